/* SPDX-License-Identifier: MIT */
/* The rigid transform of a blended dual quaternion (skin.h). */
#ifndef NAKAWARI_LANE_INFLUENCE_H
#define NAKAWARI_LANE_INFLUENCE_H

#include "strict.h"

#include <math.h>

#include <nakawari/quat.h>

#include "scalar.h"

/*
 * A dual quaternion (real, dual) of real length |real| = sqrt(n2) is normalized to r = real / |real|, d = dual /
 * |real|. For n2 = 0 it becomes the identity. NaN stays NaN.
 */
static inline nkw_quat lane_skin_rotation(nkw_quat real, float n2)
{
    float inverse = 1.0f / sqrtf(lane_divisor(n2)), k = n2 > 0.0f ? inverse : 0.0f;
    nkw_quat r = {real.x * k, real.y * k, real.z * k, real.w * k + (n2 == 0.0f ? 1.0f : 0.0f)};
    return r;
}

/* The translation, 2 d conj(r), of the rotation r and the dual part before it is normalized. */
static inline nkw_vec3 lane_skin_translation(nkw_quat r, nkw_quat dual, float n2)
{
    float inverse = 2.0f / sqrtf(lane_divisor(n2)), k = n2 > 0.0f ? inverse : 0.0f;
    nkw_vec3 t = {
        k * ((dual.x * r.w - dual.w * r.x) + (r.y * dual.z - r.z * dual.y)),
        k * ((dual.y * r.w - dual.w * r.y) + (r.z * dual.x - r.x * dual.z)),
        k * ((dual.z * r.w - dual.w * r.z) + (r.x * dual.y - r.y * dual.x)),
    };
    return t;
}

#endif
