/* SPDX-License-Identifier: MIT */
/* An aim added to a bowed body, in the axes of a joint and in model space; masks along a branch and in time. */
#include "figure.h"

#include <nakawari/blend.h>
#include <nakawari/layer.h>
#include <nakawari/mat.h>
#include <nakawari/pose.h>
#include <nakawari/quat.h>
#include <nakawari/skeleton.h>

enum { HIPS, CHEST, HEAD, ARM, JOINTS, SWEEP = 48, CHAIN = 8 };

static const int32_t parents[JOINTS] = {-1, HIPS, CHEST, CHEST};
static const nkw_vec3 place[JOINTS] = {{0, 0.95f, 0}, {0, 0.1f, 0}, {0, 0.62f, 0}, {0, 0.5f, 0}};
static const nkw_vec3 tip[JOINTS] = {{0, 0.1f, 0}, {0, 0.62f, 0}, {0, 0.16f, 0}, {0, 0, 0.85f}};
static const float bow = 0.8f, widest = 1.2f;

/* A body that bows and looks ahead, its arm level. */
static void pose_of(float bowed, float turned, nkw_pose_span out)
{
    const nkw_vec3 x = {1.0f, 0.0f, 0.0f}, y = {0.0f, 1.0f, 0.0f};
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_trs trs = {place[j], nkw_quat_identity(), {1.0f, 1.0f, 1.0f}};
        if (j == CHEST)
            trs.rotation = nkw_quat_mul(nkw_quat_from_axis_angle(x, bowed), nkw_quat_from_axis_angle(y, turned));
        else if (j > CHEST)
            trs.rotation = nkw_quat_from_axis_angle(x, -bowed);
        nkw_pose_set(out, j, &trs);
    }
}

/* The models of the bowed body with an aim of `turned` radians. */
static void aim_at(float turned, int in_model_space, nkw_mat4 *models)
{
    const nkw_skeleton skeleton = {parents, JOINTS};
    const nkw_mask_view all = {NULL, JOINTS};
    float blocks[3][NKW_POSE_FLOATS(JOINTS)];
    const nkw_pose_span body = {blocks[0], JOINTS}, aim = {blocks[1], JOINTS}, ref = {blocks[2], JOINTS};
    const nkw_additive side = in_model_space ? NKW_ADDITIVE_PARENT : NKW_ADDITIVE_LOCAL;
    pose_of(bow, 0.0f, body);
    pose_of(0.0f, turned, aim);
    pose_of(0.0f, 0.0f, ref);
    for (int i = 0; i < 3 && in_model_space; i++) {
        const nkw_pose_span pose = {blocks[i], JOINTS};
        nkw_skeleton_compose_rotations(&skeleton, NKW_VIEW(nkw_pose, pose), pose);
    }
    nkw_pose_additive_build(NKW_VIEW(nkw_pose, aim), NKW_VIEW(nkw_pose, ref), side, aim);
    nkw_pose_additive_apply(NKW_VIEW(nkw_pose, body), NKW_VIEW(nkw_pose, aim), 1.0f, all, side, body);
    if (in_model_space)
        nkw_skeleton_separate_rotations(&skeleton, NKW_VIEW(nkw_pose, body), body);
    nkw_skeleton_models_from_pose(&skeleton, NKW_VIEW(nkw_pose, body), NULL, NULL, models);
}

static void limb(svg *s, const svg_camera *camera, nkw_vec3 a, nkw_vec3 b, svg_colour colour, float width)
{
    const svg_paint paint = svg_stroke(colour, width, 1.0f), knob = svg_fill(colour, 1.0f);
    svg_line(s, svg_project(camera, a), svg_project(camera, b), &paint);
    svg_circle(s, svg_project(camera, a), 0.5f * width, &knob);
    svg_circle(s, svg_project(camera, b), 0.5f * width, &knob);
}

static void body(svg *s, const svg_camera *camera, float turned, int in_model_space, float opacity)
{
    const nkw_vec3 hips = place[HIPS], feet[2] = {{-0.16f, 0, 0}, {0.16f, 0, 0}};
    nkw_mat4 models[JOINTS];
    aim_at(turned, in_model_space, models);
    svg_begin(s, opacity);
    for (int k = 0; k < 2; k++)
        limb(s, camera, hips, feet[k], FIGURE_GREY, 6.0f);
    for (int j = 0; j < JOINTS; j++) {
        const nkw_vec3 a = nkw_mat4_translation(&models[j]), b = nkw_mat4_transform_point(&models[j], tip[j]);
        const svg_paint skull = svg_fill(FIGURE_INK, 1.0f);
        if (j == HEAD)
            svg_circle(s, svg_project(camera, b), 12.0f, &skull);
        else
            limb(s, camera, a, b, j == ARM ? FIGURE_HERMITE : FIGURE_INK, 6.0f);
    }
    svg_end(s);
}

/* The way of the hand, its shadow, and lines from one to the other. */
static void sweep(svg *s, const svg_camera *camera, int in_model_space)
{
    const svg_paint way = svg_stroke(FIGURE_HERMITE, 2.4f, 1.0f), shadow = svg_stroke(FIGURE_PALE, 2.0f, 1.0f);
    const svg_paint drop = svg_stroke(FIGURE_PALE, 1.0f, 0.8f);
    svg_point hand[SWEEP + 1], floor[SWEEP + 1];
    for (int i = 0; i <= SWEEP; i++) {
        nkw_mat4 models[JOINTS];
        aim_at(widest * (2.0f * (float)i / SWEEP - 1.0f), in_model_space, models);
        const nkw_vec3 at = nkw_mat4_transform_point(&models[ARM], tip[ARM]);
        hand[i] = svg_project(camera, at);
        floor[i] = svg_project(camera, space_below(at));
    }
    for (int i = 0; i <= SWEEP; i += SWEEP / 8)
        svg_line(s, hand[i], floor[i], &drop);
    svg_polyline(s, floor, SWEEP + 1, &shadow);
    svg_polyline(s, hand, SWEEP + 1, &way);
}

static void bowed(svg *s, svg_point centre, int in_model_space, const char *name)
{
    const nkw_mat4 view = figure_view(0.9f, 0.3f);
    const svg_camera camera = svg_orthographic(&view, centre, 135.0f);
    figure_bold(s, centre.x - 260.0f, centre.y - 245.0f, 15.0f, FIGURE_INK, 's', name);
    sweep(s, &camera, in_model_space);
    body(s, &camera, -widest, in_model_space, 0.3f);
    body(s, &camera, widest, in_model_space, 0.3f);
    body(s, &camera, 0.0f, in_model_space, 1.0f);
}

/* A chain of eight joints; the branch begins at joint 2. */
static void draw_branch(svg *s, const svg_plot *plot)
{
    static const svg_colour colours[3] = {FIGURE_GREY, FIGURE_CATMULL_ROM, FIGURE_HERMITE};
    static const char *const names[3] = {"subtree", "depth 3", "depth 5"};
    static const float depths[3] = {1.0f, 3.0f, 5.0f};
    int32_t chain[CHAIN];
    float mask[NKW_POSE_STRIDE(CHAIN)];
    svg_point line[CHAIN];
    const nkw_skeleton skeleton = {chain, CHAIN};
    for (int j = 0; j < CHAIN; j++)
        chain[j] = j - 1;
    svg_plot_frame(s, plot);
    for (int i = 0; i < 3; i++) {
        const svg_paint paint = svg_stroke(colours[i], 2.0f, 1.0f);
        nkw_mask_from_branch(&skeleton, 2, depths[i], (nkw_mask_span){mask, CHAIN});
        for (int j = 0; j < CHAIN; j++)
            line[j] = svg_plot_at(plot, (float)j, mask[j]);
        svg_polyline(s, line, CHAIN, &paint);
        for (int j = 0; j < CHAIN; j++)
            figure_dot(s, line[j], colours[i]);
        figure_legend(s, plot->box.x + 130.0f * (float)i, plot->box.y + plot->box.height + 62.0f, &paint, names[i]);
    }
}

static void draw_times(svg *s, const svg_plot *plot)
{
    static const svg_colour colours[3] = {FIGURE_GREY, FIGURE_CATMULL_ROM, FIGURE_HERMITE};
    static const char *const names[3] = {"hips, 0.6 s", "chest, 0.4 s", "hand, 0.2 s"};
    static const float times[3] = {0.6f, 0.4f, 0.2f};
    svg_point lines[3][FIGURE_STEPS + 1];
    svg_plot_frame(s, plot);
    for (int i = 0; i <= FIGURE_STEPS; i++) {
        const float elapsed = 0.6f * (float)i / FIGURE_STEPS;
        float mask[NKW_POSE_STRIDE(3)];
        nkw_mask_from_times(times, elapsed, NKW_EASE_CUBIC_IN_OUT, (nkw_mask_span){mask, 3});
        for (int j = 0; j < 3; j++)
            lines[j][i] = svg_plot_at(plot, elapsed, mask[j]);
    }
    for (int j = 0; j < 3; j++) {
        const svg_paint paint = svg_stroke(colours[j], 2.4f, 1.0f);
        svg_polyline(s, lines[j], FIGURE_STEPS + 1, &paint);
        figure_legend(s, plot->box.x + 140.0f * (float)j, plot->box.y + plot->box.height + 62.0f, &paint, names[j]);
    }
}

int figure_layer_space(const char *path)
{
    svg s;
    const svg_plot branch = {{70.0f, 480.0f, 400.0f, 150.0f}, {0.0f, 7.0f, 1.0f, "joint"}, {0.0f, 1.0f, 0.5f, ""}};
    const svg_plot times = {{570.0f, 480.0f, 400.0f, 150.0f}, {0.0f, 0.6f, 0.2f, "time, s"}, {0.0f, 1.0f, 0.5f, ""}};
    if (!figure_open(&s, path, 1040.0f, 710.0f, "Layers in model space, in joints and in time",
                     "An aim is added to a bowed body: the way of the hand, and its shadow on the floor."))
        return 0;
    bowed(&s, svg_at(290.0f, 345.0f), 0, "LOCAL: about the bowed spine");
    bowed(&s, svg_at(800.0f, 345.0f), 1, "In model space: level");
    figure_bold(&s, 30.0f, 462.0f, 15.0f, FIGURE_INK, 's', "nkw_mask_from_branch: a branch from joint 2 on");
    figure_bold(&s, 530.0f, 462.0f, 15.0f, FIGURE_INK, 's', "nkw_mask_from_times: a time for each joint");
    draw_branch(&s, &branch);
    draw_times(&s, &times);
    return svg_close(&s);
}
