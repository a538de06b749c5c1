/* SPDX-License-Identifier: MIT */
/* Floor 2: Euler angles and rotations, in binary64. */
#ifndef NAKAWARI_LANE_EULER_H
#define NAKAWARI_LANE_EULER_H

#include "strict.h"

#include <nakawari/euler.h>

#include "quat.h"
#include "f64.h"

/* The axes i j k of an order, the places of x y z in it, and e = 1 where i j k is x y z, y z x or z x y, else -1. */
typedef struct lane_euler_axes {
    unsigned char i, j, k;
    unsigned char of[3];
    double e;
} lane_euler_axes;

static inline const lane_euler_axes *lane_euler_axes_of(nkw_euler_order order)
{
    static const lane_euler_axes axes[6] = {
        {0, 1, 2, {0, 1, 2}, 1.0}, {0, 2, 1, {0, 2, 1}, -1.0}, {1, 0, 2, {1, 0, 2}, -1.0},
        {1, 2, 0, {2, 0, 1}, 1.0}, {2, 0, 1, {1, 2, 0}, 1.0},  {2, 1, 0, {2, 1, 0}, -1.0},
    };
    unsigned known = (unsigned)order;
    return &axes[known < 6 ? known : 0];
}

/* The product of the turns i, j, k, given by sine and cosine of half of each: its parts along i, j, k and w. */
static inline lane_f64_quat lane_f64_quat_from_halves(lane_sincos i, lane_sincos j, lane_sincos k, double e)
{
    lane_f64_quat q = {
        (i.s * j.c) * k.c + e * ((i.c * j.s) * k.s),
        (i.c * j.s) * k.c - e * ((i.s * j.c) * k.s),
        (i.c * j.c) * k.s + e * ((i.s * j.s) * k.c),
        (i.c * j.c) * k.c - e * ((i.s * j.s) * k.s),
    };
    return q;
}

/* The same product of half angles. */
static inline lane_f64_quat lane_f64_quat_from_half_angles(double i, double j, double k, double e)
{
    return lane_f64_quat_from_halves(lane_sincos64_any(i), lane_sincos64_any(j), lane_sincos64_any(k), e);
}

/* Values in the order i j k to the order x y z. */
static inline lane_f64_vec3 lane_euler_in_place(double i, double j, double k, const lane_euler_axes *o)
{
    const double v[3] = {i, j, k};
    lane_f64_vec3 r = {v[o->of[0]], v[o->of[1]], v[o->of[2]]};
    return r;
}

/* angle - 2 pi, angle or angle + 2 pi, the one in [-pi, pi]. */
static inline double lane_wrap_once(double angle)
{
    double turn = lane_copysign64(LANE_TWO_PI, angle);
    return angle - (lane_abs64(angle) > LANE_PI ? turn : 0.0);
}

/* angle moved by whole turns to within half a turn of reference; half a turn itself stays. */
static inline float lane_unwrap(float angle, float reference)
{
    double off = (double)angle - (double)reference;
    /* Beyond 2^51 turns a float holds no fraction of one; the rounding then returns off, rounded. */
    double turns = (off * (0.5 * LANE_INVERSE_PI) + LANE_ROUND) - LANE_ROUND;
    double moved = (double)angle - turns * LANE_TWO_PI;
    int within = off <= LANE_PI && off >= -LANE_PI;
    return within ? angle : (float)moved;
}

/* Of q and -q the one whose first component of w, x, y, z that is not 0 is positive. */
static inline lane_f64_quat lane_f64_quat_positive(lane_f64_quat q)
{
    double first = q.w != 0.0 ? q.w : q.x != 0.0 ? q.x : q.y != 0.0 ? q.y : q.z;
    return lane_f64_quat_scale(q, lane_copysign64(1.0, first));
}

/*
 * Sum and difference of the outer angles from the two halves of the quaternion; see nkw_euler_from_quat. With
 * P = |(w + qj, qi + e qk)|^2 and M = |(w - qj, qi - e qk)|^2
 *
 *     sin j : cos j = (P - M)/2 : sqrt(P M),     (P - M)/2 = 2 (w qj + e qi qk),     (P + M)/2 = |q|^2
 *
 * so q need not be unit: |q|^2 in 2^-20 .. 2^20. A half that is shorter than the rounding of a unit quaternion of
 * floats, 2^-24, is the pole.
 */
static inline lane_f64_vec3 lane_euler_from_f64_quat(lane_f64_quat q, const lane_euler_axes *o)
{
    const double v[3] = {q.x, q.y, q.z};
    double vi = v[o->i], vj = v[o->j], vk = o->e * v[o->k];
    double pc = q.w + vj, ps = vi + vk, mc = q.w - vj, ms = vi - vk;
    double plus = pc * pc + ps * ps, minus = mc * mc + ms * ms;
    double pole = 0x1p-49 * (plus + minus);
    const double y[3] = {ps, ms, 2.0 * (q.w * vj + vi * vk)}, x[3] = {pc, mc, lane_sqrt64_near(plus * minus)};
    const double a[3] = {lane_atan2_64(y[0], x[0]), lane_atan2_64(y[1], x[1]), lane_atan2_64(y[2], x[2])};
    /* At a pole the missing half is taken so that k is 0. */
    int north = minus < pole, south = plus < pole;
    double p = south ? a[1] : a[0], m = north ? p : a[1];
    double j = north ? LANE_HALF_PI : south ? -LANE_HALF_PI : a[2];
    double k = north || south ? 0.0 : lane_wrap_once(o->e * (p - m));
    return lane_euler_in_place(lane_wrap_once(p + m), j, k, o);
}

#endif
