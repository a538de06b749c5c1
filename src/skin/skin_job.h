/* SPDX-License-Identifier: MIT */
/* From the described data of skin.h to one call of skinning (batch/skin.h). */
#ifndef NAKAWARI_SKIN_JOB_H
#define NAKAWARI_SKIN_JOB_H

#include "lane/strict.h"

#include <nakawari/skin.h>

#include "batch/skin.h"
#include "batch/skin_format.h"

/* The streams of skin_job, of described vertices. */
static inline const nkw_vec3_stream_view *skin_in(const nkw_vertices_view *v, size_t stream)
{
    const nkw_vec3_stream_view *const all[SKIN_STREAMS] = {&v->positions, &v->normals, &v->tangents, &v->bitangents};
    return all[stream];
}

static inline const nkw_vec3_stream_span *skin_out(const nkw_vertices_span *v, size_t stream)
{
    const nkw_vec3_stream_span *const all[SKIN_STREAMS] = {&v->positions, &v->normals, &v->tangents, &v->bitangents};
    return all[stream];
}

/* The bytes from vertex to vertex. */
static inline size_t skin_vector_stride(size_t stride)
{
    return stride ? stride : sizeof(nkw_vec3);
}

static inline int skin_formats_fit(const nkw_skin *skin)
{
    return skin_format_is_joint(skin->joints.format) && skin_format_is_weight(skin->weights.format);
}

/* Without palette and streams. Without influences if nothing can be blended: every vector is then copied. */
static inline skin_job skin_job_of(const nkw_skin *skin, size_t joint_count)
{
    const size_t k = skin->influence_count;
    skin_job r = {0};
    r.joints = skin->joints;
    r.joints.stride = skin_stride(r.joints.stride, r.joints.format, k);
    r.weights = skin->weights;
    r.weights.stride = skin_stride(r.weights.stride, r.weights.format, k);
    r.vertex_count = skin->vertex_count;
    r.influence_count = joint_count == 0 ? 0 : k < NKW_SKIN_INFLUENCES ? k : NKW_SKIN_INFLUENCES;
    r.joint_count = joint_count < SKIN_JOINTS ? (uint32_t)joint_count : SKIN_JOINTS;
    return r;
}

#endif
