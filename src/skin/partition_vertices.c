/* SPDX-License-Identifier: MIT */
/*
 * The vertices of a part in the spaces of its joints.
 *
 * Invariant: slot s of a vertex belongs to joint s of the part. Positions and normals have no weight in them, so
 * a shader computes sum over s of weight(s) model(joint s) (x y z 1).
 *
 *     float    0  1 2 3  4 5 6      7  8 9 10  11 12 13          ...   stride
 *              w  x y z  nx ny nz   w  x y z   nx ny nz   0 0 0         of the caller, not written
 *              |---- slot 0 -----|  |----- slot 1 ------|  slots after the part's joints
 *
 *     x y z       inverse_bind[joint] (p, 1), in the unit of the mesh
 *     nx ny nz    inverse_bind[joint] (n, 0); without normals a slot has the 4 floats w x y z
 *     w           the sum of the weights by which the vertex names this joint; 0 if it names it nowhere
 */
#include "lane/strict.h"

#include <nakawari/mat.h>
#include <nakawari/partition.h>

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

nkw_result nkw_partition_vertices(const nkw_partition *partition, size_t part, const nkw_partition_source *source,
                                  size_t slot_count, float *out, size_t stride)
{
    const nkw_partition_mesh *mesh = source->mesh;
    const size_t step = NKW_PARTITION_FLOATS(1, source->normals), floats = slot_count * step;
    if (slot_count > stride / step)
        return NKW_TOO_SMALL;
    if (part >= partition->part_count || !is_sound(mesh, partition, &partition->parts[part]))
        return NKW_OUT_OF_RANGE;
    const nkw_part *it = &partition->parts[part];
    const uint16_t *joints = partition->joints + it->first_joint;
    const size_t count = it->joint_count < slot_count ? it->joint_count : slot_count;
    for (size_t i = 0; i < it->vertex_count; i++, out += stride) {
        const size_t v = partition->vertices[it->first_vertex + i];
        for (size_t c = 0; c < floats; c++)
            out[c] = 0.0f;
        put_weights(partition, it->first_vertex + i, mesh->influence_count, count, out, step);
        for (size_t s = 0; s < count; s++) {
            const nkw_mat4 *m = &source->inverse_bind[joints[s]];
            put_vec3(out + s * step + 1, nkw_mat4_transform_point(m, source->positions[v]));
            if (source->normals)
                put_vec3(out + s * step + 4, nkw_mat4_transform_direction(m, source->normals[v]));
        }
    }
    return NKW_OK;
}
