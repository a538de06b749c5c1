/* SPDX-License-Identifier: MIT */
/*
 * Materials of OBJ, in MTL files: newmtl, Kd, d, Tr and map_Kd. What is wrong with them is a warning: the shapes do not
 * need them. Source: Wavefront Technologies, The Advanced Visualizer: Material Files (.mtl), version 4.2.
 */
#include <stdlib.h>
#include <string.h>

#include "decimal.h"
#include "file.h"
#include "obj.h"

static nkwi_obj_material *material_at(const nkwi_obj *o, int32_t material)
{
    return (nkwi_obj_material *)o->materials.data + material;
}

int nkwi_obj_material_of(nkwi_obj *o, nkwi_obj_word name, int32_t *material)
{
    nkwi_obj_key key = {{0, 0, 0, 0}};
    uint32_t number;
    if (!nkwi_obj_name(o, name, &key.parts[0]) || !nkwi_obj_number(o, &o->material_table, &key, &number))
        return 0;
    *material = (int32_t)number;
    if (number < o->materials.count)
        return 1;
    nkwi_obj_material *m = (nkwi_obj_material *)nkwi_obj_add(o, &o->materials, sizeof *m);
    for (int i = 0; m && i < 4; i++)
        m->color[i] = 1.0f;
    if (m)
        m->name = key.parts[0];
    return m != NULL;
}

/* ---- Lines of an MTL file: they return NULL, or what is wrong. ---- */

static float clamped(double x)
{
    return (float)(x > 0.0 ? x < 1.0 ? x : 1.0 : 0.0);
}

static int is_option(nkwi_obj_word w)
{
    return w.length > 1 && *w.text == '-' && w.text[1] >= 'a' && w.text[1] <= 'z';
}

/* One number for grey, or three. Spectra and CIE XYZ are not read. */
static const char *read_color(nkwi_obj_text *t, float *color)
{
    double numbers[3] = {1.0, 1.0, 1.0};
    nkwi_obj_word w;
    int count = 0;
    for (; count < 3 && nkwi_obj_next(t, &w); count++) {
        const char *reason = nkwi_decimal(w.text, w.length, &numbers[count]);
        if (reason)
            return reason;
    }
    if (count == 0)
        return "a number is expected";
    for (int i = 0; i < 3; i++)
        color[i] = clamped(count == 3 ? numbers[i] : numbers[0]);
    return NULL;
}

/* d: opacity, which has priority; Tr: 1 - opacity. */
static const char *read_opacity(nkwi_obj_text *t, nkwi_obj_material *m, int is_d)
{
    double number;
    nkwi_obj_word w;
    while (nkwi_obj_next(t, &w) && is_option(w)) {
    }
    const char *reason = nkwi_decimal(w.text, w.length, &number);
    if (!reason && (is_d || !m->has_d))
        m->color[3] = clamped(is_d ? number : 1.0 - number);
    m->has_d |= !reason && is_d;
    return reason;
}

/* The words after an option of a picture: 1, 2, or up to three numbers. */
static void skip_option(nkwi_obj_text *t, nkwi_obj_word option)
{
    const int is_vector = nkwi_obj_same(option, "-o") || nkwi_obj_same(option, "-s") || nkwi_obj_same(option, "-t");
    const int most = is_vector ? 3 : nkwi_obj_same(option, "-mm") ? 2 : 1;
    nkwi_obj_word w;
    double number;
    for (int i = 0; i < most; i++) {
        const nkwi_obj_text before = *t;
        if (!nkwi_obj_next(t, &w))
            return;
        if (is_vector && nkwi_decimal(w.text, w.length, &number)) {
            *t = before;
            return;
        }
    }
}

/* map_Kd OPTIONS FILE; the name of the file may have spaces. */
static int read_picture(nkwi_obj *o, nkwi_obj_text *t, int32_t material)
{
    nkwi_obj_text before = *t;
    nkwi_obj_word w;
    for (; nkwi_obj_next(t, &w) && is_option(w); before = *t)
        skip_option(t, w);
    *t = before;
    uint32_t image;
    if (!nkwi_obj_name(o, nkwi_obj_rest(t), &image))
        return 0;
    material_at(o, material)->image = image;
    return 1;
}

/* Returns 0 without memory. *material: that of the last newmtl. */
static int read_line(nkwi_obj *o, nkwi_obj_text *t, nkwi_obj_word w, int32_t *material, const char **reason)
{
    *reason = NULL;
    if (nkwi_obj_same(w, "newmtl")) {
        if (!nkwi_obj_material_of(o, nkwi_obj_rest(t), material))
            return 0;
        material_at(o, *material)->is_defined = 1;
        return 1;
    }
    if (*material < 0)
        return 1;
    if (nkwi_obj_same(w, "map_Kd"))
        return read_picture(o, t, *material);
    if (nkwi_obj_same(w, "Kd"))
        *reason = read_color(t, material_at(o, *material)->color);
    else if (nkwi_obj_same(w, "d") || nkwi_obj_same(w, "Tr"))
        *reason = read_opacity(t, material_at(o, *material), w.length == 1);
    return 1;
}

static int read_lines(nkwi_obj *o, const char *path, nkwi_obj_text t)
{
    int32_t material = NKW_NO_JOINT;
    nkwi_obj_word w;
    const char *reason;
    for (; t.at < t.end; nkwi_obj_skip_line(&t)) {
        if (!nkwi_obj_next(&t, &w))
            continue;
        if (!read_line(o, &t, w, &material, &reason))
            return 0;
        if (reason && !nkwi_document_warn(o->document, o->error, "%s, line %zu: %s", path, t.line, reason))
            return 0;
    }
    return 1;
}

/* ---- Files ---- */

/* The last name of a path of any system. */
static const char *last_name(const char *path)
{
    const char *name = path;
    for (; *path; path++)
        if (*path == '/' || *path == '\\' || *path == ':')
            name = path + 1;
    return name;
}

/* A file of the folder. Returns 0 without memory; *was_read is 0 where it is not there. */
static int read_file(nkwi_obj *o, const char *path, int *was_read)
{
    const nkw_import_memory *m = o->memory;
    nkwi_document *d = o->document;
    const size_t bytes = m->reader ? m->reader(m->user, path, NULL, 0) : SIZE_MAX;
    *was_read = bytes <= NKWI_BYTES_MOST - d->all.bytes;
    if (!*was_read)
        return 1;
    char *data = (char *)malloc(bytes + 1);
    if (!data)
        return nkwi_fail(o->error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the materials");
    int done = 1;
    *was_read = m->reader(m->user, path, data, bytes) == bytes;
    if (*was_read) {
        const int has_mark = bytes >= 3 && memcmp(data, "\xEF\xBB\xBF", 3) == 0;
        const nkwi_obj_text text = {data + (has_mark ? 3 : 0), data + bytes, 1};
        d->all.bytes += bytes;
        d->memory.most = NKWI_MEMORY_MOST(d->all.bytes);
        done = read_lines(o, path, text);
    }
    free(data);
    return done;
}

/*
 * A material file of this name, or, of a path that leaves the folder, of its last name. Each name once. *was_read is 1
 * also for a name that was read before.
 */
static int read_library(nkwi_obj *o, nkwi_obj_word w, int *was_read)
{
    const size_t before = o->libraries.keys.count;
    nkwi_obj_key key = {{0, 0, 0, 0}};
    uint32_t number;
    if (!nkwi_obj_name(o, w, &key.parts[0]) || !nkwi_obj_number(o, &o->libraries, &key, &number))
        return 0;
    *was_read = number < before;
    if (*was_read)
        return 1;
    const char *name = nkwi_obj_name_of(o, key.parts[0]);
    char *path = (char *)malloc(strlen(name) + 1);
    if (!path)
        return nkwi_fail(o->error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the name of a file");
    const int is_path = !nkwi_path_from_name(name, path) || !nkwi_path_from_name(last_name(name), path);
    const int done = !is_path || read_file(o, path, was_read);
    free(path);
    return done;
}

/* The rest of the line is one name; otherwise each of its words is. */
int nkwi_obj_library(nkwi_obj *o)
{
    const nkwi_obj_text before = o->text;
    const nkwi_obj_word all = nkwi_obj_rest(&o->text);
    nkwi_obj_text t = before;
    nkwi_obj_word w;
    int was_read;
    if (!read_library(o, all, &was_read) || was_read)
        return o->error->code == NKW_IMPORT_OK;
    int found = 0;
    while (nkwi_obj_next(&t, &w)) {
        if (w.length < all.length && !read_library(o, w, &was_read))
            return 0;
        found += was_read;
    }
    o->misses_library |= !found;
    return found ||
           nkwi_document_warn(o->document, o->error, "the materials of %.*s are not read: there is no such file",
                              (int)(all.length < 120 ? all.length : 120), all.text);
}

/* ---- The document ---- */

/* One picture for each name. */
static int add_image(nkwi_obj *o, nkwi_obj_table *table, nkw_document_image *images, uint32_t name, size_t *number)
{
    nkw_document *d = &o->document->all;
    const nkwi_obj_key key = {{name, 0, 0, 0}};
    uint32_t index;
    if (!nkwi_obj_number(o, table, &key, &index))
        return 0;
    *number = index;
    if (index < d->image_count)
        return 1;
    nkw_document_image *image = &images[d->image_count++];
    image->name = nkwi_obj_name_of(o, name);
    char *path = (char *)nkwi_document_take(o->document, o->error, NULL, strlen(image->name) + 1, 1);
    image->path = path && !nkwi_path_from_name(image->name, path) ? path : NULL;
    return path != NULL;
}

static int warn_of_missing(nkwi_obj *o)
{
    size_t count = 0, first = 0;
    for (size_t i = 0; i < o->materials.count; i++)
        if (!material_at(o, (int32_t)i)->is_defined && count++ == 0)
            first = i;
    return count == 0 || o->misses_library ||
           nkwi_document_warn(o->document, o->error, "materials that no file defines: %zu, the first is %s", count,
                              nkwi_obj_name_of(o, material_at(o, (int32_t)first)->name));
}

int nkwi_obj_materials(nkwi_obj *o)
{
    nkw_document *d = &o->document->all;
    const size_t count = o->materials.count;
    nkwi_obj_table table = {{NULL, 0, 0}, NULL, 0};
    nkw_document_material *list =
        (nkw_document_material *)nkwi_document_take(o->document, o->error, NULL, count, sizeof *list);
    nkw_document_image *images =
        (nkw_document_image *)nkwi_document_take(o->document, o->error, NULL, count, sizeof *images);
    int done = list && images;
    for (size_t i = 0; done && i < count; i++) {
        const nkwi_obj_material *m = material_at(o, (int32_t)i);
        size_t number = 0;
        memcpy(list[i].color, m->color, sizeof m->color);
        list[i].name = nkwi_document_name(o->document, o->error, nkwi_obj_name_of(o, m->name), "material", i);
        done = list[i].name && (m->image == 0 || add_image(o, &table, images, m->image, &number));
        list[i].image = m->image ? &images[number] : NULL;
    }
    nkwi_obj_give(&table);
    d->materials = list;
    d->material_count = count;
    d->images = images;
    return done && warn_of_missing(o);
}
