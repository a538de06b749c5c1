/* SPDX-License-Identifier: MIT */
/* Paths with whole turns: slerp and nlerp along any arc. */
#include <math.h>

#include "random.h"
#include "support/expect.h"

#define PI 3.14159274f

static const nkw_path paths[3] = {NKW_PATH_SHORT, NKW_PATH_LONG, NKW_PATH_AS_GIVEN};

static nkw_quat about(nkw_vec3 axis, double angle)
{
    nkw_quat q = nkw_quat_identity();
    double half = 0.5 * angle, s = sin(half);
    q.x = (float)(axis.x * s), q.y = (float)(axis.y * s), q.z = (float)(axis.z * s), q.w = (float)cos(half);
    return q;
}

static nkw_vec3 some_axis(random_source *r)
{
    return nkw_vec3_normalize(random_direction(r));
}

/* b is a turned by `angle`; along the short arc and k turns it turns by angle + 2 pi k. */
static void turns_add_whole_turns_about_the_axis_of_the_arc(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 20000; i++) {
        nkw_vec3 axis = some_axis(&r);
        nkw_quat a = nkw_quat_normalize(random_rotation(&r));
        double angle = random_between(&r, 0.1f, 3.0f), t = random_between(&r, -1.0f, 2.0f);
        int32_t k = (int32_t)(random_bits(&r) % 11) - 5;
        nkw_quat b = nkw_quat_mul(about(axis, angle), a);
        nkw_quat want = nkw_quat_mul(about(axis, (double)(float)t * (angle + 2.0 * 3.14159265358979 * k)), a);
        expect_rotation_near(nkw_quat_slerp_path(a, b, (float)t, NKW_PATH_SHORT, k), want, 2e-5);
    }
}

static void the_long_arc_is_the_short_one_with_a_turn_back(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 20000; i++) {
        nkw_quat a = nkw_quat_normalize(random_rotation(&r));
        nkw_quat b = nkw_quat_normalize(random_near(&r, a, random_between(&r, 0.1f, 1.5f)));
        float t = random_unit(&r);
        nkw_quat expected = nkw_quat_slerp_path(a, b, t, NKW_PATH_LONG, 0);
        expect_quat_near(nkw_quat_slerp_path(a, b, t, NKW_PATH_SHORT, -1), expected, 1e-6);
    }
}

static void paths_end_at_the_keys_bit_for_bit_for_any_turns(void **state)
{
    (void)state;
    static const int32_t turns[] = {0, 1, -1, 2, 1000000, -1000001, INT32_MAX, INT32_MIN};
    random_source r = random_from(3);
    for (int i = 0; i < 3000; i++) {
        nkw_quat a = random_rotation(&r), b = random_rotation(&r);
        for (int p = 0; p < 3; p++)
            for (size_t k = 0; k < 8; k++) {
                nkw_quat end = nkw_quat_slerp_path(a, b, 1.0f, paths[p], 0);
                nkw_quat want = turns[k] % 2 ? nkw_quat_negate(end) : end;
                expect_quat_bits(nkw_quat_slerp_path(a, b, 0.0f, paths[p], turns[k]), a);
                expect_quat_bits(nkw_quat_nlerp_path(a, b, 0.0f, paths[p], turns[k]), a);
                expect_quat_bits(nkw_quat_slerp_path(a, b, 1.0f, paths[p], turns[k]), want);
                expect_quat_bits(nkw_quat_nlerp_path(a, b, 1.0f, paths[p], turns[k]), want);
            }
    }
}

/* t k is exact, so a million turns are as exact as one: at t = 1/4 a multiple of four is none. */
static void a_million_turns_are_as_exact_as_none(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 5000; i++) {
        nkw_quat a = random_rotation(&r), b = random_rotation(&r);
        for (int p = 0; p < 3; p++) {
            nkw_quat want = nkw_quat_slerp_path(a, b, 0.25f, paths[p], 0);
            expect_rotation_near(nkw_quat_slerp_path(a, b, 0.25f, paths[p], 1000000), want, 2e-7);
            expect_rotation_near(nkw_quat_slerp_path(a, b, 0.25f, paths[p], -1000000), want, 2e-7);
            want = nkw_quat_nlerp_path(a, b, 0.25f, paths[p], 0);
            expect_rotation_near(nkw_quat_nlerp_path(a, b, 0.25f, paths[p], 1 << 29), want, 2e-7);
        }
    }
}

static void nlerp_along_the_short_arc_is_nlerp(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 20000; i++) {
        nkw_quat a = random_rotation(&r), b = random_rotation(&r);
        float t = random_unit(&r);
        if (fabsf(nkw_quat_dot(a, b)) < 1e-6f)
            continue;
        expect_quat_near(nkw_quat_nlerp_path(a, b, t, NKW_PATH_SHORT, 0), nkw_quat_nlerp(a, b, t), 4e-7);
        expect_quat_bits(nkw_quat_nlerp_path(a, b, t, (nkw_path)7, 0), nkw_quat_nlerp_path(a, b, t, NKW_PATH_SHORT, 0));
    }
}

static void nlerp_along_any_arc_is_the_straight_line_divided_by_its_length(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 20000; i++) {
        nkw_quat a = random_rotation(&r), b = random_rotation(&r);
        float t = random_unit(&r);
        nkw_quat line = nkw_quat_add(nkw_quat_scale(a, 1.0f - t), nkw_quat_scale(b, t));
        if (nkw_quat_length(line) > 0.1f)
            expect_quat_near(nkw_quat_nlerp_path(a, b, t, NKW_PATH_AS_GIVEN, 0), nkw_quat_normalize(line), 3e-6);
    }
}

static void turns_between_equal_rotations_are_about_local_z(void **state)
{
    (void)state;
    random_source r = random_from(7);
    const nkw_vec3 z = {0.0f, 0.0f, 1.0f};
    for (int i = 0; i < 2000; i++) {
        nkw_quat q = nkw_quat_normalize(random_rotation(&r));
        float t = random_unit(&r);
        nkw_quat want = nkw_quat_mul(q, about(z, 4.0 * 3.14159265358979 * (double)t));
        expect_rotation_near(nkw_quat_slerp_path(q, q, t, NKW_PATH_SHORT, 2), want, 2e-6);
        expect_rotation_near(nkw_quat_nlerp_path(q, q, t, NKW_PATH_SHORT, 2), want, 2e-6);
        assert_int_equal(nkw_quat_turns(q, q, z, NKW_PATH_SHORT), 0);
    }
}

static void turns_are_those_of_the_expected_rotation(void **state)
{
    (void)state;
    random_source r = random_from(8);
    for (int i = 0; i < 20000; i++) {
        nkw_vec3 axis = some_axis(&r);
        nkw_quat a = nkw_quat_normalize(random_rotation(&r));
        float angle = random_between(&r, 0.1f, 3.0f);
        int32_t k = (int32_t)(random_bits(&r) % 41) - 20;
        nkw_quat b = nkw_quat_mul(about(axis, (double)angle), a);
        float total = angle + 2.0f * PI * (float)k + random_between(&r, -2.9f, 2.9f);
        assert_int_equal(nkw_quat_turns(a, b, nkw_vec3_scale(axis, total), NKW_PATH_SHORT), k);
    }
}

static void turns_of_anything_are_defined(void **state)
{
    (void)state;
    const nkw_quat a = {0, 0, 0, 1}, b = {0.6f, 0, 0, 0.8f}, zero = {0, 0, 0, 0};
    const nkw_vec3 far = {3e38f, 0, 0}, back = {-3e38f, 0, 0}, odd = {NAN, 0, 0}, infinite = {INFINITY, 0, 0};
    assert_int_equal(nkw_quat_turns(a, b, far, NKW_PATH_SHORT), 1 << 29);
    assert_int_equal(nkw_quat_turns(a, b, back, NKW_PATH_SHORT), -(1 << 29));
    assert_int_equal(nkw_quat_turns(a, b, odd, NKW_PATH_SHORT), 0);
    assert_int_equal(nkw_quat_turns(a, b, infinite, NKW_PATH_SHORT), 0);
    assert_int_equal(nkw_quat_turns(zero, zero, far, NKW_PATH_SHORT), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(turns_add_whole_turns_about_the_axis_of_the_arc),
        cmocka_unit_test(the_long_arc_is_the_short_one_with_a_turn_back),
        cmocka_unit_test(paths_end_at_the_keys_bit_for_bit_for_any_turns),
        cmocka_unit_test(a_million_turns_are_as_exact_as_none),
        cmocka_unit_test(nlerp_along_the_short_arc_is_nlerp),
        cmocka_unit_test(nlerp_along_any_arc_is_the_straight_line_divided_by_its_length),
        cmocka_unit_test(turns_between_equal_rotations_are_about_local_z),
        cmocka_unit_test(turns_are_those_of_the_expected_rotation),
        cmocka_unit_test(turns_of_anything_are_defined),
    };
    return cmocka_run_group_tests_name("orient_path", tests, NULL, NULL);
}
