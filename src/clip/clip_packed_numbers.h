/* SPDX-License-Identifier: MIT */
/*
 * The numbers of the keys of packed groups (clip_packed.h), in binary64: of a rotation the three of lane/compact.h.
 *
 *     survey    which range they have, and whether packed keys can store them     clip_packed_survey.c
 *     fill      rounded to knots and residuals, and written                       clip_packed_fill.c
 *     check     whether what was written is inside its block                      clip_packed_check.c
 */
#ifndef NAKAWARI_CLIP_PACKED_NUMBERS_H
#define NAKAWARI_CLIP_PACKED_NUMBERS_H

#include "lane/strict.h"

#include <nakawari/clip.h>

#include "clip_tracks.h"
#include "lane/compact.h"
#include "lane/slerp.h"
#include "track/track_keys.h"

/* The keys of a lane, in ascending order: the sign that the last rotation was multiplied by. */
typedef struct packed_keys {
    const nkw_clip_track *c;
    size_t component;
    float sign;
    nkw_quat last;
} packed_keys;

static inline nkw_quat packed_rotation(const nkw_clip_track *c, size_t k)
{
    nkw_segment at = {k, 0.0f};
    float v[4];
    nkw_track_sample_segment(&c->track, at, v);
    nkw_quat q = {v[0], v[1], v[2], v[3]};
    return q;
}

/* The rotation of key k, with the sign that makes its dot product with the one before positive, as slerp takes it. */
static inline nkw_quat packed_next_rotation(packed_keys *keys, size_t k)
{
    nkw_quat q = packed_rotation(keys->c, k);
    if (k > 0 && lane_slerp_cosine(keys->last, q) < 0.0f)
        keys->sign = -keys->sign;
    keys->last = q;
    return q;
}

static inline size_t packed_rows_of(const nkw_clip_track *c)
{
    return c->target == NKW_CLIP_ROTATION ? 3 : 1;
}

/* The numbers of key k; call it for k = 0, 1, 2 ... in this order. */
static inline void packed_next_numbers(packed_keys *keys, size_t k, double x[3])
{
    if (keys->c->target != NKW_CLIP_ROTATION) {
        x[0] = (double)track_value_at(&keys->c->track, k)[keys->component];
        return;
    }
    lane_f64_quat q = lane_f64_quat_from(packed_next_rotation(keys, k));
    lane_compact_numbers(lane_f64_quat_scale(q, (double)keys->sign), x);
}

/*
 * The range of each number, and the step. An error e of p rotates by 4 e/(1 + p.p) = 2 (1 + w) e radians: the step of a
 * rotation's numbers is that of its angle, divided by twice 1 + w at the key where it is largest.
 */
typedef struct packed_range {
    packed_extent extent; /* of a number low[0] and high[0] only */
    double step;
} packed_range;

/* The range of component `component` of track c, or of its rotation. track: its index. */
packed_range nkwi_packed_range(const packed_extents *extents, const nkw_clip_track *c, size_t track, size_t component,
                               float step);

/*
 * The largest float of 8 digits that is at most x: the lower 16 bits are 0. No number is below the base, so no knot is
 * negative; no step is longer than the one that was asked for.
 */
float nkwi_packed_base(double x);

#endif
