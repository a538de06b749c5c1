/* SPDX-License-Identifier: MIT */
/* A figure of sticks: two poses blended, a mask, a difference on top, the mirror. */
#include "figure.h"

#include <nakawari/blend.h>
#include <nakawari/mat.h>
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

static void figure_of(svg *s, svg_point feet, const float *pose, float opacity)
{
    const nkw_skeleton skeleton = {parents, JOINTS};
    nkw_mat4 models[JOINTS];
    nkw_skeleton_models_from_pose(&skeleton, (nkw_pose_view){pose, skeleton.joint_count}, NULL, NULL, models);
    svg_begin(s, opacity);
    for (int j = 0; j < JOINTS; j++) {
        svg_point a = on_page(feet, nkw_mat4_translation(&models[j]));
        svg_point b = on_page(feet, nkw_mat4_transform_point(&models[j], tip[j]));
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
