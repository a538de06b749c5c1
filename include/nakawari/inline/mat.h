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
            r.m[c + i] = (p[i] * u + p[3 + i] * v) + p[6 + i] * w;
    }
    return r;
}

inline nkw_vec3 nkw_mat3_transform(const nkw_mat3 *m, nkw_vec3 v)
{
    NKW_EXACT
    const float *a = m->m;
    nkw_vec3 r = {
        (a[0] * v.x + a[3] * v.y) + a[6] * v.z,
        (a[1] * v.x + a[4] * v.y) + a[7] * v.z,
        (a[2] * v.x + a[5] * v.y) + a[8] * v.z,
    };
    return r;
}

inline nkw_mat3 nkw_mat3_from_quat(nkw_quat q)
{
    NKW_EXACT
    float xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z, ww = q.w * q.w;
    float xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
    float wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
    nkw_mat3 r = {{
        (ww - yy) + (xx - zz), 2.0f * (xy + wz), 2.0f * (xz - wy),
        2.0f * (xy - wz), (ww - zz) + (yy - xx), 2.0f * (yz + wx),
        2.0f * (xz + wy), 2.0f * (yz - wx), (ww - xx) + (zz - yy),
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
    nkw_mat4 r = {{
        a[0], a[1], a[2], 0, a[3], a[4], a[5], 0, a[6], a[7], a[8], 0,
        translation.x, translation.y, translation.z, 1,
    }};
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
            r.m[c + i] = (p[i] * u + p[4 + i] * v) + (p[8 + i] * w + p[12 + i] * t);
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
            float z = c == 12 ? p[8 + i] * w + p[12 + i] : p[8 + i] * w;
            r.m[c + i] = (p[i] * u + p[4 + i] * v) + z;
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
        (a[0] * p.x + a[4] * p.y) + (a[8] * p.z + a[12]),
        (a[1] * p.x + a[5] * p.y) + (a[9] * p.z + a[13]),
        (a[2] * p.x + a[6] * p.y) + (a[10] * p.z + a[14]),
    };
    return r;
}

inline nkw_vec3 nkw_mat4_transform_direction(const nkw_mat4 *m, nkw_vec3 d)
{
    NKW_EXACT
    const float *a = m->m;
    nkw_vec3 r = {
        (a[0] * d.x + a[4] * d.y) + a[8] * d.z,
        (a[1] * d.x + a[5] * d.y) + a[9] * d.z,
        (a[2] * d.x + a[6] * d.y) + a[10] * d.z,
    };
    return r;
}

#ifdef __cplusplus
}
#endif

#endif
