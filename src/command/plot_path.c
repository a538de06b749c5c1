/* SPDX-License-Identifier: MIT */
/* nakawari plot --what path: the paths of joints in the space of the model. */
#include "plot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

/* Points of a path; the joints that are drawn without --joint; the most that are drawn. */
enum { POINTS = 241, LONGEST = 5, JOINTS = 16 };

typedef struct paths {
    size_t joints[JOINTS], count;
    nkw_vec3 (*points)[POINTS];
    float start, end;
} paths;

static float time_of(const paths *all, size_t i)
{
    return all->start + (all->end - all->start) * ((float)i / (float)(POINTS - 1));
}

/* ---- which joints ---- */

/* The lengths of the paths of all joints; NULL without memory. */
static float *lengths_of(const paths *all, moment *m)
{
    const size_t joints = m->document->skeleton.joint_count;
    nkw_vec3 *before = (nkw_vec3 *)calloc(joints, sizeof *before);
    float *lengths = (float *)calloc(joints, sizeof *lengths);
    for (size_t i = 0; before && lengths && i < POINTS; i++) {
        moment_at(m, time_of(all, i));
        for (size_t j = 0; j < joints; j++) {
            nkw_vec3 p = nkw_mat4_translation(&m->models[j]);
            if (i)
                lengths[j] += nkw_vec3_length(nkw_vec3_sub(p, before[j]));
            before[j] = p;
        }
    }
    free(before);
    return lengths;
}

/* Adds the joint with the longest path that is left; equal ones in the order of joints. */
static int add_longest(paths *all, float *lengths, size_t joints)
{
    size_t best = 0;
    for (size_t j = 1; j < joints; j++)
        best = lengths[j] > lengths[best] ? j : best;
    if (!(lengths[best] > 0.0f))
        return 0;
    lengths[best] = -1.0f;
    all->joints[all->count++] = best;
    return 1;
}

static int choose(paths *all, const plot_request *r, moment *m)
{
    const nkw_document *d = m->document;
    const size_t joints = d->skeleton.joint_count, most = (size_t)r->most < JOINTS ? (size_t)r->most : JOINTS;
    for (size_t n = 0; r->joints && n < joints && all->count < most; n++) {
        size_t j = (size_t)d->joint_of_node[n];
        if (plot_names(r, d, j))
            all->joints[all->count++] = j;
    }
    if (r->joints)
        return 1;
    float *lengths = lengths_of(all, m);
    while (lengths && all->count < most && all->count < LONGEST && add_longest(all, lengths, joints))
        continue;
    free(lengths);
    return lengths != NULL;
}

static int sample_all(paths *all, moment *m)
{
    all->points = calloc(all->count + 1, sizeof *all->points);
    for (size_t i = 0; all->points && i < POINTS; i++) {
        moment_at(m, time_of(all, i));
        for (size_t k = 0; k < all->count; k++)
            all->points[k][i] = nkw_mat4_translation(&m->models[all->joints[k]]);
    }
    return all->points != NULL;
}

/* ---- panels ---- */

typedef struct side {
    const char *name;
    float yaw, pitch; /* radians, of the camera */
    const char *across; /* what is to the right and up; NULL: no numbers */
    int mirrored, reversed; /* the world's coordinate falls to the right, and up */
} side;

static const side sides[4] = {
    {"from above: x to the right, z down", 0.0f, 1.57079633f, "xz", 0, 1},
    {"from the camera: 35 degrees to the left, 12 up", 0.61086524f, 0.20943951f, NULL, 0, 0},
    {"from the front: x to the right, y up", 0.0f, 0.0f, "xy", 0, 0},
    {"from the left: z to the left, y up", 1.57079633f, 0.0f, "zy", 1, 0},
};

enum { PANEL = 440, GAP = 70, LEGEND = 210 };

svg_point plot_path_size(void)
{
    svg_point size = {60.0f + 2.0f * PANEL + GAP + 24.0f + LEGEND, PLOT_TOP + 2.0f * (PANEL + GAP)};
    return size;
}

static nkw_mat4 eye_of(const side *s)
{
    const nkw_vec3 x = {1.0f, 0.0f, 0.0f}, y = {0.0f, 1.0f, 0.0f};
    return nkw_mat4_from_quat(
        nkw_quat_mul(nkw_quat_from_axis_angle(x, s->pitch), nkw_quat_from_axis_angle(y, -s->yaw)));
}

/* The range of all points in the space of the eye, as wide as high. */
static svg_plot plot_of(const paths *all, const nkw_mat4 *eye, svg_box box)
{
    nkw_vec3 low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};
    for (size_t k = 0; k < all->count; k++)
        for (size_t i = 0; i < POINTS; i++) {
            nkw_vec3 p = nkw_mat4_transform_point(eye, all->points[k][i]);
            if (!isfinite(p.x) || !isfinite(p.y))
                continue;
            low.x = nkw_min(low.x, p.x), low.y = nkw_min(low.y, p.y);
            high.x = nkw_max(high.x, p.x), high.y = nkw_max(high.y, p.y);
        }
    if (!(low.x <= high.x))
        low = high = NKW_VEC3_ZERO;
    float width = nkw_max(nkw_max(high.x - low.x, high.y - low.y), 1e-6f), half = 0.56f * width;
    float x = 0.5f * (low.x + high.x), y = 0.5f * (low.y + high.y);
    svg_plot plot = {box, {x - half, x + half, chart_tick(width), ""}, {y - half, y + half, chart_tick(width), ""}};
    return plot;
}

/* A path, with a ring at its start, a disc at its end and dots between at equal distances of time. */
static void put_path(page *p, const svg_plot *plot, const nkw_mat4 *eye, const nkw_vec3 *points, svg_colour colour,
                     size_t every)
{
    svg_point line[POINTS];
    svg_paint stroke = svg_stroke(colour, 1.8f, 0.9f), dot = svg_fill(colour, 1.0f);
    svg_paint ring = {0xffffff, colour, 1.8f, 1.0f, NULL};
    size_t count = 0;
    for (size_t i = 0; i < POINTS; i++) {
        nkw_vec3 at = nkw_mat4_transform_point(eye, points[i]);
        if (!isfinite(at.x) || !isfinite(at.y))
            return;
        line[count++] = svg_plot_at(plot, at.x, at.y);
    }
    page_polyline(p, line, count, &stroke);
    for (size_t i = every; i + 1 < count; i += every)
        page_circle(p, line[i], 2.3f, &dot);
    page_circle(p, line[count - 1], 4.2f, &dot);
    page_circle(p, line[0], 4.2f, &ring);
}

/* The numbers of an axis whose world coordinate falls along it. */
static void reverse(svg_axis *axis)
{
    axis->from = -axis->from;
    axis->to = -axis->to;
}

static void put_side(page *p, const paths *all, const side *s, svg_box box, size_t every)
{
    nkw_mat4 eye = eye_of(s);
    svg_plot plot = plot_of(all, &eye, box), frame = plot;
    svg_paint border = svg_stroke(0x9a9aa2, 1.0f, 1.0f);
    if (s->mirrored)
        reverse(&frame.x);
    if (s->reversed)
        reverse(&frame.y);
    frame.y.name = s->name;
    if (s->across)
        chart_frame(p, &frame);
    else {
        page_rect(p, box, &border);
        chart_label(p, svg_at(box.x, box.y - 7.0f), 's', s->name, 12.0f, 0x2b2b30);
    }
    for (size_t k = all->count; k-- > 0;)
        put_path(p, &plot, &eye, all->points[k], chart_colours[k % CHART_COLOURS], every);
}

static void put_legend(page *p, const paths *all, const nkw_document *d, float x, float step)
{
    char words[96];
    svg_paint ring = {0xffffff, 0x55555c, 1.8f, 1.0f, NULL}, disc = svg_fill(0x55555c, 1.0f);
    float y = PLOT_TOP + 34.0f;
    for (size_t k = 0; k < all->count; k++, y += 22.0f) {
        svg_paint paint = svg_stroke(chart_colours[k % CHART_COLOURS], 2.6f, 1.0f);
        snprintf(words, sizeof words, "%.24s", d->nodes[all->joints[k]].name);
        chart_key(p, svg_at(x, y), &paint, words);
    }
    page_circle(p, svg_at(x + 9.0f, y + 10.0f), 4.2f, &ring);
    snprintf(words, sizeof words, "start, %.4g s", (double)all->start);
    chart_label(p, svg_at(x + 24.0f, y + 14.0f), 's', words, 12.0f, 0x55555c);
    page_circle(p, svg_at(x + 9.0f, y + 32.0f), 4.2f, &disc);
    snprintf(words, sizeof words, "end, %.4g s", (double)all->end);
    chart_label(p, svg_at(x + 24.0f, y + 36.0f), 's', words, 12.0f, 0x55555c);
    page_circle(p, svg_at(x + 9.0f, y + 54.0f), 2.3f, &disc);
    snprintf(words, sizeof words, "every %.3g s", (double)step);
    chart_label(p, svg_at(x + 24.0f, y + 58.0f), 's', words, 12.0f, 0x55555c);
}

int plot_path(page *p, const plot_request *r, moment *m)
{
    enum { EVERY = (POINTS - 1) / 30 };
    paths all;
    memset(&all, 0, sizeof all);
    all.start = nkw_clip_describe(m->clip).start;
    all.end = nkw_clip_describe(m->clip).end;
    int fine = choose(&all, r, m) && sample_all(&all, m);
    for (int i = 0; fine && i < 4; i++) {
        svg_box box = {60.0f + (float)(i % 2) * (PANEL + GAP),
                       PLOT_TOP + 24.0f + (float)(i / 2) * (PANEL + GAP - 14.0f), PANEL, PANEL};
        put_side(p, &all, &sides[i], box, EVERY);
    }
    if (fine)
        put_legend(p, &all, m->document, 60.0f + 2.0f * PANEL + GAP + 24.0f,
                   (all.end - all.start) * (float)EVERY / (float)(POINTS - 1));
    free(all.points);
    return fine;
}
