/* SPDX-License-Identifier: MIT */
/*
 * The tracks of the source of a clip: checked, grouped and sorted.
 *
 * A track is constant if sampling returns the same bits at every time, otherwise animated. Only animated tracks are
 * members of groups; the value of a constant one is stored in a run.
 */
#ifndef NAKAWARI_CLIP_TRACKS_H
#define NAKAWARI_CLIP_TRACKS_H

#include <string.h>

#include <nakawari/clip.h>

#include "clip_layout.h"
#include "clip_packed.h"
#include "lane/scalar.h"
#include "track/track_keys.h"

#define CLIP_CONSTANT UINT32_MAX /* the timeline of a constant track */

typedef struct clip_tracks {
    const nkw_clip_source *source;
    uint32_t *by_group; /* tracks sorted by timeline, group, target and index; constant tracks are last */
    uint32_t *by_place; /* tracks sorted by target and index */
    uint32_t *timeline; /* of each track: the index in by_place of the first track with equal times, or CLIP_CONSTANT */
    int fills_gaps[NKW_CLIP_FLOATS]; /* whether gaps get lanes: of translations, of rotations, of scales */
    const clip_packing *packing; /* NULL: no track is packed */
} clip_tracks;

/*
 * Checks the source and sets `out`. Its three arrays are in `work`, NKW_CLIP_BUILD_WORK(track_count) bytes.
 * packing: NULL, or what to pack; clips with packed tracks have no gaps.
 */
nkw_result nkwi_clip_tracks_order(const nkw_clip_source *source, const clip_packing *packing, clip_tracks *out,
                                  size_t *bad, nkw_work work);

/* Whether a track is stored in a packed group. */
int nkwi_clip_tracks_is_packed(const clip_tracks *t, const nkw_clip_track *c);

/*
 * Whether a component of a track of floats has the same bits in all keys, and interpolation returns them. Such a float
 * is none of the tracks of a clip, although it has a lane.
 */
int nkwi_clip_tracks_is_still(const nkw_clip_track *c, size_t component);

/* nkw_clip_build, with packed tracks. */
nkw_result nkwi_clip_build(const nkw_clip_source *source, const clip_packing *packing, nkw_bytes_span block,
                           size_t *bytes, size_t *bad, nkw_work work);

/* Checks the target, width, kind and index of track c of the source s. */
nkw_result nkwi_clip_tracks_check_target(const nkw_clip_source *s, const nkw_clip_track *c);

/* The track of joint or float `index`, constant or animated; NULL if there is none. */
const nkw_clip_track *nkwi_clip_tracks_find(const clip_tracks *t, nkw_clip_target target, size_t index);

/* The animated track of joint or float `index`; NULL if there is none. */
const nkw_clip_track *nkwi_clip_tracks_find_animated(const clip_tracks *t, nkw_clip_target target, size_t index);

/* Whether two animated tracks are in the same group; 0 if either is NULL. */
int nkwi_clip_tracks_same_group(const clip_tracks *t, const nkw_clip_track *a, const nkw_clip_track *b);

/*
 * A gap is up to four neighbouring joints without an animated track, between two joints of one group or at one end of
 * the joints of a group. The joints of a gap get lanes in this group, with equal values in all keys, so that the lanes
 * are contiguous and are written by vector stores.
 *
 * Returns a neighbouring animated track of the group if the joint is in such a gap, otherwise NULL.
 */
const nkw_clip_track *nkwi_clip_tracks_find_gap(const clip_tracks *t, nkw_clip_target target, size_t joint);

/* A number for kind, interpolation, normalisation and packing; equal for the tracks of a group. */
uint32_t nkwi_clip_tracks_group(const clip_tracks *t, const nkw_clip_track *c);

/* The array 0..9 of a pose that contains the component. */
static inline size_t clip_array_of(nkw_clip_target target, size_t component)
{
    return component + (target == NKW_CLIP_ROTATION ? 3u : target == NKW_CLIP_SCALE ? 7u : 0u);
}

/* Whether two tracks have the same key times, bit for bit. */
static inline int clip_same_times(const nkw_track *a, const nkw_track *b)
{
    return a->count == b->count &&
           (a->count == 0 || a->times == b->times || memcmp(a->times, b->times, a->count * sizeof *a->times) == 0);
}

static inline int clip_is_normalized(const nkw_track *t)
{
    return t->kind == NKW_TRACK_ROTATION_NORMALIZED;
}

static inline int clip_is_minus_zero(float x)
{
    return lane_bits(x) == 0x80000000u;
}

/*
 * Whether interpolating from x to x returns the bits of x for every t. A lerp x + t (x - x) does for finite x, except
 * that it may return +0 for -0; slerp does for components of magnitude up to 2, of either zero.
 */
static inline int clip_is_invariant(nkw_clip_target target, float x)
{
    return target == NKW_CLIP_ROTATION ? x >= -2.0f && x <= 2.0f : lane_is_finite(x) && !clip_is_minus_zero(x);
}

static inline clip_kind clip_kind_of(const nkw_clip_track *c)
{
    return c->target == NKW_CLIP_ROTATION ? GROUP_ROTATIONS
           : c->target == NKW_CLIP_FLOATS ? GROUP_FLOATS
                                          : GROUP_NUMBERS;
}

/* The interpolation whose rows are stored. Tracks with a mode per key store LINEAR, or CUBICSPLINE if they are that. */
static inline nkw_interpolation clip_interpolation_of(const nkw_track *t)
{
    return t->key_interpolation && !track_is_cubic(t) ? NKW_INTERPOLATION_LINEAR : t->interpolation;
}

#endif
