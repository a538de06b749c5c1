/* SPDX-License-Identifier: MIT */
#include "model.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "mend.h"
#include "objfile.h"

/* ---- the source ---- */

int model_source_open(model_source *s, const char *path)
{
    const int is_stdin = strcmp(path, "-") == 0;
    memset(s, 0, sizeof *s);
    s->memory.file = path;
    s->folder = input_folder(is_stdin ? "." : path);
    s->memory.folder = s->folder;
    s->memory.bvh_adds_offset = input_bvh_adds();
    s->memory.v_is_up = input_v_is_up();
    s->data = input_read(path, &s->memory.bytes);
    s->memory.data = s->data;
    if (!s->data || !s->folder)
        return 0;
    s->document = input_open_memory(&s->memory);
    return s->document != NULL;
}

void model_source_close(model_source *s)
{
    input_close(s->document);
    free(s->data);
    free(s->folder);
}

int model_run(const options_text *text, const struct poptOption *table, int argc, const char **argv,
              const model_steps *steps, void *request)
{
    options o;
    model_source source;
    int code;
    if (!options_read(&o, text, table, argc, argv))
        code = o.code;
    else if ((code = steps->check(&o, request)) == COMMAND_FINE) {
        const int done = model_source_open(&source, o.files[0]) && steps->work(&source, request);
        code = done ? COMMAND_FINE : COMMAND_FINDINGS;
        model_source_close(&source);
    }
    options_close(&o);
    return code;
}

/* ---- the model ---- */

static int no_memory(void)
{
    fputs("nakawari: no memory\n", stderr);
    return 0;
}

/* Memory that the model frees; frees it without a place to note it. */
static int model_keep(model *m, void *block)
{
    void **blocks = realloc(m->blocks, (m->block_count + 1) * sizeof *blocks);
    if (!blocks || !block) {
        free(block);
        m->blocks = blocks ? blocks : m->blocks;
        return no_memory();
    }
    m->blocks = blocks;
    m->blocks[m->block_count++] = block;
    return 1;
}

void *model_take(model *m, size_t count, size_t size)
{
    void *block = calloc(count ? count : 1, size);
    return model_keep(m, block) ? block : NULL;
}

int model_open(model *m, const nkw_document *d)
{
    memset(m, 0, sizeof *m);
    m->original = d;
    m->document = *d;
    m->animations = model_take(m, d->animation_count, sizeof *m->animations);
    m->document.animations = m->animations;
    for (size_t i = 0; m->animations && i < d->animation_count; i++) {
        const size_t count = d->animations[i].track_count;
        nkw_clip_track *tracks = model_take(m, count, sizeof *tracks);
        if (!tracks)
            return 0;
        if (count)
            memcpy(tracks, d->animations[i].tracks, count * sizeof *tracks);
        m->animations[i] = d->animations[i];
        m->animations[i].tracks = tracks;
    }
    return m->animations != NULL;
}

void model_close(model *m)
{
    for (size_t i = 0; i < m->block_count; i++)
        free(m->blocks[i]);
    free(m->blocks);
}

nkw_clip_track *model_tracks(model *m, size_t animation)
{
    return (nkw_clip_track *)m->animations[animation].tracks;
}

int model_complain(const model *m, size_t animation, const char *what)
{
    return output_complain(m->original, &m->original->animations[animation], what);
}

static int refuse(const model *m, size_t animation, nkw_result result)
{
    char what[160];
    snprintf(what, sizeof what, "%s: see nakawari check", nkw_result_text(result));
    return model_complain(m, animation, what);
}

/* ---- keys ---- */

static int same_times(const nkw_track *a, const nkw_track *b)
{
    return a->count == b->count &&
           (a->times == b->times || memcmp(a->times, b->times, a->count * sizeof *a->times) == 0);
}

/* Whether a track before this one has the same times, or another one if `any`. */
static int shares_times(const nkw_document_animation *a, size_t track, int any)
{
    for (size_t i = 0; i < (any ? a->track_count : track); i++)
        if (i != track && same_times(&a->tracks[i].track, &a->tracks[track].track))
            return 1;
    return 0;
}

static void count_bytes(const nkw_document_animation *a, size_t *keys, size_t *bytes)
{
    *keys = *bytes = 0;
    for (size_t i = 0; i < a->track_count; i++) {
        const nkw_track *t = &a->tracks[i].track;
        *keys += t->count;
        *bytes += sizeof(float) * (nkw_track_value_count(t) + (shares_times(a, i, 0) ? 0 : t->count));
    }
}

static nkw_work work_of(const nkw_clip_source *s)
{
    const size_t bytes = NKW_CLIP_REDUCE_WORK(s->track_count, s->joint_count, s->float_count);
    const nkw_work work = {malloc(bytes), bytes};
    return work;
}

/* Whether there are fewer keys, and, unless `fewest`, fewer bytes: the times of the source may be shared. */
static int is_better(const nkw_document_animation *a, size_t track, const nkw_track *reduced, int fewest)
{
    const nkw_track *t = &a->tracks[track].track;
    const size_t before = nkw_track_value_count(t) + (shares_times(a, track, 1) ? 0 : t->count);
    return reduced->count < t->count && (fewest || nkw_track_value_count(reduced) + reduced->count < before);
}

int model_reduce(model *m, size_t animation, const extent *e, float tolerance, int fewest)
{
    const nkw_clip_source source = nkw_document_clip_source(&m->document, animation, NKW_CLIP_FLOAT32);
    const nkw_clip_reduction reduction = extent_reduction(e, &m->document, tolerance);
    const nkw_work work = work_of(&source);
    nkw_bytes_span block = {NULL, 0};
    nkw_clip_source_reduced reduced;
    if (!work.data)
        return no_memory();
    nkw_result result = nkw_clip_source_reduce(&source, &reduction, block, &reduced, NULL, work);
    block.bytes = reduced.bytes;
    block.data = result == NKW_TOO_SMALL && block.bytes ? model_take(m, block.bytes, 1) : NULL;
    if (block.data)
        result = nkw_clip_source_reduce(&source, &reduction, block, &reduced, NULL, work);
    free(work.data);
    if (block.bytes && !block.data)
        return 0;
    if (result != NKW_OK)
        return refuse(m, animation, result);
    const nkw_clip_source out = reduced.source;
    nkw_clip_track *tracks = model_tracks(m, animation), *chosen = model_take(m, out.track_count, sizeof *chosen);
    for (size_t i = 0; chosen && i < out.track_count; i++)
        chosen[i] = is_better(&m->animations[animation], i, &out.tracks[i].track, fewest) ? out.tracks[i] : tracks[i];
    m->animations[animation].tracks = chosen ? chosen : tracks;
    return chosen != NULL;
}

/* The number of keys of a track at this rate. */
static nkw_result count_resampled(const nkw_track *t, float rate, size_t *count)
{
    const nkw_track_span none = {NULL, NULL, NULL, 0};
    nkw_track out;
    const nkw_result result = nkw_track_resample(t, rate, none, &out, count);
    return result == NKW_TOO_SMALL ? NKW_OK : result;
}

static nkw_result resample(model *m, nkw_track *t, float rate)
{
    nkw_track_span span = {NULL, NULL, NULL, 0};
    nkw_result result = count_resampled(t, rate, &span.key_capacity);
    if (result != NKW_OK)
        return result;
    span.times = model_take(m, span.key_capacity, sizeof(float));
    span.values = model_take(m, span.key_capacity * t->width, sizeof(float));
    return span.times && span.values ? nkw_track_resample(t, rate, span, t, NULL) : NKW_TOO_SMALL;
}

/* Of a clip; with values of four floats 640 MiB. */
enum { RESAMPLED_KEYS_MOST = 1 << 25 };

/* The keys of all tracks after resampling, of those that the library accepts; at most a limit. */
static int is_moderate(const nkw_clip_track *tracks, size_t track_count, float rate)
{
    size_t total = 0, count = 0;
    for (size_t i = 0; i < track_count && total <= RESAMPLED_KEYS_MOST; i++) {
        const nkw_result result = count_resampled(&tracks[i].track, rate, &count);
        total += result == NKW_TOO_MANY ? RESAMPLED_KEYS_MOST + 1 : result == NKW_OK ? count : 0;
    }
    return total <= RESAMPLED_KEYS_MOST;
}

int model_resample(model *m, size_t animation, float rate)
{
    nkw_clip_track *tracks = model_tracks(m, animation);
    if (!is_moderate(tracks, m->animations[animation].track_count, rate))
        return model_complain(m, animation, "more than 33554432 keys at this rate: use a lower one");
    for (size_t i = 0; i < m->animations[animation].track_count; i++) {
        nkw_result result = nkw_track_validate(&tracks[i].track, NULL);
        if (result == NKW_OK)
            result = resample(m, &tracks[i].track, rate);
        if (result != NKW_OK)
            return refuse(m, animation, result);
    }
    return 1;
}

int model_measure(const model *m, size_t animation, const extent *e, float tolerance, model_change *change)
{
    const nkw_clip_source before = nkw_document_clip_source(m->original, animation, NKW_CLIP_FLOAT32);
    const nkw_clip_source after = nkw_document_clip_source(&m->document, animation, NKW_CLIP_FLOAT32);
    const nkw_clip_reduction reduction = extent_reduction(e, m->original, tolerance);
    const nkw_work work = work_of(&before);
    memset(change, 0, sizeof *change);
    count_bytes(&m->original->animations[animation], &change->keys_before, &change->bytes_before);
    count_bytes(&m->animations[animation], &change->keys, &change->bytes);
    if (!work.data)
        return no_memory();
    nkw_result result = nkw_clip_source_difference(&before, &after, &reduction, &change->error, work);
    free(work.data);
    return result == NKW_OK || refuse(m, animation, result);
}

/* ---- the file ---- */

static const char *const outer_end[] = {"gltf"};

int model_form(const char *form, const char *path)
{
    static const char *const forms[] = {"glb", "embedded", "gltf"};
    if (form)
        return words_find(form, forms, 3);
    return output_ending(path, outer_end, 1) == 0 ? NKW_GLTF_OUTER : NKW_GLTF_BINARY;
}

int model_put_file(const char *path, const void *data, size_t bytes)
{
    FILE *f = output_open(path);
    if (!f)
        return 0;
    int fine = fwrite(data, 1, bytes, f) == bytes;
    return output_close(f, path) && fine;
}

/* The path of the outer file: FILE.bin for FILE.gltf. To be freed. */
static char *outer_of(const char *path)
{
    char *outer = malloc(strlen(path) + 8);
    if (!outer)
        return NULL;
    strcpy(outer, path);
    if (output_ending(outer, outer_end, 1) == 0)
        outer[strlen(outer) - 5] = 0;
    return strcat(outer, ".bin");
}

int model_same_folder(const char *a, const char *b)
{
    size_t x = (size_t)(input_name(a) - a), y = (size_t)(input_name(b) - b);
    return x == y && memcmp(a, b, x) == 0;
}

/* Outer pictures that can be read become part of a copy of the document. `images` and `materials` are its lists. */
static void read_images(model *m, nkw_document *d, nkw_document_image *images, nkw_document_material *materials)
{
    for (size_t i = 0; i < d->image_count; i++) {
        size_t bytes = 0;
        images[i] = d->images[i];
        unsigned char *data = images[i].path && !images[i].data ? input_read_beside(d, images[i].path, &bytes) : NULL;
        if (data && model_keep(m, data)) {
            images[i].data = data;
            images[i].bytes = bytes;
        }
    }
    for (size_t i = 0; i < d->material_count; i++) {
        materials[i] = d->materials[i];
        if (materials[i].image)
            materials[i].image = images + (materials[i].image - d->images);
    }
    d->images = images;
    d->materials = materials;
}

int model_embed_images(model *m, nkw_document *d)
{
    nkw_document_image *images = model_take(m, d->image_count, sizeof *images);
    nkw_document_material *materials = model_take(m, d->material_count, sizeof *materials);
    if (images && materials)
        read_images(m, d, images, materials);
    return images && materials;
}

/* Pictures that could not be read: their path may lead nowhere from where the file is written. */
static void drop_images(nkw_document *d)
{
    nkw_document_image *images = (nkw_document_image *)d->images; /* of model_embed_images */
    for (size_t i = 0; i < d->image_count; i++) {
        if (!images[i].path || images[i].data)
            continue;
        output_text(stderr, d->file);
        fputs(": warning: ", stderr);
        output_text(stderr, images[i].path);
        fputs(" cannot be read: the file that is written is without it\n", stderr);
        images[i].path = NULL;
    }
}

static nkw_import_result write_document(model *m, int embeds, nkw_gltf_form form, const char *uri, nkw_gltf_file *file,
                                        nkw_import_error *error)
{
    nkw_document d = m->document;
    if (m->mends) /* the writer makes valid what is of no glTF file */
        d.format = "mended";
    if (embeds && d.image_count > 0 && model_embed_images(m, &d))
        drop_images(&d);
    return nkw_document_write(&d, form, uri, file, error);
}

/* Outer pictures that should have become part of the file. */
static void warn_of_images(const nkw_document *d, const nkw_gltf_file *file)
{
    const nkw_document_image *first = d->images + file->outer_image;
    if (file->outer_images == 0)
        return;
    output_text(stderr, d->file);
    fputs(": warning: ", stderr);
    output_text(stderr, first->path ? first->path : first->name);
    if (file->outer_images > 1)
        fprintf(stderr, " and %zu more are", file->outer_images - 1);
    else
        fputs(" is", stderr);
    fputs(" not in the file, which names the path: cannot be read, or is no PNG or JPEG\n", stderr);
}

/* A GLB has its images, and so has a file in another folder, where paths lead elsewhere. */
static int make_file(model *m, const model_source *source, const char *path, const char *outer, nkw_gltf_form form,
                     nkw_gltf_file *file)
{
    nkw_import_error error;
    const char *uri = outer ? input_name(outer) : NULL;
    const int embeds = m->embeds || form == NKW_GLTF_BINARY || !path || !model_same_folder(path, m->original->file);
    if (source && !m->mends_meshes) {
        const nkw_gltf_rewriting r = {&source->memory, m->original, &m->document, embeds};
        nkw_gltf_rewrite(&r, form, uri, file, &error);
    } else
        write_document(m, embeds, form, uri, file, &error);
    if (error.code == NKW_IMPORT_OK && embeds)
        warn_of_images(m->original, file);
    if (error.code != NKW_IMPORT_OK)
        input_report(&error);
    return error.code == NKW_IMPORT_OK;
}

/* The file as it was, if it is a GLB and the new one is not smaller: a clip whose keys are all needed. */
static int stay_smaller(const model *m, const model_source *source, nkw_gltf_file *file)
{
    const size_t bytes = source ? source->memory.bytes : 0;
    if (!m->only_smaller || bytes < 12 || memcmp(source->data, "glTF", 4) != 0 || file->bytes <= bytes)
        return 1;
    unsigned char *data = malloc(bytes);
    if (!data)
        return no_memory();
    memcpy(data, source->data, bytes);
    nkw_gltf_file_free(file);
    file->data = data;
    file->bytes = bytes;
    output_text(stderr, m->original->file);
    fputs(": note: nothing makes it smaller: it is copied\n", stderr);
    return 1;
}

/* bytes: receives the bytes of all files. */
static int model_write(model *m, const model_source *source, const char *path, nkw_gltf_form form, size_t *bytes)
{
    nkw_gltf_file file = {NULL, 0, NULL, 0, 0, 0};
    if (m->is_obj)
        return objfile_write(m, path, bytes);
    const int names = path && strcmp(path, "-") != 0;
    char *outer = names && form == NKW_GLTF_OUTER ? outer_of(path) : NULL;
    form = form == NKW_GLTF_OUTER && !outer ? NKW_GLTF_TEXT : form;
    int fine = make_file(m, source, names ? path : NULL, outer, form, &file);
    fine = fine && (form != NKW_GLTF_BINARY || stay_smaller(m, source, &file));
    fine = fine && (!file.outer || model_put_file(outer, file.outer, file.outer_bytes));
    fine = fine && model_put_file(path, file.data, file.bytes);
    *bytes = file.bytes + file.outer_bytes;
    nkw_gltf_file_free(&file);
    free(outer);
    return fine;
}

/* ---- the report ---- */

void model_report_head(FILE *f, const nkw_document *d)
{
    output_text(f, d->file);
    fprintf(f, ": %s, %zu bytes\n", d->format, d->bytes);
    fputs("clip      keys        to       bytes          to    distance     weights  name\n", f);
}

void model_report(FILE *f, const nkw_document *d, size_t animation, const model_change *c)
{
    fprintf(f, "%4zu  %8zu  %8zu  %10zu  %10zu  %10.3g  %10.3g  ", animation, c->keys_before, c->keys, c->bytes_before,
            c->bytes, (double)c->error.distance, (double)c->error.floats);
    output_text(f, d->animations[animation].name);
    fputc('\n', f);
}

int model_rewrite(const model_source *source, int keeps, const char *form, const char *output, model_changer change,
                  const void *request)
{
    const int to_stdout = !output || strcmp(output, "-") == 0;
    FILE *report = to_stdout ? stderr : stdout;
    size_t bytes = 0;
    model m;
    extent e;
    int fine = model_open(&m, source->document);
    fine = extent_open(&e, source->document) && fine;
    fine = fine && change(&m, request, &e, report) && (m.is_obj || mend_starts(&m));
    if (fine)
        mend_note(&m);
    fine = fine && model_write(&m, keeps ? source : NULL, output, (nkw_gltf_form)model_form(form, output), &bytes);
    if (fine)
        fprintf(report, "written: %zu bytes\n", bytes);
    extent_free(&e);
    model_close(&m);
    return (to_stdout || output_close(stdout, NULL)) && fine;
}
