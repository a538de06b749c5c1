/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/skin.h>

#include "skin_job.h"

static skin_job job_of(const nkw_skin *skin, size_t joint_count, const nkw_vertices_view *in,
                       const nkw_vertices_span *out)
{
    skin_job r = skin_job_of(skin, joint_count);
    for (size_t v = 0; v < SKIN_STREAMS; v++) {
        const nkw_vec3_stream_view *from = skin_in(in, v);
        const nkw_vec3_stream_span *to = skin_out(out, v);
        const skin_stream stream = {(const unsigned char *)from->data, (unsigned char *)to->data,
                                    skin_vector_stride(from->stride), skin_vector_stride(to->stride)};
        if (from->data && to->data)
            r.streams[v] = stream;
    }
    return r;
}

/* Whether a palette has the format, and the skin formats for joints and weights. */
static nkw_result check_formats(const nkw_skin *skin, nkw_palette_view palette, nkw_palette_format format)
{
    return palette.format == format && skin_formats_fit(skin) ? NKW_OK : NKW_BAD_FORMAT;
}

nkw_result nkw_skin_linear(const nkw_skin *skin, const nkw_skin_palette *palette, nkw_vertices_view in,
                           nkw_vertices_span out)
{
    const nkw_palette_view none = {NULL, 0, NKW_PALETTE_NORMAL_MAT3};
    const nkw_palette_view normals = palette->options.inverse_normals ? none : palette->normals;
    nkw_result result = check_formats(skin, palette->matrices, NKW_PALETTE_MAT4);
    size_t joint_count = palette->matrices.joint_count;
    if (normals.data && normals.joint_count < joint_count)
        joint_count = normals.joint_count;
    if (normals.data && normals.format != NKW_PALETTE_NORMAL_MAT3)
        result = NKW_BAD_FORMAT;
    skin_job job = job_of(skin, result == NKW_OK ? joint_count : 0, &in, &out);
    job.palette = (const unsigned char *)palette->matrices.data;
    job.normals = (const unsigned char *)normals.data;
    job.options = palette->options;
    nkwi_skin_linear(&job);
    return result;
}

nkw_result nkw_skin_dual_quat(const nkw_skin *skin, nkw_palette_view palette, nkw_vertices_view in,
                              nkw_vertices_span out)
{
    nkw_result result = check_formats(skin, palette, NKW_PALETTE_DUAL_QUAT);
    skin_job job = job_of(skin, result == NKW_OK ? palette.joint_count : 0, &in, &out);
    job.palette = (const unsigned char *)palette.data;
    nkwi_skin_dual_quat(&job);
    return result;
}
