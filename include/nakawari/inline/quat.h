/* SPDX-License-Identifier: MIT */
/* The small algebra of quat.h: inlined into the caller, and compiled into the library as symbols. */
#ifndef NAKAWARI_INLINE_QUAT_H
#define NAKAWARI_INLINE_QUAT_H

#include "../quat.h"
#include "../scalar.h"
#include "../vec.h"
#include "normal.h"
#include "product.h"

#ifdef __cplusplus
extern "C" {
#endif

NKW_BODY nkw_quat nkw_quat_identity(void)
{
    nkw_quat r = {0.0f, 0.0f, 0.0f, 1.0f};
    return r;
}

NKW_BODY nkw_quat nkw_quat_add(nkw_quat a, nkw_quat b)
{
    nkw_quat r = {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
    return r;
}

NKW_BODY nkw_quat nkw_quat_sub(nkw_quat a, nkw_quat b)
{
    nkw_quat r = {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w};
    return r;
}

NKW_BODY nkw_quat nkw_quat_scale(nkw_quat a, float s)
{
    NKW_EXACT
    nkw_quat r = {nkw_product(a.x, s), nkw_product(a.y, s), nkw_product(a.z, s), nkw_product(a.w, s)};
    return r;
}

NKW_BODY nkw_quat nkw_quat_negate(nkw_quat q)
{
    NKW_EXACT
    nkw_quat r = {-q.x, -q.y, -q.z, -q.w};
    return r;
}

NKW_BODY nkw_quat nkw_quat_conjugate(nkw_quat q)
{
    NKW_EXACT
    nkw_quat r = {-q.x, -q.y, -q.z, q.w};
    return r;
}

NKW_BODY float nkw_quat_dot(nkw_quat a, nkw_quat b)
{
    NKW_EXACT
    return (nkw_mul(a.x, b.x) + nkw_mul(a.y, b.y)) + (nkw_mul(a.z, b.z) + nkw_mul(a.w, b.w));
}

#if NKW_ROOT
/*
 * For every n2, that of q times the power of two `usual`. The zero quaternion becomes the identity: its w the root of
 * FLT_MIN.
 */
NKW_PART nkw_quat nkw_quat_normalize_any(nkw_quat q, float n2, float usual)
{
    NKW_EXACT
    q = nkw_quat_times(q, nkw_normal_scale(n2, usual));
    float square = nkw_quat_dot(q, q);
    q.w = square == 0.0f ? 1.0842022e-19f : q.w;
    return nkw_quat_over(q, nkw_sqrt(square + FLT_MIN));
}

NKW_BODY nkw_quat nkw_quat_normalize(nkw_quat q)
{
    nkw_quat p = nkw_quat_times(q, NKW_NORMAL_SCALE);
    float n2 = nkw_quat_dot(p, p);
    return nkw_is_moderate(n2) ? nkw_quat_over(p, nkw_sqrt(n2)) : nkw_quat_normalize_any(q, n2, NKW_NORMAL_SCALE);
}
#endif

NKW_BODY int nkw_quat_is_finite(nkw_quat q)
{
    /* x - x is 0 for a finite x, otherwise NaN. */
    return q.x - q.x == 0.0f && q.y - q.y == 0.0f && q.z - q.z == 0.0f && q.w - q.w == 0.0f;
}

NKW_BODY nkw_quat nkw_quat_mul(nkw_quat a, nkw_quat b)
{
    NKW_EXACT
    nkw_quat r = {
        (nkw_mul(a.x, b.w) - nkw_mul(a.z, b.y)) + (nkw_mul(a.y, b.z) + nkw_mul(a.w, b.x)),
        (nkw_mul(a.y, b.w) - nkw_mul(a.x, b.z)) + (nkw_mul(a.z, b.x) + nkw_mul(a.w, b.y)),
        (nkw_mul(a.z, b.w) - nkw_mul(a.y, b.x)) + (nkw_mul(a.x, b.y) + nkw_mul(a.w, b.z)),
        (nkw_mul(a.w, b.w) - nkw_mul(a.x, b.x)) - (nkw_mul(a.z, b.z) + nkw_mul(a.y, b.y)),
    };
    return r;
}

NKW_BODY nkw_vec3 nkw_quat_rotate(nkw_quat q, nkw_vec3 v)
{
    nkw_vec3 u = {q.x, q.y, q.z};
    nkw_vec3 c = nkw_vec3_cross(u, v);
    nkw_vec3 d = nkw_vec3_add(c, c);
    return nkw_vec3_add(v, nkw_vec3_add_scaled(nkw_vec3_cross(u, d), d, q.w));
}

NKW_BODY nkw_vec3 nkw_quat_rotate_inverse(nkw_quat q, nkw_vec3 v)
{
    return nkw_quat_rotate(nkw_quat_conjugate(q), v);
}

#ifdef __cplusplus
}
#endif

#endif
