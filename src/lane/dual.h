/* SPDX-License-Identifier: MIT */
/* Floor 2: the formulas of dual.h that loops need. In binary64. */
#ifndef NAKAWARI_LANE_DUAL_H
#define NAKAWARI_LANE_DUAL_H

#include "strict.h"

#include <nakawari/dual.h>

#include "mat.h"
#include "quat.h"

/* (t / 2) q. */
static inline lane_wquat lane_wdual_part(lane_wquat q, lane_wvec3 t)
{
    lane_wquat half = {0.5 * t.x, 0.5 * t.y, 0.5 * t.z, 0.0};
    return lane_wquat_mul(half, q);
}

/* A unit vector times side; `other` where it is the zero vector. */
static inline lane_wvec3 lane_wvec3_or(lane_wvec3 unit, double side, lane_wvec3 other)
{
    return lane_wvec3_select(lane_wvec3_dot(unit, unit) == 0.0, other, lane_wvec3_scale(unit, side));
}

/*
 * The rotation nearest to m without its scale and its mirroring, w >= 0. A column of no length is put upright on the
 * others.
 */
static inline lane_wquat lane_wquat_from_scaled(const lane_wmat3 *m)
{
    lane_wvec3 x = lane_wvec3_normalize(lane_wmat3_column(m, 0)), y = lane_wvec3_normalize(lane_wmat3_column(m, 1)),
               z = lane_wvec3_normalize(lane_wmat3_column(m, 2));
    lane_wvec3 yz = lane_wvec3_cross(y, z), zx = lane_wvec3_cross(z, x), xy = lane_wvec3_cross(x, y);
    double side = lane_wvec3_dot(x, yz) < 0.0 ? -1.0 : 1.0;
    lane_wmat3 unit =
        lane_wmat3_from_columns(lane_wvec3_or(x, side, yz), lane_wvec3_or(y, side, zx), lane_wvec3_or(z, side, xy));
    lane_wquat q = lane_wquat_from_wmat3(&unit, LANE_NEAREST_STEPS);
    return lane_wquat_scale(q, (float)q.w < 0.0f ? -1.0 : 1.0);
}

static inline nkw_dual_quat lane_dual_quat_from_affine(const lane_wmat3 *linear, lane_wvec3 translation)
{
    lane_wquat q = lane_wquat_from_scaled(linear);
    nkw_dual_quat r = {lane_quat_from_wide(q), lane_quat_from_wide(lane_wdual_part(q, translation))};
    return r;
}

#endif
