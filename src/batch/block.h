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
 * contiguous  0: lane i is written to places[i], one by one. Otherwise the number of lanes, from lane 0 of this block
 *             on, whose places are places[0], places[0] + 1, places[0] + 2 ...: they are written by vector stores. They
 *             are those of this block, and possibly of following blocks, always of whole blocks.
 * places      of each lane: its float in the component of the output
 */
typedef struct clip_block {
    uint32_t width, count, contiguous;
    uint32_t places[CLIP_BLOCK];
} clip_block;

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
