/* SPDX-License-Identifier: MIT */
#include <float.h>
#include <math.h>

#include "random.h"
#include "support/expect.h"

static const nkw_quat identity = {0, 0, 0, 1};
static const nkw_quat quarter_x = {0x1.6a09e6p-1f, 0, 0, 0x1.6a09e6p-1f};

static nkw_vec3 vec(float x, float y, float z)
{
    nkw_vec3 r = {x, y, z};
    return r;
}

static nkw_quat quat(float x, float y, float z, float w)
{
    nkw_quat r = {x, y, z, w};
    return r;
}

static void identity_changes_nothing(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 10000; i++) {
        nkw_quat q = random_rotation(&r);
        nkw_vec3 v = random_vec3(&r, -10, 10);
        expect_quat_bits(nkw_quat_mul(identity, q), q);
        expect_quat_bits(nkw_quat_mul(q, identity), q);
        expect_vec3_bits(nkw_quat_rotate(identity, v), v);
    }
}

static void i_times_j_is_k(void **state)
{
    (void)state;
    nkw_quat i = {1, 0, 0, 0}, j = {0, 1, 0, 0}, k = {0, 0, 1, 0};
    expect_quat_near(nkw_quat_mul(i, j), k, 0);
    expect_quat_near(nkw_quat_mul(j, k), i, 0);
    expect_quat_near(nkw_quat_mul(k, i), j, 0);
    expect_quat_near(nkw_quat_mul(j, i), nkw_quat_negate(k), 0);
    expect_quat_near(nkw_quat_mul(i, i), nkw_quat_negate(identity), 0);
}

static void a_quarter_turn_about_x_takes_y_to_z(void **state)
{
    (void)state;
    expect_vec3_near(nkw_quat_rotate(quarter_x, vec(0, 1, 0)), vec(0, 0, 1), 1e-7);
    expect_vec3_near(nkw_quat_rotate_inverse(quarter_x, vec(0, 0, 1)), vec(0, 1, 0), 1e-7);
}

static void product_rotates_by_the_right_factor_first(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 10000; i++) {
        nkw_quat a = random_rotation(&r), b = random_rotation(&r);
        nkw_vec3 v = random_vec3(&r, -1, 1);
        expect_vec3_near(nkw_quat_rotate(nkw_quat_mul(a, b), v), nkw_quat_rotate(a, nkw_quat_rotate(b, v)), 3e-6);
    }
}

static void rotation_agrees_with_its_matrix(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 10000; i++) {
        nkw_quat q = random_rotation(&r);
        nkw_vec3 v = random_vec3(&r, -1, 1);
        nkw_mat3 m = nkw_mat3_from_quat(q);
        expect_vec3_near(nkw_quat_rotate(q, v), nkw_mat3_transform(&m, v), 2e-6);
    }
}

static void normalize_works_from_the_smallest_to_the_largest(void **state)
{
    (void)state;
    expect_quat_bits(nkw_quat_normalize(quat(0, 0, 0, 0)), identity);
    expect_quat_bits(nkw_quat_normalize(quat(0x1p-149f, 0, 0, 0)), quat(1, 0, 0, 0));
    expect_quat_bits(nkw_quat_normalize(quat(0, -3e38f, 0, 0)), quat(0, -1, 0, 0));
    expect_quat_near(nkw_quat_normalize(quat(1e-42f, 1e-42f, -1e-42f, 1e-42f)), quat(0.5f, 0.5f, -0.5f, 0.5f), 1e-7);
    expect_quat_near(nkw_quat_normalize(quat(3e38f, 3e38f, 3e38f, 3e38f)), quat(0.5f, 0.5f, 0.5f, 0.5f), 1e-7);
    expect_nan(nkw_quat_normalize(quat(NAN, 0, 0, 1)).w);
}

static void inverse_undoes_any_quaternion(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 10000; i++) {
        nkw_quat q = nkw_quat_scale(random_rotation(&r), random_scaled(&r, -20, 20));
        expect_quat_near(nkw_quat_mul(q, nkw_quat_inverse(q)), identity, 5e-7);
    }
    expect_quat_bits(nkw_quat_inverse(quat(0, 0, 0, 0)), identity);
    expect_quat_bits(nkw_quat_conjugate(quat(1, 2, 3, 4)), quat(-1, -2, -3, 4));
}

static void axis_and_angle_go_there_and_back(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 10000; i++) {
        nkw_vec3 axis = random_direction(&r);
        float angle = random_between(&r, 1e-3f, 3.14f);
        nkw_axis_angle back = nkw_axis_angle_from_quat(nkw_quat_from_axis_angle(axis, angle));
        expect_near(back.angle, angle, 1e-6);
        expect_vec3_near(back.axis, axis, 1e-4);
    }
}

static void axis_angle_of_no_turn_has_no_axis(void **state)
{
    (void)state;
    nkw_axis_angle none = nkw_axis_angle_from_quat(quat(0, 0, 0, -1));
    nkw_axis_angle nothing = nkw_axis_angle_from_quat(quat(0, 0, 0, -0.0f));
    expect_bits(nothing.angle, 0.0f);
    expect_vec3_near(none.axis, vec(0, 0, 0), 0);
    expect_bits(none.angle, 0.0f);
    expect_quat_bits(nkw_quat_from_axis_angle(vec(0, 0, 0), 1.0f), identity);
    nkw_axis_angle tiny = nkw_axis_angle_from_quat(quat(1e-30f, 0, 0, 1));
    expect_ulps(tiny.angle, 2e-30f, 1);
    expect_vec3_bits(tiny.axis, vec(1, 0, 0));
}

static void axis_need_not_be_unit_and_angle_need_not_be_small(void **state)
{
    (void)state;
    expect_quat_near(nkw_quat_from_axis_angle(vec(1e-42f, 0, 0), 1.57079637f), quarter_x, 1e-7);
    expect_quat_near(nkw_quat_from_axis_angle(vec(1e38f, 0, 0), 1.57079637f), quarter_x, 1e-7);
    expect_near(nkw_quat_length(nkw_quat_from_axis_angle(vec(0, 1, 0), 1e30f)), 1.0, 1e-7);
}

static void from_vectors_takes_one_direction_to_the_other(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 10000; i++) {
        nkw_vec3 a = random_direction(&r), b = random_direction(&r);
        nkw_quat q = nkw_quat_from_vectors(a, nkw_vec3_scale(b, 3.0f));
        expect_vec3_near(nkw_quat_rotate(q, a), b, 2e-6);
    }
}

static void from_vectors_turns_opposites_by_pi_and_equals_by_nothing(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (int i = 0; i < 10000; i++) {
        nkw_vec3 a = random_direction(&r);
        nkw_vec3 nearly = nkw_vec3_negate(nkw_vec3_add_scaled(a, random_direction(&r), 1e-6f));
        expect_quat_bits(nkw_quat_from_vectors(a, a), identity);
        expect_vec3_near(nkw_quat_rotate(nkw_quat_from_vectors(a, nkw_vec3_negate(a)), a), nkw_vec3_negate(a), 2e-6);
        expect_vec3_near(nkw_quat_rotate(nkw_quat_from_vectors(a, nearly), a), nkw_vec3_normalize(nearly), 2e-6);
    }
    expect_quat_bits(nkw_quat_from_vectors(vec(0, 0, 0), vec(1, 0, 0)), identity);
}

static void look_rotation_points_minus_z_forward_and_y_up(void **state)
{
    (void)state;
    expect_rotation_near(nkw_quat_look_rotation(vec(0, 0, -1), vec(0, 1, 0)), identity, 0);
    random_source r = random_from(8);
    for (int i = 0; i < 10000; i++) {
        nkw_vec3 f = random_direction(&r), u = random_direction(&r);
        nkw_quat q = nkw_quat_look_rotation(nkw_vec3_scale(f, 7), u);
        expect_vec3_near(nkw_quat_rotate(q, vec(0, 0, -1)), f, 2e-6);
        expect_near(nkw_vec3_dot(nkw_quat_rotate(q, vec(1, 0, 0)), u), 0.0, 2e-6);
        assert_true(nkw_vec3_dot(nkw_quat_rotate(q, vec(0, 1, 0)), u) > -1e-6f);
    }
}

static void look_rotation_without_direction_or_up_is_defined(void **state)
{
    (void)state;
    expect_quat_bits(nkw_quat_look_rotation(vec(0, 0, 0), vec(0, 1, 0)), identity);
    nkw_quat along = nkw_quat_look_rotation(vec(0, 2, 0), vec(0, 1, 0));
    nkw_quat none = nkw_quat_look_rotation(vec(0, 2, 0), vec(0, 0, 0));
    expect_vec3_near(nkw_quat_rotate(along, vec(0, 0, -1)), vec(0, 1, 0), 1e-6);
    expect_vec3_near(nkw_quat_rotate(none, vec(0, 0, -1)), vec(0, 1, 0), 1e-6);
}

static void from_mat3_is_right_at_every_angle_and_at_half_turns(void **state)
{
    (void)state;
    random_source r = random_from(9);
    for (int i = 0; i < 20000; i++) {
        nkw_vec3 axis = random_direction(&r);
        nkw_quat half = {axis.x, axis.y, axis.z, 0};
        nkw_quat q = i % 2 ? random_rotation(&r) : i % 4 ? half : random_near(&r, half, 1e-4f);
        nkw_mat3 m = nkw_mat3_from_quat(q);
        expect_rotation_near(nkw_quat_from_mat3(&m), q, 5e-7);
    }
}

static void from_mat3_knows_the_half_turns_about_the_axes(void **state)
{
    (void)state;
    nkw_mat3 x = {{1, 0, 0, 0, -1, 0, 0, 0, -1}}, y = {{-1, 0, 0, 0, 1, 0, 0, 0, -1}},
             z = {{-1, 0, 0, 0, -1, 0, 0, 0, 1}};
    nkw_mat3 one = nkw_mat3_identity();
    expect_quat_near(nkw_quat_from_mat3(&x), quat(1, 0, 0, 0), 0);
    expect_quat_near(nkw_quat_from_mat3(&y), quat(0, 1, 0, 0), 0);
    expect_quat_near(nkw_quat_from_mat3(&z), quat(0, 0, 1, 0), 0);
    expect_quat_near(nkw_quat_from_mat3(&one), identity, 0);
}

static void from_mat3_finds_the_nearest_rotation_of_a_noisy_one(void **state)
{
    (void)state;
    random_source r = random_from(10);
    for (int i = 0; i < 10000; i++) {
        nkw_quat q = random_rotation(&r);
        nkw_mat3 m = nkw_mat3_from_quat(q);
        for (int k = 0; k < 9; k++)
            m.m[k] += random_between(&r, -1e-3f, 1e-3f);
        nkw_quat got = nkw_quat_from_mat3(&m);
        expect_near(nkw_quat_length(got), 1.0, 2e-7);
        expect_rotation_near(got, q, 2e-3);
    }
}

static void from_mat3_of_anything_finite_is_unit(void **state)
{
    (void)state;
    nkw_mat3 zero = {{0}};
    expect_near(nkw_quat_length(nkw_quat_from_mat3(&zero)), 1.0, 2e-7);
    random_source r = random_from(11);
    for (int i = 0; i < 20000; i++) {
        nkw_mat3 m;
        for (int k = 0; k < 9; k++)
            m.m[k] = random_finite(&r);
        expect_near(nkw_quat_length(nkw_quat_from_mat3(&m)), 1.0, 3e-7);
    }
}

static void angle_between_is_that_of_the_turn_for_either_sign(void **state)
{
    (void)state;
    expect_bits(nkw_quat_angle(identity, identity), 0.0f);
    expect_bits(nkw_quat_angle(identity, nkw_quat_negate(identity)), 0.0f);
    expect_ulps(nkw_quat_angle(identity, quarter_x), 1.57079637f, 1);
    expect_bits(nkw_quat_angle(identity, quat(0, 1, 0, 0)), 3.14159274f);
    expect_bits(nkw_quat_angle(identity, quat(0, 0, 0, 0)), 0.0f);
    expect_ulps(nkw_quat_angle(identity, quat(1e-7f, 0, 0, 1)), 2e-7f, 1);
    expect_ulps(nkw_quat_angle(identity, quat(1e-30f, 0, 0, -1)), 2e-30f, 1);
    expect_ulps(nkw_quat_angle(quat(0, 0, 0, 1e-30f), quat(0, 1e30f, 0, 1e30f)), 1.57079637f, 1);
}

static void wxyz_is_only_another_order(void **state)
{
    (void)state;
    float wxyz[4];
    nkw_quat_to_wxyz(quat(1, 2, 3, 4), wxyz);
    const float want[4] = {4, 1, 2, 3};
    expect_floats_bits(wxyz, want, 4);
    expect_quat_bits(nkw_quat_from_wxyz(wxyz), quat(1, 2, 3, 4));
}

/* A fused product keeps the e^2 of (1 + e)^2, e = 2^-12, which rounding takes. */
static void products_are_rounded_before_they_are_summed(void **state)
{
    (void)state;
    const float e = 0x1p-12f, a = 1 + e, s = -(1 + 2 * e);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++) {
            float p[4] = {0}, q[4] = {0};
            p[i] = q[i] = a;
            p[k] = k == i ? a : 1;
            q[k] = k == i ? a : s;
            expect_near(nkw_quat_dot(quat(p[0], p[1], p[2], p[3]), quat(q[0], q[1], q[2], q[3])),
                        k == i ? -(double)s : 0.0, 0);
        }
}

/* Hamilton's product in binary64. */
static void product_is_exact_to_its_bound(void **state)
{
    (void)state;
    random_source r = random_from(31);
    for (int i = 0; i < 20000; i++) {
        nkw_quat a = random_rotation(&r), b = random_rotation(&r), got = nkw_quat_mul(a, b);
        const double p[4] = {a.x, a.y, a.z, a.w}, q[4] = {b.x, b.y, b.z, b.w};
        const double bound = 2.5 * 0x1p-24;
        expect_near(got.x, p[3] * q[0] + p[0] * q[3] + p[1] * q[2] - p[2] * q[1], bound);
        expect_near(got.y, p[3] * q[1] + p[1] * q[3] + p[2] * q[0] - p[0] * q[2], bound);
        expect_near(got.z, p[3] * q[2] + p[2] * q[3] + p[0] * q[1] - p[1] * q[0], bound);
        expect_near(got.w, p[3] * q[3] - p[0] * q[0] - p[1] * q[1] - p[2] * q[2], bound);
        expect_near(nkw_quat_dot(a, b), p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3], 3 * 0x1p-24);
    }
}

/* Lengths of every size and those near 1, where a quaternion might be taken for unit already. */
static void normalize_and_inverse_are_exact_to_their_bound(void **state)
{
    (void)state;
    random_source r = random_from(32);
    for (int i = 0; i < 20000; i++) {
        float size = i % 2 ? 1.0f + random_scaled(&r, -24, -12) : random_scaled(&r, -100, 100);
        nkw_quat q = nkw_quat_scale(random_rotation(&r), size), unit = nkw_quat_normalize(q);
        nkw_quat inverse = nkw_quat_inverse(q);
        const double x = q.x, y = q.y, z = q.z, w = q.w, n2 = (x * x + y * y) + (z * z + w * w), n = sqrt(n2);
        const double bound = 2.3 * 0x1p-24, part = 1.0 * 0x1p-24 / n;
        expect_near(unit.x, x / n, bound);
        expect_near(unit.y, y / n, bound);
        expect_near(unit.z, z / n, bound);
        expect_near(unit.w, w / n, bound);
        expect_near(inverse.x, -x / n2, part);
        expect_near(inverse.y, -y / n2, part);
        expect_near(inverse.z, -z / n2, part);
        expect_near(inverse.w, w / n2, part);
        expect_ulps(nkw_quat_length(q), (float)n, 0);
    }
}

/* The half vector of the unit directions, at every angle from equal to 2^-20 rad from opposite. */
static void from_vectors_is_exact_at_every_angle(void **state)
{
    (void)state;
    random_source r = random_from(33);
    for (int i = 0; i < 20000; i++) {
        nkw_vec3 a = random_direction(&r), across = nkw_vec3_perpendicular(a);
        double angle = i % 2 ? 3.14159265358979 * (double)random_unit(&r)
                             : 3.14159265358979 - (double)nkw_abs(random_scaled(&r, -20, 0));
        const double c = cos(angle), s = sin(angle);
        nkw_vec3 b = {(float)(c * (double)a.x + s * (double)across.x), (float)(c * (double)a.y + s * (double)across.y),
                      (float)(c * (double)a.z + s * (double)across.z)};
        /* q = (|b| a + |a| b) taken as a half turn, times a: the axis a x b by sin, the cosine of half the angle. */
        const long double u[3] = {a.x, a.y, a.z}, v[3] = {b.x, b.y, b.z};
        long double lu = sqrtl(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
        long double lv = sqrtl(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]), sum = 0, difference = 0;
        long double n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
        for (int k = 0; k < 3; k++) {
            long double p = u[k] / lu, q = v[k] / lv;
            sum += (p + q) * (p + q);
            difference += (p - q) * (p - q);
        }
        long double ln = sqrtl(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), half = sqrtl(difference) / 2;
        nkw_quat got = nkw_quat_from_vectors(a, b);
        const double bound = 0.91 * 0x1p-24;
        expect_near(got.w, (double)(sqrtl(sum) / 2), bound);
        expect_near(got.x, ln > 0 ? (double)(half * n[0] / ln) : 0, bound);
        expect_near(got.y, ln > 0 ? (double)(half * n[1] / ln) : 0, bound);
        expect_near(got.z, ln > 0 ? (double)(half * n[2] / ln) : 0, bound);
    }
}

static void axis_and_angle_are_those_of_either_sign(void **state)
{
    (void)state;
    random_source r = random_from(35);
    for (int i = 0; i < 5000; i++) {
        nkw_quat q = random_rotation(&r);
        nkw_axis_angle a = nkw_axis_angle_from_quat(q), b = nkw_axis_angle_from_quat(nkw_quat_negate(q));
        expect_vec3_bits(a.axis, b.axis);
        expect_bits(a.angle, b.angle);
        expect_rotation_near(nkw_quat_from_axis_angle(a.axis, a.angle), q, 3e-7);
    }
}

static void swing_after_twist_is_the_rotation(void **state)
{
    (void)state;
    random_source r = random_from(41);
    for (int i = 0; i < 20000; i++) {
        nkw_quat q = random_rotation(&r);
        nkw_vec3 axis = nkw_vec3_scale(random_direction(&r), random_between(&r, 0.1f, 10.0f));
        nkw_vec3 a = nkw_vec3_normalize(axis);
        nkw_swing_twist s = nkw_quat_swing_twist(q, axis);
        expect_quat_near(nkw_quat_mul(s.swing, s.twist), q, 3e-7);
        assert_true(s.swing.w >= 0.0f);
        expect_near(nkw_vec3_dot(vec(s.swing.x, s.swing.y, s.swing.z), a), 0, 2e-7);
        expect_vec3_near(nkw_quat_rotate(s.twist, a), a, 3e-6);
        expect_vec3_near(nkw_quat_rotate(s.swing, a), nkw_quat_rotate(q, a), 5e-6);
    }
}

static void twist_angle_is_the_angle_about_the_axis(void **state)
{
    (void)state;
    random_source r = random_from(42);
    for (int i = 0; i < 20000; i++) {
        nkw_vec3 axis = random_direction(&r);
        nkw_vec3 across = nkw_vec3_perpendicular(axis);
        float twist = random_between(&r, -3.1f, 3.1f), swing = random_between(&r, -2.0f, 2.0f);
        nkw_quat q = nkw_quat_mul(nkw_quat_from_axis_angle(across, swing), nkw_quat_from_axis_angle(axis, twist));
        expect_near(nkw_quat_twist_angle(q, axis), twist, 2e-6);
        expect_bits(nkw_quat_twist_angle(nkw_quat_negate(q), axis), nkw_quat_twist_angle(q, axis));
    }
}

static void swing_of_half_a_turn_has_no_twist(void **state)
{
    (void)state;
    const nkw_quat half_turn = {0.6f, 0.8f, 0.0f, 0.0f};
    nkw_swing_twist s = nkw_quat_swing_twist(half_turn, vec(0, 0, 2));
    expect_quat_near(s.swing, half_turn, 1e-7);
    expect_quat_bits(s.twist, identity);
    expect_bits(nkw_quat_twist_angle(half_turn, vec(0, 0, 2)), 0.0f);
    s = nkw_quat_swing_twist(half_turn, vec(0, 0, 0));
    expect_quat_near(s.swing, half_turn, 1e-7);
    expect_quat_bits(s.twist, identity);
    s = nkw_quat_swing_twist(quat(0, 0, 0, 0), vec(0, 1, 0));
    expect_quat_bits(s.swing, identity);
    expect_quat_bits(s.twist, identity);
}

static void mean_of_equal_rotations_is_that_rotation(void **state)
{
    (void)state;
    random_source r = random_from(43);
    for (int i = 0; i < 2000; i++) {
        nkw_quat q = nkw_quat_normalize(random_rotation(&r));
        nkw_quat same[3] = {q, nkw_quat_negate(q), q};
        expect_quat_near(nkw_quat_mean(same, 3, NULL), q, 2e-7);
        expect_quat_near(nkw_quat_mean(&q, 1, NULL), q, 2e-7);
    }
    expect_quat_bits(nkw_quat_mean(NULL, 0, NULL), identity);
    nkw_quat zero = {0, 0, 0, 0};
    expect_quat_bits(nkw_quat_mean(&zero, 1, NULL), identity);
}

/* Of two rotations of equal weight the mean is half-way, as slerp has it. */
static void mean_of_two_is_half_way(void **state)
{
    (void)state;
    random_source r = random_from(44);
    for (int i = 0; i < 5000; i++) {
        nkw_quat q[2] = {random_rotation(&r), identity};
        q[1] = random_near(&r, q[0], random_between(&r, 0.0f, 1.4f));
        expect_quat_near(nkw_quat_mean(q, 2, NULL), nkw_quat_slerp(q[0], q[1], 0.5f), 5e-7);
    }
}

static void mean_ignores_signs_and_order_and_turns_with_the_rotations(void **state)
{
    (void)state;
    random_source r = random_from(45);
    for (int i = 0; i < 3000; i++) {
        nkw_quat q[4], other[4], turned[4], turn = random_rotation(&r);
        float weights[4], reversed[4];
        q[0] = random_rotation(&r);
        for (int k = 0; k < 4; k++) {
            q[k] = k ? random_near(&r, q[0], random_between(&r, 0.0f, 0.6f)) : q[0];
            weights[k] = random_between(&r, 0.1f, 1.0f);
            reversed[3 - k] = weights[k];
            other[3 - k] = random_bits(&r) & 1 ? nkw_quat_negate(q[k]) : q[k];
            turned[k] = nkw_quat_mul(turn, q[k]);
        }
        nkw_quat mean = nkw_quat_mean(q, 4, weights);
        expect_rotation_near(nkw_quat_mean(other, 4, reversed), mean, 3e-7);
        expect_rotation_near(nkw_quat_mean(turned, 4, weights), nkw_quat_mul(turn, mean), 1e-6);
        assert_true(nkw_quat_dot(mean, q[0]) >= 0.0f);
    }
}

/* No unit quaternion near the mean has a larger sum of weight (q.m)^2. */
static void mean_has_the_largest_sum_of_squared_products(void **state)
{
    (void)state;
    random_source r = random_from(46);
    for (int i = 0; i < 300; i++) {
        nkw_quat q[5];
        float weights[5];
        for (int k = 0; k < 5; k++) {
            q[k] = random_rotation(&r);
            weights[k] = random_between(&r, -0.2f, 1.0f);
        }
        nkw_quat mean = nkw_quat_mean(q, 5, weights);
        double best = 0.0;
        for (int trial = -1; trial < 200; trial++) {
            nkw_quat m = trial < 0 ? mean : random_near(&r, mean, random_between(&r, 0.01f, 1.5f));
            double sum = 0.0;
            for (int k = 0; k < 5; k++) {
                double dot = (double)q[k].x * m.x + (double)q[k].y * m.y + (double)q[k].z * m.z + (double)q[k].w * m.w;
                sum += weights[k] < 0 ? 0.0 : (double)weights[k] * dot * dot;
            }
            best = trial < 0 ? sum : best;
            assert_true(sum <= best * (1.0 + 1e-6));
        }
    }
}

static void mean_of_opposite_halves_is_defined_and_unit(void **state)
{
    (void)state;
    const nkw_quat apart[2] = {{0, 0, 0, 1}, {1, 0, 0, 0}};
    nkw_quat mean = nkw_quat_mean(apart, 2, NULL);
    expect_near(nkw_quat_length(mean), 1.0, 1e-7);
    assert_true(mean.y == 0.0f && mean.z == 0.0f);
    const nkw_quat odd[2] = {{0, 0, 0, NAN}, {1, 0, 0, 0}};
    assert_false(nkw_quat_is_finite(nkw_quat_mean(odd, 2, NULL)));
    const nkw_quat huge[2] = {{3e38f, 3e38f, 0, 0}, {3e38f, 3e38f, 0, 0}};
    expect_quat_near(nkw_quat_mean(huge, 2, NULL), quat(0.70710678f, 0.70710678f, 0, 0), 1e-7);
}

static void products_that_overflow_are_not_finite(void **state)
{
    (void)state;
    nkw_quat half_turn = {0, 1, 0, 0};
    nkw_vec3 v = nkw_quat_rotate(half_turn, vec(2e38f, 0, 0));
    assert_false(nkw_abs(v.x) <= FLT_MAX);
    expect_bits(nkw_quat_rotate(half_turn, vec(1e38f, 0, 0)).x, -1e38f);
    assert_false(nkw_abs(nkw_hermite(-3e38f, 0, 3e38f, 0, 0.5f)) <= FLT_MAX);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(identity_changes_nothing),
        cmocka_unit_test(i_times_j_is_k),
        cmocka_unit_test(a_quarter_turn_about_x_takes_y_to_z),
        cmocka_unit_test(product_rotates_by_the_right_factor_first),
        cmocka_unit_test(rotation_agrees_with_its_matrix),
        cmocka_unit_test(normalize_works_from_the_smallest_to_the_largest),
        cmocka_unit_test(inverse_undoes_any_quaternion),
        cmocka_unit_test(axis_and_angle_go_there_and_back),
        cmocka_unit_test(axis_angle_of_no_turn_has_no_axis),
        cmocka_unit_test(axis_need_not_be_unit_and_angle_need_not_be_small),
        cmocka_unit_test(from_vectors_takes_one_direction_to_the_other),
        cmocka_unit_test(from_vectors_turns_opposites_by_pi_and_equals_by_nothing),
        cmocka_unit_test(look_rotation_points_minus_z_forward_and_y_up),
        cmocka_unit_test(look_rotation_without_direction_or_up_is_defined),
        cmocka_unit_test(from_mat3_is_right_at_every_angle_and_at_half_turns),
        cmocka_unit_test(from_mat3_knows_the_half_turns_about_the_axes),
        cmocka_unit_test(from_mat3_finds_the_nearest_rotation_of_a_noisy_one),
        cmocka_unit_test(from_mat3_of_anything_finite_is_unit),
        cmocka_unit_test(angle_between_is_that_of_the_turn_for_either_sign),
        cmocka_unit_test(wxyz_is_only_another_order),
        cmocka_unit_test(products_are_rounded_before_they_are_summed),
        cmocka_unit_test(product_is_exact_to_its_bound),
        cmocka_unit_test(normalize_and_inverse_are_exact_to_their_bound),
        cmocka_unit_test(from_vectors_is_exact_at_every_angle),
        cmocka_unit_test(axis_and_angle_are_those_of_either_sign),
        cmocka_unit_test(swing_after_twist_is_the_rotation),
        cmocka_unit_test(twist_angle_is_the_angle_about_the_axis),
        cmocka_unit_test(swing_of_half_a_turn_has_no_twist),
        cmocka_unit_test(mean_of_equal_rotations_is_that_rotation),
        cmocka_unit_test(mean_of_two_is_half_way),
        cmocka_unit_test(mean_ignores_signs_and_order_and_turns_with_the_rotations),
        cmocka_unit_test(mean_has_the_largest_sum_of_squared_products),
        cmocka_unit_test(mean_of_opposite_halves_is_defined_and_unit),
        cmocka_unit_test(products_that_overflow_are_not_finite),
    };
    return cmocka_run_group_tests_name("quat", tests, NULL, NULL);
}
