/* SPDX-License-Identifier: MIT */
/* Slerp between decoded rotations of three numbers (lane/compact.h), in blocks of lanes. */
#ifndef NAKAWARI_BATCH_CLIP_COMPACT_H
#define NAKAWARI_BATCH_CLIP_COMPACT_H

#include "lane/strict.h"

#include <string.h>

#include "batch/block.h"
#include "batch/clip_place.h"
#include "batch/element.h"
#include "lane/compact.h"
#include "sizes.h"

/*
 * The decoded rotations of one key: xyz in blocks and rows as in the key; w and the factor `scale` of the weight
 * (lane_compact_arc) of each lane.
 */
typedef struct key16 {
    float xyz[3 * CLIP_SLERP16_BLOCKS * CLIP_BLOCK], w[CLIP_SLERP16_BLOCKS * CLIP_BLOCK],
        scale[CLIP_SLERP16_BLOCKS * CLIP_BLOCK];
} key16;

typedef struct pairs16 {
    key16 a, b;
    float v[CLIP_SLERP16_BLOCKS * CLIP_BLOCK];
} pairs16;

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

/* Computes w, scales and v of the block whose first lane is `at`. negated: of each lane, 0 or the sign bit. */
NKW_ALWAYS_INLINE void arcs_of(pairs16 *p, const uint32_t *negated, size_t at, size_t width)
{
    const nkw_vec3_view from = vectors_of(&p->a, at, width), to = vectors_of(&p->b, at, width);
    float *from_w = p->a.w + at, *to_w = p->b.w + at, *scale_a = p->a.scale + at, *scale_b = p->b.scale + at,
          *v = p->v + at;
#pragma omp simd
    for (size_t i = 0; i < width; i++) {
        nkw_quat q0 = lane_compact_quat(at_vec3(from, i)), q1 = lane_compact_quat(at_vec3(to, i));
        lane_compact_arc arc = lane_compact_arc_between(q0, q1, negated[i]);
        from_w[i] = q0.w;
        to_w[i] = q1.w;
        v[i] = arc.v;
        scale_a[i] = arc.scale_a;
        scale_b[i] = arc.scale_b;
    }
}

/* Copies a block of pairs to what is kept of it (clip_cache.h). */
NKW_ALWAYS_INLINE void keep_width(const pairs16 *p, size_t at, float *kept, size_t width)
{
    const float *rows[4] = {p->a.w, p->a.scale, p->b.w, p->b.scale};
    memcpy(kept, p->a.xyz + 3 * at, 3 * width * sizeof *kept);
    memcpy(kept + 5 * width, p->b.xyz + 3 * at, 3 * width * sizeof *kept);
    for (size_t i = 0; i < 4; i++)
        memcpy(kept + (i / 2 * 5 + 3 + i % 2) * width, rows[i] + at, width * sizeof *kept);
    memcpy(kept + 10 * width, p->v + at, width * sizeof *kept);
}

/* Dispatches on the width: a constant width compiles to loads and stores only. */
NKW_ALWAYS_INLINE void keep_rows(const pairs16 *p, size_t at, float *kept, size_t width)
{
    if (width == CLIP_BLOCK)
        keep_width(p, at, kept, CLIP_BLOCK);
    else if (width == 8)
        keep_width(p, at, kept, 8);
    else
        keep_width(p, at, kept, 4);
}

NKW_ALWAYS_INLINE void slerp_of(const pairs16 *p, const lane_compact_series *series, size_t at, float *out,
                                size_t stride, size_t width)
{
    const key16 *nearer = series->first ? &p->a : &p->b, *farther = series->first ? &p->b : &p->a;
    const nkw_quat_view n = rotations_of(nearer, at, width), f = rotations_of(farther, at, width);
    const nkw_quat_span o = block_rows_to(out, stride);
    const float *v = p->v + at, *scale_n = nearer->scale + at, *scale_f = farther->scale + at;
#pragma omp simd
    for (size_t i = 0; i < width; i++)
        put_quat(o, i, lane_compact_slerp(at_quat(n, i), at_quat(f, i), v[i], scale_n[i], scale_f[i], series));
}

/* Dispatch on the width, so that it is a constant in each loop. */

NKW_ALWAYS_INLINE void slerp16(const pairs16 *p, const lane_compact_series *series, size_t at, float *out,
                               size_t stride, size_t width)
{
    if (width == CLIP_BLOCK)
        slerp_of(p, series, at, out, stride, CLIP_BLOCK);
    else if (width == 8)
        slerp_of(p, series, at, out, stride, 8);
    else
        slerp_of(p, series, at, out, stride, 4);
}

NKW_ALWAYS_INLINE void slerp16_to(const pairs16 *p, const lane_compact_series *series, size_t at,
                                  const clip_block *block, float *out, size_t stride)
{
    float buffer[4 * CLIP_BLOCK];
    const int contiguous = block->contiguous > 0;
    slerp16(p, series, at, contiguous ? out + block->place : buffer, contiguous ? stride : CLIP_BLOCK, block->width);
    if (!contiguous)
        scatter(block, buffer, CLIP_BLOCK, out, stride);
}

#endif
