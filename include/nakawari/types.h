/* SPDX-License-Identifier: MIT */
/**
 * @file
 * The value types of the library.
 *
 * All values are structs of floats without padding. They may be copied, compared byte by byte, written to a file or
 * passed to a GPU unchanged. Functions take values of up to 16 bytes by value and larger ones by `const *`. Views and
 * spans contain pointers and are passed by value.
 *
 * `Error` lines of all headers state a bound that no measured error exceeds; brackets contain the worst error measured
 * and its arguments. 1 u is 2^-24 of the stated magnitude; without one, of the norm of the exact result, which is 1 for
 * a unit quaternion. 1 ULP is the distance of neighbouring floats at the exact result. docs/accuracy.md lists the
 * inputs.
 */
#ifndef NAKAWARI_TYPES_H
#define NAKAWARI_TYPES_H

#include "base.h"

#ifdef __cplusplus
#include <string.h>

extern "C++" {
/* The text of NKW_VIEW in C++. */
template <typename View, typename Span> static inline View nkwi_view(Span span)
{
    View view;
    memcpy(&view, &span, sizeof view);
    return view;
}
}

extern "C" {
#endif

/** Three floats: a position, a direction, a scale, or the angles about x, y and z. A column vector. */
typedef struct nkw_vec3 {
    float x, y, z;
} nkw_vec3;
NKW_SIZE(nkw_vec3, 12, 12);

/** The quaternion w + x i + y j + z k. A rotation is a unit quaternion; q and -q are the same rotation. */
typedef struct nkw_quat {
    float x, y, z, w;
} nkw_quat;
NKW_SIZE(nkw_quat, 16, 16);

/**
 * A 3x3 matrix in column-major order: element (row r, column c) is m[c * 3 + r].
 *
 *     m[0] m[3] m[6]
 *     m[1] m[4] m[7]        v' = M v,  v a column
 *     m[2] m[5] m[8]
 */
typedef struct nkw_mat3 {
    float m[9];
} nkw_mat3;
NKW_SIZE(nkw_mat3, 36, 36);

/**
 * A 4x4 matrix in column-major order: element (row r, column c) is m[c * 4 + r]; the translation is m[12..14].
 *
 *     m[0] m[4] m[ 8] m[12]
 *     m[1] m[5] m[ 9] m[13]        v' = M v,  v a column
 *     m[2] m[6] m[10] m[14]
 *     m[3] m[7] m[11] m[15]
 *
 * OpenGL, Vulkan, std430 and WebGPU use the same layout. A matrix for row vectors in row-major order (D3DX) has the
 * same bytes. A matrix is affine if its last row is 0 0 0 1.
 */
typedef struct nkw_mat4 {
    float m[16];
} nkw_mat4;
NKW_SIZE(nkw_mat4, 64, 64);

/**
 * The first three rows of an affine 4x4 matrix in row-major order: element (row r, column c) is m[r * 4 + c]; 48 bytes.
 * Shaders read it as three vec4 of a skinning palette (std430, the rows of a cbuffer).
 */
typedef struct nkw_mat3x4 {
    float m[12];
} nkw_mat3x4;
NKW_SIZE(nkw_mat3x4, 48, 48);

/** A rotation and a translation t: real + e dual, e e = 0; real is the rotation, dual = (t / 2) real. */
typedef struct nkw_dual_quat {
    nkw_quat real, dual;
} nkw_dual_quat;
NKW_SIZE(nkw_dual_quat, 32, 32);

/** Scale along the axes, then rotate, then translate: M = T R S. The local transform of glTF and FBX. */
typedef struct nkw_trs {
    nkw_vec3 translation;
    nkw_quat rotation;
    nkw_vec3 scale;
} nkw_trs;
NKW_SIZE(nkw_trs, 40, 40);

/**
 * What moves: a value with its first and second derivative, per unit of the call that returns it: by seconds where a
 * function samples at a time, by the parameter where it evaluates at a parameter. Of a segment of h seconds that is
 * evaluated at its parameter 0..1, the velocity per second is velocity / h, the acceleration is acceleration / h^2.
 */
typedef struct nkw_motion {
    float value, velocity, acceleration;
} nkw_motion;
NKW_SIZE(nkw_motion, 12, 12);
typedef struct nkw_vec3_motion {
    nkw_vec3 value, velocity, acceleration;
} nkw_vec3_motion;
NKW_SIZE(nkw_vec3_motion, 36, 36);

/** A unit quaternion with its angular velocity and acceleration, in radians, in the outer frame. */
typedef struct nkw_quat_motion {
    nkw_quat value;
    nkw_vec3 velocity, acceleration;
} nkw_quat_motion;
NKW_SIZE(nkw_quat_motion, 40, 40);

/**
 * The same of a value of several floats: three arrays of its width, of which any may be NULL if it is not wanted. The
 * velocity and acceleration of an orientation of 4 floats have 3.
 */
typedef struct nkw_motion_span {
    float *value, *velocity, *acceleration;
} nkw_motion_span;
NKW_SIZE(nkw_motion_span, 24, 12);

/** What is stepped (a spring, an offset): a value and its rate per second. */
typedef struct nkw_state {
    float value, velocity;
} nkw_state;
NKW_SIZE(nkw_state, 8, 8);
typedef struct nkw_vec3_state {
    nkw_vec3 value, velocity;
} nkw_vec3_state;
NKW_SIZE(nkw_vec3_state, 24, 24);

/** A unit quaternion and its angular velocity in radians per second, in the outer frame, as for nkw_quat_integrate. */
typedef struct nkw_quat_state {
    nkw_quat value;
    nkw_vec3 velocity;
} nkw_quat_state;
NKW_SIZE(nkw_quat_state, 28, 28);

/** The elements from .. to - 1. A `to` beyond the last element is the end; an empty range has none. */
typedef struct nkw_range {
    size_t from, to;
} nkw_range;
NKW_SIZE(nkw_range, 16, 8);

/**
 * Memory that a function uses during the call: `bytes` bytes, aligned to 16. Its content has no meaning before and after
 * the call. nkw_..._work(...) returns the bytes that a call needs, SIZE_MAX if they exceed size_t; where a stack can hold
 * them, NKW_..._WORK(...) is a constant that is enough. With less, or at an address that is no multiple of 16, a function
 * returns NKW_TOO_SMALL and writes nothing.
 */
typedef struct nkw_work {
    void *data;
    size_t bytes;
} nkw_work;
NKW_SIZE(nkw_work, 16, 8);

/** Bytes that receive what a function builds: the block of a clip. */
typedef struct nkw_bytes_span {
    void *data;
    size_t bytes;
} nkw_bytes_span;
NKW_SIZE(nkw_bytes_span, 16, 8);

/** Declares `name`, an nkw_work of `size` bytes on the stack. `size` is a constant. */
#define NKW_STACK_WORK(name, size)                                                                                     \
    unsigned char name##_memory[(size) + 15];                                                                          \
    const nkw_work name = {name##_memory + (16 - (size_t)name##_memory % 16) % 16, (size)}

/**
 * Numbers of a batch: element i is data[i * stride]. Stride 1 is an array; stride 0 is one number for all elements.
 */
typedef struct nkw_floats {
    const float *data;
    size_t stride;
} nkw_floats;
NKW_SIZE(nkw_floats, 16, 8);

/** Component arrays: element i of a vector array is (x[i], y[i], z[i]). A view is read, a span is written. */
typedef struct nkw_vec3_view {
    const float *x, *y, *z;
} nkw_vec3_view;
NKW_SIZE(nkw_vec3_view, 24, 12);
typedef struct nkw_vec3_span {
    float *x, *y, *z;
} nkw_vec3_span;
NKW_SIZE(nkw_vec3_span, 24, 12);

typedef struct nkw_quat_view {
    const float *x, *y, *z, *w;
} nkw_quat_view;
NKW_SIZE(nkw_quat_view, 32, 16);
typedef struct nkw_quat_span {
    float *x, *y, *z, *w;
} nkw_quat_span;
NKW_SIZE(nkw_quat_span, 32, 16);

/**
 * The view of a span: NKW_VIEW(nkw_pose, span) is an nkw_pose_view of the data of an nkw_pose_span. `type` is the name of
 * both without _view and _span, of any pair of the library; a span of another type does not compile.
 */
#ifdef __cplusplus
#define NKW_VIEW(type, object) nkwi_view<type##_view, type##_span>(object)
#else
#define NKW_VIEW(type, object)                                                                                         \
    (((union {                                                                                                         \
         type##_span span;                                                                                             \
         type##_view view;                                                                                             \
     }){object})                                                                                                       \
         .view)
#endif

/** One array for each of the sixteen elements, in the order of nkw_mat4. */
typedef struct nkw_mat4_view {
    const float *m[16];
} nkw_mat4_view;
NKW_SIZE(nkw_mat4_view, 128, 64);
typedef struct nkw_mat4_span {
    float *m[16];
} nkw_mat4_span;
NKW_SIZE(nkw_mat4_span, 128, 64);

typedef struct nkw_trs_view {
    nkw_vec3_view translation;
    nkw_quat_view rotation;
    nkw_vec3_view scale;
} nkw_trs_view;
NKW_SIZE(nkw_trs_view, 80, 40);
typedef struct nkw_trs_span {
    nkw_vec3_span translation;
    nkw_quat_span rotation;
    nkw_vec3_span scale;
} nkw_trs_span;
NKW_SIZE(nkw_trs_span, 80, 40);

#ifdef __cplusplus
}
#endif

#endif
