/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Palettes: the joint matrices of a skin, from model matrices, for skinning and shaders.
 *
 *     joint matrix = (global inverse * model) * inverse bind
 *
 *     inverse bind     from the mesh's space to the joint's, in the bind pose
 *     model            from the joint's space to the skeleton's, in the current pose
 *     global inverse   from the skeleton's space to the mesh's; none if they are the same
 *
 * In the bind pose joint matrices are the identity: vertices do not move. All matrices are affine: last rows are not
 * read and are written as exactly 0 0 0 1.
 *
 * A skin lists the indices of its joints in the skeleton: joint i of the skin has the model matrix models[joints[i]].
 * joints = NULL: the joints of the skeleton in the same order. If joints[i] is negative or not less than the number of
 * models, nothing is read and the joint matrix is the identity.
 *
 * Example  nkw_palette_source source; nkw_palette_span out; nkw_palette_view view; nkw_mat4 *m;
 *          nkw_palette_chunk chunks[2]; size_t total, bad; float x;
 *
 *     nkw_palette_from_models(&source, out);                     joint matrices, for skinning or for a shader
 *     x = nkw_palette_residual(&source, &bad);                   what dual quaternions drop
 *     nkw_palette_to_mat4(view, m);                              of any format, as 4x4 matrices
 *     nkw_palette_inverse_bind(&source, m);                      from the models of the bind pose
 *     nkw_palette_source_validate(&source, &bad);                which joint is wrong
 *     nkw_palette_validate(view, &bad);                          which joint is not finite
 *     nkw_palette_chunks_place(chunks, 2, 256, &total, &bad);    many palettes in one buffer
 *     nkw_palette_chunks_validate(chunks, 2, total, &bad);       which chunk overlaps
 */
#ifndef NAKAWARI_PALETTE_H
#define NAKAWARI_PALETTE_H

#include <stdint.h>

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The format of the elements of a palette. */
typedef enum nkw_palette_format {
    NKW_PALETTE_MAT4,           /**< nkw_mat4, 64 bytes: joint matrices */
    NKW_PALETTE_MAT3X4,         /**< nkw_mat3x4, 48 bytes: the first three rows of joint matrices */
    NKW_PALETTE_DUAL_QUAT,      /**< nkw_dual_quat, 32 bytes: joint matrices without scale and shear, unit */
    NKW_PALETTE_NORMAL_MAT3,    /**< nkw_mat3, 36 bytes: normal matrices (nkw_mat3_normal of joint matrices) */
    NKW_PALETTE_NORMAL_ROWS,    /**< nkw_mat3x4, 48 bytes: rows of normal matrices, fourth elements 0 */
    NKW_PALETTE_NORMAL_COLUMNS, /**< 12 floats, 48 bytes: columns of normal matrices, each of four floats, the last 0 */
    NKW_PALETTE_FORMAT_COUNT,
    NKW_PALETTE_FORMAT_MAX_ENUM = 0x7fffffff
} nkw_palette_format;

/** A palette to read: joint_count contiguous elements of the format. */
typedef struct nkw_palette_view {
    const void *data;
    size_t joint_count;
    nkw_palette_format format;
} nkw_palette_view;
NKW_SIZE(nkw_palette_view, 24, 12);
/** A palette to write. */
typedef struct nkw_palette_span {
    void *data;
    size_t joint_count;
    nkw_palette_format format;
} nkw_palette_span;
NKW_SIZE(nkw_palette_span, 24, 12);

/** The inputs of a palette. */
typedef struct nkw_palette_source {
    const nkw_mat4 *models; /**< model_count matrices of the skeleton's joints */
    size_t model_count;
    const int32_t *joints; /**< joint_count indices of models; NULL: 0, 1, 2, ... */
    const nkw_mat4 *inverse_bind; /**< joint_count matrices; NULL: none */
    /**
     * One matrix; NULL: none. In glTF models are the world matrices of the joint nodes. NULL then yields vertices in
     * world space; the inverse of the world matrix of the mesh's node yields vertices in the space of that node.
     */
    const nkw_mat4 *global_inverse;
    size_t joint_count; /**< joints of the skin */
} nkw_palette_source;
NKW_SIZE(nkw_palette_source, 48, 24);

/**
 * The palette of a skin, bit for bit by these formulas. A factor that is NULL is omitted, and its product too.
 *
 *     m[i] = nkw_mat4_mul_affine(nkw_mat4_mul_affine(global_inverse, models[joints[i]]), inverse_bind[i])
 *
 *     NKW_PALETTE_MAT4, _MAT3X4   m[i]
 *     NKW_PALETTE_DUAL_QUAT       nkw_dual_quat_from_mat4(m[i]): scale, shear and mirroring are dropped:
 *                                 nkw_palette_residual tells how much
 *     NKW_PALETTE_NORMAL_...      nkw_mat3_normal of the 3x3 block of m[i]: the inverse transpose, defined also for a
 *                                 scale of zero, under rotated parents too; normalise the normals afterwards
 *
 * With NULL for joints, inverse_bind and global_inverse it converts a palette of 4x4 matrices to any format.
 *
 * out      joint_count elements. With NKW_PALETTE_MAT4 it may be inverse_bind, or models if joints is NULL; otherwise
 *          it must not overlap the inputs
 * Returns  NKW_OK; NKW_MISMATCHED if out has another joint_count; NKW_BAD_FORMAT for an unknown format; nothing is then
 *          written
 *
 * Dual quaternions have real.w >= 0, so the identity of the bind pose is 1 and not -1. Joints that differ by more than
 * half a turn can have different signs: skinning therefore aligns the influences of a vertex with that of the largest
 * weight before it sums them: both parts of one with a negative dot product are negated.
 *
 * Error  1.0 u of the number in this table:
 *
 *     NKW_PALETTE_MAT4, _MAT3X4   6.0   of the product of the Frobenius norms of the factors at most, 3.0 without
 *                                       global_inverse: three roundings in each product; measured 4.7 and 2.8, for
 *                                       rigid joints 1.3
 *     NKW_PALETTE_DUAL_QUAT       1.5   of the rotation, for rigid joints
 *     NKW_PALETTE_NORMAL_...      1.0   of the Frobenius norm, from the joint matrix
 *
 * Stack  at most 5 KiB.
 */
NKW_API nkw_result nkw_palette_from_models(const nkw_palette_source *source, nkw_palette_span out);

/**
 * What NKW_PALETTE_DUAL_QUAT drops of a palette: the largest distance between the ends of an axis of the mesh, of
 * length 1, as the joint matrix M and as its dual quaternion, with the rotation R, moves it:
 *
 *     residual = max over joints and columns k of |M_k - R_k|
 *
 * About 3e-7 if all joints are rigid, |s - 1| for a scale s, 2 for a mirror. Where it is large, skin by matrices, or
 * scale the mesh first (nkw_skin_dual_quat). NaN if a matrix has a NaN; 0 without joints. *bad becomes the joint of the
 * skin with the largest one, or the first with a NaN, 0 if there is none; it may be NULL.
 */
NKW_API float nkw_palette_residual(const nkw_palette_source *source, size_t *bad);

/**
 * Converts a palette to 4x4 matrices: a copy, nkw_mat4_from_mat3x4 or nkw_mat4_from_dual_quat of each element. out must
 * not overlap the palette. Returns NKW_BAD_FORMAT for normal matrices and unknown formats; nothing is then written.
 */
NKW_API nkw_result nkw_palette_to_mat4(nkw_palette_view palette, nkw_mat4 *out);

/**
 * The inverse bind matrices of a skin from the model matrices of the bind pose; source->inverse_bind is not read:
 *
 *     out[i] = (global_inverse * models[joints[i]])^-1        nkw_mat4_inverse_affine of nkw_mat4_mul_affine
 *
 * so that nkw_palette_from_models of the same pose yields the identity to rounding. The inverse is zeros where the
 * matrix is flat: its determinant is at most 2^-20 of the product of the lengths of its columns (as in
 * nkw_skeleton_locals_from_models). That of an index without a model is the identity, except for the signs of zeros.
 * out has joint_count matrices and may be models if joints is NULL.
 *
 * Error  10.0 u without global_inverse, of the norms that nkw_mat4_inverse_affine states.
 * Stack  at most 5 KiB.
 */
NKW_API void nkw_palette_inverse_bind(const nkw_palette_source *source, nkw_mat4 *out);

/**
 * Checks the inputs of a palette. Models are not read.
 *
 * Returns  NKW_EMPTY without joints; NKW_OUT_OF_RANGE if an index of a joint is negative or not less than model_count;
 *          NKW_NOT_FINITE if an inverse bind matrix has an infinite or NaN element in its first three rows. *bad
 *          becomes the first offending joint of the skin, 0 if there is none; it may be NULL.
 */
NKW_API nkw_result nkw_palette_source_validate(const nkw_palette_source *source, size_t *bad);

/**
 * Checks a palette.
 *
 * Returns  NKW_BAD_FORMAT for an unknown format; NKW_EMPTY without joints; NKW_NOT_FINITE if a number is not finite,
 *          except in the last rows of 4x4 matrices; NKW_NOT_UNIT if the length of the real part of a dual quaternion
 *          differs from 1 by more than 1e-2. *bad becomes the first offending joint, 0 if there is none; it may
 *          be NULL.
 */
NKW_API nkw_result nkw_palette_validate(nkw_palette_view palette, size_t *bad);

/**
 * A section of a buffer that contains many palettes: frame_count contiguous frames of joint_count matrices. A baked
 * clip has one palette for each frame; a character whose palette is computed every frame has one. Positions are counted
 * from the start of the buffer in its elements (nkw_mat4, nkw_mat3x4 or nkw_dual_quat):
 *
 *     position of joint j of frame f = first + f joint_count + j
 *
 * This writes frame f of a chunk of `buffer`; different threads may write different frames and chunks:
 *
 *     nkw_palette_span out = {buffer + chunk.first + f * chunk.joint_count, chunk.joint_count, NKW_PALETTE_MAT4};
 *     nkw_palette_from_models(&source, out);
 */
typedef struct nkw_palette_chunk {
    size_t frame_count; /**< > 0 */
    size_t joint_count; /**< > 0 */
    size_t first; /**< the position of joint 0 of frame 0, set by nkw_palette_chunks_place */
} nkw_palette_chunk;
NKW_SIZE(nkw_palette_chunk, 24, 12);

/**
 * Places `count` chunks in one buffer: sets `first` of each chunk, in order, without overlap.
 *
 * alignment  each `first` is a multiple of it, in elements; 0 and 1: any position. GPUs require bindings at multiples
 *            of 256 bytes: 4 nkw_mat4, 8 nkw_dual_quat, 16 nkw_mat3x4
 * total      *total becomes the number of elements of the buffer
 * Returns    NKW_EMPTY if a chunk has no frames or no joints; NKW_TOO_SMALL if size_t cannot hold the size of the
 *            buffer in bytes, at 64 bytes an element. Then *bad, which may be NULL, becomes the chunk, and *total
 *            the number of elements before it.
 */
NKW_API nkw_result nkw_palette_chunks_place(nkw_palette_chunk *chunks, size_t count, size_t alignment, size_t *total,
                                            size_t *bad);

/**
 * Checks chunks of a buffer of `total` elements, for positions that nkw_palette_chunks_place did not set.
 *
 * Returns  NKW_EMPTY if a chunk has no frames or no joints; NKW_OUT_OF_RANGE if it is not inside the buffer;
 *          NKW_REPEATED if it begins before the end of the previous chunk. *bad becomes the first offending
 *          chunk, 0 if there is none; it may be NULL.
 */
NKW_API nkw_result nkw_palette_chunks_validate(const nkw_palette_chunk *chunks, size_t count, size_t total,
                                               size_t *bad);

#ifdef __cplusplus
}
#endif

#endif
