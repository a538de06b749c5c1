/* SPDX-License-Identifier: MIT */
/* Inverse kinematics of chains, and on poses. */
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/views.h"

static const nkw_quat identity = {0, 0, 0, 1};
static const nkw_vec3 none = {0, 0, 0};

static nkw_vec3 vec(float x, float y, float z)
{
    nkw_vec3 r = {x, y, z};
    return r;
}

/* ---- Chains ---- */

enum { LINKS = 6 };

typedef struct chain_case {
    nkw_ik_chain chain;
    nkw_vec3 offsets[LINKS];
    nkw_quat rotations[LINKS];
    nkw_limit limits[LINKS];
} chain_case;

static void draw_chain(random_source *r, chain_case *c)
{
    c->chain.position = random_vec3(r, -1, 1);
    c->chain.rotation = random_rotation(r);
    c->chain.offsets = c->offsets;
    c->chain.limits = NULL;
    c->chain.count = LINKS;
    for (int k = 0; k < LINKS; k++) {
        c->offsets[k] = nkw_vec3_scale(random_direction(r), random_between(r, 0.2f, 1));
        c->rotations[k] = random_rotation(r);
    }
}

static nkw_vec3 end_of(const chain_case *c)
{
    nkw_quat q = c->chain.rotation;
    nkw_vec3 p = c->chain.position;
    for (size_t k = 0; k < c->chain.count; k++) {
        q = nkw_quat_mul(q, c->rotations[k]);
        p = nkw_vec3_add(p, nkw_quat_rotate(q, c->offsets[k]));
    }
    return p;
}

/* The largest distance of a joint or the end from the line through the base. */
static float widest_of(const chain_case *c, nkw_vec3 unit_line)
{
    float widest = 0;
    chain_case part = *c;
    for (part.chain.count = 1; part.chain.count <= c->chain.count; part.chain.count++) {
        nkw_vec3 from_base = nkw_vec3_sub(end_of(&part), c->chain.position);
        widest = nkw_max(widest, nkw_vec3_length(nkw_vec3_reject(from_base, unit_line)));
    }
    return widest;
}

static nkw_ik_chain_result solve(chain_case *c, const nkw_ik_goal *goal, int ccd)
{
    nkw_ik_chain_result result = {INFINITY, 0};
    NKW_STACK_WORK(work, NKW_IK_CHAIN_WORK(LINKS));
    nkw_ik_chain_solve(&c->chain, goal, ccd ? NKW_IK_CCD : NKW_IK_FABRIK, c->rotations, &result, work);
    return result;
}

static float reach_of(const chain_case *c)
{
    float sum = 0;
    for (size_t k = 0; k < c->chain.count; k++)
        sum += nkw_vec3_length(c->offsets[k]);
    return sum;
}

static void chains_reach_what_they_can(void **state)
{
    (void)state;
    random_source r = random_from(10);
    int missed = 0;
    for (int i = 0; i < 2000; i++) {
        chain_case c;
        draw_chain(&r, &c);
        float reach = reach_of(&c) * random_between(&r, 0.3f, i % 2 ? 0.6f : 0.9f);
        nkw_ik_goal goal = {nkw_vec3_add_scaled(c.chain.position, random_direction(&r), reach), 1e-4f, 100};
        nkw_ik_chain_result s = solve(&c, &goal, i % 2);
        missed += s.error > 1e-4f;

        expect_near(s.error, nkw_vec3_distance(end_of(&c), goal.target), 3e-6);
        assert_true(s.iterations <= 100);
        for (int k = 0; k < LINKS; k++)
            expect_near(nkw_quat_length(c.rotations[k]), 1.0, 3e-7);
    }
    assert_true(missed <= 10);
}

static void chains_stretch_to_a_far_target(void **state)
{
    (void)state;
    random_source r = random_from(11);
    for (int i = 0; i < 500; i++) {
        chain_case c;
        draw_chain(&r, &c);
        nkw_ik_goal goal = {nkw_vec3_add_scaled(c.chain.position, random_direction(&r), 2 * reach_of(&c)), 0, 1};
        nkw_ik_chain_result s = solve(&c, &goal, 0);
        expect_near(s.error, reach_of(&c), 3e-6);
        assert_int_equal(s.iterations, 1);
        draw_chain(&r, &c);
        goal.target = nkw_vec3_add_scaled(c.chain.position, random_direction(&r), 2 * reach_of(&c));
        goal.iterations = 300;
        s = solve(&c, &goal, 1);
        expect_near(s.error, reach_of(&c), 2e-3 * (double)reach_of(&c));
    }
}

static void descent_never_goes_up(void **state)
{
    (void)state;
    random_source r = random_from(12);
    for (int i = 0; i < 300; i++) {
        chain_case c;
        draw_chain(&r, &c);
        nkw_ik_goal goal = {random_vec3(&r, -3, 3), 0, 1};
        float before = nkw_vec3_distance(end_of(&c), goal.target);
        for (int k = 0; k < 30; k++) {
            float now = solve(&c, &goal, 1).error;
            assert_true(now <= before + 2e-6f);
            before = now;
        }
    }
}

static void a_chain_at_its_target_does_not_move(void **state)
{
    (void)state;
    random_source r = random_from(13);
    for (int i = 0; i < 200; i++) {
        chain_case c;
        draw_chain(&r, &c);
        nkw_quat before[LINKS];
        memcpy(before, c.rotations, sizeof before);
        nkw_ik_goal goal = {end_of(&c), 1e-5f, 10};
        nkw_ik_chain_result s = solve(&c, &goal, i % 2);
        assert_int_equal(s.iterations, 0);
        expect_floats_bits(&c.rotations[0].x, &before[0].x, 4 * LINKS);
        goal.target = none;
        goal.iterations = 0;
        s = solve(&c, &goal, i % 2);
        expect_near(s.error, nkw_vec3_length(end_of(&c)), 3e-6);
        expect_floats_bits(&c.rotations[0].x, &before[0].x, 4 * LINKS);
    }
}

static void a_straight_chain_leaves_its_line(void **state)
{
    (void)state;
    const nkw_vec3 lines[4] = {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}, {0.6f, 0, 0.8f}};
    for (int i = 0; i < 8; i++)
        for (int k = -1; k < 6; k++) {
            chain_case c;
            random_source r = random_from(14);
            draw_chain(&r, &c);
            for (int j = 0; j < LINKS; j++) {
                c.offsets[j] = nkw_vec3_scale(lines[i / 2], 0.5f);
                c.rotations[j] = identity;
            }
            c.chain.rotation = identity;
            c.chain.position = vec(2, -1, 3);
            nkw_ik_goal goal = {nkw_vec3_add_scaled(c.chain.position, lines[i / 2], 0.45f * (float)k), 1e-4f, 200};
            nkw_ik_chain_result s = solve(&c, &goal, i % 2);
            assert_true(s.error <= 1e-4f);
            assert_true(widest_of(&c, lines[i / 2]) > 0.01f);
        }
}

/* The chain is solved until its error no longer falls, to the rounding of rotations. */
static void without_tolerance_a_chain_is_solved_to_rounding(void **state)
{
    (void)state;
    random_source r = random_from(22);
    for (int i = 0; i < 200; i++) {
        chain_case drawn;
        draw_chain(&r, &drawn);
        float reach = reach_of(&drawn) * random_between(&r, 0.4f, 0.6f);
        nkw_vec3 way = random_direction(&r);
        for (int k = 0; i % 4 == 0 && k < LINKS; k++) { /* a straight chain, whose target is on its line */
            drawn.offsets[k] = nkw_vec3_scale(nkw_quat_rotate_inverse(drawn.chain.rotation, way), reach / 3);
            drawn.rotations[k] = identity;
        }
        nkw_ik_goal goal = {nkw_vec3_add_scaled(drawn.chain.position, way, reach), 0.0f, 1000};
        drawn.chain.offsets = drawn.offsets;
        nkw_ik_chain_result s = solve(&drawn, &goal, i % 2);
        assert_true(s.error <= 2e-6f);
        assert_true(s.iterations > 0);
    }
}

/* Straight chains of random bones along any line, and targets on it within reach: also at and near the base. */
static void straight_chains_reach_the_targets_on_their_line(void **state)
{
    (void)state;
    random_source r = random_from(25);
    int missed = 0;
    for (int i = 0; i < 2000; i++) {
        chain_case c;
        draw_chain(&r, &c);
        const nkw_vec3 line = i % 4 ? random_direction(&r) : vec(0, 1, 0);
        float longest = 0, length = 0;
        c.chain.count = 2 + (size_t)i % (LINKS - 1);
        for (size_t k = 0; k < LINKS; k++) {
            const float bone = random_between(&r, 0.2f, 1);
            c.offsets[k] = nkw_vec3_scale(line, bone);
            c.rotations[k] = identity;
            length += k < c.chain.count ? bone : 0;
            longest = nkw_max(longest, k < c.chain.count ? bone : 0);
        }
        const float least = nkw_max(2 * longest - length, 0), near_base = nkw_abs(random_scaled(&r, -30, -3)) * length;
        const float way = i % 3 == 0 && least == 0 ? (i % 2 ? 0 : near_base)
                                                   : nkw_lerp(least, length, random_between(&r, 0.05f, 0.95f));
        const nkw_vec3 turned = nkw_quat_rotate(c.chain.rotation, line);
        nkw_ik_goal goal = {nkw_vec3_add_scaled(c.chain.position, turned, i % 5 ? way : -way), 1e-3f, 300};
        missed += solve(&c, &goal, i / 12 % 2).error > 1e-3f;
    }
    assert_true(missed <= 20);
}

static void short_chains_are_answered(void **state)
{
    (void)state;
    for (int ccd = 0; ccd < 2; ccd++) {
        chain_case c;
        random_source r = random_from(15);
        draw_chain(&r, &c);
        c.chain.count = 0;
        nkw_ik_goal goal = {nkw_vec3_add(c.chain.position, vec(3, 0, 0)), 0, 5};
        expect_near(solve(&c, &goal, ccd).error, 3, 1e-6);
        c.chain.count = 1;
        nkw_ik_chain_result s = solve(&c, &goal, ccd);
        expect_near(s.error, 3 - (double)nkw_vec3_length(c.offsets[0]), 1e-6);
        goal.target = c.chain.position;
        s = solve(&c, &goal, ccd);
        expect_near(s.error, nkw_vec3_length(c.offsets[0]), 1e-6);
        /* All bones of length zero. */
        c.chain.count = LINKS;
        for (int i = 0; i < LINKS; i++)
            c.offsets[i] = none;
        goal.target = nkw_vec3_add(c.chain.position, vec(0, 2, 0));
        s = solve(&c, &goal, ccd);
        expect_near(s.error, 2, 1e-6);
        expect_near(nkw_quat_length(c.rotations[3]), 1.0, 3e-7);
    }
}

static void joints_stay_within_their_limits(void **state)
{
    (void)state;
    random_source r = random_from(16);
    int reached = 0;
    for (int i = 0; i < 600; i++) {
        chain_case c, wanted;
        draw_chain(&r, &c);
        for (int k = 0; k < LINKS; k++) {
            nkw_limit limit = {random_rotation(&r), c.offsets[k], random_direction(&r), 0.9f, 0.5f, -0.3f, 0.3f};
            c.limits[k] = limit;
        }
        c.chain.limits = c.limits;
        /* A target that limited rotations reach. */
        wanted = c;
        for (int k = 0; k < LINKS; k++)
            wanted.rotations[k] = nkw_limit_apply(&c.limits[k], random_rotation(&r));
        nkw_ik_goal goal = {end_of(&wanted), 1e-3f, 200};
        nkw_ik_chain_result s = solve(&c, &goal, i % 2);
        expect_near(s.error, nkw_vec3_distance(end_of(&c), goal.target), 3e-6);
        reached += s.error <= 1e-3f;
        for (int k = 0; k < LINKS; k++)
            expect_quat_bits(nkw_limit_apply(&c.limits[k], c.rotations[k]), c.rotations[k]);
    }
    assert_true(reached > 300);
}

/* Places beyond the floats: the rotations remain finite and within their limits. */
static void bones_of_the_largest_lengths_have_finite_rotations(void **state)
{
    (void)state;
    random_source r = random_from(18);
    for (int i = 0; i < 400; i++) {
        chain_case c;
        draw_chain(&r, &c);
        for (int k = 0; k < LINKS; k++) {
            const nkw_limit limit = {random_rotation(&r), c.offsets[k], random_direction(&r), 0.9f, 0.5f, -0.3f, 0.3f};
            c.limits[k] = limit;
            c.offsets[k] = nkw_vec3_scale(c.offsets[k], random_bits(&r) % 2 ? 3e38f : 1.0f);
        }
        c.chain.limits = i % 2 ? c.limits : NULL;
        const nkw_ik_goal goal = {random_vec3(&r, -1, 1), 0, 30};
        solve(&c, &goal, i / 2 % 2);
        for (int k = 0; k < LINKS; k++)
            expect_near(nkw_quat_length(c.rotations[k]), 1.0, 3e-7);
    }
}

static void chains_of_numbers_that_are_not_finite_stay(void **state)
{
    (void)state;
    random_source r = random_from(17);
    for (int i = 0; i < 40; i++) {
        chain_case c, before;
        draw_chain(&r, &c);
        nkw_ik_goal goal = {vec(1, 1, 1), 0, 5};
        float bad = i % 2 ? NAN : -INFINITY;
        *(i % 5 == 0   ? &c.chain.position.y
          : i % 5 == 1 ? &c.chain.rotation.w
          : i % 5 == 2 ? &c.offsets[3].z
          : i % 5 == 3 ? &c.rotations[5].x
                       : &goal.target.x) = bad;
        before = c;
        NKW_STACK_WORK(work, NKW_IK_CHAIN_WORK(LINKS));
        nkw_ik_method method = i % 2 ? NKW_IK_CCD : NKW_IK_FABRIK;
        assert_int_equal(nkw_ik_chain_solve(&c.chain, &goal, method, c.rotations, NULL, work), NKW_NOT_FINITE);
        expect_floats_bits(&c.rotations[0].x, &before.rotations[0].x, 4 * LINKS);
    }
    chain_case c;
    draw_chain(&r, &c);
    nkw_ik_goal goal = {vec(1, 1, 1), 0, 5};
    /* Zero rotations count as identities. */
    memset(c.rotations, 0, sizeof c.rotations);
    assert_true(solve(&c, &goal, 0).error < 10);
}

static void expect_refused(chain_case *c, nkw_ik_goal goal, nkw_ik_method method, nkw_work work, nkw_result want)
{
    const chain_case before = *c;
    nkw_ik_chain_result result = {7, 8};
    assert_int_equal(nkw_ik_chain_solve(&c->chain, &goal, method, c->rotations, &result, work), want);
    expect_bits(result.error, 7);
    assert_int_equal(result.iterations, 8);
    expect_floats_bits(&c->rotations[0].x, &before.rotations[0].x, 4 * LINKS);
}

static void goals_methods_and_memory_of_a_chain_are_checked(void **state)
{
    (void)state;
    random_source r = random_from(23);
    chain_case c;
    draw_chain(&r, &c);
    NKW_STACK_WORK(work, NKW_IK_CHAIN_WORK(LINKS) + 16);
    const nkw_work nothing = {NULL, 0}, less = {work.data, NKW_IK_CHAIN_WORK(LINKS) - 1},
                   odd = {(char *)work.data + 4, NKW_IK_CHAIN_WORK(LINKS)};
    const nkw_ik_goal goal = {vec(1, 1, 1), 0, 5}, negative = {vec(1, 1, 1), -1e-9f, 5}, nan = {vec(1, 1, 1), NAN, 5};
    expect_refused(&c, goal, NKW_IK_FABRIK, less, NKW_TOO_SMALL);
    expect_refused(&c, goal, NKW_IK_FABRIK, odd, NKW_TOO_SMALL);
    expect_refused(&c, goal, NKW_IK_FABRIK, nothing, NKW_TOO_SMALL);
    expect_refused(&c, goal, (nkw_ik_method)2, work, NKW_BAD_METHOD);
    expect_refused(&c, negative, NKW_IK_CCD, work, NKW_OUT_OF_RANGE);
    expect_refused(&c, nan, NKW_IK_FABRIK, work, NKW_NOT_FINITE);
    assert_int_equal(nkw_ik_chain_solve(&c.chain, &goal, NKW_IK_CCD, c.rotations, NULL, nothing), NKW_OK);
}

/* ---- Poses ---- */

enum { JOINTS = 8 };

/* A trunk, a leg of hip, twist joint, knee, ankle, toe, and a head. */
static const int32_t parents[JOINTS] = {-1, 0, 1, 2, 3, 4, 0, 6};

typedef struct body {
    nkw_skeleton skeleton;
    nkw_mat4 models[JOINTS], root;
    float pose[NKW_POSE_FLOATS(JOINTS)];
    nkw_ik_pose ik;
} body;

static void update(body *b)
{
    nkw_skeleton_models_from_pose(&b->skeleton, pose_view(b->pose, JOINTS), &b->root, NULL, b->models);
}

/* `mirror` scales the root by -1 in one axis. */
static void draw_body(random_source *r, body *b, int mirror)
{
    nkw_skeleton skeleton = {parents, JOINTS};
    nkw_trs trs[JOINTS], root = {random_vec3(r, -1, 1), random_rotation(r), {1.5f, 1.5f, 1.5f}};
    root.scale.y *= mirror ? -1.0f : 1.0f;
    for (int j = 0; j < JOINTS; j++) {
        float s = random_between(r, 0.8f, 1.25f);
        nkw_trs t = {nkw_vec3_scale(random_direction(r), 0.5f), random_rotation(r), {s, s, s}};
        trs[j] = t;
    }
    nkw_pose_from_trs(trs, pose_span(b->pose, JOINTS));
    b->skeleton = skeleton;
    b->root = nkw_mat4_from_trs(&root);
    nkw_ik_pose ik = {skeleton, b->models, &b->root, pose_span(b->pose, JOINTS)};
    b->ik = ik;
    update(b);
}

static nkw_vec3 place(const body *b, size_t joint)
{
    return nkw_mat4_translation(&b->models[joint]);
}

static void limbs_of_poses_reach_their_targets(void **state)
{
    (void)state;
    random_source r = random_from(18);
    for (int i = 0; i < 4000; i++) {
        body b;
        draw_body(&r, &b, i % 2);
        nkw_ik_limb limb = {1, 3, 4, random_vec3(&r, -2, 2), random_direction(&r), {0, 0, 0}, 0, 1};
        float error;
        assert_int_equal(nkw_ik_pose_two_bone(&b.ik, &limb, &error), NKW_OK);
        update(&b);
        expect_near(nkw_vec3_distance(place(&b, 4), limb.target), error, 2e-5);
        nkw_vec3 line = nkw_vec3_normalize(nkw_vec3_sub(limb.target, place(&b, 1)));
        nkw_vec3 knee = nkw_vec3_reject(nkw_vec3_sub(place(&b, 3), place(&b, 1)), line);
        nkw_vec3 side = nkw_vec3_reject(limb.pole, line);
        if (nkw_vec3_length(knee) > 0.05f && nkw_vec3_length(side) > 0.05f)
            expect_near(nkw_vec3_angle(knee, side), 0, 1e-3);
    }
}

static void joints_of_poses_aim(void **state)
{
    (void)state;
    random_source r = random_from(19);
    for (int i = 0; i < 4000; i++) {
        body b;
        draw_body(&r, &b, i % 2);
        nkw_ik_look look = {i % 3 ? 6 : 0,
                            random_vec3(&r, -9, 9),
                            random_direction(&r),
                            random_vec3(&r, -0.1f, 0.1f),
                            random_direction(&r),
                            random_direction(&r),
                            {0, 0, 0},
                            0.5f,
                            1};
        look.limit_axis = i % 4 ? none : random_direction(&r);
        float error;
        assert_int_equal(nkw_ik_pose_aim(&b.ik, &look, &error), NKW_OK);
        update(&b);
        const nkw_mat4 *m = &b.models[look.joint];
        nkw_vec3 start = nkw_mat4_transform_point(m, look.offset);
        nkw_vec3 ray = nkw_mat4_transform_direction(m, look.forward);
        expect_near(nkw_vec3_angle(ray, nkw_vec3_sub(look.target, start)), error, 3e-5);
        assert_true(i % 4 == 0 || error < 1e-4f || nkw_vec3_distance(look.target, start) < 1.0f);
    }
}

static void chains_of_poses_reach_their_targets(void **state)
{
    (void)state;
    random_source r = random_from(20);
    NKW_STACK_WORK(work, NKW_IK_POSE_CHAIN_WORK(4));
    int reached = 0;
    for (int i = 0; i < 1000; i++) {
        body b;
        draw_body(&r, &b, i % 2);
        nkw_ik_reach reach = {5, 4, {{0, 0, 0}, 1e-4f, 100}, NULL, i % 3 ? NKW_IK_FABRIK : NKW_IK_CCD, 1};
        reach.goal.target = nkw_vec3_add(place(&b, 1), random_vec3(&r, -0.7f, 0.7f));
        nkw_ik_chain_result result;
        assert_int_equal(nkw_ik_pose_chain(&b.ik, &reach, &result, work), NKW_OK);
        update(&b);
        expect_near(nkw_vec3_distance(place(&b, 5), reach.goal.target), result.error, 2e-5);
        reached += result.error <= 1e-4f;
        /* At weight 0 the pose stays; at one half the error is that of the pose. */
        reach.goal.target = random_vec3(&r, -1, 1);
        reach.weight = 0;
        body same = b;
        same.ik = b.ik;
        nkw_ik_pose_chain(&b.ik, &reach, &result, work);
        expect_floats_bits(b.pose, same.pose, NKW_POSE_FLOATS(JOINTS));
        reach.weight = 0.5f;
        nkw_ik_pose_chain(&b.ik, &reach, &result, work);
        update(&b);
        expect_near(nkw_vec3_distance(place(&b, 5), reach.goal.target), result.error, 2e-5);
    }
    assert_true(reached > 900);
}

static void joints_that_do_not_fit_change_nothing(void **state)
{
    (void)state;
    random_source r = random_from(21);
    body b, same;
    draw_body(&r, &b, 0);
    same = b;
    float error = 9;
    NKW_STACK_WORK(work, NKW_IK_POSE_CHAIN_WORK(4));
    const nkw_work less = {work.data, work.bytes - 1}, nothing = {NULL, 0};
    nkw_ik_limb limb = {1, 3, 4, {1, 1, 1}, {0, 0, 0}, {0, 0, 0}, 0, 1}, odd = limb;
    odd.end = JOINTS;
    assert_int_equal(nkw_ik_pose_two_bone(&b.ik, &odd, &error), NKW_OUT_OF_RANGE);
    expect_bits(error, 9);
    odd.end = 7;
    assert_int_equal(nkw_ik_pose_two_bone(&b.ik, &odd, NULL), NKW_NOT_ORDERED);
    odd = limb;
    odd.mid = 1;
    assert_int_equal(nkw_ik_pose_two_bone(&b.ik, &odd, &error), NKW_NOT_ORDERED);
    nkw_ik_look look = {JOINTS, {1, 1, 1}, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0, 1};
    assert_int_equal(nkw_ik_pose_aim(&b.ik, &look, &error), NKW_OUT_OF_RANGE);
    nkw_ik_reach reach = {5, 4, {{1, 1, 1}, 0, 9}, NULL, NKW_IK_CCD, 1};
    nkw_ik_chain_result result = {9, 9};
    assert_int_equal(nkw_ik_pose_chain(&b.ik, &reach, &result, less), NKW_TOO_SMALL);
    expect_bits(result.error, 9);
    reach.joint_count = 6;
    assert_int_equal(nkw_ik_pose_chain(&b.ik, &reach, NULL, work), NKW_OUT_OF_RANGE);
    reach.joint_count = 0;
    assert_int_equal(nkw_ik_pose_chain(&b.ik, &reach, &result, nothing), NKW_EMPTY);
    b.ik.pose.joint_count = JOINTS - 1;
    assert_int_equal(nkw_ik_pose_two_bone(&b.ik, &limb, &error), NKW_MISMATCHED);
    assert_int_equal(nkw_ik_pose_aim(&b.ik, &look, &error), NKW_MISMATCHED);
    assert_int_equal(nkw_ik_pose_chain(&b.ik, &reach, &result, nothing), NKW_MISMATCHED);
    expect_floats_bits(b.pose, same.pose, NKW_POSE_FLOATS(JOINTS));
}

/* A parent that is not before its joint counts as none, so nothing is an ancestor beyond it. */
static void chains_of_an_unsorted_skeleton_are_refused(void **state)
{
    (void)state;
    random_source r = random_from(24);
    body b, same;
    draw_body(&r, &b, 0);
    same = b;
    float error;
    NKW_STACK_WORK(work, NKW_IK_POSE_CHAIN_WORK(4));
    nkw_ik_limb limb = {1, 3, 4, {1, 1, 1}, {0, 0, 0}, {0, 0, 0}, 0, 1};
    nkw_ik_reach reach = {5, 4, {{1, 1, 1}, 0, 9}, NULL, NKW_IK_CCD, 1};
    for (int32_t wrong = 3; wrong < JOINTS + 2; wrong++) {
        int32_t late[JOINTS];
        memcpy(late, parents, sizeof late);
        late[3] = wrong;
        b.ik.skeleton.parents = late;
        assert_int_equal(nkw_ik_pose_two_bone(&b.ik, &limb, &error), NKW_NOT_ORDERED);
        assert_int_equal(nkw_ik_pose_chain(&b.ik, &reach, NULL, work), NKW_OUT_OF_RANGE);
    }
    expect_floats_bits(b.pose, same.pose, NKW_POSE_FLOATS(JOINTS));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(chains_reach_what_they_can),
        cmocka_unit_test(chains_stretch_to_a_far_target),
        cmocka_unit_test(descent_never_goes_up),
        cmocka_unit_test(a_chain_at_its_target_does_not_move),
        cmocka_unit_test(a_straight_chain_leaves_its_line),
        cmocka_unit_test(short_chains_are_answered),
        cmocka_unit_test(joints_stay_within_their_limits),
        cmocka_unit_test(bones_of_the_largest_lengths_have_finite_rotations),
        cmocka_unit_test(chains_of_numbers_that_are_not_finite_stay),
        cmocka_unit_test(goals_methods_and_memory_of_a_chain_are_checked),
        cmocka_unit_test(limbs_of_poses_reach_their_targets),
        cmocka_unit_test(joints_of_poses_aim),
        cmocka_unit_test(chains_of_poses_reach_their_targets),
        cmocka_unit_test(joints_that_do_not_fit_change_nothing),
        cmocka_unit_test(without_tolerance_a_chain_is_solved_to_rounding),
        cmocka_unit_test(chains_of_an_unsorted_skeleton_are_refused),
        cmocka_unit_test(straight_chains_reach_the_targets_on_their_line),
    };
    return cmocka_run_group_tests_name("ik_chain", tests, NULL, NULL);
}
