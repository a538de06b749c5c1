/* SPDX-License-Identifier: MIT */
/* Views and spans from a pointer and a count, for C and C++. */
#ifndef NAKAWARI_TESTS_VIEWS_H
#define NAKAWARI_TESTS_VIEWS_H

#include <nakawari/nakawari.h>

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

#endif
