/* SPDX-License-Identifier: MIT */
/*
 * Builds the block of a clip in two passes of the same code, emit_clip:
 *
 *     1. plan      words == NULL: take() only counts the words of each section. The starts of the sections follow.
 *     2. build     words is the block: take() returns the offsets at which the elements are written.
 *
 * Invariant: both passes take the same words in the same order; whether something is taken never depends on `words`.
 * Without a block, nkw_clip_build is pass 1 alone.
 *
 *     pass 1    used     timelines 8   groups 22   blocks 18   places 5   ...          words, counted
 *     plan      start    17            25          47          65         70 ...       17 words of header first
 *     pass 2    take()   start + used  -> the offset of the next element, used grows as in pass 1
 *
 * A group needs its number of lanes before its blocks: emit_group and fits_packed run emit_lanes on a copy (`probe`).
 *
 * Order within the sections:
 *
 *     runs      of the pose, then of the floats
 *     values    constants of the pose; constants of the floats; of each group its ranges and its keys
 *     groups    by timeline; a timeline is emitted before its first group
 */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/clip.h>
#include <nakawari/segment.h>

#include "clip_keys.h"
#include "clip_layout.h"
#include "clip_packed.h"
#include "clip_tracks.h"
#include "curve/segment_even.h"
#include "sizes.h"

typedef enum section { TIMELINES, GROUPS, BLOCKS, PLACES, RUNS, TIMES, NAMES, VALUES, SECTIONS } section;

typedef struct builder {
    clip_tracks tracks;
    uint32_t *words; /* the block; NULL in pass 1 */
    uint64_t start[SECTIONS], used[SECTIONS]; /* words; in pass 1 they may exceed 2^32, the limit of a block */
    size_t listed; /* tracks of the lanes so far, as nkw_clip_describe counts them */
} builder;

/*
 * Takes words of a section. Returns their offset from the beginning of the block.
 *
 * More than 2^32 - 1 words count as 2^32: no sum overflows 64 bits, and the block is still found to be too large.
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

/* Lanes, and their places in blocks. */

/* The lanes of one group, in the order in which they are emitted. */
typedef struct lanes {
    builder *b;
    size_t expected; /* the sum of the widths of all blocks; 0 until all lanes are counted */
    size_t count, blocks; /* lanes so far; the offset of the first block */
    size_t next, length; /* the place after the last lane; how many lanes up to the last have contiguous places */
    uint32_t places[CLIP_BLOCK]; /* of the lanes of the last block */
    uint32_t starts, first; /* of the last block (batch/block.h) */
    packed_lanes *packed; /* receives the tracks of the lanes of a packed group; otherwise NULL */
} lanes;

static lanes lanes_begin(builder *b, size_t expected, packed_lanes *packed)
{
    lanes l = {b, expected, 0, (size_t)(b->start[BLOCKS] + b->used[BLOCKS]), 0, 0, {0}, 0, 0, packed};
    return l;
}

/*
 * Takes the block that ends with the last lane. It is contiguous if it is full and its places are. The `place` of
 * another block is the distance from its clip_block to its places, in words (batch/block.h).
 */
static void end_block(lanes *l)
{
    size_t count = (l->count - 1) % CLIP_BLOCK + 1, left = l->expected - (l->count - count);
    size_t width = left < CLIP_BLOCK ? left : CLIP_BLOCK, at = take(l->b, BLOCKS, sizeof(clip_block) / 4);
    int is_contiguous = count == width && l->length >= count;
    size_t places = is_contiguous ? 0 : take(l->b, PLACES, count);
    if (!l->b->words)
        return;
    clip_block block = {(uint32_t)width,
                        (uint32_t)count,
                        (uint32_t)(is_contiguous ? width : 0),
                        is_contiguous ? l->places[0] : (uint32_t)(places - at),
                        l->starts,
                        l->first};
    memcpy(l->b->words + at, &block, sizeof block);
    if (!is_contiguous)
        memcpy(l->b->words + places, l->places, count * sizeof *l->places);
}

/* Adds a lane with the place `to`. starts: 1 if it is the first of a track, otherwise 0. Returns its number. */
static size_t add_lane(lanes *l, size_t to, uint32_t starts)
{
    if (l->count % CLIP_BLOCK == 0)
        l->starts = 0, l->first = (uint32_t)l->b->listed;
    l->starts |= starts << l->count % CLIP_BLOCK;
    l->b->listed += starts;
    l->length = l->count > 0 && to == l->next ? l->length + 1 : 1;
    l->next = to + 1;
    l->places[l->count % CLIP_BLOCK] = (uint32_t)to;
    if (++l->count % CLIP_BLOCK == 0)
        end_block(l);
    return l->count - 1;
}

/*
 * Extends contiguous lanes that end with the last joint of a component array by lanes for its padding, so that they
 * remain contiguous: numbers to the start of the next array, rotations until their block is full if the padding is long
 * enough. The values are 0.
 *
 *     place     ...  joint_count - 1 | joint_count ... stride - 1 | stride ...
 *               lanes of joints      | lanes of padding           | next component array
 */
static void add_padding(lanes *l, int is_rotation)
{
    size_t joints = l->b->tracks.source->joint_count, stride = NKW_POSE_STRIDE(joints);
    size_t room = stride - joints, wanted = is_rotation ? clip_lanes(l->count) - l->count : room;
    if (l->length < 8 || l->next % stride != joints % stride || wanted > room)
        return;
    for (; wanted > 0; wanted--)
        add_lane(l, l->next, 0);
}

/* The place of a component: in the pose, in one component array of the rotations, or in the floats. */
static size_t place_of(const builder *b, nkw_clip_target target, size_t index, size_t component)
{
    size_t stride = NKW_POSE_STRIDE(b->tracks.source->joint_count);
    if (target == NKW_CLIP_FLOATS)
        return index + component;
    if (target == NKW_CLIP_ROTATION)
        return index;
    return clip_array_of(target, component) * stride + index;
}

/* The lanes of a track for array x, y or z (pass 0, 1, 2): one component; or one lane of a rotation; or all floats. */
static void emit_track(lanes *l, const clip_group *g, const nkw_clip_track *c, size_t pass)
{
    int is_rotation = c->target == NKW_CLIP_ROTATION, floats = c->target == NKW_CLIP_FLOATS;
    size_t first = is_rotation || floats ? 0 : pass, end = floats ? c->track.width : first + 1;
    for (size_t component = first; component < end; component++) {
        const int starts = floats ? !nkwi_clip_tracks_is_still(c, component) : pass == 0;
        size_t lane = add_lane(l, place_of(l->b, c->target, c->index, component), (uint32_t)starts);
        if (l->packed) {
            if (lane < PACKED_SLOTS)
                l->packed->track[lane] = c, l->packed->component[lane] = (uint32_t)component;
            continue;
        }
        if (l->b->words && g->ranges)
            nkwi_clip_fill_compact(l->b->words, g, c, component, lane);
        for (size_t row = 0; l->b->words && !g->ranges && row < (is_rotation ? 4u : 1u); row++)
            nkwi_clip_fill_component(l->b->words, g, c, component + row, row, lane);
    }
}

/* The value of a joint or float without an animated track: its constant track, its rest value, or the identity. */
static float constant_value(const builder *b, nkw_clip_target target, size_t index, size_t component)
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
 * The lanes of the joints from..to - 1, if they are a gap of the group of c (clip_tracks.h): the constant value in all
 * keys. Compact: base is the value, step and all keys are 0.
 */
static void emit_gap(lanes *l, const clip_group *g, const nkw_clip_track *c, size_t from, size_t to, size_t pass)
{
    const clip_tracks *t = &l->b->tracks;
    int is_rotation = c->target == NKW_CLIP_ROTATION;
    for (size_t joint = from; joint < to; joint++)
        if (!nkwi_clip_tracks_same_group(t, nkwi_clip_tracks_find_gap(t, c->target, joint), c))
            return;
    for (size_t joint = from; joint < to; joint++) {
        size_t lane = add_lane(l, place_of(l->b, c->target, joint, pass), 0);
        for (size_t row = 0; l->b->words && row < (is_rotation ? 4u : 1u); row++) {
            float value = constant_value(l->b, c->target, joint, is_rotation ? row : pass);
            size_t at = nkwi_clip_lane_at(g, clip_key_rows(g), row, lane);
            if (g->ranges)
                clip_floats_at(l->b->words, g->ranges)[at] = value;
            for (size_t k = 0; !g->ranges && k < c->track.count; k++)
                clip_floats_at(l->b->words, g->keys + k * g->key_words)[at] = value;
        }
    }
}

/*
 * The lanes of a group, in ascending order of places as far as possible, so that most are contiguous:
 *
 *     translation x of all joints, y of all, z of all; rotations; scale x, y, z; floats
 */
static lanes emit_lanes(builder *b, const clip_group *g, const uint32_t *members, size_t count, packed_lanes *packed)
{
    lanes l = lanes_begin(b, g->lanes, packed);
    for (int target = NKW_CLIP_TRANSLATION; target <= NKW_CLIP_FLOATS; target++) {
        int in_passes = target == NKW_CLIP_TRANSLATION || target == NKW_CLIP_SCALE;
        for (size_t pass = 0; pass < (in_passes ? 3u : 1u); pass++) {
            const nkw_clip_track *last = NULL;
            for (size_t i = 0; i < count; i++) {
                const nkw_clip_track *c = &b->tracks.source->tracks[members[i]];
                if ((int)c->target != target)
                    continue;
                emit_gap(&l, g, c, last ? last->index + 1 : 0, c->index, pass);
                emit_track(&l, g, c, pass);
                last = c;
            }
            if (last)
                emit_gap(&l, g, last, last->index + 1, b->tracks.source->joint_count, pass);
            if (target != NKW_CLIP_FLOATS)
                add_padding(&l, target == NKW_CLIP_ROTATION);
        }
    }
    if (l.count % CLIP_BLOCK != 0)
        end_block(&l);
    return l;
}

/* Groups and timelines. */

/* A timeline: its times, and the mode of each segment if the tracks have them. */
static void emit_timeline(builder *b, const nkw_track *t)
{
    size_t at = take(b, TIMELINES, sizeof(clip_timeline) / 4), times = take(b, TIMES, t->count);
    size_t modes = t->key_interpolation ? take(b, TIMES, t->count) : 0;
    if (!b->words)
        return;
    clip_timeline line = {(uint32_t)times, (uint32_t)t->count, (uint32_t)modes, 0.0f};
    (void)nkwi_segment_even_rate(t->times, t->count, &line.rate); /* 0 if there is none */
    memcpy(b->words + at, &line, sizeof line);
    memcpy(b->words + times, t->times, t->count * sizeof(float));
    for (size_t k = 0; modes && k < t->count; k++)
        b->words[modes + k] = t->key_interpolation[k];
}

/* Adds the contiguous lanes of a following block whose places continue those of this one; from the last block on. */
static void join_blocks(clip_block *blocks, size_t count)
{
    for (size_t i = count; i-- > 1;)
        if (blocks[i - 1].contiguous && blocks[i].contiguous && blocks[i].place == blocks[i - 1].place + CLIP_BLOCK)
            blocks[i - 1].contiguous += blocks[i].contiguous;
}

static uint64_t range_words(const clip_group *g)
{
    return round_up(2 * clip_rows(g) * g->lanes, CLIP_ALIGN);
}

/* Whether the keys of the group, stored as floats so far, take less memory as compact keys with their ranges. */
static int is_smaller_compact(const clip_group *g, size_t keys)
{
    clip_group compact = *g;
    compact.ranges = CLIP_ALIGN; /* any value but 0, for clip_rows */
    return range_words(&compact) + round_up(keys * clip_key_words(&compact), CLIP_ALIGN) <
           round_up(keys * clip_key_words(g), CLIP_ALIGN);
}

/* The words of the ranges and keys of a group; then the keys of a packed group, of the tracks of `packed`. */
static void take_keys(builder *b, clip_group *g, const packed_lanes *packed, size_t key_count)
{
    const nkw_clip_source *s = b->tracks.source;
    take(b, VALUES, round_up(b->used[VALUES], CLIP_ALIGN) - b->used[VALUES]);
    if (packed || (s->format == NKW_CLIP_UNORM16 && g->interpolation != NKW_INTERPOLATION_CUBICSPLINE &&
                   is_smaller_compact(g, key_count))) {
        g->ranges = CLIP_ALIGN; /* any value but 0, for clip_rows: the offset follows from the size */
        g->ranges = (uint32_t)take(b, VALUES, range_words(g));
    }
    g->packed = packed != NULL;
    g->key_words = packed ? 0 : (uint32_t)clip_key_words(g);
    g->keys = (uint32_t)take(b, VALUES, (uint64_t)g->key_words * key_count);
    if (packed)
        take(b, VALUES, nkwi_packed_fill(b->words, g, packed, s->tracks, b->tracks.packing));
}

/*
 * A group: `count` tracks with the same key times. The number of lanes determines the widths of blocks and the size of
 * keys, so the lanes are emitted twice: to a copy of the builder that writes nothing, to count them, then to b.
 * packed: NULL, or cleared.
 */
static void emit_group(builder *b, uint32_t timeline, const uint32_t *members, size_t count, packed_lanes *packed)
{
    const nkw_track *first = &b->tracks.source->tracks[members[0]].track;
    clip_group g;
    builder probe = *b;
    probe.words = NULL;
    memset(&g, 0, sizeof g);
    g.timeline = timeline;
    g.kind = (uint32_t)clip_kind_of(&b->tracks.source->tracks[members[0]]);
    g.interpolation = (uint32_t)clip_interpolation_of(first);
    g.normalized = track_is_cubic(first) && clip_is_normalized(first);
    g.lanes = (uint32_t)clip_lanes(emit_lanes(&probe, &g, members, count, packed).count);
    take_keys(b, &g, packed, first->count);
    lanes l = emit_lanes(b, &g, members, count, packed);
    size_t at = take(b, GROUPS, sizeof g / 4);
    g.blocks = (uint32_t)l.blocks;
    g.block_count = (uint32_t)round_up(l.count, CLIP_BLOCK) / CLIP_BLOCK;
    if (!b->words)
        return;
    join_blocks((clip_block *)(void *)(b->words + g.blocks), g.block_count);
    if (g.kind == GROUP_ROTATIONS && g.interpolation == NKW_INTERPOLATION_LINEAR && !g.ranges)
        nkwi_clip_fill_arcs(b->words, &g, first->count);
    memcpy(b->words + at, &g, sizeof g);
}

/* Whether `count` members have at most PACKED_SLOTS numbers, with all padding. */
static int fits_packed(const builder *b, const uint32_t *members, size_t count)
{
    builder probe = *b;
    packed_lanes ignored;
    clip_group g;
    memset(&g, 0, sizeof g);
    probe.words = NULL;
    size_t rows = b->tracks.source->tracks[members[0]].target == NKW_CLIP_ROTATION ? 3 : 1;
    return rows * clip_lanes(emit_lanes(&probe, &g, members, count, &ignored).count) <= PACKED_SLOTS;
}

/* Groups of as many members as a packed group may have. */
static void emit_packed_groups(builder *b, uint32_t timeline, const uint32_t *members, size_t count)
{
    while (count > 0) {
        size_t n = count < PACKED_SLOTS / 3 ? count : PACKED_SLOTS / 3;
        packed_lanes packed;
        memset(&packed, 0, sizeof packed);
        while (n > 1 && !fits_packed(b, members, n))
            n--;
        emit_group(b, timeline, members, n, &packed);
        members += n;
        count -= n;
    }
}

/* A group is a range of by_group with equal timeline and equal nkwi_clip_tracks_group. Constant tracks are last. */
static void emit_groups(builder *b)
{
    const clip_tracks *t = &b->tracks;
    const nkw_clip_track *tracks = t->source->tracks;
    size_t from = 0, to = 0, count = t->source->track_count;
    for (uint32_t lines = 0; from < count && t->timeline[t->by_group[from]] != CLIP_CONSTANT; from = to) {
        uint32_t first = t->by_group[from], line = t->timeline[first];
        while (to < count && t->timeline[t->by_group[to]] == line &&
               nkwi_clip_tracks_group(t, &tracks[t->by_group[to]]) == nkwi_clip_tracks_group(t, &tracks[first]))
            to++;
        if (from == 0 || t->timeline[t->by_group[from - 1]] != line) {
            emit_timeline(b, &tracks[first].track);
            lines++;
        }
        if (nkwi_clip_tracks_is_packed(t, &tracks[first]))
            emit_packed_groups(b, lines - 1, t->by_group + from, to - from);
        else
            emit_group(b, lines - 1, t->by_group + from, to - from, NULL);
    }
}

/* Constants: values of constant tracks, and rest values of joints and floats without a track. */

/*
 * The runs of one output. Each has its values contiguous, because nothing else is emitted meanwhile.
 *
 *     places    7  8  9  .  .  12 13      .: animated, a gap of at most CLIP_RUN_GAP
 *     run       to 7, count 7: values c7 c8 c9 0 0 c12 c13; the groups then overwrite the zeros
 */
typedef struct constants {
    builder *b;
    size_t at, count; /* the runs */
    size_t next; /* the place after the last value */
} constants;

static void add_value(constants *c, float value)
{
    size_t at = take(c->b, VALUES, 1);
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
        add_constant(c, to, constant_value(c->b, target, index, component));
    return 1;
}

/*
 * The constants of the ten component arrays, in the order of the pose. If the last joint of an array is not animated,
 * the padding follows, with the values of the identity. Returns the number of runs.
 */
static size_t emit_pose_constants(builder *b)
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
        int is_constant = 0;
        for (size_t j = 0; j < s->joint_count; j++)
            is_constant = emit_constant(&c, targets[array], j, components[array], array * stride + j);
        for (size_t j = s->joint_count; is_constant && j < stride; j++)
            add_constant(&c, array * stride + j, identity);
    }
    return c.count;
}

static size_t emit_float_constants(builder *b)
{
    const nkw_clip_source *s = b->tracks.source;
    constants c = {b, (size_t)(b->start[RUNS] + b->used[RUNS]), 0, 0};
    for (size_t f = 0; f < s->float_count; f++)
        emit_constant(&c, NKW_CLIP_FLOATS, f, 0, f);
    return c.count;
}

/* Names. */

/* Name 0 is that of the clip, name 1 + j that of joint j. */
static const char *name_at(const nkw_clip_names *names, size_t k)
{
    const char *name = k == 0 ? names->clip : names->joints ? names->joints[k - 1] : NULL;
    return name ? name : "";
}

static void emit_names(builder *b)
{
    const nkw_clip_names *names = b->tracks.source->names;
    size_t count = 1 + b->tracks.source->joint_count;
    if (!names)
        return;
    uint32_t *offsets = b->words ? b->words + b->start[NAMES] : NULL;
    uint64_t bytes = 4 * (uint64_t)count;
    for (size_t k = 0; k < count; k++) {
        const char *name = name_at(names, k);
        if (offsets)
            offsets[k] = (uint32_t)bytes;
        do { /* one byte at a time: the library does not import strlen */
            if (offsets)
                ((char *)offsets)[bytes] = *name;
            bytes++;
        } while (*name++);
    }
    take(b, NAMES, bytes <= UINT32_MAX ? round_up(bytes, 4) / 4 : (uint64_t)UINT32_MAX + 1);
}

/* The block. */

static void emit_header(builder *b, size_t pose_runs, size_t float_runs)
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
    head.names = (uint32_t)b->start[NAMES];
    head.name_words = (uint32_t)b->used[NAMES];
    memcpy(b->words, &head, sizeof head);
}

/* The order of these calls is the order of the elements in each section. */
static void emit_clip(builder *b)
{
    size_t pose_runs = emit_pose_constants(b), float_runs = emit_float_constants(b);
    emit_groups(b);
    emit_names(b);
    if (b->words)
        emit_header(b, pose_runs, float_runs);
}

/*
 * Pass 1: measures all sections, then sets their starts in the order of the enumeration. Leaves `used` at 0 for pass 2.
 * A block must have less than 2^32 - 1 words and fit size_t bytes.
 */
static nkw_result plan(builder *b, const nkw_clip_source *source, const clip_packing *packing, size_t *bytes,
                       size_t *bad, nkw_work work)
{
    memset(b, 0, sizeof *b);
    b->start[VALUES] = CLIP_ALIGN; /* any value but 0: an offset 0 of ranges means that there are none */
    nkw_result result = nkwi_clip_tracks_order(source, packing, &b->tracks, bad, work);
    if (result != NKW_OK)
        return result;
    emit_clip(b);
    uint64_t at = sizeof(nkw_clip) / 4;
    for (int s = 0; s < SECTIONS; s++) {
        b->start[s] = at = s == VALUES ? round_up(at, CLIP_ALIGN) : at;
        at += b->used[s];
        b->used[s] = 0;
    }
    b->listed = 0;
    if (at >= UINT32_MAX || at > SIZE_MAX / 4)
        return NKW_OUT_OF_RANGE;
    *bytes = (size_t)at * 4;
    return NKW_OK;
}

/* The same; a compact clip that is not smaller than one of floats becomes one. source: of the caller, in its format. */
static nkw_result plan_smaller(builder *b, nkw_clip_source *source, const clip_packing *packing, size_t *bytes,
                               size_t *bad, nkw_work work)
{
    size_t floats = 0;
    if (source->format != NKW_CLIP_UNORM16)
        return plan(b, source, packing, bytes, bad, work);
    source->format = NKW_CLIP_FLOAT32;
    const nkw_result of_floats = plan(b, source, packing, &floats, bad, work);
    source->format = NKW_CLIP_UNORM16;
    nkw_result result = plan(b, source, packing, bytes, bad, work);
    if (result == NKW_OK && of_floats == NKW_OK && floats <= *bytes) {
        source->format = NKW_CLIP_FLOAT32;
        result = plan(b, source, packing, bytes, bad, work);
    }
    return result;
}

nkw_result nkwi_clip_build(const nkw_clip_source *source, const clip_packing *packing, nkw_bytes_span block,
                           size_t *bytes, size_t *bad, nkw_work work)
{
    builder b;
    nkw_clip_source chosen = *source;
    size_t ignored = 0, needed = 0;
    *bytes = 0;
    nkw_result result = plan_smaller(&b, &chosen, packing, &needed, bad ? bad : &ignored, work);
    if (result != NKW_OK)
        return result;
    *bytes = needed;
    if (!block.data || block.bytes < needed)
        return NKW_TOO_SMALL;
    memset(block.data, 0, needed);
    b.words = (uint32_t *)block.data;
    emit_clip(&b);
    return NKW_OK;
}

nkw_result nkw_clip_build(const nkw_clip_source *source, nkw_bytes_span block, size_t *bytes, size_t *bad,
                          nkw_work work)
{
    return nkwi_clip_build(source, NULL, block, bytes, bad, work);
}
