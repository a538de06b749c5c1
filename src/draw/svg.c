/* SPDX-License-Identifier: MIT */
#include "svg.h"

#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/scalar.h>

static const char family[] = "DejaVu Sans, Verdana, Helvetica, sans-serif";

svg_paint svg_fill(svg_colour fill, float opacity)
{
    svg_paint p = {fill, SVG_NONE, 0.0f, opacity, NULL};
    return p;
}

svg_paint svg_stroke(svg_colour stroke, float width, float opacity)
{
    svg_paint p = {SVG_NONE, stroke, width, opacity, NULL};
    return p;
}

svg_point svg_at(float x, float y)
{
    svg_point p = {x, y};
    return p;
}

static long channel(svg_colour a, svg_colour b, int shift, float share)
{
    float x = (float)(a >> shift & 255), y = (float)(b >> shift & 255);
    return (long)(nkw_lerp(x, y, share) + 0.5f) << shift;
}

svg_colour svg_mix(svg_colour a, svg_colour b, float share)
{
    float k = nkw_clamp(share, 0.0f, 1.0f);
    return channel(a, b, 16, k) | channel(a, b, 8, k) | channel(a, b, 0, k);
}

/* Half away from zero; |value| above 1e6, and NaN, are no coordinates and become 0. */
static long scaled(float value, long unit)
{
    double x = (double)value * (double)unit;
    if (!(x > -1e6 * (double)unit && x < 1e6 * (double)unit))
        return 0;
    return (long)(x < 0.0 ? x - 0.5 : x + 0.5);
}

/* n / unit. */
static const char *fraction(char text[SVG_DIGITS], long n, long unit)
{
    while (unit > 1 && n % 10 == 0) {
        n /= 10;
        unit /= 10;
    }
    const char *sign = n < 0 ? "-" : "";
    n = n < 0 ? -n : n;
    int width = unit == 1000 ? 3 : unit == 100 ? 2 : 1;
    if (unit > 1)
        sprintf(text, "%s%ld.%0*ld", sign, n / unit, width, n % unit);
    else
        sprintf(text, "%s%ld", sign, n);
    return text;
}

const char *svg_number(char text[SVG_DIGITS], float value, int decimals)
{
    static const long units[] = {1, 10, 100, 1000};
    long unit = units[decimals < 0 ? 0 : decimals > 3 ? 3 : decimals];
    return fraction(text, scaled(value, unit), unit);
}

static void put(svg *s, const char *text)
{
    fputs(text, s->file);
}

/*  before="12.34"  */
static void attribute(svg *s, const char *name, float value)
{
    char text[SVG_DIGITS];
    fprintf(s->file, " %s=\"%s\"", name, svg_number(text, value, 2));
}

static void colour(svg *s, const char *name, svg_colour c)
{
    if (c == SVG_NONE)
        fprintf(s->file, " %s=\"none\"", name);
    else
        fprintf(s->file, " %s=\"#%06lx\"", name, (unsigned long)c & 0xffffff);
}

static void finish(svg *s, const svg_paint *p)
{
    if (p->fill != 0)
        colour(s, "fill", p->fill);
    if (p->stroke != SVG_NONE) {
        colour(s, "stroke", p->stroke);
        attribute(s, "stroke-width", p->width);
    }
    if (p->opacity < 1.0f)
        attribute(s, "opacity", p->opacity);
    if (p->dash)
        fprintf(s->file, " stroke-dasharray=\"%s\"", p->dash);
    put(s, "/>\n");
}

static void escaped(svg *s, const char *text)
{
    for (; *text; text++) {
        switch (*text) {
        case '&':
            put(s, "&amp;");
            break;
        case '<':
            put(s, "&lt;");
            break;
        default:
            fputc(*text, s->file);
        }
    }
}

void svg_start(svg *s, FILE *file, float width, float height, const char *title, const char *about)
{
    svg_box page = {0.0f, 0.0f, width, height};
    svg_paint white = svg_fill(0xffffff, 1.0f);
    s->clips = 0;
    s->file = file;
    put(s, "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\"");
    attribute(s, "width", width);
    attribute(s, "height", height);
    fprintf(s->file, " viewBox=\"0 0 %d %d\" font-family=\"%s\"", (int)width, (int)height, family);
    put(s, " stroke-linejoin=\"round\" stroke-linecap=\"round\">\n<title>");
    escaped(s, title);
    put(s, "</title>\n<desc>");
    escaped(s, about);
    put(s, "</desc>\n");
    svg_rect(s, page, 0.0f, &white);
}

int svg_open(svg *s, const char *path, float width, float height, const char *title, const char *about)
{
    FILE *file = fopen(path, "wb");
    if (file)
        svg_start(s, file, width, height, title, about);
    return file != NULL;
}

void svg_finish(svg *s)
{
    put(s, "</svg>\n");
}

int svg_close(svg *s)
{
    svg_finish(s);
    int failed = ferror(s->file);
    return fclose(s->file) == 0 && !failed;
}

void svg_begin(svg *s, float opacity)
{
    put(s, "<g");
    if (opacity < 1.0f)
        attribute(s, "opacity", opacity);
    put(s, ">\n");
}

void svg_begin_clip(svg *s, svg_box box)
{
    s->clips++;
    fprintf(s->file, "<clipPath id=\"clip%d\"><rect", s->clips);
    attribute(s, "x", box.x);
    attribute(s, "y", box.y);
    attribute(s, "width", box.width);
    attribute(s, "height", box.height);
    fprintf(s->file, "/></clipPath>\n<g clip-path=\"url(#clip%d)\">\n", s->clips);
}

void svg_end(svg *s)
{
    put(s, "</g>\n");
}

void svg_line(svg *s, svg_point a, svg_point b, const svg_paint *paint)
{
    put(s, "<line");
    attribute(s, "x1", a.x);
    attribute(s, "y1", a.y);
    attribute(s, "x2", b.x);
    attribute(s, "y2", b.y);
    finish(s, paint);
}

/* The head is as long as four strokes are wide, and never longer than 60 % of the arrow. */
void svg_arrow(svg *s, svg_point a, svg_point b, const svg_paint *paint)
{
    float dx = b.x - a.x, dy = b.y - a.y, length = nkw_sqrt(dx * dx + dy * dy);
    float head = nkw_min(2.0f + 3.2f * paint->width, 0.6f * length);
    if (!(length > 0.0f))
        return;
    dx *= head / length;
    dy *= head / length;
    svg_point neck = {b.x - dx, b.y - dy};
    svg_point tip[3] = {{neck.x - 0.45f * dy, neck.y + 0.45f * dx}, b, {neck.x + 0.45f * dy, neck.y - 0.45f * dx}};
    svg_paint solid = svg_fill(paint->stroke, paint->opacity);
    svg_line(s, a, neck, paint);
    svg_polygon(s, tip, 3, &solid);
}

static void shape(svg *s, const char *name, const svg_point *points, size_t count, const svg_paint *paint)
{
    char x[SVG_DIGITS], y[SVG_DIGITS];
    fprintf(s->file, "<%s points=\"", name);
    for (size_t i = 0; i < count; i++)
        fprintf(s->file, "%s%s,%s", i ? " " : "", svg_number(x, points[i].x, 2), svg_number(y, points[i].y, 2));
    put(s, "\"");
    finish(s, paint);
}

void svg_polyline(svg *s, const svg_point *points, size_t count, const svg_paint *paint)
{
    shape(s, "polyline", points, count, paint);
}

void svg_polygon(svg *s, const svg_point *points, size_t count, const svg_paint *paint)
{
    shape(s, "polygon", points, count, paint);
}

void svg_path_begin(svg_path *p, svg *s)
{
    const svg_path none = {s, 0, 0, 0, 0, 0, 0};
    *p = none;
    put(s, "<path d=\"");
}

/* A step in hundredths, from where the path is. */
static void put_step(const svg_path *p, const char *before, long dx, long dy)
{
    char x[SVG_DIGITS], y[SVG_DIGITS];
    fprintf(p->sheet->file, "%s%s,%s", before, fraction(x, dx, 100), fraction(y, dy, 100));
}

/* The line that is not written yet, because the next may go on in its direction. */
static void put_pending(svg_path *p)
{
    if (p->dx || p->dy)
        put_step(p, p->lines++ ? " " : "l", p->dx, p->dy);
    p->x += p->dx, p->y += p->dy;
    p->dx = p->dy = 0;
}

static void go_to(svg_path *p, long x, long y)
{
    long dx = x - p->x - p->dx, dy = y - p->y - p->dy;
    if (p->dx * dy != p->dy * dx || p->dx * dx + p->dy * dy < 0)
        put_pending(p);
    p->dx += dx, p->dy += dy;
}

/* A line of no length is a dot. */
static void end_line(svg_path *p)
{
    put_pending(p);
    if (p->points > 1 && !p->lines)
        put_step(p, "l", 0, 0);
}

void svg_path_lines(svg_path *p, const svg_point *points, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        long x = scaled(points[i].x, 100), y = scaled(points[i].y, 100);
        if (i > 0 || (p->points && x == p->x + p->dx && y == p->y + p->dy)) {
            go_to(p, x, y);
            p->points++;
            continue;
        }
        end_line(p);
        put_step(p, "m", x - p->x, y - p->y);
        p->x = x, p->y = y;
        p->points = 1;
        p->lines = 0;
    }
}

void svg_path_end(svg_path *p, const svg_paint *paint)
{
    end_line(p);
    put(p->sheet, "\"");
    finish(p->sheet, paint);
}

void svg_circle(svg *s, svg_point centre, float radius, const svg_paint *paint)
{
    put(s, "<circle");
    attribute(s, "cx", centre.x);
    attribute(s, "cy", centre.y);
    attribute(s, "r", radius);
    finish(s, paint);
}

void svg_rect(svg *s, svg_box box, float corner, const svg_paint *paint)
{
    put(s, "<rect");
    attribute(s, "x", box.x);
    attribute(s, "y", box.y);
    attribute(s, "width", box.width);
    attribute(s, "height", box.height);
    if (corner > 0.0f)
        attribute(s, "rx", corner);
    finish(s, paint);
}

void svg_text(svg *s, svg_point at, const svg_font *font, const char *text)
{
    put(s, "<text");
    attribute(s, "x", at.x);
    attribute(s, "y", at.y);
    attribute(s, "font-size", font->size);
    colour(s, "fill", font->colour);
    if (font->anchor != 's')
        fprintf(s->file, " text-anchor=\"%s\"", font->anchor == 'm' ? "middle" : "end");
    if (font->bold)
        put(s, " font-weight=\"bold\"");
    if (font->halo != SVG_NONE) {
        colour(s, "stroke", font->halo);
        put(s, " stroke-width=\"4\" paint-order=\"stroke\"");
    }
    put(s, ">");
    escaped(s, text);
    put(s, "</text>\n");
}

svg_point svg_plot_at(const svg_plot *plot, float x, float y)
{
    svg_point p = {
        plot->box.x + plot->box.width * nkw_inverse_lerp(plot->x.from, plot->x.to, x),
        plot->box.y + plot->box.height * (1.0f - nkw_inverse_lerp(plot->y.from, plot->y.to, y)),
    };
    return p;
}

/* The first multiple of the tick within the axis, and how many there are; ranges may descend. */
static long first_tick(const svg_axis *axis, long *last)
{
    float low = nkw_min(axis->from, axis->to) / axis->tick, high = nkw_max(axis->from, axis->to) / axis->tick;
    long first = (long)low + (low > (float)(long)low + 1e-3f);
    *last = (long)high - (high < (float)(long)high - 1e-3f);
    return first;
}

static void frame_columns(svg *s, const svg_plot *plot, const svg_paint *grid, const svg_font *font)
{
    char text[SVG_DIGITS];
    long last, k = first_tick(&plot->x, &last);
    for (; k <= last; k++) {
        svg_point p = svg_plot_at(plot, (float)k * plot->x.tick, plot->y.from);
        svg_line(s, svg_at(p.x, plot->box.y), p, grid);
        svg_text(s, svg_at(p.x, p.y + 16.0f), font, svg_number(text, (float)k * plot->x.tick, 2));
    }
}

static void frame_rows(svg *s, const svg_plot *plot, const svg_paint *grid, const svg_font *font)
{
    char text[SVG_DIGITS];
    long last, k = first_tick(&plot->y, &last);
    for (; k <= last; k++) {
        svg_point p = svg_plot_at(plot, plot->x.from, (float)k * plot->y.tick);
        svg_line(s, p, svg_at(plot->box.x + plot->box.width, p.y), grid);
        svg_text(s, svg_at(p.x - 7.0f, p.y + 4.0f), font, svg_number(text, (float)k * plot->y.tick, 2));
    }
}

void svg_plot_frame(svg *s, const svg_plot *plot)
{
    svg_paint grid = svg_stroke(0xe6e6ea, 1.0f, 1.0f), border = svg_stroke(0x9a9aa2, 1.0f, 1.0f);
    svg_font below = {11.0f, 0x55555c, 'm', 0, SVG_NONE}, left = {11.0f, 0x55555c, 'e', 0, SVG_NONE};
    svg_font name = {12.0f, 0x2b2b30, 'm', 0, SVG_NONE}, start = {12.0f, 0x2b2b30, 's', 0, SVG_NONE};
    svg_box b = plot->box;
    frame_columns(s, plot, &grid, &below);
    frame_rows(s, plot, &grid, &left);
    svg_rect(s, b, 0.0f, &border);
    svg_text(s, svg_at(b.x + 0.5f * b.width, b.y + b.height + 34.0f), &name, plot->x.name);
    svg_text(s, svg_at(b.x - 30.0f, b.y - 9.0f), &start, plot->y.name);
}

/* x' = x / (-z tan(fov/2)), the same for y; the third row keeps the matrix invertible, depth is svg_depth's. */
svg_camera svg_perspective(const nkw_mat4 *view, float fov, svg_point centre, float half_height)
{
    float f = 1.0f / nkw_tan(0.5f * fov);
    svg_camera c = {*view, {{f, 0, 0, 0, 0, f, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0}}, centre, half_height};
    return c;
}

svg_camera svg_orthographic(const nkw_mat4 *view, svg_point centre, float scale)
{
    svg_camera c = {*view, nkw_mat4_identity(), centre, scale};
    return c;
}

svg_point svg_project(const svg_camera *camera, nkw_vec3 p)
{
    nkw_vec3 eye = nkw_mat4_transform_point(&camera->view, p);
    nkw_vec3 q = nkw_mat4_project_point(&camera->projection, eye);
    return svg_at(camera->centre.x + camera->scale * q.x, camera->centre.y - camera->scale * q.y);
}

float svg_depth(const svg_camera *camera, nkw_vec3 p)
{
    return -nkw_mat4_transform_point(&camera->view, p).z;
}

float svg_area(const svg_point *points, size_t count)
{
    float sum = 0.0f;
    for (size_t i = 0; i < count; i++) {
        svg_point a = points[i], b = points[(i + 1) % count];
        sum += a.y * b.x - a.x * b.y;
    }
    return sum;
}

/* ---- sheets ---- */

const svg_font svg_sheet_text = {13.0f, 0x2b2b30, 's', 0, SVG_NONE};
const svg_font svg_sheet_strong = {13.0f, 0x2b2b30, 's', 1, SVG_NONE};
const svg_font svg_sheet_small = {11.0f, 0x55555c, 's', 0, SVG_NONE};

int svg_sheet_open(svg *s, const char *path, float width, float height, const char *title, const char *lesson)
{
    svg_font heading = {20.0f, 0x1d1d22, 's', 1, SVG_NONE}, below = {14.0f, 0x4a4a52, 's', 0, SVG_NONE};
    if (!svg_open(s, path, width, height, title, lesson))
        return 0;
    svg_text(s, svg_at(24.0f, 36.0f), &heading, title);
    svg_text(s, svg_at(24.0f, 60.0f), &below, lesson);
    return 1;
}
