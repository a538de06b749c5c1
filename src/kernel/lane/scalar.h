/* SPDX-License-Identifier: MIT */
/*
 * Every formula once: binary64 inside, one rounding to float at the end.
 *
 * <nakawari/scalar.h> states the result, the degenerate cases and the measured error of each function.
 * Each function of an angle exists twice: near, for |x| < LANE_NEAR, and far, for every float, four times slower. For
 * |x| < LANE_NEAR the near one defines the result.
 */
#ifndef NAKAWARI_LANE_SCALAR_H
#define NAKAWARI_LANE_SCALAR_H

#include "strict.h"

#include "f64.h"

static inline uint32_t lane_bits(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline float lane_float(uint32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* lane_divisor64 of a float. */
static inline float lane_divisor(float x)
{
    const uint32_t bits = lane_bits(x), is_none = (uint32_t)(bits << 1 == 0);
    return lane_float(bits | ((0u - is_none) & 0x3F800000u));
}

static inline float lane_abs(float x)
{
    return lane_float(lane_bits(x) & 0x7FFFFFFFu);
}

static inline int lane_is_finite(float x)
{
    return (lane_bits(x) & 0x7F800000u) != 0x7F800000u;
}

/* Returns whether validation accepts a quaternion of this length as a rotation. */
static inline int lane_is_unit_length(float length)
{
    return length >= 0.99f && length <= 1.01f;
}

static inline uint32_t lane_sign_bit(float x)
{
    return lane_bits(x) & 0x80000000u;
}

/* magnitude, not negative, with the sign bit of sign. */
static inline float lane_copysign(float magnitude, float sign)
{
    return lane_float(lane_bits(magnitude) | lane_sign_bit(sign));
}

/* Computes nkw_lerp for t other than 0 and 1 from the end nearer to t: a with x = t, or b with x = t - 1. */
static inline float lane_lerp_from(float nearer, float x, float a, float b)
{
    return nearer + x * (b - a);
}

/* sine and cosine */

static inline int lane_angle_is_far(float x)
{
    return !(lane_abs(x) < (float)LANE_NEAR);
}

static inline float lane_sin(float x)
{
    return (float)lane_sin64((double)x);
}

static inline float lane_sin_far(float x)
{
    return (float)lane_sin64_far((double)x);
}

static inline float lane_sin_any(float x)
{
    return lane_angle_is_far(x) ? lane_sin_far(x) : lane_sin(x);
}

static inline float lane_cos(float x)
{
    return (float)lane_cos64((double)x);
}

static inline float lane_cos_far(float x)
{
    return (float)lane_cos64_far((double)x);
}

static inline float lane_cos_any(float x)
{
    return lane_angle_is_far(x) ? lane_cos_far(x) : lane_cos(x);
}

static inline float lane_tan(float x)
{
    lane_sincos a = lane_sincos64((double)x);
    return (float)(a.s / a.c);
}

static inline float lane_tan_far(float x)
{
    lane_sincos a = lane_sincos64_far((double)x);
    return (float)(a.s / a.c);
}

static inline float lane_tan_any(float x)
{
    return lane_angle_is_far(x) ? lane_tan_far(x) : lane_tan(x);
}

/* arcs */

/*
 * asin of |x|, from the side of 0 or from the side of 1:
 *
 *     |x| <= 1/2:  angle = asin |x|
 *     |x| > 1/2:   angle = asin sqrt((1 - |x|)/2),   asin |x| = pi/2 - 2 angle
 */
typedef struct lane_arc {
    double angle;
    double steep; /* 1 above 1/2, else 0 */
} lane_arc;

static inline lane_arc lane_arc_of(float x)
{
    float magnitude = lane_abs(x);
    float a = magnitude > 1.0f ? 1.0f : magnitude;
    double half = (double)(0.5f - 0.5f * a); /* exact for a > 1/2 */
    double square = a > 0.5f ? half : (double)a * (double)a;
    double s = a > 0.5f ? lane_sqrt64_near(half) : (double)a;
    lane_arc arc;
    arc.angle = s * (1.0 + square * lane_poly10(LANE_ASIN, square, square * square));
    arc.steep = a > 0.5f ? 1.0 : 0.0;
    return arc;
}

static inline float lane_asin(float x)
{
    lane_arc arc = lane_arc_of(x);
    double angle = arc.steep > 0.0 ? LANE_HALF_PI - 2.0 * arc.angle : arc.angle;
    return lane_copysign((float)angle, x);
}

static inline float lane_acos(float x)
{
    lane_arc arc = lane_arc_of(x);
    double angle = arc.steep > 0.0 ? 2.0 * arc.angle : LANE_HALF_PI - arc.angle;
    return (float)(x < 0.0f ? LANE_PI - angle : angle);
}

static inline float lane_atan2(float y, float x)
{
    return (float)lane_atan2_64((double)y, (double)x);
}

static inline float lane_atan(float x)
{
    return (float)lane_atan2_64((double)x, 1.0);
}

/* exponentials and logarithms */

/* 2^x for |x| <= 1000, relative error 2^-45.8: x = n + f, 2^f by polynomial, 2^n by its exponent bits. */
static inline double lane_exp2_64(double x)
{
    double rounded = x + LANE_ROUND;
    double f = x - (rounded - LANE_ROUND);
    double power = lane_double((lane_bits64(rounded) + 1023) << 52);
    return lane_poly10(LANE_EXP2, f, f * f) * power;
}

static inline double lane_limit64(double x, double low, double high)
{
    double raised = x < low ? low : x;
    return raised > high ? high : raised;
}

/* The limits lie beyond the last arguments that give 0 and a finite float, so the rounding decides. */
static inline float lane_exp(float x)
{
    return (float)lane_exp2_64(lane_limit64((double)x, -104.0, 89.0) * LANE_LOG2_E);
}

/* e^-x for x >= 0. */
static inline double lane_decay64(double x)
{
    return lane_exp2_64((x < 690.0 ? -x : x == x ? -690.0 : x) * LANE_LOG2_E);
}

/* (1 - e^-x) / x for x >= 0; below 1/8 by its series, to 2^-45. */
static inline double lane_decay_mean64(double x)
{
    double tail = 1.0 - x / 6.0 * (1.0 - x / 7.0 * (1.0 - x / 8.0 * (1.0 - x / 9.0 * (1.0 - x / 10.0))));
    double series = 1.0 - x / 2.0 * (1.0 - x / 3.0 * (1.0 - x / 4.0 * (1.0 - x / 5.0 * tail)));
    return x < 0.125 ? series : (1.0 - lane_decay64(x)) / x;
}

/*
 * x = 2^exponent m,  sqrt(1/2) <= m < sqrt 2,  s = (m - 1)/(m + 1),     ln x = exponent ln 2 + 2 atanh s
 *
 * s is 3 - 2 sqrt 2 at most; atanh s has a relative error of 2^-51.5.
 */
typedef struct lane_logarithm {
    double exponent;
    double atanh_s;
} lane_logarithm;

/* For positive normal finite x; of at most 24 bits, for then m - 1 and m + 1 are exact. */
static inline lane_logarithm lane_logarithm_of(double x)
{
    const uint64_t root_half = UINT64_C(0x3FE6A09E667F3BCD);
    const uint64_t one = UINT64_C(0x3FF0000000000000);
    uint64_t bits = lane_bits64(x);
    uint64_t biased = (bits - root_half + one) >> 52;
    double m = lane_double(bits - (biased << 52) + one);
    double s = (m - 1.0) / (m + 1.0);
    double z = s * s;
    lane_logarithm l;
    l.exponent = lane_double(biased | UINT64_C(0x4330000000000000)) - (0x1p52 + 1023.0);
    l.atanh_s = s * (1.0 + z * lane_poly6(LANE_ATANH, z, z * z));
    return l;
}

/* ln x; +inf for +inf, -inf for zeros, NaN for negative numbers and NaN. */
static inline float lane_log(float x)
{
    lane_logarithm l = lane_logarithm_of((double)x);
    float value = (float)(l.exponent * LANE_LN_2 + 2.0 * l.atanh_s);
    float finite = x < INFINITY ? value : x;
    return x > 0.0f ? finite : (x == 0.0f ? -INFINITY : NAN);
}

/* log2 x; the same results for x that is not positive and finite. */
static inline double lane_log2_64(double x)
{
    lane_logarithm l = lane_logarithm_of(x);
    double value = l.exponent + l.atanh_s * LANE_TWO_LOG2_E;
    double finite = x < (double)INFINITY ? value : x;
    return x > 0.0 ? finite : (x == 0.0 ? -(double)INFINITY : (double)NAN);
}

/* |y| less the nearest whole number: 0 where y is whole or infinite, 1/2 or -1/2 for half an odd number. */
static inline float lane_excess(float y)
{
    float magnitude = lane_abs(y);
    float rounded = (magnitude + 0x1p23f) - 0x1p23f;
    return magnitude < 0x1p23f ? magnitude - rounded : 0.0f;
}

/*
 * x^y = 2^(y log2 |x|) with the sign of x for odd y, then what C99 F.9.4.4 fixes: NaN for finite x < 0 with a y that is
 * not whole; 1 for y = 0, for x = 1 and for x = -1 with an infinite y. |y log2 |x|| <= 150 carries a relative error of
 * 2^-51, so the power one of 2^-44.
 */
static inline float lane_pow(float x, float y)
{
    double exponent = lane_log2_64(lane_abs64((double)x)), product = (double)y * (y == 0.0f ? 0.0 : exponent);
    float power = (float)lane_exp2_64(lane_limit64(product, -160.0, 160.0));
    float mirrored = lane_abs(lane_excess(0.5f * y)) == 0.5f ? lane_copysign(power, x) : power;
    float broken = lane_excess(y) != 0.0f ? NAN : mirrored;
    float finite = x > -INFINITY ? broken : mirrored;
    float value = x < 0.0f ? finite : mirrored;
    float minus_one = lane_abs(y) == INFINITY ? 1.0f : value;
    value = x == -1.0f ? minus_one : value;
    value = x == 1.0f ? 1.0f : value;
    return y == 0.0f ? 1.0f : value;
}

/* periods */

/* The double nearest to the float nearest to pi, and that less a turn, 1e-12 to the safe side. */
#define LANE_PI_FLOAT 0x1.921fb6p1
#define LANE_WRAP_LOW (LANE_PI_FLOAT - LANE_TWO_PI + 0x1p-40)

/* r, within 2 turns of 0, brought into (LANE_WRAP_LOW, LANE_PI_FLOAT]. */
static inline double lane_wrap_turn64(double r)
{
    double lowered = r > LANE_PI_FLOAT ? r - LANE_TWO_PI : r;
    return lowered <= LANE_WRAP_LOW ? lowered + LANE_TWO_PI : lowered;
}

/* x minus whole turns, in turns: in [-1/2, 1/2], to within 2^-10. Half of x in half turns. */
static inline double lane_turn_rest64(double x)
{
    return lane_half_turns(0.5 * x, -0.0).t;
}

static inline double lane_turn_rest64_far(double x)
{
    return lane_half_turns_far(0.5 * x, -0.0).t;
}

static inline float lane_wrap_angle(float x)
{
    float wrapped = (float)lane_wrap_turn64(LANE_TWO_PI * lane_turn_rest64((double)x));
    float inside = (double)x > -LANE_PI_FLOAT ? x : wrapped;
    return (double)x <= LANE_PI_FLOAT ? inside : wrapped;
}

static inline float lane_wrap_angle_far(float x)
{
    return (float)lane_wrap_turn64(LANE_TWO_PI * lane_turn_rest64_far((double)x));
}

static inline float lane_wrap_angle_any(float x)
{
    return lane_angle_is_far(x) ? lane_wrap_angle_far(x) : lane_wrap_angle(x);
}

static inline float lane_angle_difference(float from, float to)
{
    double difference = lane_turn_rest64((double)to) - lane_turn_rest64((double)from);
    return (float)lane_wrap_turn64(LANE_TWO_PI * difference);
}

static inline float lane_angle_difference_far(float from, float to)
{
    double difference = lane_turn_rest64_far((double)to) - lane_turn_rest64_far((double)from);
    return (float)lane_wrap_turn64(LANE_TWO_PI * difference);
}

/* Where lane_wrap is not exact: quotients from 2^28. False where the result is NaN anyway. */
static inline int lane_wrap_is_far(float x, float period)
{
    double magnitude = lane_abs64((double)x);
    return (magnitude >= 0x1p28 * (double)period) & (magnitude < (double)INFINITY) & (period > 0.0f);
}

/* |x| - n period, exact, n the nearest whole number to the quotient, made positive by one period. */
static inline double lane_remainder(double magnitude, double period)
{
    double n = (magnitude / period + LANE_ROUND) - LANE_ROUND;
    double remainder = magnitude - n * period;
    return remainder < 0.0 ? remainder + period : remainder;
}

/*
 * The same for quotients from 2^28, in integers: with |x| = a 2^i, period = b 2^j, a and b < 2^24,
 *
 *     |x| mod period = 2^j (a 2^(i - j) mod b),     2^(i - j) mod b by squaring, i - j <= 253
 */
static inline double lane_remainder_far(float magnitude, float period)
{
    uint32_t x = lane_bits(magnitude) >> 23, p = lane_bits(period) >> 23;
    uint64_t a = (lane_bits(magnitude) & 0x7FFFFFu) | (x > 0 ? 0x800000u : 0u);
    uint64_t b = (lane_bits(period) & 0x7FFFFFu) | (p > 0 ? 0x800000u : 0u);
    uint32_t shift = (x > 0 ? x : 1) - (p > 0 ? p : 1);
    uint64_t square = 2 % b;
    uint64_t remainder = a % b;
    for (int i = 0; i < 8; i++) {
        remainder = (shift >> i) & 1u ? remainder * square % b : remainder;
        square = square * square % b;
    }
    return (double)remainder * ((double)period / (double)b);
}

/* The remainder of x from that of |x|: mirrored for negative x, rounded, kept below the period. */
static inline float lane_wrap_rest(double remainder, float x, float period)
{
    double mirrored = x < 0.0f ? (remainder > 0.0 ? (double)period - remainder : remainder) : remainder;
    float rounded = (float)mirrored;
    float below = lane_float(lane_bits(period) - 1u);
    float wrapped = rounded < period ? rounded : below;
    int valid = (lane_abs64((double)x) < (double)INFINITY) & (period > 0.0f) & (period < INFINITY);
    return valid ? wrapped : NAN;
}

static inline float lane_wrap(float x, float period)
{
    return lane_wrap_rest(lane_remainder(lane_abs64((double)x), (double)period), x, period);
}

static inline float lane_wrap_far(float x, float period)
{
    return lane_wrap_rest(lane_remainder_far(lane_abs(x), period), x, period);
}

static inline float lane_flip(float x, uint32_t sign_bit)
{
    return lane_float(lane_bits(x) ^ sign_bit);
}

/* x where mask is all ones, y where it is 0. */
static inline float lane_select(uint32_t mask, float x, float y)
{
    return lane_float(lane_bits(y) ^ ((lane_bits(x) ^ lane_bits(y)) & mask));
}

#endif
