/* SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "expect.h"
#include "partition.h"

void mesh_shape(mesh_data *d, size_t triangles, size_t vertices, size_t influences, size_t joints)
{
    nkw_partition_mesh mesh = {d->indices, d->materials, triangles, d->joints, d->weights,
                               vertices,   influences,   joints,    NULL};
    memset(d, 0, sizeof *d);
    d->mesh = mesh;
}

void mesh_draw(mesh_data *d, random_source *r)
{
    static const uint32_t materials[] = {0, 1, UINT32_MAX};
    const nkw_partition_mesh *m = &d->mesh;
    for (size_t v = 0; v < m->vertex_count; v++)
        for (size_t i = 0; i < m->influence_count; i++) {
            size_t joint = (v * m->joint_count / m->vertex_count + random_bits(r) % 3) % m->joint_count;
            int used = random_bits(r) % 3 != 0;
            d->joints[v * m->influence_count + i] = used ? (uint16_t)joint : 65535;
            d->weights[v * m->influence_count + i] = used ? random_unit(r) + 0.01f : 0.0f;
        }
    for (size_t t = 0; t < m->triangle_count; t++) {
        d->materials[t] = materials[random_bits(r) % 3];
        for (size_t c = 0; c < 3; c++)
            d->indices[3 * t + c] =
                (uint32_t)((t * m->vertex_count / m->triangle_count + random_bits(r) % 20) % m->vertex_count);
    }
}

void mesh_strip(mesh_data *d)
{
    static const uint32_t indices[] = {0, 1, 2, 1, 2, 3, 2, 3, 4, 3, 4, 5, 4, 5, 6, 5, 6, 7};
    static const uint32_t materials[] = {0, 0, 0, 0, 0, 7};
    static const uint16_t joints[] = {0, 9, 0, 9, 1, 9, 1, 2, 2, 9, 3, 9, 3, 9, 4, 9};
    static const float weights[] = {1, 0, 1, 0, 1, 0, 0.5f, 0.5f, 1, 0, 1, 0, 1, 0, 1, 0};
    mesh_shape(d, 6, 8, 2, 5);
    memcpy(d->indices, indices, sizeof indices);
    memcpy(d->materials, materials, sizeof materials);
    memcpy(d->joints, joints, sizeof joints);
    memcpy(d->weights, weights, sizeof weights);
}

/* ---- Partitions, in memory of exactly the lengths that bounds gives ---- */

static nkw_partition alloc_partition(const nkw_partition_mesh *mesh, nkw_partition_sizes sizes)
{
    size_t n = sizes.vertex_count * mesh->influence_count;
    nkw_partition p;
    memset(&p, 0, sizeof p);
    p.parts = malloc(sizes.part_count * sizeof(nkw_part));
    p.joints = malloc(sizes.joint_count * sizeof(uint16_t));
    p.triangles = malloc(mesh->triangle_count * sizeof(uint32_t));
    p.indices = malloc(3 * mesh->triangle_count * sizeof(uint32_t));
    p.vertices = malloc(sizes.vertex_count * sizeof(uint32_t));
    p.joint_slots = malloc(n * sizeof(uint16_t));
    p.weights = malloc(n * sizeof(float));
    return p;
}

void partition_free(nkw_partition *p)
{
    free(p->parts);
    free(p->joints);
    free(p->triangles);
    free(p->indices);
    free(p->vertices);
    free(p->joint_slots);
    free(p->weights);
}

nkw_partition partition_build(const nkw_partition_mesh *mesh, size_t max_joint_count, nkw_result want)
{
    nkw_partition_sizes sizes = nkw_partition_bounds(mesh, max_joint_count);
    nkw_partition p = alloc_partition(mesh, sizes);
    const nkw_work work = {malloc(sizes.work_bytes), sizes.work_bytes};
    memset(work.data, 0xa5, work.bytes);
    size_t bad = 99;
    assert_int_equal(nkw_partition_build(mesh, max_joint_count, &p, &bad, work), want);
    assert_int_equal(bad, want == NKW_TOO_MANY ? p.triangles[p.triangle_count] : 0);
    free(work.data);
    return p;
}

/* ---- What holds for every partition, by plain means ---- */

/* The joints of the triangle. Returns their number. */
static size_t needed(const nkw_partition_mesh *m, size_t t, unsigned char *joints)
{
    size_t n = 0;
    memset(joints, 0, m->joint_count);
    for (size_t c = 0; c < 3; c++)
        for (size_t i = 0; i < m->influence_count; i++) {
            size_t at = m->indices[3 * t + c] * m->influence_count + i;
            if (m->weights[at] == 0.0f)
                continue;
            n += !joints[m->joints[at]];
            joints[m->joints[at]] = 1;
        }
    return n;
}

/* Each triangle is once in a part or once among the rejected, and rejected just when it needs more. */
static void expect_exact_cover(const nkw_partition_mesh *m, size_t max_joint_count, const nkw_partition *p)
{
    unsigned char joints[256], seen[MOST_TRIANGLES] = {0};
    assert_int_equal(p->triangle_count + p->rejected_count, m->triangle_count);
    for (size_t i = 0; i < m->triangle_count; i++) {
        size_t t = p->triangles[i];
        assert_true(t < m->triangle_count);
        assert_int_equal(seen[t], 0);
        seen[t] = 1;
        assert_int_equal(needed(m, t, joints) > max_joint_count, i >= p->triangle_count);
        if (i > p->triangle_count)
            assert_true(p->triangles[i - 1] < t);
    }
}

/* Runs follow one another without a gap, and end at the counts. */
static void expect_runs(const nkw_partition *p)
{
    size_t triangle = 0, joint = 0, vertex = 0;
    for (size_t k = 0; k < p->part_count; k++) {
        const nkw_part *part = &p->parts[k];
        assert_int_equal(part->first_triangle, triangle);
        assert_int_equal(part->first_joint, joint);
        assert_int_equal(part->first_vertex, vertex);
        assert_true(part->triangle_count > 0);
        triangle += part->triangle_count;
        joint += part->joint_count;
        vertex += part->vertex_count;
    }
    assert_int_equal(triangle, p->triangle_count);
    assert_int_equal(joint, p->joint_count);
    assert_int_equal(vertex, p->vertex_count);
}

/* A part's triangles ascend, are of its material, and its indices lead back to the mesh's vertices. */
static void expect_triangles(const nkw_partition_mesh *m, const nkw_partition *p, const nkw_part *part)
{
    for (size_t i = part->first_triangle; i < part->first_triangle + part->triangle_count; i++) {
        size_t t = p->triangles[i];
        assert_int_equal(m->materials ? m->materials[t] : 0, part->material);
        if (i > part->first_triangle)
            assert_true(p->triangles[i - 1] < t);
        for (size_t c = 0; c < 3; c++) {
            assert_true(p->indices[3 * i + c] < part->vertex_count);
            assert_int_equal(p->vertices[part->first_vertex + p->indices[3 * i + c]], m->indices[3 * t + c]);
        }
    }
}

/* A part's vertices are distinct, come in the order of first use, and their slots lead back to the mesh's joints. */
static void expect_vertices(const nkw_partition_mesh *m, const nkw_partition *p, const nkw_part *part)
{
    size_t met = 0;
    for (size_t i = 3 * (size_t)part->first_triangle; met < part->vertex_count; i++) {
        assert_true(p->indices[i] <= met);
        met += p->indices[i] == met;
    }
    unsigned char seen[MOST_VERTICES] = {0};
    for (size_t v = part->first_vertex; v < part->first_vertex + part->vertex_count; v++) {
        assert_int_equal(seen[p->vertices[v]]++, 0);
        for (size_t i = 0; i < m->influence_count; i++) {
            size_t at = v * m->influence_count + i, from = p->vertices[v] * m->influence_count + i;
            expect_bits(p->weights[at], m->weights[from]);
            assert_true(p->joint_slots[at] < part->joint_count || m->weights[from] == 0.0f);
            if (m->weights[from] != 0.0f)
                assert_int_equal(p->joints[part->first_joint + p->joint_slots[at]], m->joints[from]);
            else
                assert_int_equal(p->joint_slots[at], 0);
        }
    }
}

static int joint_before(const nkw_partition_mesh *m, uint16_t a, uint16_t b)
{
    uint16_t x = m->depths ? m->depths[a] : 0, y = m->depths ? m->depths[b] : 0;
    return x != y ? x < y : a < b;
}

/* A part has at most max_joint_count joints, all of them needed, ascending. */
static void expect_joints(const nkw_partition_mesh *m, size_t max_joint_count, const nkw_partition *p,
                          const nkw_part *part)
{
    unsigned char joints[256], all[256] = {0};
    size_t n = 0;
    for (size_t i = 0; i < part->triangle_count; i++) {
        needed(m, p->triangles[part->first_triangle + i], joints);
        for (size_t b = 0; b < m->joint_count; b++)
            all[b] |= joints[b];
    }
    for (size_t b = 0; b < m->joint_count; b++)
        n += all[b];
    assert_int_equal(n, part->joint_count);
    assert_true(part->joint_count <= max_joint_count);
    const uint16_t *list = p->joints + part->first_joint;
    for (size_t i = 0; i < n; i++) {
        assert_true(all[list[i]]);
        assert_true(i == 0 || joint_before(m, list[i - 1], list[i]));
    }
}

static int has(const uint16_t *list, size_t n, uint16_t joint)
{
    for (size_t i = 0; i < n; i++)
        if (list[i] == joint)
            return 1;
    return 0;
}

/* No two parts of one material fit into one. */
static void expect_no_two_to_join(size_t max_joint_count, const nkw_partition *p)
{
    for (size_t a = 0; a < p->part_count; a++)
        for (size_t b = a + 1; b < p->part_count; b++) {
            const nkw_part *x = &p->parts[a], *y = &p->parts[b];
            size_t together = x->joint_count;
            for (size_t i = 0; i < y->joint_count; i++)
                together += !has(p->joints + x->first_joint, x->joint_count, p->joints[y->first_joint + i]);
            assert_true(x->material != y->material || together > max_joint_count);
        }
}

/* Parts of one material ascend by their first joint that differs; a list that another begins with comes before it. */
static void expect_parts_to_ascend(const nkw_partition_mesh *m, const nkw_partition *p)
{
    for (size_t k = 1; k < p->part_count; k++) {
        const nkw_part *x = &p->parts[k - 1], *y = &p->parts[k];
        const uint16_t *a = p->joints + x->first_joint, *b = p->joints + y->first_joint;
        size_t i = 0;
        while (i < x->joint_count && i < y->joint_count && a[i] == b[i])
            i++;
        int ascend = i == x->joint_count || (i < y->joint_count && joint_before(m, a[i], b[i]));
        assert_true(x->material < y->material || (x->material == y->material && ascend));
    }
}

void expect_partition(const nkw_partition_mesh *m, size_t max_joint_count, const nkw_partition *p)
{
    expect_exact_cover(m, max_joint_count, p);
    expect_runs(p);
    expect_no_two_to_join(max_joint_count, p);
    expect_parts_to_ascend(m, p);
    for (size_t k = 0; k < p->part_count; k++) {
        expect_triangles(m, p, &p->parts[k]);
        expect_vertices(m, p, &p->parts[k]);
        expect_joints(m, max_joint_count, p, &p->parts[k]);
    }
}

size_t mesh_needing_more(const nkw_partition_mesh *m, size_t max_joint_count)
{
    unsigned char joints[256];
    size_t n = 0;
    for (size_t t = 0; t < m->triangle_count; t++)
        n += needed(m, t, joints) > max_joint_count;
    return n;
}

void expect_nothing(const nkw_partition *p)
{
    assert_int_equal(p->part_count + p->joint_count + p->triangle_count + p->vertex_count + p->rejected_count, 0);
}
