/* SPDX-License-Identifier: MIT */
/* What the loops of packed groups (clip_packed.h) read: the segment of a group that contains a time. */
#ifndef NAKAWARI_BATCH_CLIP_PACKED_H
#define NAKAWARI_BATCH_CLIP_PACKED_H

#include <stddef.h>
#include <stdint.h>

#include "sizes.h"

#define PACKED_WIDTH 24 /* bits of a knot or residual, at most: a float has them all */

/*
 * numbers      slots of the group: a multiple of 4, at most PACKED_SLOTS
 * ranges       the upper 16 bits of the base of each slot, then of the step of each
 * wide         a bit for each 8 slots: whether their knots have 24 bits
 * knots        the first knot of the segment; the next one follows: 16 bits of all slots, then 8 of the wide ones
 * stream       the words of the segment
 * intervals    of the segment
 * key          the key before the time, of this segment: 0..intervals - 1
 */
typedef struct packed_at {
    size_t numbers;
    const uint16_t *ranges;
    uint32_t wide;
    const uint32_t *knots;
    const uint32_t *stream;
    uint32_t intervals, key;
} packed_at;

/* The words of rows of `columns` numbers of `bits` bits in all. */
static inline size_t packed_words(size_t columns, size_t bits)
{
    return columns * ((bits + 31) / 32);
}

/* The words of a knot: half a word of each slot, and two words of each 8 wide ones. */
static inline size_t packed_knot_words(size_t numbers, uint32_t wide)
{
    size_t words = numbers / 2;
    for (; wide; wide &= wide - 1)
        words += PACKED_COLUMNS / 4;
    return words;
}

/* The part lo..hi of a segment that a residual halves, at key middle; length 1: it has no middle. */
typedef struct packed_part {
    uint32_t lo, middle, hi;
} packed_part;

static inline packed_part packed_part_of(uint32_t lo, uint32_t hi)
{
    packed_part part = {lo, lo + (hi - lo) / 2, hi};
    return part;
}

/* The half of a part that contains the interval after `key`. */
static inline packed_part packed_half(packed_part part, uint32_t key)
{
    return key < part.middle ? packed_part_of(part.lo, part.middle) : packed_part_of(part.middle, part.hi);
}

/* The parts of a stream: the number of columns; of each 8 columns the widths of the levels; their slots; rows. */
static inline size_t packed_blocks(const uint32_t *stream)
{
    return ((size_t)stream[0] + PACKED_COLUMNS - 1) / PACKED_COLUMNS;
}

static inline const uint8_t *packed_widths(const uint32_t *stream)
{
    return (const uint8_t *)(stream + 1);
}

static inline const uint8_t *packed_slots(const uint32_t *stream)
{
    return packed_widths(stream) + packed_blocks(stream) * PACKED_LEVELS;
}

static inline const uint32_t *packed_rows(const uint32_t *stream)
{
    return stream + 1 + packed_blocks(stream) * (PACKED_LEVELS + PACKED_COLUMNS) / 4;
}

#endif
