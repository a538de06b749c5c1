/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/playback.h>

#include "lane/arc.h"
#include "lane/scalar.h"
#include "playback_cycle.h"

/* A count as a number of cycles: infinite without a limit. */
static double limit_of(double count)
{
    double whole = lane_floor64(count);
    return whole >= 1.0 ? whole : (double)INFINITY;
}

/* Whether a whole number is odd; from 2^53 on all are even. */
static int is_odd_number(double n)
{
    double size = lane_abs64(n), half = 0.5 * (size >= 0x1p52 ? size - 0x1p52 : size);
    return lane_floor64(half) != half;
}

/* The state in a cycle, `remainder` seconds from its beginning. */
static nkw_play_head_f64 head_in(const nkw_playback_range *range, nkw_playback mode, double remainder, double cycle)
{
    double end = range->start + range->duration;
    int is_odd = mode == NKW_PLAYBACK_PING_PONG && is_odd_number(cycle), is_closing = remainder > range->duration;
    double place = is_odd ? range->duration - remainder : remainder, time = range->start + place;
    nkw_play_head_f64 head = {is_closing || time > end ? end : time, cycle, 0.0};
    if (is_closing)
        head.closing = (remainder - range->duration) / range->closing;
    return head;
}

/* The same; where the sum rounds up to the end of a loop, it is the start of the next cycle, if there is one. */
static nkw_play_head_f64 head_before_end(const nkw_playback_range *range, nkw_playback mode, double remainder,
                                         double cycle, double limit)
{
    nkw_play_head_f64 head = head_in(range, mode, remainder, cycle);
    double end = range->start + range->duration;
    int is_joined = mode == NKW_PLAYBACK_LOOP && !(range->closing > 0.0) && cycle < limit;
    return is_joined && head.time >= end && end > range->start ? head_in(range, mode, 0.0, cycle + 1.0) : head;
}

static nkw_play_head_f64 repeated(const nkw_playback_range *range, nkw_playback mode, double x, double limit)
{
    double closing = mode == NKW_PLAYBACK_LOOP && range->closing > 0.0 ? range->closing : 0.0;
    double period = range->duration + closing, quotient = x / period, cycle;
    nkw_play_head_f64 head = {range->start, 0.0, 0.0};
    /* From its last key on, the last cycle stays. */
    if (x >= 0.0 && limit < (double)INFINITY && (x - range->duration) / period >= limit)
        return head_in(range, mode, range->duration, limit);
    if (x < 0.0 && limit < (double)INFINITY && -quotient >= limit)
        return head_in(range, mode, 0.0, -limit);
    if (!(quotient > -0x1p51 && quotient < 0x1p51 && period <= 0x1p900))
        return head;
    double remainder = playback_remainder(x, period, &cycle);
    /* The quotient above is rounded. */
    if (cycle > limit || (cycle == limit && remainder >= range->duration))
        return head_in(range, mode, range->duration, limit);
    return head_before_end(range, mode, remainder, cycle, limit);
}

nkw_play_head_f64 nkw_playback_head_f64(const nkw_playback_range *range, double time)
{
    nkw_play_head_f64 head = {range->start, 0.0, 0.0};
    double x = time - range->start;
    if (!(range->duration >= 0x1p-900 && range->duration <= 0x1p900) || x != x)
        return head;
    nkw_playback mode = x < 0.0 ? range->before : range->after;
    if (x >= 0.0 && x < range->duration)
        return head_before_end(range, range->after, x, 0.0, limit_of(range->after_cycles));
    if (mode != NKW_PLAYBACK_LOOP && mode != NKW_PLAYBACK_PING_PONG)
        return head_in(range, mode, x < 0.0 ? 0.0 : range->duration, 0.0);
    return repeated(range, mode, x, limit_of(x < 0.0 ? range->before_cycles : range->after_cycles));
}

/*
 * The head in binary64, rounded. Where the time of a loop rounds up to the end, the head is the start of the next cycle:
 * then time + cycle duration stays continuous.
 */
static nkw_play_head rounded(nkw_playback mode, float start, float duration, float time)
{
    const nkw_playback_range range = {(double)start, (double)duration, 0.0, mode, mode, 0.0, 0.0};
    nkw_play_head_f64 wide = nkw_playback_head_f64(&range, (double)time);
    nkw_play_head head = {(float)wide.time, (float)wide.cycle}, next = {start, (float)(wide.cycle + 1.0)};
    float end = (float)(range.start + range.duration);
    return mode == NKW_PLAYBACK_LOOP && head.time > start && head.time >= end ? next : head;
}

nkw_play_head nkw_playback_head(nkw_playback mode, float start, float duration, float time)
{
    nkw_play_head head = {start, 0.0f};
    float end = (float)((double)start + (double)duration);
    if (!(duration > 0.0f) || !lane_is_finite(duration) || time != time || start != start)
        return head;
    if (mode == NKW_PLAYBACK_LOOP || mode == NKW_PLAYBACK_PING_PONG)
        return rounded(mode, start, duration, time);
    head.time = time < start ? start : time > end ? end : time;
    return head;
}

/* ---- Values that continue ---- */

float nkw_playback_offset(float value, float first, float last, double cycle)
{
    double moved = (double)value + cycle * ((double)last - (double)first);
    return cycle == 0.0 ? value : (float)moved;
}

nkw_vec3 nkw_vec3_playback_offset(nkw_vec3 value, nkw_vec3 first, nkw_vec3 last, double cycle)
{
    nkw_vec3 r = {
        nkw_playback_offset(value.x, first.x, last.x, cycle),
        nkw_playback_offset(value.y, first.y, last.y, cycle),
        nkw_playback_offset(value.z, first.z, last.z, cycle),
    };
    return r;
}

nkw_quat nkw_quat_playback_offset(nkw_quat value, nkw_quat first, nkw_quat last, double cycle)
{
    lane_f64_quat a = lane_f64_quat_from(first);
    lane_f64_quat b = lane_f64_quat_aligned(a, lane_f64_quat_from(last), NKW_PATH_SHORT);
    lane_f64_vec3 half = lane_f64_quat_log(lane_f64_quat_mul(b, lane_f64_quat_conjugate(a)));
    lane_sincos turn = lane_turn64_long(cycle * lane_f64_vec3_length(half));
    lane_f64_quat c = lane_f64_quat_from_axis_half(lane_f64_vec3_normalize(half), turn);
    nkw_quat r = lane_quat_from_f64(lane_f64_quat_mul(c, lane_f64_quat_from(value)));
    return cycle == 0.0 ? value : r;
}

/* ---- Keys that are passed ---- */

/* The keys passed in a step: `count` of them, the first `capacity` of which are stored in `out`. */
typedef struct passed {
    size_t *out;
    size_t capacity, count;
    int is_backward;
    double margin; /* cycles: the number of the first and the last may be off by so much */
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
        p->out[p->count + i] = p->is_backward ? end - 1 - i : first + i;
    add_keys(p, n, 1);
}

/* The number of keys whose time is <= time; or < time. */
static size_t keys_until(const float *times, size_t count, double time, int is_below)
{
    size_t k = 0;
    for (size_t n = count; n > 0;) {
        size_t half = n / 2;
        double key = (double)times[k + half];
        int until = is_below ? key < time : key <= time;
        k += until ? half + 1 : 0;
        n = until ? n - half - 1 : half;
    }
    return k;
}

/*
 * The keys of one cycle in (low, high], backwards in [low, high), both relative to the start of the cycle; with the key
 * at `from`, the first end or backwards the last, in [low, high].
 */
static void pass(const nkw_playback_step *s, double low, double high, passed *p)
{
    int is_closed = s->includes_from != 0;
    pass_keys(keys_until(s->times, s->key_count, low, p->is_backward || is_closed),
              keys_until(s->times, s->key_count, high, p->is_backward && !is_closed), p);
}

/*
 * The keys of `cycles` cycles from `first` on, in the direction of play. All cycles except some at either end
 * contain every key. When `out` is full, they are counted by one multiplication, so that the time does not depend on
 * the number of cycles.
 */
static void passes(const nkw_playback_step *s, double first, double cycles, passed *p)
{
    double low = p->is_backward ? s->to : s->from, high = p->is_backward ? s->from : s->to;
    const double part = 2.0 + p->margin;
    for (double i = 0.0; i < cycles; i += 1.0) {
        double n = p->is_backward ? first - i : first + i;
        int is_whole = i >= part && i < cycles - part;
        if (is_whole && p->count >= p->capacity) {
            add_keys(p, s->key_count, (size_t)(cycles - part - i));
            i = cycles - part - 1.0;
        } else if (is_whole)
            pass_keys(0, s->key_count, p);
        else
            pass(s, low - n * s->duration, high - n * s->duration, p);
    }
}

/* Whether the keys span more than one cycle: each key would be counted in several cycles. */
static int is_too_long(const nkw_playback_step *s)
{
    double first = s->times[0], last = s->times[s->key_count - 1];
    return !(last - first <= s->duration);
}

static int is_finite64(double x)
{
    return x - x == 0.0;
}

static nkw_result pass_step(const nkw_playback_step *s, passed *p)
{
    double low = p->is_backward ? s->to : s->from, high = p->is_backward ? s->from : s->to;
    if (!is_finite64(s->from) || !is_finite64(s->to) || !is_finite64(s->duration))
        return NKW_NOT_FINITE;
    if (s->duration < 0.0)
        return NKW_OUT_OF_RANGE;
    if ((low == high && !s->includes_from) || s->key_count == 0)
        return NKW_OK;
    if (s->duration == 0.0) {
        pass(s, low, high, p);
        return NKW_OK;
    }
    if (is_too_long(s))
        return NKW_OUT_OF_RANGE;
    /* Cycle n contains the running times n duration + times[k]. The first and last cycle that meet the span: */
    double first = lane_floor64((low - (double)s->times[s->key_count - 1]) / s->duration) - p->margin;
    double last = lane_floor64((high - (double)s->times[0]) / s->duration) + p->margin;
    /* From 2^53 on, neighbouring whole numbers are not distinct in binary64. */
    if (!(first > -0x1p53 && last < 0x1p53 && last - first < 0x1p31))
        return NKW_OUT_OF_RANGE;
    passes(s, p->is_backward ? last : first, last - first + 1.0, p);
    return p->count < SIZE_MAX ? NKW_OK : NKW_TOO_MANY;
}

static int is_float(double x)
{
    return (double)(float)x == x;
}

/* Products of a duration of 24 bits are exact: no cycle is off. */
static double margin_of(const nkw_playback_step *s)
{
    return is_float(s->duration) && is_float(s->from) && is_float(s->to) ? 0.0 : 1.0;
}

nkw_result nkw_playback_passed(const nkw_playback_step *step, size_t *keys, size_t capacity, size_t *count)
{
    passed p = {keys, capacity, 0, step->to < step->from, margin_of(step)};
    nkw_result result = pass_step(step, &p);
    *count = p.count;
    return result == NKW_OK && p.count > capacity ? NKW_TOO_SMALL : result;
}
