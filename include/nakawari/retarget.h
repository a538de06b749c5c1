/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Retargeting: a pose of one skeleton on another, whose joints have other axes, lengths or numbers.
 *
 * A rotation means something only relative to the rest pose. With the model-space rotations W of the rest poses and G
 * of the pose, each target joint t takes over how far its source joint s is rotated from rest in model space:
 *
 *     D = G_s W_s^-1                      the rotation of the source joint from its rest, in model space
 *     G_t = D W_t                         the same of the target joint
 *     local rotation = G_p^-1 G_t         p the parent of t
 *
 * If all ancestors have sources this is the formula of VRM, with the local rotations L of the rest poses and A of the
 * pose: N = W_s L_s^-1 A W_s^-1,  B = L_t W_t^-1 N W_t. If the target has fewer joints, the rotations of the missing
 * ones are included; if it has more, those without a source keep their rest rotation.
 *
 * Both rest poses should show the same posture, for example a T-pose, seen from the same direction (see `align`).
 * Lengths of bones stay those of the target. Scales of the rest pose stay. Only rotations and the translations of the
 * joints that ask for it are taken over.
 *
 * Source VRM Consortium, VRMC_vrm_animation-1.0, how_to_transform_human_pose, 2023;
 *        Rouwe, Jolt Physics, SkeletonMapper, 2022 (chains).
 */
#ifndef NAKAWARI_RETARGET_H
#define NAKAWARI_RETARGET_H

#include "axes.h"
#include "pose.h"
#include "skeleton.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The source of a target joint. D is the slerp from that of joint `from` to that of joint `to`: joints of a chain with
 * other numbers of joints lie between two of the source (nkw_retarget_map_chain).
 */
typedef struct nkw_retarget_joint {
    int32_t from; /**< a joint of the source, or NKW_NO_JOINT: the rest rotation */
    int32_t to; /**< another one; if it is none, `from` alone */
    float t; /**< 0..1 */
    /**
     * 0: the translation of the rest pose. Otherwise the factor of the difference of the translation of `from` from its
     * rest, for the hips or the root: the ratio of the heights of the hips, or nkw_retarget_chain_scale
     */
    float translation;
} nkw_retarget_joint;
NKW_SIZE(nkw_retarget_joint, 16, 16);

/** Two skeletons, their rest poses, and the map between them. */
typedef struct nkw_retarget {
    nkw_skeleton source, target;
    nkw_pose_view source_rest, target_rest;
    const nkw_retarget_joint *joints; /**< target.joint_count */
    nkw_quat align; /**< from the source's model space to the target's; zero counts as the identity */
} nkw_retarget;
NKW_SIZE(nkw_retarget, 88, 52);

/** Bytes of working memory of nkw_retarget_apply. */
#define NKW_RETARGET_WORK(source_joints, target_joints) (32 * ((source_joints) + (target_joints)))

/**
 * The pose of the target.
 *
 * The translation of a joint with a factor f, with the rest translation r of each skeleton, is
 *
 *     r_t + f G_p^-1 align G_q (x_s - r_s)          p, q the parents of target and source joint
 *
 * source   a pose of the source
 * out      a pose of the target; must not overlap `source`
 * work     NKW_RETARGET_WORK bytes of the joints of both
 * Returns  NKW_OK; NKW_MISMATCHED if a pose has another number of joints than its skeleton; NKW_TOO_SMALL; nothing is
 *          then written. A joint of the map after the last counts as none
 *
 * Error  3.0 u of the local rotation, for each level of both hierarchies: the joints from the root to the source joint,
 *        and those from the root to the target joint.
 */
NKW_API nkw_result nkw_retarget_apply(const nkw_retarget *retarget, nkw_pose_view source, nkw_pose_span out,
                                      nkw_work work);

/**
 * Checks a retargeting.
 *
 * Returns  the errors of nkw_skeleton_validate of either skeleton and of nkw_pose_validate of either rest pose;
 *          NKW_MISMATCHED for a rest pose of another number of joints; NKW_OUT_OF_RANGE if the map names a joint that
 *          the source does not have; NKW_NOT_FINITE for a t or translation that is not finite. *bad becomes the
 *          first offending joint, 0 if there is none; may be NULL
 */
NKW_API nkw_result nkw_retarget_validate(const nkw_retarget *retarget, size_t *bad);

/**
 * Maps a chain of target joints to a chain of source joints by length: joint k of the target, at the share x of the
 * length of its chain, lies between the source joints before and after x. Both chains begin and end at the same place
 * of the body, such as the lowest and the highest joint of the spine. Each is listed from its root on.
 *
 * lengths      of a joint: |rest translation|, of the first one 0. A chain of length 0 counts joints instead
 * Returns      NKW_OK; NKW_EMPTY if a chain has no joints; NKW_OUT_OF_RANGE for a joint that the skeleton does not
 *              have; nothing is then written
 * joints       the entries of the target's chain are written: from, to and t; translation stays
 */
NKW_API nkw_result nkw_retarget_map_chain(const nkw_retarget *retarget, const int32_t *source_chain,
                                          size_t source_count, const int32_t *target_chain, size_t target_count,
                                          nkw_retarget_joint *joints);

/**
 * The ratio of the lengths of two chains in the rest poses, such as legs: the sum of |rest translation| of all joints
 * of the target's chain except the first, divided by that of the source's. The translation of the hips is scaled by it,
 * or by the ratio of the heights of the hips in the rest poses.
 *
 * scale    receives the ratio
 * Returns  NKW_OK; NKW_EMPTY if a chain has no joints; NKW_OUT_OF_RANGE for a joint that the skeleton does not have;
 *          NKW_NOT_FINITE if the ratio is not positive and finite, as of a chain without length; nothing is then
 *          written
 */
NKW_API nkw_result nkw_retarget_chain_scale(const nkw_retarget *retarget, const int32_t *source_chain,
                                            size_t source_count, const int32_t *target_chain, size_t target_count,
                                            float *scale);

/**
 * Converts a pose to other axes: joint j receives nkw_axes_convert_trs of its transform. The padding becomes that of an
 * identity. `out` may be `pose`. Returns NKW_MISMATCHED if out has another number of joints; nothing is then written.
 */
NKW_API nkw_result nkw_pose_convert_axes(nkw_pose_view pose, nkw_axes_map map, nkw_pose_span out);

#ifdef __cplusplus
}
#endif

#endif
