/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/orient.h>

#include "lane/orient.h"
#include "pack/quat.h"
#include "pack/slerp.h"

#if NKW_F32X4
LANE_SELDOM static f32x4 nlerp_any(f32x4 a, f32x4 b, float t)
{
    nkw_quat r = lane_quat_nlerp(quat_from_f32x4(a), quat_from_f32x4(b), t);
    return f32x4_from_quat(r);
}

nkw_quat nkw_quat_nlerp(nkw_quat a, nkw_quat b, float t)
{
    f32x4 from = f32x4_from_quat(a), to = f32x4_from_quat(b), r;
    if (!f32x4_nlerp(from, to, t, &r))
        r = nlerp_any(from, to, t);
    return quat_from_f32x4(r);
}

LANE_SELDOM static f32x4 slerp_any(f32x4 a, f32x4 b, float t)
{
    if (lane_t_is_inside(t))
        return f32x4_slerp(a, b, t, 0, 0);
    nkw_quat r = lane_quat_slerp_path(quat_from_f32x4(a), quat_from_f32x4(b), t, NKW_PATH_SHORT);
    return f32x4_from_quat(r);
}

nkw_quat nkw_quat_slerp(nkw_quat a, nkw_quat b, float t)
{
    f32x4 from = f32x4_from_quat(a), to = f32x4_from_quat(b);
    return quat_from_f32x4(lane_t_is_generic(t) ? f32x4_slerp(from, to, t, 1, 0) : slerp_any(from, to, t));
}
#else
nkw_quat nkw_quat_nlerp(nkw_quat a, nkw_quat b, float t)
{
    return lane_quat_nlerp(a, b, t);
}

nkw_quat nkw_quat_slerp(nkw_quat a, nkw_quat b, float t)
{
    return lane_quat_slerp_any(a, b, t);
}
#endif

nkw_quat nkw_quat_slerp_path(nkw_quat a, nkw_quat b, float t, nkw_path path)
{
    return lane_quat_slerp_path(a, b, t, path);
}

nkw_vec3 nkw_quat_log(nkw_quat q)
{
    return lane_vec3_from_wide(lane_wquat_log(lane_wquat_from(quat_argument(q))));
}

LANE_FLAT nkw_quat nkw_quat_exp(nkw_vec3 v)
{
    return lane_quat_from_wide(lane_wquat_exp(lane_wvec3_from(v)));
}

nkw_quat nkw_quat_pow(nkw_quat q, float t)
{
    lane_wvec3 v = lane_wquat_log(lane_wquat_from(q));
    return lane_quat_from_wide(lane_wquat_exp(lane_wvec3_scale(v, t)));
}

nkw_vec3 nkw_quat_angular_velocity(nkw_quat a, nkw_quat b, float duration)
{
    lane_wquat from = lane_wquat_from(a);
    lane_wquat to = lane_wquat_aligned(from, lane_wquat_from(b), NKW_PATH_SHORT);
    lane_wvec3 half = lane_wquat_log(lane_wquat_mul(to, lane_wquat_conjugate(from)));
    return lane_vec3_from_wide(lane_wvec3_scale(half, duration == 0.0f ? 0.0 : 2.0 / (double)duration));
}

nkw_quat nkw_quat_integrate(nkw_quat q, nkw_vec3 angular_velocity, float duration)
{
    lane_wvec3 half = lane_wvec3_scale(lane_wvec3_from(angular_velocity), 0.5 * (double)duration);
    return lane_quat_from_wide(lane_wquat_mul(lane_wquat_exp(half), lane_wquat_from(q)));
}

nkw_vec3 nkw_euler_lerp(nkw_vec3 a, nkw_vec3 b, float t, nkw_unwrap unwrap)
{
    int all = unwrap == NKW_UNWRAP_ALL;
    nkw_vec3 r = {
        lane_angle_lerp(a.x, b.x, t, all),
        lane_angle_lerp(a.y, b.y, t, all || unwrap == NKW_UNWRAP_YAW),
        lane_angle_lerp(a.z, b.z, t, all),
    };
    return r;
}
