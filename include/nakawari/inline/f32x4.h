/* SPDX-License-Identifier: MIT */
/*
 * Four floats in one register, for the inlined matrix products: a type with the operators + - * and four helpers. Every
 * operation acts on each float separately and rounds once, so the bits are those of the same line on single floats.
 *
 * NKW_F32X4 is 1 where the compiler has such a type and the target an instruction for it, otherwise 0.
 */
#ifndef NAKAWARI_INLINE_F32X4_H
#define NAKAWARI_INLINE_F32X4_H

#include <stdint.h>
#include <string.h>

#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__) || defined(__wasm_simd128__)) && !defined(NKW_PLAIN)
#define NKW_F32X4 1
#else
#define NKW_F32X4 0
#endif

#if NKW_F32X4
typedef float nkw_f32x4 __attribute__((vector_size(16)));
typedef int32_t nkw_i32x4 __attribute__((vector_size(16)));

/* Elements i, j, k, l of a; from 4 on those of b. The indices are constants. */
#if defined(__clang__)
#define NKW_SHUFFLE(a, b, i, j, k, l) __builtin_shufflevector(a, b, i, j, k, l)
#else
#define NKW_SHUFFLE(a, b, i, j, k, l) __builtin_shuffle(a, b, __extension__(nkw_i32x4){i, j, k, l})
#endif

/* Four floats from any address. */
static inline nkw_f32x4 nkw_f32x4_load(const void *from)
{
    nkw_f32x4 r;
    memcpy(&r, from, sizeof r);
    return r;
}

static inline void nkw_f32x4_store(void *to, nkw_f32x4 a)
{
    memcpy(to, &a, sizeof a);
}

static inline nkw_f32x4 nkw_f32x4_splat(float x)
{
    nkw_f32x4 r = {x, x, x, x};
    return r;
}
#endif

#endif
