/* SPDX-License-Identifier: MIT */
/* Resampling and comparing of tracks in arrays that are known to be large enough, for tests. */
#ifndef NAKAWARI_TESTS_RESAMPLE_H
#define NAKAWARI_TESTS_RESAMPLE_H

#include <nakawari/track.h>

/* The difference from the source. */
static inline float resample(const nkw_track *t, float rate, float *times, float *values, float *work, nkw_track *out)
{
    nkw_track_memory memory = {times, values, (size_t)-1, work, NKW_TRACK_WORK(t->width)};
    float difference;
    nkw_result result = nkw_track_resample(t, rate, &memory, out, &difference);
    return result == NKW_OK || out->count == 0 ? difference : -1.0f;
}

/* The rate; 0 after an error. */
static inline float resample_within(const nkw_track *t, float tolerance, float *times, float *values, float *work,
                                    nkw_track *out)
{
    nkw_track_memory memory = {times, values, t->count, work, NKW_TRACK_WORK(t->width)};
    float rate;
    nkw_result result = nkw_track_resample_within(t, tolerance, &memory, out, &rate);
    return (result == NKW_OK) == (rate > 0.0f) ? rate : -1.0f;
}

static inline float track_difference(const nkw_track *t, const nkw_track *other, float *work)
{
    float difference;
    nkw_result result = nkw_track_difference(t, other, &difference, work, NKW_TRACK_WORK(t->width));
    return result == NKW_OK || difference > 3e38f ? difference : -1.0f;
}

/* 0 after an error. */
static inline size_t resample_count(const nkw_track *t, float rate)
{
    size_t count;
    nkw_result result = nkw_track_resample_count(t, rate, &count);
    return (result == NKW_OK) == (count > 0) ? count : (size_t)-1;
}

/* 0 after an error. */
static inline float uniform_rate(const float *times, size_t count)
{
    float rate;
    nkw_result result = nkw_segment_uniform_rate(times, count, &rate);
    return (result == NKW_OK) == (rate > 0.0f) ? rate : -1.0f;
}

/* 0 after an error. */
static inline float even_rate(const float *times, size_t count)
{
    float rate;
    nkw_result result = nkw_segment_even_rate(times, count, &rate);
    return (result == NKW_OK) == (rate > 0.0f) ? rate : -1.0f;
}

#endif
