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

#endif
