/* SPDX-License-Identifier: MIT */
/** @file The object that an animation moves: the dart, or a model of triangles in its place. */
#ifndef OBJECT_H
#define OBJECT_H

#include "space.h"

/** Its corners are counter-clockwise seen from outside: the other side is not painted, as in the exercise's program. */
typedef struct object_triangle {
    nkw_vec3 corner[3];
    svg_colour colour;
} object_triangle;

/** A node of a tree: its plane is that of its triangle. Children are indices + 1; 0: none. */
typedef struct object_node {
    object_triangle triangle;
    nkw_vec3 normal;
    float offset; /**< the plane: normal . p = offset */
    size_t front, back;
} object_node;

/** Its nose at -z, its top at +y. Node 0 is the root. */
typedef struct object_model {
    const char *name;
    object_node *nodes;
    size_t count, room;
} object_model;

typedef enum object_result { OBJECT_OK, OBJECT_NO_SIZE, OBJECT_NO_MEMORY } object_result;

/**
 * Moves the middle of the triangles' box to the origin, scales its longest side to 1, the length of the dart, and sorts
 * them into the nodes of a model that is all zero: triangles are cut by the planes of others, up to 1000 times, so that
 * from every eye they can be painted from far to near. object_free is due in either case.
 * Source: Fuchs, Kedem, Naylor, On visible surface generation by a priori tree structures, 1980.
 *
 * Returns  OBJECT_NO_SIZE if a corner is not finite or all triangles are lines or points
 */
object_result object_build(object_model *model, object_triangle *triangles, size_t count);
void object_free(object_model *model);

/** Placed by m, a rotation and a translation, and `length` long; paler for frames between keys. NULL: the dart. */
void object_paint(space_list *list, const svg_camera *camera, const nkw_mat4 *m, float length, int pale,
                  const object_model *model);
/** Its shadow on the floor, painted at once. */
void object_shadow(svg *s, const svg_camera *camera, const nkw_mat4 *m, float length, const object_model *model);

#endif
