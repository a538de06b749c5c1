/* SPDX-License-Identifier: MIT */
/*
 * The binary form of FBX. A node is
 *
 *     end of the node, number of values, bytes of the values   each 4 bytes, from version 7500 on 8
 *     length of the name (1 byte), name, values, nodes below
 *
 * and a node of zeros ends the nodes below. Offsets count from the start of the file.
 */
#include <string.h>

#if defined(NKWI_ZLIB)
#include <zlib.h>
#endif

#include "fbx_tree.h"

typedef struct reader {
    nkwi_fbx_tree *tree;
    const unsigned char *data;
    size_t bytes, at;
    size_t ends[NKWI_FBX_DEPTH + 1]; /* of the open nodes */
} reader;

static uint64_t number_at(const nkwi_fbx_tree *tree, const unsigned char *from, size_t size)
{
    uint64_t number = 0;
    for (size_t i = 0; i < size; i++)
        number = number << 8 | from[tree->is_big ? i : size - 1 - i];
    return number;
}

/* The next unsigned number; the caller knows that its bytes are there. */
static uint64_t take(reader *r, size_t size)
{
    const uint64_t number = number_at(r->tree, r->data + r->at, size);
    r->at += size;
    return number;
}

static int64_t signed_of(uint64_t bits, size_t size)
{
    const uint64_t sign = (uint64_t)1 << (8 * size - 1);
    return (bits & sign) && size < 8 ? (int64_t)(bits - sign) - (int64_t)(sign - 1) - 1 : (int64_t)bits;
}

/* The bytes of an element of this type, 0 for an unknown one. */
static size_t size_of(char type)
{
    switch (type) {
    case 'B':
    case 'C':
    case 'b':
    case 'c':
        return 1;
    case 'Y':
        return 2;
    case 'I':
    case 'F':
    case 'i':
    case 'f':
        return 4;
    case 'L':
    case 'D':
    case 'l':
    case 'd':
        return 8;
    default:
        return 0;
    }
}

static double real_of(uint64_t bits, char type, size_t size)
{
    float single;
    double real;
    const uint32_t low = (uint32_t)bits;
    if (type == 'f' || type == 'F') {
        memcpy(&single, &low, sizeof single);
        return (double)single;
    }
    if (type == 'd' || type == 'D') {
        memcpy(&real, &bits, sizeof real);
        return real;
    }
    return (double)signed_of(bits, size);
}

static int read_number(reader *r, char type, nkwi_fbx_value *value)
{
    const size_t size = size_of(type);
    const uint64_t bits = take(r, size);
    const int is_real = type == 'F' || type == 'D';
    value->kind = is_real ? 'R' : 'I';
    value->real = real_of(bits, type, size);
    /* A real outside of the integers is none. */
    value->integer = !is_real                                        ? signed_of(bits, size)
                     : value->real > -9.2e18 && value->real < 9.2e18 ? (int64_t)value->real
                                                                     : 0;
    return 1;
}

static int read_text(reader *r, size_t end, nkwi_fbx_value *value)
{
    const size_t length = (size_t)take(r, 4);
    if (length > end - r->at)
        return nkwi_fbx_fail(r->tree, r->at, "a text is longer than its node");
    value->kind = 'S';
    value->text = (const char *)r->data + r->at;
    value->bytes = length;
    r->at += length;
    return 1;
}

static int read_array(reader *r, char type, size_t end, nkwi_fbx_value *value)
{
    const uint64_t count = take(r, 4), encoding = take(r, 4), bytes = take(r, 4);
    const size_t size = size_of(type);
    const uint64_t stored = encoding == 1 ? bytes : count * size;
    if (stored > end - r->at || encoding > 1)
        return nkwi_fbx_fail(r->tree, r->at, "an array is longer than its node, or of an unknown encoding");
    value->kind = 'A';
    value->element = type;
    value->is_packed = encoding == 1;
    value->integer = (int64_t)count;
    value->text = (const char *)r->data + r->at;
    value->bytes = (size_t)stored;
    r->at += (size_t)stored;
    return 1;
}

/* A value within the bytes up to `end`. */
static int read_value(reader *r, size_t end)
{
    nkwi_fbx_value value = {0, 0, 0, 0, 0.0, NULL, 0};
    const char type = (char)(r->at < end ? r->data[r->at++] : 0);
    const int is_text = type == 'S' || type == 'R', is_array = size_of(type) > 0 && type >= 'a';
    const size_t least = is_text ? 4 : is_array ? 12 : size_of(type);
    if (least == 0 || least > end - r->at)
        return nkwi_fbx_fail(r->tree, r->at, "a value of an unknown type, or one that is cut");
    const int done = is_text    ? read_text(r, end, &value)
                     : is_array ? read_array(r, type, end, &value)
                                : read_number(r, type, &value);
    return done && nkwi_fbx_add_value(r->tree, &value);
}

/* Closes the innermost node. */
static void close_node(reader *r)
{
    r->tree->depth--;
    r->at = r->ends[r->tree->depth];
}

/* A node with its values; a node of zeros closes the one above. Returns 0 after an error and at the end of the file. */
static int read_node(reader *r, size_t limit)
{
    const size_t wide = r->tree->version >= 7500 ? 8 : 4;
    if (limit - r->at < 3 * wide + 1)
        return r->tree->depth == 0 ? 0 : nkwi_fbx_fail(r->tree, r->at, "a node is cut");
    const uint64_t end = take(r, wide), count = take(r, wide), bytes = take(r, wide);
    const size_t length = (size_t)take(r, 1);
    if (end == 0 && r->tree->depth == 0)
        return 0;
    if (end == 0) {
        close_node(r);
        return 1;
    }
    if (end > limit || end < r->at || length > end - r->at || bytes > end - r->at - length)
        return nkwi_fbx_fail(r->tree, r->at, "a node is longer than the one above it");
    if (!nkwi_fbx_add_node(r->tree, (const char *)r->data + r->at, length))
        return 0;
    r->at += length;
    const size_t values_end = r->at + (size_t)bytes;
    for (uint64_t i = 0; i < count; i++)
        if (!read_value(r, values_end))
            return 0;
    r->at = values_end;
    r->ends[r->tree->depth] = (size_t)end;
    if (r->at == end)
        return 1;
    if (r->tree->depth + 1 >= NKWI_FBX_DEPTH)
        return nkwi_fbx_fail(r->tree, r->at, "nodes are nested too deeply");
    r->tree->last[++r->tree->depth] = NKWI_FBX_NONE;
    return 1;
}

int nkwi_fbx_read_binary(nkwi_fbx_tree *tree, const unsigned char *data, size_t bytes)
{
    reader r = {tree, data, bytes, 23, {0}};
    tree->is_big = data[22] == 1;
    tree->version = (uint32_t)take(&r, 4);
    for (;;) {
        const size_t limit = tree->depth > 0 ? r.ends[tree->depth - 1] : bytes;
        if (tree->depth > 0 && r.at == limit)
            close_node(&r);
        else if (!read_node(&r, limit))
            break;
    }
    return !tree->fault && (tree->root != NKWI_FBX_NONE || nkwi_fbx_fail(tree, r.at, "the file has no nodes"));
}

/* The bytes of a packed array, `size` each. */
static const unsigned char *inflate_array(nkwi_fbx_tree *tree, const nkwi_fbx_value *value, size_t size,
                                          nkwi_memory *memory)
{
#if defined(NKWI_ZLIB)
    const uint64_t bytes = (uint64_t)value->integer * size;
    /* The largest ratio of the method is 1032. */
    unsigned char *out = bytes / 1100 > value->bytes ? NULL : (unsigned char *)nkwi_take(memory, (size_t)bytes + 1, 1);
    uLongf length = (uLongf)bytes;
    if (out && uncompress(out, &length, (const Bytef *)value->text, (uLong)value->bytes) == Z_OK && length == bytes)
        return out;
    nkwi_fbx_fail(tree, 0, "a compressed array is damaged");
#else
    (void)value, (void)size, (void)memory;
    nkwi_fbx_fail(tree, 0, "its arrays are compressed, and this was built without zlib (Debian: zlib1g-dev)");
#endif
    return NULL;
}

int nkwi_fbx_unpack(nkwi_fbx_tree *tree, const nkwi_fbx_value *value, nkwi_memory *memory, double *out)
{
    const size_t size = size_of(value->element), count = (size_t)value->integer;
    const unsigned char *from = (const unsigned char *)value->text;
    if (value->is_packed)
        from = inflate_array(tree, value, size, memory);
    for (size_t i = 0; from && i < count; i++)
        out[i] = real_of(number_at(tree, from + i * size, size), value->element, size);
    return from != NULL;
}
