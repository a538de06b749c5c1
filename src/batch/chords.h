/* SPDX-License-Identifier: MIT */
/* Chords between rotations, a block at a time, and their normalization. */
#ifndef NAKAWARI_BATCH_CHORDS_H
#define NAKAWARI_BATCH_CHORDS_H

#include "lane/strict.h"

#include "batch/element.h"
#include "batch/isa.h"
#include "lane/orient.h"
#include "sizes.h"

/*
 * Normalizes the chord i where mixed[i] is not 0, and copies the others. out must not alias v: if one of the first
 * `used` chords is not of 0 < |v|^2 < 2, the block is computed again by the general formula.
 */
NKW_ALWAYS_INLINE void normalize_where(const float *mixed, nkw_quat_view v, int used, nkw_quat_span out, int n)
{
    int outside = 0;
#pragma omp simd reduction(| : outside)
    for (int i = 0; i < n; i++) {
        nkw_quat q = at_quat(v, (size_t)i);
        float m = nkw_quat_unit_error(q);
        outside |= !(lane_abs(m) < 1.0f) & (i < used);
        put_quat(out, (size_t)i, lane_quat_select(mixed[i] == 0.0f, q, lane_chord_normalize_short(q, m)));
    }
    if (!outside)
        return;
#pragma omp simd
    for (int i = 0; i < n; i++) {
        nkw_quat q = at_quat(v, (size_t)i);
        put_quat(out, (size_t)i, lane_quat_select(mixed[i] == 0.0f, q, lane_chord_normalize(q)));
    }
}

/* The results of lane_quat_chord. */
typedef struct chords {
    float x[ORIENT_BLOCK], y[ORIENT_BLOCK], z[ORIENT_BLOCK], w[ORIENT_BLOCK], back[ORIENT_BLOCK];
} chords;

#define put_chord(c, i, chord) store_chord((c).x, (c).y, (c).z, (c).w, (c).back, i, chord)

static inline void store_chord(float *x, float *y, float *z, float *w, float *back, size_t i, lane_chord c)
{
    store_quat(x, y, z, w, i, c.v);
    back[i] = c.back;
}

/* Normalizes n chords to nlerps; see normalize_where. */
NKW_ALWAYS_INLINE void normalize_blended(const chords *c, int used, nkw_quat_span out, int n)
{
    const nkw_quat_view v = {c->x, c->y, c->z, c->w};
    normalize_where(c->back, v, used, out, n);
}

#endif
