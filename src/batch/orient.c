/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/orient.h>

#include "batch/element.h"
#include "batch/table.h"
#include "lane/orient.h"

KERNEL(quat_nlerp)(nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_quat(out, i, lane_quat_nlerp(at_quat(a, i), at_quat(b, i), t[i]));
}

KERNEL(quat_nlerp_at)(nkw_quat_view a, nkw_quat_view b, float t, nkw_quat_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_quat(out, i, lane_quat_nlerp(at_quat(a, i), at_quat(b, i), t));
}

/* Blocks with a t outside 0..1 take the single function, as angles do that are far (see batch/scalar.c). */
#define BLOCK 256

static inline int any_outside(const float *t, size_t from, size_t to)
{
    int outside = 0;
#pragma omp simd reduction(| : outside)
    for (size_t i = from; i < to; i++)
        outside |= !lane_t_is_inside(t[i]);
    return outside;
}

/* E(u), E(t) of the elements of a block, and whether b is turned. */
typedef struct slerp_weights {
    float u[BLOCK], t[BLOCK];
    uint32_t turned[BLOCK];
} slerp_weights;

static inline void weigh(nkw_quat_view a, nkw_quat_view b, const float *t, slerp_weights *w, size_t from, size_t to)
{
#pragma omp simd
    for (size_t i = from; i < to; i++) {
        lane_slerp_arc arc = lane_slerp_arc_between(at_quat(a, i), at_quat(b, i));
        lane_slerp_pace pace = lane_slerp_pace_at(t[i]);
        w->u[i - from] = lane_slerp_excess_on(&arc, &pace, pace.u);
        w->t[i - from] = lane_slerp_excess_on(&arc, &pace, pace.t);
        w->turned[i - from] = arc.turned;
    }
}

/* In two steps: all in one would take more registers than there are. */
static inline void slerp_inside(nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out, size_t from, size_t to)
{
    slerp_weights w;
    weigh(a, b, t, &w, from, to);
#pragma omp simd
    for (size_t i = from; i < to; i++) {
        size_t k = i - from;
        lane_slerp_pace pace = lane_slerp_pace_at(t[i]);
        put_quat(out, i, lane_quat_slerp_by(at_quat(a, i), at_quat(b, i), w.turned[k], &pace, w.u[k], w.t[k]));
    }
}

KERNEL(quat_slerp)(nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out, size_t n)
{
    for (size_t from = 0; from < n; from += BLOCK) {
        size_t end = n - from < BLOCK ? n : from + BLOCK;
        if (any_outside(t, from, end))
            for (size_t i = from; i < end; i++)
                put_quat(out, i, lane_quat_slerp_any(at_quat(a, i), at_quat(b, i), t[i]));
        else
            slerp_inside(a, b, t, out, from, end);
    }
}

static inline void slerp_at_pace(nkw_quat_view a, nkw_quat_view b, lane_slerp_pace pace, nkw_quat_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        nkw_quat from = at_quat(a, i), to = at_quat(b, i);
        lane_slerp_arc arc = lane_slerp_arc_between(from, to);
        put_quat(out, i, lane_quat_slerp_on(from, to, &arc, &pace));
    }
}

KERNEL(quat_slerp_at)(nkw_quat_view a, nkw_quat_view b, float t, nkw_quat_span out, size_t n)
{
    if (!lane_t_is_inside(t)) {
        for (size_t i = 0; i < n; i++)
            put_quat(out, i, lane_quat_slerp_any(at_quat(a, i), at_quat(b, i), t));
        return;
    }
    lane_slerp_pace pace = lane_slerp_pace_at(t);
    if (pace.first)
        slerp_at_pace(a, b, lane_slerp_near(pace, 1), out, n);
    else if (pace.half)
        slerp_at_pace(a, b, pace, out, n);
    else
        slerp_at_pace(a, b, lane_slerp_near(pace, 0), out, n);
}

KERNEL(quat_log)(nkw_quat_view q, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, lane_vec3_from_wide(lane_wquat_log(lane_wquat_from(at_quat(q, i)))));
}

/* Blocks with a far vector take the single function. */
static inline int any_far(nkw_vec3_view v, size_t from, size_t to)
{
    int far = 0;
#pragma omp simd reduction(| : far)
    for (size_t i = from; i < to; i++) {
        lane_wvec3 w = lane_wvec3_from(at_vec3(v, i));
        far |= !(lane_wvec3_dot(w, w) < 0.25 * LANE_NEAR * LANE_NEAR);
    }
    return far;
}

static void exp_near(nkw_vec3_view v, nkw_quat_span out, size_t from, size_t to)
{
#pragma omp simd
    for (size_t i = from; i < to; i++)
        put_quat(out, i, lane_quat_from_wide(lane_wquat_exp_near(lane_wvec3_from(at_vec3(v, i)))));
}

KERNEL(quat_exp)(nkw_vec3_view v, nkw_quat_span out, size_t n)
{
    for (size_t from = 0; from < n; from += BLOCK) {
        size_t end = n - from < BLOCK ? n : from + BLOCK;
        if (any_far(v, from, end))
            for (size_t i = from; i < end; i++)
                put_quat(out, i, lane_quat_from_wide(lane_wquat_exp(lane_wvec3_from(at_vec3(v, i)))));
        else
            exp_near(v, out, from, end);
    }
}
