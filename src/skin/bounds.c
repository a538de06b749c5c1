/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/bounds.h>
#include <nakawari/mat.h>

#include "skin_job.h"

/* A vertex and its influences. */
typedef struct bounds_vertex {
    const unsigned char *joints, *weights;
    nkw_vec3 position;
} bounds_vertex;

static nkw_box with_point(const nkw_box *box, nkw_vec3 p)
{
    const nkw_box point = {p, p};
    return nkw_box_union(box, &point);
}

/* Adds a vertex to the boxes of its joints, or to the last one if it has none. */
static void add_vertex(const skin_job *job, const bounds_vertex *v, nkw_box *boxes, size_t joint_count)
{
    int has_joint = 0;
    for (size_t k = 0; k < job->influence_count; k++) {
        const unsigned char *at = v->joints + k * skin_format_size(job->joints.format);
        uint32_t joint = skin_joint(at, job->joints.format);
        float weight = skin_weight(v->weights + k * skin_format_size(job->weights.format), job->weights.format);
        if (weight == 0.0f || joint >= job->joint_count)
            continue;
        boxes[joint] = with_point(&boxes[joint], v->position);
        has_joint = 1;
    }
    if (!has_joint)
        boxes[joint_count] = with_point(&boxes[joint_count], v->position);
}

nkw_result nkw_box_from_skin(const nkw_skin *skin, nkw_vec3_stream_view positions, nkw_box *boxes, size_t joint_count)
{
    if (!skin_formats_fit(skin))
        return NKW_BAD_FORMAT;
    const skin_job job = skin_job_of(skin, joint_count);
    const unsigned char *at = (const unsigned char *)positions.data;
    for (size_t j = 0; j <= joint_count; j++)
        boxes[j] = NKW_BOX_EMPTY;
    for (size_t i = 0; at && i < skin->vertex_count; i++) {
        bounds_vertex v = {(const unsigned char *)job.joints.data + i * job.joints.stride,
                           (const unsigned char *)job.weights.data + i * job.weights.stride,
                           {0.0f, 0.0f, 0.0f}};
        memcpy(&v.position, at + i * skin_vector_stride(positions.stride), sizeof v.position);
        add_vertex(&job, &v, boxes, joint_count);
    }
    return NKW_OK;
}

static nkw_mat4 matrix_at(nkw_palette_view palette, size_t j)
{
    if (palette.format == NKW_PALETTE_MAT4)
        return ((const nkw_mat4 *)palette.data)[j];
    return nkw_mat4_from_mat3x4(&((const nkw_mat3x4 *)palette.data)[j]);
}

nkw_result nkw_box_from_palette(nkw_palette_view palette, const nkw_box *boxes, nkw_box *box)
{
    if (palette.format != NKW_PALETTE_MAT4 && palette.format != NKW_PALETTE_MAT3X4)
        return NKW_BAD_FORMAT;
    nkw_box sum = NKW_BOX_EMPTY;
    sum = nkw_box_union(&sum, &boxes[palette.joint_count]);
    for (size_t j = 0; j < palette.joint_count; j++) {
        nkw_mat4 m = matrix_at(palette, j);
        nkw_box moved = nkw_box_transform(&boxes[j], &m);
        sum = nkw_box_union(&sum, &moved);
    }
    *box = sum;
    return NKW_OK;
}
