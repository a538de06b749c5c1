/* SPDX-License-Identifier: MIT */
/* Affine matrices in component arrays [element][matrix], a few at a time, for loops over matrices. */
#ifndef NAKAWARI_BATCH_MATRICES_H
#define NAKAWARI_BATCH_MATRICES_H

#include "lane/strict.h"

#include "lane/mat.h"
#include "pack/f32x4.h"
#include "sizes.h"

/* Element r of column c is e[3 c + r]; of the fourth row there is only the end of the last column, e[12]. */
typedef struct matrices {
    float e[13][MATRIX_BLOCK];
} matrices;

/* Index i, clamped to the last of `size` matrices, so that a short block can be processed whole. */
static inline size_t matrices_index(size_t i, size_t size)
{
    return i < size ? i : size - 1;
}

/* Stores m[0..3] as the matrices i .. i + 3. */
static inline void matrices_put(matrices *a, size_t i, const nkw_mat4 *const m[4])
{
    for (size_t c = 0; c < 4; c++) {
        const float *const from[4] = {m[0]->m + 4 * c, m[1]->m + 4 * c, m[2]->m + 4 * c, m[3]->m + 4 * c};
        float *const to[4] = {a->e[3 * c] + i, a->e[3 * c + 1] + i, a->e[3 * c + 2] + i, NULL};
        f32x4_transpose_rows(from, to);
    }
}

/* Fills a short block of `size` with copies of its first four matrices. */
static inline void matrices_fill(matrices *a, size_t size)
{
    for (size_t i = (size + 3) / 4 * 4; i < MATRIX_BLOCK; i += 4)
        for (size_t k = 0; k < 12; k++)
            memcpy(a->e[k] + i, a->e[k], 4 * sizeof(float));
}

/* The elements x, y, z, w of each of the matrices i .. i + 3 to out[0..3], where that is not NULL. */
static inline void matrices_take(const matrices *a, size_t x, size_t y, size_t z, const float *w, size_t i,
                                 float *const out[4])
{
    const float *const from[4] = {a->e[x] + i, a->e[y] + i, a->e[z] + i, w};
    f32x4_transpose_rows(from, out);
}

/* The matrices i .. i + 3, of which out has `size`. */
static inline void matrices_write(const matrices *a, size_t i, nkw_mat4 *out, size_t size)
{
    static const float zeros[4] = {0.0f};
    for (size_t c = 0; c < 4; c++) {
        float *const to[4] = {out[0].m + 4 * c, size > 1 ? out[1].m + 4 * c : NULL, size > 2 ? out[2].m + 4 * c : NULL,
                              size > 3 ? out[3].m + 4 * c : NULL};
        matrices_take(a, 3 * c, 3 * c + 1, 3 * c + 2, c < 3 ? zeros : a->e[12] + i, i, to);
    }
}

static inline lane_f64_vec3 matrices_column(const matrices *a, size_t c, size_t i)
{
    lane_f64_vec3 r = {a->e[3 * c][i], a->e[3 * c + 1][i], a->e[3 * c + 2][i]};
    return r;
}

/* The 3x3 block. */
static inline lane_f64_mat3 matrices_linear(const matrices *a, size_t i)
{
    lane_f64_mat3 r;
    for (size_t k = 0; k < 9; k++)
        r.m[k] = a->e[k][i];
    return r;
}

/* nkw_mat4_inverse_affine of number i. */
static inline void matrices_invert(const matrices *a, size_t i, matrices *out)
{
    lane_f64_mat3 linear = matrices_linear(a, i), cofactors = lane_f64_mat3_cofactors(&linear);
    double r = lane_reciprocal_or_zero(lane_f64_mat3_determinant(&linear, &cofactors));
    lane_f64_vec3 t = matrices_column(a, 3, i);
    for (size_t k = 0; k < 9; k++)
        out->e[k][i] = r == 0.0 ? 0.0f : (float)(cofactors.m[k % 3 * 3 + k / 3] * r);
    for (size_t k = 0; k < 3; k++)
        out->e[9 + k][i] = r == 0.0 ? 0.0f : (float)(-lane_f64_vec3_dot(lane_f64_mat3_column(&cofactors, k), t) * r);
    out->e[12][i] = r == 0.0 ? 0.0f : 1.0f;
}

#endif
