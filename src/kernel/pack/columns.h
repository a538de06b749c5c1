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

#if F32XN > 4
typedef float f32x8 __attribute__((vector_size(32)));

/* F32XN_EACH(a, b, i, j, k, l): these four of each four floats of a; from F32XN on those of b. */
#define F32XN_SHUFFLE(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#if F32XN == 8
#define F32XN_EACH(a, b, i, j, k, l) F32XN_SHUFFLE(a, b, i, j, k, l, 4 + (i), 4 + (j), 4 + (k), 4 + (l))
#else
#define F32XN_EACH(a, b, i, j, k, l)                                                                                   \
    F32XN_SHUFFLE(a, b, i, j, k, l, 4 + (i), 4 + (j), 4 + (k), 4 + (l), 8 + (i), 8 + (j), 8 + (k), 8 + (l), 12 + (i),  \
                  12 + (j), 12 + (k), 12 + (l))
/* The fours that begin at i, j, k, l. */
#define F32XN_FOURS(a, b, i, j, k, l)                                                                                  \
    F32XN_SHUFFLE(a, b, i, i + 1, i + 2, i + 3, j, j + 1, j + 2, j + 3, k, k + 1, k + 2, k + 3, l, l + 1, l + 2, l + 3)
#endif
#endif

/* a[i] of each four floats in all four; with F32XN 1, a. i is a constant. */
#if F32XN == 1
#define f32xN_broadcast(a, i) (a)
#elif F32XN == 4
#define f32xN_broadcast(a, i) f32x4_broadcast(a, i)
#else
#define f32xN_broadcast(a, i) F32XN_EACH(a, a, i, i, i, i)
#endif

/* Transposes the 4x4 block of each four floats; with F32XN 1 a register is a row already. */
static inline void f32xN_transpose(f32xN m[4])
{
#if F32XN == 1
    (void)m;
#elif F32XN == 4
    f32x4_transpose(m);
#else
    f32xN a = F32XN_EACH(m[0], m[1], 0, F32XN, 1, F32XN + 1), b = F32XN_EACH(m[2], m[3], 0, F32XN, 1, F32XN + 1);
    f32xN c = F32XN_EACH(m[0], m[1], 2, F32XN + 2, 3, F32XN + 3),
          d = F32XN_EACH(m[2], m[3], 2, F32XN + 2, 3, F32XN + 3);
    m[0] = F32XN_EACH(a, b, 0, 1, F32XN, F32XN + 1);
    m[1] = F32XN_EACH(a, b, 2, 3, F32XN + 2, F32XN + 3);
    m[2] = F32XN_EACH(c, d, 0, 1, F32XN, F32XN + 1);
    m[3] = F32XN_EACH(c, d, 2, 3, F32XN + 2, F32XN + 3);
#endif
}

/* Element i of each of the four registers, to `count` floats at to[i] + offset bytes; count is 3 or 4. */
static inline void f32xN_scatter(f32xN m[4], int count, unsigned char *const *to, size_t offset)
{
    f32xN_transpose(m);
#if F32XN == 1
    memcpy(to[0] + offset, m, (size_t)count * sizeof *m);
#else
    for (int k = 0; k < 4; k++) {
        const f32x4 fours[F32XN / 4] = {
#if F32XN == 4
            m[k]
#elif F32XN == 8
            F32XN_SHUFFLE(m[k], m[k], 0, 1, 2, 3),
            F32XN_SHUFFLE(m[k], m[k], 4, 5, 6, 7)
#else
            F32XN_SHUFFLE(m[k], m[k], 0, 1, 2, 3),
            F32XN_SHUFFLE(m[k], m[k], 4, 5, 6, 7),
            F32XN_SHUFFLE(m[k], m[k], 8, 9, 10, 11),
            F32XN_SHUFFLE(m[k], m[k], 12, 13, 14, 15)
#endif
        };
        for (int g = 0; g < F32XN / 4; g++)
            if (count == 4)
                f32x4_store(to[4 * g + k] + offset, fours[g]);
            else
                f32x4_store3(to[4 * g + k] + offset, fours[g]);
    }
#endif
}

/* Eight floats to the first half of a register of 16, and back. Narrower registers have no such half. */
static inline f32xN f32xN_load8(const void *from)
{
#if F32XN == 16
    f32x8 a;
    memcpy(&a, from, sizeof a);
    return F32XN_SHUFFLE(a, a, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7);
#else
    return f32xN_load(from);
#endif
}

static inline void f32xN_store8(void *to, f32xN a)
{
#if F32XN == 16
    const f32x8 half = F32XN_SHUFFLE(a, a, 0, 1, 2, 3, 4, 5, 6, 7);
    memcpy(to, &half, sizeof half);
#else
    f32xN_store(to, a);
#endif
}

/* The columns of a group of matrices, F32XN_PARTS registers each. */
static inline f32xN_columns f32xN_columns_of(const f32xN *m)
{
#if F32XN == 1
    f32xN_columns r = {{{m[0], m[1], m[2], m[3]}},
                       {{m[4], m[5], m[6], m[7]}},
                       {{m[8], m[9], m[10], m[11]}},
                       {{m[12], m[13], m[14], m[15]}}};
#elif F32XN == 4
    f32xN_columns r = {{{m[0]}}, {{m[1]}}, {{m[2]}}, {{m[3]}}};
#elif F32XN == 8
    f32xN_columns r = {{{F32XN_SHUFFLE(m[0], m[2], 0, 1, 2, 3, 8, 9, 10, 11)}},
                       {{F32XN_SHUFFLE(m[0], m[2], 4, 5, 6, 7, 12, 13, 14, 15)}},
                       {{F32XN_SHUFFLE(m[1], m[3], 0, 1, 2, 3, 8, 9, 10, 11)}},
                       {{F32XN_SHUFFLE(m[1], m[3], 4, 5, 6, 7, 12, 13, 14, 15)}}};
#else
    f32xN xy0 = F32XN_FOURS(m[0], m[1], 0, 4, 16, 20), xy1 = F32XN_FOURS(m[2], m[3], 0, 4, 16, 20);
    f32xN zt0 = F32XN_FOURS(m[0], m[1], 8, 12, 24, 28), zt1 = F32XN_FOURS(m[2], m[3], 8, 12, 24, 28);
    f32xN_columns r = {{{F32XN_FOURS(xy0, xy1, 0, 8, 16, 24)}},
                       {{F32XN_FOURS(xy0, xy1, 4, 12, 20, 28)}},
                       {{F32XN_FOURS(zt0, zt1, 0, 8, 16, 24)}},
                       {{F32XN_FOURS(zt0, zt1, 4, 12, 20, 28)}}};
#endif
    return r;
}

/*
 * The first three columns of a group of 3x3 matrices, F32XN_PARTS3 registers each: the floats 0..3, 4..7, 5..8; 0..7,
 * 1..8 (twice with F32XN 16); or each. Fourth rows are anything, the fourth column is 0.
 */
#define F32XN_PARTS3 (F32XN == 1 ? 9 : F32XN == 4 ? 3 : 2)
static inline f32xN_columns f32xN_columns_of3(const f32xN *m)
{
#if F32XN == 1
    f32xN_columns r = {{{m[0], m[1], m[2], 0.0f}}, {{m[3], m[4], m[5], 0.0f}}, {{m[6], m[7], m[8], 0.0f}}, {{0.0f}}};
#elif F32XN == 4
    f32xN_columns r = {
        {{m[0]}}, {{F32X4_SHUFFLE(m[0], m[1], 3, 4, 5, 6)}}, {{F32X4_SHUFFLE(m[2], m[2], 1, 2, 3, 3)}}, {{{0.0f}}}};
#elif F32XN == 8
    f32xN_columns r = {{{F32XN_SHUFFLE(m[0], m[2], 0, 1, 2, 3, 8, 9, 10, 11)}},
                       {{F32XN_SHUFFLE(m[0], m[2], 3, 4, 5, 6, 11, 12, 13, 14)}},
                       {{F32XN_SHUFFLE(m[1], m[3], 5, 6, 7, 7, 13, 14, 15, 15)}},
                       {{{0.0f}}}};
#else
    /* a0..a7 b0..b7, c0..c7 d0..d7, a1..a8 b1..b8, c1..c8 d1..d8 */
    f32xN ab = F32XN_FOURS(m[0], m[2], 0, 4, 16, 20), cd = F32XN_FOURS(m[4], m[6], 0, 4, 16, 20);
    f32xN ab1 = F32XN_FOURS(m[1], m[3], 0, 4, 16, 20), cd1 = F32XN_FOURS(m[5], m[7], 0, 4, 16, 20);
    f32xN_columns r = {{{F32XN_FOURS(ab, cd, 0, 8, 16, 24)}},
                       {{F32XN_FOURS(ab, cd, 3, 11, 19, 27)}},
                       {{F32XN_SHUFFLE(ab1, cd1, 5, 6, 7, 7, 13, 14, 15, 15, 21, 22, 23, 23, 29, 30, 31, 31)}},
                       {{{0.0f}}}};
#endif
    return r;
}

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

#if F32XN == 1
static inline f32xN_vectors f32xN_vectors_of(const float *v)
{
    f32xN_vectors r = {v[0], v[1], v[2]};
    return r;
}
#else
static inline f32xN_vectors f32xN_vectors_of(f32xN v)
{
    f32xN_vectors r = {f32xN_broadcast(v, 0), f32xN_broadcast(v, 1), f32xN_broadcast(v, 2)};
    return r;
}
#endif

/* The vectors of a group, at every `stride` bytes; reads the four bytes after each too. */
static inline f32xN_vectors f32xN_read3(const unsigned char *p, size_t stride)
{
#if F32XN == 1
    float v[3];
    (void)stride;
    memcpy(v, p, sizeof v);
    return f32xN_vectors_of(v);
#elif F32XN == 4
    (void)stride;
    return f32xN_vectors_of(f32x4_load(p));
#elif F32XN == 8
    return f32xN_vectors_of(F32XN_SHUFFLE(f32x4_load(p), f32x4_load(p + stride), 0, 1, 2, 3, 4, 5, 6, 7));
#else
    const f32x8 a = F32XN_SHUFFLE(f32x4_load(p), f32x4_load(p + stride), 0, 1, 2, 3, 4, 5, 6, 7);
    const f32x8 b = F32XN_SHUFFLE(f32x4_load(p + 2 * stride), f32x4_load(p + 3 * stride), 0, 1, 2, 3, 4, 5, 6, 7);
    return f32xN_vectors_of(F32XN_FOURS(a, b, 0, 4, 8, 12));
#endif
}

/* The first n vectors of a group, the last of them in the places of the others; reads nothing else. */
static inline f32xN_vectors f32xN_read3_first(const unsigned char *p, size_t stride, size_t n)
{
#if F32XN == 1
    (void)n;
    return f32xN_read3(p, stride);
#elif F32XN == 4
    (void)stride, (void)n;
    return f32xN_vectors_of(f32x4_load3(p));
#elif F32XN == 8
    return f32xN_vectors_of(
        F32XN_SHUFFLE(f32x4_load3(p), f32x4_load3(p + (n > 1 ? stride : 0)), 0, 1, 2, 3, 4, 5, 6, 7));
#else
    const unsigned char *q = p + (n > 1 ? stride : 0), *r = p + (n > 2 ? 2 : n - 1) * stride, *s = p + (n - 1) * stride;
    const f32x8 a = F32XN_SHUFFLE(f32x4_load3(p), f32x4_load3(q), 0, 1, 2, 3, 4, 5, 6, 7);
    const f32x8 b = F32XN_SHUFFLE(f32x4_load3(r), f32x4_load3(s), 0, 1, 2, 3, 4, 5, 6, 7);
    return f32xN_vectors_of(F32XN_FOURS(a, b, 0, 4, 8, 12));
#endif
}

/* The same of contiguous vectors; reads the four bytes after the group where F32XN is 4. */
static inline f32xN_vectors f32xN_read3_packed(const unsigned char *p)
{
#if F32XN == 8
    /* x0 y0 z0 x1, z0 x1 y1 z1 */
    const f32xN v = F32XN_SHUFFLE(f32x4_load(p), f32x4_load(p + 8), 0, 1, 2, 3, 4, 5, 6, 7);
    f32xN_vectors r = {F32XN_SHUFFLE(v, v, 0, 0, 0, 0, 5, 5, 5, 5), F32XN_SHUFFLE(v, v, 1, 1, 1, 1, 6, 6, 6, 6),
                       F32XN_SHUFFLE(v, v, 2, 2, 2, 2, 7, 7, 7, 7)};
    return r;
#elif F32XN == 16
    const f32x4 c = f32x4_load(p + 32);
    const f32x8 b = F32XN_SHUFFLE(c, c, 0, 1, 2, 3, 0, 1, 2, 3);
    f32x8 a;
    memcpy(&a, p, sizeof a);
    const f32xN v = F32XN_SHUFFLE(a, b, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    f32xN_vectors r = {F32XN_SHUFFLE(v, v, 0, 0, 0, 0, 3, 3, 3, 3, 6, 6, 6, 6, 9, 9, 9, 9),
                       F32XN_SHUFFLE(v, v, 1, 1, 1, 1, 4, 4, 4, 4, 7, 7, 7, 7, 10, 10, 10, 10),
                       F32XN_SHUFFLE(v, v, 2, 2, 2, 2, 5, 5, 5, 5, 8, 8, 8, 8, 11, 11, 11, 11)};
    return r;
#else
    return f32xN_read3(p, 3 * sizeof(float));
#endif
}

/* The first three floats of each four, to every `stride` bytes. */
static inline void f32xN_write3(unsigned char *p, size_t stride, f32xN_column a)
{
#if F32XN == 1
    const float v[3] = {a.row[0], a.row[1], a.row[2]};
    (void)stride;
    memcpy(p, v, sizeof v);
#elif F32XN == 4
    (void)stride;
    f32x4_store3(p, a.row[0]);
#else
    const f32xN v = a.row[0];
    f32x4_store3(p, F32XN_SHUFFLE(v, v, 0, 1, 2, 3));
    f32x4_store3(p + stride, F32XN_SHUFFLE(v, v, 4, 5, 6, 7));
#if F32XN == 16
    f32x4_store3(p + 2 * stride, F32XN_SHUFFLE(v, v, 8, 9, 10, 11));
    f32x4_store3(p + 3 * stride, F32XN_SHUFFLE(v, v, 12, 13, 14, 15));
#endif
#endif
}

/* The same, contiguous. */
static inline void f32xN_write3_packed(unsigned char *p, f32xN_column a)
{
#if F32XN == 8
    f32x4_store(p, F32XN_SHUFFLE(a.row[0], a.row[0], 0, 1, 2, 4));
    f32x4_store(p + 8, F32XN_SHUFFLE(a.row[0], a.row[0], 2, 4, 5, 6));
#elif F32XN == 16
    const f32xN v = a.row[0];
    const f32x8 low = F32XN_SHUFFLE(v, v, 0, 1, 2, 4, 5, 6, 8, 9);
    memcpy(p, &low, sizeof low);
    f32x4_store(p + sizeof low, F32XN_SHUFFLE(v, v, 10, 12, 13, 14));
#else
    f32xN_write3(p, 3 * sizeof(float), a);
#endif
}

/*
 * Second text of nkw_mat4_transform_point and nkw_mat4_transform_direction; 3.3 times faster.
 *
 * M p of each matrix and its point.
 */
static inline f32xN_column f32xN_transform_point(f32xN_columns m, f32xN_vectors p)
{
    f32xN_column r;
    for (int i = 0; i < F32XN_ROWS; i++)
        r.row[i] = (m.x.row[i] * p.x + m.y.row[i] * p.y) + (m.z.row[i] * p.z + m.t.row[i]);
    return r;
}

/* M d of each matrix and its direction: without the translation. */
static inline f32xN_column f32xN_transform_direction(f32xN_columns m, f32xN_vectors d)
{
    f32xN_column r;
    for (int i = 0; i < F32XN_ROWS; i++)
        r.row[i] = (m.x.row[i] * d.x + m.y.row[i] * d.y) + m.z.row[i] * d.z;
    return r;
}

#endif
