/* SPDX-License-Identifier: MIT */
#include "raster.h"

#include <math.h>
#include <stdlib.h>

#include <nakawari/scalar.h>
#include <nakawari/vec.h>

static raster *raster_of(canvas *c)
{
    return (raster *)c;
}

/* ---- triangles ---- */

/* The points whose middles may be in low..high, within 0..count: first, and one after the last. */
static void range_of(float low, float high, size_t count, size_t *first, size_t *end)
{
    float from = nkw_clamp(low - 1.0f, 0.0f, (float)count), to = nkw_clamp(high + 1.0f, 0.0f, (float)count);
    *first = (size_t)from;
    *end = (size_t)to;
}

/* The barycentric weights of a point; 0 if it is outside. */
static int weights_at(const nkw_vec3 place[3], float whole, float x, float y, float w[3])
{
    w[0] = canvas_area(place[1], place[2], x, y) / whole;
    w[1] = canvas_area(place[2], place[0], x, y) / whole;
    w[2] = 1.0f - w[0] - w[1];
    return w[0] >= 0.0f && w[1] >= 0.0f && w[2] >= 0.0f;
}

/* Calls `at` for each point whose middle is in the triangle. */
typedef void (*visit)(raster *r, size_t index, const float w[3], const void *user);

static void visit_triangle(raster *r, const nkw_vec3 place[3], visit at, const void *user)
{
    const nkw_vec3 a = place[0], b = place[1], c = place[2];
    float whole = canvas_area(a, b, c.x, c.y);
    size_t x0, x1, y0, y1;
    if (!(fabsf(whole) > 0.0f))
        return;
    range_of(nkw_min(a.x, nkw_min(b.x, c.x)), nkw_max(a.x, nkw_max(b.x, c.x)), r->width, &x0, &x1);
    range_of(nkw_min(a.y, nkw_min(b.y, c.y)), nkw_max(a.y, nkw_max(b.y, c.y)), r->height, &y0, &y1);
    for (size_t y = y0; y < y1; y++)
        for (size_t x = x0; x < x1; x++) {
            float w[3];
            if (weights_at(place, whole, (float)x + 0.5f, (float)y + 0.5f, w))
                at(r, y * r->width + x, w, user);
        }
}

/* A triangle of the scene, and the level of its texture. */
typedef struct facet {
    const canvas_corner *corner;
    const texture *image;
    int level;
} facet;

static nkw_vec3 blended(nkw_vec3 a, nkw_vec3 b, nkw_vec3 c, const float w[3])
{
    return nkw_vec3_add_scaled(nkw_vec3_add_scaled(nkw_vec3_scale(a, w[0]), b, w[1]), c, w[2]);
}

static void draw_point(raster *r, size_t index, const float w[3], const void *user)
{
    const facet *f = user;
    const canvas_corner *a = &f->corner[0], *b = &f->corner[1], *c = &f->corner[2];
    float z = (w[0] * a->place.z + w[1] * b->place.z) + w[2] * c->place.z;
    if (!(z > r->depth[index]))
        return;
    nkw_vec3 colour = blended(a->colour, b->colour, c->colour, w);
    if (f->image) {
        float u = (w[0] * a->u + w[1] * b->u) + w[2] * c->u, v = (w[0] * a->v + w[1] * b->v) + w[2] * c->v;
        nkw_vec3 t = texture_at(f->image, f->level, u, v);
        colour.x *= t.x, colour.y *= t.y, colour.z *= t.z;
    }
    r->depth[index] = z;
    r->colour[index] = canvas_lit(colour, blended(a->normal, b->normal, c->normal, w));
}

static void draw_triangle(canvas *c, const canvas_corner corner[3], const texture *image)
{
    const nkw_vec3 place[3] = {corner[0].place, corner[1].place, corner[2].place};
    facet f = {corner, image, 0};
    if (!canvas_finite(corner))
        return;
    if (image)
        f.level = canvas_texture_level(corner, image);
    visit_triangle(raster_of(c), place, draw_point, &f);
}

static void draw_flat_point(raster *r, size_t index, const float w[3], const void *user)
{
    (void)w;
    r->colour[index] = *(const nkw_vec3 *)user;
}

static void draw_shadow(canvas *c, const nkw_vec3 place[3], nkw_vec3 colour)
{
    for (int i = 0; i < 3; i++)
        if (!isfinite(place[i].x) || !isfinite(place[i].y))
            return;
    visit_triangle(raster_of(c), place, draw_flat_point, &colour);
}

/* ---- lines ---- */

/* The share of a line from a to b that is nearest to a point, and the squared distance of it. */
static float nearest(nkw_vec3 a, nkw_vec3 b, float x, float y, float *squared)
{
    float dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
    float t = length > 0.0f ? nkw_clamp(((x - a.x) * dx + (y - a.y) * dy) / length, 0.0f, 1.0f) : 0.0f;
    float ex = a.x + t * dx - x, ey = a.y + t * dy - y;
    *squared = ex * ex + ey * ey;
    return t;
}

/* The columns that a line of half the width `half` may have in a row. */
static void columns_of(nkw_vec3 a, nkw_vec3 b, float half, float y, float *low, float *high)
{
    float rise = b.y - a.y, from = 0.0f, to = 1.0f;
    if (fabsf(rise) > 0.0f) {
        float s = (y - half - 1.0f - a.y) / rise, t = (y + half + 1.0f - a.y) / rise;
        from = nkw_clamp(nkw_min(s, t), 0.0f, 1.0f);
        to = nkw_clamp(nkw_max(s, t), 0.0f, 1.0f);
    }
    float x0 = nkw_lerp(a.x, b.x, from), x1 = nkw_lerp(a.x, b.x, to);
    *low = nkw_min(x0, x1) - half;
    *high = nkw_max(x0, x1) + half;
}

static void draw_line(canvas *c, canvas_layer layer, const nkw_vec3 ends[2], float width, nkw_vec3 colour)
{
    raster *r = raster_of(c);
    const nkw_vec3 a = ends[0], b = ends[1];
    size_t x0, x1, y0, y1;
    float half = 0.5f * width, low, high, squared;
    if (!isfinite(a.x) || !isfinite(a.y) || !isfinite(b.x) || !isfinite(b.y))
        return;
    range_of(nkw_min(a.y, b.y) - half, nkw_max(a.y, b.y) + half, r->height, &y0, &y1);
    for (size_t y = y0; y < y1; y++) {
        columns_of(a, b, half, (float)y + 0.5f, &low, &high);
        range_of(low, high, r->width, &x0, &x1);
        for (size_t x = x0; x < x1; x++) {
            float t = nearest(a, b, (float)x + 0.5f, (float)y + 0.5f, &squared), z = nkw_lerp(a.z, b.z, t);
            size_t index = y * r->width + x;
            if (squared > half * half || (layer == CANVAS_SCENE && !(z > r->depth[index])))
                continue;
            r->colour[index] = colour;
            r->depth[index] = layer == CANVAS_SCENE ? z : r->depth[index];
        }
    }
}

/* ---- the picture ---- */

int raster_open(raster *r, size_t width, size_t height)
{
    const canvas own = {(float)(width * RASTER_SAMPLES),
                        (float)(height * RASTER_SAMPLES),
                        (float)RASTER_SAMPLES,
                        draw_triangle,
                        draw_shadow,
                        draw_line};
    r->canvas = own;
    r->width = width * RASTER_SAMPLES;
    r->height = height * RASTER_SAMPLES;
    r->depth = calloc(r->width * r->height, sizeof *r->depth);
    r->colour = calloc(r->width * r->height, sizeof *r->colour);
    return r->depth && r->colour;
}

void raster_free(raster *r)
{
    free(r->depth);
    free(r->colour);
}

void raster_clear(raster *r, nkw_vec3 colour)
{
    for (size_t i = 0; i < r->width * r->height; i++) {
        r->depth[i] = -INFINITY;
        r->colour[i] = colour;
    }
}

void raster_resolve(const raster *r, unsigned char *out, size_t stride)
{
    const float each = 1.0f / (float)(RASTER_SAMPLES * RASTER_SAMPLES);
    for (size_t y = 0; y < r->height / RASTER_SAMPLES; y++)
        for (size_t x = 0; x < r->width / RASTER_SAMPLES; x++) {
            nkw_vec3 sum = NKW_VEC3_ZERO;
            for (size_t i = 0; i < RASTER_SAMPLES * RASTER_SAMPLES; i++) {
                size_t row = y * RASTER_SAMPLES + i / RASTER_SAMPLES, column = x * RASTER_SAMPLES + i % RASTER_SAMPLES;
                sum = nkw_vec3_add(sum, r->colour[row * r->width + column]);
            }
            unsigned char *pixel = out + y * stride + 3 * x;
            pixel[0] = canvas_byte(sum.x * each);
            pixel[1] = canvas_byte(sum.y * each);
            pixel[2] = canvas_byte(sum.z * each);
        }
}
