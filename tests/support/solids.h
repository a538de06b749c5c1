/* SPDX-License-Identifier: MIT */
/* Small closed meshes, for C and C++: positions and indices in fixed arrays. */
#ifndef NAKAWARI_TESTS_SOLIDS_H
#define NAKAWARI_TESTS_SOLIDS_H

#include <nakawari/nakawari.h>

enum { SOLID_VERTICES = 128, SOLID_TRIANGLES = 256 };

typedef struct solid {
    nkw_vec3 positions[SOLID_VERTICES];
    uint32_t indices[3 * SOLID_TRIANGLES];
    size_t vertex_count, triangle_count;
} solid;

static inline nkw_mesh solid_mesh(const solid *s)
{
    nkw_mesh mesh = {s->positions, s->vertex_count, s->indices, s->triangle_count};
    return mesh;
}

static inline void solid_triangle(solid *s, size_t a, size_t b, size_t c)
{
    uint32_t *to = s->indices + 3 * s->triangle_count++;
    to[0] = (uint32_t)a, to[1] = (uint32_t)b, to[2] = (uint32_t)c;
}

/* Counter-clockwise; the diagonal is from a to c, or from b to d. */
static inline void solid_quad(solid *s, const uint32_t corners[4], int other_diagonal)
{
    const uint32_t *q = corners;
    if (other_diagonal) {
        solid_triangle(s, q[0], q[1], q[3]);
        solid_triangle(s, q[1], q[2], q[3]);
    } else {
        solid_triangle(s, q[0], q[1], q[2]);
        solid_triangle(s, q[0], q[2], q[3]);
    }
}

/* Vertex i is at -1 or 1 by its bits; face f has the diagonal of bit f. Faces -x x -y y -z z. */
static inline void solid_cube(solid *s, unsigned diagonals)
{
    static const uint32_t faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    s->vertex_count = 8;
    s->triangle_count = 0;
    for (unsigned i = 0; i < 8; i++) {
        nkw_vec3 p = {i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f};
        s->positions[i] = p;
    }
    for (unsigned f = 0; f < 6; f++)
        solid_quad(s, faces[f], (int)(diagonals >> f & 1));
}

#endif
