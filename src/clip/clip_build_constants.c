/* SPDX-License-Identifier: MIT */
/*
 * The runs of a clip (clip_build.h): values of constant tracks, and rest values of joints and floats without a track.
 *
 * Invariant: a float of the output is written by a run, or by a lane of a group, or first by a run and then by a lane.
 * Runs are copied before the groups are sampled, so what a run writes to an animated float does not show.
 */
#include "lane/strict.h"

#include <string.h>

#include "clip_build.h"
#include "clip_keys.h"
#include "sizes.h"

float nkwi_clip_build_constant(const clip_builder *b, nkw_clip_target target, size_t index, size_t component)
{
    const nkw_clip_source *s = b->tracks.source;
    const nkw_clip_track *c = nkwi_clip_tracks_find(&b->tracks, target, index);
    size_t array = clip_array_of(target, component);
    if (c)
        return nkwi_clip_value_component(c, 0, target == NKW_CLIP_FLOATS ? index - c->index : component);
    if (target == NKW_CLIP_FLOATS)
        return s->rest_floats ? s->rest_floats[index] : 0.0f;
    return s->rest.data ? s->rest.data[array * NKW_POSE_STRIDE(s->joint_count) + index] : array >= 6 ? 1.0f : 0.0f;
}

/*
 * The runs of one output. Each has its values contiguous, because nothing else is emitted meanwhile.
 *
 *     places    7  8  9  .  .  12 13      .: animated, a gap of at most CLIP_RUN_GAP
 *     run       to 7, count 7: values c7 c8 c9 0 0 c12 c13; the groups then overwrite the zeros
 */
typedef struct constants {
    clip_builder *b;
    size_t at, count; /* the runs */
    size_t next; /* the place after the last value */
} constants;

static void add_value(constants *c, float value)
{
    size_t at = clip_take(c->b, SECTION_VALUES, 1);
    c->next++;
    if (c->b->words) {
        ((clip_run *)(void *)(c->b->words + c->at))[c->count - 1].count++;
        clip_floats_at(c->b->words, at)[0] = value;
    }
}

/* Appends the value of float `to` to the last run, or begins a run if the gap before it is long. `to` ascends. */
static void add_constant(constants *c, size_t to, float value)
{
    if (c->count == 0 || to - c->next > CLIP_RUN_GAP) {
        clip_run run = {(uint32_t)clip_next(c->b, SECTION_VALUES), (uint32_t)to, 0};
        size_t at = clip_take(c->b, SECTION_RUNS, sizeof run / 4);
        if (c->b->words)
            memcpy(c->b->words + at, &run, sizeof run);
        c->count++;
        c->next = to;
    }
    while (c->next < to)
        add_value(c, 0.0f);
    add_value(c, value);
}

/*
 * Adds the constant of float `to` of the output, component `component` of joint or float `index`, unless it has a lane.
 * Returns whether it is constant.
 */
static int emit_constant(constants *c, nkw_clip_target target, size_t index, size_t component, size_t to)
{
    const clip_tracks *t = &c->b->tracks;
    if (nkwi_clip_tracks_find_animated(t, target, index))
        return 0;
    if (!nkwi_clip_tracks_find_gap(t, target, index))
        add_constant(c, to, nkwi_clip_build_constant(c->b, target, index, component));
    return 1;
}

/*
 * The ten component arrays in the order of the pose. If the last joint of an array is not animated, the padding follows,
 * with the values of the identity.
 */
size_t nkwi_clip_build_pose_constants(clip_builder *b)
{
    static const nkw_clip_target targets[10] = {
        NKW_CLIP_TRANSLATION, NKW_CLIP_TRANSLATION, NKW_CLIP_TRANSLATION, NKW_CLIP_ROTATION, NKW_CLIP_ROTATION,
        NKW_CLIP_ROTATION,    NKW_CLIP_ROTATION,    NKW_CLIP_SCALE,       NKW_CLIP_SCALE,    NKW_CLIP_SCALE};
    static const size_t components[10] = {0, 1, 2, 0, 1, 2, 3, 0, 1, 2};
    const nkw_clip_source *s = b->tracks.source;
    size_t stride = NKW_POSE_STRIDE(s->joint_count);
    constants c = {b, clip_next(b, SECTION_RUNS), 0, 0};
    for (size_t array = 0; array < 10; array++) {
        float identity = array >= 6 ? 1.0f : 0.0f;
        int is_constant = 0;
        for (size_t j = 0; j < s->joint_count; j++)
            is_constant = emit_constant(&c, targets[array], j, components[array], array * stride + j);
        for (size_t j = s->joint_count; is_constant && j < stride; j++)
            add_constant(&c, array * stride + j, identity);
    }
    return c.count;
}

size_t nkwi_clip_build_float_constants(clip_builder *b)
{
    const nkw_clip_source *s = b->tracks.source;
    constants c = {b, clip_next(b, SECTION_RUNS), 0, 0};
    for (size_t f = 0; f < s->float_count; f++)
        emit_constant(&c, NKW_CLIP_FLOATS, f, 0, f);
    return c.count;
}
