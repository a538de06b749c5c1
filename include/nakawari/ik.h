/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Inverse kinematics: rotations of joints so that a limb, a head or a chain reaches a target.
 *
 * Each solver has two forms. The geometric form takes positions and directions, all in one space, and returns rotations
 * in that space. The form for poses takes joints of a skeleton with their model matrices, and changes the local
 * rotations of a pose. It does not update the matrices: call nkw_skeleton_models_from_pose for the subtree afterwards.
 *
 * Every solver returns the error that is left after rounding: how far the end is from the target, or the angle that
 * the aim misses. A target that is out of reach is no failure: the result is as near as the joints permit.
 *
 * Solvers compute in binary64 and round once. If an input is not finite, the geometric solvers of a limb and an aim
 * return identities with an infinite error; all others return NKW_NOT_FINITE and change nothing. An error is never NaN.
 * A weight is clamped to 0..1, NaN to 0. At weight 0 nothing is rotated; at 1 the solution is complete; between, each
 * rotation is the slerp from the identity.
 *
 * Model matrices may mirror and scale. If a parent's matrix scales unevenly, rotations of a pose are approximate and
 * the error does not include this.
 */
#ifndef NAKAWARI_IK_H
#define NAKAWARI_IK_H

#include "limit.h"
#include "pose.h"
#include "skeleton.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A limb of two bones: thigh and shin, upper arm and forearm. Positions and directions are in one space. */
typedef struct nkw_ik_two_bone {
    nkw_vec3 root, mid, end; /**< positions of hip, knee and ankle */
    nkw_vec3 target; /**< where the end should be */
    /**
     * The direction in which the middle joint points, seen from the line from root to target; any length. The plane of
     * the limb is rotated about this line until the middle joint is on that side. Zero: the plane is not rotated.
     */
    nkw_vec3 pole;
    /**
     * The axis of the middle joint where the limb is straight, to within 1/4 rad to either side, and its plane is
     * therefore not known well: a positive rotation about it extends the limb. Any length. Zero: the limb bends in its
     * plane and to its side, however small the bend; below 2^-18 rad, to the pole, or to any side without a pole.
     */
    nkw_vec3 hinge;
    /**
     * The share of the limb's length, 0..1, over which its extension slows down. 0: the limb extends fully. Greater
     * shares prevent a sudden full extension, and leave a distance to targets near the full length. A limb that is
     * extended farther already slows down from there: a target at its end, or nearer, is reached.
     */
    float softness;
    float weight; /**< 0..1 */
} nkw_ik_two_bone;
NKW_SIZE(nkw_ik_two_bone, 80, 80);

/** The rotations of the two joints. Apply `mid` first, about the middle joint, then `root` about the root joint. */
typedef struct nkw_ik_two_bone_solution {
    nkw_quat root, mid;
    nkw_vec3 mid_position, end_position; /**< after both rotations */
    float error; /**< the distance of the end from the target */
} nkw_ik_two_bone_solution;
NKW_SIZE(nkw_ik_two_bone_solution, 60, 60);

/**
 * Solves a limb of two bones (two-bone IK). With the lengths a, b of the bones and the distance d from root to target:
 *
 *     L = a + b,  s = min(softness L, L - |end - root|)
 *     reach r = d                                              d <= L - s
 *             = L - s exp(-(d - (L - s)) / s)                  beyond: smooth, below L
 *     then clamped to |a - b| .. L
 *     mid: the angle beta between the bones becomes            r^2 = a^2 + b^2 - 2 a b cos beta
 *     root: the shortest rotation of the end to the target's direction, then about this direction to the pole
 *
 * The middle joint rotates only about the normal of the limb's plane, so twist is kept; so is the plane without a pole.
 * Within 1/4 rad of straight a given hinge h, perpendicular to the first bone, is heard. With the normal n on its side
 * and k = sin(bend) / sin(1/4), the axis is that of k n + (1 - k) h, and the second bone is first moved to the plane
 * across it by the shortest rotation. A limb past straight, with its normal against the hinge, bends back through
 * straight.
 *
 * The half angles are algebraic, (a + b + r)(a + b - r) and (r + a - b)(r - a + b) over 4 a b: exact near the straight
 * limb.
 *
 *     target at the root          r = |a - b|, the end keeps its direction; the error is |a - b|
 *     target out of reach         the limb is straight towards it, or folded; the error is the rest
 *     straight limb               bends about `hinge`, to within 1/4 rad
 *     a bone of length zero       the other bone aims at the target
 *     both of length zero         identities; the error is the distance of the target
 *     pole along the target line  no rotation about the line
 *
 * Error  2.8 u of a + b: the distance of the end from a target within reach, by the rounded rotations.
 * Source Holden, Simple Two Joint IK, 2017; Nicholas, Soft IK, xsi-blog.com, article 108, 2007 (soft reach).
 * Stack  at most 2 KiB.
 */
NKW_API nkw_ik_two_bone_solution nkw_ik_two_bone_solve(const nkw_ik_two_bone *limb);

/** A joint that points at a target: a head, an eye, a gun. All vectors are in one space, for the present rotation. */
typedef struct nkw_ik_aim {
    nkw_vec3 position; /**< of the joint */
    nkw_vec3 offset; /**< from the joint to the start of the ray, which rotates with the joint; zero: at the joint */
    nkw_vec3 forward; /**< the direction of the ray, any length */
    nkw_vec3 target; /**< the point that the ray should pass through */
    nkw_vec3 up; /**< a direction of the joint, any length; zero: no rotation about the line to the target */
    nkw_vec3 pole; /**< the direction that `up` is rotated to, about the line to the target; zero: none */
    nkw_vec3 limit_axis; /**< the axis of the cone that the ray stays in, any length; zero: no limit */
    float limit_angle; /**< the angle between the axis and the edge of the cone, clamped to 0..pi; NaN: no limit */
    float weight; /**< 0..1 */
} nkw_ik_aim;
NKW_SIZE(nkw_ik_aim, 92, 92);

/** The rotation of the joint about its position. The angle, 0..pi, from the ray to the target, seen from its start. */
typedef struct nkw_ik_aim_solution {
    nkw_quat rotation;
    float error;
} nkw_ik_aim_solution;
NKW_SIZE(nkw_ik_aim_solution, 20, 20);

/**
 * Aims a joint at a target. The ray from `offset` along f = forward/|forward| meets the sphere about the joint, on
 * which the target lies, at
 *
 *     i = offset + s f,      s = -offset.f + sqrt(d^2 - h^2),    h^2 = |offset|^2 - (offset.f)^2,  d the distance
 *
 * The shortest rotation moves i to the target. Then `up` is rotated about this direction to the plane of the pole. Then
 * the ray is rotated back into the cone, to the nearest direction of its edge.
 *
 *     target nearer than h        the ray passes the target as near as it can: the root counts as 0
 *     target behind the start     as a line, the ray passes through the target; the error is pi
 *     target at the joint         no rotation, except into the cone
 *     forward zero                no rotation; the error is 0
 *
 * Error  2.0 u of 1 rad: the angle that the ray misses by the rounded rotation, if offset is zero. With an offset more
 *        where d is near h, as the square root has.
 * Source Guillaume Blanc, ozz-animation, ik_aim_job (the sphere and the pole), 2019.
 * Stack  at most 2 KiB.
 */
NKW_API nkw_ik_aim_solution nkw_ik_aim_solve(const nkw_ik_aim *aim);

/**
 * A chain of joints, each with one child: a tail, a spine, a tentacle. Joint 0 rotates relative to `rotation`, each
 * other joint relative to the joint before it.
 */
typedef struct nkw_ik_chain {
    nkw_vec3 position; /**< of joint 0 */
    nkw_quat rotation; /**< of the parent of joint 0; unit */
    const nkw_vec3 *offsets; /**< count vectors: the next joint, or the end of the chain, in the space of each joint */
    const nkw_limit *limits; /**< NULL, or count limits of the local rotations (limit.h) */
    size_t count; /**< joints that rotate */
} nkw_ik_chain;
NKW_SIZE(nkw_ik_chain, 56, 40);

/** When to stop. */
typedef struct nkw_ik_goal {
    nkw_vec3 target; /**< where the end of the chain should be */
    float tolerance; /**< the distance at which to stop; at least 0 */
    uint32_t iterations; /**< at most so many; 10 is a usual number */
} nkw_ik_goal;
NKW_SIZE(nkw_ik_goal, 20, 20);

/** What a solver of chains reached. */
typedef struct nkw_ik_chain_result {
    float error; /**< the distance of the end from the target */
    uint32_t iterations; /**< so many were needed */
} nkw_ik_chain_result;
NKW_SIZE(nkw_ik_chain_result, 8, 8);

/** How a chain is solved. */
typedef enum nkw_ik_method {
    /**
     * Forward and backward reaching: positions are moved from the end to the root and from the root to the end, each to
     * the length of its bone; in the second pass each joint is rotated by the shortest arc to its next position, and
     * clamped by its limit. Bends all joints alike; converges in fewer iterations than cyclic coordinate descent. A
     * target out of reach is answered in one iteration by a straight chain, without limits.
     *
     * With limits, positions that were moved freely may be ones that no joint may take, and reaching stalls. From the
     * first iteration that leaves more than half of the error, each rotates all joints by damped least squares, and
     * after 24 without a better result, from the best, by cyclic coordinate descent. Take this method with limits too:
     * it needs a tenth of the iterations of NKW_IK_CCD, and ends where that does or nearer; of targets that are drawn
     * without regard to reach, 0.3 % end more than 1 mm farther, for a chain of 2 m.
     */
    NKW_IK_FABRIK,
    /**
     * Cyclic coordinate descent: from the last joint to the first, each is rotated by the shortest arc that turns the
     * end to the target, and clamped by its limit. Moves the last joints most. Converges slowly where the chain is
     * nearly straight. Needs no working memory.
     */
    NKW_IK_CCD,
    NKW_IK_METHOD_MAX_ENUM = 0x7fffffff
} nkw_ik_method;

/** Bytes of working memory of nkw_ik_chain_solve by NKW_IK_FABRIK. */
#define NKW_IK_CHAIN_WORK(joint_count) (16 * (joint_count))

/**
 * Solves a chain. Limits also clamp rotations that need not move.
 *
 * rotations  count local rotations, unit; changed in place
 * result     receives the error and the iterations; may be NULL. Not written after an error
 * work       NKW_IK_CHAIN_WORK(chain->count) bytes by NKW_IK_FABRIK; none by NKW_IK_CCD
 * Returns    NKW_OK; NKW_BAD_METHOD for an unknown method; NKW_OUT_OF_RANGE for a negative tolerance; NKW_NOT_FINITE if
 *            the tolerance is NaN, or another number, except those of limits, is not finite; NKW_TOO_SMALL; nothing is
 *            then changed
 *
 * If all joints, the end and the target are on one line, no joint has a reason to bend: each joint is then first
 * rotated by 1/8 rad about a perpendicular axis, of more than 16 joints by 2/count rad. Without joints the error is the
 * distance of `position`.
 *
 * Without limits the error of NKW_IK_CCD never grows after that first bend. With limits it may stay above the
 * tolerance, although a solution exists. NKW_IK_FABRIK with limits returns the least error that it found: a chain of 4
 * bones of 0.5 m with cones of 0.6 rad comes within 1 mm of 99.9 % of the targets that it can reach, in 7 iterations on
 * average, of 200; NKW_IK_CCD of 94 %, in 117.
 *
 * Source Aristidou, Lasenby, FABRIK: A Fast, Iterative Solver for the Inverse Kinematics Problem, 2011;
 *        Wang, Chen, A Combined Optimization Method for Solving the Inverse Kinematics Problem, 1991;
 *        Wampler, Manipulator Inverse Kinematic Solutions Based on Vector Formulations and Damped Least-Squares
 *        Methods, 1986.
 * Stack  at most 2 KiB.
 */
NKW_API nkw_result nkw_ik_chain_solve(const nkw_ik_chain *chain, const nkw_ik_goal *goal, nkw_ik_method method,
                                      nkw_quat *rotations, nkw_ik_chain_result *result, nkw_work work);

/** A pose whose rotations are solved. */
typedef struct nkw_ik_pose {
    nkw_skeleton skeleton;
    const nkw_mat4 *models; /**< joint_count model matrices of the pose */
    const nkw_mat4 *root; /**< the matrix above the root joints; NULL: none */
    nkw_pose_span pose; /**< changed in place */
} nkw_ik_pose;
NKW_SIZE(nkw_ik_pose, 48, 24);

/** The joints of a limb; mid is a descendant of root, end of mid. Joints between them, as for twist, move along. */
typedef struct nkw_ik_limb {
    size_t root, mid, end;
    nkw_vec3 target; /**< in the space of the models */
    nkw_vec3 pole; /**< a direction in the space of the models, or zero */
    nkw_vec3 hinge; /**< a direction in the space of the middle joint, or zero */
    float softness, weight;
} nkw_ik_limb;
NKW_SIZE(nkw_ik_limb, 72, 56);

/**
 * nkw_ik_two_bone_solve on a pose: changes the local rotations of root and mid.
 *
 * error    receives the error; may be NULL. Not written after an error
 * Returns  NKW_OK; NKW_MISMATCHED if the pose has another number of joints than the skeleton; NKW_OUT_OF_RANGE for a
 *          joint after the last; NKW_NOT_ORDERED if mid is not a descendant of root, or end not of mid; NKW_NOT_FINITE
 *          if a number of the limb or of its matrices is not finite; nothing is then changed
 *
 * Stack  at most 2 KiB.
 */
NKW_API nkw_result nkw_ik_pose_two_bone(const nkw_ik_pose *pose, const nkw_ik_limb *limb, float *error);

/** A joint that aims. */
typedef struct nkw_ik_look {
    size_t joint;
    nkw_vec3 target; /**< in the space of the models */
    nkw_vec3 forward, offset, up; /**< in the space of the joint */
    nkw_vec3 pole; /**< a direction in the space of the models, or zero */
    nkw_vec3 limit_axis; /**< in the space of the joint's parent, or zero: no limit */
    float limit_angle, weight;
} nkw_ik_look;
NKW_SIZE(nkw_ik_look, 88, 84);

/**
 * nkw_ik_aim_solve on a pose: changes the local rotation of one joint. Arguments and results as nkw_ik_pose_two_bone.
 * To share a look between spine, neck and head, call it for each with weights, from the spine on, with updated models.
 *
 * Stack  at most 2 KiB.
 */
NKW_API nkw_result nkw_ik_pose_aim(const nkw_ik_pose *pose, const nkw_ik_look *look, float *error);

/** A chain of joints of a skeleton. */
typedef struct nkw_ik_reach {
    size_t end; /**< the joint that should be at the target; it is not rotated */
    size_t joint_count; /**< the number of its ancestors that rotate, at least 1 */
    nkw_ik_goal goal; /**< the target is in the space of the models */
    const nkw_limit *limits; /**< NULL, or joint_count limits, from the ancestor nearest to the root on */
    nkw_ik_method method;
    float weight; /**< 0..1; between, the rotations may leave their limits a little */
} nkw_ik_reach;
NKW_SIZE(nkw_ik_reach, 56, 40);

/** Bytes of working memory of nkw_ik_pose_chain. */
#define NKW_IK_POSE_CHAIN_WORK(joint_count) (44 * (joint_count))

/**
 * nkw_ik_chain_solve on a pose: changes the local rotations of `joint_count` ancestors of the joint `end`. Arguments as
 * nkw_ik_pose_two_bone.
 *
 * result   receives the error, after the weight, and the iterations; may be NULL. Not written after an error
 * work     NKW_IK_POSE_CHAIN_WORK(reach->joint_count) bytes
 * Returns  as nkw_ik_pose_two_bone and nkw_ik_chain_solve; NKW_EMPTY for joint_count 0; NKW_OUT_OF_RANGE if `end` has
 *          fewer ancestors
 *
 * Stack  at most 3 KiB.
 */
NKW_API nkw_result nkw_ik_pose_chain(const nkw_ik_pose *pose, const nkw_ik_reach *reach, nkw_ik_chain_result *result,
                                     nkw_work work);

#ifdef __cplusplus
}
#endif

#endif
