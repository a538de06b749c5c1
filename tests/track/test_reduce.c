/* SPDX-License-Identifier: MIT */
/* Reduced tracks and clips: which keys are kept, and the error. */
#include <math.h>
#include <string.h>

#include "random.h"
#include "support/expect.h"
#include "support/views.h"

#define MOST  2000
#define WIDTH 4

static float times[MOST], values[3 * WIDTH * MOST], new_times[MOST], new_values[3 * WIDTH * MOST];
static unsigned char modes[MOST], new_modes[MOST];

static nkw_track track_of(size_t count, size_t width, nkw_track_kind kind, nkw_interpolation interpolation)
{
    const nkw_track t = {times, values, count, width, kind, interpolation, NULL};
    return t;
}

static nkw_track reduced_to(const nkw_track *t, float tolerance, float *difference)
{
    const nkw_track_span memory = {new_times, new_values, new_modes, t->count};
    nkw_track out;
    assert_int_equal(nkw_track_reduce(t, tolerance, memory, &out, difference), NKW_OK);
    assert_true(out.count <= t->count);
    assert_int_equal(nkw_track_validate(&out, NULL), NKW_OK);
    expect_bits(out.times[0], t->times[0]);
    expect_bits(out.times[out.count - 1], t->times[t->count - 1]);
    return out;
}

static float difference_at(const nkw_track *a, const nkw_track *b, float time)
{
    float x[WIDTH], y[WIDTH], largest = 0.0f;
    nkw_track_sample(a, time, NULL, x);
    nkw_track_sample(b, time, NULL, y);
    if (a->kind != NKW_TRACK_FLOATS) {
        nkw_quat p = {x[0], x[1], x[2], x[3]}, q = {y[0], y[1], y[2], y[3]};
        return nkw_quat_angle(p, q);
    }
    for (size_t i = 0; i < a->width; i++)
        largest = fmaxf(largest, fabsf(x[i] - y[i]));
    return largest;
}

/* At 16 times of each segment. */
static float dense_difference(const nkw_track *a, const nkw_track *b)
{
    float largest = 0.0f;
    for (size_t k = 0; k + 1 < a->count; k++)
        for (int i = 0; i < 16; i++) {
            float time = nkw_lerp(a->times[k], a->times[k + 1], (float)i / 16.0f);
            largest = fmaxf(largest, difference_at(a, b, time));
        }
    return largest;
}

/* Each kept key is a key of the source, bit for bit, in its order. */
static void expect_keys_of(const nkw_track *out, const nkw_track *t)
{
    size_t size = t->width * (t->interpolation == NKW_INTERPOLATION_CUBICSPLINE ? 3 : 1), k = 0;
    for (size_t n = 0; n < out->count; n++, k++) {
        while (k < t->count && (t->times[k] != out->times[n] ||
                                memcmp(t->values + size * k, out->values + size * n, size * sizeof(float)) != 0))
            k++;
        assert_true(k < t->count);
    }
}

static void set_value(size_t k, size_t width, const float *v, const float *tangent)
{
    float *at = values + k * width * (tangent ? 3 : 1);
    if (tangent) {
        memcpy(at, tangent, width * sizeof(float));
        memcpy(at + 2 * width, tangent, width * sizeof(float));
    }
    memcpy(at + (tangent ? width : 0), v, width * sizeof(float));
}

/* A smooth motion at `rate`, its first key at `start`. */
static nkw_track draw(random_source *r, size_t count, float start, float rate, nkw_track_kind kind,
                      nkw_interpolation interpolation)
{
    const int turn = kind != NKW_TRACK_FLOATS, cubic = interpolation == NKW_INTERPOLATION_CUBICSPLINE;
    const float speed = random_between(r, 0.5f, 4.0f), phase = random_between(r, 0.0f, 6.0f);
    for (size_t k = 0; k < count; k++) {
        float v[4], tangent[4], x = speed * (float)k / rate + phase;
        times[k] = nkw_timeline_time((nkw_timeline){start, rate, 0}, k);
        for (size_t i = 0; i < 4; i++) {
            v[i] = sinf(x * (1.0f + 0.5f * (float)i));
            tangent[i] = speed * (1.0f + 0.5f * (float)i) * cosf(x * (1.0f + 0.5f * (float)i));
        }
        if (turn) {
            nkw_vec3 axis = {0.6f, 0.0f, 0.8f};
            nkw_quat q = nkw_quat_from_axis_angle(axis, 1.5f * v[0]);
            nkw_quat way = {0.6f, 0.0f, 0.8f, 0.0f};
            nkw_quat velocity = nkw_quat_scale(nkw_quat_mul(way, q), 0.75f * tangent[0]);
            memcpy(v, &q, sizeof q);
            memcpy(tangent, &velocity, sizeof velocity);
        }
        set_value(k, WIDTH, v, cubic ? tangent : NULL);
    }
    return track_of(count, WIDTH, kind, interpolation);
}

static void reduced_tracks_are_within_the_tolerance_at_all_times(void **state)
{
    (void)state;
    random_source r = random_from(11);
    for (int i = 0; i < 90; i++) {
        const nkw_track_kind kind = (nkw_track_kind)(i % 3);
        const nkw_interpolation mode = (nkw_interpolation)(i / 3 % 3);
        const float root = random_between(&r, 0.01f, 0.7f);
        const float tolerance = root * root;
        const nkw_track t = draw(&r, 300, 0.0f, 30.0f, kind, mode);
        float difference;
        const nkw_track out = reduced_to(&t, tolerance, &difference);
        expect_keys_of(&out, &t);
        const float dense = dense_difference(&t, &out);
        assert_true(difference <= tolerance);
        assert_true(dense <= tolerance + 2e-6f);
        assert_true(dense <= difference * (kind == NKW_TRACK_FLOATS ? 1.0f : 17.0f / 16.0f) + 2e-6f);
        if (mode != NKW_INTERPOLATION_STEP && tolerance > 0.15f)
            assert_true(out.count < t.count / 2);
    }
}

/* Cubic segments of the source are longer than the peaks of the difference are wide. */
static void differences_of_cubics_include_their_extremes(void **state)
{
    (void)state;
    static const float keys[9] = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 8.0f, 0.0f, 0.0f, 0.0f};
    memcpy(values, keys, sizeof keys);
    times[0] = 0.0f, times[1] = 1.0f, times[2] = 2.0f;
    const nkw_track t = track_of(3, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE);
    float difference;
    assert_int_equal(reduced_to(&t, 1.18f, &difference).count, 3); /* 8 t (1 - t)^2 is 32 / 27 at 1/3 */
    assert_int_equal(reduced_to(&t, 1.1852f, &difference).count, 2);
    expect_near(difference, 32.0 / 27.0, 1e-6);
}

static void a_straight_line_has_two_keys(void **state)
{
    (void)state;
    for (size_t k = 0; k < 1000; k++) {
        times[k] = (float)k / 30.0f;
        values[k] = 0.25f * times[k];
    }
    const nkw_track t = track_of(1000, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR);
    float difference;
    assert_int_equal(reduced_to(&t, 1e-5f, &difference).count, 2);
    assert_true(difference <= 1e-6f);
}

static void an_even_turn_has_one_key_for_less_than_half_a_turn(void **state)
{
    (void)state;
    const nkw_vec3 axis = {0.0f, 1.0f, 0.0f};
    for (size_t k = 0; k <= 360; k++) {
        nkw_quat q = nkw_quat_from_axis_angle(axis, nkw_radians_from_degrees((float)k));
        times[k] = (float)k / 60.0f;
        set_value(k, 4, &q.x, NULL);
    }
    const nkw_track t = track_of(361, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR);
    float difference;
    const nkw_track out = reduced_to(&t, 1e-5f, &difference); /* an interpolation by lerp needs 9 keys for 1e-2 */
    assert_int_equal(out.count, 4);
    assert_true(dense_difference(&t, &out) < 2e-6f);
}

/* 0, 120, 240 and 360 degrees: the ends are equal, and each step is beyond a quarter of a turn. */
static void a_turn_of_four_keys_remains_a_turn_at_every_tolerance(void **state)
{
    (void)state;
    const nkw_vec3 axis = {0.0f, 0.0f, 1.0f};
    for (int flip = 0; flip < 2; flip++) {
        for (size_t k = 0; k < 4; k++) {
            nkw_quat q = nkw_quat_from_axis_angle(axis, nkw_radians_from_degrees(120.0f * (float)k));
            q = nkw_quat_scale(q, flip && k % 2 ? -1.0f : 1.0f);
            times[k] = (float)k;
            set_value(k, 4, &q.x, NULL);
        }
        const nkw_track t = track_of(4, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR);
        for (float tolerance = 1e-6f; tolerance < 1e6f; tolerance *= 10.0f)
            assert_int_equal(reduced_to(&t, tolerance, NULL).count, 4);
    }
}

/* Ten whole turns at 36 degrees each: any tolerance keeps ten turns. */
static void whole_turns_are_counted_after_reduction(void **state)
{
    (void)state;
    const nkw_vec3 axis = {1.0f, 0.0f, 0.0f};
    for (size_t k = 0; k <= 100; k++) {
        nkw_quat q = nkw_quat_from_axis_angle(axis, nkw_radians_from_degrees(36.0f * (float)k));
        times[k] = (float)k;
        set_value(k, 4, &q.x, NULL);
    }
    const nkw_track t = track_of(101, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR);
    for (float tolerance = 1e-4f; tolerance < 1e4f; tolerance *= 100.0f) {
        const nkw_track out = reduced_to(&t, tolerance, NULL);
        double sum = 0.0;
        for (size_t k = 0; k + 1 < out.count; k++) {
            nkw_quat a, b;
            memcpy(&a, out.values + 4 * k, sizeof a);
            memcpy(&b, out.values + 4 * k + 4, sizeof b);
            nkw_vec3 turn = nkw_quat_log(nkw_quat_mul(b, nkw_quat_conjugate(a)));
            sum += 2.0 * (double)turn.x > 3.1416 ? 2.0 * (double)turn.x - 6.283185307 : 2.0 * (double)turn.x;
        }
        expect_near((float)sum, 62.8318531, 1e-3);
    }
}

/* A cubic pair that runs the long way is not joined with its neighbours. */
static void cubic_rotations_keep_the_way_of_their_signs(void **state)
{
    (void)state;
    const nkw_vec3 axis = {0.0f, 1.0f, 0.0f};
    const float zero[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    for (size_t k = 0; k < 6; k++) {
        nkw_quat q = nkw_quat_scale(nkw_quat_from_axis_angle(axis, 0.01f * (float)k), k < 3 ? 1.0f : -1.0f);
        times[k] = (float)k;
        set_value(k, 4, &q.x, zero);
    }
    const nkw_track t = track_of(6, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_CUBICSPLINE);
    const nkw_track out = reduced_to(&t, 10.0f, NULL);
    assert_int_equal(out.count, 4);
    expect_bits(out.times[1], 2.0f);
    expect_bits(out.times[2], 3.0f);
    assert_true(dense_difference(&t, &out) < 0.1f);
}

static void jumps_are_kept(void **state)
{
    (void)state;
    for (int mode = 0; mode < 3; mode++) {
        memset(values, 0, sizeof values);
        for (size_t k = 0; k < 40; k++) {
            const float v = k < 20 ? 1.0f : 2.0f, zero = 0.0f;
            times[k] = (float)(k < 20 ? k : k - 1);
            set_value(k, 1, &v, mode == NKW_INTERPOLATION_CUBICSPLINE ? &zero : NULL);
        }
        const nkw_track t = track_of(40, 1, NKW_TRACK_FLOATS, (nkw_interpolation)mode);
        for (int i = 0; i < 2; i++) {
            const nkw_track out = reduced_to(&t, i ? 100.0f : 0.0f, NULL);
            assert_int_equal(out.count, 4);
            expect_bits(out.times[1], 19.0f);
            expect_bits(out.times[2], 19.0f);
        }
    }
}

static void lossless_reduction_changes_no_sample(void **state)
{
    (void)state;
    random_source r = random_from(12);
    for (int i = 0; i < 60; i++) {
        const nkw_track_kind kind = (nkw_track_kind)(i % 3);
        const nkw_interpolation mode = i / 3 % 2 ? NKW_INTERPOLATION_STEP : NKW_INTERPOLATION_LINEAR;
        size_t count = 200;
        float v[4] = {0};
        for (size_t k = 0; k < count; k++) {
            if (k == 0 || random_unit(&r) < 0.1f) {
                nkw_quat q = random_rotation(&r);
                memcpy(v, &q, sizeof q);
            }
            times[k] = (float)k / 24.0f;
            set_value(k, 4, v, NULL);
        }
        const nkw_track t = track_of(count, 4, kind, mode);
        float difference;
        const nkw_track out = reduced_to(&t, 0.0f, &difference);
        expect_keys_of(&out, &t);
        assert_true(out.count < count / 2);
        expect_bits(difference, 0.0f);
        for (int n = 0; n < 2000; n++) {
            float x[4], y[4], time = n < 200 ? times[n] : random_between(&r, -1.0f, 10.0f);
            nkw_track_sample(&t, time, NULL, x);
            nkw_track_sample(&out, time, NULL, y);
            expect_floats_bits(x, y, 4);
        }
    }
}

static void lossless_reduction_keeps_what_differs_by_one_ulp(void **state)
{
    (void)state;
    for (size_t k = 0; k < 50; k++) {
        times[k] = (float)k;
        values[k] = k == 25 ? nextafterf(1.0f, 2.0f) : 1.0f;
    }
    const nkw_track t = track_of(50, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR);
    const nkw_track out = reduced_to(&t, 0.0f, NULL);
    assert_int_equal(out.count, 5);
    expect_bits(out.times[2], 25.0f);
}

static void the_error_does_not_grow_with_time(void **state)
{
    (void)state;
    random_source r = random_from(13);
    const nkw_track t = draw(&r, MOST, 3600.0f, 60.0f, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR);
    float difference;
    const nkw_track out = reduced_to(&t, 0.05f, &difference);
    assert_true(out.count < MOST / 2);
    for (size_t k = 0; k < MOST; k++)
        assert_true(difference_at(&t, &out, times[k]) <= 0.05f + 1e-6f);
}

static void weights_of_morph_targets_are_reduced_together(void **state)
{
    (void)state;
    for (size_t k = 0; k < 100; k++) {
        times[k] = (float)k;
        for (size_t i = 0; i < 4; i++)
            values[4 * k + i] = i == 2 && k == 50 ? 1.0f : 0.0f; /* a blink in one of four */
    }
    const nkw_track t = track_of(100, 4, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR);
    const nkw_track out = reduced_to(&t, 1e-3f, NULL);
    assert_int_equal(out.count, 5);
    expect_bits(out.times[2], 50.0f);
}

static void changes_of_the_mode_are_kept(void **state)
{
    (void)state;
    for (size_t k = 0; k < 30; k++) {
        times[k] = (float)k;
        values[k] = 1.0f;
        modes[k] = k < 10 ? NKW_INTERPOLATION_STEP : NKW_INTERPOLATION_LINEAR;
    }
    nkw_track t = track_of(30, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR);
    t.key_interpolation = modes;
    const nkw_track out = reduced_to(&t, 1.0f, NULL);
    assert_int_equal(out.count, 3);
    expect_bits(out.times[1], 10.0f);
    assert_int_equal(out.key_interpolation[0], NKW_INTERPOLATION_STEP);
    assert_int_equal(out.key_interpolation[1], NKW_INTERPOLATION_LINEAR);
}

/* 2e38, 0, -2e38: without the middle key the line would need a difference that no float is. */
static void values_whose_differences_overflow_keep_their_keys(void **state)
{
    (void)state;
    random_source r = random_from(16);
    for (int i = 0; i < 200; i++) {
        const int is_cubic = i % 2;
        const size_t count = i < 2 ? 3 : 12, part = is_cubic ? 3 : 1;
        float difference, time_scale = i % 4 < 2 ? 1.0f : 1e37f;
        const nkw_track t =
            track_of(count, 1, NKW_TRACK_FLOATS, is_cubic ? NKW_INTERPOLATION_CUBICSPLINE : NKW_INTERPOLATION_LINEAR);
        for (size_t k = 0; k < count; k++) {
            times[k] = (float)k * time_scale;
            values[part * k + part / 2] = i < 2 ? 2e38f * (1.0f - (float)k) : 3e38f * (1.0f - (float)k / 5.5f);
            if (is_cubic)
                values[3 * k] = values[3 * k + 2] = -(i < 2 ? 2e38f : 3e38f / 5.5f) / time_scale;
        }
        const float tolerance = random_between(&r, 0.0f, 1e36f);
        const nkw_track out = reduced_to(&t, tolerance, &difference);
        assert_true(difference <= tolerance);
        for (size_t k = 0; k < 16 * (count - 1); k++) {
            float want, got, time = nkw_lerp(times[k / 16], times[k / 16 + 1], (float)(k % 16) / 16.0f);
            nkw_track_sample(&t, time, NULL, &want);
            nkw_track_sample(&out, time, NULL, &got);
            assert_true(isfinite(want) && fabs((double)got - (double)want) <= (double)tolerance + 1e32);
        }
        assert_true(i < 2 || is_cubic || out.count < count);
    }
}

static void wrong_tracks_and_too_little_memory_are_refused(void **state)
{
    (void)state;
    random_source r = random_from(14);
    nkw_track t = draw(&r, 10, 0.0f, 30.0f, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR), out;
    const nkw_track_span memory = {new_times, new_values, NULL, 9};
    nkw_track_span enough = memory;
    float difference;
    enough.key_capacity = 10;
    assert_int_equal(nkw_track_reduce(&t, 1.0f, memory, &out, &difference), NKW_TOO_SMALL);
    assert_int_equal(out.count, 0);
    assert_true(difference > 3e38f);
    assert_int_equal(nkw_track_reduce(&t, -1.0f, enough, &out, NULL), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_track_reduce(&t, NAN, enough, &out, NULL), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_track_reduce(&t, INFINITY, enough, &out, NULL), NKW_OUT_OF_RANGE);
    t.key_interpolation = modes;
    memset(modes, 0, sizeof modes);
    assert_int_equal(nkw_track_reduce(&t, 1.0f, enough, &out, NULL), NKW_TOO_SMALL);
    t.key_interpolation = NULL;
    times[3] = 0.0f;
    assert_int_equal(nkw_track_reduce(&t, 1.0f, enough, &out, NULL), NKW_NOT_ASCENDING);
    t.count = 0;
    assert_int_equal(nkw_track_reduce(&t, 1.0f, enough, &out, NULL), NKW_EMPTY);
}

static void one_key_and_two_keys_are_copied(void **state)
{
    (void)state;
    random_source r = random_from(15);
    for (size_t count = 1; count < 3; count++) {
        const nkw_track t = draw(&r, count, 0.0f, 30.0f, NKW_TRACK_ROTATION, NKW_INTERPOLATION_CUBICSPLINE);
        const nkw_track out = reduced_to(&t, 1000.0f, NULL);
        assert_int_equal(out.count, count);
        expect_floats_bits(out.values, t.values, count * 12);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reduced_tracks_are_within_the_tolerance_at_all_times),
        cmocka_unit_test(differences_of_cubics_include_their_extremes),
        cmocka_unit_test(a_straight_line_has_two_keys),
        cmocka_unit_test(an_even_turn_has_one_key_for_less_than_half_a_turn),
        cmocka_unit_test(a_turn_of_four_keys_remains_a_turn_at_every_tolerance),
        cmocka_unit_test(whole_turns_are_counted_after_reduction),
        cmocka_unit_test(cubic_rotations_keep_the_way_of_their_signs),
        cmocka_unit_test(jumps_are_kept),
        cmocka_unit_test(lossless_reduction_changes_no_sample),
        cmocka_unit_test(lossless_reduction_keeps_what_differs_by_one_ulp),
        cmocka_unit_test(the_error_does_not_grow_with_time),
        cmocka_unit_test(weights_of_morph_targets_are_reduced_together),
        cmocka_unit_test(changes_of_the_mode_are_kept),
        cmocka_unit_test(values_whose_differences_overflow_keep_their_keys),
        cmocka_unit_test(wrong_tracks_and_too_little_memory_are_refused),
        cmocka_unit_test(one_key_and_two_keys_are_copied),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
