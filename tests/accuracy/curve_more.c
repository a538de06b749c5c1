/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/curve.h>, its motions, against binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>

#define SAMPLES 75000u

/* ---- Samples: four control values and t ---- */

static void uniform(random_source *r, float *x)
{
    for (int i = 0; i < 4; i++)
        x[i] = random_between(r, -1.0f, 1.0f);
    x[4] = random_unit(r);
}

static float delta(random_source *r, float low, float high)
{
    float sign = random_sign(r);
    return sign * random_log(r, low, high);
}

static void scattered(random_source *r, float *x)
{
    for (int i = 0; i < 4; i++)
        x[i] = delta(r, 1e-3f, 1e3f);
    x[4] = random_unit(r);
}

static void near_base(random_source *r, float *x)
{
    float base = delta(r, 1e4f, 1e6f);
    for (int i = 0; i < 4; i++)
        x[i] = base + delta(r, 1e-3f, 1.0f);
    x[4] = random_unit(r);
}

/* t of more than 24 bits after the point. */
static void fine_t(random_source *r, float *x)
{
    uniform(r, x);
    x[4] = fabsf(random_scaled(r, -30, 0));
}

static void with_times(random_source *r, float *x)
{
    x[5] = random_between(r, 0.0f, 10.0f);
    for (int i = 6; i < 9; i++)
        x[i] = x[i - 1] + random_log(r, 0.01f, 1.0f);
}

static void timed(random_source *r, float *x)
{
    uniform(r, x);
    with_times(r, x);
}

static void timed_scattered(random_source *r, float *x)
{
    scattered(r, x);
    with_times(r, x);
}

static wide magnitude(wide x)
{
    return x < 0 ? -x : x;
}

static wide largest(const wide *x, int n)
{
    wide size = 0;
    for (int i = 0; i < n; i++)
        size = magnitude(x[i]) > size ? magnitude(x[i]) : size;
    return size;
}

/* ---- Derivatives of a segment by t ---- */

/* Of the larger of the derivative and the differences f, v0, v1. */
static double slope_error(nkw_cubic_kind kind, const float *x, float got, int derivative)
{
    wide c[4], d[3], t = x[4], s = 1 - t, size;
    wide_from(x, c, 4);
    for (int i = 0; i < 3; i++)
        d[i] = c[i + 1] - c[i];
    wide in = (d[0] + d[1]) / 2, out = (d[1] + d[2]) / 2;
    wide slopes[4][3] = {{c[2] - c[0], c[1], c[3]},
                         {d[0] + d[1] + d[2], 3 * d[0], 3 * d[2]},
                         {(d[0] + 4 * d[1] + d[2]) / 6, in, out},
                         {d[1], in, out}};
    wide first[3] = {6 * t * s, s * (s - 2 * t), t * (t - 2 * s)}, second[3] = {6 - 12 * t, 6 * t - 4, 6 * t - 2};
    wide exact = wide_dot(slopes[kind], derivative == 1 ? first : second, 3);
    size = largest(slopes[kind], 3) > magnitude(exact) ? largest(slopes[kind], 3) : magnitude(exact);
    return size == 0 ? (got == 0.0f ? 0.0 : HUGE_VAL) : wide_error_of(&got, &exact, 1, size);
}

static double point_error(const float *x)
{
    double worst = 0.0;
    for (int k = 0; k < 4; k++) {
        nkw_motion p = nkw_cubic_evaluate(x, x[4], (nkw_cubic_kind)k);
        worst = fmax(worst, slope_error((nkw_cubic_kind)k, x, p.velocity, 1));
        worst = fmax(worst, slope_error((nkw_cubic_kind)k, x, p.acceleration, 2));
    }
    return worst;
}

/* The slope of the parabola. */
static wide tangent(wide p0, wide p1, wide p2, wide h0, wide h1)
{
    return ((p1 - p0) / h0 * h1 + (p2 - p1) / h1 * h0) / (h0 + h1);
}

/* Of the largest of |p2 - p1| and the tangents per segment. */
static double timed_point_error(const float *x)
{
    wide p[4], t[4];
    wide_from(x, p, 4);
    wide_from(x + 5, t, 4);
    wide h0 = t[1] - t[0], h1 = t[2] - t[1], h2 = t[3] - t[2], at = x[4], s = 1 - at;
    wide c[3] = {p[2] - p[1], tangent(p[0], p[1], p[2], h0, h1) * h1, tangent(p[1], p[2], p[3], h1, h2) * h1};
    wide first[3] = {6 * at * s, s * (s - 2 * at), at * (at - 2 * s)}, exact = wide_dot(c, first, 3);
    float through[4];
    nkw_cubic_from_catmull_rom(x, x + 5, through);
    float got = nkw_cubic_evaluate(through, x[4], NKW_CUBIC_HERMITE).velocity;
    return wide_error_of(&got, &exact, 1, largest(c, 3));
}

/* Two ends of a quintic, and t. */
static void quintic_ends(random_source *r, float *x)
{
    for (int i = 0; i < 6; i++)
        x[i] = random_between(r, -1.0f, 1.0f);
    x[6] = random_unit(r);
}

static void quintic_scattered(random_source *r, float *x)
{
    for (int i = 0; i < 6; i++)
        x[i] = delta(r, 1e-3f, 1e3f);
    x[6] = random_unit(r);
}

/* From the monomials: value, first and second derivative of the six basis polynomials. */
static double quintic_error(const float *x)
{
    static const int basis[6][6] = {{2, 0, 0, -20, 30, -12}, {0, 2, 0, -12, 16, -6}, {0, 0, 1, -3, 3, -1},
                                    {0, 0, 0, 20, -30, 12},  {0, 0, 0, -8, 14, -6},  {0, 0, 0, 1, -2, 1}};
    nkw_motion p0 = {x[0], x[1], x[2]}, p1 = {x[3], x[4], x[5]}, p = nkw_quintic_evaluate(p0, p1, x[6]);
    const float got[3] = {p.value, p.velocity, p.acceleration};
    wide ends[6], sum[3] = {0, 0, 0}, t = x[6];
    wide_from(x, ends, 6);
    for (int i = 0; i < 6; i++) {
        wide v = 0, d = 0, a = 0;
        for (int k = 5; k >= 0; k--) {
            a = a * t + 2 * d;
            d = d * t + v;
            v = v * t + basis[i][k];
        }
        sum[0] += v * x[i] / 2;
        sum[1] += d * x[i] / 2;
        sum[2] += a * x[i] / 2;
    }
    double worst = 0.0;
    for (int i = 0; i < 3; i++) {
        wide exact = magnitude(sum[i]), size = largest(ends, 6);
        worst = fmax(worst, wide_error_of(got + i, sum + i, 1, exact > size ? exact : size));
    }
    return worst;
}

static const wide_case cases[] = {
    {"nkw_cubic_evaluate", "[-1, 1]", uniform, point_error, 5, WIDE_CHECKED},
    {"nkw_cubic_evaluate", "[-1, 1], t in 2^-30 .. 1", fine_t, point_error, 5, WIDE_CHECKED},
    {"nkw_cubic_evaluate", "1e4 .. 1e6 + 1e-3 .. 1", near_base, point_error, 5, WIDE_CHECKED},
    {"nkw_cubic_evaluate", "magnitudes 1e-3 .. 1e3", scattered, point_error, 5, WIDE_CHECKED},
    {"nkw_cubic_from_catmull_rom", "velocity of it, [-1, 1]", timed, timed_point_error, 9, WIDE_CHECKED},
    {"nkw_cubic_from_catmull_rom", "velocity of it, magnitudes 1e-3 .. 1e3", timed_scattered, timed_point_error, 9,
     WIDE_CHECKED},
    {"nkw_quintic_evaluate", "[-1, 1]", quintic_ends, quintic_error, 7, WIDE_CHECKED},
    {"nkw_quintic_evaluate", "magnitudes 1e-3 .. 1e3", quintic_scattered, quintic_error, 7, WIDE_CHECKED},
};

void curve_more(accuracy *a)
{
    wide_search(a, cases, sizeof cases / sizeof cases[0], SAMPLES);
}

#else
/* ISO C forbids an empty file. */
typedef int curve_more_is_skipped;
#endif
