/* SPDX-License-Identifier: MIT */
/*
 * Vectors of three floats in a register, for lerp and the curves: where the compiler does not make vectors of them by
 * itself, which GCC does with SSSE3 and Clang does not.
 */
#ifndef NAKAWARI_INLINE_F32X3_H
#define NAKAWARI_INLINE_F32X3_H

#include "../types.h"
#include "f32x4.h"

#if NKW_F32X4 && defined(__SSE2__) && (defined(__clang__) || !defined(__SSSE3__)) && !defined(NKW_ISA)
#define NKW_F32X3 1
#else
#define NKW_F32X3 0
#endif

#if NKW_F32X3
#ifdef __cplusplus
extern "C" {
#endif

/* v.x v.y v.z 0: a load of two and a load of one. */
NKW_PART nkw_f32x4 nkw_f32x4_from_vec3(nkw_vec3 v)
{
    typedef double pairs __attribute__((vector_size(16)));
    const nkw_f32x4 z = {v.z, 0.0f, 0.0f, 0.0f};
    double xy;
    memcpy(&xy, &v, sizeof xy);
    const pairs r = {xy, ((pairs)z)[0]};
    return (nkw_f32x4)r;
}

/* a where `first` is all ones, b where it is 0. */
NKW_PART nkw_f32x4 nkw_f32x4_select(nkw_i32x4 first, nkw_f32x4 a, nkw_f32x4 b)
{
    return (nkw_f32x4)(((nkw_i32x4)a & first) | ((nkw_i32x4)b & ~first));
}

/* What lerp and the curves take from t, as nkw_lerp_from and nkw_hermite_from do. */
typedef struct nkw_f32x4_nearer {
    nkw_i32x4 first;
    nkw_f32x4 back, onward;
} nkw_f32x4_nearer;

NKW_PART nkw_f32x4_nearer nkw_f32x4_nearer_to(float t)
{
    const nkw_f32x4 at = nkw_f32x4_splat(t), zero = nkw_f32x4_splat(0.0f), one = nkw_f32x4_splat(1.0f);
    nkw_f32x4_nearer r;
    r.first = at < nkw_f32x4_splat(0.5f);
    r.back = nkw_f32x4_select(r.first, zero, one) - at;
    r.onward = nkw_f32x4_select(r.first, one, zero) - at;
    return r;
}

/* The end nearer to t, of a and b, minus `step`; at back = 0 the end, with the sign of a zero. */
NKW_PART nkw_vec3 nkw_f32x4_from_end(nkw_f32x4_nearer at, nkw_f32x4 a, nkw_f32x4 b, nkw_f32x4 step)
{
    const nkw_f32x4 zero = nkw_f32x4_splat(0.0f);
    nkw_f32x4 p = nkw_f32x4_select(at.first, a, b) - nkw_f32x4_select(at.back == zero, zero, step);
    nkw_vec3 r = {p[0], p[1], p[2]};
    return r;
}

#ifdef __cplusplus
}
#endif
#endif

#undef NKW_SHUFFLE

#endif
