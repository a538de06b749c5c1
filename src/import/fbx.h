/* SPDX-License-Identifier: MIT */
/*
 * What an FBX file states of nodes and curves, read beside Assimp: objects and their connections, transforms with
 * pivots and modes of inheritance, animation stacks with layers. docs/importers.md states the formulas.
 */
#ifndef NAKAWARI_IMPORT_FBX_H
#define NAKAWARI_IMPORT_FBX_H

#include <nakawari/euler.h>
#include <nakawari/fcurve.h>

#include "fbx_tree.h"

typedef struct nkwi_fbx_object {
    int64_t id;
    size_t node; /* of the tree; NKWI_FBX_NONE for the root, of the id 0 */
    size_t definition; /* the properties of its kind: a node of the tree, or NKWI_FBX_NONE */
    size_t first_link, link_count; /* of links: those to this object, in the order of the file */
} nkwi_fbx_object;

/* A connection of an object to one above it, or to a property of one. */
typedef struct nkwi_fbx_link {
    size_t from, to; /* objects */
    size_t order; /* in the file */
    const nkwi_fbx_value *property; /* NULL: to the object */
} nkwi_fbx_link;

typedef struct nkwi_fbx {
    nkwi_fbx_tree tree;
    nkwi_memory *memory; /* of all that follows */
    nkwi_fbx_object *objects; /* sorted by id */
    size_t object_count;
    nkwi_fbx_link *links; /* sorted by `to`, then by order */
    size_t link_count;
    size_t root; /* the object of the id 0 */
    double ticks; /* of a second */
    size_t bad_curves; /* curves without an order of times, or with keys that are not finite: they have no keys */
    size_t settings; /* the node GlobalSettings, or NKWI_FBX_NONE */
} nkwi_fbx;

/* Reads the objects of a file, to be closed also after an error: 0, and fbx->tree.fault. */
int nkwi_fbx_begin(nkwi_fbx *fbx, nkwi_memory *memory, const void *data, size_t bytes);
void nkwi_fbx_end(nkwi_fbx *fbx);

int nkwi_fbx_is_kind(const nkwi_fbx *fbx, size_t object, const char *kind);
/* The name of an object without its kind, in `room` bytes. */
void nkwi_fbx_name(const nkwi_fbx *fbx, size_t object, char *name, size_t room);
/*
 * A property of an object, the last of its name, or else of its kind: the node of the tree, or NKWI_FBX_NONE. Its
 * values begin at index 4.
 */
size_t nkwi_fbx_property(const nkwi_fbx *fbx, size_t object, const char *name);
double nkwi_fbx_number(const nkwi_fbx *fbx, size_t object, const char *name, double other);
nkw_vec3 nkwi_fbx_vector(const nkwi_fbx *fbx, size_t object, const char *name, nkw_vec3 other);
/* The same of a list of properties; the node Properties70, or NKWI_FBX_NONE. */
size_t nkwi_fbx_listed(const nkwi_fbx *fbx, size_t list, const char *name);
double nkwi_fbx_listed_number(const nkwi_fbx *fbx, size_t list, const char *name, double other);

/* ---- transforms (fbx_model.c) ---- */

enum { NKWI_FBX_RRSS, NKWI_FBX_RSRS, NKWI_FBX_RRS }; /* InheritType */

/*
 * The transform of a Model, with T, R, S of translation, rotation and scaling, from the left:
 *
 *     T  RotationOffset  RotationPivot  PreRotation  R  PostRotation^-1  RotationPivot^-1
 *     ScalingOffset  ScalingPivot  S  ScalingPivot^-1
 */
typedef struct nkwi_fbx_model {
    size_t object;
    int inherit;
    nkw_euler_order order;
    int has_pivot; /* rotation and scaling move the origin */
    nkw_quat before, after; /* PreRotation, inverse of PostRotation */
    nkw_vec3 rotation_offset, rotation_pivot, scaling_offset, scaling_pivot;
    nkw_vec3 translation, rotation, scaling; /* at rest; rotation in degrees */
    nkw_trs geometry; /* of what the node carries, not of the nodes below */
    int has_geometry, is_spheric;
} nkwi_fbx_model;

nkwi_fbx_model nkwi_fbx_model_of(const nkwi_fbx *fbx, size_t object);
nkw_quat nkwi_fbx_turn(nkw_vec3 degrees, nkw_euler_order order);
nkw_quat nkwi_fbx_rotation(const nkwi_fbx_model *model, nkw_vec3 degrees);
/* The origin, of T, S and the rotation of the node. */
nkw_vec3 nkwi_fbx_translation(const nkwi_fbx_model *model, nkw_vec3 t, nkw_quat rotation, nkw_vec3 s);

/* ---- animation (fbx_curve.c, fbx_stack.c) ---- */

/* An AnimationCurve. Times are seconds from the start of the file. */
typedef struct nkwi_fbx_curve {
    nkw_fcurve curve; /* key_count 0: not read yet, or without keys */
    uint32_t cursor;
} nkwi_fbx_curve;

/* Reads a curve; 0 after an error. */
int nkwi_fbx_curve_read(nkwi_fbx *fbx, size_t object, nkwi_fbx_curve *out);

/* An AnimationCurveNode: up to three curves of a property of an object, in a layer. */
typedef struct nkwi_fbx_channel {
    size_t object; /* of the property */
    const nkwi_fbx_value *property;
    size_t layer; /* of the stack */
    nkwi_fbx_curve *curves[3]; /* or NULL */
    float values[3]; /* where there is no curve */
} nkwi_fbx_channel;

typedef struct nkwi_fbx_layer {
    size_t object;
    int mode; /* BlendMode: 0 additive, 1 override, 2 override-passthrough */
    int composes_rotation, composes_scaling; /* not by component */
    float weight; /* 0..1 */
    const nkwi_fbx_channel *weights; /* its curve, or NULL */
} nkwi_fbx_layer;

typedef struct nkwi_fbx_stack {
    size_t object;
    float start, stop; /* of the take, seconds; stop < start: it states none */
    nkwi_fbx_layer *layers;
    size_t layer_count;
    nkwi_fbx_channel *channels; /* sorted by object, then property, then layer */
    size_t channel_count;
} nkwi_fbx_stack;

int nkwi_fbx_stack_read(nkwi_fbx *fbx, size_t object, nkwi_fbx_stack *out);
/* The channels of a property: the first, and how many layers have it. */
const nkwi_fbx_channel *nkwi_fbx_channels(const nkwi_fbx_stack *stack, size_t object, const char *property,
                                          size_t *count);
/* What an animated property is: its channels, and its value without them. */
typedef struct nkwi_fbx_animated {
    const nkwi_fbx_stack *stack;
    const nkwi_fbx_channel *channels;
    size_t count;
    nkw_vec3 rest;
    nkw_euler_order order; /* of rotations */
    char kind; /* T, R, S, or N for a number */
} nkwi_fbx_animated;

nkw_vec3 nkwi_fbx_sample(const nkwi_fbx_animated *a, float time);

#endif
