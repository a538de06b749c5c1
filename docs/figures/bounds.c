/* SPDX-License-Identifier: MIT */
/* Morph targets of an outline; the boxes of the joints of a bent tube. */
#include "figure.h"

#include <nakawari/bounds.h>
#include <nakawari/mat.h>
#include <nakawari/morph.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/skeleton.h>
#include <nakawari/transform.h>

/* ---- Morph targets ---- */

enum { OUTLINE = 72 };

static void outline(nkw_vec3 *base, nkw_vec3 *wide, nkw_vec3 *puff)
{
    for (int i = 0; i < OUTLINE; i++) {
        float angle = 6.2831853f * (float)i / (float)OUTLINE, c = nkw_cos(angle), s = nkw_sin(angle);
        float cheek = nkw_max(0.0f, 1.0f - 3.0f * nkw_abs(nkw_abs(c) - 0.85f)) * (s < 0.1f ? 1.0f : 0.2f);
        base[i] = (nkw_vec3){0.75f * c, s, 0};
        wide[i] = (nkw_vec3){0.35f * c, -0.15f * s, 0};
        puff[i] = (nkw_vec3){0.4f * cheek * c, 0.15f * cheek * s, 0};
    }
}

static void face(svg *s, float x, const float weights[2], const char *name)
{
    nkw_vec3 base[OUTLINE], deltas[2][OUTLINE], out[OUTLINE];
    svg_point page[OUTLINE], rest[OUTLINE];
    outline(base, deltas[0], deltas[1]);
    nkw_morph_target targets[2] = {{{{deltas[0], 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}}, NULL, 0},
                                   {{{deltas[1], 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}}, NULL, 0}};
    nkw_morph morph = {targets, 2, OUTLINE};
    nkw_vertices_view in = {{base, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span to = {{out, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_morph_apply(&morph, weights, in, to);
    for (int i = 0; i < OUTLINE; i++) {
        page[i] = svg_at(x + 62.0f * out[i].x, 170.0f - 62.0f * out[i].y);
        rest[i] = svg_at(x + 62.0f * base[i].x, 170.0f - 62.0f * base[i].y);
    }
    svg_paint shape = {0xfbe9dd, 0xd55e00, 2.2f, 1.0f, NULL}, pale = {SVG_NONE, FIGURE_PALE, 1.4f, 1.0f, "4 3"};
    svg_polygon(s, page, OUTLINE, &shape);
    svg_polygon(s, rest, OUTLINE, &pale);
    figure_text(s, x, 262.0f, 13.0f, FIGURE_INK, 'm', name);
}

int figure_morph_targets(const char *path)
{
    static const float weights[5][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5f, 0.5f}, {1, 1}};
    static const char *const names[5] = {"base", "wide: 1", "puff: 1", "wide 0.5, puff 0.5", "wide 1, puff 1"};
    svg s;
    if (!figure_open(&s, path, 900.0f, 285.0f, "Two morph targets and their sums",
                     "Each vertex moves by the weighted sum of its differences from the base, the dashed outline."))
        return 0;
    for (int i = 0; i < 5; i++)
        face(&s, 110.0f + 170.0f * (float)i, weights[i], names[i]);
    return svg_close(&s);
}

/* ---- Bounds ---- */

enum { TUBE_JOINTS = 4, RINGS = 41, POINTS = 2 * RINGS };

typedef struct tube {
    nkw_vec3 bind[POINTS], skinned[POINTS];
    unsigned char joints[2 * POINTS];
    float weights[2 * POINTS];
    nkw_mat4 palette[TUBE_JOINTS];
    nkw_box boxes[TUBE_JOINTS + 1];
} tube;

/* An outline of two sides, four units high; the weights pass from joint to joint. */
static void make_tube(tube *t)
{
    for (int i = 0; i < POINTS; i++) {
        float y = 4.0f * (float)(i / 2) / (float)(RINGS - 1), along = nkw_clamp(y - 0.5f, 0.0f, 3.0f);
        int joint = (int)nkw_min(along, 2.0f);
        t->bind[i] = (nkw_vec3){i % 2 ? 0.45f : -0.45f, y, 0};
        t->joints[2 * i] = (unsigned char)joint;
        t->joints[2 * i + 1] = (unsigned char)(joint + 1);
        t->weights[2 * i + 1] = nkw_smoothstep(along - (float)joint);
        t->weights[2 * i] = 1.0f - t->weights[2 * i + 1];
    }
}

static void bend_tube(tube *t, float angle)
{
    nkw_mat4 model = nkw_mat4_identity();
    for (int j = 0; j < TUBE_JOINTS; j++) {
        nkw_trs local = {{0, j ? 1.0f : 0.0f, 0}, nkw_quat_from_axis_angle((nkw_vec3){0, 0, 1}, angle), {1, 1, 1}};
        nkw_mat4 m = nkw_mat4_from_trs(&local), bind = nkw_mat4_identity();
        bind.m[13] = -(float)j;
        model = nkw_mat4_mul_affine(&model, &m);
        t->palette[j] = nkw_mat4_mul_affine(&model, &bind);
    }
}

static svg_point on_page(svg_point origin, nkw_vec3 p)
{
    return svg_at(origin.x + 70.0f * p.x, origin.y - 70.0f * p.y);
}

static void draw_box(svg *s, svg_point origin, const nkw_box *box, const svg_paint *paint)
{
    svg_point low = on_page(origin, box->low), high = on_page(origin, box->high);
    svg_box page = {low.x, high.y, high.x - low.x, low.y - high.y};
    svg_rect(s, page, 0.0f, paint);
}

static void bent_tube(svg *s, svg_point origin, float angle)
{
    static const svg_colour colours[TUBE_JOINTS] = {0xd55e00, 0x00897b, 0x7b3fa0, 0xe0a800};
    tube t;
    make_tube(&t);
    bend_tube(&t, angle);
    nkw_skin skin = {POINTS, 2, {t.joints, 0, NKW_SKIN_U8}, {t.weights, 0, NKW_SKIN_F32}};
    nkw_palette_view palette = {t.palette, TUBE_JOINTS, NKW_PALETTE_MAT4};
    nkw_skin_palette matrices = {palette, {NULL, 0, NKW_PALETTE_NORMAL_MAT3}, {0, 0, 0}};
    nkw_vertices_view in = {{t.bind, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vertices_span out = {{t.skinned, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_box box;
    nkw_skin_linear(&skin, &matrices, in, out);
    nkw_box_from_skin(&skin, in.positions, t.boxes, TUBE_JOINTS);
    nkw_box_from_palette(palette, t.boxes, &box);
    for (int j = 0; j < TUBE_JOINTS; j++) {
        nkw_box moved = nkw_box_transform(&t.boxes[j], &t.palette[j]);
        svg_paint pale = {colours[j], colours[j], 1.4f, 0.28f, NULL};
        draw_box(s, origin, &moved, &pale);
    }
    svg_point page[POINTS];
    for (int i = 0; i < RINGS; i++) {
        page[i] = on_page(origin, t.skinned[2 * i]);
        page[POINTS - 1 - i] = on_page(origin, t.skinned[2 * i + 1]);
    }
    svg_paint shape = {0xe9eef8, 0x1f5fd0, 2.0f, 1.0f, NULL}, edge = {SVG_NONE, FIGURE_INK, 2.0f, 1.0f, NULL};
    svg_polygon(s, page, POINTS, &shape);
    draw_box(s, origin, &box, &edge);
}

int figure_bounds_joints(const char *path)
{
    svg s;
    if (!figure_open(
            &s, path, 900.0f, 430.0f, "A skinned tube, and its box from the boxes of four joints",
            "Coloured: the box of each joint's vertices, moved by its joint matrix. Black: the box of the pose."))
        return 0;
    bent_tube(&s, svg_at(110.0f, 390.0f), 0.0f);
    bent_tube(&s, svg_at(480.0f, 390.0f), 0.35f);
    bent_tube(&s, svg_at(800.0f, 330.0f), 0.8f);
    return svg_close(&s);
}
