/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/curve.h>

#include "batch/element.h"
#include "batch/table.h"

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

#define CURVE(name, name_at, f)                                                                                        \
    KERNEL(name)(const float *a, const float *b, const float *c, const float *d, const float *t, float *out, size_t n) \
    {                                                                                                                  \
        each(f, a, b, c, d, t, out, n);                                                                                \
    }                                                                                                                  \
    KERNEL(name_at)(const float *a, const float *b, const float *c, const float *d, float t, float *out, size_t n)     \
    {                                                                                                                  \
        each_at(f, a, b, c, d, t, out, n);                                                                             \
    }

#define VEC3_CURVE(name, name_at, f)                                                                                   \
    KERNEL(name)(nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_view c, nkw_vec3_view d, const float *t,                   \
                 nkw_vec3_span out, size_t n)                                                                          \
    {                                                                                                                  \
        each_vec3(f, a, b, c, d, t, out, n);                                                                           \
    }                                                                                                                  \
    KERNEL(name_at)(nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_view c, nkw_vec3_view d, float t, nkw_vec3_span out,    \
                    size_t n)                                                                                          \
    {                                                                                                                  \
        each_vec3_at(f, a, b, c, d, t, out, n);                                                                        \
    }

CURVE(hermite, hermite_at, nkw_hermite)
CURVE(bezier, bezier_at, nkw_bezier)
CURVE(bspline, bspline_at, nkw_bspline)
CURVE(catmull_rom, catmull_rom_at, nkw_catmull_rom)
VEC3_CURVE(vec3_hermite, vec3_hermite_at, nkw_vec3_hermite)
VEC3_CURVE(vec3_bezier, vec3_bezier_at, nkw_vec3_bezier)
VEC3_CURVE(vec3_bspline, vec3_bspline_at, nkw_vec3_bspline)
VEC3_CURVE(vec3_catmull_rom, vec3_catmull_rom_at, nkw_vec3_catmull_rom)
