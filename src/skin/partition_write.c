/* SPDX-License-Identifier: MIT */
/*
 * The parts: bins sorted by material, then by joints; their triangles in the order of the mesh; their vertices.
 *
 * Invariant: parts are ranges, one after the other without a gap, of joints, triangles and vertices alike.
 *
 *     triangle t -> group_of -> bin_of -> part_of -> part k          part_of is the inverse of bin_order
 *
 *     joints       | part 0       | part 1       | ...               first_joint, joint_count
 *     triangles    | part 0       | part 1       | ... | rejected    first_triangle, triangle_count
 *     vertices     | part 0       | part 1       | ...               first_vertex, vertex_count
 *     indices      three for each entry of `triangles`, counted from first_vertex of its part
 *
 * A vertex that three parts use is in `vertices` three times, each time with the slots of that part.
 */
#include "partition_plan.h"

#include "sort.h"

static joint_set bin_set(const partition_plan *p, uint32_t bin)
{
    joint_set set = {p->bin_keys + p->bin_start[bin], p->bin_start[bin + 1] - p->bin_start[bin]};
    return set;
}

static int before_bin(const void *context, uint32_t a, uint32_t b)
{
    const partition_plan *p = context;
    if (p->bin_material[a] != p->bin_material[b])
        return p->bin_material[a] < p->bin_material[b];
    return joint_set_compare(bin_set(p, a), bin_set(p, b)) < 0;
}

static void write_joints(partition_plan *p, nkw_partition *out)
{
    for (size_t b = 0; b < p->bins; b++)
        p->bin_order[b] = (uint32_t)b;
    sort_indices(p->bin_order, p->bins, before_bin, p);
    for (size_t k = 0; k < p->bins; k++) {
        joint_set set = bin_set(p, p->bin_order[k]);
        nkw_part part = {p->bin_material[p->bin_order[k]], 0, 0, (uint32_t)out->joint_count, (uint32_t)set.n, 0, 0};
        out->parts[k] = part;
        for (size_t i = 0; i < set.n; i++)
            out->joints[out->joint_count++] = (uint16_t)joint_of_key(set.keys[i]);
        p->part_of[p->bin_order[k]] = (uint32_t)k;
    }
    out->part_count = p->bins;
}

/*
 * Stable counting sort of the triangles by part; the rejected ones are last. After the first loop triangle_count is the
 * size of each part; from the second loop on it counts again, as the index of the part's next free place.
 */
static void write_triangles(partition_plan *p, nkw_partition *out)
{
    size_t n = p->mesh->triangle_count;
    for (size_t t = 0; t < n; t++)
        if (p->group_of[t] != PARTITION_NONE)
            out->parts[p->part_of[p->bin_of[p->group_of[t]]]].triangle_count++;
    for (size_t k = 0; k < out->part_count; k++) {
        out->parts[k].first_triangle = (uint32_t)out->triangle_count;
        out->triangle_count += out->parts[k].triangle_count;
        out->parts[k].triangle_count = 0;
    }
    for (size_t t = 0; t < n; t++) {
        nkw_part *part = p->group_of[t] != PARTITION_NONE ? &out->parts[p->part_of[p->bin_of[p->group_of[t]]]] : NULL;
        size_t at = part ? part->first_triangle + part->triangle_count++ : out->triangle_count + out->rejected_count++;
        out->triangles[at] = (uint32_t)t;
    }
}

/* Appends vertex v of the mesh to the partition; here in_bin contains the slot of each joint. */
static void write_vertex(const partition_plan *p, nkw_partition *out, size_t v)
{
    size_t n = p->mesh->influence_count, at = out->vertex_count++;
    out->vertices[at] = (uint32_t)v;
    for (size_t i = 0; i < n; i++) {
        float w = p->mesh->weights[v * n + i];
        out->weights[at * n + i] = w;
        out->joint_slots[at * n + i] = w != 0.0f ? (uint16_t)p->in_bin[p->mesh->joints[v * n + i]] : 0;
    }
}

/*
 * The vertices of part k, in the order of first use. Parts ascend, so a vertex was met in this part where
 * seen_in[v] == k, and neither seen_in nor local is cleared between parts.
 *
 *     mesh vertices of its corners    7 3 9    3 9 4      at = 3 first_triangle ...
 *     indices                         0 1 2    1 2 3      local[v]
 */
static void write_part(partition_plan *p, nkw_partition *out, uint32_t k)
{
    nkw_part *part = &out->parts[k];
    part->first_vertex = (uint32_t)out->vertex_count;
    for (uint32_t i = 0; i < part->joint_count; i++)
        p->in_bin[out->joints[part->first_joint + i]] = i;
    for (size_t i = 0; i < 3 * (size_t)part->triangle_count; i++) {
        size_t at = 3 * (size_t)part->first_triangle + i;
        uint32_t v = p->mesh->indices[3 * (size_t)out->triangles[at / 3] + at % 3];
        if (p->seen_in[v] != k) {
            p->seen_in[v] = k;
            p->local[v] = part->vertex_count++;
            write_vertex(p, out, v);
        }
        out->indices[at] = p->local[v];
    }
}

void nkwi_partition_write(partition_plan *p, nkw_partition *out)
{
    write_joints(p, out);
    write_triangles(p, out);
    partition_fill(p->seen_in, p->mesh->vertex_count, PARTITION_NONE);
    for (size_t k = 0; k < out->part_count; k++)
        write_part(p, out, (uint32_t)k);
}
