/* SPDX-License-Identifier: MIT */
/* Lanes are characters. include/nakawari/crowd.h has the layout. */
#include "lane/strict.h"

#include <nakawari/crowd.h>
#include <nakawari/mat.h>
#include <nakawari/transform.h>

#include "batch/crowd.h"
#include "lane/mat.h"
#include "pack/f32x4.h"
#include "sizes.h"

NKW_LOOPS_CROWD(NKW_DECLARE_LOOP)

#define CROWD_LANES NKW_CROWD

/* An affine matrix of lane i. */
static inline nkw_mat4 matrix_at(const float *m, size_t i)
{
    nkw_mat4 r = {{m[i], m[CROWD_LANES + i], m[2 * CROWD_LANES + i], 0.0f, m[3 * CROWD_LANES + i],
                   m[4 * CROWD_LANES + i], m[5 * CROWD_LANES + i], 0.0f, m[6 * CROWD_LANES + i], m[7 * CROWD_LANES + i],
                   m[8 * CROWD_LANES + i], 0.0f, m[9 * CROWD_LANES + i], m[10 * CROWD_LANES + i],
                   m[11 * CROWD_LANES + i], 1.0f}};
    return r;
}

static inline void put_matrix(float *m, size_t i, const nkw_mat4 *a)
{
    for (size_t k = 0; k < 12; k++)
        m[k * CROWD_LANES + i] = a->m[k / 3 * 4 + k % 3];
}

/* nkw_mat4_from_trs of a lane. */
static inline nkw_mat4 local_at(const float *p, size_t i)
{
    const nkw_trs trs = {
        {p[i], p[CROWD_LANES + i], p[2 * CROWD_LANES + i]},
        {p[3 * CROWD_LANES + i], p[4 * CROWD_LANES + i], p[5 * CROWD_LANES + i], p[6 * CROWD_LANES + i]},
        {p[7 * CROWD_LANES + i], p[8 * CROWD_LANES + i], p[9 * CROWD_LANES + i]},
    };
    return lane_mat4_from_trs(&trs);
}

/* Functions of their own, so that the loops around them see no address of a local matrix. */
static inline void local_of(const float *p, float *out, size_t i)
{
    nkw_mat4 m = local_at(p, i);
    put_matrix(out, i, &m);
}

static inline void model_of(const float *parent, const float *p, float *out, size_t i)
{
    nkw_mat4 a = matrix_at(parent, i), b = local_at(p, i), m = lane_mat4_mul_affine(&a, &b);
    put_matrix(out, i, &m);
}

static inline void bound_of(const float *model, const nkw_mat4 *inverse_bind, float *out, size_t i)
{
    nkw_mat4 a = matrix_at(model, i), m = lane_mat4_mul_affine(&a, inverse_bind);
    put_matrix(out, i, &m);
}

NKW_ALWAYS_INLINE void locals_of(const float *pose, float *out)
{
#pragma omp simd
    NKW_KEEP_LOOP
    for (size_t i = 0; i < CROWD_LOOP; i++)
        local_of(pose, out, i);
}

NKW_ALWAYS_INLINE void models_of(const float *parent, const float *pose, float *out)
{
#pragma omp simd
    NKW_KEEP_LOOP
    for (size_t i = 0; i < CROWD_LOOP; i++)
        model_of(parent, pose, out, i);
}

NKW_LOOP(nkwi_crowd_models)
(const int32_t *parents, size_t joints, const float *crowd, const float *roots, float *models)
{
    for (size_t j = 0; j < joints; j++) {
        const float *pose = crowd + j * 10 * CROWD_LANES;
        float *model = models + j * 12 * CROWD_LANES;
        size_t p = (size_t)parents[j];
        const float *parent = p < j ? models + p * 12 * CROWD_LANES : roots;
        if (parent)
            for (size_t i = 0; i < CROWD_LANES; i += CROWD_LOOP)
                models_of(parent + i, pose + i, model + i);
        else
            for (size_t i = 0; i < CROWD_LANES; i += CROWD_LOOP)
                locals_of(pose + i, model + i);
    }
}

NKW_LOOP(nkwi_crowd_bind)(const float *model, const nkw_mat4 *inverse_bind, float *out)
{
    const nkw_mat4 bind = *inverse_bind;
#pragma omp simd
    for (size_t i = 0; i < CROWD_LANES; i++)
        bound_of(model, &bind, out, i);
}

/* Transposes four floats of four poses to four lanes of four joints. */
NKW_LOOP(nkwi_crowd_from_poses)(const float *const *poses, size_t joints, size_t stride, float *crowd)
{
    static const float identity[10][4] = {{0}, {0},          {0},          {0},          {0},
                                          {0}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}};
    for (size_t j = 0; j < joints; j += 4)
        for (size_t c = 0; c < 10; c++)
            for (size_t i = 0; i < CROWD_LANES; i += 4) {
                const float *from[4];
                float *to[4];
                for (size_t k = 0; k < 4; k++) {
                    from[k] = poses[i + k] ? poses[i + k] + c * stride + j : identity[c];
                    to[k] = j + k < joints ? crowd + ((j + k) * 10 + c) * CROWD_LANES + i : NULL;
                }
                f32x4_transpose_rows(from, to);
            }
}

NKW_LOOP(nkwi_crowd_to_matrices)(const float *crowd, size_t joints, nkw_mat4 *const *matrices)
{
    static const float last[2][4] = {{0, 0, 0, 0}, {1, 1, 1, 1}};
    for (size_t j = 0; j < joints; j++)
        for (size_t column = 0; column < 4; column++)
            for (size_t i = 0; i < CROWD_LANES; i += 4) {
                const float *at = crowd + (12 * j + 3 * column) * CROWD_LANES + i;
                const float *const from[4] = {at, at + CROWD_LANES, at + 2 * CROWD_LANES, last[column == 3]};
                float *to[4];
                for (size_t k = 0; k < 4; k++)
                    to[k] = matrices[i + k] ? matrices[i + k][j].m + 4 * column : NULL;
                f32x4_transpose_rows(from, to);
            }
}
