/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/curve.h>

#include "batch/element.h"
#include "batch/table.h"
#include "lane/curve.h"

typedef float cubic(float, float, float, float, float);
typedef nkw_vec3 vec3_cubic(nkw_vec3, nkw_vec3, nkw_vec3, nkw_vec3, float);

/* Each kind of curve has four control values a..d; for Hermite they are p0, v0, p1, v1. */

static inline void each(cubic *f, const float *a, const float *b, const float *c, const float *d, const float *t,
                        float *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = f(a[i], b[i], c[i], d[i], t[i]);
}

static inline void each_at(cubic *f, const float *a, const float *b, const float *c, const float *d, float t,
                           float *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = f(a[i], b[i], c[i], d[i], t);
}

static inline void each_vec3(vec3_cubic *f, nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_view c, nkw_vec3_view d,
                             const float *t, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, f(at_vec3(a, i), at_vec3(b, i), at_vec3(c, i), at_vec3(d, i), t[i]));
}

static inline void each_vec3_at(vec3_cubic *f, nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_view c, nkw_vec3_view d,
                                float t, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, f(at_vec3(a, i), at_vec3(b, i), at_vec3(c, i), at_vec3(d, i), t));
}

KERNEL(hermite)(const float *p0, const float *v0, const float *p1, const float *v1, const float *t, float *out,
                size_t n)
{
    each(nkw_hermite, p0, v0, p1, v1, t, out, n);
}

KERNEL(vec3_hermite)(nkw_vec3_view p0, nkw_vec3_view v0, nkw_vec3_view p1, nkw_vec3_view v1, const float *t,
                     nkw_vec3_span out, size_t n)
{
    each_vec3(nkw_vec3_hermite, p0, v0, p1, v1, t, out, n);
}

KERNEL(hermite_at)(const float *p0, const float *v0, const float *p1, const float *v1, float t, float *out,
                   size_t n)
{
    each_at(nkw_hermite, p0, v0, p1, v1, t, out, n);
}

KERNEL(vec3_hermite_at)(nkw_vec3_view p0, nkw_vec3_view v0, nkw_vec3_view p1, nkw_vec3_view v1, float t,
                        nkw_vec3_span out, size_t n)
{
    each_vec3_at(nkw_vec3_hermite, p0, v0, p1, v1, t, out, n);
}

KERNEL(bezier)(const float *p0, const float *p1, const float *p2, const float *p3, const float *t, float *out,
               size_t n)
{
    each(nkw_bezier, p0, p1, p2, p3, t, out, n);
}

KERNEL(vec3_bezier)(nkw_vec3_view p0, nkw_vec3_view p1, nkw_vec3_view p2, nkw_vec3_view p3, const float *t,
                    nkw_vec3_span out, size_t n)
{
    each_vec3(nkw_vec3_bezier, p0, p1, p2, p3, t, out, n);
}

KERNEL(bezier_at)(const float *p0, const float *p1, const float *p2, const float *p3, float t, float *out,
                  size_t n)
{
    each_at(nkw_bezier, p0, p1, p2, p3, t, out, n);
}

KERNEL(vec3_bezier_at)(nkw_vec3_view p0, nkw_vec3_view p1, nkw_vec3_view p2, nkw_vec3_view p3, float t,
                       nkw_vec3_span out, size_t n)
{
    each_vec3_at(nkw_vec3_bezier, p0, p1, p2, p3, t, out, n);
}

KERNEL(bspline)(const float *p0, const float *p1, const float *p2, const float *p3, const float *t, float *out,
                size_t n)
{
    each(nkw_bspline, p0, p1, p2, p3, t, out, n);
}

KERNEL(vec3_bspline)(nkw_vec3_view p0, nkw_vec3_view p1, nkw_vec3_view p2, nkw_vec3_view p3, const float *t,
                     nkw_vec3_span out, size_t n)
{
    each_vec3(nkw_vec3_bspline, p0, p1, p2, p3, t, out, n);
}

KERNEL(bspline_at)(const float *p0, const float *p1, const float *p2, const float *p3, float t, float *out,
                   size_t n)
{
    each_at(nkw_bspline, p0, p1, p2, p3, t, out, n);
}

KERNEL(vec3_bspline_at)(nkw_vec3_view p0, nkw_vec3_view p1, nkw_vec3_view p2, nkw_vec3_view p3, float t,
                        nkw_vec3_span out, size_t n)
{
    each_vec3_at(nkw_vec3_bspline, p0, p1, p2, p3, t, out, n);
}

KERNEL(catmull_rom)(const float *p0, const float *p1, const float *p2, const float *p3, const float *t, float *out,
                    size_t n)
{
    each(nkw_catmull_rom, p0, p1, p2, p3, t, out, n);
}

KERNEL(vec3_catmull_rom)(nkw_vec3_view p0, nkw_vec3_view p1, nkw_vec3_view p2, nkw_vec3_view p3, const float *t,
                         nkw_vec3_span out, size_t n)
{
    each_vec3(nkw_vec3_catmull_rom, p0, p1, p2, p3, t, out, n);
}

KERNEL(catmull_rom_at)(const float *p0, const float *p1, const float *p2, const float *p3, float t, float *out,
                       size_t n)
{
    each_at(nkw_catmull_rom, p0, p1, p2, p3, t, out, n);
}

KERNEL(vec3_catmull_rom_at)(nkw_vec3_view p0, nkw_vec3_view p1, nkw_vec3_view p2, nkw_vec3_view p3, float t,
                            nkw_vec3_span out, size_t n)
{
    each_vec3_at(nkw_vec3_catmull_rom, p0, p1, p2, p3, t, out, n);
}
