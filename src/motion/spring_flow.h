/* SPDX-License-Identifier: MIT */
/* The motion of a spring without a goal, and what steps of springs share. */
#ifndef NAKAWARI_SPRING_FLOW_H
#define NAKAWARI_SPRING_FLOW_H

#include "lane/strict.h"

#include <nakawari/spring.h>

#include "lane/arc.h"
#include "lane/scalar.h"

/* max(x, 0), at most the largest float; NaN stays. -0 becomes 0. */
static inline double bounded(float x)
{
    double most = (double)FLT_MAX;
    return lane_limit64((double)x + 0.0, 0.0, most);
}

/* The deviation e of a spring without a goal after h seconds: e(h) = xx e + xv e', e'(h) = vx e + vv e'. */
typedef struct flow {
    double xx, xv, vx, vv;
} flow;

/*
 * With y = damping/2, q = y^2 - stiffness, z = q h^2, c and s the functions of z that are
 *
 *     cosh sqrt z and h sinh(sqrt z) / sqrt z,  for z < 0  cos sqrt -z and h sin(sqrt -z) / sqrt -z
 *
 *     xx = e^-yh (c + y s),   xv = e^-yh s,   vx = -stiffness xv,   vv = e^-yh (c - y s)
 */
static inline flow flow_by(double stiffness, double y, double decay, lane_sincos a)
{
    flow m = {decay * (a.c + y * a.s), decay * a.s, -stiffness * (decay * a.s), decay * (a.c - y * a.s)};
    return m;
}

/* Critical damping and its neighbourhood, |z| < 1/4: the series of both functions in z, to 2^-50. */
static inline lane_sincos near_critical(double z, double h)
{
    double c = 1.0 + z / 2.0 * (1.0 + z / 12.0 * (1.0 + z / 30.0 * (1.0 + z / 56.0 * (1.0 + z / 90.0))));
    double s = 1.0 + z / 6.0 * (1.0 + z / 20.0 * (1.0 + z / 42.0 * (1.0 + z / 72.0 * (1.0 + z / 110.0))));
    lane_sincos a = {h * s, c};
    return a;
}

/* 2 pi as a sum: n times the first or the second, of 27 bits, is exact for n < 2^26. */
#define TURN_HIGH   0x1.921fb54p2
#define TURN_MIDDLE 0x1.10b461p-28
#define TURN_LOW    0x1.a62633145c06ep-56

/* The phase w h of an oscillation, and w. */
typedef struct phase {
    double w, high, low, tail; /* w h = high + low + tail; high and low are exact products */
} phase;

/* w^2 = stiffness - y^2 = square + left; w = a + b + more, a of 26 bits, and h is a float. */
static inline phase phase_of(double stiffness, double y, double h)
{
    double yy = y * y, square = stiffness - yy, back = square - stiffness;
    double left = (stiffness - (square - back)) - (yy + back), w = lane_sqrt64(square);
    double a = lane_double(lane_bits64(w) & ~UINT64_C(0x7FFFFFF)), b = w - a;
    double more = ((((square - a * a) - 2.0 * a * b) - b * b) + left) / (2.0 * w);
    phase p = {w + more, a * h, b * h, more * h};
    return p;
}

/* sin and cos of the phase without its whole turns, less than 2^26 of them, to 2^-49 rad; beyond, of the rounded one. */
static inline lane_sincos underdamped(double stiffness, double y, double h)
{
    phase p = phase_of(stiffness, y, h);
    double n = (p.w * h * (1.0 / LANE_TWO_PI) + LANE_ROUND) - LANE_ROUND;
    double reduced = ((p.high - n * TURN_HIGH) + p.low) - n * TURN_MIDDLE;
    lane_sincos a = n < 0x1p26 ? lane_sincos64(reduced + (p.tail - n * TURN_LOW)) : lane_turn64_long(p.w * h);
    a.s = a.s / p.w;
    return a;
}

/*
 * By the two exponentials, of rates r = y - w = stiffness/(y + w) and y + w, w^2 = q:
 *
 *     2 xx = e^-rh (1 + y/w) - e^-(y + w)h r/w,      2 vv = e^-(y + w)h (1 + y/w) - e^-rh r/w
 */
static inline flow overdamped(double stiffness, double y, double q, double h)
{
    double w = lane_sqrt64(q), r = stiffness / (y + w);
    double slow = 0.5 * lane_decay64(r * h), fast = slow * lane_decay64(2.0 * w * h);
    double rest = r / w, more = 1.0 + y / w;
    double xv = (slow - fast) / w;
    flow m = {slow * more - fast * rest, xv, -stiffness * xv, fast * more - slow * rest};
    return m;
}

static inline flow flow_of(double stiffness, double damping, double h)
{
    double y = 0.5 * damping, q = y * y - stiffness, z = q * h * h;
    if (z >= 0.25)
        return overdamped(stiffness, y, q, h);
    return flow_by(stiffness, y, lane_decay64(y * h), z > -0.25 ? near_critical(z, h) : underdamped(stiffness, y, h));
}

static inline flow flow_after(nkw_spring spring, double h)
{
    return flow_of(bounded(spring.stiffness), bounded(spring.damping), h);
}

/* Whether a step of h changes nothing. */
static inline int is_none(float h)
{
    return h <= 0.0f;
}

/* The float next to a finite `from` on the way to another number. */
static inline float next_towards(float from, float to)
{
    uint32_t bits = lane_bits(from), away = (from < to) == (from > 0.0f);
    float next = lane_float(away ? bits + 1u : bits - 1u);
    return from == 0.0f ? lane_float(lane_sign_bit(to) | 1u) : next;
}

/* `next`, the rounded end of a step; one ULP nearer to the goal where the step rounds to nothing before it. */
static inline float kept_moving(float from, float next, float goal)
{
    return next == from && goal != from && lane_is_finite(from) ? next_towards(from, goal) : next;
}

/* exp v: any angle, without the rounding to float from 2^20 rad on. */
static inline lane_f64_quat exp_of(lane_f64_vec3 half, lane_sincos *turn)
{
    *turn = lane_turn64_long(lane_f64_vec3_length(half));
    return lane_f64_quat_from_axis_half(lane_f64_vec3_normalize(half), *turn);
}

/* The rotation vector of the shorter arc from `goal` to `from`, halved. */
static inline lane_f64_vec3 error_of(lane_f64_quat from, lane_f64_quat goal, lane_f64_quat *error)
{
    lane_f64_quat to = lane_f64_quat_aligned(goal, from, NKW_PATH_SHORT);
    *error = lane_f64_quat_mul(to, lane_f64_quat_conjugate(goal));
    return lane_f64_quat_log(*error);
}

#endif
