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

inline nkw_mat4 nkw_mat4_from_trs(const nkw_trs *trs)
{
    NKW_EXACT
    nkw_quat q = trs->rotation;
    nkw_mat3 r = nkw_mat3_from_quat(q);
    const float s[3] = {trs->scale.x, trs->scale.y, trs->scale.z};
    /* The rounding of |q| shows in the matrix twice over; 1 - |q|^2 takes it out. */
    float m = ((0.25f - q.x * q.x) + (0.25f - q.y * q.y)) + ((0.25f - q.z * q.z) + (0.25f - q.w * q.w));
    for (size_t c = 0; c < 3; c++)
        for (size_t i = 0; i < 3; i++)
            r.m[c * 3 + i] = (r.m[c * 3 + i] + r.m[c * 3 + i] * m) * s[c];
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
