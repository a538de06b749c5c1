/* SPDX-License-Identifier: MIT */
/* The loops of skeleton.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_SKELETON_H
#define NAKAWARI_BATCH_SKELETON_H

#include <stdint.h>

#include <nakawari/types.h>

#include "batch/isa.h"

/* clang-format off */
#define NKW_LOOPS_SKELETON(X) \
    X(nkwi_models_from_pose, (const int32_t *parents, const float *pose, size_t stride, const nkw_mat4 *root, size_t from, size_t to, nkw_mat4 *models), (parents, pose, stride, root, from, to, models), NKW_WIDEST) \
    X(nkwi_models_from_records, (const int32_t *parents, const nkw_trs *records, const nkw_mat4 *root, size_t from, size_t to, nkw_mat4 *models), (parents, records, root, from, to, models), NKW_WIDEST) \
    X(nkwi_models_from_locals, (const int32_t *parents, const nkw_mat4 *locals, const nkw_mat4 *root, size_t from, size_t to, nkw_mat4 *models), (parents, locals, root, from, to, models), NKW_WIDEST) \
    X(nkwi_locals_from_models, (const int32_t *parents, const nkw_mat4 *models, const nkw_mat4 *root, size_t from, size_t to, nkw_mat4 *locals), (parents, models, root, from, to, locals), NKW_WIDEST) \
    X(nkwi_pose_from_locals, (const nkw_mat4 *m, float *out, size_t stride, int *far, size_t n), (m, out, stride, far, n), n)
/* clang-format on */

NKW_LOOPS_SKELETON(NKW_DECLARE)

#endif
