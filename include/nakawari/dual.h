/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 2: dual quaternions: a rotation and a translation in eight floats that can be blended.
 *
 *     d = real + e dual,   e e = 0;   real = rotation,   dual = (t / 2) real      t = (x, y, z, 0), the translation
 *
 * Unit says |real| = 1 and real . dual = 0; only unit ones are rigid motions, and what transforms takes them so. d and
 * -d are the same motion. Sums of unit dual quaternions, normalised, are the blends of dual-quaternion skinning; they
 * need all of one side (nkw_dual_quat_align).
 *
 * Source Kavan, Collins, Zara, O'Sullivan, Geometric Skinning with Approximate Dual Quaternion Blending, ACM TOG, 2008.
 */
#ifndef NAKAWARI_DUAL_H
#define NAKAWARI_DUAL_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** No rotation, no translation. */
NKW_API nkw_dual_quat nkw_dual_quat_identity(void);

/**
 * Rotate by the unit quaternion `rotation`, then move by `translation`. real is the rotation as given, bit for bit;
 * dual is worked out in binary64 and rounded once.
 *
 * Error  1.0 u of the dual part.
 */
NKW_API nkw_dual_quat nkw_dual_quat_from_rigid(nkw_quat rotation, nkw_vec3 translation);

/**
 * The rigid motion of an affine matrix: its translation, and the rotation nearest to its columns divided by their
 * lengths. The last row is not read. In binary64 inside.
 *
 * Scale and mirroring are dropped: the scale by dividing it out, a mirror (negative determinant) by negating all
 * columns; nkw_trs_from_mat4 negates the first alone, and so gives another rotation there. Columns off right angles by
 * 1e-3 cost nothing; with more shear the rotation is near the nearest. One column of zeros counts as at right angles to
 * the others. real.w >= 0; where it is 0, the largest component of real is positive. A block of zeros gives no
 * rotation, NaN gives NaN.
 *
 * Error  1.0 u of the dual part, 0.91 u of the rotation, against the one nearest to the columns.
 */
NKW_API nkw_dual_quat nkw_dual_quat_from_mat4(const nkw_mat4 *m);

/**
 * The matrix of a unit d: nkw_mat3_from_quat of real and the translation; last row exactly 0 0 0 1.
 *
 * Error  4.3 u of the translation, 2.8 u of the 3x3 block (Frobenius norm / sqrt 3).
 */
NKW_API nkw_mat4 nkw_mat4_from_dual_quat(const nkw_dual_quat *d);

/**
 * The translation of a unit d: 2 dual real*, that is 2 (rw dv - dw rv + rv x dv). In binary32.
 *
 * Error  4.3 u.
 */
NKW_API nkw_vec3 nkw_dual_quat_translation(const nkw_dual_quat *d);

/**
 * a b: first b, then a. real = ar br, dual = ar bd + ad br. In binary32.
 *
 * Error  4.0 u of |a.dual| + |b.dual| in the dual part, 2.8 u in the real one, for unit inputs.
 */
NKW_API nkw_dual_quat nkw_dual_quat_mul(const nkw_dual_quat *a, const nkw_dual_quat *b);

/** The inverse of a unit d: both parts conjugated. */
NKW_API nkw_dual_quat nkw_dual_quat_conjugate(const nkw_dual_quat *d);

/**
 * The unit dual quaternion of d's motion: d divided by |real|, and of dual only what is at right angles to real:
 *
 *     real' = real / |real|,     dual' = dual / |real| - real' (real' . dual / |real|)
 *
 * In binary64, rounded once. real = 0 gives the identity, whatever dual is; else NaN gives NaN.
 *
 * Error  1.0 u of |dual| / |real| in the dual part, 0.91 u in the real one.
 */
NKW_API nkw_dual_quat nkw_dual_quat_normalize(const nkw_dual_quat *d);

/**
 * d, or -d where real and that of `side` are more than a quarter turn of the 3-sphere apart (negative dot product). NaN
 * counts as one side; the dual part of `side` is not read.
 */
NKW_API nkw_dual_quat nkw_dual_quat_align(const nkw_dual_quat *d, const nkw_dual_quat *side);

/**
 * The unit d on a point: rotate, then move. In binary32.
 *
 * Error  12.0 u of |p| + |t|, t the translation.
 */
NKW_API nkw_vec3 nkw_dual_quat_transform_point(const nkw_dual_quat *d, nkw_vec3 p);
/**
 * The unit d on a direction: rotate. In binary32.
 *
 * Error  11.5 u of |v|.
 */
NKW_API nkw_vec3 nkw_dual_quat_transform_direction(const nkw_dual_quat *d, nkw_vec3 v);

#ifdef __cplusplus
}
#endif

#endif
