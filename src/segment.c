/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <stdint.h>

#include <nakawari/segment.h>

#include "lane/scalar.h"
#include "lane/segment.h"

static lane_times times_of(const float *times, size_t count)
{
    lane_times r = {(const char *)times, sizeof *times, count};
    return r;
}

nkw_segment nkw_segment_find(const float *times, size_t count, float time)
{
    return lane_segment_find(times_of(times, count), time);
}

nkw_segment nkw_segment_find_from(const float *times, size_t count, float time, size_t from)
{
    return lane_segment_find_from(times_of(times, count), time, from);
}

void nkw_segment_find_n(const float *times, size_t count, const float *time, nkw_segment *out, size_t n)
{
    lane_times all = times_of(times, count);
    size_t from = 0;
    for (size_t i = 0; i < n; i++) {
        out[i] = lane_segment_find_from(all, time[i], from);
        from = out[i].index;
    }
}

float nkw_segment_uniform_time(float start, float rate, size_t k)
{
    return (float)((double)start + (double)k / (double)rate);
}

/* Whether the times are those of nkw_segment_uniform_time, each greater than the one before. */
static int is_uniform(const float *times, size_t count, float rate)
{
    for (size_t k = 0; k < count; k++)
        if (nkw_segment_uniform_time(times[0], rate, k) != times[k] || (k > 0 && !(times[k - 1] < times[k])))
            return 0;
    return rate > 0.0f;
}

/* The middle of the rates with which times[k] is within half an ULP of times[0] + k / rate, for every k. */
static double middle_rate(const float *times, size_t count)
{
    double low = 0.0, high = DBL_MAX; /* of 1 / rate */
    for (size_t k = 1; k < count; k++) {
        double half = (double)lane_float(lane_bits(times[k]) & 0x7f800000u) * 0x1p-24;
        double way = (double)times[k] - (double)times[0], steps = (double)k;
        low = (way - half) / steps > low ? (way - half) / steps : low;
        high = (way + half) / steps < high ? (way + half) / steps : high;
    }
    return 1.0 / (0.5 * low + 0.5 * high);
}

float nkw_segment_uniform_rate(const float *times, size_t count)
{
    double rate = count > 1 ? middle_rate(times, count) : 0.0;
    if (!(rate > 0.0 && rate < 1e9))
        return 0.0f;
    float whole = (float)(uint32_t)(rate + 0.5);
    if (is_uniform(times, count, whole))
        return whole;
    return is_uniform(times, count, (float)rate) ? (float)rate : 0.0f;
}

/* floor(x) held within 0..last, for any x. */
static size_t index_within(double x, size_t last)
{
    size_t k = x > 0.0 && x < (double)last ? (size_t)x : 0;
    return x < (double)last && k < last ? k : x > 0.0 ? last : 0;
}

nkw_segment nkw_segment_find_uniform(float start, float rate, size_t count, float time)
{
    nkw_segment none = {0, 0.0f};
    if (count < 2 || !(rate > 0.0f) || rate - rate != 0.0f)
        return none;
    size_t last = count - 2;
    size_t k = index_within(((double)time - (double)start) * (double)rate, last);
    /* The key times are rounded, so a time within half an ULP of a key can be one segment off. */
    if (k > 0 && time < nkw_segment_uniform_time(start, rate, k))
        k--;
    else if (k < last && time >= nkw_segment_uniform_time(start, rate, k + 1))
        k++;
    float a = nkw_segment_uniform_time(start, rate, k);
    float b = nkw_segment_uniform_time(start, rate, k + 1);
    nkw_segment r = {k, lane_segment_t(a, b, time)};
    return r;
}
