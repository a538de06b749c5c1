/* SPDX-License-Identifier: MIT */
/* Tracks that are cut, shifted, stretched, reversed, joined and closed. */
#include <math.h>

#include "random.h"
#include "support/expect.h"

#define KEYS  9
#define ROOM  (4 * KEYS)
#define WIDTH 4

/* A track with its arrays. */
typedef struct sheet {
    float times[ROOM], values[3 * WIDTH * ROOM];
    unsigned char modes[ROOM];
    nkw_track track;
} sheet;

/* The kinds of track that the tests draw: bit 0 rotations, then the interpolation; the last has all of them. */
enum { LINEAR, STEP, CUBIC, MIXED, MIXED_CUBIC, SORTS };

static void draw(random_source *r, sheet *s, int sort, int turns)
{
    int is_cubic = sort == CUBIC || sort == MIXED_CUBIC;
    nkw_track track = {s->times, s->values, KEYS, turns ? 4 : 3, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL};
    track.kind = turns ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
    track.interpolation = is_cubic       ? NKW_INTERPOLATION_CUBICSPLINE
                          : sort == STEP ? NKW_INTERPOLATION_STEP
                                         : NKW_INTERPOLATION_LINEAR;
    size_t size = track.width * (is_cubic ? 3 : 1), at = is_cubic ? track.width : 0;
    nkw_quat q = random_rotation(r);
    for (size_t k = 0; k < KEYS; k++) {
        s->times[k] = (k > 0 ? s->times[k - 1] : -1.0f) + random_between(r, 0.25f, 1.0f);
        for (size_t i = 0; i < size; i++)
            s->values[k * size + i] = random_between(r, -1.0f, 1.0f) * (turns ? 0.004f : 0.3f);
        q = random_near(r, q, 0.25f);
        if (turns)
            memcpy(s->values + k * size + at, &q, sizeof q);
        s->modes[k] = (unsigned char)(random_bits(r) % (is_cubic ? 3 : 2));
    }
    if (sort >= MIXED)
        track.key_interpolation = s->modes;
    s->track = track;
}

static nkw_track_span memory_of(sheet *s, size_t capacity)
{
    nkw_track_span m = {s->times, s->values, s->modes, capacity};
    return m;
}

/* Times between the keys of a track, and, if `keys`, at them. */
static float time_of(const nkw_track *t, int i, int keys)
{
    size_t k = (size_t)i / 4 % t->count, next = k + 1 < t->count ? k + 1 : k;
    int quarter = keys ? i % 4 : i % 4 == 0 ? 2 : i % 4;
    return nkw_lerp(t->times[k], t->times[next], 0.25f * (float)quarter);
}

static void expect_sample(const nkw_track *got, float at, const nkw_track *want, float time)
{
    float a[WIDTH], b[WIDTH];
    nkw_track_sample(got, at, NULL, a);
    nkw_track_sample(want, time, NULL, b);
    if (want->kind == NKW_TRACK_FLOATS)
        expect_floats_near(a, b, want->width, 2e-6);
    else {
        nkw_quat p = {a[0], a[1], a[2], a[3]}, q = {b[0], b[1], b[2], b[3]};
        expect_rotation_near(nkw_quat_normalize(p), nkw_quat_normalize(q), 2e-6);
    }
}

/* Every sort of track, rotations and numbers, several times. */
static void for_each_sort(void (*test)(random_source *, const sheet *))
{
    random_source r = random_from(11);
    for (int i = 0; i < 40 * SORTS; i++) {
        sheet s;
        draw(&r, &s, i % SORTS, i / SORTS % 2);
        assert_int_equal(nkw_track_validate(&s.track, NULL), NKW_OK);
        test(&r, &s);
    }
}

static void check_trim(random_source *r, const sheet *s)
{
    sheet made;
    nkw_track out;
    nkw_track_span m = memory_of(&made, ROOM);
    float from = random_between(r, s->times[0] - 0.5f, s->times[4]), to = from + random_between(r, 0.0f, 4.0f);
    if (random_bits(r) % 4 == 0)
        from = s->times[random_bits(r) % 4];
    if (random_bits(r) % 4 == 0)
        to = s->times[4 + random_bits(r) % 4];
    to = nkw_max(from, to);
    assert_int_equal(nkw_track_trim(&s->track, from, to, m, &out), NKW_OK);
    assert_int_equal(nkw_track_validate(&out, NULL), NKW_OK);
    assert_true(out.count <= KEYS + 1 && out.times[0] >= from && out.times[out.count - 1] <= to);
    for (int i = 0; i < 32; i++) {
        float time = nkw_lerp(from, to, (float)i / 31.0f);
        if (time >= out.times[0] && time <= out.times[out.count - 1])
            expect_sample(&out, time, &s->track, time);
    }
}

static void a_part_has_the_samples_of_the_track(void **state)
{
    (void)state;
    for_each_sort(check_trim);
}

static void keys_within_a_part_keep_their_bits(void **state)
{
    (void)state;
    random_source r = random_from(12);
    sheet s, made;
    nkw_track out;
    nkw_track_span m = memory_of(&made, ROOM);
    draw(&r, &s, CUBIC, 0);
    assert_int_equal(nkw_track_trim(&s.track, s.times[2], s.times[6], m, &out), NKW_OK);
    assert_int_equal(out.count, 5);
    expect_floats_bits(out.times, s.times + 2, 5);
    expect_floats_bits(out.values, s.values + 18, 45);
    assert_int_equal(nkw_track_trim(&s.track, -100.0f, 100.0f, m, &out), NKW_OK);
    assert_int_equal(out.count, KEYS);
    expect_floats_bits(out.values, s.values, 9 * KEYS);
}

static void a_part_outside_the_keys_is_one_held_key(void **state)
{
    (void)state;
    const float times[2] = {1.0f, 2.0f}, values[2] = {5.0f, 7.0f};
    nkw_track t = {times, values, 2, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL}, out;
    sheet made;
    nkw_track_span m = memory_of(&made, ROOM);
    assert_int_equal(nkw_track_trim(&t, -1.0f, 0.5f, m, &out), NKW_OK);
    assert_int_equal(out.count, 1);
    assert_true(out.times[0] == -1.0f && out.values[0] == 5.0f);
    assert_int_equal(nkw_track_trim(&t, 3.0f, 4.0f, m, &out), NKW_OK);
    assert_int_equal(out.count, 1);
    assert_true(out.times[0] == 3.0f && out.values[0] == 7.0f);
    assert_int_equal(nkw_track_trim(&t, 1.5f, 1.5f, m, &out), NKW_OK);
    assert_int_equal(out.count, 1);
    expect_bits(out.values[0], 6.0f);
}

static void a_part_begins_after_a_jump_at_its_start_and_ends_with_a_jump_at_its_end(void **state)
{
    (void)state;
    const float times[4] = {0.0f, 1.0f, 1.0f, 2.0f}, values[4] = {0.0f, 1.0f, 5.0f, 6.0f};
    nkw_track t = {times, values, 4, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL}, out;
    sheet made;
    nkw_track_span m = memory_of(&made, ROOM);
    assert_int_equal(nkw_track_trim(&t, 1.0f, 2.0f, m, &out), NKW_OK);
    assert_int_equal(out.count, 2);
    expect_bits(out.values[0], 5.0f);
    assert_int_equal(nkw_track_trim(&t, 0.5f, 1.0f, m, &out), NKW_OK);
    assert_int_equal(out.count, 3);
    expect_bits(out.values[0], 0.5f);
    expect_bits(out.values[1], 1.0f);
    expect_bits(out.values[2], 5.0f);
}

static void a_cut_rotation_of_cubics_is_normalised_when_sampled(void **state)
{
    (void)state;
    random_source r = random_from(13);
    sheet s, made;
    nkw_track out;
    nkw_track_span m = memory_of(&made, ROOM);
    draw(&r, &s, CUBIC, 1);
    float middle = 0.5f * (s.times[0] + s.times[1]);
    assert_int_equal(nkw_track_trim(&s.track, middle, s.times[3], m, &out), NKW_OK);
    assert_int_equal(out.kind, NKW_TRACK_ROTATION_NORMALIZED);
    assert_int_equal(nkw_track_trim(&s.track, s.times[0], s.times[3], m, &out), NKW_OK);
    assert_int_equal(out.kind, NKW_TRACK_ROTATION);
    for (int i = 0; i < 4; i++)
        s.values[16 + i] = -s.values[4 + i]; /* key 1 is -q of key 0: the curve passes through zero */
    assert_int_equal(nkw_track_trim(&s.track, middle, s.times[3], m, &out), NKW_NOT_UNIT);
    assert_int_equal(out.count, 0);
}

static void check_retime(random_source *r, const sheet *s)
{
    sheet made, back;
    nkw_track out, again;
    nkw_track_span m = memory_of(&made, ROOM), n = memory_of(&back, ROOM);
    float scale = random_between(r, 0.25f, 4.0f), offset = random_between(r, -8.0f, 8.0f);
    if (random_bits(r) % 2)
        scale = -scale;
    assert_int_equal(nkw_track_retime(&s->track, scale, offset, m, &out), NKW_OK);
    assert_int_equal(nkw_track_validate(&out, NULL), NKW_OK);
    for (int i = 0; i < 4 * KEYS; i++) {
        float time = time_of(&s->track, i, 0);
        if (i / 4 + 1 < KEYS)
            expect_sample(&out, scale * time + offset, &s->track, time);
    }
    expect_sample(&out, scale > 0.0f ? 1e3f : -1e3f, &s->track, 1e3f);
    expect_sample(&out, scale > 0.0f ? -1e3f : 1e3f, &s->track, -1e3f);
    assert_int_equal(nkw_track_retime(&s->track, -1.0f, 0.0f, m, &out), NKW_OK);
    assert_int_equal(nkw_track_retime(&out, -1.0f, 0.0f, n, &again), NKW_OK);
    if (s->track.key_interpolation || s->track.interpolation == NKW_INTERPOLATION_STEP)
        return;
    assert_int_equal(again.count, KEYS);
    expect_floats_bits(again.times, s->times, KEYS);
    expect_floats_bits(again.values, s->values, nkw_track_value_count(&s->track));
}

static void a_retimed_track_has_the_samples_at_the_new_times(void **state)
{
    (void)state;
    for_each_sort(check_retime);
}

static void a_reversed_step_holds_what_it_held(void **state)
{
    (void)state;
    const float times[3] = {0.0f, 1.0f, 3.0f}, values[3] = {1.0f, 2.0f, 3.0f};
    const float want_times[4] = {-3.0f, -3.0f, -1.0f, 0.0f}, want[4] = {3.0f, 2.0f, 1.0f, 1.0f};
    nkw_track t = {times, values, 3, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_STEP, NULL}, out;
    sheet made;
    nkw_track_span m = memory_of(&made, ROOM);
    assert_int_equal(nkw_track_retime(&t, -1.0f, 0.0f, m, &out), NKW_OK);
    assert_int_equal(out.count, 4);
    for (size_t k = 0; k < 4; k++)
        assert_true(out.times[k] == want_times[k] && out.values[k] == want[k]);
}

static void a_shift_may_be_made_in_place(void **state)
{
    (void)state;
    random_source r = random_from(14);
    sheet s, made;
    nkw_track want;
    draw(&r, &s, MIXED_CUBIC, 1);
    nkw_track_span m = memory_of(&made, ROOM), own = memory_of(&s, KEYS);
    assert_int_equal(nkw_track_retime(&s.track, 2.0f, 1.0f, m, &want), NKW_OK);
    assert_int_equal(nkw_track_retime(&s.track, 2.0f, 1.0f, own, &s.track), NKW_OK);
    expect_floats_bits(s.times, want.times, KEYS);
    expect_floats_bits(s.values, want.values, 12 * KEYS);
    assert_memory_equal(s.modes, want.key_interpolation, KEYS);
}

static void check_join(random_source *r, const sheet *s)
{
    sheet left, right, made;
    nkw_track a, b, out;
    nkw_track_span m = memory_of(&left, ROOM), n = memory_of(&right, ROOM), o = memory_of(&made, ROOM);
    float middle = random_bits(r) % 2 ? s->times[4] : 0.5f * (s->times[4] + s->times[5]);
    float first = s->times[0], last = s->times[KEYS - 1];
    assert_int_equal(nkw_track_trim(&s->track, first, middle, m, &a), NKW_OK);
    assert_int_equal(nkw_track_trim(&s->track, middle, last, n, &b), NKW_OK);
    b.kind = a.kind;
    assert_int_equal(nkw_track_join(&a, &b, o, &out), NKW_OK);
    assert_int_equal(out.count, a.count + b.count - 1);
    nkw_track want = s->track;
    want.kind = a.kind;
    for (int i = 0; i < 4 * KEYS - 4; i++)
        expect_sample(&out, time_of(&s->track, i, 1), &want, time_of(&s->track, i, 1));
}

static void two_parts_join_to_the_whole(void **state)
{
    (void)state;
    for_each_sort(check_join);
}

static void tracks_that_do_not_meet_join_with_a_jump(void **state)
{
    (void)state;
    const float times[2] = {4.0f, 5.0f}, values[2] = {1.0f, 2.0f}, later[2] = {10.0f, 12.0f};
    nkw_track a = {times, values, 2, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL}, b = a, out;
    sheet made;
    nkw_track_span m = memory_of(&made, ROOM);
    b.times = later;
    b.interpolation = NKW_INTERPOLATION_STEP;
    assert_int_equal(nkw_track_join(&a, &b, m, &out), NKW_OK);
    assert_int_equal(out.count, 4);
    assert_true(out.times[1] == 5.0f && out.times[2] == 5.0f && out.times[3] == 7.0f);
    assert_int_equal(out.key_interpolation[0], NKW_INTERPOLATION_LINEAR);
    assert_int_equal(out.key_interpolation[2], NKW_INTERPOLATION_STEP);
    m.key_interpolation = NULL;
    assert_int_equal(nkw_track_join(&a, &b, m, &out), NKW_TOO_SMALL);
    assert_int_equal(nkw_track_join(&a, &a, m, &out), NKW_OK);
    assert_null(out.key_interpolation);
    b = a;
    b.kind = NKW_TRACK_ROTATION;
    b.width = 4;
    assert_int_equal(nkw_track_join(&a, &b, m, &out), NKW_MISMATCHED);
}

/* The largest jump of the derivative between both ends, by differences. */
static void check_close(random_source *r, const sheet *s)
{
    sheet made;
    nkw_track out;
    nkw_track_span m = memory_of(&made, ROOM);
    float share = (float)(random_bits(r) % 3) * 0.5f, a[WIDTH], b[WIDTH];
    size_t size = nkw_track_value_count(&s->track) / KEYS, at = size > s->track.width ? s->track.width : 0;
    assert_int_equal(nkw_track_close(&s->track, share, m, &out), NKW_OK);
    assert_int_equal(out.count, KEYS);
    expect_floats_bits(out.times, s->times, KEYS);
    nkw_track_sample(&out, -1e3f, NULL, a);
    nkw_track_sample(&out, 1e3f, NULL, b);
    float sign = s->track.kind == NKW_TRACK_ROTATION && a[0] * b[0] < 0.0f ? -1.0f : 1.0f;
    for (size_t i = 0; i < s->track.width; i++)
        expect_bits(sign * b[i], a[i]);
    if (share == 0.0f)
        expect_floats_near(out.values + at, s->values + at, s->track.width, 0.0);
    if (share == 1.0f && s->track.kind == NKW_TRACK_FLOATS)
        expect_floats_near(out.values + (KEYS - 1) * size + at, s->values + (KEYS - 1) * size + at, 3, 1e-7);
}

static void a_closed_track_ends_where_it_begins(void **state)
{
    (void)state;
    for_each_sort(check_close);
}

/* Both sides of a formula of the derivative: samples near a key, of the track closed and of the closed samples. */
static void a_closed_cubic_is_the_cubic_plus_a_line(void **state)
{
    (void)state;
    random_source r = random_from(15);
    for (int i = 0; i < 50; i++) {
        sheet s, made;
        nkw_track out;
        nkw_track_span m = memory_of(&made, ROOM);
        draw(&r, &s, CUBIC, 0);
        assert_int_equal(nkw_track_close(&s.track, 0.5f, m, &out), NKW_OK);
        for (int k = 0; k < 4 * KEYS - 4; k++) {
            float time = time_of(&s.track, k, 1), a[3], b[3];
            double u = ((double)time - (double)s.times[0]) / ((double)s.times[KEYS - 1] - (double)s.times[0]);
            nkw_track_sample(&s.track, time, NULL, a);
            nkw_track_sample(&out, time, NULL, b);
            for (int c = 0; c < 3; c++) {
                double d = (double)s.values[9 * (KEYS - 1) + 3 + c] - (double)s.values[3 + c];
                expect_near((double)b[c], (double)a[c] + (0.5 - u) * d, 1e-6);
            }
        }
    }
}

/* A wheel that turns by 3 rad in equal keys, closed: it stands. With tangents, its tangents are zero. */
static void a_closed_turn_about_one_axis_stands(void **state)
{
    (void)state;
    const nkw_vec3 axis = {0.6f, 0.0f, 0.8f};
    sheet s, made;
    random_source r = random_from(16);
    draw(&r, &s, CUBIC, 1);
    for (size_t k = 0; k < KEYS; k++) {
        float angle = 3.0f * (s.times[k] - s.times[0]) / (s.times[KEYS - 1] - s.times[0]);
        nkw_quat q = nkw_quat_from_axis_angle(axis, angle);
        float rate = 1.5f / (s.times[KEYS - 1] - s.times[0]);
        nkw_quat half = {axis.x * rate, axis.y * rate, axis.z * rate, 0.0f}, tangent = nkw_quat_mul(half, q);
        memcpy(s.values + 12 * k, &tangent, sizeof tangent);
        memcpy(s.values + 12 * k + 4, &q, sizeof q);
        memcpy(s.values + 12 * k + 8, &tangent, sizeof tangent);
    }
    nkw_track out;
    nkw_track_span m = memory_of(&made, ROOM);
    assert_int_equal(nkw_track_close(&s.track, 0.0f, m, &out), NKW_OK);
    const float still[12] = {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0};
    for (size_t k = 0; k < KEYS; k++)
        expect_floats_near(out.values + 12 * k, still, 12, 1e-6);
}

static void wrong_arguments_are_refused(void **state)
{
    (void)state;
    random_source r = random_from(17);
    sheet s, made;
    nkw_track out, none, narrow;
    nkw_track_span m = memory_of(&made, ROOM);
    draw(&r, &s, LINEAR, 1);
    none = narrow = s.track;
    none.count = 0;
    narrow.width = 3;
    assert_int_equal(nkw_track_trim(&s.track, 1.0f, 0.0f, m, &out), NKW_NOT_ASCENDING);
    assert_int_equal(nkw_track_trim(&s.track, NAN, 0.0f, m, &out), NKW_NOT_FINITE);
    assert_int_equal(nkw_track_trim(&none, 0.0f, 1.0f, m, &out), NKW_EMPTY);
    assert_int_equal(nkw_track_trim(&narrow, 0.0f, 1.0f, m, &out), NKW_BAD_WIDTH);
    assert_int_equal(nkw_track_retime(&s.track, 0.0f, 1.0f, m, &out), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_track_retime(&s.track, INFINITY, 1.0f, m, &out), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_track_retime(&s.track, 3e38f, 3e38f, m, &out), NKW_NOT_FINITE);
    assert_int_equal(nkw_track_close(&s.track, 1.5f, m, &out), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_track_close(&s.track, NAN, m, &out), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_track_join(&none, &s.track, m, &out), NKW_EMPTY);
    assert_int_equal(nkw_track_join(&s.track, &none, m, &out), NKW_EMPTY);
    assert_int_equal(out.count, 0);
    for (size_t k = 0; k < KEYS; k++)
        s.times[k] = 1.0f;
    for (s.track.count = 2; s.track.count < KEYS; s.track.count++)
        assert_int_equal(nkw_track_close(&s.track, 0.5f, m, &out), NKW_NOT_ASCENDING);
    s.track.count = 1;
    assert_int_equal(nkw_track_close(&s.track, 0.5f, m, &out), NKW_OK);
    expect_floats_bits(out.values, s.values, 4);
}

static void values_that_overflow_are_refused(void **state)
{
    (void)state;
    const float times[3] = {0, 1, 2}, tangents[9] = {0, 1, 0, 1e20f, 2, 1e20f, 0, 3, 0}, far[3] = {3e38f, 0, -3e38f};
    const nkw_track cubic = {times, tangents, 3, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE, NULL};
    const nkw_track line = {times, far, 3, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL};
    float made_times[4], made[12];
    const nkw_track_span m = {made_times, made, NULL, 4};
    nkw_track out;
    assert_int_equal(nkw_track_retime(&cubic, 1e-30f, 0.0f, m, &out), NKW_NOT_FINITE);
    assert_int_equal(out.count, 0);
    assert_int_equal(nkw_track_retime(&cubic, 1e-10f, 0.0f, m, &out), NKW_OK);
    assert_int_equal(nkw_track_close(&line, 0.5f, m, &out), NKW_OK);
    assert_int_equal(nkw_track_close(&line, 0.0f, m, &out), NKW_OK);
    const float high[3] = {-3e38f, 3e38f, 0}; /* the middle key would rise by 1.5e38 */
    nkw_track rising = line;
    rising.values = high;
    assert_int_equal(nkw_track_close(&rising, 1.0f, m, &out), NKW_NOT_FINITE);
}

static nkw_result joined(const nkw_track *a, const nkw_track *b, nkw_track_span m)
{
    nkw_track out;
    nkw_result result = nkw_track_join(a, b, m, &out);
    assert_int_equal(out.count, result == NKW_OK ? a->count + b->count : 0);
    return result;
}

/* Each reason by itself, in the first and in the second. */
static void tracks_that_differ_do_not_join(void **state)
{
    (void)state;
    random_source r = random_from(19);
    static sheet s, t, made;
    const nkw_track_span m = memory_of(&made, ROOM);
    draw(&r, &s, LINEAR, 1);
    draw(&r, &t, LINEAR, 1);
    nkw_track other = t.track;
    assert_int_equal(joined(&s.track, &t.track, m), NKW_OK);
    other.kind = NKW_TRACK_FLOATS;
    assert_int_equal(joined(&s.track, &other, m), NKW_MISMATCHED);
    assert_int_equal(joined(&other, &s.track, m), NKW_MISMATCHED);
    other = t.track;
    other.interpolation = NKW_INTERPOLATION_CUBICSPLINE;
    assert_int_equal(joined(&s.track, &other, m), NKW_MISMATCHED);
    assert_int_equal(joined(&other, &s.track, m), NKW_MISMATCHED);
    /* The second of a mode for each key, the first of one mode. */
    other = t.track;
    other.interpolation = NKW_INTERPOLATION_STEP;
    assert_int_equal(joined(&s.track, &other, m), NKW_OK);
    assert_int_equal(made.modes[0], NKW_INTERPOLATION_LINEAR);
    assert_int_equal(made.modes[2 * KEYS - 1], NKW_INTERPOLATION_STEP);
    other = t.track;
    other.key_interpolation = t.modes;
    memset(t.modes, NKW_INTERPOLATION_STEP, sizeof t.modes);
    assert_int_equal(joined(&s.track, &other, m), NKW_OK);
    assert_int_equal(made.modes[2 * KEYS - 2], NKW_INTERPOLATION_STEP);
    /* The last time: of the first, and of the result. */
    t.times[KEYS - 1] = 3e38f;
    s.times[KEYS - 1] = 1e38f;
    assert_int_equal(joined(&s.track, &t.track, m), NKW_NOT_FINITE);
    t.times[KEYS - 1] = 2e38f;
    assert_int_equal(joined(&s.track, &t.track, m), NKW_OK);
    s.times[KEYS - 1] = INFINITY;
    assert_int_equal(joined(&s.track, &t.track, m), NKW_NOT_FINITE);
}

/* The first error counts: an empty track is EMPTY whatever the other arguments are. */
static void an_empty_track_is_empty_whatever_is_asked(void **state)
{
    (void)state;
    random_source r = random_from(20);
    static sheet s, made;
    const nkw_track_span m = memory_of(&made, ROOM);
    nkw_track out;
    draw(&r, &s, CUBIC, 0);
    /* Only the first time leaves the floats. */
    s.times[0] = -3e38f;
    assert_int_equal(nkw_track_retime(&s.track, 2, 0, m, &out), NKW_NOT_FINITE);
    assert_int_equal(nkw_track_retime(&s.track, -2, 0, m, &out), NKW_NOT_FINITE);
    assert_int_equal(nkw_track_retime(&s.track, 1, 0, m, &out), NKW_OK);
    assert_int_equal(nkw_track_trim(&s.track, 0, INFINITY, m, &out), NKW_NOT_FINITE);
    assert_int_equal(nkw_track_trim(&s.track, -INFINITY, 0, m, &out), NKW_NOT_FINITE);
    s.track.count = 0;
    assert_int_equal(nkw_track_retime(&s.track, 0, NAN, m, &out), NKW_EMPTY);
    assert_int_equal(nkw_track_retime(&s.track, NAN, 0, m, &out), NKW_EMPTY);
    assert_int_equal(nkw_track_trim(&s.track, NAN, 0, m, &out), NKW_EMPTY);
    assert_int_equal(nkw_track_close(&s.track, NAN, m, &out), NKW_EMPTY);
}

static void too_little_memory_is_refused_and_not_exceeded(void **state)
{
    (void)state;
    random_source r = random_from(18);
    sheet s, made;
    nkw_track out;
    draw(&r, &s, MIXED_CUBIC, 0);
    s.modes[2] = NKW_INTERPOLATION_STEP;
    s.modes[3] = NKW_INTERPOLATION_CUBICSPLINE;
    for (size_t capacity = 0; capacity <= KEYS; capacity++) {
        nkw_track_span m = memory_of(&made, capacity);
        made.times[capacity] = 77.0f;
        made.values[9 * capacity] = 77.0f;
        made.modes[capacity] = 77;
        int fits = capacity >= KEYS;
        assert_int_equal(nkw_track_close(&s.track, 0.5f, m, &out), fits ? NKW_OK : NKW_TOO_SMALL);
        assert_int_equal(nkw_track_retime(&s.track, 2.0f, 0.0f, m, &out), fits ? NKW_OK : NKW_TOO_SMALL);
        assert_int_equal(nkw_track_trim(&s.track, -9.0f, 99.0f, m, &out), fits ? NKW_OK : NKW_TOO_SMALL);
        assert_int_equal(nkw_track_retime(&s.track, -2.0f, 0.0f, m, &out), NKW_TOO_SMALL);
        assert_int_equal(nkw_track_join(&s.track, &s.track, m, &out), NKW_TOO_SMALL);
        assert_int_equal(out.count, 0);
        assert_true(made.times[capacity] == 77.0f && made.values[9 * capacity] == 77.0f && made.modes[capacity] == 77);
    }
    nkw_track_span m = memory_of(&made, ROOM);
    m.key_interpolation = NULL;
    assert_int_equal(nkw_track_close(&s.track, 0.5f, m, &out), NKW_TOO_SMALL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_part_has_the_samples_of_the_track),
        cmocka_unit_test(keys_within_a_part_keep_their_bits),
        cmocka_unit_test(a_part_outside_the_keys_is_one_held_key),
        cmocka_unit_test(a_part_begins_after_a_jump_at_its_start_and_ends_with_a_jump_at_its_end),
        cmocka_unit_test(a_cut_rotation_of_cubics_is_normalised_when_sampled),
        cmocka_unit_test(a_retimed_track_has_the_samples_at_the_new_times),
        cmocka_unit_test(a_reversed_step_holds_what_it_held),
        cmocka_unit_test(a_shift_may_be_made_in_place),
        cmocka_unit_test(two_parts_join_to_the_whole),
        cmocka_unit_test(tracks_that_do_not_meet_join_with_a_jump),
        cmocka_unit_test(a_closed_track_ends_where_it_begins),
        cmocka_unit_test(a_closed_cubic_is_the_cubic_plus_a_line),
        cmocka_unit_test(a_closed_turn_about_one_axis_stands),
        cmocka_unit_test(wrong_arguments_are_refused),
        cmocka_unit_test(values_that_overflow_are_refused),
        cmocka_unit_test(too_little_memory_is_refused_and_not_exceeded),
        cmocka_unit_test(tracks_that_differ_do_not_join),
        cmocka_unit_test(an_empty_track_is_empty_whatever_is_asked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
