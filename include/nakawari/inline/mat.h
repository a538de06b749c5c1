/* SPDX-License-Identifier: MIT */
/* The small algebra of mat.h: inlined into the caller, and compiled into the library as symbols. */
#ifndef NAKAWARI_INLINE_MAT_H
#define NAKAWARI_INLINE_MAT_H

#include "../mat.h"
#include "f32x4.h"
#include "product.h"

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
            r.m[c + i] = (nkw_mul(p[i], u) + nkw_mul(p[3 + i], v)) + nkw_mul(p[6 + i], w);
    }
    return r;
}

NKW_BODY nkw_vec3 nkw_mat3_transform(const nkw_mat3 *m, nkw_vec3 v)
{
    NKW_EXACT
    const float *a = m->m;
    nkw_vec3 r = {
        (nkw_mul(a[0], v.x) + nkw_mul(a[3], v.y)) + nkw_mul(a[6], v.z),
        (nkw_mul(a[1], v.x) + nkw_mul(a[4], v.y)) + nkw_mul(a[7], v.z),
        (nkw_mul(a[2], v.x) + nkw_mul(a[5], v.y)) + nkw_mul(a[8], v.z),
    };
    return r;
}

NKW_BODY nkw_mat3 nkw_mat3_from_quat(nkw_quat q)
{
    NKW_EXACT
    float x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
    float xx = nkw_mul(q.x, q.x), yy = nkw_mul(q.y, q.y), zz = nkw_mul(q.z, q.z), ww = nkw_mul(q.w, q.w);
    float xy = nkw_mul(q.x, y2), yz = nkw_mul(q.y, z2), zx = nkw_mul(q.z, x2);
    float wx = nkw_mul(q.w, x2), wy = nkw_mul(q.w, y2), wz = nkw_mul(q.w, z2);
    nkw_mat3 r = {{
        (ww - yy) + (xx - zz),
        xy + wz,
        zx - wy,
        xy - wz,
        (ww - zz) + (yy - xx),
        yz + wx,
        zx + wy,
        yz - wx,
        (ww - xx) + (zz - yy),
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
    /* Assignments, because GCC clears the matrix on the stack before an initialiser. */
    nkw_mat4 r;
    r.m[0] = a[0], r.m[1] = a[1], r.m[2] = a[2], r.m[3] = 0.0f;
    r.m[4] = a[3], r.m[5] = a[4], r.m[6] = a[5], r.m[7] = 0.0f;
    r.m[8] = a[6], r.m[9] = a[7], r.m[10] = a[8], r.m[11] = 0.0f;
    r.m[12] = translation.x, r.m[13] = translation.y, r.m[14] = translation.z, r.m[15] = 1.0f;
    return r;
}

#if NKW_F32X4
/*
 * The nine elements of R, nkw_mat3_from_quat, in three registers; row and column of each element:
 *
 *     r[0] = 00 11 22   the diagonal          r[1] = 10 21 02          r[2] = 01 12 20
 */
NKW_PART void nkw_f32x4_rotation(nkw_f32x4 q, nkw_f32x4 r[3])
{
    NKW_EXACT
    nkw_f32x4 q2 = q + q, qq = nkw_f32x4_mul(q, q), w = NKW_SHUFFLE(q, q, 3, 3, 3, 3);
    nkw_f32x4 yzx = nkw_f32x4_mul(q, NKW_SHUFFLE(q2, q2, 1, 2, 0, 3));
    nkw_f32x4 zxy = nkw_f32x4_mul(w, NKW_SHUFFLE(q2, q2, 2, 0, 1, 3));
    r[0] = (nkw_f32x4_mul(w, w) - NKW_SHUFFLE(qq, qq, 1, 2, 0, 3)) + (qq - NKW_SHUFFLE(qq, qq, 2, 0, 1, 3));
    r[1] = yzx + zxy;
    r[2] = yzx - zxy;
}

/* The affine matrix with these elements and the translation, whose last element is not used. */
NKW_PART nkw_mat4 nkw_f32x4_affine(const nkw_f32x4 r[3], nkw_f32x4 translation)
{
    nkw_f32x4 d = nkw_f32x4_end_0(r[0]), u = nkw_f32x4_end_0(r[2]);
    nkw_f32x4 l = nkw_f32x4_end_0(NKW_SHUFFLE(r[1], r[1], 2, 0, 1, 3)); /* 02 10 21 */
    nkw_f32x4 x = NKW_SHUFFLE(l, d, 4, 1, 2, 3), y = NKW_SHUFFLE(d, u, 4, 1, 2, 3), z = NKW_SHUFFLE(u, l, 4, 1, 2, 3);
    nkw_mat4 m;
    nkw_f32x4_store(m.m, NKW_SHUFFLE(x, u, 0, 1, 6, 7));
    nkw_f32x4_store(m.m + 4, NKW_SHUFFLE(y, l, 0, 1, 6, 7));
    nkw_f32x4_store(m.m + 8, NKW_SHUFFLE(z, d, 0, 1, 6, 7));
    nkw_f32x4_store(m.m + 12, nkw_f32x4_end_1(translation));
    return m;
}

NKW_BODY nkw_mat4 nkw_mat4_from_quat(nkw_quat q)
{
    const nkw_f32x4 origin = {0.0f, 0.0f, 0.0f, 1.0f};
    nkw_f32x4 r[3];
    nkw_f32x4_rotation(nkw_f32x4_load(&q), r);
    return nkw_f32x4_affine(r, origin);
}
#else
NKW_BODY nkw_mat4 nkw_mat4_from_quat(nkw_quat q)
{
    nkw_mat3 m = nkw_mat3_from_quat(q);
    nkw_vec3 origin = {0.0f, 0.0f, 0.0f};
    return nkw_mat4_from_mat3(&m, origin);
}
#endif

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

#if NKW_F32X4
/*
 * x k[0] + y k[1] + z k[2] for the columns x, y, z, t of an affine matrix; the elements of k are `step` floats apart.
 */
NKW_PART nkw_f32x4 nkw_f32x4_direction(const nkw_f32x4 m[3], const float *k, size_t step)
{
    NKW_EXACT
    const nkw_f32x4 xy = nkw_f32x4_scale(m[0], k[0]) + nkw_f32x4_scale(m[1], k[step]);
    return xy + nkw_f32x4_scale(m[2], k[2 * step]);
}

/* x k[0] + y k[1] + z k[2] + t */
NKW_PART nkw_f32x4 nkw_f32x4_point(const nkw_f32x4 m[4], const float *k, size_t step)
{
    NKW_EXACT
    const nkw_f32x4 xy = nkw_f32x4_scale(m[0], k[0]) + nkw_f32x4_scale(m[1], k[step]);
    return xy + (nkw_f32x4_scale(m[2], k[2 * step]) + m[3]);
}

/*
 * Second text of lane_mat4_mul and lane_mat4_mul_affine; 2.0 times faster.
 *
 * With AVX a register holds two columns of a product a b, which makes nkw_mat4_mul 1.25 to 1.4 times faster again.
 *
 * Column c of a product a b is the sum of the columns of a, each multiplied by an element of column c of b.
 */
#if NKW_F32X8
/* Element i of each four floats, in all four; a constant. */
#define NKW_BOTH(a, i) __builtin_shufflevector(a, a, i, i, i, i, 4 + (i), 4 + (i), 4 + (i), 4 + (i))

/* x k[0] + y k[1] + z k[2] + t k[3] of each four floats. */
NKW_PART nkw_f32x8 nkw_f32x8_columns(const nkw_f32x8 m[4], nkw_f32x8 k)
{
    NKW_EXACT
    const nkw_f32x8 xy = nkw_f32x8_mul(m[0], NKW_BOTH(k, 0)) + nkw_f32x8_mul(m[1], NKW_BOTH(k, 1));
    return xy + (nkw_f32x8_mul(m[2], NKW_BOTH(k, 2)) + nkw_f32x8_mul(m[3], NKW_BOTH(k, 3)));
}

NKW_BODY nkw_mat4 nkw_mat4_mul(const nkw_mat4 *a, const nkw_mat4 *b)
{
    const nkw_f32x8 m[4] = {nkw_f32x8_twice(a->m), nkw_f32x8_twice(a->m + 4), nkw_f32x8_twice(a->m + 8),
                            nkw_f32x8_twice(a->m + 12)};
    const nkw_f32x8 k = nkw_f32x8_load(b->m), l = nkw_f32x8_load(b->m + 8);
    nkw_mat4 r;
    nkw_f32x8_store(r.m, nkw_f32x8_columns(m, k));
    nkw_f32x8_store(r.m + 8, nkw_f32x8_columns(m, l));
    return r;
}
#else
/* x k[0] + y k[1] + z k[2] + t k[3] */
NKW_PART nkw_f32x4 nkw_f32x4_columns(const nkw_f32x4 m[4], const float *k)
{
    NKW_EXACT
    const nkw_f32x4 xy = nkw_f32x4_scale(m[0], k[0]) + nkw_f32x4_scale(m[1], k[1]);
    return xy + (nkw_f32x4_scale(m[2], k[2]) + nkw_f32x4_scale(m[3], k[3]));
}

NKW_BODY nkw_mat4 nkw_mat4_mul(const nkw_mat4 *a, const nkw_mat4 *b)
{
    const nkw_f32x4 m[4] = {nkw_f32x4_load(a->m), nkw_f32x4_load(a->m + 4), nkw_f32x4_load(a->m + 8),
                            nkw_f32x4_load(a->m + 12)};
    nkw_mat4 r;
    nkw_f32x4_store(r.m, nkw_f32x4_columns(m, b->m));
    nkw_f32x4_store(r.m + 4, nkw_f32x4_columns(m, b->m + 4));
    nkw_f32x4_store(r.m + 8, nkw_f32x4_columns(m, b->m + 8));
    nkw_f32x4_store(r.m + 12, nkw_f32x4_columns(m, b->m + 12));
    return r;
}
#endif

NKW_BODY nkw_mat4 nkw_mat4_mul_affine(const nkw_mat4 *a, const nkw_mat4 *b)
{
    const nkw_f32x4 m[4] = {nkw_f32x4_load(a->m), nkw_f32x4_load(a->m + 4), nkw_f32x4_load(a->m + 8),
                            nkw_f32x4_load(a->m + 12)};
    nkw_mat4 r;
    nkw_f32x4_store(r.m, nkw_f32x4_end_0(nkw_f32x4_direction(m, b->m, 1)));
    nkw_f32x4_store(r.m + 4, nkw_f32x4_end_0(nkw_f32x4_direction(m, b->m + 4, 1)));
    nkw_f32x4_store(r.m + 8, nkw_f32x4_end_0(nkw_f32x4_direction(m, b->m + 8, 1)));
    nkw_f32x4_store(r.m + 12, nkw_f32x4_end_1(nkw_f32x4_point(m, b->m + 12, 1)));
    return r;
}
#endif

/* R^T, the transpose of the rotation, and -R^T t. */
#if NKW_F32X4
/* Second text of nkw_mat4_inverse_rigid; 2.4 times faster. Its columns are the rows of R. */
NKW_BODY nkw_mat4 nkw_mat4_inverse_rigid(const nkw_mat4 *m)
{
    NKW_EXACT
    const nkw_f32x4 x = nkw_f32x4_load(m->m), y = nkw_f32x4_load(m->m + 4);
    const nkw_f32x4 z = nkw_f32x4_end_0(nkw_f32x4_load(m->m + 8));
    const nkw_f32x4 xy = NKW_SHUFFLE(x, y, 0, 4, 1, 5), last = NKW_SHUFFLE(x, y, 2, 6, 2, 6);
    const nkw_f32x4 r[3] = {NKW_SHUFFLE(xy, z, 0, 1, 4, 7), NKW_SHUFFLE(xy, z, 2, 3, 5, 7),
                            NKW_SHUFFLE(last, z, 0, 1, 6, 7)};
    const nkw_f32x4 p = nkw_f32x4_direction(r, m->m + 12, 1);
    nkw_mat4 to;
    nkw_f32x4_store(to.m, r[0]);
    nkw_f32x4_store(to.m + 4, r[1]);
    nkw_f32x4_store(to.m + 8, r[2]);
    nkw_f32x4_store(to.m + 12, nkw_f32x4_end_1(-p));
    return to;
}
#else
NKW_BODY nkw_mat4 nkw_mat4_inverse_rigid(const nkw_mat4 *m)
{
    NKW_EXACT
    const float *a = m->m;
    float x = a[12], y = a[13], z = a[14];
    nkw_vec3 p = {
        -((nkw_mul(a[0], x) + nkw_mul(a[1], y)) + nkw_mul(a[2], z)),
        -((nkw_mul(a[4], x) + nkw_mul(a[5], y)) + nkw_mul(a[6], z)),
        -((nkw_mul(a[8], x) + nkw_mul(a[9], y)) + nkw_mul(a[10], z)),
    };
    nkw_mat4 r = {{a[0], a[4], a[8], 0.0f, a[1], a[5], a[9], 0.0f, a[2], a[6], a[10], 0.0f, p.x, p.y, p.z, 1.0f}};
    return r;
}
#endif

NKW_BODY nkw_vec3 nkw_mat4_transform_point(const nkw_mat4 *m, nkw_vec3 p)
{
    NKW_EXACT
    const float *a = m->m;
    nkw_vec3 r = {
        (nkw_mul(a[0], p.x) + nkw_mul(a[4], p.y)) + (nkw_mul(a[8], p.z) + a[12]),
        (nkw_mul(a[1], p.x) + nkw_mul(a[5], p.y)) + (nkw_mul(a[9], p.z) + a[13]),
        (nkw_mul(a[2], p.x) + nkw_mul(a[6], p.y)) + (nkw_mul(a[10], p.z) + a[14]),
    };
    return r;
}

NKW_BODY nkw_vec3 nkw_mat4_transform_direction(const nkw_mat4 *m, nkw_vec3 d)
{
    NKW_EXACT
    const float *a = m->m;
    nkw_vec3 r = {
        (nkw_mul(a[0], d.x) + nkw_mul(a[4], d.y)) + nkw_mul(a[8], d.z),
        (nkw_mul(a[1], d.x) + nkw_mul(a[5], d.y)) + nkw_mul(a[9], d.z),
        (nkw_mul(a[2], d.x) + nkw_mul(a[6], d.y)) + nkw_mul(a[10], d.z),
    };
    return r;
}

#ifdef __cplusplus
}
#endif

#undef NKW_SHUFFLE
#undef NKW_BOTH

#endif
