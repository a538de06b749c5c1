/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/curve.h>

#include "batch/curve.h"
#include "batch/element.h"

NKW_LOOPS_CURVE(NKW_DECLARE_LOOP)

typedef nkw_vec3 vec3_cubic(nkw_vec3, nkw_vec3, nkw_vec3, nkw_vec3, float);

/* Each kind of curve has four control points a..d; for Hermite they are p0, v0, p1, v1. */
static inline void each(vec3_cubic *f, nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_view c, nkw_vec3_view d,
                        const float *t, nkw_vec3_span out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        put_vec3(out, i, f(at_vec3(a, i), at_vec3(b, i), at_vec3(c, i), at_vec3(d, i), t[i]));
}

#define CURVE(name, f)                                                                                                 \
    NKW_LOOP(name)                                                                                                     \
    (nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_view c, nkw_vec3_view d, const float *t, nkw_vec3_span out, size_t n)  \
    {                                                                                                                  \
        each(f, a, b, c, d, t, out, n);                                                                                \
    }

CURVE(nkw_vec3_hermite_n, nkw_vec3_hermite)
CURVE(nkw_vec3_bezier_n, nkw_vec3_bezier)
CURVE(nkw_vec3_bspline_n, nkw_vec3_bspline)
CURVE(nkw_vec3_catmull_rom_n, nkw_vec3_catmull_rom)
