/* SPDX-License-Identifier: MIT */
/* Resampling and comparing of tracks in arrays that are known to be large enough, for tests. */
#ifndef NAKAWARI_TESTS_RESAMPLE_H
#define NAKAWARI_TESTS_RESAMPLE_H

#include <nakawari/track.h>

#ifdef __cplusplus
extern "C" {
#endif
#include "../../src/curve/segment_even.h"
#ifdef __cplusplus
}
#endif

static inline float track_difference(const nkw_track *t, const nkw_track *other, nkw_work work)
{
    float difference;
    nkw_result result = nkw_track_difference(t, other, &difference, work);
    return result == NKW_OK || difference > 3e38f ? difference : -1.0f;
}

/* The difference from the source; infinity after an error. */
static inline float resample(const nkw_track *t, float rate, float *times, float *values, nkw_work work, nkw_track *out)
{
    const nkw_track_span span = {times, values, NULL, (size_t)-1};
    const nkw_track source = *t;
    size_t count;
    nkw_result result = nkw_track_resample(t, rate, span, out, &count);
    if (count != out->count || (result == NKW_OK) != (count > 0))
        return -1.0f;
    return track_difference(&source, out, work);
}

/* The rate; 0 after an error. */
static inline float resample_within(const nkw_track *t, float tolerance, float *times, float *values, nkw_work work,
                                    nkw_track *out)
{
    const nkw_track_span span = {times, values, NULL, t->count};
    float rate;
    nkw_result result = nkw_track_resample_within(t, tolerance, span, out, &rate, work);
    return (result == NKW_OK) == (rate > 0.0f) ? rate : -1.0f;
}

/* 0 after an error. */
static inline size_t resample_count(const nkw_track *t, float rate)
{
    const nkw_track_span none = {NULL, NULL, NULL, 0};
    nkw_track out;
    size_t count;
    nkw_result result = nkw_track_resample(t, rate, none, &out, &count);
    return (result == NKW_TOO_SMALL) == (count > 0) && out.count == 0 ? count : (size_t)-1;
}

/* 0 after an error. */
static inline float uniform_rate(const float *times, size_t count)
{
    nkw_timeline line;
    nkw_result result = nkw_timeline_from_times(times, count, &line);
    int whole =
        result == NKW_OK ? line.start == times[0] && line.count == count : line.start == 0.0f && line.count == 0;
    return (result == NKW_OK) == (line.rate > 0.0f) && whole ? line.rate : -1.0f;
}

/* 0 after an error. */
static inline float even_rate(const float *times, size_t count)
{
    float rate;
    nkw_result result = nkwi_segment_even_rate(times, count, &rate);
    return (result == NKW_OK) == (rate > 0.0f) ? rate : -1.0f;
}

#endif
