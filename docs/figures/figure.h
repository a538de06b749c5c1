/* SPDX-License-Identifier: MIT */
/**
 * @file
 * The figures of the floor pages. Each figure_ function that takes a path writes one SVG file with values from the
 * library alone, and gives 0, errno set, if it could not.
 */
#ifndef FIGURE_H
#define FIGURE_H

#include "draw/space.h"
#include "draw/svg.h"

#define F(name, draw) int draw(const char *path);
#include "list.h"
#undef F

/* ---- shared, in figure.c ---- */

enum { FIGURE_STEPS = 96 };

enum {
    FIGURE_INK = 0x1d1d22,
    FIGURE_GREY = 0x55555c,
    FIGURE_PALE = 0x9a9aa2,
    FIGURE_HERMITE = 0xd55e00,
    FIGURE_BEZIER = 0x7b3fa0,
    FIGURE_BSPLINE = 0x00897b,
    FIGURE_CATMULL_ROM = 0x1f5fd0,
    FIGURE_EULER = 0xc2185b,
    FIGURE_SLERP = 0x00796b,
    FIGURE_NLERP = 0xe07b00
};

/** Opens the page and writes its heading: the lesson, and how to read the picture. */
int figure_open(svg *s, const char *path, float width, float height, const char *lesson, const char *reading);

void figure_text(svg *s, float x, float y, float size, svg_colour colour, char anchor, const char *text);
void figure_bold(svg *s, float x, float y, float size, svg_colour colour, char anchor, const char *text);
/** Bold with a white rim, for names that stand over lines. */
void figure_name(svg *s, float x, float y, svg_colour colour, char anchor, const char *text);

/** A piece of line with its meaning to the right. */
void figure_legend(svg *s, float x, float y, const svg_paint *paint, const char *text);
/** A disc with a white rim, or a white one with a dark rim: a point of a curve, a key. */
void figure_dot(svg *s, svg_point at, svg_colour colour);
void figure_key(svg *s, svg_point at);

/** Points p(0), p(1/n) ... p(1) of the plot, n = FIGURE_STEPS; p gives y for x. */
void figure_graph(svg *s, const svg_plot *plot, const float y[FIGURE_STEPS + 1], const svg_paint *paint);

/** The arc of a circle of the page from one angle to another, radians, counter-clockwise from the right. */
void figure_arc(svg *s, svg_point centre, float radius, float from, float to, const svg_paint *paint);
/** The same with an arrow's head at its end. */
void figure_arc_arrow(svg *s, svg_point centre, float radius, float from, float to, const svg_paint *paint);

/** An eye that looks `pitch` radians down, turned about the vertical by yaw. */
nkw_mat4 figure_view(float yaw, float pitch);

#endif
