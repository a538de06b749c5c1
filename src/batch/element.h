/* SPDX-License-Identifier: MIT */
/* Element i of component arrays: what a loop reads with at and writes with put. */
#ifndef NAKAWARI_BATCH_ELEMENT_H
#define NAKAWARI_BATCH_ELEMENT_H

#include "lane/strict.h"

#include <nakawari/types.h>

static inline nkw_vec3 at_vec3(nkw_vec3_view v, size_t i)
{
    nkw_vec3 r = {v.x[i], v.y[i], v.z[i]};
    return r;
}

static inline void put_vec3(nkw_vec3_span s, size_t i, nkw_vec3 v)
{
    s.x[i] = v.x;
    s.y[i] = v.y;
    s.z[i] = v.z;
}

static inline nkw_quat at_quat(nkw_quat_view v, size_t i)
{
    nkw_quat r = {v.x[i], v.y[i], v.z[i], v.w[i]};
    return r;
}

static inline void put_quat(nkw_quat_span s, size_t i, nkw_quat q)
{
    s.x[i] = q.x;
    s.y[i] = q.y;
    s.z[i] = q.z;
    s.w[i] = q.w;
}

static inline nkw_mat4 at_mat4(const nkw_mat4_view *v, size_t i)
{
    nkw_mat4 r;
    for (size_t k = 0; k < 16; k++)
        r.m[k] = v->m[k][i];
    return r;
}

static inline void put_mat4(const nkw_mat4_span *s, size_t i, const nkw_mat4 *m)
{
    for (size_t k = 0; k < 16; k++)
        s->m[k][i] = m->m[k];
}

#endif
