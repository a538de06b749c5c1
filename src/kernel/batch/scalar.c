/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/scalar.h>

#include "batch/scalar.h"
#include "lane/scalar.h"
#include "pack/sincos.h"
#include "sizes.h"

NKW_LOOPS_SCALAR(NKW_DECLARE_LOOP)

/*
 * Angles are taken in blocks. The lanes for angles below 2^20 vectorise; larger ones, which are rare, are computed
 * again by the scalar function. So are all angles of a block that is shorter than ANGLE_FEW.
 */

/* 2^20 and more, NaN and inf included, by their bits without the sign. */
#define ANGLE_LARGE 0x49800000u

static inline int any_far(const float *angle, size_t n)
{
    uint32_t far = 0;
#pragma omp simd reduction(| : far)
    for (size_t i = 0; i < n; i++)
        far |= ((lane_bits(angle[i]) & 0x7FFFFFFFu) + (0x80000000u - ANGLE_LARGE));
    return far >> 31 != 0;
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
    float kept[ANGLE_BLOCK];
    memcpy(kept, angle, n * sizeof *kept);
    sincos_each(kept, sine, cosine, n);
    for (size_t k = 0; k < n; k++)
        if (lane_angle_is_far(kept[k]))
            put_sincos(sine, cosine, k, f64x2_sincos_any((double)kept[k]));
}

NKW_LOOP(nkw_sincos_n)(const float *angle, float *sine, float *cosine, size_t n)
{
    for (size_t i = 0; i < n; i += ANGLE_BLOCK) {
        size_t count = n - i < ANGLE_BLOCK ? n - i : ANGLE_BLOCK;
        if (count < ANGLE_FEW)
            for (size_t k = i; k < i + count; k++)
                put_sincos(sine, cosine, k, f64x2_sincos_any((double)angle[k]));
        else if (any_far(angle + i, count))
            sincos_each_again(angle + i, sine + i, cosine + i, count);
        else
            sincos_each(angle + i, sine + i, cosine + i, count);
    }
}
