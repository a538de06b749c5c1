/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/views.h"

enum { JOINTS = 9, MORE = 12 };

static const int32_t parents[JOINTS] = {-1, 0, 1, 2, 3, 2, 5, 0, 7};

typedef struct figure {
    nkw_skeleton skeleton;
    float rest[NKW_POSE_FLOATS(MORE)], pose[NKW_POSE_FLOATS(MORE)];
    nkw_mat4 models[MORE], rest_models[MORE];
} figure;

typedef struct pair {
    figure source, target;
    nkw_retarget_joint joints[MORE];
    nkw_retarget retarget;
} pair;

static nkw_quat rotation_of(const nkw_mat4 *m)
{
    nkw_mat3 block = nkw_mat3_from_mat4(m);
    return nkw_quat_from_mat3(&block);
}

static void set_joint(float *pose, size_t count, size_t j, nkw_vec3 translation, nkw_quat rotation)
{
    nkw_trs trs = {translation, rotation, {1, 1, 1}};
    nkw_pose_set(pose_span(pose, count), j, &trs);
}

static nkw_trs get_joint(const float *pose, size_t count, size_t j)
{
    return nkw_pose_get(pose_view(pose, count), j);
}

static void update(figure *f)
{
    size_t n = f->skeleton.joint_count;
    nkw_skeleton_models_from_pose(&f->skeleton, pose_view(f->pose, n), NULL, NULL, f->models);
    nkw_skeleton_models_from_pose(&f->skeleton, pose_view(f->rest, n), NULL, NULL, f->rest_models);
}

static void draw_figure(random_source *r, figure *f)
{
    nkw_skeleton skeleton = {parents, JOINTS};
    f->skeleton = skeleton;
    nkw_pose_identity(pose_span(f->rest, JOINTS));
    nkw_pose_identity(pose_span(f->pose, JOINTS));
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_vec3 t = random_vec3(r, -1, 1);
        set_joint(f->rest, JOINTS, j, t, random_rotation(r));
        set_joint(f->pose, JOINTS, j, t, random_rotation(r));
    }
    update(f);
}

static void pair_up(pair *p)
{
    size_t m = p->source.skeleton.joint_count, n = p->target.skeleton.joint_count;
    nkw_retarget r = {p->source.skeleton,           p->target.skeleton, pose_view(p->source.rest, m),
                      pose_view(p->target.rest, n), p->joints,          {0, 0, 0, 0}};
    p->retarget = r;
}

static nkw_result apply(pair *p)
{
    size_t m = p->source.skeleton.joint_count, n = p->target.skeleton.joint_count;
    NKW_STACK_WORK(work, NKW_RETARGET_WORK(MORE, MORE));
    nkw_result result =
        nkw_retarget_apply(&p->retarget, pose_view(p->source.pose, m), pose_span(p->target.pose, n), work);
    update(&p->source);
    update(&p->target);
    return result;
}

static void map_equal(pair *p)
{
    for (int j = 0; j < JOINTS; j++) {
        nkw_retarget_joint map = {j, NKW_NO_JOINT, 0, 0};
        p->joints[j] = map;
    }
    p->joints[0].translation = 1;
}

/* The same bones, with other axes of each joint: K turns those of joint j. */
static void draw_rotated_axes(random_source *r, pair *p)
{
    nkw_quat k[JOINTS];
    draw_figure(r, &p->source);
    p->target.skeleton = p->source.skeleton;
    nkw_pose_identity(pose_span(p->target.rest, JOINTS));
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_trs rest = get_joint(p->source.rest, JOINTS, j);
        nkw_quat parent = parents[j] < 0 ? nkw_quat_identity() : k[parents[j]];
        k[j] = random_rotation(r);
        set_joint(p->target.rest, JOINTS, j, nkw_quat_rotate_inverse(parent, rest.translation),
                  nkw_quat_mul(nkw_quat_conjugate(parent), nkw_quat_mul(rest.rotation, k[j])));
    }
    map_equal(p);
    pair_up(p);
}

static void the_rest_pose_becomes_the_rest_pose(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 200; i++) {
        pair p;
        draw_figure(&r, &p.source);
        draw_figure(&r, &p.target);
        map_equal(&p);
        pair_up(&p);
        memcpy(p.source.pose, p.source.rest, sizeof p.source.rest);
        assert_int_equal(apply(&p), NKW_OK);
        for (size_t j = 0; j < JOINTS; j++) {
            nkw_trs got = get_joint(p.target.pose, JOINTS, j), want = get_joint(p.target.rest, JOINTS, j);
            expect_rotation_near(got.rotation, want.rotation, 3e-6);
            expect_vec3_near(got.translation, want.translation, 1e-6);
        }
    }
}

static void equal_bones_with_other_axes_move_alike(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 500; i++) {
        pair p;
        draw_rotated_axes(&r, &p);
        nkw_trs root = get_joint(p.source.pose, JOINTS, 0);
        root.translation = random_vec3(&r, -3, 3);
        set_joint(p.source.pose, JOINTS, 0, root.translation, root.rotation);
        assert_int_equal(apply(&p), NKW_OK);
        for (size_t j = 0; j < JOINTS; j++)
            expect_vec3_near(nkw_mat4_translation(&p.target.models[j]), nkw_mat4_translation(&p.source.models[j]),
                             2e-5);
    }
}

/* B = L W^-1 N W of the target, N = W L^-1 A W^-1 of the source. */
static void joints_follow_the_formula_of_vrm(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 300; i++) {
        pair p;
        draw_figure(&r, &p.source);
        draw_figure(&r, &p.target);
        map_equal(&p);
        pair_up(&p);
        apply(&p);
        for (size_t j = 0; j < JOINTS; j++) {
            nkw_quat w = rotation_of(&p.source.rest_models[j]), v = rotation_of(&p.target.rest_models[j]);
            nkw_quat a = get_joint(p.source.pose, JOINTS, j).rotation, l = get_joint(p.source.rest, JOINTS, j).rotation;
            nkw_quat n = nkw_quat_mul(nkw_quat_mul(w, nkw_quat_conjugate(l)), nkw_quat_mul(a, nkw_quat_conjugate(w)));
            nkw_quat b = nkw_quat_mul(get_joint(p.target.rest, JOINTS, j).rotation,
                                      nkw_quat_mul(nkw_quat_conjugate(v), nkw_quat_mul(n, v)));
            expect_rotation_near(get_joint(p.target.pose, JOINTS, j).rotation, b, 1e-5);
        }
    }
}

/* A target without joint 1: the joints below it point as those of the source do. */
static void rotations_of_missing_joints_are_included(void **state)
{
    (void)state;
    static const int32_t fewer[JOINTS - 1] = {-1, 0, 1, 2, 1, 4, 0, 6};
    random_source r = random_from(4);
    for (int i = 0; i < 300; i++) {
        pair p;
        draw_figure(&r, &p.source);
        nkw_skeleton skeleton = {fewer, JOINTS - 1};
        p.target.skeleton = skeleton;
        nkw_pose_identity(pose_span(p.target.rest, JOINTS - 1));
        for (int j = 0; j < JOINTS - 1; j++) {
            nkw_retarget_joint map = {j ? j + 1 : 0, NKW_NO_JOINT, 0, 0};
            p.joints[j] = map;
            set_joint(p.target.rest, JOINTS - 1, (size_t)j, random_vec3(&r, -1, 1), random_rotation(&r));
        }
        pair_up(&p);
        apply(&p);
        for (size_t j = 0; j < JOINTS - 1; j++) {
            size_t s = (size_t)p.joints[j].from;
            nkw_quat moved = nkw_quat_mul(rotation_of(&p.source.models[s]),
                                          nkw_quat_conjugate(rotation_of(&p.source.rest_models[s])));
            nkw_quat got = nkw_quat_mul(rotation_of(&p.target.models[j]),
                                        nkw_quat_conjugate(rotation_of(&p.target.rest_models[j])));
            expect_rotation_near(got, moved, 1e-5);
        }
    }
}

static void joints_without_a_source_keep_their_rest(void **state)
{
    (void)state;
    random_source r = random_from(5);
    pair p;
    draw_rotated_axes(&r, &p);
    p.joints[3].from = NKW_NO_JOINT;
    p.joints[6].from = 1000;
    apply(&p);
    for (size_t j = 3; j <= 6; j += 3) {
        nkw_trs got = get_joint(p.target.pose, JOINTS, j), want = get_joint(p.target.rest, JOINTS, j);
        expect_quat_bits(got.rotation, want.rotation);
        expect_vec3_bits(got.translation, want.translation);
    }
}

static void translations_are_scaled(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 300; i++) {
        pair p;
        draw_rotated_axes(&r, &p);
        p.joints[0].translation = 0.5f;
        nkw_vec3 moved = random_vec3(&r, -3, 3);
        nkw_trs root = get_joint(p.source.rest, JOINTS, 0), pose = get_joint(p.source.pose, JOINTS, 0);
        set_joint(p.source.pose, JOINTS, 0, nkw_vec3_add(root.translation, moved), pose.rotation);
        apply(&p);
        nkw_vec3 rest = get_joint(p.target.rest, JOINTS, 0).translation;
        expect_vec3_near(get_joint(p.target.pose, JOINTS, 0).translation, nkw_vec3_add_scaled(rest, moved, 0.5f), 3e-6);
    }
}

/* A source that looks elsewhere. */
static void align_turns_the_model_spaces(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (int i = 0; i < 300; i++) {
        pair p;
        draw_rotated_axes(&r, &p);
        nkw_quat align = random_rotation(&r);
        nkw_trs rest = get_joint(p.target.rest, JOINTS, 0), pose = get_joint(p.source.pose, JOINTS, 0);
        set_joint(p.target.rest, JOINTS, 0, nkw_quat_rotate(align, rest.translation),
                  nkw_quat_mul(align, rest.rotation));
        set_joint(p.source.pose, JOINTS, 0, random_vec3(&r, -3, 3), pose.rotation);
        p.retarget.align = align;
        apply(&p);
        for (size_t j = 0; j < JOINTS; j++)
            expect_vec3_near(nkw_mat4_translation(&p.target.models[j]),
                             nkw_quat_rotate(align, nkw_mat4_translation(&p.source.models[j])), 2e-5);
    }
}

/* A spine of 3 joints bends on one of 5: the ends bend alike, the joints between lie between. */
static void chains_of_other_lengths_are_mapped_by_length(void **state)
{
    (void)state;
    static const int32_t short_spine[3] = {-1, 0, 1}, long_spine[5] = {-1, 0, 1, 2, 3};
    const nkw_vec3 up = {0, 1, 0}, half_up = {0, 0.5f, 0}, none = {0, 0, 0}, z = {0, 0, 1};
    pair p;
    memset(&p, 0, sizeof p);
    p.source.skeleton.parents = short_spine;
    p.source.skeleton.joint_count = 3;
    p.target.skeleton.parents = long_spine;
    p.target.skeleton.joint_count = 5;
    nkw_pose_identity(pose_span(p.source.rest, 3));
    nkw_pose_identity(pose_span(p.target.rest, 5));
    for (size_t j = 0; j < 5; j++) {
        if (j < 3)
            set_joint(p.source.rest, 3, j, j ? up : none, nkw_quat_identity());
        set_joint(p.target.rest, 5, j, j ? half_up : none, nkw_quat_identity());
    }
    memcpy(p.source.pose, p.source.rest, sizeof p.source.rest);
    for (size_t j = 0; j < 3; j++)
        set_joint(p.source.pose, 3, j, j ? up : none, nkw_quat_from_axis_angle(z, 0.4f));
    pair_up(&p);
    const int32_t from[3] = {0, 1, 2}, to[5] = {0, 1, 2, 3, 4};
    assert_int_equal(nkw_retarget_map_chain(&p.retarget, from, 3, to, 5, p.joints), NKW_OK);
    apply(&p);
    static const float angles[5] = {0.4f, 0.6f, 0.8f, 1.0f, 1.2f};
    for (size_t j = 0; j < 5; j++)
        expect_rotation_near(rotation_of(&p.target.models[j]), nkw_quat_from_axis_angle(z, angles[j]), 1e-6);
    /* To fewer joints; of one joint. */
    assert_int_equal(nkw_retarget_map_chain(&p.retarget, from, 1, to, 5, p.joints), NKW_OK);
    for (size_t j = 0; j < 5; j++)
        assert_int_equal(p.joints[j].from, 0);
    assert_int_equal(nkw_retarget_map_chain(&p.retarget, from, 3, to, 1, p.joints), NKW_OK);
    expect_bits(p.joints[0].t, 0.0f);
    const int32_t bad[1] = {5};
    assert_int_equal(nkw_retarget_map_chain(&p.retarget, from, 0, to, 1, p.joints), NKW_EMPTY);
    assert_int_equal(nkw_retarget_map_chain(&p.retarget, bad, 1, to, 1, p.joints), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_retarget_map_chain(&p.retarget, from, 1, bad, 1, p.joints), NKW_OUT_OF_RANGE);
}

/*
 * Thirds of a chain are at thirds of an arc: of a spine of 3 joints that bend by 1.2 rad each, the joints of one of 4
 * have the angles 1.2 (1 + 2 k/3). A linear blend differs from them by 4e-3 rad.
 */
static void joints_between_two_lie_on_the_arc(void **state)
{
    (void)state;
    static const int32_t short_spine[3] = {-1, 0, 1}, long_spine[4] = {-1, 0, 1, 2};
    const nkw_vec3 axis = nkw_vec3_normalize((nkw_vec3){1, -2, 2}), bone = {0.2f, 1, 0.1f};
    pair p;
    memset(&p, 0, sizeof p);
    p.source.skeleton.parents = short_spine;
    p.source.skeleton.joint_count = 3;
    p.target.skeleton.parents = long_spine;
    p.target.skeleton.joint_count = 4;
    nkw_pose_identity(pose_span(p.source.rest, 3));
    nkw_pose_identity(pose_span(p.source.pose, 3));
    nkw_pose_identity(pose_span(p.target.rest, 4));
    for (size_t j = 0; j < 4; j++) {
        set_joint(p.target.rest, 4, j, bone, nkw_quat_identity());
        if (j < 3)
            set_joint(p.source.rest, 3, j, bone, nkw_quat_identity());
        if (j < 3)
            set_joint(p.source.pose, 3, j, bone, nkw_quat_from_axis_angle(axis, 1.2f));
    }
    pair_up(&p);
    const int32_t from[3] = {0, 1, 2}, to[4] = {0, 1, 2, 3};
    assert_int_equal(nkw_retarget_map_chain(&p.retarget, from, 3, to, 4, p.joints), NKW_OK);
    apply(&p);
    for (size_t j = 0; j < 4; j++)
        expect_rotation_near(rotation_of(&p.target.models[j]),
                             nkw_quat_from_axis_angle(axis, (float)(1.2 * (1 + 2.0 * (double)j / 3))), 1e-6);
}

static void the_chain_scale_is_the_ratio_of_lengths(void **state)
{
    (void)state;
    random_source r = random_from(10);
    pair p;
    draw_figure(&r, &p.source);
    draw_figure(&r, &p.target);
    map_equal(&p);
    pair_up(&p);
    const int32_t from[3] = {0, 1, 2}, to[2] = {3, 4}, bad[1] = {JOINTS};
    double length = (double)nkw_vec3_length(get_joint(p.source.rest, JOINTS, 1).translation) +
                    (double)nkw_vec3_length(get_joint(p.source.rest, JOINTS, 2).translation);
    double other = (double)nkw_vec3_length(get_joint(p.target.rest, JOINTS, 4).translation);
    float scale = 9;
    assert_int_equal(nkw_retarget_chain_scale(&p.retarget, from, 3, to, 2, &scale), NKW_OK);
    expect_near(scale, other / length, 1e-6);
    scale = 9;
    assert_int_equal(nkw_retarget_chain_scale(&p.retarget, from, 3, to, 1, &scale), NKW_NOT_FINITE);
    assert_int_equal(nkw_retarget_chain_scale(&p.retarget, from, 1, to, 2, &scale), NKW_NOT_FINITE);
    assert_int_equal(nkw_retarget_chain_scale(&p.retarget, from, 0, to, 2, &scale), NKW_EMPTY);
    assert_int_equal(nkw_retarget_chain_scale(&p.retarget, from, 3, bad, 1, &scale), NKW_OUT_OF_RANGE);
    p.target.rest[4] = INFINITY;
    assert_int_equal(nkw_retarget_chain_scale(&p.retarget, from, 3, to, 2, &scale), NKW_NOT_FINITE);
    expect_bits(scale, 9);
}

static void validate_names_the_first_offender(void **state)
{
    (void)state;
    random_source r = random_from(8);
    pair p;
    size_t bad = 7;
    draw_rotated_axes(&r, &p);
    assert_int_equal(nkw_retarget_validate(&p.retarget, &bad), NKW_OK);
    assert_int_equal(bad, 0);
    p.joints[4].to = JOINTS;
    assert_int_equal(nkw_retarget_validate(&p.retarget, &bad), NKW_OUT_OF_RANGE);
    assert_int_equal(bad, 4);
    p.joints[3].t = NAN;
    assert_int_equal(nkw_retarget_validate(&p.retarget, &bad), NKW_NOT_FINITE);
    assert_int_equal(bad, 3);
    p.target.rest[2] = INFINITY;
    assert_int_equal(nkw_retarget_validate(&p.retarget, &bad), NKW_NOT_FINITE);
    assert_int_equal(bad, 2);
    p.retarget.target_rest.joint_count = 3;
    assert_int_equal(nkw_retarget_validate(&p.retarget, NULL), NKW_MISMATCHED);
    p.retarget.source.joint_count = 0;
    assert_int_equal(nkw_retarget_validate(&p.retarget, &bad), NKW_EMPTY);
}

/* Each number of each entry by itself. */
static void each_entry_of_the_map_is_checked(void **state)
{
    (void)state;
    random_source r = random_from(12);
    pair p;
    draw_rotated_axes(&r, &p);
    for (size_t j = 0; j < JOINTS; j++) {
        const nkw_retarget_joint good = p.joints[j];
        const int32_t joints[4] = {-2, INT32_MIN, JOINTS, INT32_MAX};
        const float numbers[3] = {NAN, INFINITY, -INFINITY};
        size_t bad = 99;
        for (int i = 0; i < 8; i++) {
            *(i % 2 ? &p.joints[j].to : &p.joints[j].from) = joints[i / 2];
            assert_int_equal(nkw_retarget_validate(&p.retarget, &bad), NKW_OUT_OF_RANGE);
            assert_int_equal(bad, j);
            p.joints[j] = good;
        }
        for (int i = 0; i < 6; i++) {
            *(i % 2 ? &p.joints[j].t : &p.joints[j].translation) = numbers[i / 2];
            assert_int_equal(nkw_retarget_validate(&p.retarget, &bad), NKW_NOT_FINITE);
            assert_int_equal(bad, j);
            p.joints[j] = good;
        }
        p.joints[j].from = p.joints[j].to = NKW_NO_JOINT;
        assert_int_equal(nkw_retarget_validate(&p.retarget, &bad), NKW_OK);
        p.joints[j] = good;
    }
}

/* An unsorted skeleton is refused by validate; a parent that is not before its joint counts as none. */
static void a_parent_after_its_joint_counts_as_none(void **state)
{
    (void)state;
    random_source r = random_from(13);
    pair p, want;
    draw_rotated_axes(&r, &p);
    want = p;
    int32_t late[JOINTS], roots[JOINTS];
    memcpy(late, parents, sizeof late);
    memcpy(roots, parents, sizeof roots);
    late[3] = 3;
    late[5] = JOINTS - 1;
    roots[3] = roots[5] = -1;
    p.source.skeleton.parents = p.target.skeleton.parents = late;
    want.source.skeleton.parents = want.target.skeleton.parents = roots;
    pair_up(&p);
    pair_up(&want);
    size_t bad;
    assert_int_not_equal(nkw_retarget_validate(&p.retarget, &bad), NKW_OK);
    assert_int_equal(bad, 3);
    apply(&p);
    apply(&want);
    for (size_t j = 0; j < JOINTS; j++)
        expect_quat_bits(get_joint(p.target.pose, JOINTS, j).rotation, get_joint(want.target.pose, JOINTS, j).rotation);
}

/* Joints count where lengths do not: all bones of length 0, or one that is infinite. */
static void a_chain_without_a_length_counts_joints(void **state)
{
    (void)state;
    const int32_t from[3] = {0, 1, 2}, to[5] = {4, 5, 6, 7, 8}, none[1] = {-1}, beyond[1] = {JOINTS};
    const nkw_vec3 zero = {0, 0, 0}, far = {INFINITY, 0, 0};
    random_source r = random_from(14);
    for (int i = 0; i < 2; i++) {
        pair p;
        draw_rotated_axes(&r, &p);
        for (size_t j = 0; j < JOINTS; j++) {
            set_joint(p.source.rest, JOINTS, j, i ? far : zero, nkw_quat_identity());
            set_joint(p.target.rest, JOINTS, j, i ? far : zero, nkw_quat_identity());
        }
        assert_int_equal(nkw_retarget_map_chain(&p.retarget, from, 3, to, 5, p.joints), NKW_OK);
        for (int k = 0; k < 5; k++) {
            const float share = 0.5f * (float)k; /* of two bones of the source */
            assert_int_equal(p.joints[4 + k].from, k < 2 ? 0 : 1);
            assert_int_equal(p.joints[4 + k].to, k < 2 ? 1 : 2);
            expect_bits(p.joints[4 + k].t, k < 2 ? share : share - 1);
        }
        assert_int_equal(nkw_retarget_map_chain(&p.retarget, from, 3, to, 0, p.joints), NKW_EMPTY);
        assert_int_equal(nkw_retarget_map_chain(&p.retarget, none, 1, to, 5, p.joints), NKW_OUT_OF_RANGE);
        assert_int_equal(nkw_retarget_map_chain(&p.retarget, from, 3, none, 1, p.joints), NKW_OUT_OF_RANGE);
        assert_int_equal(nkw_retarget_chain_scale(&p.retarget, from, 3, to, 0, NULL), NKW_EMPTY);
        assert_int_equal(nkw_retarget_chain_scale(&p.retarget, beyond, 1, to, 5, NULL), NKW_OUT_OF_RANGE);
        assert_int_equal(nkw_retarget_chain_scale(&p.retarget, from, 3, none, 1, NULL), NKW_OUT_OF_RANGE);
    }
}

static void counts_that_do_not_fit_write_nothing(void **state)
{
    (void)state;
    random_source r = random_from(9);
    pair p;
    draw_rotated_axes(&r, &p);
    memset(p.target.pose, 0, sizeof p.target.pose);
    nkw_pose_view in = pose_view(p.source.pose, JOINTS);
    nkw_pose_span out = pose_span(p.target.pose, JOINTS);
    NKW_STACK_WORK(work, NKW_RETARGET_WORK(JOINTS, JOINTS) + 16);
    const nkw_work few = {work.data, NKW_RETARGET_WORK(JOINTS, JOINTS) - 1}, half = {work.data, 32 * JOINTS - 1},
                   odd = {(char *)work.data + 4, NKW_RETARGET_WORK(JOINTS, JOINTS)}, nothing = {NULL, 0};
    assert_int_equal(nkw_retarget_apply(&p.retarget, in, out, few), NKW_TOO_SMALL);
    assert_int_equal(nkw_retarget_apply(&p.retarget, in, out, half), NKW_TOO_SMALL);
    assert_int_equal(nkw_retarget_apply(&p.retarget, in, out, odd), NKW_TOO_SMALL);
    assert_int_equal(nkw_retarget_apply(&p.retarget, in, out, nothing), NKW_TOO_SMALL);
    for (int i = 0; i < 2; i++) {
        nkw_pose_view *rest = i ? &p.retarget.source_rest : &p.retarget.target_rest;
        rest->joint_count--;
        assert_int_equal(nkw_retarget_apply(&p.retarget, in, out, work), NKW_MISMATCHED);
        assert_int_equal(nkw_retarget_validate(&p.retarget, NULL), NKW_MISMATCHED);
        rest->joint_count++;
    }
    in.joint_count--;
    assert_int_equal(nkw_retarget_apply(&p.retarget, in, out, work), NKW_MISMATCHED);
    in.joint_count++;
    out.joint_count--;
    assert_int_equal(nkw_retarget_apply(&p.retarget, in, out, work), NKW_MISMATCHED);
    for (size_t i = 0; i < NKW_POSE_FLOATS(JOINTS); i++)
        expect_bits(p.target.pose[i], 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_rest_pose_becomes_the_rest_pose),
        cmocka_unit_test(equal_bones_with_other_axes_move_alike),
        cmocka_unit_test(joints_follow_the_formula_of_vrm),
        cmocka_unit_test(rotations_of_missing_joints_are_included),
        cmocka_unit_test(joints_without_a_source_keep_their_rest),
        cmocka_unit_test(translations_are_scaled),
        cmocka_unit_test(align_turns_the_model_spaces),
        cmocka_unit_test(chains_of_other_lengths_are_mapped_by_length),
        cmocka_unit_test(the_chain_scale_is_the_ratio_of_lengths),
        cmocka_unit_test(validate_names_the_first_offender),
        cmocka_unit_test(counts_that_do_not_fit_write_nothing),
        cmocka_unit_test(joints_between_two_lie_on_the_arc),
        cmocka_unit_test(each_entry_of_the_map_is_checked),
        cmocka_unit_test(a_parent_after_its_joint_counts_as_none),
        cmocka_unit_test(a_chain_without_a_length_counts_joints),
    };
    return cmocka_run_group_tests_name("retarget", tests, NULL, NULL);
}
