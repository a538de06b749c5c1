/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/motions.h"
#include "views.h"

enum { JOINTS = 67, FLOATS = NKW_POSE_FLOATS(JOINTS), SPEEDS = NKW_POSE_VELOCITY_FLOATS(JOINTS) };

typedef struct scene {
    float from[FLOATS], to[FLOATS], out[FLOATS], from_velocity[SPEEDS], to_velocity[SPEEDS];
    float inertia[NKW_POSE_INERTIA_FLOATS(JOINTS)], dead[NKW_POSE_DEAD_BLEND_FLOATS(JOINTS)];
} scene;

static void draw_pose(random_source *r, float *pose)
{
    nkw_pose_identity(pose_span(pose, JOINTS));
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_trs trs = {random_vec3(r, -2, 2), random_rotation(r), random_vec3(r, 0.5f, 2)};
        nkw_pose_set(pose_span(pose, JOINTS), j, &trs);
    }
}

static void draw(scene *s)
{
    random_source r = random_from(1);
    draw_pose(&r, s->from);
    draw_pose(&r, s->to);
    for (size_t i = 0; i < SPEEDS; i++) {
        s->from_velocity[i] = random_between(&r, -2, 2);
        s->to_velocity[i] = random_between(&r, -2, 2);
    }
}

static nkw_pose_state motion_of(const float *pose, const float *velocity)
{
    nkw_pose_state m = {pose_view(pose, JOINTS), {velocity, JOINTS}};
    return m;
}

static nkw_vec3 speed(const float *velocity, size_t row, size_t j)
{
    const float *x = velocity + row * NKW_POSE_STRIDE(JOINTS) + j;
    nkw_vec3 v = {x[0], x[NKW_POSE_STRIDE(JOINTS)], x[2 * NKW_POSE_STRIDE(JOINTS)]};
    return v;
}

static nkw_trs joint(const float *pose, size_t j)
{
    return nkw_pose_get(pose_view(pose, JOINTS), j);
}

static void expect_trs_bits(nkw_trs got, nkw_trs want)
{
    expect_vec3_bits(got.translation, want.translation);
    expect_quat_bits(got.rotation, want.rotation);
    expect_vec3_bits(got.scale, want.scale);
}

static void each_joint_is_inertialised_as_its_values_are(void **state)
{
    (void)state;
    static scene s;
    draw(&s);
    nkw_pose_state from = motion_of(s.from, s.from_velocity), to = motion_of(s.to, s.to_velocity);
    nkw_pose_inertia inertia = {s.inertia, JOINTS};
    assert_int_equal(nkw_pose_inertia_begin(inertia, &from, &to, 0.5f), NKW_OK);
    for (int i = 0; i < 12; i++) {
        float t = 0.05f * (float)i;
        assert_int_equal(nkw_pose_inertia_evaluate(inertia, to.pose, t, pose_span(s.out, JOINTS)), NKW_OK);
        for (size_t j = 0; j < JOINTS; j++) {
            nkw_trs a = joint(s.from, j), b = joint(s.to, j);
            nkw_vec3_state p = {a.translation, speed(s.from_velocity, 0, j)},
                            q = {b.translation, speed(s.to_velocity, 0, j)},
                            u = {a.scale, speed(s.from_velocity, 6, j)}, v = {b.scale, speed(s.to_velocity, 6, j)};
            nkw_quat_state g = {a.rotation, speed(s.from_velocity, 3, j)},
                            h = {b.rotation, speed(s.to_velocity, 3, j)};
            nkw_vec3_offset translation = inertia_of_vec3(&p, &q, 0.5f), scale = inertia_of_vec3(&u, &v, 0.5f);
            nkw_quat_offset rotation = inertia_of_quat(&g, &h, 0.5f);
            nkw_trs want = {nkw_vec3_offset_evaluate(&translation, &q, t).value,
                            nkw_quat_offset_evaluate(&rotation, &h, t).value,
                            nkw_vec3_offset_evaluate(&scale, &v, t).value};
            expect_trs_bits(joint(s.out, j), want);
        }
    }
}

static void each_joint_is_dead_blended_as_its_values_are(void **state)
{
    (void)state;
    static scene s;
    draw(&s);
    nkw_pose_state from = motion_of(s.from, s.from_velocity);
    nkw_pose_dead_blend dead = {s.dead, JOINTS, 0.2f, 0.5f};
    nkw_quat_offset quats[JOINTS];
    assert_int_equal(nkw_pose_dead_blend_begin(&dead, &from), NKW_OK);
    for (size_t j = 0; j < JOINTS; j++)
        quats[j] = dead_of_quat(rotating(joint(s.from, j).rotation, speed(s.from_velocity, 3, j)), 0.2f, 0.5f);
    for (int i = 0; i < 12; i++) {
        float t = 0.05f * (float)i;
        assert_int_equal(nkw_pose_dead_blend_evaluate(&dead, pose_view(s.to, JOINTS), t, pose_span(s.out, JOINTS)),
                         NKW_OK);
        for (size_t j = 0; j < JOINTS; j++) {
            nkw_trs a = joint(s.from, j), b = joint(s.to, j);
            nkw_vec3_offset p = dead_of_vec3(moving(a.translation, speed(s.from_velocity, 0, j)), 0.2f, 0.5f),
                            u = dead_of_vec3(moving(a.scale, speed(s.from_velocity, 6, j)), 0.2f, 0.5f);
            nkw_vec3_state q = {b.translation, {0, 0, 0}}, v = {b.scale, {0, 0, 0}};
            nkw_quat_state h = {b.rotation, {0, 0, 0}};
            nkw_trs want = {nkw_vec3_offset_evaluate(&p, &q, t).value,
                            nkw_quat_offset_evaluate(&quats[j], &h, t).value,
                            nkw_vec3_offset_evaluate(&u, &v, t).value};
            expect_trs_bits(joint(s.out, j), want);
        }
    }
}

static void velocities_are_those_between_two_poses(void **state)
{
    (void)state;
    static scene s;
    draw(&s);
    nkw_pose_velocity_span v = {s.from_velocity, JOINTS};
    assert_int_equal(nkw_pose_velocity_from_poses(pose_view(s.from, JOINTS), pose_view(s.to, JOINTS), 0.25f, v),
                     NKW_OK);
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_trs a = joint(s.from, j), b = joint(s.to, j);
        expect_vec3_bits(speed(v.data, 3, j), nkw_quat_angular_velocity(a.rotation, b.rotation, 0.25f));
        expect_vec3_near(speed(v.data, 0, j), nkw_vec3_scale(nkw_vec3_sub(b.translation, a.translation), 4), 2e-6);
        expect_vec3_near(speed(v.data, 6, j), nkw_vec3_scale(nkw_vec3_sub(b.scale, a.scale), 4), 2e-6);
    }
    const float none[] = {0, -0.0f, NAN};
    for (int i = 0; i < 3; i++) {
        nkw_pose_velocity_from_poses(pose_view(s.from, JOINTS), pose_view(s.to, JOINTS), none[i], v);
        for (size_t k = 0; k < SPEEDS; k++)
            expect_bits(v.data[k], 0);
    }
}

/* Two clips of every joint rotating; the transition is begun in the middle, and a second one within the first. */
static void poses_move_without_a_jump(void **state)
{
    (void)state;
    static scene s;
    static float last[FLOATS], before[FLOATS];
    draw(&s);
    const float h = 1 / 240.0f;
    nkw_pose_inertia inertia = {s.inertia, JOINTS};
    nkw_pose_dead_blend dead = {s.dead, JOINTS, 0.1f, 0.3f};
    for (int kind = 0; kind < 2; kind++) {
        memcpy(before, s.from, sizeof before);
        for (size_t j = 0; j < JOINTS; j++) {
            nkw_trs a = joint(s.from, j);
            nkw_vec3 w = {0, 1, 0};
            a.rotation = nkw_quat_integrate(a.rotation, w, h);
            a.translation.x += 1 * h;
            nkw_pose_set(pose_span(last, JOINTS), j, &a);
        }
        nkw_pose_velocity_span v = {s.from_velocity, JOINTS};
        nkw_pose_velocity_from_poses(pose_view(before, JOINTS), pose_view(last, JOINTS), h, v);
        nkw_pose_state from = motion_of(last, s.from_velocity), to = motion_of(s.to, NULL);
        assert_int_equal(nkw_pose_inertia_begin(inertia, &from, &to, 0.3f), NKW_OK);
        assert_int_equal(nkw_pose_dead_blend_begin(&dead, &from), NKW_OK);
        for (int i = 0; i <= 80; i++) {
            if (kind)
                nkw_pose_dead_blend_evaluate(&dead, to.pose, h * (float)i, pose_span(s.out, JOINTS));
            else
                nkw_pose_inertia_evaluate(inertia, to.pose, h * (float)i, pose_span(s.out, JOINTS));
            for (size_t j = 0; j < JOINTS; j++) {
                assert_true(nkw_quat_angle(joint(last, j).rotation, joint(s.out, j).rotation) < 30 * h);
                assert_true(nkw_vec3_distance(joint(last, j).translation, joint(s.out, j).translation) < 60 * h);
            }
            memcpy(last, s.out, sizeof last);
        }
        for (size_t j = 0; j < JOINTS; j++)
            expect_trs_bits(joint(s.out, j), joint(s.to, j));
    }
}

static void output_may_be_the_input_and_padding_has_no_effect(void **state)
{
    (void)state;
    static scene s;
    static float in_place[FLOATS];
    draw(&s);
    nkw_pose_state from = motion_of(s.from, NULL), to = motion_of(s.to, NULL);
    nkw_pose_inertia inertia = {s.inertia, JOINTS};
    nkw_pose_inertia_begin(inertia, &from, &to, 0.5f);
    nkw_pose_inertia_evaluate(inertia, to.pose, 0.2f, pose_span(s.out, JOINTS));
    memcpy(in_place, s.to, sizeof in_place);
    for (size_t c = 0; c < 10; c++)
        for (size_t j = JOINTS; j < NKW_POSE_STRIDE(JOINTS); j++)
            in_place[c * NKW_POSE_STRIDE(JOINTS) + j] = NAN;
    nkw_pose_inertia_evaluate(inertia, pose_view(in_place, JOINTS), 0.2f, pose_span(in_place, JOINTS));
    for (size_t j = 0; j < JOINTS; j++)
        expect_trs_bits(joint(in_place, j), joint(s.out, j));
}

/* Floats at the end of an array of exactly the size of a pose, a state: 16 joints have no padding before them. */
static void evaluating_writes_the_pose_and_the_state_alone(void **state)
{
    (void)state;
    enum { GUARD = 16 };
    const float word = -0x1.5a5a5ap119f;
    static scene s;
    static float out[FLOATS + GUARD], in_place[FLOATS], dead_data[NKW_POSE_DEAD_BLEND_FLOATS(JOINTS) + GUARD],
        inertia_data[NKW_POSE_INERTIA_FLOATS(JOINTS) + GUARD];
    draw(&s);
    for (size_t joints = 1; joints <= JOINTS; joints++) {
        float *ends[3] = {out + NKW_POSE_FLOATS(joints), dead_data + NKW_POSE_DEAD_BLEND_FLOATS(joints),
                          inertia_data + NKW_POSE_INERTIA_FLOATS(joints)};
        for (size_t k = 0; k < 3 * GUARD; k++)
            ends[k / GUARD][k % GUARD] = word;
        const nkw_pose_state from = {pose_view(s.from, joints), {NULL, 0}}, to = {pose_view(s.to, joints), {NULL, 0}};
        const nkw_pose_inertia inertia = {inertia_data, joints};
        const nkw_pose_dead_blend dead = {dead_data, joints, 0.2f, 0.5f};
        assert_int_equal(nkw_pose_inertia_begin(inertia, &from, &to, 0.5f), NKW_OK);
        assert_int_equal(nkw_pose_dead_blend_begin(&dead, &from), NKW_OK);
        assert_int_equal(nkw_pose_inertia_evaluate(inertia, to.pose, 0.1f, pose_span(out, joints)), NKW_OK);
        memcpy(in_place, s.to, sizeof in_place);
        nkw_pose_inertia_evaluate(inertia, pose_view(in_place, joints), 0.1f, pose_span(in_place, joints));
        for (size_t j = 0; j < joints; j++)
            expect_trs_bits(nkw_pose_get(pose_view(in_place, joints), j), nkw_pose_get(pose_view(out, joints), j));
        for (size_t k = 0; k < 3 * GUARD; k++)
            expect_bits(ends[k / GUARD][k % GUARD], word);
        assert_int_equal(nkw_pose_dead_blend_evaluate(&dead, to.pose, 0.1f, pose_span(out, joints)), NKW_OK);
        for (size_t k = 0; k < 3 * GUARD; k++)
            expect_bits(ends[k / GUARD][k % GUARD], word);
    }
}

static void counts_that_differ_are_refused(void **state)
{
    (void)state;
    static scene s;
    draw(&s);
    nkw_pose_state from = motion_of(s.from, s.from_velocity), other = from, fast = from, none = {{NULL, 0}, {NULL, 0}};
    other.pose.joint_count = 3;
    fast.velocity.joint_count = 3;
    nkw_pose_inertia inertia = {s.inertia, JOINTS}, empty = {NULL, 0};
    nkw_pose_dead_blend dead = {s.dead, JOINTS, 1, 1}, no_dead = {NULL, 0, 1, 1};
    nkw_pose_velocity_span v = {s.from_velocity, JOINTS}, no_v = {NULL, 0};
    nkw_pose_view view = pose_view(s.from, JOINTS), few = pose_view(s.from, 3);
    assert_int_equal(nkw_pose_inertia_begin(inertia, &other, &from, 1), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_inertia_begin(inertia, &from, &fast, 1), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_inertia_evaluate(empty, view, 1, pose_span(s.out, JOINTS)), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_inertia_evaluate(inertia, few, 1, pose_span(s.out, JOINTS)), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_dead_blend_begin(&dead, &fast), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_dead_blend_evaluate(&dead, few, 1, pose_span(s.out, JOINTS)), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_velocity_from_poses(view, few, 1, v), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_velocity_from_poses(few, view, 1, v), NKW_MISMATCHED);
    dead.joint_count = 3;
    assert_int_equal(nkw_pose_dead_blend_evaluate(&dead, view, 1, pose_span(s.out, JOINTS)), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_inertia_begin(empty, &none, &none, 1), NKW_OK);
    assert_int_equal(nkw_pose_inertia_evaluate(empty, none.pose, 1, pose_span(NULL, 0)), NKW_OK);
    assert_int_equal(nkw_pose_dead_blend_begin(&no_dead, &none), NKW_OK);
    assert_int_equal(nkw_pose_dead_blend_evaluate(&no_dead, none.pose, 1, pose_span(NULL, 0)), NKW_OK);
    assert_int_equal(nkw_pose_velocity_from_poses(none.pose, none.pose, 1, no_v), NKW_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_joint_is_inertialised_as_its_values_are),
        cmocka_unit_test(each_joint_is_dead_blended_as_its_values_are),
        cmocka_unit_test(velocities_are_those_between_two_poses),
        cmocka_unit_test(poses_move_without_a_jump),
        cmocka_unit_test(output_may_be_the_input_and_padding_has_no_effect),
        cmocka_unit_test(counts_that_differ_are_refused),
        cmocka_unit_test(evaluating_writes_the_pose_and_the_state_alone),
    };
    return cmocka_run_group_tests_name("transition", tests, NULL, NULL);
}
