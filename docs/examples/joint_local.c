/* SPDX-License-Identifier: MIT */
#include "joint_local.h"

#include <nakawari/mat.h>

/* The most joints: depths are numbers of 16 bits. */
#define MOST_JOINTS 65536u

/* ---- Joint-local vertices ---- */

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
    const uint16_t *slots = partition->joint_slots + vertex * influences;
    for (size_t i = 0; i < influences; i++)
        if (weights[i] != 0.0f && slots[i] < count)
            out[slots[i] * step] += weights[i];
}

static int has_run(size_t first, size_t count, size_t all)
{
    return first <= all && count <= all - first;
}

/* Whether the part's runs lie in the partition, its joints and vertices in the mesh. */
static int is_sound(const nkw_partition_mesh *mesh, const nkw_partition *partition, const nkw_part *part)
{
    int sound = has_run(part->first_joint, part->joint_count, partition->joint_count) &&
                has_run(part->first_vertex, part->vertex_count, partition->vertex_count);
    for (size_t i = 0; sound && i < part->joint_count; i++)
        sound = partition->joints[part->first_joint + i] < mesh->joint_count;
    for (size_t i = 0; sound && i < part->vertex_count; i++)
        sound = partition->vertices[part->first_vertex + i] < mesh->vertex_count;
    return sound;
}

void joint_local_vertices(const nkw_partition_mesh *mesh, const nkw_partition *partition, size_t part, size_t slots,
                          const nkw_mat4 *inverse_bind, const nkw_vec3 *positions, const nkw_vec3 *normals, float *out,
                          size_t stride)
{
    size_t step = JOINT_LOCAL_FLOATS(1, normals), floats = slots * step;
    if (slots > stride / step || part >= partition->part_count)
        return;
    const nkw_part *it = &partition->parts[part];
    if (!is_sound(mesh, partition, it))
        return;
    const uint16_t *joints = partition->joints + it->first_joint;
    size_t count = it->joint_count < slots ? it->joint_count : slots;
    for (size_t i = 0; i < it->vertex_count; i++, out += stride) {
        size_t v = partition->vertices[it->first_vertex + i];
        for (size_t c = 0; c < floats; c++)
            out[c] = 0.0f;
        put_weights(partition, it->first_vertex + i, mesh->influence_count, count, out, step);
        for (size_t s = 0; s < count; s++) {
            const nkw_mat4 *m = &inverse_bind[joints[s]];
            put_vec3(out + s * step + 1, nkw_mat4_transform_point(m, positions[v]));
            if (normals)
                put_vec3(out + s * step + 4, nkw_mat4_transform_direction(m, normals[v]));
        }
    }
}

/* ---- The order of joints ---- */

/*
 * The depths of a joint and of all above it, up to a root or to a joint whose depth is known already (UINT16_MAX is
 * not; a joint at that depth is no parent). Returns 0 where there is no end.
 */
static int find_depth(const int32_t *parents, size_t joint_count, size_t joint, uint16_t *depths)
{
    size_t steps = 0, top = joint;
    for (; parents[top] >= 0 && depths[top] == UINT16_MAX && steps <= joint_count; steps++)
        top = (size_t)parents[top];
    if (steps > joint_count)
        return 0;
    size_t depth = steps + (parents[top] < 0 ? 0 : depths[top]);
    for (; joint != top; joint = (size_t)parents[joint])
        depths[joint] = (uint16_t)depth--;
    depths[top] = (uint16_t)depth;
    return 1;
}

static nkw_result find_depths(const int32_t *parents, size_t joint_count, uint16_t *depths, size_t *bad)
{
    *bad = MOST_JOINTS;
    if (joint_count > MOST_JOINTS)
        return NKW_OUT_OF_RANGE;
    for (*bad = 0; *bad < joint_count; ++*bad) {
        if (parents[*bad] < -1 || parents[*bad] >= (int32_t)joint_count)
            return NKW_OUT_OF_RANGE;
        depths[*bad] = UINT16_MAX;
    }
    for (*bad = 0; *bad < joint_count; ++*bad)
        if (!find_depth(parents, joint_count, *bad, depths))
            return NKW_NOT_A_TREE;
    *bad = 0;
    return NKW_OK;
}

/* Level by level, each ascending by index. */
static void sort_by_depth(const uint16_t *depths, size_t joint_count, uint32_t *order)
{
    size_t placed = 0;
    for (unsigned depth = 0; placed < joint_count; depth++)
        for (size_t j = 0; j < joint_count; j++)
            if (depths[j] == depth)
                order[placed++] = (uint32_t)j;
}

nkw_result joints_by_depth(const int32_t *parents, size_t joint_count, uint16_t *depths, uint32_t *order,
                           size_t *bad_joint)
{
    size_t bad;
    nkw_result result = find_depths(parents, joint_count, depths, &bad);
    if (bad_joint)
        *bad_joint = bad;
    if (result == NKW_OK && order)
        sort_by_depth(depths, joint_count, order);
    return result;
}
