/* SPDX-License-Identifier: MIT */
/* Euler angles: the detour of their interpolation, and the pole. */
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

static nkw_vec3 angles(float pitch, float yaw, float roll)
{
    nkw_vec3 a = {radians(pitch), radians(yaw), radians(roll)};
    return a;
}

static nkw_vec3 nose(nkw_quat q)
{
    nkw_vec3 z = {0.0f, 0.0f, -1.0f};
    return nkw_quat_rotate(q, z);
}

/* ---- Euler lerp against slerp ---- */

/* Slerp leads the nose along a great circle; the second key gets its roll from that. */
static nkw_quat key(int last)
{
    nkw_quat a = nkw_quat_from_euler(angles(25.0f, -115.0f, 0.0f), NKW_EULER_YXZ);
    nkw_quat b = nkw_quat_from_euler(angles(50.0f, 105.0f, 0.0f), NKW_EULER_YXZ);
    return last ? nkw_quat_mul(nkw_quat_from_vectors(nose(a), nose(b)), a) : a;
}

static nkw_vec3 key_angles(int last)
{
    return nkw_euler_from_quat(key(last), NKW_EULER_YXZ);
}

static nkw_quat between(float t, int euler)
{
    if (euler)
        return nkw_quat_from_euler(nkw_euler_lerp(key_angles(0), key_angles(1), t, NKW_UNWRAP_ALL), NKW_EULER_YXZ);
    return nkw_quat_slerp(key(0), key(1), t);
}

static void nose_path(svg *s, const svg_camera *camera, int euler, svg_colour colour)
{
    nkw_vec3 points[FIGURE_STEPS + 1];
    for (int i = 0; i <= FIGURE_STEPS; i++)
        points[i] = nose(between((float)i / (float)FIGURE_STEPS, euler));
    sphere_line(s, camera, points, FIGURE_STEPS + 1, svg_stroke(colour, 3.2f, 1.0f));
    for (int i = FIGURE_STEPS / 12; i < FIGURE_STEPS; i += FIGURE_STEPS / 12)
        figure_dot(s, svg_project(camera, points[i]), colour);
}

static void nose_key(svg *s, const svg_camera *camera, float t, float dx, const char *name)
{
    svg_point p = svg_project(camera, nose(between(t, 0)));
    figure_key(s, p);
    figure_name(s, p.x + dx, p.y + 5.0f, FIGURE_INK, 'm', name);
}

/* "a: pitch 25, yaw 115, roll 0" in degrees. */
static void say_angles(svg *s, float y, int last)
{
    char text[4 * SVG_DIGITS], x_text[SVG_DIGITS], y_text[SVG_DIGITS], z_text[SVG_DIGITS];
    nkw_vec3 e = key_angles(last);
    sprintf(text, "%s: pitch %.8s\302\260, yaw %.8s\302\260, roll %.8s\302\260", last ? "b" : "a",
            svg_number(x_text, nkw_degrees_from_radians(e.x), 0), svg_number(y_text, nkw_degrees_from_radians(e.y), 0),
            svg_number(z_text, nkw_degrees_from_radians(e.z), 0));
    figure_text(s, 40.0f, y, 13.0f, 0x2b2b30, 's', text);
}

/* Degrees per unit of t, from differences. */
static void turning_speed(svg *s, const svg_plot *plot, int euler, svg_colour colour)
{
    float y[FIGURE_STEPS + 1];
    const float step = 1.0f / 512.0f;
    svg_paint paint = svg_stroke(colour, 2.6f, 1.0f);
    for (int i = 0; i <= FIGURE_STEPS; i++) {
        float t = (float)i / (float)FIGURE_STEPS, a = nkw_max(t - step, 0.0f), b = nkw_min(t + step, 1.0f);
        y[i] = nkw_degrees_from_radians(nkw_quat_angle(between(a, euler), between(b, euler))) / (b - a);
    }
    figure_graph(s, plot, y, &paint);
}

int figure_orient_euler(const char *path)
{
    svg s;
    nkw_mat4 view = figure_view(0.0f, 0.45f);
    svg_camera camera = svg_orthographic(&view, svg_at(250.0f, 292.0f), 190.0f);
    svg_plot plot = {{560.0f, 132.0f, 380.0f, 340.0f}, {0.0f, 1.0f, 0.25f, "t"},
                     {0.0f, 180.0f, 30.0f, "angular speed, degrees per unit of t"}};
    svg_paint euler = svg_stroke(FIGURE_EULER, 3.2f, 1.0f), slerp = svg_stroke(FIGURE_SLERP, 3.2f, 1.0f);
    if (!figure_open(&s, path, 980.0f, 560.0f, "Three angles at constant rates do not turn at constant speed",
                     "Left: where the nose (-z) points, a dot every 1/12 of t. Right: how fast the object turns, roll "
                     "included."))
        return 0;
    sphere_ball(&s, &camera);
    nose_path(&s, &camera, 1, FIGURE_EULER);
    nose_path(&s, &camera, 0, FIGURE_SLERP);
    nose_key(&s, &camera, 0.0f, 18.0f, "a");
    nose_key(&s, &camera, 1.0f, -18.0f, "b");
    say_angles(&s, 526.0f, 0);
    say_angles(&s, 546.0f, 1);
    svg_plot_frame(&s, &plot);
    turning_speed(&s, &plot, 1, FIGURE_EULER);
    turning_speed(&s, &plot, 0, FIGURE_SLERP);
    figure_legend(&s, 400.0f, 540.0f, &euler, "nkw_euler_lerp, NKW_EULER_YXZ");
    figure_legend(&s, 700.0f, 540.0f, &slerp, "nkw_quat_slerp");
    return svg_close(&s);
}

/* ---- the pole ---- */

static const svg_colour ring_colours[3] = {0x2ca02c, 0xd62728, 0x1f5fd0};

/* The ring that turns about `axis`, and its pin along the axis. */
static void ring(svg *s, const svg_camera *camera, nkw_vec3 axis, nkw_vec3 side, float radius, svg_colour colour)
{
    nkw_vec3 points[FIGURE_STEPS + 1], other = nkw_vec3_cross(axis, side);
    nkw_vec3 pin[2] = {nkw_vec3_scale(axis, -radius - 0.16f), nkw_vec3_scale(axis, radius + 0.16f)};
    for (int i = 0; i <= FIGURE_STEPS; i++) {
        float angle = 6.28318531f * (float)i / (float)FIGURE_STEPS;
        nkw_vec3 p = nkw_vec3_add_scaled(nkw_vec3_scale(side, nkw_cos(angle)), other, nkw_sin(angle));
        points[i] = nkw_vec3_scale(p, radius);
    }
    sphere_line(s, camera, points, FIGURE_STEPS + 1, svg_stroke(colour, 4.0f, 1.0f));
    svg_paint paint = svg_stroke(colour, 2.0f, 0.9f);
    paint.dash = "5 4";
    svg_arrow(s, svg_project(camera, pin[0]), svg_project(camera, pin[1]), &paint);
}

/* R = Ry Rx Rz: yaw turns about the world's y, pitch about the x that yaw has turned, roll about the object's z. */
static void gimbal(svg *s, svg_point centre, float pitch, const char *name, const char *said)
{
    const nkw_vec3 x = {1.0f, 0.0f, 0.0f}, y = {0.0f, 1.0f, 0.0f}, z = {0.0f, 0.0f, 1.0f};
    nkw_quat yaw = nkw_quat_from_euler(angles(0.0f, 20.0f, 0.0f), NKW_EULER_YXZ);
    nkw_quat all = nkw_quat_from_euler(angles(pitch, 20.0f, 0.0f), NKW_EULER_YXZ);
    nkw_mat4 view = figure_view(0.75f, 0.35f), m = nkw_mat4_from_quat(all);
    svg_camera camera = svg_orthographic(&view, centre, 112.0f);
    space_list list = {NULL, 0, 0, 0};
    ring(s, &camera, y, z, 1.0f, ring_colours[0]);
    ring(s, &camera, nkw_quat_rotate(yaw, x), y, 0.84f, ring_colours[1]);
    ring(s, &camera, nkw_quat_rotate(all, z), nkw_quat_rotate(all, x), 0.68f, ring_colours[2]);
    space_dart(&list, &camera, &m, 0.62f, &space_vivid);
    space_paint(&list, s);
    figure_bold(s, centre.x, 104.0f, 15.0f, FIGURE_INK, 'm', name);
    figure_text(s, centre.x, 422.0f, 13.0f, 0x2b2b30, 'm', said);
}

/* The YXZ angles of a slerp whose pitch comes near to 90 degrees on the way. */
static void over_the_top(svg *s, const svg_plot *plot)
{
    nkw_quat a = nkw_quat_from_euler(angles(50.0f, 0.0f, 0.0f), NKW_EULER_YXZ);
    nkw_quat b = nkw_quat_from_euler(angles(50.0f, 155.0f, 170.0f), NKW_EULER_YXZ);
    float y[3][FIGURE_STEPS + 1];
    nkw_vec3 last = {0.0f, 0.0f, 0.0f};
    for (int i = 0; i <= FIGURE_STEPS; i++) {
        nkw_vec3 e = nkw_euler_from_quat(nkw_quat_slerp(a, b, (float)i / (float)FIGURE_STEPS), NKW_EULER_YXZ);
        last = nkw_euler_unwrap(e, last);
        y[0][i] = nkw_degrees_from_radians(last.y);
        y[1][i] = nkw_degrees_from_radians(last.x);
        y[2][i] = nkw_degrees_from_radians(last.z);
    }
    for (int k = 0; k < 3; k++) {
        svg_paint paint = svg_stroke(ring_colours[k], 2.8f, 1.0f);
        figure_graph(s, plot, y[k], &paint);
    }
}

int figure_euler_pole(const char *path)
{
    static const char *const names[3] = {"yaw (y)", "pitch (x)", "roll (z)"};
    svg s;
    svg_plot plot = {{700.0f, 138.0f, 330.0f, 240.0f}, {0.0f, 1.0f, 0.25f, "t of the slerp"},
                     {0.0f, 180.0f, 30.0f, "degrees"}};
    if (!figure_open(&s, path, 1060.0f, 480.0f, "At pitch 90\302\260 yaw and roll turn about one axis",
                     "The pole of NKW_EULER_YXZ: one degree of freedom is lost. Near it, a small turn of the "
                     "object is a large change of two angles."))
        return 0;
    gimbal(&s, svg_at(170.0f, 258.0f), 20.0f, "pitch 20\302\260", "three axes: every small turn is possible");
    gimbal(&s, svg_at(500.0f, 258.0f), 90.0f, "pitch 90\302\260", "the axes of yaw and roll coincide");
    figure_bold(&s, 700.0f, 104.0f, 15.0f, FIGURE_INK, 's', "A turn at constant speed near the pole");
    svg_plot_frame(&s, &plot);
    over_the_top(&s, &plot);
    for (int k = 0; k < 3; k++) {
        svg_paint paint = svg_stroke(ring_colours[k], 4.0f, 1.0f);
        figure_legend(&s, 200.0f + 150.0f * (float)k, 460.0f, &paint, names[k]);
    }
    return svg_close(&s);
}
