/* SPDX-License-Identifier: MIT */
/* What the parts of the mixer share: the weight of a slot, the range of its clip, the list of those that play. */
#ifndef NAKAWARI_MIXER_STATE_H
#define NAKAWARI_MIXER_STATE_H

#include "lane/strict.h"

#include <nakawari/mixer.h>

#include "lane/scalar.h"

#include "clip_layout.h"

/* Weights of a sum from here on count as 1: sums of 16 rounded weights are within 2^-20 of theirs. */
#define MIXER_WHOLE       (1.0f - 0x1p-20f)
#define MIXER_MOST_WEIGHT 0x1p60f

/* Of nkw_mixer_slot.playing. */
enum { MIXER_FREE = 0, MIXER_FRESH = 1, MIXER_RUNNING = 2 };

static inline int mixer_is_added(const nkw_mixer_slot *s)
{
    return s->blend == NKW_MIXER_ADD;
}

/* The part of a clip that is played: seconds. */
typedef struct mixer_range {
    float start, end;
    double length;
} mixer_range;

static inline mixer_range mixer_range_of(const nkw_mixer_clip *c)
{
    const int whole = c->start == 0.0f && c->end == 0.0f;
    mixer_range r = {whole ? c->clip->start : c->start, whole ? c->clip->end : c->end, 0.0};
    const double length = (double)r.end - (double)r.start;
    r.length = length > 0.0 ? length : 0.0;
    return r;
}

static inline double mixer_fade_at(const nkw_mixer_fade *f, double elapsed)
{
    const double from = (double)f->from, to = (double)f->to;
    return elapsed < f->duration ? from + (to - from) * (elapsed / f->duration) : to;
}

static inline float mixer_own_weight(const nkw_mixer_slot *s)
{
    const float w = s->weight > 0.0f ? s->weight : 0.0f;
    return w < MIXER_MOST_WEIGHT ? w : MIXER_MOST_WEIGHT;
}

static inline float mixer_weight(const nkw_mixer_slot *s)
{
    return mixer_own_weight(s) * (float)mixer_fade_at(&s->fade, s->fade.elapsed);
}

/* Of any state, also one that was not checked. */
static inline size_t mixer_slot_count(const nkw_mixer *m)
{
    return m->slot_count < NKW_MIXER_SLOTS ? m->slot_count : NKW_MIXER_SLOTS;
}

/* A slot that plays, within an advance. */
typedef struct mixer_voice {
    nkw_mixer_slot *slot;
    const nkw_mixer_clip *clip;
    uint64_t rank; /* twice the layer, plus one if it is added */
    mixer_range range;
    double from, seconds; /* its running time before the step; what it has played of the step */
    double cycle;
    nkw_trs motion; /* of the root, at the running time of the slot, in `cycle`; with root parts */
    float weight; /* of the slot, with its fade */
    int has_ended; /* faded out in this step */
} mixer_voice;

/* The slots that play, by rank, then by slot: all parts of an advance walk this list. */
typedef struct mixer_voices {
    mixer_voice voice[NKW_MIXER_SLOTS];
    size_t count;
    int is_steady; /* nothing but times changes: no fades, no groups, no first frames */
    int has_events;
} mixer_voices;

/* Of a slot that was checked. */
static inline void mixer_voice_begin(mixer_voice *v, const nkw_mixer_set *set, nkw_mixer_slot *s)
{
    v->slot = s;
    v->clip = &set->clips[s->clip];
    v->rank = 2 * (uint64_t)s->layer + (uint64_t)mixer_is_added(s);
    v->range = mixer_range_of(v->clip);
    v->from = s->time;
    v->seconds = 0.0;
    v->weight = mixer_weight(s);
    v->has_ended = 0;
}

static inline double mixer_speed(const nkw_mixer_slot *s)
{
    return lane_is_finite(s->speed) ? (double)s->speed : 0.0;
}

/* Of a slot without a group. */
static inline void mixer_move_alone(nkw_mixer_slot *s, double seconds)
{
    s->time += seconds * mixer_speed(s);
}

/* Of a list that is steady. */
static inline void mixer_move_steady(mixer_voices *all, double seconds)
{
    for (mixer_voice *v = all->voice; v < all->voice + all->count; v++) {
        mixer_move_alone(v->slot, seconds);
        v->seconds = seconds;
    }
}

/* The time of a slot of PHASE or MARKERS, from its leader. */
double nkwi_mixer_time_in_step(const mixer_voice *leader, const mixer_voice *v);

/* Advances times and fades. */
void nkwi_mixer_move(mixer_voices *all, double seconds);

/* Reports the events between the times `from` and the times of the slots, those of `slots[0]` being of slot 0. */
void nkwi_mixer_report(const mixer_voices *all, const nkw_mixer_slot *slots, nkw_mixer_frame *frame);

/* ---- Poses ---- */

/* The working memory of a mix: `samples` poses, one after another, then a reference and their floats. */
typedef struct mixer_room {
    float *samples, *reference, *first, *velocities;
    float *sample_floats, *mean_floats, *reference_floats;
} mixer_room;

/* Mixes the pose, the floats (NULL: none) and the motions of the voices. */
void nkwi_mixer_mix(mixer_voices *all, const nkw_mixer_set *set, const mixer_room *room, nkw_pose_span pose,
                    float *floats);

/* Where the root of a slot is at its time, and at the ends of its clip. */
void nkwi_mixer_begin_root(mixer_voice *v, const nkw_mixer_set *set, const mixer_room *room);

/* The motion of the step to the motions of the voices, which become those of the slots. */
nkw_trs nkwi_mixer_take_motion(mixer_voices *all, const nkw_mixer_set *set);

/* Applies the transition of the pose to frame->pose, and keeps the pose that is shown in frame->poses. */
void nkwi_mixer_show(nkw_mixer *m, double seconds, const mixer_room *room, nkw_mixer_frame *frame);

#endif
