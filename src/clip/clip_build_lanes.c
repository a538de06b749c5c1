/* SPDX-License-Identifier: MIT */
/*
 * The lanes of a group and their blocks (clip_build.h).
 *
 * Invariant: lanes come in ascending places as far as possible, so that neighbours in the output are neighbours in the
 * keys, and a full block of 16 neighbours needs no list of places: sampling writes it by vector stores.
 *
 * A group that moves the translations of 12 joints but joint 5, in a pose of stride 16. Joint 5 is a gap: its lanes have
 * one value in all keys. The places 12 to 15 of each component array are padding:
 *
 *     lane        0 ... 4   5     6 ... 11   12 ... 15   | 16 ... 31      | 32 ... 47
 *     number      x         x     x          0           | y, as before   | z, as before
 *     place       0 ... 4   5     6 ... 11   12 ... 15   | 16 ... 31      | 32 ... 47
 *     starts      1         0     1          0           | 0              | 0               first component of a track
 *     block       0: 48 contiguous from place 0          | 1: 32 from 16  | 2: 16 from 32
 *
 * Without the lanes of gap and padding no block would be contiguous.
 */
#include "lane/strict.h"

#include <string.h>

#include "clip_build.h"
#include "clip_keys.h"

/* The lanes of one group, in the order in which they are emitted. */
typedef struct lanes {
    clip_builder *b;
    size_t expected; /* the sum of the widths of all blocks; 0 until all lanes are counted */
    size_t count, blocks; /* lanes so far; the offset of the first block */
    size_t next, length; /* the place after the last lane; how many lanes up to the last have contiguous places */
    uint32_t places[CLIP_BLOCK]; /* of the lanes of the last block */
    uint32_t starts, first; /* of the last block (batch/block.h) */
    packed_lanes *packed; /* receives the tracks of the lanes of a packed group; otherwise NULL */
} lanes;

static lanes lanes_begin(clip_builder *b, size_t expected, packed_lanes *packed)
{
    lanes l = {b, expected, 0, clip_next(b, SECTION_BLOCKS), 0, 0, {0}, 0, 0, packed};
    return l;
}

/*
 * Takes the block that ends with the last lane. It is contiguous if it is full and its places are. The `place` of
 * another block is the distance from its clip_block to its places, in words (batch/block.h).
 */
static void end_block(lanes *l)
{
    size_t count = (l->count - 1) % CLIP_BLOCK + 1, left = l->expected - (l->count - count);
    size_t width = left < CLIP_BLOCK ? left : CLIP_BLOCK, at = clip_take(l->b, SECTION_BLOCKS, sizeof(clip_block) / 4);
    int is_contiguous = count == width && l->length >= count;
    size_t places = is_contiguous ? 0 : clip_take(l->b, SECTION_PLACES, count);
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
static size_t place_of(const clip_builder *b, nkw_clip_target target, size_t index, size_t component)
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
            float value = nkwi_clip_build_constant(l->b, c->target, joint, is_rotation ? row : pass);
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
clip_built_lanes nkwi_clip_build_lanes(clip_builder *b, const clip_group *g, const uint32_t *members, size_t count,
                                       packed_lanes *packed)
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
    return (clip_built_lanes){l.count, l.blocks};
}
