/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Edits of tracks: cut, shift, stretch, reverse, join, close a loop, convert axes.
 *
 * Each function reads a track and writes another one into arrays of the caller: the key capacity and the interpolation for
 * each key that nkw_track_span (track.h) needs are stated for each. The edit of a clip is the same edit of each of its
 * tracks.
 *
 *     in seconds          of a track of times T and values V
 *     nkw_track_trim      T within from..to, and keys at both ends
 *     nkw_track_retime    scale T + offset
 *     nkw_track_join      T of the first, then T of the second
 *     nkw_track_close     V with the last key equal to the first
 *
 * Key times are computed in binary64 and rounded once. Where a track is not valid (nkw_track_validate), the result has
 * no meaning, but nothing is read or written outside the arrays.
 */
#ifndef NAKAWARI_EDIT_H
#define NAKAWARI_EDIT_H

#include "axes.h"
#include "track.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The part of a track from time `from` to time `to`. A key is added where an end is between two keys: its value is the
 * sample there, and its tangents are the derivative of the curve there. Samples of the result are those of the track
 * for all times within from..to, up to rounding. A part outside the keys of the track is one key with the value that
 * the track holds there.
 *
 * A cut CUBICSPLINE rotation keeps its curve only if the new key is not normalised. The result is then of the kind
 * NKW_TRACK_ROTATION_NORMALIZED.
 *
 * span     for at most count + 1 keys; with key_interpolation if the track has it
 * out      receives the track, which refers to the arrays of `span`; without keys after an error; may be `track`
 * Returns  NKW_OK; NKW_EMPTY without keys or for width 0; NKW_BAD_WIDTH for a rotation whose width is not 4;
 *          NKW_NOT_FINITE or NKW_NOT_ASCENDING for from and to; NKW_NOT_FINITE also if a value or a tangent of the
 *          result exceeds the largest float; NKW_TOO_SMALL for too small arrays; NKW_NOT_UNIT if a new key of a
 *          CUBICSPLINE rotation deviates from length 1 by more than 1e-2: resample such a track
 *
 * Error  7.0 u of a sample of the result, of the largest value and tangent per segment.
 */
NKW_API nkw_result nkw_track_trim(const nkw_track *track, float from, float to, nkw_track_span span, nkw_track *out);

/**
 * The track at the times scale T + offset: shifted for scale 1, stretched for other positive scales, reversed for
 * negative ones. Tangents are divided by scale.
 *
 * In a reversed track each STEP segment holds the value that it held before, and the value at the time of a jump is the
 * one after it, as in every track. So a STEP segment that follows another interpolation begins with two keys at the
 * same time.
 *
 * span     for at most count keys, 2 count for a reversed track with STEP segments. For a positive scale, its arrays
 *          may be those of the track
 * out      as of nkw_track_trim
 * Returns  NKW_OK; NKW_EMPTY, NKW_BAD_WIDTH and NKW_TOO_SMALL as of nkw_track_trim; NKW_OUT_OF_RANGE for a scale that
 *          is 0 or not finite; NKW_NOT_FINITE if the first or the last time of the result, or a tangent, is not finite
 *
 * Error  1.0 u of each time and tangent.
 */
NKW_API nkw_result nkw_track_retime(const nkw_track *track, float scale, float offset, nkw_track_span span,
                                    nkw_track *out);

/**
 * The track `first`, then the track `second`, whose times are shifted so that it begins at the last time of `first`. If
 * both keys there have the same value, bit for bit, they become one key with the in-tangent of the one and the
 * out-tangent of the other. Otherwise both remain: a jump.
 *
 * span     for the keys of both; key_interpolation is needed too if one track is STEP and the other LINEAR
 * out      as of nkw_track_trim
 * Returns  NKW_OK; NKW_EMPTY, NKW_BAD_WIDTH and NKW_TOO_SMALL as of nkw_track_trim; NKW_MISMATCHED if the widths or the
 *          kinds differ, or only one is CUBICSPLINE; NKW_NOT_FINITE if the last time or a value is not finite
 */
NKW_API nkw_result nkw_track_join(const nkw_track *first, const nkw_track *second, nkw_track_span span,
                                  nkw_track *out);

/**
 * The track with its last key equal to its first, for a loop without a jump. The difference D of the last key from the
 * first is distributed over the duration. With u = 0 at the first time and 1 at the last:
 *
 *     numbers      v + (share - u) D,      D = v_last - v_first
 *     rotations    D^(share - u) q,        D = q_last q_first^-1, the shorter arc
 *
 * Tangents change by the derivative of this. Keys between which the track is LINEAR remain LINEAR, so a straight track
 * remains straight.
 *
 * share    0..1: how much of D the first key takes. 0 keeps the first key, 1 the last, to rounding; 1/2
 *          moves both by half
 * span     for count keys; its arrays may be those of the track
 * out      as of nkw_track_trim; the values of its first and its last key have the same bits, except that the last of a
 *          rotation may be negated
 * Returns  NKW_OK; NKW_EMPTY, NKW_BAD_WIDTH and NKW_TOO_SMALL as of nkw_track_trim; NKW_OUT_OF_RANGE for another share;
 *          NKW_NOT_ASCENDING for more than one key without a duration; NKW_NOT_FINITE if a value or a tangent of the
 *          result exceeds the largest float
 *
 * Error  6.0 u for rotations; numbers 3.0 u of the largest value.
 * Source Holden, Creating Looping Animations from Motion Capture, 2022.
 */
NKW_API nkw_result nkw_track_close(const nkw_track *track, float share, nkw_track_span span, nkw_track *out);

/**
 * Converts the values and tangents of a track to other axes. Samples of the converted track are the converted samples:
 * with the same bits, except the signs of zeros; those of rotations to rounding. In place, convert each array once:
 * tracks may share their values.
 *
 * kind     what the values are: a translation is NKW_AXES_VEC3
 * values   receives nkw_track_value_count(track) floats; may be track->values
 * Returns  NKW_OK; NKW_BAD_METHOD for an unknown kind; NKW_BAD_WIDTH if the width is not NKW_AXES_WIDTH(kind);
 *          NKW_OUT_OF_RANGE for a map that is not valid; NKW_TOO_SMALL if the number of floats exceeds size_t; nothing
 *          is then written
 */
NKW_API nkw_result nkw_track_convert_axes(const nkw_track *track, nkw_axes_map map, nkw_axes_kind kind, float *values);

#ifdef __cplusplus
}
#endif

#endif
