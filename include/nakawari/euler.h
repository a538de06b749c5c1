/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 2: Euler angles, in the six Tait-Bryan orders.
 *
 * Three angles in radians stand in one nkw_vec3: .x turns about X, .y about Y, .z about Z, whatever the
 * order. The order is always an argument. NKW_EULER_YXZ means
 *
 *     R = Ry(angles.y) Rx(angles.x) Rz(angles.z)
 *
 * read as turns about the moving axes from left to right (intrinsic: yaw, pitch, roll) or about the fixed
 * axes from right to left (extrinsic). Other programs name the same product by either reading: an
 * "extrinsic zxy" is this YXZ.
 *
 * From angles to rotations any angles will do. From rotations to angles, with the order i j k:
 *
 *     outer angles i and k   in [-pi, pi]
 *     middle angle j         in [-pi/2, pi/2]
 *
 * At the pole, the middle angle at +-pi/2, the outer axes coincide and only i + k or i - k is defined. The
 * policy: within 8.5e-8 rad of the pole the middle angle is exactly the float nearest +-pi/2, the last angle k is 0
 * and the first carries the whole turn. A quaternion that was rounded from angles at the pole may be 1.2e-7 rad away
 * from it, and then has three angles as elsewhere. The *rotation* is right at the pole and around it, with the same
 * error as elsewhere; a single angle near the pole is as uncertain as its axes are close to each other.
 *
 * All works in binary64 inside and rounds once.
 */
#ifndef NAKAWARI_EULER_H
#define NAKAWARI_EULER_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The order of the three factors, from left to right: NKW_EULER_XYZ is Rx Ry Rz. Any other number is read
 * as NKW_EULER_XYZ.
 */
typedef enum nkw_euler_order {
    NKW_EULER_XYZ,
    NKW_EULER_XZY,
    NKW_EULER_YXZ,
    NKW_EULER_YZX,
    NKW_EULER_ZXY,
    NKW_EULER_ZYX
} nkw_euler_order;

/**
 * The rotation of three angles. With half angles, order i j k, e = +1 for XYZ YZX ZXY and -1 for the others:
 *
 *     w  = ci cj ck - e si sj sk        qi = si cj ck + e ci sj sk
 *     qj = ci sj ck - e si cj sk        qk = ci cj sk + e si sj ck
 *
 * Error  0.91 u.
 */
NKW_API nkw_quat nkw_quat_from_euler(nkw_vec3 angles, nkw_euler_order order);

/**
 * The rotation matrix of three angles, each element rounded once.
 *
 * Error  0.87 u (Frobenius norm / sqrt 3): nine elements of at most 1, each rounded once.
 */
NKW_API nkw_mat3 nkw_mat3_from_euler(nkw_vec3 angles, nkw_euler_order order);

/**
 * The angles of a rotation; q need not be unit, the zero quaternion gives zero angles. q and -q give the
 * same angles.
 *
 *     (i + e k)/2 = atan2(qi + e qk, w + qj)
 *     (i - e k)/2 = atan2(qi - e qk, w - qj)
 *     j = atan2(2 (w qj + e qi qk), |(w + qj, qi + e qk)| |(w - qj, qi - e qk)|)
 *
 * Error  4.2 u rad of the rotation built again from the angles, of which 4.0 are the rounding of two angles
 *        near pi.
 * Source Bernardes, Viollet, Quaternion to Euler angles conversion, PLoS ONE 17(11), 2022.
 */
NKW_API nkw_vec3 nkw_euler_from_quat(nkw_quat q, nkw_euler_order order);

/**
 * The angles of the rotation nearest to m: as nkw_euler_from_quat of nkw_quat_from_mat3, without a rounding
 * between.
 *
 * Error  4.2 u rad of the rotation built again from the angles.
 */
NKW_API nkw_vec3 nkw_euler_from_mat3(const nkw_mat3 *m, nkw_euler_order order);

/**
 * The same angles, each moved by whole turns to within pi of the angle in `reference`: what a curve through
 * several keys needs. An angle exactly half a turn away stays on its side.
 *
 * Error  0.501 ULP for angles up to 100 rad; beyond, 2e-16 of the angle more than rounding.
 */
NKW_API nkw_vec3 nkw_euler_unwrap(nkw_vec3 angles, nkw_vec3 reference);

/** nkw_quat_from_euler over component arrays, all in one order. See types.h for what holds of all batch functions. */
NKW_API void nkw_quat_from_euler_n(nkw_vec3_view angles, nkw_euler_order order, nkw_quat_span out, size_t n);

#ifdef __cplusplus
}
#endif

#endif
