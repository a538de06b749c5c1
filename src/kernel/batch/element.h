/* SPDX-License-Identifier: MIT */
/* Element i of component arrays: what a loop reads with at and writes with put. */
#ifndef NAKAWARI_BATCH_ELEMENT_H
#define NAKAWARI_BATCH_ELEMENT_H

#include "lane/strict.h"

#include <nakawari/types.h>

/*
 * at_ is a macro, and put_ passes the pointers of a span one by one: where Clang splits a struct, be it an argument or
 * a result, it loses the mark of "omp simd" on its accesses. The loop would then compare all arrays for overlap at run
 * time; in place, where they do overlap, it would not be vectorised.
 */
#define at_vec3(v, i)     ((nkw_vec3){(v).x[i], (v).y[i], (v).z[i]})
#define at_quat(v, i)     ((nkw_quat){(v).x[i], (v).y[i], (v).z[i], (v).w[i]})
#define put_vec3(s, i, v) store_vec3((s).x, (s).y, (s).z, i, v)
#define put_quat(s, i, q) store_quat((s).x, (s).y, (s).z, (s).w, i, q)

static inline void store_vec3(float *x, float *y, float *z, size_t i, nkw_vec3 v)
{
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
}

static inline void store_quat(float *x, float *y, float *z, float *w, size_t i, nkw_quat q)
{
    x[i] = q.x;
    y[i] = q.y;
    z[i] = q.z;
    w[i] = q.w;
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
