/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Writes a binary glTF 2.0 file: a buffer of numbers that grows, accessors of it, and the JSON that the caller prints.
 */
#ifndef GLB_H
#define GLB_H

#include <stddef.h>
#include <stdint.h>

/** Bytes that grow. Once memory runs out they stay as they were, and `failed` is 1. */
typedef struct glb_bytes {
    unsigned char *data;
    size_t size, room;
    int failed;
} glb_bytes;

void glb_append(glb_bytes *b, const void *data, size_t size);
/** Appends text as printf prints it, at most 1023 characters. */
void glb_print(glb_bytes *b, const char *format, ...);
void glb_free(glb_bytes *b);

/** The parts of a file while it is built; zeroed at the start. */
typedef struct glb {
    glb_bytes buffer, views, accessors;
    size_t view_count, accessor_count;
} glb;

/** glTF's component types. */
enum { GLB_U8 = 5121, GLB_U16 = 5123, GLB_F32 = 5126 };

/** What an accessor says of its elements. */
typedef struct glb_layout {
    int component;
    const char *type; /* "SCALAR", "VEC3" ... */
    int normalized;
} glb_layout;

/** Appends `count` numbers of `width` bytes as a buffer view, aligned to four bytes. Returns its index. */
size_t glb_view(glb *g, const void *data, size_t width, size_t count);
/** An accessor of `count` elements in a separate view. `extra`: further JSON members, each after a comma, or "". */
size_t glb_accessor(glb *g, glb_layout layout, size_t count, const void *data, size_t size, const char *extra);
/** An accessor of vec3 zeros, except at the `changed` elements that `indices` names. */
size_t glb_sparse_vec3(glb *g, size_t count, size_t changed, const uint16_t *indices, const float *values,
                       const char *extra);

/** Writes header, JSON and buffer. Returns 0 if it cannot; errno says why. */
int glb_write(const char *path, const glb_bytes *json, const glb_bytes *buffer);

#endif
