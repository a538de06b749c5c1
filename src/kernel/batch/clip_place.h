/* SPDX-License-Identifier: MIT */
/* Copies computed lanes of a clip to their places in the output (block.h). */
#ifndef NAKAWARI_BATCH_CLIP_PLACE_H
#define NAKAWARI_BATCH_CLIP_PLACE_H

#include "lane/strict.h"

#include <string.h>

#include "batch/block.h"
#include "batch/isa.h"
#include "sizes.h"

/* Copies rotations in rows at a distance of from_stride floats to their places; two neighbouring lanes at a time. */
static inline void scatter(const clip_block *block, const float *from, size_t from_stride, float *out, size_t stride)
{
    const uint32_t *places = block_places(block);
    size_t i = 0;
    for (; i + 1 < block->count; i += 2) {
        float *to = out + places[i];
        if (places[i + 1] - places[i] == 1)
            for (size_t row = 0; row < 4; row++)
                memcpy(to + row * stride, from + row * from_stride + i, 2 * sizeof *to);
        else
            for (size_t row = 0; row < 4; row++) {
                to[row * stride] = from[row * from_stride + i];
                out[places[i + 1] + row * stride] = from[row * from_stride + i + 1];
            }
    }
    for (size_t row = 0; i < block->count && row < 4; row++)
        out[places[i] + row * stride] = from[row * from_stride + i];
}

static inline size_t blocks_in(size_t lanes)
{
    return (lanes + CLIP_BLOCK - 1) / CLIP_BLOCK;
}

/* The number of lanes, from the first of blocks[0] on, that are computed together: whole blocks. */
static inline size_t lanes_together(const clip_block *blocks, size_t block_count)
{
    size_t n = 0;
    while (n < block_count && n < CLIP_SCATTER_BLOCKS && !blocks[n].contiguous && blocks[n].width == CLIP_BLOCK)
        n++;
    return blocks->contiguous ? blocks->contiguous : n > 0 ? n * CLIP_BLOCK : blocks->width;
}

NKW_ALWAYS_INLINE void scatter_count(const uint32_t *places, const float *from, float *out, size_t count)
{
    for (size_t i = 0; i < count; i++)
        out[places[i]] = from[i];
}

/* Copies `lanes` numbers, whole blocks, to their places. A constant count compiles to loads and stores only. */
static inline void scatter_numbers(const clip_block *blocks, const float *from, float *out, size_t lanes)
{
    for (size_t k = 0; k < blocks_in(lanes); k++, from += CLIP_BLOCK)
        if (blocks[k].count == CLIP_BLOCK)
            scatter_count(block_places(&blocks[k]), from, out, CLIP_BLOCK);
        else
            scatter_count(block_places(&blocks[k]), from, out, blocks[k].count);
}

#endif
