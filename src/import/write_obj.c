/* SPDX-License-Identifier: MIT */
/*
 * A document at one time as an OBJ file: the vertices of each node with a mesh, morphed, skinned, in the space of the
 * models. Equal positions, texture coordinates and normals are one line.
 */
#include "write_obj.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/mat.h>

#include "decimal.h"

static int no_memory(nkwi_obj_writer *w)
{
    return nkwi_fail(w->error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the file");
}

/* ---- Text ---- */

static int put(nkwi_obj_writer *w, nkwi_obj_bytes *to, const char *text, size_t count)
{
    if (count > to->room - to->count) {
        const size_t room = 2 * to->room + count + 1024;
        char *data = room > to->room ? (char *)realloc(to->data, room) : NULL;
        if (!data)
            return no_memory(w);
        to->data = data;
        to->room = room;
    }
    memcpy(to->data + to->count, text, count);
    to->count += count;
    return 1;
}

int nkwi_obj_put(nkwi_obj_writer *w, nkwi_obj_bytes *to, const char *text)
{
    return put(w, to, text, strlen(text));
}

int nkwi_obj_put_floats(nkwi_obj_writer *w, nkwi_obj_bytes *to, const char *word, const float *numbers, size_t count)
{
    char line[8 + 6 * (1 + NKWI_DECIMAL_ROOM)];
    size_t length = strlen(word);
    memcpy(line, word, length);
    for (size_t i = 0; i < count; i++) {
        line[length++] = ' ';
        length += nkwi_decimal_write(numbers[i], line + length);
    }
    line[length++] = '\n';
    return put(w, to, line, length);
}

/* ---- v, vt, vn ---- */

/* The number, from 1, of such numbers; they are written if they are new. -0 is 0. */
static int number_of(nkwi_obj_writer *w, nkwi_obj_table *table, const float *numbers, size_t count, uint32_t other,
                     uint32_t *number)
{
    nkwi_obj_key key = {{0, 0, 0, other}};
    for (size_t i = 0; i < count; i++) {
        const float x = numbers[i] + 0.0f;
        memcpy(&key.parts[i], &x, sizeof x);
    }
    if (!nkwi_obj_number(&w->objects, table, &key, number))
        return 0;
    ++*number;
    return 1;
}

static int is_new(const nkwi_obj_table *table, size_t before)
{
    return table->keys.count > before;
}

/* x y z, and of vertices with colours red green blue. */
static int put_position(nkwi_obj_writer *w, const float *position, const float *color, uint32_t *number)
{
    const size_t before = w->positions.keys.count;
    float numbers[6];
    uint32_t of_color = 0;
    memcpy(numbers, position, 3 * sizeof *numbers);
    if (color)
        memcpy(numbers + 3, color, 3 * sizeof *numbers);
    return (!color || number_of(w, &w->colors, color, 3, 0, &of_color)) &&
           number_of(w, &w->positions, position, 3, of_color, number) &&
           (!is_new(&w->positions, before) || nkwi_obj_put_floats(w, &w->lines, "v", numbers, color ? 6 : 3));
}

static int put_texcoord(nkwi_obj_writer *w, const float *at, uint32_t *number)
{
    const size_t before = w->texcoords.keys.count;
    const float up[2] = {at[0], w->writing->v_is_up ? at[1] : 1.0f - at[1]};
    return number_of(w, &w->texcoords, up, 2, 0, number) &&
           (!is_new(&w->texcoords, before) || nkwi_obj_put_floats(w, &w->lines, "vt", up, 2));
}

static int put_normal(nkwi_obj_writer *w, const float *normal, uint32_t *number)
{
    const size_t before = w->normals.keys.count;
    return number_of(w, &w->normals, normal, 3, 0, number) &&
           (!is_new(&w->normals, before) || nkwi_obj_put_floats(w, &w->lines, "vn", normal, 3));
}

static int put_vertex(nkwi_obj_writer *w, const nkw_document_primitive *p, uint32_t vertex)
{
    nkwi_obj_corner *corner = &w->corners[vertex];
    if (corner->at[OBJ_POSITION])
        return 1;
    return put_position(w, &w->vertices[vertex].x, p->colors ? p->colors + 4 * (size_t)vertex : NULL,
                        &corner->at[OBJ_POSITION]) &&
           (p->texcoord_count == 0 ||
            put_texcoord(w, p->texcoords[0] + 2 * (size_t)vertex, &corner->at[OBJ_TEXCOORD])) &&
           (!p->normals || put_normal(w, &w->directions[vertex].x, &corner->at[OBJ_NORMAL]));
}

/* ---- f, l, p ---- */

static int put_corner(nkwi_obj_writer *w, const nkwi_obj_corner *c)
{
    char text[40];
    const unsigned long v = c->at[OBJ_POSITION], t = c->at[OBJ_TEXCOORD], n = c->at[OBJ_NORMAL];
    if (t && n)
        snprintf(text, sizeof text, " %lu/%lu/%lu", v, t, n);
    else if (t)
        snprintf(text, sizeof text, " %lu/%lu", v, t);
    else if (n)
        snprintf(text, sizeof text, " %lu//%lu", v, n);
    else
        snprintf(text, sizeof text, " %lu", v);
    return nkwi_obj_put(w, &w->lines, text);
}

/* A mirrored triangle begins at the same corner. */
static int put_elements(nkwi_obj_writer *w, const nkw_document_primitive *p, int is_mirrored)
{
    static const char *const words[] = {"p", "l", "f"};
    const size_t size = (size_t)p->topology + 1;
    for (size_t i = 0; i + size <= p->index_count; i += size) {
        if (!nkwi_obj_put(w, &w->lines, words[p->topology]))
            return 0;
        for (size_t k = 0; k < size; k++)
            if (!put_corner(w, &w->corners[p->indices[i + (is_mirrored && k ? 3 - k : k)]]))
                return 0;
        if (!nkwi_obj_put(w, &w->lines, "\n"))
            return 0;
    }
    return 1;
}

static int use_material(nkwi_obj_writer *w, int32_t material)
{
    if (!w->writing->materials || w->document->material_count == 0 || material == w->material)
        return 1;
    const size_t number = material == NKW_NO_JOINT ? w->document->material_count : (size_t)material;
    w->material = material;
    return nkwi_obj_put(w, &w->lines, "usemtl ") &&
           nkwi_obj_put(w, &w->lines, nkwi_obj_name_of(&w->materials, w->material_names[number])) &&
           nkwi_obj_put(w, &w->lines, "\n");
}

/* ---- Nodes ---- */

static int put_primitive(nkwi_obj_writer *w, size_t joint, size_t primitive)
{
    const nkw_document *d = w->document;
    const nkw_document_node *node = &d->nodes[joint];
    const nkw_document_primitive *p = &d->meshes[node->mesh].primitives[primitive];
    const nkw_document_vertices_span out = {w->vertices, p->normals ? w->directions : NULL};
    const nkw_document_moment moment = {w->models, w->writing->floats, w->palette};
    const int is_rigid = node->skin == NKW_NO_JOINT || p->influence_count == 0;
    if (!p->positions)
        return 1;
    const nkw_result result = nkw_document_vertices(d, joint, primitive, &moment, out);
    if (result == NKW_TOO_SMALL)
        return no_memory(w);
    if (result != NKW_OK) {
        w->error->result = result;
        return nkwi_fail(w->error, NULL, NKW_IMPORT_REFUSED, "mesh %ld, primitive %zu: %s", (long)node->mesh, primitive,
                         nkw_result_text(result));
    }
    memset(w->corners, 0, p->vertex_count * sizeof *w->corners);
    for (size_t i = 0; i < p->index_count; i++)
        if (!put_vertex(w, p, p->indices[i]))
            return 0;
    return use_material(w, p->material) && put_elements(w, p,
                                                        is_rigid && p->topology == NKW_DOCUMENT_TRIANGLES &&
                                                            nkw_mat4_determinant(&w->models[joint]) < 0.0f);
}

static int put_node(nkwi_obj_writer *w, size_t joint)
{
    const nkw_document *d = w->document;
    const nkw_document_node *node = &d->nodes[joint];
    uint32_t name;
    if (node->mesh == NKW_NO_JOINT)
        return 1;
    if (node->skin != NKW_NO_JOINT)
        nkw_document_palette(d, (size_t)node->skin, w->models, w->palette);
    if (!nkwi_obj_unique(w, &w->objects, node->name, joint, &name) || !nkwi_obj_put(w, &w->lines, "o ") ||
        !nkwi_obj_put(w, &w->lines, nkwi_obj_name_of(&w->objects, name)) || !nkwi_obj_put(w, &w->lines, "\n"))
        return 0;
    for (size_t i = 0; i < d->meshes[node->mesh].primitive_count; i++)
        if (!put_primitive(w, joint, i))
            return 0;
    return 1;
}

/* ---- The file ---- */

static int take_rooms(nkwi_obj_writer *w)
{
    const nkw_document *d = w->document;
    size_t vertices = 1, joints = 1;
    for (size_t i = 0; i < d->mesh_count; i++)
        for (size_t k = 0; k < d->meshes[i].primitive_count; k++)
            if (d->meshes[i].primitives[k].vertex_count > vertices)
                vertices = d->meshes[i].primitives[k].vertex_count;
    for (size_t i = 0; i < d->skin_count; i++)
        joints = d->skins[i].joint_count > joints ? d->skins[i].joint_count : joints;
    w->models = (nkw_mat4 *)calloc(d->skeleton.joint_count, sizeof *w->models);
    w->palette = (nkw_mat4 *)calloc(joints, sizeof *w->palette);
    w->vertices = (nkw_vec3 *)calloc(vertices, sizeof *w->vertices);
    w->directions = (nkw_vec3 *)calloc(vertices, sizeof *w->directions);
    w->corners = (nkwi_obj_corner *)calloc(vertices, sizeof *w->corners);
    return (w->models && w->palette && w->vertices && w->directions && w->corners) || no_memory(w);
}

static int put_file(nkwi_obj_writer *w)
{
    const nkw_document *d = w->document;
    if (!take_rooms(w))
        return 0;
    if (w->writing->models)
        memcpy(w->models, w->writing->models, d->skeleton.joint_count * sizeof *w->models);
    else
        nkw_document_models(d, d->rest, NULL, w->models);
    if (w->writing->materials && d->material_count > 0 &&
        !(nkwi_obj_put_materials(w) && nkwi_obj_put(w, &w->lines, "mtllib ") &&
          nkwi_obj_put(w, &w->lines, w->writing->materials) && nkwi_obj_put(w, &w->lines, "\n")))
        return 0;
    for (size_t j = 0; j < d->skeleton.joint_count; j++)
        if (!put_node(w, j))
            return 0;
    if (!put(w, &w->lines, "", 1) || (w->material_lines.count > 0 && !put(w, &w->material_lines, "", 1)))
        return 0;
    return w->positions.keys.count > 0 || nkwi_fail(w->error, NULL, NKW_IMPORT_UNSUPPORTED, "there are no meshes");
}

static void give_names(nkwi_obj *names)
{
    free(names->names.data);
    nkwi_obj_give(&names->name_table);
}

static void give(nkwi_obj_writer *w)
{
    nkwi_obj_table *tables[] = {&w->positions, &w->texcoords, &w->normals, &w->colors};
    for (size_t i = 0; i < sizeof tables / sizeof *tables; i++)
        nkwi_obj_give(tables[i]);
    give_names(&w->objects);
    give_names(&w->materials);
    nkwi_give(&w->scratch.memory);
    free(w->material_names);
    free(w->models);
    free(w->palette);
    free(w->vertices);
    free(w->directions);
    free(w->corners);
    free(w->lines.data);
    free(w->material_lines.data);
}

nkw_import_result nkw_document_write_obj(const nkw_document *document, const nkw_obj_writing *writing,
                                         nkw_obj_file *file, nkw_import_error *error)
{
    const nkw_obj_file none = {NULL, 0, NULL, 0};
    nkw_import_error other;
    nkwi_obj_writer w;
    memset(&w, 0, sizeof w);
    w.document = document;
    w.writing = writing;
    w.error = error ? error : &other;
    w.scratch.memory.most = SIZE_MAX;
    w.objects.document = w.materials.document = &w.scratch;
    w.objects.error = w.materials.error = w.error;
    w.material = OBJ_NO_USEMTL;
    *file = none;
    nkwi_fault_none(w.error, document->file);
    if (put_file(&w)) {
        const nkw_obj_file made = {w.lines.data, w.lines.count - 1, w.material_lines.data,
                                   w.material_lines.count - (w.material_lines.count > 0)};
        *file = made;
        w.lines.data = w.material_lines.data = NULL;
    }
    give(&w);
    return w.error->code;
}

void nkw_obj_file_free(nkw_obj_file *file)
{
    const nkw_obj_file none = {NULL, 0, NULL, 0};
    free(file->data);
    free(file->materials);
    *file = none;
}
