/* SPDX-License-Identifier: MIT */
/* The small algebra of transform.h: inlined into the caller, and compiled into the library as symbols. */
#ifndef NAKAWARI_INLINE_TRANSFORM_H
#define NAKAWARI_INLINE_TRANSFORM_H

#include "../mat.h"
#include "../quat.h"
#include "../transform.h"
#include "../vec.h"
#include "f32x4.h"

#ifdef __cplusplus
extern "C" {
#endif

NKW_BODY nkw_trs nkw_trs_identity(void)
{
    nkw_trs r = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 1.0f}};
    return r;
}

NKW_BODY nkw_mat3 nkw_mat3_from_quat_scale(nkw_quat q, nkw_vec3 s)
{
    NKW_EXACT
    nkw_mat3 r = nkw_mat3_from_quat(q);
    /*
     * Let m = 1 - |q|^2 = k + off, off the nearest multiple of 2^-20. k is the rounding of a unit q: R + k R corrects
     * it. off != 0 if q is not unit: it is used unnormalised, with 1 - 2 (yy + zz) = (ww - yy) + (xx - zz) + off.
     */
    float m = nkw_quat_unit_error(q), off = (m + 12.0f) - 12.0f, k = m - off;
    for (size_t i = 0; i < 3; i++) {
        float x = r.m[i] + r.m[i] * k, y = r.m[3 + i] + r.m[3 + i] * k, z = r.m[6 + i] + r.m[6 + i] * k;
        r.m[i] = (i == 0 ? x + off : x) * s.x;
        r.m[3 + i] = (i == 1 ? y + off : y) * s.y;
        r.m[6 + i] = (i == 2 ? z + off : z) * s.z;
    }
    return r;
}

#if NKW_F32X4
/*
 * Second text of lane_mat4_from_trs; 2.3 times faster.
 *
 * The nine elements of R in three registers; row and column of each element:
 *
 *     d = 00 11 22   the diagonal          l = 10 21 02          u = 01 12 20
 */
NKW_BODY nkw_mat4 nkw_mat4_from_trs(const nkw_trs *trs)
{
    NKW_EXACT
    const nkw_f32x4 quarter = nkw_f32x4_splat(0.25f), round = nkw_f32x4_splat(12.0f);
    nkw_f32x4 q = nkw_f32x4_load(&trs->rotation), q2 = q + q, qq = q * q;
    nkw_f32x4 w = NKW_SHUFFLE(q, q, 3, 3, 3, 3);
    nkw_f32x4 yzx = q * NKW_SHUFFLE(q2, q2, 1, 2, 0, 3), zxy = w * NKW_SHUFFLE(q2, q2, 2, 0, 1, 3);
    nkw_f32x4 d = (w * w - NKW_SHUFFLE(qq, qq, 1, 2, 0, 3)) + (qq - NKW_SHUFFLE(qq, qq, 2, 0, 1, 3));
    nkw_f32x4 l = yzx + zxy, u = yzx - zxy;

    nkw_f32x4 m = quarter - qq; /* nkw_quat_unit_error(q) = k + off */
    m = m + NKW_SHUFFLE(m, m, 1, 0, 3, 2);
    m = m + NKW_SHUFFLE(m, m, 2, 3, 0, 1);
    nkw_f32x4 off = (m + round) - round, k = m - off;

    nkw_f32x4 s = nkw_f32x4_load((const float *)trs + 6); /* w of the rotation, then the scale */
    s = NKW_SHUFFLE(s, s, 1, 2, 3, 1);
    d = ((d + d * k) + off) * s;
    l = (l + l * k) * s;
    u = (u + u * k) * NKW_SHUFFLE(s, s, 1, 2, 0, 3);

    d = nkw_f32x4_end_0(d);
    u = nkw_f32x4_end_0(u);
    l = nkw_f32x4_end_0(NKW_SHUFFLE(l, l, 2, 0, 1, 3)); /* 02 10 21 */
    nkw_f32x4 x = NKW_SHUFFLE(l, d, 4, 1, 2, 3), y = NKW_SHUFFLE(d, u, 4, 1, 2, 3), z = NKW_SHUFFLE(u, l, 4, 1, 2, 3);
    nkw_mat4 r;
    nkw_f32x4_store(r.m, NKW_SHUFFLE(x, u, 0, 1, 6, 7));
    nkw_f32x4_store(r.m + 4, NKW_SHUFFLE(y, l, 0, 1, 6, 7));
    nkw_f32x4_store(r.m + 8, NKW_SHUFFLE(z, d, 0, 1, 6, 7));
    nkw_f32x4_store(r.m + 12, nkw_f32x4_end_1(nkw_f32x4_load(trs)));
    return r;
}
#endif

NKW_BODY nkw_vec3 nkw_trs_transform_point(const nkw_trs *trs, nkw_vec3 p)
{
    nkw_vec3 scaled = nkw_vec3_mul(trs->scale, p);
    return nkw_vec3_add(trs->translation, nkw_quat_rotate(trs->rotation, scaled));
}

NKW_BODY nkw_trs nkw_trs_mul(const nkw_trs *a, const nkw_trs *b)
{
    nkw_trs r;
    r.translation = nkw_trs_transform_point(a, b->translation);
    r.rotation = nkw_quat_mul(a->rotation, b->rotation);
    r.scale = nkw_vec3_mul(a->scale, b->scale);
    return r;
}

#ifdef __cplusplus
}
#endif

#undef NKW_SHUFFLE

#endif
