/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/handle.h> against binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>

#define SAMPLES 30000u

/* x = time0, value0, out, in, time1, value1, time */
static nkw_handle_segment segment_at(const float *x)
{
    nkw_handle_segment s = {x[0], x[1], {x[2], x[3]}, {x[4], x[5]}, x[6], x[7]};
    return s;
}

/* ---- Samples: lengths of handles in units of the duration, then all numbers ---- */

static void place(random_source *r, float *x, float p, float q)
{
    x[0] = random_between(r, -10.0f, 10.0f);
    float h = random_log(r, 1e-3f, 10.0f);
    x[6] = x[0] + h;
    x[2] = p * h;
    x[4] = -q * h;
    x[1] = random_between(r, -1.0f, 1.0f);
    x[3] = random_between(r, -1.0f, 1.0f);
    x[5] = random_between(r, -1.0f, 1.0f);
    x[7] = random_between(r, -1.0f, 1.0f);
    x[8] = nkw_clamp(x[0] + h * random_unit(r), x[0], x[6]);
}

static void contained(random_source *r, float *x)
{
    float p = random_unit(r), q = random_unit(r);
    place(r, x, p, q);
}

/* Nearly vertical within the segment. */
static void steep(random_source *r, float *x)
{
    float p = 1.0f - random_log(r, 1e-7f, 1e-2f), q = 1.0f - random_log(r, 1e-7f, 1e-2f);
    place(r, x, p, q);
}

/* Vertical, or nearly, at the ends. */
static void short_handles(random_source *r, float *x)
{
    float p = random_log(r, 1e-9f, 1.0f), q = random_log(r, 1e-9f, 1.0f);
    place(r, x, p, q);
}

static void beyond(random_source *r, float *x)
{
    float p = random_between(r, -2.0f, 3.0f), q = random_between(r, -2.0f, 3.0f);
    place(r, x, p, q);
}

/* Large values with small differences. */
static void about_base(random_source *r, float *x)
{
    contained(r, x);
    float base = 1e4f * random_between(r, 1.0f, 100.0f);
    x[1] += base;
    x[7] += base;
}

/* ---- The exact curve ---- */

typedef struct exact {
    wide h, p, q, v[4];
} exact;

static exact exact_of(const float *x)
{
    exact e = {(wide)x[6] - x[0], x[2], -(wide)x[4], {x[1], (wide)x[1] + x[3], (wide)x[7] + x[5], x[7]}};
    return e;
}

static wide time_of(const exact *e, wide s)
{
    wide r = 1 - s;
    return 3 * e->p * s * r * r + 3 * (e->h - e->q) * s * s * r + e->h * s * s * s;
}

static wide value_of(const exact *e, wide s)
{
    wide r = 1 - s;
    return e->v[0] * r * r * r + 3 * e->v[1] * s * r * r + 3 * e->v[2] * s * s * r + e->v[3] * s * s * s;
}

/* The roots of the derivative of time, ascending, that are in 0..1. */
static int turns_of(const exact *e, wide turns[2])
{
    wide b = e->h - e->p - e->q, a = e->p - 2 * b + e->q, half = b - e->p, disc = b * b - e->p * e->q;
    int n = 0;
    if (disc <= 0 || a == 0)
        return 0;
    wide root = sqrtq(disc), low = (-half - root) / a, high = (-half + root) / a, swap = low;
    low = low < high ? low : high;
    high = swap < high ? high : swap;
    if (low > 0 && low < 1)
        turns[n++] = low;
    if (high > 0 && high < 1)
        turns[n++] = high;
    return n;
}

/* The least s with a time of x or more, in pieces where time is monotonic. */
static wide first_at(const exact *e, wide x)
{
    wide turns[2], low = 0, high = 1;
    int n = turns_of(e, turns);
    if (x <= 0)
        return 0;
    for (int i = 0; i <= n; i++) {
        high = i < n ? turns[i] : 1;
        if (time_of(e, high) >= x)
            break;
        low = high;
    }
    if (time_of(e, high) < x)
        return 1;
    for (int i = 0; i < 110; i++) {
        wide s = (low + high) / 2;
        if (time_of(e, s) < x)
            low = s;
        else
            high = s;
    }
    return high;
}

static wide magnitude(const exact *e)
{
    wide most = 0;
    for (int i = 0; i < 4; i++)
        most = fmaxq(most, fabsq(e->v[i]));
    return most;
}

/* Of the value, from the values that the curve has at times within 2^-48 of the longest of duration and handles. */
static double point_error(const float *x)
{
    nkw_handle_segment s = segment_at(x);
    exact e = exact_of(x);
    wide size = fmaxq(e.h, fmaxq(fabsq(e.p), fabsq(e.q))), time = (wide)x[8] - x[0], off = size * 0x1p-48;
    wide from = first_at(&e, time - off), to = first_at(&e, time + off), low = value_of(&e, from), high = low;
    float got = nkw_handle_sample(&s, x[8]).value;
    for (int i = 1; i <= 16; i++) {
        wide v = value_of(&e, from + (to - from) * i / 16);
        low = fminq(low, v);
        high = fmaxq(high, v);
    }
    wide nearest = (wide)got < low ? low : (wide)got > high ? high : (wide)got;
    return wide_error_of(&got, &nearest, 1, magnitude(&e));
}

/* The same at the very time. */
static double plain_error(const float *x)
{
    nkw_handle_segment s = segment_at(x);
    exact e = exact_of(x);
    float got = nkw_handle_sample(&s, x[8]).value;
    wide value = value_of(&e, first_at(&e, (wide)x[8] - x[0]));
    return wide_error_of(&got, &value, 1, magnitude(&e));
}

/* The derivative, of itself and of the largest difference of control values over the duration. */
static double first_error(const float *x)
{
    nkw_handle_segment c = segment_at(x);
    exact e = exact_of(x);
    wide s = first_at(&e, (wide)x[8] - x[0]), r = 1 - s, b = e.h - e.p - e.q;
    wide d[3] = {e.v[1] - e.v[0], e.v[2] - e.v[1], e.v[3] - e.v[2]}, most = 0;
    for (int i = 0; i < 3; i++)
        most = fmaxq(most, fabsq(d[i]) / e.h);
    wide want = (d[0] * r * r + 2 * d[1] * r * s + d[2] * s * s) / (e.p * r * r + 2 * b * r * s + e.q * s * s);
    float got = nkw_handle_sample(&c, x[8]).velocity;
    return wide_error_of(&got, &want, 1, fmaxq(most, fabsq(want)));
}

/* ---- Limits: the distance of the lengths from the ellipse of the policy ---- */

static double lengths_error(const nkw_handle_segment *s, wide p, wide q, wide h)
{
    float got[2] = {s->out.time, -s->in.time};
    wide want[2] = {p * h, q * h};
    return fmax(wide_error_of(got, want, 1, h), wide_error_of(got + 1, want + 1, 1, h));
}

static void long_handles(random_source *r, float *x)
{
    float p = random_between(r, 0.0f, 4.0f), q = random_between(r, 0.0f, 4.0f);
    place(r, x, p, q);
}

static double ratio_error(const float *x)
{
    nkw_handle_segment s = segment_at(x), limited = nkw_handle_limit(&s, NKW_HANDLE_KEEP_RATIO);
    exact e = exact_of(x);
    wide p = e.p / e.h, q = e.q / e.h, factor = (p + q + sqrtq(p * q)) / (p * p + p * q + q * q);
    factor = nkw_handle_runs_back(&s) ? factor : 1;
    return lengths_error(&limited, p * factor, q * factor, e.h);
}

static double start_error(const float *x)
{
    nkw_handle_segment s = segment_at(x), limited = nkw_handle_limit(&s, NKW_HANDLE_KEEP_START);
    exact e = exact_of(x);
    wide p = e.p / e.h, q = e.q / e.h, square = p * (4 - 3 * p), middle = (2 - p) / 2;
    if (!nkw_handle_runs_back(&s))
        return lengths_error(&limited, p, q, e.h);
    if (3 * p >= 4)
        return lengths_error(&limited, (wide)4 / 3, (wide)1 / 3, e.h);
    wide half = sqrtq(square) / 2;
    return lengths_error(&limited, p, q > middle ? middle + half : middle - half, e.h);
}

static const wide_case cases[] = {
    {"nkw_handle_sample", "handles within the segment", contained, point_error, 9, WIDE_CHECKED},
    {"nkw_handle_sample", "nearly vertical within the segment", steep, point_error, 9, WIDE_CHECKED},
    {"nkw_handle_sample", "nearly vertical at the ends", short_handles, point_error, 9, WIDE_CHECKED},
    {"nkw_handle_sample", "handles of -2 .. 3 durations", beyond, point_error, 9, WIDE_CHECKED},
    {"nkw_handle_sample", "values 1e4 .. 1e6 + [-1, 1]", about_base, point_error, 9, WIDE_CHECKED},
    {"nkw_handle_sample", "handles within, at the very time", contained, plain_error, 9, WIDE_NOTED},
    {"nkw_handle_sample", "first derivative, handles within", contained, first_error, 9, WIDE_NOTED},
    {"nkw_handle_limit", "KEEP_RATIO", long_handles, ratio_error, 9, WIDE_CHECKED},
    {"nkw_handle_limit", "KEEP_START", long_handles, start_error, 9, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("handle.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
