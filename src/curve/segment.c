/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <stdint.h>

#include <nakawari/segment.h>

#include "lane/scalar.h"
#include "segment_even.h"
#include "segment_search.h"
#include "sizes.h"

LANE_FLAT nkw_segment nkw_segment_find(const float *times, size_t count, float time)
{
    return segment_find(segment_times_of(times, count), time);
}

LANE_FLAT nkw_segment nkw_segment_find_hint(const float *times, size_t count, float time, size_t hint)
{
    return segment_find_hint(segment_times_of(times, count), time, hint);
}

/*
 * How the segments of many times are found. Each way has the same result.
 *
 *     way       the segment of a time is first tried                      fast for
 *     SEARCH    not at all                                                times in no order
 *     HINT      at the last one and its neighbours, with branches         the same step from each time to the next
 *     WALK      at the last one and its neighbours, without branches      steps of 0, 1 or 2 segments in no order
 */
typedef enum segment_way { SEGMENT_SEARCH, SEGMENT_HINT, SEGMENT_WALK } segment_way;

/*
 * n times. The search is called: inlined into this loop it takes 1.4 times as long at 301 keys (GCC 12). The others are
 * functions of their own, so that one's variables take no registers of another.
 */
static void search_n(const float *times, size_t count, const float *time, nkw_segment *out, size_t n)
{
    for (size_t i = 0; i < n; i++)
        out[i] = nkw_segment_find(times, count, time[i]);
}

LANE_FLAT NKW_NOINLINE static void hint_n(segment_times all, const float *time, size_t from, nkw_segment *out, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        out[i] = segment_find_hint(all, time[i], from);
        from = out[i].index;
    }
}

LANE_FLAT NKW_NOINLINE static void walk_n(segment_times all, const float *time, size_t from, nkw_segment *out, size_t n)
{
    size_t k = from;
    for (size_t i = 0; i < n; i++) {
        if (!segment_walk_to(all, time[i], &k))
            k = segment_search(all, time[i]);
        out[i] = segment_at(all, time[i], k);
    }
}

/* The way for times that continue as the n segments: by how many steps are longer than HINT and than WALK try. */
static segment_way way_after(size_t count, const nkw_segment *found, size_t n)
{
    size_t far = 0, twos = 0;
    for (size_t i = 1; i < n; i++) {
        const size_t from_one_before = found[i].index + 1 - found[i - 1].index; /* modulo 2^N: 0..3 are steps of WALK */
        far += from_one_before > 3;
        twos += from_one_before == 3;
    }
    return count < SEGMENT_NEAR_KEYS || far > n / 8 ? SEGMENT_SEARCH : twos > 0 ? SEGMENT_WALK : SEGMENT_HINT;
}

void nkw_segment_find_n(const float *times, size_t count, const float *time, nkw_segment *out, size_t n)
{
    const segment_times all = segment_times_of(times, count);
    segment_way way = count < SEGMENT_NEAR_KEYS ? SEGMENT_SEARCH : SEGMENT_HINT;
    size_t from = 0, run = SEGMENT_FIRST_RUN;
    for (size_t i = 0; i < n; run = SEGMENT_RUN) {
        const size_t m = n - i < run ? n - i : run, seen = m < SEGMENT_FIRST_RUN ? m : SEGMENT_FIRST_RUN;
        if (way == SEGMENT_SEARCH)
            search_n(times, count, time + i, out + i, m);
        else if (way == SEGMENT_HINT)
            hint_n(all, time + i, from, out + i, m);
        else
            walk_n(all, time + i, from, out + i, m);
        i += m;
        from = out[i - 1].index;
        way = way_after(count, out + (i - seen), seen);
    }
}

/* start + k / rate, rounded once to binary32. k is a whole number in binary64. */
static float uniform_time(float start, float rate, double k)
{
    return (float)((double)start + k / (double)rate);
}

float nkw_timeline_time(nkw_timeline timeline, size_t k)
{
    return uniform_time(timeline.start, timeline.rate, (double)k);
}

/* Whether times[k] == times[0] + k / rate, rounded, for every k, in strictly ascending order. */
static int is_uniform(const float *times, size_t count, float rate)
{
    for (size_t k = 0; k < count; k++)
        if (uniform_time(times[0], rate, (double)k) != times[k] || (k > 0 && !(times[k - 1] < times[k])))
            return 0;
    return rate > 0.0f;
}

/*
 * A rate for which |times[k] - (times[0] + k / rate)| <= half[k] for every k, if there is one. half[k] is half an ULP:
 *
 *     (times[k] - times[0] - half[k]) / k  <=  1 / rate  <=  (times[k] - times[0] + half[k]) / k
 *
 * Returns the inverse of the middle of the intersection of these intervals.
 */
static double middle_rate(const float *times, size_t count)
{
    double low = 0.0, high = DBL_MAX; /* the interval of 1 / rate */
    for (size_t k = 1; k < count; k++) {
        double half = (double)lane_float(lane_bits(times[k]) & 0x7f800000u) * 0x1p-24;
        double elapsed = (double)times[k] - (double)times[0], steps = (double)k;
        low = (elapsed - half) / steps > low ? (elapsed - half) / steps : low;
        high = (elapsed + half) / steps < high ? (elapsed + half) / steps : high;
    }
    return 1.0 / (0.5 * low + 0.5 * high);
}

/* The nearest whole rate, otherwise the rounded rate, whichever reproduces the times; 0 if neither does. */
static float uniform_rate(const float *times, size_t count)
{
    double rate = middle_rate(times, count);
    if (!(rate > 0.0 && rate < 1e9))
        return 0.0f;
    float whole = (float)(uint32_t)(rate + 0.5);
    if (is_uniform(times, count, whole))
        return whole;
    return is_uniform(times, count, (float)rate) ? (float)rate : 0.0f;
}

nkw_result nkw_timeline_from_times(const float *times, size_t count, nkw_timeline *timeline)
{
    const nkw_timeline none = {0.0f, 0.0f, 0};
    const float rate = count > 1 ? uniform_rate(times, count) : 0.0f;
    *timeline = none;
    if (!(rate > 0.0f))
        return count < 2 ? NKW_EMPTY : NKW_NO_RATE;
    timeline->start = times[0];
    timeline->rate = rate;
    timeline->count = count;
    return NKW_OK;
}

/* The largest index of a segment: less than 2^53, so that it is exact in binary64, and within size_t. */
#define SEGMENT_MOST ((size_t)1 << (sizeof(size_t) > 4 ? 52 : 31))

nkw_segment nkw_timeline_find(nkw_timeline timeline, float time)
{
    const float start = timeline.start, rate = timeline.rate;
    const size_t count = timeline.count;
    nkw_segment none = {0, 0.0f};
    if (count < 2 || !(rate > 0.0f) || rate - rate != 0.0f)
        return none;
    double last = (double)(int64_t)(count - 2 < SEGMENT_MOST ? count - 2 : SEGMENT_MOST);
    double x = ((double)time - (double)start) * (double)rate;
    double least = x > 0.0 ? x : 0.0, k = (double)(int64_t)(least < last ? least : last);
    float a = uniform_time(start, rate, k), b = uniform_time(start, rate, k + 1.0);
    /* Key times are rounded: a time within half an ULP of a key may belong to the neighbouring segment. */
    if (k > 0.0 && time < a) {
        k -= 1.0;
        b = a;
        a = uniform_time(start, rate, k);
    } else if (k < last && time >= b) {
        k += 1.0;
        a = b;
        b = uniform_time(start, rate, k + 1.0);
    }
    nkw_segment r = {(size_t)(int64_t)k, segment_t(a, b, time)};
    return r;
}

nkw_result nkwi_segment_even_rate(const float *times, size_t count, float *rate)
{
    *rate = 0.0f;
    if (count < 2)
        return NKW_EMPTY;
    float even = (float)((double)(int64_t)(count - 1) / ((double)times[count - 1] - (double)times[0]));
    if (!(even > 0.0f && even <= FLT_MAX) || !segment_is_even(times, count, even))
        return NKW_NO_RATE;
    *rate = even;
    return NKW_OK;
}

nkw_segment nkwi_segment_find_even(const float *times, size_t count, float rate, float time)
{
    nkw_segment none = {0, 0.0f};
    if (count < 2)
        return none;
    size_t k = segment_even_key(times[0], rate, count - 1, time);
    k -= (size_t)(k > 0) & (size_t)(time < times[k]);
    return segment_at(segment_times_of(times, count), time, k < count - 2 ? k : count - 2);
}
