/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/euler.h>

#include "lane/euler.h"
#include "lane/mat.h"
#include "pack/quat.h"
#include "pack/sincos.h"

LANE_SELDOM static lane_f64_quat far_rotation(const double half[3], double e)
{
    return lane_f64_quat_from_half_angles(half[0], half[1], half[2], e);
}

static inline lane_f64_quat rotation_of(nkw_vec3 angles, nkw_euler_order order)
{
    const lane_euler_axes *o = lane_euler_axes_of(order);
    const float a[3] = {angles.x, angles.y, angles.z};
    const double half[3] = {0.5 * (double)a[o->i], 0.5 * (double)a[o->j], 0.5 * (double)a[o->k]};
    double n2 = (half[0] * half[0] + half[1] * half[1]) + half[2] * half[2];
    lane_f64_quat p =
        n2 < LANE_NEAR * LANE_NEAR
            ? lane_f64_quat_from_halves(f64x2_sincos(half[0]), f64x2_sincos(half[1]), f64x2_sincos(half[2]), o->e)
            : far_rotation(half, o->e);
    lane_f64_vec3 v = lane_euler_in_place(p.x, p.y, p.z, o);
    lane_f64_quat q = {v.x, v.y, v.z, p.w};
    return q;
}

LANE_FLAT nkw_quat nkw_quat_from_euler(nkw_vec3 angles, nkw_euler_order order)
{
    return lane_quat_from_f64(rotation_of(angles, order));
}

LANE_FLAT nkw_mat3 nkw_mat3_from_euler(nkw_vec3 angles, nkw_euler_order order)
{
    lane_f64_mat3 m = lane_f64_mat3_from_f64_quat(rotation_of(angles, order));
    return lane_mat3_from_f64(&m, 1.0);
}

/* A length that is far from 1. Zero returns the identity. */
LANE_SELDOM static lane_f64_quat rescued(lane_f64_quat q)
{
    return lane_f64_quat_normalize(q);
}

LANE_FLAT nkw_vec3 nkw_euler_from_quat(nkw_quat q, nkw_euler_order order)
{
    lane_f64_quat w = lane_f64_quat_from(quat_argument(q));
    double n2 = lane_f64_quat_dot(w, w);
    if (!(n2 > 0x1p-20 && n2 < 0x1p20))
        w = rescued(w);
    return lane_vec3_from_f64(lane_euler_from_f64_quat(lane_f64_quat_positive(w), lane_euler_axes_of(order)));
}

LANE_FLAT nkw_vec3 nkw_euler_from_mat3(const nkw_mat3 *m, nkw_euler_order order)
{
    lane_f64_mat3 w = lane_f64_mat3_from(m);
    lane_f64_form k = lane_f64_form_from_f64_mat3(&w);
    lane_f64_quat q = lane_f64_form_dominant(&k, LANE_NEAREST_STEPS);
    if (!(lane_f64_quat_dot(q, q) < 0x1p20))
        q = rescued(q);
    return lane_vec3_from_f64(lane_euler_from_f64_quat(q, lane_euler_axes_of(order)));
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
