/* SPDX-License-Identifier: MIT */
/* Inverse kinematics: legs to targets, a chain by two solvers, limits of a swing, a locked foot. */
#include "figure.h"

#include <nakawari/foot.h>
#include <nakawari/ik.h>
#include <nakawari/orient.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

enum { ORANGE = 0xd55e00, BLUE = 0x1f5fd0, GREEN = 0x00897b };

static nkw_vec3 at(float x, float y, float z)
{
    nkw_vec3 r = {x, y, z};
    return r;
}

/* ---- Limbs and chains, seen from the side: x to the right, y up ---- */

static svg_point on_page(svg_point origin, nkw_vec3 p)
{
    return svg_at(origin.x + 130.0f * p.x, origin.y - 130.0f * p.y);
}

static void bones(svg *s, svg_point origin, const nkw_vec3 *joints, int count, svg_colour colour, float width)
{
    svg_paint bone = svg_stroke(colour, width, 1.0f), knob = svg_fill(colour, 1.0f);
    for (int i = 0; i + 1 < count; i++)
        svg_line(s, on_page(origin, joints[i]), on_page(origin, joints[i + 1]), &bone);
    for (int i = 0; i < count; i++)
        svg_circle(s, on_page(origin, joints[i]), 0.75f * width, &knob);
}

static void cross(svg *s, svg_point p)
{
    svg_paint line = svg_stroke(FIGURE_INK, 2.2f, 1.0f);
    svg_line(s, svg_at(p.x - 7.0f, p.y - 7.0f), svg_at(p.x + 7.0f, p.y + 7.0f), &line);
    svg_line(s, svg_at(p.x - 7.0f, p.y + 7.0f), svg_at(p.x + 7.0f, p.y - 7.0f), &line);
}

static void leg(svg *s, svg_point hip, nkw_vec3 target, nkw_vec3 pole, const char *name)
{
    nkw_ik_two_bone limb = {{0, 0, 0}, {0.08f, -0.6f, 0}, {0, -1.2f, 0}, target, pole, {0, 0, 0}, 0.0f, 1.0f};
    nkw_ik_two_bone_solution r = nkw_ik_two_bone_solve(&limb);
    const nkw_vec3 before[3] = {limb.root, limb.mid, limb.end}, after[3] = {limb.root, r.mid_position, r.end_position};
    char text[SVG_DIGITS];
    bones(s, hip, before, 3, 0xd4d4da, 7.0f);
    bones(s, hip, after, 3, BLUE, 8.0f);
    cross(s, on_page(hip, target));
    figure_text(s, hip.x, hip.y + 205.0f, 13.0f, FIGURE_INK, 'm', name);
    svg_number(text, r.error, 2);
    figure_text(s, hip.x - 4.0f, hip.y + 223.0f, 13.0f, FIGURE_GREY, 'e', "error");
    figure_text(s, hip.x + 4.0f, hip.y + 223.0f, 13.0f, FIGURE_GREY, 's', text);
}

int figure_ik_limb(const char *path)
{
    const nkw_vec3 none = {0, 0, 0}, back = {-1, 0.2f, 0};
    svg s;
    if (!figure_open(&s, path, 960.0f, 382.0f, "A leg and its targets",
                     "Grey: the pose. Blue: solved. The error is the distance of the foot from the target."))
        return 0;
    leg(&s, svg_at(110.0f, 110.0f), at(0.45f, -0.85f, 0), none, "within reach");
    leg(&s, svg_at(300.0f, 110.0f), at(0.45f, -0.85f, 0), back, "the pole behind");
    leg(&s, svg_at(490.0f, 110.0f), at(0.75f, -1.3f, 0), none, "out of reach");
    leg(&s, svg_at(680.0f, 110.0f), at(0.02f, -0.15f, 0), none, "near the hip");
    leg(&s, svg_at(840.0f, 140.0f), at(0.3f, 0.35f, 0), none, "above");
    return svg_close(&s);
}

enum { LINKS = 8 };

static void chain(svg *s, svg_point origin, int ccd, uint32_t iterations, nkw_vec3 target)
{
    nkw_vec3 offsets[LINKS], joints[LINKS + 1];
    nkw_quat rotations[LINKS], q = nkw_quat_identity();
    for (int k = 0; k < LINKS; k++) {
        offsets[k] = at(0.24f, 0, 0);
        rotations[k] = nkw_quat_from_axis_angle(at(0, 0, 1), k ? 0.06f : 0.9f);
    }
    nkw_ik_chain c = {{0, 0, 0}, {0, 0, 0, 1}, offsets, NULL, LINKS};
    nkw_ik_goal goal = {target, 1e-3f, iterations};
    NKW_STACK_WORK(work, NKW_IK_CHAIN_WORK(LINKS));
    nkw_ik_chain_solve(&c, &goal, ccd ? NKW_IK_CCD : NKW_IK_FABRIK, rotations, NULL, work);
    joints[0] = NKW_VEC3_ZERO;
    for (int k = 0; k < LINKS; k++) {
        q = nkw_quat_mul(q, rotations[k]);
        joints[k + 1] = nkw_vec3_add(joints[k], nkw_quat_rotate(q, offsets[k]));
    }
    svg_colour colour = ccd ? ORANGE : BLUE;
    svg_colour shade = iterations ? svg_mix(0xffffff, colour, iterations > 20 ? 1.0f : 0.4f) : 0xd4d4da;
    bones(s, origin, joints, LINKS + 1, shade, iterations > 20 ? 6.0f : 4.0f);
}

static void chains(svg *s, svg_point origin, int ccd, const char *name)
{
    nkw_vec3 target = at(1.05f, -0.1f, 0);
    chain(s, origin, ccd, 0, target);
    chain(s, origin, ccd, 1, target);
    chain(s, origin, ccd, 2, target);
    chain(s, origin, ccd, 50, target);
    cross(s, on_page(origin, target));
    figure_bold(s, origin.x + 70.0f, origin.y + 70.0f, 14.0f, FIGURE_INK, 'm', name);
}

int figure_ik_chain(const char *path)
{
    svg s;
    if (!figure_open(&s, path, 760.0f, 430.0f, "A chain of eight joints",
                     "Grey: the pose. Pale: after one and two iterations. Strong: solved to a thousandth."))
        return 0;
    chains(&s, svg_at(100.0f, 330.0f), 0, "FABRIK");
    chains(&s, svg_at(470.0f, 330.0f), 1, "cyclic coordinate descent");
    return svg_close(&s);
}

/* ---- Limits ---- */

static nkw_vec3 swing_vector(nkw_quat q)
{
    return nkw_vec3_scale(nkw_quat_log(q), 2.0f);
}

static svg_point limited(const svg_plot *plot, float x, float y)
{
    nkw_quat q = nkw_quat_exp(at(0.5f * x, 0.5f * y, 0));
    nkw_limit limit = NKW_LIMIT_NONE;
    limit.axis = at(0, 0, 1);
    limit.side = at(1, 0, 0);
    limit.swing_side = 1.2f;
    limit.swing_across = 0.5f;
    nkw_vec3 v = swing_vector(nkw_limit_apply(&limit, q));
    return svg_plot_at(plot, v.x, v.y);
}

int figure_limit_ellipse(const char *path)
{
    const svg_plot plot = {{70.0f, 90.0f, 640.0f, 400.0f},
                           {-1.92f, 1.92f, 0.5f, "swing about the side, rad"},
                           {-1.2f, 1.2f, 0.5f, "swing about the other axis, rad"}};
    svg s;
    if (!figure_open(&s, path, 760.0f, 550.0f, "Swings within an ellipse",
                     "A swing outside moves to the nearest point of the boundary; one inside stays, bit for bit."))
        return 0;
    svg_plot_frame(&s, &plot);
    svg_point edge[FIGURE_STEPS + 1];
    for (int i = 0; i <= FIGURE_STEPS; i++) {
        float angle = 6.2831853f * (float)i / (float)FIGURE_STEPS;
        edge[i] = svg_plot_at(&plot, 1.2f * nkw_cos(angle), 0.5f * nkw_sin(angle));
    }
    svg_paint area = {0xe4ecfb, BLUE, 2.0f, 1.0f, NULL}, arrow = svg_stroke(ORANGE, 1.6f, 1.0f);
    svg_polygon(&s, edge, FIGURE_STEPS, &area);
    for (int i = 0; i < 24; i++) {
        float angle = 6.2831853f * ((float)i + 0.5f) / 24.0f, x = 1.65f * nkw_cos(angle), y = 1.02f * nkw_sin(angle);
        svg_point from = svg_plot_at(&plot, x, y);
        svg_arrow(&s, from, limited(&plot, x, y), &arrow);
        figure_dot(&s, from, ORANGE);
    }
    for (int i = 0; i < 9; i++)
        figure_dot(&s, limited(&plot, 0.25f * (float)(i % 3 - 1) * 2.0f, 0.2f * (float)(i / 3 - 1)), BLUE);
    return svg_close(&s);
}

/* ---- A locked foot ---- */

enum { FRAMES = 180 };

/* A step of one second: the foot slides while it stands, then swings. */
static nkw_vec3 foot_at(float time)
{
    float step = (float)(int)time, t = time - step, swing = nkw_smoothstep(nkw_clamp((t - 0.5f) * 2.0f, 0.0f, 1.0f));
    float sine = t > 0.5f ? nkw_sin(3.14159274f * (2.0f * t - 1.0f)) : 0.0f;
    return at(0.45f * step + 0.6f * swing - 0.3f * nkw_min(t, 0.5f), 0.15f * sine * sine, 0);
}

int figure_foot_lock(const char *path)
{
    const svg_plot plot = {{70.0f, 90.0f, 820.0f, 330.0f}, {0.0f, 3.0f, 0.5f, "time, s"}, {-0.2f, 1.6f, 0.2f, "x, m"}};
    svg_point animated[FRAMES + 1], shown[FRAMES + 1];
    nkw_foot foot = {0};
    const nkw_foot_rules rules = NKW_FOOT_RULES;
    svg s;
    if (!figure_open(&s, path, 940.0f, 490.0f, "A foot that slides on the ground, and the locked foot",
                     "Blue: the foot is in contact, and its position is constant. Transitions take 0.2 s."))
        return 0;
    svg_plot_frame(&s, &plot);
    for (int i = 0; i <= FRAMES; i++) {
        float time = (float)i / 60.0f;
        nkw_vec3 a = foot_at(time), p = nkw_foot_update(&foot, &rules, a, 0.0f, 1.0f / 60.0f);
        svg_point low = svg_plot_at(&plot, time, -0.2f), high = svg_plot_at(&plot, time + 1.0f / 60.0f, 1.6f);
        svg_paint band = svg_fill(0xe4ecfb, 1.0f);
        svg_box box = {low.x, high.y, high.x - low.x, low.y - high.y};
        if (foot.contact && i < FRAMES)
            svg_rect(&s, box, 0.0f, &band);
        animated[i] = svg_plot_at(&plot, time, a.x);
        shown[i] = svg_plot_at(&plot, time, p.x);
    }
    svg_paint pale = svg_stroke(FIGURE_PALE, 2.0f, 1.0f), strong = svg_stroke(BLUE, 3.0f, 1.0f);
    pale.dash = "5 4";
    svg_polyline(&s, animated, FRAMES + 1, &pale);
    svg_polyline(&s, shown, FRAMES + 1, &strong);
    figure_legend(&s, 110.0f, 120.0f, &pale, "the animation");
    figure_legend(&s, 110.0f, 142.0f, &strong, "nkw_foot_update");
    return svg_close(&s);
}
