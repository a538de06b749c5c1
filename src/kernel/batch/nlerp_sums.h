/* SPDX-License-Identifier: MIT */
/* The sums of nlerp, a block at a time, and their normalisation. */
#ifndef NAKAWARI_BATCH_NLERP_SUMS_H
#define NAKAWARI_BATCH_NLERP_SUMS_H

#include "lane/strict.h"

#include "batch/element.h"
#include "batch/isa.h"
#include "lane/nlerp.h"
#include "sizes.h"

/* The sums of a block, and their lengths; 1 where the sum is the result as it is. */
typedef struct nlerp_sums {
    float x[ORIENT_BLOCK], y[ORIENT_BLOCK], z[ORIENT_BLOCK], w[ORIENT_BLOCK], length[ORIENT_BLOCK];
} nlerp_sums;

/* Element i; `far`, an int, becomes 1 where the squared length is not moderate. */
#define put_nlerp(s, i, sum, far)                                                                                      \
    do {                                                                                                               \
        const lane_nlerp put_sum = sum;                                                                                \
        put_quat(s, i, put_sum.v);                                                                                     \
        (s).length[i] = nkw_sqrt(put_sum.n2);                                                                          \
        (far) |= !nkw_is_moderate(put_sum.n2);                                                                         \
    } while (0)

/* Divides n sums by their lengths. out must not alias them. */
NKW_ALWAYS_INLINE void normalize_sums(nkw_quat_view v, const float *length, int far, nkw_quat_span out, size_t n)
{
    if (far) {
#pragma omp simd
        for (size_t i = 0; i < n; i++)
            put_quat(out, i, lane_nlerp_any(at_quat(v, i), length[i]));
        return;
    }
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_quat(out, i, nkw_quat_over(at_quat(v, i), length[i]));
}

NKW_ALWAYS_INLINE void normalize_block_sums(const nlerp_sums *s, int far, nkw_quat_span out, size_t n)
{
    const nkw_quat_view v = {s->x, s->y, s->z, s->w};
    normalize_sums(v, s->length, far, out, n);
}

#endif
