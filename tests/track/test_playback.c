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
    nkw_playback_step step = {times, count, duration, from, to, 0};
    size_t passed = 99;
    nkw_result result = nkw_playback_passed(&step, out, capacity, &passed);
    assert_true((result == NKW_TOO_SMALL) == (passed > capacity && result != NKW_TOO_MANY));
    assert_true(result == NKW_OK || result == NKW_TOO_SMALL || passed == (result == NKW_TOO_MANY ? SIZE_MAX : 0));
    return passed;
}

static nkw_result result_of(float duration, float from, float to)
{
    const float times[2] = {0, 0.5f};
    nkw_playback_step step = {times, 2, duration, from, to, 0};
    size_t passed, keys[2];
    return nkw_playback_passed(&step, keys, 2, &passed);
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
    for (int mode = NKW_PLAYBACK_LOOP; mode <= NKW_PLAYBACK_PING_PONG; mode++) {
        expect_head(nkw_playback_head((nkw_playback)mode, 0, FLT_MIN, FLT_MAX), 0, 0, __LINE__);
        expect_head(nkw_playback_head((nkw_playback)mode, 1, 1, 0x1p52f), 1, 0, __LINE__);
        expect_head(nkw_playback_head((nkw_playback)mode, 0, 1, 0x1p50f), 0, 0x1p50f, __LINE__);
    }
}

/* The head in binary64 is before the end; its nearest float is the end. */
static void a_rounded_head_of_a_loop_is_before_its_end(void **state)
{
    (void)state;
    nkw_playback_range range = {1, 2, 0, NKW_PLAYBACK_LOOP, NKW_PLAYBACK_LOOP, 0, 0};
    const float before = 1 - 0x1p-24f; /* 2^-24 before the start: 3 - 2^-24 of cycle -1 */
    nkw_play_head_f64 wide = nkw_playback_head_f64(&range, (double)before);
    assert_true(wide.time == 3 - 0x1p-24 && wide.cycle == -1);
    expect_bits((float)wide.time, 3);
    expect_head(nkw_playback_head(NKW_PLAYBACK_LOOP, 1, 2, before), 1, 0, __LINE__);
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

/*
 * Where the quotient is rounded up to a whole number, the rest is that of the pass before; exact, by rational numbers:
 * time = 0x1.2c34d9a128p+39 durations + 0.702317476272583.
 */
static void a_rest_below_nothing_belongs_to_the_pass_before(void **state)
{
    (void)state;
    const float duration = 0x1.679bbep-1f, time = 0x1.a5b4cp+38f, before = 0.702317476272583f;
    expect_head(nkw_playback_head(NKW_PLAYBACK_LOOP, 0, duration, time), before, (float)0x1.2c34d9a128p+39,
                __LINE__);
    expect_head(nkw_playback_head(NKW_PLAYBACK_PING_PONG, 0, duration, time), before, (float)0x1.2c34d9a128p+39,
                __LINE__);
}

/* Whole seconds: the remainder by integers. */
static void the_head_is_exact_in_far_cycles(void **state)
{
    (void)state;
    random_source r = random_from(61);
    for (int i = 0; i < 100000; i++) {
        uint64_t period = 1 + random_bits(&r) % 0xFFFFFF, cycles = random_bits(&r) >> (24 + random_bits(&r) % 16);
        float duration = (float)period, time = (float)(cycles % (UINT64_C(1) << 38) * period);
        uint64_t whole = (uint64_t)time;
        nkw_play_head got = nkw_playback_head(NKW_PLAYBACK_LOOP, 0, duration, time);
        expect_bits(got.time, (float)(whole % period));
        expect_bits(got.cycle, (float)(whole / period));
    }
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

static void steps_backwards_pass_each_key_once_in_reverse(void **state)
{
    (void)state;
    const float times[3] = {0.25f, 0.5f, 0.75f};
    size_t out[8];
    assert_int_equal(keys_passed(times, 3, 1, 2.5f, 0.5f, out, 8), 6);
    const size_t want[6] = {0, 2, 1, 0, 2, 1};
    assert_memory_equal(out, want, sizeof want);
    assert_int_equal(keys_passed(times, 3, 1, 0.5f, 0.25f, out, 8), 1);
    assert_int_equal(out[0], 0);
    assert_int_equal(keys_passed(times, 3, 0, 9, 0.5f, out, 1), 2);
    assert_int_equal(out[0], 2);
    random_source r = random_from(31);
    for (int i = 0; i < 2000; i++) {
        float a = random_between(&r, -5, 5), b = a - random_unit(&r), c = b - 3 * random_unit(&r);
        assert_int_equal(keys_passed(times, 3, 1.5f, a, b, out, 8) + keys_passed(times, 3, 1.5f, b, c, out, 8),
                         keys_passed(times, 3, 1.5f, a, c, out, 8));
        /* The mirrored clip, forwards. */
        const float mirrored[3] = {-0.75f, -0.5f, -0.25f};
        size_t there[8], n = keys_passed(times, 3, 1.5f, a, c, out, 8);
        assert_int_equal(keys_passed(mirrored, 3, 1.5f, -a, -c, there, 8), n);
        for (size_t k = 0; k < n && k < 8; k++)
            assert_int_equal(out[k], 2 - there[k]);
    }
}

static const nkw_playback C = NKW_PLAYBACK_CLAMP, L = NKW_PLAYBACK_LOOP, P = NKW_PLAYBACK_PING_PONG;

static nkw_play_head_f64 head_at(nkw_playback before, nkw_playback after, double count, double closing, double time)
{
    nkw_playback_range range = {1, 2, closing, before, after, count, count};
    return nkw_playback_head_f64(&range, time);
}

static void expect_wide(nkw_play_head_f64 got, double time, double cycle, double closing, int line)
{
    if (got.time != time || got.cycle != cycle || got.closing != closing) {
        print_error("got {%a, %g, %g}, want {%a, %g, %g}\n", got.time, got.cycle, got.closing, time, cycle, closing);
        _fail(__FILE__, line);
    }
}

static void each_side_has_a_behaviour_of_its_own(void **state)
{
    (void)state;
    expect_wide(head_at(C, L, 0, 0, -9), 1, 0, 0, __LINE__);
    expect_wide(head_at(C, L, 0, 0, 2.5), 2.5, 0, 0, __LINE__);
    expect_wide(head_at(C, L, 0, 0, 3), 1, 1, 0, __LINE__);
    expect_wide(head_at(L, C, 0, 0, 0.5), 2.5, -1, 0, __LINE__);
    expect_wide(head_at(L, C, 0, 0, 99), 3, 0, 0, __LINE__);
    expect_wide(head_at(P, C, 0, 0, 0.5), 1.5, -1, 0, __LINE__);
    expect_wide(head_at(P, C, 0, 0, -1.5), 2.5, -2, 0, __LINE__);
    expect_wide(head_at(C, P, 0, 0, 3), 3, 1, 0, __LINE__);
    expect_wide(head_at(C, P, 0, 0, 4), 2, 1, 0, __LINE__);
    expect_wide(head_at((nkw_playback)7, (nkw_playback)9, 0, 0, 4), 3, 0, 0, __LINE__);
}

static void counts_end_the_repetition(void **state)
{
    (void)state;
    expect_wide(head_at(L, L, 2, 0, 6.5), 2.5, 2, 0, __LINE__);
    expect_wide(head_at(L, L, 2, 0, 7), 3, 2, 0, __LINE__);
    expect_wide(head_at(L, L, 2.9, 0, INFINITY), 3, 2, 0, __LINE__);
    expect_wide(head_at(L, L, 2, 0, -3), 1, -2, 0, __LINE__);
    expect_wide(head_at(L, L, 2, 0, -2.5), 1.5, -2, 0, __LINE__);
    expect_wide(head_at(L, L, 2, 0, -INFINITY), 1, -2, 0, __LINE__);
    expect_wide(head_at(P, P, 1, 0, 99), 1, 1, 0, __LINE__);
    expect_wide(head_at(P, P, 2, 0, 99), 3, 2, 0, __LINE__);
    expect_wide(head_at(P, P, 1, 0, -99), 3, -1, 0, __LINE__);
    expect_wide(head_at(L, L, -3, 0, 9.5), 1.5, 4, 0, __LINE__);
    expect_wide(head_at(L, L, NAN, 0, 9.5), 1.5, 4, 0, __LINE__);
    expect_wide(head_at(L, L, 0.5, 0, 9.5), 1.5, 4, 0, __LINE__);
}

/* Whole counts come back as the number of the last cycle, up to 2^53. */
static void counts_of_any_size_are_kept(void **state)
{
    (void)state;
    const double counts[5] = {0x1p24 + 1, 0x1p51 - 1, 0x1p51 + 1, 0x1p52 + 1, 0x1p53 - 1};
    for (int i = 0; i < 5; i++) {
        expect_wide(head_at(L, L, counts[i], 0, INFINITY), 3, counts[i], 0, __LINE__);
        expect_wide(head_at(L, L, counts[i], 0, -INFINITY), 1, -counts[i], 0, __LINE__);
        expect_wide(head_at(P, P, counts[i], 0, INFINITY), 1, counts[i], 0, __LINE__);
        expect_wide(head_at(P, P, counts[i] - 1, 0, INFINITY), 3, counts[i] - 1, 0, __LINE__);
        expect_wide(head_at(P, P, counts[i], 0, -INFINITY), 3, -counts[i], 0, __LINE__);
    }
    expect_wide(head_at(L, L, 0x1p51 - 0.5, 0, INFINITY), 3, 0x1p51 - 1, 0, __LINE__);
}

/* Just before a seam the sum of start and rest rounds to the end, which is the start of the next cycle. */
static void a_loop_in_binary64_never_returns_its_end(void **state)
{
    (void)state;
    nkw_playback_range range = {0x1p30, 1, 0, NKW_PLAYBACK_LOOP, NKW_PLAYBACK_LOOP, 0, 0};
    random_source r = random_from(34);
    int rounded = 0;
    for (int i = 0; i < 40000; i++) {
        range.start = (double)random_between(&r, -1000, 1000);
        range.duration = (double)random_between(&r, 0.01f, 2) + 1e-9 * (double)random_unit(&r);
        double cycle = (double)(1 + random_bits(&r) % 50), seam = range.start + cycle * range.duration;
        double time = i % 2 ? nextafter(seam, -INFINITY) : seam;
        nkw_play_head_f64 head = nkw_playback_head_f64(&range, time);
        assert_true(head.time >= range.start && head.time < range.start + range.duration);
        rounded += head.cycle >= cycle && time < seam;
        /* At the seam after the last cycle, and a rounding before and after it, there is no next one. */
        range.after_cycles = cycle;
        for (int k = -1; k < 2; k++) {
            head = nkw_playback_head_f64(&range, seam + range.duration + k * 1e-12);
            assert_true(head.cycle == cycle && head.time > range.start + 0.5 * range.duration);
        }
        range.after_cycles = 0;
    }
    assert_true(rounded > 0);
    /* A range that is shorter than the resolution of its start has one time. */
    range.start = 0x1p60;
    range.duration = 1;
    expect_wide(nkw_playback_head_f64(&range, 0x1p60 + 512), 0x1p60, 512, 0, __LINE__);
}

static void a_closing_segment_joins_the_last_key_to_the_first(void **state)
{
    (void)state;
    expect_wide(head_at(L, L, 0, 0.5, 3), 3, 0, 0, __LINE__);
    expect_wide(head_at(L, L, 0, 0.5, 3.125), 3, 0, 0.25, __LINE__);
    expect_wide(head_at(L, L, 0, 0.5, 3.5), 1, 1, 0, __LINE__);
    expect_wide(head_at(L, L, 0, 0.5, 0.875), 3, -1, 0.75, __LINE__);
    expect_wide(head_at(L, L, 1, 0.5, 6), 3, 1, 0, __LINE__);
    expect_wide(head_at(L, L, 1, 0.5, -1.5), 1, -1, 0, __LINE__);
    expect_wide(head_at(C, C, 0, 0.5, 3.25), 3, 0, 0, __LINE__);
    expect_wide(head_at(L, L, 0, -1, 3), 1, 1, 0, __LINE__);
    expect_wide(head_at(L, L, 0, NAN, 3), 1, 1, 0, __LINE__);
}

static void odd_ranges_have_an_answer(void **state)
{
    (void)state;
    const double bad[] = {0, -1, NAN, INFINITY, 1e-300, 1e300};
    for (int i = 0; i < 6; i++) {
        nkw_playback_range range = {5, bad[i], 0, NKW_PLAYBACK_LOOP, NKW_PLAYBACK_LOOP, 0, 0};
        expect_wide(nkw_playback_head_f64(&range, 7), 5, 0, 0, __LINE__);
    }
    expect_wide(head_at(NKW_PLAYBACK_LOOP, NKW_PLAYBACK_LOOP, 0, 0, NAN), 1, 0, 0, __LINE__);
    expect_wide(head_at(NKW_PLAYBACK_LOOP, NKW_PLAYBACK_LOOP, 0, 0, INFINITY), 1, 0, 0, __LINE__);
    expect_wide(head_at(NKW_PLAYBACK_LOOP, NKW_PLAYBACK_LOOP, 0, 0, 1e300), 1, 0, 0, __LINE__);
    expect_wide(head_at(NKW_PLAYBACK_LOOP, NKW_PLAYBACK_LOOP, 0, 0, -1e300), 1, 0, 0, __LINE__);
    expect_wide(head_at(NKW_PLAYBACK_CLAMP, NKW_PLAYBACK_CLAMP, 0, 0, INFINITY), 3, 0, 0, __LINE__);
    expect_wide(head_at(NKW_PLAYBACK_LOOP, NKW_PLAYBACK_LOOP, 0, INFINITY, 9), 1, 0, 0, __LINE__);
}

/* Durations of float have the head of the float function, where its result is exact. */
static void the_wide_head_is_the_head_where_floats_are_exact(void **state)
{
    (void)state;
    random_source r = random_from(32);
    for (int i = 0; i < 20000; i++) {
        float duration = (float)(1 + random_bits(&r) % 4096) / 64,
              time = (float)(int)(random_bits(&r) % 100000) / 64 - 700;
        nkw_playback mode = (nkw_playback)(i % 3);
        nkw_playback_range range = {2, duration, 0, mode, mode, 0, 0};
        nkw_play_head want = nkw_playback_head(mode, 2, duration, time);
        expect_wide(nkw_playback_head_f64(&range, time), want.time, want.cycle, 0, __LINE__);
    }
}

/* x = n period + rest with a rest of few bits: the product of 53 bits and the cycle is exact. */
static void far_remainders_are_exact(void **state)
{
    (void)state;
    const double period = 0x1.123456789abcdp0;
    nkw_playback_range range = {0, period, 0, NKW_PLAYBACK_LOOP, NKW_PLAYBACK_LOOP, 0, 0};
    random_source r = random_from(33);
    for (int i = 0; i < 20000; i++) {
        double time = ldexp((double)(random_bits(&r) >> 11), (int)(random_bits(&r) % 45) - 53);
        nkw_play_head_f64 got = nkw_playback_head_f64(&range, time);
        long double rest = fmodl((long double)time, (long double)period);
        expect_near(got.time, (double)rest, 2.3e-16);
        expect_near(got.cycle, floor((double)(((long double)time - rest) / period) + 0.5), 0);
    }
}

/* The head after a day of a 1.7 s loop at 60 frames per second, against whole frames: 102 frames a loop. */
static void a_day_of_playing_keeps_its_place(void **state)
{
    (void)state;
    nkw_playback_range range = {0, 1.7, 0, NKW_PLAYBACK_LOOP, NKW_PLAYBACK_LOOP, 0, 0};
    double worst_wide = 0, worst_float = 0;
    for (int64_t frame = 60 * 86400 - 6000; frame < 60 * 86400; frame++) {
        double want = (double)(frame % 102) / 60;
        double wide = nkw_playback_head_f64(&range, (double)frame / 60).time;
        double narrow = (double)nkw_playback_head(NKW_PLAYBACK_LOOP, 0, 1.7f, (float)((double)frame / 60)).time;
        double off = fabs(wide - want), lost = fabs(narrow - want);
        worst_wide = fmax(worst_wide, fmin(off, fabs(off - 1.7)));
        worst_float = fmax(worst_float, fmin(lost, fabs(lost - 1.7)));
    }
    assert_true(worst_wide < 2e-11);
    assert_true(worst_float > 3e-3);
}

static void values_with_offset_continue_at_the_loop(void **state)
{
    (void)state;
    random_source r = random_from(34);
    expect_bits(nkw_playback_offset(1.5f, 1, 3, 2), 5.5f);
    expect_bits(nkw_playback_offset(1.5f, 1, 3, -2), -2.5f);
    expect_bits(nkw_playback_offset(-0.0f, 1, INFINITY, 0), -0.0f);
    for (int i = 0; i < 2000; i++) {
        nkw_vec3 first = random_vec3(&r, -2, 2), last = random_vec3(&r, -2, 2);
        double cycle = (double)(int64_t)(random_bits(&r) % 2001) - 1000;
        expect_vec3_near(nkw_vec3_playback_offset(last, first, last, cycle),
                         nkw_vec3_playback_offset(first, first, last, cycle + 1), 4e-4);
        nkw_quat a = random_rotation(&r), b = random_rotation(&r);
        expect_rotation_near(nkw_quat_playback_offset(b, a, b, cycle), nkw_quat_playback_offset(a, a, b, cycle + 1),
                             3e-7);
        expect_quat_bits(nkw_quat_playback_offset(a, b, a, 0), a);
        expect_rotation_near(nkw_quat_playback_offset(a, b, b, cycle), a, 3e-4);
    }
    nkw_quat z = nkw_quat_from_axis_angle((nkw_vec3){0, 0, 1}, 0.5f), one = nkw_quat_identity();
    double angle = fmod(1e6 * 2 * atan2(z.z, z.w), 2 * 3.14159265358979324);
    expect_rotation_near(nkw_quat_playback_offset(one, one, z, 1e6),
                         nkw_quat_from_axis_angle((nkw_vec3){0, 0, 1}, (float)angle), 5e-7);
}

static void wide_steps_pass_each_key_once(void **state)
{
    (void)state;
    const float times[4] = {0.0f, 0.1f, 0.7f, 1.6f};
    random_source r = random_from(35);
    double now = 1e6;
    size_t sum = 0, back = 0, out[64], passed = 0;
    for (int i = 0; i < 20000; i++) {
        double next = now + random_unit(&r);
        nkw_playback_step step = {times, 4, 1.7, now, next, 0}, reverse = {times, 4, 1.7, next, now, 0};
        assert_int_equal(nkw_playback_passed(&step, out, 64, &passed), NKW_OK);
        sum += passed;
        assert_int_equal(nkw_playback_passed(&reverse, out, 64, &passed), NKW_OK);
        back += passed;
        now = next;
    }
    nkw_playback_step all = {times, 4, 1.7, 1e6, now, 0}, whole = {times, 4, 1.7, now, 1e6, 0};
    assert_int_equal(nkw_playback_passed(&all, NULL, 0, &passed), NKW_TOO_SMALL);
    assert_int_equal(passed, sum);
    expect_near((double)sum, 4 * (now - 1e6) / 1.7, 4);
    assert_int_equal(nkw_playback_passed(&whole, NULL, 0, &passed), NKW_TOO_SMALL);
    assert_int_equal(passed, back);
    nkw_playback_step bad = {times, 4, NAN, 0, 1, 0};
    assert_int_equal(nkw_playback_passed(&bad, NULL, 0, &passed), NKW_NOT_FINITE);
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
        cmocka_unit_test(a_rounded_head_of_a_loop_is_before_its_end),
        cmocka_unit_test(keys_are_passed_in_half_open_steps),
        cmocka_unit_test(a_clip_played_once_passes_each_key_once),
        cmocka_unit_test(steps_that_follow_each_other_lose_and_repeat_nothing),
        cmocka_unit_test(what_does_not_fit_is_counted),
        cmocka_unit_test(passing_nothing),
        cmocka_unit_test(steps_that_cannot_be_taken_are_named),
        cmocka_unit_test(passes_that_cannot_be_counted_pass_none),
        cmocka_unit_test(a_moment_before_the_start_is_the_start),
        cmocka_unit_test(a_rest_below_nothing_belongs_to_the_pass_before),
        cmocka_unit_test(the_head_is_exact_in_far_cycles),
        cmocka_unit_test(any_time_at_all_stays_within_the_pass),
        cmocka_unit_test(ping_pong_follows_its_triangle_however_far),
        cmocka_unit_test(steps_backwards_pass_each_key_once_in_reverse),
        cmocka_unit_test(each_side_has_a_behaviour_of_its_own),
        cmocka_unit_test(counts_end_the_repetition),
        cmocka_unit_test(a_closing_segment_joins_the_last_key_to_the_first),
        cmocka_unit_test(odd_ranges_have_an_answer),
        cmocka_unit_test(the_wide_head_is_the_head_where_floats_are_exact),
        cmocka_unit_test(far_remainders_are_exact),
        cmocka_unit_test(a_day_of_playing_keeps_its_place),
        cmocka_unit_test(values_with_offset_continue_at_the_loop),
        cmocka_unit_test(wide_steps_pass_each_key_once),
        cmocka_unit_test(counts_of_any_size_are_kept),
        cmocka_unit_test(a_loop_in_binary64_never_returns_its_end),
    };
    return cmocka_run_group_tests_name("playback", tests, NULL, NULL);
}
