/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 6: a crowd: sixteen characters of one skeleton at once, a lane for each, so that the whole width of every
 * vector works also on what cannot be shared out among the joints of one character: the way down the hierarchy.
 *
 *     pose    NKW_CROWD_POSE_FLOATS(joints) floats:    component c of joint j of lane i at (10 j + c) 16 + i,
 *             components as in pose.h: translation x y z, rotation x y z w, scale x y z
 *     matrix  NKW_CROWD_MATRIX_FLOATS(joints) floats:  row r, column c of joint j of lane i at (12 j + 3 c + r) 16 + i,
 *             affine: the row 0 0 0 1 is left out
 *
 * All sixteen lanes are always worked on; a lane that no character has may hold anything. Each lane gives the bits
 * that the functions of skeleton.h and palette.h give for its character alone.
 *
 * More characters are more crowds, one after the other; each may be another thread's.
 */
#ifndef NAKAWARI_CROWD_H
#define NAKAWARI_CROWD_H

#include "clip.h"
#include "palette.h"
#include "pose.h"
#include "skeleton.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Characters in a crowd. */
#define NKW_CROWD 16

/** Floats of a crowd's poses and of its matrices, for arrays on the stack. */
#define NKW_CROWD_POSE_FLOATS(joint_count)   ((joint_count)*10 * NKW_CROWD)
#define NKW_CROWD_MATRIX_FLOATS(joint_count) ((joint_count)*12 * NKW_CROWD)

/** Poses of a crowd that are read: NKW_CROWD_POSE_FLOATS(joint_count) floats. */
typedef struct nkw_crowd_poses_view {
    const float *data;
    size_t joint_count;
} nkw_crowd_poses_view;
/** Poses of a crowd that are written. */
typedef struct nkw_crowd_poses_span {
    float *data;
    size_t joint_count;
} nkw_crowd_poses_span;

/** Matrices of a crowd that are read: NKW_CROWD_MATRIX_FLOATS(joint_count) floats. */
typedef struct nkw_crowd_matrices_view {
    const float *data;
    size_t joint_count;
} nkw_crowd_matrices_view;
/** Matrices of a crowd that are written. */
typedef struct nkw_crowd_matrices_span {
    float *data;
    size_t joint_count;
} nkw_crowd_matrices_span;

/** The same poses, to be read. */
static inline nkw_crowd_poses_view nkw_crowd_poses_view_from_span(nkw_crowd_poses_span poses)
{
    nkw_crowd_poses_view view = {poses.data, poses.joint_count};
    return view;
}

/** The same matrices, to be read. */
static inline nkw_crowd_matrices_view nkw_crowd_matrices_view_from_span(nkw_crowd_matrices_span matrices)
{
    nkw_crowd_matrices_view view = {matrices.data, matrices.joint_count};
    return view;
}

/**
 * Poses (pose.h) into the lanes of a crowd: poses[i] into lane i, for the NKW_CROWD elements of `poses`. Lanes whose data
 * are NULL get the identity for every joint. Returns NKW_MISMATCHED for a pose of another number of joints than `crowd`,
 * nothing is then written.
 */
NKW_API nkw_result nkw_crowd_from_poses(const nkw_pose_view *poses, nkw_crowd_poses_span crowd);

/** Matrices into the lanes: joint j of lane i from matrices[i][j]. NULL: the identity. Last rows are not read. */
NKW_API void nkw_crowd_from_matrices(const nkw_mat4 *const *matrices, nkw_crowd_matrices_span crowd);

/** Matrices out of the lanes: matrices[i][j] from joint j of lane i. Lanes whose pointer is NULL are left out. */
NKW_API void nkw_matrices_from_crowd(nkw_crowd_matrices_view crowd, nkw_mat4 *const *matrices);

/**
 * Local to model, as nkw_models_from_pose: for each joint, parent's model times local.
 *
 * roots    one matrix for each lane (joint_count 1), applied once, to joints without a parent; data NULL: none.
 *          nkw_crowd_from_matrices(places, roots) makes them of one matrix for each character
 * Returns  NKW_MISMATCHED where poses or models are of another number of joints than the skeleton, or roots of another
 *          than 1; nothing is then written
 */
NKW_API nkw_result nkw_crowd_models_from_pose(const nkw_skeleton *skeleton, nkw_crowd_poses_view poses,
                                              nkw_crowd_matrices_view roots, nkw_crowd_matrices_span models);

/**
 * Joint matrices, as nkw_palette_from_models without a global inverse: model of joints[k] times inverse_bind[k].
 *
 * joints        palette.joint_count indices, NULL: 0, 1, 2 ...; an index that is not below models.joint_count becomes
 *               the identity
 * inverse_bind  palette.joint_count matrices, NULL: none, nothing is multiplied
 * palette       may be `models` only where joints is NULL
 */
NKW_API void nkw_crowd_palette_from_models(nkw_crowd_matrices_view models, const int32_t *joints,
                                           const nkw_mat4 *inverse_bind, nkw_crowd_matrices_span palette);

/** Floats that nkw_crowd_sample works in: a pose for each lane. */
#define NKW_CROWD_SAMPLE_FLOATS(joint_count) (NKW_CROWD * NKW_POSE_FLOATS(joint_count))

/** The characters that play one clip, each at its own time. */
typedef struct nkw_crowd_players {
    const float *times; /**< one for each character, seconds */
    /**
     * nkw_clip_cursor_count(clip) numbers for each character, those of the first before those of the second; NULL: none.
     * Those of another crowd change no bit, but searches are short only from a character's own
     */
    uint32_t *cursors;
    size_t character_count; /**< 0..NKW_CROWD, more count as NKW_CROWD; the lanes beyond them get the identity */
} nkw_crowd_players;

/**
 * One clip at many times: lane i is the clip at times[i], with the bits of nkw_clip_sample. The clip's floats (morph
 * weights) are not sampled: nkw_clip_sample without a pose returns them, for each character.
 *
 * crowd    receives the poses
 * work     work_count floats, at least NKW_CROWD_SAMPLE_FLOATS(nkw_clip_joint_count(clip)): afterwards the poses, one
 *          after the other
 * Returns  NKW_MISMATCHED where crowd is of another number of joints than the clip; NKW_TOO_SMALL for work_count
 */
NKW_API nkw_result nkw_crowd_sample(const nkw_clip *clip, const nkw_crowd_players *players, nkw_crowd_poses_span crowd,
                                    float *work, size_t work_count);

/** What is baked: a clip on a skeleton, drawn with a skin. */
typedef struct nkw_crowd_source {
    const nkw_clip *clip; /**< of as many joints as the skeleton */
    const nkw_skeleton *skeleton;
    const nkw_mat4 *root;         /**< applied once, to joints without a parent; NULL: none */
    const int32_t *joints; /**< joint_count indices of the skeleton's joints; NULL: 0, 1, 2 ... */
    const nkw_mat4 *inverse_bind; /**< joint_count matrices; NULL: none */
    size_t joint_count; /**< joints of the skin */
    float start, rate;            /**< frame f is the clip at nkw_segment_uniform_time(start, rate, f) */
} nkw_crowd_source;

/**
 * Checks a source: what nkw_skeleton_validate returns; NKW_MISMATCHED for a clip of another number of joints than the
 * skeleton; NKW_NOT_FINITE where start, rate or one of root's first three rows is not finite; NKW_OUT_OF_RANGE for a
 * rate of 0; what nkw_palette_source_validate returns for the skin. *bad_joint becomes the first offending joint, of the
 * skeleton or of the skin, 0 if it is no joint's fault; it may be NULL.
 */
NKW_API nkw_result nkw_crowd_source_validate(const nkw_crowd_source *source, size_t *bad_joint);

/** Floats that nkw_crowd_bake works in, for a skeleton and a skin of so many joints. */
#define NKW_CROWD_BAKE_FLOATS(joint_count, skin_joint_count)                                                           \
    (NKW_CROWD_SAMPLE_FLOATS(joint_count) + NKW_CROWD_POSE_FLOATS(joint_count) +                                       \
     NKW_CROWD_MATRIX_FLOATS(joint_count) + NKW_CROWD_MATRIX_FLOATS(skin_joint_count))

/**
 * Bakes frames of a clip into a chunk of a buffer of palettes (palette.h), sixteen frames at once. Each frame has the
 * bits of nkw_clip_sample, nkw_models_from_pose and nkw_palette_from_models one after the other.
 *
 * chunk    of as many joints as the skin; its place in the buffer
 * frames   NULL: all of the chunk. Otherwise only these. Threads may share out the frames
 * buffer   receives the matrices, at nkw_palette_chunk_index(chunk, frame, 0)
 * work     work_count floats, at least NKW_CROWD_BAKE_FLOATS(skeleton->joint_count, source->joint_count)
 * Returns  NKW_MISMATCHED where the clip is of another number of joints than the skeleton, or the chunk than the skin;
 *          NKW_TOO_SMALL for work_count; nothing is then written
 */
NKW_API nkw_result nkw_crowd_bake(const nkw_crowd_source *source, const nkw_palette_chunk *chunk,
                                  const nkw_range *frames, nkw_mat4 *buffer, float *work, size_t work_count);

#ifdef __cplusplus
}
#endif

#endif
