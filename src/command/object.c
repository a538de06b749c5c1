/* SPDX-License-Identifier: MIT */
#include "object.h"

#include <stdlib.h>
#include <string.h>

#include <nakawari/scalar.h>

#include "command.h"

/* Triangles without a material. */
#define GREY 0xb8bcc6

static svg_colour colour_of(const nkw_document *d, int32_t material)
{
    svg_colour colour = 0;
    if (material == NKW_NO_JOINT)
        return GREY;
    for (int i = 0; i < 3; i++)
        colour = 256 * colour + (svg_colour)(nkw_clamp(d->materials[material].color[i], 0.0f, 1.0f) * 255.0f + 0.5f);
    return colour;
}

static int is_drawn(const nkw_document_primitive *p)
{
    return p->topology == NKW_DOCUMENT_TRIANGLES && p->positions;
}

static size_t count_triangles(const nkw_document *d)
{
    size_t count = 0;
    for (size_t i = 0; i < d->mesh_count; i++)
        for (size_t k = 0; k < d->meshes[i].primitive_count; k++)
            if (is_drawn(&d->meshes[i].primitives[k]))
                count += d->meshes[i].primitives[k].index_count / 3;
    return count;
}

/* Returns the end of what it has written. */
static object_triangle *add_primitive(object_triangle *t, const nkw_document *d, const nkw_document_primitive *p)
{
    const svg_colour colour = colour_of(d, p->material);
    for (size_t i = 0; i + 2 < p->index_count; i += 3, t++) {
        t->colour = colour;
        for (size_t k = 0; k < 3; k++)
            t->corner[k] = p->positions[p->indices[i + k]];
    }
    return t;
}

/* The nodes of an OBJ file have no matrix. */
static int read_triangles(object_model *model, const nkw_document *d)
{
    const size_t count = count_triangles(d);
    if (strcmp(d->format, "OBJ") != 0)
        return output_complain(d, NULL, "--object is a file .obj");
    if (count == 0)
        return output_complain(d, NULL, "has no faces");
    if (count > OBJECT_TRIANGLES_MAX)
        return output_complain(d, NULL, "has more than 10000 triangles");
    object_triangle *triangles = malloc(count * sizeof *triangles), *t = triangles;
    if (!triangles)
        return output_complain(d, NULL, "no memory");
    for (size_t i = 0; i < d->mesh_count; i++)
        for (size_t k = 0; k < d->meshes[i].primitive_count; k++)
            if (is_drawn(&d->meshes[i].primitives[k]))
                t = add_primitive(t, d, &d->meshes[i].primitives[k]);
    const object_result result = object_build(model, triangles, count);
    free(triangles);
    return result == OBJECT_OK ||
           output_complain(d, NULL, result == OBJECT_NO_SIZE ? "its faces have no size" : "no memory");
}

int object_open(object_model *model, const char *path)
{
    memset(model, 0, sizeof *model);
    model->name = input_name(path);
    nkw_document *d = input_open(path);
    const int done = d && read_triangles(model, d);
    input_close(d);
    return done;
}
