/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Chains of cubic segments as paths: (arc) length, places at a length, constant speed, moving frames, polylines.
 *
 * A polycurve is an array of cubic segments of one kind, each of which usually begins where the one before ends. A
 * place on it is a segment and its parameter, an nkw_segment.
 *
 *     L(t) = integral of |p'(u)| du, u from 0 to t
 *
 * has no closed form. It is integrated by the Gauss-Legendre rule of 8 points, between the minima of |p'|, in intervals
 * that are halved until the two halves agree with the whole, in binary64. A minimum is a zero of p'.p''; where |p'| has
 * a corner, at cusps and where the point turns back on a line, it is there. A place at a length is the root of
 * L(t) = length, by Newton's method within a bracket.
 *
 * Source Eberly, Moving Along a Curve with Specified Speed, 2007.
 *        Wang, Juettler, Zheng, Liu, Computation of Rotation Minimizing Frames, ACM TOG 27(1), 2008.
 */
#ifndef NAKAWARI_POLYCURVE_H
#define NAKAWARI_POLYCURVE_H

#include "curve.h"
#include "segment.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A chain of cubic segments. */
typedef struct nkw_polycurve {
    const nkw_vec3_cubic *cubics; /**< count segments; belongs to the caller */
    size_t count;
    nkw_cubic_kind kind; /**< of all segments; an unknown kind is read as NKW_CUBIC_HERMITE */
} nkw_polycurve;
NKW_SIZE(nkw_polycurve, 24, 12);

/**
 * The length of a cubic segment from parameter `from` to `to`; negative if to < from.
 *
 * Returns  the length; infinity beyond the largest float; NaN if a control value or a parameter is not finite
 *
 * Error  1.0 u of the length, or, where it is larger, 2^-16 u of the length of the control polygon.
 */
NKW_API float nkw_vec3_cubic_length(const nkw_vec3_cubic *cubic, float from, float to, nkw_cubic_kind kind);

/**
 * The motion on a polycurve at a place, by the parameter: nkw_vec3_cubic_evaluate. An index beyond the last segment is
 * the last one; an empty polycurve has the point 0.
 */
NKW_API nkw_vec3_motion nkw_polycurve_evaluate(const nkw_polycurve *curve, nkw_segment at);

/** The number of floats in a table of lengths: one at each of the even parameters 0, 1/steps .. 1 of each segment. */
#define NKW_POLYCURVE_LENGTHS(count, steps) ((count) * (steps) + 1)

/**
 * Computes a table of lengths: lengths[k * steps + i] is the length of the curve up to parameter i/steps of segment k;
 * the last one is the length of the whole. The sum is in binary64; each entry is rounded once.
 *
 * steps    at least 1; 4 is enough for nkw_polycurve_at_length to take two or three steps of Newton's method
 * Returns  NKW_OK; NKW_EMPTY without segments or for steps 0; NKW_TOO_SMALL if length_count is less than
 *          NKW_POLYCURVE_LENGTHS(count, steps); NKW_NOT_FINITE if a length is not finite: the entries from there on
 *          repeat the last finite one. After other errors nothing is written
 */
NKW_API nkw_result nkw_polycurve_measure(const nkw_polycurve *curve, size_t steps, float *lengths,
                                         size_t length_count);

/**
 * The place at a length from the start, clamped to the curve; NaN counts as 0. Places at equal distances of length run
 * along the curve at constant speed: length = speed * time.
 *
 * lengths  the table of nkw_polycurve_measure for this curve: length_count is NKW_POLYCURVE_LENGTHS(count, steps), from
 *          which the steps follow. With other numbers the place has no meaning, but is a place of the curve; with
 *          fewer than count + 1 it is the start
 *
 * Error  1.0 u of the length of the whole curve: the difference of the length at the place and `length`, where the
 *        curve does not stand still; the parameter is rounded to a float, which adds half an ULP of t times |p'(t)|.
 */
NKW_API nkw_segment nkw_polycurve_at_length(const nkw_polycurve *curve, const float *lengths, size_t length_count,
                                            float length);

/** A right-handed frame on a curve: three unit vectors, binormal = tangent x normal. */
typedef struct nkw_curve_frame {
    nkw_vec3 tangent, normal, binormal;
} nkw_curve_frame;
NKW_SIZE(nkw_curve_frame, 36, 36);

/**
 * The Frenet frame: the normal points to the centre of curvature.
 *
 *     tangent = p'/|p'|     binormal = (p' x p'')/|p' x p''|     normal = binormal x tangent
 *
 * The frame is not defined where p' and p'' are parallel (straight lines, inflections), and turns by half a turn across
 * an inflection. There, where |p' x p''| <= 2^-20 |p'||p''|, the normal is the part of `before` perpendicular to the
 * tangent; if that is 0 too, it is nkw_vec3_perpendicular of the tangent. Where p' = 0, the tangent has the direction
 * of p'', which is that of the curve after the point; if p'' is 0 too, the tangent is the x axis. At the end of a
 * segment that comes to rest the curve has the direction of -p'': nkw_polycurve_frenet knows the place and the rest of
 * the curve.
 *
 * before   the normal of the frame before, or any direction that the normal should be near. Of a point whose
 *          acceleration is 0 the normal is the part of `before` perpendicular to the velocity: a frame from a tangent
 *          and a direction up
 *
 * Error  1.0 u for each vector, where |p' x p''| >= |p'||p''|/8.
 */
NKW_API nkw_curve_frame nkw_curve_frame_frenet(const nkw_vec3_motion *point, nkw_vec3 before);

/**
 * The Frenet frame of a polycurve at a place, of a curve that may come to rest there: nkw_curve_frame_frenet of its
 * derivatives. Where p' = 0, the frame is the limit from inside of the segment. The tangent then has the direction of
 * p'', at the end, t = 1, that of -p''; where p'' = 0 too, that of p'''; where all are 0, it is the x axis. The
 * binormal has the direction of p'' x p'''.
 *
 * before   as above
 *
 * Error  1.0 u for each vector, where |p' x p''| >= |p'||p''|/8; where p' = 0, the same of p'' and p'''.
 */
NKW_API nkw_curve_frame nkw_polycurve_frenet(const nkw_polycurve *curve, nkw_segment at, nkw_vec3 before);

/**
 * The frame at point b after the frame `from` at point a, turned about the tangent as little as possible (double
 * reflection): reflected in the plane between a and b, then in the plane that maps the tangent to `tangent`.
 *
 * tangent  the tangent at b, need not be unit; 0 takes the direction from a to b, and if that is 0 too, returns `from`
 *
 * The turn about the tangent deviates from that of the rotation-minimising frame of a smooth curve by the 4th power of
 * the distance of a and b, and along a curve by the 4th power of the step.
 */
NKW_API nkw_curve_frame nkw_curve_frame_transport(const nkw_curve_frame *from, nkw_vec3 a, nkw_vec3 b,
                                                  nkw_vec3 tangent);

/** The turns of the frames of a polycurve about its tangents. */
typedef enum nkw_polycurve_ends {
    NKW_POLYCURVE_OPEN,  /**< turned as little as possible from the first frame on */
    NKW_POLYCURVE_CLOSED, /**< the last frame is the first: the difference is distributed evenly over the length */
    NKW_POLYCURVE_ENDS_MAX_ENUM = 0x7fffffff
} nkw_polycurve_ends;

/**
 * Rotation-minimising frames at the even parameters of nkw_polycurve_measure: the first normal is the part of `up`
 * perpendicular to the tangent, the other frames follow by nkw_curve_frame_transport. Where p' = 0, the tangent is that
 * of nkw_polycurve_frenet. CLOSED is for curves whose ends have one point and one tangent; there the last frame has the
 * bits of the first.
 *
 * up       the direction that the first normal should be near
 * ends     any other number is read as NKW_POLYCURVE_OPEN
 * Returns  NKW_OK; NKW_EMPTY without segments or for steps 0; NKW_TOO_SMALL if frame_count is less than
 *          NKW_POLYCURVE_LENGTHS(count, steps); after an error nothing is written
 *
 * Stack  at most 2 KiB.
 */
NKW_API nkw_result nkw_polycurve_frames(const nkw_polycurve *curve, size_t steps, nkw_vec3 up, nkw_polycurve_ends ends,
                                        nkw_curve_frame *frames, size_t frame_count);

/**
 * A polyline that deviates from the curve by at most `tolerance`: the start of the first segment, then the ends of
 * intervals, each segment halved until
 *
 *     |p''|max w^2/8 <= tolerance,     w the width of the interval in t
 *
 * which bounds the distance between curve and chord at every t. Points are rounded to floats, which adds 1 u of the
 * coordinates. Gaps between segments are joined by a line.
 *
 * points   receives up to `capacity` points; NULL with capacity 0 asks for the count
 * count    receives the number of points of the whole polyline, also if capacity is less; 0 after other errors
 * Returns  NKW_OK; NKW_TOO_SMALL for capacity; NKW_EMPTY without segments; NKW_OUT_OF_RANGE if tolerance is not
 *          positive; NKW_NOT_FINITE for a control value that is not finite; NKW_TOO_MANY if a segment needs intervals
 *          of less than 2^-20
 */
NKW_API nkw_result nkw_polycurve_flatten(const nkw_polycurve *curve, float tolerance, nkw_vec3 *points, size_t capacity,
                                         size_t *count);

#ifdef __cplusplus
}
#endif

#endif
