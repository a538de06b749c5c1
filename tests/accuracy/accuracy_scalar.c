/* SPDX-License-Identifier: MIT */
/*
 * Errors of <nakawari/scalar.h>.
 *
 * Functions of one number: every float with --exhaustive, else every 127th. Functions of two: structured
 * random pairs. Oracle: the C library's binary64 functions (glibc: below 1 ULP of binary64, which is 2^-29
 * ULP of binary32, so a figure holds to 2e-9 and near-worst candidates need no second look); binary80 for
 * angle differences; fmod, which is exact, for periods.
 */
#include "accuracy.h"

#include <math.h>
#include <string.h>

#include <nakawari/scalar.h>

#include "../support/random.h"

#define PI_FLOAT 0x1.921fb6p1
#define PI       3.14159265358979323846
#define PI_LONG  3.14159265358979323846264338327950288L

typedef float one_function(float x);
typedef double one_oracle(double x);

/* Symmetry that is checked bit by bit, and then lets the positive half stand for both. */
typedef enum symmetry { NONE, ODD, EVEN } symmetry;

typedef struct one_case {
    const char *name;
    one_function *got;
    one_oracle *exact;
    symmetry symmetry;
    float highest; /* largest |x| */
} one_case;

static float float_from(uint32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static uint32_t bits_from(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static int same_bits(float a, float b)
{
    return bits_from(a) == bits_from(b);
}

/* The angle in (F - 2 pi, F]; sine and cosine of glibc reduce every argument exactly. */
static double exact_wrap_angle(double x)
{
    double r = atan2(sin(x), cos(x));
    if (fabs(x) < PI_FLOAT || x == PI_FLOAT)
        return x;
    return r <= PI_FLOAT - 2.0 * PI ? r + 2.0 * PI : r;
}

static double exact_degrees(double x)
{
    return (double)((long double)x * 180.0L / PI_LONG);
}

static double exact_radians(double x)
{
    return (double)((long double)x * PI_LONG / 180.0L);
}

static double exact_smoothstep(double t)
{
    double s = t > 0.0 ? (t < 1.0 ? t : 1.0) : 0.0;
    return s * s * (3.0 - 2.0 * s);
}

static float sine_of_pair(float x)
{
    float sine, cosine;
    nkw_sincos(x, &sine, &cosine);
    return same_bits(cosine, nkw_cos(x)) ? sine : NAN;
}

static const one_case one_cases[] = {
    {"nkw_sqrt", nkw_sqrt, sqrt, NONE, FLT_MAX},
    {"nkw_sin", nkw_sin, sin, ODD, FLT_MAX},
    {"nkw_cos", nkw_cos, cos, EVEN, FLT_MAX},
    {"nkw_sincos", sine_of_pair, sin, ODD, FLT_MAX},
    {"nkw_tan", nkw_tan, tan, ODD, FLT_MAX},
    {"nkw_asin", nkw_asin, asin, ODD, 1.0f},
    {"nkw_acos", nkw_acos, acos, NONE, 1.0f},
    {"nkw_atan", nkw_atan, atan, ODD, FLT_MAX},
    {"nkw_exp", nkw_exp, exp, NONE, FLT_MAX},
    {"nkw_log", nkw_log, log, NONE, FLT_MAX},
    {"nkw_wrap_angle", nkw_wrap_angle, exact_wrap_angle, NONE, FLT_MAX},
    {"nkw_degrees_from_radians", nkw_degrees_from_radians, exact_degrees, ODD, FLT_MAX},
    {"nkw_radians_from_degrees", nkw_radians_from_degrees, exact_radians, ODD, FLT_MAX},
    {"nkw_smoothstep", nkw_smoothstep, exact_smoothstep, NONE, FLT_MAX},
};

static double one_error(const one_case *c, float x)
{
    float got = c->got(x);
    float mirrored = c->symmetry == NONE ? got : c->got(-x);
    if (!same_bits(mirrored, c->symmetry == ODD ? -got : got) && got == got)
        return INFINITY;
    return accuracy_ulps(got, c->exact((double)x));
}

static void measure_one(accuracy *a, const one_case *c)
{
    accuracy_worst w = accuracy_worst_begin(1);
    uint32_t stride = accuracy_stride(a, 127);
    uint32_t end = bits_from(c->highest);
    const char *how = a->exhaustive ? "every float" : "every 127th float";
    char region[64];
    for (uint32_t bits = 0; bits <= end; bits += stride) {
        float x = float_from(bits);
        accuracy_worst_add(&w, one_error(c, x), &x);
        if (c->symmetry == NONE) {
            x = -x;
            accuracy_worst_add(&w, one_error(c, x), &x);
        }
    }
    const char *both = c->highest == 1.0f ? " of [-1, 1]" : "", *positive = c->highest == 1.0f ? " of [0, 1]" : " from 0 on";
    snprintf(region, sizeof region, "%s%s", how, c->symmetry == NONE ? both : positive);
    accuracy_row(a, c->name, region, &w);
}

/* Two or more arguments: a generator fills x, then the error of that case is taken. */
typedef void sampler(random_source *r, float *x);
typedef double sample_error(const float *x);

static void measure_samples(accuracy *a, const char *name, const char *region, sampler *sample,
                            sample_error *error, int arguments)
{
    accuracy_worst w = accuracy_worst_begin(arguments);
    random_source r = random_from(1);
    uint32_t count = a->exhaustive ? 100000000u : 1000000u;
    if (!accuracy_wants(a, name))
        return;
    for (uint32_t i = 0; i < count; i++) {
        float x[5];
        sample(&r, x);
        accuracy_worst_add(&w, error(x), x);
    }
    accuracy_row(a, name, region, &w);
}

/* ---- atan2 ---- */

static double atan2_error(const float *x)
{
    return accuracy_ulps(nkw_atan2(x[0], x[1]), atan2((double)x[0], (double)x[1]));
}

static void square_pair(random_source *r, float *x)
{
    x[0] = random_between(r, -1.0f, 1.0f);
    x[1] = random_between(r, -1.0f, 1.0f);
}

static void ratio_pair(random_source *r, float *x)
{
    x[0] = random_scaled(r, -10, 10);
    x[1] = random_scaled(r, -10, 10);
}

static void circle_pair(random_source *r, float *x)
{
    nkw_sincos(random_between(r, -4.0f, 4.0f), &x[0], &x[1]);
}

static void finite_pair(random_source *r, float *x)
{
    x[0] = random_finite(r);
    x[1] = random_finite(r);
}

static const float specials[] = {0.0f,           -0.0f,           1.0f,          -1.0f,
                                 0.5f,           -0.5f,           2.0f,          -2.0f,
                                 3.0f,           -3.0f,           2.5f,          -2.5f,
                                 0x1.fffffep-1f, -0x1.fffffep-1f, 0x1.000002p0f, -0x1.000002p0f,
                                 8388607.5f,     8388609.0f,      -8388609.0f,   16777215.0f,
                                 -16777215.0f,   16777216.0f,     -16777216.0f,  0x1p-149f,
                                 -0x1p-149f,     FLT_MIN,         -FLT_MIN,      FLT_MAX,
                                 -FLT_MAX,       INFINITY,        -INFINITY,     NAN};
#define SPECIALS (sizeof specials / sizeof specials[0])

/* Every pair of special values; a wrong sign of zero counts as an infinite error. */
static void measure_specials(accuracy *a, const char *name, float (*got)(float, float),
                             double (*exact)(double, double))
{
    accuracy_worst w = accuracy_worst_begin(2);
    if (!accuracy_wants(a, name))
        return;
    for (size_t i = 0; i < SPECIALS * SPECIALS; i++) {
        float x[2] = {specials[i / SPECIALS], specials[i % SPECIALS]};
        float g = got(x[0], x[1]);
        double e = exact((double)x[0], (double)x[1]);
        int sign_lost = g == 0.0f && !signbit(g) != !signbit(e);
        accuracy_worst_add(&w, sign_lost ? INFINITY : accuracy_ulps(g, e), x);
    }
    accuracy_row(a, name, "pairs of special values", &w);
}

/* ---- pow ---- */

static double pow_error(const float *x)
{
    return accuracy_ulps(nkw_pow(x[0], x[1]), pow((double)x[0], (double)x[1]));
}

static void curve_pair(random_source *r, float *x)
{
    x[0] = random_between(r, 0.0f, 4.0f);
    x[1] = random_between(r, -8.0f, 8.0f);
}

/* x over all magnitudes, y so that the result spans 2^-152 .. 2^130. */
static void power_pair(random_source *r, float *x)
{
    x[0] = fabsf(random_scaled(r, -149, 127));
    x[1] = (float)((double)random_between(r, -152.0f, 130.0f) / log2((double)x[0]));
}

/* x within 2^-8 of 1, so that y is large. */
static void near_one_pair(random_source *r, float *x)
{
    x[0] = 1.0f + random_scaled(r, -23, -8);
    x[1] = (float)((double)random_between(r, -152.0f, 130.0f) / log2((double)x[0]));
}

static void whole_pair(random_source *r, float *x)
{
    x[0] = random_between(r, -10.0f, 10.0f);
    x[1] = (float)((int)(random_bits(r) % 41) - 20);
}

/* ---- lines ---- */

static double lerp_error(const float *x)
{
    double a = (double)x[0], b = (double)x[1], t = (double)x[2];
    double size = fmax(fabs(a), fabs(b));
    return accuracy_units((double)nkw_lerp(x[0], x[1], x[2]), a + t * (b - a), size);
}

static void keyframe_line(random_source *r, float *x)
{
    x[0] = random_between(r, 1.0f, 4.0f);
    x[1] = random_between(r, 1.0f, 4.0f);
    x[2] = random_unit(r);
}

static void crossing_line(random_source *r, float *x)
{
    x[0] = random_between(r, -1.0f, 0.0f);
    x[1] = random_between(r, 0.0f, 1.0f);
    x[2] = random_unit(r);
}

static double inverse_error(const float *x)
{
    double a = (double)x[0], b = (double)x[1], v = (double)x[2];
    return accuracy_ulps(nkw_inverse_lerp(x[0], x[1], x[2]), a == b ? 0.0 : (v - a) / (b - a));
}

static void three_numbers(random_source *r, float *x)
{
    for (int i = 0; i < 3; i++)
        x[i] = random_between(r, -10.0f, 10.0f);
}

/* ---- periods ---- */

static double wrap_error(const float *x)
{
    double rest = fmod((double)x[0], (double)x[1]);
    double exact = rest < 0.0 ? rest + (double)x[1] : rest;
    float got = nkw_wrap(x[0], x[1]);
    return got >= 0.0f && got < x[1] ? accuracy_ulps(got, exact) : INFINITY;
}

static void clock_pair(random_source *r, float *x)
{
    x[0] = random_between(r, -100.0f, 100.0f);
    x[1] = random_between(r, 0.01f, 10.0f);
}

static void far_pair(random_source *r, float *x)
{
    x[0] = random_finite(r);
    x[1] = fabsf(random_scaled(r, -149, 127));
}

static void below_zero_pair(random_source *r, float *x)
{
    x[0] = -fabsf(random_scaled(r, -60, 0));
    x[1] = random_between(r, 0.5f, 4.0f);
}

static double difference_error(const float *x)
{
    long double from = atan2l(sinl((long double)x[0]), cosl((long double)x[0]));
    long double to = atan2l(sinl((long double)x[1]), cosl((long double)x[1]));
    long double d = to - from;
    d = d > (long double)PI_FLOAT ? d - 2.0L * PI_LONG : d;
    d = d <= (long double)PI_FLOAT - 2.0L * PI_LONG ? d + 2.0L * PI_LONG : d;
    if (fabsl(d) <= 1e-6L) {
        double off = (double)fabsl((long double)nkw_angle_difference(x[0], x[1]) - d);
        return off <= (double)fabsl(d) * 0x1p-24 + 2e-15 ? 0.0 : INFINITY;
    }
    return accuracy_ulps(nkw_angle_difference(x[0], x[1]), (double)d);
}

static void heading_pair(random_source *r, float *x)
{
    x[0] = random_between(r, -10.0f, 10.0f);
    x[1] = random_between(r, -10.0f, 10.0f);
}

/* Two floats that differ by nearly whole turns. */
static void turning_pair(random_source *r, float *x)
{
    double turns = (double)(random_bits(r) % 200) - 100.0;
    x[0] = random_between(r, -10.0f, 10.0f);
    x[1] = (float)((double)x[0] + turns * 2.0 * PI + (double)random_scaled(r, -20, 0));
}

static void measure_pairs(accuracy *a)
{
    measure_specials(a, "nkw_atan2", nkw_atan2, atan2);
    measure_samples(a, "nkw_atan2", "square [-1, 1]", square_pair, atan2_error, 2);
    measure_samples(a, "nkw_atan2", "ratio 2^-20 .. 2^20", ratio_pair, atan2_error, 2);
    measure_samples(a, "nkw_atan2", "unit circle", circle_pair, atan2_error, 2);
    measure_samples(a, "nkw_atan2", "any finite", finite_pair, atan2_error, 2);
    measure_specials(a, "nkw_pow", nkw_pow, pow);
    measure_samples(a, "nkw_pow", "x in [0, 4], y in [-8, 8]", curve_pair, pow_error, 2);
    measure_samples(a, "nkw_pow", "results 2^-152 .. 2^130", power_pair, pow_error, 2);
    measure_samples(a, "nkw_pow", "same, x within 2^-8 of 1", near_one_pair, pow_error, 2);
    measure_samples(a, "nkw_pow", "integer y, x in [-10, 10]", whole_pair, pow_error, 2);
    measure_samples(a, "nkw_pow", "any finite", finite_pair, pow_error, 2);
}

static void measure_lines(accuracy *a)
{
    measure_samples(a, "nkw_lerp", "a, b in [1, 4]", keyframe_line, lerp_error, 3);
    measure_samples(a, "nkw_lerp", "opposite signs", crossing_line, lerp_error, 3);
    measure_samples(a, "nkw_inverse_lerp", "[-10, 10]", three_numbers, inverse_error, 3);
}

static void measure_periods(accuracy *a)
{
    measure_samples(a, "nkw_wrap", "x in [-100, 100]", clock_pair, wrap_error, 2);
    measure_samples(a, "nkw_wrap", "just below zero", below_zero_pair, wrap_error, 2);
    measure_samples(a, "nkw_wrap", "any finite", far_pair, wrap_error, 2);
    measure_samples(a, "nkw_angle_difference", "[-10, 10]", heading_pair, difference_error, 2);
    measure_samples(a, "nkw_angle_difference", "nearly whole turns", turning_pair, difference_error,
                    2);
    measure_samples(a, "nkw_angle_difference", "any finite", finite_pair, difference_error, 2);
}

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("scalar.h", argc, argv);
    for (size_t i = 0; i < sizeof one_cases / sizeof one_cases[0]; i++)
        if (accuracy_wants(&a, one_cases[i].name))
            measure_one(&a, &one_cases[i]);
    measure_lines(&a);
    measure_periods(&a);
    measure_pairs(&a);
    return accuracy_end(&a);
}
