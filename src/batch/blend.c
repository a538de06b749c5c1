/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/scalar.h>

#include "batch/chords.h"
#include "batch/element.h"
#include "batch/table.h"
#include "lane/blend.h"

static inline void settle(nkw_quat_view v, nkw_quat_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_quat(out, i, lane_quat_settle(at_quat(v, i)));
}

KERNEL(blend_settle)(nkw_quat_view v, const float *mixed, int used, nkw_quat_span out, int n)
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

/* Lanes that are worked out together: the widest vector, and 8 at least. Poses are padded to whole ones. */
#if defined(__AVX512F__)
#define LANES 16
#else
#define LANES 8
#endif

/*
 * Lanes of two poses, and where they are blended to. chord: for x, y, z, w and 1 - |v|^2 of their chords v, BLEND_BLOCK
 * floats apart.
 */
typedef struct lanes {
    blend_rows a, b;
    blend_span out;
    float *chord;
} lanes;

static inline lanes lanes_after(lanes l)
{
    l.a.at += LANES;
    l.b.at += LANES;
    l.out.at += LANES;
    l.chord += LANES;
    return l;
}

/* A joint's own rotation, the identity in the padding: subnormal numbers there would take their time. */
#define at_joint(v, i) lane_quat_or_identity(0u - (uint32_t)((i) < used), at_quat(v, i))

/* LANES chords, for t inside 0..1: the ends are others' to copy. `first` says that it is nearer to a. */
INLINE void chord_lanes(blend_rows a, blend_rows b, float t, int first, int used, nkw_quat_span out)
{
    nkw_quat_view from = rotations_of(a), to = rotations_of(b);
#pragma omp simd
    KEEP_LOOP
    for (int i = 0; i < LANES; i++)
        put_quat(out, (size_t)i, lane_quat_chord_near(at_joint(from, i), at_joint(to, i), t, first));
}

/* Three arrays from `row` on. */
INLINE void lerp_lanes(blend_rows a, blend_rows b, size_t row, float t, int first, blend_span out)
{
    nkw_vec3_view from = vectors_of(a, row), to = vectors_of(b, row);
    nkw_vec3_span v = vector_span(out, row);
#pragma omp simd
    KEEP_LOOP
    for (size_t i = 0; i < LANES; i++)
        put_vec3(v, i, lane_vec3_lerp_near(at_vec3(from, i), at_vec3(to, i), t, first));
}

INLINE void chord_near(lanes l, float t, int first, int n)
{
    for (; n > 0; n -= LANES, l = lanes_after(l)) {
        lerp_lanes(l.a, l.b, 0, t, first, l.out);
        chord_lanes(l.a, l.b, t, first, LANES, rotation_span(l.out));
        lerp_lanes(l.a, l.b, 7, t, first, l.out);
    }
}

/* The lerp, rotations as chords, for t inside 0..1. out may be a. */
KERNEL(blend_chord)(blend_rows a, blend_rows b, float t, blend_span out, int n)
{
    const lanes l = {a, b, out, out.at};
    if (t < 0.5f)
        chord_near(l, t, 1, n);
    else
        chord_near(l, t, 0, n);
}

/* Translations beside the chords. */
INLINE void begin_lanes(lanes l, float t, int first, int used)
{
    const nkw_quat_span chord = block_rows_to(l.chord, BLEND_BLOCK);
    chord_lanes(l.a, l.b, t, first, used, chord);
    lerp_lanes(l.a, l.b, 0, t, first, l.out);
}

/* Scales beside the roots. */
INLINE void end_lanes(lanes l, float t, int first)
{
    const nkw_quat_view chord = block_rows(l.chord, BLEND_BLOCK);
    nkw_quat_span unit = rotation_span(l.out);
    float *defect = l.chord + 4 * BLEND_BLOCK;
#pragma omp simd
    KEEP_LOOP
    for (size_t i = 0; i < LANES; i++) {
        nkw_quat q = at_quat(chord, i);
        defect[i] = lane_quat_defect(q);
        put_quat(unit, i, lane_quat_settle_inside(q, defect[i]));
    }
    lerp_lanes(l.a, l.b, 7, t, first, l.out);
}

/* All chords come before all roots, so that no lane waits for the one before. */
INLINE void nlerp_near(lanes l, float t, int first, int used)
{
    lanes from = l;
    int rest = used;
    for (; rest >= LANES; rest -= LANES, l = lanes_after(l))
        begin_lanes(l, t, first, LANES);
    if (rest > 0)
        begin_lanes(l, t, first, rest);
    for (l = from, rest = used; rest > 0; rest -= LANES, l = lanes_after(l))
        end_lanes(l, t, first);
}

/* Eight lanes behind those that were worked out get the identity: rows 0 0 0, 0 0 0 1, 1 1 1. */
static inline void fill_padding(blend_span out, int used, int n)
{
    int from = (used + 7) / 8 * 8;
    for (size_t c = 0; from < n && c < 10; c++)
        for (size_t i = 0; i < 8; i++)
            out.at[c * out.stride + (size_t)from + i] = c < 6 ? 0.0f : 1.0f;
}

/* nkw_pose_blend for t inside 0..1. If a chord was not inside after all, all are brought to length 1 again. */
KERNEL(blend_nlerp)(blend_rows a, blend_rows b, float t, int used, blend_span out, int n)
{
    float c[5][BLEND_BLOCK];
    const lanes l = {a, b, out, c[0]};
    size_t whole = ((size_t)used + LANES - 1) / LANES * LANES;
    int outside = 0;
    if (t < 0.5f)
        nlerp_near(l, t, 1, used);
    else
        nlerp_near(l, t, 0, used);
    for (size_t i = 0; i < whole; i++)
        outside |= !(lane_abs(c[4][i]) < 1.0f);
    if (outside) {
        nkw_quat_view v = {c[0], c[1], c[2], c[3]};
        settle(v, rotation_span(out), whole);
    }
    fill_padding(out, used, n);
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

static inline void lerps_each(nkw_vec3_view a, nkw_vec3_view b, const float *t, nkw_vec3_span out, int n)
{
#pragma omp simd
    for (int i = 0; i < n; i++)
        put_vec3(out, (size_t)i, nkw_vec3_lerp(at_vec3(a, i), at_vec3(b, i), t[i]));
}

/* nkw_pose_blend by a t for each joint, any; t is 0 in the padding. n is at most BLEND_BLOCK. */
KERNEL(blend_each)(blend_rows a, blend_rows b, const float *t, int used, blend_span out, int n)
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
KERNEL(blend_mix)(blend_rows to, const float *t, blend_span sum, int n)
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
KERNEL(blend_share)(const float *weight, double *total, float *mixed, float *t, size_t n)
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
KERNEL(blend_missing)(const double *total, float threshold, int used, float *out, int n)
{
#pragma omp simd
    for (int i = 0; i < n; i++) {
        float w = lane_missing(total[i], threshold);
        out[i] = i < used ? w : 0.0f;
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
KERNEL(additive_apply)
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
