/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"
#include "solids.h"
#include "views.h"

static unsigned char memory[NKW_MESH_WORK(SOLID_TRIANGLES) + 16];

/* A grid of 10 x 10 vertices, uneven, a few of them at the place of others. */
static void draw_grid(random_source *r, solid *s)
{
    s->vertex_count = 100;
    s->triangle_count = 0;
    for (uint32_t i = 0; i < 100; i++) {
        const nkw_vec3 p = {(float)(i % 10), (float)(i / 10), 0.0f};
        s->positions[i] = i % 23 == 22 ? s->positions[i - 1] : nkw_vec3_add(p, random_vec3(r, -0.4f, 0.4f));
        const uint32_t quad[4] = {i, i + 1, i + 11, i + 10};
        if (i % 10 < 9 && i < 90)
            solid_quad(s, quad, (int)(random_bits(r) % 2));
    }
}

/* Corners of their own; the texture mirrored in the middle, without area in some places. */
static uint64_t hash_tangents(uint64_t hash, random_source *r, const solid *s, const nkw_vec3 *normals)
{
    enum { CORNERS = 3 * SOLID_TRIANGLES };
    static nkw_vec3 positions[CORNERS], bitangents[CORNERS];
    static float uv[2 * CORNERS], tangents[4 * CORNERS];
    const size_t count = 3 * s->triangle_count;
    const float step = random_bits(r) % 2 ? 1.0f : 2.0f;
    for (size_t c = 0; c < count; c++) {
        const float u = (float)(s->indices[c] % 10) - 4.0f;
        positions[c] = s->positions[s->indices[c]];
        uv[2 * c] = step * (float)(int)((u < 0.0f ? -u : u) / step);
        uv[2 * c + 1] = (float)(s->indices[c] / 10) + 0.1f * u;
    }
    const nkw_mesh mesh = {positions, count, NULL, s->triangle_count};
    const nkw_mesh_surface surface = {normals, uv};
    nkw_mesh_tangents(&mesh, surface, tangents, bitangents, NULL, work_in(memory, sizeof memory));
    hash = hash_floats(hash, tangents, 4 * count);
    return hash_floats(hash, &bitangents[0].x, 3 * count);
}

/* Numbers below 2^24. */
static uint64_t hash_numbers(uint64_t hash, const uint32_t *numbers, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const float number = (float)numbers[i];
        hash = hash_floats(hash, &number, 1);
    }
    return hash;
}

/* Some triangles turned, one edge of three triangles. */
static uint64_t hash_facing(uint64_t hash, random_source *r, solid *s)
{
    for (size_t t = 0; t < s->triangle_count; t++) {
        uint32_t *i = s->indices + 3 * t, second = i[1];
        if (random_bits(r) % 3 == 0)
            i[1] = i[2], i[2] = second;
    }
    solid_triangle(s, 0, 1, 50);
    const nkw_mesh mesh = solid_mesh(s);
    nkw_mesh_facing f;
    nkw_mesh_fix_facing(&mesh, s->indices, &f, NULL, work_in(memory, sizeof memory));
    const uint32_t counts[] = {(uint32_t)f.turned_count, (uint32_t)f.piece_count, (uint32_t)f.closed_count,
                               (uint32_t)f.conflict_count, (uint32_t)f.branch_count};
    hash = hash_numbers(hash, counts, 5);
    return hash_numbers(hash, s->indices, 3 * s->triangle_count);
}

uint64_t data_mesh(void)
{
    static const float creases[] = {0.0f, 0.2f, 0.7f, 1.5f, 4.0f};
    random_source r = random_from(16);
    uint64_t hash = HASH_START;
    for (int round = 0; round < 20; round++) {
        solid s;
        nkw_vec3 normals[3 * SOLID_TRIANGLES];
        draw_grid(&r, &s);
        const nkw_mesh mesh = solid_mesh(&s);
        nkw_mesh_normals(&mesh, creases[round % 5], normals, NULL, work_in(memory, sizeof memory));
        hash = hash_floats(hash, &normals[0].x, 9 * s.triangle_count);
        const nkw_box box = nkw_box_from_points(s.positions, s.vertex_count);
        hash = hash_floats(hash, &box.low.x, 6);
        hash = hash_tangents(hash, &r, &s, normals);
        hash = hash_facing(hash, &r, &s);
    }
    return hash;
}
