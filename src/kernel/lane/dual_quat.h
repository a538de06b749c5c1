/* SPDX-License-Identifier: MIT */
/* The formulas of dual.h that loops need. In binary64. */
#ifndef NAKAWARI_LANE_DUAL_QUAT_H
#define NAKAWARI_LANE_DUAL_QUAT_H

#include "strict.h"

#include <nakawari/dual.h>

#include "mat.h"
#include "quat.h"

/* (t / 2) q. */
static inline lane_f64_quat lane_wdual_part(lane_f64_quat q, lane_f64_vec3 t)
{
    lane_f64_quat half = {0.5 * t.x, 0.5 * t.y, 0.5 * t.z, 0.0};
    return lane_f64_quat_mul(half, q);
}

/* A unit vector times side; `other` where it is the zero vector. */
static inline lane_f64_vec3 lane_f64_vec3_or(lane_f64_vec3 unit, double side, lane_f64_vec3 other)
{
    return lane_f64_vec3_select(lane_f64_vec3_dot(unit, unit) == 0.0, other, lane_f64_vec3_scale(unit, side));
}

/*
 * Returns the rotation nearest to m without its scale and its mirroring, w >= 0. A column of length 0 is replaced by
 * the cross product of the two others.
 */
static inline lane_f64_quat lane_f64_quat_from_scaled(const lane_f64_mat3 *m)
{
    lane_f64_vec3 x = lane_f64_vec3_normalize(lane_f64_mat3_column(m, 0)),
                  y = lane_f64_vec3_normalize(lane_f64_mat3_column(m, 1)),
                  z = lane_f64_vec3_normalize(lane_f64_mat3_column(m, 2));
    lane_f64_vec3 yz = lane_f64_vec3_cross(y, z), zx = lane_f64_vec3_cross(z, x), xy = lane_f64_vec3_cross(x, y);
    double side = lane_f64_vec3_dot(x, yz) < -LANE_LEAST_VOLUME ? -1.0 : 1.0;
    lane_f64_mat3 unit = lane_f64_mat3_from_columns(lane_f64_vec3_or(x, side, yz), lane_f64_vec3_or(y, side, zx),
                                                    lane_f64_vec3_or(z, side, xy));
    lane_f64_quat q = lane_f64_quat_from_f64_mat3(&unit, LANE_NEAREST_STEPS);
    return lane_f64_quat_scale(q, (float)q.w < 0.0f ? -1.0 : 1.0);
}

static inline nkw_dual_quat lane_dual_quat_from_affine(const lane_f64_mat3 *linear, lane_f64_vec3 translation)
{
    lane_f64_quat q = lane_f64_quat_from_scaled(linear);
    nkw_dual_quat r = {lane_quat_from_f64(q), lane_quat_from_f64(lane_wdual_part(q, translation))};
    return r;
}

#endif
