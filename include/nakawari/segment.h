/* SPDX-License-Identifier: MIT */
/**
 * @file
 * The segment of a time: the two keys around it, and the parameter between them.
 *
 * `count` ascending key times are the bounds of count - 1 segments. The segment of a time is the k with
 *
 *     times[k] <= time < times[k + 1],        t = (time - times[k]) / (times[k + 1] - times[k])
 *
 *     before the first key     index = 0            t = 0
 *     from the last key on     index = count - 2    t = 1
 *     NaN, or count < 2        index = 0            t = 0
 *
 * Segments are half open: the time of a key starts a segment. Keys of equal time bound an empty segment; it contains no
 * time, except an empty last segment, which is found from the last key on.
 *
 * For every input, index + 1 < count or index = 0, and 0 <= t <= 1. Times that do not ascend, or are NaN, return some
 * segment within the array.
 *
 * t is computed in binary64 and rounded once. t is 0 at the first key of the segment, and t is 1 only from the last key
 * on.
 *
 * Example  nkw_segment s, list[8]; nkw_timeline even; float *times, time, moments[8]; size_t n;
 *
 *     s = nkw_segment_find(times, n, time);                  the two keys around a time, and t
 *     s = nkw_segment_find_hint(times, n, time, s.index);    faster near the last one
 *     time = nkw_timeline_time(even, 3);                     evenly spaced keys: the time of one
 *     nkw_timeline_from_times(times, n, &even);              are they evenly spaced?
 *     s = nkw_timeline_find(even, time);                     without a search
 *     nkw_segment_find_n(times, n, moments, list, 8);        of many times
 */
#ifndef NAKAWARI_SEGMENT_H
#define NAKAWARI_SEGMENT_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The segment from key `index` to key `index + 1`, and the parameter t in it, 0..1. */
typedef struct nkw_segment {
    size_t index;
    float t;
} nkw_segment;
NKW_SIZE(nkw_segment, 16, 8);

/**
 * The segment of `time`, by a search without a branch on a time. Up to 17 keys are all compared; up to 257 keys take
 * one step that compares every 16th key and one that compares 16 neighbours; more keys are first reduced to a quarter,
 * and so on.
 */
NKW_API nkw_segment nkw_segment_find(const float *times, size_t count, float time);

/**
 * The same segment, first tried at the segment `hint`, usually the segment found last, and at the next and the one
 * before. It takes two or three comparisons while the time changes slowly, forward or backward, and after a jump as
 * many more as nkw_segment_find. Any hint is valid. For ascending times the result is that of nkw_segment_find, bit for
 * bit.
 */
NKW_API nkw_segment nkw_segment_find_hint(const float *times, size_t count, float time, size_t hint);

/** `count` evenly spaced keys: key k is at start + k / rate. `rate` is in keys per second. */
typedef struct nkw_timeline {
    float start, rate;
    size_t count;
} nkw_timeline;
NKW_SIZE(nkw_timeline, 16, 12);

/** The time of key k: start + k / rate, rounded once. k may be beyond the last key. */
NKW_API float nkw_timeline_time(nkw_timeline timeline, size_t k);

/**
 * The timeline of evenly spaced key times: one with a rate of at most 1e9 for which nkw_timeline_time is times[k] for
 * every k, bit for bit except the sign of a zero. Each time must be greater than the one before. If an integer is such
 * a rate, the rate is an integer.
 *
 * timeline  receives {times[0], rate, count}; {0, 0, 0} after an error
 * Returns   NKW_OK; NKW_EMPTY for fewer than two keys; NKW_NO_RATE if no such rate exists
 */
NKW_API nkw_result nkw_timeline_from_times(const float *times, size_t count, nkw_timeline *timeline);

/**
 * The segment of `time`, without a search. The result is that of nkw_segment_find over the times of nkw_timeline_time,
 * bit for bit, if each of them is greater than the one before. A rate that is not positive and finite returns {0, 0}.
 */
NKW_API nkw_segment nkw_timeline_find(nkw_timeline timeline, float time);

/**
 * The segments of n times. The result is that of nkw_segment_find for each, for ascending key times. Where
 * neighbouring times are at most two segments apart, each search starts at the segment before; otherwise a call takes
 * as long as n of nkw_segment_find.
 */
NKW_API void nkw_segment_find_n(const float *times, size_t count, const float *time, nkw_segment *out, size_t n);

#ifdef __cplusplus
}
#endif

#endif
