/* SPDX-License-Identifier: MIT */
/*
 * Blends of poses, a block of at most BLEND_BLOCK joints at a time.
 *
 * Invariant: a joint has the bits of the scalar functions, whichever register it is in; joints behind `used` are
 * written, never computed with; out may be a or b.
 *
 *     sum      block -> lerp of all rows, rotations as sums (1 - t) a + t c, c = +-b        nkwi_blend_sum, _mix
 *     nlerp    block -> sums -> lengths -> sum / length                                     nkwi_blend_nlerp, _each
 *
 *     layers   pose 0 --mix t1--> sum --mix t2--> sum ... --each--> pose        t of nkwi_blend_share
 *
 * The mean of layers with weights w, one after another: W = w1 + ... + wk, and
 *
 *     m(k) = (W - wk)/W m(k - 1) + wk/W x(k) = lerp(m(k - 1), x(k), wk/W)
 *
 * so every layer is a lerp by its share, and the sums of rotations are divided by their length only at the end.
 */
#include "lane/strict.h"

#include <nakawari/scalar.h>

#include "batch/blend.h"
#include "batch/block.h"
#include "batch/element.h"
#include "batch/last.h"
#include "batch/nlerp_sums.h"
#include "batch/pose_sums.h"
#include "lane/blend.h"
#include "sizes.h"

NKW_LOOPS_BLEND(NKW_DECLARE_LOOP)

static inline nkw_quat_span rotation_span(blend_span rows)
{
    return block_rows_to(rows.at + 3 * rows.stride, rows.stride);
}

/*
 * Two poses, a register of joints at a time. The arrays of a pose, `stride` floats apart:
 *
 *     0 1 2     translation      lerp
 *     3 4 5 6   rotation         nlerp
 *     7 8 9     scale            lerp
 *
 * Equal rotations and ends are selected by masks: real poses have them in most registers. `inside`, a constant, states
 * that all t are inside 0..1.
 */

/* The next joints of two poses, of the result, and of their sums: components `sums` floats apart; and the lengths. */
typedef struct lanes {
    blend_rows a, b;
    blend_span out;
    float *sum, *length;
    size_t sums;
} lanes;

NKW_ALWAYS_INLINE lanes lanes_after(lanes l, size_t n)
{
    l.a.at += n;
    l.b.at += n;
    l.out.at += n;
    l.sum += n;
    l.length += n;
    return l;
}

/* A register of joints. `keep`, a constant, is NULL, or of the last joints: what is behind them is 0, not read. */
NKW_ALWAYS_INLINE f32xN joints_at(const float *x, const i32xN *keep)
{
    const f32xN r = f32xN_load_once(x);
    return keep ? f32xN_keep(*keep, r) : r;
}

NKW_ALWAYS_INLINE void lerp_row(lanes l, size_t row, f32xN_weights at, int inside, const i32xN *keep)
{
    f32xN a = joints_at(l.a.at + row * l.a.stride, keep), b = joints_at(l.b.at + row * l.b.stride, keep);
    f32xN_store(l.out.at + row * l.out.stride, f32xN_lerp(a, b, at, inside));
}

NKW_ALWAYS_INLINE void lerp_rows(lanes l, size_t row, f32xN_weights at, int inside, const i32xN *keep)
{
    lerp_row(l, row, at, inside, keep);
    lerp_row(l, row + 1, at, inside, keep);
    lerp_row(l, row + 2, at, inside, keep);
}

NKW_ALWAYS_INLINE f32xN_quat rotation_of(blend_rows rows, const i32xN *keep)
{
    const float *x = rows.at + 3 * rows.stride;
    f32xN_quat r = {joints_at(x, keep), joints_at(x + rows.stride, keep), joints_at(x + 2 * rows.stride, keep),
                    joints_at(x + 3 * rows.stride, keep)};
    return r;
}

/*
 * A step, an expression of l and keep, for each register of `used` joints; i is the first of them. No step computes
 * with what is behind the last one: it may be signalling numbers, or memory that was never written.
 *
 *     used = 19, F32XN = 8    | 0 .. 7 | 8 .. 15 | 16 17 18 0 0 0 0 0 |
 *     keep                    NULL     NULL       &last: zeros in place of what is behind
 */
#define FOR_JOINTS(used, l, i, step)                                                                                   \
    do {                                                                                                               \
        int i = 0;                                                                                                     \
        const i32xN *keep = NULL;                                                                                      \
        for (; i + F32XN <= (used); i += F32XN, l = lanes_after(l, F32XN))                                             \
            step;                                                                                                      \
        if (i < (used)) {                                                                                              \
            const i32xN last = f32xN_first((used)-i);                                                                  \
            keep = &last;                                                                                              \
            step;                                                                                                      \
        }                                                                                                              \
    } while (0)

NKW_ALWAYS_INLINE void put_sum(lanes l, f32xN_nlerp r)
{
    put_register_sum(l.sum, l.length, l.sums, r);
}

/* Most poses have one stride. A loop in which it is one variable holds fewer addresses. */
NKW_ALWAYS_INLINE int have_one_stride(blend_rows a, blend_rows b, blend_span out)
{
    return a.stride == out.stride && b.stride == out.stride;
}

NKW_ALWAYS_INLINE void sum_register(lanes l, f32xN_weights at, f32xN scale, const i32xN *keep)
{
    lerp_rows(l, 0, at, 1, keep);
    const f32xN_parts p = f32xN_parts_of(rotation_of(l.a, keep), rotation_of(l.b, keep), at, 1);
    f32xN_quat_store(l.sum, l.sums, f32xN_quat_scale(p.sum, scale));
    lerp_rows(l, 7, at, 1, keep);
}

NKW_ALWAYS_INLINE void sum_joints(lanes l, f32xN_weights at, int used)
{
    const f32xN scale = f32xN_splat(1.0f / NKW_NLERP_SCALE);
    FOR_JOINTS(used, l, i, sum_register(l, at, scale, keep));
}

NKW_ALWAYS_INLINE void sum_block(blend_rows a, blend_rows b, float t, int used, blend_span out)
{
    const lanes l = {a, b, out, out.at + 3 * out.stride, out.at, out.stride};
    if (t < 0.5f)
        sum_joints(l, f32xN_weights_from(t, 1), used);
    else
        sum_joints(l, f32xN_weights_from(t, 0), used);
}

/* The lerp by a t inside 0..1, rotations as sums. out may be a. */
NKW_LOOP(nkwi_blend_sum)(blend_rows a, blend_rows b, float t, int used, blend_span out)
{
    const blend_rows from = {a.at, out.stride}, to = {b.at, out.stride};
    if (have_one_stride(a, b, out))
        sum_block(from, to, t, used, out);
    else
        sum_block(a, b, t, used, out);
}

NKW_ALWAYS_INLINE void divide_lanes(lanes l, u32xN *far)
{
    f32xN_quat_store(l.out.at + 3 * l.out.stride, l.out.stride, divided_sum(l.sum, l.length, l.sums, far));
}

/* What comes before the divisions, and with them. */
NKW_ALWAYS_INLINE void nlerp_register(lanes l, f32xN_weights at, const i32xN *keep)
{
    put_sum(l, f32xN_nlerp_of(rotation_of(l.a, keep), rotation_of(l.b, keep), at, 1));
    lerp_rows(l, 0, at, 1, keep);
}

NKW_ALWAYS_INLINE void divide_register(lanes l, f32xN_weights at, u32xN *far, const i32xN *keep)
{
    divide_lanes(l, far);
    lerp_rows(l, 7, at, 1, keep);
}

/*
 * All sums come before all divisions, so that no register waits for the root of the one before. Returns whether a
 * length was far from that of rotations.
 */
NKW_ALWAYS_INLINE int nlerp_joints(lanes l, f32xN_weights at, int used)
{
    u32xN far = u32xN_from_f32xN(f32xN_splat(0.0f));
    lanes from = l;
    FOR_JOINTS(used, l, i, nlerp_register(l, at, keep));
    l = from;
    end_sums(l.sum, l.length, l.sums, used);
    FOR_JOINTS(used, l, i, divide_register(l, at, &far, keep));
    return u32xN_any(far) >> 30 != 0;
}

/* All again by the general formula. */
NKW_NOINLINE LANE_FLAT static void normalize_again(const float *sum, const float *length, blend_span out, int used)
{
    normalize_sums(block_rows(sum, SUM_STRIDE), length, 1, rotation_span(out), (size_t)used);
}

/* nkw_pose_blend of a block by a t inside 0..1. */
NKW_ALWAYS_INLINE void nlerp_block(blend_rows a, blend_rows b, float t, int used, blend_span out)
{
    float sum[5 * SUM_STRIDE];
    const lanes l = {a, b, out, sum, sum + 4 * SUM_STRIDE, SUM_STRIDE};
    if (t < 0.5f ? nlerp_joints(l, f32xN_weights_from(t, 1), used) : nlerp_joints(l, f32xN_weights_from(t, 0), used))
        normalize_again(sum, l.length, out, used);
}

NKW_LOOP(nkwi_blend_nlerp)(blend_rows a, blend_rows b, float t, int used, blend_span out)
{
    const blend_rows from = {a.at, out.stride}, to = {b.at, out.stride};
    if (have_one_stride(a, b, out))
        nlerp_block(from, to, t, used, out);
    else
        nlerp_block(a, b, t, used, out);
}

/* nlerp of poses that share a stride: two strides fewer to pass and to compare are 2 % of a blend of 67 joints. */
NKW_LOOP(nkwi_blend_poses)(const float *a, const float *b, size_t stride, float t, int used, float *out)
{
    const blend_rows from = {a, stride}, to = {b, stride};
    const blend_span span = {out, stride};
    nlerp_block(from, to, t, used, span);
}

/* The weight of each joint; behind them that of the last one, which needs no separate case. */
NKW_LOOP(nkwi_blend_weigh)(float weight, const float *mask, int used, float *out, int n)
{
#pragma omp simd
    for (int i = 0; i < used; i++)
        out[i] = weight * lane_mask(mask[i]);
    for (int i = used; i < n; i++)
        out[i] = out[used - 1];
}

NKW_ALWAYS_INLINE f32xN_nlerp sum_each(lanes l, f32xN_weights at, const float *open, const i32xN *keep)
{
    const f32xN_quat a = rotation_of(l.a, keep), b = rotation_of(l.b, keep);
    return open ? f32xN_mix_of(a, b, at, f32xN_load(open)) : f32xN_nlerp_of(a, b, at, 0);
}

/*
 * The registers of loops with a t for each joint: weights are computed for each register, and masks select the ends, as
 * t may be 0, 1 or outside. `open` of a joint is not 0 where a is itself a sum of rotations, not of unit length.
 */
NKW_ALWAYS_INLINE void nlerp_each(lanes l, const float *t, const float *open, const i32xN *keep)
{
    const f32xN_weights at = f32xN_weights_of(f32xN_load(t), 0);
    put_sum(l, sum_each(l, at, open, keep));
    lerp_rows(l, 0, at, 0, keep);
}

NKW_ALWAYS_INLINE void divide_each(lanes l, const float *t, u32xN *far, const i32xN *keep)
{
    divide_lanes(l, far);
    lerp_rows(l, 7, f32xN_weights_of(f32xN_load(t), 0), 0, keep);
}

NKW_ALWAYS_INLINE void mix_each(lanes l, const float *t, const float *open, const i32xN *keep)
{
    const f32xN_weights at = f32xN_weights_of(f32xN_load(t), 0);
    f32xN_quat_store(l.sum, l.sums, f32xN_mix_sum(sum_each(l, at, open, keep)));
    lerp_rows(l, 0, at, 0, keep);
    lerp_rows(l, 7, at, 0, keep);
}

NKW_ALWAYS_INLINE void each_block(blend_rows a, blend_rows b, const float *t, const float *open, int used,
                                  blend_span out)
{
    float sum[5 * SUM_STRIDE];
    const lanes begin = {a, b, out, sum, sum + 4 * SUM_STRIDE, SUM_STRIDE};
    u32xN far = u32xN_from_f32xN(f32xN_splat(0.0f));
    lanes l = begin;
    FOR_JOINTS(used, l, i, nlerp_each(l, t + i, open ? open + i : NULL, keep));
    l = begin;
    end_sums(l.sum, l.length, l.sums, used);
    FOR_JOINTS(used, l, i, divide_each(l, t + i, &far, keep));
    if (u32xN_any(far) >> 30 != 0)
        normalize_again(sum, begin.length, out, used);
}

/*
 * nkw_pose_blend by a t for each joint, any. `open` is NULL, or a and b are layers: where open[i] is not 0, a has a sum
 * of several.
 */
NKW_LOOP(nkwi_blend_each)
(blend_rows a, blend_rows b, const float *t, const float *open, int used, blend_span out)
{
    const blend_rows from = {a.at, out.stride}, to = {b.at, out.stride};
    if (have_one_stride(a, b, out))
        each_block(from, to, t, open, used, out);
    else
        each_block(a, b, t, open, used, out);
}

/*
 * The same, rotations as sums. out may be a. mixed becomes 1 where more than one pose has a share, 0 where one alone
 * has all.
 */
NKW_LOOP(nkwi_blend_mix)(blend_rows a, blend_rows b, const float *t, float *mixed, int used, blend_span out)
{
    lanes l = {a, b, out, out.at + 3 * out.stride, out.at, out.stride};
    FOR_JOINTS(used, l, i, mix_each(l, t + i, mixed + i, keep));
#pragma omp simd
    for (int i = 0; i < used; i++)
        mixed[i] = t[i] == 0.0f ? mixed[i] : t[i] == 1.0f ? 0.0f : 1.0f;
}

/*
 * Whether the rotations of `count` poses, from float `from` on, are all near those of the first one: as vectors of unit
 * length to 1e-2 within 45 degrees of them up to sign, |a . b| > 0.73; not where it is NaN. Then all signs agree.
 */
#define BLEND_NEAR 0.73f

NKW_ALWAYS_INLINE f32xN_quat rotation_at(const float *x, size_t stride, const i32xN *keep)
{
    f32xN_quat r = {f32xN_load(x), f32xN_load(x + stride), f32xN_load(x + 2 * stride), f32xN_load(x + 3 * stride)};
    if (keep) {
        r.x = f32xN_keep(*keep, r.x);
        r.y = f32xN_keep(*keep, r.y);
        r.z = f32xN_keep(*keep, r.z);
        r.w = f32xN_keep(*keep, r.w);
    }
    return r;
}

NKW_ALWAYS_INLINE i32xN near_register(const float *const *poses, size_t count, size_t at, size_t stride,
                                      const i32xN *keep)
{
    const f32xN_quat first = rotation_at(poses[0] + at, stride, keep);
    i32xN near = f32xN_equal(f32xN_splat(0.0f), f32xN_splat(0.0f));
    for (size_t k = 1; k < count; k++) {
        const f32xN dot = f32xN_quat_dot(first, rotation_at(poses[k] + at, stride, keep));
        near &= f32xN_less(f32xN_splat(BLEND_NEAR), f32xN_magnitude(dot));
    }
    return keep ? near | ~*keep : near;
}

/* Sets *far if they are not. */
NKW_LOOP(nkwi_blend_far)(const float *const *poses, size_t count, size_t stride, size_t from, int used, int *far)
{
    size_t at = from + 3 * stride;
    i32xN near = f32xN_equal(f32xN_splat(0.0f), f32xN_splat(0.0f));
    int i = 0;
    for (; i + F32XN <= used; i += F32XN, at += F32XN)
        near &= near_register(poses, count, at, stride, NULL);
    if (i < used) {
        const i32xN last = f32xN_first(used - i);
        near &= near_register(poses, count, at, stride, &last);
    }
    *far = u32xN_any(u32xN_from_f32xN(f32xN_from_i32xN(~near))) != 0;
}

/*
 * Marks the joints at which the signs of first . a, first . b and a . b have the product -1: no signs of the three
 * rotations make all their dot products positive. NaN marks too.
 */
NKW_ALWAYS_INLINE void disagree_register(blend_rows first, lanes l, u32xN *any, const i32xN *keep)
{
    const f32xN_quat q = rotation_of(first, keep), a = rotation_of(l.a, keep), b = rotation_of(l.b, keep);
    const f32xN zero = f32xN_splat(0.0f);
    const f32xN to_a = f32xN_quat_dot(q, a), to_b = f32xN_quat_dot(q, b), dot = f32xN_quat_dot(a, b);
    const i32xN odd = f32xN_less(to_a, zero) ^ f32xN_less(to_b, zero) ^ f32xN_less(dot, zero);
    const i32xN known = f32xN_equal(to_a, to_a) & f32xN_equal(to_b, to_b) & f32xN_equal(dot, dot);
    const i32xN found = (odd | ~known) | i32xN_from_f32xN(f32xN_load(l.sum));
    f32xN_store(l.sum, f32xN_from_i32xN(found));
    *any |= u32xN_from_f32xN(f32xN_from_i32xN(found));
}

/* marks: bits are set; *any: whether some are. */
NKW_LOOP(nkwi_blend_disagree)(blend_rows first, blend_rows a, blend_rows b, int used, float *marks, int *any)
{
    const blend_span to = {marks, 0};
    u32xN found = u32xN_from_f32xN(f32xN_splat(0.0f));
    lanes l = {a, b, to, marks, marks, 0};
    FOR_JOINTS(used, l, i, (disagree_register(first, l, &found, keep), first.at += F32XN));
    *any |= u32xN_any(found) != 0;
}

/* The share of a pose in the sum of it and those before, t = w/(total + w); adds w to the total, in binary64. */
NKW_LOOP(nkwi_blend_share)(const float *weight, double *total, float *t, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        float share = lane_share(weight[i], (float)total[i]);
        total[i] = total[i] + (double)weight[i];
        t[i] = share;
    }
}

/* The weight of the rest pose, threshold - total, where the layers of a joint fall short; *any: whether one does. */
NKW_LOOP(nkwi_blend_missing)(const double *total, float threshold, float *out, int *any, int n)
{
    int found = 0;
#pragma omp simd reduction(| : found)
    for (int i = 0; i < n; i++) {
        out[i] = lane_missing(total[i], threshold);
        found |= out[i] > 0.0f;
    }
    *any = found;
}

/*
 * The additive pose a - ref, joint by joint, so that base + 1 (a - ref) is a where base is ref:
 *
 *     translation    a - ref
 *     rotation       ref^-1 a, or a ref^-1 on the parent's side          1 without a difference
 *     scale          a / ref                                             1 without a difference, and where ref is 0
 */
NKW_ALWAYS_INLINE void build_joints(nkw_trs_view a, nkw_trs_view ref, int parent, nkw_trs_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out.translation, i, nkw_vec3_sub(at_vec3(a.translation, i), at_vec3(ref.translation, i)));
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_quat(out.rotation, i, lane_quat_delta(at_quat(a.rotation, i), at_quat(ref.rotation, i), parent));
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        nkw_vec3 s = at_vec3(a.scale, i), r = at_vec3(ref.scale, i);
        nkw_vec3 ratio = {lane_ratio(s.x, r.x), lane_ratio(s.y, r.y), lane_ratio(s.z, r.z)};
        put_vec3(out.scale, i, ratio);
    }
}

/* Both loops take the joints after the last multiple of LAST_LANES from memory of their own, with identities. */
NKW_LOOP(nkwi_additive_build)(nkw_trs_view a, nkw_trs_view ref, int parent, nkw_trs_span out, size_t n)
{
    last_joints last[2];
    const size_t whole = n - n % LAST_LANES;
    build_joints(a, ref, parent, out, whole);
    if (whole == n)
        return;
    a = copy_last_joints(a, whole, n - whole, &last[0]);
    ref = copy_last_joints(ref, whole, n - whole, &last[1]);
    build_joints(a, ref, parent, trs_span_after(out, whole), LAST_LANES);
}

/* The nlerps from none to the turns `delta` by their weights come first, then base times each, or each times base. */
NKW_ALWAYS_INLINE void add_turns(nkw_quat_view base, nkw_quat_view delta, const float *weight, int parent,
                                 nkw_quat_span out, size_t n)
{
    nlerp_sums c;
    float x[BLEND_BLOCK], y[BLEND_BLOCK], z[BLEND_BLOCK], w[BLEND_BLOCK];
    const nkw_quat_span parts = {x, y, z, w};
    int far = 0;
#pragma omp simd reduction(| : far)
    for (size_t i = 0; i < n; i++) {
        nkw_quat d = at_quat(delta, i);
        put_nlerp(c, i, lane_quat_nlerp(lane_quat_none(d), d, weight[i], 0), far);
    }
    normalize_block_sums(&c, far, parts, n);
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_quat(out, i, lane_quat_add_delta(at_quat(base, i), at_quat(parts, i), weight[i], parent));
}

NKW_ALWAYS_INLINE void apply_joints(nkw_trs_view base, nkw_trs_view delta, const float *weight, int parent,
                                    nkw_trs_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out.translation, i,
                 lane_vec3_add_delta(at_vec3(base.translation, i), at_vec3(delta.translation, i), weight[i]));
    add_turns(base.rotation, delta.rotation, weight, parent, out.rotation, n);
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        nkw_vec3 d = at_vec3(delta.scale, i);
        float w = weight[i];
        nkw_vec3 part = {nkw_lerp(1.0f, d.x, w), nkw_lerp(1.0f, d.y, w), nkw_lerp(1.0f, d.z, w)};
        put_vec3(out.scale, i, nkw_vec3_mul(at_vec3(base.scale, i), part));
    }
}

/* n is at most BLEND_BLOCK. The weights end with a multiple of LAST_LANES. */
NKW_LOOP(nkwi_additive_apply)
(nkw_trs_view base, nkw_trs_view delta, const float *weight, int parent, nkw_trs_span out, size_t n)
{
    last_joints last[2];
    const size_t whole = n - n % LAST_LANES;
    if (whole > 0)
        apply_joints(base, delta, weight, parent, out, whole);
    if (whole == n)
        return;
    base = copy_last_joints(base, whole, n - whole, &last[0]);
    delta = copy_last_joints(delta, whole, n - whole, &last[1]);
    apply_joints(base, delta, weight + whole, parent, trs_span_after(out, whole), LAST_LANES);
}
