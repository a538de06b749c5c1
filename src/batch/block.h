/* SPDX-License-Identifier: MIT */
#ifndef NAKAWARI_BATCH_BLOCK_H
#define NAKAWARI_BATCH_BLOCK_H

#include <stdint.h>

#define NKW_BLOCK      16 /* lanes: the widest vector, so that loops over a block have no remainder */
#define NKW_BLOCK_ROWS 9 /* x y z w and v h0 h1 h2 h3 of rotations with their arcs */

/*
 * A block of a clip's lanes: width 4, 8 or 16, of which `count` go to the floats places[i] of each component of the output.
 * `direct` is 0, or the number of lanes from the first of this block on, whole blocks, that go to the floats from places[0] on one
 * after the other, padding of the pose among them.
 */
typedef struct nkw_block {
    uint32_t width, count, direct;
    uint32_t places[NKW_BLOCK];
} nkw_block;

#endif
