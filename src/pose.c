/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/pose.h>
#include <nakawari/quat.h>
#include <nakawari/transform.h>
#include <nakawari/vec.h>

#include "lane/scalar.h"
#include "report.h"

size_t nkw_pose_floats(size_t joints)
{
    return joints <= SIZE_MAX / 160 * 16 ? NKW_POSE_FLOATS(joints) : SIZE_MAX;
}

/* pose + floats; pose itself for floats = 0, where it may be NULL. */
static const float *behind(const float *pose, size_t floats)
{
    return floats ? pose + floats : pose;
}

nkw_trs_view nkw_pose_components(nkw_pose_view pose)
{
    size_t s = NKW_POSE_STRIDE(pose.joint_count);
    const float *rotation = behind(pose.data, 3 * s), *scale = behind(pose.data, 7 * s);
    nkw_trs_view view = {
        {pose.data, behind(pose.data, s), behind(pose.data, 2 * s)},
        {rotation, behind(rotation, s), behind(rotation, 2 * s), behind(rotation, 3 * s)},
        {scale, behind(scale, s), behind(scale, 2 * s)},
    };
    return view;
}

static float *behind_span(float *pose, size_t floats)
{
    return floats ? pose + floats : pose;
}

nkw_trs_span nkw_pose_components_span(nkw_pose_span pose)
{
    size_t s = NKW_POSE_STRIDE(pose.joint_count);
    float *rotation = behind_span(pose.data, 3 * s), *scale = behind_span(pose.data, 7 * s);
    nkw_trs_span span = {
        {pose.data, behind_span(pose.data, s), behind_span(pose.data, 2 * s)},
        {rotation, behind_span(rotation, s), behind_span(rotation, 2 * s), behind_span(rotation, 3 * s)},
        {scale, behind_span(scale, s), behind_span(scale, 2 * s)},
    };
    return span;
}

static void put(float *pose, size_t stride, size_t joint, const nkw_trs *trs)
{
    const float v[10] = {
        trs->translation.x, trs->translation.y, trs->translation.z, trs->rotation.x, trs->rotation.y,
        trs->rotation.z,    trs->rotation.w,    trs->scale.x,       trs->scale.y,    trs->scale.z,
    };
    for (size_t c = 0; c < 10; c++)
        pose[c * stride + joint] = v[c];
}

static nkw_trs get(const float *pose, size_t stride, size_t joint)
{
    float v[10];
    for (size_t c = 0; c < 10; c++)
        v[c] = pose[c * stride + joint];
    nkw_trs trs = {{v[0], v[1], v[2]}, {v[3], v[4], v[5], v[6]}, {v[7], v[8], v[9]}};
    return trs;
}

/* Joints from..stride - 1 at the identity. */
static void fill(float *pose, size_t stride, size_t from)
{
    nkw_trs none = nkw_trs_identity();
    for (size_t j = from; j < stride; j++)
        put(pose, stride, j, &none);
}

void nkw_pose_identity(float *pose, size_t joints)
{
    fill(pose, NKW_POSE_STRIDE(joints), 0);
}

nkw_trs nkw_pose_get(const float *pose, size_t joints, size_t joint)
{
    return joint < joints ? get(pose, NKW_POSE_STRIDE(joints), joint) : nkw_trs_identity();
}

void nkw_pose_set(float *pose, size_t joints, size_t joint, const nkw_trs *trs)
{
    if (joint < joints)
        put(pose, NKW_POSE_STRIDE(joints), joint, trs);
}

void nkw_pose_from_trs(const nkw_trs *trs, size_t joints, float *pose)
{
    size_t stride = NKW_POSE_STRIDE(joints);
    for (size_t j = 0; j < joints; j++)
        put(pose, stride, j, &trs[j]);
    fill(pose, stride, joints);
}

void nkw_trs_from_pose(const float *pose, size_t joints, nkw_trs *out)
{
    for (size_t j = 0; j < joints; j++)
        out[j] = get(pose, NKW_POSE_STRIDE(joints), j);
}

static nkw_result check(const nkw_trs *trs)
{
    if (!nkw_vec3_is_finite(trs->translation) || !nkw_quat_is_finite(trs->rotation) || !nkw_vec3_is_finite(trs->scale))
        return NKW_NOT_FINITE;
    return lane_is_unit_length(nkw_quat_length(trs->rotation)) ? NKW_OK : NKW_NOT_UNIT;
}

nkw_result nkw_pose_validate(const float *pose, size_t joints, size_t *bad_joint)
{
    nkw_result result = joints == 0 ? NKW_EMPTY : NKW_OK;
    size_t bad = 0;
    for (size_t j = 0; result == NKW_OK && j < joints; j++) {
        nkw_trs trs = get(pose, NKW_POSE_STRIDE(joints), j);
        result = check(&trs);
        bad = j;
    }
    return report(result, bad, bad_joint);
}
