/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 2: quaternions as rotations.
 *
 * Components stand as x, y, z, w; q = w + x i + y j + z k. A rotation by `angle` about the unit `axis`:
 *
 *     q = (axis sin(angle/2), cos(angle/2)),        |q| = 1,        q and -q are the same rotation
 *
 * Sums of four products are taken as (x + y) + (z + w). "Unit" means unit to within 1e-5, which is far
 * more than the products below lose. Rotations are right-handed: positive angles turn x towards y about z.
 */
#ifndef NAKAWARI_QUAT_H
#define NAKAWARI_QUAT_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** An axis (unit, or zero where there is no turn) and an angle in radians about it. */
typedef struct nkw_axis_angle {
    nkw_vec3 axis;
    float angle;
} nkw_axis_angle;

/** (0, 0, 0, 1): no rotation. */
NKW_ALGEBRA nkw_quat nkw_quat_identity(void);
/** a + b, component by component. */
NKW_ALGEBRA nkw_quat nkw_quat_add(nkw_quat a, nkw_quat b);
/** a - b, component by component. */
NKW_ALGEBRA nkw_quat nkw_quat_sub(nkw_quat a, nkw_quat b);
/** s a, component by component. */
NKW_ALGEBRA nkw_quat nkw_quat_scale(nkw_quat a, float s);
/** -q: the same rotation, the other of its two quaternions. */
NKW_ALGEBRA nkw_quat nkw_quat_negate(nkw_quat q);
/** (-x, -y, -z, w): the opposite rotation of a unit quaternion. */
NKW_ALGEBRA nkw_quat nkw_quat_conjugate(nkw_quat q);
/**
 * a.b = (a.x b.x + a.y b.y) + (a.z b.z + a.w b.w): the cosine of half the turn from a to b.
 *
 * Error  3.0 u of |a| |b|.
 */
NKW_ALGEBRA float nkw_quat_dot(nkw_quat a, nkw_quat b);
/** 1 if all four components are finite, else 0. */
NKW_ALGEBRA int nkw_quat_is_finite(nkw_quat q);

/**
 * The product a b: rotate by b, then by a, so rotate(mul(a, b), v) = rotate(a, rotate(b, v)).
 *
 * Error  2.8 u for inputs unit to rounding (2.44 at 0x1.c7b73ep-4, 0x1.8a0c82p-6, -0x1.e0927ep-1, 0x1.4d73f4p-2 times
 *        -0x1.34d24cp-1, 0x1.a7cf1ep-4, 0x1.23541ap-1, 0x1.193ccap-1), 3.0 u for inputs unit to 1e-5.
 * Source Hamilton, On Quaternions, 1844.
 */
NKW_ALGEBRA nkw_quat nkw_quat_mul(nkw_quat a, nkw_quat b);

/**
 * v turned by the unit quaternion q.
 *
 *     c = 2 (q.xyz x v),        v' = v + w c + q.xyz x c
 *
 * Error  17.0 u of |v| for q from nkw_quat_normalize, 11.5 for q rounded from a unit one (both near half turns); the
 *        identity gives v itself.
 */
NKW_ALGEBRA nkw_vec3 nkw_quat_rotate(nkw_quat q, nkw_vec3 v);

/**
 * v turned back: rotate(conjugate(q), v).
 *
 * Error  17.0 u of |v|, as nkw_quat_rotate.
 */
NKW_ALGEBRA nkw_vec3 nkw_quat_rotate_inverse(nkw_quat q, nkw_vec3 v);

/**
 * |q|, without overflow or underflow on the way.
 *
 * Error  0.501 ULP.
 */
NKW_API float nkw_quat_length(nkw_quat q);

/**
 * q / |q| for every finite q, subnormal and huge ones too; the zero quaternion gives the identity.
 *
 * Error  2.3 u.
 */
NKW_ALGEBRA_ROOT nkw_quat nkw_quat_normalize(nkw_quat q);

/**
 * The multiplicative inverse conjugate(q) / |q|^2, for any q; the zero quaternion gives the identity.
 * For unit quaternions the conjugate is the same rotation and costs nothing.
 *
 * Error  1.0 u.
 */
NKW_API nkw_quat nkw_quat_inverse(nkw_quat q);

/**
 * The turn of `angle` radians about `axis`, which need not be unit; a zero axis gives the identity.
 *
 * Error  0.91 u.
 */
NKW_API nkw_quat nkw_quat_from_axis_angle(nkw_vec3 axis, float angle);

/**
 * The axis and angle of q, angle in 0..pi: of q and -q the one with w >= 0 is read. No turn gives the
 * zero axis and angle 0. q need not be unit.
 *
 * Error  0.91 u of the axis, 0.501 ULP of the angle.
 */
NKW_API nkw_axis_angle nkw_axis_angle_from_quat(nkw_quat q);

/**
 * The shortest turn that takes the direction `from` to the direction `to`; neither need be unit.
 * Opposite directions turn by pi about nkw_vec3_perpendicular(from). A zero vector gives the identity.
 *
 *     q = normalize(from x to, |from| |to| + from.to)
 *
 * Error  0.91 u, up to exactly opposite inputs.
 */
NKW_API nkw_quat nkw_quat_from_vectors(nkw_vec3 from, nkw_vec3 to);

/**
 * The orientation that looks along `forward` with `up` above: it turns -z into forward, and +y into the
 * direction nearest `up` at right angles to it. That is the convention of OpenGL and glTF cameras, and of
 * the key frames in keyframe.h. For an object that faces +z pass the opposite of forward.
 *
 * forward zero gives the identity; up zero or along forward is replaced by nkw_vec3_perpendicular of -forward.
 *
 * Error  0.91 u. Within 2^-30 rad up counts as along forward.
 */
NKW_API nkw_quat nkw_quat_look_rotation(nkw_vec3 forward, nkw_vec3 up);

/**
 * The quaternion of the rotation nearest to m; of a rotation the component of largest magnitude comes out positive, of
 * other matrices not always.
 *
 * With K the symmetric 4x4 matrix that is 4 q q^T for a rotation, the row of largest diagonal is
 * normalised and multiplied by K twice, which converges on K's dominant eigenvector, the nearest
 * rotation. Works at every angle, half turns too, and forgives rounding and drift in m: columns off by
 * 1e-3 cost nothing. A mirror or a scale in m must be taken out before (nkw_trs_from_mat4 does).
 * A matrix that is no rotation at all still gives a unit quaternion; NaN gives NaN.
 *
 * Error  0.91 u against the rotation nearest to m.
 * Source Bar-Itzhack, New Method for Extracting the Quaternion from a Rotation Matrix, 2000;
 *        Markley, Unit Quaternion from Rotation Matrix, 2008.
 */
NKW_API nkw_quat nkw_quat_from_mat3(const nkw_mat3 *m);

/**
 * The rotation of the upper left 3x3 block of m, as nkw_quat_from_mat3.
 *
 * Error  0.91 u against the rotation nearest to m.
 */
NKW_API nkw_quat nkw_quat_from_mat4(const nkw_mat4 *m);

/**
 * The angle in radians, 0..pi, of the turn from a to b: 2 atan2(|v|, |w|) of (v, w) = a* b.
 * Neither need be unit; a zero quaternion counts as no turn.
 *
 * Error  0.52 ULP.
 */
NKW_API float nkw_quat_angle(nkw_quat a, nkw_quat b);

/** The quaternion whose components stand in memory as w, x, y, z, and back. */
NKW_API nkw_quat nkw_quat_from_wxyz(const float wxyz[4]);
NKW_API void nkw_quat_to_wxyz(nkw_quat q, float wxyz[4]);

/**
 * The same functions over component arrays: element i of the result is f of the elements i, with the very bits of
 * the single call. See types.h for what holds of all batch functions.
 */
NKW_API void nkw_quat_mul_n(nkw_quat_view a, nkw_quat_view b, nkw_quat_span out, size_t n);
NKW_API void nkw_quat_normalize_n(nkw_quat_view q, nkw_quat_span out, size_t n);
NKW_API void nkw_quat_rotate_n(nkw_quat_view q, nkw_vec3_view v, nkw_vec3_span out, size_t n);
NKW_API void nkw_quat_from_mat3_n(nkw_mat3_view m, nkw_quat_span out, size_t n);
/** From an array of quaternions to component arrays, and back. The arrays must not overlap. */
NKW_API void nkw_quat_unpack_n(const nkw_quat *in, nkw_quat_span out, size_t n);
NKW_API void nkw_quat_pack_n(nkw_quat_view in, nkw_quat *out, size_t n);

#ifdef __cplusplus
}
#endif

#if NKW_INLINE || defined(NKW_DEFINE_ALGEBRA)
#include "inline/quat.h"
#endif

#endif
