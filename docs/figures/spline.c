/* SPDX-License-Identifier: MIT */
/* Curves through many keys: overshoot, knots; and paths: frames, constant speed. */
#include "figure.h"

#include <string.h>

#include <nakawari/nakawari.h>

/* ---- One series of keys under four methods ---- */

enum { KEYS = 9 };
static const float times[KEYS] = {0.0f, 1.0f, 2.0f, 2.5f, 3.0f, 4.0f, 5.0f, 5.5f, 7.0f};
static const float values[KEYS] = {0.0f, 0.0f, 0.1f, 1.0f, 1.0f, 1.0f, 0.25f, 0.2f, 0.2f};

typedef struct shown_method {
    const char *name, *rule;
    nkw_spline_method method;
    svg_colour colour;
} shown_method;

static const shown_method methods[4] = {
    {"Catmull-Rom", "the slope of the parabola: leaves the plateaus", NKW_SPLINE_CATMULL_ROM, FIGURE_CATMULL_ROM},
    {"C2", "continuous acceleration: waves before and after a step", NKW_SPLINE_C2, FIGURE_BEZIER},
    {"Akima", "plateaus stay flat; a little overshoot where they end", NKW_SPLINE_AKIMA, FIGURE_HERMITE},
    {"PCHIP", "never leaves the range of two neighbouring keys", NKW_SPLINE_PCHIP, FIGURE_BSPLINE},
};

/* The CUBICSPLINE track of the keys. */
static nkw_track track_of(nkw_spline_method method, float triples[3 * KEYS])
{
    NKW_STACK_WORK(work, NKW_SPLINE_WORK(KEYS));
    nkw_spline spline = {times, values, KEYS, 1, 1, method, NKW_SPLINE_ENDS_FREE, 0.0f, NULL, NULL};
    nkw_tangent_span tangents = {triples, triples + 2, 3};
    nkw_track track = {times, triples, KEYS, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE, NULL};
    nkw_spline_tangents(&spline, tangents, NULL, work);
    for (int k = 0; k < KEYS; k++)
        triples[3 * k + 1] = values[k];
    return track;
}

static void method_panel(svg *s, svg_box box, const shown_method *m)
{
    float triples[3 * KEYS], value;
    nkw_track track = track_of(m->method, triples);
    svg_plot plot = {box, {0.0f, 7.0f, 1.0f, ""}, {-0.3f, 1.3f, 0.5f, ""}};
    svg_point line[4 * FIGURE_STEPS + 1];
    svg_paint paint = svg_stroke(m->colour, 2.8f, 1.0f), level = svg_stroke(FIGURE_PALE, 1.0f, 1.0f);
    svg_plot_frame(s, &plot);
    svg_line(s, svg_plot_at(&plot, 0.0f, 1.0f), svg_plot_at(&plot, 7.0f, 1.0f), &level);
    svg_line(s, svg_plot_at(&plot, 0.0f, 0.0f), svg_plot_at(&plot, 7.0f, 0.0f), &level);
    for (int i = 0; i <= 4 * FIGURE_STEPS; i++) {
        float time = 7.0f * (float)i / (float)(4 * FIGURE_STEPS);
        nkw_track_sample(&track, time, NULL, &value);
        line[i] = svg_plot_at(&plot, time, value);
    }
    svg_polyline(s, line, 4 * FIGURE_STEPS + 1, &paint);
    for (int k = 0; k < KEYS; k++)
        figure_key(s, svg_plot_at(&plot, times[k], values[k]));
    figure_bold(s, box.x, box.y - 28.0f, 15.0f, m->colour, 's', m->name);
    figure_text(s, box.x, box.y - 11.0f, 12.0f, FIGURE_GREY, 's', m->rule);
}

int figure_spline_methods(const char *path)
{
    svg s;
    if (!figure_open(&s, path, 1064.0f, 640.0f, "The same keys, four methods for the tangents",
                     "Grey lines: the levels of the plateaus. What is above or below them is overshoot."))
        return 0;
    for (int i = 0; i < 4; i++) {
        svg_box box = {60.0f + 516.0f * (float)(i % 2), 130.0f + 266.0f * (float)(i / 2), 460.0f, 190.0f};
        method_panel(&s, box, &methods[i]);
    }
    return svg_close(&s);
}

/* ---- Catmull-Rom through points of the plane, by the powers of their distances ---- */

enum { POINTS = 6 };
static const float places[2 * POINTS] = {0.0f, 0.1f, 1.75f, 1.4f, 2.2f, 1.4f, 3.4f, 0.3f, 3.75f, 0.3f, 4.6f, 1.6f};

static svg_point on_plane(svg_box box, float x, float y)
{
    return svg_at(box.x + 26.0f + 60.0f * x, box.y + box.height - 60.0f - 84.0f * y);
}

static void knots_panel(svg *s, svg_box box, float alpha, svg_colour colour, const char *name, const char *rule)
{
    float knots[POINTS], triples[6 * POINTS], p[2];
    svg_point line[5 * FIGURE_STEPS + 1];
    svg_paint paint = svg_stroke(colour, 2.8f, 1.0f), border = svg_stroke(0xd5d5da, 1.0f, 1.0f);
    nkw_spline spline = {knots, places, POINTS, 2, 2, NKW_SPLINE_CATMULL_ROM, NKW_SPLINE_ENDS_FREE, 0.0f, NULL, NULL};
    nkw_tangent_span tangents = {triples, triples + 4, 6};
    nkw_track track = {knots, triples, POINTS, 2, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE, NULL};
    nkw_spline_knots(&spline, alpha, knots);
    nkw_spline_tangents(&spline, tangents, NULL, (nkw_work){NULL, 0});
    for (int k = 0; k < POINTS; k++)
        memcpy(triples + 6 * k + 2, places + 2 * k, 2 * sizeof(float));
    svg_rect(s, box, 6.0f, &border);
    for (int i = 0; i <= 5 * FIGURE_STEPS; i++) {
        nkw_segment at = {(size_t)(i < 5 * FIGURE_STEPS ? i / FIGURE_STEPS : POINTS - 2), 1.0f};
        if (i < 5 * FIGURE_STEPS)
            at.t = (float)(i % FIGURE_STEPS) / (float)FIGURE_STEPS;
        nkw_track_sample_segment(&track, at, p);
        line[i] = on_plane(box, p[0], p[1]);
    }
    svg_polyline(s, line, 5 * FIGURE_STEPS + 1, &paint);
    for (int k = 0; k < POINTS; k++)
        figure_key(s, on_plane(box, places[2 * k], places[2 * k + 1]));
    figure_bold(s, box.x + 16.0f, box.y + 28.0f, 15.0f, colour, 's', name);
    figure_text(s, box.x + 16.0f, box.y + 48.0f, 12.0f, FIGURE_GREY, 's', rule);
}

int figure_spline_knots(const char *path)
{
    svg s;
    if (!figure_open(&s, path, 1064.0f, 400.0f, "Close points need short knots",
                     "Catmull-Rom through the same six points; the knots step by |distance|^alpha."))
        return 0;
    for (int i = 0; i < 3; i++) {
        static const svg_colour colours[3] = {FIGURE_EULER, FIGURE_CATMULL_ROM, FIGURE_HERMITE};
        static const char *const names[3] = {"uniform, alpha = 0", "centripetal, alpha = 1/2", "chordal, alpha = 1"};
        static const char *const rules[3] = {"loops where points are close", "no loops or cusps within a segment",
                                             "wide bends between distant points"};
        svg_box box = {24.0f + 341.0f * (float)i, 84.0f, 331.0f, 296.0f};
        knots_panel(&s, box, 0.5f * (float)i, colours[i], names[i], rules[i]);
    }
    return svg_close(&s);
}

/* ---- Frames along a path with an inflection ---- */

enum { STEPS = 56 };
static const nkw_vec3_cubic bend = {{{0.0f, 0.0f, 0.0f}, {2.6f, 3.4f, 0.0f}, {2.4f, -2.4f, 0.0f}, {5.0f, 1.0f, 0.0f}}};

static svg_point on_path(svg_box box, nkw_vec3 p)
{
    return svg_at(box.x + 40.0f + 84.0f * p.x, box.y + box.height - 90.0f - 84.0f * p.y);
}

static void frames_panel(svg *s, svg_box box, int frenet)
{
    const nkw_polycurve curve = {&bend, 1, NKW_CUBIC_BEZIER};
    const nkw_vec3 up = {0.0f, 1.0f, 0.0f};
    nkw_curve_frame frames[STEPS + 1];
    svg_point line[STEPS + 1];
    svg_colour colour = frenet ? FIGURE_EULER : FIGURE_BSPLINE;
    svg_paint path = svg_stroke(FIGURE_INK, 2.6f, 1.0f), border = svg_stroke(0xd5d5da, 1.0f, 1.0f);
    svg_paint normal = svg_stroke(colour, 1.8f, 0.9f);
    nkw_polycurve_frames(&curve, STEPS, up, NKW_POLYCURVE_OPEN, frames, STEPS + 1);
    svg_rect(s, box, 6.0f, &border);
    for (int i = 0; i <= STEPS; i++) {
        nkw_segment at = {0, (float)i / (float)STEPS};
        nkw_vec3_motion p = nkw_polycurve_evaluate(&curve, at);
        nkw_curve_frame f = frenet ? nkw_curve_frame_frenet(&p, up) : frames[i];
        line[i] = on_path(box, p.value);
        svg_line(s, line[i], on_path(box, nkw_vec3_add_scaled(p.value, f.normal, 0.55f)), &normal);
    }
    svg_polyline(s, line, STEPS + 1, &path);
    figure_bold(s, box.x + 16.0f, box.y + 28.0f, 15.0f, colour, 's', frenet ? "Frenet" : "rotation-minimising");
    figure_text(s, box.x + 16.0f, box.y + 48.0f, 12.0f, FIGURE_GREY, 's',
                frenet ? "to the centre of curvature: turns by half a turn at the inflection"
                       : "the least rotation about the tangent");
}

int figure_polycurve_frames(const char *path)
{
    svg s;
    if (!figure_open(&s, path, 1064.0f, 420.0f, "The up direction along a path",
                     "Lines: the normals of the frames. A camera on the left would turn over in the middle."))
        return 0;
    for (int i = 0; i < 2; i++) {
        svg_box box = {24.0f + 512.0f * (float)i, 84.0f, 504.0f, 316.0f};
        frames_panel(&s, box, i == 0);
    }
    return svg_close(&s);
}

/* ---- Places at equal steps of t, and of length ---- */

static void speed_row(svg *s, float y, int by_length, svg_colour colour, const char *name)
{
    static const nkw_vec3_cubic cubic = {
        {{0.0f, 0.0f, 0.0f}, {0.3f, 1.6f, 0.0f}, {0.9f, 1.9f, 0.0f}, {9.0f, 0.3f, 0.0f}}};
    const nkw_polycurve curve = {&cubic, 1, NKW_CUBIC_BEZIER};
    float lengths[NKW_POLYCURVE_LENGTHS(1, 4)];
    svg_point line[FIGURE_STEPS + 1];
    svg_paint path = svg_stroke(FIGURE_PALE, 2.0f, 1.0f);
    nkw_polycurve_measure(&curve, 4, lengths, NKW_POLYCURVE_LENGTHS(1, 4));
    for (int i = 0; i <= FIGURE_STEPS; i++) {
        nkw_segment at = {0, (float)i / (float)FIGURE_STEPS};
        nkw_vec3 p = nkw_polycurve_evaluate(&curve, at).value;
        line[i] = svg_at(60.0f + 104.0f * p.x, y - 90.0f * p.y);
    }
    svg_polyline(s, line, FIGURE_STEPS + 1, &path);
    for (int i = 0; i <= 24; i++) {
        float share = (float)i / 24.0f;
        nkw_segment at = {0, share};
        if (by_length)
            at = nkw_polycurve_at_length(&curve, lengths, NKW_POLYCURVE_LENGTHS(curve.count, 4), share * lengths[4]);
        nkw_vec3 p = nkw_polycurve_evaluate(&curve, at).value;
        figure_dot(s, svg_at(60.0f + 104.0f * p.x, y - 90.0f * p.y), colour);
    }
    figure_bold(s, 300.0f, y - 8.0f, 15.0f, colour, 's', name);
}

int figure_polycurve_speed(const char *path)
{
    svg s;
    if (!figure_open(&s, path, 1064.0f, 460.0f, "Equal steps of t are not equal steps of the path",
                     "25 places on one B\303\251zier segment."))
        return 0;
    speed_row(&s, 236.0f, 0, FIGURE_EULER, "t = 0, 1/24 .. 1: slow at first, then faster and faster");
    speed_row(&s, 430.0f, 1, FIGURE_CATMULL_ROM,
              "nkw_polycurve_at_length at 0, 1/24 .. 1 of the length: constant speed");
    return svg_close(&s);
}
