/* SPDX-License-Identifier: MIT */
/* The kinds of cubic: their weights, and one segment of each over the same points. */
#include "figure.h"

#include <nakawari/curve.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

typedef struct kind {
    const char *name;
    const char *controls[4];
    svg_colour colour;
    nkw_cubic_kind kind;
    float low[3], high[3]; /* of the plots: value, velocity, acceleration */
} kind;

static const kind kinds[4] = {
    {"Hermite", {"p0", "v0", "p1", "v1"}, FIGURE_HERMITE, NKW_CUBIC_HERMITE, {-0.4f, -2.0f, -7.0f}, {1.1f, 2.0f, 7.0f}},
    {"B\303\251zier",
     {"p0", "p1", "p2", "p3"},
     FIGURE_BEZIER,
     NKW_CUBIC_BEZIER,
     {-0.4f, -3.2f, -13.0f},
     {1.1f, 3.2f, 7.0f}},
    {"B-spline",
     {"p0", "p1", "p2", "p3"},
     FIGURE_BSPLINE,
     NKW_CUBIC_BSPLINE,
     {-0.4f, -2.0f, -7.0f},
     {1.1f, 2.0f, 7.0f}},
    {"Catmull-Rom",
     {"p0", "p1", "p2", "p3"},
     FIGURE_CATMULL_ROM,
     NKW_CUBIC_CATMULL_ROM,
     {-0.4f, -2.0f, -7.0f},
     {1.1f, 2.0f, 7.0f}},
};

static const svg_colour weight_colours[4] = {0x1f5fd0, 0xe07b00, 0x2c8c4a, 0xb0308f};

/* ---- the weights ---- */

static void weights_plot(svg *s, const kind *k, int row, svg_box box)
{
    static const float ticks[3] = {0.5f, 1.0f, 3.0f};
    svg_plot plot = {box, {0.0f, 1.0f, 0.5f, ""}, {k->low[row], k->high[row], ticks[row], ""}};
    svg_paint axis = svg_stroke(FIGURE_PALE, 1.0f, 1.0f);
    svg_plot_frame(s, &plot);
    svg_line(s, svg_plot_at(&plot, 0.0f, 0.0f), svg_plot_at(&plot, 1.0f, 0.0f), &axis);
    for (int i = 0; i < 4; i++) {
        float y[FIGURE_STEPS + 1];
        svg_paint paint = svg_stroke(weight_colours[i], 2.4f, 1.0f);
        for (int j = 0; j <= FIGURE_STEPS; j++)
            y[j] = nkw_cubic_weights(k->kind, row, (float)j / (float)FIGURE_STEPS).w[i];
        figure_graph(s, &plot, y, &paint);
    }
}

static void weights_heading(svg *s, const kind *k, float x)
{
    figure_bold(s, x, 100.0f, 16.0f, k->colour, 's', k->name);
    for (int i = 0; i < 4; i++) {
        svg_paint paint = svg_stroke(weight_colours[i], 3.0f, 1.0f);
        float at = x + 54.0f * (float)i;
        svg_line(s, svg_at(at, 120.0f), svg_at(at + 18.0f, 120.0f), &paint);
        figure_bold(s, at + 23.0f, 124.0f, 13.0f, weight_colours[i], 's', k->controls[i]);
    }
}

int figure_curve_bases(const char *path)
{
    static const char *const rows[3][2] = {
        {"weight", "of each control value"}, {"velocity", "d/dt"}, {"acceleration", "d\302\262/dt\302\262"}};
    svg s;
    if (!figure_open(&s, path, 1100.0f, 712.0f, "Four kinds of curve are four sets of weights",
                     "p(t) = w0 c0 + w1 c1 + w2 c2 + w3 c3. Each line is the weight of one control value over t; the "
                     "rows below are its derivatives."))
        return 0;
    for (int row = 0; row < 3; row++) {
        float y = 148.0f + 184.0f * (float)row;
        figure_bold(&s, 24.0f, y + 72.0f, 13.0f, FIGURE_INK, 's', rows[row][0]);
        figure_text(&s, 24.0f, y + 90.0f, 11.0f, FIGURE_GREY, 's', rows[row][1]);
        for (int k = 0; k < 4; k++) {
            svg_box box = {184.0f + 232.0f * (float)k, y, 190.0f, 150.0f};
            weights_plot(&s, &kinds[k], row, box);
        }
    }
    for (int k = 0; k < 4; k++)
        weights_heading(&s, &kinds[k], 184.0f + 232.0f * (float)k);
    figure_text(&s, 570.0f, 698.0f, 12.0f, FIGURE_GREY, 'm', "t");
    return svg_close(&s);
}

/* ---- the same four points ---- */

static const nkw_vec3 points[4] = {{0.0f, 0.0f, 0.0f}, {1.0f, 2.3f, 0.0f}, {3.1f, 2.6f, 0.0f}, {4.2f, 0.5f, 0.0f}};

/* The control values of kind k: Hermite takes the outer points and the way from and to them. */
static void controls_of(int k, nkw_vec3 c[4])
{
    for (int i = 0; i < 4; i++)
        c[i] = points[i];
    if (k == 0) {
        c[1] = nkw_vec3_sub(points[1], points[0]);
        c[2] = points[3];
        c[3] = nkw_vec3_sub(points[3], points[2]);
    }
}

static nkw_vec3 curve_at(int k, float t)
{
    nkw_vec3 c[4];
    controls_of(k, c);
    switch (k) {
    case 0:
        return nkw_vec3_hermite(c[0], c[1], c[2], c[3], t);
    case 1:
        return nkw_vec3_bezier(c[0], c[1], c[2], c[3], t);
    case 2:
        return nkw_vec3_bspline(c[0], c[1], c[2], c[3], t);
    default:
        return nkw_vec3_catmull_rom(c[0], c[1], c[2], c[3], t);
    }
}

static svg_point on_panel(svg_box box, nkw_vec3 p)
{
    return svg_at(box.x + 60.0f + 92.0f * p.x, box.y + box.height - 46.0f - 78.0f * p.y);
}

static void polygon(svg *s, svg_box box)
{
    svg_point line[4];
    svg_paint paint = svg_stroke(FIGURE_PALE, 1.2f, 1.0f);
    paint.dash = "4 4";
    for (int i = 0; i < 4; i++)
        line[i] = on_panel(box, points[i]);
    svg_polyline(s, line, 4, &paint);
}

/* The tangents at the two ends of the curve, a third as long: away from the start, into the end. */
static void tangents(svg *s, svg_box box, int k)
{
    nkw_vec3 c[4];
    svg_paint paint = svg_stroke(FIGURE_INK, 1.6f, 1.0f);
    controls_of(k, c);
    for (int end = 0; end < 2; end++) {
        float t = (float)end;
        nkw_weights w = nkw_cubic_weights(kinds[k].kind, 1, t);
        const nkw_vec3_cubic cubic = {{c[0], c[1], c[2], c[3]}};
        nkw_vec3 v = nkw_vec3_cubic_sum(&cubic, w);
        nkw_vec3 p = curve_at(k, t), from = nkw_vec3_add_scaled(p, v, -t / 3.0f);
        svg_arrow(s, on_panel(box, from), on_panel(box, nkw_vec3_add_scaled(from, v, 1.0f / 3.0f)), &paint);
    }
}

static void point_names(svg *s, svg_box box)
{
    static const char *const names[4] = {"P0", "P1", "P2", "P3"};
    static const float dx[4] = {-20.0f, -16.0f, 18.0f, 22.0f}, dy[4] = {18.0f, -8.0f, -8.0f, 16.0f};
    for (int i = 0; i < 4; i++) {
        svg_point p = on_panel(box, points[i]);
        figure_key(s, p);
        figure_name(s, p.x + dx[i], p.y + dy[i], FIGURE_INK, 'm', names[i]);
    }
}

static void curve_panel(svg *s, svg_box box, int k, const char *rule)
{
    svg_point line[FIGURE_STEPS + 1];
    svg_paint border = svg_stroke(0xd5d5da, 1.0f, 1.0f), paint = svg_stroke(kinds[k].colour, 3.4f, 1.0f);
    svg_rect(s, box, 6.0f, &border);
    polygon(s, box);
    for (int i = 0; i <= FIGURE_STEPS; i++)
        line[i] = on_panel(box, curve_at(k, (float)i / (float)FIGURE_STEPS));
    svg_polyline(s, line, FIGURE_STEPS + 1, &paint);
    point_names(s, box);
    tangents(s, box, k);
    for (int i = 0; i <= FIGURE_STEPS; i += FIGURE_STEPS / 8)
        figure_dot(s, line[i], kinds[k].colour);
    figure_bold(s, box.x + 16.0f, box.y + 28.0f, 16.0f, kinds[k].colour, 's', kinds[k].name);
    figure_text(s, box.x + box.width - 16.0f, box.y + 28.0f, 13.0f, 0x2b2b30, 'e', rule);
}

int figure_curve_four(const char *path)
{
    static const char *const rules[4] = {
        "P0 to P3, tangents v0 = P1 - P0, v1 = P3 - P2", "P0 to P3, leaving towards P1, arriving from P2",
        "near P1 to near P2: through no point", "P1 to P2, tangents (P2 - P0)/2, (P3 - P1)/2"};
    svg s;
    if (!figure_open(&s, path, 1064.0f, 740.0f, "The same four points, four meanings",
                     "One segment each, a dot every 1/8 of t. Arrows: a third of the tangents, away from the start and "
                     "into the end."))
        return 0;
    for (int k = 0; k < 4; k++) {
        svg_box box = {24.0f + 512.0f * (float)(k % 2), 80.0f + 326.0f * (float)(k / 2), 504.0f, 316.0f};
        curve_panel(&s, box, k, rules[k]);
    }
    return svg_close(&s);
}
