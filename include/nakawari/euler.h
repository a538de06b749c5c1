/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Euler angles, in the six Tait-Bryan orders and the six proper Euler orders.
 *
 * An nkw_vec3 contains three angles in radians: .x about X, .y about Y, .z about Z, in every order. The order is always
 * an argument. NKW_EULER_YXZ is
 *
 *     R = Ry(angles.y) Rx(angles.x) Rz(angles.z)
 *
 * This is a sequence of rotations about the moving axes from left to right (intrinsic: yaw, pitch, roll) or about the
 * fixed axes from right to left (extrinsic). Other programs use either name: "extrinsic zxy" is NKW_EULER_YXZ.
 *
 * A proper order i j i has two angles about one axis. There .x is the first angle, .y the middle one, .z the last:
 * NKW_EULER_ZXZ is R = Rz(angles.x) Rx(angles.y) Rz(angles.z).
 *
 * Angles of any size are valid input. Angles of a rotation, in the order i j k, are
 *
 *     outer angles i and k   in [-pi, pi]
 *     middle angle j         in [-pi/2, pi/2], of a proper order in [0, pi]
 *
 * At a pole (gimbal lock), j = +-pi/2, of a proper order j = 0 or pi, the outer axes coincide and only i + k or i - k is
 * defined. Within 8.5e-8 rad of a pole, j is exactly the float nearest to +-pi/2, or 0 or the float nearest to pi, k is
 * 0 and i is the angle of the whole rotation about the common axis. A quaternion rounded from angles at a pole may be
 * 1.2e-7 rad from it, one from nkw_quat_from_euler 4e-7 rad; its three angles are then computed as elsewhere.
 * At and near a pole the *rotation* of the angles has the same error as elsewhere, but the single angles i and k are
 * ill-conditioned.
 *
 * Rotations from angles of a Tait-Bryan order are computed in binary32 if x^2 + y^2 + z^2 is less than 8192^2, and
 * otherwise in binary64 and rounded once. All other functions compute in binary64 and round once: angles are differences
 * of arcs near a pole.
 *
 * Example  nkw_vec3 a, b; nkw_vec3 keys[8]; nkw_quat q; nkw_mat3 m; float t;
 *
 *     q = nkw_quat_from_euler(a, NKW_EULER_YXZ);         R = Ry Rx Rz; a.x turns about x
 *     m = nkw_mat3_from_euler(a, NKW_EULER_YXZ);
 *     a = nkw_euler_from_quat(q, NKW_EULER_YXZ);
 *     a = nkw_euler_from_mat3(&m, NKW_EULER_YXZ);
 *     a = nkw_euler_unwrap(a, b);                        each by whole turns to the nearest of b
 *     a = nkw_euler_alternate(a, NKW_EULER_YXZ);         the other angles of the rotation
 *     a = nkw_euler_nearest(a, b, NKW_EULER_YXZ);        the angles nearest to b
 *     nkw_euler_filter(keys, 8, NKW_EULER_YXZ, keys);    no jumps from key to key
 *     a = nkw_euler_lerp(a, b, t, NKW_UNWRAP_ALL);
 */
#ifndef NAKAWARI_EULER_H
#define NAKAWARI_EULER_H

#include <stddef.h>

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The order of the three factors, from left to right: NKW_EULER_XYZ is Rx Ry Rz. Any other number is read as
 * NKW_EULER_XYZ.
 */
typedef enum nkw_euler_order {
    NKW_EULER_XYZ,
    NKW_EULER_XZY,
    NKW_EULER_YXZ,
    NKW_EULER_YZX,
    NKW_EULER_ZXY,
    NKW_EULER_ZYX,
    NKW_EULER_XYX, /**< the proper orders: first angle .x, middle .y, last .z */
    NKW_EULER_XZX,
    NKW_EULER_YXY,
    NKW_EULER_YZY,
    NKW_EULER_ZXZ,
    NKW_EULER_ZYZ,
    NKW_EULER_ORDER_MAX_ENUM = 0x7fffffff
} nkw_euler_order;

/**
 * The rotation of three angles. With c, s the cosines and sines of the half angles, the order i j k, and e = +1 for
 * XYZ, YZX, ZXY, e = -1 for the others:
 *
 *     w  = ci cj ck - e si sj sk        qi = si cj ck + e ci sj sk
 *     qj = ci sj ck - e si cj sk        qk = ci cj sk + e si sj ck
 *
 * Of a proper order i j i, with a, b, c half the angles, k the remaining axis and e = +1 for XYX, YZY, ZXZ:
 *
 *     w  = cos b cos(a + c)             qi = cos b sin(a + c)
 *     qj = sin b cos(a - c)             qk = e sin b sin(a - c)
 *
 * Error  4.0 u.
 */
NKW_API nkw_quat nkw_quat_from_euler(nkw_vec3 angles, nkw_euler_order order);

/**
 * The rotation matrix of three angles. With c, s the cosines and sines of the angles, its rows and columns in the order
 * i j k are
 *
 *     cj ck                      -e cj sk                   e sj
 *     e ci sk + si sj ck         ci ck - e si sj sk         -e si cj
 *     si sk - e ci sj ck         e si ck + ci sj sk         ci cj
 *
 * Error  2.7 u (Frobenius norm / sqrt 3).
 */
NKW_API nkw_mat3 nkw_mat3_from_euler(nkw_vec3 angles, nkw_euler_order order);

/**
 * The angles of a rotation. q and -q return the same angles. q need not be unit; the zero quaternion returns zero
 * angles.
 *
 *     (i + e k)/2 = atan2(qi + e qk, w + qj)
 *     (i - e k)/2 = atan2(qi - e qk, w - qj)
 *     j = atan2(2 (w qj + e qi qk), |(w + qj, qi + e qk)| |(w - qj, qi - e qk)|)
 *
 * Of a proper order i j i, of the angles first, middle, last:
 *
 *     (first + last)/2 = atan2(qi, w),     (first - last)/2 = atan2(e qk, qj)
 *     middle = atan2(2 |(w, qi)| |(qj, qk)|, |(w, qi)|^2 - |(qj, qk)|^2)
 *
 * Error  4.2 u rad of the rotation of the returned angles; 4.0 of these are the rounding of two angles near pi.
 * Source Bernardes, Viollet, Quaternion to Euler angles conversion, PLoS ONE 17(11), 2022.
 */
NKW_API nkw_vec3 nkw_euler_from_quat(nkw_quat q, nkw_euler_order order);

/**
 * The angles of the rotation nearest to m: nkw_euler_from_quat of nkw_quat_from_mat3, without an intermediate rounding.
 *
 * Error  4.2 u rad of the rotation of the returned angles.
 */
NKW_API nkw_vec3 nkw_euler_from_mat3(const nkw_mat3 *m, nkw_euler_order order);

/**
 * Each angle, plus the multiple of 2 pi that brings it within pi of the angle in `reference`. Use it before a curve is
 * laid through the angles of several keys. An angle at a distance of exactly half a turn stays on its side.
 *
 * Error  0.501 ULP for angles up to 100 rad; for larger angles, 2e-16 of the angle more than rounding.
 */
NKW_API nkw_vec3 nkw_euler_unwrap(nkw_vec3 angles, nkw_vec3 reference);

/**
 * The other three angles of the same rotation, for the order i j k, by the sign of each angle (-0 is negative):
 *
 *     of positive angles   i - pi,   pi - j,    k - pi
 *     of negative angles   i + pi,   -pi - j,   k + pi
 *
 * and for a proper order the outer angles by half a turn in the same way, and -j.
 *
 * Error  0.501 ULP of each angle, for angles up to 2^20 rad.
 */
NKW_API nkw_vec3 nkw_euler_alternate(nkw_vec3 angles, nkw_euler_order order);

/**
 * The three angles of the same rotation that are nearest to `reference`: of nkw_euler_unwrap(angles, reference) and
 * nkw_euler_unwrap(nkw_euler_alternate(angles, order), reference), the one with the smaller sum of squared differences
 * from the reference; the first if they are equal. Across a pole, where the angles of a rotation jump by half a turn,
 * the second is the continuation.
 *
 * Error  as nkw_euler_unwrap and nkw_euler_alternate.
 */
NKW_API nkw_vec3 nkw_euler_nearest(nkw_vec3 angles, nkw_vec3 reference, nkw_euler_order order);

/**
 * The Euler filter: the angles of `count` successive rotations without jumps. The first stays, each following one is
 * nkw_euler_nearest to the result before it. The rotations are unchanged, to rounding. `out` may be `angles`.
 */
NKW_API void nkw_euler_filter(const nkw_vec3 *angles, size_t count, nkw_euler_order order, nkw_vec3 *out);

/** The angles that nkw_euler_lerp unwraps. Any other number is read as NONE. */
typedef enum nkw_unwrap {
    NKW_UNWRAP_NONE, /**< none: differences of several turns are kept */
    NKW_UNWRAP_YAW, /**< only the angle about Y, as in the university exercise (keyframe.h) */
    NKW_UNWRAP_ALL, /**< all three */
    NKW_UNWRAP_MAX_ENUM = 0x7fffffff
} nkw_unwrap;

/**
 * Linear interpolation of Euler angles.
 *
 * An angle that `unwrap` selects is unwrapped: if the angles of a and b differ by more than pi, the angle of a is first
 * moved towards that of b by 2 pi. Each unwrapped *angle* then takes its shorter direction, which is not the shorter
 * arc of the rotation.
 *
 * Returns  exactly a (or a as moved) at t = 0, exactly b at t = 1
 *
 * Error  1.0 u of the larger of |a|, |b|, for each angle separately, with a as moved, for t in 0..1.
 */
NKW_API nkw_vec3 nkw_euler_lerp(nkw_vec3 a, nkw_vec3 b, float t, nkw_unwrap unwrap);

#ifdef __cplusplus
}
#endif

#endif
