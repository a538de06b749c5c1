/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Left and right of a rig whose joints do not have mirrored axes: poses and tracks mirrored through the rest pose, and
 * partners by their names or their places.
 *
 * nkw_pose_mirror (blend.h) is the mirrored figure only if the mirrored rest pose is the rest pose. In many rigs the
 * right side has other axes: those of the left turned by half a turn (Maya's mirrored behaviour, MMD), or any. Then
 * the motion away from the rest pose is what is mirrored.
 */
#ifndef NAKAWARI_MIRROR_H
#define NAKAWARI_MIRROR_H

#include <stdint.h>

#include "axes.h"
#include "blend.h"
#include "pose.h"
#include "skeleton.h"
#include "track.h"
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

/** The bytes of working memory of nkw_pose_mirror_rest and nkw_track_mirror_rest. */
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
 * Mirrors a track: its values become those of the partner of its joint, by the formulas of nkw_pose_mirror_rest. They
 * are linear or affine in the values, and of a joint the same at all times. So the key times stay, tangents are mapped
 * too, and a sample of the result is the mirrored sample, to rounding, of all interpolations. A whole clip is mirrored
 * by this call for each track; rig->pair is then the joint of the track. Tracks may share values: in place, mirror each
 * array once.
 *
 * joint    that of the track
 * kind     NKW_CLIP_AXES of its target: NKW_AXES_QUAT, NKW_AXES_VEC3 for a translation, or NKW_AXES_SCALE
 * values   receives nkw_track_value_count(track) floats for the joint pair[joint]; may be track->values
 * work     NKW_MIRROR_WORK(joint_count) bytes; the call takes a time of joints plus keys
 * Returns  as nkw_pose_mirror_rest, without its `bad`; NKW_OUT_OF_RANGE also for a joint after the last;
 *          NKW_BAD_METHOD also for another kind; NKW_BAD_WIDTH if the width is not that of the kind; nothing is then
 *          written
 */
NKW_API nkw_result nkw_track_mirror_rest(const nkw_track *track, const nkw_mirror_rig *rig, size_t joint,
                                         nkw_axes_kind kind, float *values, nkw_work work);

/**
 * Partners by places: the joint whose mirrored place is nearest, among the children of the partner of the parent. A
 * joint may be nearest to itself. Of those that are not more than tolerance/16 farther than the nearest, one with as
 * many descendants is taken, then the first. So names are not needed, and the result fits nkw_pose_mirror_rest except
 * where a joint of one side has no partner.
 *
 * models     of the rest pose, in the space of the plane
 * tolerance  the largest distance of a mirrored joint from its partner: above what the sides differ by, below half the
 *            distance of neighbouring joints
 * pair       receives joint_count partners: a joint without one has its own index
 * Returns the number of pairs. The time is quadratic. A parent that does not come before its child counts as none; an
 * unknown plane does not mirror.
 */
NKW_API size_t nkw_mirror_pairs_from_models(const nkw_skeleton *skeleton, const nkw_mat4 *models, nkw_mirror plane,
                                            float tolerance, int32_t *pair);

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
