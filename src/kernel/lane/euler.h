/* SPDX-License-Identifier: MIT */
/* Euler angles and rotations. */
#ifndef NAKAWARI_LANE_EULER_H
#define NAKAWARI_LANE_EULER_H

#include "strict.h"

#include <nakawari/euler.h>

#include "f64.h"
#include "quat.h"
#include "scalar.h"

/* The axes i j k of an order, the places of x y z in it, and e = 1 where i j k is x y z, y z x or z x y, else -1. */
typedef struct lane_euler_axes {
    unsigned char i, j, k;
    unsigned char of[3];
    float e;
} lane_euler_axes;

static inline const lane_euler_axes *lane_euler_axes_of(nkw_euler_order order)
{
    static const lane_euler_axes axes[6] = {
        {0, 1, 2, {0, 1, 2}, 1.0f}, {0, 2, 1, {0, 2, 1}, -1.0f}, {1, 0, 2, {1, 0, 2}, -1.0f},
        {1, 2, 0, {2, 0, 1}, 1.0f}, {2, 0, 1, {1, 2, 0}, 1.0f},  {2, 1, 0, {2, 1, 0}, -1.0f},
    };
    unsigned known = (unsigned)order;
    return &axes[known < 12 ? known % 6 : 0];
}

/* Whether an order is i j i; i j k are then the axes of the order six before it. */
static inline int lane_euler_is_proper(nkw_euler_order order)
{
    return (unsigned)order - 6u < 6u;
}

typedef struct lane_sincos32 {
    float s, c;
} lane_sincos32;

/* Sines and cosines of the angles i, j, k of an order, or of their halves. */
typedef struct lane_turns32 {
    lane_sincos32 i, j, k;
} lane_turns32;

/* The three angles together: from this length on the reduction loses digits, and they are computed in binary64. */
#define LANE_FAR32 8192.0f

static inline int lane_angles_are_far(float x, float y, float z)
{
    return !((x * x + y * y) + z * z < LANE_FAR32 * LANE_FAR32);
}

/*
 * sin x and cos x in binary32 for |x| < LANE_FAR32, error 0.6 ULP of numbers from 1/2 on.
 *
 *     x = n pi/2 + r + tail,     r = ((x - n high) - n middle) - n low,     high + middle + low = pi/2
 *
 * n has 13 bits, high 8 and middle 11, so only the last difference is rounded (Cody, Waite, Software Manual for the
 * Elementary Functions, 1980); `tail` and 1 - leading - half are what the roundings of r and leading lost. n odd
 * exchanges sine and cosine; bit 1 of n and of n + 1 are their signs.
 */
static inline lane_sincos32 lane_sincos32_of(float x)
{
    const float *a = LANE_SIN32, *b = LANE_COS32;
    float rounded = x * LANE_TWO_OVER_PI + 0x1.8p23f, n = rounded - 0x1.8p23f;
    float exact = (x - n * LANE_HALF_PI_HIGH) - n * LANE_HALF_PI_MIDDLE, low = n * LANE_HALF_PI_LOW;
    float r = exact - low, tail = (exact - r) - low, z = r * r, half = 0.5f * z, leading = 1.0f - half;
    float sine = r + ((r * z) * (a[0] + z * (a[1] + z * a[2])) + tail);
    float cosine = leading + (((1.0f - leading) - half) + ((z * z) * (b[0] + z * (b[1] + z * b[2])) - r * tail));
    uint32_t quarters = lane_bits(rounded);
    float s = quarters & 1u ? cosine : sine, c = quarters & 1u ? sine : cosine;
    lane_sincos32 t = {lane_float(lane_bits(s) ^ (quarters << 30 & 0x80000000u)),
                       lane_float(lane_bits(c) ^ ((quarters + 1u) << 30 & 0x80000000u))};
    return t;
}

/* The product of the turns i, j, k, given by sine and cosine of half of each: its parts along i, j, k and w. */
static inline nkw_quat lane_quat_from_halves(lane_turns32 t, float e)
{
    lane_sincos32 i = t.i, j = t.j, k = t.k;
    nkw_quat q = {
        (i.s * j.c) * k.c + e * ((i.c * j.s) * k.s),
        (i.c * j.s) * k.c - e * ((i.s * j.c) * k.s),
        (i.c * j.c) * k.s + e * ((i.s * j.s) * k.c),
        (i.c * j.c) * k.c - e * ((i.s * j.s) * k.s),
    };
    return q;
}

/* The matrix of the turns i, j, k, given by sine and cosine of each: rows and columns i, j, k, by columns. */
static inline nkw_mat3 lane_mat3_from_turns(lane_turns32 t, float e)
{
    lane_sincos32 i = t.i, j = t.j, k = t.k;
    float es = e * i.s, ec = e * i.c, ej = e * j.s;
    nkw_mat3 m = {{
        j.c * k.c,
        ec * k.s + (i.s * j.s) * k.c,
        i.s * k.s - (ec * j.s) * k.c,
        -((e * j.c) * k.s),
        i.c * k.c - (es * j.s) * k.s,
        es * k.c + (i.c * j.s) * k.s,
        ej,
        -(es * j.c),
        i.c * j.c,
    }};
    return m;
}

/* Element c of row r of a matrix in the order x y z is element from[3 c + r] of the same in the order i j k. */
static inline nkw_mat3 lane_euler_mat3_in_place(const nkw_mat3 *m, const lane_euler_axes *o)
{
    const float *x = m->m + 3 * o->of[0], *y = m->m + 3 * o->of[1], *z = m->m + 3 * o->of[2];
    size_t a = o->of[0], b = o->of[1], c = o->of[2];
    nkw_mat3 r = {{x[a], x[b], x[c], y[a], y[b], y[c], z[a], z[b], z[c]}};
    return r;
}

/* The same product in binary64, of half angles of any size. */
static inline lane_f64_quat lane_f64_quat_from_half_angles(double hi, double hj, double hk, double e)
{
    lane_sincos i = lane_sincos64_any(hi), j = lane_sincos64_any(hj), k = lane_sincos64_any(hk);
    lane_f64_quat q = {
        (i.s * j.c) * k.c + e * ((i.c * j.s) * k.s),
        (i.c * j.s) * k.c - e * ((i.s * j.c) * k.s),
        (i.c * j.c) * k.s + e * ((i.s * j.s) * k.c),
        (i.c * j.c) * k.c - e * ((i.s * j.s) * k.s),
    };
    return q;
}

/* The product of turns about i, j and i in binary64, of half angles of any size: see nkw_quat_from_euler. */
static inline lane_f64_quat lane_f64_quat_from_proper(double hi, double hj, double hk, double e)
{
    lane_sincos sum = lane_sincos64_any(hi + hk), difference = lane_sincos64_any(hi - hk), j = lane_sincos64_any(hj);
    lane_f64_quat q = {j.c * sum.s, j.s * difference.c, e * (j.s * difference.s), j.c * sum.c};
    return q;
}

/* Values in the order i j k to the order x y z. */
static inline lane_f64_vec3 lane_euler_in_place(double i, double j, double k, const lane_euler_axes *o)
{
    const double v[3] = {i, j, k};
    lane_f64_vec3 r = {v[o->of[0]], v[o->of[1]], v[o->of[2]]};
    return r;
}

/* angle - 2 pi, angle or angle + 2 pi, the one in [-pi, pi]. */
static inline double lane_wrap_once(double angle)
{
    double turn = lane_copysign64(LANE_TWO_PI, angle);
    return angle - lane_where64(lane_abs64(angle) > LANE_PI, turn);
}

/* angle moved by whole turns to within half a turn of reference; half a turn itself stays. */
static inline float lane_unwrap(float angle, float reference)
{
    double off = (double)angle - (double)reference;
    /* Beyond 2^51 turns a float holds no fraction of one; the rounding then returns off, rounded. */
    double turns = (off * (0.5 * LANE_INVERSE_PI) + LANE_ROUND) - LANE_ROUND;
    double moved = (double)angle - turns * LANE_TWO_PI;
    int within = off <= LANE_PI && off >= -LANE_PI;
    return within ? angle : (float)moved;
}

/* Of q and -q the one whose first component of w, x, y, z that is not 0 is positive. */
static inline lane_f64_quat lane_f64_quat_positive(lane_f64_quat q)
{
    double first = q.w != 0.0 ? q.w : q.x != 0.0 ? q.x : q.y != 0.0 ? q.y : q.z;
    return lane_f64_quat_scale(q, lane_copysign64(1.0, first));
}

/* Returns a, or a plus or minus a turn, whichever is within half a turn of b (NKW_UNWRAP_YAW, NKW_UNWRAP_ALL). */
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
