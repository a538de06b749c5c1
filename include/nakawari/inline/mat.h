/* SPDX-License-Identifier: MIT */
/* The small algebra of mat.h, once: inlined into the caller, and compiled into the library as symbols. */
#ifndef NAKAWARI_INLINE_MAT_H
#define NAKAWARI_INLINE_MAT_H

#include "../mat.h"

#ifdef __cplusplus
extern "C" {
#endif

inline nkw_mat3 nkw_mat3_identity(void)
{
    nkw_mat3 r = {{1, 0, 0, 0, 1, 0, 0, 0, 1}};
    return r;
}

inline nkw_mat3 nkw_mat3_from_columns(nkw_vec3 x, nkw_vec3 y, nkw_vec3 z)
{
    nkw_mat3 r = {{x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z}};
    return r;
}

inline nkw_vec3 nkw_mat3_column(const nkw_mat3 *m, size_t c)
{
    size_t k = c < 3 ? c * 3 : 0;
    nkw_vec3 r = {m->m[k], m->m[k + 1], m->m[k + 2]};
    return r;
}

inline nkw_mat3 nkw_mat3_from_mat4(const nkw_mat4 *m)
{
    const float *a = m->m;
    nkw_mat3 r = {{a[0], a[1], a[2], a[4], a[5], a[6], a[8], a[9], a[10]}};
    return r;
}

inline nkw_mat3 nkw_mat3_transpose(const nkw_mat3 *m)
{
    const float *a = m->m;
    nkw_mat3 r = {{a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8]}};
    return r;
}

inline nkw_mat3 nkw_mat3_mul(const nkw_mat3 *a, const nkw_mat3 *b)
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

inline nkw_vec3 nkw_mat3_transform(const nkw_mat3 *m, nkw_vec3 v)
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

inline nkw_mat3 nkw_mat3_from_quat(nkw_quat q)
{
    NKW_EXACT
    float xx = NKW_MUL(q.x, q.x), yy = NKW_MUL(q.y, q.y), zz = NKW_MUL(q.z, q.z), ww = NKW_MUL(q.w, q.w);
    float xy = NKW_MUL(q.x, q.y), xz = NKW_MUL(q.x, q.z), yz = NKW_MUL(q.y, q.z);
    float wx = NKW_MUL(q.w, q.x), wy = NKW_MUL(q.w, q.y), wz = NKW_MUL(q.w, q.z);
    nkw_mat3 r = {{
        (ww - yy) + (xx - zz), (xy + wz) + (xy + wz), (xz - wy) + (xz - wy),
        (xy - wz) + (xy - wz), (ww - zz) + (yy - xx), (yz + wx) + (yz + wx),
        (xz + wy) + (xz + wy), (yz - wx) + (yz - wx), (ww - xx) + (zz - yy),
    }};
    return r;
}

inline nkw_mat4 nkw_mat4_identity(void)
{
    nkw_mat4 r = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
    return r;
}

inline nkw_mat4 nkw_mat4_from_mat3(const nkw_mat3 *m, nkw_vec3 translation)
{
    const float *a = m->m;
    nkw_mat4 r;
    r.m[0] = a[0], r.m[1] = a[1], r.m[2] = a[2], r.m[3] = 0.0f;
    r.m[4] = a[3], r.m[5] = a[4], r.m[6] = a[5], r.m[7] = 0.0f;
    r.m[8] = a[6], r.m[9] = a[7], r.m[10] = a[8], r.m[11] = 0.0f;
    r.m[12] = translation.x, r.m[13] = translation.y, r.m[14] = translation.z, r.m[15] = 1.0f;
    return r;
}

inline nkw_mat4 nkw_mat4_from_quat(nkw_quat q)
{
    nkw_mat3 m = nkw_mat3_from_quat(q);
    nkw_vec3 origin = {0.0f, 0.0f, 0.0f};
    return nkw_mat4_from_mat3(&m, origin);
}

inline nkw_vec3 nkw_mat4_translation(const nkw_mat4 *m)
{
    nkw_vec3 r = {m->m[12], m->m[13], m->m[14]};
    return r;
}

inline nkw_mat4 nkw_mat4_transpose(const nkw_mat4 *m)
{
    nkw_mat4 r;
    for (size_t c = 0; c < 4; c++)
        for (size_t i = 0; i < 4; i++)
            r.m[c * 4 + i] = m->m[i * 4 + c];
    return r;
}

inline nkw_mat4 nkw_mat4_mul(const nkw_mat4 *a, const nkw_mat4 *b)
{
    NKW_EXACT
    nkw_mat4 r;
    const float *p = a->m;
    for (size_t c = 0; c < 16; c += 4) {
        float u = b->m[c], v = b->m[c + 1], w = b->m[c + 2], t = b->m[c + 3];
        for (size_t i = 0; i < 4; i++)
            r.m[c + i] = (NKW_MUL(p[i], u) + NKW_MUL(p[4 + i], v)) + (NKW_MUL(p[8 + i], w) + NKW_MUL(p[12 + i], t));
    }
    return r;
}

inline nkw_mat4 nkw_mat4_mul_affine(const nkw_mat4 *a, const nkw_mat4 *b)
{
    NKW_EXACT
    nkw_mat4 r;
    const float *p = a->m;
    for (size_t c = 0; c < 16; c += 4) {
        float u = b->m[c], v = b->m[c + 1], w = b->m[c + 2];
        for (size_t i = 0; i < 3; i++) {
            float z = c == 12 ? NKW_MUL(p[8 + i], w) + p[12 + i] : NKW_MUL(p[8 + i], w);
            r.m[c + i] = (NKW_MUL(p[i], u) + NKW_MUL(p[4 + i], v)) + z;
        }
        r.m[c + 3] = c == 12 ? 1.0f : 0.0f;
    }
    return r;
}

inline nkw_vec3 nkw_mat4_transform_point(const nkw_mat4 *m, nkw_vec3 p)
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

inline nkw_vec3 nkw_mat4_transform_direction(const nkw_mat4 *m, nkw_vec3 d)
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
