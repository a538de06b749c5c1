/* SPDX-License-Identifier: MIT */
/*
 * Binary64 inside, binary32 outside: square root, sine, cosine and arc tangent before their last rounding.
 *
 * Only + - * / and the bits of a number: no libm, so nothing is imported and every target computes the same
 * result. Relative errors stand with each function; 2^-44 adds 2^-20 ULP to a later rounding to float.
 */
#ifndef NAKAWARI_LANE_F64_H
#define NAKAWARI_LANE_F64_H

#include "strict.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "data/scalar.h"

/* x + LANE_ROUND holds rint(x) in its low bits for |x| < 2^51; minus LANE_ROUND it is rint(x). */
#define LANE_ROUND 0x1.8p52
#define LANE_SIGN  UINT64_C(0x8000000000000000)
/* Below this many radians lane_half_turns holds, from here on only lane_half_turns_far. */
#define LANE_NEAR 0x1p20

static inline uint64_t lane_bits64(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline double lane_double(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static inline double lane_abs64(double x)
{
    return lane_double(lane_bits64(x) & ~LANE_SIGN);
}

/*
 * Returns x, or 1 or -1 where x is 0: a divisor for quotients that are not used where x is 0, so that no division by
 * zero is raised. It combines bits of x only: if a comparison selected the divisor, compilers would make two quotients,
 * and could compute both.
 */
static inline double lane_divisor64(double x)
{
    const uint64_t bits = lane_bits64(x), some = bits << 1, is_some = (some | (UINT64_C(0) - some)) >> 63;
    return lane_double(bits | ((is_some - 1) & UINT64_C(0x3FF0000000000000)));
}

/* magnitude with the sign bit of sign; magnitude must not be negative. */
static inline double lane_copysign64(double magnitude, double sign)
{
    return lane_double(lane_bits64(magnitude) | (lane_bits64(sign) & LANE_SIGN));
}

/* a if `holds` is not 0, otherwise 0: by a mask, as nkw_select does. */
static inline double lane_where64(int holds, double a)
{
    return lane_double(lane_bits64(a) & (UINT64_C(0) - (uint64_t)(holds != 0)));
}

/* floor(x) for |x| < 2^51; x unchanged otherwise. */
static inline double lane_floor64(double x)
{
    double rounded = (x + LANE_ROUND) - LANE_ROUND;
    double whole = x < 0x1p51 && x > -0x1p51 ? rounded : x;
    return whole > x ? whole - 1.0 : whole;
}

/*
 * Polynomials c[0] + c[1] z + ..., zz = z^2: pairs are summed first, then Horner in zz.
 * Half the latency of Horner for one product more.
 */
static inline double lane_poly2(const double *c, double z)
{
    return c[0] + c[1] * z;
}

static inline double lane_poly6(const double *c, double z, double zz)
{
    return lane_poly2(c, z) + zz * (lane_poly2(c + 2, z) + zz * lane_poly2(c + 4, z));
}

static inline double lane_poly8(const double *c, double z, double zz)
{
    return lane_poly2(c, z) + zz * lane_poly6(c + 2, z, zz);
}

static inline double lane_poly10(const double *c, double z, double zz)
{
    return lane_poly2(c, z) + zz * lane_poly8(c + 2, z, zz);
}

/* The roots of m in 2^-100 .. 2^100 as floats have them: s within 2^-23.4 of sqrt(m), y within 2^-22.6 of 1/sqrt(m). */
typedef struct lane_roots {
    double s, y; /* for m = 0: 0 and 2^126 */
} lane_roots;

static inline lane_roots lane_roots_of(double m)
{
    float s = sqrtf((float)m);
    lane_roots r = {(double)s, (double)(1.0f / (s + FLT_MIN))};
    return r;
}

/* x = m 4^k, m in [1/2, 2). */
static inline double lane_root_mantissa(double x)
{
    return lane_double((lane_bits64(x) & UINT64_C(0x001FFFFFFFFFFFFF)) | UINT64_C(0x3FE0000000000000));
}

/* Bits 53 to 61 of x: the exponent field of 2^k, except for a constant. */
static inline uint64_t lane_root_exponent(double x)
{
    return (lane_bits64(x) & UINT64_C(0x7FE0000000000000)) >> 1;
}

/*
 * 1/sqrt(m) for 2^-100 <= m <= 2^100, relative error 2^-52; exact for 4^k, some finite number for 0.
 *
 *     1/sqrt(m) = y (1 + h + 3/2 h^2),    h = (1 - m y^2)/2        error d -> 5/2 d^3
 *
 * The step adds to y, so only its small correction carries a rounding error; y^2 is exact.
 */
static inline double lane_rsqrt64_near(double m)
{
    double y = lane_roots_of(m).y;
    double h = 0.5 - (0.5 * m) * (y * y);
    return y + (y * h) * (1.0 + 1.5 * h);
}

/* The same for x >= 2^-1000. NaN for infinities and NaN. */
static inline double lane_rsqrt64(double x)
{
    double scale = lane_double(UINT64_C(0x5FE0000000000000) - lane_root_exponent(x)); /* 2^-k */
    scale = x < (double)INFINITY ? scale : (double)NAN;
    return lane_rsqrt64_near(lane_root_mantissa(x)) * scale;
}

/*
 * sqrt(m) for m = 0 and 2^-100 <= m <= 2^100, relative error 2^-47; the root of a square of 24 bits is exact.
 *
 *     sqrt(m) = s + (m - s^2) y/2            error d -> 5/2 d^2
 */
static inline double lane_sqrt64_near(double m)
{
    lane_roots r = lane_roots_of(m);
    return r.s + (m - r.s * r.s) * (0.5 * r.y);
}

/* The same for x >= 2^-1000. Zeros, +inf and NaN are returned unchanged. Not for negative numbers. */
static inline double lane_sqrt64(double x)
{
    double scale = lane_double(UINT64_C(0x2000000000000000) + lane_root_exponent(x)); /* 2^k */
    scale = x > 0.0 ? scale : x;
    scale = x < (double)INFINITY ? scale : x;
    return lane_sqrt64_near(lane_root_mantissa(x)) * scale;
}

/* An angle as n + t half turns: |t| <= 1/2 + 2^-10. */
typedef struct lane_turns {
    double t;
    uint64_t n; /* only bit 0, n odd, is meant */
} lane_turns;

/*
 * offset + x/pi = n + t for |x| < LANE_NEAR and x of at most 24 bits, offset 1/2 or none: -0, for x + -0 is x.
 *
 *     t = ((offset + x high) - n) + x low,     high + low = 1/pi
 *
 * high has 29 bits, so x high is exact, and so is its difference from n. 1/2 + x high, for x <= 0, is exact below
 * 1/4 and else rounded within 2^-52 t (Cody, Waite, Software Manual for the Elementary Functions, 1980).
 * |error of t| < 2^-63 + 2^-51 |t|. high and low are positive, so -0 returns -0. An x of more bits counts as one
 * within 2^-53 of itself. Larger finite x give some number, inf and NaN give NaN.
 */
static inline lane_turns lane_half_turns(double x, double offset)
{
    double high = offset + x * LANE_INVERSE_PI_HIGH;
    double rounded = high + LANE_ROUND;
    lane_turns a;
    a.t = (high - (rounded - LANE_ROUND)) + x * LANE_INVERSE_PI_LOW;
    a.n = lane_bits64(rounded);
    return a;
}

/*
 * The same for every x of at most 24 bits with |x| < 2^128.
 *
 *     x/pi = x c0 + x c1 + x c2 (modulo 4),     t = (((offset + x c0) - n) + x c1) + x c2
 *
 * x c0 and x c1 are exact, the row of c leaves out what makes multiples of 4 (Payne, Hanek, Radian
 * Reduction for Trigonometric Functions, SIGNUM Newsletter, 1983). |error of t| < 2^-77 + 2^-51 |t|.
 */
static inline lane_turns lane_half_turns_far(double x, double offset)
{
    uint64_t exponent = (lane_bits64(x) & ~LANE_SIGN) >> 52;
    uint64_t row = exponent < 1023 ? 0 : (exponent - 1023) >> 3;
    const double *c = LANE_INVERSE_PI_ROWS[row < 16 ? row : 15];
    double high = offset + x * c[0];
    double middle = x * c[1];
    double rounded = (high + middle) + LANE_ROUND;
    lane_turns a;
    a.t = ((high - (rounded - LANE_ROUND)) + middle) + x * c[2];
    a.n = lane_bits64(rounded);
    return a;
}

/* (-1)^n sin(pi t), relative error 2^-35.2. Zero keeps its sign. */
static inline double lane_sine64(lane_turns a)
{
    double z = a.t * a.t;
    double sine = a.t * lane_poly6(LANE_SIN, z, z * z);
    return lane_double(lane_bits64(sine) ^ (a.n << 63));
}

/*
 * sin x and cos x, relative error 2^-35.2 each, for |x| < LANE_NEAR and x of at most 24 bits: a float or half
 * a float. cos x is the sine of pi/2 - |x|: exactly even. inf and NaN give NaN.
 */
static inline double lane_sin64(double x)
{
    return lane_sine64(lane_half_turns(x, -0.0));
}

static inline double lane_cos64(double x)
{
    return lane_sine64(lane_half_turns(-lane_abs64(x), 0.5));
}

typedef struct lane_sincos {
    double s, c;
} lane_sincos;

static inline lane_sincos lane_sincos64(double x)
{
    lane_sincos a = {lane_sin64(x), lane_cos64(x)};
    return a;
}

/* The same for every |x| < 2^128. */
static inline double lane_sin64_far(double x)
{
    return lane_sine64(lane_half_turns_far(x, -0.0));
}

static inline double lane_cos64_far(double x)
{
    return lane_sine64(lane_half_turns_far(-lane_abs64(x), 0.5));
}

static inline lane_sincos lane_sincos64_far(double x)
{
    lane_sincos a = {lane_sin64_far(x), lane_cos64_far(x)};
    return a;
}

/* For single calls. A loop calls lane_sincos64 for all angles, and computes the far ones again. */
static inline lane_sincos lane_sincos64_any(double x)
{
    return lane_abs64(x) < LANE_NEAR ? lane_sincos64(x) : lane_sincos64_far(x);
}

/*
 * The angle of (x, y) in [-pi, pi], relative error 2^-44.8, for |x|, |y| in 2^-1022 .. 2^1022, zero or infinite.
 *
 *     q = low/high,  q <= tan(pi/8);  (low - high)/(low + high) + a turn of pi/4 above
 *     low, high = the smaller and the larger of |x|, |y|
 *
 * then pi/2 - q, pi - q and the sign of y select the octant. Zeros and infinities follow C99 F.9.1.4, except for angles
 * below 2^-800 instead of 0: infinities count as 2^1022, so two of them are equal. 2^-1022 is added to the larger of
 * |x| and |y|, so that two zeros have a quotient. A NaN in either passes through every line.
 */
static inline double lane_atan2_64(double y, double x)
{
    double ax = lane_abs64(x);
    double ay = lane_abs64(y);
    double smaller = ay < ax ? ay : ax;
    double larger = ay < ax ? ax : ay;
    double low = 0x1p1022 < smaller ? 0x1p1022 : smaller;
    larger = 0x1p1022 < larger ? 0x1p1022 : larger;
    double high = larger + 0x1p-1022;
    int steep = low > LANE_TAN_EIGHTH_PI * high;
    double turn = steep ? LANE_QUARTER_PI : 0.0;
    double q = (low - (steep ? high : 0.0)) / (high + (steep ? low : 0.0));
    double z = q * q;
    double angle = turn + q * (1.0 + z * lane_poly8(LANE_ATAN, z, z * z));
    angle = ay > ax ? LANE_HALF_PI - angle : angle;
    angle = lane_copysign64(1.0, x) < 0.0 ? LANE_PI - angle : angle;
    return lane_copysign64(angle, y);
}

#endif
