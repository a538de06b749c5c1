/* SPDX-License-Identifier: MIT */
/* Affine matrices side by side: a few at a time in component arrays [element][matrix], for loops over matrices. */
#ifndef NAKAWARI_BATCH_MATRICES_H
#define NAKAWARI_BATCH_MATRICES_H

#include "lane/strict.h"

#include "lane/affine.h"
#include "lane/fours.h"
#include "lane/mat.h"

/* Matrices together: one register of the widest, for floats. */
#define MATRICES 16

/* Element r of column c is e[3 c + r]; of the fourth row there is only the end of the last column, e[12]. */
typedef struct matrices {
    float e[13][MATRICES];
} matrices;

/* What stands for matrix i of `size`: beyond them the last. */
static inline size_t matrices_index(size_t i, size_t size)
{
    return i < size ? i : size - 1;
}

#if LANE_FOURS == 4
/* Four matrices become number i and those after it. */
static inline void matrices_put(matrices *a, size_t i, const nkw_mat4 *const m[4])
{
    lane_wide rows[4];
    for (size_t k = 0; k < 4; k++)
        rows[k] = lane_wide_load(m[k]->m);
    lane_wide_transpose(rows);
    for (size_t k = 0; k < 3; k++) {
        lane_four_store(a->e[k] + i, LANE_MIX(rows[k], rows[k], 0, 1, 2, 3));
        lane_four_store(a->e[3 + k] + i, LANE_MIX(rows[k], rows[k], 4, 5, 6, 7));
        lane_four_store(a->e[6 + k] + i, LANE_MIX(rows[k], rows[k], 8, 9, 10, 11));
        lane_four_store(a->e[9 + k] + i, LANE_MIX(rows[k], rows[k], 12, 13, 14, 15));
    }
}
#else
/* Four matrices become number i and those after it. */
static inline void matrices_put(matrices *a, size_t i, const nkw_mat4 *const m[4])
{
    for (size_t c = 0; c < 4; c++) {
        lane_four rows[4];
        for (size_t k = 0; k < 4; k++)
            rows[k] = lane_four_load(m[k]->m + 4 * c);
        lane_four_transpose(rows);
        for (size_t r = 0; r < 3; r++)
            lane_four_store(a->e[3 * c + r] + i, rows[r]);
    }
}
#endif

/* A short block of `size` repeats its first four. */
static inline void matrices_fill(matrices *a, size_t size)
{
    for (size_t i = (size + 3) / 4 * 4; i < MATRICES; i += 4)
        for (size_t k = 0; k < 12; k++)
            lane_four_store(a->e[k] + i, lane_four_load(a->e[k]));
}

/* Elements x y z of the matrices i .. i + 3, and a fourth, side by side. */
static inline void matrices_turn(const matrices *a, size_t x, size_t y, size_t z, lane_four w, size_t i,
                                 lane_four out[4])
{
    out[0] = lane_four_load(a->e[x] + i);
    out[1] = lane_four_load(a->e[y] + i);
    out[2] = lane_four_load(a->e[z] + i);
    out[3] = w;
    lane_four_transpose(out);
}

/* The columns of the matrices i .. i + 3. */
static inline void matrices_take(const matrices *a, size_t i, lane_columns m[4])
{
    for (size_t c = 0; c < 4; c++) {
        lane_four w = c == 3 ? lane_four_load(a->e[12] + i) : lane_four_all(0.0f), columns[4];
        matrices_turn(a, 3 * c, 3 * c + 1, 3 * c + 2, w, i, columns);
        for (size_t k = 0; k < 4; k++)
            m[k].c[c] = columns[k];
    }
}

/* The matrices i .. i + 3, of which out has `size`. */
static inline void matrices_write(const matrices *a, size_t i, nkw_mat4 *out, size_t size)
{
    lane_columns m[4];
    matrices_take(a, i, m);
    for (size_t k = 0; k < 4 && k < size; k++)
        for (size_t c = 0; c < 4; c++)
            lane_four_store(out[k].m + 4 * c, m[k].c[c]);
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
