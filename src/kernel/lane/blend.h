/* SPDX-License-Identifier: MIT */
/* The formulas of blend.h beyond those of rotations. */
#ifndef NAKAWARI_LANE_BLEND_H
#define NAKAWARI_LANE_BLEND_H

#include "strict.h"

#include <nakawari/blend.h>
#include <nakawari/vec.h>

#include "quat.h"
#include "scalar.h"

/* A mask brought into 0..1, NaN to 0. */
static inline float lane_mask(float mask)
{
    float m = mask > 0.0f ? mask : 0.0f;
    return m < 1.0f ? m : 1.0f;
}

/* Returns weight / (total + weight), the share of a layer in the sum of itself and the layers before; 0 for 0. */
static inline float lane_share(float weight, float total)
{
    float sum = total + weight;
    float share = weight / lane_divisor(sum);
    return weight > 0.0f ? share : 0.0f;
}

/* Returns the weight of the rest pose: what the total lacks to the threshold, 0 if nothing; 1 for a total of 0. */
static inline float lane_missing(double total, float threshold)
{
    double limit = (double)threshold;
    double short_of = total < limit ? limit - total : 0.0;
    return total == 0.0 ? 1.0f : (float)short_of;
}

/* a / b, and 1 where b is 0. */
static inline float lane_ratio(float a, float b)
{
    float r = a / lane_divisor(b);
    return b == 0.0f ? 1.0f : r;
}

/* ref^-1 a, or a ref^-1 on the parent's side; in binary64, rounded once. A zero ref counts as the identity. */
static inline nkw_quat lane_quat_delta(nkw_quat a, nkw_quat ref, int parent)
{
    lane_f64_quat identity = {0.0, 0.0, 0.0, 1.0};
    lane_f64_quat from = lane_f64_quat_from(ref), to = lane_f64_quat_from(a);
    double n2 = lane_f64_quat_dot(from, from);
    lane_f64_quat inverse = lane_f64_quat_scale(lane_f64_quat_conjugate(from), 1.0 / lane_divisor64(n2));
    inverse = lane_f64_quat_select(n2 == 0.0, identity, inverse);
    lane_f64_quat left = lane_f64_quat_select(parent, to, inverse), right = lane_f64_quat_select(parent, inverse, to);
    return lane_quat_from_f64(lane_f64_quat_mul(left, right));
}

/* Returns the identity as 1 or -1, with the sign of delta.w, so that nlerp from it to delta keeps the sign of delta. */
static inline nkw_quat lane_quat_none(nkw_quat delta)
{
    nkw_quat none = {0.0f, 0.0f, 0.0f, delta.w < 0.0f ? -1.0f : 1.0f};
    return none;
}

/* Returns base rotated by `part`, the nlerp from the identity to the delta by w; base itself for w = 0. */
static inline nkw_quat lane_quat_add_delta(nkw_quat base, nkw_quat part, float w, int parent)
{
    nkw_quat left = lane_quat_select(parent, part, base), right = lane_quat_select(parent, base, part);
    return lane_quat_select(w == 0.0f, base, nkw_quat_mul(left, right));
}

static inline nkw_vec3 lane_vec3_add_delta(nkw_vec3 base, nkw_vec3 delta, float w)
{
    nkw_vec3 moved = nkw_vec3_add_scaled(base, delta, w);
    nkw_vec3 r = {w == 0.0f ? base.x : moved.x, w == 0.0f ? base.y : moved.y, w == 0.0f ? base.z : moved.z};
    return r;
}

#endif
