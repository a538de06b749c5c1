/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/skin.h>

#include "batch/skin.h"
#include "skin_format.h"

static skin_stream stream_of(nkw_vec3_stream_view in, nkw_vec3_stream_span out)
{
    const skin_stream none = {NULL, NULL, 0, 0};
    const skin_stream r = {(const unsigned char *)in.data, (unsigned char *)out.data,
                           in.stride ? in.stride : sizeof(nkw_vec3), out.stride ? out.stride : sizeof(nkw_vec3)};
    return in.data && out.data ? r : none;
}

/* Without influences if nothing can be blended: every vector is then copied. */
static skin_job job_of(const nkw_skin *skin, size_t joint_count, const nkw_vertices_view *in,
                       const nkw_vertices_span *out)
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
    r.streams[SKIN_POSITIONS] = stream_of(in->positions, out->positions);
    r.streams[SKIN_NORMALS] = stream_of(in->normals, out->normals);
    r.streams[SKIN_TANGENTS] = stream_of(in->tangents, out->tangents);
    r.streams[SKIN_BITANGENTS] = stream_of(in->bitangents, out->bitangents);
    return r;
}

/* Whether a palette has the format, and the skin formats for joints and weights. */
static nkw_result check_formats(const nkw_skin *skin, nkw_palette_view palette, nkw_palette_format format)
{
    int fits = palette.format == format && skin_format_is_joint(skin->joints.format) &&
               skin_format_is_weight(skin->weights.format);
    return fits ? NKW_OK : NKW_BAD_FORMAT;
}

nkw_result nkw_skin_linear(const nkw_skin *skin, const nkw_skin_palette *palette, const nkw_vertices_view *in,
                           const nkw_vertices_span *out)
{
    const nkw_palette_view normals = palette->normals;
    nkw_result result = check_formats(skin, palette->matrices, NKW_PALETTE_MAT4);
    size_t joint_count = palette->matrices.joint_count;
    if (normals.data && normals.joint_count < joint_count)
        joint_count = normals.joint_count;
    if (normals.data && normals.format != NKW_PALETTE_NORMAL_MAT3)
        result = NKW_BAD_FORMAT;
    skin_job job = job_of(skin, result == NKW_OK ? joint_count : 0, in, out);
    job.palette = (const unsigned char *)palette->matrices.data;
    job.normals = (const unsigned char *)normals.data;
    job.skip_normalization = palette->skip_normalization;
    nkwi_skin_linear(&job);
    return result;
}

nkw_result nkw_skin_dual_quat(const nkw_skin *skin, nkw_palette_view palette, const nkw_vertices_view *in,
                              const nkw_vertices_span *out)
{
    nkw_result result = check_formats(skin, palette, NKW_PALETTE_DUAL_QUAT);
    skin_job job = job_of(skin, result == NKW_OK ? palette.joint_count : 0, in, out);
    job.palette = (const unsigned char *)palette.data;
    nkwi_skin_dual_quat(&job);
    return result;
}
