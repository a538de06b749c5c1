/* SPDX-License-Identifier: MIT */
/* Writes the keys and ranges of lanes (clip_layout.h) into the words of a block. */
#ifndef NAKAWARI_CLIP_KEYS_H
#define NAKAWARI_CLIP_KEYS_H

#include <nakawari/clip.h>

#include "clip_layout.h"

static inline float *clip_floats_at(uint32_t *words, size_t at)
{
    return (float *)(void *)(words + at);
}

/* A component of the sample of the track at key k. */
float nkwi_clip_value_component(const nkw_clip_track *c, size_t k, size_t component);

/*
 * The index of row `row` of a lane, in a key or value with `rows` rows (clip_layout.h):
 *
 *     rows * (lanes of the blocks before) + row * (width of its block) + (lane in its block)
 */
size_t nkwi_clip_lane_at(const clip_group *g, size_t rows, size_t row, size_t lane);

/* Writes one component of a track to row `row` of its lane in every key. */
void nkwi_clip_fill_component(uint32_t *words, const clip_group *g, const nkw_clip_track *c, size_t component,
                              size_t row, size_t lane);

/*
 * Writes the ranges and keys of all rows of a lane. Rotations are stored with w >= 0, so that their numbers are in
 * -1..1. If it makes the widest range narrower, they are stored with w >= -1/2 instead.
 */
void nkwi_clip_fill_compact(uint32_t *words, const clip_group *g, const nkw_clip_track *c, size_t component,
                            size_t lane);

/*
 * The triples of the keys k and k + 1 of the track of a CUBICSPLINE group that begins at a place: 2 * 3 * width floats.
 * Returns 0 if a part of the track is missing.
 */
int nkwi_clip_cubic_keys(const nkw_clip *clip, const clip_group *g, uint32_t place, size_t k, float values[24]);

/* Writes the arcs of all keys of a group of LINEAR rotations; the last key has none. */
void nkwi_clip_fill_arcs(uint32_t *words, const clip_group *g, size_t key_count);

#endif
