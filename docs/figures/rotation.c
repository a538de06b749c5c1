/* SPDX-License-Identifier: MIT */
/* Smooth curves through the same rotations: their speed, and their path. */
#include "figure.h"
#include "draw/sphere.h"

#include <nakawari/rotation.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

enum { KEYS = 6, METHODS = 4 };

static const svg_colour colours[METHODS] = {FIGURE_PALE, FIGURE_HERMITE, FIGURE_CATMULL_ROM, FIGURE_BSPLINE};
static const char *const names[METHODS] = {"slerp", "squad", "Catmull-Rom", "B-spline"};

/* The key's yaw and pitch in degrees; every second is a key. */
static nkw_quat key(size_t k)
{
    static const float yaw[KEYS] = {-62.0f, -20.0f, -4.0f, 18.0f, 24.0f, 66.0f};
    static const float pitch[KEYS] = {14.0f, -30.0f, 26.0f, 34.0f, -22.0f, 8.0f};
    nkw_vec3 angles = {nkw_radians_from_degrees(pitch[k]), nkw_radians_from_degrees(yaw[k]), 0.0f};
    return nkw_quat_from_euler(angles, NKW_EULER_YXZ);
}

/* Segment k between keys k and k + 1, the end keys repeated. */
static nkw_rotation_segment segment(int method, size_t k)
{
    size_t first = k > 0 ? k - 1 : 0, last = k + 2 < KEYS ? k + 2 : KEYS - 1;
    nkw_quat keys[4] = {key(first), key(k), key(k + 1), key(last)};
    float times[4] = {(float)first, (float)k, (float)(k + 1), (float)last};
    switch (method) {
    case 0:
        return nkw_rotation_from_slerp(keys[1], keys[2], 1.0f, NKW_PATH_SHORT, 0);
    case 1:
        return nkw_rotation_from_squad(keys, 1.0f);
    case 2:
        return nkw_rotation_from_catmull_rom(keys, times);
    }
    return nkw_rotation_from_bspline(keys, 1.0f);
}

enum { PER_SEGMENT = 32, SAMPLES = (KEYS - 1) * (PER_SEGMENT + 1) };

static nkw_quat_motion state_at(int method, size_t sample)
{
    nkw_rotation_segment s = segment(method, sample / (PER_SEGMENT + 1));
    return nkw_rotation_evaluate(&s, (float)(sample % (PER_SEGMENT + 1)) / (float)PER_SEGMENT);
}

static float time_at(size_t sample)
{
    size_t k = sample / (PER_SEGMENT + 1);
    return (float)k + (float)(sample % (PER_SEGMENT + 1)) / (float)PER_SEGMENT;
}

/* The magnitude of the velocity or the acceleration, in degrees; both ends of each segment are drawn. */
static void magnitude_line(svg *s, const svg_plot *plot, int method, int is_acceleration)
{
    svg_point line[SAMPLES];
    svg_paint paint = svg_stroke(colours[method], method ? 2.4f : 3.4f, 1.0f);
    for (size_t i = 0; i < SAMPLES; i++) {
        nkw_quat_motion at = state_at(method, i);
        nkw_vec3 v = is_acceleration ? at.acceleration : at.velocity;
        float y = nkw_degrees_from_radians(nkw_vec3_length(v));
        line[i] = svg_plot_at(plot, time_at(i), nkw_min(y, plot->y.to));
    }
    svg_polyline(s, line, SAMPLES, &paint);
}

static void key_rules(svg *s, const svg_plot *plot)
{
    svg_paint paint = svg_stroke(0xb5b5bc, 1.0f, 1.0f);
    paint.dash = "2 4";
    for (int k = 1; k + 1 < KEYS; k++)
        svg_line(s, svg_plot_at(plot, (float)k, plot->y.from), svg_plot_at(plot, (float)k, plot->y.to), &paint);
}

static void legend(svg *s, float x, float y)
{
    for (int method = 0; method < METHODS; method++) {
        svg_paint paint = svg_stroke(colours[method], 3.0f, 1.0f);
        figure_legend(s, x + 150.0f * (float)method, y, &paint, names[method]);
    }
}

int figure_rotation_speed(const char *path)
{
    svg s;
    svg_plot speed = {{64.0f, 120.0f, 400.0f, 270.0f},
                      {0.0f, 5.0f, 1.0f, "seconds; a key every second"},
                      {0.0f, 90.0f, 15.0f, "angular speed, degrees per second"}};
    svg_plot change = {{550.0f, 120.0f, 400.0f, 270.0f},
                       {0.0f, 5.0f, 1.0f, "seconds; a key every second"},
                       {0.0f, 300.0f, 50.0f, "angular acceleration, degrees per second\302\262"}};
    if (!figure_open(&s, path, 980.0f, 476.0f, "The velocity of slerp jumps at the keys",
                     "The same six keys. Only the B-spline's acceleration has no jumps; it passes near the keys."))
        return 0;
    svg_plot_frame(&s, &speed);
    svg_plot_frame(&s, &change);
    key_rules(&s, &speed);
    key_rules(&s, &change);
    for (int method = 0; method < METHODS; method++) {
        magnitude_line(&s, &speed, method, 0);
        if (method)
            magnitude_line(&s, &change, method, 1);
    }
    legend(&s, 200.0f, 452.0f);
    return svg_close(&s);
}

/* Where the rotation takes the axis towards the eye. */
static nkw_vec3 tip(nkw_quat q)
{
    nkw_vec3 z = {0.0f, 0.0f, 1.0f};
    return nkw_quat_rotate(q, z);
}

static void sphere_path(svg *s, const svg_camera *camera, int method)
{
    nkw_vec3 points[SAMPLES];
    for (size_t i = 0; i < SAMPLES; i++)
        points[i] = tip(state_at(method, i).value);
    sphere_line(s, camera, points, SAMPLES, svg_stroke(colours[method], method ? 2.6f : 3.6f, 1.0f));
}

int figure_rotation_paths(const char *path)
{
    svg s;
    nkw_mat4 view = figure_view(0.0f, 0.1f);
    svg_camera camera = svg_orthographic(&view, svg_at(490.0f, 320.0f), 210.0f);
    if (!figure_open(&s, path, 980.0f, 590.0f, "The path of one axis through six orientations",
                     "Slerp has a corner at each key. Squad and Catmull-Rom pass through the keys without one."))
        return 0;
    sphere_ball(&s, &camera);
    for (int method = 0; method < METHODS; method++)
        sphere_path(&s, &camera, method);
    for (size_t k = 0; k < KEYS; k++)
        figure_key(&s, svg_project(&camera, tip(key(k))));
    legend(&s, 200.0f, 566.0f);
    return svg_close(&s);
}

/* ---- whole turns: the angle over t ---- */

static const nkw_vec3 y_axis = {0.0f, 1.0f, 0.0f};

static nkw_quat about_y(float degrees)
{
    return nkw_quat_from_axis_angle(y_axis, nkw_radians_from_degrees(degrees));
}

/* The angle about y in degrees, continued from the one before without jumps of more than half a turn. */
static float angle_after(float before, nkw_quat q)
{
    float angle = nkw_quat_twist_angle(q, y_axis);
    return before + nkw_degrees_from_radians(nkw_angle_difference(nkw_radians_from_degrees(before), angle));
}

static void path_line(svg *s, const svg_plot *plot, nkw_path path, int turns, svg_colour colour, const char *name)
{
    svg_paint paint = svg_stroke(colour, 2.6f, 1.0f);
    float y[FIGURE_STEPS + 1], angle = 0.0f;
    for (int i = 0; i <= FIGURE_STEPS; i++) {
        float t = (float)i / (float)FIGURE_STEPS;
        angle = angle_after(angle, nkw_quat_slerp_path(about_y(0.0f), about_y(60.0f), t, path, turns));
        y[i] = angle;
    }
    figure_graph(s, plot, y, &paint);
    svg_point end = svg_plot_at(plot, 1.0f, angle);
    figure_text(s, end.x + 6.0f, end.y + 4.0f, 12.0f, colour, 's', name);
}

/* A wheel that turns 1.3 times between two steps of the physics, ever faster. */
enum { STEPS = 3 };

static float wheel_rate(int step)
{
    return 7.0f + 0.8f * (float)step;
}

static float wheel_angle(int step)
{
    return nkw_degrees_from_radians(7.0f * (float)step + 0.4f * (float)(step * step));
}

static nkw_quat wheel_at(int step, float t, int with_velocity)
{
    nkw_quat a = about_y(wheel_angle(step)), b = about_y(wheel_angle(step + 1));
    nkw_vec3 va = nkw_vec3_scale(y_axis, wheel_rate(step)), vb = nkw_vec3_scale(y_axis, wheel_rate(step + 1));
    if (!with_velocity)
        return nkw_quat_slerp(a, b, t);
    nkw_rotation_segment s = nkw_rotation_from_hermite(a, va, b, vb, 1.0f);
    return nkw_rotation_evaluate(&s, t).value;
}

static void wheel_line(svg *s, const svg_plot *plot, int with_velocity, svg_colour colour)
{
    svg_point line[FIGURE_STEPS + 1];
    svg_paint paint = svg_stroke(colour, 2.6f, 1.0f);
    float angle = 0.0f;
    for (int i = 0; i <= FIGURE_STEPS; i++) {
        int step = i * STEPS / FIGURE_STEPS < STEPS ? i * STEPS / FIGURE_STEPS : STEPS - 1;
        float time = (float)(i * STEPS) / (float)FIGURE_STEPS;
        angle = angle_after(angle, wheel_at(step, time - (float)step, with_velocity));
        line[i] = svg_plot_at(plot, time, angle / 360.0f);
    }
    svg_polyline(s, line, FIGURE_STEPS + 1, &paint);
}

int figure_rotation_turns(const char *path)
{
    svg s;
    svg_paint slerp = svg_stroke(FIGURE_PALE, 2.6f, 1.0f), hermite = svg_stroke(FIGURE_HERMITE, 2.6f, 1.0f);
    svg_plot arcs = {{64.0f, 120.0f, 330.0f, 270.0f},
                     {0.0f, 1.0f, 0.25f, "t"},
                     {-720.0f, 900.0f, 180.0f, "angle in degrees, from 0 to 60"}};
    svg_plot wheel = {{580.0f, 120.0f, 370.0f, 270.0f},
                      {0.0f, 3.0f, 1.0f, "steps of the physics"},
                      {-1.0f, 4.0f, 1.0f, "turns of the wheel, as shown"}};
    if (!figure_open(&s, path, 980.0f, 476.0f, "Paths and whole turns",
                     "Left: the path and the whole turns are arguments. Right: the angular velocities determine them."))
        return 0;
    svg_plot_frame(&s, &arcs);
    svg_plot_frame(&s, &wheel);
    path_line(&s, &arcs, NKW_PATH_SHORT, 2, FIGURE_BEZIER, "short, 2 turns");
    path_line(&s, &arcs, NKW_PATH_SHORT, 1, FIGURE_CATMULL_ROM, "short, 1 turn");
    path_line(&s, &arcs, NKW_PATH_SHORT, 0, FIGURE_SLERP, "short: 60\302\260");
    path_line(&s, &arcs, NKW_PATH_LONG, 0, FIGURE_NLERP, "long: -300\302\260");
    path_line(&s, &arcs, NKW_PATH_LONG, 1, FIGURE_EULER, "long, 1 turn");
    wheel_line(&s, &wheel, 0, FIGURE_PALE);
    wheel_line(&s, &wheel, 1, FIGURE_HERMITE);
    figure_legend(&s, 550.0f, 452.0f, &slerp, "nkw_quat_slerp");
    figure_legend(&s, 720.0f, 452.0f, &hermite, "nkw_rotation_from_hermite");
    return svg_close(&s);
}
