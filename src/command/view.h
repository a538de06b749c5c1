/* SPDX-License-Identifier: MIT */
/** @file What `nakawari render` shows of a document, and the camera that frames it. */
#ifndef VIEW_H
#define VIEW_H

#include "canvas.h"
#include "moment.h"

/** The space that a model takes, over some moments. Empty: low > high. */
typedef struct view_box {
    nkw_vec3 low, high; /**< in eye space: what the picture frames */
    nkw_vec3 least, most; /**< in the world, from the origin of the view */
    float sole; /**< the lowest y in eye space of all points, dropped to y = 0 in the world */
} view_box;

/** An orthographic camera: it looks along -z of its space, y is up. */
typedef struct view {
    nkw_vec3 origin; /**< what the camera moves with; y is 0 */
    nkw_mat4 eye; /**< from the world to the eye */
    view_box box;
    unsigned char *shown; /**< of each joint: whether it is in the scene */
    unsigned char *bones; /**< of each joint: whether it is a joint of a skin; of all joints if there are no skins */
    int frames_bones; /**< whether the box includes them: nodes without a skin may be cameras and lamps far away */
    texture *textures; /**< of each material */
    size_t texture_count;
} view;

/** Finds what is shown. Returns 0 and reports without memory. view_free is due in either case. */
int view_open(view *v, const nkw_document *d);
void view_free(view *v);

/** Moves the camera with an origin in the world, and turns it: radians to the right about y, then down about x. The box
 * becomes empty. */
void view_turn(view *v, nkw_vec3 origin, float yaw, float pitch);
/** The mean of the joints of a moment, at y = 0. */
nkw_vec3 view_middle(const view *v, const moment *m);
/** Extends the box by all vertices and bones of a moment. */
void view_include(view *v, moment *m);
/** Extends a box by another. */
void view_join(view_box *box, const view_box *other);
/** Extends the box of eye space by the shadow on the floor. */
void view_include_shadow(view *v, view_box *box);

/** Draws a floor below the box, with the shadow of what is straight above it. Not from below. */
void view_draw_floor(const view *v, moment *m, canvas *c);
/** Draws the meshes and, if `skeleton` or if no mesh is shown, the bones over them. */
void view_draw(const view *v, moment *m, canvas *c, int skeleton);

/** The colour behind all. */
nkw_vec3 view_paper(void);

#endif
