/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/palette.h>

#include "batch/matrices.h"
#include "batch/palette.h"
#include "lane/dual_quat.h"
#include "lane/mat.h"
#include "pack/affine.h"

NKW_LOOPS_PALETTE(NKW_DECLARE_LOOP)

/* The model of joint i of the skin, NULL where there is none. A negative index is beyond every count. */
static inline const nkw_mat4 *model_of(const nkw_palette_source *s, size_t i)
{
    size_t j = s->joints ? (size_t)s->joints[i] : i;
    return j < s->model_count ? s->models + j : NULL;
}

/* (global inverse * model) * inverse bind, without the factors that are NULL. */
static inline affine product_of(const affine *global_inverse, const nkw_mat4 *model, const nkw_mat4 *inverse_bind)
{
    affine m = global_inverse ? affine_mul(global_inverse, model) : affine_load(model);
    return inverse_bind ? affine_mul(&m, inverse_bind) : m;
}

static inline affine joint_matrix(const nkw_palette_source *s, const nkw_mat4 *inverse_bind,
                                  const affine *global_inverse, size_t i)
{
    static const nkw_mat4 identity = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
    const nkw_mat4 *model = model_of(s, i);
    if (!model)
        return affine_load(&identity);
    return product_of(global_inverse, model, inverse_bind ? inverse_bind + i : NULL);
}

/* *m, or 0 where there is none. */
static inline affine affine_or_zero(const nkw_mat4 *m)
{
    return m ? affine_load(m) : affine_zero();
}

NKW_LOOP(nkwi_palette_4x4)
(const nkw_palette_source *source, nkw_mat4 *out)
{
    const nkw_palette_source s = *source;
    const affine g = affine_or_zero(s.global_inverse);
    for (size_t i = 0; i < s.joint_count; i++) {
        affine m = joint_matrix(&s, s.inverse_bind, s.global_inverse ? &g : NULL, i);
        affine_store(&m, &out[i]);
    }
}

NKW_LOOP(nkwi_palette_3x4)
(const nkw_palette_source *source, nkw_mat3x4 *out)
{
    const nkw_palette_source s = *source;
    const affine g = affine_or_zero(s.global_inverse);
    for (size_t i = 0; i < s.joint_count; i++) {
        affine m = joint_matrix(&s, s.inverse_bind, s.global_inverse ? &g : NULL, i);
        affine_store_rows(&m, &out[i]);
    }
}

/* Joint matrices from number `from` on. */
static inline void gather(const nkw_palette_source *s, const nkw_mat4 *inverse_bind, const affine *global_inverse,
                          size_t from, size_t size, matrices *a)
{
    nkw_mat4 m[MATRIX_BLOCK];
    int plain = !s->joints && !inverse_bind && !global_inverse && from + size <= s->model_count;
    for (size_t i = 0; i < size && !plain; i++) {
        affine c = joint_matrix(s, inverse_bind, global_inverse, from + i);
        affine_store(&c, &m[i]);
    }
    matrices_spread(plain ? s->models + from : m, size, a);
}

NKW_LOOP(nkwi_palette_inverse)
(const nkw_palette_source *source, nkw_mat4 *out)
{
    const nkw_palette_source s = *source;
    const affine g = affine_or_zero(s.global_inverse);
    const size_t n = s.joint_count;
    matrices a, r;
    for (size_t from = 0; from < n; from += MATRIX_BLOCK) {
        size_t size = n - from < MATRIX_BLOCK ? n - from : MATRIX_BLOCK;
        gather(&s, NULL, s.global_inverse ? &g : NULL, from, size, &a);
        matrices_invert(&a, &r);
        for (size_t i = 0; i < size; i += 4)
            matrices_write(&r, i, out + from + i, size - i);
    }
}

/* Functions of their own, so that the loops around them see no address of a local matrix. */
static inline void normal_one(const matrices *a, matrices *r, size_t i)
{
    nkw_mat3 m = {
        {a->e[0][i], a->e[1][i], a->e[2][i], a->e[3][i], a->e[4][i], a->e[5][i], a->e[6][i], a->e[7][i], a->e[8][i]}};
    nkw_mat3 normal = lane_mat3_normal(&m);
    for (size_t k = 0; k < 9; k++)
        r->e[k][i] = normal.m[k];
}

/* Eight elements: the real part, then the dual one. */
static inline void dual_one(const matrices *a, matrices *r, size_t i)
{
    lane_f64_mat3 linear = matrices_linear(a, i);
    nkw_dual_quat d = lane_dual_quat_from_affine(&linear, matrices_column(a, 3, i));
    r->e[0][i] = d.real.x, r->e[1][i] = d.real.y, r->e[2][i] = d.real.z, r->e[3][i] = d.real.w;
    r->e[4][i] = d.dual.x, r->e[5][i] = d.dual.y, r->e[6][i] = d.dual.z, r->e[7][i] = d.dual.w;
}

NKW_LOOP(nkwi_palette_dual)
(const nkw_palette_source *source, nkw_dual_quat *out)
{
    const nkw_palette_source s = *source;
    const affine g = affine_or_zero(s.global_inverse);
    const size_t n = s.joint_count;
    matrices a, r;
    for (size_t from = 0; from < n; from += MATRIX_BLOCK) {
        size_t size = n - from < MATRIX_BLOCK ? n - from : MATRIX_BLOCK;
        gather(&s, s.inverse_bind, s.global_inverse ? &g : NULL, from, size, &a);
#pragma omp simd
        for (size_t i = 0; i < MATRIX_BLOCK; i++)
            dual_one(&a, &r, i);
        for (size_t i = 0; i < size; i += 4) {
            float *real[4] = {NULL}, *dual[4] = {NULL};
            for (size_t k = 0; k < 4 && i + k < size; k++) {
                real[k] = &out[from + i + k].real.x;
                dual[k] = &out[from + i + k].dual.x;
            }
            matrices_take(&r, 0, 1, 2, r.e[3] + i, i, real);
            matrices_take(&r, 4, 5, 6, r.e[7] + i, i, dual);
        }
    }
}

/*
 * Three lines of `line` floats for each matrix: elements `step` apart, lines from element 0, `next`, 2 `next` on. What
 * a line of three has beyond itself the next one writes over.
 */
static inline void write_normals(const matrices *r, size_t line, size_t step, size_t next, float *out, size_t size)
{
    static const float zeros[4] = {0.0f};
    for (size_t i = 0; i < size; i += 4)
        for (size_t l = 0; l < 3; l++) {
            float lines[4][4], *const to[4] = {lines[0], lines[1], lines[2], lines[3]};
            matrices_take(r, l * next, l * next + step, l * next + 2 * step, zeros, i, to);
            for (size_t k = 0; k < 4 && i + k < size; k++) {
                float *o = out + (3 * (i + k) + l) * line;
                memcpy(o, lines[k], (line == 4 || l < 2 ? 4 : 3) * sizeof *o);
            }
        }
}

/* Lines of `line` floats, of which those after three are 0: columns, or rows. */
NKW_LOOP(nkwi_palette_normals)(const nkw_palette_source *source, size_t line, int rows, float *out)
{
    const nkw_palette_source s = *source;
    const affine g = affine_or_zero(s.global_inverse);
    const size_t n = s.joint_count;
    matrices a, r;
    for (size_t from = 0; from < n; from += MATRIX_BLOCK) {
        size_t size = n - from < MATRIX_BLOCK ? n - from : MATRIX_BLOCK;
        gather(&s, s.inverse_bind, s.global_inverse ? &g : NULL, from, size, &a);
#pragma omp simd
        for (size_t i = 0; i < MATRIX_BLOCK; i++)
            normal_one(&a, &r, i);
        write_normals(&r, line, rows ? 3 : 1, rows ? 1 : 3, out + from * 3 * line, size);
    }
}
