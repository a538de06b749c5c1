/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include "batch/element.h"
#include "batch/transition.h"
#include "lane/offset.h"

NKW_LOOPS_TRANSITION(NKW_DECLARE_LOOP)

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
