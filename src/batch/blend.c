/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/scalar.h>

#include "batch/blend.h"
#include "batch/block.h"
#include "batch/element.h"
#include "batch/nlerp.h"
#include "lane/blend.h"
#include "pack/nlerp.h"
#include "sizes.h"

NKW_LOOPS_BLEND(NKW_DECLARE_LOOP)

static inline nkw_quat_view rotations_of(blend_rows rows)
{
    return block_rows(rows.at + 3 * rows.stride, rows.stride);
}

static inline nkw_quat_span rotation_span(blend_span rows)
{
    return block_rows_to(rows.at + 3 * rows.stride, rows.stride);
}

static inline nkw_vec3_view vectors_of(blend_rows rows, size_t first)
{
    const float *x = rows.at + first * rows.stride;
    nkw_vec3_view v = {x, x + rows.stride, x + 2 * rows.stride};
    return v;
}

static inline nkw_vec3_span vector_span(blend_span rows, size_t first)
{
    float *x = rows.at + first * rows.stride;
    nkw_vec3_span s = {x, x + rows.stride, x + 2 * rows.stride};
    return s;
}

/*
 * Two poses, a register of joints at a time. The arrays of a pose, `stride` floats apart:
 *
 *     0 1 2     translation      lerp
 *     3 4 5 6   rotation         nlerp
 *     7 8 9     scale            lerp
 *
 * Joints in whose register all t are inside 0..1 on one side of 1/2, and no two rotations may be equal, are computed on
 * registers; the others by the lanes.
 */

/* Floats from one component of the sums of a block to the next: a register more than the block has joints. */
#define SUM_STRIDE (BLEND_BLOCK + F32XN)

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

NKW_ALWAYS_INLINE void lerp_row(lanes l, size_t row, f32xN t, int first)
{
    f32xN a = f32xN_load_once(l.a.at + row * l.a.stride), b = f32xN_load_once(l.b.at + row * l.b.stride);
    f32xN_store(l.out.at + row * l.out.stride, f32xN_lerp(a, b, t, first));
}

NKW_ALWAYS_INLINE void lerp_rows(lanes l, size_t row, f32xN t, int first)
{
    lerp_row(l, row, t, first);
    lerp_row(l, row + 1, t, first);
    lerp_row(l, row + 2, t, first);
}

/* The sums and their lengths; or, where `lengths`, a constant, is 0, the sums as large as rotations are. */
NKW_ALWAYS_INLINE void sum_lanes(lanes l, f32xN_weights at, int lengths)
{
    f32xN_quat a = f32xN_quat_load(l.a.at + 3 * l.a.stride, l.a.stride),
               b = f32xN_quat_load(l.b.at + 3 * l.b.stride, l.b.stride), v = f32xN_nlerp_sum(a, b, at);
    f32xN_quat_store(l.sum, l.sums, lengths ? v : f32xN_quat_scale(v, f32xN_splat(1.0f / NKW_NLERP_SCALE)));
    if (lengths)
        f32xN_store(l.length, f32xN_sqrt(f32xN_quat_dot(v, v)));
}

/* Most poses have one stride. A loop in which it is one variable holds fewer addresses. */
NKW_ALWAYS_INLINE int have_one_stride(blend_rows a, blend_rows b, blend_span out)
{
    return a.stride == out.stride && b.stride == out.stride;
}

NKW_ALWAYS_INLINE void sum_joints(lanes l, f32xN t, int first, int n)
{
    const f32xN_weights at = f32xN_weights_of(t);
    for (int i = 0; i < n; i += F32XN, l = lanes_after(l, F32XN)) {
        lerp_rows(l, 0, t, first);
        sum_lanes(l, at, 0);
        lerp_rows(l, 7, t, first);
    }
}

NKW_ALWAYS_INLINE void sum_block(blend_rows a, blend_rows b, float t, blend_span out, int n)
{
    const lanes l = {a, b, out, out.at + 3 * out.stride, out.at, out.stride};
    if (t < 0.5f)
        sum_joints(l, f32xN_splat(t), 1, n);
    else
        sum_joints(l, f32xN_splat(t), 0, n);
}

/* The lerp by a t inside 0..1, rotations as sums. out may be a. */
NKW_LOOP(nkwi_blend_sum)(blend_rows a, blend_rows b, float t, blend_span out, int n)
{
    const blend_rows from = {a.at, out.stride}, to = {b.at, out.stride};
    if (have_one_stride(a, b, out))
        sum_block(from, to, t, out, n);
    else
        sum_block(a, b, t, out, n);
}

/* Identities in the padding from joint `used` on, whose lengths are 1. */
NKW_ALWAYS_INLINE void end_sums(lanes l, int used)
{
    const f32xN zero = f32xN_splat(0.0f), one = f32xN_splat(1.0f);
    f32xN_quat identity = {zero, zero, zero, one};
    f32xN_quat_store(l.sum + used, l.sums, identity);
    f32xN_store(l.length + used, one);
}

/* Whether two of the next `left` rotations may be equal. */
NKW_ALWAYS_INLINE int may_be_equal(lanes l, int left)
{
    const f32xN a = f32xN_load_once(l.a.at + 6 * l.a.stride), b = f32xN_load_once(l.b.at + 6 * l.b.stride);
    const uint32_t same = f32xN_same_size(a, b);
    return same != 0 && (left >= F32XN || (same & ((UINT32_C(1) << left) - 1)) != 0);
}

/* The sums of a register of joints by the lanes, which is seldom: by one t, or by one of each. */
NKW_NOINLINE LANE_FLAT static void sums_by_lanes(lanes l, const float *t, int each)
{
    const nkw_quat_view a = rotations_of(l.a), b = rotations_of(l.b);
    const nkw_quat_span sum = block_rows_to(l.sum, l.sums);
#pragma omp simd
    for (size_t i = 0; i < F32XN; i++) {
        lane_nlerp v = lane_quat_nlerp(at_quat(a, i), at_quat(b, i), t[each ? i : 0], 0);
        put_quat(sum, i, v.v);
        l.length[i] = nkw_sqrt(v.n2);
    }
}

/* The same of layers. */
NKW_ALWAYS_INLINE void mixes_by_lanes(lanes l, const float *t, const float *open, int lengths)
{
    const nkw_quat_view a = rotations_of(l.a), b = rotations_of(l.b);
    const nkw_quat_span sum = block_rows_to(l.sum, l.sums);
#pragma omp simd
    for (size_t i = 0; i < F32XN; i++) {
        lane_nlerp v = lane_quat_mix(at_quat(a, i), at_quat(b, i), t[i], open[i] != 0.0f);
        put_quat(sum, i, lengths ? v.v : lane_mix_sum(v));
        l.length[i] = nkw_sqrt(v.n2);
    }
}

NKW_ALWAYS_INLINE void lerps_by_lanes(lanes l, size_t row, const float *t)
{
    const nkw_vec3_view a = vectors_of(l.a, row), b = vectors_of(l.b, row);
    const nkw_vec3_span out = vector_span(l.out, row);
#pragma omp simd
    for (size_t i = 0; i < F32XN; i++)
        put_vec3(out, i, nkw_vec3_lerp(at_vec3(a, i), at_vec3(b, i), t[i]));
}

/* Divides the next sums by their lengths. Sets bits 30 or 31 of *far where one is not in 1 .. 2^128. */
NKW_ALWAYS_INLINE void divide_lanes(lanes l, u32xN *far)
{
    const f32xN n = f32xN_load_once(l.length);
    f32xN_quat_store(l.out.at + 3 * l.out.stride, l.out.stride, f32xN_quat_over(f32xN_quat_load(l.sum, l.sums), n));
    *far |= u32xN_from_f32xN(n) - (UINT32_C(127) << 23);
}

/*
 * All sums come before all divisions, so that no register waits for the root of the one before. Returns whether a
 * length was far from that of rotations.
 */
NKW_ALWAYS_INLINE int nlerp_joints(lanes l, float t, int first, int used)
{
    const f32xN all = f32xN_splat(t);
    const f32xN_weights at = f32xN_weights_of(all);
    u32xN far = u32xN_from_f32xN(f32xN_splat(0.0f));
    lanes from = l;
    for (int i = 0; i < used; i += F32XN, l = lanes_after(l, F32XN)) {
        if (may_be_equal(l, used - i))
            sums_by_lanes(l, &t, 0);
        else
            sum_lanes(l, at, 1);
        lerp_rows(l, 0, all, first);
    }
    l = from;
    end_sums(l, used);
    for (int i = 0; i < used; i += F32XN, l = lanes_after(l, F32XN)) {
        divide_lanes(l, &far);
        lerp_rows(l, 7, all, first);
    }
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
    if (t < 0.5f ? nlerp_joints(l, t, 1, used) : nlerp_joints(l, t, 0, used))
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

/* The same of whole poses: two strides fewer to pass and to compare are 2 % of a blend of 67 joints. */
NKW_LOOP(nkwi_blend_poses)(const float *a, const float *b, size_t stride, float t, int used, float *out)
{
    const blend_rows from = {a, stride}, to = {b, stride};
    const blend_span span = {out, stride};
    nlerp_block(from, to, t, used, span);
}

/* The weight of each joint; in the padding that of the last one, which needs no separate case. */
NKW_LOOP(nkwi_blend_weigh)(float weight, const float *mask, int used, float *out, int n)
{
#pragma omp simd
    for (int i = 0; i < n; i++)
        out[i] = weight * lane_mask(mask[i]);
    for (int i = used; i < n; i++)
        out[i] = out[used - 1];
}

/* How a register of joints is computed by a t of each: on registers from either end, by the lanes, or copied. */
typedef enum how { FROM_A, FROM_B, BY_LANES, ALL_A, ALL_B } how;

NKW_ALWAYS_INLINE how how_at(f32xN t)
{
    const uint32_t all = (UINT32_C(1) << F32XN) - 1;
    const f32xN zero = f32xN_splat(0.0f), half = f32xN_splat(0.5f), one = f32xN_splat(1.0f);
    const uint32_t near = i32xN_bits(f32xN_less(t, half));
    if (i32xN_bits(f32xN_less(zero, t) & f32xN_less(t, one)) == all)
        return near == all ? FROM_A : near == 0 ? FROM_B : BY_LANES;
    if (i32xN_bits(f32xN_equal(t, zero)) == all)
        return ALL_A;
    return i32xN_bits(f32xN_equal(t, one)) == all ? ALL_B : BY_LANES;
}

NKW_ALWAYS_INLINE void copy_row(lanes l, size_t row, blend_rows from)
{
    f32xN_store(l.out.at + row * l.out.stride, f32xN_load(from.at + row * from.stride));
}

NKW_ALWAYS_INLINE void lerps_each(lanes l, size_t row, const float *t, how kind)
{
    if (kind == FROM_A)
        lerp_rows(l, row, f32xN_load(t), 1);
    else if (kind == FROM_B)
        lerp_rows(l, row, f32xN_load(t), 0);
    else if (kind == BY_LANES)
        lerps_by_lanes(l, row, t);
    else
        for (size_t i = row; i < row + 3; i++)
            copy_row(l, i, kind == ALL_A ? l.a : l.b);
}

NKW_ALWAYS_INLINE void sums_each(lanes l, const float *t, const float *open, how kind, int left, int lengths)
{
    const int is_special = kind > FROM_B || may_be_equal(l, left);
    if (is_special && open)
        mixes_by_lanes(l, t, open, lengths);
    else if (is_special)
        sums_by_lanes(l, t, 1);
    else
        sum_lanes(l, f32xN_weights_of(f32xN_load(t)), lengths);
}

NKW_ALWAYS_INLINE void each_block(blend_rows a, blend_rows b, const float *t, const float *open, int used,
                                  blend_span out)
{
    float sum[5 * SUM_STRIDE];
    const lanes begin = {a, b, out, sum, sum + 4 * SUM_STRIDE, SUM_STRIDE};
    u32xN far = u32xN_from_f32xN(f32xN_splat(0.0f));
    how kinds[BLEND_BLOCK / F32XN];
    lanes l = begin;
    for (int i = 0; i < used; i += F32XN, l = lanes_after(l, F32XN)) {
        const how kind = kinds[i / F32XN] = how_at(f32xN_load(t + i));
        sums_each(l, t + i, open ? open + i : NULL, kind, used - i, 1);
        lerps_each(l, 0, t + i, kind);
    }
    l = begin;
    end_sums(l, used);
    for (int i = 0; i < used; i += F32XN, l = lanes_after(l, F32XN)) {
        divide_lanes(l, &far);
        lerps_each(l, 7, t + i, kinds[i / F32XN]);
    }
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
 * The same, rotations as sums. out may be a. mixed becomes 1 where more than one pose has a part, 0 where one alone has
 * all.
 */
NKW_LOOP(nkwi_blend_mix)(blend_rows a, blend_rows b, const float *t, float *mixed, int used, blend_span out)
{
    float length[SUM_STRIDE];
    lanes l = {a, b, out, out.at + 3 * out.stride, length, out.stride};
    for (int i = 0; i < used; i += F32XN, l = lanes_after(l, F32XN)) {
        const how kind = how_at(f32xN_load(t + i));
        sums_each(l, t + i, mixed + i, kind, used - i, 0);
        lerps_each(l, 0, t + i, kind);
        lerps_each(l, 7, t + i, kind);
    }
#pragma omp simd
    for (int i = 0; i < used; i++)
        mixed[i] = t[i] == 0.0f ? mixed[i] : t[i] == 1.0f ? 0.0f : 1.0f;
}

/* The part of a pose in the sum of it and those before, t; and the total. */
NKW_LOOP(nkwi_blend_share)(const float *weight, double *total, float *t, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        float share = lane_share(weight[i], (float)total[i]);
        total[i] = total[i] + (double)weight[i];
        t[i] = share;
    }
}

/* What the rest pose has to make up for; *any becomes 1 where it is not 0. */
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

NKW_LOOP(nkwi_additive_build)(nkw_trs_view a, nkw_trs_view ref, int parent, nkw_trs_span out, size_t n)
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

/* The parts of the turns delta come before they are added, as nlerps. */
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

/* n is at most BLEND_BLOCK. */
NKW_LOOP(nkwi_additive_apply)
(nkw_trs_view base, nkw_trs_view delta, const float *weight, int parent, nkw_trs_span out, size_t n)
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
