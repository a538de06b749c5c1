/* SPDX-License-Identifier: MIT */
/* OBJ with its own arrays: positions, texture coordinates and normals have numbers of their own. */
#include <math.h>
#include <string.h>

#include <nakawari/box.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

#include "obj.h"

static void *take(const nkwi_obj *o, size_t count, size_t size)
{
    return nkwi_document_take(o->document, o->error, NULL, count, size);
}

static int copy_lines(const nkwi_obj *o, nkw_obj *out)
{
    out->position_count = o->positions.count;
    out->texcoord_count = o->texcoords.count;
    out->normal_count = o->normals.count;
    out->positions = (nkw_vec3 *)take(o, out->position_count, sizeof *out->positions);
    out->texcoords = (float *)take(o, out->texcoord_count, 2 * sizeof *out->texcoords);
    out->normals = (nkw_vec3 *)take(o, out->normal_count, sizeof *out->normals);
    if (!out->positions || !out->texcoords || !out->normals)
        return 0;
    for (size_t i = 0; i < out->position_count; i++)
        out->positions[i] = ((const nkwi_obj_position *)o->positions.data)[i].at;
    for (size_t i = 0; i < out->texcoord_count; i++)
        memcpy(out->texcoords + 2 * i, (const nkwi_obj_texcoord *)o->texcoords.data + i, sizeof(nkwi_obj_texcoord));
    if (out->normal_count)
        memcpy(out->normals, o->normals.data, out->normal_count * sizeof *out->normals);
    return 1;
}

/* Numbers from 1 become numbers from 0, and 0 NKW_OBJ_NONE. */
static int copy_triangles(const nkwi_obj *o, nkw_obj *out)
{
    const nkwi_obj_element *elements = (const nkwi_obj_element *)o->elements.data;
    size_t count = 0;
    for (size_t i = 0; i < o->elements.count; i++)
        count += elements[i].topology == NKW_DOCUMENT_TRIANGLES ? elements[i].count - 2 : 0;
    uint32_t *positions = (uint32_t *)take(o, count, 3 * sizeof *positions);
    uint32_t *texcoords = (uint32_t *)take(o, count, 3 * sizeof *texcoords);
    uint32_t *normals = (uint32_t *)take(o, count, 3 * sizeof *normals);
    int32_t *materials = (int32_t *)take(o, count, sizeof *materials);
    if (!positions || !texcoords || !normals || !materials)
        return 0;
    out->position_indices = positions;
    out->texcoord_indices = texcoords;
    out->normal_indices = normals;
    out->materials = materials;
    for (size_t i = 0; i < o->elements.count; i++) {
        const nkwi_obj_element *e = &elements[i];
        const nkwi_obj_corner *corners = (const nkwi_obj_corner *)o->corners.data + e->first;
        if (e->topology != NKW_DOCUMENT_TRIANGLES)
            continue;
        nkwi_obj_triangles(o, e, positions);
        for (size_t k = 0; k < 3 * (e->count - 2); k++) {
            const nkwi_obj_corner *c = &corners[*positions];
            *positions++ = c->at[OBJ_POSITION] - 1;
            *texcoords++ = c->at[OBJ_TEXCOORD] - 1;
            *normals++ = c->at[OBJ_NORMAL] - 1;
        }
        for (size_t k = 2; k < e->count; k++)
            *materials++ = e->material;
    }
    out->triangle_count = count;
    return 1;
}

int nkwi_obj_arrays(nkwi_obj *o)
{
    nkw_obj *out = &o->document->obj;
    out->document = &o->document->all;
    return copy_lines(o, out) && copy_triangles(o, out);
}

/* ---- Opening ---- */

static nkw_import_result arrays_of(nkw_document *document, nkw_obj **obj, nkw_import_error *error)
{
    nkwi_document *d = (nkwi_document *)(void *)document;
    if (d && d->obj.document)
        *obj = &d->obj;
    else if (d) {
        nkwi_fail(error, NULL, NKW_IMPORT_UNSUPPORTED, "the format is %s, not OBJ", document->format);
        nkw_document_close(document);
    }
    return error->code;
}

nkw_import_result nkw_obj_open(const char *path, nkw_obj **obj, nkw_import_error *error)
{
    nkw_import_error other;
    nkw_document *document;
    error = error ? error : &other;
    *obj = NULL;
    nkwi_document_open(path, 1, &document, error);
    return arrays_of(document, obj, error);
}

nkw_import_result nkw_obj_from_memory(const nkw_import_memory *memory, nkw_obj **obj, nkw_import_error *error)
{
    nkw_import_error other;
    nkw_document *document;
    error = error ? error : &other;
    *obj = NULL;
    nkwi_document_from_memory(memory, 1, &document, error);
    return arrays_of(document, obj, error);
}

void nkw_obj_close(nkw_obj *obj)
{
    if (obj)
        nkw_document_close(obj->document);
}

/* ---- Scaling ---- */

static nkw_vec3 size_of(const nkw_obj *obj)
{
    const nkw_vec3 none = {0.0f, 0.0f, 0.0f};
    const nkw_box box = nkw_box_from_points(obj->positions, obj->position_count);
    return obj->position_count ? nkw_vec3_sub(box.high, box.low) : none;
}

static void scale_positions(nkw_vec3 *positions, size_t count, double factor)
{
    for (size_t i = 0; i < count; i++) {
        positions[i].x = (float)(factor * (double)positions[i].x);
        positions[i].y = (float)(factor * (double)positions[i].y);
        positions[i].z = (float)(factor * (double)positions[i].z);
    }
}

nkw_vec3 nkw_obj_scale(nkw_obj *obj, float largest)
{
    const nkw_vec3 size = size_of(obj);
    const float most = nkw_max(size.x, nkw_max(size.y, size.z));
    const nkw_document *d = obj->document;
    if (!(most > 0.0f && isfinite(most) && largest > 0.0f && isfinite(largest)))
        return size;
    const double factor = (double)largest / (double)most;
    scale_positions(obj->positions, obj->position_count, factor);
    for (size_t i = 0; i < d->mesh_count; i++)
        for (size_t k = 0; k < d->meshes[i].primitive_count; k++) {
            const nkw_document_primitive *p = &d->meshes[i].primitives[k];
            scale_positions((nkw_vec3 *)p->positions, p->vertex_count, factor);
        }
    nkwi_document_boxes((nkwi_document *)(void *)obj->document);
    return size_of(obj);
}
