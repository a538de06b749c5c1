/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/curve.h>

#include "batch/curve.h"
#include "batch/element.h"

NKW_LOOPS_CURVE(NKW_DECLARE_LOOP)

NKW_LOOPS_CURVE(NKW_DECLARE_LOOP)

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
    NKW_LOOP(name)                                                                                                     \
    (const float *a, const float *b, const float *c, const float *d, const float *t, float *out, size_t n)             \
    {                                                                                                                  \
        each(f, a, b, c, d, t, out, n);                                                                                \
    }                                                                                                                  \
    NKW_LOOP(name_at)(const float *a, const float *b, const float *c, const float *d, float t, float *out, size_t n)   \
    {                                                                                                                  \
        each_at(f, a, b, c, d, t, out, n);                                                                             \
    }

#define VEC3_CURVE(name, name_at, f)                                                                                   \
    NKW_LOOP(name)                                                                                                     \
    (nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_view c, nkw_vec3_view d, const float *t, nkw_vec3_span out, size_t n)  \
    {                                                                                                                  \
        each_vec3(f, a, b, c, d, t, out, n);                                                                           \
    }                                                                                                                  \
    NKW_LOOP(name_at)                                                                                                  \
    (nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_view c, nkw_vec3_view d, float t, nkw_vec3_span out, size_t n)         \
    {                                                                                                                  \
        each_vec3_at(f, a, b, c, d, t, out, n);                                                                        \
    }

CURVE(nkw_hermite_n, nkw_hermite_at_n, nkw_hermite)
CURVE(nkw_bezier_n, nkw_bezier_at_n, nkw_bezier)
CURVE(nkw_bspline_n, nkw_bspline_at_n, nkw_bspline)
CURVE(nkw_catmull_rom_n, nkw_catmull_rom_at_n, nkw_catmull_rom)
VEC3_CURVE(nkw_vec3_hermite_n, nkw_vec3_hermite_at_n, nkw_vec3_hermite)
VEC3_CURVE(nkw_vec3_bezier_n, nkw_vec3_bezier_at_n, nkw_vec3_bezier)
VEC3_CURVE(nkw_vec3_bspline_n, nkw_vec3_bspline_at_n, nkw_vec3_bspline)
VEC3_CURVE(nkw_vec3_catmull_rom_n, nkw_vec3_catmull_rom_at_n, nkw_vec3_catmull_rom)
