/* SPDX-License-Identifier: MIT */
/**
 * @file
 * A pose: the local transforms of all joints at one time, in component arrays.
 *
 * The data of a pose are one block of NKW_POSE_FLOATS(joint_count) floats: ten arrays of NKW_POSE_STRIDE(joint_count)
 * floats. The first joint_count floats of an array belong to the joints, the rest is padding.
 *
 *     array   0 1 2              3 4 5 6           7 8 9
 *             translation x y z  rotation x y z w  scale x y z
 *
 *     component c of joint j:  data[c * NKW_POSE_STRIDE(joint_count) + j]
 *
 * The stride is a multiple of 16, so loops of every vector width run without a remainder. Padding may hold any values,
 * or be memory that was never written: no function computes with it. Functions that write a whole pose may write padding
 * too. Alignment for float suffices; 64 bytes is fastest.
 *
 * Example  nkw_pose_span pose; nkw_pose_view view; nkw_trs_view in; nkw_trs_span out; nkw_trs p, list[24];
 *          size_t n, bad;
 *
 *     n = nkw_pose_floats(24);                 floats of 24 joints
 *     in = nkw_pose_components(view);          its component arrays
 *     out = nkw_pose_components_span(pose);
 *     nkw_pose_identity(pose);
 *     p = nkw_pose_get(view, 3);               one joint
 *     nkw_pose_set(pose, 3, &p);
 *     nkw_pose_from_trs(list, pose);
 *     nkw_trs_from_pose(view, list);
 *     nkw_pose_validate(view, &bad);           which joint is wrong
 */
#ifndef NAKAWARI_POSE_H
#define NAKAWARI_POSE_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Floats from one component array of a pose to the next: joint_count rounded up to a multiple of 16. */
#define NKW_POSE_STRIDE(joint_count) (((joint_count) + 15) / 16 * 16)

/** Floats in the block of a pose; for arrays on the stack. */
#define NKW_POSE_FLOATS(joint_count) (10 * NKW_POSE_STRIDE(joint_count))

/** A pose to read: NKW_POSE_FLOATS(joint_count) floats. */
typedef struct nkw_pose_view {
    const float *data;
    size_t joint_count;
} nkw_pose_view;
NKW_SIZE(nkw_pose_view, 16, 8);
/** A pose to write. */
typedef struct nkw_pose_span {
    float *data;
    size_t joint_count;
} nkw_pose_span;
NKW_SIZE(nkw_pose_span, 16, 8);

/** NKW_POSE_FLOATS as a function, for languages without the macro; SIZE_MAX if size_t cannot hold the number. */
NKW_API size_t nkw_pose_floats(size_t joint_count);

/** The ten arrays of a pose, for batch functions: nkw_mat4_from_trs_n(nkw_pose_components(pose), out, joint_count). */
NKW_API nkw_trs_view nkw_pose_components(nkw_pose_view pose);
NKW_API nkw_trs_span nkw_pose_components_span(nkw_pose_span pose);

/** Sets every joint and the padding to the identity: no translation, no rotation, scale 1. */
NKW_API void nkw_pose_identity(nkw_pose_span pose);

/** Returns the transform of one joint; the identity if joint >= pose.joint_count. */
NKW_API nkw_trs nkw_pose_get(nkw_pose_view pose, size_t joint);
/** Sets the transform of one joint. Returns NKW_OUT_OF_RANGE if joint >= pose.joint_count. */
NKW_API nkw_result nkw_pose_set(nkw_pose_span pose, size_t joint, const nkw_trs *trs);

/** Copies joint_count transforms into a pose and back, bit for bit. The padding of the pose becomes the identity. */
NKW_API void nkw_pose_from_trs(const nkw_trs *trs, nkw_pose_span pose);
NKW_API void nkw_trs_from_pose(nkw_pose_view pose, nkw_trs *out);

/**
 * Checks a pose.
 *
 * Returns  NKW_EMPTY without joints; NKW_NOT_FINITE if a number is not finite; NKW_NOT_UNIT if the length of a rotation
 *          differs from 1 by more than 1e-2. *bad becomes the first offending joint, 0 if there is none; it may be
 *          NULL.
 */
NKW_API nkw_result nkw_pose_validate(nkw_pose_view pose, size_t *bad);

#ifdef __cplusplus
}
#endif

#endif
