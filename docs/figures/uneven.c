/* SPDX-License-Identifier: MIT */
/* Curves over key times that are not even, and the units of their tangents. */
#include "figure.h"

#include <nakawari/curve.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

static const svg_colour uniform_colour = 0xc2185b, timed_colour = 0x1f5fd0;

/* ---- Catmull-Rom over uneven times ---- */

enum { KEYS = 6 };
static const float times[KEYS] = {0.0f, 1.2f, 1.5f, 1.8f, 3.4f, 4.0f};

/* The motion that the keys were taken from. */
static float motion(float time)
{
    return nkw_sin(1.5f * time);
}

/* The four keys around segment k, the end keys doubled. */
static void around(size_t k, float time[4], float value[4])
{
    size_t key[4] = {k > 0 ? k - 1 : 0, k, k + 1, k + 2 < KEYS ? k + 2 : k + 1};
    for (int i = 0; i < 4; i++) {
        time[i] = times[key[i]];
        value[i] = motion(time[i]);
    }
}

/* The curve of four keys at any times. */
static float uneven(const float at[4], float p0, float p1, float p2, float p3, float t)
{
    const float keys[4] = {p0, p1, p2, p3};
    float c[4];
    nkw_cubic_from_catmull_rom(keys, at, c);
    return nkw_hermite(c[0], c[1], c[2], c[3], t);
}

static float value_at(size_t k, float t, int timed)
{
    float h[4], p[4];
    around(k, h, p);
    return timed ? uneven(h, p[0], p[1], p[2], p[3], t) : nkw_catmull_rom(p[0], p[1], p[2], p[3], t);
}

/* Per second. */
static float velocity_at(size_t k, float t, int timed)
{
    float h[4], p[4];
    around(k, h, p);
    float duration = h[2] - h[1];
    float c[4];
    nkw_cubic_from_catmull_rom(p, h, c);
    return (timed ? nkw_cubic_evaluate(c, t, NKW_CUBIC_HERMITE) : nkw_cubic_evaluate(p, t, NKW_CUBIC_CATMULL_ROM))
               .velocity /
           duration;
}

enum { PER_SEGMENT = 32, SAMPLES = (KEYS - 1) * (PER_SEGMENT + 1) };

/* Both ends of every segment are drawn, so that a jump shows as an upright line. */
static void uneven_line(svg *s, const svg_plot *plot, float (*f)(size_t, float, int), int timed, svg_paint paint)
{
    svg_point line[SAMPLES];
    for (size_t i = 0; i < SAMPLES; i++) {
        size_t k = i / (PER_SEGMENT + 1);
        float t = (float)(i % (PER_SEGMENT + 1)) / (float)PER_SEGMENT;
        line[i] = svg_plot_at(plot, nkw_lerp(times[k], times[k + 1], t), f(k, t, timed));
    }
    svg_polyline(s, line, SAMPLES, &paint);
}

static void key_rules(svg *s, const svg_plot *plot)
{
    svg_paint paint = svg_stroke(0xb5b5bc, 1.0f, 1.0f);
    paint.dash = "2 4";
    for (int k = 0; k < KEYS; k++)
        svg_line(s, svg_plot_at(plot, times[k], plot->y.from), svg_plot_at(plot, times[k], plot->y.to), &paint);
}

static svg_paint dashed(svg_colour colour, float width)
{
    svg_paint paint = svg_stroke(colour, width, 1.0f);
    paint.dash = "6 4";
    return paint;
}

static void true_line(svg *s, const svg_plot *plot)
{
    svg_point line[FIGURE_STEPS + 1];
    svg_paint paint = svg_stroke(0xa9adba, 5.0f, 0.6f);
    for (int i = 0; i <= FIGURE_STEPS; i++) {
        float time = times[KEYS - 1] * (float)i / (float)FIGURE_STEPS;
        line[i] = svg_plot_at(plot, time, motion(time));
    }
    svg_polyline(s, line, FIGURE_STEPS + 1, &paint);
}

int figure_curve_uneven(const char *path)
{
    svg s;
    svg_plot value = {{70.0f, 120.0f, 900.0f, 240.0f}, {-0.1f, 4.1f, 0.5f, ""}, {-1.4f, 1.4f, 0.5f, "value"}};
    svg_plot speed = {
        {70.0f, 420.0f, 900.0f, 220.0f}, {-0.1f, 4.1f, 0.5f, "time, s"}, {-3.3f, 2.3f, 1.0f, "velocity, per second"}};
    svg_paint uniform = dashed(uniform_colour, 2.4f), timed = svg_stroke(timed_colour, 2.6f, 1.0f);
    svg_paint truth = svg_stroke(0xa9adba, 5.0f, 0.6f);
    if (!figure_open(&s, path, 1000.0f, 724.0f, "Catmull-Rom over non-uniform keys needs their times",
                     "The uniform form assumes segments of equal duration: its velocity jumps at the keys, and it "
                     "overshoots in short segments."))
        return 0;
    svg_plot_frame(&s, &value);
    svg_plot_frame(&s, &speed);
    key_rules(&s, &value);
    key_rules(&s, &speed);
    true_line(&s, &value);
    uneven_line(&s, &value, value_at, 0, uniform);
    uneven_line(&s, &value, value_at, 1, timed);
    uneven_line(&s, &speed, velocity_at, 0, uniform);
    uneven_line(&s, &speed, velocity_at, 1, timed);
    for (int k = 0; k < KEYS; k++)
        figure_key(&s, svg_plot_at(&value, times[k], motion(times[k])));
    figure_legend(&s, 70.0f, 708.0f, &uniform, "nkw_catmull_rom: uniform");
    figure_legend(&s, 330.0f, 708.0f, &timed, "nkw_cubic_from_catmull_rom");
    figure_legend(&s, 590.0f, 708.0f, &truth, "the motion the keys were taken from");
    return svg_close(&s);
}

/* ---- three dialects of tangents ---- */

static const float key_time[3] = {0.0f, 0.5f, 2.5f}, key_value[3] = {0.0f, 0.6f, 1.1f};

/* A piece of the line of slope v through a key, on the side `way` (-1 or 1). */
static void slope_line(svg *s, const svg_plot *plot, int key, float v, float way)
{
    svg_paint paint = svg_stroke(FIGURE_INK, 1.6f, 1.0f);
    float dx = plot->box.width / (plot->x.to - plot->x.from);
    float dy = v * plot->box.height / (plot->y.to - plot->y.from);
    float k = way * 40.0f / nkw_sqrt(dx * dx + dy * dy);
    svg_point p = svg_plot_at(plot, key_time[key], key_value[key]);
    svg_line(s, p, svg_at(p.x + k * dx, p.y - k * dy), &paint);
}

/* The tangent 1 at every key, per segment or per second. */
static void dialect_curve(svg *s, const svg_plot *plot, int per_second, svg_colour colour)
{
    svg_paint paint = svg_stroke(colour, 3.2f, 1.0f);
    for (int k = 0; k < 2; k++) {
        float h = key_time[k + 1] - key_time[k], v = per_second ? h : 1.0f;
        svg_point line[FIGURE_STEPS + 1];
        for (int i = 0; i <= FIGURE_STEPS; i++) {
            float t = (float)i / (float)FIGURE_STEPS;
            float y = nkw_hermite(key_value[k], v, key_value[k + 1], v, t);
            line[i] = svg_plot_at(plot, nkw_lerp(key_time[k], key_time[k + 1], t), y);
        }
        svg_polyline(s, line, FIGURE_STEPS + 1, &paint);
        slope_line(s, plot, k, v / h, 1.0f);
        slope_line(s, plot, k + 1, v / h, -1.0f);
    }
    for (int k = 0; k < 3; k++)
        figure_key(s, svg_plot_at(plot, key_time[k], key_value[k]));
}

static void dialect_panel(svg *s, float x, int per_second, svg_colour colour)
{
    svg_plot plot = {{x, 178.0f, 300.0f, 270.0f}, {-0.3f, 2.8f, 0.5f, "time, s"}, {-0.3f, 1.6f, 0.5f, "value"}};
    svg_plot_frame(s, &plot);
    dialect_curve(s, &plot, per_second, colour);
}

/* The exercise, seen from above: tangents of length 1, however far the keys stand apart. */
static void heading_pair(svg *s, svg_point at, float apart, svg_colour colour)
{
    const float unit = 72.0f;
    nkw_vec3 p0 = {0.0f, 0.0f, 0.0f}, p1 = {apart, 0.0f, 0.0f};
    nkw_vec3 v0 = {0.34202014f, 0.93969262f, 0.0f}, v1 = {0.34202014f, -0.93969262f, 0.0f};
    svg_point line[FIGURE_STEPS + 1];
    svg_paint paint = svg_stroke(colour, 3.2f, 1.0f), arrow = svg_stroke(FIGURE_INK, 1.8f, 1.0f);
    for (int i = 0; i <= FIGURE_STEPS; i++) {
        nkw_vec3 p = nkw_vec3_hermite(p0, v0, p1, v1, (float)i / (float)FIGURE_STEPS);
        line[i] = svg_at(at.x + unit * p.x, at.y - unit * p.y);
    }
    svg_polyline(s, line, FIGURE_STEPS + 1, &paint);
    svg_point end = line[FIGURE_STEPS];
    svg_arrow(s, at, svg_at(at.x + unit * v0.x, at.y - unit * v0.y), &arrow);
    svg_arrow(s, end, svg_at(end.x + unit * v1.x, end.y - unit * v1.y), &arrow);
    figure_key(s, at);
    figure_key(s, end);
}

static void heading_panel(svg *s, float x, svg_colour colour)
{
    svg_box box = {x, 178.0f, 300.0f, 270.0f};
    svg_paint border = svg_stroke(FIGURE_PALE, 1.0f, 1.0f);
    svg_rect(s, box, 0.0f, &border);
    figure_text(s, x, 169.0f, 12.0f, 0x2b2b30, 's', "from above");
    heading_pair(s, svg_at(x + 30.0f, 262.0f), 0.35f, colour);
    heading_pair(s, svg_at(x + 30.0f, 372.0f), 2.9f, colour);
    figure_text(s, x + 104.0f, 258.0f, 12.0f, FIGURE_GREY, 's', "keys 0.35 apart: a hairpin");
    figure_text(s, x + 30.0f, 414.0f, 12.0f, FIGURE_GREY, 's', "keys 2.9 apart: nearly straight");
}

static void dialect_heading(svg *s, float x, svg_colour colour, const char *name, const char *rule, const char *effect,
                            const char *more)
{
    figure_bold(s, x, 108.0f, 15.0f, colour, 's', name);
    figure_text(s, x, 130.0f, 13.0f, 0x2b2b30, 's', rule);
    figure_text(s, x, 506.0f, 13.0f, 0x2b2b30, 's', effect);
    figure_text(s, x, 524.0f, 13.0f, 0x2b2b30, 's', more);
}

int figure_curve_tangents(const char *path)
{
    svg s;
    const svg_colour colours[3] = {FIGURE_HERMITE, 0x2c8c4a, FIGURE_BEZIER};
    if (!figure_open(&s, path, 1080.0f, 546.0f, "The number 1 as a tangent, in three dialects",
                     "The Hermite functions take tangents per segment. The same number read in another unit gives "
                     "another curve. Black: the tangents."))
        return 0;
    dialect_panel(&s, 60.0f, 0, colours[0]);
    dialect_panel(&s, 414.0f, 1, colours[1]);
    heading_panel(&s, 756.0f, colours[2]);
    dialect_heading(&s, 60.0f, colours[0], "per segment", "v unchanged", "Slope v/duration: 2 before the middle key,",
                    "0.5 after it. The velocity jumps.");
    dialect_heading(&s, 414.0f, colours[1], "per second (glTF)", "v times the duration of the segment",
                    "Slope 1 on both sides of every key:", "the velocity is continuous.");
    dialect_heading(&s, 756.0f, colours[2], "the exercise", "v = -z of the key's rotation, length 1",
                    "Neither time nor distance is a factor: the bend", "depends on the distance of the keys.");
    return svg_close(&s);
}
