/* SPDX-License-Identifier: MIT */
/* Pictures of skeletons: from a file's order to parents first, and local to model along an arm. */
#include "figure.h"

#include <stdio.h>

#include <nakawari/pose.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/skeleton.h>
#include <nakawari/transform.h>

/* ---- order ---- */

enum { NODES = 6 };

static const float half_turn = 3.14159265f;

static const float cell = 48.0f;
static const svg_colour joint_colours[NODES] = {0x1f5fd0, 0x2c8c4a, 0xd55e00, 0x7b3fa0, 0xc2185b, 0x00897b};

static const char *number_of(char text[16], int32_t joint)
{
    if (joint < 0)
        return "-";
    sprintf(text, "%d", (int)(joint % 100));
    return text;
}

/* A number in a box, the colour that of the joint's number in the file. */
static void number_cell(svg *s, float x, float y, int32_t number, int32_t of)
{
    char text[16];
    svg_colour colour = of < 0 ? FIGURE_PALE : joint_colours[of % NODES];
    svg_box box = {x, y, cell - 4.0f, 34.0f};
    svg_paint paint = {svg_mix(0xffffff, colour, 0.18f), colour, 1.4f, 1.0f, NULL};
    svg_rect(s, box, 4.0f, &paint);
    figure_bold(s, x + (cell - 4.0f) / 2.0f, y + 23.0f, 15.0f, FIGURE_INK, 'm', number_of(text, number));
}

/* Parents as an array, with an arrow from each joint to its parent. of: the joint's number in the file. */
static void parent_array(svg *s, float x, float y, const int32_t *parents, const int32_t *of)
{
    for (int j = 0; j < NODES; j++) {
        int32_t parent = parents[j];
        char text[16];
        float at = x + cell * (float)j + (cell - 4.0f) / 2.0f;
        number_cell(s, x + cell * (float)j, y, parent, parent < 0 ? -1 : of[parent]);
        figure_text(s, at, y + 52.0f, 13.0f, FIGURE_GREY, 'm', number_of(text, j));
        if (parent < 0)
            continue;
        float away = cell * (float)(parent - j), radius = (away < 0.0f ? -away : away) / 2.0f;
        float from = away < 0.0f ? 0.0f : half_turn, to = half_turn - from;
        svg_paint paint = svg_stroke(joint_colours[of[j] % NODES], 1.6f, 0.9f);
        figure_arc_arrow(s, svg_at(at + away / 2.0f, y - 6.0f), radius, from, to, &paint);
    }
}

/* The joints one below the other, each to the right of its parent. */
static void indented_tree(svg *s, float x, float y, const int32_t *parents, const int32_t *of)
{
    float left[NODES];
    svg_paint rule = svg_stroke(FIGURE_PALE, 1.4f, 1.0f);
    for (int j = 0; j < NODES; j++) {
        char text[16], line[40];
        float top = y + 40.0f * (float)j;
        left[j] = parents[j] < 0 ? x : left[parents[j]] + 38.0f;
        if (parents[j] >= 0) {
            float above = y + 40.0f * (float)parents[j] + 15.0f, down = left[parents[j]];
            svg_line(s, svg_at(down, above), svg_at(down, top), &rule);
            svg_line(s, svg_at(down, top), svg_at(left[j] - 15.0f, top), &rule);
        }
        svg_paint disc = {svg_mix(0xffffff, joint_colours[of[j] % NODES], 0.18f), joint_colours[of[j] % NODES], 1.6f,
                          1.0f, NULL};
        svg_circle(s, svg_at(left[j], top), 15.0f, &disc);
        figure_bold(s, left[j], top + 5.0f, 15.0f, FIGURE_INK, 'm', number_of(text, of[j]));
        sprintf(line, "becomes joint %d", j % 100);
        figure_text(s, left[j] + 24.0f, top + 5.0f, 13.0f, FIGURE_GREY, 's', line);
    }
}

int figure_skeleton_order(const char *path)
{
    static const int32_t file[NODES] = {3, 5, 3, -1, 0, -1};
    int32_t to[NODES], from[NODES], parents[NODES];
    static const int32_t same[NODES] = {0, 1, 2, 3, 4, 5};
    svg s;
    if (nkw_skeleton_from_parents(file, NODES, to, from, parents, NULL) != NKW_OK ||
        !figure_open(&s, path, 984.0f, 380.0f, "Parents come before their children",
                     "nkw_skeleton_from_parents renumbers the joints of a file, depth first. Numbers in the tree and "
                     "colours are the file's."))
        return 0;
    figure_bold(&s, 24.0f, 104.0f, 15.0f, FIGURE_INK, 's', "In the file: parents anywhere");
    parent_array(&s, 24.0f, 250.0f, file, same);
    figure_bold(&s, 374.0f, 104.0f, 15.0f, FIGURE_INK, 's', "The tree");
    indented_tree(&s, 394.0f, 136.0f, parents, from);
    figure_bold(&s, 672.0f, 104.0f, 15.0f, FIGURE_INK, 's', "The skeleton: every arrow goes left");
    parent_array(&s, 672.0f, 250.0f, parents, from);
    figure_text(&s, 24.0f, 340.0f, 13.0f, FIGURE_GREY, 's', "in the box the parent, below it the joint");
    figure_text(&s, 672.0f, 340.0f, 13.0f, FIGURE_GREY, 's', "in one pass, parents are computed first");
    return svg_close(&s);
}

/* ---- local to model ---- */

enum { ARM = 4 }; /* shoulder, elbow, wrist, tip */

static const float unit = 104.0f;
static const svg_colour arm_colours[ARM] = {0x1f5fd0, 0x2c8c4a, 0xd55e00, 0x55555c};

static svg_point arm_at(svg_point origin, nkw_vec3 p)
{
    return svg_at(origin.x + unit * p.x, origin.y - unit * p.y);
}

static void arm_models(const float turns[ARM], nkw_mat4 models[ARM])
{
    static const int32_t parents[ARM] = {NKW_NO_JOINT, 0, 1, 2};
    static const float bones[ARM] = {0.0f, 1.5f, 1.2f, 0.6f};
    const nkw_skeleton skeleton = {parents, ARM};
    const nkw_vec3 z = {0.0f, 0.0f, 1.0f};
    float pose[NKW_POSE_FLOATS(ARM)];
    for (size_t j = 0; j < ARM; j++) {
        nkw_trs trs = {{bones[j], 0.0f, 0.0f}, nkw_quat_from_axis_angle(z, turns[j]), {1.0f, 1.0f, 1.0f}};
        nkw_pose_set((nkw_pose_span){pose, ARM}, j, &trs);
    }
    nkw_skeleton_models_from_pose(&skeleton, (nkw_pose_view){pose, skeleton.joint_count}, NULL, NULL, models);
}

/* A bone from joint j to the next, and the axes of its space. */
static void draw_bone(svg *s, svg_point origin, const nkw_mat4 *models, int j, float opacity)
{
    nkw_vec3 side = {0.12f, 0.12f, 0.0f}, other = {0.12f, -0.12f, 0.0f}, zero = {0.0f, 0.0f, 0.0f};
    svg_point shape[4] = {arm_at(origin, nkw_mat4_transform_point(&models[j], zero)),
                          arm_at(origin, nkw_mat4_transform_point(&models[j], side)),
                          arm_at(origin, nkw_mat4_translation(&models[j + 1])),
                          arm_at(origin, nkw_mat4_transform_point(&models[j], other))};
    svg_paint paint = {svg_mix(0xffffff, arm_colours[j], 0.25f), arm_colours[j], 1.6f, opacity, NULL};
    svg_polygon(s, shape, 4, &paint);
}

static void draw_axes(svg *s, svg_point origin, const nkw_mat4 *m)
{
    nkw_vec3 x = {0.38f, 0.0f, 0.0f}, y = {0.0f, 0.38f, 0.0f};
    svg_point at = arm_at(origin, nkw_mat4_translation(m));
    svg_paint red = svg_stroke(0xd62728, 2.0f, 1.0f), green = svg_stroke(0x2ca02c, 2.0f, 1.0f);
    svg_arrow(s, at, arm_at(origin, nkw_mat4_transform_point(m, x)), &red);
    svg_arrow(s, at, arm_at(origin, nkw_mat4_transform_point(m, y)), &green);
    figure_dot(s, at, FIGURE_INK);
}

static void draw_arm(svg *s, svg_point origin, const nkw_mat4 *models, float opacity)
{
    for (int j = 0; j + 1 < ARM; j++)
        draw_bone(s, origin, models, j, opacity);
    for (int j = 0; j + 1 < ARM && opacity == 1.0f; j++)
        draw_axes(s, origin, &models[j]);
}

static void arm_lines(svg *s, float x, float y)
{
    static const char *const lines[3][2] = {{"model[0] = local[0]", "turn 35 degrees"},
                                            {"model[1] = model[0] local[1]", "1.5 along x, turn 60 degrees"},
                                            {"model[2] = model[1] local[2]", "1.2 along x, turn -40 degrees"}};
    for (int j = 0; j < 3; j++) {
        figure_bold(s, x, y + 52.0f * (float)j, 14.0f, arm_colours[j], 's', lines[j][0]);
        figure_text(s, x, y + 52.0f * (float)j + 19.0f, 13.0f, FIGURE_GREY, 's', lines[j][1]);
    }
}

int figure_skeleton_models(const char *path)
{
    static const float straight[ARM] = {0.0f, 0.0f, 0.0f, 0.0f};
    static const float bent[ARM] = {0.610865f, 1.047198f, -0.698132f, 0.0f};
    static const char *const names[3] = {"shoulder 0", "elbow 1", "wrist 2"};
    nkw_mat4 bind[ARM], now[ARM];
    svg_point left = {48.0f, 400.0f}, right = {510.0f, 400.0f};
    svg s;
    if (!figure_open(&s, path, 1008.0f, 470.0f, "A joint moves its children",
                     "A local transform is relative to the axes of the parent (x red, y green). Models are products "
                     "along the chain."))
        return 0;
    arm_models(straight, bind);
    arm_models(bent, now);
    figure_bold(&s, 24.0f, 104.0f, 15.0f, FIGURE_INK, 's', "Bind pose: no joint turns");
    figure_bold(&s, 486.0f, 104.0f, 15.0f, FIGURE_INK, 's', "Posed");
    draw_arm(&s, left, bind, 1.0f);
    draw_arm(&s, right, bind, 0.22f);
    draw_arm(&s, right, now, 1.0f);
    for (int j = 0; j < 3; j++) {
        svg_point at = arm_at(left, nkw_mat4_translation(&bind[j]));
        figure_name(&s, at.x + 2.0f, at.y + 34.0f, arm_colours[j], 's', names[j]);
    }
    arm_lines(&s, 740.0f, 150.0f);
    return svg_close(&s);
}
