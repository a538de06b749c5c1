/* SPDX-License-Identifier: MIT */
/* One float a register: the compiler has no vector type. A group is one matrix, a row one register. See columns.h. */
#ifndef NAKAWARI_PACK_COLUMNS1_H
#define NAKAWARI_PACK_COLUMNS1_H

#define f32xN_broadcast(a, i) (a)

static inline void f32xN_transpose(f32xN m[4])
{
    (void)m;
}

static inline void f32xN_scatter(f32xN m[4], int count, unsigned char *const *to, size_t offset)
{
    f32xN_transpose(m);
    memcpy(to[0] + offset, m, (size_t)count * sizeof *m);
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
    f32xN_columns r = {{{m[0], m[1], m[2], m[3]}},
                       {{m[4], m[5], m[6], m[7]}},
                       {{m[8], m[9], m[10], m[11]}},
                       {{m[12], m[13], m[14], m[15]}}};
    return r;
}

static inline f32xN_columns f32xN_columns_of3(const f32xN *m)
{
    f32xN_columns r = {{{m[0], m[1], m[2], 0.0f}}, {{m[3], m[4], m[5], 0.0f}}, {{m[6], m[7], m[8], 0.0f}}, {{0.0f}}};
    return r;
}

static inline f32xN_column f32xN_next(f32xN_column a)
{
    f32xN_column r = {{a.row[1], a.row[2], a.row[0], 0.0f}};
    return r;
}

static inline f32xN_vectors f32xN_vectors_of(const float *v)
{
    f32xN_vectors r = {v[0], v[1], v[2]};
    return r;
}

static inline f32xN_vectors f32xN_read3(const unsigned char *p, size_t stride)
{
    float v[3];
    (void)stride;
    memcpy(v, p, sizeof v);
    return f32xN_vectors_of(v);
}

static inline f32xN_vectors f32xN_read3_first(const unsigned char *p, size_t stride, size_t n)
{
    (void)n;
    return f32xN_read3(p, stride);
}

static inline f32xN_vectors f32xN_read3_packed(const unsigned char *p)
{
    return f32xN_read3(p, 3 * sizeof(float));
}

static inline void f32xN_write3(unsigned char *p, size_t stride, f32xN_column a)
{
    const float v[3] = {a.row[0], a.row[1], a.row[2]};
    (void)stride;
    memcpy(p, v, sizeof v);
}

static inline void f32xN_write3_packed(unsigned char *p, f32xN_column a)
{
    f32xN_write3(p, 3 * sizeof(float), a);
}

#endif
