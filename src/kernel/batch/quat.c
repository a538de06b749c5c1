/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/quat.h>

#include "batch/element.h"
#include "batch/quat.h"
#include "lane/quat.h"
#include "sizes.h"

NKW_LOOPS_QUAT(NKW_DECLARE_LOOP)

NKW_LOOP(nkw_quat_mul_n)(nkw_quat_view a, nkw_quat_view b, nkw_quat_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_quat(out, i, nkw_quat_mul(at_quat(a, i), at_quat(b, i)));
}

/* Lengths come before divisions, so that no element waits for the root of the one before. */
static inline void normalize_block(nkw_quat_view q, nkw_quat_span out, size_t from, size_t to)
{
    float length[NORMALIZE_BLOCK];
    int far = 0;
#pragma omp simd reduction(| : far)
    for (size_t i = from; i < to; i++) {
        nkw_quat v = nkw_quat_scale(at_quat(q, i), NKW_NORMAL_SCALE);
        float n2 = nkw_quat_dot(v, v);
        far |= !nkw_is_moderate(n2);
        length[i - from] = nkw_sqrt(n2);
    }
    if (far) {
#pragma omp simd
        for (size_t i = from; i < to; i++) {
            nkw_quat v = nkw_quat_scale(at_quat(q, i), NKW_NORMAL_SCALE);
            put_quat(out, i, nkw_quat_normalize_any(at_quat(q, i), nkw_quat_dot(v, v), NKW_NORMAL_SCALE));
        }
        return;
    }
#pragma omp simd
    for (size_t i = from; i < to; i++)
        put_quat(out, i, nkw_quat_over(nkw_quat_scale(at_quat(q, i), NKW_NORMAL_SCALE), length[i - from]));
}

NKW_LOOP(nkw_quat_normalize_n)(nkw_quat_view q, nkw_quat_span out, size_t n)
{
    for (size_t from = 0; from < n; from += NORMALIZE_BLOCK)
        normalize_block(q, out, from, n - from < NORMALIZE_BLOCK ? n : from + NORMALIZE_BLOCK);
}

NKW_LOOP(nkw_quat_rotate_n)(nkw_quat_view q, nkw_vec3_view v, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, nkw_quat_rotate(at_quat(q, i), at_vec3(v, i)));
}

NKW_LOOP(nkw_quat_unpack_n)(const nkw_quat *in, nkw_quat_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out.x[i] = in[i].x, out.y[i] = in[i].y, out.z[i] = in[i].z, out.w[i] = in[i].w;
}

NKW_LOOP(nkw_quat_pack_n)(nkw_quat_view in, nkw_quat *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i].x = in.x[i], out[i].y = in.y[i], out[i].z = in.z[i], out[i].w = in.w[i];
}
