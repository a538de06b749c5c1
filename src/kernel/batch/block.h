/* SPDX-License-Identifier: MIT */
#ifndef NAKAWARI_BATCH_BLOCK_H
#define NAKAWARI_BATCH_BLOCK_H

#include <stddef.h>
#include <stdint.h>

#include <nakawari/types.h>

#include "sizes.h"

#define CLIP_SLERP_ROWS 5 /* rows of a LINEAR rotation: x y z w, and the arc v to the next key */
#define CLIP_KEPT_ROWS  11 /* rows kept of two compact rotations (batch/clip.c) */

/*
 * A block of lanes of a clip (clip_layout.h): the destinations of up to 16 lanes.
 *
 * width       lanes in each row of a key: 16; 4, 8 or 16 in the last block of a group
 * count       lanes that are written, at most width. The others are padding: computed, but not written.
 * contiguous  0: lane i is written to the place block_places(block)[i], one by one. Otherwise the number of lanes, from
 *             lane 0 of this block on, whose places are place, place + 1, place + 2 ...: they are written by vector
 *             stores. They are those of this block, and possibly of following blocks, always of whole blocks.
 * place       of lane 0 if contiguous: its float in the component of the output; otherwise the distance from this block
 *             to the places of its lanes, in words
 * starts      a bit for each lane: 1 if it is the first of a track (clip_list.c); 0 of other components and of gaps
 * first       the number of tracks of all blocks before this one: the index of its first track
 */
typedef struct clip_block {
    uint32_t width, count, contiguous, place, starts, first;
} clip_block;

/* The places of the lanes of a block that is not contiguous. */
static inline const uint32_t *block_places(const clip_block *block)
{
    return (const uint32_t *)(const void *)block + block->place;
}

/* The rows x, y, z, w at x, at a distance of `width` floats. */
static inline nkw_quat_view block_rows(const float *x, size_t width)
{
    nkw_quat_view view = {x, x + width, x + 2 * width, x + 3 * width};
    return view;
}

static inline nkw_quat_span block_rows_to(float *x, size_t width)
{
    nkw_quat_span span = {x, x + width, x + 2 * width, x + 3 * width};
    return span;
}

#endif
