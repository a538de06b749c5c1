/* SPDX-License-Identifier: MIT */
/*
 * FBX: curves, layers, transforms, modes of inheritance. The files of tests/data/import/fbx are written by hand; the
 * values follow from their texts by the definitions in the comments, in binary64.
 */
#include <math.h>
#include <stdio.h>

#include <nakawari/mat.h>
#include <nakawari/transform.h>

#include "moment.h"

#define FILES NKW_TEST_DATA "/import/fbx/"

static float x_of(const moment *m, const char *name)
{
    return local(m, name).translation.x;
}

/* The clip `index` of the document. */
static void choose(moment *m, size_t index)
{
    nkw_import_free(m->clip);
    assert_int_equal(nkw_document_clip(m->d, index, NKW_CLIP_FLOAT32, &m->clip, NULL), NKW_IMPORT_OK);
}

/* ---- curves ---- */

/*
 * The Bezier curve of time and value from (0, 0) to (h, rise) with the handles (a h, a h m) and (-b h, -b h n), by
 * bisection: s is the parameter.
 */
static double bezier(double h, double from, double rise, double a, double m, double b, double n, double time)
{
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; i++) {
        const double s = 0.5 * (low + high), r = 1.0 - s;
        const double x = 3.0 * s * r * r * a * h + 3.0 * s * s * r * (1.0 - b) * h + s * s * s * h;
        *(x < time ? &low : &high) = s;
    }
    const double s = low, r = 1.0 - s;
    return from + 3.0 * s * r * r * a * h * m + 3.0 * s * s * r * (rise - b * h * n) + s * s * s * rise;
}

/*
 * Keys 0, 2, 1 at 0, 1, 3 s; lines of 2 and -1/2. Slopes of the middle key, and of the ends:
 *
 *     user         to the right 1, to the left -2, of all
 *     tcb          t = 1/4, c = -1/2, b = 0.3: in 3/8 (1.3 1.5 2 - 0.7 0.5/2), out 3/8 (1.3 0.5 2 - 0.7 1.5/2); ends
 *                  3/4 0.7 1.5 2 and -3/4 1.3 1.5/2
 *     untimed      (1 - 0)/3
 *     auto         half of that, and half of 2 2/3 - 1/2 1/3 = 7/6; ends: the lines
 *     biased       half of the way from there to the line after, -1/2
 *     progressive  keys 0, 0.1, 3.1: 0.8, but no more than 0.1 3; ends level
 *     clamped      keys 0, 0, 1: level beside an equal key; the line at the end
 */
static void curves_have_the_slopes_of_their_modes(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double value[3], out0, in1, out1, in2, out_weight, in_weight;
    } curves[] = {
        {"user", {0, 2, 1}, 1, -2, 1, -2, 1.0 / 3.0, 1.0 / 3.0},
        {"weighted", {0, 2, 1}, 1, -2, 1, -2, 0.5, 0.1},
        {"tcb", {0, 2, 1}, 1.575, 1.396875, 0.290625, -0.73125, 1.0 / 3.0, 1.0 / 3.0},
        {"auto", {0, 2, 1}, 2, 0.75, 0.75, -0.5, 1.0 / 3.0, 1.0 / 3.0},
        {"untimed", {0, 2, 1}, 2, 1.0 / 3.0, 1.0 / 3.0, -0.5, 1.0 / 3.0, 1.0 / 3.0},
        {"biased", {0, 2, 1}, 2, 0.125, 0.125, -0.5, 1.0 / 3.0, 1.0 / 3.0},
        {"progressive", {0, 0.1, 3.1}, 0, 0.3, 0.3, 0, 1.0 / 3.0, 1.0 / 3.0},
        {"clamped", {0, 0, 1}, 0, 0, 0, 0.5, 1.0 / 3.0, 1.0 / 3.0},
    };
    static const char *const files[] = {FILES "tangents.fbx", FILES "tangents_7400.fbx", FILES "tangents_7700.fbx"};
    for (int f = 0; f < 3; f++) {
        moment *m = open_file(files[f]);
        for (int i = 0; i <= 60; i++) {
            const float t = 0.05f * (float)i;
            play(m, t);
            for (size_t k = 0; k < sizeof curves / sizeof *curves; k++) {
                const int late = t >= 1.0f;
                const double v = curves[k].value[late], rise = curves[k].value[late + 1] - v;
                const double expected =
                    bezier(late ? 2 : 1, v, rise, curves[k].out_weight, late ? curves[k].out1 : curves[k].out0,
                           curves[k].in_weight, late ? curves[k].in2 : curves[k].in1, late ? (double)t - 1 : (double)t);
                expect_near(x_of(m, curves[k].name), expected, 3e-5);
            }
        }
        close_file(m);
    }
}

static void keys_that_are_constant_hold(void **state)
{
    (void)state;
    moment *m = open_file(FILES "tangents.fbx");
    static const struct {
        float time, constant, next, linear;
    } rows[] = {{0, 0, 0, 0}, {0.5f, 0, 2, 1}, {1, 2, 2, 2}, {1.5f, 2, 1, 1.75f}, {2.5f, 2, 1, 1.25f}, {3, 1, 1, 1}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        play(m, rows[i].time);
        expect_bits(x_of(m, "constant"), rows[i].constant);
        expect_bits(x_of(m, "next"), rows[i].next);
        expect_near(x_of(m, "linear"), (double)rows[i].linear, 3e-7);
    }
    play(m, nextafterf(1.0f, 0.0f));
    expect_bits(x_of(m, "constant"), 0.0f);
    for (size_t i = 0; i < 2; i++)
        assert_int_equal(m->d->animations[0].tracks[i].track.interpolation, NKW_INTERPOLATION_STEP);
    assert_int_equal(m->d->animations[0].tracks[2].track.interpolation, NKW_INTERPOLATION_LINEAR);
    close_file(m);
}

/* A line from 0 at 1 s to 3 at 2 s, in a take from 0 to 4 s. */
static void curves_continue_outside_their_keys(void **state)
{
    (void)state;
    moment *m = open_file(FILES "outside.fbx");
    expect_bits(nkw_clip_describe(m->clip).start, 0.0f);
    expect_bits(nkw_clip_describe(m->clip).end, 4.0f);
    static const struct {
        const char *name;
        float values[6];
    } rows[] = {{"hold", {0, 0, 1.5f, 3, 3, 3}},
                {"slope", {-2.25f, -0.75f, 1.5f, 3.75f, 6.75f, 8.25f}},
                {"repeat", {0.75f, 2.25f, 1.5f, 0.75f, 0.75f, 2.25f}},
                {"offset", {-2.25f, -0.75f, 1.5f, 3.75f, 6.75f, 8.25f}},
                {"mirror", {2.25f, 0.75f, 1.5f, 2.25f, 0.75f, 2.25f}},
                {"once", {0.75f, 2.25f, 1.5f, 0.75f, 3, 3}},
                {"never", {0, 0, 1.5f, 3, 3, 3}}};
    static const float times[] = {0.25f, 0.75f, 1.5f, 2.25f, 3.25f, 3.75f};
    for (int i = 0; i < 6; i++) {
        play(m, times[i]);
        for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
            expect_near(x_of(m, rows[k].name), (double)rows[k].values[i], 2e-5);
    }
    play(m, 2.0f);
    expect_near(x_of(m, "repeat"), 3.0, 2e-6); /* the key, then the next cycle */
    play(m, 2.000001f);
    expect_near(x_of(m, "repeat"), 0.0, 2e-5);
    close_file(m);
}

/* Keys that differ by less than a microsecond are one, and the last key, 0.6 us behind the take, is not lost. */
static void ticks_make_no_keys(void **state)
{
    (void)state;
    moment *m = open_file(FILES "ticks.fbx");
    const nkw_track *t = &m->d->animations[0].tracks[0].track;
    assert_int_equal(m->d->warning_count, 0);
    assert_int_equal(t->count, 3);
    expect_bits(t->times[2], 1.0f);
    expect_vec3_near(at(t->values[6], t->values[7], t->values[8]), at(2, 0, 4), 1e-5);
    expect_vec3_near(at(t->values[3], t->values[4], t->values[5]), at(1, 3, 1), 1e-5);
    play(m, 0.25f);
    expect_near(x_of(m, "jump"), 0.5, 1e-6); /* two keys a tick apart are a jump from 1 to 5 */
    play(m, 0.5f);
    expect_near(x_of(m, "jump"), 5.0, 1e-6);
    play(m, 0.75f);
    expect_near(x_of(m, "jump"), 5.5, 1e-6);
    close_file(m);
}

/* ---- layers ---- */

static void expect_box(const moment *m, nkw_vec3 t, nkw_quat r, nkw_vec3 s)
{
    expect_vec3_near(local(m, "box").translation, t, 2e-5);
    expect_rotation_near(local(m, "box").rotation, r, 2e-5);
    expect_vec3_near(local(m, "box").scale, s, 2e-5);
}

/*
 * Below: T (10 t, 5, 0), R 90 t about x, S 2 2 2. Above: T 4 0 0, R 90 about z, S 4 1 1, with the weight w:
 *
 *     additive      T + w 4, R * slerp(1, z 90, w), S 4^w; by component the angles and the scales are added
 *     override      what is above
 *     passthrough   the mean by w, slerp and S^(1 - w) 4^w
 */
static void layers_are_combined_by_their_modes(void **state)
{
    (void)state;
    moment *m = open_file(FILES "layers.fbx");
    assert_int_equal(m->d->animation_count, 5);
    for (int i = 0; i <= 4; i++) {
        const float t = 0.25f * (float)i;
        const nkw_quat below = turn('x', 90 * t), above = turn('z', 90);
        choose(m, 0);
        play(m, t);
        expect_box(m, at(10 * t + 2, 5, 0), nkw_quat_mul(below, turn('z', 45)), at(4, 2, 2));
        choose(m, 1);
        play(m, t);
        expect_box(m, at(10 * t + 2, 5, 0), nkw_quat_mul(turn('z', 45), below), at(4, 2.5f, 2.5f));
        choose(m, 2);
        play(m, t);
        expect_box(m, at(4, 0, 0), above, at(4, 1, 1));
        choose(m, 3);
        play(m, t);
        const float root = 1.6817928305f; /* 2^(3/4) */
        expect_box(m, at(7.5f * t + 1, 3.75f, 0), nkw_quat_slerp(below, above, 0.25f),
                   at(root * 1.41421356f, root, root));
        choose(m, 4); /* the weight is t */
        play(m, t);
        expect_box(m, at(14 * t, 5, 0), nkw_quat_mul(below, turn('z', 90 * t)), at(2 * powf(4, t), 2, 2));
    }
    close_file(m);
}

/* ---- transforms ---- */

/* The axes of the box at the end of a chain, and its origin: columns of its model matrix. */
static void expect_model(const moment *m, const char *name, nkw_vec3 x, nkw_vec3 y, nkw_vec3 z, nkw_vec3 origin)
{
    const float *v = m->models[joint(m, name)].m;
    expect_vec3_near(at(v[0], v[1], v[2]), x, 2e-5);
    expect_vec3_near(at(v[4], v[5], v[6]), y, 2e-5);
    expect_vec3_near(at(v[8], v[9], v[10]), z, 2e-5);
    expect_vec3_near(at(v[12], v[13], v[14]), origin, 2e-5);
}

/*
 * The parent: at 0 0 1, scale s 1 1, s = 2 + 2 t. Each child: at 1 0 0, turned by 90 about z, scale 1 3 1; each end: at
 * 0 1 0, scale 1 1 5. R is the turn: x to y, y to -x.
 *
 *     RSrs   S_p R S         columns (0 1 0), (-3 s 0 0), (0 0 1)
 *     RrSs   R S_p S         columns (0 s 0), (-3 0 0), (0 0 1)
 *     Rrs    R S             columns (0 1 0), (-3 0 0), (0 0 1)
 *
 * Origins are points of the parent: s 0 1. That of an end is a point of the child. The scale of an end is 1 1 5, with
 * RrSs times s 3 1, with Rrs times 1 1 1, for the parent of its parent has mode 1 and passes nothing to it.
 */
static void scales_are_inherited_by_their_modes(void **state)
{
    (void)state;
    moment *m = open_file(FILES "inherit.fbx");
    for (int i = 0; i <= 4; i++) {
        const float t = 0.25f * (float)i, s = 2 + 2 * t;
        const nkw_vec3 origin = at(s, 0, 1), end = at(s - 3, 0, 1);
        play(m, t);
        expect_model(m, "parent_scale", at(s, 0, 0), at(0, 1, 0), at(0, 0, 1), at(0, 0, 1));
        expect_model(m, "rsrs", at(0, 1, 0), at(-3 * s, 0, 0), at(0, 0, 1), origin);
        expect_model(m, "rsrs_end", at(0, 1, 0), at(-3 * s, 0, 0), at(0, 0, 5), at(s - 3 * s, 0, 1));
        expect_model(m, "rrss_scale", at(0, s, 0), at(-3, 0, 0), at(0, 0, 1), origin);
        expect_model(m, "rrss_end", at(0, s, 0), at(-3, 0, 0), at(0, 0, 5), end);
        expect_model(m, "rrs_scale", at(0, 1, 0), at(-3, 0, 0), at(0, 0, 1), origin);
        expect_model(m, "rrs_end", at(0, 1, 0), at(-1, 0, 0), at(0, 0, 5), end);
    }
    close_file(m);
}

static nkw_mat4 moved(float x, float y, float z)
{
    const nkw_trs t = {{x, y, z}, {0, 0, 0, 1}, {1, 1, 1}};
    return nkw_mat4_from_trs(&t);
}

static nkw_mat4 turned(nkw_quat q)
{
    const nkw_trs t = {{0, 0, 0}, q, {1, 1, 1}};
    return nkw_mat4_from_trs(&t);
}

/* T Roff Rp Rpre R Rpost^-1 Rp^-1 Soff Sp S Sp^-1 with R = Rx Rz Ry of YZX, and its two turns about x. */
static void transforms_have_all_their_factors(void **state)
{
    (void)state;
    moment *m = open_file(FILES "rotation.fbx");
    for (int i = 0; i <= 20; i++) {
        const float t = 0.05f * (float)i;
        const nkw_trs scale = {{0, 0, 0}, {0, 0, 0, 1}, {1 + 2 * t, 1, 1}};
        const nkw_mat4 factors[] = {moved(3, 0, 0),
                                    moved(0.5f, 0, 0),
                                    moved(0, 1, 0),
                                    turned(turn('z', 90)),
                                    turned(turn('x', 720 * t)),
                                    turned(turn('y', 30 * t)),
                                    turned(turn('y', -20)),
                                    moved(0, -1, 0),
                                    moved(0, 0, 2),
                                    moved(1, 0, 0),
                                    nkw_mat4_from_trs(&scale),
                                    moved(-1, 0, 0)};
        nkw_mat4 whole = factors[0];
        for (size_t k = 1; k < sizeof factors / sizeof *factors; k++)
            whole = nkw_mat4_mul(&whole, &factors[k]);
        play(m, t);
        for (int k = 0; k < 16; k++)
            expect_near(m->models[joint(m, "pivots")].m[k], (double)whole.m[k], 6e-5);
    }
    close_file(m);
}

/* The first letter turns first: xyz is Rz Ry Rx. Without RotationActive neither the order nor PreRotation counts. */
static void rotations_have_their_orders(void **state)
{
    (void)state;
    moment *m = open_file(FILES "rotation.fbx");
    static const char *const orders[] = {"xyz", "xzy", "yzx", "yxz", "zxy", "zyx"};
    play(m, 0.0f);
    for (int i = 0; i < 6; i++) {
        nkw_quat q = {0, 0, 0, 1};
        for (int k = 0; k < 3; k++)
            q = nkw_quat_mul(turn(orders[i][k], 10.0f * (float)(orders[i][k] - 'x' + 1)), q);
        expect_rotation_near(local(m, orders[i]).rotation, q, 4e-7);
    }
    expect_rotation_near(local(m, "inactive").rotation, local(m, "xyz").rotation, 1e-7);
    close_file(m);
}

/* z up, -y to the front, x to the right of the viewer, which is the left of a character; an inch is 0.0254 m. */
static void axes_and_units_are_stated(void **state)
{
    (void)state;
    moment *m = open_file(FILES "axes.fbx");
    assert_int_equal(m->d->space.axes.up, NKW_AXIS_Z);
    assert_int_equal(m->d->space.axes.forward, NKW_AXIS_NEGATIVE_Y);
    assert_int_equal(m->d->space.axes.right, NKW_AXIS_NEGATIVE_X);
    expect_near(m->d->space.metres, 0.0254, 1e-9);
    play(m, 0.5f);
    expect_vec3_near(local(m, "box").translation, at(10, 20, 40), 1e-6);
    close_file(m);
    m = open_file(FILES "ticks.fbx"); /* without GlobalSettings */
    expect_bits(m->d->space.metres, 0.0f);
    assert_int_equal(m->d->space.axes.up, 0);
    close_file(m);
}

/* Shapes at -100, 40 and 100 percent; the mesh at 0. Percents -150, 0, 120 at 0, 1, 2 s. At rest 25. */
static void shapes_between_follow_each_other(void **state)
{
    (void)state;
    moment *m = open_file(FILES "shapes.fbx");
    static const struct {
        float time, weights[3];
    } rows[] = {{0, {1.5f, 0, 0}},      {0.5f, {0.75f, 0, 0}},           {1, {0, 0, 0}},
                {1.25f, {0, 0.75f, 0}}, {1.5f, {0, 2.0f / 3, 1.0f / 3}}, {2, {0, -1.0f / 3, 4.0f / 3}}};
    assert_int_equal(m->d->float_count, 3);
    expect_near(m->d->rest_floats[1], 0.625, 1e-7);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        float floats[3], pose[NKW_POSE_FLOATS(JOINTS)];
        const nkw_pose_span span = pose_span(pose, m->d->skeleton.joint_count);
        assert_int_equal(nkw_clip_sample(m->clip, rows[i].time, NULL, span, floats), NKW_OK);
        for (int k = 0; k < 3; k++)
            expect_near(floats[k], (double)rows[i].weights[k], 3e-5);
    }
    close_file(m);
}

static void expect_vertices(const moment *m, const char *name, const nkw_vec3 expected[3])
{
    const size_t j = joint(m, name);
    nkw_vec3 vertices[3];
    const nkw_document_vertices_span out = {vertices, NULL};
    const nkw_document_moment now = {m->models, NULL, m->palette};
    assert_int_equal(m->d->meshes[m->d->nodes[j].mesh].primitives[0].vertex_count, 3);
    assert_int_equal(nkw_document_vertices(m->d, j, 0, &now, out), NKW_OK);
    for (int i = 0; i < 3; i++)
        expect_vec3_near(vertices[i], expected[i], 2e-6);
}

/*
 * Vertices 0 0 0, 1 0 0, 0 1 0 times 2, at 0 0 5, by the geometric transform. The bone at 1 0 0 turns them by 90 degrees
 * about z: x - 1 and y become -y + 1 and x - 1. The rigid mesh is at 0 3 0; the node below it is not scaled.
 */
static void geometric_transforms_move_the_mesh_alone(void **state)
{
    (void)state;
    moment *m = open_file(FILES "geometry.fbx");
    const nkw_vec3 before[] = {{0, 0, 5}, {2, 0, 5}, {0, 2, 5}}, after[] = {{1, -1, 5}, {1, 1, 5}, {-1, -1, 5}};
    const nkw_vec3 rigid[] = {{0, 3, 5}, {2, 3, 5}, {0, 5, 5}};
    play(m, 0.0f);
    expect_vertices(m, "skinned", before);
    expect_vertices(m, "rigid_geometry", rigid);
    expect_model(m, "below", at(1, 0, 0), at(0, 1, 0), at(0, 0, 1), at(1, 3, 0));
    play(m, 1.0f);
    expect_vertices(m, "skinned", after);
    close_file(m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(curves_have_the_slopes_of_their_modes),
        cmocka_unit_test(keys_that_are_constant_hold),
        cmocka_unit_test(curves_continue_outside_their_keys),
        cmocka_unit_test(ticks_make_no_keys),
        cmocka_unit_test(layers_are_combined_by_their_modes),
        cmocka_unit_test(scales_are_inherited_by_their_modes),
        cmocka_unit_test(transforms_have_all_their_factors),
        cmocka_unit_test(shapes_between_follow_each_other),
        cmocka_unit_test(geometric_transforms_move_the_mesh_alone),
        cmocka_unit_test(axes_and_units_are_stated),
        cmocka_unit_test(rotations_have_their_orders),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
