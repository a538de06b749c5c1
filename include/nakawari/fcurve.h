/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Curves of animation tools: keys with handles, an interpolation for each key, and a behaviour before the
 * first and after the last key.
 *
 * An fcurve is a view of the caller's array of keys, in ascending order of time; two equal times are a jump. The
 * segment from key k to k + 1 is half open, as in segment.h, and interpolated by the kind of key k, with
 * x = (time - key[k].time) / (key[k + 1].time - key[k].time):
 *
 *     CONSTANT        value[k]
 *     CONSTANT_NEXT   value[k + 1]; value[k] only at the time of key k itself
 *     LINEAR          value[k] + x (value[k + 1] - value[k])
 *     BEZIER          nkw_handle_sample with the handles key[k].out and key[k + 1].in, shortened by `policy`
 *     EASE            value[k] + nkw_ease_evaluate(key[k].ease, x).value (value[k + 1] - value[k])
 *
 * At the time of a key the value is that of the key, bit for bit. With d = time of the last key - time of the first,
 * the value outside the keys is
 *
 *     HOLD            that of the nearest key
 *     LINEAR          the line through the nearest key, along its handle that points outwards if the key is BEZIER and
 *                     that handle has a time, otherwise with the slope of the curve there; an infinite slope holds
 *     CYCLE           that at time - n d
 *     CYCLE_OFFSET    that at time - n d, plus n (value of the last key - value of the first)
 *     OSCILLATE       that at time - n d for even n, at the mirrored time for odd n
 *
 * where n is the number of the cycle, 0 within the keys. After the given number of cycles, the value at their end is
 * held. Derivatives are by time; at a key they are those of the segment that it begins, at the last key those of the
 * segment that it ends.
 */
#ifndef NAKAWARI_FCURVE_H
#define NAKAWARI_FCURVE_H

#include <stdint.h>

#include "base.h"
#include "ease.h"
#include "handle.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The interpolation of the segment that a key begins. Any other number is read as NKW_FCURVE_CONSTANT. */
typedef enum nkw_fcurve_kind {
    NKW_FCURVE_CONSTANT, /**< holds the key (step) */
    NKW_FCURVE_CONSTANT_NEXT, /**< holds the next key (step next) */
    NKW_FCURVE_LINEAR,
    NKW_FCURVE_BEZIER,
    NKW_FCURVE_EASE,
    NKW_FCURVE_KIND_MAX_ENUM = 0x7fffffff
} nkw_fcurve_kind;

/** The behaviour before the first or after the last key. Any other number is read as NKW_FCURVE_OUTSIDE_HOLD. */
typedef enum nkw_fcurve_outside {
    NKW_FCURVE_OUTSIDE_HOLD, /**< constant */
    NKW_FCURVE_OUTSIDE_LINEAR, /**< a line, see above */
    NKW_FCURVE_OUTSIDE_CYCLE, /**< repeats (loop) */
    NKW_FCURVE_OUTSIDE_CYCLE_OFFSET, /**< repeats, each cycle from the value where the one before ended */
    NKW_FCURVE_OUTSIDE_OSCILLATE, /**< repeats, every other cycle backwards (ping-pong) */
    NKW_FCURVE_OUTSIDE_MAX_ENUM = 0x7fffffff
} nkw_fcurve_outside;

typedef struct nkw_fcurve_key {
    float time, value;
    nkw_handle in, out; /**< relative to the key; in.time is not positive, out.time not negative */
    nkw_fcurve_kind kind;
    nkw_ease_kind ease; /**< for NKW_FCURVE_EASE */
} nkw_fcurve_key;
NKW_SIZE(nkw_fcurve_key, 32, 32);

/** One number over time. The keys belong to the caller. */
typedef struct nkw_fcurve {
    const nkw_fcurve_key *keys;
    size_t key_count;
    nkw_fcurve_outside before, after;
    uint32_t before_cycles, after_cycles; /**< the number of cycles outside the keys; 0 repeats without end */
    nkw_handle_policy policy; /**< for BEZIER segments that run back in time */
} nkw_fcurve;
NKW_SIZE(nkw_fcurve, 40, 28);

/**
 * Checks an fcurve.
 *
 * bad  receives the index of the first key with an error, 0 if there is none; may be NULL
 * Returns
 *
 *     NKW_OK             no error
 *     NKW_EMPTY          no keys
 *     NKW_BAD_METHOD     an unknown kind, ease, behaviour or policy
 *     NKW_NOT_FINITE     a time, value or handle that is not finite
 *     NKW_NOT_ASCENDING  a time less than the one before
 *
 * Handles that point out of their segment are not an error: the policy, or the solver, answers them.
 */
NKW_API nkw_result nkw_fcurve_validate(const nkw_fcurve *curve, size_t *bad);

/**
 * The value at `time`, with its first and second derivative by time.
 *
 * cursor   NULL, or where the search begins: a segment, which receives the segment found. Any number is a valid cursor.
 *          The result has the same bits
 * Returns  NaN for a NaN time; 0 for no keys. One key holds its value. A curve that nkw_fcurve_validate rejects returns
 *          values without meaning, but nothing is read outside its keys. An infinite time returns the nearest key for
 *          the cycles, and its line for LINEAR
 *
 * Error  1.1 u of the largest of the result and the values and tips of handles of the segment. BEZIER and EASE by a
 *        keyword of CSS relative to the exact curve at some time near `time`, as in handle.h. Outside the keys up to
 *        2^40 cycles, where differences of times are exact in binary64: they are 0 or within a factor of 2^29 of each
 *        other.
 */
NKW_API nkw_motion nkw_fcurve_sample(const nkw_fcurve *curve, float time, uint32_t *cursor);

/**
 * Shortens the handles of all BEZIER segments by a policy, as nkw_handle_limit, so that no tool sees a curve that runs
 * back (nkw_handle_runs_back of a segment). out receives count keys; it may be `keys`.
 */
NKW_API void nkw_fcurve_limit(const nkw_fcurve_key *keys, size_t count, nkw_handle_policy policy, nkw_fcurve_key *out);

/**
 * Inserts a key without changing the curve. A CONSTANT or LINEAR segment becomes two of its kind, a BEZIER segment is
 * split by nkw_handle_split, after `policy` has shortened its handles.
 *
 * Under NKW_HANDLE_CONTAIN the segment with the new key changes, as in Blender, where a handle is longer than its part
 * of the segment: the policy then shortens it. No insertion is exact there. To leave the curve unchanged, store the
 * shortened handles by nkw_fcurve_limit and continue with NKW_HANDLE_KEEP_RATIO: it changes no segment whose handles
 * are within its duration.
 *
 * time     later than a key and earlier than the next one
 * out      receives key_count + 1 keys; may be the array of the curve, if it has room
 * index    receives the index of the new key; unchanged after an error
 * Returns  NKW_OK; NKW_OUT_OF_RANGE for another time; NKW_BAD_METHOD for an EASE segment; nothing is then written
 */
NKW_API nkw_result nkw_fcurve_insert(const nkw_fcurve *curve, float time, nkw_fcurve_key *out, size_t *index);

#ifdef __cplusplus
}
#endif

#endif
