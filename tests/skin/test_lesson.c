/* SPDX-License-Identifier: MIT */
/* Numbers of docs/joints.md: the lesson's capsule with vectors and weights stored in fewer bits. */
#include "expect.h"

#include "mesh.h"
#include "page.h"
#include "quantized.h"
#include "rig.h"

enum { VERTICES = 512, TIMES = 41 };

/* What is stored in integers, the others in floats. */
typedef enum stored { POSITIONS, NORMALS, WEIGHTS } stored;

/* The capsule, its weights before they are rounded, and where it is at a time. */
typedef struct lesson {
    mesh body;
    rig rig;
    nkw_box box;
    float weights[VERTICES][RIG_JOINTS];
} lesson;

static void lesson_open(lesson *l)
{
    memset(l, 0, sizeof *l);
    assert_true(mesh_capsule(&l->body) && l->body.vertex_count <= VERTICES);
    assert_null(rig_build(&l->rig, &l->body));
    mesh_box(&l->body, &l->box.low, &l->box.high);
    for (size_t i = 0; i < l->body.vertex_count; i++)
        rig_weights(&l->rig, l->body.vertices[i].position.y, l->weights[i]);
}

static void lesson_close(lesson *l)
{
    rig_free(&l->rig);
    mesh_free(&l->body);
}

typedef struct moved {
    nkw_vec3 positions[VERTICES], normals[VERTICES];
} moved;

/* bits of 0: floats. */
static void move(const lesson *l, const rig_state *state, stored what, int bits, moved *out)
{
    static nkw_vec3 positions[VERTICES], normals[VERTICES];
    static uint8_t bytes[VERTICES][RIG_JOINTS];
    static uint16_t words[VERTICES][RIG_JOINTS], joints[VERTICES][RIG_JOINTS];
    const size_t count = l->body.vertex_count;
    for (size_t i = 0; i < count; i++) {
        positions[i] = l->body.vertices[i].position;
        normals[i] = l->body.vertices[i].normal;
        if (bits && what == POSITIONS)
            positions[i] = quantized_position(positions[i], &l->box, bits);
        if (bits && what == NORMALS)
            normals[i] = quantized_direction(normals[i], bits);
        for (uint16_t j = 0; j < RIG_JOINTS; j++)
            joints[i][j] = j;
    }
    nkw_skin skin = {count, RIG_JOINTS, {joints, 0, NKW_SKIN_U16}, {l->weights, 0, NKW_SKIN_F32}};
    if (bits && what == WEIGHTS) {
        void *data = bits == 8 ? (void *)bytes : (void *)words;
        nkw_skin_span span = {data, 0, bits == 8 ? NKW_SKIN_U8 : NKW_SKIN_U16};
        assert_int_equal(nkw_skin_normalize_weights(skin.weights, RIG_JOINTS, count, span), NKW_OK);
        skin.weights = (nkw_skin_view){data, 0, span.format};
    }
    nkw_skin_palette palette = {{state->palette, RIG_JOINTS, NKW_PALETTE_MAT4}, {NULL, 0, NKW_PALETTE_NORMAL_MAT3}, 0};
    nkw_vertices_view in = {{positions, 0}, {normals, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span span = {{out->positions, 0}, {out->normals, 0}, {NULL, 0}, {NULL, 0}};
    assert_int_equal(nkw_skin_linear(&skin, &palette, in, span), NKW_OK);
}

/* The largest error over the motion: of positions in millimetres at a height of 2 m, or of normals in degrees. */
static double worst(const lesson *l, stored what, int bits)
{
    static moved exact, rounded;
    const double millimetres = 2000.0 / ((double)l->box.high.y - (double)l->box.low.y);
    double most = 0.0;
    for (int k = 0; k < TIMES; k++) {
        rig_state state = rig_at(&l->rig, RIG_END * (float)k / (float)(TIMES - 1));
        move(l, &state, what, 0, &exact);
        move(l, &state, what, bits, &rounded);
        for (size_t i = 0; i < l->body.vertex_count; i++)
            most = fmax(most, what == NORMALS
                                  ? quantized_angle(exact.normals[i], rounded.normals[i])
                                  : millimetres * quantized_distance(exact.positions[i], rounded.positions[i]));
    }
    return most;
}

static void the_capsule_has_the_errors_of_the_page(void **state)
{
    static lesson l;
    (void)state;
    lesson_open(&l);
    expect_page("joints.md", "| positions within the box of the capsule | %.3f mm | %.1f mm |",
                worst(&l, POSITIONS, 16), worst(&l, POSITIONS, 8));
    expect_page("joints.md", "| normals of the capsule | %.4f° | %.2f° |", worst(&l, NORMALS, 16),
                worst(&l, NORMALS, 8));
    expect_page("joints.md", "| weights of the capsule | %.4f mm | %.1f mm |", worst(&l, WEIGHTS, 16),
                worst(&l, WEIGHTS, 8));
    lesson_close(&l);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_capsule_has_the_errors_of_the_page)};
    return cmocka_run_group_tests_name("lesson", tests, NULL, NULL);
}
