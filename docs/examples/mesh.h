/* SPDX-License-Identifier: MIT */
/**
 * @file
 * A mesh with four joints for each vertex: a capsule of our own making, or the triangles of a Wavefront .obj file.
 */
#ifndef MESH_H
#define MESH_H

#include <stddef.h>
#include <stdint.h>

#include <nakawari/types.h>

enum { MESH_INFLUENCES = 4, MESH_MESSAGE = 512 };

/** The lesson's SkeletalVertex, but for its texture coordinates. Weights are 0..65535 for 0..1. */
typedef struct mesh_vertex {
    nkw_vec3 position, normal;
    uint16_t joints[MESH_INFLUENCES], weights[MESH_INFLUENCES];
} mesh_vertex;

/** Three or four corners, counter-clockwise seen from outside. */
typedef struct mesh_face {
    size_t corner[4];
    int corners;
} mesh_face;

typedef struct mesh {
    mesh_vertex *vertices;
    mesh_face *faces;
    size_t vertex_count, face_count;
    size_t vertex_room, face_room;
} mesh;

/** A vertex without joints, a face. Give 0 if memory ran out. */
int mesh_add_vertex(mesh *m, nkw_vec3 position, nkw_vec3 normal);
int mesh_add_face(mesh *m, const size_t *corner, int corners);
void mesh_free(mesh *m);

/** The array with room for one more than `count` elements, or NULL if memory ran out: then it stays as it was. */
void *mesh_grow(void *array, size_t size, size_t count, size_t *room);

/** The smallest box, with its sides along the axes, that holds all vertices. */
void mesh_box(const mesh *m, nkw_vec3 *low, nkw_vec3 *high);

/** A capsule from y = 0 to y = 3, of radius 0.5. Gives 0 if memory ran out. */
int mesh_capsule(mesh *m);

/**
 * The faces of an .obj file: its lines v, vn and f are read, all others are not. Polygons of more than four corners (up
 * to 256) are cut into a fan; a face without normals gets its own. Gives 0, and in `message` the file, the line and
 * what is wrong there. mesh_free is due in either case.
 */
int mesh_read_obj(mesh *m, const char *path, char message[MESH_MESSAGE]);

#endif
