/* SPDX-License-Identifier: MIT */
/**
 * @file
 * A small SVG writer for the figures, with a projector from space to the page.
 *
 * Coordinates are pixels, x to the right, y down. Every number is written with at most two decimals, by integer
 * arithmetic of its own, so the bytes depend neither on the C library nor on the locale. Errors of the file
 * are remembered and reported once, by svg_close.
 */
#ifndef SVG_H
#define SVG_H

#include <stdio.h>

#include <nakawari/types.h>

/** Room for a number as text. */
enum { SVG_DIGITS = 48 };

/** A colour 0xRRGGBB, or SVG_NONE. */
typedef long svg_colour;
#define SVG_NONE (-1L)

typedef struct svg_point {
    float x, y;
} svg_point;

typedef struct svg_box {
    float x, y, width, height;
} svg_box;

/** How a shape is painted. */
typedef struct svg_paint {
    svg_colour fill, stroke;
    float width;      /**< of the stroke, pixels */
    float opacity;    /**< of the whole shape, 0..1 */
    const char *dash; /**< lengths of dashes and gaps, "6 3"; NULL is a solid line */
} svg_paint;

/** How a text is set. */
typedef struct svg_font {
    float size; /**< pixels */
    svg_colour colour;
    char anchor; /**< which point of the text is given: 's'tart, 'm'iddle or 'e'nd of the base line */
    int bold;
    svg_colour halo; /**< a rim that keeps the letters readable over lines, or SVG_NONE */
} svg_font;

typedef struct svg {
    FILE *file;
    int clips; /* clip paths written so far: they need names */
} svg;

/** A path that is being written; coordinates in hundredths. */
typedef struct svg_path {
    svg *sheet;
    long x, y; /* where it is */
    long dx, dy; /* the line from there that is not written yet */
    size_t points, lines; /* since the last move; lines that are written */
} svg_path;

svg_paint svg_fill(svg_colour fill, float opacity);
svg_paint svg_stroke(svg_colour stroke, float width, float opacity);
svg_point svg_at(float x, float y);
/** a at share = 0, b at share = 1, mixed by channel. */
svg_colour svg_mix(svg_colour a, svg_colour b, float share);

/** Starts a white page. `title` and `about` are what a screen reader says. Gives 0, errno set, if it cannot. */
int svg_open(svg *s, const char *path, float width, float height, const char *title, const char *about);
/** The same into an open file, to be ended by svg_finish or svg_close. */
void svg_start(svg *s, FILE *file, float width, float height, const char *title, const char *about);
/** Ends the page; the file remains open. */
void svg_finish(svg *s);
/** Ends the page and closes the file. Returns 0 if anything since svg_open could not be written. */
int svg_close(svg *s);

/** A group painted as one, so that shapes within do not show through one another. */
void svg_begin(svg *s, float opacity);
/** A group of which only the part within the box is seen. */
void svg_begin_clip(svg *s, svg_box box);
void svg_end(svg *s);

void svg_line(svg *s, svg_point a, svg_point b, const svg_paint *paint);
void svg_arrow(svg *s, svg_point a, svg_point b, const svg_paint *paint);
void svg_polyline(svg *s, const svg_point *points, size_t count, const svg_paint *paint);
/**
 * Many polylines as one element. One that begins where the last ended continues it: with round joins and caps, and an
 * opacity of 1, the picture is that of separate ones. A point between two others on a line is left out.
 */
void svg_path_begin(svg_path *p, svg *s);
void svg_path_lines(svg_path *p, const svg_point *points, size_t count);
void svg_path_end(svg_path *p, const svg_paint *paint);
void svg_polygon(svg *s, const svg_point *points, size_t count, const svg_paint *paint);
void svg_circle(svg *s, svg_point centre, float radius, const svg_paint *paint);
void svg_rect(svg *s, svg_box box, float corner, const svg_paint *paint);
void svg_text(svg *s, svg_point at, const svg_font *font, const char *text);

/** A number with up to `decimals` (0..3) decimals, trailing zeros dropped, into `text`; gives text. */
const char *svg_number(char text[SVG_DIGITS], float value, int decimals);

/* ---- plots ---- */

/** One axis of a plot: its range, the distance of its ticks, and what it is called. */
typedef struct svg_axis {
    float from, to, tick;
    const char *name;
} svg_axis;

/** A rectangle of the page with a scale on each side; y.from lies at the bottom. */
typedef struct svg_plot {
    svg_box box;
    svg_axis x, y;
} svg_plot;

svg_point svg_plot_at(const svg_plot *plot, float x, float y);
/** The frame with its grid, numbers and names. */
void svg_plot_frame(svg *s, const svg_plot *plot);

/* ---- from space to the page ---- */

/** Eye coordinates look along -z with y up, as in OpenGL. */
typedef struct svg_camera {
    nkw_mat4 view;       /**< from the world to the eye */
    nkw_mat4 projection; /**< from the eye to -1..1 */
    svg_point centre;    /**< where 0, 0 falls on the page */
    float scale;         /**< pixels per 1 */
} svg_camera;

/** `fov` radians from the lower to the upper edge, which are 2 * half_height pixels apart. */
svg_camera svg_perspective(const nkw_mat4 *view, float fov, svg_point centre, float half_height);
/** `scale` pixels per unit of length. */
svg_camera svg_orthographic(const nkw_mat4 *view, svg_point centre, float scale);

/** The point of the page; meaningless where svg_depth is not above 0. */
svg_point svg_project(const svg_camera *camera, nkw_vec3 p);
/** How far p lies before the eye along its line of sight. */
float svg_depth(const svg_camera *camera, nkw_vec3 p);
/** Twice the area of a polygon of the page, positive where its corners run counter-clockwise to the eye. */
float svg_area(const svg_point *points, size_t count);

/* ---- sheets ---- */

/** The fonts of labels on a sheet. */
extern const svg_font svg_sheet_text, svg_sheet_strong, svg_sheet_small;

/** Opens a sheet and writes its heading: what is seen, and the lesson in one line. 0 after an error, as svg_open. */
int svg_sheet_open(svg *s, const char *path, float width, float height, const char *title, const char *lesson);

#endif
