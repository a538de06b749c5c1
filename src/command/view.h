/* SPDX-License-Identifier: MIT */
/** @file What `nakawari render` shows of a document, and the camera that frames it. */
#ifndef VIEW_H
#define VIEW_H

#include "moment.h"
#include "raster.h"

/** An orthographic camera: it looks along -z of its space, y is up. */
typedef struct view {
    nkw_mat4 eye; /**< from the world to the eye */
    nkw_vec3 low, high; /**< the box in eye space that the picture frames */
    unsigned char *shown; /**< of each joint: whether it is in the scene */
    unsigned char *bones; /**< of each joint: whether it is a joint of a skin; of all joints if there are no skins */
    int frames_bones; /**< whether the box includes them: nodes without a skin may be cameras and lamps far away */
} view;

/** Finds what is shown. Returns 0 and reports without memory. view_free is due in either case. */
int view_open(view *v, const nkw_document *d);
void view_free(view *v);

/** Turns the camera: radians to the right about y, then down about x. The box becomes empty. */
void view_turn(view *v, float yaw, float pitch);
/** Extends the box by all vertices and bones of a moment. */
void view_include(view *v, moment *m);
/** Extends the box by that of another view. */
void view_join(view *v, const view *other);

/** Draws the meshes and, if `skeleton`, the bones over them. */
void view_draw(const view *v, moment *m, raster *r, int skeleton);

#endif
