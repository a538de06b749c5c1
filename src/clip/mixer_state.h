/* SPDX-License-Identifier: MIT */
/* What the parts of the mixer share: the weight of a slot, the range of its clip. */
#ifndef NAKAWARI_MIXER_STATE_H
#define NAKAWARI_MIXER_STATE_H

#include "lane/strict.h"

#include <nakawari/mixer.h>

#include "lane/scalar.h"

#include "clip_layout.h"

/* Weights of a sum from here on count as 1: sums of 16 rounded weights are within 2^-20 of theirs. */
#define MIXER_WHOLE       (1.0f - 0x1p-20f)
#define MIXER_MOST_WEIGHT 0x1p60f

/* Of nkw_mixer_slot.playing. ENDED is added to one of the others within an advance: the slot is freed before the mix. */
enum { MIXER_FREE = 0, MIXER_FRESH = 1, MIXER_RUNNING = 2, MIXER_ENDED = 4 };

static inline int mixer_plays(const nkw_mixer_slot *s)
{
    return s->playing == MIXER_FRESH || s->playing == MIXER_RUNNING;
}

static inline int mixer_is_added(const nkw_mixer_slot *s)
{
    return s->blend == NKW_MIXER_ADD;
}

/* The part of a clip that is played: seconds. */
typedef struct mixer_range {
    float start, end;
    double length;
} mixer_range;

static inline mixer_range mixer_range_of(const nkw_mixer_set *set, const nkw_mixer_slot *s)
{
    const nkw_mixer_clip *c = &set->clips[s->clip];
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

/* The first playing slot of a group; NULL if there is none. */
static inline const nkw_mixer_slot *mixer_leader(const nkw_mixer *m, uint32_t group)
{
    for (size_t i = 0; i < mixer_slot_count(m); i++)
        if (mixer_plays(&m->slot[i]) && m->slot[i].group == group)
            return &m->slot[i];
    return NULL;
}

/* The time of a slot of PHASE or MARKERS, from its leader. */
double nkwi_mixer_time_in_step(const nkw_mixer_set *set, const nkw_mixer_slot *leader, const nkw_mixer_slot *s);

/* Advances times and fades; slots that are faded out become MIXER_ENDED. */
void nkwi_mixer_move(nkw_mixer *m, const nkw_mixer_set *set, double seconds);

/* Reports the events between the times `from` of all slots and their times. */
void nkwi_mixer_report(const nkw_mixer *m, const nkw_mixer_set *set, const double *from, nkw_mixer_frame *frame);

/* ---- Poses ---- */

/* The working memory of a mix: `samples` poses, one after another, then a reference and their floats. */
typedef struct mixer_room {
    float *samples, *reference, *first, *velocities;
    float *sample_floats, *mean_floats, *reference_floats;
} mixer_room;

/* The roots of the slots at their times. */
typedef struct mixer_roots {
    nkw_trs motion[NKW_MIXER_SLOTS];
    double cycle[NKW_MIXER_SLOTS];
} mixer_roots;

/* The slots of a layer that are sampled at the same time, of the largest layer; at least 1. */
size_t nkwi_mixer_most_in_layer(const nkw_mixer *m);

/* Mixes the pose and the floats (NULL: none). */
void nkwi_mixer_mix(const nkw_mixer *m, const nkw_mixer_set *set, const mixer_room *room, nkw_pose_span pose,
                    float *floats, mixer_roots *roots);

/* Where the root of a slot is at its time, and at the ends of its clip. */
void nkwi_mixer_begin_root(nkw_mixer_slot *s, const nkw_mixer_set *set, const mixer_room *room);

/* The motion of the step to the roots, which become those of the slots. */
nkw_trs nkwi_mixer_take_motion(nkw_mixer *m, const nkw_mixer_set *set, const mixer_roots *roots);

/* Applies the transition of the pose to frame->pose, and keeps the pose that is shown. */
void nkwi_mixer_show(nkw_mixer *m, double seconds, const mixer_room *room, nkw_mixer_frame *frame);

#endif
