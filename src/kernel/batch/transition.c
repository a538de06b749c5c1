/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "batch/element.h"
#include "batch/transition.h"
#include "lane/offset.h"

NKW_LOOPS_TRANSITION(NKW_DECLARE_LOOP)

NKW_LOOP(nkwi_vec3_rates)
(nkw_vec3_view before, nkw_vec3_view now, double rate, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, lane_vec3_rate(at_vec3(before, i), at_vec3(now, i), rate));
}

NKW_LOOP(nkwi_quat_rates)
(nkw_quat_view before, nkw_quat_view now, double rate, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, lane_quat_rate(at_quat(before, i), at_quat(now, i), rate));
}

NKW_LOOP(nkwi_inertia_begin_vec3)
(nkw_vec3_view from, nkw_vec3_view v, nkw_vec3_view to, nkw_vec3_view w, float duration,
 const transition_offsets_span *out, size_t n)
{
    const transition_offsets_span o = *out;
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        lane_f64_vec3 x = lane_vec3_difference(at_vec3(from, i), at_vec3(to, i));
        lane_f64_vec3 rate = lane_vec3_difference(at_vec3(v, i), at_vec3(w, i));
        lane_inertia_c c = lane_inertia_begin(x, rate, duration);
        put_vec3(o.c0, i, c.c0);
        put_vec3(o.c1, i, c.c1);
        put_vec3(o.c2, i, c.c2);
        o.duration[i] = c.duration;
    }
}

NKW_LOOP(nkwi_inertia_begin_quat)
(nkw_quat_view from, nkw_vec3_view v, nkw_quat_view to, nkw_vec3_view w, float duration,
 const transition_offsets_span *out, size_t n)
{
    const transition_offsets_span o = *out;
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        lane_rotation_offset x =
            lane_rotation_offset_of(at_quat(from, i), at_vec3(v, i), at_quat(to, i), at_vec3(w, i));
        lane_inertia_c c = lane_inertia_begin_quat(x, duration);
        put_vec3(o.c0, i, c.c0);
        put_vec3(o.c1, i, c.c1);
        put_vec3(o.c2, i, c.c2);
        o.duration[i] = c.duration;
    }
}

NKW_LOOP(nkwi_inertia_vec3)
(const transition_offsets *offsets, nkw_vec3_view to, float t, nkw_vec3_span out, size_t n)
{
    const transition_offsets o = *offsets;
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        double u = lane_inertia_time(t, o.duration[i]);
        lane_f64_vec3 offset = lane_inertia_offset_vec3(at_vec3(o.c0, i), at_vec3(o.c1, i), at_vec3(o.c2, i), u);
        put_vec3(out, i, lane_inertia_value_vec3(at_vec3(to, i), offset, u));
    }
}

NKW_LOOP(nkwi_inertia_quat)
(const transition_offsets *offsets, nkw_quat_view to, float t, nkw_quat_span out, size_t n)
{
    const transition_offsets o = *offsets;
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        double u = lane_inertia_time(t, o.duration[i]);
        lane_f64_vec3 offset = lane_inertia_offset_vec3(at_vec3(o.c0, i), at_vec3(o.c1, i), at_vec3(o.c2, i), u);
        put_quat(out, i, lane_inertia_value_quat(at_quat(to, i), offset, u));
    }
}

NKW_LOOP(nkwi_dead_vec3)
(nkw_vec3_view from, nkw_vec3_view velocity, nkw_vec3_view to, transition_time at, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i,
                 lane_dead_value_vec3(at_vec3(from, i), at_vec3(velocity, i), at_vec3(to, i), at.carried, at.s));
}

NKW_LOOP(nkwi_dead_quat)
(nkw_quat_view from, nkw_vec3_view velocity, nkw_quat_view to, transition_time at, nkw_quat_span last,
 nkw_quat_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        lane_f64_quat old = lane_dead_old_quat(at_quat(from, i), at_vec3(velocity, i), at.carried);
        lane_f64_quat d = lane_dead_difference(old, at_quat(to, i), at_quat(last, i));
        nkw_quat value = lane_dead_value_quat(d, at_quat(to, i), at.s);
        put_quat(last, i, lane_quat_from_f64(d));
        put_quat(out, i, value);
    }
}
