/* SPDX-License-Identifier: MIT */
/* Builds a clip's block. It is laid out twice by the same code: first to measure, without a block, then to write. */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/clip.h>
#include <nakawari/segment.h>

#include "batch/clip.h"
#include "clip_layout.h"
#include "clip_tracks.h"
#include "lane/clip.h"
#include "lane/orient.h"

typedef enum section { TIMELINES, GROUPS, BLOCKS, RUNS, TIMES, VALUES, SECTIONS } section;

typedef struct builder {
    clip_tracks tracks;
    uint32_t *words; /* the block; NULL while measuring */
    uint64_t start[SECTIONS], used[SECTIONS]; /* words; far more than a block may have while measuring */
} builder;

/*
 * Room in a section: where it begins, in words from the beginning of the block. What is too large for a block is cut to
 * 2^32 words, so that sums stay below 2^64 and the clip is still found too large.
 */
static size_t take(builder *b, section s, uint64_t words)
{
    uint64_t at = b->start[s] + b->used[s];
    b->used[s] += words <= UINT32_MAX ? words : (uint64_t)UINT32_MAX + 1;
    return (size_t)at;
}

static uint64_t round_up(uint64_t n, uint64_t to)
{
    return (n + to - 1) / to * to;
}

static float *floats_at(const builder *b, size_t at)
{
    return (float *)(void *)(b->words + at);
}

/* Lanes: where they go, in blocks. */

typedef struct lanes {
    builder *b;
    size_t expected; /* of all blocks together; unknown while measuring */
    size_t count, blocks;
    size_t next, length; /* where the last lane went, plus one, and how long it has been going on so */
} lanes;

static nkw_block *block_of(const lanes *l, size_t lane)
{
    return (nkw_block *)(void *)(l->b->words + l->blocks) + lane / NKW_BLOCK;
}

static lanes lanes_begin(builder *b, size_t expected)
{
    lanes l = {b, expected, 0, (size_t)(b->start[BLOCKS] + b->used[BLOCKS]), 0, 0};
    return l;
}

/* One more lane, that goes to the float `to`; gives its number. */
static size_t add_lane(lanes *l, size_t to)
{
    size_t i = l->count % NKW_BLOCK;
    l->length = l->count > 0 && to == l->next ? l->length + 1 : 1;
    l->next = to + 1;
    if (i == 0)
        take(l->b, BLOCKS, sizeof(nkw_block) / 4);
    if (l->b->words) {
        nkw_block *block = block_of(l, l->count);
        size_t left = l->expected - (l->count - i);
        block->width = (uint32_t)(left < NKW_BLOCK ? left : NKW_BLOCK);
        block->places[i] = (uint32_t)to;
        block->count = (uint32_t)i + 1;
        block->direct = block->count == block->width && l->length >= block->count ? block->width : 0;
    }
    return l->count++;
}

/*
 * Lanes that end with the last joint of a component array go on over the padding: numbers into the next array,
 * rotations until their block is full, where the padding is long enough for that.
 */
static void add_padding(lanes *l, int turns)
{
    size_t joints = l->b->tracks.source->joint_count, stride = NKW_POSE_STRIDE(joints);
    size_t room = stride - joints, wanted = turns ? clip_lanes(l->count) - l->count : room;
    if (l->length < 8 || l->next % stride != joints % stride || wanted > room)
        return;
    for (; wanted > 0; wanted--)
        add_lane(l, l->next);
}

/* Keys. */

/* A component of what the track gives at key k. */
static float held_component(const nkw_clip_track *c, size_t k, size_t component)
{
    nkw_segment at = {k, 0.0f};
    float rotation[4];
    if (c->target != NKW_CLIP_ROTATION)
        return clip_track_value(&c->track, k)[component];
    nkw_track_sample_segment(&c->track, at, rotation);
    return rotation[component];
}

/* Component c of key k's in-tangent, value or out-tangent (part 0, 1, 2); without tangents of the value. */
static float key_component(const nkw_clip_track *c, size_t k, size_t part, size_t component)
{
    const nkw_track *t = &c->track;
    if (clip_is_cubic(t))
        return t->values[(3 * k + part) * t->width + component];
    return held_component(c, k, component);
}

/* Where row `row` of a lane stands in a value, of a key with `rows` rows to a lane. */
static size_t lane_at(const clip_group *g, size_t rows, size_t row, size_t lane)
{
    size_t i = lane % NKW_BLOCK, before = lane - i, left = g->lanes - before;
    return before * rows + row * (left < NKW_BLOCK ? left : NKW_BLOCK) + i;
}

/* Writes a component of a track into every key of its lane. */
static void fill_component(const builder *b, const clip_group *g, const nkw_clip_track *c, size_t component, size_t row,
                           size_t lane)
{
    int cubic = clip_is_cubic(&c->track);
    size_t at = lane_at(g, cubic ? clip_rows(g) : clip_key_rows(g), row, lane);
    for (size_t k = 0; k < c->track.count; k++)
        for (size_t part = 0; part < (cubic ? 3u : 1u); part++)
            floats_at(b, g->keys + k * g->key_words)[part * clip_rows(g) * g->lanes + at] =
                key_component(c, k, part, component);
}

/* Compact keys: the range of a lane's row, and its numbers as parts of it. */

/* A lane's keys, to be taken one after the other from 0 on. */
typedef struct compact_keys {
    const nkw_clip_track *c;
    size_t component;
    double lowest; /* w of a rotation may become this */
    float side; /* 1 or -1: what the last rotation was multiplied by */
} compact_keys;

static nkw_quat held_rotation(const nkw_clip_track *c, size_t k)
{
    nkw_quat q = {held_component(c, k, 0), held_component(c, k, 1), held_component(c, k, 2), held_component(c, k, 3)};
    return q;
}

/*
 * The numbers of key k: one, or a rotation's three. A rotation is kept on the side of the one before as slerp sees it,
 * so that the way between them is that of the source also where it is half a turn. Where its w would be too low there
 * it is turned, which is told.
 */
static unsigned next_numbers(compact_keys *keys, size_t k, double numbers[3])
{
    if (keys->c->target != NKW_CLIP_ROTATION) {
        numbers[0] = (double)held_component(keys->c, k, keys->component);
        return 0;
    }
    nkw_quat q = held_rotation(keys->c, k);
    if (k > 0 && lane_slerp_cosine(held_rotation(keys->c, k - 1), q) < 0.0f)
        keys->side = -keys->side;
    double w = (double)keys->side * (double)q.w, lowest = k > 0 ? keys->lowest : 0.0;
    unsigned turned = w < lowest;
    keys->side = turned ? -keys->side : keys->side;
    lane_compact_numbers(lane_wquat_scale(lane_wquat_from(q), (double)keys->side), numbers);
    return turned;
}

/* What the numbers of a lane lie between. */
typedef struct compact_ranges {
    double low[3], high[3], widest;
} compact_ranges;

static compact_ranges ranges_of(compact_keys keys, size_t rows)
{
    compact_ranges r = {{0.0}, {0.0}, 0.0};
    for (size_t k = 0; k < keys.c->track.count; k++) {
        double x[3];
        next_numbers(&keys, k, x);
        for (size_t i = 0; i < rows; i++) {
            r.low[i] = k == 0 || x[i] < r.low[i] ? x[i] : r.low[i];
            r.high[i] = k == 0 || x[i] > r.high[i] ? x[i] : r.high[i];
            r.widest = r.high[i] - r.low[i] > r.widest ? r.high[i] - r.low[i] : r.widest;
        }
    }
    return r;
}

/* (x - base) / step in 0..65535. */
static double part_of(float base, float step, double x)
{
    double part = step > 0.0f ? (x - (double)base) / (double)step : 0.0;
    return part < 0.0 ? 0.0 : part > (double)CLIP_STEPS ? (double)CLIP_STEPS : part;
}

/*
 * Each number to the nearest; those of a rotation to an odd sum where it is turned, else to an even one: if it is not,
 * that number is rounded the other way which adds least to the square of the distance, (1 - 2 |off|) step^2. Three with
 * the same step are then off by a step at most, all together.
 */
static void encode(const float base[3], const float step[3], const double x[3], size_t rows, unsigned turned,
                   uint16_t parts[3])
{
    double least = 0.0;
    size_t other = rows;
    unsigned sum = 0, away = 0;
    for (size_t r = 0; r < rows; r++) {
        double part = part_of(base[r], step[r], x[r]);
        unsigned nearest = (unsigned)(part + 0.5);
        double off = part - (double)nearest, size = off < 0.0 ? -off : off;
        double added = (1.0 - 2.0 * size) * (double)step[r] * (double)step[r];
        if (other == rows || added < least) {
            other = r;
            least = added;
            away = off < 0.0 || nearest == 65535 ? nearest - 1 : nearest + 1;
        }
        parts[r] = (uint16_t)nearest;
        sum += nearest;
    }
    if (rows == 3 && sum % 2 != turned)
        parts[other] = (uint16_t)away;
}

/*
 * All rows of a lane. Rotations are those with w >= 0, so that their numbers are within -1..1; or, where that makes
 * ranges narrower, those of one side as far as w = -1/2.
 */
static void fill_compact(const builder *b, const clip_group *g, const nkw_clip_track *c, size_t component, size_t lane)
{
    size_t rows = clip_rows(g), at[3];
    compact_keys keys = {c, component, 0.0, 1.0f};
    compact_ranges ranges = ranges_of(keys, rows);
    float base[3], step[3];
    if (c->target == NKW_CLIP_ROTATION) {
        compact_keys far_keys = {c, component, -0.5, 1.0f};
        compact_ranges far_ranges = ranges_of(far_keys, rows);
        if (far_ranges.widest < ranges.widest) {
            keys = far_keys;
            ranges = far_ranges;
        }
    }
    for (size_t r = 0; r < rows; r++) {
        at[r] = lane_at(g, rows, r, lane);
        base[r] = floats_at(b, g->ranges)[at[r]] = (float)ranges.low[r];
        step[r] = floats_at(b, g->ranges)[rows * g->lanes + at[r]] =
            (float)((ranges.high[r] - (double)base[r]) / (double)CLIP_STEPS);
    }
    for (size_t k = 0; k < c->track.count; k++) {
        uint16_t *key = (uint16_t *)(void *)(b->words + g->keys + k * g->key_words), parts[3];
        double x[3];
        unsigned turned = next_numbers(&keys, k, x);
        encode(base, step, x, rows, turned, parts);
        for (size_t r = 0; r < rows; r++)
            key[at[r]] = parts[r];
    }
}

static void fill_arcs(const builder *b, const clip_group *g, size_t key_count)
{
    const nkw_block *blocks = (const nkw_block *)(const void *)(b->words + g->blocks);
    for (size_t k = 0; k + 1 < key_count; k++) {
        float *key = floats_at(b, g->keys + k * g->key_words);
        nkwi_clip_arcs(key, key + g->key_words, blocks, g->block_count);
    }
}

/* Where component c goes: in the pose, in its rotations, or in the floats. */
static size_t place_of(const builder *b, nkw_clip_target target, size_t index, size_t component)
{
    size_t stride = NKW_POSE_STRIDE(b->tracks.source->joint_count);
    if (target == NKW_CLIP_FLOATS)
        return index + component;
    if (target == NKW_CLIP_ROTATION)
        return index;
    return clip_array_of(target, component) * stride + index;
}

/* The lanes of a track in pass 0, 1 or 2: one component, or all of a rotation, or all the floats in a row. */
static void lay_track(lanes *l, const clip_group *g, const nkw_clip_track *c, size_t pass)
{
    int turns = c->target == NKW_CLIP_ROTATION, floats = c->target == NKW_CLIP_FLOATS;
    size_t first = turns || floats ? 0 : pass, end = floats ? c->track.width : first + 1;
    for (size_t component = first; component < end; component++) {
        size_t lane = add_lane(l, place_of(l->b, c->target, c->index, component));
        if (l->b->words && g->ranges)
            fill_compact(l->b, g, c, component, lane);
        for (size_t row = 0; l->b->words && !g->ranges && row < (turns ? 4u : 1u); row++)
            fill_component(l->b, g, c, component + row, row, lane);
    }
}

/* What a joint or float holds that nothing changes. */
static float constant_of(const builder *b, nkw_clip_target target, size_t index, size_t component)
{
    const nkw_clip_source *s = b->tracks.source;
    const nkw_clip_track *c = nkw_clip_tracks_of(&b->tracks, target, index);
    size_t array = clip_array_of(target, component);
    if (c)
        return held_component(c, 0, target == NKW_CLIP_FLOATS ? index - c->index : component);
    if (target == NKW_CLIP_FLOATS)
        return s->rest_floats ? s->rest_floats[index] : 0.0f;
    return s->rest.data ? s->rest.data[array * NKW_POSE_STRIDE(s->joint_count) + index] : array >= 6 ? 1.0f : 0.0f;
}

/*
 * The lanes of joints from..to - 1, if those of c beside them go on there: all keys are the same. Compact ones are 0, of
 * a range without width.
 */
static void lay_gap(lanes *l, const clip_group *g, const nkw_clip_track *c, size_t from, size_t to, size_t pass)
{
    const clip_tracks *t = &l->b->tracks;
    int turns = c->target == NKW_CLIP_ROTATION;
    for (size_t joint = from; joint < to; joint++)
        if (!nkw_clip_tracks_same(t, nkw_clip_tracks_beside(t, c->target, joint), c))
            return;
    for (size_t joint = from; joint < to; joint++) {
        size_t lane = add_lane(l, place_of(l->b, c->target, joint, pass));
        for (size_t row = 0; l->b->words && row < (turns ? 4u : 1u); row++) {
            float value = constant_of(l->b, c->target, joint, turns ? row : pass);
            size_t at = lane_at(g, clip_key_rows(g), row, lane);
            if (g->ranges)
                floats_at(l->b, g->ranges)[at] = value;
            for (size_t k = 0; !g->ranges && k < c->track.count; k++)
                floats_at(l->b, g->keys + k * g->key_words)[at] = value;
        }
    }
}

/* The lanes of a group's tracks: translations x, y, z, rotations, scales x, y, z, each in joint order; floats. */
static lanes lay_lanes(builder *b, const clip_group *g, const uint32_t *members, size_t count)
{
    lanes l = lanes_begin(b, g->lanes);
    for (int target = NKW_CLIP_TRANSLATION; target <= NKW_CLIP_FLOATS; target++) {
        int in_passes = target == NKW_CLIP_TRANSLATION || target == NKW_CLIP_SCALE;
        for (size_t pass = 0; pass < (in_passes ? 3u : 1u); pass++) {
            const nkw_clip_track *last = NULL;
            for (size_t i = 0; i < count; i++) {
                const nkw_clip_track *c = &b->tracks.source->tracks[members[i]];
                if ((int)c->target != target)
                    continue;
                lay_gap(&l, g, c, last ? last->index + 1 : 0, c->index, pass);
                lay_track(&l, g, c, pass);
                last = c;
            }
            if (last)
                lay_gap(&l, g, last, last->index + 1, b->tracks.source->joint_count, pass);
            if (target != NKW_CLIP_FLOATS)
                add_padding(&l, target == NKW_CLIP_ROTATION);
        }
    }
    return l;
}

/* Groups and timelines. */

static void lay_timeline(builder *b, const nkw_track *t)
{
    size_t at = take(b, TIMELINES, sizeof(clip_timeline) / 4), times = take(b, TIMES, t->count);
    size_t modes = t->key_interpolation ? take(b, TIMES, t->count) : 0;
    if (!b->words)
        return;
    clip_timeline line = {(uint32_t)times, (uint32_t)t->count, (uint32_t)modes, 0.0f};
    (void)nkw_segment_uniform_rate(t->times, t->count, &line.rate); /* 0 where there is none */
    memcpy(b->words + at, &line, sizeof line);
    memcpy(b->words + times, t->times, t->count * sizeof(float));
    for (size_t k = 0; modes && k < t->count; k++)
        b->words[modes + k] = t->key_interpolation[k];
}

/* Blocks that go on from each other become one stretch. */
static void join_blocks(nkw_block *blocks, size_t count)
{
    for (size_t i = count; i-- > 1;)
        if (blocks[i - 1].direct && blocks[i].direct && blocks[i].places[0] == blocks[i - 1].places[0] + NKW_BLOCK)
            blocks[i - 1].direct += blocks[i].direct;
}

/* The tracks of a group have the key times of its first one. */
static void lay_group(builder *b, uint32_t timeline, const uint32_t *members, size_t count)
{
    const nkw_track *first = &b->tracks.source->tracks[members[0]].track;
    clip_group g;
    builder probe = *b;
    probe.words = NULL;
    memset(&g, 0, sizeof g);
    g.timeline = timeline;
    g.kind = clip_kind_of(&b->tracks.source->tracks[members[0]]);
    g.interpolation = clip_interpolation_of(first);
    g.normalized = clip_is_cubic(first) && clip_is_normalized(first);
    g.lanes = (uint32_t)clip_lanes(lay_lanes(&probe, &g, members, count).count);
    take(b, VALUES, round_up(b->used[VALUES], CLIP_ALIGN) - b->used[VALUES]);
    if (b->tracks.source->format == NKW_CLIP_UNORM16 && !clip_is_cubic(first)) {
        g.ranges = CLIP_ALIGN; /* so that its rows are those of a compact group */
        g.ranges = (uint32_t)take(b, VALUES, round_up(2 * clip_rows(&g) * g.lanes, CLIP_ALIGN));
    }
    g.key_words = (uint32_t)clip_key_words(&g);
    g.keys = (uint32_t)take(b, VALUES, (uint64_t)g.key_words * first->count);
    lanes l = lay_lanes(b, &g, members, count);
    size_t at = take(b, GROUPS, sizeof g / 4);
    g.blocks = (uint32_t)l.blocks;
    g.block_count = (uint32_t)round_up(l.count, NKW_BLOCK) / NKW_BLOCK;
    if (!b->words)
        return;
    join_blocks((nkw_block *)(void *)(b->words + g.blocks), g.block_count);
    if (g.kind == GROUP_ROTATIONS && g.interpolation == NKW_INTERPOLATION_LINEAR && !g.ranges)
        fill_arcs(b, &g, first->count);
    memcpy(b->words + at, &g, sizeof g);
}

static void lay_groups(builder *b)
{
    const clip_tracks *t = &b->tracks;
    const nkw_clip_track *tracks = t->source->tracks;
    size_t from = 0, to = 0, count = t->source->track_count;
    for (uint32_t lines = 0; from < count && t->timeline[t->by_group[from]] != CLIP_CONSTANT; from = to) {
        uint32_t first = t->by_group[from], line = t->timeline[first];
        while (to < count && t->timeline[t->by_group[to]] == line &&
               nkw_clip_tracks_group(&tracks[t->by_group[to]]) == nkw_clip_tracks_group(&tracks[first]))
            to++;
        if (from == 0 || t->timeline[t->by_group[from - 1]] != line) {
            lay_timeline(b, &tracks[first].track);
            lines++;
        }
        lay_group(b, lines - 1, t->by_group + from, to - from);
    }
}

/* What never changes: constant tracks, and the rest where there is no track. */

#define BRIDGE 32 /* floats: a shorter gap between runs is filled; what is animated there is written afterwards */

typedef struct constants {
    builder *b;
    size_t at, count; /* the runs */
    size_t next; /* where the last one would go on */
} constants;

static void add_value(constants *c, float value)
{
    size_t at = take(c->b, VALUES, 1);
    c->next++;
    if (c->b->words) {
        ((clip_run *)(void *)(c->b->words + c->at))[c->count - 1].count++;
        floats_at(c->b, at)[0] = value;
    }
}

static void add_constant(constants *c, size_t to, float value)
{
    if (c->count == 0 || to - c->next > BRIDGE) {
        clip_run run = {(uint32_t)(c->b->start[VALUES] + c->b->used[VALUES]), (uint32_t)to, 0};
        size_t at = take(c->b, RUNS, sizeof run / 4);
        if (c->b->words)
            memcpy(c->b->words + at, &run, sizeof run);
        c->count++;
        c->next = to;
    }
    while (c->next < to)
        add_value(c, 0.0f);
    add_value(c, value);
}

/* Float `to` of the output, unless a track animates it: component `component` of joint or float `index`. */
static int lay_constant(constants *c, nkw_clip_target target, size_t index, size_t component, size_t to)
{
    const clip_tracks *t = &c->b->tracks;
    if (nkw_clip_tracks_mover(t, target, index))
        return 0;
    if (!nkw_clip_tracks_beside(t, target, index))
        add_constant(c, to, constant_of(c->b, target, index, component));
    return 1;
}

static size_t lay_pose_constants(builder *b)
{
    static const nkw_clip_target targets[10] = {
        NKW_CLIP_TRANSLATION, NKW_CLIP_TRANSLATION, NKW_CLIP_TRANSLATION, NKW_CLIP_ROTATION, NKW_CLIP_ROTATION,
        NKW_CLIP_ROTATION,    NKW_CLIP_ROTATION,    NKW_CLIP_SCALE,       NKW_CLIP_SCALE,    NKW_CLIP_SCALE};
    static const size_t components[10] = {0, 1, 2, 0, 1, 2, 3, 0, 1, 2};
    const nkw_clip_source *s = b->tracks.source;
    size_t stride = NKW_POSE_STRIDE(s->joint_count);
    constants c = {b, (size_t)(b->start[RUNS] + b->used[RUNS]), 0, 0};
    for (size_t array = 0; array < 10; array++) {
        float identity = array >= 6 ? 1.0f : 0.0f;
        int held = 0;
        for (size_t j = 0; j < s->joint_count; j++)
            held = lay_constant(&c, targets[array], j, components[array], array * stride + j);
        for (size_t j = s->joint_count; held && j < stride; j++)
            add_constant(&c, array * stride + j, identity);
    }
    return c.count;
}

static size_t lay_float_constants(builder *b)
{
    const nkw_clip_source *s = b->tracks.source;
    constants c = {b, (size_t)(b->start[RUNS] + b->used[RUNS]), 0, 0};
    for (size_t f = 0; f < s->float_count; f++)
        lay_constant(&c, NKW_CLIP_FLOATS, f, 0, f);
    return c.count;
}

/* The whole block. */

static void lay_head(builder *b, size_t pose_runs, size_t float_runs)
{
    nkw_clip head;
    const nkw_clip_source *s = b->tracks.source;
    memset(&head, 0, sizeof head);
    head.magic = CLIP_MAGIC;
    head.version = CLIP_VERSION;
    head.words = (uint32_t)(b->start[VALUES] + b->used[VALUES]);
    head.joints = (uint32_t)s->joint_count;
    head.floats = (uint32_t)s->float_count;
    for (size_t i = 0; i < s->track_count; i++) {
        const nkw_track *t = &s->tracks[b->tracks.by_place[i]].track;
        float first = t->times[0], last = t->times[t->count - 1];
        head.start = i == 0 || first < head.start ? first : head.start;
        head.end = i == 0 || last > head.end ? last : head.end;
    }
    head.timelines = (uint32_t)b->start[TIMELINES];
    head.timeline_count = (uint32_t)(b->used[TIMELINES] / (sizeof(clip_timeline) / 4));
    head.groups = (uint32_t)b->start[GROUPS];
    head.group_count = (uint32_t)(b->used[GROUPS] / (sizeof(clip_group) / 4));
    head.constants = (uint32_t)b->start[RUNS];
    head.constant_count = (uint32_t)pose_runs;
    head.float_constants = (uint32_t)(b->start[RUNS] + pose_runs * (sizeof(clip_run) / 4));
    head.float_constant_count = (uint32_t)float_runs;
    memcpy(b->words, &head, sizeof head);
}

static void lay_clip(builder *b)
{
    size_t pose_runs = lay_pose_constants(b), float_runs = lay_float_constants(b);
    lay_groups(b);
    if (b->words)
        lay_head(b, pose_runs, float_runs);
}

/* Measures, so that each section's beginning is known. */
static nkw_result plan(builder *b, const nkw_clip_source *source, size_t *bytes, size_t *bad, uint32_t *work,
                       size_t work_count)
{
    memset(b, 0, sizeof *b);
    b->start[VALUES] = CLIP_ALIGN; /* not 0, which says that there are no ranges */
    nkw_result result = nkw_clip_tracks_order(source, &b->tracks, bad, work, work_count);
    if (result != NKW_OK)
        return result;
    lay_clip(b);
    uint64_t at = sizeof(nkw_clip) / 4;
    for (int s = 0; s < SECTIONS; s++) {
        b->start[s] = at = s == VALUES ? round_up(at, CLIP_ALIGN) : at;
        at += b->used[s];
        b->used[s] = 0;
    }
    if (at >= UINT32_MAX || at > SIZE_MAX / 4)
        return NKW_OUT_OF_RANGE;
    *bytes = (size_t)at * 4;
    return NKW_OK;
}

nkw_result nkw_clip_measure(const nkw_clip_source *source, size_t *bytes, size_t *bad_track, uint32_t *work,
                            size_t work_count)
{
    builder b;
    size_t bad = 0;
    return plan(&b, source, bytes, bad_track ? bad_track : &bad, work, work_count);
}

nkw_result nkw_clip_build(const nkw_clip_source *source, void *block, size_t bytes, size_t *bad_track, uint32_t *work,
                          size_t work_count)
{
    builder b;
    size_t bad = 0, needed = 0;
    nkw_result result = plan(&b, source, &needed, bad_track ? bad_track : &bad, work, work_count);
    if (result != NKW_OK)
        return result;
    if (bytes < needed)
        return NKW_TOO_SMALL;
    memset(block, 0, needed);
    b.words = (uint32_t *)block;
    lay_clip(&b);
    return NKW_OK;
}
