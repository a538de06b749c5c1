/* SPDX-License-Identifier: MIT */
/* The loops of transition.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_TRANSITION_H
#define NAKAWARI_BATCH_TRANSITION_H

#include <nakawari/types.h>

#include "batch/isa.h"

/* The offsets of one vector of all joints: nine arrays of coefficients, then, further on, the durations. */
typedef struct transition_offsets {
    nkw_vec3_view c0, c1, c2;
    const float *duration;
} transition_offsets;

/* Where the same is written, by a transition that begins. */
typedef struct transition_offsets_span {
    nkw_vec3_span c0, c1, c2;
    float *duration;
} transition_offsets_span;

/* Of a dead blend at a time: how far velocities have carried, the weight of the new pose. */
typedef struct transition_time {
    double carried, s;
} transition_time;

/* clang-format off */
#define NKW_LOOPS_TRANSITION(X) \
    X(nkwi_vec3_rates, (nkw_vec3_view before, nkw_vec3_view now, double rate, nkw_vec3_span out, size_t n), (before, now, rate, out, n), n) \
    X(nkwi_quat_rates, (nkw_quat_view before, nkw_quat_view now, double rate, nkw_vec3_span out, size_t n), (before, now, rate, out, n), n) \
    X(nkwi_inertia_begin_vec3, (nkw_vec3_view from, nkw_vec3_view v, nkw_vec3_view to, nkw_vec3_view w, float duration, const transition_offsets_span *out, size_t n), (from, v, to, w, duration, out, n), n) \
    X(nkwi_inertia_begin_quat, (nkw_quat_view from, nkw_vec3_view v, nkw_quat_view to, nkw_vec3_view w, float duration, const transition_offsets_span *out, size_t n), (from, v, to, w, duration, out, n), n) \
    X(nkwi_inertia_vec3, (const transition_offsets *offsets, nkw_vec3_view to, float t, nkw_vec3_span out, size_t n), (offsets, to, t, out, n), n) \
    X(nkwi_inertia_quat, (const transition_offsets *offsets, nkw_quat_view to, float t, nkw_quat_span out, size_t n), (offsets, to, t, out, n), n) \
    X(nkwi_dead_vec3, (nkw_vec3_view from, nkw_vec3_view velocity, nkw_vec3_view to, transition_time at, nkw_vec3_span out, size_t n), (from, velocity, to, at, out, n), n) \
    X(nkwi_dead_quat, (nkw_quat_view from, nkw_vec3_view velocity, nkw_quat_view to, transition_time at, nkw_quat_span last, nkw_quat_span out, size_t n), (from, velocity, to, at, last, out, n), n)
/* clang-format on */

NKW_LOOPS_TRANSITION(NKW_DECLARE)

#endif
