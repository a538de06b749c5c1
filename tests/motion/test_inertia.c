/* SPDX-License-Identifier: MIT */
#include <float.h>
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/motions.h"

#define U 0x1p-24

static nkw_state some_motion(random_source *r)
{
    float value = random_between(r, -3, 3);
    return motion(value, random_between(r, -10, 10));
}

static void expect_motion(nkw_state got, nkw_state want)
{
    expect_bits(got.value, want.value);
    expect_bits(got.velocity, want.velocity);
}

static void value_and_velocity_are_continuous_at_both_ends(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 20000; i++) {
        nkw_state from = some_motion(&r), to = some_motion(&r);
        float duration = random_between(&r, 0.05f, 2);
        nkw_offset x = inertia_of(from, to, duration);
        assert_true(x.end > 0 && x.end <= duration);
        nkw_state begin = nkw_offset_evaluate(&x, to, 0), end = nkw_offset_evaluate(&x, to, 0.9999f * x.end);
        expect_near(begin.value, from.value, 1e-6);
        /* c[1] = V + 3 x is rounded to a float. */
        double size = fabs(from.value - to.value) + fabs(from.velocity - to.velocity) * x.end;
        expect_near(begin.velocity, from.velocity, 5e-7 * (size / x.end + fabs(to.velocity)));
        expect_near(end.value, to.value, 1e-6);
        expect_near(end.velocity, to.velocity, 1e-5 + 1e-6 * size / x.end);
        expect_motion(nkw_offset_evaluate(&x, to, x.end), to);
        expect_motion(nkw_offset_evaluate(&x, to, INFINITY), to);
    }
}

static void the_velocity_is_the_rate_of_the_value(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 5000; i++) {
        nkw_state from = some_motion(&r), to = motion(0, 0);
        nkw_offset x = inertia_of(from, to, 1);
        float d = 1e-3f * x.end, t = random_between(&r, 2 * d, x.end - 2 * d);
        double rate = ((double)nkw_offset_evaluate(&x, to, t + d).value - nkw_offset_evaluate(&x, to, t - d).value) /
                      ((double)(t + d) - (t - d));
        expect_near(nkw_offset_evaluate(&x, to, t).velocity, rate, 3e-3 * (fabs(from.velocity) + fabs(from.value)));
    }
}

static void offsets_that_shrink_neither_change_their_sign_nor_grow(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 5000; i++) {
        float sign = i & 1 ? -1.0f : 1.0f, value = sign * random_between(&r, 0.01f, 3),
              velocity = -sign * random_between(&r, 0, i % 3 ? 100.0f : 2.0f), last = fabsf(value);
        nkw_offset x = inertia_of(motion(value, velocity), motion(0, 0), 0.5f);
        for (int k = 0; k <= 50; k++) {
            float offset = sign * nkw_offset_evaluate(&x, motion(0, 0), 0.02f * (float)k * x.end).value;
            assert_true(offset >= -1e-7f * fabsf(value) && offset <= last + 1e-6f * fabsf(value));
            last = offset;
        }
    }
}

/* x = 1, T = 1: without velocity (1 - u)^3 (1 + 3 u + 6 u^2); at v = -5 and beyond (1 - u)^5. */
static void known_offsets_come_out(void **state)
{
    (void)state;
    nkw_offset rest = inertia_of(motion(1, 0), motion(0, 0), 1);
    expect_bits(nkw_offset_evaluate(&rest, motion(0, 0), 0.5f).value, 0.5f);
    nkw_offset limit = inertia_of(motion(1, -5), motion(0, 0), 1);
    expect_bits(limit.end, 1);
    expect_bits(nkw_offset_evaluate(&limit, motion(0, 0), 0.5f).value, 0x1p-5f);
    nkw_offset fast = inertia_of(motion(1, -10), motion(0, 0), 1);
    expect_bits(fast.end, 0.5f);
    expect_bits(nkw_offset_evaluate(&fast, motion(0, 0), 0.25f).value, 0x1p-5f);
    nkw_offset away = inertia_of(motion(0, 1), motion(0, 0), 1);
    expect_bits(nkw_offset_evaluate(&away, motion(0, 0), 0.5f).value, 0.15625f);
}

static void offsets_that_grow_stay_below_their_bound(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 2000; i++) {
        float value = random_between(&r, 0, 1), velocity = random_between(&r, 0, 20);
        nkw_offset x = inertia_of(motion(value, velocity), motion(0, 0), 1);
        for (int k = 0; k <= 100; k++)
            assert_true(nkw_offset_evaluate(&x, motion(0, 0), 0.01f * (float)k).value <= value + 0.22f * velocity);
    }
}

static void bad_durations_end_the_transition_at_once(void **state)
{
    (void)state;
    const float bad[] = {0, -0.0f, -1, NAN, INFINITY, -INFINITY};
    nkw_quat_state a = rotating(nkw_quat_identity(), vec(1, 2, 3)),
                    b = rotating(random_rotation(&(random_source){{1, 2, 3, 4}, NULL, 0}), vec(0, 0, 1));
    nkw_vec3_state v = moving(vec(1, 2, 3), vec(4, 5, 6)), w = moving(vec(-1, 0, 0), vec(0, 0, 0));
    for (int i = 0; i < 6; i++) {
        nkw_offset x = inertia_of(motion(1, 2), motion(3, 4), bad[i]);
        nkw_vec3_offset y = inertia_of_vec3(&v, &w, bad[i]);
        nkw_quat_offset z = inertia_of_quat(&a, &b, bad[i]);
        expect_motion(nkw_offset_evaluate(&x, motion(3, 4), 0), motion(3, 4));
        expect_vec3_bits(nkw_vec3_offset_evaluate(&y, &w, 0).value, w.value);
        expect_quat_bits(nkw_quat_offset_evaluate(&z, &b, 0).value, b.value);
        expect_vec3_bits(nkw_quat_offset_evaluate(&z, &b, -1).velocity, b.velocity);
        if (i == 4)
            continue;
        nkw_offset d = dead_of(motion(1, 2), 0.1f, bad[i]);
        nkw_quat_offset q = dead_of_quat(a, 0.1f, bad[i]);
        expect_motion(nkw_offset_evaluate(&d, motion(3, 4), 0), motion(3, 4));
        expect_quat_bits(nkw_quat_offset_evaluate(&q, &b, 0).value, b.value);
    }
}

static void early_times_and_nan_are_the_beginning(void **state)
{
    (void)state;
    nkw_offset x = inertia_of(motion(1, 2), motion(3, 4), 1);
    nkw_offset d = dead_of(motion(1, 2), 0.1f, 1);
    const float early[] = {-1, -INFINITY, NAN, -0.0f};
    for (int i = 0; i < 4; i++) {
        expect_motion(nkw_offset_evaluate(&x, motion(3, 4), early[i]), nkw_offset_evaluate(&x, motion(3, 4), 0));
        expect_motion(nkw_offset_evaluate(&d, motion(3, 4), early[i]), motion(1, 2));
    }
    nkw_offset unknown = inertia_of(motion(NAN, 0), motion(0, 0), 1);
    expect_nan(nkw_offset_evaluate(&unknown, motion(0, 0), 0.5f).value);
    expect_nan(nkw_offset_evaluate(&x, motion(NAN, 0), 0.5f).value);
    expect_motion(nkw_offset_evaluate(&unknown, motion(0, 0), 1), motion(0, 0));
}

static void vectors_along_one_axis_are_numbers(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 500; i++) {
        nkw_state a = some_motion(&r), b = some_motion(&r);
        nkw_vec3_state from = moving(vec(0, a.value, 0), vec(0, a.velocity, 0)),
                        to = moving(vec(0, b.value, 0), vec(0, b.velocity, 0));
        nkw_vec3_offset v = inertia_of_vec3(&from, &to, 0.5f);
        nkw_offset number = inertia_of(a, b, 0.5f);
        nkw_state want = nkw_offset_evaluate(&number, b, 0.1f);
        nkw_vec3_state got = nkw_vec3_offset_evaluate(&v, &to, 0.1f);
        expect_bits(got.value.y, want.value);
        expect_bits(got.velocity.y, want.velocity);
        expect_bits(got.value.x, 0);
    }
}

/* The velocity at right angles to the offset is kept too, and turning both motions turns the transition. */
static void vectors_are_continuous_and_do_not_depend_on_the_axes(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 5000; i++) {
        nkw_vec3_state from = moving(random_vec3(&r, -3, 3), random_vec3(&r, -3, 3)),
                        to = moving(random_vec3(&r, -3, 3), random_vec3(&r, -3, 3));
        nkw_quat q = random_rotation(&r);
        nkw_vec3_state from_q = moving(nkw_quat_rotate(q, from.value), nkw_quat_rotate(q, from.velocity)),
                        to_q = moving(nkw_quat_rotate(q, to.value), nkw_quat_rotate(q, to.velocity));
        nkw_vec3_offset v = inertia_of_vec3(&from, &to, 1), vq = inertia_of_vec3(&from_q, &to_q, 1);
        nkw_vec3_state begin = nkw_vec3_offset_evaluate(&v, &to, 0);
        expect_vec3_near(begin.value, from.value, 2e-6);
        expect_vec3_near(begin.velocity, from.velocity, 1e-5);
        float t = random_unit(&r);
        expect_vec3_near(nkw_vec3_offset_evaluate(&vq, &to_q, t).value,
                         nkw_quat_rotate(q, nkw_vec3_offset_evaluate(&v, &to, t).value), 2e-5);
    }
}

static void rotations_begin_with_rotation_and_velocity_of_the_old_motion(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (int i = 0; i < 20000; i++) {
        nkw_quat_state from = rotating(random_rotation(&r), random_vec3(&r, -3, 3)),
                        to = rotating(random_rotation(&r), random_vec3(&r, -3, 3));
        if (i % 4 == 0)
            to.value = random_near(&r, from.value, 1.5707f);
        nkw_quat_offset x = inertia_of_quat(&from, &to, 0.5f);
        nkw_quat_state begin = nkw_quat_offset_evaluate(&x, &to, 0);
        expect_rotation_near(begin.value, from.value, 6e-7);
        expect_vec3_near(begin.velocity, from.velocity, 2e-5);
        expect_quat_bits(nkw_quat_offset_evaluate(&x, &to, 0.5f).value, to.value);
        expect_near(nkw_quat_length(nkw_quat_offset_evaluate(&x, &to, random_unit(&r)).value), 1, 4e-7);
    }
}

/* The new motion passes half a turn from the old one while the transition runs. */
static void rotations_do_not_snap_at_half_a_turn(void **state)
{
    (void)state;
    nkw_vec3 z = vec(0, 0, 1), y = vec(0, 1, 0);
    nkw_quat_state from = rotating(nkw_quat_from_axis_angle(y, 0.1f), vec(0, 0, -1)),
                    to = rotating(nkw_quat_from_axis_angle(z, 3), vec(0, 0, 2)), last = from, dead_last = from;
    nkw_quat_offset x = inertia_of_quat(&from, &to, 1);
    nkw_quat_offset dead = dead_of_quat(from, 0.3f, 1);
    for (int i = 0; i <= 1000; i++) {
        float t = 0.001f * (float)i;
        to.value = nkw_quat_from_axis_angle(z, 3 + 2 * t);
        nkw_quat_state got = nkw_quat_offset_evaluate(&x, &to, t),
                        blended = nkw_quat_offset_evaluate(&dead, &to, t);
        assert_true(nkw_quat_angle(last.value, got.value) < 0.012f);
        assert_true(nkw_quat_angle(dead_last.value, blended.value) < 0.012f);
        if (i > 0) {
            nkw_vec3 w = nkw_quat_angular_velocity(last.value, got.value, 0.001f),
                     v = nkw_quat_angular_velocity(dead_last.value, blended.value, 0.001f);
            expect_vec3_near(nkw_vec3_lerp(last.velocity, got.velocity, 0.5f), w, 0.02);
            expect_vec3_near(nkw_vec3_lerp(dead_last.velocity, blended.velocity, 0.5f), v, 0.02);
        }
        last = got;
        dead_last = blended;
    }
    expect_quat_bits(last.value, to.value);
    expect_quat_bits(dead_last.value, to.value);
}

static void a_second_transition_continues_the_first(void **state)
{
    (void)state;
    random_source r = random_from(8);
    for (int i = 0; i < 2000; i++) {
        nkw_quat_state from = rotating(random_rotation(&r), random_vec3(&r, -3, 3)),
                        a = rotating(random_rotation(&r), random_vec3(&r, -3, 3)),
                        b = rotating(random_rotation(&r), random_vec3(&r, -3, 3));
        nkw_quat_offset first = inertia_of_quat(&from, &a, 0.5f);
        nkw_quat_state middle = nkw_quat_offset_evaluate(&first, &a, 0.2f);
        nkw_quat_offset second = inertia_of_quat(&middle, &b, 0.5f);
        nkw_quat_state got = nkw_quat_offset_evaluate(&second, &b, 0);
        expect_rotation_near(got.value, middle.value, 6e-7);
        expect_vec3_near(got.velocity, middle.velocity, 1e-4);
    }
}

static void dead_blends_begin_with_the_old_and_end_with_the_new(void **state)
{
    (void)state;
    random_source r = random_from(9);
    for (int i = 0; i < 5000; i++) {
        nkw_state from = some_motion(&r), to = some_motion(&r);
        float half_life = random_between(&r, 0.01f, 1), duration = random_between(&r, 0.1f, 1);
        nkw_offset d = dead_of(from, half_life, duration);
        expect_motion(nkw_offset_evaluate(&d, to, 0), from);
        expect_motion(nkw_offset_evaluate(&d, to, duration), to);
        expect_motion(nkw_offset_evaluate(&d, to, INFINITY), to);
        float t = random_between(&r, 0.01f, 0.99f) * duration, u = t / duration;
        double decay = log(2.0) / half_life, old = from.value + from.velocity * (1 - exp(-decay * t)) / decay,
               s = u * u * (3.0 - 2.0 * u), want = old + s * (to.value - old);
        expect_near(nkw_offset_evaluate(&d, to, t).value, want, 4e-6);
        /* The derivative: that of old decays, that of s is 6 u (1 - u)/duration. */
        double left = from.velocity * exp(-decay * t), turn = 6.0 * u * (1.0 - u) / duration * (to.value - old);
        double rate = (1 - s) * left + s * to.velocity + turn;
        expect_near(nkw_offset_evaluate(&d, to, t).velocity, rate,
                    1e-6 * (fabs(left) + fabs((double)to.velocity) + fabs(turn) + 1));
    }
}

static void half_lives_of_zero_and_infinity_stop_and_continue(void **state)
{
    (void)state;
    nkw_offset stopped = dead_of(motion(1, 4), 0, 1), going = dead_of(motion(1, 4), INFINITY, 1);
    expect_bits(nkw_offset_evaluate(&stopped, motion(1, 0), 0.5f).value, 1);
    expect_bits(nkw_offset_evaluate(&going, motion(0, 0), 0.5f).value, 1.5f);
    nkw_offset endless = dead_of(motion(1, 4), INFINITY, INFINITY);
    expect_bits(nkw_offset_evaluate(&endless, motion(0, 0), 2).value, 9);
}

static void dead_vectors_are_component_by_component(void **state)
{
    (void)state;
    random_source r = random_from(10);
    for (int i = 0; i < 500; i++) {
        nkw_vec3 x = random_vec3(&r, -1, 1), w = random_vec3(&r, -1, 1);
        nkw_vec3_offset v = dead_of_vec3(moving(x, w), 0.2f, 0.7f);
        nkw_offset d = dead_of(motion(v.from.value.z, v.from.velocity.z), 0.2f, 0.7f);
        nkw_vec3_state to = moving(random_vec3(&r, -1, 1), random_vec3(&r, -1, 1));
        nkw_vec3_state got = nkw_vec3_offset_evaluate(&v, &to, 0.3f);
        expect_motion(motion(got.value.z, got.velocity.z),
                      nkw_offset_evaluate(&d, motion(to.value.z, to.velocity.z), 0.3f));
    }
}

static void dead_rotations_begin_with_the_old_motion(void **state)
{
    (void)state;
    random_source r = random_from(11);
    for (int i = 0; i < 5000; i++) {
        nkw_quat_state from = rotating(random_rotation(&r), random_vec3(&r, -3, 3)),
                        to = rotating(random_rotation(&r), random_vec3(&r, -3, 3));
        nkw_quat_offset d = dead_of_quat(from, 0.2f, 0.5f);
        nkw_quat_state got = nkw_quat_offset_evaluate(&d, &to, 0);
        expect_rotation_near(got.value, from.value, 5e-7);
        expect_vec3_near(got.velocity, from.velocity, 1e-4);
        expect_quat_bits(nkw_quat_offset_evaluate(&d, &to, 0.5f).value, to.value);
    }
}

/* What spring.md says of it. */
static float half_life_towards(nkw_state from, float to)
{
    return nkw_clamp((to - from.value) / from.velocity, 0.1f, 4);
}

static void half_lives_follow_the_way_to_the_new_value(void **state)
{
    (void)state;
    expect_bits(half_life_towards(motion(0, 2), 1), 0.5f);
    expect_bits(half_life_towards(motion(0, -2), 1), 0.1f);
    expect_bits(half_life_towards(motion(0, 0.01f), 1), 4);
    expect_bits(half_life_towards(motion(0, 0), 1), 4);
    expect_bits(half_life_towards(motion(1, 0), 0), 0.1f);
}

/* The settings stay, so that a transition begins again from what is shown; one that never began has ended. */
static void both_kinds_are_used_alike(void **state)
{
    (void)state;
    nkw_quat_state a = rotating(nkw_quat_from_axis_angle(vec(0, 1, 0), 1), vec(0, 2, 0)),
                   b = rotating(nkw_quat_from_axis_angle(vec(1, 0, 0), 1), vec(0, 0, 1));
    nkw_vec3_state v = moving(vec(1, 2, 3), vec(4, 5, 6)), w = moving(vec(-1, 0, 0), vec(0, 0, 0));
    for (int kind = 0; kind < 2; kind++) {
        nkw_offset o = {.kind = (nkw_offset_kind)kind};
        nkw_vec3_offset p = {.kind = (nkw_offset_kind)kind};
        nkw_quat_offset q = {.kind = (nkw_offset_kind)kind};
        for (int i = 0; i < 3; i++) {
            expect_motion(nkw_offset_evaluate(&o, motion(3, 4), 0), i ? motion(1, 2) : motion(3, 4));
            expect_vec3_near(nkw_vec3_offset_evaluate(&p, &w, 0).value, i ? v.value : w.value, 0);
            expect_rotation_near(nkw_quat_offset_evaluate(&q, &b, 0).value, i ? a.value : b.value, i ? 3e-7 : 0);
            expect_vec3_near(nkw_quat_offset_evaluate(&q, &b, 0).velocity, i ? a.velocity : b.velocity, 2e-6);
            expect_motion(nkw_offset_evaluate(&o, motion(3, 4), 0.5f), motion(3, 4));
            expect_vec3_bits(nkw_vec3_offset_evaluate(&p, &w, 0.5f).value, w.value);
            expect_quat_bits(nkw_quat_offset_evaluate(&q, &b, 0.5f).value, b.value);
            o.duration = p.duration = q.duration = 0.5f;
            o.half_life = p.half_life = q.half_life = 0.1f;
            nkw_offset_begin(&o, motion(1, 2), motion(3, 4));
            nkw_vec3_offset_begin(&p, &v, &w);
            nkw_quat_offset_begin(&q, &a, &b);
            assert_true(o.end == 0.5f && p.end == 0.5f && q.end == 0.5f);
            assert_true(o.kind == (nkw_offset_kind)kind && o.duration == 0.5f && o.half_life == 0.1f);
        }
    }
}

static void an_unknown_kind_is_inertialisation(void **state)
{
    (void)state;
    nkw_offset known = inertia_of(motion(1, 2), motion(3, 4), 1), odd = {.kind = (nkw_offset_kind)7, .duration = 1};
    nkw_offset_begin(&odd, motion(1, 2), motion(3, 4));
    expect_motion(nkw_offset_evaluate(&odd, motion(3, 4), 0.25f), nkw_offset_evaluate(&known, motion(3, 4), 0.25f));
}

static void bodies_move_smoothly_between_steps_of_physics(void **state)
{
    (void)state;
    random_source r = random_from(12);
    for (int i = 0; i < 2000; i++) {
        nkw_body_motion a = {moving(random_vec3(&r, -2, 2), random_vec3(&r, -2, 2)),
                             rotating(random_rotation(&r), random_vec3(&r, -9, 9))},
                        b = {moving(random_vec3(&r, -2, 2), random_vec3(&r, -2, 2)),
                             rotating(random_rotation(&r), random_vec3(&r, -9, 9))};
        const float h = 1 / 30.0f;
        nkw_body_motion first = nkw_body_motion_between(&a, &b, h, 0), last = nkw_body_motion_between(&a, &b, h, 1);
        expect_vec3_bits(first.position.value, a.position.value);
        expect_vec3_near(first.position.velocity, a.position.velocity, 1e-6);
        expect_vec3_bits(last.position.value, b.position.value);
        expect_vec3_near(last.position.velocity, b.position.velocity, 1e-6);
        expect_quat_bits(first.rotation.value, a.rotation.value);
        expect_rotation_near(last.rotation.value, b.rotation.value, 0);
        expect_vec3_near(first.rotation.velocity, a.rotation.velocity, 1e-5);
        expect_vec3_near(last.rotation.velocity, b.rotation.velocity, 1e-5);
        nkw_body_motion still = nkw_body_motion_between(&a, &b, i & 1 ? NAN : 0, 0.5f);
        expect_vec3_near(still.position.value, nkw_vec3_lerp(a.position.value, b.position.value, 0.5f), 1e-6);
        expect_vec3_near(still.position.velocity, vec(0, 0, 0), 0);
        expect_vec3_near(still.rotation.velocity, vec(0, 0, 0), 0);
    }
}

/* A wheel at 100 rad/s passes 10/3 rad in a step of 1/30 s: more than half a turn. */
static void fast_wheels_turn_as_often_as_their_velocity_says(void **state)
{
    (void)state;
    const float h = 1 / 30.0f;
    nkw_vec3 w = vec(0, 0, 100);
    nkw_body_motion a = {moving(vec(0, 0, 0), vec(3, 0, 0)), rotating(nkw_quat_identity(), w)},
                    b = {moving(vec(0.1f, 0, 0), vec(3, 0, 0)),
                         rotating(nkw_quat_integrate(nkw_quat_identity(), w, h), w)};
    for (int i = 0; i <= 10; i++) {
        float t = 0.1f * (float)i;
        nkw_body_motion got = nkw_body_motion_between(&a, &b, h, t);
        expect_rotation_near(got.rotation.value, nkw_quat_integrate(nkw_quat_identity(), w, t * h), 2e-6);
        expect_vec3_near(got.rotation.velocity, w, 1e-3);
        expect_vec3_near(got.position.value, vec(0.1f * t, 0, 0), 1e-7);
    }
}

static double offset_at(const float *c, double u)
{
    return (1 - u) * (1 - u) * (1 - u) * ((double)c[0] + u * ((double)c[1] + u * (double)c[2]));
}

/* Coefficients of another size than the offset, and times whose quotient is no float. */
static void offsets_and_blends_are_rounded_once(void **state)
{
    (void)state;
    random_source r = random_from(12);
    nkw_offset known = {.end = 0x1.fd005cp+0f, .c = {0x1.044d7cp+9f, 0x1.3d7bc6p+1f, -0x1.06a28p+0f}};
    for (int i = 0; i < 50000; i++) {
        nkw_offset x = known;
        nkw_state to = some_motion(&r), from = some_motion(&r);
        for (int k = 0; k < 3 && i > 0; k++)
            x.c[k] = ldexpf(random_between(&r, -1, 1), (int)(random_bits(&r) % 20) - 10);
        float t = i ? random_unit(&r) * x.end : 0x1.1f3dccp-8f;
        to.value = i ? to.value : 0x1.0003p+1f;
        double size = fabs(to.value) + fabs(x.c[0]) + fabs(x.c[1]) + fabs(x.c[2]);
        double want = (double)to.value + offset_at(x.c, (double)t / (double)x.end);
        expect_near(nkw_offset_evaluate(&x, to, t).value, want, 1.01 * U * size);
        nkw_offset d = dead_of(from, random_between(&r, 0.001f, 2), x.end);
        double h = (double)d.half_life / log(2), carried = (double)from.velocity * h * -expm1(-(double)t / h);
        double old = (double)from.value + carried, u = (double)t / (double)x.end;
        want = old + u * u * (3 - 2 * u) * ((double)to.value - old);
        size = fabs(from.value) + fabs(carried) + fabs(to.value);
        expect_near(nkw_offset_evaluate(&d, to, t).value, want, 1.01 * U * size);
    }
}

/* The offset of rotations at rest is x (1 - u)^3 (1 + 3 u + 6 u^2), about one axis. */
static void rotations_from_rest_to_rest_keep_to_the_quintic(void **state)
{
    (void)state;
    const nkw_quat from = {-0x1.77cf74p-2f, 0x1.4a858ap-1f, 0x1.4cfd3ep-1f, -0x1.47a3c6p-3f},
                   to = {0x1.9a4fc4p-1f, 0x1.199fa8p-7f, 0x1.d95588p-2f, -0x1.84a08cp-2f};
    const float duration = 0x1.3b0898p-1f, t = 0x1.58af1ap-3f;
    nkw_quat_state a = rotating(from, vec(0, 0, 0)), b = rotating(to, vec(0, 0, 0));
    nkw_quat_offset i = inertia_of_quat(&a, &b, duration);
    nkw_quat got = nkw_quat_offset_evaluate(&i, &b, t).value;
    double dot = (double)from.x * (double)to.x + (double)from.y * (double)to.y + (double)from.z * (double)to.z +
                 (double)from.w * (double)to.w;
    double u = (double)t / (double)duration, angle = acos(fabs(dot)), sign = dot < 0 ? -1 : 1;
    double part = (1 - u) * (1 - u) * (1 - u) * (1 + 3 * u + 6 * u * u);
    double p = sin(part * angle) / sin(angle) * sign, q = sin((1 - part) * angle) / sin(angle);
    const double want[4] = {p * (double)from.x + q * (double)to.x, p * (double)from.y + q * (double)to.y,
                            p * (double)from.z + q * (double)to.z, p * (double)from.w + q * (double)to.w};
    const float g[4] = {got.x, got.y, got.z, got.w};
    double off = 0;
    for (int k = 0; k < 4; k++)
        off += ((double)g[k] - want[k]) * ((double)g[k] - want[k]);
    expect_near(sqrt(off), 0, 2.5 * U);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(value_and_velocity_are_continuous_at_both_ends),
        cmocka_unit_test(the_velocity_is_the_rate_of_the_value),
        cmocka_unit_test(offsets_that_shrink_neither_change_their_sign_nor_grow),
        cmocka_unit_test(known_offsets_come_out),
        cmocka_unit_test(offsets_that_grow_stay_below_their_bound),
        cmocka_unit_test(bad_durations_end_the_transition_at_once),
        cmocka_unit_test(early_times_and_nan_are_the_beginning),
        cmocka_unit_test(vectors_along_one_axis_are_numbers),
        cmocka_unit_test(vectors_are_continuous_and_do_not_depend_on_the_axes),
        cmocka_unit_test(rotations_begin_with_rotation_and_velocity_of_the_old_motion),
        cmocka_unit_test(rotations_do_not_snap_at_half_a_turn),
        cmocka_unit_test(a_second_transition_continues_the_first),
        cmocka_unit_test(dead_blends_begin_with_the_old_and_end_with_the_new),
        cmocka_unit_test(half_lives_of_zero_and_infinity_stop_and_continue),
        cmocka_unit_test(dead_vectors_are_component_by_component),
        cmocka_unit_test(dead_rotations_begin_with_the_old_motion),
        cmocka_unit_test(half_lives_follow_the_way_to_the_new_value),
        cmocka_unit_test(both_kinds_are_used_alike),
        cmocka_unit_test(an_unknown_kind_is_inertialisation),
        cmocka_unit_test(bodies_move_smoothly_between_steps_of_physics),
        cmocka_unit_test(fast_wheels_turn_as_often_as_their_velocity_says),
        cmocka_unit_test(offsets_and_blends_are_rounded_once),
        cmocka_unit_test(rotations_from_rest_to_rest_keep_to_the_quintic),
    };
    return cmocka_run_group_tests_name("inertia", tests, NULL, NULL);
}
