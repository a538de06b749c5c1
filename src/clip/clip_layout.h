/* SPDX-License-Identifier: MIT */
/*
 * The memory of a clip: 32-bit words. All offsets are in words from the beginning.
 *
 *     section      element          words   number
 *     header       nkw_clip         17      1
 *     timelines    clip_timeline     4      timeline_count
 *     groups       clip_group       11      group_count
 *     blocks       clip_block        6      (lanes + 15) / 16 of each group
 *     places       uint32_t          1      count of each block that is not contiguous
 *     runs         clip_run          3      constant_count, then float_constant_count
 *     times        float             1      count of each timeline; then its modes, if any, a word each
 *     names        uint32_t, char           of the clip, of each joint, then of each float or of none, where its text
 *                                           begins, in bytes from the beginning of the section; then the texts in
 *                                           this order, each with its NUL; or nothing
 *     values       float, uint16_t          constants; of each group its ranges, if any, and its keys
 *
 * Values begin at a multiple of CLIP_ALIGN words, and so do the ranges and keys of each group; in a clip with packed
 * groups only those of the others.
 *
 * Timeline   the ascending key times, in seconds, of one or more groups: one search for all of them.
 * Group      the tracks of one timeline, one kind and one interpolation: one loop for all of them.
 * Lane       one number of a pose; one of the floats; or the rotation of one joint.
 * Block      16 neighbouring lanes of a group; the last block has 4, 8 or 16.
 * Place      the destination of a lane: a float of the pose, of one component array of the rotations, or of the floats.
 * Run        contiguous values that no track changes: copied to the output before the groups are sampled. A run of
 *            the pose that is equal for a while has one value of each CLIP_FILL places, as scales of 1 are.
 *
 * A key stores its blocks one after another. A block stores its rows one after another, of `width` floats each:
 *
 *     group                            rows of a block
 *     numbers, floats                  1: value
 *     rotations, STEP                  4: x y z w
 *     rotations, LINEAR                5: x y z w v; v is the arc to the next key (lane_slerp_arc); 0 in the last key
 *     CUBICSPLINE                      as numbers or as STEP, three times: in-tangents of all blocks, values of all
 *                                      blocks, out-tangents of all blocks; tangents are per second
 *
 * Example: a key of 20 LINEAR rotations, key_words = 5 * 20 = 100.
 *
 *     word   0         16        32        48        64        80       84    88    92    96
 *            | x0..x15 | y0..y15 | z0..z15 | w0..w15 | v0..v15 | x16..19 | y   | z   | w   | v   |
 *            |-------------------- block 0 --------------------|------------- block 1 -----------|
 *
 * Compact groups (ranges != 0; STEP and LINEAR only) store 16-bit keys in the same order, two in a word, and one range
 * for each row of each lane: `base` of all rows in the order of a key, then `step` of all rows.
 *
 *     number = base + step key,  key in 0..65535
 *
 * A compact rotation has 3 rows, x y z of lane/compact.h, and no arc. Of q and -q, each key stores one. If the sum of its
 * three numbers is odd, slerp from the previous key negates it.
 *
 * Packed groups (packed != 0; LINEAR only) have ranges too, and store their keys as clip_packed.h describes.
 *
 * Lanes of one component array whose joints are neighbours are contiguous, so short gaps get lanes too: up to four
 * constant joints between the joints of a group, with the same value in all keys (clip_tracks.h).
 */
#ifndef NAKAWARI_CLIP_LAYOUT_H
#define NAKAWARI_CLIP_LAYOUT_H

#include <stdint.h>

#include <nakawari/clip.h>

#include "batch/block.h"

#define CLIP_MAGIC   0x70696c63u /* "clip", lowest byte first */
#define CLIP_VERSION 9u
#define CLIP_STEPS   65535.0f /* steps of a range: the largest 16-bit key */
#define CLIP_ALIGN   16u /* words: 64 bytes, a cache line */

/* Limits: offsets in a pose, numbers of lanes and words of a key are less than 2^32; bytes of a pose fit size_t. */
#define CLIP_MAX_JOINTS (1u << 26)
#define CLIP_MAX_FLOATS (1u << 29)

/*
 * Copies the words values..values + n - 1 to the floats to..to + n - 1 of the output; those of a fill, which are equal,
 * CLIP_FILL times each, the last one less often.
 *
 *     count    n, less than 2^31;    CLIP_IS_FILL + n of a fill: ceil(n / CLIP_FILL) words, n at least CLIP_FILL
 */
typedef struct clip_run {
    uint32_t values, to, count;
} clip_run;

#define CLIP_IS_FILL 0x80000000u

static inline uint32_t clip_run_floats(const clip_run *r)
{
    return r->count & ~CLIP_IS_FILL;
}

static inline uint32_t clip_run_words(const clip_run *r)
{
    const uint32_t n = clip_run_floats(r);
    return r->count & CLIP_IS_FILL ? (n + CLIP_FILL - 1) / CLIP_FILL : n;
}

struct nkw_clip {
    uint32_t magic, version, words; /* words: of the whole block */
    uint32_t joints, floats;
    float start, end; /* seconds */
    uint32_t timelines, timeline_count;
    uint32_t groups, group_count; /* groups of one timeline are neighbours */
    uint32_t constants, constant_count; /* runs of the pose */
    uint32_t float_constants, float_constant_count; /* runs of the floats */
    uint32_t names, name_words; /* 0 words: there are no names */
};

typedef struct clip_timeline {
    uint32_t times, count;
    uint32_t modes; /* count words, an nkw_interpolation for each segment; 0: all segments have that of the group */
    float rate; /* nkwi_segment_even_rate of the times; 0 if there is none */
} clip_timeline;

typedef enum clip_kind { GROUP_NUMBERS, GROUP_ROTATIONS, GROUP_FLOATS, GROUP_KINDS } clip_kind;

typedef struct clip_group {
    uint32_t timeline, kind, interpolation; /* index, clip_kind, nkw_interpolation */
    uint32_t normalized; /* CUBICSPLINE rotations are normalised at keys too */
    uint32_t lanes; /* the sum of the widths of all blocks */
    uint32_t blocks, block_count;
    uint32_t keys, key_words; /* offset of key 0, words of each key */
    uint32_t ranges; /* offset of the ranges of a compact or packed group, otherwise 0 */
    uint32_t packed; /* 1: a packed group */
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

static inline const clip_block *clip_blocks(const nkw_clip *clip, const clip_group *g)
{
    return (const clip_block *)(const void *)(clip_words(clip) + g->blocks);
}

/* How many tracks begin in a block. */
static inline uint32_t clip_starts(const clip_block *b)
{
    uint32_t count = 0;
    for (uint32_t starts = b->starts; starts; starts &= starts - 1)
        count++;
    return count;
}

/* The place of lane i of a block. */
static inline uint32_t clip_place_of(const clip_block *b, uint32_t i)
{
    return b->contiguous ? b->place + i : block_places(b)[i];
}

/* The lane of a place; the number of lanes if the group does not write it. Places of lanes ascend: by bisection. */
static inline size_t clip_lane_of(const nkw_clip *clip, const clip_group *g, size_t place)
{
    const clip_block *blocks = clip_blocks(clip, g);
    size_t low = 0, high = g->block_count;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (blocks[middle].count > 0 && clip_place_of(&blocks[middle], 0) <= place)
            low = middle;
        else
            high = middle;
    }
    for (uint32_t i = 0; i < blocks[low].count; i++)
        if (clip_place_of(&blocks[low], i) == place)
            return low * CLIP_BLOCK + i;
    return g->lanes;
}

/* Whether a place is that of the first number of a property: of a joint, not of padding. */
static inline int clip_begins(const nkw_clip *clip, uint32_t kind, uint32_t place)
{
    const size_t stride = NKW_POSE_STRIDE((size_t)clip->joints);
    return kind == GROUP_FLOATS ||
           (place % stride < clip->joints && (place < stride || (kind == GROUP_NUMBERS && place / stride == 7)));
}

static inline const float *clip_floats(const nkw_clip *clip, uint32_t offset)
{
    return (const float *)(const void *)(clip_words(clip) + offset);
}

/* The number of names, after which the text of name 0 begins: 1 + joints, + floats if they are named; 0 without names. */
static inline size_t clip_name_count(const nkw_clip *clip)
{
    return clip->name_words ? clip_words(clip)[clip->names] / 4 : 0;
}

/* The text of name k: 0 of the clip, 1 + j of joint j, 1 + joints + i of float i. */
static inline const char *clip_name(const nkw_clip *clip, size_t k)
{
    const uint32_t *names = clip_words(clip) + clip->names;
    return clip->name_words ? (const char *)names + names[k] : "";
}

/* The number of listed tracks: those that begin in all lanes. */
static inline size_t clip_track_count(const nkw_clip *clip)
{
    if (clip->group_count == 0)
        return 0;
    const clip_group *g = clip_groups(clip) + clip->group_count - 1;
    const clip_block *last = clip_blocks(clip, g) + g->block_count - 1;
    return last->first + (size_t)clip_starts(last);
}

/* The lanes of the blocks that contain `count` lanes: `count` rounded up so that the last block has 4, 8 or 16. */
static inline size_t clip_lanes(size_t count)
{
    size_t last = count % CLIP_BLOCK; /* lanes of a last block that is not full */
    return count - last + (last == 0 ? 0 : last <= 4 ? 4 : last <= 8 ? 8 : CLIP_BLOCK);
}

/* The rows of a value, and of a key. */
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
    return g->kind == GROUP_ROTATIONS && g->interpolation == NKW_INTERPOLATION_LINEAR ? CLIP_SLERP_ROWS : clip_rows(g);
}

/* The words of a key. Lanes are a multiple of 4, so a compact key is a whole number of words. */
static inline uint64_t clip_key_words(const clip_group *g)
{
    uint64_t numbers = (uint64_t)clip_key_rows(g) * g->lanes;
    return g->ranges ? numbers / 2 : numbers;
}

#endif
