/* SPDX-License-Identifier: MIT */
/* Registers of 16 floats: a group is four matrices. See columns.h. */
#ifndef NAKAWARI_PACK_COLUMNS16_H
#define NAKAWARI_PACK_COLUMNS16_H

typedef float f32x8 __attribute__((vector_size(32)));

/* F32XN_EACH(a, b, i, j, k, l): these four of each four floats of a; from 16 on those of b. */
#define F32XN_SHUFFLE(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#define F32XN_EACH(a, b, i, j, k, l)                                                                                   \
    F32XN_SHUFFLE(a, b, i, j, k, l, 4 + (i), 4 + (j), 4 + (k), 4 + (l), 8 + (i), 8 + (j), 8 + (k), 8 + (l), 12 + (i),  \
                  12 + (j), 12 + (k), 12 + (l))
/* The fours that begin at i, j, k, l. */
#define F32XN_FOURS(a, b, i, j, k, l)                                                                                  \
    F32XN_SHUFFLE(a, b, i, i + 1, i + 2, i + 3, j, j + 1, j + 2, j + 3, k, k + 1, k + 2, k + 3, l, l + 1, l + 2, l + 3)

#define f32xN_broadcast(a, i) F32XN_EACH(a, a, i, i, i, i)

static inline void f32xN_transpose(f32xN m[4])
{
    f32xN a = F32XN_EACH(m[0], m[1], 0, 16, 1, 17), b = F32XN_EACH(m[2], m[3], 0, 16, 1, 17);
    f32xN c = F32XN_EACH(m[0], m[1], 2, 18, 3, 19), d = F32XN_EACH(m[2], m[3], 2, 18, 3, 19);
    m[0] = F32XN_EACH(a, b, 0, 1, 16, 17);
    m[1] = F32XN_EACH(a, b, 2, 3, 18, 19);
    m[2] = F32XN_EACH(c, d, 0, 1, 16, 17);
    m[3] = F32XN_EACH(c, d, 2, 3, 18, 19);
}

static inline void f32xN_scatter(f32xN m[4], int count, unsigned char *const *to, size_t offset)
{
    f32xN_transpose(m);
    for (int k = 0; k < 4; k++) {
        const f32x4 fours[4] = {F32XN_SHUFFLE(m[k], m[k], 0, 1, 2, 3), F32XN_SHUFFLE(m[k], m[k], 4, 5, 6, 7),
                                F32XN_SHUFFLE(m[k], m[k], 8, 9, 10, 11), F32XN_SHUFFLE(m[k], m[k], 12, 13, 14, 15)};
        for (int g = 0; g < 4; g++)
            if (count == 4)
                f32x4_store(to[4 * g + k] + offset, fours[g]);
            else
                f32x4_store3(to[4 * g + k] + offset, fours[g]);
    }
}

static inline f32xN f32xN_load8(const void *from)
{
    f32x8 a;
    memcpy(&a, from, sizeof a);
    return F32XN_SHUFFLE(a, a, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7);
}

static inline void f32xN_store8(void *to, f32xN a)
{
    const f32x8 half = F32XN_SHUFFLE(a, a, 0, 1, 2, 3, 4, 5, 6, 7);
    memcpy(to, &half, sizeof half);
}

static inline f32xN_columns f32xN_columns_of(const f32xN *m)
{
    f32xN xy0 = F32XN_FOURS(m[0], m[1], 0, 4, 16, 20), xy1 = F32XN_FOURS(m[2], m[3], 0, 4, 16, 20);
    f32xN zt0 = F32XN_FOURS(m[0], m[1], 8, 12, 24, 28), zt1 = F32XN_FOURS(m[2], m[3], 8, 12, 24, 28);
    f32xN_columns r = {{{F32XN_FOURS(xy0, xy1, 0, 8, 16, 24)}},
                       {{F32XN_FOURS(xy0, xy1, 4, 12, 20, 28)}},
                       {{F32XN_FOURS(zt0, zt1, 0, 8, 16, 24)}},
                       {{F32XN_FOURS(zt0, zt1, 4, 12, 20, 28)}}};
    return r;
}

static inline f32xN_columns f32xN_columns_of3(const f32xN *m)
{
    /* a0..a7 b0..b7, c0..c7 d0..d7, a1..a8 b1..b8, c1..c8 d1..d8 */
    f32xN ab = F32XN_FOURS(m[0], m[2], 0, 4, 16, 20), cd = F32XN_FOURS(m[4], m[6], 0, 4, 16, 20);
    f32xN ab1 = F32XN_FOURS(m[1], m[3], 0, 4, 16, 20), cd1 = F32XN_FOURS(m[5], m[7], 0, 4, 16, 20);
    f32xN_columns r = {{{F32XN_FOURS(ab, cd, 0, 8, 16, 24)}},
                       {{F32XN_FOURS(ab, cd, 3, 11, 19, 27)}},
                       {{F32XN_SHUFFLE(ab1, cd1, 5, 6, 7, 7, 13, 14, 15, 15, 21, 22, 23, 23, 29, 30, 31, 31)}},
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
    const f32x8 a = F32XN_SHUFFLE(f32x4_load(p), f32x4_load(p + stride), 0, 1, 2, 3, 4, 5, 6, 7);
    const f32x8 b = F32XN_SHUFFLE(f32x4_load(p + 2 * stride), f32x4_load(p + 3 * stride), 0, 1, 2, 3, 4, 5, 6, 7);
    return f32xN_vectors_of(F32XN_FOURS(a, b, 0, 4, 8, 12));
}

static inline f32xN_vectors f32xN_read3_first(const unsigned char *p, size_t stride, size_t n)
{
    const unsigned char *q = p + (n > 1 ? stride : 0), *r = p + (n > 2 ? 2 : n - 1) * stride, *s = p + (n - 1) * stride;
    const f32x8 a = F32XN_SHUFFLE(f32x4_load3(p), f32x4_load3(q), 0, 1, 2, 3, 4, 5, 6, 7);
    const f32x8 b = F32XN_SHUFFLE(f32x4_load3(r), f32x4_load3(s), 0, 1, 2, 3, 4, 5, 6, 7);
    return f32xN_vectors_of(F32XN_FOURS(a, b, 0, 4, 8, 12));
}

static inline f32xN_vectors f32xN_read3_packed(const unsigned char *p)
{
    const f32x4 c = f32x4_load(p + 32);
    const f32x8 b = F32XN_SHUFFLE(c, c, 0, 1, 2, 3, 0, 1, 2, 3);
    f32x8 a;
    memcpy(&a, p, sizeof a);
    const f32xN v = F32XN_SHUFFLE(a, b, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    f32xN_vectors r = {F32XN_SHUFFLE(v, v, 0, 0, 0, 0, 3, 3, 3, 3, 6, 6, 6, 6, 9, 9, 9, 9),
                       F32XN_SHUFFLE(v, v, 1, 1, 1, 1, 4, 4, 4, 4, 7, 7, 7, 7, 10, 10, 10, 10),
                       F32XN_SHUFFLE(v, v, 2, 2, 2, 2, 5, 5, 5, 5, 8, 8, 8, 8, 11, 11, 11, 11)};
    return r;
}

static inline void f32xN_write3(unsigned char *p, size_t stride, f32xN_column a)
{
    const f32xN v = a.row[0];
    f32x4_store3(p, F32XN_SHUFFLE(v, v, 0, 1, 2, 3));
    f32x4_store3(p + stride, F32XN_SHUFFLE(v, v, 4, 5, 6, 7));
    f32x4_store3(p + 2 * stride, F32XN_SHUFFLE(v, v, 8, 9, 10, 11));
    f32x4_store3(p + 3 * stride, F32XN_SHUFFLE(v, v, 12, 13, 14, 15));
}

static inline void f32xN_write3_packed(unsigned char *p, f32xN_column a)
{
    const f32xN v = a.row[0];
    const f32x8 low = F32XN_SHUFFLE(v, v, 0, 1, 2, 4, 5, 6, 8, 9);
    memcpy(p, &low, sizeof low);
    f32x4_store(p + sizeof low, F32XN_SHUFFLE(v, v, 10, 12, 13, 14));
}

#endif
