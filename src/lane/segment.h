/* SPDX-License-Identifier: MIT */
/* Floor 4: segment lookup over times that stand `stride` bytes apart. */
#ifndef NAKAWARI_LANE_SEGMENT_H
#define NAKAWARI_LANE_SEGMENT_H

#include "strict.h"

#include <nakawari/segment.h>

/* Key times in an array of floats or of structs that hold one. */
typedef struct lane_times {
    const char *first;
    size_t stride;
    size_t count;
} lane_times;

static inline float lane_time(lane_times times, size_t k)
{
    return *(const float *)(const void *)(times.first + k * times.stride);
}

/*
 * (time - a) / (b - a) clamped to 0..1; 1 from b on and only there: before b a quotient that rounds to 1 is the float
 * below.
 * a >= b gives 1 from b on, else 0; NaN gives 0.
 */
static inline float lane_segment_t(float a, float b, float time)
{
    double t = ((double)time - (double)a) / ((double)b - (double)a);
    float inside = t > 0.0 ? (float)t : 0.0f;
    float below = inside < 1.0f ? inside : 0x1.fffffep-1f;
    return time >= b ? 1.0f : below;
}

/*
 * The largest k in low..high-1 with time(k) <= time, or low. Whatever the times are:
 *     low < high;   low is the first, or time(low) <= time;   high is the last key, or not time(high) <= time
 */
static inline size_t lane_segment_bisect(lane_times times, float time, size_t low, size_t high)
{
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (lane_time(times, middle) <= time)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static inline nkw_segment lane_segment_at(lane_times times, float time, size_t k)
{
    nkw_segment r = {k, lane_segment_t(lane_time(times, k), lane_time(times, k + 1), time)};
    return r;
}

static inline nkw_segment lane_segment_find(lane_times times, float time)
{
    nkw_segment none = {0, 0.0f};
    if (times.count < 2)
        return none;
    return lane_segment_at(times, time, lane_segment_bisect(times, time, 0, times.count - 1));
}

/* Doubling steps away from `from` until the time is enclosed, then bisection between. */
static inline nkw_segment lane_segment_find_from(lane_times times, float time, size_t from)
{
    nkw_segment none = {0, 0.0f};
    if (times.count < 2)
        return none;
    size_t last = times.count - 1;
    size_t low = from < last ? from : last - 1, high = low + 1, step = 1;
    if (lane_time(times, low) <= time) {
        while (high < last && lane_time(times, high) <= time) {
            low = high;
            high = last - high > step ? high + step : last;
            step += step;
        }
    } else {
        while (low > 0 && !(lane_time(times, low) <= time)) {
            high = low;
            low = low > step ? low - step : 0;
            step += step;
        }
    }
    return lane_segment_at(times, time, lane_segment_bisect(times, time, low, high));
}

#endif
