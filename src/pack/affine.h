/* SPDX-License-Identifier: MIT */
/*
 * An affine matrix as the left factor of many products: its columns in registers where there are such, otherwise in
 * memory. The last row is not defined until the matrix is stored.
 */
#ifndef NAKAWARI_PACK_AFFINE_H
#define NAKAWARI_PACK_AFFINE_H

#include "lane/strict.h"

#include "lane/mat.h"
#include "pack/f32x4.h"

/* A right factor in component arrays: elements of the columns x, y, z are `step` floats apart, those of t `t_step`. */
typedef struct affine_arrays {
    const float *x, *y, *z, *t;
    size_t step, t_step;
} affine_arrays;

static inline nkw_mat4 mat4_from_affine_arrays(const affine_arrays *a)
{
    const float *const columns[4] = {a->x, a->y, a->z, a->t};
    nkw_mat4 m;
    for (size_t c = 0; c < 4; c++) {
        for (size_t r = 0; r < 3; r++)
            m.m[4 * c + r] = columns[c][r * (c < 3 ? a->step : a->t_step)];
        m.m[4 * c + 3] = c < 3 ? 0.0f : 1.0f;
    }
    return m;
}

#if NKW_F32X4
typedef struct affine {
    f32x4 c[4];
} affine;

static inline affine affine_load(const nkw_mat4 *m)
{
    affine r;
    for (int c = 0; c < 4; c++)
        r.c[c] = f32x4_load(m->m + 4 * c);
    return r;
}

static inline affine affine_zero(void)
{
    affine r = {{{0.0f}, {0.0f}, {0.0f}, {0.0f}}};
    return r;
}

/* With the last row 0 0 0 1. */
static inline void affine_store(const affine *a, nkw_mat4 *out)
{
    for (int c = 0; c < 4; c++)
        f32x4_store(out->m + 4 * c, f32x4_with_last(a->c[c], c == 3));
}

/* The upper three rows. */
static inline void affine_store_rows(const affine *a, nkw_mat3x4 *out)
{
    affine t = *a;
    f32x4_transpose(t.c);
    for (int r = 0; r < 3; r++)
        f32x4_store(out->m + 4 * r, t.c[r]);
}

/* a b, by the sums of nkw_mat4_mul_affine. */
static inline affine affine_mul(const affine *a, const nkw_mat4 *b)
{
    affine r;
    for (int c = 0; c < 3; c++)
        r.c[c] = nkw_f32x4_direction(a->c, b->m + 4 * c, 1);
    r.c[3] = nkw_f32x4_point(a->c, b->m + 12, 1);
    return r;
}

static inline affine affine_mul_arrays(const affine *a, const affine_arrays *b)
{
    affine r;
    r.c[0] = nkw_f32x4_direction(a->c, b->x, b->step);
    r.c[1] = nkw_f32x4_direction(a->c, b->y, b->step);
    r.c[2] = nkw_f32x4_direction(a->c, b->z, b->step);
    r.c[3] = nkw_f32x4_point(a->c, b->t, b->t_step);
    return r;
}
#else
typedef nkw_mat4 affine;

static inline affine affine_load(const nkw_mat4 *m)
{
    return *m;
}

static inline affine affine_zero(void)
{
    affine r = {{0.0f}};
    return r;
}

static inline void affine_store(const affine *a, nkw_mat4 *out)
{
    *out = *a;
    for (int c = 0; c < 4; c++)
        out->m[4 * c + 3] = c < 3 ? 0.0f : 1.0f;
}

static inline void affine_store_rows(const affine *a, nkw_mat3x4 *out)
{
    *out = nkw_mat3x4_from_mat4(a);
}

static inline affine affine_mul(const affine *a, const nkw_mat4 *b)
{
    return lane_mat4_mul_affine(a, b);
}

static inline affine affine_mul_arrays(const affine *a, const affine_arrays *b)
{
    const nkw_mat4 m = mat4_from_affine_arrays(b);
    return lane_mat4_mul_affine(a, &m);
}
#endif

#endif
