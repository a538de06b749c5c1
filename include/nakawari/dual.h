/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Dual quaternions: a rotation and a translation in eight floats, which can be blended.
 *
 *     d = real + e dual,   e e = 0;   real = rotation,   dual = (t / 2) real      t = (x, y, z, 0), the translation
 *
 * d is unit if |real| = 1 and real . dual = 0. Unit dual quaternions are the rigid motions; functions that transform
 * require them. d and -d are the same motion. Dual-quaternion skinning blends by the normalised weighted sum of unit
 * dual quaternions. Negate those whose real part has a negative dot product with that of the first before the sum.
 * The inverse of a unit d is {nkw_quat_conjugate(d.real), nkw_quat_conjugate(d.dual)}. A direction is rotated by
 * nkw_quat_rotate(d.real, v).
 *
 * Source Kavan, Collins, Zara, O'Sullivan, Geometric Skinning with Approximate Dual Quaternion Blending, ACM TOG, 2008.
 */
#ifndef NAKAWARI_DUAL_H
#define NAKAWARI_DUAL_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The rotation by the unit quaternion `rotation`, then the translation by `translation`. real is a copy of `rotation`;
 * dual is computed in binary64 and rounded once.
 *
 * Error  1.0 u of the dual part.
 */
NKW_API nkw_dual_quat nkw_dual_quat_from_rigid(nkw_quat rotation, nkw_vec3 translation);

/**
 * The rigid motion of an affine matrix: its translation, and the rotation nearest to its columns divided by their
 * lengths. The last row is not read. Computed in binary64.
 *
 * Scale and mirroring are removed: the columns are divided by their lengths, and all are negated if m mirrors (negative
 * determinant). nkw_trs_from_mat4 negates only the first column, so its rotation is a different one if m mirrors.
 * Columns that are perpendicular to within 1e-3 do not increase the error; with more shear, the rotation is close to
 * the nearest one. One column of zeros counts as perpendicular to the others.
 *
 * Returns real.w >= 0; if it is 0, the largest component of real is positive. A block of zeros returns the identity
 * rotation, NaN returns NaN.
 *
 * Error  1.0 u of the dual part, 0.91 u of the rotation, against the one nearest to the columns.
 */
NKW_API nkw_dual_quat nkw_dual_quat_from_mat4(const nkw_mat4 *m);

/**
 * The matrix of a unit d: nkw_mat3_from_quat of real, and the translation. The last row is exactly 0 0 0 1.
 *
 * Error  4.3 u of the translation, 3.1 u of the 3x3 block (Frobenius norm / sqrt 3).
 */
NKW_API nkw_mat4 nkw_mat4_from_dual_quat(const nkw_dual_quat *d);

/**
 * The product a b: b first, then a. real = ar br, dual = ar bd + ad br. Computed in binary32.
 *
 * Error  4.0 u of |a.dual| + |b.dual| in the dual part, 2.8 u in the real part, for unit inputs.
 */
NKW_API nkw_dual_quat nkw_dual_quat_mul(const nkw_dual_quat *a, const nkw_dual_quat *b);

/**
 * The unit dual quaternion of d: d divided by |real|, without the component of dual along real:
 *
 *     real' = real / |real|,     dual' = dual / |real| - real' (real' . dual / |real|)
 *
 * Computed in binary64, rounded once. real = 0 returns the identity for every dual; otherwise NaN returns NaN.
 *
 * Error  1.0 u of |dual| / |real| in the dual part, 0.91 u in the real part.
 */
NKW_API nkw_dual_quat nkw_dual_quat_normalize(const nkw_dual_quat *d);

/**
 * The point p transformed by the unit d: rotated by real, then translated. Computed in binary32.
 *
 *     p' = rotate(real, p) + 2 (rw dv - dw rv + rv x dv),       (rv, rw) = real,  (dv, dw) = dual
 *
 * Of the point 0 it is the translation.
 *
 * Error  13.0 u of |p| + |t|, t the translation; 4.3 u for p = 0.
 */
NKW_API nkw_vec3 nkw_dual_quat_transform_point(const nkw_dual_quat *d, nkw_vec3 p);

#ifdef __cplusplus
}
#endif

#endif
