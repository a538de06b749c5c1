/* SPDX-License-Identifier: MIT */
/* An OBJ file and its MTL file while they are written. */
#ifndef NAKAWARI_IMPORT_WRITE_OBJ_H
#define NAKAWARI_IMPORT_WRITE_OBJ_H

#include <nakawari/export.h>

#include "obj.h"

/* Bytes that grow. */
typedef struct nkwi_obj_bytes {
    char *data;
    size_t count, room;
} nkwi_obj_bytes;

typedef struct nkwi_obj_writer {
    const nkw_document *document;
    const nkw_obj_writing *writing;
    nkw_import_error *error;
    nkwi_document scratch; /* of names */
    nkwi_obj objects, materials; /* names in use */
    nkwi_obj_table positions, texcoords, normals, colors; /* of the bits of their numbers */
    nkwi_obj_bytes lines, material_lines;
    uint32_t *material_names; /* material_count and one more: of none */
    int32_t material; /* of the last usemtl; OBJ_NO_USEMTL at the start */
    nkw_mat4 *models, *palette; /* room for all joints, for the largest skin */
    nkw_vec3 *vertices, *directions; /* room for the largest primitive: positions, normals */
    nkwi_obj_corner *corners; /* the same */
} nkwi_obj_writer;

enum { OBJ_NO_USEMTL = -2 };

/* Appends text, words and numbers. Returns 0, and the error, without memory. */
int nkwi_obj_put(nkwi_obj_writer *w, nkwi_obj_bytes *to, const char *text);
/* A word and numbers after it, each after a space, to the end of the line. */
int nkwi_obj_put_floats(nkwi_obj_writer *w, nkwi_obj_bytes *to, const char *word, const float *numbers, size_t count);

/* The number of a name in `names` that no other has: without blanks, and _INDEX after it if it was in use. */
int nkwi_obj_unique(nkwi_obj_writer *w, nkwi_obj *names, const char *name, size_t index, uint32_t *number);

/* Names, and newmtl, Kd, d and map_Kd of each material (write_obj_material.c). */
int nkwi_obj_put_materials(nkwi_obj_writer *w);

#endif
