/* SPDX-License-Identifier: MIT */
/* Checks, play, stop, advance. Times are in mixer_time.c, events in mixer_events.c, poses in mixer_pose.c. */
#include "mixer_state.h"

#include <string.h>

#include <nakawari/transform.h>

#include "report.h"
#include "work.h"

#define MOST_SECONDS 0x1p30

static int is_finite64(double x)
{
    return x - x == 0.0;
}

/* ---- Checks of a set ---- */

static nkw_result check_marks(const nkw_mixer_clip *c, float start, float end)
{
    for (size_t i = 0; i < c->event_count; i++) {
        if (!lane_is_finite(c->events[i].time) || !lane_is_finite(c->events[i].duration))
            return NKW_NOT_FINITE;
        if (c->events[i].duration < 0.0f)
            return NKW_OUT_OF_RANGE;
    }
    for (size_t i = 0; i < c->marker_count; i++) {
        if (!lane_is_finite(c->markers[i]))
            return NKW_NOT_FINITE;
        if (c->markers[i] < start || c->markers[i] >= end)
            return NKW_OUT_OF_RANGE;
        if (i > 0 && c->markers[i] < c->markers[i - 1])
            return NKW_NOT_ASCENDING;
    }
    return NKW_OK;
}

/* What must hold so that sampling is safe. */
static nkw_result check_counts(const nkw_mixer_set *set, size_t clip)
{
    const nkw_mixer_clip *c = &set->clips[clip];
    const size_t joints = set->rest.joint_count;
    if (!c->clip)
        return NKW_EMPTY;
    if (c->clip->joints != joints || c->clip->floats != set->float_count)
        return NKW_MISMATCHED;
    return c->reference.data && c->reference.joint_count != joints ? NKW_MISMATCHED : NKW_OK;
}

static nkw_result check_clip(const nkw_mixer_set *set, size_t clip)
{
    const nkw_mixer_clip *c = &set->clips[clip];
    const nkw_result counts = check_counts(set, clip);
    if (counts != NKW_OK)
        return counts;
    if (!lane_is_finite(c->start) || !lane_is_finite(c->end))
        return NKW_NOT_FINITE;
    if (c->end < c->start)
        return NKW_OUT_OF_RANGE;
    const mixer_range range = mixer_range_of(c);
    return check_marks(c, range.start, range.end);
}

static nkw_result check_mask(const nkw_mixer_set *set, size_t mask)
{
    if (set->masks[mask].data && set->masks[mask].joint_count != set->rest.joint_count)
        return NKW_MISMATCHED;
    return set->masks[mask].data ? nkw_mask_validate(set->masks[mask], NULL) : NKW_OK;
}

static nkw_result check_rest(const nkw_mixer_set *set)
{
    return set->rest.data && set->rest.joint_count > 0 ? NKW_OK : NKW_EMPTY;
}

static nkw_result check_root(const nkw_mixer_set *set)
{
    return set->root_parts && set->root >= set->rest.joint_count ? NKW_OUT_OF_RANGE : NKW_OK;
}

nkw_result nkw_mixer_set_validate(const nkw_mixer_set *set, size_t *bad)
{
    nkw_result result = check_rest(set);
    size_t offender = 0;
    for (size_t i = 0; result == NKW_OK && i < set->clip_count; i++) {
        result = check_clip(set, i);
        offender = i;
    }
    for (size_t i = 0; result == NKW_OK && i < set->mask_count; i++) {
        result = check_mask(set, i);
        offender = i;
    }
    if (result == NKW_OK) {
        result = check_root(set);
        offender = 0;
    }
    return report(result, offender, bad);
}

/* ---- Checks of a state ---- */

static int has_mask(const nkw_mixer_set *set, uint32_t mask)
{
    return set->mask_count ? mask < set->mask_count : mask == 0;
}

/* A number that is not finite makes its difference NaN, and with it the sum. */
static nkw_result check_times(const nkw_mixer_slot *s)
{
    const nkw_mixer_fade *f = &s->fade;
    const double zero = (s->time - s->time) + (s->cycle - s->cycle) + (f->elapsed - f->elapsed) +
                        (f->duration - f->duration) + (double)((f->from - f->from) + (f->to - f->to));
    if (zero != 0.0)
        return NKW_NOT_FINITE;
    return f->elapsed >= 0.0 && f->duration >= 0.0 ? NKW_OK : NKW_OUT_OF_RANGE;
}

static nkw_result check_slot(const nkw_mixer_set *set, const nkw_mixer_slot *s)
{
    if (s->playing == MIXER_FREE)
        return NKW_OK;
    if (s->playing > MIXER_RUNNING || s->clip >= set->clip_count || !has_mask(set, s->mask))
        return NKW_OUT_OF_RANGE;
    const nkw_result times = check_times(s), counts = check_counts(set, s->clip);
    const nkw_mask_view *mask = set->mask_count ? &set->masks[s->mask] : NULL;
    if (times != NKW_OK || counts != NKW_OK)
        return times != NKW_OK ? times : counts;
    return mask && mask->data && mask->joint_count != set->rest.joint_count ? NKW_MISMATCHED : NKW_OK;
}

static nkw_result check_transition(const nkw_mixer *m)
{
    if (m->transition < NKW_MIXER_CROSS_FADE || m->transition > NKW_MIXER_DEAD_BLEND)
        return NKW_BAD_METHOD;
    if (m->pending > 1 || m->shown > 2 || m->shown_at > 1 || m->slot_count > NKW_MIXER_SLOTS)
        return NKW_OUT_OF_RANGE;
    return is_finite64(m->elapsed) && is_finite64(m->duration) && lane_is_finite(m->step) ? NKW_OK : NKW_NOT_FINITE;
}

nkw_result nkw_mixer_validate(const nkw_mixer *mixer, const nkw_mixer_set *set, size_t *bad)
{
    nkw_result result = check_transition(mixer);
    size_t offender = 0;
    for (size_t i = 0; result == NKW_OK && i < mixer->slot_count; i++) {
        result = check_slot(set, &mixer->slot[i]);
        offender = i;
    }
    return report(result, offender, bad);
}

/* ---- Play and stop ---- */

static int is_choice(int value, int last)
{
    return value >= 0 && value <= last;
}

static nkw_result check_options(const nkw_mixer_set *set, const nkw_mixer_options *o)
{
    if (o->clip >= set->clip_count || !has_mask(set, o->mask))
        return NKW_OUT_OF_RANGE;
    if (!is_choice((int)o->mode, NKW_PLAYBACK_PING_PONG) || !is_choice((int)o->blend, NKW_MIXER_ADD) ||
        !is_choice((int)o->sync, NKW_MIXER_SYNC_MARKERS) || !is_choice((int)o->transition, NKW_MIXER_DEAD_BLEND))
        return NKW_BAD_METHOD;
    if (!lane_is_finite(o->fade) || !lane_is_finite(o->time))
        return NKW_NOT_FINITE;
    return o->fade >= 0.0f ? check_counts(set, o->clip) : NKW_OUT_OF_RANGE;
}

static void fade_to(nkw_mixer_slot *s, float to, float duration)
{
    const nkw_mixer_fade fade = {0.0, (double)duration, (float)mixer_fade_at(&s->fade, s->fade.elapsed), to};
    s->fade = fade;
}

/* A new slot takes its time from the first slot of its group. */
static void join_group(nkw_mixer *m, const nkw_mixer_set *set, nkw_mixer_slot *s)
{
    for (size_t i = 0; i < mixer_slot_count(m); i++) {
        nkw_mixer_slot *leader = &m->slot[i];
        if (leader == s || !leader->playing || leader->group != s->group)
            continue;
        if (check_slot(set, leader) != NKW_OK)
            return;
        mixer_voice first, own;
        mixer_voice_begin(&first, set, leader);
        mixer_voice_begin(&own, set, s);
        s->time = nkwi_mixer_time_in_step(&first, &own);
        return;
    }
}

static int is_replaced(const nkw_mixer_slot *s, const nkw_mixer_options *o)
{
    return s->playing && !mixer_is_added(s) && s->layer == o->layer && o->blend != NKW_MIXER_ADD &&
           o->transition != NKW_MIXER_FADE_IN;
}

static void fill_slot(nkw_mixer_slot *s, const nkw_mixer_options *o, float duration)
{
    memset(s, 0, sizeof *s);
    s->time = (double)o->time;
    s->motion = s->first = s->last = nkw_trs_identity();
    s->weight = s->speed = 1.0f;
    s->playing = MIXER_FRESH;
    s->clip = o->clip;
    s->mask = o->mask;
    s->layer = o->layer;
    s->group = o->group;
    s->sync = o->sync;
    s->mode = o->mode;
    s->blend = o->blend;
    fade_to(s, 1.0f, duration);
}

nkw_result nkw_mixer_play(nkw_mixer *mixer, const nkw_mixer_set *set, const nkw_mixer_options *options, size_t *slot)
{
    const int is_offset = options->transition == NKW_MIXER_INERTIA || options->transition == NKW_MIXER_DEAD_BLEND;
    const float duration = is_offset ? 0.0f : options->fade;
    const nkw_result result = check_options(set, options);
    const size_t count = mixer_slot_count(mixer);
    size_t at = 0;
    while (at < count && mixer->slot[at].playing)
        at++;
    if (result != NKW_OK || at == NKW_MIXER_SLOTS)
        return result != NKW_OK ? result : NKW_TOO_MANY;
    for (size_t i = 0; i < count; i++)
        if (is_replaced(&mixer->slot[i], options))
            fade_to(&mixer->slot[i], 0.0f, duration);
    nkw_mixer_slot *s = &mixer->slot[at];
    if (at == count)
        mixer->slot_count = (uint32_t)at + 1;
    memset(s, 0, sizeof *s);
    fill_slot(s, options, duration);
    if (options->group)
        join_group(mixer, set, s);
    if (is_offset) {
        mixer->transition = options->transition;
        mixer->duration = (double)options->fade;
        mixer->pending = 1;
    }
    if (slot)
        *slot = at;
    return NKW_OK;
}

nkw_result nkw_mixer_stop(nkw_mixer *mixer, size_t slot, float fade)
{
    if (!lane_is_finite(fade))
        return NKW_NOT_FINITE;
    if (slot >= mixer_slot_count(mixer) || !mixer->slot[slot].playing || fade < 0.0f)
        return NKW_OUT_OF_RANGE;
    fade_to(&mixer->slot[slot], 0.0f, fade);
    return NKW_OK;
}

/* ---- Advance ---- */

static void add_to_list(mixer_voices *all, const nkw_mixer_set *set, nkw_mixer_slot *s)
{
    mixer_voice *v = &all->voice[all->count++];
    mixer_voice_begin(v, set, s);
    const int is_fading = s->fade.elapsed < s->fade.duration || s->fade.to == 0.0f;
    if (is_fading || s->group || s->playing == MIXER_FRESH)
        all->is_steady = 0;
    all->has_events |= v->clip->event_count > 0;
    for (; v > all->voice && v[-1].rank > v->rank; v--) {
        const mixer_voice one = *v;
        v[0] = v[-1];
        v[-1] = one;
    }
}

/* Checks the slots and lists what plays. */
static nkw_result list_voices(nkw_mixer *m, const nkw_mixer_set *set, mixer_voices *all)
{
    nkw_result result = check_transition(m);
    all->count = 0;
    all->is_steady = 1;
    all->has_events = 0;
    for (size_t i = 0; result == NKW_OK && i < m->slot_count; i++) {
        if (m->slot[i].playing == MIXER_FREE)
            continue;
        result = check_slot(set, &m->slot[i]);
        if (result == NKW_OK)
            add_to_list(all, set, &m->slot[i]);
    }
    return result;
}

/* The number of slots of the largest layer, which are sampled at the same time; at least 1. */
static size_t most_in_layer(const mixer_voices *all)
{
    size_t most = 1, run = 1;
    for (size_t i = 1; i < all->count; i++) {
        run = all->voice[i].slot->layer == all->voice[i - 1].slot->layer ? run + 1 : 1;
        most = run > most ? run : most;
    }
    return most;
}

/* Divides the working memory. Returns 0 if it is too small. */
static int take_room(const nkw_mixer_set *set, size_t most, nkw_work work, mixer_room *room)
{
    const size_t pose = NKW_POSE_FLOATS(set->rest.joint_count);
    if (!work_fits(work, NKW_MIXER_WORK(most, set->rest.joint_count, set->float_count)))
        return 0;
    room->samples = (float *)work.data;
    room->reference = room->samples + most * pose;
    room->first = room->reference + pose;
    room->velocities = room->first + pose; /* 18 of 20 arrays */
    room->sample_floats = room->velocities + 2 * pose;
    room->mean_floats = room->sample_floats + set->float_count;
    room->reference_floats = room->mean_floats + set->float_count;
    return 1;
}

static nkw_result check_advance(const nkw_mixer_set *set, double seconds, const nkw_mixer_frame *frame)
{
    if (seconds != seconds)
        return NKW_NOT_FINITE;
    if (!(seconds >= 0.0 && seconds <= MOST_SECONDS))
        return NKW_OUT_OF_RANGE;
    if (frame->pose.joint_count != set->rest.joint_count)
        return NKW_MISMATCHED;
    return check_rest(set) != NKW_OK ? NKW_EMPTY : check_root(set);
}

/* Frees what has ended, which leaves the list; the first frame of the others is over. */
static void settle(nkw_mixer *m, mixer_voices *all)
{
    size_t count = 0;
    for (size_t i = 0; i < all->count; i++) {
        mixer_voice *v = &all->voice[i];
        if (v->has_ended)
            memset(v->slot, 0, sizeof *v->slot);
        else {
            v->slot->playing = MIXER_RUNNING;
            all->voice[count++] = *v;
        }
    }
    all->count = count;
    while (m->slot_count > 0 && m->slot[m->slot_count - 1].playing == MIXER_FREE)
        m->slot_count--;
}

static void step(nkw_mixer *m, mixer_voices *all, double seconds, nkw_mixer_frame *frame)
{
    frame->event_count = 0;
    if (all->is_steady) {
        mixer_move_steady(all, seconds);
        if (all->has_events)
            nkwi_mixer_report(all, m->slot, frame);
        return;
    }
    nkwi_mixer_move(all, seconds);
    for (size_t i = 0; i < all->count; i++)
        all->voice[i].weight = mixer_weight(all->voice[i].slot);
    nkwi_mixer_report(all, m->slot, frame);
    settle(m, all);
}

nkw_result nkw_mixer_advance(nkw_mixer *mixer, const nkw_mixer_set *set, double seconds, nkw_mixer_frame *frame,
                             nkw_work work)
{
    mixer_voices all;
    mixer_room room;
    nkw_result result = check_advance(set, seconds, frame);
    if (result == NKW_OK)
        result = list_voices(mixer, set, &all);
    if (result != NKW_OK)
        return result;
    if (!take_room(set, most_in_layer(&all), work, &room) ||
        (mixer->transition != NKW_MIXER_CROSS_FADE && !frame->poses))
        return NKW_TOO_SMALL;
    if (mixer->pending && mixer->shown) {
        const nkw_pose_span first = {room.first, frame->pose.joint_count};
        nkwi_mixer_mix(&all, set, &room, first, NULL);
    }
    for (size_t i = 0; set->root_parts && i < all.count; i++)
        if (all.voice[i].slot->playing == MIXER_FRESH)
            nkwi_mixer_begin_root(&all.voice[i], set, &room);
    step(mixer, &all, seconds, frame);
    nkwi_mixer_mix(&all, set, &room, frame->pose, frame->floats);
    frame->motion = set->root_parts ? nkwi_mixer_take_motion(&all, set) : nkw_trs_identity();
    if (frame->poses)
        nkwi_mixer_show(mixer, seconds, &room, frame);
    else
        mixer->shown = mixer->pending = 0;
    return NKW_OK;
}
