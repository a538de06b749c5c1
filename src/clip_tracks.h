/* SPDX-License-Identifier: MIT */
/* The tracks of a clip to be built: checked, told apart, and put in order. */
#ifndef NAKAWARI_CLIP_TRACKS_H
#define NAKAWARI_CLIP_TRACKS_H

#include <string.h>

#include <nakawari/clip.h>

#include "clip_layout.h"

#define CLIP_CONSTANT UINT32_MAX /* in place of a timeline */

typedef struct clip_tracks {
    const nkw_clip_source *source;
    uint32_t *by_group; /* tracks by timeline, then by group, then by target and index; constant ones last */
    uint32_t *by_place; /* tracks by target and index */
    uint32_t *timeline; /* of each track: where in by_place the first with the same one is, or CLIP_CONSTANT */
    int bridges[NKW_CLIP_FLOATS]; /* whether gaps between translations, rotations, scales are bridged */
} clip_tracks;

/* Checks the source, and fills the three arrays in `work`, at least NKW_CLIP_WORK numbers. */
nkw_result nkw_clip_tracks_order(const nkw_clip_source *source, clip_tracks *out, size_t *bad_track, uint32_t *work,
                                 size_t work_count);

/* Whether track c may stand in the source s: its target, width and kind, and what it moves. */
nkw_result nkw_clip_tracks_place(const nkw_clip_source *s, const nkw_clip_track *c);

/* The track that moves joint or float `index`, or NULL. */
const nkw_clip_track *nkw_clip_tracks_of(const clip_tracks *t, nkw_clip_target target, size_t index);

/* The track that changes joint or float `index`, or NULL. */
const nkw_clip_track *nkw_clip_tracks_mover(const clip_tracks *t, nkw_clip_target target, size_t index);

/* Whether two tracks that change are of one group. */
int nkw_clip_tracks_same(const clip_tracks *t, const nkw_clip_track *a, const nkw_clip_track *b);

/*
 * A track beside a joint that nothing changes, whose group's lanes go on over it: in a gap of up to four joints between
 * those of the group, or at an end of them. Lanes without gaps are written as they stand. NULL where there is none.
 */
const nkw_clip_track *nkw_clip_tracks_beside(const clip_tracks *t, nkw_clip_target target, size_t joint);

/* What tracks of one timeline must have in common to be a group: equal numbers. */
uint32_t nkw_clip_tracks_group(const nkw_clip_track *c);

/* The component array of a pose in which a component stands. */
static inline size_t clip_array_of(nkw_clip_target target, size_t component)
{
    return component + (target == NKW_CLIP_ROTATION ? 3u : target == NKW_CLIP_SCALE ? 7u : 0u);
}

static inline int clip_is_cubic(const nkw_track *t)
{
    return t->interpolation == NKW_INTERPOLATION_CUBICSPLINE;
}

/* Whether two tracks have their keys at the same times, bit for bit. */
static inline int clip_same_times(const nkw_track *a, const nkw_track *b)
{
    return a->count == b->count &&
           (a->count == 0 || a->times == b->times || memcmp(a->times, b->times, a->count * sizeof *a->times) == 0);
}

static inline int clip_is_normalized(const nkw_track *t)
{
    return t->kind == NKW_TRACK_ROTATION_NORMALIZED;
}

static inline const float *clip_track_value(const nkw_track *t, size_t k)
{
    return t->values + (clip_is_cubic(t) ? (3 * k + 1) * t->width : k * t->width);
}

static inline clip_kind clip_kind_of(const nkw_clip_track *c)
{
    return c->target == NKW_CLIP_ROTATION ? GROUP_ROTATIONS
           : c->target == NKW_CLIP_FLOATS ? GROUP_FLOATS
                                          : GROUP_NUMBERS;
}

/* Tracks that choose key by key are laid out as LINEAR, which serves STEP too, or as CUBICSPLINE, which serves all. */
static inline nkw_interpolation clip_interpolation_of(const nkw_track *t)
{
    return t->key_interpolation && !clip_is_cubic(t) ? NKW_INTERPOLATION_LINEAR : t->interpolation;
}

#endif
