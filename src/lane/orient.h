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

static inline nkw_quat lane_quat_flip(nkw_quat q, uint32_t sign_bit)
{
    nkw_quat r = {lane_flip(q.x, sign_bit), lane_flip(q.y, sign_bit), lane_flip(q.z, sign_bit), lane_flip(q.w, sign_bit)};
    return r;
}

/* b or -b, whichever lies on a's side. */
static inline nkw_quat lane_quat_turned(nkw_quat a, nkw_quat b)
{
    return lane_quat_flip(b, nkw_quat_dot(a, b) < 0.0f ? 0x80000000u : 0u);
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
    float m = nkw_quat_unit_error(v), n2 = 1.0f - m;
    float n = sqrtf(n2);
    int outright = n2 > 2.0f;
    float g = (outright ? 1.0f : m) / (outright ? n : n + n2);
    uint32_t kept = outright ? 0x80000000u : ~0u;
    nkw_quat part = {lane_kept(kept, v.x), lane_kept(kept, v.y), lane_kept(kept, v.z), lane_kept(kept, v.w)};
    return lane_quat_select(n2 <= 0.0f, nkw_quat_identity(), nkw_quat_add(part, nkw_quat_scale(v, g)));
}

static inline nkw_quat lane_quat_nlerp(nkw_quat a, nkw_quat b, float t)
{
    lane_chord c = lane_quat_chord(a, b, t);
    return lane_quat_select(c.back == 0.0f, c.v, lane_quat_settle(c.v));
}

/*
 * Slerp as the end nearer to t and a small correction to it. b is turned to a's side; theta is their angle, n the nearer
 * end, f the farther, s the way from n to t and r = 1 - s that from f:
 *
 *     sin(k theta)/sin theta = k - E(k)
 *     slerp = n - (bow f - way (f - n)),                 bow = E(s) + E(r),  way = s + E(r)
 *     t = 1/2:  slerp = m - bow m,  m = (a + b)/2        bow = 2 E(1/2)
 *
 * Exchanging a and b and t and 1 - t gives the same bits, also at t = 1/2.
 *
 *     E(k) = k (1 - k^2) v H(v, k^2) = (c v) H,  c = s r (1 + k),    v = q / (|a.b| + q LANE_SLERP_BEND),  q = |b - a|^2
 *
 * v stands for the angle: small ones are told by the chord, large ones by the dot product, and the lengths of a and b
 * cancel. At t = 0 and 1 bow and way are -0, so that the bracket is +0 where n is -0: "n - 0" keeps a -0.
 *
 * H is a polynomial in v, the coefficient of each power one in k^2. Many slerps at one t share these.
 */

/* x where mask is all ones, y where it is 0. */
static inline float lane_blend(uint32_t mask, float x, float y)
{
    return lane_float(lane_bits(y) ^ ((lane_bits(x) ^ lane_bits(y)) & mask));
}

/* a.b. The smallest normal number makes -0 positive and keeps 0 / 0 away. */
static inline float lane_slerp_cosine(nkw_quat a, nkw_quat b)
{
    return nkw_quat_dot(a, b) + 0x1p-126f;
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

/*
 * What slerp needs to know of a and b: v, with the sign bit set where b is turned. `keys`, a constant: they are keys as
 * they are stored; else they are unit.
 */
static inline float lane_slerp_arc(nkw_quat a, nkw_quat b, int keys)
{
    float cosine = lane_slerp_cosine(a, b), along = lane_abs(cosine);
    nkw_quat d = nkw_quat_sub(lane_quat_flip(b, lane_sign_bit(cosine)), a);
    float q = nkw_quat_dot(d, d);
    q = keys ? lane_slerp_stored(q, along) : q;
    return lane_flip(q / (along + q * LANE_SLERP_BEND), lane_sign_bit(cosine));
}

/* What it needs to know of t: s, r, the c of each, and masks: a is nearer, t is 1/2, t is an end. */
typedef struct lane_slerp_pace {
    float s, r, cs, cr;
    uint32_t first, half, end;
} lane_slerp_pace;

/* 0 < t < 1 and not 1/2. */
static inline int lane_t_is_aside(float t)
{
    return t > 0.0f && t < 1.0f && t != 0.5f;
}

static inline lane_slerp_pace lane_slerp_pace_aside(float t)
{
    float u = 1.0f - t, s = t < u ? t : u, r = t < u ? u : t, sr = t * u;
    lane_slerp_pace pace = {s, r, sr * (1.0f + s), sr * (1.0f + r), 0u - (lane_bits(t - 0.5f) >> 31), 0u, 0u};
    return pace;
}

/* For t in 0..1; a -0 counts as 0. */
static inline lane_slerp_pace lane_slerp_pace_at(float t)
{
    lane_slerp_pace pace = lane_slerp_pace_aside(t + 0.0f);
    pace.half = 0u - (uint32_t)(t == 0.5f);
    pace.end = 0u - (uint32_t)(pace.s == 0.0f);
    return pace;
}

/* The pace aside where it is known at compile time which end is nearer, so that nothing is left to be selected. */
static inline lane_slerp_pace lane_slerp_near(lane_slerp_pace pace, int first)
{
    pace.first = first ? ~0u : 0u;
    pace.half = pace.end = 0u;
    return pace;
}

/* The coefficient of v^i: a polynomial in z = k^2, zz = z^2. */
static inline float lane_slerp_power1(const float h[][LANE_SLERP_POWERS], int i, float z)
{
    return h[0][i] + z * h[1][i];
}

static inline float lane_slerp_power2(const float h[][LANE_SLERP_POWERS], int i, float z, float zz)
{
    return (h[0][i] + z * h[1][i]) + zz * h[2][i];
}

static inline float lane_slerp_power3(const float h[][LANE_SLERP_POWERS], int i, float z, float zz)
{
    return (h[0][i] + z * h[1][i]) + zz * (h[2][i] + z * h[3][i]);
}

/* H by its coefficients: pairs are summed first, then Horner in v^2, for half the latency of Horner in v. */
static inline float lane_slerp_sum(float h0, float h1, float h2, float h3, float h4, float h5, float v)
{
    float vv = v * v;
    return (h0 + v * h1) + vv * ((h2 + v * h3) + vv * (h4 + v * h5));
}

/* E(r) and E(s). Terms that the tables have not (their degrees stand in docs/generate/slerp.c) are left out. */
static inline float lane_slerp_near_excess(const lane_slerp_pace *pace, float v)
{
    const float z = pace->r * pace->r, zz = z * z, (*h)[LANE_SLERP_POWERS] = LANE_SLERP_NEAR;
    return (pace->cr * v) * lane_slerp_sum(h[0][0], lane_slerp_power1(h, 1, z), lane_slerp_power2(h, 2, z, zz),
                                           lane_slerp_power3(h, 3, z, zz), h[0][4], lane_slerp_power2(h, 5, z, zz), v);
}

static inline float lane_slerp_far_excess(const lane_slerp_pace *pace, float v)
{
    const float z = pace->s * pace->s, zz = z * z, (*h)[LANE_SLERP_POWERS] = LANE_SLERP_FAR;
    return (pace->cs * v) * lane_slerp_sum(h[0][0], lane_slerp_power1(h, 1, z), lane_slerp_power2(h, 2, z, zz),
                                           lane_slerp_power1(h, 3, z), h[0][4], lane_slerp_power1(h, 5, z), v);
}

/* The same for many v at one t: the coefficients, worked out once. */
typedef struct lane_slerp_powers {
    float near[LANE_SLERP_POWERS], far[LANE_SLERP_POWERS];
} lane_slerp_powers;

static inline lane_slerp_powers lane_slerp_powers_at(const lane_slerp_pace *pace)
{
    const float zr = pace->r * pace->r, zs = pace->s * pace->s;
    lane_slerp_powers p;
    for (int i = 0; i < LANE_SLERP_POWERS; i++) {
        p.near[i] = lane_slerp_power3(LANE_SLERP_NEAR, i, zr, zr * zr);
        p.far[i] = lane_slerp_power3(LANE_SLERP_FAR, i, zs, zs * zs);
    }
    return p;
}

static inline float lane_slerp_excess_by(const float *h, float c, float v)
{
    return (c * v) * lane_slerp_sum(h[0], h[1], h[2], h[3], h[4], h[5], v);
}

typedef struct lane_slerp_weights {
    float bow, way;
} lane_slerp_weights;

static inline lane_slerp_weights lane_slerp_weights_of(const lane_slerp_pace *pace, float er, float es)
{
    lane_slerp_weights w = {lane_blend(pace->half, es, er) + es, lane_blend(pace->end, er, pace->s + er)};
    return w;
}

/* One component. */
static inline float lane_slerp_component(float a, float b, const lane_slerp_pace *pace, lane_slerp_weights w)
{
    float middle = 0.5f * (a + b);
    float n = lane_blend(pace->half, middle, lane_blend(pace->first, a, b));
    float f = lane_blend(pace->half, middle, lane_blend(pace->first, b, a));
    return n - (w.bow * f - w.way * (f - n));
}

/* The slerp by its E(r) and E(s). */
static inline nkw_quat lane_quat_slerp_by(nkw_quat a, nkw_quat b, float arc, const lane_slerp_pace *pace, float er,
                                          float es)
{
    lane_slerp_weights w = lane_slerp_weights_of(pace, er, es);
    nkw_quat c = lane_quat_flip(b, lane_sign_bit(arc));
    nkw_quat r = {
        lane_slerp_component(a.x, c.x, pace, w),
        lane_slerp_component(a.y, c.y, pace, w),
        lane_slerp_component(a.z, c.z, pace, w),
        lane_slerp_component(a.w, c.w, pace, w),
    };
    return r;
}

static inline nkw_quat lane_quat_slerp_on(nkw_quat a, nkw_quat b, float arc, const lane_slerp_pace *pace)
{
    float v = lane_abs(arc);
    return lane_quat_slerp_by(a, b, arc, pace, lane_slerp_near_excess(pace, v), lane_slerp_far_excess(pace, v));
}

/* The same bits, at a pace that many have. */
static inline nkw_quat lane_quat_slerp_along(nkw_quat a, nkw_quat b, float arc, const lane_slerp_pace *pace,
                                             const lane_slerp_powers *powers)
{
    float v = lane_abs(arc);
    return lane_quat_slerp_by(a, b, arc, pace, lane_slerp_excess_by(powers->near, pace->cr, v),
                              lane_slerp_excess_by(powers->far, pace->cs, v));
}

static inline nkw_quat lane_quat_slerp_between(nkw_quat a, nkw_quat b, float t, int keys)
{
    lane_slerp_pace pace = lane_slerp_pace_at(t);
    return lane_quat_slerp_on(a, b, lane_slerp_arc(a, b, keys), &pace);
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

/* Row j of v^i and v^(i + 1), i even, in H of the nearer and of the farther end: near, far, near, far. */
static inline lane_four lane_four_slerp_row(int j, int i)
{
    lane_four h = {LANE_SLERP_NEAR[j][i], LANE_SLERP_FAR[j][i], LANE_SLERP_NEAR[j][i + 1], LANE_SLERP_FAR[j][i + 1]};
    return h;
}

/* Their coefficients at z. Rows 2 and 3 are 0 in columns 0 and 1, row 3 in columns 4 and 5. */
static inline lane_four lane_four_slerp_powers(int i, lane_four z, lane_four zz)
{
    lane_four low = lane_four_slerp_row(0, i) + z * lane_four_slerp_row(1, i);
    lane_four high = lane_four_slerp_row(2, i);
    high = i == 2 ? high + z * lane_four_slerp_row(3, i) : high;
    return i == 0 ? low : low + zz * high;
}

/* For t in 0..1. `aside`, a constant, says that t is, and leaves out what is seldom. */
static inline lane_four lane_four_slerp(lane_four a, lane_four b, float t, int aside, int keys)
{
    const lane_four_bits sign = {INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN};
    const lane_four zero = {0.0f, 0.0f, 0.0f, 0.0f}, half = {0.5f, 0.5f, 0.5f, 0.5f}, one = half + half;
    lane_four cosine = lane_four_sum(a * b) + lane_four_all(0x1p-126f);
    lane_four c = lane_four_flip(b, (lane_four_bits)cosine & sign), d = c - a;
    lane_four q = lane_four_sum(d * d), along = (lane_four)((lane_four_bits)cosine & ~sign);
    q = keys ? lane_four_all(lane_slerp_stored(q[0], along[0])) : q;
    lane_four v = q / (along + q * lane_four_all(LANE_SLERP_BEND)), vv = v * v;

    /* Of the nearer and the farther end in turn: E(r) E(s) E(r) E(s). By a mask, for GCC makes a branch of t < u. */
    const lane_four_bits odd = {0, -1, 0, -1};
    t = aside ? t : t + 0.0f;
    lane_four at = lane_four_all(t), to = lane_four_all(1.0f - t);
    lane_four_bits first = at < half;
    lane_four k = lane_four_select(first ^ odd, to, at), z = k * k, zz = z * z, e = v;
    for (int i = 4; i >= 0; i -= 2) {
        lane_four h = lane_four_slerp_powers(i, z, zz);
        lane_four pair = h + v * LANE_FOUR_MIX(h, h, 2, 3, 2, 3);
        e = i == 4 ? pair : pair + vv * e;
    }
    e = (at * to * (one + k) * v) * e;

    lane_four er = lane_four_splat(e, 0), es = lane_four_splat(e, 1), bow = er + es;
    lane_four s = lane_four_splat(k, 1), way = er + s;
    lane_four n = lane_four_select(first, a, c), f = lane_four_select(first, c, a);
    if (!aside) {
        lane_four_bits middle = at == half, end = s == zero;
        lane_four m = half * (a + c);
        bow = lane_four_select(middle, es + es, bow);
        way = lane_four_select(end, er, way);
        n = lane_four_select(middle, m, n);
        f = lane_four_select(middle, m, f);
    }
    return n - (bow * f - way * (f - n));
}
#endif

/* Between two keys as they are stored, for single calls; t in 0..1. */
static inline nkw_quat lane_quat_slerp_keys(nkw_quat a, nkw_quat b, float t)
{
#if defined(LANE_FOUR)
    lane_four from = lane_four_from_quat(a), to = lane_four_from_quat(b);
    return lane_quat_from_four(lane_t_is_aside(t) ? lane_four_slerp(from, to, t, 1, 1)
                                                  : lane_four_slerp(from, to, t, 0, 1));
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
    float inside = (float)((1.0 - (double)t) * from + (double)t * (double)b);
    return t == 0.0f ? (float)from : t == 1.0f ? b : inside;
}

#endif
