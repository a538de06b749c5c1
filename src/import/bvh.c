/* SPDX-License-Identifier: MIT */
/*
 * BVH (Biovision, 1990s): a hierarchy of joints, then a line of numbers for each frame. As programs write it: keywords
 * in any case, names with spaces, names of end sites, several roots, scale channels, a byte order mark, "Frames :".
 */
#include "bvh.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "decimal.h"
#include "utf8.h"

int nkwi_bvh_fail(nkwi_bvh *b, const char *reason)
{
    char place[40];
    snprintf(place, sizeof place, "line %zu", b->line);
    return nkwi_fail_at(b->error, place, NKW_IMPORT_INVALID, "%s", reason);
}

/* ---- Words ---- */

typedef struct word {
    const char *text;
    size_t length;
} word;

static int is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/* What ends a number. */
static int is_space(char c)
{
    return is_blank(c) || c == '\n' || c == '\f' || c == '\v' || c == '\0';
}

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

/* The same in any case; `text` is in small letters. */
static int is(word w, const char *text)
{
    size_t i = 0;
    while (i < w.length && text[i] && lower(w.text[i]) == text[i])
        i++;
    return i == w.length && !text[i];
}

static void skip(nkwi_bvh *b)
{
    while (b->at < b->end && (is_blank(*b->at) || *b->at == '\n'))
        b->line += *b->at++ == '\n';
}

/* Up to a space, a colon or a brace; these two are words of their own. Empty at the end. */
static word next_word(nkwi_bvh *b)
{
    skip(b);
    word w = {b->at, 0};
    while (b->at < b->end && !is_blank(*b->at) && *b->at != '\n' && !strchr("{}:", *b->at))
        b->at++;
    if (b->at == w.text && b->at < b->end)
        b->at++;
    w.length = (size_t)(b->at - w.text);
    return w;
}

/* The rest of the line up to a brace, without spaces around it. */
static word rest_of_line(nkwi_bvh *b)
{
    while (b->at < b->end && is_blank(*b->at))
        b->at++;
    word w = {b->at, 0};
    while (b->at < b->end && *b->at != '\n' && *b->at != '{')
        b->at++;
    w.length = (size_t)(b->at - w.text);
    while (w.length > 0 && is_blank(w.text[w.length - 1]))
        w.length--;
    return w;
}

/* The next number of the text; *found is 0 at its end. Returns 0, and the error, for what is no finite number. */
static int next_number(nkwi_bvh *b, double *number, int *found)
{
    while (b->at < b->end && is_space(*b->at))
        b->line += *b->at++ == '\n';
    const char *from = b->at;
    while (b->at < b->end && !is_space(*b->at))
        b->at++;
    *found = b->at > from;
    const char *reason = *found ? nkwi_decimal(from, (size_t)(b->at - from), number) : NULL;
    return !reason || nkwi_bvh_fail(b, reason);
}

static int expect(nkwi_bvh *b, const char *text, const char *reason)
{
    return is(next_word(b), text) || nkwi_bvh_fail(b, reason);
}

/* ---- The hierarchy ---- */

static char *name_of(nkwi_bvh *b, word w, const char *before)
{
    const size_t length = strlen(before);
    char *name = (char *)nkwi_document_take(b->document, b->error, NULL, length + w.length + 1, 1);
    if (!name)
        return NULL;
    memcpy(name, before, length);
    memcpy(name + length, w.text, w.length);
    nkwi_utf8(name, length + w.length);
    return name;
}

static int add_node(nkwi_bvh *b, const char *name, int32_t parent)
{
    if (b->node_count == b->node_room) {
        const size_t room = b->node_room ? 2 * b->node_room : 64;
        nkwi_bvh_node *nodes = room < INT32_MAX / 2 ? (nkwi_bvh_node *)realloc(b->nodes, room * sizeof *nodes) : NULL;
        if (!nodes)
            return nkwi_fail(b->error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the joints");
        b->nodes = nodes;
        b->node_room = room;
    }
    nkwi_bvh_node *node = &b->nodes[b->node_count++];
    memset(node, 0, sizeof *node);
    node->name = name;
    node->parent = parent;
    return name != NULL;
}

/* A joint and its brace. An end site without a name has that of its parent. */
static int open_node(nkwi_bvh *b, int is_end, int32_t *current)
{
    if (is_end && !expect(b, "site", "End Site is expected"))
        return 0;
    word name = rest_of_line(b);
    const char *before = "";
    if (name.length == 0 && is_end) {
        name.text = b->nodes[*current].name;
        name.length = strlen(name.text);
        before = "EndSite_";
    }
    if (name.length == 0)
        return nkwi_bvh_fail(b, "the joint has no name");
    if (!expect(b, "{", "{ is expected") || !add_node(b, name_of(b, name, before), *current))
        return 0;
    *current = (int32_t)(b->node_count - 1);
    return 1;
}

static int read_offset(nkwi_bvh *b, nkwi_bvh_node *node)
{
    float *out = &node->offset.x;
    for (int i = 0; i < 3; i++) {
        double number;
        int found;
        if (!next_number(b, &number, &found) || (!found && !nkwi_bvh_fail(b, "OFFSET has fewer than 3 numbers")))
            return 0;
        out[i] = (float)number;
    }
    return 1;
}

static int read_channels(nkwi_bvh *b, nkwi_bvh_node *node)
{
    static const char *const names[BVH_CHANNELS] = {"xposition", "yposition", "zposition", "xrotation", "yrotation",
                                                    "zrotation", "xscale",    "yscale",    "zscale"};
    double count;
    int found;
    if (!next_number(b, &count, &found) || !found || !(count >= 0.0 && count <= BVH_CHANNELS))
        return nkwi_bvh_fail(b, "CHANNELS has a number from 0 to 9");
    node->first = b->channel_count;
    for (node->channel_count = 0; node->channel_count < (size_t)count; node->channel_count++) {
        const word w = next_word(b);
        unsigned char c = 0;
        while (c < BVH_CHANNELS && !is(w, names[c]))
            c++;
        if (c == BVH_CHANNELS || memchr(node->channels, c, node->channel_count))
            return nkwi_bvh_fail(b, "a channel is unknown, or is there twice");
        node->channels[node->channel_count] = c;
    }
    b->channel_count += node->channel_count;
    return 1;
}

static int read_joint_word(nkwi_bvh *b, word w, int32_t *current)
{
    const int is_inside = *current >= 0;
    if (is(w, "root") && !is_inside)
        return open_node(b, 0, current);
    if (is(w, "joint") && is_inside)
        return open_node(b, 0, current);
    if (is(w, "end") && is_inside)
        return open_node(b, 1, current);
    if (is(w, "offset") && is_inside)
        return read_offset(b, &b->nodes[*current]);
    if (is(w, "channels") && is_inside)
        return b->nodes[*current].channel_count == 0 ? read_channels(b, &b->nodes[*current])
                                                     : nkwi_bvh_fail(b, "the joint has CHANNELS already");
    if (is(w, "}") && is_inside) {
        *current = b->nodes[*current].parent;
        return 1;
    }
    return nkwi_bvh_fail(b, w.length ? "ROOT, JOINT, End Site, OFFSET, CHANNELS, MOTION or a brace is expected"
                                     : "the file ends before MOTION");
}

static int read_hierarchy(nkwi_bvh *b)
{
    int32_t current = NKW_NO_JOINT;
    if (!expect(b, "hierarchy", "HIERARCHY is expected"))
        return 0;
    for (;;) {
        const word w = next_word(b);
        if (is(w, "motion") && current < 0)
            break;
        if (!read_joint_word(b, w, &current))
            return 0;
    }
    return b->node_count > 0 || nkwi_bvh_fail(b, "there is no ROOT");
}

/* ---- The frames ---- */

static int add_value(nkwi_bvh *b, double value)
{
    if (b->value_count == b->value_room) {
        const size_t room = b->value_room ? 2 * b->value_room : 4096;
        float *values = room < SIZE_MAX / sizeof *values ? (float *)realloc(b->values, room * sizeof *values) : NULL;
        if (!values)
            return nkwi_fail(b->error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the frames");
        b->values = values;
        b->value_room = room;
    }
    b->values[b->value_count++] = (float)value;
    return 1;
}

static int read_frames(nkwi_bvh *b)
{
    double number;
    int found;
    if (!expect(b, "frames", "Frames: is expected") || !expect(b, ":", "Frames: is expected") ||
        !next_number(b, &number, &found))
        return 0;
    if (!found || !(number >= 0.0 && number < 1e9))
        return nkwi_bvh_fail(b, "Frames: has a whole number");
    b->stated = (size_t)number;
    if (!expect(b, "frame", "Frame Time: is expected") || !expect(b, "time", "Frame Time: is expected") ||
        !expect(b, ":", "Frame Time: is expected") || !next_number(b, &b->frame_time, &found))
        return 0;
    if (!found)
        return nkwi_bvh_fail(b, "Frame Time: has a number of seconds");
    while (next_number(b, &number, &found)) {
        if (!found)
            return 1;
        if (!add_value(b, number))
            return 0;
    }
    return 0;
}

int nkwi_bvh_parse(nkwi_bvh *b)
{
    return read_hierarchy(b) && read_frames(b);
}

/* ---- The reader ---- */

/* The text after a byte order mark. */
static const char *begin_of(const void *data, size_t bytes)
{
    const char *text = (const char *)data;
    return bytes >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? text + 3 : text;
}

int nkwi_bvh_is(const void *data, size_t bytes)
{
    nkwi_bvh b;
    memset(&b, 0, sizeof b);
    b.at = begin_of(data, bytes);
    b.end = (const char *)data + bytes;
    return bytes > 0 && is(next_word(&b), "hierarchy");
}

int nkwi_bvh_read(nkwi_document *document, const nkw_import_memory *memory, nkw_import_error *error)
{
    nkwi_bvh b;
    memset(&b, 0, sizeof b);
    b.document = document;
    b.error = error;
    b.at = begin_of(memory->data, memory->bytes);
    b.end = (const char *)memory->data + memory->bytes;
    b.line = 1;
    const int done = nkwi_bvh_parse(&b) && nkwi_bvh_document(&b, memory->bvh_adds_offset);
    free(b.nodes);
    free(b.values);
    return done;
}
