/* SPDX-License-Identifier: MIT */
#include "write_valid.h"

#include <math.h>
#include <string.h>

#include <nakawari/vec.h>

int nkwi_valid_applies(const nkw_document *document)
{
    return strcmp(document->format, "glTF 2.0") != 0;
}

/* ---- weights ---- */

/* Adds the weights of equal joints to the first of them. The others become 0, of joint 0. */
static void join_equal(uint16_t *joints, float *weights, size_t width)
{
    for (size_t i = 0; i < width; i++) {
        weights[i] = isfinite(weights[i]) && weights[i] > 0.0f ? weights[i] : 0.0f;
        for (size_t k = 0; k < i && weights[i] > 0.0f; k++)
            if (joints[k] == joints[i] && weights[k] > 0.0f) {
                weights[k] += weights[i];
                weights[i] = 0.0f;
            }
        joints[i] = weights[i] > 0.0f ? joints[i] : 0;
    }
}

/* w / sum in binary64, rounded; then the largest takes what is missing to 1. */
static void scale_to_one(float *weights, size_t width)
{
    double sum = 0.0, rounded = 0.0;
    size_t most = 0;
    for (size_t i = 0; i < width; i++) {
        sum += (double)weights[i];
        most = weights[i] > weights[most] ? i : most;
    }
    if (!(sum > 0.0))
        return;
    for (size_t i = 0; i < width; i++) {
        weights[i] = (float)((double)weights[i] / sum);
        rounded += (double)weights[i];
    }
    weights[most] = (float)((double)weights[most] + (1.0 - rounded));
}

void nkwi_valid_influences(const nkw_document_primitive *p, uint16_t *joints, float *weights)
{
    const size_t width = p->influence_count, count = p->vertex_count * width;
    if (count == 0)
        return;
    memcpy(joints, p->joints, count * sizeof *joints);
    memcpy(weights, p->weights, count * sizeof *weights);
    for (size_t v = 0; v < p->vertex_count; v++) {
        join_equal(joints + v * width, weights + v * width, width);
        scale_to_one(weights + v * width, width);
    }
}

/* ---- unit vectors ---- */

/* In binary64, so that no component is lost and none is infinite; 0 0 0 of a vector that has no direction. */
static nkw_vec3 unit_of(const double *v)
{
    const double most = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
    const nkw_vec3 none = {0.0f, 0.0f, 0.0f};
    if (!(most > 0.0) || !isfinite(v[0]) || !isfinite(v[1]) || !isfinite(v[2]))
        return none;
    const double x = v[0] / most, y = v[1] / most, z = v[2] / most, length = sqrt(x * x + y * y + z * z);
    const nkw_vec3 unit = {(float)(x / length), (float)(y / length), (float)(z / length)};
    return unit;
}

void nkwi_valid_units(const float *from, size_t width, const nkw_vec3 *other, size_t vertex_count, float *out)
{
    for (size_t v = 0; v < vertex_count; v++) {
        const float *at = from + v * width;
        const double vector[3] = {(double)at[0], (double)at[1], (double)at[2]};
        nkw_vec3 unit = unit_of(vector);
        if (unit.x == 0.0f && unit.y == 0.0f && unit.z == 0.0f)
            unit = other[v];
        memcpy(out + v * width, &unit, sizeof unit);
        if (width == 4)
            out[v * width + 3] = at[3] < 0.0f ? -1.0f : 1.0f;
    }
}

void nkwi_valid_faces(const nkw_document_primitive *p, nkw_vec3 *out)
{
    memset(out, 0, p->vertex_count * sizeof *out);
    for (size_t i = 0; p->topology == NKW_DOCUMENT_TRIANGLES && i + 2 < p->index_count; i += 3) {
        const uint32_t *corner = p->indices + i;
        const nkw_vec3 a = p->positions[corner[0]];
        const nkw_vec3 area =
            nkw_vec3_cross(nkw_vec3_sub(p->positions[corner[1]], a), nkw_vec3_sub(p->positions[corner[2]], a));
        for (int k = 0; k < 3; k++)
            out[corner[k]] = nkw_vec3_add(out[corner[k]], area);
    }
    for (size_t v = 0; v < p->vertex_count; v++) {
        const double sum[3] = {(double)out[v].x, (double)out[v].y, (double)out[v].z};
        out[v] = unit_of(sum);
        if (out[v].x == 0.0f && out[v].y == 0.0f && out[v].z == 0.0f)
            out[v].z = 1.0f;
    }
}

int nkwi_valid_colors(const float *from, size_t count, float *out)
{
    for (size_t i = 0; i < count; i++)
        out[i] = from[i] < 0.0f ? 0.0f : from[i] <= 1.0f ? from[i] : 1.0f;
    return memcmp(from, out, count * sizeof *out) != 0;
}

/* ---- matrices ---- */

nkw_mat4 nkwi_valid_matrix(const nkw_mat4 *m)
{
    const float last = m->m[15], most = 1e-4f * fabsf(last);
    nkw_mat4 out = *m;
    if (!(fabsf(m->m[3]) <= most && fabsf(m->m[7]) <= most && fabsf(m->m[11]) <= most && last != 0.0f))
        return out;
    for (int i = 0; i < 16; i++)
        out.m[i] = fabsf(last - 1.0f) > 1e-4f ? m->m[i] / last : m->m[i];
    out.m[3] = out.m[7] = out.m[11] = 0.0f;
    out.m[15] = 1.0f;
    return out;
}
