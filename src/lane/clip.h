/* SPDX-License-Identifier: MIT */
/* Floor 4: the rotations of compact clips. */
#ifndef NAKAWARI_LANE_CLIP_H
#define NAKAWARI_LANE_CLIP_H

#include "strict.h"

#include "orient.h"

/*
 * A rotation in three numbers: its axis times the tangent of a quarter of its angle,
 *
 *     p = (x, y, z)/(1 + w)        q = (p, (1 - p.p)/2) / ((1 + p.p)/2)
 *
 * Any three numbers are a rotation, and of q and -q one has |p| <= 1. The map keeps angles: p that is off by e turns
 * the rotation by 4 e/(1 + p.p), whatever the direction.
 *
 * Source Marandi and Modi, A Preferred Coordinate System and the Associated Orientation Representation in Attitude
 * Dynamics, Acta Astronautica 15, 1987; Terzakis, Lourakis and Ait-Boudaoud, Modified Rodrigues Parameters: An
 * Efficient Representation of Orientation in 3D Vision and Graphics, Journal of Mathematical Imaging and Vision, 2018.
 */

/* q times its length (1 + p.p)/2, which is 1 less this w. */
static inline nkw_quat lane_compact_quat(nkw_vec3 p)
{
    float n = (p.x * p.x + p.y * p.y) + p.z * p.z;
    nkw_quat q = {p.x, p.y, p.z, 0.5f - 0.5f * n};
    return q;
}

/* p of a quaternion of any length, in binary64; 0 of 0. */
static inline void lane_compact_numbers(lane_wquat q, double p[3])
{
    double whole = lane_sqrt64(lane_wquat_dot(q, q)) + q.w;
    double part = whole > 0.0 ? 1.0 / whole : 0.0;
    p[0] = q.x * part;
    p[1] = q.y * part;
    p[2] = q.z * part;
}

/* What slerp needs to know of two keys: v, and what their weights are to be multiplied by. */
typedef struct lane_compact_arc {
    float v, of_a, of_b;
} lane_compact_arc;

/*
 * b is turned first if `turned` is the sign bit. With the lengths la and lb, m = la lb and c = m cos theta:
 *
 *     v = q / (c + q LANE_SLERP_BEND),  q = 2 (m - c)
 *
 * |c| <= m, so neither divisor is 0.
 */
static inline lane_compact_arc lane_compact_arc_between(nkw_quat a, nkw_quat b, uint32_t turned)
{
    float la = 1.0f - a.w, lb = 1.0f - b.w, m = la * lb;
    float c = lane_flip(nkw_quat_dot(a, b), turned), q = 2.0f * (m - c), inverse = 1.0f / m;
    lane_compact_arc arc = {q / (c + q * LANE_SLERP_BEND), inverse * lb, lane_flip(inverse * la, turned)};
    return arc;
}

/* Slerp's weights of the nearer and the farther key, k - E(k), by powers of v. */
typedef struct lane_compact_series {
    int first; /* a is nearer */
    float nearer[1 + LANE_SLERP_POWERS], farther[1 + LANE_SLERP_POWERS];
} lane_compact_series;

static inline lane_compact_series lane_compact_series_at(float t)
{
    const lane_slerp_time at = lane_slerp_time_at(t, 0);
    const float zr = at.r * at.r, zs = at.s * at.s;
    lane_compact_series series = {at.first != 0u, {at.r}, {at.s}};
    for (int i = 0; i < LANE_SLERP_POWERS; i++) {
        series.nearer[1 + i] = -at.cr * lane_slerp_coefficient(LANE_SLERP_BRIEF_NEAR, i, 3, zr, zr * zr);
        series.farther[1 + i] = -at.cs * lane_slerp_coefficient(LANE_SLERP_BRIEF_FAR, i, 3, zs, zs * zs);
    }
    return series;
}

static inline float lane_compact_weight(const float *c, float v)
{
    float vv = v * v;
    return ((c[0] + c[1] * v) + (c[2] + c[3] * v) * vv) + (c[4] + c[5] * v) * (vv * vv);
}

/* n is the nearer key and f the farther, and of_n and of_f what belongs to them of the arc. */
static inline nkw_quat lane_compact_slerp(nkw_quat n, nkw_quat f, float v, float of_n, float of_f,
                                          const lane_compact_series *series)
{
    float wn = of_n * lane_compact_weight(series->nearer, v), wf = of_f * lane_compact_weight(series->farther, v);
    nkw_quat r = {wn * n.x + wf * f.x, wn * n.y + wf * f.y, wn * n.z + wf * f.z, wn * n.w + wf * f.w};
    return r;
}

#endif
