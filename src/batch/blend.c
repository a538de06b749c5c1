/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/scalar.h>

#include "batch/chords.h"
#include "batch/element.h"
#include "batch/blend.h"
#include "batch/block.h"
#include "lane/blend.h"
#include "pack/nlerp.h"
#include "sizes.h"

NKW_LOOPS_BLEND(NKW_DECLARE_LOOP)

static inline void normalize_chords(nkw_quat_view v, nkw_quat_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_quat(out, i, lane_chord_normalize(at_quat(v, i)));
}

NKW_LOOP(nkwi_blend_normalize)(nkw_quat_view v, const float *mixed, int used, nkw_quat_span out, int n)
{
    normalize_where(mixed, v, used, out, n);
}

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
 * Two poses by one t inside 0..1, a register of joints at a time; callers copy at t = 0 and 1. `first` and x are those of
 * pack/nlerp.h. The arrays of a pose, `stride` floats apart:
 *
 *     0 1 2     translation      lerp
 *     3 4 5 6   rotation         chord, then normalized
 *     7 8 9     scale            lerp
 */

/* Floats from one component of the chords of a block to the next: a register more than the block has joints. */
#define CHORD_STRIDE (BLEND_BLOCK + F32XN)

/* The next joints of two poses, of the result, and of their chords, whose components are `chords` floats apart. */
typedef struct lanes {
    blend_rows a, b;
    blend_span out;
    float *chord;
    size_t chords;
} lanes;

NKW_ALWAYS_INLINE lanes lanes_after(lanes l)
{
    l.a.at += F32XN;
    l.b.at += F32XN;
    l.out.at += F32XN;
    l.chord += F32XN;
    return l;
}

NKW_ALWAYS_INLINE void lerp_row(lanes l, size_t row, f32xN x, int first)
{
    f32xN a = f32xN_load_once(l.a.at + row * l.a.stride), b = f32xN_load_once(l.b.at + row * l.b.stride);
    f32xN_store(l.out.at + row * l.out.stride, f32xN_lerp(a, b, x, first));
}

NKW_ALWAYS_INLINE void lerp_rows(lanes l, size_t row, f32xN x, int first)
{
    lerp_row(l, row, x, first);
    lerp_row(l, row + 1, x, first);
    lerp_row(l, row + 2, x, first);
}

NKW_ALWAYS_INLINE void chord_lanes(lanes l, f32xN x, int first)
{
    f32xN_quat a = f32xN_quat_load(l.a.at + 3 * l.a.stride, l.a.stride),
               b = f32xN_quat_load(l.b.at + 3 * l.b.stride, l.b.stride);
    f32xN_quat_store(l.chord, l.chords, f32xN_chord(a, b, x, first));
}

NKW_ALWAYS_INLINE void chord_joints(lanes l, f32xN x, int first, int n)
{
    for (int i = 0; i < n; i += F32XN, l = lanes_after(l)) {
        lerp_rows(l, 0, x, first);
        chord_lanes(l, x, first);
        lerp_rows(l, 7, x, first);
    }
}

NKW_ALWAYS_INLINE void chord_block(blend_rows a, blend_rows b, float t, blend_span out, int n)
{
    const lanes l = {a, b, out, out.at + 3 * out.stride, out.stride};
    if (t < 0.5f)
        chord_joints(l, f32xN_splat(t), 1, n);
    else
        chord_joints(l, f32xN_splat(t - 1.0f), 0, n);
}

/* Most poses have one stride. A loop in which it is one variable holds fewer addresses. */
NKW_ALWAYS_INLINE int have_one_stride(blend_rows a, blend_rows b, blend_span out)
{
    return a.stride == out.stride && b.stride == out.stride;
}

/* The lerp, rotations as chords. out may be a. */
NKW_LOOP(nkwi_blend_chord)(blend_rows a, blend_rows b, float t, blend_span out, int n)
{
    const blend_rows from = {a.at, out.stride}, to = {b.at, out.stride};
    if (have_one_stride(a, b, out))
        chord_block(from, to, t, out, n);
    else
        chord_block(a, b, t, out, n);
}

/* Identities in the padding from joint `used` on, so that it is inside. */
NKW_ALWAYS_INLINE void end_chords(float *chord, int used)
{
    f32xN_quat identity = {f32xN_splat(0.0f), f32xN_splat(0.0f), f32xN_splat(0.0f), f32xN_splat(1.0f)};
    f32xN_quat_store(chord + used, CHORD_STRIDE, identity);
}

/*
 * All chords come before all roots, so that no register waits for the root of the one before. Returns whether a chord was
 * outside.
 */
NKW_ALWAYS_INLINE int nlerp_joints(lanes l, f32xN x, int first, int used)
{
    u32xN outside = u32xN_from_f32xN(f32xN_splat(0.0f));
    lanes from = l;
    for (int i = 0; i < used; i += F32XN, l = lanes_after(l)) {
        chord_lanes(l, x, first);
        lerp_rows(l, 0, x, first);
    }
    l = from;
    end_chords(l.chord, used);
    for (int i = 0; i < used; i += F32XN, l = lanes_after(l)) {
        f32xN_quat v = f32xN_quat_load(l.chord, l.chords);
        f32xN_quat_store(l.out.at + 3 * l.out.stride, l.out.stride, f32xN_chord_normalize(v, &outside));
        lerp_rows(l, 7, x, first);
    }
    return u32xN_any(outside) >> 30 != 0;
}

NKW_ALWAYS_INLINE int nlerp(lanes l, float t, int used)
{
    return t < 0.5f ? nlerp_joints(l, f32xN_splat(t), 1, used) : nlerp_joints(l, f32xN_splat(t - 1.0f), 0, used);
}

/* nkw_pose_blend of a block. If a chord was outside, all are normalized again, by the general formula. */
NKW_ALWAYS_INLINE void nlerp_block(blend_rows a, blend_rows b, float t, int used, blend_span out)
{
    float c[4 * CHORD_STRIDE];
    const lanes l = {a, b, out, c, CHORD_STRIDE};
    if (nlerp(l, t, used))
        normalize_chords(block_rows(c, CHORD_STRIDE), rotation_span(out), (size_t)used);
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

/* A joint's own rotation, the identity in the padding: subnormal numbers there would take their time. */
#define at_joint(v, i) lane_quat_or_identity(0u - (uint32_t)((i) < used), at_quat(v, i))

/* The weight of each joint; 0 in the padding, whatever it holds. */
NKW_LOOP(nkwi_blend_weigh)(float weight, const float *mask, int used, float *out, int n)
{
#pragma omp simd
    for (int i = 0; i < n; i++) {
        float w = weight * lane_mask(mask[i]);
        out[i] = i < used ? w : 0.0f;
    }
}

static inline void lerps_each(nkw_vec3_view a, nkw_vec3_view b, const float *t, nkw_vec3_span out, int n)
{
#pragma omp simd
    for (int i = 0; i < n; i++)
        put_vec3(out, (size_t)i, nkw_vec3_lerp(at_vec3(a, i), at_vec3(b, i), t[i]));
}

/* nkw_pose_blend by a t for each joint, any; t is 0 in the padding. n is at most BLEND_BLOCK. */
NKW_LOOP(nkwi_blend_each)(blend_rows a, blend_rows b, const float *t, int used, blend_span out, int n)
{
    nkw_quat_view p = rotations_of(a), q = rotations_of(b);
    chords c;
    lerps_each(vectors_of(a, 0), vectors_of(b, 0), t, vector_span(out, 0), n);
#pragma omp simd
    for (int i = 0; i < n; i++)
        put_chord(c, (size_t)i, lane_quat_chord(at_joint(p, i), at_joint(q, i), t[i]));
    normalize_blended(&c, used, rotation_span(out), n);
    lerps_each(vectors_of(a, 7), vectors_of(b, 7), t, vector_span(out, 7), n);
}

/* sum becomes its lerp to a pose by a t for each joint, rotations as chords. */
NKW_LOOP(nkwi_blend_mix)(blend_rows to, const float *t, blend_span sum, int n)
{
    const blend_rows from = {sum.at, sum.stride};
    nkw_quat_view p = rotations_of(from), q = rotations_of(to);
    nkw_quat_span r = rotation_span(sum);
    lerps_each(vectors_of(from, 0), vectors_of(to, 0), t, vector_span(sum, 0), n);
#pragma omp simd
    for (int i = 0; i < n; i++)
        put_quat(r, (size_t)i, lane_quat_mix(at_quat(p, (size_t)i), at_quat(q, (size_t)i), t[i]));
    lerps_each(vectors_of(from, 7), vectors_of(to, 7), t, vector_span(sum, 7), n);
}

/* mixed becomes 1 where more than one pose has a part, 0 where one alone has all. */
NKW_LOOP(nkwi_blend_share)(const float *weight, double *total, float *mixed, float *t, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        float share = lane_share(weight[i], (float)total[i]);
        mixed[i] = share == 0.0f ? mixed[i] : share == 1.0f ? 0.0f : 1.0f;
        total[i] = total[i] + (double)weight[i];
        t[i] = share;
    }
}

/* What the rest pose has to make up for. */
NKW_LOOP(nkwi_blend_missing)(const double *total, float threshold, int used, float *out, int n)
{
#pragma omp simd
    for (int i = 0; i < n; i++) {
        float w = lane_missing(total[i], threshold);
        out[i] = i < used ? w : 0.0f;
    }
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
    chords c;
    float x[BLEND_BLOCK], y[BLEND_BLOCK], z[BLEND_BLOCK], w[BLEND_BLOCK];
    const nkw_quat_span parts = {x, y, z, w};
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        nkw_quat d = at_quat(delta, i);
        put_chord(c, i, lane_quat_chord(lane_quat_none(d), d, weight[i]));
    }
    normalize_blended(&c, (int)n, parts, (int)n);
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
