/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Whole frames and ticks at rational rates, their conversion into each other and into seconds, and timecode.
 *
 * A film has 24 frames a second, television of the NTSC countries 30000/1001; FBX files count 46186158000 ticks a
 * second, USD stages and BVH files any number that they state. A count of frames or ticks is a whole number: it adds up
 * without rounding, for hours, at every rate. Seconds do not: 1001/30000 is no binary number. Convert to seconds last.
 *
 * All arithmetic is in integers of 128 bits: every result is the exact quotient, rounded once.
 */
#ifndef NAKAWARI_TIMECODE_H
#define NAKAWARI_TIMECODE_H

#include <stdint.h>

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * A rate of numerator/denominator frames or ticks per second: {30, 1}, {30000, 1001}. Both are positive, the numerator
 * at most 2^40, the denominator at most 2^22; any other rate is an error.
 */
typedef struct nkw_rate {
    int64_t numerator, denominator;
} nkw_rate;
NKW_SIZE(nkw_rate, 16, 16);

/** Ticks per second that files and tools count. */
#define NKW_RATE_FBX       46186158000 /**< FBX: a multiple of the frame rates of film and television */
#define NKW_RATE_FLICKS    705600000 /**< flicks */
#define NKW_RATE_MAYA      141120000 /**< Maya 2017 and later; before, 6000 */
#define NKW_RATE_ASSIMP_MS 1000 /**< milliseconds, as many importers of Assimp state */
#define NKW_RATE_3DS_MAX   4800 /**< 3ds Max */

/** How a quotient that is not whole is rounded. Any other number is read as NKW_ROUND_NEAREST. */
typedef enum nkw_round {
    NKW_ROUND_NEAREST, /**< to the nearest whole number, halves upwards */
    NKW_ROUND_DOWN, /**< towards minus infinity: the frame that is shown at a time */
    NKW_ROUND_UP, /**< towards plus infinity: the first frame that is not before a time */
    NKW_ROUND_MAX_ENUM = 0x7fffffff
} nkw_round;

/**
 * The count of `to` at the time of `count` of `from`: count (to / from), rounded as `round` says.
 *
 * out      receives the count; 0 after an error
 * Returns  NKW_OK; NKW_NO_RATE for a rate out of range; NKW_OUT_OF_RANGE if the result exceeds 63 bits
 */
NKW_API nkw_result nkw_ticks_convert(int64_t count, nkw_rate from, nkw_rate to, nkw_round round, int64_t *out);

/**
 * The time in seconds of a count: count denominator / numerator, correctly rounded to binary64.
 *
 * seconds  receives the time; 0 after an error
 * Returns  NKW_OK; NKW_NO_RATE for a rate out of range
 */
NKW_API nkw_result nkw_ticks_to_seconds(int64_t count, nkw_rate rate, double *seconds);

/**
 * The count at a time: seconds numerator / denominator, rounded as `round` says; the exact product of the double, not a
 * rounded one.
 *
 * Seconds that nkw_ticks_to_seconds returned come back as their count with NEAREST, for counts below 2^51. With DOWN
 * they may return the frame before, because seconds are rounded: 1023 of the first 1999 frames at 30000/1001 do. Use
 * NEAREST for times of frames, DOWN for times of a clock.
 *
 * out      receives the count; 0 after an error
 * Returns  NKW_OK; NKW_NO_RATE for a rate out of range; NKW_NOT_FINITE; NKW_OUT_OF_RANGE if the result exceeds 63 bits
 */
NKW_API nkw_result nkw_ticks_from_seconds(double seconds, nkw_rate rate, nkw_round round, int64_t *out);

/**
 * A label of a frame, hours:minutes:seconds:frames. Drop-frame timecode (SMPTE ST 12-1) leaves out the labels of the
 * first frames of every minute except each tenth, so that labels of 30000/1001 frames per second follow the clock: 2 of
 * 30, 4 of 60. No frame is dropped.
 */
typedef struct nkw_timecode {
    int32_t hours, minutes, seconds, frames;
} nkw_timecode;
NKW_SIZE(nkw_timecode, 16, 16);

/**
 * The label of a frame, counted from 00:00:00:00.
 *
 * frame       at least 0; below 2^31 hours
 * per_second  frames of the label's second: 24, 25, 30, 60 ...: the rate rounded up; 1 to 1000
 * drop        not 0: drop-frame timecode, of multiples of 30 frames per second
 * out         receives the label; zeros after an error. Hours are not reduced to a day
 * Returns     NKW_OK; NKW_NO_RATE if per_second is out of range, or no multiple of 30 for drop-frame timecode;
 *             NKW_OUT_OF_RANGE if frame is
 */
NKW_API nkw_result nkw_timecode_from_frame(int64_t frame, int32_t per_second, int drop, nkw_timecode *out);

/**
 * The frame of a label: the inverse.
 *
 * out      receives the frame; 0 after an error
 * Returns  as above; NKW_OUT_OF_RANGE if a number of the label is out of range, or if drop-frame timecode has no such
 *          label (00:01:00:00)
 */
NKW_API nkw_result nkw_timecode_to_frame(nkw_timecode timecode, int32_t per_second, int drop, int64_t *out);

#ifdef __cplusplus
}
#endif

#endif
