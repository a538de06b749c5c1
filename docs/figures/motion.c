/* SPDX-License-Identifier: MIT */
/* Springs, transitions and root motion. */
#include "figure.h"

#include <nakawari/inertia.h>
#include <nakawari/quat.h>
#include <nakawari/root.h>
#include <nakawari/scalar.h>
#include <nakawari/spring.h>
#include <nakawari/transform.h>
#include <nakawari/vec.h>

static nkw_state motion(float value, float velocity)
{
    nkw_state m = {value, velocity};
    return m;
}

/* ---- springs ---- */

static const float half_life = 0.15f;

static void response(svg *s, const svg_plot *plot, float ratio, const svg_paint *paint)
{
    const nkw_spring spring = nkw_spring_from_half_life(half_life, ratio);
    float y[FIGURE_STEPS + 1];
    for (int i = 0; i <= FIGURE_STEPS; i++) {
        float time = (float)i / (float)FIGURE_STEPS;
        y[i] = nkw_spring_step(spring, motion(0.0f, 0.0f), motion(1.0f, 0.0f), time).value;
    }
    figure_graph(s, plot, y, paint);
}

static void damper(svg *s, const svg_plot *plot, const svg_paint *paint)
{
    float y[FIGURE_STEPS + 1];
    for (int i = 0; i <= FIGURE_STEPS; i++)
        y[i] = nkw_damper_step(0.0f, 1.0f, half_life, (float)i / (float)FIGURE_STEPS);
    figure_graph(s, plot, y, paint);
}

static void families(svg *s, const svg_plot *plot)
{
    static const float ratios[4] = {0.2f, 0.5f, 1.0f, 2.0f};
    static const svg_colour colours[4] = {FIGURE_HERMITE, FIGURE_EULER, FIGURE_CATMULL_ROM, FIGURE_BSPLINE};
    static const char *const names[4] = {"damping ratio 0.2", "0.5", "1: critical", "2"};
    svg_paint dashed = svg_stroke(FIGURE_GREY, 2.0f, 1.0f);
    dashed.dash = "6 4";
    svg_plot_frame(s, plot);
    damper(s, plot, &dashed);
    for (int i = 0; i < 4; i++) {
        svg_paint paint = svg_stroke(colours[i], 2.6f, 1.0f);
        response(s, plot, ratios[i], &paint);
        figure_legend(s, plot->box.x + 190.0f * (float)i, 396.0f, &paint, names[i]);
    }
    figure_legend(s, plot->box.x + 190.0f * 4.0f - 70.0f, 396.0f, &dashed, "damper");
    figure_key(s, svg_plot_at(plot, half_life, 0.5f));
}

/* Ten steps a second, by the closed form and by the method of many programs: v += h a, x += h v. */
static void steps(svg *s, const svg_plot *plot)
{
    const nkw_spring spring = nkw_spring_from_half_life(half_life, 1.0f);
    svg_paint curve = svg_stroke(FIGURE_CATMULL_ROM, 2.6f, 1.0f), line = svg_stroke(FIGURE_NLERP, 1.6f, 1.0f);
    svg_point points[11];
    nkw_state exact = {0.0f, 0.0f}, euler = exact;
    const float h = 0.1f;
    svg_plot_frame(s, plot);
    response(s, plot, 1.0f, &curve);
    for (int i = 0; i <= 10; i++) {
        points[i] = svg_plot_at(plot, h * (float)i, euler.value);
        figure_dot(s, svg_plot_at(plot, h * (float)i, exact.value), FIGURE_CATMULL_ROM);
        exact = nkw_spring_step(spring, exact, motion(1.0f, 0.0f), h);
        euler.velocity += h * (spring.stiffness * (1.0f - euler.value) - spring.damping * euler.velocity);
        euler.value += h * euler.velocity;
    }
    svg_begin_clip(s, plot->box);
    svg_polyline(s, points, 11, &line);
    for (int i = 0; i <= 10; i++)
        figure_dot(s, points[i], FIGURE_NLERP);
    svg_end(s);
    figure_legend(s, plot->box.x, 690.0f, &curve, "nkw_spring_step: dots at ten steps per second, line at any step");
    figure_legend(s, plot->box.x + 500.0f, 690.0f, &line, "v += h a, x += h v at ten steps per second");
}

int figure_spring_families(const char *path)
{
    svg s;
    svg_plot top = {{70.0f, 100.0f, 890.0f, 240.0f}, {0.0f, 1.0f, 0.1f, ""}, {0.0f, 1.6f, 0.5f, "value"}};
    svg_plot low = {{70.0f, 430.0f, 890.0f, 200.0f}, {0.0f, 1.0f, 0.1f, "time, s"}, {-1.0f, 3.0f, 1.0f, "value"}};
    if (!figure_open(&s, path, 1000.0f, 710.0f, "Springs of one half-life, and their steps",
                     "A goal at 1, from rest at 0. All springs are half-way after the half-life, 0.15 s (circle). A "
                     "step of the closed form is exact at any length."))
        return 0;
    families(&s, &top);
    steps(&s, &low);
    return svg_close(&s);
}

/* A spring on its way to 1 at 1 s: its values and velocities, the dots by ten steps. */
static void timed(svg *s, const svg_plot *value, const svg_plot *velocity, nkw_spring spring, svg_colour colour)
{
    const nkw_spring_timed start = {spring, 1.0f, {0.0f, 0.0f}, {0.0f, 0.0f}};
    svg_paint paint = svg_stroke(colour, 2.6f, 1.0f);
    float x[FIGURE_STEPS + 1], v[FIGURE_STEPS + 1];
    for (int i = 0; i <= FIGURE_STEPS; i++) {
        nkw_spring_timed now = start;
        nkw_spring_timed_step(&now, 1.0f, (float)i / (float)FIGURE_STEPS);
        x[i] = now.state.value;
        v[i] = now.state.velocity;
    }
    figure_graph(s, value, x, &paint);
    figure_graph(s, velocity, v, &paint);
    nkw_spring_timed now = start;
    for (int i = 1; i <= 10; i++) {
        nkw_spring_timed_step(&now, 1.0f, 0.1f);
        figure_dot(s, svg_plot_at(value, 0.1f * (float)i, now.state.value), colour);
    }
}

int figure_spring_timed(const char *path)
{
    static const float half_lives[4] = {0.05f, 0.2f, 0.4f, INFINITY};
    static const svg_colour colours[4] = {FIGURE_HERMITE, FIGURE_EULER, FIGURE_CATMULL_ROM, FIGURE_BSPLINE};
    static const char *const names[4] = {"half-life 0.05 s", "0.2 s", "0.4 s", "no spring: a cubic"};
    svg s;
    svg_plot top = {{70.0f, 100.0f, 890.0f, 260.0f}, {0.0f, 1.0f, 0.1f, ""}, {0.0f, 1.2f, 0.2f, "value"}};
    svg_plot low = {{70.0f, 450.0f, 890.0f, 180.0f}, {0.0f, 1.0f, 0.1f, "time, s"}, {0.0f, 2.0f, 0.5f, "velocity"}};
    if (!figure_open(&s, path, 1000.0f, 710.0f, "Springs that arrive after one second",
                     "From rest at 0 to rest at 1. Dots: ten steps. Lines: one step to each time. An acceleration of "
                     "the least effort is added."))
        return 0;
    svg_plot_frame(&s, &top);
    svg_plot_frame(&s, &low);
    for (int i = 0; i < 4; i++) {
        svg_paint paint = svg_stroke(colours[i], 2.6f, 1.0f);
        timed(&s, &top, &low, nkw_spring_from_half_life(half_lives[i], 1.0f), colours[i]);
        figure_legend(&s, top.box.x + 190.0f * (float)i, 410.0f, &paint, names[i]);
    }
    return svg_close(&s);
}

/* ---- transitions ---- */

/* The old motion and the new one. */
static nkw_state old_motion(float time)
{
    return motion(0.7f * nkw_sin(7.0f * time), 4.9f * nkw_cos(7.0f * time));
}

static nkw_state new_motion(float time)
{
    return motion(1.6f + 0.25f * nkw_sin(5.0f * time), 1.25f * nkw_cos(5.0f * time));
}

enum { CROSS_FADE, INERTIA, DEAD };

static const float begin = 0.72f, duration = 0.45f;

/* A cross-fade by a straight weight, as `animation time / duration` is; its velocity is that of the sum. */
static nkw_state cross_fade(float time)
{
    float w = nkw_clamp((time - begin) / duration, 0.0f, 1.0f);
    nkw_state a = old_motion(time), b = new_motion(time);
    float rate = w > 0.0f && w < 1.0f ? (b.value - a.value) / duration : 0.0f;
    return motion(nkw_lerp(a.value, b.value, w), nkw_lerp(a.velocity, b.velocity, w) + rate);
}

static nkw_state shown(int kind, float time)
{
    const nkw_offset_kind way = kind == DEAD ? NKW_OFFSET_DEAD_BLEND : NKW_OFFSET_INERTIA;
    nkw_offset offset = {.kind = way, .duration = duration, .half_life = 0.08f};
    nkw_offset_begin(&offset, old_motion(begin), new_motion(begin));
    if (time < begin)
        return old_motion(time);
    return kind == CROSS_FADE ? cross_fade(time) : nkw_offset_evaluate(&offset, new_motion(time), time - begin);
}

enum { FINE = 480 };

static void transition_line(svg *s, const svg_plot *plot, int kind, int velocity, const svg_paint *paint)
{
    svg_point line[FINE + 1];
    for (int i = 0; i <= FINE; i++) {
        float time = plot->x.to * (float)i / (float)FINE;
        nkw_state m = kind < 0 ? new_motion(time) : shown(kind, time);
        line[i] = svg_plot_at(plot, time, velocity ? m.velocity : m.value);
    }
    svg_begin_clip(s, plot->box);
    svg_polyline(s, line, FINE + 1, paint);
    svg_end(s);
}

static void transitions(svg *s, const svg_plot *plot, int velocity)
{
    static const svg_colour colours[3] = {FIGURE_NLERP, FIGURE_CATMULL_ROM, FIGURE_BSPLINE};
    svg_paint rule = svg_stroke(0xb5b5bc, 1.2f, 1.0f), pale = svg_stroke(0xa9adba, 4.0f, 0.5f);
    rule.dash = "3 4";
    svg_plot_frame(s, plot);
    for (int i = 0; i < 2; i++) {
        float time = begin + duration * (float)i;
        svg_line(s, svg_plot_at(plot, time, plot->y.from), svg_plot_at(plot, time, plot->y.to), &rule);
    }
    transition_line(s, plot, -1, velocity, &pale);
    for (int kind = CROSS_FADE; kind <= DEAD; kind++) {
        svg_paint paint = svg_stroke(colours[kind], 2.4f, 1.0f);
        transition_line(s, plot, kind, velocity, &paint);
    }
}

int figure_inertia_transition(const char *path)
{
    svg s;
    svg_plot value = {{70.0f, 100.0f, 890.0f, 240.0f}, {0.0f, 1.6f, 0.2f, ""}, {-1.0f, 2.2f, 1.0f, "value"}};
    svg_plot speed = {
        {70.0f, 390.0f, 890.0f, 240.0f}, {0.0f, 1.6f, 0.2f, "time, s"}, {-6.0f, 14.0f, 5.0f, "velocity, per second"}};
    svg_paint fade = svg_stroke(FIGURE_NLERP, 2.4f, 1.0f), inertia = svg_stroke(FIGURE_CATMULL_ROM, 2.4f, 1.0f),
              dead = svg_stroke(FIGURE_BSPLINE, 2.4f, 1.0f), pale = svg_stroke(0xa9adba, 4.0f, 0.5f);
    if (!figure_open(
            &s, path, 1000.0f, 710.0f, "Three transitions from one motion to another",
            "Between the dashed lines. The velocity of the cross-fade jumps where it begins and where it ends."))
        return 0;
    transitions(&s, &value, 0);
    transitions(&s, &speed, 1);
    figure_legend(&s, 70.0f, 690.0f, &fade, "cross-fade of both motions");
    figure_legend(&s, 310.0f, 690.0f, &inertia, "inertialisation");
    figure_legend(&s, 500.0f, 690.0f, &dead, "dead blending");
    figure_legend(&s, 680.0f, 690.0f, &pale, "the new motion");
    return svg_close(&s);
}

/* ---- root motion ---- */

/* The root of a clip of one second: a step to the left and to the right, and a turn by 50 degrees. */
static nkw_trs root_at(float t)
{
    const nkw_vec3 y = {0.0f, 1.0f, 0.0f};
    nkw_trs root = nkw_trs_identity();
    float angle = 0.87f * t;
    root.translation.x = 2.2f * nkw_sin(angle) + 0.10f * nkw_sin(12.566371f * t);
    root.translation.z = 2.2f * (1.0f - nkw_cos(angle));
    root.translation.y = 0.95f;
    root.rotation = nkw_quat_from_axis_angle(y, -angle);
    return root;
}

static svg_point on_floor(nkw_vec3 p)
{
    return svg_at(240.0f + 120.0f * p.x, 630.0f - 120.0f * p.z);
}

static void character(svg *s, const nkw_trs *place, svg_colour colour, float width)
{
    const nkw_vec3 ahead = {0.28f, 0.0f, 0.0f};
    svg_paint paint = svg_stroke(colour, width, 1.0f);
    svg_arrow(s, on_floor(place->translation), on_floor(nkw_trs_transform_point(place, ahead)), &paint);
}

static void loops(svg *s, const nkw_root_cycle *cycle, const nkw_root_rule *rule)
{
    static const svg_colour colours[3] = {FIGURE_HERMITE, FIGURE_CATMULL_ROM, FIGURE_BSPLINE};
    const nkw_trs origin = nkw_trs_identity();
    for (int n = 0; n < 3; n++) {
        svg_point line[FIGURE_STEPS + 1];
        svg_paint paint = svg_stroke(colours[n], 3.0f, 1.0f);
        for (int i = 0; i <= FIGURE_STEPS; i++) {
            nkw_trs root = root_at((float)i / (float)FIGURE_STEPS), now = nkw_root_split(rule, &root).motion;
            nkw_trs place = nkw_root_place(cycle, &origin, &now, n);
            line[i] = on_floor(place.translation);
            if (i % 24 == 12)
                character(s, &place, colours[n], 1.8f);
        }
        svg_polyline(s, line, FIGURE_STEPS + 1, &paint);
    }
    for (int n = 0; n <= 3; n++) {
        nkw_trs place = nkw_root_place(cycle, &origin, &cycle->first, n);
        character(s, &place, FIGURE_INK, 2.4f);
        figure_key(s, on_floor(place.translation));
    }
}

int figure_root_loops(const char *path)
{
    static const char *const names[4] = {"origin", "C", "C\xc2\xb2", "C\xc2\xb3"};
    const nkw_root_rule rule = {{0.0f, 1.0f, 0.0f}, NKW_ROOT_PLANE | NKW_ROOT_YAW};
    const nkw_trs first = root_at(0.0f), last = root_at(1.0f), origin = nkw_trs_identity();
    const nkw_root_cycle cycle = {nkw_root_split(&rule, &first).motion, nkw_root_split(&rule, &last).motion};
    svg s;
    if (!figure_open(&s, path, 760.0f, 690.0f, "Three loops of a clip that walks and turns, from above",
                     "Each loop begins at the end of the last: nkw_root_place with cycle 0, 1 and 2. Arrows look "
                     "ahead."))
        return 0;
    loops(&s, &cycle, &rule);
    for (int n = 0; n <= 3; n++) {
        nkw_trs place = nkw_root_place(&cycle, &origin, &cycle.first, n);
        svg_point p = on_floor(place.translation);
        figure_name(&s, p.x - 14.0f, p.y + 26.0f, FIGURE_INK, 'm', names[n]);
    }
    return svg_close(&s);
}
