/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/pose.h>
#include <nakawari/skeleton.h>
#include <nakawari/transform.h>

#include "batch/skeleton.h"
#include "lane/skeleton.h"
#include "track/difference.h"
#include "report.h"
#include "sizes.h"

nkw_result nkw_skeleton_validate(const nkw_skeleton *skeleton, size_t *bad)
{
    nkw_result result = skeleton->joint_count == 0 ? NKW_EMPTY : NKW_OK;
    size_t j = 0;
    for (; result == NKW_OK && j < skeleton->joint_count; j++) {
        int32_t parent = skeleton->parents[j];
        if (parent < NKW_NO_JOINT || (parent >= 0 && (size_t)parent >= skeleton->joint_count))
            result = NKW_OUT_OF_RANGE;
        else if (parent != NKW_NO_JOINT && skeleton_parent(skeleton->parents, j) >= j)
            result = NKW_NOT_ORDERED;
    }
    return report(result, j ? j - 1 : 0, bad);
}

size_t nkw_skeleton_subtree_end(const nkw_skeleton *skeleton, size_t joint)
{
    size_t end = joint < skeleton->joint_count ? joint + 1 : skeleton->joint_count;
    for (; end < skeleton->joint_count; end++) {
        size_t parent = skeleton_parent(skeleton->parents, end);
        if (parent < joint || parent >= end)
            break;
    }
    return end;
}

nkw_result nkw_skeleton_models_from_pose(const nkw_skeleton *skeleton, nkw_pose_view pose, const nkw_mat4 *root,
                                         const nkw_range *range, nkw_mat4 *models)
{
    const nkw_range r = skeleton_range(skeleton, range);
    if (pose.joint_count != skeleton->joint_count)
        return NKW_MISMATCHED;
    nkwi_models_from_pose(skeleton->parents, pose.data, NKW_POSE_STRIDE(pose.joint_count), root, r.from, r.to, models);
    return NKW_OK;
}

void nkw_skeleton_models_from_locals(const nkw_skeleton *skeleton, const nkw_mat4 *locals, const nkw_mat4 *root,
                                     const nkw_range *range, nkw_mat4 *models)
{
    const nkw_range r = skeleton_range(skeleton, range);
    nkwi_models_from_locals(skeleton->parents, locals, root, r.from, r.to, models);
}

void nkw_skeleton_locals_from_models(const nkw_skeleton *skeleton, const nkw_mat4 *models, const nkw_mat4 *root,
                                     nkw_mat4 *locals)
{
    nkwi_locals_from_models(skeleton->parents, models, root, 0, skeleton->joint_count, locals);
}

/* The joints `from` to `to`, at most LOCALS_BLOCK; returns the worst of `worst` and their residuals, where asked for. */
static float put_locals(const nkw_mat4 *locals, size_t from, size_t to, nkw_pose_span pose, int asked, float worst)
{
    int far;
    nkwi_pose_from_locals(locals, pose.data + from, NKW_POSE_STRIDE(pose.joint_count), &far, to - from);
    for (size_t j = from; j < to && (far || asked); j++) {
        nkw_trs trs = nkw_trs_from_mat4(&locals[j - from]);
        nkw_pose_set(pose, j, &trs);
        if (asked)
            worst = difference_worse(worst, nkw_trs_residual(&trs, &locals[j - from]));
    }
    return worst;
}

nkw_result nkw_skeleton_pose_from_models(const nkw_skeleton *skeleton, const nkw_mat4 *models, const nkw_mat4 *root,
                                         nkw_pose_span pose, float *residual)
{
    size_t count = skeleton->joint_count;
    float worst = 0.0f;
    if (pose.joint_count != count)
        return NKW_MISMATCHED;
    nkw_pose_identity(pose);
    for (size_t from = 0; from < count; from += LOCALS_BLOCK) {
        nkw_mat4 locals[LOCALS_BLOCK];
        size_t to = count - from < LOCALS_BLOCK ? count : from + LOCALS_BLOCK;
        nkwi_locals_from_models(skeleton->parents, models, root, from, to, locals);
        worst = put_locals(locals, from, to, pose, residual != NULL, worst);
    }
    if (residual)
        *residual = worst;
    return NKW_OK;
}
