/* SPDX-License-Identifier: MIT */
/*
 * The symbols of the small algebra that the headers inline: for bindings, debuggers, and callers whose compiler
 * could change its bits (see NKW_INLINE in base.h). Declared without `inline` here, the definitions are external.
 */
#include "lane/strict.h"

#include <math.h>

#define NKW_DEFINE_ALGEBRA
#include <nakawari/curve.h>
#include <nakawari/mat.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/transform.h>
#include <nakawari/vec.h>
