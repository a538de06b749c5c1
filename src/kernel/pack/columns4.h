/* SPDX-License-Identifier: MIT */
/* Registers of 4 floats: a group is one matrix. See columns.h. */
#ifndef NAKAWARI_PACK_COLUMNS4_H
#define NAKAWARI_PACK_COLUMNS4_H

#define f32xN_broadcast(a, i) f32x4_broadcast(a, i)

static inline void f32xN_transpose(f32xN m[4])
{
    f32x4_transpose(m);
}

static inline void f32xN_scatter(f32xN m[4], int count, unsigned char *const *to, size_t offset)
{
    f32xN_transpose(m);
    for (int k = 0; k < 4; k++) {
        const f32x4 fours[1] = {m[k]};
        for (int g = 0; g < 1; g++)
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
    f32xN_columns r = {{{m[0]}}, {{m[1]}}, {{m[2]}}, {{m[3]}}};
    return r;
}

static inline f32xN_columns f32xN_columns_of3(const f32xN *m)
{
    f32xN_columns r = {
        {{m[0]}}, {{F32X4_SHUFFLE(m[0], m[1], 3, 4, 5, 6)}}, {{F32X4_SHUFFLE(m[2], m[2], 1, 2, 3, 3)}}, {{{0.0f}}}};
    return r;
}

static inline f32xN_column f32xN_next(f32xN_column a)
{
    f32xN_column r = {{F32X4_SHUFFLE(a.row[0], a.row[0], 1, 2, 0, 3)}};
    return r;
}

static inline f32xN_vectors f32xN_vectors_of(f32xN v)
{
    f32xN_vectors r = {f32xN_broadcast(v, 0), f32xN_broadcast(v, 1), f32xN_broadcast(v, 2)};
    return r;
}

static inline f32xN_vectors f32xN_read3(const unsigned char *p, size_t stride)
{
    (void)stride;
    return f32xN_vectors_of(f32x4_load(p));
}

static inline f32xN_vectors f32xN_read3_first(const unsigned char *p, size_t stride, size_t n)
{
    (void)stride, (void)n;
    return f32xN_vectors_of(f32x4_load3(p));
}

static inline f32xN_vectors f32xN_read3_packed(const unsigned char *p)
{
    return f32xN_read3(p, 3 * sizeof(float));
}

static inline void f32xN_write3(unsigned char *p, size_t stride, f32xN_column a)
{
    (void)stride;
    f32x4_store3(p, a.row[0]);
}

static inline void f32xN_write3_packed(unsigned char *p, f32xN_column a)
{
    f32xN_write3(p, 3 * sizeof(float), a);
}

#endif
