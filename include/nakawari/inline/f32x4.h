/* SPDX-License-Identifier: MIT */
/*
 * Four floats in one register, for inlined functions: a type with the operators + - * / and a few helpers. Every
 * operation acts on each float separately and rounds once, so the bits are those of scalar code.
 *
 * Defined only if NKW_F32X4 of base.h is 1.
 */
#include "../base.h"

/* Elements i, j, k, l of a, from 4 on those of b; constants. Each header that includes this file undefines it again. */
#if !NKW_F32X4 || defined(NKW_SHUFFLE)
#elif defined(__clang__)
#define NKW_SHUFFLE(a, b, i, j, k, l) __builtin_shufflevector(a, b, i, j, k, l)
#else
#define NKW_SHUFFLE(a, b, i, j, k, l) __builtin_shuffle(a, b, __extension__(nkw_i32x4){i, j, k, l})
#endif

#ifndef NAKAWARI_INLINE_F32X4_H
#define NAKAWARI_INLINE_F32X4_H

#include <stdint.h>
#include <string.h>

#include "product.h"

#if NKW_F32X4
typedef float nkw_f32x4 __attribute__((vector_size(16)));
typedef int32_t nkw_i32x4 __attribute__((vector_size(16)));

/* Reads four floats; no alignment required. */
NKW_PART nkw_f32x4 nkw_f32x4_load(const void *from)
{
    nkw_f32x4 r;
    memcpy(&r, from, sizeof r);
    return r;
}

NKW_PART void nkw_f32x4_store(void *to, nkw_f32x4 a)
{
    memcpy(to, &a, sizeof a);
}

NKW_PART nkw_f32x4 nkw_f32x4_splat(float x)
{
    nkw_f32x4 r = {x, x, x, x};
    return r;
}

/* nkw_product of each float. */
NKW_PART nkw_f32x4 nkw_f32x4_mul(nkw_f32x4 a, nkw_f32x4 b)
{
    NKW_EXACT
    nkw_f32x4 r = a * b;
    NKW_OPAQUE(r);
    return r;
}

NKW_PART nkw_f32x4 nkw_f32x4_scale(nkw_f32x4 a, float s)
{
    NKW_EXACT
    nkw_f32x4 r = a * s;
    NKW_OPAQUE(r);
    return r;
}

/* (a[0] + a[1]) + (a[2] + a[3]), in all four. */
NKW_PART nkw_f32x4 nkw_f32x4_sum(nkw_f32x4 a)
{
    nkw_f32x4 pairs = a + NKW_SHUFFLE(a, a, 1, 0, 3, 2);
    return pairs + NKW_SHUFFLE(pairs, pairs, 2, 3, 0, 1);
}

/* Whether all four are equal. */
NKW_PART int nkw_f32x4_equal(nkw_f32x4 a, nkw_f32x4 b)
{
#if defined(__SSE2__)
    return __builtin_ia32_movmskps((nkw_f32x4)(a != b)) == 0;
#else
    nkw_i32x4 other = a != b;
    int64_t halves[2];
    memcpy(halves, &other, sizeof halves);
    return (halves[0] | halves[1]) == 0;
#endif
}

/* a[0] a[1] a[2] 0 */
NKW_PART nkw_f32x4 nkw_f32x4_end_0(nkw_f32x4 a)
{
    const nkw_f32x4 end = {0.0f, 0.0f, 0.0f, 0.0f};
    return NKW_SHUFFLE(a, end, 0, 1, 2, 7);
}

/* a[0] a[1] a[2] 1 */
NKW_PART nkw_f32x4 nkw_f32x4_end_1(nkw_f32x4 a)
{
    const nkw_f32x4 end = {0.0f, 0.0f, 0.0f, 1.0f};
    return NKW_SHUFFLE(a, end, 0, 1, 2, 7);
}
#endif

/* Eight floats, two columns, where a register has room for them and the compiler has a shuffle of any vectors. */
#if NKW_F32X4 && defined(__AVX__) && defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define NKW_F32X8 1
#endif
#endif
#ifndef NKW_F32X8
#define NKW_F32X8 0
#endif

#if NKW_F32X8
typedef float nkw_f32x8 __attribute__((vector_size(32)));

NKW_PART nkw_f32x8 nkw_f32x8_load(const void *from)
{
    nkw_f32x8 r;
    memcpy(&r, from, sizeof r);
    return r;
}

NKW_PART void nkw_f32x8_store(void *to, nkw_f32x8 a)
{
    memcpy(to, &a, sizeof a);
}

NKW_PART nkw_f32x8 nkw_f32x8_mul(nkw_f32x8 a, nkw_f32x8 b)
{
    NKW_EXACT
    nkw_f32x8 r = a * b;
    NKW_OPAQUE(r);
    return r;
}

/* Four floats, twice. */
NKW_PART nkw_f32x8 nkw_f32x8_twice(const void *from)
{
    const nkw_f32x4 a = nkw_f32x4_load(from);
    return __builtin_shufflevector(a, a, 0, 1, 2, 3, 0, 1, 2, 3);
}
#endif

#endif
