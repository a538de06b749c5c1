/* SPDX-License-Identifier: MIT */
/* Chords between rotations, many at once, and how they are brought to length 1. */
#ifndef NAKAWARI_BATCH_CHORDS_H
#define NAKAWARI_BATCH_CHORDS_H

#include "lane/strict.h"

#include "batch/element.h"
#include "batch/isa.h"
#include "lane/orient.h"

/*
 * Chords made unit where mixed is not 0; as they are elsewhere. out is not v: if one of the first `used` was not inside
 * after all, all are done again.
 */
INLINE void settle_where(const float *mixed, nkw_quat_view v, int used, nkw_quat_span out, int n)
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

/* Chords and their ways back, as lane_quat_chord gives them. */
#define CHORDS 256

typedef struct chords {
    float x[CHORDS], y[CHORDS], z[CHORDS], w[CHORDS], back[CHORDS];
} chords;

#define put_chord(c, i, chord) store_chord((c).x, (c).y, (c).z, (c).w, (c).back, i, chord)

static inline void store_chord(float *x, float *y, float *z, float *w, float *back, size_t i, lane_chord c)
{
    store_quat(x, y, z, w, i, c.v);
    back[i] = c.back;
}

/* n nlerps from their chords; as settle_where. */
INLINE void settle_chords(const chords *c, int used, nkw_quat_span out, int n)
{
    const nkw_quat_view v = {c->x, c->y, c->z, c->w};
    settle_where(c->back, v, used, out, n);
}

#endif
