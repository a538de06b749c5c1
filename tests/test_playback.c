/* SPDX-License-Identifier: MIT */
#include <float.h>
#include <math.h>

#include "random.h"
#include "support/expect.h"

static void expect_head(nkw_play_head got, float time, float cycle, int line)
{
    if (bits_of(got.time) != bits_of(time) || bits_of(got.cycle) != bits_of(cycle)) {
        print_error("got {%a, %g}, want {%a, %g}\n", (double)got.time, (double)got.cycle, (double)time, (double)cycle);
        _fail(__FILE__, line);
    }
}

/* 0 after an error. */
static size_t keys_passed(const float *times, size_t count, float duration, float from, float to, size_t *out,
                          size_t capacity)
{
    nkw_playback_step step = {times, count, duration, from, to};
    size_t passed = 99;
    nkw_result result = nkw_playback_passed(&step, out, &passed, capacity);
    assert_true(result == NKW_OK || passed == (result == NKW_TOO_MANY ? SIZE_MAX : 0));
    return passed;
}

static nkw_result result_of(float duration, float from, float to)
{
    const float times[2] = {0, 0.5f};
    nkw_playback_step step = {times, 2, duration, from, to};
    size_t passed;
    return nkw_playback_passed(&step, NULL, &passed, 0);
}

static void clamp_holds_both_ends(void **state)
{
    (void)state;
    expect_head(nkw_playback_head(NKW_PLAYBACK_CLAMP, 1, 2, 0.5f), 1, 0, __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_CLAMP, 1, 2, 2.5f), 2.5f, 0, __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_CLAMP, 1, 2, 9), 3, 0, __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_CLAMP, 1, 2, -INFINITY), 1, 0, __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_CLAMP, 1, 2, INFINITY), 3, 0, __LINE__);
}

static void loop_begins_again_at_its_end(void **state)
{
    (void)state;
    expect_head(nkw_playback_head(NKW_PLAYBACK_LOOP, 1, 2, 1), 1, 0, __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_LOOP, 1, 2, 2.5f), 2.5f, 0, __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_LOOP, 1, 2, 3), 1, 1, __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_LOOP, 1, 2, 8.5f), 2.5f, 3, __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_LOOP, 1, 2, 0.5f), 2.5f, -1, __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_LOOP, 1, 2, -1), 1, -1, __LINE__);
}

static void ping_pong_turns_at_both_ends(void **state)
{
    (void)state;
    expect_head(nkw_playback_head(NKW_PLAYBACK_PING_PONG, 1, 2, 1.5f), 1.5f, 0, __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_PING_PONG, 1, 2, 3), 3, 1, __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_PING_PONG, 1, 2, 3.5f), 2.5f, 1, __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_PING_PONG, 1, 2, 5), 1, 2, __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_PING_PONG, 1, 2, 0.5f), 1.5f, -1, __LINE__);
}

static void loop_never_gives_its_end_and_does_not_drift(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 50000; i++) {
        float duration = nkw_abs(random_scaled(&r, -10, 10)), start = random_scaled(&r, -3, 3);
        float time = random_scaled(&r, -10, 20);
        nkw_play_head head = nkw_playback_head(NKW_PLAYBACK_LOOP, start, duration, time);
        assert_true(head.time >= start && (head.time < start + duration || head.time == start));
        double rest = fmod((double)time - (double)start, duration);
        rest = rest < 0 ? rest + (double)duration : rest;
        double off = fabs((double)head.time - ((double)start + rest));
        /* One rounding to float; at the seam the end counts as the start. */
        double rounding = 0x1p-24 * (fabs((double)start) + (double)duration);
        assert_true(off <= rounding || fabs(off - (double)duration) <= rounding);
    }
}

/* Of a motion whose value is the time, value + cycle (last - first) is the running time, to two roundings. */
static void relative_motion_goes_on_across_the_seam(void **state)
{
    (void)state;
    expect_head(nkw_playback_head(NKW_PLAYBACK_LOOP, 0, 1, -0x1p-30f), 0, 0, __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_LOOP, 1, 0x1p-30f, 1), 1, 0, __LINE__);
    random_source r = random_from(3);
    for (int i = 0; i < 50000; i++) {
        float duration = nkw_abs(random_scaled(&r, -6, 6)), start = random_scaled(&r, -6, 6);
        double seam = (double)start + (double)(i % 9 - 4) * (double)duration;
        float time = (float)(i % 2 ? seam : seam - (double)nkw_abs(random_scaled(&r, -60, -20)));
        nkw_play_head head = nkw_playback_head(NKW_PLAYBACK_LOOP, start, duration, time);
        double on = (double)head.time + (double)head.cycle * (double)duration;
        assert_true(fabs(on - (double)time) <= 0x1p-23 * (fabs((double)start) + (double)duration));
    }
}

static void nonsense_is_the_start(void **state)
{
    (void)state;
    static const float durations[] = {0, -1, NAN, INFINITY};
    for (int mode = 0; mode < 4; mode++) {
        for (int i = 0; i < 4; i++)
            expect_head(nkw_playback_head((nkw_playback)mode, 1, durations[i], 5), 1, 0, __LINE__);
        expect_head(nkw_playback_head((nkw_playback)mode, 1, 2, NAN), 1, 0, __LINE__);
    }
    expect_head(nkw_playback_head(NKW_PLAYBACK_LOOP, 1, 2, INFINITY), 1, 0, __LINE__);
    nkw_play_head far = nkw_playback_head(NKW_PLAYBACK_LOOP, 0, FLT_MIN, FLT_MAX);
    assert_true(far.time >= 0 && far.time < FLT_MIN);
}

static void keys_are_passed_in_half_open_steps(void **state)
{
    (void)state;
    const float times[3] = {0, 0.5f, 0.75f};
    size_t out[8];
    assert_int_equal(keys_passed(times, 3, 1, 0.25f, 0.5f, out, 8), 1);
    assert_int_equal(out[0], 1);
    assert_int_equal(keys_passed(times, 3, 1, 0.5f, 0.75f, out, 8), 1);
    assert_int_equal(out[0], 2);
    assert_int_equal(keys_passed(times, 3, 1, 0.75f, 1.5f, out, 8), 2);
    assert_int_equal(out[0], 0);
    assert_int_equal(out[1], 1);
    assert_int_equal(keys_passed(times, 3, 1, -0.25f, 0, out, 8), 1);
    assert_int_equal(out[0], 0);
}

static void a_clip_played_once_passes_each_key_once(void **state)
{
    (void)state;
    const float times[3] = {0, 0.5f, 1};
    size_t out[8];
    assert_int_equal(keys_passed(times, 3, 0, -1, 100, out, 8), 3);
    assert_int_equal(keys_passed(times, 3, 0, 1, 100, out, 8), 0);
}

static void steps_that_follow_each_other_lose_and_repeat_nothing(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int round = 0; round < 300; round++) {
        float times[5], duration = random_between(&r, 0.3f, 2.0f);
        for (int k = 0; k < 5; k++)
            times[k] = duration * (float)k / 5.0f;
        float from = random_between(&r, -20, 0), now = from;
        size_t stepped[4096], whole[4096], count = 0;
        for (int i = 0; i < 60; i++) {
            float next = now + (i % 5 ? random_between(&r, 0, 0.3f) : random_between(&r, 0, 3));
            count += keys_passed(times, 5, duration, now, next, stepped + count, 4096 - count);
            now = next;
        }
        assert_int_equal(keys_passed(times, 5, duration, from, now, whole, 4096), count);
        assert_memory_equal(whole, stepped, count * sizeof whole[0]);
    }
}

static void what_does_not_fit_is_counted(void **state)
{
    (void)state;
    const float times[2] = {0, 0.5f};
    size_t out[3] = {9, 9, 9};
    assert_int_equal(keys_passed(times, 2, 1, -0.25f, 1000.25f, out, 2), 2001);
    assert_int_equal(out[0], 0);
    assert_int_equal(out[1], 1);
    assert_int_equal(out[2], 9);
    assert_int_equal(keys_passed(times, 2, 1, -0.25f, 1000.25f, NULL, 0), 2001);
    /* 2^32: more than a size_t of 32 bits holds. */
    const float four[4] = {0, 0.25f, 0.5f, 0.75f};
    const size_t all = sizeof(size_t) > 4 ? (size_t)0xffffffffu + 1 : SIZE_MAX;
    assert_true(keys_passed(four, 4, 1, 0, 0x1p30f, out, 2) == all);
    assert_int_equal(out[0], 1);
    assert_int_equal(out[2], 9);
}

static void passing_nothing(void **state)
{
    (void)state;
    const float times[2] = {0, 0.5f};
    size_t out[2];
    assert_int_equal(keys_passed(times, 2, 1, 2, 2, out, 2), 0);
    assert_int_equal(keys_passed(times, 2, 1, 3, 2, out, 2), 0);
    assert_int_equal(keys_passed(times, 2, 1, NAN, 2, out, 2), 0);
    assert_int_equal(keys_passed(times, 2, 1, 0, INFINITY, out, 2), 0);
    assert_int_equal(keys_passed(times, 2, -1, 0, 2, out, 2), 0);
    assert_int_equal(keys_passed(times, 2, NAN, 0, 2, out, 2), 0);
    assert_int_equal(keys_passed(NULL, 0, 1, 0, 2, out, 2), 0);
    assert_int_equal(keys_passed(times, 2, 1e-30f, 0, 3e38f, out, 2), 0);
}

static void steps_that_cannot_be_taken_are_named(void **state)
{
    (void)state;
    assert_int_equal(result_of(1, 0, 1), NKW_OK);
    assert_int_equal(result_of(1, 1, 0), NKW_OK);
    assert_int_equal(result_of(1, NAN, 1), NKW_NOT_FINITE);
    assert_int_equal(result_of(1, 0, INFINITY), NKW_NOT_FINITE);
    assert_int_equal(result_of(NAN, 0, 1), NKW_NOT_FINITE);
    assert_int_equal(result_of(-1, 0, 1), NKW_OUT_OF_RANGE);
    assert_int_equal(result_of(0.25f, 0, 1), NKW_OUT_OF_RANGE);
    assert_int_equal(result_of(1, 0, 0x1p40f), NKW_OUT_OF_RANGE);
    assert_int_equal(result_of(1, -0x1p60f, -0x1.fffffep59f), NKW_OUT_OF_RANGE);
}

static void passes_that_cannot_be_counted_pass_none(void **state)
{
    const float times[] = {0.25f, 0.5f};
    size_t out[4];
    (void)state;
    assert_int_equal(keys_passed(times, 2, 1e14f, 1e30f, nextafterf(1e30f, 2e30f), out, 4), 0);
    assert_int_equal(keys_passed(times, 2, 100.0f, -0x1p60f, nextafterf(-0x1p60f, 0.0f), out, 4), 0);
}

static void a_moment_before_the_start_is_the_start(void **state)
{
    (void)state;
    /* The rest of -1e-20 is 1 in binary64: the whole period, which begins the pass at 0. */
    expect_head(nkw_playback_head(NKW_PLAYBACK_LOOP, 0, 1, -1e-20f), 0, 0, __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_PING_PONG, 0, 1, -1e-20f), 0, 0, __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_LOOP, 0, 3, -1e-30f), 0, 0, __LINE__);
}

/* Where cycle times duration is rounded to more than the time, the rest is that of the pass before. */
static void a_rest_below_nothing_belongs_to_the_pass_before(void **state)
{
    (void)state;
    const float duration = 0x1.679bbep-1f, time = 0x1.a5b4cp+38f; /* 0x1.2c34d9a12ap+39 durations less 2^-14 */
    const float before = (float)((double)duration - 0x1p-14);
    expect_head(nkw_playback_head(NKW_PLAYBACK_LOOP, 0, duration, time), before, (float)(0x1.2c34d9a12ap+39 - 1),
                __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_PING_PONG, 0, duration, time), before, (float)(0x1.2c34d9a12ap+39 - 1),
                __LINE__);
}

static void any_time_at_all_stays_within_the_pass(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 100000; i++) {
        float duration = nkw_abs(random_scaled(&r, -126, 20)), time = random_scaled(&r, -100, 127);
        for (int mode = NKW_PLAYBACK_CLAMP; mode <= NKW_PLAYBACK_PING_PONG; mode++) {
            float got = nkw_playback_head((nkw_playback)mode, 0, duration, time).time;
            assert_true(got >= 0 && got <= duration);
        }
    }
}

/* From 2^29 cycles on, cycle times duration is rounded: x is off by less than its last place, on either side. */
static void ping_pong_follows_its_triangle_however_far(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 100000; i++) {
        float duration = nkw_abs(random_scaled(&r, -3, 3)), time = random_scaled(&r, 10, 46);
        double rest = fmod(fabs((double)time), 2 * (double)duration), back = 2 * (double)duration - rest;
        double want = rest < back ? rest : back;
        double got = nkw_playback_head(NKW_PLAYBACK_PING_PONG, 0, duration, time).time;
        assert_true(got >= 0 && got <= (double)duration);
        assert_true(fabs(got - want) <= 0x1p-24 * (double)duration + 0x1p-52 * fabs((double)time));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clamp_holds_both_ends),
        cmocka_unit_test(loop_begins_again_at_its_end),
        cmocka_unit_test(ping_pong_turns_at_both_ends),
        cmocka_unit_test(loop_never_gives_its_end_and_does_not_drift),
        cmocka_unit_test(relative_motion_goes_on_across_the_seam),
        cmocka_unit_test(nonsense_is_the_start),
        cmocka_unit_test(keys_are_passed_in_half_open_steps),
        cmocka_unit_test(a_clip_played_once_passes_each_key_once),
        cmocka_unit_test(steps_that_follow_each_other_lose_and_repeat_nothing),
        cmocka_unit_test(what_does_not_fit_is_counted),
        cmocka_unit_test(passing_nothing),
        cmocka_unit_test(steps_that_cannot_be_taken_are_named),
        cmocka_unit_test(passes_that_cannot_be_counted_pass_none),
        cmocka_unit_test(a_moment_before_the_start_is_the_start),
        cmocka_unit_test(a_rest_below_nothing_belongs_to_the_pass_before),
        cmocka_unit_test(any_time_at_all_stays_within_the_pass),
        cmocka_unit_test(ping_pong_follows_its_triangle_however_far),
    };
    return cmocka_run_group_tests_name("playback", tests, NULL, NULL);
}
