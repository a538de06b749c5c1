/* SPDX-License-Identifier: MIT */
/* Floor 6: what cutting a mesh works with: small sets of joints. */
#ifndef NAKAWARI_LANE_PARTITION_H
#define NAKAWARI_LANE_PARTITION_H

#include "strict.h"

#include <stddef.h>
#include <stdint.h>

#define MOST_JOINTS 65536u /* a joint is the lower half of a key */

/* A set of joints: ascending keys, depth in the upper and joint in the lower half. */
typedef struct lane_set {
    const uint32_t *keys;
    size_t n;
} lane_set;

static inline uint32_t lane_joint_of(uint32_t key)
{
    return key & 0xffffu;
}

/* Inserts into an ascending set, once; gives the new number. */
static inline size_t lane_set_insert(uint32_t *keys, size_t n, uint32_t key)
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

static inline int lane_set_compare(lane_set a, lane_set b)
{
    size_t n = a.n < b.n ? a.n : b.n;
    for (size_t i = 0; i < n; i++)
        if (a.keys[i] != b.keys[i])
            return a.keys[i] < b.keys[i] ? -1 : 1;
    return a.n == b.n ? 0 : a.n < b.n ? -1 : 1;
}

/* FNV-1a by words, mixed so that the upper bits count. */
static inline uint32_t lane_set_hash(uint32_t material, lane_set set)
{
    uint32_t h = (2166136261u ^ material) * 16777619u;
    for (size_t i = 0; i < set.n; i++)
        h = (h ^ (h >> 15) ^ set.keys[i]) * 16777619u;
    return (h ^ (h >> 16)) * 0x9e3779b1u;
}

#endif
