/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "support/poses.h"
#include "support/put.h"
#include "support/views.h"

#include <nakawari/mirror.h>

#define RIG 6

/* Chest, left and right arm, their hands, a head. */
static const int32_t rig_parents[RIG] = {-1, 0, 0, 1, 2, 0}, rig_pair[RIG] = {0, 2, 1, 4, 3, 5};

typedef struct rig_of_test {
    float rest[NKW_POSE_FLOATS(RIG)], pose[NKW_POSE_FLOATS(RIG)], out[NKW_POSE_FLOATS(RIG)];
    nkw_mirror_rig rig;
} rig_of_test;

/* The rest pose at mirrored places, every joint with axes of its own. */
static void make_rig(rig_of_test *t, uint64_t seed)
{
    random_source r = random_from(seed);
    const nkw_vec3 at[RIG] = {{0, 1, 0},          {0.2f, 1.5f, 0.1f},  {-0.2f, 1.5f, 0.1f},
                              {0.7f, 1.4f, 0.2f}, {-0.7f, 1.4f, 0.2f}, {0, 1.8f, 0}};
    nkw_quat w[RIG];
    nkw_pose_identity(pose_span(t->rest, RIG));
    for (size_t j = 0; j < RIG; j++) {
        nkw_trs trs = nkw_trs_identity();
        const int32_t q = rig_parents[j];
        w[j] = random_rotation(&r);
        trs.rotation = q < 0 ? w[j] : nkw_quat_mul(nkw_quat_conjugate(w[q]), w[j]);
        trs.translation = q < 0 ? at[j] : nkw_quat_rotate(nkw_quat_conjugate(w[q]), nkw_vec3_sub(at[j], at[q]));
        nkw_pose_set(pose_span(t->rest, RIG), j, &trs);
        trs.rotation = random_rotation(&r);
        trs.translation = nkw_vec3_add(trs.translation, random_vec3(&r, -0.1f, 0.1f));
        nkw_pose_set(pose_span(t->pose, RIG), j, &trs);
    }
    const nkw_mirror_rig rig = {rig_parents, rig_pair, pose_view(t->rest, RIG), NKW_MIRROR_X};
    t->rig = rig;
}

static void models_of(const float *pose, nkw_mat4 *models)
{
    const nkw_skeleton skeleton = {rig_parents, RIG};
    nkw_skeleton_models_from_pose(&skeleton, pose_view(pose, RIG), NULL, NULL, models);
}

/* G' = M G_p W_p^-1 M W_j, by matrices. */
static void models_are_mirrored_through_the_rest_pose(void **state)
{
    (void)state;
    NKW_STACK_WORK(work, NKW_MIRROR_WORK(RIG));
    nkw_mat4 m = nkw_mat4_identity();
    m.m[0] = -1;
    for (uint64_t seed = 1; seed < 200; seed++) {
        static rig_of_test t;
        nkw_mat4 rest[RIG], pose[RIG], out[RIG];
        size_t bad;
        make_rig(&t, seed);
        assert_int_equal(nkw_pose_mirror_rest(pose_view(t.pose, RIG), &t.rig, pose_span(t.out, RIG), NULL, &bad, work),
                         NKW_OK);
        models_of(t.rest, rest);
        models_of(t.pose, pose);
        models_of(t.out, out);
        for (size_t j = 0; j < RIG; j++) {
            const size_t p = (size_t)rig_pair[j];
            const nkw_mat4 inverse = nkw_mat4_inverse(&rest[p]), moved = nkw_mat4_mul(&pose[p], &inverse);
            nkw_mat4 want = nkw_mat4_mul(&m, &moved);
            want = nkw_mat4_mul(&want, &m);
            want = nkw_mat4_mul(&want, &rest[j]);
            for (size_t i = 0; i < 16; i++)
                expect_near(out[j].m[i], (double)want.m[i], 3e-6);
        }
        nkw_pose_mirror_rest(pose_view(t.out, RIG), &t.rig, pose_span(t.out, RIG), NULL, NULL, work);
        for (size_t j = 0; j < RIG; j++) {
            const nkw_trs a = nkw_pose_get(pose_view(t.out, RIG), j), b = nkw_pose_get(pose_view(t.pose, RIG), j);
            expect_rotation_near(a.rotation, b.rotation, 3e-6);
            expect_vec3_near(a.translation, b.translation, 2e-6);
        }
    }
}

/* Chest, L, R; the right axes are x, -y, -z of the left: L raised by 0.5 rad about z lowers R by as much in the model. */
static void axes_of_mirrored_behaviour_are_found_and_mirrored(void **state)
{
    (void)state;
    NKW_STACK_WORK(work, NKW_MIRROR_WORK(3));
    const int32_t parents[3] = {-1, 0, 0}, pair[3] = {0, 2, 1};
    float rest[NKW_POSE_FLOATS(3)], pose[NKW_POSE_FLOATS(3)], difference;
    nkw_pose_identity(pose_span(rest, 3));
    nkw_trs right = nkw_trs_identity(), left = right;
    right.rotation = (nkw_quat){1, 0, 0, 0};
    nkw_pose_set(pose_span(rest, 3), 2, &right);
    memcpy(pose, rest, sizeof pose);
    left.rotation = nkw_quat_from_axis_angle((nkw_vec3){0, 0, 1}, 0.5f);
    left.scale = (nkw_vec3){1, 2, 3};
    nkw_pose_set(pose_span(pose, 3), 1, &left);
    const nkw_mirror_rig rig = {parents, pair, pose_view(rest, 3), NKW_MIRROR_X};
    assert_int_equal(nkw_pose_mirror_rest(pose_view(rest, 3), &rig, pose_span(rest, 3), &difference, NULL, work),
                     NKW_OK);
    expect_near(difference, 3.14159265, 1e-6);
    nkw_pose_mirror_rest(pose_view(pose, 3), &rig, pose_span(pose, 3), NULL, NULL, work);
    const nkw_quat down = nkw_quat_from_axis_angle((nkw_vec3){0, 0, 1}, -0.5f);
    const nkw_trs got = nkw_pose_get(pose_view(pose, 3), 2);
    expect_rotation_near(got.rotation, nkw_quat_mul(down, right.rotation), 1e-6);
    expect_vec3_near(got.scale, left.scale, 1e-6);
    expect_rotation_near(nkw_pose_get(pose_view(pose, 3), 1).rotation, nkw_quat_identity(), 1e-6);
}

/* A rest pose that is its own mirror image. */
static void where_the_axes_are_mirrored_it_is_the_plain_mirror(void **state)
{
    (void)state;
    NKW_STACK_WORK(work, NKW_MIRROR_WORK(RIG));
    static rig_of_test t;
    float difference, want[NKW_POSE_FLOATS(RIG)];
    make_rig(&t, 3);
    for (size_t j = 0; j < RIG; j++) {
        nkw_trs trs = nkw_pose_get(pose_view(t.rest, RIG), j);
        trs.rotation = nkw_quat_identity();
        trs.translation.x = j == (size_t)rig_pair[j] ? 0.0f : trs.translation.x;
        nkw_pose_set(pose_span(t.rest, RIG), j, &trs);
        trs.translation.x = -trs.translation.x;
        if (j < (size_t)rig_pair[j])
            nkw_pose_set(pose_span(t.rest, RIG), (size_t)rig_pair[j], &trs);
    }
    for (size_t j = 0; j < RIG; j++) {
        nkw_trs trs = nkw_pose_get(pose_view(t.rest, RIG), j);
        if (j > (size_t)rig_pair[j])
            trs.translation = nkw_pose_get(pose_view(t.rest, RIG), (size_t)rig_pair[j]).translation,
            trs.translation.x = -trs.translation.x;
        nkw_pose_set(pose_span(t.rest, RIG), j, &trs);
    }
    nkw_pose_mirror(pose_view(t.pose, RIG), rig_pair, NKW_MIRROR_X, pose_span(want, RIG), NULL);
    assert_int_equal(
        nkw_pose_mirror_rest(pose_view(t.pose, RIG), &t.rig, pose_span(t.out, RIG), &difference, NULL, work), NKW_OK);
    expect_near(difference, 0, 1e-7);
    for (size_t j = 0; j < RIG; j++) {
        const nkw_trs a = nkw_pose_get(pose_view(t.out, RIG), j), b = nkw_pose_get(pose_view(want, RIG), j);
        expect_rotation_near(a.rotation, b.rotation, 1e-6);
        expect_vec3_near(a.translation, b.translation, 1e-6);
    }
}

static void expect_refused(nkw_mirror_rig rig, nkw_result result, size_t joint)
{
    NKW_STACK_WORK(work, NKW_MIRROR_WORK(RIG));
    float pose[NKW_POSE_FLOATS(RIG)] = {0}, out[NKW_POSE_FLOATS(RIG)] = {0};
    size_t bad = 99;
    assert_int_equal(nkw_pose_mirror_rest(pose_view(pose, RIG), &rig, pose_span(out, RIG), NULL, &bad, work), result);
    assert_int_equal(bad, joint);
    for (size_t i = 0; i < NKW_POSE_FLOATS(RIG); i++)
        assert_true(out[i] == 0.0f);
}

static void a_rig_that_cannot_be_mirrored_is_refused(void **state)
{
    (void)state;
    static rig_of_test t;
    make_rig(&t, 1);
    nkw_mirror_rig rig = t.rig;
    const int32_t far[RIG] = {0, 2, 1, 4, 3, 6}, single[RIG] = {0, 2, 2, 4, 3, 5}, crossed[RIG] = {0, 2, 1, 3, 4, 5};
    const int32_t late[RIG] = {-1, 0, 0, 5, 2, 0}, none[RIG] = {-1, 0, 0, 1, -2, 0}, beyond[RIG] = {-1, 0, 9, 1, 2, 0};
    rig.plane = (nkw_mirror)3;
    expect_refused(rig, NKW_BAD_METHOD, 0);
    rig = t.rig, rig.pair = far;
    expect_refused(rig, NKW_OUT_OF_RANGE, 5);
    rig.pair = single;
    expect_refused(rig, NKW_BAD_MIRROR, 1);
    rig.pair = crossed;
    expect_refused(rig, NKW_BAD_MIRROR, 3);
    rig = t.rig, rig.parents = late;
    expect_refused(rig, NKW_NOT_ORDERED, 3);
    rig.parents = none;
    expect_refused(rig, NKW_BAD_MIRROR, 3);
    rig.parents = beyond;
    expect_refused(rig, NKW_BAD_MIRROR, 1);
    rig = t.rig, rig.rest.joint_count = RIG - 1;
    expect_refused(rig, NKW_MISMATCHED, 0);
    const nkw_work small = {NULL, 0};
    assert_int_equal(nkw_pose_mirror_rest(pose_view(t.pose, RIG), &t.rig, pose_span(t.out, RIG), NULL, NULL, small),
                     NKW_TOO_SMALL);
}

static void names_of_tools_have_partners(void **state)
{
    (void)state;
    static const char *const names[] = {"Hips",
                                        "mixamorig:LeftArm",
                                        "mixamorig:RightArm",
                                        "hand.L",
                                        "hand.R",
                                        "L_Foot",
                                        "R_Foot",
                                        "Bip01 L Arm",
                                        "Bip01 R Arm",
                                        "lShldr",
                                        "rShldr",
                                        "\xE5\xB7\xA6\xE8\x85\x95",
                                        "\xE5\x8F\xB3\xE8\x85\x95",
                                        "thigh_l",
                                        "thigh_r",
                                        "Lamp",
                                        "Ramp",
                                        "ball",
                                        "barr",
                                        NULL,
                                        "eyeLeft",
                                        "eyeRight",
                                        "Left",
                                        NULL};
    int32_t pair[24];
    assert_int_equal(nkw_mirror_pairs_from_names(names, 24, pair), 8);
    for (int32_t j = 0; j < 24; j++) {
        const int is_pair = (j >= 1 && j <= 14) || j == 20 || j == 21;
        const int32_t partner = j == 20 ? 21 : j == 21 ? 20 : j % 2 ? j + 1 : j - 1;
        assert_int_equal(pair[j], is_pair ? partner : j);
    }
    assert_int_equal(nkw_mirror_pairs_from_names(names, 0, pair), 0);
}

/* Tracks of the arm (1) for the other arm (2): sampled, it is the mirrored pose of the sample. */
static void expect_mirrored_track(const rig_of_test *t, nkw_track track, nkw_axes_kind kind, float time)
{
    NKW_STACK_WORK(work, NKW_MIRROR_WORK(RIG));
    float mirrored[48], pose[NKW_POSE_FLOATS(RIG)], got[4];
    nkw_track other = track;
    other.values = mirrored;
    assert_int_equal(nkw_track_mirror_rest(&track, &t->rig, 1, kind, mirrored, work), NKW_OK);
    nkw_track_sample(&other, time, NULL, got);
    memcpy(pose, t->rest, sizeof pose);
    nkw_trs trs = nkw_pose_get(pose_view(pose, RIG), 1);
    nkw_track_sample(&track, time, NULL,
                     kind == NKW_AXES_QUAT ? &trs.rotation.x : kind == NKW_AXES_VEC3 ? &trs.translation.x : &trs.scale.x);
    nkw_pose_set(pose_span(pose, RIG), 1, &trs);
    nkw_pose_mirror_rest(pose_view(pose, RIG), &t->rig, pose_span(pose, RIG), NULL, NULL, work);
    trs = nkw_pose_get(pose_view(pose, RIG), 2);
    const nkw_quat turn = {got[0], got[1], got[2], got[3]};
    const nkw_vec3 v = {got[0], got[1], got[2]};
    if (kind == NKW_AXES_QUAT)
        expect_rotation_near(turn, trs.rotation, 3e-6);
    else
        expect_vec3_near(v, kind == NKW_AXES_VEC3 ? trs.translation : trs.scale, 5e-6);
}

static void samples_of_mirrored_tracks_are_mirrored_samples(void **state)
{
    (void)state;
    static const float times[4] = {0, 0.5f, 1.25f, 2};
    static rig_of_test t;
    for (uint64_t seed = 1; seed < 300; seed++) {
        random_source r = random_from(seed);
        float values[48];
        const nkw_axes_kind kind = seed % 3 == 0 ? NKW_AXES_QUAT : seed % 3 == 1 ? NKW_AXES_VEC3 : NKW_AXES_SCALE;
        const nkw_interpolation how = (nkw_interpolation)(seed / 3 % 3);
        const size_t width = NKW_AXES_WIDTH(kind), size = how == NKW_INTERPOLATION_CUBICSPLINE ? 3 * width : width;
        make_rig(&t, seed);
        for (size_t i = 0; i < 48; i++)
            values[i] = random_between(&r, -0.5f, 0.5f);
        for (size_t k = 0; k < 4 && kind == NKW_AXES_QUAT; k++)
            put_quat(values + k * size + (size > width ? width : 0), random_rotation(&r));
        const nkw_track track = {times, values, 4, width, kind == NKW_AXES_QUAT ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS,
                                 how, NULL};
        for (int n = 0; n < 8; n++)
            expect_mirrored_track(&t, track, kind, n ? random_between(&r, 0, 2) : 0.5f);
    }
}

static void a_track_that_does_not_fit_is_refused(void **state)
{
    (void)state;
    NKW_STACK_WORK(work, NKW_MIRROR_WORK(RIG));
    static rig_of_test t;
    const float time = 0, values[4] = {0, 0, 0, 1};
    float out[4] = {7, 7, 7, 7};
    nkw_track track = {&time, values, 1, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR, NULL};
    const nkw_work little = {work.data, work.bytes - 1};
    make_rig(&t, 4);
    assert_int_equal(nkw_track_mirror_rest(&track, &t.rig, RIG, NKW_AXES_QUAT, out, work), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_track_mirror_rest(&track, &t.rig, 1, NKW_AXES_VEC3, out, work), NKW_BAD_WIDTH);
    assert_int_equal(nkw_track_mirror_rest(&track, &t.rig, 1, NKW_AXES_ANGULAR, out, work), NKW_BAD_METHOD);
    assert_int_equal(nkw_track_mirror_rest(&track, &t.rig, 1, NKW_AXES_QUAT, out, little), NKW_TOO_SMALL);
    t.rig.plane = (nkw_mirror)3;
    assert_int_equal(nkw_track_mirror_rest(&track, &t.rig, 1, NKW_AXES_QUAT, out, work), NKW_BAD_METHOD);
    t.rig.plane = NKW_MIRROR_X;
    const int32_t pair[RIG] = {0, 2, 1, 3, 4, 5};
    t.rig.pair = pair;
    assert_int_equal(nkw_track_mirror_rest(&track, &t.rig, 1, NKW_AXES_QUAT, out, work), NKW_BAD_MIRROR);
    expect_bits(out[0], 7);
}

static void partners_are_found_by_their_places(void **state)
{
    (void)state;
    static rig_of_test t;
    nkw_mat4 models[RIG];
    int32_t pair[RIG];
    const nkw_skeleton skeleton = {rig_parents, RIG};
    for (uint64_t seed = 1; seed < 50; seed++) {
        make_rig(&t, seed);
        models_of(t.rest, models);
        assert_int_equal(nkw_mirror_pairs_from_models(&skeleton, models, NKW_MIRROR_X, 1e-3f, pair), 2);
        assert_memory_equal(pair, rig_pair, sizeof pair);
    }
    models[4].m[12] += 0.01f;
    assert_int_equal(nkw_mirror_pairs_from_models(&skeleton, models, NKW_MIRROR_X, 1e-3f, pair), 1);
    assert_true(pair[3] == 3 && pair[4] == 4 && pair[1] == 2);
    assert_int_equal(nkw_mirror_pairs_from_models(&skeleton, models, NKW_MIRROR_X, 0.02f, pair), 2);
    assert_int_equal(nkw_mirror_pairs_from_models(&skeleton, models, NKW_MIRROR_Z, 1e-3f, pair), 0);
    models[1].m[12] = NAN;
    assert_int_equal(nkw_mirror_pairs_from_models(&skeleton, models, NKW_MIRROR_X, 1e-3f, pair), 0);
    assert_true(pair[3] == 3 && pair[4] == 4); /* children of parents that have no partners */
}

/*
 * Left (1) a twist bone, then the arm (2) with a hand; right (4) the arm with a hand, then (6) a twist bone, all four in
 * one place but for rounding; two eyes nearer to the middle than the tolerance; a nose.
 */
static void ties_of_places_are_decided_by_descendants(void **state)
{
    (void)state;
    const int32_t parents[10] = {-1, 0, 0, 2, 0, 4, 0, 0, 0, 0}, want[10] = {0, 6, 4, 5, 2, 3, 1, 8, 7, 9};
    const nkw_vec3 at[10] = {{0, 1, 0},          {0.2f, 1.4f, 0},   {0.2f, 1.4f, 0}, {0.6f, 1.4f, 0},
                             {-0.2f, 1.4f, 0},   {-0.6f, 1.4f, 0},  {-0.2000001f, 1.4f, 0},
                             {0.004f, 1.7f, 0.1f}, {-0.004f, 1.7f, 0.1f}, {0.001f, 1.68f, 0.12f}};
    const nkw_skeleton skeleton = {parents, 10};
    nkw_mat4 models[10];
    int32_t pair[10];
    for (size_t j = 0; j < 10; j++) {
        nkw_trs trs = nkw_trs_identity();
        trs.translation = at[j];
        models[j] = nkw_mat4_from_trs(&trs);
    }
    assert_int_equal(nkw_mirror_pairs_from_models(&skeleton, models, NKW_MIRROR_X, 0.01f, pair), 4);
    assert_memory_equal(pair, want, sizeof pair);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(models_are_mirrored_through_the_rest_pose),
        cmocka_unit_test(axes_of_mirrored_behaviour_are_found_and_mirrored),
        cmocka_unit_test(where_the_axes_are_mirrored_it_is_the_plain_mirror),
        cmocka_unit_test(a_rig_that_cannot_be_mirrored_is_refused),
        cmocka_unit_test(names_of_tools_have_partners),
        cmocka_unit_test(samples_of_mirrored_tracks_are_mirrored_samples),
        cmocka_unit_test(a_track_that_does_not_fit_is_refused),
        cmocka_unit_test(partners_are_found_by_their_places),
        cmocka_unit_test(ties_of_places_are_decided_by_descendants),
    };
    return cmocka_run_group_tests_name("mirror", tests, NULL, NULL);
}
