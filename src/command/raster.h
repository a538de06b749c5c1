/* SPDX-License-Identifier: MIT */
/** @file A canvas of points: triangles with a z-buffer, lines and discs. */
#ifndef RASTER_H
#define RASTER_H

#include "canvas.h"

/** A picture while it is drawn: SAMPLES x SAMPLES points for each pixel. */
typedef struct raster {
    canvas canvas; /**< the first member */
    size_t width, height; /**< of the points */
    float *depth; /**< the nearest z so far: larger is nearer */
    nkw_vec3 *colour; /**< red, green, blue, linear, 0..1 */
} raster;

enum { RASTER_SAMPLES = 3 };

/** Room for a picture of width x height pixels. Returns 0 without memory. raster_free is due in either case. */
int raster_open(raster *r, size_t width, size_t height);
void raster_free(raster *r);
void raster_clear(raster *r, nkw_vec3 colour);

/** Averages the points of each pixel into `out`, rows of `stride` bytes, red green blue. */
void raster_resolve(const raster *r, unsigned char *out, size_t stride);

#endif
