/* SPDX-License-Identifier: MIT */
/* Looks over a block before it is sampled: everything that sampling reads or writes must lie inside. */
#include "lane/strict.h"

#include <nakawari/clip.h>
#include <nakawari/segment.h>

#include "clip_layout.h"
#include "lane/scalar.h"

/*
 * A block to look over; how many of its words no part has taken: no two share one, so the work is bounded; and how many
 * numbers of the pose and of the floats its parts write. These bound what the clip may claim to hold.
 */
typedef struct opening {
    const nkw_clip *clip;
    uint64_t left, pose, floats;
} opening;

static void add_written(opening *o, uint32_t kind, uint64_t count)
{
    *(kind == GROUP_FLOATS ? &o->floats : &o->pose) += kind == GROUP_ROTATIONS ? 4 * count : count;
}

/* Takes count things of `size` words each, from word `at` on, if they lie within the block. */
static int fits(opening *o, uint64_t at, uint64_t count, uint64_t size)
{
    uint64_t words = count * size;
    if (at + words > o->clip->words || words > o->left)
        return 0;
    o->left -= words;
    return 1;
}

/* Floats of the output in one component that a group of the kind may write. */
static uint64_t room_of(const nkw_clip *clip, uint32_t kind)
{
    uint64_t stride = NKW_POSE_STRIDE((uint64_t)clip->joints);
    return kind == GROUP_FLOATS ? clip->floats : kind == GROUP_ROTATIONS ? stride : 10 * stride;
}

/* One width but for the last block; all places in the room. */
static nkw_result check_blocks(opening *o, const clip_group *g)
{
    if (!fits(o, g->blocks, g->block_count, sizeof(nkw_block) / 4))
        return NKW_OUT_OF_RANGE;
    const nkw_block *blocks = clip_blocks(o->clip, g);
    uint64_t room = room_of(o->clip, g->kind), lanes = 0;
    for (uint32_t i = 0; i < g->block_count; i++) {
        const nkw_block *b = &blocks[i];
        int is_last = i + 1 == g->block_count;
        if (b->width != NKW_BLOCK && (!is_last || (b->width != 4 && b->width != 8)))
            return NKW_OUT_OF_RANGE;
        int is_stretch = b->direct <= g->lanes - lanes && (b->direct % NKW_BLOCK == 0 || lanes + b->direct == g->lanes);
        if (b->count > b->width || !is_stretch || (b->direct && (uint64_t)b->places[0] + b->direct > room))
            return NKW_OUT_OF_RANGE;
        for (uint32_t k = 0; k < b->count; k++)
            if (b->places[k] >= room)
                return NKW_OUT_OF_RANGE;
        lanes += b->width;
        add_written(o, g->kind, b->count);
    }
    return lanes == g->lanes ? NKW_OK : NKW_OUT_OF_RANGE;
}

static nkw_result check_times(const clip_timeline *line, const float *times)
{
    for (uint32_t k = 0; k < line->count; k++) {
        if (!lane_is_finite(times[k]))
            return NKW_NOT_FINITE;
        if (k > 0 && times[k] < times[k - 1])
            return NKW_NOT_ASCENDING;
        if (line->rate != 0.0f && nkw_segment_uniform_time(times[0], line->rate, k) != times[k])
            return NKW_NOT_ASCENDING;
    }
    return NKW_OK;
}

static nkw_result check_timeline(opening *o, const clip_timeline *line)
{
    if (line->count == 0 || !fits(o, line->times, line->count, 1) ||
        (line->modes && !fits(o, line->modes, line->count, 1)))
        return NKW_OUT_OF_RANGE;
    return check_times(line, clip_floats(o->clip, line->times));
}

/* Modes of segments are for a group that serves them: one laid out as LINEAR, or as CUBICSPLINE. */
static int fits_modes(const nkw_clip *clip, const clip_timeline *line, const clip_group *g)
{
    uint32_t most =
        g->interpolation == NKW_INTERPOLATION_CUBICSPLINE ? NKW_INTERPOLATION_CUBICSPLINE : NKW_INTERPOLATION_STEP;
    for (uint32_t k = 0; line->modes && k < line->count; k++)
        if (g->interpolation == NKW_INTERPOLATION_STEP || clip_words(clip)[line->modes + k] > most)
            return 0;
    return 1;
}

static nkw_result check_group(opening *o, const clip_group *g)
{
    const nkw_clip *clip = o->clip;
    if (g->timeline >= clip->timeline_count || g->kind >= GROUP_KINDS ||
        g->interpolation > NKW_INTERPOLATION_CUBICSPLINE || g->lanes == 0 || g->lanes > clip->words)
        return NKW_OUT_OF_RANGE;
    if (g->normalized && g->kind != GROUP_ROTATIONS)
        return NKW_OUT_OF_RANGE;
    if (g->ranges && (g->interpolation == NKW_INTERPOLATION_CUBICSPLINE || g->lanes % 4 != 0 ||
                      !fits(o, g->ranges, g->lanes, 2 * clip_rows(g))))
        return NKW_OUT_OF_RANGE;
    const clip_timeline *line = clip_timelines(clip) + g->timeline;
    if (g->key_words != clip_key_words(g) || !fits(o, g->keys, line->count, g->key_words))
        return NKW_OUT_OF_RANGE;
    return fits_modes(clip, line, g) ? check_blocks(o, g) : NKW_OUT_OF_RANGE;
}

static nkw_result check_constants(opening *o, uint32_t at, uint32_t count, uint32_t kind)
{
    if (!fits(o, at, count, sizeof(clip_run) / 4))
        return NKW_OUT_OF_RANGE;
    const clip_run *runs = (const clip_run *)(const void *)(clip_words(o->clip) + at);
    for (uint32_t r = 0; r < count; r++) {
        if (!fits(o, runs[r].values, runs[r].count, 1) || (uint64_t)runs[r].to + runs[r].count > room_of(o->clip, kind))
            return NKW_OUT_OF_RANGE;
        add_written(o, kind, runs[r].count);
    }
    return NKW_OK;
}

static nkw_result check_parts(const nkw_clip *clip)
{
    opening o = {clip, clip->words, 0, 0};
    nkw_result result = NKW_OK;
    if (!fits(&o, clip->timelines, clip->timeline_count, sizeof(clip_timeline) / 4) ||
        !fits(&o, clip->groups, clip->group_count, sizeof(clip_group) / 4))
        return NKW_OUT_OF_RANGE;
    for (uint32_t i = 0; result == NKW_OK && i < clip->timeline_count; i++)
        result = check_timeline(&o, clip_timelines(clip) + i);
    for (uint32_t i = 0; result == NKW_OK && i < clip->group_count; i++)
        result = check_group(&o, clip_groups(clip) + i);
    if (result == NKW_OK)
        result = check_constants(&o, clip->constants, clip->constant_count, GROUP_NUMBERS);
    if (result == NKW_OK)
        result = check_constants(&o, clip->float_constants, clip->float_constant_count, GROUP_FLOATS);
    if (result == NKW_OK && (o.pose < 10 * (uint64_t)clip->joints || o.floats < clip->floats))
        result = NKW_OUT_OF_RANGE;
    return result;
}

static nkw_result check_head(const nkw_clip *clip)
{
    if (clip->joints > CLIP_MOST_JOINTS || clip->floats > CLIP_MOST_FLOATS)
        return NKW_OUT_OF_RANGE;
    if (!lane_is_finite(clip->start) || !lane_is_finite(clip->end))
        return NKW_NOT_FINITE;
    return clip->start <= clip->end ? NKW_OK : NKW_NOT_ASCENDING;
}

nkw_result nkw_clip_open(const void *block, size_t bytes, const nkw_clip **clip)
{
    const nkw_clip *head = (const nkw_clip *)block;
    *clip = NULL;
    if (bytes < sizeof *head)
        return NKW_TOO_SMALL;
    if ((uintptr_t)block % sizeof(float) != 0)
        return NKW_NOT_A_CLIP;
    if (head->magic != CLIP_MAGIC || head->version != CLIP_VERSION)
        return NKW_NOT_A_CLIP;
    if (bytes / 4 < head->words || head->words < sizeof *head / 4)
        return NKW_TOO_SMALL;
    nkw_result result = check_head(head);
    if (result == NKW_OK)
        result = check_parts(head);
    *clip = result == NKW_OK ? head : NULL;
    return result;
}
