/* SPDX-License-Identifier: MIT */
/*
 * Two doubles side by side, for single calls that do the same more than once: angles, minors of a matrix. Each of the
 * two is what wide.h says of one double, with the same bits. Loops over elements take the lanes of wide.h, and so does
 * everything where there is no such type (LANE_TWO is not defined).
 */
#ifndef NAKAWARI_LANE_TWO_H
#define NAKAWARI_LANE_TWO_H

#include "strict.h"

#include "wide.h"

#if defined(__GNUC__) && !defined(__arm__) && !defined(NKW_PLAIN_FOUR)
#define LANE_TWO

typedef double lane_two __attribute__((vector_size(16)));
typedef int64_t lane_two_bits __attribute__((vector_size(16)));

#if defined(__clang__)
#define LANE_TWO_MIX(a, b, i, j) __builtin_shufflevector(a, b, i, j)
#else
#define LANE_TWO_MIX(a, b, i, j) __builtin_shuffle(a, b, (lane_two_bits){i, j})
#endif

static inline lane_two lane_two_of(double a, double b)
{
    lane_two r = {a, b};
    return r;
}

static inline lane_two lane_two_swap(lane_two a)
{
    return LANE_TWO_MIX(a, a, 1, 0);
}

static inline lane_two lane_two_all(double a)
{
    return lane_two_of(a, a);
}

/* a where the mask is set, else 0. */
static inline lane_two lane_two_where(lane_two_bits mask, lane_two a)
{
    return (lane_two)(mask & (lane_two_bits)a);
}

static inline lane_two_bits lane_two_sign(lane_two a)
{
    const lane_two_bits sign = {INT64_MIN, INT64_MIN};
    return (lane_two_bits)a & sign;
}

static inline lane_two lane_two_abs(lane_two a)
{
    return (lane_two)((lane_two_bits)a ^ lane_two_sign(a));
}

static inline lane_two lane_two_poly2(const double *c, lane_two z)
{
    return c[0] + c[1] * z;
}

static inline lane_two lane_two_poly4(const double *c, lane_two z, lane_two zz)
{
    return lane_two_poly2(c, z) + zz * lane_two_poly2(c + 2, z);
}

static inline lane_two lane_two_poly6(const double *c, lane_two z, lane_two zz)
{
    return lane_two_poly2(c, z) + zz * lane_two_poly4(c + 2, z, zz);
}

static inline lane_two lane_two_poly8(const double *c, lane_two z, lane_two zz)
{
    return lane_two_poly2(c, z) + zz * lane_two_poly6(c + 2, z, zz);
}

/* lane_sine64 of lane_half_turns. */
static inline lane_two lane_two_sine64(lane_two x, lane_two offset)
{
    lane_two high = offset + x * LANE_INVERSE_PI_HIGH;
    lane_two rounded = high + LANE_ROUND;
    lane_two t = (high - (rounded - LANE_ROUND)) + x * LANE_INVERSE_PI_LOW;
    lane_two z = t * t;
    lane_two sine = t * lane_two_poly6(LANE_SIN, z, z * z);
    return (lane_two)((lane_two_bits)sine ^ ((lane_two_bits)rounded << 63));
}

static inline lane_sincos lane_sincos64_near(double x)
{
    const lane_two_bits negative = {0, INT64_MIN};
    const lane_two offset = {-0.0, 0.5};
    lane_two a = lane_two_sine64((lane_two)((lane_two_bits)lane_two_all(x) | negative), offset);
    lane_sincos r = {a[0], a[1]};
    return r;
}

/* lane_atan2_64 of finite numbers; NaN for two zeros. */
static inline lane_two lane_two_atan2_64(lane_two y, lane_two x)
{
    const lane_two one = {1.0, 1.0}, half_pi = {LANE_HALF_PI, LANE_HALF_PI}, pi = {LANE_PI, LANE_PI};
    const lane_two quarter_pi = {LANE_QUARTER_PI, LANE_QUARTER_PI};
    lane_two ax = lane_two_abs(x), ay = lane_two_abs(y);
    lane_two_bits above = ay > ax;
    lane_two_bits swap = ((lane_two_bits)ax ^ (lane_two_bits)ay) & above;
    lane_two low = (lane_two)((lane_two_bits)ay ^ swap);
    lane_two high = (lane_two)((lane_two_bits)ax ^ swap);
    lane_two_bits steep = low > LANE_TAN_EIGHTH_PI * high;
    lane_two q = (low - lane_two_where(steep, high)) / (high + lane_two_where(steep, low));
    lane_two z = q * q;
    lane_two angle = lane_two_where(steep, quarter_pi) + q * (1.0 + z * lane_two_poly8(LANE_ATAN, z, z * z));
    lane_two_bits behind = (lane_two)(lane_two_sign(x) | (lane_two_bits)one) < 0.0;
    angle = lane_two_where(above, half_pi) + (lane_two)((lane_two_bits)angle ^ (above << 63));
    angle = lane_two_where(behind, pi) + (lane_two)((lane_two_bits)angle ^ lane_two_sign(x));
    return (lane_two)((lane_two_bits)angle | lane_two_sign(y));
}

#else

static inline lane_sincos lane_sincos64_near(double x)
{
    return lane_sincos64(x);
}

#endif

/* lane_sincos64_any, both at once. */
static inline lane_sincos lane_sincos64_single(double x)
{
    return x < LANE_NEAR && x > -LANE_NEAR ? lane_sincos64_near(x) : lane_sincos64_far(x);
}

#endif
