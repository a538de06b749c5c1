/* SPDX-License-Identifier: MIT */
/* glTF 2.0, 3.6.1: buffers: the chunk of a GLB, data URIs, outer files. Each is read when it is first used. */
#include <string.h>

#include "file.h"
#include "gltf.h"

/* Room for `bytes` more bytes of files. */
static unsigned char *room_of(nkwi_gltf *g, const nkwi_value *at, size_t bytes)
{
    nkw_document *document = &g->document->all;
    if (bytes > NKWI_BYTES_MOST - document->bytes) {
        nkwi_fail(g->error, &at->place, NKW_IMPORT_TOO_LARGE, "the files have more than %zu bytes", NKWI_BYTES_MOST);
        return NULL;
    }
    return (unsigned char *)nkwi_gltf_scratch(g, at, bytes, 1);
}

static int read_data(nkwi_gltf *g, const nkwi_value *uri, const char *text, nkwi_buffer *buffer)
{
    size_t length = strlen(text), bytes;
    if (buffer->bytes > length)
        return nkwi_fail(g->error, &uri->place, NKW_IMPORT_INVALID, "has %zu characters for %zu bytes", length,
                         buffer->bytes);
    unsigned char *data = (unsigned char *)nkwi_gltf_scratch(g, uri, buffer->bytes, 1);
    if (!data)
        return 0;
    const char *wrong = nkwi_bytes_from_uri(text, data, buffer->bytes, &bytes);
    if (wrong)
        return nkwi_fail(g->error, &uri->place, NKW_IMPORT_INVALID, "%s", wrong);
    if (bytes < buffer->bytes)
        return nkwi_fail(g->error, &uri->place, NKW_IMPORT_INVALID, "has %zu bytes, byteLength is %zu", bytes,
                         buffer->bytes);
    buffer->data = data;
    return 1;
}

static int read_outer(nkwi_gltf *g, const nkwi_value *uri, const char *text, nkwi_buffer *buffer)
{
    const nkw_import_memory *memory = g->memory;
    char *path = (char *)nkwi_gltf_scratch(g, uri, strlen(text) + 1, 1);
    if (!path)
        return 0;
    const char *wrong = nkwi_path_from_uri(text, path);
    if (wrong)
        return nkwi_fail(g->error, &uri->place, NKW_IMPORT_UNREADABLE, "%s: %s", text, wrong);
    if (!memory->reader)
        return nkwi_fail(g->error, &uri->place, NKW_IMPORT_UNREADABLE, "%s: no folder to read it from", path);
    size_t bytes = memory->reader(memory->user, path, NULL, 0);
    if (bytes == SIZE_MAX)
        return nkwi_fail(g->error, &uri->place, NKW_IMPORT_UNREADABLE, "%s: cannot be read", path);
    if (bytes < buffer->bytes)
        return nkwi_fail(g->error, &uri->place, NKW_IMPORT_INVALID, "%s has %zu bytes, byteLength is %zu", path, bytes,
                         buffer->bytes);
    unsigned char *data = room_of(g, uri, buffer->bytes);
    if (!data)
        return 0;
    if (memory->reader(memory->user, path, data, buffer->bytes) == SIZE_MAX)
        return nkwi_fail(g->error, &uri->place, NKW_IMPORT_UNREADABLE, "%s: cannot be read", path);
    buffer->data = data;
    g->document->all.bytes += buffer->bytes;
    g->document->memory.most = NKWI_MEMORY_MOST(g->document->all.bytes);
    return 1;
}

static int read_chunk(nkwi_gltf *g, const nkwi_value *object, size_t index, nkwi_buffer *buffer)
{
    if (index > 0 || !g->bin)
        return nkwi_fail(g->error, &object->place, NKW_IMPORT_INVALID, "has no uri, and is no chunk of a GLB");
    if (g->bin_bytes < buffer->bytes)
        return nkwi_fail(g->error, &object->place, NKW_IMPORT_INVALID, "the chunk has %zu bytes, byteLength is %zu",
                         g->bin_bytes, buffer->bytes);
    buffer->data = g->bin;
    return 1;
}

int nkwi_gltf_buffer(nkwi_gltf *g, size_t index, nkwi_buffer *out)
{
    nkwi_buffer *buffer = &g->buffers[index];
    nkwi_value object = nkwi_element(&g->buffer_list, index), length = nkwi_member(&object, "byteLength");
    nkwi_value uri = nkwi_member(&object, "uri");
    if (!buffer->data) {
        if (!nkwi_is_object(g->error, &object) || !nkwi_integer(g->error, &length, &buffer->bytes))
            return 0;
        const char *text = json_string_value(uri.json);
        if (buffer->bytes == 0)
            return nkwi_fail(g->error, &length.place, NKW_IMPORT_INVALID, "the buffer is empty");
        if (uri.json && (!text || strlen(text) != json_string_length(uri.json)))
            return nkwi_fail(g->error, &uri.place, NKW_IMPORT_INVALID, "is no URI");
        int done = !text                            ? read_chunk(g, &object, index, buffer)
                   : strncmp(text, "data:", 5) == 0 ? read_data(g, &uri, text, buffer)
                                                    : read_outer(g, &uri, text, buffer);
        if (!done)
            return 0;
    }
    *out = *buffer;
    return 1;
}
