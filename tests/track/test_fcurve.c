/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdint.h>

#include "random.h"
#include "support/expect.h"

static nkw_fcurve_key key(float time, float value, nkw_fcurve_kind kind)
{
    nkw_fcurve_key k = {time, value, {0.0f, 0.0f}, {0.0f, 0.0f}, kind, NKW_EASE_LINEAR};
    return k;
}

static nkw_fcurve_key bezier(float time, float value, nkw_handle in, nkw_handle out)
{
    nkw_fcurve_key k = {time, value, in, out, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR};
    return k;
}

static nkw_fcurve curve_of(const nkw_fcurve_key *keys, size_t count, nkw_fcurve_outside outside)
{
    nkw_fcurve c = {keys, count, outside, outside, 0, 0, NKW_HANDLE_NONE};
    return c;
}

/* Values 1, 3, 2 at 0, 1, 4 s: slope 2 at the start, -1/3 at the end. */
static const nkw_fcurve_key three[3] = {{0, 1, {0, 0}, {0.5f, 1}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                                        {1, 3, {-0.25f, 0}, {1, 0.5f}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                                        {4, 2, {-1.5f, 0.5f}, {0, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR}};

static float value(const nkw_fcurve *c, float time)
{
    return nkw_fcurve_sample(c, time, NULL).value;
}

static void expect_point(nkw_motion got, nkw_motion want, double bound)
{
    expect_near(got.value, want.value, bound);
    expect_near(got.velocity, want.velocity, bound);
    expect_near(got.acceleration, want.acceleration, bound);
}

/* ---- Within the keys ---- */

static void each_kind_interpolates_in_its_way(void **state)
{
    (void)state;
    nkw_fcurve_key keys[6];
    for (int k = 0; k < 6; k++)
        keys[k] = key((float)(2 * k), (float)(k * k), (nkw_fcurve_kind)(k % 5));
    keys[3].out.time = keys[3].out.value = 1.0f;
    keys[4].ease = NKW_EASE_CUBIC_IN;
    keys[4].in.time = -1.0f;
    nkw_fcurve c = curve_of(keys, 6, NKW_FCURVE_OUTSIDE_HOLD);
    nkw_handle_segment s = {6, 9, keys[3].out, keys[4].in, 8, 16};
    expect_bits(value(&c, 0.5f), 0);
    expect_bits(value(&c, 2.0f), 1);
    expect_bits(value(&c, 2.5f), 4);
    expect_bits(value(&c, 4.5f), 5.25f);
    expect_bits(nkw_fcurve_sample(&c, 4.5f, NULL).velocity, 2.5f);
    nkw_motion at = nkw_fcurve_sample(&c, 6.75f, NULL), want = nkw_handle_sample(&s, 6.75f);
    expect_floats_bits(&at.value, &want.value, 3);
    at = nkw_fcurve_sample(&c, 9.0f, NULL);
    expect_bits(at.value, 16 + 9 * 0.125f);
    expect_bits(at.velocity, 9 * 0.75f / 2);
    expect_bits(at.acceleration, 9 * 3.0f / 4);
    keys[0].kind = (nkw_fcurve_kind)77;
    expect_bits(value(&c, 1.9f), 0);
}

static void keys_come_back_bit_for_bit_at_their_own_time(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int round = 0; round < 2000; round++) {
        nkw_fcurve_key keys[7];
        for (int k = 0; k < 7; k++) {
            nkw_handle in = {-random_unit(&r), random_between(&r, -2, 2)},
                       out = {random_unit(&r), random_between(&r, -2, 2)};
            keys[k] =
                bezier((k ? keys[k - 1].time : -3.0f) + 0.1f + random_unit(&r), random_between(&r, -5, 5), in, out);
            keys[k].kind = (nkw_fcurve_kind)(random_bits(&r) % 5);
            keys[k].ease = (nkw_ease_kind)(random_bits(&r) % NKW_EASE_CSS_STEP_START);
        }
        nkw_fcurve c = curve_of(keys, 7, (nkw_fcurve_outside)(round % 5));
        for (int k = 0; k < 7; k++)
            expect_bits(value(&c, keys[k].time), keys[k].value);
    }
}

static void a_cursor_changes_no_bits(void **state)
{
    (void)state;
    random_source r = random_from(2);
    static nkw_fcurve_key keys[500];
    for (int k = 0; k < 500; k++) {
        nkw_handle in = {-random_unit(&r), random_unit(&r)}, out = {random_unit(&r), random_unit(&r)};
        keys[k] = bezier((k ? keys[k - 1].time : 0.0f) + random_unit(&r), random_unit(&r), in, out);
        keys[k].kind = (nkw_fcurve_kind)(random_bits(&r) % 5);
    }
    for (int outside = 0; outside < 5; outside++) {
        nkw_fcurve c = curve_of(keys, 500, (nkw_fcurve_outside)outside);
        uint32_t cursor = 0;
        for (int i = 0; i < 4000; i++) {
            float time = i % 9 ? (float)i * 0.2f - 200.0f : random_between(&r, -500, 800);
            cursor = i % 100 ? cursor : (uint32_t)random_bits(&r);
            nkw_motion a = nkw_fcurve_sample(&c, time, &cursor), b = nkw_fcurve_sample(&c, time, NULL);
            expect_floats_bits(&a.value, &b.value, 3);
            assert_true(cursor < 499 || outside == NKW_FCURVE_OUTSIDE_HOLD);
        }
    }
}

static void equal_times_are_a_jump(void **state)
{
    (void)state;
    const nkw_fcurve_key keys[4] = {{0, 0, {0, 0}, {0, 0}, NKW_FCURVE_LINEAR, NKW_EASE_LINEAR},
                                    {1, 1, {0, 0}, {0, 0}, NKW_FCURVE_LINEAR, NKW_EASE_LINEAR},
                                    {1, 5, {0, 0}, {0, 0}, NKW_FCURVE_LINEAR, NKW_EASE_LINEAR},
                                    {2, 7, {0, 0}, {0, 0}, NKW_FCURVE_LINEAR, NKW_EASE_LINEAR}};
    nkw_fcurve c = curve_of(keys, 4, NKW_FCURVE_OUTSIDE_HOLD), last = curve_of(keys, 3, NKW_FCURVE_OUTSIDE_LINEAR);
    expect_near(value(&c, 0.99999994f), 1, 1e-6);
    expect_bits(value(&c, 1), 5);
    expect_bits(value(&last, 1), 5);
    expect_bits(value(&last, 3), 5);
}

static int runs_back(const nkw_fcurve_key *keys)
{
    const nkw_handle_segment s = {keys[0].time, keys[0].value, keys[0].out, keys[1].in, keys[1].time, keys[1].value};
    return nkw_handle_runs_back(&s);
}

static void the_policy_limits_each_segment(void **state)
{
    (void)state;
    const nkw_fcurve_key keys[2] = {{0, 0, {0, 0}, {3, 1}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                                    {1, 1, {-2, 0}, {0, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR}};
    nkw_fcurve_key limited[2];
    nkw_fcurve c = curve_of(keys, 2, NKW_FCURVE_OUTSIDE_HOLD), d = curve_of(limited, 2, NKW_FCURVE_OUTSIDE_HOLD);
    assert_true(runs_back(keys));
    for (int policy = 1; policy < 4; policy++) {
        c.policy = (nkw_handle_policy)policy;
        nkw_fcurve_limit(keys, 2, c.policy, limited);
        assert_true(!runs_back(limited));
        for (int k = 0; k <= 16; k++) {
            nkw_motion a = nkw_fcurve_sample(&c, (float)k / 16.0f, NULL), b = nkw_fcurve_sample(&d, (float)k / 16.0f, NULL);
            expect_floats_bits(&a.value, &b.value, 3);
        }
    }
}

static void inserted_keys_change_nothing(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int round = 0; round < 400; round++) {
        nkw_fcurve_key keys[5], more[6];
        for (int k = 0; k < 4; k++) {
            nkw_handle in = {-0.5f * random_unit(&r), random_between(&r, -1, 1)};
            nkw_handle out = {0.5f * random_unit(&r), random_between(&r, -1, 1)};
            keys[k] = bezier((float)k, random_between(&r, -5, 5), in, out);
            keys[k].kind = (nkw_fcurve_kind)(random_bits(&r) % 4);
        }
        nkw_fcurve c = curve_of(keys, 4, NKW_FCURVE_OUTSIDE_HOLD), d = curve_of(more, 5, NKW_FCURVE_OUTSIDE_HOLD);
        c.policy = (nkw_handle_policy)(round % 4);
        float time = random_between(&r, 0.01f, 2.99f);
        size_t index = 9;
        assert_int_equal(nkw_fcurve_insert(&c, time, more, &index), NKW_OK);
        assert_true(index == 1 + (size_t)time && more[index].time == time);
        expect_bits(more[index].value, value(&c, time));
        for (int i = 0; i <= 300; i++) {
            nkw_motion p = nkw_fcurve_sample(&c, 0.01f * (float)i, NULL);
            expect_near(value(&d, 0.01f * (float)i), p.value, 1e-5 + 1e-6 * fabs(p.velocity));
        }
        assert_int_equal(nkw_fcurve_insert(&c, time, keys, &index), NKW_OK);
        assert_memory_equal(keys, more, 5 * sizeof keys[0]);
    }
}

/* Handles up to the duration, whose parts can be longer than the parts of the segment. */
static void long_handles_survive_an_insertion(void **state)
{
    (void)state;
    random_source r = random_from(4);
    int changed = 0;
    for (int round = 0; round < 600; round++) {
        nkw_fcurve_key keys[4], more[5];
        for (int k = 0; k < 4; k++) {
            nkw_handle in = {-1.2f * random_unit(&r), random_between(&r, -1, 1)};
            nkw_handle out = {1.2f * random_unit(&r), random_between(&r, -1, 1)};
            keys[k] = bezier((float)k, random_between(&r, -5, 5), in, out);
        }
        nkw_fcurve c = curve_of(keys, 4, NKW_FCURVE_OUTSIDE_HOLD), d = curve_of(more, 5, NKW_FCURVE_OUTSIDE_HOLD);
        int is_contained = round % 3 == 0;
        c.policy = round % 3 == 2 ? NKW_HANDLE_KEEP_START : NKW_HANDLE_KEEP_RATIO;
        d.policy = c.policy;
        if (is_contained)
            nkw_fcurve_limit(keys, 4, NKW_HANDLE_CONTAIN, keys);
        float time = random_between(&r, 1.01f, 1.99f);
        size_t index;
        assert_int_equal(nkw_fcurve_insert(&c, time, more, &index), NKW_OK);
        for (int i = 0; i <= 300; i++) {
            nkw_motion p = nkw_fcurve_sample(&c, 0.01f * (float)i, NULL);
            expect_near(value(&d, 0.01f * (float)i), p.value, 1e-5 + 1e-6 * fabs(p.velocity));
        }
        if (!is_contained)
            continue;
        /* CONTAIN itself changes the curve in the split segment at most. */
        c.policy = d.policy = NKW_HANDLE_CONTAIN;
        for (int i = 0; i <= 300; i++) {
            float at = 0.01f * (float)i;
            nkw_motion p = nkw_fcurve_sample(&c, at, NULL);
            double off = fabs((double)value(&d, at) - (double)p.value);
            changed += off > 1e-3;
            assert_true((at > 1 && at < 2) || off <= 1e-5 + 1e-6 * fabs(p.velocity));
        }
    }
    assert_true(changed > 0);
}

static void keys_are_inserted_only_between_keys(void **state)
{
    (void)state;
    nkw_fcurve_key keys[4];
    memcpy(keys, three, sizeof three);
    nkw_fcurve c = curve_of(keys, 3, NKW_FCURVE_OUTSIDE_HOLD);
    const float times[5] = {-1, 0, 1, 4, NAN};
    size_t index = 9;
    for (int i = 0; i < 5; i++)
        assert_int_equal(nkw_fcurve_insert(&c, times[i], keys, &index), NKW_OUT_OF_RANGE);
    keys[0].kind = NKW_FCURVE_EASE;
    assert_int_equal(nkw_fcurve_insert(&c, 0.5f, keys, &index), NKW_BAD_METHOD);
    c.key_count = 1;
    assert_int_equal(nkw_fcurve_insert(&c, 0.5f, keys, &index), NKW_OUT_OF_RANGE);
    assert_int_equal(index, 9);
}

/* ---- Outside ---- */

static void hold_and_linear_continue_each_end_by_itself(void **state)
{
    (void)state;
    nkw_fcurve c = curve_of(three, 3, NKW_FCURVE_OUTSIDE_LINEAR);
    expect_near(value(&c, -2), 1 - 2 * 2, 1e-6);
    expect_near(nkw_fcurve_sample(&c, -2, NULL).velocity, 2, 1e-6);
    expect_near(value(&c, 10), 2 - 6.0 / 3, 1e-5);
    expect_bits(value(&c, INFINITY), -INFINITY);
    c.after = NKW_FCURVE_OUTSIDE_HOLD;
    expect_bits(value(&c, 10), 2);
    expect_bits(nkw_fcurve_sample(&c, 10, NULL).velocity, 0);
    c.before = (nkw_fcurve_outside)77;
    expect_bits(value(&c, -10), 1);
}

/* Whole seconds: the time in the cycle by integers. */
static void far_cycles_are_exact(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (int i = 0; i < 20000; i++) {
        uint64_t period = 1 + random_bits(&r) % 0xFFFFF, cycles = random_bits(&r) >> (24 + random_bits(&r) % 16);
        nkw_fcurve_key keys[2];
        memset(keys, 0, sizeof keys);
        keys[0].kind = NKW_FCURVE_LINEAR;
        keys[1].time = keys[1].value = (float)period;
        nkw_fcurve c = curve_of(keys, 2, NKW_FCURVE_OUTSIDE_CYCLE);
        float time = (float)(cycles % (UINT64_C(1) << 40) * period);
        expect_near(value(&c, time), (double)((uint64_t)time % period), 1e-7 * (double)period);
    }
}

/* As in Maya and Blender: the handles before the first and after the last key. */
static void linear_follows_the_outer_handles(void **state)
{
    (void)state;
    nkw_fcurve_key keys[3];
    memcpy(keys, three, sizeof keys);
    nkw_fcurve c = curve_of(keys, 3, NKW_FCURVE_OUTSIDE_LINEAR);
    keys[0].in.time = -0.5f;
    keys[0].in.value = 0.25f;
    keys[2].out.time = 0.25f;
    keys[2].out.value = 1.0f;
    expect_bits(value(&c, -2), 2);
    expect_bits(nkw_fcurve_sample(&c, -2, NULL).velocity, -0.5f);
    expect_bits(value(&c, 6), 10);
    keys[2].kind = NKW_FCURVE_LINEAR;
    expect_near(value(&c, 10), 2 - 6.0 / 3, 1e-5);
    keys[0].in.time = 0.0f;
    expect_near(value(&c, -2), 1 - 2 * 2, 1e-6);
}

static void a_vertical_end_is_held(void **state)
{
    (void)state;
    const nkw_fcurve_key keys[2] = {{0, 1, {0, 0}, {0, 5}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                                    {1, 2, {0, 3}, {0, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR}};
    nkw_fcurve c = curve_of(keys, 2, NKW_FCURVE_OUTSIDE_LINEAR);
    expect_bits(nkw_fcurve_sample(&c, 0, NULL).velocity, INFINITY);
    expect_bits(value(&c, -1), 1);
    expect_bits(value(&c, 9), 2);
    expect_bits(value(&c, INFINITY), 2);
}

static void cycles_repeat_offset_and_oscillate(void **state)
{
    (void)state;
    nkw_fcurve cycle = curve_of(three, 3, NKW_FCURVE_OUTSIDE_CYCLE);
    nkw_fcurve offset = curve_of(three, 3, NKW_FCURVE_OUTSIDE_CYCLE_OFFSET);
    nkw_fcurve oscillate = curve_of(three, 3, NKW_FCURVE_OUTSIDE_OSCILLATE);
    for (int n = -5; n <= 5; n++)
        for (int k = 1; k < 32; k++) {
            float rest = (float)k / 8.0f, time = 4.0f * (float)n + rest;
            nkw_motion p = nkw_fcurve_sample(&cycle, rest, NULL), q = p, back = nkw_fcurve_sample(&cycle, 4.0f - rest, NULL);
            q.value += (float)n;
            back.velocity = -back.velocity;
            expect_point(nkw_fcurve_sample(&cycle, time, NULL), p, 0);
            expect_point(nkw_fcurve_sample(&offset, time, NULL), q, 1e-6);
            expect_point(nkw_fcurve_sample(&oscillate, time, NULL), n % 2 ? back : p, 0);
        }
    /* A cycle begins at its first key; the keys themselves include the last one. */
    expect_bits(value(&cycle, 4), 2);
    expect_bits(value(&cycle, 8), 1);
    expect_bits(value(&cycle, -4), 1);
    expect_bits(value(&offset, 8), 3);
    expect_bits(value(&oscillate, 8), 1);
    expect_bits(value(&oscillate, -4), 2);
}

static void before_and_after_are_apart(void **state)
{
    (void)state;
    nkw_fcurve c = curve_of(three, 3, NKW_FCURVE_OUTSIDE_CYCLE);
    c.after = NKW_FCURVE_OUTSIDE_OSCILLATE;
    expect_bits(value(&c, -3), value(&c, 1));
    expect_bits(value(&c, 7), value(&c, 1));
    expect_bits(value(&c, 7.5f), value(&c, 0.5f));
}

static void cycles_end_after_their_number(void **state)
{
    (void)state;
    nkw_fcurve c = curve_of(three, 3, NKW_FCURVE_OUTSIDE_CYCLE);
    c.before_cycles = 2;
    c.after_cycles = 3;
    expect_bits(value(&c, 15.5f), value(&c, 3.5f));
    expect_bits(value(&c, 16.0f), 2);
    expect_bits(value(&c, 99.0f), 2);
    expect_bits(nkw_fcurve_sample(&c, 99.0f, NULL).velocity, 0);
    expect_bits(value(&c, -7.5f), value(&c, 0.5f));
    expect_bits(value(&c, -8.0f), 1);
    expect_bits(value(&c, -99.0f), 1);
    c.before = c.after = NKW_FCURVE_OUTSIDE_CYCLE_OFFSET;
    expect_bits(value(&c, 99.0f), 2 + 3);
    expect_bits(value(&c, -99.0f), 1 - 2);
    c.before = c.after = NKW_FCURVE_OUTSIDE_OSCILLATE;
    expect_bits(value(&c, 99.0f), 1);
    expect_bits(value(&c, -99.0f), 1);
    c.before_cycles = 1;
    c.after_cycles = 2;
    expect_bits(value(&c, 99.0f), 2);
    expect_bits(value(&c, -99.0f), 2);
}

/* A million cycles: time and offset are exact for this curve. */
static void a_million_cycles_do_not_drift(void **state)
{
    (void)state;
    nkw_fcurve offset = curve_of(three, 3, NKW_FCURVE_OUTSIDE_CYCLE_OFFSET);
    for (int sign = -1; sign <= 1; sign += 2) {
        float n = (float)sign * 1e6f;
        expect_bits(value(&offset, 4.0f * n + 1.0f), 3.0f + n);
        expect_near(nkw_fcurve_sample(&offset, 4.0f * n + 1.0f, NULL).velocity, 0.5, 1e-6);
    }
}

static void times_of_a_curve_without_duration_hold(void **state)
{
    (void)state;
    const nkw_fcurve_key same[2] = {{1, 2, {0, 0}, {0, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                                    {1, 3, {0, 0}, {0, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR}};
    for (int outside = 0; outside < 5; outside++) {
        nkw_fcurve c = curve_of(same, 2, (nkw_fcurve_outside)outside),
                   one = curve_of(same, 1, (nkw_fcurve_outside)outside);
        expect_bits(value(&c, 0), 2);
        expect_bits(value(&c, 1), 3);
        expect_bits(value(&c, 9), 3);
        expect_bits(value(&one, -5), 2);
        expect_bits(value(&one, INFINITY), 2);
        expect_nan(value(&c, NAN));
        expect_nan(value(&one, NAN));
    }
    nkw_fcurve none = curve_of(NULL, 0, NKW_FCURVE_OUTSIDE_CYCLE);
    expect_bits(value(&none, NAN), 0);
}

/* A time that a float rounds to the next key still belongs to its own segment. */
static void cycled_times_are_not_rounded_over_a_key(void **state)
{
    (void)state;
    const nkw_fcurve_key keys[3] = {{0, 1, {0, 0}, {0, 0}, NKW_FCURVE_CONSTANT, NKW_EASE_LINEAR},
                                    {1000, 2, {0, 0}, {0, 0}, NKW_FCURVE_CONSTANT, NKW_EASE_LINEAR},
                                    {1000.1f, 3, {0, 0}, {0, 0}, NKW_FCURVE_CONSTANT, NKW_EASE_LINEAR}};
    nkw_fcurve c = curve_of(keys, 3, NKW_FCURVE_OUTSIDE_CYCLE);
    /* -0.1000061 + 1000.1 is 1000 less 2^-17: the float nearest to it is 1000. */
    float d = 1000.1f, time = -(float)((double)d - 1000.0) - 0x1p-17f;
    expect_bits((float)((double)time + (double)d), 1000.0f);
    expect_bits(value(&c, time), 1);
    expect_bits(value(&c, time + 0x1p-17f), 2);
}

/* ---- OpenUSD's TsTest_Museum: TwoKnotBezier, from the baseline of its evaluator ---- */

static void openusd_two_knot_bezier_has_its_values(void **state)
{
    (void)state;
    const nkw_fcurve_key keys[2] = {{1, 1, {0, 0}, {0.5f, 0.5f}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                                    {5, 2, {-0.5f, 0}, {0, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR}};
    static const float want[][2] = {{0.2f, 1.0f},
                                    {1.0f, 1.0f},
                                    {1.0199005f, 1.0187387f},
                                    {1.1990050f, 1.1383760f},
                                    {1.3980100f, 1.2323005f},
                                    {1.5970149f, 1.3094952f},
                                    {1.7960199f, 1.3770208f},
                                    {1.9950249f, 1.4379735f}};
    nkw_fcurve c = curve_of(keys, 2, NKW_FCURVE_OUTSIDE_HOLD);
    for (size_t i = 0; i < sizeof want / sizeof want[0]; i++)
        expect_near(value(&c, want[i][0]), want[i][1], 3e-7);
}

/* ---- Validation ---- */

static void expect_result(const nkw_fcurve *c, nkw_result want, size_t bad)
{
    size_t found = 99;
    assert_int_equal(nkw_fcurve_validate(c, &found), want);
    assert_int_equal(found, bad);
    assert_int_equal(nkw_fcurve_validate(c, NULL), want);
}

static void validate_names_the_first_offender(void **state)
{
    (void)state;
    nkw_fcurve_key keys[3];
    memcpy(keys, three, sizeof keys);
    nkw_fcurve c = curve_of(keys, 3, NKW_FCURVE_OUTSIDE_CYCLE), none = curve_of(keys, 0, NKW_FCURVE_OUTSIDE_HOLD);
    expect_result(&none, NKW_EMPTY, 0);
    expect_result(&c, NKW_OK, 0);
    keys[2].in.value = NAN;
    expect_result(&c, NKW_NOT_FINITE, 2);
    keys[1].time = -1;
    expect_result(&c, NKW_NOT_ASCENDING, 1);
    keys[1].time = INFINITY;
    expect_result(&c, NKW_NOT_FINITE, 1);
    keys[0].kind = (nkw_fcurve_kind)5;
    expect_result(&c, NKW_BAD_METHOD, 0);
    keys[0].kind = NKW_FCURVE_EASE;
    keys[0].ease = NKW_EASE_COUNT;
    expect_result(&c, NKW_BAD_METHOD, 0);
    memcpy(keys, three, sizeof keys);
    c.after = (nkw_fcurve_outside)5;
    expect_result(&c, NKW_BAD_METHOD, 0);
    c.after = NKW_FCURVE_OUTSIDE_HOLD;
    c.policy = (nkw_handle_policy)4;
    expect_result(&c, NKW_BAD_METHOD, 0);
}

/* Each number of each key by itself. */
static void each_number_of_a_key_is_checked(void **state)
{
    (void)state;
    const float wrong[3] = {NAN, INFINITY, -INFINITY};
    nkw_fcurve_key keys[3];
    memcpy(keys, three, sizeof keys);
    nkw_fcurve c = curve_of(keys, 3, NKW_FCURVE_OUTSIDE_HOLD);
    for (size_t i = 0; i < 3 * 3 * 6; i++) {
        memcpy(keys, three, sizeof keys);
        nkw_fcurve_key *k = &keys[i % 3];
        float *numbers[6] = {&k->time, &k->value, &k->in.time, &k->in.value, &k->out.time, &k->out.value};
        *numbers[i / 9] = wrong[i / 3 % 3];
        expect_result(&c, NKW_NOT_FINITE, i % 3);
    }
    memcpy(keys, three, sizeof keys);
    c.before = (nkw_fcurve_outside)5;
    expect_result(&c, NKW_BAD_METHOD, 0);
    c.before = (nkw_fcurve_outside)-1;
    expect_result(&c, NKW_BAD_METHOD, 0);
    c.before = NKW_FCURVE_OUTSIDE_OSCILLATE;
    expect_result(&c, NKW_OK, 0);
}

static void an_infinite_time_is_the_nearest_key_of_cycles(void **state)
{
    (void)state;
    for (int mode = NKW_FCURVE_OUTSIDE_CYCLE; mode <= NKW_FCURVE_OUTSIDE_OSCILLATE; mode++) {
        nkw_fcurve c = curve_of(three, 3, (nkw_fcurve_outside)mode);
        const nkw_motion first = {1, 0, 0}, last = {2, 0, 0};
        expect_point(nkw_fcurve_sample(&c, -INFINITY, NULL), first, 0);
        expect_point(nkw_fcurve_sample(&c, INFINITY, NULL), last, 0);
        expect_nan(value(&c, NAN));
    }
}

/* Handles of other kinds are not used, so no policy shortens them. */
static void only_bezier_segments_are_limited(void **state)
{
    (void)state;
    nkw_fcurve_key keys[4], limited[4];
    for (int k = 0; k < 4; k++) {
        const nkw_handle in = {-5, 1}, out = {5, 1};
        keys[k] = bezier((float)k, (float)k, in, out);
    }
    for (int first = 0; first < 4; first++) {
        nkw_fcurve_limit(keys, 4, NKW_HANDLE_KEEP_RATIO, limited);
        for (int k = 0; k < 3; k++) {
            assert_int_equal(runs_back(limited + k), k < first);
            if (k < first)
                expect_bits(limited[k].out.time, 5);
        }
        keys[first].kind = (nkw_fcurve_kind)(first == 0 ? NKW_FCURVE_LINEAR : NKW_FCURVE_CONSTANT);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_kind_interpolates_in_its_way),
        cmocka_unit_test(keys_come_back_bit_for_bit_at_their_own_time),
        cmocka_unit_test(a_cursor_changes_no_bits),
        cmocka_unit_test(equal_times_are_a_jump),
        cmocka_unit_test(the_policy_limits_each_segment),
        cmocka_unit_test(inserted_keys_change_nothing),
        cmocka_unit_test(long_handles_survive_an_insertion),
        cmocka_unit_test(keys_are_inserted_only_between_keys),
        cmocka_unit_test(hold_and_linear_continue_each_end_by_itself),
        cmocka_unit_test(far_cycles_are_exact),
        cmocka_unit_test(linear_follows_the_outer_handles),
        cmocka_unit_test(a_vertical_end_is_held),
        cmocka_unit_test(cycles_repeat_offset_and_oscillate),
        cmocka_unit_test(before_and_after_are_apart),
        cmocka_unit_test(cycles_end_after_their_number),
        cmocka_unit_test(a_million_cycles_do_not_drift),
        cmocka_unit_test(times_of_a_curve_without_duration_hold),
        cmocka_unit_test(cycled_times_are_not_rounded_over_a_key),
        cmocka_unit_test(openusd_two_knot_bezier_has_its_values),
        cmocka_unit_test(validate_names_the_first_offender),
        cmocka_unit_test(each_number_of_a_key_is_checked),
        cmocka_unit_test(an_infinite_time_is_the_nearest_key_of_cycles),
        cmocka_unit_test(only_bezier_segments_are_limited),
    };
    return cmocka_run_group_tests_name("fcurve", tests, NULL, NULL);
}
