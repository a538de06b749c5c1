/* SPDX-License-Identifier: MIT */
/* The quaternion of a rotation matrix, for single calls: the matrix K in four registers. Loops take the lanes. */
#ifndef NAKAWARI_PACK_FORM_H
#define NAKAWARI_PACK_FORM_H

#include "lane/strict.h"

#include "lane/mat.h"
#include "pack/f32x4.h"
#include "pack/f64x2.h"
#include "pack/quat.h"

#if NKW_F32X4
/* The columns of K, lane_form_from_columns, from its diagonal less 1 in three parts, and p - q = xw yw zw. */
static inline void f32x4_form(f32x4 x, f32x4 y, f32x4 z, f32x4 p, f32x4 q, f32x4 k[4])
{
    const i32x4 x_sign = {0, INT32_MIN, INT32_MIN, 0}, y_sign = {INT32_MIN, 0, INT32_MIN, 0};
    const i32x4 z_sign = {INT32_MIN, INT32_MIN, 0, 0};
    f32x4 d = ((1.0f + f32x4_flip(x, x_sign)) + f32x4_flip(y, y_sign)) + f32x4_flip(z, z_sign);
    f32x4 s = p + q, a = p - q; /* yz xz xy, xw yw zw */
    k[0] = F32X4_SHUFFLE(F32X4_SHUFFLE(d, s, 0, 0, 6, 6), F32X4_SHUFFLE(s, a, 1, 1, 4, 4), 0, 2, 4, 6);
    k[1] = F32X4_SHUFFLE(F32X4_SHUFFLE(s, d, 2, 2, 5, 5), F32X4_SHUFFLE(s, a, 0, 0, 5, 5), 0, 2, 4, 6);
    k[2] = F32X4_SHUFFLE(F32X4_SHUFFLE(s, s, 1, 0, 1, 0), F32X4_SHUFFLE(d, a, 2, 2, 6, 6), 0, 1, 4, 6);
    k[3] = F32X4_SHUFFLE(a, d, 0, 1, 2, 7);
}

static inline f32x4 f32x4_form_apply(const f32x4 k[4], f32x4 q)
{
    return (k[0] * f32x4_broadcast(q, 0) + k[1] * f32x4_broadcast(q, 1)) +
           (k[2] * f32x4_broadcast(q, 2) + k[3] * f32x4_broadcast(q, 3));
}

/* The elements of which xw yw zw are differences; of the rows of a matrix, the second ones come first. */
static inline f32x4 f32x4_first_turn(f32x4 x, f32x4 y, f32x4 z)
{
    return F32X4_SHUFFLE(F32X4_SHUFFLE(y, z, 2, 2, 4, 4), x, 0, 2, 5, 5); /* y2 z0 x1 */
}

static inline f32x4 f32x4_second_turn(f32x4 x, f32x4 y, f32x4 z)
{
    return F32X4_SHUFFLE(F32X4_SHUFFLE(z, x, 1, 1, 6, 6), y, 0, 2, 4, 4); /* z1 x2 y0 */
}

/* The row of K that lane_form_row selects, multiplied by K twice. */
static inline f32x4 f32x4_form_dominant(const f32x4 k[4])
{
    int x_over_y = k[0][0] > k[1][1], z_over_w = k[2][2] > k[3][3];
    float xy = x_over_y ? k[0][0] : k[1][1], zw = z_over_w ? k[2][2] : k[3][3];
    int row = xy > zw ? 1 - x_over_y : 3 - z_over_w;
    return f32x4_form_apply(k, f32x4_form_apply(k, k[row]));
}

/* Second text of lane_quat_from_columns; 1.4 times faster. The fourth floats of the columns are not used. */
static inline lane_nearest f32x4_quat_from_columns(f32x4 x, f32x4 y, f32x4 z)
{
    f32x4 k[4];
    f32x4_form(f32x4_broadcast(x, 0), f32x4_broadcast(y, 1), f32x4_broadcast(z, 2), f32x4_first_turn(x, y, z),
               f32x4_second_turn(x, y, z), k);
    f32x4 q = f32x4_form_dominant(k), n2 = f32x4_sum(q * q);
    lane_nearest r = {quat_from_f32x4(q / f32x4_splat(sqrtf(n2[0]))), n2[0]};
    return r;
}

/* Lanes 1 2 0, the columns after 0 1 2. */
static inline f32x4 f32x4_next(f32x4 row)
{
    return F32X4_SHUFFLE(row, row, 1, 2, 0, 3);
}

/*
 * Second text of lane_scaled_rotation_of; 1.3 times faster. Stores translation, rotation and scale as they are in an
 * nkw_trs. Returns is_near.
 */
static inline int f32x4_trs_from_mat4(const float *m, float *trs)
{
    const i32x4 first = {INT32_MIN, 0, 0, 0};
    const f32x4 t = f32x4_load(m + 12);
    f32x4 r[4] = {f32x4_load(m), f32x4_load(m + 4), f32x4_load(m + 8), f32x4_load(m + 8)}; /* lane 3 as lane 2 */
    f32x4_transpose(r);
    const f32x4 x = f32x4_next(r[0]), y = f32x4_next(r[1]), z = f32x4_next(r[2]);
    const f32x4 n2 = (r[0] * r[0] + r[1] * r[1]) + r[2] * r[2];
    const i64x2 inside = (i64x2)((n2 > LANE_LEAST_SQUARE) & (n2 < LANE_MOST_SQUARE)); /* all ones: -1 */
    if ((inside[0] & inside[1]) != -1)
        return 0;
    f32x4 scale = f32x4_sqrt(n2), inverse = 1.0f / scale;
    f32x4 cosine = ((r[0] * x + r[1] * y) + r[2] * z) * (inverse * f32x4_next(inverse));
    f32x4 across = (r[1] * z - y * r[2]) * F32X4_SHUFFLE(r[0], r[0], 2, 0, 1, 3);
    f32x4 side = {(across[0] + across[1]) + across[2]}, c2 = cosine * cosine;
    scale = f32x4_flip(scale, (i32x4)side & first);
    inverse = f32x4_flip(inverse, (i32x4)side & first);
    r[0] = r[0] * inverse, r[1] = r[1] * inverse, r[2] = r[2] * inverse;
    f32x4 k[4];
    f32x4_form(f32x4_broadcast(r[0], 0), f32x4_broadcast(r[1], 1), f32x4_broadcast(r[2], 2),
               f32x4_second_turn(r[0], r[1], r[2]), f32x4_first_turn(r[0], r[1], r[2]), k);
    f32x4 q = f32x4_form_dominant(k);
    q = q / f32x4_sqrt(f32x4_sum(q * q));
    /* In the parts that callers copy. */
    f32x4_store(trs, F32X4_SHUFFLE(t, F32X4_SHUFFLE(t, q, 2, 2, 4, 4), 0, 1, 4, 6));
    f32x4_store(trs + 4, F32X4_SHUFFLE(q, F32X4_SHUFFLE(q, scale, 3, 3, 4, 4), 1, 2, 4, 6));
    int64_t rest = ((i64x2)F32X4_SHUFFLE(scale, scale, 1, 2, 1, 2))[0];
    memcpy(trs + 8, &rest, sizeof rest);
    return (c2[0] + c2[1]) + c2[2] < LANE_LITTLE_SHEAR;
}
#endif

#endif
