/* SPDX-License-Identifier: MIT */
#include <float.h>
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/motions.h"

static nkw_state some_motion(random_source *r)
{
    float value = random_between(r, -3, 3);
    return motion(value, random_between(r, -5, 5));
}

/* Springs of every kind. */
static nkw_spring some_spring(random_source *r, int i)
{
    const nkw_spring odd[4] = {{0, 0}, {0, 5}, {300, 0}, {1e-4f, 30}};
    if (i % 8 < 4)
        return odd[i % 8];
    return nkw_spring_from_half_life(random_between(r, 0.02f, 0.5f), random_between(r, 0.05f, 3));
}

static void timed_springs_are_at_their_goal_at_their_time(void **state)
{
    (void)state;
    random_source r = random_from(61);
    for (int i = 0; i < 4000; i++) {
        float time = random_between(&r, 0.01f, 3), goal = random_between(&r, -3, 3);
        nkw_state from = some_motion(&r);
        nkw_spring_timed timed = {some_spring(&r, i), time, from, motion(from.value, 0)};
        int steps = 0;
        for (; timed.time_left > 0; steps++)
            nkw_spring_timed_step(&timed, goal, i % 3 ? 1 / 60.0f : random_between(&r, 0, 0.2f));
        assert_true(steps > 0);
        expect_bits(timed.state.value, goal);
        expect_bits(timed.state.velocity, 0);
        expect_bits(timed.point.value, goal);
        nkw_spring_timed_step(&timed, goal, 0.01f);
        expect_bits(timed.state.value, goal);
        /* The goal may change on the way, and after it. */
        timed.time_left = 0.5f;
        for (int k = 0; timed.time_left > 0; k++)
            nkw_spring_timed_step(&timed, k < 9 ? 7.0f : goal, 0.03f);
        expect_bits(timed.state.value, goal);
        expect_bits(timed.state.velocity, 0);
    }
}

/* The motion comes near: with the time its distance and its velocity vanish, without a jump at the end. */
static void timed_springs_do_not_jump(void **state)
{
    (void)state;
    random_source r = random_from(62);
    for (int i = 0; i < 2000; i++) {
        nkw_state from = some_motion(&r);
        nkw_spring s = some_spring(&r, i);
        float stiff = nkw_sqrt(s.stiffness) + s.damping;
        for (int k = 1; k < 6; k++) {
            float left = nkw_pow(0.1f, (float)k);
            nkw_spring_timed timed = {s, 1, from, motion(from.value, 0)};
            nkw_spring_timed_step(&timed, 2, 1 - left);
            expect_near(timed.state.value, 2, 60 * (double)(left * left * (1 + stiff) + 1e-7f));
            expect_near(timed.state.velocity, 0, 60 * (double)(left * (1 + stiff * stiff) + 1e-4f));
        }
    }
}

/* ---- The least effort, by another road ---- */

/* A state, and the costates of Pontryagin's principle for the integral of u^2/2, in which u = -b. */
typedef struct effort {
    double x, v, a, b;
} effort;

typedef struct task {
    double stiffness, damping, point, rate;
} task;

static effort derivative(const task *k, effort e, double t, int is_free)
{
    double pull = is_free ? 0 : k->stiffness * (k->point + k->rate * t) + k->damping * k->rate;
    effort d = {e.v, pull - k->stiffness * e.x - k->damping * e.v - e.b, k->stiffness * e.b, -e.a + k->damping * e.b};
    return d;
}

static effort after(effort e, effort d, double h)
{
    effort r = {e.x + h * d.x, e.v + h * d.v, e.a + h * d.a, e.b + h * d.b};
    return r;
}

/* Runge's and Kutta's method, of fourth order, over `seconds`. */
static effort integrated(const task *k, effort e, double seconds, int is_free)
{
    enum { STEPS = 2000 };
    double h = seconds / STEPS;
    for (int i = 0; i < STEPS; i++) {
        double t = i * h;
        effort k1 = derivative(k, e, t, is_free), k2 = derivative(k, after(e, k1, h / 2), t + h / 2, is_free);
        effort k3 = derivative(k, after(e, k2, h / 2), t + h / 2, is_free);
        effort k4 = derivative(k, after(e, k3, h), t + h, is_free);
        e = after(after(after(after(e, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
    }
    return e;
}

/* While the point moves, then at the goal. */
static effort both(task k, effort e, double goal, double moves, double rests, int is_free)
{
    const task still = {k.stiffness, k.damping, goal, 0};
    return integrated(&still, integrated(&k, e, moves, is_free), rests, is_free);
}

static void timed_springs_arrive_with_the_least_effort(void **state)
{
    (void)state;
    random_source r = random_from(63);
    for (int i = 0; i < 400; i++) {
        /* Costates grow by e^(damping time): springs for which binary64 holds that. */
        nkw_spring s = nkw_spring_from_half_life(random_between(&r, 0.2f, 1), random_between(&r, 0.05f, 1.2f));
        const nkw_spring odd[4] = {{0, 0}, {0, 5}, {300, 0}, {1e-4f, 8}};
        nkw_state from = some_motion(&r);
        s = i % 8 < 4 ? odd[i % 8] : s;
        float point = i % 2 ? from.value : random_between(&r, -3, 3), goal = random_between(&r, -3, 3);
        float time = random_between(&r, 0.1f, 1), h = time * random_between(&r, 0.05f, 0.95f);
        double lead = s.stiffness > 0 ? (double)s.damping / (double)s.stiffness : 0, moves = (double)time - lead;
        moves = moves > 0 ? moves : 0;
        const task k = {(double)s.stiffness, (double)s.damping, (double)point, ((double)goal - (double)point) / (double)time};
        const effort begin = {(double)from.value, (double)from.velocity, 0, 0}, one = {0, 0, 1, 0}, two = {0, 0, 0, 1};
        double rests = (double)time - moves, first = moves < (double)h ? moves : (double)h;
        effort b = both(k, begin, (double)goal, moves, rests, 0);
        effort x = both(k, one, 0, moves, rests, 1), y = both(k, two, 0, moves, rests, 1);
        double miss = (double)goal - b.x, det = x.x * y.v - y.x * x.v;
        effort with = begin;
        with.a = (miss * y.v + b.v * y.x) / det;
        with.b = (-b.v * x.x - miss * x.v) / det;
        effort want = both(k, with, (double)goal, first, (double)h - first, 0);
        nkw_spring_timed timed = {s, time, from, motion(point, 0)};
        nkw_spring_timed_step(&timed, goal, h);
        double size = fabs((double)goal) + fabs(begin.x) + fabs((double)point) + fabs(begin.v) * (double)time;
        double rate = sqrt(k.stiffness) + k.damping + 6 / (double)time;
        expect_near(timed.state.value, want.x, 1.01 * 0x1p-24 * size);
        expect_near(timed.state.velocity, want.v, 1.01 * 0x1p-24 * size * rate);
    }
}

static void timed_steps_compose(void **state)
{
    (void)state;
    random_source r = random_from(10);
    for (int i = 0; i < 5000; i++) {
        float time = random_between(&r, 0.01f, 1), h = random_between(&r, 0.01f, 0.5f);
        nkw_spring s = nkw_spring_from_half_life(random_between(&r, 0.01f, 0.3f), random_between(&r, 0.3f, 2));
        nkw_state from = some_motion(&r);
        nkw_spring_timed once = {s, time, from, motion(from.value, 0)}, twice = once;
        nkw_spring_timed_step(&once, 2, 2 * h);
        nkw_spring_timed_step(&twice, 2, h);
        nkw_spring_timed_step(&twice, 2, h);
        expect_near(twice.state.value, once.state.value, 1e-5);
        expect_near(twice.state.velocity, once.state.velocity, 5e-4 * (1 + s.damping));
        expect_near(once.time_left, twice.time_left, 1e-6);
        expect_near(once.point.value, twice.point.value, 2e-6);
    }
}

static void timed_vectors_and_rotations_move_as_numbers_do(void **state)
{
    (void)state;
    const nkw_spring s = nkw_spring_from_half_life(0.1f, 1);
    nkw_spring_timed a = {s, 0.6f, motion(0, 1), motion(0, 0)};
    nkw_vec3_spring_timed b = {s, 0.6f, moving(vec(0, 5, 0), vec(1, 0, 0)), moving(vec(0, 5, 0), vec(0, 0, 0))};
    nkw_quat_spring_timed c = {s, 0.6f, rotating(nkw_quat_identity(), vec(0, 0, 1)), rotating(nkw_quat_identity(), vec(0, 0, 0))};
    for (int i = 0; i < 30; i++) {
        nkw_spring_timed_step(&a, 2, 0.03f);
        nkw_vec3_spring_timed_step(&b, vec(2, 5, 0), 0.03f);
        nkw_quat_spring_timed_step(&c, nkw_quat_from_axis_angle(vec(0, 0, 1), 2), 0.03f);
        expect_bits(b.state.value.x, a.state.value);
        expect_bits(b.state.value.y, 5);
        expect_rotation_near(c.state.value, nkw_quat_from_axis_angle(vec(0, 0, 1), a.state.value), 1e-5);
        expect_bits(b.time_left, a.time_left);
        expect_bits(c.time_left, a.time_left);
    }
    nkw_spring_timed_step(&a, 9, -1);
    expect_bits(b.state.value.x, a.state.value);
}

/* No number is worse than NaN, and the time passes. */
static void odd_times_have_an_answer(void **state)
{
    (void)state;
    const float odd[] = {0, -1, 1e-45f, 1e-20f, 1, 1e20f, FLT_MAX, INFINITY, NAN};
    for (int i = 0; i < 9 * 9 * 9; i++) {
        const nkw_spring s = {odd[i % 9], odd[i / 9 % 9]};
        nkw_spring_timed timed = {s, odd[i / 81], motion(1, 2), motion(1, 0)};
        nkw_quat_spring_timed turning = {s, odd[i / 81], rotating(nkw_quat_identity(), vec(0, 1, 0)),
                                         rotating(nkw_quat_identity(), vec(0, 0, 0))};
        float before = timed.time_left;
        nkw_spring_timed_step(&timed, 3, 0.25f);
        nkw_quat_spring_timed_step(&turning, nkw_quat_from_axis_angle(vec(0, 0, 1), 1), 0.25f);
        expect_bits(timed.time_left, turning.time_left);
        assert_true(timed.time_left < before || before <= 0 || before != before);
        if (before > 0 && before <= 0.25f) {
            expect_bits(timed.state.value, 3);
            expect_near(nkw_quat_angle(turning.state.value, nkw_quat_from_axis_angle(vec(0, 0, 1), 1)), 0, 1e-6);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(timed_springs_are_at_their_goal_at_their_time),
        cmocka_unit_test(timed_springs_do_not_jump),
        cmocka_unit_test(timed_springs_arrive_with_the_least_effort),
        cmocka_unit_test(timed_steps_compose),
        cmocka_unit_test(timed_vectors_and_rotations_move_as_numbers_do),
        cmocka_unit_test(odd_times_have_an_answer),
    };
    return cmocka_run_group_tests_name("spring_timed", tests, NULL, NULL);
}
