/* SPDX-License-Identifier: MIT */
/* Pictures of arrays: key times and their segments, the elements of a matrix in memory. */
#include "figure.h"

#include <stdio.h>

#include <nakawari/mat.h>
#include <nakawari/scalar.h>
#include <nakawari/segment.h>

/* ---- segment lookup ---- */

static const svg_colour segment_colours[4] = {0x1f5fd0, 0xe07b00, 0x2c8c4a, 0xb0308f};

typedef struct timeline {
    const char *name;
    float times[5];
    size_t count;
    float x, width; /* of the plot on the page */
    const char *said[2];
} timeline;

static const timeline timelines[2] = {
    {"times = {0, 1, 2.5, 3}", {0.0f, 1.0f, 2.5f, 3.0f, 0.0f}, 4, 60.0f, 440.0f,
     {"The time of a key is in the segment after it (full dot);", "only the last segment contains its end too."}},
    {"times = {0, 1, 1, 2, 2}", {0.0f, 1.0f, 1.0f, 2.0f, 2.0f}, 5, 568.0f, 370.0f,
     {"No time is in segment 1, from 1 to 1.",
      "Segment 3, from 2 to 2, is the last: from 2 on index = 3, t = 1."}},
};

static svg_plot timeline_plot(const timeline *l)
{
    float end = l->times[l->count - 1] + 0.75f;
    svg_plot plot = {{l->x, 138.0f, l->width, 190.0f}, {-0.75f, end, 0.5f, "time, s"}, {0.0f, 1.0f, 0.5f, "t"}};
    plot.y.from = -0.15f;
    plot.y.to = 1.15f;
    return plot;
}

/* The rise of t over the segment that holds `time`, from a to b. */
static void rise(svg *s, const svg_plot *plot, const timeline *l, float a, float b)
{
    nkw_segment first = nkw_segment_find(l->times, l->count, a);
    svg_paint paint = svg_stroke(segment_colours[first.index], 3.0f, 1.0f);
    float end = l->times[first.index + 1] <= a ? first.t : 1.0f;
    svg_line(s, svg_plot_at(plot, a, first.t), svg_plot_at(plot, b, a < l->times[0] ? first.t : end), &paint);
}

static void ring(svg *s, svg_point at, svg_colour colour, int full)
{
    svg_paint paint = {full ? colour : 0xffffff, colour, 2.2f, 1.0f, NULL};
    svg_circle(s, at, 4.6f, &paint);
}

/* A full dot at every key, where find says its own time lies; a hollow one at the end that a segment does not own. */
static void ends(svg *s, const svg_plot *plot, const timeline *l)
{
    for (size_t k = 0; k < l->count; k++) {
        nkw_segment at = nkw_segment_find(l->times, l->count, l->times[k]);
        if (k > 0 && k + 1 < l->count && l->times[k] > l->times[k - 1])
            ring(s, svg_plot_at(plot, l->times[k], 1.0f), segment_colours[k - 1], 0);
        ring(s, svg_plot_at(plot, l->times[k], at.t), segment_colours[at.index], 1);
    }
}

static void graph_of_t(svg *s, const timeline *l)
{
    svg_plot plot = timeline_plot(l);
    svg_plot_frame(s, &plot);
    rise(s, &plot, l, plot.x.from, l->times[0]);
    for (size_t k = 0; k + 1 < l->count; k++) {
        if (l->times[k] < l->times[k + 1])
            rise(s, &plot, l, l->times[k], l->times[k + 1]);
    }
    rise(s, &plot, l, l->times[l->count - 1], plot.x.to);
    ends(s, &plot, l);
}

/* One row per segment: [from, to) or [from, to]; an empty one is a mark. */
static void segment_row(svg *s, const svg_plot *plot, const timeline *l, size_t k)
{
    char text[64], a[SVG_DIGITS], b[SVG_DIGITS];
    int last = k + 2 == l->count, empty = !(l->times[k] < l->times[k + 1]);
    float y = 416.0f + 28.0f * (float)k, x0 = svg_plot_at(plot, l->times[k], 0.0f).x;
    float x1 = svg_plot_at(plot, l->times[k + 1], 0.0f).x;
    svg_paint bar = svg_stroke(segment_colours[k], 4.0f, 0.55f);
    svg_line(s, svg_at(x0, y), svg_at(x1, y), &bar);
    if (!empty || last)
        ring(s, svg_at(x0, y), segment_colours[k], 1);
    if (!empty || !last)
        ring(s, svg_at(x1, y), segment_colours[k], last);
    sprintf(text, "%u: [%.8s, %.8s%s%s", (unsigned)k, svg_number(a, l->times[k], 2),
            svg_number(b, l->times[k + 1], 2), last ? "]" : ")", empty && !last ? " empty" : "");
    figure_name(s, x1 + 14.0f, y + 5.0f, segment_colours[k], 's', text);
}

static void timeline_panel(svg *s, const timeline *l)
{
    svg_plot plot = timeline_plot(l);
    figure_bold(s, l->x, 102.0f, 15.0f, FIGURE_INK, 's', l->name);
    graph_of_t(s, l);
    figure_bold(s, l->x, 390.0f, 13.0f, FIGURE_INK, 's', "segments");
    for (size_t k = 0; k + 1 < l->count; k++)
        segment_row(s, &plot, l, k);
    figure_text(s, l->x, 544.0f, 13.0f, 0x2b2b30, 's', l->said[0]);
    figure_text(s, l->x, 562.0f, 13.0f, 0x2b2b30, 's', l->said[1]);
}

int figure_segment_lookup(const char *path)
{
    svg s;
    if (!figure_open(&s, path, 1020.0f, 584.0f, "A time is in exactly one segment",
                     "t over time by nkw_segment_find, one colour for each segment. Outside the keys, index and t are "
                     "clamped."))
        return 0;
    for (int i = 0; i < 2; i++)
        timeline_panel(&s, &timelines[i]);
    return svg_close(&s);
}

/* ---- the memory of a matrix ---- */

static const svg_colour column_colours[4] = {0xd62728, 0x2ca02c, 0x1f5fd0, 0x6a4a9c};
static const float cell = 56.0f;

static void matrix_cell(svg *s, svg_point at, svg_colour colour, const char *text, const char *index)
{
    svg_box box = {at.x, at.y, cell - 4.0f, cell - 4.0f};
    svg_paint paint = {svg_mix(0xffffff, colour, 0.16f), colour, 1.4f, 1.0f, NULL};
    svg_rect(s, box, 5.0f, &paint);
    figure_bold(s, at.x + 26.0f, at.y + 24.0f, 15.0f, FIGURE_INK, 'm', text);
    figure_text(s, at.x + 26.0f, at.y + 42.0f, 11.0f, FIGURE_GREY, 'm', index);
}

static const char *element(int row, int column)
{
    static const char *const names[4][4] = {
        {"Xx", "Yx", "Zx", "Tx"}, {"Xy", "Yy", "Zy", "Ty"}, {"Xz", "Yz", "Zz", "Tz"}, {"0", "0", "0", "1"}};
    return names[row][column];
}

static void written_matrix(svg *s, svg_point at)
{
    static const char *const heads[4] = {"x axis", "y axis", "z axis", "translation"};
    for (int c = 0; c < 4; c++) {
        for (int r = 0; r < 4; r++) {
            char index[16];
            sprintf(index, "m[%d]", (c * 4 + r) % 16);
            matrix_cell(s, svg_at(at.x + cell * (float)c * 1.25f, at.y + cell * (float)r), column_colours[c],
                        element(r, c), index);
        }
        figure_bold(s, at.x + 26.0f + cell * (float)c * 1.25f, at.y - 12.0f, 12.0f, column_colours[c], 'm', heads[c]);
    }
}

static void memory_strip(svg *s, svg_point at)
{
    for (int i = 0; i < 16; i++) {
        char index[16];
        sprintf(index, "m[%d]", i);
        matrix_cell(s, svg_at(at.x + cell * (float)i, at.y), column_colours[i / 4], element(i % 4, i / 4), index);
    }
}

static void layout_table(svg *s, svg_point at)
{
    static const char *const rows[4][3] = {
        {"columns of column vectors", "OpenGL, glTF, GLM", "unchanged"},
        {"rows of row vectors", "D3DX, DirectXMath, XNA", "the same bytes"},
        {"rows of column vectors", "vecmath, NumPy", "transposed"},
        {"columns of row vectors", "(rare)", "transposed"}};
    svg_paint rule = svg_stroke(0xd5d5da, 1.0f, 1.0f);
    figure_bold(s, at.x, at.y, 14.0f, FIGURE_INK, 's', "The four conventions");
    for (int i = 0; i < 4; i++) {
        float y = at.y + 40.0f + 50.0f * (float)i;
        svg_line(s, svg_at(at.x, y - 24.0f), svg_at(at.x + 510.0f, y - 24.0f), &rule);
        figure_text(s, at.x, y, 13.0f, FIGURE_INK, 's', rows[i][0]);
        figure_text(s, at.x + 206.0f, y, 13.0f, FIGURE_GREY, 's', rows[i][1]);
        figure_bold(s, at.x + 510.0f, y, 13.0f, i < 2 ? 0x2c8c4a : 0xd55e00, 'e', rows[i][2]);
    }
}

int figure_mat_layout(const char *path)
{
    svg s;
    if (!figure_open(&s, path, 944.0f, 504.0f, "A matrix is stored column by column",
                     "Element (row r, column c) is m[c * 4 + r]. v' = M v; the columns are the images of the axes, the "
                     "last one is the translation."))
        return 0;
    written_matrix(&s, svg_at(24.0f, 116.0f));
    layout_table(&s, svg_at(400.0f, 112.0f));
    figure_bold(&s, 24.0f, 392.0f, 14.0f, FIGURE_INK, 's', "In memory, 64 bytes, the lowest address first");
    memory_strip(&s, svg_at(24.0f, 408.0f));
    return svg_close(&s);
}
