/* SPDX-License-Identifier: MIT */
/*
 * What is kept of two neighbouring compact keys between samples.
 *
 *     section      element     number
 *     cursors      uint32_t    1 of each timeline
 *     segments     uint32_t    1 of each group: k + 1 of the segment k from which `kept` was computed, or 0
 *     kept         float       clip_kept_floats of each group, from a multiple of CLIP_ALIGN words on
 *
 * Of float keys nothing is kept: their arcs are stored, and differences alone save no time.
 */
#ifndef NAKAWARI_CLIP_CACHE_H
#define NAKAWARI_CLIP_CACHE_H

#include "clip_layout.h"

/* The floats kept of a group, a multiple of CLIP_ALIGN; 0 if it is sampled without. */
static inline size_t clip_kept_floats(const clip_group *g)
{
    size_t floats = (size_t)g->lanes * (g->kind == GROUP_ROTATIONS ? CLIP_KEPT_ROWS : 2);
    return g->ranges ? (floats + CLIP_ALIGN - 1) / CLIP_ALIGN * CLIP_ALIGN : 0;
}

/* The words before the kept floats. */
static inline size_t clip_cache_head(const nkw_clip *clip)
{
    size_t words = (size_t)clip->timeline_count + clip->group_count;
    return (words + CLIP_ALIGN - 1) / CLIP_ALIGN * CLIP_ALIGN;
}

/* The bytes of the whole cache; SIZE_MAX beyond size_t. */
static inline size_t clip_cache_bytes(const nkw_clip *clip)
{
    uint64_t words = clip_cache_head(clip);
    for (uint32_t g = 0; g < clip->group_count; g++)
        words += clip_kept_floats(&clip_groups(clip)[g]);
    return words > SIZE_MAX / 4 ? SIZE_MAX : (size_t)words * 4;
}

/*
 * Samples the group at `at` from what is kept, which is computed first if it is of another segment. Returns 0, and does
 * nothing, where a key is held, except the first of two packed keys.
 */
int nkwi_clip_sample_kept(const nkw_clip *clip, const clip_group *g, nkw_segment at, uint32_t *segment, float *kept,
                          float *out, size_t stride);

#endif
