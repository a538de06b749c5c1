/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

static const nkw_foot_rules rules = NKW_FOOT_RULES;

static nkw_vec3 vec(float x, float y, float z)
{
    nkw_vec3 r = {x, y, z};
    return r;
}

/* Whether a foot is in contact after an update at this height and speed, and was before. */
static int foot_contact(int contact, float height, float speed)
{
    nkw_foot foot = {.started = 1, .contact = contact};
    nkw_foot_rules near_by = rules;
    near_by.release_distance = 0;
    foot.animated.x = -speed;
    foot.animated.y = height;
    nkw_foot_update(&foot, &near_by, vec(0, height, 0), 0, 1);
    return foot.contact;
}

static void contact_has_hysteresis(void **state)
{
    (void)state;
    assert_int_equal(foot_contact(0, 0.05f, 0.3f), 1);
    assert_int_equal(foot_contact(0, 0.051f, 0.3f), 0);
    assert_int_equal(foot_contact(0, 0.05f, 0.31f), 0);
    assert_int_equal(foot_contact(1, 0.1f, 1.0f), 1);
    assert_int_equal(foot_contact(1, 0.11f, 0.0f), 0);
    assert_int_equal(foot_contact(1, 0.0f, 1.01f), 0);
    /* Noise between the thresholds changes nothing. */
    random_source r = random_from(1);
    for (int contact = 0; contact < 2; contact++)
        for (int i = 0; i < 1000; i++)
            assert_int_equal(
                foot_contact(contact, random_between(&r, 0.051f, 0.099f), random_between(&r, 0.31f, 0.99f)), contact);
}

/* A walk on the spot of 1 s a step: the foot stands, sliding by 4 cm, then swings 0.6 m ahead and 0.2 m up. */
static nkw_vec3 walk(float time)
{
    float step = (float)(int)time, t = time - step, swing = nkw_smoothstep(nkw_clamp((t - 0.5f) * 2, 0.0f, 1.0f));
    float sine = t > 0.5f ? nkw_sin(3.14159274f * (2 * t - 1)) : 0.0f, up = 0.2f * sine * sine;
    return vec(0.56f * step + 0.6f * swing - 0.08f * nkw_min(t, 0.5f), up, 0);
}

static void a_standing_foot_does_not_slide(void **state)
{
    (void)state;
    nkw_foot foot = {0};
    int contacts = 0, changes = 0;
    for (int i = 0; i < 480; i++) {
        nkw_vec3 before = foot.position;
        int was = foot.contact, rested = was && foot.time > rules.duration;
        nkw_vec3 p = nkw_foot_update(&foot, &rules, walk((float)i / 120), 0, 1.0f / 120);
        contacts += foot.contact;
        changes += i > 0 && foot.contact != was;
        if (foot.contact && foot.time > rules.duration) {
            expect_vec3_near(p, foot.locked, 0);
            if (rested)
                expect_vec3_bits(p, before);
        }
    }
    assert_true(contacts > 4 * 50 && contacts < 4 * 75);
    assert_in_range(changes, 6, 9);
}

/* Neither position nor velocity jumps: the change of the velocity is bounded, at both transitions. */
static void transitions_are_smooth(void **state)
{
    (void)state;
    nkw_foot foot = {0};
    const float dt = 1.0f / 480;
    nkw_vec3 last = {0, 0, 0}, velocity = {0, 0, 0};
    for (int i = 0; i < 4 * 480; i++) {
        nkw_vec3 p = nkw_foot_update(&foot, &rules, walk((float)i * dt), 0, dt);
        nkw_vec3 v = nkw_vec3_scale(nkw_vec3_sub(p, last), 1 / dt);
        if (i > 1)
            assert_true(nkw_vec3_distance(v, velocity) < 0.4f);
        velocity = v;
        last = p;
    }
}

static void a_released_foot_returns_to_the_animation(void **state)
{
    (void)state;
    nkw_foot foot = {0};
    const float dt = 0.01f;
    int i = 0;
    for (; i < 40; i++)
        nkw_foot_update(&foot, &rules, walk((float)i * dt), 0, dt);
    assert_int_equal(foot.contact, 1);
    for (; i < 85; i++)
        nkw_foot_update(&foot, &rules, walk((float)i * dt), 0, dt);
    assert_int_equal(foot.contact, 0);
    expect_vec3_near(foot.position, walk((float)(i - 1) * dt), 0);
}

static void a_lock_ends_far_from_the_animation(void **state)
{
    (void)state;
    nkw_foot foot = {0};
    nkw_foot_rules free = rules;
    free.release_distance = 0;
    nkw_foot other = {0};
    int released = 0;
    for (int i = 0; i < 200; i++) {
        nkw_vec3 p = vec(0.0025f * (float)i, 0, 0);
        nkw_foot_update(&foot, &rules, p, 0, 0.01f);
        nkw_foot_update(&other, &free, p, 0, 0.01f);
        released += !foot.contact;
        assert_true(nkw_vec3_distance(foot.locked, p) < 0.21f || !foot.contact);
    }
    assert_true(released >= 2);
    assert_int_equal(other.contact, 1);
    expect_bits(other.position.x, 0);
}

static void heights_are_along_up_and_above_the_ground(void **state)
{
    (void)state;
    nkw_foot_rules z_up = rules, no_up = rules;
    z_up.up = vec(0, 0, 2);
    no_up.up = vec(0, 0, 0);
    for (int k = 0; k < 3; k++) {
        const nkw_foot_rules *used = k == 0 ? &rules : k == 1 ? &z_up : &no_up;
        nkw_vec3 low = k == 1 ? vec(9, 9, 5.02f) : vec(9, 5.02f, 9);
        nkw_foot foot = {0};
        nkw_foot_update(&foot, used, low, 5, 0.01f);
        assert_int_equal(foot.contact, 1);
        nkw_foot_update(&foot, used, low, 5, 0.01f);
        assert_int_equal(foot.contact, 1);
        nkw_foot_update(&foot, used, low, 4.9f, 0.01f);
        assert_int_equal(foot.contact, 0);
    }
}

static void no_time_and_no_numbers_change_nothing(void **state)
{
    (void)state;
    nkw_foot foot = {0}, before;
    expect_vec3_bits(nkw_foot_update(&foot, &rules, vec(1, 0, 2), 0, NAN), vec(0, 0, 0));
    expect_vec3_bits(nkw_foot_update(&foot, &rules, vec(1, 0, 2), 0, 0), vec(1, 0, 2));
    nkw_foot_update(&foot, &rules, vec(1, 0, 2), 0, 0.01f);
    assert_int_equal(foot.contact, 1);
    before = foot;
    nkw_foot_update(&foot, &rules, vec(NAN, 0, 2), 0, 0.01f);
    nkw_foot_update(&foot, &rules, vec(1, 0, 2), INFINITY, 0.01f);
    nkw_foot_update(&foot, &rules, vec(1, 0, 2), 0, INFINITY);
    assert_memory_equal(&foot, &before, sizeof foot);
    /* Time stands still or runs back: the contact stays. */
    nkw_foot_update(&foot, &rules, vec(1, 3, 2), 0, 0);
    nkw_foot_update(&foot, &rules, vec(1, 3, 2), 0, -1);
    assert_int_equal(foot.contact, 1);
    assert_true(foot.time == before.time);
    /* A duration that is none locks at once. */
    nkw_foot_rules sudden = rules;
    sudden.duration = 0;
    memset(&foot, 0, sizeof foot);
    nkw_foot_update(&foot, &sudden, vec(0, 0, 0), 0, 0.01f);
    nkw_foot_update(&foot, &sudden, vec(0.002f, 0, 0), 0, 0.01f);
    nkw_foot_update(&foot, &sudden, vec(0.004f, 0, 0), 0, 0.01f);
    expect_vec3_bits(foot.position, vec(0, 0, 0));
    nkw_foot_update(&foot, &sudden, vec(0.05f, 0, 0), 0, 0.01f);
    expect_vec3_bits(nkw_foot_update(&foot, &sudden, vec(0.07f, 0, 0), 0, 0.01f), vec(0.07f, 0, 0));
    expect_bits(foot.weight, 0);
}

/* Heights are along `up`, of any direction and length: the same walk in other axes has the same contacts. */
static void the_direction_of_heights_may_be_any(void **state)
{
    (void)state;
    const nkw_vec3 ups[4] = {{0, 0, 0}, {3, 0, 0}, {0, 0, -0.5f}, {0, -2, 0}};
    for (int k = 0; k < 4; k++) {
        nkw_foot foot = {0}, plain = {0};
        nkw_foot_rules turned = rules;
        int contacts = 0;
        turned.up = ups[k];
        for (int i = 0; i < 300; i++) {
            const nkw_vec3 p = walk((float)i / 60);
            const nkw_vec3 places[4] = {p, {p.y, p.z, p.x}, {p.x, p.z, -p.y}, {p.x, -p.y, p.z}};
            nkw_foot_update(&plain, &rules, p, 0, 1.0f / 60);
            nkw_foot_update(&foot, &turned, places[k], 0, 1.0f / 60);
            assert_int_equal(foot.contact, plain.contact);
            contacts += foot.contact;
        }
        assert_true(contacts > 50 && contacts < 250);
    }
}

/* A foot that stands from the first frame on is locked there; one that moves is not seen to have been locked. */
static void a_contact_may_begin_in_the_first_frame(void **state)
{
    (void)state;
    nkw_foot foot = {0};
    for (int i = 0; i < 8; i++) {
        nkw_vec3 p = nkw_foot_update(&foot, &rules, vec(0.002f * (float)i, 0, 0), 0, i ? 1 / 30.0f : 0);
        assert_int_equal(foot.contact, 1);
        expect_vec3_bits(p, vec(0, 0, 0));
        expect_bits(foot.weight, 1);
    }
    for (int high = 0; high < 2; high++) {
        /* Between the speeds of entering and leaving, and above the height of entering. */
        memset(&foot, 0, sizeof foot);
        float y = high ? 0.06f : 0.01f;
        for (int i = 0; i < 4; i++) {
            nkw_vec3 at = vec(0.5f * (float)i / 30, y, 0);
            expect_vec3_bits(nkw_foot_update(&foot, &rules, at, 0, 1 / 30.0f), at);
            assert_int_equal(foot.contact, i == 0 && !high);
            expect_bits(foot.weight, (float)(i == 0 && !high));
        }
    }
    /* No time passes: nothing is confirmed, and nothing denied. */
    memset(&foot, 0, sizeof foot);
    for (int i = 0; i < 3; i++)
        nkw_foot_update(&foot, &rules, vec(0, 0, 0), 0, 0);
    assert_true(foot.contact && foot.is_assumed);
    nkw_foot_update(&foot, &rules, vec(0.02f, 0, 0), 0, 0.01f);
    assert_int_equal(foot.contact, 0);
}

/* In contact 1, else 0, except in transitions; and with weight 0 the position is that of the animation. */
static void the_weight_is_that_of_the_lock(void **state)
{
    (void)state;
    nkw_foot foot = {0};
    const float dt = 1.0f / 240;
    float last = 1, most = 0;
    int whole = 0, none = 0;
    for (int i = 0; i < 4 * 240; i++) {
        nkw_vec3 a = walk((float)i * dt), p = nkw_foot_update(&foot, &rules, a, 0, dt);
        assert_true(foot.weight >= 0 && foot.weight <= 1);
        most = nkw_max(most, nkw_abs(foot.weight - last));
        last = foot.weight;
        if (foot.contact && foot.time > rules.duration + dt)
            expect_bits(foot.weight, 1);
        if (!foot.contact && foot.released > rules.duration + dt)
            expect_bits(foot.weight, 0);
        if (foot.weight == 0)
            expect_vec3_bits(p, a);
        whole += foot.weight == 1;
        none += foot.weight == 0;
    }
    assert_true(most < 1.6f * dt / rules.duration);
    assert_true(whole > 200 && none > 200);
}

/* The result is the same as of contacts that were found, if they are given; and it follows any others. */
static void contacts_may_be_given(void **state)
{
    (void)state;
    nkw_foot found = {0}, given = {0};
    for (int i = 0; i < 600; i++) {
        nkw_vec3 at = walk((float)i / 120);
        nkw_vec3 p = nkw_foot_update(&found, &rules, at, 0, 1.0f / 120);
        nkw_vec3 q = nkw_foot_update_given(&given, &rules, at, found.contact, 1.0f / 120);
        expect_vec3_bits(p, q);
        expect_bits(found.weight, given.weight);
    }
    /* High above the ground, fast, and far from the lock; a foot that stands is let go. */
    memset(&given, 0, sizeof given);
    for (int i = 0; i < 100; i++) {
        nkw_foot_update_given(&given, &rules, vec(0.1f * (float)i, 9, 0), i < 60 ? 3 : 0, 0.01f);
        assert_int_equal(given.contact, i < 60);
        if (i < 60)
            expect_vec3_bits(given.position, vec(0, 9, 0));
    }
    expect_vec3_near(given.position, vec(0.1f * 99, 9, 0), 0);
    expect_bits(given.weight, 0);
    nkw_foot before = given;
    nkw_foot_update_given(&given, &rules, vec(NAN, 0, 0), 1, 0.01f);
    nkw_foot_update_given(&given, &rules, vec(0, 0, 0), 1, NAN);
    assert_memory_equal(&given, &before, sizeof given);
    nkw_foot_update_given(&given, &rules, vec(9.9f, 9, 0), 1, 0);
    assert_int_equal(given.contact, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contact_has_hysteresis),
        cmocka_unit_test(a_standing_foot_does_not_slide),
        cmocka_unit_test(transitions_are_smooth),
        cmocka_unit_test(a_released_foot_returns_to_the_animation),
        cmocka_unit_test(a_lock_ends_far_from_the_animation),
        cmocka_unit_test(heights_are_along_up_and_above_the_ground),
        cmocka_unit_test(no_time_and_no_numbers_change_nothing),
        cmocka_unit_test(the_direction_of_heights_may_be_any),
        cmocka_unit_test(a_contact_may_begin_in_the_first_frame),
        cmocka_unit_test(the_weight_is_that_of_the_lock),
        cmocka_unit_test(contacts_may_be_given),
    };
    return cmocka_run_group_tests_name("foot", tests, NULL, NULL);
}
