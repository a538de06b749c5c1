/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/quat.h>

#include "batch/element.h"
#include "batch/quat.h"
#include "lane/quat.h"

NKW_LOOPS_QUAT(NKW_DECLARE_LOOP)

NKW_LOOP(nkw_quat_mul_n)(nkw_quat_view a, nkw_quat_view b, nkw_quat_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_quat(out, i, nkw_quat_mul(at_quat(a, i), at_quat(b, i)));
}

NKW_LOOP(nkw_quat_normalize_n)(nkw_quat_view q, nkw_quat_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_quat(out, i, lane_quat_normalize(at_quat(q, i)));
}

NKW_LOOP(nkw_quat_rotate_n)(nkw_quat_view q, nkw_vec3_view v, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, nkw_quat_rotate(at_quat(q, i), at_vec3(v, i)));
}

/* By its columns: GCC keeps in memory what is an array in the loop itself. */
static inline nkw_quat from_columns(nkw_vec3 x, nkw_vec3 y, nkw_vec3 z)
{
    lane_f64_mat3 m = {{x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z}};
    return lane_quat_from_f64(lane_f64_quat_from_f64_mat3(&m, LANE_NEAREST_STEPS));
}

NKW_LOOP(nkw_quat_from_mat3_n)(nkw_mat3_view m, nkw_quat_span out, size_t n)
{
    const nkw_vec3_view x = {m.m[0], m.m[1], m.m[2]}, y = {m.m[3], m.m[4], m.m[5]}, z = {m.m[6], m.m[7], m.m[8]};
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_quat(out, i, from_columns(at_vec3(x, i), at_vec3(y, i), at_vec3(z, i)));
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
