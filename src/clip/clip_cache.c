/* SPDX-License-Identifier: MIT */
/*
 * Samples from what is kept of two neighbouring keys (clip_cache.h).
 *
 * Invariant: where *segment = k + 1, `kept` has what keys k and k + 1 of the group give for every t inside 0..1. So the
 * samples between two keys decode them once; the result has the bits of a sample without a cache.
 *
 *     numbers      key k | key k + 1 - key k, in steps; packed: k | k + 1      2 lanes floats
 *     rotations    of each block: x y z w scale of k | the same of k + 1 | v   CLIP_KEPT_ROWS rows
 *
 * At t = 1, and at t = 0 of compact keys, the function returns 0: nkwi_clip_sample_group then decodes that key alone. A
 * packed group takes t = 0 from here, because decoding its first key costs as much as both.
 */
#include "lane/strict.h"

#include <nakawari/clip.h>

#include "batch/clip.h"
#include "clip_cache.h"
#include "clip_packed.h"

/* Computes what is kept of the keys k and k + 1. */
static void keep(const nkw_clip *clip, const clip_group *g, size_t k, float *kept)
{
    const clip_block *blocks = clip_blocks(clip, g);
    const float *base = clip_floats(clip, g->ranges), *step = base + clip_rows(g) * g->lanes;
    const uint16_t *a = (const uint16_t *)(const void *)(clip_words(clip) + g->keys + k * g->key_words);
    const uint16_t *b = a + 2 * g->key_words;
    if (g->packed) {
        const packed_at p = packed_at_key(clip, g, clip_timelines(clip)[g->timeline].count, (uint32_t)k);
        if (g->kind == GROUP_ROTATIONS)
            nkwi_clip_keep_packed_rotations(&p, 0, blocks, g->block_count, kept);
        else
            nkwi_clip_keep_packed(&p, 0, kept);
    } else if (g->kind == GROUP_ROTATIONS) {
        nkwi_clip_keep_slerp16(a, b, base, step, blocks, g->block_count, kept);
    } else {
        nkwi_clip_keep_lerp16(a, b, kept, g->lanes);
    }
}

int nkwi_clip_sample_kept(const nkw_clip *clip, const clip_group *g, nkw_segment at, uint32_t *segment, float *kept,
                          float *out, size_t stride)
{
    const clip_timeline *line = clip_timelines(clip) + g->timeline;
    const clip_block *blocks = clip_blocks(clip, g);
    size_t k = at.index;
    uint32_t mode = line->modes ? clip_words(clip)[line->modes + k] : g->interpolation;
    if (k + 1 >= line->count || (at.t == 0.0f && !g->packed) || at.t == 1.0f || mode != NKW_INTERPOLATION_LINEAR)
        return 0;
    if (*segment != (uint32_t)k + 1)
        keep(clip, g, k, kept);
    *segment = (uint32_t)k + 1;
    if (g->kind == GROUP_ROTATIONS)
        nkwi_clip_kept_slerp16(kept, at.t, blocks, g->block_count, out, stride);
    else if (g->packed)
        nkwi_clip_lerp(kept, kept + g->lanes, at.t, blocks, g->block_count, out);
    else
        nkwi_clip_kept_lerp16(kept, g->lanes, clip_floats(clip, g->ranges), clip_floats(clip, g->ranges) + g->lanes,
                              at.t, blocks, g->block_count, out);
    return 1;
}
