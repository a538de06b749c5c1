/* SPDX-License-Identifier: MIT */
/* One pose on three skeletons; the weights of a blend space. */
#include "figure.h"

#include <nakawari/blendspace.h>
#include <nakawari/mat.h>
#include <nakawari/quat.h>
#include <nakawari/retarget.h>
#include <nakawari/vec.h>

enum { HIPS, SPINE, HEAD, ARM_L, HAND_L, ARM_R, HAND_R, LEG_L, FOOT_L, LEG_R, FOOT_R, JOINTS };
enum { FLOATS = NKW_POSE_FLOATS(JOINTS) };

static const int32_t parents[JOINTS] = {-1, HIPS, SPINE, SPINE, ARM_L, SPINE, ARM_R, HIPS, LEG_L, HIPS, LEG_R};

/* From the parent joint, in model space, in the T-pose; and where the bone of a joint ends. */
static const nkw_vec3 place[JOINTS] = {{0, 1, 0},      {0, 0.1f, 0},      {0, 0.5f, 0},  {0.2f, 0.45f, 0},
                                       {0.3f, 0, 0},   {-0.2f, 0.45f, 0}, {-0.3f, 0, 0}, {0.12f, 0, 0},
                                       {0, -0.48f, 0}, {-0.12f, 0, 0},    {0, -0.48f, 0}};
static const nkw_vec3 tip[JOINTS] = {{0, 0.1f, 0},   {0, 0.5f, 0},   {0, 0.2f, 0},   {0.3f, 0, 0},
                                     {0.28f, 0, 0},  {-0.3f, 0, 0},  {-0.28f, 0, 0}, {0, -0.48f, 0},
                                     {0, -0.48f, 0}, {0, -0.48f, 0}, {0, -0.48f, 0}};
static const float bends[JOINTS] = {0.1f, -0.25f, 0.3f, 0.6f, 0.9f, -1.0f, 0.5f, 0.35f, -0.3f, -0.5f, 0.2f};

typedef struct doll {
    float rest[FLOATS];
    nkw_quat axes[JOINTS]; /* from a joint's space to the model's, in the rest pose */
    float legs, arms; /* factors of lengths */
} doll;

static float factor(const doll *d, int j)
{
    return j == HIPS || j >= LEG_L ? d->legs : j >= ARM_L ? d->arms : 1.0f;
}

/* A rest pose with joints whose axes are turned by `turn` more each. */
static void make_doll(doll *d, float turn, float legs, float arms)
{
    const nkw_vec3 z = {0, 0, 1};
    d->legs = legs;
    d->arms = arms;
    nkw_pose_identity((nkw_pose_span){d->rest, JOINTS});
    for (int j = 0; j < JOINTS; j++) {
        nkw_quat parent = parents[j] < 0 ? nkw_quat_identity() : d->axes[parents[j]];
        d->axes[j] = nkw_quat_from_axis_angle(z, turn * (float)(j + 1));
        nkw_trs trs = {nkw_quat_rotate_inverse(parent, nkw_vec3_scale(place[j], factor(d, j))),
                       nkw_quat_mul(nkw_quat_conjugate(parent), d->axes[j]),
                       {1, 1, 1}};
        nkw_pose_set((nkw_pose_span){d->rest, JOINTS}, (size_t)j, &trs);
    }
}

static svg_point on_page(svg_point feet, nkw_vec3 p)
{
    return svg_at(feet.x + 105.0f * p.x, feet.y - 105.0f * p.y);
}

static void draw_doll(svg *s, svg_point feet, const doll *d, const float *pose, svg_colour colour)
{
    const nkw_skeleton skeleton = {parents, JOINTS};
    nkw_mat4 models[JOINTS];
    svg_paint bone = svg_stroke(colour, 7.0f, 1.0f), head = svg_fill(colour, 1.0f);
    svg_paint axis_x = svg_stroke(0xc62828, 1.6f, 1.0f), axis_y = svg_stroke(0x2e7d32, 1.6f, 1.0f);
    nkw_skeleton_models_from_pose(&skeleton, (nkw_pose_view){pose, JOINTS}, NULL, NULL, models);
    for (int j = 0; j < JOINTS; j++) {
        nkw_vec3 end = nkw_quat_rotate_inverse(d->axes[j], nkw_vec3_scale(tip[j], j == HIPS ? 1.0f : factor(d, j)));
        svg_point a = on_page(feet, nkw_mat4_translation(&models[j]));
        svg_point b = on_page(feet, nkw_mat4_transform_point(&models[j], end));
        svg_line(s, a, b, &bone);
        if (j == HEAD)
            svg_circle(s, b, 13.0f, &head);
    }
    for (int j = 0; j < JOINTS; j++) {
        nkw_vec3 origin = nkw_mat4_translation(&models[j]);
        nkw_vec3 x = nkw_mat4_transform_point(&models[j], (nkw_vec3){0.11f, 0, 0});
        nkw_vec3 y = nkw_mat4_transform_point(&models[j], (nkw_vec3){0, 0.11f, 0});
        svg_line(s, on_page(feet, origin), on_page(feet, x), &axis_x);
        svg_line(s, on_page(feet, origin), on_page(feet, y), &axis_y);
    }
}

static void retarget(const doll *source, const float *pose, const doll *target, float *out)
{
    const nkw_skeleton skeleton = {parents, JOINTS};
    nkw_retarget_joint map[JOINTS];
    NKW_STACK_WORK(work, NKW_RETARGET_WORK(JOINTS, JOINTS));
    for (int32_t j = 0; j < JOINTS; j++)
        map[j] = (nkw_retarget_joint){j, NKW_NO_JOINT, 0.0f, j == HIPS ? target->legs : 0.0f};
    nkw_retarget r = {skeleton, skeleton, {source->rest, JOINTS}, {target->rest, JOINTS}, map, {0, 0, 0, 1}};
    nkw_retarget_apply(&r, (nkw_pose_view){pose, JOINTS}, (nkw_pose_span){out, JOINTS}, work);
}

int figure_retarget_axes(const char *path)
{
    const nkw_vec3 z = {0, 0, 1};
    doll source, turned, long_legs;
    float pose[FLOATS], out[FLOATS];
    svg s;
    make_doll(&source, 0.0f, 1.0f, 1.0f);
    make_doll(&turned, 0.7f, 1.0f, 1.0f);
    make_doll(&long_legs, -0.4f, 1.25f, 0.8f);
    nkw_pose_identity((nkw_pose_span){pose, JOINTS});
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_trs trs = nkw_pose_get((nkw_pose_view){source.rest, JOINTS}, j);
        trs.rotation = nkw_quat_from_axis_angle(z, bends[j]);
        nkw_pose_set((nkw_pose_span){pose, JOINTS}, j, &trs);
    }
    if (!figure_open(&s, path, 960.0f, 420.0f, "One pose on three skeletons",
                     "Red and green: the x and y axes of the joints. Pale: the rest pose of each."))
        return 0;
    draw_doll(&s, svg_at(130.0f, 350.0f), &source, source.rest, 0xd4d4da);
    draw_doll(&s, svg_at(300.0f, 350.0f), &source, pose, 0xd55e00);
    figure_text(&s, 215.0f, 395.0f, 14.0f, FIGURE_INK, 'm', "the source");
    retarget(&source, pose, &turned, out);
    draw_doll(&s, svg_at(450.0f, 350.0f), &turned, turned.rest, 0xd4d4da);
    draw_doll(&s, svg_at(610.0f, 350.0f), &turned, out, 0x1f5fd0);
    figure_text(&s, 530.0f, 395.0f, 14.0f, FIGURE_INK, 'm', "other axes");
    retarget(&source, pose, &long_legs, out);
    draw_doll(&s, svg_at(760.0f, 350.0f), &long_legs, long_legs.rest, 0xd4d4da);
    draw_doll(&s, svg_at(890.0f, 350.0f), &long_legs, out, 0x1f5fd0);
    figure_text(&s, 830.0f, 395.0f, 14.0f, FIGURE_INK, 'm', "other axes and lengths");
    return svg_close(&s);
}

/* ---- Blend space ---- */

enum { SAMPLES = 7, CELLS = 30 };

static const float samples[2 * SAMPLES] = {0, 0, 0, 1.5f, 0, 4, 1.3f, 0, -1.3f, 0, 2.4f, 2.4f, -2.4f, 2.4f};
static const svg_colour colours[SAMPLES] = {0x9a9aa2, 0x1f5fd0, 0xd55e00, 0x00897b, 0x7b3fa0, 0xe0a800, 0xc2185b};
static const char *const names[SAMPLES] = {"idle", "walk", "run", "step right", "step left", "run right", "run left"};

/* The colours of the samples, mixed by their weights. */
static svg_colour mixed(const nkw_blendspace *space, float x, float y)
{
    float weights[SAMPLES], point[2] = {x, y}, total = 0.0f;
    svg_colour colour = 0xffffff;
    nkw_blendspace_weights(space, point, weights);
    for (int i = 0; i < SAMPLES; i++) {
        total += weights[i];
        colour = weights[i] > 0.0f ? svg_mix(colour, colours[i], weights[i] / total) : colour;
    }
    return svg_mix(0xffffff, colour, 0.75f);
}

static void space_map(svg *s, float left, nkw_blendspace_kind kind, const char *name)
{
    const svg_plot plot = {
        {left, 100.0f, 400.0f, 400.0f}, {-3.2f, 3.2f, 1.0f, "right, m/s"}, {-1.6f, 4.8f, 1.0f, "ahead, m/s"}};
    const nkw_blendspace space = {samples, SAMPLES, 2, kind};
    const float size = 400.0f / (float)CELLS;
    svg_plot_frame(s, &plot);
    for (int i = 0; i < CELLS * CELLS; i++) {
        float x = -3.2f + 6.4f * ((float)(i % CELLS) + 0.5f) / (float)CELLS;
        float y = -1.6f + 6.4f * ((float)(i / CELLS) + 0.5f) / (float)CELLS;
        svg_point p = svg_plot_at(&plot, x, y);
        svg_box box = {p.x - 0.5f * size, p.y - 0.5f * size, size + 0.3f, size + 0.3f};
        svg_paint fill = svg_fill(mixed(&space, x, y), 1.0f);
        svg_rect(s, box, 0.0f, &fill);
    }
    for (int i = 0; i < SAMPLES; i++) {
        svg_point p = svg_plot_at(&plot, samples[2 * i], samples[2 * i + 1]);
        figure_key(s, p);
        figure_name(s, p.x, p.y - 12.0f, FIGURE_INK, 'm', names[i]);
    }
    figure_bold(s, left + 200.0f, 90.0f, 15.0f, FIGURE_INK, 'm', name);
}

int figure_blendspace_weights(const char *path)
{
    svg s;
    if (!figure_open(&s, path, 980.0f, 570.0f, "Seven animations in a blend space",
                     "Each sample has a colour; a point has the mixture of their weights."))
        return 0;
    space_map(&s, 70.0f, NKW_BLENDSPACE_CARTESIAN, "Cartesian");
    space_map(&s, 550.0f, NKW_BLENDSPACE_POLAR, "polar: speed and direction");
    return svg_close(&s);
}
