/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/euler.h>

#include "batch/euler.h"
#include "lane/euler.h"
#include "lane/scalar.h"
#include "sizes.h"

NKW_LOOPS_EULER(NKW_DECLARE_LOOP)

/* As for single angles (see batch/scalar.c): blocks with a far angle take the single function. */

static inline int any_far(nkw_vec3_view angles, size_t from, size_t to)
{
    int far = 0;
#pragma omp simd reduction(| : far)
    for (size_t i = from; i < to; i++)
        far |= lane_angle_is_far(angles.x[i]) | lane_angle_is_far(angles.y[i]) | lane_angle_is_far(angles.z[i]);
    return far;
}

/* Angles and parts in the order of the product: i, j, k, and for the parts w. */
static void near_block(const float *const angles[3], double e, float *const parts[4], size_t from, size_t to)
{
    const float *ai = angles[0], *aj = angles[1], *ak = angles[2];
    float *pi = parts[0], *pj = parts[1], *pk = parts[2], *pw = parts[3];
#pragma omp simd
    for (size_t n = from; n < to; n++) {
        lane_sincos i = lane_sincos64(0.5 * (double)ai[n]);
        lane_sincos j = lane_sincos64(0.5 * (double)aj[n]);
        lane_sincos k = lane_sincos64(0.5 * (double)ak[n]);
        lane_f64_quat p = lane_f64_quat_from_halves(i, j, k, e);
        pi[n] = (float)p.x;
        pj[n] = (float)p.y;
        pk[n] = (float)p.z;
        pw[n] = (float)p.w;
    }
}

static void far_block(const float *const angles[3], double e, float *const parts[4], size_t from, size_t to)
{
    for (size_t n = from; n < to; n++) {
        lane_f64_quat p = lane_f64_quat_from_half_angles(0.5 * (double)angles[0][n], 0.5 * (double)angles[1][n],
                                                         0.5 * (double)angles[2][n], e);
        parts[0][n] = (float)p.x;
        parts[1][n] = (float)p.y;
        parts[2][n] = (float)p.z;
        parts[3][n] = (float)p.w;
    }
}

NKW_LOOP(nkw_quat_from_euler_n)(nkw_vec3_view angles, nkw_euler_order order, nkw_quat_span out, size_t n)
{
    const lane_euler_axes *o = lane_euler_axes_of(order);
    const float *const in[3] = {angles.x, angles.y, angles.z};
    float *const to[3] = {out.x, out.y, out.z};
    const float *const turns[3] = {in[o->i], in[o->j], in[o->k]};
    float *const parts[4] = {to[o->i], to[o->j], to[o->k], out.w};
    for (size_t from = 0; from < n; from += ANGLE_BLOCK) {
        size_t end = n - from < ANGLE_BLOCK ? n : from + ANGLE_BLOCK;
        if (any_far(angles, from, end))
            far_block(turns, o->e, parts, from, end);
        else
            near_block(turns, o->e, parts, from, end);
    }
}
