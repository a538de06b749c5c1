/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Cubic Bezier segments whose handles have a time and a value.
 *
 * The curve editors of Blender, Maya, Unity, Unreal, FBX and OpenUSD, and the cubic-bezier() of CSS, draw a curve in
 * the plane of time and value. Its parameter s is not the time:
 *
 *     time(s)  = time0 r^3 + 3 (time0 + out.time) s r^2 + 3 (time1 + in.time) s^2 r + time1 s^3,       r = 1 - s
 *     value(s) = the same of values
 *
 * The functions solve time(s) = time for s. Halley's steps stay in a bracket, so that they converge for every pair of
 * handles. All is computed in binary64.
 *
 * A handle is long if it leaves the segment: then time(s) can run back, and the curve has up to three values at a time.
 * nkw_handle_limit shortens such handles by the policy of a tool. Otherwise the value at a time is that of the least s:
 * the curve where it first reaches the time. It jumps there.
 */
#ifndef NAKAWARI_HANDLE_H
#define NAKAWARI_HANDLE_H

#include "curve.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The tip of a handle, relative to its key. */
typedef struct nkw_handle {
    float time, value;
} nkw_handle;
NKW_SIZE(nkw_handle, 8, 8);

/** Two keys, the out-handle of the first and the in-handle of the second. */
typedef struct nkw_handle_segment {
    float time0, value0;
    nkw_handle out; /**< out.time is not negative if the handle points into the segment */
    nkw_handle in; /**< in.time is not positive if the handle points into the segment */
    float time1, value1;
} nkw_handle_segment;
NKW_SIZE(nkw_handle_segment, 32, 32);

/**
 * How handles are shortened whose curve would run back in time. With the lengths p = out.time and q = -in.time in units
 * of the duration, time(s) does not run back for
 *
 *     p, q >= 0  and  (p + q <= 1  or  p^2 + p q + q^2 - 2 (p + q) + 1 <= 0)
 *
 * The second is an ellipse through (1, 0), (4/3, 1/3), (1, 1), (1/3, 4/3) and (0, 1). Any other number is read as
 * NKW_HANDLE_NONE.
 */
typedef enum nkw_handle_policy {
    NKW_HANDLE_NONE, /**< handles as they are: CSS, Unity */
    NKW_HANDLE_CONTAIN, /**< p <= 1 and q <= 1, each by itself: Blender */
    NKW_HANDLE_KEEP_RATIO, /**< both by one factor to the ellipse: OpenUSD */
    NKW_HANDLE_KEEP_START, /**< q is moved to the ellipse; from p = 4/3 on, (p, q) is (4/3, 1/3): Maya */
    NKW_HANDLE_POLICY_MAX_ENUM = 0x7fffffff
} nkw_handle_policy;

/**
 * The point of the segment at a time: the value, and its first and second derivative by time.
 *
 *     first  = value'(s) / time'(s),     second = (value'' time' - value' time'') / time'^3
 *
 * time     before the segment: value0, derivatives 0; after it: value1, derivatives 0. At time0 and time1 the value is
 *          value0 and value1, bit for bit, and the derivatives are those of the segment
 * Returns  NaN for a NaN time or segment time, and where a value that counts is NaN. A segment without a duration
 *          returns value0 before time1 and value1 from time1 on, derivatives 0. Where the curve is vertical, `velocity`
 *          is infinite with the sign of the value's change. Where a handle has length 0 in time and value, `velocity`
 *          is the slope to the next control point that differs, and `acceleration` is 0 or infinite
 *
 * Error  1.1 u of the largest of |value0|, |value1| and of the values at the tips of the handles, for the value,
 *        relative to the exact curve at some time within 2^-48 of the longest of duration and handles from `time`. The
 *        value moves so far where the curve is steep: up to 2^-16 of a jump at a vertical tangent within the segment.
 * Source OpenUSD, Ts, Regressive Splines in USD, 2024, for the ellipse.
 */
NKW_API nkw_motion nkw_handle_sample(const nkw_handle_segment *segment, float time);

/** The parameter s at a time, 0..1; 0 before and 1 after the segment, NaN as for nkw_handle_sample. */
NKW_API float nkw_handle_parameter(const nkw_handle_segment *segment, float time);

/** 1 if time(s) falls for some s in 0..1, otherwise 0. A segment without a duration returns 0. */
NKW_API int nkw_handle_runs_back(const nkw_handle_segment *segment);

/**
 * Shortens the handles of a segment by a policy, so that nkw_handle_runs_back returns 0. The slope of a shortened
 * handle stays. KEEP_START can lengthen q, where p > 1, as Maya does. A handle that points out of its segment becomes
 * {0, 0}. A segment that does not run back is returned unchanged, and so is one without a duration or with a time that
 * is not finite; except that CONTAIN shortens every handle of more than the duration.
 *
 * Error  3.0 u of the duration, for the lengths in time, relative to the exact ellipse.
 */
NKW_API nkw_handle_segment nkw_handle_limit(const nkw_handle_segment *segment, nkw_handle_policy policy);

/**
 * Inserts a key at a time without changing the curve: splits the segment by de Casteljau's triangle at the parameter of
 * the time. The new key has the bits of nkw_handle_sample. A time outside the segment is clamped. left and right may be
 * the input.
 */
NKW_API void nkw_handle_split(const nkw_handle_segment *segment, float time, nkw_handle_segment *left,
                              nkw_handle_segment *right);

#ifdef __cplusplus
}
#endif

#endif
