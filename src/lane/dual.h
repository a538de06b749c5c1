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

/* The rotation nearest to m without its scale and its mirroring, w >= 0. */
static inline lane_wquat lane_wquat_from_scaled(const lane_wmat3 *m)
{
    lane_wmat3 unit = lane_wmat3_from_columns(lane_wvec3_normalize(lane_wmat3_column(m, 0)),
                                              lane_wvec3_normalize(lane_wmat3_column(m, 1)),
                                              lane_wvec3_normalize(lane_wmat3_column(m, 2)));
    lane_wmat3 cofactors = lane_wmat3_cofactors(&unit);
    double side = lane_wmat3_determinant(&unit, &cofactors) < 0.0 ? -1.0 : 1.0;
    for (size_t i = 0; i < 9; i++)
        unit.m[i] *= side;
    lane_wquat q = lane_wquat_from_wmat3(&unit, LANE_NEAREST_STEPS);
    return lane_wquat_scale(q, q.w < 0.0 ? -1.0 : 1.0);
}

static inline nkw_dual_quat lane_dual_quat_from_affine(const lane_wmat3 *linear, lane_wvec3 translation)
{
    lane_wquat q = lane_wquat_from_scaled(linear);
    nkw_dual_quat r = {lane_quat_from_wide(q), lane_quat_from_wide(lane_wdual_part(q, translation))};
    return r;
}

#endif
