/* SPDX-License-Identifier: MIT */
/* Floor 3: curves on rotations. */
#ifndef NAKAWARI_LANE_ORIENT_H
#define NAKAWARI_LANE_ORIENT_H

#include "strict.h"

#include <nakawari/orient.h>

#include "data/slerp.h"
#include "euler.h"
#include "quat.h"

/*
 * The blend v from the end nearer to t, then v / |v| = v + v g,  g = 1/|v| - 1 = m / (|v| + |v|^2),  m = 1 - |v|^2.
 * At x = 0 the end comes back as it is.
 */
static inline nkw_quat lane_quat_nlerp(nkw_quat a, nkw_quat b, float t)
{
    float sign = nkw_quat_dot(a, b) < 0.0f ? -1.0f : 1.0f;
    nkw_quat c = nkw_quat_scale(b, sign);
    int first = t < 0.5f;
    float x = first ? t : 1.0f - t;
    nkw_quat near = lane_quat_select(first, a, c), far = lane_quat_select(first, c, a);
    nkw_quat v = nkw_quat_add(near, nkw_quat_scale(nkw_quat_sub(far, near), x));
    float m = lane_quat_defect(v), n2 = 1.0f - m;
    nkw_quat unit = nkw_quat_add(v, nkw_quat_scale(v, m / (sqrtf(n2) + n2)));
    return lane_quat_select(x == 0.0f, near, lane_quat_select(n2 > 0.0f, unit, nkw_quat_identity()));
}

/* Polynomials of 2..6 coefficients, lowest power first, by Horner's rule. */
static inline float lane_horner2(const float *c, float v)
{
    return c[0] + v * c[1];
}

static inline float lane_horner3(const float *c, float v)
{
    return c[0] + v * lane_horner2(c + 1, v);
}

static inline float lane_horner4(const float *c, float v)
{
    return c[0] + v * lane_horner3(c + 1, v);
}

static inline float lane_horner5(const float *c, float v)
{
    return c[0] + v * lane_horner4(c + 1, v);
}

static inline float lane_horner6(const float *c, float v)
{
    return c[0] + v * lane_horner5(c + 1, v);
}

/*
 * Slerp about the middle of the arc, so that only half angles up to pi/4 appear. near, far: the end nearer to t and
 * the other one; theta their angle; tau = min(t, 1 - t):
 *
 *     slerp = C s/2 - S d/2      s = near + far   C = cos(rho theta/2) / cos(theta/2)
 *                                d = far - near   S = sin(rho theta/2) / sin(theta/2)
 *                                rho = 1 - 2 tau
 *
 * With x = 1 - cos theta, p = t (1 - t), z = p x, v = x / (2.625 - x), P = p v:
 *
 *     C = 1 + z F(v, P)          S = rho + 2 rho z G(v, P)
 *
 * so that s/2, in the middle half of the arc, or near = s/2 - d/2, in the outer quarters, can be taken out as the
 * base, and what is left is small:
 *
 *     tau >= 1/4:  slerp = s/2  + (z F s/2 + (tau - 1/2 - rho z G) d)
 *     tau <  1/4:  slerp = near + (z F s/2 + (tau       - rho z G) d)
 */

/* z F; F(0, 0) = 1. */
static inline float lane_slerp_bulge(float v, float p, float z)
{
    float f3 = lane_horner2(LANE_SLERP_F3, v) + p * LANE_SLERP_F4[0];
    float f2 = lane_horner3(LANE_SLERP_F2, v) + p * f3;
    float f1 = lane_horner4(LANE_SLERP_F1, v) + p * f2;
    return z + z * (v * lane_horner5(LANE_SLERP_F0, v) + p * f1);
}

/* G. */
static inline float lane_slerp_skew(float v, float p)
{
    float g2 = lane_horner3(LANE_SLERP_G2, v) + p * LANE_SLERP_G3[0];
    float g1 = lane_horner3(LANE_SLERP_G1, v) + p * g2;
    return lane_horner6(LANE_SLERP_G0, v) + p * g1;
}

/*
 * base + (bulge s/2 + skew d) of one component, base s/2 or the near end. In the middle the rounding error of s,
 * by Knuth's two-sum, joins the small terms. Where nothing is added it is +0, and "base - 0" keeps a -0.
 */
static inline float lane_slerp_blend(float a, float b, float near, int middle, float bulge, float skew)
{
    float s = a + b, half = 0.5f * s, q = s - a;
    float lost = ((s - q) - a) + (q - b);
    float base = middle ? half : near;
    return base - ((middle ? 0.5f : 0.0f) * lost - (bulge * half + skew * (b - a)));
}

static inline nkw_quat lane_quat_slerp(nkw_quat a, nkw_quat b, float t)
{
    float cosine = nkw_quat_dot(a, b);
    float sign = cosine < 0.0f ? -1.0f : 1.0f;
    b = nkw_quat_scale(b, sign);
    /* 1 - cos theta = |b - a|^2 / 2: the chord for small angles, the dot product for large ones. */
    nkw_quat d = nkw_quat_sub(b, a);
    float chord = 0.5f * nkw_quat_dot(d, d);
    float x = chord < 0.5f ? chord : 1.0f - cosine * sign;
    float u = 1.0f - t;
    int first = t <= 0.5f;
    float tau = first ? t : u;
    int middle = tau >= 0.25f;
    float p = t * u, z = p * x, v = x / (LANE_SLERP_POLE - x);
    float bulge = lane_slerp_bulge(v, p * v, z);
    float skew = (middle ? tau - 0.5f : tau) - ((1.0f - 2.0f * tau) * z) * lane_slerp_skew(v, p * v);
    skew = first ? skew : -skew;
    nkw_quat r = {
        lane_slerp_blend(a.x, b.x, first ? a.x : b.x, middle, bulge, skew),
        lane_slerp_blend(a.y, b.y, first ? a.y : b.y, middle, bulge, skew),
        lane_slerp_blend(a.z, b.z, first ? a.z : b.z, middle, bulge, skew),
        lane_slerp_blend(a.w, b.w, first ? a.w : b.w, middle, bulge, skew),
    };
    return r;
}

/* b or -b: the sign that `path` asks for. Where a.b = 0 the short path keeps b. */
static inline lane_wquat lane_wquat_aligned(lane_wquat a, lane_wquat b, nkw_path path)
{
    int obtuse = lane_wquat_dot(a, b) < 0.0;
    int turned = path == NKW_PATH_AS_GIVEN ? 0 : path == NKW_PATH_LONG ? !obtuse : obtuse;
    return lane_wquat_scale(b, turned ? -1.0 : 1.0);
}

/* sin x, cos x for any x; from 2^20 on x is first rounded to a float, which is all that a turn of that size can say. */
static inline lane_sincos lane_turn64(double x)
{
    return lane_sincos64_any(lane_abs64(x) < LANE_NEAR ? x : (double)(float)x);
}

/*
 * Slerp over any arc and for any t, from a's direction u and the direction e at right angles to it towards b:
 *
 *     q = l (u cos(t h) + e sin(t h)),      h = atan2(|b - (u.b) u|, u.b),      l from |a| to |b|
 *
 * Where b has no part at right angles to a, the turn is about the local z axis: e = u * (0, 0, 1, 0).
 */
static inline lane_wquat lane_wquat_slerp(lane_wquat a, lane_wquat b, double t)
{
    lane_wquat u = lane_wquat_normalize(a), v = lane_wquat_normalize(b);
    double cosine = lane_wquat_dot(u, v);
    lane_wquat across = lane_wquat_sub(v, lane_wquat_scale(u, cosine));
    lane_wquat about_z = {u.y, -u.x, u.w, -u.z};
    double s2 = lane_wquat_dot(across, across);
    int along = s2 < 0x1p-96;
    double h = along ? (cosine < 0.0 ? LANE_PI : 0.0) : lane_atan2_64(lane_sqrt64(s2), cosine);
    lane_wquat e = lane_wquat_select(along, about_z, lane_wquat_normalize(across));
    lane_sincos turn = lane_turn64(t * h);
    double la = lane_sqrt64(lane_wquat_dot(a, a)), lb = lane_sqrt64(lane_wquat_dot(b, b));
    lane_wquat q = lane_wquat_add(lane_wquat_scale(u, turn.c), lane_wquat_scale(e, h == 0.0 ? 0.0 : turn.s));
    q = lane_wquat_scale(q, t > 0.0 && t < 1.0 ? la + t * (lb - la) : t > 0.0 ? lb : la);
    return lane_wquat_select(t == 0.0, a, lane_wquat_select(t == 1.0, b, q));
}

static inline nkw_quat lane_quat_slerp_path(nkw_quat a, nkw_quat b, float t, nkw_path path)
{
    lane_wquat from = lane_wquat_from(a);
    lane_wquat to = lane_wquat_aligned(from, lane_wquat_from(b), path);
    return lane_quat_from_wide(lane_wquat_slerp(from, to, (double)t));
}

/* lane_quat_slerp holds for t in 0..1; the arc goes on beyond. */
static inline int lane_t_is_inside(float t)
{
    return t >= 0.0f && t <= 1.0f;
}

static inline nkw_quat lane_quat_slerp_any(nkw_quat a, nkw_quat b, float t)
{
    return lane_t_is_inside(t) ? lane_quat_slerp(a, b, t) : lane_quat_slerp_path(a, b, t, NKW_PATH_SHORT);
}

/* An angle of a within one turn of b's, as NKW_UNWRAP_YAW and _ALL ask. */
static inline double lane_turned_towards(double a, double b)
{
    return a < b - LANE_PI ? a + LANE_TWO_PI : a > b + LANE_PI ? a - LANE_TWO_PI : a;
}

/* (1 - t) a + t b in binary64: exact ends, one rounding. */
static inline float lane_angle_lerp(float a, float b, float t, int unwrap)
{
    double from = unwrap ? lane_turned_towards(a, b) : (double)a;
    return (float)((1.0 - (double)t) * from + (double)t * (double)b);
}

#endif
