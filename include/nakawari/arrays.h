/* SPDX-License-Identifier: MIT */
/**
 * @file
 * The small functions over component arrays.
 *
 * A function with a name in _n applies the function of the same name to n elements, with the same bits: element i of the
 * result is computed from the elements i. Loops of SSE2, AVX2, AVX-512, NEON or WebAssembly run; each is chosen once.
 *
 *     length     any n, also 0
 *     alignment  that of float
 *     overlap    an output array may be an input array of the same call (in place), unless the function excludes it;
 *                arrays must not overlap otherwise
 *
 * For speed, pad arrays to a multiple of 16 elements. Avoid distances of a multiple of 4096 bytes between the arrays of
 * a matrix: they cause cache-set conflicts.
 */
#ifndef NAKAWARI_ARRAYS_H
#define NAKAWARI_ARRAYS_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Copy arrays of structs to component arrays, and back. The arrays must not overlap. */
NKW_API void nkw_vec3_unpack_n(const nkw_vec3 *in, nkw_vec3_span out, size_t n);
NKW_API void nkw_vec3_pack_n(nkw_vec3_view in, nkw_vec3 *out, size_t n);
NKW_API void nkw_quat_unpack_n(const nkw_quat *in, nkw_quat_span out, size_t n);
NKW_API void nkw_quat_pack_n(nkw_quat_view in, nkw_quat *out, size_t n);
NKW_API void nkw_mat4_unpack_n(const nkw_mat4 *in, nkw_mat4_span out, size_t n);
NKW_API void nkw_mat4_pack_n(nkw_mat4_view in, nkw_mat4 *out, size_t n);

/**
 * Stack  at most 2 KiB.
 */
NKW_API void nkw_vec3_normalize_n(nkw_vec3_view a, nkw_vec3_span out, size_t n);
NKW_API void nkw_vec3_lerp_n(nkw_vec3_view a, nkw_vec3_view b, const float *t, nkw_vec3_span out, size_t n);
/** All elements at the same t. */
NKW_API void nkw_vec3_lerp_at_n(nkw_vec3_view a, nkw_vec3_view b, float t, nkw_vec3_span out, size_t n);

NKW_API void nkw_quat_mul_n(nkw_quat_view a, nkw_quat_view b, nkw_quat_span out, size_t n);
/**
 * Stack  at most 2 KiB.
 */
NKW_API void nkw_quat_normalize_n(nkw_quat_view q, nkw_quat_span out, size_t n);
NKW_API void nkw_quat_rotate_n(nkw_quat_view q, nkw_vec3_view v, nkw_vec3_span out, size_t n);

/**
 * Along the shorter arc, at t[i], or all at the same t.
 *
 * Stack  at most 16 KiB in nkw_quat_slerp_n; 9 KiB in nkw_quat_nlerp_n, nkw_quat_nlerp_at_n; 8 KiB in
 *        nkw_quat_slerp_at_n.
 */
NKW_API void nkw_quat_nlerp_n(nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out, size_t n);
NKW_API void nkw_quat_nlerp_at_n(nkw_quat_view a, nkw_quat_view b, float t, nkw_quat_span out, size_t n);
NKW_API void nkw_quat_slerp_n(nkw_quat_view a, nkw_quat_view b, const float *t, nkw_quat_span out, size_t n);
NKW_API void nkw_quat_slerp_at_n(nkw_quat_view a, nkw_quat_view b, float t, nkw_quat_span out, size_t n);

/** In place, out may be a, b or both. */
NKW_API void nkw_mat4_mul_affine_n(nkw_mat4_view a, nkw_mat4_view b, nkw_mat4_span out, size_t n);
/** n points, or n directions, transformed by one affine matrix. */
NKW_API void nkw_mat4_transform_point_n(const nkw_mat4 *m, nkw_vec3_view p, nkw_vec3_span out, size_t n);
NKW_API void nkw_mat4_transform_direction_n(const nkw_mat4 *m, nkw_vec3_view d, nkw_vec3_span out, size_t n);
/** In place, only out.m[12..14] may be input arrays, namely those of the translation. */
NKW_API void nkw_mat4_from_trs_n(nkw_trs_view trs, nkw_mat4_span out, size_t n);

/** The curves of curve.h, with the four control values of element i, at t[i]. */
NKW_API void nkw_vec3_hermite_n(nkw_vec3_view p0, nkw_vec3_view v0, nkw_vec3_view p1, nkw_vec3_view v1, const float *t,
                                nkw_vec3_span out, size_t n);
NKW_API void nkw_vec3_bezier_n(nkw_vec3_view p0, nkw_vec3_view p1, nkw_vec3_view p2, nkw_vec3_view p3, const float *t,
                               nkw_vec3_span out, size_t n);
NKW_API void nkw_vec3_bspline_n(nkw_vec3_view p0, nkw_vec3_view p1, nkw_vec3_view p2, nkw_vec3_view p3, const float *t,
                                nkw_vec3_span out, size_t n);
NKW_API void nkw_vec3_catmull_rom_n(nkw_vec3_view p0, nkw_vec3_view p1, nkw_vec3_view p2, nkw_vec3_view p3,
                                    const float *t, nkw_vec3_span out, size_t n);

#ifdef __cplusplus
}
#endif

#endif
