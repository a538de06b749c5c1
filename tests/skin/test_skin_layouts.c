/* SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "support/put.h"
#include "support/skin_mesh.h"

static void directions_are_not_normalized_where_that_is_skipped(void **state)
{
    (void)state;
    for (size_t k = 1; k <= 8; k++) {
        mesh m = draw(30 + k, k, 0);
        nkw_skin skin = skin_of(&m, k);
        nkw_skin_palette palette = palette_of(m.matrices, NULL, JOINTS, 1),
                         exact = palette_of(m.matrices, m.normals, JOINTS, 1);
        float out[VERTICES * FLOATS] = {0}, pair[VERTICES * FLOATS] = {0}, own[VERTICES * FLOATS] = {0};
        nkw_vertices_view from = streams(m.v, FLOATS), two = {from.positions, from.normals, {NULL, 0}, {NULL, 0}};
        nkw_vertices_span to = spans(out, FLOATS), to_pair = spans(pair, FLOATS), to_own = spans(own, FLOATS);
        nkw_skin_linear(&skin, &palette, from, to);
        nkw_skin_linear(&skin, &palette, two, to_pair);
        nkw_skin_linear(&skin, &exact, from, to_own);
        for (size_t i = 0; i < VERTICES; i++) {
            nkw_mat4 sum;
            nkw_mat3 normal;
            const float *v = m.v + i * FLOATS, *got = out + i * FLOATS;
            blend(&m, m.matrices->m, 16, k, i, sum.m);
            blend(&m, m.normals->m, 9, k, i, normal.m);
            for (size_t a = 3; a < 12; a += 3)
                expect_vec3_bits(vec3_at(got + a), nkw_mat4_transform_direction(&sum, vec3_at(v + a)));
            expect_floats_bits(pair + i * FLOATS, got, 6);
            expect_bits(pair[i * FLOATS + 6], 0);
            expect_vec3_bits(vec3_at(own + i * FLOATS + 3), nkw_mat3_transform(&normal, vec3_at(v + 3)));
        }
    }
}

static const size_t size_of[4] = {1, 2, 4, 4};

/*
 * The influences of m in the formats of `skin`, whose arrays are written; m has then the numbers that they stand for.
 */
static void encode(mesh *m, size_t k, const nkw_skin *skin, uint8_t *joints, uint8_t *weights)
{
    const nkw_skin_format j = skin->joints.format, w = skin->weights.format;
    const nkw_skin_view from = {m->weights, 0, NKW_SKIN_F32};
    const nkw_skin_span to = {weights, 0, w};
    assert_int_equal(nkw_skin_normalize_weights(from, k, VERTICES, to), NKW_OK);
    for (size_t i = 0; i < VERTICES * k; i++) {
        const uint8_t u8 = (uint8_t)m->joints[i];
        const uint32_t u32 = m->joints[i];
        uint16_t w16;
        memcpy(joints + i * size_of[j],
               j == NKW_SKIN_U8    ? (const void *)&u8
               : j == NKW_SKIN_U16 ? (const void *)&m->joints[i]
                                   : (const void *)&u32,
               size_of[j]);
        memcpy(&w16, weights + 2 * i, sizeof w16);
        if (w == NKW_SKIN_F32)
            memcpy(&m->weights[i], weights + 4 * i, sizeof(float));
        else
            m->weights[i] = w == NKW_SKIN_U8 ? (float)weights[i] / 255.0f : (float)w16 / 65535.0f;
    }
}

/* Positions and normals of `floats` floats a vertex, or separate ones, in place; floats around them are kept. */
static void expect_by_definition(const mesh *m, const nkw_skin *skin, size_t floats, nkw_skin_options options)
{
    nkw_skin_palette palette = palette_of(m->matrices, NULL, JOINTS, 0);
    float got[VERTICES * FLOATS + 2], want[VERTICES * FLOATS + 2];
    const size_t s = floats * sizeof(float), normals = floats == 3 ? 3 * VERTICES : 3;
    palette.options = options;
    memcpy(got + 1, m->v, sizeof m->v);
    got[0] = got[VERTICES * FLOATS + 1] = 7;
    memcpy(want, got, sizeof got);
    nkw_vertices_view in = {{got + 1, s}, {got + 1 + normals, s}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span out = {{got + 1, s}, {got + 1 + normals, s}, {NULL, 0}, {NULL, 0}};
    for (size_t i = 0; i < VERTICES; i++) {
        nkw_mat4 sum;
        float *p = want + 1 + i * floats, *n = p + normals;
        if (!matrix_of(m, skin->influence_count, i, &sum))
            continue;
        const nkw_vec3 d =
            options.inverse_normals ? inverse_normal(&sum, vec3_at(n)) : nkw_mat4_transform_direction(&sum, vec3_at(n));
        const nkw_vec3 moved = nkw_mat4_transform_point(&sum, vec3_at(p));
        const float w = options.divide_by_weights ? sum.m[15] : 1.0f;
        put_vec3(p, (nkw_vec3){moved.x / w, moved.y / w, moved.z / w});
        put_vec3(n, options.keep_length ? d : unit(d));
    }
    assert_int_equal(nkw_skin_linear(skin, &palette, in, out), NKW_OK);
    expect_floats_bits(got, want, VERTICES * FLOATS + 2);
}

/* With vertices without weights and joints beyond the palette at all places of a group. */
static void every_format_and_count_is_the_sum_of_the_stored_numbers(void **state)
{
    (void)state;
    const nkw_skin_format joint_formats[3] = {NKW_SKIN_U8, NKW_SKIN_U16, NKW_SKIN_U32};
    const nkw_skin_format weight_formats[3] = {NKW_SKIN_U8, NKW_SKIN_U16, NKW_SKIN_F32};
    for (size_t k = 1; k <= 8; k++)
        for (size_t f = 0; f < 9; f++) {
            mesh m = draw(40 + k, k, 0);
            uint8_t joints[VERTICES * 8 * 4], weights[VERTICES * 8 * 4];
            nkw_skin skin = {VERTICES, k, {joints, 0, joint_formats[f % 3]}, {weights, 0, weight_formats[f / 3]}};
            for (size_t i = 0; i < VERTICES; i += 1 + i / 5) {
                m.joints[i * k + i % k] = i % 2 ? JOINTS : 200;
                if (i % 3 == 0)
                    memset(m.weights + i * k, 0, k * sizeof *m.weights);
            }
            encode(&m, k, &skin, joints, weights);
            for (int o = 0; o < 8; o++) {
                const nkw_skin_options options = {o & 1, o >> 1 & 1, o >> 2};
                expect_by_definition(&m, &skin, 3, options);
                expect_by_definition(&m, &skin, FLOATS, options);
            }
        }
}

static void positions_and_normals_alone_are_as_together(void **state)
{
    (void)state;
    for (size_t k = 1; k <= 8; k++) {
        mesh m = draw(60 + k, k, 0);
        uint16_t weights[VERTICES * 8];
        nkw_skin_view floats = {m.weights, 0, NKW_SKIN_F32};
        nkw_skin_span whole = {weights, 0, NKW_SKIN_U16};
        nkw_skin_normalize_weights(floats, k, VERTICES, whole);
        for (int format = 0; format < 2; format++) {
            float together[VERTICES * FLOATS] = {0}, alone[VERTICES * FLOATS] = {0};
            nkw_skin skin = skin_of(&m, k);
            nkw_skin_palette palette = palette_of(m.matrices, NULL, JOINTS, 0);
            nkw_vertices_view in = streams(m.v, FLOATS);
            nkw_vertices_view none = {{NULL, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}}, positions = none, normals = none;
            nkw_vertices_span to = spans(together, FLOATS), to_alone = spans(alone, FLOATS);
            nkw_vertices_span nowhere = {{NULL, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
            if (format)
                skin.weights.data = weights, skin.weights.format = NKW_SKIN_U16;
            positions.positions = in.positions;
            normals.normals = in.normals;
            in.tangents = in.bitangents = none.tangents;
            nkw_skin_linear(&skin, &palette, in, to);
            nkw_skin_linear(&skin, &palette, positions, to_alone);
            nkw_skin_linear(&skin, &palette, normals, to_alone);
            nkw_skin_linear(&skin, &palette, in, nowhere);
            expect_floats_bits(alone, together, VERTICES * FLOATS);
        }
    }
}

/* What is behind the joints that influence a vertex must not matter. */
static void normals_by_their_own_matrices_are_the_same_for_any_number_of_joints(void **state)
{
    (void)state;
    enum { MANY = 257 };
    static nkw_mat4 matrices[MANY];
    static nkw_mat3 normals[MANY];
    memset(matrices, 0xff, sizeof matrices);
    memset(normals, 0xff, sizeof normals);
    for (size_t k = 1; k <= 8; k++) {
        mesh m = draw(90 + k, k, 0);
        nkw_skin skin = skin_of(&m, k);
        nkw_vertices_view in = streams(m.v, FLOATS), tight = {{m.v, 0}, {m.v + 3 * VERTICES, 0}, {NULL, 0}, {NULL, 0}};
        memcpy(matrices, m.matrices, sizeof m.matrices);
        memcpy(normals, m.normals, sizeof m.normals);
        for (size_t i = 0; i < VERTICES; i += 1 + i / 5)
            memset(m.weights + i * k, 0, k * sizeof *m.weights);
        for (int raw = 0; raw < 2; raw++) {
            float few[2][VERTICES * FLOATS] = {{0}}, many[2][VERTICES * FLOATS] = {{0}};
            nkw_skin_palette small = palette_of(m.matrices, m.normals, JOINTS, raw),
                             large = palette_of(matrices, normals, MANY, raw);
            nkw_vertices_span out[2] = {spans(few[0], FLOATS), spans(many[0], FLOATS)};
            nkw_vertices_span out_tight[2] = {
                {{few[1], 0}, {few[1] + 3 * VERTICES, 0}, {NULL, 0}, {NULL, 0}},
                {{many[1], 0}, {many[1] + 3 * VERTICES, 0}, {NULL, 0}, {NULL, 0}},
            };
            nkw_skin_linear(&skin, &small, in, out[0]);
            nkw_skin_linear(&skin, &large, in, out[1]);
            nkw_skin_linear(&skin, &small, tight, out_tight[0]);
            nkw_skin_linear(&skin, &large, tight, out_tight[1]);
            expect_floats_bits(few[0], many[0], VERTICES * FLOATS);
            expect_floats_bits(few[1], many[1], VERTICES * FLOATS);
        }
    }
}

/* As many floats as are there and no more: what lies behind is out of bounds. */
static float *copy_of(const float *v, size_t floats)
{
    float *r = malloc(floats * sizeof *r);
    assert_non_null(r);
    memcpy(r, v, floats * sizeof *r);
    return r;
}

static void any_number_of_vertices_is_as_the_first_of_many(void **state)
{
    (void)state;
    const size_t floats[2] = {3, 6};
    mesh m = draw(80, 4, 0);
    for (size_t n = 1; n < 40; n++)
        for (size_t c = 0; c < 8; c++) {
            const size_t f = floats[c & 1], s = f * sizeof(float);
            float want[VERTICES * 6], *all = copy_of(m.v, (n - 1) * f + 3), *w = copy_of(m.weights, n * 4);
            nkw_skin_palette palette = palette_of(m.matrices, NULL, JOINTS, (int)(c >> 1 & 1));
            nkw_skin many = skin_of(&m, 4), few = many;
            nkw_vertices_view in = {{m.v, s}, {NULL, 0}, {NULL, 0}, {NULL, 0}},
                              in_few = {{all, s}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
            nkw_vertices_span out = {{want, s}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
            nkw_vertices_span out_few = {{all, s}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
            if (c >> 2) {
                in.normals = in.positions, in_few.normals = in_few.positions;
                out.normals = out.positions, out_few.normals = out_few.positions;
                in.positions.data = in_few.positions.data = out.positions.data = out_few.positions.data = NULL;
            }
            memcpy(want, m.v, sizeof want);
            few.vertex_count = n, few.weights.data = w;
            nkw_skin_linear(&many, &palette, in, out);
            nkw_skin_linear(&few, &palette, in_few, out_few);
            expect_floats_bits(all, want, (n - 1) * f + 3);
            free(all), free(w);
        }
}

static void without_influences_their_arrays_may_be_null(void **state)
{
    (void)state;
    mesh m = draw(70, 4, 0);
    const nkw_skin_palette palette = palette_of(m.matrices, m.normals, JOINTS, 0);
    const nkw_skin skin = {VERTICES, 0, {NULL, 16, NKW_SKIN_U8}, {NULL, 16, NKW_SKIN_F32}};
    for (int dual = 0; dual < 2; dual++) {
        float out[VERTICES * FLOATS];
        nkw_vertices_view in = {{m.v, 24}, {m.v + 3, 24}, {NULL, 0}, {NULL, 0}};
        nkw_vertices_span to = {{out, 24}, {out + 3, 24}, {NULL, 0}, {NULL, 0}};
        if (dual)
            nkw_skin_dual_quat(&skin, duals_of(m.duals, JOINTS), in, to);
        else
            nkw_skin_linear(&skin, &palette, in, to);
        expect_floats_bits(out, m.v, VERTICES * 6);
    }
}

/* All together, by itself: the same bits, with tangents and bitangents, between vertices without weights. */
static void a_vertex_is_the_same_alone_by_either_method(void **state)
{
    (void)state;
    for (size_t k = 1; k <= 8; k++)
        for (int method = 0; method < 3; method++) {
            mesh m = draw(100 + k, k, 1);
            const nkw_skin_palette palette = palette_of(m.matrices, method == 1 ? m.normals : NULL, JOINTS, 0);
            float all[VERTICES * FLOATS] = {0}, one[FLOATS] = {0};
            for (size_t i = 0; i < VERTICES; i += 1 + i / 5)
                memset(m.weights + i * k, 0, k * sizeof *m.weights);
            const nkw_skin skin = skin_of(&m, k);
            const nkw_vertices_view in = streams(m.v, FLOATS);
            const nkw_vertices_span to = spans(all, FLOATS), to_one = spans(one, FLOATS);
            if (method == 2)
                nkw_skin_dual_quat(&skin, duals_of(m.duals, JOINTS), in, to);
            else
                nkw_skin_linear(&skin, &palette, in, to);
            for (size_t i = 0; i < VERTICES; i++) {
                const nkw_skin alone = {
                    1, k, {m.joints + k * i, 0, NKW_SKIN_U16}, {m.weights + k * i, 0, NKW_SKIN_F32}};
                const nkw_vertices_view at = streams(m.v + i * FLOATS, FLOATS);
                if (method == 2)
                    nkw_skin_dual_quat(&alone, duals_of(m.duals, JOINTS), at, to_one);
                else
                    nkw_skin_linear(&alone, &palette, at, to_one);
                expect_floats_bits(one, all + i * FLOATS, 12);
            }
        }
}

/* Every vertex at the same place, and at the places of bytes that follow one another. */
static void strides_may_be_shorter_than_a_vector(void **state)
{
    (void)state;
    mesh m = draw(110, 4, 0);
    const nkw_skin skin = skin_of(&m, 4);
    const nkw_skin_palette palette = palette_of(m.matrices, NULL, JOINTS, 0);
    unsigned char *bytes = malloc(12 + 2 * (VERTICES - 1));
    nkw_vec3 packed[VERTICES], got[VERTICES], want[VERTICES];
    assert_non_null(bytes);
    for (size_t i = 0; i < 12 + 2 * (VERTICES - 1); i++)
        bytes[i] = (unsigned char)(i % 4 == 3 ? 0x3f : i * 7);
    for (size_t i = 0; i < VERTICES; i++)
        memcpy(&packed[i], bytes + 2 * i, sizeof packed[i]);
    const nkw_vertices_view in = {{bytes, 2}, {NULL, 0}, {NULL, 0}, {NULL, 0}},
                            in_packed = {{packed, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    const nkw_vertices_span out = {{got, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}},
                            out_packed = {{want, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_skin_linear(&skin, &palette, in, out);
    nkw_skin_linear(&skin, &palette, in_packed, out_packed);
    for (size_t i = 0; i < VERTICES; i++)
        expect_vec3_bits(got[i], want[i]);
    free(bytes);
}

/* Of an odd number of joints, where all joints are even: 4 - j has no low bit for those beyond either. */
static void even_joints_beyond_the_palette_count_as_weight_zero(void **state)
{
    (void)state;
    enum { COUNT = 5 };
    mesh m = draw(28, 4, 1), without = m;
    static unsigned char bytes[VERTICES * 4];
    static uint32_t wide[VERTICES * 4];
    for (size_t i = 0; i < VERTICES * 4; i++) {
        const uint16_t even = (uint16_t)(m.joints[i] & ~1u);
        m.joints[i] = bytes[i] = (unsigned char)even;
        wide[i] = even;
        without.joints[i] = even < COUNT ? even : 0;
        without.weights[i] = even < COUNT ? m.weights[i] : 0;
    }
    const nkw_skin_view joints[3] = {{bytes, 0, NKW_SKIN_U8}, {m.joints, 0, NKW_SKIN_U16}, {wide, 0, NKW_SKIN_U32}};
    for (int dual = 0; dual < 2; dual++)
        for (int f = 0; f < 3; f++) {
            float got[VERTICES * FLOATS] = {0}, want[VERTICES * FLOATS] = {0};
            const nkw_vertices_view in = streams(m.v, FLOATS);
            const nkw_vertices_span to = spans(got, FLOATS), to_want = spans(want, FLOATS);
            const nkw_skin_palette palette = palette_of(m.matrices, NULL, COUNT, 0);
            const nkw_skin skin_want = skin_of(&without, 4), skin = {VERTICES, 4, joints[f], skin_of(&m, 4).weights};
            if (dual) {
                nkw_skin_dual_quat(&skin, duals_of(m.duals, COUNT), in, to);
                nkw_skin_dual_quat(&skin_want, duals_of(m.duals, COUNT), in, to_want);
            } else {
                nkw_skin_linear(&skin, &palette, in, to);
                nkw_skin_linear(&skin_want, &palette, in, to_want);
            }
            expect_floats_bits(got, want, VERTICES * FLOATS);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(directions_are_not_normalized_where_that_is_skipped),
        cmocka_unit_test(every_format_and_count_is_the_sum_of_the_stored_numbers),
        cmocka_unit_test(positions_and_normals_alone_are_as_together),
        cmocka_unit_test(normals_by_their_own_matrices_are_the_same_for_any_number_of_joints),
        cmocka_unit_test(any_number_of_vertices_is_as_the_first_of_many),
        cmocka_unit_test(without_influences_their_arrays_may_be_null),
        cmocka_unit_test(a_vertex_is_the_same_alone_by_either_method),
        cmocka_unit_test(strides_may_be_shorter_than_a_vector),
        cmocka_unit_test(even_joints_beyond_the_palette_count_as_weight_zero),
    };
    return cmocka_run_group_tests_name("skin_layouts", tests, NULL, NULL);
}
