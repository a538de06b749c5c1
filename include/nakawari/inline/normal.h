/* SPDX-License-Identifier: MIT */
/* What nkw_vec3_normalize, nkw_quat_normalize and nkw_quat_nlerp share. */
#ifndef NAKAWARI_INLINE_NORMAL_H
#define NAKAWARI_INLINE_NORMAL_H

#include <stdint.h>
#include <string.h>

#include "../types.h"
#include "f32x4.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Vectors are multiplied by 2^31 before they are squared: the squares of components near 1e-23, as exporters leave
 * them, would be subnormal, which takes some hundred cycles on some processors. n2 is the sum of the squares. In 2^-96
 * .. 2^126 no square has overflowed, and one that underflows is too small to matter. Otherwise (also for NaN) the
 * vector is multiplied by another power of two: 2^106 below, 2^-65 above that range.
 */
#define NKW_NORMAL_SCALE 2147483648.0f

NKW_PART int nkw_is_moderate(float n2)
{
    uint32_t bits;
    memcpy(&bits, &n2, sizeof bits);
    return bits - (UINT32_C(31) << 23) <= UINT32_C(222) << 23;
}

/*
 * `usual`, or 2^75 or 2^-96 times that. By the exponent: GCC compiles a selection between constants to three products.
 */
NKW_PART float nkw_normal_scale(float n2, float usual)
{
    uint32_t up = n2 < 1.26217745e-29f ? UINT32_C(75) << 23 : 0, down = n2 > 8.507059173e37f ? UINT32_C(96) << 23 : 0;
    uint32_t bits;
    memcpy(&bits, &usual, sizeof bits);
    bits = (bits + up) - down;
    memcpy(&usual, &bits, sizeof usual);
    return usual;
}

/* a s, q s, of which the caller only takes products and quotients. */
NKW_PART nkw_vec3 nkw_vec3_times(nkw_vec3 a, float s)
{
    NKW_EXACT
    nkw_vec3 r = {a.x * s, a.y * s, a.z * s};
    return r;
}

NKW_PART nkw_quat nkw_quat_times(nkw_quat q, float s)
{
    NKW_EXACT
    nkw_quat r = {q.x * s, q.y * s, q.z * s, q.w * s};
    return r;
}

NKW_PART nkw_vec3 nkw_vec3_over_each(nkw_vec3 a, float n)
{
    NKW_EXACT
    nkw_vec3 r = {a.x / n, a.y / n, a.z / n};
    return r;
}

NKW_PART nkw_quat nkw_quat_over_each(nkw_quat q, float n)
{
    NKW_EXACT
    nkw_quat r = {q.x / n, q.y / n, q.z / n, q.w / n};
    return r;
}

/*
 * a / n, q / n: one division of four floats where there is a register for them. The loops of the library (NKW_ISA)
 * divide component by component.
 */
#if NKW_F32X4 && !defined(NKW_ISA)
/* Second text of nkw_vec3_over_each and nkw_quat_over_each; 1.3 times faster. */
NKW_PART nkw_vec3 nkw_vec3_over(nkw_vec3 a, float n)
{
    nkw_f32x4 v = {a.x, a.y, a.z, n};
    v = v / nkw_f32x4_splat(n);
    nkw_vec3 r = {v[0], v[1], v[2]};
    return r;
}

NKW_PART nkw_quat nkw_quat_over(nkw_quat q, float n)
{
    nkw_f32x4 v = {q.x, q.y, q.z, q.w};
    v = v / nkw_f32x4_splat(n);
    nkw_quat r = {v[0], v[1], v[2], v[3]};
    return r;
}
#else
NKW_PART nkw_vec3 nkw_vec3_over(nkw_vec3 a, float n)
{
    return nkw_vec3_over_each(a, n);
}

NKW_PART nkw_quat nkw_quat_over(nkw_quat q, float n)
{
    return nkw_quat_over_each(q, n);
}
#endif

#ifdef __cplusplus
}
#endif

#undef NKW_SHUFFLE

#endif
