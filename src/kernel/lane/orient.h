/* SPDX-License-Identifier: MIT */
/* Curves on rotations. */
#ifndef NAKAWARI_LANE_ORIENT_H
#define NAKAWARI_LANE_ORIENT_H

#include "strict.h"

#include <nakawari/orient.h>

#include "data/slerp.h"
#include "euler.h"
#include "quat.h"
#include "scalar.h"

static inline float lane_flip(float x, uint32_t sign_bit)
{
    return lane_float(lane_bits(x) ^ sign_bit);
}

static inline nkw_quat lane_quat_flip(nkw_quat q, uint32_t sign_bit)
{
    nkw_quat r = {lane_flip(q.x, sign_bit), lane_flip(q.y, sign_bit), lane_flip(q.z, sign_bit),
                  lane_flip(q.w, sign_bit)};
    return r;
}

/* x where mask is all ones, y where it is 0. */
static inline float lane_select(uint32_t mask, float x, float y)
{
    return lane_float(lane_bits(y) ^ ((lane_bits(x) ^ lane_bits(y)) & mask));
}

/* ---- nlerp: a sum, divided by its length ---- */

/* What is divided by the root of n2: a sum, 2^60 times as large, or, where n2 is 1, the result as it is. */
typedef struct lane_nlerp {
    nkw_quat v;
    float n2;
} lane_nlerp;

/*
 * v = (1 - t) a + t c, c = +-b, exactly a at t = 0, exactly c at t = 1, exactly a where a = c is not zero. `generic`, a
 * constant, states that none of these holds.
 */
static inline lane_nlerp lane_quat_nlerp(nkw_quat a, nkw_quat b, float t, int generic)
{
    uint32_t last = generic ? 0u : 0u - (uint32_t)(t == 1.0f);
    float s = lane_select(last, NKW_NLERP_SCALE, NKW_NLERP_SCALE - NKW_NLERP_SCALE * t);
    nkw_quat part = nkw_quat_scale(a, s);
    float dot = nkw_quat_dot(part, b);
    nkw_quat c = lane_quat_flip(b, (dot < 0.0f) != (s < 0.0f) ? 0x80000000u : 0u);
    nkw_quat v = nkw_quat_add(part, nkw_quat_scale(c, NKW_NLERP_SCALE * t));
    int is_equal = (a.x == c.x) & (a.y == c.y) & (a.z == c.z) & (a.w == c.w);
    uint32_t kept = generic ? 0u : 0u - (uint32_t)nkw_nlerp_is_kept(is_equal, t, dot);
    lane_nlerp r = {
        {
            lane_select(kept, lane_select(last, c.x, a.x), v.x),
            lane_select(kept, lane_select(last, c.y, a.y), v.y),
            lane_select(kept, lane_select(last, c.z, a.z), v.z),
            lane_select(kept, lane_select(last, c.w, a.w), v.w),
        },
        lane_select(kept, 1.0f, nkw_quat_dot(v, v)),
    };
    return r;
}

/* The quotient for every length n, the root of n2. */
static inline nkw_quat lane_nlerp_any(nkw_quat v, float n)
{
    return lane_quat_select(n == 1.0f, v, nkw_quat_normalize_any(v, nkw_quat_dot(v, v), 1.0f));
}

/*
 * ---- slerp: the nearer end and a small correction ----
 *
 * b is negated where a.b < 0; theta is the angle between them, n the end nearer to t, f the other end, s the parameter
 * from n to t and r = 1 - s.
 *
 *     sin(k theta)/sin theta = k - E(k)
 *     slerp = (r - E(r)) n + (s - E(s)) f = n - (e f - w (f - n)),      e = E(s) + E(r),  w = s + E(r)
 *     t = 1/2:  slerp = m - e m,                                        m = (a + b)/2,  e = 2 E(1/2)
 *
 * Exchanging a and b and t and 1 - t yields the same bits, also at t = 1/2. At t = 0 and 1 e and w are -0, so that the
 * bracket is +0 where n is -0: "n - 0" keeps a -0.
 *
 *     E(k) = k (1 - k^2) v H(v, k^2) = (c v) H,  c = s r (1 + k),    v = q / (|a.b| + q LANE_SLERP_BEND),  q = |b -
 *     a|^2
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

/* Neither 0, 1/2 nor 1: the masks `half` and `end` are 0. */
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

/* The same by coefficients that are known. */
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

/* The same bits, by coefficients that are known. */
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

/* ---- slerp over any arc and for any t ---- */

/* b or -b: the sign that `path` asks for. Where a.b = 0 the short path keeps b. */
static inline lane_f64_quat lane_f64_quat_aligned(lane_f64_quat a, lane_f64_quat b, nkw_path path)
{
    int obtuse = lane_f64_quat_dot(a, b) < 0.0;
    int negated = path == NKW_PATH_AS_GIVEN ? 0 : path == NKW_PATH_LONG ? !obtuse : obtuse;
    return lane_f64_quat_scale(b, negated ? -1.0 : 1.0);
}

/*
 * The great circle from a's direction u to b's: u cos x + e sin x is a at x = 0 and b at x = h.
 *
 *     h = atan2(|b - (u.b) u|, u.b),      e = the direction of b - (u.b) u
 *
 * Where b has no part at right angles to a, the turn is about the local z axis: e = u * (0, 0, 1, 0).
 */
typedef struct lane_f64_arc {
    lane_f64_quat u, e;
    double h, sine, cosine; /* sine and cosine of h */
    int is_along; /* b has the direction of a or -a */
} lane_f64_arc;

static inline lane_f64_arc lane_f64_arc_between(lane_f64_quat a, lane_f64_quat b)
{
    lane_f64_quat u = lane_f64_quat_normalize(a), v = lane_f64_quat_normalize(b);
    double cosine = lane_f64_quat_dot(u, v);
    lane_f64_quat across = lane_f64_quat_sub(v, lane_f64_quat_scale(u, cosine));
    lane_f64_quat about_z = {u.y, -u.x, u.w, -u.z};
    double s2 = lane_f64_quat_dot(across, across), sine = lane_sqrt64(s2);
    int along = s2 < 0x1p-96;
    double angle = lane_atan2_64(sine, cosine), end = cosine < 0.0 ? LANE_PI : 0.0;
    lane_f64_arc r = {
        u,    lane_f64_quat_select(along, about_z, lane_f64_quat_normalize(across)), along ? end : angle, sine, cosine,
        along};
    return r;
}

/* The point at the angle x + pi turns. `near`, a constant, says that |x| < LANE_NEAR; then there is no branch. */
static inline lane_f64_quat lane_f64_arc_at(const lane_f64_arc *arc, double x, double turns, int near)
{
    /* Two half turns of a quaternion are none. */
    double rest = turns - 2.0 * ((0.5 * turns + LANE_ROUND) - LANE_ROUND);
    double angle = turns == 0.0 ? x : x + LANE_PI * rest;
    lane_sincos turn = near ? lane_sincos64(angle) : lane_turn64(angle);
    int still = (arc->h == 0.0) & (turns == 0.0);
    return lane_f64_quat_add(lane_f64_quat_scale(arc->u, turn.c), lane_f64_quat_scale(arc->e, still ? 0.0 : turn.s));
}

#define LANE_T_NEAR (0.25 * LANE_NEAR)

/* Slerp over any arc, turned by whole turns, for any t; `near` says that |t| < LANE_T_NEAR and turns is 0. */
static inline lane_f64_quat lane_f64_quat_slerp_turned(lane_f64_quat a, lane_f64_quat b, double t, double turns,
                                                       int near)
{
    lane_f64_arc arc = lane_f64_arc_between(a, b);
    double la = lane_sqrt64(lane_f64_quat_dot(a, a)), lb = lane_sqrt64(lane_f64_quat_dot(b, b));
    lane_f64_quat q = lane_f64_arc_at(&arc, t * arc.h, turns == 0.0 ? 0.0 : t * turns, near);
    q = lane_f64_quat_scale(q, t > 0.0 && t < 1.0 ? la + t * (lb - la) : t > 0.0 ? lb : la);
    return lane_f64_quat_select(t == 0.0, a, lane_f64_quat_select(t == 1.0, b, q));
}

static inline nkw_quat lane_quat_slerp_turned(nkw_quat a, nkw_quat b, float t, nkw_path path, int near)
{
    lane_f64_quat from = lane_f64_quat_from(a);
    lane_f64_quat to = lane_f64_quat_aligned(from, lane_f64_quat_from(b), path);
    return lane_quat_from_f64(lane_f64_quat_slerp_turned(from, to, (double)t, 0.0, near));
}

/* b with the sign of the path; negated by an odd number of turns. */
static inline lane_f64_quat lane_f64_quat_after(lane_f64_quat b, int32_t turns)
{
    return lane_f64_quat_scale(b, turns % 2 ? -1.0 : 1.0);
}

static inline nkw_quat lane_quat_slerp_path(nkw_quat a, nkw_quat b, float t, nkw_path path, int32_t turns)
{
    lane_f64_quat from = lane_f64_quat_from(a);
    lane_f64_quat to = lane_f64_quat_aligned(from, lane_f64_quat_from(b), path);
    lane_f64_quat q = lane_f64_quat_slerp_turned(from, to, (double)t, (double)turns, 0);
    return lane_quat_from_f64(t == 1.0f ? lane_f64_quat_after(to, turns) : q);
}

static inline int lane_t_is_inside(float t)
{
    return t >= 0.0f && t <= 1.0f;
}

/* Along the short arc: lane_quat_slerp for t in 0..1. */
static inline nkw_quat lane_quat_slerp_any(nkw_quat a, nkw_quat b, float t)
{
    return lane_t_is_inside(t) ? lane_quat_slerp(a, b, t, 0) : lane_quat_slerp_turned(a, b, t, NKW_PATH_SHORT, 0);
}

/* ---- rotation vectors: r = 2 log q, the axis times the angle ---- */

/*
 * The rate of the rotation vector r = 2 log q of a rotation q with the angular velocity w (outer frame):
 *
 *     r' = w - r x w / 2 + c r x (r x w),      c = (1 - h cot h) / (4 h^2),  h = |r|/2 = |log q|
 *
 * h < pi; at pi the rate is infinite, and c is 1/12 here. Below h = 1/8 by the series of c, to 2^-44.
 */
static inline lane_f64_vec3 lane_f64_rotation_rate(lane_f64_quat q, lane_f64_vec3 half, lane_f64_vec3 w)
{
    lane_f64_vec3 axis = {q.x, q.y, q.z};
    double h2 = lane_f64_vec3_dot(half, half), n = lane_f64_vec3_length(axis);
    double series = 1.0 / 12.0 + h2 * (1.0 / 180.0 + h2 * (1.0 / 1890.0 + h2 * (1.0 / 18900.0 + h2 / 187110.0)));
    double exact = (1.0 - lane_sqrt64(h2) * (q.w / lane_divisor64(n))) / (4.0 * lane_divisor64(h2));
    double c = h2 < 0x1p-6 ? series : exact;
    lane_f64_vec3 r = lane_f64_vec3_scale(half, 2.0);
    return lane_f64_vec3_turned(r, w, -0.5, n == 0.0 ? 1.0 / 12.0 : c);
}

/*
 * The inverse: the angular velocity of the rotation of vector r whose rate is v; s and c are sine and cosine of |r|/2.
 *
 *     w = v + (1 - cos |r|)/|r|^2 r x v + (|r| - sin |r|)/|r|^3 r x (r x v)
 */
static inline lane_f64_vec3 lane_f64_rotation_velocity(lane_f64_vec3 r, lane_sincos half, lane_f64_vec3 v)
{
    double z = lane_f64_vec3_dot(r, r), n = lane_sqrt64(z);
    double a_series = 1.0 / 2.0 - z * (1.0 / 24.0 - z * (1.0 / 720.0 - z * (1.0 / 40320.0 - z / 3628800.0)));
    double b_series = 1.0 / 6.0 - z * (1.0 / 120.0 - z * (1.0 / 5040.0 - z * (1.0 / 362880.0 - z / 39916800.0)));
    double a = 2.0 * (half.s * half.s) / lane_divisor64(z);
    double b = (n - 2.0 * (half.s * half.c)) / lane_divisor64(z * n);
    return lane_f64_vec3_turned(r, v, z < 0.25 ? a_series : a, z < 0.25 ? b_series : b);
}

/* ---- Euler angles ---- */

/* An angle of a within one turn of b's, as NKW_UNWRAP_YAW and _ALL ask. */
static inline double lane_turned_towards(double a, double b)
{
    return a < b - LANE_PI ? a + LANE_TWO_PI : a > b + LANE_PI ? a - LANE_TWO_PI : a;
}

/* (1 - t) a + t b in binary64: exact ends, one rounding. */
static inline float lane_angle_lerp(float a, float b, float t, int unwrap)
{
    double from = unwrap ? lane_turned_towards(a, b) : (double)a;
    float inside = (float)((1.0 - (double)t) * from + (double)t * (double)b);
    return t == 0.0f ? (float)from : t == 1.0f ? b : inside;
}

#endif
