/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 4: key reduction: the keys of a track that are needed, within a tolerance.
 *
 * A reduced track has some of the keys of its source, unchanged: times, values, tangents, modes per key. It never has
 * more keys than the source. These are always kept:
 *
 *     the first and the last key        the span of the track
 *     both keys of a jump               two keys with equal times and different values
 *     keys where the mode changes       of tracks with a mode per key
 *     keys that determine the turn      of rotations, see below
 *     keys whose removal overflows      of numbers: the difference of two values must be a float, and of CUBICSPLINE
 *                                       this and both tangents per segment at most 2^125
 *
 * From each kept key the longest segment within the tolerance is searched: its length is doubled while it is within the
 * tolerance, then bisected.
 *
 * Turns. Let q[a] ... q[b] be the keys from one kept key to the next, each multiplied by 1 or -1 so that the dot
 * product with the previous one is not negative (LINEAR), or as stored (CUBICSPLINE, which does not choose the shorter
 * arc). Keys are removed only if
 *
 *     q[a] . q[k] > 1/1000 for a < k <= b
 *
 * so the new segment turns by less than half a turn, in the direction of the source: 360 degrees in four keys remain
 * 360 degrees for every tolerance.
 *
 * A tolerance of 0 is lossless: a key is removed only if the values of its neighbours equal its own, for CUBICSPLINE
 * with tangents of 0 between them. Samples are then equal at all times; those of CUBICSPLINE are to the rounding of the
 * weights, and a zero may change its sign.
 *
 * The tangents of CUBICSPLINE are those of the source, per second, so they have the correct unit in longer segments.
 *
 * Source Zeux, gltfpack, and McCurdy, glTF-Transform, for the cases: more keys than before, lerp in place of slerp,
 * turns that collapse, tangents that are lost. Guillaume, ozz-animation, and Frechette, Animation Compression Library:
 * Error metrics, 2017: an error measured in model space at the distance of the skin.
 */
#ifndef NAKAWARI_REDUCE_H
#define NAKAWARI_REDUCE_H

#include "clip.h"
#include "edit.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Reduces a track.
 *
 * tolerance   the largest difference of a component, or, for rotations, the largest angle in radians
 * memory      for as many keys as the source has. It must not overlap the arrays of the source
 * out         receives the track, which refers to `memory`; without keys after an error; may be `track`
 * difference  receives the error: the largest difference of the two tracks; infinity after an error; may be NULL
 * Returns     NKW_OK; the errors of nkw_track_validate; NKW_NOT_FINITE also for a tolerance that is negative or not
 *             finite; NKW_TOO_SMALL for too little memory
 *
 * The difference of numbers is exact at all times, to the rounding of samples: between two keys of the source it is a
 * cubic, whose extremes are computed in binary64. That of rotations is measured at the keys of the source and at 1/4,
 * 1/2 and 3/4 between them, and may be 1/16 larger between these times: it is kept within 16/17 of the tolerance.
 */
NKW_API nkw_result nkw_track_reduce(const nkw_track *track, float tolerance, const nkw_edit_memory *memory,
                                    nkw_track *out, float *difference);

/** What nkw_clip_source_reduce reached. */
typedef struct nkw_reduced {
    size_t source_key_count; /**< of all tracks of the source */
    size_t key_count; /**< of all reduced tracks */
    float distance; /**< the largest distance in model space */
    float share; /**< the largest distance divided by its tolerance, of all joints and floats: at most 1 */
    float floats; /**< the largest difference of a separate float */
} nkw_reduced;
NKW_SIZE(nkw_reduced, 32, 20);

/**
 * Checks a source as nkw_clip_measure does, and computes the number of bytes of the block of nkw_clip_source_reduce.
 *
 * work     work_count doubles, at least NKW_CLIP_REDUCE_WORK of the tracks, joints and floats
 * Returns  as nkw_clip_measure; NKW_TOO_SMALL also if the bytes exceed size_t
 */
NKW_API nkw_result nkw_clip_source_reduce_measure(const nkw_clip_source *source, size_t *bytes, size_t *bad_track,
                                                  double *work, size_t work_count);

/**
 * Reduces all tracks of a clip, so that no joint is further from its place than a tolerance, in model space: the errors
 * of a chain of joints add up. The distance of a joint is the largest of its position and of all points around it, as of
 * nkw_clip_reduce. The tolerance of each track is found by trials: all tracks are
 * reduced, sampled and compared with the source, until no joint exceeds its tolerance and no trial has fewer keys. They
 * are compared at the key times of all tracks of the source and at 1/4, 1/2 and 3/4 between two of these times.
 *
 * Between these times the distance may be larger: it is kept within 0.98 of the tolerance. If the trials do not reach
 * that, all tracks are reduced losslessly. If the rounding of samples is still larger than the tolerance, `out` is the
 * source.
 *
 * memory   block: aligned for pointers, of at least nkw_clip_source_reduce_measure bytes; work: as there
 * out      receives the source with the reduced tracks, which are in the block; its other fields are those of `source`;
 *          without tracks after an error. May be `source`
 * reduced  receives the result; may be NULL
 * Returns  as nkw_clip_source_reduce_measure; NKW_NOT_FINITE also for a tolerance or distance that is negative or not
 *          finite; NKW_TOO_SMALL for too little memory
 *
 * Time: at most 29 trials. A clip of 93 tracks and 16,829 keys takes 0.6 s.
 */
NKW_API nkw_result nkw_clip_source_reduce(const nkw_clip_source *source, const nkw_clip_reduction *reduction,
                                          const nkw_clip_memory *memory, nkw_clip_source *out, nkw_reduced *reduced,
                                          size_t *bad_track);

/**
 * The largest differences of other tracks from those of a clip, in model space, as nkw_clip_source_reduce measures
 * them; also at the keys of the other tracks and between them. For tracks that were edited, resampled or read again.
 *
 * source, other  with the same number of joints and floats. The points around a joint are those of `source`
 * reduction      as above; its tolerances determine `share`, which may be larger than 1
 * difference     receives the number of keys of both, and the differences
 * work           as above, for the source with more tracks
 * Returns        as nkw_clip_source_reduce_measure for either; NKW_MISMATCHED for another number of joints or floats;
 *                NKW_NOT_FINITE as above
 */
NKW_API nkw_result nkw_clip_source_difference(const nkw_clip_source *source, const nkw_clip_source *other,
                                              const nkw_clip_reduction *reduction, nkw_reduced *difference,
                                              double *work, size_t work_count);

#ifdef __cplusplus
}
#endif

#endif
