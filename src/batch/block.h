/* SPDX-License-Identifier: MIT */
#ifndef NAKAWARI_BATCH_BLOCK_H
#define NAKAWARI_BATCH_BLOCK_H

#include <stddef.h>
#include <stdint.h>

#include <nakawari/types.h>

#define NKW_BLOCK      16 /* lanes: the widest vector, so that loops over a block have no remainder */
#define NKW_BLOCK_ROWS 5 /* x y z w of rotations and v of their arcs */

/*
 * A block of a clip's lanes: width 4, 8 or 16. The first `count` are lanes of tracks, the rest fill it up: lane i
 * goes to the float places[i] of each component of the output.
 *
 * direct: how many lanes from the first of this block on go to places[0], places[0] + 1, places[0] + 2 ... and may be
 * written there in one stream: this block and maybe others after it, all of them whole. 0 where this block is scattered
 * lane by lane.
 */
typedef struct nkw_block {
    uint32_t width, count, direct;
    uint32_t places[NKW_BLOCK];
} nkw_block;

/* Rows of a block that stand `width` floats apart. */
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
