/* SPDX-License-Identifier: MIT */
/* The MTL file: newmtl, Kd, d and map_Kd; and names. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "write_obj.h"

/* Blanks end names for many readers; # begins a comment, and a backslash joins lines. */
static char kept(char c)
{
    return (unsigned char)c <= ' ' || c == 127 || c == '#' || c == '\\' ? '_' : c;
}

int nkwi_obj_unique(nkwi_obj_writer *w, nkwi_obj *names, const char *name, size_t index, uint32_t *number)
{
    char suffix[24];
    size_t length = strlen(name), count;
    const size_t more = (size_t)snprintf(suffix, sizeof suffix, "_%zu", index);
    char *text = (char *)malloc(length + 1);
    for (size_t i = 0; text && i < length; i++)
        text[i] = kept(name[i]);
    int done = text != NULL;
    do {
        const nkwi_obj_word word = {text, length};
        count = names->names.count;
        done = done && nkwi_obj_name(names, word, number);
        if (!done || *number == count)
            break;
        char *longer = (char *)realloc(text, length + more);
        done = longer != NULL;
        text = done ? longer : text;
        if (done)
            memcpy(text + length, suffix, more);
        length += more;
    } while (done);
    free(text);
    return done ||
           (w->error->code == NKW_IMPORT_OK ? nkwi_fail(w->error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the names")
                                            : 0);
}

/* A name of a file, which may have spaces; -x would be an option. */
static int put_picture(nkwi_obj_writer *w, const char *name)
{
    nkwi_obj_bytes *to = &w->material_lines;
    const size_t start = to->count;
    if (!nkwi_obj_put(w, to, *name == '-' ? "map_Kd ./" : "map_Kd ") || !nkwi_obj_put(w, to, name))
        return 0;
    for (size_t i = start; i < to->count; i++)
        to->data[i] = (unsigned char)to->data[i] < ' ' ? '_' : to->data[i];
    return nkwi_obj_put(w, to, "\n");
}

static int put_material(nkwi_obj_writer *w, const float *color, uint32_t name, const char *picture)
{
    nkwi_obj_bytes *to = &w->material_lines;
    return nkwi_obj_put(w, to, "newmtl ") && nkwi_obj_put(w, to, nkwi_obj_name_of(&w->materials, name)) &&
           nkwi_obj_put(w, to, "\n") && nkwi_obj_put_floats(w, to, "Kd", color, 3) &&
           (color[3] == 1.0f || nkwi_obj_put_floats(w, to, "d", color + 3, 1)) && (!picture || put_picture(w, picture));
}

/* Whether something is drawn without a material. OBJ cannot end the material before it. */
static int needs_none(const nkw_document *d)
{
    for (size_t i = 0; i < d->mesh_count; i++)
        for (size_t k = 0; k < d->meshes[i].primitive_count; k++)
            if (d->meshes[i].primitives[k].material == NKW_NO_JOINT)
                return 1;
    return 0;
}

static const char *picture_of(const nkwi_obj_writer *w, const nkw_document_image *image)
{
    const char *const *names = w->writing->images;
    return !image ? NULL : names ? names[image - w->document->images] : image->path;
}

int nkwi_obj_put_materials(nkwi_obj_writer *w)
{
    static const float white[4] = {1.0f, 1.0f, 1.0f, 1.0f};
    const nkw_document *d = w->document;
    w->material_names = (uint32_t *)calloc(d->material_count + 1, sizeof *w->material_names);
    if (!w->material_names)
        return nkwi_fail(w->error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the materials");
    for (size_t i = 0; i < d->material_count; i++) {
        const nkw_document_material *m = &d->materials[i];
        if (!nkwi_obj_unique(w, &w->materials, m->name, i, &w->material_names[i]) ||
            !put_material(w, m->color, w->material_names[i], picture_of(w, m->image)))
            return 0;
    }
    uint32_t *none = &w->material_names[d->material_count];
    return !needs_none(d) ||
           (nkwi_obj_unique(w, &w->materials, "none", d->material_count, none) && put_material(w, white, *none, NULL));
}
