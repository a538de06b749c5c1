/* SPDX-License-Identifier: MIT */
/* A document while it is read. */
#ifndef NAKAWARI_IMPORT_DOCUMENT_H
#define NAKAWARI_IMPORT_DOCUMENT_H

#include "fault.h"
#include "memory.h"

/* What nkw_document_close frees. `all` is the first member: a pointer to it is a pointer to the whole structure. */
typedef struct nkwi_document {
    nkw_document all;
    nkwi_memory memory;
    nkw_document_node *nodes; /* all.nodes, to be completed */
    float *rest_floats; /* all.rest_floats, the same */
    const char **warnings; /* all.warnings, the same */
    int v_is_up; /* nkw_import_memory.v_is_up */
    int wants_obj; /* whether `obj` is to be filled */
    nkw_obj obj;
} nkwi_document;

/* The most bytes that a document of `bytes` bytes of files may allocate. No valid file is known that needs more. */
#define NKWI_MEMORY_MOST(bytes) (((size_t)64 << 20) + ((bytes) < SIZE_MAX / 128 ? 64 * (bytes) : SIZE_MAX / 2))

/* nkwi_take, and the error where there is no memory. */
void *nkwi_document_take(nkwi_document *document, nkw_import_error *error, const nkwi_place *place, size_t count,
                         size_t size);

/* A copy of a text. NULL, and the error, where there is no memory. */
const char *nkwi_document_text(nkwi_document *document, nkw_import_error *error, const char *text);

/* A copy of the name; "KIND_NUMBER" where it is NULL or empty. */
const char *nkwi_document_name(nkwi_document *document, nkw_import_error *error, const char *name, const char *kind,
                               size_t number);

/*
 * The skeleton, the rest pose and the morph weights of `count` nodes: those of their meshes. `list` and `node_parents` are in the order of the
 * file; the nodes of the document are sorted. The skin of a node is that of the file. Places of errors are below
 * `place`.
 */
int nkwi_document_nodes(nkwi_document *document, nkw_import_error *error, const nkwi_place *place,
                        const nkw_document_node *list, const int32_t *node_parents, size_t count);

/* The boxes of all primitives. */
void nkwi_document_boxes(nkwi_document *document);

/* nkw_document_open and nkw_document_from_memory; with the arrays of OBJ if they are wanted. error is not NULL. */
nkw_import_result nkwi_document_open(const char *path, int wants_obj, nkw_document **document, nkw_import_error *error);
nkw_import_result nkwi_document_from_memory(const nkw_import_memory *memory, int wants_obj, nkw_document **document,
                                            nkw_import_error *error);

/* The folder of the memory as its reader, if it has none. The name of the folder is to be freed. */
int nkwi_document_reader(nkw_import_memory *memory, char **folder, nkw_import_error *error);

/*
 * Adds a warning: what is odd in the file, and how it is read. After NKWI_WARNINGS no more are added. Returns 0, and
 * the error, without memory.
 */
enum { NKWI_WARNINGS = 16 };
int nkwi_document_warn(nkwi_document *document, nkw_import_error *error, const char *format, ...) NKWI_PRINTS(3, 4);

/* glTF 2.0 (gltf.c): whether the first bytes are those of a glTF file, and reading it. */
int nkwi_gltf_is(const void *data, size_t bytes);
int nkwi_gltf_read(nkwi_document *document, const nkw_import_memory *memory, nkw_import_error *error);

/* BVH (bvh.c): the same. */
int nkwi_bvh_is(const void *data, size_t bytes);
int nkwi_bvh_read(nkwi_document *document, const nkw_import_memory *memory, nkw_import_error *error);

/* OBJ (obj.c): the same; and whether a file without such words is one by its extension. */
int nkwi_obj_is(const void *data, size_t bytes);
int nkwi_obj_is_named(const char *file);
int nkwi_obj_read(nkwi_document *document, const nkw_import_memory *memory, nkw_import_error *error);

/* Keys in CSV (keys.c): the same. */
int nkwi_keys_is(const void *data, size_t bytes);
int nkwi_keys_read(nkwi_document *document, const nkw_import_memory *memory, nkw_import_error *error);

/* Keys in JSON, which is parsed already: tables, and scenes. */
struct nkwi_value;
int nkwi_keys_are(const struct nkwi_value *root);
int nkwi_keys_read_tree(nkwi_document *document, const struct nkwi_value *root, nkw_import_error *error);

/* All other formats, if Assimp is there (assimp.c): whether an importer takes the file, and reading it. */
#if defined(NKWI_ASSIMP)
int nkwi_assimp_is(const nkw_import_memory *memory);
int nkwi_assimp_read(nkwi_document *document, const nkw_import_memory *memory, nkw_import_error *error);
#endif

#endif
