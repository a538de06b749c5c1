/* SPDX-License-Identifier: MIT */
/*
 * Lerp and the sums of nlerp of many rotations, F32XN at a time, each component in a register: for poses, whose ten
 * arrays of three poses need more address registers than compilers have in a loop over lanes.
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

static inline f32xN f32xN_quat_dot(f32xN_quat a, f32xN_quat b)
{
    return (a.x * b.x + a.y * b.y) + (a.z * b.z + a.w * b.w);
}

/* The t of F32XN joints, 1 - t, and the x of f32xN_lerp. All are inside 0..1, and on one side of 1/2. */
typedef struct f32xN_time {
    f32xN t, s, x;
} f32xN_time;

/* `first`, a constant, is not 0 where t < 1/2. */
static inline f32xN_time f32xN_time_at(f32xN t, int first)
{
    const f32xN one = f32xN_splat(1.0f);
    f32xN_time r = {t, one - t, first ? t : t - one};
    return r;
}

/* p = a + t (b - a) = b + (t - 1) (b - a), from the end that is nearer. */
static inline f32xN f32xN_lerp(f32xN a, f32xN b, f32xN x, int first)
{
    return (first ? a : b) + x * (b - a);
}

/* Second text of nkw_nlerp_sum; 1.3 times faster. */
static inline f32xN_quat f32xN_nlerp_sum(f32xN_quat a, f32xN_quat b, f32xN_time at)
{
    const f32xN t = f32xN_negate_where(f32xN_less(f32xN_quat_dot(a, b), f32xN_splat(0.0f)), at.t);
    f32xN_quat r = {at.s * a.x + t * b.x, at.s * a.y + t * b.y, at.s * a.z + t * b.z, at.s * a.w + t * b.w};
    return r;
}

static inline f32xN_quat f32xN_quat_over(f32xN_quat q, f32xN n)
{
    f32xN_quat r = {q.x / n, q.y / n, q.z / n, q.w / n};
    return r;
}

/* A bit for each |a| = |b|. */
static inline uint32_t f32xN_same_size(f32xN a, f32xN b)
{
    const i32xN other = i32xN_from_f32xN(a) ^ i32xN_from_f32xN(b);
    return i32xN_bits(i32xN_equal(other + other, other ^ other));
}

#endif
