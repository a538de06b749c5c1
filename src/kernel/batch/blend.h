/* SPDX-License-Identifier: MIT */
/* The loops of blend.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_BLEND_H
#define NAKAWARI_BATCH_BLEND_H

#include <nakawari/types.h>

#include "batch/isa.h"
#include "batch/rows.h"

/* clang-format off */
#define NKW_LOOPS_BLEND(X) \
    X(nkwi_blend_sum, (blend_rows a, blend_rows b, float t, int used, blend_span out), (a, b, t, used, out), NKW_WIDEST) \
    X(nkwi_blend_poses, (const float *a, const float *b, size_t stride, float t, int used, float *out), (a, b, stride, t, used, out), NKW_WIDEST) \
    X(nkwi_blend_nlerp, (blend_rows a, blend_rows b, float t, int used, blend_span out), (a, b, t, used, out), NKW_WIDEST) \
    X(nkwi_blend_weigh, (float weight, const float *mask, int used, float *out, int n), (weight, mask, used, out, n), NKW_WIDEST) \
    X(nkwi_blend_each, (blend_rows a, blend_rows b, const float *t, const float *open, int used, blend_span out), (a, b, t, open, used, out), NKW_WIDEST) \
    X(nkwi_blend_mix, (blend_rows a, blend_rows b, const float *t, float *mixed, int used, blend_span out), (a, b, t, mixed, used, out), NKW_WIDEST) \
    X(nkwi_blend_far, (const float *const *poses, size_t count, size_t stride, size_t from, int used, int *far), (poses, count, stride, from, used, far), NKW_WIDEST) \
    X(nkwi_blend_disagree, (blend_rows first, blend_rows a, blend_rows b, int used, float *marks, int *any), (first, a, b, used, marks, any), NKW_WIDEST) \
    X(nkwi_blend_missing, (const double *total, float threshold, float *out, int *any, int n), (total, threshold, out, any, n), NKW_WIDEST) \
    X(nkwi_blend_share, (const float *weight, double *total, float *t, size_t n), (weight, total, t, n), NKW_WIDEST) \
    X(nkwi_additive_build, (nkw_trs_view a, nkw_trs_view ref, int parent, nkw_trs_span out, size_t n), (a, ref, parent, out, n), NKW_WIDEST) \
    X(nkwi_additive_apply, (nkw_trs_view base, nkw_trs_view delta, const float *weight, int parent, nkw_trs_span out, size_t n), (base, delta, weight, parent, out, n), NKW_WIDEST)
/* clang-format on */

NKW_LOOPS_BLEND(NKW_DECLARE)

#endif
