/* SPDX-License-Identifier: MIT */
/* The small algebra of transform.h, once: inlined into the caller, and compiled into the library as symbols. */
#ifndef NAKAWARI_INLINE_TRANSFORM_H
#define NAKAWARI_INLINE_TRANSFORM_H

#include "../mat.h"
#include "../quat.h"
#include "../transform.h"
#include "../vec.h"

#ifdef __cplusplus
extern "C" {
#endif

inline nkw_trs nkw_trs_identity(void)
{
    nkw_trs r = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 1.0f}};
    return r;
}

inline nkw_mat3 nkw_mat3_from_quat_scale(nkw_quat q, nkw_vec3 s)
{
    NKW_EXACT
    nkw_mat3 r = nkw_mat3_from_quat(q);
    /* The rounding of |q| shows in the matrix twice over; 1 - |q|^2 takes it out. */
    float m = NKW_QUAT_DEFECT(q);
    for (size_t i = 0; i < 3; i++) {
        r.m[i] = NKW_MUL(r.m[i] + NKW_MUL(r.m[i], m), s.x);
        r.m[3 + i] = NKW_MUL(r.m[3 + i] + NKW_MUL(r.m[3 + i], m), s.y);
        r.m[6 + i] = NKW_MUL(r.m[6 + i] + NKW_MUL(r.m[6 + i], m), s.z);
    }
    return r;
}

inline nkw_mat4 nkw_mat4_from_trs(const nkw_trs *trs)
{
    nkw_mat3 r = nkw_mat3_from_quat_scale(trs->rotation, trs->scale);
    return nkw_mat4_from_mat3(&r, trs->translation);
}

inline nkw_vec3 nkw_trs_transform_point(const nkw_trs *trs, nkw_vec3 p)
{
    nkw_vec3 scaled = nkw_vec3_mul(trs->scale, p);
    return nkw_vec3_add(trs->translation, nkw_quat_rotate(trs->rotation, scaled));
}

inline nkw_trs nkw_trs_mul(const nkw_trs *a, const nkw_trs *b)
{
    nkw_trs r;
    r.translation = nkw_trs_transform_point(a, b->translation);
    r.rotation = nkw_quat_mul(a->rotation, b->rotation);
    r.scale = nkw_vec3_mul(a->scale, b->scale);
    return r;
}

#ifdef __cplusplus
}
#endif

#endif
