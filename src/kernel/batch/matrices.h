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

/* `size` matrices side by side. */
static inline void matrices_spread(const nkw_mat4 *m, size_t size, matrices *a)
{
    for (size_t i = 0; i < size; i += 4) {
        const nkw_mat4 *four[4];
        for (size_t k = 0; k < 4; k++)
            four[k] = &m[matrices_index(i + k, size)];
        matrices_put(a, i, four);
    }
    matrices_fill(a, size);
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

static inline nkw_vec3 matrices_column3(const matrices *a, size_t c, size_t i)
{
    nkw_vec3 r = {a->e[3 * c][i], a->e[3 * c + 1][i], a->e[3 * c + 2][i]};
    return r;
}

/*
 * A separate function, so that the loop around it sees no address of a local matrix. Returns whether it is not near.
 */
static inline int matrices_invert_near(const matrices *a, size_t i, matrices *out)
{
    lane_affine_inverse r = lane_inverse_affine(matrices_column3(a, 0, i), matrices_column3(a, 1, i),
                                                matrices_column3(a, 2, i), matrices_column3(a, 3, i));
    const float e[12] = {r.x.x, r.x.y, r.x.z, r.y.x, r.y.y, r.y.z, r.z.x, r.z.y, r.z.z, r.t.x, r.t.y, r.t.z};
    for (size_t k = 0; k < 12; k++)
        out->e[k][i] = e[k];
    out->e[12][i] = 1.0f;
    return !r.is_near;
}

static inline void matrices_invert_any(const matrices *a, size_t i, matrices *out)
{
    nkw_mat4 m = nkw_mat4_identity();
    for (size_t k = 0; k < 12; k++)
        m.m[k / 3 * 4 + k % 3] = a->e[k][i];
    m = lane_inverse_any_model(&m);
    for (size_t k = 0; k < 12; k++)
        out->e[k][i] = m.m[k / 3 * 4 + k % 3];
    out->e[12][i] = m.m[15];
}

/* nkw_mat4_inverse_affine of each, zeros where it is flat. */
static inline void matrices_invert(const matrices *a, matrices *out)
{
    int far = 0;
#pragma omp simd reduction(| : far)
    for (size_t i = 0; i < MATRIX_BLOCK; i++)
        far |= matrices_invert_near(a, i, out);
    for (size_t i = 0; far && i < MATRIX_BLOCK; i++)
        if (matrices_invert_near(a, i, out))
            matrices_invert_any(a, i, out);
}

#endif
