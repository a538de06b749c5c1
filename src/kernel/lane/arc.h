/* SPDX-License-Identifier: MIT */
/* The arcs between rotations: slerp along either of them, by whole turns, for any t. */
#ifndef NAKAWARI_LANE_ARC_H
#define NAKAWARI_LANE_ARC_H

#include "strict.h"

#include <nakawari/orient.h>

#include "quat.h"
#include "slerp.h"

/* b or -b: the sign that `path` asks for. Where a.b = 0 the short path keeps b. */
static inline lane_f64_quat lane_f64_quat_aligned(lane_f64_quat a, lane_f64_quat b, nkw_path path)
{
    int obtuse = lane_f64_quat_dot(a, b) < 0.0;
    int negated = path == NKW_PATH_AS_GIVEN ? 0 : path == NKW_PATH_LONG ? !obtuse : obtuse;
    return lane_f64_quat_scale(b, negated ? -1.0 : 1.0);
}

/*
 * The great circle from a's direction u to b's: u cos x + e sin x is a at x = 0 and b at x = h.
 *
 *     h = atan2(|b - (u.b) u|, u.b),      e = the direction of b - (u.b) u
 *
 * Where b has no part at right angles to a, the turn is about the local z axis: e = u * (0, 0, 1, 0).
 */
typedef struct lane_f64_arc {
    lane_f64_quat u, e;
    double h, sine, cosine; /* sine and cosine of h */
    int is_along; /* b has the direction of a or -a */
} lane_f64_arc;

static inline lane_f64_arc lane_f64_arc_between(lane_f64_quat a, lane_f64_quat b)
{
    lane_f64_quat u = lane_f64_quat_normalize(a), v = lane_f64_quat_normalize(b);
    double cosine = lane_f64_quat_dot(u, v);
    lane_f64_quat across = lane_f64_quat_sub(v, lane_f64_quat_scale(u, cosine));
    lane_f64_quat about_z = {u.y, -u.x, u.w, -u.z};
    double s2 = lane_f64_quat_dot(across, across), sine = lane_sqrt64(s2);
    int along = s2 < 0x1p-96;
    double angle = lane_atan2_64(sine, cosine), end = cosine < 0.0 ? LANE_PI : 0.0;
    lane_f64_arc r = {
        u,    lane_f64_quat_select(along, about_z, lane_f64_quat_normalize(across)), along ? end : angle, sine, cosine,
        along};
    return r;
}

/* The point at the angle x + pi turns. `near`, a constant, says that |x| < LANE_NEAR; then there is no branch. */
static inline lane_f64_quat lane_f64_arc_at(const lane_f64_arc *arc, double x, double turns, int near)
{
    /* A quaternion that is turned by two half turns is the same one. */
    double remainder = turns - 2.0 * ((0.5 * turns + LANE_ROUND) - LANE_ROUND);
    double angle = turns == 0.0 ? x : x + LANE_PI * remainder;
    lane_sincos turn = near ? lane_sincos64(angle) : lane_turn64(angle);
    int still = (arc->h == 0.0) & (turns == 0.0);
    return lane_f64_quat_add(lane_f64_quat_scale(arc->u, turn.c), lane_f64_quat_scale(arc->e, still ? 0.0 : turn.s));
}

#define LANE_T_NEAR (0.25 * LANE_NEAR)

/* Slerp over any arc, turned by whole turns, for any t; `near` says that |t| < LANE_T_NEAR and turns is 0. */
static inline lane_f64_quat lane_f64_quat_slerp_turned(lane_f64_quat a, lane_f64_quat b, double t, double turns,
                                                       int near)
{
    lane_f64_arc arc = lane_f64_arc_between(a, b);
    double la = lane_sqrt64(lane_f64_quat_dot(a, a)), lb = lane_sqrt64(lane_f64_quat_dot(b, b));
    lane_f64_quat q = lane_f64_arc_at(&arc, t * arc.h, turns == 0.0 ? 0.0 : t * turns, near);
    q = lane_f64_quat_scale(q, t > 0.0 && t < 1.0 ? la + t * (lb - la) : t > 0.0 ? lb : la);
    return lane_f64_quat_select(t == 0.0, a, lane_f64_quat_select(t == 1.0, b, q));
}

static inline nkw_quat lane_quat_slerp_turned(nkw_quat a, nkw_quat b, float t, nkw_path path, int near)
{
    lane_f64_quat from = lane_f64_quat_from(a);
    lane_f64_quat to = lane_f64_quat_aligned(from, lane_f64_quat_from(b), path);
    return lane_quat_from_f64(lane_f64_quat_slerp_turned(from, to, (double)t, 0.0, near));
}

/* Returns b after whole turns of the rotation: an odd number negates the quaternion. */
static inline lane_f64_quat lane_f64_quat_after(lane_f64_quat b, int32_t turns)
{
    return lane_f64_quat_scale(b, turns % 2 ? -1.0 : 1.0);
}

static inline nkw_quat lane_quat_slerp_path(nkw_quat a, nkw_quat b, float t, nkw_path path, int32_t turns)
{
    lane_f64_quat from = lane_f64_quat_from(a);
    lane_f64_quat to = lane_f64_quat_aligned(from, lane_f64_quat_from(b), path);
    lane_f64_quat q = lane_f64_quat_slerp_turned(from, to, (double)t, (double)turns, 0);
    return lane_quat_from_f64(t == 1.0f ? lane_f64_quat_after(to, turns) : q);
}

/* Along the short arc: lane_quat_slerp for t in 0..1. */
static inline nkw_quat lane_quat_slerp_any(nkw_quat a, nkw_quat b, float t)
{
    return lane_t_is_inside(t) ? lane_quat_slerp(a, b, t, 0) : lane_quat_slerp_turned(a, b, t, NKW_PATH_SHORT, 0);
}

#endif
