/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

#define U        0x1p-24
#define SEGMENTS 5
#define STEPS    4
#define ENTRIES  NKW_POLYCURVE_LENGTHS(SEGMENTS, STEPS)

static nkw_vec3 vec3(float x, float y, float z)
{
    nkw_vec3 r = {x, y, z};
    return r;
}

static nkw_vec3_cubic cubic(nkw_vec3 a, nkw_vec3 b, nkw_vec3 c, nkw_vec3 d)
{
    nkw_vec3_cubic r = {{a, b, c, d}};
    return r;
}

static nkw_vec3_cubic draw(random_source *r)
{
    return cubic(random_vec3(r, -2, 2), random_vec3(r, -2, 2), random_vec3(r, -2, 2), random_vec3(r, -2, 2));
}

/* A chain of Bezier segments with a common tangent where they join. */
static void draw_chain(random_source *r, nkw_vec3_cubic chain[SEGMENTS])
{
    for (size_t k = 0; k < SEGMENTS; k++) {
        chain[k] = draw(r);
        if (k == 0)
            continue;
        const nkw_vec3 *before = chain[k - 1].c;
        chain[k].c[0] = before[3];
        chain[k].c[1] = nkw_vec3_add(before[3], nkw_vec3_sub(before[3], before[2]));
    }
}

/* By the trapezoidal rule on the chords of 20000 steps. */
static double chords(nkw_cubic_kind kind, const nkw_vec3_cubic *c, double from, double to)
{
    double sum = 0;
    const int n = 20000;
    for (int i = 0; i < n; i++) {
        double t = from + (to - from) * (i + 0.5) / n;
        nkw_vec3 v = nkw_vec3_cubic_evaluate(c, (float)t, kind).velocity;
        sum += sqrt((double)v.x * (double)v.x + (double)v.y * (double)v.y + (double)v.z * (double)v.z);
    }
    return sum * (to - from) / n;
}

static void length_of_a_line_is_its_distance(void **state)
{
    (void)state;
    random_source r = random_from(1);
    const nkw_vec3 zero = {0, 0, 0};
    for (int i = 0; i < 400; i++) {
        nkw_vec3 a = random_vec3(&r, -9, 9), b = random_vec3(&r, -9, 9), f = nkw_vec3_sub(b, a);
        nkw_vec3_cubic even = cubic(a, f, b, f), resting = cubic(a, zero, b, zero);
        float distance = nkw_vec3_distance(a, b);
        expect_near(nkw_vec3_cubic_length(&even, 0, 1, NKW_CUBIC_HERMITE), distance, 3e-6);
        expect_near(nkw_vec3_cubic_length(&resting, 0, 1, NKW_CUBIC_HERMITE), distance, 3e-6);
        expect_near(nkw_vec3_cubic_length(&even, 0.25f, 0.75f, NKW_CUBIC_HERMITE), distance / 2, 3e-6);
    }
}

static void lengths_in_closed_form_come_out(void **state)
{
    (void)state;
    /* (t, t^2): sqrt(5)/2 + asinh(2)/4 */
    nkw_vec3_cubic parabola = cubic(vec3(0, 0, 0), vec3(1, 0, 0), vec3(1, 1, 0), vec3(1, 2, 0));
    expect_near(nkw_vec3_cubic_length(&parabola, 0, 1, NKW_CUBIC_HERMITE), 1.4789428575445975, 1e-7);
    /* A cusp at t = 1/2: 2 sqrt(2) - 1 */
    nkw_vec3_cubic cusp = cubic(vec3(0, 0, 0), vec3(1, 1, 0), vec3(0, 1, 0), vec3(1, 0, 0));
    expect_near(nkw_vec3_cubic_length(&cusp, 0, 1, NKW_CUBIC_BEZIER), 1.8284271247461903, 1e-7);
    double after = chords(NKW_CUBIC_BEZIER, &cusp, 0.5, 1);
    expect_near(nkw_vec3_cubic_length(&cusp, 0.495f, 1, NKW_CUBIC_BEZIER),
                chords(NKW_CUBIC_BEZIER, &cusp, (double)0.495f, 0.5) + after, 1e-7);
    /* x = 6t - 15t^2 + 10t^3 turns at t = (1 -+ sqrt(1/5))/2: 1/sqrt(5) forward, again back, and 1 more */
    nkw_vec3_cubic back = cubic(vec3(0, 0, 0), vec3(2, 0, 0), vec3(-1, 0, 0), vec3(1, 0, 0));
    double low = 0.5 * (1 - sqrt(0.2)), high = 1 - low;
    double at_low = low * (6 + low * (-15 + 10 * low)), at_high = high * (6 + high * (-15 + 10 * high));
    expect_near(nkw_vec3_cubic_length(&back, 0, 1, NKW_CUBIC_BEZIER), 2 * (at_low - at_high) + 1, 2e-7);
}

static void length_is_that_of_many_chords(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 40; i++) {
        nkw_vec3_cubic c = draw(&r);
        nkw_cubic_kind kind = (nkw_cubic_kind)(i % 4);
        expect_near(nkw_vec3_cubic_length(&c, 0, 1, kind), chords(kind, &c, 0, 1), 3e-6);
        expect_near(nkw_vec3_cubic_length(&c, 0.125f, 1.5f, kind), chords(kind, &c, 0.125, 1.5), 3e-5);
    }
}

/* The ways forward and back of a curve of one component whose slope is a + b t + c t^2, for t in 0..1. */
static double forward_and_back(double a, double b, double c)
{
    double d = b * b - 4 * a * c, q = d > 0 ? -0.5 * (b + copysign(sqrt(d), b)) : 0;
    double s = fmin(fmax(c != 0 ? q / c : 0, 0), 1), t = fmin(fmax(q != 0 ? a / q : 0, 0), 1);
    const double at[4] = {0, fmin(s, t), fmax(s, t), 1};
    double sum = 0, before = 0;
    for (int i = 1; i < 4; i++) {
        double x = at[i] * (a + at[i] * (b / 2 + at[i] * c / 3));
        sum += fabs(x - before);
        before = x;
    }
    return sum;
}

static nkw_vec3_cubic along(nkw_vec3 direction, const float x[4])
{
    return cubic(nkw_vec3_scale(direction, x[0]), nkw_vec3_scale(direction, x[1]), nkw_vec3_scale(direction, x[2]),
                 nkw_vec3_scale(direction, x[3]));
}

static void stretches_that_run_back_count(void **state)
{
    (void)state;
    const nkw_vec3 x = {1, 0, 0};
    const float bezier[4] = {0, 3.5f, -3.5f, 10}, hermite[4] = {0, -0.5f, 10, -0.5f}, equal[4] = {2, 2, 2, 2};
    nkw_vec3_cubic a = along(x, bezier), b = along(x, hermite), c = along(x, equal);
    expect_near(nkw_vec3_cubic_length(&a, 0, 1, NKW_CUBIC_BEZIER), 10.01927186, 6e-7);
    expect_near(nkw_vec3_cubic_length(&b, 0, 1, NKW_CUBIC_HERMITE), 10.00797901, 6e-7);
    expect_bits(nkw_vec3_cubic_length(&c, 0, 1, NKW_CUBIC_CATMULL_ROM), 0);
}

/* Of Catmull-Rom segments through round keys on a line, also beside it by less than a ten-thousandth. */
static void lengths_on_a_line_are_those_of_its_stretches(void **state)
{
    (void)state;
    random_source r = random_from(12);
    for (int i = 0; i < 4000; i++) {
        float p[4], beside = i % 2 ? 0x1p-16f : 0, lengths[5];
        for (int k = 0; k < 4; k++)
            p[k] = 0.5f * (float)(random_bits(&r) % 16);
        double v0 = 0.5 * ((double)p[2] - (double)p[0]), v1 = 0.5 * ((double)p[3] - (double)p[1]), f = p[2] - p[1];
        double want = forward_and_back(v0, 6 * f - 4 * v0 - 2 * v1, 3 * (v0 + v1) - 6 * f);
        nkw_vec3_cubic c = along(vec3(0, 1, 0), p);
        c.c[i / 2 % 4].x = beside;
        nkw_polycurve curve = {&c, 1, NKW_CUBIC_CATMULL_ROM};
        double near = 1.5 * U * want + 2e-9 + (want > 0 ? 4 * pow((double)beside, 1.5) : 2 * (double)beside);
        expect_near(nkw_vec3_cubic_length(&c, 0, 1, NKW_CUBIC_CATMULL_ROM), want, near);
        assert_int_equal(nkw_polycurve_measure(&curve, STEPS, lengths, STEPS + 1), NKW_OK);
        expect_near(lengths[STEPS], want, near);
        nkw_segment at =
            nkw_polycurve_at_length(&curve, lengths, NKW_POLYCURVE_LENGTHS(curve.count, STEPS), 0.75f * lengths[STEPS]);
        expect_near(nkw_vec3_cubic_length(&c, 0, at.t, NKW_CUBIC_CATMULL_ROM), 0.75 * want, 3 * U * want + near);
    }
}

/* p' = (t - s) (a + b t): a cusp at s, from which both sides are smooth. */
static void a_cusp_anywhere_is_integrated(void **state)
{
    (void)state;
    random_source r = random_from(13);
    for (int i = 0; i < 100; i++) {
        nkw_vec3 a = random_vec3(&r, -1, 1), b = random_vec3(&r, -1, 1), zero = {0, 0, 0};
        float s = i % 2 ? random_between(&r, 0, 0.02f) : random_unit(&r);
        nkw_vec3 v0 = nkw_vec3_scale(a, -s), v1 = nkw_vec3_scale(nkw_vec3_add(a, b), 1 - s);
        nkw_vec3 f = nkw_vec3_add(nkw_vec3_scale(a, 0.5f - s), nkw_vec3_scale(b, 1 / 3.0f - 0.5f * s));
        nkw_vec3_cubic c = cubic(zero, v0, f, v1);
        double want = chords(NKW_CUBIC_HERMITE, &c, 0, s) + chords(NKW_CUBIC_HERMITE, &c, s, 1);
        expect_near(nkw_vec3_cubic_length(&c, 0, 1, NKW_CUBIC_HERMITE), want, 2e-7);
    }
}

static void lengths_of_parts_add_and_backward_is_negative(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 400; i++) {
        nkw_vec3_cubic c = draw(&r);
        float t = random_unit(&r), whole = nkw_vec3_cubic_length(&c, 0, 1, NKW_CUBIC_BEZIER);
        double parts = (double)nkw_vec3_cubic_length(&c, 0, t, NKW_CUBIC_BEZIER) +
                       (double)nkw_vec3_cubic_length(&c, t, 1, NKW_CUBIC_BEZIER);
        expect_near(whole, parts, 2e-7 * (double)whole);
        expect_near(nkw_vec3_cubic_length(&c, 1, 0, NKW_CUBIC_BEZIER), -(double)whole, 1e-7 * (double)whole);
        expect_bits(nkw_vec3_cubic_length(&c, t, t, NKW_CUBIC_BEZIER), 0);
    }
}

static void length_of_a_point_is_zero_and_of_nan_is_nan(void **state)
{
    (void)state;
    nkw_vec3 p = {1, 2, 3};
    nkw_vec3_cubic point = cubic(p, p, p, p), bad = cubic(p, p, vec3(NAN, 0, 0), p),
                   far = cubic(p, p, p, vec3(INFINITY, 0, 0));
    expect_bits(nkw_vec3_cubic_length(&point, 0, 1, NKW_CUBIC_BEZIER), 0);
    expect_nan(nkw_vec3_cubic_length(&bad, 0, 1, NKW_CUBIC_BEZIER));
    expect_nan(nkw_vec3_cubic_length(&far, 0, 1, NKW_CUBIC_BEZIER));
    bad = cubic(p, p, vec3(1, 0, 0), p);
    expect_nan(nkw_vec3_cubic_length(&bad, 0, NAN, NKW_CUBIC_BEZIER));
}

static void table_has_the_lengths_of_all_parts(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 100; i++) {
        nkw_vec3_cubic chain[SEGMENTS];
        float lengths[ENTRIES];
        double sum = 0;
        draw_chain(&r, chain);
        nkw_polycurve curve = {chain, SEGMENTS, NKW_CUBIC_BEZIER};
        assert_int_equal(nkw_polycurve_measure(&curve, STEPS, lengths, ENTRIES), NKW_OK);
        expect_bits(lengths[0], 0);
        for (size_t k = 0; k < SEGMENTS; k++) {
            sum += (double)nkw_vec3_cubic_length(&chain[k], 0, 1, NKW_CUBIC_BEZIER);
            expect_near(lengths[(k + 1) * STEPS], sum, 1e-6 * sum);
        }
    }
}

static void places_at_a_length_have_it(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 200; i++) {
        nkw_vec3_cubic chain[SEGMENTS];
        float lengths[ENTRIES];
        size_t steps = i % 2 ? STEPS : 1;
        draw_chain(&r, chain);
        nkw_polycurve curve = {chain, SEGMENTS, NKW_CUBIC_BEZIER};
        assert_int_equal(nkw_polycurve_measure(&curve, steps, lengths, ENTRIES), NKW_OK);
        float total = lengths[SEGMENTS * steps];
        for (int j = 0; j <= 20; j++) {
            float length = total * (float)j / 20;
            nkw_segment at =
                nkw_polycurve_at_length(&curve, lengths, NKW_POLYCURVE_LENGTHS(curve.count, steps), length);
            assert_true(at.index < SEGMENTS && at.t >= 0 && at.t <= 1);
            double reached = (double)lengths[at.index * steps] +
                             (double)nkw_vec3_cubic_length(&chain[at.index], 0, at.t, NKW_CUBIC_BEZIER);
            expect_near(reached, length, 2.5e-7 * (double)total);
        }
    }
}

static void ends_and_other_lengths_are_places_of_the_curve(void **state)
{
    (void)state;
    random_source r = random_from(6);
    nkw_vec3_cubic chain[SEGMENTS];
    float lengths[ENTRIES];
    draw_chain(&r, chain);
    nkw_polycurve curve = {chain, SEGMENTS, NKW_CUBIC_BEZIER}, none = {chain, 0, NKW_CUBIC_BEZIER};
    assert_int_equal(nkw_polycurve_measure(&curve, STEPS, lengths, ENTRIES), NKW_OK);
    const float starts[4] = {0, -1, -INFINITY, NAN}, ends[3] = {lengths[ENTRIES - 1], 1e9f, INFINITY};
    for (size_t i = 0; i < 4; i++) {
        nkw_segment at = nkw_polycurve_at_length(&curve, lengths, NKW_POLYCURVE_LENGTHS(curve.count, STEPS), starts[i]);
        assert_int_equal(at.index, 0);
        expect_bits(at.t, 0);
    }
    for (size_t i = 0; i < 3; i++) {
        nkw_segment at = nkw_polycurve_at_length(&curve, lengths, NKW_POLYCURVE_LENGTHS(curve.count, STEPS), ends[i]);
        assert_int_equal(at.index, SEGMENTS - 1);
        expect_bits(at.t, 1);
    }
    expect_bits(nkw_polycurve_at_length(&none, lengths, NKW_POLYCURVE_LENGTHS(none.count, STEPS), 1).t, 0);
    expect_bits(nkw_polycurve_at_length(&curve, lengths, NKW_POLYCURVE_LENGTHS(curve.count, 0), 1).t, 0);
    for (size_t i = 0; i < ENTRIES; i++)
        lengths[i] = i % 3 ? (float)i : NAN;
    for (int i = 0; i < 40; i++) {
        nkw_segment at = nkw_polycurve_at_length(&curve, lengths, NKW_POLYCURVE_LENGTHS(curve.count, STEPS), (float)i);
        assert_true(at.index < SEGMENTS && at.t >= 0 && at.t <= 1);
    }
}

static void a_curve_that_stands_still_has_places(void **state)
{
    (void)state;
    nkw_vec3 p = {1, 2, 3}, q = {2, 2, 3};
    nkw_vec3_cubic still[3] = {{{p, p, p, p}}, {{p, p, q, q}}, {{q, q, q, q}}};
    float lengths[4];
    nkw_polycurve curve = {still, 3, NKW_CUBIC_BEZIER}, point = {still, 1, NKW_CUBIC_BEZIER};
    assert_int_equal(nkw_polycurve_measure(&curve, 1, lengths, 4), NKW_OK);
    expect_near(lengths[3], 1, 1e-7);
    nkw_segment at = nkw_polycurve_at_length(&curve, lengths, NKW_POLYCURVE_LENGTHS(curve.count, 1), 0.5f);
    assert_int_equal(at.index, 1);
    expect_near(at.t, 0.5, 1e-7);
    assert_int_equal(nkw_polycurve_measure(&point, 1, lengths, 2), NKW_OK);
    at = nkw_polycurve_at_length(&point, lengths, NKW_POLYCURVE_LENGTHS(point.count, 1), 0.5f);
    assert_int_equal(at.index, 0);
}

static void measure_checks_its_arguments(void **state)
{
    (void)state;
    random_source r = random_from(7);
    nkw_vec3_cubic chain[SEGMENTS];
    float lengths[ENTRIES] = {9};
    draw_chain(&r, chain);
    nkw_polycurve curve = {chain, SEGMENTS, NKW_CUBIC_BEZIER}, none = {chain, 0, NKW_CUBIC_BEZIER};
    assert_int_equal(nkw_polycurve_measure(&none, STEPS, lengths, ENTRIES), NKW_EMPTY);
    assert_int_equal(nkw_polycurve_measure(&curve, 0, lengths, ENTRIES), NKW_EMPTY);
    assert_int_equal(nkw_polycurve_measure(&curve, STEPS, lengths, ENTRIES - 1), NKW_TOO_SMALL);
    assert_int_equal(nkw_polycurve_measure(&curve, STEPS, lengths, 0), NKW_TOO_SMALL);
    expect_bits(lengths[0], 9);
    chain[3].c[1].x = NAN;
    assert_int_equal(nkw_polycurve_measure(&curve, STEPS, lengths, ENTRIES), NKW_NOT_FINITE);
    for (size_t i = 3 * STEPS; i < ENTRIES; i++)
        expect_bits(lengths[i], lengths[3 * STEPS]);
}

static void points_of_a_polycurve_are_those_of_its_segments(void **state)
{
    (void)state;
    random_source r = random_from(8);
    nkw_vec3_cubic chain[SEGMENTS];
    draw_chain(&r, chain);
    nkw_polycurve curve = {chain, SEGMENTS, NKW_CUBIC_BEZIER}, none = {chain, 0, NKW_CUBIC_BEZIER};
    nkw_segment at = {2, 0.25f}, beyond = {99, 0.25f};
    expect_vec3_bits(nkw_polycurve_evaluate(&curve, at).value,
                     nkw_vec3_cubic_evaluate(&chain[2], 0.25f, NKW_CUBIC_BEZIER).value);
    expect_vec3_bits(nkw_polycurve_evaluate(&curve, beyond).acceleration,
                     nkw_vec3_cubic_evaluate(&chain[SEGMENTS - 1], 0.25f, NKW_CUBIC_BEZIER).acceleration);
    expect_vec3_bits(nkw_polycurve_evaluate(&none, at).value, vec3(0, 0, 0));
}

/* Sums over the polyline: the distance of each point of the curve to the chord of its interval. */
static double farthest(const nkw_polycurve *curve, const nkw_vec3 *points, size_t count)
{
    double worst = 0;
    size_t chord = 0;
    for (size_t k = 0; k < curve->count; k++)
        for (int i = 0; i <= 2000; i++) {
            nkw_segment at = {k, (float)i / 2000};
            nkw_vec3 p = nkw_polycurve_evaluate(curve, at).value;
            double best = 1e30;
            /* The chords only advance. */
            for (size_t c = chord; c + 1 < count && c < chord + 3; c++) {
                nkw_vec3 a = points[c], ab = nkw_vec3_sub(points[c + 1], a), ap = nkw_vec3_sub(p, a);
                float n = nkw_vec3_dot(ab, ab), s = n > 0 ? nkw_clamp(nkw_vec3_dot(ap, ab) / n, 0.0f, 1.0f) : 0;
                double d = nkw_vec3_distance(p, nkw_vec3_add_scaled(a, ab, s));
                if (d < best) {
                    best = d;
                    chord = c;
                }
            }
            worst = fmax(worst, best);
        }
    return worst;
}

static void polylines_stay_within_the_tolerance(void **state)
{
    (void)state;
    random_source r = random_from(9);
    static nkw_vec3 points[4096];
    for (int i = 0; i < 24; i++) {
        nkw_vec3_cubic chain[SEGMENTS];
        draw_chain(&r, chain);
        nkw_polycurve curve = {chain, SEGMENTS, (nkw_cubic_kind)(i % 4)};
        float tolerance = i < 12 ? 0.05f : 0.001f;
        size_t count;
        if (curve.kind != NKW_CUBIC_BEZIER)
            curve.count = 1; /* others do not join */
        assert_int_equal(nkw_polycurve_flatten(&curve, tolerance, points, 4096, &count), NKW_OK);
        assert_true(farthest(&curve, points, count) <= (double)tolerance + 2e-6);
        expect_vec3_near(points[0], nkw_vec3_cubic_evaluate(chain, 0, curve.kind).value, 1e-6);
        expect_vec3_near(points[count - 1], nkw_vec3_cubic_evaluate(chain + curve.count - 1, 1, curve.kind).value,
                         1e-6);
    }
}

static void polylines_join_and_count(void **state)
{
    (void)state;
    nkw_vec3 p[5] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {5, 1, 0}}, points[8];
    nkw_vec3_cubic lines[3] = {{{p[0], p[0], p[1], p[1]}}, {{p[1], p[1], p[2], p[2]}}, {{p[3], p[3], p[4], p[4]}}};
    lines[0] = cubic(p[0], p[1], p[2], p[3]); /* even steps: straight in t too */
    lines[1] = cubic(p[3], vec3(4, 0, 0), vec3(5, 0, 0), vec3(6, 0, 0));
    lines[2] = cubic(p[0], p[1], p[2], p[3]);
    nkw_polycurve curve = {lines, 3, NKW_CUBIC_BEZIER};
    size_t count = 99;
    assert_int_equal(nkw_polycurve_flatten(&curve, 0.01f, points, 8, &count), NKW_OK);
    assert_int_equal(count, 5); /* the third begins elsewhere */
    expect_vec3_bits(points[1], p[3]);
    expect_vec3_bits(points[2], vec3(6, 0, 0));
    expect_vec3_bits(points[3], p[0]);
    points[2] = vec3(9, 9, 9);
    assert_int_equal(nkw_polycurve_flatten(&curve, 0.01f, points, 2, &count), NKW_TOO_SMALL);
    assert_int_equal(count, 5);
    expect_vec3_bits(points[2], vec3(9, 9, 9));
    assert_int_equal(nkw_polycurve_flatten(&curve, 0.01f, NULL, 0, &count), NKW_TOO_SMALL);
    assert_int_equal(count, 5);
}

static void joints_of_bsplines_are_one_point(void **state)
{
    (void)state;
    random_source r = random_from(10);
    for (int i = 0; i < 200; i++) {
        nkw_vec3 p[5], points[512];
        nkw_vec3_cubic two[2];
        size_t whole, first, second;
        for (int k = 0; k < 5; k++)
            p[k] = random_vec3(&r, -2, 2);
        two[0] = cubic(p[0], p[1], p[2], p[3]);
        two[1] = cubic(p[1], p[2], p[3], p[4]);
        nkw_polycurve curve = {two, 2, i % 2 ? NKW_CUBIC_BSPLINE : NKW_CUBIC_CATMULL_ROM};
        assert_int_equal(nkw_polycurve_flatten(&curve, 0.01f, points, 512, &whole), NKW_OK);
        curve.count = 1;
        nkw_polycurve_flatten(&curve, 0.01f, points, 512, &first);
        curve.cubics = two + 1;
        nkw_polycurve_flatten(&curve, 0.01f, points, 512, &second);
        assert_int_equal(whole, first + second - 1);
    }
}

static void flatten_checks_its_arguments(void **state)
{
    (void)state;
    random_source r = random_from(11);
    nkw_vec3_cubic chain[SEGMENTS];
    nkw_vec3 points[8];
    size_t count = 99;
    draw_chain(&r, chain);
    nkw_polycurve curve = {chain, SEGMENTS, NKW_CUBIC_BEZIER}, none = {chain, 0, NKW_CUBIC_BEZIER};
    assert_int_equal(nkw_polycurve_flatten(&none, 1, points, 8, &count), NKW_EMPTY);
    assert_int_equal(count, 0);
    assert_int_equal(nkw_polycurve_flatten(&curve, 0, points, 8, &count), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_polycurve_flatten(&curve, NAN, points, 8, &count), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_polycurve_flatten(&curve, 1e-20f, points, 8, &count), NKW_TOO_MANY);
    assert_int_equal(count, 0);
    chain[2].c[2].y = INFINITY;
    assert_int_equal(nkw_polycurve_flatten(&curve, 1, points, 8, &count), NKW_NOT_FINITE);
    assert_int_equal(count, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(length_of_a_line_is_its_distance),
        cmocka_unit_test(lengths_in_closed_form_come_out),
        cmocka_unit_test(length_is_that_of_many_chords),
        cmocka_unit_test(stretches_that_run_back_count),
        cmocka_unit_test(lengths_on_a_line_are_those_of_its_stretches),
        cmocka_unit_test(a_cusp_anywhere_is_integrated),
        cmocka_unit_test(lengths_of_parts_add_and_backward_is_negative),
        cmocka_unit_test(length_of_a_point_is_zero_and_of_nan_is_nan),
        cmocka_unit_test(table_has_the_lengths_of_all_parts),
        cmocka_unit_test(places_at_a_length_have_it),
        cmocka_unit_test(ends_and_other_lengths_are_places_of_the_curve),
        cmocka_unit_test(a_curve_that_stands_still_has_places),
        cmocka_unit_test(measure_checks_its_arguments),
        cmocka_unit_test(points_of_a_polycurve_are_those_of_its_segments),
        cmocka_unit_test(polylines_stay_within_the_tolerance),
        cmocka_unit_test(polylines_join_and_count),
        cmocka_unit_test(joints_of_bsplines_are_one_point),
        cmocka_unit_test(flatten_checks_its_arguments),
    };
    return cmocka_run_group_tests_name("polycurve", tests, NULL, NULL);
}
