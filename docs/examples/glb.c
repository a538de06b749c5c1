/* SPDX-License-Identifier: MIT */
#include "glb.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void glb_append(glb_bytes *b, const void *data, size_t size)
{
    if (b->failed || size == 0)
        return;
    if (b->size + size > b->room) {
        size_t room = 2 * (b->size + size);
        unsigned char *moved = realloc(b->data, room);
        b->failed = moved == NULL;
        if (!moved)
            return;
        b->data = moved;
        b->room = room;
    }
    memcpy(b->data + b->size, data, size);
    b->size += size;
}

void glb_print(glb_bytes *b, const char *format, ...)
{
    char text[1024];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (length < 0 || (size_t)length >= sizeof text)
        b->failed = 1;
    else
        glb_append(b, text, (size_t)length);
}

void glb_free(glb_bytes *b)
{
    const glb_bytes empty = {NULL, 0, 0, 0};
    free(b->data);
    *b = empty;
}

/* glTF's numbers are little-endian. */
static void append_numbers(glb_bytes *b, const unsigned char *data, size_t width, size_t count)
{
    const uint16_t one = 1;
    if (*(const unsigned char *)&one || width == 1)
        glb_append(b, data, width * count);
    else
        for (size_t i = 0; i < width * count; i++)
            glb_append(b, data + i / width * width + (width - 1 - i % width), 1);
}

size_t glb_view(glb *g, const void *data, size_t width, size_t count)
{
    static const unsigned char zeros[4] = {0};
    glb_append(&g->buffer, zeros, (4 - g->buffer.size % 4) % 4);
    glb_print(&g->views, "%s{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu}", g->view_count ? "," : "",
              g->buffer.size, width * count);
    append_numbers(&g->buffer, data, width, count);
    return g->view_count++;
}

size_t glb_accessor(glb *g, glb_layout layout, size_t count, const void *data, size_t size, const char *extra)
{
    const size_t width = layout.component == GLB_U8 ? 1 : layout.component == GLB_U16 ? 2 : 4;
    size_t view = glb_view(g, data, width, size / width);
    glb_print(&g->accessors, "%s{\"bufferView\":%zu,\"componentType\":%d,%s\"count\":%zu,\"type\":\"%s\"%s}",
              g->accessor_count ? "," : "", view, layout.component, layout.normalized ? "\"normalized\":true," : "",
              count, layout.type, extra);
    return g->accessor_count++;
}

size_t glb_sparse_vec3(glb *g, size_t count, size_t changed, const uint16_t *indices, const float *values,
                       const char *extra)
{
    const char *comma = g->accessor_count ? "," : "";
    if (changed == 0)
        glb_print(&g->accessors, "%s{\"componentType\":5126,\"count\":%zu,\"type\":\"VEC3\"%s}", comma, count, extra);
    else {
        size_t at = glb_view(g, indices, sizeof *indices, changed);
        size_t to = glb_view(g, values, sizeof *values, changed * 3);
        glb_print(&g->accessors,
                  "%s{\"componentType\":5126,\"count\":%zu,\"type\":\"VEC3\"%s,\"sparse\":{\"count\":%zu,"
                  "\"indices\":{\"bufferView\":%zu,\"componentType\":5123},\"values\":{\"bufferView\":%zu}}}",
                  comma, count, extra, changed, at, to);
    }
    return g->accessor_count++;
}

/* A little-endian number. */
static void put_u32(unsigned char *to, size_t value)
{
    for (int i = 0; i < 4; i++)
        to[i] = (unsigned char)(value >> 8 * i & 0xff);
}

static int write_chunk(FILE *f, const char *type, const glb_bytes *b, char padding)
{
    unsigned char head[8];
    size_t rest = (4 - b->size % 4) % 4;
    put_u32(head, b->size + rest);
    memcpy(head + 4, type, 4);
    int done = fwrite(head, 1, sizeof head, f) == sizeof head && fwrite(b->data, 1, b->size, f) == b->size;
    for (size_t i = 0; done && i < rest; i++)
        done = fputc(padding, f) != EOF;
    return done;
}

int glb_write(const char *path, const glb_bytes *json, const glb_bytes *buffer)
{
    unsigned char head[12] = {'g', 'l', 'T', 'F', 2};
    size_t size = sizeof head + 16 + (json->size + 3) / 4 * 4 + (buffer->size + 3) / 4 * 4;
    if (json->failed || buffer->failed) {
        errno = ENOMEM;
        return 0;
    }
    FILE *f = fopen(path, "wb");
    if (!f)
        return 0;
    put_u32(head + 8, size);
    int done = fwrite(head, 1, sizeof head, f) == sizeof head && write_chunk(f, "JSON", json, ' ') &&
               write_chunk(f, "BIN\0", buffer, '\0');
    return fclose(f) == 0 && done;
}
