/* SPDX-License-Identifier: MIT */
/*
 * Events of a mixer. An event at the time t of a clip is passed at t + n length, n any integer. N(x) is the number of
 * these times up to x, from any fixed one on. A step from x to y passes N(y) - N(x) of them: what steps pass is the same
 * however a way is divided, because N depends on one end only.
 */
#include "mixer_state.h"

/* An event passed more often in one step is counted as this. */
#define MOST_PASSES 0x1p24

/* The times at which a mark is passed: t + n period; without a period t alone. Ping-pong has two of them. */
typedef struct mixer_times {
    double t[2], period;
    int count;
} mixer_times;

static mixer_times times_of(const nkw_mixer_slot *s, double length, double t)
{
    mixer_times times = {{t, 0.0}, 0.0, 1};
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
    double n = 0.0;
    for (int k = 0; k < times->count; k++)
        n += times->period > 0.0 ? lane_floor64((x - times->t[k]) / times->period) : x >= times->t[k] ? 1.0 : 0.0;
    return n;
}

static double below(const mixer_times *times, double x)
{
    double n = 0.0;
    for (int k = 0; k < times->count; k++)
        n += times->period > 0.0 ? -1.0 - lane_floor64((times->t[k] - x) / times->period) : x > times->t[k] ? 1.0 : 0.0;
    return n;
}

static size_t number(double n)
{
    return n > 0.0 ? (size_t)(n < MOST_PASSES ? n : MOST_PASSES) : 0;
}

/* The step of a slot, and the event that is looked at. */
typedef struct mixer_step {
    double from, to;
    int is_fresh, has_ended;
    nkw_mixer_event event;
    nkw_mixer_frame *frame;
} mixer_step;

static void emit(mixer_step *step, nkw_mixer_event_kind kind, size_t n)
{
    nkw_mixer_frame *frame = step->frame;
    step->event.kind = kind;
    for (size_t i = frame->event_count; i < frame->event_capacity && i - frame->event_count < n; i++)
        frame->events[i] = step->event;
    frame->event_count = n <= SIZE_MAX - frame->event_count ? frame->event_count + n : SIZE_MAX;
}

static void report_instant(mixer_step *step, const mixer_times *times)
{
    const int backwards = step->to < step->from;
    const double low = backwards ? step->to : step->from, high = backwards ? step->from : step->to;
    const double until = backwards && !step->is_fresh ? below(times, high) : upto(times, high);
    const double since = backwards || step->is_fresh ? below(times, low) : upto(times, low);
    emit(step, NKW_MIXER_PASSED, number(until - since));
}

/* The interval is [begin, end) in both directions, so that what is entered is left. */
static void report_interval(mixer_step *step, const mixer_times *begin, const mixer_times *end)
{
    const double b0 = upto(begin, step->from), b1 = upto(begin, step->to);
    const double e0 = upto(end, step->from), e1 = upto(end, step->to);
    const int backwards = step->to < step->from;
    const size_t inside = number(b0 - e0);
    size_t entered = number(backwards ? e0 - e1 : b1 - b0) + (step->is_fresh ? inside : 0);
    size_t left = number(backwards ? b0 - b1 : e1 - e0) + (step->has_ended ? number(b1 - e1) : 0);
    int leaves = inside > 0 && !step->is_fresh;
    while (entered > 0 && left > 0 && step->frame->event_count < step->frame->event_capacity) {
        emit(step, leaves ? NKW_MIXER_LEFT : NKW_MIXER_ENTERED, 1);
        entered -= !leaves;
        left -= (size_t)leaves;
        leaves = !leaves;
    }
    emit(step, leaves ? NKW_MIXER_LEFT : NKW_MIXER_ENTERED, leaves ? left : entered);
    emit(step, leaves ? NKW_MIXER_ENTERED : NKW_MIXER_LEFT, leaves ? entered : left);
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
    end.t[0] = t + duration;
    if (length > 0.0 && s->mode == NKW_PLAYBACK_PING_PONG) {
        const double e = t + duration < length ? t + duration : length;
        end.t[0] = e;
        begin.t[1] = 2.0 * length - e;
        end.t[1] = 2.0 * length - t;
        begin.count = end.count = 2;
    }
    report_interval(step, &begin, &end);
}

static void report_slot(const nkw_mixer_set *set, const nkw_mixer_slot *s, mixer_step *step)
{
    const nkw_mixer_clip *clip = &set->clips[s->clip];
    const mixer_range range = mixer_range_of(set, s);
    for (size_t i = 0; i < clip->event_count; i++) {
        const double t = (double)clip->events[i].time - (double)range.start;
        step->event.event = (uint32_t)i;
        if (t >= 0.0 && t <= range.length)
            report_mark(step, s, range.length, t, (double)clip->events[i].duration);
    }
}

void nkwi_mixer_report(const nkw_mixer *m, const nkw_mixer_set *set, const double *from, nkw_mixer_frame *frame)
{
    frame->event_count = 0;
    for (size_t i = 0; i < m->slot_count; i++) {
        const nkw_mixer_slot *s = &m->slot[i];
        if (s->playing == MIXER_FREE || set->clips[s->clip].event_count == 0)
            continue;
        mixer_step step = {from[i],
                           s->time,
                           (s->playing & MIXER_FRESH) != 0,
                           (s->playing & MIXER_ENDED) != 0,
                           {(uint32_t)i, s->clip, 0, NKW_MIXER_PASSED, mixer_weight(s)},
                           frame};
        report_slot(set, s, &step);
    }
}
