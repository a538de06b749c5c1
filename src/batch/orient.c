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

/*
 * Blocks with a t outside 0..1 take the single function, as angles do that are far (see batch/scalar.c), and those of
 * one element.
 */
#define BLOCK 256

static inline int any_outside(const float *t, size_t from, size_t to)
{
    int outside = 0;
#pragma omp simd reduction(| : outside)
    for (size_t i = from; i < to; i++)
        outside |= !lane_t_is_inside(t[i]);
    return outside;
}

static inline int any_half(const float *t, size_t from, size_t to)
{
    int half = 0;
#pragma omp simd reduction(| : half)
    for (size_t i = from; i < to; i++)
        half |= t[i] == 0.5f;
    return half;
}

/*
 * Slerp takes three steps over a block: arcs, weights, rotations. All in one would take more registers than there are,
 * and each element would wait for its division and its polynomials.
 */
typedef struct slerp_block {
    float v[BLOCK], u[BLOCK], t[BLOCK]; /* the arc, E(u), E(t) */
    uint32_t turned[BLOCK];
} slerp_block;

static inline void arcs(nkw_quat_view a, nkw_quat_view b, slerp_block *s, size_t from, size_t to)
{
#pragma omp simd
    for (size_t i = from; i < to; i++) {
        lane_slerp_arc arc = lane_slerp_arc_between(at_quat(a, i), at_quat(b, i));
        s->v[i - from] = arc.v;
        s->turned[i - from] = arc.turned;
    }
}

static inline void weigh(slerp_block *s, size_t k, lane_slerp_pace pace)
{
    lane_slerp_arc arc = lane_slerp_arc_of(0, s->v[k]);
    s->u[k] = lane_slerp_excess_on(&arc, &pace, pace.u);
    s->t[k] = lane_slerp_excess_on(&arc, &pace, pace.t);
}

static inline nkw_quat turn(const slerp_block *s, size_t k, nkw_quat a, nkw_quat b, lane_slerp_pace pace)
{
    return lane_quat_slerp_by(a, b, s->turned[k], &pace, s->u[k], s->t[k]);
}

/* `half` says whether some t may be 1/2: mostly none is, which saves up to a tenth of the instructions. */
INLINE void slerp_inside(nkw_quat_view a, nkw_quat_view b, const float *t, int half, nkw_quat_span out, size_t from,
                         size_t to)
{
    slerp_block s;
    arcs(a, b, &s, from, to);
#pragma omp simd
    for (size_t i = from; i < to; i++)
        weigh(&s, i - from, lane_slerp_pace_aside(t[i]));
#pragma omp simd
    for (size_t i = from; i < to; i++) {
        lane_slerp_pace pace = half ? lane_slerp_pace_at(t[i]) : lane_slerp_pace_aside(t[i]);
        put_quat(out, i, turn(&s, i - from, at_quat(a, i), at_quat(b, i), pace));
    }
}

KERNEL(quat_slerp)(nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out, size_t n)
{
    for (size_t from = 0; from < n; from += BLOCK) {
        size_t end = n - from < BLOCK ? n : from + BLOCK;
        if (end - from == 1 || any_outside(t, from, end))
            for (size_t i = from; i < end; i++)
                put_quat(out, i, nkw_quat_slerp(at_quat(a, i), at_quat(b, i), t[i]));
        else if (any_half(t, from, end))
            slerp_inside(a, b, t, 1, out, from, end);
        else
            slerp_inside(a, b, t, 0, out, from, end);
    }
}

static inline void slerp_at_pace(nkw_quat_view a, nkw_quat_view b, lane_slerp_pace pace, nkw_quat_span out, size_t n)
{
    for (size_t from = 0; from < n; from += BLOCK) {
        size_t end = n - from < BLOCK ? n : from + BLOCK;
        slerp_block s;
        arcs(a, b, &s, from, end);
#pragma omp simd
        for (size_t i = from; i < end; i++)
            weigh(&s, i - from, pace);
#pragma omp simd
        for (size_t i = from; i < end; i++)
            put_quat(out, i, turn(&s, i - from, at_quat(a, i), at_quat(b, i), pace));
    }
}

KERNEL(quat_slerp_at)(nkw_quat_view a, nkw_quat_view b, float t, nkw_quat_span out, size_t n)
{
    if (n == 1 || !lane_t_is_inside(t)) {
        for (size_t i = 0; i < n; i++)
            put_quat(out, i, nkw_quat_slerp(at_quat(a, i), at_quat(b, i), t));
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
