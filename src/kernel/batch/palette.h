/* SPDX-License-Identifier: MIT */
/* The loops of palette.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_PALETTE_H
#define NAKAWARI_BATCH_PALETTE_H

#include <nakawari/palette.h>

#include "batch/isa.h"

/* clang-format off */
#define NKW_LOOPS_PALETTE(X) \
    X(nkwi_palette_4x4, (const nkw_palette_source *source, nkw_mat4 *out), (source, out), NKW_WIDEST) \
    X(nkwi_palette_3x4, (const nkw_palette_source *source, nkw_mat3x4 *out), (source, out), NKW_WIDEST) \
    X(nkwi_palette_dual, (const nkw_palette_source *source, nkw_dual_quat *out), (source, out), NKW_WIDEST) \
    X(nkwi_palette_inverse, (const nkw_palette_source *source, nkw_mat4 *out), (source, out), NKW_WIDEST) \
    X(nkwi_palette_normals, (const nkw_palette_source *source, size_t line, int rows, float *out), (source, line, rows, out), NKW_WIDEST)
/* clang-format on */

NKW_LOOPS_PALETTE(NKW_DECLARE)

#endif
