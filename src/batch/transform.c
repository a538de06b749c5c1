/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/transform.h>

#include "batch/element.h"
#include "batch/table.h"

/*
 * The elements that are no sums: translation and last row. Copies and constants stand apart from the loop: Clang drops
 * from them the mark that says its arrays do not depend on each other.
 */
static inline void put_rest(nkw_vec3_view t, const nkw_mat4_span *out, size_t n)
{
    const float *const from[3] = {t.x, t.y, t.z};
    for (size_t k = 0; k < 3; k++) {
        memmove(out->m[12 + k], from[k], n * sizeof(float));
        memset(out->m[4 * k + 3], 0, n * sizeof(float));
    }
    for (size_t i = 0; i < n; i++)
        out->m[15][i] = 1.0f;
}

KERNEL(mat4_from_trs)(nkw_trs_view trs, nkw_mat4_span out, size_t n)
{
    const nkw_quat_view rotation = trs.rotation;
    const nkw_vec3_view scale = trs.scale;
    if (n == 0)
        return;
    put_rest(trs.translation, &out, n);
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        nkw_mat3 r = nkw_mat3_from_quat_scale(at_quat(rotation, i), at_vec3(scale, i));
        for (size_t k = 0; k < 9; k++)
            out.m[k / 3 * 4 + k % 3][i] = r.m[k];
    }
}
