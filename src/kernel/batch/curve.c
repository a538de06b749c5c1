/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/curve.h>

#include "batch/curve.h"
#include "batch/element.h"

NKW_LOOPS_CURVE(NKW_DECLARE_LOOP)

typedef float cubic(float, float, float, float, float);

/* Each kind of curve has four control values a..d; for Hermite they are p0, v0, p1, v1. */
static inline void each(cubic *f, nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_view c, nkw_vec3_view d, const float *t,
                        nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++) {
        nkw_vec3 r = {
            f(a.x[i], b.x[i], c.x[i], d.x[i], t[i]),
            f(a.y[i], b.y[i], c.y[i], d.y[i], t[i]),
            f(a.z[i], b.z[i], c.z[i], d.z[i], t[i]),
        };
        put_vec3(out, i, r);
    }
}

#define CURVE(name, f)                                                                                                 \
    NKW_LOOP(name)                                                                                                     \
    (nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_view c, nkw_vec3_view d, const float *t, nkw_vec3_span out, size_t n)  \
    {                                                                                                                  \
        each(f, a, b, c, d, t, out, n);                                                                                \
    }

CURVE(nkw_vec3_hermite_n, nkw_hermite)
CURVE(nkw_vec3_bezier_n, nkw_bezier)
CURVE(nkw_vec3_bspline_n, nkw_bspline)
CURVE(nkw_vec3_catmull_rom_n, nkw_catmull_rom)
