/* SPDX-License-Identifier: MIT */
/* Floor 2: Euler angles and rotations, in binary64. */
#ifndef NAKAWARI_LANE_EULER_H
#define NAKAWARI_LANE_EULER_H

#include "strict.h"

#include <nakawari/euler.h>

#include "quat.h"
#include "wide.h"

/* The axes i j k of an order, and e = +1 where they follow each other as x y z x y, else -1. */
typedef struct lane_euler_axes {
    unsigned char i, j, k;
    signed char e;
} lane_euler_axes;

static inline lane_euler_axes lane_euler_axes_of(nkw_euler_order order)
{
    static const lane_euler_axes axes[6] = {
        {0, 1, 2, 1}, {0, 2, 1, -1}, {1, 0, 2, -1}, {1, 2, 0, 1}, {2, 0, 1, 1}, {2, 1, 0, -1},
    };
    unsigned known = (unsigned)order;
    return axes[known < 6 ? known : 0];
}

/* The product of the turns i, j, k, given by sine and cosine of half of each: its parts along i, j, k and w. */
static inline lane_wquat lane_wquat_from_halves(lane_sincos i, lane_sincos j, lane_sincos k, double e)
{
    lane_wquat q = {
        (i.s * j.c) * k.c + e * ((i.c * j.s) * k.s),
        (i.c * j.s) * k.c - e * ((i.s * j.c) * k.s),
        (i.c * j.c) * k.s + e * ((i.s * j.s) * k.c),
        (i.c * j.c) * k.c - e * ((i.s * j.s) * k.s),
    };
    return q;
}

/* Angles about x, y, z; the order says which of them is i, j, k. */
static inline lane_wquat lane_wquat_from_euler(const double angles[3], lane_euler_axes o)
{
    lane_sincos i = lane_sincos64_any(0.5 * angles[o.i]);
    lane_sincos j = lane_sincos64_any(0.5 * angles[o.j]);
    lane_sincos k = lane_sincos64_any(0.5 * angles[o.k]);
    lane_wquat p = lane_wquat_from_halves(i, j, k, o.e);
    double v[3];
    v[o.i] = p.x;
    v[o.j] = p.y;
    v[o.k] = p.z;
    lane_wquat q = {v[0], v[1], v[2], p.w};
    return q;
}

/* angle - 2 pi, angle or angle + 2 pi, the one in [-pi, pi]. */
static inline double lane_wrap_once(double angle)
{
    return angle > LANE_PI ? angle - LANE_TWO_PI : angle < -LANE_PI ? angle + LANE_TWO_PI : angle;
}

/* angle moved by whole turns to within half a turn of reference; half a turn itself stays. */
static inline float lane_unwrap(float angle, float reference)
{
    double off = (double)angle - (double)reference;
    /* Beyond 2^51 turns a float says nothing of a fraction of one; rint then gives off itself, rounded. */
    double turns = (off * (0.5 * LANE_INVERSE_PI) + LANE_ROUND) - LANE_ROUND;
    double moved = (double)angle - turns * LANE_TWO_PI;
    int within = off <= LANE_PI && off >= -LANE_PI;
    return within ? angle : (float)moved;
}

/* Of q and -q the one whose first component of w, x, y, z that is not 0 is positive. */
static inline lane_wquat lane_wquat_positive(lane_wquat q)
{
    double first = q.w != 0.0 ? q.w : q.x != 0.0 ? q.x : q.y != 0.0 ? q.y : q.z;
    return lane_wquat_scale(q, first < 0.0 ? -1.0 : 1.0);
}

/*
 * Sum and difference of the outer angles from the two halves of the quaternion; see nkw_euler_from_quat.
 * A half that is shorter than the rounding of a unit quaternion of floats, 2^-24, is the pole.
 */
static inline void lane_euler_from_wquat(lane_wquat q, lane_euler_axes o, double angles[3])
{
    double v[3] = {q.x, q.y, q.z};
    double e = o.e, vi = v[o.i], vj = v[o.j], vk = e * v[o.k];
    double pc = q.w + vj, ps = vi + vk, mc = q.w - vj, ms = vi - vk;
    double plus = lane_sqrt64(pc * pc + ps * ps), minus = lane_sqrt64(mc * mc + ms * ms);
    int north = minus < 0x1p-24, south = plus < 0x1p-24;
    double p = lane_atan2_64(ps, pc), m = lane_atan2_64(ms, mc);
    /* At a pole the missing half is taken so that k is 0. */
    p = south ? m : p;
    m = north ? p : m;
    angles[o.i] = lane_wrap_once(p + m);
    angles[o.k] = north || south ? 0.0 : lane_wrap_once(e * (p - m));
    double j = 2.0 * lane_atan2_64(plus, minus) - LANE_HALF_PI;
    angles[o.j] = north ? LANE_HALF_PI : south ? -LANE_HALF_PI : j;
}

#endif
