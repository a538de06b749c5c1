/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/quat.h>

#include "lane/mat.h"
#include "lane/quat.h"
#include "pack/form.h"
#include "pack/sincos.h"

float nkw_quat_length(nkw_quat q)
{
    lane_f64_quat w = lane_f64_quat_from(q);
    return (float)lane_sqrt64(lane_f64_quat_dot(w, w));
}

nkw_quat nkw_quat_inverse(nkw_quat q)
{
    lane_f64_quat w = lane_f64_quat_from(q);
    double n2 = lane_f64_quat_dot(w, w);
    lane_f64_quat inverse = lane_f64_quat_scale(lane_f64_quat_conjugate(w), 1.0 / lane_divisor64(n2));
    return n2 == 0.0 ? nkw_quat_identity() : lane_quat_from_f64(inverse);
}

nkw_quat nkw_quat_from_axis_angle(nkw_vec3 axis, float angle)
{
    lane_f64_vec3 unit = lane_f64_vec3_normalize(lane_f64_vec3_from(axis));
    if (unit.x == 0.0 && unit.y == 0.0 && unit.z == 0.0)
        return nkw_quat_identity();
    return lane_quat_from_f64(lane_f64_quat_from_axis_half(unit, f64x2_sincos_any(0.5 * (double)angle)));
}

nkw_axis_angle nkw_axis_angle_from_quat(nkw_quat q)
{
    lane_f64_quat w = lane_f64_quat_from(q);
    lane_f64_vec3 v = {w.x, w.y, w.z};
    lane_f64_vec3 axis = lane_f64_vec3_normalize(lane_f64_vec3_scale(v, w.w < 0.0 ? -1.0 : 1.0));
    double half = lane_atan2_64(lane_f64_vec3_length(v), lane_abs64(w.w));
    nkw_axis_angle r = {lane_vec3_from_f64(axis), (float)(2.0 * half)};
    return r;
}

nkw_quat nkw_quat_from_vectors(nkw_vec3 from, nkw_vec3 to)
{
    return lane_quat_from_f64(lane_f64_quat_from_vectors(lane_f64_vec3_from(from), lane_f64_vec3_from(to)));
}

nkw_quat nkw_quat_look_rotation(nkw_vec3 forward, nkw_vec3 up)
{
    lane_f64_vec3 z = lane_f64_vec3_normalize(lane_f64_vec3_scale(lane_f64_vec3_from(forward), -1.0));
    lane_f64_vec3 u = lane_f64_vec3_normalize(lane_f64_vec3_from(up));
    lane_f64_vec3 side = lane_f64_vec3_cross(u, z);
    /* If `up` is parallel to forward, they have no common perpendicular; any other `up` is then taken. */
    int parallel = lane_f64_vec3_dot(side, side) < 0x1p-60;
    lane_f64_vec3 x = lane_f64_vec3_normalize(
        lane_f64_vec3_select(parallel, lane_f64_vec3_cross(lane_f64_vec3_perpendicular(z), z), side));
    lane_f64_vec3 y = lane_f64_vec3_cross(z, x);
    lane_f64_mat3 m = lane_f64_mat3_from_columns(x, y, z);
    if (lane_f64_vec3_dot(z, z) == 0.0)
        return nkw_quat_identity();
    return lane_quat_from_f64(lane_f64_quat_from_f64_mat3(&m, 0));
}

LANE_SELDOM static nkw_quat from_any_matrix(const float *x, const float *y, const float *z)
{
    nkw_vec3 a = {x[0], x[1], x[2]}, b = {y[0], y[1], y[2]}, c = {z[0], z[1], z[2]};
    return lane_quat_from_any_columns(a, b, c);
}

nkw_quat nkw_quat_from_mat3(const nkw_mat3 *m)
{
    const float *a = m->m;
#if NKW_F32X4
    f32x4 last = f32x4_load(a + 5);
    lane_nearest r = f32x4_quat_from_columns(f32x4_load(a), f32x4_load(a + 3), F32X4_SHUFFLE(last, last, 1, 2, 3, 0));
#else
    lane_nearest r = lane_quat_from_columns(nkw_mat3_column(m, 0), nkw_mat3_column(m, 1), nkw_mat3_column(m, 2));
#endif
    return r.n2 < LANE_NEAREST_FAR ? r.q : from_any_matrix(a, a + 3, a + 6);
}

float nkw_quat_angle(nkw_quat a, nkw_quat b)
{
    return (float)lane_f64_quat_angle(lane_f64_quat_from(a), lane_f64_quat_from(b));
}

nkw_swing_twist nkw_quat_swing_twist(nkw_quat q, nkw_vec3 axis)
{
    lane_f64_vec3 unit = lane_f64_vec3_normalize(lane_f64_vec3_from(axis));
    lane_f64_swing_twist parts = lane_f64_quat_swing_twist(lane_f64_quat_from(q), unit);
    nkw_swing_twist r = {lane_quat_from_f64(parts.swing), lane_quat_from_f64(parts.twist)};
    return r;
}

float nkw_quat_twist_angle(nkw_quat q, nkw_vec3 axis)
{
    lane_f64_vec3 unit = lane_f64_vec3_normalize(lane_f64_vec3_from(axis));
    lane_twist_part p = lane_twist_part_of(lane_f64_quat_from(q), unit);
    double sign = p.w < 0.0 ? -1.0 : 1.0;
    return p.is_none ? 0.0f : (float)(2.0 * lane_atan2_64(sign * p.along, sign * p.w));
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

int nkw_quat_equal_within(nkw_quat a, nkw_quat b, float angle)
{
    return nkw_quat_angle(a, b) <= angle;
}
