/* SPDX-License-Identifier: MIT */
/* Cubic keys for samples. */
#include <math.h>
#include <stdlib.h>

#include "random.h"
#include "support/expect.h"

enum { MOST = 301, WIDTH = 4 };

/* Samples, and what is fitted to them. */
typedef struct sheet {
    float times[MOST], values[WIDTH * MOST], made_times[MOST], made[3 * WIDTH * MOST], error;
    nkw_track_span span;
    unsigned char memory[NKW_FIT_WORK(MOST, WIDTH) + 15];
    nkw_work work;
    nkw_track track, out;
} sheet;

static sheet *begin(size_t count, size_t width, nkw_track_kind kind)
{
    sheet *s = (sheet *)calloc(1, sizeof *s);
    assert_non_null(s);
    nkw_track track = {s->times, s->values, count, width, kind, NKW_INTERPOLATION_LINEAR, NULL};
    nkw_track_span span = {s->made_times, s->made, NULL, count};
    nkw_work work = {s->memory + (16 - (size_t)s->memory % 16) % 16, NKW_FIT_WORK(count, width)};
    s->track = track;
    s->span = span;
    s->work = work;
    for (size_t k = 0; k < count; k++)
        s->times[k] = nkw_timeline_time((nkw_timeline){0.0f, 60.0f, 0}, k);
    return s;
}

static nkw_result fit(sheet *s, float tolerance)
{
    return nkw_track_fit(&s->track, tolerance, s->span, &s->out, &s->error, s->work);
}

/* Within the tolerance, and every key is a sample. */
static void expect_fit(sheet *s, float tolerance)
{
    assert_int_equal(fit(s, tolerance), NKW_OK);
    assert_int_equal(nkw_track_validate(&s->out, NULL), NKW_OK);
    assert_int_equal(s->out.interpolation, NKW_INTERPOLATION_CUBICSPLINE);
    assert_true(s->error <= tolerance);
    size_t width = s->track.width;
    for (size_t k = 0, at = 0; k < s->out.count; k++, at++) {
        while (s->times[at] < s->out.times[k])
            at++;
        expect_bits(s->out.times[k], s->times[at]);
        for (size_t i = 0; i < width; i++)
            assert_true(nkw_abs(s->out.values[(3 * k + 1) * width + i]) == nkw_abs(s->values[at * width + i]));
    }
}

static void a_cubic_is_found_again_by_two_keys(void **state)
{
    (void)state;
    sheet *s = begin(101, 3, NKW_TRACK_FLOATS);
    for (size_t k = 0; k < 101; k++) {
        float t = s->times[k] - 0.7f;
        s->values[3 * k] = 1.0f + t * (2.0f - t * (1.0f - 0.5f * t));
        s->values[3 * k + 1] = 4.0f * t;
        s->values[3 * k + 2] = 7.0f;
    }
    expect_fit(s, 1e-3f);
    assert_int_equal(s->out.count, 2);
    float t = -0.7f;
    expect_near(s->out.values[6], 2.0 - 2.0 * (double)t + 1.5 * (double)(t * t), 1e-2); /* the slope at the start */
    expect_near(s->out.values[7], 4.0, 1e-3);
    expect_near(s->out.values[8], 0.0, 1e-6);
    free(s);
}

static void a_smooth_motion_takes_few_keys(void **state)
{
    (void)state;
    sheet *s = begin(301, 1, NKW_TRACK_FLOATS);
    for (size_t k = 0; k < 301; k++)
        s->values[k] = nkw_sin(2.0f * s->times[k]) + 0.3f * nkw_cos(5.0f * s->times[k]);
    size_t before = 301;
    const float tolerances[4] = {1e-4f, 1e-3f, 1e-2f, 1e-1f};
    const size_t most[4] = {64, 40, 24, 12};
    for (int i = 0; i < 4; i++) {
        expect_fit(s, tolerances[i]);
        assert_true(s->out.count <= before && s->out.count <= most[i]);
        before = s->out.count;
    }
    free(s);
}

static void a_smooth_fit_has_one_velocity_at_each_key(void **state)
{
    (void)state;
    sheet *s = begin(301, 1, NKW_TRACK_FLOATS);
    for (size_t k = 0; k < 301; k++)
        s->values[k] = nkw_sin(3.0f * s->times[k]);
    expect_fit(s, 1e-3f);
    for (size_t k = 1; k + 1 < s->out.count; k++)
        expect_bits(s->out.values[3 * k], s->out.values[3 * k + 2]);
    free(s);
}

static void corners_and_jumps_remain(void **state)
{
    (void)state;
    sheet *s = begin(61, 1, NKW_TRACK_FLOATS);
    for (size_t k = 0; k < 61; k++)
        s->values[k] = k < 20 ? (float)k : k < 40 ? 20.0f : -(float)k;
    s->times[40] = s->times[39]; /* a jump from 20 to -40 */
    expect_fit(s, 1e-4f);
    int has_jump = 0;
    for (size_t k = 0; k + 1 < s->out.count; k++)
        has_jump |= s->out.times[k] == s->out.times[k + 1];
    assert_true(has_jump);
    assert_true(s->out.count < 24);
    free(s);
}

static void noise_takes_as_many_numbers_as_it_has(void **state)
{
    (void)state;
    random_source r = random_from(3);
    sheet *s = begin(64, 3, NKW_TRACK_FLOATS);
    for (size_t k = 0; k < 3 * 64; k++)
        s->values[k] = random_between(&r, -1.0f, 1.0f);
    expect_fit(s, 1e-6f);
    assert_true(s->out.count >= 32); /* a key has two numbers for each component */
    expect_fit(s, 0.0f);
    assert_int_equal(s->out.count, 64);
    expect_bits(s->error, 0.0f);
    free(s);
}

static void rotations_are_fitted_whatever_their_signs(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int round = 0; round < 20; round++) {
        sheet *s = begin(241, 4, NKW_TRACK_ROTATION);
        nkw_vec3 a = random_direction(&r), b = random_direction(&r);
        for (size_t k = 0; k < 241; k++) {
            nkw_quat p = nkw_quat_from_axis_angle(a, 2.0f * s->times[k]);
            nkw_quat q = nkw_quat_mul(p, nkw_quat_from_axis_angle(b, nkw_sin(1.5f * s->times[k])));
            if (random_bits(&r) % 2)
                q = nkw_quat_negate(q);
            memcpy(s->values + 4 * k, &q, sizeof q);
        }
        expect_fit(s, 1e-3f);
        assert_true(s->out.count < 60);
        free(s);
    }
}

static void few_samples_are_answered(void **state)
{
    (void)state;
    for (size_t count = 1; count <= 3; count++) {
        sheet *s = begin(count, 2, NKW_TRACK_FLOATS);
        for (size_t k = 0; k < 2 * count; k++)
            s->values[k] = (float)(k * k);
        expect_fit(s, 1e-5f);
        assert_true(s->out.count <= count && s->out.count >= (count > 1 ? 2u : 1u));
        free(s);
    }
}

static void tangents_that_overflow_are_refused(void **state)
{
    (void)state;
    sheet *s = begin(5, 1, NKW_TRACK_FLOATS);
    for (size_t k = 0; k < 5; k++)
        s->values[k] = k % 2 ? 1e38f : -1e38f; /* 1.2e40 per second */
    assert_int_equal(fit(s, 1e30f), NKW_NOT_FINITE);
    assert_int_equal(s->out.count, 0);
    assert_true(s->error == INFINITY);
    for (size_t k = 0; k < 5; k++)
        s->values[k] *= 1e-3f;
    expect_fit(s, 1e30f);
    free(s);
}

static void wrong_tracks_and_too_little_memory_are_refused(void **state)
{
    (void)state;
    sheet *s = begin(10, 1, NKW_TRACK_FLOATS);
    s->track.interpolation = NKW_INTERPOLATION_STEP;
    assert_int_equal(fit(s, 1.0f), NKW_MISMATCHED);
    s->track.interpolation = NKW_INTERPOLATION_LINEAR;
    const unsigned char modes[10] = {0};
    s->track.key_interpolation = modes;
    assert_int_equal(fit(s, 1.0f), NKW_MISMATCHED);
    s->track.key_interpolation = NULL;
    const nkw_work work = s->work;
    s->work.bytes -= 10 * 6 * sizeof(double);
    assert_int_equal(fit(s, 1.0f), NKW_TOO_SMALL);
    s->work.bytes = 0;
    assert_int_equal(fit(s, 1.0f), NKW_TOO_SMALL);
    s->work = work;
    s->work.data = (char *)work.data + 8;
    assert_int_equal(fit(s, 1.0f), NKW_TOO_SMALL);
    s->work = work;
    assert_int_equal(fit(s, -1.0f), NKW_OUT_OF_RANGE);
    assert_int_equal(fit(s, NAN), NKW_OUT_OF_RANGE);
    assert_true(s->out.count == 0 && s->error == INFINITY);
    s->values[3] = NAN;
    assert_int_equal(fit(s, 1.0f), NKW_NOT_FINITE);
    assert_true(s->out.count == 0 && s->error == INFINITY);
    s->values[3] = 0.0f;
    s->span.key_capacity = 9;
    assert_int_equal(fit(s, 1.0f), NKW_TOO_SMALL);
    s->span.key_capacity = 10;
    s->work.bytes--;
    assert_int_equal(fit(s, 1.0f), NKW_TOO_SMALL);
    s->track.count = 0;
    assert_int_equal(fit(s, 1.0f), NKW_EMPTY);
    free(s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cubic_is_found_again_by_two_keys),
        cmocka_unit_test(a_smooth_motion_takes_few_keys),
        cmocka_unit_test(a_smooth_fit_has_one_velocity_at_each_key),
        cmocka_unit_test(corners_and_jumps_remain),
        cmocka_unit_test(noise_takes_as_many_numbers_as_it_has),
        cmocka_unit_test(rotations_are_fitted_whatever_their_signs),
        cmocka_unit_test(few_samples_are_answered),
        cmocka_unit_test(tangents_that_overflow_are_refused),
        cmocka_unit_test(wrong_tracks_and_too_little_memory_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
