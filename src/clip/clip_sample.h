/* SPDX-License-Identifier: MIT */
/* A sample of one group of a clip. */
#ifndef NAKAWARI_CLIP_SAMPLE_H
#define NAKAWARI_CLIP_SAMPLE_H

#include <nakawari/clip.h>

#include "clip_layout.h"

/*
 * Writes the values of the group at a segment of its timeline.
 *
 * out     the pose, its rotations (from array 3 on) or the floats, by the kind of the group
 * stride  the distance of the component arrays of rotations, in floats
 */
void nkwi_clip_sample_group(const nkw_clip *clip, const clip_group *g, const clip_timeline *line, nkw_segment at,
                            float *out, size_t stride);

/* The same of one block of a group that is not packed. */
void nkwi_clip_sample_block(const nkw_clip *clip, const clip_group *g, const clip_timeline *line, nkw_segment at,
                            size_t block, float *out, size_t stride);

/* The same of one block of any group, lane i to out[i], component r of a rotation to out[CLIP_BLOCK * r + i]. */
void nkwi_clip_sample_lanes(const nkw_clip *clip, const clip_group *g, const clip_timeline *line, nkw_segment at,
                            size_t block, float out[4 * CLIP_BLOCK]);

/* Copies `count` runs at `at`, the constants, to a pose or to floats. */
void nkwi_clip_copy_runs(const nkw_clip *clip, uint32_t at, uint32_t count, float *out);

/* The segment of the time on a timeline; cursor may be NULL. */
nkw_segment nkwi_clip_find(const nkw_clip *clip, const clip_timeline *line, float time, uint32_t *cursor);

#endif
