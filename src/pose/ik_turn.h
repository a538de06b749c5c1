/* SPDX-License-Identifier: MIT */
/* Rotations that the solvers of inverse kinematics share. */
#ifndef NAKAWARI_IK_TURN_H
#define NAKAWARI_IK_TURN_H

#include "lane/strict.h"

#include <nakawari/ik.h>
#include <nakawari/orient.h>
#include <nakawari/quat.h>

#include "lane/quat.h"

/* The square of the sine below which unit directions count as parallel: binary64 has rounded them to within 2^-50. */
#define IK_NOISE 0x1p-96

/*
 * The unit axis of the shortest rotation from u to v, unit. If they are nearly parallel, u x v is rounding in part: its
 * component along u is removed, so that a half turn about it does not miss; below IK_NOISE it is any perpendicular.
 */
static inline lane_f64_vec3 ik_axis_between(lane_f64_vec3 u, lane_f64_vec3 v)
{
    lane_f64_vec3 c = lane_f64_vec3_cross(u, v);
    c = lane_f64_vec3_add_scaled(c, u, -lane_f64_vec3_dot(c, u));
    int is_noise = lane_f64_vec3_dot(c, c) < IK_NOISE;
    return is_noise ? lane_f64_vec3_perpendicular(u) : lane_f64_vec3_normalize(c);
}

/* The same of unit directions: tan(angle/2) = |u - v| / |u + v|. */
static inline lane_f64_quat ik_turn_between_units(lane_f64_vec3 u, lane_f64_vec3 v)
{
    lane_sincos half = {lane_f64_vec3_length(lane_f64_vec3_sub(u, v)), lane_f64_vec3_length(lane_f64_vec3_add(u, v))};
    return lane_f64_quat_normalize(lane_f64_quat_from_axis_half(ik_axis_between(u, v), half));
}

/*
 * The shortest rotation from one direction to another, of any lengths, that carry the roundings of binary64; the
 * identity where one is zero. (lane_f64_quat_from_vectors takes its vectors as exact.) For less than a right angle
 *
 *     (u x v, |u| |v| + u.v) / its length
 *
 * and beyond, where u x v and the sum vanish together at a half turn, by unit directions.
 */
static inline lane_f64_quat ik_turn_between(lane_f64_vec3 from, lane_f64_vec3 to)
{
    const lane_f64_quat identity = {0.0, 0.0, 0.0, 1.0};
    double along = lane_f64_vec3_dot(from, to);
    if (along > 0.0) {
        lane_f64_vec3 c = lane_f64_vec3_cross(from, to);
        double both = lane_sqrt64(lane_f64_vec3_dot(from, from) * lane_f64_vec3_dot(to, to));
        lane_f64_quat q = {c.x, c.y, c.z, both + along};
        return lane_f64_quat_normalize(q);
    }
    lane_f64_vec3 u = lane_f64_vec3_normalize(from), v = lane_f64_vec3_normalize(to);
    if (lane_f64_vec3_dot(u, u) == 0.0 || lane_f64_vec3_dot(v, v) == 0.0)
        return identity;
    return ik_turn_between_units(u, v);
}

/*
 * The rotation about the unit axis that brings the side of `from` to that of `to`, for unit `to`. With m, w their parts
 * perpendicular to the axis, L = |m| |w|:
 *
 *     tan(angle/2) = y / (L + x) = (L - x) / y,      x = m.w,  y = axis.(m x w)
 *
 * Identity where a part is zero, or its square is below `parallel` of its vector's.
 */
static inline lane_f64_quat ik_turn_about(lane_f64_vec3 axis, lane_f64_vec3 from, lane_f64_vec3 to, double parallel)
{
    const lane_f64_quat identity = {0.0, 0.0, 0.0, 1.0};
    lane_f64_vec3 m = lane_f64_vec3_add_scaled(from, axis, -lane_f64_vec3_dot(from, axis));
    lane_f64_vec3 w = lane_f64_vec3_add_scaled(to, axis, -lane_f64_vec3_dot(to, axis));
    double m2 = lane_f64_vec3_dot(m, m), w2 = lane_f64_vec3_dot(w, w);
    if (!(m2 > parallel * lane_f64_vec3_dot(from, from)) || !(w2 > parallel * lane_f64_vec3_dot(to, to)))
        return identity;
    m = lane_f64_vec3_normalize(m);
    w = lane_f64_vec3_normalize(w);
    double x = lane_f64_vec3_dot(m, w), y = lane_f64_vec3_dot(axis, lane_f64_vec3_cross(m, w));
    lane_sincos half = {x < 0.0 ? 1.0 - x : y, x < 0.0 ? y : 1.0 + x};
    return lane_f64_quat_normalize(lane_f64_quat_from_axis_half(axis, half));
}

/* A share of a rotation, along the shorter arc; at 1 the rotation itself, with w >= 0. */
static inline nkw_quat ik_weighted(lane_f64_quat q, float weight)
{
    nkw_quat whole = lane_quat_from_f64(lane_f64_quat_scale(q, q.w < 0.0 ? -1.0 : 1.0));
    float share = weight > 0.0f ? weight < 1.0f ? weight : 1.0f : 0.0f;
    return share == 1.0f ? whole : nkw_quat_slerp(nkw_quat_identity(), whole, share);
}

/* The distance of the end of a chain from the target, for rotations as they are; infinite if it is not finite. */
float nkwi_ik_chain_error(const nkw_ik_chain *chain, const nkw_quat *rotations, nkw_vec3 target);

#endif
