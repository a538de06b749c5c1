/* SPDX-License-Identifier: MIT */
/** @file Triangles with a z-buffer, lines and discs over them, and PNG files by libpng. */
#ifndef RASTER_H
#define RASTER_H

#include <stdio.h>

#include <nakawari/types.h>

/** A picture while it is drawn: SAMPLES x SAMPLES points for each pixel. */
typedef struct raster {
    size_t width, height; /**< of the points */
    float *depth; /**< the nearest z so far: larger is nearer */
    nkw_vec3 *colour; /**< red, green, blue, linear, 0..1 */
} raster;

enum { RASTER_SAMPLES = 3 };

/** A corner: x to the right and y down in points, z towards the eye; the normal in eye space, of any length. */
typedef struct raster_corner {
    nkw_vec3 place, normal;
} raster_corner;

/** Room for a picture of width x height pixels. Returns 0 without memory. raster_free is due in either case. */
int raster_open(raster *r, size_t width, size_t height);
void raster_free(raster *r);
void raster_clear(raster *r, nkw_vec3 colour);

/** A lit triangle, seen from both sides. Corners that are not finite draw nothing. */
void raster_triangle(raster *r, const raster_corner corner[3], nkw_vec3 colour);
/** A line over all that is drawn, and a disc; widths in points. */
void raster_line(raster *r, nkw_vec3 a, nkw_vec3 b, float width, nkw_vec3 colour);
void raster_disc(raster *r, nkw_vec3 centre, float radius, nkw_vec3 colour);

/** Averages the points of each pixel into `out`, rows of `stride` bytes, red green blue. */
void raster_resolve(const raster *r, unsigned char *out, size_t stride);

/** Writes a PNG file of width x height pixels. Returns 0 if it cannot. */
int raster_write_png(FILE *f, const unsigned char *pixels, size_t width, size_t height);

#endif
