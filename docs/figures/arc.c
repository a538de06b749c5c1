/* SPDX-License-Identifier: MIT */
/* Arcs between two rotations: how fast, which way, and whose sign. */
#include "figure.h"
#include "draw/sphere.h"

#include <stdio.h>

#include <nakawari/mat.h>
#include <nakawari/orient.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

static float radians(float degrees)
{
    return nkw_radians_from_degrees(degrees);
}

static nkw_quat about_y(float degrees)
{
    nkw_vec3 y = {0.0f, 1.0f, 0.0f};
    return nkw_quat_from_axis_angle(y, radians(degrees));
}

/* ---- nlerp against slerp: speed ---- */

enum { TURNS = 4 };
static const float turns[TURNS] = {180.0f, 135.0f, 90.0f, 45.0f};
static const svg_colour turn_colours[TURNS] = {0xb0308f, 0xd55e00, 0xe0a000, 0x7a9c2c};

typedef nkw_quat blend_function(nkw_quat a, nkw_quat b, float t);

/* The angle turned after t, degrees, on the way from 0 to `turn`. */
static float turned(blend_function *blend, float turn, float t)
{
    return nkw_degrees_from_radians(nkw_quat_angle(about_y(0.0f), blend(about_y(0.0f), about_y(turn), t)));
}

/* Speed over the mean speed, from differences. */
static void speed_graph(svg *s, const svg_plot *plot, blend_function *blend, float turn, svg_paint paint)
{
    float y[FIGURE_STEPS + 1];
    const float step = 1.0f / 512.0f;
    for (int i = 0; i <= FIGURE_STEPS; i++) {
        float t = (float)i / (float)FIGURE_STEPS, a = nkw_max(t - step, 0.0f), b = nkw_min(t + step, 1.0f);
        y[i] = (turned(blend, turn, b) - turned(blend, turn, a)) / ((b - a) * turn);
    }
    figure_graph(s, plot, y, &paint);
}

static void lag_graph(svg *s, const svg_plot *plot, float turn, svg_paint paint)
{
    float y[FIGURE_STEPS + 1];
    for (int i = 0; i <= FIGURE_STEPS; i++) {
        float t = (float)i / (float)FIGURE_STEPS;
        y[i] = turned(nkw_quat_nlerp, turn, t) - turned(nkw_quat_slerp, turn, t);
    }
    figure_graph(s, plot, y, &paint);
}

static void speed_legend(svg *s)
{
    svg_paint even = svg_stroke(FIGURE_SLERP, 3.0f, 1.0f);
    figure_legend(s, 64.0f, 452.0f, &even, "slerp");
    figure_text(s, 190.0f, 452.0f, 13.0f, 0x2b2b30, 's', "nlerp, by the turn from a to b:");
    for (int i = 0; i < TURNS; i++) {
        char text[SVG_DIGITS], digits[SVG_DIGITS];
        svg_paint paint = svg_stroke(turn_colours[i], 3.0f, 1.0f);
        sprintf(text, "%.8s\302\260", svg_number(digits, turns[i], 0));
        figure_legend(s, 420.0f + 100.0f * (float)i, 452.0f, &paint, text);
    }
}

int figure_orient_speed(const char *path)
{
    svg s;
    svg_plot speed = {{64.0f, 120.0f, 400.0f, 270.0f}, {0.0f, 1.0f, 0.25f, "t"},
                      {0.6f, 1.3f, 0.1f, "angular speed / mean speed"}};
    svg_plot lag = {{550.0f, 120.0f, 400.0f, 270.0f}, {0.0f, 1.0f, 0.25f, "t"},
                    {-9.0f, 9.0f, 3.0f, "nlerp is ahead of slerp by, degrees"}};
    if (!figure_open(&s, path, 980.0f, 476.0f, "Slerp has constant speed, nlerp is faster in the middle",
                     "Same arc, same ends, same middle. The difference grows with about the third power of the angle."))
        return 0;
    svg_plot_frame(&s, &speed);
    svg_plot_frame(&s, &lag);
    speed_graph(&s, &speed, nkw_quat_slerp, 90.0f, svg_stroke(FIGURE_SLERP, 3.0f, 1.0f));
    lag_graph(&s, &lag, 0.0f, svg_stroke(FIGURE_SLERP, 3.0f, 1.0f));
    for (int i = 0; i < TURNS; i++) {
        speed_graph(&s, &speed, nkw_quat_nlerp, turns[i], svg_stroke(turn_colours[i], 2.4f, 1.0f));
        lag_graph(&s, &lag, turns[i], svg_stroke(turn_colours[i], 2.4f, 1.0f));
    }
    speed_legend(&s);
    return svg_close(&s);
}

/* ---- the arcs on the sphere ---- */

/* Where the rotations take the x axis; the turn between them is about an axis at right angles to it. */
static nkw_vec3 tip(nkw_quat q)
{
    nkw_vec3 x = {1.0f, 0.0f, 0.0f};
    return nkw_quat_rotate(q, x);
}

/* Turned by `degrees` about an axis that leans towards the eye; at 0 the tip is nearest to the eye. */
static nkw_quat tilted(float degrees)
{
    nkw_vec3 axis = {0.0f, 0.93969262f, 0.34202014f}, near = {0.0f, -0.34202014f, 0.93969262f};
    nkw_vec3 x = {1.0f, 0.0f, 0.0f};
    return nkw_quat_mul(nkw_quat_from_axis_angle(axis, radians(degrees)), nkw_quat_from_vectors(x, near));
}

typedef nkw_quat arc_function(nkw_quat a, nkw_quat b, float t);

static nkw_quat long_way(nkw_quat a, nkw_quat b, float t)
{
    return nkw_quat_slerp_path(a, b, t, NKW_PATH_LONG, 0);
}

static void sphere_arc(svg *s, const svg_camera *camera, arc_function *arc, float turn, svg_colour colour)
{
    nkw_vec3 points[FIGURE_STEPS + 1];
    nkw_quat a = tilted(-0.5f * turn), b = tilted(0.5f * turn);
    for (int i = 0; i <= FIGURE_STEPS; i++)
        points[i] = tip(arc(a, b, (float)i / (float)FIGURE_STEPS));
    sphere_line(s, camera, points, FIGURE_STEPS + 1, svg_stroke(colour, 3.2f, 1.0f));
    for (int i = FIGURE_STEPS / 8; i < FIGURE_STEPS; i += FIGURE_STEPS / 8) {
        int back = svg_depth(camera, points[i]) > 0.0f;
        svg_paint dot = {back ? svg_mix(0xf4f5f9, colour, 0.45f) : colour, 0xffffff, 1.0f, 1.0f, NULL};
        svg_circle(s, svg_project(camera, points[i]), colour == FIGURE_NLERP ? 6.6f : 4.2f, &dot);
    }
}

static void sphere_ends(svg *s, const svg_camera *camera, float turn)
{
    svg_point a = svg_project(camera, tip(tilted(-0.5f * turn))), b = svg_project(camera, tip(tilted(0.5f * turn)));
    figure_key(s, a);
    figure_key(s, b);
    figure_name(s, a.x, a.y - 14.0f, FIGURE_INK, 'm', "a");
    figure_name(s, b.x, b.y - 14.0f, FIGURE_INK, 'm', "b");
}

static void sphere_panel(svg *s, svg_point centre, float turn, arc_function *first, arc_function *second,
                         svg_colour colour)
{
    nkw_mat4 view = figure_view(0.0f, 0.35f);
    svg_camera camera = svg_orthographic(&view, centre, 190.0f);
    sphere_ball(s, &camera);
    sphere_arc(s, &camera, second, turn, colour);
    sphere_arc(s, &camera, first, turn, FIGURE_SLERP);
    sphere_ends(s, &camera, turn);
}

int figure_orient_paths(const char *path)
{
    svg s;
    svg_paint slerp = svg_stroke(FIGURE_SLERP, 3.2f, 1.0f), nlerp = svg_stroke(FIGURE_NLERP, 3.2f, 1.0f);
    svg_paint other = svg_stroke(0x6a4a9c, 3.2f, 1.0f);
    if (!figure_open(&s, path, 980.0f, 560.0f, "One great circle: two speeds, two directions",
                     "Where the turned x axis points, a dot every 1/8 of t. A pale line runs behind the sphere."))
        return 0;
    figure_bold(&s, 40.0f, 98.0f, 15.0f, FIGURE_INK, 's', "150\302\260: the same arc, other speeds");
    figure_bold(&s, 530.0f, 98.0f, 15.0f, FIGURE_INK, 's', "110\302\260: the short and the long path");
    sphere_panel(&s, svg_at(250.0f, 310.0f), 150.0f, nkw_quat_slerp, nkw_quat_nlerp, FIGURE_NLERP);
    sphere_panel(&s, svg_at(740.0f, 310.0f), 110.0f, nkw_quat_slerp, long_way, 0x6a4a9c);
    figure_legend(&s, 110.0f, 538.0f, &slerp, "nkw_quat_slerp");
    figure_legend(&s, 280.0f, 538.0f, &nlerp, "nkw_quat_nlerp");
    figure_legend(&s, 510.0f, 538.0f, &slerp, "NKW_PATH_SHORT, 110\302\260");
    figure_legend(&s, 745.0f, 538.0f, &other, "NKW_PATH_LONG, 250\302\260");
    return svg_close(&s);
}

/* ---- the sign ---- */

/* Rotations about one axis are the points of a circle, at half the angle of the turn. */
static void circle_point(svg *s, svg_point c, float radius, float angle, svg_colour colour, const char *name)
{
    svg_paint spoke = svg_stroke(colour, 1.4f, 0.7f);
    svg_point p = svg_at(c.x + radius * nkw_cos(angle), c.y - radius * nkw_sin(angle));
    svg_line(s, c, p, &spoke);
    svg_paint disc = {colour, 0xffffff, 1.4f, 1.0f, NULL};
    svg_circle(s, p, 7.0f, &disc);
    figure_name(s, c.x + (radius + 28.0f) * nkw_cos(angle), c.y - (radius + 22.0f) * nkw_sin(angle) + 5.0f, colour,
                nkw_cos(angle) < -0.3f ? 'e' : nkw_cos(angle) > 0.3f ? 's' : 'm', name);
}

static void quaternion_circle(svg *s, svg_point c)
{
    const float r = 150.0f;
    svg_paint rim = svg_stroke(FIGURE_PALE, 1.4f, 1.0f), axis = svg_stroke(0xd5d5da, 1.0f, 1.0f);
    svg_paint shorter = svg_stroke(FIGURE_SLERP, 4.0f, 1.0f), longer = svg_stroke(FIGURE_EULER, 3.0f, 1.0f);
    longer.dash = "7 6";
    svg_line(s, svg_at(c.x - r - 16.0f, c.y), svg_at(c.x + r + 16.0f, c.y), &axis);
    svg_line(s, svg_at(c.x, c.y - r - 16.0f), svg_at(c.x, c.y + r + 16.0f), &axis);
    svg_circle(s, c, r, &rim);
    figure_arc_arrow(s, c, r - 18.0f, 0.0f, radians(50.0f), &shorter);
    figure_arc_arrow(s, c, r - 38.0f, 0.0f, radians(-130.0f), &longer);
    circle_point(s, c, r, 0.0f, FIGURE_INK, "a, no turn");
    circle_point(s, c, r, radians(230.0f), FIGURE_EULER, "b");
    circle_point(s, c, r, radians(50.0f), FIGURE_SLERP, "-b: the same rotation");
    circle_point(s, c, r, radians(130.0f), 0xe07b00, "conjugate(b)");
    figure_text(s, c.x + 66.0f, c.y - 50.0f, 12.0f, FIGURE_SLERP, 'm', "50\302\260");
    figure_text(s, c.x + 46.0f, c.y + 66.0f, 12.0f, FIGURE_EULER, 'm', "130\302\260");
}

static void object_hand(svg *s, svg_point c, float turn, float length, svg_colour colour, const char *name)
{
    svg_paint hand = svg_stroke(colour, 4.0f, 1.0f);
    float angle = radians(turn);
    svg_point p = svg_at(c.x + length * nkw_cos(angle), c.y - length * nkw_sin(angle));
    svg_arrow(s, c, p, &hand);
    figure_name(s, c.x + (length + 14.0f) * nkw_cos(angle), c.y - (length + 18.0f) * nkw_sin(angle) + 5.0f, colour,
                turn == 0.0f ? 's' : 'm', name);
}

static void object_dial(svg *s, svg_point c)
{
    const float r = 150.0f;
    svg_paint rim = svg_stroke(0xd5d5da, 1.4f, 1.0f);
    svg_paint shorter = svg_stroke(FIGURE_SLERP, 4.0f, 1.0f), longer = svg_stroke(FIGURE_EULER, 3.0f, 1.0f);
    longer.dash = "7 6";
    svg_circle(s, c, r, &rim);
    figure_arc_arrow(s, c, 66.0f, 0.0f, radians(100.0f), &shorter);
    figure_arc_arrow(s, c, 90.0f, 0.0f, radians(-260.0f), &longer);
    object_hand(s, c, 0.0f, r, FIGURE_INK, "a");
    object_hand(s, c, 100.0f, r, FIGURE_SLERP, "b and -b");
    object_hand(s, c, 260.0f, r, 0xe07b00, "conjugate(b): elsewhere");
    figure_name(s, c.x + 27.0f, c.y - 24.0f, FIGURE_SLERP, 'm', "100\302\260");
    figure_name(s, c.x - 92.0f, c.y + 48.0f, FIGURE_EULER, 'e', "260\302\260");
}

int figure_orient_shorter(const char *path)
{
    svg s;
    svg_paint shorter = svg_stroke(FIGURE_SLERP, 4.0f, 1.0f), longer = svg_stroke(FIGURE_EULER, 3.0f, 1.0f);
    longer.dash = "7 6";
    if (!figure_open(&s, path, 980.0f, 546.0f, "The shorter arc: negate b, do not conjugate it",
                     "Turns about one axis. On the left their quaternions, cos and sin of half the turn; on the right "
                     "the object itself."))
        return 0;
    figure_bold(&s, 40.0f, 100.0f, 15.0f, FIGURE_INK, 's', "Quaternions: a.b < 0, so -b is nearer");
    figure_bold(&s, 560.0f, 100.0f, 15.0f, FIGURE_INK, 's', "What the object does");
    quaternion_circle(&s, svg_at(250.0f, 300.0f));
    object_dial(&s, svg_at(730.0f, 300.0f));
    figure_legend(&s, 130.0f, 526.0f, &shorter, "a to -b: NKW_PATH_SHORT, and nkw_quat_slerp");
    figure_legend(&s, 540.0f, 526.0f, &longer, "a to b, signs as given: NKW_PATH_AS_GIVEN");
    return svg_close(&s);
}
