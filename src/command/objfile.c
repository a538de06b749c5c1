/* SPDX-License-Identifier: MIT */
#include "objfile.h"

#include <stdlib.h>
#include <string.h>

#include "moment.h"

typedef struct objfile {
    model *m;
    nkw_document document; /* of m, with the bytes of its pictures */
    const char *path;
    char *base; /* the path without .obj */
    char **images; /* names of pictures, or NULL */
    size_t bytes;
} objfile;

int objfile_is(const char *path)
{
    static const char *const ends[] = {"obj"};
    return output_ending(path, ends, 1) == 0;
}

/* base + suffix, in memory of the model. */
static char *with_suffix(objfile *f, const char *suffix)
{
    char *path = model_take(f->m, strlen(f->base) + strlen(suffix) + 1, 1);
    if (path)
        strcat(strcpy(path, f->base), suffix);
    return path;
}

static int put_file(objfile *f, const char *path, const void *data, size_t bytes)
{
    f->bytes += bytes;
    return model_put_file(path, data, bytes);
}

/* ---- Pictures ---- */

static const char *ending_of(const nkw_document_image *image)
{
    const unsigned char *data = image->data;
    if (image->bytes >= 4 && memcmp(data, "\x89PNG", 4) == 0)
        return "png";
    return image->bytes >= 3 && memcmp(data, "\xff\xd8\xff", 3) == 0 ? "jpg" : "bin";
}

/* A picture in a file becomes one of its own; others have their path. */
static int put_image(objfile *f, size_t i)
{
    const nkw_document_image *image = &f->document.images[i];
    char suffix[40];
    if (!image->data) {
        f->images[i] = (char *)image->path;
        return 1;
    }
    snprintf(suffix, sizeof suffix, "_%zu.%s", i, ending_of(image));
    char *path = with_suffix(f, suffix);
    f->images[i] = path ? (char *)input_name(path) : NULL;
    return path && put_file(f, path, image->data, image->bytes);
}

static int put_images(objfile *f)
{
    const nkw_document *d = f->m->original;
    const int is_elsewhere = !model_same_folder(f->path, d->file);
    f->images = model_take(f->m, d->image_count, sizeof *f->images);
    if (!f->images || (is_elsewhere && !model_embed_images(f->m, &f->document)))
        return 0;
    for (size_t i = 0; i < d->image_count; i++) {
        if (!put_image(f, i))
            return 0;
        if (is_elsewhere && f->images[i] && !f->document.images[i].data) {
            output_text(stderr, f->images[i]);
            fputs(": warning: cannot be read, and is not copied\n", stderr);
        }
    }
    return 1;
}

/* ---- What is not written ---- */

static size_t most_texcoords(const nkw_document *d)
{
    size_t most = 0;
    for (size_t i = 0; i < d->mesh_count; i++)
        for (size_t k = 0; k < d->meshes[i].primitive_count; k++)
            if (d->meshes[i].primitives[k].texcoord_count > most)
                most = d->meshes[i].primitives[k].texcoord_count;
    return most;
}

static void note(const objfile *f)
{
    const nkw_document *d = &f->document;
    const size_t sets = most_texcoords(d);
    if (d->animation_count || d->skin_count || d->float_count) {
        fputs("note: OBJ has no clips, skins and morph targets: written is ", stderr);
        if (f->m->clip == INPUT_REST)
            fputs("the rest pose\n", stderr);
        else {
            fputs("clip ", stderr);
            output_text(stderr, input_clip_name(d, f->m->clip));
            fprintf(stderr, " at %.6g s\n", (double)f->m->time);
        }
    }
    if (sets > 1)
        fprintf(stderr, "note: OBJ has one set of texture coordinates: written is set 0 of %zu\n", sets);
}

/* ---- The files ---- */

static int put_texts(objfile *f, const moment *now)
{
    nkw_obj_file file;
    nkw_import_error error;
    char *materials = with_suffix(f, ".mtl");
    if (!materials)
        return 0;
    const nkw_obj_writing writing = {now->models, now->floats, input_name(materials), (const char *const *)f->images,
                                     input_v_is_up()};
    if (nkw_document_write_obj(&f->document, &writing, &file, &error) != NKW_IMPORT_OK) {
        input_report(&error);
        return 0;
    }
    int done = put_file(f, f->path, file.data, file.bytes);
    done = done && (!file.materials || put_file(f, materials, file.materials, file.material_bytes));
    nkw_obj_file_free(&file);
    return done;
}

int objfile_write(model *m, const char *path, size_t *bytes)
{
    moment now;
    objfile f = {m, m->document, path, NULL, NULL, 0};
    f.base = model_take(m, strlen(path) + 1, 1);
    if (f.base)
        memcpy(f.base, path, strlen(path) - strlen(".obj"));
    int done = f.base && put_images(&f) && moment_open(&now, &f.document, m->clip);
    if (done) {
        moment_at(&now, m->time);
        done = put_texts(&f, &now);
        moment_close(&now);
    }
    if (done)
        note(&f);
    *bytes = f.bytes;
    return done;
}
