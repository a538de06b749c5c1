/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

#define KINDS 4

static float value_of(nkw_cubic_kind kind, const float c[4], float t)
{
    switch (kind) {
    case NKW_CUBIC_BEZIER:
        return nkw_bezier(c[0], c[1], c[2], c[3], t);
    case NKW_CUBIC_BSPLINE:
        return nkw_bspline(c[0], c[1], c[2], c[3], t);
    case NKW_CUBIC_CATMULL_ROM:
        return nkw_catmull_rom(c[0], c[1], c[2], c[3], t);
    default:
        return nkw_hermite(c[0], c[1], c[2], c[3], t);
    }
}

static void draw(random_source *r, float c[4])
{
    for (int i = 0; i < 4; i++)
        c[i] = random_between(r, -1, 1);
}

static nkw_motion draw_point(random_source *r)
{
    nkw_motion p = {random_between(r, -1, 1), random_between(r, -4, 4), random_between(r, -20, 20)};
    return p;
}

static void value_of_a_point_has_the_bits_of_the_curve(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 4000; i++) {
        float c[4], t = random_between(&r, -0.5f, 1.5f);
        draw(&r, c);
        for (int kind = -1; kind <= KINDS; kind++)
            expect_bits(nkw_cubic_evaluate(c, t, (nkw_cubic_kind)kind).value, value_of((nkw_cubic_kind)kind, c, t));
    }
}

static float weigh(nkw_weights w, float c0, float c1, float c2, float c3)
{
    const nkw_vec3_cubic c = {{{c0, 0.0f, 0.0f}, {c1, 0.0f, 0.0f}, {c2, 0.0f, 0.0f}, {c3, 0.0f, 0.0f}}};
    return nkw_vec3_cubic_sum(&c, w).x;
}

static void derivatives_of_a_point_are_the_weighted_sums(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 4000; i++) {
        float c[4], t = random_unit(&r);
        draw(&r, c);
        for (int k = 0; k < KINDS; k++) {
            nkw_cubic_kind kind = (nkw_cubic_kind)k;
            nkw_motion p = nkw_cubic_evaluate(c, t, kind);
            nkw_weights v = nkw_cubic_weights(kind, 1, t), a = nkw_cubic_weights(kind, 2, t);
            expect_near(p.velocity, weigh(v, c[0], c[1], c[2], c[3]), 4e-6);
            expect_near(p.acceleration, weigh(a, c[0], c[1], c[2], c[3]), 1e-5);
        }
    }
}

static void tangents_come_back_at_the_ends(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 4000; i++) {
        float c[4];
        for (int j = 0; j < 4; j++)
            c[j] = random_scaled(&r, -40, 40);
        expect_bits(nkw_cubic_evaluate(c, 0, NKW_CUBIC_HERMITE).velocity, c[1]);
        expect_bits(nkw_cubic_evaluate(c, 1, NKW_CUBIC_HERMITE).velocity, c[3]);
    }
}

static void derivatives_do_not_lose_digits_far_from_the_origin(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 2000; i++) {
        float near[4], far[4], t = random_unit(&r);
        for (int j = 0; j < 4; j++) {
            near[j] = (float)(random_bits(&r) % 64) / 16;
            far[j] = 262144.0f + near[j]; /* exact */
        }
        for (int k = NKW_CUBIC_BEZIER; k < KINDS; k++) {
            expect_bits(nkw_cubic_evaluate(far, t, (nkw_cubic_kind)k).velocity,
                        nkw_cubic_evaluate(near, t, (nkw_cubic_kind)k).velocity);
            expect_bits(nkw_cubic_evaluate(far, t, (nkw_cubic_kind)k).acceleration,
                        nkw_cubic_evaluate(near, t, (nkw_cubic_kind)k).acceleration);
        }
    }
}

/* The curve of four keys at any times. */
static float uneven(const float times[4], float p0, float p1, float p2, float p3, float t)
{
    const float keys[4] = {p0, p1, p2, p3};
    float c[4];
    nkw_cubic_from_catmull_rom(keys, times, c);
    return nkw_hermite(c[0], c[1], c[2], c[3], t);
}

static nkw_motion uneven_motion(const float times[4], const float keys[4], float t)
{
    float c[4];
    nkw_cubic_from_catmull_rom(keys, times, c);
    return nkw_cubic_evaluate(c, t, NKW_CUBIC_HERMITE);
}

static void points_of_vectors_go_by_component(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 1000; i++) {
        nkw_vec3_cubic c;
        float t = random_unit(&r), times[4] = {0, 0.5f, 0.75f, 2}, y[4];
        for (int j = 0; j < 4; j++) {
            c.c[j] = random_vec3(&r, -1, 1);
            y[j] = c.c[j].y;
        }
        nkw_vec3_motion p = nkw_vec3_cubic_evaluate(&c, t, NKW_CUBIC_BSPLINE);
        nkw_motion want = nkw_cubic_evaluate(y, t, NKW_CUBIC_BSPLINE);
        expect_bits(p.value.y, want.value);
        expect_bits(p.velocity.y, want.velocity);
        expect_bits(p.acceleration.y, want.acceleration);
        const float z[4] = {c.c[0].z, c.c[1].z, c.c[2].z, c.c[3].z};
        const nkw_vec3_cubic through = nkw_vec3_cubic_from_catmull_rom(c.c, times);
        p = nkw_vec3_cubic_evaluate(&through, t, NKW_CUBIC_HERMITE);
        want = uneven_motion(times, z, t);
        expect_bits(p.value.z, want.value);
        expect_bits(p.velocity.z, want.velocity);
        expect_bits(p.acceleration.z, want.acceleration);
        nkw_vec3_motion a = {c.c[0], c.c[1], c.c[2]}, b = {c.c[3], c.c[0], c.c[1]};
        nkw_motion ax = {a.value.x, a.velocity.x, a.acceleration.x}, bx = {b.value.x, b.velocity.x, b.acceleration.x};
        p = nkw_vec3_quintic_evaluate(&a, &b, t);
        want = nkw_quintic_evaluate(ax, bx, t);
        expect_bits(p.value.x, want.value);
        expect_bits(p.velocity.x, want.velocity);
        expect_bits(p.acceleration.x, want.acceleration);
    }
}

static void nonuniform_points_have_the_value_of_the_curve_and_its_slope(void **state)
{
    (void)state;
    random_source r = random_from(6);
    const double h = 0x1p-9;
    for (int i = 0; i < 2000; i++) {
        float c[4], times[4] = {0, 0.5f, 1.5f, 1.75f}, t = 0.25f + (float)(random_bits(&r) % 256) / 512;
        draw(&r, c);
        nkw_motion p = uneven_motion(times, c, t);
        expect_bits(p.value, uneven(times, c[0], c[1], c[2], c[3], t));
        nkw_motion before = uneven_motion(times, c, t - (float)h), after = uneven_motion(times, c, t + (float)h);
        /* Central differences: off by h^2/6 times the third derivative, at most 60. */
        expect_near(p.velocity, ((double)after.value - (double)before.value) / (2 * h), 3e-4);
        expect_near(p.acceleration, ((double)after.velocity - (double)before.velocity) / (2 * h), 1e-3);
    }
}

static void quintic_returns_its_ends(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (int i = 0; i < 4000; i++) {
        nkw_motion p0 = draw_point(&r), p1 = draw_point(&r);
        nkw_motion start = nkw_quintic_evaluate(p0, p1, 0), end = nkw_quintic_evaluate(p0, p1, 1);
        expect_bits(start.value, p0.value);
        expect_bits(start.velocity, p0.velocity);
        expect_bits(start.acceleration, p0.acceleration);
        expect_bits(end.value, p1.value);
        expect_bits(end.velocity, p1.velocity);
        expect_bits(end.acceleration, p1.acceleration);
    }
}

static void quintic_of_a_constant_is_constant(void **state)
{
    (void)state;
    random_source r = random_from(8);
    for (int i = 0; i < 4000; i++) {
        nkw_motion p = {random_scaled(&r, -60, 60), 0, 0};
        nkw_motion at = nkw_quintic_evaluate(p, p, random_unit(&r));
        expect_bits(at.value, p.value);
        expect_near(at.velocity, 0, 0);
        expect_near(at.acceleration, 0, 0);
    }
}

/* Degree 5 with random coefficients, in double. */
static void quintic_reproduces_polynomials_of_degree_five(void **state)
{
    (void)state;
    random_source r = random_from(9);
    for (int i = 0; i < 4000; i++) {
        double c[6], t = random_unit(&r), x[3][3] = {{0}};
        for (int k = 0; k < 6; k++)
            c[k] = (double)(random_bits(&r) % 65) / 16 - 2; /* sums of these are floats */
        const double at[3] = {0, 1, t};
        for (int j = 0; j < 3; j++)
            for (int k = 5; k >= 0; k--) {
                x[j][2] = x[j][2] * at[j] + 2 * x[j][1];
                x[j][1] = x[j][1] * at[j] + x[j][0];
                x[j][0] = x[j][0] * at[j] + c[k];
            }
        nkw_motion p0 = {(float)x[0][0], (float)x[0][1], (float)x[0][2]},
                        p1 = {(float)x[1][0], (float)x[1][1], (float)x[1][2]};
        nkw_motion p = nkw_quintic_evaluate(p0, p1, (float)t);
        expect_near(p.value, x[2][0], 1e-6);
        expect_near(p.velocity, x[2][1], 4e-6);
        expect_near(p.acceleration, x[2][2], 2e-5);
    }
}

static void quintic_mirrors(void **state)
{
    (void)state;
    random_source r = random_from(10);
    for (int i = 0; i < 4000; i++) {
        nkw_motion p0 = draw_point(&r), p1 = draw_point(&r);
        nkw_motion m0 = {p1.value, -p1.velocity, p1.acceleration}, m1 = {p0.value, -p0.velocity, p0.acceleration};
        float t = random_unit(&r);
        nkw_motion p = nkw_quintic_evaluate(p0, p1, t), m = nkw_quintic_evaluate(m0, m1, 1.0f - t);
        expect_near(p.value, m.value, 1e-6);
        expect_near(p.velocity, -(double)m.velocity, 1e-5);
        expect_near(p.acceleration, m.acceleration, 1e-4);
    }
}

static void points_of_nan_are_nan(void **state)
{
    (void)state;
    const float c[4] = {0, NAN, 1, 0};
    nkw_motion p = nkw_cubic_evaluate(c, 0.5f, NKW_CUBIC_HERMITE), zero = {0, 0, 0}, bad = {NAN, 0, 0};
    expect_nan(p.value);
    expect_nan(p.velocity);
    expect_nan(p.acceleration);
    expect_nan(nkw_quintic_evaluate(zero, bad, 0.25f).value);
    expect_nan(nkw_quintic_evaluate(zero, zero, NAN).velocity);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(value_of_a_point_has_the_bits_of_the_curve),
        cmocka_unit_test(derivatives_of_a_point_are_the_weighted_sums),
        cmocka_unit_test(tangents_come_back_at_the_ends),
        cmocka_unit_test(derivatives_do_not_lose_digits_far_from_the_origin),
        cmocka_unit_test(points_of_vectors_go_by_component),
        cmocka_unit_test(nonuniform_points_have_the_value_of_the_curve_and_its_slope),
        cmocka_unit_test(quintic_returns_its_ends),
        cmocka_unit_test(quintic_of_a_constant_is_constant),
        cmocka_unit_test(quintic_reproduces_polynomials_of_degree_five),
        cmocka_unit_test(quintic_mirrors),
        cmocka_unit_test(points_of_nan_are_nan),
    };
    return cmocka_run_group_tests_name("curve_point", tests, NULL, NULL);
}
