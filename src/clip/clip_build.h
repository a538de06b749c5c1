/* SPDX-License-Identifier: MIT */
/*
 * The builder of the block of a clip (clip_layout.h). Its calls run twice, in the same order:
 *
 *     1. plan      words == NULL: clip_take() only counts the words of each section. Then their starts are known.
 *     2. build     words is the block: clip_take() returns the offsets at which the elements are written.
 *
 * Invariant: both passes take the same words in the same order; whether something is taken never depends on `words`.
 * Only of packed keys pass 1 may count more (clip_packing.is_most); they are in the last section.
 *
 *     pass 1    used         timelines 8   groups 22   blocks 18   places 5   ...          words, counted
 *     plan      start        17            25          47          65         70 ...       17 words of header first
 *     pass 2    clip_take()  start + used  -> the offset of the next element, used grows as in pass 1
 *
 * Order within the sections:
 *
 *     runs      of the pose, then of the floats
 *     values    constants of the pose; constants of the floats; of each group its ranges and its keys
 *     groups    by timeline; a timeline is emitted before its first group
 */
#ifndef NAKAWARI_CLIP_BUILD_H
#define NAKAWARI_CLIP_BUILD_H

#include "clip_tracks.h"

typedef enum clip_section {
    SECTION_TIMELINES,
    SECTION_GROUPS,
    SECTION_BLOCKS,
    SECTION_PLACES,
    SECTION_RUNS,
    SECTION_TIMES,
    SECTION_NAMES,
    SECTION_VALUES,
    SECTION_COUNT
} clip_section;

typedef struct clip_builder {
    clip_tracks tracks;
    uint32_t *words; /* the block; NULL in pass 1 */
    uint64_t start[SECTION_COUNT],
        used[SECTION_COUNT]; /* words; in pass 1 they may exceed 2^32, the limit of a block */
    size_t listed; /* tracks of the lanes so far, as nkw_clip_describe counts them */
} clip_builder;

/* The offset, from the beginning of the block, of the next element of a section. */
static inline size_t clip_next(const clip_builder *b, clip_section s)
{
    return (size_t)(b->start[s] + b->used[s]);
}

/*
 * Takes words of a section; those of values are cleared. Returns their offset.
 *
 * More than 2^32 - 1 words count as 2^32: no sum overflows 64 bits, and the block is still found to be too large.
 */
static inline size_t clip_take(clip_builder *b, clip_section s, uint64_t words)
{
    size_t at = clip_next(b, s);
    b->used[s] += words <= UINT32_MAX ? words : (uint64_t)UINT32_MAX + 1;
    if (b->words && s == SECTION_VALUES)
        memset(b->words + at, 0, (size_t)words * sizeof *b->words);
    return at;
}

/* Takes words of values that are written already: a packed group has fewer than pass 1 counted. */
static inline void clip_took(clip_builder *b, uint64_t words)
{
    b->used[SECTION_VALUES] += words <= UINT32_MAX ? words : (uint64_t)UINT32_MAX + 1;
}

static inline uint64_t clip_round_up(uint64_t n, uint64_t to)
{
    return (n + to - 1) / to * to;
}

/* The lanes of one group: how many, with gaps and padding; and the offset of its first block. */
typedef struct clip_built_lanes {
    size_t count, blocks;
} clip_built_lanes;

/*
 * Emits the blocks and places of the lanes of a group, `count` tracks, and writes its keys if they are not packed.
 *
 * g->lanes is the sum of the widths of all blocks, which the width of the last block depends on; 0 where the lanes are
 * only counted. packed: receives the tracks of the lanes of a packed group, or NULL.
 */
clip_built_lanes nkwi_clip_build_lanes(clip_builder *b, const clip_group *g, const uint32_t *members, size_t count,
                                       packed_lanes *packed);

/* All timelines, and the groups of each. */
void nkwi_clip_build_groups(clip_builder *b);

/* The value of a joint or float without an animated track: its constant track, its rest value, or the identity. */
float nkwi_clip_build_constant(const clip_builder *b, nkw_clip_target target, size_t index, size_t component);

/* The constants of the pose, and of the floats. Return the number of runs. */
size_t nkwi_clip_build_pose_constants(clip_builder *b);
size_t nkwi_clip_build_float_constants(clip_builder *b);

#endif
