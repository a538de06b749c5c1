/* SPDX-License-Identifier: MIT */
/* Segment lookup in key times at a distance of `stride` bytes. */
#ifndef NAKAWARI_SEGMENT_SEARCH_H
#define NAKAWARI_SEGMENT_SEARCH_H

#include "lane/strict.h"

#include <stdint.h>

#include <nakawari/segment.h>

#include "batch/isa.h"
#include "sizes.h"

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
 * In binary64: differences in binary32 take 0.3 to 2 ns less, and make t wrong by 3 u where a and b differ by more than
 * a factor of 2.
 *
 * t is 1 if and only if time >= b: for time < b, a quotient that rounds to 1 becomes the largest float below 1.
 * If a >= b, t is 1 for time >= b, otherwise 0. NaN returns 0.
 */
static inline float segment_t(float a, float b, float time)
{
    if (!(a < b))
        return time >= b ? 1.0f : 0.0f;
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

/* The same of the keys k, k + 1 ... k + SEGMENT_WINDOW - 1. A constant number, for vectors. */
static inline size_t segment_passed_window(segment_times times, float time, size_t k)
{
    int32_t passed = 0;
    NKW_KEEP_LOOP
    for (size_t i = 0; i < SEGMENT_WINDOW; i++)
        passed += segment_time(times, k + i) <= time;
    return (size_t)passed;
}

/*
 * The last key, of all but the last, whose time is <= time; 0 if there is none. count >= 2. Of n keys from k on:
 *
 *     n > SEGMENT_WINDOW^2      each iteration reduces n to about a quarter
 *     n > SEGMENT_WINDOW        every SEGMENT_WINDOW-th key is compared, then as many neighbours
 *     otherwise                 all are compared
 *
 * The comparisons are added, not branched on, and their number depends on n only: no branch is mispredicted when times
 * are random. The result is in 0..count - 2 for any times, also for times that do not ascend.
 */
static inline size_t segment_search(segment_times times, float time)
{
    size_t k = 0, n = times.count - 1, passed = 0;
    while (n > SEGMENT_WINDOW * SEGMENT_WINDOW) {
        size_t quarter = n / 4;
        k += quarter * segment_passed(times, time, k, quarter);
        n -= 3 * quarter;
    }
    if (n <= SEGMENT_WINDOW) {
        for (size_t i = 1; i < n; i++)
            passed += segment_time(times, k + i) <= time;
        return k + passed;
    }
    for (size_t i = SEGMENT_WINDOW; i < n; i += SEGMENT_WINDOW)
        passed += segment_time(times, k + i) <= time;
    size_t from = SEGMENT_WINDOW * passed, last = n - SEGMENT_WINDOW;
    k += from < last ? from : last;
    passed = segment_passed_window(times, time, k);
    return passed > 0 ? k + passed - 1 : k;
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
    return segment_at(times, time, segment_search(times, time));
}

/*
 * Whether the time is in the segment `hint`, the next or the one before; *k receives which. These are branched on, so
 * that the processor need not wait for the result of the search before: it predicts that the segment is the same.
 */
static inline int segment_is_near(segment_times times, float time, size_t hint, size_t *k)
{
    size_t last = times.count - 2, at = hint < last ? hint : last;
    if (!(segment_time(times, at) <= time)) {
        *k = at - (at > 0);
        return at <= 1 || segment_time(times, *k) <= time;
    }
    *k = at;
    if (at == last || time < segment_time(times, at + 1))
        return 1;
    *k = at + 1;
    return *k == last || time < segment_time(times, *k + 1);
}

/*
 * Moves *k to the segment of the time if this is the one before, the segment itself or one of the next two: whether it
 * is one of them is branched on, which of them is not. At least SEGMENT_NEAR_KEYS keys.
 *
 *     keys       low = *k - 1     low + 1      low + 2      low + 3      low + 4
 *     segment    low if none of the keys between has passed; + 1 of each that has
 */
static inline int segment_walk_to(segment_times times, float time, size_t *k)
{
    const size_t most = times.count - SEGMENT_NEAR_KEYS, before = *k - (*k > 0), low = before < most ? before : most;
    const int is_after = low == 0 || segment_time(times, low) <= time;
    const int is_before = low == most || time < segment_time(times, low + SEGMENT_NEAR_KEYS - 1);
    *k = low + segment_passed(times, time, low, 1);
    return is_after & is_before;
}

/* The same result as segment_find, by way of `hint`. */
static inline nkw_segment segment_find_hint(segment_times times, float time, size_t hint)
{
    nkw_segment none = {0, 0.0f};
    size_t k;
    if (times.count < 2)
        return none;
    if (!segment_is_near(times, time, hint, &k))
        k = segment_search(times, time);
    return segment_at(times, time, k);
}

/*
 * The key at an even rate that is nearest to the time, 0..last. It does not decrease with the time, because rounding is
 * monotonic. So if it is k for each times[k], it is k or k + 1 for times[k] <= time < times[k + 1].
 */
static inline size_t segment_even_key(float start, float rate, size_t last, float time)
{
    float x = (time - start) * rate + 0.5f, above = x > 0.0f ? x : 0.0f;
    float within = above < 0x1p31f ? above : 0x1p31f; /* a number of its own, so that no other is converted */
    size_t k = (uint32_t)within;
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
