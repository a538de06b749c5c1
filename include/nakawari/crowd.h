/* SPDX-License-Identifier: MIT */
/**
 * @file
 * A crowd: sixteen characters of one skeleton, interleaved so that each is one lane of a vector. The joints of
 * one character cannot fill a vector, because a joint needs the matrix of its parent; the same joint of sixteen
 * characters can.
 *
 *     pose    NKW_CROWD_POSE_FLOATS(joints) floats:    component c of joint j of lane i at (10 j + c) 16 + i,
 *             components as in pose.h: translation x y z, rotation x y z w, scale x y z
 *     matrix  NKW_CROWD_MATRIX_FLOATS(joints) floats:  row r, column c of joint j of lane i at (12 j + 3 c + r) 16 + i,
 *             affine: the row 0 0 0 1 is not stored
 *
 * All sixteen lanes are always computed; a lane without a character may hold any values. The results of each lane have
 * the bits of the functions of skeleton.h and palette.h for its character.
 *
 * Use one crowd for each sixteen characters. Different threads may work on different crowds.
 */
#ifndef NAKAWARI_CROWD_H
#define NAKAWARI_CROWD_H

#include "clip.h"
#include "palette.h"
#include "pose.h"
#include "skeleton.h"
#include "skin.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Characters in a crowd. */
#define NKW_CROWD 16

/** Floats of the poses and of the matrices of a crowd, for arrays on the stack. */
#define NKW_CROWD_POSE_FLOATS(joint_count)   ((joint_count)*10 * NKW_CROWD)
#define NKW_CROWD_MATRIX_FLOATS(joint_count) ((joint_count)*12 * NKW_CROWD)

/** Poses of a crowd to read: NKW_CROWD_POSE_FLOATS(joint_count) floats. */
typedef struct nkw_crowd_poses_view {
    const float *data;
    size_t joint_count;
} nkw_crowd_poses_view;
NKW_SIZE(nkw_crowd_poses_view, 16, 8);
/** Poses of a crowd to write. */
typedef struct nkw_crowd_poses_span {
    float *data;
    size_t joint_count;
} nkw_crowd_poses_span;
NKW_SIZE(nkw_crowd_poses_span, 16, 8);

/** Matrices of a crowd to read: NKW_CROWD_MATRIX_FLOATS(joint_count) floats. */
typedef struct nkw_crowd_matrices_view {
    const float *data;
    size_t joint_count;
} nkw_crowd_matrices_view;
NKW_SIZE(nkw_crowd_matrices_view, 16, 8);
/** Matrices of a crowd to write. */
typedef struct nkw_crowd_matrices_span {
    float *data;
    size_t joint_count;
} nkw_crowd_matrices_span;
NKW_SIZE(nkw_crowd_matrices_span, 16, 8);

/**
 * Copies poses (pose.h) into the lanes of a crowd: poses[i] into lane i, for the NKW_CROWD elements of `poses`. If the
 * data of a pose are NULL, its lane becomes the identity for every joint. Returns NKW_MISMATCHED if a pose has another
 * number of joints than `crowd`; nothing is then written.
 */
NKW_API nkw_result nkw_crowd_from_poses(const nkw_pose_view *poses, nkw_crowd_poses_span crowd);

/** Copies matrices into the lanes: joint j of lane i from matrices[i][j]; NULL: the identity. Ignores last rows. */
NKW_API void nkw_crowd_from_matrices(const nkw_mat4 *const *matrices, nkw_crowd_matrices_span crowd);

/** Copies matrices out of the lanes: matrices[i][j] from joint j of lane i. Lanes whose pointer is NULL are skipped. */
NKW_API void nkw_crowd_to_matrices(nkw_crowd_matrices_view crowd, nkw_mat4 *const *matrices);

/**
 * Local to model, as nkw_skeleton_models_from_pose: for each joint, the model matrix of its parent times its local
 * matrix.
 *
 * roots    one matrix for each lane (joint_count 1), applied once, to root joints; data NULL: none.
 *          nkw_crowd_from_matrices stores one matrix of each character in this form
 * Returns  NKW_MISMATCHED if poses or models have another number of joints than the skeleton, or roots more or fewer
 *          than 1; nothing is then written
 */
NKW_API nkw_result nkw_crowd_models_from_pose(const nkw_skeleton *skeleton, nkw_crowd_poses_view poses,
                                              nkw_crowd_matrices_view roots, nkw_crowd_matrices_span models);

/**
 * Joint matrices, as nkw_palette_from_models without a global inverse: models of joints[k] times inverse_bind[k].
 *
 * joints        palette.joint_count indices, NULL: 0, 1, 2 ...; the joint matrix of an index that is negative or not
 *               less than models.joint_count is the identity
 * inverse_bind  palette.joint_count matrices; NULL: none, the models are copied
 * palette       may be `models` only if joints is NULL
 */
NKW_API void nkw_crowd_palette_from_models(nkw_crowd_matrices_view models, const int32_t *joints,
                                           const nkw_mat4 *inverse_bind, nkw_crowd_matrices_span palette);

/**
 * Linear blend skinning of a crowd: one skin and its vertices for all, a palette for each lane. A joint's matrix is
 * read once for sixteen characters, and no palette leaves the lanes. The vertices of lane i have the bits of
 * nkw_skin_linear with the matrices of lane i and without normal matrices.
 *
 * in       the vertices of the skin
 * options  as of nkw_skin_palette
 * outs     the vertices of each lane, NKW_CROWD elements; vectors that are NULL are skipped. They share no vector with
 *          `in` or with each other
 *
 * Returns NKW_OK, or NKW_BAD_FORMAT if the joints or the weights have a format that does not fit; all vectors are then
 * copied.
 *
 * Stack  at most 14 KiB.
 */
NKW_API nkw_result nkw_crowd_skin(nkw_crowd_matrices_view palette, const nkw_skin *skin, nkw_vertices_view in,
                                  nkw_skin_options options, const nkw_vertices_span *outs);

/** The bytes of working memory of nkw_crowd_sample: a pose for each lane. */
#define NKW_CROWD_SAMPLE_WORK(joint_count) (4 * NKW_CROWD * NKW_POSE_FLOATS(joint_count))

/** The characters that play one clip, each at its own time. */
typedef struct nkw_crowd_players {
    const float *times; /**< one for each character, seconds */
    /**
     * cursor_count (nkw_clip_describe) numbers for each character, contiguous, in the order of the characters; NULL:
     * none. Any values yield the same bits, but a search is short only from the cursors of the same character
     */
    uint32_t *cursors;
    size_t character_count; /**< clamped to NKW_CROWD; the other lanes become the identity */
} nkw_crowd_players;
NKW_SIZE(nkw_crowd_players, 24, 12);

/**
 * Samples one clip at many times: lane i is the clip at times[i], with the bits of nkw_clip_sample. The floats of the
 * clip (morph weights) are not sampled: call nkw_clip_sample without a pose for each character.
 *
 * crowd    receives the poses
 * work     NKW_CROWD_SAMPLE_WORK of the clip's joints; receives the poses of the lanes (pose.h), contiguous
 * Returns  NKW_MISMATCHED if crowd has another number of joints than the clip; NKW_TOO_SMALL for too little memory
 *
 * Stack  at most 15 KiB.
 */
NKW_API nkw_result nkw_crowd_sample(const nkw_crowd_players *players, const nkw_clip *clip, nkw_crowd_poses_span crowd,
                                    nkw_work work);

/** The inputs of baking: a clip, its skeleton and a skin. */
typedef struct nkw_crowd_source {
    const nkw_clip *clip; /**< has as many joints as the skeleton */
    const nkw_skeleton *skeleton;
    const nkw_mat4 *root; /**< applied once, to root joints; NULL: none */
    const int32_t *joints; /**< joint_count indices of joints of the skeleton; NULL: 0, 1, 2 ... */
    const nkw_mat4 *inverse_bind; /**< joint_count matrices; NULL: none */
    size_t joint_count; /**< joints of the skin */
    float start, rate; /**< frame f is the clip at nkw_timeline_time({start, rate}, f) */
} nkw_crowd_source;
NKW_SIZE(nkw_crowd_source, 56, 32);

/** The bytes of working memory of nkw_crowd_bake, for a skeleton and a skin. */
#define NKW_CROWD_BAKE_WORK(joint_count, skin_joint_count)                                                             \
    (NKW_CROWD_SAMPLE_WORK(joint_count) +                                                                              \
     4 * (NKW_CROWD_POSE_FLOATS(joint_count) + NKW_CROWD_MATRIX_FLOATS(joint_count) +                                  \
          NKW_CROWD_MATRIX_FLOATS(skin_joint_count)))

/**
 * Bakes frames of a clip into a chunk of a buffer of palettes (palette.h), sixteen frames at once. Each frame has the
 * bits of nkw_clip_sample, nkw_skeleton_models_from_pose and nkw_palette_from_models, called in this order.
 *
 * chunk    the position in the buffer; has as many joints as the skin
 * frames   NULL: all frames of the chunk. Otherwise only these; different threads may bake different frames
 * buffer   receives the matrices of each frame at its position in the chunk
 * bad      receives the first offending joint of the skeleton or of the skin, 0 if there is none; may be NULL
 * work     NKW_CROWD_BAKE_WORK(source->skeleton->joint_count, source->joint_count) bytes
 * Returns  the result of nkw_skeleton_validate; NKW_MISMATCHED if the clip has another number of joints than the
 *          skeleton, or the chunk than the skin; NKW_NOT_FINITE if start, rate or one of the first three rows of root
 *          is not finite; NKW_OUT_OF_RANGE for a rate of 0; the result of nkw_palette_source_validate for the skin;
 *          NKW_TOO_SMALL for too little memory; nothing is then written
 *
 * Stack  at most 17 KiB.
 */
NKW_API nkw_result nkw_crowd_bake(const nkw_crowd_source *source, const nkw_palette_chunk *chunk,
                                  const nkw_range *frames, nkw_mat4 *buffer, size_t *bad, nkw_work work);

#ifdef __cplusplus
}
#endif

#endif
