/* SPDX-License-Identifier: MIT */
/* slerp along the shorter arc, for t in 0..1. */
#ifndef NAKAWARI_LANE_SLERP_H
#define NAKAWARI_LANE_SLERP_H

#include "strict.h"

#include <nakawari/orient.h>

#include "data/slerp.h"
#include "quat.h"
#include "scalar.h"

/*
 * Slerp without a sine: the nearer end and a small correction.
 *
 * b is negated where a.b < 0; theta is the angle between a and b, n the end nearer to t, f the farther end, s the
 * parameter from n to t and r = 1 - s. The textbook's weights are k less an excess E(k):
 *
 *     slerp = sin(r theta)/sin theta n + sin(s theta)/sin theta f,       sin(k theta)/sin theta = k - E(k)
 *           = (r - E(r)) n + (s - E(s)) f
 *           = n + s (f - n) - E(r) n - E(s) f                            by r = 1 - s
 *           = n - (e f - w (f - n)),     e = E(s) + E(r),  w = s + E(r)  by n = f - (f - n)
 *     t = 1/2:  slerp = m - e m,         m = (a + b)/2,    e = 2 E(1/2)
 *
 * Exchanging a and b and t and 1 - t yields the same bits, also at t = 1/2. At t = 0 and 1 e and w are -0, so that the
 * bracket is +0 where n is -0: "n - 0" keeps a -0.
 *
 * E is odd in k, even in theta, and 0 at k = 0 and 1 and at theta = 0. So it has the factors k, 1 - k^2 and theta^2;
 * the last is replaced by a v that needs no arc cosine, and BEND moves the pole of E at theta = pi farther out:
 *
 *     E(k) = -k (1 - k^2) theta^2 (1/6 + (7 - 3 k^2) theta^2/360 + ...)
 *          = k (1 - k^2) v H(v, k^2) = (c v) H,      c = s r (1 + k) for k = s and for k = r
 *     q = |b - a|^2 = 2 (1 - cos theta),             v = q / (|a.b| + q LANE_SLERP_BEND) = theta^2 + O(theta^4)
 *
 * v measures the angle: q determines small angles, the dot product large ones, and the lengths of a and b cancel. H is
 * a polynomial in v; the coefficient of each power is one in k^2, which slerps at one t share.
 */

/* a.b. The smallest normal number makes -0 positive and prevents 0 / 0. */
static inline float lane_slerp_cosine(nkw_quat a, nkw_quat b)
{
    return nkw_quat_dot(a, b) + 0x1p-126f;
}

/*
 * q of v from |a.b| and q. `keys`, a constant: a and b are stored keys. Where (|a|^2 + |b|^2)/2 differs from 1 by more
 * than rounding their angle is acos |a.b|, as in glTF, or 0 where |a.b| > 1: q = 2 (1 - |a.b|). Equal keys have the
 * angle 0.
 */
static inline float lane_slerp_square(float cosine, float q, int keys)
{
    float u = cosine - 1.0f, off = u + 0.5f * q;
    int unit = (off <= 0x1p-20f) & (off >= -0x1p-20f), same = q == 0.0f;
    float stored = u < 0.0f ? -2.0f * u : 0.0f;
    return !keys || (unit | same) ? q : stored;
}

/*
 * A v below this, an angle below 8.7e-5 rad, is 0: e is at most v/8, 0.02 u. Products of such an e with components that
 * are noise, as in exported rotations, are subnormal, which takes some processors 150 cycles each.
 */
#define LANE_SLERP_LEAST 0x1p-27f

/* v from |a.b| and q. */
static inline float lane_slerp_angle(float cosine, float q, int keys)
{
    q = lane_slerp_square(cosine, q, keys);
    float v = q / (cosine + q * LANE_SLERP_BEND);
    return v < LANE_SLERP_LEAST ? 0.0f : v;
}

/* v, with the sign bit set where b is negated. */
static inline float lane_slerp_arc(nkw_quat a, nkw_quat b, int keys)
{
    float cosine = lane_slerp_cosine(a, b);
    nkw_quat d = nkw_quat_sub(lane_quat_flip(b, lane_sign_bit(cosine)), a);
    return lane_flip(lane_slerp_angle(lane_abs(cosine), nkw_quat_dot(d, d), keys), lane_sign_bit(cosine));
}

/* What depends on t alone: s, r, the c of each, and masks: a is nearer, t is 1/2, t is 0 or 1. */
typedef struct lane_slerp_time {
    float s, r, cs, cr;
    uint32_t first, half, end;
} lane_slerp_time;

static inline int lane_t_is_inside(float t)
{
    return t >= 0.0f && t <= 1.0f;
}

/* Whether t is inside 0..1 and not 1/2: the masks `half` and `end` are then 0. */
static inline int lane_t_is_generic(float t)
{
    return t > 0.0f && t < 1.0f && t != 0.5f;
}

/* For t in 0..1; a -0 counts as 0. `generic`, a constant, states that t is. */
static inline lane_slerp_time lane_slerp_time_at(float t, int generic)
{
    t = generic ? t : t + 0.0f;
    float u = 1.0f - t, s = t < u ? t : u, r = u < t ? t : u, sr = t * u;
    lane_slerp_time at = {s, r, sr * (1.0f + s), sr * (1.0f + r), 0u - (lane_bits(t - 0.5f) >> 31), 0u, 0u};
    at.half = generic ? 0u : 0u - (uint32_t)(t == 0.5f);
    at.end = generic ? 0u : 0u - (uint32_t)(s == 0.0f);
    return at;
}

/* The same for a generic t, with constants: which end is nearer, and no other case. */
static inline lane_slerp_time lane_slerp_time_from(lane_slerp_time at, int first)
{
    at.first = first ? ~0u : 0u;
    at.half = at.end = 0u;
    return at;
}

/* The coefficient of v^i, a polynomial of `degree` in z = k^2, and zz = z^2. Rows above the degree are 0. */
static inline float lane_slerp_coefficient(const float h[][LANE_SLERP_POWERS], int i, int degree, float z, float zz)
{
    float low = degree > 0 ? h[0][i] + z * h[1][i] : h[0][i];
    float high = degree > 2 ? h[2][i] + z * h[3][i] : h[2][i];
    return degree > 1 ? low + zz * high : low;
}

/* H by its coefficients: pairs are summed first, then Horner in v^2, for half the latency of Horner in v. */
static inline float lane_slerp_sum(float h0, float h1, float h2, float h3, float h4, float h5, float v)
{
    float vv = v * v;
    return (h0 + v * h1) + vv * ((h2 + v * h3) + vv * (h4 + v * h5));
}

/* E(r), the nearer end's, or E(s), the other end's; each with the degrees that docs/generate/slerp.c chose. */
static inline float lane_slerp_excess(const lane_slerp_time *at, int nearer, float v)
{
    const float k = nearer ? at->r : at->s, z = k * k, zz = z * z;
    const float(*h)[LANE_SLERP_POWERS] = nearer ? LANE_SLERP_NEARER : LANE_SLERP_FARTHER;
    float h1 = lane_slerp_coefficient(h, 1, 1, z, zz), h2 = lane_slerp_coefficient(h, 2, 2, z, zz);
    float h3 = lane_slerp_coefficient(h, 3, nearer ? 3 : 1, z, zz);
    float h5 = lane_slerp_coefficient(h, 5, nearer ? 2 : 1, z, zz);
    return ((nearer ? at->cr : at->cs) * v) * lane_slerp_sum(h[0][0], h1, h2, h3, h[0][4], h5, v);
}

/* Computes the same from coefficients that lane_slerp_series_at has computed. */
static inline float lane_slerp_excess_by(const float h[LANE_SLERP_POWERS], float c, float v)
{
    return (c * v) * lane_slerp_sum(h[0], h[1], h[2], h[3], h[4], h[5], v);
}

/* The coefficients of both, for many v at one t: the same bits. */
typedef struct lane_slerp_series {
    float nearer[LANE_SLERP_POWERS], farther[LANE_SLERP_POWERS];
} lane_slerp_series;

static inline lane_slerp_series lane_slerp_series_at(const lane_slerp_time *at)
{
    const float zr = at->r * at->r, zs = at->s * at->s;
    lane_slerp_series p;
    for (int i = 0; i < LANE_SLERP_POWERS; i++) {
        p.nearer[i] = lane_slerp_coefficient(LANE_SLERP_NEARER, i, 3, zr, zr * zr);
        p.farther[i] = lane_slerp_coefficient(LANE_SLERP_FARTHER, i, 3, zs, zs * zs);
    }
    return p;
}

typedef struct lane_slerp_weights {
    float e, w;
} lane_slerp_weights;

static inline lane_slerp_weights lane_slerp_weights_by(const lane_slerp_time *at, float er, float es)
{
    lane_slerp_weights k = {lane_select(at->half, es, er) + es, lane_select(at->end, er, at->s + er)};
    return k;
}

static inline lane_slerp_weights lane_slerp_weights_of(const lane_slerp_time *at, float v)
{
    return lane_slerp_weights_by(at, lane_slerp_excess(at, 1, v), lane_slerp_excess(at, 0, v));
}

/* Computes the same bits from coefficients that lane_slerp_series_at has computed. */
static inline lane_slerp_weights lane_slerp_weights_in(const lane_slerp_time *at, const lane_slerp_series *c, float v)
{
    return lane_slerp_weights_by(at, lane_slerp_excess_by(c->nearer, at->cr, v),
                                 lane_slerp_excess_by(c->farther, at->cs, v));
}

/* One component. */
static inline float lane_slerp_component(float a, float b, const lane_slerp_time *at, lane_slerp_weights k)
{
    float middle = 0.5f * (a + b);
    float n = lane_select(at->half, middle, lane_select(at->first, a, b));
    float f = lane_select(at->half, middle, lane_select(at->first, b, a));
    return n - (k.e * f - k.w * (f - n));
}

static inline nkw_quat lane_quat_slerp_by(nkw_quat a, nkw_quat b, float arc, const lane_slerp_time *at,
                                          lane_slerp_weights k)
{
    nkw_quat c = lane_quat_flip(b, lane_sign_bit(arc));
    nkw_quat r = {
        lane_slerp_component(a.x, c.x, at, k),
        lane_slerp_component(a.y, c.y, at, k),
        lane_slerp_component(a.z, c.z, at, k),
        lane_slerp_component(a.w, c.w, at, k),
    };
    return r;
}

/* For t in 0..1; `keys` as in lane_slerp_angle. */
static inline nkw_quat lane_quat_slerp(nkw_quat a, nkw_quat b, float t, int keys)
{
    lane_slerp_time at = lane_slerp_time_at(t, 0);
    float arc = lane_slerp_arc(a, b, keys);
    return lane_quat_slerp_by(a, b, arc, &at, lane_slerp_weights_of(&at, lane_abs(arc)));
}

#endif
