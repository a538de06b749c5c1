/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/morph.h>
#include <nakawari/vec.h>

#include "batch/morph.h"
#include "lane/morph.h"
#include "report.h"
#include "sizes.h"
#include "skin_job.h"

/* The same vector of all vertices: where it is read and written. */
typedef struct morph_stream {
    const unsigned char *in;
    unsigned char *out;
    size_t in_stride, out_stride;
} morph_stream;

/* The differences of this vector of a target. */
typedef struct morph_deltas {
    const unsigned char *data;
    size_t stride;
} morph_deltas;

static morph_deltas deltas_of(const nkw_morph_target *target, size_t stream)
{
    const nkw_vec3_stream_view *v = skin_in(&target->deltas, stream);
    morph_deltas d = {(const unsigned char *)v->data, skin_vector_stride(v->stride)};
    return d;
}

static nkw_vec3 read_vec3(const unsigned char *p)
{
    nkw_vec3 v;
    memcpy(&v, p, sizeof v);
    return v;
}

/* Adds a difference to a vector. */
static void add_one(unsigned char *to, float weight, const unsigned char *delta)
{
    nkw_vec3 v = read_vec3(to), d = read_vec3(delta);
    nkw_vec3 r = {lane_morph(v.x, weight, d.x), lane_morph(v.y, weight, d.y), lane_morph(v.z, weight, d.z)};
    memcpy(to, &r, sizeof r);
}

static int is_contiguous(const void *data, size_t stride)
{
    return stride == sizeof(nkw_vec3) && (uintptr_t)data % sizeof(float) == 0;
}

static void add_dense(const morph_stream *s, morph_deltas d, float weight, size_t from, size_t to)
{
    if (is_contiguous(s->out, s->out_stride) && is_contiguous(d.data, d.stride)) {
        nkwi_morph_add((const float *)(const void *)d.data + 3 * from, weight, (float *)(void *)s->out + 3 * from,
                       3 * (to - from));
        return;
    }
    for (size_t i = from; i < to; i++)
        add_one(s->out + i * s->out_stride, weight, d.data + i * d.stride);
}

static void add_sparse(const morph_stream *s, const nkw_morph_target *target, morph_deltas d, float weight,
                       size_t vertex_count)
{
    for (size_t k = 0; k < target->count; k++)
        if (target->indices[k] < vertex_count)
            add_one(s->out + target->indices[k] * s->out_stride, weight, d.data + k * d.stride);
}

static void copy(const morph_stream *s, size_t from, size_t to)
{
    if (s->in == s->out && s->in_stride == s->out_stride)
        return;
    for (size_t i = from; i < to; i++)
        memcpy(s->out + i * s->out_stride, s->in + i * s->in_stride, sizeof(nkw_vec3));
}

/* The end of the targets from `first` on that are dense, or have no effect. */
static size_t dense_end(const nkw_morph *m, const float *weights, size_t first)
{
    while (first < m->target_count && (!m->targets[first].indices || weights[first] == 0.0f))
        first++;
    return first;
}

/* The dense targets first .. end - 1, for blocks of vertices that stay in a near cache. */
static void run_dense(const nkw_morph *m, const float *weights, const morph_stream *s, size_t stream, nkw_range targets)
{
    for (size_t from = 0; from < m->vertex_count; from += MORPH_BLOCK) {
        size_t rest = m->vertex_count - from, to = from + (rest < MORPH_BLOCK ? rest : MORPH_BLOCK);
        if (targets.from == 0)
            copy(s, from, to);
        for (size_t t = targets.from; t < targets.to; t++) {
            morph_deltas d = deltas_of(&m->targets[t], stream);
            if (weights[t] != 0.0f && d.data)
                add_dense(s, d, weights[t], from, to);
        }
    }
}

static void run_stream(const nkw_morph *m, const float *weights, const morph_stream *s, size_t stream)
{
    size_t t = 0;
    do {
        nkw_range dense = {t, dense_end(m, weights, t)};
        run_dense(m, weights, s, stream, dense);
        for (t = dense.to; t < m->target_count && m->targets[t].indices; t++) {
            morph_deltas d = deltas_of(&m->targets[t], stream);
            if (weights[t] != 0.0f && d.data)
                add_sparse(s, &m->targets[t], d, weights[t], m->vertex_count);
        }
    } while (t < m->target_count);
}

void nkw_morph_apply(const nkw_morph *morph, const float *weights, nkw_vertices_view in, nkw_vertices_span out)
{
    for (size_t stream = 0; stream < SKIN_STREAMS; stream++) {
        const nkw_vec3_stream_view *from = skin_in(&in, stream);
        const nkw_vec3_stream_span *to = skin_out(&out, stream);
        morph_stream s = {(const unsigned char *)from->data, (unsigned char *)to->data,
                          skin_vector_stride(from->stride), skin_vector_stride(to->stride)};
        if (s.in && s.out)
            run_stream(morph, weights, &s, stream);
    }
}

static int deltas_are_finite(const nkw_morph *m, const nkw_morph_target *target)
{
    size_t count = target->indices ? target->count : m->vertex_count;
    for (size_t stream = 0; stream < SKIN_STREAMS; stream++) {
        morph_deltas d = deltas_of(target, stream);
        for (size_t k = 0; d.data && k < count; k++)
            if (!nkw_vec3_is_finite(read_vec3(d.data + k * d.stride)))
                return 0;
    }
    return 1;
}

static nkw_result check_target(const nkw_morph *m, const nkw_morph_target *target)
{
    for (size_t k = 0; target->indices && k < target->count; k++)
        if (target->indices[k] >= m->vertex_count)
            return NKW_OUT_OF_RANGE;
    return deltas_are_finite(m, target) ? NKW_OK : NKW_NOT_FINITE;
}

nkw_result nkw_morph_validate(const nkw_morph *morph, size_t *bad)
{
    nkw_result result = morph->vertex_count == 0 ? NKW_EMPTY : NKW_OK;
    size_t t = 0;
    for (; result == NKW_OK && t < morph->target_count; t++)
        result = check_target(morph, &morph->targets[t]);
    return report(result, t ? t - 1 : 0, bad);
}
