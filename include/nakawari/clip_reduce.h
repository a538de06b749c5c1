/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Compresses animations as far as a tolerance permits: quantizes the keys in the clip's block to as many bits as they
 * need (nkw_clip_reduce, *packed* keys), or removes keys of all tracks together (nkw_clip_source_reduce, *key
 * reduction*; reduce.h has that of one track). The error is the largest distance in model space of the points that
 * a joint carries, so errors of a chain of joints add up.
 *
 * Source Guillaume, ozz-animation, and Frechette, Animation Compression Library: Error metrics, 2017: an error measured
 * in model space at the distance of the skin.
 */
#ifndef NAKAWARI_CLIP_REDUCE_H
#define NAKAWARI_CLIP_REDUCE_H

#include <stdint.h>

#include "clip.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How far a reduced clip may be from its tracks. All distances are in the unit of the translations. */
typedef struct nkw_clip_reduction {
    /**
     * The parent of each joint, as in nkw_skeleton: less than the joint's own index, otherwise the joint is a root.
     * NULL: all joints are roots.
     */
    const int32_t *parents;
    float tolerance; /**< the largest distance in model space, of a point at a joint and of the points around it */
    /**
     * The distance of these points from the joint, in model space: how far its skin reaches. They are fixed in the
     * joint's space, n[c] distance/s[c] on its axes c = x, y, z for all |n| <= 1: an ellipsoid. s[c] is the length of
     * column c of the joint's model matrix, of all times of keys the largest (1 if it is 0). So no point is farther than
     * `distance`, and those on an axis are as far at the time when it is longest.
     */
    float distance;
    const float *tolerances; /**< NULL, or joint_count numbers in place of `tolerance` */
    const float *distances; /**< NULL, or joint_count numbers in place of `distance` */
    float float_tolerance; /**< the largest difference of a separate float */
} nkw_clip_reduction;
NKW_SIZE(nkw_clip_reduction, 40, 24);

/** What nkw_clip_reduce reached. */
typedef struct nkw_clip_reduced {
    size_t bytes; /**< of the clip; without a block, the bytes that it needs */
    size_t constant_count; /**< tracks that are constant within the tolerance */
    size_t packed_count; /**< tracks with packed keys; 0: the keys of all are in FLOAT32 or in UNORM16 */
    float distance; /**< the largest distance in model space, to 1e-6 of it too large */
    float share; /**< the largest distance divided by its tolerance, of all joints and floats */
    float floats; /**< the largest difference of a separate float */
} nkw_clip_reduced;
NKW_SIZE(nkw_clip_reduced, 40, 24);

/** The bytes of working memory of nkw_clip_reduce, nkw_clip_source_reduce and nkw_clip_source_difference. */
#define NKW_CLIP_REDUCE_WORK(track_count, joint_count, float_count)                                                    \
    (8 * (40 * (track_count) + 34 * (joint_count) + NKW_POSE_FLOATS(joint_count) + 6 * (float_count) + 16))

/**
 * Builds a clip that is as small as a tolerance permits. `format` of the source must be FLOAT32.
 *
 *   - A track whose values stay within the tolerance of one value becomes constant.
 *   - LINEAR keys are packed: in whole steps, 16 intervals at a time. Of the keys between both ends only the difference
 *     from the line between two neighbours is stored, with as many bits as it needs in this segment: motion that is
 *     straight or smooth for a while needs few or none.
 *   - STEP, CUBICSPLINE and modes per key are stored as FLOAT32: resample CUBICSPLINE first. So are the rotations of a
 *     track that makes whole turns, tracks whose range exceeds 2^20 steps, and rotations that are so far from unit that
 *     it is seen: packed ones are unit, and a square length of 1 + d moves a point as a rotation by d radians does.
 *   - If the clip is smaller as FLOAT32, or as UNORM16 within the tolerance, it is stored so: few keys are. It is never
 *     larger than the FLOAT32 clip of its source, nor than the UNORM16 clip if that is within the tolerance.
 *
 * The steps are found by trials: a clip is built, sampled and compared with the tracks in model space, until no joint
 * exceeds its tolerance and the clip does not become smaller. It is compared at the times of all keys and in the middle
 * between two keys, by the matrices of nkw_skeleton_models_from_pose in binary64. The distance of a joint is the
 * largest of its position and of all points around it, in every direction.
 *
 * The trials find a small clip, not the smallest: with a larger tolerance it is smaller as a rule, but may be larger.
 * If there are more than 1024 intervals, the first 16 trials are of eight parts of 64 intervals each; a few of the whole
 * clip follow, so the result is measured at all times, as that of a short clip is.
 *
 * A reduced clip is opened, sampled and copied as every clip. Equal first and last keys return equal bits. A sample
 * decodes two keys from two knots and one segment of 16 intervals, at random times as in order. It takes 4 to 12 times
 * as long as that of a FLOAT32 clip in the first-level cache: 8 to 10 ns for each moving track with AVX2, 11 to 15 ns
 * with SSE2. nkw_clip_sample_cached decodes each pair of keys once: half of that at 60 samples per second of keys at
 * 30 Hz.
 *
 * block    aligned for float; NULL asks for a bound of its bytes. The clip is much smaller: copy its first
 *          reduced->bytes bytes
 * reduced  receives the result. If the block is too small its `bytes` are those that the block needs, otherwise 0 after
 *          an error
 * bad      receives the index of the first track with an error, 0 if there is none; may be NULL
 * work     NKW_CLIP_REDUCE_WORK of the tracks, joints and floats
 * Returns  as nkw_clip_build; NKW_BAD_FORMAT for another format than FLOAT32; NKW_NOT_FINITE for a tolerance or a
 *          distance that is not finite, NKW_OUT_OF_RANGE for a negative one; NKW_TOO_SMALL for too little memory
 *
 * Where a tolerance is so small that the trials do not reach it, tracks are stored as FLOAT32: `share` is at most 1.
 *
 * Time: 16 to 32 trials of up to 1024 intervals, 2 to 6 of more. A clip of 67 joints takes 0.2 to 0.5 s with 301 keys
 * and 8 s with 36,001.
 *
 * Stack  at most 17 KiB.
 */
NKW_API nkw_result nkw_clip_reduce(const nkw_clip_source *source, const nkw_clip_reduction *reduction,
                                   nkw_bytes_span block, nkw_clip_reduced *reduced, size_t *bad, nkw_work work);

/** How far reduced or other tracks are from those of a source. */
typedef struct nkw_reduced {
    size_t source_key_count; /**< of all tracks of the source */
    size_t key_count; /**< of all reduced tracks */
    float distance; /**< the largest distance in model space */
    float share; /**< the largest distance divided by its tolerance, of all joints and floats: at most 1 */
    float floats; /**< the largest difference of a separate float */
} nkw_reduced;
NKW_SIZE(nkw_reduced, 32, 20);

/** What nkw_clip_source_reduce made. */
typedef struct nkw_clip_source_reduced {
    nkw_clip_source source; /**< with the reduced tracks, which are in the block; without tracks after an error */
    nkw_reduced reached;
    size_t bytes; /**< that the block needs */
} nkw_clip_source_reduced;
NKW_SIZE(nkw_clip_source_reduced, 112, 60);

/**
 * Reduces all tracks of a clip, so that no joint is further from its place than a tolerance, in model space: the errors
 * of a chain of joints add up. The distance of a joint is the largest of its position and of all points around it, as
 * of nkw_clip_reduce. The tolerance of each track is found by trials: all tracks are reduced, sampled and compared with
 * the source, until no joint exceeds its tolerance and no trial has fewer keys. They are compared at the key times of
 * all tracks of the source and at 1/4, 1/2 and 3/4 between two of these times.
 *
 * Between these times the distance may be larger: it is kept within 0.98 of the tolerance. If the trials do not reach
 * that, all tracks are reduced losslessly. If the rounding of samples is still larger than the tolerance, the result is
 * the source.
 *
 * block    aligned for pointers; NULL asks for its bytes
 * reduced  receives the result; its other fields are those of `source`. If the block is too small, its `bytes` are
 *          those that the block needs, otherwise 0 after an error
 * bad      as of nkw_clip_reduce
 * work     NKW_CLIP_REDUCE_WORK of the tracks, joints and floats
 * Returns  as nkw_clip_build; NKW_NOT_FINITE and NKW_OUT_OF_RANGE for tolerances and distances as of nkw_clip_reduce;
 *          NKW_TOO_SMALL for too little memory, and if the bytes exceed size_t
 *
 * Time: as of nkw_clip_reduce. 100 rotations of 10,000 keys take 4 s.
 *
 * Stack  at most 16 KiB.
 */
NKW_API nkw_result nkw_clip_source_reduce(const nkw_clip_source *source, const nkw_clip_reduction *reduction,
                                          nkw_bytes_span block, nkw_clip_source_reduced *reduced, size_t *bad,
                                          nkw_work work);

/**
 * The largest differences of other tracks from those of a clip, in model space, as nkw_clip_source_reduce measures
 * them; also at the keys of the other tracks and between them. For tracks that were edited, resampled or read again.
 *
 * source, other  with the same number of joints and floats. The points around a joint are those of `source`
 * reduction      as above; its tolerances determine `share`, which may be larger than 1
 * difference     receives the number of keys of both, and the differences
 * work           NKW_CLIP_REDUCE_WORK of the joints, floats and the larger number of tracks
 * Returns        as nkw_clip_source_reduce for either; NKW_MISMATCHED for another number of joints or floats. Nothing
 *                is written after an error
 *
 * Stack  at most 16 KiB.
 */
NKW_API nkw_result nkw_clip_source_difference(const nkw_clip_source *source, const nkw_clip_source *other,
                                              const nkw_clip_reduction *reduction, nkw_reduced *difference,
                                              nkw_work work);

#ifdef __cplusplus
}
#endif

#endif
