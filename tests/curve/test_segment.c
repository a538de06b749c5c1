/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdint.h>

#include "random.h"
#include "support/expect.h"
#include "support/resample.h"

static void expect_segment_at(nkw_segment got, size_t index, float t, int line)
{
    if (got.index != index || bits_of(got.t) != bits_of(t)) {
        print_error("got {%zu, %a}, want {%zu, %a}\n", got.index, (double)got.t, index, (double)t);
        _fail(__FILE__, line);
    }
}

#define expect_segment(got, index, t) expect_segment_at((got), (index), (t), __LINE__)

/* The definition of the header, literally. */
static nkw_segment by_definition(const float *times, size_t count, float time)
{
    nkw_segment r = {0, 0.0f};
    if (count < 2 || time != time || time < times[0])
        return r;
    for (size_t k = 0; k + 1 < count; k++)
        if (times[k] <= time && (time < times[k + 1] || k + 2 == count))
            r.index = k;
    float a = times[r.index], b = times[r.index + 1];
    r.t = (float)(((double)time - (double)a) / ((double)b - (double)a));
    r.t = time >= b ? 1.0f : r.t < 1.0f ? r.t : 0x1.fffffep-1f;
    return r;
}

static void segments_are_half_open_and_the_last_is_closed(void **state)
{
    (void)state;
    const float times[4] = {0, 1, 3, 4};
    expect_segment(nkw_segment_find(times, 4, 0.0f), 0, 0.0f);
    expect_segment(nkw_segment_find(times, 4, 0.25f), 0, 0.25f);
    expect_segment(nkw_segment_find(times, 4, 1.0f), 1, 0.0f);
    expect_segment(nkw_segment_find(times, 4, 2.0f), 1, 0.5f);
    expect_segment(nkw_segment_find(times, 4, 3.0f), 2, 0.0f);
    expect_segment(nkw_segment_find(times, 4, 4.0f), 2, 1.0f);
}

static void outside_the_keys_it_clamps(void **state)
{
    (void)state;
    const float times[3] = {1, 2, 4};
    expect_segment(nkw_segment_find(times, 3, 0.5f), 0, 0.0f);
    expect_segment(nkw_segment_find(times, 3, -INFINITY), 0, 0.0f);
    expect_segment(nkw_segment_find(times, 3, 5.0f), 1, 1.0f);
    expect_segment(nkw_segment_find(times, 3, INFINITY), 1, 1.0f);
}

static void fewer_than_two_keys_and_nan_give_the_first_segment(void **state)
{
    (void)state;
    const float times[3] = {1, 2, 4};
    expect_segment(nkw_segment_find(NULL, 0, 1.0f), 0, 0.0f);
    expect_segment(nkw_segment_find(times, 1, 3.0f), 0, 0.0f);
    expect_segment(nkw_segment_find(times, 3, NAN), 0, 0.0f);
    expect_segment(nkw_segment_find_hint(NULL, 0, 1.0f, 7), 0, 0.0f);
    expect_segment(nkw_segment_find_hint(times, 1, 3.0f, 7), 0, 0.0f);
    expect_segment(nkw_segment_find_hint(times, 3, NAN, 2), 0, 0.0f);
    expect_segment(nkw_timeline_find((nkw_timeline){0, 30, 0}, 1), 0, 0.0f);
    expect_segment(nkw_timeline_find((nkw_timeline){0, 30, 1}, 1), 0, 0.0f);
    expect_segment(nkw_timeline_find((nkw_timeline){0, 30, 9}, NAN), 0, 0.0f);
}

static void equal_times_make_empty_segments_that_are_passed_over(void **state)
{
    (void)state;
    const float inner[5] = {0, 1, 1, 1, 2}, last[3] = {0, 1, 1}, all[3] = {1, 1, 1};
    expect_segment(nkw_segment_find(inner, 5, 1.0f), 3, 0.0f);
    expect_segment(nkw_segment_find(inner, 5, 0.5f), 0, 0.5f);
    expect_segment(nkw_segment_find(last, 3, 1.0f), 1, 1.0f);
    expect_segment(nkw_segment_find(last, 3, 0.5f), 0, 0.5f);
    expect_segment(nkw_segment_find(all, 3, 1.0f), 1, 1.0f);
    expect_segment(nkw_segment_find(all, 3, 0.0f), 0, 0.0f);
}

static void t_does_not_overflow(void **state)
{
    (void)state;
    const float times[2] = {-3e38f, 3e38f};
    expect_segment(nkw_segment_find(times, 2, 0.0f), 0, 0.5f);
}

/* Near and far keys; negative, zero and tiny times. */
static void t_is_rounded_once(void **state)
{
    (void)state;
    random_source r = random_from(27);
    for (int i = 0; i < 400000; i++) {
        float sign = i % 2 ? 1.0f : -1.0f, size = i % 16 < 2 ? 0x1p-146f : powf(2, random_between(&r, -20, 20));
        float times[2] = {i % 7 ? sign * size * random_unit(&r) : 0.0f, 0};
        times[1] = times[0] + size * (i % 3 ? random_between(&r, 1e-4f, 2) : powf(2, random_between(&r, -12, 12)));
        float time = nkw_lerp(times[0], times[1], i % 8 < 4 ? random_unit(&r) : powf(2, random_between(&r, -20, 0)));
        nkw_segment want = by_definition(times, 2, time);
        expect_segment(nkw_segment_find(times, 2, time), want.index, want.t);
    }
}

static void t_is_one_only_at_the_end(void **state)
{
    (void)state;
    const float times[3] = {-1e9f, 1.0f, 2.0f};
    expect_segment(nkw_segment_find(times, 3, 0x1.fffffep-1f), 0, 0x1.fffffep-1f);
    expect_segment(nkw_segment_find(times, 3, 1.0f), 1, 0.0f);
    expect_segment(nkw_segment_find(times, 3, 2.0f), 1, 1.0f);
}

static void search_and_cursor_agree_with_the_definition(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int round = 0; round < 3000; round++) {
        float times[40];
        size_t count = 1 + (size_t)(random_bits(&r) % 40);
        float now = -5.0f;
        for (size_t k = 0; k < count; k++)
            times[k] = now += random_bits(&r) % 4 ? random_unit(&r) : 0.0f;
        for (int i = 0; i < 20; i++) {
            int on_key = (int)(random_bits(&r) % 3) == 0;
            float time = on_key ? times[random_bits(&r) % count] : random_between(&r, -6, now + 1);
            nkw_segment want = by_definition(times, count, time);
            expect_segment(nkw_segment_find(times, count, time), want.index, want.t);
            size_t from = (size_t)(random_bits(&r) % (count + 3));
            expect_segment(nkw_segment_find_hint(times, count, time, from), want.index, want.t);
        }
        expect_segment(nkw_segment_find_hint(times, count, now, SIZE_MAX), nkw_segment_find(times, count, now).index,
                       nkw_segment_find(times, count, now).t);
    }
}

/* Near and far times, forward and backward, in order and not, so that each way of searching is entered and left. */
static void many_times_agree_with_the_definition(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int round = 0; round < 200; round++) {
        float keys[400], times[400], now = -5.0f;
        nkw_segment found[400];
        size_t count = 1 + (size_t)(random_bits(&r) % 400), n = (size_t)(random_bits(&r) % 401), near = 0;
        const size_t far = 1 + (size_t)(random_bits(&r) % 256), step = (size_t)(random_bits(&r) % 5);
        for (size_t k = 0; k < count; k++)
            keys[k] = now += random_bits(&r) % 4 ? random_unit(&r) : 0.0f;
        for (size_t i = 0; i < n; i++) {
            near = i % far ? near + (size_t)(random_bits(&r) % (step + 1)) + (step == 4 ? count - 1 : 0)
                           : (size_t)(random_bits(&r) % 400);
            times[i] = random_bits(&r) % 20 ? keys[near % count] + random_unit(&r) : NAN;
        }
        nkw_segment_find_n(keys, count, times, found, n);
        for (size_t i = 0; i < n; i++) {
            nkw_segment want = by_definition(keys, count, times[i]);
            expect_segment(found[i], want.index, want.t);
            expect_segment(nkw_segment_find(keys, count, times[i]), want.index, want.t);
            expect_segment(nkw_segment_find_hint(keys, count, times[i], i * 5), want.index, want.t);
        }
    }
}

static void anything_at_all_stays_within_the_array(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int round = 0; round < 20000; round++) {
        float times[17];
        size_t count = (size_t)(random_bits(&r) % 18);
        for (size_t k = 0; k < count; k++)
            times[k] = float_of((uint32_t)random_bits(&r));
        float time = float_of((uint32_t)random_bits(&r));
        nkw_segment found[4] = {nkw_segment_find(times, count, time),
                                nkw_segment_find_hint(times, count, time, (size_t)random_bits(&r))};
        nkw_segment_find_n(times, count, times, found + 2, count < 2 ? count : 2);
        for (size_t i = 0; i < 2 + (count < 2 ? count : 2); i++) {
            assert_true(found[i].index == 0 || found[i].index + 1 < count);
            assert_true(found[i].t >= 0.0f && found[i].t <= 1.0f);
        }
    }
}

static void uniform_times_agree_with_a_search_over_them(void **state)
{
    (void)state;
    random_source r = random_from(3);
    static const float rates[] = {24, 25, 29.97f, 30, 60, 120, 0.1f, 1000, 44100};
    for (int round = 0; round < 400; round++) {
        float start = random_between(&r, -10, 10), rate = rates[random_bits(&r) % 9], times[300];
        size_t count = 2 + (size_t)(random_bits(&r) % 299);
        for (size_t k = 0; k < count; k++)
            times[k] = nkw_timeline_time((nkw_timeline){start, rate, 0}, k);
        for (int i = 0; i < 200; i++) {
            float key = times[random_bits(&r) % count];
            float time = i % 4 == 0   ? key
                         : i % 4 == 1 ? float_of(bits_of(key) + 1)
                         : i % 4 == 2 ? float_of(bits_of(key) - 1)
                                      : random_between(&r, start - 1, times[count - 1] + 1);
            nkw_segment want = nkw_segment_find(times, count, time);
            expect_segment(nkw_timeline_find((nkw_timeline){start, rate, count}, time), want.index, want.t);
        }
    }
}

static void uniform_rate_of_nonsense_is_defined(void **state)
{
    (void)state;
    expect_segment(nkw_timeline_find((nkw_timeline){0, 0, 10}, 5), 0, 0.0f);
    expect_segment(nkw_timeline_find((nkw_timeline){0, -30, 10}, 5), 0, 0.0f);
    expect_segment(nkw_timeline_find((nkw_timeline){0, INFINITY, 10}, 5), 0, 0.0f);
    expect_segment(nkw_timeline_find((nkw_timeline){0, NAN, 10}, 5), 0, 0.0f);
    nkw_segment far = nkw_timeline_find((nkw_timeline){0, 3e38f, SIZE_MAX}, 3e38f);
    assert_true(far.index <= SIZE_MAX - 2 && far.t >= 0.0f && far.t <= 1.0f);
    far = nkw_timeline_find((nkw_timeline){-INFINITY, 30, 10}, 0);
    assert_true(far.index <= 8 && far.t >= 0.0f && far.t <= 1.0f);
}

static void the_rate_of_even_times_is_found(void **state)
{
    (void)state;
    const float rates[6] = {30.0f, 24.0f, 48000.0f, 1.0f, 29.97f, 0.3f}, starts[3] = {0.0f, 2.5f, -7.3f};
    float times[200];
    for (int i = 0; i < 18; i++) {
        for (size_t k = 0; k < 200; k++)
            times[k] = nkw_timeline_time((nkw_timeline){starts[i % 3], rates[i / 3], 0}, k);
        expect_bits(uniform_rate(times, 200), rates[i / 3]);
        for (size_t count = 2; count < 200; count += 13) {
            float rate = uniform_rate(times, count);
            for (size_t k = 0; rate > 0.0f && k < count; k++)
                expect_bits(nkw_timeline_time((nkw_timeline){times[0], rate, 0}, k), times[k]);
        }
        times[100] += 1e-3f;
        expect_bits(uniform_rate(times, 200), 0.0f);
    }
}

static void any_rate_of_even_times_is_found(void **state)
{
    (void)state;
    random_source r = random_from(21);
    for (int i = 0; i < 20000; i++) {
        float times[128], rate = random_between(&r, 1.0f, 120.0f), start = i % 2 ? random_between(&r, -10, 10) : 0.0f;
        size_t count = 2 + (size_t)(random_bits(&r) % 126);
        rate = i % 4 < 2 ? (float)(1 + random_bits(&r) % 240) : rate;
        for (size_t k = 0; k < count; k++)
            times[k] = nkw_timeline_time((nkw_timeline){start, rate, 0}, k);
        float found = uniform_rate(times, count);
        assert_true(found > 0.0f && (i % 4 >= 2 || found == (float)(uint32_t)found));
        for (size_t k = 0; k < count; k++)
            expect_bits(nkw_timeline_time((nkw_timeline){start, found, 0}, k), times[k]);
    }
}

static void times_without_a_rate_have_none(void **state)
{
    (void)state;
    const float uneven[3] = {0, 1, 3}, same[3] = {1, 1, 1}, back[3] = {2, 1, 0}, odd[3] = {0, NAN, 2};
    const float endless[2] = {0, INFINITY};
    expect_bits(uniform_rate(NULL, 0), 0.0f);
    expect_bits(uniform_rate(uneven, 1), 0.0f);
    expect_bits(uniform_rate(uneven, 3), 0.0f);
    expect_bits(uniform_rate(same, 3), 0.0f);
    expect_bits(uniform_rate(back, 3), 0.0f);
    expect_bits(uniform_rate(odd, 3), 0.0f);
    expect_bits(uniform_rate(endless, 2), 0.0f);
}

/* Series that programs make: each is even before its times are rounded. */
static float series_time(int series, size_t k, float before)
{
    const float step24 = 1.0f / 24, step30 = 1.0f / 30, step60 = 0.016f;
    const double rates[4] = {30000.0 / 1001, 24000.0 / 1001, 60000.0 / 1001, 29.97};
    switch (series) {
    case 0:
        return (float)k * step24;
    case 1:
        return (float)(k + 10) * step24;
    case 2:
        return (float)(k + 100000) / 24;
    case 3:
        return k ? before + step30 : 0.0f;
    case 4:
        return k ? before + step60 : -7.3f;
    case 5:
        return (float)((double)k * 16.67) * 0.001f;
    default:
        return (float)((double)(k + 10 * (size_t)series) / rates[series % 4]);
    }
}

static void expect_even(const float *times, size_t count, float rate)
{
    random_source r = random_from(24);
    for (int i = 0; i < 2000; i++) {
        float key = times[random_bits(&r) % count];
        float time = i % 4 == 0   ? key
                     : i % 4 == 1 ? float_of(bits_of(key) + 1)
                     : i % 4 == 2 ? float_of(bits_of(key) + (uint32_t)(random_bits(&r) % 9) - 4)
                                  : random_between(&r, times[0] - 1, times[count - 1] + 1);
        nkw_segment want = by_definition(times, count, time);
        expect_segment(nkwi_segment_find_even(times, count, rate, time), want.index, want.t);
    }
    expect_segment(nkwi_segment_find_even(times, count, rate, NAN), 0, 0.0f);
    expect_segment(nkwi_segment_find_even(times, count, rate, INFINITY), count - 2, 1.0f);
    expect_segment(nkwi_segment_find_even(times, count, rate, -INFINITY), 0, 0.0f);
}

static void times_that_are_nearly_even_need_no_search(void **state)
{
    (void)state;
    static float times[3000];
    for (int series = 0; series < 10; series++)
        for (size_t count = 2; count <= 3000; count = count < 300 ? count + 17 : 3 * count) {
            for (size_t k = 0; k < count; k++)
                times[k] = series_time(series, k, k ? times[k - 1] : 0.0f);
            float rate = even_rate(times, count);
            assert_true(rate > 0.0f);
            expect_even(times, count, rate);
        }
}

static void keys_off_by_less_than_a_quarter_are_even(void **state)
{
    (void)state;
    random_source r = random_from(25);
    static float times[500];
    for (int round = 0; round < 40; round++) {
        size_t count = 2 + (size_t)(random_bits(&r) % 499);
        for (size_t k = 0; k < count; k++)
            times[k] = -3.0f + 0.04f * ((float)k + random_between(&r, -0.24f, 0.24f));
        float rate = even_rate(times, count);
        assert_true(rate > 0.0f);
        expect_even(times, count, rate);
    }
}

/* Whatever passes as even is found as by a search. */
static void no_other_times_are_even(void **state)
{
    (void)state;
    random_source r = random_from(26);
    const float uneven[4] = {0, 1, 2, 5}, jump[4] = {0, 1, 1, 2}, odd[3] = {0, NAN, 2}, endless[3] = {0, 1, INFINITY};
    expect_bits(even_rate(NULL, 0), 0.0f);
    expect_bits(even_rate(uneven, 1), 0.0f);
    expect_bits(even_rate(uneven, 4), 0.0f);
    expect_bits(even_rate(jump, 4), 0.0f);
    expect_bits(even_rate(odd, 3), 0.0f);
    expect_bits(even_rate(endless, 3), 0.0f);
    expect_segment(nkwi_segment_find_even(uneven, 1, 1, 3), 0, 0.0f);
    for (int round = 0; round < 4000; round++) {
        float times[12];
        size_t count = 2 + (size_t)(random_bits(&r) % 11);
        times[0] = random_between(&r, -9, 9);
        for (size_t k = 1; k < count; k++)
            times[k] = times[k - 1] + random_between(&r, 0.0f, 1.0f);
        float rate = even_rate(times, count), any = float_of((uint32_t)random_bits(&r));
        assert_true(nkwi_segment_find_even(times, count, any, random_between(&r, -9, 9)).index + 1 < count);
        if (rate > 0.0f)
            expect_even(times, count, rate);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(segments_are_half_open_and_the_last_is_closed),
        cmocka_unit_test(times_that_are_nearly_even_need_no_search),
        cmocka_unit_test(keys_off_by_less_than_a_quarter_are_even),
        cmocka_unit_test(no_other_times_are_even),
        cmocka_unit_test(outside_the_keys_it_clamps),
        cmocka_unit_test(fewer_than_two_keys_and_nan_give_the_first_segment),
        cmocka_unit_test(equal_times_make_empty_segments_that_are_passed_over),
        cmocka_unit_test(t_does_not_overflow),
        cmocka_unit_test(t_is_rounded_once),
        cmocka_unit_test(t_is_one_only_at_the_end),
        cmocka_unit_test(search_and_cursor_agree_with_the_definition),
        cmocka_unit_test(many_times_agree_with_the_definition),
        cmocka_unit_test(anything_at_all_stays_within_the_array),
        cmocka_unit_test(uniform_times_agree_with_a_search_over_them),
        cmocka_unit_test(uniform_rate_of_nonsense_is_defined),
        cmocka_unit_test(the_rate_of_even_times_is_found),
        cmocka_unit_test(any_rate_of_even_times_is_found),
        cmocka_unit_test(times_without_a_rate_have_none),
    };
    return cmocka_run_group_tests_name("segment", tests, NULL, NULL);
}
