/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Quaternions as rotations.
 *
 * Components are stored as x, y, z, w; q = w + x i + y j + z k. A rotation by `angle` about the unit `axis`:
 *
 *     q = (axis sin(angle/2), cos(angle/2)),        |q| = 1,        q and -q are the same rotation
 *
 * Sums of four products are evaluated as (x + y) + (z + w). A quaternion is unit if its length is 1 to within 1e-5; the
 * products below lose far less. Rotations are right-handed: a positive angle about z rotates x towards y.
 *
 * Example  nkw_quat a, b, q; nkw_quat *list; nkw_vec3 v, axis, up; nkw_mat3 m; nkw_axis_angle turn;
 *          nkw_swing_twist parts; float angle, wxyz[4], *weights;
 *
 *     q = nkw_quat_identity();                     no rotation
 *     q = nkw_quat_add(a, b);                      for sums with weights
 *     q = nkw_quat_sub(a, b);
 *     q = nkw_quat_scale(a, 0.5f);
 *     q = nkw_quat_negate(q);                      the same rotation
 *     q = nkw_quat_conjugate(q);                   the inverse of a unit quaternion
 *     angle = nkw_quat_dot(a, b);                  negative: the longer arc
 *     nkw_quat_is_finite(q);
 *     q = nkw_quat_mul(a, b);                      turns by b, then by a
 *     v = nkw_quat_rotate(q, v);
 *     v = nkw_quat_rotate_inverse(q, v);           by the inverse
 *     angle = nkw_quat_length(q);
 *     q = nkw_quat_normalize(q);                   zero becomes the identity
 *     q = nkw_quat_inverse(q);                     of any length
 *     q = nkw_quat_from_axis_angle(axis, 1.5f);
 *     turn = nkw_axis_angle_from_quat(q);
 *     q = nkw_quat_from_vectors(v, axis);          the shortest rotation from v to axis
 *     q = nkw_quat_look_rotation(v, up);           look at: -z along v
 *     q = nkw_quat_from_mat3(&m);                  the nearest rotation
 *     angle = nkw_quat_angle(a, b);                between two rotations
 *     nkw_quat_equal_within(a, b, 0.001f);         by their angle
 *     parts = nkw_quat_swing_twist(q, axis);       q = swing twist
 *     angle = nkw_quat_twist_angle(q, axis);
 *     q = nkw_quat_mean(list, 3, weights);         of many rotations
 *     q = nkw_quat_from_wxyz(wxyz);                w first
 *     nkw_quat_to_wxyz(q, wxyz);
 */
#ifndef NAKAWARI_QUAT_H
#define NAKAWARI_QUAT_H

#include <stddef.h>

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** An axis (unit, or zero for the identity) and an angle in radians about it. */
typedef struct nkw_axis_angle {
    nkw_vec3 axis;
    float angle;
} nkw_axis_angle;
NKW_SIZE(nkw_axis_angle, 16, 16);

/** A rotation in two parts: q = swing * twist, first about an axis, then of that axis. */
typedef struct nkw_swing_twist {
    nkw_quat swing, twist;
} nkw_swing_twist;
NKW_SIZE(nkw_swing_twist, 32, 32);

/** (0, 0, 0, 1): no rotation. */
NKW_ALGEBRA nkw_quat nkw_quat_identity(void);
/** a + b, component by component. */
NKW_ALGEBRA nkw_quat nkw_quat_add(nkw_quat a, nkw_quat b);
/** a - b, component by component. */
NKW_ALGEBRA nkw_quat nkw_quat_sub(nkw_quat a, nkw_quat b);
/** s a, component by component. */
NKW_ALGEBRA nkw_quat nkw_quat_scale(nkw_quat a, float s);
/** -q: the other quaternion of the same rotation. */
NKW_ALGEBRA nkw_quat nkw_quat_negate(nkw_quat q);
/** (-x, -y, -z, w): the inverse of a unit quaternion. */
NKW_ALGEBRA nkw_quat nkw_quat_conjugate(nkw_quat q);
/**
 * a.b = (a.x b.x + a.y b.y) + (a.z b.z + a.w b.w): for unit a, b the cosine of half the angle of the rotation from a to
 * b.
 *
 * Error  3.0 u of |a| |b|.
 */
NKW_ALGEBRA float nkw_quat_dot(nkw_quat a, nkw_quat b);
/** 1 if all four components are finite, otherwise 0. */
NKW_ALGEBRA int nkw_quat_is_finite(nkw_quat q);

/**
 * The product a b: rotation by b, then by a: rotate(mul(a, b), v) = rotate(a, rotate(b, v)).
 *
 * Error  2.8 u for inputs unit to rounding (2.44 at 0x1.c7b73ep-4, 0x1.8a0c82p-6, -0x1.e0927ep-1, 0x1.4d73f4p-2 times
 *        -0x1.34d24cp-1, 0x1.a7cf1ep-4, 0x1.23541ap-1, 0x1.193ccap-1), 3.0 u for inputs unit to 1e-5.
 * Source Hamilton, On Quaternions, 1844.
 */
NKW_ALGEBRA nkw_quat nkw_quat_mul(nkw_quat a, nkw_quat b);

/**
 * v rotated by the unit quaternion q.
 *
 *     c = 2 (q.xyz x v),        v' = v + w c + q.xyz x c
 *
 * Error  20.0 u of |v| for q from nkw_quat_normalize, 11.5 for a unit q with each component rounded once (both near
 *        half turns); exact for the identity.
 */
NKW_ALGEBRA nkw_vec3 nkw_quat_rotate(nkw_quat q, nkw_vec3 v);

/**
 * v rotated by the inverse of q: rotate(conjugate(q), v).
 *
 * Error  20.0 u of |v|, as nkw_quat_rotate.
 */
NKW_ALGEBRA nkw_vec3 nkw_quat_rotate_inverse(nkw_quat q, nkw_vec3 v);

/**
 * |q|, without intermediate overflow or underflow.
 *
 * Error  0.501 ULP.
 */
NKW_API float nkw_quat_length(nkw_quat q);

/**
 * q / |q| for every finite q, including subnormal and huge ones. The zero quaternion returns the identity. Computed as
 * nkw_vec3_normalize.
 *
 * Error  3.1 u (2.97 at 0x1.55dc36p-117, 0x1.01bc48p-117, 0x1.015246p-108, 0x1.32eee4p-118; 2.3 of 65,536 random
 *        quaternions).
 */
NKW_ALGEBRA_ROOT nkw_quat nkw_quat_normalize(nkw_quat q);

/**
 * The multiplicative inverse conjugate(q) / |q|^2, for any q. The zero quaternion returns the identity.
 * For a unit quaternion, nkw_quat_conjugate is the same rotation and costs less.
 *
 * Error  1.0 u.
 */
NKW_API nkw_quat nkw_quat_inverse(nkw_quat q);

/**
 * The rotation by `angle` radians about `axis`, which need not be unit. A zero axis returns the identity.
 *
 * Error  0.91 u.
 */
NKW_API nkw_quat nkw_quat_from_axis_angle(nkw_vec3 axis, float angle);

/**
 * The axis and the angle of q, angle in 0..pi. Of q and -q, the one with w >= 0 is used. The identity returns the zero
 * axis and angle 0. q need not be unit.
 *
 * Error  0.91 u of the axis, 0.501 ULP of the angle.
 */
NKW_API nkw_axis_angle nkw_axis_angle_from_quat(nkw_quat q);

/**
 * The shortest rotation from the direction `from` to the direction `to`; neither need be unit. For opposite directions
 * it is the rotation by pi about nkw_vec3_perpendicular(from). A zero vector returns the identity.
 *
 *     q = normalize(from x to, |from| |to| + from.to)
 *
 * Error  0.91 u, also for opposite inputs.
 */
NKW_API nkw_quat nkw_quat_from_vectors(nkw_vec3 from, nkw_vec3 to);

/**
 * The orientation that looks along `forward` with `up` above; to look at a point, forward is the point minus the own
 * position. It rotates -z to forward, and +y to the direction perpendicular to forward that is nearest to up. This is
 * the convention of cameras in OpenGL and glTF, and of the key frames in keyframe.h. For an object that faces +z, pass
 * -forward.
 *
 * forward = 0 returns the identity. If up is 0 or parallel to forward, to within 2^-30 rad, it is replaced by
 * nkw_vec3_perpendicular(-forward).
 *
 * Error  0.91 u.
 */
NKW_API nkw_quat nkw_quat_look_rotation(nkw_vec3 forward, nkw_vec3 up);

/**
 * The quaternion of the rotation nearest to m. If m is a rotation, the component of largest magnitude is positive; for
 * other matrices not always.
 *
 * K is the symmetric 4x4 matrix that equals 4 q q^T for a rotation. The row of K with the largest diagonal element is
 * multiplied by K twice and normalised, in binary32. This converges to the dominant eigenvector of K, the nearest
 * rotation. It works at every angle, including half turns. m may differ from a rotation by rounding and drift:
 * deviations of its columns of 1e-3 do not increase the error. m must not mirror or scale (nkw_trs_from_mat4 removes
 * both).
 *
 * Any other finite matrix returns a unit quaternion, computed in binary64 if its elements are so large that binary32
 * could overflow; NaN returns NaN.
 *
 * Error  4.2 u against the rotation nearest to m; 3.4 u if m is a rotation with each element rounded once.
 * Source Bar-Itzhack, New Method for Extracting the Quaternion from a Rotation Matrix, 2000;
 *        Markley, Unit Quaternion from Rotation Matrix, 2008.
 */
NKW_API nkw_quat nkw_quat_from_mat3(const nkw_mat3 *m);

/**
 * The angle in radians, 0..pi, of the rotation from a to b: 2 atan2(|v|, |w|) with (v, w) = conjugate(a) b.
 * Neither need be unit; the angle to a zero quaternion is 0.
 *
 * Error  0.52 ULP.
 */
NKW_API float nkw_quat_angle(nkw_quat a, nkw_quat b);

/** 1 if a and b are the same rotation to within `angle` radians, q and -q being equal; otherwise 0, also for NaN. */
NKW_API int nkw_quat_equal_within(nkw_quat a, nkw_quat b, float angle);

/**
 * Swing and twist: the twist is a rotation about `axis`, and the swing, applied after it, rotates the axis by the
 * shortest arc to where q rotates it. With a = axis/|axis| and q = (v, w):
 *
 *     twist = normalize((v.a) a, w),      swing = q twist^-1,      q/|q| = swing twist
 *
 * The axis of the swing is perpendicular to a, and its w is not negative: an angle of at most half a turn. The twist
 * has the sign of q: for q with w >= 0 its angle is at most half a turn.
 *
 * Neither q nor axis need be unit. If q rotates the axis to its opposite, to within 2^-48 rad, every twist has such a
 * swing; the twist is then the identity. From 2^-48 to 2^-28 rad, rounding of the inputs decides. A zero axis returns
 * the identity as twist; the zero quaternion returns two identities.
 *
 * Error  0.91 u of each part, if q rotates the axis to at least 2^-28 rad from its opposite.
 * Source Dobrowolski, Swing-twist decomposition in Clifford algebra, arXiv:1506.05481, 2015.
 */
NKW_API nkw_swing_twist nkw_quat_swing_twist(nkw_quat q, nkw_vec3 axis);

/**
 * The angle of the twist of q about `axis`, in -pi..pi, of q or -q, whichever has the smaller angle:
 * 2 atan2(v.a, w) for w >= 0. It is 0 where nkw_quat_swing_twist returns the identity as twist.
 *
 * Error  0.52 ULP, if |v.a| is at least 2^-20 |v| and q rotates the axis to at least 2^-20 rad from its opposite.
 */
NKW_API float nkw_quat_twist_angle(nkw_quat q, nkw_vec3 axis);

/**
 * The weighted mean of `count` rotations: the unit quaternion m with the largest sum of weight[i] (q[i].m)^2, which
 * minimises the weighted sum of squared chords between the rotation matrices. The signs of the quaternions, and their
 * order except for rounding, have no effect.
 *
 *     m = the eigenvector of the largest eigenvalue of M = sum of weight[i] q[i] q[i]^T
 *
 * M is squared and divided by its trace 32 times; all its columns are then multiples of m. Of m and -m it returns the
 * one with m.q[0] >= 0. If several m have the same sum, as for two rotations by half a turn from each other, it returns
 * one of them, the same on every target.
 *
 * rotations  `count` quaternions, unit; another length multiplies the weight by its square
 * weights    `count` weights, or NULL: all equal. A negative weight counts as 0.
 * Returns    the identity for count 0, or if all weights are 0; NaN for input that is not finite
 *
 * Error  0.91 u, if the two largest eigenvalues differ by at least 2^-20 of their sum.
 * Source Markley, Cheng, Crassidis, Oshman, Averaging Quaternions, Journal of Guidance, Control, and Dynamics 30(4),
 *        2007.
 */
NKW_API nkw_quat nkw_quat_mean(const nkw_quat *rotations, size_t count, const float *weights);

/** The quaternion from components stored as w, x, y, z, and back. */
NKW_API nkw_quat nkw_quat_from_wxyz(const float wxyz[4]);
NKW_API void nkw_quat_to_wxyz(nkw_quat q, float wxyz[4]);

#ifdef __cplusplus
}
#endif

#if NKW_INLINE || defined(NKW_DEFINE_ALGEBRA)
#include "inline/quat.h"
#endif

#endif
