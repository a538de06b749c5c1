/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/pose.h>
#include <nakawari/quat.h>
#include <nakawari/transform.h>
#include <nakawari/vec.h>

#include "batch/pose.h"
#include "lane/scalar.h"
#include "report.h"

size_t nkw_pose_floats(size_t joint_count)
{
    return joint_count <= SIZE_MAX / 160 * 16 ? NKW_POSE_FLOATS(joint_count) : SIZE_MAX;
}

/* Array k of a pose; for stride 0 the pose unchanged, because NULL + 0 is undefined in C99. */
static float *array_of(nkw_pose_span pose, size_t stride, size_t k)
{
    return stride ? pose.data + k * stride : pose.data;
}

nkw_trs_span nkw_pose_components_span(nkw_pose_span pose)
{
    size_t s = NKW_POSE_STRIDE(pose.joint_count);
    nkw_trs_span span = {
        {array_of(pose, s, 0), array_of(pose, s, 1), array_of(pose, s, 2)},
        {array_of(pose, s, 3), array_of(pose, s, 4), array_of(pose, s, 5), array_of(pose, s, 6)},
        {array_of(pose, s, 7), array_of(pose, s, 8), array_of(pose, s, 9)},
    };
    return span;
}

/* A view and its span have one layout, as in NKW_VIEW; nothing is written by this span. */
nkw_trs_view nkw_pose_components(nkw_pose_view pose)
{
    const union {
        nkw_pose_view view;
        nkw_pose_span span;
    } same = {pose};
    return NKW_VIEW(nkw_trs, nkw_pose_components_span(same.span));
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

/* Sets the joints from .. stride - 1, a multiple of 16, to the identity: arrays 6 to 9 are w and the scale. */
static void fill(float *pose, size_t stride, size_t from)
{
    static const float zeros[16] = {0.0f}, ones[16] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    for (size_t j = from; j < stride; j += 16)
        for (size_t c = 0; c < 10; c++)
            memcpy(pose + c * stride + j, c < 6 ? zeros : ones, sizeof zeros);
}

void nkw_pose_identity(nkw_pose_span pose)
{
    fill(pose.data, NKW_POSE_STRIDE(pose.joint_count), 0);
}

nkw_trs nkw_pose_get(nkw_pose_view pose, size_t joint)
{
    return joint < pose.joint_count ? get(pose.data, NKW_POSE_STRIDE(pose.joint_count), joint) : nkw_trs_identity();
}

nkw_result nkw_pose_set(nkw_pose_span pose, size_t joint, const nkw_trs *trs)
{
    if (joint >= pose.joint_count)
        return NKW_OUT_OF_RANGE;
    put(pose.data, NKW_POSE_STRIDE(pose.joint_count), joint, trs);
    return NKW_OK;
}

void nkw_pose_from_trs(const nkw_trs *trs, nkw_pose_span pose)
{
    size_t stride = NKW_POSE_STRIDE(pose.joint_count);
    if (stride == 0)
        return;
    fill(pose.data, stride, pose.joint_count / 16 * 16);
    nkwi_pose_from_trs(trs, pose.joint_count, pose.data, stride);
}

void nkw_trs_from_pose(nkw_pose_view pose, nkw_trs *out)
{
    if (pose.joint_count > 0)
        nkwi_trs_from_pose(pose.data, NKW_POSE_STRIDE(pose.joint_count), pose.joint_count, out);
}

static nkw_result check(const nkw_trs *trs)
{
    if (!nkw_vec3_is_finite(trs->translation) || !nkw_quat_is_finite(trs->rotation) || !nkw_vec3_is_finite(trs->scale))
        return NKW_NOT_FINITE;
    return lane_is_unit_length(nkw_quat_length(trs->rotation)) ? NKW_OK : NKW_NOT_UNIT;
}

nkw_result nkw_pose_validate(nkw_pose_view pose, size_t *bad)
{
    nkw_result result = pose.joint_count == 0 ? NKW_EMPTY : NKW_OK;
    size_t offender = 0;
    for (size_t j = 0; result == NKW_OK && j < pose.joint_count; j++) {
        nkw_trs trs = get(pose.data, NKW_POSE_STRIDE(pose.joint_count), j);
        result = check(&trs);
        offender = j;
    }
    return report(result, offender, bad);
}
