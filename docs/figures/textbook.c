/* SPDX-License-Identifier: MIT */
/* What docs/textbook.md derives: Hermite's conditions, the half angle, slerp in its plane, normals. */
#include "figure.h"

#include <stdio.h>

#include <nakawari/curve.h>
#include <nakawari/mat.h>
#include <nakawari/scalar.h>

static float radians(float degrees)
{
    return nkw_radians_from_degrees(degrees);
}

static svg_point from_centre(svg_point c, float radius, float degrees)
{
    return svg_at(c.x + radius * nkw_cos(radians(degrees)), c.y - radius * nkw_sin(radians(degrees)));
}

static void ray(svg *s, svg_point c, float radius, float degrees, svg_colour colour, const char *name)
{
    svg_paint paint = svg_stroke(colour, 3.2f, 1.0f);
    svg_arrow(s, c, from_centre(c, radius, degrees), &paint);
    svg_point at = from_centre(c, radius + 18.0f, degrees);
    figure_name(s, at.x, at.y + 5.0f, colour, 'm', name);
}

/* ---- Hermite: one weight for each condition ---- */

enum { WEIGHTS = 4 };

typedef struct condition {
    const char *name, *holds;
    size_t weight; /* in nkw_weights: p0, v0, p1, v1 */
    float value[2]; /* at 0 and 1 */
    float slope[2];
    svg_colour colour;
} condition;

static const condition conditions[WEIGHTS] = {
    {"H0, of p0", "value 1 at t = 0", 0, {1.0f, 0.0f}, {0.0f, 0.0f}, FIGURE_HERMITE},
    {"H1, of p1", "value 1 at t = 1", 2, {0.0f, 1.0f}, {0.0f, 0.0f}, FIGURE_BEZIER},
    {"h0, of v0", "slope 1 at t = 0", 1, {0.0f, 0.0f}, {1.0f, 0.0f}, FIGURE_BSPLINE},
    {"h1, of v1", "slope 1 at t = 1", 3, {0.0f, 0.0f}, {0.0f, 1.0f}, FIGURE_CATMULL_ROM},
};

/* A short tangent at an end, and the point. */
static void end_mark(svg *s, const svg_plot *plot, const condition *c, int end)
{
    const float reach = 0.16f;
    float t = (float)end, y = c->value[end], k = c->slope[end];
    svg_paint tangent = svg_stroke(FIGURE_INK, 2.0f, 1.0f);
    float from = end ? t - reach : t, to = end ? t : t + reach;
    svg_line(s, svg_plot_at(plot, from, y + k * (from - t)), svg_plot_at(plot, to, y + k * (to - t)), &tangent);
    figure_key(s, svg_plot_at(plot, t, y));
}

static void condition_panel(svg *s, float x, const condition *c)
{
    svg_plot plot = {{x, 132.0f, 190.0f, 250.0f}, {0.0f, 1.0f, 0.5f, "t"}, {-0.2f, 1.0f, 0.2f, ""}};
    float y[FIGURE_STEPS + 1];
    svg_paint paint = svg_stroke(c->colour, 3.2f, 1.0f);
    for (int i = 0; i <= FIGURE_STEPS; i++)
        y[i] = nkw_cubic_weights(NKW_CUBIC_HERMITE, 0, (float)i / (float)FIGURE_STEPS).w[c->weight];
    svg_plot_frame(s, &plot);
    figure_graph(s, &plot, y, &paint);
    end_mark(s, &plot, c, 0);
    end_mark(s, &plot, c, 1);
    figure_bold(s, x, 102.0f, 15.0f, c->colour, 's', c->name);
    figure_text(s, x, 122.0f, 13.0f, FIGURE_GREY, 's', c->holds);
}

int figure_textbook_hermite(const char *path)
{
    svg s;
    if (!figure_open(&s, path, 980.0f, 440.0f, "Each Hermite weight meets one condition and is 0 for the other three",
                     "A circle: the value at an end. The dark line through it: the slope there."))
        return 0;
    for (int i = 0; i < WEIGHTS; i++)
        condition_panel(&s, 54.0f + 238.0f * (float)i, &conditions[i]);
    return svg_close(&s);
}

/* ---- the half angle: two reflections ---- */

static void mirror_line(svg *s, svg_point c, float degrees, svg_colour colour, const char *name)
{
    svg_paint paint = svg_stroke(colour, 2.0f, 1.0f);
    paint.dash = "9 5";
    svg_line(s, from_centre(c, -50.0f, degrees), from_centre(c, 176.0f, degrees), &paint);
    svg_point at = from_centre(c, 194.0f, degrees);
    figure_name(s, at.x, at.y + 5.0f, colour, 'm', name);
}

static void two_mirrors(svg *s, svg_point c)
{
    svg_paint turn = svg_stroke(FIGURE_SLERP, 3.0f, 1.0f), half = svg_stroke(FIGURE_EULER, 3.0f, 1.0f);
    mirror_line(s, c, 40.0f, FIGURE_EULER, "mirror a");
    mirror_line(s, c, 80.0f, FIGURE_EULER, "mirror b");
    ray(s, c, 140.0f, 15.0f, FIGURE_INK, "v");
    ray(s, c, 140.0f, 65.0f, FIGURE_PALE, "v'");
    ray(s, c, 140.0f, 95.0f, FIGURE_SLERP, "v''");
    figure_arc_arrow(s, c, 84.0f, radians(15.0f), radians(95.0f), &turn);
    figure_arc_arrow(s, c, 50.0f, radians(40.0f), radians(80.0f), &half);
    svg_point at = from_centre(c, 108.0f, 50.0f), by = from_centre(c, 34.0f, 60.0f);
    figure_name(s, at.x, at.y, FIGURE_SLERP, 'm', "80\302\260");
    figure_name(s, by.x, by.y + 4.0f, FIGURE_EULER, 'm', "40\302\260");
}

/* The two factors of q v q*: each turns by half, seen along the axis. */
static void two_factors(svg *s, svg_point c)
{
    svg_paint first = svg_stroke(FIGURE_EULER, 3.0f, 1.0f), second = svg_stroke(FIGURE_BEZIER, 3.0f, 1.0f);
    ray(s, c, 140.0f, 15.0f, FIGURE_INK, "v");
    ray(s, c, 140.0f, 55.0f, FIGURE_EULER, "q v");
    ray(s, c, 140.0f, 95.0f, FIGURE_BEZIER, "q v q*");
    figure_arc_arrow(s, c, 84.0f, radians(15.0f), radians(55.0f), &first);
    figure_arc_arrow(s, c, 84.0f, radians(55.0f), radians(95.0f), &second);
    svg_point at = from_centre(c, 106.0f, 35.0f), by = from_centre(c, 106.0f, 75.0f);
    figure_name(s, at.x, at.y + 5.0f, FIGURE_EULER, 'm', "40\302\260");
    figure_name(s, by.x, by.y + 5.0f, FIGURE_BEZIER, 'm', "40\302\260");
}

int figure_textbook_half(const char *path)
{
    svg s;
    if (!figure_open(
            &s, path, 980.0f, 400.0f, "A quaternion holds half the angle, because it is applied twice",
            "A turn of 80\302\260, seen along its axis: v is at a right angle to the axis, which points to you."))
        return 0;
    figure_bold(&s, 40.0f, 98.0f, 15.0f, FIGURE_INK, 's', "Two mirrors at 40\302\260 turn by 80\302\260");
    figure_bold(&s, 540.0f, 98.0f, 15.0f, FIGURE_INK, 's',
                "q = cos 40\302\260 + sin 40\302\260 k turns by 40\302\260 on each side");
    two_mirrors(&s, svg_at(200.0f, 340.0f));
    two_factors(&s, svg_at(690.0f, 340.0f));
    return svg_close(&s);
}

/* ---- slerp in the plane of its ends ---- */

int figure_textbook_slerp(const char *path)
{
    svg s;
    const float theta = 76.0f, t = 0.35f, r = 300.0f;
    svg_point c = svg_at(150.0f, 440.0f);
    if (!figure_open(
            &s, path, 980.0f, 480.0f, "Slerp: the law of sines in the plane of q0 and q1",
            "q is the sum of a multiple of q0 and a multiple of q1. The grey triangle has the angles t \316\270, "
            "180\302\260 - \316\270 and (1 - t) \316\270."))
        return 0;
    float sine = nkw_sin(radians(theta)), k0 = nkw_sin(radians((1.0f - t) * theta)) / sine;
    svg_point q = from_centre(c, r, t * theta);
    svg_point corner = from_centre(c, k0 * r, 0.0f), triangle[3] = {c, corner, q};
    svg_paint rim = svg_stroke(FIGURE_PALE, 1.6f, 1.0f), fill = svg_fill(0xececf0, 1.0f);
    svg_paint first = svg_stroke(FIGURE_HERMITE, 5.0f, 1.0f), second = svg_stroke(FIGURE_CATMULL_ROM, 5.0f, 1.0f);
    svg_paint arc = svg_stroke(FIGURE_SLERP, 3.0f, 1.0f), angle = svg_stroke(FIGURE_GREY, 1.6f, 1.0f);
    svg_polygon(&s, triangle, 3, &fill);
    figure_arc(&s, c, r, 0.0f, radians(theta), &rim);
    figure_arc(&s, c, r, 0.0f, radians(t * theta), &arc);
    ray(&s, c, r, 0.0f, FIGURE_INK, "q0");
    ray(&s, c, r, theta, FIGURE_INK, "q1");
    svg_line(&s, c, corner, &first);
    svg_line(&s, corner, q, &second);
    svg_line(&s, c, q, &arc);
    figure_arc(&s, c, 70.0f, 0.0f, radians(t * theta), &angle);
    figure_arc(&s, c, 110.0f, radians(t * theta), radians(theta), &angle);
    svg_point a = from_centre(c, 92.0f, 0.5f * t * theta), b = from_centre(c, 140.0f, 0.5f * (1.0f + t) * theta);
    figure_name(&s, a.x, a.y + 5.0f, FIGURE_GREY, 'm', "t \316\270");
    figure_name(&s, b.x, b.y + 5.0f, FIGURE_GREY, 'm', "(1 - t) \316\270");
    figure_name(&s, 0.5f * (c.x + corner.x), c.y + 22.0f, FIGURE_HERMITE, 'm', "k0 q0");
    figure_name(&s, corner.x - 10.0f, 0.5f * (corner.y + q.y) + 30.0f, FIGURE_CATMULL_ROM, 'e', "k1 q1");
    figure_name(&s, q.x + 10.0f, q.y - 8.0f, FIGURE_SLERP, 's', "q");
    figure_bold(&s, 490.0f, 150.0f, 15.0f, FIGURE_INK, 's',
                "In a triangle, sides are as the sines of opposite angles:");
    figure_text(&s, 490.0f, 190.0f, 15.0f, FIGURE_HERMITE, 's',
                "k0 / sin((1 - t) \316\270)  =  1 / sin(180\302\260 - \316\270)");
    figure_text(&s, 490.0f, 220.0f, 15.0f, FIGURE_CATMULL_ROM, 's',
                "k1 / sin(t \316\270)  =  1 / sin(180\302\260 - \316\270)");
    figure_text(&s, 490.0f, 260.0f, 15.0f, FIGURE_INK, 's',
                "and sin(180\302\260 - \316\270) = sin \316\270, which is (17).");
    return svg_close(&s);
}

/* ---- normals under a scale ---- */

typedef struct surface {
    svg_point centre;
    float scale_x;
} surface;

static svg_point on_surface(const surface *f, float degrees, float radius)
{
    svg_point p = from_centre(svg_at(0.0f, 0.0f), radius, degrees);
    return svg_at(f->centre.x + f->scale_x * p.x, f->centre.y + p.y);
}

static void surface_line(svg *s, const surface *f)
{
    svg_point line[FIGURE_STEPS + 1];
    svg_paint paint = svg_stroke(FIGURE_INK, 2.4f, 1.0f);
    for (int i = 0; i <= FIGURE_STEPS; i++)
        line[i] = on_surface(f, 180.0f * (float)i / (float)FIGURE_STEPS, 100.0f);
    svg_polyline(s, line, FIGURE_STEPS + 1, &paint);
}

/* A tangent and a direction from a point of the surface; the direction has length 70 on the page. */
static void surface_arrow(svg *s, svg_point p, float x, float y, svg_colour colour)
{
    svg_paint paint = svg_stroke(colour, 3.2f, 1.0f);
    float length = nkw_sqrt(x * x + y * y);
    svg_arrow(s, p, svg_at(p.x + 70.0f * x / length, p.y - 70.0f * y / length), &paint);
}

static void surface_panel(svg *s, surface f, int wrong)
{
    surface_line(s, &f);
    for (int i = 1; i <= 5; i++) {
        float degrees = 30.0f * (float)i, x = nkw_cos(radians(degrees)), y = nkw_sin(radians(degrees));
        svg_point p = on_surface(&f, degrees, 100.0f);
        svg_paint tangent = svg_stroke(FIGURE_PALE, 2.0f, 1.0f);
        float tx = -y * f.scale_x, ty = x, length = nkw_sqrt(tx * tx + ty * ty);
        svg_line(s, svg_at(p.x - 24.0f * tx / length, p.y + 24.0f * ty / length),
                 svg_at(p.x + 24.0f * tx / length, p.y - 24.0f * ty / length), &tangent);
        if (wrong)
            surface_arrow(s, p, x * f.scale_x, y, FIGURE_EULER);
        surface_arrow(s, p, x / f.scale_x, y, FIGURE_SLERP);
    }
}

int figure_textbook_normal(const char *path)
{
    svg s;
    svg_paint right = svg_stroke(FIGURE_SLERP, 3.2f, 1.0f), wrong = svg_stroke(FIGURE_EULER, 3.2f, 1.0f);
    svg_paint tangent = svg_stroke(FIGURE_PALE, 2.0f, 1.0f);
    surface before = {{190.0f, 320.0f}, 1.0f}, after = {{640.0f, 320.0f}, 2.4f};
    if (!figure_open(
            &s, path, 980.0f, 410.0f, "Normals: M tilts them towards the stretch, the inverse transpose does not",
            "Grey: tangents of the surface, which M carries to tangents. The normal stays at a right angle to them."))
        return 0;
    figure_bold(&s, 90.0f, 110.0f, 15.0f, FIGURE_INK, 's', "before: a half circle");
    figure_bold(&s, 420.0f, 110.0f, 15.0f, FIGURE_INK, 's', "after M: 2.4 times as wide");
    surface_panel(&s, before, 0);
    surface_panel(&s, after, 1);
    figure_legend(&s, 90.0f, 388.0f, &tangent, "tangent");
    figure_legend(&s, 250.0f, 388.0f, &right, "normal: (M\342\201\273\302\271)\341\265\200 n");
    figure_legend(&s, 480.0f, 388.0f, &wrong, "M n: not at a right angle to the surface");
    return svg_close(&s);
}
