/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/curve.h> against binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>

#define SAMPLES 75000u
#define FEWER   25000u

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

/* The bounds of nkw_cubic_weights, in u: the table of curve.h. */
static const double weight_bounds[4][3] = {{1.9, 3.3, 8.0}, {2.5, 7.1, 16.0}, {1.8, 1.9, 2.0}, {2.6, 4.5, 8.0}};

#define CURVE(name, kind)                                                                                              \
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
        nkw_weights got = nkw_cubic_weights(kind, 0, x[4]);                                                            \
        double worst = 0.0;                                                                                            \
        name##_exact(x[4], exact);                                                                                     \
        for (int i = 0; i < 4; i++)                                                                                    \
            worst = fmax(worst, wide_error_of(got.w + i, exact + i, 1, 1));                                            \
        return worst / weight_bounds[kind][0];                                                                         \
    }

CURVE(hermite, NKW_CUBIC_HERMITE)
CURVE(bezier, NKW_CUBIC_BEZIER)
CURVE(bspline, NKW_CUBIC_BSPLINE)
CURVE(catmull_rom, NKW_CUBIC_CATMULL_ROM)

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

/* Only its ends are exact. */
static double bezier_promises(const float *x)
{
    return exactly(nkw_bezier(x[0], x[1], x[2], x[3], 0.0f), x[0], nkw_bezier(x[0], x[1], x[2], x[3], 1.0f), x[3], 0.0f,
                   0.0f);
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

/* The slope of the parabola. */
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
    float through[4];
    nkw_cubic_from_catmull_rom(x, x + 5, through);
    float got = nkw_hermite(through[0], through[1], through[2], through[3], x[4]),
          tangents[2] = {(float)c[1], (float)c[3]};
    hermite_exact(x[4], w);
    wide exact = wide_dot(w, c, 4), size = largest(x, 4), steep = largest(tangents, 2);
    return wide_error_of(&got, &exact, 1, size > steep ? size : steep);
}

/* ---- Derivatives of the weights, absolute ---- */

/* Six times the coefficients of 1, t, t^2, t^3 of the four weights. */
typedef const int monomials[4][4];

static monomials hermite_monomials = {{6, 0, -18, 12}, {0, 6, -12, 6}, {0, 0, 18, -12}, {0, 0, -6, 6}};
static monomials bezier_monomials = {{6, -18, 18, -6}, {0, 18, -36, 18}, {0, 0, 18, -18}, {0, 0, 0, 6}};
static monomials bspline_monomials = {{1, -3, 3, -1}, {4, 0, -6, 3}, {1, 3, 3, -3}, {0, 0, 0, 1}};
static monomials catmull_rom_monomials = {{0, -3, 6, -3}, {6, 0, -15, 9}, {0, 3, 12, -9}, {0, 0, -3, 3}};

static double off_velocity(nkw_weights got, wide t, monomials m)
{
    double worst = 0.0;
    for (int i = 0; i < 4; i++) {
        wide exact = (m[i][1] + t * (2 * m[i][2] + t * (3 * m[i][3]))) / 6;
        worst = fmax(worst, wide_error_of(got.w + i, &exact, 1, 1));
    }
    return worst;
}

static double off_acceleration(nkw_weights got, wide t, monomials m)
{
    double worst = 0.0;
    for (int i = 0; i < 4; i++) {
        wide exact = (2 * m[i][2] + t * (6 * m[i][3])) / 6;
        worst = fmax(worst, wide_error_of(got.w + i, &exact, 1, 1));
    }
    return worst;
}

#define DERIVATIVE(name, kind)                                                                                         \
    static double name##_velocity_error(const float *x)                                                                \
    {                                                                                                                  \
        return off_velocity(nkw_cubic_weights(kind, 1, x[4]), x[4], name##_monomials) / weight_bounds[kind][1];        \
    }                                                                                                                  \
    static double name##_acceleration_error(const float *x)                                                            \
    {                                                                                                                  \
        return off_acceleration(nkw_cubic_weights(kind, 2, x[4]), x[4], name##_monomials) / weight_bounds[kind][2];    \
    }

DERIVATIVE(hermite, NKW_CUBIC_HERMITE)
DERIVATIVE(bezier, NKW_CUBIC_BEZIER)
DERIVATIVE(bspline, NKW_CUBIC_BSPLINE)
DERIVATIVE(catmull_rom, NKW_CUBIC_CATMULL_ROM)

/* A cubic of numbers, as the x of one of vectors. */
static nkw_vec3_cubic cubic_of(const float *x)
{
    nkw_vec3_cubic r = {{{x[0], 0, 0}, {x[1], 0, 0}, {x[2], 0, 0}, {x[3], 0, 0}}};
    return r;
}

/* ---- The weighted sum: four values, t, four weights ---- */

static void with_weights(float *x)
{
    nkw_weights w = nkw_cubic_weights(NKW_CUBIC_CATMULL_ROM, 0, x[4]);
    for (int i = 0; i < 4; i++)
        x[5 + i] = w.w[i];
}

static void weighed_uniform(random_source *r, float *x)
{
    uniform(r, x);
    with_weights(x);
}

static void weighed_near_base(random_source *r, float *x)
{
    near_base(r, x);
    with_weights(x);
}

static void weighed_scattered(random_source *r, float *x)
{
    scattered(r, x);
    for (int i = 5; i < 9; i++)
        x[i] = delta(r, 1e-3f, 1e3f);
}

/* Of |w0 c0| + |w1 c1| + |w2 c2| + |w3 c3|. */
static double weigh_error(const float *x)
{
    nkw_weights w = {{x[5], x[6], x[7], x[8]}};
    const nkw_vec3_cubic cubic = cubic_of(x);
    float got = nkw_vec3_cubic_sum(&cubic, w).x;
    wide exact = 0, size = 0;
    for (int i = 0; i < 4; i++) {
        wide term = (wide)x[i] * x[5 + i];
        exact += term;
        size += term < 0 ? -term : term;
    }
    return wide_error_of(&got, &exact, 1, size);
}

/* ---- The tangent: three values and two durations ---- */

static void with_durations(random_source *r, float *x)
{
    x[3] = random_log(r, 1e-3f, 10.0f);
    x[4] = random_log(r, 1e-3f, 10.0f);
}

static void tangent_uniform(random_source *r, float *x)
{
    uniform(r, x);
    with_durations(r, x);
}

static void tangent_scattered(random_source *r, float *x)
{
    scattered(r, x);
    with_durations(r, x);
}

static void tangent_near_base(random_source *r, float *x)
{
    near_base(r, x);
    with_durations(r, x);
}

/* Near a turning point: one slope as steep up as the other down. */
static void tangent_level(random_source *r, float *x)
{
    tangent_uniform(r, x);
    x[4] = x[3];
    x[2] = x[0] * (1.0f + random_scaled(r, -24, -4));
}

/* Of the larger of the slopes of both sides, times the duration. */
static double tangent_error(const float *x)
{
    const float keys[4] = {x[0], x[1], x[2], x[2]}, times[4] = {-x[3], 0, x[4], x[4]};
    float through[4];
    nkw_cubic_from_catmull_rom(keys, times, through);
    wide exact = tangent(x[0], x[1], x[2], x[3], x[4]) * x[4];
    wide d0 = ((wide)x[1] - x[0]) / x[3], d1 = ((wide)x[2] - x[1]) / x[4];
    d0 = d0 < 0 ? -d0 : d0;
    d1 = d1 < 0 ? -d1 : d1;
    return wide_error_of(through + 1, &exact, 1, (d0 > d1 ? d0 : d1) * x[4]);
}

/* ---- One kind in the terms of another; the two halves of a Bezier segment ---- */

static void to_bezier_from_hermite(const wide c[4], wide out[4])
{
    out[0] = c[0];
    out[1] = c[0] + c[1] / 3;
    out[2] = c[2] - c[3] / 3;
    out[3] = c[2];
}

static void to_hermite_from_bezier(const wide c[4], wide out[4])
{
    out[0] = c[0];
    out[1] = 3 * (c[1] - c[0]);
    out[2] = c[3];
    out[3] = 3 * (c[3] - c[2]);
}

static void to_bezier_from_bspline(const wide c[4], wide out[4])
{
    out[0] = (c[0] + 4 * c[1] + c[2]) / 6;
    out[1] = (2 * c[1] + c[2]) / 3;
    out[2] = (c[1] + 2 * c[2]) / 3;
    out[3] = (c[1] + 4 * c[2] + c[3]) / 6;
}

static void take_cubic(const nkw_vec3_cubic *from, float to[4])
{
    for (int i = 0; i < 4; i++)
        to[i] = from->c[i].x;
}

static void to_bspline_from_bezier(const wide c[4], wide out[4])
{
    out[0] = 6 * c[0] - 7 * c[1] + 2 * c[2];
    out[1] = 2 * c[1] - c[2];
    out[2] = 2 * c[2] - c[1];
    out[3] = 2 * c[1] - 7 * c[2] + 6 * c[3];
}

static void to_catmull_rom_from_bezier(const wide c[4], wide out[4])
{
    out[0] = c[3] - 6 * (c[1] - c[0]);
    out[1] = c[0];
    out[2] = c[3];
    out[3] = c[0] + 6 * (c[3] - c[2]);
}

static void to_bezier_from_catmull_rom(const wide c[4], wide out[4])
{
    out[0] = c[1];
    out[1] = c[1] + (c[2] - c[0]) / 6;
    out[2] = c[2] - (c[3] - c[1]) / 6;
    out[3] = c[2];
}

/* Of the largest control value of the two segments. */
#define CONVERSION(name, FROM, TO)                                                                                     \
    static double name##_error(const float *x)                                                                         \
    {                                                                                                                  \
        float got[4];                                                                                                  \
        nkw_vec3_cubic from = cubic_of(x), to = nkw_vec3_cubic_convert(&from, FROM, TO);                               \
        take_cubic(&to, got);                                                                                          \
        wide c[4], exact[4], size = largest(x, 4), far = largest(got, 4);                                              \
        double worst = 0.0;                                                                                            \
        wide_from(x, c, 4);                                                                                            \
        to_##name(c, exact);                                                                                           \
        for (int i = 0; i < 4; i++)                                                                                    \
            worst = fmax(worst, wide_error_of(got + i, exact + i, 1, far > size ? far : size));                        \
        return worst;                                                                                                  \
    }

CONVERSION(bezier_from_hermite, NKW_CUBIC_HERMITE, NKW_CUBIC_BEZIER)
CONVERSION(hermite_from_bezier, NKW_CUBIC_BEZIER, NKW_CUBIC_HERMITE)
CONVERSION(bezier_from_bspline, NKW_CUBIC_BSPLINE, NKW_CUBIC_BEZIER)
CONVERSION(bspline_from_bezier, NKW_CUBIC_BEZIER, NKW_CUBIC_BSPLINE)
CONVERSION(bezier_from_catmull_rom, NKW_CUBIC_CATMULL_ROM, NKW_CUBIC_BEZIER)
CONVERSION(catmull_rom_from_bezier, NKW_CUBIC_BEZIER, NKW_CUBIC_CATMULL_ROM)

static void cut(const wide c[4], wide t, wide left[4], wide right[4])
{
    wide s = 1 - t, ab = s * c[0] + t * c[1], bc = s * c[1] + t * c[2], cd = s * c[2] + t * c[3];
    left[0] = c[0];
    left[1] = ab;
    left[2] = s * ab + t * bc;
    right[1] = s * bc + t * cd;
    right[2] = cd;
    right[3] = c[3];
    left[3] = right[0] = s * left[2] + t * right[1];
}

/* The outer ends and the cut bit by bit. */
static double split_error(const float *x)
{
    nkw_vec3_cubic whole = cubic_of(x), halves[2];
    float left[4], right[4];
    wide c[4], before[4], after[4];
    double worst = 0.0;
    nkw_vec3_bezier_split(&whole, x[4], &halves[0], &halves[1]);
    take_cubic(&halves[0], left);
    take_cubic(&halves[1], right);
    wide_from(x, c, 4);
    cut(c, x[4], before, after);
    for (int i = 0; i < 4; i++) {
        worst = fmax(worst, wide_error_of(left + i, before + i, 1, largest(x, 4)));
        worst = fmax(worst, wide_error_of(right + i, after + i, 1, largest(x, 4)));
    }
    int promises = left[0] == x[0] && left[3] == right[0] && right[3] == x[3];
    return promises ? worst : HUGE_VAL;
}

#define BLOCKS(name, near, about)                                                                                      \
    {"nkw_" #name, "[-1, 1]", uniform, name##_error, 5, WIDE_CHECKED},                                                 \
        {"nkw_" #name, "[-1, 1], t in 2^-30 .. 1", fine_t, name##_error, 5, WIDE_CHECKED},                             \
        {"nkw_" #name, "1e4 .. 1e6 + 1e-3 .. 1", near, name##_error, 5, WIDE_CHECKED},                                 \
        {"nkw_" #name, "1e4 .. 1e6 + 1 .. 100", about, name##_error, 5, WIDE_CHECKED},                                 \
        {"nkw_" #name, "magnitudes 1e-3 .. 1e3", scattered, name##_error, 5, WIDE_CHECKED},                            \
        {"nkw_" #name, "ends and constants, bit for bit", scattered, name##_promises, 5, WIDE_CHECKED},                \
        {"nkw_" #name, "1e4 .. 1e6 + 1e-3 .. 1, ULP", near, name##_ulps, 5, WIDE_NOTED},                               \
        {"nkw_" #name, "1e4 .. 1e6 + 1 .. 100, ULP", about, name##_ulps, 5, WIDE_NOTED},                               \
        {"nkw_" #name, "t in [-1, 2]", beyond, name##_error, 5, WIDE_NOTED},                                           \
        {"nkw_cubic_weights", #name ", t in 2^-30 .. 1", fine_t, name##_weights_error, 5, WIDE_CHECKED},               \
    {                                                                                                                  \
        "nkw_cubic_weights", #name ", t in [0, 1)", uniform, name##_weights_error, 5, WIDE_CHECKED                     \
    }

static const wide_case cases[] = {
    BLOCKS(hermite, hermite_near_base, hermite_about_base),
    BLOCKS(bezier, near_base, about_base),
    BLOCKS(bspline, near_base, about_base),
    BLOCKS(catmull_rom, near_base, about_base),
    {"nkw_cubic_from_catmull_rom", "nkw_hermite of it, [-1, 1]", timed, timed_error, 9, WIDE_CHECKED},
    {"nkw_cubic_from_catmull_rom", "nkw_hermite of it, magnitudes 1e-3 .. 1e3", timed_scattered, timed_error, 9,
     WIDE_CHECKED},
    {"nkw_cubic_from_catmull_rom", "nkw_hermite of it, 1e4 .. 1e6 + 1 .. 100", timed_about_base, timed_error, 9,
     WIDE_CHECKED},
};

#define DERIVATIVES(name)                                                                                                \
    {                                                                                                                    \
        "nkw_cubic_weights", #name ", first derivative, t in 2^-30 .. 1", fine_t, name##_velocity_error, 5,              \
        WIDE_CHECKED},                                                                                                   \
        {"nkw_cubic_weights", #name ", first derivative, t in [0, 1)", uniform, name##_velocity_error, 5, WIDE_CHECKED}, \
        {"nkw_cubic_weights", #name ", second derivative, t in 2^-30 .. 1", fine_t, name##_acceleration_error, 5,        \
         WIDE_CHECKED},                                                                                                  \
    {                                                                                                                    \
        "nkw_cubic_weights", #name ", second derivative, t in [0, 1)", uniform, name##_acceleration_error, 5,            \
            WIDE_CHECKED                                                                                                 \
    }

#define CONVERSIONS(name, text)                                                                                        \
    {"nkw_vec3_cubic_convert", text ", [-1, 1]", uniform, name##_error, 4, WIDE_CHECKED},                              \
        {"nkw_vec3_cubic_convert", text ", 1e4 .. 1e6 + 1e-3 .. 1", near_base, name##_error, 4, WIDE_CHECKED},         \
    {                                                                                                                  \
        "nkw_vec3_cubic_convert", text ", magnitudes 1e-3 .. 1e3", scattered, name##_error, 4, WIDE_CHECKED            \
    }

#define TANGENT "nkw_cubic_from_catmull_rom"

static const wide_case others[] = {
    DERIVATIVES(hermite),
    DERIVATIVES(bezier),
    DERIVATIVES(bspline),
    DERIVATIVES(catmull_rom),
    {"nkw_vec3_cubic_sum", "Catmull-Rom, [-1, 1]", weighed_uniform, weigh_error, 9, WIDE_CHECKED},
    {"nkw_vec3_cubic_sum", "Catmull-Rom, 1e4 .. 1e6 + 1e-3 .. 1", weighed_near_base, weigh_error, 9, WIDE_CHECKED},
    {"nkw_vec3_cubic_sum", "both of magnitudes 1e-3 .. 1e3", weighed_scattered, weigh_error, 9, WIDE_CHECKED},
    {TANGENT, "the tangent, [-1, 1], 1e-3 .. 10 s", tangent_uniform, tangent_error, 5, WIDE_CHECKED},
    {TANGENT, "the tangent, magnitudes 1e-3 .. 1e3", tangent_scattered, tangent_error, 5, WIDE_CHECKED},
    {TANGENT, "the tangent, 1e4 .. 1e6 + 1e-3 .. 1", tangent_near_base, tangent_error, 5, WIDE_CHECKED},
    {TANGENT, "the tangent, nearly level", tangent_level, tangent_error, 5, WIDE_CHECKED},
    CONVERSIONS(bezier_from_hermite, "Bezier from Hermite"),
    CONVERSIONS(hermite_from_bezier, "Hermite from Bezier"),
    CONVERSIONS(bezier_from_bspline, "Bezier from B-spline"),
    CONVERSIONS(bspline_from_bezier, "B-spline from Bezier"),
    CONVERSIONS(bezier_from_catmull_rom, "Bezier from Catmull-Rom"),
    CONVERSIONS(catmull_rom_from_bezier, "Catmull-Rom from Bezier"),
    {"nkw_vec3_bezier_split", "[-1, 1]", uniform, split_error, 5, WIDE_CHECKED},
    {"nkw_vec3_bezier_split", "[-1, 1], t in 2^-30 .. 1", fine_t, split_error, 5, WIDE_CHECKED},
    {"nkw_vec3_bezier_split", "1e4 .. 1e6 + 1e-3 .. 1", near_base, split_error, 5, WIDE_CHECKED},
    {"nkw_vec3_bezier_split", "magnitudes 1e-3 .. 1e3", scattered, split_error, 5, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("curve.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    wide_search(&a, others, sizeof others / sizeof others[0], FEWER);
    curve_more(&a);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
