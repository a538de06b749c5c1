/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 4: a track: the keys of one property, as animation files give them.
 *
 * A track is a view over the caller's arrays, in the very layout of glTF 2.0 accessors: `count` ascending key times in
 * seconds, and the keys' values one after the other, `width` floats each.
 *
 *     NKW_INTERPOLATION_STEP, _LINEAR    count values
 *     NKW_INTERPOLATION_CUBICSPLINE      count triples: in-tangent, value, out-tangent, each `width` floats;
 *                                        tangents per second
 *
 * Before the first key its value holds, after the last one the last's. At a key's own time its value comes back bit for
 * bit. Segments are half open, as in segment.h. Between keys k and k + 1, d seconds apart and t of the way:
 *
 *     STEP          value[k]
 *     LINEAR        nkw_lerp of each component; rotations by slerp
 *     CUBICSPLINE   the Hermite curve of value[k], d out[k], value[k+1], d in[k+1]; rotations normalised afterwards
 *
 * Rotations are x, y, z, w and should be unit; what is stored is used as it is. Between unit keys it is nkw_quat_slerp;
 * where the squares of their lengths are off 1 by more than rounding, 1e-6 in the mean, it is glTF's formula on the
 * keys as they stand, with the angle acos |a.b|, and equal keys hold. NKW_TRACK_ROTATION_NORMALIZED normalises LINEAR
 * and STEP keys as they are read, and gives those of CUBICSPLINE normalised at their own times: a key's own value is
 * then unit to rounding, instead of the stored bits.
 *
 * Source Khronos Group, glTF 2.0 Specification, section 3.11 and appendix C, 2021.
 */
#ifndef NAKAWARI_TRACK_H
#define NAKAWARI_TRACK_H

#include <stdint.h>

#include "segment.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How the values go from key to key. */
typedef enum nkw_interpolation {
    NKW_INTERPOLATION_LINEAR,
    NKW_INTERPOLATION_STEP,
    NKW_INTERPOLATION_CUBICSPLINE
} nkw_interpolation;

/** What the floats of a value mean. */
typedef enum nkw_track_kind {
    NKW_TRACK_FLOATS,             /**< `width` numbers of their own: a scalar, morph weights, a vector, a scale */
    NKW_TRACK_ROTATION,           /**< a quaternion: width 4 */
    NKW_TRACK_ROTATION_NORMALIZED /**< a quaternion whose keys are normalised as they are read */
} nkw_track_kind;

/** One property over time. Nothing is owned; the arrays may lie in a mapped file. */
typedef struct nkw_track {
    const float *times;  /**< count key times, seconds, ascending; equal times allowed */
    const float *values; /**< count * width floats, three times as many for CUBICSPLINE */
    size_t count;        /**< at least 1 */
    size_t width;        /**< floats in a value, at least 1 */
    nkw_track_kind kind;
    nkw_interpolation interpolation;
    /**
     * NULL, or count bytes: the interpolation of the segment that begins at each key, in place of the one above; for
     * files that choose it key by key. CUBICSPLINE only where the one above is: it says how `values` are stored.
     */
    const unsigned char *key_interpolation;
} nkw_track;

/** How many floats stand in `values`; SIZE_MAX where size_t does not hold so many. */
NKW_API size_t nkw_track_value_count(const nkw_track *track);

/**
 * Checks a track: NKW_EMPTY without keys or width; NKW_BAD_WIDTH for a rotation whose width is not 4; NKW_BAD_METHOD for
 * an unknown kind or interpolation, a key's interpolation that is unknown, or CUBICSPLINE in a track that is not; NKW_NOT_FINITE
 * where a time, value or tangent is not finite; NKW_NOT_ASCENDING where a time is less than the one before;
 * NKW_NOT_UNIT where a rotation's value is off unit length by more than 1e-2; NKW_TOO_SMALL where size_t does not hold
 * the bytes of the values. *bad_key becomes the index of the first offending key, 0 if there is none; it may be NULL.
 */
NKW_API nkw_result nkw_track_validate(const nkw_track *track, size_t *bad_key);

/**
 * The value at `time`: writes `width` floats. A NaN time counts as before the first key. An empty track writes
 * nothing. A track that would not validate gives values of no meaning, but nothing is read or written outside its
 * arrays.
 *
 * Error  4.8 u: of numbers, u of the largest of the two values and, for CUBICSPLINE, of the tangents per segment
 *        (LINEAR 3.0 u at most: 2.0 of nkw_lerp, 1 of t); of rotations, LINEAR 3.5 u with keys up to 1.5 rad apart
 *        between the quaternions, CUBICSPLINE 3.8 u up to 1 rad. All for the time itself: t is rounded on the way, and
 *        the segment's duration.
 */
NKW_API void nkw_track_sample(const nkw_track *track, float time, float *out);

/**
 * The same with a cursor: *cursor is the segment found last, any number at first, and becomes the one found now. Fast
 * while time changes slowly, forward or backward; the same bits.
 */
NKW_API void nkw_track_sample_cursor(const nkw_track *track, float time, uint32_t *cursor, float *out);

/**
 * The same where the segment is already known, for tracks that share their key times: `segment` is what
 * nkw_segment_find returns for track->times.
 */
NKW_API void nkw_track_sample_segment(const nkw_track *track, nkw_segment segment, float *out);

/** Floats of working memory that comparing and resampling tracks of this width take. */
#define NKW_TRACK_WORK(width) (2 * (width))

/**
 * How far another track is from this one: the largest difference met at the keys of either and at the quarters
 * between two of them, from this one's first key to its last. Of rotations it is the angle between them in radians, of
 * numbers the difference of a component. What lies between those moments is not seen.
 *
 * difference  the result; infinity where the tracks cannot be compared, NaN where a number is
 * work        work_count floats, at least NKW_TRACK_WORK(width)
 * Returns     NKW_OK; NKW_EMPTY without keys or width; NKW_BAD_WIDTH for a rotation whose width is not 4;
 *             NKW_MISMATCHED for different widths, or a rotation and numbers; NKW_TOO_SMALL for work_count
 */
NKW_API nkw_result nkw_track_difference(const nkw_track *track, const nkw_track *other, float *difference, float *work,
                                        size_t work_count);

/**
 * How many keys the track has at a uniform rate, in keys per second: at the times nkw_segment_uniform_time(first,
 * rate, k) for k = 0, 1, 2 ... until the last key's time is reached or passed. 1 for a track of one key or of no
 * duration.
 *
 * Returns NKW_OK; NKW_EMPTY without keys or width; NKW_BAD_WIDTH for a rotation whose width is not 4; NKW_OUT_OF_RANGE
 *         for a rate that is not positive and finite; NKW_NOT_FINITE for a first or last time that is not finite, or a
 *         last key that would not be; NKW_TOO_MANY for 2^31 keys or more. *count is then 0.
 */
NKW_API nkw_result nkw_track_resample_count(const nkw_track *track, float rate, size_t *count);

/** The memory of a resampled track; not the source's own arrays. */
typedef struct nkw_track_memory {
    float *times; /**< key_capacity floats */
    float *values; /**< key_capacity times width floats */
    size_t key_capacity; /**< how many keys there is room for */
    float *work; /**< work_count floats of working memory, at least NKW_TRACK_WORK(width) */
    size_t work_count;
} nkw_track_memory;

/**
 * The track at a uniform rate (baked): its keys are samples of the source. Between them STEP stays STEP and all else
 * becomes LINEAR; a source that chooses key by key stays STEP if all of it is. Normalised rotations are stored
 * normalised: the kind becomes NKW_TRACK_ROTATION. A clip finds keys of such times without a search.
 *
 * At a rate at which every key of the source falls on one of the new keys, a STEP source, and a LINEAR one without two
 * keys at one time, comes back. Where the rate does not divide the duration the last key is later than the source's, by
 * less than 1 / rate: loop by the source's duration.
 *
 * memory      takes nkw_track_resample_count keys
 * out         becomes the track over the memory, without keys after an error; may be the source itself
 * difference  becomes the error: nkw_track_difference from the source; infinity after an error; may be NULL
 * Returns     NKW_OK; what nkw_track_resample_count returns; NKW_TOO_SMALL for the memory
 */
NKW_API nkw_result nkw_track_resample(const nkw_track *track, float rate, const nkw_track_memory *memory,
                                      nkw_track *out, float *difference);

/**
 * The same at the lowest rate whose error is within `tolerance` (radians for rotations): fewer keys for a smaller
 * clip. Tried are the source's own number of segments over its duration, half as many, a quarter ... down to one,
 * rounded up; the last key is then at the source's end, to rounding. Of evenly spaced keys these are rate, rate/2,
 * rate/4 ...
 *
 * memory   takes as many keys as the source has
 * rate     becomes the rate, 0 after an error; 1 for a track of one key or of no duration, which has one key
 * Returns  NKW_OK; NKW_EMPTY, NKW_BAD_WIDTH and NKW_TOO_SMALL as above; NKW_NO_RATE where none is within the tolerance
 */
NKW_API nkw_result nkw_track_resample_within(const nkw_track *track, float tolerance, const nkw_track_memory *memory,
                                             nkw_track *out, float *rate);

#ifdef __cplusplus
}
#endif

#endif
