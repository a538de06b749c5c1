/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/layer.h>

#include "lane/blend.h"
#include "lane/quat.h"
#include "lane/scalar.h"
#include "lane/skeleton.h"

nkw_result nkw_mask_from_branch(const nkw_skeleton *skeleton, size_t root, float depth, nkw_mask_span mask)
{
    const size_t joints = mask.joint_count, stride = NKW_POSE_STRIDE(joints);
    if (skeleton->joint_count != joints)
        return NKW_MISMATCHED;
    for (size_t j = 0; j < stride; j++) { /* first d + 1, 0 outside */
        const size_t parent = j < joints ? skeleton_parent(skeleton->parents, j) : j;
        const float above = parent < j ? mask.data[parent] : 0.0f;
        mask.data[j] = j == root && j < joints ? 1.0f : above > 0.0f ? above + 1.0f : 0.0f;
    }
    for (size_t j = 0; j < joints; j++)
        mask.data[j] = depth > 1.0f ? lane_mask(mask.data[j] / depth) : lane_mask(mask.data[j]);
    return NKW_OK;
}

nkw_result nkw_mask_from_times(const float *times, float elapsed, nkw_ease_kind ease, nkw_mask_span mask)
{
    const float known = elapsed > 0.0f ? elapsed : 0.0f;
    for (size_t j = 0; j < NKW_POSE_STRIDE(mask.joint_count); j++) {
        const float time = j < mask.joint_count ? times[j] : 0.0f;
        const float share = known < time ? known / time : 1.0f;
        mask.data[j] = j < mask.joint_count ? lane_mask(nkw_ease_evaluate(ease, share).value) : 0.0f;
    }
    return NKW_OK;
}

/* ---- Rotations in model space ---- */

static nkw_quat rotation_at(const float *data, size_t stride, size_t j)
{
    const float *x = data + 3 * stride + j;
    const nkw_quat q = {x[0], x[stride], x[2 * stride], x[3 * stride]};
    return q;
}

static void set_rotation(float *data, size_t stride, size_t j, nkw_quat q)
{
    float *x = data + 3 * stride + j;
    x[0] = q.x;
    x[stride] = q.y;
    x[2 * stride] = q.z;
    x[3 * stride] = q.w;
}

/* Returns 0 if the joints differ. */
static int copy_pose(const nkw_skeleton *skeleton, nkw_pose_view pose, nkw_pose_span out)
{
    if (pose.joint_count != out.joint_count || skeleton->joint_count != out.joint_count)
        return 0;
    if (out.joint_count && pose.data != out.data)
        memcpy(out.data, pose.data, NKW_POSE_FLOATS(out.joint_count) * sizeof(float));
    return 1;
}

nkw_result nkw_skeleton_compose_rotations(const nkw_skeleton *skeleton, nkw_pose_view pose, nkw_pose_span out)
{
    const size_t stride = NKW_POSE_STRIDE(out.joint_count);
    if (!copy_pose(skeleton, pose, out))
        return NKW_MISMATCHED;
    for (size_t j = 0; j < out.joint_count; j++) {
        const size_t parent = skeleton_parent(skeleton->parents, j);
        if (parent >= j)
            continue;
        const lane_f64_quat above = lane_f64_quat_from(rotation_at(out.data, stride, parent));
        const lane_f64_quat own = lane_f64_quat_from(rotation_at(out.data, stride, j));
        set_rotation(out.data, stride, j, lane_quat_from_f64(lane_f64_quat_mul(above, own)));
    }
    return NKW_OK;
}

/* From the last joint to the first, so that the parents still have their rotations in model space. */
nkw_result nkw_skeleton_separate_rotations(const nkw_skeleton *skeleton, nkw_pose_view pose, nkw_pose_span out)
{
    const size_t stride = NKW_POSE_STRIDE(out.joint_count);
    if (!copy_pose(skeleton, pose, out))
        return NKW_MISMATCHED;
    for (size_t j = out.joint_count; j-- > 0;) {
        const size_t parent = skeleton_parent(skeleton->parents, j);
        if (parent >= j)
            continue;
        const nkw_quat above = rotation_at(out.data, stride, parent), own = rotation_at(out.data, stride, j);
        set_rotation(out.data, stride, j, lane_quat_delta(own, above, 0));
    }
    return NKW_OK;
}
