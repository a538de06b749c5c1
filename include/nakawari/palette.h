/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 6: from the joints' model matrices to what skinning and shaders take: joint matrices, in palettes.
 *
 *     joint matrix = (global inverse * model) * inverse bind
 *
 *     inverse bind     from the mesh's space to the joint's, in the pose in which the mesh was bound
 *     model            from the joint's space to the skeleton's, now
 *     global inverse   from the skeleton's space to the mesh's; none where they are the same
 *
 * A joint that stands as it was bound has the identity as its joint matrix: its vertices stay where they are. All
 * matrices are affine: last rows are not read, and those written are exactly 0 0 0 1.
 *
 * A skin names its joints by their numbers in the skeleton: joint i of the skin is model joints[i]. joints = NULL says
 * that they are the same in the same order. A number that no model has gives the identity matrix; nothing is read for
 * it.
 */
#ifndef NAKAWARI_PALETTE_H
#define NAKAWARI_PALETTE_H

#include <stdint.h>

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What the elements of a palette are. */
typedef enum nkw_palette_format {
    NKW_PALETTE_MAT4,           /**< nkw_mat4, 64 bytes: joint matrices */
    NKW_PALETTE_MAT3X4,         /**< nkw_mat3x4, 48 bytes: the first three rows of joint matrices */
    NKW_PALETTE_DUAL_QUAT,      /**< nkw_dual_quat, 32 bytes: joint matrices without scale and shear, unit */
    NKW_PALETTE_NORMAL_MAT3,    /**< nkw_mat3, 36 bytes: normal matrices (nkw_mat3_normal of joint matrices) */
    NKW_PALETTE_NORMAL_ROWS,    /**< nkw_mat3x4, 48 bytes: rows of normal matrices, fourth elements 0 */
    NKW_PALETTE_NORMAL_COLUMNS, /**< 12 floats, 48 bytes: columns of normal matrices, each of four floats, the last 0 */
    NKW_PALETTE_FORMAT_COUNT
} nkw_palette_format;

/** A palette that is read: joint_count elements of the format, contiguous. */
typedef struct nkw_palette_view {
    const void *data;
    size_t joint_count;
    nkw_palette_format format;
} nkw_palette_view;
/** A palette that is written. */
typedef struct nkw_palette_span {
    void *data;
    size_t joint_count;
    nkw_palette_format format;
} nkw_palette_span;

/** The same palette, to be read. */
static inline nkw_palette_view nkw_palette_view_from_span(nkw_palette_span palette)
{
    nkw_palette_view view = {palette.data, palette.joint_count, palette.format};
    return view;
}

/**
 * The joint matrices of a skin, out[i] for i in 0..count - 1.
 *
 *     out[i] = nkw_mat4_mul_affine(nkw_mat4_mul_affine(global_inverse, models[joints[i]]), inverse_bind[i])
 *
 * bit for bit; a factor that is NULL is left out, and its product too.
 *
 * Error            6.0 u of the product of the factors' Frobenius norms at most, 3.0 u without global_inverse: three
 *                  roundings in each product; found were 4.7 u and 2.8 u, for rigid ones 1.3 u
 *
 * models           model_count matrices of the skeleton's joints
 * joints           count numbers of models; NULL: 0, 1, 2, ...
 * inverse_bind     count matrices; NULL: none
 * global_inverse   one matrix; NULL: none. In glTF, where vertices come out in world space, models are the joint
 *                  nodes' world matrices and it is NULL; to draw below the mesh's own node it is the inverse of that
 *                  node's world matrix
 * out              may be inverse_bind itself; may be models itself where joints is NULL; no other overlap
 */
NKW_API void nkw_palette_from_models(const nkw_mat4 *models, size_t model_count, const int32_t *joints,
                                     const nkw_mat4 *inverse_bind, const nkw_mat4 *global_inverse, size_t count,
                                     nkw_mat4 *out);

/**
 * The same matrices as three rows of four, same bits: 48 bytes each instead of 64, a quarter less to upload. With NULL
 * for joints, inverse_bind and global_inverse it turns a palette of 4x4 matrices into one of 3x4. out overlaps no
 * input.
 */
NKW_API void nkw_palette_3x4_from_models(const nkw_mat4 *models, size_t model_count, const int32_t *joints,
                                         const nkw_mat4 *inverse_bind, const nkw_mat4 *global_inverse, size_t count,
                                         nkw_mat3x4 *out);

/**
 * The same matrices as unit dual quaternions, each nkw_dual_quat_from_mat4 of the joint matrix, bit for bit. Scale,
 * shear and mirroring are dropped. With NULLs as above it turns a palette of 4x4 matrices into dual quaternions. out
 * overlaps no input.
 *
 * Error  1.3 u of the rotation, for rigid joints.
 *
 * The sign: real.w >= 0, the side of the bind pose. Two joints that have turned away from each other by more than half
 * a turn stand on different sides all the same, so skinning takes each influence to the side of the vertex's heaviest
 * (nkw_dual_quat_align) before it sums; no sign of the palette alone can save that.
 */
NKW_API void nkw_palette_dual_from_models(const nkw_mat4 *models, size_t model_count, const int32_t *joints,
                                          const nkw_mat4 *inverse_bind, const nkw_mat4 *global_inverse, size_t count,
                                          nkw_dual_quat *out);

/** Back to 4x4: nkw_mat4_from_mat3x4 and nkw_mat4_from_dual_quat of each. out does not overlap the input. */
NKW_API void nkw_palette_from_3x4(const nkw_mat3x4 *palette, size_t count, nkw_mat4 *out);
NKW_API void nkw_palette_from_dual(const nkw_dual_quat *palette, size_t count, nkw_mat4 *out);

/**
 * The inverse bind matrices of a skin from the model matrices of the bind pose:
 *
 *     out[i] = (global_inverse * models[joints[i]])^-1        nkw_mat4_inverse_affine of nkw_mat4_mul_affine
 *
 * so that nkw_palette_from_models of the same pose gives the identity to rounding. A singular matrix gives zeros, a
 * number that no model has the identity, but for the signs of zeros. Parameters as above; out may be models where
 * joints is NULL.
 *
 * Error  1.0 u of the Frobenius norm, without global_inverse.
 */
NKW_API void nkw_inverse_bind_from_models(const nkw_mat4 *models, size_t model_count, const int32_t *joints,
                                          const nkw_mat4 *global_inverse, size_t count, nkw_mat4 *out);

/**
 * The matrices that turn normals where the palette's turn positions: nkw_mat3_normal of the 3x3 block of each, bit for
 * bit. The inverse transpose, also where a scale is zero; normalise the normals afterwards.
 *
 * Three forms: 3x3 matrices; rows of four floats (row r in m[4 r .. 4 r + 2], m[4 r + 3] = 0), to go with a 3x4
 * palette; columns of four floats (12 floats a joint, column c in out[12 i + 4 c ..], fourth ones 0), which is `mat3
 * normals[]` in std430 and std140. out overlaps no input.
 *
 * Error  1.0 u of the Frobenius norm.
 */
NKW_API void nkw_palette_normals(const nkw_mat4 *palette, size_t count, nkw_mat3 *out);
NKW_API void nkw_palette_normals_rows(const nkw_mat4 *palette, size_t count, nkw_mat3x4 *out);
NKW_API void nkw_palette_normals_columns(const nkw_mat4 *palette, size_t count, float *out);

/**
 * Checks what a palette is made from: NKW_EMPTY without joints; NKW_OUT_OF_RANGE for a joint's number that is negative
 * or not below model_count; NKW_NOT_FINITE for an inverse bind matrix that has an infinite or NaN element in its first
 * three rows. *bad_joint becomes the first offending joint of the skin, 0 if there is none; it may be NULL.
 */
NKW_API nkw_result nkw_palette_validate(size_t model_count, const int32_t *joints, const nkw_mat4 *inverse_bind,
                                        size_t count, size_t *bad_joint);

/**
 * Checks a palette of dual quaternions: NKW_EMPTY without joints; NKW_NOT_FINITE where a number is not finite;
 * NKW_NOT_UNIT where the real part is off unit length by more than 1e-2. *bad_joint becomes the first offending joint,
 * 0 if there is none; it may be NULL.
 */
NKW_API nkw_result nkw_palette_dual_validate(const nkw_dual_quat *palette, size_t count, size_t *bad_joint);

/**
 * A part of a buffer that holds many palettes: frames, one after the other, each of `joints` matrices. A baked clip
 * has its frames, a character that is written anew each time has one. All places are counted in matrices of the
 * buffer, whatever their type (nkw_mat4, nkw_mat3x4, nkw_dual_quat), from its beginning.
 */
typedef struct nkw_palette_chunk {
    size_t frames; /**< > 0 */
    size_t joints; /**< > 0 */
    size_t first;  /**< the place of joint 0 of frame 0, a result of nkw_palette_chunks_place */
} nkw_palette_chunk;

/**
 * Places `count` chunks in one buffer: sets `first` of each from their frames and joints, in order, without overlap,
 * each at a multiple of `alignment` matrices (0 and 1: anywhere; GPUs want bindings at multiples of 256 bytes: 4
 * nkw_mat4, 8 dual quaternions, 16 nkw_mat3x4). *total becomes the matrices that the buffer must hold.
 *
 * Result NKW_EMPTY: a chunk has no frames or no joints. NKW_TOO_SMALL: size_t cannot hold the buffer's bytes, at 64
 *        bytes a matrix. Then *bad_chunk, which may be NULL, is the chunk, and *total the matrices up to it.
 */
NKW_API nkw_result nkw_palette_chunks_place(nkw_palette_chunk *chunks, size_t count, size_t alignment, size_t *total,
                                            size_t *bad_chunk);

/**
 * Checks chunks of a buffer of `total` matrices that were placed by other means: NKW_EMPTY for one without frames or
 * joints; NKW_OUT_OF_RANGE for one that does not lie inside the buffer; NKW_REPEATED for one that begins before the end
 * of the one before it. *bad_chunk becomes the first offender, 0 if there is none; it may be NULL.
 */
NKW_API nkw_result nkw_palette_chunks_validate(const nkw_palette_chunk *chunks, size_t count, size_t total,
                                               size_t *bad_chunk);

/**
 * The place of a joint in a frame: first + frame * joints + joint. A frame or a joint beyond the last counts as the
 * last, so the place is always inside the chunk; a chunk without frames or joints gives `first`. Writing frame f of a
 * chunk is
 *
 *     nkw_palette_from_models(models, ..., chunk.joints, buffer + nkw_palette_chunk_at(&chunk, f, 0))
 *
 * and may go on in many threads at once, one for each chunk or frame.
 */
NKW_API size_t nkw_palette_chunk_at(const nkw_palette_chunk *chunk, size_t frame, size_t joint);

#ifdef __cplusplus
}
#endif

#endif
