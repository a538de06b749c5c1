/* SPDX-License-Identifier: MIT */
/*
 * Groups: the joint set of each triangle, found in a hash table of the sets before.
 *
 * The table has two places for each triangle, so it is at most half full. A place has a group or PARTITION_NONE; a set
 * is at the place of its hash or, where that is taken, at the next free one (linear probing).
 */
#include "partition_plan.h"

static uint32_t key_of(const nkw_partition_mesh *mesh, uint16_t joint)
{
    return mesh->depths ? (uint32_t)mesh->depths[joint] << 16 | joint : joint;
}

static size_t triangle_set(const nkw_partition_mesh *mesh, size_t t, uint32_t keys[PARTITION_SET])
{
    size_t n = 0;
    for (size_t c = 0; c < 3; c++) {
        size_t v = mesh->indices[3 * t + c] * mesh->influence_count;
        for (size_t i = 0; i < mesh->influence_count; i++)
            if (mesh->weights[v + i] != 0.0f)
                n = joint_set_insert(keys, n, key_of(mesh, mesh->joints[v + i]));
    }
    return n;
}

static uint32_t add_group(partition_plan *p, size_t triangle, joint_set set)
{
    uint32_t group = (uint32_t)p->groups++, start = p->set_start[group];
    for (size_t i = 0; i < set.n; i++)
        p->set_keys[start + i] = set.keys[i];
    p->set_start[group + 1] = start + (uint32_t)set.n;
    p->first[group] = (uint32_t)triangle;
    return group;
}

static int is_group(const partition_plan *p, uint32_t group, uint32_t material, joint_set set)
{
    return partition_material(p->mesh, p->first[group]) == material && joint_set_compare(partition_group_set(p, group), set) == 0;
}

static uint32_t find_group(partition_plan *p, size_t triangle, joint_set set)
{
    size_t size = 2 * p->mesh->triangle_count;
    uint32_t material = partition_material(p->mesh, triangle);
    size_t at = (size_t)((uint64_t)joint_set_hash(material, set) * size >> 32);
    while (p->table[at] != PARTITION_NONE && !is_group(p, p->table[at], material, set))
        at = at + 1 < size ? at + 1 : 0;
    if (p->table[at] == PARTITION_NONE)
        p->table[at] = add_group(p, triangle, set);
    return p->table[at];
}

void nkwi_partition_group(partition_plan *p)
{
    const nkw_partition_mesh *mesh = p->mesh;
    partition_fill(p->table, 2 * mesh->triangle_count, PARTITION_NONE);
    p->set_start[0] = 0;
    for (size_t t = 0; t < mesh->triangle_count; t++) {
        uint32_t keys[PARTITION_SET];
        joint_set set = {keys, triangle_set(mesh, t, keys)};
        p->group_of[t] = set.n <= p->max_joint_count ? find_group(p, t, set) : PARTITION_NONE;
    }
}
