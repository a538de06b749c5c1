/* SPDX-License-Identifier: MIT */
/* Slerp of two quaternions, each in one register: for scalar calls. Loops use the lanes. */
#ifndef NAKAWARI_PACK_SLERP_H
#define NAKAWARI_PACK_SLERP_H

#include "lane/strict.h"

#include "lane/orient.h"
#include "pack/f32x4.h"
#include "pack/quat.h"

#if NKW_F32X4
/* Second text of lane_quat_slerp; 2.1 times faster. The weights come from the lane. */
static inline f32x4 f32x4_slerp(f32x4 a, f32x4 b, float t, int generic, int keys)
{
    const f32x4 cosine = f32x4_sum(a * b) + 0x1p-126f, c = f32x4_flip(b, (i32x4)cosine), d = c - a;
    const float v = lane_slerp_angle(lane_abs(cosine[0]), f32x4_sum(d * d)[0], keys);
    const lane_slerp_time at = lane_slerp_time_at(t, generic);
    const lane_slerp_weights k = lane_slerp_weights_of(&at, v);
    const i32x4 zero = {0, 0, 0, 0}, first = zero + (int32_t)at.first, half = zero + (int32_t)at.half;
    f32x4 n = f32x4_select(first, a, c), f = f32x4_select(first, c, a);
    if (!generic) {
        n = f32x4_select(half, 0.5f * (a + c), n);
        f = f32x4_select(half, 0.5f * (a + c), f);
    }
    return n - (k.e * f - k.w * (f - n));
}

#endif

/* lane_quat_slerp of stored keys, for scalar calls. */
static inline nkw_quat quat_slerp_keys(nkw_quat a, nkw_quat b, float t)
{
#if NKW_F32X4
    const f32x4 from = f32x4_from_quat(a), to = f32x4_from_quat(b);
    return quat_from_f32x4(lane_t_is_generic(t) ? f32x4_slerp(from, to, t, 1, 1) : f32x4_slerp(from, to, t, 0, 1));
#else
    return lane_quat_slerp(a, b, t, 1);
#endif
}

#endif
