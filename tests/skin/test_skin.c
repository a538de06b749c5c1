/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/skin_mesh.h"

static void linear_blend_is_the_weighted_sum_of_matrices_for_every_count(void **state)
{
    (void)state;
    for (size_t k = 1; k <= 8; k++) {
        mesh m = draw(k, k, 0);
        nkw_skin skin = skin_of(&m, k);
        nkw_skin_palette palette = palette_of(m.matrices, NULL, JOINTS, 0);
        float out[VERTICES * FLOATS] = {0};
        nkw_vertices_view from = streams(m.v, FLOATS);
        nkw_vertices_span to = spans(out, FLOATS);
        nkw_skin_linear(&skin, &palette, from, to);
        for (size_t i = 0; i < VERTICES; i++) {
            nkw_mat4 sum;
            const float *v = m.v + i * FLOATS, *got = out + i * FLOATS;
            blend(&m, m.matrices->m, 16, k, i, sum.m);
            expect_vec3_bits(vec3_at(got), nkw_mat4_transform_point(&sum, vec3_at(v)));
            for (size_t a = 3; a < 12; a += 3)
                expect_vec3_bits(vec3_at(got + a), unit(nkw_mat4_transform_direction(&sum, vec3_at(v + a))));
            expect_bits(got[12], 0);
            expect_bits(got[13], 0);
        }
    }
}

static void normals_go_by_their_own_palette_where_there_is_one(void **state)
{
    (void)state;
    for (size_t k = 1; k <= 8; k++) {
        mesh m = draw(k, k, 0);
        nkw_skin skin = skin_of(&m, k);
        nkw_skin_palette palette = palette_of(m.matrices, m.normals, JOINTS, 0),
                         plain = palette_of(m.matrices, NULL, JOINTS, 0);
        float out[VERTICES * FLOATS] = {0}, other[VERTICES * FLOATS] = {0};
        nkw_vertices_view from = streams(m.v, FLOATS);
        nkw_vertices_span to = spans(out, FLOATS), to_other = spans(other, FLOATS);
        nkw_skin_linear(&skin, &palette, from, to);
        nkw_skin_linear(&skin, &plain, from, to_other);
        for (size_t i = 0; i < VERTICES; i++) {
            nkw_mat3 sum;
            const float *got = out + i * FLOATS;
            blend(&m, m.normals->m, 9, k, i, sum.m);
            expect_vec3_bits(vec3_at(got + 3), unit(nkw_mat3_transform(&sum, vec3_at(m.v + i * FLOATS + 3))));
            expect_vec3_bits(vec3_at(got), vec3_at(other + i * FLOATS));
            expect_vec3_bits(vec3_at(got + 6), vec3_at(other + i * FLOATS + 6));
        }
    }
}

static void a_normal_stays_at_right_angles_under_uneven_scale_by_its_palette(void **state)
{
    (void)state;
    random_source r = random_from(3);
    const uint8_t joint = 0, weight = 255;
    nkw_skin skin = {1, 1, {&joint, 0, NKW_SKIN_U8}, {&weight, 0, NKW_SKIN_U8}};
    for (int n = 0; n < 100; n++) {
        nkw_trs trs = {random_vec3(&r, -2, 2), random_rotation(&r), random_vec3(&r, 0.25f, 4)};
        nkw_mat4 m = nkw_mat4_from_trs(&trs);
        nkw_mat3 block = nkw_mat3_from_mat4(&m), normal = nkw_mat3_normal(&block);
        nkw_skin_palette palette = palette_of(&m, &normal, 1, 0);
        nkw_vec3 v[3] = {{0, 0, 0}, random_direction(&r), {0, 0, 0}};
        v[2] = nkw_vec3_normalize(nkw_vec3_perpendicular(v[1]));
        nkw_vertices_view in = {{&v[0], 0}, {&v[1], 0}, {&v[2], 0}, {NULL, 0}};
        nkw_vertices_span out = {{&v[0], 0}, {&v[1], 0}, {&v[2], 0}, {NULL, 0}};
        nkw_skin_linear(&skin, &palette, in, out);
        expect_near(nkw_vec3_dot(v[1], v[2]), 0, 2e-6);
        expect_near(nkw_vec3_length(v[1]), 1, 2e-7);
        expect_vec3_near(v[0], trs.translation, 0);
    }
}

/* The same vertices contiguous, interleaved, in place: same bits. */
static void every_layout_gives_the_same_bits(void **state)
{
    (void)state;
    mesh m = draw(9, 4, 0);
    nkw_skin skin = skin_of(&m, 4);
    nkw_skin_palette palette = palette_of(m.matrices, NULL, JOINTS, 0);
    float mixed[VERTICES * FLOATS];
    nkw_vec3 tight[2][VERTICES];
    memcpy(mixed, m.v, sizeof mixed);
    for (size_t i = 0; i < VERTICES; i++) {
        tight[0][i] = vec3_at(m.v + i * FLOATS);
        tight[1][i] = vec3_at(m.v + i * FLOATS + 3);
    }
    nkw_vertices_view in_mixed = streams(mixed, FLOATS),
                      in_tight = {{tight[0], 0}, {tight[1], 12}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span out_mixed = spans(mixed, FLOATS),
                      out_tight = {{tight[0], 0}, {tight[1], 12}, {NULL, 0}, {NULL, 0}};
    assert_int_equal(nkw_skin_linear(&skin, &palette, in_mixed, out_mixed), NKW_OK);
    assert_int_equal(nkw_skin_linear(&skin, &palette, in_tight, out_tight), NKW_OK);
    for (size_t i = 0; i < VERTICES; i++) {
        expect_vec3_bits(tight[0][i], vec3_at(mixed + i * FLOATS));
        expect_vec3_bits(tight[1][i], vec3_at(mixed + i * FLOATS + 3));
        expect_floats_bits(mixed + i * FLOATS + 12, m.v + i * FLOATS + 12, 2);
    }
}

static void zero_and_subnormal_and_negative_weights_and_joints_beyond_the_palette(void **state)
{
    (void)state;
    mesh m = draw(12, 4, 0);
    const float weights[7][4] = {{0, 0.5f, 0.25f, 0.25f},   {0, 0, 0, 1},     {0x1p-140f, 0, 0, 0},
                                 {0, -0.0f, 0, -0x1p-149f}, {-0.0f, 0, 0, 0}, {-1, 0, 0, 2},
                                 {0x1p-126f, 0, 0, 0}};
    nkw_vec3 position[VERTICES], normal[VERTICES];
    for (size_t i = 0; i < VERTICES; i++) {
        if (i % 3 == 0)
            memcpy(m.weights + 4 * i, weights[i / 3 % 7], sizeof weights[0]);
        if (i % 5 == 0)
            m.joints[4 * i + i % 4] = JOINTS;
        position[i] = vec3_at(m.v + i * FLOATS);
        normal[i] = vec3_at(m.v + i * FLOATS + 3);
    }
    nkw_skin skin = skin_of(&m, 4);
    nkw_skin_palette palette = palette_of(m.matrices, NULL, JOINTS, 0);
    nkw_vertices_view in = {{position, 0}, {normal, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span out = {{position, 0}, {normal, 0}, {NULL, 0}, {NULL, 0}};
    nkw_skin_linear(&skin, &palette, in, out);
    for (size_t i = 0; i < VERTICES; i++) {
        const nkw_vec3 p = vec3_at(m.v + i * FLOATS), n = vec3_at(m.v + i * FLOATS + 3);
        nkw_mat4 sum;
        const int moved = matrix_of(&m, 4, i, &sum);
        expect_vec3_bits(position[i], moved ? nkw_mat4_transform_point(&sum, p) : p);
        expect_vec3_bits(normal[i], moved ? unit(nkw_mat4_transform_direction(&sum, n)) : n);
    }
}

static void a_vertex_does_not_depend_on_its_neighbours_or_the_count(void **state)
{
    (void)state;
    mesh m = draw(10, 3, 0);
    nkw_skin_palette palette = palette_of(m.matrices, NULL, JOINTS, 0);
    float whole[VERTICES * FLOATS] = {0}, alone[FLOATS] = {0};
    nkw_skin skin = skin_of(&m, 3);
    nkw_vertices_view in = streams(m.v, FLOATS);
    nkw_vertices_span out = spans(whole, FLOATS), out_alone = spans(alone, FLOATS);
    nkw_skin_linear(&skin, &palette, in, out);
    for (size_t i = 0; i < VERTICES; i++) {
        nkw_skin one = {1, 3, {m.joints + 3 * i, 0, NKW_SKIN_U16}, {m.weights + 3 * i, 0, NKW_SKIN_F32}};
        nkw_vertices_view at = streams(m.v + i * FLOATS, FLOATS);
        nkw_skin_linear(&one, &palette, at, out_alone);
        expect_floats_bits(alone, whole + i * FLOATS, FLOATS);
    }
}

/* position 3, texture 2, normal 3, four 16-bit joints, four 16-bit weights: 48 bytes. */
typedef struct skeletal_vertex {
    float position[3], texture[2], normal[3];
    uint16_t joints[4], weights[4];
} skeletal_vertex;

static void whole_number_weights_are_their_quotients(void **state)
{
    (void)state;
    random_source r = random_from(11);
    mesh m = draw(11, 4, 0);
    nkw_skin_palette palette = palette_of(m.matrices, NULL, JOINTS, 0);
    skeletal_vertex v[VERTICES];
    uint8_t joints8[VERTICES][4], weights8[VERTICES][4];
    uint32_t joints32[VERTICES][4];
    float w8[VERTICES][4], w16[VERTICES][4];
    nkw_vec3 want[VERTICES], got[VERTICES];
    for (size_t i = 0; i < VERTICES; i++)
        for (size_t e = 0; e < 4; e++) {
            v[i].position[e % 3] = random_between(&r, -1, 1);
            v[i].joints[e] = joints8[i][e] = (uint8_t)(random_bits(&r) % JOINTS);
            joints32[i][e] = joints8[i][e];
            v[i].weights[e] = (uint16_t)random_bits(&r);
            weights8[i][e] = (uint8_t)random_bits(&r);
            w16[i][e] = (float)v[i].weights[e] / 65535.0f;
            w8[i][e] = (float)weights8[i][e] / 255.0f;
        }
    nkw_vertices_view in = {{v->position, sizeof *v}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span out_want = {{want, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}},
                      out_got = {{got, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_skin skins[4] = {
        {VERTICES, 4, {v->joints, sizeof *v, NKW_SKIN_U16}, {v->weights, sizeof *v, NKW_SKIN_U16}},
        {VERTICES, 4, {joints32, 0, NKW_SKIN_U32}, {w16, 0, NKW_SKIN_F32}},
        {VERTICES, 4, {joints8, 0, NKW_SKIN_U8}, {weights8, 4, NKW_SKIN_U8}},
        {VERTICES, 4, {joints32, 16, NKW_SKIN_U32}, {w8, 16, NKW_SKIN_F32}},
    };
    for (size_t s = 0; s < 4; s += 2) {
        nkw_skin_linear(&skins[s], &palette, in, out_got);
        nkw_skin_linear(&skins[s + 1], &palette, in, out_want);
        for (size_t i = 0; i < VERTICES; i++)
            expect_vec3_bits(got[i], want[i]);
    }
}

static void a_vertex_without_weight_is_not_moved(void **state)
{
    (void)state;
    for (int dual = 0; dual < 2; dual++) {
        mesh m = draw(12, 4, 1);
        float out[VERTICES * FLOATS];
        for (size_t i = 0; i < VERTICES; i += 5)
            for (size_t e = 0; e < 4; e++)
                m.weights[i * 4 + e] = e % 2 ? -0.0f : 0.0f;
        m.v[5 * FLOATS] = -0.0f;
        memcpy(out, m.v, sizeof out);
        nkw_skin skin = skin_of(&m, 4);
        nkw_skin_palette palette = palette_of(m.matrices, m.normals, JOINTS, 0);
        nkw_vertices_view in = streams(m.v, FLOATS);
        nkw_vertices_span to = spans(out, FLOATS);
        if (dual)
            nkw_skin_dual_quat(&skin, duals_of(m.duals, JOINTS), in, to);
        else
            nkw_skin_linear(&skin, &palette, in, to);
        for (size_t i = 0; i < VERTICES; i += 5)
            expect_floats_bits(out + i * FLOATS, m.v + i * FLOATS, FLOATS);
        assert_memory_not_equal(out + FLOATS, m.v + FLOATS, 12);
    }
}

/* The palette lies in a heap block of exactly its size, which the sanitizers watch. */
static void a_joint_beyond_the_palette_counts_as_weight_zero(void **state)
{
    (void)state;
    mesh m = draw(13, 4, 0);
    nkw_mat4 *matrices = (nkw_mat4 *)test_malloc(5 * sizeof *matrices);
    memcpy(matrices, m.matrices, 5 * sizeof *matrices);
    nkw_skin_palette palette = palette_of(matrices, NULL, 5, 0);
    float got[VERTICES * FLOATS] = {0}, want[VERTICES * FLOATS] = {0};
    nkw_vertices_view in = streams(m.v, FLOATS);
    nkw_vertices_span out = spans(got, FLOATS), out_want = spans(want, FLOATS);
    nkw_skin skin = skin_of(&m, 4);
    nkw_skin_linear(&skin, &palette, in, out);
    for (size_t i = 0; i < VERTICES * 4; i++)
        if (m.joints[i] >= 5)
            m.joints[i] = 0, m.weights[i] = 0;
    nkw_skin_linear(&skin, &palette, in, out_want);
    expect_floats_bits(got, want, VERTICES * FLOATS);
    test_free(matrices);
}

/* By both methods; joint_count of each palette. */
static void expect_not_moved(const nkw_skin *skin, size_t joint_count, const mesh *m, nkw_result result)
{
    const nkw_skin_palette palette = palette_of(m->matrices, NULL, joint_count, 0);
    for (int dual = 0; dual < 2; dual++) {
        float out[VERTICES * FLOATS] = {0};
        nkw_vertices_view in = streams(m->v, FLOATS);
        nkw_vertices_span to = spans(out, FLOATS);
        nkw_result got = dual ? nkw_skin_dual_quat(skin, duals_of(m->duals, joint_count), in, to)
                              : nkw_skin_linear(skin, &palette, in, to);
        assert_int_equal(got, result);
        for (size_t i = 0; i < VERTICES; i++)
            expect_floats_bits(out + i * FLOATS, m->v + i * FLOATS, 12);
    }
}

static void no_palette_no_influence_and_unknown_formats_move_nothing(void **state)
{
    (void)state;
    mesh m = draw(14, 4, 0);
    nkw_skin skin = skin_of(&m, 4);
    expect_not_moved(&skin, 0, &m, NKW_OK);
    skin.influence_count = 0;
    expect_not_moved(&skin, JOINTS, &m, NKW_OK);
    skin = skin_of(&m, 4);
    skin.joints.format = NKW_SKIN_FORMAT_MAX_ENUM;
    expect_not_moved(&skin, JOINTS, &m, NKW_BAD_FORMAT);
    skin = skin_of(&m, 4);
    skin.weights.format = NKW_SKIN_U32;
    expect_not_moved(&skin, JOINTS, &m, NKW_BAD_FORMAT);
}

static void a_palette_of_another_format_moves_nothing(void **state)
{
    (void)state;
    mesh m = draw(25, 4, 0);
    const nkw_skin skin = skin_of(&m, 4);
    nkw_skin_palette duals = palette_of(m.matrices, NULL, JOINTS, 0),
                     rows = palette_of(m.matrices, m.normals, JOINTS, 0);
    const nkw_palette_view matrices = duals.matrices;
    float out[VERTICES * FLOATS] = {0};
    nkw_vertices_view in = streams(m.v, FLOATS);
    nkw_vertices_span to = spans(out, FLOATS);
    duals.matrices.format = NKW_PALETTE_DUAL_QUAT;
    rows.normals.format = NKW_PALETTE_NORMAL_ROWS;
    for (int which = 0; which < 3; which++) {
        memset(out, 0, sizeof out);
        assert_int_equal(which == 0   ? nkw_skin_dual_quat(&skin, matrices, in, to)
                         : which == 1 ? nkw_skin_linear(&skin, &duals, in, to)
                                      : nkw_skin_linear(&skin, &rows, in, to),
                         NKW_BAD_FORMAT);
        for (size_t i = 0; i < VERTICES; i++)
            expect_floats_bits(out + i * FLOATS, m.v + i * FLOATS, 12);
    }
}

static void no_vertices_and_no_vectors_are_allowed(void **state)
{
    (void)state;
    mesh m = draw(26, 4, 0);
    nkw_skin skin = skin_of(&m, 4);
    const nkw_skin_palette palette = palette_of(m.matrices, m.normals, JOINTS, 0);
    float out[VERTICES * FLOATS] = {0};
    const nkw_vertices_view in = {{NULL, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    const nkw_vertices_span to = {{NULL, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}}, all = spans(out, FLOATS);
    const nkw_vertices_view from = streams(m.v, FLOATS);
    for (int empty = 0; empty < 2; empty++) {
        skin.vertex_count = empty ? 0 : VERTICES;
        assert_int_equal(nkw_skin_linear(&skin, &palette, in, to), NKW_OK);
        assert_int_equal(nkw_skin_linear(&skin, &palette, from, to), NKW_OK);
        assert_int_equal(nkw_skin_linear(&skin, &palette, in, all), NKW_OK);
        assert_int_equal(nkw_skin_dual_quat(&skin, duals_of(m.duals, JOINTS), in, to), NKW_OK);
    }
    assert_int_equal(nkw_skin_linear(&skin, &palette, from, all), NKW_OK);
    for (size_t i = 0; i < VERTICES * FLOATS; i++)
        expect_bits(out[i], 0);
}

/* In 32 bits, where 64 times a joint would be one of the palette again. */
static void joints_from_2_to_the_26_on_count_as_weight_zero(void **state)
{
    (void)state;
    mesh m = draw(27, 4, 1);
    const uint32_t beyond[4] = {1u << 26, (1u << 26) + 3, 1u << 31, UINT32_MAX};
    static uint32_t joints[VERTICES * 4];
    for (size_t i = 0; i < VERTICES * 4; i++) {
        joints[i] = i % 7 == 0 ? beyond[i / 7 % 4] : m.joints[i];
        if (i % 7 == 0)
            m.joints[i] = JOINTS;
    }
    for (int dual = 0; dual < 2; dual++) {
        float got[VERTICES * FLOATS] = {0}, want[VERTICES * FLOATS] = {0};
        const nkw_vertices_view in = streams(m.v, FLOATS);
        const nkw_vertices_span to = spans(got, FLOATS), to_want = spans(want, FLOATS);
        const nkw_skin few = skin_of(&m, 4), wide = {VERTICES, 4, {joints, 0, NKW_SKIN_U32}, few.weights};
        const nkw_skin_palette all = palette_of(m.matrices, NULL, SIZE_MAX, 0),
                               own = palette_of(m.matrices, NULL, JOINTS, 0);
        if (dual) {
            nkw_skin_dual_quat(&wide, duals_of(m.duals, SIZE_MAX), in, to);
            nkw_skin_dual_quat(&few, duals_of(m.duals, JOINTS), in, to_want);
        } else {
            nkw_skin_linear(&wide, &all, in, to);
            nkw_skin_linear(&few, &own, in, to_want);
        }
        expect_floats_bits(got, want, VERTICES * FLOATS);
    }
}

static void the_smaller_palette_limits_the_joints(void **state)
{
    (void)state;
    mesh m = draw(28, 4, 0);
    nkw_mat3 *normals = (nkw_mat3 *)test_malloc(9 * sizeof *normals);
    memcpy(normals, m.normals, 9 * sizeof *normals);
    nkw_skin_palette few = palette_of(m.matrices, normals, JOINTS, 0), both = palette_of(m.matrices, m.normals, 9, 0);
    few.normals.joint_count = 9;
    float got[VERTICES * FLOATS] = {0}, want[VERTICES * FLOATS] = {0};
    const nkw_skin skin = skin_of(&m, 4);
    const nkw_vertices_view in = streams(m.v, FLOATS);
    const nkw_vertices_span to = spans(got, FLOATS), to_want = spans(want, FLOATS);
    nkw_skin_linear(&skin, &few, in, to);
    nkw_skin_linear(&skin, &both, in, to_want);
    expect_floats_bits(got, want, VERTICES * FLOATS);
    test_free(normals);
}

static void a_palette_of_nan_gives_nan_at_weight_zero_too(void **state)
{
    (void)state;
    mesh m = draw(29, 4, 1);
    for (size_t a = 0; a < 16; a++)
        m.matrices[0].m[a] = NAN;
    m.duals[0].real.x = m.duals[0].dual.y = NAN;
    const nkw_skin skin = skin_of(&m, 4);
    const nkw_skin_palette palette = palette_of(m.matrices, NULL, JOINTS, 0);
    for (int dual = 0; dual < 2; dual++) {
        float out[VERTICES * FLOATS] = {0};
        const nkw_vertices_view in = streams(m.v, FLOATS);
        const nkw_vertices_span to = spans(out, FLOATS);
        m.weights[3] = dual ? 0.5f : 0.0f;
        m.joints[3] = 0;
        if (dual)
            nkw_skin_dual_quat(&skin, duals_of(m.duals, JOINTS), in, to);
        else
            nkw_skin_linear(&skin, &palette, in, to);
        for (size_t i = 0; i < VERTICES; i++) {
            int is_nan = 0;
            for (size_t e = 0; e < 4; e++)
                is_nan |= m.joints[4 * i + e] == 0;
            for (size_t c = 0; c < 6; c++)
                assert_int_equal(out[i * FLOATS + c] != out[i * FLOATS + c], is_nan);
        }
    }
}

static void directions_far_below_the_normal_floats_become_zero(void **state)
{
    (void)state;
    const nkw_mat4 identity = nkw_mat4_identity();
    const nkw_skin_palette palette = palette_of(&identity, NULL, 1, 0), raw = palette_of(&identity, NULL, 1, 1);
    const uint8_t joints[3] = {0, 0, 0}, weights[3] = {255, 255, 255};
    const nkw_skin skin = {3, 1, {joints, 0, NKW_SKIN_U8}, {weights, 0, NKW_SKIN_U8}};
    const nkw_vec3 n[3] = {{1e-30f, 0, 0}, {0, 1e-18f, 0}, {0, 0, 1e18f}};
    const nkw_vec3 want[3] = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    nkw_vec3 got[3], same[3];
    const nkw_vertices_view in = {{NULL, 0}, {n, 0}, {NULL, 0}, {NULL, 0}};
    const nkw_vertices_span out = {{NULL, 0}, {got, 0}, {NULL, 0}, {NULL, 0}},
                            to_same = {{NULL, 0}, {same, 0}, {NULL, 0}, {NULL, 0}};
    nkw_skin_linear(&skin, &palette, in, out);
    nkw_skin_linear(&skin, &raw, in, to_same);
    for (size_t i = 0; i < 3; i++) {
        expect_vec3_near(got[i], want[i], 2e-7);
        expect_vec3_bits(same[i], n[i]);
    }
}

static void influences_beyond_the_eighth_are_not_read(void **state)
{
    (void)state;
    mesh m = draw(15, 8, 0);
    nkw_skin_palette palette = palette_of(m.matrices, NULL, JOINTS, 0);
    float got[VERTICES * FLOATS] = {0}, want[VERTICES * FLOATS] = {0};
    nkw_vertices_view in = streams(m.v, FLOATS);
    nkw_vertices_span out = spans(got, FLOATS), out_want = spans(want, FLOATS);
    nkw_skin skin = {VERTICES / 2, 8, {m.joints, 32, NKW_SKIN_U16}, {m.weights, 64, NKW_SKIN_F32}};
    nkw_skin_linear(&skin, &palette, in, out_want);
    skin.influence_count = 16;
    nkw_skin_linear(&skin, &palette, in, out);
    expect_floats_bits(got, want, VERTICES * FLOATS);
}

static void zero_normals_stay_zero_and_nan_stays_in_its_vertex(void **state)
{
    (void)state;
    mesh m = draw(16, 4, 0);
    nkw_skin_palette palette = palette_of(m.matrices, NULL, JOINTS, 0);
    float out[VERTICES * FLOATS] = {0}, clean[VERTICES * FLOATS] = {0};
    m.v[3] = m.v[4] = m.v[5] = 0;
    nkw_skin skin = skin_of(&m, 4);
    nkw_vertices_view in = streams(m.v, FLOATS);
    nkw_vertices_span to = spans(out, FLOATS), to_clean = spans(clean, FLOATS);
    nkw_skin_linear(&skin, &palette, in, to_clean);
    for (size_t c = 3; c < 6; c++)
        expect_near(clean[c], 0, 0);
    m.weights[4 * 70] = NAN;
    nkw_skin_linear(&skin, &palette, in, to);
    expect_nan(out[70 * FLOATS]);
    expect_floats_bits(out, clean, 70 * FLOATS);
    expect_floats_bits(out + 71 * FLOATS, clean + 71 * FLOATS, (VERTICES - 71) * FLOATS);
}

static void one_rigid_joint_is_the_same_either_way(void **state)
{
    (void)state;
    mesh m = draw(17, 1, 1);
    nkw_skin skin = skin_of(&m, 1);
    nkw_skin_palette palette = palette_of(m.matrices, NULL, JOINTS, 0);
    float linear[VERTICES * FLOATS] = {0}, dual[VERTICES * FLOATS] = {0};
    nkw_vertices_view in = streams(m.v, FLOATS);
    nkw_vertices_span out = spans(linear, FLOATS), out_dual = spans(dual, FLOATS);
    nkw_skin_linear(&skin, &palette, in, out);
    nkw_skin_dual_quat(&skin, duals_of(m.duals, JOINTS), in, out_dual);
    expect_floats_near(dual, linear, VERTICES * FLOATS, 2e-6);
}

/* Half of nothing and half of a turn by 90 degrees about x through the point (0, 1, 0) is a turn by 45 about it. */
static void half_of_a_turn_is_a_turn_by_half_the_angle(void **state)
{
    (void)state;
    nkw_vec3 x = {1, 0, 0}, pivot = {0, 1, 0}, p = {0.5f, 3, 0};
    nkw_quat turn = nkw_quat_from_axis_angle(x, 1.57079633f), half = nkw_quat_from_axis_angle(x, 0.785398163f);
    nkw_dual_quat palette[2] = {dual_quat(nkw_quat_identity(), nkw_vec3_sub(pivot, pivot)),
                                dual_quat(turn, nkw_vec3_sub(pivot, nkw_quat_rotate(turn, pivot)))};
    const uint8_t joints[2] = {0, 1};
    const float weights[2] = {0.5f, 0.5f};
    nkw_skin skin = {1, 2, {joints, 0, NKW_SKIN_U8}, {weights, 0, NKW_SKIN_F32}};
    nkw_vec3 want = nkw_vec3_add(pivot, nkw_quat_rotate(half, nkw_vec3_sub(p, pivot))), got;
    nkw_vertices_view in = {{&p, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span out = {{&got, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_skin_dual_quat(&skin, duals_of(palette, 2), in, out);
    expect_vec3_near(got, want, 5e-7);
}

static void the_sign_of_a_dual_quaternion_does_not_matter(void **state)
{
    (void)state;
    random_source r = random_from(18);
    for (size_t k = 1; k <= 8; k++) {
        mesh m = draw(18 + k, k, 1);
        float want[VERTICES * FLOATS] = {0}, got[VERTICES * FLOATS] = {0};
        nkw_skin skin = skin_of(&m, k);
        nkw_vertices_view in = streams(m.v, FLOATS);
        nkw_vertices_span out = spans(want, FLOATS), out_got = spans(got, FLOATS);
        nkw_skin_dual_quat(&skin, duals_of(m.duals, JOINTS), in, out);
        for (size_t j = 0; j < JOINTS; j++)
            if (random_bits(&r) & 1) {
                nkw_quat q = m.duals[j].real, d = m.duals[j].dual;
                nkw_dual_quat negated = {{-q.x, -q.y, -q.z, -q.w}, {-d.x, -d.y, -d.z, -d.w}};
                m.duals[j] = negated;
            }
        nkw_skin_dual_quat(&skin, duals_of(m.duals, JOINTS), in, out_got);
        expect_floats_bits(got, want, VERTICES * FLOATS);
    }
}

static void dual_quaternions_keep_lengths(void **state)
{
    (void)state;
    mesh m = draw(19, 4, 1);
    nkw_skin skin = skin_of(&m, 4);
    float out[VERTICES * FLOATS] = {0}, other[VERTICES * FLOATS] = {0};
    nkw_vertices_view in = streams(m.v, FLOATS), in_normals = in;
    in_normals.positions = in.normals;
    nkw_vertices_span to = spans(out, FLOATS), to_other = spans(other, FLOATS);
    nkw_skin_dual_quat(&skin, duals_of(m.duals, JOINTS), in, to);
    nkw_skin_dual_quat(&skin, duals_of(m.duals, JOINTS), in_normals, to_other);
    for (size_t i = 0; i < VERTICES; i++) {
        float before = nkw_vec3_distance(vec3_at(m.v + i * FLOATS), vec3_at(m.v + i * FLOATS + 3));
        float after = nkw_vec3_distance(vec3_at(out + i * FLOATS), vec3_at(other + i * FLOATS));
        expect_near(after, before, 5e-6);
    }
}

static void dual_quaternions_that_cancel_move_nothing(void **state)
{
    (void)state;
    const nkw_dual_quat palette[1] = {{{0, 0, 0, 0}, {0, 1, 0, 0}}};
    const uint8_t joint = 0, weight = 255;
    nkw_skin skin = {1, 1, {&joint, 0, NKW_SKIN_U8}, {&weight, 0, NKW_SKIN_U8}};
    nkw_vec3 p = {1, 2, 3}, want = p;
    nkw_vertices_view in = {{&p, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span out = {{&p, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_skin_dual_quat(&skin, duals_of(palette, 1), in, out);
    expect_vec3_bits(p, want);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(linear_blend_is_the_weighted_sum_of_matrices_for_every_count),
        cmocka_unit_test(normals_go_by_their_own_palette_where_there_is_one),
        cmocka_unit_test(a_normal_stays_at_right_angles_under_uneven_scale_by_its_palette),
        cmocka_unit_test(every_layout_gives_the_same_bits),
        cmocka_unit_test(zero_and_subnormal_and_negative_weights_and_joints_beyond_the_palette),
        cmocka_unit_test(a_vertex_does_not_depend_on_its_neighbours_or_the_count),
        cmocka_unit_test(whole_number_weights_are_their_quotients),
        cmocka_unit_test(a_vertex_without_weight_is_not_moved),
        cmocka_unit_test(a_joint_beyond_the_palette_counts_as_weight_zero),
        cmocka_unit_test(no_palette_no_influence_and_unknown_formats_move_nothing),
        cmocka_unit_test(a_palette_of_another_format_moves_nothing),
        cmocka_unit_test(no_vertices_and_no_vectors_are_allowed),
        cmocka_unit_test(joints_from_2_to_the_26_on_count_as_weight_zero),
        cmocka_unit_test(the_smaller_palette_limits_the_joints),
        cmocka_unit_test(a_palette_of_nan_gives_nan_at_weight_zero_too),
        cmocka_unit_test(directions_far_below_the_normal_floats_become_zero),
        cmocka_unit_test(influences_beyond_the_eighth_are_not_read),
        cmocka_unit_test(zero_normals_stay_zero_and_nan_stays_in_its_vertex),
        cmocka_unit_test(one_rigid_joint_is_the_same_either_way),
        cmocka_unit_test(half_of_a_turn_is_a_turn_by_half_the_angle),
        cmocka_unit_test(the_sign_of_a_dual_quaternion_does_not_matter),
        cmocka_unit_test(dual_quaternions_keep_lengths),
        cmocka_unit_test(dual_quaternions_that_cancel_move_nothing),
    };
    return cmocka_run_group_tests_name("skin", tests, NULL, NULL);
}
