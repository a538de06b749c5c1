/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Blend spaces: the weights of animations that are samples of one or more parameters, such as the speed and
 * the direction of a walk: the nodes of a blend tree that blend by parameters.
 *
 * Gradient band interpolation: sample i has the weight
 *
 *     h_i = min over j of 1 - (p - p_i).(p_j - p_i) / |p_j - p_i|^2,      clamped to 0..1
 *     w_i = h_i / sum of h
 *
 * The weights are continuous, 0..1, sum to 1, and need no triangles. At a sample its own weight is exactly 1. In one
 * dimension they are those of linear interpolation between neighbours. Outside, the nearest samples keep their weights.
 * The layers of nkw_pose_layers_blend take the weights as they are.
 *
 * Source Johansen, Automated Semi-Procedural Animation for Character Locomotion, Aarhus University, 2009, chapter 6.
 */
#ifndef NAKAWARI_BLENDSPACE_H
#define NAKAWARI_BLENDSPACE_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How distances are measured. */
typedef enum nkw_blendspace_kind {
    NKW_BLENDSPACE_CARTESIAN, /**< by differences of the parameters */
    /**
     * Two parameters that are a velocity: by the difference of the lengths, relative to their mean, and by the angle
     * between the directions times 2. A jog to the left is between a jog ahead and a walk to the left. For a sample or
     * a point at the origin the angle counts as 0. A sample a quarter turn or more away counts in both directions
     * around the circle.
     */
    NKW_BLENDSPACE_POLAR,
    NKW_BLENDSPACE_KIND_MAX_ENUM = 0x7fffffff
} nkw_blendspace_kind;

/** The samples of a blend space. */
typedef struct nkw_blendspace {
    const float *samples; /**< count * dimension numbers, one sample after the other */
    size_t count;
    size_t dimension; /**< of a sample and of a point; at least 1 */
    nkw_blendspace_kind kind; /**< POLAR needs dimension 2 */
} nkw_blendspace;
NKW_SIZE(nkw_blendspace, 32, 16);

/**
 * The weights of a point. Takes time as count^2 * dimension.
 *
 * point    dimension numbers
 * weights  receives count numbers, 0..1, with the sum 1 to rounding. Samples at the same place share their weight.
 *          Samples that are not finite have the weight 0 and no effect on others. If the point is not finite, all
 *          finite samples have the same weight
 * Returns  NKW_EMPTY without samples or for dimension 0; NKW_BAD_METHOD for an unknown kind, or POLAR of another
 *          dimension than 2; nothing is then written
 *
 * Error  1.0 u of 1, for samples whose distances are not small against their magnitude.
 */
NKW_API nkw_result nkw_blendspace_weights(const nkw_blendspace *space, const float *point, float *weights);

/**
 * Checks a blend space.
 *
 * Returns  NKW_EMPTY without samples or for dimension 0; NKW_BAD_METHOD for an unknown kind, or POLAR of another
 *          dimension than 2; NKW_NOT_FINITE; NKW_REPEATED for a sample at the place of an earlier one. *bad
 *          becomes the first offending sample, 0 if there is none; it may be NULL
 */
NKW_API nkw_result nkw_blendspace_validate(const nkw_blendspace *space, size_t *bad);

#ifdef __cplusplus
}
#endif

#endif
