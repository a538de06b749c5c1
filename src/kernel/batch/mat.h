/* SPDX-License-Identifier: MIT */
/* The loops of mat.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_MAT_H
#define NAKAWARI_BATCH_MAT_H

#include <nakawari/types.h>

#include "batch/isa.h"

/* clang-format off */
#define NKW_LOOPS_MAT(X) \
    X(nkw_mat4_mul_affine_n, (nkw_mat4_view a, nkw_mat4_view b, nkw_mat4_span out, size_t n), (a, b, out, n), n) \
    X(nkw_mat4_transform_point_n, (const nkw_mat4 *m, nkw_vec3_view p, nkw_vec3_span out, size_t n), (m, p, out, n), n) \
    X(nkw_mat4_transform_direction_n, (const nkw_mat4 *m, nkw_vec3_view d, nkw_vec3_span out, size_t n), (m, d, out, n), n) \
    X(nkw_mat4_unpack_n, (const nkw_mat4 *in, nkw_mat4_span out, size_t n), (in, out, n), n) \
    X(nkw_mat4_pack_n, (nkw_mat4_view in, nkw_mat4 *out, size_t n), (in, out, n), n)
/* clang-format on */

NKW_LOOPS_MAT(NKW_DECLARE)

#endif
