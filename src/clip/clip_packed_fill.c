/* SPDX-License-Identifier: MIT */
/*
 * Writes the keys of packed groups (clip_packed.h).
 *
 * A segment is rounded twice, with the same result: once for the widths of its levels and the order of its columns, and
 * once, when the head of its stream is known, for its rows. Between two segments p->signs has the sign of each
 * rotation's key before the next one.
 *
 * Invariant: every key that is read back is within half a step of its track, since a residual is rounded against what
 * the coarser levels read back as, not against the track: errors do not add up from level to level.
 *
 *     one slot, n = 4 intervals, keys in steps     0.2    1.4    4.9    7.7    8.1
 *     knots                                        0                           8
 *     level 0: line 4, residual 0.9 -> 1                         5
 *     level 1: lines 2.5 and 6.5, -1.1 and 1.2            1.5           7.5
 *     stored                                       knots 0 and 8, residuals 1 | -1 1, widths 2 2
 *
 * The order of these numbers in `packed_residuals`, a binary tree by levels, for n = 16:
 *
 *     r[]      0    1  2     3  4  5   6     7 ... 14       level L from 2^L - 1 on
 *     key      8    4  12    2  6  10  14    1 3 5 ... 15
 *
 * How a slot becomes a column, and the columns 8 i .. 8 i + 7 a block:
 *
 *     slots        3: 40 bits   7: 0 bits   12: 18 bits        bits = sum over levels of 2^level width
 *     columns      0: slot 12   1: slot 3                       ascending bits; slot 7 is constant, so it has none
 *     width        of a level: the widest of 8 columns
 *     rows         8 words of 32 bits: bit b of column c is bit b % 32 of word b / 32 * 8 + c
 */
#include "lane/strict.h"

#include <string.h>

#include "clip_keys.h"
#include "clip_packed.h"
#include "clip_packed_numbers.h"
#include "sort.h"

/* ---- Segments ---- */

/* The keys of one segment of a lane, in units of the step from the base on. */
typedef struct packed_segment {
    uint32_t n; /* intervals */
    double x[3][PACKED_KEYS + 1];
} packed_segment;

/* To the nearest whole number, for |x| < 2^51: LANE_ROUND is 1.5 2^52, where neighbouring doubles differ by 1. */
static double nearest(double x)
{
    return (x + LANE_ROUND) - LANE_ROUND;
}

/* `keys` is before the first key of the segment, and is left before its last. */
static packed_segment segment_of(packed_keys *keys, size_t first, uint32_t n, const float *base, const float *step)
{
    packed_segment s;
    s.n = n;
    for (uint32_t k = 0; k <= n; k++) {
        packed_keys next = *keys;
        double x[3] = {0.0, 0.0, 0.0};
        packed_next_numbers(&next, first + k, x);
        for (size_t r = 0; r < packed_rows_of(keys->c); r++)
            s.x[r][k] = step[r] > 0.0f ? (x[r] - (double)base[r]) / (double)step[r] : 0.0;
        if (k < n)
            *keys = next;
    }
    return s;
}

/* The bits of x: 0 for 0, otherwise floor(log2 x) + 1. */
static uint8_t bits_of(uint32_t x)
{
    uint8_t bits = 0;
    while (x >> bits)
        bits++;
    return bits;
}

/* The residuals of a slot, level after level; and the widths of its levels: the widest r, -2^(w-1) <= r < 2^(w-1). */
typedef struct packed_residuals {
    int32_t r[PACKED_KEYS - 1];
    uint8_t widths[PACKED_LEVELS];
} packed_residuals;

/*
 * The part of a segment of n intervals that the residual `index` of a level halves. The bits of the index, from the
 * highest on, are the way down from the whole segment: 0 the first half, 1 the second.
 */
static packed_part part_of(uint32_t n, uint32_t level, uint32_t index)
{
    packed_part part = packed_part_of(0, n);
    for (uint32_t i = level; i-- > 0;)
        part = index >> i & 1 ? packed_part_of(part.middle, part.hi) : packed_part_of(part.lo, part.middle);
    return part;
}

/*
 * Rounds the keys of a row to knots and residuals, from the coarsest level to the finest. x: as in packed_segment; it
 * becomes what is read back, the ends of the parts of the next level. A residual code < 0 needs the bits of ~code.
 */
static void round_residuals(uint32_t n, double x[PACKED_KEYS + 1], packed_residuals *out)
{
    size_t at = 0;
    memset(out, 0, sizeof *out);
    x[0] = nearest(x[0]);
    x[n] = nearest(x[n]);
    for (uint32_t level = 0; level < packed_levels(n); level++)
        for (uint32_t i = 0; i < (uint32_t)1 << level; i++, at++) {
            const packed_part p = part_of(n, level, i);
            if (p.middle == p.lo)
                continue;
            double place = (double)(p.middle - p.lo) / (double)(p.hi - p.lo);
            double line = x[p.lo] + place * (x[p.hi] - x[p.lo]), r = nearest(x[p.middle] - line);
            int32_t code = out->r[at] = (int32_t)r;
            uint8_t width = (uint8_t)(code == 0 ? 0 : bits_of((uint32_t)(code < 0 ? ~code : code)) + 1);
            out->widths[level] = width > out->widths[level] ? width : out->widths[level];
            x[p.middle] = line + r;
        }
}

/* ---- Groups ---- */

typedef struct packer {
    uint32_t *words; /* from the keys of the group on; NULL: only counted */
    const clip_group *g;
    const packed_lanes *lanes;
    uint32_t count; /* keys */
    size_t numbers; /* slots */
    float base[PACKED_SLOTS], step[PACKED_SLOTS];
    float signs[PACKED_SLOTS / 3]; /* of lanes of rotations: before this segment */
    uint32_t wide; /* a bit for each 8 slots */
    /* The stream of this segment: of each slot the widths of its levels and their bits; the slots of the columns. */
    uint8_t widths[PACKED_SLOTS][PACKED_LEVELS];
    uint16_t bits[PACKED_SLOTS];
    uint32_t order[PACKED_SLOTS], columns;
} packer;

/*
 * The ranges of all slots, and whether their knots are wide: more than 65535 steps from base to the highest number.
 * Padding has base 0 and step 0.
 */
static void set_ranges(packer *p, const nkw_clip_track *tracks, const clip_packing *packing)
{
    memset(p->base, 0, sizeof p->base);
    memset(p->step, 0, sizeof p->step);
    p->wide = 0;
    for (size_t lane = 0; lane < p->g->lanes; lane++) {
        const nkw_clip_track *c = p->lanes->track[lane];
        if (!c)
            continue;
        const size_t track = (size_t)(c - tracks);
        const packed_range r =
            nkwi_packed_range(packing->extents, c, track, p->lanes->component[lane], packing->steps[track]);
        for (size_t row = 0; row < clip_rows(p->g); row++) {
            size_t slot = nkwi_clip_lane_at(p->g, clip_rows(p->g), row, lane);
            p->base[slot] = nkwi_packed_base(r.extent.low[row]);
            p->step[slot] = nkwi_packed_base(r.step);
            if (nearest((r.extent.high[row] - (double)p->base[slot]) / (double)p->step[slot]) > 65535.0)
                p->wide |= (uint32_t)1 << slot / PACKED_COLUMNS;
        }
        if (p->g->kind == GROUP_ROTATIONS)
            p->signs[lane] = (float)r.extent.sign;
    }
}

static void write_ranges(const packer *p, uint16_t *ranges)
{
    for (size_t i = 0; i < p->numbers; i++) {
        ranges[i] = (uint16_t)(lane_bits(p->base[i]) >> 16);
        ranges[p->numbers + i] = (uint16_t)(lane_bits(p->step[i]) >> 16);
    }
}

/* The keys of a lane in segment s, and its slots. Returns the sign of the key before the next segment. */
static float lane_segment(const packer *p, size_t lane, uint32_t s, packed_segment *out, size_t slots[3])
{
    const nkw_clip_track *c = p->lanes->track[lane];
    const size_t rows = clip_rows(p->g), first = (size_t)s * PACKED_KEYS;
    packed_keys keys = {c, p->lanes->component[lane], 1.0f, {0.0f, 0.0f, 0.0f, 1.0f}};
    float base[3] = {0.0f, 0.0f, 0.0f}, step[3] = {0.0f, 0.0f, 0.0f};
    for (size_t row = 0; row < rows; row++) {
        slots[row] = nkwi_clip_lane_at(p->g, rows, row, lane);
        base[row] = p->base[slots[row]], step[row] = p->step[slots[row]];
    }
    if (rows == 3) {
        keys.sign = p->signs[lane];
        keys.last = first > 0 ? packed_rotation(c, first - 1) : keys.last;
    }
    *out = segment_of(&keys, first, packed_intervals(p->count, s), base, step);
    return keys.sign;
}

/*
 * Adds the low `width` bits of a field to column `column` of rows, at bit `bit`. A field that begins near the end of a
 * word continues in the same column of the next row; width is at most 24, so two words suffice.
 */
static void add_field(uint32_t *rows, size_t columns, size_t column, size_t bit, uint32_t width, uint32_t field)
{
    uint64_t shifted = (uint64_t)(field & (((uint32_t)1 << width) - 1)) << bit % 32;
    uint32_t *low = rows + bit / 32 * columns + column;
    low[0] |= (uint32_t)shifted;
    if (shifted >> 32)
        low[columns] |= (uint32_t)(shifted >> 32);
}

/*
 * Knot `knot` of a slot, less than 2^20 steps (clip_packed_survey.c). The upper 8 bits of the wide blocks follow the lower 16 of all slots:
 *
 *     words    | lower 16 bits of slots 0 1, 2 3, ...     | upper bits of wide blocks: 8 bytes each |
 *              0                                          numbers / 2
 */
static void write_knot(const packer *p, size_t slot, uint32_t knot, double number)
{
    uint32_t *words = p->words + packed_knots(p->count) + knot * packed_knot_words(p->numbers, p->wide);
    const uint32_t code = (uint32_t)number, block = (uint32_t)slot / PACKED_COLUMNS;
    ((uint16_t *)(void *)words)[slot] = (uint16_t)code;
    words += packed_knot_words(p->numbers, p->wide & (((uint32_t)1 << block) - 1));
    if (p->wide >> block & 1)
        ((uint8_t *)words)[slot % PACKED_COLUMNS] = (uint8_t)(code >> 16);
}

static int before_by_bits(const void *context, uint32_t a, uint32_t b)
{
    const packer *p = (const packer *)context;
    return p->bits[a] != p->bits[b] ? p->bits[a] < p->bits[b] : a < b;
}

/* Rounds all slots of a segment, writes their knots, and sets their widths and the order of the columns. */
static void set_columns(packer *p, uint32_t s)
{
    p->columns = 0;
    memset(p->bits, 0, sizeof p->bits);
    for (size_t lane = 0; lane < p->g->lanes; lane++) {
        packed_segment part;
        size_t slots[3] = {0, 0, 0};
        if (!p->lanes->track[lane])
            continue;
        lane_segment(p, lane, s, &part, slots);
        for (size_t row = 0; row < clip_rows(p->g); row++) {
            packed_residuals r;
            round_residuals(part.n, part.x[row], &r);
            for (size_t level = 0; level < PACKED_LEVELS; level++) {
                p->widths[slots[row]][level] = r.widths[level];
                p->bits[slots[row]] = (uint16_t)(p->bits[slots[row]] + ((uint32_t)r.widths[level] << level));
            }
            if (p->words) {
                write_knot(p, slots[row], s, part.x[row][0]);
                if (s + 1 == packed_segments(p->count))
                    write_knot(p, slots[row], s + 1, part.x[row][part.n]);
            }
        }
    }
    for (uint32_t slot = 0; slot < p->numbers; slot++)
        if (p->bits[slot] > 0)
            p->order[p->columns++] = slot;
    sort_indices(p->order, p->columns, before_by_bits, p);
}

/* The widest of a level in the 8 columns from `first` on. */
static uint32_t widest(const packer *p, uint32_t first, size_t level)
{
    uint32_t width = 0;
    for (uint32_t i = first; i < first + PACKED_COLUMNS && i < p->columns; i++)
        width = p->widths[p->order[i]][level] > width ? p->widths[p->order[i]][level] : width;
    return width;
}

/*
 * Writes the residuals of a slot to a column of the rows of a stream. Blocks share rows, level by level:
 *
 *     bits    | level 0: block 0, block 1, ... | level 1, first: block 0, block 1, ... | level 1, second: ... | level 2
 *             0  width of each                  bit          + sum: the widths of all blocks at this level
 *
 * so the residual i of a level begins at bit + i sum + the widths of the blocks before. r is stored as r + 2^(w-1).
 */
static void write_column(const uint32_t *stream, uint32_t *rows, uint32_t column, uint32_t levels,
                         const packed_residuals *r)
{
    const uint8_t *widths = packed_widths(stream);
    const size_t block = column / PACKED_COLUMNS;
    size_t bit = 0, at = 0;
    for (size_t level = 0; level < levels; level++) {
        size_t sum = 0, before = 0;
        uint32_t width = widths[block * PACKED_LEVELS + level];
        for (size_t k = 0; k < packed_blocks(stream); k++) {
            before += k < block ? widths[k * PACKED_LEVELS + level] : 0;
            sum += widths[k * PACKED_LEVELS + level];
        }
        for (size_t i = 0; i < (size_t)1 << level; i++)
            add_field(rows, PACKED_COLUMNS, column % PACKED_COLUMNS, bit + i * sum + before, width,
                      (uint32_t)r->r[at++] + ((uint32_t)1 << width >> 1));
        bit += sum << level;
    }
}

/* Writes the rows of a stream, whose head is written, and advances the signs to the next segment. */
static void write_rows(packer *p, uint32_t s, const uint32_t *stream, uint32_t *rows)
{
    uint8_t column[PACKED_SLOTS];
    for (uint32_t i = 0; i < p->columns; i++)
        column[p->order[i]] = (uint8_t)i;
    for (size_t lane = 0; lane < p->g->lanes; lane++) {
        packed_segment part;
        size_t slots[3] = {0, 0, 0};
        if (!p->lanes->track[lane])
            continue;
        float sign = lane_segment(p, lane, s, &part, slots);
        for (size_t row = 0; row < clip_rows(p->g); row++) {
            packed_residuals r;
            if (!rows || p->bits[slots[row]] == 0)
                continue;
            round_residuals(part.n, part.x[row], &r);
            write_column(stream, rows, column[slots[row]], packed_levels(part.n), &r);
        }
        if (p->g->kind == GROUP_ROTATIONS)
            p->signs[lane] = sign;
    }
}

/*
 * The stream of a segment, at word `to` of the keys. Returns its words; without a block it is only counted.
 *
 *     words    | columns | widths: 4 bytes of each 8 columns | slots: 8 bytes of each 8 columns | rows |
 */
static uint64_t write_stream(packer *p, uint32_t s, uint64_t to)
{
    set_columns(p, s);
    size_t bits = 0;
    for (uint32_t i = 0; i < p->columns; i += PACKED_COLUMNS)
        for (size_t level = 0; level < PACKED_LEVELS; level++)
            bits += widest(p, i, level) << level;
    const uint32_t head[1] = {p->columns};
    const size_t rows = (size_t)(packed_rows(head) - head), words = rows + packed_words(PACKED_COLUMNS, bits);
    uint32_t *stream = p->words ? p->words + to : NULL;
    if (stream) {
        memset(stream, 0, words * sizeof *stream);
        stream[0] = p->columns;
        uint8_t *widths = (uint8_t *)(stream + 1), *slots = widths + packed_blocks(stream) * PACKED_LEVELS;
        for (uint32_t i = 0; i < p->columns; i += PACKED_COLUMNS)
            for (size_t level = 0; level < PACKED_LEVELS; level++)
                *widths++ = (uint8_t)widest(p, i, level);
        for (uint32_t i = 0; i < p->columns; i++)
            slots[i] = (uint8_t)p->order[i];
    }
    write_rows(p, s, stream, stream ? stream + rows : NULL);
    return words;
}

/* The most words of a group: every number has a wide knot and PACKED_KEYS - 1 residuals of the largest width. */
static uint64_t most_words(uint32_t count, size_t numbers)
{
    uint64_t segments = packed_segments(count);
    const uint32_t head[1] = {(uint32_t)numbers};
    uint64_t knots = packed_knot_words(numbers, (uint32_t)-1) * (segments + 1);
    uint64_t stream = (uint64_t)(packed_rows(head) - head) +
                      packed_words(PACKED_COLUMNS, (PACKED_KEYS - 1) * PACKED_WIDTH * packed_blocks(head));
    return packed_knots(count) + knots + segments * stream;
}

uint64_t nkwi_packed_fill(uint32_t *words, const clip_group *g, const packed_lanes *lanes, const nkw_clip_track *tracks,
                          const clip_packing *packing)
{
    packer p;
    p.words = words ? words + g->keys : NULL;
    p.g = g, p.lanes = lanes;
    p.count = (uint32_t)lanes->track[0]->track.count;
    p.numbers = clip_rows(g) * g->lanes;
    if (!words && packing->is_most)
        return most_words(p.count, p.numbers);
    set_ranges(&p, tracks, packing);
    uint64_t at = packed_knots(p.count) + (packed_segments(p.count) + 1) * packed_knot_words(p.numbers, p.wide);
    if (words) {
        memset(p.words, 0, (size_t)at * sizeof *words);
        write_ranges(&p, (uint16_t *)(void *)(words + g->ranges));
        p.words[packed_segments(p.count)] = p.wide;
    }
    for (uint32_t s = 0; s < packed_segments(p.count); s++) {
        if (words)
            p.words[s] = (uint32_t)at;
        at += write_stream(&p, s, at);
    }
    return at;
}
