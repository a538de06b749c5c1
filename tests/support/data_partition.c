/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"

#define TRIANGLES  157
#define VERTICES   97
#define JOINTS     23
#define INFLUENCES 4
#define MOST       9
#define WORK       36000
#define SLOTS      10
#define STRIDE     (7 * SLOTS + 2)

static uint32_t indices[3 * TRIANGLES], materials[TRIANGLES];
static uint16_t joints[VERTICES * INFLUENCES], depths[JOINTS];
static float weights[VERTICES * INFLUENCES];
static nkw_vec3 positions[VERTICES], normals[VERTICES];
static nkw_mat4 inverse_bind[JOINTS];

static nkw_part parts[TRIANGLES];
static uint16_t part_joints[MOST * TRIANGLES], slots[3 * TRIANGLES * INFLUENCES];
static uint32_t triangles[TRIANGLES], part_indices[3 * TRIANGLES], vertices[3 * TRIANGLES];
static float part_weights[3 * TRIANGLES * INFLUENCES], local[3 * TRIANGLES * STRIDE];

static void draw(random_source *r)
{
    for (size_t v = 0; v < VERTICES; v++) {
        positions[v] = random_vec3(r, -5, 5);
        normals[v] = random_direction(r);
        size_t used = (size_t)(random_bits(r) % (INFLUENCES + 1));
        for (size_t i = 0; i < INFLUENCES; i++) {
            joints[v * INFLUENCES + i] = (uint16_t)((v / 5 + random_bits(r) % 4) % JOINTS);
            weights[v * INFLUENCES + i] = i < used ? random_unit(r) : 0.0f;
        }
    }
    for (size_t t = 0; t < TRIANGLES; t++) {
        materials[t] = (uint32_t)(random_bits(r) % 3) * 1000000007u;
        for (size_t c = 0; c < 3; c++)
            indices[3 * t + c] = (uint32_t)((t / 2 + random_bits(r) % 12) % VERTICES);
    }
}

static void draw_joints(random_source *r)
{
    int32_t parents[JOINTS];
    uint32_t order[JOINTS];
    for (size_t b = 0; b < JOINTS; b++) {
        nkw_trs trs = {random_vec3(r, -5, 5), random_rotation(r), random_vec3(r, 0.5f, 2)};
        inverse_bind[b] = nkw_mat4_from_trs(&trs);
        parents[b] = b + 1 < JOINTS ? (int32_t)(b + 1 + random_bits(r) % (JOINTS - 1 - b)) : -1;
    }
    const nkw_skeleton skeleton = {parents, JOINTS};
    nkw_skeleton_depths(&skeleton, depths, order, NULL);
}

static uint64_t hash_words(uint64_t hash, const uint32_t *words, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        float halves[2] = {(float)(words[i] >> 16), (float)(words[i] & 0xffff)};
        hash = hash_floats(hash, halves, 2);
    }
    return hash;
}

static uint64_t hash_shorts(uint64_t hash, const uint16_t *shorts, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        float value = shorts[i];
        hash = hash_floats(hash, &value, 1);
    }
    return hash;
}

static uint64_t hash_partition(uint64_t hash, const nkw_partition *p)
{
    hash = hash_words(hash, &p->parts->material, 7 * p->part_count);
    hash = hash_shorts(hash, p->joints, p->joint_count);
    hash = hash_words(hash, p->triangles, TRIANGLES);
    hash = hash_words(hash, p->indices, 3 * p->triangle_count);
    hash = hash_words(hash, p->vertices, p->vertex_count);
    hash = hash_shorts(hash, p->joint_slots, INFLUENCES * p->vertex_count);
    return hash_floats(hash, p->weights, INFLUENCES * p->vertex_count);
}

uint64_t data_partition(void)
{
    random_source r = random_from(6);
    uint64_t hash = HASH_START;
    draw(&r);
    draw_joints(&r);
    nkw_partition_mesh mesh = {indices, materials, TRIANGLES, joints, weights, VERTICES, INFLUENCES, JOINTS, depths};
    nkw_partition out = {parts, part_joints, triangles, part_indices, vertices, slots, part_weights, 0, 0, 0, 0, 0};
    static const size_t most[] = {2, 4, 7, MOST};
    for (size_t i = 0; i < 4; i++) {
        NKW_STACK_WORK(work, WORK);
        size_t bad;
        nkw_result result = nkw_partition_build(&mesh, most[i], &out, &bad, work);
        const uint32_t head[] = {(uint32_t)result, (uint32_t)bad, (uint32_t)out.part_count,
                                 (uint32_t)out.rejected_count};
        hash = hash_partition(hash_words(hash, head, 4), &out);
    }
    const nkw_partition_source source = {&mesh, inverse_bind, positions, normals};
    const nkw_partition_source bare = {&mesh, inverse_bind, positions, NULL};
    for (size_t k = 0; k < out.part_count; k++) {
        size_t n = out.parts[k].vertex_count;
        memset(local, 0, sizeof local);
        nkw_partition_vertices(&out, k, &source, SLOTS, local, STRIDE);
        hash = hash_floats(hash, local, n * STRIDE);
        nkw_partition_vertices(&out, k, &bare, 3, local, 12);
        hash = hash_floats(hash, local, n * 12);
    }
    return hash;
}
