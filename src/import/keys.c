/* SPDX-License-Identifier: MIT */
/* Keys of one's own: from rows to a document. */
#include "keys.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const size_t nkwi_keys_first[4] = {0, 3, 7, NKWI_WEIGHT}, nkwi_keys_width[4] = {3, 4, 3, 1};

int nkwi_keys_fail(nkwi_keys *k, const char *column, nkw_import_result code, const char *reason)
{
    char place[160];
    if (k->is_json)
        snprintf(place, sizeof place, column ? "/rows/%zu/%s" : "/rows/%zu", k->line, column);
    else
        snprintf(place, sizeof place, column ? "line %zu, column %s" : "line %zu", k->line, column);
    return nkwi_fail_at(k->error, place, code, "%s", reason);
}

int nkwi_keys_no_memory(nkwi_keys *k)
{
    return nkwi_keys_fail(k, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the keys");
}

/* The index of a name, the next one if it is new. */
static int index_of(nkwi_keys *k, json_t *names, const char *name, uint32_t *out)
{
    const json_t *known = json_object_get(names, name);
    *out = (uint32_t)json_object_size(names);
    if (known)
        *out = (uint32_t)json_integer_value(known);
    return known || json_object_set_new_nocheck(names, name, json_integer(*out)) == 0 || nkwi_keys_no_memory(k);
}

/* The first parent that a node names is its parent. */
static int read_parent(nkwi_keys *k, uint32_t node, const char *parent)
{
    while (json_array_size(k->parents) <= node)
        if (json_array_append_new(k->parents, json_null()) != 0)
            return nkwi_keys_no_memory(k);
    if (!parent || !parent[0] || !json_is_null(json_array_get(k->parents, node)))
        return 1;
    return json_array_set_new(k->parents, node, json_string_nocheck(parent)) == 0 || nkwi_keys_no_memory(k);
}

static int room_for_row(nkwi_keys *k)
{
    if (k->row_count < k->room)
        return 1;
    size_t room = k->room ? 2 * k->room : 64, most = SIZE_MAX / (sizeof *k->rows + k->stride * sizeof *k->numbers);
    nkwi_row *rows = room < most ? (nkwi_row *)realloc(k->rows, room * sizeof *rows) : NULL;
    k->rows = rows ? rows : k->rows;
    float *numbers = rows ? (float *)realloc(k->numbers, room * k->stride * sizeof *numbers) : NULL;
    k->numbers = numbers ? numbers : k->numbers;
    if (!numbers)
        return nkwi_keys_no_memory(k);
    k->room = room;
    return 1;
}

int nkwi_keys_add(nkwi_keys *k, const nkwi_entry *e)
{
    nkwi_row r = {k->line, 0, 0, e->interpolation, e->has, e->has_angles, e->time, e->angles, k->row_count * k->stride};
    if (!e->name || !e->name[0])
        return nkwi_keys_fail(k, "name", NKW_IMPORT_INVALID, "is empty");
    if (!room_for_row(k) || !index_of(k, k->clips, e->clip ? e->clip : "", &r.clip) ||
        !index_of(k, k->nodes, e->name, &r.node) || !read_parent(k, r.node, e->parent))
        return 0;
    memcpy(k->numbers + r.numbers, e->numbers, k->stride * sizeof *k->numbers);
    k->rows[k->row_count++] = r;
    return 1;
}

/* Names and parents. */
static int name_nodes(nkwi_keys *k, nkw_document_node *nodes, int32_t *parents)
{
    const char *name;
    json_t *index;
    json_object_foreach(k->nodes, name, index)
    {
        size_t i = (size_t)json_integer_value(index);
        const char *parent = json_string_value(json_array_get(k->parents, i));
        const json_t *found = parent ? json_object_get(k->nodes, parent) : NULL;
        if (parent && !found)
            return nkwi_fail(k->error, NULL, NKW_IMPORT_INVALID, "%s: there is no node %s, its parent", name, parent);
        parents[i] = found ? (int32_t)json_integer_value(found) : NKW_NO_JOINT;
        nodes[i].name = nkwi_document_text(k->document, k->error, name);
        nodes[i].number = i;
        nodes[i].mesh = nodes[i].skin = NKW_NO_JOINT;
        if (!nodes[i].name)
            return 0;
    }
    return 1;
}

/* Of sorted rows: the end of those that have the clip and the node of the row `from`. */
static size_t end_of_run(const nkwi_keys *k, size_t from)
{
    size_t end = from;
    while (end < k->row_count && k->rows[end].clip == k->rows[from].clip && k->rows[end].node == k->rows[from].node)
        end++;
    return end;
}

static int has(const nkwi_row *r, int property)
{
    return (int)(r->has >> property & 1);
}

/* The morph weights of one time, the first of a run: their number, and the first row. */
static size_t count_weights(const nkwi_keys *k, size_t from, size_t to, size_t *first)
{
    size_t count = 0;
    for (size_t i = from; i < to; i++) {
        if (!has(&k->rows[i], NKW_CLIP_FLOATS))
            continue;
        *first = count == 0 ? i : *first;
        if (k->rows[i].time != k->rows[*first].time)
            break;
        count++;
    }
    return count;
}

/* The weights of a node are those of a mesh without primitives. */
static int make_mesh(nkwi_keys *k, size_t from, size_t count, nkw_document_node *node, nkw_document_mesh *mesh)
{
    float *weights = (float *)nkwi_document_take(k->document, k->error, NULL, count, sizeof *weights);
    const char **names = (const char **)nkwi_document_take(k->document, k->error, NULL, count, sizeof *names);
    if (!weights || !names)
        return 0;
    for (size_t i = from, t = 0; t < count; i++)
        if (has(&k->rows[i], NKW_CLIP_FLOATS)) {
            weights[t] = k->numbers[k->rows[i].numbers + NKWI_WEIGHT];
            names[t] = nkwi_document_name(k->document, k->error, NULL, "target", t);
            if (!names[t++])
                return 0;
        }
    mesh->name = node->name;
    mesh->weights = weights;
    mesh->target_names = names;
    mesh->target_count = count;
    return 1;
}

/* A mesh for each node with weights. */
static int make_meshes(nkwi_keys *k, nkw_document_node *nodes, size_t node_count)
{
    nkw_document *d = &k->document->all;
    nkw_document_mesh *meshes = NULL;
    for (size_t from = 0, end; from < k->row_count; from = end) {
        nkw_document_node *node = &nodes[k->rows[from].node];
        size_t first = from, count = count_weights(k, from, end = end_of_run(k, from), &first);
        if (count == 0 || node->mesh != NKW_NO_JOINT)
            continue;
        if (!meshes)
            meshes = (nkw_document_mesh *)nkwi_document_take(k->document, k->error, NULL, node_count, sizeof *meshes);
        d->meshes = meshes;
        if (!meshes || !make_mesh(k, first, count, node, &meshes[d->mesh_count]))
            return 0;
        node->mesh = (int32_t)d->mesh_count++;
    }
    return 1;
}

/* Rows of a clip, then of a node, then as in the file. */
static int compare_rows(const void *left, const void *right)
{
    const nkwi_row *a = (const nkwi_row *)left, *b = (const nkwi_row *)right;
    if (a->clip != b->clip)
        return a->clip < b->clip ? -1 : 1;
    if (a->node != b->node)
        return a->node < b->node ? -1 : 1;
    return a->line < b->line ? -1 : a->line > b->line;
}

/* Nodes in the order of their first rows; the first row of a node has its rest pose. Sorts the rows. */
static int make_nodes(nkwi_keys *k)
{
    static const nkwi_place root = {NULL, NULL, 0}, place = {&root, "nodes", 0};
    size_t count = json_object_size(k->nodes);
    nkw_document_node *nodes = (nkw_document_node *)calloc(count, sizeof *nodes);
    int32_t *parents = (int32_t *)calloc(count, sizeof *parents);
    int good = nodes && parents ? name_nodes(k, nodes, parents) : nkwi_keys_no_memory(k);
    for (size_t i = k->row_count; good && i-- > 0;)
        memcpy(&nodes[k->rows[i].node].rest, k->numbers + k->rows[i].numbers, sizeof(nkw_trs));
    qsort(k->rows, k->row_count, sizeof *k->rows, compare_rows);
    good = good && make_meshes(k, nodes, count) &&
           nkwi_document_nodes(k->document, k->error, &place, nodes, parents, count);
    free(nodes);
    free(parents);
    return good;
}

/* The mode of a run, which is that of all its rows. */
static int check_mode(nkwi_keys *k, size_t from, size_t to)
{
    for (size_t i = from; i < to; i++) {
        k->line = k->rows[i].line;
        if (k->rows[i].interpolation != k->rows[from].interpolation)
            return nkwi_keys_fail(k, "interpolation", NKW_IMPORT_INVALID, "another than in the first row of the node");
    }
    return 1;
}

/* The rows of a key of `parts` weights have the same time, and none is missing. */
static int check_weights(nkwi_keys *k, size_t from, size_t to, size_t parts)
{
    size_t count = 0;
    float time = 0.0f;
    for (size_t i = from; i < to; i++) {
        if (!has(&k->rows[i], NKW_CLIP_FLOATS))
            continue;
        k->line = k->rows[i].line;
        if (count++ % parts == 0)
            time = k->rows[i].time;
        else if (k->rows[i].time != time)
            return nkwi_keys_fail(k, "weight", NKW_IMPORT_INVALID, "the time before has fewer weights than the first");
    }
    return count % parts == 0 ||
           nkwi_keys_fail(k, "weight", NKW_IMPORT_INVALID, "the last time has fewer weights than the first");
}

/* The keys of `parts` rows each: times, and values between tangents, as in glTF. */
static void copy_keys(const nkwi_keys *k, size_t from, size_t to, nkw_clip_track *out, float *times, float *values)
{
    int property = (int)out->target, cubic = out->track.interpolation == NKW_INTERPOLATION_CUBICSPLINE;
    size_t w = nkwi_keys_width[property], parts = out->track.width / w, count = 0, span = out->track.width;
    for (size_t i = from; i < to; i++) {
        const float *v = k->numbers + k->rows[i].numbers + nkwi_keys_first[property];
        if (!has(&k->rows[i], property))
            continue;
        float *key = values + count / parts * span * (cubic ? 3 : 1) + count % parts * w;
        times[count / parts] = k->rows[i].time;
        memcpy(key + (cubic ? span : 0), v, w * sizeof *v);
        if (cubic && k->stride == NKWI_NUMBERS) {
            memcpy(key, v + NKWI_VALUES, w * sizeof *v);
            memcpy(key + 2 * span, v + 2 * NKWI_VALUES, w * sizeof *v);
        }
        count++;
    }
}

/*
 * The keys of a property in rows from .. to - 1 of one clip and node; none: the track stays without keys. *added: those
 * that no row has.
 */
static int make_track(nkwi_keys *k, size_t from, size_t to, int property, nkw_clip_track *out, size_t *added)
{
    const nkw_document *d = &k->document->all;
    size_t count = 0, joint = (size_t)d->joint_of_node[k->rows[from].node];
    size_t parts = property == NKW_CLIP_FLOATS ? d->nodes[joint].float_count : 1;
    nkw_interpolation mode = k->rows[from].interpolation;
    const int turns = property == NKW_CLIP_ROTATION && mode == NKW_INTERPOLATION_LINEAR;
    for (size_t i = from; i < to; i++)
        count += (size_t)has(&k->rows[i], property);
    if (count == 0)
        return 1;
    if (turns && !nkwi_keys_check_turns(k, from, to))
        return 0;
    *added = turns ? nkwi_keys_turns(k, from, to, NULL, NULL) - count : 0;
    count += *added;
    if (property == NKW_CLIP_FLOATS && !check_weights(k, from, to, parts))
        return 0;
    size_t floats = count * nkwi_keys_width[property] * (mode == NKW_INTERPOLATION_CUBICSPLINE ? 3 : 1);
    float *times = (float *)nkwi_document_take(k->document, k->error, NULL, count / parts, sizeof *times);
    float *values = (float *)nkwi_document_take(k->document, k->error, NULL, floats, sizeof *values);
    if (!times || !values)
        return 0;
    const nkw_track track = {times,
                             values,
                             count / parts,
                             parts * nkwi_keys_width[property],
                             property == NKW_CLIP_ROTATION ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS,
                             mode,
                             NULL};
    out->target = (nkw_clip_target)property;
    out->index = property == NKW_CLIP_FLOATS ? d->nodes[joint].float_first : (uint32_t)joint;
    out->track = track;
    if (turns)
        nkwi_keys_turns(k, from, to, times, values);
    else
        copy_keys(k, from, to, out, times, values);
    return 1;
}

/* Tracks of the rows from .. to - 1, which are those of one clip. */
static int make_animation(nkwi_keys *k, size_t from, size_t to, nkw_document_animation *out)
{
    size_t runs = 1;
    for (size_t i = from + 1; i < to; i++)
        runs += k->rows[i].node != k->rows[i - 1].node;
    nkw_clip_track *tracks =
        (nkw_clip_track *)nkwi_document_take(k->document, k->error, NULL, runs, 4 * sizeof *tracks);
    nkw_document_channel *channels =
        (nkw_document_channel *)nkwi_document_take(k->document, k->error, NULL, runs, 4 * sizeof *channels);
    if (!tracks || !channels)
        return 0;
    out->tracks = tracks;
    out->channels = channels;
    for (size_t end; from < to; from = end) {
        end = end_of_run(k, from);
        if (!check_mode(k, from, end))
            return 0;
        for (int property = 0; property < 4; property++) {
            nkw_clip_track *track = &tracks[out->track_count];
            nkw_document_channel *channel = &channels[out->track_count];
            if (!make_track(k, from, end, property, track, &channel->added))
                return 0;
            channel->number = out->track_count;
            channel->joint = k->document->all.joint_of_node[k->rows[from].node];
            channel->bytes = (track->track.count + nkw_track_value_count(&track->track)) * sizeof(float);
            out->track_count += track->track.count > 0;
        }
    }
    return 1;
}

static int make_animations(nkwi_keys *k)
{
    size_t count = json_object_size(k->clips), next = 0;
    nkw_document_animation *list =
        (nkw_document_animation *)nkwi_document_take(k->document, k->error, NULL, count, sizeof *list);
    const char *name;
    json_t *index;
    if (!list)
        return 0;
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

static int make_document(nkwi_keys *k, const char *format)
{
    if (k->row_count == 0)
        return nkwi_keys_fail(k, NULL, NKW_IMPORT_INVALID, "there are no keys");
    k->document->all.format = format;
    return make_nodes(k) && make_animations(k);
}

static int read_rows(nkwi_keys *k, const nkw_import_memory *memory, const nkwi_value *root, const char **format)
{
    *format = !root ? "CSV keys" : "JSON keys";
    if (!root)
        return nkwi_table_read(k, memory->data, memory->bytes);
    return nkwi_table_are(root) ? nkwi_table_read_tree(k, root) : nkwi_scenes_read(k, root);
}

/* root: NULL for CSV. */
static int read_keys(nkwi_document *document, const nkw_import_memory *memory, const nkwi_value *root,
                     nkw_import_error *error)
{
    nkwi_keys k;
    const char *format;
    int done = 0;
    memset(&k, 0, sizeof k);
    k.document = document;
    k.error = error;
    k.clips = json_object();
    k.nodes = json_object();
    k.parents = json_array();
    if (!k.clips || !k.nodes || !k.parents)
        nkwi_keys_no_memory(&k);
    else
        done = read_rows(&k, memory, root, &format) && make_document(&k, format);
    json_decref(k.clips);
    json_decref(k.nodes);
    json_decref(k.parents);
    free(k.rows);
    free(k.numbers);
    return done;
}

int nkwi_keys_is(const void *data, size_t bytes)
{
    return nkwi_table_is(data, bytes);
}

int nkwi_keys_read(nkwi_document *document, const nkw_import_memory *memory, nkw_import_error *error)
{
    return read_keys(document, memory, NULL, error);
}

int nkwi_keys_are(const nkwi_value *root)
{
    return !nkwi_member(root, "asset").json && (nkwi_table_are(root) || nkwi_scenes_are(root));
}

int nkwi_keys_read_tree(nkwi_document *document, const nkwi_value *root, nkw_import_error *error)
{
    return read_keys(document, NULL, root, error);
}
