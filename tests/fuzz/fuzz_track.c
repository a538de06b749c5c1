/* SPDX-License-Identifier: MIT */
#include "fuzz.h"
#include "../support/motion_span.h"
#include "../support/resample.h"

#include <nakawari/reduce.h>

#include <string.h>

enum { KEYS = 40, WIDTH = 9 };

static float *draw_times(fuzz *f, size_t count, int wild)
{
    float *times = fuzz_floats(f, count, wild);
    for (size_t k = 1; k < count && !wild; k++)
        times[k] = times[k - 1] + (times[k] > 0.0f ? times[k] / 8.0f : 0.0f);
    return times;
}

static nkw_track draw_track(fuzz *f)
{
    int wild = fuzz_byte(f) % 2;
    nkw_track t = {NULL,
                   NULL,
                   fuzz_upto(f, KEYS),
                   fuzz_byte(f) % 2 ? 4 : fuzz_upto(f, WIDTH),
                   (nkw_track_kind)fuzz_choice(f, 2),
                   (nkw_interpolation)fuzz_choice(f, 2),
                   NULL};
    if (fuzz_byte(f) % 4 == 0)
        t.key_interpolation = fuzz_bytes(f, t.count);
    t.times = draw_times(f, t.count, wild);
    float *values = fuzz_floats(f, nkw_track_value_count(&t), wild);
    int is_cubic = t.interpolation == NKW_INTERPOLATION_CUBICSPLINE;
    size_t key = t.width * (is_cubic ? 3 : 1), at = is_cubic ? t.width : 0;
    random_source r = fuzz_source(f);
    for (size_t k = 0; t.width == 4 && !wild && k < t.count; k++) {
        nkw_quat q = random_rotation(&r);
        memcpy(values + k * key + at, &q, sizeof q);
    }
    t.values = values;
    return t;
}

static void sample(fuzz *f, const nkw_track *t)
{
    float *out = fuzz_room(f, t->width), *again = fuzz_room(f, t->width);
    size_t bad;
    uint32_t cursor = (uint32_t)fuzz_huge(f);
    nkw_result result = nkw_track_validate(t, &bad);
    FUZZ_CHECK(bad < t->count || bad == 0);
    for (int i = 0; i < 6; i++) {
        float time = fuzz_float(f);
        nkw_segment any = {fuzz_huge(f), fuzz_float(f)};
        nkw_track_sample_segment(t, any, out);
        nkw_track_sample(t, time, NULL, out);
        nkw_track_sample(t, time, &cursor, again);
        FUZZ_CHECK(cursor + 1 < t->count || cursor == 0);
        if (result == NKW_OK)
            FUZZ_CHECK(fuzz_same(out, again, t->width));
    }
}

/* Values of at most 4 and tangents too, over times of moderate length. */
static void finite(fuzz *f, const nkw_track *t)
{
    float *out = fuzz_room(f, t->width);
    for (size_t i = 0; i < nkw_track_value_count(t); i++)
        if (!(t->values[i] <= 4.0f && t->values[i] >= -4.0f))
            return;
    if (nkw_track_validate(t, NULL) != NKW_OK || t->times[t->count - 1] - t->times[0] > 1e6f)
        return;
    for (int i = 0; i < 6; i++) {
        nkw_track_sample(t, fuzz_float(f), NULL, out);
        FUZZ_CHECK(fuzz_finite(out, t->width));
    }
}

static void bake(fuzz *f, const nkw_track *t, const nkw_track *other)
{
    const nkw_work work = {fuzz_block(f, NKW_TRACK_WORK(t->width)), NKW_TRACK_WORK(t->width)};
    const float rate = fuzz_float(f);
    size_t count = resample_count(t, rate);
    float far = track_difference(t, other, work);
    FUZZ_CHECK(!(far < 0.0f));
    nkw_track out;
    if (count <= 4096) {
        float *times = fuzz_room(f, count), *values = fuzz_room(f, count * t->width);
        resample(t, rate, times, values, work, &out);
        FUZZ_CHECK(out.count == count);
    }
    float *times = fuzz_room(f, t->count), *values = fuzz_room(f, t->count * t->width);
    float found = resample_within(t, fuzz_float(f), times, values, work, &out);
    FUZZ_CHECK(out.count <= t->count && (found > 0.0f) == (out.count > 0));
}

/* Aligned keys are aligned. */
static void align(fuzz *f, const nkw_track *t)
{
    size_t counted, negated, first;
    float *values = fuzz_room(f, nkw_track_value_count(t));
    nkw_result result = nkw_track_align(t, NULL, &counted, &first);
    FUZZ_CHECK(counted < t->count || counted == 0);
    FUZZ_CHECK((first > 0) == (counted > 0) && (first < t->count || first == 0));
    FUZZ_CHECK(nkw_track_align(t, values, &negated, NULL) == result && negated == counted);
    if (result == NKW_OK) {
        nkw_track aligned = *t;
        aligned.values = values;
        nkw_track_align(&aligned, values, &negated, &first);
        FUZZ_CHECK(negated == 0 && first == 0);
    }
}

static int track_is_turning(const nkw_track *t)
{
    return t->kind == NKW_TRACK_ROTATION || t->kind == NKW_TRACK_ROTATION_NORMALIZED;
}

/* The orientation is the sample. */
static void turn(fuzz *f, const nkw_track *t)
{
    nkw_quat_motion state;
    float time = fuzz_float(f), *plain = fuzz_room(f, t->width);
    if (track_is_turning(t) && nkw_track_sample_motion(t, time, quat_motion_span(&state)) == NKW_OK) {
        nkw_track_sample(t, time, NULL, plain);
        FUZZ_CHECK(fuzz_same(plain, &state.value.x, 4));
    }
}

static void edit(fuzz *f, const nkw_track *t, const nkw_track *other)
{
    size_t capacity = fuzz_upto(f, 2 * KEYS);
    nkw_track_span m = {fuzz_room(f, capacity), fuzz_room(f, capacity * 3 * WIDTH), fuzz_bytes(f, capacity), capacity};
    nkw_track out;
    FUZZ_CHECK((nkw_track_trim(t, fuzz_float(f), fuzz_float(f), m, &out) == NKW_OK) == (out.count > 0));
    FUZZ_CHECK(out.count <= capacity);
    FUZZ_CHECK((nkw_track_retime(t, fuzz_float(f), fuzz_float(f), m, &out) == NKW_OK) == (out.count > 0));
    FUZZ_CHECK((nkw_track_join(t, other, m, &out) == NKW_OK) == (out.count > 0));
    FUZZ_CHECK((nkw_track_close(t, fuzz_float(f), m, &out) == NKW_OK) == (out.count > 0));
    FUZZ_CHECK(out.count <= capacity);
}

/* As many keys at most as before; within the tolerance at the keys. */
static void reduce(fuzz *f, const nkw_track *t)
{
    const size_t count = nkw_track_value_count(t);
    const nkw_track_span memory = {fuzz_room(f, t->count), fuzz_room(f, count), fuzz_block(f, t->count), t->count};
    float tolerance = fuzz_byte(f) % 4 ? nkw_abs(fuzz_float(f)) : 0.0f, difference;
    const nkw_work work = {fuzz_block(f, NKW_TRACK_WORK(t->width)), NKW_TRACK_WORK(t->width)};
    nkw_track out;
    nkw_result result = nkw_track_reduce(t, tolerance, memory, &out, &difference);
    FUZZ_CHECK(out.count <= t->count && (result == NKW_OK) == (out.count > 0));
    if (result != NKW_OK)
        return;
    FUZZ_CHECK(difference <= tolerance && nkw_track_validate(&out, NULL) == NKW_OK);
    FUZZ_CHECK(!(track_difference(t, &out, work) < 0.0f));
}

static void fit(fuzz *f, const nkw_track *t)
{
    const size_t bytes = NKW_FIT_WORK(t->count, t->width);
    nkw_track_span m = {fuzz_room(f, t->count), fuzz_room(f, 3 * t->count * t->width), NULL, t->count};
    nkw_work work = {fuzz_block(f, bytes), bytes};
    nkw_track out;
    float error, tolerance = fuzz_float(f);
    FUZZ_CHECK((nkw_track_fit(t, tolerance, m, &out, &error, work) == NKW_OK) == (out.count > 0));
    FUZZ_CHECK(out.count <= t->count);
    FUZZ_CHECK(out.count == 0 || error <= tolerance || out.count == t->count);
}

/* There and back are the same bits. */
static void convert(fuzz *f, const nkw_track *t)
{
    nkw_axes_map map = {(nkw_axis)(fuzz_choice(f, 6) - 3), (nkw_axis)(fuzz_choice(f, 6) - 3),
                        (nkw_axis)(fuzz_choice(f, 6) - 3)};
    const nkw_axes_kind kind = NKW_CLIP_AXES((nkw_clip_target)fuzz_choice(f, 3));
    nkw_track c = *t;
    size_t count = nkw_track_value_count(t);
    float *values = fuzz_room(f, count);
    nkw_track_convert_axes(t, map, (nkw_axes_kind)fuzz_choice(f, 3), values);
    if (nkw_track_convert_axes(&c, map, kind, values) != NKW_OK)
        return;
    c.values = values;
    if (nkw_axes_map_is_valid(map)) {
        nkw_track_convert_axes(&c, nkw_axes_map_inverse(map), kind, values);
        FUZZ_CHECK(fuzz_same(values, t->values, count));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    nkw_track t = draw_track(&f), other = draw_track(&f);
    sample(&f, &t);
    finite(&f, &t);
    bake(&f, &t, &other);
    align(&f, &t);
    turn(&f, &t);
    edit(&f, &t, &other);
    reduce(&f, &t);
    fit(&f, &t);
    convert(&f, &t);
    return fuzz_end(&f);
}
