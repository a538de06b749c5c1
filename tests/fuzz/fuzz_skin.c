/* SPDX-License-Identifier: MIT */
/* Any formats, strides and alignments; arrays end where the last number does. */
#include "fuzz.h"

#include <string.h>

enum { VERTICES = 150, JOINTS = 20, MOST = 12 };

static size_t size_of(nkw_skin_format format)
{
    return format == NKW_SKIN_U8 ? 1 : format == NKW_SKIN_U16 ? 2 : 4;
}

static nkw_skin_format draw_format(fuzz *f)
{
    return (nkw_skin_format)fuzz_choice(f, 3);
}

/* `width` bytes for each of n vertices: what the last one has ends with the block. Gives the first byte. */
static unsigned char *draw_bytes(fuzz *f, size_t n, size_t width, size_t stride, int is_float)
{
    size_t odd = fuzz_byte(f) % 4, bytes = n ? (n - 1) * stride + width : 0;
    unsigned char *v = fuzz_bytes(f, bytes + odd);
    const float *values = is_float ? fuzz_floats(f, n * (width / 4), fuzz_byte(f) % 2) : NULL;
    for (size_t i = 0; values && i < n; i++)
        memcpy(v + odd + i * stride, values + i * (width / 4), width);
    return v + odd;
}

static nkw_skin_view draw_view(fuzz *f, size_t n, size_t influences, nkw_skin_format format)
{
    size_t width = influences * size_of(format), stride = fuzz_byte(f) % 2 ? width : 1 + fuzz_upto(f, 70);
    nkw_skin_view v = {draw_bytes(f, n, width, stride, format == NKW_SKIN_F32), stride, format};
    if (stride == width && fuzz_byte(f) % 2)
        v.stride = 0;
    return v;
}

/* Joints of n vertices; most of those that are floats are whole numbers, as any floats rarely are. */
static nkw_skin_view draw_joints(fuzz *f, size_t n, size_t influences)
{
    const nkw_skin_format format = draw_format(f);
    const size_t size = size_of(format), width = influences * size;
    if (format != NKW_SKIN_F32)
        return draw_view(f, n, influences, format);
    const size_t stride = fuzz_byte(f) % 2 ? width : 1 + fuzz_upto(f, 70);
    unsigned char *bytes = draw_bytes(f, n, width, stride, 1);
    for (size_t i = 0; i < n * influences; i++) {
        const uint8_t drawn = fuzz_byte(f);
        const float joint = (float)(drawn % (JOINTS + 2));
        if (drawn < 200)
            memcpy(bytes + i / influences * stride + i % influences * size, &joint, sizeof joint);
    }
    return (nkw_skin_view){bytes, stride, format};
}

static nkw_skin draw_skin(fuzz *f)
{
    nkw_skin s = {fuzz_upto(f, VERTICES), fuzz_upto(f, MOST), {NULL, 0, NKW_SKIN_U8}, {NULL, 0, NKW_SKIN_U8}};
    s.joints = draw_joints(f, s.vertex_count, s.influence_count);
    s.weights = draw_view(f, s.vertex_count, s.influence_count, draw_format(f));
    return s;
}

static nkw_vec3_stream_view draw_stream(fuzz *f, size_t n)
{
    size_t stride = 12 + fuzz_upto(f, 60);
    nkw_vec3_stream_view s = {draw_bytes(f, n, 12, stride, 1), stride};
    if (fuzz_byte(f) % 4 == 0)
        s.data = NULL;
    return s;
}

static nkw_vec3_stream_span room_for(fuzz *f, size_t n)
{
    size_t stride = 12 + fuzz_upto(f, 60), odd = fuzz_byte(f) % 4;
    nkw_vec3_stream_span s = {(unsigned char *)fuzz_block(f, (n ? (n - 1) * stride + 12 : 0) + odd) + odd, stride};
    if (fuzz_byte(f) % 8 == 0)
        s.data = NULL;
    return s;
}

static void read_vertex(const void *data, size_t stride, size_t i, float v[3])
{
    memcpy(v, (const unsigned char *)data + i * stride, 3 * sizeof *v);
}

/* What lies between the vectors is as it was. */
static void check_gaps(const nkw_vec3_stream_span *s, size_t n)
{
    const unsigned char *p = s->data;
    for (size_t i = 0; p && i + 1 < n; i++)
        for (size_t b = 12; b < s->stride; b++)
            FUZZ_CHECK(p[i * s->stride + b] == 0xa5);
}

/* Vector i of a stream, copied to v. */
static nkw_vec3_stream_view one_of(const nkw_vec3_stream_view *s, size_t i, float v[3])
{
    nkw_vec3_stream_view r = {v, 0}, none = {NULL, 0};
    if (!s->data)
        return none;
    read_vertex(s->data, s->stride, i, v);
    return r;
}

static void same(const nkw_vec3_stream_span *all, size_t i, const nkw_vec3_stream_span *one)
{
    float got[3], want[3];
    if (!all->data || !one->data)
        return;
    read_vertex(all->data, all->stride, i, got);
    read_vertex(one->data, 0, 0, want);
    FUZZ_CHECK(fuzz_same(got, want, 3));
}

static nkw_skin_view influences_of(const nkw_skin_view *v, size_t influence_count, size_t i)
{
    size_t stride = v->stride ? v->stride : influence_count * size_of(v->format);
    nkw_skin_view r = {(const unsigned char *)v->data + i * stride, 0, v->format};
    return r;
}

typedef struct palettes {
    nkw_skin_palette linear;
    nkw_palette_view dual;
} palettes;

static nkw_skin_options draw_options(fuzz *f)
{
    const uint8_t bits = fuzz_byte(f);
    return (nkw_skin_options){bits & 1, bits >> 1 & 1, bits >> 2 & 1};
}

static palettes draw_palettes(fuzz *f)
{
    size_t joint_count = fuzz_upto(f, JOINTS), normal_count = fuzz_upto(f, JOINTS);
    const float *normals = fuzz_floats(f, 9 * normal_count, 1);
    palettes p = {{{fuzz_matrices(f, joint_count, 1), joint_count, NKW_PALETTE_MAT4},
                   {fuzz_byte(f) % 4 ? NULL : normals, normal_count, NKW_PALETTE_NORMAL_MAT3},
                   draw_options(f)},
                  {fuzz_floats(f, 8 * joint_count, 1), joint_count, NKW_PALETTE_DUAL_QUAT}};
    return p;
}

static void run(const nkw_skin *s, const palettes *p, int is_dual, const nkw_vertices_view *in,
                const nkw_vertices_span *out)
{
    if (is_dual)
        nkw_skin_dual_quat(s, p->dual, *in, *out);
    else
        nkw_skin_linear(s, &p->linear, *in, *out);
}

/* All vertices together and one by one have the same bits, by matrices and by dual quaternions. */
static void skin(fuzz *f, const nkw_skin *s, int is_dual)
{
    size_t n = s->vertex_count;
    palettes p = draw_palettes(f);
    nkw_vertices_view in = {draw_stream(f, n), draw_stream(f, n), draw_stream(f, n), draw_stream(f, n)};
    nkw_vertices_span out = {room_for(f, n), room_for(f, n), room_for(f, n), room_for(f, n)};
    run(s, &p, is_dual, &in, &out);
    for (size_t i = 0; i < n; i++) {
        nkw_skin one = {1, s->influence_count, influences_of(&s->joints, s->influence_count, i),
                        influences_of(&s->weights, s->influence_count, i)};
        float v[4][3];
        nkw_vertices_view from = {one_of(&in.positions, i, v[0]), one_of(&in.normals, i, v[1]),
                                  one_of(&in.tangents, i, v[2]), one_of(&in.bitangents, i, v[3])};
        nkw_vertices_span to = {{v[0], 0}, {v[1], 0}, {v[2], 0}, {v[3], 0}};
        run(&one, &p, is_dual, &from, &to);
        if (in.positions.data)
            same(&out.positions, i, &to.positions);
        if (in.normals.data)
            same(&out.normals, i, &to.normals);
        if (in.tangents.data)
            same(&out.tangents, i, &to.tangents);
        if (in.bitangents.data)
            same(&out.bitangents, i, &to.bitangents);
    }
    check_gaps(&out.positions, n);
    check_gaps(&out.normals, n);
    check_gaps(&out.tangents, n);
    check_gaps(&out.bitangents, n);
}

static nkw_skin_span draw_span(fuzz *f, size_t n, size_t influences)
{
    nkw_skin_format format = draw_format(f);
    size_t width = influences * size_of(format), stride = width + fuzz_upto(f, 9);
    nkw_skin_span s = {fuzz_block(f, n ? (n - 1) * stride + width : 0), stride, format};
    return s;
}

/* Normalised weights are sound, or there was nothing to normalise. */
static void prepare(fuzz *f, const nkw_skin *s)
{
    size_t keep = fuzz_upto(f, MOST), bad;
    nkw_skin_span joints = draw_span(f, s->vertex_count, keep), weights = draw_span(f, s->vertex_count, keep);
    nkw_result result = nkw_skin_validate(s, JOINTS, &bad);
    FUZZ_CHECK(bad < s->vertex_count || bad == 0);
    nkw_skin_span even = draw_span(f, s->vertex_count, s->influence_count);
    nkw_skin_normalize_weights(s->weights, s->influence_count, s->vertex_count, even);
    nkw_skin_prune(s, keep, joints, weights);
    nkw_skin pruned = {s->vertex_count,
                       keep,
                       {joints.data, joints.stride, joints.format},
                       {weights.data, weights.stride, weights.format}};
    nkw_result shape = nkw_skin_validate(&pruned, SIZE_MAX, NULL);
    int was_pruned = keep >= 1 && keep <= 8 && s->influence_count >= 1 && s->influence_count <= 8 &&
                     s->vertex_count > 0 && result != NKW_BAD_FORMAT && shape != NKW_BAD_FORMAT;
    FUZZ_CHECK(!was_pruned || shape == NKW_OK);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    nkw_skin s = draw_skin(&f);
    prepare(&f, &s);
    skin(&f, &s, 0);
    skin(&f, &s, 1);
    return fuzz_end(&f);
}
