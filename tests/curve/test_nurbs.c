/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

#define MOST 40

/* A curve of numbers. */
static nkw_nurbs numbers(const float *points, const float *weights, const float *knots, size_t count, size_t degree)
{
    nkw_nurbs c = {points, weights, knots, count, degree, 1, 1};
    return c;
}

static nkw_motion at(const nkw_nurbs *c, float u)
{
    nkw_motion p = {9, 9, 9};
    nkw_nurbs_evaluate(c, u, (nkw_motion_span){&p.value, &p.velocity, &p.acceleration});
    return p;
}

static void draw(random_source *r, float *x, size_t n, float low, float high)
{
    for (size_t i = 0; i < n; i++)
        x[i] = random_between(r, low, high);
}

/* Knots of even steps from 0 to 1, or steps of random length, now and then 0. */
static void draw_knots(random_source *r, nkw_nurbs_knots_kind kind, size_t count, size_t degree, float *knots)
{
    assert_int_equal(nkw_nurbs_make_knots(count, degree, 0, 1, kind, knots), NKW_OK);
    if (random_bits(r) % 2)
        for (size_t k = 1; k < NKW_NURBS_KNOTS(count, degree); k++)
            knots[k] = knots[k - 1] + random_between(r, 0.25f, 1.0f);
}

static void one_point_returns_it(void **state)
{
    (void)state;
    static const float points[1] = {3}, knots[2] = {0, 1};
    nkw_nurbs c = numbers(points, NULL, knots, 1, 0);
    assert_int_equal(nkw_nurbs_validate(&c, NULL), NKW_OK);
    expect_bits(at(&c, 0.5f).value, 3);
    expect_bits(at(&c, 0.5f).velocity, 0);
    expect_bits(at(&c, 0.5f).acceleration, 0);
}

static void degree_zero_holds_and_degree_one_is_linear(void **state)
{
    (void)state;
    static const float points[3] = {1, 3, -1}, steps[4] = {0, 1, 2, 4}, lines[5] = {0, 0, 1, 3, 3};
    nkw_nurbs hold = numbers(points, NULL, steps, 3, 0), line = numbers(points, NULL, lines, 3, 1);
    expect_bits(at(&hold, 0.75f).value, 1);
    expect_bits(at(&hold, 1).value, 3);
    expect_bits(at(&hold, 4).value, -1);
    expect_bits(at(&hold, 3).velocity, 0);
    expect_bits(at(&line, 0.5f).value, 2);
    expect_bits(at(&line, 1).value, 3);
    expect_bits(at(&line, 2).value, 1);
    expect_bits(at(&line, 2).velocity, -2);
    expect_bits(at(&line, 2).acceleration, 0);
}

static void uniform_knots_of_degree_three_are_the_bspline(void **state)
{
    (void)state;
    random_source r = random_from(1);
    float points[7], knots[11];
    assert_int_equal(nkw_nurbs_make_knots(7, 3, 0, 4, NKW_NURBS_KNOTS_UNIFORM, knots), NKW_OK);
    for (int i = 0; i < 2000; i++) {
        draw(&r, points, 7, -1, 1);
        nkw_nurbs c = numbers(points, NULL, knots, 7, 3);
        size_t k = random_bits(&r) % 4;
        float t = random_unit(&r);
        nkw_motion p = at(&c, (float)k + t),
                   want = nkw_cubic_evaluate(points + k, (float)k + t - (float)k, NKW_CUBIC_BSPLINE);
        expect_near(p.value, want.value, 3e-7);
        expect_near(p.velocity, want.velocity, 3e-6);
        expect_near(p.acceleration, want.acceleration, 1e-5);
    }
}

static void clamped_knots_of_four_points_are_the_bezier(void **state)
{
    (void)state;
    random_source r = random_from(2);
    float points[4], knots[8];
    assert_int_equal(nkw_nurbs_make_knots(4, 3, 0, 1, NKW_NURBS_KNOTS_CLAMPED, knots), NKW_OK);
    for (int i = 0; i < 2000; i++) {
        draw(&r, points, 4, -1, 1);
        nkw_nurbs c = numbers(points, NULL, knots, 4, 3);
        float t = random_unit(&r);
        nkw_motion p = at(&c, t), want = nkw_cubic_evaluate(points, t, NKW_CUBIC_BEZIER);
        expect_near(p.value, want.value, 3e-7);
        expect_near(p.velocity, want.velocity, 1e-6);
        expect_near(p.acceleration, want.acceleration, 4e-6);
    }
}

static void clamped_ends_are_control_points(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 400; i++) {
        float points[MOST], weights[MOST], knots[MOST];
        size_t degree = random_bits(&r) % (NKW_NURBS_DEGREE + 1), count = degree + 1 + random_bits(&r) % 8;
        draw(&r, points, count, -1, 1);
        draw(&r, weights, count, 0.25f, 4);
        assert_int_equal(nkw_nurbs_make_knots(count, degree, -2, 3, NKW_NURBS_KNOTS_CLAMPED, knots), NKW_OK);
        nkw_nurbs c = numbers(points, weights, knots, count, degree);
        assert_int_equal(nkw_nurbs_validate(&c, NULL), NKW_OK);
        expect_bits(at(&c, -2).value, points[0]);
        expect_bits(at(&c, 3).value, points[count - 1]);
        expect_bits(at(&c, -7).value, points[0]);
        expect_bits(at(&c, NAN).value, points[0]);
        expect_bits(at(&c, INFINITY).value, points[count - 1]);
    }
}

/* A square of half side 1 with weights 1, cos 45: four arcs of the unit circle. */
static void a_circle_is_round(void **state)
{
    (void)state;
    static const float points[18] = {1, 0, 1, 1, 0, 1, -1, 1, -1, 0, -1, -1, 0, -1, 1, -1, 1, 0};
    static const float knots[12] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
    const float h = 0x1.6a09e6p-1f, weights[9] = {1, h, 1, h, 1, h, 1, h, 1};
    nkw_nurbs circle = {points, weights, knots, 9, 2, 2, 2};
    assert_int_equal(nkw_nurbs_validate(&circle, NULL), NKW_OK);
    for (int i = 0; i <= 1000; i++) {
        float u = 4 * (float)i / 1000, p[2], v[2];
        nkw_nurbs_evaluate(&circle, u, (nkw_motion_span){p, v, NULL});
        expect_near(sqrt((double)p[0] * (double)p[0] + (double)p[1] * (double)p[1]), 1, 1.5e-7);
        expect_near((double)p[0] * (double)v[0] + (double)p[1] * (double)v[1], 0, 5e-7);
    }
}

static void values_are_those_of_scipy(void **state)
{
    (void)state;
    static const float knots[16] = {0, 0, 0, 0, 0, 0, 0.5f, 1.25f, 1.25f, 3, 4, 4, 4, 4, 4, 4},
                       points[10] = {0, 1, -0.5f, 2, 3, 1.5f, -2, 0.25f, 1, 4};
    static const float knots2[8] = {0, 0, 0, 1, 2.5f, 3, 3, 3}, points2[5] = {0, 1, 3, -1, 2},
                       weights2[5] = {1, 0.5f, 2, 0.25f, 1};
    static const struct {
        double u, want[3];
    } rows[] =
        {
            {0, {0, 10, -128}},
            {0.25, {0.5667381944444444, 0.22143055555555619, 11.329555555555556}},
            {0.75, {1.9333336309523808, 2.7749226190476191, -7.717238095238093}},
            {1.25, {2.3699528769841267, -0.62971230158730163, -4.3769841269841274}},
            {2, {0.96663384794757534, -2.5117528649781522, 0.24264602819931785}},
            {3.5, {0.56486981275673998, 2.6561478528984166, 6.6922146223423464}},
        },
      rational[] = {
          {0, {0, 1, 5.4000000000000004}},
          {0.5, {1.1935483870967745, 3.3298647242455779, 0.13963948843610413}},
          {1.75, {2.7667386609071278, -0.11344923939562146, -1.1895598319713681}},
          {2.75, {1.2857142857142858, 1.0448979591836733, 31.04839650145772}},

      };
    nkw_nurbs c = numbers(points, NULL, knots, 10, 5), d = numbers(points2, weights2, knots2, 5, 2);
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        nkw_motion p = at(&c, (float)rows[i].u);
        expect_near(p.value, rows[i].want[0], 2e-7);
        expect_near(p.velocity, rows[i].want[1], 2e-6);
        expect_near(p.acceleration, rows[i].want[2], 2e-5);
    }
    for (size_t i = 0; i < sizeof rational / sizeof rational[0]; i++) {
        nkw_motion p = at(&d, (float)rational[i].u);
        expect_near(p.value, rational[i].want[0], 2e-7);
        expect_near(p.velocity, rational[i].want[1], 2e-6);
        expect_near(p.acceleration, rational[i].want[2], 2e-5);
    }
}

static void equal_points_are_that_point_and_weights_may_be_scaled(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 400; i++) {
        float points[MOST], weights[MOST], scaled[MOST], knots[MOST];
        size_t degree = random_bits(&r) % 8, count = degree + 1 + random_bits(&r) % 8;
        draw(&r, points, count, -1, 1);
        draw(&r, weights, count, 0.25f, 4);
        draw_knots(&r, (nkw_nurbs_knots_kind)(i % 2), count, degree, knots);
        for (size_t k = 0; k < count; k++)
            scaled[k] = 8 * weights[k];
        nkw_nurbs c = numbers(points, weights, knots, count, degree), d = numbers(points, scaled, knots, count, degree);
        float u = nkw_lerp(knots[degree], knots[count], random_unit(&r));
        nkw_motion p = at(&c, u), q = at(&d, u);
        expect_bits(p.value, q.value);
        expect_bits(p.velocity, q.velocity);
        for (size_t k = 0; k < count; k++)
            points[k] = 0.625f;
        expect_bits(at(&c, u).value, 0.625f);
        expect_near(at(&c, u).velocity, 0, 0);
    }
}

static void derivatives_are_slopes(void **state)
{
    (void)state;
    random_source r = random_from(5);
    const float h = 0x1p-9f;
    for (int i = 0; i < 1000; i++) {
        float points[MOST], weights[MOST], knots[MOST];
        size_t degree = 2 + random_bits(&r) % 4, count = degree + 1 + random_bits(&r) % 4;
        draw(&r, points, count, -1, 1);
        draw(&r, weights, count, 0.5f, 2);
        assert_int_equal(
            nkw_nurbs_make_knots(count, degree, 0, (float)(count - degree), NKW_NURBS_KNOTS_CLAMPED, knots), NKW_OK);
        nkw_nurbs c = numbers(points, weights, knots, count, degree);
        float u = (float)(random_bits(&r) % (count - degree)) + 0x1p-8f + (float)(random_bits(&r) % 253) / 256;
        nkw_motion p = at(&c, u), before = at(&c, u - h), after = at(&c, u + h);
        expect_near(p.velocity, ((double)after.value - (double)before.value) / (2 * (double)h), 1e-2);
        expect_near(p.acceleration, ((double)after.velocity - (double)before.velocity) / (2 * (double)h),
                    3e-2 + 1e-3 * fabs((double)p.acceleration));
    }
}

static void mirrored_curves_have_mirrored_points(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 400; i++) {
        float points[MOST], weights[MOST], knots[MOST], back_points[MOST], back_weights[MOST], back_knots[MOST];
        size_t degree = 1 + random_bits(&r) % 7, count = degree + 1 + random_bits(&r) % 8, n = count + degree;
        draw(&r, points, count, -1, 1);
        draw(&r, weights, count, 0.25f, 4);
        draw_knots(&r, (nkw_nurbs_knots_kind)(i % 2), count, degree, knots);
        for (size_t k = 0; k < count; k++) {
            back_points[k] = points[count - 1 - k];
            back_weights[k] = weights[count - 1 - k];
        }
        for (size_t k = 0; k <= n; k++)
            back_knots[k] = -knots[n - k];
        nkw_nurbs c = numbers(points, weights, knots, count, degree),
                  back = numbers(back_points, back_weights, back_knots, count, degree);
        float u = nkw_lerp(knots[degree], knots[count], 0.999f * random_unit(&r));
        nkw_motion p = at(&c, u), q = at(&back, -u);
        expect_near(p.value, q.value, 1e-6);
        if (degree > 2)
            expect_near(p.velocity, -(double)q.velocity, 1e-5 * (1 + fabs((double)p.velocity)));
    }
}

static void vectors_go_by_component_and_stride(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (int i = 0; i < 200; i++) {
        float points[28], weights[7], knots[11], y[7], p[3], v[3], a[3];
        draw(&r, points, 28, -1, 1);
        draw(&r, weights, 7, 0.5f, 2);
        draw_knots(&r, NKW_NURBS_KNOTS_CLAMPED, 7, 3, knots);
        for (size_t k = 0; k < 7; k++)
            y[k] = points[4 * k + 1];
        nkw_nurbs c = {points, weights, knots, 7, 3, 3, 4}, one = numbers(y, weights, knots, 7, 3);
        float u = nkw_lerp(knots[3], knots[7], random_unit(&r));
        nkw_nurbs_evaluate(&c, u, (nkw_motion_span){p, v, a});
        nkw_motion want = at(&one, u);
        expect_bits(p[1], want.value);
        expect_bits(v[1], want.velocity);
        expect_bits(a[1], want.acceleration);
        float again[3];
        nkw_nurbs_evaluate(&c, u, (nkw_motion_span){again, NULL, NULL});
        expect_floats_bits(again, p, 3);
    }
}

static void a_knot_of_multiplicity_degree_is_a_corner_at_its_point(void **state)
{
    (void)state;
    static const float points[7] = {0, 1, 2, 5, 3, 2, 1}, knots[11] = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2};
    nkw_nurbs c = numbers(points, NULL, knots, 7, 3);
    assert_int_equal(nkw_nurbs_validate(&c, NULL), NKW_OK);
    expect_bits(at(&c, 1).value, 5);
    expect_near(at(&c, 1).velocity, -6, 1e-6); /* of the span that begins there */
}

static void expect_bad(const nkw_nurbs *c, nkw_result result, size_t bad)
{
    size_t index = 99;
    assert_int_equal(nkw_nurbs_validate(c, &index), result);
    assert_int_equal(index, bad);
    assert_int_equal(nkw_nurbs_validate(c, NULL), result);
}

static void curves_are_checked(void **state)
{
    (void)state;
    static const float points[5] = {0, 1, NAN, 3, 4}, good[6] = {0, 1, 2, 3, 4, 5}, knots[8] = {0, 0, 0, 1, 2, 3, 3, 3},
                       infinite[8] = {0, 0, 0, 1, INFINITY, 3, 3, 3}, descending[8] = {0, 0, 0, 2, 1, 3, 3, 3},
                       empty[8] = {0, 1, 2, 2, 2, 2, 3, 4}, many[9] = {0, 0, 0, 1, 1, 1, 1, 3, 3},
                       weights[5] = {1, 1, 1, 0, 1}, nan_weights[5] = {1, NAN, 1, 1, 1};
    nkw_nurbs c = numbers(good, NULL, knots, 5, 2);
    expect_bad(&c, NKW_OK, 0);
    c.count = 0;
    expect_bad(&c, NKW_EMPTY, 0);
    c = numbers(good, NULL, knots, 5, 2);
    c.width = 0;
    expect_bad(&c, NKW_EMPTY, 0);
    c = numbers(good, NULL, knots, 5, NKW_NURBS_DEGREE + 1);
    expect_bad(&c, NKW_TOO_MANY, 0);
    c = numbers(good, NULL, knots, 5, 5);
    expect_bad(&c, NKW_TOO_SMALL, 0);
    c = numbers(good, NULL, knots, 5, 2);
    c.stride = 0;
    expect_bad(&c, NKW_BAD_WIDTH, 0);
    c = numbers(good, NULL, infinite, 5, 2);
    expect_bad(&c, NKW_NOT_FINITE, 4);
    c = numbers(good, NULL, descending, 5, 2);
    expect_bad(&c, NKW_NOT_ASCENDING, 4);
    c = numbers(good, NULL, empty, 5, 2);
    expect_bad(&c, NKW_NOT_ASCENDING, 5);
    c = numbers(good, NULL, many, 6, 2);
    expect_bad(&c, NKW_TOO_MANY, 6);
    c = numbers(points, NULL, knots, 5, 2);
    expect_bad(&c, NKW_NOT_FINITE, 2);
    c = numbers(good, weights, knots, 5, 2);
    expect_bad(&c, NKW_BAD_WEIGHTS, 3);
    c = numbers(good, nan_weights, knots, 5, 2);
    expect_bad(&c, NKW_NOT_FINITE, 1);
}

static void curves_without_points_write_nothing(void **state)
{
    (void)state;
    static const float points[2] = {0, 1}, knots[5] = {0, 0, 0, 1, 1};
    nkw_nurbs few = numbers(points, NULL, knots, 2, 2), none = numbers(points, NULL, knots, 0, 0),
              high = numbers(points, NULL, knots, 2, 99);
    expect_bits(at(&few, 0.5f).value, 9);
    expect_bits(at(&none, 0.5f).value, 9);
    expect_bits(at(&high, 0.5f).value, 9);
}

static void knots_are_even_and_refuse_bad_shapes(void **state)
{
    (void)state;
    static const float clamped[8] = {1, 1, 1, 2, 3, 4, 4, 4}, uniform[8] = {-1, 0, 1, 2, 3, 4, 5, 6};
    float knots[8];
    assert_int_equal(nkw_nurbs_make_knots(5, 2, 1, 4, NKW_NURBS_KNOTS_CLAMPED, knots), NKW_OK);
    expect_floats_bits(knots, clamped, 8);
    assert_int_equal(nkw_nurbs_make_knots(5, 2, 1, 4, (nkw_nurbs_knots_kind)7, knots), NKW_OK);
    expect_floats_bits(knots, clamped, 8);
    assert_int_equal(nkw_nurbs_make_knots(5, 2, 1, 4, NKW_NURBS_KNOTS_UNIFORM, knots), NKW_OK);
    expect_floats_bits(knots, uniform, 8);
    assert_int_equal(nkw_nurbs_make_knots(5, 2, -3e38f, 3e38f, NKW_NURBS_KNOTS_UNIFORM, knots), NKW_OK);
    expect_bits(knots[0], -FLT_MAX);
    expect_bits(knots[7], FLT_MAX);
    assert_int_equal(nkw_nurbs_make_knots(5, 16, 1, 4, NKW_NURBS_KNOTS_CLAMPED, knots), NKW_TOO_MANY);
    assert_int_equal(nkw_nurbs_make_knots(2, 2, 1, 4, NKW_NURBS_KNOTS_CLAMPED, knots), NKW_TOO_SMALL);
    assert_int_equal(nkw_nurbs_make_knots(5, 2, NAN, 4, NKW_NURBS_KNOTS_CLAMPED, knots), NKW_NOT_FINITE);
    assert_int_equal(nkw_nurbs_make_knots(5, 2, 1, INFINITY, NKW_NURBS_KNOTS_CLAMPED, knots), NKW_NOT_FINITE);
    assert_int_equal(nkw_nurbs_make_knots(5, 2, 1, NAN, NKW_NURBS_KNOTS_CLAMPED, knots), NKW_NOT_FINITE);
    assert_int_equal(nkw_nurbs_make_knots(5, 2, 4, 4, NKW_NURBS_KNOTS_CLAMPED, knots), NKW_NOT_ASCENDING);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_point_returns_it),
        cmocka_unit_test(degree_zero_holds_and_degree_one_is_linear),
        cmocka_unit_test(uniform_knots_of_degree_three_are_the_bspline),
        cmocka_unit_test(clamped_knots_of_four_points_are_the_bezier),
        cmocka_unit_test(clamped_ends_are_control_points),
        cmocka_unit_test(a_circle_is_round),
        cmocka_unit_test(values_are_those_of_scipy),
        cmocka_unit_test(equal_points_are_that_point_and_weights_may_be_scaled),
        cmocka_unit_test(derivatives_are_slopes),
        cmocka_unit_test(mirrored_curves_have_mirrored_points),
        cmocka_unit_test(vectors_go_by_component_and_stride),
        cmocka_unit_test(a_knot_of_multiplicity_degree_is_a_corner_at_its_point),
        cmocka_unit_test(curves_are_checked),
        cmocka_unit_test(curves_without_points_write_nothing),
        cmocka_unit_test(knots_are_even_and_refuse_bad_shapes),
    };
    return cmocka_run_group_tests_name("nurbs", tests, NULL, NULL);
}
