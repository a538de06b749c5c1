/* SPDX-License-Identifier: MIT */
/*
 * The last joints of a pose, fewer than a loop takes at once, in memory of their own. Nothing computes with what is
 * behind them in the pose: it may be signalling numbers, or memory that was never written.
 */
#ifndef NAKAWARI_BATCH_LAST_H
#define NAKAWARI_BATCH_LAST_H

#include "lane/strict.h"

#include <nakawari/types.h>

#include "batch/isa.h"
#include "lane/scalar.h"

/* The first n of `lanes` numbers, a constant; `other` in the places of the rest. */
NKW_ALWAYS_INLINE void copy_last(const float *x, int lanes, size_t n, float other, float *to)
{
    const int32_t count = (int32_t)n;
#pragma omp simd
    NKW_KEEP_LOOP
    for (int32_t i = 0; i < lanes; i++)
        to[i] = lane_float(i < count ? lane_bits(x[i]) : lane_bits(other));
}

#define LAST_LANES 16

/* n joints, and identities. */
typedef struct last_joints {
    float v[10][LAST_LANES];
} last_joints;

/* Those from joint `from` on. */
NKW_ALWAYS_INLINE nkw_trs_view copy_last_joints(nkw_trs_view v, size_t from, size_t n, last_joints *to)
{
    const float *const rows[10] = {v.translation.x, v.translation.y, v.translation.z, v.rotation.x, v.rotation.y,
                                   v.rotation.z,    v.rotation.w,    v.scale.x,       v.scale.y,    v.scale.z};
    for (size_t c = 0; c < 10; c++)
        copy_last(rows[c] + from, LAST_LANES, n, c < 6 ? 0.0f : 1.0f, to->v[c]);
    const nkw_trs_view r = {{to->v[0], to->v[1], to->v[2]},
                            {to->v[3], to->v[4], to->v[5], to->v[6]},
                            {to->v[7], to->v[8], to->v[9]}};
    return r;
}

NKW_ALWAYS_INLINE nkw_trs_span trs_span_after(nkw_trs_span s, size_t n)
{
    const nkw_trs_span r = {{s.translation.x + n, s.translation.y + n, s.translation.z + n},
                            {s.rotation.x + n, s.rotation.y + n, s.rotation.z + n, s.rotation.w + n},
                            {s.scale.x + n, s.scale.y + n, s.scale.z + n}};
    return r;
}

#endif
