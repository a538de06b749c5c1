/* SPDX-License-Identifier: MIT */
#include "command.h"

#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/scalar.h>

/* The standard input is kept in memory; more is an error. */
#define STDIN_MOST ((size_t)1 << 31)

static int bvh_adds, v_is_up;

void input_set_bvh(int adds_offset)
{
    bvh_adds = adds_offset;
}

int input_bvh_adds(void)
{
    return bvh_adds;
}

int input_set_v(const char *direction)
{
    static const char *const directions[] = {"down", "up"};
    const int found = direction ? words_find(direction, directions, 2) : 0;
    v_is_up = found == 1;
    return found >= 0;
}

int input_v_is_up(void)
{
    return v_is_up;
}

static nkw_document_preparation preparation;

int input_set_preparation(const nkw_document_preparation *p)
{
    preparation = *p;
    preparation.make_normals = p->crease != -1.0f;
    preparation.crease = preparation.make_normals ? nkw_radians_from_degrees(p->crease) : 0.0f;
    return preparation.crease >= 0.0f && preparation.crease < 1e6f;
}

int input_prepares(void)
{
    return preparation.apply_transforms || preparation.fix_facing || preparation.make_normals ||
           preparation.make_tangents;
}

const nkw_document_preparation *input_preparation(void)
{
    return &preparation;
}

static nkw_import_error last_error;

const nkw_import_error *input_error(void)
{
    return &last_error;
}

void input_report(const nkw_import_error *error)
{
    last_error = *error;
    output_text(stderr, error->file);
    if (error->place[0]) {
        fputs(":", stderr);
        output_text(stderr, error->place);
    }
    fputs(": ", stderr);
    output_text(stderr, error->reason);
    fputs("\n", stderr);
}

/* All bytes of the standard input. Returns NULL, errno set, if it cannot. */
static unsigned char *read_all(FILE *f, size_t *bytes)
{
    unsigned char *data = NULL;
    size_t room = 0, count = 0;
    for (;;) {
        if (count == room) {
            unsigned char *more = room < STDIN_MOST ? realloc(data, room ? room * 2 : 65536) : NULL;
            if (!more)
                break;
            data = more;
            room = room ? room * 2 : 65536;
        }
        size_t got = fread(data + count, 1, room - count, f);
        count += got;
        if (got == 0) {
            *bytes = count;
            if (!ferror(f))
                return data;
            free(data);
            return NULL;
        }
    }
    free(data);
    errno = room < STDIN_MOST ? ENOMEM : EFBIG;
    return NULL;
}

unsigned char *input_read(const char *path, size_t *bytes)
{
    const int is_stdin = strcmp(path, "-") == 0;
    FILE *f = is_stdin ? stdin : fopen(path, "rb");
    unsigned char *data = f ? read_all(f, bytes) : NULL;
    if (!data) {
        nkw_import_error error = {NKW_IMPORT_UNREADABLE, NKW_OK, "", "", ""};
        snprintf(error.file, sizeof error.file, "%s", path);
        snprintf(error.reason, sizeof error.reason, "cannot be read: %s", strerror(errno));
        input_report(&error);
    }
    if (f && !is_stdin)
        fclose(f);
    return data;
}

const char *input_name(const char *path)
{
    const char *end = strrchr(path, '/');
    return end ? end + 1 : path;
}

/* The folder of a path, with its last separator; "." without one. */
char *input_folder(const char *path)
{
    size_t length = (size_t)(input_name(path) - path);
    char *folder = malloc(length + 2);
    if (folder) {
        memcpy(folder, path, length);
        strcpy(folder + length, length ? "" : ".");
    }
    return folder;
}

char *input_beside(const nkw_document *d, const char *path)
{
    const size_t folder = (size_t)(input_name(d->file) - d->file);
    char *name = malloc(folder + strlen(path) + 1);
    if (name) {
        memcpy(name, d->file, folder);
        strcpy(name + folder, path);
    }
    return name;
}

unsigned char *input_read_beside(const nkw_document *d, const char *path, size_t *bytes)
{
    char *name = input_beside(d, path);
    FILE *f = name ? fopen(name, "rb") : NULL;
    unsigned char *data = f ? read_all(f, bytes) : NULL;
    if (f)
        fclose(f);
    free(name);
    return data;
}

void input_warn(const nkw_document *document)
{
    for (size_t i = 0; i < document->warning_count; i++) {
        output_text(stderr, document->file);
        fputs(": warning: ", stderr);
        output_text(stderr, document->warnings[i]);
        fputs("\n", stderr);
    }
}

static int is_name(const nkw_document *d, size_t joint, const char *text, size_t length)
{
    const char *name = d->nodes[joint].name;
    return strlen(name) == length && memcmp(name, text, length) == 0;
}

int input_is_joint(const nkw_document *d, size_t joint, const char *text, size_t length)
{
    char number[24];
    const int digits = snprintf(number, sizeof number, "%zu", d->nodes[joint].number);
    if (is_name(d, joint, text, length))
        return 1;
    if ((size_t)digits != length || memcmp(number, text, length) != 0)
        return 0;
    for (size_t j = 0; j < d->skeleton.joint_count; j++)
        if (is_name(d, j, text, length))
            return 0;
    return 1;
}

static int select_name(const nkw_document *d, const char *clip, input_clips *clips)
{
    for (size_t i = 0; i < d->animation_count; i++)
        if (strcmp(d->animations[i].name, clip) == 0) {
            clips->first = i;
            return 1;
        }
    return 0;
}

int input_select(const nkw_document *d, const char *clip, input_clips *clips)
{
    clips->first = d->animation_count ? 0 : INPUT_REST;
    clips->count = 1;
    if (!clip)
        return 1;
    if (strcmp(clip, "rest") == 0 || strcmp(clip, "-1") == 0) {
        clips->first = INPUT_REST;
        return 1;
    }
    if (strcmp(clip, "all") == 0) {
        clips->count = d->animation_count ? d->animation_count : 1;
        return 1;
    }
    if (select_name(d, clip, clips) || (options_index(clip, &clips->first) && clips->first < d->animation_count))
        return 1;
    output_text(stderr, d->file);
    fputs(": no clip ", stderr);
    output_text(stderr, clip);
    fprintf(stderr, ": it has %zu\n", d->animation_count);
    return 0;
}

const char *input_clip_name(const nkw_document *document, size_t animation)
{
    return animation < document->animation_count ? document->animations[animation].name : "";
}

long input_clip_number(size_t animation)
{
    return animation == INPUT_REST ? -1 : (long)animation;
}
