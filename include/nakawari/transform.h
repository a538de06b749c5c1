/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 2: translation, rotation and scale, and their matrix M = T R S.
 *
 * Composition runs per joint per frame and works in binary32; decomposition runs per asset and works in
 * binary64 inside.
 */
#ifndef NAKAWARI_TRANSFORM_H
#define NAKAWARI_TRANSFORM_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** No translation, no rotation, scale (1, 1, 1). */
NKW_ALGEBRA nkw_trs nkw_trs_identity(void);

/**
 * R S: the columns of the rotation matrix of q, scaled.
 *
 *     1 - 2 (yy + zz)    2 (xy - wz)        2 (xz + wy)
 *     2 (xy + wz)        1 - 2 (xx + zz)    2 (yz - wx)
 *     2 (xz - wy)        2 (yz + wx)        1 - 2 (xx + yy)
 *
 * What rounding takes from a unit q is made good. A q that is off unit by more than 2e-7 is taken as it stands, as in
 * glTF: to rounding and 5e-7 these are its columns, which are then not of unit length.
 *
 * Error  3.7 u of each column, for q unit to 2e-7; 21 u for others unit to 1e-3; beyond, it grows with |q|^2.
 */
NKW_ALGEBRA nkw_mat3 nkw_mat3_from_quat_scale(nkw_quat q, nkw_vec3 scale);

/**
 * T R S: nkw_mat3_from_quat_scale and the translation.
 *
 * Error  3.7 u of each column, for q unit to 2e-7; 21 u for others unit to 1e-3; beyond, it grows with |q|^2.
 */
NKW_ALGEBRA_F32X4 nkw_mat4 nkw_mat4_from_trs(const nkw_trs *trs);

/**
 * The transform of a point: translation + rotate(rotation, scale * p).
 *
 * Error  18.0 u of |scale * p| + |translation| for a rotation from nkw_quat_normalize, 12.5 for one rounded from a
 *        unit one (both near half turns).
 */
NKW_ALGEBRA nkw_vec3 nkw_trs_transform_point(const nkw_trs *trs, nkw_vec3 p);

/**
 * The translation, rotation and scale of an affine matrix. The last row is not read.
 *
 *     scale      the lengths of the columns; for a mirror (negative determinant) scale.x is negative
 *     rotation   of the columns divided by the scale: the nearest one, where they are not at right angles
 *
 * No threshold: any scale from the smallest to the largest float works. A column of zero length gives scale 0
 * there and takes its direction at right angles to the others; a matrix of zeros gives the identity rotation.
 * Shear cannot be held by a TRS: nkw_trs_residual says how much was lost.
 *
 * Error  2.4 u of each column of the matrix built again (0.91 u of the rotation, 1.0 u of the scale along it).
 */
NKW_API nkw_trs nkw_trs_from_mat4(const nkw_mat4 *m);

/**
 * What trs fails to say of m: the largest difference of an element of the 3x3 block of T R S from that of m, as a
 * part of the longest column of m. About 1e-7 where m is a TRS; a shear of angle a leaves about a/2.
 * A block of zeros gives 0, numbers that are not finite give NaN.
 *
 * Error  0.501 ULP for residuals above 1e-5; 2e-15 more than rounding below.
 */
NKW_API float nkw_trs_residual(const nkw_trs *trs, const nkw_mat4 *m);

/**
 * The product a b, b first, as far as a TRS can hold it:
 *
 *     translation = a(b.translation),   rotation = a.rotation b.rotation,   scale = a.scale * b.scale
 *
 * Exact in the mathematical sense where a's scale is uniform, or b does not rotate. Elsewhere the true
 * product has shear: multiply the matrices instead.
 *
 * Error  18.0 u of the translation, as nkw_trs_transform_point; 2.8 u of the rotation.
 */
NKW_ALGEBRA nkw_trs nkw_trs_mul(const nkw_trs *a, const nkw_trs *b);

/**
 * nkw_mat4_from_trs over component arrays. See types.h for what holds of all batch functions; but in place only
 * out.m[12..14] may be the translation's arrays, the others no input.
 */
NKW_API void nkw_mat4_from_trs_n(nkw_trs_view trs, nkw_mat4_span out, size_t n);

#ifdef __cplusplus
}
#endif

#if NKW_INLINE || defined(NKW_DEFINE_ALGEBRA)
#include "inline/transform.h"
#endif

#endif
