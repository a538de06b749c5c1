/* SPDX-License-Identifier: MIT */
/** @file What `nakawari render` draws on: points of a raster, or shapes of an SVG page. */
#ifndef CANVAS_H
#define CANVAS_H

#include <nakawari/types.h>

#include "texture.h"

/** What hides what: the scene hides the floor, and itself by depth; what is over the scene is drawn in its order. */
typedef enum canvas_layer { CANVAS_FLOOR, CANVAS_SCENE, CANVAS_OVER } canvas_layer;

/**
 * A corner of a triangle: x to the right and y down in units of the canvas, z towards the eye; the normal in eye space,
 * of any length; red, green, blue, linear, 0..1; the place in the texture.
 */
typedef struct canvas_corner {
    nkw_vec3 place, normal, colour;
    float u, v;
} canvas_corner;

typedef struct canvas canvas;
struct canvas {
    float width, height; /**< in units */
    float unit; /**< units for a pixel */
    /** A lit triangle of the scene, seen from both sides. image NULL: none. */
    void (*triangle)(canvas *c, const canvas_corner corner[3], const texture *image);
    /** A triangle of the floor, in one colour. */
    void (*shadow)(canvas *c, const nkw_vec3 place[3], nkw_vec3 colour);
    /** A line with round ends, in one colour; a == b: a disc. */
    void (*line)(canvas *c, canvas_layer layer, const nkw_vec3 ends[2], float width, nkw_vec3 colour);
};

/** The colour of a surface by its normal: light from the upper left behind the eye, from the sky and from everywhere. */
nkw_vec3 canvas_lit(nkw_vec3 colour, nkw_vec3 normal);
/** Whether all places, and all normals, are finite: others are not drawn. */
int canvas_finite(const canvas_corner corner[3]);
/** Twice the signed area of a, b, (x, y). */
float canvas_area(nkw_vec3 a, nkw_vec3 b, float x, float y);
/** The level of a texture for a triangle. */
int canvas_texture_level(const canvas_corner corner[3], const texture *image);
/** A linear share as a byte of sRGB, by a square root (texture_share is its inverse). */
unsigned char canvas_byte(float share);

#endif
