/* SPDX-License-Identifier: MIT */
/* glTF 2.0, 4.4 and 3.6.1: the container of a tree and its buffer. */
#include <stdlib.h>
#include <string.h>

#include "file.h"
#include "sink.h"

void nkw_gltf_file_free(nkw_gltf_file *file)
{
    const nkw_gltf_file none = {NULL, 0, NULL, 0, 0, 0};
    free(file->data);
    free(file->outer);
    *file = none;
}

static void put_u32(unsigned char *to, size_t value)
{
    for (int i = 0; i < 4; i++)
        to[i] = (unsigned char)(value >> 8 * i & 0xff);
}

/* A chunk, padded to a multiple of four bytes. Returns its end. */
static unsigned char *put_chunk(unsigned char *to, const char *type, const void *data, size_t bytes, char padding)
{
    const size_t padded = (bytes + 3) / 4 * 4;
    put_u32(to, padded);
    memcpy(to + 4, type, 4);
    memcpy(to + 8, data, bytes);
    memset(to + 8 + bytes, padding, padded - bytes);
    return to + 8 + padded;
}

static int write_binary(nkwi_sink *s, const char *text, size_t length, nkw_gltf_file *file)
{
    const size_t json = (length + 3) / 4 * 4, bin = (s->bytes + 3) / 4 * 4;
    if (json > NKWI_BYTES_MOST - 28 || bin > NKWI_BYTES_MOST - 28 - json)
        return nkwi_fail(s->error, NULL, NKW_IMPORT_TOO_LARGE, "the file exceeds 4 GiB");
    file->bytes = 12 + 8 + json + (s->bytes ? 8 + bin : 0);
    file->data = (unsigned char *)malloc(file->bytes);
    if (!file->data)
        return 0;
    memcpy(file->data, "glTF\2\0\0\0", 8);
    put_u32(file->data + 8, file->bytes);
    unsigned char *at = put_chunk(file->data + 12, "JSON", text, length, ' ');
    if (s->bytes)
        put_chunk(at, "BIN\0", s->data, s->bytes, '\0');
    return 1;
}

static char *data_uri(const unsigned char *data, size_t bytes)
{
    static const char head[] = "data:application/octet-stream;base64,";
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    char *uri = (char *)malloc(sizeof head + (bytes + 2) / 3 * 4), *to = uri;
    if (!uri)
        return NULL;
    memcpy(to, head, sizeof head);
    to += sizeof head - 1;
    for (size_t i = 0; i < bytes; i += 3) {
        uint32_t bits = (uint32_t)data[i] << 16;
        bits |= i + 1 < bytes ? (uint32_t)data[i + 1] << 8 : 0;
        bits |= i + 2 < bytes ? (uint32_t)data[i + 2] : 0;
        for (unsigned k = 0; k < 4; k++)
            *to++ = i + k < bytes + 1 ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
    *to = 0;
    return uri;
}

static void set_buffer(nkwi_sink *s, json_t *root, nkw_gltf_form form, const char *uri)
{
    json_t *buffer = json_object(), *buffers = json_array();
    nkwi_set(s, buffer, "byteLength", json_integer((json_int_t)s->bytes));
    char *data = form == NKW_GLTF_TEXT ? data_uri(s->data, s->bytes) : NULL;
    if (form == NKW_GLTF_TEXT)
        nkwi_set(s, buffer, "uri", json_string(data ? data : ""));
    if (form == NKW_GLTF_OUTER)
        nkwi_set(s, buffer, "uri", nkwi_uri(s, uri));
    s->failed = s->failed || (form == NKW_GLTF_TEXT && !data);
    free(data);
    nkwi_put(s, buffers, buffer);
    nkwi_set(s, root, "buffers", buffers);
}

/* Empty arrays are not valid (3.3). */
static void drop_empty(json_t *root, const char *key)
{
    if (json_array_size(json_object_get(root, key)) == 0)
        json_object_del(root, key);
}

int nkwi_sink_write(nkwi_sink *s, json_t *root, nkw_gltf_form form, const char *uri, size_t precision,
                    nkw_gltf_file *file)
{
    json_object_del(root, "buffers");
    if (s->bytes > 0)
        set_buffer(s, root, form, uri);
    drop_empty(root, "bufferViews");
    drop_empty(root, "accessors");
    drop_empty(root, "animations");
    char *text = s->failed ? NULL : json_dumps(root, JSON_COMPACT | JSON_REAL_PRECISION(precision));
    const size_t length = text ? strlen(text) : 0;
    int done = 0;
    if (text && form == NKW_GLTF_BINARY)
        done = write_binary(s, text, length, file);
    else if (text) {
        file->data = (unsigned char *)text;
        file->bytes = length;
        file->outer = form == NKW_GLTF_OUTER ? s->data : NULL;
        file->outer_bytes = form == NKW_GLTF_OUTER ? s->bytes : 0;
        if (file->outer)
            s->data = NULL;
        text = NULL;
        done = 1;
    }
    free(text);
    if (!done && s->error->code == NKW_IMPORT_OK)
        nkwi_fail(s->error, NULL, s->bytes > NKWI_BYTES_MOST / 2 ? NKW_IMPORT_TOO_LARGE : NKW_IMPORT_NO_MEMORY,
                  "no memory for the file, or it exceeds 4 GiB");
    return done;
}
