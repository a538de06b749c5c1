/* SPDX-License-Identifier: MIT */
/* Segments, and the play head. */
#include "fuzz.h"
#include "../support/resample.h"

enum { KEYS = 60, TIMES = 20 };

static void check_segment(nkw_segment s, size_t count)
{
    FUZZ_CHECK(s.index + 1 < count || s.index == 0);
    FUZZ_CHECK(s.t >= 0.0f && s.t <= 1.0f);
}

static int are_ascending(const float *times, size_t count)
{
    for (size_t k = 0; k < count; k++)
        if (!fuzz_finite(times + k, 1) || (k && times[k] < times[k - 1]))
            return 0;
    return 1;
}

static float *draw_times(fuzz *f, size_t count)
{
    unsigned kind = fuzz_byte(f) % 3;
    float *times = fuzz_floats(f, count, kind == 0), start = fuzz_float(f), rate = fuzz_float(f);
    for (size_t k = 0; k < count; k++)
        if (kind == 1)
            times[k] = nkw_timeline_time((nkw_timeline){start, rate, 0}, k);
        else if (kind == 2 && k)
            times[k] = times[k - 1] + (times[k] > 0.0f ? times[k] : 0.0f);
    return times;
}

static void segments(fuzz *f, const float *times, size_t count)
{
    int ascending = are_ascending(times, count);
    const float *time = fuzz_floats(f, TIMES, 1);
    nkw_segment *all = fuzz_block(f, TIMES * sizeof *all);
    nkw_segment_find_n(times, count, time, all, TIMES);
    float rate = uniform_rate(times, count);
    FUZZ_CHECK(rate >= 0.0f && rate < 1e9f);
    float even = even_rate(times, count), any = fuzz_float(f);
    FUZZ_CHECK(even >= 0.0f);
    for (size_t i = 0; i < TIMES; i++) {
        nkw_segment s = nkw_segment_find(times, count, time[i]);
        nkw_segment from = nkw_segment_find_hint(times, count, time[i], fuzz_huge(f));
        check_segment(s, count);
        check_segment(from, count);
        check_segment(all[i], count);
        if (ascending)
            FUZZ_CHECK(s.index == from.index && fuzz_same(&s.t, &from.t, 1) && s.index == all[i].index);
        nkw_segment by_rate = nkwi_segment_find_even(times, count, even > 0.0f ? even : any, time[i]);
        check_segment(by_rate, count);
        if (even > 0.0f)
            FUZZ_CHECK(s.index == by_rate.index && fuzz_same(&s.t, &by_rate.t, 1));
        if (rate <= 0.0f)
            continue;
        by_rate = nkw_timeline_find((nkw_timeline){times[0], rate, count}, time[i]);
        FUZZ_CHECK(s.index == by_rate.index && fuzz_same(&s.t, &by_rate.t, 1));
    }
    size_t huge = fuzz_huge(f);
    check_segment(nkw_timeline_find((nkw_timeline){fuzz_float(f), fuzz_float(f), huge}, fuzz_float(f)), huge);
}

static void playback(fuzz *f, const float *times, size_t count)
{
    nkw_playback mode = (nkw_playback)fuzz_choice(f, 2);
    float start = fuzz_float(f), duration = fuzz_float(f), time = fuzz_float(f);
    nkw_play_head head = nkw_playback_head(mode, start, duration, time);
    double end = (double)start + (double)duration;
    if (fuzz_finite(&start, 1) && fuzz_finite(&time, 1) && duration > 0.0f && end <= 3e38)
        FUZZ_CHECK(head.time >= start && head.time <= (float)end);
    size_t capacity = fuzz_upto(f, 300), *out = fuzz_block(f, capacity * sizeof *out);
    float from = fuzz_float(f), to = fuzz_byte(f) % 2 ? fuzz_float(f) : from + (float)fuzz_byte(f) / 16.0f;
    nkw_playback_step step = {times, count, duration, from, to, fuzz_byte(f) % 2};
    size_t passed, again;
    nkw_result result = nkw_playback_passed(&step, out, capacity, &passed);
    for (size_t i = 0; i < passed && i < capacity; i++)
        FUZZ_CHECK(out[i] < count);
    nkw_result asked = nkw_playback_passed(&step, NULL, 0, &again);
    FUZZ_CHECK(passed == again && (asked == result || (asked == NKW_TOO_SMALL && result == NKW_OK)));
    FUZZ_CHECK((result == NKW_TOO_SMALL) == (passed > capacity && result != NKW_TOO_MANY));
    FUZZ_CHECK(result == NKW_OK || result == NKW_TOO_SMALL || passed == (result == NKW_TOO_MANY ? SIZE_MAX : 0));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    size_t count = fuzz_upto(&f, KEYS);
    const float *times = draw_times(&f, count);
    segments(&f, times, count);
    playback(&f, times, count);
    return fuzz_end(&f);
}
