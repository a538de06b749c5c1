/* SPDX-License-Identifier: MIT */
/*
 * Views and spans from a pointer and a count, and functions that take described sources on the loose arrays of tests;
 * for C and C++.
 */
#ifndef NAKAWARI_TESTS_VIEWS_H
#define NAKAWARI_TESTS_VIEWS_H

#include <nakawari/nakawari.h>

static inline nkw_bytes_span bytes_span(void *data, size_t bytes)
{
    nkw_bytes_span r = {data, bytes};
    return r;
}

/* The part of the memory from a multiple of 16 on. */
static inline nkw_work work_in(void *data, size_t bytes)
{
    const size_t skipped = (16 - (size_t)data % 16) % 16;
    nkw_work r = {(unsigned char *)data + skipped, bytes - skipped};
    return r;
}

static inline nkw_pose_view pose_view(const float *data, size_t joint_count)
{
    nkw_pose_view r = {data, joint_count};
    return r;
}

static inline nkw_pose_span pose_span(float *data, size_t joint_count)
{
    nkw_pose_span r = {data, joint_count};
    return r;
}

static inline nkw_mask_view mask_view(const float *data, size_t joint_count)
{
    nkw_mask_view r = {data, joint_count};
    return r;
}

static inline nkw_mask_span mask_span(float *data, size_t joint_count)
{
    nkw_mask_span r = {data, joint_count};
    return r;
}

static inline nkw_palette_view palette_view(nkw_palette_format format, const void *data, size_t joint_count)
{
    nkw_palette_view r = {data, joint_count, format};
    return r;
}

static inline nkw_palette_span palette_span(nkw_palette_format format, void *data, size_t joint_count)
{
    nkw_palette_span r = {data, joint_count, format};
    return r;
}

static inline nkw_crowd_poses_view crowd_poses_view(const float *data, size_t joint_count)
{
    nkw_crowd_poses_view r = {data, joint_count};
    return r;
}

static inline nkw_crowd_poses_span crowd_poses_span(float *data, size_t joint_count)
{
    nkw_crowd_poses_span r = {data, joint_count};
    return r;
}

static inline nkw_crowd_matrices_view crowd_matrices_view(const float *data, size_t joint_count)
{
    nkw_crowd_matrices_view r = {data, joint_count};
    return r;
}

static inline nkw_crowd_matrices_span crowd_matrices_span(float *data, size_t joint_count)
{
    nkw_crowd_matrices_span r = {data, joint_count};
    return r;
}

static inline nkw_result mask_from_subtree(const int32_t *parents, size_t joint_count, size_t root, float *mask)
{
    const nkw_skeleton skeleton = {parents, joint_count};
    return nkw_mask_from_subtree(&skeleton, root, mask_span(mask, joint_count));
}

/* The residual. */
static inline float pose_from_models(const nkw_skeleton *skeleton, const nkw_mat4 *models, const nkw_mat4 *root,
                                     float *pose)
{
    float residual = -1.0f;
    nkw_skeleton_pose_from_models(skeleton, models, root, pose_span(pose, skeleton->joint_count), &residual);
    return residual;
}

static inline nkw_result update_models_from_pose(const nkw_skeleton *skeleton, const float *pose, const nkw_mat4 *root,
                                                 size_t from, size_t to, nkw_mat4 *models)
{
    const nkw_range range = {from, to};
    return nkw_skeleton_models_from_pose(skeleton, pose_view(pose, skeleton->joint_count), root, &range, models);
}

static inline void update_models_from_locals(const nkw_skeleton *skeleton, const nkw_mat4 *locals, const nkw_mat4 *root,
                                             size_t from, size_t to, nkw_mat4 *models)
{
    const nkw_range range = {from, to};
    nkw_skeleton_models_from_locals(skeleton, locals, root, &range, models);
}

static inline nkw_palette_source palette_source(const nkw_mat4 *models, size_t model_count, const int32_t *joints,
                                                const nkw_mat4 *inverse_bind, const nkw_mat4 *global_inverse,
                                                size_t count)
{
    nkw_palette_source r = {models, model_count, joints, inverse_bind, global_inverse, count};
    return r;
}

static inline void palette_from_models(const nkw_mat4 *models, size_t model_count, const int32_t *joints,
                                       const nkw_mat4 *inverse_bind, const nkw_mat4 *global_inverse, size_t count,
                                       nkw_mat4 *out)
{
    const nkw_palette_source s = palette_source(models, model_count, joints, inverse_bind, global_inverse, count);
    nkw_palette_from_models(&s, palette_span(NKW_PALETTE_MAT4, out, count));
}

static inline void palette_3x4_from_models(const nkw_mat4 *models, size_t model_count, const int32_t *joints,
                                           const nkw_mat4 *inverse_bind, const nkw_mat4 *global_inverse, size_t count,
                                           nkw_mat3x4 *out)
{
    const nkw_palette_source s = palette_source(models, model_count, joints, inverse_bind, global_inverse, count);
    nkw_palette_from_models(&s, palette_span(NKW_PALETTE_MAT3X4, out, count));
}

static inline void palette_dual_from_models(const nkw_mat4 *models, size_t model_count, const int32_t *joints,
                                            const nkw_mat4 *inverse_bind, const nkw_mat4 *global_inverse, size_t count,
                                            nkw_dual_quat *out)
{
    const nkw_palette_source s = palette_source(models, model_count, joints, inverse_bind, global_inverse, count);
    nkw_palette_from_models(&s, palette_span(NKW_PALETTE_DUAL_QUAT, out, count));
}

static inline void palette_normals_of(nkw_palette_format format, const nkw_mat4 *palette, size_t count, void *out)
{
    const nkw_palette_source s = palette_source(palette, count, NULL, NULL, NULL, count);
    nkw_palette_from_models(&s, palette_span(format, out, count));
}

static inline void palette_normals(const nkw_mat4 *palette, size_t count, nkw_mat3 *out)
{
    palette_normals_of(NKW_PALETTE_NORMAL_MAT3, palette, count, out);
}

static inline void palette_normals_rows(const nkw_mat4 *palette, size_t count, nkw_mat3x4 *out)
{
    palette_normals_of(NKW_PALETTE_NORMAL_ROWS, palette, count, out);
}

static inline void palette_normals_columns(const nkw_mat4 *palette, size_t count, float *out)
{
    palette_normals_of(NKW_PALETTE_NORMAL_COLUMNS, palette, count, out);
}

static inline void inverse_bind_from_models(const nkw_mat4 *models, size_t model_count, const int32_t *joints,
                                            const nkw_mat4 *global_inverse, size_t count, nkw_mat4 *out)
{
    const nkw_palette_source s = palette_source(models, model_count, joints, NULL, global_inverse, count);
    nkw_palette_inverse_bind(&s, out);
}

static inline nkw_result palette_source_validate(size_t model_count, const int32_t *joints,
                                                 const nkw_mat4 *inverse_bind, size_t count, size_t *bad_joint)
{
    const nkw_palette_source s = palette_source(NULL, model_count, joints, inverse_bind, NULL, count);
    return nkw_palette_source_validate(&s, bad_joint);
}

static inline nkw_result crowd_from_poses(const float *const *poses, size_t joint_count, float *crowd)
{
    nkw_pose_view views[NKW_CROWD];
    for (size_t i = 0; i < NKW_CROWD; i++)
        views[i] = pose_view(poses[i], joint_count);
    return nkw_crowd_from_poses(views, crowd_poses_span(crowd, joint_count));
}

static inline void crowd_from_matrices(const nkw_mat4 *const *matrices, size_t joint_count, float *crowd)
{
    nkw_crowd_from_matrices(matrices, crowd_matrices_span(crowd, joint_count));
}

static inline void matrices_from_crowd(const float *crowd, size_t joint_count, nkw_mat4 *const *matrices)
{
    nkw_crowd_to_matrices(crowd_matrices_view(crowd, joint_count), matrices);
}

static inline nkw_result crowd_models_from_pose(const nkw_skeleton *skeleton, const float *poses, const float *roots,
                                                float *models)
{
    size_t count = skeleton->joint_count;
    return nkw_crowd_models_from_pose(skeleton, crowd_poses_view(poses, count), crowd_matrices_view(roots, 1),
                                      crowd_matrices_span(models, count));
}

static inline void crowd_palette_from_models(const float *models, size_t model_count, const int32_t *joints,
                                             const nkw_mat4 *inverse_bind, size_t count, float *palette)
{
    nkw_crowd_palette_from_models(crowd_matrices_view(models, model_count), joints, inverse_bind,
                                  crowd_matrices_span(palette, count));
}

static inline nkw_result crowd_sample(const nkw_clip *clip, const float *times, uint32_t *cursors,
                                      size_t character_count, nkw_work work, float *crowd)
{
    size_t joints = nkw_clip_describe(clip).joint_count;
    const nkw_crowd_players players = {times, cursors, character_count};
    return nkw_crowd_sample(&players, clip, crowd_poses_span(crowd, joints), work);
}

static inline nkw_result crowd_bake(const nkw_crowd_source *source, const nkw_palette_chunk *chunk, size_t from,
                                    size_t to, nkw_work work, nkw_mat4 *buffer)
{
    const nkw_range frames = {from, to};
    return nkw_crowd_bake(source, chunk, &frames, buffer, NULL, work);
}

#endif
