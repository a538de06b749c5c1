/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/polycurve.h> against binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>
#include <stdlib.h>
#include <string.h>

#define SAMPLES 100u

/* Intervals of the exact integral towards each end, each half of the next; and the steps of Romberg's rule in each. */
#define PARTS 12
#define ROWS  5

/* Two parameters after the control values x[0..11]. */
static void parameters(random_source *r, float *x)
{
    x[12] = random_unit(r);
    x[13] = random_unit(r);
}

/* A Bezier segment whose control points advance in x, so that it does not stand still. */
static void advancing(random_source *r, float *x)
{
    for (int i = 0; i < 4; i++) {
        x[3 * i] = (float)i + random_between(r, -0.25f, 0.25f);
        x[3 * i + 1] = random_between(r, -1.0f, 1.0f);
        x[3 * i + 2] = random_between(r, -1.0f, 1.0f);
    }
    parameters(r, x);
}

/* Control points on a line, in any order. */
static void on_a_line(random_source *r, float *x)
{
    nkw_vec3 axis = {0.0f, 1.0f, 0.0f}, direction = random_unit(r) < 0.5f ? axis : random_direction(r);
    for (int i = 0; i < 4; i++)
        put_vec3(x + 3 * i, nkw_vec3_scale(direction, random_between(r, -1.0f, 1.0f)));
    parameters(r, x);
}

/* The same with multiples of 1/2, and beside the line by 2^-28 to 1/16. */
static void beside_a_line(random_source *r, float *x)
{
    float beside = random_log(r, 0x1p-28f, 0x1p-4f);
    for (int i = 0; i < 4; i++) {
        x[3 * i] = 0.5f * (float)(int)random_between(r, 0.0f, 16.0f);
        x[3 * i + 1] = random_between(r, -beside, beside);
        x[3 * i + 2] = 0.0f;
    }
    parameters(r, x);
}

/* p' = (t - s) (a + b t): a cusp. */
static void with_a_cusp(random_source *r, float *x)
{
    nkw_vec3 a = random_vec3(r, -1.0f, 1.0f), b = random_vec3(r, -1.0f, 1.0f), zero = {0.0f, 0.0f, 0.0f};
    float s = random_unit(r);
    nkw_vec3 d0 = nkw_vec3_scale(a, -s / 3.0f), d2 = nkw_vec3_scale(nkw_vec3_add(a, b), (1.0f - s) / 3.0f);
    nkw_vec3 f = nkw_vec3_add(nkw_vec3_scale(a, 0.5f - s), nkw_vec3_scale(b, 1.0f / 3.0f - 0.5f * s));
    put_vec3(x, zero);
    put_vec3(x + 3, d0);
    put_vec3(x + 6, nkw_vec3_sub(f, d2));
    put_vec3(x + 9, f);
    parameters(r, x);
}

/* Equal control points at one end or at both, so that the segment stands still there. */
static void standing_still(random_source *r, float *x)
{
    advancing(r, x);
    int ends = 1 + (int)(random_bits(r) % 3);
    for (int i = 0; i < 3; i++) {
        x[3 + i] = ends & 1 ? x[i] : x[3 + i];
        x[6 + i] = ends & 2 ? x[9 + i] : x[6 + i];
    }
}

static nkw_vec3_cubic cubic_of(const float *x)
{
    nkw_vec3_cubic c;
    for (int i = 0; i < 4; i++)
        c.c[i] = vec3_at(x + 3 * i);
    return c;
}

/* The differences of the control points of a Bezier segment, a component. */
static void differences(const float *x, int i, wide d[3])
{
    for (int k = 0; k < 3; k++)
        d[k] = (wide)x[3 * k + 3 + i] - x[3 * k + i];
}

static wide speed(const float *x, wide t)
{
    wide s = 1 - t, v[3];
    for (int i = 0; i < 3; i++) {
        wide d[3];
        differences(x, i, d);
        v[i] = 3 * (s * s * d[0] + 2 * s * t * d[1] + t * t * d[2]);
    }
    return wide_length(v, 3);
}

/* Romberg's extrapolation of the trapezoidal rule. */
static wide romberg(const float *x, wide a, wide b)
{
    wide row[ROWS], h = b - a;
    row[0] = h * (speed(x, a) + speed(x, b)) / 2;
    for (int n = 1; n < ROWS; n++) {
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
    return row[ROWS - 1];
}

/* In intervals that shrink towards both ends. */
static wide between(const float *x, wide a, wide b)
{
    wide sum = 0, h = (b - a) / 2;
    for (int i = 0; i < PARTS; i++, h /= 2)
        sum += romberg(x, a + h / 2, a + h) + romberg(x, b - h, b - h / 2);
    return sum + romberg(x, a, a + h) + romberg(x, b - h, b);
}

/* Adds the zeros in low..high of a component of p', and of its derivative, to the places at. Returns their number. */
static int zeros_of(const wide d[3], wide low, wide high, wide *at)
{
    wide a = d[0] - 2 * d[1] + d[2], b = d[1] - d[0], c = d[0], e = b * b - a * c, t[3];
    wide q = -(b + (b < 0 ? -1 : 1) * sqrtq(e > 0 ? e : 0));
    int count = 0;
    t[0] = e >= 0 && a != 0 ? q / a : low;
    t[1] = e >= 0 && q != 0 ? c / q : low;
    t[2] = a != 0 ? -b / a : low;
    for (int i = 0; i < 3; i++)
        if (t[i] > low && t[i] < high)
            at[count++] = t[i];
    return count;
}

static int ascending(const void *a, const void *b)
{
    wide x, y;
    memcpy(&x, a, sizeof x);
    memcpy(&y, b, sizeof y);
    return (x > y) - (x < y);
}

/* Each component of p' keeps its sign in the intervals that are integrated. */
static wide exact_length(const float *x, wide from, wide to)
{
    wide at[11], low = from < to ? from : to, high = from < to ? to : from, sum = 0;
    int count = 0;
    at[count++] = low;
    for (int i = 0; i < 3; i++) {
        wide d[3];
        differences(x, i, d);
        count += zeros_of(d, low, high, at + count);
    }
    at[count++] = high;
    qsort(at, (size_t)count, sizeof *at, ascending);
    for (int i = 0; i + 1 < count; i++)
        sum += at[i + 1] > at[i] ? between(x, at[i], at[i + 1]) : 0;
    return from < to ? sum : -sum;
}

/* The length of the control polygon. */
static wide polygon(const float *x)
{
    wide sum = 0, v[3];
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++)
            v[i] = (wide)x[3 * k + 3 + i] - x[3 * k + i];
        sum += wide_length(v, 3);
    }
    return sum;
}

static double length_error(const float *x)
{
    nkw_vec3_cubic c = cubic_of(x);
    float got = nkw_vec3_cubic_length(&c, x[12], x[13], NKW_CUBIC_BEZIER);
    wide exact = exact_length(x, x[12], x[13]), size = fabsq(exact), least = polygon(x) * 0x1p-16f;
    return wide_error_of(&got, &exact, 1, size > least ? size : least);
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
    nkw_segment at = nkw_polycurve_at_length(&curve, lengths, NKW_POLYCURVE_LENGTHS(curve.count, steps), length);
    wide off = fabsq(exact_length(x, 0, at.t) - length), whole = exact_length(x, 0, 1);
    wide rounding = speed(x, at.t) * (nextafterf(at.t, 2.0f) - at.t) / 2;
    return (double)((off > rounding ? off - rounding : 0) / whole * 0x1p24f);
}

/* A velocity and an acceleration that are not nearly parallel. */
static void bent(random_source *r, float *x)
{
    put_vec3(x, random_vec3(r, -1.0f, 1.0f));
    put_vec3(x + 3, random_vec3(r, -1.0f, 1.0f));
}

/* The largest of the errors of the vectors of a frame for these derivatives; 0 where they are nearly parallel. */
static double frame_error(const nkw_curve_frame *f, wide v[3], wide a[3])
{
    wide b[3], n[3];
    wide_cross(v, a, b);
    if (!(wide_length(b, 3) * 8 >= wide_length(v, 3) * wide_length(a, 3)))
        return 0.0;
    wide_normalize(v, 3);
    wide_normalize(b, 3);
    wide_cross(b, v, n);
    return fmax(wide_error(&f->tangent.x, v, 3),
                fmax(wide_error(&f->normal.x, n, 3), wide_error(&f->binormal.x, b, 3)));
}

static double frenet_error(const float *x)
{
    wide v[3], a[3];
    nkw_vec3_motion p = {{0, 0, 0}, vec3_at(x), vec3_at(x + 3)};
    nkw_vec3 up = {0, 0, 1};
    nkw_curve_frame f = nkw_curve_frame_frenet(&p, up);
    wide_from(x, v, 3);
    wide_from(x + 3, a, 3);
    return frame_error(&f, v, a);
}

/* At rest at an end, and there. */
static void at_rest(random_source *r, float *x)
{
    standing_still(r, x);
    x[12] = x[0] == x[3] && x[1] == x[4] ? 0.0f : 1.0f;
}

static double place_frame_error(const float *x)
{
    nkw_vec3_cubic c = cubic_of(x);
    nkw_polycurve curve = {&c, 1, NKW_CUBIC_BEZIER};
    nkw_segment at = {0, x[12]};
    nkw_vec3 up = {0, 0, 1};
    nkw_curve_frame f = nkw_polycurve_frenet(&curve, at, up);
    wide v[3], a[3], third[3], t = x[12], s = 1 - t, side = t < 1 ? 1 : -1;
    for (int i = 0; i < 3; i++) {
        wide d[3];
        differences(x, i, d);
        v[i] = s * s * d[0] + 2 * s * t * d[1] + t * t * d[2];
        a[i] = 2 * (s * (d[1] - d[0]) + t * (d[2] - d[1]));
        third[i] = 2 * side * (d[2] - 2 * d[1] + d[0]);
    }
    if (wide_length(v, 3) > 0)
        return frame_error(&f, v, a);
    wide_scale(a, side, 3);
    return frame_error(&f, a, third);
}

static const wide_case lengths[] = {
    {"nkw_vec3_cubic_length", "Bezier, advancing", advancing, length_error, 14, WIDE_CHECKED},
    {"nkw_vec3_cubic_length", "Bezier, on a line", on_a_line, length_error, 14, WIDE_CHECKED},
    {"nkw_vec3_cubic_length", "Bezier, beside a line", beside_a_line, length_error, 14, WIDE_CHECKED},
    {"nkw_vec3_cubic_length", "Bezier, with a cusp", with_a_cusp, length_error, 14, WIDE_CHECKED},
    {"nkw_vec3_cubic_length", "Bezier, at rest at an end", standing_still, length_error, 14, WIDE_CHECKED},
    {"nkw_polycurve_at_length", "Bezier, advancing, 1 and 4 steps", advancing, place_error, 14, WIDE_CHECKED},
    {"nkw_polycurve_at_length", "Bezier, on a line, 1 and 4 steps", on_a_line, place_error, 14, WIDE_CHECKED},
    {"nkw_polycurve_at_length", "Bezier, with a cusp, 1 and 4 steps", with_a_cusp, place_error, 14, WIDE_CHECKED},
};

static const wide_case frames[] = {
    {"nkw_curve_frame_frenet", "[-1, 1]", bent, frenet_error, 6, WIDE_CHECKED},
    {"nkw_polycurve_frenet", "Bezier, advancing", advancing, place_frame_error, 13, WIDE_CHECKED},
    {"nkw_polycurve_frenet", "Bezier, at rest there", at_rest, place_frame_error, 13, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("polycurve.h", argc, argv);
    wide_search(&a, lengths, sizeof lengths / sizeof lengths[0], SAMPLES);
    wide_search(&a, frames, sizeof frames / sizeof frames[0], 300 * SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
