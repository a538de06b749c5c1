/* SPDX-License-Identifier: MIT */
/* Checks of meshes, corners of the same position, edges of the same ends, equal records. */
#include "mesh_join.h"

#include <string.h>

#include "report.h"
#include "work.h"

/* ---- Checks ---- */

static nkw_result check_corner(const nkw_mesh *mesh, size_t corner)
{
    const size_t v = mesh_vertex(mesh, corner);
    if (v >= mesh->vertex_count)
        return NKW_OUT_OF_RANGE;
    const nkw_vec3 p = mesh->positions[v];
    return lane_is_finite(p.x) && lane_is_finite(p.y) && lane_is_finite(p.z) ? NKW_OK : NKW_NOT_FINITE;
}

nkw_result nkwi_mesh_check(const nkw_mesh *mesh, size_t *bad)
{
    if (mesh->triangle_count > MESH_MOST_TRIANGLES)
        return report(NKW_OUT_OF_RANGE, 0, bad);
    nkw_result result = NKW_OK;
    size_t corner = 0;
    for (; corner < 3 * mesh->triangle_count; corner++)
        if ((result = check_corner(mesh, corner)) != NKW_OK)
            break;
    return report(result, corner / 3, bad);
}

/* ---- Corners of the same position ---- */

static uint32_t hash_position(const void *context, size_t corner)
{
    const nkw_mesh *mesh = context;
    return mesh_mixed(mesh_mix_vec3(0, mesh->positions[mesh_vertex(mesh, corner)]));
}

static int same_position(const void *context, size_t a, size_t b)
{
    const nkw_mesh *mesh = context;
    return mesh_same_vec3(mesh->positions[mesh_vertex(mesh, a)], mesh->positions[mesh_vertex(mesh, b)]);
}

void nkwi_mesh_join_positions(const nkw_mesh *mesh, mesh_join out, uint32_t *table)
{
    mesh_join_equal(out, 3 * mesh->triangle_count, table, hash_position, same_position, mesh);
}

/* ---- Edges of the same ends ---- */

static uint32_t hash_edge(const void *context, size_t corner)
{
    const uint32_t *ids = context, a = ids[corner], b = ids[mesh_after(corner)];
    if (mesh_is_collapsed(ids, corner / 3))
        return mesh_mixed(mesh_mix(1, (uint32_t)corner));
    return mesh_mixed(mesh_mix(mesh_mix(0, a < b ? a : b), a < b ? b : a));
}

static int same_edge(const void *context, size_t a, size_t b)
{
    const uint32_t *ids = context, a0 = ids[a], a1 = ids[mesh_after(a)], b0 = ids[b], b1 = ids[mesh_after(b)];
    if (mesh_is_collapsed(ids, a / 3) || mesh_is_collapsed(ids, b / 3))
        return 0;
    return (a0 == b0 && a1 == b1) || (a0 == b1 && a1 == b0);
}

void nkwi_mesh_join_edges(const uint32_t *ids, size_t n, mesh_join out, uint32_t *table)
{
    mesh_join_equal(out, n, table, hash_edge, same_edge, ids);
}

/* ---- Equal records ---- */

typedef struct mesh_records {
    const unsigned char *data;
    size_t stride;
} mesh_records;

static uint32_t hash_record(const void *context, size_t i)
{
    const mesh_records *records = context;
    const unsigned char *record = records->data + i * records->stride;
    uint32_t hash = 0, word = 0;
    for (size_t k = 0; k < records->stride; k++) {
        word = word << 8 | record[k];
        if (k % 4 == 3)
            hash = mesh_mix(hash, word);
    }
    return mesh_mixed(mesh_mix(hash, word));
}

static int same_record(const void *context, size_t a, size_t b)
{
    const mesh_records *records = context;
    return memcmp(records->data + a * records->stride, records->data + b * records->stride, records->stride) == 0;
}

#define WELD_MOST ((size_t)1 << 30)

nkw_result nkw_mesh_weld(const void *records, size_t count, size_t stride, uint32_t *remap, size_t *distinct,
                         nkw_work work)
{
    if (count > WELD_MOST)
        return NKW_OUT_OF_RANGE;
    if (!work_fits_each(work, count, NKW_MESH_WELD_WORK(1)))
        return NKW_TOO_SMALL;
    const mesh_records all = {(const unsigned char *)records, stride};
    uint32_t *words = (uint32_t *)work.data, values = 0;
    const mesh_join join = {remap, words}; /* then the table of two places for each record */
    mesh_join_equal(join, count, words + count, hash_record, same_record, &all);
    for (size_t i = 0; i < count; i++)
        remap[i] = remap[i] == i ? values++ : remap[remap[i]];
    if (distinct)
        *distinct = values;
    return NKW_OK;
}
