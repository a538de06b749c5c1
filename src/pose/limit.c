/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/limit.h>
#include <nakawari/quat.h>
#include <nakawari/vec.h>

#include "lane/quat.h"
#include "lane/scalar.h"

/* So far outside counts as inside, radians: more than rounding. */
#define LIMIT_SLACK 0x1p-20

/* More than any point needs: Newton's method converges quadratically. */
#define LIMIT_STEPS 64

/* A swing as a point of the plane: its angle about the side, and about axis x side. */
typedef struct swing_point {
    double x, y;
} swing_point;

/* The plane of the swings of an axis. */
typedef struct swing_plane {
    lane_f64_vec3 side, across;
} swing_plane;

static double limit_angle(float angle)
{
    return !(angle < (float)LANE_PI) ? LANE_PI : angle > 0.0f ? (double)angle : 0.0;
}

static swing_plane plane_of(nkw_vec3 axis, nkw_vec3 side)
{
    lane_f64_vec3 a = lane_f64_vec3_normalize(lane_f64_vec3_from(axis));
    lane_f64_vec3 s = lane_f64_vec3_normalize(lane_f64_vec3_from(side));
    lane_f64_vec3 across = lane_f64_vec3_cross(a, s);
    int parallel = lane_f64_vec3_dot(across, across) < 0x1p-60;
    across = lane_f64_vec3_select(parallel, lane_f64_vec3_cross(a, lane_f64_vec3_perpendicular(a)), across);
    across = lane_f64_vec3_normalize(across);
    swing_plane plane = {lane_f64_vec3_cross(across, a), across};
    return plane;
}

static swing_point point_of(const swing_plane *plane, lane_f64_quat swing)
{
    lane_f64_vec3 s = lane_f64_vec3_scale(lane_f64_quat_log(swing), 2.0);
    swing_point p = {lane_f64_vec3_dot(s, plane->side), lane_f64_vec3_dot(s, plane->across)};
    return p;
}

static lane_f64_quat swing_of(const swing_plane *plane, swing_point p)
{
    lane_f64_vec3 half = lane_f64_vec3_scale(plane->side, 0.5 * p.x);
    return lane_f64_quat_exp(lane_f64_vec3_add_scaled(half, plane->across, 0.5 * p.y));
}

/*
 * The nearest point of the ellipse x = a cos, y = b sin to a point outside with x, y >= 0, for a >= b > 0:
 *
 *     (u / (s r + 1))^2 + (v / (s + 1))^2 = 1,      u = x/a,  v = y/b,  r = (b/a)^2
 *     nearest = (x / (s r + 1), y / (s + 1))
 *
 * The left side decreases and is convex in s, so Newton's method from a smaller s stays below the root. Each term is at
 * most 1 at the root, which bounds s from below.
 */
static swing_point nearest_of_quadrant(double a, double b, swing_point p)
{
    double u = p.x / a, v = p.y / b, r = (b / a) * (b / a);
    double s = v > 1.0 ? v - 1.0 : 0.0;
    s = u - 1.0 > s * r ? (u - 1.0) / r : s;
    for (int i = 0; i < LIMIT_STEPS; i++) {
        double fu = 1.0 / (s * r + 1.0), fv = 1.0 / (s + 1.0);
        double gu = u * fu * (u * fu), gv = v * fv * (v * fv);
        double step = ((gu + gv) - 1.0) / (2.0 * (gu * (fu * r) + gv * fv));
        if (!(step > 0.0) || s + step == s)
            break;
        s += step;
    }
    swing_point nearest = {p.x / (s * r + 1.0), p.y / (s + 1.0)};
    return nearest;
}

/* The nearest point of the ellipse to a point outside; a or b may be 0. */
static swing_point nearest_of_ellipse(double a, double b, swing_point p)
{
    swing_point q = {lane_abs64(p.x), lane_abs64(p.y)}, swapped = {q.y, q.x}, n;
    if (a == 0.0 || b == 0.0) {
        n.x = q.x < a ? q.x : a;
        n.y = q.y < b ? q.y : b;
    } else if (a >= b) {
        n = nearest_of_quadrant(a, b, q);
    } else {
        swapped = nearest_of_quadrant(b, a, swapped);
        n.x = swapped.y;
        n.y = swapped.x;
    }
    swing_point r = {lane_copysign64(n.x, p.x), lane_copysign64(n.y, p.y)};
    return r;
}

static int is_inside(double a, double b, swing_point p)
{
    if (a == 0.0 || b == 0.0)
        return lane_abs64(p.x) <= a && lane_abs64(p.y) <= b;
    return (p.x / a) * (p.x / a) + (p.y / b) * (p.y / b) <= 1.0;
}

/* Limits a swing. Returns 0 if it stays. */
static int limit_swing(lane_f64_quat *swing, const swing_plane *plane, double a, double b)
{
    swing_point p = point_of(plane, *swing);
    if (is_inside(a, b, p))
        return 0;
    swing_point nearest = nearest_of_ellipse(a, b, p);
    double dx = nearest.x - p.x, dy = nearest.y - p.y;
    if (!(dx * dx + dy * dy > LIMIT_SLACK * LIMIT_SLACK))
        return 0;
    *swing = swing_of(plane, nearest);
    return 1;
}

/* Limits a twist about the unit axis. Returns 0 if it stays. */
static int limit_twist(lane_f64_quat *twist, lane_f64_vec3 axis, float low, float high)
{
    double half = 0.5 * ((double)high - (double)low), middle = 0.5 * ((double)low + (double)high);
    half = half < 0.0 ? 0.0 : half;
    if (!(half < LANE_PI))
        return 0;
    lane_f64_vec3 v = {twist->x, twist->y, twist->z};
    double along = lane_f64_vec3_dot(v, axis), flip = twist->w < 0.0 ? -1.0 : 1.0;
    double angle = 2.0 * lane_atan2_64(flip * along, flip * twist->w);
    /* From the middle of the range, in -pi..pi. */
    double turns = (angle - middle) * (0.5 / LANE_PI);
    double off = (angle - middle) - 2.0 * LANE_PI * ((turns + LANE_ROUND) - LANE_ROUND);
    if (!(lane_abs64(off) - half > LIMIT_SLACK))
        return 0;
    double limited = 0.5 * (middle + lane_copysign64(half, off));
    *twist = lane_f64_quat_from_axis_half(axis, lane_turn64(limited));
    return 1;
}

static lane_f64_vec3 unit_axis(nkw_vec3 axis)
{
    return lane_f64_vec3_normalize(lane_f64_vec3_from(axis));
}

static int is_limited(nkw_quat q, nkw_vec3 axis)
{
    int has_axis = axis.x != 0.0f || axis.y != 0.0f || axis.z != 0.0f;
    return has_axis && nkw_vec3_is_finite(axis) && nkw_quat_is_finite(q);
}

nkw_quat nkw_limit_apply(const nkw_limit *limit, nkw_quat q)
{
    if (!is_limited(q, limit->axis) || !nkw_quat_is_finite(limit->rest))
        return q;
    lane_f64_quat rest = lane_f64_quat_unit_from(limit->rest);
    lane_f64_quat off = lane_f64_quat_mul(lane_f64_quat_conjugate(rest), lane_f64_quat_from(q));
    lane_f64_swing_twist parts = lane_f64_quat_swing_twist(off, unit_axis(limit->axis));
    swing_plane plane = plane_of(limit->axis, limit->side);
    double a = limit_angle(limit->swing_side), b = limit_angle(limit->swing_across);
    int swings = limit_swing(&parts.swing, &plane, a, b);
    int twists = limit_twist(&parts.twist, unit_axis(limit->axis), limit->twist_low, limit->twist_high);
    if (!swings && !twists)
        return q;
    return lane_quat_from_f64(lane_f64_quat_mul(rest, lane_f64_quat_mul(parts.swing, parts.twist)));
}
