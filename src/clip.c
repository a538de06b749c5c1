/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/clip.h>
#include <nakawari/segment.h>

#include "clip_layout.h"
#include "simd/select.h"

size_t nkw_clip_joints(const nkw_clip *clip)
{
    return clip->joints;
}

size_t nkw_clip_floats(const nkw_clip *clip)
{
    return clip->floats;
}

size_t nkw_clip_bytes(const nkw_clip *clip)
{
    return (size_t)clip->words * 4;
}

float nkw_clip_start(const nkw_clip *clip)
{
    return clip->start;
}

float nkw_clip_end(const nkw_clip *clip)
{
    return clip->end;
}

size_t nkw_clip_cursors(const nkw_clip *clip)
{
    return clip->timeline_count;
}

/* Where a group writes: to components that stand `stride` floats apart. */
typedef struct target {
    float *out;
    size_t stride, components;
} target;

static void copy_runs(const float *from, size_t lanes, const nkw_run *runs, size_t run_count, target to)
{
    for (size_t c = 0; c < to.components; c++)
        for (size_t r = 0; r < run_count; r++)
            memcpy(to.out + c * to.stride + runs[r].to, from + c * lanes + runs[r].lane, runs[r].count * sizeof(float));
}

static nkw_segment find(const nkw_clip *clip, const clip_timeline *line, float time, uint32_t *cursor)
{
    const float *times = clip_floats(clip, line->times);
    if (line->rate > 0.0f)
        return nkw_segment_find_uniform(times[0], line->rate, line->count, time);
    if (!cursor)
        return nkw_segment_find(times, line->count, time);
    nkw_segment segment = nkw_segment_find_from(times, line->count, time, *cursor);
    *cursor = (uint32_t)segment.index;
    return segment;
}

/* The key's own value. */
static void hold(const nkw_clip *clip, const clip_group *g, const float *key, target to)
{
    const nkw_run *runs = clip_runs(clip, g->runs);
    size_t before = g->interpolation == NKW_INTERPOLATION_CUBICSPLINE ? clip_value_words(g) : 0;
    copy_runs(key + before, g->lanes, runs, g->run_count, to);
    if (g->normalized)
        nkw_batch_selected()->clip_normalize(runs, g->run_count, to.out, to.stride);
}

static void cubic(const nkw_clip *clip, const clip_group *g, const float *a, const float *b, float duration, float t,
                  target to)
{
    const nkw_batch *batch = nkw_batch_selected();
    const nkw_run *runs = clip_runs(clip, g->runs);
    for (size_t c = 0; c < to.components; c++)
        batch->clip_hermite(a + c * g->lanes, b + c * g->lanes, clip_value_words(g), duration, t, runs, g->run_count,
                            to.out + c * to.stride);
    if (g->kind == GROUP_ROTATIONS)
        batch->clip_normalize(runs, g->run_count, to.out, to.stride);
}

static void between(const nkw_clip *clip, const clip_group *g, const float *a, const float *b, float t, target to)
{
    const nkw_run *runs = clip_runs(clip, g->runs);
    if (g->kind == GROUP_ROTATIONS)
        nkw_batch_selected()->clip_slerp(a, b, g->lanes, t, runs, g->run_count, to.out, to.stride);
    else
        nkw_batch_selected()->clip_lerp(a, b, t, runs, g->run_count, to.out);
}

/* The same cases, in the same order, as nkw_track_sample_at. */
static void sample_group(const nkw_clip *clip, const clip_group *g, const clip_timeline *line, nkw_segment at,
                         target to)
{
    size_t last = line->count - 1;
    size_t k = at.index < last ? at.index : last;
    const float *times = clip_floats(clip, line->times);
    const float *a = clip_floats(clip, g->keys) + k * g->key_words, *b = a + g->key_words;
    uint32_t mode = line->modes ? clip_words(clip)[line->modes + k] : g->interpolation;
    if (k == last || at.t == 0.0f)
        hold(clip, g, a, to);
    else if (at.t == 1.0f)
        hold(clip, g, b, to);
    else if (mode == NKW_INTERPOLATION_CUBICSPLINE)
        cubic(clip, g, a, b, times[k + 1] - times[k], at.t, to);
    else if (mode == NKW_INTERPOLATION_LINEAR)
        between(clip, g, a, b, at.t, to);
    else
        hold(clip, g, a, to);
}

static target target_of(const nkw_clip *clip, uint32_t kind, float *pose, float *floats)
{
    size_t stride = NKW_POSE_STRIDE(clip->joints);
    target to = {pose, stride, 1};
    if (kind == GROUP_FLOATS)
        to.out = floats;
    if (kind == GROUP_ROTATIONS && pose) {
        to.out = pose + 3 * stride;
        to.components = 4;
    }
    return to;
}

void nkw_clip_sample(const nkw_clip *clip, float time, uint32_t *cursors, float *pose, float *floats)
{
    target numbers = target_of(clip, GROUP_NUMBERS, pose, floats), others = target_of(clip, GROUP_FLOATS, pose, floats);
    if (pose)
        copy_runs(clip_floats(clip, clip->constants), 0, clip_runs(clip, clip->constant_runs), clip->constant_run_count,
                  numbers);
    if (floats)
        copy_runs(clip_floats(clip, clip->float_constants), 0, clip_runs(clip, clip->float_runs), clip->float_run_count,
                  others);
    const clip_group *groups = clip_groups(clip);
    nkw_segment at = {0, 0.0f};
    for (uint32_t g = 0; g < clip->group_count; g++) {
        uint32_t i = groups[g].timeline;
        const clip_timeline *line = clip_timelines(clip) + i;
        target to = target_of(clip, groups[g].kind, pose, floats);
        if (g == 0 || i != groups[g - 1].timeline)
            at = find(clip, line, time, cursors ? cursors + i : NULL);
        if (to.out)
            sample_group(clip, &groups[g], line, at, to);
    }
}
