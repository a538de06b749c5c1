/* SPDX-License-Identifier: MIT */
/*
 * A clip's block: 32-bit words throughout. Offsets are in words from the beginning of the block.
 *
 *     head | timelines | groups | runs | times | constants | key blocks
 *
 * A group holds the tracks of one timeline that are sampled alike. Its lanes are single numbers, or joints where it turns:
 *
 *     GROUP_NUMBERS, GROUP_FLOATS   key = numbers[lanes]                         (into the pose; into the floats)
 *     GROUP_ROTATIONS               key = x[lanes] y[lanes] z[lanes] w[lanes]
 *                                   and for LINEAR the arc to the next key:  v[lanes] h0[lanes] h1[lanes] h2[lanes] h3[lanes]
 *     CUBICSPLINE                   in-tangents, values and out-tangents, each as above
 */
#ifndef NAKAWARI_CLIP_LAYOUT_H
#define NAKAWARI_CLIP_LAYOUT_H

#include <stdint.h>

#include <nakawari/clip.h>

#include "batch/run.h"

#define CLIP_MAGIC   0x70696c63u /* "clip", lowest byte first */
#define CLIP_VERSION 1u
#define CLIP_ALIGN   16u /* words: key blocks and constants begin on 64 bytes of the block */

struct nkw_clip {
    uint32_t magic, version, words;
    uint32_t joints, floats;
    float start, end;
    uint32_t timelines, timeline_count;
    uint32_t groups, group_count;
    uint32_t constants, constant_runs, constant_run_count; /* pose values that never change */
    uint32_t float_constants, float_runs, float_run_count; /* and floats */
};

typedef struct clip_timeline {
    uint32_t times, count;
    uint32_t modes; /* count words, an nkw_interpolation for each segment; 0: that of the group */
    float rate; /* keys per second of an evenly spaced timeline, else 0 */
} clip_timeline;

typedef enum clip_kind { GROUP_NUMBERS, GROUP_ROTATIONS, GROUP_FLOATS, GROUP_KINDS } clip_kind;

typedef struct clip_group {
    uint32_t timeline, kind, interpolation;
    uint32_t normalized; /* CUBICSPLINE rotations are unit at keys too */
    uint32_t lanes; /* from one component of a key to the next */
    uint32_t runs, run_count;
    uint32_t keys, key_words;
} clip_group;

static inline const uint32_t *clip_words(const nkw_clip *clip)
{
    return (const uint32_t *)(const void *)clip;
}

static inline const clip_timeline *clip_timelines(const nkw_clip *clip)
{
    return (const clip_timeline *)(const void *)(clip_words(clip) + clip->timelines);
}

static inline const clip_group *clip_groups(const nkw_clip *clip)
{
    return (const clip_group *)(const void *)(clip_words(clip) + clip->groups);
}

static inline const nkw_run *clip_runs(const nkw_clip *clip, uint32_t offset)
{
    return (const nkw_run *)(const void *)(clip_words(clip) + offset);
}

static inline const float *clip_floats(const nkw_clip *clip, uint32_t offset)
{
    return (const float *)(const void *)(clip_words(clip) + offset);
}

/* The words of a value (all lanes, all components) of a group, and of a key of it. */
static inline uint32_t clip_value_words(const clip_group *g)
{
    return g->lanes * (g->kind == GROUP_ROTATIONS ? 4u : 1u);
}

static inline uint32_t clip_key_words(const clip_group *g)
{
    uint32_t arc = g->kind == GROUP_ROTATIONS && g->interpolation == NKW_INTERPOLATION_LINEAR ? 5u * g->lanes : 0u;
    return clip_value_words(g) * (g->interpolation == NKW_INTERPOLATION_CUBICSPLINE ? 3u : 1u) + arc;
}

#endif
