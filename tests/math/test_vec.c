/* SPDX-License-Identifier: MIT */
#include <float.h>
#include <math.h>

#include "random.h"
#include "support/expect.h"

static nkw_vec3 vec(float x, float y, float z)
{
    nkw_vec3 r = {x, y, z};
    return r;
}

static void sums_differences_and_products_go_by_component(void **state)
{
    (void)state;
    nkw_vec3 a = vec(1, -2, 3), b = vec(4, 5, -6);
    expect_vec3_bits(nkw_vec3_add(a, b), vec(5, 3, -3));
    expect_vec3_bits(nkw_vec3_sub(a, b), vec(-3, -7, 9));
    expect_vec3_bits(nkw_vec3_mul(a, b), vec(4, -10, -18));
    expect_vec3_bits(nkw_vec3_scale(a, -2), vec(-2, 4, -6));
    expect_vec3_bits(nkw_vec3_negate(a), vec(-1, 2, -3));
    expect_vec3_bits(nkw_vec3_add_scaled(a, b, 0.5f), vec(3, 0.5f, 0));
    expect_vec3_bits(nkw_vec3_min(a, b), vec(1, -2, -6));
    expect_vec3_bits(nkw_vec3_max(a, b), vec(4, 5, 3));
    expect_vec3_bits(NKW_VEC3_ZERO, vec(0, 0, 0));
}

static void cross_of_x_and_y_is_z(void **state)
{
    (void)state;
    expect_vec3_bits(nkw_vec3_cross(vec(1, 0, 0), vec(0, 1, 0)), vec(0, 0, 1));
    expect_vec3_bits(nkw_vec3_cross(vec(0, 1, 0), vec(0, 0, 1)), vec(1, 0, 0));
    expect_vec3_bits(nkw_vec3_cross(vec(0, 0, 1), vec(1, 0, 0)), vec(0, 1, 0));
}

static void dot_and_length_know_pythagoras(void **state)
{
    (void)state;
    expect_bits(nkw_vec3_dot(vec(1, 2, 3), vec(4, -5, 6)), 12.0f);
    expect_bits(nkw_vec3_dot(vec(2, 3, 6), vec(2, 3, 6)), 49.0f);
    expect_bits(nkw_vec3_length(vec(2, 3, 6)), 7.0f);
    expect_bits(nkw_vec3_distance(vec(1, 1, 1), vec(3, 4, 7)), 7.0f);
}

static void length_neither_overflows_nor_underflows(void **state)
{
    (void)state;
    float tiny = 0x1p-149f;
    expect_bits(nkw_vec3_length(vec(3 * tiny, 4 * tiny, 0)), 5 * tiny);
    expect_ulps(nkw_vec3_length(vec(2e38f, 2e38f, 0)), 2.8284271e38f, 1);
    expect_bits(nkw_vec3_length(vec(FLT_MAX, FLT_MAX, 0)), INFINITY);
    expect_bits(nkw_vec3_length(vec(0, -0.0f, 0)), 0.0f);
}

static void normalize_gives_a_unit_vector_of_any_finite_one(void **state)
{
    (void)state;
    static const float sizes[] = {0x1p-149f, 1e-40f, 1e-30f, 1e-15f, 1.0f, 1e15f, 1e30f, 3e38f};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        nkw_vec3 u = nkw_vec3_normalize(vec(-sizes[i], 0, 0));
        expect_vec3_bits(u, vec(-1, 0, 0));
        nkw_vec3 v = nkw_vec3_normalize(vec(sizes[i], -sizes[i], sizes[i]));
        expect_vec3_near(v, vec(0.57735027f, -0.57735027f, 0.57735027f), 1e-7);
    }
}

static void normalize_of_zero_is_zero(void **state)
{
    (void)state;
    expect_vec3_bits(nkw_vec3_normalize(vec(0, 0, 0)), vec(0, 0, 0));
    expect_nan(nkw_vec3_normalize(vec(NAN, 1, 0)).x);
    expect_nan(nkw_vec3_normalize(vec(INFINITY, 1, 0)).x);
}

static void lerp_is_exact_at_its_ends_and_between_equals(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 20000; i++) {
        nkw_vec3 a = {random_finite(&r) * 0.25f, random_finite(&r) * 0.25f, -0.0f};
        nkw_vec3 b = {random_finite(&r) * 0.25f, random_finite(&r) * 0.25f, random_unit(&r)};
        expect_vec3_bits(nkw_vec3_lerp(a, b, 0.0f), a);
        expect_vec3_bits(nkw_vec3_lerp(a, b, 1.0f), b);
        expect_vec3_near(nkw_vec3_lerp(b, b, random_unit(&r)), b, 0.0);
    }
}

static void angle_is_exact_near_zero_and_near_pi(void **state)
{
    (void)state;
    expect_bits(nkw_vec3_angle(vec(1, 0, 0), vec(5, 0, 0)), 0.0f);
    expect_ulps(nkw_vec3_angle(vec(1, 0, 0), vec(1, 1e-6f, 0)), 1e-6f, 0);
    expect_bits(nkw_vec3_angle(vec(1, 0, 0), vec(-2, 0, 0)), 3.14159265358979f);
    expect_bits(nkw_vec3_angle(vec(0, 3, 0), vec(0, 0, 2)), 1.57079632679490f);
    expect_bits(nkw_vec3_angle(vec(0, 0, 0), vec(0, 0, 2)), 0.0f);
    expect_bits(nkw_vec3_angle(vec(1e-40f, 0, 0), vec(0, 3e38f, 0)), 1.57079632679490f);
}

static void project_and_reject_part_a_vector(void **state)
{
    (void)state;
    expect_vec3_bits(nkw_vec3_project(vec(1, 2, 3), vec(0, 5, 0)), vec(0, 2, 0));
    expect_vec3_bits(nkw_vec3_reject(vec(1, 2, 3), vec(0, 5, 0)), vec(1, 0, 3));
    expect_vec3_bits(nkw_vec3_project(vec(1, 2, 3), vec(0, 0, 0)), vec(0, 0, 0));
    expect_vec3_bits(nkw_vec3_reject(vec(1, 2, 3), vec(0, 0, 0)), vec(1, 2, 3));
}

static void reflect_turns_the_part_along_the_normal(void **state)
{
    (void)state;
    expect_vec3_bits(nkw_vec3_reflect(vec(1, -2, 3), vec(0, 1, 0)), vec(1, 2, 3));
}

static void perpendicular_is_unit_and_at_right_angles(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 20000; i++) {
        nkw_vec3 a = random_vec3(&r, -10, 10), p = nkw_vec3_perpendicular(a);
        expect_near(nkw_vec3_length(p), 1.0, 1e-7);
        expect_near(nkw_vec3_dot(a, p), 0.0, 2e-6);
    }
    expect_vec3_bits(nkw_vec3_perpendicular(vec(0, 0, 0)), vec(1, 0, 0));
    for (int k = 0; k < 3; k++)
        for (int m = 1; m < 8; m++) {
            nkw_vec3 a = {k == 0 ? NAN : (float)(m & 1), k == 1 ? NAN : (float)(m & 2), k == 2 ? NAN : (float)(m & 4)};
            expect_nan(nkw_vec3_length(nkw_vec3_perpendicular(a)));
        }
    expect_near(nkw_vec3_length(nkw_vec3_perpendicular(vec(0, 0x1p-149f, 0))), 1.0, 1e-7);
}

/* Crossed with the axis of the smallest component: of equal ones x before y before z. */
static void perpendicular_takes_the_first_of_equal_components(void **state)
{
    (void)state;
    const float a = 0x1.6a09e6p-1f, b = 0x1.c9f25cp-1f, c = 0x1.c9f25cp-2f;
    expect_vec3_near(nkw_vec3_perpendicular(vec(1, 1, 1)), vec(0, -a, a), 0);
    expect_vec3_near(nkw_vec3_perpendicular(vec(1, 1, 2)), vec(0, -b, c), 0);
    expect_vec3_near(nkw_vec3_perpendicular(vec(-1, 2, 1)), vec(0, -c, b), 0);
    expect_vec3_near(nkw_vec3_perpendicular(vec(2, 1, 1)), vec(c, 0, -b), 0);
    expect_vec3_near(nkw_vec3_perpendicular(vec(2, 2, 1)), vec(-a, a, 0), 0);
}

static void is_finite_sees_each_component(void **state)
{
    (void)state;
    assert_int_equal(nkw_vec3_is_finite(vec(FLT_MAX, -FLT_MAX, 0)), 1);
    assert_int_equal(nkw_vec3_is_finite(vec(NAN, 0, 0)), 0);
    assert_int_equal(nkw_vec3_is_finite(vec(0, INFINITY, 0)), 0);
    assert_int_equal(nkw_vec3_is_finite(vec(0, 0, -INFINITY)), 0);
}

/*
 * Sums of products, each product rounded: (1 + e)^2 = 1 + 2e + e^2 with e = 2^-12, whose e^2 rounding takes, less
 * 1 + 2e. A fused product keeps the e^2.
 */
static void products_are_rounded_before_they_are_summed(void **state)
{
    (void)state;
    const float e = 0x1p-12f, a = 1 + e, s = -(1 + 2 * e);
    const nkw_vec3 p[3] = {vec(a, s, 0), vec(0, a, s), vec(s, 0, a)}, q[3] = {vec(a, 1, 0), vec(0, a, 1), vec(1, 0, a)};
    const nkw_vec3 c[3] = {vec(a, 1, 0), vec(0, a, 1), vec(1, 0, a)},
                   d[3] = {vec(-s, a, 0), vec(0, -s, a), vec(a, 0, -s)};
    for (int i = 0; i < 3; i++) {
        expect_near(nkw_vec3_dot(p[i], q[i]), 0.0, 0);
        expect_near(nkw_vec3_dot(q[i], p[i]), 0.0, 0);
        /* a a - 1 (1 + 2e) in one component. */
        nkw_vec3 cross = nkw_vec3_cross(c[i], d[i]);
        expect_near(cross.x, 0.0, 0);
        expect_near(cross.y, 0.0, 0);
        expect_near(cross.z, 0.0, 0);
    }
    expect_vec3_near(nkw_vec3_add_scaled(vec(s, s, s), vec(a, a, a), a), vec(0, 0, 0), 0);
    expect_near(nkw_vec3_dot(vec(a, e, 0), vec(a, e, 0)), 1 + 2 * (double)e, 0);
}

static double exact_length(nkw_vec3 a)
{
    double x = a.x, y = a.y, z = a.z;
    return sqrt((x * x + y * y) + z * z);
}

/* Lengths of every size and those near 1, where a vector might be taken for unit already. */
static void normalize_and_length_are_exact_to_their_bound(void **state)
{
    (void)state;
    random_source r = random_from(31);
    for (int i = 0; i < 20000; i++) {
        float size = i % 2 ? 1.0f + random_scaled(&r, -24, -12) : random_scaled(&r, -100, 100);
        nkw_vec3 a = nkw_vec3_scale(random_direction(&r), size), unit = nkw_vec3_normalize(a);
        double length = exact_length(a), bound = 2.3 * 0x1p-24;
        expect_near(unit.x, (double)a.x / length, bound);
        expect_near(unit.y, (double)a.y / length, bound);
        expect_near(unit.z, (double)a.z / length, bound);
        expect_ulps(nkw_vec3_length(a), (float)length, 0);
    }
}

static void a_move_is_as_long_as_its_step(void **state)
{
    (void)state;
    nkw_vec3 from = {1, 2, 3}, to = {1, 5, 7}, back = nkw_vec3_move_towards(from, to, -1.0f);
    nkw_vec3 some = nkw_vec3_move_towards(from, to, 2.5f), all = nkw_vec3_move_towards(from, to, 5.0f);
    nkw_vec3 half = {1, 3.5f, 5};
    assert_true(nkw_vec3_equal_within(some, half, 0.0f));
    assert_memory_equal(&all, &to, sizeof to);
    assert_memory_equal(&back, &from, sizeof from);
    assert_false(nkw_vec3_is_finite(nkw_vec3_move_towards(from, to, NAN)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums_differences_and_products_go_by_component),
        cmocka_unit_test(cross_of_x_and_y_is_z),
        cmocka_unit_test(dot_and_length_know_pythagoras),
        cmocka_unit_test(length_neither_overflows_nor_underflows),
        cmocka_unit_test(normalize_gives_a_unit_vector_of_any_finite_one),
        cmocka_unit_test(normalize_of_zero_is_zero),
        cmocka_unit_test(lerp_is_exact_at_its_ends_and_between_equals),
        cmocka_unit_test(angle_is_exact_near_zero_and_near_pi),
        cmocka_unit_test(project_and_reject_part_a_vector),
        cmocka_unit_test(reflect_turns_the_part_along_the_normal),
        cmocka_unit_test(perpendicular_is_unit_and_at_right_angles),
        cmocka_unit_test(perpendicular_takes_the_first_of_equal_components),
        cmocka_unit_test(is_finite_sees_each_component),
        cmocka_unit_test(products_are_rounded_before_they_are_summed),
        cmocka_unit_test(normalize_and_length_are_exact_to_their_bound),
        cmocka_unit_test(a_move_is_as_long_as_its_step),
    };
    return cmocka_run_group_tests_name("vec", tests, NULL, NULL);
}
