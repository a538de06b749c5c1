/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

static nkw_vec3 vec(float x, float y, float z)
{
    nkw_vec3 r = {x, y, z};
    return r;
}

static nkw_trs trs(nkw_vec3 t, nkw_quat r, nkw_vec3 s)
{
    nkw_trs a = {t, r, s};
    return a;
}

static void expect_columns_near(const nkw_mat4 *got, const nkw_mat4 *want, double part)
{
    for (int c = 0; c < 3; c++) {
        nkw_vec3 a = {got->m[c * 4], got->m[c * 4 + 1], got->m[c * 4 + 2]};
        nkw_vec3 b = {want->m[c * 4], want->m[c * 4 + 1], want->m[c * 4 + 2]};
        expect_vec3_near(a, b, part * (double)nkw_vec3_length(b));
    }
}

static void identity_composes_to_the_identity_matrix(void **state)
{
    (void)state;
    nkw_trs t = nkw_trs_identity();
    nkw_mat4 m = nkw_mat4_from_trs(&t), one = nkw_mat4_identity();
    expect_floats_bits(m.m, one.m, 16);
}

static void scale_comes_first_then_rotation_then_translation(void **state)
{
    (void)state;
    nkw_quat quarter_z = nkw_quat_from_axis_angle(vec(0, 0, 1), 1.57079637f);
    nkw_trs t = trs(vec(10, 20, 30), quarter_z, vec(2, 3, 4));
    nkw_mat4 m = nkw_mat4_from_trs(&t);
    expect_vec3_near(nkw_mat4_transform_point(&m, vec(1, 1, 1)), vec(7, 22, 34), 2e-6);
    expect_vec3_near(nkw_trs_transform_point(&t, vec(1, 1, 1)), vec(7, 22, 34), 2e-6);
}

static void decomposition_gives_back_what_was_composed(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 5000; i++) {
        float size = nkw_abs(random_scaled(&r, -40, 40));
        nkw_vec3 s = nkw_vec3_scale(random_vec3(&r, 0.01f, 1.0f), size);
        nkw_trs t = trs(random_vec3(&r, -10, 10), random_rotation(&r), s);
        nkw_mat4 m = nkw_mat4_from_trs(&t);
        nkw_trs got = nkw_trs_from_mat4(&m);
        expect_vec3_bits(got.translation, t.translation);
        expect_rotation_near(got.rotation, t.rotation, 1e-6);
        expect_ulps(got.scale.x, s.x, 8);
        expect_ulps(got.scale.y, s.y, 8);
        expect_ulps(got.scale.z, s.z, 8);
        assert_true(nkw_trs_residual(&got, &m) < 4e-7f);
    }
}

/* One column at a time: the threshold to binary64 asks each of them. */
static void one_column_far_from_the_others_keeps_its_scale(void **state)
{
    (void)state;
    static const float far[] = {0x1p-40f, 0x1p40f, 1e20f, 1e-20f, 0x1p-31f, 0x1p31f, 0x1p-60f, 0x1p60f};
    random_source r = random_from(15);
    for (int i = 0; i < 2400; i++) {
        nkw_vec3 s = random_vec3(&r, 0.5f, 2.0f);
        (&s.x)[i % 3] *= far[i / 3 % 8];
        nkw_trs t = trs(vec(1, 2, 3), random_rotation(&r), s);
        nkw_mat4 m = nkw_mat4_from_trs(&t);
        nkw_trs got = nkw_trs_from_mat4(&m);
        expect_rotation_near(got.rotation, t.rotation, 1e-6);
        expect_ulps(got.scale.x, s.x, 8);
        expect_ulps(got.scale.y, s.y, 8);
        expect_ulps(got.scale.z, s.z, 8);
    }
}

/* A product with a flat block: its columns are dependent to rounding, so the sign of its determinant is none. */
static void columns_that_are_dependent_to_rounding_do_not_mirror(void **state)
{
    (void)state;
    random_source r = random_from(16);
    for (int i = 0; i < 2000; i++) {
        nkw_mat3 a = nkw_mat3_from_quat(random_rotation(&r)), b = nkw_mat3_from_quat(random_rotation(&r));
        nkw_mat3 flat = {{1, 0, 0, 0, 0, 0, 0, 0, 1}};
        flat = nkw_mat3_mul(&a, &flat);
        flat = nkw_mat3_mul(&flat, &b);
        nkw_mat4 m = nkw_mat4_from_mat3(&flat, vec(0, 0, 0));
        assert_true(nkw_trs_from_mat4(&m).scale.x >= 0);
    }
}

static void a_rotation_that_is_off_unit_is_taken_as_it_stands(void **state)
{
    (void)state;
    static const float lengths[] = {1.00001f, 0.99999f, 1.0003f, 0.99f, 1.3f, 0.1f, 0.0f};
    random_source r = random_from(12);
    for (int i = 0; i < 7000; i++) {
        nkw_trs t = trs(vec(1, 2, 3), nkw_quat_scale(random_rotation(&r), lengths[i % 7]), vec(1, 2, 0.5f));
        nkw_mat4 got = nkw_mat4_from_trs(&t);
        const float *f = &t.rotation.x;
        double q[4] = {f[0], f[1], f[2], f[3]}, scales[3] = {1, 2, 0.5};
        double n2 = (q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]);
        for (int c = 0; c < 3; c++) {
            int a = (c + 1) % 3, b = (c + 2) % 3;
            expect_near(got.m[4 * c + c], scales[c] * (n2 - 2 * (q[a] * q[a] + q[b] * q[b])), 1e-6);
            expect_near(got.m[4 * c + a], scales[c] * 2 * (q[c] * q[a] + q[3] * q[b]), 1e-6);
            expect_near(got.m[4 * c + b], scales[c] * 2 * (q[c] * q[b] - q[3] * q[a]), 1e-6);
        }
    }
}

static void mirrors_show_as_a_negative_x_scale(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 5000; i++) {
        nkw_vec3 s = random_vec3(&r, 0.1f, 2.0f);
        nkw_vec3 signs = {i & 1 ? -1.0f : 1.0f, i & 2 ? -1.0f : 1.0f, i & 4 ? -1.0f : 1.0f};
        nkw_trs t = trs(vec(1, 2, 3), random_rotation(&r), nkw_vec3_mul(s, signs));
        nkw_mat4 m = nkw_mat4_from_trs(&t);
        nkw_trs got = nkw_trs_from_mat4(&m);
        nkw_mat4 again = nkw_mat4_from_trs(&got);
        assert_true((signs.x * signs.y * signs.z < 0) == (got.scale.x < 0));
        assert_true(got.scale.y > 0 && got.scale.z > 0);
        expect_columns_near(&again, &m, 1e-6);
    }
}

static void shear_is_left_out_and_reported(void **state)
{
    (void)state;
    nkw_mat4 m = nkw_mat4_identity();
    m.m[4] = 0.2f;
    nkw_trs got = nkw_trs_from_mat4(&m);
    float residual = nkw_trs_residual(&got, &m);
    assert_true(residual > 0.05f && residual < 0.15f);
    expect_near(nkw_quat_length(got.rotation), 1.0, 2e-7);
    /* The nearest rotation of the unit columns shares the shear between them: half the angle each. */
    nkw_axis_angle turn = nkw_axis_angle_from_quat(got.rotation);
    expect_near(turn.angle, 0.5 * (double)nkw_atan(0.2f), 1e-6);
}

/* R is the rotation nearest to U if and only if R^T U is symmetric (and positive). */
static void rotation_is_the_nearest_at_any_shear(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 5000; i++) {
        float shear = random_scaled(&r, -14, -2);
        nkw_mat3 q = nkw_mat3_from_quat(random_rotation(&r));
        nkw_mat3 sheared = {{1, 0, 0, shear, 1, 0, -shear, shear * 0.5f, 1}};
        nkw_mat3 u = nkw_mat3_mul(&q, &sheared);
        for (size_t c = 0; c < 3; c++) {
            nkw_vec3 unit = nkw_vec3_normalize(nkw_mat3_column(&u, c));
            u.m[c * 3] = unit.x, u.m[c * 3 + 1] = unit.y, u.m[c * 3 + 2] = unit.z;
        }
        nkw_mat4 m = nkw_mat4_from_mat3(&u, vec(0, 0, 0));
        nkw_mat3 rotation = nkw_mat3_from_quat(nkw_trs_from_mat4(&m).rotation);
        nkw_mat3 back = nkw_mat3_transpose(&rotation), p = nkw_mat3_mul(&back, &u);
        nkw_mat3 across = nkw_mat3_transpose(&p);
        expect_floats_near(p.m, across.m, 9, 5e-7);
    }
}

static void zero_scales_are_kept_and_the_rotation_stays_unit(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 800; i++) {
        nkw_vec3 s = {i & 1 ? 0.0f : 1.0f, i & 2 ? 0.0f : 2.0f, i & 4 ? 0.0f : 0.5f};
        nkw_trs t = trs(vec(1, 2, 3), random_rotation(&r), s);
        nkw_mat4 m = nkw_mat4_from_trs(&t);
        nkw_trs got = nkw_trs_from_mat4(&m);
        nkw_mat4 again = nkw_mat4_from_trs(&got);
        expect_near(nkw_quat_length(got.rotation), 1.0, 2e-7);
        expect_columns_near(&again, &m, 1e-6);
        assert_true((got.scale.x == 0) == (s.x == 0) && (got.scale.y == 0) == (s.y == 0));
    }
}

static void matrix_of_zeros_has_no_rotation(void **state)
{
    (void)state;
    nkw_mat4 zero = {{0}};
    nkw_trs got = nkw_trs_from_mat4(&zero);
    expect_quat_bits(got.rotation, nkw_quat_identity());
    expect_vec3_near(got.scale, vec(0, 0, 0), 0);
    expect_bits(nkw_trs_residual(&got, &zero), 0.0f);
}

static void residual_of_what_is_not_finite_is_nan(void **state)
{
    (void)state;
    static const float bad[] = {NAN, INFINITY, -INFINITY};
    for (size_t i = 0; i < 11; i++)
        for (size_t k = 0; i % 4 != 3 && k < 3; k++) {
            nkw_mat4 m = nkw_mat4_identity(), zero = {{0}};
            m.m[i] = zero.m[i] = bad[k];
            nkw_trs got = nkw_trs_from_mat4(&m);
            assert_true(isnan(nkw_trs_residual(&got, &m)));
            assert_true(isnan(nkw_trs_residual(&got, &zero)));
        }
}

static void product_is_the_matrix_product_where_scales_are_uniform(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 5000; i++) {
        float s = random_between(&r, 0.5f, 2.0f);
        nkw_trs a = trs(random_vec3(&r, -5, 5), random_rotation(&r), vec(s, s, s));
        nkw_trs b = trs(random_vec3(&r, -5, 5), random_rotation(&r), random_vec3(&r, 0.5f, 2));
        nkw_trs ab = nkw_trs_mul(&a, &b);
        nkw_mat4 ma = nkw_mat4_from_trs(&a), mb = nkw_mat4_from_trs(&b), product = nkw_mat4_mul(&ma, &mb);
        nkw_mat4 got = nkw_mat4_from_trs(&ab);
        expect_floats_near(got.m, product.m, 16, 1e-5);
    }
}

/* Element by element in binary64, for quaternions that are unit to rounding. */
static void composition_is_exact_to_its_bound(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 5000; i++) {
        nkw_trs t = trs(random_vec3(&r, -9, 9), random_rotation(&r), random_vec3(&r, -2, 2));
        nkw_mat4 got = nkw_mat4_from_trs(&t);
        const double x = t.rotation.x, y = t.rotation.y, z = t.rotation.z, w = t.rotation.w;
        const double q[4] = {x, y, z, w}, n2 = (x * x + y * y) + (z * z + w * w);
        const double scales[3] = {t.scale.x, t.scale.y, t.scale.z};
        for (int c = 0; c < 3; c++) {
            int a = (c + 1) % 3, b = (c + 2) % 3;
            double s = scales[c] / n2, bound = 4.2 * 0x1p-24 * fabs(scales[c]);
            expect_near(got.m[4 * c + c], s * (n2 - 2 * (q[a] * q[a] + q[b] * q[b])), bound);
            expect_near(got.m[4 * c + a], s * 2 * (q[c] * q[a] + q[3] * q[b]), bound);
            expect_near(got.m[4 * c + b], s * 2 * (q[c] * q[b] - q[3] * q[a]), bound);
            expect_bits(got.m[4 * c + 3], 0.0f);
        }
        expect_vec3_bits(nkw_mat4_translation(&got), t.translation);
        expect_bits(got.m[15], 1.0f);
    }
}

static void the_block_alone_has_the_bits_of_the_whole(void **state)
{
    (void)state;
    static const float lengths[] = {1.0f, 1.0000002f, 0.99999f, 1.0003f, 0.99f, 1.3f, 0.1f};
    random_source r = random_from(8);
    for (int i = 0; i < 7000; i++) {
        nkw_trs t = trs(vec(1, 2, 3), nkw_quat_scale(random_rotation(&r), lengths[i % 7]), random_vec3(&r, -2, 2));
        nkw_mat4 whole = nkw_mat4_from_trs(&t);
        nkw_mat3 block = nkw_mat3_from_quat_scale(t.rotation, t.scale), of_whole = nkw_mat3_from_mat4(&whole);
        expect_floats_bits(block.m, of_whole.m, 9);
    }
}

/* The next column is perpendicular to the one that has a length. */
static void one_column_alone_has_a_known_rotation(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (int i = 0; i < 3000; i++) {
        int c = i % 3;
        nkw_vec3 axis = random_direction(&r), across = nkw_vec3_perpendicular(axis);
        nkw_mat4 m = nkw_mat4_identity();
        memset(m.m, 0, 12 * sizeof(float));
        m.m[4 * c] = axis.x, m.m[4 * c + 1] = axis.y, m.m[4 * c + 2] = axis.z;
        nkw_trs got = nkw_trs_from_mat4(&m);
        nkw_mat3 rotation = nkw_mat3_from_quat(got.rotation);
        expect_vec3_near(nkw_mat3_column(&rotation, (size_t)c), axis, 5e-7);
        expect_vec3_near(nkw_mat3_column(&rotation, (size_t)(c + 1) % 3), across, 5e-7);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(identity_composes_to_the_identity_matrix),
        cmocka_unit_test(scale_comes_first_then_rotation_then_translation),
        cmocka_unit_test(decomposition_gives_back_what_was_composed),
        cmocka_unit_test(one_column_far_from_the_others_keeps_its_scale),
        cmocka_unit_test(columns_that_are_dependent_to_rounding_do_not_mirror),
        cmocka_unit_test(a_rotation_that_is_off_unit_is_taken_as_it_stands),
        cmocka_unit_test(mirrors_show_as_a_negative_x_scale),
        cmocka_unit_test(shear_is_left_out_and_reported),
        cmocka_unit_test(rotation_is_the_nearest_at_any_shear),
        cmocka_unit_test(zero_scales_are_kept_and_the_rotation_stays_unit),
        cmocka_unit_test(matrix_of_zeros_has_no_rotation),
        cmocka_unit_test(residual_of_what_is_not_finite_is_nan),
        cmocka_unit_test(product_is_the_matrix_product_where_scales_are_uniform),
        cmocka_unit_test(composition_is_exact_to_its_bound),
        cmocka_unit_test(the_block_alone_has_the_bits_of_the_whole),
        cmocka_unit_test(one_column_alone_has_a_known_rotation),
    };
    return cmocka_run_group_tests_name("transform", tests, NULL, NULL);
}
