/* SPDX-License-Identifier: MIT */
#include "fuzz.h"

#include <nakawari/nakawari.h>

#include <string.h>

enum { TRIANGLES = 60, VERTICES = 40 };

/* Vertices at few places, so that triangles are degenerate and share positions. */
static nkw_mesh draw_mesh(fuzz *f, int wild)
{
    nkw_mesh m = {NULL, 1 + fuzz_upto(f, VERTICES - 1), NULL, fuzz_upto(f, TRIANGLES)};
    float *positions = fuzz_floats(f, 3 * m.vertex_count, wild);
    const int few = fuzz_byte(f) % 2;
    for (size_t i = 0; few && i < 3 * m.vertex_count; i++)
        if (positions[i] > -4.0f && positions[i] < 4.0f)
            positions[i] = (float)(int)(positions[i] / 2.0f);
    m.positions = (const nkw_vec3 *)positions;
    if (fuzz_byte(f) % 4 == 0) {
        m.triangle_count = m.vertex_count / 3 + (size_t)(wild && fuzz_byte(f) % 4 == 0);
        return m;
    }
    uint32_t *indices = fuzz_bytes(f, 12 * m.triangle_count);
    for (size_t i = 0; i < 3 * m.triangle_count; i++)
        indices[i] = wild && i % 64 == 63 ? indices[i] : indices[i] % (uint32_t)m.vertex_count;
    m.indices = indices;
    return m;
}

/* The first triangle with a fault, and the fault, by plain means. */
static nkw_result fault_of(const nkw_mesh *m, size_t *bad)
{
    for (size_t c = 0; c < 3 * m->triangle_count; c++) {
        const size_t v = m->indices ? m->indices[c] : c;
        *bad = c / 3;
        if (v >= m->vertex_count)
            return NKW_OUT_OF_RANGE;
        if (!fuzz_finite(&m->positions[v].x, 3))
            return NKW_NOT_FINITE;
    }
    *bad = 0;
    return NKW_OK;
}

/* Each normal is zero or unit. */
static void normals(fuzz *f, const nkw_mesh *m, nkw_work work)
{
    size_t bad = 99, want_bad;
    const nkw_result want = fault_of(m, &want_bad);
    const float crease = fuzz_byte(f) % 4 ? (float)fuzz_upto(f, 400) / 100.0f : fuzz_float(f);
    nkw_vec3 *out = (nkw_vec3 *)(void *)fuzz_room(f, 9 * m->triangle_count);
    const nkw_result result = nkw_mesh_normals(m, crease, out, &bad, work);
    if (!(crease >= 0.0f)) {
        FUZZ_CHECK(result == NKW_OUT_OF_RANGE && bad == 0);
        return;
    }
    FUZZ_CHECK(result == want && bad == want_bad);
    for (size_t c = 0; result == NKW_OK && c < 3 * m->triangle_count; c++) {
        const float length = nkw_vec3_length(out[c]);
        FUZZ_CHECK(length == 0.0f || (length > 0.999999f && length < 1.000001f));
    }
}

/* Each tangent is zero or unit, each sign 1 or -1; bitangents follow. */
static void tangents(fuzz *f, const nkw_mesh *m, nkw_work work, int wild)
{
    size_t bad = 99, want_bad;
    float *uv = fuzz_floats(f, 2 * m->vertex_count, wild);
    const nkw_mesh_surface surface = {(const nkw_vec3 *)(void *)fuzz_floats(f, 3 * m->vertex_count, wild), uv};
    const int few = fuzz_byte(f) % 2;
    for (size_t i = 0; few && i < 2 * m->vertex_count; i++)
        if (uv[i] > -4.0f && uv[i] < 4.0f)
            uv[i] = (float)(int)(uv[i] / 2.0f);
    float *out = fuzz_room(f, 12 * m->triangle_count);
    nkw_vec3 *bitangents = (nkw_vec3 *)(void *)fuzz_room(f, 9 * m->triangle_count);
    const nkw_result want = fault_of(m, &want_bad);
    const nkw_result result = nkw_mesh_tangents(m, surface, out, bitangents, &bad, work);
    FUZZ_CHECK(want == NKW_OK ? result == NKW_OK || result == NKW_NOT_FINITE : result == want && bad == want_bad);
    for (size_t c = 0; result == NKW_OK && c < 3 * m->triangle_count; c++) {
        const nkw_vec3 t = {out[4 * c], out[4 * c + 1], out[4 * c + 2]};
        const float length = nkw_vec3_length(t);
        FUZZ_CHECK(length == 0.0f || (length > 0.999999f && length < 1.000001f));
        FUZZ_CHECK(out[4 * c + 3] == 1.0f || out[4 * c + 3] == -1.0f);
        FUZZ_CHECK(nkw_vec3_length(bitangents[c]) < 1.000001f);
    }
}

/* Triangles keep their first vertex; what is settled stays. */
static void facing(fuzz *f, const nkw_mesh *m, nkw_work work)
{
    size_t bad = 99, want_bad, turned = 0;
    const nkw_result want = fault_of(m, &want_bad);
    uint32_t *out = fuzz_block(f, 12 * m->triangle_count);
    nkw_mesh_facing found, again;
    FUZZ_CHECK(nkw_mesh_fix_facing(m, out, &found, &bad, work) == want && bad == want_bad);
    if (want != NKW_OK)
        return;
    for (size_t c = 0; c < 3 * m->triangle_count; c += 3) {
        const uint32_t a = m->indices ? m->indices[c] : (uint32_t)c, b = m->indices ? m->indices[c + 1] : a + 1,
                       d = m->indices ? m->indices[c + 2] : a + 2;
        FUZZ_CHECK(out[c] == a && ((out[c + 1] == b && out[c + 2] == d) || (out[c + 1] == d && out[c + 2] == b)));
        turned += out[c + 1] != b || out[c + 2] != d;
    }
    FUZZ_CHECK(found.turned_count >= turned && found.closed_count <= found.piece_count);
    FUZZ_CHECK(found.piece_count <= m->triangle_count);
    nkw_mesh settled = *m;
    settled.indices = out;
    FUZZ_CHECK(nkw_mesh_fix_facing(&settled, out, &again, NULL, work) == NKW_OK);
    FUZZ_CHECK(again.piece_count == found.piece_count && again.closed_count == found.closed_count);
    FUZZ_CHECK(again.branch_count == found.branch_count && again.conflict_count == found.conflict_count);
    FUZZ_CHECK(found.conflict_count || again.turned_count == 0);
}

/* Equal numbers are equal records, and numbers ascend. */
static void weld(fuzz *f)
{
    const size_t count = fuzz_upto(f, 100), stride = fuzz_upto(f, 5);
    const unsigned char *records = fuzz_bytes(f, count * stride);
    uint32_t *remap = fuzz_block(f, 4 * count), next = 0;
    size_t distinct = 99;
    const nkw_work work = fuzz_work(f, NKW_MESH_WELD_WORK(count));
    FUZZ_CHECK(nkw_mesh_weld(records, count, stride, remap, &distinct, work) == NKW_OK);
    for (size_t i = 0; i < count; i++) {
        size_t j = 0;
        while (remap[j] != remap[i])
            j++;
        FUZZ_CHECK(memcmp(records + i * stride, records + j * stride, stride) == 0);
        FUZZ_CHECK(j < i || remap[i] == next++);
    }
    FUZZ_CHECK(distinct == next);
    const size_t huge = fuzz_huge(f);
    const nkw_work none = {NULL, 0};
    FUZZ_CHECK((nkw_mesh_weld(records, huge, stride, remap, NULL, none) == NKW_OK) == (huge == 0));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    const int wild = fuzz_byte(&f) % 2;
    const nkw_mesh m = draw_mesh(&f, wild);
    const nkw_work work = fuzz_work(&f, NKW_MESH_WORK(m.triangle_count));
    normals(&f, &m, work);
    facing(&f, &m, work);
    tangents(&f, &m, work, wild);
    weld(&f);
    return fuzz_end(&f);
}
