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

/* Elements i and j of a; from 2 on those of b. The indices are constants. */
#if defined(__clang__)
#define F64X2_SHUFFLE(a, b, i, j) __builtin_shufflevector(a, b, i, j)
#else
#define F64X2_SHUFFLE(a, b, i, j) __builtin_shuffle(a, b, (i64x2){i, j})
#endif

static inline f64x2 f64x2_of(double a, double b)
{
    f64x2 r = {a, b};
    return r;
}

static inline f64x2 f64x2_load(const double *from)
{
    f64x2 r;
    memcpy(&r, from, sizeof r);
    return r;
}

static inline void f64x2_store(double *to, f64x2 a)
{
    memcpy(to, &a, sizeof a);
}

static inline f64x2 f64x2_splat(double a)
{
    return f64x2_of(a, a);
}

static inline f64x2 f64x2_swap(f64x2 a)
{
    return F64X2_SHUFFLE(a, a, 1, 0);
}

/* a where the mask is set, otherwise b. */
static inline f64x2 f64x2_select(i64x2 mask, f64x2 a, f64x2 b)
{
    return (f64x2)((((i64x2)a ^ (i64x2)b) & mask) ^ (i64x2)b);
}

/* a where the mask is set, otherwise 0. */
static inline f64x2 f64x2_where(i64x2 mask, f64x2 a)
{
    return (f64x2)(mask & (i64x2)a);
}

static inline i64x2 f64x2_sign(f64x2 a)
{
    const i64x2 sign = {INT64_MIN, INT64_MIN};
    return (i64x2)a & sign;
}

static inline f64x2 f64x2_abs(f64x2 a)
{
    return (f64x2)((i64x2)a ^ f64x2_sign(a));
}
#endif

#endif
