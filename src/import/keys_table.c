/* SPDX-License-Identifier: MIT */
/* Tables of keys: a row for each node and time, CSV or JSON. docs/import.md states the columns. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/euler.h>
#include <nakawari/scalar.h>

#include "keys.h"

/* The columns: the numbers of a key, three angles in place of the rotation, and others. */
enum { YAW = NKWI_NUMBERS, NUMBERS = YAW + 3 };
enum { NAME = NUMBERS, TIME, CLIP, PARENT, INTERPOLATION, INDEX, TARGET, COLUMNS };
enum { FIELDS_MOST = 64 };

/* clang-format off */
static const char *const column_names[COLUMNS] = {
    "tx", "ty", "tz", "qx", "qy", "qz", "qw", "sx", "sy", "sz", "weight",
    "in_tx", "in_ty", "in_tz", "in_qx", "in_qy", "in_qz", "in_qw", "in_sx", "in_sy", "in_sz", "in_weight",
    "out_tx", "out_ty", "out_tz", "out_qx", "out_qy", "out_qz", "out_qw", "out_sx", "out_sy", "out_sz", "out_weight",
    "yaw", "pitch", "roll", "name", "time", "clip", "parent", "interpolation", "index", "target"};
/* clang-format on */

/* A text whose fields are cut from a copy, or the columns of JSON. */
typedef struct table {
    nkwi_keys *keys;
    char *text, *at, *end;
    size_t next; /* the line of `at` */
    char *fields[FIELDS_MOST];
    size_t field_count, column_count;
    int column_of[FIELDS_MOST];
    float numbers[NUMBERS]; /* of the row that is read */
    int filled[NUMBERS];
} table;

/* Cuts a field off, RFC 4180: in quotes, a double quote is doubled. Returns whether another follows in the line. */
static int cut_field(table *t, char **field)
{
    char *to = t->at;
    int quoted = t->at < t->end && *t->at == '"';
    *field = to;
    t->at += quoted;
    for (; t->at < t->end; t->at++) {
        if (quoted && *t->at == '"' && t->at + 1 < t->end && t->at[1] == '"')
            t->at++;
        else if (quoted && *t->at == '"') {
            quoted = 0;
            continue;
        } else if (!quoted && (*t->at == ',' || *t->at == '\n'))
            break;
        t->next += *t->at == '\n';
        *to++ = *t->at;
    }
    int more = t->at < t->end && *t->at == ',';
    t->next += t->at < t->end && *t->at == '\n';
    t->at += t->at < t->end;
    to -= !more && to > *field && to[-1] == '\r';
    *to = 0;
    return more;
}

/* The fields of the next line that is neither empty nor a comment; 0 at the end or after an error. */
static int next_line(table *t)
{
    while (t->at < t->end) {
        int more = 1;
        t->keys->line = t->next;
        for (t->field_count = 0; more && t->field_count < FIELDS_MOST; t->field_count++)
            more = cut_field(t, &t->fields[t->field_count]);
        if (more)
            return nkwi_keys_fail(t->keys, NULL, NKW_IMPORT_TOO_LARGE, "more than 64 fields");
        if (t->fields[0][0] != '#' && (t->field_count > 1 || t->fields[0][0]))
            return 1;
    }
    return 0;
}

/* A group of columns, of which all or none are there: a property, its tangents, or the angles. */
typedef struct group {
    int first, width, needs; /* the group that must be there too */
} group;

enum { GROUPS = 13, ANGLES = 12 };

static const group groups[GROUPS] = {{0, 3, 0},  {3, 4, 1},  {7, 3, 2},       {10, 1, 3}, {11, 3, 0},
                                     {14, 4, 1}, {18, 3, 2}, {21, 1, 3},      {22, 3, 0}, {25, 4, 1},
                                     {29, 3, 2}, {32, 1, 3}, {YAW, 3, ANGLES}};

static int check_groups(table *t, const int *found)
{
    for (int g = 0; g < GROUPS; g++) {
        const group *at = &groups[g];
        for (int c = at->first; c < at->first + at->width; c++)
            if (found[c] != found[at->first])
                return nkwi_keys_fail(t->keys, column_names[found[c] ? at->first : c], NKW_IMPORT_INVALID,
                                      "is missing");
        if (found[at->first] && !found[groups[at->needs].first])
            return nkwi_keys_fail(t->keys, column_names[at->first], NKW_IMPORT_INVALID, "has no column of values");
    }
    if (found[3] && found[YAW])
        return nkwi_keys_fail(t->keys, "yaw", NKW_IMPORT_INVALID, "there are both quaternions and angles");
    return 1;
}

static int read_header(table *t)
{
    int found[COLUMNS] = {0};
    t->keys->stride = NKWI_VALUES;
    for (size_t i = 0; i < t->field_count; i++) {
        int c = 0;
        while (c < COLUMNS && strcmp(t->fields[i], column_names[c]) != 0)
            c++;
        if (c == COLUMNS || found[c]++)
            return nkwi_keys_fail(t->keys, t->fields[i], NKW_IMPORT_INVALID,
                                  c == COLUMNS ? "is no column" : "is there twice");
        t->column_of[i] = c;
        if (c >= NKWI_VALUES && c < YAW)
            t->keys->stride = NKWI_NUMBERS;
    }
    t->column_count = t->field_count;
    return check_groups(t, found);
}

/* A number as in JSON, which does not depend on the locale. */
static int read_number(const char *text, float *out)
{
    json_t *json = json_loads(text, JSON_DECODE_ANY | JSON_DECODE_INT_AS_REAL, NULL);
    double number = json_number_value(json);
    int is_number = json_is_number(json);
    json_decref(json);
    *out = (float)number;
    return is_number && isfinite(*out);
}

/* Whether the row has the numbers of a group: all, or none. */
static int group_is(table *t, int g, int *has)
{
    const group *at = &groups[g];
    *has = t->filled[at->first];
    for (int c = at->first; c < at->first + at->width; c++)
        if (t->filled[c] != *has)
            return nkwi_keys_fail(t->keys, column_names[at->first], NKW_IMPORT_INVALID,
                                  "some of the property's numbers are missing");
    return 1;
}

/* The numbers of a row. Absent values are the identity, absent tangents 0. */
static int set_numbers(table *t, nkwi_entry *e)
{
    static const float identity[NKWI_NUMBERS] = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1};
    memcpy(e->numbers, identity, sizeof identity);
    for (int g = 0; g < GROUPS; g++) {
        const group *at = &groups[g];
        int has;
        if (!group_is(t, g, &has))
            return 0;
        if (!has)
            continue;
        if (g >= 4 && g < ANGLES && e->interpolation != NKW_INTERPOLATION_CUBICSPLINE)
            return nkwi_keys_fail(t->keys, column_names[at->first], NKW_IMPORT_INVALID,
                                  "only CUBICSPLINE has tangents");
        if (g >= 4 && g < ANGLES && !(e->has >> at->needs & 1))
            return nkwi_keys_fail(t->keys, column_names[at->first], NKW_IMPORT_INVALID, "a tangent without a value");
        e->has |= g == ANGLES ? 2u : g < 4 ? 1u << g : 0;
        if (g != ANGLES)
            memcpy(e->numbers + at->first, t->numbers + at->first, (size_t)at->width * sizeof *e->numbers);
    }
    if (t->filled[YAW]) {
        const float *v = t->numbers + YAW;
        nkw_vec3 angles = {nkw_radians_from_degrees(v[1]), nkw_radians_from_degrees(v[0]),
                           nkw_radians_from_degrees(v[2])};
        nkwi_entry_turn(e, angles);
    }
    return 1;
}

static int read_interpolation(table *t, const char *mode, nkw_interpolation *out)
{
    static const char *const names[] = {"LINEAR", "STEP", "CUBICSPLINE"};
    *out = NKW_INTERPOLATION_LINEAR;
    for (int i = 0; mode && i < 3; i++)
        if (strcmp(mode, names[i]) == 0) {
            *out = (nkw_interpolation)i;
            return 1;
        }
    return !mode || !mode[0] ||
           nkwi_keys_fail(t->keys, "interpolation", NKW_IMPORT_INVALID, "is not LINEAR, STEP or CUBICSPLINE");
}

/* A line of CSV. */
static int read_line(table *t)
{
    const char *cells[COLUMNS] = {NULL};
    nkwi_entry e;
    if (t->field_count > t->column_count)
        return nkwi_keys_fail(t->keys, NULL, NKW_IMPORT_INVALID, "more fields than columns");
    for (size_t i = 0; i < t->field_count; i++)
        cells[t->column_of[i]] = t->fields[i];
    memset(&e, 0, sizeof e);
    e.name = cells[NAME];
    e.clip = cells[CLIP];
    e.parent = cells[PARENT];
    for (int c = 0; c < NUMBERS; c++) {
        t->filled[c] = cells[c] && cells[c][0];
        if (t->filled[c] && !read_number(cells[c], &t->numbers[c]))
            return nkwi_keys_fail(t->keys, column_names[c], NKW_IMPORT_INVALID, "is no finite number");
    }
    if (!cells[TIME] || !read_number(cells[TIME], &e.time))
        return nkwi_keys_fail(t->keys, "time", NKW_IMPORT_INVALID, "is no finite number");
    return read_interpolation(t, cells[INTERPOLATION], &e.interpolation) && set_numbers(t, &e) &&
           nkwi_keys_add(t->keys, &e);
}

static int is_float(const json_t *json, float *out)
{
    *out = (float)json_number_value(json);
    return json_is_number(json) && isfinite(*out);
}

/* An element of "rows" in JSON: its values are in the order of the columns; null is no key. */
static int read_object(table *t, const json_t *object)
{
    const json_t *values = json_object_get(object, "values"), *clip = json_object_get(object, "clip");
    const char *mode = json_string_value(json_object_get(object, "interpolation"));
    char number[32];
    nkwi_entry e;
    memset(&e, 0, sizeof e);
    memset(t->filled, 0, sizeof t->filled);
    e.name = json_string_value(json_object_get(object, "name"));
    e.clip = json_string_value(clip);
    e.parent = json_string_value(json_object_get(object, "parent"));
    if (json_is_number(clip)) {
        snprintf(number, sizeof number, "%.0f", json_number_value(clip));
        e.clip = number;
    }
    if (!is_float(json_object_get(object, "time"), &e.time))
        return nkwi_keys_fail(t->keys, "time", NKW_IMPORT_INVALID, "is no finite number");
    if (json_array_size(values) != t->column_count)
        return nkwi_keys_fail(t->keys, "values", NKW_IMPORT_INVALID, "are not as many as the columns");
    for (size_t i = 0; i < t->column_count; i++) {
        const json_t *value = json_array_get(values, i);
        if (json_is_null(value))
            continue;
        if (!is_float(value, &t->numbers[t->column_of[i]]))
            return nkwi_keys_fail(t->keys, "values", NKW_IMPORT_INVALID, "are not finite numbers");
        t->filled[t->column_of[i]] = 1;
    }
    return read_interpolation(t, mode, &e.interpolation) && set_numbers(t, &e) && nkwi_keys_add(t->keys, &e);
}

/* Copies the text to bytes + 1 characters, without its byte order mark: fields are cut from the copy. */
static void begin_in(table *t, nkwi_keys *k, const void *data, size_t bytes, char *copy)
{
    size_t mark = bytes >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    memset(t, 0, sizeof *t);
    t->keys = k;
    t->text = t->at = copy;
    t->end = copy + (bytes - mark);
    t->next = 1;
    memcpy(copy, (const char *)data + mark, bytes - mark);
}

/* The same to memory that is to be freed. */
static int begin(table *t, nkwi_keys *k, const void *data, size_t bytes)
{
    t->text = (char *)malloc(bytes + 1);
    if (!t->text)
        return nkwi_keys_no_memory(k);
    begin_in(t, k, data, bytes, t->text);
    return 1;
}

int nkwi_table_is(const void *data, size_t bytes)
{
    nkwi_keys k;
    table t;
    nkw_import_error error;
    char head[4097]; /* comments and the header; no allocation, which may fail */
    size_t most = sizeof head - 1;
    int has_name = 0, has_time = 0;
    memset(&k, 0, sizeof k);
    nkwi_fault_none(&error, "");
    k.error = &error;
    begin_in(&t, &k, data, bytes < most ? bytes : most, head);
    int found = next_line(&t);
    for (size_t i = 0; found && i < t.field_count; i++) {
        has_name |= strcmp(t.fields[i], "name") == 0;
        has_time |= strcmp(t.fields[i], "time") == 0;
    }
    return has_name && has_time;
}

int nkwi_table_read(nkwi_keys *k, const void *data, size_t bytes)
{
    table t;
    int good = begin(&t, k, data, bytes) && next_line(&t) && read_header(&t);
    while (good && next_line(&t))
        good = read_line(&t);
    free(t.text);
    return k->error->code == NKW_IMPORT_OK;
}

int nkwi_table_are(const nkwi_value *root)
{
    return nkwi_member(root, "rows").json && nkwi_member(root, "columns").json;
}

static int read_rows(table *t, const nkwi_value *rows, const nkwi_value *columns)
{
    nkwi_keys *k = t->keys;
    if (!next_line(t) || !read_header(t))
        return nkwi_fail(k->error, &columns->place, NKW_IMPORT_INVALID, "are no list of columns");
    for (size_t i = 0; i < t->column_count; i++)
        if (t->column_of[i] >= NUMBERS)
            return nkwi_fail(k->error, &columns->place, NKW_IMPORT_INVALID, "%s is a member of rows", t->fields[i]);
    k->is_json = 1;
    for (k->line = 0; k->line < nkwi_length(rows); k->line++)
        if (!read_object(t, json_array_get(rows->json, k->line)))
            return 0;
    return 1;
}

int nkwi_table_read_tree(nkwi_keys *k, const nkwi_value *root)
{
    nkwi_value rows = nkwi_member(root, "rows"), columns = nkwi_member(root, "columns");
    const char *names = nkwi_text(root, "columns", "");
    table t;
    if (!nkwi_is_array(k->error, &rows) || !begin(&t, k, names, strlen(names)))
        return 0;
    int done = read_rows(&t, &rows, &columns);
    free(t.text);
    return done;
}
