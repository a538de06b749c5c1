/* SPDX-License-Identifier: MIT */
/* Numbers of docs/joints.md: the lesson's capsule with vectors and weights stored in fewer bits; of skin.md: bent. */
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
    nkw_skin_palette palette = {
        {state->palette, RIG_JOINTS, NKW_PALETTE_MAT4}, {NULL, 0, NKW_PALETTE_NORMAL_MAT3}, {0, 0, 0}};
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

/* ---- normals of the capsule, its upper half bent ---- */

typedef enum mode { BY_MATRIX, BY_NORMALS, BY_INVERSE } mode;

typedef struct bent {
    nkw_mat4 palette[2];
    nkw_mat3 normal_matrices[2];
    float weights[VERTICES][2];
    uint8_t joints[VERTICES][2];
    nkw_vec3 normals[VERTICES], turned[VERTICES];
} bent;

/* The upper joint turns about z at half the height; its weight grows from 0 to 1 over the middle half. */
static void bend(const mesh *m, float degrees, bent *b)
{
    const nkw_vec3 z = {0.0f, 0.0f, 1.0f}, up = {0.0f, 1.5f, 0.0f}, down = {0.0f, -1.5f, 0.0f};
    const nkw_mat4 turn = nkw_mat4_from_quat(nkw_quat_from_axis_angle(z, nkw_radians_from_degrees(degrees)));
    const nkw_mat4 to = nkw_mat4_from_translation(up), from = nkw_mat4_from_translation(down);
    b->palette[0] = nkw_mat4_identity();
    b->palette[1] = nkw_mat4_mul(&turn, &from);
    b->palette[1] = nkw_mat4_mul(&to, &b->palette[1]);
    for (int j = 0; j < 2; j++) {
        const nkw_mat3 block = nkw_mat3_from_mat4(&b->palette[j]);
        b->normal_matrices[j] = nkw_mat3_normal(&block);
    }
    for (size_t i = 0; i < m->vertex_count; i++) {
        const float w = nkw_clamp((m->vertices[i].position.y - 0.75f) / 1.5f, 0.0f, 1.0f);
        b->normals[i] = m->vertices[i].normal;
        b->weights[i][0] = 1.0f - w, b->weights[i][1] = w;
        b->joints[i][0] = 0, b->joints[i][1] = 1;
    }
}

/* (M^-1)^T n of vertex i in binary64, M = |a b 0|: the turn is about z, |c d 0| in the plane of x and y. */
static nkw_vec3 exact_normal(const bent *b, size_t i)
{
    double m[2][2];
    for (int c = 0; c < 2; c++)
        for (int r = 0; r < 2; r++)
            m[c][r] = (double)b->weights[i][0] * (double)b->palette[0].m[4 * c + r] +
                      (double)b->weights[i][1] * (double)b->palette[1].m[4 * c + r];
    const double det = m[0][0] * m[1][1] - m[1][0] * m[0][1];
    const double x = (double)b->normals[i].x, y = (double)b->normals[i].y, z = (double)b->normals[i].z;
    const double n[3] = {(m[1][1] * x - m[0][1] * y) / det, (m[0][0] * y - m[1][0] * x) / det, z};
    const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    return (nkw_vec3){(float)(n[0] / length), (float)(n[1] / length), (float)(n[2] / length)};
}

/* The largest angle between the normals of a mode and the exact ones, degrees. */
static double angle_of(const mesh *m, float degrees, mode by)
{
    static bent b;
    double most = 0.0;
    bend(m, degrees, &b);
    const nkw_skin skin = {m->vertex_count, 2, {b.joints, 0, NKW_SKIN_U8}, {b.weights, 0, NKW_SKIN_F32}};
    const nkw_skin_palette palette = {{b.palette, 2, NKW_PALETTE_MAT4},
                                      {by == BY_NORMALS ? b.normal_matrices : NULL, 2, NKW_PALETTE_NORMAL_MAT3},
                                      {0, by == BY_INVERSE, 0}};
    const nkw_vertices_view in = {{NULL, 0}, {b.normals, 0}, {NULL, 0}, {NULL, 0}};
    const nkw_vertices_span out = {{NULL, 0}, {b.turned, 0}, {NULL, 0}, {NULL, 0}};
    assert_int_equal(nkw_skin_linear(&skin, &palette, in, out), NKW_OK);
    for (size_t i = 0; i < m->vertex_count; i++)
        most = fmax(most, quantized_angle(b.turned[i], exact_normal(&b, i)));
    return most;
}

static void the_bent_capsule_has_the_errors_of_the_page(void **state)
{
    mesh m = {0};
    double error[3][3];
    (void)state;
    assert_true(mesh_capsule(&m) && m.vertex_count <= VERTICES);
    for (int by = 0; by < 3; by++) {
        error[by][0] = angle_of(&m, 10.0f, (mode)by);
        error[by][1] = angle_of(&m, 40.0f, (mode)by);
        error[by][2] = angle_of(&m, 60.0f, (mode)by);
    }
    for (int by = 0; by < 2; by++)
        expect_page("subjects/skin/skin.md",
                    by ? "times n | %.2f° | %.2f° | %.2f° |" : "| M n | %.2f° | %.2f° | %.2f° |", error[by][0],
                    error[by][1], error[by][2]);
    expect_page("subjects/skin/skin.md", "| (M⁻¹)ᵀ n | %.5f° | %.5f° | %.5f° |", error[2][0], error[2][1], error[2][2]);
    mesh_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_capsule_has_the_errors_of_the_page),
        cmocka_unit_test(the_bent_capsule_has_the_errors_of_the_page),
    };
    return cmocka_run_group_tests_name("lesson", tests, NULL, NULL);
}
