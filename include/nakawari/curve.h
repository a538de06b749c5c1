/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Cubic curves on numbers and on vectors.
 *
 * A cubic segment is the sum of four control values, weighted by four basis weights of t:
 *
 *     p(t) = w0(t) c0 + w1(t) c1 + w2(t) c2 + w3(t) c3,      0 <= t <= 1
 *
 * The kinds of curve differ only in the weights and in the meaning of the control values:
 *
 *     Hermite       c = p0, v0, p1, v1   ends and tangents; passes through p0 and p1
 *     Bezier        c = p0, p1, p2, p3   passes through p0 and p3, in the convex hull of the four
 *     B-spline      c = p0, p1, p2, p3   from (p0 + 4 p1 + p2)/6 to (p1 + 4 p2 + p3)/6; twice differentiable
 *     Catmull-Rom   c = p0, p1, p2, p3   passes through p1 and p2, tangents (p2 - p0)/2 and (p3 - p1)/2
 *
 * nkw_cubic_weights returns the weights, or their first or second derivative by t for velocity and acceleration. The
 * weights of one t apply to any number of components.
 *
 * All curve functions compute in binary32. All except Bezier evaluate the polynomial relative to the end nearer to t.
 * So ends are exact bit for bit, a constant curve is constant, and large coordinates with small differences lose no
 * digits. Bezier is the weighted sum. For t outside 0..1 the cubic continues; the B-spline and Bezier up to |t| = 2^42,
 * so that t^3 does not overflow.
 *
 * Tangents are per segment: the derivative of p by t. Multiply a tangent per second (glTF) by the duration of the
 * segment: nkw_vec3_scale(tangent, duration).
 *
 * Example  nkw_weights w; nkw_vec3 a, b, c, d, keys[4]; nkw_vec3_cubic p, left, right; float x, t, y[4], times[4];
 *          nkw_motion m; nkw_vec3_motion v;
 *
 *     w = nkw_cubic_weights(NKW_CUBIC_HERMITE, 0, t);             the four weights, or their derivatives
 *     a = nkw_vec3_cubic_sum(&p, w);                              control values times weights
 *     x = nkw_hermite(y[0], y[1], y[2], y[3], t);                 value, tangent, value, tangent
 *     a = nkw_vec3_hermite(a, b, c, d, t);                        tangents per segment
 *     x = nkw_bezier(y[0], y[1], y[2], y[3], t);
 *     a = nkw_vec3_bezier(a, b, c, d, t);                         four control points
 *     x = nkw_bspline(y[0], y[1], y[2], y[3], t);
 *     a = nkw_vec3_bspline(a, b, c, d, t);                        uniform B-spline: passes near the points
 *     x = nkw_catmull_rom(y[0], y[1], y[2], y[3], t);
 *     a = nkw_vec3_catmull_rom(a, b, c, d, t);                    through b and c
 *     p = nkw_vec3_cubic_from_catmull_rom(keys, times);           the segment between keys 1 and 2 as Hermite
 *     nkw_cubic_from_catmull_rom(y, times, y);                    of numbers
 *     m = nkw_cubic_evaluate(y, t, NKW_CUBIC_BEZIER);             value, velocity, acceleration
 *     v = nkw_vec3_cubic_evaluate(&p, t, NKW_CUBIC_BEZIER);
 *     m = nkw_quintic_evaluate(m, m, t);                          Hermite of two whole states
 *     v = nkw_vec3_quintic_evaluate(&v, &v, t);
 *     p = nkw_vec3_cubic_convert(&p, NKW_CUBIC_BEZIER, NKW_CUBIC_HERMITE);    from kind to kind
 *     nkw_vec3_bezier_split(&p, t, &left, &right);                de Casteljau
 */
#ifndef NAKAWARI_CURVE_H
#define NAKAWARI_CURVE_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Four basis weights, in the order of the control values. */
typedef struct nkw_weights {
    float w[4];
} nkw_weights;
NKW_SIZE(nkw_weights, 16, 16);

/** The four control points of one cubic segment, in the order of its kind. */
typedef struct nkw_vec3_cubic {
    nkw_vec3 c[4];
} nkw_vec3_cubic;
NKW_SIZE(nkw_vec3_cubic, 48, 48);

/** The parameters of a Kochanek-Bartels key, usually -1..1; all 0 is the cardinal spline of tension 0. */
typedef struct nkw_tcb {
    float tension, continuity, bias;
} nkw_tcb;
NKW_SIZE(nkw_tcb, 12, 12);

/** A kind of cubic curve. Any other number is read as NKW_CUBIC_HERMITE. */
typedef enum nkw_cubic_kind {
    NKW_CUBIC_HERMITE, /**< control values p0, v0, p1, v1 */
    NKW_CUBIC_BEZIER, /**< p0, p1, p2, p3 */
    NKW_CUBIC_BSPLINE, /**< p0, p1, p2, p3; uniform */
    NKW_CUBIC_CATMULL_ROM, /**< p0, p1, p2, p3; uniform */
    NKW_CUBIC_KIND_MAX_ENUM = 0x7fffffff
} nkw_cubic_kind;

/**
 * The four basis weights of a kind at t, or a derivative of them by t. With s = 1 - t:
 *
 *     Hermite       (1 + 2t) s^2,   t s^2,   t^2 (3 - 2t),   -t^2 s
 *       first       -6 t s,   (s - 2t) s,   6 t s,   (t - 2s) t
 *       second      12t - 6,   6t - 4,   6 - 12t,   6t - 2
 *     Bezier        s^3,   3 s^2 t,   3 s t^2,   t^3                            (Bernstein)
 *       first       -3 s^2,   3 s (s - 2t),   3 t (2s - t),   3 t^2
 *       second      6s,   18t - 12,   6 - 18t,   6t
 *     B-spline      s^3/6,   (4 + 3 t^2 (t - 2))/6,   (4 + 3 s^2 (s - 2))/6,   t^3/6
 *       first       -s^2/2,   -t (4s + t)/2,   s (s + 4t)/2,   t^2/2
 *       second      s,   3t - 2,   1 - 3t,   t
 *     Catmull-Rom   -t s^2/2,   s (1 + t - 3t^2/2),   t (1 + s - 3s^2/2),   -t^2 s/2
 *       first       s (2t - s)/2,   -t (10s + t)/2,   s (s + 10t)/2,   t (t - 2s)/2
 *       second      2 - 3t,   9t - 5,   4 - 9t,   3t - 1
 *
 * derivative   0 for the weights, 1 for the first derivative, 2 for the second; any other number is read as 0
 *
 * Error  1.0 u of the number in this table, absolute, for t in 0..1 (u = 2^-24):
 *
 *     derivative    0     1     2
 *     Hermite       2.0   3.3   8.0
 *     Bezier        2.5   7.1   16.0
 *     B-spline      1.8   1.9   2.0
 *     Catmull-Rom   2.6   4.5   8.0
 */
NKW_API nkw_weights nkw_cubic_weights(nkw_cubic_kind kind, int derivative, float t);

/**
 * The weighted sum (w0 c0 + w1 c1) + (w2 c2 + w3 c3) of the control values, for each component.
 *
 * Error  3.0 u of |w0 c0| + |w1 c1| + |w2 c2| + |w3 c3|.
 */
NKW_API nkw_vec3 nkw_vec3_cubic_sum(const nkw_vec3_cubic *cubic, nkw_weights weights);

/**
 * The Hermite curve from p0 to p1 with tangents v0, v1 per segment. Returns exactly p0 at t = 0 and p1 at t = 1.
 *
 *     p = p0 + t (f + s (s (v0 - f) - t (v1 - f))),    f = p1 - p0,  s = 1 - t
 *
 * A sum by four weights is not faster with SSE2 and has up to 1.5 times the error; so this form stays.
 *
 * Error  4.3 u of the largest control value, for t in 0..1 (4.003 at -0x1.12706ap+15, -0x1.127752p+15, 0x1.12500cp+15,
 *        -0x1.01a49ep+15, t 0x1.ff9776p-2).
 * Source Ferguson, Multivariable Curve Interpolation, J. ACM 11, 1964.
 */
NKW_ALGEBRA float nkw_hermite(float p0, float v0, float p1, float v1, float t);
/** The Hermite curve of vectors, by nkw_hermite for each component. */
NKW_ALGEBRA nkw_vec3 nkw_vec3_hermite(nkw_vec3 p0, nkw_vec3 v0, nkw_vec3 p1, nkw_vec3 v1, float t);

/**
 * The cubic Bezier curve: the weighted sum of NKW_CUBIC_BEZIER, (w0 p0 + w1 p1) + (w2 p2 + w3 p3). Returns exactly p0
 * at t = 0 and p3 at t = 1, for finite control values, except the sign of a zero. A constant curve is constant to
 * within the error.
 *
 * Error  6.0 u of the largest control value, for t in 0..1 (5.52 at -0x1.1d9cc4p+16, -0x1.1d9dbp+16, -0x1.1d9dbcp+16,
 *        -0x1.1d9ebep+16, t 0x1.77acecp-3).
 * Source Farin, Curves and Surfaces for CAGD, 5th edition, 2002.
 */
NKW_ALGEBRA float nkw_bezier(float p0, float p1, float p2, float p3, float t);
/** The cubic Bezier curve of vectors, by nkw_bezier for each component. */
NKW_ALGEBRA nkw_vec3 nkw_vec3_bezier(nkw_vec3 p0, nkw_vec3 p1, nkw_vec3 p2, nkw_vec3 p3, float t);

/**
 * The segment of the uniform cubic B-spline between the second and third control value.
 *
 * Error  3.9 u of the largest control value, for t in 0..1 (3.653 at -0x1.f630e6p+3, 0x1.09fbcap+4, -0x1p+4,
 *        0x1.f5eabcp+3, t 0x1.ff2dd2p-9).
 * Source de Boor, A Practical Guide to Splines, 1978.
 */
NKW_ALGEBRA float nkw_bspline(float p0, float p1, float p2, float p3, float t);
/** The uniform cubic B-spline of vectors, by nkw_bspline for each component. */
NKW_ALGEBRA nkw_vec3 nkw_vec3_bspline(nkw_vec3 p0, nkw_vec3 p1, nkw_vec3 p2, nkw_vec3 p3, float t);

/**
 * The uniform Catmull-Rom segment from p1 to p2. Returns exactly p1 at t = 0 and p2 at t = 1.
 *
 * A sum by four weights is slower with SSE2 and has up to 1.7 times the error; so this form stays.
 *
 * Error  4.5 u of the largest control value, for t in 0..1 (4.12 at 0x1.00d17ep+10, -0x1.03c53ep+10, 0x1.03c0c8p+10,
 *        -0x1.03b74cp+10, t 0x1.fbd2aep-2).
 * Source Catmull, Rom, A Class of Local Interpolating Splines, 1974.
 */
NKW_ALGEBRA float nkw_catmull_rom(float p0, float p1, float p2, float p3, float t);
/** The uniform Catmull-Rom segment of vectors, by nkw_catmull_rom for each component. */
NKW_ALGEBRA nkw_vec3 nkw_vec3_catmull_rom(nkw_vec3 p0, nkw_vec3 p1, nkw_vec3 p2, nkw_vec3 p3, float t);

/**
 * The Catmull-Rom segment from keys[1] to keys[2], at times[0..3] that may be unevenly spaced, as Hermite control
 * values p0, v0, p1, v1: for nkw_hermite and NKW_CUBIC_HERMITE; t in 0..1 corresponds to times[1]..times[2]. The
 * tangent at a key is the derivative there of the parabola through it and its neighbours:
 *
 *     v = (d0 h1 + d1 h0)/(h0 + h1),     d0, d1 the slopes and h0, h1 the durations before and after the key
 *
 * At the ends of a series, repeat the end key and its time: where one duration is not positive, v is the slope of the
 * other side; where both are not, 0. v per second is computed in binary64 and rounded, then multiplied by the duration
 * of the segment.
 *
 * times   differences of times, and tangents per second, must be normal floats or 0
 * cubic   receives p0, v0, p1, v1
 *
 * Error  7.0 u of the largest of |p2 - p1| and the tangents per segment, for the velocity of nkw_cubic_evaluate and t
 *        in 0..1; 4.0 u of the largest of the control values and tangents, for nkw_hermite; 2.1 u of the larger slope
 *        times the duration, for a tangent.
 * Source Barry, Goldman, A Recursive Evaluation Algorithm for a Class of Catmull-Rom Splines, SIGGRAPH 1988,
 *        whose curve over uneven knots has these tangents.
 */
NKW_API void nkw_cubic_from_catmull_rom(const float keys[4], const float times[4], float cubic[4]);
/** The Catmull-Rom segment of vectors, by nkw_cubic_from_catmull_rom for each component. */
NKW_API nkw_vec3_cubic nkw_vec3_cubic_from_catmull_rom(const nkw_vec3 keys[4], const float times[4]);

/**
 * The motion on a cubic segment at t: the value, with the bits of the function of its kind, and the first and second
 * derivative by t. For a segment of h seconds, divide `velocity` by h and `acceleration` by h^2. With f = p(1) - p(0)
 * and the tangents v0, v1 at the ends:
 *
 *     velocity     = 6 t s f + s (s - 2t) v0 + t (t - 2s) v1,          s = 1 - t
 *     acceleration = (6 - 12t) f + (6t - 4) v0 + (6t - 2) v1
 *
 *     Hermite       f = p1 - p0                 v0, v1 as stored
 *     Bezier        f = d0 + d1 + d2            v0 = 3 d0,          v1 = 3 d2
 *     B-spline      f = (d0 + 4 d1 + d2)/6      v0 = (d0 + d1)/2,   v1 = (d1 + d2)/2
 *     Catmull-Rom   f = d1                      v0 = (d0 + d1)/2,   v1 = (d1 + d2)/2
 *
 * where di = cubic[i + 1] - cubic[i]. The derivatives are computed in binary64 from these differences and rounded once.
 * So large coordinates with small differences lose no digits. A Hermite segment returns its tangents exactly at t = 0
 * and t = 1, except the sign of a zero.
 *
 * cubic  the four control values, in the order of the kind
 *
 * Error  1.0 u for `velocity` and `acceleration`, of the larger of the derivative and the largest of |f|, |v0|, |v1|,
 *        for t in 0..1; `value` as its function.
 */
NKW_API nkw_motion nkw_cubic_evaluate(const float cubic[4], float t, nkw_cubic_kind kind);
/** The motion on a segment of vectors, by nkw_cubic_evaluate for each component. */
NKW_API nkw_vec3_motion nkw_vec3_cubic_evaluate(const nkw_vec3_cubic *cubic, float t, nkw_cubic_kind kind);

/**
 * The quintic Hermite curve from p0 to p1: value, first and second derivative at both ends are those given. Segments
 * that share them join with continuous acceleration. Derivatives are by t: multiply a velocity per second by the
 * duration h of the segment, an acceleration by h^2. With f = p1.value - p0.value, s = 1 - t, vi, ai the derivatives:
 *
 *     p            = p0 + t^3 (10 - 15t + 6t^2) f + t s^3 (1 + 3t) v0 - s t^3 (1 + 3s) v1 + t^2 s^2 (s a0 + t a1)/2
 *     velocity     = 30 t^2 s^2 f + s^2 (1 + 2t - 15t^2) v0 + t^2 (1 + 2s - 15s^2) v1
 *                    + t s (s (2 - 5t) a0 - t (2 - 5s) a1)/2
 *     acceleration = 60 t s (s - t) f - 12 t s ((3 - 5t) v0 - (3 - 5s) v1)
 *                    + s (1 - 8t + 10t^2) a0 + t (1 - 8s + 10s^2) a1
 *
 * Computed in binary64 from the end nearer to t; each number is rounded once. Returns the ends exactly at t = 0 and
 * t = 1, except the sign of a zero.
 *
 * Error  1.0 u of the larger of the exact number and the largest of |p0.value|, |p1.value| and the derivatives at the
 *        ends, for t in 0..1.
 * Source Farin, Curves and Surfaces for CAGD, 5th edition, 2002, section 7.6 (quintic Hermite interpolation).
 */
NKW_API nkw_motion nkw_quintic_evaluate(nkw_motion p0, nkw_motion p1, float t);
/** The quintic Hermite curve of vectors, by nkw_quintic_evaluate for each component. */
NKW_API nkw_vec3_motion nkw_vec3_quintic_evaluate(const nkw_vec3_motion *p0, const nkw_vec3_motion *p1, float t);

/**
 * The same segment as a curve of another kind, for each component: all kinds span the same cubics. By way of the Bezier
 * control values b, with p, v the Hermite, d the B-spline and c the Catmull-Rom control values:
 *
 *     b = p0, p0 + v0/3, p1 - v1/3, p1                        p = b0, b3,    v = 3 (b1 - b0), 3 (b3 - b2)
 *     b = (d0 + 4 d1 + d2)/6, (2 d1 + d2)/3,                  d = 6 b0 - 7 b1 + 2 b2, 2 b1 - b2,
 *         (d1 + 2 d2)/3, (d1 + 4 d2 + d3)/6                       2 b2 - b1, 2 b1 - 7 b2 + 6 b3
 *     b = c1, c1 + (c2 - c0)/6, c2 - (c3 - c1)/6, c2          c = b3 - 6 (b1 - b0), b0, b3, b0 + 6 (b3 - b2)
 *
 * Mathematically exact; computed in binary64, each value rounded once. A segment that has the kind `to` is returned
 * unchanged.
 *
 * Error  1.0 u of the largest control value of the two segments.
 */
NKW_API nkw_vec3_cubic nkw_vec3_cubic_convert(const nkw_vec3_cubic *cubic, nkw_cubic_kind from, nkw_cubic_kind to);

/**
 * Splits a Bezier segment at t: into the curve over 0..t and the curve over t..1, each a Bezier segment over 0..1. The
 * end of left and the start of right have the same bits; the other ends are those of the segment. t outside 0..1
 * extrapolates. left and right may be the input.
 *
 * Error  1.0 u of the largest control value, for t in 0..1.
 * Source de Casteljau, Courbes et surfaces a poles, 1963.
 */
NKW_API void nkw_vec3_bezier_split(const nkw_vec3_cubic *bezier, float t, nkw_vec3_cubic *left, nkw_vec3_cubic *right);

#ifdef __cplusplus
}
#endif

#if NKW_INLINE || defined(NKW_DEFINE_ALGEBRA)
#include "inline/curve.h"
#endif

#endif
