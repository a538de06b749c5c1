/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/mat.h>

#include "batch/element.h"
#include "batch/mat.h"
#include "lane/mat.h"

NKW_LOOPS_MAT(NKW_DECLARE_LOOP)

/* A separate function: GCC keeps a matrix whose address is taken in the loop in memory, and does not vectorise. */
static inline void mul_affine(const nkw_mat4_view *a, const nkw_mat4_view *b, const nkw_mat4_span *out, size_t i)
{
    nkw_mat4 p = at_mat4(a, i), q = at_mat4(b, i), r = lane_mat4_mul_affine(&p, &q);
    put_mat4(out, i, &r);
}

NKW_LOOP(nkw_mat4_mul_affine_n)(nkw_mat4_view a, nkw_mat4_view b, nkw_mat4_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        mul_affine(&a, &b, &out, i);
}

NKW_LOOP(nkw_mat4_transform_point_n)(const nkw_mat4 *m, nkw_vec3_view p, nkw_vec3_span out, size_t n)
{
    const nkw_mat4 a = *m;
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, nkw_mat4_transform_point(&a, at_vec3(p, i)));
}

NKW_LOOP(nkw_mat4_transform_direction_n)(const nkw_mat4 *m, nkw_vec3_view d, nkw_vec3_span out, size_t n)
{
    const nkw_mat4 a = *m;
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, nkw_mat4_transform_direction(&a, at_vec3(d, i)));
}

NKW_LOOP(nkw_mat4_unpack_n)(const nkw_mat4 *in, nkw_mat4_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_mat4(&out, i, &in[i]);
}

NKW_LOOP(nkw_mat4_pack_n)(nkw_mat4_view in, nkw_mat4 *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = at_mat4(&in, i);
}
