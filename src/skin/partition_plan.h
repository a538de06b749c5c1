/* SPDX-License-Identifier: MIT */
/*
 * The plan of a partition: its working memory, which three steps fill one after the other.
 *
 *     triangles --(partition_groups.c)--> groups --(partition_pack.c)--> bins --(partition_write.c)--> parts
 *
 * A group is all triangles of one material and one joint set: what must be in one part anyway. Groups are numbered in
 * the order of their first triangle. A bin is a part before the parts are sorted: at most max_joint_count joints that
 * contain the sets of all its groups. Each step reads only what the steps before it wrote:
 *
 *     triangle t   group_of[t]                          its group, or PARTITION_NONE where its set is too large
 *     group g      set_keys[set_start[g] .. set_start[g + 1] - 1]   its joints
 *                  bin_of[g]                            its bin
 *     bin b        bin_keys[bin_start[b] .. bin_start[b + 1] - 1]   its joints, ascending
 *                  part_of[b]                           its part
 *
 * Sets of joints are short, so they are ascending lists of keys: the depth of the joint in the upper half, the joint in
 * the lower. Parents then precede children in every list, and equal sets are equal words.
 */
#ifndef NAKAWARI_PARTITION_PLAN_H
#define NAKAWARI_PARTITION_PLAN_H

#include "lane/strict.h"

#include <nakawari/partition.h>
#include <nakawari/skin.h>

#define PARTITION_NONE           UINT32_MAX
#define PARTITION_SET            (3 * NKW_SKIN_INFLUENCES) /* joints of a triangle, at most */
#define PARTITION_MOST_TRIANGLES (UINT32_MAX / PARTITION_SET)
#define PARTITION_MOST_JOINTS    65536u /* a joint is the lower half of a key */

/* A set of joints: n ascending keys. */
typedef struct joint_set {
    const uint32_t *keys;
    size_t n;
} joint_set;

static inline uint32_t joint_of_key(uint32_t key)
{
    return key & 0xffffu;
}

/* Inserts into an ascending set, once; returns the new number. */
static inline size_t joint_set_insert(uint32_t *keys, size_t n, uint32_t key)
{
    size_t i = n;
    while (i > 0 && keys[i - 1] > key)
        i--;
    if (i > 0 && keys[i - 1] == key)
        return n;
    for (size_t k = n; k > i; k--)
        keys[k] = keys[k - 1];
    keys[i] = key;
    return n + 1;
}

static inline int joint_set_compare(joint_set a, joint_set b)
{
    size_t n = a.n < b.n ? a.n : b.n;
    for (size_t i = 0; i < n; i++)
        if (a.keys[i] != b.keys[i])
            return a.keys[i] < b.keys[i] ? -1 : 1;
    return a.n == b.n ? 0 : a.n < b.n ? -1 : 1;
}

/* FNV-1a by words, mixed so that the upper bits count. */
static inline uint32_t joint_set_hash(uint32_t material, joint_set set)
{
    uint32_t h = (2166136261u ^ material) * 16777619u;
    for (size_t i = 0; i < set.n; i++)
        h = (h ^ (h >> 15) ^ set.keys[i]) * 16777619u;
    return (h ^ (h >> 16)) * 0x9e3779b1u;
}

/* The arrays are parts of the caller's working memory. */
typedef struct partition_plan {
    const nkw_partition_mesh *mesh;
    size_t max_joint_count;
    uint32_t *group_of; /* for each triangle; PARTITION_NONE for a rejected one */
    uint32_t *table; /* hash table of groups, 2 * triangles */
    uint32_t *set_start; /* for each group and the end: its set in set_keys */
    uint32_t *set_keys;
    uint32_t *first; /* for each group: a triangle of it */
    uint32_t *bin_of; /* for each group; PARTITION_NONE until it is packed */
    uint32_t *ranked; /* the groups in the order of packing: by material, then larger sets first, then by joints */
    uint32_t *missing; /* for each rank: the number of its joints that are not in the open bin */
    uint32_t *touched; /* the ranks that share a joint with the open bin */
    uint32_t *users; /* for each joint, from user_start: the ranks whose sets contain it */
    uint32_t *user_start, *user_count, *in_bin;
    uint32_t *bin_start; /* for each bin and the end: its joints in bin_keys */
    uint32_t *bin_keys;
    uint32_t *bin_material, *bin_order, *part_of;
    uint32_t *seen_in, *local; /* for each vertex: the last part that used it, and its index in that part */
    size_t groups, bins, touched_count;
} partition_plan;

static inline void partition_fill(uint32_t *a, size_t n, uint32_t value)
{
    for (size_t i = 0; i < n; i++)
        a[i] = value;
}

static inline uint32_t partition_material(const nkw_partition_mesh *mesh, size_t triangle)
{
    return mesh->materials ? mesh->materials[triangle] : 0;
}

static inline joint_set partition_group_set(const partition_plan *p, uint32_t group)
{
    joint_set set = {p->set_keys + p->set_start[group], p->set_start[group + 1] - p->set_start[group]};
    return set;
}

/* The steps: group_of and the groups; bin_of and the bins; the parts. */
void nkwi_partition_group(partition_plan *p);
void nkwi_partition_pack(partition_plan *p);
void nkwi_partition_write(partition_plan *p, nkw_partition *out);

#endif
