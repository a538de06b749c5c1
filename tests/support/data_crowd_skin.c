/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"

enum { JOINTS = 11, VERTICES = 71, MOST = 6 };

static nkw_mat4 palettes[NKW_CROWD][JOINTS];
static float crowd[NKW_CROWD_MATRIX_FLOATS(JOINTS)], weights[VERTICES * MOST], vectors[2][VERTICES * 3];
static float out[NKW_CROWD][2][VERTICES * 3];
static uint16_t joints[VERTICES * MOST];

/* Joints beyond the palette, vertices without weight and zero normals among them. */
static void draw(void)
{
    random_source r = random_from(14);
    const nkw_mat4 *matrices[NKW_CROWD];
    for (size_t i = 0; i < NKW_CROWD; i++) {
        matrices[i] = palettes[i];
        for (size_t j = 0; j < JOINTS; j++) {
            const nkw_trs trs = {random_vec3(&r, -2, 2), random_rotation(&r), random_vec3(&r, 0.5f, 2)};
            palettes[i][j] = nkw_mat4_from_trs(&trs);
        }
    }
    const nkw_crowd_matrices_span lanes = {crowd, JOINTS};
    nkw_crowd_from_matrices(matrices, lanes);
    for (size_t i = 0; i < VERTICES * MOST; i++) {
        joints[i] = (uint16_t)(random_bits(&r) % (JOINTS + 1));
        weights[i] = i / MOST % 13 == 5 ? 0.0f : random_unit(&r);
    }
    for (size_t i = 0; i < VERTICES * 3; i++) {
        vectors[0][i] = random_between(&r, -1, 1);
        vectors[1][i] = i / 3 % 17 == 2 ? 0.0f : random_between(&r, -1, 1);
    }
}

uint64_t data_crowd_skin(void)
{
    uint64_t hash = HASH_START;
    draw();
    for (int round = 0; round < 8; round++) {
        const nkw_skin skin = {
            VERTICES, round < 4 ? 4 : (size_t)round - 2, {joints, 0, NKW_SKIN_U16}, {weights, 0, NKW_SKIN_F32}};
        const nkw_vertices_view in = {{vectors[0], 0}, {vectors[1], 0}, {NULL, 0}, {NULL, 0}};
        const nkw_crowd_matrices_view palette = {crowd, JOINTS};
        nkw_vertices_span outs[NKW_CROWD];
        for (size_t i = 0; i < NKW_CROWD; i++) {
            const nkw_vertices_span to = {
                {i == 4 ? NULL : out[i][0], 0}, {round % 4 == 3 ? NULL : out[i][1], 0}, {NULL, 0}, {NULL, 0}};
            outs[i] = to;
        }
        nkw_crowd_skin(palette, &skin, in, (nkw_skin_options){round % 2, 0, 0}, outs);
        hash = hash_floats(hash, out[0][0], sizeof out / sizeof(float));
    }
    return hash;
}
