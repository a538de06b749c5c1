/* SPDX-License-Identifier: MIT */
/*
 * Four floats in one register. + - * / and comparisons act on each float separately; a comparison returns a mask, all
 * bits set where it holds. Each operation rounds once, so the bits are those of the same line on single floats.
 *
 * Where the compiler has no such type (NKW_F32X4 is 0), formulas go by their text in src/kernel/lane.
 */
#ifndef NAKAWARI_PACK_F32X4_H
#define NAKAWARI_PACK_F32X4_H

#include "lane/strict.h"

#include <math.h>

#include <nakawari/inline/f32x4.h>

#if NKW_F32X4 && defined(__SSE2__)
#include <emmintrin.h>
#elif NKW_F32X4 && defined(__aarch64__)
#include <arm_neon.h>
#endif

#if NKW_F32X4
typedef nkw_f32x4 f32x4;
typedef nkw_i32x4 i32x4;

/* Elements i, j, k, l of a, from 4 on those of b; constants. */
#if defined(__clang__)
#define F32X4_SHUFFLE(a, b, i, j, k, l) __builtin_shufflevector(a, b, i, j, k, l)
#else
#define F32X4_SHUFFLE(a, b, i, j, k, l) __builtin_shuffle(a, b, (i32x4){i, j, k, l})
#endif

static inline f32x4 f32x4_load(const void *from)
{
    return nkw_f32x4_load(from);
}

static inline void f32x4_store(void *to, f32x4 a)
{
    nkw_f32x4_store(to, a);
}

/* The first three floats of a. */
static inline void f32x4_store3(void *to, f32x4 a)
{
    typedef int64_t i64x2 __attribute__((vector_size(16)));
    const int64_t xy = ((i64x2)a)[0];
    const float z = a[2];
    memcpy(to, &xy, sizeof xy);
    memcpy((char *)to + sizeof xy, &z, sizeof z);
}

static inline f32x4 f32x4_splat(float x)
{
    return nkw_f32x4_splat(x);
}

/* a[i] in all four; i is a constant. Before AVX the integer shuffle needs no copy of a. */
#if defined(__SSE2__) && NKW_REGISTER_BITS == 128
#define f32x4_broadcast(a, i) ((f32x4)F32X4_SHUFFLE((i32x4)(a), (i32x4)(a), i, i, i, i))
#else
#define f32x4_broadcast(a, i) F32X4_SHUFFLE(a, a, i, i, i, i)
#endif

/* a where the mask is set, otherwise b. */
static inline f32x4 f32x4_select(i32x4 mask, f32x4 a, f32x4 b)
{
    return (f32x4)((((i32x4)a ^ (i32x4)b) & mask) ^ (i32x4)b);
}

/* a, negated where the sign bit of `sign` is set. */
static inline f32x4 f32x4_flip(f32x4 a, i32x4 sign)
{
    return (f32x4)((i32x4)a ^ (sign & INT32_MIN));
}

/* a[0] a[1] a[2] last, `last` a constant 0 or 1. */
static inline f32x4 f32x4_with_last(f32x4 a, int last)
{
#if NKW_REGISTER_BITS > 128
    const f32x4 end = {0.0f, 0.0f, 0.0f, last ? 1.0f : 0.0f};
    return F32X4_SHUFFLE(a, end, 0, 1, 2, 7);
#else
    const i32x4 keep = {-1, -1, -1, 0}, end = {0, 0, 0, last ? 0x3f800000 : 0};
    return (f32x4)(((i32x4)a & keep) | end);
#endif
}

/* (a[0] + a[1]) + (a[2] + a[3]), in all four. */
static inline f32x4 f32x4_sum(f32x4 a)
{
    return nkw_f32x4_sum(a);
}

static inline f32x4 f32x4_sqrt(f32x4 a)
{
#if defined(__SSE2__)
    return (f32x4)_mm_sqrt_ps((__m128)a);
#elif defined(__aarch64__)
    return (f32x4)vsqrtq_f32((float32x4_t)a);
#else
    f32x4 r = {sqrtf(a[0]), sqrtf(a[1]), sqrtf(a[2]), sqrtf(a[3])};
    return r;
#endif
}

/* Rows become columns. */
static inline void f32x4_transpose(f32x4 m[4])
{
    f32x4 a = F32X4_SHUFFLE(m[0], m[1], 0, 4, 1, 5), b = F32X4_SHUFFLE(m[2], m[3], 0, 4, 1, 5);
    f32x4 c = F32X4_SHUFFLE(m[0], m[1], 2, 6, 3, 7), d = F32X4_SHUFFLE(m[2], m[3], 2, 6, 3, 7);
    m[0] = F32X4_SHUFFLE(a, b, 0, 1, 4, 5);
    m[1] = F32X4_SHUFFLE(a, b, 2, 3, 6, 7);
    m[2] = F32X4_SHUFFLE(c, d, 0, 1, 4, 5);
    m[3] = F32X4_SHUFFLE(c, d, 2, 3, 6, 7);
}
#endif

/* The 4x4 block with the rows from[0..3], transposed to the rows to[0..3]; a row that is NULL in `to` is left out. */
static inline void f32x4_transpose_rows(const float *const from[4], float *const to[4])
{
#if NKW_F32X4
    f32x4 m[4] = {f32x4_load(from[0]), f32x4_load(from[1]), f32x4_load(from[2]), f32x4_load(from[3])};
    f32x4_transpose(m);
    for (size_t k = 0; k < 4; k++)
        if (to[k])
            f32x4_store(to[k], m[k]);
#else
    float m[4][4];
    for (size_t i = 0; i < 4; i++)
        for (size_t k = 0; k < 4; k++)
            m[k][i] = from[i][k];
    for (size_t k = 0; k < 4; k++)
        if (to[k])
            memcpy(to[k], m[k], sizeof m[k]);
#endif
}

#endif
