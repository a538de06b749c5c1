/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Layered blends of poses: masks that rise along a branch, blend times of each joint, rotations in model space.
 *
 * A difference in the axes of a joint or of its parent turns with the body: an aim to the side that is added to a bowed
 * spine lifts a level arm. In model space the arm stays level. nkw_skeleton_compose_rotations replaces the rotation of each joint
 * by that in model space, nkw_skeleton_separate_rotations restores the rotations relative to the parents. Between the
 * two, any function of blend.h blends, adds and masks rotations of model space; translations and scales stay local.
 *
 *     layered    compose a and b;  nkw_pose_blend by the mask;  separate
 *     additive   compose a and ref;  nkw_pose_additive_build with NKW_ADDITIVE_PARENT:  delta = A ref^-1
 *                compose base;  nkw_pose_additive_apply with NKW_ADDITIVE_PARENT:  delta base;  separate
 *
 * A joint outside the mask keeps its rotation in model space, whatever its parents do: masks should have whole
 * branches.
 *
 * Source Epic Games, Unreal Engine, AnimationRuntime.cpp, 2014 to 2022: ConvertPoseToMeshRotation of both poses, then
 *        ConvertTransformToAdditive, A ref^-1 of the rotations; Layered Blend Per Bone (Mesh Space Rotation Blend,
 *        Blend Depth), Blend Profiles (Time Factor).
 */
#ifndef NAKAWARI_LAYER_H
#define NAKAWARI_LAYER_H

#include "blend.h"
#include "ease.h"
#include "pose.h"
#include "skeleton.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The mask of a branch that rises from joint to joint. With d the number of joints from `root` to a descendant,
 *
 *     mask = min((d + 1) / depth, 1),        0 for all joints that are neither root nor below it, and in the padding
 *
 * depth    joints over which the weight rises to 1. Up to 1, and NaN: nkw_mask_from_subtree
 * Returns  NKW_MISMATCHED if the mask has another number of joints. A parent index that is not less than the joint's
 *          own counts as none. If root >= joint_count, all are 0
 */
NKW_API nkw_result nkw_mask_from_branch(const nkw_skeleton *skeleton, size_t root, float depth, nkw_mask_span mask);

/**
 * The mask of a transition in which each joint has its own time, as weights of the new pose.
 *
 *     mask = ease(min(elapsed / time, 1)), clamped to 0..1;        1 for a time of 0, negative or NaN; padding is 0
 *
 * times    seconds, one of each joint of the mask
 * elapsed  seconds since the transition began; negative and NaN count as 0
 * ease     NKW_EASE_LINEAR for weights that rise at a constant rate
 */
NKW_API nkw_result nkw_mask_from_times(const float *times, float elapsed, nkw_ease_kind ease, nkw_mask_span mask);

/**
 * Replaces the rotation of each joint by its rotation in model space, R_j = R_parent r_j. Translations and scales are
 * copied. Each product is computed in binary64 and rounded once.
 *
 * out      may be `pose`
 * Returns  NKW_MISMATCHED for different numbers of joints. A parent index that is not less than the joint's own counts
 *          as none. Rotations should be of unit length; below a rotation of length 0 all are 0
 */
NKW_API nkw_result nkw_skeleton_compose_rotations(const nkw_skeleton *skeleton, nkw_pose_view pose, nkw_pose_span out);

/**
 * The reverse, r_j = R_parent^-1 R_j: the rotations of a pose in model space become those relative to the parents.
 * Inverses are conjugates divided by the squared length; a zero quaternion counts as no rotation.
 *
 * Error  2.0 u of rotations in separate(compose(pose)) against pose, however many parents a joint has: two roundings
 *        of unit quaternions, each by at most 1.0 u. 1.50 u was measured.
 */
NKW_API nkw_result nkw_skeleton_separate_rotations(const nkw_skeleton *skeleton, nkw_pose_view pose, nkw_pose_span out);

#ifdef __cplusplus
}
#endif

#endif
