/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/euler.h>

#include "batch/euler.h"
#include "lane/euler.h"
#include "sizes.h"

NKW_LOOPS_EULER(NKW_DECLARE_LOOP)

/* As for single angles (see batch/scalar.c): in blocks with a far angle, its rotations are computed in binary64. */

static inline int any_far(nkw_vec3_view angles, size_t from, size_t to)
{
    int far = 0;
#pragma omp simd reduction(| : far)
    for (size_t i = from; i < to; i++)
        far |= lane_angles_are_far(angles.x[i], angles.y[i], angles.z[i]);
    return far;
}

static inline nkw_quat near_rotation(float i, float j, float k, float e)
{
    lane_turns32 t = {lane_sincos32_of(0.5f * i), lane_sincos32_of(0.5f * j), lane_sincos32_of(0.5f * k)};
    return lane_quat_from_halves(t, e);
}

/* Angles and parts in the order of the product: i, j, k, and for the parts w. */
static void near_block(const float *const angles[3], float e, float *const parts[4], size_t from, size_t to)
{
    const float *ai = angles[0], *aj = angles[1], *ak = angles[2];
    float *pi = parts[0], *pj = parts[1], *pk = parts[2], *pw = parts[3];
#pragma omp simd
    for (size_t n = from; n < to; n++) {
        nkw_quat p = near_rotation(ai[n], aj[n], ak[n], e);
        pi[n] = p.x;
        pj[n] = p.y;
        pk[n] = p.z;
        pw[n] = p.w;
    }
}

static void far_block(nkw_vec3_view all, const float *const angles[3], float e, float *const parts[4], size_t from,
                      size_t to)
{
    for (size_t n = from; n < to; n++) {
        const float i = angles[0][n], j = angles[1][n], k = angles[2][n];
        nkw_quat p = near_rotation(i, j, k, e);
        if (lane_angles_are_far(all.x[n], all.y[n], all.z[n]))
            p = lane_quat_from_f64(
                lane_f64_quat_from_half_angles(0.5 * (double)i, 0.5 * (double)j, 0.5 * (double)k, (double)e));
        parts[0][n] = p.x;
        parts[1][n] = p.y;
        parts[2][n] = p.z;
        parts[3][n] = p.w;
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
            far_block(angles, turns, o->e, parts, from, end);
        else
            near_block(turns, o->e, parts, from, end);
    }
}
