/* SPDX-License-Identifier: MIT */
/* Poses, masks, layers and partners that do not fit: each reason by itself. */
#include <math.h>

#include "support/expect.h"
#include "support/views.h"

enum { JOINTS = 5, FLOATS = NKW_POSE_FLOATS(JOINTS) };

static float pose[FLOATS], out[FLOATS];
static const float mask[NKW_POSE_STRIDE(JOINTS)] = {1, 0, 0.5f, 1, 1};

/* All functions of two poses and a mask; none writes. */
static void expect_mismatch(nkw_pose_view a, nkw_pose_view b, nkw_mask_view m)
{
    nkw_pose_span to = pose_span(out, JOINTS);
    out[0] = 9.0f;
    assert_int_equal(nkw_pose_blend(a, b, 0.5f, m, to), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_blend_slerp(a, b, 0.5f, m, to), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_additive_apply(a, b, 1, m, NKW_ADDITIVE_LOCAL, to), NKW_MISMATCHED);
    expect_bits(out[0], 9.0f);
}

static void each_argument_of_another_number_of_joints_is_refused(void **state)
{
    (void)state;
    const nkw_pose_view all = pose_view(pose, JOINTS), few = pose_view(pose, JOINTS - 1);
    const nkw_mask_view none = mask_view(NULL, 0), whole = mask_view(mask, JOINTS), thin = mask_view(mask, JOINTS - 1);
    nkw_pose_identity(pose_span(pose, JOINTS));
    expect_mismatch(few, all, none);
    expect_mismatch(all, few, none);
    expect_mismatch(all, all, thin);
    assert_int_equal(nkw_pose_additive_build(few, all, NKW_ADDITIVE_LOCAL, pose_span(out, JOINTS)), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_additive_build(all, few, NKW_ADDITIVE_LOCAL, pose_span(out, JOINTS)), NKW_MISMATCHED);
    expect_bits(out[0], 9.0f);
    assert_int_equal(nkw_pose_blend_slerp(all, all, 0.5f, whole, pose_span(out, JOINTS)), NKW_OK);
    /* Layers: the second is wrong, in its pose or in its mask. */
    nkw_pose_layer layers[3] = {{all, 1, none}, {all, 1, whole}, {all, 1, none}};
    size_t bad = 9;
    assert_int_equal(nkw_pose_layers_blend(layers, 3, all, 0.5f, pose_span(out, JOINTS)), NKW_OK);
    layers[1].mask = thin;
    assert_int_equal(nkw_pose_layers_blend(layers, 3, all, 0.5f, pose_span(out, JOINTS)), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_layers_validate(layers, 3, JOINTS, &bad), NKW_MISMATCHED);
    assert_int_equal(bad, 1);
    layers[1].mask = whole;
    layers[1].pose = few;
    assert_int_equal(nkw_pose_layers_blend(layers, 3, all, 0.5f, pose_span(out, JOINTS)), NKW_MISMATCHED);
    assert_int_equal(nkw_pose_layers_validate(layers, 3, JOINTS, &bad), NKW_MISMATCHED);
    assert_int_equal(bad, 1);
}

static void numbers_of_layers_and_masks_are_checked(void **state)
{
    (void)state;
    const float numbers[7] = {0, 1, -0.5f, 1.5f, NAN, INFINITY, -INFINITY};
    const nkw_result of_mask[7] = {NKW_OK,         NKW_OK,         NKW_BAD_WEIGHTS, NKW_BAD_WEIGHTS,
                                   NKW_NOT_FINITE, NKW_NOT_FINITE, NKW_NOT_FINITE};
    const nkw_result of_layer[7] = {NKW_OK,         NKW_OK,         NKW_BAD_WEIGHTS, NKW_OK,
                                    NKW_NOT_FINITE, NKW_NOT_FINITE, NKW_NOT_FINITE};
    const nkw_pose_view all = pose_view(pose, JOINTS);
    for (size_t i = 0; i < 7; i++)
        for (size_t j = 0; j < JOINTS; j++) {
            float m[NKW_POSE_STRIDE(JOINTS)];
            size_t bad = 9;
            memcpy(m, mask, sizeof m);
            m[j] = numbers[i];
            assert_int_equal(nkw_mask_validate(mask_view(m, JOINTS), &bad), of_mask[i]);
            assert_int_equal(bad, of_mask[i] == NKW_OK ? 0 : j);
            /* In a layer after another, by its mask, and by its weight. */
            nkw_pose_layer layers[2] = {{all, 1, {NULL, 0}}, {all, 1, mask_view(m, JOINTS)}};
            assert_int_equal(nkw_pose_layers_validate(layers, 2, JOINTS, &bad), of_mask[i]);
            assert_int_equal(bad, of_mask[i] == NKW_OK ? 0 : 1);
            layers[1].weight = numbers[i];
            layers[1].mask = mask_view(NULL, 0);
            assert_int_equal(nkw_pose_layers_validate(layers, 2, JOINTS, &bad), of_layer[i]);
            assert_int_equal(bad, of_layer[i] == NKW_OK ? 0 : 1);
            layers[1].mask = mask_view(m, JOINTS);
            assert_int_equal(nkw_pose_layers_validate(layers, 2, JOINTS, &bad),
                             of_layer[i] == NKW_OK ? of_mask[i] : of_layer[i]);
        }
    nkw_pose_layer empty = {pose_view(NULL, 0), 1, {NULL, 0}};
    assert_int_equal(nkw_pose_layers_validate(&empty, 1, JOINTS, NULL), NKW_EMPTY);
    assert_int_equal(nkw_pose_layers_validate(&empty, 0, JOINTS, NULL), NKW_OK);
    assert_int_equal(nkw_pose_layers_validate(&empty, 0, 0, NULL), NKW_EMPTY);
    assert_int_equal(nkw_mask_validate(mask_view(NULL, JOINTS), NULL), NKW_OK);
    assert_int_equal(nkw_mask_validate(mask_view(mask, 0), NULL), NKW_EMPTY);
}

/* The partner of joint 1 has no partner itself. */
static void a_partner_without_a_partner_is_refused(void **state)
{
    (void)state;
    const int32_t wrong[5] = {-1, INT32_MIN, JOINTS, INT32_MAX, 2};
    out[0] = 9.0f;
    for (int i = 0; i < 5; i++) {
        int32_t pair[JOINTS] = {0, 3, 2, 3, 4};
        size_t bad = 9;
        pair[3] = wrong[i];
        assert_int_equal(nkw_pose_mirror(pose_view(pose, JOINTS), pair, NKW_MIRROR_X, pose_span(out, JOINTS), &bad),
                         NKW_BAD_MIRROR);
        assert_int_equal(bad, 1);
        expect_bits(out[0], 9.0f);
    }
}

static void unknown_sides_and_planes_are_refused(void **state)
{
    (void)state;
    const int32_t own[JOINTS] = {0, 1, 2, 3, 4};
    const nkw_pose_view p = pose_view(pose, JOINTS);
    const nkw_pose_span to = pose_span(out, JOINTS);
    size_t bad = 9;
    out[0] = 9.0f;
    assert_int_equal(nkw_pose_additive_build(p, p, (nkw_additive)2, to), NKW_BAD_METHOD);
    assert_int_equal(nkw_pose_additive_apply(p, p, 1, mask_view(NULL, 0), (nkw_additive)-1, to), NKW_BAD_METHOD);
    assert_int_equal(nkw_pose_mirror(p, own, (nkw_mirror)3, to, &bad), NKW_BAD_METHOD);
    assert_int_equal(bad, 0);
    expect_bits(out[0], 9.0f);
}

/* A mask of a layer without weight has no effect, whatever it holds. */
static void a_layer_without_weight_has_no_mask(void **state)
{
    (void)state;
    const float spoiled[NKW_POSE_STRIDE(JOINTS)] = {NAN, 7, -1, INFINITY, 0};
    float other[FLOATS], want[FLOATS];
    nkw_pose_identity(pose_span(pose, JOINTS));
    nkw_pose_identity(pose_span(other, JOINTS));
    pose[0] = 2;
    nkw_pose_layer layers[2] = {{pose_view(pose, JOINTS), 0.75f, {NULL, 0}}, {pose_view(other, JOINTS), 0, {NULL, 0}}};
    nkw_pose_layers_blend(layers, 2, pose_view(other, JOINTS), 0.25f, pose_span(want, JOINTS));
    layers[1].mask = mask_view(spoiled, JOINTS);
    nkw_pose_layers_blend(layers, 2, pose_view(other, JOINTS), 0.25f, pose_span(out, JOINTS));
    for (size_t c = 0; c < 10; c++)
        expect_floats_bits(out + c * NKW_POSE_STRIDE(JOINTS), want + c * NKW_POSE_STRIDE(JOINTS), JOINTS);
    expect_bits(out[0], 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_argument_of_another_number_of_joints_is_refused),
        cmocka_unit_test(numbers_of_layers_and_masks_are_checked),
        cmocka_unit_test(a_partner_without_a_partner_is_refused),
        cmocka_unit_test(unknown_sides_and_planes_are_refused),
        cmocka_unit_test(a_layer_without_weight_has_no_mask),
    };
    return cmocka_run_group_tests_name("blend_errors", tests, NULL, NULL);
}
