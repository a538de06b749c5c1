/* SPDX-License-Identifier: MIT */
/* Tracks at other rates, and the difference of two tracks. */
#include <math.h>
#include <stdlib.h>

#include "random.h"
#include "support/expect.h"
#include "support/four_keys.h"
#include "support/resample.h"

static void same_track(const nkw_track *got, const nkw_track *want)
{
    assert_int_equal(got->count, want->count);
    expect_floats_bits(got->times, want->times, want->count);
    expect_floats_bits(got->values, want->values, want->count * want->width);
    assert_int_equal(got->interpolation, want->interpolation);
    assert_int_equal(got->kind, want->kind);
}

#define EVEN_KEYS 61

/* Keys at a rate, drawn so that neighbours are near each other. */
static nkw_track even_keys(random_source *r, float start, float rate, int turns, float *times, float *values)
{
    size_t width = turns ? 4 : 3;
    nkw_track t = {times, values, EVEN_KEYS, width, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL};
    t.kind = turns ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
    nkw_quat q = random_rotation(r);
    for (size_t k = 0; k < EVEN_KEYS; k++) {
        times[k] = nkw_timeline_time((nkw_timeline){start, rate, 0}, k);
        for (size_t i = 0; i < width; i++)
            values[k * width + i] = random_between(r, -3, 3);
        q = random_near(r, q, 0.3f);
        if (turns)
            memcpy(values + 4 * k, &q, sizeof q);
    }
    return t;
}

static void resampling_at_its_own_rate_gives_the_track_back(void **state)
{
    (void)state;
    random_source r = random_from(5);
    const float starts[3] = {0.0f, 7.3f, -2.0f}, rates[4] = {30.0f, 24.0f, 12.5f, 29.97f};
    for (int i = 0; i < 48; i++) {
        float times[EVEN_KEYS], values[4 * EVEN_KEYS], new_times[EVEN_KEYS], made[4 * EVEN_KEYS];
        NKW_STACK_WORK(work, NKW_TRACK_WORK(4));
        float rate = rates[i % 4];
        nkw_track t = even_keys(&r, starts[i % 3], rate, i % 2, times, values), out;
        t.interpolation = i % 8 < 4 ? NKW_INTERPOLATION_LINEAR : NKW_INTERPOLATION_STEP;
        assert_int_equal(resample_count(&t, rate), EVEN_KEYS);
        expect_near(resample(&t, rate, new_times, made, work, &out), 0.0, i % 2 ? 1e-7 : 0.0);
        same_track(&out, &t);
        expect_near(uniform_rate(new_times, EVEN_KEYS), rate, 2e-6 * rate);
    }
}

static void resampled_keys_are_samples_until_the_end_is_reached_or_passed(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 600; i++) {
        float values[48], times[64], made[256], want[4];
        NKW_STACK_WORK(work, NKW_TRACK_WORK(4));
        for (int v = 0; v < 48; v++)
            values[v] = random_between(&r, -1, 1);
        nkw_track t = floats(values, 4, (nkw_interpolation)(i % 3)), out;
        t.kind = i % 2 ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
        float rate = random_between(&r, 0.1f, 30.0f);
        size_t count = resample_count(&t, rate);
        assert_in_range(count, 2, 61);
        assert_true(nkw_timeline_time((nkw_timeline){0.5f, rate, 0}, count - 2) < 2.5f);
        assert_true(nkw_timeline_time((nkw_timeline){0.5f, rate, 0}, count - 1) >= 2.5f);
        float error = resample(&t, rate, times, made, work, &out);
        assert_int_equal(out.count, count);
        assert_int_equal(out.interpolation, i % 3 == 1 ? NKW_INTERPOLATION_STEP : NKW_INTERPOLATION_LINEAR);
        expect_bits(error, track_difference(&t, &out, work));
        for (size_t k = 0; k < count; k++) {
            nkw_track_sample(&t, times[k], NULL, want);
            expect_floats_bits(made + 4 * k, want, 4);
        }
    }
}

static void the_error_of_resampling_is_what_was_lost(void **state)
{
    (void)state;
    const float hat[3] = {0, 3, 0}, line[3] = {0, 1, 2}, steps[3] = {1, 5, 6}, at[3] = {0, 1, 2};
    float times[9], made[9];
    NKW_STACK_WORK(work, NKW_TRACK_WORK(1));
    nkw_track t = {at, hat, 3, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL}, out;
    expect_bits(resample(&t, 0.5f, times, made, work, &out), 3.0f);
    assert_int_equal(out.count, 2);
    expect_bits(resample(&t, 1.0f, times, made, work, &out), 0.0f);
    out = t;
    expect_bits(resample(&out, 0.5f, times, made, work, &out), 3.0f);
    assert_int_equal(out.count, 2);
    out = t;
    expect_bits(resample_within(&out, 0.1f, times, made, work, &out), 1.0f);
    assert_int_equal(out.count, 3);
    t.values = line;
    expect_bits(resample(&t, 0.5f, times, made, work, &out), 0.0f);
    t.values = steps;
    t.interpolation = NKW_INTERPOLATION_STEP;
    expect_bits(resample(&t, 0.5f, times, made, work, &out), 4.0f);
    /* An arch of height 1 between two keys: seen at the quarters alone. */
    const float arch[6] = {0, 0, 4, -4, 0, 0};
    nkw_track curve = {at, arch, 2, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE, NULL};
    expect_bits(resample(&curve, 1.0f, times, made, work, &out), 1.0f);
    /* A quarter turn and back, held still: the angle of a quarter turn. */
    const float turns[12] = {0, 0, 0, 1, 0, 0, 0.70710678f, 0.70710678f, 0, 0, 0, 1};
    nkw_track turn = {at, turns, 3, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR, NULL};
    float rotations_made[12];
    NKW_STACK_WORK(rotations_work, NKW_TRACK_WORK(4));
    expect_near(resample(&turn, 0.5f, times, rotations_made, rotations_work, &out), 1.57079633, 2e-7);
}

/* Rates at which new keys fall on all keys and quarters of the source: what is lost lies between the new ones. */
static void the_error_of_resampling_shows_between_the_new_keys(void **state)
{
    (void)state;
    const float at[4] = {0, 1, 1, 2}, ease[6] = {0, 0, 0, 0, 1, 0}, jump[4] = {0, 0, 10, 10};
    const unsigned char modes[3] = {NKW_INTERPOLATION_STEP, NKW_INTERPOLATION_LINEAR, 0};
    const float thirds[3] = {0, 1, 2}, held[3] = {0, 10, 10};
    float times[99], made[99];
    NKW_STACK_WORK(work, NKW_TRACK_WORK(1));
    nkw_track t = {at, ease, 2, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE, NULL}, out;
    /* A parabola over 1/rate: 1/8 of the second derivative, 6 at the ends, times its square. */
    for (float rate = 4; rate <= 24; rate += 4) {
        double end = 0.125 * 6 / (double)(rate * rate) * (1 - 1 / (double)rate);
        expect_near(resample(&t, rate, times, made, work, &out), end, 0.05 * end);
    }
    t.values = jump;
    t.count = 4;
    t.interpolation = NKW_INTERPOLATION_LINEAR;
    assert_true(resample(&t, 8.0f, times, made, work, &out) >= 7.5f);
    t.times = thirds;
    t.values = held;
    t.count = 3;
    t.key_interpolation = modes;
    assert_true(resample(&t, 8.0f, times, made, work, &out) >= 7.5f);
}

static void resampling_keeps_step_where_all_is_step(void **state)
{
    (void)state;
    const float values[4] = {3, 1, 4, 5};
    unsigned char modes[4] = {NKW_INTERPOLATION_STEP, NKW_INTERPOLATION_STEP, NKW_INTERPOLATION_STEP, 0};
    float times[8], made[8];
    NKW_STACK_WORK(work, NKW_TRACK_WORK(1));
    nkw_track t = floats(values, 1, NKW_INTERPOLATION_LINEAR), out;
    t.key_interpolation = modes;
    expect_bits(resample(&t, 2.0f, times, made, work, &out), 0.0f);
    assert_int_equal(out.interpolation, NKW_INTERPOLATION_STEP);
    assert_null(out.key_interpolation);
    modes[1] = NKW_INTERPOLATION_LINEAR;
    resample(&t, 2.0f, times, made, work, &out);
    assert_int_equal(out.interpolation, NKW_INTERPOLATION_LINEAR);
}

static void resampled_rotations_that_are_normalised_are_stored_unit(void **state)
{
    (void)state;
    const float values[16] = {0, 0, 0, 1, 0.707f, 0, 0, 0.707f, 0, 0, 0, 1, 0.707f, 0, 0, 0.707f};
    float times[64], made[256];
    NKW_STACK_WORK(work, NKW_TRACK_WORK(4));
    nkw_track t = rotations(values, NKW_INTERPOLATION_LINEAR), out;
    t.kind = NKW_TRACK_ROTATION_NORMALIZED;
    assert_true(resample(&t, 30.0f, times, made, work, &out) < 2e-7f);
    assert_int_equal(out.kind, NKW_TRACK_ROTATION);
    for (size_t k = 0; k < out.count; k++) {
        nkw_quat q = {made[4 * k], made[4 * k + 1], made[4 * k + 2], made[4 * k + 3]};
        expect_near(nkw_quat_length(q), 1.0, 2e-7);
    }
}

static void the_lowest_rate_within_a_tolerance_is_found(void **state)
{
    (void)state;
    random_source r = random_from(7);
    float times[EVEN_KEYS], values[4 * EVEN_KEYS], new_times[EVEN_KEYS], made[4 * EVEN_KEYS];
    NKW_STACK_WORK(work, NKW_TRACK_WORK(4));
    nkw_track t = even_keys(&r, 0.25f, 30.0f, 0, times, values), out;
    t.width = 1;
    /* Corners at every fourth key: a quarter of the rate is enough. */
    for (size_t k = 0; k < EVEN_KEYS; k++)
        values[k] = nkw_lerp(values[k / 4 * 4], values[k / 4 * 4 + (k % 4 ? 4 : 0)], 0.25f * (float)(k % 4));
    expect_bits(resample_within(&t, 1e-5f, new_times, made, work, &out), 7.5f);
    assert_int_equal(out.count, 16);
    assert_true(track_difference(&t, &out, work) <= 1e-5f);
    expect_bits(resample_within(&t, 0.0f, new_times, made, work, &out), 30.0f);
    same_track(&out, &t);
    expect_bits(resample_within(&t, 10.0f, new_times, made, work, &out), 0.46875f * 16 / 15);
    assert_int_equal(out.count, 2);
    expect_bits(resample_within(&t, NAN, new_times, made, work, &out), 0.0f);
    assert_int_equal(out.count, 0);
}

static void no_lower_rate_of_those_tried_is_within_the_tolerance(void **state)
{
    (void)state;
    random_source r = random_from(8);
    for (int i = 0; i < 200; i++) {
        size_t count = 2 + (size_t)(random_bits(&r) % 40);
        float times[64], values[3 * 64], new_times[64], made[3 * 64];
        NKW_STACK_WORK(work, NKW_TRACK_WORK(3));
        for (size_t k = 0; k < count; k++) {
            times[k] = k ? times[k - 1] + random_between(&r, 0.01f, 0.05f) : random_between(&r, -5, 5);
            for (size_t c = 0; c < 3; c++)
                values[3 * k + c] = nkw_sin(times[k] + (float)c);
        }
        nkw_track t = {times, values, count, 3, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL}, out;
        float tolerance = 0.02f * random_unit(&r);
        float rate = resample_within(&t, tolerance, new_times, made, work, &out);
        if (rate == 0.0f) {
            assert_int_equal(out.count, 0);
            continue;
        }
        assert_in_range(out.count, 2, count);
        assert_true(track_difference(&t, &out, work) <= tolerance);
        assert_true(new_times[out.count - 1] >= times[count - 1]);
        assert_true(new_times[out.count - 1] < times[count - 1] + 1e-5f);
        size_t all = count - 1, found = out.count - 1, parts = 1;
        while ((all + parts - 1) / parts > found)
            parts *= 2;
        for (; (all + parts - 1) / parts > 1; parts *= 2) {
            size_t fewer = (all + 2 * parts - 1) / (2 * parts);
            float lower = (float)fewer / (times[all] - times[0]);
            assert_true(resample(&t, lower, new_times, made, work, &out) > tolerance - 1e-5f);
        }
    }
}

static void resampling_of_nothing_is_defined(void **state)
{
    (void)state;
    const float values[4] = {3, 1, 4, 5}, same[4] = {1, 1, 1, 1};
    const float bad_rates[4] = {0.0f, -30.0f, NAN, INFINITY};
    float times[4], made[4];
    NKW_STACK_WORK(work, NKW_TRACK_WORK(4));
    nkw_track t = floats(values, 1, NKW_INTERPOLATION_LINEAR), one = t, none = t, still = t, turn = t, out;
    for (int i = 0; i < 4; i++) {
        assert_int_equal(resample_count(&t, bad_rates[i]), 0);
        expect_bits(resample(&t, bad_rates[i], times, made, work, &out), INFINITY);
        assert_int_equal(out.count, 0);
    }
    /* Two seconds; within half an ULP of the end it is reached. */
    assert_in_range(resample_count(&t, 1e9f), 1999999800, 2000000001);
    assert_int_equal(resample_count(&t, 2e9f), 0);
    one.count = 1;
    still.times = same;
    none.count = 0;
    turn.kind = NKW_TRACK_ROTATION;
    assert_int_equal(resample_count(&none, 30.0f), 0);
    assert_int_equal(resample_count(&turn, 30.0f), 0);
    expect_bits(resample(&one, 30.0f, times, made, work, &out), 0.0f);
    assert_int_equal(out.count, 1);
    expect_bits(resample(&still, 30.0f, times, made, work, &out), 0.0f);
    assert_int_equal(out.count, 1);
    expect_bits(made[0], 5.0f);
    expect_bits(resample_within(&one, 0.0f, times, made, work, &out), 1.0f);
    expect_bits(resample_within(&still, 0.0f, times, made, work, &out), 1.0f);
    assert_int_equal(out.count, 1);
    expect_bits(resample_within(&none, 1.0f, times, made, work, &out), 0.0f);
    expect_bits(resample_within(&turn, 1.0f, times, made, work, &out), 0.0f);
    assert_int_equal(out.count, 0);
}

static void tracks_that_are_not_alike_differ_infinitely(void **state)
{
    (void)state;
    const float values[16] = {0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0};
    NKW_STACK_WORK(work, NKW_TRACK_WORK(4));
    float other[16];
    memcpy(other, values, sizeof other);
    nkw_track t = floats(values, 4, NKW_INTERPOLATION_LINEAR), thin = t, turn = t, none = t, nan = t;
    thin.width = 3;
    turn.kind = NKW_TRACK_ROTATION;
    none.count = 0;
    other[5] = NAN;
    nan.values = other;
    expect_bits(track_difference(&t, &t, work), 0.0f);
    expect_bits(track_difference(&t, &thin, work), INFINITY);
    expect_bits(track_difference(&t, &turn, work), INFINITY);
    expect_bits(track_difference(&t, &none, work), INFINITY);
    expect_bits(track_difference(&none, &t, work), INFINITY);
    expect_nan(track_difference(&t, &nan, work));
}

static void results_name_what_keeps_tracks_from_being_resampled(void **state)
{
    (void)state;
    const float at[3] = {0, 1, 2}, endless[3] = {0, 1, INFINITY}, values[12] = {0};
    float times[3], made[12], rate, difference;
    NKW_STACK_WORK(work, NKW_TRACK_WORK(4));
    nkw_track t = {at, values, 3, 4, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL}, none = t, thin = t, out;
    nkw_track_span span = {times, made, NULL, 3};
    size_t count;
    none.count = 0;
    thin.width = 3;
    const nkw_track_span nowhere = {NULL, NULL, NULL, 0};
    const nkw_work less = {work.data, work.bytes - 1}, shifted = {(char *)work.data + 4, work.bytes};
    assert_int_equal(nkw_track_resample(&t, 1.0f, nowhere, &out, &count), NKW_TOO_SMALL);
    assert_int_equal(count, 3);
    assert_int_equal(out.count, 0);
    assert_int_equal(nkw_track_resample(&none, 1.0f, nowhere, &out, &count), NKW_EMPTY);
    assert_int_equal(count, 0);
    assert_int_equal(nkw_track_resample(&t, 0.0f, nowhere, &out, &count), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_track_resample(&t, 2e9f, nowhere, &out, NULL), NKW_TOO_MANY);
    assert_int_equal(nkw_track_difference(&t, &thin, &difference, work), NKW_MISMATCHED);
    assert_int_equal(nkw_track_difference(&t, &none, &difference, work), NKW_EMPTY);
    assert_int_equal(nkw_track_difference(&t, &t, &difference, less), NKW_TOO_SMALL);
    assert_int_equal(nkw_track_difference(&t, &t, &difference, shifted), NKW_TOO_SMALL);
    expect_bits(difference, INFINITY);
    assert_int_equal(nkw_track_resample(&t, 1.0f, span, &out, NULL), NKW_OK);
    assert_int_equal(out.count, 3);
    assert_int_equal(nkw_track_resample_within(&t, -1.0f, span, &out, &rate, work), NKW_OUT_OF_RANGE);
    span.key_capacity = 2;
    assert_int_equal(nkw_track_resample(&t, 1.0f, span, &out, &count), NKW_TOO_SMALL);
    assert_int_equal(out.count, 0);
    assert_int_equal(count, 3);
    assert_int_equal(nkw_track_resample_within(&t, 1.0f, span, &out, &rate, work), NKW_TOO_SMALL);
    span.key_capacity = 3;
    assert_int_equal(nkw_track_resample_within(&t, 1.0f, span, &out, &rate, less), NKW_TOO_SMALL);
    assert_int_equal(nkw_track_resample_within(&t, 1.0f, span, &out, &rate, shifted), NKW_TOO_SMALL);
    expect_bits(rate, 0.0f);
    assert_int_equal(out.count, 0);
    t.times = endless;
    assert_int_equal(nkw_track_resample(&t, 1.0f, nowhere, &out, &count), NKW_NOT_FINITE);
    thin.kind = NKW_TRACK_ROTATION;
    assert_int_equal(nkw_track_resample(&thin, 1.0f, nowhere, &out, &count), NKW_BAD_WIDTH);
    assert_int_equal(nkw_track_validate(&thin, NULL), NKW_BAD_WIDTH);
}

/* A jump between two keys of equal time is at no rate within a tolerance. */
static void a_jump_has_no_rate(void **state)
{
    (void)state;
    const float at[3] = {0, 1, 1}, values[3] = {0, 0, 8};
    float times[3], made[3], rate = 7.0f;
    NKW_STACK_WORK(work, NKW_TRACK_WORK(1));
    const nkw_track t = {at, values, 3, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL};
    const nkw_track_span span = {times, made, NULL, 3};
    nkw_track out;
    assert_int_equal(nkw_track_resample_within(&t, 0.0f, span, &out, &rate, work), NKW_NO_RATE);
    expect_bits(rate, 0.0f);
    assert_int_equal(out.count, 0);
}

/* The keys that within may write, in arrays of exactly their size. */
static void resampling_anything_stays_within_its_arrays(void **state)
{
    (void)state;
    random_source r = random_from(9);
    for (int i = 0; i < 20000; i++) {
        float times[6], values[3 * 4 * 6];
        NKW_STACK_WORK(work, NKW_TRACK_WORK(4));
        size_t count = (size_t)(random_bits(&r) % 6), width = 1 + (size_t)(random_bits(&r) % 4);
        for (size_t k = 0; k < 6; k++)
            times[k] = i % 2   ? float_of((uint32_t)random_bits(&r))
                       : k > 0 ? times[k - 1] + random_scaled(&r, -100, 100)
                               : 0.0f;
        for (size_t k = 0; k < 72; k++)
            values[k] = float_of((uint32_t)random_bits(&r));
        nkw_track out, t = {times,
                            values,
                            count,
                            width,
                            (nkw_track_kind)(random_bits(&r) % 4),
                            (nkw_interpolation)(random_bits(&r) % 4),
                            NULL};
        float *new_times = (float *)malloc(sizeof(float) * (count + 1));
        float *made = (float *)malloc(sizeof(float) * (count * width + 1));
        assert_true(new_times && made);
        resample_within(&t, random_unit(&r), new_times + 1, made + 1, work, &out);
        assert_true(out.count <= count);
        free(new_times);
        free(made);
    }
}

static void tracks_are_compared_while_the_first_lasts(void **state)
{
    (void)state;
    const float inside[2] = {1, 2}, outside[4] = {0, 1, 2, 3}, same[2] = {5, 6}, far[4] = {90, 5, 6, -90};
    NKW_STACK_WORK(work, NKW_TRACK_WORK(1));
    nkw_track t = {inside, same, 2, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL};
    nkw_track longer = {outside, far, 4, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL};
    expect_bits(track_difference(&t, &longer, work), 0.0f);
    expect_bits(track_difference(&longer, &t, work), 96.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(resampling_at_its_own_rate_gives_the_track_back),
        cmocka_unit_test(resampled_keys_are_samples_until_the_end_is_reached_or_passed),
        cmocka_unit_test(the_error_of_resampling_shows_between_the_new_keys),
        cmocka_unit_test(the_error_of_resampling_is_what_was_lost),
        cmocka_unit_test(resampling_keeps_step_where_all_is_step),
        cmocka_unit_test(resampled_rotations_that_are_normalised_are_stored_unit),
        cmocka_unit_test(the_lowest_rate_within_a_tolerance_is_found),
        cmocka_unit_test(no_lower_rate_of_those_tried_is_within_the_tolerance),
        cmocka_unit_test(resampling_of_nothing_is_defined),
        cmocka_unit_test(tracks_that_are_not_alike_differ_infinitely),
        cmocka_unit_test(results_name_what_keeps_tracks_from_being_resampled),
        cmocka_unit_test(a_jump_has_no_rate),
        cmocka_unit_test(resampling_anything_stays_within_its_arrays),
        cmocka_unit_test(tracks_are_compared_while_the_first_lasts),
    };
    return cmocka_run_group_tests_name("track_resample", tests, NULL, NULL);
}
