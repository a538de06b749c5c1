/* SPDX-License-Identifier: MIT */
/* The tracks of a clip: listed, and taken out again. */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/clip.h>

#include "clip_keys.h"
#include "clip_layout.h"
#include "clip_sample.h"
#include "clip_tracks.h"

/* A track of a clip: the group of its lanes, and the place of its first number. */
typedef struct listed {
    const clip_group *group;
    nkw_clip_target target;
    uint32_t index, place;
} listed;

static size_t stride_of(const nkw_clip *clip)
{
    return NKW_POSE_STRIDE((size_t)clip->joints);
}

static const clip_timeline *timeline_of(const nkw_clip *clip, const clip_group *g)
{
    return clip_timelines(clip) + g->timeline;
}

static int is_cubic(const clip_group *g)
{
    return g->interpolation == NKW_INTERPOLATION_CUBICSPLINE;
}

/* The place of lane i of a block. */
static uint32_t place_of(const clip_block *block, uint32_t i)
{
    return block->contiguous ? block->place + i : block_places(block)[i];
}

/* The lane of a place; the number of lanes if the group does not write it. */
static size_t lane_of(const nkw_clip *clip, const clip_group *g, size_t place)
{
    size_t first = 0;
    for (const clip_block *b = clip_blocks(clip, g), *end = b + g->block_count; b < end; first += b++->width)
        for (uint32_t i = 0; i < b->count; i++)
            if (place_of(b, i) == place)
                return first + i;
    return g->lanes;
}

/* Whether a place is the first number of a property, and which. Padding of component arrays is none. */
static int begins_track(const nkw_clip *clip, const clip_group *g, uint32_t place, listed *out)
{
    out->group = g;
    out->place = out->index = place;
    out->target = NKW_CLIP_FLOATS;
    if (g->kind == GROUP_FLOATS)
        return 1;
    size_t array = place / stride_of(clip); /* joints are not 0, for the pose contains the place */
    out->index = (uint32_t)(place % stride_of(clip));
    out->target = g->kind == GROUP_ROTATIONS ? NKW_CLIP_ROTATION : array == 0 ? NKW_CLIP_TRANSLATION : NKW_CLIP_SCALE;
    return out->index < clip->joints && (array == 0 || (array == 7 && g->kind == GROUP_NUMBERS));
}

/* Whether a row of a lane has the same bits in all keys, and interpolation returns them: of a gap (clip_tracks.h). */
static int is_row_constant(const nkw_clip *clip, const listed *t, size_t row, size_t lane)
{
    const clip_group *g = t->group;
    const char *keys = (const char *)(clip_words(clip) + g->keys);
    size_t size = g->ranges ? sizeof(uint16_t) : sizeof(float), i = nkwi_clip_lane_at(g, clip_key_rows(g), row, lane);
    size_t at = size * i;
    if (!clip_is_invariant(t->target, clip_floats(clip, g->ranges ? g->ranges : g->keys)[i]))
        return 0;
    for (uint32_t k = 1; k < timeline_of(clip, g)->count; k++)
        if (memcmp(keys + at, keys + 4 * (size_t)k * g->key_words + at, size) != 0)
            return 0;
    return 1;
}

/* Groups of CUBICSPLINE and of packed keys have no gaps. */
static int is_gap(const nkw_clip *clip, const listed *t)
{
    const clip_group *g = t->group;
    if (is_cubic(g) || g->packed)
        return 0;
    for (size_t i = 0; i < (g->kind == GROUP_NUMBERS ? 3u : 1u); i++) {
        size_t lane = lane_of(clip, g, t->place + i * stride_of(clip));
        for (size_t row = 0; row < clip_rows(g); row++)
            if (lane == g->lanes || !is_row_constant(clip, t, row, lane))
                return 0;
    }
    return 1;
}

/* Finds track `index`. Returns 0 if it does not exist; *found is then the number of tracks. */
static int find(const nkw_clip *clip, size_t index, listed *out, size_t *found)
{
    *found = 0;
    for (uint32_t i = 0; i < clip->group_count; i++) {
        const clip_group *g = clip_groups(clip) + i;
        for (const clip_block *b = clip_blocks(clip, g), *end = b + g->block_count; b < end; b++)
            for (uint32_t lane = 0; lane < b->count; lane++)
                if (begins_track(clip, g, place_of(b, lane), out) && !is_gap(clip, out) && (*found)++ == index)
                    return 1;
    }
    return 0;
}

size_t nkw_clip_track_count(const nkw_clip *clip)
{
    size_t count;
    listed unused;
    return find(clip, SIZE_MAX, &unused, &count) ? 0 : count;
}

static nkw_clip_track shape_of(const nkw_clip *clip, const listed *t)
{
    const clip_timeline *line = timeline_of(clip, t->group);
    nkw_clip_track c;
    memset(&c, 0, sizeof c);
    c.target = t->target;
    c.index = t->index;
    c.track.times = clip_floats(clip, line->times);
    c.track.count = line->count;
    c.track.width = t->target == NKW_CLIP_FLOATS ? 1 : t->target == NKW_CLIP_ROTATION ? 4 : 3;
    c.track.kind = t->target != NKW_CLIP_ROTATION ? NKW_TRACK_FLOATS
                   : t->group->normalized         ? NKW_TRACK_ROTATION_NORMALIZED
                                                  : NKW_TRACK_ROTATION;
    c.track.interpolation = (nkw_interpolation)t->group->interpolation;
    return c;
}

nkw_result nkw_clip_track_shape(const nkw_clip *clip, size_t index, nkw_clip_track *out)
{
    listed t;
    size_t unused;
    if (!find(clip, index, &t, &unused))
        return NKW_OUT_OF_RANGE;
    *out = shape_of(clip, &t);
    return NKW_OK;
}

/* The triples of the keys, from the lanes of a CUBICSPLINE group. */
static nkw_result get_cubic(const nkw_clip *clip, const listed *t, const nkw_track *shape, float *values)
{
    const clip_group *g = t->group;
    int is_rotation = g->kind == GROUP_ROTATIONS;
    size_t part = clip_rows(g) * g->lanes;
    for (size_t i = 0; i < shape->width; i++) {
        size_t lane = lane_of(clip, g, t->place + (is_rotation ? 0 : i * stride_of(clip)));
        if (lane == g->lanes)
            return NKW_OUT_OF_RANGE;
        size_t at = nkwi_clip_lane_at(g, clip_rows(g), is_rotation ? i : 0, lane);
        for (size_t k = 0; k < shape->count; k++)
            for (size_t p = 0; p < 3; p++)
                values[(3 * k + p) * shape->width + i] = clip_floats(clip, g->keys)[k * g->key_words + p * part + at];
    }
    return NKW_OK;
}

/* The values of the keys, by a sample of the group at each. */
static void get_values(const nkw_clip *clip, const listed *t, const nkw_track *shape, float *values, float *work)
{
    const clip_group *g = t->group;
    size_t stride = stride_of(clip), pose = NKW_POSE_FLOATS((size_t)clip->joints);
    float *out = work + (g->kind == GROUP_FLOATS ? pose : g->kind == GROUP_ROTATIONS ? 3 * stride : 0);
    memset(work, 0, (pose + clip->floats) * sizeof *work);
    for (size_t k = 0; k < shape->count; k++) {
        int is_last = k + 1 == shape->count && k > 0;
        nkw_segment at = {is_last ? k - 1 : k, is_last ? 1.0f : 0.0f};
        nkwi_clip_sample_group(clip, g, timeline_of(clip, g), at, out, stride);
        for (size_t i = 0; i < shape->width; i++)
            values[k * shape->width + i] = out[t->place + i * stride];
    }
}

nkw_result nkw_clip_track_get(const nkw_clip *clip, size_t index, const nkw_edit_memory *memory, nkw_clip_track *out,
                              float *work, size_t work_count)
{
    listed t;
    size_t unused;
    if (!find(clip, index, &t, &unused))
        return NKW_OUT_OF_RANGE;
    nkw_clip_track c = shape_of(clip, &t);
    const uint32_t modes = timeline_of(clip, t.group)->modes;
    if (memory->key_capacity < c.track.count || (modes && !memory->key_interpolation) ||
        work_count < NKW_CLIP_TRACK_WORK((size_t)clip->joints, (size_t)clip->floats))
        return NKW_TOO_SMALL;
    nkw_result result = NKW_OK;
    if (is_cubic(t.group))
        result = get_cubic(clip, &t, &c.track, memory->values);
    else
        get_values(clip, &t, &c.track, memory->values, work);
    if (result != NKW_OK)
        return result;
    memcpy(memory->times, c.track.times, c.track.count * sizeof(float));
    for (size_t k = 0; modes && k < c.track.count; k++)
        memory->key_interpolation[k] = (unsigned char)clip_words(clip)[modes + k];
    c.track.times = memory->times;
    c.track.values = memory->values;
    c.track.key_interpolation = modes ? memory->key_interpolation : NULL;
    *out = c;
    return NKW_OK;
}
