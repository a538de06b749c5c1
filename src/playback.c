/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/playback.h>

#include "lane/scalar.h"
#include "playback_cycle.h"

static int is_positive(float x)
{
    return x > 0.0f && lane_is_finite(x);
}

/*
 * start + r in binary32. If that rounds up to the end, returns the start of the next cycle instead: then
 * time + cycle duration stays continuous.
 */
static nkw_play_head looped(float start, double r, float duration, double cycle)
{
    float time = (float)((double)start + r);
    float end = (float)((double)start + (double)duration);
    nkw_play_head here = {time, (float)cycle}, next = {start, (float)(cycle + 1.0)};
    return time > start && time >= end ? next : here;
}

static float clamped(float start, float duration, float time)
{
    float end = (float)((double)start + (double)duration);
    return time < start ? start : time > end ? end : time;
}

nkw_play_head nkw_playback_head(nkw_playback mode, float start, float duration, float time)
{
    nkw_play_head head = {start, 0.0f};
    double cycle, x = (double)time - (double)start;
    if (!is_positive(duration) || x != x)
        return head;
    if (mode != NKW_PLAYBACK_LOOP && mode != NKW_PLAYBACK_PING_PONG) {
        head.time = clamped(start, duration, time);
        return head;
    }
    if (x - x != 0.0)
        return head;
    double r = playback_remainder(x, duration, &cycle);
    if (mode == NKW_PLAYBACK_LOOP)
        return looped(start, r, duration, cycle);
    double half = 0.5 * cycle;
    int odd = lane_floor64(half) != half;
    head.time = (float)((double)start + (odd ? (double)duration - r : r));
    head.cycle = (float)cycle;
    return head;
}

/* The keys passed in a step: `count` of them, the first `capacity` of which are stored in `out`. */
typedef struct passed {
    size_t *out;
    size_t capacity, count;
} passed;

/* Adds n * times to the count; SIZE_MAX on overflow. */
static void add_keys(passed *p, size_t n, size_t times)
{
    p->count = n == 0 || times <= (SIZE_MAX - p->count) / n ? p->count + n * times : SIZE_MAX;
}

/* Stores the keys first..end - 1. */
static void pass_keys(size_t first, size_t end, passed *p)
{
    size_t n = end > first ? end - first : 0;
    for (size_t i = 0; i < n && p->count + i < p->capacity; i++)
        p->out[p->count + i] = first + i;
    add_keys(p, n, 1);
}

/* The number of keys whose time is <= time. */
static size_t keys_until(const float *times, size_t count, double time)
{
    size_t k = 0;
    for (size_t n = count; n > 0;) {
        size_t half = n / 2;
        int until = (double)times[k + half] <= time;
        k += until ? half + 1 : 0;
        n = until ? n - half - 1 : half;
    }
    return k;
}

/* The keys of one cycle in (from, to], both relative to the start of the cycle. */
static void pass(const float *times, size_t count, double from, double to, passed *p)
{
    pass_keys(keys_until(times, count, from), keys_until(times, count, to), p);
}

/*
 * The keys of the cycles first..last. The cycles first + 2..last - 2 contain every key. When `out` is full, they are
 * counted by one multiplication, so that the time does not depend on the number of cycles.
 */
static void passes(const float *times, size_t count, double duration, double first, double last, const double span[2],
                   passed *p)
{
    for (double n = first; n <= last; n += 1.0) {
        int is_whole = n >= first + 2.0 && n <= last - 2.0;
        if (is_whole && p->count >= p->capacity) {
            add_keys(p, count, (size_t)(last - 2.0 - n));
            n = last - 2.0;
        }
        if (is_whole)
            pass_keys(0, count, p);
        else
            pass(times, count, span[0] - n * duration, span[1] - n * duration, p);
    }
}

/* Whether the keys span more than one cycle: each key would be counted in several cycles. */
static int is_too_long(const nkw_playback_step *s)
{
    double first = s->times[0], last = s->times[s->key_count - 1];
    return !(last - first <= (double)s->duration);
}

static nkw_result pass_step(const nkw_playback_step *s, passed *p)
{
    const double span[2] = {s->from, s->to};
    if (!lane_is_finite(s->from) || !lane_is_finite(s->to) || !lane_is_finite(s->duration))
        return NKW_NOT_FINITE;
    if (s->duration < 0.0f)
        return NKW_OUT_OF_RANGE;
    if (!(s->from < s->to) || s->key_count == 0)
        return NKW_OK;
    if (s->duration == 0.0f) {
        pass(s->times, s->key_count, span[0], span[1], p);
        return NKW_OK;
    }
    if (is_too_long(s))
        return NKW_OUT_OF_RANGE;
    /* Cycle n contains the running times n duration + times[k]. The first and last cycle that meet the span: */
    double first = lane_floor64((span[0] - (double)s->times[s->key_count - 1]) / (double)s->duration);
    double last = lane_floor64((span[1] - (double)s->times[0]) / (double)s->duration);
    /* From 2^53 on, neighbouring whole numbers are not distinct in binary64. */
    if (!(first > -0x1p53 && last < 0x1p53 && last - first < 0x1p31))
        return NKW_OUT_OF_RANGE;
    passes(s->times, s->key_count, s->duration, first, last, span, p);
    return p->count < SIZE_MAX ? NKW_OK : NKW_TOO_MANY;
}

nkw_result nkw_playback_passed(const nkw_playback_step *step, size_t *keys, size_t *passed_count, size_t capacity)
{
    passed p = {keys, capacity, 0};
    nkw_result result = pass_step(step, &p);
    *passed_count = p.count;
    return result;
}
