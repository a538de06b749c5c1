/* SPDX-License-Identifier: MIT */
/**
 * @file
 * B-splines of any degree up to 15, with weights (NURBS): curves of CAD and camera tools, exact circles.
 *
 * `count` control points p, their weights w and count + degree + 1 ascending knots u determine the curve
 *
 *     c(u) = sum of Ni(u) wi pi / sum of Ni(u) wi,       u[degree] <= u <= u[count]
 *
 *     Ni of degree 0      1 from u[i] to u[i + 1], 0 elsewhere
 *     Ni of degree d      (u - u[i])/(u[i + d] - u[i]) Ni  +  (u[i + d + 1] - u)/(u[i + d + 1] - u[i + 1]) N(i + 1)
 *                           of degree d - 1, where 0/0 counts as 0
 *
 * The curve is degree - m times continuously differentiable at a knot that is stored m times. A knot stored degree
 * times is a corner at a control point, and degree + 1 times a jump. Without weights it is the B-spline.
 *
 * Computed in binary64; each number is rounded once.
 *
 * Source Piegl, Tiller, The NURBS Book, 2nd edition, 1997; de Boor, A Practical Guide to Splines, 1978.
 */
#ifndef NAKAWARI_NURBS_H
#define NAKAWARI_NURBS_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The greatest degree. */
#define NKW_NURBS_DEGREE 15

/** A curve. The arrays belong to the caller. */
typedef struct nkw_nurbs {
    const float *points;  /**< control point i: `width` floats from points[i * stride] on */
    const float *weights; /**< count positive numbers; NULL: all 1 */
    const float *knots;   /**< count + degree + 1 numbers, ascending; equal ones allowed */
    size_t count;         /**< at least degree + 1 */
    size_t degree;        /**< 0 .. NKW_NURBS_DEGREE; 3 is cubic */
    size_t width;         /**< floats in a point, at least 1 */
    size_t stride;        /**< floats from a point to the next, at least width */
} nkw_nurbs;
NKW_SIZE(nkw_nurbs, 56, 28);

/** The number of knots of a curve. */
#define NKW_NURBS_KNOTS(count, degree) ((count) + (degree) + 1)

/** Knots that need no data. */
typedef enum nkw_nurbs_knots_kind {
    NKW_NURBS_KNOTS_CLAMPED, /**< degree + 1 equal knots at each end: the curve begins and ends at control points */
    NKW_NURBS_KNOTS_UNIFORM,  /**< even steps: the uniform B-spline; degree 3 is nkw_bspline */
    NKW_NURBS_KNOTS_KIND_MAX_ENUM = 0x7fffffff
} nkw_nurbs_knots_kind;

/**
 * Checks a curve.
 *
 * bad      receives the index of the first point, weight or knot with an error, 0 if there is none; may be NULL
 * Returns
 *
 *     NKW_OK             no error
 *     NKW_EMPTY          no points, or width 0
 *     NKW_TOO_MANY       degree above NKW_NURBS_DEGREE
 *     NKW_TOO_SMALL      fewer than degree + 1 points
 *     NKW_BAD_WIDTH      a stride less than the width
 *     NKW_NOT_FINITE     a knot, a point or a weight that is not finite
 *     NKW_NOT_ASCENDING  a knot less than the one before, or knot `count` if the domain is empty: u[count] = u[degree]
 *     NKW_TOO_MANY       a knot that is equal to the degree + 1 knots before it
 *     NKW_BAD_WEIGHTS    a weight that is not positive
 */
NKW_API nkw_result nkw_nurbs_validate(const nkw_nurbs *curve, size_t *bad);

/**
 * The point of the curve at u with its first and second derivative by u. u is clamped to the domain u[degree] ..
 * u[count]; NaN counts as its start. At a knot the derivatives are those of the span that begins there; at the end of
 * the domain, of the last span.
 *
 * out      each array that is not NULL receives `width` floats
 * Returns  NKW_OK; the code of nkw_nurbs_validate for a curve without points, of fewer than degree + 1, or of a degree
 *          or a stride out of range, for which nothing is written. Other errors of a curve return values without
 *          meaning; nothing is read or written outside the arrays
 *
 * Error  1.0 u of the largest coordinate of all points for the value, of weights in 2^-10 .. 2^10 and degrees up to 7;
 *        the derivatives the same, of the larger of the derivative and the largest coordinate times d, d^2 for the
 *        acceleration, d = degree over the shortest span that the point depends on.
 */
NKW_API nkw_result nkw_nurbs_evaluate(const nkw_nurbs *curve, float u, nkw_motion_span out);

/**
 * Writes NKW_NURBS_KNOTS(count, degree) knots, whose domain begins at `from` and ends at `to`. Inner knots are even:
 * knot degree + i is from + i (to - from)/(count - degree), rounded once.
 *
 * kind     any other number is read as NKW_NURBS_KNOTS_CLAMPED
 * Returns  NKW_OK; NKW_TOO_MANY for a degree above NKW_NURBS_DEGREE; NKW_TOO_SMALL for fewer than degree + 1 points;
 *          NKW_NOT_FINITE for `from` or `to`; NKW_NOT_ASCENDING if from >= to; after an error nothing is written
 */
NKW_API nkw_result nkw_nurbs_make_knots(size_t count, size_t degree, float from, float to, nkw_nurbs_knots_kind kind,
                                        float *knots);

#ifdef __cplusplus
}
#endif

#endif
