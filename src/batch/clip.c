/* SPDX-License-Identifier: MIT */
/* Between two keys of a clip's group, block by block. src/clip_layout.h has the layout of keys. */
#include "lane/strict.h"

#include <string.h>

#include "batch/block.h"
#include "batch/element.h"
#include "batch/clip.h"
#include "lane/clip.h"
#include "lane/curve.h"

NKW_LOOPS_CLIP(NKW_DECLARE_LOOP)

/* Rotations in rows `apart` floats apart to their places in components `stride` apart; two at a time. */
static inline void scatter(const nkw_block *block, const float *from, size_t apart, float *out, size_t stride)
{
    const uint32_t *places = block->places;
    size_t i = 0;
    for (; i + 1 < block->count; i += 2) {
        float *to = out + places[i];
        if (places[i + 1] - places[i] == 1)
            for (size_t row = 0; row < 4; row++)
                memcpy(to + row * stride, from + row * apart + i, 2 * sizeof *to);
        else
            for (size_t row = 0; row < 4; row++) {
                to[row * stride] = from[row * apart + i];
                out[places[i + 1] + row * stride] = from[row * apart + i + 1];
            }
    }
    for (size_t row = 0; i < block->count && row < 4; row++)
        out[places[i] + row * stride] = from[row * apart + i];
}

static inline size_t blocks_in(size_t lanes)
{
    return (lanes + NKW_BLOCK - 1) / NKW_BLOCK;
}

/* Scattered blocks of numbers that are worked out together, at most: no lane waits to be stored before the next. */
#define SCATTERED 8

/* How many lanes from the first block on are worked out together. */
static inline size_t lanes_together(const nkw_block *blocks, size_t block_count)
{
    size_t n = 0;
    while (n < block_count && n < SCATTERED && !blocks[n].direct && blocks[n].width == NKW_BLOCK)
        n++;
    return blocks->direct ? blocks->direct : n > 0 ? n * NKW_BLOCK : blocks->width;
}

INLINE void scatter_count(const uint32_t *places, const float *from, float *out, size_t count)
{
    for (size_t i = 0; i < count; i++)
        out[places[i]] = from[i];
}

/* `lanes` numbers, whole blocks, to their places; a constant count is a few loads and stores. */
static inline void scatter_numbers(const nkw_block *blocks, const float *from, float *out, size_t lanes)
{
    for (size_t k = 0; k < blocks_in(lanes); k++, from += NKW_BLOCK)
        if (blocks[k].count == NKW_BLOCK)
            scatter_count(blocks[k].places, from, out, NKW_BLOCK);
        else
            scatter_count(blocks[k].places, from, out, blocks[k].count);
}

static inline void arcs_of_block(float *a, const float *b, size_t width)
{
    nkw_quat_view from = block_rows(a, width), to = block_rows(b, width);
    float *arcs = a + 4 * width;
#pragma omp simd
    for (size_t i = 0; i < width; i++)
        arcs[i] = lane_slerp_arc(at_quat(from, i), at_quat(to, i), 1);
}

/* Writes the arcs of key a to key b into a. */
NKW_LOOP(nkwi_clip_arcs)(float *a, const float *b, const nkw_block *blocks, size_t block_count)
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
        out[i] = nkw_lerp_from(first, a[i], b[i], t);
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
        float mixed[SCATTERED * NKW_BLOCK];
        int direct = blocks[k].direct > 0;
        lanes = lanes_together(blocks + k, block_count - k);
        lerp_stretch(a + k * NKW_BLOCK, b + k * NKW_BLOCK, t, first, direct ? out + blocks[k].places[0] : mixed, lanes);
        if (!direct)
            scatter_numbers(blocks + k, mixed, out, lanes);
    }
}

/* For t inside 0..1: at the ends there is a key to hold. */
NKW_LOOP(nkwi_clip_lerp)
(const float *a, const float *b, float t, const nkw_block *blocks, size_t block_count, float *out)
{
    if (t < 0.5f)
        lerp_blocks(a, b, t, 1, blocks, block_count, out);
    else
        lerp_blocks(a, b, t, 0, blocks, block_count, out);
}

/* What the slerps of a group at one t share. */
typedef struct slerp_shared {
    lane_slerp_time at;
    lane_slerp_series series;
} slerp_shared;

INLINE void slerp_block(const float *a, const float *b, const slerp_shared *p, float *out, size_t stride, size_t width)
{
    nkw_quat_view from = block_rows(a, width), to = block_rows(b, width);
    nkw_quat_span o = block_rows_to(out, stride);
    const float *arcs = a + 4 * width;
#pragma omp simd
    KEEP_LOOP
    for (size_t i = 0; i < width; i++) {
        lane_slerp_weights k = lane_slerp_weights_in(&p->at, &p->series, lane_abs(arcs[i]));
        put_quat(o, i, lane_quat_slerp_by(at_quat(from, i), at_quat(to, i), arcs[i], &p->at, k));
    }
}

/* `lanes` lanes, whole blocks, from one after the other to one after the other. */
INLINE void slerp_stretch(const float *a, const float *b, const slerp_shared *p, float *out, size_t stride,
                          size_t lanes)
{
    const size_t block = NKW_BLOCK * NKW_BLOCK_ROWS;
    for (; lanes >= NKW_BLOCK; lanes -= NKW_BLOCK, a += block, b += block, out += NKW_BLOCK)
        slerp_block(a, b, p, out, stride, NKW_BLOCK);
    if (lanes == 8)
        slerp_block(a, b, p, out, stride, 8);
    else if (lanes == 4)
        slerp_block(a, b, p, out, stride, 4);
}

INLINE void slerp_blocks(const float *a, const float *b, lane_slerp_time at, const nkw_block *blocks,
                         size_t block_count, float *out, size_t stride)
{
    const slerp_shared p = {at, lane_slerp_series_at(&at)};
    for (size_t k = 0, lanes; k < block_count; k += blocks_in(lanes)) {
        const size_t from = k * NKW_BLOCK * NKW_BLOCK_ROWS;
        float mixed[4 * NKW_BLOCK];
        int direct = blocks[k].direct > 0;
        lanes = direct ? blocks[k].direct : blocks[k].width;
        slerp_stretch(a + from, b + from, &p, direct ? out + blocks[k].places[0] : mixed, direct ? stride : NKW_BLOCK,
                      lanes);
        if (!direct)
            scatter(&blocks[k], mixed, NKW_BLOCK, out, stride);
    }
}

NKW_LOOP(nkwi_clip_slerp)
(const float *a, const float *b, float t, const nkw_block *blocks, size_t block_count, float *out, size_t stride)
{
    lane_slerp_time at = lane_slerp_time_at(t, 0);
    if (!lane_t_is_generic(t))
        slerp_blocks(a, b, at, blocks, block_count, out, stride);
    else if (at.first)
        slerp_blocks(a, b, lane_slerp_time_from(at, 1), blocks, block_count, out, stride);
    else
        slerp_blocks(a, b, lane_slerp_time_from(at, 0), blocks, block_count, out, stride);
}

/* Compact keys. A number is base + step key; between two keys of a number the key itself is interpolated. */

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
(const uint16_t *a, const uint16_t *b, const float *base, const float *step, float t, const nkw_block *blocks,
 size_t block_count, float *out)
{
    for (size_t k = 0, lanes; k < block_count; k += blocks_in(lanes)) {
        size_t at = k * NKW_BLOCK;
        int direct = blocks[k].direct > 0;
        float mixed[SCATTERED * NKW_BLOCK];
        lanes = lanes_together(blocks + k, block_count - k);
        lerp16_lanes(a + at, b + at, base + at, step + at, t, direct ? out + blocks[k].places[0] : mixed, lanes);
        if (!direct)
            scatter_numbers(blocks + k, mixed, out, lanes);
    }
}

#define PAIRS 8 /* blocks that take each step together, so that no step waits for the divisions of the one before */

/* Rotations of a key, block by block as in the key, and what the arcs say of them. */
typedef struct key16 {
    float xyz[3 * PAIRS * NKW_BLOCK], w[PAIRS * NKW_BLOCK], of[PAIRS * NKW_BLOCK];
} key16;

typedef struct pairs16 {
    key16 a, b;
    float v[PAIRS * NKW_BLOCK];
} pairs16;

INLINE void decode_lanes(const uint16_t *key, const float *base, const float *step, float *out, size_t n)
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

/* Where its three numbers have an odd sum, a rotation of b is turned against the key before. */
INLINE void turns_of(const uint16_t *b, uint32_t *turned, size_t width)
{
#pragma omp simd
    for (size_t i = 0; i < width; i++)
        turned[i] = ((uint32_t)b[i] ^ b[width + i] ^ b[2 * width + i]) << 31;
}

static inline nkw_vec3_view vectors_of(const key16 *key, size_t at, size_t width)
{
    const float *x = key->xyz + 3 * at;
    nkw_vec3_view view = {x, x + width, x + 2 * width};
    return view;
}

static inline nkw_quat_view rotations_of(const key16 *key, size_t at, size_t width)
{
    const float *x = key->xyz + 3 * at;
    nkw_quat_view view = {x, x + width, x + 2 * width, key->w + at};
    return view;
}

/* The block whose first lane is `at`. */
INLINE void arcs_of(pairs16 *p, const uint16_t *b, size_t at, size_t width)
{
    const nkw_vec3_view from = vectors_of(&p->a, at, width), to = vectors_of(&p->b, at, width);
    float *from_w = p->a.w + at, *to_w = p->b.w + at, *of_a = p->a.of + at, *of_b = p->b.of + at, *v = p->v + at;
    uint32_t turned[NKW_BLOCK];
    turns_of(b, turned, width);
#pragma omp simd
    for (size_t i = 0; i < width; i++) {
        nkw_quat q0 = lane_compact_quat(at_vec3(from, i)), q1 = lane_compact_quat(at_vec3(to, i));
        lane_compact_arc arc = lane_compact_arc_between(q0, q1, turned[i]);
        from_w[i] = q0.w;
        to_w[i] = q1.w;
        v[i] = arc.v;
        of_a[i] = arc.of_a;
        of_b[i] = arc.of_b;
    }
}

INLINE void slerp_of(const pairs16 *p, const lane_compact_series *series, size_t at, float *out, size_t stride,
                     size_t width)
{
    const key16 *near = series->first ? &p->a : &p->b, *far = series->first ? &p->b : &p->a;
    const nkw_quat_view n = rotations_of(near, at, width), f = rotations_of(far, at, width);
    const nkw_quat_span o = block_rows_to(out, stride);
    const float *v = p->v + at, *of_n = near->of + at, *of_f = far->of + at;
#pragma omp simd
    for (size_t i = 0; i < width; i++)
        put_quat(o, i, lane_compact_slerp(at_quat(n, i), at_quat(f, i), v[i], of_n[i], of_f[i], series));
}

/* The widths as constants. */

INLINE void arcs16(pairs16 *p, const uint16_t *b, size_t at, size_t width)
{
    if (width == NKW_BLOCK)
        arcs_of(p, b, at, NKW_BLOCK);
    else if (width == 8)
        arcs_of(p, b, at, 8);
    else
        arcs_of(p, b, at, 4);
}

INLINE void slerp16(const pairs16 *p, const lane_compact_series *series, size_t at, float *out, size_t stride,
                    size_t width)
{
    if (width == NKW_BLOCK)
        slerp_of(p, series, at, out, stride, NKW_BLOCK);
    else if (width == 8)
        slerp_of(p, series, at, out, stride, 8);
    else
        slerp_of(p, series, at, out, stride, 4);
}

INLINE void slerp16_to(const pairs16 *p, const lane_compact_series *series, size_t at, const nkw_block *block,
                       float *out, size_t stride)
{
    float mixed[4 * NKW_BLOCK];
    const int direct = block->direct > 0;
    slerp16(p, series, at, direct ? out + block->places[0] : mixed, direct ? stride : NKW_BLOCK, block->width);
    if (!direct)
        scatter(block, mixed, NKW_BLOCK, out, stride);
}

NKW_LOOP(nkwi_clip_slerp16)
(const uint16_t *a, const uint16_t *b, const float *base, const float *step, float t, const nkw_block *blocks,
 size_t block_count, float *out, size_t stride)
{
    const lane_compact_series series = lane_compact_series_at(t);
    for (size_t k = 0; k < block_count; k += PAIRS) {
        const size_t n = block_count - k < PAIRS ? block_count - k : PAIRS, first = 3 * NKW_BLOCK * k;
        const size_t numbers = 3 * (NKW_BLOCK * (n - 1) + blocks[k + n - 1].width);
        pairs16 p;
        decode(a + first, base + first, step + first, p.a.xyz, numbers);
        decode(b + first, base + first, step + first, p.b.xyz, numbers);
        for (size_t i = 0; i < n; i++)
            arcs16(&p, b + first + 3 * NKW_BLOCK * i, NKW_BLOCK * i, blocks[k + i].width);
        for (size_t i = 0; i < n; i++)
            slerp16_to(&p, &series, NKW_BLOCK * i, &blocks[k + i], out, stride);
    }
}

/* A value has `words` floats; its tangents are per second: times the duration they are per segment. */
INLINE void hermite_from(int first, const float *a, const float *b, size_t words, float duration, float t, float *out,
                         size_t n)
{
    const float *p0 = a + words, *v0 = p0 + words, *v1 = b, *p1 = b + words;
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = nkw_hermite_from(first, p0[i], duration * v0[i], p1[i], duration * v1[i], t);
}

/* For t inside 0..1. */
INLINE void hermite_lanes(const float *a, const float *b, size_t words, float duration, float t, float *out, size_t n)
{
    if (t < 0.5f)
        hermite_from(1, a, b, words, duration, t, out, n);
    else
        hermite_from(0, a, b, words, duration, t, out, n);
}

NKW_LOOP(nkwi_clip_hermite)
(const float *a, const float *b, size_t words, float duration, float t, const nkw_block *blocks, size_t block_count,
 float *out)
{
    for (size_t k = 0, lanes; k < block_count; k += blocks_in(lanes)) {
        float mixed[SCATTERED * NKW_BLOCK];
        size_t at = k * NKW_BLOCK;
        int direct = blocks[k].direct > 0;
        lanes = lanes_together(blocks + k, block_count - k);
        hermite_lanes(a + at, b + at, words, duration, t, direct ? out + blocks[k].places[0] : mixed, lanes);
        if (!direct)
            scatter_numbers(blocks + k, mixed, out, lanes);
    }
}

INLINE void normalize_block(const float *x, float *out, size_t stride, size_t width)
{
    nkw_quat_span o = block_rows_to(out, stride);
    nkw_quat_view q = block_rows(x, width);
#pragma omp simd
    for (size_t i = 0; i < width; i++)
        put_quat(o, i, lane_quat_normalize(at_quat(q, i)));
}

INLINE void quat_hermite_block(const float *a, const float *b, size_t words, float duration, float t, float *out,
                               size_t stride, size_t width)
{
    float lanes[4 * NKW_BLOCK];
    hermite_lanes(a, b, words, duration, t, lanes, 4 * width);
    normalize_block(lanes, out, stride, width);
}

NKW_LOOP(nkwi_clip_quat_hermite)
(const float *a, const float *b, size_t words, float duration, float t, const nkw_block *blocks, size_t block_count,
 float *out, size_t stride)
{
    for (size_t k = 0; k < block_count; k++, a += 4 * NKW_BLOCK, b += 4 * NKW_BLOCK) {
        float mixed[4 * NKW_BLOCK];
        int direct = blocks[k].direct > 0;
        float *o = direct ? out + blocks[k].places[0] : mixed;
        size_t apart = direct ? stride : NKW_BLOCK;
        if (blocks[k].width == NKW_BLOCK)
            quat_hermite_block(a, b, words, duration, t, o, apart, NKW_BLOCK);
        else
            quat_hermite_block(a, b, words, duration, t, o, apart, blocks[k].width);
        if (!direct)
            scatter(&blocks[k], mixed, NKW_BLOCK, out, stride);
    }
}

/* A block of rotations to its places; a constant width is a few loads and stores. */
INLINE void copy_rows(const float *from, float *out, size_t stride, size_t width)
{
    for (size_t row = 0; row < 4; row++)
        memcpy(out + row * stride, from + row * width, width * sizeof(float));
}

static inline void place(const nkw_block *block, const float *from, float *out, size_t stride)
{
    const size_t width = block->width;
    if (!block->direct)
        scatter(block, from, width, out, stride);
    else if (width == NKW_BLOCK)
        copy_rows(from, out + block->places[0], stride, NKW_BLOCK);
    else
        copy_rows(from, out + block->places[0], stride, width);
}

/* A key's values as they are. */
NKW_LOOP(nkwi_clip_hold)(const float *key, const nkw_block *blocks, size_t block_count, float *out)
{
    for (size_t k = 0, lanes; k < block_count; k += blocks_in(lanes)) {
        lanes = lanes_together(blocks + k, block_count - k);
        if (blocks[k].direct)
            memcpy(out + blocks[k].places[0], key + k * NKW_BLOCK, lanes * sizeof *out);
        else
            scatter_numbers(blocks + k, key + k * NKW_BLOCK, out, lanes);
    }
}

/* Those of rotations, the first four of `rows` rows in a block; normalised if asked. */
NKW_LOOP(nkwi_clip_quat_hold)
(const float *key, size_t rows, int normalized, const nkw_block *blocks, size_t block_count, float *out, size_t stride)
{
    for (size_t k = 0; k < block_count; k++, key += rows * NKW_BLOCK) {
        size_t width = blocks[k].width;
        float unit[4 * NKW_BLOCK];
        if (normalized)
            normalize_block(key, unit, width, width);
        place(&blocks[k], normalized ? unit : key, out, stride);
    }
}
