/* SPDX-License-Identifier: MIT */
/** @file A page of plots: SVG, or PNG by cairo if NKW_CAIRO is defined. */
#ifndef PAGE_H
#define PAGE_H

#include <stdio.h>

#include "draw/svg.h"

/** Pixels of a PNG for one of SVG. */
enum { PAGE_SCALE = 2 };

typedef struct page {
    svg svg;
    svg_path path;
    void *surface, *cairo; /**< of PNG; otherwise NULL */
} page;

/** Whether a file is to be PNG, by the end of its name. */
int page_is_png(const char *path);

/** Begins a white page; title and about are for SVG. Returns 0 if PNG has no memory for it, or is not built. */
int page_start(page *p, FILE *f, int png, svg_point size, const char *title, const char *about);
/** Ends it; the file remains open. Returns 0 if PNG cannot be written. */
int page_finish(page *p);

/** As the functions svg_...; corners of rectangles are square. */
void page_line(page *p, svg_point a, svg_point b, const svg_paint *paint);
void page_polyline(page *p, const svg_point *points, size_t count, const svg_paint *paint);
void page_path_begin(page *p);
void page_path_lines(page *p, const svg_point *points, size_t count);
void page_path_end(page *p, const svg_paint *paint);
void page_circle(page *p, svg_point centre, float radius, const svg_paint *paint);
void page_rect(page *p, svg_box box, const svg_paint *paint);
void page_text(page *p, svg_point at, const svg_font *font, const char *text);

#endif
