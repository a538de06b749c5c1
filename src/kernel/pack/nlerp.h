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

static inline f32xN_quat f32xN_quat_scale(f32xN_quat q, f32xN s)
{
    f32xN_quat r = {q.x * s, q.y * s, q.z * s, q.w * s};
    return r;
}

static inline f32xN_quat f32xN_quat_over(f32xN_quat q, f32xN n)
{
    f32xN_quat r = {q.x / n, q.y / n, q.z / n, q.w / n};
    return r;
}

/* a where the mask is set, otherwise b. */
static inline f32xN_quat f32xN_quat_select(i32xN mask, f32xN_quat a, f32xN_quat b)
{
    f32xN_quat r = {f32xN_select(mask, a.x, b.x), f32xN_select(mask, a.y, b.y), f32xN_select(mask, a.z, b.z),
                    f32xN_select(mask, a.w, b.w)};
    return r;
}

/*
 * What depends on t alone. `t` and `s` are the weights of nlerp, 2^60 t and 2^60 (1 - t), at t = 1 2^60 and 2^60.
 * `back` is the lerp's distance from t to the end that is nearer, a where `first` is set. `inside`, a constant, states
 * that all t are inside 0..1: then the masks are not used.
 */
typedef struct f32xN_weights {
    f32xN t, s, back;
    i32xN first, is_first, is_last;
} f32xN_weights;

static inline f32xN_weights f32xN_weights_of(f32xN t, int inside)
{
    const f32xN zero = f32xN_splat(0.0f), one = f32xN_splat(1.0f), whole = f32xN_splat(NKW_NLERP_SCALE);
    const i32xN first = f32xN_less(t, f32xN_splat(0.5f)), is_last = f32xN_equal(t, one);
    const f32xN s = whole - whole * t;
    f32xN_weights r = {whole * t,
                       inside ? s : f32xN_select(is_last, whole, s),
                       f32xN_select(first, zero, one) - t,
                       first,
                       f32xN_equal(t, zero),
                       is_last};
    return r;
}

/* The same inside 0..1, with a constant: whether a is nearer. */
static inline f32xN_weights f32xN_weights_from(float t, int first)
{
    f32xN_weights at = f32xN_weights_of(f32xN_splat(t), 1);
    const i32xN none = at.first ^ at.first;
    at.first = first ? ~none : none;
    return at;
}

/* The lerp of one register, p = end - back (b - a); nkw_lerp_from. */
static inline f32xN f32xN_lerp(f32xN a, f32xN b, f32xN_weights at, int inside)
{
    const f32xN zero = f32xN_splat(0.0f), step = at.back * (b - a);
    return f32xN_select(at.first, a, b) - (inside ? step : f32xN_select(f32xN_equal(at.back, zero), zero, step));
}

static inline i32xN f32xN_quat_equal(f32xN_quat a, f32xN_quat b)
{
    return (f32xN_equal(a.x, b.x) & f32xN_equal(a.y, b.y)) & (f32xN_equal(a.z, b.z) & f32xN_equal(a.w, b.w));
}

static inline f32xN_quat f32xN_quat_negate_where(i32xN mask, f32xN_quat q)
{
    f32xN_quat r = {f32xN_negate_where(mask, q.x), f32xN_negate_where(mask, q.y), f32xN_negate_where(mask, q.z),
                    f32xN_negate_where(mask, q.w)};
    return r;
}

/* part = (1 - t) a, c = +-b, sum = part + t c; and where a = c is not zero. */
typedef struct f32xN_parts {
    f32xN_quat part, c, sum;
    i32xN is_equal;
} f32xN_parts;

static inline f32xN_parts f32xN_parts_of(f32xN_quat a, f32xN_quat b, f32xN_weights at, int inside)
{
    const f32xN zero = f32xN_splat(0.0f);
    const f32xN_quat part = f32xN_quat_scale(a, at.s);
    const f32xN dot = f32xN_quat_dot(part, b);
    const i32xN obtuse = f32xN_less(dot, zero);
    const f32xN_quat c = f32xN_quat_negate_where(inside ? obtuse : obtuse ^ f32xN_less(at.s, zero), b);
    f32xN_parts r = {part,
                     c,
                     {part.x + at.t * c.x, part.y + at.t * c.y, part.z + at.t * c.z, part.w + at.t * c.w},
                     f32xN_quat_equal(a, c) & ~f32xN_equal(dot, zero)};
    return r;
}

/* What is divided by the root of n2: a sum, or, where n2 is 1, the result as it is. */
typedef struct f32xN_nlerp {
    f32xN_quat v;
    f32xN n2;
} f32xN_nlerp;

static inline f32xN_nlerp f32xN_nlerp_or(i32xN is_kept, f32xN_quat kept, f32xN_quat sum)
{
    f32xN_nlerp r = {f32xN_quat_select(is_kept, kept, sum),
                     f32xN_select(is_kept, f32xN_splat(1.0f), f32xN_quat_dot(sum, sum))};
    return r;
}

/* Second text of lane_quat_nlerp; 1.6 times faster. */
static inline f32xN_nlerp f32xN_nlerp_of(f32xN_quat a, f32xN_quat b, f32xN_weights at, int inside)
{
    const f32xN_parts p = f32xN_parts_of(a, b, at, inside);
    if (inside)
        return f32xN_nlerp_or(p.is_equal, a, p.sum);
    return f32xN_nlerp_or(p.is_equal | at.is_first | at.is_last, f32xN_quat_select(at.is_last, p.c, a), p.sum);
}

/*
 * The same of layers: at t = 1 it is b itself, whatever a is. Where `open` is not 0, a is a sum of several, which is
 * normalised at t = 0 as well: 2^60 a is the part of a there.
 */
static inline f32xN_nlerp f32xN_mix_of(f32xN_quat a, f32xN_quat b, f32xN_weights at, f32xN open)
{
    const f32xN_parts p = f32xN_parts_of(a, b, at, 0);
    const i32xN is_sum = at.is_first & ~f32xN_equal(open, f32xN_splat(0.0f));
    const i32xN is_kept = (p.is_equal | at.is_first | at.is_last) & ~is_sum;
    return f32xN_nlerp_or(is_kept, f32xN_quat_select(at.is_last, b, a), f32xN_quat_select(is_sum, p.part, p.sum));
}

/* The sum itself, as large as rotations are. */
static inline f32xN_quat f32xN_mix_sum(f32xN_nlerp r)
{
    const f32xN one = f32xN_splat(1.0f);
    return f32xN_quat_scale(r.v, f32xN_select(f32xN_equal(r.n2, one), one, f32xN_splat(1.0f / NKW_NLERP_SCALE)));
}

#endif
