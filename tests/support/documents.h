/* SPDX-License-Identifier: MIT */
/* Small glTF files, written in the tests with ' in place of ". */
#ifndef NAKAWARI_TESTS_DOCUMENTS_H
#define NAKAWARI_TESTS_DOCUMENTS_H

#include <stdlib.h>
#include <string.h>

#include <nakawari/import.h>

#include "expect.h"

/* The outer file data.bin of such a file. */
typedef struct outer {
    const void *data;
    size_t bytes;
} outer;

static inline size_t read_outer(void *user, const char *path, void *out, size_t size)
{
    const outer *o = (const outer *)user;
    if (strcmp(path, "data.bin") != 0 || size > o->bytes)
        return SIZE_MAX;
    if (out)
        memcpy(out, o->data, size);
    return o->bytes;
}

/* The text with " in place of '; to be freed. */
static inline char *quoted(const char *text)
{
    size_t length = strlen(text);
    char *copy = (char *)malloc(length + 1);
    assert_non_null(copy);
    for (size_t i = 0; i <= length; i++)
        copy[i] = (char)(text[i] == '\'' ? '"' : text[i]);
    return copy;
}

/* Opens a text whose buffer, if it has one, is data.bin. */
static inline nkw_import_result open_text(const char *text, const void *data, size_t bytes, nkw_document **document,
                                          nkw_import_error *error)
{
    char *json = quoted(text);
    outer o = {data, bytes};
    const nkw_import_memory memory = {json, strlen(json), "test.gltf", NULL, read_outer, &o, 0, 0};
    nkw_import_result result = nkw_document_from_memory(&memory, document, error);
    assert_int_equal(result, error->code);
    assert_int_equal(*document == NULL, result != NKW_IMPORT_OK);
    free(json);
    return result;
}

/* A file that is valid. */
static inline nkw_document *opened(const char *text, const void *data, size_t bytes)
{
    nkw_document *document;
    nkw_import_error error;
    if (open_text(text, data, bytes, &document, &error) != NKW_IMPORT_OK)
        print_error("%s:%s: %s\n", error.file, error.place, error.reason);
    assert_int_equal(error.code, NKW_IMPORT_OK);
    return document;
}

/* A file that is refused with this code, at this place. */
#define expect_refused(text, data, bytes, code, place)                                                                 \
    expect_refused_at((text), (data), (bytes), (code), (place), __FILE__, __LINE__)

static inline void expect_refused_at(const char *text, const void *data, size_t bytes, nkw_import_result code,
                                     const char *place, const char *file, int line)
{
    nkw_document *document;
    nkw_import_error error;
    nkw_import_result result = open_text(text, data, bytes, &document, &error);
    nkw_document_close(document);
    if (result == code && strcmp(error.place, place) == 0 && strcmp(error.file, "test.gltf") == 0 && error.reason[0])
        return;
    print_error("got %d at \"%s\": %s\nwant %d at \"%s\"\n", (int)result, error.place, error.reason, (int)code, place);
    _fail(file, line);
}

#endif
