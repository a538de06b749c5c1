/* SPDX-License-Identifier: MIT */
/* Three ways to write a straight line in floats. */
#include "figure.h"

#include <nakawari/scalar.h>

enum { FORMS = 3, DOTS = 33 };
static const svg_colour colours[FORMS] = {0xc2185b, 0xe07b00, 0x1f5fd0};
static const char *const names[FORMS] = {"a + t (b - a)", "(1 - t) a + t b", "nkw_lerp"};

/* In these each step is stored, so that no compiler keeps more digits than a float has. */
static float from_start(float a, float b, float t)
{
    volatile float way = b - a, part = t * way;
    return a + part;
}

static float from_both(float a, float b, float t)
{
    volatile float u = 1.0f - t, first = u * a, second = t * b;
    return first + second;
}

static float form(int which, float a, float b, float t)
{
    return which == 0 ? from_start(a, b, t) : which == 1 ? from_both(a, b, t) : nkw_lerp(a, b, t);
}

static void disc(svg *s, svg_point at, svg_colour colour, float radius)
{
    svg_paint paint = svg_fill(colour, 1.0f);
    svg_circle(s, at, radius, &paint);
}

/* From a = -1000 to b = 0.001: the last 12 floats before t = 1, in thousandths. */
static void last_steps(svg *s, const svg_plot *plot)
{
    const float a = -1000.0f, b = 0.001f, step = 0x1p-24f;
    svg_paint level = svg_stroke(FIGURE_PALE, 1.2f, 1.0f);
    level.dash = "5 4";
    svg_line(s, svg_plot_at(plot, plot->x.from, 1000.0f * b), svg_plot_at(plot, plot->x.to, 1000.0f * b), &level);
    svg_point name = svg_plot_at(plot, -11.6f, 1000.0f * b);
    figure_name(s, name.x, name.y + 5.0f, FIGURE_GREY, 's', "b");
    for (int i = -12; i <= 0; i++) {
        float t = 1.0f + (float)i * step;
        disc(s, svg_plot_at(plot, (float)i, 1000.0f * form(0, a, b, t)), colours[0], 5.4f);
        disc(s, svg_plot_at(plot, (float)i, 1000.0f * form(2, a, b, t)), colours[2], 3.4f);
    }
}

/* From a to a: how many units in the last place the result is off. */
static void between_equals(svg *s, const svg_plot *plot)
{
    const float a = 0.7f, ulp = 0x1p-24f;
    for (int i = 0; i < DOTS; i++) {
        float t = (float)i / (float)(DOTS - 1) + (i % (DOTS - 1) ? 0.0031f : 0.0f);
        disc(s, svg_plot_at(plot, t, (form(1, a, a, t) - a) / ulp), colours[1], 5.4f);
        disc(s, svg_plot_at(plot, t, (form(2, a, a, t) - a) / ulp), colours[2], 3.4f);
    }
}

int figure_scalar_lerp(const char *path)
{
    svg s;
    svg_plot end = {{70.0f, 138.0f, 400.0f, 250.0f}, {-12.5f, 0.5f, 2.0f, "n of t = 1 + n 2^-24"},
                    {0.2f, 1.1f, 0.1f, "result, thousandths"}};
    svg_plot equal = {{550.0f, 138.0f, 400.0f, 250.0f}, {-0.02f, 1.02f, 0.25f, "t"},
                      {-1.5f, 1.5f, 0.5f, "result - a, units in the last place"}};
    if (!figure_open(&s, path, 980.0f, 476.0f, "nkw_lerp starts at the nearer end",
                     "Each textbook form of lerp loses one property; the form from the nearer end has both."))
        return 0;
    figure_bold(&s, 70.0f, 104.0f, 15.0f, FIGURE_INK, 's', "Near t = 1: from -1000 to 0.001");
    figure_bold(&s, 550.0f, 104.0f, 15.0f, FIGURE_INK, 's', "Equal ends: from 0.7 to 0.7");
    svg_plot_frame(&s, &end);
    svg_plot_frame(&s, &equal);
    last_steps(&s, &end);
    between_equals(&s, &equal);
    for (int i = 0; i < FORMS; i++) {
        float x = 220.0f + 220.0f * (float)i;
        disc(&s, svg_at(x, 452.0f), colours[i], i == 2 ? 3.4f : 5.4f);
        figure_text(&s, x + 14.0f, 456.0f, 13.0f, 0x2b2b30, 's', names[i]);
    }
    return svg_close(&s);
}
