/* SPDX-License-Identifier: MIT */
/** @file Axes, labels and lines of the plots. */
#ifndef CHART_H
#define CHART_H

#include "page.h"

enum { CHART_COLOURS = 8 };

/** Red, green, blue, grey for x, y, z, w; then four more for lists. */
extern const svg_colour chart_colours[CHART_COLOURS];

/** A step of 1, 2 or 5 times a power of ten, four to ten of them in a range. */
float chart_tick(float range);
/** An axis from low to high with a margin of 6 %; of a range that is empty, around it. */
svg_axis chart_axis(float low, float high, const char *name);

/** A text; control characters become ?, and it is cut after 255 bytes. anchor: as in svg_font. Bold if large. */
void chart_label(page *p, svg_point at, char anchor, const char *words, float size, svg_colour colour);
/** The frame of a plot with its grid and numbers, and the name of its y axis above it. */
void chart_frame(page *p, const svg_plot *plot);
/** A short line of a paint and words beside it. */
void chart_key(page *p, svg_point at, const svg_paint *paint, const char *words);

#endif
