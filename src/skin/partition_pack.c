/* SPDX-License-Identifier: MIT */
/*
 * Packing: groups into as few bins as a greedy order finds (bin packing with overlapping items).
 *
 * Of each material the largest set opens a bin. Then, again and again, the set with the fewest missing joints is added,
 * until none fits. Two counts make that fast, and hold between any two steps:
 *
 *     missing[r]    how many joints of the set of rank r are not in the open bin
 *     touched       the ranks not packed yet with missing[r] < the size of their set: those that share a joint
 *
 * A joint that enters the bin decrements missing[r] of its users only: users[user_start[j] ..][user_count[j]] are the
 * ranks whose sets contain joint j. So a step costs what shares a joint with it, not all groups.
 *
 * Between two bins missing[r] is the size of the set for all ranks not packed yet, touched is empty and in_bin is 0.
 *
 * Ranks are groups sorted by material, then from large sets to small ones. Of one material, from..to - 1:
 *
 *     rank            4        5        6      7      8         from = 4, to = 9
 *     set             {0 1 2}  {1 2 3}  {2 3}  {5 6}  {5}
 *     next[3] = 4, next[2] = 6, next[1] = 8, next[0] = 9        the first rank with at most s joints
 *
 * With max_joint_count = 4 a bin is packed in these steps; the joints in brackets enter:
 *
 *     step    packs                    missing of 5 6 7 8    touched    room
 *     1       rank 4 [0 1 2]           1 1 2 1               5 6        1
 *     2       rank 5 [3]               . 0 2 1               6          0
 *     3       rank 6, missing 0        . . 2 1                          0     no set fits: the bin is closed
 *
 * Bins are contiguous in bin_keys. The open bin is the last one, and grows at its end:
 *
 *     bin_keys    | bin 0 | bin 1 | ... | open bin            |  not used yet
 *     bin_start     0       1             bins     bins + 1
 */
#include "partition_plan.h"

#include "sort.h"

/* Nothing here depends on the order of the triangles: two groups of one material have different sets. */
static int before_group(const void *context, uint32_t a, uint32_t b)
{
    const partition_plan *p = context;
    uint32_t x = partition_material(p->mesh, p->first[a]), y = partition_material(p->mesh, p->first[b]);
    if (x != y)
        return x < y;
    joint_set s = partition_group_set(p, a), t = partition_group_set(p, b);
    return s.n != t.n ? s.n > t.n : joint_set_compare(s, t) < 0;
}

static joint_set ranked_set(const partition_plan *p, size_t rank)
{
    return partition_group_set(p, p->ranked[rank]);
}

static int is_packed(const partition_plan *p, size_t rank)
{
    return p->bin_of[p->ranked[rank]] != PARTITION_NONE;
}

/*
 * Lists for each joint the ranks of from..to - 1 whose sets contain it, by a counting sort: counts, starts, entries.
 * Only joints of these sets are written, so many materials do not cost materials * joints.
 *
 *     users    | ranks with joint 2 | ranks with joint 0 | ...        lists in the order in which joints are met
 *
 * In the last loop PARTITION_NONE marks a joint that is not met yet; its list then begins at the end of the others.
 */
static void list_users(partition_plan *p, size_t from, size_t to)
{
    uint32_t start = 0;
    for (size_t r = from; r < to; r++)
        for (size_t i = 0; i < ranked_set(p, r).n; i++)
            p->user_count[joint_of_key(ranked_set(p, r).keys[i])] = 0;
    for (size_t r = from; r < to; r++)
        for (size_t i = 0; i < ranked_set(p, r).n; i++)
            p->user_count[joint_of_key(ranked_set(p, r).keys[i])]++;
    for (size_t r = from; r < to; r++)
        for (size_t i = 0; i < ranked_set(p, r).n; i++)
            p->user_start[joint_of_key(ranked_set(p, r).keys[i])] = PARTITION_NONE;
    for (size_t r = from; r < to; r++)
        for (size_t i = 0; i < ranked_set(p, r).n; i++) {
            uint32_t joint = joint_of_key(ranked_set(p, r).keys[i]);
            if (p->user_start[joint] == PARTITION_NONE) {
                p->user_start[joint] = start;
                start += p->user_count[joint];
                p->user_count[joint] = 0;
            }
            p->users[p->user_start[joint] + p->user_count[joint]++] = (uint32_t)r;
        }
}

/*
 * Adds a joint to the open bin and decrements `missing` of its users. Packed users are removed from the list, by the
 * last one in their place: no bin asks for them again. A rank is touched when its first joint enters.
 */
static void enter_joint(partition_plan *p, uint32_t key)
{
    uint32_t joint = joint_of_key(key), *users = p->users + p->user_start[joint];
    p->in_bin[joint] = 1;
    p->bin_keys[p->bin_start[p->bins + 1]++] = key;
    for (size_t i = 0; i < p->user_count[joint];) {
        uint32_t r = users[i];
        if (is_packed(p, r)) {
            users[i] = users[--p->user_count[joint]];
            continue;
        }
        if (p->missing[r] == ranked_set(p, r).n)
            p->touched[p->touched_count++] = r;
        p->missing[r]--;
        i++;
    }
}

static void pack_group(partition_plan *p, size_t rank)
{
    joint_set set = ranked_set(p, rank);
    p->bin_of[p->ranked[rank]] = (uint32_t)p->bins;
    for (size_t i = 0; i < set.n; i++)
        if (!p->in_bin[joint_of_key(set.keys[i])])
            enter_joint(p, set.keys[i]);
}

/* How many joints the open bin can still take. */
static size_t room(const partition_plan *p)
{
    return p->max_joint_count - (p->bin_start[p->bins + 1] - p->bin_start[p->bins]);
}

/*
 * Packs the touched groups whose joints are all in the open bin. Of the others that fit, returns the one with the
 * fewest missing joints, of these the first by rank, so the largest; PARTITION_NONE if none fits.
 */
static uint32_t best_touched(partition_plan *p)
{
    uint32_t best = PARTITION_NONE;
    size_t kept = 0;
    for (size_t i = 0; i < p->touched_count; i++) {
        uint32_t r = p->touched[i];
        if (p->missing[r] == 0)
            p->bin_of[p->ranked[r]] = (uint32_t)p->bins;
        if (is_packed(p, r))
            continue;
        p->touched[kept++] = r;
        if (p->missing[r] > room(p))
            continue;
        if (best == PARTITION_NONE || p->missing[r] < p->missing[best] ||
            (p->missing[r] == p->missing[best] && r < best))
            best = r;
    }
    p->touched_count = kept;
    return best;
}

/*
 * The largest unpacked set of at most `most` joints. next[s]: no unpacked rank of at most s joints is before it. A
 * packed rank remains packed, so next[s] only ascends, and all calls together take to - from steps for each s.
 */
static uint32_t largest_left(const partition_plan *p, size_t next[PARTITION_SET + 1], size_t most, size_t to)
{
    size_t s = most < PARTITION_SET ? most : PARTITION_SET;
    while (next[s] < to && is_packed(p, next[s]))
        next[s]++;
    return next[s] < to ? (uint32_t)next[s] : PARTITION_NONE;
}

/* Restores what holds between two bins, at the cost of this bin only; its keys then ascend. */
static void close_bin(partition_plan *p, uint32_t material)
{
    uint32_t *keys = p->bin_keys + p->bin_start[p->bins];
    size_t n = p->bin_start[p->bins + 1] - p->bin_start[p->bins];
    for (size_t i = 0; i < n; i++)
        p->in_bin[joint_of_key(keys[i])] = 0;
    for (size_t i = 0; i < p->touched_count; i++)
        p->missing[p->touched[i]] = (uint32_t)ranked_set(p, p->touched[i]).n;
    p->touched_count = 0;
    sort_indices(keys, n, sort_before_number, NULL);
    p->bin_material[p->bins++] = material;
}

/* Packs the groups of one material: ranks from..to - 1. */
static void pack_material(partition_plan *p, size_t from, size_t to, uint32_t material)
{
    size_t next[PARTITION_SET + 1];
    for (size_t s = PARTITION_SET + 1, r = from; s-- > 0; next[s] = r)
        while (r < to && ranked_set(p, r).n > s)
            r++;
    list_users(p, from, to);
    for (uint32_t r = largest_left(p, next, PARTITION_SET, to); r != PARTITION_NONE;
         r = largest_left(p, next, PARTITION_SET, to)) {
        p->bin_start[p->bins + 1] = p->bin_start[p->bins];
        while (r != PARTITION_NONE) {
            pack_group(p, r);
            r = best_touched(p);
            /* Sets that share no joint with the bin fill what is left: fewer bins. */
            if (r == PARTITION_NONE)
                r = largest_left(p, next, room(p), to);
        }
        close_bin(p, material);
    }
}

void nkwi_partition_pack(partition_plan *p)
{
    for (size_t g = 0; g < p->groups; g++)
        p->ranked[g] = (uint32_t)g;
    sort_indices(p->ranked, p->groups, before_group, p);
    for (size_t r = 0; r < p->groups; r++)
        p->missing[r] = (uint32_t)ranked_set(p, r).n;
    partition_fill(p->bin_of, p->groups, PARTITION_NONE);
    partition_fill(p->in_bin, p->mesh->joint_count, 0);
    p->bin_start[0] = 0;
    for (size_t from = 0, to; from < p->groups; from = to) {
        uint32_t material = partition_material(p->mesh, p->first[p->ranked[from]]);
        for (to = from; to < p->groups && partition_material(p->mesh, p->first[p->ranked[to]]) == material;)
            to++;
        pack_material(p, from, to, material);
    }
}
