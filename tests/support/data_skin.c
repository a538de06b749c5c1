/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"

#define VERTICES 141 /* two whole blocks and an odd rest */
#define JOINTS   37
#define FLOATS   14

typedef struct model {
    nkw_mat4 matrices[JOINTS];
    nkw_mat3 normals[JOINTS];
    nkw_dual_quat duals[JOINTS];
    float weights[VERTICES * 8], vertices[VERTICES * FLOATS];
    uint16_t weights16[VERTICES * 8], joints[VERTICES * 8];
    uint8_t joints8[VERTICES * 8], weights8[VERTICES * 8];
} model;

static void draw_joints(random_source *r, model *m)
{
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_trs trs = {random_vec3(r, -2, 2), random_rotation(r), random_vec3(r, 0.5f, 2)};
        m->matrices[j] = nkw_mat4_from_trs(&trs);
        nkw_mat3 block = nkw_mat3_from_mat4(&m->matrices[j]);
        m->normals[j] = nkw_mat3_normal(&block);
        m->duals[j].real = trs.rotation;
        m->duals[j].dual = random_rotation(r);
    }
}

/* Joints beyond the palette, vertices without weight and zero normals among them. */
static void draw(model *m)
{
    random_source r = random_from(6);
    draw_joints(&r, m);
    for (size_t i = 0; i < VERTICES * 8; i++) {
        m->joints[i] = (uint16_t)(random_bits(&r) % (JOINTS + 1));
        m->weights[i] = i / 8 % 19 == 3 ? 0.0f : random_unit(&r);
        m->weights16[i] = (uint16_t)(i / 8 % 17 == 5 ? 0 : random_bits(&r));
        m->joints8[i] = (uint8_t)(random_bits(&r) % (JOINTS + 1));
        m->weights8[i] = (uint8_t)(i / 8 % 13 == 7 ? 0 : random_bits(&r));
    }
    for (size_t i = 0; i < VERTICES * FLOATS; i++)
        m->vertices[i] = i % 31 == 0 ? 0.0f : random_between(&r, -1, 1);
}

static nkw_vertices_view streams(const float *v)
{
    nkw_vertices_view r = {{v, 4 * FLOATS}, {v + 3, 4 * FLOATS}, {v + 8, 4 * FLOATS}, {v + 11, 4 * FLOATS}};
    return r;
}

static nkw_vertices_span spans(float *v)
{
    nkw_vertices_span r = {{v, 4 * FLOATS}, {v + 3, 4 * FLOATS}, {v + 8, 4 * FLOATS}, {v + 11, 4 * FLOATS}};
    return r;
}

static nkw_skin_palette palette_of(const model *m, int with_normals, int keep_length)
{
    nkw_skin_palette p = {{m->matrices, JOINTS, NKW_PALETTE_MAT4},
                          {with_normals ? m->normals : NULL, JOINTS, NKW_PALETTE_NORMAL_MAT3},
                          {keep_length, 0, 0}};
    return p;
}

static nkw_palette_view duals_of(const model *m)
{
    nkw_palette_view p = {m->duals, JOINTS, NKW_PALETTE_DUAL_QUAT};
    return p;
}

static uint64_t skin_all(uint64_t hash, const model *m, const nkw_skin *skin)
{
    const nkw_skin_palette plain = palette_of(m, 0, 0), exact = palette_of(m, 1, 0);
    float v[VERTICES * FLOATS];
    nkw_vertices_view in = streams(m->vertices);
    nkw_vertices_span out = spans(v);
    memcpy(v, m->vertices, sizeof v);
    nkw_skin_linear(skin, &plain, in, out);
    hash = hash_floats(hash, v, VERTICES * FLOATS);
    nkw_skin_linear(skin, &exact, in, out);
    hash = hash_floats(hash, v, VERTICES * FLOATS);
    nkw_skin_dual_quat(skin, duals_of(m), in, out);
    return hash_floats(hash, v, VERTICES * FLOATS);
}

/* Positions and normals alone, in place, made unit and not. */
static uint64_t skin_pairs(uint64_t hash, const model *m, const nkw_skin *skin)
{
    for (int raw = 0; raw < 2; raw++) {
        const nkw_skin_palette palette = palette_of(m, 0, raw);
        float v[VERTICES * FLOATS];
        nkw_vertices_view in = {{v, 0}, {v + 3 * VERTICES, 4 * FLOATS / 2}, {NULL, 0}, {NULL, 0}};
        nkw_vertices_span out = {{v, 0}, {v + 3 * VERTICES, 4 * FLOATS / 2}, {NULL, 0}, {NULL, 0}};
        memcpy(v, m->vertices, sizeof v);
        nkw_skin_linear(skin, &palette, in, out);
        hash = hash_floats(hash, v, VERTICES * FLOATS);
    }
    return hash;
}

/* Component arrays of a vector, VERTICES floats at every 150th, to structs and back. */
static void gather(const float *v, nkw_vec3 *out)
{
    for (size_t i = 0; i < VERTICES; i++)
        out[i].x = v[i], out[i].y = v[150 + i], out[i].z = v[300 + i];
}

static void scatter(const nkw_vec3 *in, size_t n, float *v)
{
    for (size_t i = 0; i < n; i++)
        v[i] = in[i].x, v[150 + i] = in[i].y, v[300 + i] = in[i].z;
}

/* Positions and normals alone, one method after the other. */
static uint64_t skin_chain(uint64_t hash, const model *m, const nkw_skin *skin)
{
    const nkw_skin_palette plain = palette_of(m, 0, 0), exact = palette_of(m, 1, 0);
    float v[VERTICES * FLOATS];
    nkw_vec3 p[VERTICES], n[VERTICES];
    nkw_vertices_view in = {{p, 0}, {n, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span out = {{p, 0}, {n, 0}, {NULL, 0}, {NULL, 0}};
    memcpy(v, m->vertices, sizeof v);
    gather(v, p), gather(v + 450, n);
    nkw_skin_linear(skin, &plain, in, out);
    nkw_skin_linear(skin, &exact, in, out);
    nkw_skin_dual_quat(skin, duals_of(m), in, out);
    scatter(p, skin->vertex_count, v), scatter(n, skin->vertex_count, v + 450);
    return hash_floats(hash, v, VERTICES * FLOATS);
}

static uint64_t prune(uint64_t hash, const nkw_skin *skin)
{
    float weights[VERTICES * 4], joints_as_floats[VERTICES * 4];
    uint16_t joints[VERTICES * 4];
    nkw_skin_span j = {joints, 0, NKW_SKIN_U16}, w = {weights, 0, NKW_SKIN_F32};
    nkw_skin_prune(skin, 4, j, w);
    for (size_t i = 0; i < VERTICES * 4; i++)
        joints_as_floats[i] = joints[i];
    return hash_floats(hash_floats(hash, joints_as_floats, VERTICES * 4), weights, VERTICES * 4);
}

uint64_t data_skin(void)
{
    static model m;
    uint64_t hash = HASH_START;
    draw(&m);
    for (size_t k = 1; k <= 8; k++) {
        nkw_skin skin = {VERTICES, k, {m.joints, 16, NKW_SKIN_U16}, {m.weights, 32, NKW_SKIN_F32}};
        hash = skin_chain(skin_all(hash, &m, &skin), &m, &skin);
        hash = prune(skin_pairs(hash, &m, &skin), &skin);
        nkw_skin tight = {VERTICES, k, {m.joints, 0, NKW_SKIN_U16}, {m.weights16, 0, NKW_SKIN_U16}};
        hash = skin_chain(skin_all(hash, &m, &tight), &m, &tight);
        nkw_skin bytes = {VERTICES - k, k, {m.joints8, 5 < k ? k : 5, NKW_SKIN_U8}, {m.weights8, 0, NKW_SKIN_U8}};
        hash = skin_pairs(skin_all(hash, &m, &bytes), &m, &bytes);
    }
    return hash;
}
