/* SPDX-License-Identifier: MIT */
#include "sketch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/vec.h>

static sketch *sketch_of(canvas *c)
{
    return (sketch *)c;
}

static svg_colour colour_of(nkw_vec3 c)
{
    return (svg_colour)canvas_byte(c.x) << 16 | (svg_colour)canvas_byte(c.y) << 8 | (svg_colour)canvas_byte(c.z);
}

static svg_point on_page(const sketch *s, nkw_vec3 p)
{
    return svg_at(s->box.x + p.x, s->box.y + p.y);
}

/* ---- shadows: one path of triangles, all in one direction, so that they join ---- */

static void end_shadow(sketch *s)
{
    if (s->shadow != SVG_NONE)
        fputs("\"/>\n", s->page->file);
    s->shadow = SVG_NONE;
}

static void put_point(const sketch *s, const char *letter, nkw_vec3 p)
{
    char x[SVG_DIGITS], y[SVG_DIGITS];
    svg_point at = on_page(s, p);
    fprintf(s->page->file, "%s%s %s", letter, svg_number(x, at.x, 1), svg_number(y, at.y, 1));
}

static void draw_shadow(canvas *c, const nkw_vec3 place[3], nkw_vec3 colour)
{
    sketch *s = sketch_of(c);
    const float area = canvas_area(place[0], place[1], place[2].x, place[2].y);
    if (!isfinite(area) || !(fabsf(area) > 0.02f))
        return;
    if (s->shadow != colour_of(colour)) {
        end_shadow(s);
        s->shadow = colour_of(colour);
        fprintf(s->page->file, "<path fill=\"#%06lx\" d=\"", (unsigned long)s->shadow);
    }
    put_point(s, "M", place[0]);
    put_point(s, "L", place[area > 0.0f ? 1 : 2]);
    put_point(s, " ", place[area > 0.0f ? 2 : 1]);
}

/* ---- shapes ---- */

static void add(sketch *s, sketch_shape shape)
{
    if (s->count == s->room) {
        size_t room = 2 * s->room + 256;
        sketch_shape *more = room < (size_t)1 << 26 ? realloc(s->shapes, room * sizeof *more) : NULL;
        if (!more) {
            s->failed = 1;
            return;
        }
        s->shapes = more;
        s->room = room;
    }
    shape.order = s->count;
    s->shapes[s->count++] = shape;
}

static nkw_vec3 mean(nkw_vec3 a, nkw_vec3 b, nkw_vec3 c)
{
    return nkw_vec3_scale(nkw_vec3_add(nkw_vec3_add(a, b), c), 1.0f / 3.0f);
}

static void draw_triangle(canvas *c, const canvas_corner corner[3], const texture *image)
{
    sketch *s = sketch_of(c);
    const canvas_corner *p = corner;
    sketch_shape shape = {CANVAS_SCENE, 0.0f, 0, 3, {{0.0f, 0.0f}}, 0, 0.4f};
    if (!canvas_finite(corner))
        return;
    nkw_vec3 colour = mean(p[0].colour, p[1].colour, p[2].colour);
    nkw_vec3 normal =
        mean(nkw_vec3_normalize(p[0].normal), nkw_vec3_normalize(p[1].normal), nkw_vec3_normalize(p[2].normal));
    if (image) {
        nkw_vec3 t = texture_at(image, canvas_texture_level(corner, image), (p[0].u + p[1].u + p[2].u) / 3.0f,
                                (p[0].v + p[1].v + p[2].v) / 3.0f);
        colour.x *= t.x, colour.y *= t.y, colour.z *= t.z;
    }
    shape.depth = (p[0].place.z + p[1].place.z + p[2].place.z) / 3.0f;
    shape.colour = colour_of(canvas_lit(colour, normal));
    for (int i = 0; i < 3; i++)
        shape.corners[i] = on_page(s, p[i].place);
    add(s, shape);
}

static void put_shape(const sketch *s, const sketch_shape *shape)
{
    svg_paint paint = {shape->colour, shape->colour, shape->width, 1.0f, NULL};
    if (shape->corner_count == 3) {
        svg_polygon(s->page, shape->corners, 3, &paint);
        return;
    }
    svg_point a = shape->corners[0], b = shape->corners[1];
    svg_paint disc = svg_fill(shape->colour, 1.0f), line = svg_stroke(shape->colour, shape->width, 1.0f);
    if (a.x == b.x && a.y == b.y)
        svg_circle(s->page, a, 0.5f * shape->width, &disc);
    else
        svg_line(s->page, a, b, &line);
}

static void draw_line(canvas *c, canvas_layer layer, const nkw_vec3 ends[2], float width, nkw_vec3 colour)
{
    sketch *s = sketch_of(c);
    const nkw_vec3 a = ends[0], b = ends[1];
    if (!isfinite(a.x) || !isfinite(a.y) || !isfinite(b.x) || !isfinite(b.y))
        return;
    sketch_shape shape = {layer, layer == CANVAS_SCENE ? 0.5f * (a.z + b.z) : 0.0f, 0,
                          2,     {on_page(s, a), on_page(s, b), {0.0f, 0.0f}},      colour_of(colour),
                          width};
    end_shadow(s);
    if (layer == CANVAS_FLOOR)
        put_shape(s, &shape);
    else
        add(s, shape);
}

/* ---- a frame ---- */

void sketch_begin(sketch *s, svg *page, svg_box box, nkw_vec3 paper)
{
    const canvas own = {box.width, box.height, 1.0f, draw_triangle, draw_shadow, draw_line};
    svg_paint ground = svg_fill(colour_of(paper), 1.0f);
    memset(s, 0, sizeof *s);
    s->canvas = own;
    s->page = page;
    s->box = box;
    s->shadow = SVG_NONE;
    svg_begin_clip(page, box);
    svg_rect(page, box, 0.0f, &ground);
}

static int by_depth(const void *a, const void *b)
{
    const sketch_shape *x = a, *y = b;
    if (x->layer != y->layer)
        return x->layer < y->layer ? -1 : 1;
    if (x->depth != y->depth)
        return x->depth < y->depth ? -1 : 1;
    return (x->order > y->order) - (x->order < y->order);
}

int sketch_end(sketch *s)
{
    end_shadow(s);
    if (s->count)
        qsort(s->shapes, s->count, sizeof *s->shapes, by_depth);
    for (size_t i = 0; i < s->count; i++)
        put_shape(s, &s->shapes[i]);
    svg_end(s->page);
    free(s->shapes);
    s->shapes = NULL;
    return !s->failed;
}
