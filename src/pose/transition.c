/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/orient.h>
#include <nakawari/transition.h>

#include "batch/transition.h"
#include "lane/offset.h"

/* The vector in the arrays `row` to `row + 2` of a block. */
static nkw_vec3_view rows_of(const float *data, size_t row, size_t stride)
{
    const float *x = data + row * stride;
    nkw_vec3_view v = {x, x + stride, x + 2 * stride};
    return v;
}

static nkw_vec3_span rows_span(float *data, size_t row, size_t stride)
{
    float *x = data + row * stride;
    nkw_vec3_span v = {x, x + stride, x + 2 * stride};
    return v;
}

/* ---- Velocities ---- */

/* Arrays of the velocities. */
enum { TRANSLATION = 0, ROTATION = 3, SCALE = 6 };

nkw_result nkw_pose_velocity_from_poses(nkw_pose_view before, nkw_pose_view now, float duration,
                                        nkw_pose_velocity_span out)
{
    size_t joints = out.joint_count, stride = NKW_POSE_STRIDE(joints);
    if (before.joint_count != joints || now.joint_count != joints)
        return NKW_MISMATCHED;
    if (joints == 0)
        return NKW_OK;
    memset(out.data, 0, NKW_POSE_VELOCITY_FLOATS(joints) * sizeof *out.data);
    if (duration != duration || duration == 0.0f)
        return NKW_OK;
    const nkw_trs_view a = nkw_pose_components(before), b = nkw_pose_components(now);
    double rate = 1.0 / (double)duration;
    nkwi_vec3_rates(a.translation, b.translation, rate, rows_span(out.data, TRANSLATION, stride), joints);
    nkwi_quat_rates(a.rotation, b.rotation, rate, rows_span(out.data, ROTATION, stride), joints);
    nkwi_vec3_rates(a.scale, b.scale, rate, rows_span(out.data, SCALE, stride), joints);
    return NKW_OK;
}

static int motion_fits(const nkw_pose_state *motion, size_t joints)
{
    return motion->pose.joint_count == joints && (!motion->velocity.data || motion->velocity.joint_count == joints);
}

/* ---- Inertialisation ---- */

/* The state: for each vector nine arrays of coefficients, from TRANSLATION * 3 on; then the three durations. */
enum { DURATIONS = 27 };

static transition_offsets_span offsets_span(nkw_pose_inertia inertia, size_t vector)
{
    size_t stride = NKW_POSE_STRIDE(inertia.joint_count), row = 3 * vector;
    transition_offsets_span o = {
        rows_span(inertia.data, row, stride),
        rows_span(inertia.data, row + 3, stride),
        rows_span(inertia.data, row + 6, stride),
        inertia.data + (DURATIONS + vector / 3) * stride,
    };
    return o;
}

static transition_offsets offsets_of(nkw_pose_inertia inertia, size_t vector)
{
    size_t stride = NKW_POSE_STRIDE(inertia.joint_count), row = 3 * vector;
    transition_offsets o = {
        rows_of(inertia.data, row, stride),
        rows_of(inertia.data, row + 3, stride),
        rows_of(inertia.data, row + 6, stride),
        inertia.data + (DURATIONS + vector / 3) * stride,
    };
    return o;
}

/* Velocities; without data the last coefficients, which are 0 until the element that reads them writes them. */
static nkw_vec3_view velocities_of(nkw_pose_velocity_view v, size_t vector, const transition_offsets_span *zeros)
{
    const nkw_vec3_view none = {zeros->c2.x, zeros->c2.y, zeros->c2.z};
    return v.data ? rows_of(v.data, vector, NKW_POSE_STRIDE(v.joint_count)) : none;
}

nkw_result nkw_pose_inertia_begin(nkw_pose_inertia inertia, const nkw_pose_state *from, const nkw_pose_state *to,
                                  float duration)
{
    size_t joints = inertia.joint_count;
    if (!motion_fits(from, joints) || !motion_fits(to, joints))
        return NKW_MISMATCHED;
    if (joints == 0)
        return NKW_OK;
    memset(inertia.data, 0, NKW_POSE_INERTIA_FLOATS(joints) * sizeof *inertia.data);
    const nkw_trs_view a = nkw_pose_components(from->pose), b = nkw_pose_components(to->pose);
    const transition_offsets_span translation = offsets_span(inertia, TRANSLATION),
                                  rotation = offsets_span(inertia, ROTATION), scale = offsets_span(inertia, SCALE);
    nkwi_inertia_begin_vec3(a.translation, velocities_of(from->velocity, TRANSLATION, &translation), b.translation,
                            velocities_of(to->velocity, TRANSLATION, &translation), duration, &translation, joints);
    nkwi_inertia_begin_quat(a.rotation, velocities_of(from->velocity, ROTATION, &rotation), b.rotation,
                            velocities_of(to->velocity, ROTATION, &rotation), duration, &rotation, joints);
    nkwi_inertia_begin_vec3(a.scale, velocities_of(from->velocity, SCALE, &scale), b.scale,
                            velocities_of(to->velocity, SCALE, &scale), duration, &scale, joints);
    return NKW_OK;
}

nkw_result nkw_pose_inertia_evaluate(nkw_pose_inertia inertia, nkw_pose_view to, float t, nkw_pose_span out)
{
    size_t joints = out.joint_count;
    if (inertia.joint_count != joints || to.joint_count != joints)
        return NKW_MISMATCHED;
    if (joints == 0)
        return NKW_OK;
    const nkw_trs_view in = nkw_pose_components(to);
    const nkw_trs_span into = nkw_pose_components_span(out);
    const transition_offsets translation = offsets_of(inertia, TRANSLATION), rotation = offsets_of(inertia, ROTATION),
                             scale = offsets_of(inertia, SCALE);
    nkwi_inertia_vec3(&translation, in.translation, t, into.translation, joints);
    nkwi_inertia_quat(&rotation, in.rotation, t, into.rotation, joints);
    nkwi_inertia_vec3(&scale, in.scale, t, into.scale, joints);
    return NKW_OK;
}

/* ---- Dead blending ---- */

/* The state: the pose, its velocities, the differences of the rotations. */
enum { VELOCITIES = 10, DIFFERENCES = 19 };

nkw_result nkw_pose_dead_blend_begin(const nkw_pose_dead_blend *blend, const nkw_pose_state *from)
{
    size_t joints = blend->joint_count, stride = NKW_POSE_STRIDE(joints);
    if (!motion_fits(from, joints))
        return NKW_MISMATCHED;
    if (joints == 0)
        return NKW_OK;
    float *velocities = blend->data + VELOCITIES * stride;
    memset(blend->data, 0, NKW_POSE_DEAD_BLEND_FLOATS(joints) * sizeof *blend->data);
    for (size_t row = 0; row < VELOCITIES; row++)
        memcpy(blend->data + row * stride, from->pose.data + row * stride, joints * sizeof *blend->data);
    for (size_t row = 0; row < 9 && from->velocity.data; row++)
        memcpy(velocities + row * stride, from->velocity.data + row * stride, joints * sizeof *velocities);
    return NKW_OK;
}

nkw_result nkw_pose_dead_blend_evaluate(const nkw_pose_dead_blend *blend, nkw_pose_view to, float t, nkw_pose_span out)
{
    size_t joints = out.joint_count, stride = NKW_POSE_STRIDE(joints);
    if (blend->joint_count != joints || to.joint_count != joints)
        return NKW_MISMATCHED;
    if (joints == 0)
        return NKW_OK;
    const lane_dead_time time = lane_dead_time_at(blend->half_life, blend->duration, t);
    const transition_time at = {time.carried, time.s};
    const nkw_pose_view old = {blend->data, joints};
    const nkw_trs_view from = nkw_pose_components(old), in = nkw_pose_components(to);
    const nkw_trs_span into = nkw_pose_components_span(out);
    const float *velocity = blend->data + VELOCITIES * stride;
    float *d = blend->data + DIFFERENCES * stride;
    const nkw_quat_span last = {d, d + stride, d + 2 * stride, d + 3 * stride};
    nkwi_dead_vec3(from.translation, rows_of(velocity, TRANSLATION, stride), in.translation, at, into.translation,
                   joints);
    nkwi_dead_quat(from.rotation, rows_of(velocity, ROTATION, stride), in.rotation, at, last, into.rotation, joints);
    nkwi_dead_vec3(from.scale, rows_of(velocity, SCALE, stride), in.scale, at, into.scale, joints);
    return NKW_OK;
}
