/* SPDX-License-Identifier: MIT */
/*
 * A figure of sticks: two poses blended, a mask, a difference on top, the mirror, a mirror through the rest pose; the
 * mean of three rotations.
 */
#include "figure.h"

#include <nakawari/blend.h>
#include <nakawari/euler.h>
#include <nakawari/mat.h>
#include <nakawari/mirror.h>
#include <nakawari/pose.h>
#include <nakawari/quat.h>
#include <nakawari/skeleton.h>

enum {
    PELVIS,
    SPINE,
    HEAD,
    LEFT_ARM,
    LEFT_HAND,
    RIGHT_ARM,
    RIGHT_HAND,
    LEFT_LEG,
    LEFT_FOOT,
    RIGHT_LEG,
    RIGHT_FOOT,
    JOINTS
};
enum { FLOATS = NKW_POSE_FLOATS(JOINTS) };

static const int32_t parents[JOINTS] = {-1,        PELVIS, SPINE,    SPINE,  LEFT_ARM, SPINE,
                                        RIGHT_ARM, PELVIS, LEFT_LEG, PELVIS, RIGHT_LEG};
static const int32_t pairs[JOINTS] = {PELVIS,    SPINE,     HEAD,       RIGHT_ARM, RIGHT_HAND, LEFT_ARM,
                                      LEFT_HAND, RIGHT_LEG, RIGHT_FOOT, LEFT_LEG,  LEFT_FOOT};

/* Where a joint is in its parent, and where its bone ends in its own space. */
static const nkw_vec3 place[JOINTS] = {{0, 0, 0},      {0, 0.1f, 0},    {0, 0.75f, 0},  {-0.2f, 0.7f, 0},
                                       {0, -0.45f, 0}, {0.2f, 0.7f, 0}, {0, -0.45f, 0}, {-0.12f, 0, 0},
                                       {0, -0.55f, 0}, {0.12f, 0, 0},   {0, -0.55f, 0}};
static const nkw_vec3 tip[JOINTS] = {{0, 0.1f, 0},   {0, 0.75f, 0},  {0, 0.22f, 0}, {0, -0.45f, 0},
                                     {0, -0.4f, 0},  {0, -0.45f, 0}, {0, -0.4f, 0}, {0, -0.55f, 0},
                                     {0, -0.55f, 0}, {0, -0.55f, 0}, {0, -0.55f, 0}};

/* Turns of all joints in radians, counter-clockwise. */
typedef float turns[JOINTS];

static const turns stand = {0, 0, 0, -0.15f, -0.1f, 0.15f, 0.1f, -0.05f, 0, 0.05f, 0};
static const turns stride = {0.05f, -0.1f, 0, -0.9f, -0.5f, 0.5f, 0.9f, -0.55f, 0.15f, 0.5f, 0.0f};
static const turns jump = {0, 0, 0, -2.4f, -0.35f, 2.4f, 0.35f, -1.0f, 1.3f, 1.0f, -1.3f};
static const turns wave = {0, 0, 0.2f, -0.15f, -0.1f, 2.0f, 1.0f, -0.05f, 0, 0.05f, 0};
static const turns lean = {0, -0.45f, -0.35f, -0.15f, -0.1f, 0.15f, 0.1f, -0.05f, 0, 0.05f, 0};

static void pose_of(const turns by, float *pose)
{
    const nkw_vec3 z = {0.0f, 0.0f, 1.0f};
    nkw_pose_identity((nkw_pose_span){pose, JOINTS});
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_trs trs = {place[j], nkw_quat_from_axis_angle(z, by[j]), {1.0f, 1.0f, 1.0f}};
        nkw_pose_set((nkw_pose_span){pose, JOINTS}, j, &trs);
    }
}

static svg_point on_page(svg_point feet, nkw_vec3 p)
{
    return svg_at(feet.x + 62.0f * p.x, feet.y - 62.0f * (p.y + 1.1f));
}

static svg_colour colour_of(int j)
{
    return j == LEFT_ARM || j == LEFT_HAND || j == LEFT_LEG || j == LEFT_FOOT       ? 0xd55e00
           : j == RIGHT_ARM || j == RIGHT_HAND || j == RIGHT_LEG || j == RIGHT_FOOT ? 0x1f5fd0
                                                                                    : 0x2b2b30;
}

static void figure_with(svg *s, svg_point feet, const float *pose, const nkw_vec3 *tips, float opacity)
{
    const nkw_skeleton skeleton = {parents, JOINTS};
    nkw_mat4 models[JOINTS];
    nkw_skeleton_models_from_pose(&skeleton, (nkw_pose_view){pose, skeleton.joint_count}, NULL, NULL, models);
    svg_begin(s, opacity);
    for (int j = 0; j < JOINTS; j++) {
        svg_point a = on_page(feet, nkw_mat4_translation(&models[j]));
        svg_point b = on_page(feet, nkw_mat4_transform_point(&models[j], tips[j]));
        svg_paint bone = svg_stroke(colour_of(j), 6.0f, 1.0f), skull = svg_fill(colour_of(j), 1.0f);
        if (j == HEAD)
            svg_circle(s, b, 11.0f, &skull);
        else
            svg_line(s, a, b, &bone);
        svg_paint knob = svg_fill(colour_of(j), 1.0f);
        svg_circle(s, a, 3.0f, &knob);
        svg_circle(s, b, 3.0f, &knob);
    }
    svg_end(s);
}

static void figure_of(svg *s, svg_point feet, const float *pose, float opacity)
{
    figure_with(s, feet, pose, tip, opacity);
}

static void named(svg *s, svg_point feet, const float *pose, const char *name)
{
    figure_of(s, feet, pose, 1.0f);
    figure_text(s, feet.x, feet.y + 24.0f, 13.0f, FIGURE_INK, 'm', name);
}

static void sign(svg *s, float x, float y, const char *text)
{
    figure_bold(s, x, y, 22.0f, FIGURE_PALE, 'm', text);
}

static void two_poses(svg *s, float y)
{
    static const char *const names[5] = {"a: t = 0", "t = 0.25", "t = 0.5", "t = 0.75", "b: t = 1"};
    float a[FLOATS], b[FLOATS], out[FLOATS];
    pose_of(stride, a);
    pose_of(jump, b);
    figure_bold(s, 24.0f, y - 190.0f, 15.0f, FIGURE_INK, 's', "Two poses: nkw_pose_blend");
    for (int i = 0; i < 5; i++) {
        nkw_pose_blend((nkw_pose_view){a, JOINTS}, (nkw_pose_view){b, JOINTS}, 0.25f * (float)i,
                       (nkw_mask_view){NULL, JOINTS}, (nkw_pose_span){out, JOINTS});
        named(s, svg_at(100.0f + 190.0f * (float)i, y), out, names[i]);
    }
}

static void masked(svg *s, float x, float y)
{
    float a[FLOATS], b[FLOATS], out[FLOATS], arm[NKW_POSE_STRIDE(JOINTS)];
    pose_of(stride, a);
    pose_of(wave, b);
    const nkw_skeleton skeleton = {parents, JOINTS};
    nkw_mask_from_subtree(&skeleton, RIGHT_ARM, (nkw_mask_span){arm, JOINTS});
    nkw_pose_blend((nkw_pose_view){a, JOINTS}, (nkw_pose_view){b, JOINTS}, 1.0f, (nkw_mask_view){arm, JOINTS},
                   (nkw_pose_span){out, JOINTS});
    figure_bold(s, x, y - 190.0f, 15.0f, FIGURE_INK, 's', "A mask: one arm of the wave");
    named(s, svg_at(x + 66.0f, y), a, "walk");
    sign(s, x + 126.0f, y - 48.0f, "+");
    named(s, svg_at(x + 182.0f, y), b, "wave");
    sign(s, x + 244.0f, y - 48.0f, "=");
    named(s, svg_at(x + 306.0f, y), out, "arm: 1, the rest: 0");
}

static void added(svg *s, float x, float y)
{
    float base[FLOATS], ref[FLOATS], a[FLOATS], delta[FLOATS], out[FLOATS];
    pose_of(stride, base);
    pose_of(stand, ref);
    pose_of(lean, a);
    nkw_pose_additive_build((nkw_pose_view){a, JOINTS}, (nkw_pose_view){ref, JOINTS}, NKW_ADDITIVE_LOCAL,
                            (nkw_pose_span){delta, JOINTS});
    nkw_pose_additive_apply((nkw_pose_view){base, JOINTS}, (nkw_pose_view){delta, JOINTS}, 1.0f,
                            (nkw_mask_view){NULL, JOINTS}, NKW_ADDITIVE_LOCAL, (nkw_pose_span){out, JOINTS});
    figure_bold(s, x, y - 190.0f, 15.0f, FIGURE_INK, 's', "A difference: from ref (pale) to a");
    named(s, svg_at(x + 56.0f, y), base, "walk");
    sign(s, x + 116.0f, y - 48.0f, "+");
    figure_of(s, svg_at(x + 172.0f, y), ref, 0.25f);
    named(s, svg_at(x + 172.0f, y), a, "from ref to a");
    sign(s, x + 234.0f, y - 48.0f, "=");
    named(s, svg_at(x + 290.0f, y), out, "walk, leaning");
}

static void mirrored(svg *s, float x, float y)
{
    float a[FLOATS], out[FLOATS];
    svg_paint plane = svg_stroke(FIGURE_PALE, 1.4f, 1.0f);
    plane.dash = "5 4";
    pose_of(stride, a);
    nkw_pose_mirror((nkw_pose_view){a, JOINTS}, pairs, NKW_MIRROR_X, (nkw_pose_span){out, JOINTS}, NULL);
    figure_bold(s, x, y - 190.0f, 15.0f, FIGURE_INK, 's', "The mirror: x = 0");
    named(s, svg_at(x + 60.0f, y), a, "walk");
    svg_line(s, svg_at(x + 124.0f, y - 160.0f), svg_at(x + 124.0f, y + 6.0f), &plane);
    named(s, svg_at(x + 188.0f, y), out, "mirrored");
}

int figure_blend_poses(const char *path)
{
    svg s;
    if (!figure_open(
            &s, path, 1040.0f, 580.0f, "Operations on poses",
            "The limbs of one side are orange, those of the other blue: the mirror does not change which is which."))
        return 0;
    two_poses(&s, 284.0f);
    masked(&s, 24.0f, 540.0f);
    added(&s, 410.0f, 540.0f);
    mirrored(&s, 776.0f, 540.0f);
    return svg_close(&s);
}

/* ---- a rig whose right arm has the axes x, -y, -z of the left ---- */

static void turned_pose_of(const turns by, float *pose)
{
    const nkw_quat half_turn = {1.0f, 0.0f, 0.0f, 0.0f};
    pose_of(by, pose);
    nkw_trs arm = nkw_pose_get((nkw_pose_view){pose, JOINTS}, RIGHT_ARM), hand;
    hand = nkw_pose_get((nkw_pose_view){pose, JOINTS}, RIGHT_HAND);
    arm.rotation = nkw_quat_mul(arm.rotation, half_turn);
    hand.rotation = nkw_quat_conjugate(hand.rotation); /* the half turn about x, its inverse before: z becomes -z */
    hand.translation.y = -hand.translation.y;
    nkw_pose_set((nkw_pose_span){pose, JOINTS}, RIGHT_ARM, &arm);
    nkw_pose_set((nkw_pose_span){pose, JOINTS}, RIGHT_HAND, &hand);
}

static void turned(svg *s, svg_point feet, const float *pose, const char *name)
{
    nkw_vec3 tips[JOINTS];
    for (int j = 0; j < JOINTS; j++)
        tips[j] = j == RIGHT_ARM || j == RIGHT_HAND ? nkw_vec3_negate(tip[j]) : tip[j];
    figure_with(s, feet, pose, tips, 1.0f);
    figure_text(s, feet.x, feet.y + 24.0f, 13.0f, FIGURE_INK, 'm', name);
}

int figure_mirror_rest(const char *path)
{
    svg s;
    static const turns none = {0};
    float rest[FLOATS], pose[FLOATS], plain[FLOATS], through[FLOATS];
    NKW_STACK_WORK(work, NKW_MIRROR_WORK(JOINTS));
    turned_pose_of(none, rest);
    turned_pose_of(wave, pose);
    const nkw_mirror_rig rig = {parents, pairs, {rest, JOINTS}, NKW_MIRROR_X};
    nkw_pose_mirror((nkw_pose_view){pose, JOINTS}, pairs, NKW_MIRROR_X, (nkw_pose_span){plain, JOINTS}, NULL);
    nkw_pose_mirror_rest((nkw_pose_view){pose, JOINTS}, &rig, (nkw_pose_span){through, JOINTS}, NULL, NULL, work);
    if (!figure_open(&s, path, 1040.0f, 330.0f, "A rig whose right arm has the axes x, -y, -z of the left one",
                     "Mirrored local transforms turn both arms by half a turn, also in the rest pose. Through the rest "
                     "pose the motion is mirrored."))
        return 0;
    turned(&s, svg_at(130.0f, 290.0f), rest, "rest pose");
    turned(&s, svg_at(390.0f, 290.0f), pose, "pose");
    turned(&s, svg_at(650.0f, 290.0f), plain, "nkw_pose_mirror");
    turned(&s, svg_at(910.0f, 290.0f), through, "nkw_pose_mirror_rest");
    return svg_close(&s);
}

/* ---- the mean of three rotations about z ---- */

#define THIRD 2.2f

/* The angle of a turn about z, 0 .. 2 pi. */
static float turn_of(nkw_quat q)
{
    const float angle = 2.0f * nkw_atan2(q.z, q.w);
    return angle < 0.0f ? angle + 6.2831853f : angle > 6.2831853f ? angle - 6.2831853f : angle;
}

/* The heaviest first, each with the sign nearer to the sum so far: the sum of many programs. */
static float sum_in_order(const nkw_quat q[3], const float w[3])
{
    int order[3] = {0, 1, 2};
    for (int i = 0; i < 3; i++)
        for (int k = i + 1; k < 3; k++)
            if (w[order[k]] > w[order[i]]) {
                const int swapped = order[i];
                order[i] = order[k];
                order[k] = swapped;
            }
    nkw_quat sum = nkw_quat_scale(q[order[0]], w[order[0]]);
    for (int i = 1; i < 3; i++) {
        const nkw_quat other = nkw_quat_scale(q[order[i]], w[order[i]]);
        sum = nkw_quat_add(sum, nkw_quat_dot(sum, other) < 0.0f ? nkw_quat_negate(other) : other);
    }
    return turn_of(sum);
}

int figure_blend_mean(const char *path)
{
    svg s;
    const nkw_vec3 z = {0.0f, 0.0f, 1.0f};
    const float angles[3] = {0.0f, THIRD, -THIRD};
    const svg_plot plot = {{70.0f, 100.0f, 890.0f, 300.0f}, {0.0f, 1.0f, 0.1f, "x"}, {1.5f, 5.0f, 0.5f, "angle, rad"}};
    const svg_paint mean = svg_stroke(FIGURE_CATMULL_ROM, 2.6f, 1.0f), markley = svg_stroke(FIGURE_BSPLINE, 1.6f, 1.0f);
    svg_paint order = svg_stroke(FIGURE_NLERP, 1.8f, 1.0f);
    float poses[3][NKW_POSE_FLOATS(1)], out[NKW_POSE_FLOATS(1)], y[3][FIGURE_STEPS + 1];
    nkw_quat q[3];
    order.dash = "6 4";
    for (int k = 0; k < 3; k++) {
        nkw_trs trs = {{0.0f, 0.0f, 0.0f}, nkw_quat_from_axis_angle(z, angles[k]), {1.0f, 1.0f, 1.0f}};
        q[k] = trs.rotation;
        nkw_pose_set((nkw_pose_span){poses[k], 1}, 0, &trs);
    }
    for (int i = 0; i <= FIGURE_STEPS; i++) {
        const float b = 0.8f * (float)i / (float)FIGURE_STEPS, w[3] = {0.2f, b, 0.8f - b};
        nkw_pose_layer layers[3];
        for (int k = 0; k < 3; k++)
            layers[k] = (nkw_pose_layer){{poses[k], 1}, w[k], {NULL, 1}};
        nkw_pose_layers_blend(layers, 3, (nkw_pose_view){poses[0], 1}, 0.0f, (nkw_pose_span){out, 1});
        y[0][i] = turn_of(nkw_pose_get((nkw_pose_view){out, 1}, 0).rotation);
        y[1][i] = sum_in_order(q, w);
        y[2][i] = turn_of(nkw_quat_mean(q, 3, w));
    }
    if (!figure_open(&s, path, 1000.0f, 480.0f, "The mean of three turns while two weights exchange",
                     "a: 0 rad, weight 0.2; b: 2.2 rad, weight 0.8 x; c: -2.2 rad, that is 4.08, weight 0.8 (1 - x)."))
        return 0;
    svg_plot_frame(&s, &plot);
    figure_graph(&s, &plot, y[2], &markley);
    figure_graph(&s, &plot, y[1], &order);
    figure_graph(&s, &plot, y[0], &mean);
    figure_legend(&s, 70.0f, 455.0f, &mean, "nkw_pose_layers_blend");
    figure_legend(&s, 350.0f, 455.0f, &order, "sum, the heaviest first: it jumps");
    figure_legend(&s, 690.0f, 455.0f, &markley, "nkw_quat_mean");
    return svg_close(&s);
}
