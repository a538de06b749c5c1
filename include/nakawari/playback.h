/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 4: from the time that runs to the time in a clip, and which keys were passed on the way.
 *
 * A clip runs over [start, start + duration]. Its play head is worked out in binary64 from the running time, not
 * summed up, so it does not drift, and the same time gives the same bits however it was reached. All times in
 * seconds.
 */
#ifndef NAKAWARI_PLAYBACK_H
#define NAKAWARI_PLAYBACK_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What happens outside the clip. Any other number is read as NKW_PLAYBACK_CLAMP. */
typedef enum nkw_playback {
    NKW_PLAYBACK_CLAMP,    /**< the first and the last state hold */
    NKW_PLAYBACK_LOOP,     /**< from the end at once to the start: time in [start, start + duration) */
    NKW_PLAYBACK_PING_PONG /**< forth and back */
} nkw_playback;

/**
 * A play head: the time in the clip, and the number of the pass, 0 for the first, negative before it. With passes a
 * motion goes on from where it ended: value + cycle (last - first), the relative cycling of curve editors.
 */
typedef struct nkw_play_head {
    float time;
    float cycle;
} nkw_play_head;

/**
 * The play head at the running time `time`, where time = start is the clip's first moment.
 *
 *     cycle = floor((time - start) / duration),     rest = time - start - cycle duration
 *
 *     CLAMP       time within [start, start + duration], cycle 0
 *     LOOP        start + rest; where that rounds to the end, start, and cycle one more
 *     PING_PONG   start + rest in even cycles, start + duration - rest in odd ones
 *
 * A clip's keys may begin late. Seconds since it was started are nkw_playback_head(mode, start, end - start, start +
 * seconds); on a time line of its own, from 0 to its last key as in glTF, nkw_playback_head(mode, 0, end, seconds).
 *
 * For a loop with a closing segment, in which the last key blends into the first, pass duration + the segment's
 * length and give the track its first key once more at the end.
 *
 * A duration that is not positive and finite, or a NaN time, gives {start, 0}; so does an infinite time but for CLAMP,
 * which gives the end that it lies beyond. Beyond 2^24 passes `cycle` is rounded, beyond 2^128 infinite.
 */
NKW_API nkw_play_head nkw_playback_head(nkw_playback mode, float start, float duration, float time);

/** A step of the running time over the keys of a clip. */
typedef struct nkw_playback_step {
    /**
     * key_count ascending key times in [start, start + duration); keys at start + duration are those at start in the
     * next pass and should not be listed
     */
    const float *times;
    size_t key_count;
    float duration; /**< of the loop; 0 for a clip that is played once */
    float from, to; /**< the running time goes from `from`, exclusive, to `to`, inclusive */
} nkw_playback_step;

/**
 * The keys that a looping clip passes in a step of the running time: those in (from, to], each once for every pass.
 * Steps that follow each other, (a, b] and (b, c], miss none and report none twice, across the ends of the loop too.
 *
 *     key k is passed at times[k] + n duration, n = 0, 1, 2 ... and -1, -2 ...
 *
 * keys        receives the indices of the first `capacity` keys in the order in which they are passed; may be NULL if
 *             capacity is 0
 * passed      becomes the number of keys passed, which may be more than capacity. to <= from passes none: play
 *             backwards by mirroring times
 * Returns     NKW_OK; NKW_NOT_FINITE for a from, to or duration that is not finite; NKW_OUT_OF_RANGE for a negative
 *             duration, times that span more than it, more than 2^31 passes in one step, and passes beyond the 2^53rd;
 *             *passed is then 0. NKW_TOO_MANY where size_t does not hold the number, *passed is then SIZE_MAX
 */
NKW_API nkw_result nkw_playback_passed(const nkw_playback_step *step, size_t *keys, size_t *passed, size_t capacity);

#ifdef __cplusplus
}
#endif

#endif
