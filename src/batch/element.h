/* SPDX-License-Identifier: MIT */
/* Element i of component arrays: what a loop reads with at and writes with put. */
#ifndef NAKAWARI_BATCH_ELEMENT_H
#define NAKAWARI_BATCH_ELEMENT_H

#include "lane/strict.h"

#include <nakawari/types.h>

/*
 * The pointers of a vec3 view or span go one by one: Clang takes a struct of up to three pointers apart itself, and in
 * doing so loses what "omp simd" says of the accesses. Every loop would then compare all arrays for overlap at run time,
 * and in place, where they do overlap, would not use vectors.
 */
static inline nkw_vec3 load_vec3(const float *x, const float *y, const float *z, size_t i)
{
    nkw_vec3 r = {x[i], y[i], z[i]};
    return r;
}

static inline void store_vec3(float *x, float *y, float *z, size_t i, nkw_vec3 v)
{
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
}

#define at_vec3(v, i)     load_vec3((v).x, (v).y, (v).z, i)
#define put_vec3(s, i, v) store_vec3((s).x, (s).y, (s).z, i, v)

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
