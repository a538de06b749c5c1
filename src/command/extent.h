/* SPDX-License-Identifier: MIT */
/** @file How large a model is, and how far a joint moves what: the scale of every tolerance in space. */
#ifndef EXTENT_H
#define EXTENT_H

#include <nakawari/clip_reduce.h>

#include "moment.h"

typedef struct extent {
    nkw_vec3 low, high; /**< the box of the joints and vertices in the rest pose */
    float size; /**< its diagonal; 1 if it has none */
    float *reach; /**< of each joint: the farthest vertex that it moves, in the joint's space */
    float *radius; /**< the same in model space; size / 16 of a joint without vertices; the size of what sees far */
    float *lever; /**< at least the farthest point that it or a joint below it moves, in model space */
    float *stretch; /**< the largest column of the parent's matrix: from the joint's translation to model space */
    float *tolerances; /**< see extent_reduction */
} extent;

/** Returns 0 and reports on stderr without memory. extent_free is due in either case. The moment is set to rest. */
int extent_open(extent *e, const nkw_document *d);
void extent_free(extent *e);

/**
 * Within `tolerance` in model space at the farthest vertex of each joint, but of a joint at most a twentieth of its
 * lever, so that small parts of a large scene keep their motion; of morph weights by the size of the model. Its arrays
 * remain until the next call.
 */
nkw_clip_reduction extent_reduction(const extent *e, const nkw_document *d, float tolerance);

#endif
