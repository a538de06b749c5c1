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

/* M p of each matrix and its point. */
static inline f32xN_column f32xN_transform_point(f32xN_columns m, f32xN_vectors p)
{
    f32xN_column r;
    for (int i = 0; i < F32XN_ROWS; i++)
        r.row[i] = f32xN_point(m.x.row[i], m.y.row[i], m.z.row[i], m.t.row[i], p);
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
