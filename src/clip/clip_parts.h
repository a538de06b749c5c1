/* SPDX-License-Identifier: MIT */
/*
 * The parts of a block of a clip that are not words, which are stored in the order of the memory:
 *
 *     16-bit keys of compact groups, knots of packed ones    a word has two
 *     high bytes of knots, widths and slots of a stream,     a word has four
 *     texts of names
 *
 * The walk reads words only that are offsets or counts; a block that was not checked is safe: a part is visited only
 * where it is inside the block, and all parts together are at most the block.
 */
#ifndef NAKAWARI_CLIP_PARTS_H
#define NAKAWARI_CLIP_PARTS_H

#include "lane/strict.h"

#include <stdint.h>

static inline uint32_t clip_swapped_bytes(uint32_t w)
{
    return w >> 24 | (w >> 8 & 0xff00u) | (w << 8 & 0xff0000u) | w << 24;
}

static inline uint32_t clip_swapped_halves(uint32_t w)
{
    return w << 16 | w >> 16;
}

typedef enum clip_part { PART_HALVES, PART_BYTES } clip_part;

/* Receives each part: `count` words from `at` on. It may change these words. */
typedef void (*clip_visit)(void *user, clip_part part, uint64_t at, uint64_t count);

/* words: the block, of at least sizeof(nkw_clip) bytes; its words are in the order of this machine. */
void nkwi_clip_parts(const uint32_t *words, uint64_t count, clip_visit visit, void *user);

#endif
