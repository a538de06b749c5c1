/* SPDX-License-Identifier: MIT */
/* Handles in time, the behaviour outside the keys, and easing. */
#include "figure.h"

#include <stdio.h>

#include <nakawari/dialect.h>

enum { STEPS = 240 };

/* ---- A segment that runs back, under the four policies ---- */

static nkw_handle point_of(const nkw_handle_segment *c, float s)
{
    nkw_handle p = {nkw_bezier(c->time0, c->time0 + c->out.time, c->time1 + c->in.time, c->time1, s),
                    nkw_bezier(c->value0, c->value0 + c->out.value, c->value1 + c->in.value, c->value1, s)};
    return p;
}

static void draw_handles(svg *s, const svg_plot *plot, const nkw_handle_segment *c, svg_colour colour)
{
    svg_paint stick = svg_stroke(colour, 1.4f, 1.0f);
    svg_point a = svg_plot_at(plot, c->time0, c->value0), b = svg_plot_at(plot, c->time1, c->value1);
    svg_point out = svg_plot_at(plot, c->time0 + c->out.time, c->value0 + c->out.value);
    svg_point in = svg_plot_at(plot, c->time1 + c->in.time, c->value1 + c->in.value);
    svg_line(s, a, out, &stick);
    svg_line(s, b, in, &stick);
    figure_dot(s, out, colour);
    figure_dot(s, in, colour);
    figure_key(s, a);
    figure_key(s, b);
}

static void draw_parametric(svg *s, const svg_plot *plot, const nkw_handle_segment *c, const svg_paint *paint)
{
    svg_point line[STEPS + 1];
    for (int i = 0; i <= STEPS; i++) {
        nkw_handle p = point_of(c, (float)i / (float)STEPS);
        line[i] = svg_plot_at(plot, p.time, p.value);
    }
    svg_polyline(s, line, STEPS + 1, paint);
}

/* The values that the solver returns, with a gap where they jump. */
static void draw_values(svg *s, const svg_plot *plot, const nkw_handle_segment *c, const svg_paint *paint)
{
    svg_point line[4 * STEPS + 1];
    size_t n = 0;
    float before = c->value0;
    for (int i = 0; i <= 4 * STEPS; i++) {
        float time = nkw_lerp(c->time0, c->time1, (float)i / (float)(4 * STEPS)),
              value = nkw_handle_sample(c, time).value;
        if (value - before > 0.2f) {
            svg_polyline(s, line, n, paint);
            n = 0;
        }
        line[n++] = svg_plot_at(plot, time, value);
        before = value;
    }
    svg_polyline(s, line, n, paint);
}

static void policy_panel(svg *s, float x, float y, nkw_handle_policy policy, const char *name, const char *effect)
{
    const nkw_handle_segment c = {0.0f, 0.0f, {1.75f, 0.35f}, {-1.05f, 0.1f}, 1.0f, 1.0f};
    nkw_handle_segment limited = nkw_handle_limit(&c, policy);
    svg_plot plot = {{x, y, 400.0f, 200.0f}, {-0.15f, 1.85f, 0.5f, "time, s"}, {-0.15f, 1.25f, 0.5f, ""}};
    svg_paint whole = svg_stroke(FIGURE_PALE, 1.6f, 1.0f), curve = svg_stroke(FIGURE_BEZIER, 3.0f, 1.0f);
    whole.dash = "5 4";
    figure_bold(s, x, y - 30.0f, 15.0f, FIGURE_INK, 's', name);
    figure_text(s, x, y - 11.0f, 13.0f, 0x2b2b30, 's', effect);
    svg_plot_frame(s, &plot);
    draw_parametric(s, &plot, &c, &whole);
    draw_values(s, &plot, &limited, &curve);
    draw_handles(s, &plot, &limited, FIGURE_CATMULL_ROM);
}

int figure_fcurve_policies(const char *path)
{
    svg s;
    if (!figure_open(&s, path, 960.0f, 750.0f, "A handle that runs back in time, under four policies",
                     "At some times the curve of the given handles has three values. A policy shortens the handles."))
        return 0;
    svg_paint given = svg_stroke(FIGURE_PALE, 1.6f, 1.0f), value = svg_stroke(FIGURE_BEZIER, 3.0f, 1.0f);
    svg_paint handle = svg_stroke(FIGURE_CATMULL_ROM, 1.4f, 1.0f);
    given.dash = "5 4";
    figure_legend(&s, 60.0f, 94.0f, &given, "the curve of the given handles");
    figure_legend(&s, 340.0f, 94.0f, &value, "the value at each time");
    figure_legend(&s, 560.0f, 94.0f, &handle, "the handles under the policy");
    policy_panel(&s, 60.0f, 160.0f, NKW_HANDLE_NONE, "NONE",
                 "The first value is used; the curve jumps where it runs back.");
    policy_panel(&s, 530.0f, 160.0f, NKW_HANDLE_CONTAIN, "CONTAIN (Blender)", "Each handle ends at the other key.");
    policy_panel(&s, 60.0f, 490.0f, NKW_HANDLE_KEEP_RATIO, "KEEP_RATIO (OpenUSD)", "Both by one factor.");
    policy_panel(&s, 530.0f, 490.0f, NKW_HANDLE_KEEP_START, "KEEP_START (Maya)",
                 "The end handle is shortened first; 4/3 and 1/3 at most.");
    return svg_close(&s);
}

/* ---- Before and after the keys ---- */

static void outside_panel(svg *s, float y, nkw_fcurve_outside outside, const char *name)
{
    static const nkw_fcurve_key keys[3] = {{0, 0.2f, {0, 0}, {0.2f, 0.5f}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                                           {0.6f, 1, {-0.25f, 0}, {0.15f, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                                           {1, 0.6f, {-0.25f, -0.1f}, {0, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR}};
    nkw_fcurve curve = {keys, 3, outside, outside, 2, 2, NKW_HANDLE_NONE};
    svg_plot plot = {{170.0f, y, 760.0f, 92.0f}, {-3.2f, 4.2f, 1.0f, ""}, {-1.4f, 2.4f, 1.0f, ""}};
    svg_paint within = svg_stroke(FIGURE_BEZIER, 3.2f, 1.0f), around = svg_stroke(FIGURE_BSPLINE, 2.0f, 1.0f);
    svg_point line[STEPS + 1];
    size_t n = 0;
    svg_plot_frame(s, &plot);
    figure_bold(s, 20.0f, y + 50.0f, 13.0f, FIGURE_INK, 's', name);
    float before = nkw_fcurve_sample(&curve, -3.2f, NULL).value;
    for (int i = 0; i <= STEPS; i++) {
        float time = nkw_lerp(-3.2f, 4.2f, (float)i / (float)STEPS), value = nkw_fcurve_sample(&curve, time, NULL).value;
        if (nkw_abs(value - before) > 0.25f) {
            svg_polyline(s, line, n, &around);
            n = 0;
        }
        if (value >= -1.4f && value <= 2.4f)
            line[n++] = svg_plot_at(&plot, time, value);
        before = value;
    }
    svg_polyline(s, line, n, &around);
    for (int i = 0; i <= STEPS; i++)
        line[i] = svg_plot_at(&plot, (float)i / STEPS, nkw_fcurve_sample(&curve, (float)i / STEPS, NULL).value);
    svg_polyline(s, line, STEPS + 1, &within);
    for (int k = 0; k < 3; k++)
        figure_key(s, svg_plot_at(&plot, keys[k].time, keys[k].value));
}

int figure_fcurve_outside(const char *path)
{
    svg s;
    static const char *names[5] = {"HOLD", "LINEAR", "CYCLE", "CYCLE_OFFSET", "OSCILLATE"};
    if (!figure_open(&s, path, 960.0f, 746.0f, "Before the first and after the last key",
                     "Three keys from 0 to 1 s; two cycles on each side, then the value is held."))
        return 0;
    svg_paint within = svg_stroke(FIGURE_BEZIER, 3.2f, 1.0f), around = svg_stroke(FIGURE_BSPLINE, 2.0f, 1.0f);
    figure_legend(&s, 170.0f, 92.0f, &within, "between the keys");
    figure_legend(&s, 360.0f, 92.0f, &around, "before and after");
    for (int i = 0; i < 5; i++)
        outside_panel(&s, 110.0f + 122.0f * (float)i, (nkw_fcurve_outside)i, names[i]);
    figure_text(&s, 550.0f, 734.0f, 13.0f, 0x2b2b30, 'm', "time, s");
    return svg_close(&s);
}

/* ---- Easing ---- */

static const svg_colour form_colours[3] = {FIGURE_HERMITE, FIGURE_CATMULL_ROM, FIGURE_BEZIER};

static void ease_panel(svg *s, int family, const char *name)
{
    float x = 40.0f + 186.0f * (float)(family % 5), y = 150.0f + 232.0f * (float)(family / 5);
    svg_plot plot = {{x, y, 150.0f, 170.0f}, {0.0f, 1.0f, 1.0f, ""}, {-0.45f, 1.45f, 1.0f, ""}};
    float values[FIGURE_STEPS + 1];
    svg_plot_frame(s, &plot);
    figure_bold(s, x, y - 9.0f, 13.0f, FIGURE_INK, 's', name);
    for (int form = 0; form < 3; form++) {
        svg_paint paint = svg_stroke(form_colours[form], 2.0f, 1.0f);
        for (int i = 0; i <= FIGURE_STEPS; i++)
            values[i] =
                nkw_ease_evaluate((nkw_ease_kind)(NKW_EASE_SINE_IN + 3 * family + form), (float)i / (float)FIGURE_STEPS)
                    .value;
        figure_graph(s, &plot, values, &paint);
    }
}

int figure_ease_kinds(const char *path)
{
    svg s;
    static const char *names[10] = {"SINE", "QUAD", "CUBIC", "QUART",   "QUINT",
                                    "EXPO", "CIRC", "BACK",  "ELASTIC", "BOUNCE"};
    if (!figure_open(&s, path, 980.0f, 590.0f, "Penner's thirty easing functions",
                     "Both axes from 0 to 1; BACK and ELASTIC leave 0..1."))
        return 0;
    for (int i = 0; i < 3; i++) {
        static const char *forms[3] = {"in", "out", "in-out"};
        svg_paint paint = svg_stroke(form_colours[i], 2.0f, 1.0f);
        figure_legend(&s, 40.0f + 110.0f * (float)i, 96.0f, &paint, forms[i]);
    }
    for (int i = 0; i < 10; i++)
        ease_panel(&s, i, names[i]);
    return svg_close(&s);
}

/* ---- To a CUBICSPLINE track ---- */

static void track_panel(svg *s, float x, float tolerance, const char *name)
{
    static const nkw_fcurve_key keys[3] = {{0, 0, {0, 0}, {0.95f, 0.1f}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                                           {1, 1, {-0.8f, 0}, {0.1f, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR},
                                           {2, 0.3f, {-0.8f, 0.4f}, {0, 0}, NKW_FCURVE_BEZIER, NKW_EASE_LINEAR}};
    float times[64], values[192], error;
    nkw_fcurve curve = {keys, 3, NKW_FCURVE_OUTSIDE_HOLD, NKW_FCURVE_OUTSIDE_HOLD, 0, 0, NKW_HANDLE_NONE};
    nkw_track_span span = {times, values, NULL, 64};
    nkw_track track;
    svg_plot plot = {{x, 150.0f, 400.0f, 250.0f}, {-0.1f, 2.1f, 0.5f, "time, s"}, {-0.15f, 1.2f, 0.5f, ""}};
    svg_paint exact = svg_stroke(FIGURE_BEZIER, 5.0f, 0.35f), made = svg_stroke(FIGURE_HERMITE, 1.8f, 1.0f);
    svg_point line[STEPS + 1], fitted[STEPS + 1];
    char text[80];
    figure_bold(s, x, 120.0f, 15.0f, FIGURE_INK, 's', name);
    if (nkw_track_from_fcurves(&curve, 1, tolerance, span, &track, &error) != NKW_OK)
        return;
    svg_plot_frame(s, &plot);
    for (int i = 0; i <= STEPS; i++) {
        float time = 2.0f * (float)i / (float)STEPS, value;
        nkw_track_sample(&track, time, NULL, &value);
        line[i] = svg_plot_at(&plot, time, nkw_fcurve_sample(&curve, time, NULL).value);
        fitted[i] = svg_plot_at(&plot, time, value);
    }
    svg_polyline(s, line, STEPS + 1, &exact);
    svg_polyline(s, fitted, STEPS + 1, &made);
    for (size_t k = 0; k < track.count; k++)
        figure_key(s, svg_plot_at(&plot, times[k], values[3 * k + 1]));
    sprintf(text, "%u keys, largest difference %.5f", (unsigned)track.count, (double)error);
    figure_text(s, x, 140.0f, 13.0f, 0x2b2b30, 's', text);
}

int figure_dialect_track(const char *path)
{
    svg s;
    if (!figure_open(&s, path, 960.0f, 460.0f, "Handles in time as CUBICSPLINE keys",
                     "nkw_track_from_fcurves adds keys until the difference is within the tolerance."))
        return 0;
    svg_paint exact = svg_stroke(FIGURE_BEZIER, 5.0f, 0.35f), made = svg_stroke(FIGURE_HERMITE, 1.8f, 1.0f);
    figure_legend(&s, 50.0f, 92.0f, &exact, "three keys with handles in time");
    figure_legend(&s, 340.0f, 92.0f, &made, "the track and its keys");
    track_panel(&s, 50.0f, 0.05f, "tolerance 0.05");
    track_panel(&s, 530.0f, 0.001f, "tolerance 0.001");
    return svg_close(&s);
}
