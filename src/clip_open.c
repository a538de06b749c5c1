/* SPDX-License-Identifier: MIT */
/* Looks over a block before it is sampled: everything that sampling reads or writes must lie inside. */
#include "lane/strict.h"

#include <nakawari/clip.h>
#include <nakawari/segment.h>

#include "clip_layout.h"
#include "lane/scalar.h"

/* count things of `size` words each from word `at` on lie within the block. */
static int fits(const nkw_clip *clip, uint64_t at, uint64_t count, uint64_t size)
{
    return at + count * size <= clip->words;
}

/* Floats of the output in one component that a group of the kind may write. */
static uint64_t room_of(const nkw_clip *clip, uint32_t kind)
{
    uint64_t stride = NKW_POSE_STRIDE((uint64_t)clip->joints);
    return kind == GROUP_FLOATS ? clip->floats : kind == GROUP_ROTATIONS ? stride : 10 * stride;
}

static nkw_result check_runs(const nkw_clip *clip, uint32_t at, uint32_t count, uint64_t lanes, uint64_t room)
{
    if (!fits(clip, at, count, sizeof(nkw_run) / 4))
        return NKW_OUT_OF_RANGE;
    const nkw_run *runs = clip_runs(clip, at);
    for (uint32_t r = 0; r < count; r++)
        if ((uint64_t)runs[r].lane + runs[r].count > lanes || (uint64_t)runs[r].to + runs[r].count > room)
            return NKW_OUT_OF_RANGE;
    return NKW_OK;
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

static nkw_result check_timeline(const nkw_clip *clip, const clip_timeline *line)
{
    if (line->count == 0 || !fits(clip, line->times, line->count, 1) || !fits(clip, line->modes, line->count, 1))
        return NKW_OUT_OF_RANGE;
    for (uint32_t k = 0; line->modes && k < line->count; k++)
        if (clip_words(clip)[line->modes + k] > NKW_INTERPOLATION_STEP)
            return NKW_OUT_OF_RANGE;
    return check_times(line, clip_floats(clip, line->times));
}

static nkw_result check_group(const nkw_clip *clip, const clip_group *g)
{
    if (g->timeline >= clip->timeline_count || g->kind >= GROUP_KINDS ||
        g->interpolation > NKW_INTERPOLATION_CUBICSPLINE || g->lanes > clip->words)
        return NKW_OUT_OF_RANGE;
    if (g->normalized && g->kind != GROUP_ROTATIONS)
        return NKW_OUT_OF_RANGE;
    const clip_timeline *line = clip_timelines(clip) + g->timeline;
    if (line->modes && g->interpolation != NKW_INTERPOLATION_LINEAR)
        return NKW_OUT_OF_RANGE;
    uint64_t rows =
        (g->kind == GROUP_ROTATIONS ? 4u : 1u) * (g->interpolation == NKW_INTERPOLATION_CUBICSPLINE ? 3u : 1u);
    uint64_t arcs = g->kind == GROUP_ROTATIONS && g->interpolation == NKW_INTERPOLATION_LINEAR ? 5u : 0u;
    if (g->key_words != (rows + arcs) * g->lanes || !fits(clip, g->keys, line->count, g->key_words))
        return NKW_OUT_OF_RANGE;
    return check_runs(clip, g->runs, g->run_count, g->lanes, room_of(clip, g->kind));
}

/* The values of constants stand one after the other. */
static nkw_result check_constants(const nkw_clip *clip, uint32_t values, uint32_t runs, uint32_t run_count,
                                  uint32_t kind)
{
    uint64_t lanes = values <= clip->words ? clip->words - values : 0;
    return check_runs(clip, runs, run_count, lanes, room_of(clip, kind));
}

static nkw_result check_parts(const nkw_clip *clip)
{
    nkw_result result = NKW_OK;
    if (!fits(clip, clip->timelines, clip->timeline_count, sizeof(clip_timeline) / 4) ||
        !fits(clip, clip->groups, clip->group_count, sizeof(clip_group) / 4))
        return NKW_OUT_OF_RANGE;
    for (uint32_t i = 0; result == NKW_OK && i < clip->timeline_count; i++)
        result = check_timeline(clip, clip_timelines(clip) + i);
    for (uint32_t i = 0; result == NKW_OK && i < clip->group_count; i++)
        result = check_group(clip, clip_groups(clip) + i);
    if (result == NKW_OK)
        result = check_constants(clip, clip->constants, clip->constant_runs, clip->constant_run_count, GROUP_NUMBERS);
    if (result == NKW_OK)
        result = check_constants(clip, clip->float_constants, clip->float_runs, clip->float_run_count, GROUP_FLOATS);
    return result;
}

nkw_result nkw_clip_open(const void *block, size_t bytes, const nkw_clip **clip)
{
    const nkw_clip *head = (const nkw_clip *)block;
    *clip = NULL;
    if (bytes < sizeof *head)
        return NKW_TOO_SMALL;
    if (head->magic != CLIP_MAGIC || head->version != CLIP_VERSION)
        return NKW_NOT_A_CLIP;
    if (bytes / 4 < head->words || head->words < sizeof *head / 4)
        return NKW_TOO_SMALL;
    nkw_result result = check_parts(head);
    *clip = result == NKW_OK ? head : NULL;
    return result;
}
