/* SPDX-License-Identifier: MIT */
/* Products that no compiler fuses with a sum, for inlined functions. */
#ifndef NAKAWARI_INLINE_PRODUCT_H
#define NAKAWARI_INLINE_PRODUCT_H

#include "../base.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Where GCC could fuse (NKW_FMA), no instruction takes and returns the register of the product a: GCC no longer knows it
 * for one. (With __builtin_assoc_barrier it does: GCC 12 drops the barrier where it makes vectors.)
 */
#if NKW_FMA && defined(__aarch64__)
#define NKW_OPAQUE(a) __asm__("" : "+w"(a))
#elif NKW_FMA
#define NKW_OPAQUE(a) __asm__("" : "+x"(a))
#else
#define NKW_OPAQUE(a) (void)(a)
#endif

/*
 * a b, rounded, as a term of a sum. Where GCC could fuse, it is a b - 0, fused already: the same bits in one instruction,
 * which GCC still makes vectors of. A product that is only a factor of another is written a * b.
 */
NKW_PART float nkw_mul(float a, float b)
{
    NKW_EXACT
#if NKW_FMA
    return __builtin_fmaf(a, b, -0.0f);
#else
    return a * b;
#endif
}

/*
 * a b, rounded, as a result: the caller may negate it. GCC would make -(a b - 0) to -a b + 0, and so of a zero the other
 * one.
 */
NKW_PART float nkw_product(float a, float b)
{
    NKW_EXACT
    float r = a * b;
    NKW_OPAQUE(r);
    return r;
}

#ifdef __cplusplus
}
#endif

#endif
