/* SPDX-License-Identifier: MIT */
#include "random.h"
#include "support/expect.h"

/* Expects the keys of a step in the order in which they are passed. */
static void expect_keys(double from, double to, double duration, int includes_from, size_t count, const size_t *keys)
{
    static const float times[3] = {0, 0.25f, 0.5f};
    const nkw_playback_step step = {times, 3, duration, from, to, includes_from};
    size_t out[8], passed = 99;
    assert_int_equal(nkw_playback_passed(&step, out, 8, &passed), NKW_OK);
    assert_int_equal(passed, count);
    assert_memory_equal(out, keys, count * sizeof *out);
}

static void the_first_step_passes_keys_at_its_start(void **state)
{
    (void)state;
    const size_t up[4] = {0, 1, 2, 0}, down[4] = {2, 1, 0, 2};
    for (int loops = 0; loops < 2; loops++) {
        expect_keys(0, 0.3, loops, 0, 1, up + 1);
        expect_keys(0, 0.3, loops, 1, 2, up);
        expect_keys(0, 0, loops, 0, 0, up);
        expect_keys(0, 0, loops, 1, 1, up);
        expect_keys(0.1, 0.1, loops, 1, 0, up);
        expect_keys(0.5, 0.25, loops, 0, 1, down + 1);
        expect_keys(0.5, 0.25, loops, 1, 2, down);
        expect_keys(0.25, 0.6, loops, 1, 2, up + 1);
    }
    expect_keys(7, 8, 1, 1, 4, up);
    expect_keys(6.5, 5.5, 1, 1, 4, down);
    /* A first step and those after it pass as many keys as one first step, wherever they are divided. */
    random_source r = random_from(61);
    const float times[4] = {0, 0.1f, 0.7f, 1.6f};
    for (int i = 0; i < 2000; i++) {
        double from = (double)(int)random_between(&r, -9, 9) * 1.7 + (double)times[i % 4];
        double to = i % 3 ? random_between(&r, -20, 20) : from;
        double between = from + (to - from) * (double)random_unit(&r);
        nkw_playback_step whole = {times, 4, 1.7, from, to, 1}, first = whole, second = {times, 4, 1.7, between, to, 0};
        size_t keys[128], a, b, c;
        first.to = between;
        assert_int_equal(nkw_playback_passed(&whole, keys, 128, &a), NKW_OK);
        assert_int_equal(nkw_playback_passed(&first, keys, 128, &b), NKW_OK);
        assert_int_equal(nkw_playback_passed(&second, keys, 128, &c), NKW_OK);
        assert_int_equal(a, b + c);
    }
}

static void too_few_places_for_keys_are_reported(void **state)
{
    (void)state;
    const float times[2] = {0, 0.5f};
    const nkw_playback_step step = {times, 2, 1, 0, 1.6, 0};
    size_t keys[3] = {9, 9, 9}, passed = 0;
    assert_int_equal(nkw_playback_passed(&step, keys, 2, &passed), NKW_TOO_SMALL);
    assert_int_equal(passed, 3);
    assert_true(keys[0] == 1 && keys[1] == 0 && keys[2] == 9);
    assert_int_equal(nkw_playback_passed(&step, NULL, 0, &passed), NKW_TOO_SMALL);
    assert_int_equal(passed, 3);
    assert_int_equal(nkw_playback_passed(&step, keys, 3, &passed), NKW_OK);
    assert_int_equal(keys[2], 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_first_step_passes_keys_at_its_start),
        cmocka_unit_test(too_few_places_for_keys_are_reported),
    };
    return cmocka_run_group_tests_name("playback_passed", tests, NULL, NULL);
}
