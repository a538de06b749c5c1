/* SPDX-License-Identifier: MIT */
/*
 * Events of a mixer. An event at the time t of a clip is passed at t + n length, n any integer. N(x) is the number of
 * these times up to x, from any fixed one on. A step from x to y passes N(y) - N(x) of them: what steps pass is the
 * same however a way is divided, because N depends on one end only.
 */
#include "mixer_state.h"

/* An event passed more often in one step is counted as this. */
#define MOST_PASSES 0x1p24

/* An interval of whole cycles, to the rounding of its duration to float, ends when it begins again. */
#define WHOLE_CYCLE 0x1p-23

/*
 * The times at which a mark is passed: t + (n + whole) period; without a period t alone. Ping-pong has two of them. Ends of
 * intervals that are longer than the loop are `whole` cycles later.
 */
typedef struct mixer_times {
    double t[2], period, whole;
    int count;
} mixer_times;

static mixer_times times_of(const nkw_mixer_slot *s, double length, double t)
{
    mixer_times times = {{t, 0.0}, 0.0, 0.0, 1};
    if (length > 0.0 && s->mode == NKW_PLAYBACK_LOOP)
        times.period = length;
    if (length > 0.0 && s->mode == NKW_PLAYBACK_PING_PONG) {
        times.period = 2.0 * length;
        times.t[1] = 2.0 * length - t;
        times.count = t > 0.0 && t < length ? 2 : 1;
    }
    return times;
}

/* The number of times that are at most x; or less than x. */
static double upto(const mixer_times *times, double x)
{
    double n = -times->whole;
    for (int k = 0; k < times->count; k++)
        n += times->period > 0.0 ? lane_floor64((x - times->t[k]) / times->period) : x >= times->t[k] ? 1.0 : 0.0;
    return n;
}

static double below(const mixer_times *times, double x)
{
    double n = -times->whole;
    for (int k = 0; k < times->count; k++)
        n += times->period > 0.0 ? -1.0 - lane_floor64((times->t[k] - x) / times->period) : x > times->t[k] ? 1.0 : 0.0;
    return n;
}

/*
 * The time of pass n, the one with which the numbers above become n. The passes of each cycle, or the single one, are
 * consecutive: t[0] first.
 */
static double time_of_pass(const mixer_times *times, double n)
{
    const double count = (double)times->count, place = n + times->whole + count - 1.0;
    const double cycle = lane_floor64(place / count);
    return times->t[place - cycle * count > 0.0] + cycle * times->period;
}

static size_t number(double n)
{
    return n > 0.0 ? (size_t)(n < MOST_PASSES ? n : MOST_PASSES) : 0;
}

/* The step of a slot, and the event that is looked at. */
typedef struct mixer_step {
    double from, to, seconds;
    int is_fresh, has_ended;
    nkw_mixer_event event;
    nkw_mixer_frame *frame;
} mixer_step;

/* The share of the step at which a slot of constant speed is at the running time x. */
static double share_at(const mixer_step *step, double x)
{
    const double way = step->to - step->from, share = way != 0.0 ? (x - step->from) / way : 0.0;
    return share > 0.0 ? share < 1.0 ? share : 1.0 : 0.0;
}

static int is_later(const nkw_mixer_event *a, const nkw_mixer_event *b)
{
    return a->moment > b->moment || (a->moment == b->moment && a->slot > b->slot);
}

/* Of those that do not fit, the last ones are left out. */
static void report(mixer_step *step, nkw_mixer_event_kind kind, double share)
{
    nkw_mixer_event *events = step->frame->events;
    const size_t capacity = step->frame->event_capacity, count = step->frame->event_count++;
    size_t k = count < capacity ? count : capacity;
    step->event.kind = kind;
    step->event.moment = (float)(share * step->seconds);
    for (; k > 0 && is_later(&events[k - 1], &step->event); k--)
        if (k < capacity)
            events[k] = events[k - 1];
    if (k < capacity)
        events[k] = step->event;
}

/* The reports of a mark that may fit: the first ones. The others are only counted, by count_rest. */
static size_t most_of(const mixer_step *step, size_t n)
{
    return n < step->frame->event_capacity ? n : step->frame->event_capacity;
}

static void count_rest(const mixer_step *step, size_t n)
{
    const size_t rest = n - most_of(step, n), room = SIZE_MAX - step->frame->event_count;
    step->frame->event_count += rest < room ? rest : room;
}

static void report_instant(mixer_step *step, const mixer_times *times)
{
    const int backwards = step->to < step->from;
    const double low = backwards ? step->to : step->from, high = backwards ? step->from : step->to;
    const double until = backwards && !step->is_fresh ? below(times, high) : upto(times, high);
    const double since = backwards || step->is_fresh ? below(times, low) : upto(times, low);
    const size_t n = number(until - since), most = most_of(step, n);
    for (size_t i = 0; i < most; i++) {
        const double pass = backwards ? until - (double)i : since + 1.0 + (double)i;
        report(step, NKW_MIXER_PASSED, share_at(step, time_of_pass(times, pass)));
    }
    count_rest(step, n);
}

/* The reports of one kind: first `begun` at the beginning of the step, then those of passes, then at its end. */
typedef struct mixer_bound {
    const mixer_times *times;
    double before; /* the number of passes at the beginning of the step */
    size_t begun, passed, count;
} mixer_bound;

static mixer_bound bound_of(const mixer_times *times, double before, double after, size_t begun, size_t ended)
{
    const size_t passed = number(lane_abs64(after - before));
    const mixer_bound bound = {times, before, begun, passed, begun + passed + ended};
    return bound;
}

static double share_of(const mixer_step *step, const mixer_bound *b, size_t i)
{
    const double k = (double)(i < b->begun ? 0 : i - b->begun);
    const double pass = step->to < step->from ? b->before - k : b->before + 1.0 + k;
    if (i < b->begun)
        return 0.0;
    return i < b->begun + b->passed ? share_at(step, time_of_pass(b->times, pass)) : 1.0;
}

/* The interval is [begin, end) in both directions, so that what is entered is left. */
static void report_interval(mixer_step *step, const mixer_times *begin, const mixer_times *end)
{
    const double b0 = upto(begin, step->from), b1 = upto(begin, step->to);
    const double e0 = upto(end, step->from), e1 = upto(end, step->to);
    const int backwards = step->to < step->from;
    const size_t inside = number(b0 - e0), fresh = step->is_fresh ? inside : 0;
    const size_t ended = step->has_ended ? number(b1 - e1) : 0;
    const mixer_bound enter = backwards ? bound_of(end, e0, e1, fresh, 0) : bound_of(begin, b0, b1, fresh, 0);
    const mixer_bound leave = backwards ? bound_of(begin, b0, b1, 0, ended) : bound_of(end, e0, e1, 0, ended);
    const size_t n = enter.count + leave.count, most = most_of(step, n);
    int leaves = inside > 0 && !step->is_fresh;
    for (size_t entered = 0, left = 0; entered + left < most;) {
        leaves = left < leave.count && (leaves || entered == enter.count);
        if (leaves)
            report(step, NKW_MIXER_LEFT, share_of(step, &leave, left++));
        else
            report(step, NKW_MIXER_ENTERED, share_of(step, &enter, entered++));
        leaves = !leaves;
    }
    count_rest(step, n);
}

/* Ping-pong meets the interval [t, e] again as [2 length - e, 2 length - t]: begins and ends are exchanged. */
static void report_mark(mixer_step *step, const nkw_mixer_slot *s, double length, double t, double duration)
{
    if (!(duration > 0.0)) {
        const mixer_times times = times_of(s, length, t);
        report_instant(step, &times);
        return;
    }
    mixer_times begin = times_of(s, length, t), end = begin;
    if (begin.period > 0.0)
        end.whole = lane_floor64(duration / begin.period * (1.0 + WHOLE_CYCLE));
    const double part = duration - end.whole * begin.period;
    end.t[0] = t + (part > duration * WHOLE_CYCLE ? part : 0.0);
    if (length > 0.0 && s->mode == NKW_PLAYBACK_PING_PONG) {
        const double e = t + duration < length ? t + duration : length;
        end.t[0] = e;
        end.whole = 0.0;
        begin.t[1] = 2.0 * length - e;
        end.t[1] = 2.0 * length - t;
        begin.count = end.count = 2;
    }
    report_interval(step, &begin, &end);
}

/* The step of a loop from the start of the cycle in which it begins, and MARGIN_CYCLES more; or all times. */
typedef struct mixer_span {
    double low, high, period;
} mixer_span;

/* Of less than 2^24 cycles: the roundings of the division and of the differences are less than 2^-26 cycles. */
#define MOST_CYCLES   0x1p24
#define MARGIN_CYCLES 0x1p-20

static mixer_span span_of(const mixer_voice *v)
{
    const double to = v->slot->time, length = v->range.length;
    const double low = v->from < to ? v->from : to, high = v->from < to ? to : v->from;
    const double most = MOST_CYCLES * length, margin = MARGIN_CYCLES * length;
    mixer_span span = {-INFINITY, INFINITY, length};
    if (v->slot->mode == NKW_PLAYBACK_LOOP && low > -most && high < most) {
        const double start = lane_floor64(low / length) * length;
        span.low = low - start - margin;
        span.high = high - start + margin;
    }
    return span;
}

/* Whether t, of 0..period, and all t + n period are outside: N is the same at both ends of the step. */
static int is_outside(const mixer_span *span, double t)
{
    return t < span->low ? t + span->period > span->high : t > span->high && t - span->period < span->low;
}

void nkwi_mixer_report(const mixer_voices *all, const nkw_mixer_slot *slots, nkw_mixer_frame *frame)
{
    for (const mixer_voice *v = all->voice; v < all->voice + all->count; v++) {
        const nkw_mixer_slot *s = v->slot;
        if (v->clip->event_count == 0)
            continue;
        const mixer_span span = span_of(v);
        mixer_step step = {v->from,      s->time,
                           v->seconds,   s->playing == MIXER_FRESH,
                           v->has_ended, {(uint32_t)(s - slots), s->clip, 0, NKW_MIXER_PASSED, v->weight, 0.0f},
                           frame};
        for (size_t i = 0; i < v->clip->event_count; i++) {
            const double t = (double)v->clip->events[i].time - (double)v->range.start;
            const double duration = (double)v->clip->events[i].duration;
            step.event.event = (uint32_t)i;
            if (t >= 0.0 && t <= v->range.length && !(duration == 0.0 && is_outside(&span, t)))
                report_mark(&step, s, v->range.length, t, duration);
        }
    }
}
