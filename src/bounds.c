/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/bounds.h>
#include <nakawari/mat.h>
#include <nakawari/vec.h>

#include "lane/scalar.h"
#include "skin_job.h"

/* More than the rounding of a blend of eight matrices and of a product: about 20 u. */
#define BOUNDS_MARGIN 0x1p-19

nkw_box nkw_box_empty(void)
{
    nkw_box box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    return box;
}

int nkw_box_is_empty(const nkw_box *box)
{
    return !(box->low.x <= box->high.x && box->low.y <= box->high.y && box->low.z <= box->high.z);
}

/* The smaller and the greater; a where b is NaN. */
static float least(float a, float b)
{
    return b < a ? b : a;
}

static float greatest(float a, float b)
{
    return b > a ? b : a;
}

static nkw_box join(const nkw_box *a, nkw_vec3 low, nkw_vec3 high)
{
    nkw_box box = {{least(a->low.x, low.x), least(a->low.y, low.y), least(a->low.z, low.z)},
                   {greatest(a->high.x, high.x), greatest(a->high.y, high.y), greatest(a->high.z, high.z)}};
    return box;
}

nkw_box nkw_box_union(const nkw_box *a, const nkw_box *b)
{
    nkw_box box = nkw_box_empty();
    box = join(&box, a->low, a->high);
    return join(&box, b->low, b->high);
}

nkw_box nkw_box_add_point(const nkw_box *box, nkw_vec3 p)
{
    return p.x == p.x && p.y == p.y && p.z == p.z ? join(box, p, p) : *box;
}

/* One row of the image: centre and half length, in binary64, which is exact to far less than the margin. */
static void transform_row(const nkw_mat4 *m, const nkw_box *box, size_t row, float *low, float *high)
{
    const float from[3] = {box->low.x, box->low.y, box->low.z}, to[3] = {box->high.x, box->high.y, box->high.z};
    double centre = (double)m->m[12 + row], half = 0.0, size = lane_abs64(centre);
    for (size_t c = 0; c < 3; c++) {
        double e = (double)m->m[c * 4 + row], a = (double)from[c], b = (double)to[c];
        double most = lane_abs64(a) > lane_abs64(b) ? lane_abs64(a) : lane_abs64(b);
        centre += e * (0.5 * (a + b));
        half += lane_abs64(e) * (0.5 * (b - a));
        size += lane_abs64(e) * most;
    }
    half += BOUNDS_MARGIN * size;
    *low = (float)(centre - half);
    *high = (float)(centre + half);
}

nkw_box nkw_box_transform(const nkw_mat4 *m, const nkw_box *box)
{
    const nkw_box all = {{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}};
    nkw_box r;
    if (nkw_box_is_empty(box))
        return nkw_box_empty();
    transform_row(m, box, 0, &r.low.x, &r.high.x);
    transform_row(m, box, 1, &r.low.y, &r.high.y);
    transform_row(m, box, 2, &r.low.z, &r.high.z);
    return nkw_vec3_is_finite(r.low) && nkw_vec3_is_finite(r.high) ? r : all;
}

/* A vertex and its influences. */
typedef struct bounds_vertex {
    const unsigned char *joints, *weights;
    nkw_vec3 position;
} bounds_vertex;

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
        boxes[joint] = nkw_box_add_point(&boxes[joint], v->position);
        has_joint = 1;
    }
    if (!has_joint)
        boxes[joint_count] = nkw_box_add_point(&boxes[joint_count], v->position);
}

nkw_result nkw_bounds_from_skin(const nkw_skin *skin, nkw_vec3_stream_view positions, nkw_box *boxes,
                                size_t joint_count)
{
    if (!skin_formats_fit(skin))
        return NKW_BAD_FORMAT;
    const skin_job job = skin_job_of(skin, joint_count);
    const unsigned char *at = (const unsigned char *)positions.data;
    for (size_t j = 0; j <= joint_count; j++)
        boxes[j] = nkw_box_empty();
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

nkw_result nkw_bounds_from_palette(nkw_palette_view palette, const nkw_box *boxes, nkw_box *box)
{
    if (palette.format != NKW_PALETTE_MAT4 && palette.format != NKW_PALETTE_MAT3X4)
        return NKW_BAD_FORMAT;
    nkw_box sum = nkw_box_empty();
    sum = nkw_box_union(&sum, &boxes[palette.joint_count]);
    for (size_t j = 0; j < palette.joint_count; j++) {
        if (nkw_box_is_empty(&boxes[j]))
            continue;
        nkw_mat4 m = matrix_at(palette, j);
        nkw_box moved = nkw_box_transform(&m, &boxes[j]);
        sum = nkw_box_union(&sum, &moved);
    }
    *box = sum;
    return NKW_OK;
}
