/* SPDX-License-Identifier: MIT */
/*
 * The symbols of the functions that the headers define inline: for bindings, for debuggers, and for callers whose
 * compiler could change the bits (NKW_INLINE in base.h). This file declares them without `inline`, so their
 * definitions are external.
 */
#include "lane/strict.h"

#include <math.h>

#define NKW_DEFINE_ALGEBRA
#include <nakawari/curve.h>
#include <nakawari/mat.h>
#include <nakawari/orient.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/transform.h>
#include <nakawari/vec.h>
