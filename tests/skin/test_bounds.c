/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/views.h"

enum { VERTICES = 400, JOINTS = 12, INFLUENCES = 4 };

typedef struct mesh_case {
    nkw_vec3 positions[VERTICES], skinned[VERTICES];
    uint16_t joints[VERTICES * INFLUENCES];
    float weights[VERTICES * INFLUENCES];
    unsigned char bytes[VERTICES * INFLUENCES];
    nkw_mat4 palette[JOINTS];
    nkw_mat3x4 rows[JOINTS];
    nkw_box boxes[JOINTS + 1];
    nkw_skin skin;
} mesh_case;

static int is_empty(const nkw_box *box)
{
    return !(box->low.x <= box->high.x && box->low.y <= box->high.y && box->low.z <= box->high.z);
}

static nkw_box with_point(const nkw_box *box, nkw_vec3 p)
{
    const nkw_box point = {p, p};
    return nkw_box_union(box, &point);
}

static mesh_case m;

static int contains(const nkw_box *box, nkw_vec3 p)
{
    return box->low.x <= p.x && p.x <= box->high.x && box->low.y <= p.y && p.y <= box->high.y && box->low.z <= p.z &&
           p.z <= box->high.z;
}

/* Weights sum to 1 to rounding; a few vertices have none. */
static void draw_mesh(random_source *r, int scaled, float size)
{
    for (size_t i = 0; i < VERTICES; i++) {
        m.positions[i] = random_vec3(r, -size, size);
        for (size_t k = 0; k < INFLUENCES; k++) {
            size_t at = INFLUENCES * i + k;
            m.joints[at] = (uint16_t)(random_bits(r) % JOINTS);
            m.weights[at] = i % 50 == 7 || random_bits(r) % 4 == 0 ? 0.0f : random_unit(r);
        }
    }
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_vec3 scale = scaled ? random_vec3(r, -2, 2) : (nkw_vec3){1, 1, 1};
        nkw_trs trs = {random_vec3(r, -3, 3), random_rotation(r), scale};
        m.palette[j] = nkw_mat4_from_trs(&trs);
        m.rows[j] = nkw_mat3x4_from_mat4(&m.palette[j]);
    }
    nkw_skin skin = {VERTICES, INFLUENCES, {m.joints, 0, NKW_SKIN_U16}, {m.weights, 0, NKW_SKIN_F32}};
    nkw_skin_span weights = {m.weights, 0, NKW_SKIN_F32}, bytes = {m.bytes, 0, NKW_SKIN_U8};
    nkw_skin_normalize_weights(skin.weights, INFLUENCES, VERTICES, bytes);
    nkw_skin_normalize_weights(skin.weights, INFLUENCES, VERTICES, weights);
    m.skin = skin;
}

static void skin_mesh(void)
{
    nkw_skin_palette palette = {palette_view(NKW_PALETTE_MAT4, m.palette, JOINTS), {NULL, 0, NKW_PALETTE_MAT4}, {0, 0, 0}};
    nkw_vertices_view in = {{m.positions, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span out = {{m.skinned, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_skin_linear(&m.skin, &palette, in, out);
}

static nkw_vec3_stream_view positions(void)
{
    nkw_vec3_stream_view v = {m.positions, 0};
    return v;
}

static void every_skinned_vertex_is_inside(void **state)
{
    (void)state;
    random_source r = random_from(1);
    double looseness = 0;
    for (int round = 0; round < 400; round++) {
        static const float sizes[] = {1, 1e-6f, 1e6f, 1e-30f};
        draw_mesh(&r, round % 2, sizes[round % 4]);
        if (round % 3 == 0) {
            nkw_skin_view bytes = {m.bytes, 0, NKW_SKIN_U8};
            m.skin.weights = bytes;
        }
        nkw_box box, same;
        assert_int_equal(nkw_box_from_skin(&m.skin, positions(), m.boxes, JOINTS), NKW_OK);
        assert_int_equal(nkw_box_from_palette(palette_view(NKW_PALETTE_MAT4, m.palette, JOINTS), m.boxes, &box),
                         NKW_OK);
        assert_int_equal(nkw_box_from_palette(palette_view(NKW_PALETTE_MAT3X4, m.rows, JOINTS), m.boxes, &same),
                         NKW_OK);
        expect_floats_bits(&same.low.x, &box.low.x, 6);
        skin_mesh();
        nkw_box tight = NKW_BOX_EMPTY;
        for (size_t i = 0; i < VERTICES; i++) {
            assert_true(contains(&box, m.skinned[i]));
            tight = with_point(&tight, m.skinned[i]);
        }
        if (round % 4 == 0)
            looseness = fmax(looseness, (double)((box.high.x - box.low.x) / (tight.high.x - tight.low.x)));
    }
    /* Not the box of all points either. */
    assert_true(looseness < 4);
}

static void one_joint_has_the_box_of_its_vertices(void **state)
{
    (void)state;
    random_source r = random_from(2);
    draw_mesh(&r, 0, 1);
    for (size_t j = 0; j < JOINTS; j++)
        m.palette[j] = nkw_mat4_identity();
    nkw_box_from_skin(&m.skin, positions(), m.boxes, JOINTS);
    nkw_box box, want = NKW_BOX_EMPTY;
    nkw_box_from_palette(palette_view(NKW_PALETTE_MAT4, m.palette, JOINTS), m.boxes, &box);
    for (size_t i = 0; i < VERTICES; i++)
        want = with_point(&want, m.positions[i]);
    expect_vec3_near(box.low, want.low, 1e-5);
    expect_vec3_near(box.high, want.high, 1e-5);
    for (size_t j = 0; j < JOINTS; j++)
        for (size_t i = 0; i < VERTICES; i++)
            for (size_t k = 0; k < INFLUENCES; k++)
                if (m.joints[INFLUENCES * i + k] == j && m.weights[INFLUENCES * i + k] > 0.0f)
                    assert_true(contains(&m.boxes[j], m.positions[i]));
}

static void vertices_without_influence_stay_where_they_are(void **state)
{
    (void)state;
    random_source r = random_from(3);
    draw_mesh(&r, 0, 1);
    nkw_box_from_skin(&m.skin, positions(), m.boxes, JOINTS);
    assert_true(contains(&m.boxes[JOINTS], m.positions[7]) && contains(&m.boxes[JOINTS], m.positions[57]));
    /* No joints: all vertices. */
    nkw_box_from_skin(&m.skin, positions(), m.boxes, 0);
    nkw_box box;
    nkw_box_from_palette(palette_view(NKW_PALETTE_MAT4, NULL, 0), m.boxes, &box);
    for (size_t i = 0; i < VERTICES; i++)
        assert_true(contains(&box, m.positions[i]));
    /* No vertices: nothing. */
    m.skin.vertex_count = 0;
    nkw_box_from_skin(&m.skin, positions(), m.boxes, JOINTS);
    nkw_box_from_palette(palette_view(NKW_PALETTE_MAT4, m.palette, JOINTS), m.boxes, &box);
    assert_int_equal(is_empty(&box), 1);
}

static void formats_that_do_not_fit_write_nothing(void **state)
{
    (void)state;
    random_source r = random_from(4);
    draw_mesh(&r, 0, 1);
    nkw_box box = {{1, 2, 3}, {4, 5, 6}}, same = box;
    assert_int_equal(nkw_box_from_palette(palette_view(NKW_PALETTE_DUAL_QUAT, m.palette, 1), m.boxes, &box),
                     NKW_BAD_FORMAT);
    expect_floats_bits(&box.low.x, &same.low.x, 6);
    m.skin.joints.format = NKW_SKIN_FORMAT_MAX_ENUM;
    m.boxes[0] = same;
    assert_int_equal(nkw_box_from_skin(&m.skin, positions(), m.boxes, JOINTS), NKW_BAD_FORMAT);
    expect_floats_bits(&m.boxes[0].low.x, &same.low.x, 6);
}

static void without_positions_all_boxes_are_empty(void **state)
{
    (void)state;
    random_source r = random_from(6);
    draw_mesh(&r, 0, 1);
    const nkw_vec3_stream_view none = {NULL, 0};
    assert_int_equal(nkw_box_from_skin(&m.skin, none, m.boxes, JOINTS), NKW_OK);
    for (int j = 0; j <= JOINTS; j++)
        assert_int_equal(is_empty(&m.boxes[j]), 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_skinned_vertex_is_inside),
        cmocka_unit_test(one_joint_has_the_box_of_its_vertices),
        cmocka_unit_test(vertices_without_influence_stay_where_they_are),
        cmocka_unit_test(formats_that_do_not_fit_write_nothing),
        cmocka_unit_test(without_positions_all_boxes_are_empty),
    };
    return cmocka_run_group_tests_name("bounds", tests, NULL, NULL);
}
