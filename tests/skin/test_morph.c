/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

enum { VERTICES = 1337, TARGETS = 7, SPARSE = 60 };

typedef struct face {
    nkw_vec3 base[VERTICES], normals[VERTICES], deltas[TARGETS][VERTICES], normal_deltas[TARGETS][VERTICES];
    uint32_t indices[SPARSE];
    nkw_morph_target targets[TARGETS];
    nkw_morph morph;
    float weights[TARGETS];
} face;

static nkw_vec3_stream_view stream(const void *data, size_t stride)
{
    nkw_vec3_stream_view v = {data, stride};
    return v;
}

static nkw_vec3_stream_span stream_span(void *data, size_t stride)
{
    nkw_vec3_stream_span v = {data, stride};
    return v;
}

/* Targets 2 and 5 are sparse. */
static void draw_face(random_source *r, face *f)
{
    memset(f->targets, 0, sizeof f->targets);
    for (size_t i = 0; i < VERTICES; i++) {
        f->base[i] = random_vec3(r, -2, 2);
        f->normals[i] = random_direction(r);
        for (size_t t = 0; t < TARGETS; t++) {
            f->deltas[t][i] = random_vec3(r, -1, 1);
            f->normal_deltas[t][i] = random_vec3(r, -1, 1);
        }
    }
    for (size_t k = 0; k < SPARSE; k++)
        f->indices[k] = (uint32_t)(random_bits(r) % VERTICES);
    for (size_t t = 0; t < TARGETS; t++) {
        f->weights[t] = random_between(r, -1, 1);
        f->targets[t].deltas.positions = stream(f->deltas[t], 0);
        f->targets[t].deltas.normals = stream(f->normal_deltas[t], 12);
        f->targets[t].indices = t == 2 || t == 5 ? f->indices : NULL;
        f->targets[t].count = SPARSE;
    }
    nkw_morph morph = {f->targets, TARGETS, VERTICES};
    f->morph = morph;
}

static nkw_vec3 add(nkw_vec3 v, float w, nkw_vec3 d)
{
    return nkw_vec3_add_scaled(v, d, w);
}

/* Vertex by vertex, target by target. */
static nkw_vec3 expected(const face *f, size_t i, int normals)
{
    nkw_vec3 v = normals ? f->normals[i] : f->base[i];
    for (size_t t = 0; t < TARGETS; t++) {
        const nkw_vec3 *d = normals ? f->normal_deltas[t] : f->deltas[t];
        if (f->weights[t] == 0.0f)
            continue;
        if (!f->targets[t].indices)
            v = add(v, f->weights[t], d[i]);
        for (size_t k = 0; f->targets[t].indices && k < SPARSE; k++)
            if (f->indices[k] == i)
                v = add(v, f->weights[t], d[k]);
    }
    return v;
}

static face f;

static void vectors_are_summed_in_the_order_of_the_targets(void **state)
{
    (void)state;
    static nkw_vec3 positions[VERTICES], normals[VERTICES];
    random_source r = random_from(1);
    for (int round = 0; round < 4; round++) {
        draw_face(&r, &f);
        f.weights[(size_t)round] = round % 2 ? 0.0f : -0.0f;
        nkw_vertices_view in = {stream(f.base, 0), stream(f.normals, 0), {NULL, 0}, {NULL, 0}};
        nkw_vertices_span out = {stream_span(positions, 12), stream_span(normals, 0), {NULL, 0}, {NULL, 0}};
        nkw_morph_apply(&f.morph, f.weights, in, out);
        for (size_t i = 0; i < VERTICES; i++) {
            expect_vec3_bits(positions[i], expected(&f, i, 0));
            expect_vec3_bits(normals[i], expected(&f, i, 1));
        }
    }
}

static void strides_alignment_and_place_change_no_bit(void **state)
{
    (void)state;
    enum { STRIDE = 31 };
    static unsigned char in[VERTICES * STRIDE + 16], out[VERTICES * STRIDE + 16];
    static nkw_vec3 place[VERTICES];
    random_source r = random_from(2);
    draw_face(&r, &f);
    for (size_t i = 0; i < VERTICES; i++)
        memcpy(in + 1 + i * STRIDE, &f.base[i], sizeof f.base[i]);
    memset(out, 0x5a, sizeof out);
    memcpy(place, f.base, sizeof place);
    nkw_vertices_view from = {stream(in + 1, STRIDE), {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span to = {stream_span(out + 1, STRIDE), {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_morph_apply(&f.morph, f.weights, from, to);
    nkw_vertices_view same = {stream(place, 0), {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span same_out = {stream_span(place, 0), {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_morph_apply(&f.morph, f.weights, same, same_out);
    for (size_t i = 0; i < VERTICES; i++) {
        nkw_vec3 got;
        memcpy(&got, out + 1 + i * STRIDE, sizeof got);
        expect_vec3_bits(got, expected(&f, i, 0));
        expect_vec3_bits(place[i], got);
        /* The bytes between the vectors. */
        for (size_t k = 12; k < STRIDE; k++)
            assert_int_equal(out[1 + i * STRIDE + k], 0x5a);
    }
    assert_int_equal(out[0], 0x5a);
}

/* Packed vectors at any byte, of the output or of a target; and a target with gaps beside a packed output. */
static void packed_vectors_may_be_at_odd_addresses(void **state)
{
    (void)state;
    enum { GAP = 16 };
    static unsigned char out[sizeof(nkw_vec3) * VERTICES + 4], packed[sizeof(nkw_vec3) * VERTICES + 4],
        wide[GAP * VERTICES];
    random_source r = random_from(6);
    draw_face(&r, &f);
    for (size_t i = 0; i < VERTICES; i++)
        memcpy(wide + GAP * i, &f.deltas[1][i], sizeof(nkw_vec3));
    f.targets[1].deltas.positions = stream(wide, GAP);
    for (size_t odd = 0; odd < 4; odd++) {
        memcpy(packed + odd, f.deltas[0], sizeof f.deltas[0]);
        f.targets[0].deltas.positions = stream(packed + odd, 0);
        for (size_t at = 0; at < 4; at++) {
            nkw_vertices_view in = {stream(f.base, 0), {NULL, 0}, {NULL, 0}, {NULL, 0}};
            nkw_vertices_span to = {stream_span(out + at, 0), {NULL, 0}, {NULL, 0}, {NULL, 0}};
            nkw_morph_apply(&f.morph, f.weights, in, to);
            for (size_t i = 0; i < VERTICES; i++) {
                nkw_vec3 got;
                memcpy(&got, out + at + i * sizeof got, sizeof got);
                expect_vec3_bits(got, expected(&f, i, 0));
            }
        }
    }
}

static void targets_without_weight_are_not_read(void **state)
{
    (void)state;
    static nkw_vec3 out[VERTICES];
    random_source r = random_from(3);
    draw_face(&r, &f);
    memset(f.weights, 0, sizeof f.weights);
    for (size_t t = 0; t < TARGETS; t++) {
        f.deltas[t][5].x = NAN;
        f.weights[t] = t % 2 ? 0.0f : -0.0f;
    }
    nkw_vertices_view in = {stream(f.base, 0), {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span to = {stream_span(out, 0), {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_morph_apply(&f.morph, f.weights, in, to);
    expect_floats_bits(&out[0].x, &f.base[0].x, 3 * VERTICES);
    f.targets[1].deltas.positions.data = NULL;
    f.weights[1] = 1;
    nkw_morph_apply(&f.morph, f.weights, in, to);
    expect_floats_bits(&out[0].x, &f.base[0].x, 3 * VERTICES);
    f.morph.target_count = 0;
    out[7].y = 99;
    nkw_morph_apply(&f.morph, NULL, in, to);
    expect_floats_bits(&out[0].x, &f.base[0].x, 3 * VERTICES);
    f.morph.vertex_count = 0;
    nkw_morph_apply(&f.morph, NULL, in, to);
}

/* Sparse targets without weight, or without differences of a stream, and streams with one side only. */
static void what_is_not_there_has_no_effect(void **state)
{
    (void)state;
    static nkw_vec3 out[VERTICES], out_normals[VERTICES], want[VERTICES], want_normals[VERTICES];
    random_source r = random_from(5);
    draw_face(&r, &f);
    f.targets[2].deltas.normals.data = NULL;
    f.weights[5] = 0;
    f.targets[3].indices = f.indices; /* sparse after a sparse one that has weight */
    f.weights[3] = 0;
    f.targets[6].deltas.positions.data = NULL;
    nkw_vertices_view in = {stream(f.base, 0), stream(f.normals, 0), {NULL, 0}, {NULL, 0}};
    nkw_vertices_span to = {stream_span(out, 0), stream_span(out_normals, 0), {NULL, 0}, {NULL, 0}};
    nkw_morph_apply(&f.morph, f.weights, in, to);
    for (size_t i = 0; i < VERTICES; i++) {
        want[i] = f.base[i];
        want_normals[i] = f.normals[i];
        for (size_t t = 0; t < TARGETS; t++) {
            if (t != 2 && t != 3 && t < 5)
                want[i] = add(want[i], f.weights[t], f.deltas[t][i]);
            for (size_t k = 0; t == 2 && k < SPARSE; k++)
                if (f.indices[k] == i)
                    want[i] = add(want[i], f.weights[t], f.deltas[t][k]);
            if (t != 2 && t != 3 && t != 5)
                want_normals[i] = add(want_normals[i], f.weights[t], f.normal_deltas[t][i]);
        }
    }
    expect_floats_bits(&out[0].x, &want[0].x, 3 * VERTICES);
    expect_floats_bits(&out_normals[0].x, &want_normals[0].x, 3 * VERTICES);
    /* An input without an output, an output without an input. */
    to.normals.data = NULL;
    in.tangents = stream(f.normals, 0);
    in.positions.data = NULL;
    out[3].y = 77;
    nkw_morph_apply(&f.morph, f.weights, in, to);
    expect_bits(out[3].y, 77);
}

static void indices_after_the_last_are_not_used(void **state)
{
    (void)state;
    const uint32_t indices[4] = {3, 1, UINT32_MAX, 1};
    const nkw_vec3 deltas[4] = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {0.5f, 0, 0}},
                   base[3] = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    const nkw_vec3 moved = {10, 11, 13};
    nkw_vec3 out[3];
    nkw_morph_target target = {{stream(deltas, 0), {NULL, 0}, {NULL, 0}, {NULL, 0}}, indices, 4};
    nkw_morph morph = {&target, 1, 3};
    nkw_vertices_view in = {stream(base, 0), {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span to = {stream_span(out, 0), {NULL, 0}, {NULL, 0}, {NULL, 0}};
    const float weight = 2;
    nkw_morph_apply(&morph, &weight, in, to);
    expect_vec3_bits(out[0], base[0]);
    expect_vec3_bits(out[1], moved);
    expect_vec3_bits(out[2], base[2]);
    size_t bad = 9;
    assert_int_equal(nkw_morph_validate(&morph, &bad), NKW_OUT_OF_RANGE);
    assert_int_equal(bad, 0);
}

static void validate_names_the_first_offender(void **state)
{
    (void)state;
    random_source r = random_from(4);
    size_t bad = 9;
    draw_face(&r, &f);
    assert_int_equal(nkw_morph_validate(&f.morph, &bad), NKW_OK);
    assert_int_equal(bad, 0);
    f.normal_deltas[4][VERTICES - 1].z = INFINITY;
    assert_int_equal(nkw_morph_validate(&f.morph, &bad), NKW_NOT_FINITE);
    assert_int_equal(bad, 4);
    f.deltas[2][SPARSE].z = NAN;
    assert_int_equal(nkw_morph_validate(&f.morph, NULL), NKW_NOT_FINITE);
    f.indices[SPARSE - 1] = VERTICES;
    assert_int_equal(nkw_morph_validate(&f.morph, &bad), NKW_OUT_OF_RANGE);
    assert_int_equal(bad, 2);
    f.morph.vertex_count = 0;
    assert_int_equal(nkw_morph_validate(&f.morph, &bad), NKW_EMPTY);
    assert_int_equal(bad, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vectors_are_summed_in_the_order_of_the_targets),
        cmocka_unit_test(strides_alignment_and_place_change_no_bit),
        cmocka_unit_test(targets_without_weight_are_not_read),
        cmocka_unit_test(indices_after_the_last_are_not_used),
        cmocka_unit_test(validate_names_the_first_offender),
        cmocka_unit_test(what_is_not_there_has_no_effect),
        cmocka_unit_test(packed_vectors_may_be_at_odd_addresses),
    };
    return cmocka_run_group_tests_name("morph", tests, NULL, NULL);
}
