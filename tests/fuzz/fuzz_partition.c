/* SPDX-License-Identifier: MIT */
#include "fuzz.h"

#include <string.h>

enum { TRIANGLES = 120, VERTICES = 80, JOINTS = 70 };

static nkw_partition_mesh draw_mesh(fuzz *f, int wild)
{
    nkw_partition_mesh m = {NULL,
                            NULL,
                            fuzz_upto(f, TRIANGLES),
                            NULL,
                            NULL,
                            1 + fuzz_upto(f, VERTICES - 1),
                            1 + fuzz_upto(f, 7),
                            1 + fuzz_upto(f, JOINTS - 1),
                            NULL};
    uint32_t *indices = fuzz_bytes(f, 12 * m.triangle_count);
    size_t n = m.vertex_count * m.influence_count;
    uint16_t *joints = fuzz_bytes(f, 2 * n);
    float *weights = fuzz_floats(f, n, wild);
    for (size_t i = 0; i < 3 * m.triangle_count && !(wild && i % 64 == 63); i++)
        indices[i] %= (uint32_t)m.vertex_count;
    for (size_t i = 0; i < n; i++) {
        joints[i] = (uint16_t)(wild && i % 16 == 15 ? joints[i] : joints[i] % m.joint_count);
        weights[i] = wild || weights[i] > 0.0f ? weights[i] : 0.0f;
    }
    m.indices = indices;
    m.joints = joints;
    m.weights = weights;
    m.materials = fuzz_byte(f) % 2 ? NULL : fuzz_bytes(f, 4 * m.triangle_count);
    m.depths = fuzz_byte(f) % 2 ? NULL : fuzz_bytes(f, 2 * m.joint_count);
    return m;
}

static nkw_partition room_for(fuzz *f, const nkw_partition_mesh *m, const nkw_partition_sizes *sizes)
{
    nkw_partition p;
    memset(&p, 0, sizeof p);
    p.parts = fuzz_block(f, sizes->part_count * sizeof *p.parts);
    p.joints = fuzz_block(f, sizes->joint_count * sizeof *p.joints);
    p.triangles = fuzz_block(f, m->triangle_count * sizeof *p.triangles);
    p.indices = fuzz_block(f, 3 * m->triangle_count * sizeof *p.indices);
    p.vertices = fuzz_block(f, sizes->vertex_count * sizeof *p.vertices);
    p.joint_slots = fuzz_block(f, sizes->vertex_count * m->influence_count * sizeof *p.joint_slots);
    p.weights = fuzz_block(f, sizes->vertex_count * m->influence_count * sizeof *p.weights);
    return p;
}

/* Runs follow each other; indices, slots and joints lie within theirs. */
static void check_part(const nkw_partition_mesh *m, const nkw_partition *p, const nkw_part *part,
                       size_t max_joint_count)
{
    FUZZ_CHECK(part->joint_count <= max_joint_count && part->triangle_count > 0);
    for (size_t i = 0; i < part->joint_count; i++)
        FUZZ_CHECK(p->joints[part->first_joint + i] < m->joint_count);
    for (size_t i = 0; i < 3 * (size_t)part->triangle_count; i++) {
        size_t at = 3 * (size_t)part->first_triangle + i, v = part->first_vertex + p->indices[at];
        FUZZ_CHECK(p->indices[at] < part->vertex_count);
        FUZZ_CHECK(p->vertices[v] == m->indices[3 * p->triangles[at / 3] + at % 3]);
    }
    for (size_t i = 0; i < part->vertex_count * m->influence_count; i++) {
        size_t at = part->first_vertex * m->influence_count + i;
        size_t from = p->vertices[at / m->influence_count] * m->influence_count + at % m->influence_count;
        FUZZ_CHECK(fuzz_same(p->weights + at, m->weights + from, 1));
        FUZZ_CHECK(p->weights[at] == 0.0f || (p->joint_slots[at] < part->joint_count &&
                                              p->joints[part->first_joint + p->joint_slots[at]] == m->joints[from]));
    }
}

static void check_partition(fuzz *f, const nkw_partition_mesh *m, const nkw_partition *p, size_t max_joint_count)
{
    unsigned char *seen = fuzz_block(f, m->triangle_count);
    size_t triangles = 0, joints = 0, vertices = 0;
    memset(seen, 0, m->triangle_count);
    FUZZ_CHECK(p->triangle_count + p->rejected_count == m->triangle_count);
    for (size_t i = 0; i < m->triangle_count; i++)
        FUZZ_CHECK(p->triangles[i] < m->triangle_count && !seen[p->triangles[i]]++);
    for (size_t k = 0; k < p->part_count; k++) {
        const nkw_part *part = &p->parts[k];
        FUZZ_CHECK(part->first_triangle == triangles && part->first_joint == joints && part->first_vertex == vertices);
        check_part(m, p, part, max_joint_count);
        triangles += part->triangle_count, joints += part->joint_count, vertices += part->vertex_count;
    }
    FUZZ_CHECK(triangles == p->triangle_count && joints == p->joint_count && vertices == p->vertex_count);
}

/* Writes within its rows, whatever the partition says of itself. */
static void part_vertices(fuzz *f, const nkw_partition_mesh *m, nkw_partition *p)
{
    int normals = fuzz_byte(f) % 2;
    size_t slots = fuzz_byte(f) % 4 ? fuzz_upto(f, 6) : fuzz_huge(f), stride = fuzz_upto(f, 60);
    const nkw_mat4 *inverse_bind = fuzz_matrices(f, m->joint_count, 1);
    const nkw_vec3 *positions = fuzz_block(f, m->vertex_count * sizeof *positions);
    float *out = fuzz_room(f, p->vertex_count * stride);
    for (size_t k = fuzz_byte(f) % 4; k > 0 && p->part_count; k--) {
        uint32_t *field = (uint32_t *)&p->parts[fuzz_upto(f, p->part_count - 1)];
        field[fuzz_upto(f, 6)] = fuzz_byte(f) % 2 ? fuzz_byte(f) : fuzz_bits(f);
    }
    if (fuzz_byte(f) % 4 == 0 && p->vertex_count)
        p->vertices[fuzz_upto(f, p->vertex_count - 1)] = fuzz_bits(f);
    if (fuzz_byte(f) % 4 == 0 && p->joint_count)
        p->joints[fuzz_upto(f, p->joint_count - 1)] = (uint16_t)fuzz_bits(f);
    if (fuzz_byte(f) % 4 == 0 && p->vertex_count)
        p->joint_slots[fuzz_upto(f, p->vertex_count - 1)] = (uint16_t)fuzz_bits(f);
    const nkw_partition_source source = {m, inverse_bind, positions, normals ? positions : NULL};
    for (size_t part = 0; part <= p->part_count; part++)
        nkw_partition_vertices(p, part, &source, slots, out, stride);
    FUZZ_CHECK(nkw_partition_vertices(p, p->part_count, &source, 0, out, stride) == NKW_OUT_OF_RANGE);
}

static void build(fuzz *f, const nkw_partition_mesh *m)
{
    size_t max_joint_count = fuzz_byte(f) % 8 ? fuzz_upto(f, 30) : fuzz_huge(f), bad = 0, bad_again;
    nkw_partition_sizes sizes = nkw_partition_bounds(m, max_joint_count);
    nkw_partition p = room_for(f, m, &sizes);
    const nkw_work work = fuzz_work(f, sizes.work_bytes), none = {NULL, 0};
    nkw_result sound = nkw_partition_build(m, max_joint_count, &p, &bad, none);
    FUZZ_CHECK(bad < m->triangle_count || bad == 0);
    nkw_result result = nkw_partition_build(m, max_joint_count, &p, &bad_again, work);
    if (sound != NKW_OK && sound != NKW_TOO_SMALL) {
        FUZZ_CHECK(result == sound && bad == bad_again && p.part_count == 0 && p.triangle_count == 0);
        return;
    }
    FUZZ_CHECK(result == (p.rejected_count ? NKW_TOO_MANY : NKW_OK));
    check_partition(f, m, &p, max_joint_count);
    part_vertices(f, m, &p);
    const nkw_work less = {work.data, sizes.work_bytes - 1};
    FUZZ_CHECK(!m->triangle_count || nkw_partition_build(m, max_joint_count, &p, NULL, less) == NKW_TOO_SMALL);
}

/* Counts alone: lengths hold the mesh, or there are none for it. */
static void counts(fuzz *f)
{
    nkw_partition_mesh m = {NULL, NULL, fuzz_huge(f), NULL, NULL, fuzz_huge(f), fuzz_huge(f), fuzz_huge(f), NULL};
    nkw_partition_sizes sizes = nkw_partition_bounds(&m, fuzz_huge(f));
    const nkw_work none = {NULL, 0};
    nkw_partition p;
    FUZZ_CHECK(sizes.work_bytes == 0 ||
               (sizes.part_count == m.triangle_count && sizes.vertex_count >= m.triangle_count));
    FUZZ_CHECK(sizes.work_bytes == 0 || sizes.work_bytes > m.triangle_count);
    if (sizes.work_bytes == 0 && m.triangle_count)
        FUZZ_CHECK(nkw_partition_build(&m, 4, &p, NULL, none) == NKW_OUT_OF_RANGE);
}

static void order(fuzz *f)
{
    size_t n = fuzz_upto(f, JOINTS), bad;
    const int32_t *parents = fuzz_byte(f) % 2 ? fuzz_parents(f, n, 1) : fuzz_links(f, n, n, fuzz_byte(f) % 2);
    uint16_t *depths = fuzz_block(f, 2 * n);
    uint32_t *by_depth = fuzz_block(f, 4 * n);
    const nkw_skeleton skeleton = {parents, n}, large = {parents, 65537};
    nkw_result result = nkw_skeleton_depths(&skeleton, depths, by_depth, &bad);
    FUZZ_CHECK(bad < n || bad == 0);
    for (size_t i = 0; result == NKW_OK && i < n; i++) {
        FUZZ_CHECK(by_depth[i] < n);
        FUZZ_CHECK(depths[i] == (parents[i] < 0 ? 0 : depths[parents[i]] + 1));
        FUZZ_CHECK(i == 0 || depths[by_depth[i - 1]] <= depths[by_depth[i]]);
    }
    FUZZ_CHECK(nkw_skeleton_depths(&large, NULL, NULL, NULL) == NKW_OUT_OF_RANGE);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    nkw_partition_mesh m = draw_mesh(&f, fuzz_byte(&f) % 2);
    build(&f, &m);
    counts(&f);
    order(&f);
    return fuzz_end(&f);
}
