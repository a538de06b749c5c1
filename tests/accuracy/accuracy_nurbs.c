/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/nurbs.h> against binary128: curves drawn from their seed. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>

#define SAMPLES 8000u
#define MOST    12

typedef struct example {
    float points[MOST], weights[MOST], knots[NKW_NURBS_KNOTS(MOST, 7)], u;
    nkw_nurbs curve;
} example;

static void begin(example *e, random_source *r, float base)
{
    size_t degree = 1 + random_bits(r) % 7, count = degree + 1 + random_bits(r) % (MOST - degree);
    nkw_nurbs curve = {e->points, random_bits(r) % 4 ? e->weights : NULL, e->knots, count, degree, 1, 1};
    e->curve = curve;
    for (size_t i = 0; i < count; i++) {
        e->points[i] = base + random_between(r, -1.0f, 1.0f);
        e->weights[i] = random_log(r, 0x1p-10f, 0x1p10f);
    }
    e->knots[0] = random_between(r, -2.0f, 2.0f);
    for (size_t k = 1; k < NKW_NURBS_KNOTS(count, degree); k++)
        e->knots[k] = e->knots[k - 1] + random_log(r, 0.01f, 1.0f);
    /* Not the end of the domain: the functions of the definition are 0 there. */
    e->u = random_between(r, e->knots[degree], e->knots[count]);
    e->u = e->u < e->knots[count] ? e->u : e->knots[degree];
}

/* The recursive definition, with its derivatives: d times the derivative of the functions of degree d - 1. */
static wide basis(const float *knots, size_t i, size_t degree, wide u, int derivative)
{
    if (degree == 0)
        return derivative == 0 && u >= knots[i] && u < knots[i + 1];
    wide left = (wide)knots[i + degree] - knots[i], right = (wide)knots[i + degree + 1] - knots[i + 1];
    if (derivative > 0)
        return (wide)(int)degree * (basis(knots, i, degree - 1, u, derivative - 1) / left -
                                    basis(knots, i + 1, degree - 1, u, derivative - 1) / right);
    return (u - knots[i]) / left * basis(knots, i, degree - 1, u, 0) +
           (knots[i + degree + 1] - u) / right * basis(knots, i + 1, degree - 1, u, 0);
}

static void exact_point(const example *e, wide out[3])
{
    wide a[3] = {0, 0, 0}, w[3] = {0, 0, 0};
    for (size_t i = 0; i < e->curve.count; i++)
        for (int d = 0; d < 3; d++) {
            wide n = basis(e->knots, i, e->curve.degree, e->u, d) * (e->curve.weights ? e->weights[i] : 1.0f);
            a[d] += n * e->points[i];
            w[d] += n;
        }
    out[0] = a[0] / w[0];
    out[1] = (a[1] - w[1] * out[0]) / w[0];
    out[2] = (a[2] - 2 * w[1] * out[1] - w[2] * out[0]) / w[0];
}

static wide magnitude(wide x)
{
    return x < 0 ? -x : x;
}

static double point_error(const float *x, float base)
{
    random_source r = wide_source(x);
    example e;
    float got[3];
    wide exact[3], size = 0, shortest = 1e30f;
    begin(&e, &r, base);
    nkw_nurbs_evaluate(&e.curve, e.u, (nkw_motion_span){got, got + 1, got + 2});
    exact_point(&e, exact);
    for (size_t i = 0; i < e.curve.count; i++)
        size = fabsf(e.points[i]) > size ? fabsf(e.points[i]) : size;
    for (size_t k = 1; k < NKW_NURBS_KNOTS(e.curve.count, e.curve.degree); k++) {
        wide step = (wide)e.knots[k] - e.knots[k - 1];
        shortest = step < shortest ? step : shortest;
    }
    double worst = wide_error_of(got, exact, 1, size);
    for (int d = 1; d < 3; d++) {
        size *= (wide)(int)e.curve.degree / shortest;
        worst =
            fmax(worst, wide_error_of(got + d, exact + d, 1, magnitude(exact[d]) > size ? magnitude(exact[d]) : size));
    }
    return worst;
}

static double near_origin(const float *x)
{
    return point_error(x, 0.0f);
}

static double far_away(const float *x)
{
    return point_error(x, 1e5f);
}

static const wide_case cases[] = {
    {"nkw_nurbs_evaluate", "degrees 1 .. 7, [-1, 1]", wide_seed, near_origin, 2, WIDE_CHECKED},
    {"nkw_nurbs_evaluate", "degrees 1 .. 7, 1e5 + [-1, 1]", wide_seed, far_away, 2, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("nurbs.h", argc, argv);
    wide_search_seeds(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
