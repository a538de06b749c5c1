/* SPDX-License-Identifier: MIT */
/* The loops of skin.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_SKIN_H
#define NAKAWARI_BATCH_SKIN_H

#include "batch/isa.h"
#include "lane/skin.h"

/* clang-format off */
#define NKW_LOOPS_SKIN(X) \
    X(nkwi_skin_decode, (skin_block *b, const nkw_skin_view *joints, uint32_t limit, const nkw_skin_view *weights, size_t k, size_t n), (b, joints, limit, weights, k, n), n) \
    X(nkwi_skin_blend, (skin_block *b, const nkw_mat4 *palette, size_t k, size_t n), (b, palette, k, n), n) \
    X(nkwi_skin_blend_normals, (skin_block *b, const nkw_mat3 *palette, size_t k, size_t n), (b, palette, k, n), n) \
    X(nkwi_skin_blend_dual_quats, (skin_block *b, const nkw_dual_quat *palette, size_t k, size_t n), (b, palette, k, n), n) \
    X(nkwi_skin_pairs, (const skin_influences *f, const nkw_mat4 *palette, const skin_stream *p, const skin_stream *d, int raw, size_t more, size_t n), (f, palette, p, d, raw, more, n), n) \
    X(nkwi_skin_points, (const skin_block *b, nkw_vec3_view in, nkw_vec3_span out, size_t n), (b, in, out, n), n) \
    X(nkwi_skin_directions, (const skin_block *b, const float *m, int raw, nkw_vec3_view in, nkw_vec3_span out, size_t n), (b, m, raw, in, out, n), n) \
    X(nkwi_skin_read, (const unsigned char *data, size_t stride, float *out, size_t n), (data, stride, out, n), n) \
    X(nkwi_skin_write, (const float *in, unsigned char *data, size_t stride, size_t n), (in, data, stride, n), n)
/* clang-format on */

NKW_LOOPS_SKIN(NKW_DECLARE)

#endif
