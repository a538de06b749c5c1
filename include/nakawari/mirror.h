/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Left and right of a rig whose joints do not have mirrored axes: poses mirrored through the rest pose, and partners by
 * their names.
 *
 * nkw_pose_mirror (blend.h) is the mirrored figure only if the mirrored rest pose is the rest pose. In many rigs the
 * right side has other axes: those of the left turned by half a turn (Maya's mirrored behaviour, MMD), or any. Then
 * the motion away from the rest pose is what is mirrored.
 */
#ifndef NAKAWARI_MIRROR_H
#define NAKAWARI_MIRROR_H

#include <stdint.h>

#include "blend.h"
#include "pose.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What the mirror of a rig needs. Nothing is owned. */
typedef struct nkw_mirror_rig {
    const int32_t *parents; /**< as of nkw_skeleton, one for each joint of `rest` */
    const int32_t *pair; /**< the partner of each joint; its own index in the middle */
    nkw_pose_view rest; /**< the rest pose: the same posture on both sides; rotations unit */
    nkw_mirror plane; /**< of the space of the root joints' parent, the model's */
} nkw_mirror_rig;
NKW_SIZE(nkw_mirror_rig, 40, 20);

/** The bytes of working memory of nkw_pose_mirror_rest. */
#define NKW_MIRROR_WORK(joint_count) (16 * (joint_count))

/**
 * Mirrors a pose through the rest pose. With W the model rotations of the rest pose, M the reflection, p the partner of
 * joint j, q its parent:
 *
 *     C_j = W_j^-1 (M W_p M)                   the axes of the partner, mirrored, in those of j; C = 1 above a root
 *
 *     rotation        C_q (M r_p M) C_j^-1     so in model space G'_j = M G_p W_p^-1 M W_j
 *     translation     rest_j + C_q M (t_p - rest_p)
 *     scale           the diagonal of C_j S_p C_j^-1
 *
 * The translation of a joint that does not leave that of its rest pose is the rest pose's, so bones keep their lengths
 * also where the rest positions of both sides differ a little. Where they are mirrored exactly, it is that of G'. Where
 * all C are the identity, the result is that of nkw_pose_mirror, to rounding. Rests are posed with scales that are
 * positive and even; the rotations of W are the products of those of the rest pose.
 *
 * out         may be `pose`; otherwise it must not overlap it
 * difference  *difference becomes the largest angle of a C_j in radians, 0 without joints: near 0 nkw_pose_mirror fits
 *             the rig, near pi an axis is reversed. It may be NULL
 * work        NKW_MIRROR_WORK(joint_count) bytes
 * Returns     NKW_MISMATCHED if rest or out has another number of joints; NKW_BAD_METHOD for an unknown plane;
 *             NKW_OUT_OF_RANGE if a partner or parent is no joint; NKW_NOT_ORDERED if a parent does not come before its
 *             child; NKW_BAD_MIRROR if pair[pair[j]] is not j, or the parent of the partner is not the partner of the
 *             parent; NKW_TOO_SMALL; nothing is then written. *bad becomes the first offending joint, 0 if there is
 *             none; it may be NULL
 */
NKW_API nkw_result nkw_pose_mirror_rest(nkw_pose_view pose, const nkw_mirror_rig *rig, nkw_pose_span out,
                                        float *difference, size_t *bad, nkw_work work);

/**
 * Partners by names. Two names are partners if they are equal except for one word:
 *
 *     Left Right, left right, LEFT RIGHT      anywhere: mixamorig:LeftArm, thigh_left
 *     L R, l r                                between ends, "_", ".", "-", ":" and spaces: hand.L, L_Foot, Bip01 L Arm;
 *                                             or first and before a capital: lShldr
 *     the Japanese words for left and right   anywhere, in UTF-8
 *
 * names   joint_count names; a NULL has no partner
 * pair    receives joint_count partners: a joint without one has its own index. Of several that fit the first is taken
 * Returns the number of pairs. The time is quadratic.
 */
NKW_API size_t nkw_mirror_pairs_from_names(const char *const *names, size_t joint_count, int32_t *pair);

#ifdef __cplusplus
}
#endif

#endif
