/* SPDX-License-Identifier: MIT */
/* Between two keys of a clip's group, run by run. src/clip_layout.h has the layout of keys. */
#include "lane/strict.h"

#include "batch/element.h"
#include "batch/run.h"
#include "batch/table.h"
#include "lane/curve.h"
#include "lane/orient.h"

/* Components that stand `lanes` floats apart, from a lane on. */
static inline nkw_quat_view quats_from(const float *key, size_t lanes, size_t lane)
{
    const float *x = key + lane;
    nkw_quat_view view = {x, x + lanes, x + 2 * lanes, x + 3 * lanes};
    return view;
}

static inline nkw_quat_span quats_to(float *out, size_t stride, size_t to)
{
    float *x = out + to;
    nkw_quat_span span = {x, x + stride, x + 2 * stride, x + 3 * stride};
    return span;
}

/* The arcs from a key to the next: v, with the sign bit of "turned", and H's polynomials. */
static inline lane_slerp_arc arc_at(const float *arcs, size_t lanes, size_t i)
{
    float v = arcs[i];
    lane_slerp_arc arc = {lane_sign_bit(v),    lane_abs(v),         arcs[lanes + i],
                          arcs[2 * lanes + i], arcs[3 * lanes + i], arcs[4 * lanes + i]};
    return arc;
}

KERNEL(clip_arcs)(const float *a, const float *b, size_t lanes, float *arcs)
{
    nkw_quat_view from = quats_from(a, lanes, 0), to = quats_from(b, lanes, 0);
#pragma omp simd
    for (size_t i = 0; i < lanes; i++) {
        lane_slerp_arc arc = lane_slerp_arc_between(at_quat(from, i), at_quat(to, i));
        arcs[i] = lane_flip(arc.v, arc.turned);
        arcs[lanes + i] = arc.h0;
        arcs[2 * lanes + i] = arc.h1;
        arcs[3 * lanes + i] = arc.h2;
        arcs[4 * lanes + i] = arc.h3;
    }
}

KERNEL(clip_lerp)(const float *a, const float *b, float t, const nkw_run *runs, size_t run_count, float *out)
{
    for (size_t r = 0; r < run_count; r++) {
        const float *from = a + runs[r].lane, *to = b + runs[r].lane;
        float *o = out + runs[r].to;
        size_t n = runs[r].count;
#pragma omp simd
        for (size_t i = 0; i < n; i++)
            o[i] = nkw_lerp(from[i], to[i], t);
    }
}

static inline void slerp_runs(const float *a, const float *b, size_t lanes, lane_slerp_pace pace, const nkw_run *runs,
                              size_t run_count, float *out, size_t stride)
{
    for (size_t r = 0; r < run_count; r++) {
        nkw_quat_view from = quats_from(a, lanes, runs[r].lane), to = quats_from(b, lanes, runs[r].lane);
        nkw_quat_span o = quats_to(out, stride, runs[r].to);
        const float *arcs = a + 4 * lanes + runs[r].lane;
        size_t n = runs[r].count;
#pragma omp simd
        for (size_t i = 0; i < n; i++)
            put_quat(o, i, lane_quat_slerp_on(at_quat(from, i), at_quat(to, i), arc_at(arcs, lanes, i), pace));
    }
}

KERNEL(clip_slerp)
(const float *a, const float *b, size_t lanes, float t, const nkw_run *runs, size_t run_count, float *out,
 size_t stride)
{
    lane_slerp_pace pace = lane_slerp_pace_at(t);
    if (pace.first)
        slerp_runs(a, b, lanes, lane_slerp_near(pace, 1), runs, run_count, out, stride);
    else if (pace.half)
        slerp_runs(a, b, lanes, pace, runs, run_count, out, stride);
    else
        slerp_runs(a, b, lanes, lane_slerp_near(pace, 0), runs, run_count, out, stride);
}

/* Keys of `words` floats to a value. Tangents are per second; times the duration they are per segment. */
KERNEL(clip_hermite)
(const float *a, const float *b, size_t words, float duration, float t, const nkw_run *runs, size_t run_count,
 float *out)
{
    for (size_t r = 0; r < run_count; r++) {
        const float *p0 = a + words + runs[r].lane, *v0 = p0 + words, *v1 = b + runs[r].lane, *p1 = v1 + words;
        float *o = out + runs[r].to;
        size_t n = runs[r].count;
#pragma omp simd
        for (size_t i = 0; i < n; i++)
            o[i] = lane_hermite(p0[i], duration * v0[i], p1[i], duration * v1[i], t);
    }
}

KERNEL(clip_normalize)(const nkw_run *runs, size_t run_count, float *out, size_t stride)
{
    for (size_t r = 0; r < run_count; r++) {
        nkw_quat_span o = quats_to(out, stride, runs[r].to);
        nkw_quat_view q = {o.x, o.y, o.z, o.w};
        size_t n = runs[r].count;
#pragma omp simd
        for (size_t i = 0; i < n; i++)
            put_quat(o, i, lane_quat_normalize(at_quat(q, i)));
    }
}
