/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "four_keys.h"
#include "random.h"
#include "support/expect.h"
#include "support/motion_span.h"

/* Four keys of two numbers with their tangents. */
static void draw(random_source *r, float triples[24])
{
    for (int i = 0; i < 24; i++)
        triples[i] = random_between(r, -2, 2);
}

static void derivatives(const nkw_track *track, float time, float *value, float *velocity, float *acceleration)
{
    const nkw_motion_span out = {value, velocity, acceleration};
    assert_int_equal(nkw_track_sample_motion(track, time, out), NKW_OK);
}

static void value_has_the_bits_of_the_sample(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 3000; i++) {
        float v[24], at[2], velocity[2], acceleration[2], want[2], time = random_between(&r, 0, 3);
        draw(&r, v);
        nkw_track track = floats(v, 2, (nkw_interpolation)(i % 3));
        derivatives(&track, time, at, velocity, acceleration);
        nkw_track_sample(&track, time, NULL, want);
        expect_floats_bits(at, want, 2);
    }
}

static void derivatives_are_the_slopes_of_the_samples(void **state)
{
    (void)state;
    random_source r = random_from(2);
    const float h = 0x1p-8f;
    for (int i = 0; i < 3000; i++) {
        float v[24], at[2], velocity[2], acceleration[2], before[2], after[2], low[2], high[2], other[2];
        float time = 1 + 0x1p-7f + 0.96875f * random_unit(&r);
        draw(&r, v);
        nkw_track track = floats(v, 2, (nkw_interpolation)(i % 3));
        derivatives(&track, time, at, velocity, acceleration);
        derivatives(&track, time - h, before, low, other);
        derivatives(&track, time + h, after, high, other);
        for (int c = 0; c < 2; c++) {
            /* Central differences: off by h^2/6 times the third derivative, at most 72; and by rounding. */
            expect_near(velocity[c], ((double)after[c] - (double)before[c]) / (2 * (double)h), 3e-4);
            expect_near(acceleration[c], ((double)high[c] - (double)low[c]) / (2 * (double)h), 1e-3);
        }
    }
}

static void keys_have_the_velocity_of_the_segment_that_begins_there(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 200; i++) {
        float v[24], at[2], velocity[2], acceleration[2];
        draw(&r, v);
        nkw_track track = floats(v, 2, NKW_INTERPOLATION_CUBICSPLINE);
        for (size_t k = 0; k < 3; k++) {
            derivatives(&track, times4[k], at, velocity, acceleration);
            expect_floats_bits(velocity, v + 6 * k + 4, 2);
        }
        derivatives(&track, times4[3], at, velocity, acceleration);
        expect_floats_bits(velocity, v + 18, 2);
    }
}

static void derivatives_outside_the_keys_are_zero(void **state)
{
    (void)state;
    static const float v[24] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 1, 2, 3, 4, 5, 6, 7, 8, 9, 1, 2, 3, 4, 5, 6},
                       zero[2] = {0, 0};
    const float outside[4] = {0.25f, 2.75f, NAN, INFINITY};
    for (int i = 0; i < 12; i++) {
        float at[2], velocity[2] = {9, 9}, acceleration[2] = {9, 9};
        nkw_track track = floats(v, 2, (nkw_interpolation)(i % 3));
        derivatives(&track, outside[i / 3], at, velocity, acceleration);
        expect_floats_bits(velocity, zero, 2);
        expect_floats_bits(acceleration, zero, 2);
    }
}

static void an_empty_segment_has_no_velocity(void **state)
{
    (void)state;
    static const float times[3] = {0, 1, 1}, v[3] = {1, 2, 4}, one[1] = {0};
    nkw_track track = {times, v, 3, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL};
    nkw_track single = {one, v, 1, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL};
    float at, velocity, acceleration;
    derivatives(&track, 1, &at, &velocity, &acceleration);
    expect_bits(at, 4);
    expect_bits(velocity, 0);
    derivatives(&single, 0, &at, &velocity, &acceleration);
    expect_bits(at, 1);
    expect_bits(velocity, 0);
}

static void each_key_may_choose_its_interpolation(void **state)
{
    (void)state;
    random_source r = random_from(4);
    static const unsigned char own[4] = {NKW_INTERPOLATION_STEP, NKW_INTERPOLATION_LINEAR,
                                         NKW_INTERPOLATION_CUBICSPLINE, NKW_INTERPOLATION_STEP};
    float v[24], at[2], velocity[2], acceleration[2];
    draw(&r, v);
    nkw_track track = floats(v, 2, NKW_INTERPOLATION_CUBICSPLINE);
    track.key_interpolation = own;
    derivatives(&track, 0.75f, at, velocity, acceleration);
    expect_bits(velocity[0], 0);
    derivatives(&track, 1.25f, at, velocity, acceleration);
    expect_near(velocity[0], (double)v[14] - (double)v[8], 1e-6); /* of the values of keys 1 and 2, 1 s apart */
    expect_bits(acceleration[0], 0);
    derivatives(&track, 2, at, velocity, acceleration);
    expect_bits(velocity[1], v[17]);
}

static void tracks_that_cannot_be_read_are_refused(void **state)
{
    (void)state;
    static const float v[16] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    nkw_track empty = floats(v, 1, NKW_INTERPOLATION_LINEAR), narrow = floats(v, 0, NKW_INTERPOLATION_LINEAR),
              none = rotations(v, NKW_INTERPOLATION_LINEAR), thin = none;
    float at[4] = {9, 9, 9, 9}, velocity[4] = {9, 9, 9, 9}, acceleration[4] = {9, 9, 9, 9};
    const nkw_motion_span out = {at, velocity, acceleration};
    empty.count = none.count = 0;
    thin.width = 3;
    assert_int_equal(nkw_track_sample_motion(&empty, 1, out), NKW_EMPTY);
    assert_int_equal(nkw_track_sample_motion(&narrow, 1, out), NKW_EMPTY);
    assert_int_equal(nkw_track_sample_motion(&none, 1, out), NKW_EMPTY);
    assert_int_equal(nkw_track_sample_motion(&thin, 1, out), NKW_BAD_WIDTH);
    assert_int_equal(nkw_track_sample(&empty, 1, NULL, at), NKW_EMPTY);
    assert_int_equal(nkw_track_sample(&thin, 1, NULL, at), NKW_BAD_WIDTH);
    for (int i = 0; i < 4; i++)
        assert_true(at[i] == 9 && velocity[i] == 9 && acceleration[i] == 9);
}

/* Each of the three may be left out; the others have the same bits. */
static void what_is_not_wanted_may_be_null(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (int i = 0; i < 64; i++) {
        float v[48], all[3][4] = {{0}}, some[3][4] = {{0}};
        draw(&r, v);
        draw(&r, v + 24);
        nkw_track track = i % 2 ? rotations(v, NKW_INTERPOLATION_CUBICSPLINE) : floats(v, 2, NKW_INTERPOLATION_CUBICSPLINE);
        const nkw_motion_span whole = {all[0], all[1], all[2]};
        const nkw_motion_span part = {i & 2 ? some[0] : NULL, i & 4 ? some[1] : NULL, i & 8 ? some[2] : NULL};
        assert_int_equal(nkw_track_sample_motion(&track, 1.25f, whole), NKW_OK);
        assert_int_equal(nkw_track_sample_motion(&track, 1.25f, part), NKW_OK);
        for (int k = 0; k < 3; k++)
            if (i & (2 << k))
                expect_floats_bits(some[k], all[k], 4);
            else
                expect_bits(some[k][0], 0);
    }
}

/* Four unit keys, each at most 1 rad from the one before, with tangents for CUBICSPLINE: 48 or 16 floats. */
static void draw_rotations(random_source *r, int cubic, float *v)
{
    nkw_quat q = random_rotation(r);
    for (int k = 0; k < 4; k++, q = random_near(r, q, random_between(r, 0.1f, 0.5f))) {
        float *key = v + (cubic ? 12 * k : 4 * k);
        for (int i = 0; i < 12 && cubic; i++)
            key[i] = random_between(r, -1, 1);
        memcpy(key + (cubic ? 4 : 0), &q, sizeof q);
    }
}

static nkw_quat_motion rotation_at(const nkw_track *track, float time)
{
    nkw_quat_motion s;
    assert_int_equal(nkw_track_sample_motion(track, time, quat_motion_span(&s)), NKW_OK);
    return s;
}

static void orientation_has_the_bits_of_the_sample(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 3000; i++) {
        float v[48], want[4], time = random_between(&r, 0, 3);
        draw_rotations(&r, i % 3 == NKW_INTERPOLATION_CUBICSPLINE, v);
        nkw_track track = rotations(v, (nkw_interpolation)(i % 3));
        track.kind = i % 2 ? NKW_TRACK_ROTATION_NORMALIZED : NKW_TRACK_ROTATION;
        nkw_quat_motion s = rotation_at(&track, time);
        nkw_track_sample(&track, time, NULL, want);
        expect_floats_bits(&s.value.x, want, 4);
    }
}

static void velocity_and_acceleration_are_those_of_neighbouring_samples(void **state)
{
    (void)state;
    random_source r = random_from(4);
    const float h = 0x1p-7f;
    for (int i = 0; i < 3000; i++) {
        float v[48];
        nkw_interpolation mode = i % 2 ? NKW_INTERPOLATION_CUBICSPLINE : NKW_INTERPOLATION_LINEAR;
        draw_rotations(&r, i % 2, v);
        nkw_track track = rotations(v, mode);
        int k = i % 3;
        float time = random_between(&r, times4[k] + 2 * h, times4[k + 1] - 2 * h);
        nkw_quat_motion low = rotation_at(&track, time - h), at = rotation_at(&track, time),
                           high = rotation_at(&track, time + h);
        nkw_vec3 velocity = nkw_quat_angular_velocity(low.value, high.value, 2 * h);
        nkw_vec3 acceleration = nkw_vec3_scale(nkw_vec3_sub(high.velocity, low.velocity), 1 / (2 * h));
        expect_vec3_near(at.velocity, velocity, 0.02);
        expect_vec3_near(at.acceleration, acceleration, 0.1 + 0.02 * nkw_vec3_length(at.acceleration));
    }
}

static void a_slerp_turns_at_constant_velocity_along_the_shorter_arc(void **state)
{
    (void)state;
    const float c = 0.70710678f;
    float v[16] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, c, c, 0, 0, -c, -c};
    nkw_track track = rotations(v, NKW_INTERPOLATION_LINEAR);
    const nkw_vec3 quarter = {0, 0, 1.57079633f}, none = {0, 0, 0};
    for (int i = 0; i < 2; i++) {
        nkw_quat_motion s = rotation_at(&track, i ? 1.0f : 1.25f); /* a quarter turn from 1 s to 2 s */
        expect_vec3_near(s.velocity, quarter, 1e-6);
        expect_vec3_bits(s.acceleration, none);
        expect_vec3_near(rotation_at(&track, 2.25f).velocity, none, 1e-6); /* to the same rotation, negated */
        for (int k = 8; k < 12; k++)
            v[k] = -v[k];
    }
}

static void a_key_has_the_angular_velocity_of_its_tangent(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 300; i++) {
        float v[48];
        draw_rotations(&r, 1, v);
        nkw_track track = rotations(v, NKW_INTERPOLATION_CUBICSPLINE);
        int k = i % 3;
        nkw_quat q, tangent;
        nkw_vec3 w = random_vec3(&r, -3, 3);
        memcpy(&q, v + 12 * k + 4, sizeof q);
        nkw_quat half = {0.5f * w.x, 0.5f * w.y, 0.5f * w.z, 0};
        tangent = nkw_quat_mul(half, q); /* q' = w/2 q */
        memcpy(v + 12 * k + 8, &tangent, sizeof tangent);
        expect_vec3_near(rotation_at(&track, times4[k]).velocity, w, 4e-6);
    }
}

static void rotations_that_stand_still_have_no_velocity(void **state)
{
    (void)state;
    random_source r = random_from(6);
    const nkw_vec3 none = {0, 0, 0};
    float v[48];
    draw_rotations(&r, 1, v);
    nkw_track track = rotations(v, NKW_INTERPOLATION_CUBICSPLINE);
    const float times[5] = {0, 0.4375f, 2.5625f, INFINITY, NAN};
    for (int i = 0; i < 5; i++) {
        expect_vec3_bits(rotation_at(&track, times[i]).velocity, none);
        expect_vec3_bits(rotation_at(&track, times[i]).acceleration, none);
    }
    track.interpolation = NKW_INTERPOLATION_STEP;
    expect_vec3_bits(rotation_at(&track, 1.5f).velocity, none);
    memset(v, 0, sizeof v); /* no direction */
    track.interpolation = NKW_INTERPOLATION_CUBICSPLINE;
    expect_vec3_bits(rotation_at(&track, 1.5f).velocity, none);
    track.interpolation = NKW_INTERPOLATION_LINEAR;
    expect_vec3_bits(rotation_at(&track, 1.5f).velocity, none);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(value_has_the_bits_of_the_sample),
        cmocka_unit_test(derivatives_are_the_slopes_of_the_samples),
        cmocka_unit_test(keys_have_the_velocity_of_the_segment_that_begins_there),
        cmocka_unit_test(derivatives_outside_the_keys_are_zero),
        cmocka_unit_test(an_empty_segment_has_no_velocity),
        cmocka_unit_test(each_key_may_choose_its_interpolation),
        cmocka_unit_test(tracks_that_cannot_be_read_are_refused),
        cmocka_unit_test(what_is_not_wanted_may_be_null),
        cmocka_unit_test(orientation_has_the_bits_of_the_sample),
        cmocka_unit_test(velocity_and_acceleration_are_those_of_neighbouring_samples),
        cmocka_unit_test(a_slerp_turns_at_constant_velocity_along_the_shorter_arc),
        cmocka_unit_test(a_key_has_the_angular_velocity_of_its_tangent),
        cmocka_unit_test(rotations_that_stand_still_have_no_velocity),
    };
    return cmocka_run_group_tests_name("track_derivatives", tests, NULL, NULL);
}
