/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <math.h>

#include <nakawari/fcurve.h>

#include "fcurve_segment.h"
#include "lane/scalar.h"
#include "playback_cycle.h"
#include "report.h"
#include "curve/segment_search.h"

static int is_finite_key(const nkw_fcurve_key *key)
{
    return lane_is_finite(key->time) && lane_is_finite(key->value) && lane_is_finite(key->in.time) &&
           lane_is_finite(key->in.value) && lane_is_finite(key->out.time) && lane_is_finite(key->out.value);
}

static nkw_result check_key(const nkw_fcurve *curve, size_t k)
{
    const nkw_fcurve_key *key = curve->keys + k;
    if ((unsigned)key->kind > NKW_FCURVE_EASE)
        return NKW_BAD_METHOD;
    if (key->kind == NKW_FCURVE_EASE && (unsigned)key->ease >= NKW_EASE_COUNT)
        return NKW_BAD_METHOD;
    if (!is_finite_key(key))
        return NKW_NOT_FINITE;
    return k > 0 && key->time < key[-1].time ? NKW_NOT_ASCENDING : NKW_OK;
}

nkw_result nkw_fcurve_validate(const nkw_fcurve *curve, size_t *bad)
{
    if (curve->key_count == 0)
        return report(NKW_EMPTY, 0, bad);
    if ((unsigned)curve->before > NKW_FCURVE_OUTSIDE_OSCILLATE ||
        (unsigned)curve->after > NKW_FCURVE_OUTSIDE_OSCILLATE || (unsigned)curve->policy > NKW_HANDLE_KEEP_START)
        return report(NKW_BAD_METHOD, 0, bad);
    nkw_result result = NKW_OK;
    size_t k = 0;
    while (k < curve->key_count && result == NKW_OK)
        result = check_key(curve, k++);
    return report(result, k - 1, bad);
}

static double time_at(const nkw_fcurve *curve, size_t k)
{
    return (double)curve->keys[k].time;
}

/*
 * The point at a time within the keys, of two keys or more. The search has the time as a float; where that rounds over
 * a key, the neighbouring segment is taken.
 */
static handle_point inside(const nkw_fcurve *curve, double time, uint32_t *cursor)
{
    segment_times times = {(const char *)&curve->keys->time, sizeof *curve->keys, curve->key_count};
    size_t k = segment_find_hint(times, (float)time, *cursor).index;
    while (k > 0 && time < time_at(curve, k))
        k--;
    *cursor = (uint32_t)k;
    return fcurve_point(curve->keys + k, curve->policy, time - time_at(curve, k));
}

static handle_point held(double value)
{
    handle_point r = {value, 0.0, 0.0};
    return r;
}

/* The line through the key at `end`: along its handle that points outwards, otherwise in the direction of the curve. */
static handle_point extended(const nkw_fcurve *curve, size_t end, double time, uint32_t *cursor)
{
    const nkw_fcurve_key *key = curve->keys + end;
    handle_point p = inside(curve, (double)key->time, cursor);
    nkw_handle outer = end == 0 ? key->in : key->out;
    if (key->kind == NKW_FCURVE_BEZIER && outer.time != 0.0f)
        p.first = (double)outer.value / (double)outer.time;
    p.second = 0.0;
    p.first = p.first - p.first == 0.0 ? p.first : 0.0;
    p.value = p.first != 0.0 ? p.value + p.first * (time - (double)key->time) : p.value;
    return p;
}

/* The point of cycle n at r seconds in it; n = 0 are the keys themselves. */
static handle_point in_cycle(const nkw_fcurve *curve, nkw_fcurve_outside mode, double n, double r, uint32_t *cursor)
{
    double first = time_at(curve, 0), last = time_at(curve, curve->key_count - 1), half = 0.5 * n;
    int is_mirrored = mode == NKW_FCURVE_OUTSIDE_OSCILLATE && lane_floor64(half) != half;
    handle_point p = inside(curve, is_mirrored ? last - r : first + r, cursor);
    if (is_mirrored)
        p.first = -p.first;
    if (mode == NKW_FCURVE_OUTSIDE_CYCLE_OFFSET)
        p.value += n * ((double)curve->keys[curve->key_count - 1].value - (double)curve->keys[0].value);
    return p;
}

/* Cycles outside the keys, at x seconds after the first key: x < 0 or x > d, the duration of a cycle. */
static handle_point cycled(const nkw_fcurve *curve, nkw_fcurve_outside mode, double x, double d, uint32_t *cursor)
{
    double n, before = -(double)curve->before_cycles, after = (double)curve->after_cycles;
    if (x < 0.0 && before < 0.0 && x < before * d)
        return held(in_cycle(curve, mode, before, 0.0, cursor).value);
    if (x > 0.0 && after > 0.0 && x >= (after + 1.0) * d)
        return held(in_cycle(curve, mode, after, d, cursor).value);
    double r = playback_remainder(x, d, &n);
    return in_cycle(curve, mode, n, r, cursor);
}

static handle_point outside(const nkw_fcurve *curve, float time, uint32_t *cursor)
{
    int is_before = time < curve->keys[0].time;
    size_t end = is_before ? 0 : curve->key_count - 1;
    nkw_fcurve_outside mode = is_before ? curve->before : curve->after;
    double first = time_at(curve, 0), d = time_at(curve, curve->key_count - 1) - first;
    if (!(d > 0.0) || mode == NKW_FCURVE_OUTSIDE_HOLD || (unsigned)mode > NKW_FCURVE_OUTSIDE_OSCILLATE)
        return held((double)curve->keys[end].value);
    if (mode == NKW_FCURVE_OUTSIDE_LINEAR)
        return extended(curve, end, (double)time, cursor);
    if (!lane_is_finite(time) || d - d != 0.0)
        return held((double)curve->keys[end].value);
    return cycled(curve, mode, (double)time - first, d, cursor);
}

nkw_motion nkw_fcurve_sample(const nkw_fcurve *curve, float time, uint32_t *cursor)
{
    const nkw_motion none = {0.0f, 0.0f, 0.0f};
    uint32_t own = 0, *at = cursor ? cursor : &own;
    if (curve->key_count == 0)
        return none;
    if (time != time)
        return handle_rounded(held((double)NAN));
    if (curve->key_count < 2)
        return handle_rounded(held((double)curve->keys[0].value));
    if (time >= curve->keys[0].time && time <= curve->keys[curve->key_count - 1].time)
        return handle_rounded(inside(curve, (double)time, at));
    return handle_rounded(outside(curve, time, at));
}

void nkw_fcurve_limit(const nkw_fcurve_key *keys, size_t count, nkw_handle_policy policy, nkw_fcurve_key *out)
{
    if (out != keys)
        for (size_t k = 0; k < count; k++)
            out[k] = keys[k];
    for (size_t k = 0; k + 1 < count; k++) {
        nkw_handle_segment s = fcurve_handles(out + k);
        if (out[k].kind != NKW_FCURVE_BEZIER)
            continue;
        s = nkw_handle_limit(&s, policy);
        out[k].out = s.out;
        out[k + 1].in = s.in;
    }
}

/* The new key, and the changed handles of its neighbours. */
static nkw_fcurve_key split_segment(nkw_fcurve_key around[2], nkw_handle_policy policy, float time)
{
    nkw_fcurve_key key = {time, 0.0f, {0.0f, 0.0f}, {0.0f, 0.0f}, around->kind, around->ease};
    nkw_handle_segment whole = fcurve_handles(around), left, right;
    key.value = (float)fcurve_point(around, policy, (double)time - (double)around->time).value;
    if (around->kind != NKW_FCURVE_BEZIER)
        return key;
    whole = nkw_handle_limit(&whole, policy);
    nkw_handle_split(&whole, time, &left, &right);
    around[0].out = left.out;
    key.in = left.in;
    key.out = right.out;
    around[1].in = right.in;
    return key;
}

nkw_result nkw_fcurve_insert(const nkw_fcurve *curve, float time, nkw_fcurve_key *out, size_t *index)
{
    size_t count = curve->key_count;
    if (count < 2)
        return NKW_OUT_OF_RANGE;
    segment_times times = {(const char *)&curve->keys->time, sizeof *curve->keys, count};
    size_t k = segment_find(times, time).index;
    if (!(time > curve->keys[k].time && time < curve->keys[k + 1].time))
        return NKW_OUT_OF_RANGE;
    nkw_fcurve_key around[2] = {curve->keys[k], curve->keys[k + 1]};
    if (around->kind == NKW_FCURVE_EASE)
        return NKW_BAD_METHOD;
    for (size_t i = count; i > k + 1; i--)
        out[i] = curve->keys[i - 1];
    for (size_t i = 0; i < k && out != curve->keys; i++)
        out[i] = curve->keys[i];
    out[k + 1] = split_segment(around, curve->policy, time);
    out[k] = around[0];
    out[k + 2] = around[1];
    *index = k + 1;
    return NKW_OK;
}
