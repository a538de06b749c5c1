/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/vec.h>

#include "batch/element.h"
#include "batch/vec.h"
#include "lane/vec.h"

NKW_LOOPS_VEC(NKW_DECLARE_LOOP)

NKW_LOOP(nkw_vec3_normalize_n)(nkw_vec3_view a, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, lane_vec3_normalize(at_vec3(a, i)));
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
