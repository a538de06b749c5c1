/* SPDX-License-Identifier: MIT */
/* The formulas of inertia.h. */
#ifndef NAKAWARI_LANE_OFFSET_H
#define NAKAWARI_LANE_OFFSET_H

#include "strict.h"

#include <nakawari/inertia.h>
#include <nakawari/vec.h>

#include "arc.h"
#include "quat.h"
#include "rotation_vector.h"
#include "scalar.h"

/* a - b, without rounding unless the exponents are far apart. */
static inline lane_f64_vec3 lane_vec3_difference(nkw_vec3 a, nkw_vec3 b)
{
    return lane_f64_vec3_sub(lane_f64_vec3_from(a), lane_f64_vec3_from(b));
}

static inline nkw_vec3 lane_vec3_rate(nkw_vec3 before, nkw_vec3 now, double rate)
{
    return lane_vec3_from_f64(lane_f64_vec3_scale(lane_vec3_difference(now, before), rate));
}

/* ---- Inertialisation: the offset (1 - u)^3 (c[0] + c[1] u + c[2] u^2) ---- */

/* Returns u = t / duration, clamped to 0..1; 1 also for a duration of 0. */
static inline double lane_inertia_time(float t, float duration)
{
    double all = (double)duration, time = t > 0.0f ? (double)t : 0.0;
    double part = time / lane_divisor64(all);
    return time < all ? part : 1.0;
}

static inline double lane_inertia_offset(float c0, float c1, float c2, double u)
{
    double w = 1.0 - u;
    return (w * w) * (w * ((double)c0 + u * ((double)c1 + u * (double)c2)));
}

static inline lane_f64_vec3 lane_inertia_offset_vec3(nkw_vec3 c0, nkw_vec3 c1, nkw_vec3 c2, double u)
{
    lane_f64_vec3 r = {
        lane_inertia_offset(c0.x, c1.x, c2.x, u),
        lane_inertia_offset(c0.y, c1.y, c2.y, u),
        lane_inertia_offset(c0.z, c1.z, c2.z, u),
    };
    return r;
}

/* to + offset; exactly `to` from u = 1 on, also where coefficients are not finite. */
static inline float lane_inertia_value(float to, double offset, double u)
{
    double from = (double)to;
    return (float)(u < 1.0 ? from + offset : from);
}

static inline nkw_vec3 lane_inertia_value_vec3(nkw_vec3 to, lane_f64_vec3 offset, double u)
{
    nkw_vec3 r = {
        lane_inertia_value(to.x, offset.x, u),
        lane_inertia_value(to.y, offset.y, u),
        lane_inertia_value(to.z, offset.z, u),
    };
    return r;
}

LANE_FLAT static inline nkw_quat lane_inertia_value_quat(nkw_quat to, lane_f64_vec3 offset, double u)
{
    nkw_quat r = lane_quat_from_f64(lane_f64_quat_mul(lane_f64_quat_exp_near(offset), lane_f64_quat_from(to)));
    return lane_quat_select(u < 1.0, r, to);
}

/* Returns x.v/|x|^2, the growth of |x| per second in units of |x|: negative where it shrinks; 0 for x = 0. */
static inline double lane_inertia_growth(double xv, double xx)
{
    return xx > 0.0 ? xv / lane_divisor64(xx) : xx == xx ? 0.0 : xx;
}

/* Returns the duration, or -5 / growth where that is shorter; 0 for a duration that is not positive and finite. */
static inline double lane_inertia_duration(double growth, float duration)
{
    double all = duration > 0.0f && duration < INFINITY ? (double)duration : 0.0;
    return all * growth < -5.0 ? -5.0 / lane_divisor64(growth) : all;
}

/* Returns the factor of x in c[2]: 6 + A/2, A = max(0, -8 growth duration - 20). */
static inline double lane_inertia_curvature(double growth, double duration)
{
    double a = -8.0 * (growth * duration) - 20.0;
    return 6.0 + 0.5 * (a > 0.0 ? a : 0.0);
}

/* The coefficients. They are not used where the duration is 0. */
typedef struct lane_inertia_c {
    nkw_vec3 c0, c1, c2;
    float duration;
} lane_inertia_c;

static inline lane_inertia_c lane_inertia_begin(lane_f64_vec3 x, lane_f64_vec3 v, float duration)
{
    double growth = lane_inertia_growth(lane_f64_vec3_dot(x, v), lane_f64_vec3_dot(x, x));
    double t = lane_inertia_duration(growth, duration);
    lane_f64_vec3 velocity = lane_f64_vec3_scale(v, t);
    lane_f64_vec3 c1 = lane_f64_vec3_add_scaled(velocity, x, 3.0);
    lane_f64_vec3 c2 =
        lane_f64_vec3_add_scaled(lane_f64_vec3_scale(velocity, 3.0), x, lane_inertia_curvature(growth, t));
    lane_inertia_c r = {lane_vec3_from_f64(x), lane_vec3_from_f64(c1), lane_vec3_from_f64(c2), (float)t};
    return r;
}

/* x = log(from to^-1) of the shorter arc, and its rate; see nkw_quat_offset_begin. */
typedef struct lane_rotation_offset {
    lane_f64_vec3 half, rate;
} lane_rotation_offset;

/* Returns the rate of half the rotation vector of d, where from = d to, given the angular velocities of both. */
static inline lane_f64_vec3 lane_difference_rate(lane_f64_quat d, lane_f64_vec3 half, lane_f64_vec3 from,
                                                 lane_f64_vec3 to)
{
    lane_f64_vec3 w = lane_f64_vec3_sub(from, lane_f64_quat_rotate(d, to));
    return lane_f64_vec3_scale(lane_f64_rotation_rate(d, half, w), 0.5);
}

static inline lane_rotation_offset lane_rotation_offset_of(nkw_quat from, nkw_vec3 w, nkw_quat to, nkw_vec3 v)
{
    lane_f64_quat b = lane_f64_quat_unit_from(to);
    lane_f64_quat a = lane_f64_quat_aligned(b, lane_f64_quat_unit_from(from), NKW_PATH_SHORT);
    lane_f64_quat d = lane_f64_quat_mul(a, lane_f64_quat_conjugate(b));
    lane_f64_vec3 half = lane_f64_quat_log(d);
    lane_rotation_offset r = {half, lane_difference_rate(d, half, lane_f64_vec3_from(w), lane_f64_vec3_from(v))};
    return r;
}

/* The offset of rotations turns by at most 2^16 rad in all. */
#define LANE_MOST_HALF_TURN 0x1p15

static inline lane_inertia_c lane_inertia_begin_quat(lane_rotation_offset x, float duration)
{
    double pass = lane_f64_vec3_length(x.rate) * (double)duration;
    lane_f64_vec3 less = lane_f64_vec3_scale(x.rate, LANE_MOST_HALF_TURN / lane_divisor64(pass));
    return lane_inertia_begin(x.half, lane_f64_vec3_select(pass > LANE_MOST_HALF_TURN, less, x.rate), duration);
}

/* ---- Dead blending ---- */

/*
 * What depends on the time alone.
 *
 * carried   the distance that the old motion has moved, in seconds of its first velocity
 * left      the share of the old velocity that remains
 * s, rate   the weight of the new motion, and its derivative per second
 */
typedef struct lane_dead_time {
    double carried, left, s, rate;
} lane_dead_time;

static inline lane_dead_time lane_dead_time_at(float half_life, float duration, float t)
{
    double time = t > 0.0f ? (double)t : 0.0;
    double lasting = half_life > 0.0f ? (double)half_life : 0.0, x = time * LANE_LN_2 / lane_divisor64(lasting);
    int stopped = lasting == 0.0 && time > 0.0;
    double known = lasting == 0.0 ? 0.0 : x;
    double u = lane_inertia_time(t, duration), w = 1.0 - u;
    lane_dead_time r = {
        lasting == 0.0 ? 0.0 : time * lane_decay_mean64(known),
        stopped ? 0.0 : lane_decay64(known),
        u * u * (1.0 + 2.0 * w),
        u < 1.0 ? 6.0 * (u * w) / lane_divisor64((double)duration) : 0.0,
    };
    return r;
}

static inline double lane_dead_old(float x, float v, double carried)
{
    double from = (double)x, old = from + (double)v * carried;
    return carried > 0.0 ? old : from;
}

/* Exactly `to` at s = 1, exactly old at s = 0. */
static inline float lane_dead_blend(double old, float to, double s)
{
    double end = (double)to, inside = old + s * (end - old);
    return (float)(s == 1.0 ? end : s == 0.0 ? old : inside);
}

static inline nkw_vec3 lane_dead_value_vec3(nkw_vec3 x, nkw_vec3 v, nkw_vec3 to, double carried, double s)
{
    nkw_vec3 r = {
        lane_dead_blend(lane_dead_old(x.x, v.x, carried), to.x, s),
        lane_dead_blend(lane_dead_old(x.y, v.y, carried), to.y, s),
        lane_dead_blend(lane_dead_old(x.z, v.z, carried), to.z, s),
    };
    return r;
}

/* Returns the old rotation, continued to this time. Its angle is limited as that of inertialisation is. */
LANE_FLAT static inline lane_f64_quat lane_dead_old_quat(nkw_quat from, nkw_vec3 w, double carried)
{
    lane_f64_vec3 half = lane_f64_vec3_scale(lane_f64_vec3_from(w), 0.5 * carried);
    double pass = lane_f64_vec3_length(half);
    lane_f64_vec3 less = lane_f64_vec3_scale(half, LANE_MOST_HALF_TURN / lane_divisor64(pass));
    lane_f64_quat turn = lane_f64_quat_exp_near(lane_f64_vec3_select(pass > LANE_MOST_HALF_TURN, less, half));
    return lane_f64_quat_mul(turn, lane_f64_quat_unit_from(from));
}

/* Returns old to^-1 with the sign that continues the last difference; of the shorter arc if `last` is zero. */
LANE_FLAT static inline lane_f64_quat lane_dead_difference(lane_f64_quat old, nkw_quat to, nkw_quat last)
{
    lane_f64_quat b = lane_f64_quat_unit_from(to), l = lane_f64_quat_from(last);
    lane_f64_quat d = lane_f64_quat_mul(old, lane_f64_quat_conjugate(b)), identity = {0.0, 0.0, 0.0, 1.0};
    int none = lane_f64_quat_dot(l, l) == 0.0;
    return lane_f64_quat_aligned(lane_f64_quat_select(none, identity, l), d, NKW_PATH_SHORT);
}

/* exp((1 - s) log d) to; exactly `to` at s = 1. */
LANE_FLAT static inline nkw_quat lane_dead_value_quat(lane_f64_quat d, nkw_quat to, double s)
{
    lane_f64_vec3 part = lane_f64_vec3_scale(lane_f64_quat_log(d), 1.0 - s);
    lane_f64_quat q = lane_f64_quat_mul(lane_f64_quat_exp_near(part), lane_f64_quat_from(to));
    return lane_quat_select(s == 1.0, to, lane_quat_from_f64(q));
}

#endif
