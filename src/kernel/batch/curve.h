/* SPDX-License-Identifier: MIT */
/* The loops of curve.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_CURVE_H
#define NAKAWARI_BATCH_CURVE_H

#include <nakawari/types.h>

#include "batch/isa.h"

/* clang-format off */
#define NKW_LOOPS_CURVE(X) \
    X(nkw_vec3_hermite_n, (nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_view c, nkw_vec3_view d, const float *t, nkw_vec3_span out, size_t n), (a, b, c, d, t, out, n), n) \
    X(nkw_vec3_bezier_n, (nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_view c, nkw_vec3_view d, const float *t, nkw_vec3_span out, size_t n), (a, b, c, d, t, out, n), n) \
    X(nkw_vec3_bspline_n, (nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_view c, nkw_vec3_view d, const float *t, nkw_vec3_span out, size_t n), (a, b, c, d, t, out, n), n) \
    X(nkw_vec3_catmull_rom_n, (nkw_vec3_view a, nkw_vec3_view b, nkw_vec3_view c, nkw_vec3_view d, const float *t, nkw_vec3_span out, size_t n), (a, b, c, d, t, out, n), n)
/* clang-format on */

NKW_LOOPS_CURVE(NKW_DECLARE)

#endif
