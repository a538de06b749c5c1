/* SPDX-License-Identifier: MIT */
/* The loops of clip.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_CLIP_H
#define NAKAWARI_BATCH_CLIP_H

#include "batch/isa.h"
#include "batch/block.h"
#include "batch/clip_packed.h"

/* clang-format off */
#define NKW_LOOPS_CLIP(X) \
    X(nkwi_clip_arcs, (float *a, const float *b, const clip_block *blocks, size_t block_count), (a, b, blocks, block_count), NKW_WIDEST) \
    X(nkwi_clip_lerp, (const float *a, const float *b, float t, const clip_block *blocks, size_t block_count, float *out), (a, b, t, blocks, block_count, out), NKW_WIDEST) \
    X(nkwi_clip_slerp, (const float *a, const float *b, float t, const clip_block *blocks, size_t block_count, float *out, size_t stride), (a, b, t, blocks, block_count, out, stride), NKW_WIDEST) \
    X(nkwi_clip_hermite, (const float *a, const float *b, size_t words, float duration, float t, const clip_block *blocks, size_t block_count, float *out), (a, b, words, duration, t, blocks, block_count, out), NKW_WIDEST) \
    X(nkwi_clip_quat_hermite, (const float *a, const float *b, size_t words, float duration, float t, const clip_block *blocks, size_t block_count, float *out, size_t stride), (a, b, words, duration, t, blocks, block_count, out, stride), NKW_WIDEST) \
    X(nkwi_clip_lerp16, (const uint16_t *a, const uint16_t *b, const float *base, const float *step, float t, const clip_block *blocks, size_t block_count, float *out), (a, b, base, step, t, blocks, block_count, out), NKW_WIDEST) \
    X(nkwi_clip_slerp16, (const uint16_t *a, const uint16_t *b, const float *base, const float *step, float t, const clip_block *blocks, size_t block_count, float *out, size_t stride), (a, b, base, step, t, blocks, block_count, out, stride), NKW_WIDEST) \
    X(nkwi_clip_hold, (const float *key, const clip_block *blocks, size_t block_count, float *out), (key, blocks, block_count, out), NKW_WIDEST) \
    X(nkwi_clip_quat_hold, (const float *key, size_t rows, int normalized, const clip_block *blocks, size_t block_count, float *out, size_t stride), (key, rows, normalized, blocks, block_count, out, stride), NKW_WIDEST) \
    X(nkwi_clip_keep_lerp16, (const uint16_t *a, const uint16_t *b, float *kept, size_t n), (a, b, kept, n), NKW_WIDEST) \
    X(nkwi_clip_kept_lerp16, (const float *kept, size_t n, const float *base, const float *step, float t, const clip_block *blocks, size_t block_count, float *out), (kept, n, base, step, t, blocks, block_count, out), NKW_WIDEST) \
    X(nkwi_clip_keep_slerp16, (const uint16_t *a, const uint16_t *b, const float *base, const float *step, const clip_block *blocks, size_t block_count, float *kept), (a, b, base, step, blocks, block_count, kept), NKW_WIDEST) \
    X(nkwi_clip_kept_slerp16, (const float *kept, float t, const clip_block *blocks, size_t block_count, float *out, size_t stride), (kept, t, blocks, block_count, out, stride), NKW_WIDEST) \
    X(nkwi_clip_keep_packed, (const packed_at *p, int held, float *kept), (p, held, kept), NKW_WIDEST) \
    X(nkwi_clip_keep_packed_rotations, (const packed_at *p, int held, const clip_block *blocks, size_t block_count, float *kept), (p, held, blocks, block_count, kept), NKW_WIDEST)
/* clang-format on */

NKW_LOOPS_CLIP(NKW_DECLARE)

#endif
