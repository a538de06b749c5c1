/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/spline.h> against binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>

#define SAMPLES 40000u
#define KEYS    5

/* Samples: five values, five times, tension, continuity, bias. The tangents of the key in the middle are measured. */

static void with_times(random_source *r, float *x)
{
    x[5] = random_between(r, -2.0f, 2.0f);
    for (int i = 6; i < 10; i++)
        x[i] = x[i - 1] + random_log(r, 0.01f, 1.0f);
    for (int i = 10; i < 13; i++)
        x[i] = random_between(r, -1.0f, 1.0f);
}

static void uniform(random_source *r, float *x)
{
    for (int i = 0; i < 5; i++)
        x[i] = random_between(r, -1.0f, 1.0f);
    with_times(r, x);
}

static void scattered(random_source *r, float *x)
{
    for (int i = 0; i < 5; i++) {
        float sign = random_sign(r);
        x[i] = sign * random_log(r, 1e-3f, 1e3f);
    }
    with_times(r, x);
}

static void near_base(random_source *r, float *x)
{
    float base = random_log(r, 1e4f, 1e6f);
    for (int i = 0; i < 5; i++)
        x[i] = base + random_log(r, 1e-3f, 1.0f);
    with_times(r, x);
}

static wide magnitude(wide x)
{
    return x < 0 ? -x : x;
}

/* The durations and slopes of the four segments. */
typedef struct segments {
    wide h[4], d[4];
} segments;

static segments segments_of(const float *x)
{
    segments s;
    for (int i = 0; i < 4; i++) {
        s.h[i] = (wide)x[6 + i] - x[5 + i];
        s.d[i] = ((wide)x[i + 1] - x[i]) / s.h[i];
    }
    return s;
}

static wide blend(wide w0, wide d0, wide w1, wide d1)
{
    return (w0 * d0 + w1 * d1) / (w0 + w1);
}

static wide akima(const wide *d, wide part)
{
    wide w0 = magnitude(d[3] - d[2]) + part * magnitude(d[3] + d[2]);
    wide w1 = magnitude(d[1] - d[0]) + part * magnitude(d[1] + d[0]);
    return w0 + w1 == 0 ? (d[1] + d[2]) / 2 : blend(w0, d[1], w1, d[2]);
}

/* The natural spline, by elimination without pivots. */
static wide c2(const segments *s)
{
    wide a[KEYS][KEYS + 1] = {{0}};
    for (int i = 0; i < KEYS; i++) {
        a[i][i] = 2;
        if (i == 0 || i == KEYS - 1) {
            a[i][i == 0 ? 1 : i - 1] = 1;
            a[i][KEYS] = 3 * s->d[i == 0 ? 0 : i - 1];
            continue;
        }
        wide l = s->h[i] / (s->h[i - 1] + s->h[i]);
        a[i][i - 1] = l;
        a[i][i + 1] = 1 - l;
        a[i][KEYS] = 3 * (l * s->d[i - 1] + (1 - l) * s->d[i]);
    }
    for (int i = 0; i < KEYS; i++)
        for (int j = 0; j < KEYS; j++) {
            wide factor = j == i ? 0 : a[j][i] / a[i][i];
            for (int k = 0; k <= KEYS; k++)
                a[j][k] -= factor * a[i][k];
        }
    return a[2][KEYS] / a[2][2];
}

/* Before the key; `after` the key for TCB. */
static wide exact_tangent(nkw_spline_method method, const segments *s, const float *x, int after)
{
    const wide *h = s->h, *d = s->d;
    wide t = x[10], c = after ? -(wide)x[11] : x[11], b = x[12];
    switch (method) {
    case NKW_SPLINE_CARDINAL:
        return (1 - t) * blend(h[1], d[1], h[2], d[2]);
    case NKW_SPLINE_TCB:
        return (1 - t) * ((1 - c) * (1 + b) * d[1] * h[1] + (1 + c) * (1 - b) * d[2] * h[2]) / (h[1] + h[2]);
    case NKW_SPLINE_PCHIP:
        return d[1] * d[2] > 0 ? 3 * (h[1] + h[2]) / ((2 * h[2] + h[1]) / d[1] + (h[2] + 2 * h[1]) / d[2]) : 0;
    case NKW_SPLINE_AKIMA:
        return akima(d, 0);
    case NKW_SPLINE_MAKIMA:
        return akima(d, 0.5);
    case NKW_SPLINE_C2:
        return c2(s);
    case NKW_SPLINE_CENTRIPETAL:
    case NKW_SPLINE_CHORDAL:
    case NKW_SPLINE_CATMULL_ROM:
    default:
        break;
    }
    return blend(h[2], d[1], h[1], d[2]);
}

/* Of the larger of the tangent and the slopes. */
static double tangent_error(nkw_spline_method method, const float *x)
{
    float in[KEYS], out[KEYS];
    NKW_STACK_WORK(work, NKW_SPLINE_WORK(KEYS));
    double worst = 0.0;
    nkw_tcb keys[KEYS] = {{0, 0, 0}, {0, 0, 0}, {x[10], x[11], x[12]}, {0, 0, 0}, {0, 0, 0}};
    nkw_spline spline = {x + 5, x, KEYS, 1, 1, method, NKW_SPLINE_ENDS_FREE, x[10], keys, NULL};
    nkw_tangent_span to = {in, out, 1};
    if (nkw_spline_tangents(&spline, to, NULL, work) != NKW_OK)
        return HUGE_VAL;
    segments s = segments_of(x);
    int all = method == NKW_SPLINE_C2 || method == NKW_SPLINE_AKIMA || method == NKW_SPLINE_MAKIMA;
    for (int after = 0; after < 2; after++) {
        wide exact = exact_tangent(method, &s, x, after), size = magnitude(exact);
        for (int i = all ? 0 : 1; i < (all ? 4 : 3); i++)
            size = magnitude(s.d[i]) > size ? magnitude(s.d[i]) : size;
        worst = fmax(worst, wide_error_of(after ? out + 2 : in + 2, &exact, 1, size > 0 ? size : 1));
    }
    return worst;
}

#define METHOD(name, method)                                                                                           \
    static double name##_error(const float *x)                                                                         \
    {                                                                                                                  \
        return tangent_error(method, x);                                                                               \
    }

METHOD(catmull_rom, NKW_SPLINE_CATMULL_ROM)
METHOD(cardinal, NKW_SPLINE_CARDINAL)
METHOD(tcb, NKW_SPLINE_TCB)
METHOD(pchip, NKW_SPLINE_PCHIP)
METHOD(akima, NKW_SPLINE_AKIMA)
METHOD(makima, NKW_SPLINE_MAKIMA)
METHOD(c2, NKW_SPLINE_C2)

/* Knots of three points of the plane: x[0..5]; alpha 0, 1/2 or 1 by x[6]. */
static void points(random_source *r, float *x)
{
    for (int i = 0; i < 6; i++) {
        float sign = random_sign(r);
        x[i] = sign * random_log(r, 1e-3f, 1e3f);
    }
    x[6] = random_unit(r);
}

static double knots_error(const float *x)
{
    float knots[3], alpha = x[6] < 0.25f ? 0.0f : x[6] < 0.625f ? 0.5f : 1.0f;
    nkw_spline spline = {NULL, x, 3, 2, 2, NKW_SPLINE_CATMULL_ROM, NKW_SPLINE_ENDS_FREE, 0, NULL, NULL};
    wide exact[3] = {0, 0, 0};
    nkw_spline_knots(&spline, alpha, knots);
    for (int i = 0; i < 2; i++) {
        wide d[2] = {(wide)x[2 * i + 2] - x[2 * i], (wide)x[2 * i + 3] - x[2 * i + 1]}, length = wide_length(d, 2);
        wide root = length;
        /* Newton's square root. */
        for (int n = 0; n < 200 && length > 0; n++)
            root = (root + length / root) / 2;
        exact[i + 1] = exact[i] + (alpha == 0.0f ? 1 : alpha == 1.0f ? length : root);
    }
    return fmax(wide_error_of(knots + 1, exact + 1, 1, exact[2]), wide_error_of(knots + 2, exact + 2, 1, exact[2]));
}

#define ROWS(name)                                                                                                     \
    {"nkw_spline_tangents", #name ", [-1, 1]", uniform, name##_error, 13, WIDE_CHECKED},                               \
        {"nkw_spline_tangents", #name ", magnitudes 1e-3 .. 1e3", scattered, name##_error, 13, WIDE_CHECKED},          \
    {                                                                                                                  \
        "nkw_spline_tangents", #name ", 1e4 .. 1e6 + 1e-3 .. 1", near_base, name##_error, 13, WIDE_CHECKED             \
    }

static const wide_case cases[] = {
    ROWS(catmull_rom), ROWS(cardinal),
    ROWS(tcb),         ROWS(pchip),
    ROWS(akima),       ROWS(makima),
    ROWS(c2),          {"nkw_spline_knots", "three points, alpha 0, 1/2, 1", points, knots_error, 7, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("spline.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
