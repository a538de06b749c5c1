/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/euler.h>
#include <nakawari/scalar.h>

#include "lane/euler.h"
#include "lane/mat.h"

static nkw_vec3 narrow(const double angles[3])
{
    nkw_vec3 r = {(float)angles[0], (float)angles[1], (float)angles[2]};
    return r;
}

static lane_wquat rotation_of(nkw_vec3 angles, nkw_euler_order order)
{
    double wide[3] = {angles.x, angles.y, angles.z};
    return lane_wquat_from_euler(wide, lane_euler_axes_of(order));
}

nkw_quat nkw_quat_from_euler(nkw_vec3 angles, nkw_euler_order order)
{
    return lane_quat_from_wide(rotation_of(angles, order));
}

nkw_mat3 nkw_mat3_from_euler(nkw_vec3 angles, nkw_euler_order order)
{
    lane_wmat3 m = lane_wmat3_from_wquat(rotation_of(angles, order));
    return lane_mat3_from_wide(&m, 1.0);
}

nkw_vec3 nkw_euler_from_quat(nkw_quat q, nkw_euler_order order)
{
    double angles[3];
    lane_wquat unit = lane_wquat_positive(lane_wquat_normalize(lane_wquat_from(q)));
    lane_euler_from_wquat(unit, lane_euler_axes_of(order), angles);
    return narrow(angles);
}

nkw_vec3 nkw_euler_from_mat3(const nkw_mat3 *m, nkw_euler_order order)
{
    double angles[3];
    lane_wmat3 w = lane_wmat3_from(m);
    lane_euler_from_wquat(lane_wquat_from_wmat3(&w, LANE_NEAREST_STEPS), lane_euler_axes_of(order), angles);
    return narrow(angles);
}

nkw_vec3 nkw_euler_unwrap(nkw_vec3 angles, nkw_vec3 reference)
{
    nkw_vec3 r = {
        lane_unwrap(angles.x, reference.x),
        lane_unwrap(angles.y, reference.y),
        lane_unwrap(angles.z, reference.z),
    };
    return r;
}
