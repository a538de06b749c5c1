/* SPDX-License-Identifier: MIT */
/* A glTF 2.0 file with other animations: its steps, in their order (rewrite.h). */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rewrite.h"

int nkwi_rewriter_no_memory(nkwi_rewriter *r)
{
    if (r->sink.error->code == NKW_IMPORT_OK)
        nkwi_fail(r->sink.error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the file");
    return 0;
}

size_t nkwi_rewriter_index(const json_t *object, const char *key)
{
    const json_t *value = json_object_get(object, key);
    return json_is_integer(value) && json_integer_value(value) >= 0 ? (size_t)json_integer_value(value) : SIZE_MAX;
}

static int check_file(nkwi_rewriter *r)
{
    const json_t *used = json_object_get(r->root, "extensionsUsed");
    for (size_t i = 0; i < json_array_size(used); i++) {
        const char *name = json_string_value(json_array_get(used, i));
        if (name && strstr(name, "meshopt_compression"))
            return nkwi_fail(r->sink.error, NULL, NKW_IMPORT_UNSUPPORTED, "files with %s cannot be rewritten", name);
    }
    return 1;
}

static json_t *list_of(nkwi_rewriter *r, const char *key)
{
    json_t *list = json_object_get(r->root, key);
    if (!list)
        json_object_set_new(r->root, key, list = json_array());
    return list;
}

/* Nine digits are enough for a float. */
static int is_short(const json_t *value)
{
    const double number = json_real_value(value);
    char text[32];
    if (!json_is_real(value) || (double)(float)number == number)
        return 1;
    snprintf(text, sizeof text, "%.9g", number);
    return strtod(text, NULL) == number;
}

static int are_short(json_t *value)
{
    const char *key;
    json_t *member;
    size_t i;
    if (json_is_array(value))
        json_array_foreach(value, i, member) if (!are_short(member)) return 0;
    json_object_foreach(value, key, member) if (!are_short(member)) return 0;
    return is_short(value);
}

static int rewrite(nkwi_rewriter *r, nkw_gltf_form form, const char *uri, nkw_gltf_file *file)
{
    if (!nkwi_gltf_begin(&r->g) || !check_file(r))
        return 0;
    nkwi_sink_open(&r->sink, r->g.error, list_of(r, "bufferViews"), list_of(r, "accessors"));
    nkwi_sink_begin_keys(&r->sink);
    nkwi_set(&r->sink, r->sink.view, "new", json_true());
    const int done = nkwi_rewriter_animations(r);
    nkwi_sink_end_keys(&r->sink);
    if (!done)
        return 0;
    nkwi_rewriter_images(r, file);
    return nkwi_rewriter_views(r) && nkwi_rewriter_buffers(r) &&
           nkwi_sink_write(&r->sink, r->root, form, uri, are_short(r->root) ? 9 : 17, file);
}

nkw_import_result nkw_gltf_rewrite(const nkw_gltf_rewriting *rewriting, nkw_gltf_form form, const char *uri,
                                   nkw_gltf_file *file, nkw_import_error *error)
{
    const nkw_gltf_file none = {NULL, 0, NULL, 0, 0, 0};
    nkw_import_memory memory = *rewriting->source;
    nkw_import_error own;
    char *folder = NULL;
    nkwi_document document;
    nkwi_rewriter r;
    error = error ? error : &own;
    memset(&r, 0, sizeof r);
    memset(&document, 0, sizeof document);
    document.memory.most = SIZE_MAX;
    nkwi_fault_none(error, memory.file);
    *file = none;
    r.rewriting = rewriting;
    if (nkwi_document_reader(&memory, &folder, error))
        r.root = nkwi_gltf_open(&r.g, &document, &memory, 0, error);
    if (!r.root || !rewrite(&r, form, uri ? uri : "", file)) {
        nkw_gltf_file_free(file);
        if (error->code == NKW_IMPORT_OK)
            nkwi_fail(error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the file");
    }
    nkwi_sink_close(&r.sink);
    nkwi_give(&r.g.scratch);
    nkwi_give(&document.memory);
    json_decref(r.root);
    free(folder);
    return error->code;
}
