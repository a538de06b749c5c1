/* SPDX-License-Identifier: MIT */
/* Floor 2: the formulas of quat.h beyond the small algebra. */
#ifndef NAKAWARI_LANE_QUAT_H
#define NAKAWARI_LANE_QUAT_H

#include "strict.h"

#include <nakawari/quat.h>

#include "two.h"
#include "vec.h"
#include "wide.h"

/* A quaternion in binary64. */
typedef struct lane_wquat {
    double x, y, z, w;
} lane_wquat;

/* A 3x3 matrix in binary64, column-major. */
typedef struct lane_wmat3 {
    double m[9];
} lane_wmat3;

static inline lane_wquat lane_wquat_from(nkw_quat q)
{
    lane_wquat r = {q.x, q.y, q.z, q.w};
    return r;
}

static inline nkw_quat lane_quat_from_wide(lane_wquat q)
{
    nkw_quat r = {(float)q.x, (float)q.y, (float)q.z, (float)q.w};
    return r;
}

static inline lane_wquat lane_wquat_scale(lane_wquat q, double s)
{
    lane_wquat r = {q.x * s, q.y * s, q.z * s, q.w * s};
    return r;
}

static inline lane_wquat lane_wquat_add(lane_wquat a, lane_wquat b)
{
    lane_wquat r = {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
    return r;
}

static inline lane_wquat lane_wquat_sub(lane_wquat a, lane_wquat b)
{
    lane_wquat r = {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w};
    return r;
}

static inline double lane_wquat_dot(lane_wquat a, lane_wquat b)
{
    return (a.x * b.x + a.y * b.y) + (a.z * b.z + a.w * b.w);
}

static inline lane_wquat lane_wquat_select(int first, lane_wquat a, lane_wquat b)
{
    lane_wquat r = {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z, first ? a.w : b.w};
    return r;
}

static inline nkw_quat lane_quat_select(int first, nkw_quat a, nkw_quat b)
{
    nkw_quat r = {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z, first ? a.w : b.w};
    return r;
}

static inline lane_wquat lane_wquat_mul(lane_wquat a, lane_wquat b)
{
    lane_wquat r = {
        (a.w * b.x + a.x * b.w) + (a.y * b.z - a.z * b.y),
        (a.w * b.y + a.y * b.w) + (a.z * b.x - a.x * b.z),
        (a.w * b.z + a.z * b.w) + (a.x * b.y - a.y * b.x),
        (a.w * b.w - a.x * b.x) - (a.y * b.y + a.z * b.z),
    };
    return r;
}

static inline lane_wquat lane_wquat_conjugate(lane_wquat q)
{
    lane_wquat r = {-q.x, -q.y, -q.z, q.w};
    return r;
}

/* q / |q|; zero gives the identity. */
static inline lane_wquat lane_wquat_normalize(lane_wquat q)
{
    lane_wquat identity = {0.0, 0.0, 0.0, 1.0};
    double n2 = lane_wquat_dot(q, q);
    return lane_wquat_select(n2 == 0.0, identity, lane_wquat_scale(q, lane_rsqrt64(n2)));
}

/* The turn about a unit axis, given by sine and cosine of half its angle. */
static inline lane_wquat lane_wquat_from_axis_half(lane_wvec3 axis, lane_sincos half)
{
    lane_wquat r = {axis.x * half.s, axis.y * half.s, axis.z * half.s, half.c};
    return r;
}

static inline lane_wquat lane_wquat_from_axis_half_angle(lane_wvec3 axis, double half)
{
    return lane_wquat_from_axis_half(axis, lane_sincos64_single(half));
}

/*
 * sin x, cos x for any x; from 2^20 on x is first rounded to the nearest finite float, which is all that a turn of
 * that size can say.
 */
static inline lane_sincos lane_turn64(double x)
{
    double most = (double)FLT_MAX;
    double held = x > most ? most : x < -most ? -most : x;
    return lane_sincos64_single(lane_abs64(x) < LANE_NEAR ? x : (double)(float)held);
}

/* log q: axis times half angle; see nkw_quat_log. */
static inline lane_wvec3 lane_wquat_log(lane_wquat q)
{
    lane_wvec3 v = {q.x, q.y, q.z};
    double n = lane_wvec3_length(v);
    double half = lane_atan2_64(n, q.w + 0.0);
    lane_wvec3 turned = lane_wvec3_scale(v, half / n);
    lane_wvec3 none = {n == 0.0 ? half : 0.0, 0.0, 0.0};
    return lane_wvec3_select(n == 0.0, none, turned);
}

/* exp v for |v| < LANE_NEAR, without a branch. */
static inline lane_wquat lane_wquat_exp_near(lane_wvec3 v)
{
    return lane_wquat_from_axis_half(lane_wvec3_normalize(v), lane_sincos64(lane_wvec3_length(v)));
}

static inline lane_wquat lane_wquat_exp(lane_wvec3 v)
{
    return lane_wquat_from_axis_half(lane_wvec3_normalize(v), lane_turn64(lane_wvec3_length(v)));
}

/* The rotation matrix, elements exact to binary64 for a unit q. */
static inline lane_wmat3 lane_wmat3_from_wquat(lane_wquat q)
{
    double x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
    double xx = q.x * x2, yy = q.y * y2, zz = q.z * z2;
    double xy = q.x * y2, xz = q.x * z2, yz = q.y * z2;
    double wx = q.w * x2, wy = q.w * y2, wz = q.w * z2;
    lane_wmat3 r = {{
        1.0 - (yy + zz), xy + wz, xz - wy,
        xy - wz, 1.0 - (xx + zz), yz + wx,
        xz + wy, yz - wx, 1.0 - (xx + yy),
    }};
    return r;
}

/*
 * The symmetric matrix K with q^T K q = 1 + trace(R(q)^T M): 4 q q^T where M is a rotation, and its dominant
 * eigenvector is the rotation nearest to any M. Rows x, y, z, w.
 */
typedef struct lane_wform {
    lane_wquat x, y, z, w;
} lane_wform;

static inline lane_wform lane_wform_from_wmat3(const lane_wmat3 *a)
{
    const double *m = a->m;
    double xy = m[1] + m[3], xz = m[2] + m[6], yz = m[5] + m[7];
    double xw = m[5] - m[7], yw = m[6] - m[2], zw = m[1] - m[3];
    lane_wform k = {
        {((1.0 + m[0]) - m[4]) - m[8], xy, xz, xw},
        {xy, ((1.0 - m[0]) + m[4]) - m[8], yz, yw},
        {xz, yz, ((1.0 - m[0]) - m[4]) + m[8], zw},
        {xw, yw, zw, ((1.0 + m[0]) + m[4]) + m[8]},
    };
    return k;
}

static inline lane_wquat lane_wform_apply(const lane_wform *k, lane_wquat q)
{
    lane_wquat r = {
        lane_wquat_dot(k->x, q),
        lane_wquat_dot(k->y, q),
        lane_wquat_dot(k->z, q),
        lane_wquat_dot(k->w, q),
    };
    return r;
}

/* The row of largest diagonal: the quaternion itself, times 4 and its own largest component. */
static inline lane_wquat lane_wform_row(const lane_wform *k)
{
    int x_over_y = k->x.x > k->y.y;
    int z_over_w = k->z.z > k->w.w;
    double xy = x_over_y ? k->x.x : k->y.y;
    double zw = z_over_w ? k->z.z : k->w.w;
    return lane_wquat_select(xy > zw, lane_wquat_select(x_over_y, k->x, k->y),
                             lane_wquat_select(z_over_w, k->z, k->w));
}

/*
 * The rotation nearest to m, not unit: the best row after `steps` multiplications by K, each of which shrinks the
 * distance from the eigenvector by the ratio of the eigenvalues: to a quarter of the noise where m is nearly a
 * rotation.
 */
#define LANE_NEAREST_STEPS 2 /* enough where m is nearly a rotation */

static inline lane_wquat lane_wform_dominant(const lane_wform *k, int steps)
{
    lane_wquat q = lane_wform_row(k);
    for (int i = 0; i < steps; i++)
        q = lane_wform_apply(k, q);
    return q;
}

/* The same for single calls: the row is looked up, and K, which is symmetric, multiplied by its columns. */
static inline lane_wquat lane_wform_dominant_single(const lane_wform *k, int steps)
{
#if defined(LANE_TWO)
    const lane_two xy[4] = {{k->x.x, k->x.y}, {k->y.x, k->y.y}, {k->z.x, k->z.y}, {k->w.x, k->w.y}};
    const lane_two zw[4] = {{k->x.z, k->x.w}, {k->y.z, k->y.w}, {k->z.z, k->z.w}, {k->w.z, k->w.w}};
    int y = !(k->x.x > k->y.y), w = !(k->z.z > k->w.w);
    double larger_xy = y ? k->y.y : k->x.x, larger_zw = w ? k->w.w : k->z.z;
    int row = larger_xy > larger_zw ? y : 2 + w;
    lane_two a = xy[row], b = zw[row];
    for (int i = 0; i < steps; i++) {
        lane_two c = (xy[0] * a[0] + xy[1] * a[1]) + (xy[2] * b[0] + xy[3] * b[1]);
        b = (zw[0] * a[0] + zw[1] * a[1]) + (zw[2] * b[0] + zw[3] * b[1]);
        a = c;
    }
    lane_wquat q = {a[0], a[1], b[0], b[1]};
    return q;
#else
    return lane_wform_dominant(k, steps);
#endif
}

static inline lane_wquat lane_wquat_from_wmat3(const lane_wmat3 *m, int steps)
{
    lane_wform k = lane_wform_from_wmat3(m);
    return lane_wquat_normalize(lane_wform_dominant(&k, steps));
}

/* q / |q|, the squares summed in binary64; zero gives the identity. */
static inline nkw_quat lane_quat_normalize(nkw_quat q)
{
    lane_wquat w = lane_wquat_from(q);
    double n2 = lane_wquat_dot(w, w);
    float rescue = lane_rescue((float)n2);
    double held = n2 * ((double)rescue * (double)rescue);
    float n = sqrtf((float)held + FLT_MIN);
    nkw_quat unit = {q.x * rescue / n, q.y * rescue / n, q.z * rescue / n, q.w * rescue / n};
    unit.w = n2 == 0.0 ? 1.0f : unit.w;
    return unit;
}

/*
 * (from x to, |from| |to| + from.to), normalised. Past a quarter turn the last sum cancels, and
 *
 *     |from| |to| + from.to = |from x to|^2 / (|from| |to| - from.to)
 */
static inline lane_wquat lane_wquat_from_vectors(lane_wvec3 from, lane_wvec3 to)
{
    double n2 = lane_wvec3_dot(from, from) * lane_wvec3_dot(to, to);
    double lengths = lane_sqrt64(n2), cosine = lane_wvec3_dot(from, to);
    lane_wvec3 c = lane_wvec3_cross(from, to);
    double c2 = lane_wvec3_dot(c, c);
    double w = cosine < 0.0 ? c2 / (lengths - cosine) : lengths + cosine;
    lane_wquat q = {c.x, c.y, c.z, w};
    lane_wvec3 p = lane_wvec3_perpendicular(from);
    lane_wquat half_turn = {p.x, p.y, p.z, 0.0};
    int opposite = cosine < 0.0 && c2 == 0.0;
    return lane_wquat_select(opposite, half_turn, lane_wquat_normalize(q));
}

/* The turn between two quaternions, 0..pi, of the nearer signs; their lengths cancel. */
static inline double lane_wquat_angle(lane_wquat a, lane_wquat b)
{
    lane_wquat turn = lane_wquat_mul(lane_wquat_conjugate(a), b);
    lane_wvec3 v = {turn.x, turn.y, turn.z};
    return 2.0 * lane_atan2_64(lane_wvec3_length(v), lane_abs64(turn.w));
}

#endif
