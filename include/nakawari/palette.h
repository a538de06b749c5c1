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

/** What a palette is made from. */
typedef struct nkw_palette_source {
    const nkw_mat4 *models; /**< model_count matrices of the skeleton's joints */
    size_t model_count;
    const int32_t *joints; /**< joint_count indices of models; NULL: 0, 1, 2, ... */
    const nkw_mat4 *inverse_bind; /**< joint_count matrices; NULL: none */
    /**
     * One matrix; NULL: none. In glTF, where vertices come out in world space, models are the joint nodes' world
     * matrices and it is NULL; to draw below the mesh's own node it is the inverse of that node's world matrix.
     */
    const nkw_mat4 *global_inverse;
    size_t joint_count; /**< joints of the skin */
} nkw_palette_source;

/**
 * The palette of a skin. The joint matrices are, bit for bit; a factor that is NULL is left out, and its product too:
 *
 *     m[i] = nkw_mat4_mul_affine(nkw_mat4_mul_affine(global_inverse, models[joints[i]]), inverse_bind[i])
 *
 *     NKW_PALETTE_MAT4, _MAT3X4   m[i]
 *     NKW_PALETTE_DUAL_QUAT       nkw_dual_quat_from_mat4(m[i]): scale, shear and mirroring are dropped
 *     NKW_PALETTE_NORMAL_...      nkw_mat3_normal of the 3x3 block of m[i]: the inverse transpose, also where a scale is
 *                                 zero; normalize the normals afterwards
 *
 * With NULL for joints, inverse_bind and global_inverse it converts a palette of 4x4 matrices to any format.
 *
 * out      joint_count elements. NKW_PALETTE_MAT4 may be inverse_bind itself, or models itself where joints is NULL;
 *          there is no other overlap
 * Returns  NKW_OK; NKW_MISMATCHED where out is of another joint_count, NKW_BAD_FORMAT for an unknown format; nothing is
 *          then written
 *
 * The sign of dual quaternions: real.w >= 0, the side of the bind pose. Two joints that have turned away from each other
 * by more than half a turn have different signs, so skinning negates influences that are not on the side of the vertex's
 * heaviest (nkw_dual_quat_align) before it sums.
 *
 * Error  1.0 u of the number in this table:
 *
 *     NKW_PALETTE_MAT4, _MAT3X4   6.0   of the product of the factors' Frobenius norms at most, 3.0 without
 *                                       global_inverse: three roundings in each product; found were 4.7 and 2.8, for
 *                                       rigid ones 1.3
 *     NKW_PALETTE_DUAL_QUAT       1.3   of the rotation, for rigid joints
 *     NKW_PALETTE_NORMAL_...      1.0   of the Frobenius norm, from the joint matrix
 */
NKW_API nkw_result nkw_palette_from_models(const nkw_palette_source *source, nkw_palette_span out);

/**
 * A palette as 4x4 matrices: a copy, nkw_mat4_from_mat3x4 or nkw_mat4_from_dual_quat of each element. out does not
 * overlap the palette. Returns NKW_BAD_FORMAT for normal matrices and unknown formats; nothing is then written.
 */
NKW_API nkw_result nkw_mat4_from_palette(nkw_palette_view palette, nkw_mat4 *out);

/**
 * The inverse bind matrices of a skin from the model matrices of the bind pose; source->inverse_bind is not read:
 *
 *     out[i] = (global_inverse * models[joints[i]])^-1        nkw_mat4_inverse_affine of nkw_mat4_mul_affine
 *
 * so that nkw_palette_from_models of the same pose returns the identity to rounding. A singular matrix becomes zeros; an
 * index that no model has becomes the identity, except the signs of zeros. out has joint_count matrices and may be
 * models where joints is NULL.
 *
 * Error  1.0 u of the Frobenius norm, without global_inverse.
 */
NKW_API void nkw_inverse_bind_from_models(const nkw_palette_source *source, nkw_mat4 *out);

/**
 * Checks what a palette is made from: NKW_EMPTY without joints; NKW_OUT_OF_RANGE for an index of a joint that is
 * negative or not below model_count; NKW_NOT_FINITE for an inverse bind matrix that has an infinite or NaN element in
 * its first three rows. Models are not read. *bad_joint becomes the first offending joint of the skin, 0 if there is
 * none; it may be NULL.
 */
NKW_API nkw_result nkw_palette_source_validate(const nkw_palette_source *source, size_t *bad_joint);

/**
 * Checks a palette: NKW_BAD_FORMAT for an unknown format; NKW_EMPTY without joints; NKW_NOT_FINITE where a number is not
 * finite, the last rows of 4x4 matrices excepted; NKW_NOT_UNIT where the real part of a dual quaternion is off unit
 * length by more than 1e-2. *bad_joint becomes the first offending joint, 0 if there is none; it may be NULL.
 */
NKW_API nkw_result nkw_palette_validate(nkw_palette_view palette, size_t *bad_joint);

/**
 * A part of a buffer that holds many palettes: frames, one after the other, each of joint_count matrices. A baked clip
 * has its frames, a character that is written anew each time has one. All places are counted in matrices of the
 * buffer, whatever their type (nkw_mat4, nkw_mat3x4, nkw_dual_quat), from its beginning.
 */
typedef struct nkw_palette_chunk {
    size_t frame_count; /**< > 0 */
    size_t joint_count; /**< > 0 */
    size_t first; /**< the place of joint 0 of frame 0, a result of nkw_palette_chunks_place */
} nkw_palette_chunk;

/**
 * Places `count` chunks in one buffer: sets `first` of each from their counts, in order, without overlap,
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
 * The place of a joint in a frame: first + frame * joint_count + joint. A frame or a joint beyond the last counts as the
 * last, so the place is always inside the chunk; a chunk without frames or joints gives `first`. Writing frame f of a
 * chunk is
 *
 *     nkw_palette_span out = {buffer + nkw_palette_chunk_index(&chunk, f, 0), chunk.joint_count, NKW_PALETTE_MAT4};
 *     nkw_palette_from_models(&source, out);
 *
 * and may go on in many threads at once, one for each chunk or frame.
 */
NKW_API size_t nkw_palette_chunk_index(const nkw_palette_chunk *chunk, size_t frame, size_t joint);

#ifdef __cplusplus
}
#endif

#endif
