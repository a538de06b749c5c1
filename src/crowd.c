/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/crowd.h>
#include <nakawari/mat.h>
#include <nakawari/pose.h>

#include "simd/select.h"

void nkw_crowd_from_poses(const float *const *poses, size_t joints, float *crowd)
{
    nkw_batch_selected()->crowd_from_poses(poses, joints, NKW_POSE_STRIDE(joints), crowd);
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
    nkw_batch_selected()->crowd_to_matrices(crowd, joints, matrices);
}

void nkw_crowd_models_from_pose(const nkw_skeleton *skeleton, const float *crowd, const float *roots, float *models)
{
    nkw_batch_selected()->crowd_models(skeleton->parents, skeleton->joint_count, crowd, roots, models);
}

static void put_identity(float *matrix)
{
    for (size_t k = 0; k < 12; k++)
        for (size_t i = 0; i < NKW_CROWD; i++)
            matrix[k * NKW_CROWD + i] = k % 4 == 0 ? 1.0f : 0.0f;
}

void nkw_crowd_palette_from_models(const float *models, size_t model_count, const int32_t *joints,
                                   const nkw_mat4 *inverse_bind, size_t count, float *palette)
{
    const size_t size = NKW_CROWD_MATRIX_FLOATS(1);
    for (size_t k = 0; k < count; k++) {
        size_t j = joints ? (size_t)joints[k] : k;
        if (j >= model_count)
            put_identity(palette + k * size);
        else if (inverse_bind)
            nkw_batch_selected()->crowd_bind(models + j * size, &inverse_bind[k], palette + k * size);
        else
            memmove(palette + k * size, models + j * size, size * sizeof(float));
    }
}
