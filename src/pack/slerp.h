/* SPDX-License-Identifier: MIT */
/* Slerp and nlerp of two quaternions, each in one register: for scalar calls. Loops take the lanes. */
#ifndef NAKAWARI_PACK_SLERP_H
#define NAKAWARI_PACK_SLERP_H

#include "lane/strict.h"

#include "lane/orient.h"
#include "pack/f32x4.h"
#include "pack/quat.h"

#if NKW_F32X4
/* Second text of lane_quat_slerp; 3.0 times. The weights come from the lane. */
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

/* Second text of lane_quat_nlerp; 2.5 times. Returns 0 where *out is not the result: chords of 0 or of sqrt 2 and more. */
static inline int f32x4_nlerp(f32x4 a, f32x4 b, float t, f32x4 *out)
{
    const int first = t < 0.5f;
    const float back = (first ? 0.0f : 1.0f) - t;
    const f32x4 zero = f32x4_splat(0.0f), quarter = f32x4_splat(0.25f), c = f32x4_flip(b, f32x4_sum(a * b) < zero);
    const i32x4 inside = f32x4_splat(back) != zero;
    const f32x4 v = (first ? a : c) - (f32x4)((i32x4)(back * (c - a)) & inside);
    const float m = f32x4_sum(quarter - v * v)[0], n2 = 1.0f - m;
    const f32x4 g = f32x4_splat(m / (sqrtf(n2) + n2));
    *out = v + v * (f32x4)((i32x4)g & inside);
    return m * m < 1.0f;
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
