/* SPDX-License-Identifier: MIT */
/*
 * Local transforms to model matrices, and back.
 *
 * Invariant: parents are before their children, so when joint j is computed the matrix of its parent is complete. Any
 * number that is not less than j, also a negative one, makes j a root.
 *
 *     pose, arrays of `stride`    | tx | ty | tz | rx .. rw | sx sy sz |        64 joints from `start` on at a time
 *     l[9][64], on the stack      R S, column by column: | m00 of 64 | m10 of 64 | m20 | m01 | ...
 *     joint j, i = j - start      columns l[0], l[3], l[6] + i, and t + i       affine_arrays
 *     models[j]                   model(parent) (R S, t): 16 floats, the last row 0 0 0 1
 *
 * R S of many joints is a vector loop; the products are not, as each needs the one before. From models back to locals
 * all inverses are independent: local(j) = model(parent)^-1 model(j).
 */
#include "lane/strict.h"

#include <nakawari/transform.h>

#include "batch/element.h"
#include "batch/last.h"
#include "batch/matrices.h"
#include "batch/record_rows.h"
#include "batch/skeleton.h"
#include "lane/skeleton.h"
#include "pack/affine.h"
#include "sizes.h"

NKW_LOOPS_SKELETON(NKW_DECLARE_LOOP)

/*
 * R S of eight joints of a pose whose rotations begin at r: one array for each element. With sixteen at a time AVX-512
 * takes a tenth longer for the joints, which read the elements one by one soon after.
 */
static inline void make_linear(const float *r, size_t stride, float *linear)
{
    const float *s = r + 4 * stride;
#pragma omp simd
    for (size_t i = 0; i < 8; i++) {
        nkw_quat rotation = {r[i], r[stride + i], r[2 * stride + i], r[3 * stride + i]};
        nkw_vec3 scale = {s[i], s[stride + i], s[2 * stride + i]};
        nkw_mat3 m = nkw_mat3_from_quat_scale(rotation, scale);
        for (size_t k = 0; k < 9; k++)
            linear[k * MODELS_BLOCK + i] = m.m[k];
    }
}

/* The same of the last joints, fewer than eight. */
static inline void make_last_linear(const float *r, size_t stride, size_t joints, float *linear)
{
    float rows[7][8];
    for (size_t k = 0; k < 7; k++)
        copy_last(r + k * stride, 8, joints, 0.0f, rows[k]);
    make_linear(rows[0], 8, linear);
}

/* The address of the parent's matrix, or NULL. */
static inline const nkw_mat4 *above(const int32_t *parents, size_t j, const nkw_mat4 *root, const nkw_mat4 *models)
{
    size_t p = skeleton_parent(parents, j);
    return p < j ? &models[p] : root;
}

/*
 * The local matrix of a root. A separate function: otherwise its loads are shared with those of the product, ahead of
 * the branch, and the sums lose their registers to them.
 */
NKW_NOINLINE static void store_root(affine_arrays local, nkw_mat4 *m)
{
    *m = mat4_from_affine_arrays(&local);
}

/*
 * The parent of most joints is the joint before, whose matrix is still in registers: loading it from memory again would
 * take as long as the sums.
 */
static inline int follows_parent(const int32_t *parents, size_t j)
{
    return (uint64_t)skeleton_parent(parents, j) + 1 == j;
}

/* The matrix of the joint before the first of from .. to - 1. */
static inline affine model_before(const nkw_mat4 *models, size_t from, size_t to)
{
    return 0 < from && from < to ? affine_load(&models[from - 1]) : affine_zero();
}

/* Joints of one block of a pose: its rows begin at t, with joint `start`. */
typedef struct models_part {
    const float *t;
    size_t stride, start, end;
} models_part;

/* Joints j .. p->end - 1. m is the matrix of joint j - 1, then of the last one. */
NKW_ALWAYS_INLINE void models_of_block(const int32_t *parents, const models_part *p, size_t j, const nkw_mat4 *root,
                                       nkw_mat4 *models, affine *m)
{
    float l[9][MODELS_BLOCK];
    const size_t last = (p->end - p->start) / 8 * 8;
    for (size_t i = 0; i < last; i += 8)
        make_linear(p->t + 3 * p->stride + i, p->stride, l[0] + i);
    if (p->start + last < p->end)
        make_last_linear(p->t + 3 * p->stride + last, p->stride, p->end - p->start - last, l[0] + last);
    for (; j < p->end; j++) {
        const size_t i = j - p->start;
        const affine_arrays local = {l[0] + i, l[3] + i, l[6] + i, p->t + i, MODELS_BLOCK, p->stride};
        const nkw_mat4 *parent;
        if (follows_parent(parents, j)) {
            *m = affine_mul_arrays(m, &local);
        } else if ((parent = above(parents, j, root, models)) != NULL) {
            *m = affine_load(parent);
            *m = affine_mul_arrays(m, &local);
        } else {
            store_root(local, &models[j]);
            *m = affine_load(&models[j]);
            continue;
        }
        affine_store(m, &models[j]);
    }
}

/* Joints from .. to - 1; at from > 0 `models` holds those before. */
NKW_LOOP(nkwi_models_from_pose)
(const int32_t *parents, const float *pose, size_t stride, const nkw_mat4 *root, size_t from, size_t to,
 nkw_mat4 *models)
{
    affine m = model_before(models, from, to);
    for (size_t start = from / 16 * 16, j = from; j < to; start += MODELS_BLOCK, j = start) {
        const models_part p = {pose + start, stride, start, to - start < MODELS_BLOCK ? to : start + MODELS_BLOCK};
        models_of_block(parents, &p, j, root, models, &m);
    }
}

/* The same of a pose of records. */
NKW_LOOP(nkwi_models_from_records)
(const int32_t *parents, const nkw_trs *records, const nkw_mat4 *root, size_t from, size_t to, nkw_mat4 *models)
{
    affine m = model_before(models, from, to);
    for (size_t j = from; j < to; j += MODELS_BLOCK) {
        float rows[RECORD_FLOATS * MODELS_BLOCK];
        const models_part p = {rows, MODELS_BLOCK, j, to - j < MODELS_BLOCK ? to : j + MODELS_BLOCK};
        rows_from_records(records + j, p.end - j, rows, MODELS_BLOCK);
        models_of_block(parents, &p, j, root, models, &m);
    }
}

NKW_LOOP(nkwi_models_from_locals)
(const int32_t *parents, const nkw_mat4 *locals, const nkw_mat4 *root, size_t from, size_t to, nkw_mat4 *models)
{
    affine m = model_before(models, from, to);
    for (size_t j = from; j < to; j++) {
        const nkw_mat4 *parent;
        if (follows_parent(parents, j)) {
            m = affine_mul(&m, &locals[j]);
        } else if ((parent = above(parents, j, root, models)) != NULL) {
            m = affine_load(parent);
            m = affine_mul(&m, &locals[j]);
        } else {
            m = affine_load(&locals[j]);
        }
        affine_store(&m, &models[j]);
    }
}

/*
 * Joints from .. to - 1 to the beginning of `locals`, the last first: in place, parents are then still model matrices
 * when they are asked. A joint with nothing above is inverted for nothing.
 */
NKW_LOOP(nkwi_locals_from_models)
(const int32_t *parents, const nkw_mat4 *models, const nkw_mat4 *root, size_t from, size_t to, nkw_mat4 *locals)
{
    matrices a, inverse;
    for (size_t end = to; end > from;) {
        size_t size = end - from < MATRIX_BLOCK ? end - from : MATRIX_BLOCK, start = end - size;
        for (size_t i = 0; i < size; i += 4) {
            const nkw_mat4 *four[4];
            for (size_t k = 0; k < 4; k++) {
                size_t j = start + matrices_index(i + k, size);
                const nkw_mat4 *parent = above(parents, j, root, models);
                four[k] = parent ? parent : &models[j];
            }
            matrices_put(&a, i, four);
        }
        matrices_fill(&a, size);
        matrices_invert(&a, &inverse);
        for (size_t i = 0; i < size; i += 4) {
            nkw_mat4 m[4];
            matrices_write(&inverse, i, m, 4);
            for (size_t k = 0; k < 4 && i + k < size; k++) {
                size_t j = start + i + k;
                affine l = affine_load(&m[k]);
                l = above(parents, j, root, models) ? affine_mul(&l, &models[j]) : affine_load(&models[j]);
                affine_store(&l, &locals[j - from]);
            }
        }
        end = start;
    }
}

/* Apart, so that the loop sees no address of a local matrix. Returns whether the result is not to be used. */
static inline int decompose_one(const matrices *a, float *out, size_t stride, size_t i)
{
    lane_scaled_rotation r =
        lane_scaled_rotation_of(matrices_column3(a, 0, i), matrices_column3(a, 1, i), matrices_column3(a, 2, i));
    store_vec3(out, out + stride, out + 2 * stride, i, matrices_column3(a, 3, i));
    store_quat(out + 3 * stride, out + 4 * stride, out + 5 * stride, out + 6 * stride, i, r.rotation);
    store_vec3(out + 7 * stride, out + 8 * stride, out + 9 * stride, i, r.scale);
    return !r.is_near;
}

/* nkw_trs_from_mat4 of n <= MATRIX_BLOCK matrices to the rows of a pose; *far says that some are none of these. */
NKW_LOOP(nkwi_pose_from_locals)(const nkw_mat4 *m, float *out, size_t stride, int *far, size_t n)
{
    matrices a;
    int some = 0;
    matrices_spread(m, n, &a);
#pragma omp simd reduction(| : some)
    for (size_t i = 0; i < n; i++)
        some |= decompose_one(&a, out, stride, i);
    *far = some;
}
