/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 4: from a time to the two keys around it.
 *
 * `count` ascending key times part the time line into count - 1 segments. A time lies in the segment k with
 *
 *     times[k] <= time < times[k + 1],        t = (time - times[k]) / (times[k + 1] - times[k])
 *
 * half open, so a key's own time begins a segment, with t = 0; but the last segment is closed: from the last
 * key on, index = count - 2 and t = 1. Before the first key, index = 0 and t = 0. Keys of equal time make
 * empty segments, which no time lies in, except an empty last one, which the end does.
 *
 * Whatever the input: index + 1 < count or index = 0, and 0 <= t <= 1. Fewer than two keys have no segment and
 * give {0, 0}; so does a NaN time. Times that do not ascend, or are NaN, give some segment within the array.
 *
 * t is worked out in binary64 and rounded once, so it cannot overflow. It is 0 at the key that begins the segment,
 * and 1 from the last key on and only there.
 */
#ifndef NAKAWARI_SEGMENT_H
#define NAKAWARI_SEGMENT_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The segment from key `index` to key `index + 1`, and where in it: t in 0..1. */
typedef struct nkw_segment {
    size_t index;
    float t;
} nkw_segment;

/** The segment of `time`: by quartering, about log4(count) turns of three comparisons and no branch on a time. */
NKW_API nkw_segment nkw_segment_find(const float *times, size_t count, float time);

/**
 * The same segment, searched from the segment `hint`, the last one found, outwards: one or two comparisons while time
 * changes slowly, forward or backward, and no more than twice those of nkw_segment_find when it jumps. Any hint is
 * valid. On ascending times the result is that of nkw_segment_find, bit for bit.
 */
NKW_API nkw_segment nkw_segment_find_hint(const float *times, size_t count, float time, size_t hint);

/**
 * The time of key k of a uniform series: start + k / rate, rounded once. `rate` in keys per second.
 */
NKW_API float nkw_segment_uniform_time(float start, float rate, size_t k);

/**
 * The rate of evenly spaced key times: one, at most 1e9, with which nkw_segment_uniform_time(times[0], rate, k) is
 * times[k], bit for bit except the sign of a zero, for every k, and each time is greater than the one before. A whole
 * number where one serves.
 *
 * Returns NKW_OK; NKW_EMPTY for fewer than two keys and NKW_NO_RATE where there is no such rate, *rate is then 0.
 */
NKW_API nkw_result nkw_segment_uniform_rate(const float *times, size_t count, float *rate);

/**
 * The segment among `count` keys at start, start + 1/rate, start + 2/rate ..., without a search. The result is
 * that of nkw_segment_find over the times nkw_segment_uniform_time gives, bit for bit, while each of those is
 * greater than the one before. A rate that is not positive and finite gives {0, 0}.
 */
NKW_API nkw_segment nkw_segment_find_uniform(float start, float rate, size_t count, float time);

/**
 * The segments of n times: each searched from the one before it where the times of one call ascend or stay near each
 * other, for itself where they jump. The same as nkw_segment_find for each, on ascending times.
 */
NKW_API void nkw_segment_find_n(const float *times, size_t count, const float *time, nkw_segment *out, size_t n);

#ifdef __cplusplus
}
#endif

#endif
