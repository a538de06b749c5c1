/* SPDX-License-Identifier: MIT */
/* The small algebra of orient.h: inlined into the caller, and compiled into the library as a symbol. */
#ifndef NAKAWARI_INLINE_ORIENT_H
#define NAKAWARI_INLINE_ORIENT_H

#include "../orient.h"
#include "../quat.h"
#include "../scalar.h"
#include "f32x4.h"
#include "product.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * nlerp divides (1 - t) a +- t b by its length. The weights are 2^60 times as large: products of components near 1e-23,
 * as exporters leave them, would be subnormal, which takes some hundred cycles on some processors. The sign is that of
 * ((1 - t) a).b; at t = 1, where the result is +-b, a counts whole.
 */
#define NKW_NLERP_SCALE 1152921504606846976.0f

NKW_PART float nkw_nlerp_weight(float t)
{
    NKW_EXACT
    return t == 1.0f ? NKW_NLERP_SCALE : NKW_NLERP_SCALE - nkw_mul(NKW_NLERP_SCALE, t);
}

/* Whether nlerp returns a or +-b as it is: at t = 0 and 1, and where a = +-b is not zero. */
NKW_PART int nkw_nlerp_is_kept(int is_equal, float t, float dot)
{
    NKW_EXACT
    return (is_equal & (dot != 0.0f)) | (t == 0.0f) | (t == 1.0f);
}

#if NKW_ROOT && NKW_F32X4
/* Second text of lane_quat_nlerp; 1.4 times faster. */
NKW_BODY nkw_quat nkw_quat_nlerp(nkw_quat a, nkw_quat b, float t)
{
    NKW_EXACT
    float s = nkw_nlerp_weight(t), u = NKW_NLERP_SCALE * t;
    nkw_f32x4 from = {a.x, a.y, a.z, a.w}, to = {b.x, b.y, b.z, b.w}, weight = nkw_f32x4_splat(s);
    nkw_f32x4 part = nkw_f32x4_mul(weight, from), dot = nkw_f32x4_sum(nkw_f32x4_mul(part, to));
    nkw_f32x4 zero = nkw_f32x4_splat(0.0f);
    to = (nkw_f32x4)((nkw_i32x4)to ^ (((dot < zero) ^ (weight < zero)) & INT32_MIN));
    nkw_f32x4 v = part + nkw_f32x4_scale(to, u);
    if (t == 0.0f || t == 1.0f || (nkw_f32x4_equal(from, to) && dot[0] != 0.0f)) /* nkw_nlerp_is_kept */
        v = t == 1.0f ? to : from;
    else {
        float n2 = nkw_f32x4_sum(nkw_f32x4_mul(v, v))[0];
        if (!nkw_is_moderate(n2)) {
            nkw_quat p = {v[0], v[1], v[2], v[3]};
            return nkw_quat_normalize_any(p, n2, 1.0f);
        }
        v = v / nkw_f32x4_splat(nkw_sqrt(n2));
    }
    nkw_quat r = {v[0], v[1], v[2], v[3]};
    return r;
}
#elif NKW_ROOT
NKW_BODY nkw_quat nkw_quat_nlerp(nkw_quat a, nkw_quat b, float t)
{
    NKW_EXACT
    float s = nkw_nlerp_weight(t);
    nkw_quat part = nkw_quat_scale(a, s);
    float dot = nkw_quat_dot(part, b);
    nkw_quat c = (dot < 0.0f) != (s < 0.0f) ? nkw_quat_negate(b) : b;
    if (nkw_nlerp_is_kept(a.x == c.x && a.y == c.y && a.z == c.z && a.w == c.w, t, dot))
        return t == 1.0f ? c : a;
    nkw_quat v = nkw_quat_add(part, nkw_quat_scale(c, NKW_NLERP_SCALE * t));
    float n2 = nkw_quat_dot(v, v);
    return nkw_is_moderate(n2) ? nkw_quat_over(v, nkw_sqrt(n2)) : nkw_quat_normalize_any(v, n2, 1.0f);
}
#endif

#ifdef __cplusplus
}
#endif

#undef NKW_SHUFFLE

#endif
