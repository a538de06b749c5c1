/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Blending of poses: two poses by a parameter, any number of poses by weights, additive poses, mirroring.
 *
 * A crossfade is nkw_pose_blend by t = elapsed / duration, or by an ease of it (ease.h); transition.h has transitions
 * that sample the new animation only. A blend tree is a call of these functions for each of its nodes; the weights of
 * a node that blends by parameters are those of blendspace.h.
 *
 * All poses and masks of a call have the same joint_count; otherwise the result is NKW_MISMATCHED and nothing is
 * written. A mask has one float for each joint, by which the weight is multiplied: 0 excludes the joint, 1 applies the
 * whole weight. It is padded like one array of a pose: NKW_POSE_STRIDE(joint_count) floats. A mask with NULL data is 1
 * for every joint. Masks are clamped to 0..1; NaN counts as 0.
 *
 * Weights below 0 and above 1: t of a blend of two poses extrapolates on both sides; the weight of a layer and of an
 * additive pose counts as 0 below 0. Above 1 a layer takes its share of the sum, and an additive pose extrapolates.
 *
 * Without joints nothing is read or written. `out` may be one of the input poses; otherwise it must not overlap them.
 * Its padding may be written. The result of a joint depends on the inputs of that joint only, except for the order of
 * layers of equal weight.
 *
 * Example  nkw_pose_view a, b; nkw_pose_span out; nkw_mask_view mask; nkw_mask_span to; nkw_skeleton skeleton;
 *          const nkw_pose_layer *layers; const int32_t *pair; float t; size_t bad;
 *
 *     nkw_pose_blend(a, b, t, mask, out);                         crossfade: nlerp of all joints
 *     nkw_pose_blend_slerp(a, b, t, mask, out);                   rotations at constant speed
 *     nkw_pose_layers_blend(layers, 3, a, 0.1f, out);             many poses by weights
 *     nkw_mask_validate(mask, &bad);
 *     nkw_pose_layers_validate(layers, 3, 24, &bad);              which layer is wrong
 *     nkw_pose_additive_build(a, b, NKW_ADDITIVE_LOCAL, out);     the difference of two poses
 *     nkw_pose_additive_apply(a, b, t, mask, NKW_ADDITIVE_LOCAL, out);    added to a third
 *     nkw_pose_mirror(a, pair, NKW_MIRROR_X, out, &bad);          left for right
 *     nkw_mask_from_subtree(&skeleton, 3, to);                    a joint and all below it
 */
#ifndef NAKAWARI_BLEND_H
#define NAKAWARI_BLEND_H

#include <stdint.h>

#include "pose.h"
#include "skeleton.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A mask to read: NKW_POSE_STRIDE(joint_count) floats. data NULL: 1 for every joint. */
typedef struct nkw_mask_view {
    const float *data;
    size_t joint_count;
} nkw_mask_view;
NKW_SIZE(nkw_mask_view, 16, 8);
/** A mask to write. */
typedef struct nkw_mask_span {
    float *data;
    size_t joint_count;
} nkw_mask_span;
NKW_SIZE(nkw_mask_span, 16, 8);

/**
 * Interpolates from pose a to pose b: translations and scales by nkw_lerp, rotations by nkw_quat_nlerp, bit for bit.
 *
 * t        any; multiplied by the mask of the joint. Outside 0..1 it extrapolates; NaN counts as 0. An infinite t
 *          yields infinities and NaN, also where the mask is 0.
 * Returns  the result code. out is exactly a at t = 0 and exactly b at t = 1, except that a rotation of b is negated if
 *          its dot product with that of a is negative.
 *
 * Stack  at most 16 KiB.
 */
NKW_API nkw_result nkw_pose_blend(nkw_pose_view a, nkw_pose_view b, float t, nkw_mask_view mask, nkw_pose_span out);

/**
 * The same with nkw_quat_slerp for the rotations: the angular velocity is constant in t. Rotations must be finite also
 * where the mask is 0.
 *
 * Stack  at most 17 KiB.
 */
NKW_API nkw_result nkw_pose_blend_slerp(nkw_pose_view a, nkw_pose_view b, float t, nkw_mask_view mask,
                                        nkw_pose_span out);

/** A pose that takes part in a blend of many. */
typedef struct nkw_pose_layer {
    nkw_pose_view pose;
    float weight; /**< at least 0; the sum may be any. Negative and NaN count as 0, above 2^60 as 2^60 */
    nkw_mask_view mask; /**< the weight of a joint is weight * mask */
} nkw_pose_layer;
NKW_SIZE(nkw_pose_layer, 40, 20);

/**
 * The weighted mean of any number of poses, joint by joint. The order of `layers` changes no bit of the result.
 *
 *     w_i = weight_i mask_i,   W = sum w_i,   w_rest = max(threshold - W, 0)
 *
 *     translation, scale   (sum w_i v_i + w_rest v_rest) / (W + w_rest)
 *     rotation             the same sum of +-q_i, normalised
 *
 * Where the sum of the weights is below the threshold, the rest pose takes the missing weight. Where no layer has a
 * weight, the result is the rest pose bit for bit, for any threshold. Weights need not sum to 1.
 *
 * Layers are sorted before they are added: by weight, the largest first. Layers of equal weight are sorted, in each
 * block of 128 joints, by the bits of the first number in which their masks or poses differ.
 *
 * Signs: with s_ik = -1 where q_i . q_k < 0, else 1, the rotation is the eigenvector of the largest eigenvalue of
 *
 *     A = sum over i and k of w_i w_k s_ik q_i q_k^T
 *
 * If there are signs s_i with s_ik = s_i s_k for all pairs, A = v v^T, and the rotation is v = sum s_i w_i q_i, made
 * unit: so two layers take the shorter arc, as nkw_quat_nlerp, and so do all layers within 90 degrees of one of them.
 * Otherwise, from three rotations on, the eigenvector is computed. A is continuous in the weights: the mean does not
 * jump where two weights exchange their order or a layer fades out, only where the two largest eigenvalues of A are
 * equal (single points of the space of weights: three shorter arcs that together are a whole turn have such a point). It
 * is that of nkw_quat_mean (Markley) to at most 0.0013 rad for rotations within 0.5 rad of each other, 0.011 within
 * 1 rad, 0.11 within 2 rad; on average to 0.0001, 0.0007, 0.007. Of more than 32 layers with a weight each is
 * added with the sign for which its dot product with the sum so far is not negative, and the mean can jump.
 *
 * The mean is computed by lerps: sum = lerp(sum, v, w / (total + w)). Therefore these results are exact, bit for bit:
 * translations and scales that are equal in all layers, rotations that are equal in both of two layers; the transform
 * of a joint on which only one layer has a weight, or on which the share of one layer rounds to 1; two layers without
 * masks, which are nkw_pose_blend from the layer of larger weight to the other. A layer has no effect on a joint where
 * its weight is 0.
 *
 * layers     layer_count layers; may be none
 * threshold  0.1 is usual. 0, negative or NaN: the rest pose is used only where no layer has a weight
 *
 * The time grows linearly with the number of layers; the sort is quadratic and is noticeable from about 20 layers.
 *
 * Error  9.5 u of rotations, for up to eight layers (5.0 u for up to four); 7.8 u of the largest of the translations or
 *        scales (7.5 u where the rest pose takes no weight).
 * Stack  at most 16 KiB.
 */
NKW_API nkw_result nkw_pose_layers_blend(const nkw_pose_layer *layers, size_t layer_count, nkw_pose_view rest,
                                         float threshold, nkw_pose_span out);

/**
 * Checks a mask.
 *
 * Returns  NKW_EMPTY without joints; NKW_NOT_FINITE if a number is not finite; NKW_BAD_WEIGHTS if one is not in 0..1.
 *          *bad becomes the first offending joint, 0 if there is none; it may be NULL.
 */
NKW_API nkw_result nkw_mask_validate(nkw_mask_view mask, size_t *bad);

/**
 * Checks layers; there may be none. The numbers of the poses are not read: nkw_pose_validate checks them.
 *
 * Returns  NKW_EMPTY without joints and for a layer without a pose; NKW_MISMATCHED if a pose or mask has another number
 *          of joints; NKW_NOT_FINITE if a weight is not finite; NKW_BAD_WEIGHTS if one is not in 0..2^60; otherwise the
 *          result of nkw_mask_validate. *bad becomes the first offending layer, 0 if there is none; it may be NULL.
 */
NKW_API nkw_result nkw_pose_layers_validate(const nkw_pose_layer *layers, size_t layer_count, size_t joint_count,
                                            size_t *bad);

/** The side on which the rotation of an additive pose is multiplied. */
typedef enum nkw_additive {
    NKW_ADDITIVE_LOCAL, /**< in the axes of the joint:       base * delta,  delta = ref^-1 a */
    NKW_ADDITIVE_PARENT, /**< in the axes of its parent:      delta * base,  delta = a ref^-1 */
    NKW_ADDITIVE_MAX_ENUM = 0x7fffffff
} nkw_additive;

/**
 * The additive pose from ref to a. nkw_pose_additive_apply applies it to another pose.
 *
 *     translation  a - ref,    rotation  ref^-1 a  or  a ref^-1,    scale  a / ref
 *
 * Where a scale of ref is 0, the ratio is 1. Rotations are computed in binary64 and rounded once. The inverse of a
 * rotation of ref is its conjugate divided by its squared length; a zero quaternion counts as no rotation.
 *
 * Returns  NKW_BAD_METHOD for an unknown side; nothing is then written.
 *
 * Stack  at most 3 KiB.
 */
NKW_API nkw_result nkw_pose_additive_build(nkw_pose_view a, nkw_pose_view ref, nkw_additive side, nkw_pose_span out);

/**
 * Applies an additive pose to base with the weight w = weight * mask.
 *
 *     translation  base + w delta,    rotation  base * part  or  part * base,    scale  base * lerp(1, delta, w)
 *
 *     part = nkw_quat_nlerp(+-1, delta, w), the sign of the identity 1 being that of delta.w
 *
 * weight   at least 0; negative and NaN count as 0, above 2^60 as 2^60. Above 1 it extrapolates.
 * Returns  NKW_BAD_METHOD for an unknown side. out is exactly base at w = 0. With delta built from a and ref, base =
 *          ref and w = 1 yield a, with the signs of its rotations: translations exactly where a and ref have the same
 *          sign and differ by at most a factor of two; scales exactly where the scale of ref is a power of two or
 *          equals that of a. Otherwise see Error. The product of two unit rotations is of unit length to rounding; it
 *          is not normalised.
 *
 * Error   2.7 u of rotations in apply(build(a, ref), ref) against a; scales 2.0 u of themselves, translations 1.0 u of
 *         |a - ref| + |a|.
 * Stack  at most 11 KiB.
 */
NKW_API nkw_result nkw_pose_additive_apply(nkw_pose_view base, nkw_pose_view delta, float weight, nkw_mask_view mask,
                                           nkw_additive side, nkw_pose_span out);

/** The plane of the reflection. */
typedef enum nkw_mirror {
    NKW_MIRROR_X, /**< the plane x = 0: exchanges left and right of a character that looks along z */
    NKW_MIRROR_Y,
    NKW_MIRROR_Z,
    NKW_MIRROR_MAX_ENUM = 0x7fffffff
} nkw_mirror;

/**
 * Mirrors a pose: joint j receives the reflected transform of joint pair[j].
 *
 *     plane x = 0:   translation (-x, y, z),   rotation (x, -y, -z, w),   scale unchanged
 *
 * Only signs change, so applying it twice restores the original bits. The result is the mirrored figure if the mirrored
 * bind pose is the bind pose; mirror.h has the form for all other rigs, and says whether this one fits. In some rigs
 * this holds, in one of the planes, only for the joints below the hip; docs/subjects/pose/blend.md shows how to correct
 * the hip and the joints above it.
 *
 * pair     joint_count partners: the left hand has the index of the right hand and vice versa, the head its own index
 * Returns  NKW_BAD_METHOD for an unknown plane; NKW_OUT_OF_RANGE if a partner is not in 0..joint_count - 1;
 *          NKW_BAD_MIRROR if pair[pair[j]] is not j; nothing is then written. *bad becomes the first offending joint, 0
 *          if there is none; it may be NULL
 */
NKW_API nkw_result nkw_pose_mirror(nkw_pose_view pose, const int32_t *pair, nkw_mirror plane, nkw_pose_span out,
                                   size_t *bad);

/**
 * The mask of a subtree: 1 for the joint `root` and all its descendants, 0 for the others and in the padding. A parent
 * index that is not less than the joint's own counts as none. If root >= joint_count, all are 0.
 */
NKW_API nkw_result nkw_mask_from_subtree(const nkw_skeleton *skeleton, size_t root, nkw_mask_span mask);

#ifdef __cplusplus
}
#endif

#endif
