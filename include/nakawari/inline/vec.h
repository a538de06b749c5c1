/* SPDX-License-Identifier: MIT */
/* The small algebra of vec.h: inlined into the caller, and compiled into the library as symbols. */
#ifndef NAKAWARI_INLINE_VEC_H
#define NAKAWARI_INLINE_VEC_H

#include "../scalar.h"
#include "../vec.h"
#include "f32x3.h"
#include "normal.h"
#include "product.h"

#ifdef __cplusplus
extern "C" {
#endif

NKW_BODY nkw_vec3 nkw_vec3_add(nkw_vec3 a, nkw_vec3 b)
{
    nkw_vec3 r = {a.x + b.x, a.y + b.y, a.z + b.z};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_sub(nkw_vec3 a, nkw_vec3 b)
{
    nkw_vec3 r = {a.x - b.x, a.y - b.y, a.z - b.z};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_negate(nkw_vec3 a)
{
    NKW_EXACT
    nkw_vec3 r = {-a.x, -a.y, -a.z};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_scale(nkw_vec3 a, float s)
{
    NKW_EXACT
    nkw_vec3 r = {nkw_product(a.x, s), nkw_product(a.y, s), nkw_product(a.z, s)};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_mul(nkw_vec3 a, nkw_vec3 b)
{
    NKW_EXACT
    nkw_vec3 r = {nkw_product(a.x, b.x), nkw_product(a.y, b.y), nkw_product(a.z, b.z)};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_add_scaled(nkw_vec3 a, nkw_vec3 b, float s)
{
    NKW_EXACT
    nkw_vec3 r = {a.x + nkw_mul(b.x, s), a.y + nkw_mul(b.y, s), a.z + nkw_mul(b.z, s)};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_min(nkw_vec3 a, nkw_vec3 b)
{
    nkw_vec3 r = {nkw_min(a.x, b.x), nkw_min(a.y, b.y), nkw_min(a.z, b.z)};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_max(nkw_vec3 a, nkw_vec3 b)
{
    nkw_vec3 r = {nkw_max(a.x, b.x), nkw_max(a.y, b.y), nkw_max(a.z, b.z)};
    return r;
}

NKW_BODY float nkw_vec3_dot(nkw_vec3 a, nkw_vec3 b)
{
    NKW_EXACT
    return (nkw_mul(a.x, b.x) + nkw_mul(a.y, b.y)) + nkw_mul(a.z, b.z);
}

NKW_BODY nkw_vec3 nkw_vec3_cross(nkw_vec3 a, nkw_vec3 b)
{
    NKW_EXACT
    nkw_vec3 r = {
        nkw_mul(a.y, b.z) - nkw_mul(a.z, b.y),
        nkw_mul(a.z, b.x) - nkw_mul(a.x, b.z),
        nkw_mul(a.x, b.y) - nkw_mul(a.y, b.x),
    };
    return r;
}

#if NKW_ROOT
/* For every n2, that of a times NKW_NORMAL_SCALE. FLT_MIN prevents 0 / 0: the zero vector stays zero. */
NKW_PART nkw_vec3 nkw_vec3_normalize_any(nkw_vec3 a, float n2)
{
    NKW_EXACT
    a = nkw_vec3_times(a, nkw_normal_scale(n2, NKW_NORMAL_SCALE));
    return nkw_vec3_over(a, nkw_sqrt(nkw_vec3_dot(a, a) + FLT_MIN));
}

NKW_BODY nkw_vec3 nkw_vec3_normalize(nkw_vec3 a)
{
    nkw_vec3 b = nkw_vec3_times(a, NKW_NORMAL_SCALE);
    float n2 = nkw_vec3_dot(b, b);
    return nkw_is_moderate(n2) ? nkw_vec3_over(b, nkw_sqrt(n2)) : nkw_vec3_normalize_any(a, n2);
}
#endif

#if NKW_F32X3
/* Second text of nkw_lerp; 2.0 times faster. */
NKW_BODY nkw_vec3 nkw_vec3_lerp(nkw_vec3 a, nkw_vec3 b, float t)
{
    NKW_EXACT
    const nkw_f32x4_nearer at = nkw_f32x4_nearer_to(t);
    const nkw_f32x4 from = nkw_f32x4_from_vec3(a), to = nkw_f32x4_from_vec3(b);
    return nkw_f32x4_from_end(at, from, to, at.back * (to - from));
}
#else
NKW_BODY nkw_vec3 nkw_vec3_lerp(nkw_vec3 a, nkw_vec3 b, float t)
{
    nkw_vec3 r = {nkw_lerp(a.x, b.x, t), nkw_lerp(a.y, b.y, t), nkw_lerp(a.z, b.z, t)};
    return r;
}
#endif

NKW_BODY nkw_vec3 nkw_vec3_reflect(nkw_vec3 a, nkw_vec3 n)
{
    NKW_EXACT
    return nkw_vec3_add_scaled(a, n, -2.0f * nkw_vec3_dot(a, n));
}

NKW_BODY int nkw_vec3_is_finite(nkw_vec3 a)
{
    /* x - x is 0 for a finite x, otherwise NaN. */
    return a.x - a.x == 0.0f && a.y - a.y == 0.0f && a.z - a.z == 0.0f;
}

#ifdef __cplusplus
}
#endif

#endif
