/* SPDX-License-Identifier: MIT */
/*
 * Wavefront OBJ: positions, texture coordinates, normals, and faces, lines and points of them. As programs write it:
 * numbers as .5 and 1e-5, corners as 1/2/3, 1//3, 1/2, 1/ and -1, lines that a backslash joins, comments after them.
 * Source: Wavefront Technologies, The Advanced Visualizer, appendix B1: Object Files (.obj).
 */
#include "obj.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "decimal.h"

int nkwi_obj_fail(const nkwi_obj *o, size_t line, const char *format, ...)
{
    char place[40], reason[160];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(reason, sizeof reason, format, arguments);
    va_end(arguments);
    snprintf(place, sizeof place, "line %zu", line);
    return nkwi_fail_at(o->error, place, NKW_IMPORT_INVALID, "%s", reason);
}

/* ---- Words ---- */

static int is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\f' || c == '\v';
}

static int is_break(char c)
{
    return c == '\n' || c == '\r';
}

/* The bytes of a line break. */
static size_t break_bytes(const char *at, const char *end)
{
    return at < end && is_break(*at) ? 1 + (size_t)(*at == '\r' && at + 1 < end && at[1] == '\n') : 0;
}

/* The bytes of a backslash that joins two lines; 0 for none. */
static size_t join_bytes(const nkwi_obj_text *t, const char *at)
{
    if (*at != '\\')
        return 0;
    const size_t bytes = break_bytes(at + 1, t->end);
    return bytes || at + 1 == t->end ? 1 + bytes : 0;
}

static void skip_blanks(nkwi_obj_text *t)
{
    while (t->at < t->end) {
        const size_t join = join_bytes(t, t->at);
        if (!is_blank(*t->at) && !join)
            return;
        t->at += join ? join : 1;
        t->line += join > 1;
    }
}

int nkwi_obj_next(nkwi_obj_text *t, nkwi_obj_word *w)
{
    skip_blanks(t);
    w->text = t->at;
    while (t->at < t->end && !is_blank(*t->at) && !is_break(*t->at) && *t->at != '#' && !join_bytes(t, t->at))
        t->at++;
    w->length = (size_t)(t->at - w->text);
    return w->length > 0;
}

nkwi_obj_word nkwi_obj_rest(nkwi_obj_text *t)
{
    skip_blanks(t);
    nkwi_obj_word w = {t->at, 0};
    for (; t->at < t->end && !is_break(*t->at) && !join_bytes(t, t->at); t->at++) {
        const int is_after = t->at == w.text || is_blank(t->at[-1]);
        const int is_before = t->at + 1 == t->end || is_blank(t->at[1]) || is_break(t->at[1]);
        if (*t->at == '#' && is_after && is_before)
            break;
    }
    w.length = (size_t)(t->at - w.text);
    while (w.length > 0 && is_blank(w.text[w.length - 1]))
        w.length--;
    return w;
}

/* A comment ends with its line, also after a backslash. */
void nkwi_obj_skip_line(nkwi_obj_text *t)
{
    for (skip_blanks(t); t->at < t->end && !is_break(*t->at); skip_blanks(t))
        if (*t->at++ == '#')
            while (t->at < t->end && !is_break(*t->at))
                t->at++;
    const size_t bytes = break_bytes(t->at, t->end);
    t->at += bytes;
    t->line += bytes > 0;
}

int nkwi_obj_same(nkwi_obj_word w, const char *text)
{
    return strlen(text) == w.length && memcmp(w.text, text, w.length) == 0;
}

static int is_one_of(nkwi_obj_word w, const char *const *list, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (nkwi_obj_same(w, list[i]))
            return 1;
    return 0;
}

/* ---- v, vt, vn ---- */

/* All numbers of the line, of which the first `most` are stored: at least `least`. */
static int read_numbers(nkwi_obj *o, size_t least, size_t most, float *out, size_t *count)
{
    nkwi_obj_word w;
    double number;
    for (*count = 0; nkwi_obj_next(&o->text, &w); ++*count) {
        const char *reason = nkwi_decimal(w.text, w.length, &number);
        if (reason)
            return nkwi_obj_fail(o, o->text.line, "%s", reason);
        if (*count < most)
            out[*count] = (float)number;
    }
    return *count >= least || nkwi_obj_fail(o, o->text.line, "%zu numbers are expected, %zu are there", least, *count);
}

/* x y z; x y z w, of which w is of curves only; x y z and a colour. */
static int read_position(nkwi_obj *o)
{
    float numbers[6] = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f};
    size_t count;
    if (!read_numbers(o, 3, 6, numbers, &count))
        return 0;
    nkwi_obj_position *p = (nkwi_obj_position *)nkwi_obj_add(o, &o->positions, sizeof *p);
    if (!p)
        return 0;
    memcpy(&p->at, numbers, sizeof p->at);
    memcpy(p->color, numbers + 3, sizeof p->color);
    p->has_color = count >= 6;
    return 1;
}

static int read_texcoord(nkwi_obj *o)
{
    float numbers[2] = {0.0f, 0.0f};
    size_t count;
    if (!read_numbers(o, 1, 2, numbers, &count))
        return 0;
    nkwi_obj_texcoord *t = (nkwi_obj_texcoord *)nkwi_obj_add(o, &o->texcoords, sizeof *t);
    if (!t)
        return 0;
    t->at[0] = numbers[0];
    t->at[1] = o->document->v_is_up ? numbers[1] : 1.0f - numbers[1];
    return 1;
}

static int read_normal(nkwi_obj *o)
{
    float numbers[3];
    size_t count;
    if (!read_numbers(o, 3, 3, numbers, &count))
        return 0;
    nkw_vec3 *n = (nkw_vec3 *)nkwi_obj_add(o, &o->normals, sizeof *n);
    if (n)
        memcpy(n, numbers, sizeof *n);
    return n != NULL;
}

/* ---- f, l, p ---- */

/*
 * A number of a corner, from 1; -1 is the last element so far. *out 0: there are no digits. Numbers of elements that
 * follow later in the file are compared with their count at its end.
 */
static int read_index(nkwi_obj *o, nkwi_obj_word *w, size_t count, uint32_t *out)
{
    const int is_back = w->length > 0 && *w->text == '-';
    const char *at = w->text + is_back, *end = w->text + w->length;
    uint64_t number = 0;
    for (; at < end && *at >= '0' && *at <= '9'; at++)
        number = number < UINT32_MAX ? 10 * number + (uint64_t)(*at - '0') : number;
    const int has_digits = at > w->text + is_back;
    w->length -= (size_t)(at - w->text);
    w->text = at;
    *out = 0;
    if (!has_digits)
        return !is_back || nkwi_obj_fail(o, o->text.line, "a number of a vertex is expected");
    if (number == 0 || number >= UINT32_MAX || (is_back && number > count))
        return nkwi_obj_fail(o, o->text.line, "%s%lu is out of range: there are %zu so far", is_back ? "-" : "",
                             (unsigned long)(number < UINT32_MAX ? number : UINT32_MAX), count);
    *out = (uint32_t)(is_back ? count - number + 1 : number);
    return 1;
}

/* 1, 1/2, 1/2/3, 1//3; also 1/, 1//. */
static int read_corner(nkwi_obj *o, nkwi_obj_word w)
{
    const size_t counts[OBJ_ATTRIBUTES] = {o->positions.count, o->texcoords.count, o->normals.count};
    nkwi_obj_corner *corner = (nkwi_obj_corner *)nkwi_obj_add(o, &o->corners, sizeof *corner);
    if (!corner)
        return 0;
    for (int i = 0; i < OBJ_ATTRIBUTES; i++) {
        if (!read_index(o, &w, counts[i], &corner->at[i]))
            return 0;
        if (i == OBJ_NORMAL || w.length == 0 || *w.text != '/')
            break;
        w.text++;
        w.length--;
    }
    return (w.length == 0 && corner->at[OBJ_POSITION] > 0) ||
           nkwi_obj_fail(o, o->text.line, "a corner is expected: 1, 1/2, 1//3 or 1/2/3");
}

static int add_element(nkwi_obj *o, nkw_document_topology topology, size_t first, size_t line)
{
    const nkwi_obj_key key = {{o->object, o->group, 0, 0}};
    nkwi_obj_element *e = (nkwi_obj_element *)nkwi_obj_add(o, &o->elements, sizeof *e);
    if (!e || !nkwi_obj_number(o, &o->parts, &key, &e->part))
        return 0;
    e->topology = topology;
    e->first = first;
    e->count = o->corners.count - first;
    e->line = line;
    e->material = o->material;
    return 1;
}

/* Faces and lines of too few corners are left out. */
static int read_element(nkwi_obj *o, nkw_document_topology topology)
{
    const size_t first = o->corners.count, line = o->text.line;
    nkwi_obj_word w;
    while (nkwi_obj_next(&o->text, &w))
        if (!read_corner(o, w))
            return 0;
    if (o->corners.count - first > (size_t)topology)
        return add_element(o, topology, first, line);
    o->corners.count = first;
    o->short_count++;
    return 1;
}

/* ---- Lines ---- */

static int read_unknown(nkwi_obj *o, nkwi_obj_word w)
{
    static const char *const silent[] = {"s",         "vp",    "lod",    "bevel",  "c_interp",
                                         "d_interp",  "mg",    "usemap", "maplib", "shadow_obj",
                                         "trace_obj", "ctech", "end",    "stech"};
    if (!is_one_of(w, silent, sizeof silent / sizeof *silent) && o->unread_count++ == 0)
        o->unread_line = o->text.line;
    return 1;
}

static int read_line(nkwi_obj *o, nkwi_obj_word w)
{
    if (nkwi_obj_same(w, "v"))
        return read_position(o);
    if (nkwi_obj_same(w, "vt"))
        return read_texcoord(o);
    if (nkwi_obj_same(w, "vn"))
        return read_normal(o);
    if (nkwi_obj_same(w, "f") || nkwi_obj_same(w, "fo"))
        return read_element(o, NKW_DOCUMENT_TRIANGLES);
    if (nkwi_obj_same(w, "l"))
        return read_element(o, NKW_DOCUMENT_LINES);
    if (nkwi_obj_same(w, "p"))
        return read_element(o, NKW_DOCUMENT_POINTS);
    if (nkwi_obj_same(w, "usemtl"))
        return nkwi_obj_material_of(o, nkwi_obj_rest(&o->text), &o->material);
    if (nkwi_obj_same(w, "mtllib"))
        return nkwi_obj_library(o);
    if (nkwi_obj_same(w, "g"))
        return nkwi_obj_name(o, nkwi_obj_rest(&o->text), &o->group);
    if (nkwi_obj_same(w, "o")) {
        o->group = 0;
        return nkwi_obj_name(o, nkwi_obj_rest(&o->text), &o->object);
    }
    return read_unknown(o, w);
}

/* A file of positions only is a cloud of points. */
static int add_cloud(nkwi_obj *o)
{
    for (size_t i = 0; i < o->positions.count; i++) {
        nkwi_obj_corner *corner = (nkwi_obj_corner *)nkwi_obj_add(o, &o->corners, sizeof *corner);
        if (!corner)
            return 0;
        corner->at[OBJ_POSITION] = (uint32_t)i + 1;
    }
    return o->corners.count > 0 ? add_element(o, NKW_DOCUMENT_POINTS, 0, 1)
                                : nkwi_obj_fail(o, o->text.line, "there are no vertices");
}

static int warn(nkwi_obj *o)
{
    if (o->short_count && !nkwi_document_warn(o->document, o->error,
                                              "faces or lines of too few corners are left out: %zu", o->short_count))
        return 0;
    return o->unread_count == 0 ||
           nkwi_document_warn(o->document, o->error, "lines that are not read: %zu, the first is line %zu",
                              o->unread_count, o->unread_line);
}

static int read_lines(nkwi_obj *o)
{
    const nkwi_obj_word none = {"", 0};
    nkwi_obj_word w;
    o->material = NKW_NO_JOINT;
    if (!nkwi_obj_name(o, none, &o->group))
        return 0;
    for (; o->text.at < o->text.end; nkwi_obj_skip_line(&o->text))
        if (nkwi_obj_next(&o->text, &w) && !read_line(o, w))
            return 0;
    return (o->elements.count > 0 || add_cloud(o)) && warn(o);
}

/* ---- The reader ---- */

/* The text after a byte order mark. */
static nkwi_obj_text text_of(const void *data, size_t bytes)
{
    nkwi_obj_text t = {(const char *)data, (const char *)data + bytes, 1};
    if (bytes >= 3 && memcmp(data, "\xEF\xBB\xBF", 3) == 0)
        t.at += 3;
    return t;
}

int nkwi_obj_is(const void *data, size_t bytes)
{
    static const char *const words[] = {"v", "vn", "vt", "f", "o", "g", "s", "mtllib", "usemtl"};
    if (bytes == 0)
        return 0;
    nkwi_obj_text t = text_of(data, bytes);
    nkwi_obj_word w = {NULL, 0};
    while (t.at < t.end && !nkwi_obj_next(&t, &w))
        nkwi_obj_skip_line(&t);
    return is_one_of(w, words, sizeof words / sizeof *words);
}

int nkwi_obj_is_named(const char *file)
{
    static const char small[] = ".obj", large[] = ".OBJ";
    const size_t length = file ? strlen(file) : 0;
    for (size_t i = 0; i < 4; i++)
        if (length < 4 || (file[length - 4 + i] != small[i] && file[length - 4 + i] != large[i]))
            return 0;
    return 1;
}

int nkwi_obj_read(nkwi_document *document, const nkw_import_memory *memory, nkw_import_error *error)
{
    nkwi_obj o;
    memset(&o, 0, sizeof o);
    o.document = document;
    o.error = error;
    o.memory = memory;
    o.text = text_of(memory->data, memory->bytes);
    const int done = read_lines(&o) && nkwi_obj_document(&o) && (!document->wants_obj || nkwi_obj_arrays(&o));
    nkwi_obj_list *lists[] = {&o.positions, &o.texcoords, &o.normals, &o.corners, &o.elements, &o.names, &o.materials};
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++)
        free(lists[i]->data);
    nkwi_obj_table *tables[] = {&o.name_table, &o.material_table, &o.parts, &o.libraries};
    for (size_t i = 0; i < sizeof tables / sizeof *tables; i++)
        nkwi_obj_give(tables[i]);
    return done;
}
