/* SPDX-License-Identifier: MIT */
#include "page.h"

#include "command.h"

#include <stdlib.h>
#include <string.h>

int page_is_png(const char *path)
{
    static const char *const png[] = {"png"};
    return output_ending(path, png, 1) == 0;
}

#if defined(NKW_CAIRO)

#include <cairo.h>

/* The largest surface of cairo is 32767 pixels. */
enum { SIDE_MOST = 32767 / PAGE_SCALE };

static int start_png(page *p, svg_point size)
{
    if (size.x > (float)SIDE_MOST || size.y > (float)SIDE_MOST)
        return 0;
    cairo_surface_t *surface =
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, PAGE_SCALE * (int)size.x, PAGE_SCALE * (int)size.y);
    cairo_t *c = cairo_create(surface);
    p->surface = surface;
    p->cairo = c;
    cairo_scale(c, PAGE_SCALE, PAGE_SCALE);
    cairo_set_source_rgb(c, 1.0, 1.0, 1.0);
    cairo_paint(c);
    cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(c, CAIRO_LINE_CAP_ROUND);
    return cairo_status(c) == CAIRO_STATUS_SUCCESS;
}

static cairo_status_t write_bytes(void *file, const unsigned char *data, unsigned bytes)
{
    return fwrite(data, 1, bytes, file) == bytes ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

static int finish_png(page *p)
{
    int fine = cairo_status(p->cairo) == CAIRO_STATUS_SUCCESS &&
               cairo_surface_write_to_png_stream(p->surface, write_bytes, p->svg.file) == CAIRO_STATUS_SUCCESS;
    cairo_destroy(p->cairo);
    cairo_surface_destroy(p->surface);
    return fine;
}

static void set_colour(cairo_t *c, svg_colour colour, float opacity)
{
    cairo_set_source_rgba(c, (double)(colour >> 16 & 255) / 255.0, (double)(colour >> 8 & 255) / 255.0,
                          (double)(colour & 255) / 255.0, (double)opacity);
}

/* "6 3": lengths of dashes and gaps. */
static void set_dash(cairo_t *c, const char *dash)
{
    double lengths[8];
    int count = 0;
    char *end;
    for (; dash && count < 8; dash = end) {
        lengths[count] = strtod(dash, &end);
        if (end == dash)
            break;
        count++;
    }
    cairo_set_dash(c, lengths, count, 0.0);
}

/* Paints the path that was begun. */
static void paint_path(cairo_t *c, const svg_paint *paint)
{
    if (paint->fill != SVG_NONE) {
        set_colour(c, paint->fill, paint->opacity);
        cairo_fill_preserve(c);
    }
    if (paint->stroke != SVG_NONE) {
        set_colour(c, paint->stroke, paint->opacity);
        cairo_set_line_width(c, (double)paint->width);
        set_dash(c, paint->dash);
        cairo_stroke_preserve(c);
    }
    cairo_new_path(c);
}

static void draw_points(cairo_t *c, const svg_point *points, size_t count)
{
    for (size_t i = 0; i < count; i++)
        cairo_line_to(c, (double)points[i].x, (double)points[i].y);
}

static void draw_move(cairo_t *c)
{
    cairo_new_sub_path(c);
}

static void draw_circle(cairo_t *c, svg_point centre, float radius)
{
    cairo_arc(c, (double)centre.x, (double)centre.y, (double)radius, 0.0, 6.283185307179586);
}

static void draw_rect(cairo_t *c, svg_box box)
{
    cairo_rectangle(c, (double)box.x, (double)box.y, (double)box.width, (double)box.height);
}

static void draw_text(cairo_t *c, svg_point at, const svg_font *font, const char *text)
{
    cairo_text_extents_t extents;
    cairo_select_font_face(c, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           font->bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(c, (double)font->size);
    cairo_text_extents(c, text, &extents);
    double share = font->anchor == 's' ? 0.0 : font->anchor == 'm' ? 0.5 : 1.0;
    cairo_move_to(c, (double)at.x - share * extents.x_advance, (double)at.y);
    set_colour(c, font->colour, 1.0f);
    cairo_show_text(c, text);
    cairo_new_path(c);
}

#else

typedef void cairo_t;

static int start_png(page *p, svg_point size)
{
    (void)p, (void)size;
    return 0;
}

static int finish_png(page *p)
{
    (void)p;
    return 0;
}

static void paint_path(cairo_t *c, const svg_paint *paint)
{
    (void)c, (void)paint;
}

static void draw_points(cairo_t *c, const svg_point *points, size_t count)
{
    (void)c, (void)points, (void)count;
}

static void draw_move(cairo_t *c)
{
    (void)c;
}

static void draw_circle(cairo_t *c, svg_point centre, float radius)
{
    (void)c, (void)centre, (void)radius;
}

static void draw_rect(cairo_t *c, svg_box box)
{
    (void)c, (void)box;
}

static void draw_text(cairo_t *c, svg_point at, const svg_font *font, const char *text)
{
    (void)c, (void)at, (void)font, (void)text;
}

#endif

int page_start(page *p, FILE *f, int png, svg_point size, const char *title, const char *about)
{
    memset(p, 0, sizeof *p);
    p->svg.file = f;
    if (png)
        return start_png(p, size);
    svg_start(&p->svg, f, size.x, size.y, title, about);
    return 1;
}

int page_finish(page *p)
{
    if (p->cairo)
        return finish_png(p);
    svg_finish(&p->svg);
    return 1;
}

void page_line(page *p, svg_point a, svg_point b, const svg_paint *paint)
{
    const svg_point points[2] = {a, b};
    if (!p->cairo) {
        svg_line(&p->svg, a, b, paint);
        return;
    }
    draw_points(p->cairo, points, 2);
    paint_path(p->cairo, paint);
}

void page_polyline(page *p, const svg_point *points, size_t count, const svg_paint *paint)
{
    if (!p->cairo) {
        svg_polyline(&p->svg, points, count, paint);
        return;
    }
    draw_points(p->cairo, points, count);
    paint_path(p->cairo, paint);
}

void page_path_begin(page *p)
{
    if (!p->cairo)
        svg_path_begin(&p->path, &p->svg);
}

void page_path_lines(page *p, const svg_point *points, size_t count)
{
    if (!p->cairo) {
        svg_path_lines(&p->path, points, count);
        return;
    }
    draw_move(p->cairo);
    draw_points(p->cairo, points, count);
}

void page_path_end(page *p, const svg_paint *paint)
{
    if (p->cairo)
        paint_path(p->cairo, paint);
    else
        svg_path_end(&p->path, paint);
}

void page_circle(page *p, svg_point centre, float radius, const svg_paint *paint)
{
    if (!p->cairo) {
        svg_circle(&p->svg, centre, radius, paint);
        return;
    }
    draw_circle(p->cairo, centre, radius);
    paint_path(p->cairo, paint);
}

void page_rect(page *p, svg_box box, const svg_paint *paint)
{
    if (!p->cairo) {
        svg_rect(&p->svg, box, 0.0f, paint);
        return;
    }
    draw_rect(p->cairo, box);
    paint_path(p->cairo, paint);
}

void page_text(page *p, svg_point at, const svg_font *font, const char *text)
{
    if (p->cairo)
        draw_text(p->cairo, at, font, text);
    else
        svg_text(&p->svg, at, font, text);
}
