/* SPDX-License-Identifier: MIT */
/*
 * Interpolation between two neighbouring keys a and b of a group of a clip. src/clip/clip_layout.h has the layout.
 *
 * A loop computes the lanes of one or more blocks row by row, either into the output, if their places are contiguous,
 * or into a buffer on the stack, which is then scattered:
 *
 *     contiguous    key rows -> vector computation -> out + place
 *     otherwise     key rows -> vector computation -> buffer -> out[places[i]], i < count
 *
 * Numbers: out is the output. Rotations: component c of the output is at out + c * stride.
 *
 * Invariant: a lane of float keys has the bits that nkw_track_sample_segment returns for its track. Padding lanes are
 * computed, and never written to a place.
 *
 *     block         0    1    2    3    4          an example: 72 lanes of numbers
 *     width         16   16   16   16   8
 *     contiguous    32   16   0    0    8          lanes from this block on whose places follow one another
 *     one step      |-------| |-------| |-|        lanes_together: contiguous, or up to CLIP_SCATTER_BLOCKS of 16
 *     written to    place     buffer    place
 *     a, b at       0         32        64         times 1 row for numbers, CLIP_SLERP_ROWS or 3 for rotations
 *
 * Rotations take one scattered block at a time: four rows of it are as many lanes as four blocks of numbers.
 * Most inner loops take the width as a constant, 16, 8 or 4, and have no remainder.
 */
#include "lane/strict.h"

#include <string.h>

#include "batch/block.h"
#include "batch/element.h"
#include "batch/clip.h"
#include "batch/clip_compact.h"
#include "batch/clip_place.h"
#include "lane/compact.h"
#include "lane/cubic.h"
#include "sizes.h"

NKW_LOOPS_CLIP(NKW_DECLARE_LOOP)

static inline void arcs_of_block(float *a, const float *b, size_t width)
{
    nkw_quat_view from = block_rows(a, width), to = block_rows(b, width);
    float *arcs = a + 4 * width;
#pragma omp simd
    for (size_t i = 0; i < width; i++)
        arcs[i] = lane_slerp_arc(at_quat(from, i), at_quat(to, i), 1);
}

/* Writes row v of key a: the arcs from key a to key b. `keys` is 1: their lengths may differ from 1, as in glTF. */
NKW_LOOP(nkwi_clip_arcs)(float *a, const float *b, const clip_block *blocks, size_t block_count)
{
    for (size_t k = 0; k < block_count; k++) {
        size_t at = k * CLIP_BLOCK * CLIP_SLERP_ROWS;
        arcs_of_block(a + at, b + at, blocks[k].width);
    }
}

NKW_ALWAYS_INLINE void lerp_lanes(const float *a, const float *b, float t, int first, float *out, size_t n)
{
#pragma omp simd
    NKW_KEEP_LOOP
    for (size_t i = 0; i < n; i++)
        out[i] = nkw_lerp_from(first, 1, a[i], b[i], t);
}

/*
 * `lanes` lanes: blocks of 16, and at most one of 8 or 4. `first`, a constant: a is the key nearer to t.
 *
 *     a + t (b - a), t < 1/2        b - (1 - t) (b - a) otherwise
 */
NKW_ALWAYS_INLINE void lerp_contiguous(const float *a, const float *b, float t, int first, float *out, size_t lanes)
{
    for (; lanes >= CLIP_BLOCK; lanes -= CLIP_BLOCK, a += CLIP_BLOCK, b += CLIP_BLOCK, out += CLIP_BLOCK)
        lerp_lanes(a, b, t, first, out, CLIP_BLOCK);
    if (lanes == 8)
        lerp_lanes(a, b, t, first, out, 8);
    else if (lanes == 4)
        lerp_lanes(a, b, t, first, out, 4);
}

/* Steps of the picture above: contiguous lanes go to their places, others by way of the buffer, up to 8 blocks. */
NKW_ALWAYS_INLINE void lerp_blocks(const float *a, const float *b, float t, int first, const clip_block *blocks,
                                   size_t block_count, float *out)
{
    for (size_t k = 0, lanes; k < block_count; k += blocks_in(lanes)) {
        float buffer[CLIP_SCATTER_BLOCKS * CLIP_BLOCK];
        int contiguous = blocks[k].contiguous > 0;
        lanes = lanes_together(blocks + k, block_count - k);
        lerp_contiguous(a + k * CLIP_BLOCK, b + k * CLIP_BLOCK, t, first, contiguous ? out + blocks[k].place : buffer,
                        lanes);
        if (!contiguous)
            scatter_numbers(blocks + k, buffer, out, lanes);
    }
}

/* 0 < t < 1. At 0 and 1 the caller calls nkwi_clip_hold. */
NKW_LOOP(nkwi_clip_lerp)
(const float *a, const float *b, float t, const clip_block *blocks, size_t block_count, float *out)
{
    if (t < 0.5f)
        lerp_blocks(a, b, t, 1, blocks, block_count, out);
    else
        lerp_blocks(a, b, t, 0, blocks, block_count, out);
}

/* The values that all slerps at one t share: the coefficients of powers of v (lane/slerp.h), once for all lanes. */
typedef struct slerp_shared {
    lane_slerp_time at;
    lane_slerp_series series;
} slerp_shared;

NKW_ALWAYS_INLINE void slerp_block(const float *a, const float *b, const slerp_shared *p, float *out, size_t stride,
                                   size_t width)
{
    nkw_quat_view from = block_rows(a, width), to = block_rows(b, width);
    nkw_quat_span o = block_rows_to(out, stride);
    const float *arcs = a + 4 * width;
#pragma omp simd
    NKW_KEEP_LOOP
    for (size_t i = 0; i < width; i++) {
        lane_slerp_weights k = lane_slerp_weights_in(&p->at, &p->series, lane_abs(arcs[i]));
        put_quat(o, i, lane_quat_slerp_by(at_quat(from, i), at_quat(to, i), arcs[i], &p->at, k));
    }
}

/* `lanes` lanes: blocks of 16, and at most one of 8 or 4, to contiguous places. */
NKW_ALWAYS_INLINE void slerp_contiguous(const float *a, const float *b, const slerp_shared *p, float *out,
                                        size_t stride, size_t lanes)
{
    const size_t block = CLIP_BLOCK * CLIP_SLERP_ROWS;
    for (; lanes >= CLIP_BLOCK; lanes -= CLIP_BLOCK, a += block, b += block, out += CLIP_BLOCK)
        slerp_block(a, b, p, out, stride, CLIP_BLOCK);
    if (lanes == 8)
        slerp_block(a, b, p, out, stride, 8);
    else if (lanes == 4)
        slerp_block(a, b, p, out, stride, 4);
}

/* A contiguous step may have many blocks; a scattered one has one, of at most 16 lanes and 4 rows. */
NKW_ALWAYS_INLINE void slerp_blocks(const float *a, const float *b, lane_slerp_time at, const clip_block *blocks,
                                    size_t block_count, float *out, size_t stride)
{
    const slerp_shared p = {at, lane_slerp_series_at(&at)};
    for (size_t k = 0, lanes; k < block_count; k += blocks_in(lanes)) {
        const size_t from = k * CLIP_BLOCK * CLIP_SLERP_ROWS;
        float buffer[4 * CLIP_BLOCK];
        int contiguous = blocks[k].contiguous > 0;
        lanes = contiguous ? blocks[k].contiguous : blocks[k].width;
        slerp_contiguous(a + from, b + from, &p, contiguous ? out + blocks[k].place : buffer,
                         contiguous ? stride : CLIP_BLOCK, lanes);
        if (!contiguous)
            scatter(&blocks[k], buffer, CLIP_BLOCK, out, stride);
    }
}

/*
 * 0 <= t <= 1. Which key is nearer depends on t only. Except at 0, 1/2 and 1, it is a constant in the loop, so that the
 * selects fold away.
 */
NKW_LOOP(nkwi_clip_slerp)
(const float *a, const float *b, float t, const clip_block *blocks, size_t block_count, float *out, size_t stride)
{
    lane_slerp_time at = lane_slerp_time_at(t, 0);
    if (!lane_t_is_generic(t))
        slerp_blocks(a, b, at, blocks, block_count, out, stride);
    else if (at.first)
        slerp_blocks(a, b, lane_slerp_time_from(at, 1), blocks, block_count, out, stride);
    else
        slerp_blocks(a, b, lane_slerp_time_from(at, 0), blocks, block_count, out, stride);
}

/*
 * Compact keys: number = base + step key. Numbers are linear in the key, so the key is interpolated, then decoded.
 * Rotations are decoded first.
 */

/* out = base + step (a + t (b - a)), in the unit of the track; a and b are exact as floats. */
static inline void lerp16_lanes(const uint16_t *a, const uint16_t *b, const float *base, const float *step, float t,
                                float *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        float from = (float)a[i], to = (float)b[i];
        out[i] = base[i] + step[i] * (from + t * (to - from));
    }
}

NKW_LOOP(nkwi_clip_lerp16)
(const uint16_t *a, const uint16_t *b, const float *base, const float *step, float t, const clip_block *blocks,
 size_t block_count, float *out)
{
    for (size_t k = 0, lanes; k < block_count; k += blocks_in(lanes)) {
        size_t at = k * CLIP_BLOCK;
        int contiguous = blocks[k].contiguous > 0;
        float buffer[CLIP_SCATTER_BLOCKS * CLIP_BLOCK];
        lanes = lanes_together(blocks + k, block_count - k);
        lerp16_lanes(a + at, b + at, base + at, step + at, t, contiguous ? out + blocks[k].place : buffer, lanes);
        if (!contiguous)
            scatter_numbers(blocks + k, buffer, out, lanes);
    }
}

NKW_ALWAYS_INLINE void decode_lanes(const uint16_t *key, const float *base, const float *step, float *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = base[i] + step[i] * (float)key[i];
}

/* n is a multiple of 4. */
static inline void decode(const uint16_t *key, const float *base, const float *step, float *out, size_t n)
{
    size_t i = n / 16 * 16;
    decode_lanes(key, base, step, out, i);
    for (; i < n; i += 4)
        decode_lanes(key + i, base + i, step + i, out + i, 4);
}

/*
 * The sign bit of each lane whose three numbers in b have an odd sum: slerp negates this rotation of b. The lowest bit
 * of a sum is the exclusive or of the lowest bits; << 31 leaves only it.
 */
NKW_ALWAYS_INLINE void negations_of(const uint16_t *b, uint32_t *negated, size_t width)
{
#pragma omp simd
    for (size_t i = 0; i < width; i++)
        negated[i] = ((uint32_t)b[i] ^ b[width + i] ^ b[2 * width + i]) << 31;
}

NKW_ALWAYS_INLINE void arcs16_of(pairs16 *p, const uint16_t *b, size_t at, size_t width)
{
    uint32_t negated[CLIP_BLOCK];
    negations_of(b, negated, width);
    arcs_of(p, negated, at, width);
}

NKW_ALWAYS_INLINE void arcs16(pairs16 *p, const uint16_t *b, size_t at, size_t width)
{
    if (width == CLIP_BLOCK)
        arcs16_of(p, b, at, CLIP_BLOCK);
    else if (width == 8)
        arcs16_of(p, b, at, 8);
    else
        arcs16_of(p, b, at, 4);
}

/* The blocks from `blocks` on that take each step together, at most CLIP_SLERP16_BLOCKS. */
static inline size_t blocks16(size_t block_count)
{
    return block_count < CLIP_SLERP16_BLOCKS ? block_count : CLIP_SLERP16_BLOCKS;
}

/*
 * Decodes the numbers of both keys of n blocks; computes w, v and the scales of each block.
 *
 *     a, b, base, step    block i at 3 * 16 i: x y z, `width` of each                 as in the key
 *     p->a.w, p->v ...    block i at 16 i                                              floats
 *
 * The last block may be narrower; the numbers of all blocks are contiguous, so one loop decodes them.
 */
NKW_ALWAYS_INLINE void pairs16_of(pairs16 *p, const uint16_t *a, const uint16_t *b, const float *base,
                                  const float *step, const clip_block *blocks, size_t n)
{
    const size_t numbers = 3 * (CLIP_BLOCK * (n - 1) + blocks[n - 1].width);
    decode(a, base, step, p->a.xyz, numbers);
    decode(b, base, step, p->b.xyz, numbers);
    for (size_t i = 0; i < n; i++)
        arcs16(p, b + 3 * CLIP_BLOCK * i, CLIP_BLOCK * i, blocks[i].width);
}

/*
 * Decodes up to CLIP_SLERP16_BLOCKS blocks, then interpolates each. t = 0 returns the rotations of a, of unit length.
 */
NKW_LOOP(nkwi_clip_slerp16)
(const uint16_t *a, const uint16_t *b, const float *base, const float *step, float t, const clip_block *blocks,
 size_t block_count, float *out, size_t stride)
{
    const lane_compact_series series = lane_compact_series_at(t);
    for (size_t k = 0; k < block_count; k += CLIP_SLERP16_BLOCKS) {
        const size_t n = blocks16(block_count - k), first = 3 * CLIP_BLOCK * k;
        pairs16 p;
        pairs16_of(&p, a + first, b + first, base + first, step + first, blocks + k, n);
        for (size_t i = 0; i < n; i++)
            slerp16_to(&p, &series, CLIP_BLOCK * i, &blocks[k + i], out, stride);
    }
}

/*
 * Two neighbouring compact keys whose samples are at steps much smaller than the distance of the keys: what does not
 * depend on t is kept (clip_cache.c). Each pair of loops returns the bits of the loop without `kept`.
 *
 *     numbers       key a of each lane as a float, n of them; then b - a: out = base + step (a + t (b - a))
 *     rotations     CLIP_KEPT_ROWS rows of a block: x y z w of a and the factor of its weight; the same of b; v
 *
 *     row           0    1    2    3    4         5    6    7    8    9         10
 *                   x a  y a  z a  w a  scale a   x b  y b  z b  w b  scale b   v         `width` floats each
 *
 * Blocks of rotations begin at every CLIP_KEPT_ROWS * 16 floats.
 */
NKW_LOOP(nkwi_clip_keep_lerp16)(const uint16_t *a, const uint16_t *b, float *kept, size_t n)
{
    float *d = kept + n;
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        kept[i] = (float)a[i];
        d[i] = (float)b[i] - (float)a[i];
    }
}

static inline void kept_lerp16_lanes(const float *from, const float *d, const float *base, const float *step, float t,
                                     float *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = base[i] + step[i] * (from[i] + t * d[i]);
}

NKW_LOOP(nkwi_clip_kept_lerp16)
(const float *kept, size_t n, const float *base, const float *step, float t, const clip_block *blocks,
 size_t block_count, float *out)
{
    for (size_t k = 0, lanes; k < block_count; k += blocks_in(lanes)) {
        size_t at = k * CLIP_BLOCK;
        int contiguous = blocks[k].contiguous > 0;
        float buffer[CLIP_SCATTER_BLOCKS * CLIP_BLOCK];
        lanes = lanes_together(blocks + k, block_count - k);
        kept_lerp16_lanes(kept + at, kept + n + at, base + at, step + at, t,
                          contiguous ? out + blocks[k].place : buffer, lanes);
        if (!contiguous)
            scatter_numbers(blocks + k, buffer, out, lanes);
    }
}

NKW_LOOP(nkwi_clip_keep_slerp16)
(const uint16_t *a, const uint16_t *b, const float *base, const float *step, const clip_block *blocks,
 size_t block_count, float *kept)
{
    for (size_t k = 0; k < block_count; k += CLIP_SLERP16_BLOCKS) {
        const size_t n = blocks16(block_count - k), first = 3 * CLIP_BLOCK * k;
        pairs16 p;
        pairs16_of(&p, a + first, b + first, base + first, step + first, blocks + k, n);
        for (size_t i = 0; i < n; i++)
            keep_rows(&p, CLIP_BLOCK * i, kept + CLIP_KEPT_ROWS * CLIP_BLOCK * (k + i), blocks[k + i].width);
    }
}

NKW_ALWAYS_INLINE void kept_slerp16_block(const float *kept, const lane_compact_series *series, float *out,
                                          size_t stride, size_t width)
{
    const float *nearer = kept + (series->first ? 0 : 5 * width), *farther = kept + (series->first ? 5 * width : 0);
    const float *scale_n = nearer + 4 * width, *scale_f = farther + 4 * width, *v = kept + 10 * width;
    const nkw_quat_view n = block_rows(nearer, width), f = block_rows(farther, width);
    const nkw_quat_span o = block_rows_to(out, stride);
#pragma omp simd
    NKW_KEEP_LOOP
    for (size_t i = 0; i < width; i++)
        put_quat(o, i, lane_compact_slerp(at_quat(n, i), at_quat(f, i), v[i], scale_n[i], scale_f[i], series));
}

NKW_LOOP(nkwi_clip_kept_slerp16)
(const float *kept, float t, const clip_block *blocks, size_t block_count, float *out, size_t stride)
{
    const lane_compact_series series = lane_compact_series_at(t);
    for (size_t k = 0; k < block_count; k++, kept += CLIP_KEPT_ROWS * CLIP_BLOCK) {
        float buffer[4 * CLIP_BLOCK];
        const int contiguous = blocks[k].contiguous > 0;
        float *to = contiguous ? out + blocks[k].place : buffer;
        const size_t to_stride = contiguous ? stride : CLIP_BLOCK;
        if (blocks[k].width == CLIP_BLOCK)
            kept_slerp16_block(kept, &series, to, to_stride, CLIP_BLOCK);
        else if (blocks[k].width == 8)
            kept_slerp16_block(kept, &series, to, to_stride, 8);
        else
            kept_slerp16_block(kept, &series, to, to_stride, 4);
        if (!contiguous)
            scatter(&blocks[k], buffer, CLIP_BLOCK, out, stride);
    }
}

/*
 * n lanes of CUBICSPLINE. A key has three parts of `words` floats each; tangents are per second, and are multiplied by
 * the duration of the segment.
 *
 *     a   in-tangents | values p0   | out-tangents v0
 *     b   in-tangents v1 | values p1 | out-tangents
 */
NKW_ALWAYS_INLINE void hermite_from(int first, const float *a, const float *b, size_t words, float duration, float t,
                                    float *out, size_t n)
{
    const float *p0 = a + words, *v0 = p0 + words, *v1 = b, *p1 = b + words;
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = nkw_hermite_from(first, 1, p0[i], duration * v0[i], p1[i], duration * v1[i], t);
}

/* 0 < t < 1. */
NKW_ALWAYS_INLINE void hermite_lanes(const float *a, const float *b, size_t words, float duration, float t, float *out,
                                     size_t n)
{
    if (t < 0.5f)
        hermite_from(1, a, b, words, duration, t, out, n);
    else
        hermite_from(0, a, b, words, duration, t, out, n);
}

NKW_LOOP(nkwi_clip_hermite)
(const float *a, const float *b, size_t words, float duration, float t, const clip_block *blocks, size_t block_count,
 float *out)
{
    for (size_t k = 0, lanes; k < block_count; k += blocks_in(lanes)) {
        float buffer[CLIP_SCATTER_BLOCKS * CLIP_BLOCK];
        size_t at = k * CLIP_BLOCK;
        int contiguous = blocks[k].contiguous > 0;
        lanes = lanes_together(blocks + k, block_count - k);
        hermite_lanes(a + at, b + at, words, duration, t, contiguous ? out + blocks[k].place : buffer, lanes);
        if (!contiguous)
            scatter_numbers(blocks + k, buffer, out, lanes);
    }
}

/* x / |x| of the rows of a block. |x|^2 is that of NKW_NORMAL_SCALE x, as in nkw_quat_normalize. */
NKW_ALWAYS_INLINE void normalize_block(const float *x, float *out, size_t stride, size_t width)
{
    nkw_quat_span o = block_rows_to(out, stride);
    nkw_quat_view q = block_rows(x, width);
#pragma omp simd
    for (size_t i = 0; i < width; i++) {
        nkw_quat v = nkw_quat_scale(at_quat(q, i), NKW_NORMAL_SCALE);
        put_quat(o, i, nkw_quat_normalize_any(at_quat(q, i), nkw_quat_dot(v, v), NKW_NORMAL_SCALE));
    }
}

/* Hermite of the four rows of a block, 4 * width lanes, then normalised: glTF's CUBICSPLINE of rotations. */
NKW_ALWAYS_INLINE void quat_hermite_block(const float *a, const float *b, size_t words, float duration, float t,
                                          float *out, size_t stride, size_t width)
{
    float lanes[4 * CLIP_BLOCK];
    hermite_lanes(a, b, words, duration, t, lanes, 4 * width);
    normalize_block(lanes, out, stride, width);
}

NKW_LOOP(nkwi_clip_quat_hermite)
(const float *a, const float *b, size_t words, float duration, float t, const clip_block *blocks, size_t block_count,
 float *out, size_t stride)
{
    for (size_t k = 0; k < block_count; k++, a += 4 * CLIP_BLOCK, b += 4 * CLIP_BLOCK) {
        float buffer[4 * CLIP_BLOCK];
        int contiguous = blocks[k].contiguous > 0;
        float *o = contiguous ? out + blocks[k].place : buffer;
        size_t out_stride = contiguous ? stride : CLIP_BLOCK;
        if (blocks[k].width == CLIP_BLOCK)
            quat_hermite_block(a, b, words, duration, t, o, out_stride, CLIP_BLOCK);
        else
            quat_hermite_block(a, b, words, duration, t, o, out_stride, blocks[k].width);
        if (!contiguous)
            scatter(&blocks[k], buffer, CLIP_BLOCK, out, stride);
    }
}

/* Copies the four rows of a block to contiguous places. A constant width compiles to loads and stores only. */
NKW_ALWAYS_INLINE void copy_rows(const float *from, float *out, size_t stride, size_t width)
{
    for (size_t row = 0; row < 4; row++)
        memcpy(out + row * stride, from + row * width, width * sizeof(float));
}

/* The four rows at `from`, `width` floats apart, to their places. */
static inline void place(const clip_block *block, const float *from, float *out, size_t stride)
{
    const size_t width = block->width;
    if (!block->contiguous)
        scatter(block, from, width, out, stride);
    else if (width == CLIP_BLOCK)
        copy_rows(from, out + block->place, stride, CLIP_BLOCK);
    else
        copy_rows(from, out + block->place, stride, width);
}

/* Copies the values of a key to their places. */
NKW_LOOP(nkwi_clip_hold)(const float *key, const clip_block *blocks, size_t block_count, float *out)
{
    for (size_t k = 0, lanes; k < block_count; k += blocks_in(lanes)) {
        lanes = lanes_together(blocks + k, block_count - k);
        if (blocks[k].contiguous)
            memcpy(out + blocks[k].place, key + k * CLIP_BLOCK, lanes * sizeof *out);
        else
            scatter_numbers(blocks + k, key + k * CLIP_BLOCK, out, lanes);
    }
}

/* Copies the rotations of a key, the first 4 of `rows` rows of each block, to their places; normalised on request. */
NKW_LOOP(nkwi_clip_quat_hold)
(const float *key, size_t rows, int normalized, const clip_block *blocks, size_t block_count, float *out, size_t stride)
{
    for (size_t k = 0; k < block_count; k++, key += rows * CLIP_BLOCK) {
        size_t width = blocks[k].width;
        float unit[4 * CLIP_BLOCK];
        if (normalized)
            normalize_block(key, unit, width, width);
        place(&blocks[k], normalized ? unit : key, out, stride);
    }
}
