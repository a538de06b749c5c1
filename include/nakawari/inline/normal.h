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
 * Vectors are normalised by their squared length n2. In 2^-96 .. 2^96 no square has overflowed, and a square that
 * underflows is too small to matter. Otherwise (also for NaN) the vector is first multiplied by a power of two: 2^100
 * below, 2^-70 above that range.
 */
NKW_PART int nkw_is_moderate(float n2)
{
    uint32_t bits;
    memcpy(&bits, &n2, sizeof bits);
    return bits - (UINT32_C(31) << 23) <= UINT32_C(192) << 23;
}

/* By the exponent: GCC compiles a selection between constants to three products, each with what follows. */
NKW_PART float nkw_normal_scale(float n2)
{
    uint32_t up = n2 < 1.26217745e-29f ? UINT32_C(100) << 23 : 0, down = n2 > 7.92281625e28f ? UINT32_C(70) << 23 : 0;
    uint32_t bits = (UINT32_C(0x3F800000) + up) - down;
    float scale;
    memcpy(&scale, &bits, sizeof scale);
    return scale;
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
 * a / n, q / n: one division of four floats where there is a register for them. The loops of the library (NKW_ISA) divide
 * component by component.
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
