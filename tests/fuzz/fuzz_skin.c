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

static nkw_skin draw_skin(fuzz *f)
{
    nkw_skin s = {fuzz_upto(f, VERTICES), fuzz_upto(f, MOST), {NULL, 0, NKW_SKIN_U8}, {NULL, 0, NKW_SKIN_U8}};
    s.joints = draw_view(f, s.vertices, s.influences, draw_format(f));
    s.weights = draw_view(f, s.vertices, s.influences, draw_format(f));
    return s;
}

static nkw_vec3_stream draw_stream(fuzz *f, size_t n)
{
    size_t stride = 12 + fuzz_upto(f, 60);
    nkw_vec3_stream s = {draw_bytes(f, n, 12, stride, 1), stride};
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

/* The stream in component arrays, and room for the result. */
static void to_arrays(fuzz *f, const nkw_vec3_stream *s, size_t n, nkw_vec3_view *in, nkw_vec3_span *out)
{
    float *v = fuzz_room(f, 3 * n), *o = fuzz_room(f, 3 * n), at[3];
    nkw_vec3_view view = {v, v + n, v + 2 * n}, no_view = {NULL, NULL, NULL};
    nkw_vec3_span span = {o, o + n, o + 2 * n};
    for (size_t i = 0; s->data && i < n; i++) {
        read_vertex(s->data, s->stride, i, at);
        v[i] = at[0], v[n + i] = at[1], v[2 * n + i] = at[2];
    }
    *in = s->data ? view : no_view;
    *out = span;
}

static void same(const nkw_vec3_stream_span *s, const nkw_vec3_view *in, const nkw_vec3_span *out, size_t n)
{
    for (size_t i = 0; s->data && in->x && i < n; i++) {
        float got[3], want[3] = {out->x[i], out->y[i], out->z[i]};
        read_vertex(s->data, s->stride, i, got);
        FUZZ_CHECK(fuzz_same(got, want, 3));
    }
    check_gaps(s, n);
}

/* Streams and arrays give the same bits, by matrices and by dual quaternions. */
static void skin(fuzz *f, const nkw_skin *s, int is_dual)
{
    size_t n = s->vertices, joints = fuzz_upto(f, JOINTS);
    nkw_vertices in = {draw_stream(f, n), draw_stream(f, n), draw_stream(f, n), draw_stream(f, n)};
    nkw_vertices_span out = {room_for(f, n), room_for(f, n), room_for(f, n), room_for(f, n)};
    nkw_vertices_arrays a;
    nkw_vertices_arrays_span o;
    to_arrays(f, &in.positions, n, &a.positions, &o.positions);
    to_arrays(f, &in.normals, n, &a.normals, &o.normals);
    to_arrays(f, &in.tangents, n, &a.tangents, &o.tangents);
    to_arrays(f, &in.bitangents, n, &a.bitangents, &o.bitangents);
    if (is_dual) {
        const nkw_dual_quat *palette = (const nkw_dual_quat *)(const void *)fuzz_floats(f, 8 * joints, 1);
        nkw_skin_dual_quat(s, palette, joints, &in, &out);
        nkw_skin_dual_quat_arrays(s, palette, joints, &a, &o);
    } else {
        const nkw_mat3 *normals = (const nkw_mat3 *)(const void *)fuzz_floats(f, 9 * joints, 1);
        nkw_skin_palette p = {fuzz_matrices(f, joints, 1), fuzz_byte(f) % 4 ? NULL : normals, joints, fuzz_byte(f) % 2};
        nkw_skin_linear(s, &p, &in, &out);
        nkw_skin_linear_arrays(s, &p, &a, &o);
    }
    same(&out.positions, &a.positions, &o.positions, n);
    same(&out.normals, &a.normals, &o.normals, n);
    same(&out.tangents, &a.tangents, &o.tangents, n);
    same(&out.bitangents, &a.bitangents, &o.bitangents, n);
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
    nkw_skin_span joints = draw_span(f, s->vertices, keep), weights = draw_span(f, s->vertices, keep);
    nkw_result result = nkw_skin_validate(s, JOINTS, &bad);
    FUZZ_CHECK(bad < s->vertices || bad == 0);
    nkw_skin_span even = draw_span(f, s->vertices, s->influences);
    nkw_skin_normalize_weights(s->weights, s->influences, even, s->vertices);
    nkw_skin_prune(s, keep, joints, weights);
    nkw_skin pruned = {
        s->vertices, keep, {joints.data, joints.stride, joints.format}, {weights.data, weights.stride, weights.format}};
    nkw_result shape = nkw_skin_validate(&pruned, SIZE_MAX, NULL);
    int was_pruned = keep >= 1 && keep <= 8 && s->influences >= 1 && s->influences <= 8 && s->vertices > 0 &&
                     result != NKW_BAD_METHOD && shape != NKW_BAD_METHOD;
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
