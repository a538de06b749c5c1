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

/* Elements from .. to - 1, whose matrices may have elements of any size, are computed again in binary64. */
static inline void nearest_again(const nkw_vec3_view columns[3], const float *n2, nkw_quat_span out, size_t from,
                                 size_t to)
{
    for (size_t i = from; i < to; i++)
        if (!(n2[i - from] < LANE_NEAREST_FAR)) {
            nkw_quat q =
                lane_quat_from_any_columns(at_vec3(columns[0], i), at_vec3(columns[1], i), at_vec3(columns[2], i));
            out.x[i - from] = q.x, out.y[i - from] = q.y, out.z[i - from] = q.z, out.w[i - from] = q.w;
        }
}

/* In blocks, which are copied to `out` when all their matrices have been read. */
NKW_LOOP(nkw_quat_from_mat3_n)(nkw_mat3_view m, nkw_quat_span out, size_t n)
{
    const nkw_vec3_view c[3] = {{m.m[0], m.m[1], m.m[2]}, {m.m[3], m.m[4], m.m[5]}, {m.m[6], m.m[7], m.m[8]}};
    const nkw_vec3_view x = c[0], y = c[1], z = c[2];
    float q[4][NEAREST_BLOCK], n2[NEAREST_BLOCK];
    const nkw_quat_span block = {q[0], q[1], q[2], q[3]};
    for (size_t from = 0; from < n; from += NEAREST_BLOCK) {
        size_t size = n - from < NEAREST_BLOCK ? n - from : NEAREST_BLOCK;
        int far = 0;
#pragma omp simd reduction(| : far)
        for (size_t i = 0; i < size; i++) {
            lane_nearest r = lane_quat_from_columns(at_vec3(x, from + i), at_vec3(y, from + i), at_vec3(z, from + i));
            put_quat(block, i, r.q);
            n2[i] = r.n2;
            far |= !(r.n2 < LANE_NEAREST_FAR);
        }
        if (far)
            nearest_again(c, n2, block, from, from + size);
#pragma omp simd
        for (size_t i = 0; i < size; i++)
            put_quat(out, from + i, at_quat(block, i));
    }
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
