/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "batch/element.h"
#include "batch/table.h"
#include "lane/blend.h"

KERNEL(quat_mix)(nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_quat(out, i, lane_quat_mix(at_quat(a, i), at_quat(b, i), t[i]));
}

/* For t inside 0..1: the ends are others' to copy. */
INLINE void chords(nkw_quat_view a, nkw_quat_view b, float t, int first, nkw_quat_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_quat(out, i, lane_quat_chord_near(at_quat(a, i), at_quat(b, i), t, first).v);
}

/* Rotations are worked out in whole vectors, of 8 lanes at least. */
#if defined(__AVX512F__)
#define VECTOR 16
#else
#define VECTOR 8
#endif

/* The last vector, from lane `from` on, the identity in the padding: subnormal numbers there would take their time. */
INLINE void last_chords(nkw_quat_view a, nkw_quat_view b, float t, int first, int used, int from, nkw_quat_span out)
{
#pragma omp simd
    for (int i = from; i < from + VECTOR; i++) {
        nkw_quat p = lane_quat_select(i < used, at_quat(a, (size_t)i), nkw_quat_identity());
        nkw_quat q = lane_quat_select(i < used, at_quat(b, (size_t)i), nkw_quat_identity());
        put_quat(out, (size_t)i, lane_quat_chord_near(p, q, t, first).v);
    }
}

/* out is not v: if one of the first `used` chords was not inside after all, all are done again. */
static inline void settle(nkw_quat_view v, int used, nkw_quat_span out, int n)
{
    int outside = 0;
#pragma omp simd reduction(| : outside)
    for (int i = 0; i < n; i++) {
        nkw_quat q = at_quat(v, (size_t)i);
        float m = lane_quat_defect(q);
        outside |= !(lane_abs(m) < 1.0f) & (i < used);
        put_quat(out, (size_t)i, lane_quat_settle_inside(q, m));
    }
    if (outside) {
#pragma omp simd
        for (int i = 0; i < n; i++)
            put_quat(out, (size_t)i, lane_quat_settle(at_quat(v, (size_t)i)));
    }
}

KERNEL(quat_settle)(nkw_quat_view v, int used, nkw_quat_span out, int n)
{
    settle(v, used, out, n);
}

/* Three arrays of n; end to end in all three blocks, as one. */
INLINE void lerp_arrays(blend_rows a, blend_rows b, size_t row, float t, int first, blend_span out, size_t n)
{
    int whole = n == a.stride && n == b.stride && n == out.stride;
    size_t length = whole ? 3 * n : n;
    for (size_t c = row; c < row + (whole ? 1 : 3); c++) {
        const float *x = a.at + c * a.stride, *y = b.at + c * b.stride;
        float *z = out.at + c * out.stride;
#pragma omp simd
        for (size_t i = 0; i < length; i++)
            z[i] = lane_lerp_near(x[i], y[i], t, first);
    }
}

static inline nkw_quat_view rotations_of(blend_rows rows)
{
    const float *x = rows.at + 3 * rows.stride;
    nkw_quat_view v = {x, x + rows.stride, x + 2 * rows.stride, x + 3 * rows.stride};
    return v;
}

static inline nkw_quat_span rotation_span(blend_span rows)
{
    float *x = rows.at + 3 * rows.stride;
    nkw_quat_span s = {x, x + rows.stride, x + 2 * rows.stride, x + 3 * rows.stride};
    return s;
}

INLINE void chord_along(blend_rows a, blend_rows b, float t, int first, blend_span out, int n)
{
    lerp_arrays(a, b, 0, t, first, out, (size_t)n);
    chords(rotations_of(a), rotations_of(b), t, first, rotation_span(out), (size_t)n);
    lerp_arrays(a, b, 7, t, first, out, (size_t)n);
}

/* The lerp, rotations as chords, for t inside 0..1. out may be a. */
KERNEL(blend_chord)(blend_rows a, blend_rows b, float t, blend_span out, int n)
{
    if (t < 0.5f)
        chord_along(a, b, t, 1, out, n);
    else
        chord_along(a, b, t, 0, out, n);
}

/* Eight lanes after the whole vectors get the identity. */
static inline void fill_padding(nkw_quat_span out, int used, int n)
{
    size_t from = (size_t)((used + 7) / 8 * 8);
    for (size_t i = from; (int)from < n && i < from + 8; i++)
        put_quat(out, i, nkw_quat_identity());
}

INLINE void nlerp_along(blend_rows a, blend_rows b, float t, int first, int used, blend_span out, int n)
{
    float v[4][BLEND_BLOCK];
    nkw_quat_span chord = {v[0], v[1], v[2], v[3]};
    nkw_quat_view chord_view = {v[0], v[1], v[2], v[3]};
    int whole = used / VECTOR * VECTOR, turned = (used + VECTOR - 1) / VECTOR * VECTOR;
    chords(rotations_of(a), rotations_of(b), t, first, chord, (size_t)whole);
    if (whole < turned)
        last_chords(rotations_of(a), rotations_of(b), t, first, used, whole, chord);
    lerp_arrays(a, b, 0, t, first, out, (size_t)n);
    settle(chord_view, used, rotation_span(out), turned);
    fill_padding(rotation_span(out), used, n);
    lerp_arrays(a, b, 7, t, first, out, (size_t)n);
}

/* nkw_pose_blend for t inside 0..1. All chords come before all roots, so that no lane waits for the one before. */
KERNEL(blend_nlerp)(blend_rows a, blend_rows b, float t, int used, blend_span out, int n)
{
    if (t < 0.5f)
        nlerp_along(a, b, t, 1, used, out, n);
    else
        nlerp_along(a, b, t, 0, used, out, n);
}

/* The joints' own weights; none in the padding, whatever stands there. */
KERNEL(blend_weigh)(float weight, const float *mask, int used, float *out, int n)
{
#pragma omp simd
    for (int i = 0; i < n; i++) {
        float w = weight * lane_mask(mask[i]);
        out[i] = i < used ? w : 0.0f;
    }
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

static inline void lerps_each(nkw_vec3_view a, nkw_vec3_view b, const float *t, nkw_vec3_span out, int n)
{
#pragma omp simd
    for (int i = 0; i < n; i++)
        put_vec3(out, (size_t)i, nkw_vec3_lerp(at_vec3(a, i), at_vec3(b, i), t[i]));
}

/* A joint's own rotation, the identity in the padding: subnormal numbers there would take their time. */
#define at_joint(v, i) lane_quat_select((i) < used, at_quat(v, i), nkw_quat_identity())

/* nkw_pose_blend by a t for each joint, any; t is 0 in the padding. */
KERNEL(blend_each)(blend_rows a, blend_rows b, const float *t, int used, blend_span out, int n)
{
    nkw_quat_view p = rotations_of(a), q = rotations_of(b);
    nkw_quat_span r = rotation_span(out);
    lerps_each(vectors_of(a, 0), vectors_of(b, 0), t, vector_span(out, 0), n);
#pragma omp simd
    for (int i = 0; i < n; i++)
        put_quat(r, (size_t)i, lane_quat_nlerp(at_joint(p, i), at_joint(q, i), t[i]));
    lerps_each(vectors_of(a, 7), vectors_of(b, 7), t, vector_span(out, 7), n);
}

/* mixed becomes 1 where more than one pose has a part, 0 where one alone has all. */
KERNEL(blend_share)(const float *weight, float *total, float *mixed, float *t, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        float share = lane_share(weight[i], total[i]);
        mixed[i] = share == 0.0f ? mixed[i] : share == 1.0f ? 0.0f : 1.0f;
        total[i] = total[i] + weight[i];
        t[i] = share;
    }
}

KERNEL(additive_build)(nkw_trs_view a, nkw_trs_view ref, int parent, nkw_trs_span out, size_t n)
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

KERNEL(additive_apply)
(nkw_trs_view base, nkw_trs_view delta, const float *weight, int parent, nkw_trs_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out.translation, i,
                 lane_vec3_add_delta(at_vec3(base.translation, i), at_vec3(delta.translation, i), weight[i]));
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_quat(out.rotation, i,
                 lane_quat_add_delta(at_quat(base.rotation, i), at_quat(delta.rotation, i), weight[i], parent));
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        nkw_vec3 d = at_vec3(delta.scale, i);
        float w = weight[i];
        nkw_vec3 part = {nkw_lerp(1.0f, d.x, w), nkw_lerp(1.0f, d.y, w), nkw_lerp(1.0f, d.z, w)};
        put_vec3(out.scale, i, nkw_vec3_mul(at_vec3(base.scale, i), part));
    }
}
