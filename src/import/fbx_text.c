/* SPDX-License-Identifier: MIT */
/*
 * The text form of FBX:
 *
 *     Name: value, "text", word {       a node with values, and nodes below
 *         Name: *2 {                    an array of 2 numbers
 *             a: 1,2
 *         }
 *     }                                 ; a comment to the end of the line
 *
 * The values of a node end with its line, unless a comma is the last of it.
 */
#include <string.h>

#include "decimal.h"
#include "fbx_tree.h"

typedef struct reader {
    nkwi_fbx_tree *tree;
    const char *data;
    size_t bytes, at;
} reader;

static int peek(const reader *r)
{
    return r->at < r->bytes ? (unsigned char)r->data[r->at] : -1;
}

/* Blanks and comments; line ends too if they are wanted. */
static void skip(reader *r, int with_lines)
{
    for (;;) {
        const int c = peek(r);
        if (c == ';')
            while (peek(r) != -1 && peek(r) != '\n')
                r->at++;
        else if (c == ' ' || c == '\t' || c == '\r' || c == 0 || (with_lines && c == '\n'))
            r->at++;
        else
            return;
    }
}

static int is_end(int c)
{
    return c == -1 || c == ',' || c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '{' || c == '}' || c == ';';
}

/* Digits with a sign as an integer; larger ones than 2^63 - 1 are that. */
static int read_integer(const char *text, size_t length, int64_t *out)
{
    const size_t sign = length > 0 && (text[0] == '-' || text[0] == '+');
    uint64_t number = 0;
    for (size_t i = sign; i < length; i++) {
        if (text[i] < '0' || text[i] > '9')
            return 0;
        const uint64_t digit = (uint64_t)(text[i] - '0');
        number = number > (INT64_MAX - digit) / 10 ? INT64_MAX : 10 * number + digit;
    }
    *out = text[0] == '-' ? -(int64_t)number : (int64_t)number;
    return length > sign;
}

/* A number, or a word as a text. */
static void read_word(nkwi_fbx_value *value)
{
    if (read_integer(value->text, value->bytes, &value->integer)) {
        value->kind = 'I';
        value->real = (double)value->integer;
    } else if (!nkwi_decimal(value->text, value->bytes, &value->real)) {
        value->kind = 'R';
        value->integer = value->real > -9.2e18 && value->real < 9.2e18 ? (int64_t)value->real : 0;
    } else {
        value->kind = 'S';
        value->real = 0.0;
    }
}

/* The numbers of an array up to its closing brace. */
static int read_array(reader *r, nkwi_fbx_value *value)
{
    skip(r, 1);
    if (peek(r) != '{')
        return nkwi_fbx_fail(r->tree, r->at, "an array without numbers");
    r->at++;
    skip(r, 1);
    if (peek(r) == 'a')
        r->at++;
    skip(r, 1);
    if (peek(r) == ':')
        r->at++;
    value->kind = 'A';
    value->element = 't';
    value->text = r->data + r->at;
    while (peek(r) != '}' && peek(r) != -1)
        r->at++;
    value->bytes = (size_t)(r->data + r->at - value->text);
    if (peek(r) == -1)
        return nkwi_fbx_fail(r->tree, r->at, "an array is cut");
    r->at++;
    return 1;
}

static int read_value(reader *r)
{
    nkwi_fbx_value value = {0, 0, 0, 0, 0.0, NULL, 0};
    const int quoted = peek(r) == '"', is_array = peek(r) == '*';
    r->at += (size_t)(quoted || is_array);
    value.text = r->data + r->at;
    while (quoted ? peek(r) != '"' && peek(r) != -1 : !is_end(peek(r)))
        r->at++;
    value.bytes = (size_t)(r->data + r->at - value.text);
    if (quoted) {
        value.kind = 'S';
        if (peek(r) == -1)
            return nkwi_fbx_fail(r->tree, r->at, "a text is cut");
        r->at++;
    } else if (is_array) {
        if (!read_integer(value.text, value.bytes, &value.integer) || !read_array(r, &value))
            return nkwi_fbx_fail(r->tree, r->at, "an array without a count");
    } else if (value.bytes > 0) {
        read_word(&value);
    } else {
        return nkwi_fbx_fail(r->tree, r->at, "a value is missing");
    }
    return nkwi_fbx_add_value(r->tree, &value);
}

/* The values of a node, to the end of the line or to a brace. */
static int read_values(reader *r)
{
    skip(r, 0);
    while (peek(r) != -1 && peek(r) != '\n' && peek(r) != '{' && peek(r) != '}') {
        if (peek(r) == ',') {
            r->at++;
            skip(r, 1);
            continue;
        }
        if (!read_value(r))
            return 0;
        skip(r, 0);
    }
    return 1;
}

/* A node, or the end of one. */
static int read_node(reader *r)
{
    const char *name = r->data + r->at;
    if (peek(r) == '}') {
        r->at++;
        if (r->tree->depth == 0)
            return nkwi_fbx_fail(r->tree, r->at, "a brace closes no node");
        r->tree->depth--;
        return 1;
    }
    while (!is_end(peek(r)) && peek(r) != ':')
        r->at++;
    const size_t length = (size_t)(r->data + r->at - name);
    if (length == 0 || peek(r) != ':')
        return nkwi_fbx_fail(r->tree, r->at, "a node without a name and a colon");
    r->at++;
    if (!nkwi_fbx_add_node(r->tree, name, length) || !read_values(r))
        return 0;
    if (peek(r) != '{')
        return 1;
    r->at++;
    if (r->tree->depth + 1 >= NKWI_FBX_DEPTH)
        return nkwi_fbx_fail(r->tree, r->at, "nodes are nested too deeply");
    r->tree->last[++r->tree->depth] = NKWI_FBX_NONE;
    return 1;
}

int nkwi_fbx_read_text(nkwi_fbx_tree *tree, const char *data, size_t bytes)
{
    reader r = {tree, data, bytes, 0};
    tree->is_text = 1;
    for (skip(&r, 1); peek(&r) != -1; skip(&r, 1))
        if (!read_node(&r))
            return 0;
    if (tree->depth > 0)
        return nkwi_fbx_fail(tree, r.at, "the file is cut");
    const size_t header = nkwi_fbx_find(tree, tree->root, "FBXHeaderExtension");
    const nkwi_fbx_value *version = nkwi_fbx_at(tree, nkwi_fbx_below(tree, header, "FBXVersion"), 0);
    tree->version = version && version->kind == 'I' && version->integer > 0 && version->integer < 100000
                        ? (uint32_t)version->integer
                        : 0;
    return 1;
}

size_t nkwi_fbx_scan(const nkwi_fbx_value *value, double *out, size_t room)
{
    size_t count = 0, at = 0;
    while (at < value->bytes) {
        size_t end = at;
        while (end < value->bytes && !is_end((unsigned char)value->text[end]))
            end++;
        if (end > at) {
            double number = 0.0;
            if (count < room && nkwi_decimal(value->text + at, end - at, &number))
                number = 0.0;
            if (count < room)
                out[count] = number;
            count++;
        }
        at = end + 1;
    }
    return count;
}
