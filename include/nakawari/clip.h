/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Clips: one call samples many tracks at one time into one pose. A clip may be compressed: quantized to 16-bit keys
 * (NKW_CLIP_UNORM16, *compact*), or reduced by nkw_clip_reduce of clip_reduce.h.
 *
 * A clip is built from tracks into one block of memory of the caller. It contains no pointer, so it may be copied,
 * written to a file and mapped. nkw_clip_open checks a block before its first use. Sampling returns the same bits as
 * nkw_track_sample of every track, in a fraction of the time:
 *
 *   - Tracks with the same key times share one timeline, which is searched once.
 *   - Their keys are stored in component arrays, [key][component][lane]. A sample reads two contiguous keys.
 *   - The arc of two neighbouring rotation keys, which slerp needs, is computed when the clip is built.
 *   - Evenly spaced key times need no search.
 *   - A constant track is stored as one value, and is copied.
 *
 * Share key times between tracks, as exporters do. A track with separate key times needs a separate search and more
 * memory than its keys: a clip of such tracks is no faster than the tracks. Resample them at one rate.
 *
 * A block has the byte order of the machine that built it. Machines of the same byte order build the same bytes, and
 * nkw_clip_convert opens a block of the other byte order.
 *
 * Example  nkw_clip_source source; nkw_bytes_span block, cache; nkw_work work; const nkw_clip *clip;
 *          float time, *floats; nkw_pose_span pose; uint32_t *cursors; size_t bytes, bad; nkw_clip_description all;
 *          nkw_clip_error error; nkw_clip_track track; nkw_track_span span; const char *name;
 *
 *     nkw_clip_build(&source, block, &bytes, &bad, work);         tracks into one block
 *     nkw_clip_open(block.data, bytes, &clip);                    checks a block from a file
 *     nkw_clip_convert(block.data, bytes, block.data, &clip);     a block of the other byte order
 *     all = nkw_clip_describe(clip);                              times, counts, sizes
 *     name = nkw_clip_joint_name(clip, 3);                        of a joint
 *     name = nkw_clip_float_name(clip, 0);                        of a separate float
 *     nkw_clip_track_get(clip, 0, span, &track, work);            one track back
 *     nkw_clip_sample(clip, time, cursors, pose, floats);         the pose at a time
 *     nkw_clip_sample_cached(clip, time, cache, pose, floats);    the same, faster in small steps
 *     nkw_clip_difference(clip, &source, &error, work);           what its format loses
 */
#ifndef NAKAWARI_CLIP_H
#define NAKAWARI_CLIP_H

#include <stdint.h>

#include "pose.h"
#include "track.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The property that a track of a clip animates. */
typedef enum nkw_clip_target {
    NKW_CLIP_TRANSLATION, /**< of a joint: width 3 */
    NKW_CLIP_ROTATION, /**< of a joint: a rotation, width 4 */
    NKW_CLIP_SCALE, /**< of a joint: width 3 */
    NKW_CLIP_FLOATS, /**< separate floats, from `index` on: morph weights, any width */
    NKW_CLIP_TARGET_MAX_ENUM = 0x7fffffff
} nkw_clip_target;

/** A track and its target: `index` is the joint, or the first of the floats. */
typedef struct nkw_clip_track {
    nkw_clip_target target;
    uint32_t index;
    nkw_track track;
} nkw_clip_track;
NKW_SIZE(nkw_clip_track, 56, 36);

/**
 * The kind of the values of a target, for nkw_track_convert_axes (edit.h). Values of NKW_CLIP_FLOATS have no axes: do
 * not convert them. Convert all other tracks of a source and its rest pose (nkw_pose_convert_axes) before
 * nkw_clip_build.
 */
#define NKW_CLIP_AXES(target)                                                                                          \
    ((target) == NKW_CLIP_ROTATION ? NKW_AXES_QUAT : (target) == NKW_CLIP_SCALE ? NKW_AXES_SCALE : NKW_AXES_VEC3)

/**
 * The format of stored keys. Bytes of a track of n keys:
 *
 *                                          FLOAT32     UNORM16
 *     each number, LINEAR or STEP          4 n         8 + 2 n
 *     rotation, LINEAR                     20 n        24 + 6 n
 *     rotation, STEP                       16 n        24 + 6 n
 *     each number, CUBICSPLINE             12 n        12 n
 *     rotation, CUBICSPLINE                48 n        48 n
 *     constant number, rotation            4, 16       4, 16
 *
 * In addition each timeline takes 16 + 4 n, each group of tracks with the same key times about 100, each number and
 * rotation 1, or 5 if its joint has no animated neighbour. Component arrays of at least 8 neighbouring joints are
 * padded as those of a pose, so that they are written as a whole: 10 joints take the memory of 16. In compact clips a
 * sample takes about twice as long where the keys are in the caches of the core.
 */
typedef enum nkw_clip_format {
    NKW_CLIP_FLOAT32, /**< binary32, unchanged: sampling returns the bits of nkw_track_sample */
    /**
     * 16 bits for each number, linear over the range of that number in all keys of its track. CUBICSPLINE tracks are
     * stored as FLOAT32. So are groups of so few keys that they would take more memory, with their padding, and a clip
     * that is not smaller than its FLOAT32 form: a compact clip is never larger. The error of a number is at most
     * 0.51/65535 of its range plus 3 u of its magnitude, for ranges of 1e-33 to 3e38 and numbers up to 3e38; u = 2^-24.
     *
     * A rotation is stored as three numbers: its axis times the tangent of a quarter of its angle. The error of the
     * rotation is
     *
     *     at a key                            4/65535 rad times the widest range of the three (at most 2), plus 1e-6:
     *                                         at most 1.24e-4 rad
     *     between keys half a turn apart      sqrt 2 times that: at most 1.75e-4 rad
     *
     * Its length is 1 to within 7e-7, and its sign may differ from that of the track. Keys are normalised before they
     * are stored. Between keys that were not unit, the error increases by twice their deviation from length 1, or more.
     *
     * nkw_clip_difference measures the error of a clip.
     */
    NKW_CLIP_UNORM16,
    NKW_CLIP_FORMAT_MAX_ENUM = 0x7fffffff
} nkw_clip_format;

/** The names that a clip stores: UTF-8 texts that end with a NUL. NULL is the empty text. */
typedef struct nkw_clip_names {
    const char *clip;
    const char *const *joints; /**< NULL, or joint_count texts */
    const char *const *floats; /**< NULL, or float_count texts: of morph targets, of a curve */
} nkw_clip_names;
NKW_SIZE(nkw_clip_names, 24, 12);

/** The input of a clip. Joints and floats without a track keep their rest values. */
typedef struct nkw_clip_source {
    const nkw_clip_track *tracks; /**< in any order */
    size_t track_count;
    size_t joint_count; /**< of the poses that the clip writes */
    size_t float_count; /**< separate floats in addition to the pose; may be 0 */
    nkw_pose_view rest; /**< a pose of joint_count joints; if data is NULL, every joint is the identity */
    const float *rest_floats; /**< float_count floats; if NULL, zeros */
    nkw_clip_format format;
    const nkw_clip_names *names; /**< NULL: no names, and no memory for them */
} nkw_clip_source;
NKW_SIZE(nkw_clip_source, 72, 36);

/** The header of the block of a clip. */
typedef struct nkw_clip nkw_clip;

/** The bytes of working memory of nkw_clip_build. */
#define NKW_CLIP_BUILD_WORK(track_count) (12 * (track_count))

/**
 * Checks the source, each track and then each pair, and builds its clip into a block. The block may then be sampled as
 * (const nkw_clip *)block.data.
 *
 * block    aligned for float, 64-byte alignment is fastest. data NULL asks for the size
 * bytes    receives the size of the clip; 0 after every error but a block that is too small
 * bad      receives the index of the first track with an error, 0 if there is none; after NKW_OK how many tracks have
 *          rotation keys that send CUBICSPLINE the longer way (nkw_track_validate); may be NULL
 * work     NKW_CLIP_BUILD_WORK(source->track_count) bytes
 * Returns
 *
 *     NKW_OK            no error
 *     NKW_EMPTY         no joints and no floats
 *     NKW_BAD_METHOD    an unknown target
 *     NKW_BAD_WIDTH     a track whose width does not match its target
 *     NKW_BAD_FORMAT    an unknown format
 *     NKW_MISMATCHED    a rest pose with another number of joints; a track whose kind does not match its target
 *     NKW_OUT_OF_RANGE  a joint or float after the last; more than 2^26 joints, 2^29 floats or 2^32 words in the block
 *     NKW_REPEATED      two tracks that animate the same property; *bad is the later one
 *     NKW_TOO_SMALL     too little working memory, or too small a block: *bytes is then its size
 *
 * and the errors of nkw_track_validate for each track.
 *
 * Stack  at most 16 KiB.
 */
NKW_API nkw_result nkw_clip_build(const nkw_clip_source *source, nkw_bytes_span block, size_t *bytes, size_t *bad,
                                  nkw_work work);

/**
 * Checks a block that was read or mapped. A clip that this function accepts is safe to sample; a clip that it rejects
 * must not be sampled. The values of keys are not checked. In an accepted clip, the number of joints plus the number of
 * floats is less than the number of bytes.
 *
 * clip     receives the block as a clip; NULL after an error
 * Returns
 *
 *     NKW_OK             no error
 *     NKW_NOT_A_CLIP     no clip of this version and byte order; a block that is not aligned for float
 *     NKW_TOO_SMALL      a truncated block
 *     NKW_OUT_OF_RANGE   sampling would access memory outside the block or the pose; the parts together are larger than
 *                        the block; the clip states more joints or floats than its parts write
 *     NKW_NOT_FINITE     a key time, the start or the end is not finite
 *     NKW_NOT_ASCENDING  key times do not ascend, the end is before the start, or key times are not those of the stored
 *                        rate
 */
NKW_API nkw_result nkw_clip_open(const void *block, size_t bytes, const nkw_clip **clip);

/**
 * Copies a block of either byte order to `out`, in the byte order of this machine, and opens it. It is the block that
 * this machine builds from the same source, byte for byte.
 *
 * block    bytes bytes, of any alignment
 * out      bytes bytes, aligned for float; may be `block`
 * Returns  as nkw_clip_open; NKW_NOT_A_CLIP also if `out` is not aligned
 */
NKW_API nkw_result nkw_clip_convert(const void *block, size_t bytes, void *out, const nkw_clip **clip);

/** What a clip contains. */
typedef struct nkw_clip_description {
    size_t joint_count; /**< of the poses */
    size_t float_count; /**< separate floats */
    /**
     * The tracks whose values change. Tracks with one value are not stored as tracks: the values of all other
     * properties are those that nkw_clip_sample returns at any time. Each separate float is a track of width 1.
     */
    size_t track_count;
    size_t cursor_count; /**< of nkw_clip_sample: one for each timeline */
    size_t cache_bytes; /**< of nkw_clip_sample_cached: about 68 for each animated joint of a compact clip */
    size_t bytes; /**< of the block */
    float start; /**< the earliest key time of all tracks, also constant ones, in seconds; 0 without tracks */
    float end; /**< the latest */
    const char *name; /**< in the block; the empty text if there is none */
} nkw_clip_description;
NKW_SIZE(nkw_clip_description, 64, 36);

/** Describes a clip. The cache is a sum over the groups of tracks with the same key times: describe a clip once. */
NKW_API nkw_clip_description nkw_clip_describe(const nkw_clip *clip);

/** The name of a joint, in the block; the empty text if there is none. */
NKW_API const char *nkw_clip_joint_name(const nkw_clip *clip, size_t joint);

/** The name of a separate float, in the block; the empty text if there is none. */
NKW_API const char *nkw_clip_float_name(const nkw_clip *clip, size_t index);

/** The bytes of working memory of nkw_clip_track_get. */
#define NKW_CLIP_TRACK_GET_WORK(joint_count, float_count) (4 * (NKW_POSE_FLOATS(joint_count) + (float_count)))

/**
 * Takes track `index` out of a clip again, in a time that does not depend on the number of joints. The order of tracks
 * is that of the block, not that of the source.
 *
 * A FLOAT32 clip that is built from these tracks, with a sample as the rest pose, returns the samples of the clip:
 *
 *     of a FLOAT32 clip              bit for bit. Keys have the bits of the source, except that LINEAR keys of
 *                                    NKW_TRACK_ROTATION_NORMALIZED are normalised; the track is an NKW_TRACK_ROTATION
 *     of a compact or reduced one    at a key bit for bit; between keys to rounding: 8 u of the largest value of a
 *                                    number, 1e-6 of a rotation, which may be negated
 *
 * Compact and packed keys about half a turn apart may be more than half a turn apart by the rounding of their format,
 * and the clip turns by that. No two keys of a track do. So that the track turns in the same direction, its later key
 * is moved by this rounding, to 1e-6 rad below half a turn.
 *
 * span     for the keys of the track; without arrays (times NULL) it asks for its shape: no working memory is needed
 * out      receives the track, which refers to the arrays of `span`. After NKW_TOO_SMALL it is the shape: target, kind, width,
 *          interpolation, number of keys and their times, which are in the block; `values` and `key_interpolation` are
 *          NULL. Unchanged after other errors
 * work     NKW_CLIP_TRACK_GET_WORK of the clip's joints and floats
 * Returns  NKW_OK; NKW_OUT_OF_RANGE after the last track, and for a track whose parts are not together; NKW_TOO_SMALL
 *          for too little memory
 *
 * Stack  at most 15 KiB.
 */
NKW_API nkw_result nkw_clip_track_get(const nkw_clip *clip, size_t index, nkw_track_span span, nkw_clip_track *out,
                                      nkw_work work);

/**
 * Samples the clip at `time`.
 *
 * cursors  NULL, or cursor_count numbers (nkw_clip_describe) of any initial value, separate for each playing instance:
 *          each search then begins where the last one ended. The bits of the result do not depend on them.
 * pose     receives all joints; its padding may be written; data may be NULL
 * floats   receives the separate floats; may be NULL
 * Returns  NKW_OK; NKW_MISMATCHED for a pose with another number of joints: nothing is written
 *
 * Stack  at most 15 KiB.
 */
NKW_API nkw_result nkw_clip_sample(const nkw_clip *clip, float time, uint32_t *cursors, nkw_pose_span pose,
                                   float *floats);

/**
 * Samples the clip at `time`, for steps of time much smaller than the distance of the keys: slow motion, steps of a
 * simulation. What two neighbouring compact or packed keys (nkw_clip_reduce) determine without the time is kept in the
 * cache: decoded numbers, arcs. Samples of such clips take half the time or less while they are between the same keys;
 * the first one after that takes a third longer. Float clips store their arcs, so for them the cache has cursors only.
 * The pose and the floats are those of nkw_clip_sample, bit for bit.
 *
 * cache    cache_bytes (nkw_clip_describe), separate for each playing instance; zeros before its first use and before
 *          its use for another clip. Aligned for float, 64-byte alignment is fastest
 * Returns  as nkw_clip_sample; NKW_TOO_SMALL for too small a cache: nothing is written
 *
 * Stack  at most 15 KiB.
 */
NKW_API nkw_result nkw_clip_sample_cached(const nkw_clip *clip, float time, nkw_bytes_span cache, nkw_pose_span pose,
                                          float *floats);

/** The largest differences between a clip and its tracks. */
typedef struct nkw_clip_error {
    float translation; /**< of a component */
    float rotation; /**< radians, the angle between the two rotations */
    float scale; /**< of a component */
    float floats;
} nkw_clip_error;
NKW_SIZE(nkw_clip_error, 16, 16);

/** The bytes of working memory of nkw_clip_difference. */
#define NKW_CLIP_DIFFERENCE_WORK(joint_count, float_count) (4 * (NKW_POSE_FLOATS(joint_count) + 2 * (float_count)))

/**
 * The largest differences between the samples of a clip and those of its tracks.
 *
 *     times                                                           tracks compared
 *     the keys of a track, and 1/4, 1/2 and 3/4 between two keys      the tracks with these key times
 *     the same of a timeline of the clip that no track has            all tracks, from first to last key
 *
 * source   the source of the clip, or the tracks from which it was made, for example before resampling
 * error    receives the differences
 * work     NKW_CLIP_DIFFERENCE_WORK of the clip's joints and floats
 * Returns  NKW_OK; NKW_MISMATCHED for another number of joints or floats, or for a track without keys or with a
 *          target, kind, width or index that nkw_clip_build rejects; NKW_TOO_SMALL for too little working memory;
 *          nothing is then written
 *
 * Stack  at most 15 KiB.
 */
NKW_API nkw_result nkw_clip_difference(const nkw_clip *clip, const nkw_clip_source *source, nkw_clip_error *error,
                                       nkw_work work);

#ifdef __cplusplus
}
#endif

#endif
