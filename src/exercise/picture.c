/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include <stdio.h>

#include <nakawari/mat.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

typedef struct curve {
    nkw_position_method method;
    const char *name, *rule, *where;
    svg_colour colour;
} curve;

static const curve curves[] = {
    {NKW_POSITION_LINEAR, "Linear", "straight from key to key", "with a corner at each", 0x54545c},
    {NKW_POSITION_HERMITE, "Hermite", "through every key,", "leaving along its nose", 0xd55e00},
    {NKW_POSITION_BEZIER, "B\303\251zier", "through every third key,", "drawn towards the others", 0x7b3fa0},
    {NKW_POSITION_BSPLINE, "B-spline", "near the keys,", "smoothest of the four", 0x00897b},
};
enum { CURVES = sizeof curves / sizeof *curves };
enum { PER_SECOND = 40, POINTS_MAX = 40 * SCENE_SECONDS_MAX + 2 };
static const svg_colour axis_colours[3] = {0xd62728, 0x2ca02c, 0x1f5fd0};

const char *picture_key_name(const scene *s, size_t key, char text[SVG_DIGITS])
{
    char time[SVG_DIGITS];
    sprintf(text, "key %u (%.8s s)", (unsigned)key, svg_number(time, s->keys[key].time, 2));
    return text;
}

/* The positions of a curve, PER_SECOND times a second and at the end. */
static size_t points_of(const scene *s, nkw_position_method method, nkw_vec3 out[POINTS_MAX])
{
    size_t count = scene_times(s, PER_SECOND);
    for (size_t i = 0; i < count; i++) {
        nkw_mat4 m = scene_place(s, scene_time(s, PER_SECOND, i), method, NKW_ORIENTATION_STEP);
        out[i] = nkw_mat4_translation(&m);
    }
    return count;
}

/* ---- from above ---- */

/* All that the picture has to keep clear of when it places a label. */
typedef struct obstacles {
    svg_point point[CURVES * POINTS_MAX + 36 * SCENE_KEYS_MAX];
    size_t count;
} obstacles;

static void avoid(obstacles *o, svg_point p)
{
    o->point[o->count++] = p;
}

/* The distance, squared, of the nearest obstacle from the rim of a label around p, 72 by 16 pixels. */
static float clearance(const obstacles *o, svg_point p)
{
    float least = 1e9f;
    for (size_t i = 0; i < o->count; i++) {
        float dx = nkw_max(nkw_abs(o->point[i].x - p.x) - 36.0f, 0.0f);
        float dy = nkw_max(nkw_abs(o->point[i].y - p.y) - 8.0f, 0.0f);
        least = nkw_min(least, dx * dx + dy * dy);
    }
    return least;
}

static int label_fits(svg_box box, svg_point p)
{
    return p.x > box.x + 40.0f && p.x < box.x + box.width - 40.0f && p.y > box.y + 12.0f &&
           p.y < box.y + box.height - 12.0f;
}

/* The best of 64 places around `at`, in four rings; nearer ones are preferred. */
static svg_point free_place(const obstacles *o, svg_box box, svg_point at)
{
    svg_point best = at;
    float most = -1e9f;
    for (int i = 0; i < 64; i++) {
        float angle = (float)(i % 16) * 0.392699082f, far = 1.0f + 0.3f * (float)(i / 16);
        svg_point p = svg_at(at.x + 50.0f * far * nkw_cos(angle), at.y + 22.0f * far * nkw_sin(angle));
        float value = nkw_min(clearance(o, p), 100.0f) - 45.0f * far;
        if (value > most && label_fits(box, p)) {
            most = value;
            best = p;
        }
    }
    return best;
}

static void include_range(svg_plot *plot, nkw_vec3 p)
{
    plot->x.from = nkw_min(plot->x.from, p.x);
    plot->x.to = nkw_max(plot->x.to, p.x);
    plot->y.to = nkw_min(plot->y.to, p.z);
    plot->y.from = nkw_max(plot->y.from, p.z);
}

/* The range of all curves and keys with a margin, one scale for both axes; the box shrinks to fit it. */
static svg_plot map_of(const scene *s, svg_box box)
{
    nkw_vec3 points[POINTS_MAX], p = scene_position(s, 0);
    svg_plot plot = {box, {p.x, p.x, 0.5f, "x"}, {p.z, p.z, 0.5f, "z, down as on a map"}};
    const float margin = 0.6f;
    for (int c = 0; c < CURVES; c++) {
        size_t count = points_of(s, curves[c].method, points);
        for (size_t i = 0; i < count; i++)
            include_range(&plot, points[i]);
    }
    for (size_t k = 0; k < s->count; k++)
        include_range(&plot, scene_position(s, k));
    plot.x.from -= margin;
    plot.x.to += margin;
    plot.y.from += margin;
    plot.y.to -= margin;
    float scale = nkw_min(box.width / (plot.x.to - plot.x.from), box.height / (plot.y.from - plot.y.to));
    plot.box.width = scale * (plot.x.to - plot.x.from);
    plot.box.height = scale * (plot.y.from - plot.y.to);
    return plot;
}

static svg_point on_map(const svg_plot *plot, nkw_vec3 p)
{
    return svg_plot_at(plot, p.x, p.z);
}

/* A curve with a dot every 0.2 s: where the dots lie close the object is slow. */
static void map_curve(svg *out, const scene *s, const svg_plot *plot, const curve *c, obstacles *o)
{
    nkw_vec3 points[POINTS_MAX];
    svg_point line[POINTS_MAX];
    svg_paint stroke = svg_stroke(c->colour, 2.4f, 0.9f), dot = svg_fill(c->colour, 1.0f);
    size_t count = points_of(s, c->method, points);
    for (size_t i = 0; i < count; i++) {
        line[i] = on_map(plot, points[i]);
        avoid(o, line[i]);
    }
    svg_polyline(out, line, count, &stroke);
    for (size_t i = 0; i < count; i += PER_SECOND / 5)
        svg_circle(out, line[i], 2.6f, &dot);
}

static void map_arrow(svg *out, const svg_plot *plot, nkw_vec3 from, nkw_vec3 way, svg_paint paint, obstacles *o)
{
    svg_point a = on_map(plot, from), b = on_map(plot, nkw_vec3_add(from, way));
    svg_arrow(out, a, b, &paint);
    for (int i = 1; i <= 6; i++)
        avoid(o, svg_at(nkw_lerp(a.x, b.x, (float)i / 6.0f), nkw_lerp(a.y, b.y, (float)i / 6.0f)));
}

/* The key's axes; the nose, minus z, is drawn longer: it is the tangent of the Hermite curve. */
static void map_key(svg *out, const scene *s, const svg_plot *plot, size_t k, obstacles *o)
{
    const nkw_vec3 at = scene_position(s, k);
    nkw_mat3 r = nkw_mat3_from_quat(s->keys[k].orientation);
    svg_paint nose = svg_stroke(0x1d1d22, 1.4f, 1.0f), core = {0xffffff, 0x1d1d22, 1.8f, 1.0f, NULL};
    nose.dash = "4 3";
    map_arrow(out, plot, at, nkw_vec3_scale(nkw_mat3_column(&r, 2), -0.42f), nose, o);
    for (size_t c = 0; c < 3; c++)
        map_arrow(out, plot, at, nkw_vec3_scale(nkw_mat3_column(&r, c), 0.26f),
                  svg_stroke(axis_colours[c], 2.2f, 1.0f), o);
    svg_circle(out, on_map(plot, at), 4.5f, &core);
    avoid(o, on_map(plot, at));
}

static void map_label(svg *out, const scene *s, const svg_plot *plot, size_t key, obstacles *o)
{
    char text[SVG_DIGITS];
    svg_font font = {13.0f, 0x1d1d22, 'm', 1, 0xffffff};
    svg_point p = free_place(o, plot->box, on_map(plot, scene_position(s, key)));
    svg_text(out, svg_at(p.x, p.y + 4.5f), &font, picture_key_name(s, key, text));
    for (int i = -1; i <= 1; i++)
        avoid(o, svg_at(p.x + 25.0f * (float)i, p.y));
}

static void curve_legend(svg *out, svg_point at)
{
    for (int c = 0; c < CURVES; c++, at.y += 62.0f) {
        svg_paint stroke = svg_stroke(curves[c].colour, 3.0f, 1.0f), dot = svg_fill(curves[c].colour, 1.0f);
        svg_line(out, at, svg_at(at.x + 34.0f, at.y), &stroke);
        svg_circle(out, svg_at(at.x + 17.0f, at.y), 3.4f, &dot);
        svg_text(out, svg_at(at.x + 44.0f, at.y + 4.5f), &svg_sheet_strong, curves[c].name);
        svg_text(out, svg_at(at.x + 44.0f, at.y + 21.0f), &svg_sheet_small, curves[c].rule);
        svg_text(out, svg_at(at.x + 44.0f, at.y + 35.0f), &svg_sheet_small, curves[c].where);
    }
    svg_text(out, at, &svg_sheet_small, "One dot every 0.2 s.");
}

static void axes_legend(svg *out, svg_point at)
{
    static const char *const names[] = {"x axis of a key", "y axis (up of the object)", "z axis (its tail)"};
    svg_paint nose = svg_stroke(0x1d1d22, 1.4f, 1.0f);
    for (int i = 0; i < 3; i++, at.y += 22.0f) {
        svg_paint stroke = svg_stroke(axis_colours[i], 2.2f, 1.0f);
        svg_arrow(out, at, svg_at(at.x + 34.0f, at.y), &stroke);
        svg_text(out, svg_at(at.x + 44.0f, at.y + 4.0f), &svg_sheet_small, names[i]);
    }
    nose.dash = "4 3";
    svg_arrow(out, at, svg_at(at.x + 34.0f, at.y), &nose);
    svg_text(out, svg_at(at.x + 44.0f, at.y + 4.0f), &svg_sheet_small, "its nose: -z,");
    svg_text(out, svg_at(at.x + 44.0f, at.y + 18.0f), &svg_sheet_small, "Hermite's tangent");
}

int picture_trajectory_top(const scene *s, const char *path)
{
    svg out;
    obstacles o = {{{0.0f, 0.0f}}, 0};
    char across[48], digits[SVG_DIGITS];
    const svg_box box = {64.0f, 104.0f, 720.0f, 720.0f};
    svg_plot plot = map_of(s, box);
    sprintf(across, "x, 1 is %.16s", svg_number(digits, s->unit, 6));
    if (s->unit != 1.0f)
        plot.x.name = across;
    float width = plot.box.x + plot.box.width + 216.0f, height = plot.box.y + nkw_max(plot.box.height, 440.0f) + 56.0f;
    if (!svg_sheet_open(&out, path, width, height, "Four curves through the same keys, seen from above",
                      s->own ? "The keys fix the position at their times; the method determines the path between them."
                             : "The keys fix the position once a second; the method determines the path between them."))
        return 0;
    svg_plot_frame(&out, &plot);
    for (int c = 0; c < CURVES; c++)
        map_curve(&out, s, &plot, &curves[c], &o);
    for (size_t k = 0; k < s->count; k++)
        map_key(&out, s, &plot, k, &o);
    for (size_t k = 0; k < s->count; k++)
        map_label(&out, s, &plot, k, &o);
    curve_legend(&out, svg_at(plot.box.x + plot.box.width + 24.0f, 130.0f));
    axes_legend(&out, svg_at(plot.box.x + plot.box.width + 24.0f, 430.0f));
    return svg_close(&out);
}

/* ---- in space ---- */

/* Over three points of the curve: the curtain down to the floor, and the curve itself on top of it. */
static void curtain(space_list *list, const svg_camera *camera, const nkw_vec3 p[3], svg_colour colour)
{
    nkw_vec3 quad[4] = {p[0], p[2], space_below(p[2]), space_below(p[0])};
    svg_paint cloth = svg_fill(colour, 0.13f), line = svg_stroke(colour, 3.0f, 1.0f);
    float distance = space_distance(camera, p[1]);
    space_add(list, camera, quad, 4, distance, &cloth);
    space_add(list, camera, p, 2, distance - 0.05f, &line);
    space_add(list, camera, p + 1, 2, distance - 0.05f, &line);
}

static void shadow_line(svg *out, const svg_camera *camera, const nkw_vec3 *points, size_t count, svg_colour colour)
{
    svg_point line[POINTS_MAX];
    svg_paint paint = svg_stroke(svg_mix(colour, 0x202028, 0.4f), 2.4f, 0.45f);
    for (size_t i = 0; i < count; i++)
        line[i] = svg_project(camera, space_below(points[i]));
    svg_polyline(out, line, count, &paint);
}

/* A pole from the key to the floor, and the key's object. */
static void key_object(space_list *list, const svg_camera *camera, const scene *s, size_t k)
{
    const nkw_vec3 at = scene_position(s, k);
    nkw_vec3 pole[2] = {at, space_below(at)};
    svg_paint paint = svg_stroke(0x55555c, 1.2f, 1.0f);
    nkw_mat3 r = nkw_mat3_from_quat(s->keys[k].orientation);
    nkw_mat4 m = nkw_mat4_from_mat3(&r, at);
    paint.dash = "3 3";
    space_add(list, camera, pole, 2, space_distance(camera, at) + 0.02f, &paint);
    object_paint(list, camera, &m, 0.4f, 0, s->object);
}

svg_point picture_outward(const scene *s, const svg_camera *camera, size_t key, float far)
{
    svg_point p = svg_project(camera, scene_position(s, key)), centre = {0.0f, 0.0f};
    for (size_t k = 0; k < s->count; k++) {
        svg_point q = svg_project(camera, scene_position(s, k));
        centre.x += q.x / (float)s->count;
        centre.y += q.y / (float)s->count;
    }
    float dx = p.x - centre.x, dy = 1.4f * (p.y - centre.y), length = nkw_sqrt(dx * dx + dy * dy);
    float k = length > 0.0f ? far / length : 0.0f;
    return svg_at(p.x + 1.3f * k * dx, p.y + k * dy + 4.5f);
}

static void key_numbers(svg *out, const svg_camera *camera, const scene *s)
{
    svg_font font = {14.0f, 0x1d1d22, 'm', 1, 0xffffff};
    char text[SVG_DIGITS];
    for (size_t k = 0; k < s->count; k++)
        svg_text(out, picture_outward(s, camera, k, 29.0f), &font, svg_number(text, (float)k, 0));
}

static int panel(svg *out, const scene *s, svg_box box, const curve *c)
{
    nkw_vec3 points[POINTS_MAX];
    space_list list = {NULL, 0, 0, 0};
    svg_font name = {16.0f, c->colour, 's', 1, 0xffffff};
    svg_paint border = svg_stroke(0x9a9aa2, 1.0f, 1.0f);
    svg_point centre = {box.x + 0.5f * box.width, box.y + 0.53f * box.height};
    svg_camera camera = svg_perspective(&s->view, PICTURE_FOV, centre, 220.0f);
    size_t count = points_of(s, c->method, points);
    svg_begin_clip(out, box);
    space_floor(out, &camera, box);
    shadow_line(out, &camera, points, count, c->colour);
    for (size_t i = 0; i + 2 < count; i += 2)
        curtain(&list, &camera, points + i, c->colour);
    for (size_t k = 0; k < s->count; k++)
        key_object(&list, &camera, s, k);
    int ok = space_paint(&list, out);
    key_numbers(out, &camera, s);
    svg_end(out);
    svg_rect(out, box, 0.0f, &border);
    svg_text(out, svg_at(box.x + 12.0f, box.y + 24.0f), &name, c->name);
    return ok;
}

static void dart_legend(svg *out, svg_point at)
{
    static const struct {
        svg_colour colour;
        const char *text;
    } parts[] = {{0xe8304f, "nose (-z)"},
                 {0xf08a24, "left"},
                 {0x2f7fd1, "right"},
                 {0xf4d35e, "fin, on top"},
                 {0x6a6a78, "underside"}};
    static const float widths[] = {96.0f, 60.0f, 68.0f, 106.0f, 0.0f};
    for (int i = 0; i < 5; i++) {
        svg_paint paint = {parts[i].colour, 0x33333a, 0.6f, 1.0f, NULL};
        svg_circle(out, svg_at(at.x, at.y), 6.0f, &paint);
        svg_text(out, svg_at(at.x + 12.0f, at.y + 4.5f), &svg_sheet_text, parts[i].text);
        at.x += widths[i];
    }
}

void picture_object_legend(svg *out, const scene *s, svg_point at)
{
    char text[96];
    if (!s->object) {
        dart_legend(out, at);
        return;
    }
    sprintf(text, "%.60s: its nose is -z, its top +y", s->object->name);
    svg_text(out, svg_at(at.x, at.y + 4.5f), &svg_sheet_text, text);
}

int picture_trajectory_perspective(const scene *s, const char *path)
{
    svg out;
    int ok = 1;
    if (!svg_sheet_open(&out, path, 1080.0f, 800.0f, "The same curves in space, through the exercise's camera",
                      s->own ? "The objects are the keys. The surface between each curve and its shadow shows the "
                               "height."
                             : "The objects are the keys, with their times in seconds. The surface between each curve "
                               "and its shadow shows the height."))
        return 0;
    for (int c = 0; c < CURVES; c++) {
        svg_box box = {24.0f + 520.0f * (float)(c % 2), 84.0f + 340.0f * (float)(c / 2), 512.0f, 332.0f};
        ok &= panel(&out, s, box, &curves[c]);
    }
    picture_object_legend(&out, s, svg_at(36.0f, 779.0f));
    return svg_close(&out) && ok;
}
