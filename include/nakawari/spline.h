/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Smooth curves through many keys.
 *
 * All methods have one form: a tangent before and a tangent after each key, per second. The curve between two keys is
 * the cubic Hermite segment of their values and tangents. A CUBICSPLINE track (track.h) stores exactly these numbers:
 * nkw_spline_tangents writes the tangents into its triples, and nkw_track_sample, clips and
 * nkw_track_sample_motion evaluate it.
 *
 * With the durations hi = times[i + 1] - times[i] and the slopes di = (values[i + 1] - values[i])/hi, the tangent of
 * key k, between h0 = h(k-1), d0 = d(k-1) and h1 = hk, d1 = dk:
 *
 *     CATMULL_ROM   (d0 h1 + d1 h0)/(h0 + h1)             the slope of the parabola through three keys
 *     CARDINAL      (1 - tension)(d0 h0 + d1 h1)/(h0 + h1)
 *     TCB           Kochanek-Bartels: tension T, continuity C and bias B of each key
 *                     before   (1 - T)((1 - C)(1 + B) d0 h0 + (1 + C)(1 - B) d1 h1)/(h0 + h1)
 *                     after    (1 - T)((1 + C)(1 + B) d0 h0 + (1 - C)(1 - B) d1 h1)/(h0 + h1)
 *     CENTRIPETAL   Catmull-Rom over the knots of nkw_spline_knots with alpha = 1/2, run through in the times of the
 *     CHORDAL       keys; with alpha = 1. The direction is continuous at a key, the speed is not
 *     PCHIP         0 if d0 d1 <= 0, otherwise the harmonic mean (w0 + w1)/(w0/d0 + w1/d1), w0 = 2 h1 + h0,
 *                     w1 = h1 + 2 h0: monotone where the keys are, without overshoot
 *     AKIMA         (w0 d0 + w1 d1)/(w0 + w1), w0 = |d(k+1) - d1|, w1 = |d0 - d(k-2)|; (d0 + d1)/2 if w0 + w1 is at
 *                     most 1e-9 of the sum of the magnitudes of the four slopes
 *     MAKIMA        the same with w0 = |d(k+1) - d1| + |d(k+1) + d1|/2, w1 = |d0 - d(k-2)| + |d0 + d(k-2)|/2
 *     C2            the tangents for which the acceleration is continuous at every key: a tridiagonal system
 *
 * Ends:
 *
 *     FREE       CATMULL_ROM and the knots continue the last slope d; the tangent of CARDINAL is (1 - tension) d, that
 *                of TCB (1 - tension)(1 + bias continuity) d at the first key, 1 - bias continuity at the last; PCHIP
 *                takes the slope of the parabola through three keys, limited to keep monotone; AKIMA and MAKIMA
 *                extrapolate slopes, d(-1) = 2 d0 - d1; C2 has no acceleration at the end (natural spline)
 *     CLAMPED    the tangents of the first and last key are given
 *     PERIODIC   the last key is the first one of the next period: their values should be equal
 *
 * Keys of equal time are a jump. They divide the keys into separate splines, whose ends are free; PERIODIC is then read
 * as FREE. A separate key has the tangent 0. Tangents are computed in binary64 and rounded once; a tangent that exceeds
 * the largest float is replaced by it.
 *
 * Source Kochanek, Bartels, Interpolating Splines with Local Tension, Continuity, and Bias Control, SIGGRAPH 1984, with
 *        its correction for unequal durations (Eberly, Kochanek-Bartels Cubic Splines, 2017).
 *        Yuksel, Schaefer, Keyser, Parameterization and Applications of Catmull-Rom Curves, 2011: centripetal knots.
 *        Fritsch, Carlson, Monotone Piecewise Cubic Interpolation, 1980; Fritsch, Butland, A Method for Constructing
 *        Local Monotone Piecewise Cubic Interpolants, 1984: PCHIP, as SciPy's PchipInterpolator.
 *        Akima, A New Method of Interpolation and Smooth Curve Fitting, J. ACM 17, 1970.
 *        de Boor, A Practical Guide to Splines, 1978: the C2 cubic.
 */
#ifndef NAKAWARI_SPLINE_H
#define NAKAWARI_SPLINE_H

#include "curve.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How the tangents follow from the keys. */
typedef enum nkw_spline_method {
    NKW_SPLINE_CATMULL_ROM,
    NKW_SPLINE_CARDINAL,
    NKW_SPLINE_TCB,
    NKW_SPLINE_CENTRIPETAL,
    NKW_SPLINE_CHORDAL,
    NKW_SPLINE_PCHIP,
    NKW_SPLINE_AKIMA,
    NKW_SPLINE_MAKIMA,
    NKW_SPLINE_C2,
    NKW_SPLINE_METHOD_MAX_ENUM = 0x7fffffff
} nkw_spline_method;

/** The tangents at the first and the last key. */
typedef enum nkw_spline_ends {
    NKW_SPLINE_ENDS_FREE,
    NKW_SPLINE_ENDS_CLAMPED,
    NKW_SPLINE_ENDS_PERIODIC,
    NKW_SPLINE_ENDS_MAX_ENUM = 0x7fffffff
} nkw_spline_ends;

/** Keys and a method. The arrays belong to the caller. */
typedef struct nkw_spline {
    const float *times;  /**< count key times, seconds, ascending; equal times are a jump */
    const float *values; /**< the value of key k: `width` floats from values[k * stride] on */
    size_t count;        /**< at least 1 */
    size_t width;        /**< floats in a value, at least 1 */
    size_t stride;       /**< floats from a value to the next, at least width */
    nkw_spline_method method;
    nkw_spline_ends ends;
    float tension;             /**< CARDINAL: 0 is the usual spline, 1 has no tangents */
    const nkw_tcb *tcb;        /**< TCB: count parameters; NULL: all 0 */
    const float *end_tangents; /**< CLAMPED: width floats of the first key, then of the last; NULL: all 0 */
} nkw_spline;
NKW_SIZE(nkw_spline, 72, 40);

/**
 * Where tangents are written: those before and after key k to in[k * stride] and out[k * stride]. Both may be the same
 * array for all methods except TCB, CENTRIPETAL and CHORDAL, whose two tangents differ; that array then receives the
 * tangents after the keys. For a CUBICSPLINE track with triples v: {v, v + 2 * width, 3 * width}, the values of the
 * keys in v + width with the stride 3 * width.
 */
typedef struct nkw_tangent_span {
    float *in, *out;
    size_t stride; /**< floats, at least the width of the spline */
} nkw_tangent_span;
NKW_SIZE(nkw_tangent_span, 24, 12);

/** The bytes of working memory for NKW_SPLINE_C2; other methods need none. */
#define NKW_SPLINE_WORK(count) (3 * sizeof(double) * (count))

/**
 * Computes the tangents of all keys, per second. Each key is checked first; after an error nothing is written. The
 * arrays of `tangents` must not overlap the values.
 *
 * bad      receives the index of the first key with an error, 0 if there is none; may be NULL
 * work     at least NKW_SPLINE_WORK(count) bytes for NKW_SPLINE_C2; for other methods {NULL, 0} is valid
 * Returns
 *
 *     NKW_OK             no error
 *     NKW_EMPTY          no keys, or width 0
 *     NKW_BAD_METHOD     unknown method or ends
 *     NKW_BAD_WIDTH      a stride less than the width
 *     NKW_NOT_FINITE     a time, a value, a parameter or an end tangent that is not finite
 *     NKW_NOT_ASCENDING  a time less than the one before
 *     NKW_TOO_SMALL      work
 *
 * Error  1.0 u of the larger of the tangent and the largest slope that it is computed from (of all slopes for C2), for
 *        |tension|, |T|, |C|, |B| <= 1 and durations between 2^-20 and 2^20 of each other.
 */
NKW_API nkw_result nkw_spline_tangents(const nkw_spline *spline, nkw_tangent_span tangents, size_t *bad, nkw_work work);

/**
 * Knots from the distances of the keys: 0, then a step of |values[k + 1] - values[k]|^alpha for each segment. As times
 * of a spline, they determine its shape: alpha = 0 is uniform, 1/2 centripetal (without cusps and loops within a
 * segment), 1 chordal. Reads values, count, width and stride only. Coincident values have a step of 0 for alpha > 0;
 * sums beyond the largest float are that float.
 *
 * knots    receives count numbers
 * Returns  NKW_OK; NKW_EMPTY without keys or for width 0; NKW_BAD_WIDTH for a stride less than the width;
 *          NKW_NOT_FINITE for alpha; after an error nothing is written
 *
 * Error  1.0 u of the last knot, for alpha = 0, 1/2 and 1.
 */
NKW_API nkw_result nkw_spline_knots(const nkw_spline *spline, float alpha, float *knots);

#ifdef __cplusplus
}
#endif

#endif
