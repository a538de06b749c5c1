/* SPDX-License-Identifier: MIT */
/* Registers of 8 floats: a group is two matrices. See columns.h. */
#ifndef NAKAWARI_PACK_COLUMNS8_H
#define NAKAWARI_PACK_COLUMNS8_H

typedef float f32x8 __attribute__((vector_size(32)));

/* F32XN_EACH(a, b, i, j, k, l): these four of each four floats of a; from 8 on those of b. */
#define F32XN_SHUFFLE(a, b, ...)     __builtin_shufflevector(a, b, __VA_ARGS__)
#define F32XN_EACH(a, b, i, j, k, l) F32XN_SHUFFLE(a, b, i, j, k, l, 4 + (i), 4 + (j), 4 + (k), 4 + (l))

#define f32xN_broadcast(a, i) F32XN_EACH(a, a, i, i, i, i)

static inline void f32xN_transpose(f32xN m[4])
{
    f32xN a = F32XN_EACH(m[0], m[1], 0, 8, 1, 9), b = F32XN_EACH(m[2], m[3], 0, 8, 1, 9);
    f32xN c = F32XN_EACH(m[0], m[1], 2, 10, 3, 11), d = F32XN_EACH(m[2], m[3], 2, 10, 3, 11);
    m[0] = F32XN_EACH(a, b, 0, 1, 8, 9);
    m[1] = F32XN_EACH(a, b, 2, 3, 10, 11);
    m[2] = F32XN_EACH(c, d, 0, 1, 8, 9);
    m[3] = F32XN_EACH(c, d, 2, 3, 10, 11);
}

static inline void f32xN_scatter(f32xN m[4], int count, unsigned char *const *to, size_t offset)
{
    f32xN_transpose(m);
    for (int k = 0; k < 4; k++) {
        const f32x4 fours[2] = {F32XN_SHUFFLE(m[k], m[k], 0, 1, 2, 3), F32XN_SHUFFLE(m[k], m[k], 4, 5, 6, 7)};
        for (int g = 0; g < 2; g++)
            if (count == 4)
                f32x4_store(to[4 * g + k] + offset, fours[g]);
            else
                f32x4_store3(to[4 * g + k] + offset, fours[g]);
    }
}

static inline f32xN f32xN_load8(const void *from)
{
    return f32xN_load(from);
}

static inline void f32xN_store8(void *to, f32xN a)
{
    f32xN_store(to, a);
}

static inline f32xN_columns f32xN_columns_of(const f32xN *m)
{
    f32xN_columns r = {{{F32XN_SHUFFLE(m[0], m[2], 0, 1, 2, 3, 8, 9, 10, 11)}},
                       {{F32XN_SHUFFLE(m[0], m[2], 4, 5, 6, 7, 12, 13, 14, 15)}},
                       {{F32XN_SHUFFLE(m[1], m[3], 0, 1, 2, 3, 8, 9, 10, 11)}},
                       {{F32XN_SHUFFLE(m[1], m[3], 4, 5, 6, 7, 12, 13, 14, 15)}}};
    return r;
}

static inline f32xN_columns f32xN_columns_of3(const f32xN *m)
{
    f32xN_columns r = {{{F32XN_SHUFFLE(m[0], m[2], 0, 1, 2, 3, 8, 9, 10, 11)}},
                       {{F32XN_SHUFFLE(m[0], m[2], 3, 4, 5, 6, 11, 12, 13, 14)}},
                       {{F32XN_SHUFFLE(m[1], m[3], 5, 6, 7, 7, 13, 14, 15, 15)}},
                       {{{0.0f}}}};
    return r;
}

static inline f32xN_column f32xN_next(f32xN_column a)
{
    f32xN_column r = {{F32XN_EACH(a.row[0], a.row[0], 1, 2, 0, 3)}};
    return r;
}

static inline f32xN_vectors f32xN_vectors_of(f32xN v)
{
    f32xN_vectors r = {f32xN_broadcast(v, 0), f32xN_broadcast(v, 1), f32xN_broadcast(v, 2)};
    return r;
}

static inline f32xN_vectors f32xN_read3(const unsigned char *p, size_t stride)
{
    return f32xN_vectors_of(F32XN_SHUFFLE(f32x4_load(p), f32x4_load(p + stride), 0, 1, 2, 3, 4, 5, 6, 7));
}

static inline f32xN_vectors f32xN_read3_first(const unsigned char *p, size_t stride, size_t n)
{
    return f32xN_vectors_of(
        F32XN_SHUFFLE(f32x4_load3(p), f32x4_load3(p + (n > 1 ? stride : 0)), 0, 1, 2, 3, 4, 5, 6, 7));
}

static inline f32xN_vectors f32xN_read3_packed(const unsigned char *p)
{
    /* x0 y0 z0 x1, z0 x1 y1 z1 */
    const f32xN v = F32XN_SHUFFLE(f32x4_load(p), f32x4_load(p + 8), 0, 1, 2, 3, 4, 5, 6, 7);
    f32xN_vectors r = {F32XN_SHUFFLE(v, v, 0, 0, 0, 0, 5, 5, 5, 5), F32XN_SHUFFLE(v, v, 1, 1, 1, 1, 6, 6, 6, 6),
                       F32XN_SHUFFLE(v, v, 2, 2, 2, 2, 7, 7, 7, 7)};
    return r;
}

static inline void f32xN_write3(unsigned char *p, size_t stride, f32xN_column a)
{
    const f32xN v = a.row[0];
    f32x4_store3(p, F32XN_SHUFFLE(v, v, 0, 1, 2, 3));
    f32x4_store3(p + stride, F32XN_SHUFFLE(v, v, 4, 5, 6, 7));
}

static inline void f32xN_write3_packed(unsigned char *p, f32xN_column a)
{
    f32x4_store(p, F32XN_SHUFFLE(a.row[0], a.row[0], 0, 1, 2, 4));
    f32x4_store(p + 8, F32XN_SHUFFLE(a.row[0], a.row[0], 2, 4, 5, 6));
}

#endif
