/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Pictures of a mesh that four joints bend. Each film_ function that takes a path writes one SVG file and gives 0,
 * errno set, if it could not.
 */
#ifndef FILM_H
#define FILM_H

#include "rig.h"
#include "draw/svg.h"

typedef struct film {
    const rig *rig;
    const mesh *mesh;
    int dual; /**< skin by dual quaternions */
    int frames; /**< pictures, evenly over 0 <= time < RIG_END */
    nkw_vec3 *positions, *normals; /**< owned: the mesh at one moment */
    svg_box extent; /**< where the mesh is in any frame, as the eye sees it, in units of length */
} film;

/** Gives 0, errno set, if memory ran out. film_free is due in either case. */
int film_open(film *f, const rig *r, const mesh *m, int dual, int frames);
void film_free(film *f);

float film_time(const film *f, int frame);

int film_frame(film *f, int frame, const char *path);
/** All frames on one page. */
int film_sheet(film *f, const char *path);
/** Blended matrices beside dual quaternions where joint 2 is twisted most. */
int film_compare(film *f, const char *path);

#endif
