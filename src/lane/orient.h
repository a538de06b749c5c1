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

/* sin(k h) / sin h for 0 <= h <= pi/2, and its limit k for small h. */
static inline double lane_sine_ratio(double k, double h)
{
    double ratio = lane_sincos64_any(k * h).s / lane_sincos64_any(h).s;
    return h < 0x1p-30 ? k : ratio;
}

/*
 * Slerp over any arc up to a whole turn of the rotation, by way of the middle m of the arc:
 *
 *     h = angle(a, m) = atan2(|b - a|, |b + a|) <= pi/2,      m = (a + b) / (2 cos h)
 *     q = e sin((1 - k) h)/sin h + m sin(k h)/sin h,          e the end nearer to t, k = 2t or 2(1 - t)
 */
static inline lane_wquat lane_wquat_slerp(lane_wquat a, lane_wquat b, double t)
{
    lane_wquat sum = lane_wquat_add(a, b), difference = lane_wquat_sub(b, a);
    double ss = lane_wquat_dot(sum, sum), dd = lane_wquat_dot(difference, difference);
    double h = lane_atan2_64(lane_sqrt64(dd), lane_sqrt64(ss));
    lane_wquat about_z = {a.y, -a.x, a.w, -a.z};
    lane_wquat middle = lane_wquat_scale(sum, 0.5 * lane_sqrt64((ss + dd) / ss));
    middle = lane_wquat_select(ss == 0.0, about_z, middle);
    int first = t < 0.5;
    double k = 2.0 * (first ? t : 1.0 - t);
    lane_wquat end = lane_wquat_scale(lane_wquat_select(first, a, b), lane_sine_ratio(1.0 - k, h));
    lane_wquat q = lane_wquat_add(end, lane_wquat_scale(middle, lane_sine_ratio(k, h)));
    return lane_wquat_select(ss + dd == 0.0, a, q);
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
