/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Translation, rotation and scale, and their matrix M = T R S.
 *
 * Composition and decomposition compute in binary32. Only the decomposition of matrices that shear, or whose columns
 * are very long or short, computes in binary64.
 *
 * Example  nkw_trs p, q; nkw_mat4 m; nkw_mat3 r; nkw_quat turn; nkw_vec3 v; float x;
 *
 *     p = nkw_trs_identity();
 *     r = nkw_mat3_from_quat_scale(turn, v);    R S
 *     m = nkw_mat4_from_trs(&p);                T R S
 *     v = nkw_trs_transform_point(&p, v);
 *     p = nkw_trs_from_mat4(&m);                decomposes
 *     x = nkw_trs_residual(&p, &m);             what decomposing lost: shear
 *     p = nkw_trs_mul(&p, &q);                  q first
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
 * R S: the columns of the rotation matrix of q, nkw_mat3_from_quat, multiplied by the components of scale.
 *
 * q has unit length. Its length is not corrected: R is |q|^2 times a rotation, so a length of 1 + d makes the columns
 * longer by 2 d of their length. nkw_quat_normalize corrects q.
 *
 * Error  4.2 u of each column of |q|^2 R S; the same of R S, for a unit q with each component rounded once; 8.6 u of
 *        R S, for q from nkw_quat_normalize.
 */
NKW_ALGEBRA nkw_mat3 nkw_mat3_from_quat_scale(nkw_quat q, nkw_vec3 scale);

/**
 * T R S: nkw_mat3_from_quat_scale and the translation. The rotation has unit length; its length is not corrected.
 *
 * Error  4.2 u of each column of |q|^2 R S; the same of R S, for a unit q with each component rounded once; 8.6 u of
 *        R S, for q from nkw_quat_normalize.
 */
NKW_ALGEBRA_F32X4 nkw_mat4 nkw_mat4_from_trs(const nkw_trs *trs);

/**
 * The transform of a point: translation + rotate(rotation, scale * p).
 *
 * Error  21.0 u of |scale * p| + |translation| for a rotation from nkw_quat_normalize, 14.0 for a unit rotation with
 *        each component rounded once (both near half turns).
 */
NKW_ALGEBRA nkw_vec3 nkw_trs_transform_point(const nkw_trs *trs, nkw_vec3 p);

/**
 * The translation, rotation and scale of an affine matrix. The last row is not read.
 *
 *     scale      the lengths of the columns; scale.x is negative if m mirrors: its determinant is below -2^-20 of the
 *                product of these lengths; nearer to 0 its sign is rounding, and m counts as not mirroring
 *     rotation   the rotation nearest to the columns divided by the scale
 *
 * The function has no threshold: every scale from the smallest to the largest float works. A column of length zero
 * returns scale 0 there, and its direction is perpendicular to the others. A matrix of zeros returns the identity
 * rotation. A TRS cannot store shear: nkw_trs_residual returns how much was lost.
 *
 * If the sum of the squares of the cosines between the columns is 2^-20 or more, or if a column is not longer than
 * 2^-30 and shorter than 2^30, the result is computed in binary64.
 *
 * Error  5.2 u of each column of the matrix of the result (3.4 u of the rotation, 2.6 u of the scale along it); 2.4 u
 *        if computed in binary64.
 */
NKW_API nkw_trs nkw_trs_from_mat4(const nkw_mat4 *m);

/**
 * The largest difference of an element of the 3x3 block of T R S from the element of m, divided by the length of the
 * longest column of m. About 2e-7 if m is a TRS, about a/2 for a shear of angle a. A block of zeros in m returns 0,
 * numbers that are not finite return NaN.
 *
 * Error  0.501 ULP for residuals above 1e-5; 2e-15 more than rounding for smaller ones.
 */
NKW_API float nkw_trs_residual(const nkw_trs *trs, const nkw_mat4 *m);

/**
 * The product a b, b first, without the shear of the exact product, which a TRS cannot store:
 *
 *     translation = a(b.translation),   rotation = a.rotation b.rotation,   scale = a.scale * b.scale
 *
 * Mathematically exact if a.scale is uniform or b does not rotate. Otherwise the exact product has shear: multiply the
 * matrices instead.
 *
 * Error  20.0 u of the translation, as nkw_trs_transform_point; 2.8 u of the rotation.
 */
NKW_ALGEBRA nkw_trs nkw_trs_mul(const nkw_trs *a, const nkw_trs *b);

#ifdef __cplusplus
}
#endif

#if NKW_INLINE || defined(NKW_DEFINE_ALGEBRA)
#include "inline/transform.h"
#endif

#endif
