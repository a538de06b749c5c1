/* SPDX-License-Identifier: MIT */
/* Paths of any control values: every call ends, and writes within its arrays. */
#include "fuzz.h"

#include <string.h>

enum { SEGMENTS = 4, STEPS = 3, POINTS = 64 };

static nkw_vec3 draw_vec3(fuzz *f)
{
    nkw_vec3 v = {fuzz_float(f), fuzz_float(f), fuzz_float(f)};
    return v;
}

static void places(fuzz *f, const nkw_polycurve *curve, size_t steps)
{
    size_t count = NKW_POLYCURVE_LENGTHS(curve->count, steps);
    float *lengths = fuzz_floats(f, count, 1);
    nkw_result result = nkw_polycurve_measure(curve, steps, lengths, count - (fuzz_byte(f) % 8 == 0));
    for (size_t i = 1; i < count && result == NKW_OK; i++)
        FUZZ_CHECK(lengths[i] >= lengths[i - 1]);
    for (int i = 0; i < 3; i++) {
        nkw_segment at =
            nkw_polycurve_at_length(curve, lengths, NKW_POLYCURVE_LENGTHS(curve->count, steps), fuzz_float(f));
        FUZZ_CHECK((at.index < curve->count || at.index == 0) && at.t >= 0.0f && at.t <= 1.0f);
        nkw_vec3_motion p = nkw_polycurve_evaluate(curve, at);
        nkw_curve_frame frame = nkw_curve_frame_frenet(&p, draw_vec3(f));
        nkw_polycurve_frenet(curve, at, draw_vec3(f));
        nkw_curve_frame_transport(&frame, p.value, draw_vec3(f), draw_vec3(f));
    }
}

static void frames(fuzz *f, const nkw_polycurve *curve, size_t steps)
{
    size_t count = NKW_POLYCURVE_LENGTHS(curve->count, steps) - (fuzz_byte(f) % 8 == 0);
    nkw_curve_frame *out = fuzz_block(f, count * sizeof *out);
    nkw_polycurve_frames(curve, steps, draw_vec3(f), (nkw_polycurve_ends)fuzz_choice(f, 1), out, count);
}

static void polyline(fuzz *f, const nkw_polycurve *curve, int wild)
{
    size_t capacity = fuzz_upto(f, POINTS), count;
    nkw_vec3 *out = fuzz_block(f, capacity * sizeof *out);
    float tolerance = wild ? fuzz_float(f) : 0.001f + 0.01f * (float)fuzz_byte(f);
    nkw_result result = nkw_polycurve_flatten(curve, tolerance, out, capacity, &count);
    FUZZ_CHECK(result != NKW_OK || count <= capacity);
    FUZZ_CHECK(result != NKW_TOO_SMALL || count > capacity);
    FUZZ_CHECK(wild || result == NKW_OK || result == NKW_TOO_SMALL || result == NKW_EMPTY);
    FUZZ_CHECK(result != NKW_OK || fuzz_finite(&out[0].x, 3 * count));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    int wild = fuzz_byte(&f) % 2;
    size_t count = fuzz_upto(&f, SEGMENTS), steps = fuzz_upto(&f, STEPS);
    nkw_vec3_cubic *cubics = fuzz_block(&f, count * sizeof *cubics);
    const float *numbers = fuzz_floats(&f, 12 * count, wild);
    memcpy(cubics, numbers, count * sizeof *cubics);
    nkw_polycurve curve = {cubics, count, (nkw_cubic_kind)fuzz_choice(&f, 3)};
    places(&f, &curve, steps);
    frames(&f, &curve, steps);
    polyline(&f, &curve, wild);
    if (count > 0)
        nkw_vec3_cubic_length(cubics, fuzz_float(&f), fuzz_float(&f), curve.kind);
    return fuzz_end(&f);
}
