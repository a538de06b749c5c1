/* SPDX-License-Identifier: MIT */
/* Meshes of a document that are changed on request. */
#ifndef NAKAWARI_IMPORT_PREPARE_H
#define NAKAWARI_IMPORT_PREPARE_H

#include "document.h"

typedef struct nkwi_prepare {
    nkwi_document *document;
    nkw_import_error *error;
    const nkw_document_preparation *wanted;
    nkw_document_mesh *meshes; /* all.meshes, whose primitives are copies */
    nkwi_memory scratch; /* of one primitive */
    size_t turned, conflicts, branches; /* triangles, edges */
    size_t primitives, normals, tangents, without_texcoords; /* primitives of triangles */
} nkwi_prepare;

/* nkwi_take of the scratch, and the error where there is no memory. */
void *nkwi_prepare_scratch(nkwi_prepare *p, size_t count, size_t size);

/* Multiplies vertices by the transforms of their nodes (prepare_transform.c). Returns 0, and the error. */
int nkwi_prepare_transforms(nkwi_prepare *p);

#endif
