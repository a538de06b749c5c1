/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/quat.h>

#include "lane/mat.h"
#include "lane/quat.h"

float nkw_quat_length(nkw_quat q)
{
    lane_wquat w = lane_wquat_from(q);
    return (float)lane_sqrt64(lane_wquat_dot(w, w));
}

nkw_quat nkw_quat_inverse(nkw_quat q)
{
    lane_wquat w = lane_wquat_from(q);
    double n2 = lane_wquat_dot(w, w);
    lane_wquat inverse = lane_wquat_scale(lane_wquat_conjugate(w), 1.0 / n2);
    return n2 == 0.0 ? nkw_quat_identity() : lane_quat_from_wide(inverse);
}

nkw_quat nkw_quat_from_axis_angle(nkw_vec3 axis, float angle)
{
    lane_wvec3 unit = lane_wvec3_normalize(lane_wvec3_from(axis));
    if (unit.x == 0.0 && unit.y == 0.0 && unit.z == 0.0)
        return nkw_quat_identity();
    return lane_quat_from_wide(lane_wquat_from_axis_half_angle(unit, 0.5 * (double)angle));
}

nkw_axis_angle nkw_axis_angle_from_quat(nkw_quat q)
{
    lane_wquat w = lane_wquat_from(q);
    lane_wvec3 v = {w.x, w.y, w.z};
    lane_wvec3 axis = lane_wvec3_normalize(lane_wvec3_scale(v, w.w < 0.0 ? -1.0 : 1.0));
    double half = lane_atan2_64(lane_wvec3_length(v), lane_abs64(w.w));
    nkw_axis_angle r = {lane_vec3_from_wide(axis), (float)(2.0 * half)};
    return r;
}

nkw_quat nkw_quat_from_vectors(nkw_vec3 from, nkw_vec3 to)
{
    return lane_quat_from_wide(
        lane_wquat_from_vectors(lane_wvec3_from(from), lane_wvec3_from(to)));
}

nkw_quat nkw_quat_look_rotation(nkw_vec3 forward, nkw_vec3 up)
{
    lane_wvec3 z = lane_wvec3_normalize(lane_wvec3_scale(lane_wvec3_from(forward), -1.0));
    lane_wvec3 u = lane_wvec3_normalize(lane_wvec3_from(up));
    lane_wvec3 side = lane_wvec3_cross(u, z);
    /* Up along forward has no side; then any up will do. */
    int parallel = lane_wvec3_dot(side, side) < 0x1p-60;
    lane_wvec3 x = lane_wvec3_normalize(
        lane_wvec3_select(parallel, lane_wvec3_cross(lane_wvec3_perpendicular(z), z), side));
    lane_wvec3 y = lane_wvec3_cross(z, x);
    lane_wmat3 m = lane_wmat3_from_columns(x, y, z);
    if (lane_wvec3_dot(z, z) == 0.0)
        return nkw_quat_identity();
    return lane_quat_from_wide(lane_wquat_from_wmat3(&m, 0));
}

LANE_SELDOM static nkw_quat from_any_matrix(const nkw_mat3 *m)
{
    lane_wmat3 w = lane_wmat3_from(m);
    return lane_quat_from_wide(lane_wquat_from_wmat3(&w, LANE_NEAREST_STEPS));
}

LANE_FLAT nkw_quat nkw_quat_from_mat3(const nkw_mat3 *m)
{
    lane_wmat3 w = lane_wmat3_from(m);
    lane_wform k = lane_wform_from_wmat3(&w);
    lane_wquat q = lane_wform_dominant_single(&k, LANE_NEAREST_STEPS);
    double n2 = lane_wquat_dot(q, q);
    if (!lane_root_is_near(n2))
        return from_any_matrix(m);
    return lane_quat_from_wide(lane_wquat_scale(q, lane_rsqrt64_near(n2)));
}

nkw_quat nkw_quat_from_mat4(const nkw_mat4 *m)
{
    nkw_mat3 r = nkw_mat3_from_mat4(m);
    return nkw_quat_from_mat3(&r);
}

float nkw_quat_angle(nkw_quat a, nkw_quat b)
{
    return (float)lane_wquat_angle(lane_wquat_from(a), lane_wquat_from(b));
}

nkw_quat nkw_quat_from_wxyz(const float wxyz[4])
{
    nkw_quat r = {wxyz[1], wxyz[2], wxyz[3], wxyz[0]};
    return r;
}

void nkw_quat_to_wxyz(nkw_quat q, float wxyz[4])
{
    wxyz[0] = q.w;
    wxyz[1] = q.x;
    wxyz[2] = q.y;
    wxyz[3] = q.z;
}
