/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/curve.h>

#include "batch/element.h"
#include "batch/table.h"
#include "lane/curve.h"

KERNEL(hermite)(const float *p0, const float *v0, const float *p1, const float *v1, const float *t, float *out,
                size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = lane_hermite(p0[i], v0[i], p1[i], v1[i], t[i]);
}

KERNEL(vec3_hermite)(nkw_vec3_view p0, nkw_vec3_view v0, nkw_vec3_view p1, nkw_vec3_view v1, const float *t,
                     nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, lane_vec3_hermite(at_vec3(p0, i), at_vec3(v0, i), at_vec3(p1, i), at_vec3(v1, i), t[i]));
}

KERNEL(hermite_at)(const float *p0, const float *v0, const float *p1, const float *v1, float t, float *out,
                   size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = lane_hermite(p0[i], v0[i], p1[i], v1[i], t);
}

KERNEL(vec3_hermite_at)(nkw_vec3_view p0, nkw_vec3_view v0, nkw_vec3_view p1, nkw_vec3_view v1, float t,
                        nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, lane_vec3_hermite(at_vec3(p0, i), at_vec3(v0, i), at_vec3(p1, i), at_vec3(v1, i), t));
}

KERNEL(bezier)(const float *p0, const float *p1, const float *p2, const float *p3, const float *t, float *out,
               size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = lane_bezier(p0[i], p1[i], p2[i], p3[i], t[i]);
}

KERNEL(vec3_bezier)(nkw_vec3_view p0, nkw_vec3_view p1, nkw_vec3_view p2, nkw_vec3_view p3, const float *t,
                    nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, lane_vec3_bezier(at_vec3(p0, i), at_vec3(p1, i), at_vec3(p2, i), at_vec3(p3, i), t[i]));
}

KERNEL(bezier_at)(const float *p0, const float *p1, const float *p2, const float *p3, float t, float *out,
                  size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = lane_bezier(p0[i], p1[i], p2[i], p3[i], t);
}

KERNEL(vec3_bezier_at)(nkw_vec3_view p0, nkw_vec3_view p1, nkw_vec3_view p2, nkw_vec3_view p3, float t,
                       nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, lane_vec3_bezier(at_vec3(p0, i), at_vec3(p1, i), at_vec3(p2, i), at_vec3(p3, i), t));
}

KERNEL(bspline)(const float *p0, const float *p1, const float *p2, const float *p3, const float *t, float *out,
                size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = lane_bspline(p0[i], p1[i], p2[i], p3[i], t[i]);
}

KERNEL(vec3_bspline)(nkw_vec3_view p0, nkw_vec3_view p1, nkw_vec3_view p2, nkw_vec3_view p3, const float *t,
                     nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, lane_vec3_bspline(at_vec3(p0, i), at_vec3(p1, i), at_vec3(p2, i), at_vec3(p3, i), t[i]));
}

KERNEL(bspline_at)(const float *p0, const float *p1, const float *p2, const float *p3, float t, float *out,
                   size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = lane_bspline(p0[i], p1[i], p2[i], p3[i], t);
}

KERNEL(vec3_bspline_at)(nkw_vec3_view p0, nkw_vec3_view p1, nkw_vec3_view p2, nkw_vec3_view p3, float t,
                        nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, lane_vec3_bspline(at_vec3(p0, i), at_vec3(p1, i), at_vec3(p2, i), at_vec3(p3, i), t));
}

KERNEL(catmull_rom)(const float *p0, const float *p1, const float *p2, const float *p3, const float *t, float *out,
                    size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = lane_catmull_rom(p0[i], p1[i], p2[i], p3[i], t[i]);
}

KERNEL(vec3_catmull_rom)(nkw_vec3_view p0, nkw_vec3_view p1, nkw_vec3_view p2, nkw_vec3_view p3, const float *t,
                         nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, lane_vec3_catmull_rom(at_vec3(p0, i), at_vec3(p1, i), at_vec3(p2, i), at_vec3(p3, i), t[i]));
}

KERNEL(catmull_rom_at)(const float *p0, const float *p1, const float *p2, const float *p3, float t, float *out,
                       size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = lane_catmull_rom(p0[i], p1[i], p2[i], p3[i], t);
}

KERNEL(vec3_catmull_rom_at)(nkw_vec3_view p0, nkw_vec3_view p1, nkw_vec3_view p2, nkw_vec3_view p3, float t,
                            nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, lane_vec3_catmull_rom(at_vec3(p0, i), at_vec3(p1, i), at_vec3(p2, i), at_vec3(p3, i), t));
}
