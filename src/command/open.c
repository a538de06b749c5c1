/* SPDX-License-Identifier: MIT */
/* Opening documents: in which process, and which tracks remain. */
#include "command.h"

#include <stdlib.h>
#include <string.h>

#include "apart.h"

static int in_process, leaves_faults;

void input_set_in_process(int chosen)
{
    in_process = chosen;
}

void input_set_holding(int holds)
{
    leaves_faults = !holds;
}

/* A document and what it is made of. A pointer to `all`, the first member, is a pointer to the whole. */
typedef struct opened {
    nkw_document all;
    nkw_document *own; /* of nkw_document_from_memory; or NULL */
    parcel block; /* of a child */
    nkw_document_animation *animations; /* in place of those of the document; or NULL */
    void **kept; /* two arrays of each of these */
} opened;

/* ---- tracks in error ---- */

/* Says which track is left out, and why. */
static void warn_of_track(const nkw_document *d, const nkw_document_animation *a, size_t track, nkw_result result)
{
    static const char *const targets[] = {"translation", "rotation", "scale", "weights"};
    size_t key = 0;
    output_text(stderr, d->file);
    fputs(": warning: clip ", stderr);
    output_text(stderr, a->name);
    fputs(": joint ", stderr);
    output_text(stderr, d->nodes[a->channels[track].joint].name);
    fprintf(stderr, " %s: ", targets[a->tracks[track].target]);
    if (nkw_track_validate(&a->tracks[track].track, &key) == result)
        fprintf(stderr, "key %zu: ", key);
    fprintf(stderr, "%s: it holds the rest pose\n", nkw_result_text(result));
}

/* The first track that the library refuses; SIZE_MAX if there is none, or if it is no track. */
static size_t find_refused(const nkw_document *d, size_t animation, nkw_work work, nkw_result *result)
{
    const nkw_clip_source source = nkw_document_clip_source(d, animation, NKW_CLIP_FLOAT32);
    const nkw_bytes_span none = {NULL, 0};
    size_t bytes = 0, bad = 0;
    *result = nkw_clip_build(&source, none, &bytes, &bad, work);
    return bytes == 0 && bad < source.track_count ? bad : SIZE_MAX;
}

/* Copies of the lists of an animation, so that tracks can be removed. */
static int copy_lists(opened *o, size_t animation)
{
    nkw_document_animation *a = &o->animations[animation];
    nkw_clip_track *tracks = malloc(a->track_count * sizeof *tracks + 1);
    nkw_document_channel *channels = malloc(a->track_count * sizeof *channels + 1);
    o->kept[2 * animation] = tracks;
    o->kept[2 * animation + 1] = channels;
    if (!tracks || !channels)
        return 0;
    memcpy(tracks, a->tracks, a->track_count * sizeof *tracks);
    memcpy(channels, a->channels, a->track_count * sizeof *channels);
    a->tracks = tracks;
    a->channels = channels;
    return 1;
}

static void remove_track(opened *o, size_t animation, size_t track)
{
    nkw_document_animation *a = &o->animations[animation];
    nkw_clip_track *tracks = o->kept[2 * animation];
    nkw_document_channel *channels = o->kept[2 * animation + 1];
    const size_t after = --a->track_count - track;
    memmove(tracks + track, tracks + track + 1, after * sizeof *tracks);
    memmove(channels + track, channels + track + 1, after * sizeof *channels);
}

static int begin_holding(opened *o)
{
    const size_t count = o->all.animation_count;
    if (o->animations)
        return 1;
    o->animations = malloc(count * sizeof *o->animations);
    o->kept = calloc(2 * count, sizeof *o->kept);
    if (!o->animations || !o->kept)
        return 0;
    memcpy(o->animations, o->all.animations, count * sizeof *o->animations);
    o->all.animations = o->animations;
    return 1;
}

/* Removes the refused tracks of an animation, one after another: of two tracks of one target the second one. */
static int hold_clip(opened *o, size_t animation)
{
    nkw_result result;
    nkw_work work = {NULL, NKW_CLIP_BUILD_WORK(o->all.animations[animation].track_count)};
    work.data = malloc(work.bytes + 1);
    size_t bad = work.data ? find_refused(&o->all, animation, work, &result) : SIZE_MAX;
    int fine = work.data != NULL;
    if (bad != SIZE_MAX)
        fine = begin_holding(o) && copy_lists(o, animation);
    for (; fine && bad != SIZE_MAX; bad = find_refused(&o->all, animation, work, &result)) {
        warn_of_track(&o->all, &o->all.animations[animation], bad, result);
        remove_track(o, animation, bad);
    }
    free(work.data);
    return fine;
}

/* ---- opening ---- */

/* Formats of readers of this library, by their first characters; of CSV and OBJ anything can be the first. */
static int is_own(const nkw_import_memory *memory)
{
    static const char bvh[] = "HIERARCHY", glb[] = "glTF";
    const unsigned char *data = memory->data;
    size_t i = memory->bytes >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    while (i < memory->bytes && data[i] && strchr(" \t\r\n", data[i]))
        i++;
    const size_t left = memory->bytes - i;
    return left == 0 || data[i] == '{' || data[i] == '[' || (left >= 4 && memcmp(data + i, glb, 4) == 0) ||
           (left >= 9 && memcmp(data + i, bvh, 9) == 0);
}

static nkw_document *read_document(const nkw_import_memory *memory, nkw_import_error *error)
{
    nkw_document *d = NULL;
    if (nkw_document_from_memory(memory, &d, error) == NKW_IMPORT_OK && input_prepares() &&
        nkw_document_prepare(d, input_preparation(), error) != NKW_IMPORT_OK) {
        nkw_document_close(d);
        d = NULL;
    }
    return d;
}

static int no_memory(void)
{
    fputs("nakawari: no memory\n", stderr);
    return 0;
}

nkw_document *input_open_memory(const nkw_import_memory *memory)
{
    nkw_import_error error;
    opened *o = calloc(1, sizeof *o);
    const int apart = apart_possible() && !in_process && !is_own(memory);
    const nkw_document *d = NULL;
    if (!o)
        no_memory();
    else if (apart)
        d = apart_read(memory, read_document, &o->block, &error);
    else
        d = o->own = read_document(memory, &error);
    if (o && !d)
        input_report(&error);
    if (d) {
        o->all = *d;
        input_warn(d);
    }
    int fine = d != NULL;
    for (size_t i = 0; fine && !leaves_faults && i < d->animation_count; i++)
        fine = hold_clip(o, i) || no_memory();
    if (o && !fine) {
        input_close(&o->all);
        return NULL;
    }
    return o ? &o->all : NULL;
}

nkw_document *input_open(const char *path)
{
    const int is_stdin = strcmp(path, "-") == 0;
    char *folder = input_folder(is_stdin ? "." : path);
    nkw_import_memory memory = {NULL, 0, path, folder, NULL, NULL, input_bvh_adds(), input_v_is_up()};
    unsigned char *data = folder ? input_read(path, &memory.bytes) : NULL;
    memory.data = data;
    nkw_document *d = data ? input_open_memory(&memory) : NULL;
    free(data);
    free(folder);
    return d;
}

void input_close(nkw_document *document)
{
    opened *o = (opened *)(void *)document;
    if (!o)
        return;
    for (size_t i = 0; o->kept && i < 2 * o->all.animation_count; i++)
        free(o->kept[i]);
    free(o->kept);
    free(o->animations);
    parcel_free(&o->block);
    nkw_document_close(o->own);
    free(o);
}
