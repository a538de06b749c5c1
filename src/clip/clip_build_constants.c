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
 * The runs of one output. Each has its values contiguous, because nothing else is emitted meanwhile. Equal values are
 * held back until another one follows: then it is known whether they are a fill.
 *
 *     places    7  8  9  .  .  12 13      .: animated, a gap of at most CLIP_RUN_GAP
 *     run       to 7, count 7: values c7 c8 c9 c9 c9 c12 c13; the groups then overwrite the gap
 *     fill      to 7, count 7: value c7, if the constants are equal, and CLIP_FILL or more with their gaps
 */
typedef struct constants {
    clip_builder *b;
    size_t at, count; /* the runs */
    int is_open; /* whether the last run ends where the equal values begin, and is no fill */
    int fills; /* whether there may be fills: of packed clips, whose other tracks take longer */
    size_t equal_to, equal; /* where they begin, how many */
    float value;
} constants;

static void begin_run(constants *c, uint32_t flag)
{
    const clip_run run = {(uint32_t)clip_next(c->b, SECTION_VALUES), (uint32_t)c->equal_to, flag};
    const size_t at = clip_take(c->b, SECTION_RUNS, sizeof run / 4);
    if (c->b->words)
        memcpy(c->b->words + at, &run, sizeof run);
    c->count++;
}

/* Adds n floats of the value to the last run, `words` words. */
static void add_values(constants *c, size_t n, size_t words)
{
    const size_t at = clip_take(c->b, SECTION_VALUES, words);
    if (!c->b->words)
        return;
    ((clip_run *)(void *)(c->b->words + c->at))[c->count - 1].count += (uint32_t)n;
    for (size_t i = 0; i < words; i++)
        clip_floats_at(c->b->words, at)[i] = c->value;
}

/* Adds the equal values: a fill, or to the last run, or to a new one. */
static void add_equal(constants *c)
{
    const int is_fill = c->fills && c->equal >= CLIP_FILL;
    if (c->equal > 0 && (is_fill || !c->is_open))
        begin_run(c, is_fill ? CLIP_IS_FILL : 0);
    if (c->equal > 0)
        add_values(c, c->equal, is_fill ? (c->equal + CLIP_FILL - 1) / CLIP_FILL : c->equal);
    c->is_open = !is_fill;
    c->equal = 0;
}

/* Appends the value of float `to`. `to` ascends. */
static void add_constant(constants *c, size_t to, float value)
{
    const size_t gap = to - (c->equal_to + c->equal);
    if (c->equal > 0 && gap <= CLIP_RUN_GAP) {
        c->equal += gap;
        if (lane_bits(value) == lane_bits(c->value)) {
            c->equal++;
            return;
        }
    }
    add_equal(c);
    c->is_open = c->is_open && gap <= CLIP_RUN_GAP && c->count > 0;
    c->equal_to = to;
    c->equal = 1;
    c->value = value;
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
 * with the values of the identity, in packed clips with that of the last joint.
 */
size_t nkwi_clip_build_pose_constants(clip_builder *b)
{
    static const nkw_clip_target targets[10] = {
        NKW_CLIP_TRANSLATION, NKW_CLIP_TRANSLATION, NKW_CLIP_TRANSLATION, NKW_CLIP_ROTATION, NKW_CLIP_ROTATION,
        NKW_CLIP_ROTATION,    NKW_CLIP_ROTATION,    NKW_CLIP_SCALE,       NKW_CLIP_SCALE,    NKW_CLIP_SCALE};
    static const size_t components[10] = {0, 1, 2, 0, 1, 2, 3, 0, 1, 2};
    const nkw_clip_source *s = b->tracks.source;
    size_t stride = NKW_POSE_STRIDE(s->joint_count);
    constants c = {b, clip_next(b, SECTION_RUNS), 0, 0, b->tracks.packing != NULL, 0, 0, 0.0f};
    for (size_t array = 0; array < 10; array++) {
        float identity = array >= 6 ? 1.0f : 0.0f;
        int is_constant = 0;
        for (size_t j = 0; j < s->joint_count; j++)
            is_constant = emit_constant(&c, targets[array], j, components[array], array * stride + j);
        if (is_constant && c.fills)
            c.equal += stride - s->joint_count;
        for (size_t j = s->joint_count; is_constant && !c.fills && j < stride; j++)
            add_constant(&c, array * stride + j, identity);
    }
    add_equal(&c);
    return c.count;
}

size_t nkwi_clip_build_float_constants(clip_builder *b)
{
    const nkw_clip_source *s = b->tracks.source;
    constants c = {b, clip_next(b, SECTION_RUNS), 0, 0, 0, 0, 0, 0.0f};
    for (size_t f = 0; f < s->float_count; f++)
        emit_constant(&c, NKW_CLIP_FLOATS, f, 0, f);
    add_equal(&c);
    return c.count;
}
