/* SPDX-License-Identifier: MIT */
/* OBJ while it is read. */
#ifndef NAKAWARI_IMPORT_OBJ_H
#define NAKAWARI_IMPORT_OBJ_H

#include "document.h"

/* The lines of an OBJ or MTL file. A backslash at the end of a line joins it and the next one. */
typedef struct nkwi_obj_text {
    const char *at, *end; /* what is left */
    size_t line; /* from 1 */
} nkwi_obj_text;

typedef struct nkwi_obj_word {
    const char *text;
    size_t length;
} nkwi_obj_word;

typedef struct nkwi_obj_list {
    void *data;
    size_t count, room; /* elements */
} nkwi_obj_list;

/* The numbers 0, 1, 2 ... of keys, in the order of their first appearance. */
typedef struct nkwi_obj_key {
    uint32_t parts[4];
} nkwi_obj_key;

typedef struct nkwi_obj_table {
    nkwi_obj_list keys; /* nkwi_obj_key */
    uint32_t *slots; /* 1 more than the number of a key; 0: empty */
    size_t room; /* slots: a power of two */
} nkwi_obj_table;

typedef struct nkwi_obj_position {
    nkw_vec3 at;
    float color[3];
    int has_color;
} nkwi_obj_position;

typedef struct nkwi_obj_texcoord {
    float at[2]; /* v downwards */
} nkwi_obj_texcoord;

/* Of a face, a line or a point: numbers of its position, texture coordinate and normal, from 1; 0: none. */
enum { OBJ_POSITION, OBJ_TEXCOORD, OBJ_NORMAL, OBJ_ATTRIBUTES };
typedef struct nkwi_obj_corner {
    uint32_t at[OBJ_ATTRIBUTES];
    uint32_t vertex; /* of the primitive of its element */
} nkwi_obj_corner;

typedef struct nkwi_obj_element {
    nkw_document_topology topology;
    size_t first, count; /* corners */
    size_t line;
    uint32_t part; /* of nkwi_obj.parts */
    int32_t material;
    uint32_t primitive;
} nkwi_obj_element;

typedef struct nkwi_obj_material {
    uint32_t name, image; /* of nkwi_obj.names; image 0: none */
    float color[4];
    int is_defined, has_d;
} nkwi_obj_material;

typedef struct nkwi_obj {
    nkwi_document *document;
    nkw_import_error *error;
    const nkw_import_memory *memory;
    nkwi_obj_text text;
    nkwi_obj_list positions, texcoords, normals; /* nkwi_obj_position, nkwi_obj_texcoord, nkw_vec3 */
    nkwi_obj_list corners, elements; /* nkwi_obj_corner, nkwi_obj_element */
    nkwi_obj_list names; /* const char *, of the document; 0 is empty */
    nkwi_obj_table name_table; /* their hashes */
    nkwi_obj_list materials; /* nkwi_obj_material */
    nkwi_obj_table material_table, parts, libraries; /* keys: names; object and group; names */
    uint32_t object, group; /* names: those of the next elements */
    int32_t material; /* the same */
    size_t short_count; /* faces and lines with too few corners */
    size_t unread_count, unread_line; /* lines that are not read, and the first of them */
    int misses_library;
} nkwi_obj;

/* ---- Words (obj.c) ---- */

/* The next word of the line; 0 at its end, and at a comment. */
int nkwi_obj_next(nkwi_obj_text *t, nkwi_obj_word *w);
/* The rest of the line: a name with spaces. A comment in it begins with a # between spaces. */
nkwi_obj_word nkwi_obj_rest(nkwi_obj_text *t);
void nkwi_obj_skip_line(nkwi_obj_text *t);
int nkwi_obj_same(nkwi_obj_word w, const char *text);

/* ---- Lists and tables (obj_table.c). Without memory they return 0, and the error. ---- */

/* A new element of `size` bytes, all zero, at the end. */
void *nkwi_obj_add(nkwi_obj *o, nkwi_obj_list *list, size_t size);
/* The number of a key, which is added if it is new: then it is the last one. */
int nkwi_obj_number(nkwi_obj *o, nkwi_obj_table *table, const nkwi_obj_key *key, uint32_t *number);
/* The number of a name, in UTF-8. */
int nkwi_obj_name(nkwi_obj *o, nkwi_obj_word name, uint32_t *number);
const char *nkwi_obj_name_of(const nkwi_obj *o, uint32_t name);
void nkwi_obj_give(nkwi_obj_table *table);

/* ---- Materials (obj_material.c) ---- */

/* The material of a name, which is added if it is new. */
int nkwi_obj_material_of(nkwi_obj *o, nkwi_obj_word name, int32_t *material);
/* The files of a line mtllib. What is wrong with them is a warning. */
int nkwi_obj_library(nkwi_obj *o);
int nkwi_obj_materials(nkwi_obj *o);

/* ---- The document (obj_document.c), and triangles (obj_polygon.c) ---- */

int nkwi_obj_document(nkwi_obj *o);

/* The arrays of the file (obj_arrays.c), after the document: the numbers of corners are valid then. */
int nkwi_obj_arrays(nkwi_obj *o);

/*
 * The count - 2 triangles of a polygon, as three numbers of its corners each. Convex ones become a fan about the first
 * corner; others of at most 256 corners are cut ear by ear in the plane that they are nearest to.
 * Source: Meisters, Polygons Have Ears, 1975; the normal: Sutherland, Sproull, Schumacker (Newell), 1974.
 */
void nkwi_obj_triangles(const nkwi_obj *o, const nkwi_obj_element *e, uint32_t *out);

/* An error in a line. */
int nkwi_obj_fail(const nkwi_obj *o, size_t line, const char *format, ...) NKWI_PRINTS(3, 4);

#endif
