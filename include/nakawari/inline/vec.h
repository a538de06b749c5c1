/* SPDX-License-Identifier: MIT */
/* The small algebra of vec.h, once: inlined into the caller, and compiled into the library as symbols. */
#ifndef NAKAWARI_INLINE_VEC_H
#define NAKAWARI_INLINE_VEC_H

#include "../scalar.h"
#include "../vec.h"

#ifdef __cplusplus
extern "C" {
#endif

NKW_BODY nkw_vec3 nkw_vec3_zero(void)
{
    nkw_vec3 r = {0.0f, 0.0f, 0.0f};
    return r;
}

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
    nkw_vec3 r = {NKW_MUL(-1.0f, a.x), NKW_MUL(-1.0f, a.y), NKW_MUL(-1.0f, a.z)};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_scale(nkw_vec3 a, float s)
{
    nkw_vec3 r = {NKW_MUL(a.x, s), NKW_MUL(a.y, s), NKW_MUL(a.z, s)};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_divide(nkw_vec3 a, float s)
{
    nkw_vec3 r = {a.x / s, a.y / s, a.z / s};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_mul(nkw_vec3 a, nkw_vec3 b)
{
    nkw_vec3 r = {NKW_MUL(a.x, b.x), NKW_MUL(a.y, b.y), NKW_MUL(a.z, b.z)};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_add_scaled(nkw_vec3 a, nkw_vec3 b, float s)
{
    NKW_EXACT
    nkw_vec3 r = {a.x + NKW_MUL(b.x, s), a.y + NKW_MUL(b.y, s), a.z + NKW_MUL(b.z, s)};
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
    return (NKW_MUL(a.x, b.x) + NKW_MUL(a.y, b.y)) + NKW_MUL(a.z, b.z);
}

NKW_BODY nkw_vec3 nkw_vec3_cross(nkw_vec3 a, nkw_vec3 b)
{
    NKW_EXACT
    nkw_vec3 r = {
        NKW_MUL(a.y, b.z) - NKW_MUL(a.z, b.y),
        NKW_MUL(a.z, b.x) - NKW_MUL(a.x, b.z),
        NKW_MUL(a.x, b.y) - NKW_MUL(a.y, b.x),
    };
    return r;
}

NKW_BODY float nkw_vec3_length_squared(nkw_vec3 a)
{
    return nkw_vec3_dot(a, a);
}

#if NKW_ROOT_INLINE || defined(NKW_DEFINE_ALGEBRA)
NKW_BODY nkw_vec3 nkw_vec3_normalize(nkw_vec3 a)
{
    NKW_EXACT
    double n2 = (NKW_SQUARE64(a.x) + NKW_SQUARE64(a.y)) + NKW_SQUARE64(a.z);
    if (!NKW_IS_NEAR(n2)) {
        nkw_vec3_view from = {&a.x, &a.y, &a.z};
        nkw_vec3 r;
        nkw_vec3_span to = {&r.x, &r.y, &r.z};
        nkw_vec3_normalize_n(from, to, 1);
        return r;
    }
    return nkw_vec3_divide(a, nkw_sqrt((float)n2));
}
#endif

NKW_BODY nkw_vec3 nkw_vec3_lerp(nkw_vec3 a, nkw_vec3 b, float t)
{
    nkw_vec3 r = {nkw_lerp(a.x, b.x, t), nkw_lerp(a.y, b.y, t), nkw_lerp(a.z, b.z, t)};
    return r;
}

NKW_BODY nkw_vec3 nkw_vec3_reflect(nkw_vec3 a, nkw_vec3 n)
{
    return nkw_vec3_add_scaled(a, n, NKW_MUL(-2.0f, nkw_vec3_dot(a, n)));
}

NKW_BODY int nkw_vec3_is_finite(nkw_vec3 a)
{
    /* x - x is 0 for a finite x, else NaN. */
    return a.x - a.x == 0.0f && a.y - a.y == 0.0f && a.z - a.z == 0.0f;
}

#ifdef __cplusplus
}
#endif

#endif
