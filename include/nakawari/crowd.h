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
 * Poses (pose.h) into the lanes of a crowd: poses[i] into lane i, for i below NKW_CROWD. Lanes whose pose is NULL get
 * the identity for every joint.
 */
NKW_API void nkw_crowd_from_poses(const float *const *poses, size_t joints, float *crowd);

/** Matrices into the lanes: joint j of lane i from matrices[i][j]. NULL: the identity. Last rows are not read. */
NKW_API void nkw_crowd_from_matrices(const nkw_mat4 *const *matrices, size_t joints, float *crowd);

/** Matrices out of the lanes: matrices[i][j] from joint j of lane i. Lanes whose pointer is NULL are left out. */
NKW_API void nkw_matrices_from_crowd(const float *crowd, size_t joints, nkw_mat4 *const *matrices);

/**
 * Local to model, as nkw_models_from_pose: for each joint, parent's model times local.
 *
 * crowd   the poses of skeleton->joint_count joints
 * roots   a matrix for each lane, NKW_CROWD_MATRIX_FLOATS(1) floats, applied once, to joints without a parent; NULL:
 *         none. nkw_crowd_from_matrices(places, 1, roots) makes them of one matrix for each character
 * models  receives the matrices of all joints
 */
NKW_API void nkw_crowd_models_from_pose(const nkw_skeleton *skeleton, const float *crowd, const float *roots,
                                        float *models);

/**
 * Joint matrices, as nkw_palette_from_models without a global inverse: model of joints[k] times inverse_bind[k].
 *
 * joints        count numbers of joints, NULL: 0, 1, 2 ...; a number that is none of model_count gives the identity
 * inverse_bind  count matrices, NULL: identities, with which nothing is multiplied
 * palette       receives count matrices for each lane; may be `models` only where joints is NULL
 */
NKW_API void nkw_crowd_palette_from_models(const float *models, size_t model_count, const int32_t *joints,
                                           const nkw_mat4 *inverse_bind, size_t count, float *palette);

/** Floats that nkw_crowd_sample works in: a pose for each lane. */
#define NKW_CROWD_SAMPLE_FLOATS(joints) (NKW_CROWD * NKW_POSE_FLOATS(joints))

/**
 * One clip at many times: lane i is the clip at times[i], with the bits of nkw_clip_sample. The clip's floats (morph
 * weights) are not sampled: nkw_clip_sample(clip, times[i], cursors, NULL, floats) gives them, for each character.
 *
 * times       one for each character, seconds
 * cursors     nkw_clip_cursors(clip) numbers for each character, those of the first before those of the second; NULL.
 *             Those of another crowd change no bit, but searches are short only from a character's own
 * characters  how many, 0..NKW_CROWD, more count as NKW_CROWD; the lanes beyond them get the identity
 * work        NKW_CROWD_SAMPLE_FLOATS(nkw_clip_joints(clip)) floats: the poses stand in them afterwards, one after the
 *             other
 * crowd       receives the poses of nkw_clip_joints(clip) joints
 */
NKW_API void nkw_crowd_sample(const nkw_clip *clip, const float *times, uint32_t *cursors, size_t characters,
                              float *work, float *crowd);

/** What is baked: a clip on a skeleton, drawn with a skin. */
typedef struct nkw_crowd_source {
    const nkw_clip *clip; /**< of as many joints as the skeleton */
    const nkw_skeleton *skeleton;
    const nkw_mat4 *root;         /**< applied once, to joints without a parent; NULL: none */
    const int32_t *joints;        /**< of the skin, numbers of the skeleton's; NULL: 0, 1, 2 ... */
    const nkw_mat4 *inverse_bind; /**< one for each joint of the skin; NULL: none */
    float start, rate;            /**< frame f is the clip at nkw_segment_uniform_time(start, rate, f) */
} nkw_crowd_source;

/**
 * Checks a source and a skin of so many joints: what nkw_skeleton_validate gives; NKW_BAD_METHOD for a clip of another
 * number of joints than the skeleton; NKW_NOT_FINITE where start, rate or one of root's first three rows is not finite;
 * NKW_OUT_OF_RANGE for a rate of 0; what nkw_palette_validate gives for the skin. *bad_joint becomes the first
 * offending joint, of the skeleton or of the skin, 0 if it is no joint's fault; it may be NULL.
 */
NKW_API nkw_result nkw_crowd_source_validate(const nkw_crowd_source *source, size_t skin_joints, size_t *bad_joint);

/** Floats that nkw_crowd_bake works in, for a skeleton and a skin of so many joints. */
#define NKW_CROWD_BAKE_FLOATS(joints, skin_joints)                                                                     \
    (NKW_CROWD_SAMPLE_FLOATS(joints) + NKW_CROWD_POSE_FLOATS(joints) + NKW_CROWD_MATRIX_FLOATS(joints) +               \
     NKW_CROWD_MATRIX_FLOATS(skin_joints))

/**
 * Bakes frames of a clip into a chunk of a buffer of palettes (palette.h), sixteen frames at once. Each frame has the
 * bits of nkw_clip_sample, nkw_models_from_pose and nkw_palette_from_models one after the other.
 *
 * chunk     of as many joints as the skin; its place in the buffer
 * from, to  the frames from .. to - 1; those that the chunk has not are left out. Threads may share out the frames
 * work      NKW_CROWD_BAKE_FLOATS(skeleton->joint_count, chunk->joints) floats
 * buffer    receives the matrices, at nkw_palette_chunk_at(chunk, frame, 0)
 *
 * Nothing is written where the clip is of another number of joints than the skeleton.
 */
NKW_API void nkw_crowd_bake(const nkw_crowd_source *source, const nkw_palette_chunk *chunk, size_t from, size_t to,
                            float *work, nkw_mat4 *buffer);

#ifdef __cplusplus
}
#endif

#endif
