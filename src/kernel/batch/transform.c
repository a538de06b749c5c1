/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/transform.h>

#include "batch/element.h"
#include "batch/transform.h"

NKW_LOOPS_TRANSFORM(NKW_DECLARE_LOOP)

/*
 * The elements that are no sums: translation and last row. Copies and constants stand apart from the loop: Clang drops
 * from them the mark that says its arrays do not depend on each other.
 */
static inline void copy(const float *from, float *to, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        to[i] = from[i];
}

static inline void fill(float *to, float x, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        to[i] = x;
}

static inline void put_rest(nkw_vec3_view t, const nkw_mat4_span *out, size_t n)
{
    copy(t.x, out->m[12], n);
    copy(t.y, out->m[13], n);
    copy(t.z, out->m[14], n);
    fill(out->m[3], 0.0f, n);
    fill(out->m[7], 0.0f, n);
    fill(out->m[11], 0.0f, n);
    fill(out->m[15], 1.0f, n);
}

NKW_LOOP(nkw_mat4_from_trs_n)(nkw_trs_view trs, nkw_mat4_span out, size_t n)
{
    const nkw_quat_view rotation = trs.rotation;
    const nkw_vec3_view scale = trs.scale;
    put_rest(trs.translation, &out, n);
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        nkw_mat3 r = nkw_mat3_from_quat_scale(at_quat(rotation, i), at_vec3(scale, i));
        for (size_t k = 0; k < 9; k++)
            out.m[k / 3 * 4 + k % 3][i] = r.m[k];
    }
}
