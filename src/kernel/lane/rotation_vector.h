/* SPDX-License-Identifier: MIT */
/* Rotation vectors, r = 2 log q: the axis times the angle. */
#ifndef NAKAWARI_LANE_ROTATION_VECTOR_H
#define NAKAWARI_LANE_ROTATION_VECTOR_H

#include "strict.h"

#include "arc.h"
#include "quat.h"

/* The angular velocity of the shorter arc from a to b in 1 / rate seconds. */
static inline nkw_vec3 lane_quat_rate(nkw_quat a, nkw_quat b, double rate)
{
    lane_f64_quat from = lane_f64_quat_from(a);
    lane_f64_quat to = lane_f64_quat_aligned(from, lane_f64_quat_from(b), NKW_PATH_SHORT);
    lane_f64_vec3 half = lane_f64_quat_log(lane_f64_quat_mul(to, lane_f64_quat_conjugate(from)));
    return lane_vec3_from_f64(lane_f64_vec3_scale(half, 2.0 * rate));
}

/*
 * The rate of the rotation vector r = 2 log q of a rotation q with the angular velocity w (outer frame):
 *
 *     r' = w - r x w / 2 + c r x (r x w),      c = (1 - h cot h) / (4 h^2),  h = |r|/2 = |log q|
 *
 * h < pi; at pi the rate is infinite, and c is 1/12 here. Below h = 1/8 by the series of c, to 2^-44.
 */
static inline lane_f64_vec3 lane_f64_rotation_rate(lane_f64_quat q, lane_f64_vec3 half, lane_f64_vec3 w)
{
    lane_f64_vec3 axis = {q.x, q.y, q.z};
    double h2 = lane_f64_vec3_dot(half, half), n = lane_f64_vec3_length(axis);
    double series = 1.0 / 12.0 + h2 * (1.0 / 180.0 + h2 * (1.0 / 1890.0 + h2 * (1.0 / 18900.0 + h2 / 187110.0)));
    double exact = (1.0 - lane_sqrt64(h2) * (q.w / lane_divisor64(n))) / (4.0 * lane_divisor64(h2));
    double c = h2 < 0x1p-6 ? series : exact;
    lane_f64_vec3 r = lane_f64_vec3_scale(half, 2.0);
    return lane_f64_vec3_turned(r, w, -0.5, n == 0.0 ? 1.0 / 12.0 : c);
}

/*
 * The inverse: the angular velocity of the rotation of vector r whose rate is v; s and c are sine and cosine of |r|/2.
 *
 *     w = v + (1 - cos |r|)/|r|^2 r x v + (|r| - sin |r|)/|r|^3 r x (r x v)
 */
static inline lane_f64_vec3 lane_f64_rotation_velocity(lane_f64_vec3 r, lane_sincos half, lane_f64_vec3 v)
{
    double z = lane_f64_vec3_dot(r, r), n = lane_sqrt64(z);
    double a_series = 1.0 / 2.0 - z * (1.0 / 24.0 - z * (1.0 / 720.0 - z * (1.0 / 40320.0 - z / 3628800.0)));
    double b_series = 1.0 / 6.0 - z * (1.0 / 120.0 - z * (1.0 / 5040.0 - z * (1.0 / 362880.0 - z / 39916800.0)));
    double a = 2.0 * (half.s * half.s) / lane_divisor64(z);
    double b = (n - 2.0 * (half.s * half.c)) / lane_divisor64(z * n);
    return lane_f64_vec3_turned(r, v, z < 0.25 ? a_series : a, z < 0.25 ? b_series : b);
}

#endif
