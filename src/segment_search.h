/* SPDX-License-Identifier: MIT */
/* Floor 4: segment lookup in key times at a distance of `stride` bytes. */
#ifndef NAKAWARI_SEGMENT_SEARCH_H
#define NAKAWARI_SEGMENT_SEARCH_H

#include "lane/strict.h"

#include <nakawari/segment.h>

/* Key times in an array of floats, or of structs with a time. */
typedef struct segment_times {
    const char *first;
    size_t stride;
    size_t count;
} segment_times;

static inline segment_times segment_times_of(const float *times, size_t count)
{
    segment_times r = {(const char *)times, sizeof *times, count};
    return r;
}

static inline float segment_time(segment_times times, size_t k)
{
    return *(const float *)(const void *)(times.first + k * times.stride);
}

/*
 * t = (time - a) / (b - a), clamped to 0..1.
 *
 * t is 1 if and only if time >= b: for time < b, a quotient that rounds to 1 becomes the largest float below 1.
 * If a >= b, t is 1 for time >= b, otherwise 0. NaN returns 0.
 */
static inline float segment_t(float a, float b, float time)
{
    float t = (float)(((double)time - (double)a) / ((double)b - (double)a));
    float inside = t > 0.0f ? t : 0.0f;
    float below = inside < 0x1.fffffep-1f ? inside : 0x1.fffffep-1f;
    return time >= b ? 1.0f : below;
}

/* The number of keys k + step, k + 2 step and k + 3 step whose time is <= time. */
static inline size_t segment_passed(segment_times times, float time, size_t k, size_t step)
{
    size_t one = segment_time(times, k + step) <= time, two = segment_time(times, k + 2 * step) <= time;
    size_t three = segment_time(times, k + 3 * step) <= time;
    return one + two + three;
}

/*
 * The last of the keys k..k + n - 1 whose time is <= time; k if there is none.
 *
 * Each iteration reduces n to about a quarter. The comparisons are added, not branched on, and the number of iterations
 * depends on n only: no branch is mispredicted when times are random. The result is in k..k + n - 1 for any times, also
 * for times that do not ascend.
 */
static inline size_t segment_search(segment_times times, float time, size_t k, size_t n)
{
    while (n > 3) {
        size_t quarter = n / 4;
        k += quarter * segment_passed(times, time, k, quarter);
        n -= 3 * quarter;
    }
    size_t one = n > 1 && segment_time(times, k + 1) <= time, two = n > 2 && segment_time(times, k + 2) <= time;
    return k + one + two;
}

static inline nkw_segment segment_at(segment_times times, float time, size_t k)
{
    nkw_segment r = {k, segment_t(segment_time(times, k), segment_time(times, k + 1), time)};
    return r;
}

static inline nkw_segment segment_find(segment_times times, float time)
{
    nkw_segment none = {0, 0.0f};
    if (times.count < 2)
        return none;
    return segment_at(times, time, segment_search(times, time, 0, times.count - 1));
}

/*
 * Searches from `hint` on: steps of 1, 1, 4, 16, ... keys forwards or backwards until an interval contains the time,
 * then segment_search in that interval. O(log d) for d keys between the hint and the result.
 */
static inline nkw_segment segment_find_hint(segment_times times, float time, size_t hint)
{
    nkw_segment none = {0, 0.0f};
    if (times.count < 2)
        return none;
    size_t last = times.count - 1;
    size_t k = hint < last ? hint : last - 1, n = 1, step = 1;
    if (segment_time(times, k) <= time) {
        for (; n < last - k && segment_time(times, k + n) <= time; step *= 4) {
            k += n;
            n = step;
        }
        n = n < last - k ? n : last - k;
    } else {
        for (; n < k && !(segment_time(times, k - n) <= time); step *= 4) {
            k -= n;
            n = step;
        }
        n = n < k ? n : k;
        k -= n;
    }
    return segment_at(times, time, n > 1 ? segment_search(times, time, k, n) : k);
}

/*
 * The key at an even rate that is nearest to the time, 0..last. It does not decrease with the time, because rounding is
 * monotonic. So if it is k for each times[k], it is k or k + 1 for times[k] <= time < times[k + 1].
 */
static inline size_t segment_even_key(float start, float rate, size_t last, float time)
{
    float x = (time - start) * rate + 0.5f, from = x >= 1.0f ? x : 0.0f;
    size_t k = (uint32_t)(from < 0x1p31f ? from : 0x1p31f);
    return k < last ? k : last;
}

/* Times with an even rate: those for which the nearest key of each key is that key itself. */
static inline int segment_is_even(const float *times, size_t count, float rate)
{
    int is_even = count > 1;
    for (size_t k = 0; k < count && is_even; k++)
        is_even = segment_even_key(times[0], rate, count - 1, times[k]) == k;
    return is_even;
}

#endif
