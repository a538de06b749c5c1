/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Tracks: the keys of one property, as animation files contain them.
 *
 * A track is a view of the caller's arrays, in the layout of glTF 2.0 accessors: `count` ascending key times in
 * seconds, and the values of the keys, contiguous, `width` floats each.
 *
 *     NKW_INTERPOLATION_STEP, _LINEAR    count values
 *     NKW_INTERPOLATION_CUBICSPLINE      count triples: in-tangent, value, out-tangent, each `width` floats;
 *                                        tangents per second
 *
 * Before the first key the result is the value of the first key, after the last key that of the last. At the time of a
 * key it is the value of that key, bit for bit. Segments are half open, as in segment.h. In the segment of keys k and
 * k + 1, with the duration d in seconds and the parameter t:
 *
 *     STEP          value[k]
 *     LINEAR        nkw_lerp of each component; slerp for rotations
 *     CUBICSPLINE   the Hermite curve of value[k], d out[k], value[k+1], d in[k+1]; rotations are then normalised
 *
 * Booleans and integers are STEP tracks of NKW_TRACK_FLOATS: every value is a stored one, bit for bit. A float has
 * every integer up to 2^24. Rotations as Euler angles, with any number of turns, become rotation tracks by
 * nkw_track_from_euler_fcurves (dialect.h).
 *
 * A step that holds the next key is a STEP track whose steps are at the float after each key: nkw_track_from_fcurves
 * makes it of keys of NKW_FCURVE_CONSTANT_NEXT.
 *
 * Rotations are x, y, z, w and should be unit. Stored values are used unchanged:
 *
 *   - If the mean of the squared lengths of both keys differs from 1 by at most 1e-6, LINEAR is nkw_quat_slerp.
 *   - Otherwise it is the formula of glTF without normalisation, with the angle acos |a.b|. Equal keys return that key.
 *   - NKW_TRACK_ROTATION_NORMALIZED normalises LINEAR and STEP keys before use, and CUBICSPLINE also at the times of
 *     keys. The result at a key is then unit to rounding, not the stored bits.
 *   - CUBICSPLINE does not choose the shorter arc: if a key is q and the next one is close to -q, the curve takes the
 *     longer arc, as in glTF. nkw_track_align finds and negates such keys.
 *
 * Source Khronos Group, glTF 2.0 Specification, section 3.11 and appendix C, 2021.
 *
 * Example  nkw_track track, other, made; nkw_track_span span; nkw_motion_span motion; nkw_segment s; nkw_work work;
 *          float time, value[4], *values, error, rate; uint32_t cursor; size_t n, bad;
 *
 *     n = nkw_track_value_count(&track);                          floats of all keys
 *     nkw_track_validate(&track, &bad);                           which key is wrong
 *     nkw_track_sample(&track, time, &cursor, value);             the value at a time
 *     nkw_track_sample_segment(&track, s, value);                 in a segment that is known
 *     nkw_track_sample_motion(&track, time, motion);              value, velocity, acceleration
 *     nkw_track_align(&track, values, &n, &bad);                  rotations to the shorter arcs
 *     nkw_track_difference(&track, &other, &error, work);         the largest at any time
 *     nkw_track_resample(&track, 30.0f, span, &made, &n);         keys at a rate
 *     nkw_track_resample_within(&track, 0.01f, span, &made, &rate, work);    at the lowest rate within a tolerance
 */
#ifndef NAKAWARI_TRACK_H
#define NAKAWARI_TRACK_H

#include <stdint.h>

#include "segment.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How the values of neighbouring keys are interpolated. */
typedef enum nkw_interpolation {
    NKW_INTERPOLATION_LINEAR,
    NKW_INTERPOLATION_STEP,
    NKW_INTERPOLATION_CUBICSPLINE,
    NKW_INTERPOLATION_MAX_ENUM = 0x7fffffff
} nkw_interpolation;

/** The meaning of the floats of a value. */
typedef enum nkw_track_kind {
    NKW_TRACK_FLOATS,             /**< `width` separate numbers: a scalar, morph weights, a vector, a scale */
    NKW_TRACK_ROTATION,           /**< a quaternion: width 4 */
    NKW_TRACK_ROTATION_NORMALIZED, /**< a quaternion; keys are normalised before use: width 4 */
    NKW_TRACK_KIND_MAX_ENUM = 0x7fffffff
} nkw_track_kind;

/** One property over time. The arrays belong to the caller and may be in a mapped file. */
typedef struct nkw_track {
    const float *times;  /**< count key times, seconds, ascending; equal times allowed */
    const float *values; /**< count * width floats, three times as many for CUBICSPLINE */
    size_t count;        /**< at least 1 */
    size_t width;        /**< floats in a value, at least 1 */
    nkw_track_kind kind;
    nkw_interpolation interpolation;
    /**
     * NULL, or count bytes: the interpolation of the segment that begins at each key. It replaces `interpolation`, for
     * files that choose it for each key. CUBICSPLINE is valid only if `interpolation` is CUBICSPLINE too, because that
     * determines the layout of `values`.
     */
    const unsigned char *key_interpolation;
} nkw_track;
NKW_SIZE(nkw_track, 48, 28);

/**
 * The arrays that receive a track, for every function that writes one. The function returns the track itself in an
 * nkw_track *out, whose count is the number of keys written. The arrays must not overlap those of the source, except
 * where a function permits it; `out` may be the source.
 */
typedef struct nkw_track_span {
    float *times;  /**< key_capacity floats */
    float *values; /**< key_capacity * width floats, three times as many if the track that is written is CUBICSPLINE */
    unsigned char *key_interpolation; /**< key_capacity bytes; NULL if the track has no interpolation for each key */
    size_t key_capacity; /**< the greatest number of keys */
} nkw_track_span;
NKW_SIZE(nkw_track_span, 32, 16);

/** The number of floats in `values`; SIZE_MAX if it exceeds size_t. */
NKW_API size_t nkw_track_value_count(const nkw_track *track);

/**
 * Checks a track.
 *
 * bad  receives the index of the first key with an error, 0 if there is none; may be NULL. After NKW_OK it is a
 *      warning: the first key whose rotation sends CUBICSPLINE from the key before the longer way (nkw_track_align), 0
 *      if there is none
 * Returns
 *
 *     NKW_OK             no error
 *     NKW_EMPTY          no keys, or width 0
 *     NKW_BAD_WIDTH      a rotation whose width is not 4
 *     NKW_BAD_METHOD     an unknown kind or interpolation, also of a key; CUBICSPLINE for a key of a track of another
 *                        interpolation
 *     NKW_NOT_FINITE     a time, value or tangent that is not finite
 *     NKW_NOT_ASCENDING  a time less than the one before
 *     NKW_NOT_UNIT       a rotation whose length differs from 1 by more than 1e-2
 *     NKW_TOO_SMALL      the bytes of the values exceed size_t
 */
NKW_API nkw_result nkw_track_validate(const nkw_track *track, size_t *bad);

/**
 * Writes the value at `time` to out: `width` floats. A NaN time counts as before the first key. A track that
 * nkw_track_validate rejects returns values without meaning, but nothing is read or written outside its arrays.
 *
 * cursor   NULL, or where the search begins: a segment, which receives the segment found. Any number is a valid cursor.
 *          Fast while the time changes slowly, forward or backward. The result has the same bits
 * Returns  NKW_OK; NKW_EMPTY without keys or for width 0; NKW_BAD_WIDTH for a rotation whose width is not 4; after an
 *          error nothing is written to `out`
 *
 * Error  5.7 u of the largest of the two values and, for CUBICSPLINE, of the tangents per segment (LINEAR at most 3.0
 *        u: 2.0 of nkw_lerp, 1 of t). For rotations LINEAR 3.9 u, with keys unit to rounding and up to 1.5 rad apart
 *        between the quaternions (5.7 u with keys unit to 4e-7), and CUBICSPLINE 4.0 u, up to 1 rad. All are errors
 *        relative to the exact value at `time`: they include the rounding of t and of the duration of the segment.
 */
NKW_API nkw_result nkw_track_sample(const nkw_track *track, float time, uint32_t *cursor, float *out);

/**
 * The same for a known segment: the result of nkw_segment_find for track->times. For tracks that share their key times.
 * Any other t is clamped to 0..1, and a NaN counts as 0.
 */
NKW_API nkw_result nkw_track_sample_segment(const nkw_track *track, nkw_segment segment, float *out);

/**
 * The value at `time`, and its velocity and acceleration. The value has the bits of nkw_track_sample. At a key the
 * derivatives are those of the segment that begins there; at the last key, of the segment that ends there. Before the
 * first and after the last key, and for STEP, they are 0.
 *
 * Of numbers they are the first and second derivative, per second. In a segment of the duration h between values a and
 * b, with the parameter t, s = 1 - t, and the tangents v0, v1 per second:
 *
 *     LINEAR        velocity = (b - a)/h                                             acceleration = 0
 *     CUBICSPLINE   velocity = 6 t s (b - a)/h + s (s - 2t) v0 + t (t - 2s) v1
 *                   acceleration = ((6 - 12t) (b - a)/h + (6t - 4) v0 + (6t - 2) v1)/h
 *
 * Of rotations they are the angular velocity and acceleration in the outer frame. With the four numbers p of the
 * Hermite curve, whose direction is the orientation, and p* the conjugate; 0 where p is 0:
 *
 *     LINEAR        velocity = 2 log(b a^-1)/h along the shorter arc           acceleration = 0
 *     CUBICSPLINE   velocity = 2 Im(p' p*)/|p|^2                               Im: the vector part
 *                   acceleration = 2 Im(p'' p*)/|p|^2 - 2 (p.p')/|p|^2 velocity
 *
 * out      receives `width` floats in each of its arrays that is not NULL; of rotations 4, 3 and 3
 * Returns  as nkw_track_sample
 *
 * Error  1.0 u of the larger of the derivative and the largest of |b - a|/h, |v0|, |v1|, divided by h for the second,
 *        for numbers. Of rotations 1.0 u of the velocity, of its length for LINEAR, of S = 2 |p'|/|p| for CUBICSPLINE;
 *        1.0 u of the acceleration, of 2 |p''|/|p| + S^2; for keys up to 1 rad apart. All at the rounded t of the
 *        segment.
 */
NKW_API nkw_result nkw_track_sample_motion(const nkw_track *track, float time, nkw_motion_span out);

/**
 * Aligns the signs of rotations: each key has a dot product with the key before that is not negative. A key is negated
 * as a whole, with both tangents for CUBICSPLINE. The rotations at the keys and the angular velocities there stay;
 * CUBICSPLINE then takes the shorter arc everywhere, LINEAR and STEP tracks keep their rotations at all times.
 *
 * Without values it only counts; nkw_track_validate warns of such keys of CUBICSPLINE. Its formula in glTF does not
 * negate: the curve between two keys 90 degrees apart, one of them negated, passes through -135 degrees and turns by
 * 270 degrees. Few files intend that.
 *
 * values   receives the nkw_track_value_count values; may be the array of the track. A track of numbers is copied. NULL:
 *          nothing is written, the keys are only counted
 * negated  receives how many keys are negated; may be NULL
 * first    receives the index of the first of them, 0 if there is none; may be NULL
 * Returns  as nkw_track_sample; after an error nothing is written to `values`, and 0 to the others
 */
NKW_API nkw_result nkw_track_align(const nkw_track *track, float *values, size_t *negated, size_t *first);

/** Bytes of working memory to compare tracks of this width. */
#define NKW_TRACK_WORK(width) (2 * (width) * sizeof(float))

/**
 * The largest difference of two tracks, from the first key of `track` to its last: of a component, or, for rotations,
 * the angle between them in radians. It is measured at the keys of both tracks and at 1/4, 1/2 and 3/4 between two
 * keys. The difference between these times may be larger.
 *
 * difference  receives the result; infinity after an error; NaN if a value is NaN
 * work        at least NKW_TRACK_WORK(width)
 * Returns     NKW_OK; NKW_EMPTY without keys or for width 0; NKW_BAD_WIDTH for a rotation whose width is not 4;
 *             NKW_MISMATCHED for different widths, or for a rotation and numbers; NKW_TOO_SMALL for the working memory
 */
NKW_API nkw_result nkw_track_difference(const nkw_track *track, const nkw_track *other, float *difference,
                                        nkw_work work);

/**
 * Resamples (bakes) a track at a uniform rate: its keys are samples of the source. A clip finds the keys of such tracks
 * without a search. The keys are at nkw_timeline_time({first, rate}, k), k = 0, 1, 2 ..., up to the first time that
 * is not less than the last key time: one key for a track of one key or of duration 0.
 *
 *     source                                                 result
 *     STEP in every segment                                  STEP
 *     any other interpolation                                LINEAR
 *     NKW_TRACK_ROTATION or NKW_TRACK_ROTATION_NORMALIZED    NKW_TRACK_ROTATION
 *
 * If every key of the source is at the time of a new key, the resampled track has the values of the source at all
 * times: for a STEP source, and for a LINEAR source without two keys at the same time. nkw_track_difference measures
 * the error of others. If the duration is not a multiple of 1 / rate, the last key is later than that of the source, by
 * less than 1 / rate. Use the duration of the source for loops.
 *
 * rate     keys per second, positive and finite
 * span     for all keys; values of `width` floats. Without arrays (times NULL) only the keys are counted
 * out      receives the track, which refers to the arrays of `span`; without keys after an error; may be `track`
 * count    receives the number of keys that the track has or needs; 0 after an error other than NKW_TOO_SMALL; may be
 *          NULL
 * Returns  NKW_OK; NKW_EMPTY without keys or for width 0; NKW_BAD_WIDTH for a rotation whose width is not 4;
 *          NKW_OUT_OF_RANGE for an invalid rate; NKW_NOT_FINITE if the first, the last or the resampled last time is
 *          not finite; NKW_TOO_MANY for 2^31 keys or more; NKW_TOO_SMALL without arrays or for too small ones
 */
NKW_API nkw_result nkw_track_resample(const nkw_track *track, float rate, nkw_track_span span, nkw_track *out,
                                      size_t *count);

/**
 * Resamples a track at the lowest of a few rates whose error, nkw_track_difference, is within `tolerance` (radians for
 * rotations), for a smaller clip. The rates are those of n, n/2, n/4 ... 1 segments, rounded up, over the duration,
 * where n is the number of segments of the source; for evenly spaced keys these are rate, rate/2, rate/4 ... The last
 * key is at the end of the source, to rounding.
 *
 * span     for at least as many keys as the source has
 * rate     receives the rate; 0 after an error; 1 for a track of one key or of duration 0, which becomes one key
 * work     at least NKW_TRACK_WORK(width)
 * Returns  NKW_OK; NKW_EMPTY and NKW_BAD_WIDTH as above; NKW_OUT_OF_RANGE for a tolerance that is negative or NaN;
 *          NKW_TOO_SMALL for the arrays or the working memory; NKW_NO_RATE if no rate is within the tolerance
 *
 * Stack  at most 2 KiB.
 */
NKW_API nkw_result nkw_track_resample_within(const nkw_track *track, float tolerance, nkw_track_span span,
                                             nkw_track *out, float *rate, nkw_work work);

#ifdef __cplusplus
}
#endif

#endif
