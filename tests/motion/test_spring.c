/* SPDX-License-Identifier: MIT */
#include <float.h>
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/motions.h"

#define U 0x1p-24

static nkw_quat_state still(nkw_quat value)
{
    return rotating(value, vec(0, 0, 0));
}

/* Under-, critically and overdamped, drag alone, no damping, and none at all. */
static nkw_spring some_spring(random_source *r, int i)
{
    static const float ratios[] = {0.05f, 0.5f, 0.99f, 1.0f, 1.01f, 3.0f, 40.0f};
    nkw_spring drag = {0, random_between(r, 0, 20)}, swing = {random_between(r, 0, 400), 0};
    if (i % 9 == 7)
        return drag;
    if (i % 9 == 8)
        return swing;
    return nkw_spring_from_frequency(random_between(r, 0.05f, 5), ratios[i % 9]);
}

static nkw_state some_motion(random_source *r)
{
    float value = random_between(r, -3, 3);
    return motion(value, random_between(r, -10, 10));
}

/* The equation in binary64 by Runge and Kutta's method. */
static void integrate(nkw_spring s, double *x, double *v, nkw_state goal, double h)
{
    const int steps = 4000;
    double dt = h / steps, g;
    for (int i = 0; i < steps; i++) {
        g = goal.value + goal.velocity * dt * i;
        double kx[4], kv[4];
        for (int k = 0; k < 4; k++) {
            double part = k == 0 ? 0 : k == 3 ? dt : 0.5 * dt;
            double at = *x + (k ? part * kx[k - 1] : 0);
            kx[k] = *v + (k ? part * kv[k - 1] : 0);
            kv[k] = s.stiffness * (g + goal.velocity * part - at) + s.damping * (goal.velocity - kx[k]);
        }
        *x += dt / 6 * (kx[0] + 2 * kx[1] + 2 * kx[2] + kx[3]);
        *v += dt / 6 * (kv[0] + 2 * kv[1] + 2 * kv[2] + kv[3]);
    }
}

static void steps_solve_the_equation_of_motion(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 90; i++) {
        nkw_spring s = some_spring(&r, i);
        nkw_state from = some_motion(&r), goal = some_motion(&r);
        float h = random_between(&r, 0, 0.25f);
        double x = from.value, v = from.velocity;
        integrate(s, &x, &v, goal, h);
        nkw_state got = nkw_spring_step(s, from, goal, h);
        double size = fabs(x) + fabs(goal.value) + 1, speed = fabs(v) + 1;
        expect_near(got.value, x, 4e-7 * size);
        expect_near(got.velocity, v, 4e-7 * (speed + s.damping * size));
    }
}

static void one_step_of_2h_equals_two_of_h(void **state)
{
    (void)state;
    random_source r = random_from(2);
    double worst = 0;
    for (int i = 0; i < 200000; i++) {
        nkw_spring s = some_spring(&r, i);
        nkw_state from = some_motion(&r), goal = some_motion(&r);
        float h = ldexpf(random_unit(&r), (int)(random_bits(&r) % 6) - 4);
        nkw_state then = {goal.value + goal.velocity * h, goal.velocity};
        nkw_state once = nkw_spring_step(s, from, goal, 2 * h);
        nkw_state half = nkw_spring_step(s, from, goal, h), twice = nkw_spring_step(s, half, then, h);
        double omega = sqrt(s.stiffness) + s.damping, x = fabs(from.value - goal.value),
               v = fabs(from.velocity - goal.velocity);
        double size = fabs(goal.value) + fabs(goal.velocity) * 2 * h + x + fmin(v * 2 * h, v / (omega + 1e-30));
        double speed = fabs(goal.velocity) + v + omega * (x + fabs(goal.value) + fabs(goal.velocity) * 2 * h);
        worst = fmax(worst, fabs(once.value - twice.value) / size);
        worst = fmax(worst, fabs(once.velocity - twice.velocity) / speed);
    }
    expect_near(worst, 0, 4 * U);
}

static void a_long_step_equals_ten_thousand_short_ones(void **state)
{
    (void)state;
    nkw_spring s = nkw_spring_from_half_life(0.5f, 0.3f);
    nkw_state goal = motion(2, 0), x = motion(-1, 3);
    for (int i = 0; i < 10240; i++)
        x = nkw_spring_step(s, x, goal, 0x1p-12f);
    nkw_state once = nkw_spring_step(s, motion(-1, 3), goal, 2.5f);
    expect_near(x.value, once.value, 2e-5);
    expect_near(x.velocity, once.velocity, 1e-4);
}

static void no_time_changes_nothing(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 200; i++) {
        nkw_spring s = some_spring(&r, i);
        nkw_state from = {random_finite(&r), random_finite(&r)}, goal = some_motion(&r);
        for (int k = 0; k < 3; k++) {
            float h = k == 0 ? 0.0f : k == 1 ? -0.0f : -1e9f;
            nkw_state got = nkw_spring_step(s, from, goal, h);
            expect_bits(got.value, from.value);
            expect_bits(got.velocity, from.velocity);
            expect_bits(nkw_damper_step(from.value, goal.value, 0, h), from.value);
        }
    }
}

static void a_goal_is_reached_and_not_left(void **state)
{
    (void)state;
    const float far[] = {1e9f, FLT_MAX, INFINITY};
    for (int i = 0; i < 3; i++) {
        nkw_state got = nkw_spring_step(nkw_spring_from_half_life(0.1f, 1), motion(5, -7), motion(2, 0), far[i]);
        expect_bits(got.value, 2);
        expect_near(got.velocity, 0, 0);
        expect_bits(nkw_damper_step(5, 2, 0.1f, far[i]), 2);
    }
    nkw_state stays = nkw_spring_step(nkw_spring_from_half_life(0.1f, 0.2f), motion(3, 0), motion(3, 0), 0.01f);
    expect_bits(stays.value, 3);
    expect_bits(stays.velocity, 0);
}

static void a_moving_goal_is_followed_without_a_lag(void **state)
{
    (void)state;
    nkw_spring s = nkw_spring_from_half_life(0.05f, 1);
    nkw_state x = motion(0, 0), goal = motion(1, 4);
    for (int i = 0; i < 120; i++, goal.value += 4 / 60.0f)
        x = nkw_spring_step(s, x, goal, 1 / 60.0f);
    expect_near(x.value, goal.value, 1e-6);
    expect_near(x.velocity, 4, 1e-5);
}

static void half_life_zero_jumps_and_infinite_drifts(void **state)
{
    (void)state;
    nkw_state jumped = nkw_spring_step(nkw_spring_from_half_life(0, 1), motion(1, 5), motion(2, 0), 1e-6f);
    expect_bits(jumped.value, 2);
    expect_near(jumped.velocity, 0, 0);
    nkw_state drifted = nkw_spring_step(nkw_spring_from_half_life(INFINITY, 1), motion(1, 5), motion(2, 0), 2);
    expect_bits(drifted.value, 11);
    expect_bits(drifted.velocity, 5);
    expect_bits(nkw_damper_step(1, 2, 0, 1e-6f), 2);
    expect_bits(nkw_damper_step(1, 2, -1, 1e-6f), 2);
    expect_bits(nkw_damper_step(1, 2, INFINITY, 1e6f), 1);
}

static void nan_stays_nan(void **state)
{
    (void)state;
    nkw_spring s = nkw_spring_from_half_life(0.1f, 1), bad = {NAN, 1}, worse = {1, NAN};
    expect_nan(nkw_spring_step(s, motion(NAN, 0), motion(0, 0), 0.1f).value);
    expect_nan(nkw_spring_step(s, motion(0, 0), motion(0, NAN), 0.1f).value);
    expect_nan(nkw_spring_step(s, motion(1, 0), motion(0, 0), NAN).value);
    expect_nan(nkw_spring_step(bad, motion(1, 0), motion(0, 0), 0.1f).value);
    expect_nan(nkw_spring_step(worse, motion(1, 0), motion(0, 0), 0.1f).value);
    expect_nan(nkw_spring_from_half_life(NAN, 1).stiffness);
    expect_nan(nkw_spring_from_half_life(1, NAN).damping);
    expect_nan(nkw_spring_from_frequency(NAN, 1).stiffness);
    expect_nan(nkw_damper_step(1, 2, NAN, 1));
    expect_nan(nkw_damper_step(1, 2, 1, NAN));
    expect_nan(nkw_damper_step(1, 2, 0, NAN));
}

static void constants_convert_into_each_other(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 2000; i++) {
        float half = ldexpf(1 + random_unit(&r), (int)(random_bits(&r) % 20) - 10), ratio = random_between(&r, 0, 4);
        nkw_spring s = nkw_spring_from_half_life(half, ratio);
        nkw_spring_description d = nkw_spring_describe(s);
        expect_near(d.half_life / half, 1, 4e-7);
        expect_near(d.damping_ratio, ratio, 4e-7 * ratio);
        nkw_spring f = nkw_spring_from_frequency(d.frequency, ratio);
        expect_near(f.stiffness / s.stiffness, 1, 6e-7);
        expect_near(f.damping, s.damping, 6e-7 * s.damping);
    }
    nkw_spring one = nkw_spring_from_frequency(1, 0.5f);
    expect_near(one.stiffness, 39.4784176, 2e-6);
    expect_near(one.damping, 6.28318531, 5e-7);
    nkw_spring drag = {0, 3}, none = {0, 0};
    expect_bits(nkw_spring_describe(drag).damping_ratio, INFINITY);
    expect_bits(nkw_spring_describe(drag).frequency, 0);
    expect_bits(nkw_spring_describe(none).damping_ratio, 0);
    expect_bits(nkw_spring_describe(drag).half_life, INFINITY);
}

/* (1 + z) e^-z = 1/2 at z = 1.678346990016661. */
static void from_rest_the_deviation_is_halved_in_the_half_life(void **state)
{
    (void)state;
    expect_near(nkw_spring_from_half_life(1, 1).damping, 2 * 1.678346990016661, 3e-7);
    for (int i = 0; i <= 40; i++) {
        nkw_spring s = nkw_spring_from_half_life(0.75f, 0.1f * (float)i);
        nkw_state got = nkw_spring_step(s, motion(8, 0), motion(0, 0), 0.75f);
        expect_near(got.value, 4, 3e-6);
    }
    expect_near(nkw_damper_step(8, 0, 0.75f, 1.5f), 2, 2e-7);
}

static void half_lives_are_exact_for_any_damping_and_scale(void **state)
{
    (void)state;
    const float ratios[] = {0, 1e-6f, 0.3f, 1, 30, 1e3f, 1e6f, 1e9f, INFINITY},
                times[] = {1e-10f, 1e-3f, 1, 1e3f, 1e10f};
    for (int i = 0; i < 9; i++) {
        for (int k = 0; k < 5; k++) {
            nkw_spring s = nkw_spring_from_half_life(times[k], ratios[i]);
            expect_near(nkw_spring_step(s, motion(1, 0), motion(0, 0), times[k]).value, 0.5, 1e-6);
        }
        nkw_spring none = nkw_spring_from_half_life(1e30f, ratios[i]);
        expect_bits(none.stiffness, 0);
        expect_bits(none.damping, 0);
    }
}

static void only_underdamped_springs_pass_the_goal(void **state)
{
    (void)state;
    for (int i = 1; i < 40; i++) {
        float ratio = 0.05f * (float)i;
        nkw_spring s = nkw_spring_from_frequency(1, ratio);
        int passes = 0;
        for (int k = 1; k < 400; k++)
            passes |= nkw_spring_step(s, motion(1, 0), motion(0, 0), 0.01f * (float)k).value < -1e-6f;
        assert_int_equal(passes, i < 20);
    }
}

static void an_undamped_spring_keeps_its_energy(void **state)
{
    (void)state;
    nkw_spring s = {9, 0};
    for (int i = 1; i < 100; i++) {
        nkw_state got = nkw_spring_step(s, motion(2, 0), motion(0, 0), 1e3f * (float)i);
        expect_near(got.value * got.value + got.velocity * got.velocity / 9, 4, 2e-6);
        expect_near(got.value, 2 * cos(3.0 * 1e3 * i), 1e-6);
    }
}

static void vectors_follow_component_by_component(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 500; i++) {
        nkw_spring s = some_spring(&r, i);
        nkw_vec3_state from = {random_vec3(&r, -3, 3), random_vec3(&r, -9, 9)},
                        goal = {random_vec3(&r, -3, 3), random_vec3(&r, -1, 1)};
        float h = random_between(&r, 0, 0.5f);
        nkw_vec3_state got = nkw_vec3_spring_step(s, &from, &goal, h);
        nkw_state y =
            nkw_spring_step(s, motion(from.value.y, from.velocity.y), motion(goal.value.y, goal.velocity.y), h);
        expect_bits(got.value.y, y.value);
        expect_bits(got.velocity.y, y.velocity);
        expect_bits(nkw_vec3_damper_step(from.value, goal.value, 0.2f, h).z,
                    nkw_damper_step(from.value.z, goal.value.z, 0.2f, h));
    }
}

/* About one axis a rotation is its angle. */
static void rotations_about_one_axis_follow_as_their_angles(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 2000; i++) {
        nkw_spring s = some_spring(&r, i);
        nkw_vec3 axis = random_direction(&r);
        nkw_state from = {random_between(&r, -3, 0), random_between(&r, -2, 2)},
                   goal = {random_between(&r, -0.1f, 0.1f), random_between(&r, -2, 2)};
        float h = random_between(&r, 0, 0.7f);
        nkw_state want = nkw_spring_step(s, from, goal, h);
        nkw_quat_state q = rotating(nkw_quat_from_axis_angle(axis, from.value), nkw_vec3_scale(axis, from.velocity)),
                        g = rotating(nkw_quat_from_axis_angle(axis, goal.value), nkw_vec3_scale(axis, goal.velocity));
        nkw_quat_state got = nkw_quat_spring_step(s, &q, &g, h);
        expect_rotation_near(got.value, nkw_quat_from_axis_angle(axis, want.value), 2e-6);
        expect_vec3_near(got.velocity, nkw_vec3_scale(axis, want.velocity), 2e-5 * (1 + s.damping + s.stiffness));
    }
}

static void rotations_compose_about_changing_axes(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (int i = 0; i < 20000; i++) {
        nkw_spring s = nkw_spring_from_frequency(random_between(&r, 0.1f, 2), random_between(&r, 0.5f, 2));
        nkw_quat goal = random_rotation(&r);
        nkw_vec3 w = random_vec3(&r, -2, 2);
        nkw_quat_state from = rotating(random_near(&r, goal, 0.8f), random_vec3(&r, -3, 3)), g = rotating(goal, w),
                        then = rotating(nkw_quat_integrate(goal, w, 0.1f), w);
        nkw_quat_state once = nkw_quat_spring_step(s, &from, &g, 0.2f),
                        half = nkw_quat_spring_step(s, &from, &g, 0.1f);
        nkw_quat_state twice = nkw_quat_spring_step(s, &half, &then, 0.1f);
        expect_rotation_near(twice.value, once.value, 1e-6);
        expect_vec3_near(twice.velocity, once.velocity, 2e-5);
    }
}

static void the_velocity_is_the_rate_of_the_rotation(void **state)
{
    (void)state;
    random_source r = random_from(8);
    for (int i = 0; i < 2000; i++) {
        nkw_spring s = nkw_spring_from_frequency(1, 0.7f);
        nkw_quat_state from = rotating(random_rotation(&r), random_vec3(&r, -3, 3)),
                        goal = rotating(random_rotation(&r), random_vec3(&r, -3, 3));
        float h = random_between(&r, 0.01f, 0.5f), d = 1e-3f;
        nkw_quat_state a = nkw_quat_spring_step(s, &from, &goal, h - d), b = nkw_quat_spring_step(s, &from, &goal, h),
                        c = nkw_quat_spring_step(s, &from, &goal, h + d);
        nkw_vec3 w = nkw_quat_angular_velocity(a.value, c.value, (h + d) - (h - d));
        expect_vec3_near(b.velocity, w, 2e-3);
        nkw_quat_state first = nkw_quat_spring_step(s, &from, &goal, 1e-6f);
        expect_vec3_near(first.velocity, from.velocity, 1e-3);
    }
}

/* The error passes half a turn: neither the rotation nor its velocity jumps. */
static void nothing_snaps_at_half_a_turn(void **state)
{
    (void)state;
    nkw_spring s = nkw_spring_from_half_life(0.4f, 1);
    nkw_vec3 z = vec(0, 0, 1);
    nkw_quat_state x = still(nkw_quat_identity());
    for (int i = 0; i < 200; i++) {
        nkw_quat_state goal = still(nkw_quat_from_axis_angle(z, 3.1f + 0.001f * (float)i)), last = x;
        x = nkw_quat_spring_step(s, &x, &goal, 1e-3f);
        assert_true(nkw_quat_angle(last.value, x.value) < 0.02f);
        assert_true(nkw_vec3_distance(last.velocity, x.velocity) < 0.2f);
    }
}

static void odd_rotations_have_an_answer(void **state)
{
    (void)state;
    nkw_spring s = nkw_spring_from_half_life(0.1f, 1);
    nkw_quat zero = {0, 0, 0, 0}, half = {1, 0, 0, 0};
    nkw_quat_state none = still(zero), one = still(nkw_quat_identity()), opposite = still(half);
    expect_quat_near(nkw_quat_spring_step(s, &none, &one, 1).value, nkw_quat_identity(), 1e-6);
    nkw_quat_state got = nkw_quat_spring_step(s, &opposite, &one, 0.1f);
    expect_near(nkw_quat_angle(got.value, nkw_quat_identity()), 0.5 * 3.14159265, 1e-5);
    nkw_quat_state fast = rotating(half, vec(1e30f, 0, 1e30f));
    expect_near(nkw_quat_length(nkw_quat_spring_step(s, &fast, &one, 0.1f).value), 1, 1e-6);
    nkw_quat_state bad = rotating(half, vec(NAN, 0, 0));
    expect_nan(nkw_quat_spring_step(s, &bad, &one, 0.1f).value.w);
    expect_quat_bits(nkw_quat_spring_step(s, &fast, &one, 0).value, half);
    expect_quat_bits(nkw_quat_damper_step(half, nkw_quat_identity(), 1, -1), half);
    expect_quat_bits(nkw_quat_damper_step(half, nkw_quat_identity(), 0, 1), nkw_quat_identity());
}

static void damped_rotations_halve_their_angle(void **state)
{
    (void)state;
    random_source r = random_from(9);
    for (int i = 0; i < 2000; i++) {
        nkw_quat goal = random_rotation(&r), from = random_near(&r, goal, random_between(&r, 0, 1.5f));
        if (i & 1)
            goal = nkw_quat_negate(goal);
        nkw_quat got = nkw_quat_damper_step(from, goal, 0.25f, 0.25f);
        expect_near(nkw_quat_angle(got, goal), 0.5 * nkw_quat_angle(from, goal), 1e-6);
        assert_true(nkw_quat_dot(got, from) > 0);
        nkw_quat half = nkw_quat_damper_step(from, goal, 0.25f, 0.1f);
        expect_quat_near(nkw_quat_damper_step(half, goal, 0.25f, 0.15f), got, 4e-7);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_solve_the_equation_of_motion),
        cmocka_unit_test(one_step_of_2h_equals_two_of_h),
        cmocka_unit_test(a_long_step_equals_ten_thousand_short_ones),
        cmocka_unit_test(no_time_changes_nothing),
        cmocka_unit_test(a_goal_is_reached_and_not_left),
        cmocka_unit_test(a_moving_goal_is_followed_without_a_lag),
        cmocka_unit_test(half_life_zero_jumps_and_infinite_drifts),
        cmocka_unit_test(nan_stays_nan),
        cmocka_unit_test(constants_convert_into_each_other),
        cmocka_unit_test(from_rest_the_deviation_is_halved_in_the_half_life),
        cmocka_unit_test(half_lives_are_exact_for_any_damping_and_scale),
        cmocka_unit_test(only_underdamped_springs_pass_the_goal),
        cmocka_unit_test(an_undamped_spring_keeps_its_energy),
        cmocka_unit_test(vectors_follow_component_by_component),
        cmocka_unit_test(rotations_about_one_axis_follow_as_their_angles),
        cmocka_unit_test(rotations_compose_about_changing_axes),
        cmocka_unit_test(the_velocity_is_the_rate_of_the_rotation),
        cmocka_unit_test(nothing_snaps_at_half_a_turn),
        cmocka_unit_test(odd_rotations_have_an_answer),
        cmocka_unit_test(damped_rotations_halve_their_angle),
    };
    return cmocka_run_group_tests_name("spring", tests, NULL, NULL);
}
