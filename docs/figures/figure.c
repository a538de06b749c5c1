/* SPDX-License-Identifier: MIT */
#include "figure.h"

#include <nakawari/mat.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

static void put_text(svg *s, float x, float y, svg_font font, const char *text)
{
    svg_text(s, svg_at(x, y), &font, text);
}

void figure_text(svg *s, float x, float y, float size, svg_colour colour, char anchor, const char *text)
{
    svg_font font = {size, colour, anchor, 0, SVG_NONE};
    put_text(s, x, y, font, text);
}

void figure_bold(svg *s, float x, float y, float size, svg_colour colour, char anchor, const char *text)
{
    svg_font font = {size, colour, anchor, 1, SVG_NONE};
    put_text(s, x, y, font, text);
}

void figure_name(svg *s, float x, float y, svg_colour colour, char anchor, const char *text)
{
    svg_font font = {14.0f, colour, anchor, 1, 0xffffff};
    put_text(s, x, y, font, text);
}

int figure_open(svg *s, const char *path, float width, float height, const char *lesson, const char *reading)
{
    if (!svg_open(s, path, width, height, lesson, reading))
        return 0;
    figure_bold(s, 24.0f, 36.0f, 20.0f, FIGURE_INK, 's', lesson);
    figure_text(s, 24.0f, 60.0f, 14.0f, 0x4a4a52, 's', reading);
    return 1;
}

void figure_legend(svg *s, float x, float y, const svg_paint *paint, const char *text)
{
    svg_line(s, svg_at(x, y - 4.0f), svg_at(x + 30.0f, y - 4.0f), paint);
    figure_text(s, x + 38.0f, y, 13.0f, 0x2b2b30, 's', text);
}

void figure_dot(svg *s, svg_point at, svg_colour colour)
{
    svg_paint paint = {colour, 0xffffff, 1.0f, 1.0f, NULL};
    svg_circle(s, at, 4.2f, &paint);
}

void figure_key(svg *s, svg_point at)
{
    svg_paint paint = {0xffffff, FIGURE_INK, 2.0f, 1.0f, NULL};
    svg_circle(s, at, 5.5f, &paint);
}

void figure_graph(svg *s, const svg_plot *plot, const float y[FIGURE_STEPS + 1], const svg_paint *paint)
{
    svg_point line[FIGURE_STEPS + 1];
    for (int i = 0; i <= FIGURE_STEPS; i++)
        line[i] = svg_plot_at(plot, (float)i / (float)FIGURE_STEPS, y[i]);
    svg_polyline(s, line, FIGURE_STEPS + 1, paint);
}

/* ---- arcs of the page ---- */

static svg_point on_circle(svg_point centre, float radius, float angle)
{
    return svg_at(centre.x + radius * nkw_cos(angle), centre.y - radius * nkw_sin(angle));
}

void figure_arc(svg *s, svg_point centre, float radius, float from, float to, const svg_paint *paint)
{
    svg_point line[FIGURE_STEPS + 1];
    for (int i = 0; i <= FIGURE_STEPS; i++)
        line[i] = on_circle(centre, radius, nkw_lerp(from, to, (float)i / (float)FIGURE_STEPS));
    svg_polyline(s, line, FIGURE_STEPS + 1, paint);
}

void figure_arc_arrow(svg *s, svg_point centre, float radius, float from, float to, const svg_paint *paint)
{
    float head = (2.0f + 3.2f * paint->width) / radius * (to > from ? 1.0f : -1.0f);
    svg_paint tip = *paint;
    tip.dash = NULL;
    figure_arc(s, centre, radius, from, to - head, paint);
    svg_arrow(s, on_circle(centre, radius, to - 1.7f * head), on_circle(centre, radius, to), &tip);
}

nkw_mat4 figure_view(float yaw, float pitch)
{
    nkw_vec3 x = {1.0f, 0.0f, 0.0f}, y = {0.0f, 1.0f, 0.0f};
    return nkw_mat4_from_quat(
        nkw_quat_mul(nkw_quat_from_axis_angle(x, pitch), nkw_quat_from_axis_angle(y, -yaw)));
}
