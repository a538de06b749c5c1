/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/crowd.h>
#include <nakawari/mat.h>
#include <nakawari/pose.h>
#include <nakawari/segment.h>

#include "batch/crowd.h"
#include "lane/scalar.h"
#include "report.h"

void nkw_crowd_from_poses(const float *const *poses, size_t joints, float *crowd)
{
    nkwi_crowd_from_poses(poses, joints, NKW_POSE_STRIDE(joints), crowd);
}

void nkw_crowd_from_matrices(const nkw_mat4 *const *matrices, size_t joints, float *crowd)
{
    nkw_mat4 identity = nkw_mat4_identity();
    for (size_t j = 0; j < joints; j++)
        for (size_t i = 0; i < NKW_CROWD; i++) {
            const nkw_mat4 *m = matrices[i] ? &matrices[i][j] : &identity;
            for (size_t k = 0; k < 12; k++)
                crowd[(12 * j + k) * NKW_CROWD + i] = m->m[k / 3 * 4 + k % 3];
        }
}

void nkw_matrices_from_crowd(const float *crowd, size_t joints, nkw_mat4 *const *matrices)
{
    nkwi_crowd_to_matrices(crowd, joints, matrices);
}

void nkw_crowd_models_from_pose(const nkw_skeleton *skeleton, const float *crowd, const float *roots, float *models)
{
    nkwi_crowd_models(skeleton->parents, skeleton->joint_count, crowd, roots, models);
}

void nkw_crowd_palette_from_models(const float *models, size_t model_count, const int32_t *joints,
                                   const nkw_mat4 *inverse_bind, size_t count, float *palette)
{
    const size_t size = NKW_CROWD_MATRIX_FLOATS(1);
    const nkw_mat4 *const none[NKW_CROWD] = {NULL};
    for (size_t k = 0; k < count; k++) {
        size_t j = joints ? (size_t)joints[k] : k;
        if (j >= model_count)
            nkw_crowd_from_matrices(none, 1, palette + k * size);
        else if (inverse_bind)
            nkwi_crowd_bind(models + j * size, &inverse_bind[k], palette + k * size);
        else
            memmove(palette + k * size, models + j * size, size * sizeof(float));
    }
}

void nkw_crowd_sample(const nkw_clip *clip, const float *times, uint32_t *cursors, size_t characters, float *work,
                      float *crowd)
{
    const float *poses[NKW_CROWD] = {NULL};
    size_t joints = nkw_clip_joint_count(clip), step = nkw_clip_cursor_count(clip);
    for (size_t i = 0; i < characters && i < NKW_CROWD; i++) {
        float *pose = joints ? work + i * NKW_POSE_FLOATS(joints) : work;
        nkw_pose_span span = {pose, joints};
        nkw_clip_sample(clip, times[i], cursors ? cursors + i * step : NULL, span, NULL);
        poses[i] = pose;
    }
    nkw_crowd_from_poses(poses, joints, crowd);
}

static nkw_result check_frames(const nkw_crowd_source *source)
{
    nkw_result root = source->root ? nkw_palette_validate(1, NULL, source->root, 1, NULL) : NKW_OK;
    if (root != NKW_OK || !lane_is_finite(source->start) || !lane_is_finite(source->rate))
        return NKW_NOT_FINITE;
    return source->rate == 0.0f ? NKW_OUT_OF_RANGE : NKW_OK;
}

nkw_result nkw_crowd_source_validate(const nkw_crowd_source *source, size_t skin_joints, size_t *bad_joint)
{
    size_t bad = 0, joints = source->skeleton->joint_count;
    nkw_result result = nkw_skeleton_validate(source->skeleton, &bad);
    if (result == NKW_OK && nkw_clip_joint_count(source->clip) != joints)
        result = NKW_MISMATCHED;
    if (result == NKW_OK)
        result = check_frames(source);
    if (result == NKW_OK)
        result = nkw_palette_validate(joints, source->joints, source->inverse_bind, skin_joints, &bad);
    return report(result, bad, bad_joint);
}

/* Where the steps of baking leave their results. */
typedef struct bake_work {
    float *poses, *crowd, *models, *palette;
} bake_work;

static bake_work bake_work_in(float *work, size_t joints)
{
    bake_work w;
    w.poses = work;
    w.crowd = w.poses + NKW_CROWD_SAMPLE_FLOATS(joints);
    w.models = w.crowd + NKW_CROWD_POSE_FLOATS(joints);
    w.palette = w.models + NKW_CROWD_MATRIX_FLOATS(joints);
    return w;
}

/* `count` frames from `frame` on, at most a crowd of them. */
static void bake_lanes(const nkw_crowd_source *source, const nkw_palette_chunk *chunk, const float *roots, size_t frame,
                       size_t count, const bake_work *w, nkw_mat4 *buffer)
{
    float times[NKW_CROWD];
    nkw_mat4 *out[NKW_CROWD] = {NULL};
    for (size_t i = 0; i < count; i++) {
        times[i] = nkw_segment_uniform_time(source->start, source->rate, frame + i);
        out[i] = buffer + nkw_palette_chunk_at(chunk, frame + i, 0);
    }
    nkw_crowd_sample(source->clip, times, NULL, count, w->poses, w->crowd);
    nkw_crowd_models_from_pose(source->skeleton, w->crowd, roots, w->models);
    nkw_crowd_palette_from_models(w->models, source->skeleton->joint_count, source->joints, source->inverse_bind,
                                  chunk->joints, w->palette);
    nkw_matrices_from_crowd(w->palette, chunk->joints, out);
}

void nkw_crowd_bake(const nkw_crowd_source *source, const nkw_palette_chunk *chunk, size_t from, size_t to, float *work,
                    nkw_mat4 *buffer)
{
    size_t joints = source->skeleton->joint_count;
    const bake_work w = bake_work_in(work, joints);
    float roots[NKW_CROWD_MATRIX_FLOATS(1)];
    const nkw_mat4 *root[NKW_CROWD];
    if (nkw_clip_joint_count(source->clip) != joints)
        return;
    for (size_t i = 0; i < NKW_CROWD; i++)
        root[i] = source->root;
    nkw_crowd_from_matrices(root, 1, roots);
    to = to < chunk->frames ? to : chunk->frames;
    for (size_t frame = from, count; frame < to; frame += count) {
        count = to - frame < NKW_CROWD ? to - frame : NKW_CROWD;
        bake_lanes(source, chunk, source->root ? roots : NULL, frame, count, &w, buffer);
    }
}
