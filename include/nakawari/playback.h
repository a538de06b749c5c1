/* SPDX-License-Identifier: MIT */
/**
 * @file
 * The time in a clip from the running time of a program, the keys that were passed in a step of it, and values
 * that continue from one loop to the next.
 *
 * A clip covers [start, start + duration]. Its play head is computed in binary64 from the running time, not
 * accumulated: it does not drift, and equal times return equal bits. All times are in seconds.
 *
 * Example  nkw_playback_range range; nkw_playback_step step; nkw_play_head head; nkw_play_head_f64 far;
 *          nkw_vec3 v, a, b; nkw_quat q, r; float x; size_t keys[8], n;
 *
 *     head = nkw_playback_head(NKW_PLAYBACK_LOOP, 0.0f, 2.0f, 12.5f);    the time in the clip: once, loop, ping-pong
 *     far = nkw_playback_head_f64(&range, 1e6);                   of long times
 *     x = nkw_playback_offset(x, 0.0f, 1.0f, head.cycle);         a loop that goes on: the value after whole cycles
 *     v = nkw_vec3_playback_offset(v, a, b, head.cycle);
 *     q = nkw_quat_playback_offset(q, q, r, head.cycle);
 *     nkw_playback_passed(&step, keys, 8, &n);                    events between two frames
 */
#ifndef NAKAWARI_PLAYBACK_H
#define NAKAWARI_PLAYBACK_H

#include <stdint.h>

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The state outside the clip. Any other number is read as NKW_PLAYBACK_CLAMP. */
typedef enum nkw_playback {
    NKW_PLAYBACK_CLAMP, /**< the first state before, the last state after */
    NKW_PLAYBACK_LOOP, /**< the clip repeats: time in [start, start + duration) */
    NKW_PLAYBACK_PING_PONG, /**< the clip alternates between forward and backward */
    NKW_PLAYBACK_MAX_ENUM = 0x7fffffff
} nkw_playback;

/**
 * A play head: the time in the clip, and the number of the loop, 0 for the first, negative before it. With it a motion
 * can continue from its last value, as in the relative cycling of curve editors: value + cycle (last - first).
 */
typedef struct nkw_play_head {
    float time;
    float cycle;
} nkw_play_head;
NKW_SIZE(nkw_play_head, 8, 8);

/**
 * The play head at the running time `time`; the first loop begins at time = start.
 *
 *     cycle = floor((time - start) / duration),     r = time - start - cycle duration
 *
 *     CLAMP       time clamped to [start, start + duration]; cycle 0
 *     LOOP        start + r; if it rounds to the end, start, and cycle + 1
 *     PING_PONG   start + r in even cycles, start + duration - r in odd cycles
 *
 * The first key of a clip may be later than 0. For a clip whose first key is at `start` and whose last key is at `end`,
 * `seconds` after it was started:
 *
 *     from its first key on     nkw_playback_head(mode, start, end - start, start + seconds)
 *     from 0 on, as in glTF     nkw_playback_head(mode, 0, end, seconds)
 *
 * For a loop with a closing segment from the last key to the first, add the length of that segment to the duration, and
 * repeat the first key at the end of the track.
 *
 * Returns  {start, 0} for a duration that is not positive and finite, and for a NaN time. An infinite time returns the
 *          nearer end for CLAMP and {start, 0} otherwise. So does a cycle from 2^51 on. Above 2^24, `cycle` is rounded.
 *
 * The time is exact to one rounding where time - start is exact in binary64: one is 0, or they differ by less than a
 * factor of 2^29. `time` itself has a resolution of 7.8 ms after a day.
 *
 * It is nkw_playback_head_f64 of the same mode before and after, rounded. Both functions exist because the rounding
 * belongs to the cycle: just before the end of a loop of 2 s, (float)1.99999999 is 2, the end, which a loop never
 * returns. An index computed from it, such as that of a frame, would be one too large. Only what knows the cycle can
 * return the start of the next one instead.
 */
NKW_API nkw_play_head nkw_playback_head(nkw_playback mode, float start, float duration, float time);

/**
 * How a clip is repeated before its start and after its end. Zero a range first: all members of 0 are the defaults.
 */
typedef struct nkw_playback_range {
    double start, duration; /**< seconds; the duration from the first key to the last */
    /**
     * Seconds of an additional segment from the last key to the first, between two cycles of NKW_PLAYBACK_LOOP. 0 if
     * the last key repeats the first.
     */
    double closing;
    nkw_playback before, after; /**< the state before the start and after the end */
    /**
     * More whole cycles, before the start and after the end of the clip itself; then the state stays. 0: without a
     * limit. 3 after the end play the clip four times in all, as Blender's modifier does. From others: CSS and three.js
     * count the plays, which is one more.
     */
    double before_cycles, after_cycles;
} nkw_playback_range;
NKW_SIZE(nkw_playback_range, 48, 48);

/** A play head in binary64. */
typedef struct nkw_play_head_f64 {
    double time; /**< in [start, start + duration] */
    double cycle; /**< the number of the cycle: 0 within the clip, negative before it */
    double closing; /**< in the closing segment, its parameter in 0..1 from the last key to the first; 0 elsewhere */
} nkw_play_head_f64;
NKW_SIZE(nkw_play_head_f64, 24, 24);

/**
 * The play head of a range in binary64: for a running time of hours, where a float has a resolution of milliseconds
 * (0.24 ms after an hour, 7.8 ms after a day).
 *
 *     period = duration + closing for LOOP, duration for PING_PONG
 *     cycle = floor((time - start) / period),     r = time - start - cycle period
 *
 *     CLAMP       the nearer end; cycle 0
 *     LOOP        start + r; from duration on the last key, with closing = (r - duration) / closing; without a
 *                 closing segment, if start + r rounds to the end, start, and cycle + 1
 *     PING_PONG   start + r in even cycles, start + duration - r in odd cycles
 *
 * Beyond the counts, the state is that at the end of the last cycle after the clip, at the beginning of the first one
 * before it, and `cycle` is the number of that cycle.
 *
 * range    counts are rounded down; negative counts, a negative closing and NaN count as 0
 * time     running time in seconds
 * Returns  {start, 0, 0} for a duration outside 2^-900 .. 2^900 and for a NaN time. An infinite time returns the state
 *          beyond the count, without a limit {start, 0, 0}. So does a cycle from 2^51 on.
 *
 * time - start and the period are rounded to binary64, then the remainder has one rounding. With start = 0 and closing
 * = 0 that is one rounding in all, for |cycle| below 2^51. Otherwise `time` is off by up to |time| 2^-52 more, the
 * rounding of a sum in each period: 1.4e-10 s after a week. A caller who rounds `time` to float may receive the end.
 */
NKW_API nkw_play_head_f64 nkw_playback_head_f64(const nkw_playback_range *range, double time);

/**
 * A value that continues in each cycle from the end of the one before, as curve editors repeat "with offset":
 *
 *     value + cycle (last - first)
 *
 * value, first, last  the value now, at the first key and at the last
 * cycle               of a play head; any number. 0 returns the value bit for bit
 *
 * Error  1.01 u of |value| + |cycle (last - first)|.
 */
NKW_API float nkw_playback_offset(float value, float first, float last, double cycle);
/** The same of a vector: each component with the bits of nkw_playback_offset. */
NKW_API nkw_vec3 nkw_vec3_playback_offset(nkw_vec3 value, nkw_vec3 first, nkw_vec3 last, double cycle);
/**
 * The same of a rotation: C^cycle value, C = last first^-1 along the shorter arc. The power is computed by its angle,
 * not by repeated products, so it does not drift.
 *
 * Error  3.5 u, for |cycle| below 10^7: 115 days of cycles of one second.
 */
NKW_API nkw_quat nkw_quat_playback_offset(nkw_quat value, nkw_quat first, nkw_quat last, double cycle);

/** A step of the running time over the keys of a clip. */
typedef struct nkw_playback_step {
    /**
     * key_count ascending key times in [start, start + duration). Omit a key at start + duration: it is the key at
     * start of the next loop.
     */
    const float *times;
    size_t key_count;
    double duration; /**< of the loop; 0 for a clip that does not loop */
    double from, to; /**< the running time before, exclusive, and after the step, inclusive; to < from plays backwards */
    /** 1 for the first step of a play: keys at `from` are passed too; else 0. Of 64 bits, for one size on 32-bit ABIs. */
    int64_t includes_from;
} nkw_playback_step;
NKW_SIZE(nkw_playback_step, 48, 40);

/**
 * The keys that a clip passes in a step of the running time:
 *
 *     key k is passed at times[k] + n duration, for every integer n; for duration = 0 only at times[k]
 *
 * Consecutive steps in one direction, from a to b and from b to c, report each passing exactly once, also across the
 * ends of a loop: a step passes the keys in (from, to], a step backwards those in [to, from). Where play begins, no
 * step before has passed the keys at `from`: with `includes_from` both are [from, to] and [to, from], also for to = from.
 *
 * keys      receives the indices of the first `capacity` keys in the order in which they are passed; may be NULL if
 *           capacity is 0
 * count     receives the number of keys passed, also if capacity is less
 * Returns   NKW_OK; NKW_TOO_SMALL for capacity; NKW_NOT_FINITE if from, to or duration is not finite; NKW_OUT_OF_RANGE for a negative duration, for
 *           times that span more than the duration, for more than 2^31 loops in one step, and for loop numbers from
 *           2^53 on; *count is then 0. NKW_TOO_MANY if the number exceeds size_t; *count is then SIZE_MAX
 */
NKW_API nkw_result nkw_playback_passed(const nkw_playback_step *step, size_t *keys, size_t capacity, size_t *count);

#ifdef __cplusplus
}
#endif

#endif
