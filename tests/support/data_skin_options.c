/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"

enum { VERTICES = 141, JOINTS = 13, MOST = 8, FLOATS = 14 };

typedef struct model {
    nkw_mat4 matrices[NKW_CROWD][JOINTS];
    float crowd[NKW_CROWD_MATRIX_FLOATS(JOINTS)];
    float joints[VERTICES * MOST], weights[VERTICES * MOST], vertices[VERTICES * FLOATS];
} model;

/* Matrices that turn, mirror, flatten; floats that are no joint, vertices without weight and zero normals among them. */
static void draw(model *m)
{
    random_source r = random_from(35);
    const nkw_mat4 *matrices[NKW_CROWD];
    for (size_t i = 0; i < NKW_CROWD; i++) {
        matrices[i] = m->matrices[i];
        for (size_t j = 0; j < JOINTS; j++) {
            nkw_trs trs = {random_vec3(&r, -2, 2), random_rotation(&r), random_vec3(&r, 0.5f, 2)};
            trs.scale.y *= j % 3 == 1 ? -1.0f : j % 7 == 2 ? 0.0f : 1.0f;
            m->matrices[i][j] = nkw_mat4_from_trs(&trs);
        }
    }
    const nkw_crowd_matrices_span lanes = {m->crowd, JOINTS};
    nkw_crowd_from_matrices(matrices, lanes);
    for (size_t i = 0; i < VERTICES * MOST; i++) {
        m->joints[i] = (float)(random_bits(&r) % (JOINTS + 1)) + (i % 37 == 5 ? 0.25f : 0.0f);
        m->weights[i] = i / MOST % 19 == 3 ? 0.0f : random_unit(&r);
    }
    for (size_t i = 0; i < VERTICES * FLOATS; i++)
        m->vertices[i] = i / FLOATS % 23 == 4 ? 0.0f : random_between(&r, -1, 1);
}

static nkw_vertices_view streams(const float *v, int tangents)
{
    const nkw_vertices_view r = {
        {v, 4 * FLOATS}, {v + 3, 4 * FLOATS}, {tangents ? v + 6 : NULL, 4 * FLOATS}, {NULL, 0}};
    return r;
}

static nkw_vertices_span spans(float *v)
{
    const nkw_vertices_span r = {{v, 4 * FLOATS}, {v + 3, 4 * FLOATS}, {v + 6, 4 * FLOATS}, {NULL, 0}};
    return r;
}

/* Interleaved, and positions and normals alone in separate arrays. */
static uint64_t skin_by(uint64_t hash, const model *m, const nkw_skin *skin, nkw_skin_options options)
{
    const nkw_skin_palette palette = {
        {m->matrices[0], JOINTS, NKW_PALETTE_MAT4}, {NULL, 0, NKW_PALETTE_NORMAL_MAT3}, options};
    float v[VERTICES * FLOATS];
    memcpy(v, m->vertices, sizeof v);
    nkw_skin_linear(skin, &palette, streams(m->vertices, (int)skin->influence_count % 2), spans(v));
    hash = hash_floats(hash, v, VERTICES * FLOATS);
    memcpy(v, m->vertices, sizeof v);
    const nkw_vertices_view in = {{v, 0}, {v + 3 * VERTICES, 0}, {NULL, 0}, {NULL, 0}};
    const nkw_vertices_span out = {{v, 0}, {v + 3 * VERTICES, 0}, {NULL, 0}, {NULL, 0}};
    nkw_skin_linear(skin, &palette, in, out);
    return hash_floats(hash, v, VERTICES * FLOATS);
}

static uint64_t crowd_by(uint64_t hash, const model *m, const nkw_skin *skin, nkw_skin_options options)
{
    static float v[NKW_CROWD][VERTICES * FLOATS];
    const nkw_crowd_matrices_view palette = {m->crowd, JOINTS};
    nkw_vertices_span outs[NKW_CROWD];
    for (size_t i = 0; i < NKW_CROWD; i++) {
        memcpy(v[i], m->vertices, sizeof v[i]);
        outs[i] = spans(v[i]);
    }
    nkw_crowd_skin(palette, skin, streams(m->vertices, 1), options, outs);
    return hash_floats(hash, v[0], sizeof v / sizeof(float));
}

uint64_t data_skin_options(void)
{
    static model m;
    uint64_t hash = HASH_START;
    draw(&m);
    for (size_t k = 1; k <= MOST; k++)
        for (int o = 0; o < 8; o++) {
            const nkw_skin_options options = {o & 1, o >> 1 & 1, o >> 2};
            const nkw_skin skin = {VERTICES, k, {m.joints, 0, NKW_SKIN_F32}, {m.weights, 0, NKW_SKIN_F32}};
            hash = crowd_by(skin_by(hash, &m, &skin, options), &m, &skin, options);
        }
    return hash;
}
