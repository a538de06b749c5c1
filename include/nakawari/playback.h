/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 4: the time in a clip from the running time of a program, and the keys that were passed in a step of it.
 *
 * A clip covers [start, start + duration]. Its play head is computed in binary64 from the running time, not
 * accumulated: it does not drift, and equal times return equal bits. All times are in seconds.
 */
#ifndef NAKAWARI_PLAYBACK_H
#define NAKAWARI_PLAYBACK_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The state outside the clip. Any other number is read as NKW_PLAYBACK_CLAMP. */
typedef enum nkw_playback {
    NKW_PLAYBACK_CLAMP,    /**< the first state before, the last state after */
    NKW_PLAYBACK_LOOP,     /**< the clip repeats: time in [start, start + duration) */
    NKW_PLAYBACK_PING_PONG /**< the clip alternates between forward and backward */
} nkw_playback;

/**
 * A play head: the time in the clip, and the number of the loop, 0 for the first, negative before it. With it a motion
 * can continue from its last value, as in the relative cycling of curve editors: value + cycle (last - first).
 */
typedef struct nkw_play_head {
    float time;
    float cycle;
} nkw_play_head;

/**
 * The play head at the running time `time`; the first loop begins at time = start.
 *
 *     cycle = floor((time - start) / duration),     rest = time - start - cycle duration
 *
 *     CLAMP       time clamped to [start, start + duration]; cycle 0
 *     LOOP        start + rest; if it rounds to the end, start, and cycle + 1
 *     PING_PONG   start + rest in even cycles, start + duration - rest in odd cycles
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
 *          nearer end for CLAMP and {start, 0} otherwise. Above 2^24, `cycle` is rounded; above 2^128 it is infinite.
 */
NKW_API nkw_play_head nkw_playback_head(nkw_playback mode, float start, float duration, float time);

/** A step of the running time over the keys of a clip. */
typedef struct nkw_playback_step {
    /**
     * key_count ascending key times in [start, start + duration). Omit a key at start + duration: it is the key at
     * start of the next loop.
     */
    const float *times;
    size_t key_count;
    float duration; /**< of the loop; 0 for a clip that does not loop */
    float from, to; /**< the running time before, exclusive, and after the step, inclusive */
} nkw_playback_step;

/**
 * The keys that a clip passes in a step of the running time:
 *
 *     key k is passed at times[k] + n duration, for every integer n; for duration = 0 only at times[k]
 *
 * Consecutive steps, (a, b] and (b, c], report each passing exactly once, also across the ends of a loop.
 *
 * keys      receives the indices of the first `capacity` keys in the order in which they are passed; may be NULL if
 *           capacity is 0
 * passed    receives the number of keys passed, which may be greater than capacity; 0 for to <= from
 * Returns   NKW_OK; NKW_NOT_FINITE if from, to or duration is not finite; NKW_OUT_OF_RANGE for a negative duration, for
 *           times that span more than the duration, for more than 2^31 loops in one step, and for loop numbers from
 *           2^53 on; *passed is then 0. NKW_TOO_MANY if the number exceeds size_t; *passed is then SIZE_MAX
 *
 * To play backwards, pass -from, -to, and the negated key times in reverse order.
 */
NKW_API nkw_result nkw_playback_passed(const nkw_playback_step *step, size_t *keys, size_t *passed, size_t capacity);

#ifdef __cplusplus
}
#endif

#endif
