/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Curves of tools and files to and from fcurves (fcurve.h).
 *
 * The same cubic curve is written in five ways. h is the duration of the segment, in seconds:
 *
 *     handle tips relative to the key        this library; Maya's API, as (x, y)/3
 *     handle tips as points                  Blender
 *     slope, and the length of the handle    Unity, FBX: in units of h; OpenUSD: in seconds; Unreal: in the plane of
 *                                            time and value; without a length (Hermite) it is h/3
 *     a Hermite tangent per second           glTF CUBICSPLINE, and the splines of spline.h (TCB, PCHIP ...)
 *     control points in units of the segment CSS cubic-bezier()
 *
 * These conversions are exact, each number rounded once, except to a CUBICSPLINE track: there, segments whose handles
 * are not h/3 long are divided until the curve is within a tolerance.
 */
#ifndef NAKAWARI_DIALECT_H
#define NAKAWARI_DIALECT_H

#include "euler.h"
#include "fcurve.h"
#include "spline.h"
#include "track.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The unit of the length of a handle. */
typedef enum nkw_weight_unit {
    NKW_WEIGHT_FRACTION, /**< its time in units of the duration of the segment: Unity, FBX */
    NKW_WEIGHT_SECONDS, /**< its time in seconds: the widths of OpenUSD */
    NKW_WEIGHT_LENGTH, /**< its length in the plane of time and value: Unreal */
    NKW_WEIGHT_UNIT_MAX_ENUM = 0x7fffffff
} nkw_weight_unit;

/** Which handles of a key have a length of their own, with the numbers of Unity and Unreal; others are h/3 long. */
typedef enum nkw_weighted {
    NKW_WEIGHTED_NONE,
    NKW_WEIGHTED_IN, /**< arrive */
    NKW_WEIGHTED_OUT, /**< leave */
    NKW_WEIGHTED_BOTH,
    NKW_WEIGHTED_MAX_ENUM = 0x7fffffff
} nkw_weighted;

/** A key with slopes, in value per second. */
typedef struct nkw_slope_key {
    float time, value;
    float in_slope, out_slope;
    float in_weight, out_weight; /**< ignored where `weighted` does not name them */
    nkw_weighted weighted;
    nkw_fcurve_kind kind; /**< of the segment that the key begins */
} nkw_slope_key;
NKW_SIZE(nkw_slope_key, 32, 32);

/**
 * Converts keys with slopes.
 *
 *     time of the handle     FRACTION  weight h     SECONDS  weight     LENGTH  weight / sqrt(1 + slope^2)
 *     value of the handle    slope times its time
 *
 * A BEZIER segment with an infinite slope becomes CONSTANT, as in Unity. Handles before the first and after the last
 * key only state a slope: their length is a third of the segment beside them, for one key 1 s.
 *
 * keys     receives `count` keys
 * bad  receives the index of the first key with an error, 0 if there is none; may be NULL
 * Returns  NKW_OK; NKW_EMPTY; NKW_BAD_METHOD for an unknown kind, unit or `weighted`, and for EASE; NKW_NOT_FINITE for
 *          a time, value or weight that is not finite, and a slope that is NaN; NKW_NOT_ASCENDING. Keys before the
 *          offender are written
 *
 * Error  1.1 u of the number, for handles.
 */
NKW_API nkw_result nkw_fcurve_from_slope_keys(const nkw_slope_key *slopes, size_t count, nkw_weight_unit unit,
                                               nkw_fcurve_key *keys, size_t *bad);

/**
 * The inverse. A handle of the time (float)(h/3) is written without a weight. LINEAR segments have the slope of the
 * line, CONSTANT ones the slope 0. Handles that are not used become slope 0.
 *
 * Returns  as above; NKW_BAD_METHOD also for EASE; NKW_OUT_OF_RANGE for a vertical handle, which has no slope
 */
NKW_API nkw_result nkw_slope_keys_from_fcurve(const nkw_fcurve_key *keys, size_t count, nkw_weight_unit unit,
                                               nkw_slope_key *slopes, size_t *bad);

/** A key of Blender: three points, and its numbers for interpolation (`ipo`) and easing. */
typedef struct nkw_blender_key {
    nkw_handle left, center, right; /**< points, not relative to the key */
    int interpolation; /**< 0 constant, 1 linear, 2 Bezier, 3 .. 12 back, bounce, circ, cubic, elastic, expo, quad,
                            quart, quint, sine */
    int easing; /**< 0 auto, 1 in, 2 out, 3 in-out; auto is out for back, bounce, elastic, otherwise in */
} nkw_blender_key;
NKW_SIZE(nkw_blender_key, 32, 32);

/**
 * Converts keys of Blender. Its evaluation is that of the policy NKW_HANDLE_CONTAIN. Its behaviour outside: `extend`
 * constant and linear are HOLD and LINEAR; the modifier Cycles repeats as CYCLE, CYCLE_OFFSET, OSCILLATE.
 *
 * Returns  NKW_OK; NKW_EMPTY; NKW_NOT_FINITE; NKW_NOT_ASCENDING; NKW_BAD_METHOD for unknown numbers, and for elastic
 *          and expo, whose formulas differ from Penner's: period in frames, and a scale by 1/(1 - 2^-10). Back has
 *          Blender's default overshoot
 *
 * Error  2.0 u of the larger of the coordinates of handle and key.
 */
NKW_API nkw_result nkw_fcurve_from_blender_keys(const nkw_blender_key *blender, size_t count, nkw_fcurve_key *keys,
                                                size_t *bad);

/** The inverse. Returns NKW_BAD_METHOD also for CONSTANT_NEXT, and for an easing of CSS. */
NKW_API nkw_result nkw_blender_keys_from_fcurve(const nkw_fcurve_key *keys, size_t count, nkw_blender_key *blender,
                                                size_t *bad);

/** How a handle follows from the keys, with the names of Blender. Any other number is read as NKW_HANDLE_FREE. */
typedef enum nkw_handle_type {
    NKW_HANDLE_FREE, /**< stays */
    NKW_HANDLE_ALIGNED, /**< keeps its time, and takes the slope of the other handle */
    NKW_HANDLE_VECTOR, /**< points to the neighbouring key, a third of the distance */
    NKW_HANDLE_AUTO, /**< the mean of the slopes to both neighbours */
    NKW_HANDLE_AUTO_CLAMPED, /**< the same, level at extremes, and never beyond the value of the neighbour */
    NKW_HANDLE_TYPE_MAX_ENUM = 0x7fffffff
} nkw_handle_type;

/** The types of both handles of a key. */
typedef struct nkw_handle_types {
    nkw_handle_type in, out;
} nkw_handle_types;
NKW_SIZE(nkw_handle_types, 8, 8);

/**
 * Computes the handles of keys from their types, as Blender does after an edit, with its smoothing `None`. With the
 * durations h0, h1 and slopes d0, d1 before and after the key:
 *
 *     VECTOR          in -(h0, d0 h0)/3,     out (h1, d1 h1)/3
 *     AUTO            in -h0/2.5614 (1, m),  out h1/2.5614 (1, m),     m = (d0 + d1)/2
 *     AUTO_CLAMPED    m = 0 if the key is an extreme of the three; otherwise a handle that passes the value of its
 *                     neighbour ends there, and the other one is aligned to it
 *
 * h0 and h1 count as at most five times the other for AUTO. An AUTO handle of the first and last key is level, a VECTOR
 * there beyond the keys continues the slope inside. If both handles are ALIGNED, the out-handle follows.
 *
 * types   of each key
 *
 * Error  1.0 u of the larger slope times the duration, for the values of VECTOR and AUTO handles.
 */
NKW_API void nkw_fcurve_auto_handles(nkw_fcurve_key *keys, size_t count, const nkw_handle_types *types);

/** Makes the segment of two keys that of cubic-bezier(css[0], css[1], css[2], css[3]): kind and handles are set. */
NKW_API void nkw_fcurve_from_css(const float css[4], nkw_fcurve_key keys[2]);

/**
 * The cubic-bezier() of the segment of two keys: BEZIER, LINEAR, or EASE by a keyword of CSS.
 *
 * Returns  NKW_OK; NKW_BAD_METHOD for other kinds; NKW_OUT_OF_RANGE without a duration, for an x outside 0..1, and for
 *          handles with a value between keys of equal value
 */
NKW_API nkw_result nkw_fcurve_to_css(const nkw_fcurve_key keys[2], float css[4]);

/**
 * The keys of one component of a track: STEP is CONSTANT, CUBICSPLINE is BEZIER with handles of h/3. A spline through
 * keys (TCB, PCHIP and all methods of spline.h) is the CUBICSPLINE track of its values and nkw_spline_tangents.
 *
 * keys     receives track->count keys
 * Returns  those of nkw_track_validate; NKW_MISMATCHED for rotations, whose components are not curves of their own;
 *          NKW_OUT_OF_RANGE for the component
 */
NKW_API nkw_result nkw_fcurve_from_track(const nkw_track *track, size_t component, nkw_fcurve_key *keys,
                                              size_t *bad);

/**
 * Converts `count` fcurves to one CUBICSPLINE track of that width, from the first key of all to the last: for glTF, for
 * clips, and for tools without handles in time. Each segment begins as the Hermite segment of the values and slopes at
 * its ends, and is halved while the curve is more than `tolerance` from it at one of 31 times between. Key times
 * ascend strictly. A jump takes two keys at neighbouring floats, so that no float time lies within it. If all segments
 * are CONSTANT or CONSTANT_NEXT, as of booleans and integers, the track is STEP and exact: a step that holds the next
 * key is a step at the float after its key.
 *
 * span        for the keys, each of 3 * count values; key_interpolation is not used
 * out         receives the track, which refers to the arrays of `span`; without keys after an error
 * difference  receives the largest difference found at these times; infinity after an error; may be NULL. It is more
 *             than the tolerance only where float times end the division, at vertical tangents
 * Returns     NKW_OK; NKW_EMPTY for count 0; those of nkw_fcurve_validate; NKW_OUT_OF_RANGE for a negative or NaN
 *             tolerance; NKW_MISMATCHED if a curve whose keys begin later or end earlier than others cycles there;
 *             NKW_TOO_SMALL for too small arrays
 *
 * Stack  at most 2 KiB.
 */
NKW_API nkw_result nkw_track_from_fcurves(const nkw_fcurve *curves, size_t count, float tolerance, nkw_track_span span,
                                          nkw_track *out, float *difference);

/**
 * Converts three fcurves of Euler angles to one track of rotations, NKW_TRACK_ROTATION and CUBICSPLINE, for glTF and
 * for clips. The track follows the angles through any number of turns: keys are added until it does. Their signs are
 * those for which the cubic follows the angles.
 *
 * angles      about x, y and z, of a proper order the first, middle and last; in radians, at any number of turns
 * order       of the product; any other number is read as NKW_EULER_XYZ
 * tolerance   radians
 * difference  receives the largest angle between track and curves found, as above
 * Returns     those of nkw_track_from_fcurves
 *
 * Stack  at most 2 KiB.
 */
NKW_API nkw_result nkw_track_from_euler_fcurves(const nkw_fcurve angles[3], nkw_euler_order order, float tolerance,
                                                nkw_track_span span, nkw_track *out, float *difference);

#ifdef __cplusplus
}
#endif

#endif
