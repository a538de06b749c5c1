/* SPDX-License-Identifier: MIT */
/*
 * Columns of 4x4 matrices in registers, and vectors of three floats in memory that they transform. A register holds
 * one column of F32XN_GROUP matrices:
 *
 *     F32XN   matrices in a group   registers of a column   registers of a matrix
 *     1       1                     4                       16
 *     4       1                     1                       4
 *     8       2                     1                       2
 *     16      4                     1                       1
 */
#ifndef NAKAWARI_PACK_COLUMNS_H
#define NAKAWARI_PACK_COLUMNS_H

#include "pack/f32xn.h"

#define F32XN_GROUP (F32XN > 4 ? F32XN / 4 : 1)
#define F32XN_ROWS  (F32XN > 4 ? 1 : 4 / F32XN)
#define F32XN_PARTS (16 / F32XN)

/* One column of the matrices of a group: 4 floats of each. */
typedef struct f32xN_column {
    f32xN row[F32XN_ROWS];
} f32xN_column;

/* The four columns. */
typedef struct f32xN_columns {
    f32xN_column x, y, z, t;
} f32xN_columns;

/* The vectors of a group: each component four times. */
typedef struct f32xN_vectors {
    f32xN x, y, z;
} f32xN_vectors;

#if NKW_F32X4
/* Three floats, then 0. */
static inline f32x4 f32x4_load3(const void *from)
{
    float x, y, z;
    memcpy(&x, from, sizeof x);
    memcpy(&y, (const char *)from + sizeof x, sizeof y);
    memcpy(&z, (const char *)from + 2 * sizeof x, sizeof z);
    const f32x4 r = {x, y, z, 0.0f};
    return r;
}
#endif

/*
 * Each width has a file with the same functions:
 *
 *     f32xN_broadcast(a, i)         a[i] of each four floats in all four; i is a constant
 *     f32xN_transpose(m)            transposes the 4x4 block of each four floats
 *     f32xN_scatter(m, count, to, offset)
 *                                   element i of each of the four registers, to `count` floats at to[i] + offset bytes;
 *                                   count is 3 or 4
 *     f32xN_load8, f32xN_store8     eight floats in the first half of a register of 16; otherwise a register
 *     f32xN_columns_of(m)           the columns of a group of matrices, F32XN_PARTS registers each
 *     f32xN_columns_of3(m)          the first three columns of a group of 3x3 matrices, F32XN_PARTS3 registers each: the
 *                                   floats 0..3, 4..7, 5..8; 0..7, 1..8 (twice with F32XN 16); or each. Fourth rows are
 *                                   anything, the fourth column is 0
 *     f32xN_next(a)                 y z x of each x y z; fourth rows are anything
 *     f32xN_read3(p, stride)        the vectors of a group, at every `stride` bytes; reads the four bytes after each too
 *     f32xN_read3_first(p, stride, n)
 *                                   the first n vectors of a group, the last of them in the places of the others; reads
 *                                   nothing else
 *     f32xN_read3_packed(p)         f32xN_read3 of contiguous vectors; reads the four bytes after the group with F32XN 4
 *     f32xN_write3(p, stride, a)    the first three floats of each four, to every `stride` bytes
 *     f32xN_write3_packed(p, a)     the same, contiguous
 */
#define F32XN_PARTS3 (F32XN == 1 ? 9 : F32XN == 4 ? 3 : 2)
#if F32XN == 1
#include "pack/columns1.h"
#elif F32XN == 4
#include "pack/columns4.h"
#elif F32XN == 8
#include "pack/columns8.h"
#else
#include "pack/columns16.h"
#endif

/* Element i of a column of each matrix, beside all four of its elements; i is a constant. */
#if F32XN == 1
#define f32xN_element(a, i) ((a).row[i])
#else
#define f32xN_element(a, i) f32xN_broadcast((a).row[0], i)
#endif

/*
 * Second text of nkw_mat4_transform_point and nkw_mat4_transform_direction; 3.3 times faster.
 *
 * A row, or parts of columns, of M p and of M d: x y z t are what the matrix has there in its columns.
 */
static inline f32xN f32xN_point(f32xN x, f32xN y, f32xN z, f32xN t, f32xN_vectors p)
{
    return (x * p.x + y * p.y) + (z * p.z + t);
}

static inline f32xN f32xN_direction(f32xN x, f32xN y, f32xN z, f32xN_vectors d)
{
    return (x * d.x + y * d.y) + z * d.z;
}

/*
 * Normals n' = s (b x c, c x a, a x b) n, of the direction of (M^-1)^T n:  a, b, c are the columns of M, s = -1 where
 *
 *     det M < -2^-20 T,    T = the sum of the magnitudes of the six products in det M = a . (b x c),
 *
 * else 1. Within 2^-20 T rounding may have decided the sign of det M: M is flat.
 */
#define PACK_FLAT 0x1p-20f

/* The components of three columns after a component and after the next one. */
typedef struct f32xN_minor {
    f32xN a1, a2, b1, b2, c1, c2;
} f32xN_minor;

/* A component of (b x c, c x a, a x b) n. */
static inline f32xN f32xN_cofactors(f32xN_minor m, f32xN_vectors n)
{
    const f32xN x = m.b1 * m.c2 - m.b2 * m.c1, y = m.c1 * m.a2 - m.c2 * m.a1, z = m.a1 * m.b2 - m.a2 * m.b1;
    return f32xN_direction(x, y, z, n);
}

/* A component of a, a term of det M + 2^-20 T. */
static inline f32xN f32xN_side(f32xN a, f32xN_minor m)
{
    const f32xN p = m.b1 * m.c2, q = m.b2 * m.c1;
    return a * (p - q) + f32xN_splat(PACK_FLAT) * (f32xN_magnitude(a) * (f32xN_magnitude(p) + f32xN_magnitude(q)));
}

/* x + y + z, where M mirrors. */
static inline i32xN f32xN_mirrors(f32xN x, f32xN y, f32xN z)
{
    return f32xN_less((x + y) + z, f32xN_splat(0.0f));
}

/* n' of each matrix and its normal. */
static inline f32xN_column f32xN_transform_normal(f32xN_columns m, f32xN_vectors n)
{
    const f32xN_column a1 = f32xN_next(m.x), a2 = f32xN_next(a1), b1 = f32xN_next(m.y), b2 = f32xN_next(b1);
    const f32xN_column c1 = f32xN_next(m.z), c2 = f32xN_next(c1);
    f32xN_column r, side;
    for (int i = 0; i < F32XN_ROWS; i++) {
        const f32xN_minor minor = {a1.row[i], a2.row[i], b1.row[i], b2.row[i], c1.row[i], c2.row[i]};
        r.row[i] = f32xN_cofactors(minor, n);
        side.row[i] = f32xN_side(m.x.row[i], minor);
    }
    const i32xN mirrors = f32xN_mirrors(f32xN_element(side, 0), f32xN_element(side, 1), f32xN_element(side, 2));
    for (int i = 0; i < F32XN_ROWS; i++)
        r.row[i] = f32xN_negate_where(mirrors, r.row[i]);
    return r;
}

/* M p of each matrix and its point. */
static inline f32xN_column f32xN_transform_point(f32xN_columns m, f32xN_vectors p)
{
    f32xN_column r;
    for (int i = 0; i < F32XN_ROWS; i++)
        r.row[i] = f32xN_point(m.x.row[i], m.y.row[i], m.z.row[i], m.t.row[i], p);
    return r;
}

/* M p / w, w the last element of M. */
static inline f32xN_column f32xN_transform_divided(f32xN_columns m, f32xN_vectors p)
{
    f32xN_column r = f32xN_transform_point(m, p);
    for (int i = 0; i < F32XN_ROWS; i++)
        r.row[i] = r.row[i] / f32xN_element(m.t, 3);
    return r;
}

/* M d of each matrix and its direction: without the translation. */
static inline f32xN_column f32xN_transform_direction(f32xN_columns m, f32xN_vectors d)
{
    f32xN_column r;
    for (int i = 0; i < F32XN_ROWS; i++)
        r.row[i] = f32xN_direction(m.x.row[i], m.y.row[i], m.z.row[i], d);
    return r;
}

#endif
