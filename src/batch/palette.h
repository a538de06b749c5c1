/* SPDX-License-Identifier: MIT */
/* The loops of palette.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_PALETTE_H
#define NAKAWARI_BATCH_PALETTE_H

#include <stdint.h>

#include <nakawari/types.h>

#include "batch/isa.h"

/* clang-format off */
#define NKW_LOOPS_PALETTE(X) \
    X(nkwi_palette_4x4, (const nkw_mat4 *models, size_t model_count, const int32_t *joints, const nkw_mat4 *inverse_bind, const nkw_mat4 *global_inverse, nkw_mat4 *out, size_t n), (models, model_count, joints, inverse_bind, global_inverse, out, n), NKW_WIDEST) \
    X(nkwi_palette_3x4, (const nkw_mat4 *models, size_t model_count, const int32_t *joints, const nkw_mat4 *inverse_bind, const nkw_mat4 *global_inverse, nkw_mat3x4 *out, size_t n), (models, model_count, joints, inverse_bind, global_inverse, out, n), NKW_WIDEST) \
    X(nkwi_palette_dual, (const nkw_mat4 *models, size_t model_count, const int32_t *joints, const nkw_mat4 *inverse_bind, const nkw_mat4 *global_inverse, nkw_dual_quat *out, size_t n), (models, model_count, joints, inverse_bind, global_inverse, out, n), NKW_WIDEST) \
    X(nkwi_palette_inverse, (const nkw_mat4 *models, size_t model_count, const int32_t *joints, const nkw_mat4 *global_inverse, nkw_mat4 *out, size_t n), (models, model_count, joints, global_inverse, out, n), NKW_WIDEST) \
    X(nkwi_palette_normals, (const nkw_mat4 *palette, size_t line, int rows, float *out, size_t n), (palette, line, rows, out, n), NKW_WIDEST)
/* clang-format on */

NKW_LOOPS_PALETTE(NKW_DECLARE)

#endif
