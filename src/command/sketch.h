/* SPDX-License-Identifier: MIT */
/** @file A canvas of SVG: each triangle in one colour, farther ones before nearer ones. */
#ifndef SKETCH_H
#define SKETCH_H

#include "canvas.h"
#include "draw/svg.h"

typedef struct sketch_shape {
    canvas_layer layer;
    float depth;
    size_t order, corner_count; /**< 3, or 2: a line of some width */
    svg_point corners[3];
    svg_colour colour;
    float width;
} sketch_shape;

typedef struct sketch {
    canvas canvas; /**< the first member; its units are pixels */
    svg *page;
    svg_box box;
    sketch_shape *shapes;
    size_t count, room;
    svg_colour shadow; /**< of the path that is open, or SVG_NONE */
    int failed; /**< no memory */
} sketch;

/** Begins a frame in a box of the page, filled with a colour. */
void sketch_begin(sketch *s, svg *page, svg_box box, nkw_vec3 paper);
/** Draws what was added, and frees it. Returns 0 without memory. */
int sketch_end(sketch *s);

#endif
