/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/vec.h>

#include "batch/element.h"
#include "batch/vec.h"
#include "lane/vec.h"
#include "sizes.h"

NKW_LOOPS_VEC(NKW_DECLARE_LOOP)

/* Lengths come before divisions, so that no element waits for the root of the one before. */
static inline void normalize_block(nkw_vec3_view a, nkw_vec3_span out, size_t from, size_t to)
{
    float length[NORMALIZE_BLOCK];
    int far = 0;
#pragma omp simd reduction(| : far)
    for (size_t i = from; i < to; i++) {
        nkw_vec3 v = nkw_vec3_scale(at_vec3(a, i), NKW_NORMAL_SCALE);
        float n2 = nkw_vec3_dot(v, v);
        far |= !nkw_is_moderate(n2);
        length[i - from] = nkw_sqrt(n2);
    }
    if (far) {
#pragma omp simd
        for (size_t i = from; i < to; i++) {
            nkw_vec3 v = nkw_vec3_scale(at_vec3(a, i), NKW_NORMAL_SCALE);
            put_vec3(out, i, nkw_vec3_normalize_any(at_vec3(a, i), nkw_vec3_dot(v, v)));
        }
        return;
    }
#pragma omp simd
    for (size_t i = from; i < to; i++)
        put_vec3(out, i, nkw_vec3_over(nkw_vec3_scale(at_vec3(a, i), NKW_NORMAL_SCALE), length[i - from]));
}

NKW_LOOP(nkw_vec3_normalize_n)(nkw_vec3_view a, nkw_vec3_span out, size_t n)
{
    for (size_t from = 0; from < n; from += NORMALIZE_BLOCK)
        normalize_block(a, out, from, n - from < NORMALIZE_BLOCK ? n : from + NORMALIZE_BLOCK);
}

NKW_LOOP(nkw_vec3_lerp_n)(nkw_vec3_view a, nkw_vec3_view b, const float *t, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, nkw_vec3_lerp(at_vec3(a, i), at_vec3(b, i), t[i]));
}

NKW_LOOP(nkw_vec3_lerp_at_n)(nkw_vec3_view a, nkw_vec3_view b, float t, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, nkw_vec3_lerp(at_vec3(a, i), at_vec3(b, i), t));
}

NKW_LOOP(nkw_vec3_unpack_n)(const nkw_vec3 *in, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out.x[i] = in[i].x, out.y[i] = in[i].y, out.z[i] = in[i].z;
}

NKW_LOOP(nkw_vec3_pack_n)(nkw_vec3_view in, nkw_vec3 *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i].x = in.x[i], out[i].y = in.y[i], out[i].z = in.z[i];
}
