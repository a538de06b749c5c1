/* SPDX-License-Identifier: MIT */
#include "mesh.h"

#include <stdlib.h>

#include <nakawari/scalar.h>
#include <nakawari/vec.h>

void *mesh_grow(void *array, size_t size, size_t count, size_t *room)
{
    if (count < *room)
        return array;
    size_t more = *room ? 2 * *room : 256;
    void *moved = more <= (size_t)-1 / size ? realloc(array, more * size) : NULL;
    if (moved)
        *room = more;
    return moved;
}

int mesh_add_vertex(mesh *m, nkw_vec3 position, nkw_vec3 normal)
{
    mesh_vertex v = {position, normal, {0}, {0}}, *moved;
    moved = mesh_grow(m->vertices, sizeof v, m->vertex_count, &m->vertex_room);
    if (!moved)
        return 0;
    m->vertices = moved;
    m->vertices[m->vertex_count++] = v;
    return 1;
}

int mesh_add_face(mesh *m, const size_t *corner, int corners)
{
    mesh_face f = {{0}, corners}, *moved;
    moved = mesh_grow(m->faces, sizeof f, m->face_count, &m->face_room);
    if (!moved)
        return 0;
    for (int i = 0; i < corners; i++)
        f.corner[i] = corner[i];
    m->faces = moved;
    m->faces[m->face_count++] = f;
    return 1;
}

void mesh_free(mesh *m)
{
    const mesh empty = {NULL, NULL, 0, 0, 0, 0};
    free(m->vertices);
    free(m->faces);
    *m = empty;
}

void mesh_box(const mesh *m, nkw_vec3 *low, nkw_vec3 *high)
{
    *low = *high = m->vertex_count ? m->vertices[0].position : NKW_VEC3_ZERO;
    for (size_t i = 1; i < m->vertex_count; i++) {
        *low = nkw_vec3_min(*low, m->vertices[i].position);
        *high = nkw_vec3_max(*high, m->vertices[i].position);
    }
}

/* ---- the capsule ---- */

/* Rings from the lower pole to the upper one: CAP in each half ball, SIDE steps between them. */
enum { AROUND = 16, CAP = 4, SIDE = 12, RINGS = 2 * CAP + SIDE + 1 };
static const float radius = 0.5f, straight = 2.0f, pi = 3.14159265f;

/* The angle of a ring above its half ball's rim, -90 to 90 degrees, and the height of that ball's centre. */
static float ring_angle(int ring, float *centre)
{
    int above = ring - CAP - SIDE, below = ring - CAP;
    *centre = radius + straight * nkw_clamp((float)below / (float)SIDE, 0.0f, 1.0f);
    return 0.5f * pi / (float)CAP * (float)(above > 0 ? above : below < 0 ? below : 0);
}

static int add_ring(mesh *m, int ring)
{
    float centre, angle = ring_angle(ring, &centre);
    for (int i = 0; i < AROUND; i++) {
        float turn = 2.0f * pi * (float)i / (float)AROUND;
        nkw_vec3 normal = {nkw_cos(angle) * nkw_sin(turn), nkw_sin(angle), nkw_cos(angle) * nkw_cos(turn)};
        nkw_vec3 position = nkw_vec3_scale(normal, radius);
        position.y += centre;
        if (!mesh_add_vertex(m, position, normal))
            return 0;
    }
    return 1;
}

/* The faces between a ring and the next: at the poles, where a ring is one point, triangles. */
static int add_band(mesh *m, int ring)
{
    int ok = 1;
    for (int i = 0; i < AROUND; i++) {
        size_t low = (size_t)ring * AROUND + (size_t)i, low_next = (size_t)ring * AROUND + (size_t)((i + 1) % AROUND);
        size_t corner[4] = {low, low_next, low_next + AROUND, low + AROUND};
        if (ring == 0)
            corner[1] = corner[2], corner[2] = corner[3];
        ok &= mesh_add_face(m, corner, ring == 0 || ring == RINGS - 2 ? 3 : 4);
    }
    return ok;
}

int mesh_capsule(mesh *m)
{
    int ok = 1;
    for (int ring = 0; ring < RINGS; ring++)
        ok &= add_ring(m, ring);
    for (int ring = 0; ring + 1 < RINGS; ring++)
        ok &= add_band(m, ring);
    return ok;
}
