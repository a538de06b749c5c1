/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 4: a clip: many tracks, one time, one call, one pose.
 *
 * A clip is built from tracks into one block of the caller's. It holds no pointer, so it may be copied, written to a
 * file and mapped back; nkw_clip_open checks a block before its first use. Sampling gives the same bits as
 * nkw_track_sample of every track, in a fraction of its time:
 *
 *     - tracks with the same key times share one timeline, and it is searched once;
 *     - their keys stand side by side in component arrays, [key][component][lane], so a sample reads two as streams;
 *     - what slerp needs to know of two neighbouring keys is worked out when the clip is built;
 *     - key times that are evenly spaced need no search: any time costs the same;
 *     - tracks that never change are found, stored once and copied.
 *
 * That is for tracks that share key times, as exporters write them. A track with times of its own is searched by itself
 * and takes more room than its keys: clips of such tracks are no faster than their tracks. Resample them at one rate.
 *
 * A block is in the byte order of the machine that built it. It is the same on every machine of that order, byte for
 * byte.
 */
#ifndef NAKAWARI_CLIP_H
#define NAKAWARI_CLIP_H

#include <stdint.h>

#include "pose.h"
#include "track.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What a track of a clip moves. */
typedef enum nkw_clip_target {
    NKW_CLIP_TRANSLATION, /**< of a joint: width 3 */
    NKW_CLIP_ROTATION, /**< of a joint: a rotation, width 4 */
    NKW_CLIP_SCALE, /**< of a joint: width 3 */
    NKW_CLIP_FLOATS /**< floats of their own, from `index` on: morph weights, any width */
} nkw_clip_target;

/** A track and its place: `index` is the joint, or the first of the floats. */
typedef struct nkw_clip_track {
    nkw_clip_target target;
    uint32_t index;
    nkw_track track;
} nkw_clip_track;

/** How keys are stored. */
typedef enum nkw_clip_format {
    NKW_CLIP_FLOAT32, /**< as they are: sampling gives the bits of track by track */
    /**
     * 16 bits a number, over the range of that number in all keys of its track; CUBICSPLINE tracks stay as they are.
     * A number is off by at most 0.51/65535 of its range, for ranges of 1e-33 to 3e38 and numbers up to
     * 3e38, and 3 u of its size.
     *
     * A rotation is three numbers, its axis times the tangent of a quarter of its angle. At a key it is off by at most
     * 4/65535 radians times the widest range of the three, which is 2 at most, and 1e-6: 1.24e-4; between keys that are
     * half a turn apart by sqrt 2 of that, 1.75e-4. It is unit to 7e-7, and of q and -q may be the one that the track's
     * is not. Keys that are not unit are made so first: between them it is then off by twice what they are, and more.
     *
     * nkw_clip_difference measures a clip's own error.
     */
    NKW_CLIP_UNORM16
} nkw_clip_format;

/** What a clip is built from. Joints and floats without a track hold what `rest` says. */
typedef struct nkw_clip_source {
    const nkw_clip_track *tracks; /**< in any order */
    size_t track_count;
    size_t joint_count; /**< of the poses that the clip gives */
    size_t float_count; /**< floats besides the pose, 0 if there are none */
    nkw_pose_view rest; /**< a pose of joint_count joints; data NULL: every joint at the identity */
    const float *rest_floats; /**< float_count floats; NULL: zeros */
    nkw_clip_format format;
} nkw_clip_source;

/** The head of a clip's block. */
typedef struct nkw_clip nkw_clip;

/** How many uint32_t nkw_clip_measure and nkw_clip_build take as working memory. */
#define NKW_CLIP_WORK(track_count) (3 * (track_count))

/**
 * Checks the tracks; *bytes becomes the size of their clip.
 *
 * NKW_EMPTY without joints and floats; what nkw_track_validate returns for a track; NKW_BAD_METHOD for a target that is
 * none and a track whose kind is not its target's; NKW_BAD_WIDTH for a width that is not; NKW_BAD_FORMAT for an unknown
 * format; NKW_MISMATCHED for a rest pose of another number of joints; NKW_OUT_OF_RANGE for a joint or float beyond the
 * last, and for more than 2^26 joints, 2^29 floats or 2^32 words in the block; NKW_REPEATED for two tracks that move the
 * same, the later one being the offender; NKW_TOO_SMALL where work_count is less than
 * NKW_CLIP_WORK(source->track_count). Each track is checked by itself before any two are. *bad_track becomes the index
 * of the first offender, 0 if there is none; it may be NULL.
 */
NKW_API nkw_result nkw_clip_measure(const nkw_clip_source *source, size_t *bytes, size_t *bad_track, uint32_t *work,
                                    size_t work_count);

/**
 * Builds a clip of `bytes` bytes, as nkw_clip_measure told, into `block`, which must be aligned for float; 64 bytes
 * is fastest. Returns what nkw_clip_measure returns, and NKW_TOO_SMALL if bytes are less than that. The block may then
 * be sampled as (const nkw_clip *)block.
 */
NKW_API nkw_result nkw_clip_build(const nkw_clip_source *source, void *block, size_t bytes, size_t *bad_track,
                                  uint32_t *work, size_t work_count);

/**
 * The clip in a block that was read or mapped: *clip becomes the block itself, or NULL where it is not a sound clip.
 *
 * NKW_NOT_A_CLIP for another beginning, version or byte order, and for a block that is not aligned for float;
 * NKW_TOO_SMALL for a block that is cut off; NKW_OUT_OF_RANGE where something in it would be read or written outside
 * the block or the pose, where its parts take more room than it has, or where the clip states more joints or floats
 * than its parts write; NKW_NOT_ASCENDING and NKW_NOT_FINITE for key times, or a start and end, that are so; the former
 * also for times that are not those of the stored rate. The values of keys are not checked. A clip that opens is safe to
 * sample, and its joints and floats together are fewer than its bytes; a clip that does not open must not be sampled.
 */
NKW_API nkw_result nkw_clip_open(const void *block, size_t bytes, const nkw_clip **clip);

/** What a clip is made for: the joints of its poses, the floats besides, the bytes of its block. */
NKW_API size_t nkw_clip_joint_count(const nkw_clip *clip);
NKW_API size_t nkw_clip_float_count(const nkw_clip *clip);
NKW_API size_t nkw_clip_bytes(const nkw_clip *clip);

/** The earliest and the latest key time of all tracks, constant ones too, seconds; 0 and 0 without tracks. */
NKW_API float nkw_clip_start(const nkw_clip *clip);
NKW_API float nkw_clip_end(const nkw_clip *clip);

/** How many cursors sampling takes: one for each timeline. */
NKW_API size_t nkw_clip_cursor_count(const nkw_clip *clip);

/**
 * The pose at `time`.
 *
 * cursors  nkw_clip_cursor_count(clip) numbers, any at first, that each playing instance keeps for itself: the search
 *          begins where the last one ended. NULL: each search begins anew. The result is the same bits.
 * pose     receives all joints, its padding may be written; data may be NULL
 * floats   receives nkw_clip_float_count(clip) floats; may be NULL
 * Returns  NKW_OK; NKW_MISMATCHED for a pose of another number of joints, nothing is then written
 */
NKW_API nkw_result nkw_clip_sample(const nkw_clip *clip, float time, uint32_t *cursors, nkw_pose_span pose,
                                   float *floats);

/** How far a clip is from tracks: the largest difference met. */
typedef struct nkw_clip_error {
    float translation; /**< of a component */
    float rotation;    /**< radians, the angle between the two rotations */
    float scale;       /**< of a component */
    float floats;
} nkw_clip_error;

/** Floats of working memory that nkw_clip_difference takes. */
#define NKW_CLIP_DIFFERENCE_WORK(joint_count, float_count) (NKW_POSE_FLOATS(joint_count) + 2 * (float_count))

/**
 * Samples the clip and every track of the source at each key of the track and at the quarters between two keys; and all
 * of them, while they last, at those of the clip's own timelines that the source has not.
 *
 * source   what nkw_clip_build took for this clip, or the tracks that those were made from (before resampling, say)
 * error    the differences; infinities after an error
 * work     work_count floats, at least NKW_CLIP_DIFFERENCE_WORK of the clip's joints and floats
 * Returns  NKW_OK; NKW_MISMATCHED for another number of joints or floats, or a track that nkw_clip_measure would not
 *          accept; NKW_TOO_SMALL for work_count
 */
NKW_API nkw_result nkw_clip_difference(const nkw_clip *clip, const nkw_clip_source *source, nkw_clip_error *error,
                                       float *work, size_t work_count);

#ifdef __cplusplus
}
#endif

#endif
