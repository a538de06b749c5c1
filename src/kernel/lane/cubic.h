/* SPDX-License-Identifier: MIT */
/* Cubic curves on one component. */
#ifndef NAKAWARI_LANE_CUBIC_H
#define NAKAWARI_LANE_CUBIC_H

#include "strict.h"

#include <nakawari/curve.h>

/*
 * The kinds of cubics, a row each: the name in nkw_cubic_kind, the name in its formulas, and which control values are its
 * ends at t = 0 and 1 (of a B-spline none: they are means of three, and these are the first of them).
 *
 * A new kind is an enumerator, a row, nkw_NAME of one number, and here lane_NAME_weights, _velocity_weights,
 * _acceleration_weights, _slopes, lane_bezier_from_NAME and lane_NAME_from_bezier. A switch over the rows without a `default` does not compile without its row.
 */
#define LANE_CUBICS(X)                                                                                                 \
    X(HERMITE, hermite, 0, 2)                                                                                          \
    X(BEZIER, bezier, 0, 3)                                                                                            \
    X(BSPLINE, bspline, 0, 1)                                                                                          \
    X(CATMULL_ROM, catmull_rom, 1, 2)

/*
 * The weights of p0, v0, p1, v1, s = 1 - t, tangents per segment. The text that computes a value, nkw_hermite_from,
 * does not multiply p0 and p1 by them, because their sum is 1: with f = p1 - p0 and v = f + (v - f),
 *
 *     (1 + 2 t) s^2 p0 + t s^2 v0 + (1 + 2 s) t^2 p1 - s t^2 v1
 *         = p0 + t^2 (3 - 2 t) f + t s^2 v0 - s t^2 v1
 *         = p0 + t f + t s k,      k = s (v0 - f) - t (v1 - f)
 *         = p1 - s f + t s k       by p0 = p1 - f
 */
static inline nkw_weights lane_hermite_weights(float t)
{
    float s = 1.0f - t;
    nkw_weights r = {{(1.0f + 2.0f * t) * (s * s), t * (s * s), (1.0f + 2.0f * s) * (t * t), -s * (t * t)}};
    return r;
}

static inline nkw_weights lane_hermite_velocity_weights(float t)
{
    float s = 1.0f - t;
    nkw_weights r = {{-6.0f * (t * s), (s - 2.0f * t) * s, 6.0f * (t * s), (t - 2.0f * s) * t}};
    return r;
}

static inline nkw_weights lane_hermite_acceleration_weights(float t)
{
    nkw_weights r = {{12.0f * t - 6.0f, 6.0f * t - 4.0f, 6.0f - 12.0f * t, 6.0f * t - 2.0f}};
    return r;
}

static inline nkw_weights lane_bezier_weights(float t)
{
    return nkw_bezier_weights(t);
}

static inline nkw_weights lane_bezier_velocity_weights(float t)
{
    float s = 1.0f - t;
    nkw_weights r = {{-3.0f * (s * s), 3.0f * s * (s - 2.0f * t), 3.0f * t * (2.0f * s - t), 3.0f * (t * t)}};
    return r;
}

static inline nkw_weights lane_bezier_acceleration_weights(float t)
{
    nkw_weights r = {{6.0f * (1.0f - t), 18.0f * t - 12.0f, 6.0f - 18.0f * t, 6.0f * t}};
    return r;
}

static inline nkw_weights lane_bspline_weights(float t)
{
    float s = 1.0f - t, ss = s * s, tt = t * t;
    nkw_weights r = {{
        (s * ss) / 6.0f,
        (4.0f + 3.0f * tt * (t - 2.0f)) / 6.0f,
        (4.0f + 3.0f * ss * (s - 2.0f)) / 6.0f,
        (t * tt) / 6.0f,
    }};
    return r;
}

static inline nkw_weights lane_bspline_velocity_weights(float t)
{
    float s = 1.0f - t;
    nkw_weights r = {{-0.5f * (s * s), -0.5f * t * (4.0f * s + t), 0.5f * s * (s + 4.0f * t), 0.5f * (t * t)}};
    return r;
}

static inline nkw_weights lane_bspline_acceleration_weights(float t)
{
    nkw_weights r = {{1.0f - t, 3.0f * t - 2.0f, 1.0f - 3.0f * t, t}};
    return r;
}

static inline nkw_weights lane_catmull_rom_weights(float t)
{
    float s = 1.0f - t, ss = s * s, tt = t * t;
    nkw_weights r = {{
        -0.5f * (t * ss),
        s * ((1.0f + t) - 1.5f * tt),
        t * ((1.0f + s) - 1.5f * ss),
        -0.5f * (tt * s),
    }};
    return r;
}

static inline nkw_weights lane_catmull_rom_velocity_weights(float t)
{
    float s = 1.0f - t;
    nkw_weights r = {{
        0.5f * s * (2.0f * t - s),
        -0.5f * t * (10.0f * s + t),
        0.5f * s * (s + 10.0f * t),
        0.5f * t * (t - 2.0f * s),
    }};
    return r;
}

static inline nkw_weights lane_catmull_rom_acceleration_weights(float t)
{
    nkw_weights r = {{2.0f - 3.0f * t, 9.0f * t - 5.0f, 4.0f - 9.0f * t, 3.0f * t - 1.0f}};
    return r;
}

static inline float lane_weigh(nkw_weights k, float c0, float c1, float c2, float c3)
{
    return (k.w[0] * c0 + k.w[1] * c1) + (k.w[2] * c2 + k.w[3] * c3);
}

/* The slope at p1 of the parabola through three points; see nkw_cubic_from_catmull_rom. */
static inline float lane_catmull_rom_tangent(float p0, float p1, float p2, float h0, float h1)
{
    double a = h0 > 0.0f ? h0 : 0.0, b = h1 > 0.0f ? h1 : 0.0;
    double d0 = ((double)p1 - (double)p0) / (a > 0.0 ? a : 1.0);
    double d1 = ((double)p2 - (double)p1) / (b > 0.0 ? b : 1.0);
    /* Without a duration on one side all weight goes to the other; without any there is no slope. */
    double w0 = a > 0.0 ? (b > 0.0 ? b : 1.0) : 0.0;
    double w1 = b > 0.0 ? (a > 0.0 ? a : 1.0) : 0.0;
    return (float)((d0 * w0 + d1 * w1) / (w0 + w1 > 0.0 ? w0 + w1 : 1.0));
}

/* Conversions between the kinds, see nkw_vec3_cubic_convert: in binary64, each value rounded once. */
typedef struct lane_f64_cubic {
    double c[4];
} lane_f64_cubic;

static inline lane_f64_cubic lane_bezier_from_bezier(lane_f64_cubic b)
{
    return b;
}

static inline lane_f64_cubic lane_bezier_from_hermite(lane_f64_cubic h)
{
    const double *c = h.c;
    lane_f64_cubic r = {{c[0], c[0] + c[1] / 3.0, c[2] - c[3] / 3.0, c[2]}};
    return r;
}

static inline lane_f64_cubic lane_hermite_from_bezier(lane_f64_cubic b)
{
    const double *c = b.c;
    lane_f64_cubic r = {{c[0], 3.0 * (c[1] - c[0]), c[3], 3.0 * (c[3] - c[2])}};
    return r;
}

static inline lane_f64_cubic lane_bezier_from_bspline(lane_f64_cubic d)
{
    const double *c = d.c;
    lane_f64_cubic r = {{
        ((c[0] + 4.0 * c[1]) + c[2]) / 6.0,
        (2.0 * c[1] + c[2]) / 3.0,
        (c[1] + 2.0 * c[2]) / 3.0,
        ((c[1] + 4.0 * c[2]) + c[3]) / 6.0,
    }};
    return r;
}

static inline lane_f64_cubic lane_bspline_from_bezier(lane_f64_cubic b)
{
    const double *c = b.c;
    lane_f64_cubic r = {{
        (6.0 * c[0] - 7.0 * c[1]) + 2.0 * c[2],
        2.0 * c[1] - c[2],
        2.0 * c[2] - c[1],
        2.0 * c[1] + (6.0 * c[3] - 7.0 * c[2]),
    }};
    return r;
}

static inline lane_f64_cubic lane_bezier_from_catmull_rom(lane_f64_cubic p)
{
    const double *c = p.c;
    lane_f64_cubic r = {{c[1], c[1] + (c[2] - c[0]) / 6.0, c[2] - (c[3] - c[1]) / 6.0, c[2]}};
    return r;
}

static inline lane_f64_cubic lane_catmull_rom_from_bezier(lane_f64_cubic b)
{
    const double *c = b.c;
    lane_f64_cubic r = {{c[3] - 6.0 * (c[1] - c[0]), c[0], c[3], c[0] + 6.0 * (c[3] - c[2])}};
    return r;
}

/* The differences that determine a cubic segment except its place: p(1) - p(0), and the tangents at its ends. */
typedef struct lane_f64_slopes {
    double f, v0, v1;
} lane_f64_slopes;

static inline lane_f64_slopes lane_hermite_slopes(const float c[4])
{
    lane_f64_slopes r = {(double)c[2] - (double)c[0], c[1], c[3]};
    return r;
}

static inline lane_f64_slopes lane_bezier_slopes(const float c[4])
{
    lane_f64_slopes r = {(double)c[3] - (double)c[0], 3.0 * ((double)c[1] - (double)c[0]),
                         3.0 * ((double)c[3] - (double)c[2])};
    return r;
}

static inline lane_f64_slopes lane_bspline_slopes(const float c[4])
{
    double d0 = (double)c[1] - (double)c[0], d1 = (double)c[2] - (double)c[1], d2 = (double)c[3] - (double)c[2];
    lane_f64_slopes r = {((d0 + 4.0 * d1) + d2) / 6.0, 0.5 * (d0 + d1), 0.5 * (d1 + d2)};
    return r;
}

static inline lane_f64_slopes lane_catmull_rom_slopes(const float c[4])
{
    double d0 = (double)c[1] - (double)c[0], d1 = (double)c[2] - (double)c[1], d2 = (double)c[3] - (double)c[2];
    lane_f64_slopes r = {d1, 0.5 * (d0 + d1), 0.5 * (d1 + d2)};
    return r;
}

static inline lane_f64_slopes lane_slopes_of(nkw_cubic_kind kind, const float c[4])
{
    switch (kind) {
#define LANE_SLOPES(KIND, name, first, last)                                                                           \
    case NKW_CUBIC_##KIND:                                                                                             \
        return lane_##name##_slopes(c);
        LANE_CUBICS(LANE_SLOPES)
#undef LANE_SLOPES
    case NKW_CUBIC_KIND_MAX_ENUM:
        break;
    }
    return lane_hermite_slopes(c);
}

/* The weights of the three at t: what each adds to the value, p(t) - p(0). */
static inline lane_f64_slopes lane_f64_hermite_weights(double t)
{
    double s = 1.0 - t;
    lane_f64_slopes r = {(t * t) * (3.0 - 2.0 * t), t * (s * s), -((t * t) * s)};
    return r;
}

/* The value, from p(0) = from. */
static inline double lane_f64_value(double from, lane_f64_slopes a, double t)
{
    lane_f64_slopes k = lane_f64_hermite_weights(t);
    return from + (k.f * a.f + (k.v0 * a.v0 + k.v1 * a.v1));
}

/* The value from the end nearer to t: p0 + t (f + s k) or p1 - s (f - t k), k = s (v0 - f) - t (v1 - f). */
static inline double lane_f64_value_between(double p0, double p1, lane_f64_slopes a, double t)
{
    double s = 1.0 - t, bend = s * (a.v0 - a.f) - t * (a.v1 - a.f);
    return t < 0.5 ? p0 + t * (a.f + s * bend) : p1 - s * (a.f - t * bend);
}

/* The first and second derivative by t; see nkw_cubic_evaluate. */
static inline double lane_f64_first(lane_f64_slopes a, double t)
{
    double s = 1.0 - t;
    return (6.0 * (t * s)) * a.f + ((s * (s - 2.0 * t)) * a.v0 + (t * (t - 2.0 * s)) * a.v1);
}

static inline double lane_f64_second(lane_f64_slopes a, double t)
{
    return (6.0 - 12.0 * t) * a.f + ((6.0 * t - 4.0) * a.v0 + (6.0 * t - 2.0) * a.v1);
}

/* De Casteljau's triangle; its two sides are the halves. */
static inline void lane_bezier_split(lane_f64_cubic b, double t, lane_f64_cubic *left, lane_f64_cubic *right)
{
    const double *c = b.c;
    double s = 1.0 - t;
    double ab = s * c[0] + t * c[1], bc = s * c[1] + t * c[2], cd = s * c[2] + t * c[3];
    double abc = s * ab + t * bc, bcd = s * bc + t * cd;
    double point = s * abc + t * bcd;
    lane_f64_cubic before = {{c[0], ab, abc, point}}, after = {{point, bcd, cd, c[3]}};
    *left = before;
    *right = after;
}

#endif
