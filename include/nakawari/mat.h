/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 2: 3x3 and 4x4 matrices on column vectors, column-major (see types.h).
 *
 * Products read right to left: (A B) v applies B, then A. What runs per joint per frame (products,
 * transforms, the matrix of a quaternion) works in binary32; determinants, inverses and
 * orthonormalisation work in binary64 inside and round once.
 */
#ifndef NAKAWARI_MAT_H
#define NAKAWARI_MAT_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The identity matrix. */
NKW_ALGEBRA nkw_mat3 nkw_mat3_identity(void);
/** The matrix with columns x, y, z: it takes the axes to these vectors. */
NKW_ALGEBRA nkw_mat3 nkw_mat3_from_columns(nkw_vec3 x, nkw_vec3 y, nkw_vec3 z);
/** Column c of m, c in 0..2; any other c gives column 0. */
NKW_ALGEBRA nkw_vec3 nkw_mat3_column(const nkw_mat3 *m, size_t c);
/** The upper left 3x3 block of m. */
NKW_ALGEBRA nkw_mat3 nkw_mat3_from_mat4(const nkw_mat4 *m);
/** Rows become columns. */
NKW_ALGEBRA nkw_mat3 nkw_mat3_transpose(const nkw_mat3 *m);

/**
 * a b: first b, then a. Each element is a sum of three products, (0 + 1) + 2.
 *
 * Error  1.8 u of the Frobenius norm, for rotations.
 */
NKW_ALGEBRA nkw_mat3 nkw_mat3_mul(const nkw_mat3 *a, const nkw_mat3 *b);

/**
 * m v.
 *
 * Error  3.0 u of |m| |v|, |m| the Frobenius norm; 3.0 u of |v| for rotations.
 */
NKW_ALGEBRA nkw_vec3 nkw_mat3_transform(const nkw_mat3 *m, nkw_vec3 v);

/**
 * The rotation matrix of the unit quaternion q. q and -q give the same bits.
 *
 *     ww + xx - yy - zz    2(xy - wz)           2(xz + wy)
 *     2(xy + wz)           ww - xx + yy - zz    2(yz - wx)
 *     2(xz - wy)           2(yz + wx)           ww - xx - yy + zz
 *
 * A q that is not unit gives |q|^2 times the rotation.
 *
 * Error  2.8 u (Frobenius norm / sqrt 3), 3.4 u of the worst element, for q unit to rounding.
 */
NKW_ALGEBRA nkw_mat3 nkw_mat3_from_quat(nkw_quat q);

/**
 * The determinant: the volume of the image of the unit cube, negative for a mirror.
 * Every product is exact in binary64, so cancellation costs nothing until the last rounding.
 *
 * Error  0.51 ULP, up to condition 1e7.
 */
NKW_API float nkw_mat3_determinant(const nkw_mat3 *m);

/**
 * The inverse, by the adjugate in binary64. A singular matrix (determinant exactly 0 in binary64, or not
 * finite) gives the zero matrix.
 *
 * Error  1.0 u of the Frobenius norm, up to condition 1e7.
 */
NKW_API nkw_mat3 nkw_mat3_inverse(const nkw_mat3 *m);

/**
 * The matrix that turns normals when m turns positions: the inverse transpose of m.
 *
 * Where m is singular (a scale of zero along one axis) the inverse does not exist but the direction of the
 * normals still does: then the cofactor matrix is given, its largest element 1. A matrix of rank below two
 * has no normals and gives the zero matrix, as do NaN and infinity. Normalise the normals afterwards.
 *
 * Error  1.0 u of the Frobenius norm, up to condition 1e7.
 */
NKW_API nkw_mat3 nkw_mat3_normal(const nkw_mat3 *m);

/**
 * The nearest matrix, by Gram and Schmidt, with orthonormal columns: x keeps its direction, y its half-plane,
 * z its side, so a mirror stays a mirror. Columns of zero length and columns without a direction of their
 * own are replaced by unit vectors at right angles to the others. NaN gives NaN in its column and those after it.
 *
 * Error  0.87 u per column, while the angle between y and x, and y and -x, is 2^-25 rad or more; closer, up to 8 u.
 */
NKW_API nkw_mat3 nkw_mat3_orthonormalize(const nkw_mat3 *m);

/** The identity matrix. */
NKW_ALGEBRA nkw_mat4 nkw_mat4_identity(void);
/** The affine matrix with the 3x3 block m and a translation. */
NKW_ALGEBRA nkw_mat4 nkw_mat4_from_mat3(const nkw_mat3 *m, nkw_vec3 translation);
/** The rotation q as a 4x4 matrix; elements as in nkw_mat3_from_quat. */
NKW_ALGEBRA nkw_mat4 nkw_mat4_from_quat(nkw_quat q);
/** The translation column (m[12], m[13], m[14]). */
NKW_ALGEBRA nkw_vec3 nkw_mat4_translation(const nkw_mat4 *m);
/** Rows become columns. */
NKW_ALGEBRA nkw_mat4 nkw_mat4_transpose(const nkw_mat4 *m);

/**
 * a b: first b, then a. Each element is a sum of four products, (0 + 1) + (2 + 3).
 *
 * Error  3.0 u of |a| |b|, the Frobenius norms: three roundings of each product. Where sums cancel, the error is larger
 *        than any part of the norm of the result.
 */
NKW_ALGEBRA_F32X4 nkw_mat4 nkw_mat4_mul(const nkw_mat4 *a, const nkw_mat4 *b);

/**
 * a b of two affine matrices: the last rows are not read, and the result's is exactly 0 0 0 1. Same bits as
 * nkw_mat4_mul where both are affine and finite, but for the sign of a zero.
 *
 * Error  3.0 u of |a| |b|, the Frobenius norms.
 */
NKW_ALGEBRA_F32X4 nkw_mat4 nkw_mat4_mul_affine(const nkw_mat4 *a, const nkw_mat4 *b);

/**
 * The affine m on a point: m (p, 1). The last row is not read.
 *
 * Error  3.0 u of |A| |p| + |t|, |A| the Frobenius norm of the 3x3 block, t the translation.
 */
NKW_ALGEBRA nkw_vec3 nkw_mat4_transform_point(const nkw_mat4 *m, nkw_vec3 p);
/**
 * The affine m on a direction: m (d, 0), without the translation.
 *
 * Error  3.0 u of |A| |d|, |A| the Frobenius norm of the 3x3 block.
 */
NKW_ALGEBRA nkw_vec3 nkw_mat4_transform_direction(const nkw_mat4 *m, nkw_vec3 d);

/**
 * Any m on a point with the division by w: q = m (p, 1), r = q.xyz / q.w. A point in the plane w = 0 gives
 * infinities or NaN, as the division does.
 *
 * Error  3.0 u of (1 + |r|) |m| |(p, 1)| / |q.w|, |m| the Frobenius norm; 2.5 u of 1 in view of a perspective.
 */
NKW_API nkw_vec3 nkw_mat4_project_point(const nkw_mat4 *m, nkw_vec3 p);

/**
 * The determinant, in binary64 from exact 2x2 minors.
 *
 * Error  0.502 ULP, up to condition 1e4.
 */
NKW_API float nkw_mat4_determinant(const nkw_mat4 *m);

/**
 * The inverse of any matrix, in binary64: by cofactors where they lose nothing, by elimination with
 * pivoting where they would. A singular matrix, whose determinant is at most 2^-50 of the terms that it
 * sums, gives the zero matrix; so does one whose determinant is not finite.
 *
 * Error  1.0 u of the Frobenius norm, up to condition 1e7.
 */
NKW_API nkw_mat4 nkw_mat4_inverse(const nkw_mat4 *m);

/**
 * The inverse of an affine matrix: A^-1 and -A^-1 t, in binary64. The last row is not read; the result's is
 * exactly 0 0 0 1. Where the 3x3 block is singular or not finite, the zero matrix.
 *
 * Error  1.0 u of the Frobenius norm, for scales up to 1000 : 1.
 */
NKW_API nkw_mat4 nkw_mat4_inverse_affine(const nkw_mat4 *m);

/**
 * The inverse of a rotation and translation: R^T and -R^T t. Wrong where m scales or shears; exact in the
 * rotation. The last row is not read; the result's is exactly 0 0 0 1.
 *
 * Error  3.0 u of |t| in the translation; 3.4 u of the Frobenius norm against the inverse of a rounded rotation.
 */
NKW_ALGEBRA nkw_mat4 nkw_mat4_inverse_rigid(const nkw_mat4 *m);

/**
 * Other layouts, 16 floats each:
 *
 *     columns of column vectors   this library, OpenGL, glTF, GLM     the same bytes
 *     rows of row vectors         D3DX, DirectXMath, XNA              the same bytes
 *     rows of column vectors      vecmath, HLSL row_major, NumPy      transposed: _row_major
 *     columns of row vectors      (rare)                              transposed: _row_major
 */
NKW_API nkw_mat4 nkw_mat4_from_row_major(const float rows[16]);
NKW_API void nkw_mat4_to_row_major(const nkw_mat4 *m, float rows[16]);

/** The first three rows of the affine m, and back with the last row 0 0 0 1. Every bit is kept. */
NKW_API nkw_mat3x4 nkw_mat3x4_from_mat4(const nkw_mat4 *m);
NKW_API nkw_mat4 nkw_mat4_from_mat3x4(const nkw_mat3x4 *m);

/**
 * The same functions over component arrays: element i of the result is f of the elements i, with the very bits of
 * the single call. See types.h for what holds of all batch functions.
 */
NKW_API void nkw_mat3_from_quat_n(nkw_quat_view q, nkw_mat3_span out, size_t n);
/** In place out may be a or b, or both. */
NKW_API void nkw_mat4_mul_affine_n(nkw_mat4_view a, nkw_mat4_view b, nkw_mat4_span out, size_t n);
/** One affine matrix on many points, and on many directions. */
NKW_API void nkw_mat4_transform_point_n(const nkw_mat4 *m, nkw_vec3_view p, nkw_vec3_span out, size_t n);
NKW_API void nkw_mat4_transform_direction_n(const nkw_mat4 *m, nkw_vec3_view d, nkw_vec3_span out, size_t n);
/** From an array of matrices to component arrays, and back. The arrays must not overlap. */
NKW_API void nkw_mat4_unpack_n(const nkw_mat4 *in, nkw_mat4_span out, size_t n);
NKW_API void nkw_mat4_pack_n(nkw_mat4_view in, nkw_mat4 *out, size_t n);

#ifdef __cplusplus
}
#endif

#if NKW_INLINE || defined(NKW_DEFINE_ALGEBRA)
#include "inline/mat.h"
#endif

#endif
