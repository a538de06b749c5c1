/* SPDX-License-Identifier: MIT */
/* What cannot be converted: each reason by itself, at each key, with the result and the index that the headers state. */
#include <math.h>

#include "random.h"
#include "support/expect.h"

enum { KEYS = 4 };

static nkw_fcurve curve_of(const nkw_fcurve_key *keys, size_t count)
{
    nkw_fcurve c = {keys, count, NKW_FCURVE_OUTSIDE_HOLD, NKW_FCURVE_OUTSIDE_HOLD, 0, 0, NKW_HANDLE_NONE};
    return c;
}

/* Keys at 0, 1, 2 ... of values 0, 2, 0 ..., level handles of a quarter. */
static void make_keys(nkw_fcurve_key *keys)
{
    for (int k = 0; k < KEYS; k++) {
        nkw_fcurve_key key = {(float)k,   (float)(k % 2 * 2), {-0.25f, 0},
                              {0.25f, 0}, NKW_FCURVE_BEZIER,  NKW_EASE_LINEAR};
        keys[k] = key;
    }
}

/* ---- Slopes ---- */

static void make_slopes(nkw_slope_key *slopes, nkw_weighted weighted)
{
    for (int k = 0; k < KEYS; k++) {
        nkw_slope_key s = {(float)k, 1, 0.5f, -0.5f, 0.3f, 0.4f, weighted, NKW_FCURVE_BEZIER};
        slopes[k] = s;
    }
}

/* Converts; keys before the offender are written, others are not. */
static void expect_slopes(const nkw_slope_key *slopes, nkw_result want, size_t bad)
{
    nkw_fcurve_key keys[KEYS];
    size_t got = 99;
    for (int k = 0; k < KEYS; k++)
        keys[k].value = 77;
    assert_int_equal(nkw_fcurve_from_slope_keys(slopes, KEYS, NKW_WEIGHT_SECONDS, keys, &got), want);
    assert_int_equal(got, want == NKW_OK ? 0 : bad);
    assert_int_equal(nkw_fcurve_from_slope_keys(slopes, KEYS, NKW_WEIGHT_SECONDS, keys, NULL), want);
    for (size_t k = 0; k < KEYS; k++)
        expect_bits(keys[k].value, want == NKW_OK || k < bad ? slopes[k].value : 77);
}

static void each_number_of_a_slope_key_is_checked(void **state)
{
    (void)state;
    const float bad[3] = {NAN, INFINITY, -INFINITY};
    nkw_slope_key slopes[KEYS];
    for (size_t i = 0; i < KEYS * 3 * 4; i++) {
        const size_t k = i % KEYS;
        const float number = bad[i / KEYS % 3];
        const nkw_weighted weighted = (nkw_weighted)(i / KEYS / 3);
        const nkw_result of_in = (unsigned)weighted & NKW_WEIGHTED_IN ? NKW_NOT_FINITE : NKW_OK;
        const nkw_result of_out = (unsigned)weighted & NKW_WEIGHTED_OUT ? NKW_NOT_FINITE : NKW_OK;
        const nkw_result of_slope = number != number ? NKW_NOT_FINITE : NKW_OK;
        make_slopes(slopes, weighted);
        slopes[k].time = number;
        expect_slopes(slopes, NKW_NOT_FINITE, k);
        make_slopes(slopes, weighted);
        slopes[k].value = number;
        expect_slopes(slopes, NKW_NOT_FINITE, k);
        make_slopes(slopes, weighted);
        slopes[k].in_slope = number;
        expect_slopes(slopes, of_slope, k);
        make_slopes(slopes, weighted);
        slopes[k].out_slope = number;
        expect_slopes(slopes, of_slope, k);
        /* A weight counts where `weighted` names it. */
        make_slopes(slopes, weighted);
        slopes[k].in_weight = number;
        expect_slopes(slopes, of_in, k);
        make_slopes(slopes, weighted);
        slopes[k].out_weight = number;
        expect_slopes(slopes, of_out, k);
    }
}

static void kinds_and_units_of_slopes_are_checked(void **state)
{
    (void)state;
    nkw_slope_key slopes[KEYS];
    nkw_fcurve_key keys[KEYS];
    size_t bad;
    for (size_t k = 0; k < KEYS; k++) {
        make_slopes(slopes, NKW_WEIGHTED_BOTH);
        slopes[k].weighted = (nkw_weighted)4;
        expect_slopes(slopes, NKW_BAD_METHOD, k);
        slopes[k].weighted = (nkw_weighted)-1;
        expect_slopes(slopes, NKW_BAD_METHOD, k);
        make_slopes(slopes, NKW_WEIGHTED_BOTH);
        slopes[k].kind = NKW_FCURVE_EASE;
        expect_slopes(slopes, NKW_BAD_METHOD, k);
        if (k == 0)
            continue;
        make_slopes(slopes, NKW_WEIGHTED_BOTH);
        slopes[k].time = slopes[k - 1].time - 0.5f;
        expect_slopes(slopes, NKW_NOT_ASCENDING, k);
    }
    make_slopes(slopes, NKW_WEIGHTED_BOTH);
    assert_int_equal(nkw_fcurve_from_slope_keys(slopes, 0, NKW_WEIGHT_LENGTH, keys, &bad), NKW_EMPTY);
    assert_int_equal(nkw_fcurve_from_slope_keys(slopes, KEYS, (nkw_weight_unit)3, keys, &bad), NKW_BAD_METHOD);
    assert_int_equal(bad, 0);
    make_keys(keys);
    assert_int_equal(nkw_slope_keys_from_fcurve(keys, 0, NKW_WEIGHT_LENGTH, slopes, &bad), NKW_EMPTY);
    assert_int_equal(nkw_slope_keys_from_fcurve(keys, KEYS, (nkw_weight_unit)3, slopes, &bad), NKW_BAD_METHOD);
    keys[1].value = NAN;
    assert_int_equal(nkw_slope_keys_from_fcurve(keys, KEYS, NKW_WEIGHT_LENGTH, slopes, &bad), NKW_NOT_FINITE);
    assert_int_equal(bad, 1);
}

/* Its line has no slope: both ends have 0. */
static void a_line_without_a_duration_is_level(void **state)
{
    (void)state;
    nkw_fcurve_key keys[KEYS];
    nkw_slope_key slopes[KEYS];
    make_keys(keys);
    keys[1].kind = NKW_FCURVE_LINEAR;
    keys[2].time = keys[1].time;
    assert_int_equal(nkw_slope_keys_from_fcurve(keys, KEYS, NKW_WEIGHT_FRACTION, slopes, NULL), NKW_OK);
    expect_bits(slopes[1].out_slope, 0);
    expect_bits(slopes[2].in_slope, 0);
    keys[2].time = keys[1].time + 0.5f;
    assert_int_equal(nkw_slope_keys_from_fcurve(keys, KEYS, NKW_WEIGHT_FRACTION, slopes, NULL), NKW_OK);
    expect_bits(slopes[1].out_slope, -4);
    expect_bits(slopes[2].in_slope, -4);
}

/* ---- Blender ---- */

static void make_blender(nkw_blender_key *keys)
{
    for (int k = 0; k < KEYS; k++) {
        const float time = (float)k;
        nkw_blender_key key = {{time - 0.25f, 1}, {time, 1}, {time + 0.25f, 1}, 2, 0};
        keys[k] = key;
    }
}

static void expect_blender(const nkw_blender_key *blender, nkw_result want, size_t bad)
{
    nkw_fcurve_key keys[KEYS];
    size_t got = 99;
    assert_int_equal(nkw_fcurve_from_blender_keys(blender, KEYS, keys, &got), want);
    assert_int_equal(got, bad);
}

static void numbers_that_blender_does_not_have_are_refused(void **state)
{
    (void)state;
    nkw_blender_key keys[KEYS];
    make_blender(keys);
    expect_blender(keys, NKW_OK, 0);
    for (size_t k = 0; k < KEYS; k++) {
        const int wrong[4] = {-1, 13, 7, 8}; /* 7 and 8 are elastic and expo */
        for (int i = 0; i < 4; i++) {
            make_blender(keys);
            keys[k].interpolation = wrong[i];
            expect_blender(keys, NKW_BAD_METHOD, k);
        }
        for (int easing = -1; easing < 5; easing += 5) {
            make_blender(keys);
            keys[k].easing = easing;
            expect_blender(keys, NKW_BAD_METHOD, k);
        }
        make_blender(keys);
        keys[k].easing = 3;
        expect_blender(keys, NKW_OK, 0);
        /* Of two errors the first counts, of whatever kind. */
        keys[k].easing = 4;
        keys[2].center.value = NAN;
        expect_blender(keys, k <= 1 ? NKW_BAD_METHOD : NKW_NOT_FINITE, k <= 1 ? k : 2);
    }
}

static void keys_that_blender_does_not_have_are_refused(void **state)
{
    (void)state;
    nkw_fcurve_key keys[KEYS];
    nkw_blender_key blender[KEYS];
    size_t bad;
    for (size_t k = 0; k < KEYS; k++) {
        make_keys(keys);
        keys[k].kind = NKW_FCURVE_CONSTANT_NEXT;
        assert_int_equal(nkw_blender_keys_from_fcurve(keys, KEYS, blender, &bad), NKW_BAD_METHOD);
        assert_int_equal(bad, k);
        keys[k].kind = NKW_FCURVE_EASE;
        keys[k].ease = NKW_EASE_CSS_IN;
        assert_int_equal(nkw_blender_keys_from_fcurve(keys, KEYS, blender, &bad), NKW_BAD_METHOD);
        assert_int_equal(bad, k);
        keys[k].kind = NKW_FCURVE_BEZIER;
        keys[k].out.time = INFINITY;
        assert_int_equal(nkw_blender_keys_from_fcurve(keys, KEYS, blender, &bad), NKW_NOT_FINITE);
        assert_int_equal(bad, k);
    }
    assert_int_equal(nkw_blender_keys_from_fcurve(keys, 0, blender, &bad), NKW_EMPTY);
}

/* ---- CSS ---- */

static void css_needs_handles_within_the_segment(void **state)
{
    (void)state;
    float css[4];
    nkw_fcurve_key keys[KEYS];
    make_keys(keys);
    assert_int_equal(nkw_fcurve_to_css(keys, css), NKW_OK);
    const float want[4] = {0.25f, 0, 0.75f, 1};
    expect_floats_bits(css, want, 4);
    const float outside[2] = {-0.125f, 1.125f};
    for (int i = 0; i < 2; i++) {
        make_keys(keys);
        keys[0].out.time = outside[i];
        assert_int_equal(nkw_fcurve_to_css(keys, css), NKW_OUT_OF_RANGE);
        make_keys(keys);
        keys[1].in.time = -outside[i];
        assert_int_equal(nkw_fcurve_to_css(keys, css), NKW_OUT_OF_RANGE);
        /* The very ends are within. */
        make_keys(keys);
        keys[0].out.time = (float)i;
        keys[1].in.time = -(float)i;
        assert_int_equal(nkw_fcurve_to_css(keys, css), NKW_OK);
        expect_bits(css[0], (float)i);
        expect_bits(css[2], 1 - (float)i);
    }
}

/* Between equal values y has no unit: only a level segment has a cubic-bezier(). */
static void css_between_equal_values_must_be_level(void **state)
{
    (void)state;
    float css[4];
    nkw_fcurve_key keys[KEYS];
    make_keys(keys);
    keys[1].value = keys[0].value;
    assert_int_equal(nkw_fcurve_to_css(keys, css), NKW_OK);
    const float want[4] = {0.25f, 0, 0.75f, 1};
    expect_floats_bits(css, want, 4);
    keys[0].out.value = 0.5f;
    assert_int_equal(nkw_fcurve_to_css(keys, css), NKW_OUT_OF_RANGE);
    keys[1].in.value = 0.5f;
    assert_int_equal(nkw_fcurve_to_css(keys, css), NKW_OUT_OF_RANGE);
    keys[0].out.value = 0;
    assert_int_equal(nkw_fcurve_to_css(keys, css), NKW_OUT_OF_RANGE);
}

/* ---- Splines and tracks ---- */

static void a_component_of_rotations_is_not_a_curve(void **state)
{
    (void)state;
    const float times[2] = {0, 1}, values[8] = {0, 0, 0, 1, 0, 1, 0, 0};
    nkw_track track = {.times = times, .values = values, .count = 2, .width = 4};
    nkw_fcurve_key keys[2];
    size_t bad = 9;
    assert_int_equal(nkw_fcurve_from_track(&track, 3, keys, &bad), NKW_OK);
    expect_bits(keys[0].value, 1);
    assert_int_equal(nkw_fcurve_from_track(&track, 4, keys, &bad), NKW_OUT_OF_RANGE);
    track.kind = NKW_TRACK_ROTATION;
    assert_int_equal(nkw_fcurve_from_track(&track, 3, keys, &bad), NKW_MISMATCHED);
    assert_int_equal(nkw_fcurve_from_track(&track, 4, keys, &bad), NKW_MISMATCHED);
    assert_int_equal(bad, 0);
}

/* ---- Tracks from fcurves ---- */

/* Beyond its own keys a curve may hold or go on, but not cycle: the track would end within a cycle. */
static void a_curve_of_fewer_keys_may_not_cycle(void **state)
{
    (void)state;
    enum { ROOM = 200 };
    static float times[ROOM], values[6 * ROOM];
    nkw_fcurve_key all[KEYS], few[KEYS];
    const nkw_track_span memory = {times, values, NULL, ROOM};
    nkw_track track;
    make_keys(all);
    make_keys(few);
    for (int before = 0; before <= NKW_FCURVE_OUTSIDE_OSCILLATE; before++)
        for (int after = 0; after <= NKW_FCURVE_OUTSIDE_OSCILLATE; after++)
            for (int part = 0; part < 4; part++) {
                const int late = part & 1, early = part >> 1;
                nkw_fcurve curves[2] = {curve_of(all, KEYS), curve_of(few + early, KEYS - (size_t)(early + late))};
                curves[1].before = (nkw_fcurve_outside)before;
                curves[1].after = (nkw_fcurve_outside)after;
                int refused =
                    (early && before > NKW_FCURVE_OUTSIDE_LINEAR) || (late && after > NKW_FCURVE_OUTSIDE_LINEAR);
                assert_int_equal(nkw_track_from_fcurves(curves, 2, 0.01f, memory, &track, NULL),
                                 refused ? NKW_MISMATCHED : NKW_OK);
                assert_true(refused || (track.times[0] == 0 && track.times[track.count - 1] == KEYS - 1));
            }
}

/* The track of a curve; its times ascend strictly. */
static nkw_track track_of(const nkw_fcurve *curves, size_t width, float tolerance, nkw_track_span memory,
                          float *difference)
{
    nkw_track track;
    assert_int_equal(nkw_track_from_fcurves(curves, width, tolerance, memory, &track, difference), NKW_OK);
    assert_int_equal(nkw_track_validate(&track, NULL), NKW_OK);
    for (size_t k = 1; k < track.count; k++)
        assert_true(track.times[k - 1] < track.times[k]);
    return track;
}

/* One key holds its value beside a curve of more. */
static void a_curve_of_one_key_is_a_constant_component(void **state)
{
    (void)state;
    enum { ROOM = 400 };
    static float times[ROOM], values[6 * ROOM];
    nkw_track_span memory = {times, values, NULL, ROOM};
    nkw_fcurve_key keys[KEYS], one[1];
    float difference;
    make_keys(keys);
    for (int k = -1; k <= KEYS; k++) {
        one[0] = keys[1];
        one[0].time = (float)k;
        const nkw_fcurve curves[2] = {curve_of(keys, KEYS), curve_of(one, 1)};
        nkw_track track = track_of(curves, 2, 0.01f, memory, &difference);
        for (int i = 0; i <= 60; i++) {
            float got[2], time = 0.05f * (float)i;
            nkw_track_sample(&track, time, NULL, got);
            expect_near(got[0], nkw_fcurve_sample(&curves[0], time, NULL).value, 0.011);
            expect_bits(got[1], one[0].value);
        }
    }
}

/* Float times end the division: within eight floats, and at a vertical tangent. The difference says what is left. */
static void float_times_end_the_division(void **state)
{
    (void)state;
    enum { ROOM = 20000 };
    static float times[ROOM], values[3 * ROOM];
    nkw_track_span memory = {times, values, NULL, ROOM};
    float difference;
    for (int floats = 1; floats <= 8; floats++) {
        const nkw_fcurve_key keys[2] = {
            {1, 0, {0, 0}, {0, 5}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
            {1 + 0x1p-23f * (float)floats, 1, {0, -5}, {0, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR}};
        const nkw_fcurve c = curve_of(keys, 2);
        nkw_track track = track_of(&c, 1, 0, memory, &difference);
        assert_true(track.count >= 2 && track.count <= 1 + (size_t)floats);
        assert_true(difference >= 0 && difference < INFINITY);
        for (size_t k = 0; k < track.count; k++)
            expect_bits(track.values[3 * k + 1], nkw_fcurve_sample(&c, track.times[k], NULL).value);
    }
    const nkw_fcurve_key steep[2] = {{0, 0, {0, 0}, {0, 1}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                                     {1, 1, {-0.5f, 0}, {0, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR}};
    const nkw_fcurve c = curve_of(steep, 2);
    nkw_track track = track_of(&c, 1, 1e-6f, memory, &difference);
    assert_true(difference < 1e-3f && track.times[1] < 0x1p-20f);
}

/* Each capacity below the need is TOO_SMALL, before a jump and after it, and nothing beyond it is written. */
static void too_little_memory_for_a_jump_is_refused(void **state)
{
    (void)state;
    enum { ROOM = 64 };
    float times[ROOM], values[3 * ROOM];
    nkw_fcurve_key keys[KEYS];
    make_keys(keys);
    keys[1].kind = NKW_FCURVE_CONSTANT;
    keys[2].time = nextafterf(keys[1].time, 9); /* a step of one float */
    const nkw_fcurve c = curve_of(keys, KEYS);
    nkw_track_span memory = {times, values, NULL, ROOM};
    float difference;
    const size_t need = track_of(&c, 1, 0.01f, memory, &difference).count;
    for (size_t room = 0; room <= need; room++) {
        nkw_track track;
        times[room] = values[3 * room] = 77;
        memory.key_capacity = room;
        assert_int_equal(nkw_track_from_fcurves(&c, 1, 0.01f, memory, &track, &difference),
                         room < need ? NKW_TOO_SMALL : NKW_OK);
        assert_true(times[room] == 77 && values[3 * room] == 77);
        assert_true(room == need || (track.count == 0 && difference == INFINITY));
    }
}

static void css_has_no_other_curves(void **state)
{
    (void)state;
    nkw_fcurve_key keys[2] = {{0, 1, {0, 0}, {1.5f, 1}, NKW_FCURVE_BEZIER, NKW_EASE_CSS},
                              {1, 2, {-0.5f, 0}, {0, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR}};
    float css[4];
    const float line[4] = {0, 0, 1, 1}, ease[4] = {0.25f, 0.1f, 0.25f, 1};
    assert_int_equal(nkw_fcurve_to_css(keys, css), NKW_OUT_OF_RANGE);
    keys[0].kind = NKW_FCURVE_LINEAR;
    assert_int_equal(nkw_fcurve_to_css(keys, css), NKW_OK);
    expect_floats_bits(css, line, 4);
    keys[0].kind = NKW_FCURVE_EASE;
    assert_int_equal(nkw_fcurve_to_css(keys, css), NKW_OK);
    expect_floats_bits(css, ease, 4);
    keys[0].ease = NKW_EASE_SINE_IN;
    assert_int_equal(nkw_fcurve_to_css(keys, css), NKW_BAD_METHOD);
    keys[0].kind = NKW_FCURVE_BEZIER;
    keys[0].out.time = 0.5f;
    keys[0].value = 2;
    assert_int_equal(nkw_fcurve_to_css(keys, css), NKW_OUT_OF_RANGE);
    keys[1].time = 0;
    assert_int_equal(nkw_fcurve_to_css(keys, css), NKW_OUT_OF_RANGE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_number_of_a_slope_key_is_checked),
        cmocka_unit_test(kinds_and_units_of_slopes_are_checked),
        cmocka_unit_test(a_line_without_a_duration_is_level),
        cmocka_unit_test(numbers_that_blender_does_not_have_are_refused),
        cmocka_unit_test(keys_that_blender_does_not_have_are_refused),
        cmocka_unit_test(css_needs_handles_within_the_segment),
        cmocka_unit_test(css_between_equal_values_must_be_level),
        cmocka_unit_test(a_component_of_rotations_is_not_a_curve),
        cmocka_unit_test(a_curve_of_fewer_keys_may_not_cycle),
        cmocka_unit_test(a_curve_of_one_key_is_a_constant_component),
        cmocka_unit_test(float_times_end_the_division),
        cmocka_unit_test(too_little_memory_for_a_jump_is_refused),
        cmocka_unit_test(css_has_no_other_curves),
    };
    return cmocka_run_group_tests_name("dialect_errors", tests, NULL, NULL);
}
