/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/curve.h>
#include <nakawari/quat.h>
#include <nakawari/track.h>

#include "curve/segment_search.h"
#include "difference.h"
#include "finite.h"
#include "lane/scalar.h"
#include "pack/slerp.h"
#include "report.h"
#include "track_keys.h"
#include "work.h"

size_t nkw_track_value_count(const nkw_track *track)
{
    size_t most = SIZE_MAX / (track_is_cubic(track) ? 3 : 1);
    if (track->count == 0 || track->width == 0)
        return 0;
    return track->count <= most / track->width ? track->count * track_key_size(track) : SIZE_MAX;
}

static nkw_quat rotation_at(const nkw_track *track, size_t k)
{
    nkw_quat q = track_read_quat(track_value_at(track, k));
    return track->kind == NKW_TRACK_ROTATION_NORMALIZED ? nkw_quat_normalize(q) : q;
}

static void hold(const nkw_track *track, size_t k, float *out)
{
    const float *v = track_value_at(track, k);
    if (track_is_rotation(track))
        track_write_quat(rotation_at(track, k), out);
    else
        for (size_t i = 0; i < track->width; i++)
            out[i] = v[i];
}

/*
 * t other than 0 and 1. Interpolates from the nearer key, a or b. It is selected by arithmetic: a branch on t would be
 * mispredicted.
 */
static void lerp(const float *a, const float *b, float t, float *out, size_t n)
{
    size_t last = t < 0.5f ? 0u : 1u;
    const float *nearer = a + last * (size_t)(b - a);
    float x = t - (float)last;
    for (size_t i = 0; i < n; i++)
        out[i] = lane_lerp_from(nearer[i], x, a[i], b[i]);
}

static void linear(const nkw_track *track, size_t k, float t, float *out)
{
    if (track_is_rotation(track))
        track_write_quat(quat_slerp_keys(rotation_at(track, k), rotation_at(track, k + 1), t), out);
    else
        lerp(track_value_at(track, k), track_value_at(track, k + 1), t, out, track->width);
}

/* Tangents are per second. Times the duration of the segment they are per segment. */
static void cubic(const nkw_track *track, size_t k, float t, float *out)
{
    const float *a = track_value_at(track, k), *b = track_value_at(track, k + 1);
    const float *leaving = a + track->width, *arriving = b - track->width;
    float duration = track->times[k + 1] - track->times[k];
    for (size_t i = 0; i < track->width; i++)
        out[i] = nkw_hermite(a[i], duration * leaving[i], b[i], duration * arriving[i], t);
    if (track_is_rotation(track))
        track_write_quat(nkw_quat_normalize(track_read_quat(out)), out);
}

nkw_result nkw_track_sample_segment(const nkw_track *track, nkw_segment segment, float *out)
{
    if (!track_is_readable(track))
        return track_check_readable(track);
    size_t last = track->count - 1;
    size_t k = segment.index < last ? segment.index : last;
    float t = segment.t > 0.0f ? segment.t : 0.0f;
    if (k == last || t == 0.0f)
        hold(track, k, out);
    else if (t >= 1.0f)
        hold(track, k + 1, out);
    else if (track_interpolation_at(track, k) == NKW_INTERPOLATION_CUBICSPLINE && track_is_cubic(track))
        cubic(track, k, t, out);
    else if (track_interpolation_at(track, k) == NKW_INTERPOLATION_LINEAR)
        linear(track, k, t, out);
    else
        hold(track, k, out);
    return NKW_OK;
}

nkw_result nkw_track_sample(const nkw_track *track, float time, uint32_t *cursor, float *out)
{
    if (!cursor)
        return nkw_track_sample_segment(track, nkw_segment_find(track->times, track->count, time), out);
    nkw_segment segment = segment_find_hint(segment_times_of(track->times, track->count), time, *cursor);
    *cursor = (uint32_t)segment.index;
    return nkw_track_sample_segment(track, segment, out);
}

static nkw_result check_shape(const nkw_track *track)
{
    if ((unsigned)track->kind > NKW_TRACK_ROTATION_NORMALIZED ||
        (unsigned)track->interpolation > NKW_INTERPOLATION_CUBICSPLINE)
        return NKW_BAD_METHOD;
    nkw_result result = track_check_readable(track);
    if (result != NKW_OK)
        return result;
    return nkw_track_value_count(track) <= SIZE_MAX / sizeof(float) ? NKW_OK : NKW_TOO_SMALL;
}

static nkw_result check_key(const nkw_track *track, size_t k)
{
    unsigned most = track_is_cubic(track) ? NKW_INTERPOLATION_CUBICSPLINE : NKW_INTERPOLATION_STEP;
    if (track->key_interpolation && track->key_interpolation[k] > most)
        return NKW_BAD_METHOD;
    if (!lane_is_finite(track->times[k]) || !are_finite(track_key_at(track, k), track_key_size(track)))
        return NKW_NOT_FINITE;
    if (k > 0 && track->times[k] < track->times[k - 1])
        return NKW_NOT_ASCENDING;
    float length = track_is_rotation(track) ? nkw_quat_length(track_read_quat(track_value_at(track, k))) : 1.0f;
    return lane_is_unit_length(length) ? NKW_OK : NKW_NOT_UNIT;
}

nkw_result nkw_track_validate(const nkw_track *track, size_t *bad)
{
    nkw_result result = check_shape(track);
    size_t offender = 0;
    for (size_t k = 0; result == NKW_OK && k < track->count; k++) {
        result = check_key(track, k);
        offender = k;
    }
    if (result == NKW_OK && bad)
        *bad = nkwi_track_long_way(track);
    return result == NKW_OK ? NKW_OK : report(result, offender, bad);
}

/* Resampling. */

#define TRACK_MOST_STEPS 0x7fffffffu

/* The least k with start + k / rate >= end; at most TRACK_MOST_STEPS. By bisection. */
static size_t steps_until(float start, float rate, float end)
{
    size_t low = 0, high = TRACK_MOST_STEPS;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (nkw_timeline_time((nkw_timeline){start, rate, 0}, middle) < end)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* The number of keys; 0 after an error. */
static nkw_result count_keys(const nkw_track *track, float rate, size_t *count)
{
    nkw_result result = track_check_readable(track);
    *count = 0;
    if (result != NKW_OK)
        return result;
    if (!(rate > 0.0f) || !lane_is_finite(rate))
        return NKW_OUT_OF_RANGE;
    float first = track->times[0], last = track->times[track->count - 1];
    size_t steps = steps_until(first, rate, last);
    if (!lane_is_finite(last) || !lane_is_finite(nkw_timeline_time((nkw_timeline){first, rate, 0}, steps)))
        return NKW_NOT_FINITE;
    if (steps >= TRACK_MOST_STEPS)
        return NKW_TOO_MANY;
    *count = steps + 1;
    return NKW_OK;
}

/* Whether all segments are STEP. */
static int is_step(const nkw_track *track)
{
    for (size_t k = 0; track->key_interpolation && k + 1 < track->count; k++)
        if (track->key_interpolation[k] != NKW_INTERPOLATION_STEP)
            return 0;
    return track->key_interpolation || track->interpolation == NKW_INTERPOLATION_STEP;
}

/* Samples of normalised rotations are unit, so the resampled track is not normalised again. */
static nkw_track resampled(const nkw_track *track, const float *times, const float *values, size_t count)
{
    nkw_track r = {times, values, count, track->width, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL};
    r.kind = track_is_rotation(track) ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
    r.interpolation = is_step(track) ? NKW_INTERPOLATION_STEP : NKW_INTERPOLATION_LINEAR;
    return r;
}

/* The largest difference at the keys of `along` and at the quarters between them, while `track` has keys. */
static float difference_along(const nkw_track *along, const nkw_track *track, const nkw_track *other, nkw_work work)
{
    uint32_t here = 0, there = 0;
    float *a = (float *)work.data, *b = a + track->width, largest = 0.0f;
    for (size_t k = 0; k < along->count; k++)
        for (int quarter = 0; quarter < DIFFERENCE_QUARTERS; quarter++) {
            float time = difference_time(along, k, quarter);
            if (time < track->times[0] || time > track->times[track->count - 1])
                continue;
            nkw_track_sample(track, time, &here, a);
            nkw_track_sample(other, time, &there, b);
            largest = difference_worse(largest, track_is_rotation(track)
                                                    ? nkw_quat_angle(track_read_quat(a), track_read_quat(b))
                                                    : difference_largest(a, b, track->width));
        }
    return largest;
}

static int has_work(const nkw_track *track, nkw_work work)
{
    return work_fits_each(work, track->width, NKW_TRACK_WORK(1));
}

static float difference_of(const nkw_track *track, const nkw_track *other, nkw_work work)
{
    return difference_worse(difference_along(track, track, other, work), difference_along(other, track, other, work));
}

nkw_result nkw_track_difference(const nkw_track *track, const nkw_track *other, float *difference, nkw_work work)
{
    nkw_result result = track_check_readable(track);
    *difference = INFINITY;
    if (result == NKW_OK)
        result = track_check_readable(other);
    if (result != NKW_OK)
        return result;
    if (track->width != other->width || track_is_rotation(track) != track_is_rotation(other))
        return NKW_MISMATCHED;
    if (!has_work(track, work))
        return NKW_TOO_SMALL;
    *difference = difference_of(track, other, work);
    return NKW_OK;
}

/* Samples `count` keys from the time of the first key on. */
static void resample(const nkw_track *track, float rate, nkw_track_span span, size_t count, nkw_track *out)
{
    uint32_t cursor = 0;
    for (size_t k = 0; k < count; k++) {
        span.times[k] = nkw_timeline_time((nkw_timeline){track->times[0], rate, 0}, k);
        nkw_track_sample(track, span.times[k], &cursor, span.values + k * track->width);
    }
    *out = resampled(track, span.times, span.values, count);
}

nkw_result nkw_track_resample(const nkw_track *track, float rate, nkw_track_span span, nkw_track *out, size_t *count)
{
    const nkw_track source = *track;
    size_t keys;
    nkw_result result = count_keys(&source, rate, &keys);
    if (count)
        *count = keys;
    if (result == NKW_OK && (!span.times || span.key_capacity < keys))
        result = NKW_TOO_SMALL;
    resample(&source, rate, span, result == NKW_OK ? keys : 0, out);
    return result;
}

/*
 * The rate with `segments` segments from the first key to the last: the mean rate times segments / (count - 1).
 * Decreased by ULPs until the last time is not before the last key. 1 without a duration; 0 if the mean rate overflows.
 */
static float rate_over(const nkw_track *track, size_t segments)
{
    float first = track->times[0], last = track->times[track->count - 1];
    if (track->count < 2 || !(first < last))
        return 1.0f;
    nkw_timeline even;
    double all = (double)(track->count - 1);
    int is_even = nkw_timeline_from_times(track->times, track->count, &even) == NKW_OK;
    double mean = is_even ? (double)even.rate : all / ((double)last - (double)first);
    if (!(mean <= (double)FLT_MAX))
        return 0.0f;
    float rate = (float)(mean * ((double)segments / all));
    while (nkw_timeline_time((nkw_timeline){first, rate, 0}, segments) < last)
        rate = lane_float(lane_bits(rate) - 1);
    return rate;
}

/*
 * Tries rates in ascending order: (count - 1) / parts segments, rounded up, for parts = 2^n, ..., 4, 2, 1. Returns the
 * first whose error is at most the tolerance; 0 if there is none.
 */
static float lowest_rate(const nkw_track *track, float tolerance, nkw_track_span span, nkw_track *out, nkw_work work)
{
    size_t segments = track->count - 1, parts = 1;
    while (parts < segments)
        parts *= 2;
    for (; parts > 0; parts /= 2) {
        float rate = rate_over(track, (segments + parts - 1) / parts);
        if (nkw_track_resample(track, rate, span, out, NULL) == NKW_OK && difference_of(track, out, work) <= tolerance)
            return rate;
    }
    return 0.0f;
}

nkw_result nkw_track_resample_within(const nkw_track *track, float tolerance, nkw_track_span span, nkw_track *out,
                                     float *rate, nkw_work work)
{
    const nkw_track source = *track;
    nkw_result result = track_check_readable(&source);
    if (result == NKW_OK && !(tolerance >= 0.0f))
        result = NKW_OUT_OF_RANGE;
    if (result == NKW_OK && (span.key_capacity < source.count || !has_work(&source, work)))
        result = NKW_TOO_SMALL;
    *rate = result == NKW_OK ? lowest_rate(&source, tolerance, span, out, work) : 0.0f;
    if (result == NKW_OK && *rate == 0.0f)
        result = NKW_NO_RATE;
    if (result != NKW_OK)
        *out = resampled(&source, span.times, span.values, 0);
    return result;
}
