/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/dual.h>
#include <nakawari/mat.h>
#include <nakawari/quat.h>
#include <nakawari/vec.h>

#include "lane/dual_quat.h"

nkw_dual_quat nkw_dual_quat_from_rigid(nkw_quat rotation, nkw_vec3 translation)
{
    lane_f64_quat dual = lane_wdual_part(lane_f64_quat_from(rotation), lane_f64_vec3_from(translation));
    nkw_dual_quat r = {rotation, lane_quat_from_f64(dual)};
    return r;
}

nkw_dual_quat nkw_dual_quat_from_mat4(const nkw_mat4 *m)
{
    lane_f64_mat3 linear = lane_f64_mat3_from_mat4(m);
    return lane_dual_quat_from_affine(&linear, lane_f64_vec3_from(nkw_mat4_translation(m)));
}

static nkw_vec3 translation_of(const nkw_dual_quat *d)
{
    nkw_vec3 rv = {d->real.x, d->real.y, d->real.z}, dv = {d->dual.x, d->dual.y, d->dual.z};
    nkw_vec3 along = nkw_vec3_sub(nkw_vec3_scale(dv, d->real.w), nkw_vec3_scale(rv, d->dual.w));
    return nkw_vec3_scale(nkw_vec3_add(along, nkw_vec3_cross(rv, dv)), 2.0f);
}

nkw_mat4 nkw_mat4_from_dual_quat(const nkw_dual_quat *d)
{
    nkw_mat3 linear = nkw_mat3_from_quat(d->real);
    return nkw_mat4_from_mat3(&linear, translation_of(d));
}

nkw_dual_quat nkw_dual_quat_mul(const nkw_dual_quat *a, const nkw_dual_quat *b)
{
    nkw_dual_quat r = {
        nkw_quat_mul(a->real, b->real),
        nkw_quat_add(nkw_quat_mul(a->real, b->dual), nkw_quat_mul(a->dual, b->real)),
    };
    return r;
}

nkw_dual_quat nkw_dual_quat_normalize(const nkw_dual_quat *d)
{
    const nkw_dual_quat none = {{0.0f, 0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 0.0f, 0.0f}};
    lane_f64_quat real = lane_f64_quat_from(d->real), dual = lane_f64_quat_from(d->dual);
    double n2 = lane_f64_quat_dot(real, real);
    if (n2 == 0.0)
        return none;
    double s = lane_rsqrt64(n2);
    real = lane_f64_quat_scale(real, s);
    dual = lane_f64_quat_scale(dual, s);
    dual = lane_f64_quat_sub(dual, lane_f64_quat_scale(real, lane_f64_quat_dot(real, dual)));
    nkw_dual_quat r = {lane_quat_from_f64(real), lane_quat_from_f64(dual)};
    return r;
}

nkw_vec3 nkw_dual_quat_transform_point(const nkw_dual_quat *d, nkw_vec3 p)
{
    return nkw_vec3_add(nkw_quat_rotate(d->real, p), translation_of(d));
}
