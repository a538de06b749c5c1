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

/** The memory of nkw_track_fit. It must not overlap the arrays of the source. */
typedef struct nkw_fit_memory {
    float *times; /**< key_capacity floats */
    float *values; /**< key_capacity * 3 * width floats */
    size_t key_capacity; /**< at least the number of keys of the source */
    double *work; /**< work_count doubles of working memory, at least NKW_FIT_WORK of the source */
    size_t work_count;
} nkw_fit_memory;
NKW_SIZE(nkw_fit_memory, 40, 20);

/** The number of doubles of working memory of nkw_track_fit. */
#define NKW_FIT_WORK(count, width) ((count) * ((width) + 5) + (width))

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
 * out         receives the track, which refers to `memory`; without keys after an error; may be `track`
 * difference  receives the largest difference of a sample, at most `tolerance` if that is not negative; infinity after
 *             an error; may be NULL
 * Returns     NKW_OK; NKW_BAD_METHOD if the track is not LINEAR, or has key_interpolation; NKW_TOO_SMALL for too little
 *             memory; NKW_NOT_FINITE if a tangent exceeds the largest float; the errors of nkw_track_validate
 *
 * Source de Boor, A Practical Guide to Splines, 1978; Schneider, An Algorithm for Automatically Fitting Digitized
 *        Curves, Graphics Gems, 1990.
 * Stack  at most 2 KiB.
 */
NKW_API nkw_result nkw_track_fit(const nkw_track *track, float tolerance, const nkw_fit_memory *memory, nkw_track *out,
                                 float *difference);

#ifdef __cplusplus
}
#endif

#endif
