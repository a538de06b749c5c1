/* SPDX-License-Identifier: MIT */
/*
 * The tree of an FBX file of version 7100 to 7700, binary or text: nodes with values and nodes below. Names, texts and
 * arrays remain in the file, which must outlive the tree; arrays are decoded when they are asked for.
 */
#ifndef NAKAWARI_IMPORT_FBX_TREE_H
#define NAKAWARI_IMPORT_FBX_TREE_H

#include <stdint.h>

#include "memory.h"

#define NKWI_FBX_NONE SIZE_MAX
enum { NKWI_FBX_DEPTH = 64 };

typedef struct nkwi_fbx_value {
    char kind; /* I integer, R real, S text, A array */
    char element; /* of an array, as in the file: i l f d b c; t: decimal numbers with commas between */
    int is_packed; /* an array that zlib compressed */
    int64_t integer; /* an integer; a real is cut to one; of an array the number of elements */
    double real; /* a number */
    const char *text; /* of texts and arrays: `bytes` bytes of the file */
    size_t bytes;
} nkwi_fbx_value;

typedef struct nkwi_fbx_node {
    const char *name;
    size_t name_length;
    size_t first, value_count; /* values[first] .. */
    size_t child, next; /* the first node below, the next one beside; or NKWI_FBX_NONE */
} nkwi_fbx_node;

typedef struct nkwi_fbx_tree {
    nkwi_fbx_node *nodes;
    size_t node_count, node_room;
    nkwi_fbx_value *values;
    size_t value_count, value_room;
    size_t root; /* the first node of the file, or NKWI_FBX_NONE */
    uint32_t version; /* 7400 */
    int is_text, is_big; /* is_big: the most significant byte first */
    const char *fault; /* why the file cannot be read; NULL */
    size_t at; /* byte of the fault */
    /* While it is read: the open nodes. */
    size_t depth, last[NKWI_FBX_DEPTH + 1]; /* the last node of each depth, or NKWI_FBX_NONE */
} nkwi_fbx_tree;

/* Reads a tree, to be closed also after an error. Returns 0 after an error, which is tree->fault. */
int nkwi_fbx_open(nkwi_fbx_tree *tree, const void *data, size_t bytes);
void nkwi_fbx_close(nkwi_fbx_tree *tree);

/* The first node of this name from `node` on, itself or beside it; NKWI_FBX_NONE. */
size_t nkwi_fbx_find(const nkwi_fbx_tree *tree, size_t node, const char *name);
/* The first node of this name below `node`. */
size_t nkwi_fbx_below(const nkwi_fbx_tree *tree, size_t node, const char *name);
/* The value of a node; NULL where it has none. */
const nkwi_fbx_value *nkwi_fbx_at(const nkwi_fbx_tree *tree, size_t node, size_t value);
int nkwi_fbx_is(const nkwi_fbx_tree *tree, size_t node, const char *name);
/* Whether a value is this text. */
int nkwi_fbx_equals(const nkwi_fbx_value *value, const char *text);

/*
 * The numbers of the array of a node, or its plain numbers. Integers beyond 2^53 are rounded. Returns NULL, and
 * the count 0, for a node without numbers; the same, and tree->fault, for an array that is damaged, or without memory.
 */
double *nkwi_fbx_numbers(nkwi_fbx_tree *tree, size_t node, nkwi_memory *memory, size_t *count);

/* Of the readers of both forms. */
int nkwi_fbx_fail(nkwi_fbx_tree *tree, size_t at, const char *fault);
int nkwi_fbx_add_node(nkwi_fbx_tree *tree, const char *name, size_t length); /* at the depth */
int nkwi_fbx_add_value(nkwi_fbx_tree *tree, const nkwi_fbx_value *value); /* to the last node */
int nkwi_fbx_read_binary(nkwi_fbx_tree *tree, const unsigned char *data, size_t bytes);
int nkwi_fbx_read_text(nkwi_fbx_tree *tree, const char *data, size_t bytes);
/* The bytes of a binary array, unpacked if it is packed, as numbers (fbx_binary.c). */
int nkwi_fbx_unpack(nkwi_fbx_tree *tree, const nkwi_fbx_value *value, nkwi_memory *memory, double *out);
/* The numbers of a text array: at most `room`; returns how many there are (fbx_text.c). */
size_t nkwi_fbx_scan(const nkwi_fbx_value *value, double *out, size_t room);

#endif
