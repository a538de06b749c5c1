/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Points of curves: the value with its first and second derivative, in one call; the quintic Hermite curve,
 * whose control values are such points.
 *
 * Derivatives are by the parameter t, which is 0..1 in a segment. In a segment of h seconds, the velocity is first/h
 * and the acceleration second/h^2.
 */
#ifndef NAKAWARI_CURVE_POINT_H
#define NAKAWARI_CURVE_POINT_H

#include "curve.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The point of a cubic segment at t: the value, with the bits of the function of its kind, and the first and second
 * derivative by t. For a segment of h seconds, divide `velocity` by h and `acceleration` by h^2. With f = p(1) - p(0) and the
 * tangents v0, v1 at the ends:
 *
 *     first  = 6 t s f + s (s - 2t) v0 + t (t - 2s) v1,          s = 1 - t
 *     second = (6 - 12t) f + (6t - 4) v0 + (6t - 2) v1
 *
 *     Hermite       f = p1 - p0                 v0, v1 as stored
 *     Bezier        f = d0 + d1 + d2            v0 = 3 d0,          v1 = 3 d2
 *     B-spline      f = (d0 + 4 d1 + d2)/6      v0 = (d0 + d1)/2,   v1 = (d1 + d2)/2
 *     Catmull-Rom   f = d1                      v0 = (d0 + d1)/2,   v1 = (d1 + d2)/2
 *
 * where di = c[i + 1] - c[i]. The derivatives are computed in binary64 from these differences and rounded once. So
 * large coordinates with small differences lose no digits. A Hermite segment returns its tangents exactly at t = 0 and
 * t = 1, except the sign of a zero.
 *
 * kind   any other number is read as NKW_CUBIC_HERMITE
 * c      the four control values, in the order of the kind
 *
 * Error  1.0 u for `velocity` and `acceleration`, of the larger of the derivative and the largest of |f|, |v0|, |v1|, for t in
 *        0..1; `value` as its function.
 */
NKW_API nkw_motion nkw_cubic_point(nkw_cubic_kind kind, const float c[4], float t);
/** The point of a segment of vectors, by nkw_cubic_point for each component. */
NKW_API nkw_vec3_motion nkw_vec3_cubic_point(nkw_cubic_kind kind, const nkw_vec3_cubic *cubic, float t);

/**
 * The point of nkw_catmull_rom_nonuniform at t: its value, bit for bit, and the derivatives by t. `velocity` and `acceleration`
 * are those of the Hermite segment whose tangents are the rounded tangents of nkw_catmull_rom_tangent.
 *
 * Error  7.0 u for `velocity`, of the largest of |p2 - p1| and the tangents per segment, for t in 0..1; `value` as its
 *        function.
 */
NKW_API nkw_motion nkw_catmull_rom_nonuniform_point(const float times[4], float p0, float p1, float p2, float p3,
                                                         float t);
/** The point of vectors, by nkw_catmull_rom_nonuniform_point for each component. */
NKW_API nkw_vec3_motion nkw_vec3_catmull_rom_nonuniform_point(const float times[4], nkw_vec3 p0, nkw_vec3 p1,
                                                                   nkw_vec3 p2, nkw_vec3 p3, float t);

/**
 * The quintic Hermite curve from p0 to p1: value, first and second derivative at both ends are those given. Segments
 * that share them join with continuous acceleration. Derivatives are by t: multiply a velocity per second by the
 * duration h of the segment, an acceleration by h^2. With f = p1.value - p0.value, s = 1 - t, vi, ai the derivatives:
 *
 *     p      = p0 + t^3 (10 - 15t + 6t^2) f + t s^3 (1 + 3t) v0 - s t^3 (1 + 3s) v1 + t^2 s^2 (s a0 + t a1)/2
 *     first  = 30 t^2 s^2 f + s^2 (1 + 2t - 15t^2) v0 + t^2 (1 + 2s - 15s^2) v1 + t s (s (2 - 5t) a0 - t (2 - 5s) a1)/2
 *     second = 60 t s (s - t) f - 12 t s ((3 - 5t) v0 - (3 - 5s) v1) + s (1 - 8t + 10t^2) a0 + t (1 - 8s + 10s^2) a1
 *
 * Computed in binary64 from the end nearer to t; each number is rounded once. Returns the ends exactly at t = 0 and
 * t = 1, except the sign of a zero.
 *
 * Error  1.0 u of the larger of the exact number and the largest of |p0.value|, |p1.value| and the derivatives at the
 *        ends, for t in 0..1.
 * Source Farin, Curves and Surfaces for CAGD, 5th edition, 2002, section 7.6 (quintic Hermite interpolation).
 */
NKW_API nkw_motion nkw_quintic_hermite(nkw_motion p0, nkw_motion p1, float t);
/** The quintic Hermite curve of vectors, by nkw_quintic_hermite for each component. */
NKW_API nkw_vec3_motion nkw_vec3_quintic_hermite(const nkw_vec3_motion *p0, const nkw_vec3_motion *p1,
                                                      float t);

#ifdef __cplusplus
}
#endif

#endif
