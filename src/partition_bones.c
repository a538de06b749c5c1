/* SPDX-License-Identifier: MIT */
/* Bone-local vertices of a part, and bones by their depth. */
#include "lane/strict.h"

#include <nakawari/mat.h>
#include <nakawari/partition.h>

#include "lane/partition.h"
#include "lane/sort.h"
#include "report.h"


/* ---- Bone-local vertices ---- */

static void put_vec3(float *out, nkw_vec3 v)
{
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

static void put_weights(const nkw_partition *partition, size_t vertex, size_t influences, size_t count, float *out,
                        size_t step)
{
    const float *weights = partition->weights + vertex * influences;
    const uint16_t *slots = partition->slots + vertex * influences;
    for (size_t i = 0; i < influences; i++)
        if (weights[i] != 0.0f && slots[i] < count)
            out[slots[i] * step] += weights[i];
}

static int has_run(size_t first, size_t count, size_t all)
{
    return first <= all && count <= all - first;
}

/* Whether the part's runs lie in the partition, its bones and vertices in the mesh. */
static int is_sound(const nkw_partition_mesh *mesh, const nkw_partition *partition, const nkw_part *part)
{
    int sound = has_run(part->first_bone, part->bone_count, partition->bone_count) &&
                has_run(part->first_vertex, part->vertex_count, partition->vertex_count);
    for (size_t i = 0; sound && i < part->bone_count; i++)
        sound = partition->bones[part->first_bone + i] < mesh->bones;
    for (size_t i = 0; sound && i < part->vertex_count; i++)
        sound = partition->vertices[part->first_vertex + i] < mesh->vertices;
    return sound;
}

void nkw_partition_bone_local(const nkw_partition_mesh *mesh, const nkw_partition *partition, size_t part, size_t slots,
                              const nkw_mat4 *inverse_bind, const nkw_vec3 *positions, const nkw_vec3 *normals,
                              float *out, size_t stride)
{
    size_t step = NKW_BONE_LOCAL_FLOATS(1, normals), floats = slots * step;
    if (slots > stride / step || part >= partition->part_count)
        return;
    const nkw_part *it = &partition->parts[part];
    if (!is_sound(mesh, partition, it))
        return;
    const uint16_t *bones = partition->bones + it->first_bone;
    size_t count = it->bone_count < slots ? it->bone_count : slots;
    for (size_t i = 0; i < it->vertex_count; i++, out += stride) {
        size_t v = partition->vertices[it->first_vertex + i];
        for (size_t c = 0; c < floats; c++)
            out[c] = 0.0f;
        put_weights(partition, it->first_vertex + i, mesh->influences, count, out, step);
        for (size_t s = 0; s < count; s++) {
            const nkw_mat4 *m = &inverse_bind[bones[s]];
            put_vec3(out + s * step + 1, nkw_mat4_transform_point(m, positions[v]));
            if (normals)
                put_vec3(out + s * step + 4, nkw_mat4_transform_direction(m, normals[v]));
        }
    }
}

/* ---- The order of bones ---- */

/*
 * The depths of a bone and of all above it, up to a root or to a bone whose depth is known already (UINT16_MAX is not;
 * a bone that deep is nobody's parent). Gives 0 where there is no end.
 */
static int find_depth(const int32_t *parents, size_t bones, size_t bone, uint16_t *depths)
{
    size_t steps = 0, top = bone;
    for (; parents[top] >= 0 && depths[top] == UINT16_MAX && steps <= bones; steps++)
        top = (size_t)parents[top];
    if (steps > bones)
        return 0;
    size_t depth = steps + (parents[top] < 0 ? 0 : depths[top]);
    for (; bone != top; bone = (size_t)parents[bone])
        depths[bone] = (uint16_t)depth--;
    depths[top] = (uint16_t)depth;
    return 1;
}

static nkw_result find_depths(const int32_t *parents, size_t bones, uint16_t *depths, size_t *bad)
{
    *bad = MOST_BONES;
    if (bones > MOST_BONES)
        return NKW_OUT_OF_RANGE;
    for (*bad = 0; *bad < bones; ++*bad) {
        if (parents[*bad] < -1 || parents[*bad] >= (int32_t)bones)
            return NKW_OUT_OF_RANGE;
        depths[*bad] = UINT16_MAX;
    }
    for (*bad = 0; *bad < bones; ++*bad)
        if (!find_depth(parents, bones, *bad, depths))
            return NKW_NOT_A_TREE;
    *bad = 0;
    return NKW_OK;
}

static int before_bone(const void *context, uint32_t a, uint32_t b)
{
    const uint16_t *depths = context;
    return depths[a] != depths[b] ? depths[a] < depths[b] : a < b;
}

nkw_result nkw_bones_order(const int32_t *parents, size_t bones, uint16_t *depths, uint32_t *order, size_t *bad_bone)
{
    size_t bad;
    nkw_result result = find_depths(parents, bones, depths, &bad);
    if (report(result, bad, bad_bone) != NKW_OK || !order)
        return result;
    for (size_t b = 0; b < bones; b++)
        order[b] = (uint32_t)b;
    lane_sort(order, bones, before_bone, depths);
    return NKW_OK;
}
