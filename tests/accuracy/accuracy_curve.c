/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/curve.h> against binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>

#define SAMPLES 300000u

/* ---- The four weights, from the monomials ---- */

typedef void exact_weights(wide t, wide w[4]);

static void hermite_exact(wide t, wide w[4])
{
    wide tt = t * t, ttt = tt * t;
    w[0] = 2 * ttt - 3 * tt + 1;
    w[1] = ttt - 2 * tt + t;
    w[2] = 3 * tt - 2 * ttt;
    w[3] = ttt - tt;
}

static void bezier_exact(wide t, wide w[4])
{
    wide s = 1 - t;
    w[0] = s * s * s;
    w[1] = 3 * s * s * t;
    w[2] = 3 * s * t * t;
    w[3] = t * t * t;
}

static void bspline_exact(wide t, wide w[4])
{
    wide s = 1 - t, tt = t * t, ttt = tt * t;
    w[0] = s * s * s / 6;
    w[1] = (3 * ttt - 6 * tt + 4) / 6;
    w[2] = (-3 * ttt + 3 * tt + 3 * t + 1) / 6;
    w[3] = ttt / 6;
}

static void catmull_rom_exact(wide t, wide w[4])
{
    wide tt = t * t, ttt = tt * t;
    w[0] = (-ttt + 2 * tt - t) / 2;
    w[1] = (3 * ttt - 5 * tt + 2) / 2;
    w[2] = (-3 * ttt + 4 * tt + t) / 2;
    w[3] = (ttt - tt) / 2;
}

static wide weighed(const float *c, exact_weights *weights, wide t)
{
    wide w[4], exact[4];
    weights(t, w);
    wide_from(c, exact, 4);
    return wide_dot(w, exact, 4);
}

/* ---- Samples: four control values (Hermite in the order p0 v0 p1 v1) and t ---- */

static void uniform(random_source *r, float *x)
{
    for (int i = 0; i < 4; i++)
        x[i] = random_between(r, -1.0f, 1.0f);
    x[4] = random_unit(r);
}

static void scattered(random_source *r, float *x)
{
    for (int i = 0; i < 4; i++) {
        float sign = random_sign(r);
        x[i] = sign * random_log(r, 1e-3f, 1e3f);
    }
    x[4] = random_unit(r);
}

static float delta(random_source *r, float low, float high)
{
    float sign = random_sign(r);
    return sign * random_log(r, low, high);
}

static void based(random_source *r, float *x, float low, float high)
{
    float base = delta(r, 1e4f, 1e6f);
    for (int i = 0; i < 4; i++)
        x[i] = base + delta(r, low, high);
    x[4] = random_unit(r);
}

static void near_base(random_source *r, float *x)
{
    based(r, x, 1e-3f, 1.0f);
}

static void about_base(random_source *r, float *x)
{
    based(r, x, 1.0f, 100.0f);
}

static void hermite_near_base(random_source *r, float *x)
{
    near_base(r, x);
    x[1] = delta(r, 1e-3f, 1.0f);
    x[3] = delta(r, 1e-3f, 1.0f);
}

static void hermite_about_base(random_source *r, float *x)
{
    about_base(r, x);
    x[1] = delta(r, 1.0f, 100.0f);
    x[3] = delta(r, 1.0f, 100.0f);
}

/* t of more than 24 bits after the point: 1 - t is rounded. */
static void fine_t(random_source *r, float *x)
{
    uniform(r, x);
    x[4] = fabsf(random_scaled(r, -30, 0));
}

static void beyond(random_source *r, float *x)
{
    uniform(r, x);
    x[4] = random_between(r, -1.0f, 2.0f);
}

static wide largest(const float *x, int n)
{
    float size = 0.0f;
    for (int i = 0; i < n; i++)
        size = fmaxf(size, fabsf(x[i]));
    return size;
}

/* ---- Values ---- */

static double units(float got, const float *x, exact_weights *weights)
{
    wide exact = weighed(x, weights, x[4]);
    return wide_error_of(&got, &exact, 1, largest(x, 4));
}

static double ulps(float got, const float *x, exact_weights *weights)
{
    return accuracy_ulps(got, (double)weighed(x, weights, x[4]));
}

#define CURVE(name)                                                                                                    \
    static double name##_error(const float *x)                                                                         \
    {                                                                                                                  \
        return units(nkw_##name(x[0], x[1], x[2], x[3], x[4]), x, name##_exact);                                       \
    }                                                                                                                  \
    static double name##_ulps(const float *x)                                                                          \
    {                                                                                                                  \
        return ulps(nkw_##name(x[0], x[1], x[2], x[3], x[4]), x, name##_exact);                                        \
    }                                                                                                                  \
    static double name##_weights_error(const float *x)                                                                 \
    {                                                                                                                  \
        wide exact[4];                                                                                                 \
        nkw_weights got = nkw_##name##_weights(x[4]);                                                                  \
        double worst = 0.0;                                                                                            \
        name##_exact(x[4], exact);                                                                                     \
        for (int i = 0; i < 4; i++)                                                                                    \
            worst = fmax(worst, wide_error_of(got.w + i, exact + i, 1, 1));                                            \
        return worst;                                                                                                  \
    }

CURVE(hermite)
CURVE(bezier)
CURVE(bspline)
CURVE(catmull_rom)

/* ---- Ends and constants come back bit by bit ---- */

static double exactly(float start, float a, float end, float b, float constant, float value)
{
    return start == a && end == b && constant == value ? 0.0 : HUGE_VAL;
}

static double hermite_promises(const float *x)
{
    return exactly(nkw_hermite(x[0], x[1], x[2], x[3], 0.0f), x[0], nkw_hermite(x[0], x[1], x[2], x[3], 1.0f), x[2],
                   nkw_hermite(x[0], 0.0f, x[0], 0.0f, x[4]), x[0]);
}

static double bezier_promises(const float *x)
{
    return exactly(nkw_bezier(x[0], x[1], x[2], x[3], 0.0f), x[0], nkw_bezier(x[0], x[1], x[2], x[3], 1.0f), x[3],
                   nkw_bezier(x[0], x[0], x[0], x[0], x[4]), x[0]);
}

static double bspline_promises(const float *x)
{
    float constant = nkw_bspline(x[0], x[0], x[0], x[0], x[4]);
    return exactly(0.0f, 0.0f, 0.0f, 0.0f, constant, x[0]);
}

static double catmull_rom_promises(const float *x)
{
    return exactly(nkw_catmull_rom(x[0], x[1], x[2], x[3], 0.0f), x[1], nkw_catmull_rom(x[0], x[1], x[2], x[3], 1.0f),
                   x[2], nkw_catmull_rom(x[0], x[0], x[0], x[0], x[4]), x[0]);
}

/* ---- Uneven times: x[5..8] ---- */

static void timed(random_source *r, float *x)
{
    uniform(r, x);
    x[5] = random_between(r, 0.0f, 10.0f);
    for (int i = 6; i < 9; i++)
        x[i] = x[i - 1] + random_log(r, 0.01f, 1.0f);
}

static void timed_scattered(random_source *r, float *x)
{
    timed(r, x);
    float t = x[4];
    scattered(r, x);
    x[4] = t;
}

static void timed_about_base(random_source *r, float *x)
{
    timed(r, x);
    float t = x[4];
    about_base(r, x);
    x[4] = t;
}

static wide tangent(wide p0, wide p1, wide p2, wide h0, wide h1)
{
    return ((p1 - p0) / h0 * h1 + (p2 - p1) / h1 * h0) / (h0 + h1);
}

static double timed_error(const float *x)
{
    wide p[4], t[4], w[4];
    wide_from(x, p, 4);
    wide_from(x + 5, t, 4);
    wide h0 = t[1] - t[0], h1 = t[2] - t[1], h2 = t[3] - t[2];
    wide c[4] = {p[1], tangent(p[0], p[1], p[2], h0, h1) * h1, p[2], tangent(p[1], p[2], p[3], h1, h2) * h1};
    float got = nkw_catmull_rom_timed(x + 5, x[0], x[1], x[2], x[3], x[4]), tangents[2] = {(float)c[1], (float)c[3]};
    hermite_exact(x[4], w);
    wide exact = wide_dot(w, c, 4), size = largest(x, 4), steep = largest(tangents, 2);
    return wide_error_of(&got, &exact, 1, size > steep ? size : steep);
}

#define BLOCKS(name, near, about)                                                                                      \
    {"nkw_" #name, "[-1, 1]", uniform, name##_error, 5, WIDE_CHECKED},                                                 \
        {"nkw_" #name, "[-1, 1], t in 2^-30 .. 1", fine_t, name##_error, 5, WIDE_CHECKED},                             \
        {"nkw_" #name, "1e4 .. 1e6 + 1e-3 .. 1", near, name##_error, 5, WIDE_CHECKED},                                 \
        {"nkw_" #name, "1e4 .. 1e6 + 1 .. 100", about, name##_error, 5, WIDE_CHECKED},                                 \
        {"nkw_" #name, "magnitudes 1e-3 .. 1e3", scattered, name##_error, 5, WIDE_CHECKED},                            \
        {"nkw_" #name, "ends and constants, bit by bit", scattered, name##_promises, 5, WIDE_CHECKED},                 \
        {"nkw_" #name, "1e4 .. 1e6 + 1e-3 .. 1, ULP", near, name##_ulps, 5, WIDE_NOTED},                               \
        {"nkw_" #name, "1e4 .. 1e6 + 1 .. 100, ULP", about, name##_ulps, 5, WIDE_NOTED},                               \
        {"nkw_" #name, "t in [-1, 2]", beyond, name##_error, 5, WIDE_NOTED},                                           \
        {"nkw_" #name "_weights", "t in 2^-30 .. 1", fine_t, name##_weights_error, 5, WIDE_CHECKED},                   \
    {                                                                                                                  \
        "nkw_" #name "_weights", "t in [0, 1)", uniform, name##_weights_error, 5, WIDE_CHECKED                         \
    }

static const wide_case cases[] = {
    BLOCKS(hermite, hermite_near_base, hermite_about_base),
    BLOCKS(bezier, near_base, about_base),
    BLOCKS(bspline, near_base, about_base),
    BLOCKS(catmull_rom, near_base, about_base),
    {"nkw_catmull_rom_timed", "[-1, 1]", timed, timed_error, 9, WIDE_CHECKED},
    {"nkw_catmull_rom_timed", "magnitudes 1e-3 .. 1e3", timed_scattered, timed_error, 9, WIDE_CHECKED},
    {"nkw_catmull_rom_timed", "1e4 .. 1e6 + 1 .. 100", timed_about_base, timed_error, 9, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("curve.h", argc, argv);
    wide_run(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
