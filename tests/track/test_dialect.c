/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdint.h>

#include "random.h"
#include "support/clips.h"
#include "support/expect.h"

enum { KEYS = 6, ROOM = 4000 };

static nkw_motion cubic_bezier(float x1, float y1, float x2, float y2, float t)
{
    const nkw_easing e = {NKW_EASING_CUBIC_BEZIER, {x1, y1, x2, y2}, NKW_EASE_JUMP_END, 0, NULL, NULL};
    return nkw_easing_evaluate(&e, t);
}

static nkw_fcurve curve_of(const nkw_fcurve_key *keys, size_t count)
{
    nkw_fcurve c = {keys, count, NKW_FCURVE_OUTSIDE_HOLD, NKW_FCURVE_OUTSIDE_HOLD, 0, 0, NKW_HANDLE_NONE};
    return c;
}

/* Handles within their segments, kinds as asked. */
static void draw_keys(random_source *r, nkw_fcurve_key *keys, size_t count, unsigned kinds)
{
    for (size_t k = 0; k < count; k++) {
        nkw_fcurve_key key = {(k ? keys[k - 1].time : -2.0f) + random_between(r, 0.25f, 2.0f),
                              random_between(r, -4, 4),
                              {0, 0},
                              {0, 0},
                              NKW_FCURVE_BEZIER,
                              NKW_EASE_LINEAR};
        key.out.time = random_between(r, 0.05f, 0.25f);
        key.in.time = -random_between(r, 0.05f, 0.25f);
        key.out.value = random_between(r, -2, 2);
        key.in.value = random_between(r, -2, 2);
        key.kind = kinds & (1u << NKW_FCURVE_BEZIER) ? NKW_FCURVE_BEZIER : NKW_FCURVE_CONSTANT;
        for (unsigned i = (unsigned)(random_bits(r) % 5), n = 0; n < 5; n++, i = (i + 1) % 5)
            if (kinds & (1u << i)) {
                key.kind = (nkw_fcurve_kind)i;
                break;
            }
        key.ease = (nkw_ease_kind)(random_bits(r) % NKW_EASE_CSS_STEP_END);
        keys[k] = key;
    }
}

static void expect_same_curve(const nkw_fcurve_key *a, const nkw_fcurve_key *b, size_t count, double bound)
{
    nkw_fcurve one = curve_of(a, count), other = curve_of(b, count);
    for (int i = 0; i <= 200; i++) {
        float time = a[0].time + (a[count - 1].time - a[0].time) * (float)i / 200.0f;
        expect_near(nkw_fcurve_sample(&one, time, NULL).value, nkw_fcurve_sample(&other, time, NULL).value, bound);
    }
}

/* ---- Slopes ---- */

static void unweighted_slopes_are_the_hermite_curve(void **state)
{
    (void)state;
    const nkw_slope_key slopes[2] = {{1, 2, 9, 3, 9, 9, NKW_WEIGHTED_NONE, NKW_FCURVE_BEZIER},
                                     {3, 1, -1, 9, 9, 9, NKW_WEIGHTED_NONE, NKW_FCURVE_BEZIER}};
    nkw_fcurve_key keys[2];
    assert_int_equal(nkw_fcurve_from_slope_keys(slopes, 2, NKW_WEIGHT_FRACTION, keys, NULL), NKW_OK);
    nkw_fcurve c = curve_of(keys, 2);
    for (int i = 0; i <= 32; i++)
        expect_near(nkw_fcurve_sample(&c, 1 + (float)i / 16, NULL).value, nkw_hermite(2, 6, 1, -2, (float)i / 32), 1e-6);
}

/* Unreal's formula: the tangent's angle and its length in the plane. */
static void weights_are_those_of_their_tools(void **state)
{
    (void)state;
    const nkw_slope_key s[2] = {{0, 0, 0, 2, 0, 0.5f, NKW_WEIGHTED_OUT, NKW_FCURVE_BEZIER},
                                {2, 1, -1, 0, 0.25f, 0, NKW_WEIGHTED_IN, NKW_FCURVE_BEZIER}};
    nkw_fcurve_key keys[2];
    double angle = atan(2.0), other = atan(-1.0);
    nkw_fcurve_from_slope_keys(s, 2, NKW_WEIGHT_FRACTION, keys, NULL);
    expect_bits(keys[0].out.time, 1.0f);
    expect_bits(keys[0].out.value, 2.0f);
    expect_bits(keys[1].in.time, -0.5f);
    expect_bits(keys[1].in.value, 0.5f);
    nkw_fcurve_from_slope_keys(s, 2, NKW_WEIGHT_SECONDS, keys, NULL);
    expect_bits(keys[0].out.time, 0.5f);
    expect_bits(keys[1].in.time, -0.25f);
    nkw_fcurve_from_slope_keys(s, 2, NKW_WEIGHT_LENGTH, keys, NULL);
    expect_near(keys[0].out.time, 0.5 * cos(angle), 1e-7);
    expect_near(keys[0].out.value, 0.5 * sin(angle), 1e-7);
    expect_near(keys[1].in.time, -0.25 * cos(other), 1e-7);
    expect_near(keys[1].in.value, -0.25 * sin(other), 1e-7);
}

static void slopes_come_back(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 2000; i++) {
        nkw_fcurve_key keys[KEYS], back[KEYS];
        nkw_slope_key slopes[KEYS];
        nkw_weight_unit unit = (nkw_weight_unit)(i % 3);
        draw_keys(&r, keys, KEYS, 0xf);
        assert_int_equal(nkw_slope_keys_from_fcurve(keys, KEYS, unit, slopes, NULL), NKW_OK);
        assert_int_equal(nkw_fcurve_from_slope_keys(slopes, KEYS, unit, back, NULL), NKW_OK);
        expect_same_curve(keys, back, KEYS, 1e-5);
        assert_int_equal(nkw_slope_keys_from_fcurve(back, KEYS, unit, slopes, NULL), NKW_OK);
    }
}

static void infinite_slopes_are_steps(void **state)
{
    (void)state;
    nkw_slope_key s[3] = {{0, 1, 0, INFINITY, 0, 0, NKW_WEIGHTED_NONE, NKW_FCURVE_BEZIER},
                          {1, 2, 0, 1, 0, 0, NKW_WEIGHTED_NONE, NKW_FCURVE_BEZIER},
                          {2, 3, -INFINITY, 0, 0, 0, NKW_WEIGHTED_NONE, NKW_FCURVE_BEZIER}};
    nkw_fcurve_key keys[3];
    assert_int_equal(nkw_fcurve_from_slope_keys(s, 3, NKW_WEIGHT_FRACTION, keys, NULL), NKW_OK);
    assert_int_equal(keys[0].kind, NKW_FCURVE_CONSTANT);
    assert_int_equal(keys[1].kind, NKW_FCURVE_CONSTANT);
}

static void slopes_with_errors_are_named(void **state)
{
    (void)state;
    nkw_slope_key s[2] = {{0, 1, 0, 0, NAN, NAN, NKW_WEIGHTED_NONE, NKW_FCURVE_BEZIER},
                          {1, 2, 0, 0, 0, 0, NKW_WEIGHTED_NONE, NKW_FCURVE_BEZIER}};
    nkw_fcurve_key keys[2];
    size_t bad = 9;
    assert_int_equal(nkw_fcurve_from_slope_keys(s, 2, NKW_WEIGHT_FRACTION, keys, &bad), NKW_OK);
    assert_int_equal(nkw_fcurve_from_slope_keys(s, 0, NKW_WEIGHT_FRACTION, keys, &bad), NKW_EMPTY);
    assert_int_equal(nkw_fcurve_from_slope_keys(s, 2, (nkw_weight_unit)3, keys, &bad), NKW_BAD_METHOD);
    s[1].weighted = NKW_WEIGHTED_IN;
    s[1].in_weight = INFINITY;
    assert_int_equal(nkw_fcurve_from_slope_keys(s, 2, NKW_WEIGHT_FRACTION, keys, &bad), NKW_NOT_FINITE);
    assert_int_equal(bad, 1);
    s[1].weighted = NKW_WEIGHTED_NONE;
    s[1].time = -1;
    assert_int_equal(nkw_fcurve_from_slope_keys(s, 2, NKW_WEIGHT_FRACTION, keys, &bad), NKW_NOT_ASCENDING);
    s[0].kind = NKW_FCURVE_EASE;
    assert_int_equal(nkw_fcurve_from_slope_keys(s, 2, NKW_WEIGHT_FRACTION, keys, &bad), NKW_BAD_METHOD);
    const nkw_fcurve_key up[2] = {{0, 0, {0, 0}, {0, 1}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                                  {1, 1, {0, 0}, {0, 0}, NKW_FCURVE_EASE, NKW_EASE_LINEAR}};
    assert_int_equal(nkw_slope_keys_from_fcurve(up, 2, NKW_WEIGHT_FRACTION, s, &bad), NKW_OUT_OF_RANGE);
    assert_int_equal(bad, 0);
    assert_int_equal(nkw_slope_keys_from_fcurve(up + 1, 1, NKW_WEIGHT_FRACTION, s, &bad), NKW_BAD_METHOD);
}

/* ---- Blender ---- */

static void blender_keys_come_back(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 500; i++) {
        nkw_fcurve_key keys[KEYS], back[KEYS];
        nkw_blender_key blender[KEYS];
        draw_keys(&r, keys, KEYS, 0x15);
        for (int k = 0; k < KEYS; k++)
            keys[k].ease = (nkw_ease_kind)(NKW_EASE_SINE_IN + (int)(random_bits(&r) % 15));
        assert_int_equal(nkw_blender_keys_from_fcurve(keys, KEYS, blender, NULL), NKW_OK);
        assert_int_equal(nkw_fcurve_from_blender_keys(blender, KEYS, back, NULL), NKW_OK);
        expect_same_curve(keys, back, KEYS, 1e-4);
        for (int k = 0; k < KEYS; k++)
            assert_true(back[k].kind == keys[k].kind &&
                        (keys[k].kind != NKW_FCURVE_EASE || back[k].ease == keys[k].ease));
    }
}

static void blender_easing_auto_depends_on_the_family(void **state)
{
    (void)state;
    nkw_blender_key b = {{-1, 0}, {0, 0}, {1, 0}, 3, 0};
    nkw_fcurve_key key;
    static const nkw_ease_kind want[10] = {NKW_EASE_BACK_OUT, NKW_EASE_BOUNCE_OUT, NKW_EASE_CIRC_IN, NKW_EASE_CUBIC_IN,
                                           NKW_EASE_COUNT,    NKW_EASE_COUNT,      NKW_EASE_QUAD_IN, NKW_EASE_QUART_IN,
                                           NKW_EASE_QUINT_IN, NKW_EASE_SINE_IN};
    size_t bad;
    for (int i = 0; i < 10; i++) {
        b.interpolation = 3 + i;
        nkw_result result = nkw_fcurve_from_blender_keys(&b, 1, &key, &bad);
        assert_int_equal(result, want[i] == NKW_EASE_COUNT ? NKW_BAD_METHOD : NKW_OK);
        assert_true(result != NKW_OK || key.ease == want[i]);
    }
    b.interpolation = 13;
    assert_int_equal(nkw_fcurve_from_blender_keys(&b, 1, &key, &bad), NKW_BAD_METHOD);
    assert_int_equal(nkw_fcurve_from_blender_keys(&b, 0, &key, &bad), NKW_EMPTY);
    key.kind = NKW_FCURVE_CONSTANT_NEXT;
    assert_int_equal(nkw_blender_keys_from_fcurve(&key, 1, &b, &bad), NKW_BAD_METHOD);
}

/* ---- Types of handles ---- */

static void handles_follow_from_their_types(void **state)
{
    (void)state;
    const nkw_handle_types all[5] = {{NKW_HANDLE_AUTO, NKW_HANDLE_AUTO},
                                     {NKW_HANDLE_AUTO, NKW_HANDLE_AUTO},
                                     {NKW_HANDLE_VECTOR, NKW_HANDLE_VECTOR},
                                     {NKW_HANDLE_FREE, NKW_HANDLE_ALIGNED},
                                     {NKW_HANDLE_ALIGNED, NKW_HANDLE_VECTOR}};
    nkw_fcurve_key keys[5] = {{0, 0, {0, 0}, {0, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                              {1, 1, {0, 0}, {0, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                              {3, 5, {0, 0}, {0, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                              {4, 5, {-0.5f, 1}, {0.25f, 9}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                              {5, 7, {-0.5f, 0}, {0, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR}};
    nkw_fcurve_auto_handles(keys, 5, all);
    expect_near(keys[0].out.time, 1 / 2.5614, 1e-7);
    expect_near(keys[0].out.value, 0, 0);
    expect_near(keys[1].in.time, -1 / 2.5614, 1e-7);
    expect_near(keys[1].in.value, -1.5 / 2.5614, 1e-7);
    expect_near(keys[1].out.time, 2 / 2.5614, 1e-7);
    expect_near(keys[1].out.value, 3 / 2.5614, 1e-6);
    expect_near(keys[2].in.value, -4.0 / 3, 1e-6);
    expect_near(keys[2].out.time, 1.0 / 3, 1e-7);
    expect_near(keys[3].in.value, 1, 0);
    expect_near(keys[3].out.value, -0.5, 0);
    expect_near(keys[4].out.value, 2.0 / 3, 1e-6);
    expect_near(keys[4].in.value, -1, 1e-6);
}

/* Clamped handles do not overshoot: each segment stays between its keys. */
static void clamped_handles_stay_between_their_keys(void **state)
{
    (void)state;
    random_source r = random_from(7);
    const nkw_handle_types clamped = {NKW_HANDLE_AUTO_CLAMPED, NKW_HANDLE_AUTO_CLAMPED};
    const nkw_handle_types types[KEYS] = {clamped, clamped, clamped, clamped, clamped, clamped};
    for (int round = 0; round < 500; round++) {
        nkw_fcurve_key keys[KEYS];
        draw_keys(&r, keys, KEYS, 0x8);
        if (round % 2)
            for (int k = 1; k < KEYS; k++)
                keys[k].value = keys[k - 1].value + random_unit(&r);
        nkw_fcurve_auto_handles(keys, KEYS, types);
        nkw_fcurve c = curve_of(keys, KEYS);
        for (int k = 0; k + 1 < KEYS; k++)
            for (int i = 0; i <= 16; i++) {
                float v = nkw_fcurve_sample(&c, nkw_lerp(keys[k].time, keys[k + 1].time, (float)i / 16.0f), NULL).value;
                assert_true(v >= nkw_min(keys[k].value, keys[k + 1].value) - 1e-5f);
                assert_true(v <= nkw_max(keys[k].value, keys[k + 1].value) + 1e-5f);
            }
    }
}

static void handles_of_one_key_or_no_duration_are_defined(void **state)
{
    (void)state;
    const nkw_handle_types types[2] = {{NKW_HANDLE_AUTO, NKW_HANDLE_AUTO}, {NKW_HANDLE_VECTOR, (nkw_handle_type)99}};
    nkw_fcurve_key keys[2] = {{1, 2, {-1, 5}, {1, 5}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                              {1, 3, {-1, 5}, {1, 5}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR}};
    nkw_fcurve_auto_handles(keys, 1, types);
    expect_bits(keys[0].out.value, 5);
    nkw_fcurve_auto_handles(keys, 2, types);
    assert_true(isfinite(keys[0].out.time) && isfinite(keys[1].in.value));
    expect_bits(keys[1].out.value, 5);
    nkw_fcurve_auto_handles(NULL, 0, NULL);
}

/* ---- CSS ---- */

static void css_curves_come_back(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 2000; i++) {
        nkw_fcurve_key keys[2];
        float css[4], back[4];
        draw_keys(&r, keys, 2, 0x8);
        for (int k = 0; k < 4; k++)
            css[k] = k % 2 ? random_between(&r, -1, 2) : random_unit(&r);
        nkw_fcurve_from_css(css, keys);
        nkw_fcurve c = curve_of(keys, 2);
        float t = random_unit(&r), h = keys[1].time - keys[0].time, time = keys[0].time + t * h;
        nkw_motion p = nkw_fcurve_sample(&c, time, NULL), e = cubic_bezier(css[0], css[1], css[2], css[3], t);
        double rise = (double)keys[1].value - keys[0].value;
        expect_near(p.value, keys[0].value + rise * e.value, 1e-5 + 1e-6 * fabs(rise * e.velocity));
        if (fabs(rise) < 0.01)
            continue;
        assert_int_equal(nkw_fcurve_to_css(keys, back), NKW_OK);
        expect_floats_near(back, css, 4, 1e-6);
    }
}

/* ---- Splines and tracks ---- */

static void tcb_keys_are_those_of_the_spline(void **state)
{
    (void)state;
    const float times[4] = {0, 1, 3, 4}, values[8] = {0, 9, 2, 9, 1, 9, 3, 9};
    const nkw_tcb tcb[4] = {{0, 0, 0}, {0.5f, 0.25f, -0.5f}, {-0.5f, 0, 1}, {0, 0, 0}};
    nkw_spline spline = {times, values, 4, 2, 2, NKW_SPLINE_TCB, NKW_SPLINE_ENDS_FREE, 0, tcb, NULL};
    float in[8], out[8], triples[24];
    nkw_tangent_span span = {in, out, 2};
    nkw_fcurve_key keys[4];
    const nkw_track track = {times, triples, 4, 2, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE, NULL};
    assert_int_equal(nkw_spline_tangents(&spline, span, NULL, (nkw_work){NULL, 0}), NKW_OK);
    for (int k = 0; k < 8; k++) {
        float *triple = triples + 6 * (k / 2) + k % 2;
        triple[0] = in[k], triple[2] = values[k], triple[4] = out[k];
    }
    assert_int_equal(nkw_fcurve_from_track(&track, 0, keys, NULL), NKW_OK);
    nkw_fcurve c = curve_of(keys, 4);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i <= 16; i++) {
            float h = times[k + 1] - times[k], t = (float)i / 16.0f;
            float want = nkw_hermite(values[2 * k], h * out[2 * k], values[2 * k + 2], h * in[2 * k + 2], t);
            expect_near(nkw_fcurve_sample(&c, times[k] + t * h, NULL).value, want, 2e-6);
        }
    assert_int_equal(nkw_fcurve_from_track(&track, 2, keys, NULL), NKW_OUT_OF_RANGE);
}

static void components_of_tracks_are_fcurves(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int round = 0; round < 60; round++) {
        float times[5], values[30], got[2];
        unsigned char each[5];
        for (int k = 0; k < 5; k++) {
            times[k] = (k ? times[k - 1] : 0.0f) + random_between(&r, 0.1f, 1);
            each[k] = (unsigned char)(random_bits(&r) % 3);
        }
        for (int i = 0; i < 30; i++)
            values[i] = random_between(&r, -2, 2);
        nkw_track track = {times, values, 5, 2, NKW_TRACK_FLOATS, (nkw_interpolation)(round % 3), NULL};
        if (round % 6 == 5)
            track.key_interpolation = each;
        nkw_fcurve_key keys[2][5];
        for (size_t i = 0; i < 2; i++)
            assert_int_equal(nkw_fcurve_from_track(&track, i, keys[i], NULL), NKW_OK);
        for (int i = 0; i < 100; i++) {
            float time = random_between(&r, -0.5f, times[4] + 0.5f);
            nkw_fcurve x = curve_of(keys[0], 5), y = curve_of(keys[1], 5);
            nkw_track_sample(&track, time, NULL, got);
            expect_near(nkw_fcurve_sample(&x, time, NULL).value, got[0], 3e-6);
            expect_near(nkw_fcurve_sample(&y, time, NULL).value, got[1], 3e-6);
        }
        assert_int_equal(nkw_fcurve_from_track(&track, 2, keys[0], NULL), NKW_OUT_OF_RANGE);
        track.count = 0;
        assert_int_equal(nkw_fcurve_from_track(&track, 0, keys[0], NULL), NKW_EMPTY);
    }
}

static float room_times[ROOM], room_values[9 * ROOM];

static nkw_track_span memory_of(size_t keys)
{
    nkw_track_span m = {room_times, room_values, NULL, keys};
    return m;
}

/* Dense samples: the error between the 31 times of a segment is not much larger. */
static void expect_within(const nkw_fcurve *curves, size_t width, const nkw_track *track, float error)
{
    float first = track->times[0], last = track->times[track->count - 1], got[3];
    for (int i = 0; i <= 3000; i++) {
        float time = first + (last - first) * (float)i / 3000.0f;
        nkw_track_sample(track, time, NULL, got);
        for (size_t c = 0; c < width; c++)
            expect_near(got[c], nkw_fcurve_sample(curves + c, time, NULL).value, 1.1 * error + 2e-6);
    }
    for (size_t k = 1; k < track->count; k++)
        assert_true(track->times[k - 1] < track->times[k]);
}

static void tracks_are_within_the_tolerance(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int round = 0; round < 60; round++) {
        nkw_fcurve_key keys[3][KEYS];
        nkw_fcurve curves[3];
        nkw_track track;
        nkw_track_span memory = memory_of(ROOM);
        float tolerance = round % 2 ? 1e-2f : 1e-3f, error;
        for (int c = 0; c < 3; c++) {
            draw_keys(&r, keys[c], KEYS, round % 3 ? 0x1f : 0x8);
            curves[c] = curve_of(keys[c], KEYS);
            curves[c].before = curves[c].after = NKW_FCURVE_OUTSIDE_LINEAR;
        }
        size_t width = 1 + (size_t)round % 3;
        assert_int_equal(nkw_track_from_fcurves(curves, width, tolerance, memory, &track, &error), NKW_OK);
        assert_true(error <= tolerance && track.width == width);
        assert_int_equal(nkw_track_validate(&track, NULL), NKW_OK);
        expect_within(curves, width, &track, tolerance);
    }
}

static void handles_of_a_third_need_no_more_keys(void **state)
{
    (void)state;
    const nkw_slope_key slopes[3] = {{0, 2, 0, 3, 0, 0, NKW_WEIGHTED_NONE, NKW_FCURVE_BEZIER},
                                     {3, 1, -1, 2, 0, 0, NKW_WEIGHTED_NONE, NKW_FCURVE_LINEAR},
                                     {4, 1.5f, 0, 0, 0, 0, NKW_WEIGHTED_NONE, NKW_FCURVE_BEZIER}};
    nkw_fcurve_key keys[3];
    nkw_track track;
    nkw_track_span memory = memory_of(4);
    float error;
    nkw_fcurve_from_slope_keys(slopes, 3, NKW_WEIGHT_FRACTION, keys, NULL);
    nkw_fcurve c = curve_of(keys, 3);
    assert_int_equal(nkw_track_from_fcurves(&c, 1, 1e-5f, memory, &track, &error), NKW_OK);
    assert_int_equal(track.count, 3);
    assert_true(error < 1e-6f);
    expect_near(track.values[3], -1, 1e-6);
    assert_int_equal(nkw_track_from_fcurves(&c, 1, 1e-5f, memory, &track, NULL), NKW_OK);
}

static void jumps_take_two_keys_at_neighbouring_floats(void **state)
{
    (void)state;
    nkw_fcurve_key keys[4] = {{0, 1, {0, 0}, {0, 0}, NKW_FCURVE_CONSTANT, NKW_EASE_LINEAR},
                              {1, 2, {0, 0}, {0, 0}, NKW_FCURVE_CONSTANT_NEXT, NKW_EASE_LINEAR},
                              {2, 5, {0, 0}, {0, 0}, NKW_FCURVE_LINEAR, NKW_EASE_LINEAR},
                              {3, 7, {0, 0}, {0, 0}, NKW_FCURVE_LINEAR, NKW_EASE_LINEAR}};
    nkw_fcurve c = curve_of(keys, 4);
    nkw_track_span memory = memory_of(6);
    nkw_track track;
    float error, got;
    assert_int_equal(nkw_track_from_fcurves(&c, 1, 0.1f, memory, &track, &error), NKW_OK);
    assert_int_equal(track.count, 6);
    expect_bits(error, 0);
    const float times[7] = {0, 0.5f, 0x1.fffffep-1f, 1, 0x1.000002p0f, 1.5f, 2};
    for (int i = 0; i < 7; i++) {
        nkw_track_sample(&track, times[i], NULL, &got);
        expect_bits(got, nkw_fcurve_sample(&c, times[i], NULL).value);
    }
}

/* Curves that run back jump; vertical tangents are approached by ever shorter segments. */
static void regressive_and_vertical_segments_become_tracks(void **state)
{
    (void)state;
    const float lengths[][2] = {{2, 2}, {-1, 0.5f}, {0.5f, -1}, {-1, -1}, {1, 1}, {0, 0.3f}, {0, 0}, {3, 0.1f}};
    for (int i = 0; i < 8; i++) {
        nkw_fcurve_key keys[2] = {{1, 0, {0, 0}, {lengths[i][0], 0.5f}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                                  {2, 1, {-lengths[i][1], -0.25f}, {0, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR}};
        nkw_fcurve c = curve_of(keys, 2);
        nkw_track_span memory = memory_of(ROOM);
        nkw_track track;
        float error;
        assert_int_equal(nkw_track_from_fcurves(&c, 1, 2e-3f, memory, &track, &error), NKW_OK);
        assert_true(error <= 2e-3f && track.count < 200);
        expect_within(&c, 1, &track, 2e-3f);
    }
}

static nkw_quat rotation_of(const nkw_fcurve angles[3], nkw_euler_order order, float time)
{
    nkw_vec3 a = {nkw_fcurve_sample(angles, time, NULL).value, nkw_fcurve_sample(angles + 1, time, NULL).value,
                  nkw_fcurve_sample(angles + 2, time, NULL).value};
    return nkw_quat_from_euler(a, order);
}

/* Five turns in one segment, other axes by handles, and a segment that holds. */
static void euler_angles_keep_their_turns(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int order = 0; order <= 12; order++) {
        nkw_fcurve_key keys[3][4];
        nkw_fcurve angles[3];
        nkw_track track;
        nkw_track_span memory = memory_of(1000);
        float error, q[4];
        for (int c = 0; c < 3; c++) {
            draw_keys(&r, keys[c], 4, c == order % 3 ? 0x8 : 0xc);
            for (int k = 0; k < 4; k++)
                keys[c][k].time = (float)k;
            keys[c][2].value += c == order % 3 ? 31.415927f : 0.0f;
            angles[c] = curve_of(keys[c], 4);
        }
        keys[0][2].kind = keys[1][2].kind = keys[2][2].kind = NKW_FCURVE_CONSTANT;
        nkw_result result =
            nkw_track_from_euler_fcurves(angles, (nkw_euler_order)order, 2e-3f, memory, &track, &error);
        assert_int_equal(result, NKW_OK);
        assert_true(error <= 2e-3f && track.kind == NKW_TRACK_ROTATION && track.count < 300);
        assert_int_equal(nkw_track_validate(&track, NULL), NKW_OK);
        for (int i = 0; i <= 2000; i++) {
            float time = 3.0f * (float)i / 2000.0f;
            nkw_track_sample(&track, time, NULL, q);
            nkw_quat got = {q[0], q[1], q[2], q[3]};
            expect_near(nkw_quat_angle(got, rotation_of(angles, (nkw_euler_order)order, time)), 0, 2.2e-3);
        }
    }
}

/* Handles in time, Euler angles of several turns and a boolean, from tool to clip. */
static void fcurves_drive_the_joint_of_a_clip(void **state)
{
    (void)state;
    random_source r = random_from(8);
    nkw_fcurve_key keys[7][KEYS];
    nkw_fcurve curves[7];
    nkw_clip_track tracks[3] = {{NKW_CLIP_TRANSLATION, 0, {0}}, {NKW_CLIP_ROTATION, 0, {0}}, {NKW_CLIP_FLOATS, 0, {0}}};
    static float times[3][1000], values[3][12000];
    for (int c = 0; c < 7; c++) {
        draw_keys(&r, keys[c], KEYS, c < 6 ? 0x8 : 0x1);
        for (int k = 0; k < KEYS; k++) {
            keys[c][k].time = 0.5f * (float)k;
            keys[c][k].value = c < 6 ? keys[c][k].value + (c > 2 ? 6.0f * (float)k : 0.0f) : (float)(k % 2);
        }
        curves[c] = curve_of(keys[c], KEYS);
        curves[c].policy = NKW_HANDLE_CONTAIN;
    }
    for (int i = 0; i < 3; i++) {
        nkw_track_span memory = {times[i], values[i], NULL, 1000};
        nkw_result result =
            i == 1 ? nkw_track_from_euler_fcurves(curves + 3, NKW_EULER_ZXY, 1e-3f, memory, &tracks[1].track, NULL)
                   : nkw_track_from_fcurves(curves + 3 * i, i ? 1 : 3, 1e-3f, memory, &tracks[i].track, NULL);
        assert_int_equal(result, NKW_OK);
    }
    assert_int_equal(tracks[2].track.interpolation, NKW_INTERPOLATION_STEP);
    nkw_clip_source source = {tracks, 3, 1, 1, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
    size_t bytes;
    nkw_clip *clip = clip_build(&source, &bytes);
    float data[NKW_POSE_FLOATS(1)], flag;
    nkw_pose_span pose = {data, 1};
    for (int i = 0; i <= 1000; i++) {
        float time = 2.5f * (float)i / 1000.0f;
        assert_int_equal(nkw_clip_sample(clip, time, NULL, pose, &flag), NKW_OK);
        nkw_trs joint = nkw_pose_get(NKW_VIEW(nkw_pose, pose), 0);
        expect_near(joint.translation.x, nkw_fcurve_sample(curves, time, NULL).value, 1.2e-3);
        expect_near(joint.translation.z, nkw_fcurve_sample(curves + 2, time, NULL).value, 1.2e-3);
        expect_near(nkw_quat_angle(joint.rotation, rotation_of(curves + 3, NKW_EULER_ZXY, time)), 0, 1.5e-3);
        expect_bits(flag, nkw_fcurve_sample(curves + 6, time, NULL).value);
    }
    free(clip);
}

static void what_cannot_become_a_track_is_refused(void **state)
{
    (void)state;
    const nkw_fcurve_key keys[3] = {{0, 0, {0, 0}, {0, 0}, NKW_FCURVE_LINEAR, NKW_EASE_LINEAR},
                                    {1, 1, {0, 0}, {0, 0}, NKW_FCURVE_LINEAR, NKW_EASE_LINEAR},
                                    {2, 0, {0, 0}, {0, 0}, NKW_FCURVE_LINEAR, NKW_EASE_LINEAR}};
    nkw_fcurve c[2] = {curve_of(keys, 3), curve_of(keys, 2)};
    nkw_track_span memory = memory_of(2);
    nkw_track track;
    float error;
    assert_int_equal(nkw_track_from_fcurves(c, 0, 0.1f, memory, &track, &error), NKW_EMPTY);
    assert_int_equal(nkw_track_from_fcurves(c, 1, 0.1f, memory, &track, &error), NKW_TOO_SMALL);
    assert_true(track.count == 0 && error == INFINITY);
    memory.key_capacity = 0;
    assert_int_equal(nkw_track_from_fcurves(c, 1, 0.1f, memory, &track, &error), NKW_TOO_SMALL);
    memory.key_capacity = ROOM;
    assert_int_equal(nkw_track_from_fcurves(c, 1, NAN, memory, &track, &error), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_track_from_fcurves(c, 2, 0.1f, memory, &track, &error), NKW_OK);
    c[1].after = NKW_FCURVE_OUTSIDE_CYCLE;
    assert_int_equal(nkw_track_from_fcurves(c, 2, 0.1f, memory, &track, &error), NKW_MISMATCHED);
    c[0].after = NKW_FCURVE_OUTSIDE_CYCLE;
    assert_int_equal(nkw_track_from_fcurves(c, 1, 0.1f, memory, &track, &error), NKW_OK);
    c[0].key_count = 1;
    assert_int_equal(nkw_track_from_fcurves(c, 1, 0.1f, memory, &track, &error), NKW_OK);
    assert_int_equal(track.count, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unweighted_slopes_are_the_hermite_curve),
        cmocka_unit_test(weights_are_those_of_their_tools),
        cmocka_unit_test(slopes_come_back),
        cmocka_unit_test(infinite_slopes_are_steps),
        cmocka_unit_test(slopes_with_errors_are_named),
        cmocka_unit_test(blender_keys_come_back),
        cmocka_unit_test(blender_easing_auto_depends_on_the_family),
        cmocka_unit_test(handles_follow_from_their_types),
        cmocka_unit_test(clamped_handles_stay_between_their_keys),
        cmocka_unit_test(handles_of_one_key_or_no_duration_are_defined),
        cmocka_unit_test(css_curves_come_back),
        cmocka_unit_test(tcb_keys_are_those_of_the_spline),
        cmocka_unit_test(components_of_tracks_are_fcurves),
        cmocka_unit_test(tracks_are_within_the_tolerance),
        cmocka_unit_test(handles_of_a_third_need_no_more_keys),
        cmocka_unit_test(jumps_take_two_keys_at_neighbouring_floats),
        cmocka_unit_test(regressive_and_vertical_segments_become_tracks),
        cmocka_unit_test(euler_angles_keep_their_turns),
        cmocka_unit_test(fcurves_drive_the_joint_of_a_clip),
        cmocka_unit_test(what_cannot_become_a_track_is_refused),
    };
    return cmocka_run_group_tests_name("dialect", tests, NULL, NULL);
}
