/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "random.h"
#include "support/expect.h"
#include "support/four_keys.h"

static float sample_float(const nkw_track *track, float time)
{
    float v = NAN;
    nkw_track_sample(track, time, NULL, &v);
    return v;
}

static void keys_come_back_bit_for_bit_at_their_own_time(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int round = 0; round < 500; round++) {
        float values[4 * 3 * 4], got[4];
        for (int i = 0; i < 48; i++)
            values[i] = i % 7 ? random_scaled(&r, -20, 20) : -0.0f;
        for (int mode = 0; mode < 3; mode++) {
            nkw_track plain = floats(values, 4, (nkw_interpolation)mode);
            nkw_track turns = rotations(values, (nkw_interpolation)mode);
            for (size_t k = 0; k < 4; k++) {
                const float *want = mode == NKW_INTERPOLATION_CUBICSPLINE ? values + 12 * k + 4 : values + 4 * k;
                nkw_track_sample(&plain, times4[k], NULL, got);
                expect_floats_bits(got, want, 4);
                nkw_track_sample(&turns, times4[k], NULL, got);
                expect_floats_bits(got, want, 4);
            }
        }
    }
}

static void outside_the_keys_the_ends_hold(void **state)
{
    (void)state;
    const float values[4] = {3, 1, 4, 5}, triples[12] = {9, 3, 9, 9, 1, 9, 9, 4, 9, 9, 5, 9};
    for (int mode = 0; mode < 3; mode++) {
        nkw_track t = floats(mode == 2 ? triples : values, 1, (nkw_interpolation)mode);
        expect_bits(sample_float(&t, -INFINITY), 3.0f);
        expect_bits(sample_float(&t, 0.0f), 3.0f);
        expect_bits(sample_float(&t, NAN), 3.0f);
        expect_bits(sample_float(&t, 2.5f), 5.0f);
        expect_bits(sample_float(&t, INFINITY), 5.0f);
    }
}

static void step_holds_linear_blends(void **state)
{
    (void)state;
    const float values[4] = {3, 1, 4, 5};
    nkw_track step = floats(values, 1, NKW_INTERPOLATION_STEP), line = floats(values, 1, NKW_INTERPOLATION_LINEAR);
    expect_bits(sample_float(&step, 0.99f), 3.0f);
    expect_bits(sample_float(&step, 1.0f), 1.0f);
    expect_bits(sample_float(&line, 0.75f), 2.0f);
    expect_bits(sample_float(&line, 1.5f), 2.5f);
}

static void cubic_tangents_are_per_second(void **state)
{
    (void)state;
    /* A motion at 4 units per second: the tangents say so, whatever the length of the segments. */
    float triples[12];
    for (int k = 0; k < 4; k++) {
        triples[3 * k] = triples[3 * k + 2] = 4.0f;
        triples[3 * k + 1] = 4.0f * times4[k];
    }
    nkw_track t = floats(triples, 1, NKW_INTERPOLATION_CUBICSPLINE);
    for (float time = 0.5f; time <= 2.5f; time += 0.0625f)
        expect_near(sample_float(&t, time), 4.0f * time, 1e-6);
}

static void cubic_takes_the_out_tangent_of_its_left_key_and_the_in_tangent_of_its_right_one(void **state)
{
    (void)state;
    const float triples[12] = {100, 0, 1, 2, 0, 200, 300, 0, 400, 500, 0, 600};
    nkw_track t = floats(triples, 1, NKW_INTERPOLATION_CUBICSPLINE);
    /* Half a second from key 0 to key 1: at its middle d (1/8 out - 1/8 in). */
    expect_near(sample_float(&t, 0.75f), 0.5 * (1.0 / 8 - 2.0 / 8), 1e-7);
}

static void rotations_take_the_shorter_arc_and_stay_unit(void **state)
{
    (void)state;
    nkw_vec3 z = {0, 0, 1};
    float values[16], got[4];
    for (int k = 0; k < 4; k++) {
        nkw_quat q = nkw_quat_scale(nkw_quat_from_axis_angle(z, (float)k), k % 2 ? -1.0f : 1.0f);
        memcpy(values + 4 * k, &q, sizeof q);
    }
    nkw_track t = rotations(values, NKW_INTERPOLATION_LINEAR);
    nkw_track_sample(&t, 0.75f, NULL, got);
    nkw_quat q = {got[0], got[1], got[2], got[3]};
    expect_rotation_near(q, nkw_quat_from_axis_angle(z, 0.5f), 2e-7);
}

static void cubic_rotations_are_normalised_between_keys(void **state)
{
    (void)state;
    random_source r = random_from(2);
    float values[48], got[4];
    for (int k = 0; k < 12; k++) {
        nkw_quat q = random_rotation(&r);
        memcpy(values + 4 * k, &q, sizeof q);
    }
    nkw_track t = rotations(values, NKW_INTERPOLATION_CUBICSPLINE);
    for (float time = 0.51f; time < 2.5f; time += 0.0173f) {
        nkw_track_sample(&t, time, NULL, got);
        nkw_quat q = {got[0], got[1], got[2], got[3]};
        expect_near(nkw_quat_length(q), 1.0, 2e-7);
    }
}

static void keys_that_are_not_quite_unit_are_normalised_where_asked(void **state)
{
    (void)state;
    const float values[16] = {0, 0, 0, 1, 0.707f, 0, 0, 0.707f, 0, 0, 0, 1, 0.707f, 0, 0, 0.707f};
    float got[4];
    nkw_track t = rotations(values, NKW_INTERPOLATION_LINEAR);
    t.kind = NKW_TRACK_ROTATION_NORMALIZED;
    nkw_track_sample(&t, 1.0f, NULL, got);
    expect_near(got[0], 0.70710678, 1e-7);
    nkw_track_sample(&t, 1.3f, NULL, got);
    nkw_quat q = {got[0], got[1], got[2], got[3]};
    expect_near(nkw_quat_length(q), 1.0, 2e-7);
}

static void each_key_may_choose_its_interpolation(void **state)
{
    (void)state;
    const float values[4] = {3, 1, 4, 5};
    const unsigned char modes[4] = {NKW_INTERPOLATION_LINEAR, NKW_INTERPOLATION_STEP, NKW_INTERPOLATION_LINEAR, 0};
    nkw_track t = floats(values, 1, NKW_INTERPOLATION_STEP);
    t.key_interpolation = modes;
    expect_bits(sample_float(&t, 0.75f), 2.0f);
    expect_bits(sample_float(&t, 1.5f), 1.0f);
    expect_bits(sample_float(&t, 2.25f), 4.5f);
}

/* Each segment as that of a track of one interpolation: rotations, of the two kinds, and numbers. */
static void each_key_of_a_cubic_may_choose_its_interpolation(void **state)
{
    (void)state;
    const unsigned char modes[4] = {NKW_INTERPOLATION_CUBICSPLINE, NKW_INTERPOLATION_LINEAR, NKW_INTERPOLATION_STEP, 0};
    random_source r = random_from(21);
    float values[48], keys[16];
    for (int i = 0; i < 48; i++)
        values[i] = random_between(&r, -1, 1);
    for (int k = 0; k < 4; k++) {
        nkw_quat q = random_rotation(&r);
        memcpy(values + 12 * k + 4, &q, sizeof q);
        values[12 * k + 4] *= 1.001f;
        memcpy(keys + 4 * k, values + 12 * k + 4, sizeof q);
    }
    for (int kind = NKW_TRACK_FLOATS; kind <= NKW_TRACK_ROTATION_NORMALIZED; kind++) {
        nkw_track t = {times4, values, 4, 4, (nkw_track_kind)kind, NKW_INTERPOLATION_CUBICSPLINE, modes}, like = t;
        assert_int_equal(nkw_track_validate(&t, NULL), NKW_OK);
        like.key_interpolation = NULL;
        for (float time = -0.5f; time < 4; time += 0.0625f) {
            float got[4], want[4];
            size_t k = nkw_segment_find(times4, 4, time).index;
            like.interpolation = (nkw_interpolation)modes[k];
            like.values = modes[k] == NKW_INTERPOLATION_CUBICSPLINE ? values : keys;
            nkw_track_sample(&t, time, NULL, got);
            nkw_track_sample(&like, time, NULL, want);
            expect_floats_bits(got, want, 4);
        }
    }
}

static void one_key_is_constant_and_equal_times_do_not_divide(void **state)
{
    (void)state;
    const float value[3] = {7, 8, 9}, jump[3] = {0, 1, 1};
    nkw_track one = {times4, value, 1, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL};
    expect_bits(sample_float(&one, 0.1f), 7.0f);
    expect_bits(sample_float(&one, 9.0f), 7.0f);
    nkw_track twice = {jump, value, 3, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL};
    expect_bits(sample_float(&twice, 0.5f), 7.5f);
    expect_bits(sample_float(&twice, 1.0f), 9.0f);
}

static void cursor_and_shared_segment_give_the_same_bits(void **state)
{
    (void)state;
    random_source r = random_from(3);
    float values[48];
    for (int i = 0; i < 48; i++)
        values[i] = random_between(&r, -1, 1);
    uint32_t cursor = 99;
    for (int i = 0; i < 3000; i++) {
        nkw_track t = floats(values, 4, (nkw_interpolation)(i % 3));
        t.kind = i % 2 ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
        float time = random_between(&r, 0, 3), a[4], b[4], c[4];
        nkw_track_sample(&t, time, NULL, a);
        nkw_track_sample(&t, time, &cursor, b);
        nkw_track_sample_segment(&t, nkw_segment_find(times4, 4, time), c);
        expect_floats_bits(b, a, 4);
        expect_floats_bits(c, a, 4);
        assert_true(cursor <= 2);
    }
}

static void a_t_outside_of_its_segment_is_clamped(void **state)
{
    (void)state;
    random_source r = random_from(31);
    float values[48];
    for (int i = 0; i < 48; i++)
        values[i] = random_between(&r, -1, 1);
    static const float outside[] = {-0.0f, -0.25f, -3e38f, -INFINITY, NAN, 1.25f, 3e38f, INFINITY};
    for (int i = 0; i < 6 * 8; i++) {
        nkw_track t = floats(values, 4, (nkw_interpolation)(i % 3));
        t.kind = i / 3 % 2 ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
        float got[4], want[4], at = outside[i / 6];
        const nkw_segment given = {1, at}, clamped = {1, at > 0.0f ? 1.0f : 0.0f};
        nkw_track_sample_segment(&t, given, got);
        nkw_track_sample_segment(&t, clamped, want);
        expect_floats_bits(got, want, 4);
    }
}

/* glTF 2.0, appendix C.4, in binary64, with the keys as given. */
static void textbook_slerp(const float *a, const float *b, double t, double out[4])
{
    double dot = 0;
    for (int i = 0; i < 4; i++)
        dot += (double)a[i] * (double)b[i];
    double angle = acos(fmin(fabs(dot), 1)), sine = sin(angle), sign = dot < 0 ? -1 : 1;
    double wa = sine > 0 ? sin((1 - t) * angle) / sine : 1 - t, wb = sine > 0 ? sin(t * angle) / sine : t;
    for (int i = 0; i < 4; i++)
        out[i] = wa * (double)a[i] + wb * sign * (double)b[i];
}

static void keys_that_are_off_unit_are_taken_as_they_stand(void **state)
{
    (void)state;
    static const float lengths[] = {1.00001f, 0.99999f, 1.0003f, 0.9997f, 1.009f, 0.991f, 1.0f};
    random_source r = random_from(9);
    for (int i = 0; i < 14000; i++) {
        float values[16], got[4], time = random_between(&r, 1.0f, 2.0f);
        double want[4], t = (double)time - 1;
        nkw_quat a = random_rotation(&r), b = i % 2 ? random_rotation(&r) : random_near(&r, a, 0.1f);
        a = nkw_quat_scale(a, lengths[i % 7]);
        b = nkw_quat_scale(b, lengths[i % 7]);
        for (int k = 0; k < 4; k++)
            memcpy(values + 4 * k, k == 1 ? &a : &b, sizeof a);
        nkw_track track = rotations(values, NKW_INTERPOLATION_LINEAR);
        nkw_track_sample(&track, time, NULL, got);
        textbook_slerp(values + 4, values + 8, t, want);
        for (int k = 0; k < 4; k++)
            expect_near(got[k], want[k], 5e-7);
        nkw_track_sample(&track, 2.2f, NULL, got);
        expect_floats_bits(got, values + 12, 4);
    }
}

static void value_count_is_what_the_layout_holds(void **state)
{
    (void)state;
    nkw_track t = floats(NULL, 3, NKW_INTERPOLATION_LINEAR);
    assert_int_equal(nkw_track_value_count(&t), 12);
    t.interpolation = NKW_INTERPOLATION_CUBICSPLINE;
    assert_int_equal(nkw_track_value_count(&t), 36);
    t.count = SIZE_MAX / 9;
    assert_true(nkw_track_value_count(&t) == SIZE_MAX / 9 * 9);
    t.count++;
    assert_true(nkw_track_value_count(&t) == SIZE_MAX);
}

static void expect_invalid(const nkw_track *t, nkw_result result, size_t key, int line)
{
    size_t bad = 99;
    nkw_result got = nkw_track_validate(t, &bad);
    if (got != result || bad != key) {
        print_error("got %s at %zu, want %s at %zu\n", nkw_result_text(got), bad, nkw_result_text(result), key);
        _fail(__FILE__, line);
    }
    assert_int_equal(nkw_track_validate(t, NULL), result);
}

static void validate_accepts_what_is_right(void **state)
{
    (void)state;
    const float values[16] = {0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0}, same[4] = {1, 1, 1, 1};
    nkw_track t = rotations(values, NKW_INTERPOLATION_LINEAR);
    expect_invalid(&t, NKW_OK, 0, __LINE__);
    t.times = same;
    expect_invalid(&t, NKW_OK, 0, __LINE__);
}

static void validate_refuses_wrong_shapes(void **state)
{
    (void)state;
    const float values[16] = {0};
    const unsigned char modes[4] = {0, 1, 2, 0}, unknown[4] = {0, 1, 2, 3};
    nkw_track t = floats(values, 1, NKW_INTERPOLATION_LINEAR), none = t, thin = t, odd = t, mode = t, turn = t;
    nkw_track key = t, both = t;
    none.count = 0;
    thin.width = 0;
    odd.kind = (nkw_track_kind)3;
    mode.interpolation = (nkw_interpolation)3;
    turn.kind = NKW_TRACK_ROTATION;
    key.key_interpolation = modes;
    both.interpolation = NKW_INTERPOLATION_CUBICSPLINE;
    both.key_interpolation = modes;
    nkw_track vast = t;
    vast.count = SIZE_MAX / 3 + 2;
    expect_invalid(&vast, NKW_TOO_SMALL, 0, __LINE__);
    expect_invalid(&none, NKW_EMPTY, 0, __LINE__);
    expect_invalid(&thin, NKW_EMPTY, 0, __LINE__);
    expect_invalid(&odd, NKW_BAD_METHOD, 0, __LINE__);
    expect_invalid(&mode, NKW_BAD_METHOD, 0, __LINE__);
    expect_invalid(&turn, NKW_BAD_WIDTH, 0, __LINE__);
    expect_invalid(&key, NKW_BAD_METHOD, 2, __LINE__);
    expect_invalid(&both, NKW_OK, 0, __LINE__);
    both.key_interpolation = unknown;
    expect_invalid(&both, NKW_BAD_METHOD, 3, __LINE__);
}

static void validate_refuses_wrong_numbers(void **state)
{
    (void)state;
    float values[16] = {0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0};
    float infinite[4] = {0, 1, 2, INFINITY}, back[4] = {0, 1, 0.5f, 2};
    nkw_track t = rotations(values, NKW_INTERPOLATION_LINEAR);
    t.times = infinite;
    expect_invalid(&t, NKW_NOT_FINITE, 3, __LINE__);
    t.times = back;
    expect_invalid(&t, NKW_NOT_ASCENDING, 2, __LINE__);
    t.times = times4;
    values[5] = NAN;
    expect_invalid(&t, NKW_NOT_FINITE, 1, __LINE__);
    values[5] = 0.3f;
    expect_invalid(&t, NKW_NOT_UNIT, 1, __LINE__);
    values[5] = 0;
    values[6] = 1.009f;
    values[9] = 0.991f;
    expect_invalid(&t, NKW_OK, 0, __LINE__);
    values[9] = 0.989f;
    expect_invalid(&t, NKW_NOT_UNIT, 2, __LINE__);
    t.kind = NKW_TRACK_ROTATION_NORMALIZED;
    expect_invalid(&t, NKW_NOT_UNIT, 2, __LINE__);
}

static void anything_at_all_stays_within_its_arrays(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 20000; i++) {
        size_t count = (size_t)(random_bits(&r) % 5), width = (size_t)(random_bits(&r) % 6);
        nkw_track t = {
            NULL, NULL, count, width, (nkw_track_kind)(random_bits(&r) % 4), (nkw_interpolation)(random_bits(&r) % 4),
            NULL};
        size_t n = nkw_track_value_count(&t);
        /* The arrays end where the data ends, so that a sanitizer sees a step beyond. */
        float *times = (float *)malloc(count * sizeof(float)), *values = (float *)malloc(n * sizeof(float));
        float out[6];
        assert_true((times || count == 0) && (values || n == 0));
        for (size_t k = 0; k < count; k++)
            times[k] = float_of((uint32_t)random_bits(&r));
        for (size_t k = 0; k < n; k++)
            values[k] = float_of((uint32_t)random_bits(&r));
        t.times = times;
        t.values = values;
        nkw_track_sample(&t, float_of((uint32_t)random_bits(&r)), NULL, out);
        nkw_track_validate(&t, NULL);
        free(times);
        free(values);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_t_outside_of_its_segment_is_clamped),
        cmocka_unit_test(keys_come_back_bit_for_bit_at_their_own_time),
        cmocka_unit_test(outside_the_keys_the_ends_hold),
        cmocka_unit_test(step_holds_linear_blends),
        cmocka_unit_test(cubic_tangents_are_per_second),
        cmocka_unit_test(cubic_takes_the_out_tangent_of_its_left_key_and_the_in_tangent_of_its_right_one),
        cmocka_unit_test(rotations_take_the_shorter_arc_and_stay_unit),
        cmocka_unit_test(cubic_rotations_are_normalised_between_keys),
        cmocka_unit_test(keys_that_are_not_quite_unit_are_normalised_where_asked),
        cmocka_unit_test(each_key_may_choose_its_interpolation),
        cmocka_unit_test(each_key_of_a_cubic_may_choose_its_interpolation),
        cmocka_unit_test(one_key_is_constant_and_equal_times_do_not_divide),
        cmocka_unit_test(cursor_and_shared_segment_give_the_same_bits),
        cmocka_unit_test(keys_that_are_off_unit_are_taken_as_they_stand),
        cmocka_unit_test(value_count_is_what_the_layout_holds),
        cmocka_unit_test(validate_accepts_what_is_right),
        cmocka_unit_test(validate_refuses_wrong_shapes),
        cmocka_unit_test(validate_refuses_wrong_numbers),
        cmocka_unit_test(anything_at_all_stays_within_its_arrays),
    };
    return cmocka_run_group_tests_name("track", tests, NULL, NULL);
}
