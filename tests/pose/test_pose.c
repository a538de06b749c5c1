/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/views.h"

#define JOINTS 21

static void draw(random_source *r, nkw_trs trs[JOINTS])
{
    for (int j = 0; j < JOINTS; j++) {
        trs[j].translation = random_vec3(r, -5, 5);
        trs[j].rotation = random_rotation(r);
        trs[j].scale = random_vec3(r, 0.5f, 2);
    }
}

static void strides_are_padded_to_sixteen(void **state)
{
    (void)state;
    assert_int_equal(NKW_POSE_STRIDE(0), 0);
    assert_int_equal(NKW_POSE_STRIDE(1), 16);
    assert_int_equal(NKW_POSE_STRIDE(16), 16);
    assert_int_equal(NKW_POSE_STRIDE(17), 32);
    assert_int_equal(nkw_pose_floats(67), 800);
    assert_int_equal(nkw_pose_floats(67), NKW_POSE_FLOATS(67));
}

static void transforms_go_in_and_come_out_bit_for_bit(void **state)
{
    (void)state;
    random_source r = random_from(1);
    float pose[NKW_POSE_FLOATS(JOINTS)];
    nkw_trs in[JOINTS], out[JOINTS];
    draw(&r, in);
    in[3].translation.y = -0.0f;
    nkw_pose_from_trs(in, pose_span(pose, JOINTS));
    nkw_trs_from_pose(pose_view(pose, JOINTS), out);
    assert_memory_equal(in, out, sizeof in);
    nkw_trs one = nkw_pose_get(pose_view(pose, JOINTS), 20);
    assert_memory_equal(&one, &in[20], sizeof one);
    nkw_pose_set(pose_span(pose, JOINTS), 4, &one);
    nkw_trs_from_pose(pose_view(pose, JOINTS), out);
    assert_memory_equal(&out[4], &one, sizeof one);
    assert_memory_equal(&out[5], &in[5], sizeof one);
}

/* The sanitizer watches: no address is computed from NULL. */
static void a_pose_without_joints_may_be_null(void **state)
{
    (void)state;
    nkw_pose_view no_view = {NULL, 0};
    nkw_pose_span no_span = {NULL, 0};
    nkw_trs_view view = nkw_pose_components(no_view);
    nkw_trs_span span = nkw_pose_components_span(no_span);
    assert_true(!view.translation.z && !view.rotation.w && !view.scale.z);
    assert_true(!span.translation.z && !span.rotation.w && !span.scale.z);
    nkw_pose_identity(pose_span(NULL, 0));
    nkw_pose_from_trs(NULL, pose_span(NULL, 0));
    assert_int_equal(nkw_pose_validate(pose_view(NULL, 0), NULL), NKW_EMPTY);
}

static void a_pose_that_no_memory_holds_has_the_most_floats(void **state)
{
    (void)state;
    const size_t most = SIZE_MAX / 160 * 16;
    assert_true(nkw_pose_floats(most) == 10 * most);
    assert_true(nkw_pose_floats(most + 1) == SIZE_MAX);
    assert_true(nkw_pose_floats(SIZE_MAX) == SIZE_MAX);
}

static void views_and_spans_are_the_arrays_in_their_order(void **state)
{
    (void)state;
    float pose[NKW_POSE_FLOATS(JOINTS)] = {0};
    nkw_pose_span whole = {pose, JOINTS};
    nkw_trs_view view = nkw_pose_components(NKW_VIEW(nkw_pose, whole));
    nkw_trs_span span = nkw_pose_components_span(whole);
    const float *read[10] = {view.translation.x, view.translation.y, view.translation.z, view.rotation.x,
                             view.rotation.y,    view.rotation.z,    view.rotation.w,    view.scale.x,
                             view.scale.y,       view.scale.z};
    float *written[10] = {span.translation.x, span.translation.y, span.translation.z, span.rotation.x, span.rotation.y,
                          span.rotation.z,    span.rotation.w,    span.scale.x,       span.scale.y,    span.scale.z};
    for (size_t c = 0; c < 10; c++) {
        assert_ptr_equal(read[c], pose + 32 * c);
        assert_ptr_equal(written[c], pose + 32 * c);
    }
}

static void identity_fills_the_padding_too(void **state)
{
    (void)state;
    float pose[NKW_POSE_FLOATS(3)];
    nkw_pose_identity(pose_span(pose, 3));
    for (size_t i = 0; i < 160; i++)
        expect_bits(pose[i], i / 16 >= 6 ? 1.0f : 0.0f);
}

static void a_joint_beyond_the_last_is_the_identity_and_not_written(void **state)
{
    (void)state;
    float pose[NKW_POSE_FLOATS(3)] = {0};
    nkw_trs none = nkw_trs_identity(), got = nkw_pose_get(pose_view(pose, 3), 3);
    assert_memory_equal(&got, &none, sizeof got);
    nkw_pose_set(pose_span(pose, 3), 3, &none);
    for (size_t i = 0; i < 160; i++)
        expect_bits(pose[i], 0.0f);
}

static void expect_invalid(const float *pose, size_t joints, nkw_result result, size_t joint)
{
    size_t bad = 99;
    assert_int_equal(nkw_pose_validate(pose_view(pose, joints), &bad), result);
    assert_int_equal(bad, joint);
    assert_int_equal(nkw_pose_validate(pose_view(pose, joints), NULL), result);
}

static void validate_names_the_first_offender(void **state)
{
    (void)state;
    float pose[NKW_POSE_FLOATS(3)];
    nkw_pose_identity(pose_span(pose, 3));
    expect_invalid(pose, 3, NKW_OK, 0);
    expect_invalid(pose, 0, NKW_EMPTY, 0);
    pose[15] = NAN;
    expect_invalid(pose, 3, NKW_OK, 0);
    for (size_t c = 0; c < 10; c++) {
        nkw_pose_identity(pose_span(pose, 3));
        pose[16 * c + 2] = INFINITY;
        expect_invalid(pose, 3, NKW_NOT_FINITE, 2);
    }
    nkw_pose_identity(pose_span(pose, 3));
    pose[16 * 6 + 1] = 0.991f;
    expect_invalid(pose, 3, NKW_OK, 0);
    pose[16 * 6 + 1] = 0.989f;
    expect_invalid(pose, 3, NKW_NOT_UNIT, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(strides_are_padded_to_sixteen),
        cmocka_unit_test(transforms_go_in_and_come_out_bit_for_bit),
        cmocka_unit_test(a_pose_without_joints_may_be_null),
        cmocka_unit_test(a_pose_that_no_memory_holds_has_the_most_floats),
        cmocka_unit_test(views_and_spans_are_the_arrays_in_their_order),
        cmocka_unit_test(identity_fills_the_padding_too),
        cmocka_unit_test(a_joint_beyond_the_last_is_the_identity_and_not_written),
        cmocka_unit_test(validate_names_the_first_offender),
    };
    return cmocka_run_group_tests_name("pose", tests, NULL, NULL);
}
