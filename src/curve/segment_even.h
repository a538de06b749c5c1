/* SPDX-License-Identifier: MIT */
/* Segments of key times that are nearly evenly spaced: of clips. Tests call these functions from any stack. */
#ifndef NAKAWARI_SEGMENT_EVEN_H
#define NAKAWARI_SEGMENT_EVEN_H

#include <nakawari/segment.h>

/*
 * Computes the rate of times that are evenly spaced before they are rounded, or nearly so: k times a rounded step, sums
 * of a step, times that begin at any frame. The rate is count - 1 segments over the time from first to last key, and
 * (times[k] - times[0]) rate + 1/2, in binary32, is in k..k + 1 for every k: each key deviates from its even time by
 * less than half a segment.
 *
 * *rate receives the rate in keys per second, or 0 after an error: NKW_EMPTY for fewer than two keys; NKW_NO_RATE for
 * other times, or more than 2^31 keys.
 */
NKW_REALIGN nkw_result nkwi_segment_even_rate(const float *times, size_t count, float *rate);

/*
 * The segment of `time`, without a search: the rate determines the nearest even key, and one comparison with the time
 * of that key its segment. The result is that of nkw_segment_find, bit for bit, for a rate from nkwi_segment_even_rate.
 * For another rate it is some segment within the array.
 */
NKW_REALIGN nkw_segment nkwi_segment_find_even(const float *times, size_t count, float rate, float time);

#endif
