/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "random.h"
#include "support/expect.h"

#define PI 3.14159265358979323846

static nkw_result trace_of(const nkw_keyframe *keys, size_t count, float time, nkw_position_method position,
                           nkw_orientation_method orientation, nkw_keyframe_trace *trace)
{
    nkw_keyframe_options options = {position, orientation, NKW_KEYFRAME_RULE_LIBRARY};
    return nkw_keyframes_trace(keys, count, time, &options, trace);
}

static nkw_quat yaw_pitch_roll(double yaw, double pitch, double roll)
{
    nkw_vec3 angles = {(float)pitch, (float)yaw, (float)roll};
    return nkw_quat_from_euler(angles, NKW_EULER_YXZ);
}

/* Scene 1 of the exercise. */
static void scene_1(nkw_keyframe keys[7])
{
    const nkw_keyframe scene[7] = {
        {0, {-1.0f, 0.5f, -1.5f}, yaw_pitch_roll(PI * 0.6, 0, 0)},
        {1, {0.0f, 1.0f, 0.0f}, yaw_pitch_roll(PI * 1.2, PI / 3, PI / 4)},
        {2, {-2.0f, 0.5f, 1.0f}, yaw_pitch_roll(PI, -PI / 6, 0)},
        {3, {0.0f, 0.4f, 1.5f}, yaw_pitch_roll(PI * 1.2, 0, 0)},
        {4, {1.0f, 0.35f, 1.75f}, yaw_pitch_roll(PI * -0.4, PI / 12, 0)},
        {5, {1.5f, 0.6f, 0.0f}, yaw_pitch_roll(0, 0, 0)},
        {6, {1.0f, 1.0f, -1.0f}, yaw_pitch_roll(PI / 3, 0, 0)},
    };
    memcpy(keys, scene, sizeof scene);
}

static void scene_2(nkw_keyframe keys[2])
{
    const nkw_keyframe scene[2] = {
        {0, {-1.0f, 0.5f, 0.0f}, yaw_pitch_roll(PI * 0.6, 0, 0)},
        {1, {1.0f, 0.5f, 0.0f}, yaw_pitch_roll(PI * 1.2, PI / 3, PI / 4)},
    };
    memcpy(keys, scene, sizeof scene);
}

/* One row of the exercise's table: what was asked, and the matrix that must come. */
typedef struct row {
    char scene[24], position[24], orientation[16];
    int count;
    float time;
    float m[16];
} row;

static int read_row(FILE *file, row *r)
{
    int read = fscanf(file, "%23[^,],%d,%23[^,],%15[^,],%f,%*d,%*f", r->scene, &r->count, r->position, r->orientation,
                      &r->time);
    for (int i = 0; i < 16 && read == 5; i++)
        if (fscanf(file, ",%f", &r->m[i]) != 1)
            return 0;
    return read == 5 && fscanf(file, " ") == 0;
}

static nkw_position_method position_of(const row *r)
{
    return strcmp(r->position, "linear") == 0    ? NKW_POSITION_LINEAR
           : strcmp(r->position, "hermite") == 0 ? NKW_POSITION_HERMITE
           : strcmp(r->position, "bspline") == 0 ? NKW_POSITION_BSPLINE
                                                 : NKW_POSITION_BEZIER;
}

static nkw_orientation_method orientation_of(const row *r)
{
    return strcmp(r->orientation, "euler") == 0  ? NKW_ORIENTATION_EULER
           : strcmp(r->orientation, "quat") == 0 ? NKW_ORIENTATION_SLERP
                                                 : NKW_ORIENTATION_STEP;
}

/* Where the two rules agree: the library clamps Bezier too (the rows bezier_clamped), and its steps are half open. */
static int is_ours(const row *r, const nkw_keyframe *keys)
{
    float first = keys[0].time, last = keys[r->count - 1].time;
    int outside = r->time < first || r->time > last;
    if (strcmp(r->position, "bezier") == 0 && outside)
        return 0;
    if (strcmp(r->orientation, "none") != 0)
        return 1;
    for (int k = 1; k < r->count; k++)
        if (r->time == keys[k].time)
            return 0;
    return r->time <= last;
}

static void every_row_of_the_exercise_is_met(void **state)
{
    (void)state;
    nkw_keyframe one[7], two[2];
    int rows = 0, compared = 0, programs = 0;
    row r;
    scene_1(one);
    scene_2(two);
    FILE *file = fopen(NKW_COURSEWORK_CSV, "r");
    assert_non_null(file);
    assert_int_equal(fscanf(file, "%*[^\n] "), 0);
    while (read_row(file, &r)) {
        const nkw_keyframe *keys = strcmp(r.scene, "scene2") == 0 ? two : one;
        nkw_mat4 m;
        rows++;
        assert_int_equal(nkw_keyframes_sample(keys, (size_t)r.count, r.time, position_of(&r), orientation_of(&r), &m),
                         NKW_OK);
        if (is_ours(&r, keys)) {
            expect_floats_near(m.m, r.m, 16, 2e-6);
            compared++;
        }
        if (strcmp(r.position, "bezier_clamped") == 0)
            continue;
        nkw_keyframe_options exercise = {position_of(&r), orientation_of(&r), NKW_KEYFRAME_RULE_EXERCISE};
        assert_int_equal(nkw_keyframes_sample_as(keys, (size_t)r.count, r.time, &exercise, &m), NKW_OK);
        expect_floats_near(m.m, r.m, 16, 2e-6);
        programs++;
    }
    fclose(file);
    assert_int_equal(rows, 2760);
    assert_int_equal(compared, 2589);
    assert_int_equal(programs, 2760 - 276);
}

/* docs/coursework.md, "Where this library differs". */
static void the_rule_of_the_exercise_is_an_option(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    nkw_keyframe_options options = {NKW_POSITION_STEP, NKW_ORIENTATION_STEP, NKW_KEYFRAME_RULE_EXERCISE};
    nkw_keyframe_trace trace;
    nkw_mat4 m = nkw_mat4_identity();
    scene_1(keys);
    for (int k = 0; k < 7; k++) {
        size_t segment = k > 0 ? (size_t)k - 1 : 0;
        assert_int_equal(nkw_keyframes_trace(keys, 7, (float)k, &options, &trace), NKW_OK);
        assert_int_equal(trace.segment.index, segment);
        expect_bits(trace.segment.t, k > 0 ? 1.0f : 0.0f);
        expect_vec3_bits(trace.position, keys[segment].position);
    }
    assert_int_equal(nkw_keyframes_sample_as(keys, 1, 0.0f, &options, &m), NKW_EMPTY);
    options.rule = (nkw_keyframe_rule)2;
    assert_int_equal(nkw_keyframes_sample_as(keys, 7, 0.0f, &options, &m), NKW_BAD_METHOD);
    nkw_mat4 identity = nkw_mat4_identity();
    expect_floats_bits(m.m, identity.m, 16);
}

/* Three keys at one time: the first segment that contains it. */
static void the_exercise_takes_the_first_of_segments_of_one_time(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    nkw_keyframe_options options = {NKW_POSITION_LINEAR, NKW_ORIENTATION_STEP, NKW_KEYFRAME_RULE_EXERCISE};
    nkw_keyframe_trace trace;
    scene_1(keys);
    keys[3].time = keys[4].time = 2.0f;
    assert_int_equal(nkw_keyframes_trace(keys, 7, 2.0f, &options, &trace), NKW_OK);
    assert_int_equal(trace.segment.index, 1);
    expect_vec3_bits(trace.position, keys[2].position);
}

/* At a pitch of 90 degrees, ConvMatToEuler loses roll. */
static void the_exercise_loses_roll_at_the_pole(void **state)
{
    (void)state;
    nkw_keyframe keys[2] = {{0, {0, 0, 0}, yaw_pitch_roll(0.5, PI / 2, 0.75)}, {1, {0, 0, 0}, yaw_pitch_roll(0, 0, 0)}};
    nkw_keyframe_options options = {NKW_POSITION_LINEAR, NKW_ORIENTATION_EULER, NKW_KEYFRAME_RULE_LIBRARY};
    nkw_mat4 ours, theirs, key = nkw_mat4_from_quat(keys[0].orientation);
    assert_int_equal(nkw_keyframes_sample_as(keys, 2, 0.0f, &options, &ours), NKW_OK);
    options.rule = NKW_KEYFRAME_RULE_EXERCISE;
    assert_int_equal(nkw_keyframes_sample_as(keys, 2, 0.0f, &options, &theirs), NKW_OK);
    assert_true(nkw_mat4_equal_within(&ours, &key, 1e-6f));
    assert_false(nkw_mat4_equal_within(&theirs, &key, 0.1f));
}

static void step_begins_at_its_key_and_holds_the_last(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    nkw_mat4 m;
    scene_1(keys);
    for (int k = 0; k < 7; k++) {
        nkw_mat4 want = nkw_mat4_from_quat(keys[k].orientation);
        for (int half = 0; half < 2; half++) {
            nkw_keyframes_sample(keys, 7, (float)k + 0.5f * (float)half, NKW_POSITION_STEP, NKW_ORIENTATION_STEP, &m);
            expect_floats_bits(m.m, want.m, 12);
            expect_vec3_bits(nkw_mat4_translation(&m), keys[k].position);
        }
    }
}

static void keys_come_back_bit_for_bit_at_their_own_time(void **state)
{
    (void)state;
    static const nkw_position_method through[] = {NKW_POSITION_LINEAR, NKW_POSITION_HERMITE, NKW_POSITION_CATMULL_ROM};
    nkw_keyframe keys[7];
    nkw_mat4 m;
    scene_1(keys);
    for (int k = 0; k < 7; k++) {
        nkw_mat4 want = nkw_mat4_from_quat(keys[k].orientation);
        for (int i = 0; i < 3; i++) {
            nkw_keyframes_sample(keys, 7, keys[k].time, through[i], NKW_ORIENTATION_SLERP, &m);
            expect_vec3_bits(nkw_mat4_translation(&m), keys[k].position);
            expect_floats_near(m.m, want.m, 12, 0);
        }
    }
}

static void outside_the_keys_every_method_clamps(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    scene_1(keys);
    for (int p = NKW_POSITION_LINEAR; p <= NKW_POSITION_MAKIMA; p++) {
        for (int o = NKW_ORIENTATION_STEP; o <= NKW_ORIENTATION_BSPLINE; o++) {
            static const float outside[4] = {-1e30f, -0.5f, 6.5f, INFINITY};
            for (int i = 0; i < 4; i++) {
                nkw_mat4 got, want;
                nkw_keyframes_sample(keys, 7, outside[i], (nkw_position_method)p, (nkw_orientation_method)o, &got);
                nkw_keyframes_sample(keys, 7, i < 2 ? 0.0f : 6.0f, (nkw_position_method)p, (nkw_orientation_method)o,
                                     &want);
                expect_floats_bits(got.m, want.m, 16);
            }
        }
    }
}

static void incomplete_bezier_groups_hold_the_last_whole_one(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    nkw_mat4 m;
    scene_1(keys);
    for (size_t count = 5; count <= 6; count++)
        for (float time = 3.0f; time < 6.0f; time += 0.25f) {
            nkw_keyframes_sample(keys, count, time, NKW_POSITION_BEZIER, NKW_ORIENTATION_STEP, &m);
            expect_vec3_bits(nkw_mat4_translation(&m), keys[3].position);
        }
    for (size_t count = 1; count <= 3; count++)
        for (float time = -1.0f; time < 4.0f; time += 0.25f) {
            nkw_keyframes_sample(keys, count, time, NKW_POSITION_BEZIER, NKW_ORIENTATION_STEP, &m);
            expect_vec3_bits(nkw_mat4_translation(&m), keys[0].position);
        }
}

static void bspline_misses_the_ends_by_a_sixth_of_the_end_segment(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    nkw_mat4 m;
    scene_1(keys);
    nkw_keyframes_sample(keys, 7, 0, NKW_POSITION_BSPLINE, NKW_ORIENTATION_STEP, &m);
    expect_vec3_near(nkw_mat4_translation(&m), nkw_vec3_lerp(keys[0].position, keys[1].position, 1 / 6.0f), 2e-7);
    nkw_keyframes_sample(keys, 7, 6, NKW_POSITION_BSPLINE, NKW_ORIENTATION_STEP, &m);
    expect_vec3_near(nkw_mat4_translation(&m), nkw_vec3_lerp(keys[6].position, keys[5].position, 1 / 6.0f), 2e-7);
}

static void uneven_times_move_the_bezier_parameter_by_time(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    nkw_keyframe_trace trace;
    scene_1(keys);
    keys[1].time = 0.1f;
    keys[3].time = 4.0f;
    assert_int_equal(trace_of(keys, 4, 1.0f, NKW_POSITION_BEZIER, NKW_ORIENTATION_SLERP, &trace), NKW_OK);
    expect_bits(trace.parameter, 0.25f);
    assert_int_equal(trace.segment.index, 1);
}

static void one_key_is_itself_and_none_is_an_error(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    nkw_mat4 m = nkw_mat4_identity(), untouched = m;
    scene_1(keys);
    for (int p = NKW_POSITION_LINEAR; p <= NKW_POSITION_MAKIMA; p++)
        for (int o = NKW_ORIENTATION_STEP; o <= NKW_ORIENTATION_BSPLINE; o++) {
            m = untouched;
            assert_int_equal(nkw_keyframes_sample(keys, 0, 1, (nkw_position_method)p, (nkw_orientation_method)o, &m),
                             NKW_EMPTY);
            expect_floats_bits(m.m, untouched.m, 16);
            assert_int_equal(nkw_keyframes_sample(keys, 1, 1, (nkw_position_method)p, (nkw_orientation_method)o, &m),
                             NKW_OK);
            expect_vec3_near(nkw_mat4_translation(&m), keys[0].position, 1e-7);
            nkw_mat4 want = nkw_mat4_from_quat(keys[0].orientation);
            expect_floats_near(m.m, want.m, 12, 3e-7);
        }
}

static void unknown_methods_are_refused(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    nkw_mat4 m = nkw_mat4_identity(), untouched = m;
    scene_1(keys);
    assert_int_equal(
        nkw_keyframes_sample(keys, 7, 1, (nkw_position_method)(NKW_POSITION_MAKIMA + 1), NKW_ORIENTATION_STEP, &m),
        NKW_BAD_METHOD);
    assert_int_equal(nkw_keyframes_sample(keys, 7, 1, (nkw_position_method)-1, NKW_ORIENTATION_STEP, &m),
                     NKW_BAD_METHOD);
    assert_int_equal(nkw_keyframes_sample(keys, 7, 1, NKW_POSITION_STEP, (nkw_orientation_method)8, &m),
                     NKW_BAD_METHOD);
    expect_floats_bits(m.m, untouched.m, 16);
}

static void trace_says_what_sample_did(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    scene_1(keys);
    for (int p = NKW_POSITION_LINEAR; p <= NKW_POSITION_MAKIMA; p++) {
        for (int o = NKW_ORIENTATION_STEP; o <= NKW_ORIENTATION_BSPLINE; o++) {
            for (float time = -0.5f; time < 7.0f; time += 0.07f) {
                nkw_mat4 m;
                nkw_keyframe_trace trace;
                nkw_keyframes_sample(keys, 7, time, (nkw_position_method)p, (nkw_orientation_method)o, &m);
                trace_of(keys, 7, time, (nkw_position_method)p, (nkw_orientation_method)o, &trace);
                nkw_mat4 same = nkw_mat4_from_mat3(&trace.rotation, trace.position);
                expect_floats_bits(same.m, m.m, 16);
                nkw_vec3 sum = {0, 0, 0};
                for (size_t i = 0; i < trace.control_count; i++)
                    sum = nkw_vec3_add_scaled(sum, trace.control[i], trace.weight[i]);
                expect_vec3_near(sum, trace.position, 2e-6);
            }
        }
    }
}

static void trace_of_slerp_has_the_textbook_weights(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    nkw_keyframe_trace trace;
    scene_1(keys);
    trace_of(keys, 7, 0.3f, NKW_POSITION_LINEAR, NKW_ORIENTATION_SLERP, &trace);
    nkw_quat a = nkw_quat_scale(trace.orientation[0], trace.orientation_weight[0]);
    nkw_quat b = nkw_quat_scale(trace.orientation[1], trace.orientation_weight[1]);
    expect_quat_near(nkw_quat_add(a, b), nkw_quat_slerp(keys[0].orientation, keys[1].orientation, 0.3f), 5e-7);
    assert_true(nkw_quat_dot(trace.orientation[0], trace.orientation[1]) >= 0);
    expect_near(trace.half_angle, 0.5 * (double)nkw_quat_angle(keys[0].orientation, keys[1].orientation), 1e-7);
}

static void trace_of_euler_shows_the_unwrapped_yaw(void **state)
{
    (void)state;
    nkw_keyframe keys[2];
    nkw_keyframe_trace trace;
    scene_2(keys);
    trace_of(keys, 2, 0.5f, NKW_POSITION_LINEAR, NKW_ORIENTATION_EULER, &trace);
    /* 108 degrees becomes -252, next to -144. */
    expect_near(trace.angles[0].y, -252 * PI / 180, 1e-6);
    expect_near(trace.angles[1].y, -144 * PI / 180, 1e-6);
}

static void validate_names_the_first_offender(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    size_t bad = 99;
    scene_1(keys);
    assert_int_equal(nkw_keyframes_validate(keys, 7, &bad), NKW_OK);
    assert_int_equal(bad, 0);
    assert_int_equal(nkw_keyframes_validate(keys, 7, NULL), NKW_OK);
    assert_int_equal(nkw_keyframes_validate(NULL, 0, &bad), NKW_EMPTY);
}

static void validate_refuses_numbers_that_are_not_finite(void **state)
{
    (void)state;
    for (int field = 0; field < 8; field++) {
        nkw_keyframe keys[7];
        size_t bad = 99;
        scene_1(keys);
        float *fields[8] = {&keys[3].time,          &keys[3].position.x,    &keys[3].position.y,
                            &keys[3].position.z,    &keys[3].orientation.x, &keys[3].orientation.y,
                            &keys[3].orientation.z, &keys[3].orientation.w};
        *fields[field] = field % 2 ? NAN : INFINITY;
        assert_int_equal(nkw_keyframes_validate(keys, 7, &bad), NKW_NOT_FINITE);
        assert_int_equal(bad, 3);
    }
}

static void validate_refuses_times_that_descend_but_not_equal_ones(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    size_t bad = 99;
    scene_1(keys);
    keys[4].time = keys[3].time;
    assert_int_equal(nkw_keyframes_validate(keys, 7, &bad), NKW_OK);
    keys[5].time = 2.5f;
    assert_int_equal(nkw_keyframes_validate(keys, 7, &bad), NKW_NOT_ASCENDING);
    assert_int_equal(bad, 5);
}

static void validate_refuses_orientations_that_are_not_unit(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    size_t bad = 99;
    scene_1(keys);
    nkw_quat unit = keys[6].orientation;
    const float lengths[2] = {0.985f, 1.015f}, near[2] = {0.995f, 1.005f};
    for (int i = 0; i < 2; i++) {
        keys[6].orientation = nkw_quat_scale(unit, lengths[i]);
        assert_int_equal(nkw_keyframes_validate(keys, 7, &bad), NKW_NOT_UNIT);
        assert_int_equal(bad, 6);
        keys[6].orientation = nkw_quat_scale(unit, near[i]);
        assert_int_equal(nkw_keyframes_validate(keys, 7, &bad), NKW_OK);
    }
}

static void anything_at_all_is_sampled_within_the_keys(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 20000; i++) {
        nkw_keyframe keys[9];
        size_t count = 1 + (size_t)(random_bits(&r) % 9);
        for (size_t k = 0; k < count; k++) {
            float f[8];
            for (int j = 0; j < 8; j++)
                f[j] = float_of((uint32_t)random_bits(&r));
            memcpy(&keys[k], f, sizeof f);
        }
        /* The keys end where the array ends, so that a sanitizer sees a step beyond. */
        nkw_keyframe *exact = (nkw_keyframe *)malloc(count * sizeof *exact);
        assert_non_null(exact);
        memcpy(exact, keys, count * sizeof *exact);
        nkw_keyframe_trace trace;
        nkw_position_method p = (nkw_position_method)(random_bits(&r) % 6);
        nkw_orientation_method o = (nkw_orientation_method)(random_bits(&r) % 5);
        assert_int_equal(trace_of(exact, count, float_of((uint32_t)random_bits(&r)), p, o, &trace), NKW_OK);
        for (size_t k = 0; k < trace.control_count; k++)
            assert_true(trace.key[k] < count);
        free(exact);
    }
}

static void trace_of_step_names_the_key_it_holds(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    nkw_keyframe_trace trace;
    scene_1(keys);
    for (int k = 0; k < 7; k++) {
        trace_of(keys, 7, (float)k + 0.75f, NKW_POSITION_STEP, NKW_ORIENTATION_STEP, &trace);
        for (int i = 0; i < 2; i++) {
            expect_quat_bits(trace.orientation[i], keys[k].orientation);
            expect_bits(trace.orientation_weight[i], i == 0 ? 1.0f : 0.0f);
        }
    }
}

/* The orientation of each method is its two orientations by their weights, to the method's own blend. */
static void trace_of_every_method_names_both_orientations(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    nkw_keyframe_trace trace;
    scene_1(keys);
    for (int o = NKW_ORIENTATION_EULER; o <= NKW_ORIENTATION_NLERP; o++) {
        trace_of(keys, 7, 2.25f, NKW_POSITION_LINEAR, (nkw_orientation_method)o, &trace);
        expect_rotation_near(trace.orientation[0], keys[2].orientation, 0);
        expect_rotation_near(trace.orientation[1], keys[3].orientation, 0);
        if (o != NKW_ORIENTATION_SLERP) {
            expect_bits(trace.orientation_weight[0], 0.75f);
            expect_bits(trace.orientation_weight[1], 0.25f);
        }
    }
}

/* Squad and Catmull-Rom pass through the keys, the B-spline of even turns too; the velocity has no jump at a key. */
static void curves_of_four_keys_pass_with_a_continuous_velocity(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    nkw_keyframe_trace before, after;
    scene_1(keys);
    for (int o = NKW_ORIENTATION_SQUAD; o <= NKW_ORIENTATION_BSPLINE; o++)
        for (size_t k = 1; k + 1 < 7; k++) {
            float time = keys[k].time;
            trace_of(keys, 7, time - 0x1p-16f, NKW_POSITION_LINEAR, (nkw_orientation_method)o, &before);
            trace_of(keys, 7, time, NKW_POSITION_LINEAR, (nkw_orientation_method)o, &after);
            expect_vec3_near(before.angular_velocity, after.angular_velocity, 1e-3);
            expect_floats_near(before.rotation.m, after.rotation.m, 9, 1e-4);
            nkw_mat3 want = nkw_mat3_from_quat(keys[k].orientation);
            if (o != NKW_ORIENTATION_BSPLINE)
                expect_floats_bits(after.rotation.m, want.m, 9);
            assert_true(after.orientation_weight[0] == 0.0f && after.orientation_weight[1] == 0.0f);
        }
}

static void orientations_of_a_steady_turn_are_those_of_slerp(void **state)
{
    (void)state;
    nkw_keyframe keys[7];
    scene_1(keys);
    for (int k = 0; k < 7; k++) {
        const nkw_vec3 axis = {0.6f, 0.0f, 0.8f};
        keys[k].orientation = nkw_quat_from_axis_angle(axis, 0.5f * keys[k].time);
    }
    for (float time = 1.0f; time < 5.0f; time += 0.17f)
        for (int o = NKW_ORIENTATION_SQUAD; o <= NKW_ORIENTATION_BSPLINE; o++) {
            nkw_mat4 got, want;
            nkw_keyframes_sample(keys, 7, time, NKW_POSITION_STEP, (nkw_orientation_method)o, &got);
            nkw_keyframes_sample(keys, 7, time, NKW_POSITION_STEP, NKW_ORIENTATION_SLERP, &want);
            expect_floats_near(got.m, want.m, 16, 1e-6);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_row_of_the_exercise_is_met),
        cmocka_unit_test(the_rule_of_the_exercise_is_an_option),
        cmocka_unit_test(the_exercise_takes_the_first_of_segments_of_one_time),
        cmocka_unit_test(the_exercise_loses_roll_at_the_pole),
        cmocka_unit_test(step_begins_at_its_key_and_holds_the_last),
        cmocka_unit_test(keys_come_back_bit_for_bit_at_their_own_time),
        cmocka_unit_test(outside_the_keys_every_method_clamps),
        cmocka_unit_test(incomplete_bezier_groups_hold_the_last_whole_one),
        cmocka_unit_test(bspline_misses_the_ends_by_a_sixth_of_the_end_segment),
        cmocka_unit_test(uneven_times_move_the_bezier_parameter_by_time),
        cmocka_unit_test(one_key_is_itself_and_none_is_an_error),
        cmocka_unit_test(unknown_methods_are_refused),
        cmocka_unit_test(curves_of_four_keys_pass_with_a_continuous_velocity),
        cmocka_unit_test(orientations_of_a_steady_turn_are_those_of_slerp),
        cmocka_unit_test(trace_says_what_sample_did),
        cmocka_unit_test(trace_of_slerp_has_the_textbook_weights),
        cmocka_unit_test(trace_of_euler_shows_the_unwrapped_yaw),
        cmocka_unit_test(validate_names_the_first_offender),
        cmocka_unit_test(validate_refuses_numbers_that_are_not_finite),
        cmocka_unit_test(validate_refuses_times_that_descend_but_not_equal_ones),
        cmocka_unit_test(validate_refuses_orientations_that_are_not_unit),
        cmocka_unit_test(anything_at_all_is_sampled_within_the_keys),
        cmocka_unit_test(trace_of_step_names_the_key_it_holds),
        cmocka_unit_test(trace_of_every_method_names_both_orientations),
    };
    return cmocka_run_group_tests_name("keyframe", tests, NULL, NULL);
}
