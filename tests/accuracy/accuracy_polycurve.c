/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/polycurve.h> against binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>

#define SAMPLES 300u

/* Intervals of the exact integral. */
#define PARTS 24

/* A Bezier segment whose control points advance in x, so that it does not stand still: x[0..11]; and two parameters. */
static void advancing(random_source *r, float *x)
{
    for (int i = 0; i < 4; i++) {
        x[3 * i] = (float)i + random_between(r, -0.25f, 0.25f);
        x[3 * i + 1] = random_between(r, -1.0f, 1.0f);
        x[3 * i + 2] = random_between(r, -1.0f, 1.0f);
    }
    x[12] = random_unit(r);
    x[13] = random_unit(r);
}

static nkw_vec3_cubic cubic_of(const float *x)
{
    nkw_vec3_cubic c;
    for (int i = 0; i < 4; i++)
        c.c[i] = vec3_at(x + 3 * i);
    return c;
}

static wide speed(const float *x, wide t)
{
    wide s = 1 - t, v[3];
    for (int i = 0; i < 3; i++) {
        wide d0 = (wide)x[3 + i] - x[i], d1 = (wide)x[6 + i] - x[3 + i], d2 = (wide)x[9 + i] - x[6 + i];
        v[i] = 3 * (s * s * d0 + 2 * s * t * d1 + t * t * d2);
    }
    return wide_length(v, 3);
}

/* Romberg's extrapolation of the trapezoidal rule, in each of the parts. */
static wide romberg(const float *x, wide a, wide b)
{
    wide row[8], h = b - a;
    row[0] = h * (speed(x, a) + speed(x, b)) / 2;
    for (int n = 1; n < 6; n++) {
        wide sum = 0, before = row[0], factor = 1;
        int count = 1 << (n - 1);
        for (int i = 0; i < count; i++)
            sum += speed(x, a + h * (2 * i + 1) / (2 * count));
        row[0] = row[0] / 2 + h * sum / (2 * count);
        for (int k = 1; k <= n; k++) {
            wide kept = row[k];
            factor *= 4;
            row[k] = row[k - 1] + (row[k - 1] - before) / (factor - 1);
            before = kept;
        }
    }
    return row[5];
}

static wide exact_length(const float *x, wide from, wide to)
{
    wide sum = 0;
    for (int i = 0; i < PARTS; i++)
        sum += romberg(x, from + (to - from) * i / PARTS, from + (to - from) * (i + 1) / PARTS);
    return sum;
}

static double length_error(const float *x)
{
    nkw_vec3_cubic c = cubic_of(x);
    float got = nkw_vec3_cubic_length(NKW_CUBIC_BEZIER, &c, x[12], x[13]);
    wide exact = exact_length(x, x[12], x[13]), whole = exact_length(x, 0, 1), size = exact < 0 ? -exact : exact;
    return wide_error_of(&got, &exact, 1, size > whole * 0x1p-16f ? size : whole * 0x1p-16f);
}

/* The difference of lengths, of the whole, without what the rounding of t adds. */
static double place_error(const float *x)
{
    nkw_vec3_cubic c = cubic_of(x);
    nkw_polycurve curve = {&c, 1, NKW_CUBIC_BEZIER};
    float lengths[5];
    size_t steps = x[13] < 0.5f ? 1 : 4;
    if (nkw_polycurve_measure(&curve, steps, lengths, 5) != NKW_OK)
        return HUGE_VAL;
    float length = x[12] * lengths[steps];
    nkw_segment at = nkw_polycurve_at_length(&curve, lengths, steps, length);
    wide off = exact_length(x, 0, at.t) - length, whole = exact_length(x, 0, 1);
    wide rounding = speed(x, at.t) * (nextafterf(at.t, 2.0f) - at.t) / 2;
    off = off < 0 ? -off : off;
    return (double)((off > rounding ? off - rounding : 0) / whole * 0x1p24f);
}

/* A velocity and an acceleration that are not nearly parallel. */
static void bent(random_source *r, float *x)
{
    put_vec3(x, random_vec3(r, -1.0f, 1.0f));
    put_vec3(x + 3, random_vec3(r, -1.0f, 1.0f));
}

static double frenet_error(const float *x)
{
    wide v[3], a[3], b[3], n[3];
    nkw_vec3_curve_point p = {{0, 0, 0}, vec3_at(x), vec3_at(x + 3)};
    nkw_vec3 up = {0, 0, 1};
    nkw_curve_frame f = nkw_curve_frame_frenet(&p, up);
    float got[9];
    wide_from(x, v, 3);
    wide_from(x + 3, a, 3);
    wide_cross(v, a, b);
    if (!(wide_length(b, 3) * 8 >= wide_length(v, 3) * wide_length(a, 3)))
        return 0.0;
    put_vec3(got, f.tangent);
    put_vec3(got + 3, f.normal);
    put_vec3(got + 6, f.binormal);
    wide_normalize(v, 3);
    wide_normalize(b, 3);
    wide_cross(b, v, n);
    return fmax(wide_error(got, v, 3), fmax(wide_error(got + 3, n, 3), wide_error(got + 6, b, 3)));
}

static const wide_case lengths[] = {
    {"nkw_vec3_cubic_length", "Bezier, advancing", advancing, length_error, 14, WIDE_CHECKED},
    {"nkw_polycurve_at_length", "Bezier, advancing, 1 and 4 steps", advancing, place_error, 14, WIDE_CHECKED},
};

static const wide_case frames[] = {
    {"nkw_curve_frame_frenet", "[-1, 1]", bent, frenet_error, 6, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("polycurve.h", argc, argv);
    wide_search(&a, lengths, sizeof lengths / sizeof lengths[0], SAMPLES);
    wide_search(&a, frames, sizeof frames / sizeof frames[0], 100 * SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
