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

static nkw_vec3 vec3_at(nkw_vec3_view v, size_t i)
{
    nkw_vec3 r = {v.x[i], v.y[i], v.z[i]};
    return r;
}

static void write_vec3(nkw_vec3_span v, size_t i, nkw_vec3 a)
{
    v.x[i] = a.x;
    v.y[i] = a.y;
    v.z[i] = a.z;
}

/* ---- Velocities ---- */

/* Arrays of the velocities. */
enum { TRANSLATION = 0, ROTATION = 3, SCALE = 6 };

static nkw_vec3 rate_of(nkw_vec3 before, nkw_vec3 now, double rate)
{
    lane_f64_vec3 d = lane_f64_vec3_sub(lane_f64_vec3_from(now), lane_f64_vec3_from(before));
    return lane_vec3_from_f64(lane_f64_vec3_scale(d, rate));
}

nkw_result nkw_pose_velocity_from_poses(nkw_pose_view before, nkw_pose_view now, float duration,
                                        nkw_pose_velocity_span out)
{
    size_t joints = out.joint_count, stride = NKW_POSE_STRIDE(joints);
    if (before.joint_count != joints || now.joint_count != joints)
        return NKW_MISMATCHED;
    int some = duration == duration && duration != 0.0f;
    double rate = some ? 1.0 / (double)duration : 0.0;
    if (joints > 0)
        memset(out.data, 0, NKW_POSE_VELOCITY_FLOATS(joints) * sizeof *out.data);
    for (size_t j = 0; j < joints && some; j++) {
        nkw_trs a = nkw_pose_get(before, j), b = nkw_pose_get(now, j);
        write_vec3(rows_span(out.data, TRANSLATION, stride), j, rate_of(a.translation, b.translation, rate));
        write_vec3(rows_span(out.data, ROTATION, stride), j, nkw_quat_angular_velocity(a.rotation, b.rotation, duration));
        write_vec3(rows_span(out.data, SCALE, stride), j, rate_of(a.scale, b.scale, rate));
    }
    return NKW_OK;
}

/* A velocity of joint j; 0 without data. */
static nkw_vec3 velocity_at(nkw_pose_velocity_view v, size_t row, size_t j)
{
    const nkw_vec3 none = {0.0f, 0.0f, 0.0f};
    return v.data ? vec3_at(rows_of(v.data, row, NKW_POSE_STRIDE(v.joint_count)), j) : none;
}

static int motion_fits(const nkw_pose_state *motion, size_t joints)
{
    return motion->pose.joint_count == joints && (!motion->velocity.data || motion->velocity.joint_count == joints);
}

/* ---- Inertialisation ---- */

/* The state: for each vector nine arrays of coefficients, from TRANSLATION * 3 on; then the three durations. */
enum { DURATIONS = 27 };

static void put_offset(nkw_pose_inertia inertia, size_t vector, size_t j, lane_inertia_c c)
{
    size_t stride = NKW_POSE_STRIDE(inertia.joint_count), row = 3 * vector;
    write_vec3(rows_span(inertia.data, row, stride), j, c.c0);
    write_vec3(rows_span(inertia.data, row + 3, stride), j, c.c1);
    write_vec3(rows_span(inertia.data, row + 6, stride), j, c.c2);
    inertia.data[(DURATIONS + vector / 3) * stride + j] = c.duration;
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

static lane_inertia_c begin_vec3(nkw_vec3 from, nkw_vec3 v, nkw_vec3 to, nkw_vec3 w, float duration)
{
    nkw_vec3_state a = {from, v}, b = {to, w};
    nkw_vec3_offset o = {.kind = NKW_OFFSET_INERTIA, .duration = duration};
    nkw_vec3_offset_begin(&o, &a, &b);
    lane_inertia_c c = {o.c[0], o.c[1], o.c[2], o.end};
    return c;
}

static lane_inertia_c begin_quat(nkw_quat from, nkw_vec3 v, nkw_quat to, nkw_vec3 w, float duration)
{
    nkw_quat_state a = {from, v}, b = {to, w};
    nkw_quat_offset o = {.kind = NKW_OFFSET_INERTIA, .duration = duration};
    nkw_quat_offset_begin(&o, &a, &b);
    lane_inertia_c c = {o.c[0], o.c[1], o.c[2], o.end};
    return c;
}

nkw_result nkw_pose_inertia_begin(nkw_pose_inertia inertia, const nkw_pose_state *from, const nkw_pose_state *to,
                                  float duration)
{
    nkw_pose_velocity_view v = from->velocity, w = to->velocity;
    if (!motion_fits(from, inertia.joint_count) || !motion_fits(to, inertia.joint_count))
        return NKW_MISMATCHED;
    if (inertia.joint_count > 0)
        memset(inertia.data, 0, NKW_POSE_INERTIA_FLOATS(inertia.joint_count) * sizeof *inertia.data);
    for (size_t j = 0; j < inertia.joint_count; j++) {
        nkw_trs a = nkw_pose_get(from->pose, j), b = nkw_pose_get(to->pose, j);
        put_offset(inertia, TRANSLATION, j,
                   begin_vec3(a.translation, velocity_at(v, TRANSLATION, j), b.translation,
                              velocity_at(w, TRANSLATION, j), duration));
        put_offset(
            inertia, ROTATION, j,
            begin_quat(a.rotation, velocity_at(v, ROTATION, j), b.rotation, velocity_at(w, ROTATION, j), duration));
        put_offset(inertia, SCALE, j,
                   begin_vec3(a.scale, velocity_at(v, SCALE, j), b.scale, velocity_at(w, SCALE, j), duration));
    }
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
