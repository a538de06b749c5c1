/* SPDX-License-Identifier: MIT */
/*
 * Nodes and animations of FBX, read beside Assimp (fbx.h). Assimp's scene has the meshes, the bones and one node for
 * each Model.
 *
 * InheritType is exact with one node more. R and S are rotation and scale of a node, p its parent:
 *
 *     RSrs   global = global of p * R S
 *     RrSs   the rotations of both, then the scales of both: R_p R S_p S
 *     Rrs    as RrSs without the scale of p itself
 *
 * The scale of a node with such nodes below is that of a node NAME_scale, which carries its mesh and its other nodes;
 * the nodes of RrSs and Rrs are below the node without the scale, with the product of the scales that they inherit.
 */
#ifndef NAKAWARI_IMPORT_ASSIMP_FBX_H
#define NAKAWARI_IMPORT_ASSIMP_FBX_H

#include "assimp.h"
#include "fbx.h"

typedef struct nkwi_assimp_fbx {
    nkwi_fbx file;
    nkwi_fbx_model *models; /* of each node of the tree; object NKWI_FBX_NONE: there is none */
    int32_t *inherits; /* the node whose scale it inherits; or NKW_NO_JOINT */
    unsigned char *is_scaled; /* its scale, with those that it inherits, may differ from 1 */
    nkwi_fbx_stack *stacks;
    size_t stack_count;
    nkwi_fbx_animated (*animated)[3]; /* translation, rotation and scaling of each node in the stack that is read */
} nkwi_assimp_fbx;

/* The stack whose values are read; NULL: the rest pose. */
void nkwi_assimp_fbx_choose(nkwi_assimp *a, const nkwi_fbx_stack *stack);
/* Translation (3), rotation (4) or scale (3 floats) of a node at a time. `whole`: the scale that the node has. */
void nkwi_assimp_fbx_local(const nkwi_assimp *a, size_t node, nkw_clip_target target, float time, float *out);
/* The scale of a node, times those that it inherits. */
nkw_vec3 nkwi_assimp_fbx_scale(const nkwi_assimp *a, size_t node, float time);

/* A shape of a BlendShapeChannel: a morph target. */
typedef struct nkwi_assimp_shape {
    size_t channel; /* an object */
    const double *full; /* the percents at which each shape of the channel is whole, ascending; NULL: 100 */
    size_t index, count; /* of the channel's shapes */
} nkwi_assimp_shape;

/* The shapes of the mesh of a node, in the order of the morph targets; NULL, and 0 in *count, where there are none. */
nkwi_assimp_shape *nkwi_assimp_fbx_shapes(nkwi_assimp *a, size_t node, size_t *count);
/* The weight of a shape at a percent of its channel: shapes follow each other in lines. */
float nkwi_assimp_fbx_weight(const nkwi_assimp_shape *shape, float percent);
/* DeformPercent of a channel at rest. */
float nkwi_assimp_fbx_percent(const nkwi_assimp *a, size_t channel);
/* Records what the tree could not read. Returns 0. */
int nkwi_assimp_fbx_fail(nkwi_assimp *a);

#endif
