/* SPDX-License-Identifier: MIT */
/*
 * A clip's block: 32-bit words throughout. Offsets are in words from the beginning of the block.
 *
 *     head | timelines | groups | blocks | runs | times | constants | key blocks
 *
 * A group holds the tracks of one timeline that are sampled alike. Its lanes are single numbers, or joints where it
 * turns; they stand in blocks of 16, the last one of 4, 8 or 16. A key holds block after block; in a block of `width`
 * lanes stand
 *
 *     GROUP_NUMBERS, GROUP_FLOATS   numbers[width]                               (into the pose; into the floats)
 *     GROUP_ROTATIONS               x[width] y[width] z[width] w[width]
 *                                   and for LINEAR the arc to the next key: v[width]
 *
 * A group that moves the joints on both sides of a few that nothing changes has lanes for these too (clip_tracks.h).
 *
 * A CUBICSPLINE key is its in-tangents, its values and its out-tangents, each laid out so.
 *
 * A compact group has 16-bit numbers in its keys, in the same order, and the range of each, once: the bases of all
 * numbers of a key, then the steps of all, number = base + step key. Those of a rotation are the three that
 * lane/clip.h makes of it, x[width] y[width] z[width], without arcs; where the sum of the three in the key is odd,
 * slerp from the key before goes to -q.
 */
#ifndef NAKAWARI_CLIP_LAYOUT_H
#define NAKAWARI_CLIP_LAYOUT_H

#include <stdint.h>

#include <nakawari/clip.h>

#include "batch/block.h"

#define CLIP_MAGIC   0x70696c63u /* "clip", lowest byte first */
#define CLIP_VERSION 5u
#define CLIP_STEPS   65535.0f /* of a range */
#define CLIP_ALIGN   16u /* words: key blocks and constants begin on 64 bytes of the block */

/* So that offsets in a pose, lanes and the words of a key fit 32 bits, and a pose's bytes any size_t. */
#define CLIP_MOST_JOINTS (1u << 26)
#define CLIP_MOST_FLOATS (1u << 29)

/* Words from `values` on go to floats to..to + count - 1 of the output. */
typedef struct clip_run {
    uint32_t values, to, count;
} clip_run;

struct nkw_clip {
    uint32_t magic, version, words;
    uint32_t joints, floats;
    float start, end;
    uint32_t timelines, timeline_count;
    uint32_t groups, group_count;
    uint32_t constants, constant_count; /* runs of what never changes: in the pose, */
    uint32_t float_constants, float_constant_count; /* and in the floats */
};

typedef struct clip_timeline {
    uint32_t times, count;
    uint32_t modes; /* count words, an nkw_interpolation for each segment; 0: that of the group */
    float rate; /* keys per second of an evenly spaced timeline, else 0 */
} clip_timeline;

typedef enum clip_kind { GROUP_NUMBERS, GROUP_ROTATIONS, GROUP_FLOATS, GROUP_KINDS } clip_kind;

typedef struct clip_group {
    uint32_t timeline, kind, interpolation;
    uint32_t normalized; /* CUBICSPLINE rotations are unit at keys too */
    uint32_t lanes; /* of all blocks together */
    uint32_t blocks, block_count;
    uint32_t keys, key_words;
    uint32_t ranges; /* of a compact group; else 0 */
} clip_group;

static inline const uint32_t *clip_words(const nkw_clip *clip)
{
    return (const uint32_t *)(const void *)clip;
}

static inline const clip_timeline *clip_timelines(const nkw_clip *clip)
{
    return (const clip_timeline *)(const void *)(clip_words(clip) + clip->timelines);
}

static inline const clip_group *clip_groups(const nkw_clip *clip)
{
    return (const clip_group *)(const void *)(clip_words(clip) + clip->groups);
}

static inline const nkw_block *clip_blocks(const nkw_clip *clip, const clip_group *g)
{
    return (const nkw_block *)(const void *)(clip_words(clip) + g->blocks);
}

static inline const float *clip_floats(const nkw_clip *clip, uint32_t offset)
{
    return (const float *)(const void *)(clip_words(clip) + offset);
}

/* Lanes of all blocks together that hold `count`: full blocks and a narrower last one. */
static inline size_t clip_lanes(size_t count)
{
    size_t rest = count % NKW_BLOCK;
    return count - rest + (rest == 0 ? 0 : rest <= 4 ? 4 : rest <= 8 ? 8 : NKW_BLOCK);
}

/* Floats of a lane in a value, and in a key. */
static inline size_t clip_rows(const clip_group *g)
{
    return g->kind != GROUP_ROTATIONS ? 1 : g->ranges ? 3 : 4;
}

static inline size_t clip_key_rows(const clip_group *g)
{
    if (g->interpolation == NKW_INTERPOLATION_CUBICSPLINE)
        return 3 * clip_rows(g);
    if (g->ranges)
        return clip_rows(g);
    return g->kind == GROUP_ROTATIONS && g->interpolation == NKW_INTERPOLATION_LINEAR ? NKW_BLOCK_ROWS : clip_rows(g);
}

/* Words of a key. Lanes are a multiple of 4, so those of a compact one are whole. */
static inline uint64_t clip_key_words(const clip_group *g)
{
    uint64_t numbers = (uint64_t)clip_key_rows(g) * g->lanes;
    return g->ranges ? numbers / 2 : numbers;
}

#endif
