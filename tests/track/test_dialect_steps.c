/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

#define KEYS 5

static nkw_fcurve steps(const nkw_fcurve_key *keys)
{
    nkw_fcurve c = {keys, KEYS, NKW_FCURVE_OUTSIDE_HOLD, NKW_FCURVE_OUTSIDE_HOLD, 0, 0, NKW_HANDLE_NONE};
    return c;
}

/* Whole numbers at whole times; equal times and equal values occur. */
static void draw(random_source *r, nkw_fcurve_key keys[KEYS])
{
    float time = 0.0f;
    for (int k = 0; k < KEYS; k++, time += (float)(random_bits(r) % 3)) {
        nkw_fcurve_kind kind = random_bits(r) % 2 ? NKW_FCURVE_CONSTANT_NEXT : NKW_FCURVE_CONSTANT;
        nkw_fcurve_key key = {time, (float)(random_bits(r) % 4), {0, 0}, {0, 0}, kind, NKW_EASE_LINEAR};
        keys[k] = key;
    }
}

static void expect_samples(const nkw_track *track, const nkw_fcurve *curves, size_t width, float time)
{
    float got[2];
    nkw_track_sample(track, time, NULL, got);
    for (size_t i = 0; i < width; i++)
        expect_bits(got[i], nkw_fcurve_sample(curves + i, time, NULL).value);
}

static void a_step_to_the_next_key_is_a_step_track(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int round = 0; round < 2000; round++) {
        nkw_fcurve_key keys[2][KEYS];
        float times[4 * KEYS], values[8 * KEYS], difference;
        draw(&r, keys[0]);
        draw(&r, keys[1]);
        nkw_fcurve curves[2] = {steps(keys[0]), steps(keys[1])};
        nkw_track_span memory = {times, values, NULL, 4 * KEYS};
        nkw_track track;
        size_t width = 1 + (size_t)round % 2;
        assert_int_equal(nkw_track_from_fcurves(curves, width, 10.0f, memory, &track, &difference), NKW_OK);
        assert_int_equal(track.interpolation, NKW_INTERPOLATION_STEP);
        assert_int_equal(nkw_track_validate(&track, NULL), NKW_OK);
        expect_bits(difference, 0);
        for (size_t i = 0; i < width; i++)
            for (int k = 0; k < KEYS; k++) {
                float time = keys[i][k].time;
                expect_samples(&track, curves, width, time);
                expect_samples(&track, curves, width, fmaxf(nextafterf(time, -INFINITY), 0.0f));
                expect_samples(&track, curves, width, nextafterf(time, INFINITY));
                expect_samples(&track, curves, width, time + 0.5f);
            }
    }
}

static void steps_need_a_key_for_each_jump(void **state)
{
    (void)state;
    nkw_fcurve_key keys[KEYS];
    for (int k = 0; k < KEYS; k++) {
        nkw_fcurve_key key = {(float)k, (float)(k * k), {0, 0}, {0, 0}, NKW_FCURVE_CONSTANT_NEXT, NKW_EASE_LINEAR};
        keys[k] = key;
    }
    nkw_fcurve curve = steps(keys);
    float times[9], values[9], difference;
    nkw_track_span memory = {times, values, NULL, 9};
    nkw_track track;
    assert_int_equal(nkw_track_from_fcurves(&curve, 1, 0, memory, &track, NULL), NKW_OK);
    assert_int_equal(track.count, 9); /* a key and the float after it, four times, and the last key */
    expect_bits(track.times[1], 0x1p-149f);
    expect_bits(track.values[1], 1);
    memory.key_capacity = 8;
    assert_int_equal(nkw_track_from_fcurves(&curve, 1, 0, memory, &track, &difference), NKW_TOO_SMALL);
    assert_int_equal(track.count, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_step_to_the_next_key_is_a_step_track),
        cmocka_unit_test(steps_need_a_key_for_each_jump),
    };
    return cmocka_run_group_tests_name("dialect_steps", tests, NULL, NULL);
}
