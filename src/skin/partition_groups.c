/* SPDX-License-Identifier: MIT */
/*
 * Groups: the joint set of each triangle, found in a hash table of the sets before.
 *
 * Invariant: two triangles have the same group where their materials and their sets are equal, and nowhere else.
 *
 *     triangle    0        1        2        3             weights that are not 0 belong to
 *     set         {0 1}    {1 2}    {0 1}    {0 1 2 3}     max_joint_count = 3
 *     group_of    0        1        0        NONE          a set of more joints is rejected
 *
 *     group       0    1    end
 *     set_start   0    2    4          offsets in set_keys
 *     set_keys    0 1  1 2             keys: depth << 16 | joint; here all depths are 0
 *     first       0    1               the triangle by which the material is found
 *
 *     table       NONE 1 NONE NONE 0 NONE NONE NONE        2 places for each triangle: at most half full
 *
 * A group is at the place of its hash or, where that is taken, at the next free one, the first place after the last
 * (linear probing). A search therefore ends at the set or at PARTITION_NONE.
 */
#include "partition_plan.h"

/* Keys ascend by depth, then by joint: the order of the joints in a part. */
static uint32_t key_of(const nkw_partition_mesh *mesh, uint16_t joint)
{
    return mesh->depths ? (uint32_t)mesh->depths[joint] << 16 | joint : joint;
}

/* Writes the keys of the joints that have weight at the three vertices. Returns their number. */
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
    return partition_material(p->mesh, p->first[group]) == material &&
           joint_set_compare(partition_group_set(p, group), set) == 0;
}

static uint32_t find_group(partition_plan *p, size_t triangle, joint_set set)
{
    size_t size = 2 * p->mesh->triangle_count;
    uint32_t material = partition_material(p->mesh, triangle);
    /* hash 2^-32 size: from 0 to size - 1, by the upper bits of the hash, without a division. */
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
