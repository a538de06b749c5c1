/* SPDX-License-Identifier: MIT */
/*
 * Two doubles in one register, for scalar functions that compute the same twice. + - * / and comparisons act on each
 * double separately and round once; a comparison returns a mask, all bits set where it holds.
 *
 * Where the compiler has no such type (NKW_F32X4 is 0), formulas go by their text in src/lane.
 */
#ifndef NAKAWARI_PACK_F64X2_H
#define NAKAWARI_PACK_F64X2_H

#include "lane/strict.h"

#include <nakawari/inline/f32x4.h>

#if NKW_F32X4
typedef double f64x2 __attribute__((vector_size(16)));
typedef int64_t i64x2 __attribute__((vector_size(16)));

static inline f64x2 f64x2_of(double a, double b)
{
    f64x2 r = {a, b};
    return r;
}

static inline f64x2 f64x2_splat(double a)
{
    return f64x2_of(a, a);
}
#endif

#endif
