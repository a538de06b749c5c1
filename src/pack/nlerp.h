/* SPDX-License-Identifier: MIT */
/*
 * Lerp and the sums of nlerp of many rotations, F32XN at a time, each component in a register: for poses, whose ten
 * arrays of three poses need more address registers than compilers have in a loop over lanes.
 */
#ifndef NAKAWARI_PACK_NLERP_H
#define NAKAWARI_PACK_NLERP_H

#include <nakawari/orient.h>

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

/* The weights of F32XN joints, 2^60 t and 2^60 (1 - t). All t are inside 0..1. */
typedef struct f32xN_weights {
    f32xN t, s;
} f32xN_weights;

static inline f32xN_weights f32xN_weights_of(f32xN t)
{
    const f32xN whole = f32xN_splat(NKW_NLERP_SCALE);
    f32xN_weights r = {whole * t, whole - whole * t};
    return r;
}

/* p = a + t (b - a) = b + (t - 1) (b - a), from the end that is nearer: `first`, a constant, is not 0 where t < 1/2. */
static inline f32xN f32xN_lerp(f32xN a, f32xN b, f32xN t, int first)
{
    return (first ? a : b) + (first ? t : t - f32xN_splat(1.0f)) * (b - a);
}

static inline f32xN_quat f32xN_quat_scale(f32xN_quat q, f32xN s)
{
    f32xN_quat r = {q.x * s, q.y * s, q.z * s, q.w * s};
    return r;
}

/* The sum of generic weights. Second text of lane_quat_nlerp; 1.6 times faster. */
static inline f32xN_quat f32xN_nlerp_sum(f32xN_quat a, f32xN_quat b, f32xN_weights at)
{
    const f32xN_quat part = f32xN_quat_scale(a, at.s);
    const f32xN t = f32xN_negate_where(f32xN_less(f32xN_quat_dot(part, b), f32xN_splat(0.0f)), at.t);
    f32xN_quat r = {part.x + t * b.x, part.y + t * b.y, part.z + t * b.z, part.w + t * b.w};
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
    return i32xN_bits(i32xN_equal(other & INT32_MAX, other ^ other));
}

#endif
