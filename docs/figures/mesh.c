/* SPDX-License-Identifier: MIT */
/* The normals of a cylinder by three creases. */
#include "figure.h"

#include <nakawari/mat.h>
#include <nakawari/mesh.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

enum { SIDES = 12, TRIANGLES = 4 * SIDES - 4 };

typedef struct cylinder {
    nkw_vec3 positions[2 * SIDES];
    uint32_t indices[3 * TRIANGLES];
    nkw_vec3 normals[3 * TRIANGLES];
} cylinder;

static void add_triangle(cylinder *c, size_t t, size_t x, size_t y, size_t z)
{
    const size_t corners[3] = {x, y, z};
    for (size_t k = 0; k < 3; k++)
        c->indices[3 * t + k] = (uint32_t)corners[k];
}

/* The axis is y. */
static void make_cylinder(cylinder *c, float crease)
{
    static double memory[NKW_MESH_WORK(TRIANGLES) / sizeof(double) + 2];
    unsigned char *start = (unsigned char *)memory;
    const nkw_work work = {start + (16 - (size_t)start % 16) % 16, NKW_MESH_WORK(TRIANGLES)};
    const nkw_mesh mesh = {c->positions, (size_t)2 * SIDES, c->indices, TRIANGLES};
    size_t t = 0;
    for (size_t i = 0; i < SIDES; i++) {
        const float angle = 6.2831853f * ((float)i + 0.5f) / (float)SIDES;
        const nkw_vec3 low = {nkw_sin(angle), -0.9f, nkw_cos(angle)}, high = {low.x, 0.9f, low.z};
        const size_t j = (i + 1) % SIDES;
        c->positions[i] = low;
        c->positions[SIDES + i] = high;
        add_triangle(c, t++, i, j, SIDES + j);
        add_triangle(c, t++, i, SIDES + j, SIDES + i);
    }
    for (size_t i = 2; i < SIDES; i++) {
        add_triangle(c, t++, 0, i, i - 1);
        add_triangle(c, t++, SIDES, SIDES + i - 1, SIDES + i);
    }
    nkw_mesh_normals(&mesh, crease, c->normals, NULL, work);
}

/* Lambert's law for a lamp above the left shoulder; the colour of the face by the mean of its normals. */
static svg_colour shade(const nkw_vec3 *normals)
{
    const nkw_vec3 lamp = {-0.48f, 0.64f, 0.6f};
    const nkw_vec3 mean = nkw_vec3_normalize(nkw_vec3_add(nkw_vec3_add(normals[0], normals[1]), normals[2]));
    const float light = 0.55f + 0.43f * nkw_max(0.0f, nkw_vec3_dot(mean, lamp));
    const unsigned grey = (unsigned)(255.0f * light);
    return (svg_colour)(grey << 16 | grey << 8 | grey);
}

static void draw_cylinder(svg *s, svg_point centre, float crease, const char *name, const char *meaning)
{
    static cylinder c;
    const nkw_mat4 view = figure_view(0.35f, 0.5f);
    const svg_camera camera = svg_orthographic(&view, centre, 88.0f);
    space_list list = {NULL, 0, 0, 0};
    make_cylinder(&c, crease);
    for (size_t t = 0; t < TRIANGLES; t++) {
        nkw_vec3 corners[3], middle = {0.0f, 0.0f, 0.0f};
        for (size_t k = 0; k < 3; k++) {
            corners[k] = c.positions[c.indices[3 * t + k]];
            middle = nkw_vec3_add(middle, nkw_vec3_scale(corners[k], 1.0f / 3.0f));
        }
        const svg_paint face = svg_fill(shade(c.normals + 3 * t), 1.0f),
                        needle = svg_stroke(FIGURE_HERMITE, 1.6f, 1.0f);
        space_add(&list, &camera, corners, 3, -nkw_mat4_transform_point(&camera.view, middle).z, &face);
        for (size_t k = 0; k < 3; k++) {
            const nkw_vec3 line[2] = {corners[k],
                                      nkw_vec3_add(corners[k], nkw_vec3_scale(c.normals[3 * t + k], 0.45f))};
            space_add(&list, &camera, line, 2, -nkw_mat4_transform_point(&camera.view, line[1]).z, &needle);
        }
    }
    space_paint(&list, s);
    figure_bold(s, centre.x, centre.y + 190.0f, 16.0f, FIGURE_INK, 'm', name);
    figure_text(s, centre.x, centre.y + 212.0f, 14.0f, FIGURE_GREY, 'm', meaning);
}

int figure_mesh_normals(const char *path)
{
    svg s;
    if (!figure_open(
            &s, path, 980.0f, 500.0f, "The normals of a cylinder of 12 sides, by the crease",
            "Sides meet at 30 degrees, sides and caps at 90. A needle is the normal of a corner; where normals "
            "differ, a vertex is split."))
        return 0;
    draw_cylinder(&s, svg_at(175.0f, 262.0f), 0.0f, "crease 0", "flat: 3 normals at each position");
    draw_cylinder(&s, svg_at(490.0f, 262.0f), nkw_radians_from_degrees(45.0f), "crease 45 degrees",
                  "smooth around, hard at the caps: 2 normals");
    draw_cylinder(&s, svg_at(805.0f, 262.0f), nkw_radians_from_degrees(180.0f), "crease 180 degrees",
                  "smooth everywhere: 1 normal");
    return svg_close(&s);
}
