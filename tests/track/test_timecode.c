/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

static const nkw_rate film = {24, 1}, pal = {25, 1}, ntsc = {30000, 1001}, fast = {60000, 1001},
                      fbx = {NKW_RATE_FBX, 1}, seconds = {1, 1};

static int64_t converted(int64_t count, nkw_rate from, nkw_rate to, nkw_round round)
{
    int64_t out = -99;
    assert_int_equal(nkw_ticks_convert(count, from, to, round, &out), NKW_OK);
    return out;
}

static int64_t ticks(double time, nkw_rate rate, nkw_round round)
{
    int64_t out = -99;
    assert_int_equal(nkw_ticks_from_seconds(time, rate, round, &out), NKW_OK);
    return out;
}

static double seconds_of(int64_t count, nkw_rate rate)
{
    double time;
    assert_int_equal(nkw_ticks_to_seconds(count, rate, &time), NKW_OK);
    return time;
}

static void frames_convert_exactly_where_the_rates_allow(void **state)
{
    (void)state;
    assert_int_equal(converted(48, film, seconds, NKW_ROUND_NEAREST), 2);
    assert_int_equal(converted(1001, ntsc, pal, NKW_ROUND_NEAREST), 835);
    assert_int_equal(converted(1, ntsc, fbx, NKW_ROUND_NEAREST), 1541078139); /* FBX's NTSC frame, 1541078138.6 */
    assert_int_equal(converted(1, film, fbx, NKW_ROUND_NEAREST), 1924423250);
    assert_int_equal(converted(-1, film, fbx, NKW_ROUND_NEAREST), -1924423250);
    for (int64_t k = -100000; k < 100000; k += 37) {
        assert_int_equal(converted(converted(k, film, fbx, NKW_ROUND_DOWN), fbx, film, NKW_ROUND_DOWN), k);
        assert_int_equal(converted(converted(k, ntsc, fbx, NKW_ROUND_NEAREST), fbx, ntsc, NKW_ROUND_NEAREST), k);
        assert_int_equal(converted(converted(k, ntsc, fbx, NKW_ROUND_UP), fbx, ntsc, NKW_ROUND_DOWN), k);
    }
}

static void each_rounding_is_what_it_says(void **state)
{
    (void)state;
    nkw_rate two = {2, 1};
    const int64_t half[4][4] = {{1, 1, 0, 1}, {-1, 0, -1, 0}, {3, 2, 1, 2}, {-3, -1, -2, -1}};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++) {
            assert_int_equal(converted(half[i][0], two, seconds, (nkw_round)k), half[i][k + 1]);
            assert_int_equal(ticks(0.5 * (double)half[i][0], seconds, (nkw_round)k), half[i][k + 1]);
        }
    nkw_rate three = {3, 1};
    assert_int_equal(converted(1, three, seconds, (nkw_round)9), 0);
    assert_int_equal(converted(2, three, seconds, NKW_ROUND_NEAREST), 1);
    assert_int_equal(converted(-2, three, seconds, NKW_ROUND_NEAREST), -1);
    assert_int_equal(converted(-1, three, seconds, NKW_ROUND_DOWN), -1);
    assert_int_equal(ticks(-1e-300, seconds, NKW_ROUND_DOWN), -1);
    assert_int_equal(ticks(4.9e-324, seconds, NKW_ROUND_UP), 1);
    assert_int_equal(ticks(4.9e-324, seconds, NKW_ROUND_NEAREST), 0);
    assert_int_equal(ticks(-0.0, seconds, NKW_ROUND_DOWN), 0);
}

static void seconds_are_correctly_rounded(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 20000; i++) {
        int64_t count = (int64_t)(random_bits(&r) >> (11 + random_bits(&r) % 50));
        double exact = (double)count; /* below 2^53: one rounding by the division */
        nkw_rate rate = {1 + (int64_t)(random_bits(&r) % 1000000), 1};
        assert_true(seconds_of(count, rate) == exact / (double)rate.numerator);
        assert_true(seconds_of(-count, rate) == -exact / (double)rate.numerator);
    }
    assert_true(seconds_of(1, ntsc) == 1001.0 / 30000.0);
    assert_true(seconds_of(0, ntsc) == 0.0);
    assert_true(seconds_of(INT64_MAX, seconds) == 0x1p63);
    assert_true(seconds_of(INT64_MIN, seconds) == -0x1p63);
    assert_true(seconds_of((INT64_C(1) << 53) + 1, seconds) == 0x1p53);
    assert_true(seconds_of((INT64_C(1) << 53) + 3, seconds) == 0x1p53 + 4);
    nkw_rate most = {INT64_C(1) << 40, 1}, slow = {1, INT64_C(1) << 22};
    assert_true(seconds_of(1, most) == 0x1p-40);
    assert_true(seconds_of(1, slow) == 0x1p22);
    assert_true(seconds_of(INT64_MAX, slow) == 0x1p85);
}

static void frames_come_back_from_seconds(void **state)
{
    (void)state;
    const nkw_rate rates[] = {film, pal, ntsc, fast, fbx, {NKW_RATE_FLICKS, 1}, {NKW_RATE_3DS_MAX, 1}};
    random_source r = random_from(2);
    int below = 0;
    for (int i = 0; i < 100000; i++) {
        int64_t k = (int64_t)(random_bits(&r) >> (13 + random_bits(&r) % 45));
        nkw_rate rate = rates[i % 7];
        assert_int_equal(ticks(seconds_of(k, rate), rate, NKW_ROUND_NEAREST), k);
        assert_int_equal(ticks(seconds_of(-k, rate), rate, NKW_ROUND_NEAREST), -k);
        below += ticks(seconds_of(k, rate), rate, NKW_ROUND_DOWN) < k;
    }
    assert_true(below > 0);
    for (int i = 0; i < 20000; i++) { /* the slowest rates too: seconds beyond 2^63 */
        int64_t k = (int64_t)(random_bits(&r) >> (13 + random_bits(&r) % 45));
        nkw_rate rate = {1 + (int64_t)(random_bits(&r) >> (24 + random_bits(&r) % 40)),
                         1 + (int64_t)(random_bits(&r) >> (42 + random_bits(&r) % 22))};
        assert_int_equal(ticks(seconds_of(k, rate), rate, NKW_ROUND_NEAREST), k);
    }
    /* 3003/30000 is rounded downwards. */
    assert_int_equal(ticks(seconds_of(3, ntsc), ntsc, NKW_ROUND_DOWN), 2);
}

static void a_hundred_hours_of_frames_add_up(void **state)
{
    (void)state;
    int64_t frame = 0, per_step = 7;
    for (int i = 0; i < 1000000; i++)
        frame += per_step;
    assert_int_equal(converted(frame, ntsc, seconds, NKW_ROUND_NEAREST), 233567); /* 7e6 1001/30000 = 233566.67 */
    assert_true(seconds_of(frame, ntsc) == 7007000000.0 / 30000.0);
}

static void what_does_not_fit_is_refused(void **state)
{
    (void)state;
    int64_t out = 5;
    nkw_rate bad[] = {{0, 1}, {1, 0}, {-30, 1}, {30, -1}, {(INT64_C(1) << 40) + 1, 1}, {1, (INT64_C(1) << 22) + 1}};
    for (int i = 0; i < 6; i++) {
        assert_int_equal(nkw_ticks_convert(1, bad[i], film, NKW_ROUND_DOWN, &out), NKW_NO_RATE);
        assert_int_equal(out, 0);
        assert_int_equal(nkw_ticks_convert(1, film, bad[i], NKW_ROUND_DOWN, &out), NKW_NO_RATE);
        assert_int_equal(nkw_ticks_from_seconds(1, bad[i], NKW_ROUND_DOWN, &out), NKW_NO_RATE);
        double time = 7.0;
        assert_int_equal(nkw_ticks_to_seconds(1, bad[i], &time), NKW_NO_RATE);
        assert_true(time == 0.0);
    }
    assert_int_equal(nkw_ticks_convert(INT64_MAX, film, fbx, NKW_ROUND_DOWN, &out), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_ticks_convert(INT64_MAX, film, film, NKW_ROUND_UP, &out), NKW_OK);
    assert_true(out == INT64_MAX);
    assert_int_equal(nkw_ticks_from_seconds(NAN, film, NKW_ROUND_UP, &out), NKW_NOT_FINITE);
    assert_int_equal(nkw_ticks_from_seconds(-INFINITY, film, NKW_ROUND_UP, &out), NKW_NOT_FINITE);
    assert_int_equal(nkw_ticks_from_seconds(1e300, film, NKW_ROUND_UP, &out), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_ticks_from_seconds(0x1p63, seconds, NKW_ROUND_UP, &out), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_ticks_from_seconds(0x1p62, seconds, NKW_ROUND_UP, &out), NKW_OK);
    assert_true(out == INT64_C(1) << 62);
    /* Results of 2^63 - 2, 2^63 and nearly 2^65, of either sign. */
    const nkw_rate half = {1, 2}, one = {1, 1}, quarter = {1, 4};
    const int64_t fits = INT64_MAX / 2, exceeds = fits + 1;
    assert_int_equal(nkw_ticks_convert(fits, half, one, NKW_ROUND_UP, &out), NKW_OK);
    assert_true(out == INT64_MAX - 1);
    assert_int_equal(nkw_ticks_convert(-fits, half, one, NKW_ROUND_DOWN, &out), NKW_OK);
    assert_true(out == -(INT64_MAX - 1));
    assert_int_equal(nkw_ticks_convert(exceeds, half, one, NKW_ROUND_UP, &out), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_ticks_convert(-exceeds, half, one, NKW_ROUND_DOWN, &out), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_ticks_convert(INT64_MAX, quarter, one, NKW_ROUND_UP, &out), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_ticks_convert(-INT64_MAX, quarter, one, NKW_ROUND_DOWN, &out), NKW_OUT_OF_RANGE);
    assert_int_equal(out, 0);
}

static void expect_label(int64_t frame, int32_t per_second, int drop, nkw_timecode want, int line)
{
    nkw_timecode got;
    int64_t back = -1;
    assert_int_equal(nkw_timecode_from_frame(frame, per_second, drop, &got), NKW_OK);
    if (memcmp(&got, &want, sizeof got) != 0) {
        print_error("%d:%d:%d:%d\n", (int)got.hours, (int)got.minutes, (int)got.seconds, (int)got.frames);
        _fail(__FILE__, line);
    }
    assert_int_equal(nkw_timecode_to_frame(got, per_second, drop, &back), NKW_OK);
    assert_int_equal(back, frame);
}

/* SMPTE ST 12-1: one hour of 30000/1001 has 107892 frames. */
static void labels_follow_the_clock(void **state)
{
    (void)state;
    expect_label(1799, 30, 1, (nkw_timecode){0, 0, 59, 29}, __LINE__);
    expect_label(1800, 30, 1, (nkw_timecode){0, 1, 0, 2}, __LINE__);
    expect_label(3597, 30, 1, (nkw_timecode){0, 1, 59, 29}, __LINE__);
    expect_label(3598, 30, 1, (nkw_timecode){0, 2, 0, 2}, __LINE__);
    expect_label(17981, 30, 1, (nkw_timecode){0, 9, 59, 29}, __LINE__);
    expect_label(17982, 30, 1, (nkw_timecode){0, 10, 0, 0}, __LINE__);
    expect_label(107892, 30, 1, (nkw_timecode){1, 0, 0, 0}, __LINE__);
    expect_label(3600, 60, 1, (nkw_timecode){0, 1, 0, 4}, __LINE__);
    expect_label(90000, 25, 0, (nkw_timecode){1, 0, 0, 0}, __LINE__);
    expect_label(2589407, 30, 1, (nkw_timecode){23, 59, 59, 29}, __LINE__);
    expect_label(2589408, 30, 1, (nkw_timecode){24, 0, 0, 0}, __LINE__);
}

static void labels_ascend_and_come_back(void **state)
{
    (void)state;
    const int32_t rates[] = {24, 25, 30, 60, 30, 60, 120};
    for (int i = 0; i < 7; i++) {
        nkw_timecode last = {0, 0, 0, -1};
        for (int64_t frame = 0; frame < 100000; frame++) {
            nkw_timecode t;
            int64_t back;
            assert_int_equal(nkw_timecode_from_frame(frame, rates[i], i > 3, &t), NKW_OK);
            assert_int_equal(nkw_timecode_to_frame(t, rates[i], i > 3, &back), NKW_OK);
            assert_int_equal(back, frame);
            int64_t a = ((last.hours * 60 + last.minutes) * 60 + last.seconds) * 1000 + last.frames,
                    b = ((t.hours * 60 + t.minutes) * 60 + t.seconds) * 1000 + t.frames;
            assert_true(b > a);
            last = t;
        }
    }
}

static void labels_that_do_not_exist_are_refused(void **state)
{
    (void)state;
    const nkw_timecode bad[] = {{-1, 0, 0, 0}, {0, 60, 0, 0}, {0, -1, 0, 0}, {0, 0, 60, 0}, {0, 0, -1, 0},
                                {0, 0, 0, 30}, {0, 0, 0, -1}, {0, 1, 0, 0},  {0, 59, 0, 1}};
    int64_t out;
    nkw_timecode t;
    for (int i = 0; i < 9; i++)
        assert_int_equal(nkw_timecode_to_frame(bad[i], 30, 1, &out), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_timecode_to_frame(bad[7], 30, 0, &out), NKW_OK);
    assert_int_equal(nkw_timecode_to_frame(bad[7], 25, 1, &out), NKW_NO_RATE);
    assert_int_equal(nkw_timecode_to_frame(bad[7], 0, 0, &out), NKW_NO_RATE);
    assert_int_equal(nkw_timecode_from_frame(1, 1001, 0, &t), NKW_NO_RATE);
    assert_int_equal(nkw_timecode_from_frame(1, 24, 1, &t), NKW_NO_RATE);
    assert_int_equal(nkw_timecode_from_frame(-1, 30, 0, &t), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_timecode_from_frame(INT64_MAX, 30, 1, &t), NKW_OUT_OF_RANGE);
    assert_int_equal(t.hours + t.frames, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_convert_exactly_where_the_rates_allow),
        cmocka_unit_test(each_rounding_is_what_it_says),
        cmocka_unit_test(seconds_are_correctly_rounded),
        cmocka_unit_test(frames_come_back_from_seconds),
        cmocka_unit_test(a_hundred_hours_of_frames_add_up),
        cmocka_unit_test(what_does_not_fit_is_refused),
        cmocka_unit_test(labels_follow_the_clock),
        cmocka_unit_test(labels_ascend_and_come_back),
        cmocka_unit_test(labels_that_do_not_exist_are_refused),
    };
    return cmocka_run_group_tests_name("timecode", tests, NULL, NULL);
}
