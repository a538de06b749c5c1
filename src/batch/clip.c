/* SPDX-License-Identifier: MIT */
/* Between two keys of a clip's group, block by block. src/clip_layout.h has the layout of keys. */
#include "lane/strict.h"

#include <string.h>

#include "batch/block.h"
#include "batch/element.h"
#include "batch/table.h"
#include "lane/curve.h"
#include "lane/orient.h"

/* Rows of a block that stand `width` floats apart. */
static inline nkw_quat_view rows_of(const float *x, size_t width)
{
    nkw_quat_view view = {x, x + width, x + 2 * width, x + 3 * width};
    return view;
}

static inline nkw_quat_span rows_to(float *x, size_t stride)
{
    nkw_quat_span span = {x, x + stride, x + 2 * stride, x + 3 * stride};
    return span;
}

/* The lanes of `rows` rows, `apart` floats apart, to their places in components `stride` apart. */
static inline void scatter(const nkw_block *block, const float *from, size_t apart, size_t rows, float *out,
                           size_t stride)
{
    for (size_t i = 0; i < block->count; i++) {
        float *to = out + block->places[i];
        for (size_t row = 0; row < rows; row++)
            to[row * stride] = from[row * apart + i];
    }
}

static inline size_t blocks_in(size_t lanes)
{
    return (lanes + NKW_BLOCK - 1) / NKW_BLOCK;
}

/* The arc from a key to the next as one number: v, with the sign bit of "turned". */
static inline lane_slerp_arc arc_of(float number)
{
    return lane_slerp_arc_of(lane_sign_bit(number), lane_abs(number));
}

static inline void arcs_of_block(float *a, const float *b, size_t width)
{
    nkw_quat_view from = rows_of(a, width), to = rows_of(b, width);
    float *arcs = a + 4 * width;
#pragma omp simd
    for (size_t i = 0; i < width; i++) {
        lane_slerp_arc arc = lane_slerp_arc_between(at_quat(from, i), at_quat(to, i));
        arcs[i] = lane_flip(arc.v, arc.turned);
    }
}

/* Writes the arcs of key a to key b into a. */
KERNEL(clip_arcs)(float *a, const float *b, const nkw_block *blocks, size_t block_count)
{
    for (size_t k = 0; k < block_count; k++) {
        size_t at = k * NKW_BLOCK * NKW_BLOCK_ROWS;
        arcs_of_block(a + at, b + at, blocks[k].width);
    }
}

INLINE void lerp_lanes(const float *a, const float *b, float t, int first, float *out, size_t n)
{
#pragma omp simd
    KEEP_LOOP
    for (size_t i = 0; i < n; i++)
        out[i] = lane_lerp_near(a[i], b[i], t, first);
}

/* `lanes` lanes, whole blocks. */
INLINE void lerp_stretch(const float *a, const float *b, float t, int first, float *out, size_t lanes)
{
    for (; lanes >= NKW_BLOCK; lanes -= NKW_BLOCK, a += NKW_BLOCK, b += NKW_BLOCK, out += NKW_BLOCK)
        lerp_lanes(a, b, t, first, out, NKW_BLOCK);
    if (lanes == 8)
        lerp_lanes(a, b, t, first, out, 8);
    else if (lanes == 4)
        lerp_lanes(a, b, t, first, out, 4);
}

INLINE void lerp_blocks(const float *a, const float *b, float t, int first, const nkw_block *blocks, size_t block_count,
                        float *out)
{
    for (size_t k = 0, lanes; k < block_count; k += blocks_in(lanes)) {
        float mixed[NKW_BLOCK];
        int direct = blocks[k].direct > 0;
        lanes = direct ? blocks[k].direct : blocks[k].width;
        lerp_stretch(a + k * NKW_BLOCK, b + k * NKW_BLOCK, t, first, direct ? out + blocks[k].places[0] : mixed, lanes);
        if (!direct)
            scatter(&blocks[k], mixed, 0, 1, out, 0);
    }
}

/* For t inside 0..1: at the ends there is a key to hold. */
KERNEL(clip_lerp)(const float *a, const float *b, float t, const nkw_block *blocks, size_t block_count, float *out)
{
    if (t < 0.5f)
        lerp_blocks(a, b, t, 1, blocks, block_count, out);
    else
        lerp_blocks(a, b, t, 0, blocks, block_count, out);
}

/* Blocks of rotations that are worked out together, at most. */
#define TOGETHER 2

/* E(u) and E(t) of lanes. */
typedef struct excesses {
    float u[NKW_BLOCK], t[NKW_BLOCK];
} excesses;

INLINE void excesses_of_block(const float *arcs, lane_slerp_pace pace, excesses *e, size_t width)
{
#pragma omp simd
    KEEP_LOOP
    for (size_t i = 0; i < width; i++) {
        lane_slerp_arc arc = arc_of(arcs[i]);
        e->u[i] = lane_slerp_excess_on(&arc, &pace, pace.u);
        e->t[i] = lane_slerp_excess_on(&arc, &pace, pace.t);
    }
}

INLINE void slerp_block(const float *a, const float *b, const excesses *e, lane_slerp_pace pace, float *out,
                        size_t stride, size_t width)
{
    nkw_quat_view from = rows_of(a, width), to = rows_of(b, width);
    nkw_quat_span o = rows_to(out, stride);
    const float *arcs = a + 4 * width;
#pragma omp simd
    KEEP_LOOP
    for (size_t i = 0; i < width; i++) {
        uint32_t turned = lane_sign_bit(arcs[i]);
        put_quat(o, i, lane_quat_slerp_by(at_quat(from, i), at_quat(to, i), turned, &pace, e->u[i], e->t[i]));
    }
}

/* n blocks, first all of their polynomials: no lane waits for those of the one before. */
INLINE void slerp_together(const float *a, const float *b, lane_slerp_pace pace, float *out, size_t stride,
                           size_t width, size_t n)
{
    const size_t block = NKW_BLOCK * NKW_BLOCK_ROWS;
    excesses e[TOGETHER];
    for (size_t k = 0; k < n; k++)
        excesses_of_block(a + k * block + 4 * width, pace, &e[k], width);
    for (size_t k = 0; k < n; k++)
        slerp_block(a + k * block, b + k * block, &e[k], pace, out + k * NKW_BLOCK, stride, width);
}

/* `lanes` lanes, whole blocks, from one after the other to one after the other. */
INLINE void slerp_stretch(const float *a, const float *b, lane_slerp_pace pace, float *out, size_t stride, size_t lanes)
{
    const size_t block = NKW_BLOCK * NKW_BLOCK_ROWS;
    for (size_t n; lanes >= NKW_BLOCK; lanes -= n * NKW_BLOCK, a += n * block, b += n * block, out += n * NKW_BLOCK) {
        n = lanes < TOGETHER * NKW_BLOCK ? 1 : TOGETHER;
        slerp_together(a, b, pace, out, stride, NKW_BLOCK, n);
    }
    if (lanes == 8)
        slerp_together(a, b, pace, out, stride, 8, 1);
    else if (lanes == 4)
        slerp_together(a, b, pace, out, stride, 4, 1);
}

INLINE void slerp_blocks(const float *a, const float *b, lane_slerp_pace pace, const nkw_block *blocks,
                         size_t block_count, float *out, size_t stride)
{
    for (size_t k = 0, lanes; k < block_count; k += blocks_in(lanes)) {
        const size_t at = k * NKW_BLOCK * NKW_BLOCK_ROWS;
        float mixed[4 * NKW_BLOCK];
        int direct = blocks[k].direct > 0;
        lanes = direct ? blocks[k].direct : blocks[k].width;
        slerp_stretch(a + at, b + at, pace, direct ? out + blocks[k].places[0] : mixed, direct ? stride : NKW_BLOCK,
                      lanes);
        if (!direct)
            scatter(&blocks[k], mixed, NKW_BLOCK, 4, out, stride);
    }
}

KERNEL(clip_slerp)
(const float *a, const float *b, float t, const nkw_block *blocks, size_t block_count, float *out, size_t stride)
{
    lane_slerp_pace pace = lane_slerp_pace_at(t);
    if (pace.first)
        slerp_blocks(a, b, lane_slerp_near(pace, 1), blocks, block_count, out, stride);
    else if (pace.half)
        slerp_blocks(a, b, pace, blocks, block_count, out, stride);
    else
        slerp_blocks(a, b, lane_slerp_near(pace, 0), blocks, block_count, out, stride);
}

/* Compact keys. A number is base + step key; between two keys of a number the key itself is interpolated. */

static inline void lerp16_lanes(const uint16_t *a, const uint16_t *b, const float *base, const float *step, float t,
                                float *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = base[i] + step[i] * nkw_lerp((float)a[i], (float)b[i], t);
}

KERNEL(clip_lerp16)
(const uint16_t *a, const uint16_t *b, const float *base, const float *step, float t, const nkw_block *blocks,
 size_t block_count, float *out)
{
    for (size_t k = 0, lanes; k < block_count; k += blocks_in(lanes)) {
        size_t at = k * NKW_BLOCK;
        int direct = blocks[k].direct > 0;
        float mixed[NKW_BLOCK];
        lanes = direct ? blocks[k].direct : blocks[k].width;
        lerp16_lanes(a + at, b + at, base + at, step + at, t, direct ? out + blocks[k].places[0] : mixed, lanes);
        if (!direct)
            scatter(&blocks[k], mixed, 0, 1, out, 0);
    }
}

/*
 * A pass of its own over both keys: with 16-bit numbers in it, the loop over rotations would take twice as many as
 * registers hold.
 */
static inline void decode(const uint16_t *a, const uint16_t *b, const float *base, const float *step, float *from,
                          float *to, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        from[i] = base[i] + step[i] * (float)a[i];
        to[i] = base[i] + step[i] * (float)b[i];
    }
}

/* q / |q| for a length that is near 1: 1/sqrt(1 - m) = 1 + m/2 + 3 m^2/8 ... */
static inline nkw_quat near_unit(nkw_quat q)
{
    float m = lane_quat_defect(q);
    return nkw_quat_add(q, nkw_quat_scale(q, m * (0.5f + 0.375f * m)));
}

/*
 * Keys are on the side of the one before. Those half a turn apart have a dot product about 0, which 16 bits may have
 * made negative: they are not turned again, for that would be the way round the other side. Arcs have a pass of their
 * own, so that no lane waits for the division of the one before.
 */
INLINE void slerp16_block(const float *a, const float *b, lane_slerp_pace pace, float *out, size_t stride, size_t width)
{
    nkw_quat_view from = rows_of(a, width), to = rows_of(b, width);
    nkw_quat_span o = rows_to(out, stride);
    float arcs[NKW_BLOCK];
#pragma omp simd
    for (size_t i = 0; i < width; i++) {
        nkw_quat p = at_quat(from, i), q = at_quat(to, i);
        arcs[i] = lane_slerp_arc_to(p, q, lane_slerp_cosine(p, q), 0).v;
    }
#pragma omp simd
    for (size_t i = 0; i < width; i++) {
        lane_slerp_arc arc = lane_slerp_arc_of(0, arcs[i]);
        put_quat(o, i, near_unit(lane_quat_slerp_on(at_quat(from, i), at_quat(to, i), &arc, &pace)));
    }
}

INLINE void slerp16_blocks(const uint16_t *a, const uint16_t *b, const float *base, const float *step,
                           lane_slerp_pace pace, const nkw_block *blocks, size_t block_count, float *out, size_t stride)
{
    for (size_t k = 0; k < block_count; k++) {
        size_t at = k * 4 * NKW_BLOCK, width = blocks[k].width;
        float from[4 * NKW_BLOCK], to[4 * NKW_BLOCK], mixed[4 * NKW_BLOCK];
        int direct = blocks[k].direct > 0;
        float *o = direct ? out + blocks[k].places[0] : mixed;
        size_t apart = direct ? stride : NKW_BLOCK;
        if (width == NKW_BLOCK) {
            decode(a + at, b + at, base + at, step + at, from, to, 4 * NKW_BLOCK);
            slerp16_block(from, to, pace, o, apart, NKW_BLOCK);
        } else {
            decode(a + at, b + at, base + at, step + at, from, to, 4 * width);
            slerp16_block(from, to, pace, o, apart, width);
        }
        if (!direct)
            scatter(&blocks[k], mixed, NKW_BLOCK, 4, out, stride);
    }
}

KERNEL(clip_slerp16)
(const uint16_t *a, const uint16_t *b, const float *base, const float *step, float t, const nkw_block *blocks,
 size_t block_count, float *out, size_t stride)
{
    lane_slerp_pace pace = lane_slerp_pace_at(t);
    if (pace.first)
        slerp16_blocks(a, b, base, step, lane_slerp_near(pace, 1), blocks, block_count, out, stride);
    else if (pace.half)
        slerp16_blocks(a, b, base, step, pace, blocks, block_count, out, stride);
    else
        slerp16_blocks(a, b, base, step, lane_slerp_near(pace, 0), blocks, block_count, out, stride);
}

/* `words` floats to a value. Tangents are per second; times the duration they are per segment. */
static inline void hermite_block(const float *a, const float *b, size_t words, float duration, float t, float *out,
                                 size_t n)
{
    const float *p0 = a + words, *v0 = p0 + words, *v1 = b, *p1 = b + words;
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = nkw_hermite(p0[i], duration * v0[i], p1[i], duration * v1[i], t);
}

KERNEL(clip_hermite)
(const float *a, const float *b, size_t words, float duration, float t, const nkw_block *blocks, size_t block_count,
 float *out)
{
    for (size_t k = 0; k < block_count; k++, a += NKW_BLOCK, b += NKW_BLOCK) {
        float lanes[NKW_BLOCK];
        hermite_block(a, b, words, duration, t, lanes, blocks[k].width);
        scatter(&blocks[k], lanes, 0, 1, out, 0);
    }
}

static inline void normalize_block(float *x, size_t width)
{
    nkw_quat_span o = rows_to(x, width);
    nkw_quat_view q = rows_of(x, width);
#pragma omp simd
    for (size_t i = 0; i < width; i++)
        put_quat(o, i, lane_quat_normalize(at_quat(q, i)));
}

KERNEL(clip_quat_hermite)
(const float *a, const float *b, size_t words, float duration, float t, const nkw_block *blocks, size_t block_count,
 float *out, size_t stride)
{
    for (size_t k = 0; k < block_count; k++, a += 4 * NKW_BLOCK, b += 4 * NKW_BLOCK) {
        float lanes[4 * NKW_BLOCK];
        hermite_block(a, b, words, duration, t, lanes, 4 * (size_t)blocks[k].width);
        normalize_block(lanes, blocks[k].width);
        scatter(&blocks[k], lanes, blocks[k].width, 4, out, stride);
    }
}

/* `rows` rows of a block to their places; a constant width is a few loads and stores. */
INLINE void copy_rows(const float *from, size_t rows, float *out, size_t stride, size_t width)
{
    for (size_t row = 0; row < rows; row++)
        memcpy(out + row * stride, from + row * width, width * sizeof(float));
}

static inline void place(const nkw_block *block, const float *from, size_t rows, float *out, size_t stride)
{
    const size_t width = block->width;
    float *to = out + block->places[0];
    if (!block->direct)
        scatter(block, from, width, rows, out, stride);
    else if (width == NKW_BLOCK)
        copy_rows(from, rows, to, stride, NKW_BLOCK);
    else
        copy_rows(from, rows, to, stride, width);
}

/* A key's values as they are, `rows` rows of a lane among `key_rows` in a block; rotations normalised if asked. */
KERNEL(clip_hold)
(const float *key, size_t rows, size_t key_rows, int normalized, const nkw_block *blocks, size_t block_count,
 float *out, size_t stride)
{
    for (size_t k = 0; k < block_count; k++, key += key_rows * NKW_BLOCK) {
        size_t width = blocks[k].width;
        float lanes[4 * NKW_BLOCK];
        if (!normalized) {
            place(&blocks[k], key, rows, out, stride);
            continue;
        }
        for (size_t i = 0; i < 4 * width; i++)
            lanes[i] = key[i];
        normalize_block(lanes, width);
        place(&blocks[k], lanes, 4, out, stride);
    }
}
