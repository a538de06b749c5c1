/* SPDX-License-Identifier: MIT */
/* The formulas of quat.h beyond the small algebra. */
#ifndef NAKAWARI_LANE_QUAT_H
#define NAKAWARI_LANE_QUAT_H

#include "strict.h"

#include <nakawari/quat.h>

#include "vec.h"
#include "f64.h"
#include "scalar.h"

/* A quaternion in binary64. */
typedef struct lane_f64_quat {
    double x, y, z, w;
} lane_f64_quat;

/* A 3x3 matrix in binary64, column-major. */
typedef struct lane_f64_mat3 {
    double m[9];
} lane_f64_mat3;

static inline lane_f64_quat lane_f64_quat_from(nkw_quat q)
{
    lane_f64_quat r = {q.x, q.y, q.z, q.w};
    return r;
}

static inline nkw_quat lane_quat_from_f64(lane_f64_quat q)
{
    nkw_quat r = {(float)q.x, (float)q.y, (float)q.z, (float)q.w};
    return r;
}

static inline lane_f64_quat lane_f64_quat_scale(lane_f64_quat q, double s)
{
    lane_f64_quat r = {q.x * s, q.y * s, q.z * s, q.w * s};
    return r;
}

static inline lane_f64_quat lane_f64_quat_add(lane_f64_quat a, lane_f64_quat b)
{
    lane_f64_quat r = {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
    return r;
}

static inline lane_f64_quat lane_f64_quat_sub(lane_f64_quat a, lane_f64_quat b)
{
    lane_f64_quat r = {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w};
    return r;
}

static inline double lane_f64_quat_dot(lane_f64_quat a, lane_f64_quat b)
{
    return (a.x * b.x + a.y * b.y) + (a.z * b.z + a.w * b.w);
}

static inline lane_f64_quat lane_f64_quat_select(int first, lane_f64_quat a, lane_f64_quat b)
{
    lane_f64_quat r = {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z, first ? a.w : b.w};
    return r;
}

static inline nkw_quat lane_quat_select(int first, nkw_quat a, nkw_quat b)
{
    nkw_quat r = {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z, first ? a.w : b.w};
    return r;
}

static inline lane_f64_quat lane_f64_quat_mul(lane_f64_quat a, lane_f64_quat b)
{
    lane_f64_quat r = {
        (a.w * b.x + a.x * b.w) + (a.y * b.z - a.z * b.y),
        (a.w * b.y + a.y * b.w) + (a.z * b.x - a.x * b.z),
        (a.w * b.z + a.z * b.w) + (a.x * b.y - a.y * b.x),
        (a.w * b.w - a.x * b.x) - (a.y * b.y + a.z * b.z),
    };
    return r;
}

static inline lane_f64_quat lane_f64_quat_conjugate(lane_f64_quat q)
{
    lane_f64_quat r = {-q.x, -q.y, -q.z, q.w};
    return r;
}

/* R(q) v for a unit q: v + 2 w (q x v) + 2 q x (q x v). */
static inline lane_f64_vec3 lane_f64_quat_rotate(lane_f64_quat q, lane_f64_vec3 v)
{
    lane_f64_vec3 axis = {q.x, q.y, q.z};
    return lane_f64_vec3_turned(axis, v, 2.0 * q.w, 2.0);
}

/* q / |q|; zero returns the identity. */
static inline lane_f64_quat lane_f64_quat_normalize(lane_f64_quat q)
{
    lane_f64_quat identity = {0.0, 0.0, 0.0, 1.0};
    double n2 = lane_f64_quat_dot(q, q);
    return lane_f64_quat_select(n2 == 0.0, identity, lane_f64_quat_scale(q, lane_rsqrt64(n2)));
}

/* q normalised, in binary64; the zero quaternion is the identity. */
static inline lane_f64_quat lane_f64_quat_unit_from(nkw_quat q)
{
    return lane_f64_quat_normalize(lane_f64_quat_from(q));
}

/* The turn about a unit axis, given by sine and cosine of half its angle. */
static inline lane_f64_quat lane_f64_quat_from_axis_half(lane_f64_vec3 axis, lane_sincos half)
{
    lane_f64_quat r = {axis.x * half.s, axis.y * half.s, axis.z * half.s, half.c};
    return r;
}

/* Returns x; from 2^20 on rounded to the nearest finite float, as lane_sincos64_far takes numbers of 24 bits. */
static inline double lane_turn_angle64(double x)
{
    double most = (double)FLT_MAX;
    double clamped = x > most ? most : x < -most ? -most : x;
    return lane_abs64(x) < LANE_NEAR ? x : (double)(float)clamped;
}

static inline lane_sincos lane_turn64(double x)
{
    return lane_sincos64_any(lane_turn_angle64(x));
}

/* 2 pi as the sum of 33 bits and the rest: n * high is exact for n < 2^20. */
#define LANE_TURN_HIGH 0x1.921fb544p2
#define LANE_TURN_LOW  0x1.0b4611a626331p-32

/* sin x and cos x of all bits of x for |x| < 2^50; beyond, x is rounded to float. */
static inline lane_sincos lane_turn64_long(double x)
{
    double n = (x * (1.0 / LANE_TWO_PI) + LANE_ROUND) - LANE_ROUND;
    return lane_abs64(x) < 0x1p50 ? lane_sincos64((x - n * LANE_TURN_HIGH) - n * LANE_TURN_LOW) : lane_turn64(x);
}

/* log q: axis times half angle; see nkw_quat_log. */
static inline lane_f64_vec3 lane_f64_quat_log(lane_f64_quat q)
{
    lane_f64_vec3 v = {q.x, q.y, q.z};
    double n = lane_f64_vec3_length(v);
    double half = lane_atan2_64(n, q.w + 0.0);
    lane_f64_vec3 rotation = lane_f64_vec3_scale(v, half / lane_divisor64(n));
    lane_f64_vec3 none = {n == 0.0 ? half : 0.0, 0.0, 0.0};
    return lane_f64_vec3_select(n == 0.0, none, rotation);
}

/* exp v for |v| < LANE_NEAR, without a branch. */
static inline lane_f64_quat lane_f64_quat_exp_near(lane_f64_vec3 v)
{
    return lane_f64_quat_from_axis_half(lane_f64_vec3_normalize(v), lane_sincos64(lane_f64_vec3_length(v)));
}

static inline lane_f64_quat lane_f64_quat_exp(lane_f64_vec3 v)
{
    return lane_f64_quat_from_axis_half(lane_f64_vec3_normalize(v), lane_turn64(lane_f64_vec3_length(v)));
}

/* The rotation matrix, elements exact to binary64 for a unit q. */
static inline lane_f64_mat3 lane_f64_mat3_from_f64_quat(lane_f64_quat q)
{
    double x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
    double xx = q.x * x2, yy = q.y * y2, zz = q.z * z2;
    double xy = q.x * y2, xz = q.x * z2, yz = q.y * z2;
    double wx = q.w * x2, wy = q.w * y2, wz = q.w * z2;
    lane_f64_mat3 r = {{
        1.0 - (yy + zz),
        xy + wz,
        xz - wy,
        xy - wz,
        1.0 - (xx + zz),
        yz + wx,
        xz + wy,
        yz - wx,
        1.0 - (xx + yy),
    }};
    return r;
}

/*
 * The symmetric matrix K with q^T K q = 1 + trace(R(q)^T M): 4 q q^T where M is a rotation, and its dominant
 * eigenvector is the rotation nearest to any M. Rows x, y, z, w.
 */
typedef struct lane_f64_form {
    lane_f64_quat x, y, z, w;
} lane_f64_form;

static inline lane_f64_form lane_f64_form_from_f64_mat3(const lane_f64_mat3 *a)
{
    const double *m = a->m;
    double xy = m[1] + m[3], xz = m[2] + m[6], yz = m[5] + m[7];
    double xw = m[5] - m[7], yw = m[6] - m[2], zw = m[1] - m[3];
    lane_f64_form k = {
        {((1.0 + m[0]) - m[4]) - m[8], xy, xz, xw},
        {xy, ((1.0 - m[0]) + m[4]) - m[8], yz, yw},
        {xz, yz, ((1.0 - m[0]) - m[4]) + m[8], zw},
        {xw, yw, zw, ((1.0 + m[0]) + m[4]) + m[8]},
    };
    return k;
}

static inline lane_f64_quat lane_f64_form_apply(const lane_f64_form *k, lane_f64_quat q)
{
    lane_f64_quat r = {
        lane_f64_quat_dot(k->x, q),
        lane_f64_quat_dot(k->y, q),
        lane_f64_quat_dot(k->z, q),
        lane_f64_quat_dot(k->w, q),
    };
    return r;
}

/* The row of largest diagonal: the quaternion itself, times 4 and its own largest component. */
static inline lane_f64_quat lane_f64_form_row(const lane_f64_form *k)
{
    int x_over_y = k->x.x > k->y.y;
    int z_over_w = k->z.z > k->w.w;
    double xy = x_over_y ? k->x.x : k->y.y;
    double zw = z_over_w ? k->z.z : k->w.w;
    return lane_f64_quat_select(xy > zw, lane_f64_quat_select(x_over_y, k->x, k->y),
                                lane_f64_quat_select(z_over_w, k->z, k->w));
}

/*
 * The rotation nearest to m, not unit: the best row after `steps` multiplications by K, each of which shrinks the
 * distance from the eigenvector by the ratio of the eigenvalues: to a quarter of the noise where m is nearly a
 * rotation.
 */
#define LANE_NEAREST_STEPS 2 /* enough where m is nearly a rotation */

static inline lane_f64_quat lane_f64_form_dominant(const lane_f64_form *k, int steps)
{
    lane_f64_quat q = lane_f64_form_row(k);
    for (int i = 0; i < steps; i++)
        q = lane_f64_form_apply(k, q);
    return q;
}

static inline lane_f64_quat lane_f64_quat_from_f64_mat3(const lane_f64_mat3 *m, int steps)
{
    lane_f64_form k = lane_f64_form_from_f64_mat3(m);
    return lane_f64_quat_normalize(lane_f64_form_dominant(&k, steps));
}

/* The same in binary32: lane_f64_form_from_f64_mat3 of the columns. */
typedef struct lane_form {
    nkw_quat x, y, z, w;
} lane_form;

static inline lane_form lane_form_from_columns(nkw_vec3 x, nkw_vec3 y, nkw_vec3 z)
{
    float xy = x.y + y.x, xz = x.z + z.x, yz = y.z + z.y;
    float xw = y.z - z.y, yw = z.x - x.z, zw = x.y - y.x;
    lane_form k = {
        {((1.0f + x.x) - y.y) - z.z, xy, xz, xw},
        {xy, ((1.0f - x.x) + y.y) - z.z, yz, yw},
        {xz, yz, ((1.0f - x.x) - y.y) + z.z, zw},
        {xw, yw, zw, ((1.0f + x.x) + y.y) + z.z},
    };
    return k;
}

static inline nkw_quat lane_form_apply(const lane_form *k, nkw_quat q)
{
    nkw_quat r = {nkw_quat_dot(k->x, q), nkw_quat_dot(k->y, q), nkw_quat_dot(k->z, q), nkw_quat_dot(k->w, q)};
    return r;
}

static inline nkw_quat lane_form_row(const lane_form *k)
{
    int x_over_y = k->x.x > k->y.y, z_over_w = k->z.z > k->w.w;
    float xy = x_over_y ? k->x.x : k->y.y, zw = z_over_w ? k->z.z : k->w.w;
    return lane_quat_select(xy > zw, lane_quat_select(x_over_y, k->x, k->y), lane_quat_select(z_over_w, k->z, k->w));
}

/*
 * The rotation nearest to a matrix and the square of the length that it was divided by, which is at least 1 except for
 * rounding: a row of K of diagonal d >= 1 is at least 1 long, and each product makes it longer. From LANE_NEAREST_FAR
 * on it is not the nearest rotation but the result of an overflow, possibly: elements beyond 2^15.
 */
typedef struct lane_nearest {
    nkw_quat q;
    float n2;
} lane_nearest;

#define LANE_NEAREST_FAR 0x1p100f

static inline lane_nearest lane_quat_from_columns(nkw_vec3 x, nkw_vec3 y, nkw_vec3 z)
{
    lane_form k = lane_form_from_columns(x, y, z);
    nkw_quat q = lane_form_apply(&k, lane_form_apply(&k, lane_form_row(&k)));
    float n2 = nkw_quat_dot(q, q), n = sqrtf(n2);
    lane_nearest r = {{q.x / n, q.y / n, q.z / n, q.w / n}, n2};
    return r;
}

/* Computes the same for any matrix, in binary64. */
static inline nkw_quat lane_quat_from_any_columns(nkw_vec3 x, nkw_vec3 y, nkw_vec3 z)
{
    lane_f64_mat3 m = {{x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z}};
    return lane_quat_from_f64(lane_f64_quat_from_f64_mat3(&m, LANE_NEAREST_STEPS));
}

/*
 * (from x to, |from| |to| + from.to), normalised. Past a quarter turn the last sum cancels, and
 *
 *     |from| |to| + from.to = |from x to|^2 / (|from| |to| - from.to)
 */
static inline lane_f64_quat lane_f64_quat_from_vectors(lane_f64_vec3 from, lane_f64_vec3 to)
{
    double n2 = lane_f64_vec3_dot(from, from) * lane_f64_vec3_dot(to, to);
    double lengths = lane_sqrt64(n2), cosine = lane_f64_vec3_dot(from, to);
    lane_f64_vec3 c = lane_f64_vec3_cross(from, to);
    double c2 = lane_f64_vec3_dot(c, c);
    double w = cosine < 0.0 ? c2 / (lengths - cosine) : lengths + cosine;
    lane_f64_quat q = {c.x, c.y, c.z, w};
    lane_f64_vec3 p = lane_f64_vec3_perpendicular(from);
    lane_f64_quat half_turn = {p.x, p.y, p.z, 0.0};
    int opposite = cosine < 0.0 && c2 == 0.0;
    return lane_f64_quat_select(opposite, half_turn, lane_f64_quat_normalize(q));
}

/* The part of q along the unit axis a, and w, not unit. is_none: q rotates the axis to its opposite, or a is zero. */
typedef struct lane_twist_part {
    double along, w;
    int is_none;
} lane_twist_part;

static inline lane_twist_part lane_twist_part_of(lane_f64_quat q, lane_f64_vec3 a)
{
    lane_f64_vec3 v = {q.x, q.y, q.z};
    lane_twist_part p = {lane_f64_vec3_dot(v, a), q.w, 0};
    p.is_none = p.along * p.along + p.w * p.w < 0x1p-96 * lane_f64_quat_dot(q, q) || lane_f64_vec3_dot(a, a) == 0.0;
    return p;
}

/* q/|q| = swing twist about the unit axis a; see nkw_quat_swing_twist. */
typedef struct lane_f64_swing_twist {
    lane_f64_quat swing, twist;
} lane_f64_swing_twist;

static inline lane_f64_swing_twist lane_f64_quat_swing_twist(lane_f64_quat q, lane_f64_vec3 a)
{
    const lane_f64_quat identity = {0.0, 0.0, 0.0, 1.0};
    lane_f64_quat u = lane_f64_quat_normalize(q);
    lane_twist_part p = lane_twist_part_of(u, a);
    lane_f64_vec3 along = lane_f64_vec3_scale(a, p.along);
    lane_f64_quat part = {along.x, along.y, along.z, p.w};
    lane_f64_quat twist = p.is_none ? identity : lane_f64_quat_normalize(part);
    lane_f64_swing_twist r = {lane_f64_quat_mul(u, lane_f64_quat_conjugate(twist)), twist};
    return r;
}

/* Returns the angle between two rotations, 0..pi, along the shorter arc. Their lengths cancel. */
static inline double lane_f64_quat_angle(lane_f64_quat a, lane_f64_quat b)
{
    lane_f64_quat turn = lane_f64_quat_mul(lane_f64_quat_conjugate(a), b);
    lane_f64_vec3 v = {turn.x, turn.y, turn.z};
    return 2.0 * lane_atan2_64(lane_f64_vec3_length(v), lane_abs64(turn.w));
}

static inline nkw_quat lane_quat_flip(nkw_quat q, uint32_t sign_bit)
{
    nkw_quat r = {lane_flip(q.x, sign_bit), lane_flip(q.y, sign_bit), lane_flip(q.z, sign_bit),
                  lane_flip(q.w, sign_bit)};
    return r;
}

#endif
