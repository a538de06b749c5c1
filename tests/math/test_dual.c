/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

#define ROUNDS 2000

static void expect_dual_near(const nkw_dual_quat *got, const nkw_dual_quat *want, double bound)
{
    expect_quat_near(got->real, want->real, bound);
    expect_quat_near(got->dual, want->dual, bound);
}

static nkw_dual_quat draw(random_source *r)
{
    nkw_quat q = random_rotation(r);
    nkw_vec3 t = random_vec3(r, -4, 4);
    return nkw_dual_quat_from_rigid(q, t);
}

static nkw_dual_quat negated(const nkw_dual_quat *d)
{
    nkw_dual_quat r = {nkw_quat_negate(d->real), nkw_quat_negate(d->dual)};
    return r;
}

static nkw_dual_quat conjugate(const nkw_dual_quat *d)
{
    nkw_dual_quat r = {nkw_quat_conjugate(d->real), nkw_quat_conjugate(d->dual)};
    return r;
}

static void the_identity_moves_nothing(void **state)
{
    (void)state;
    random_source r = random_from(1);
    nkw_dual_quat none = nkw_dual_quat_from_rigid(nkw_quat_identity(), NKW_VEC3_ZERO), made;
    nkw_vec3 p = random_vec3(&r, -3, 3), zero = {0, 0, 0};
    made = nkw_dual_quat_from_rigid(nkw_quat_identity(), zero);
    assert_memory_equal(&none.real, &made.real, sizeof none.real);
    expect_quat_near(none.dual, made.dual, 0.0);
    expect_vec3_near(nkw_dual_quat_transform_point(&none, p), p, 0.0);
    nkw_mat4 m = nkw_mat4_from_dual_quat(&none), one = nkw_mat4_identity();
    expect_floats_near(m.m, one.m, 16, 0.0);
}

static void a_quarter_turn_and_a_move_by_hand(void **state)
{
    (void)state;
    /* A quarter turn about z, then (2, 4, 6): dual = (1, 2, 3, 0)(0, 0, s, s), s = sqrt(1/2). */
    const float s = 0.70710678f;
    nkw_quat quarter = {0, 0, s, s}, dual = {3 * s, 1 * s, 3 * s, -3 * s};
    nkw_vec3 t = {2, 4, 6}, x = {1, 0, 0}, want = {2, 5, 6}, y = {0, 1, 0};
    nkw_dual_quat d = nkw_dual_quat_from_rigid(quarter, t);
    expect_quat_bits(d.real, quarter);
    expect_quat_near(d.dual, dual, 3e-7);
    expect_vec3_near(nkw_dual_quat_transform_point(&d, NKW_VEC3_ZERO), t, 1e-6);
    expect_vec3_near(nkw_dual_quat_transform_point(&d, x), want, 1e-6);
    expect_vec3_near(nkw_quat_rotate(d.real, x), y, 1e-6);
}

static void points_go_where_the_matrix_takes_them(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < ROUNDS; i++) {
        nkw_dual_quat d = draw(&r);
        nkw_vec3 p = random_vec3(&r, -3, 3), t = nkw_dual_quat_transform_point(&d, NKW_VEC3_ZERO);
        nkw_mat3 linear = nkw_mat3_from_quat(d.real);
        nkw_mat4 m = nkw_mat4_from_dual_quat(&d), want = nkw_mat4_from_mat3(&linear, t);
        expect_floats_bits(m.m, want.m, 16);
        expect_vec3_near(nkw_dual_quat_transform_point(&d, p), nkw_mat4_transform_point(&m, p), 4e-6);
        expect_vec3_near(nkw_quat_rotate(d.real, p), nkw_mat4_transform_direction(&m, p), 3e-6);
    }
}

static void translations_come_back(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < ROUNDS; i++) {
        nkw_quat q = random_rotation(&r);
        nkw_vec3 t = random_vec3(&r, -4, 4);
        nkw_dual_quat d = nkw_dual_quat_from_rigid(q, t);
        expect_vec3_near(nkw_dual_quat_transform_point(&d, NKW_VEC3_ZERO), t, 3e-6);
    }
}

static void products_apply_the_right_one_first(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < ROUNDS; i++) {
        nkw_dual_quat a = draw(&r), b = draw(&r), ab = nkw_dual_quat_mul(&a, &b);
        nkw_vec3 p = random_vec3(&r, -3, 3);
        nkw_vec3 want = nkw_dual_quat_transform_point(&a, nkw_dual_quat_transform_point(&b, p));
        expect_vec3_near(nkw_dual_quat_transform_point(&ab, p), want, 1e-5);
    }
}

static void the_conjugate_is_the_inverse(void **state)
{
    (void)state;
    random_source r = random_from(5);
    nkw_dual_quat none = nkw_dual_quat_from_rigid(nkw_quat_identity(), NKW_VEC3_ZERO);
    for (int i = 0; i < ROUNDS; i++) {
        nkw_dual_quat d = draw(&r), back = conjugate(&d), both = nkw_dual_quat_mul(&back, &d);
        expect_dual_near(&both, &none, 2e-6);
    }
}

static void rigid_matrices_come_back_with_w_not_negative(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < ROUNDS; i++) {
        nkw_dual_quat d = draw(&r), got;
        nkw_mat4 m = nkw_mat4_from_dual_quat(&d);
        got = nkw_dual_quat_from_mat4(&m);
        assert_true(got.real.w >= 0.0f);
        if (d.real.w < 0.0f)
            d = negated(&d);
        expect_dual_near(&got, &d, 3e-6);
    }
}

static void half_turns_have_their_largest_component_positive(void **state)
{
    (void)state;
    const nkw_mat4 about_x = {{1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1}};
    const nkw_mat4 about_z = {{-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
    nkw_dual_quat x = nkw_dual_quat_from_mat4(&about_x), z = nkw_dual_quat_from_mat4(&about_z);
    nkw_quat want_x = {1, 0, 0, 0}, want_z = {0, 0, 1, 0};
    expect_quat_near(x.real, want_x, 1e-7);
    expect_quat_near(z.real, want_z, 1e-7);
    nkw_mat4 nearly = about_x;
    nearly.m[6] = -0x1p-149f;
    expect_quat_near(nkw_dual_quat_from_mat4(&nearly).real, want_x, 1e-7);
}

static nkw_trs draw_scaled(random_source *r)
{
    nkw_trs trs = {random_vec3(r, -4, 4), random_rotation(r), random_vec3(r, 0.01f, 9)};
    if (trs.rotation.w < 0.0f)
        trs.rotation = nkw_quat_negate(trs.rotation);
    return trs;
}

static void expect_unscaled(const nkw_mat4 *m, const nkw_trs *trs)
{
    nkw_dual_quat got = nkw_dual_quat_from_mat4(m), want = nkw_dual_quat_from_rigid(trs->rotation, trs->translation);
    expect_dual_near(&got, &want, 2e-6);
}

/* Each axis in turn, as nkw_trs_from_mat4 does. */
static void a_scale_of_zero_along_one_axis_leaves_the_rotation(void **state)
{
    (void)state;
    random_source r = random_from(8);
    for (int i = 0; i < ROUNDS; i++) {
        nkw_trs trs = draw_scaled(&r);
        *(i % 3 == 0 ? &trs.scale.x : i % 3 == 1 ? &trs.scale.y : &trs.scale.z) = 0.0f;
        nkw_mat4 m = nkw_mat4_from_trs(&trs);
        expect_unscaled(&m, &trs);
    }
}

static void scale_and_mirroring_are_dropped(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (int i = 0; i < ROUNDS; i++) {
        nkw_trs trs = draw_scaled(&r);
        nkw_mat4 m = nkw_mat4_from_trs(&trs);
        expect_unscaled(&m, &trs);
        for (int k = 0; k < 12; k++)
            m.m[k] = -m.m[k];
        expect_unscaled(&m, &trs);
    }
}

static void a_matrix_of_zeros_gives_no_rotation_and_nan_gives_nan(void **state)
{
    (void)state;
    nkw_mat4 m = {{0}};
    m.m[12] = 2.0f;
    nkw_dual_quat d = nkw_dual_quat_from_mat4(&m);
    expect_quat_near(d.real, nkw_quat_identity(), 0.0);
    expect_near(d.dual.x, 1.0, 0.0);
    m.m[5] = NAN;
    d = nkw_dual_quat_from_mat4(&m);
    expect_nan(d.real.w);
}

static void normalize_keeps_unit_ones_and_mends_others(void **state)
{
    (void)state;
    random_source r = random_from(8);
    for (int i = 0; i < ROUNDS; i++) {
        nkw_dual_quat d = draw(&r), same = nkw_dual_quat_normalize(&d), bent, n;
        expect_dual_near(&same, &d, 1e-6);
        float s = random_between(&r, 0.1f, 5.0f), off = random_between(&r, -1, 1);
        bent.real = nkw_quat_scale(d.real, s);
        bent.dual = nkw_quat_scale(nkw_quat_add(d.dual, nkw_quat_scale(d.real, off)), s);
        n = nkw_dual_quat_normalize(&bent);
        expect_dual_near(&n, &d, 2e-6);
        expect_near(nkw_quat_dot(n.real, n.dual), 0.0, 1e-6);
    }
}

static void normalize_of_zero_is_the_identity_and_of_nan_is_nan(void **state)
{
    (void)state;
    nkw_dual_quat d = {{0, 0, 0, 0}, {1, 2, 3, 4}}, none = nkw_dual_quat_from_rigid(nkw_quat_identity(), NKW_VEC3_ZERO);
    nkw_dual_quat got = nkw_dual_quat_normalize(&d);
    assert_memory_equal(&got, &none, sizeof got);
    d.real.y = NAN;
    got = nkw_dual_quat_normalize(&d);
    expect_nan(got.real.x);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_identity_moves_nothing),
        cmocka_unit_test(a_quarter_turn_and_a_move_by_hand),
        cmocka_unit_test(points_go_where_the_matrix_takes_them),
        cmocka_unit_test(translations_come_back),
        cmocka_unit_test(products_apply_the_right_one_first),
        cmocka_unit_test(the_conjugate_is_the_inverse),
        cmocka_unit_test(rigid_matrices_come_back_with_w_not_negative),
        cmocka_unit_test(half_turns_have_their_largest_component_positive),
        cmocka_unit_test(scale_and_mirroring_are_dropped),
        cmocka_unit_test(a_scale_of_zero_along_one_axis_leaves_the_rotation),
        cmocka_unit_test(a_matrix_of_zeros_gives_no_rotation_and_nan_gives_nan),
        cmocka_unit_test(normalize_keeps_unit_ones_and_mends_others),
        cmocka_unit_test(normalize_of_zero_is_the_identity_and_of_nan_is_nan),
    };
    return cmocka_run_group_tests_name("dual", tests, NULL, NULL);
}
