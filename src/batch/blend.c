/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/scalar.h>

#include "batch/chords.h"
#include "batch/element.h"
#include "batch/blend.h"
#include "batch/block.h"
#include "lane/blend.h"
#include "lane/fours.h"

NKW_LOOPS_BLEND(NKW_DECLARE_LOOP)

static inline void settle(nkw_quat_view v, nkw_quat_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_quat(out, i, lane_chord_normalize(at_quat(v, i)));
}

NKW_LOOP(nkwi_blend_settle)(nkw_quat_view v, const float *mixed, int used, nkw_quat_span out, int n)
{
    settle_where(mixed, v, used, out, n);
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
 * Two poses by one t inside 0..1, a register of lanes at a time: the ends are others' to copy. way: t, or t - 1 where b
 * is nearer; `first` says at compile time that a is.
 */

/* Rotations, one in each lane. */
typedef struct wide_quat {
    lane_wide x, y, z, w;
} wide_quat;

INLINE wide_quat load_quats(const float *x, size_t stride)
{
    wide_quat r = {lane_wide_load_once(x), lane_wide_load_once(x + stride), lane_wide_load_once(x + 2 * stride),
                   lane_wide_load_once(x + 3 * stride)};
    return r;
}

INLINE void store_quats(float *x, size_t stride, wide_quat q)
{
    lane_wide_store(x, q.x);
    lane_wide_store(x + stride, q.y);
    lane_wide_store(x + 2 * stride, q.z);
    lane_wide_store(x + 3 * stride, q.w);
}

/* As lane_lerp_from. */
INLINE lane_wide lerp_wide(lane_wide a, lane_wide b, lane_wide way, int first)
{
    return lane_wide_add(first ? a : b, lane_wide_mul(way, lane_wide_sub(b, a)));
}

/* As lane_quat_chord. */
INLINE wide_quat chord_wide(wide_quat a, wide_quat b, lane_wide way, int first)
{
    lane_wide xy = lane_wide_add(lane_wide_mul(a.x, b.x), lane_wide_mul(a.y, b.y));
    lane_wide zw = lane_wide_add(lane_wide_mul(a.z, b.z), lane_wide_mul(a.w, b.w));
    lane_wide dot = lane_wide_add(xy, zw);
    wide_quat r = {
        lerp_wide(a.x, lane_wide_turn(dot, b.x), way, first),
        lerp_wide(a.y, lane_wide_turn(dot, b.y), way, first),
        lerp_wide(a.z, lane_wide_turn(dot, b.z), way, first),
        lerp_wide(a.w, lane_wide_turn(dot, b.w), way, first),
    };
    return r;
}

/* 1/4 - x^2 */
INLINE lane_wide share_wide(lane_wide x)
{
    return lane_wide_sub(lane_wide_all(0.25f), lane_wide_mul(x, x));
}

INLINE lane_wide stretch_wide(lane_wide x, lane_wide g)
{
    return lane_wide_add(x, lane_wide_mul(x, g));
}

/* As lane_quat_settle_inside. `seen` is marked where not 0 < |v|^2 <= 2. */
INLINE wide_quat settle_wide(wide_quat v, lane_wide *seen)
{
    lane_wide xy = lane_wide_add(share_wide(v.x), share_wide(v.y));
    lane_wide m = lane_wide_add(xy, lane_wide_add(share_wide(v.z), share_wide(v.w)));
    lane_wide n2 = lane_wide_sub(lane_wide_all(1.0f), m);
    lane_wide g = lane_wide_div(m, lane_wide_add(lane_wide_sqrt(n2), n2));
    wide_quat r = {stretch_wide(v.x, g), stretch_wide(v.y, g), stretch_wide(v.z, g), stretch_wide(v.w, g)};
    *seen = lane_wide_mark(*seen, n2);
    return r;
}

/* Floats from one component of the chords of a block to the next: a register more than it has lanes. */
#define CHORD_STRIDE (BLEND_BLOCK + LANE_WIDE)

/* Lanes of two poses, where they are blended to, and their chords, `chords` floats from component to component. */
typedef struct lanes {
    blend_rows a, b;
    blend_span out;
    float *chord;
    size_t chords;
} lanes;

INLINE lanes lanes_after(lanes l)
{
    l.a.at += LANE_WIDE;
    l.b.at += LANE_WIDE;
    l.out.at += LANE_WIDE;
    l.chord += LANE_WIDE;
    return l;
}

INLINE void lerp_row(lanes l, size_t row, lane_wide way, int first)
{
    lane_wide a = lane_wide_load_once(l.a.at + row * l.a.stride), b = lane_wide_load_once(l.b.at + row * l.b.stride);
    lane_wide_store(l.out.at + row * l.out.stride, lerp_wide(a, b, way, first));
}

INLINE void lerp_rows(lanes l, size_t row, lane_wide way, int first)
{
    lerp_row(l, row, way, first);
    lerp_row(l, row + 1, way, first);
    lerp_row(l, row + 2, way, first);
}

INLINE void chord_lanes(lanes l, lane_wide way, int first)
{
    wide_quat a = load_quats(l.a.at + 3 * l.a.stride, l.a.stride), b = load_quats(l.b.at + 3 * l.b.stride, l.b.stride);
    store_quats(l.chord, l.chords, chord_wide(a, b, way, first));
}

INLINE void chord_near(lanes l, lane_wide way, int first, int n)
{
    for (int i = 0; i < n; i += LANE_WIDE, l = lanes_after(l)) {
        lerp_rows(l, 0, way, first);
        chord_lanes(l, way, first);
        lerp_rows(l, 7, way, first);
    }
}

INLINE void chord_block(blend_rows a, blend_rows b, float t, blend_span out, int n)
{
    const lanes l = {a, b, out, out.at + 3 * out.stride, out.stride};
    if (t < 0.5f)
        chord_near(l, lane_wide_all(t), 1, n);
    else
        chord_near(l, lane_wide_all(t - 1.0f), 0, n);
}

/* As most have: then there are fewer addresses to hold, if the compiler is told. */
INLINE int have_one_stride(blend_rows a, blend_rows b, blend_span out)
{
    return a.stride == out.stride && b.stride == out.stride;
}

/* The lerp, rotations as chords. out may be a. */
NKW_LOOP(nkwi_blend_chord)(blend_rows a, blend_rows b, float t, blend_span out, int n)
{
    const blend_rows x = {a.at, out.stride}, y = {b.at, out.stride};
    if (have_one_stride(a, b, out))
        chord_block(x, y, t, out, n);
    else
        chord_block(a, b, t, out, n);
}

/* Chords that move nothing, in the padding from lane `used` on. */
INLINE void end_chords(float *chord, int used)
{
    wide_quat identity = {lane_wide_all(0.0f), lane_wide_all(0.0f), lane_wide_all(0.0f), lane_wide_all(1.0f)};
    store_quats(chord + used, CHORD_STRIDE, identity);
}

/*
 * Translations beside the chords, scales beside the roots; all chords come before all roots, so that no lane waits for
 * the one before.
 */
INLINE int nlerp_near(lanes l, lane_wide way, int first, int used)
{
    lane_wide seen = lane_wide_all(0.0f);
    lanes from = l;
    for (int i = 0; i < used; i += LANE_WIDE, l = lanes_after(l)) {
        chord_lanes(l, way, first);
        lerp_rows(l, 0, way, first);
    }
    l = from;
    end_chords(l.chord, used);
    for (int i = 0; i < used; i += LANE_WIDE, l = lanes_after(l)) {
        wide_quat v = load_quats(l.chord, l.chords);
        store_quats(l.out.at + 3 * l.out.stride, l.out.stride, settle_wide(v, &seen));
        lerp_rows(l, 7, way, first);
    }
    return lane_wide_is_marked(seen);
}

INLINE int nlerp(lanes l, float t, int used)
{
    return t < 0.5f ? nlerp_near(l, lane_wide_all(t), 1, used) : nlerp_near(l, lane_wide_all(t - 1.0f), 0, used);
}

/* nkw_pose_blend of a block. If a chord was not inside after all, all are brought to length 1 again. */
INLINE void nlerp_block(blend_rows a, blend_rows b, float t, int used, blend_span out)
{
    float c[4 * CHORD_STRIDE];
    const lanes l = {a, b, out, c, CHORD_STRIDE};
    if (nlerp(l, t, used))
        settle(block_rows(c, CHORD_STRIDE), rotation_span(out), (size_t)used);
}

NKW_LOOP(nkwi_blend_nlerp)(blend_rows a, blend_rows b, float t, int used, blend_span out)
{
    const blend_rows x = {a.at, out.stride}, y = {b.at, out.stride};
    if (have_one_stride(a, b, out))
        nlerp_block(x, y, t, used, out);
    else
        nlerp_block(a, b, t, used, out);
}

/* The same of poses themselves: a blend of 67 joints is 2 % faster for what is not passed and asked. */
NKW_LOOP(nkwi_blend_poses)(const float *a, const float *b, size_t stride, float t, int used, float *out)
{
    const blend_rows x = {a, stride}, y = {b, stride};
    const blend_span to = {out, stride};
    nlerp_block(x, y, t, used, to);
}

/* A joint's own rotation, the identity in the padding: subnormal numbers there would take their time. */
#define at_joint(v, i) lane_quat_or_identity(0u - (uint32_t)((i) < used), at_quat(v, i))

/* The joints' own weights; none in the padding, whatever stands there. */
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
    settle_chords(&c, used, rotation_span(out), n);
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
INLINE void add_turns(nkw_quat_view base, nkw_quat_view delta, const float *weight, int parent, nkw_quat_span out,
                      size_t n)
{
    chords c;
    float x[BLEND_BLOCK], y[BLEND_BLOCK], z[BLEND_BLOCK], w[BLEND_BLOCK];
    const nkw_quat_span parts = {x, y, z, w};
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        nkw_quat d = at_quat(delta, i);
        put_chord(c, i, lane_quat_chord(lane_quat_none(d), d, weight[i]));
    }
    settle_chords(&c, (int)n, parts, (int)n);
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
