/* SPDX-License-Identifier: MIT */
/* Drawn meshes for the tests of skinning, and their matrices by definition. */
#ifndef NAKAWARI_TESTS_SKIN_MESH_H
#define NAKAWARI_TESTS_SKIN_MESH_H

#include <math.h>

#include "random.h"
#include "expect.h"

#define VERTICES 131 /* two whole blocks and an odd rest */
#define JOINTS   23
#define FLOATS   14

/* A mesh of the book's vertex: position 3, normal 3, tangent 3, bitangent 3, texture 2. */
typedef struct mesh {
    nkw_mat4 matrices[JOINTS];
    nkw_mat3 normals[JOINTS];
    nkw_dual_quat duals[JOINTS];
    float weights[VERTICES * 8];
    uint16_t joints[VERTICES * 8];
    float v[VERTICES * FLOATS];
} mesh;

static inline nkw_dual_quat dual_quat(nkw_quat r, nkw_vec3 t)
{
    nkw_quat half = {0.5f * t.x, 0.5f * t.y, 0.5f * t.z, 0};
    nkw_dual_quat d = {r, nkw_quat_mul(half, r)};
    return d;
}

static inline void draw_joints(random_source *r, mesh *m, int rigid)
{
    nkw_vec3 one = {1, 1, 1};
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_trs trs = {random_vec3(r, -2, 2), random_rotation(r), rigid ? one : random_vec3(r, 0.5f, 2)};
        m->matrices[j] = nkw_mat4_from_trs(&trs);
        nkw_mat3 block = nkw_mat3_from_mat4(&m->matrices[j]);
        m->normals[j] = nkw_mat3_normal(&block);
        m->duals[j] = dual_quat(trs.rotation, trs.translation);
    }
}

static inline mesh draw(uint64_t seed, size_t influences, int rigid)
{
    random_source r = random_from(seed);
    mesh m = {0};
    draw_joints(&r, &m, rigid);
    for (size_t i = 0; i < VERTICES * influences; i++) {
        m.joints[i] = (uint16_t)(random_bits(&r) % JOINTS);
        m.weights[i] = random_unit(&r);
    }
    nkw_skin_view in = {m.weights, 0, NKW_SKIN_F32};
    nkw_skin_span out = {m.weights, 0, NKW_SKIN_F32};
    nkw_skin_normalize_weights(in, influences, VERTICES, out);
    for (size_t i = 0; i < VERTICES * FLOATS; i++)
        m.v[i] = random_between(&r, -1, 1);
    return m;
}

static inline nkw_skin skin_of(const mesh *m, size_t influences)
{
    nkw_skin s = {VERTICES, influences, {m->joints, 0, NKW_SKIN_U16}, {m->weights, 0, NKW_SKIN_F32}};
    return s;
}

static inline nkw_skin_palette palette_of(const nkw_mat4 *matrices, const nkw_mat3 *normals, size_t joint_count,
                                          int keep_length)
{
    nkw_skin_palette p = {{matrices, joint_count, NKW_PALETTE_MAT4},
                          {normals, joint_count, NKW_PALETTE_NORMAL_MAT3},
                          {keep_length, 0, 0}};
    return p;
}

static inline nkw_palette_view duals_of(const nkw_dual_quat *duals, size_t joint_count)
{
    nkw_palette_view p = {duals, joint_count, NKW_PALETTE_DUAL_QUAT};
    return p;
}

static inline nkw_vertices_view streams(const float *v, size_t floats)
{
    size_t s = floats * sizeof *v;
    nkw_vertices_view r = {{v, s}, {v + 3, s}, {v + 6, s}, {v + 9, s}};
    return r;
}

static inline nkw_vertices_span spans(float *v, size_t floats)
{
    size_t s = floats * sizeof *v;
    nkw_vertices_span r = {{v, s}, {v + 3, s}, {v + 6, s}, {v + 9, s}};
    return r;
}

static inline nkw_vec3 vec3_at(const float *v)
{
    nkw_vec3 r = {v[0], v[1], v[2]};
    return r;
}

/* The sum in the order of the influences, of `width` floats a joint. */
static inline void blend(const mesh *m, const float *palette, size_t width, size_t influences, size_t vertex,
                         float *out)
{
    for (size_t a = 0; a < width; a++)
        for (size_t e = 0; e < influences; e++) {
            size_t at = vertex * influences + e;
            float term = m->weights[at] * palette[width * m->joints[at] + a];
            out[a] = e ? out[a] + term : term;
        }
}

static inline nkw_vec3 unit(nkw_vec3 n)
{
    float n2 = (n.x * n.x + n.y * n.y) + n.z * n.z;
    return nkw_vec3_scale(n, n2 == 0 ? 0 : 1 / sqrtf(n2));
}

static inline float term_of_side(float a, float b1, float b2, float c1, float c2)
{
    const float p = b1 * c2, q = b2 * c1;
    return a * (p - q) + 0x1p-20f * (fabsf(a) * (fabsf(p) + fabsf(q)));
}

/* The n' of nkw_skin_options before it is made unit, as skin.h defines it. */
static inline nkw_vec3 inverse_normal(const nkw_mat4 *m, nkw_vec3 n)
{
    const nkw_vec3 a = vec3_at(m->m), b = vec3_at(m->m + 4), c = vec3_at(m->m + 8);
    const nkw_vec3 bc = nkw_vec3_cross(b, c), ca = nkw_vec3_cross(c, a), ab = nkw_vec3_cross(a, b);
    const nkw_vec3 r = {(bc.x * n.x + ca.x * n.y) + ab.x * n.z, (bc.y * n.x + ca.y * n.y) + ab.y * n.z,
                        (bc.z * n.x + ca.z * n.y) + ab.z * n.z};
    const float side = (term_of_side(a.x, b.y, b.z, c.y, c.z) + term_of_side(a.y, b.z, b.x, c.z, c.x)) +
                       term_of_side(a.z, b.x, b.y, c.x, c.y);
    return nkw_vec3_scale(r, side < 0.0f ? -1.0f : 1.0f);
}

/* Whether vertex i has a weight other than 0 for a joint of the palette, and its matrix by definition. */
static inline int matrix_of(const mesh *m, size_t influences, size_t i, nkw_mat4 *sum)
{
    int any = 0;
    for (size_t a = 0; a < 16; a++)
        sum->m[a] = 0;
    for (size_t e = 0; e < influences; e++) {
        const size_t joint = m->joints[i * influences + e] < JOINTS ? m->joints[i * influences + e] : 0;
        const float weight = m->joints[i * influences + e] < JOINTS ? m->weights[i * influences + e] : 0;
        any |= weight != 0;
        for (size_t a = 0; a < 16; a++)
            sum->m[a] = e ? sum->m[a] + weight * m->matrices[joint].m[a] : weight * m->matrices[joint].m[a];
    }
    return any;
}

#endif
