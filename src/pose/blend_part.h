/* SPDX-License-Identifier: MIT */
/* A part of a pose, as the loops of blend.c take it, and the weights of its joints. */
#ifndef NAKAWARI_POSE_BLEND_PART_H
#define NAKAWARI_POSE_BLEND_PART_H

#include "lane/strict.h"

#include <nakawari/blend.h>

#include "batch/blend.h"
#include "lane/blend.h"
#include "sizes.h"

/* Weights count as this at most, so that the sum of all is finite. */
#define BLEND_MOST_WEIGHT 0x1p60f

/* `n` lanes of poses from joint `from` on, the first `used` of them joints; `stride` of the whole pose. */
typedef struct part {
    size_t joints, stride, from, used, n;
} part;

static inline size_t at_most(size_t n, size_t most)
{
    return n < most ? n : most;
}

static inline part part_at(size_t joints, size_t from)
{
    size_t stride = NKW_POSE_STRIDE(joints);
    part p = {joints, stride, from, at_most(joints - from, BLEND_BLOCK), at_most(stride - from, BLEND_BLOCK)};
    return p;
}

static inline nkw_trs_view view_of(const float *pose, const part *p)
{
    nkw_pose_view view = {pose + p->from, p->joints};
    return nkw_pose_components(view);
}

static inline nkw_trs_span span_of(float *pose, const part *p)
{
    nkw_pose_span span = {pose + p->from, p->joints};
    return nkw_pose_components_span(span);
}

static inline blend_rows rows_of(const float *pose, const part *p)
{
    blend_rows r = {pose + p->from, p->stride};
    return r;
}

static inline blend_span rows_span(float *pose, const part *p)
{
    blend_span r = {pose + p->from, p->stride};
    return r;
}

static inline float weight_of(float weight)
{
    float w = weight > 0.0f ? weight : 0.0f;
    return w < BLEND_MOST_WEIGHT ? w : BLEND_MOST_WEIGHT;
}

/* The joints' own weights: weight * mask. */
static inline void weigh(float weight, const float *mask, const part *p, float *out)
{
    if (mask)
        nkwi_blend_weigh(weight, mask + p->from, (int)p->used, out, (int)p->n);
    else
        for (size_t i = 0; i < p->n; i++)
            out[i] = weight;
}

/* A mask without data fits every pose. */
static inline int fits(nkw_mask_view mask, size_t joint_count)
{
    return !mask.data || mask.joint_count == joint_count;
}

/* Whether all layers are of so many joints. */
static inline int all_fit(const nkw_pose_layer *layers, size_t count, size_t joint_count)
{
    int fit = 1;
    for (size_t i = 0; joint_count > 0 && i < count; i++)
        fit = fit && layers[i].pose.joint_count == joint_count && fits(layers[i].mask, joint_count);
    return fit;
}

#endif
