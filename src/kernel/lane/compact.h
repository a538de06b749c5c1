/* SPDX-License-Identifier: MIT */
/* The rotations of compact clips. */
#ifndef NAKAWARI_LANE_COMPACT_H
#define NAKAWARI_LANE_COMPACT_H

#include "strict.h"

#include "scalar.h"
#include "slerp.h"

/*
 * A rotation as three numbers: its axis times the tangent of a quarter of its angle,
 *
 *     p = (x, y, z)/(1 + w)        q = (p, (1 - p.p)/2) / ((1 + p.p)/2)
 *
 * Any three numbers are a rotation. Either q or -q has |p| <= 1. The map is conformal: a small error e of p in any
 * direction rotates the result by 4 e/(1 + p.p) radians.
 *
 * Source Marandi and Modi, A Preferred Coordinate System and the Associated Orientation Representation in Attitude
 * Dynamics, Acta Astronautica 15, 1987; Terzakis, Lourakis and Ait-Boudaoud, Modified Rodrigues Parameters: An
 * Efficient Representation of Orientation in 3D Vision and Graphics, Journal of Mathematical Imaging and Vision, 2018.
 */

/* q times (1 + p.p)/2. This is the length of the result, and is 1 - w of the result. */
static inline nkw_quat lane_compact_quat(nkw_vec3 p)
{
    float n = (p.x * p.x + p.y * p.y) + p.z * p.z;
    nkw_quat q = {p.x, p.y, p.z, 0.5f - 0.5f * n};
    return q;
}

/* p of a quaternion of any length, in binary64. Returns 0 for q = 0, and for q = (0, 0, 0, w), w < 0. */
static inline void lane_compact_numbers(lane_f64_quat q, double p[3])
{
    double whole = lane_sqrt64(lane_f64_quat_dot(q, q)) + q.w;
    double scale = whole > 0.0 ? 1.0 / whole : 0.0;
    p[0] = q.x * scale;
    p[1] = q.y * scale;
    p[2] = q.z * scale;
}

/* The arc from key a to key b: v, and the factors of the weights of a and b, since both have lengths other than 1. */
typedef struct lane_compact_arc {
    float v, scale_a, scale_b;
} lane_compact_arc;

/*
 * a and b are results of lane_compact_quat. negated: 0, or the sign bit, which negates b. With the lengths la and lb of
 * a and b, m = la lb, and c = a.b = m cos theta:
 *
 *     v = q / (c + q LANE_SLERP_BEND),  q = 2 (m - c)
 *
 *     scale_a = 1/la,  scale_b = 1/lb, or -1/lb if b is negated
 *
 * |c| <= m and m >= 1/4, so neither divisor is 0.
 */
static inline lane_compact_arc lane_compact_arc_between(nkw_quat a, nkw_quat b, uint32_t negated)
{
    float la = 1.0f - a.w, lb = 1.0f - b.w, m = la * lb;
    float c = lane_flip(nkw_quat_dot(a, b), negated), q = 2.0f * (m - c), inverse = 1.0f / m;
    lane_compact_arc arc = {q / (c + q * LANE_SLERP_BEND), inverse * lb, lane_flip(inverse * la, negated)};
    return arc;
}

/* The weights k - E(k) of the nearer and the farther key, as coefficients of the powers of v. */
typedef struct lane_compact_series {
    int first; /* whether a is the nearer key */
    float nearer[1 + LANE_SLERP_POWERS], farther[1 + LANE_SLERP_POWERS];
} lane_compact_series;

static inline lane_compact_series lane_compact_series_at(float t)
{
    const lane_slerp_time at = lane_slerp_time_at(t, 0);
    const float zr = at.r * at.r, zs = at.s * at.s;
    lane_compact_series series = {at.first != 0u, {at.r}, {at.s}};
    for (int i = 0; i < LANE_SLERP_POWERS; i++) {
        series.nearer[1 + i] = -at.cr * lane_slerp_coefficient(LANE_SLERP_COMPACT_NEARER, i, 3, zr, zr * zr);
        series.farther[1 + i] = -at.cs * lane_slerp_coefficient(LANE_SLERP_COMPACT_FARTHER, i, 3, zs, zs * zs);
    }
    return series;
}

/* The sum of c[i] v^i, i = 0..5. */
static inline float lane_compact_weight(const float *c, float v)
{
    float vv = v * v;
    return ((c[0] + c[1] * v) + (c[2] + c[3] * v) * vv) + (c[4] + c[5] * v) * (vv * vv);
}

/* The rotation between n, the nearer key, and f, the farther: wn n + wf f. scale_n and scale_f are those of the arc. */
static inline nkw_quat lane_compact_slerp(nkw_quat n, nkw_quat f, float v, float scale_n, float scale_f,
                                          const lane_compact_series *series)
{
    float wn = scale_n * lane_compact_weight(series->nearer, v), wf = scale_f * lane_compact_weight(series->farther, v);
    nkw_quat r = {wn * n.x + wf * f.x, wn * n.y + wf * f.y, wn * n.z + wf * f.z, wn * n.w + wf * f.w};
    return r;
}

#endif
