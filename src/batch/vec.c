/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/vec.h>

#include "batch/element.h"
#include "batch/table.h"
#include "lane/vec.h"

KERNEL(vec3_add)(nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, nkw_vec3_add(at_vec3(a, i), at_vec3(b, i)));
}

KERNEL(vec3_sub)(nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, nkw_vec3_sub(at_vec3(a, i), at_vec3(b, i)));
}

KERNEL(vec3_mul)(nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, nkw_vec3_mul(at_vec3(a, i), at_vec3(b, i)));
}

KERNEL(vec3_scale)(nkw_vec3_view a, const float *s, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, nkw_vec3_scale(at_vec3(a, i), s[i]));
}

KERNEL(vec3_add_scaled)(nkw_vec3_view a, nkw_vec3_view b, const float *s, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, nkw_vec3_add_scaled(at_vec3(a, i), at_vec3(b, i), s[i]));
}

KERNEL(vec3_dot)(nkw_vec3_view a, nkw_vec3_view b, float *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = nkw_vec3_dot(at_vec3(a, i), at_vec3(b, i));
}

KERNEL(vec3_cross)(nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, nkw_vec3_cross(at_vec3(a, i), at_vec3(b, i)));
}

KERNEL(vec3_length)(nkw_vec3_view a, float *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = lane_vec3_length(at_vec3(a, i));
}

KERNEL(vec3_normalize)(nkw_vec3_view a, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, lane_vec3_normalize(at_vec3(a, i)));
}

KERNEL(vec3_lerp)(nkw_vec3_view a, nkw_vec3_view b, const float *t, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, nkw_vec3_lerp(at_vec3(a, i), at_vec3(b, i), t[i]));
}

KERNEL(vec3_lerp_at)(nkw_vec3_view a, nkw_vec3_view b, float t, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, nkw_vec3_lerp(at_vec3(a, i), at_vec3(b, i), t));
}

KERNEL(vec3_unpack)(const nkw_vec3 *in, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out.x[i] = in[i].x, out.y[i] = in[i].y, out.z[i] = in[i].z;
}

KERNEL(vec3_pack)(nkw_vec3_view in, nkw_vec3 *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i].x = in.x[i], out[i].y = in.y[i], out[i].z = in.z[i];
}
