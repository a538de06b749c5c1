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
    const nkw_mixer_slot slot = {.clip = (uint32_t)clip};
    const mixer_range range = mixer_range_of(set, &slot);
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

static nkw_result check_fade(const nkw_mixer_fade *f)
{
    if (!is_finite64(f->elapsed) || !is_finite64(f->duration) || !lane_is_finite(f->from) || !lane_is_finite(f->to))
        return NKW_NOT_FINITE;
    return f->elapsed >= 0.0 && f->duration >= 0.0 ? NKW_OK : NKW_OUT_OF_RANGE;
}

static nkw_result check_slot(const nkw_mixer_set *set, const nkw_mixer_slot *s)
{
    if (s->playing == MIXER_FREE)
        return NKW_OK;
    if (s->playing > MIXER_RUNNING || s->clip >= set->clip_count || !has_mask(set, s->mask))
        return NKW_OUT_OF_RANGE;
    if (!is_finite64(s->time) || !is_finite64(s->cycle))
        return NKW_NOT_FINITE;
    const nkw_result fade = check_fade(&s->fade), counts = check_counts(set, s->clip);
    const nkw_mask_view mask = {NULL, 0};
    const nkw_mask_view used = set->mask_count ? set->masks[s->mask] : mask;
    if (fade != NKW_OK || counts != NKW_OK)
        return fade != NKW_OK ? fade : counts;
    return used.data && used.joint_count != set->rest.joint_count ? NKW_MISMATCHED : NKW_OK;
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

static int is_replaced(const nkw_mixer_slot *s, const nkw_mixer_options *o)
{
    return mixer_plays(s) && !mixer_is_added(s) && s->layer == o->layer && o->blend != NKW_MIXER_ADD &&
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
    const nkw_mixer_slot *leader = options->group ? mixer_leader(mixer, options->group) : NULL;
    nkw_mixer_slot *s = &mixer->slot[at];
    fill_slot(s, options, duration);
    if (leader && check_slot(set, leader) == NKW_OK)
        s->time = nkwi_mixer_time_in_step(set, leader, s);
    if (is_offset) {
        mixer->transition = options->transition;
        mixer->duration = (double)options->fade;
        mixer->pending = 1;
    }
    if (at == count)
        mixer->slot_count = (uint32_t)at + 1;
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

/* Divides the working memory. Returns 0 if it is too small. */
static int take_room(const nkw_mixer *m, const nkw_mixer_set *set, nkw_work work, mixer_room *room)
{
    const size_t pose = NKW_POSE_FLOATS(set->rest.joint_count), most = nkwi_mixer_most_in_layer(m);
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

static nkw_result check_advance(const nkw_mixer *m, const nkw_mixer_set *set, double seconds,
                                const nkw_mixer_frame *frame)
{
    if (seconds != seconds)
        return NKW_NOT_FINITE;
    if (!(seconds >= 0.0 && seconds <= MOST_SECONDS))
        return NKW_OUT_OF_RANGE;
    if (frame->pose.joint_count != set->rest.joint_count)
        return NKW_MISMATCHED;
    if (check_rest(set) != NKW_OK || check_root(set) != NKW_OK)
        return check_rest(set) != NKW_OK ? NKW_EMPTY : NKW_OUT_OF_RANGE;
    return nkw_mixer_validate(m, set, NULL);
}

/* Frees what has ended; the first frame of the others is over. */
static void settle_slots(nkw_mixer *m)
{
    for (size_t i = 0; i < m->slot_count; i++)
        if (m->slot[i].playing & MIXER_ENDED)
            memset(&m->slot[i], 0, sizeof m->slot[i]);
        else if (m->slot[i].playing)
            m->slot[i].playing = MIXER_RUNNING;
    while (m->slot_count > 0 && m->slot[m->slot_count - 1].playing == MIXER_FREE)
        m->slot_count--;
}

nkw_result nkw_mixer_advance(nkw_mixer *mixer, const nkw_mixer_set *set, double seconds, nkw_mixer_frame *frame,
                             nkw_work work)
{
    double from[NKW_MIXER_SLOTS];
    mixer_roots roots;
    mixer_room room;
    const nkw_result result = check_advance(mixer, set, seconds, frame);
    if (result != NKW_OK)
        return result;
    if (!take_room(mixer, set, work, &room) || (mixer->transition != NKW_MIXER_CROSS_FADE && !frame->poses))
        return NKW_TOO_SMALL;
    if (mixer->pending && mixer->shown) {
        const nkw_pose_span first = {room.first, frame->pose.joint_count};
        nkwi_mixer_mix(mixer, set, &room, first, NULL, &roots);
    }
    for (size_t i = 0; i < mixer->slot_count; i++) {
        nkw_mixer_slot *s = &mixer->slot[i];
        from[i] = s->time;
        if (s->playing == MIXER_FRESH && set->root_parts)
            nkwi_mixer_begin_root(s, set, &room);
    }
    nkwi_mixer_move(mixer, set, seconds);
    nkwi_mixer_report(mixer, set, from, frame);
    settle_slots(mixer);
    nkwi_mixer_mix(mixer, set, &room, frame->pose, frame->floats, &roots);
    frame->motion = set->root_parts ? nkwi_mixer_take_motion(mixer, set, &roots) : nkw_trs_identity();
    nkwi_mixer_show(mixer, seconds, &room, frame);
    return NKW_OK;
}
