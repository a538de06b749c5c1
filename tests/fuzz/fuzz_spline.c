/* SPDX-License-Identifier: MIT */
/* Splines of any keys: refused, or finite tangents and a sound track; nothing outside of the arrays. */
#include "fuzz.h"

enum { KEYS = 24, WIDTH = 4 };

/* Any keys, or keys that ascend, now and then with a jump. */
static nkw_spline draw(fuzz *f)
{
    int wild = fuzz_byte(f) % 4 == 0;
    nkw_spline s = {NULL, NULL, fuzz_upto(f, KEYS), fuzz_upto(f, WIDTH), 0, NKW_SPLINE_C2, NKW_SPLINE_ENDS_FREE, 0,
                    NULL, NULL};
    s.stride = s.width + fuzz_upto(f, 2);
    float *times = fuzz_floats(f, s.count, wild);
    for (size_t k = 1; k < s.count && !wild; k++)
        times[k] = times[k - 1] + (times[k] > -2.0f ? times[k] * times[k] : 0.0f);
    s.times = times;
    s.values = fuzz_floats(f, s.count * s.stride, wild);
    s.method = (nkw_spline_method)fuzz_choice(f, NKW_SPLINE_C2);
    s.ends = (nkw_spline_ends)fuzz_choice(f, NKW_SPLINE_ENDS_PERIODIC);
    s.tension = fuzz_float(f);
    s.tcb = fuzz_byte(f) % 2 ? (const nkw_tcb *)(const void *)fuzz_floats(f, 3 * s.count, wild) : NULL;
    s.end_tangents = fuzz_byte(f) % 2 ? fuzz_floats(f, 2 * s.width, wild) : NULL;
    return s;
}

static void sample(fuzz *f, const nkw_track *track)
{
    float *at = fuzz_room(f, 3 * track->width), *plain = fuzz_room(f, track->width), time = fuzz_float(f);
    const nkw_motion_span out = {at, at + track->width, at + 2 * track->width};
    nkw_result result = nkw_track_sample_motion(track, time, out);
    nkw_track_sample(track, time, NULL, plain);
    FUZZ_CHECK(result == (track->count && track->width ? NKW_OK : NKW_EMPTY));
    FUZZ_CHECK(result != NKW_OK || fuzz_same(at, plain, track->width));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    const nkw_spline s = draw(&f);
    size_t bad, bytes = NKW_SPLINE_WORK(s.count) - (fuzz_byte(&f) % 16 == 0 && s.count);
    size_t floats = 3 * s.width * s.count;
    const nkw_work work = {fuzz_block(&f, bytes), bytes};
    float *triples = fuzz_floats(&f, floats, 1), *knots = fuzz_room(&f, s.count);
    nkw_tangent_span to = {triples, triples + 2 * s.width, 3 * s.width};
    nkw_result result = nkw_spline_tangents(&s, to, &bad, work);
    FUZZ_CHECK(bad < s.count || bad == 0);
    for (size_t k = 0; k < s.count && result == NKW_OK; k++) {
        FUZZ_CHECK(fuzz_finite(to.in + k * to.stride, s.width) && fuzz_finite(to.out + k * to.stride, s.width));
        for (size_t c = 0; c < s.width; c++)
            triples[(3 * k + 1) * s.width + c] = s.values[k * s.stride + c];
    }
    nkw_track track = {s.times, triples, s.count, s.width, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE, NULL};
    FUZZ_CHECK(result != NKW_OK || nkw_track_validate(&track, NULL) == NKW_OK);
    for (int i = 0; i < 4; i++)
        sample(&f, &track);
    nkw_spline_knots(&s, fuzz_float(&f), knots);
    return fuzz_end(&f);
}
