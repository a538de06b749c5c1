/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Samples of a few joints or of one channel of a clip, and velocities beside poses: of clips, and through blends of two poses.
 */
#ifndef NAKAWARI_CLIP_MOTION_H
#define NAKAWARI_CLIP_MOTION_H

#include <stdint.h>

#include "blend.h"
#include "clip.h"
#include "transition.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * nkw_clip_sample of some joints, with the same bits: a hand, what a camera is attached to; or the first joints, for a
 * character that is far away. Other joints of the pose are written or not, in part too.
 *
 * joints   joint_count joints, in any order; those that the clip does not have are ignored. NULL: the joints
 *          0 .. joint_count - 1
 * cursors  as those of nkw_clip_sample; may be NULL
 * pose     of the joints of the clip. Afterwards nkw_pose_get returns a joint
 * Returns  NKW_OK; NKW_MISMATCHED for a pose with another number of joints: nothing is written
 *
 * The time is that of the blocks of 16 neighbouring joints that are asked for, and of the constant tracks.
 *
 * Stack  at most 15 KiB.
 */
NKW_API nkw_result nkw_clip_sample_joints(const nkw_clip *clip, float time, const uint32_t *joints, size_t joint_count,
                                          uint32_t *cursors, nkw_pose_span pose);

/**
 * nkw_clip_sample of one channel, with the same bits: a translation, a rotation, a scale or a separate float. The time is
 * that of one block of 16 lanes for each number of the channel; no other joint is computed.
 *
 * index    the joint, or the float
 * cursors  as those of nkw_clip_sample; may be NULL
 * values   receives 3, 4, 3 or 1 numbers
 * Returns  NKW_OK; NKW_BAD_METHOD for an unknown target; NKW_OUT_OF_RANGE after the last joint or float: nothing is
 *          written
 *
 * Stack  at most 15 KiB.
 */
NKW_API nkw_result nkw_clip_sample_channel(const nkw_clip *clip, float time, nkw_clip_target target, uint32_t index,
                                           uint32_t *cursors, float *values);

/** The bytes of working memory of nkw_clip_sample_velocity. */
#define NKW_CLIP_VELOCITY_WORK(joint_count, float_count) (4 * (2 * NKW_POSE_FLOATS(joint_count) + 2 * (float_count)))

/**
 * The velocities at `time`, of the keys and not of two poses: of each track the velocity of nkw_track_sample_motion.
 *
 *     numbers        LINEAR (b - a)/h, STEP 0, CUBICSPLINE the derivative of the cubic; per second
 *     rotations      the angular velocity in the frame of the parent, radians per second: LINEAR 2 log(b a^-1)/h along
 *                    the shorter arc, STEP 0, CUBICSPLINE 2 Im(p' p*)/|p|^2
 *
 * At a key they are those of the segment that begins there, at the last key of the segment that ends there. Before the
 * first and after the last key of a track they are 0, and so are those of constant tracks.
 *
 * velocity  of the joints of the clip; receives all joints, and 0 in the padding; data may be NULL
 * floats    receives the velocities of the separate floats; may be NULL
 * work      NKW_CLIP_VELOCITY_WORK of the clip's joints and floats
 * Returns   NKW_OK; NKW_MISMATCHED for another number of joints; NKW_TOO_SMALL for too little working memory; nothing
 *           is then written
 *
 * Error  that of nkw_track_sample_motion, for the keys that the clip stores.
 * Stack  at most 15 KiB.
 */
NKW_API nkw_result nkw_clip_sample_velocity(const nkw_clip *clip, float time, nkw_pose_velocity_span velocity,
                                            float *floats, nkw_work work);

/**
 * The velocity of nkw_pose_blend(a, b, t, mask) where t changes by `rate` per second. With w = t mask, w' = rate mask, 0
 * where the mask is 0:
 *
 *     translation, scale   v = (va + w (vb - va)) + w' (b - a)
 *     rotation             n = (1 - w) qa + w c,   c = qb or -qb, whose dot product with qa is not negative
 *                          n' = (1 - w) qa' + w c' + w' (c - qa),   q' = (omega/2) q
 *                          omega = 2 Im(n' n*)/|n|^2,   0 where n is 0
 *
 * in binary64, rounded once. A velocity without data is 0. An ease of t has rate = (its derivative) / duration.
 *
 * out      receives all joints, and 0 in the padding; may be a velocity of a or b
 * Returns  NKW_MISMATCHED for different numbers of joints; nothing is then written
 *
 * Error  1.0 u of |va| + |vb| + |w' (b - a)| for t in 0..1 and quaternions less than a right angle apart.
 */
NKW_API nkw_result nkw_pose_velocity_blend(const nkw_pose_state *a, const nkw_pose_state *b, float t, float rate,
                                           nkw_mask_view mask, nkw_pose_velocity_span out);

#ifdef __cplusplus
}
#endif

#endif
