/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Things in space drawn on a page: the painter's algorithm, a floor, and the object that the animation moves.
 */
#ifndef SPACE_H
#define SPACE_H

#include "svg.h"

/** A shape waiting to be painted; far ones are painted first. */
typedef struct space_shape {
    svg_point point[4];
    int corners;    /**< 2 is a line, 3 and 4 a filled polygon */
    svg_paint paint;
    float distance; /**< from the eye */
    size_t order;   /**< at equal distance the later one is painted over the earlier */
} space_shape;

typedef struct space_list {
    space_shape *shapes;
    size_t count, room;
    int failed; /**< memory ran out */
} space_list;

void space_add(space_list *list, const svg_camera *camera, const nkw_vec3 *corners, int count, float distance,
               const svg_paint *paint);
/** Paints everything from far to near and empties the list. Gives 0, errno set, if memory ran out. */
int space_paint(space_list *list, svg *s);

/** The distance of p from the eye. */
float space_distance(const svg_camera *camera, nkw_vec3 p);
/** The point of the floor y = 0 straight below. */
nkw_vec3 space_below(nkw_vec3 p);
/** A checkerboard of 1 x 1 tiles at y = 0, so far as it falls into the box, paler with the distance. */
void space_floor(svg *s, const svg_camera *camera, svg_box box);

/** The colours of the object: left and right half of its top, its underside, and the fin on top. */
typedef struct space_livery {
    svg_colour left, right, under, fin;
} space_livery;

extern const space_livery space_vivid, space_pale;

/** A colour in the light on a face, whose corners are counter-clockwise seen from outside. */
svg_colour space_lit(svg_colour colour, const nkw_vec3 *corners);
/** Where the lamp of the exercise, at (0, 10, 0), throws the shadow of a point on the floor. */
nkw_vec3 space_shadow_of(nkw_vec3 p);
/** The colour of shadows. */
extern const svg_paint space_shade;

/** A dart with its nose at -z and its fin at +y, placed by m and `length` units long. */
void space_dart(space_list *list, const svg_camera *camera, const nkw_mat4 *m, float length,
                const space_livery *livery);
/** Its shadow on the floor, painted at once. */
void space_dart_shadow(svg *s, const svg_camera *camera, const nkw_mat4 *m, float length);

#endif
