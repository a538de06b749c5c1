/* SPDX-License-Identifier: MIT */
/**
 * @file
 * 3x3 and 4x4 matrices on column vectors, column-major (see types.h).
 *
 * The product A B applies B first, then A. Functions that run for each joint and frame (products, transforms, the
 * matrix of a quaternion, rigid and affine inverses) compute in binary32. Determinants, the other inverses and
 * orthonormalisation compute in binary64 and round once.
 *
 * Example  nkw_mat3 m, k; nkw_mat4 a, b, r; nkw_mat3x4 rows; nkw_quat q; nkw_vec3 x, y, z; float d, f[16];
 *          nkw_perspective lens; nkw_orthographic flat;
 *
 *     m = nkw_mat3_identity();
 *     m = nkw_mat3_from_columns(x, y, z);         the images of the axes
 *     x = nkw_mat3_column(&m, 0);
 *     m = nkw_mat3_from_mat4(&a);                 without translation
 *     m = nkw_mat3_transpose(&m);
 *     m = nkw_mat3_mul(&m, &k);                   k first
 *     x = nkw_mat3_transform(&m, x);
 *     m = nkw_mat3_from_quat(q);
 *     d = nkw_mat3_determinant(&m);
 *     m = nkw_mat3_inverse(&m);                   zero if there is none
 *     m = nkw_mat3_normal(&m);                    transforms normals: inverse transpose
 *     m = nkw_mat3_orthonormalize(&m);
 *     r = nkw_mat4_identity();
 *     r = nkw_mat4_from_mat3(&m, x);              and a translation
 *     r = nkw_mat4_from_quat(q);                  a rotation
 *     x = nkw_mat4_translation(&a);               the fourth column
 *     r = nkw_mat4_transpose(&a);
 *     r = nkw_mat4_mul(&a, &b);                   b first
 *     r = nkw_mat4_mul_affine(&a, &b);            faster: last rows 0 0 0 1
 *     x = nkw_mat4_transform_point(&a, x);
 *     x = nkw_mat4_transform_direction(&a, x);    without translation
 *     x = nkw_mat4_project_point(&a, x);          divides by w
 *     d = nkw_mat4_determinant(&a);
 *     r = nkw_mat4_inverse(&a);                   any; zero if there is none
 *     r = nkw_mat4_inverse_affine(&a);            last row 0 0 0 1
 *     r = nkw_mat4_inverse_rigid(&a);             rotation and translation
 *     r = nkw_mat4_from_row_major(f);
 *     nkw_mat4_to_row_major(&a, f);
 *     rows = nkw_mat3x4_from_mat4(&a);            three rows, for shaders
 *     r = nkw_mat4_from_mat3x4(&rows);
 *     r = nkw_mat4_from_translation(x);
 *     r = nkw_mat4_from_scale(x);
 *     r = nkw_mat4_from_axis_angle(x, 1.5f);
 *     r = nkw_mat4_look_at(x, y, z);              camera at x, looks at y, z is up
 *     r = nkw_mat4_from_perspective(&lens);       GL, Vulkan, D3D; reversed z; infinite
 *     r = nkw_mat4_from_orthographic(&flat);
 *     nkw_mat4_equal_within(&a, &b, 1e-5f);       element by element
 */
#ifndef NAKAWARI_MAT_H
#define NAKAWARI_MAT_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The identity matrix. */
NKW_ALGEBRA nkw_mat3 nkw_mat3_identity(void);
/** The matrix with columns x, y, z: it maps the axes to these vectors. */
NKW_ALGEBRA nkw_mat3 nkw_mat3_from_columns(nkw_vec3 x, nkw_vec3 y, nkw_vec3 z);
/** Column c of m, c in 0..2; any other c returns column 0. */
NKW_ALGEBRA nkw_vec3 nkw_mat3_column(const nkw_mat3 *m, size_t c);
/** The upper left 3x3 block of m. */
NKW_ALGEBRA nkw_mat3 nkw_mat3_from_mat4(const nkw_mat4 *m);
/** The transpose. */
NKW_ALGEBRA nkw_mat3 nkw_mat3_transpose(const nkw_mat3 *m);

/**
 * The product a b: b first, then a. Each element is a sum of three products, evaluated as (0 + 1) + 2.
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
 * The rotation matrix of the unit quaternion q. q and -q return the same bits.
 *
 *     ww + xx - yy - zz    2(xy - wz)           2(xz + wy)
 *     2(xy + wz)           ww - xx + yy - zz    2(yz - wx)
 *     2(xz - wy)           2(yz + wx)           ww - xx - yy + zz
 *
 * A q that is not unit returns |q|^2 times the rotation.
 *
 * Error  3.1 u (Frobenius norm / sqrt 3), 3.4 u of the worst element, for q unit to rounding.
 */
NKW_ALGEBRA nkw_mat3 nkw_mat3_from_quat(nkw_quat q);

/**
 * The determinant: the volume of the image of the unit cube, negative if m mirrors. Computed in binary64.
 *
 * Error  0.51 ULP, up to condition 1e7.
 */
NKW_API float nkw_mat3_determinant(const nkw_mat3 *m);

/**
 * The inverse, by the adjugate in binary64. Returns the zero matrix if the determinant is not finite, or if m is
 * singular: its determinant is at most 2^-50 of the terms of its sum, as for nkw_mat4_inverse.
 *
 * Error  1.0 u of the Frobenius norm, up to condition 1e7.
 */
NKW_API nkw_mat3 nkw_mat3_inverse(const nkw_mat3 *m);

/**
 * The matrix that transforms normals if m transforms positions: the transpose of the inverse of m. Normalise the
 * normals afterwards.
 *
 * A matrix of rank 2 (a scale of zero along one axis) has no inverse, but the direction of the normals is defined. In a
 * product of matrices rounding decides whether the determinant is 0, and its sign. So where its magnitude is at most
 * 2^-20 of the product of the lengths of the columns, the result is the cofactor matrix (det m times the inverse
 * transpose), scaled to a largest element of 1; it does not depend on the sign. A rank below 2, NaN and infinity return
 * the zero matrix.
 *
 * Error  1.0 u of the Frobenius norm.
 */
NKW_API nkw_mat3 nkw_mat3_normal(const nkw_mat3 *m);

/**
 * Orthonormal columns by the Gram-Schmidt process. Column x keeps its direction, y its half-plane through x, z its side
 * of the plane x, y, so a matrix that mirrors still mirrors. A column of length zero, or within 2^-30 rad of the line
 * or the plane of the columns before it, is replaced by a unit vector perpendicular to the others; z then has the side
 * of x x y. NaN returns NaN in its column and in the columns after it.
 *
 * Error  0.87 u per column, if the angle between y and x, and y and -x, is 2^-25 rad or more; otherwise up to 8 u, down
 *        to 2^-30 rad.
 */
NKW_API nkw_mat3 nkw_mat3_orthonormalize(const nkw_mat3 *m);

/** The identity matrix. */
NKW_ALGEBRA nkw_mat4 nkw_mat4_identity(void);
/** The affine matrix with the 3x3 block m and the translation. */
NKW_ALGEBRA nkw_mat4 nkw_mat4_from_mat3(const nkw_mat3 *m, nkw_vec3 translation);
/** The rotation q as a 4x4 matrix; elements as in nkw_mat3_from_quat. */
NKW_ALGEBRA nkw_mat4 nkw_mat4_from_quat(nkw_quat q);
/** The translation column (m[12], m[13], m[14]). */
NKW_ALGEBRA nkw_vec3 nkw_mat4_translation(const nkw_mat4 *m);
/** The transpose. */
NKW_ALGEBRA nkw_mat4 nkw_mat4_transpose(const nkw_mat4 *m);

/**
 * The product a b: b first, then a. Each element is a sum of four products, evaluated as (0 + 1) + (2 + 3).
 *
 * Error  3.0 u of |a| |b|, the Frobenius norms: three roundings of each product. No bound exists relative to the norm
 *        of the result, because sums may cancel.
 */
NKW_ALGEBRA_F32X4 nkw_mat4 nkw_mat4_mul(const nkw_mat4 *a, const nkw_mat4 *b);

/**
 * The product a b of two affine matrices. The last rows are not read; the last row of the result is exactly 0 0 0 1. If
 * both are affine and finite, the bits are those of nkw_mat4_mul, except the sign of a zero.
 *
 * Error  3.0 u of |a| |b|, the Frobenius norms.
 */
NKW_ALGEBRA_F32X4 nkw_mat4 nkw_mat4_mul_affine(const nkw_mat4 *a, const nkw_mat4 *b);

/**
 * The point p transformed by the affine m: m (p, 1). The last row is not read.
 *
 * Error  3.0 u of |A| |p| + |t|, |A| the Frobenius norm of the 3x3 block, t the translation.
 */
NKW_ALGEBRA nkw_vec3 nkw_mat4_transform_point(const nkw_mat4 *m, nkw_vec3 p);
/**
 * The direction d transformed by the affine m: m (d, 0), without the translation.
 *
 * Error  3.0 u of |A| |d|, |A| the Frobenius norm of the 3x3 block.
 */
NKW_ALGEBRA nkw_vec3 nkw_mat4_transform_direction(const nkw_mat4 *m, nkw_vec3 d);

/**
 * The point p transformed by any m, with the division by w: q = m (p, 1), r = q.xyz / q.w. A point in the plane w = 0
 * returns infinities or NaN, as the division does.
 *
 * Error  3.0 u of (1 + |r|) |m| |(p, 1)| / |q.w|, |m| the Frobenius norm; 4.0 u of 1 within the view of a perspective
 *        matrix, the norm of the difference.
 */
NKW_API nkw_vec3 nkw_mat4_project_point(const nkw_mat4 *m, nkw_vec3 p);

/**
 * The determinant, computed in binary64 from exact 2x2 minors.
 *
 * Error  0.502 ULP, up to condition 1e4.
 */
NKW_API float nkw_mat4_determinant(const nkw_mat4 *m);

/**
 * The inverse of any matrix, computed in binary64: by cofactors, or by elimination with pivoting where cofactors would
 * lose digits. Returns the zero matrix if the determinant is not finite, or if m is singular: its determinant is at
 * most 2^-50 of the terms of its sum. In binary32 cofactors lose 90 to 250 u for the product of a perspective and a
 * view matrix, and all digits for other matrices of high condition, so no binary32 form is used.
 *
 * Error  1.0 u of the Frobenius norm, up to condition 1e7.
 */
NKW_API nkw_mat4 nkw_mat4_inverse(const nkw_mat4 *m);

/**
 * The inverse of an affine matrix: A^-1 and -A^-1 t, in binary32 by the cross products of the columns of the 3x3 block
 * A. The last row is not read; the last row of the result is exactly 0 0 0 1. If A is not finite, or singular as for
 * nkw_mat3_inverse, returns the zero matrix; t does not count. nkw_mat4_inverse is the exact one.
 *
 * If the determinant of A is less than half of the product of the lengths of its columns (strong shear), or if this
 * product is not within 2^-30 .. 2^30, the result is computed in binary64 and rounded once.
 *
 * Error  10.0 u of |A^-1| in the 3x3 block, and of |A^-1| |t| in the translation, the Frobenius norms, at every ratio of
 *        scales; 1.1 u in the root mean square. Of the norm of the whole result it grows with uneven scales: some 11,
 *        19 and 21 u at 10 : 1, 100 : 1 and 1000 : 1.
 */
NKW_API nkw_mat4 nkw_mat4_inverse_affine(const nkw_mat4 *m);

/**
 * The inverse of a rotation and a translation: R^T and -R^T t, in binary32: the transpose R^T is exact, and one sum of
 * three products remains. m must not scale or shear.
 * The last row is not read; the last row of the result is exactly 0 0 0 1.
 *
 * Error  3.0 u of |t| in the translation; 4.0 u of the Frobenius norm against the inverse of a rounded rotation.
 */
NKW_ALGEBRA nkw_mat4 nkw_mat4_inverse_rigid(const nkw_mat4 *m);

/**
 * Conversion from and to 16 floats in the transposed layout.
 *
 *     order          vectors
 *     column-major   columns    this library, OpenGL, glTF, GLM     the same bytes
 *     row-major      rows       D3DX, DirectXMath, XNA              the same bytes
 *     row-major      columns    vecmath, HLSL row_major, NumPy      transposed: these functions
 *     column-major   rows       (rare)                              transposed: these functions
 */
NKW_API nkw_mat4 nkw_mat4_from_row_major(const float rows[16]);
NKW_API void nkw_mat4_to_row_major(const nkw_mat4 *m, float rows[16]);

/** The first three rows of the affine m; and back, with the last row 0 0 0 1. The bits do not change. */
NKW_API nkw_mat3x4 nkw_mat3x4_from_mat4(const nkw_mat4 *m);
NKW_API nkw_mat4 nkw_mat4_from_mat3x4(const nkw_mat3x4 *m);

/** Moves by t. */
NKW_API nkw_mat4 nkw_mat4_from_translation(nkw_vec3 t);
/** Scales by s.x, s.y, s.z along the axes. */
NKW_API nkw_mat4 nkw_mat4_from_scale(nkw_vec3 s);
/**
 * Rotates by `angle` radians about `axis`, counter-clockwise seen from its tip: nkw_mat3_from_quat of
 * nkw_quat_from_axis_angle. The axis need not be unit; a zero axis returns the identity.
 */
NKW_API nkw_mat4 nkw_mat4_from_axis_angle(nkw_vec3 axis, float angle);

/**
 * The view matrix of a camera at `eye` that looks at `target` with `up` above (lookAt, gluLookAt): it transforms points
 * of the world to the camera's space, where x is to the right, y up, and the camera looks along -z.
 *
 *     R = nkw_mat3_from_quat(nkw_quat_look_rotation(target - eye, up)),     V = R^T T(-eye)
 *
 * A target at the eye and an `up` that is 0 or parallel to the direction have the results of nkw_quat_look_rotation.
 *
 * Error  4.5 u of 1 in the 3x3 block, of |eye| in the translation, if target - eye is exact.
 */
NKW_API nkw_mat4 nkw_mat4_look_at(nkw_vec3 eye, nkw_vec3 target, nkw_vec3 up);

/**
 * The clip space of a graphics interface. In all of them, x is to the right and -w <= x, y <= w is visible.
 *
 *     NKW_GRAPHICS_GL        y up,    -w <= z <= w    OpenGL, OpenGL ES, WebGL
 *     NKW_GRAPHICS_D3D       y up,     0 <= z <= w    Direct3D, Metal, WebGPU; OpenGL with GL_ZERO_TO_ONE
 *     NKW_GRAPHICS_VULKAN    y down,   0 <= z <= w    Vulkan
 */
typedef enum nkw_graphics {
    NKW_GRAPHICS_GL,
    NKW_GRAPHICS_D3D,
    NKW_GRAPHICS_VULKAN,
    NKW_GRAPHICS_MAX_ENUM = 0x7fffffff
} nkw_graphics;

/** A perspective camera that looks along -z. */
typedef struct nkw_perspective {
    float angle;  /**< the vertical field of view in radians, between 0 and pi */
    float aspect; /**< width / height of the image */
    float near_z; /**< the distance of the nearest visible plane, greater than 0 */
    float far_z;  /**< of the farthest, greater than near_z; INFINITY has no farthest plane */
    nkw_graphics graphics;
    int reversed_z; /**< not 0: the depth of the nearest plane is the greatest, of the farthest the least */
} nkw_perspective;
NKW_SIZE(nkw_perspective, 24, 24);

/**
 * The projection of a perspective camera. With n, f the nearest and farthest plane, dn and df their depths (GL: -1, 1;
 * otherwise 0, 1; exchanged by reversed_z), r = n / f and c = cot(angle / 2), negative in the second row for Vulkan:
 *
 *     c / aspect   0    0                       0
 *     0            c    0                       0
 *     0            0    (dn r - df) / (1 - r)   n (dn - df) / (1 - r)
 *     0            0    -1                      0
 *
 * A struct outside these ranges, an unknown interface and NaN return the zero matrix. Reversed z with an interface
 * whose depth is 0 .. 1 and a floating-point depth buffer has the smallest error of depth over all distances.
 *
 * Error  0.60 ULP of each element.
 */
NKW_API nkw_mat4 nkw_mat4_from_perspective(const nkw_perspective *camera);

/** A camera without perspective that looks along -z; the sides of the visible box in the camera's space. */
typedef struct nkw_orthographic {
    float left, right, bottom, top; /**< x of the left and right side, y of the lower and upper; not equal */
    float near_z, far_z;            /**< distances along -z, not equal; may be 0 or negative */
    nkw_graphics graphics;
    int reversed_z; /**< as in nkw_perspective */
} nkw_orthographic;
NKW_SIZE(nkw_orthographic, 32, 32);

/**
 * The projection of a camera without perspective. x = left has the x -1, x = right has 1; y the same, exchanged for
 * Vulkan; the depth of z = -near_z is dn, that of z = -far_z is df, as in nkw_mat4_from_perspective.
 * Equal sides, an unknown interface and what is not finite return the zero matrix.
 *
 * Error  0.60 ULP of each element.
 */
NKW_API nkw_mat4 nkw_mat4_from_orthographic(const nkw_orthographic *camera);

/** 1 if no two elements differ by more than `tolerance`, otherwise 0, also for NaN. Equal infinities do not differ. */
NKW_API int nkw_mat4_equal_within(const nkw_mat4 *a, const nkw_mat4 *b, float tolerance);

#ifdef __cplusplus
}
#endif

#if NKW_INLINE || defined(NKW_DEFINE_ALGEBRA)
#include "inline/mat.h"
#endif

#endif
