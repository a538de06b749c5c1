/* SPDX-License-Identifier: MIT */
/* The small algebra of quat.h, once: inlined into the caller, and compiled into the library as symbols. */
#ifndef NAKAWARI_INLINE_QUAT_H
#define NAKAWARI_INLINE_QUAT_H

#include "../quat.h"
#include "../scalar.h"
#include "../vec.h"

/* 1 - |q|^2 of a nearly unit q. Each difference is small, so nothing large is rounded. */
#define NKW_QUAT_DEFECT(q)                                                                                             \
    (((0.25f - NKW_MUL((q).x, (q).x)) + (0.25f - NKW_MUL((q).y, (q).y))) +                                             \
     ((0.25f - NKW_MUL((q).z, (q).z)) + (0.25f - NKW_MUL((q).w, (q).w))))

/* The defect rounded to a multiple of 2^-20: 0 for a quaternion that is unit to rounding. */
#define NKW_QUAT_ROUNDS 12.0f
#define NKW_QUAT_OFF(defect) (((defect) + NKW_QUAT_ROUNDS) - NKW_QUAT_ROUNDS)

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
    nkw_quat r = {NKW_MUL(a.x, s), NKW_MUL(a.y, s), NKW_MUL(a.z, s), NKW_MUL(a.w, s)};
    return r;
}

NKW_BODY nkw_quat nkw_quat_divide(nkw_quat a, float s)
{
    nkw_quat r = {a.x / s, a.y / s, a.z / s, a.w / s};
    return r;
}

NKW_BODY nkw_quat nkw_quat_negate(nkw_quat q)
{
    NKW_EXACT
    nkw_quat r = {NKW_MUL(-1.0f, q.x), NKW_MUL(-1.0f, q.y), NKW_MUL(-1.0f, q.z), NKW_MUL(-1.0f, q.w)};
    return r;
}

NKW_BODY nkw_quat nkw_quat_conjugate(nkw_quat q)
{
    NKW_EXACT
    nkw_quat r = {NKW_MUL(-1.0f, q.x), NKW_MUL(-1.0f, q.y), NKW_MUL(-1.0f, q.z), q.w};
    return r;
}

NKW_BODY float nkw_quat_dot(nkw_quat a, nkw_quat b)
{
    NKW_EXACT
    return (NKW_MUL(a.x, b.x) + NKW_MUL(a.y, b.y)) + (NKW_MUL(a.z, b.z) + NKW_MUL(a.w, b.w));
}

#if NKW_ROOT_INLINE || defined(NKW_DEFINE_ALGEBRA)
NKW_BODY nkw_quat nkw_quat_normalize(nkw_quat q)
{
    NKW_EXACT
    double n2 = (NKW_SQUARE64(q.x) + NKW_SQUARE64(q.y)) + (NKW_SQUARE64(q.z) + NKW_SQUARE64(q.w));
    if (!NKW_IS_NEAR(n2)) {
        nkw_quat r = q; /* so that q itself stays in registers */
        nkw_quat_view from = {&r.x, &r.y, &r.z, &r.w};
        nkw_quat_span to = {&r.x, &r.y, &r.z, &r.w};
        nkw_quat_normalize_n(from, to, 1);
        return r;
    }
    return nkw_quat_divide(q, nkw_sqrt((float)n2));
}
#endif

NKW_BODY int nkw_quat_is_finite(nkw_quat q)
{
    /* x - x is 0 for a finite x, else NaN. */
    return q.x - q.x == 0.0f && q.y - q.y == 0.0f && q.z - q.z == 0.0f && q.w - q.w == 0.0f;
}

NKW_BODY nkw_quat nkw_quat_mul(nkw_quat a, nkw_quat b)
{
    NKW_EXACT
    nkw_quat r = {
        (NKW_MUL(a.x, b.w) - NKW_MUL(a.z, b.y)) + (NKW_MUL(a.y, b.z) + NKW_MUL(a.w, b.x)),
        (NKW_MUL(a.y, b.w) - NKW_MUL(a.x, b.z)) + (NKW_MUL(a.z, b.x) + NKW_MUL(a.w, b.y)),
        (NKW_MUL(a.z, b.w) - NKW_MUL(a.y, b.x)) + (NKW_MUL(a.x, b.y) + NKW_MUL(a.w, b.z)),
        (NKW_MUL(a.w, b.w) - NKW_MUL(a.x, b.x)) - (NKW_MUL(a.z, b.z) + NKW_MUL(a.y, b.y)),
    };
    return r;
}

NKW_BODY nkw_vec3 nkw_quat_rotate(nkw_quat q, nkw_vec3 v)
{
    nkw_vec3 u = {q.x, q.y, q.z};
    nkw_vec3 c = nkw_vec3_cross(u, v);
    nkw_vec3 d = nkw_vec3_add(c, c);
    return nkw_vec3_add(v, nkw_vec3_add(nkw_vec3_scale(d, q.w), nkw_vec3_cross(u, d)));
}

NKW_BODY nkw_vec3 nkw_quat_rotate_inverse(nkw_quat q, nkw_vec3 v)
{
    return nkw_quat_rotate(nkw_quat_conjugate(q), v);
}

#ifdef __cplusplus
}
#endif

#endif
