/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/palette.h>

#include "batch/element.h"
#include "batch/table.h"
#include "lane/dual.h"
#include "lane/mat.h"
#include "lane/palette.h"

/* The model of joint i of the skin, NULL where there is none. A negative number is beyond every count. */
static inline const nkw_mat4 *model_of(const nkw_mat4 *models, size_t model_count, const int32_t *joints, size_t i)
{
    size_t j = joints ? (size_t)joints[i] : i;
    return j < model_count ? models + j : NULL;
}

/* Joint matrix i, columns. */
static inline lane_columns columns_of(const nkw_mat4 *models, size_t model_count, const int32_t *joints,
                                      const nkw_mat4 *inverse_bind, const lane_columns *global_inverse, size_t i)
{
    static const nkw_mat4 identity = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
    const nkw_mat4 *model = model_of(models, model_count, joints, i);
    if (!model)
        return lane_columns_from(&identity);
    return lane_joint_columns(global_inverse, model, inverse_bind ? inverse_bind + i : NULL);
}

/* The columns of *m; anything where there is none. */
static inline lane_columns columns_or_none(const nkw_mat4 *m)
{
    static const nkw_mat4 none = {{0}};
    return lane_columns_from(m ? m : &none);
}

KERNEL(palette_4x4)
(const nkw_mat4 *models, size_t model_count, const int32_t *joints, const nkw_mat4 *inverse_bind,
 const nkw_mat4 *global_inverse, nkw_mat4 *out, size_t n)
{
    const lane_columns g = columns_or_none(global_inverse);
    for (size_t i = 0; i < n; i++) {
        lane_columns m = columns_of(models, model_count, joints, inverse_bind, global_inverse ? &g : NULL, i);
        lane_mat4_from_columns(&m, &out[i]);
    }
}

KERNEL(palette_3x4)
(const nkw_mat4 *models, size_t model_count, const int32_t *joints, const nkw_mat4 *inverse_bind,
 const nkw_mat4 *global_inverse, nkw_mat3x4 *out, size_t n)
{
    const lane_columns g = columns_or_none(global_inverse);
    for (size_t i = 0; i < n; i++) {
        lane_columns m = columns_of(models, model_count, joints, inverse_bind, global_inverse ? &g : NULL, i);
        lane_mat3x4_from_columns(&m, &out[i]);
    }
}

/*
 * Matrices that are worked on together, in component arrays [element][matrix]. The elements that a short block lacks
 * are those of an earlier one, or 0.
 */
#define BLOCK 16

static inline void unpack_one(const nkw_mat4 *m, float a[16][BLOCK], size_t i)
{
    for (size_t k = 0; k < 16; k++)
        a[k][i] = m->m[k];
}

/* Functions of their own, so that the loops around them see no address of a local matrix. */
static inline void normal_one(float a[16][BLOCK], float r[9][BLOCK], size_t i)
{
    nkw_mat3 m = {{a[0][i], a[1][i], a[2][i], a[4][i], a[5][i], a[6][i], a[8][i], a[9][i], a[10][i]}};
    nkw_mat3 normal = lane_mat3_normal(&m);
    for (size_t k = 0; k < 9; k++)
        r[k][i] = normal.m[k];
}

static inline void dual_one(float a[16][BLOCK], float r[8][BLOCK], size_t i)
{
    lane_wmat3 linear = {{a[0][i], a[1][i], a[2][i], a[4][i], a[5][i], a[6][i], a[8][i], a[9][i], a[10][i]}};
    lane_wvec3 translation = {a[12][i], a[13][i], a[14][i]};
    nkw_dual_quat d = lane_dual_quat_from_affine(&linear, translation);
    r[0][i] = d.real.x, r[1][i] = d.real.y, r[2][i] = d.real.z, r[3][i] = d.real.w;
    r[4][i] = d.dual.x, r[5][i] = d.dual.y, r[6][i] = d.dual.z, r[7][i] = d.dual.w;
}

KERNEL(palette_dual)
(const nkw_mat4 *models, size_t model_count, const int32_t *joints, const nkw_mat4 *inverse_bind,
 const nkw_mat4 *global_inverse, nkw_dual_quat *out, size_t n)
{
    const lane_columns g = columns_or_none(global_inverse);
    float a[16][BLOCK] = {{0}}, r[8][BLOCK];
    for (size_t from = 0; from < n; from += BLOCK) {
        size_t size = n - from < BLOCK ? n - from : BLOCK;
        for (size_t i = 0; i < size; i++) {
            nkw_mat4 m;
            lane_columns c =
                columns_of(models, model_count, joints, inverse_bind, global_inverse ? &g : NULL, from + i);
            lane_mat4_from_columns(&c, &m);
            unpack_one(&m, a, i);
        }
#pragma omp simd
        for (size_t i = 0; i < BLOCK; i++)
            dual_one(a, r, i);
        for (size_t i = 0; i < size; i++) {
            nkw_dual_quat d = {{r[0][i], r[1][i], r[2][i], r[3][i]}, {r[4][i], r[5][i], r[6][i], r[7][i]}};
            out[from + i] = d;
        }
    }
}

/* Element (r, c) of each goes to out[r * row + c * column]; `size` floats a matrix, those between are 0. */
KERNEL(palette_normals)(const nkw_mat4 *palette, size_t size, size_t row, size_t column, float *out, size_t n)
{
    float a[16][BLOCK] = {{0}}, r[9][BLOCK];
    for (size_t from = 0; from < n; from += BLOCK) {
        size_t block = n - from < BLOCK ? n - from : BLOCK;
        for (size_t i = 0; i < block; i++)
            unpack_one(&palette[from + i], a, i);
#pragma omp simd
        for (size_t i = 0; i < BLOCK; i++)
            normal_one(a, r, i);
        for (size_t i = 0; i < block; i++) {
            float *o = out + (from + i) * size;
            for (size_t k = 3; k < size; k += 4)
                o[k] = 0.0f;
            for (size_t k = 0; k < 9; k++)
                o[k / 3 * column + k % 3 * row] = r[k][i];
        }
    }
}
