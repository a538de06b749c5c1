/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/scalar.h>

#include "batch/scalar.h"
#include "lane/scalar.h"
#include "lane/two.h"

NKW_LOOPS_SCALAR(NKW_DECLARE_LOOP)

/*
 * Angles come in blocks. The lanes for near angles vectorise; far ones, which are rare, are done again by the single
 * functions. So are all of a block of so few that most of them would be left over by vectors.
 */
#define BLOCK 256
#define FEW   8

/* 2^20 and more, NaN and inf included, by their bits without the sign. */
#define FAR 0x49800000u

typedef float function(float);

static inline int any_far(const float *angle, size_t n)
{
    uint32_t far = 0;
#pragma omp simd reduction(| : far)
    for (size_t i = 0; i < n; i++)
        far |= ((lane_bits(angle[i]) & 0x7FFFFFFFu) + (0x80000000u - FAR));
    return far >> 31 != 0;
}

static inline void each(function *f, const float *x, float *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = f(x[i]);
}

/* In place the angles are gone by then, so these are kept. */
static inline void each_angle_again(function *near, function *any, const float *angle, float *out, size_t n)
{
    float kept[BLOCK];
    memcpy(kept, angle, n * sizeof *kept);
    each(near, kept, out, n);
    for (size_t k = 0; k < n; k++)
        out[k] = lane_angle_is_far(kept[k]) ? any(kept[k]) : out[k];
}

static inline void each_angle(function *near, function *any, const float *angle, float *out, size_t n)
{
    for (size_t i = 0; i < n; i += BLOCK) {
        size_t count = n - i < BLOCK ? n - i : BLOCK;
        if (count < FEW)
            for (size_t k = i; k < i + count; k++)
                out[k] = any(angle[k]);
        else if (any_far(angle + i, count))
            each_angle_again(near, any, angle + i, out + i, count);
        else
            each(near, angle + i, out + i, count);
    }
}

NKW_LOOP(nkw_sqrt_n)(const float *x, float *out, size_t n)
{
    each(sqrtf, x, out, n);
}

NKW_LOOP(nkw_sin_n)(const float *angle, float *out, size_t n)
{
    each_angle(lane_sin, lane_sin_any, angle, out, n);
}

NKW_LOOP(nkw_cos_n)(const float *angle, float *out, size_t n)
{
    each_angle(lane_cos, lane_cos_any, angle, out, n);
}

static inline void put_sincos(float *sine, float *cosine, size_t i, lane_sincos a)
{
    sine[i] = (float)a.s;
    cosine[i] = (float)a.c;
}

static inline void sincos_each(const float *angle, float *sine, float *cosine, size_t n)
{
#pragma omp simd
    for (size_t k = 0; k < n; k++)
        put_sincos(sine, cosine, k, lane_sincos64((double)angle[k]));
}

static inline void sincos_each_again(const float *angle, float *sine, float *cosine, size_t n)
{
    float kept[BLOCK];
    memcpy(kept, angle, n * sizeof *kept);
    sincos_each(kept, sine, cosine, n);
    for (size_t k = 0; k < n; k++)
        if (lane_angle_is_far(kept[k]))
            put_sincos(sine, cosine, k, lane_sincos64_single((double)kept[k]));
}

NKW_LOOP(nkw_sincos_n)(const float *angle, float *sine, float *cosine, size_t n)
{
    for (size_t i = 0; i < n; i += BLOCK) {
        size_t count = n - i < BLOCK ? n - i : BLOCK;
        if (count < FEW)
            for (size_t k = i; k < i + count; k++)
                put_sincos(sine, cosine, k, lane_sincos64_single((double)angle[k]));
        else if (any_far(angle + i, count))
            sincos_each_again(angle + i, sine + i, cosine + i, count);
        else
            sincos_each(angle + i, sine + i, cosine + i, count);
    }
}

NKW_LOOP(nkw_tan_n)(const float *angle, float *out, size_t n)
{
    each_angle(lane_tan, lane_tan_any, angle, out, n);
}

NKW_LOOP(nkw_asin_n)(const float *x, float *out, size_t n)
{
    each(lane_asin, x, out, n);
}

NKW_LOOP(nkw_acos_n)(const float *x, float *out, size_t n)
{
    each(lane_acos, x, out, n);
}

NKW_LOOP(nkw_atan_n)(const float *x, float *out, size_t n)
{
    each(lane_atan, x, out, n);
}

NKW_LOOP(nkw_atan2_n)(const float *y, const float *x, float *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = lane_atan2(y[i], x[i]);
}

NKW_LOOP(nkw_exp_n)(const float *x, float *out, size_t n)
{
    each(lane_exp, x, out, n);
}

NKW_LOOP(nkw_log_n)(const float *x, float *out, size_t n)
{
    each(lane_log, x, out, n);
}

NKW_LOOP(nkw_pow_n)(const float *x, const float *y, float *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = lane_pow(x[i], y[i]);
}

NKW_LOOP(nkw_wrap_angle_n)(const float *angle, float *out, size_t n)
{
    each_angle(lane_wrap_angle, lane_wrap_angle_any, angle, out, n);
}

NKW_LOOP(nkw_lerp_n)(const float *a, const float *b, const float *t, float *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = nkw_lerp(a[i], b[i], t[i]);
}

NKW_LOOP(nkw_lerp_at_n)(const float *a, const float *b, float t, float *out, size_t n)
{
#pragma omp simd
    for (size_t i = 0; i < n; i++)
        out[i] = nkw_lerp(a[i], b[i], t);
}
