/* SPDX-License-Identifier: MIT */
/*
 * What a Collada 1.4 file states of nodes and animations, read by libxml2 beside Assimp.
 *
 * The transform of a node is the product of its elements in the order of the file:
 *
 *     translate   x y z                   rotate   axis x y z, degrees
 *     scale       x y z                   matrix   16 numbers, row by row
 *     lookat      eye, interest, up       skew     not applied
 *
 * A sampler has times (INPUT), values (OUTPUT), and for each segment the kind of its first key (INTERPOLATION). With
 * the keys P0, P1, the curve of (time, value) is the Bezier curve of
 *
 *     BEZIER    P0, OUT_TANGENT 0, IN_TANGENT 1, P1                    control points
 *     HERMITE   P0, P0 + OUT_TANGENT 0 / 3, P1 - IN_TANGENT 1 / 3, P1  tangents per segment
 *     TCB       as HERMITE, of the tangents of Kochanek and Bartels
 *
 * Tangents without times have those of a third of the segment. Source: COLLADA 1.4.1 Specification, Khronos, 2008.
 */
#ifndef NAKAWARI_IMPORT_COLLADA_H
#define NAKAWARI_IMPORT_COLLADA_H

#include <libxml/tree.h>

#include <nakawari/handle.h>
#include <nakawari/transform.h>

#include "memory.h"

#define NKWI_COLLADA_NONE ((size_t)-1)

typedef enum nkwi_collada_kind {
    NKWI_COLLADA_TRANSLATE,
    NKWI_COLLADA_ROTATE,
    NKWI_COLLADA_SCALE,
    NKWI_COLLADA_MATRIX,
    NKWI_COLLADA_LOOKAT,
    NKWI_COLLADA_SKEW
} nkwi_collada_kind;

/* An element of a node's transform. */
typedef struct nkwi_collada_element {
    nkwi_collada_kind kind;
    const xmlNode *tag;
    float values[16];
    size_t channel; /* the first of the clip that is read; NKWI_COLLADA_NONE for none */
} nkwi_collada_element;

/* How a segment is computed. */
enum { NKWI_COLLADA_LINEAR, NKWI_COLLADA_STEP, NKWI_COLLADA_CUBIC };

typedef struct nkwi_collada_curve {
    size_t count, width; /* keys, numbers of a key */
    const float *times, *values;
    const unsigned char *kinds; /* of the segment from each key */
    const nkw_handle *out, *in; /* of each segment `width`; NULL where no segment is cubic */
    const nkw_trs *keys; /* of matrices without cubic segments; NULL otherwise */
} nkwi_collada_curve;

/* A curve of an element. */
typedef struct nkwi_collada_channel {
    size_t number; /* in the file */
    xmlNode *tag;
    const nkwi_collada_curve *curve; /* NULL: it is not read, and `reason` says why */
    const char *reason;
    size_t element, first; /* of elements; the first number of the element that is animated */
    size_t next; /* the next channel of the element in the clip that is read */
} nkwi_collada_channel;

typedef struct nkwi_collada_id {
    const char *text;
    xmlNode *tag;
    size_t order;
} nkwi_collada_id;

typedef struct nkwi_collada {
    xmlDoc *xml;
    nkwi_memory *memory; /* of all that follows */
    nkwi_collada_id *ids; /* sorted */
    size_t id_count;
    nkwi_collada_element *elements; /* those of a node are contiguous */
    size_t element_count;
    nkwi_collada_channel *channels; /* in the order of the file */
    size_t channel_count;
    size_t unread_kinds; /* curves with CARDINAL, BSPLINE and unknown segments, which are LINEAR */
    size_t bad_curves; /* whose times descend, or whose numbers are not finite */
    size_t no_tangents; /* with cubic segments without tangents, which are LINEAR */
    size_t flat_keys; /* matrices that have no rotation */
    size_t morphs; /* morph controllers */
    size_t infinities; /* curves that a tool continues outside of their keys by an extension */
    const char *fault; /* why it cannot be read: no memory, or the XML */
    int line; /* of the XML */
} nkwi_collada;

/* To be closed also after an error: 0, and c->fault. */
int nkwi_collada_begin(nkwi_collada *c, nkwi_memory *memory, const void *data, size_t bytes);
void nkwi_collada_end(nkwi_collada *c);

/* ---- the tree ---- */

int nkwi_collada_is(const xmlNode *tag, const char *name);
/* The first child of this name; the next sibling of this name. NULL for none. */
xmlNode *nkwi_collada_child(const xmlNode *tag, const char *name);
xmlNode *nkwi_collada_next(const xmlNode *tag, const char *name);
/* The tag after this one in the order of the file, below `top`; NULL after the last. */
xmlNode *nkwi_collada_walk(const xmlNode *top, const xmlNode *tag);
/* An attribute, or NULL. */
const char *nkwi_collada_text(const xmlNode *tag, const char *key);
/* The tag of this id; of a URL #id. NULL for none. */
xmlNode *nkwi_collada_find(const nkwi_collada *c, const char *id);
xmlNode *nkwi_collada_of_url(const nkwi_collada *c, const char *url);
/* The source of an input of this meaning; NULL for none. */
xmlNode *nkwi_collada_input(const nkwi_collada *c, const xmlNode *tag, const char *semantic);
/* The numbers of an element: at most `most`; the others stay. Returns how many there are. */
size_t nkwi_collada_numbers(const xmlNode *tag, float *out, size_t most);
/* The visual scene of the file, or NULL. */
xmlNode *nkwi_collada_scene(const nkwi_collada *c);

/* ---- animation (collada_curve.c, collada_channel.c) ---- */

/* The curve of a sampler. NULL, and *reason, where it has none; NULL in *reason without memory. */
const nkwi_collada_curve *nkwi_collada_curve_read(nkwi_collada *c, const xmlNode *sampler, const char **reason);
void nkwi_collada_sample(const nkwi_collada_curve *curve, float time, float *out);
/* The key at or before a time, and the part of its segment. */
size_t nkwi_collada_segment(const nkwi_collada_curve *curve, float time, float *part);

/* The channels of the file; 0 without memory. */
int nkwi_collada_channels(nkwi_collada *c);

/* ---- transforms (collada_node.c) ---- */

/* The elements of all nodes; 0 without memory. */
int nkwi_collada_elements(nkwi_collada *c);
/* Those of a node: the first, and how many. */
nkwi_collada_element *nkwi_collada_elements_of(const nkwi_collada *c, const xmlNode *node, size_t *count);
/* How many numbers an element of this kind has. */
size_t nkwi_collada_width(nkwi_collada_kind kind);
/* Key by key what matrices are; rotations that no matrix has are those of the key beside. NULL without memory. */
const nkw_trs *nkwi_collada_matrix_keys(nkwi_collada *c, const float *values, size_t count);
/*
 * The transform of a node at a time. `matrix`, if not NULL, is the exact product, of which the result lacks the shear.
 */
nkw_trs nkwi_collada_transform(const nkwi_collada *c, const nkwi_collada_element *list, size_t count, float time,
                               nkw_mat4 *matrix);
/* Whether an element of the list can change translation (0), rotation (1) or scale (2). */
int nkwi_collada_affects(const nkwi_collada_element *list, size_t count, size_t element, int part);

#endif
