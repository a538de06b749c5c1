/* SPDX-License-Identifier: MIT */
/* Keys of one's own: a table with a row for each node and time, CSV or JSON. docs/import.md states the columns. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/euler.h>
#include <nakawari/scalar.h>

#include "document.h"
#include "value.h"

/* The columns: ten numbers of a TRS, three angles in place of the rotation, and others. */
enum { NUMBERS = 13, YAW = 10, NAME = NUMBERS, TIME, CLIP, PARENT, INTERPOLATION, INDEX, COLUMNS, FIELDS_MOST = 64 };

static const char *const column_names[COLUMNS] = {"tx",   "ty",   "tz",   "qx",   "qy",     "qz",
                                                  "qw",   "sx",   "sy",   "sz",   "yaw",    "pitch",
                                                  "roll", "name", "time", "clip", "parent", "interpolation",
                                                  "index"};

/* A row: which properties it has (bits 0, 1, 2: translation, rotation, scale), and where it comes from. */
typedef struct row {
    size_t line;
    uint32_t clip, node;
    nkw_interpolation interpolation;
    unsigned has;
    float time, numbers[10];
} row;

/* The same as the file has it: NULL or empty texts are not there, bits of `filled` are the numbers that are. */
typedef struct entry {
    const char *name, *clip, *parent, *interpolation;
    float time, numbers[NUMBERS];
    unsigned filled;
} entry;

typedef struct keys {
    nkwi_document *document;
    nkw_import_error *error;
    char *text, *at, *end; /* a copy that the fields are cut from */
    size_t line, next; /* of the fields, and of `at`; in JSON `line` is the index of the row */
    int is_json;
    char *fields[FIELDS_MOST];
    size_t field_count, column_count;
    int column_of[FIELDS_MOST];
    json_t *clips, *nodes, *parents; /* objects: the index of a name; an array: the parent of each node, or null */
    row *rows;
    size_t row_count, room;
} keys;

static int fail(keys *k, const char *column, nkw_import_result code, const char *reason)
{
    char place[160];
    if (k->is_json)
        snprintf(place, sizeof place, column ? "/rows/%zu/%s" : "/rows/%zu", k->line, column);
    else
        snprintf(place, sizeof place, column ? "line %zu, column %s" : "line %zu", k->line, column);
    return nkwi_fail_at(k->error, place, code, "%s", reason);
}

static int no_memory(keys *k)
{
    return fail(k, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the keys");
}

/* Cuts a field off, RFC 4180: in quotes, a double quote is doubled. Returns whether another follows in the line. */
static int cut_field(keys *k, char **field)
{
    char *to = k->at;
    int quoted = k->at < k->end && *k->at == '"';
    *field = to;
    k->at += quoted;
    for (; k->at < k->end; k->at++) {
        if (quoted && *k->at == '"' && k->at + 1 < k->end && k->at[1] == '"')
            k->at++;
        else if (quoted && *k->at == '"') {
            quoted = 0;
            continue;
        } else if (!quoted && (*k->at == ',' || *k->at == '\n'))
            break;
        k->next += *k->at == '\n';
        *to++ = *k->at;
    }
    int more = k->at < k->end && *k->at == ',';
    k->next += k->at < k->end && *k->at == '\n';
    k->at += k->at < k->end;
    to -= !more && to > *field && to[-1] == '\r';
    *to = 0;
    return more;
}

/* The fields of the next line that is neither empty nor a comment; 0 at the end or after an error. */
static int next_line(keys *k)
{
    while (k->at < k->end) {
        int more = 1;
        k->line = k->next;
        for (k->field_count = 0; more && k->field_count < FIELDS_MOST; k->field_count++)
            more = cut_field(k, &k->fields[k->field_count]);
        if (more)
            return fail(k, NULL, NKW_IMPORT_TOO_LARGE, "more than 64 fields");
        if (k->fields[0][0] != '#' && (k->field_count > 1 || k->fields[0][0]))
            return 1;
    }
    return 0;
}

static int read_header(keys *k)
{
    int found[COLUMNS] = {0};
    for (size_t i = 0; i < k->field_count; i++) {
        int c = 0;
        while (c < COLUMNS && strcmp(k->fields[i], column_names[c]) != 0)
            c++;
        if (c == COLUMNS || found[c]++)
            return fail(k, k->fields[i], NKW_IMPORT_INVALID, c == COLUMNS ? "is no column" : "is there twice");
        k->column_of[i] = c;
    }
    k->column_count = k->field_count;
    for (int c = 0; c < NUMBERS; c++) {
        int first = c < 3 ? 0 : c < 7 ? 3 : c < 10 ? 7 : 10;
        if (found[c] != found[first])
            return fail(k, column_names[found[c] ? first : c], NKW_IMPORT_INVALID, "is missing");
    }
    if (found[3] && found[YAW])
        return fail(k, "yaw", NKW_IMPORT_INVALID, "there are both quaternions and angles");
    return 1;
}

/* The index of a name, the next one if it is new. */
static int index_of(keys *k, json_t *names, const char *name, uint32_t *out)
{
    const json_t *known = json_object_get(names, name);
    *out = (uint32_t)json_object_size(names);
    if (known)
        *out = (uint32_t)json_integer_value(known);
    return known || json_object_set_new_nocheck(names, name, json_integer(*out)) == 0 || no_memory(k);
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

/* The numbers of a row: of a property all, or none. */
static int set_numbers(keys *k, const entry *e, row *r)
{
    static const unsigned masks[4] = {0x7, 0x78, 0x380, 0x1c00};
    static const int firsts[4] = {0, 3, 7, YAW};
    unsigned filled = e->filled;
    for (int p = 0; p < 4; p++)
        if ((filled & masks[p]) && (filled & masks[p]) != masks[p])
            return fail(k, column_names[firsts[p]], NKW_IMPORT_INVALID, "some of the property's numbers are missing");
    for (int c = 0; c < 10; c++)
        r->numbers[c] = filled & 1u << c ? e->numbers[c] : c >= 6 ? 1.0f : 0.0f;
    if (filled & masks[3]) {
        const float *v = e->numbers + YAW;
        nkw_vec3 angles = {nkw_radians_from_degrees(v[1]), nkw_radians_from_degrees(v[0]),
                           nkw_radians_from_degrees(v[2])};
        nkw_quat q = nkw_quat_from_euler(angles, NKW_EULER_YXZ);
        memcpy(r->numbers + 3, &q, sizeof q);
    }
    r->has = (filled & masks[0] ? 1u : 0) | (filled & (masks[1] | masks[3]) ? 2u : 0) | (filled & masks[2] ? 4u : 0);
    return 1;
}

/* The first parent that a node names is its parent. */
static int read_parent(keys *k, uint32_t node, const char *parent)
{
    while (json_array_size(k->parents) <= node)
        if (json_array_append_new(k->parents, json_null()) != 0)
            return no_memory(k);
    if (!parent || !parent[0] || !json_is_null(json_array_get(k->parents, node)))
        return 1;
    return json_array_set_new(k->parents, node, json_string_nocheck(parent)) == 0 || no_memory(k);
}

static int room_for_row(keys *k)
{
    if (k->row_count < k->room)
        return 1;
    size_t room = k->room ? 2 * k->room : 64;
    row *wider = room < SIZE_MAX / sizeof *wider ? (row *)realloc(k->rows, room * sizeof *wider) : NULL;
    if (!wider)
        return no_memory(k);
    k->rows = wider;
    k->room = room;
    return 1;
}

static int add_row(keys *k, const entry *e)
{
    row r = {k->line, 0, 0, NKW_INTERPOLATION_LINEAR, 0, e->time, {0}};
    const char *mode = e->interpolation;
    if (!e->name || !e->name[0])
        return fail(k, "name", NKW_IMPORT_INVALID, "is empty");
    if (mode && strcmp(mode, "STEP") == 0)
        r.interpolation = NKW_INTERPOLATION_STEP;
    else if (mode && mode[0] && strcmp(mode, "LINEAR") != 0)
        return fail(k, "interpolation", NKW_IMPORT_INVALID, "is neither LINEAR nor STEP");
    if (!set_numbers(k, e, &r) || !room_for_row(k) || !index_of(k, k->clips, e->clip ? e->clip : "", &r.clip) ||
        !index_of(k, k->nodes, e->name, &r.node) || !read_parent(k, r.node, e->parent))
        return 0;
    k->rows[k->row_count++] = r;
    return 1;
}

/* A line of CSV. */
static int read_line(keys *k)
{
    const char *cells[COLUMNS] = {NULL};
    entry e;
    if (k->field_count > k->column_count)
        return fail(k, NULL, NKW_IMPORT_INVALID, "more fields than columns");
    for (size_t i = 0; i < k->field_count; i++)
        cells[k->column_of[i]] = k->fields[i];
    memset(&e, 0, sizeof e);
    e.name = cells[NAME];
    e.clip = cells[CLIP];
    e.parent = cells[PARENT];
    e.interpolation = cells[INTERPOLATION];
    for (int c = 0; c < NUMBERS; c++) {
        if (!cells[c] || !cells[c][0])
            continue;
        if (!read_number(cells[c], &e.numbers[c]))
            return fail(k, column_names[c], NKW_IMPORT_INVALID, "is no finite number");
        e.filled |= 1u << c;
    }
    if (!cells[TIME] || !read_number(cells[TIME], &e.time))
        return fail(k, "time", NKW_IMPORT_INVALID, "is no finite number");
    return add_row(k, &e);
}

static int is_float(const json_t *json, float *out)
{
    *out = (float)json_number_value(json);
    return json_is_number(json) && isfinite(*out);
}

/* An element of "rows" in JSON: its values are in the order of the columns; null is no key. */
static int read_object(keys *k, const json_t *object)
{
    const json_t *values = json_object_get(object, "values"), *clip = json_object_get(object, "clip");
    char number[32];
    entry e;
    memset(&e, 0, sizeof e);
    e.name = json_string_value(json_object_get(object, "name"));
    e.clip = json_string_value(clip);
    e.parent = json_string_value(json_object_get(object, "parent"));
    e.interpolation = json_string_value(json_object_get(object, "interpolation"));
    if (json_is_number(clip)) {
        snprintf(number, sizeof number, "%.0f", json_number_value(clip));
        e.clip = number;
    }
    if (!is_float(json_object_get(object, "time"), &e.time))
        return fail(k, "time", NKW_IMPORT_INVALID, "is no finite number");
    if (json_array_size(values) != k->column_count)
        return fail(k, "values", NKW_IMPORT_INVALID, "are not as many as the columns");
    for (size_t i = 0; i < k->column_count; i++) {
        const json_t *value = json_array_get(values, i);
        if (json_is_null(value))
            continue;
        if (!is_float(value, &e.numbers[k->column_of[i]]))
            return fail(k, "values", NKW_IMPORT_INVALID, "are not finite numbers");
        e.filled |= 1u << k->column_of[i];
    }
    return add_row(k, &e);
}

/* Nodes in the order of their first rows; the first row of a node has its rest pose. */
static int make_nodes(keys *k)
{
    static const nkwi_place root = {NULL, NULL, 0}, place = {&root, "nodes", 0};
    size_t count = json_object_size(k->nodes);
    nkw_document_node *nodes = (nkw_document_node *)calloc(count, sizeof *nodes);
    int32_t *parents = (int32_t *)calloc(count, sizeof *parents);
    const char *name;
    json_t *index;
    int good = nodes && parents ? 1 : no_memory(k);
    json_object_foreach(k->nodes, name, index)
    {
        size_t i = (size_t)json_integer_value(index);
        const char *parent = json_string_value(json_array_get(k->parents, i));
        const json_t *found = parent ? json_object_get(k->nodes, parent) : NULL;
        if (!good)
            break;
        if (parent && !found)
            good = nkwi_fail(k->error, NULL, NKW_IMPORT_INVALID, "%s: there is no node %s, its parent", name, parent);
        parents[i] = found ? (int32_t)json_integer_value(found) : NKW_NO_JOINT;
        nodes[i].name = good ? nkwi_document_text(k->document, k->error, name) : NULL;
        nodes[i].number = i;
        nodes[i].mesh = nodes[i].skin = NKW_NO_JOINT;
        good = nodes[i].name != NULL;
    }
    for (size_t i = k->row_count; good && i-- > 0;)
        memcpy(&nodes[k->rows[i].node].rest, k->rows[i].numbers, sizeof(nkw_trs));
    good = good && nkwi_document_nodes(k->document, k->error, &place, nodes, parents, count);
    free(nodes);
    free(parents);
    return good;
}

/* Rows of a clip, then of a node, then as in the file. */
static int compare_rows(const void *left, const void *right)
{
    const row *a = (const row *)left, *b = (const row *)right;
    if (a->clip != b->clip)
        return a->clip < b->clip ? -1 : 1;
    if (a->node != b->node)
        return a->node < b->node ? -1 : 1;
    return a->line < b->line ? -1 : a->line > b->line;
}

/* The keys of a property in rows from .. to - 1 of one clip and node; none: the track stays without keys. */
static int make_track(keys *k, size_t from, size_t to, int property, nkw_clip_track *out)
{
    static const size_t first[3] = {0, 3, 7}, width[3] = {3, 4, 3};
    size_t count = 0, w = width[property];
    for (size_t i = from; i < to; i++)
        count += k->rows[i].has >> property & 1;
    float *times = (float *)nkwi_document_take(k->document, k->error, NULL, count, sizeof *times);
    float *values = (float *)nkwi_document_take(k->document, k->error, NULL, count, w * sizeof *values);
    if (!times || !values)
        return 0;
    nkw_interpolation mode = k->rows[from].interpolation;
    nkw_track track = {times, values, count, w, property == 1 ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS, mode, NULL};
    out->target = (nkw_clip_target)property;
    out->index = (uint32_t)k->document->all.joint_of_node[k->rows[from].node];
    out->track = track;
    for (size_t i = from; i < to; i++) {
        k->line = k->rows[i].line;
        if (k->rows[i].interpolation != mode)
            return fail(k, "interpolation", NKW_IMPORT_INVALID, "another than in the first row of the node");
        if (!(k->rows[i].has >> property & 1))
            continue;
        *times++ = k->rows[i].time;
        memcpy(values, k->rows[i].numbers + first[property], w * sizeof *values);
        values += w;
    }
    return 1;
}

/* Tracks of the rows from .. to - 1, which are those of one clip. */
static int make_animation(keys *k, size_t from, size_t to, nkw_document_animation *out)
{
    size_t runs = 1;
    for (size_t i = from + 1; i < to; i++)
        runs += k->rows[i].node != k->rows[i - 1].node;
    nkw_clip_track *tracks =
        (nkw_clip_track *)nkwi_document_take(k->document, k->error, NULL, runs, 3 * sizeof *tracks);
    nkw_document_channel *channels =
        (nkw_document_channel *)nkwi_document_take(k->document, k->error, NULL, runs, 3 * sizeof *channels);
    if (!tracks || !channels)
        return 0;
    out->tracks = tracks;
    out->channels = channels;
    for (size_t end; from < to; from = end) {
        for (end = from; end < to && k->rows[end].node == k->rows[from].node;)
            end++;
        for (int property = 0; property < 3; property++) {
            nkw_clip_track *track = &tracks[out->track_count];
            nkw_document_channel *channel = &channels[out->track_count];
            if (!make_track(k, from, end, property, track))
                return 0;
            channel->number = out->track_count;
            channel->joint = (int32_t)track->index;
            channel->bytes = track->track.count * (1 + track->track.width) * sizeof(float);
            out->track_count += track->track.count > 0;
        }
    }
    return 1;
}

static int make_animations(keys *k)
{
    size_t count = json_object_size(k->clips), next = 0;
    nkw_document_animation *list =
        (nkw_document_animation *)nkwi_document_take(k->document, k->error, NULL, count, sizeof *list);
    const char *name;
    json_t *index;
    if (!list)
        return 0;
    qsort(k->rows, k->row_count, sizeof *k->rows, compare_rows);
    json_object_foreach(k->clips, name, index)
    {
        size_t i = (size_t)json_integer_value(index);
        list[i].name = nkwi_document_name(k->document, k->error, name, "animation", i);
        if (!list[i].name)
            return 0;
    }
    k->document->all.animations = list;
    k->document->all.animation_count = count;
    for (size_t i = 0; i < count; i++) {
        size_t from = next;
        while (next < k->row_count && k->rows[next].clip == i)
            next++;
        if (!make_animation(k, from, next, &list[i]))
            return 0;
    }
    return 1;
}

static int make_document(keys *k, const char *format)
{
    if (k->error->code != NKW_IMPORT_OK)
        return 0;
    if (k->row_count == 0)
        return fail(k, NULL, NKW_IMPORT_INVALID, "there are no keys");
    k->document->all.format = format;
    return make_nodes(k) && make_animations(k);
}

static int read_text(keys *k)
{
    if (!next_line(k) || !read_header(k))
        return 0;
    while (next_line(k))
        if (!read_line(k))
            return 0;
    return make_document(k, "CSV keys");
}

/* Copies the text, as fields are cut from it. */
static int begin(keys *k, const void *data, size_t bytes)
{
    size_t mark = bytes >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    memset(k, 0, sizeof *k);
    k->text = (char *)malloc(bytes - mark + 1);
    if (!k->text)
        return 0;
    memcpy(k->text, (const char *)data + mark, bytes - mark);
    k->at = k->text;
    k->end = k->text + (bytes - mark);
    k->next = 1;
    return 1;
}

int nkwi_keys_is(const void *data, size_t bytes)
{
    keys k;
    nkw_import_error error;
    size_t most = 4096; /* comments and the header */
    int has_name = 0, has_time = 0;
    if (!begin(&k, data, bytes < most ? bytes : most))
        return 0;
    nkwi_fault_none(&error, "");
    k.error = &error;
    int found = next_line(&k);
    for (size_t i = 0; found && i < k.field_count; i++) {
        has_name |= strcmp(k.fields[i], "name") == 0;
        has_time |= strcmp(k.fields[i], "time") == 0;
    }
    free(k.text);
    return has_name && has_time;
}

/* "columns" and "rows" of JSON. */
static int read_tree(keys *k, const nkwi_value *root)
{
    nkwi_value rows = nkwi_member(root, "rows"), columns = nkwi_member(root, "columns");
    if (!nkwi_is_array(k->error, &rows))
        return 0;
    if (!next_line(k) || !read_header(k))
        return nkwi_fail(k->error, &columns.place, NKW_IMPORT_INVALID, "are no list of columns");
    for (size_t i = 0; i < k->column_count; i++)
        if (k->column_of[i] >= NUMBERS)
            return nkwi_fail(k->error, &columns.place, NKW_IMPORT_INVALID, "%s is a member of rows", k->fields[i]);
    k->is_json = 1;
    for (k->line = 0; k->line < nkwi_length(&rows); k->line++)
        if (!read_object(k, json_array_get(rows.json, k->line)))
            return 0;
    return make_document(k, "JSON keys");
}

/* root: NULL for CSV. */
static int read_keys(nkwi_document *document, const void *text, size_t bytes, const nkwi_value *root,
                     nkw_import_error *error)
{
    keys k;
    int done = 0, copied = begin(&k, text, bytes);
    k.document = document;
    k.error = error;
    k.clips = json_object();
    k.nodes = json_object();
    k.parents = json_array();
    if (!copied || !k.clips || !k.nodes || !k.parents)
        no_memory(&k);
    else
        done = root ? read_tree(&k, root) : read_text(&k);
    json_decref(k.clips);
    json_decref(k.nodes);
    json_decref(k.parents);
    free(k.rows);
    free(k.text);
    return done;
}

int nkwi_keys_read(nkwi_document *document, const nkw_import_memory *memory, nkw_import_error *error)
{
    return read_keys(document, memory->data, memory->bytes, NULL, error);
}

int nkwi_keys_are(const nkwi_value *root)
{
    return nkwi_member(root, "rows").json && nkwi_member(root, "columns").json && !nkwi_member(root, "asset").json;
}

int nkwi_keys_read_tree(nkwi_document *document, const nkwi_value *root, nkw_import_error *error)
{
    const char *columns = nkwi_text(root, "columns", "");
    return read_keys(document, columns, strlen(columns), root, error);
}
