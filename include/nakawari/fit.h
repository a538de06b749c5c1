/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Few cubic keys for many samples.
 *
 * A recorded or baked track has a key for each frame. nkw_track_fit replaces it by a CUBICSPLINE track, whose keys are
 * some of the samples, so that an animator can edit it again.
 */
#ifndef NAKAWARI_FIT_H
#define NAKAWARI_FIT_H

#include "track.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Bytes of working memory of nkw_track_fit, for a source of `count` keys. */
#define NKW_FIT_WORK(count, width) (((count) * ((width) + 5) + (width)) * sizeof(double))

/**
 * Fits cubic segments to the samples of a LINEAR track.
 *
 * A key of the result is a sample, with its time and value. The tangents are those with the least sum of the squared
 * differences from all samples between the keys, over all segments at once, with one velocity on both sides of a key:
 *
 *     sum over samples (y - h00(u) y_a - h01(u) y_b - d (h10(u) m_a + h11(u) m_b))^2
 *
 * h the Hermite weights, d the duration of the segment, m tangents per second. These are linear equations in the
 * tangents, with one matrix of three diagonals for all components, solved in binary64. It begins with the first and the
 * last sample. While segments exceed the tolerance, the worst of them get keys in their middle, and all tangents are
 * computed again. Samples of equal time, a jump, remain keys, and the tangents on both sides of it are independent.
 *
 * The difference is measured at the samples. Between two of them the curve is smooth, and the LINEAR track is straight:
 * nkw_track_difference measures how far they are apart.
 *
 * Rotations are fitted as four numbers and normalised by the sampler. Each key gets the sign that is nearer to the
 * sample before.
 *
 * tolerance   the largest difference of a component, or, for rotations, of the angle in radians
 * span        for as many CUBICSPLINE keys as the source has. It must not overlap the arrays of the source
 * out         receives the track, which refers to the arrays of `span`; without keys after an error; may be `track`
 * difference  receives the largest difference of a sample, at most `tolerance`; infinity after an error; may be NULL
 * work        at least NKW_FIT_WORK(count, width) of the source
 * Returns     NKW_OK; NKW_MISMATCHED if the track is not LINEAR, or has key_interpolation; NKW_OUT_OF_RANGE for a
 *             tolerance that is negative or NaN; NKW_TOO_SMALL for too small arrays or working memory; NKW_NOT_FINITE
 *             if a tangent exceeds the largest float; the errors of nkw_track_validate
 *
 * Source de Boor, A Practical Guide to Splines, 1978; Schneider, An Algorithm for Automatically Fitting Digitized
 *        Curves, Graphics Gems, 1990.
 * Stack  at most 2 KiB.
 */
NKW_API nkw_result nkw_track_fit(const nkw_track *track, float tolerance, nkw_track_span span, nkw_track *out,
                                 float *difference, nkw_work work);

#ifdef __cplusplus
}
#endif

#endif
