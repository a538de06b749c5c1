/* SPDX-License-Identifier: MIT */
/*
 * Two neighbouring keys of packed groups (clip_packed.h): knots and residuals as floats; their sums; for rotations
 * their arcs. The loops of compact groups then interpolate between them.
 *
 * Invariant: a key has the same bits as the first of two keys and as the second, so a sample at its time does not
 * depend on the side it comes from. Knots are below 2^20: lines between them are exact to 1/16 step in binary32.
 *
 *     key     16 s        key p->key = 5, and 6            16 (s + 1)
 *     knot    first                                        second
 *     level   part        middle   hat at 5    hat at 6
 *     0       0..16       8        5/8         6/8
 *     1       0..8        4        3/4         2/4
 *     2       4..8        6        1/2         1
 *     3       4..6        5        1           0
 *
 *     a = first + 5/16 (second - first) + 5/8 r0 + 3/4 r1 + 1/2 r2 + r3       in steps, of every slot
 *     b = first + 6/16 (second - first) + 6/8 r0 + 2/4 r1 +     r2
 *
 * The way of the data, 8 columns at a time:
 *
 *     rows of the stream --(unpack)--> residuals of one level --(sum_levels)--> sums of columns
 *         --(store_columns)--> sums of slots --(add_lines)--> keys in steps --(scale_all)--> base + step key
 *
 * Slots without a column have only a line, and their sums are cleared first.
 */
#include "lane/strict.h"

#include <string.h>

#include "batch/clip.h"
#include "batch/clip_compact.h"
#include "lane/scalar.h"

NKW_LOOPS_CLIP(NKW_DECLARE_LOOP)

/* Of each width: the mask of its bits, and half its range, by which a field is larger than its residual. */
static const uint32_t packed_masks[PACKED_WIDTH + 1] = {
    0x0u,     0x1u,     0x3u,     0x7u,      0xfu,      0x1fu,     0x3fu,    0x7fu,   0xffu,
    0x1ffu,   0x3ffu,   0x7ffu,   0xfffu,    0x1fffu,   0x3fffu,   0x7fffu,  0xffffu, 0x1ffffu,
    0x3ffffu, 0x7ffffu, 0xfffffu, 0x1fffffu, 0x3fffffu, 0x7fffffu, 0xffffffu};
static const float packed_halves[PACKED_WIDTH + 1] = {
    0.0f,      1.0f,      2.0f,      4.0f,       8.0f,       16.0f,      32.0f,     64.0f,    128.0f,
    256.0f,    512.0f,    1024.0f,   2048.0f,    4096.0f,    8192.0f,    16384.0f,  32768.0f, 65536.0f,
    131072.0f, 262144.0f, 524288.0f, 1048576.0f, 2097152.0f, 4194304.0f, 8388608.0f};

/*
 * The residuals of `width` bits from bit `bit` of 8 columns on. Reads the row after the last bit too.
 *
 *     row bit / 32        | ......xxxxxx |        low >> right: bits 0 .. 31 - right of the field
 *     row bit / 32 + 1    | xx.......... |        high << (32 - right), in two shifts: << 32 is undefined for right = 0
 *
 * width 0 reads bits, and its mask clears them: no branch for levels without residuals.
 */
NKW_ALWAYS_INLINE void unpack(const uint32_t *rows, size_t bit, uint32_t width, float *out)
{
    const uint32_t *low = rows + bit / 32 * PACKED_COLUMNS, *high = low + PACKED_COLUMNS;
    const uint32_t right = (uint32_t)bit % 32, left = 31 - right, mask = packed_masks[width];
    const float half = packed_halves[width];
#pragma omp simd
    for (size_t i = 0; i < PACKED_COLUMNS; i++)
        out[i] = (float)(int32_t)((low[i] >> right | high[i] << 1 << left) & mask) - half;
}

/* Adds the high 8 bits of 8 numbers. */
NKW_ALWAYS_INLINE void add_high(const uint8_t *high, float *out)
{
#pragma omp simd
    for (size_t i = 0; i < PACKED_COLUMNS; i++)
        out[i] += 65536.0f * (float)(int32_t)high[i];
}

/* A knot of all slots. */
NKW_ALWAYS_INLINE void read_knot(const packed_at *p, const uint32_t *knot, float *out)
{
    const uint16_t *low = (const uint16_t *)(const void *)knot;
    const uint8_t *high = (const uint8_t *)(knot + p->numbers / 2);
#pragma omp simd
    for (size_t i = 0; i < p->numbers / 4 * 4; i++)
        out[i] = (float)(int32_t)low[i];
    for (uint32_t wide = p->wide, i = 0; wide; wide >>= 1, i += PACKED_COLUMNS)
        if (wide & 1) {
            add_high(high, out + i);
            high += PACKED_COLUMNS;
        }
}

/* One level: the bit of its residual in the first block; the weights at the key and the next one. */
typedef struct packed_level {
    size_t bit;
    float a, b;
} packed_level;

/* How much the residual in the middle of a part adds at a key of it: 1 in the middle, 0 at both ends. */
NKW_ALWAYS_INLINE float hat(packed_part part, uint32_t key)
{
    const uint32_t at = key < part.middle ? key - part.lo : part.hi - key;
    const uint32_t length = key < part.middle ? part.middle - part.lo : part.hi - part.middle;
    return part.middle == part.lo ? 0.0f : (float)(int32_t)at / (float)(int32_t)length;
}

/*
 * The levels of the segment that contain the interval after the key. Returns their number. The residual `index` of
 * a level begins at bit + index * (sum of the widths of all blocks).
 */
NKW_ALWAYS_INLINE size_t find_levels(const packed_at *p, packed_level levels[PACKED_LEVELS])
{
    const uint8_t *widths = packed_widths(p->stream);
    size_t sums[PACKED_LEVELS] = {0}, bit = 0, index = 0, level = 0;
    packed_part part = packed_part_of(0, p->intervals);
    for (size_t k = 0; k < packed_blocks(p->stream); k++, widths += PACKED_LEVELS)
        for (size_t i = 0; i < PACKED_LEVELS; i++)
            sums[i] += widths[i];
    for (; (uint32_t)1 << level < p->intervals; level++) {
        levels[level].bit = bit + index * sums[level];
        levels[level].a = hat(part, p->key);
        levels[level].b = hat(part, p->key + 1);
        bit += sums[level] << level;
        index = 2 * index + (p->key >= part.middle);
        part = packed_half(part, p->key);
    }
    return level;
}

/* Columns beyond the last one, up to 8, are computed and not stored. */
NKW_ALWAYS_INLINE void store_columns(const float *column, const uint8_t *slots, size_t n, float *out)
{
    if (n == PACKED_COLUMNS)
        for (size_t i = 0; i < PACKED_COLUMNS; i++)
            out[slots[i]] = column[i];
    else
        for (size_t i = 0; i < n; i++)
            out[slots[i]] = column[i];
}

/* Adds the residuals of `level_count` levels, best a constant, to the sums of the slots of all columns. */
NKW_ALWAYS_INLINE void sum_levels(const packed_at *p, const packed_level *levels, size_t level_count, float *a,
                                  float *b)
{
    const size_t count = p->stream[0], blocks = packed_blocks(p->stream);
    const uint8_t *widths = packed_widths(p->stream), *slots = packed_slots(p->stream);
    const uint32_t *rows = packed_rows(p->stream);
    size_t bits[PACKED_LEVELS] = {0};
    for (size_t level = 0; level < level_count; level++)
        bits[level] = levels[level].bit;
    for (size_t k = 0; k < blocks; k++, slots += PACKED_COLUMNS, widths += PACKED_LEVELS) {
        const size_t left = count - k * PACKED_COLUMNS, n = left < PACKED_COLUMNS ? left : PACKED_COLUMNS;
        float sum_a[PACKED_COLUMNS] = {0}, sum_b[PACKED_COLUMNS] = {0};
        for (size_t level = 0; level < level_count; level++) {
            const uint32_t width = widths[level];
            float residuals[PACKED_COLUMNS];
            unpack(rows, bits[level], width, residuals);
#pragma omp simd
            for (size_t i = 0; i < PACKED_COLUMNS; i++) {
                sum_a[i] += levels[level].a * residuals[i];
                sum_b[i] += levels[level].b * residuals[i];
            }
            bits[level] += width;
        }
        store_columns(sum_a, slots, n, a);
        store_columns(sum_b, slots, n, b);
    }
}

/* The sums of the residuals of all slots, at the key and the next one. */
NKW_ALWAYS_INLINE void read_residuals(const packed_at *p, float *a, float *b)
{
    packed_level levels[PACKED_LEVELS];
    const size_t level_count = find_levels(p, levels);
    memset(a, 0, p->numbers * sizeof *a);
    memset(b, 0, p->numbers * sizeof *b);
    if (level_count == PACKED_LEVELS)
        sum_levels(p, levels, PACKED_LEVELS, a, b);
    else
        sum_levels(p, levels, level_count, a, b);
}

/* The line between the knots at `place`, plus the residuals, of slots from..to - 1; in steps. */
NKW_ALWAYS_INLINE void add_lines(const float *first, const float *second, float place, float *residuals, size_t from,
                                 size_t to)
{
#pragma omp simd
    for (size_t i = from; i < to; i++)
        residuals[i] = (first[i] + place * (second[i] - first[i])) + residuals[i];
}

/* Both keys around the time, in steps. */
NKW_ALWAYS_INLINE void read_keys(const packed_at *p, float *a, float *b)
{
    float first[PACKED_SLOTS], second[PACKED_SLOTS];
    const float intervals = (float)(int32_t)p->intervals;
    const float place_a = (float)(int32_t)p->key / intervals, place_b = (float)(int32_t)(p->key + 1) / intervals;
    size_t i = p->numbers / CLIP_BLOCK * CLIP_BLOCK;
    read_knot(p, p->knots, first);
    read_knot(p, p->knots + packed_knot_words(p->numbers, p->wide), second);
    read_residuals(p, a, b);
    add_lines(first, second, place_a, a, 0, i);
    add_lines(first, second, place_b, b, 0, i);
    for (; i < p->numbers; i += 4) {
        add_lines(first, second, place_a, a, i, i + 4);
        add_lines(first, second, place_b, b, i, i + 4);
    }
}

/* base + step x of the slots from..to - 1. */
NKW_ALWAYS_INLINE void scale(const packed_at *p, const float *x, float *out, size_t from, size_t to)
{
    const uint16_t *base = p->ranges, *step = p->ranges + p->numbers;
#pragma omp simd
    for (size_t i = from; i < to; i++)
        out[i] = lane_float((uint32_t)base[i] << 16) + lane_float((uint32_t)step[i] << 16) * x[i];
}

NKW_ALWAYS_INLINE void scale_all(const packed_at *p, const float *x, float *out)
{
    size_t i = p->numbers / CLIP_BLOCK * CLIP_BLOCK;
    scale(p, x, out, 0, i);
    for (; i < p->numbers; i += 4)
        scale(p, x, out, i, i + 4);
}

/*
 * What is kept of two neighbouring keys (clip_cache.h), of numbers and of rotations. held: whether both are the second
 * key, for the time of the last one.
 */
NKW_LOOP(nkwi_clip_keep_packed)(const packed_at *p, int held, float *kept)
{
    float a[PACKED_SLOTS], b[PACKED_SLOTS];
    read_keys(p, a, b);
    scale_all(p, held ? b : a, kept);
    scale_all(p, b, kept + p->numbers);
}

/*
 * 1 / length; the length of lane_compact_quat is 1 - w. Scales of one key each, so that the rotation at the time of
 * a key does not depend on the other one.
 */
NKW_ALWAYS_INLINE void set_scales(key16 *key, size_t at, size_t width)
{
#pragma omp simd
    for (size_t i = at; i < at + width; i++)
        key->scale[i] = 1.0f / (1.0f - key->w[i]);
}

NKW_ALWAYS_INLINE void arcs_of_width(pairs16 *p, const uint32_t *same, size_t at, size_t width)
{
    arcs_of(p, same, at, width);
    set_scales(&p->a, at, width);
    set_scales(&p->b, at, width);
}

/* The arcs of a block: no rotation of the second key is negated. */
NKW_ALWAYS_INLINE void arcs_packed(pairs16 *p, size_t at, size_t width)
{
    static const uint32_t same[CLIP_BLOCK] = {0};
    if (width == CLIP_BLOCK)
        arcs_of_width(p, same, at, CLIP_BLOCK);
    else if (width == 8)
        arcs_of_width(p, same, at, 8);
    else
        arcs_of_width(p, same, at, 4);
}

NKW_LOOP(nkwi_clip_keep_packed_rotations)
(const packed_at *p, int held, const clip_block *blocks, size_t block_count, float *kept)
{
    float a[PACKED_SLOTS], b[PACKED_SLOTS];
    pairs16 pairs;
    read_keys(p, a, b);
    scale_all(p, held ? b : a, pairs.a.xyz);
    scale_all(p, b, pairs.b.xyz);
    for (size_t k = 0; k < block_count; k++)
        arcs_packed(&pairs, CLIP_BLOCK * k, blocks[k].width);
    for (size_t k = 0; k < block_count; k++)
        keep_rows(&pairs, CLIP_BLOCK * k, kept + CLIP_KEPT_ROWS * CLIP_BLOCK * k, blocks[k].width);
}
