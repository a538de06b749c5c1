/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/ik.h>
#include <nakawari/mat.h>
#include <nakawari/transform.h>

#include "ik_turn.h"
#include "lane/quat.h"
#include "lane/skeleton.h"
#include "work.h"

static int is_descendant(const nkw_skeleton *skeleton, size_t joint, size_t ancestor)
{
    size_t parent = skeleton_parent(skeleton->parents, joint);
    while (parent < joint && parent != ancestor) {
        joint = parent;
        parent = skeleton_parent(skeleton->parents, joint);
    }
    return parent < joint;
}

static nkw_vec3 position_of(const nkw_ik_pose *pose, size_t joint)
{
    return nkw_mat4_translation(&pose->models[joint]);
}

/* The axes of a joint's parent: a rotation after a mirror in x, without scale. */
typedef struct parent_axes {
    lane_f64_quat rotation;
    int mirrored;
} parent_axes;

static nkw_mat4 parent_matrix(const nkw_ik_pose *pose, size_t joint)
{
    size_t parent = skeleton_parent(pose->skeleton.parents, joint);
    return parent < joint ? pose->models[parent] : pose->root ? *pose->root : nkw_mat4_identity();
}

static parent_axes parent_axes_of(const nkw_ik_pose *pose, size_t joint)
{
    nkw_mat4 m = parent_matrix(pose, joint);
    nkw_trs trs = nkw_trs_from_mat4(&m);
    parent_axes axes = {lane_f64_quat_unit_from(trs.rotation), trs.scale.x < 0.0f};
    return axes;
}

/* A vector of the models' space in the parent's axes. */
static lane_f64_vec3 vec_to_parent(const parent_axes *axes, lane_f64_vec3 v)
{
    lane_f64_vec3 r = lane_f64_quat_rotate(lane_f64_quat_conjugate(axes->rotation), v);
    r.x = axes->mirrored ? -r.x : r.x;
    return r;
}

/* A rotation of the models' space in the parent's axes. */
static lane_f64_quat turn_to_parent(const parent_axes *axes, nkw_quat turn)
{
    lane_f64_quat q = lane_f64_quat_mul(lane_f64_quat_from(turn), axes->rotation);
    q = lane_f64_quat_mul(lane_f64_quat_conjugate(axes->rotation), q);
    lane_f64_quat mirrored = {q.x, -q.y, -q.z, q.w};
    return axes->mirrored ? mirrored : q;
}

/* Rotates a joint by a rotation of the models' space. */
static void turn_joint(const nkw_ik_pose *pose, size_t joint, nkw_quat turn)
{
    nkw_trs local = nkw_pose_get(NKW_VIEW(nkw_pose, pose->pose), joint);
    parent_axes axes = parent_axes_of(pose, joint);
    lane_f64_quat q = lane_f64_quat_mul(turn_to_parent(&axes, turn), lane_f64_quat_from(local.rotation));
    local.rotation = lane_quat_from_f64(lane_f64_quat_normalize(q));
    nkw_pose_set(pose->pose, joint, &local);
}

static nkw_result check_joint(const nkw_ik_pose *pose, size_t joint)
{
    if (pose->pose.joint_count != pose->skeleton.joint_count)
        return NKW_MISMATCHED;
    return joint < pose->skeleton.joint_count ? NKW_OK : NKW_OUT_OF_RANGE;
}

static nkw_result check_limb(const nkw_ik_pose *pose, const nkw_ik_limb *limb)
{
    size_t most = limb->root > limb->mid ? limb->root : limb->mid;
    nkw_result result = check_joint(pose, most > limb->end ? most : limb->end);
    if (result != NKW_OK)
        return result;
    int ordered =
        is_descendant(&pose->skeleton, limb->mid, limb->root) && is_descendant(&pose->skeleton, limb->end, limb->mid);
    return ordered ? NKW_OK : NKW_NOT_ORDERED;
}

nkw_result nkw_ik_pose_two_bone(const nkw_ik_pose *pose, const nkw_ik_limb *limb, float *error)
{
    nkw_result result = check_limb(pose, limb);
    if (result != NKW_OK)
        return result;
    nkw_ik_two_bone t;
    t.root = position_of(pose, limb->root);
    t.mid = position_of(pose, limb->mid);
    t.end = position_of(pose, limb->end);
    t.target = limb->target;
    t.pole = limb->pole;
    t.hinge = nkw_mat4_transform_direction(&pose->models[limb->mid], limb->hinge);
    t.softness = limb->softness;
    t.weight = limb->weight;
    nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&t);
    if (!(s.error < INFINITY))
        return NKW_NOT_FINITE;
    if (error)
        *error = s.error;
    turn_joint(pose, limb->mid, s.mid);
    turn_joint(pose, limb->root, s.root);
    return NKW_OK;
}

nkw_result nkw_ik_pose_aim(const nkw_ik_pose *pose, const nkw_ik_look *look, float *error)
{
    nkw_result result = check_joint(pose, look->joint);
    if (result != NKW_OK)
        return result;
    const nkw_mat4 *model = &pose->models[look->joint];
    nkw_mat4 parent = parent_matrix(pose, look->joint);
    nkw_ik_aim aim;
    aim.position = nkw_mat4_translation(model);
    aim.offset = nkw_mat4_transform_direction(model, look->offset);
    aim.forward = nkw_mat4_transform_direction(model, look->forward);
    aim.target = look->target;
    aim.up = nkw_mat4_transform_direction(model, look->up);
    aim.pole = look->pole;
    aim.limit_axis = nkw_mat4_transform_direction(&parent, look->limit_axis);
    aim.limit_angle = look->limit_angle;
    aim.weight = look->weight;
    nkw_ik_aim_solution s = nkw_ik_aim_solve(&aim);
    if (!(s.error < INFINITY))
        return NKW_NOT_FINITE;
    if (error)
        *error = s.error;
    turn_joint(pose, look->joint, s.rotation);
    return NKW_OK;
}

/* ---- Chains ---- */

/* The first joint of a chain; joint_count of the skeleton if there are too few ancestors. */
static size_t first_of(const nkw_skeleton *skeleton, const nkw_ik_reach *reach)
{
    size_t at = reach->end;
    for (size_t k = 0; k < reach->joint_count; k++) {
        size_t parent = skeleton_parent(skeleton->parents, at);
        if (parent >= at)
            return skeleton->joint_count;
        at = parent;
    }
    return at;
}

static nkw_result check_reach(const nkw_ik_pose *pose, const nkw_ik_reach *reach, nkw_work work)
{
    nkw_result result = check_joint(pose, reach->end);
    if (result != NKW_OK)
        return result;
    if (reach->joint_count == 0)
        return NKW_EMPTY;
    if (first_of(&pose->skeleton, reach) == pose->skeleton.joint_count)
        return NKW_OUT_OF_RANGE;
    int fits = work_fits_each(work, reach->joint_count, NKW_IK_POSE_CHAIN_WORK(1));
    return fits ? NKW_OK : NKW_TOO_SMALL;
}

/* The chain in the axes of the parent of its first joint, from its first joint; the target too. */
static nkw_vec3 chain_of(const nkw_ik_pose *pose, const nkw_ik_reach *reach, nkw_quat *rotations, nkw_vec3 *offsets)
{
    size_t first = first_of(&pose->skeleton, reach), at = reach->end;
    parent_axes axes = parent_axes_of(pose, first);
    for (size_t k = reach->joint_count; k-- > 0;) {
        size_t parent = skeleton_parent(pose->skeleton.parents, at);
        lane_f64_vec3 bone =
            lane_f64_vec3_sub(lane_f64_vec3_from(position_of(pose, at)), lane_f64_vec3_from(position_of(pose, parent)));
        offsets[k] = lane_vec3_from_f64(vec_to_parent(&axes, bone));
        rotations[k] = nkw_pose_get(NKW_VIEW(nkw_pose, pose->pose), parent).rotation;
        at = parent;
    }
    lane_f64_quat rotation = {0.0, 0.0, 0.0, 1.0};
    for (size_t k = 0; k < reach->joint_count; k++) {
        rotation = lane_f64_quat_mul(rotation, lane_f64_quat_unit_from(rotations[k]));
        lane_f64_quat inverse = lane_f64_quat_conjugate(rotation);
        offsets[k] = lane_vec3_from_f64(lane_f64_quat_rotate(inverse, lane_f64_vec3_from(offsets[k])));
    }
    lane_f64_vec3 base = lane_f64_vec3_from(position_of(pose, first));
    return lane_vec3_from_f64(vec_to_parent(&axes, lane_f64_vec3_sub(lane_f64_vec3_from(reach->goal.target), base)));
}

/* Stores the rotations, weighted, in the pose and in `rotations`. */
static void store_chain(const nkw_ik_pose *pose, const nkw_ik_reach *reach, nkw_quat *rotations)
{
    float share = reach->weight > 0.0f ? reach->weight < 1.0f ? reach->weight : 1.0f : 0.0f;
    size_t at = reach->end;
    for (size_t k = reach->joint_count; k-- > 0;) {
        at = skeleton_parent(pose->skeleton.parents, at);
        nkw_trs local = nkw_pose_get(NKW_VIEW(nkw_pose, pose->pose), at);
        local.rotation = share == 1.0f ? rotations[k] : nkw_quat_slerp(local.rotation, rotations[k], share);
        rotations[k] = local.rotation;
        nkw_pose_set(pose->pose, at, &local);
    }
}

nkw_result nkw_ik_pose_chain(const nkw_ik_pose *pose, const nkw_ik_reach *reach, nkw_ik_chain_result *result,
                             nkw_work work)
{
    nkw_result status = check_reach(pose, reach, work);
    if (status != NKW_OK)
        return status;
    size_t count = reach->joint_count;
    nkw_quat *rotations = work.data;
    nkw_vec3 *offsets = (nkw_vec3 *)(void *)((float *)work.data + 8 * count);
    const nkw_work places = {rotations + count, NKW_IK_CHAIN_WORK(count)};
    nkw_ik_goal goal = reach->goal;
    nkw_ik_chain_result reached;
    goal.target = chain_of(pose, reach, rotations, offsets);
    nkw_ik_chain chain = {{0, 0, 0}, {0, 0, 0, 1}, offsets, reach->limits, count};
    status = nkw_ik_chain_solve(&chain, &goal, reach->method, rotations, &reached, places);
    if (status != NKW_OK)
        return status;
    if (!(reached.error < INFINITY))
        return NKW_NOT_FINITE;
    store_chain(pose, reach, rotations);
    reached.error = nkwi_ik_chain_error(&chain, rotations, goal.target);
    if (result)
        *result = reached;
    return NKW_OK;
}
