/* SPDX-License-Identifier: MIT */
/*
 * The symbols of the functions that the headers define inline: for bindings, for debuggers, and for callers whose
 * compiler could change the bits (NKW_INLINE in base.h). This file declares them without `inline`, so their
 * definitions are external.
 */
#define NKW_DEFINE_ALGEBRA
#include "lane/strict.h"

#include <math.h>

#include <nakawari/curve.h>
#include <nakawari/vec.h>

/* Pairs make vectors faster, but quaternions slower: two pairs are stored, and a load of all four waits for both. */
LANE_NO_PAIRS

#include <nakawari/mat.h>
#include <nakawari/orient.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/transform.h>
