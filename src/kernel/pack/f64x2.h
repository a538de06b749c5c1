/* SPDX-License-Identifier: MIT */
/*
 * Two doubles in one register, for scalar functions that compute the same twice. + - * / and comparisons act on each
 * double separately and round once; a comparison returns a mask, all bits set where it holds.
 *
 * Where the compiler has no such type (NKW_F32X4 is 0), formulas go by their text in src/kernel/lane.
 */
#ifndef NAKAWARI_PACK_F64X2_H
#define NAKAWARI_PACK_F64X2_H

#include "lane/strict.h"

#include <nakawari/inline/f32x4.h>

#if NKW_F32X4 && defined(__SSE2__)
#include <emmintrin.h>
#endif

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

/* a where the mask is set, otherwise 0. */
static inline f64x2 f64x2_where(i64x2 mask, f64x2 a)
{
    return (f64x2)((i64x2)a & mask);
}

/* The sign bits of a. */
static inline i64x2 f64x2_sign(f64x2 a)
{
    return (i64x2)a & INT64_MIN;
}

/* a < b ? a : b and a > b ? a : b */
static inline f64x2 f64x2_min(f64x2 a, f64x2 b)
{
#if defined(__SSE2__)
    return (f64x2)_mm_min_pd((__m128d)a, (__m128d)b);
#else
    return (f64x2)(((i64x2)a & (a < b)) | ((i64x2)b & ~(a < b)));
#endif
}

static inline f64x2 f64x2_max(f64x2 a, f64x2 b)
{
#if defined(__SSE2__)
    return (f64x2)_mm_max_pd((__m128d)a, (__m128d)b);
#else
    return (f64x2)(((i64x2)a & (a > b)) | ((i64x2)b & ~(a > b)));
#endif
}
#endif

#endif
