/* SPDX-License-Identifier: MIT */
#include "raster.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <png.h>

#include <nakawari/scalar.h>
#include <nakawari/vec.h>

int raster_open(raster *r, size_t width, size_t height)
{
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

/* The points whose middles may be in low..high, within 0..count: first, and one after the last. */
static void range_of(float low, float high, size_t count, size_t *first, size_t *end)
{
    float from = nkw_clamp(low - 1.0f, 0.0f, (float)count), to = nkw_clamp(high + 1.0f, 0.0f, (float)count);
    *first = (size_t)from;
    *end = (size_t)to;
}

/* Light from the upper left behind the eye, and light from everywhere. */
static nkw_vec3 lit(nkw_vec3 colour, nkw_vec3 normal)
{
    const nkw_vec3 lamp = {-0.36f, 0.55f, 0.753f};
    nkw_vec3 n = nkw_vec3_normalize(normal);
    float cosine = nkw_vec3_dot(n.z < 0.0f ? nkw_vec3_scale(n, -1.0f) : n, lamp);
    return nkw_vec3_scale(colour, 0.2f + 0.7f * nkw_max(cosine, 0.0f));
}

/* Twice the signed area of a, b, p. */
static float area(nkw_vec3 a, nkw_vec3 b, float x, float y)
{
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

static int finite_corners(const raster_corner corner[3])
{
    int finite = 1;
    for (int i = 0; i < 3; i++) {
        nkw_vec3 p = corner[i].place, n = corner[i].normal;
        finite = finite && isfinite(p.x) && isfinite(p.y) && isfinite(p.z) && isfinite(n.x) && isfinite(n.y) &&
                 isfinite(n.z);
    }
    return finite;
}

/* The barycentric weights of a point; 0 if it is outside. */
static int weights_at(const raster_corner corner[3], float whole, float x, float y, float w[3])
{
    w[0] = area(corner[1].place, corner[2].place, x, y) / whole;
    w[1] = area(corner[2].place, corner[0].place, x, y) / whole;
    w[2] = 1.0f - w[0] - w[1];
    return w[0] >= 0.0f && w[1] >= 0.0f && w[2] >= 0.0f;
}

static nkw_vec3 blended(const raster_corner corner[3], const float w[3])
{
    nkw_vec3 n = nkw_vec3_scale(corner[0].normal, w[0]);
    n = nkw_vec3_add_scaled(n, corner[1].normal, w[1]);
    return nkw_vec3_add_scaled(n, corner[2].normal, w[2]);
}

void raster_triangle(raster *r, const raster_corner corner[3], nkw_vec3 colour)
{
    if (!finite_corners(corner))
        return;
    const nkw_vec3 a = corner[0].place, b = corner[1].place, c = corner[2].place;
    float whole = area(a, b, c.x, c.y);
    size_t x0, x1, y0, y1;
    if (!(fabsf(whole) > 0.0f))
        return;
    range_of(nkw_min(a.x, nkw_min(b.x, c.x)), nkw_max(a.x, nkw_max(b.x, c.x)), r->width, &x0, &x1);
    range_of(nkw_min(a.y, nkw_min(b.y, c.y)), nkw_max(a.y, nkw_max(b.y, c.y)), r->height, &y0, &y1);
    for (size_t y = y0; y < y1; y++)
        for (size_t x = x0; x < x1; x++) {
            float w[3], *depth = &r->depth[y * r->width + x];
            if (!weights_at(corner, whole, (float)x + 0.5f, (float)y + 0.5f, w))
                continue;
            float z = (w[0] * a.z + w[1] * b.z) + w[2] * c.z;
            if (!(z > *depth))
                continue;
            *depth = z;
            r->colour[y * r->width + x] = lit(colour, blended(corner, w));
        }
}

/* The squared distance of a point from the line from a to b. */
static float distance_squared(nkw_vec3 a, nkw_vec3 b, float x, float y)
{
    float dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
    float t = length > 0.0f ? nkw_saturate(((x - a.x) * dx + (y - a.y) * dy) / length) : 0.0f;
    float ex = a.x + t * dx - x, ey = a.y + t * dy - y;
    return ex * ex + ey * ey;
}

void raster_line(raster *r, nkw_vec3 a, nkw_vec3 b, float width, nkw_vec3 colour)
{
    size_t x0, x1, y0, y1;
    float half = 0.5f * width;
    if (!isfinite(a.x) || !isfinite(a.y) || !isfinite(b.x) || !isfinite(b.y))
        return;
    range_of(nkw_min(a.x, b.x) - half, nkw_max(a.x, b.x) + half, r->width, &x0, &x1);
    range_of(nkw_min(a.y, b.y) - half, nkw_max(a.y, b.y) + half, r->height, &y0, &y1);
    for (size_t y = y0; y < y1; y++)
        for (size_t x = x0; x < x1; x++)
            if (distance_squared(a, b, (float)x + 0.5f, (float)y + 0.5f) <= half * half)
                r->colour[y * r->width + x] = colour;
}

void raster_disc(raster *r, nkw_vec3 centre, float radius, nkw_vec3 colour)
{
    raster_line(r, centre, centre, 2.0f * radius, colour);
}

/* A linear share as a byte; the transfer function is the square root. */
static unsigned char byte_of(float share)
{
    return (unsigned char)(255.0f * nkw_sqrt(nkw_saturate(share)) + 0.5f);
}

void raster_resolve(const raster *r, unsigned char *out, size_t stride)
{
    const float each = 1.0f / (float)(RASTER_SAMPLES * RASTER_SAMPLES);
    for (size_t y = 0; y < r->height / RASTER_SAMPLES; y++)
        for (size_t x = 0; x < r->width / RASTER_SAMPLES; x++) {
            nkw_vec3 sum = nkw_vec3_zero();
            for (size_t i = 0; i < RASTER_SAMPLES * RASTER_SAMPLES; i++) {
                size_t row = y * RASTER_SAMPLES + i / RASTER_SAMPLES, column = x * RASTER_SAMPLES + i % RASTER_SAMPLES;
                sum = nkw_vec3_add(sum, r->colour[row * r->width + column]);
            }
            unsigned char *pixel = out + y * stride + 3 * x;
            pixel[0] = byte_of(sum.x * each);
            pixel[1] = byte_of(sum.y * each);
            pixel[2] = byte_of(sum.z * each);
        }
}

int raster_write_png(FILE *f, const unsigned char *pixels, size_t width, size_t height)
{
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    image.format = PNG_FORMAT_RGB;
    image.width = (png_uint_32)width;
    image.height = (png_uint_32)height;
    int fine = png_image_write_to_stdio(&image, f, 0, pixels, 0, NULL) != 0;
    png_image_free(&image);
    return fine;
}
