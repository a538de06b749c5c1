/* SPDX-License-Identifier: MIT */
/*
 * Meshes cut into parts of few joints: the checks, the working memory (partition_plan.h), and the three steps.
 *
 * Invariant: a checked mesh has T triangles, whose sets have at most K joints each, K = set_limit. Every array of the
 * plan is as long as its index can grow in the worst case, so the three steps do not check lengths.
 *
 *     T groups     each triangle alone in its group
 *     T bins       each group alone in its bin
 *     T K keys     of all groups together, as of all bins: a bin has at most the joints of its groups together
 *
 * The working memory, in words of 4 bytes; J joints, V vertices of the mesh:
 *
 *     step      arrays, in words                                                            sum
 *     groups    group_of T, table 2T, set_start T + 1, set_keys T K, first T                (5 + K) T + 1
 *     bins      bin_of T, ranked T, missing T, touched T, users T K, user_start J,          (6 + 2K) T + 3J + 1
 *               user_count J, in_bin J, bin_start T + 1, bin_keys T K, bin_material T
 *     parts     bin_order T, part_of T, seen_in V, local V                                  2T + 2V
 */
#include "lane/strict.h"

#include <nakawari/partition.h>
#include <nakawari/skin.h>

#include "lane/scalar.h"
#include "partition_plan.h"
#include "report.h"
#include "work.h"

/* ---- Validation ---- */

/* T K < 2^32, as PARTITION_MOST_TRIANGLES ensures: all offsets of keys fit a word. Vertex 2^32 - 1 would be NONE. */
static int counts_are_in_range(const nkw_partition_mesh *mesh)
{
    return mesh->influence_count >= 1 && mesh->influence_count <= NKW_SKIN_INFLUENCES &&
           mesh->joint_count <= PARTITION_MOST_JOINTS && mesh->triangle_count <= PARTITION_MOST_TRIANGLES &&
           mesh->vertex_count < UINT32_MAX;
}

/* A weight that is not 0 needs a joint of the mesh; where the weight is 0, the joint is never read. */
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

static nkw_result check_mesh(const nkw_partition_mesh *mesh, size_t *bad)
{
    nkw_result result = counts_are_in_range(mesh) ? NKW_OK : NKW_OUT_OF_RANGE;
    size_t at = 0;
    for (size_t t = 0; result == NKW_OK && t < mesh->triangle_count; t++) {
        result = check_triangle(mesh, t);
        at = t;
    }
    return report(result, at, bad);
}

/* ---- Working memory ---- */

/* K: the joints of a set, at most. Three vertices name 3 * influence_count; sets above max_joint_count are rejected. */
static size_t set_limit(const nkw_partition_mesh *mesh, size_t max_joint_count)
{
    size_t most = 3 * (mesh->influence_count < NKW_SKIN_INFLUENCES ? mesh->influence_count : NKW_SKIN_INFLUENCES);
    return max_joint_count < most ? max_joint_count : most;
}

/* A 32-bit size_t cannot hold every size; SIZE_MAX then fails the test of the memory. */
static size_t saturated(uint64_t n)
{
    return n > SIZE_MAX ? SIZE_MAX : (size_t)n;
}

/* Divides the block into the arrays of the plan. Returns their size in words; block may be NULL. */
static uint64_t lay_out(partition_plan *p, const nkw_partition_mesh *mesh, size_t max_joint_count, uint32_t *block)
{
    const uint64_t t = mesh->triangle_count, sets = t * set_limit(mesh, max_joint_count), joints = mesh->joint_count;
    const struct {
        uint32_t **array;
        uint64_t count;
    } all[] = {{&p->group_of, t},        {&p->table, 2 * t},
               {&p->set_start, t + 1},   {&p->set_keys, sets},
               {&p->first, t},           {&p->bin_of, t},
               {&p->ranked, t},          {&p->missing, t},
               {&p->touched, t},         {&p->users, sets},
               {&p->user_start, joints}, {&p->user_count, joints},
               {&p->in_bin, joints},     {&p->bin_start, t + 1},
               {&p->bin_keys, sets},     {&p->bin_material, t},
               {&p->bin_order, t},       {&p->part_of, t},
               {&p->seen_in, mesh->vertex_count}, {&p->local, mesh->vertex_count}};
    uint64_t used = 0;
    p->mesh = mesh;
    p->max_joint_count = max_joint_count;
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        *all[i].array = block ? block + used : NULL;
        used += all[i].count;
    }
    return used;
}

nkw_partition_sizes nkw_partition_bounds(const nkw_partition_mesh *mesh, size_t max_joint_count)
{
    nkw_partition_sizes sizes = {0, 0, 0, 0};
    if (!counts_are_in_range(mesh))
        return sizes;
    partition_plan p;
    uint64_t t = mesh->triangle_count;
    sizes.part_count = saturated(t);
    sizes.joint_count = saturated(t * set_limit(mesh, max_joint_count));
    sizes.vertex_count = saturated(3 * t);
    sizes.work_bytes = saturated(sizeof(uint32_t) * lay_out(&p, mesh, max_joint_count, NULL));
    return sizes;
}

nkw_result nkw_partition_build(const nkw_partition_mesh *mesh, size_t max_joint_count, nkw_partition *out, size_t *bad,
                               nkw_work work)
{
    out->part_count = out->joint_count = out->triangle_count = out->vertex_count = out->rejected_count = 0;
    nkw_result result = check_mesh(mesh, bad);
    if (result == NKW_OK && !work_fits(work, nkw_partition_bounds(mesh, max_joint_count).work_bytes))
        result = NKW_TOO_SMALL;
    if (result != NKW_OK || mesh->triangle_count == 0)
        return result;
    partition_plan p = {0};
    lay_out(&p, mesh, max_joint_count, (uint32_t *)work.data);
    nkwi_partition_group(&p);
    nkwi_partition_pack(&p);
    nkwi_partition_write(&p, out);
    if (out->rejected_count == 0)
        return NKW_OK;
    /* Rejected triangles are after the others, in ascending order: this is the first. */
    return report(NKW_TOO_MANY, out->triangles[out->triangle_count], bad);
}
