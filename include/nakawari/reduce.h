/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Key reduction (keyframe reduction, decimation): removes keys of a track that are not needed within a tolerance.
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
 * turns that collapse, tangents that are lost.
 */
#ifndef NAKAWARI_REDUCE_H
#define NAKAWARI_REDUCE_H

#include "track.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Reduces a track.
 *
 * tolerance   the largest difference of a component, or, for rotations, the largest angle in radians
 * span        for as many keys as the source has; with key_interpolation if it has it. It must not overlap the arrays of
 *             the source
 * out         receives the track, which refers to the arrays of `span`; without keys after an error; may be `track`
 * difference  receives the error: the largest difference of the two tracks; infinity after an error; may be NULL
 * Returns     NKW_OK; the errors of nkw_track_validate; NKW_OUT_OF_RANGE for a tolerance that is negative or not finite;
 *             NKW_TOO_SMALL for too small arrays
 *
 * The difference of numbers is exact at all times, to the rounding of samples: between two keys of the source it is a
 * cubic, whose extremes are computed in binary64. That of rotations is measured at the keys of the source and at 1/4,
 * 1/2 and 3/4 between them, and may be 1/16 larger between these times: it is kept within 16/17 of the tolerance.
 *
 * Stack  at most 2 KiB.
 */
NKW_API nkw_result nkw_track_reduce(const nkw_track *track, float tolerance, nkw_track_span span,
                                    nkw_track *out, float *difference);

#ifdef __cplusplus
}
#endif

#endif
