/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

#define PI 3.14159274f

static const nkw_quat identity = {0, 0, 0, 1};
static const nkw_vec3 none = {0, 0, 0};

static nkw_vec3 vec(float x, float y, float z)
{
    nkw_vec3 r = {x, y, z};
    return r;
}

/* ---- Two bones ---- */

/* A leg, the knee a little forward. */
static nkw_ik_two_bone leg_to(nkw_vec3 target)
{
    nkw_ik_two_bone leg = {{0, 1, 0}, {0, 0.55f, 0.1f}, {0, 0.1f, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0, 1};
    leg.target = target;
    return leg;
}

static float length_of(const nkw_ik_two_bone *leg)
{
    return nkw_vec3_distance(leg->root, leg->mid) + nkw_vec3_distance(leg->mid, leg->end);
}

/* Applies the rotations to the positions. */
static nkw_vec3 end_after(const nkw_ik_two_bone *leg, const nkw_ik_two_bone_solution *s, nkw_vec3 *mid)
{
    nkw_vec3 u = nkw_vec3_sub(leg->mid, leg->root), v = nkw_vec3_sub(leg->end, leg->mid);
    nkw_vec3 end = nkw_vec3_add(u, nkw_quat_rotate(s->mid, v));
    *mid = nkw_vec3_add(leg->root, nkw_quat_rotate(s->root, u));
    return nkw_vec3_add(leg->root, nkw_quat_rotate(s->root, end));
}

static void expect_consistent(const nkw_ik_two_bone *leg, const nkw_ik_two_bone_solution *s)
{
    nkw_vec3 mid, end = end_after(leg, s, &mid);
    double bound = 2e-6 * (double)(length_of(leg) + nkw_vec3_length(leg->root));
    expect_vec3_near(s->end_position, end, bound);
    expect_vec3_near(s->mid_position, mid, bound);
    expect_near(s->error, nkw_vec3_distance(end, leg->target), bound + 1e-6 * (double)nkw_vec3_length(leg->target));
    expect_near(nkw_quat_length(s->root), 1.0, 3e-7);
    expect_near(nkw_quat_length(s->mid), 1.0, 3e-7);
}

static nkw_ik_two_bone draw_limb(random_source *r)
{
    nkw_ik_two_bone leg = leg_to(random_vec3(r, -2, 2));
    leg.root = random_vec3(r, -1, 1);
    leg.mid = nkw_vec3_add_scaled(leg.root, random_direction(r), random_between(r, 0.05f, 1));
    leg.end = nkw_vec3_add_scaled(leg.mid, random_direction(r), random_between(r, 0.05f, 1));
    leg.pole = random_bits(r) % 3 ? random_direction(r) : none;
    return leg;
}

static void targets_within_reach_are_reached(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 30000; i++) {
        nkw_ik_two_bone leg = draw_limb(&r);
        float a = nkw_vec3_distance(leg.root, leg.mid), b = nkw_vec3_distance(leg.mid, leg.end);
        float reach = random_between(&r, nkw_abs(a - b), a + b);
        leg.target = nkw_vec3_add_scaled(leg.root, random_direction(&r), reach);
        nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
        expect_consistent(&leg, &s);
        expect_near(s.error, 0, 1e-6);
    }
}

static void targets_out_of_reach_leave_the_rest(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 20000; i++) {
        nkw_ik_two_bone leg = draw_limb(&r);
        double d = (double)nkw_vec3_distance(leg.root, leg.target), length = (double)length_of(&leg);
        double least = fabs((double)(nkw_vec3_distance(leg.root, leg.mid) - nkw_vec3_distance(leg.mid, leg.end)));
        nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
        expect_consistent(&leg, &s);
        expect_near(s.error, d > length ? d - length : d < least ? least - d : 0, 2e-6);
    }
}

/* A bone that is lost in the roundings of the other one: the rotations remain unit. */
static void bones_of_any_lengths_have_unit_rotations(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (int i = 0; i < 20000; i++) {
        nkw_ik_two_bone leg = draw_limb(&r);
        const float size = exp2f(random_between(&r, -60, 60));
        leg.mid = nkw_vec3_add_scaled(leg.root, random_direction(&r), size);
        leg.end = nkw_vec3_add(leg.mid, random_direction(&r));
        leg.target = i % 2 ? leg.root : leg.target;
        const nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
        expect_near(nkw_quat_length(s.root), 1, 2e-7);
        expect_near(nkw_quat_length(s.mid), 1, 2e-7);
        assert_true(s.error >= 0.0f);
    }
}

static void the_pole_chooses_the_side_of_the_knee(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 20000; i++) {
        nkw_ik_two_bone leg = draw_limb(&r);
        leg.pole = random_direction(&r);
        nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
        nkw_vec3 line = nkw_vec3_normalize(nkw_vec3_sub(leg.target, leg.root));
        nkw_vec3 knee = nkw_vec3_reject(nkw_vec3_sub(s.mid_position, leg.root), line);
        nkw_vec3 side = nkw_vec3_reject(leg.pole, line);
        if (nkw_vec3_length(knee) < 1e-2f || nkw_vec3_length(side) < 1e-2f)
            continue;
        expect_near(nkw_vec3_angle(knee, side), 0, 2e-4);
    }
}

/* The knee's rotation is about the normal of the leg's plane; without a pole the thigh takes the shortest arc. */
static void the_knee_is_a_hinge_and_twist_is_kept(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 20000; i++) {
        nkw_ik_two_bone leg = draw_limb(&r);
        leg.pole = none;
        nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
        nkw_vec3 u = nkw_vec3_sub(leg.mid, leg.root), v = nkw_vec3_sub(leg.end, leg.mid);
        nkw_vec3 normal = nkw_vec3_normalize(nkw_vec3_cross(u, v)), axis = vec(s.mid.x, s.mid.y, s.mid.z);
        if (nkw_vec3_length(nkw_vec3_cross(u, v)) < 1e-3f)
            continue;
        expect_near(nkw_vec3_length(nkw_vec3_cross(axis, normal)), 0, 1e-4);
        nkw_vec3 bent = nkw_vec3_add(u, nkw_quat_rotate(s.mid, v));
        if (nkw_vec3_length(bent) < 1e-2f)
            continue;
        nkw_vec3 turn = vec(s.root.x, s.root.y, s.root.z);
        expect_near(nkw_vec3_dot(turn, nkw_vec3_normalize(bent)), 0, 3e-5);
    }
}

static void a_limb_at_its_target_does_not_move(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 5000; i++) {
        nkw_ik_two_bone leg = draw_limb(&r);
        leg.target = leg.end;
        leg.pole = i % 2 ? none : nkw_vec3_sub(leg.mid, leg.root);
        nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
        expect_quat_near(s.mid, identity, 1e-6);
        expect_quat_near(s.root, identity, 1e-6);
        expect_near(s.error, 0, 4e-7);
    }
}

static void a_straight_leg_bends_about_its_hinge(void **state)
{
    (void)state;
    nkw_ik_two_bone leg = leg_to(vec(0, 0.3f, 0));
    leg.mid = vec(0, 0.5f, 0);
    leg.end = vec(0, 0, 0);
    leg.hinge = vec(-2, 0, 0);
    nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
    expect_consistent(&leg, &s);
    expect_near(s.error, 0, 2e-7);
    /* Forwards: a negative rotation about -x moves the shin back, so the knee is at +z. */
    expect_vec3_near(s.mid_position, vec(0, 0.65f, nkw_sqrt(0.25f - 0.35f * 0.35f)), 1e-6);
    leg.hinge = vec(2, 5, 0);
    s = nkw_ik_two_bone_solve(&leg);
    expect_vec3_near(s.mid_position, vec(0, 0.65f, -nkw_sqrt(0.25f - 0.35f * 0.35f)), 1e-6);
    /* Without a hinge to the pole; without both to some side. */
    leg.hinge = none;
    leg.pole = vec(1, 0, 0);
    s = nkw_ik_two_bone_solve(&leg);
    expect_vec3_near(s.mid_position, vec(nkw_sqrt(0.25f - 0.35f * 0.35f), 0.65f, 0), 1e-6);
    leg.pole = none;
    s = nkw_ik_two_bone_solve(&leg);
    expect_consistent(&leg, &s);
    expect_near(s.error, 0, 2e-7);
    /* A folded one unfolds. */
    leg.end = vec(0, 0.9f, 0);
    s = nkw_ik_two_bone_solve(&leg);
    expect_consistent(&leg, &s);
    expect_near(s.error, 0, 2e-7);
}

static void a_target_at_the_root_folds_the_limb(void **state)
{
    (void)state;
    nkw_ik_two_bone leg = leg_to(vec(0, 1, 0));
    nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
    expect_consistent(&leg, &s);
    expect_near(s.error, 0, 3e-7);
    leg.end = vec(0, 0.3f, 0.2f);
    leg.pole = vec(1, 0, 0);
    s = nkw_ik_two_bone_solve(&leg);
    expect_consistent(&leg, &s);
    expect_near(s.error, fabs((double)(nkw_vec3_distance(leg.root, leg.mid) - nkw_vec3_distance(leg.mid, leg.end))),
                3e-7);
}

static void bones_of_length_zero_are_answered(void **state)
{
    (void)state;
    nkw_ik_two_bone leg = leg_to(vec(0, 1, 3));
    leg.mid = leg.root;
    nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
    expect_consistent(&leg, &s);
    expect_vec3_near(s.end_position, vec(0, 1, 0.9f), 3e-7);
    leg = leg_to(vec(0, 1, 3));
    leg.end = leg.mid;
    s = nkw_ik_two_bone_solve(&leg);
    expect_consistent(&leg, &s);
    expect_near(s.error, 3.0 - (double)nkw_vec3_distance(leg.root, leg.mid), 3e-7);
    leg.mid = leg.end = leg.root;
    s = nkw_ik_two_bone_solve(&leg);
    expect_quat_bits(s.root, identity);
    expect_quat_bits(s.mid, identity);
    expect_bits(s.error, 3.0f);
    leg.target = leg.root;
    expect_bits(nkw_ik_two_bone_solve(&leg).error, 0.0f);
}

static void an_opposite_target_is_reached(void **state)
{
    (void)state;
    nkw_ik_two_bone leg = leg_to(vec(0, 1.9f, 0));
    nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
    expect_consistent(&leg, &s);
    expect_near(s.error, 0, 3e-7);
    /* A pole along the line to the target does not matter. */
    leg.pole = vec(0, 1, 0);
    nkw_ik_two_bone_solution same = nkw_ik_two_bone_solve(&leg);
    expect_quat_bits(same.root, s.root);
    /* A pole at the opposite side of the knee: half a turn about the line. */
    leg.target = vec(0, 0.3f, 0);
    leg.pole = vec(0, 0, -1);
    s = nkw_ik_two_bone_solve(&leg);
    assert_true(s.mid_position.z < -0.1f);
    expect_near(s.error, 0, 3e-7);
}

/* Opposite to rounding: the cross product of the directions is rounding too. */
static void a_limb_reaches_a_target_opposite_to_its_end(void **state)
{
    (void)state;
    random_source r = random_from(21);
    for (int i = 0; i < 20000; i++) {
        nkw_ik_two_bone leg = draw_limb(&r);
        leg.root = none;
        leg.pole = none;
        leg.mid = nkw_vec3_scale(random_direction(&r), random_between(&r, 0.05f, 1));
        leg.end = nkw_vec3_add_scaled(leg.mid, random_direction(&r), random_between(&r, 0.05f, 1));
        leg.target = nkw_vec3_negate(leg.end);
        nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
        expect_consistent(&leg, &s);
        expect_near(s.error, 0, 3e-7 * (double)length_of(&leg));
    }
}

static void soft_reach_is_smooth_and_never_complete(void **state)
{
    (void)state;
    nkw_ik_two_bone leg = {{0, 1, 0}, {0, 0.7f, 0.4f}, {0, 0.3f, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0.2f, 1};
    double length = (double)length_of(&leg), before = 0, step = 0;
    for (int i = 0; i <= 400; i++) {
        double d = length * (0.5 + 0.002 * i);
        leg.target = vec(0, (float)(1.0 - d), 0);
        nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
        double reach = (double)nkw_vec3_distance(s.end_position, leg.root), start = 0.8 * length;
        expect_near(reach, d <= start ? d : length - 0.2 * length * exp((start - d) / (0.2 * length)), 1e-6);
        assert_true(reach < length);
        if (i > 1) {
            assert_true(reach >= before);
            expect_near(reach - before, step, 0.002 * length * 0.02);
        }
        step = i ? reach - before : 0;
        before = reach;
    }
}

/* A limb whose end is beyond the soft start begins to slow down there: what it has reached stays reached. */
static void softness_leaves_a_reached_target(void **state)
{
    (void)state;
    random_source r = random_from(22);
    for (int i = 0; i < 20000; i++) {
        nkw_ik_two_bone leg = draw_limb(&r);
        leg.pole = none;
        leg.target = leg.end;
        leg.softness = random_between(&r, 0, 1);
        if (i % 2)
            leg.end = leg.target = nkw_vec3_add_scaled(leg.mid, nkw_vec3_sub(leg.mid, leg.root), 0.7f);
        nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
        expect_near(s.error, 0, 4e-7);
        expect_quat_near(s.root, identity, 1e-3);
        /* Nearer targets are reached, farther ones approached: the reach is continuous, grows, and stays below L. */
        nkw_vec3 to = nkw_vec3_sub(leg.end, leg.root);
        float is = nkw_vec3_length(to), length = length_of(&leg), before = is;
        if (is < 0.01f)
            continue;
        for (int k = 1; k <= 8; k++) {
            leg.target = nkw_vec3_add_scaled(leg.root, to, 1 + 0.1f * (float)k);
            float reach = nkw_vec3_distance(nkw_ik_two_bone_solve(&leg).end_position, leg.root);
            assert_true(reach >= before - 2e-6f && reach <= before + 0.1f * is + 2e-6f && reach <= length + 2e-6f);
            before = reach;
        }
    }
}

/* Within 1/4 rad of straight a hinge decides to which side a limb bends, and in which plane. */
static void a_hinge_is_heard_near_straight(void **state)
{
    (void)state;
    const nkw_vec3 hinge = {-1, 0, 0};
    float before = 0;
    for (int i = -23; i <= 23; i++) {
        /* The bend of the knee, forward or past straight. */
        float bend = 0.01f * (float)i, half = 0.5f * bend;
        nkw_ik_two_bone leg = {{0, 1, 0}, {0, 1 - 0.5f * nkw_cos(half), 0.5f * nkw_sin(half)},
                               {0, 0, 0}, {0, 0.2f, 0},
                               {0, 0, 0}, hinge,
                               0,         1};
        leg.end = vec(0, 1 - nkw_cos(half), 0);
        nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
        expect_consistent(&leg, &s);
        expect_vec3_near(s.mid_position, vec(0, 0.6f, 0.3f), 1e-6);
        expect_near(s.error, 0, 3e-7);
    }
    /* A bend to the side: the knee is in the plane across the hinge where it is straight, in its own from 1/4 on. */
    for (int i = 0; i <= 30; i++) {
        float half = 0.005f * (float)i;
        nkw_ik_two_bone leg = {{0, 1, 0}, {0.5f * nkw_sin(half), 1 - 0.5f * nkw_cos(half), 0},
                               {0, 0, 0}, {0, 0.2f, 0},
                               {0, 0, 0}, hinge,
                               0,         1};
        leg.end = vec(0, 1 - nkw_cos(half), 0);
        nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
        expect_consistent(&leg, &s);
        expect_near(s.error, 0, 3e-7);
        float turn = nkw_atan2(s.mid_position.x, s.mid_position.z);
        assert_true(turn >= before - 1e-4f && turn - before < 0.2f);
        before = turn;
        expect_near(nkw_vec3_length(nkw_vec3_sub(s.mid_position, vec(0, 0.6f, 0))), 0.3, 1e-6);
        if (i == 0)
            expect_near(turn, 0, 1e-6);
    }
    expect_near(before, 1.5707963, 1e-5);
    /* A knee that is bent by more keeps its side, whatever the hinge. */
    nkw_ik_two_bone leg = {{0, 1, 0}, {0, 0.5f, -0.1f}, {0, 0, 0}, {0, 0.2f, 0}, {0, 0, 0}, {-1, 0, 0}, 0, 1};
    assert_true(nkw_ik_two_bone_solve(&leg).mid_position.z < -0.2f);
}

static void weights_move_a_part(void **state)
{
    (void)state;
    nkw_ik_two_bone leg = leg_to(vec(0.3f, 0.4f, 0.4f));
    nkw_ik_two_bone_solution whole = nkw_ik_two_bone_solve(&leg), s;
    leg.weight = 0.25f;
    s = nkw_ik_two_bone_solve(&leg);
    expect_consistent(&leg, &s);
    expect_near(4.0f * nkw_quat_angle(identity, s.mid), nkw_quat_angle(identity, whole.mid), 2e-6);
    expect_near(4.0f * nkw_quat_angle(identity, s.root), nkw_quat_angle(identity, whole.root), 2e-6);
    static const float off[] = {0, -1, NAN};
    for (int i = 0; i < 3; i++) {
        leg.weight = off[i];
        s = nkw_ik_two_bone_solve(&leg);
        expect_quat_bits(s.root, identity);
        expect_quat_bits(s.mid, identity);
        expect_bits(s.error, nkw_vec3_distance(leg.end, leg.target));
    }
    leg.weight = 7;
    s = nkw_ik_two_bone_solve(&leg);
    expect_quat_bits(s.root, whole.root);
}

static void numbers_that_are_not_finite_move_nothing(void **state)
{
    (void)state;
    for (int i = 0; i < 18; i++) {
        nkw_ik_two_bone leg = leg_to(vec(0.3f, 0.4f, 0.4f));
        ((float *)&leg)[i] = i % 2 ? NAN : INFINITY;
        nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
        expect_quat_bits(s.root, identity);
        expect_quat_bits(s.mid, identity);
        expect_bits(s.error, INFINITY);
    }
    nkw_ik_two_bone leg = leg_to(vec(0.3f, 0.4f, 0.4f));
    leg.softness = NAN;
    nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
    expect_near(s.error, 0, 3e-7);
}

static void huge_and_tiny_limbs_are_solved(void **state)
{
    (void)state;
    static const float scales[] = {1e-38f, 1e-20f, 1e-6f, 1e6f, 1e20f, 1e38f};
    for (int i = 0; i < 6; i++) {
        nkw_ik_two_bone leg = leg_to(vec(0.3f, 0.4f, 0.4f));
        leg.root = nkw_vec3_scale(leg.root, scales[i]);
        leg.mid = nkw_vec3_scale(leg.mid, scales[i]);
        leg.end = nkw_vec3_scale(leg.end, scales[i]);
        leg.target = nkw_vec3_scale(leg.target, scales[i]);
        nkw_ik_two_bone_solution s = nkw_ik_two_bone_solve(&leg);
        assert_true(s.error <= 5e-7f * scales[i]);
    }
}

/* ---- Aim ---- */

static nkw_ik_aim aim_at(nkw_vec3 target)
{
    nkw_ik_aim aim = {{1, 2, 3}, {0, 0, 0}, {0, 0, 2}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0, 1};
    aim.target = target;
    return aim;
}

static void a_joint_points_at_its_target_by_the_shortest_arc(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 20000; i++) {
        nkw_ik_aim aim = aim_at(random_vec3(&r, -5, 5));
        aim.forward = random_vec3(&r, -1, 1);
        nkw_ik_aim_solution s = nkw_ik_aim_solve(&aim);
        nkw_vec3 to = nkw_vec3_sub(aim.target, aim.position);
        expect_near(nkw_vec3_angle(nkw_quat_rotate(s.rotation, aim.forward), to), 0, 1e-6);
        expect_near(s.error, 0, 5e-7);
        if (nkw_vec3_angle(aim.forward, to) < 3.0f)
            expect_rotation_near(s.rotation, nkw_quat_from_vectors(aim.forward, to), 2e-6);
    }
}

static void a_ray_that_starts_beside_the_joint_meets_the_target(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (int i = 0; i < 20000; i++) {
        nkw_ik_aim aim = aim_at(nkw_vec3_add_scaled(vec(1, 2, 3), random_direction(&r), random_between(&r, 1.5f, 9)));
        aim.forward = random_direction(&r);
        aim.offset = nkw_vec3_scale(random_direction(&r), random_unit(&r));
        aim.up = random_direction(&r);
        aim.pole = random_direction(&r);
        nkw_ik_aim_solution s = nkw_ik_aim_solve(&aim);
        nkw_vec3 start = nkw_vec3_add(aim.position, nkw_quat_rotate(s.rotation, aim.offset));
        nkw_vec3 ray = nkw_quat_rotate(s.rotation, aim.forward), to = nkw_vec3_sub(aim.target, start);
        expect_near(nkw_vec3_angle(ray, to), 0, 4e-6);
        expect_near(s.error, 0, 2e-6);
    }
}

static void up_turns_to_the_pole(void **state)
{
    (void)state;
    random_source r = random_from(8);
    for (int i = 0; i < 20000; i++) {
        nkw_ik_aim aim = aim_at(random_vec3(&r, -5, 5));
        aim.forward = random_direction(&r);
        aim.up = random_direction(&r);
        aim.pole = random_direction(&r);
        nkw_ik_aim_solution s = nkw_ik_aim_solve(&aim);
        nkw_vec3 line = nkw_vec3_normalize(nkw_vec3_sub(aim.target, aim.position));
        nkw_vec3 up = nkw_vec3_reject(nkw_quat_rotate(s.rotation, aim.up), line);
        nkw_vec3 pole = nkw_vec3_reject(aim.pole, line);
        if (nkw_vec3_length(up) > 0.02f && nkw_vec3_length(pole) > 0.02f)
            expect_near(nkw_vec3_angle(up, pole), 0, 5e-5);
    }
}

static void the_ray_stays_in_its_cone(void **state)
{
    (void)state;
    random_source r = random_from(9);
    for (int i = 0; i < 20000; i++) {
        nkw_ik_aim aim = aim_at(random_vec3(&r, -5, 5));
        aim.forward = random_direction(&r);
        aim.limit_axis = random_vec3(&r, -1, 1);
        aim.limit_angle = random_between(&r, 0, 3);
        nkw_vec3 to = nkw_vec3_sub(aim.target, aim.position);
        nkw_ik_aim_solution s = nkw_ik_aim_solve(&aim);
        double free = (double)nkw_vec3_angle(aim.limit_axis, to), most = (double)aim.limit_angle;
        nkw_vec3 ray = nkw_quat_rotate(s.rotation, aim.forward);
        expect_near(nkw_vec3_angle(aim.limit_axis, ray), free < most ? free : most, 2e-6);
        expect_near(s.error, free < most ? 0 : free - most, 2e-6);
    }
}

static void a_joint_points_at_a_target_opposite_to_its_ray(void **state)
{
    (void)state;
    random_source r = random_from(22);
    for (int i = 0; i < 20000; i++) {
        nkw_ik_aim aim = {none, none, none, none, none, none, none, 0, 1};
        aim.forward = random_vec3(&r, -4, 4);
        aim.target = nkw_vec3_scale(aim.forward, i % 2 ? -2.0f : -random_between(&r, 0.1f, 10));
        nkw_ik_aim_solution s = nkw_ik_aim_solve(&aim);
        expect_near(s.error, 0, 3e-7);
        nkw_vec3 ray = nkw_quat_rotate(s.rotation, aim.forward);
        expect_near(nkw_vec3_angle(ray, aim.target), 0, 1e-6);
        /* Into a cone about the opposite direction of the target: the ray ends on its edge. */
        aim.limit_axis = aim.forward;
        aim.limit_angle = 0.5f;
        s = nkw_ik_aim_solve(&aim);
        expect_near(nkw_vec3_angle(nkw_quat_rotate(s.rotation, aim.forward), aim.forward), 0.5, 1e-6);
    }
}

static void odd_aims_are_defined(void **state)
{
    (void)state;
    nkw_ik_aim aim = aim_at(vec(1, 2, 3));
    expect_quat_bits(nkw_ik_aim_solve(&aim).rotation, identity);
    expect_bits(nkw_ik_aim_solve(&aim).error, 0.0f);
    aim = aim_at(vec(1, 2, 2));
    expect_near(nkw_quat_angle(nkw_ik_aim_solve(&aim).rotation, identity), PI, 1e-6);
    /* The target is inside the circle of the ray: as near as it can. */
    aim = aim_at(vec(1, 2.5f, 3));
    aim.offset = vec(0, 1, 0);
    nkw_ik_aim_solution s = nkw_ik_aim_solve(&aim);
    expect_near(s.error, 0.5 * (double)PI, 1e-6);
    expect_quat_near(s.rotation, identity, 1e-6);
    /* The target is behind the start of the ray. */
    aim.offset = vec(0, 0, 2);
    s = nkw_ik_aim_solve(&aim);
    expect_near(s.error, PI, 1e-6);
    aim.forward = none;
    s = nkw_ik_aim_solve(&aim);
    expect_quat_bits(s.rotation, identity);
    expect_bits(s.error, 0.0f);
    /* The cone about the opposite of the ray; no limit by NaN. */
    aim = aim_at(vec(1, 2, 9));
    aim.limit_axis = vec(0, 0, -1);
    aim.limit_angle = 1;
    s = nkw_ik_aim_solve(&aim);
    expect_near(s.error, (double)PI - 1, 1e-6);
    aim.limit_angle = NAN;
    expect_bits(nkw_ik_aim_solve(&aim).error, 0.0f);
    for (int i = 0; i < 21; i++) {
        aim = aim_at(vec(0, 2, 9));
        ((float *)&aim)[i] = i % 2 ? NAN : INFINITY;
        s = nkw_ik_aim_solve(&aim);
        expect_quat_bits(s.rotation, identity);
        expect_bits(s.error, INFINITY);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(targets_within_reach_are_reached),
        cmocka_unit_test(targets_out_of_reach_leave_the_rest),
        cmocka_unit_test(bones_of_any_lengths_have_unit_rotations),
        cmocka_unit_test(the_pole_chooses_the_side_of_the_knee),
        cmocka_unit_test(the_knee_is_a_hinge_and_twist_is_kept),
        cmocka_unit_test(a_limb_at_its_target_does_not_move),
        cmocka_unit_test(a_straight_leg_bends_about_its_hinge),
        cmocka_unit_test(a_target_at_the_root_folds_the_limb),
        cmocka_unit_test(bones_of_length_zero_are_answered),
        cmocka_unit_test(an_opposite_target_is_reached),
        cmocka_unit_test(a_limb_reaches_a_target_opposite_to_its_end),
        cmocka_unit_test(soft_reach_is_smooth_and_never_complete),
        cmocka_unit_test(softness_leaves_a_reached_target),
        cmocka_unit_test(a_hinge_is_heard_near_straight),
        cmocka_unit_test(weights_move_a_part),
        cmocka_unit_test(numbers_that_are_not_finite_move_nothing),
        cmocka_unit_test(huge_and_tiny_limbs_are_solved),
        cmocka_unit_test(a_joint_points_at_its_target_by_the_shortest_arc),
        cmocka_unit_test(a_ray_that_starts_beside_the_joint_meets_the_target),
        cmocka_unit_test(up_turns_to_the_pole),
        cmocka_unit_test(the_ray_stays_in_its_cone),
        cmocka_unit_test(a_joint_points_at_a_target_opposite_to_its_ray),
        cmocka_unit_test(odd_aims_are_defined),
    };
    return cmocka_run_group_tests_name("ik", tests, NULL, NULL);
}
