/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 4: the key-frame sampler: a position and an orientation per key, one matrix at any time.
 *
 * This is the whole of the university exercise on key-frame animation that the library grew from (Oshita,
 * Keyframe Animation, Kyushu Institute of Technology): four position curves, Euler angles or quaternions, and
 * the matrix of the object. docs/coursework.md leads from each blank of the exercise to its line here.
 *
 * Outside the key times every method clamps: the first key's state before, the last one's after.
 */
#ifndef NAKAWARI_KEYFRAME_H
#define NAKAWARI_KEYFRAME_H

#include "curve.h"
#include "segment.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Where an object is, and how it is turned, at one time in seconds. */
typedef struct nkw_keyframe {
    float time;
    nkw_vec3 position;
    nkw_quat orientation; /**< unit */
} nkw_keyframe;

/** How the position goes from key to key. */
typedef enum nkw_position_method {
    /** A straight line from key to key. */
    NKW_POSITION_LINEAR,
    /**
     * Through every key, leaving along its -z axis: the tangents are minus the third column of the keys'
     * rotation matrices, of length 1 per segment whatever its duration.
     */
    NKW_POSITION_HERMITE,
    /**
     * One curve over three segments: keys 3b .. 3b+3 are the control points, neighbours share an end key, and
     * the parameter is the time over the whole group. Passes through every third key. Keys left over after the
     * last whole group hold its end; fewer than four keys hold the first.
     */
    NKW_POSITION_BEZIER,
    /** Keys k-1 .. k+2 as control points, the end keys doubled. Passes near the keys, through none. */
    NKW_POSITION_BSPLINE,
    /** Through every key; the tangent at a key is the slope of the parabola through it and its neighbours. */
    NKW_POSITION_CATMULL_ROM,
    /** The key that begins the segment, and the last key from the end on. */
    NKW_POSITION_STEP
} nkw_position_method;

/** How the orientation goes from key to key. */
typedef enum nkw_orientation_method {
    /** The key that begins the segment, and the last key from the end on. */
    NKW_ORIENTATION_STEP,
    /** YXZ Euler angles, linearly; only the angle about Y takes the shorter way round. */
    NKW_ORIENTATION_EULER,
    /** nkw_quat_slerp. */
    NKW_ORIENTATION_SLERP,
    /** YXZ Euler angles, linearly; each takes the shorter way round. */
    NKW_ORIENTATION_EULER_UNWRAPPED,
    /** nkw_quat_nlerp. */
    NKW_ORIENTATION_NLERP
} nkw_orientation_method;

/**
 * Everything that happened on the way to one matrix, so that a reader can follow it with pencil and paper.
 *
 *     position = weight[0] control[0] + ... + weight[control_count - 1] control[control_count - 1]
 *
 * up to rounding (the curve is evaluated in a more exact form, see curve.h).
 */
typedef struct nkw_keyframe_trace {
    nkw_segment segment;      /**< the segment of the time, and t in it */
    float parameter;          /**< the curve's own parameter: t, but for Bezier, where it runs over the group */
    size_t control_count;     /**< 1, 2 or 4: how many of the next three arrays are used */
    size_t key[4];            /**< the key that each control value was taken from */
    nkw_vec3 control[4];      /**< control points; Hermite: point, tangent, point, tangent */
    float weight[4];          /**< their basis weights at `parameter` */
    nkw_quat orientation[2];  /**< the orientations blended, the second with its sign turned where the arc asks */
    nkw_vec3 angles[2];       /**< Euler methods: the YXZ angles blended, the first moved by its turn; else zero */
    float half_angle;         /**< slerp and nlerp: acos of the orientations' dot product, radians; else zero */
    float orientation_weight[2]; /**< the weights of the two orientations (or angles) */
    nkw_vec3 position;        /**< the result's translation */
    nkw_mat3 rotation;        /**< the result's rotation */
} nkw_keyframe_trace;

/**
 * Checks keys[0..count): NKW_EMPTY without keys, NKW_NOT_FINITE where a number is not finite, NKW_NOT_ASCENDING
 * where a time is less than the one before, NKW_NOT_UNIT where an orientation's length is off 1 by more than
 * 1e-3; else NKW_OK. Equal times are allowed. *bad_key becomes the index of the first offender, 0 if there is
 * none; it may be NULL.
 */
NKW_API nkw_result nkw_keyframes_validate(const nkw_keyframe *keys, size_t count, size_t *bad_key);

/**
 * The matrix of the object at `time`: rotation in the 3x3 block, position in m[12..14], last row 0 0 0 1.
 *
 * keys   ascending times (nkw_keyframes_validate); others give a defined matrix of no meaning
 * time   seconds, clamped to the keys; NaN counts as before the first key
 * Gives  NKW_OK; NKW_EMPTY if there is no key and NKW_BAD_METHOD if a method is none of the above, *out then left
 *        as it was. One key gives that key.
 *
 * At a key's own time linear, Hermite, Catmull-Rom and step give the key's position bit for bit, and step and slerp
 * the matrix of its orientation.
 */
NKW_API nkw_result nkw_keyframes_sample(const nkw_keyframe *keys, size_t count, float time,
                                        nkw_position_method position, nkw_orientation_method orientation,
                                        nkw_mat4 *out);

/** The same, with every intermediate value written down. trace->position and rotation are those of the matrix. */
NKW_API nkw_result nkw_keyframes_trace(const nkw_keyframe *keys, size_t count, float time,
                                       nkw_position_method position, nkw_orientation_method orientation,
                                       nkw_keyframe_trace *trace);

#ifdef __cplusplus
}
#endif

#endif
