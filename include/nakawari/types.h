/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 2: the plain values that the rest of the library works on.
 *
 * All values are structs of floats without padding, passed by value up to 16 bytes and by `const *` above, and safe to
 * copy, compare byte by byte, write to a file or hand to a GPU as they lie. Views and spans, of pointers, go by value.
 *
 * `Error` lines of all headers tell the worst error measured. 1 u is 2^-24 of the magnitude named; where none is, of
 * the norm of the exact result, which is 1 for a unit quaternion. 1 ULP is the distance of neighbouring floats at the
 * exact result. docs/accuracy.md has the inputs.
 */
#ifndef NAKAWARI_TYPES_H
#define NAKAWARI_TYPES_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Three floats: a position, a direction, a scale, or the angles about x, y and z. A column vector. */
typedef struct nkw_vec3 {
    float x, y, z;
} nkw_vec3;

/** The quaternion w + x i + y j + z k. As a rotation it is unit; q and -q are the same rotation. */
typedef struct nkw_quat {
    float x, y, z, w;
} nkw_quat;

/**
 * A 3x3 matrix, column by column: element (row r, column c) is m[c * 3 + r].
 *
 *     m[0] m[3] m[6]
 *     m[1] m[4] m[7]        v' = M v,  v a column
 *     m[2] m[5] m[8]
 */
typedef struct nkw_mat3 {
    float m[9];
} nkw_mat3;

/**
 * A 4x4 matrix, column by column: element (row r, column c) is m[c * 4 + r]; translation in m[12..14].
 *
 *     m[0] m[4] m[ 8] m[12]
 *     m[1] m[5] m[ 9] m[13]        v' = M v,  v a column
 *     m[2] m[6] m[10] m[14]
 *     m[3] m[7] m[11] m[15]
 *
 * OpenGL, Vulkan, std430 and WebGPU take it as it lies. A matrix of row vectors stored row by row (D3DX)
 * has the very same bytes. "Affine" says that the last row is 0 0 0 1.
 */
typedef struct nkw_mat4 {
    float m[16];
} nkw_mat4;

/**
 * The first three rows of an affine 4x4 matrix, row by row: element (row r, column c) is m[r * 4 + c]. What shaders
 * take for skinning palettes as three vec4 (std430, a cbuffer's rows): 48 bytes.
 */
typedef struct nkw_mat3x4 {
    float m[12];
} nkw_mat3x4;

/** A rotation and a translation in one: real + e dual, e e = 0; real is the rotation, dual = (t / 2) real. */
typedef struct nkw_dual_quat {
    nkw_quat real, dual;
} nkw_dual_quat;

/** Scale along the axes, then rotate, then translate: M = T R S. The local transform of glTF and FBX. */
typedef struct nkw_trs {
    nkw_vec3 translation;
    nkw_quat rotation;
    nkw_vec3 scale;
} nkw_trs;

/**
 * Component arrays: element i of a vector array is (x[i], y[i], z[i]). A view is read, a span is written.
 *
 * The batch functions, those that end in _n, take n elements of each. Any alignment for float and any n will do, n = 0
 * too. An output array may be the very input array of the same function (in place), unless that function says
 * otherwise; arrays that overlap in any other way may not be mixed. Element by element the results are those of the
 * single call, bit for bit.
 *
 * Fastest are arrays padded to a multiple of 16 and, of matrices, not a multiple of 4096 bytes apart: so many
 * streams would share the same places of the cache.
 */
typedef struct nkw_vec3_view {
    const float *x, *y, *z;
} nkw_vec3_view;
typedef struct nkw_vec3_span {
    float *x, *y, *z;
} nkw_vec3_span;

typedef struct nkw_quat_view {
    const float *x, *y, *z, *w;
} nkw_quat_view;
typedef struct nkw_quat_span {
    float *x, *y, *z, *w;
} nkw_quat_span;

/** One array for each of the nine elements, in the order of nkw_mat3. */
typedef struct nkw_mat3_view {
    const float *m[9];
} nkw_mat3_view;
typedef struct nkw_mat3_span {
    float *m[9];
} nkw_mat3_span;

/** One array for each of the sixteen elements, in the order of nkw_mat4. */
typedef struct nkw_mat4_view {
    const float *m[16];
} nkw_mat4_view;
typedef struct nkw_mat4_span {
    float *m[16];
} nkw_mat4_span;

typedef struct nkw_trs_view {
    nkw_vec3_view translation;
    nkw_quat_view rotation;
    nkw_vec3_view scale;
} nkw_trs_view;
typedef struct nkw_trs_span {
    nkw_vec3_span translation;
    nkw_quat_span rotation;
    nkw_vec3_span scale;
} nkw_trs_span;

#ifdef __cplusplus
}
#endif

#endif
