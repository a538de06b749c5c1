/* SPDX-License-Identifier: MIT */
/* Files for Assimp: the first file from memory, the others from its folder by the reader of the document. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "assimp.h"
#include "file.h"

/* An open file. `file` is the first member: a pointer to it is a pointer to the whole structure. */
typedef struct stream {
    struct aiFile file;
    const char *data;
    void *owned; /* to be freed, or NULL */
    size_t bytes, at;
    nkwi_assimp_files *files;
    int is_counted; /* in files->bytes */
} stream;

static size_t read_stream(struct aiFile *file, char *out, size_t size, size_t count)
{
    stream *s = (stream *)(void *)file->UserData;
    size_t left = size > 0 ? (s->bytes - s->at) / size : 0;
    s->files->bytes += s->is_counted ? 0 : s->bytes;
    s->is_counted = 1;
    count = count < left ? count : left;
    if (count > 0)
        memcpy(out, s->data + s->at, size * count);
    s->at += size * count;
    return count;
}

static size_t write_stream(struct aiFile *file, const char *data, size_t size, size_t count)
{
    (void)file, (void)data, (void)size, (void)count;
    return 0;
}

static size_t tell_stream(struct aiFile *file)
{
    return ((stream *)(void *)file->UserData)->at;
}

static size_t size_stream(struct aiFile *file)
{
    return ((stream *)(void *)file->UserData)->bytes;
}

/* Offsets are unsigned: from the end they count back. */
static enum aiReturn seek_stream(struct aiFile *file, size_t offset, enum aiOrigin origin)
{
    stream *s = (stream *)(void *)file->UserData;
    size_t base = origin == aiOrigin_CUR ? s->at : origin == aiOrigin_END ? s->bytes : 0;
    size_t at = origin == aiOrigin_END && offset <= s->bytes ? base - offset : base + offset;
    if (at > s->bytes)
        return aiReturn_FAILURE;
    s->at = at;
    return aiReturn_SUCCESS;
}

static void flush_stream(struct aiFile *file)
{
    (void)file;
}

/* Another file than the first, of at most `most` bytes. */
static int load(const nkw_import_memory *memory, const char *name, size_t most, stream *s)
{
    char *path = (char *)malloc(strlen(name) + 1);
    int good = path && memory->reader && !nkwi_path_from_name(name, path);
    s->bytes = good ? memory->reader(memory->user, path, NULL, 0) : SIZE_MAX;
    good = s->bytes <= most;
    s->owned = good ? malloc(s->bytes + 1) : NULL;
    good = s->owned && memory->reader(memory->user, path, s->owned, s->bytes) == s->bytes;
    s->data = (const char *)s->owned;
    free(path);
    return good;
}

static void close_stream(struct aiFileIO *io, struct aiFile *file)
{
    stream *s = (stream *)(void *)file->UserData;
    (void)io;
    free(s->owned);
    free(s);
}

/*
 * Assimp 5.2 plays every .md5anim at 24 frames per second. The line of the file is "frameRate 30". Returns 0 if there
 * is none.
 */
static double frame_rate_of(const stream *s)
{
    static const char key[] = "\nframeRate";
    size_t length = sizeof key - 1;
    char number[32];
    for (size_t i = 0; i + length + 1 < s->bytes; i++)
        if (memcmp(s->data + i, key, length) == 0) {
            size_t left = s->bytes - i - length, n = left < sizeof number - 1 ? left : sizeof number - 1;
            memcpy(number, s->data + i + length, n);
            number[n] = 0;
            return strtod(number, NULL); /* an integer in this format: without the decimal point of the locale */
        }
    return 0.0;
}

static int ends_with(const char *text, const char *end)
{
    size_t length = strlen(text), tail = strlen(end);
    return length >= tail && strcmp(text + length - tail, end) == 0;
}

static struct aiFile *open_stream(struct aiFileIO *io, const char *name, const char *mode)
{
    nkwi_assimp_files *files = (nkwi_assimp_files *)(void *)io->UserData;
    const struct aiFile methods = {read_stream, write_stream, tell_stream, size_stream,
                                   seek_stream, flush_stream, NULL};
    stream *s = strchr(mode, 'w') ? NULL : (stream *)calloc(1, sizeof *s);
    if (!s)
        return NULL;
    s->file = methods;
    s->file.UserData = (char *)s;
    s->files = files;
    s->is_counted = strcmp(name, files->name) == 0;
    s->data = (const char *)files->memory->data;
    s->bytes = files->memory->bytes;
    if (!s->is_counted && !load(files->memory, name, NKWI_BYTES_MOST - files->bytes, s)) {
        close_stream(io, &s->file);
        return NULL;
    }
    if (ends_with(name, ".md5anim"))
        files->frame_rate = frame_rate_of(s);
    if (!files->fault && (ends_with(name, ".md5anim") || ends_with(name, ".md5mesh")))
        files->fault = nkwi_assimp_md5_fault(s->data, s->bytes);
    if (files->fault) {
        close_stream(io, &s->file);
        return NULL;
    }
    return &s->file;
}

void nkwi_assimp_files_begin(nkwi_assimp_files *files, const nkw_import_memory *memory, const char *name)
{
    memset(files, 0, sizeof *files);
    files->io.OpenProc = open_stream;
    files->io.CloseProc = close_stream;
    files->io.UserData = (char *)files;
    files->memory = memory;
    files->name = name;
    files->bytes = memory->bytes;
}

/* Whether the first `most` bytes have the text. */
static int has(const nkw_import_memory *memory, size_t most, const char *text)
{
    const char *data = (const char *)memory->data;
    size_t length = strlen(text), end = memory->bytes < most ? memory->bytes : most;
    for (size_t i = 0; i + length <= end; i++)
        if (memcmp(data + i, text, length) == 0)
            return 1;
    return 0;
}

/* Formats whose beginning names them. */
static const char *extension_of_content(const nkw_import_memory *memory)
{
    static const struct {
        size_t most;
        const char *text, *extension;
    } marks[] = {{4, "xof ", ".x"},
                 {32, "Kaydara FBX Binary", ".fbx"},
                 {1024, "FBXHeaderExtension", ".fbx"},
                 {16, "; FBX ", ".fbx"},
                 {4096, "<COLLADA", ".dae"},
                 {4, "IDP2", ".md2"},
                 {4, "IDP3", ".md3"},
                 {4, "ply\n", ".ply"},
                 {5, "ply\r\n", ".ply"},
                 {7, "BLENDER", ".blend"},
                 {15, "INTERQUAKEMODEL", ".iqm"},
                 {4, "BB3D", ".b3d"},
                 {10, "MS3D000000", ".ms3d"}};
    if (has(memory, 10, "MD5Version"))
        return has(memory, 4096, "numFrames") ? ".md5anim" : has(memory, 4096, "numCuts") ? ".md5camera" : ".md5mesh";
    for (size_t i = 0; i < sizeof marks / sizeof *marks; i++)
        if (has(memory, marks[i].most, marks[i].text))
            return marks[i].extension;
    return NULL;
}

const char *nkwi_assimp_extension(const nkw_import_memory *memory)
{
    const char *found = extension_of_content(memory), *name = memory->file ? memory->file : "";
    const char *dot = strrchr(name, '.');
    if (found)
        return found;
    return dot && !strpbrk(dot, "/\\") && dot[1] ? dot : "";
}
