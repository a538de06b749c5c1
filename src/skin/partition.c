/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/partition.h>
#include <nakawari/skin.h>

#include "lane/scalar.h"
#include "report.h"
#include "sort.h"

#define PARTITION_NONE           UINT32_MAX
#define PARTITION_SET            (3 * NKW_SKIN_INFLUENCES) /* joints of a triangle, at most */
#define PARTITION_MOST_TRIANGLES (UINT32_MAX / PARTITION_SET)
#define PARTITION_MOST_JOINTS    65536u /* a joint is the lower half of a key */

/* ---- Small sets of joints ---- */

/* A set of joints: ascending keys, depth in the upper and joint in the lower half. */
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

/* ---- Validation ---- */

static int counts_are_in_range(const nkw_partition_mesh *mesh)
{
    return mesh->influence_count >= 1 && mesh->influence_count <= NKW_SKIN_INFLUENCES &&
           mesh->joint_count <= PARTITION_MOST_JOINTS && mesh->triangle_count <= PARTITION_MOST_TRIANGLES &&
           mesh->vertex_count < UINT32_MAX;
}

static nkw_result check_influence(const nkw_partition_mesh *mesh, size_t i)
{
    float w = mesh->weights[i];
    if (!lane_is_finite(w))
        return NKW_NOT_FINITE;
    if (w < 0.0f)
        return NKW_BAD_WEIGHTS;
    return w == 0.0f || mesh->joints[i] < mesh->joint_count ? NKW_OK : NKW_OUT_OF_RANGE;
}

static nkw_result check_triangle(const nkw_partition_mesh *mesh, size_t t)
{
    nkw_result result = NKW_OK;
    for (size_t c = 0; result == NKW_OK && c < 3; c++) {
        size_t v = mesh->indices[3 * t + c];
        if (v >= mesh->vertex_count)
            return NKW_OUT_OF_RANGE;
        for (size_t i = 0; result == NKW_OK && i < mesh->influence_count; i++)
            result = check_influence(mesh, v * mesh->influence_count + i);
    }
    return result;
}

nkw_result nkw_partition_validate(const nkw_partition_mesh *mesh, size_t *bad_triangle)
{
    nkw_result result = counts_are_in_range(mesh) ? NKW_OK : NKW_OUT_OF_RANGE;
    size_t bad = 0;
    for (size_t t = 0; result == NKW_OK && t < mesh->triangle_count; t++) {
        result = check_triangle(mesh, t);
        bad = t;
    }
    return report(result, bad, bad_triangle);
}

/* ---- Working memory ---- */

/*
 * A group is all triangles of one material and one joint set. Groups are numbered in the order of their first triangle;
 * `ranked` sorts them by material, then by the size of the set, descending, then by joints. This is the order of
 * packing. A bin is a part before the parts are sorted.
 */
typedef struct plan {
    const nkw_partition_mesh *mesh;
    size_t max_joint_count;
    uint32_t *group_of; /* for each triangle; PARTITION_NONE for a rejected one */
    uint32_t *table; /* hash table of groups, 2 * triangles */
    uint32_t *set_start; /* for each group and the end: its set in set_keys */
    uint32_t *set_keys;
    uint32_t *first; /* for each group: a triangle of it */
    uint32_t *bin_of; /* for each group; PARTITION_NONE until it is packed */
    uint32_t *ranked; /* for each rank: the group */
    uint32_t *missing; /* for each rank: the number of its joints that are not in the open bin */
    uint32_t *touched; /* the ranks that share a joint with the open bin */
    uint32_t *users; /* for each joint, from user_start: the ranks whose sets contain it */
    uint32_t *user_start, *user_count, *in_bin;
    uint32_t *bin_start; /* for each bin and the end: its joints in bin_keys */
    uint32_t *bin_keys;
    uint32_t *bin_material, *bin_order, *part_of;
    uint32_t *seen_in, *local; /* for each vertex: the last part that used it, and its index in that part */
    size_t groups, bins, touched_count;
} plan;

static size_t set_limit(const nkw_partition_mesh *mesh, size_t max_joint_count)
{
    size_t most = 3 * (mesh->influence_count < NKW_SKIN_INFLUENCES ? mesh->influence_count : NKW_SKIN_INFLUENCES);
    return max_joint_count < most ? max_joint_count : most;
}

static size_t saturated(uint64_t n)
{
    return n > SIZE_MAX ? SIZE_MAX : (size_t)n;
}

/* Returns the next n words of the block, NULL without a block; adds n to *used. */
static uint32_t *carve(uint32_t *block, uint64_t *used, uint64_t n)
{
    uint32_t *words = block ? block + *used : NULL;
    *used += n;
    return words;
}

/* Divides the block into the arrays of the plan. Returns their size in words; block may be NULL. */
static uint64_t lay_out(plan *p, const nkw_partition_mesh *mesh, size_t max_joint_count, uint32_t *block)
{
    uint64_t t = mesh->triangle_count, sets = t * set_limit(mesh, max_joint_count), used = 0;
    p->mesh = mesh;
    p->max_joint_count = max_joint_count;
    p->group_of = carve(block, &used, t);
    p->table = carve(block, &used, 2 * t);
    p->set_start = carve(block, &used, t + 1);
    p->set_keys = carve(block, &used, sets);
    p->first = carve(block, &used, t);
    p->bin_of = carve(block, &used, t);
    p->ranked = carve(block, &used, t);
    p->missing = carve(block, &used, t);
    p->touched = carve(block, &used, t);
    p->users = carve(block, &used, sets);
    p->user_start = carve(block, &used, mesh->joint_count);
    p->user_count = carve(block, &used, mesh->joint_count);
    p->in_bin = carve(block, &used, mesh->joint_count);
    p->bin_start = carve(block, &used, t + 1);
    p->bin_keys = carve(block, &used, sets);
    p->bin_material = carve(block, &used, t);
    p->bin_order = carve(block, &used, t);
    p->part_of = carve(block, &used, t);
    p->seen_in = carve(block, &used, mesh->vertex_count);
    p->local = carve(block, &used, mesh->vertex_count);
    return used;
}

nkw_partition_sizes nkw_partition_bounds(const nkw_partition_mesh *mesh, size_t max_joint_count)
{
    nkw_partition_sizes sizes = {0, 0, 0, 0};
    if (!counts_are_in_range(mesh))
        return sizes;
    plan p;
    uint64_t t = mesh->triangle_count;
    sizes.part_count = saturated(t);
    sizes.joint_count = saturated(t * set_limit(mesh, max_joint_count));
    sizes.vertex_count = saturated(3 * t);
    sizes.work_count = saturated(lay_out(&p, mesh, max_joint_count, NULL));
    return sizes;
}

static void fill(uint32_t *a, size_t n, uint32_t value)
{
    for (size_t i = 0; i < n; i++)
        a[i] = value;
}

/* ---- Groups ---- */

static uint32_t key_of(const nkw_partition_mesh *mesh, uint16_t joint)
{
    return mesh->depths ? (uint32_t)mesh->depths[joint] << 16 | joint : joint;
}

static uint32_t material_of(const nkw_partition_mesh *mesh, size_t triangle)
{
    return mesh->materials ? mesh->materials[triangle] : 0;
}

static joint_set group_set(const plan *p, uint32_t group)
{
    joint_set set = {p->set_keys + p->set_start[group], p->set_start[group + 1] - p->set_start[group]};
    return set;
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

static uint32_t add_group(plan *p, size_t triangle, joint_set set)
{
    uint32_t group = (uint32_t)p->groups++, start = p->set_start[group];
    for (size_t i = 0; i < set.n; i++)
        p->set_keys[start + i] = set.keys[i];
    p->set_start[group + 1] = start + (uint32_t)set.n;
    p->first[group] = (uint32_t)triangle;
    return group;
}

static int is_group(const plan *p, uint32_t group, uint32_t material, joint_set set)
{
    return material_of(p->mesh, p->first[group]) == material && joint_set_compare(group_set(p, group), set) == 0;
}

static uint32_t find_group(plan *p, size_t triangle, joint_set set)
{
    size_t size = 2 * p->mesh->triangle_count;
    uint32_t material = material_of(p->mesh, triangle);
    size_t at = (size_t)((uint64_t)joint_set_hash(material, set) * size >> 32);
    while (p->table[at] != PARTITION_NONE && !is_group(p, p->table[at], material, set))
        at = at + 1 < size ? at + 1 : 0;
    if (p->table[at] == PARTITION_NONE)
        p->table[at] = add_group(p, triangle, set);
    return p->table[at];
}

static void find_groups(plan *p)
{
    const nkw_partition_mesh *mesh = p->mesh;
    fill(p->table, 2 * mesh->triangle_count, PARTITION_NONE);
    p->set_start[0] = 0;
    for (size_t t = 0; t < mesh->triangle_count; t++) {
        uint32_t keys[PARTITION_SET];
        joint_set set = {keys, triangle_set(mesh, t, keys)};
        p->group_of[t] = set.n <= p->max_joint_count ? find_group(p, t, set) : PARTITION_NONE;
    }
}

static int before_group(const void *context, uint32_t a, uint32_t b)
{
    const plan *p = context;
    uint32_t x = material_of(p->mesh, p->first[a]), y = material_of(p->mesh, p->first[b]);
    if (x != y)
        return x < y;
    joint_set s = group_set(p, a), t = group_set(p, b);
    return s.n != t.n ? s.n > t.n : joint_set_compare(s, t) < 0;
}

/* ---- Packing ---- */

static joint_set ranked_set(const plan *p, size_t rank)
{
    return group_set(p, p->ranked[rank]);
}

static int is_packed(const plan *p, size_t rank)
{
    return p->bin_of[p->ranked[rank]] != PARTITION_NONE;
}

/* Lists for each joint the ranks of from..to - 1 whose sets contain it: counts, starts, entries. */
static void list_users(plan *p, size_t from, size_t to)
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

/* Adds a joint to the open bin and decrements `missing` of its users. Packed users are removed from the list. */
static void enter_joint(plan *p, uint32_t key)
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

static void pack_group(plan *p, size_t rank)
{
    joint_set set = ranked_set(p, rank);
    p->bin_of[p->ranked[rank]] = (uint32_t)p->bins;
    for (size_t i = 0; i < set.n; i++)
        if (!p->in_bin[joint_of_key(set.keys[i])])
            enter_joint(p, set.keys[i]);
}

static size_t room(const plan *p)
{
    return p->max_joint_count - (p->bin_start[p->bins + 1] - p->bin_start[p->bins]);
}

/*
 * Packs the touched groups whose joints are all in the open bin. Of the others that fit, returns the one with the
 * fewest missing joints, of these the first by rank, so the largest; PARTITION_NONE if none fits.
 */
static uint32_t best_touched(plan *p)
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

/* The largest unpacked set of at most `most` joints. next[s]: no unpacked rank of at most s joints is before it. */
static uint32_t largest_left(const plan *p, size_t next[PARTITION_SET + 1], size_t most, size_t to)
{
    size_t s = most < PARTITION_SET ? most : PARTITION_SET;
    while (next[s] < to && is_packed(p, next[s]))
        next[s]++;
    return next[s] < to ? (uint32_t)next[s] : PARTITION_NONE;
}

static void close_bin(plan *p, uint32_t material)
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
static void pack_material(plan *p, size_t from, size_t to, uint32_t material)
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
            if (r == PARTITION_NONE)
                r = largest_left(p, next, room(p), to);
        }
        close_bin(p, material);
    }
}

static void pack_groups(plan *p)
{
    for (size_t g = 0; g < p->groups; g++)
        p->ranked[g] = (uint32_t)g;
    sort_indices(p->ranked, p->groups, before_group, p);
    for (size_t r = 0; r < p->groups; r++)
        p->missing[r] = (uint32_t)ranked_set(p, r).n;
    fill(p->bin_of, p->groups, PARTITION_NONE);
    fill(p->in_bin, p->mesh->joint_count, 0);
    p->bin_start[0] = 0;
    for (size_t from = 0, to; from < p->groups; from = to) {
        uint32_t material = material_of(p->mesh, p->first[p->ranked[from]]);
        for (to = from; to < p->groups && material_of(p->mesh, p->first[p->ranked[to]]) == material;)
            to++;
        pack_material(p, from, to, material);
    }
}

/* ---- Writing the parts ---- */

static joint_set bin_set(const plan *p, uint32_t bin)
{
    joint_set set = {p->bin_keys + p->bin_start[bin], p->bin_start[bin + 1] - p->bin_start[bin]};
    return set;
}

static int before_bin(const void *context, uint32_t a, uint32_t b)
{
    const plan *p = context;
    if (p->bin_material[a] != p->bin_material[b])
        return p->bin_material[a] < p->bin_material[b];
    return joint_set_compare(bin_set(p, a), bin_set(p, b)) < 0;
}

static void write_joints(plan *p, nkw_partition *out)
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

/* Stable counting sort of the triangles by part; the rejected ones are last. */
static void write_triangles(plan *p, nkw_partition *out)
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
static void write_vertex(const plan *p, nkw_partition *out, size_t v)
{
    size_t n = p->mesh->influence_count, at = out->vertex_count++;
    out->vertices[at] = (uint32_t)v;
    for (size_t i = 0; i < n; i++) {
        float w = p->mesh->weights[v * n + i];
        out->weights[at * n + i] = w;
        out->joint_slots[at * n + i] = w != 0.0f ? (uint16_t)p->in_bin[p->mesh->joints[v * n + i]] : 0;
    }
}

static void write_part(plan *p, nkw_partition *out, uint32_t k)
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

nkw_result nkw_partition_build(const nkw_partition_mesh *mesh, size_t max_joint_count, nkw_partition *out,
                               size_t *bad_triangle, uint32_t *work, size_t work_count)
{
    out->part_count = out->joint_count = out->triangle_count = out->vertex_count = out->rejected_count = 0;
    nkw_result result = nkw_partition_validate(mesh, bad_triangle);
    if (result == NKW_OK && work_count < nkw_partition_bounds(mesh, max_joint_count).work_count)
        result = NKW_TOO_SMALL;
    if (result != NKW_OK || mesh->triangle_count == 0)
        return result;
    plan p = {0};
    lay_out(&p, mesh, max_joint_count, work);
    find_groups(&p);
    pack_groups(&p);
    write_joints(&p, out);
    write_triangles(&p, out);
    fill(p.seen_in, mesh->vertex_count, PARTITION_NONE);
    for (size_t k = 0; k < out->part_count; k++)
        write_part(&p, out, (uint32_t)k);
    if (out->rejected_count == 0)
        return NKW_OK;
    return report(NKW_TOO_MANY, out->triangles[out->triangle_count], bad_triangle);
}
