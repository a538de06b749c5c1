/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "views.h"

enum { JOINTS = 40, FLOATS = NKW_POSE_FLOATS(JOINTS), STRIDE = NKW_POSE_STRIDE(JOINTS) };

static void a_branch_rises_joint_by_joint(void **state)
{
    (void)state;
    static const int32_t parents[8] = {-1, 0, 1, 2, 3, 0, 2, INT32_MAX};
    static const float thirds[8] = {0, 1.0f / 3.0f, 2.0f / 3.0f, 1, 1, 0, 1, 0}, none[8] = {0};
    static const float depths[] = {1.0f, 0.0f, -2.0f, NAN};
    const nkw_skeleton skeleton = {parents, 8};
    float mask[NKW_POSE_STRIDE(8)], whole[NKW_POSE_STRIDE(8)];
    mask[15] = 7.0f;
    assert_int_equal(nkw_mask_from_branch(&skeleton, 1, 3.0f, mask_span(mask, 8)), NKW_OK);
    expect_floats_bits(mask, thirds, 8);
    expect_floats_bits(mask + 8, none, 8);
    assert_int_equal(nkw_mask_from_branch(&skeleton, 8, 3.0f, mask_span(mask, 8)), NKW_OK);
    expect_floats_bits(mask, none, 8);
    for (size_t i = 0; i < 4; i++) {
        nkw_mask_from_branch(&skeleton, 2, depths[i], mask_span(mask, 8));
        nkw_mask_from_subtree(&skeleton, 2, mask_span(whole, 8));
        expect_floats_bits(mask, whole, 16);
    }
    nkw_mask_from_branch(&skeleton, 1, INFINITY, mask_span(mask, 8));
    expect_floats_bits(mask, none, 8);
    assert_int_equal(nkw_mask_from_branch(&skeleton, 1, 3.0f, mask_span(mask, 7)), NKW_MISMATCHED);
}

static void each_joint_has_its_own_time(void **state)
{
    (void)state;
    static const float times[8] = {0.25f, 0.5f, 1.0f, 2.0f, 0.0f, -1.0f, NAN, INFINITY}, zeros[8] = {0};
    static const float half[8] = {1, 1, 0.5f, 0.25f, 1, 1, 1, 0}, begin[8] = {0, 0, 0, 0, 1, 1, 1, 0};
    float mask[NKW_POSE_STRIDE(8)];
    assert_int_equal(nkw_mask_from_times(times, 0.5f, NKW_EASE_LINEAR, mask_span(mask, 8)), NKW_OK);
    expect_floats_bits(mask, half, 8);
    expect_floats_bits(mask + 8, zeros, 8);
    nkw_mask_from_times(times, -1.0f, NKW_EASE_LINEAR, mask_span(mask, 8));
    expect_floats_bits(mask, begin, 8);
    nkw_mask_from_times(times, NAN, NKW_EASE_LINEAR, mask_span(mask, 8));
    expect_floats_bits(mask, begin, 8);
    nkw_mask_from_times(times, 0.5f, NKW_EASE_QUAD_IN, mask_span(mask, 8)); /* t^2 */
    expect_near(mask[2], 0.25, 1e-7);
    expect_near(mask[3], 0.0625, 1e-7);
    for (int k = 0; k <= 64; k++) { /* an ease that overshoots stays a mask */
        nkw_mask_from_times(times, (float)k / 64.0f, NKW_EASE_BACK_OUT, mask_span(mask, 8));
        assert_int_equal(nkw_mask_validate(mask_view(mask, 8), NULL), NKW_OK);
    }
}

/* ---- Rotations in model space ---- */

static void draw_pose(random_source *r, int32_t *parents, float *pose)
{
    for (size_t j = 0; j < JOINTS; j++) {
        const nkw_trs trs = {random_vec3(r, -1, 1), random_rotation(r), random_vec3(r, 0.5f, 2.0f)};
        parents[j] = j ? (int32_t)(random_bits(r) % j) : -1;
        parents[j] = j % 3 ? (int32_t)j - 1 : parents[j];
        nkw_pose_set(pose_span(pose, JOINTS), j, &trs);
    }
}

static void rotate_in_double(nkw_quat q, double *v)
{
    const double x = (double)q.x, y = (double)q.y, z = (double)q.z, w = (double)q.w;
    const double tx = 2 * (y * v[2] - z * v[1]), ty = 2 * (z * v[0] - x * v[2]), tz = 2 * (x * v[1] - y * v[0]);
    const double to[3] = {v[0] + w * tx + (y * tz - z * ty), v[1] + w * ty + (z * tx - x * tz),
                          v[2] + w * tz + (x * ty - y * tx)};
    memcpy(v, to, sizeof to);
}

/* A vector that is turned by the rotations of the joint, its parent, the parent of that ... one after another. */
static void composed_rotations_are_those_of_all_parents(void **state)
{
    (void)state;
    random_source r = random_from(61);
    static float pose[FLOATS], out[FLOATS];
    int32_t parents[JOINTS];
    for (int round = 0; round < 50; round++) {
        draw_pose(&r, parents, pose);
        const nkw_skeleton skeleton = {parents, JOINTS};
        assert_int_equal(nkw_skeleton_compose_rotations(&skeleton, pose_view(pose, JOINTS), pose_span(out, JOINTS)),
                         NKW_OK);
        for (size_t j = 0; j < JOINTS; j++) {
            double a[3] = {0.6, -0.8, 0.5}, b[3] = {0.6, -0.8, 0.5};
            for (int32_t k = (int32_t)j; k >= 0; k = parents[k])
                rotate_in_double(nkw_pose_get(pose_view(pose, JOINTS), (size_t)k).rotation, a);
            rotate_in_double(nkw_pose_get(pose_view(out, JOINTS), j).rotation, b);
            for (int c = 0; c < 3; c++)
                expect_near(b[c], a[c], 1e-5);
        }
        expect_floats_bits(out, pose, 3 * STRIDE);
        expect_floats_bits(out + 7 * STRIDE, pose + 7 * STRIDE, 3 * STRIDE);
    }
}

/* In place; the worst of these is 1.42 u. */
static void separated_rotations_are_those_before(void **state)
{
    (void)state;
    random_source r = random_from(62);
    static float pose[FLOATS], out[FLOATS];
    int32_t parents[JOINTS];
    double worst = 0.0;
    for (int round = 0; round < 2000; round++) {
        draw_pose(&r, parents, pose);
        const nkw_skeleton skeleton = {parents, JOINTS};
        memcpy(out, pose, sizeof out);
        nkw_skeleton_compose_rotations(&skeleton, pose_view(out, JOINTS), pose_span(out, JOINTS));
        nkw_skeleton_separate_rotations(&skeleton, pose_view(out, JOINTS), pose_span(out, JOINTS));
        for (size_t j = 0; j < JOINTS; j++) {
            double sum = 0.0;
            for (size_t c = 3; c < 7; c++)
                sum += pow((double)out[c * STRIDE + j] - (double)pose[c * STRIDE + j], 2.0);
            worst = fmax(worst, sqrt(sum));
        }
    }
    assert_true(worst <= 1.5 * 0x1p-24);
}

static nkw_quat turn(float x, float y, float angle)
{
    const nkw_quat q = {x * sinf(0.5f * angle), y * sinf(0.5f * angle), 0.0f, cosf(0.5f * angle)};
    return q;
}

static void set_turn(float *pose, size_t joint, nkw_quat q)
{
    const nkw_trs trs = {NKW_VEC3_ZERO, q, {1, 1, 1}};
    nkw_pose_set(pose_span(pose, 3), joint, &trs);
}

static void expect_turn(const float *pose, size_t joint, nkw_quat want)
{
    const nkw_quat q = nkw_pose_get(pose_view(pose, 3), joint).rotation;
    expect_near(fabsf(q.x * want.x + q.y * want.y + q.z * want.z + q.w * want.w), 1.0, 1e-6);
}

static const int32_t body[3] = {-1, 0, 1}; /* hips, chest, head */
static const nkw_skeleton torso = {body, 3};

/* A body that bows by 0.7 about x and aims by 0.5 about y: in model space the head turns about the upright y. */
static void an_aim_is_added_in_model_space(void **state)
{
    (void)state;
    float base[NKW_POSE_FLOATS(3)], aim[NKW_POSE_FLOATS(3)], ref[NKW_POSE_FLOATS(3)], mask[NKW_POSE_STRIDE(3)];
    for (size_t j = 0; j < 3; j++) {
        set_turn(base, j, j == 0 ? turn(1, 0, 0.7f) : nkw_quat_identity());
        set_turn(aim, j, j == 1 ? turn(0, 1, 0.5f) : nkw_quat_identity());
        set_turn(ref, j, nkw_quat_identity());
    }
    nkw_mask_from_branch(&torso, 1, 2.0f, mask_span(mask, 3));
    nkw_skeleton_compose_rotations(&torso, pose_view(aim, 3), pose_span(aim, 3));
    nkw_skeleton_compose_rotations(&torso, pose_view(ref, 3), pose_span(ref, 3));
    nkw_pose_additive_build(pose_view(aim, 3), pose_view(ref, 3), NKW_ADDITIVE_PARENT, pose_span(aim, 3));
    nkw_skeleton_compose_rotations(&torso, pose_view(base, 3), pose_span(base, 3));
    nkw_pose_additive_apply(pose_view(base, 3), pose_view(aim, 3), 1.0f, mask_view(mask, 3), NKW_ADDITIVE_PARENT,
                            pose_span(base, 3));
    expect_turn(base, 0, turn(1, 0, 0.7f));
    expect_turn(base, 2, nkw_quat_mul(turn(0, 1, 0.5f), turn(1, 0, 0.7f)));
    nkw_skeleton_separate_rotations(&torso, pose_view(base, 3), pose_span(base, 3));
    expect_turn(base, 0, turn(1, 0, 0.7f));
    const nkw_quat up = turn(1, 0, -0.7f), down = turn(1, 0, 0.7f);
    expect_turn(base, 1, nkw_quat_mul(up, nkw_quat_mul(turn(0, 1, 0.25f), down))); /* half of the aim, by the mask */
    expect_turn(base, 2, nkw_quat_mul(up, nkw_quat_mul(turn(0, 1, 0.25f), down)));
}

/* The chest of the layer keeps its direction in model space, though the hips below turn. */
static void a_layer_keeps_its_rotations_in_model_space(void **state)
{
    (void)state;
    float base[NKW_POSE_FLOATS(3)], layer[NKW_POSE_FLOATS(3)], mask[NKW_POSE_STRIDE(3)];
    for (size_t j = 0; j < 3; j++) {
        set_turn(base, j, turn(0, 1, 0.3f));
        set_turn(layer, j, turn(1, 0, 0.2f));
    }
    nkw_mask_from_subtree(&torso, 1, mask_span(mask, 3));
    nkw_skeleton_compose_rotations(&torso, pose_view(base, 3), pose_span(base, 3));
    nkw_skeleton_compose_rotations(&torso, pose_view(layer, 3), pose_span(layer, 3));
    nkw_pose_blend(pose_view(base, 3), pose_view(layer, 3), 1.0f, mask_view(mask, 3), pose_span(base, 3));
    nkw_skeleton_separate_rotations(&torso, pose_view(base, 3), pose_span(base, 3));
    expect_turn(base, 0, turn(0, 1, 0.3f));
    expect_turn(base, 1, nkw_quat_mul(turn(0, 1, -0.3f), turn(1, 0, 0.4f)));
    expect_turn(base, 2, turn(1, 0, 0.2f));
}

static void different_joints_and_zeros_are_defined(void **state)
{
    (void)state;
    float pose[NKW_POSE_FLOATS(3)], out[NKW_POSE_FLOATS(3)] = {9.0f};
    assert_int_equal(nkw_skeleton_compose_rotations(&torso, pose_view(pose, 2), pose_span(out, 3)), NKW_MISMATCHED);
    assert_int_equal(nkw_skeleton_separate_rotations(&torso, pose_view(pose, 3), pose_span(out, 2)), NKW_MISMATCHED);
    const nkw_skeleton none = {NULL, 0};
    assert_int_equal(nkw_skeleton_compose_rotations(&none, pose_view(NULL, 0), pose_span(NULL, 0)), NKW_OK);
    assert_int_equal(nkw_skeleton_separate_rotations(&none, pose_view(NULL, 0), pose_span(NULL, 0)), NKW_OK);
    expect_bits(out[0], 9.0f);
    const nkw_quat zero = {0, 0, 0, 0};
    for (size_t j = 0; j < 3; j++)
        set_turn(pose, j, j == 1 ? zero : turn(1, 0, 0.2f));
    nkw_skeleton_separate_rotations(&torso, pose_view(pose, 3), pose_span(out, 3));
    expect_turn(out, 2, turn(1, 0, 0.2f));
    nkw_skeleton_compose_rotations(&torso, pose_view(pose, 3), pose_span(out, 3));
    expect_bits(nkw_pose_get(pose_view(out, 3), 2).rotation.w, 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_branch_rises_joint_by_joint),
        cmocka_unit_test(each_joint_has_its_own_time),
        cmocka_unit_test(composed_rotations_are_those_of_all_parents),
        cmocka_unit_test(separated_rotations_are_those_before),
        cmocka_unit_test(an_aim_is_added_in_model_space),
        cmocka_unit_test(a_layer_keeps_its_rotations_in_model_space),
        cmocka_unit_test(different_joints_and_zeros_are_defined),
    };
    return cmocka_run_group_tests_name("layer", tests, NULL, NULL);
}
