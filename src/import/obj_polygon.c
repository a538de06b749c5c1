/* SPDX-License-Identifier: MIT */
/* Triangles of polygons. */
#include <math.h>

#include "obj.h"

enum { CORNERS_MOST = 256 };

/* A polygon in the plane, counter-clockwise. */
typedef struct polygon {
    double at[CORNERS_MOST][2];
    uint32_t corners[CORNERS_MOST]; /* that are left */
    size_t count;
} polygon;

static nkw_vec3 place_of(const nkwi_obj *o, const nkwi_obj_element *e, size_t corner)
{
    const nkwi_obj_corner *corners = (const nkwi_obj_corner *)o->corners.data + e->first;
    const nkwi_obj_position *positions = (const nkwi_obj_position *)o->positions.data;
    return positions[corners[corner].at[OBJ_POSITION] - 1].at;
}

/* Twice the area, along the normal: the sum of (p_i - p_0) x (p_(i+1) - p_0). */
static void area_of(const nkwi_obj *o, const nkwi_obj_element *e, double *out)
{
    const nkw_vec3 p = place_of(o, e, 0);
    out[0] = out[1] = out[2] = 0.0;
    for (size_t i = 1; i + 1 < e->count; i++) {
        const nkw_vec3 a = place_of(o, e, i), b = place_of(o, e, i + 1);
        const double ax = (double)a.x - p.x, ay = (double)a.y - p.y, az = (double)a.z - p.z;
        const double bx = (double)b.x - p.x, by = (double)b.y - p.y, bz = (double)b.z - p.z;
        out[0] += ay * bz - az * by;
        out[1] += az * bx - ax * bz;
        out[2] += ax * by - ay * bx;
    }
}

/* The plane without the axis along which the area is largest. */
static void flatten(const nkwi_obj *o, const nkwi_obj_element *e, polygon *p)
{
    double area[3];
    area_of(o, e, area);
    int axis = fabs(area[1]) > fabs(area[0]) ? 1 : 0;
    axis = fabs(area[2]) > fabs(area[axis]) ? 2 : axis;
    const int is_back = area[axis] < 0.0;
    p->count = e->count;
    for (size_t i = 0; i < e->count; i++) {
        const nkw_vec3 v = place_of(o, e, i);
        const double all[3] = {v.x, v.y, v.z};
        p->at[i][is_back] = all[(axis + 1) % 3];
        p->at[i][!is_back] = all[(axis + 2) % 3];
        p->corners[i] = (uint32_t)i;
    }
}

/* Twice the signed area of a triangle of corners. */
static double side(const polygon *p, uint32_t a, uint32_t b, uint32_t c)
{
    const double *o = p->at[a];
    return (p->at[b][0] - o[0]) * (p->at[c][1] - o[1]) - (p->at[b][1] - o[1]) * (p->at[c][0] - o[0]);
}

static void neighbours(const polygon *p, size_t i, uint32_t *abc)
{
    abc[0] = p->corners[i > 0 ? i - 1 : p->count - 1];
    abc[1] = p->corners[i];
    abc[2] = p->corners[i + 1 < p->count ? i + 1 : 0];
}

static int is_convex(const polygon *p)
{
    uint32_t t[3];
    for (size_t i = 0; i < p->count; i++) {
        neighbours(p, i, t);
        if (side(p, t[0], t[1], t[2]) < 0.0)
            return 0;
    }
    return 1;
}

static int is_same_place(const polygon *p, uint32_t a, uint32_t b)
{
    return p->at[a][0] == p->at[b][0] && p->at[a][1] == p->at[b][1];
}

/* A corner that turns left, whose triangle has no other corner inside or on its sides. */
static int is_ear(const polygon *p, size_t i)
{
    uint32_t t[3];
    neighbours(p, i, t);
    if (!(side(p, t[0], t[1], t[2]) > 0.0))
        return 0;
    for (size_t k = 0; k < p->count; k++) {
        const uint32_t c = p->corners[k];
        if (is_same_place(p, c, t[0]) || is_same_place(p, c, t[1]) || is_same_place(p, c, t[2]))
            continue;
        if (side(p, t[0], t[1], c) >= 0.0 && side(p, t[1], t[2], c) >= 0.0 && side(p, t[2], t[0], c) >= 0.0)
            return 0;
    }
    return 1;
}

/* Without an ear, as of a polygon that crosses itself, any corner is cut. */
static void cut_ears(polygon *p, uint32_t *out)
{
    size_t i = 0;
    for (; p->count >= 3; out += 3) {
        size_t tried = 0;
        for (i %= p->count; tried < p->count && !is_ear(p, i); tried++)
            i = (i + 1) % p->count;
        neighbours(p, i, out);
        p->count--;
        for (size_t k = i; k < p->count; k++)
            p->corners[k] = p->corners[k + 1];
    }
}

static void fan(size_t count, uint32_t *out)
{
    for (size_t i = 1; i + 1 < count; i++, out += 3) {
        out[0] = 0;
        out[1] = (uint32_t)i;
        out[2] = (uint32_t)i + 1;
    }
}

void nkwi_obj_triangles(const nkwi_obj *o, const nkwi_obj_element *e, uint32_t *out)
{
    polygon p;
    if (e->count > 3 && e->count <= CORNERS_MOST) {
        flatten(o, e, &p);
        if (!is_convex(&p)) {
            cut_ears(&p, out);
            return;
        }
    }
    fan(e->count, out);
}
