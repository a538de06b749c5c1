/* SPDX-License-Identifier: MIT */
/* The small algebra of mat.h, once: inlined into the caller, and compiled into the library as symbols. */
#ifndef NAKAWARI_INLINE_MAT_H
#define NAKAWARI_INLINE_MAT_H

#include <string.h>

#include "../mat.h"

/*
 * A column of a 4x4 matrix, in a register where the compiler has such: at once in one load, or float by float in
 * loops. NKW_COLUMN(r, f) is r = f, where f is a formula of terms NKW_TERM(a) = a, NKW_TIMES(a, s) = a s for columns a
 * and floats s, and NKW_PRODUCT(a, b), float by float. NKW_COLUMN_MIX takes the floats i, j, k, l of a, from 4 on those
 * of b. NKW_COLUMN_END sets the last float, to 0 or 1.
 *
 * The library's loops go over many matrices instead, so there a column is four floats.
 */
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__)) && !defined(NKW_ISA) &&                           \
    (!defined(NKW_FUSES) || defined(__FMA__) || defined(__FMA4__) || defined(__aarch64__))
typedef float nkw_column __attribute__((vector_size(16)));
typedef int nkw_column_bits __attribute__((vector_size(16)));
#define NKW_COLUMN(r, formula) ((void)(r = (formula)))
#define NKW_COLUMN_LOAD(r, from) memcpy(&r, from, sizeof r)
#define NKW_COLUMN_STORE(to, r) memcpy(to, &r, sizeof r)
#if defined(__clang__)
#define NKW_COLUMN_MIX(r, a, b, i, j, k, l) ((void)(r = __builtin_shufflevector(a, b, i, j, k, l)))
#else
#define NKW_COLUMN_MIX(r, a, b, i, j, k, l)                                                                            \
    ((void)(r = __builtin_shuffle(a, b, __extension__(nkw_column_bits){i, j, k, l})))
#endif
#if defined(__SSE4_1__)
#define NKW_COLUMN_END(r, one)                                                                                         \
    do {                                                                                                               \
        const nkw_column last = {0.0f, 0.0f, 0.0f, (one) ? 1.0f : 0.0f};                                               \
        NKW_COLUMN_MIX(r, r, last, 0, 1, 2, 7);                                                                        \
    } while (0)
#else
#define NKW_COLUMN_END(r, one)                                                                                         \
    do {                                                                                                               \
        const nkw_column_bits keep = {-1, -1, -1, 0}, last = {0, 0, 0, (one) ? 0x3f800000 : 0};                        \
        r = (nkw_column)(((nkw_column_bits)r & keep) | last);                                                          \
    } while (0)
#endif
#define NKW_TERM(a) (a)
#define NKW_ALL(s) (__extension__(nkw_column){s, s, s, s})
#if !defined(NKW_FUSES)
#define NKW_TIMES(a, s) ((a) * (s))
#define NKW_PRODUCT(a, b) ((a) * (b))
#else
#if defined(__aarch64__)
#define NKW_PRODUCT(a, b) __builtin_aarch64_fmav4sf(a, b, NKW_ALL(-0.0f))
#else
#define NKW_PRODUCT(a, b) __builtin_ia32_vfmaddps(a, b, NKW_ALL(-0.0f))
#endif
#define NKW_TIMES(a, s) NKW_PRODUCT(a, NKW_ALL(s))
#endif
#else
typedef float nkw_column[4];
#define NKW_COLUMN_EACH(statement)                                                                                     \
    do {                                                                                                               \
        for (size_t row = 0; row < 4; row++)                                                                           \
            statement;                                                                                                 \
    } while (0)
#define NKW_COLUMN(r, formula) NKW_COLUMN_EACH((r)[row] = (formula))
#define NKW_COLUMN_END(r, one) ((void)((r)[3] = (one) ? 1.0f : 0.0f))
#define NKW_COLUMN_LOAD(r, from) NKW_COLUMN_EACH((r)[row] = (from)[row])
#define NKW_COLUMN_STORE(to, r) NKW_COLUMN_EACH((to)[row] = (r)[row])
#define NKW_COLUMN_PICK(a, b, i) ((i) < 4 ? (a)[(i) & 3] : (b)[(i) & 3])
#define NKW_COLUMN_MIX(r, a, b, i, j, k, l)                                                                            \
    do {                                                                                                               \
        const float mix[4] = {NKW_COLUMN_PICK(a, b, i), NKW_COLUMN_PICK(a, b, j), NKW_COLUMN_PICK(a, b, k),            \
                              NKW_COLUMN_PICK(a, b, l)};                                                               \
        NKW_COLUMN_EACH((r)[row] = mix[row]);                                                                          \
    } while (0)
#define NKW_TERM(a) ((a)[row])
#define NKW_TIMES(a, s) NKW_MUL((a)[row], s)
#define NKW_PRODUCT(a, b) NKW_MUL((a)[row], (b)[row])
#endif

/*
 * Two columns in one register, for products. NKW_PAIR_COPIES(x, y, from) makes x the first of the two columns from, y
 * the second, each twice; NKW_PAIR_TIMES(a, b, i) takes either column of a times the number i of that of b. Matrices
 * are stored by pairs too: a load of two columns that were stored one by one would wait.
 */
#if defined(NKW_ALL) && defined(__AVX__) && defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define NKW_PAIRS
#endif
#endif
#if defined(NKW_PAIRS)
typedef float nkw_pair __attribute__((vector_size(32)));
#define NKW_PAIR_MIX(a, b, i, j, k, l, m, n, o, p) __builtin_shufflevector(a, b, i, j, k, l, m, n, o, p)
#define NKW_PAIR_STORE(to, x, y)                                                                                       \
    do {                                                                                                               \
        const nkw_pair both = NKW_PAIR_MIX(x, y, 0, 1, 2, 3, 4, 5, 6, 7);                                              \
        NKW_COLUMN_STORE(to, both);                                                                                    \
    } while (0)
#if !defined(NKW_FUSES)
#define NKW_PAIR_PRODUCT(a, b) ((a) * (b))
#else
#define NKW_PAIR_PRODUCT(a, b)                                                                                         \
    __builtin_ia32_vfmaddps256(                                                                                        \
        a, b, (__extension__(nkw_pair){-0.0f, -0.0f, -0.0f, -0.0f, -0.0f, -0.0f, -0.0f, -0.0f}))
#endif
#define NKW_PAIR_TIMES(a, b, i)                                                                                        \
    NKW_PAIR_PRODUCT(a, NKW_PAIR_MIX(b, b, i, i, i, i, (i) + 4, (i) + 4, (i) + 4, (i) + 4))
#define NKW_PAIR_COPIES(x, y, from)                                                                                    \
    do {                                                                                                               \
        NKW_COLUMN_LOAD(x, from);                                                                                      \
        y = NKW_PAIR_MIX(x, x, 4, 5, 6, 7, 4, 5, 6, 7);                                                                \
        x = NKW_PAIR_MIX(x, x, 0, 1, 2, 3, 0, 1, 2, 3);                                                                \
    } while (0)
/* a, but for the last number of each column: those of b. */
#define NKW_PAIR_END(a, b) NKW_PAIR_MIX(a, b, 0, 1, 2, 11, 4, 5, 6, 15)
#else
#define NKW_PAIR_STORE(to, x, y)                                                                                       \
    do {                                                                                                               \
        NKW_COLUMN_STORE(to, x);                                                                                       \
        NKW_COLUMN_STORE((to) + 4, y);                                                                                 \
    } while (0)
#endif

/* The columns x, y, z, t of a 4x4 matrix. */
#define NKW_COLUMNS_LOAD(x, y, z, t, from)                                                                             \
    do {                                                                                                               \
        NKW_COLUMN_LOAD(x, (from)->m);                                                                                 \
        NKW_COLUMN_LOAD(y, (from)->m + 4);                                                                             \
        NKW_COLUMN_LOAD(z, (from)->m + 8);                                                                             \
        NKW_COLUMN_LOAD(t, (from)->m + 12);                                                                            \
    } while (0)
#define NKW_COLUMNS_STORE(to, x, y, z, t)                                                                              \
    do {                                                                                                               \
        NKW_PAIR_STORE((to)->m, x, y);                                                                                 \
        NKW_PAIR_STORE((to)->m + 8, z, t);                                                                             \
    } while (0)

#ifdef __cplusplus
extern "C" {
#endif

NKW_BODY nkw_mat3 nkw_mat3_identity(void)
{
    nkw_mat3 r = {{1, 0, 0, 0, 1, 0, 0, 0, 1}};
    return r;
}

NKW_BODY nkw_mat3 nkw_mat3_from_columns(nkw_vec3 x, nkw_vec3 y, nkw_vec3 z)
{
    nkw_mat3 r = {{x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z}};
    return r;
}

NKW_BODY nkw_vec3 nkw_mat3_column(const nkw_mat3 *m, size_t c)
{
    size_t k = c < 3 ? c * 3 : 0;
    nkw_vec3 r = {m->m[k], m->m[k + 1], m->m[k + 2]};
    return r;
}

NKW_BODY nkw_mat3 nkw_mat3_from_mat4(const nkw_mat4 *m)
{
    const float *a = m->m;
    nkw_mat3 r = {{a[0], a[1], a[2], a[4], a[5], a[6], a[8], a[9], a[10]}};
    return r;
}

NKW_BODY nkw_mat3 nkw_mat3_transpose(const nkw_mat3 *m)
{
    const float *a = m->m;
    nkw_mat3 r = {{a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8]}};
    return r;
}

NKW_BODY nkw_mat3 nkw_mat3_mul(const nkw_mat3 *a, const nkw_mat3 *b)
{
    NKW_EXACT
    nkw_mat3 r;
    const float *p = a->m;
    for (size_t c = 0; c < 9; c += 3) {
        float u = b->m[c], v = b->m[c + 1], w = b->m[c + 2];
        for (size_t i = 0; i < 3; i++)
            r.m[c + i] = (NKW_MUL(p[i], u) + NKW_MUL(p[3 + i], v)) + NKW_MUL(p[6 + i], w);
    }
    return r;
}

NKW_BODY nkw_vec3 nkw_mat3_transform(const nkw_mat3 *m, nkw_vec3 v)
{
    NKW_EXACT
    const float *a = m->m;
    nkw_vec3 r = {
        (NKW_MUL(a[0], v.x) + NKW_MUL(a[3], v.y)) + NKW_MUL(a[6], v.z),
        (NKW_MUL(a[1], v.x) + NKW_MUL(a[4], v.y)) + NKW_MUL(a[7], v.z),
        (NKW_MUL(a[2], v.x) + NKW_MUL(a[5], v.y)) + NKW_MUL(a[8], v.z),
    };
    return r;
}

NKW_BODY nkw_mat3 nkw_mat3_from_quat(nkw_quat q)
{
    NKW_EXACT
    float x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
    float xx = NKW_MUL(q.x, q.x), yy = NKW_MUL(q.y, q.y), zz = NKW_MUL(q.z, q.z), ww = NKW_MUL(q.w, q.w);
    float xy = NKW_MUL(q.x, y2), yz = NKW_MUL(q.y, z2), zx = NKW_MUL(q.z, x2);
    float wx = NKW_MUL(q.w, x2), wy = NKW_MUL(q.w, y2), wz = NKW_MUL(q.w, z2);
    nkw_mat3 r = {{
        (ww - yy) + (xx - zz), xy + wz, zx - wy,
        xy - wz, (ww - zz) + (yy - xx), yz + wx,
        zx + wy, yz - wx, (ww - xx) + (zz - yy),
    }};
    return r;
}

NKW_BODY nkw_mat4 nkw_mat4_identity(void)
{
    nkw_mat4 r = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
    return r;
}

NKW_BODY nkw_mat4 nkw_mat4_from_mat3(const nkw_mat3 *m, nkw_vec3 translation)
{
    const float *a = m->m;
    /* One by one: from braces GCC clears it on the stack first. */
    nkw_mat4 r;
    r.m[0] = a[0], r.m[1] = a[1], r.m[2] = a[2], r.m[3] = 0.0f;
    r.m[4] = a[3], r.m[5] = a[4], r.m[6] = a[5], r.m[7] = 0.0f;
    r.m[8] = a[6], r.m[9] = a[7], r.m[10] = a[8], r.m[11] = 0.0f;
    r.m[12] = translation.x, r.m[13] = translation.y, r.m[14] = translation.z, r.m[15] = 1.0f;
    return r;
}

NKW_BODY nkw_mat4 nkw_mat4_from_quat(nkw_quat q)
{
    nkw_mat3 m = nkw_mat3_from_quat(q);
    nkw_vec3 origin = {0.0f, 0.0f, 0.0f};
    return nkw_mat4_from_mat3(&m, origin);
}

NKW_BODY nkw_vec3 nkw_mat4_translation(const nkw_mat4 *m)
{
    nkw_vec3 r = {m->m[12], m->m[13], m->m[14]};
    return r;
}

NKW_BODY nkw_mat4 nkw_mat4_transpose(const nkw_mat4 *m)
{
    nkw_mat4 r;
    for (size_t c = 0; c < 4; c++)
        for (size_t i = 0; i < 4; i++)
            r.m[c * 4 + i] = m->m[i * 4 + c];
    return r;
}

/* x b[0] + y b[1] + z b[2] + t b[3] for the columns x, y, z, t; and where b[3] is 0 or 1. */
#define NKW_WEIGHED(b) ((NKW_TIMES(x, (b)[0]) + NKW_TIMES(y, (b)[1])) + (NKW_TIMES(z, (b)[2]) + NKW_TIMES(t, (b)[3])))
#define NKW_WEIGHED_0(b) ((NKW_TIMES(x, (b)[0]) + NKW_TIMES(y, (b)[1])) + NKW_TIMES(z, (b)[2]))
#define NKW_WEIGHED_1(b) ((NKW_TIMES(x, (b)[0]) + NKW_TIMES(y, (b)[1])) + (NKW_TIMES(z, (b)[2]) + NKW_TERM(t)))

#if defined(NKW_PAIRS)

/* The same of pairs, sum by sum. */
#define NKW_PAIR_XY(b) (NKW_PAIR_TIMES(x, b, 0) + NKW_PAIR_TIMES(y, b, 1))
#define NKW_PAIR_Z(b)  NKW_PAIR_TIMES(z, b, 2)
#define NKW_PAIR_ZT(b) (NKW_PAIR_TIMES(z, b, 2) + NKW_PAIR_TIMES(t, b, 3))

NKW_BODY nkw_mat4 nkw_mat4_mul(const nkw_mat4 *a, const nkw_mat4 *b)
{
    NKW_EXACT
    nkw_pair x, y, z, t, u, w;
    NKW_PAIR_COPIES(x, y, a->m);
    NKW_PAIR_COPIES(z, t, a->m + 8);
    NKW_COLUMN_LOAD(u, b->m);
    NKW_COLUMN_LOAD(w, b->m + 8);
    u = NKW_PAIR_XY(u) + NKW_PAIR_ZT(u);
    w = NKW_PAIR_XY(w) + NKW_PAIR_ZT(w);
    nkw_mat4 r;
    NKW_COLUMN_STORE(r.m, u);
    NKW_COLUMN_STORE(r.m + 8, w);
    return r;
}

NKW_BODY nkw_mat4 nkw_mat4_mul_affine(const nkw_mat4 *a, const nkw_mat4 *b)
{
    NKW_EXACT
    const nkw_pair zeros = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f}, last = {0, 0, 0, 0, 0, 0, 0, 1.0f};
    const nkw_pair nothing = {-0.0f, -0.0f, -0.0f, -0.0f, 0.0f, 0.0f, 0.0f, 0.0f}; /* p + -0 is p */
    nkw_pair x, y, z, t, u, w;
    NKW_PAIR_COPIES(x, y, a->m);
    NKW_PAIR_COPIES(z, t, a->m + 8);
    NKW_COLUMN_LOAD(u, b->m);
    NKW_COLUMN_LOAD(w, b->m + 8);
    t = NKW_PAIR_MIX(nothing, t, 0, 1, 2, 3, 12, 13, 14, 15);
    u = NKW_PAIR_END(NKW_PAIR_XY(u) + NKW_PAIR_Z(u), zeros);
    w = NKW_PAIR_END(NKW_PAIR_XY(w) + (NKW_PAIR_Z(w) + t), last);
    nkw_mat4 r;
    NKW_COLUMN_STORE(r.m, u);
    NKW_COLUMN_STORE(r.m + 8, w);
    return r;
}

#else

NKW_BODY nkw_mat4 nkw_mat4_mul(const nkw_mat4 *a, const nkw_mat4 *b)
{
    NKW_EXACT
    nkw_column x, y, z, t, u, v, w, s;
    NKW_COLUMNS_LOAD(x, y, z, t, a);
    NKW_COLUMN(u, NKW_WEIGHED(b->m));
    NKW_COLUMN(v, NKW_WEIGHED(b->m + 4));
    NKW_COLUMN(w, NKW_WEIGHED(b->m + 8));
    NKW_COLUMN(s, NKW_WEIGHED(b->m + 12));
    nkw_mat4 r;
    NKW_COLUMNS_STORE(&r, u, v, w, s);
    return r;
}

NKW_BODY nkw_mat4 nkw_mat4_mul_affine(const nkw_mat4 *a, const nkw_mat4 *b)
{
    NKW_EXACT
    nkw_column x, y, z, t, u, v, w, s;
    NKW_COLUMNS_LOAD(x, y, z, t, a);
    NKW_COLUMN(u, NKW_WEIGHED_0(b->m));
    NKW_COLUMN(v, NKW_WEIGHED_0(b->m + 4));
    NKW_COLUMN(w, NKW_WEIGHED_0(b->m + 8));
    NKW_COLUMN(s, NKW_WEIGHED_1(b->m + 12));
    NKW_COLUMN_END(u, 0);
    NKW_COLUMN_END(v, 0);
    NKW_COLUMN_END(w, 0);
    NKW_COLUMN_END(s, 1);
    nkw_mat4 r;
    NKW_COLUMNS_STORE(&r, u, v, w, s);
    return r;
}

#endif

NKW_BODY nkw_mat4 nkw_mat4_inverse_rigid(const nkw_mat4 *m)
{
    NKW_EXACT
    const nkw_column none = {0.0f, 0.0f, 0.0f, 0.0f};
    nkw_column x, y, z, t, xy_low, xy_high, z_low, z_high;
    NKW_COLUMNS_LOAD(x, y, z, t, m);
    NKW_COLUMN_MIX(xy_low, x, y, 0, 4, 1, 5);
    NKW_COLUMN_MIX(xy_high, x, y, 2, 6, 3, 7);
    NKW_COLUMN_MIX(z_low, z, none, 0, 4, 1, 5);
    NKW_COLUMN_MIX(z_high, z, none, 2, 6, 3, 7);
    NKW_COLUMN_MIX(x, xy_low, z_low, 0, 1, 4, 5);
    NKW_COLUMN_MIX(y, xy_low, z_low, 2, 3, 6, 7);
    NKW_COLUMN_MIX(z, xy_high, z_high, 0, 1, 4, 5);
    NKW_COLUMN(t, -NKW_WEIGHED_0(m->m + 12));
    NKW_COLUMN_END(t, 1);
    nkw_mat4 r;
    NKW_COLUMNS_STORE(&r, x, y, z, t);
    return r;
}

NKW_BODY nkw_vec3 nkw_mat4_transform_point(const nkw_mat4 *m, nkw_vec3 p)
{
    NKW_EXACT
    const float *a = m->m;
    nkw_vec3 r = {
        (NKW_MUL(a[0], p.x) + NKW_MUL(a[4], p.y)) + (NKW_MUL(a[8], p.z) + a[12]),
        (NKW_MUL(a[1], p.x) + NKW_MUL(a[5], p.y)) + (NKW_MUL(a[9], p.z) + a[13]),
        (NKW_MUL(a[2], p.x) + NKW_MUL(a[6], p.y)) + (NKW_MUL(a[10], p.z) + a[14]),
    };
    return r;
}

NKW_BODY nkw_vec3 nkw_mat4_transform_direction(const nkw_mat4 *m, nkw_vec3 d)
{
    NKW_EXACT
    const float *a = m->m;
    nkw_vec3 r = {
        (NKW_MUL(a[0], d.x) + NKW_MUL(a[4], d.y)) + NKW_MUL(a[8], d.z),
        (NKW_MUL(a[1], d.x) + NKW_MUL(a[5], d.y)) + NKW_MUL(a[9], d.z),
        (NKW_MUL(a[2], d.x) + NKW_MUL(a[6], d.y)) + NKW_MUL(a[10], d.z),
    };
    return r;
}

#ifdef __cplusplus
}
#endif

#endif
