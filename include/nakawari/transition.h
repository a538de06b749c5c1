/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Transitions of whole poses without a jump: inertialisation and dead blending of all joints. Unlike a crossfade
 * (nkw_pose_blend of blend.h), they do not sample the old animation any more.
 *
 * The formulas are those of inertia.h, joint by joint and bit for bit: translation and scale as vectors, the rotation
 * as a rotation. The caller keeps the state of a transition in one block of floats. The velocities of the joints, nine
 * arrays, come from two poses of the last frames (nkw_pose_velocity_from_poses).
 *
 * All poses, velocities and states of a call have the same joint_count; otherwise the result is NKW_MISMATCHED and
 * nothing is written. Without joints nothing is read or written. `out` may be the pose `to`; padding may be written.
 */
#ifndef NAKAWARI_TRANSITION_H
#define NAKAWARI_TRANSITION_H

#include "inertia.h"
#include "pose.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Floats in the velocities of a pose: nine arrays of NKW_POSE_STRIDE(joint_count), for the translation x y z, the
 * angular velocity x y z in the frame of the parent, and the scale x y z. For arrays on the stack.
 */
#define NKW_POSE_VELOCITY_FLOATS(joint_count) (9 * NKW_POSE_STRIDE(joint_count))

/** Velocities of all joints, to read. data NULL: all 0. */
typedef struct nkw_pose_velocity_view {
    const float *data;
    size_t joint_count;
} nkw_pose_velocity_view;
NKW_SIZE(nkw_pose_velocity_view, 16, 8);
/** Velocities of all joints, to write. */
typedef struct nkw_pose_velocity_span {
    float *data;
    size_t joint_count;
} nkw_pose_velocity_span;
NKW_SIZE(nkw_pose_velocity_span, 16, 8);

/**
 * The velocities from two poses: differences divided by the time, and nkw_quat_angular_velocity.
 *
 * duration  seconds between the poses; 0 and NaN return velocities of 0
 *
 * Source Bollo, Inertialization: High-Performance Animation Transitions in Gears of War, GDC 2018.
 * Stack  at most 2 KiB.
 */
NKW_API nkw_result nkw_pose_velocity_from_poses(nkw_pose_view before, nkw_pose_view now, float duration,
                                                nkw_pose_velocity_span out);

/** Floats in the state of an inertialisation: three coefficients and a duration for each of three vectors. */
#define NKW_POSE_INERTIA_FLOATS(joint_count) (30 * NKW_POSE_STRIDE(joint_count))

/** The offsets of all joints: NKW_POSE_INERTIA_FLOATS(joint_count) floats of the caller. */
typedef struct nkw_pose_inertia {
    float *data;
    size_t joint_count;
} nkw_pose_inertia;
NKW_SIZE(nkw_pose_inertia, 16, 8);

/** A pose and its velocities. */
typedef struct nkw_pose_state {
    nkw_pose_view pose;
    nkw_pose_velocity_view velocity;
} nkw_pose_state;
NKW_SIZE(nkw_pose_state, 32, 16);

/**
 * Begins an inertialisation: nkw_vec3_offset_begin for translations and scales, nkw_quat_offset_begin for rotations.
 *
 * inertia   receives the offsets
 * from      the last pose that was shown; of a transition that still runs, its result
 * to        the first pose of the new motion
 * duration  seconds
 *
 * Stack  at most 5 KiB.
 */
NKW_API nkw_result nkw_pose_inertia_begin(nkw_pose_inertia inertia, const nkw_pose_state *from,
                                          const nkw_pose_state *to, float duration);

/**
 * The pose t seconds after the transition began, from the pose of the new motion at that time. From the duration on it
 * is that pose, bit for bit: then the transition may be dropped.
 *
 * Stack  at most 3 KiB.
 */
NKW_API nkw_result nkw_pose_inertia_evaluate(nkw_pose_inertia inertia, nkw_pose_view to, float t, nkw_pose_span out);

/** Floats in the state of a dead blend: a pose, its velocities, and the differences of the rotations. */
#define NKW_POSE_DEAD_BLEND_FLOATS(joint_count) (23 * NKW_POSE_STRIDE(joint_count))

/** The state of a dead blend: NKW_POSE_DEAD_BLEND_FLOATS(joint_count) floats of the caller, and the times. */
typedef struct nkw_pose_dead_blend {
    float *data;
    size_t joint_count;
    float half_life, duration; /**< as nkw_offset */
} nkw_pose_dead_blend;
NKW_SIZE(nkw_pose_dead_blend, 24, 16);

/** Begins a dead blend: copies the pose and its velocities into the state. */
NKW_API nkw_result nkw_pose_dead_blend_begin(const nkw_pose_dead_blend *blend, const nkw_pose_state *from);

/**
 * The pose t seconds after the transition began: nkw_vec3_offset_evaluate for translations and scales,
 * nkw_quat_offset_evaluate for rotations. The state receives the differences of the rotations.
 *
 * Stack  at most 5 KiB.
 */
NKW_API nkw_result nkw_pose_dead_blend_evaluate(const nkw_pose_dead_blend *blend, nkw_pose_view to, float t,
                                                nkw_pose_span out);

#ifdef __cplusplus
}
#endif

#endif
