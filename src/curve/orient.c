/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/orient.h>

#include "lane/arc.h"
#include "lane/euler.h"
#include "lane/rotation_vector.h"
#include "pack/quat.h"
#include "pack/sincos.h"
#include "pack/slerp.h"

nkw_quat nkw_quat_slerp(nkw_quat a, nkw_quat b, float t)
{
    return quat_slerp(a, b, t);
}

nkw_quat nkw_quat_slerp_path(nkw_quat a, nkw_quat b, float t, nkw_path path, int32_t turns)
{
    return lane_quat_slerp_path(a, b, t, path, turns);
}

nkw_quat nkw_quat_nlerp_path(nkw_quat a, nkw_quat b, float t, nkw_path path, int32_t turns)
{
    lane_f64_quat from = lane_f64_quat_from(a);
    lane_f64_quat to = lane_f64_quat_aligned(from, lane_f64_quat_from(b), path);
    lane_f64_arc arc = lane_f64_arc_between(from, to);
    double t64 = (double)t, la = lane_sqrt64(lane_f64_quat_dot(from, from));
    double part = t64 * lane_sqrt64(lane_f64_quat_dot(to, to));
    double x = lane_atan2_64(part * (arc.is_along ? 0.0 : arc.sine), (1.0 - t64) * la + part * arc.cosine);
    lane_f64_quat q = lane_f64_arc_at(&arc, x, turns == 0 ? 0.0 : t64 * (double)turns, 0);
    return lane_quat_from_f64(t == 0.0f ? from : t == 1.0f ? lane_f64_quat_after(to, turns) : q);
}

#define MOST_TURNS 0x1p29

int32_t nkw_quat_turns(nkw_quat a, nkw_quat b, nkw_vec3 expected, nkw_path path)
{
    lane_f64_quat from = lane_f64_quat_from(a);
    lane_f64_arc arc = lane_f64_arc_between(from, lane_f64_quat_aligned(from, lane_f64_quat_from(b), path));
    lane_f64_quat axis = lane_f64_quat_mul(arc.e, lane_f64_quat_conjugate(arc.u));
    lane_f64_vec3 n = {axis.x, axis.y, axis.z};
    double beyond = lane_f64_vec3_dot(n, lane_f64_vec3_from(expected)) - 2.0 * arc.h;
    double turns = (beyond / LANE_TWO_PI + LANE_ROUND) - LANE_ROUND;
    if (arc.h == 0.0 || !lane_is_finite(expected.x + expected.y + expected.z) || !(turns == turns))
        return 0;
    double least = turns > -MOST_TURNS ? turns : -MOST_TURNS, within = least < MOST_TURNS ? least : MOST_TURNS;
    return (int32_t)within;
}

nkw_vec3 nkw_quat_log(nkw_quat q)
{
    return lane_vec3_from_f64(lane_f64_quat_log(lane_f64_quat_from(quat_argument(q))));
}

LANE_FLAT nkw_quat nkw_quat_exp(nkw_vec3 v)
{
    lane_f64_vec3 w = lane_f64_vec3_from(v);
    lane_sincos half = f64x2_sincos_any(lane_turn_angle64(lane_f64_vec3_length(w)));
    return lane_quat_from_f64(lane_f64_quat_from_axis_half(lane_f64_vec3_normalize(w), half));
}

nkw_quat nkw_quat_pow(nkw_quat q, float t)
{
    lane_f64_vec3 v = lane_f64_quat_log(lane_f64_quat_from(q));
    return lane_quat_from_f64(lane_f64_quat_exp(lane_f64_vec3_scale(v, t)));
}

nkw_vec3 nkw_quat_angular_velocity(nkw_quat a, nkw_quat b, float duration)
{
    return lane_quat_rate(a, b, duration == 0.0f ? 0.0 : 1.0 / (double)duration);
}

nkw_quat nkw_quat_integrate(nkw_quat q, nkw_vec3 angular_velocity, float duration)
{
    lane_f64_vec3 half = lane_f64_vec3_scale(lane_f64_vec3_from(angular_velocity), 0.5 * (double)duration);
    return lane_quat_from_f64(lane_f64_quat_mul(lane_f64_quat_exp(half), lane_f64_quat_from(q)));
}

nkw_quat nkw_quat_rotate_towards(nkw_quat from, nkw_quat to, float angle)
{
    float whole = nkw_quat_angle(from, to), part = angle < 0.0f ? 0.0f : angle;
    return whole <= part ? to : nkw_quat_slerp(from, to, part / whole);
}
