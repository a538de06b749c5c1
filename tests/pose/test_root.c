/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/page.h"

static nkw_vec3 vec(float x, float y, float z)
{
    nkw_vec3 v = {x, y, z};
    return v;
}

static nkw_trs place(nkw_vec3 translation, nkw_quat rotation)
{
    nkw_trs t = {translation, rotation, {1, 1, 1}};
    return t;
}

static nkw_quat yaw(float angle)
{
    return nkw_quat_from_axis_angle(vec(0, 1, 0), angle);
}

static nkw_trs random_place(random_source *r)
{
    return place(random_vec3(r, -3, 3), random_rotation(r));
}

static nkw_trs inverse(nkw_trs t)
{
    nkw_quat q = nkw_quat_conjugate(t.rotation);
    return place(nkw_quat_rotate(q, nkw_vec3_scale(t.translation, -1)), q);
}

static nkw_trs mul(nkw_trs a, nkw_trs b)
{
    return nkw_trs_mul(&a, &b);
}

static void expect_place(nkw_trs got, nkw_trs want, double bound)
{
    expect_vec3_near(got.translation, want.translation, bound);
    expect_rotation_near(got.rotation, want.rotation, bound);
}

static const unsigned all_parts[] = {0,
                                     NKW_ROOT_PLANE,
                                     NKW_ROOT_HEIGHT,
                                     NKW_ROOT_YAW,
                                     NKW_ROOT_PLANE | NKW_ROOT_YAW,
                                     NKW_ROOT_PLANE | NKW_ROOT_HEIGHT | NKW_ROOT_YAW,
                                     NKW_ROOT_ROTATION,
                                     NKW_ROOT_PLANE | NKW_ROOT_HEIGHT | NKW_ROOT_ROTATION};

static void motion_and_rest_make_the_root(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 5000; i++) {
        nkw_trs root = random_place(&r);
        root.scale = random_vec3(&r, 0.5f, 2);
        nkw_root_rule rule = {random_direction(&r), all_parts[i % 8]};
        nkw_root_motion parts = nkw_root_split(&rule, &root);
        nkw_trs motion = parts.motion, rest = parts.rest;
        nkw_trs got = mul(motion, rest);
        expect_place(got, root, 2e-6);
        expect_vec3_bits(rest.scale, root.scale);
        expect_vec3_bits(motion.scale, vec(1, 1, 1));
    }
}

static void each_part_moves_what_it_says(void **state)
{
    (void)state;
    nkw_quat tilt = nkw_quat_from_axis_angle(vec(1, 0, 0), 0.3f);
    nkw_trs root = place(vec(1, 2, 3), nkw_quat_mul(yaw(0.7f), tilt));
    nkw_root_rule plane = {vec(0, 5, 0), NKW_ROOT_PLANE}, height = {vec(0, 1, 0), NKW_ROOT_HEIGHT},
                  turn = {vec(0, 1, 0), NKW_ROOT_YAW}, none = {vec(0, 1, 0), 0}, z = {vec(0, 0, 2), NKW_ROOT_PLANE},
                  whole = {vec(0, 1, 0), NKW_ROOT_PLANE | NKW_ROOT_HEIGHT | NKW_ROOT_ROTATION};
    expect_vec3_bits(nkw_root_split(&plane, &root).motion.translation, vec(1, 0, 3));
    expect_quat_bits(nkw_root_split(&plane, &root).motion.rotation, nkw_quat_identity());
    expect_vec3_bits(nkw_root_split(&height, &root).motion.translation, vec(0, 2, 0));
    expect_vec3_bits(nkw_root_split(&z, &root).motion.translation, vec(1, 2, 0));
    expect_vec3_bits(nkw_root_split(&none, &root).motion.translation, vec(0, 0, 0));
    expect_quat_near(nkw_root_split(&turn, &root).motion.rotation, yaw(0.7f), 1e-7);
    expect_place(nkw_root_split(&whole, &root).motion, root, 1e-7);
    expect_place(nkw_root_split(&whole, &root).rest, nkw_trs_identity(), 2e-7);
    expect_quat_near(nkw_root_split(&turn, &root).rest.rotation, tilt, 2e-7);
}

static void odd_rules_have_an_answer(void **state)
{
    (void)state;
    nkw_trs root = place(vec(1, 2, 3), nkw_quat_identity());
    const nkw_vec3 ups[] = {vec(0, 0, 0), vec(NAN, 0, 0), vec(INFINITY, 1, 0)};
    for (int i = 0; i < 3; i++) {
        nkw_root_rule rule = {ups[i], 0xfffffff1u};
        expect_vec3_bits(nkw_root_split(&rule, &root).motion.translation, vec(1, 0, 3));
    }
    nkw_root_rule turn = {vec(0, 1, 0), NKW_ROOT_YAW};
    nkw_trs fallen = place(vec(0, 0, 0), nkw_quat_from_axis_angle(vec(1, 0, 0), 3.14159274f));
    expect_rotation_near(nkw_root_split(&turn, &fallen).motion.rotation, nkw_quat_identity(), 1e-6);
    nkw_trs motion = root;
    nkw_root_split_keys(&turn, NULL, NULL, NULL, 3);
    nkw_root_split_keys(&turn, NULL, NULL, &motion, 1);
    expect_place(motion, nkw_trs_identity(), 0);
}

static void keys_lose_their_motion(void **state)
{
    (void)state;
    random_source r = random_from(2);
    nkw_root_rule rule = {vec(0, 0, 1), NKW_ROOT_PLANE | NKW_ROOT_YAW};
    nkw_trs root = random_place(&r), motions[1];
    nkw_root_motion parts = nkw_root_split(&rule, &root);
    expect_place(mul(parts.motion, parts.rest), root, 2e-6);
    expect_bits(parts.rest.translation.x, 0);
    nkw_vec3 translation = root.translation;
    nkw_quat rotation = root.rotation;
    nkw_root_split_keys(&rule, &translation, &rotation, motions, 1);
    expect_vec3_bits(translation, parts.rest.translation);
    expect_quat_bits(rotation, parts.rest.rotation);
    expect_vec3_bits(motions[0].translation, parts.motion.translation);
}

/* The motion of a clip: an arc in the plane. */
static nkw_trs walk(float t)
{
    return place(vec(nkw_sin(t), 0.2f * t, 2 * t), yaw(0.6f * t));
}

static void steps_within_a_clip_are_the_difference_of_its_motions(void **state)
{
    (void)state;
    nkw_root_cycle cycle = {walk(0.5f), walk(1.5f)};
    nkw_trs a = walk(0.7f), b = walk(1.2f), delta = nkw_root_delta(&cycle, &a, &b, 0);
    expect_place(mul(a, delta), b, 1e-6);
    expect_place(nkw_root_delta(&cycle, &a, &a, 0), nkw_trs_identity(), 1e-6);
    nkw_trs back = nkw_root_delta(&cycle, &b, &a, 0);
    expect_place(mul(delta, back), nkw_trs_identity(), 1e-6);
}

static void a_loop_continues_where_the_clip_ends(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 2000; i++) {
        nkw_root_cycle cycle = {random_place(&r), random_place(&r)};
        nkw_trs from = random_place(&r), to = random_place(&r);
        /* from .. last, then first .. to. */
        nkw_trs rest = nkw_root_delta(&cycle, &from, &cycle.last, 0),
                next = nkw_root_delta(&cycle, &cycle.first, &to, 0);
        nkw_trs once = nkw_root_delta(&cycle, &from, &to, 1);
        expect_place(mul(rest, next), once, 1e-5);
        /* Backwards is the inverse. */
        expect_place(mul(once, nkw_root_delta(&cycle, &to, &from, -1)), nkw_trs_identity(), 1e-5);
    }
}

/* n loops in one call and n products, in binary64 outside. */
static void n_loops_in_one_step_equal_n_steps(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 300; i++) {
        nkw_root_cycle cycle = {random_place(&r), random_place(&r)};
        if (i % 3 == 0)
            cycle.last = mul(cycle.first, place(random_vec3(&r, -1, 1), yaw(i % 2 ? 0 : 1e-4f)));
        nkw_trs here = random_place(&r), sum = nkw_trs_identity();
        for (int n = 1; n <= 40; n++) {
            sum = mul(sum, nkw_root_delta(&cycle, &here, &here, 1));
            nkw_trs all = nkw_root_delta(&cycle, &here, &here, n);
            expect_place(all, sum, 2e-5 * n);
            expect_place(nkw_root_delta(&cycle, &here, &here, -n), inverse(sum), 2e-5 * n);
        }
    }
}

static void a_thousand_loops_do_not_drift(void **state)
{
    (void)state;
    /* An exact eighth of a turn and exact ways: after 1000 loops, 125 turns. */
    nkw_quat eighth = {0, (float)sin(3.14159265358979 / 8), 0, (float)cos(3.14159265358979 / 8)};
    nkw_root_cycle cycle = {nkw_trs_identity(), place(vec(1, 0.25f, 0), eighth)};
    nkw_trs origin = place(vec(5, 0, 5), yaw(1)), start = nkw_trs_identity(), summed = origin;
    double angle = 1000 * 2 * atan2((double)eighth.y, (double)eighth.w);
    nkw_trs there = nkw_root_place(&cycle, &origin, &start, 1000);
    for (int i = 0; i < 1000; i++)
        summed = mul(summed, nkw_root_delta(&cycle, &start, &start, 1));
    expect_near(there.translation.y, 250, 0);
    expect_rotation_near(there.rotation, yaw((float)fmod(1 + angle, 2 * 3.14159265358979)), 3e-7);
    /* One call has one rounding; a thousand products in binary32 are 3 mm off. */
    nkw_trs in_parts = origin;
    for (int i = 0; i < 10; i++) {
        in_parts = nkw_root_place(&cycle, &in_parts, &start, 100);
    }
    expect_place(in_parts, there, 5e-6);
    expect_place(summed, there, 2e-2);
    double off = (double)nkw_vec3_distance(summed.translation, there.translation);
    nkw_root_cycle by_axis = {nkw_trs_identity(), place(vec(1, 0.25f, 0), yaw(0.785398163f))};
    there = nkw_root_place(&by_axis, &origin, &start, 1000), summed = origin;
    for (int i = 0; i < 1000; i++)
        summed = mul(summed, nkw_root_delta(&by_axis, &start, &start, 1));
    expect_page("subjects/pose/root.md", "the sum is %.0f mm off, or %.0f mm with the quaternion of", 1000 * off,
                1000 * (double)nkw_vec3_distance(summed.translation, there.translation));
    for (int n = -1000000; n <= 1000000; n += 250000) {
        nkw_trs far = nkw_root_place(&cycle, &origin, &start, n);
        expect_near(far.translation.y, 0.25 * n, 0);
        expect_near(nkw_quat_length(far.rotation), 1, 2e-7);
        assert_true(fabsf(far.translation.x - 5) < 3 && fabsf(far.translation.z - 5) < 3);
    }
}

static void straight_clips_go_straight(void **state)
{
    (void)state;
    nkw_root_cycle cycle = {nkw_trs_identity(), place(vec(0.5f, 0, 2), nkw_quat_identity())};
    nkw_trs here = place(vec(0.25f, 0, 1), nkw_quat_identity());
    expect_vec3_bits(nkw_root_delta(&cycle, &here, &here, 1000).translation, vec(500, 0, 2000));
    expect_vec3_bits(nkw_root_delta(&cycle, &here, &here, -1e6).translation, vec(-5e5f, 0, -2e6f));
    expect_vec3_bits(nkw_root_delta(&cycle, &here, &here, 0.5).translation, vec(0.25f, 0, 1));
}

static void blends_are_weighted_means(void **state)
{
    (void)state;
    nkw_trs motions[3] = {place(vec(1, 0, 0), yaw(0.2f)), place(vec(3, 0, 4), yaw(0.8f)), place(vec(9, 9, 9), yaw(2))};
    const float weights[3] = {1, 3, -5}, none[3] = {0, NAN, -1};
    nkw_trs got = nkw_root_blend(motions, weights, 3);
    expect_place(got, place(vec(2.5f, 0, 3), yaw(0.65f)), 2e-7);
    expect_place(nkw_root_blend(motions, none, 3), nkw_trs_identity(), 0);
    expect_place(nkw_root_blend(NULL, NULL, 0), nkw_trs_identity(), 0);
    motions[1].rotation = nkw_quat_negate(motions[1].rotation);
    expect_place(nkw_root_blend(motions, weights, 2), got, 2e-7);
    expect_place(nkw_root_blend(motions, weights, 1), motions[0], 1e-7);
}

static void parts_of_a_loop_take_the_shorter_arc(void **state)
{
    (void)state;
    const float angle = 3.5f, short_way = angle - 6.28318531f;
    nkw_trs here = nkw_trs_identity(), loop = place(vec(1, 0, 0), yaw(angle)), sum = loop;
    nkw_root_cycle cycle = {nkw_trs_identity(), loop};
    for (int n = 1; n <= 3; n++, sum = mul(sum, loop))
        expect_place(nkw_root_delta(&cycle, &here, &here, n), sum, 2e-6);
    nkw_trs half = nkw_root_delta(&cycle, &here, &here, 0.5);
    expect_rotation_near(half.rotation, yaw(short_way / 2), 1e-6);
    expect_place(mul(half, half), loop, 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(motion_and_rest_make_the_root),
        cmocka_unit_test(each_part_moves_what_it_says),
        cmocka_unit_test(odd_rules_have_an_answer),
        cmocka_unit_test(keys_lose_their_motion),
        cmocka_unit_test(steps_within_a_clip_are_the_difference_of_its_motions),
        cmocka_unit_test(a_loop_continues_where_the_clip_ends),
        cmocka_unit_test(n_loops_in_one_step_equal_n_steps),
        cmocka_unit_test(a_thousand_loops_do_not_drift),
        cmocka_unit_test(straight_clips_go_straight),
        cmocka_unit_test(blends_are_weighted_means),
        cmocka_unit_test(parts_of_a_loop_take_the_shorter_arc),
    };
    return cmocka_run_group_tests_name("root", tests, NULL, NULL);
}
