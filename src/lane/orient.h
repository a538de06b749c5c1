/* SPDX-License-Identifier: MIT */
/* Floor 3: curves on rotations. */
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

/* b or -b, whichever lies on a's side. */
static inline nkw_quat lane_quat_turned(nkw_quat a, nkw_quat b)
{
    uint32_t turned = nkw_quat_dot(a, b) < 0.0f ? 0x80000000u : 0u;
    nkw_quat r = {lane_flip(b.x, turned), lane_flip(b.y, turned), lane_flip(b.z, turned), lane_flip(b.w, turned)};
    return r;
}

/* The point v of the chord from a to b, turned to a's side, and the way back from there to the end nearer to t. */
typedef struct lane_chord {
    nkw_quat v;
    float back;
} lane_chord;

/* As nkw_lerp: where back = 0, v is the end as it is. */
static inline lane_chord lane_quat_chord(nkw_quat a, nkw_quat b, float t)
{
    nkw_quat c = lane_quat_turned(a, b);
    int first = t < 0.5f;
    lane_chord r;
    r.back = (first ? 0.0f : 1.0f) - t;
    nkw_quat way = nkw_quat_scale(nkw_quat_sub(c, a), r.back), none = {0.0f, 0.0f, 0.0f, 0.0f};
    r.v = nkw_quat_sub(lane_quat_select(first, a, c), lane_quat_select(r.back == 0.0f, none, way));
    return r;
}

/* v for t inside 0..1 where it is known at compile time which end is nearer. */
static inline nkw_quat lane_quat_chord_near(nkw_quat a, nkw_quat b, float t, int first)
{
    nkw_quat c = lane_quat_turned(a, b);
    return nkw_quat_add(first ? a : c, nkw_quat_scale(nkw_quat_sub(c, a), first ? t : t - 1.0f));
}

/*
 * v / |v| = v + v g,  g = 1/|v| - 1 = m / (|v| + |v|^2),  m = 1 - |v|^2, for chords of |v|^2 in 0..2 without 0.
 */
static inline nkw_quat lane_quat_settle_inside(nkw_quat v, float m)
{
    float n2 = 1.0f - m;
    return nkw_quat_add(v, nkw_quat_scale(v, m / (sqrtf(n2) + n2)));
}

/* x, or where only the sign bit is kept, a zero of its sign. */
static inline float lane_kept(uint32_t mask, float x)
{
    return lane_float(lane_bits(x) & mask);
}

/* The same for any: a chord that t outside 0..1 made longer than sqrt 2 is divided by its length outright. */
static inline nkw_quat lane_quat_settle(nkw_quat v)
{
    float m = lane_quat_defect(v), n2 = 1.0f - m;
    float n = sqrtf(n2);
    int outright = n2 > 2.0f;
    float g = (outright ? 1.0f : m) / (outright ? n : n + n2);
    uint32_t kept = outright ? 0x80000000u : ~0u;
    nkw_quat part = {lane_kept(kept, v.x), lane_kept(kept, v.y), lane_kept(kept, v.z), lane_kept(kept, v.w)};
    return lane_quat_select(n2 > 0.0f, nkw_quat_add(part, nkw_quat_scale(v, g)), nkw_quat_identity());
}

static inline nkw_quat lane_quat_nlerp(nkw_quat a, nkw_quat b, float t)
{
    lane_chord c = lane_quat_chord(a, b, t);
    return lane_quat_select(c.back == 0.0f, c.v, lane_quat_settle(c.v));
}

/*
 * Polynomials of 3, 5 and 6 coefficients, lowest power first: pairs are summed first, then Horner in v^2, for half the
 * latency of Horner in v.
 */
static inline float lane_pairs3(const float *c, float v, float vv)
{
    return (c[0] + v * c[1]) + vv * c[2];
}

static inline float lane_pairs5(const float *c, float v, float vv)
{
    return (c[0] + v * c[1]) + vv * lane_pairs3(c + 2, v, vv);
}

static inline float lane_pairs6(const float *c, float v, float vv)
{
    return (c[0] + v * c[1]) + vv * ((c[2] + v * c[3]) + vv * (c[4] + v * c[5]));
}

/*
 * Slerp as the end nearer to t and small corrections to it. b is turned to a's side; theta is their angle, u = 1 - t:
 *
 *     slerp = sin(u theta)/sin theta a + sin(t theta)/sin theta b        sin(k theta)/sin theta = k - E(k)
 *
 *     t < 1/2:  slerp = a         - (-t d + (E(u) a + E(t) b))           d = b - a
 *     t = 1/2:  slerp = (a + b)/2 - (       (E(u) a + E(t) b))
 *     t > 1/2:  slerp = b         - ( u d + (E(u) a + E(t) b))
 *
 * Exchanging a and b and t and u gives the same bits, also at t = 1/2.
 *
 *     E(k) = k (1 - k^2) v H(v, k^2 v) = (c v) H,  c = t u (1 + k),    v = q / (|a.b| + q LANE_SLERP_BEND),  q = |d|^2
 *
 * v stands for the angle: small ones are told by the chord d, large ones by the dot product, and the lengths of a and b
 * cancel. c is never -0, so E(0) = -0 E(1) = -0: the bracket is +0 where nothing is to be added, and "near - 0" keeps
 * a -0.
 */

/* x where mask is all ones, y where it is 0. */
static inline float lane_blend(uint32_t mask, float x, float y)
{
    return lane_float(lane_bits(y) ^ ((lane_bits(x) ^ lane_bits(y)) & mask));
}

/* What slerp needs to know of a and b: whether b is turned, their angle as v, and H's polynomials in it. */
typedef struct lane_slerp_arc {
    uint32_t turned;
    float v, h0, h1, h2, h3;
} lane_slerp_arc;

/* a.b. The smallest normal number makes -0 positive and keeps 0 / 0 away. */
static inline float lane_slerp_cosine(nkw_quat a, nkw_quat b)
{
    return nkw_quat_dot(a, b) + 0x1p-126f;
}

/* The arc of which v is known. */
static inline lane_slerp_arc lane_slerp_arc_of(uint32_t turned, float v)
{
    float vv = v * v;
    lane_slerp_arc arc = {
        turned,
        v,
        lane_pairs6(LANE_SLERP_H0, v, vv),
        lane_pairs5(LANE_SLERP_H1, v, vv),
        lane_pairs3(LANE_SLERP_H2, v, vv),
        LANE_SLERP_H3[0] + v * LANE_SLERP_H3[1],
    };
    return arc;
}

/*
 * q of keys as they are stored. Where (|a|^2 + |b|^2)/2 is off 1 by more than rounding their angle is acos |a.b|, as
 * glTF has it, and none where that is above 1: q = 2 (1 - |a.b|). Equal keys have none either.
 */
static inline float lane_slerp_stored(float q, float cosine)
{
    float u = cosine - 1.0f, off = u + 0.5f * q;
    int unit = (off <= 0x1p-20f) & (off >= -0x1p-20f), same = q == 0.0f;
    float stored = u < 0.0f ? -2.0f * u : 0.0f;
    return unit | same ? q : stored;
}

/* From a to c, which is b on a's side. `keys`, a constant: a and b are keys as they are stored; else they are unit. */
static inline lane_slerp_arc lane_slerp_arc_between(nkw_quat a, nkw_quat b, int keys)
{
    float cosine = lane_slerp_cosine(a, b);
    uint32_t turned = lane_sign_bit(cosine);
    nkw_quat c = {lane_flip(b.x, turned), lane_flip(b.y, turned), lane_flip(b.z, turned), lane_flip(b.w, turned)};
    nkw_quat d = nkw_quat_sub(c, a);
    float q = nkw_quat_dot(d, d);
    cosine = lane_flip(cosine, turned);
    q = keys ? lane_slerp_stored(q, cosine) : q;
    return lane_slerp_arc_of(turned, q / (cosine + q * LANE_SLERP_BEND));
}

/* What it needs to know of t: the masks say whether a is the nearer end, and whether t is 1/2. */
typedef struct lane_slerp_pace {
    float t, u, shift;
    uint32_t first, half;
} lane_slerp_pace;

/* For t other than 1/2. */
static inline lane_slerp_pace lane_slerp_pace_aside(float t)
{
    float u = 1.0f - t, late = t - 0.5f;
    uint32_t first = 0u - (lane_bits(late) >> 31);
    lane_slerp_pace pace = {t, u, lane_flip(t < u ? t : u, lane_sign_bit(late)), first, 0u};
    return pace;
}

static inline lane_slerp_pace lane_slerp_pace_at(float t)
{
    lane_slerp_pace pace = lane_slerp_pace_aside(t);
    pace.half = 0u - (uint32_t)(t == 0.5f);
    pace.shift = lane_blend(pace.half, 0.0f, pace.shift);
    return pace;
}

/* The same pace where it is known at compile time which end is nearer, so that nothing is left to be selected. */
static inline lane_slerp_pace lane_slerp_near(lane_slerp_pace pace, int first)
{
    pace.first = first ? ~0u : 0u;
    pace.half = 0u;
    return pace;
}

/* One component: base - (shift d + (E(u) a + E(t) b)). */
static inline float lane_slerp_component(float a, float b, const lane_slerp_pace *pace, float eu, float et)
{
    float base = lane_blend(pace->half, 0.5f * (a + b), lane_blend(pace->first, a, b));
    return base - (pace->shift * (b - a) + (eu * a + et * b));
}

/* E(k) for k = u or t. */
static inline float lane_slerp_excess_on(const lane_slerp_arc *arc, const lane_slerp_pace *pace, float k)
{
    float c = (pace->t * pace->u + 0.0f) * (1.0f + k), kv = k * k * arc->v;
    return (c * arc->v) * (arc->h0 + kv * (arc->h1 + kv * (arc->h2 + kv * (arc->h3 + kv * LANE_SLERP_H4[0]))));
}

/* The slerp by its E(u) and E(t). */
static inline nkw_quat lane_quat_slerp_by(nkw_quat a, nkw_quat b, uint32_t turned, const lane_slerp_pace *pace,
                                          float eu, float et)
{
    nkw_quat r = {
        lane_slerp_component(a.x, lane_flip(b.x, turned), pace, eu, et),
        lane_slerp_component(a.y, lane_flip(b.y, turned), pace, eu, et),
        lane_slerp_component(a.z, lane_flip(b.z, turned), pace, eu, et),
        lane_slerp_component(a.w, lane_flip(b.w, turned), pace, eu, et),
    };
    return r;
}

static inline nkw_quat lane_quat_slerp_on(nkw_quat a, nkw_quat b, const lane_slerp_arc *arc,
                                          const lane_slerp_pace *pace)
{
    float et = lane_slerp_excess_on(arc, pace, pace->t), eu = lane_slerp_excess_on(arc, pace, pace->u);
    return lane_quat_slerp_by(a, b, arc->turned, pace, eu, et);
}

static inline nkw_quat lane_quat_slerp_between(nkw_quat a, nkw_quat b, float t, int keys)
{
    lane_slerp_arc arc = lane_slerp_arc_between(a, b, keys);
    lane_slerp_pace pace = lane_slerp_pace_at(t);
    return lane_quat_slerp_on(a, b, &arc, &pace);
}

static inline nkw_quat lane_quat_slerp(nkw_quat a, nkw_quat b, float t)
{
    return lane_quat_slerp_between(a, b, t, 0);
}

/* b or -b: the sign that `path` asks for. Where a.b = 0 the short path keeps b. */
static inline lane_wquat lane_wquat_aligned(lane_wquat a, lane_wquat b, nkw_path path)
{
    int obtuse = lane_wquat_dot(a, b) < 0.0;
    int turned = path == NKW_PATH_AS_GIVEN ? 0 : path == NKW_PATH_LONG ? !obtuse : obtuse;
    return lane_wquat_scale(b, turned ? -1.0 : 1.0);
}

/*
 * Slerp over any arc and for any t, from a's direction u and the direction e at right angles to it towards b:
 *
 *     q = l (u cos(t h) + e sin(t h)),      h = atan2(|b - (u.b) u|, u.b),      l from |a| to |b|
 *
 * Where b has no part at right angles to a, the turn is about the local z axis: e = u * (0, 0, 1, 0). `near`, a
 * constant, says that |t| < LANE_T_NEAR; then there is no branch.
 */
#define LANE_T_NEAR (0.25 * LANE_NEAR)

static inline lane_wquat lane_wquat_slerp_turned(lane_wquat a, lane_wquat b, double t, int near)
{
    lane_wquat u = lane_wquat_normalize(a), v = lane_wquat_normalize(b);
    double cosine = lane_wquat_dot(u, v);
    lane_wquat across = lane_wquat_sub(v, lane_wquat_scale(u, cosine));
    lane_wquat about_z = {u.y, -u.x, u.w, -u.z};
    double s2 = lane_wquat_dot(across, across);
    int along = s2 < 0x1p-96;
    double arc = lane_atan2_64(lane_sqrt64(s2), cosine), end = cosine < 0.0 ? LANE_PI : 0.0;
    double h = along ? end : arc;
    lane_wquat e = lane_wquat_select(along, about_z, lane_wquat_normalize(across));
    lane_sincos turn = near ? lane_sincos64(t * h) : lane_turn64(t * h);
    double la = lane_sqrt64(lane_wquat_dot(a, a)), lb = lane_sqrt64(lane_wquat_dot(b, b));
    lane_wquat q = lane_wquat_add(lane_wquat_scale(u, turn.c), lane_wquat_scale(e, h == 0.0 ? 0.0 : turn.s));
    q = lane_wquat_scale(q, t > 0.0 && t < 1.0 ? la + t * (lb - la) : t > 0.0 ? lb : la);
    return lane_wquat_select(t == 0.0, a, lane_wquat_select(t == 1.0, b, q));
}

static inline nkw_quat lane_quat_slerp_turned(nkw_quat a, nkw_quat b, float t, nkw_path path, int near)
{
    lane_wquat from = lane_wquat_from(a);
    lane_wquat to = lane_wquat_aligned(from, lane_wquat_from(b), path);
    return lane_quat_from_wide(lane_wquat_slerp_turned(from, to, (double)t, near));
}

static inline nkw_quat lane_quat_slerp_path(nkw_quat a, nkw_quat b, float t, nkw_path path)
{
    return lane_quat_slerp_turned(a, b, t, path, 0);
}

/* lane_quat_slerp holds for t in 0..1; the arc goes on beyond. */
static inline int lane_t_is_inside(float t)
{
    return t >= 0.0f && t <= 1.0f;
}

static inline nkw_quat lane_quat_slerp_any(nkw_quat a, nkw_quat b, float t)
{
    return lane_t_is_inside(t) ? lane_quat_slerp(a, b, t) : lane_quat_slerp_path(a, b, t, NKW_PATH_SHORT);
}

#if defined(LANE_FOUR)
/*
 * Single calls, the four components side by side: line for line the formulas of lane_quat_nlerp and lane_quat_slerp,
 * with the same bits.
 */

/* nlerp in *out; not for chords of 0 or of sqrt 2 and more, as t outside 0..1 makes them. */
static inline int lane_four_nlerp(lane_four a, lane_four b, float t, lane_four *out)
{
    const lane_four quarter = {0.25f, 0.25f, 0.25f, 0.25f}, half = quarter + quarter, one = half + half;
    const lane_four zero = {0.0f, 0.0f, 0.0f, 0.0f};
    lane_four c = lane_four_flip(b, (lane_four_sum(a * b) < zero) << 31), at = lane_four_all(t);
    lane_four_bits first = at < half;
    lane_four near = lane_four_select(first, a, c), back = lane_four_select(first, zero, one) - at;
    lane_four_bits inside = back != zero;
    lane_four v = near - (lane_four)((lane_four_bits)(back * (c - a)) & inside);
    float m = lane_four_sum(quarter - v * v)[0], n2 = 1.0f - m;
    lane_four g = lane_four_all(m / (sqrtf(n2) + n2));
    *out = v + v * (lane_four)((lane_four_bits)g & inside);
    return m * m < 1.0f;
}

/* LANE_SLERP_H0[i] to _H3[i]: the coefficients that shorter polynomials lack are 0. */
static inline lane_four lane_four_slerp_power(int i)
{
    lane_four c = {LANE_SLERP_H0[i], i < 5 ? LANE_SLERP_H1[i] : 0.0f, i < 3 ? LANE_SLERP_H2[i] : 0.0f,
                   i < 2 ? LANE_SLERP_H3[i] : 0.0f};
    return c;
}

/* lane_slerp_arc's h0..h3, v being finite or NaN. */
static inline lane_four lane_four_slerp_polynomials(lane_four v)
{
    lane_four vv = v * v, h = lane_four_slerp_power(4) + v * lane_four_slerp_power(5);
    for (int i = 2; i >= 0; i -= 2)
        h = (lane_four_slerp_power(i) + v * lane_four_slerp_power(i + 1)) + vv * h;
    return h;
}

/* For t in 0..1. */
static inline lane_four lane_four_slerp(lane_four a, lane_four b, float t, int keys)
{
    const lane_four_bits sign = {INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN};
    const lane_four zero = {0.0f, 0.0f, 0.0f, 0.0f}, half = {0.5f, 0.5f, 0.5f, 0.5f};
    lane_four cosine = lane_four_sum(a * b) + lane_four_all(0x1p-126f);
    lane_four_bits turned = (lane_four_bits)cosine & sign;
    lane_four c = lane_four_flip(b, turned), d = c - a;
    lane_four q = lane_four_sum(d * d), along = lane_four_flip(cosine, turned);
    q = keys ? lane_four_all(lane_slerp_stored(q[0], along[0])) : q;
    lane_four v = q / (along + q * lane_four_all(LANE_SLERP_BEND));
    lane_four h = lane_four_slerp_polynomials(v);

    float u = 1.0f - t;
    lane_four late = lane_four_all(t) - half;
    lane_four_bits first = (lane_four_bits)late >> 31, middle = late == zero;
    lane_four way = lane_four_select(first, lane_four_all(-t), lane_four_all(u));
    lane_four shift = (lane_four)((lane_four_bits)way & ~middle);
    lane_four base = lane_four_select(middle, half * (a + c), lane_four_select(first, a, c));

    /* E(u) and E(t) */
    lane_four k = {u, t, 0.0f, 0.0f}, kv = k * k * v, tu = lane_four_all(t * u) + zero;
    lane_four of = tu * (lane_four_all(1.0f) + k);
    lane_four h3 = lane_four_splat(h, 3) + kv * lane_four_all(LANE_SLERP_H4[0]);
    lane_four e =
        (of * v) * (lane_four_splat(h, 0) + kv * (lane_four_splat(h, 1) + kv * (lane_four_splat(h, 2) + kv * h3)));
    return base - (shift * d + (lane_four_splat(e, 0) * a + lane_four_splat(e, 1) * c));
}
#endif

/* Between two keys as they are stored, for single calls; t in 0..1. */
static inline nkw_quat lane_quat_slerp_keys(nkw_quat a, nkw_quat b, float t)
{
#if defined(LANE_FOUR)
    return lane_quat_from_four(lane_four_slerp(lane_four_from_quat(a), lane_four_from_quat(b), t, 1));
#else
    return lane_quat_slerp_between(a, b, t, 1);
#endif
}

/* An angle of a within one turn of b's, as NKW_UNWRAP_YAW and _ALL ask. */
static inline double lane_turned_towards(double a, double b)
{
    return a < b - LANE_PI ? a + LANE_TWO_PI : a > b + LANE_PI ? a - LANE_TWO_PI : a;
}

/* (1 - t) a + t b in binary64: exact ends, one rounding. */
static inline float lane_angle_lerp(float a, float b, float t, int unwrap)
{
    double from = unwrap ? lane_turned_towards(a, b) : (double)a;
    return (float)((1.0 - (double)t) * from + (double)t * (double)b);
}

#endif
