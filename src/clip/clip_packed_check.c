/* SPDX-License-Identifier: MIT */
/*
 * Checks packed groups of a block that is opened (clip_packed.h).
 *
 * Invariant: after the check, unpacking reads no word outside the block and writes no slot outside its arrays, whatever
 * the other words are. Wrong residuals make wrong rotations, and are not looked for.
 *
 *     words of the group, from g->keys on          the block        checked
 *     | offsets | wide | knots      | streams ...  ... padding |
 *       each     bits   segments + 1  columns <= slots, widths <= 24, slot < slots, rows end before the padding
 *
 * Streams may be anywhere in the block, in any order. `words` is the sum of all of them: nkw_clip_open refuses groups
 * whose sum exceeds the block, so streams that overlap do not make a short file take long.
 */
#include "lane/strict.h"

#include "clip_packed.h"

/* The words of a stream, of at most `left`; 0 if it is longer, or a slot or a width is out of range. */
static uint64_t stream_words(const uint32_t *stream, uint64_t left, size_t numbers, uint32_t levels)
{
    if (left < 1 || stream[0] > numbers)
        return 0;
    uint64_t words = (uint64_t)(packed_rows(stream) - stream);
    size_t bits = 0;
    if (words > left)
        return 0;
    for (size_t i = 0; i < stream[0]; i++)
        if (packed_slots(stream)[i] >= numbers)
            return 0;
    for (size_t k = 0; k < packed_blocks(stream) * PACKED_LEVELS; k++) {
        if (packed_widths(stream)[k] > PACKED_WIDTH)
            return 0;
        bits += k % PACKED_LEVELS < levels ? (size_t)packed_widths(stream)[k] << k % PACKED_LEVELS : 0;
    }
    words += packed_words(PACKED_COLUMNS, bits);
    return words <= left ? words : 0;
}

/*
 * Padding follows the words somewhere in the block: unpacking reads the row after the last bit, and two rows of a width
 * of 0. All sums are of 64 bits, so offsets near 2^32 do not wrap round.
 */
int nkwi_packed_check(const nkw_clip *clip, const clip_group *g, uint32_t count, uint64_t *words)
{
    const uint64_t numbers = clip_rows(g) * (uint64_t)g->lanes, all = clip->words;
    if (numbers > PACKED_SLOTS || g->keys + (uint64_t)packed_knots(count) > all)
        return 0;
    const uint32_t *keys = clip_words(clip) + g->keys, wide = keys[packed_segments(count)];
    if (wide >> (numbers + PACKED_COLUMNS - 1) / PACKED_COLUMNS)
        return 0;
    *words = packed_knots(count) + ((uint64_t)packed_segments(count) + 1) * packed_knot_words((size_t)numbers, wide);
    if (g->keys + *words + PACKED_PADDING > all)
        return 0;
    for (uint32_t s = 0; s < packed_segments(count); s++) {
        uint64_t at = (uint64_t)g->keys + keys[s], end = all - PACKED_PADDING;
        uint64_t taken = at < end ? stream_words(clip_words(clip) + at, end - at, (size_t)numbers,
                                                 packed_levels(packed_intervals(count, s)))
                                  : 0;
        if (taken == 0)
            return 0;
        *words += taken;
    }
    return 1;
}
