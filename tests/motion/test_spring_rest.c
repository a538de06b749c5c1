/* SPDX-License-Identifier: MIT */
/* Springs and dampers in steps below the resolution of a float, and in steps of days. */
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/motions.h"

static nkw_quat_state still(nkw_quat value)
{
    return rotating(value, vec(0, 0, 0));
}

static const float rates[4] = {30, 60, 144, 1000}, halves[3] = {0.05f, 1, 5}, goals[4] = {10000, -100000, 1, 0x1p-20f};

static double ulp_of(float x)
{
    return fabs((double)nextafterf(x, 2 * x) - (double)x);
}

/* At most one ULP a step from the exact decay, so ULP/(1 - 2^(-h/half_life)) in all. */
static void dampers_arrive_at_any_frame_rate(void **state)
{
    (void)state;
    for (int i = 0; i < 48; i++) {
        float h = 1 / rates[i % 4], half = halves[i / 4 % 3], goal = goals[i / 12], x = 0.99f * goal;
        double e = (double)x - (double)goal, worst = 0;
        int n = 0;
        for (; n < 1000000 && x != goal; n++) {
            x = nkw_damper_step(x, goal, half, h);
            worst = fmax(worst, fabs((double)x - ((double)goal + e * exp2(-(double)h * (n + 1) / (double)half))));
        }
        expect_bits(x, goal);
        assert_true(worst <= ulp_of(goal) / (1 - exp2(-(double)h / (double)half)));
        expect_bits(nkw_damper_step(x, goal, half, h), goal);
    }
}

/* x(t) of a spring from rest at the deviation 1. */
static double deviation(double omega, double ratio, double t)
{
    double y = ratio * omega, w = omega * sqrt(fabs(ratio * ratio - 1));
    if (ratio == 1)
        return exp(-y * t) * (1 + y * t);
    return ratio < 1 ? exp(-y * t) * (cos(w * t) + y / w * sin(w * t))
                     : (exp((w - y) * t) * (y + w) - exp((-y - w) * t) * (y - w)) / (2 * w);
}

static void springs_arrive_at_any_frame_rate(void **state)
{
    (void)state;
    const float ratios[3] = {0.5f, 1, 3};
    for (int i = 0; i < 144; i++) {
        float h = 1 / rates[i % 4], goal = goals[i / 12 % 4], ratio = ratios[i / 48];
        nkw_spring s = nkw_spring_from_half_life(halves[i / 4 % 3], ratio);
        nkw_state x = motion(0.99f * goal, 0);
        double e = (double)x.value - (double)goal, omega = sqrt((double)s.stiffness), worst = 0;
        int n = 0, rest = 0;
        for (; n < 1000000 && rest < 1000; n++) {
            x = nkw_spring_step(s, x, motion(goal, 0), h);
            rest = x.value == goal ? rest + 1 : 0;
            worst =
                fmax(worst, fabs((double)x.value - (double)goal - e * deviation(omega, ratio, (double)h * (n + 1))));
        }
        expect_bits(x.value, goal);
        assert_true(worst <= ulp_of(goal) * (1 + fmax(2 * (double)ratio, 1 / (double)ratio) / (omega * (double)h)));
    }
}

static void rotations_arrive_at_any_frame_rate(void **state)
{
    (void)state;
    random_source r = random_from(11);
    for (int i = 0; i < 24; i++) {
        float h = 1 / rates[i % 4], half = halves[i / 4 % 3];
        nkw_quat goal = random_rotation(&r), x = random_near(&r, goal, 0.1f);
        nkw_quat_state m = still(x), g = still(goal);
        nkw_spring s = nkw_spring_from_half_life(half, 1);
        for (int n = 0; n < 80000; n++) {
            x = nkw_quat_damper_step(x, goal, half, h);
            expect_near(nkw_quat_length(x), 1, 2e-7);
            m = nkw_quat_spring_step(s, &m, &g, h);
        }
        /* The goal with the length 1, rounded. */
        expect_quat_near(x, goal, 6.1e-8);
        expect_quat_near(m.value, goal, 6.1e-8);
    }
}

static void what_oscillates_or_drifts_is_not_drawn_to_the_goal(void **state)
{
    (void)state;
    nkw_spring swing = {1, 0}, drag = {0, 1}, none = {0, 0}, slow = {1, 1e-4f};
    nkw_state x = motion(1001, 0), y = motion(10, 1e-9f), z = y, w = x;
    nkw_quat_state q = rotating(nkw_quat_identity(), vec(1e-9f, 0, 0)), g = still(nkw_quat_identity());
    q.value = nkw_quat_normalize(nkw_quat_from_axis_angle(vec(0.6f, 0.8f, 0), 1));
    g.value = nkw_quat_normalize(nkw_quat_from_axis_angle(vec(0.6f, 0.8f, 0), 1.5f));
    nkw_quat start = q.value;
    double most = 0, less = 0;
    for (int i = 0; i < 1000000; i++) {
        x = nkw_spring_step(swing, x, motion(1000, 0), 1e-3f);
        y = nkw_spring_step(drag, y, motion(20, 0), 1e-3f);
        z = nkw_spring_step(none, z, motion(20, 0), 1e-3f);
        w = nkw_spring_step(slow, w, motion(1000, 0), 1e-3f);
        q = nkw_quat_spring_step(drag, &q, &g, 1e-3f);
        most = i < 990000 ? 0 : fmax(most, fabs((double)x.value - 1000));
        less = i < 990000 ? 0 : fmax(less, fabs((double)w.value - 1000));
    }
    expect_near(most, 1, 0.02);
    expect_near(less, exp(-0.5e-4 * 990), 0.05);
    expect_quat_near(q.value, start, 1.3e-7);
    expect_bits(y.value, 10);
    expect_bits(z.value, 10);
}

static void a_moving_goal_is_reached_at_any_frame_rate(void **state)
{
    (void)state;
    nkw_spring s = nkw_spring_from_half_life(1, 1);
    nkw_state x = motion(10000, 0);
    for (int i = 0; i < 100000; i++) {
        nkw_state goal = motion((float)(10010 + 0.1 * i * 1e-3), 0.1f);
        x = nkw_spring_step(s, x, goal, 1e-3f);
        if (i > 40000)
            expect_near(x.value, goal.value, 8 * ulp_of(10000));
    }
}

static void long_times_run_out(void **state)
{
    (void)state;
    nkw_spring_timed timed = {nkw_spring_from_half_life(1, 1), 0x1p20f, motion(0, 0), motion(0, 0)};
    for (int i = 0; i < 1000; i++) {
        float before = timed.time_left;
        nkw_spring_timed_step(&timed, 3, 1e-3f);
        assert_true(timed.time_left < before);
    }
}

static void an_infinite_half_life_returns_the_value(void **state)
{
    (void)state;
    random_source r = random_from(12);
    expect_bits(nkw_damper_step(0x1.6098cap-24f, 0x1.afb136p+23f, INFINITY, 1), 0x1.6098cap-24f);
    for (int i = 0; i < 2000; i++) {
        float x = random_finite(&r), goal = random_finite(&r);
        nkw_quat a = random_rotation(&r), b = random_rotation(&r);
        expect_bits(nkw_damper_step(x, goal, INFINITY, 1), x);
        expect_quat_bits(nkw_quat_damper_step(a, b, INFINITY, 1), a);
    }
    expect_nan(nkw_damper_step(1, NAN, INFINITY, 1));
}

/* cos w h with w h as two doubles: (1, 0) to 0 without damping; and 2^25 oscillations and a quarter. */
static void long_steps_keep_their_phase(void **state)
{
    (void)state;
    nkw_spring s = {0x1.31dcaep+10f, 0};
    expect_near(nkw_spring_step(s, motion(1, 0), motion(0, 0), 0x1.8e1a1p+22f).value, -0.522703853, 4e-8);
    const float week = 604800;
    for (int i = 1; i < 20; i++) {
        nkw_spring whole = {(float)(i * i), 0};
        nkw_state got = nkw_spring_step(whole, motion(2, 0), motion(0, 0), week);
        expect_near(got.value, 2 * cos((double)i * (double)week), 3e-7);
        expect_near(got.velocity, -2 * i * sin((double)i * (double)week), 3e-7 * i);
    }
}

/* About an axis at 1e-5 rad/s: each step turns by a tenth of the rounding. */
static void a_moving_rotation_is_reached(void **state)
{
    (void)state;
    nkw_spring s = nkw_spring_from_half_life(1, 1);
    nkw_vec3 axis = nkw_vec3_normalize(vec(1, 2, -1));
    nkw_quat_state x = still(nkw_quat_from_axis_angle(axis, 0.5f));
    for (int i = 0; i < 40000; i++) {
        float angle = (float)(1 + 1e-8 * i);
        nkw_quat_state goal = rotating(nkw_quat_from_axis_angle(axis, angle), nkw_vec3_scale(axis, 1e-5f));
        x = nkw_quat_spring_step(s, &x, &goal, 1e-3f);
        if (i > 30000)
            expect_near(nkw_quat_angle(x.value, goal.value), 0, 1e-6);
    }
}

static void the_least_step_is_the_next_float(void **state)
{
    (void)state;
    const float least = 0x1p-149f, one = 1, above = 1 + 0x1p-23f, below = 1 - 0x1p-24f;
    expect_bits(nkw_damper_step(0, least, 1000, 1e-3f), least);
    expect_bits(nkw_damper_step(0, -least, 1000, 1e-3f), -least);
    expect_bits(nkw_damper_step(-least, 0, 1000, 1e-3f), -0.0f);
    expect_bits(nkw_damper_step(one, 1.1f, 1e6f, 1e-3f), above);
    expect_bits(nkw_damper_step(one, 0.9f, 1e6f, 1e-3f), below);
    expect_bits(nkw_damper_step(-one, -1.1f, 1e6f, 1e-3f), -above);
    expect_bits(nkw_damper_step(-one, -0.9f, 1e6f, 1e-3f), -below);
    expect_bits(nkw_damper_step(one, one, 1e6f, 1e-3f), one);
    expect_bits(nkw_damper_step(INFINITY, 1, 1e6f, 1e-3f), INFINITY);
}

static void vectors_arrive_component_by_component(void **state)
{
    (void)state;
    nkw_spring s = nkw_spring_from_half_life(1, 1);
    nkw_vec3_state v = moving(vec(9999, -5, 0.75f), vec(0, 0, 0)), goal = moving(vec(10000, -5.001f, 1), vec(0, 0, 0));
    nkw_state x = motion(9999, 0), y = motion(-5, 0), z = motion(0.75f, 0);
    nkw_vec3 d = v.value;
    for (int i = 0; i < 20000; i++) {
        nkw_vec3 before = d;
        v = nkw_vec3_spring_step(s, &v, &goal, 1e-3f);
        d = nkw_vec3_damper_step(d, goal.value, 1, 1e-3f);
        x = nkw_spring_step(s, x, motion(10000, 0), 1e-3f);
        y = nkw_spring_step(s, y, motion(-5.001f, 0), 1e-3f);
        z = nkw_spring_step(s, z, motion(1, 0), 1e-3f);
        expect_vec3_bits(v.value, vec(x.value, y.value, z.value));
        expect_bits(d.y, nkw_damper_step(before.y, goal.value.y, 1, 1e-3f));
    }
    expect_vec3_bits(v.value, goal.value);
    expect_vec3_bits(d, goal.value);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dampers_arrive_at_any_frame_rate),
        cmocka_unit_test(springs_arrive_at_any_frame_rate),
        cmocka_unit_test(rotations_arrive_at_any_frame_rate),
        cmocka_unit_test(what_oscillates_or_drifts_is_not_drawn_to_the_goal),
        cmocka_unit_test(a_moving_goal_is_reached_at_any_frame_rate),
        cmocka_unit_test(long_times_run_out),
        cmocka_unit_test(an_infinite_half_life_returns_the_value),
        cmocka_unit_test(long_steps_keep_their_phase),
        cmocka_unit_test(a_moving_rotation_is_reached),
        cmocka_unit_test(the_least_step_is_the_next_float),
        cmocka_unit_test(vectors_arrive_component_by_component),
    };
    return cmocka_run_group_tests_name("spring_rest", tests, NULL, NULL);
}
