/* SPDX-License-Identifier: MIT */
/*
 * A glTF 2.0 file while it is read. Source: Khronos Group, glTF 2.0 Specification, 2021; sections are its sections.
 */
#ifndef NAKAWARI_IMPORT_GLTF_H
#define NAKAWARI_IMPORT_GLTF_H

#include "document.h"
#include "value.h"

/* Bytes of a buffer, once they are read. */
typedef struct nkwi_buffer {
    const unsigned char *data; /* NULL: not yet */
    size_t bytes;
} nkwi_buffer;

/* The component types of accessors (3.6.2.2). */
typedef enum nkwi_component {
    NKWI_I8 = 5120,
    NKWI_U8 = 5121,
    NKWI_I16 = 5122,
    NKWI_U16 = 5123,
    NKWI_U32 = 5125,
    NKWI_F32 = 5126
} nkwi_component;

/* Elements in a buffer: `count` of `size` bytes, `stride` bytes apart. data NULL: zeros. */
typedef struct nkwi_elements {
    const unsigned char *data;
    size_t count, size, stride;
} nkwi_elements;

/* An accessor, once it is used, and its numbers, once they are decoded. */
typedef struct nkwi_accessor {
    int is_open;
    nkwi_component component;
    int normalized;
    size_t width; /* components of an element */
    nkwi_elements elements;
    size_t sparse_count;
    nkwi_elements sparse_indices, sparse_values;
    nkwi_component sparse_component;
    float *floats;
    uint32_t *integers;
    uint16_t *shorts;
    int v_is_up; /* of floats that are texture coordinates */
} nkwi_accessor;

typedef struct nkwi_gltf {
    nkwi_document *document;
    nkw_import_error *error;
    const nkw_import_memory *memory;
    nkwi_memory scratch; /* until the file is read */
    nkwi_value root;
    nkwi_value buffer_list, view_list, accessor_list;
    const unsigned char *bin; /* the second chunk of a GLB, or NULL */
    size_t bin_bytes;
    size_t zeros; /* behind the JSON of a GLB */
    nkwi_buffer *buffers;
    nkwi_accessor *accessors;
    size_t node_count, mesh_count, skin_count, material_count, accessor_count;
    nkw_document_image *images; /* document->all.images, to be completed */
    unsigned char *image_is_read;
} nkwi_gltf;

/*
 * The tree of a file, with the flags of jansson, and the bytes of the GLB's second chunk; NULL after an error. Then the
 * lists of accessors, views and buffers. The tree and g->scratch are to be freed.
 */
json_t *nkwi_gltf_open(nkwi_gltf *g, nkwi_document *document, const nkw_import_memory *memory, size_t flags,
                       nkw_import_error *error);
int nkwi_gltf_begin(nkwi_gltf *g);

/* Scratch memory, and memory of the document. */
void *nkwi_gltf_scratch(nkwi_gltf *g, const nkwi_value *at, size_t count, size_t size);
void *nkwi_gltf_take(nkwi_gltf *g, const nkwi_value *at, size_t count, size_t size);

/* The name of an object of the file, or its default. NULL if there is no memory. */
const char *nkwi_gltf_name(nkwi_gltf *g, const nkwi_value *object, const char *kind);

/* The array `key` of the root, and its length; absent: 0 elements. */
int nkwi_gltf_list(nkwi_gltf *g, const char *key, nkwi_value *list, size_t *count);

/*
 * Reads the array `key` of the root: `count` elements of `size` bytes in memory of the document, each by `read`, which
 * returns 0 after an error. Returns the elements, or NULL after an error.
 */
typedef int (*nkwi_gltf_reader)(nkwi_gltf *g, const nkwi_value *object, void *element);
void *nkwi_gltf_each(nkwi_gltf *g, const char *key, size_t size, nkwi_gltf_reader read, size_t *count);

/* The bytes of a buffer (gltf_buffer.c). */
int nkwi_gltf_buffer(nkwi_gltf *g, size_t index, nkwi_buffer *out);

/* Integers as floats: only normalised ones, or any. */
typedef enum nkwi_integers { NKWI_NORMALIZED, NKWI_ANY } nkwi_integers;

/*
 * The numbers of the accessor that the member `key` of `object` names, in memory of the document; of accessors that are
 * used again the same. width is 1, 2, 3, 4 or 16 components. An absent member is an error.
 */
int nkwi_gltf_floats(nkwi_gltf *g, const nkwi_value *object, const char *key, size_t width, nkwi_integers integers,
                     const float **out, size_t *count);
/* The same of two components: texture coordinates, whose v is turned once if the document wants it upwards: 1 - v. */
int nkwi_gltf_texcoords(nkwi_gltf *g, const nkwi_value *object, const char *key, const float **out, size_t *count);
int nkwi_gltf_integers(nkwi_gltf *g, const nkwi_value *object, const char *key, const uint32_t **out, size_t *count);
int nkwi_gltf_shorts(nkwi_gltf *g, const nkwi_value *object, const char *key, const uint16_t **out, size_t *count);

/* The bytes of the buffer view that the member `bufferView` of `object` names. */
int nkwi_gltf_view(nkwi_gltf *g, const nkwi_value *object, const unsigned char **data, size_t *bytes);

/* The bytes of the elements of an accessor that was decoded. */
size_t nkwi_gltf_bytes(const nkwi_gltf *g, size_t accessor);

/* The images, without their data (gltf_image.c). */
int nkwi_gltf_images(nkwi_gltf *g);
/*
 * The image of the texture that the member `key` of `object` names, with its data or path; NULL without one. *set is the
 * set of texture coordinates.
 */
const nkw_document_image *nkwi_gltf_texture(nkwi_gltf *g, const nkwi_value *object, const char *key, size_t *set);

/* The parts of a file (gltf_node.c, gltf_mesh.c, gltf_animation.c), in this order. */
int nkwi_gltf_materials(nkwi_gltf *g);
int nkwi_gltf_meshes(nkwi_gltf *g);
int nkwi_gltf_nodes(nkwi_gltf *g);
int nkwi_gltf_skins(nkwi_gltf *g);
int nkwi_gltf_animations(nkwi_gltf *g);
int nkwi_gltf_scenes(nkwi_gltf *g);

#endif
