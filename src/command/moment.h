/* SPDX-License-Identifier: MIT */
/** @file A clip of a document at one time: the pose, the model matrices, the palettes, the vertices. */
#ifndef MOMENT_H
#define MOMENT_H

#include <nakawari/box.h>

#include "command.h"

typedef struct moment {
    const nkw_document *document;
    nkw_clip *clip; /**< owned */
    uint32_t *cursors;
    float *pose;
    float *floats; /**< float_count morph weights */
    nkw_mat4 *models; /**< of all joints */
    nkw_mat4 *palette; /**< room for the largest skin */
    nkw_vec3 *positions, *normals; /**< room for the largest primitive */
} moment;

/** Builds the clip of an animation, or of INPUT_REST. Returns 0 and reports on stderr. moment_close is due always. */
int moment_open(moment *m, const nkw_document *document, size_t animation);
void moment_close(moment *m);

/** Computes the pose, the floats and the models. */
void moment_at(moment *m, float time);
nkw_pose_view moment_pose(const moment *m);
/** Computes `palette` of a skin. */
void moment_palette(moment *m, size_t skin);
/** Computes `positions` and `normals` of a primitive of the mesh of a joint, and before that `palette`. */
void moment_vertices(moment *m, size_t joint, size_t primitive);

/** The box of all vertices in the rest pose. Returns 0, having reported, without memory. */
int moment_rest_box(const nkw_document *d, nkw_box *box);

/** The times first, first + 1/rate ... before the end of the clip, then its end. */
size_t moment_rate_count(const moment *m, float rate);
float moment_rate_time(const moment *m, float rate, size_t k);

#endif
