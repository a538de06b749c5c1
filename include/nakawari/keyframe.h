/* SPDX-License-Identifier: MIT */
/**
 * @file
 * The key-frame sampler: the matrix of an object at any time, from keys with a position and an orientation.
 *
 * It covers the university exercise on key-frame animation from which the library started (Oshita, Keyframe Animation,
 * Kyushu Institute of Technology): four position curves, Euler angles or quaternions, and the matrix of the object.
 * docs/coursework.md links each blank of the exercise to its function.
 *
 * Outside the key times every method clamps: to the state of the first key before, and of the last key after.
 *
 * Example  nkw_keyframe keys[2]; float time; nkw_mat4 m; size_t bad; nkw_keyframe_options options;
 *          nkw_keyframe_trace all;
 *
 *     nkw_keyframes_validate(keys, 2, &bad);                      which key is wrong
 *     nkw_keyframes_sample(keys, 2, time, NKW_POSITION_LINEAR, NKW_ORIENTATION_SLERP, &m);    the matrix at a time
 *     nkw_keyframes_sample_as(keys, 2, time, &options, &m);       by options, also by the exercise's own rule
 *     nkw_keyframes_trace(keys, 2, time, &options, &all);         all intermediate numbers
 */
#ifndef NAKAWARI_KEYFRAME_H
#define NAKAWARI_KEYFRAME_H

#include "curve.h"
#include "segment.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The position and the orientation of an object at a time in seconds. */
typedef struct nkw_keyframe {
    float time;
    nkw_vec3 position;
    nkw_quat orientation; /**< unit */
} nkw_keyframe;
NKW_SIZE(nkw_keyframe, 32, 32);

/** How the position is interpolated. */
typedef enum nkw_position_method {
    /** A straight line from key to key. */
    NKW_POSITION_LINEAR,
    /**
     * Passes through every key in the direction of its -z axis: each tangent is the negated third column of the key's
     * rotation matrix, of length 1 per segment for every duration.
     */
    NKW_POSITION_HERMITE,
    /**
     * One curve over three segments: keys 3b .. 3b+3 are its control points, and its parameter is 0 at the time of key
     * 3b and 1 at that of key 3b+3. Neighbouring curves share an end key, so the path passes through every third key.
     * After the last complete group the position stays at its end; with fewer than four keys, at the first key.
     */
    NKW_POSITION_BEZIER,
    /** Keys k-1 .. k+2 are the control points of segment k, the end keys repeated. Passes near the keys. */
    NKW_POSITION_BSPLINE,
    /** Passes through every key; its tangent is that of the parabola through the key and its two neighbours. */
    NKW_POSITION_CATMULL_ROM,
    /** The position of the first key of the segment; from the last key on, that of the last key. */
    NKW_POSITION_STEP,
    /** The position of the next key; at the time of a key, that of the key. Before the first key, that of the first. */
    NKW_POSITION_STEP_NEXT,
    /**
     * The methods of spline.h that need the neighbouring keys only: passes through every key, with the tangents of
     * NKW_SPLINE_CENTRIPETAL, _PCHIP, _AKIMA or _MAKIMA and free ends. The position has the bits of a CUBICSPLINE track
     * of all keys.
     */
    NKW_POSITION_CENTRIPETAL,
    NKW_POSITION_PCHIP,
    NKW_POSITION_AKIMA,
    NKW_POSITION_MAKIMA,
    NKW_POSITION_METHOD_MAX_ENUM = 0x7fffffff
} nkw_position_method;

/** How the orientation is interpolated. */
typedef enum nkw_orientation_method {
    /** The orientation of the first key of the segment; from the last key on, that of the last key. */
    NKW_ORIENTATION_STEP,
    /** YXZ Euler angles, linearly; only the angle about Y is unwrapped (nkw_euler_lerp). */
    NKW_ORIENTATION_EULER,
    /** nkw_quat_slerp. */
    NKW_ORIENTATION_SLERP,
    /** YXZ Euler angles, linearly; all three are unwrapped. */
    NKW_ORIENTATION_EULER_UNWRAPPED,
    /** nkw_quat_nlerp. */
    NKW_ORIENTATION_NLERP,
    /** nkw_rotation_from_squad of the four keys around the segment, the end keys repeated. It does not use the times. */
    NKW_ORIENTATION_SQUAD,
    /** nkw_rotation_from_catmull_rom of these keys and their times: the angular velocity is continuous. */
    NKW_ORIENTATION_CATMULL_ROM,
    /** nkw_rotation_from_bspline of these keys. Passes near them. */
    NKW_ORIENTATION_BSPLINE,
    NKW_ORIENTATION_METHOD_MAX_ENUM = 0x7fffffff
} nkw_orientation_method;

/**
 * What the sampler does where the exercise states no rule, but its program has one (docs/coursework.md):
 *
 *     time at an inner key     EXERCISE: the segment that ends there, t = 1; LIBRARY: the one that begins there, t = 0
 *     STEP from the last key   EXERCISE: the key before it; LIBRARY: the last key
 *     BEZIER beyond the keys   EXERCISE: the curve continues, if the end key ends a group of four; LIBRARY: clamps
 *     EULER, pitch of a key    EXERCISE: ConvMatToEuler, which loses part of the rotation at 90 degrees; LIBRARY:
 *                              nkw_euler_from_quat
 *     one key                  EXERCISE: NKW_EMPTY; LIBRARY: that key
 */
typedef enum nkw_keyframe_rule {
    NKW_KEYFRAME_RULE_LIBRARY,
    NKW_KEYFRAME_RULE_EXERCISE,
    NKW_KEYFRAME_RULE_MAX_ENUM = 0x7fffffff
} nkw_keyframe_rule;

/** How nkw_keyframes_sample_as samples. Zero is linear, step, by the library's rule. */
typedef struct nkw_keyframe_options {
    nkw_position_method position;
    nkw_orientation_method orientation;
    nkw_keyframe_rule rule;
} nkw_keyframe_options;
NKW_SIZE(nkw_keyframe_options, 12, 12);

/**
 * All intermediate values of one matrix, so that a reader can check it by hand. To rounding,
 *
 *     position = weight[0] control[0] + ... + weight[control_count - 1] control[control_count - 1]
 *
 * The sampler evaluates the curve in a more exact form (curve.h).
 */
typedef struct nkw_keyframe_trace {
    nkw_segment segment;      /**< the segment of the time, and t in it */
    float parameter;          /**< the parameter of the curve: t; for Bezier 0..1 over the group of four keys */
    size_t control_count;     /**< 1, 2 or 4: the number of elements used in the next three arrays */
    size_t key[4];            /**< the key of each control value */
    nkw_vec3 control[4];      /**< control points; Hermite: point, tangent, point, tangent */
    float weight[4];          /**< their basis weights at `parameter` */
    nkw_quat orientation[2];  /**< the orientations interpolated, the second negated for the shorter arc */
    nkw_vec3 angles[2];       /**< Euler methods: the YXZ angles, the first unwrapped; otherwise zero */
    float half_angle;         /**< slerp and nlerp: acos of the dot product, radians; otherwise zero */
    float orientation_weight[2]; /**< the weights of the two orientations (or angles); 0 for the curves of four keys */
    nkw_vec3 angular_velocity;   /**< curves of four keys: radians per second, outer frame; otherwise zero */
    nkw_vec3 position;        /**< the translation of the result */
    nkw_mat3 rotation;        /**< the rotation of the result */
} nkw_keyframe_trace;
NKW_SIZE(nkw_keyframe_trace, 256, 224);

/**
 * Checks `count` keys. Equal times are valid.
 *
 * bad  receives the index of the first key with an error, 0 if there is none; may be NULL
 * Returns  NKW_OK; NKW_EMPTY without keys; NKW_NOT_FINITE for a number that is not finite; NKW_NOT_ASCENDING for a time
 *          less than the one before; NKW_NOT_UNIT for an orientation whose length differs from 1 by more than 1e-2
 */
NKW_API nkw_result nkw_keyframes_validate(const nkw_keyframe *keys, size_t count, size_t *bad);

/**
 * The matrix of the object at `time`: rotation in the 3x3 block, position in m[12..14], last row 0 0 0 1.
 *
 * keys     valid (nkw_keyframes_validate); other keys return a defined matrix without meaning
 * time     seconds, clamped to the key times; NaN counts as before the first key
 * out      receives the matrix; after an error it is unchanged
 * Returns  NKW_OK; NKW_EMPTY without keys; NKW_BAD_METHOD for an unknown method
 *
 * At the time of a key, all methods but Bezier and B-spline return the position of the key bit for bit; step, slerp,
 * squad and Catmull-Rom return the matrix of its orientation.
 *
 * Stack  at most 3 KiB.
 */
NKW_API nkw_result nkw_keyframes_sample(const nkw_keyframe *keys, size_t count, float time,
                                        nkw_position_method position, nkw_orientation_method orientation,
                                        nkw_mat4 *out);

/**
 * nkw_keyframes_sample with the methods and the rule of `options`.
 *
 * Returns  NKW_BAD_METHOD also for an unknown rule; NKW_EMPTY also for one key by the rule of the exercise
 *
 * Stack  at most 3 KiB.
 */
NKW_API nkw_result nkw_keyframes_sample_as(const nkw_keyframe *keys, size_t count, float time,
                                           const nkw_keyframe_options *options, nkw_mat4 *out);

/**
 * The same with all intermediate values. trace->position and trace->rotation are those of the matrix.
 *
 * Stack  at most 4 KiB.
 */
NKW_API nkw_result nkw_keyframes_trace(const nkw_keyframe *keys, size_t count, float time,
                                       const nkw_keyframe_options *options, nkw_keyframe_trace *trace);

#ifdef __cplusplus
}
#endif

#endif
