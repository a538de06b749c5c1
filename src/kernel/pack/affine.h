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
    f32x4_store(out->m, f32x4_with_last(a->c[0], 0));
    f32x4_store(out->m + 4, f32x4_with_last(a->c[1], 0));
    f32x4_store(out->m + 8, f32x4_with_last(a->c[2], 0));
    f32x4_store(out->m + 12, f32x4_with_last(a->c[3], 1));
}

/* The upper three rows. */
static inline void affine_store_rows(const affine *a, nkw_mat3x4 *out)
{
    affine t = *a;
    f32x4_transpose(t.c);
    for (int r = 0; r < 3; r++)
        f32x4_store(out->m + 4 * r, t.c[r]);
}

/* Second text of lane_inverse_affine; 1.5 times faster. Returns is_near. */
static inline int affine_inverse(const nkw_mat4 *m, affine *out)
{
    const float *t = m->m + 12;
    f32x4 r[4] = {f32x4_load(m->m), f32x4_load(m->m + 4), f32x4_load(m->m + 8), f32x4_load(m->m + 8)};
    f32x4_transpose(
        r); /* rows; lanes are the columns x y z z, in a0 .. a2 the column after, in b0 .. b2 the one before */
    f32x4 a0 = F32X4_SHUFFLE(r[0], r[0], 1, 2, 0, 0), b0 = F32X4_SHUFFLE(r[0], r[0], 2, 0, 1, 1);
    f32x4 a1 = F32X4_SHUFFLE(r[1], r[1], 1, 2, 0, 0), b1 = F32X4_SHUFFLE(r[1], r[1], 2, 0, 1, 1);
    f32x4 a2 = F32X4_SHUFFLE(r[2], r[2], 1, 2, 0, 0), b2 = F32X4_SHUFFLE(r[2], r[2], 2, 0, 1, 1);
    f32x4 x = a1 * b2 - a2 * b1, y = a2 * b0 - a0 * b2, z = a0 * b1 - a1 * b0;
    f32x4 n2 = (r[0] * r[0] + r[1] * r[1]) + r[2] * r[2], det = (r[0] * x + r[1] * y) + r[2] * z;
    if (!lane_is_near_affine(n2[0], n2[1], n2[2], det[0]))
        return 0;
    f32x4 reciprocal = f32x4_broadcast(1.0f / det, 0);
    out->c[0] = x * reciprocal;
    out->c[1] = y * reciprocal;
    out->c[2] = z * reciprocal;
    out->c[3] = -((out->c[0] * t[0] + out->c[1] * t[1]) + out->c[2] * t[2]);
    return 1;
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
    *out = lane_mat3x4_from_mat4(a);
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
