/* SPDX-License-Identifier: MIT */
/** @file A skinned mesh of a document as one nkw_partition_mesh: all primitives joined, bones roots first. */
#ifndef SKINMODEL_H
#define SKINMODEL_H

#include <nakawari/partition.h>

#include "command.h"

typedef struct skinmodel {
    nkw_partition_mesh mesh; /**< its arrays are those below */
    uint32_t *indices, *materials; /**< material + 1 of the document; 0: none */
    uint16_t *joints; /**< bones, by rank */
    float *weights;
    nkw_vec3 *positions, *normals;
    float *texcoords; /**< for each vertex u and v of all sets; zeros of sets that its primitive does not have */
    size_t texcoord_count; /**< sets: the most of a primitive */
    size_t bone_count;
    int32_t *joint_of_bone; /**< the joint of the skeleton */
    int32_t *parents; /**< of each bone: a bone, or -1; less than the bone */
    nkw_mat4 *inverse_bind;
} skinmodel;

/**
 * The mesh of a joint that has a mesh and a skin; vertices keep at most `influences` weights, which sum to 1. Returns 0
 * and reports on stderr. skinmodel_free is due in either case.
 */
int skinmodel_open(skinmodel *s, const nkw_document *d, size_t joint, size_t influences);
void skinmodel_free(skinmodel *s);

/** The matrix of a bone in the bind pose, relative to its parent. */
nkw_mat4 skinmodel_bind_local(const skinmodel *s, size_t bone);

#endif
