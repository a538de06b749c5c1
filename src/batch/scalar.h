/* SPDX-License-Identifier: MIT */
/* The loops of scalar.c; batch/isa.h explains the list. */
#ifndef NAKAWARI_BATCH_SCALAR_H
#define NAKAWARI_BATCH_SCALAR_H

#include "batch/isa.h"

/* clang-format off */
#define NKW_LOOPS_SCALAR(X) \
    X(nkw_sqrt_n, (const float *x, float *out, size_t n), (x, out, n), n) \
    X(nkw_sin_n, (const float *angle, float *out, size_t n), (angle, out, n), n) \
    X(nkw_cos_n, (const float *angle, float *out, size_t n), (angle, out, n), n) \
    X(nkw_sincos_n, (const float *angle, float *sine, float *cosine, size_t n), (angle, sine, cosine, n), n) \
    X(nkw_tan_n, (const float *angle, float *out, size_t n), (angle, out, n), n) \
    X(nkw_asin_n, (const float *x, float *out, size_t n), (x, out, n), n) \
    X(nkw_acos_n, (const float *x, float *out, size_t n), (x, out, n), n) \
    X(nkw_atan_n, (const float *x, float *out, size_t n), (x, out, n), n) \
    X(nkw_atan2_n, (const float *y, const float *x, float *out, size_t n), (y, x, out, n), n) \
    X(nkw_exp_n, (const float *x, float *out, size_t n), (x, out, n), n) \
    X(nkw_log_n, (const float *x, float *out, size_t n), (x, out, n), n) \
    X(nkw_pow_n, (const float *x, const float *y, float *out, size_t n), (x, y, out, n), n) \
    X(nkw_wrap_angle_n, (const float *angle, float *out, size_t n), (angle, out, n), n) \
    X(nkw_lerp_n, (const float *a, const float *b, const float *t, float *out, size_t n), (a, b, t, out, n), n) \
    X(nkw_lerp_at_n, (const float *a, const float *b, float t, float *out, size_t n), (a, b, t, out, n), n)
/* clang-format on */

NKW_LOOPS_SCALAR(NKW_DECLARE)

#endif
