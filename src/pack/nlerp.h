/* SPDX-License-Identifier: MIT */
/*
 * Lerp and nlerp of many rotations at one t inside 0..1, F32XN at a time, each component in a register: for poses, whose
 * ten arrays of three poses need more address registers than compilers have in a loop over lanes.
 *
 * `first`, a constant, is not 0 where t < 1/2. x is t then, otherwise t - 1.
 */
#ifndef NAKAWARI_PACK_NLERP_H
#define NAKAWARI_PACK_NLERP_H

#include "pack/f32xn.h"

typedef struct f32xN_quat {
    f32xN x, y, z, w;
} f32xN_quat;

/* Components that begin at x, `stride` floats apart. */
static inline f32xN_quat f32xN_quat_load(const float *x, size_t stride)
{
    f32xN_quat r = {f32xN_load_once(x), f32xN_load_once(x + stride), f32xN_load_once(x + 2 * stride),
                    f32xN_load_once(x + 3 * stride)};
    return r;
}

static inline void f32xN_quat_store(float *x, size_t stride, f32xN_quat q)
{
    f32xN_store(x, q.x);
    f32xN_store(x + stride, q.y);
    f32xN_store(x + 2 * stride, q.z);
    f32xN_store(x + 3 * stride, q.w);
}

/* p = a + t (b - a) = b + (t - 1) (b - a) */
static inline f32xN f32xN_lerp(f32xN a, f32xN b, f32xN x, int first)
{
    return (first ? a : b) + x * (b - a);
}

/* Second text of lane_quat_chord and lane_chord_normalize_short; 1.3 times faster. */
static inline f32xN_quat f32xN_chord(f32xN_quat a, f32xN_quat b, f32xN x, int first)
{
    const f32xN dot = (a.x * b.x + a.y * b.y) + (a.z * b.z + a.w * b.w);
    const i32xN obtuse = f32xN_less(dot, f32xN_splat(0.0f));
    f32xN_quat r = {
        f32xN_lerp(a.x, f32xN_negate_where(obtuse, b.x), x, first),
        f32xN_lerp(a.y, f32xN_negate_where(obtuse, b.y), x, first),
        f32xN_lerp(a.z, f32xN_negate_where(obtuse, b.z), x, first),
        f32xN_lerp(a.w, f32xN_negate_where(obtuse, b.w), x, first),
    };
    return r;
}

/* Sets bits 30 or 31 of *outside where not 0 < |v|^2 <= 2. */
static inline f32xN_quat f32xN_chord_normalize(f32xN_quat v, u32xN *outside)
{
    const f32xN quarter = f32xN_splat(0.25f);
    const f32xN m = ((quarter - v.x * v.x) + (quarter - v.y * v.y)) + ((quarter - v.z * v.z) + (quarter - v.w * v.w));
    const f32xN n2 = f32xN_splat(1.0f) - m, g = m / (f32xN_sqrt(n2) + n2);
    f32xN_quat r = {v.x + v.x * g, v.y + v.y * g, v.z + v.z * g, v.w + v.w * g};
    *outside |= u32xN_from_f32xN(n2) - 1; /* 0 < n2 <= 2: the bits minus 1 are below 2^30 */
    return r;
}

#endif
