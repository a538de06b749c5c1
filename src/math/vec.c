/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/vec.h>

#include "lane/vec.h"

float nkw_vec3_length(nkw_vec3 a)
{
    return lane_vec3_length(a);
}

float nkw_vec3_distance(nkw_vec3 a, nkw_vec3 b)
{
    return lane_vec3_distance(a, b);
}

float nkw_vec3_angle(nkw_vec3 a, nkw_vec3 b)
{
    return lane_vec3_angle(a, b);
}

nkw_vec3 nkw_vec3_project(nkw_vec3 a, nkw_vec3 b)
{
    return lane_vec3_from_f64(lane_f64_vec3_project(lane_f64_vec3_from(a), lane_f64_vec3_from(b)));
}

nkw_vec3 nkw_vec3_reject(nkw_vec3 a, nkw_vec3 b)
{
    lane_f64_vec3 u = lane_f64_vec3_from(a);
    return lane_vec3_from_f64(lane_f64_vec3_sub(u, lane_f64_vec3_project(u, lane_f64_vec3_from(b))));
}

nkw_vec3 nkw_vec3_perpendicular(nkw_vec3 a)
{
    return lane_vec3_from_f64(lane_f64_vec3_perpendicular(lane_f64_vec3_from(a)));
}

int nkw_vec3_equal_within(nkw_vec3 a, nkw_vec3 b, float tolerance)
{
    return nkw_equal_within(a.x, b.x, tolerance) && nkw_equal_within(a.y, b.y, tolerance) &&
           nkw_equal_within(a.z, b.z, tolerance);
}

nkw_vec3 nkw_vec3_move_towards(nkw_vec3 from, nkw_vec3 to, float step)
{
    nkw_vec3 d = nkw_vec3_sub(to, from);
    float length = nkw_vec3_length(d), s = step < 0.0f ? 0.0f : step;
    return length <= s ? to : nkw_vec3_add_scaled(from, d, s / length);
}
