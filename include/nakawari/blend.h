/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 5: poses blended: two by a weight, any number by their weights, differences put on top, left and right
 * exchanged.
 *
 * All poses and masks of a call have the same joint_count; otherwise the result is NKW_MISMATCHED and nothing is written.
 * A mask is one float for each joint, 0 (the joint takes no part) to 1 (it takes all of the weight), padded as one array
 * of a pose: NKW_POSE_STRIDE(joint_count) floats. A mask whose data are NULL is 1 for every joint. Masks outside 0..1 count as 0 or 1, NaN as 0.
 *
 * Without joints nothing is read or written. `out` may be any of the input poses itself, otherwise it must not overlap
 * them; its padding may be written. A joint's result depends on that joint's inputs alone, but for the order of layers
 * of one weight.
 */
#ifndef NAKAWARI_BLEND_H
#define NAKAWARI_BLEND_H

#include <stdint.h>

#include "pose.h"
#include "skeleton.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A mask that is read: NKW_POSE_STRIDE(joint_count) floats. data NULL: 1 for every joint. */
typedef struct nkw_mask_view {
    const float *data;
    size_t joint_count;
} nkw_mask_view;
/** A mask that is written. */
typedef struct nkw_mask_span {
    float *data;
    size_t joint_count;
} nkw_mask_span;

/** The same mask, to be read. */
static inline nkw_mask_view nkw_mask_view_from_span(nkw_mask_span mask)
{
    nkw_mask_view view = {mask.data, mask.joint_count};
    return view;
}

/**
 * The pose at t of the way from a to b: translations and scales by nkw_lerp, rotations by nkw_quat_nlerp, bit for bit.
 *
 * t      any; times the joint's mask. Outside 0..1 the way goes on; NaN counts as 0. An infinite one gives infinities
 *        and NaN, where the mask is 0 too.
 * mask   of each joint
 * Gives  exactly a at t = 0, exactly b at t = 1, but for the sign of a rotation: b or -b, on a's side.
 */
NKW_API nkw_result nkw_pose_blend(nkw_pose_view a, nkw_pose_view b, float t, nkw_mask_view mask, nkw_pose_span out);

/**
 * The same with nkw_quat_slerp for the rotations: each turns at constant speed as t goes on. Rotations must be finite
 * also where they have no part.
 */
NKW_API nkw_result nkw_pose_blend_slerp(nkw_pose_view a, nkw_pose_view b, float t, nkw_mask_view mask,
                                        nkw_pose_span out);

/** A pose that takes part in a blend of many. */
typedef struct nkw_pose_layer {
    nkw_pose_view pose;
    float weight; /**< from 0, of any sum; negative and NaN count as 0, from 2^60 on as 2^60 */
    nkw_mask_view mask; /**< the joint's weight is weight * mask */
} nkw_pose_layer;

/**
 * The weighted mean of any number of poses, joint by joint, in whatever order they come: the result has the same bits.
 *
 *     w_i = weight_i mask_i,   W = sum w_i,   w_rest = max(threshold - W, 0)
 *
 *     translation, scale   (sum w_i v_i + w_rest v_rest) / (W + w_rest)
 *     rotation             the same sum of +-q_i, normalised
 *
 * Where the weights fall short of the threshold, the rest pose makes up for what is missing; where no layer has a
 * weight it is taken bit for bit, whatever the threshold. Weights need not sum to 1.
 *
 * Layers are added in an order of their own: the heaviest first, those of one weight by the first number, as bits, in
 * which their masks or poses differ, in each block of 128 joints. That makes the order of `layers` of no account for
 * any bit. Each rotation is added with the sign that puts it on the side of the sum so far, so the heaviest layer says
 * which side that is, and two layers take the shorter arc. (A fixed side, such as the rest pose's, would tear apart
 * layers that agree on a half turn away from it.) Three and more rotations of which some are more than half a turn
 * apart have no mean that is continuous in the weights: there the result may jump where two weights change places.
 *
 * The mean is made by lerps: sum = lerp(sum, v, w / (total + w)). So translations and scales that all layers share come
 * out bit for bit, as does a joint on which one layer alone has a weight, or so much of it that its share rounds to 1,
 * its rotation too; and two layers without masks are nkw_pose_blend from the heavier to the lighter, bit for bit. A
 * layer has no effect at all on a joint where it has no weight.
 *
 * layers     layer_count of them, 0 too
 * threshold  0 or less, and NaN: the rest pose only where nothing else is; 0.1 is usual
 *
 * The time grows with the number of layers, and for their order with its square, which shows from about 20 on.
 * Error  7.8 u of the largest of the translations or scales, for up to eight layers (5.8 u where the rest pose has
 *        nothing to make up for); of rotations 6.2 u (5.9 u so, up to four layers 3.3).
 */
NKW_API nkw_result nkw_pose_blend_layers(const nkw_pose_layer *layers, size_t layer_count, nkw_pose_view rest,
                                         float threshold, nkw_pose_span out);

/**
 * Checks a mask: NKW_EMPTY without joints; NKW_NOT_FINITE where a number is not finite; NKW_BAD_WEIGHTS where one is
 * not in 0..1. *bad_joint becomes the first offending joint, 0 if there is none; it may be NULL.
 */
NKW_API nkw_result nkw_mask_validate(nkw_mask_view mask, size_t *bad_joint);

/**
 * Checks layers, which may be none: NKW_EMPTY for a layer without a pose, and without joints; NKW_MISMATCHED for a pose or a
 * mask of another number of joints; NKW_NOT_FINITE where a
 * weight is not finite; NKW_BAD_WEIGHTS where one is not in 0..2^60; what nkw_mask_validate gives for a mask.
 * *bad_layer becomes the first offending layer, 0 if there is none; it may be NULL. Poses have nkw_pose_validate.
 */
NKW_API nkw_result nkw_pose_layers_validate(const nkw_pose_layer *layers, size_t layer_count, size_t joint_count,
                                            size_t *bad_layer);

/** On which side of a rotation a difference is. Any other number is read as NKW_ADDITIVE_LOCAL. */
typedef enum nkw_additive {
    NKW_ADDITIVE_LOCAL, /**< in the joint's own axes:  base * delta,  delta = ref^-1 a */
    NKW_ADDITIVE_PARENT /**< in its parent's axes:     delta * base,  delta = a ref^-1 */
} nkw_additive;

/**
 * The difference of the pose a from the pose ref, a pose itself: to be put on another one by nkw_pose_additive_apply.
 *
 *     translation  a - ref,    rotation  ref^-1 a  or  a ref^-1,    scale  a / ref
 *
 * A scale of 0 in ref gives the ratio 1. Rotations are worked out in binary64 and rounded once; a ref that is not unit
 * is divided by its length twice, as an inverse is; a zero quaternion counts as no rotation.
 */
NKW_API nkw_result nkw_pose_additive_build(nkw_pose_view a, nkw_pose_view ref, nkw_additive side, nkw_pose_span out);

/**
 * base with the part w = weight * mask of a difference on top.
 *
 *     translation  base + w delta,    rotation  base * part  or  part * base,    scale  base * lerp(1, delta, w)
 *
 * part is nkw_quat_nlerp of no rotation and delta; as 1 and -1 are both none, it starts from the one on delta's side.
 *
 * weight  from 0; negative and NaN count as 0, from 2^60 on as 2^60. Above 1 the difference is overdone.
 * mask    of each joint
 * Gives   exactly base at w = 0. With the difference of a from ref, apply(ref) at w = 1 is a, its rotations with their
 *         signs: translations exactly where a and ref have one sign and differ by at most a factor of two, scales
 *         exactly where ref's is a power of two or a's own. Elsewhere see Error. The product of two unit rotations is
 *         unit to rounding, it is not normalised.
 *
 * Error   2.7 u of rotations in apply(build(a, ref), ref) against a; scales 2.0 u of themselves, translations 1.0 u of
 *         |a - ref| + |a|.
 */
NKW_API nkw_result nkw_pose_additive_apply(nkw_pose_view base, nkw_pose_view delta, nkw_additive side, float weight,
                                           nkw_mask_view mask, nkw_pose_span out);

/** The plane through the origin that is the mirror. Any other number is read as NKW_MIRROR_X. */
typedef enum nkw_mirror {
    NKW_MIRROR_X, /**< the plane x = 0: left and right where a character looks along z */
    NKW_MIRROR_Y,
    NKW_MIRROR_Z
} nkw_mirror;

/**
 * The pose seen in a mirror: joint j takes the mirrored transform of joint pair[j].
 *
 *     plane x = 0:   translation (-x, y, z),   rotation (x, -y, -z, w),   scale as it is
 *
 * Only signs change, so twice gives the original bits. It is the mirrored figure where the skeleton is symmetric in its
 * axes too: where the mirrored bind pose is the bind pose. Some rigs are so, in one of the planes, for the pairs and
 * all else below the hip: how the hip and the joints above it are put right stands in docs/floors/5-blend.md.
 *
 * pair   joint_count partners: the left hand has the right one's index and the other way round, the head its own. A
 *        partner that is out of range or has another partner itself counts as none: that joint is mirrored in its
 *        place.
 */
NKW_API nkw_result nkw_pose_mirror(nkw_pose_view pose, const int32_t *pair, nkw_mirror plane, nkw_pose_span out);

/**
 * Checks a map of partners: NKW_EMPTY without joints; NKW_OUT_OF_RANGE where a partner is not in 0..joint_count - 1;
 * NKW_BAD_MIRROR where pair[pair[j]] is not j. *bad_joint becomes the first offending joint, 0 if there is none; it may
 * be NULL.
 */
NKW_API nkw_result nkw_mirror_validate(const int32_t *pair, size_t joint_count, size_t *bad_joint);

/**
 * The mask of a joint and all below it: 1 for those, 0 for the others and in the padding. A parent that is not before
 * its child counts as none. A root that is not below joint_count: all 0.
 */
NKW_API nkw_result nkw_mask_from_subtree(const nkw_skeleton *skeleton, size_t root, nkw_mask_span mask);

#ifdef __cplusplus
}
#endif

#endif
