/* SPDX-License-Identifier: MIT */
/* Curves of tools: handles, easing, fcurves. */
#include "fuzz.h"

#include <string.h>

enum { KEYS = 12, TIMES = 16, STOPS = 8 };

static nkw_handle draw_handle(fuzz *f)
{
    nkw_handle h = {fuzz_float(f), fuzz_float(f)};
    return h;
}

static int is_finite(const nkw_handle_segment *s)
{
    return fuzz_finite(&s->time0, sizeof *s / sizeof(float));
}

/* Values are between those of the control points: the curve is in their convex hull. */
static void check_value(const nkw_handle_segment *s, float value)
{
    double v[4] = {s->value0, (double)s->value0 + s->out.value, (double)s->value1 + s->in.value, s->value1};
    double low = v[0], high = v[0], size;
    for (int i = 1; i < 4; i++) {
        low = v[i] < low ? v[i] : low;
        high = v[i] > high ? v[i] : high;
    }
    size = high > -low ? high : -low;
    FUZZ_CHECK(size > 3e38 || (value >= low - 1e-6 * size && value <= high + 1e-6 * size));
}

static void handles(fuzz *f)
{
    nkw_handle_segment s = {fuzz_float(f), fuzz_float(f), draw_handle(f), draw_handle(f), fuzz_float(f), fuzz_float(f)};
    nkw_handle_segment left, right;
    float time = fuzz_byte(f) % 2 ? fuzz_float(f) : nkw_lerp(s.time0, s.time1, (float)fuzz_byte(f) / 255.0f);
    nkw_motion p = nkw_handle_sample(&s, time);
    float t = nkw_handle_parameter(&s, time);
    FUZZ_CHECK(t != t || (t >= 0.0f && t <= 1.0f));
    if (is_finite(&s) && fuzz_finite(&time, 1)) {
        check_value(&s, p.value);
        FUZZ_CHECK(p.velocity == p.velocity && p.acceleration == p.acceleration);
    }
    nkw_handle_split(&s, time, &left, &right);
    for (int policy = NKW_HANDLE_CONTAIN; policy <= NKW_HANDLE_KEEP_START; policy++) {
        nkw_handle_segment limited = nkw_handle_limit(&s, (nkw_handle_policy)policy);
        FUZZ_CHECK(!is_finite(&s) || !nkw_handle_runs_back(&limited));
    }
    nkw_handle_limit(&s, (nkw_handle_policy)fuzz_choice(f, 3));
}

static void eases(fuzz *f)
{
    float t = fuzz_float(f), inputs[STOPS], outputs[STOPS];
    nkw_ease_kind kind = (nkw_ease_kind)fuzz_choice(f, NKW_EASE_COUNT - 1);
    nkw_motion p = nkw_ease_evaluate(kind, t);
    FUZZ_CHECK(!(t >= 0.0f && t <= 1.0f) || (p.value > -0.5f && p.value < 1.5f));
    nkw_easing easing = {NKW_EASING_CUBIC_BEZIER,
                         {fuzz_float(f), fuzz_float(f), fuzz_float(f), fuzz_float(f)},
                         (nkw_ease_jump)fuzz_choice(f, 3),
                         fuzz_bits(f),
                         inputs,
                         outputs};
    nkw_easing_evaluate(&easing, t);
    easing.kind = NKW_EASING_STEPS;
    nkw_easing_evaluate(&easing, t);
    easing.kind = NKW_EASING_LINEAR;
    size_t count = fuzz_upto(f, STOPS);
    for (size_t i = 0; i < count; i++) {
        inputs[i] = fuzz_float(f);
        outputs[i] = fuzz_float(f);
    }
    easing.count = count;
    nkw_easing_evaluate(&easing, t);
    nkw_easing_complete(inputs, count);
    for (size_t i = 1; i < count; i++)
        FUZZ_CHECK(!fuzz_finite(inputs, count) || inputs[i - 1] <= inputs[i]);
    nkw_easing_evaluate(&easing, t);
}

static nkw_fcurve_key *draw_keys(fuzz *f, size_t count, int wild)
{
    nkw_fcurve_key *keys = fuzz_block(f, count * sizeof *keys);
    random_source r = fuzz_source(f);
    for (size_t k = 0; k < count; k++) {
        nkw_handle in = {-3.0f * random_unit(&r), random_between(&r, -4, 4)};
        nkw_handle out = {3.0f * random_unit(&r), random_between(&r, -4, 4)};
        nkw_fcurve_key key = {(k ? keys[k - 1].time : -3.0f) + random_unit(&r),
                              random_between(&r, -4, 4),
                              in,
                              out,
                              (nkw_fcurve_kind)(random_bits(&r) % 5),
                              (nkw_ease_kind)(random_bits(&r) % NKW_EASE_COUNT)};
        keys[k] = key;
        if (!wild || random_bits(&r) % 4)
            continue;
        float *number[6] = {&keys[k].time,     &keys[k].value,    &keys[k].in.time,
                            &keys[k].in.value, &keys[k].out.time, &keys[k].out.value};
        *number[random_bits(&r) % 6] = fuzz_float(f);
        keys[k].kind = (nkw_fcurve_kind)fuzz_choice(f, 4);
        keys[k].ease = (nkw_ease_kind)fuzz_choice(f, NKW_EASE_COUNT - 1);
    }
    return keys;
}

static void fcurves(fuzz *f)
{
    size_t count = fuzz_upto(f, KEYS), bad;
    nkw_fcurve_key *keys = draw_keys(f, count, fuzz_byte(f) % 2);
    nkw_fcurve c = {keys,
                    count,
                    (nkw_fcurve_outside)fuzz_choice(f, 4),
                    (nkw_fcurve_outside)fuzz_choice(f, 4),
                    fuzz_bits(f) % 4,
                    fuzz_bits(f) % 4,
                    (nkw_handle_policy)fuzz_choice(f, 3)};
    nkw_result result = nkw_fcurve_validate(&c, &bad);
    FUZZ_CHECK(result == NKW_OK || result == NKW_EMPTY || bad < count);
    const float *times = fuzz_floats(f, TIMES, 1);
    uint32_t cursor = fuzz_bits(f);
    for (size_t i = 0; i < TIMES; i++) {
        nkw_motion a = nkw_fcurve_sample(&c, times[i], NULL), b = nkw_fcurve_sample(&c, times[i], &cursor);
        FUZZ_CHECK(result != NKW_OK || fuzz_same(&a.value, &b.value, 3));
        FUZZ_CHECK(result != NKW_OK || !fuzz_finite(times + i, 1) || a.value == a.value);
    }
    nkw_fcurve_key *more = fuzz_block(f, (count + 1) * sizeof *more);
    size_t index = 0;
    if (nkw_fcurve_insert(&c, times[0], more, &index) == NKW_OK)
        FUZZ_CHECK(index > 0 && index < count);
    nkw_fcurve_limit(keys, count, NKW_HANDLE_KEEP_RATIO, keys);
    for (size_t k = 0; k + 1 < count; k++) {
        const nkw_handle_segment s = {keys[k].time,   keys[k].value,     keys[k].out,
                                      keys[k + 1].in, keys[k + 1].time, keys[k + 1].value};
        FUZZ_CHECK(!nkw_handle_runs_back(&s) || result != NKW_OK || keys[k].kind != NKW_FCURVE_BEZIER);
    }
}

static void slopes(fuzz *f, const nkw_fcurve_key *keys, size_t count)
{
    nkw_weight_unit unit = (nkw_weight_unit)fuzz_choice(f, 2);
    nkw_slope_key *slope = fuzz_block(f, count * sizeof *slope);
    nkw_fcurve_key *back = fuzz_block(f, count * sizeof *back);
    size_t bad;
    if (nkw_slope_keys_from_fcurve(keys, count, unit, slope, &bad) != NKW_OK)
        FUZZ_CHECK(count == 0 || bad < count);
    for (size_t k = 0; k < count && fuzz_byte(f) % 2; k++) {
        nkw_slope_key s = {fuzz_float(f),
                           fuzz_float(f),
                           fuzz_float(f),
                           fuzz_float(f),
                           fuzz_float(f),
                           fuzz_float(f),
                           (nkw_weighted)fuzz_choice(f, 3),
                           (nkw_fcurve_kind)fuzz_choice(f, 4)};
        slope[k] = s;
    }
    if (nkw_fcurve_from_slope_keys(slope, count, unit, back, &bad) != NKW_OK)
        FUZZ_CHECK(count == 0 || bad < count);
}

static void dialects(fuzz *f)
{
    size_t count = fuzz_upto(f, KEYS), bad, room = fuzz_upto(f, 60);
    nkw_fcurve_key *keys = draw_keys(f, count, fuzz_byte(f) % 2);
    nkw_blender_key *blender = fuzz_block(f, count * sizeof *blender);
    float css[4] = {fuzz_float(f), fuzz_float(f), fuzz_float(f), fuzz_float(f)}, error;
    slopes(f, keys, count);
    nkw_handle_types *types = fuzz_block(f, count * sizeof *types);
    for (size_t k = 0; k < count; k++) {
        types[k].in = (nkw_handle_type)fuzz_choice(f, 4);
        types[k].out = (nkw_handle_type)fuzz_choice(f, 4);
    }
    nkw_fcurve_auto_handles(keys, fuzz_byte(f) % 2 ? count : 0, types);
    if (nkw_blender_keys_from_fcurve(keys, count, blender, &bad) == NKW_OK && fuzz_byte(f) % 2)
        nkw_fcurve_from_blender_keys(blender, count, keys, &bad);
    if (count > 1) {
        nkw_fcurve_to_css(keys, css);
        nkw_fcurve_from_css(css, keys);
    }
    nkw_fcurve c[2] = {{keys, count, (nkw_fcurve_outside)fuzz_choice(f, 4), (nkw_fcurve_outside)fuzz_choice(f, 4),
                        fuzz_bits(f) % 4, fuzz_bits(f) % 4, (nkw_handle_policy)fuzz_choice(f, 3)},
                       {keys, count / 2, NKW_FCURVE_OUTSIDE_LINEAR, NKW_FCURVE_OUTSIDE_HOLD, 0, 0, NKW_HANDLE_CONTAIN}};
    size_t width = 1 + fuzz_byte(f) % 2u;
    nkw_track_span memory = {fuzz_room(f, room), fuzz_room(f, 3 * width * room), NULL, room};
    nkw_track track;
    nkw_result result = nkw_track_from_fcurves(c, width, 0.01f * (float)fuzz_byte(f), memory, &track, &error);
    FUZZ_CHECK(track.count <= room && (result == NKW_OK) == (track.count > 0));
    nkw_fcurve angles[3] = {c[0], c[1], c[fuzz_byte(f) % 2]};
    nkw_track_span rotations = {fuzz_room(f, room), fuzz_room(f, 12 * room), NULL, room};
    nkw_track turns;
    nkw_track_from_euler_fcurves(angles, (nkw_euler_order)fuzz_choice(f, 5), 0.1f, rotations, &turns, NULL);
    FUZZ_CHECK(turns.count <= room);
    for (size_t k = 1; k < track.count; k++)
        FUZZ_CHECK(track.times[k - 1] < track.times[k]);
    if (track.count > 0 && nkw_track_validate(&track, &bad) == NKW_OK)
        nkw_fcurve_from_track(&track, 0, fuzz_block(f, track.count * sizeof *keys), &bad);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    handles(&f);
    eases(&f);
    fcurves(&f);
    dialects(&f);
    return fuzz_end(&f);
}
