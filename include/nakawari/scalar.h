/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Numbers: small arithmetic, angles, periods and elementary functions.
 *
 * The elementary functions of the C library differ between systems; those of this header return the same bits on every
 * target. They compute in binary64 and round once to binary32. The result is the float nearest to the exact value,
 * except for a few arguments in a thousand million (sine, cosine, tangent: one in five thousand). C libraries have
 * faster forms of exp, log and pow by tables; in loops each argument would cost a gather, so polynomials are used here.
 *
 * Every function is total: no argument causes undefined behaviour. NaN in any argument returns NaN, unless a function
 * states otherwise or its formula ignores the argument: nkw_lerp(a, NaN, 0) is a.
 *
 * `Error` lines state a bound that no measured error exceeds; brackets contain the worst error measured and its
 * arguments. 1 ULP is the distance of neighbouring floats at the exact result: 0.5 ULP is correct rounding. 1 u is
 * 2^-24 times the stated magnitude. "exact": the exact result is a float and is returned. "exhaustive": measured over
 * every float, for odd and even functions over every float from 0 on; other figures come from structured random
 * arguments.
 *
 * Example  float a, b, t, x, y, s, c;
 *
 *     x = nkw_abs(a);                         |a|
 *     x = nkw_min(a, b);                      b if a is NaN
 *     x = nkw_max(a, b);
 *     x = nkw_clamp(a, 0.0f, 1.0f);           into a range
 *     x = nkw_lerp(a, b, t);                  from a to b, exact at both ends
 *     t = nkw_inverse_lerp(a, b, x);          where x is between a and b
 *     nkw_equal_within(a, b, 1e-5f);          1 if they differ by at most that
 *     x = nkw_move_towards(x, b, 0.1f);       by a step, never beyond
 *     x = nkw_smoothstep(t);                  0 to 1 with flat ends
 *     x = nkw_degrees_from_radians(a);
 *     x = nkw_radians_from_degrees(90.0f);
 *     x = nkw_sqrt(a);
 *     x = nkw_sin(a);                         radians; the same bits everywhere
 *     x = nkw_cos(a);
 *     nkw_sincos(a, &s, &c);                  both
 *     x = nkw_tan(a);
 *     x = nkw_asin(a);
 *     x = nkw_acos(a);
 *     x = nkw_atan(a);
 *     x = nkw_atan2(y, x);                    the angle of (x, y)
 *     x = nkw_exp(a);
 *     x = nkw_log(a);
 *     x = nkw_pow(a, b);
 *     x = nkw_wrap(a, 2.0f);                  into [0, period)
 *     x = nkw_wrap_angle(a);                  into (-pi, pi]
 *     x = nkw_angle_difference(a, b);         from a to b, the shorter way
 */
#ifndef NAKAWARI_SCALAR_H
#define NAKAWARI_SCALAR_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- small arithmetic, inlined ---- */

/**
 * |x|. Returns 0 for both zeros.
 *
 * Error  exact
 */
NKW_ALGEBRA float nkw_abs(float x);

/**
 * The smaller of two numbers: a < b ? a : b.
 *
 * A comparison with NaN is false, so the result is b if either argument is NaN: nkw_min(NaN, b) is b, nkw_min(a, NaN)
 * is NaN. The result is b also for equal arguments, including zeros of different sign.
 *
 * Error  exact
 */
NKW_ALGEBRA float nkw_min(float a, float b);

/**
 * The larger of two numbers: a > b ? a : b. The result is b for NaN and for equal arguments, as in nkw_min.
 *
 * Error  exact
 */
NKW_ALGEBRA float nkw_max(float a, float b);

/**
 * x clamped to [low, high].
 *
 *     clamp = min(max(x, low), high)
 *
 * low      at most high; a larger low returns high
 * Returns  low for x = NaN; high for low = NaN; NaN for high = NaN
 *
 * Error  exact
 */
NKW_ALGEBRA float nkw_clamp(float x, float low, float high);

/**
 * The number at t on the straight line from a (t = 0) to b (t = 1).
 *
 *     a + t (b - a)            t < 1/2
 *     b - (1 - t)(b - a)       otherwise
 *
 * The formula starts at the end nearer to t, so both ends are exact: lerp(a, b, 0) is a and lerp(a, b, 1) is b, bit for
 * bit. lerp(a, a, t) is a for finite t, except the sign of a zero. (1 - t) a + t b takes fewer operations, but neither
 * keeps equal ends nor is monotonic; so this form stays.
 *
 * a, b     b - a must not overflow; then every t in [0, 1] returns a finite number
 * t        any; outside [0, 1] the line continues; 1 - t is exact in [1/2, 2]
 * Returns  for t in [0, 1] a number between a and b, which does not decrease in t if a <= b
 *
 * Error  2.0 u of max(|a|, |b|), t in [0, 1] (1.93 at -0x1.063c44p-1, 0x1.fc6cdcp-2, 0x1.01b49cp-1)
 */
NKW_ALGEBRA float nkw_lerp(float a, float b, float t);

/**
 * The parameter of x on the line from a (0) to b (1): the inverse of nkw_lerp.
 *
 *     t = (x - a)/(b - a)
 *
 * a, b     x - a and b - a must not overflow
 * Returns  exactly 0 at x = a and exactly 1 at x = b; less than 0 or more than 1 beyond the ends; 0 for a = b
 *
 * Error  3.0 ULP (2.49 at 0x1.9b7b88p0, 0x1.34c4e4p3, 0x1.34a41ep3)
 */
NKW_ALGEBRA float nkw_inverse_lerp(float a, float b, float x);

/** 1 if a and b differ by at most `tolerance`, otherwise 0, also for NaN. Equal infinities do not differ. */
NKW_API int nkw_equal_within(float a, float b, float tolerance);

/**
 * `from`, moved towards `to` by at most `step`: `to` itself within that distance, otherwise from + step or from - step.
 * A negative step counts as 0. NaN returns NaN.
 */
NKW_API float nkw_move_towards(float from, float to, float step);

/**
 * The smooth step from 0 to 1, with derivative 0 at both ends.
 *
 *     s^2 (3 - 2 s)            s < 1/2,  s = t clamped to [0, 1]
 *     1 - u^2 (3 - 2 u)        otherwise,  u = 1 - s
 *
 * Returns  0 for t <= 0 and for NaN, 1 for t >= 1
 *
 * Error  2.0 ULP (exhaustive: 1.998 at 0x1.ffb4f4p-2)
 */
NKW_ALGEBRA float nkw_smoothstep(float t);

/**
 * An angle in degrees, from radians: times 180/pi, computed in binary64.
 *
 * Error  0.500001 ULP (exhaustive: 0.5000000 at 0x1.698402p-126)
 */
NKW_ALGEBRA float nkw_degrees_from_radians(float radians);

/**
 * An angle in radians, from degrees: times pi/180, computed in binary64.
 *
 * Error  0.500001 ULP (exhaustive: 0.5000000 at 0x1.af870cp-123)
 */
NKW_ALGEBRA float nkw_radians_from_degrees(float degrees);

/* ---- elementary functions, in the library ---- */

/**
 * The square root. Negative numbers return NaN, -0 returns -0.
 *
 * Error  0.5 ULP, correctly rounded (IEEE 754)
 */
NKW_ALGEBRA_ROOT float nkw_sqrt(float x);

/**
 * The sine of an angle in radians.
 *
 *     angle/pi = n + t,  |t| <= 1/2         sin angle = (-1)^n t P(t^2)
 *
 * angle    every finite float. Below 2^20 the reduction uses 1/pi in two parts. From 2^20 on it uses three parts, which
 *          the exponent selects, so the error at 3.4e38 is the same as at 1.
 * Returns  a number in [-1, 1]; sin(-a) = -sin(a) in every bit; -0 for -0; NaN for infinities
 *
 * Error  0.5005 ULP (exhaustive: 0.5004016 at 0x1.f6c9b4p49)
 * Source Cody, Waite, Software Manual for the Elementary Functions, 1980; Payne, Hanek, Radian Reduction
 *        for Trigonometric Functions, SIGNUM Newsletter 18, 1983.
 */
NKW_API float nkw_sin(float angle);

/**
 * The cosine of an angle in radians.
 *
 *     1/2 - |angle|/pi = n + t,  |t| <= 1/2        cos angle = (-1)^n t P(t^2)
 *
 * Returns  a number in [-1, 1]; cos(-a) = cos(a) in every bit; 1 for zeros; NaN for infinities
 *
 * Error  0.5005 ULP (exhaustive: 0.5004021 at 0x1.298da6p87)
 * Source as nkw_sin
 */
NKW_API float nkw_cos(float angle);

/**
 * Sine and cosine of one angle, with the bits of nkw_sin and nkw_cos.
 *
 * sine, cosine  one float each; if both are the same address, it contains the cosine afterwards
 *
 * Error  0.5005 ULP each
 */
NKW_API void nkw_sincos(float angle, float *sine, float *cosine);

/**
 * The tangent of an angle in radians: sine over cosine before either is rounded.
 *
 * Returns  a finite number for every finite angle, because no float is an odd multiple of pi/2; tan(-a) = -tan(a) in
 *          every bit; -0 for -0; NaN for infinities
 *
 * Error  0.5007 ULP (exhaustive: 0.500609 at 0x1.e2e36cp120)
 */
NKW_API float nkw_tan(float angle);

/**
 * The angle in [-pi/2, pi/2] whose sine is x.
 *
 *     |x| <= 1/2:  s (1 + s^2 P(s^2)), s = |x|         otherwise:  pi/2 - 2 asin s, s = sqrt((1 - |x|)/2)
 *
 * x        clamped to [-1, 1], because rounding may move a dot product of unit vectors beyond 1
 * Returns  asin(-x) = -asin(x) in every bit; -0 for -0
 *
 * Error  0.500001 ULP (exhaustive: 0.5000000 at 0x1.137f0cp-5)
 */
NKW_API float nkw_asin(float x);

/**
 * The angle in [0, pi] whose cosine is x.
 *
 *     |x| <= 1/2:  pi/2 - asin x      x > 1/2:  2 asin s      x < -1/2:  pi - 2 asin s,   s as in nkw_asin
 *
 * x        clamped to [-1, 1]
 * Returns  0 at 1, without loss of digits near 1; at -1 the float nearest to pi, 8.7e-8 more than pi
 *
 * Error  0.500001 ULP (exhaustive: 0.5000000 at 0x1.110b46p-26)
 */
NKW_API float nkw_acos(float x);

/**
 * The angle in [-pi/2, pi/2] whose tangent is x. atan(-x) = -atan(x) in every bit; infinities return pi/2 with their
 * sign.
 *
 * Error  0.500001 ULP (exhaustive: 0.5000003 at 0x1.a02dc6p-2)
 */
NKW_API float nkw_atan(float x);

/**
 * The angle of the point (x, y), from the positive x axis towards the positive y axis.
 *
 *     q = low/high,    low, high the smaller and the larger of |x|, |y|
 *     atan q                                        q <= tan(pi/8)
 *     pi/4 + atan((low - high)/(low + high))        otherwise;  then the octant
 *
 * Returns  an angle in [-pi, pi] with the sign of y. Special values are those of C99 F.9.1.4:
 *
 *     y = +-0:   +-0 for x > 0 and x = +0,  +-pi for x < 0 and x = -0
 *     x = +-0:   +-pi/2 with the sign of y != 0
 *     y = +-inf: +-pi/2 for finite x,  +-pi/4 for x = +inf,  +-3 pi/4 for x = -inf
 *     finite y:  +-0 for x = +inf,  +-pi for x = -inf
 *
 * So (0, 0) returns 0: the zero vector counts as the direction x.
 *
 * Error  0.500001 ULP (0.5000002 at y = 0x1.1e2b4p-5, x = 0x1.327b6cp-1, of 4e8 pairs)
 */
NKW_API float nkw_atan2(float y, float x);

/**
 * e to the power of x.
 *
 *     e^x = 2^n 2^f,     x log2 e = n + f,  |f| <= 1/2
 *
 * Returns  1 for zeros; +inf above 88.72284; subnormal numbers, rounded once, below -87.3365; 0 below -103.9721 and for
 *          -inf
 *
 * Error  0.500001 ULP (exhaustive: 0.5000002 at -0x1.96b488p2)
 */
NKW_API float nkw_exp(float x);

/**
 * The natural logarithm.
 *
 *     ln x = k ln 2 + 2 atanh((m - 1)/(m + 1)),     x = 2^k m,  sqrt(1/2) <= m < sqrt 2
 *
 * Returns  0 for 1; -inf for zeros; NaN for negative numbers; +inf for +inf
 *
 * Error  0.500001 ULP (exhaustive: 0.5000000 at 0x1.22d57p-65)
 */
NKW_API float nkw_log(float x);

/**
 * x to the power of y.
 *
 *     x^y = 2^(y log2 |x|), with the sign of x for odd y
 *
 * Returns  special values as in C99 F.9.4.4:
 *
 *     1           for y = 0 and for x = 1, even if the other is NaN; for x = -1 and infinite y
 *     NaN         for finite x < 0 and finite y that is not an integer
 *     x = +-0:    inf for y < 0, 0 for y > 0; the sign of x for odd y, otherwise +
 *     x = +-inf:  0 for y < 0, inf for y > 0; the sign of x for odd y, otherwise +
 *     y = +inf:   0 for |x| < 1, +inf for |x| > 1;  y = -inf the reverse
 *
 * Results that overflow are infinite, results that underflow are zero; subnormal results are rounded once.
 *
 * Error  0.500001 ULP (0.5000002 at x = 0x1.0000b8p0, y = 0x1.3933b6p21, of 5e8 pairs)
 */
NKW_API float nkw_pow(float x, float y);

/* ---- periods ---- */

/**
 * x reduced to [0, period): x - period floor(x / period), in exact arithmetic.
 *
 *     wrap(7, 3) = 1,   wrap(-1, 3) = 2,   wrap(1e30, 3) = the remainder of the exact integer
 *
 * x        finite
 * period   finite and above 0
 * Returns  for x >= 0 the exact remainder, however large the quotient. For x < 0 the period minus the remainder of -x,
 *          rounded; if that rounds to the period, the largest float below it. Never -0. NaN if x or the period is out
 *          of its range.
 *
 * Error  1.0 ULP next to the period (x = -0x1.d0a982p-60, period 0x1.b96404p0), else 0.5 ULP
 */
NKW_API float nkw_wrap(float x, float period);

/**
 * An angle reduced by multiples of 2 pi, as in nkw_sin.
 *
 *     (-pi, pi], in floats: (-F, F],     F = 0x1.921fb6p1, the float nearest to pi
 *
 * F is 8.7e-8 more than pi. A float in (-F, F] is returned unchanged, so a second call changes nothing, and
 * nkw_wrap_angle(F) is F. Every other angle is reduced by the exact 2 pi to (F - 2 pi, F], then rounded;
 * -F becomes 2 pi - F = 3.1415925.
 *
 * angle    every finite float
 * Returns  -0 for -0; NaN for infinities
 *
 * Error  0.5001 ULP
 */
NKW_API float nkw_wrap_angle(float angle);

/**
 * The signed difference of two angles of smallest magnitude: to - from, modulo 2 pi, in the range of nkw_wrap_angle.
 *
 * from, to  every finite float; each is reduced before the subtraction
 * Returns   the float nearest to the exact difference, to within 2e-15 rad. difference(to, from) is
 *           -difference(from, to), except next to half turns, where both can be positive: with F, the float nearest
 *           to pi, difference(0, F) is F and difference(F, 0) is 2 pi - F, the float below F. NaN if either angle is
 *           infinite.
 *
 * Error  0.5001 ULP for differences above 1e-6 (0.500067 at 0x1.1166bp3, 0x1.159728p9); 2e-15 rad
 *        more than rounding below
 */
NKW_API float nkw_angle_difference(float from, float to);

#ifdef __cplusplus
}
#endif

#if NKW_INLINE || defined(NKW_DEFINE_ALGEBRA)
#include "inline/scalar.h"
#endif

#endif
