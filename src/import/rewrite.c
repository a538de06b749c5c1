/* SPDX-License-Identifier: MIT */
/*
 * A glTF 2.0 file with other animations.
 *
 * Invariant: an accessor that something other than a sampler may name keeps its index, also where an extension that is
 * not known here names it. Views may be renumbered: an index of a view is a member named bufferView anywhere.
 *
 *     step         the tree                                          the buffer of the sink
 *     animations   samplers -> new accessors -> one new view         | new keys |
 *     images       outer files -> new views, if asked                | new keys | images |
 *     views        those that nothing names are dropped              |
 *     buffers      old views -> offsets in the one buffer            | new keys | images | parts of old buffers |
 *
 * Accessors of a file with n of them, of which 2 and 4 were the keys of samplers only, after four new ones:
 *
 *     index        0     1     2     3     4    ...  n - 1  n      n + 1  n + 2  n + 3
 *     appended     mesh  mesh  old   mesh  old       mesh   key a  key b  key c  key d
 *     moved        mesh  mesh  key a mesh  key b     mesh   key c  key d
 *
 * While this is done a new view has a member "new", which no glTF file may have: its offset is in the sink already.
 */
#include <stdlib.h>
#include <string.h>

#include "file.h"
#include "sink.h"

/* A part: bytes start..end - 1 of an old buffer, which views need, and their place in the sink, `at`. */
typedef struct part {
    size_t buffer, start, end, at;
} part;

typedef struct rewriter {
    nkwi_gltf g;
    nkwi_sink sink;
    const nkw_gltf_rewriting *rewriting;
    json_t *root;
    unsigned char *freed; /* of each accessor: it has no use any more */
    size_t accessor_count;
    part *parts; /* merged, in the order of buffers and bytes */
    size_t part_count;
} rewriter;

static int no_memory(rewriter *r)
{
    if (r->sink.error->code == NKW_IMPORT_OK)
        nkwi_fail(r->sink.error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the file");
    return 0;
}

/* ---- animations ---- */

static size_t index_of(const json_t *object, const char *key)
{
    const json_t *value = json_object_get(object, key);
    return json_is_integer(value) && json_integer_value(value) >= 0 ? (size_t)json_integer_value(value) : SIZE_MAX;
}

/* The track of a channel of the file; SIZE_MAX if it has none. */
static size_t track_of(const nkw_document_animation *a, size_t channel)
{
    for (size_t i = 0; i < a->track_count; i++)
        if (a->channels[i].number == channel)
            return i;
    return SIZE_MAX;
}

/* Arrays are compared by address: `to` names those of `from` where nothing is replaced. */
static int is_replaced(const nkw_track *from, const nkw_track *to)
{
    return from->times != to->times || from->values != to->values || from->count != to->count ||
           from->interpolation != to->interpolation || from->key_interpolation != to->key_interpolation;
}

/* The type of the old values; another than an integer of at most 16 bits counts as float. */
static nkwi_component component_of(const rewriter *r, size_t accessor)
{
    size_t type = index_of(json_array_get(r->sink.accessors, accessor), "componentType");
    return type >= NKWI_I8 && type <= NKWI_U16 ? (nkwi_component)type : NKWI_F32;
}

/* Channel i of animation a, with a new sampler at the end of the list. */
static int replace_channel(rewriter *r, size_t a, size_t i, const json_t *old, json_t *samplers)
{
    const nkw_document_animation *from = &r->rewriting->from->animations[a], *to = &r->rewriting->to->animations[a];
    json_t *channel =
        json_array_get(json_object_get(json_array_get(json_object_get(r->root, "animations"), a), "channels"), i);
    const nkwi_place root = {NULL, NULL, 0}, list = {&root, "animations", 0}, at = {&list, NULL, a};
    const nkwi_place channels = {&at, "channels", 0}, place = {&channels, NULL, i};
    const size_t track = track_of(from, i), number = index_of(channel, "sampler");
    json_t *sampler = json_array_get(old, number), *made = NULL;
    if (track != SIZE_MAX) {
        made = nkwi_sink_sampler(&r->sink, &to->tracks[track], &place, component_of(r, index_of(sampler, "output")));
        if (!made)
            return r->sink.failed ? no_memory(r) : 0;
    }
    nkwi_set(&r->sink, channel, "sampler", json_integer((json_int_t)json_array_size(samplers)));
    nkwi_put(&r->sink, samplers, made ? made : json_incref(sampler));
    return 1;
}

/* Samplers that several channels share, and that are not replaced, remain shared. */
static void share_samplers(rewriter *r, json_t *channels, json_t *samplers)
{
    json_t *list = json_array();
    for (size_t i = 0; i < json_array_size(channels); i++) {
        const json_t *sampler = json_array_get(samplers, i);
        size_t k = 0;
        while (k < json_array_size(list) && json_array_get(list, k) != sampler)
            k++;
        if (k == json_array_size(list))
            nkwi_put(&r->sink, list, json_incref((json_t *)json_array_get(samplers, i)));
        nkwi_set(&r->sink, json_array_get(channels, i), "sampler", json_integer((json_int_t)k));
    }
    json_array_clear(samplers);
    json_array_extend(samplers, list);
    json_decref(list);
}

static int replace_animation(rewriter *r, size_t a)
{
    json_t *object = json_array_get(json_object_get(r->root, "animations"), a);
    json_t *channels = json_object_get(object, "channels"), *old = json_object_get(object, "samplers");
    json_t *samplers = json_array();
    int done = 1;
    for (size_t i = 0; done && i < json_array_size(channels); i++)
        done = replace_channel(r, a, i, old, samplers);
    if (done)
        share_samplers(r, channels, samplers);
    nkwi_set(&r->sink, object, "samplers", samplers);
    return done;
}

static int replaces_any(const nkw_gltf_rewriting *w)
{
    for (size_t a = 0; a < w->from->animation_count; a++)
        for (size_t i = 0; i < w->from->animations[a].track_count; i++)
            if (is_replaced(&w->from->animations[a].tracks[i].track, &w->to->animations[a].tracks[i].track))
                return 1;
    return 0;
}

static int matches(const nkw_gltf_rewriting *w, size_t count)
{
    int same = w->from->animation_count == w->to->animation_count && w->from->animation_count == count;
    for (size_t a = 0; same && a < count; a++)
        same = w->from->animations[a].track_count == w->to->animations[a].track_count;
    return same;
}

/*
 * Marks, or unmarks, the accessors of all samplers. Called with 1 before and with 0 after the channels are replaced, it
 * leaves marked what the old samplers used and the new ones do not.
 */
static void mark_samplers(rewriter *r, unsigned char mark)
{
    const json_t *animations = json_object_get(r->root, "animations");
    for (size_t a = 0; a < json_array_size(animations); a++) {
        const json_t *samplers = json_object_get(json_array_get(animations, a), "samplers");
        for (size_t i = 0; i < json_array_size(samplers); i++) {
            size_t in = index_of(json_array_get(samplers, i), "input"), out;
            out = index_of(json_array_get(samplers, i), "output");
            if (in < r->accessor_count)
                r->freed[in] = mark;
            if (out < r->accessor_count)
                r->freed[out] = mark;
        }
    }
}

static void keep(rewriter *r, const json_t *object, const char *key)
{
    size_t index = index_of(object, key);
    if (index < r->accessor_count)
        r->freed[index] = 0;
}

static void keep_all(rewriter *r, const json_t *attributes)
{
    const char *key;
    json_t *value;
    json_object_foreach((json_t *)attributes, key, value) keep(r, attributes, key);
}

/* The accessors of meshes and skins (3.7). */
static void keep_others(rewriter *r)
{
    const json_t *meshes = json_object_get(r->root, "meshes"), *skins = json_object_get(r->root, "skins");
    for (size_t i = 0; i < json_array_size(skins); i++)
        keep(r, json_array_get(skins, i), "inverseBindMatrices");
    for (size_t m = 0; m < json_array_size(meshes); m++) {
        const json_t *list = json_object_get(json_array_get(meshes, m), "primitives");
        for (size_t p = 0; p < json_array_size(list); p++) {
            const json_t *primitive = json_array_get(list, p), *targets = json_object_get(primitive, "targets");
            keep(r, primitive, "indices");
            keep_all(r, json_object_get(primitive, "attributes"));
            for (size_t t = 0; t < json_array_size(targets); t++)
                keep_all(r, json_array_get(targets, t));
        }
    }
}

/*
 * An accessor of new keys that was appended moves to a freed index, from the first on. to[i] is the new index of
 * accessor accessor_count + i. slot ascends, so the freed indices below it are all in use.
 */
static void move_accessors(rewriter *r)
{
    const json_t *animations = json_object_get(r->root, "animations");
    size_t appended = json_array_size(r->sink.accessors) - r->accessor_count, slot = 0, moved = 0;
    size_t *to = (size_t *)nkwi_take(&r->sink.scratch, appended, sizeof *to);
    r->sink.failed = r->sink.failed || !to;
    for (; !r->sink.failed && moved < appended; moved++) {
        while (slot < r->accessor_count && !r->freed[slot])
            slot++;
        if (slot == r->accessor_count)
            break;
        json_array_set(r->sink.accessors, slot, json_array_get(r->sink.accessors, r->accessor_count + moved));
        to[moved] = slot++;
    }
    for (size_t i = moved; !r->sink.failed && i < appended; i++) {
        to[i] = r->accessor_count + i - moved;
        json_array_set(r->sink.accessors, to[i], json_array_get(r->sink.accessors, r->accessor_count + i));
    }
    if (r->sink.failed)
        return;
    while (json_array_size(r->sink.accessors) > r->accessor_count + appended - moved)
        json_array_remove(r->sink.accessors, json_array_size(r->sink.accessors) - 1);
    for (size_t a = 0; a < json_array_size(animations); a++) {
        const json_t *samplers = json_object_get(json_array_get(animations, a), "samplers");
        for (size_t i = 0; i < json_array_size(samplers); i++) {
            json_t *sampler = json_array_get(samplers, i);
            size_t in = index_of(sampler, "input"), out = index_of(sampler, "output");
            if (in >= r->accessor_count)
                nkwi_set(&r->sink, sampler, "input", json_integer((json_int_t)to[in - r->accessor_count]));
            if (out >= r->accessor_count)
                nkwi_set(&r->sink, sampler, "output", json_integer((json_int_t)to[out - r->accessor_count]));
        }
    }
    /* Freed indices that remain: dropped at the end of the list, elsewhere accessors of the last new keys. */
    for (size_t last = r->accessor_count; moved == appended && last-- > slot;)
        if (r->freed[last] && last + 1 == json_array_size(r->sink.accessors))
            json_array_remove(r->sink.accessors, last);
    for (size_t k = slot; moved == appended && moved > 0 && k < json_array_size(r->sink.accessors); k++)
        if (r->freed[k])
            json_array_set(r->sink.accessors, k, json_array_get(r->sink.accessors, to[moved - 1]));
}

static int replace_animations(rewriter *r)
{
    const size_t count = json_array_size(json_object_get(r->root, "animations"));
    if (!matches(r->rewriting, count))
        return nkwi_fail(r->sink.error, NULL, NKW_IMPORT_REFUSED, "other animations than those of the file");
    if (!replaces_any(r->rewriting))
        return 1;
    r->accessor_count = json_array_size(r->sink.accessors);
    r->freed = (unsigned char *)nkwi_take(&r->sink.scratch, r->accessor_count, 1);
    if (!r->freed)
        return no_memory(r);
    mark_samplers(r, 1);
    for (size_t a = 0; a < count; a++)
        if (!replace_animation(r, a))
            return 0;
    mark_samplers(r, 0);
    keep_others(r);
    move_accessors(r);
    return !r->sink.failed || no_memory(r);
}

/* ---- views ---- */

/* Calls `at` for each member bufferView of an object of the tree, except those of extras. */
static void each_view(json_t *value, void (*at)(void *user, json_t *object, size_t view), void *user)
{
    const char *key;
    json_t *member;
    size_t i;
    if (json_is_array(value))
        json_array_foreach(value, i, member) each_view(member, at, user);
    if (!json_is_object(value))
        return;
    if (index_of(value, "bufferView") != SIZE_MAX)
        at(user, value, index_of(value, "bufferView"));
    json_object_foreach(value, key, member) if (strcmp(key, "extras") != 0) each_view(member, at, user);
}

typedef struct view_map {
    size_t *to; /* of each view: 1 if it is used; then its new index */
    size_t count;
    nkwi_sink *sink;
} view_map;

static void use_view(void *user, json_t *object, size_t view)
{
    view_map *map = (view_map *)user;
    (void)object;
    if (view < map->count)
        map->to[view] = 1;
}

static void renumber(void *user, json_t *object, size_t view)
{
    view_map *map = (view_map *)user;
    if (view < map->count)
        nkwi_set(map->sink, object, "bufferView", json_integer((json_int_t)map->to[view]));
}

/* An accessor may be in the list several times: it is renumbered once. */
static void renumber_all(rewriter *r, view_map *map)
{
    json_t *list = r->sink.accessors;
    for (size_t i = 0; i < json_array_size(list); i++) {
        json_t *copy = json_deep_copy(json_array_get(list, i));
        r->sink.failed = r->sink.failed || json_array_set_new(list, i, copy) != 0;
    }
    each_view(r->root, renumber, map);
}

/* Drops the views that nothing refers to. */
static int drop_views(rewriter *r)
{
    const size_t count = json_array_size(r->sink.views);
    view_map map = {(size_t *)nkwi_take(&r->sink.scratch, count, sizeof(size_t)), count, &r->sink};
    json_t *list = json_array();
    if (!map.to || !list)
        return no_memory(r);
    each_view(r->root, use_view, &map);
    for (size_t i = 0; i < count; i++) {
        const int used = map.to[i] == 1;
        map.to[i] = json_array_size(list);
        if (used)
            nkwi_put(&r->sink, list, json_incref(json_array_get(r->sink.views, i)));
    }
    json_array_clear(r->sink.views);
    json_array_extend(r->sink.views, list);
    json_decref(list);
    renumber_all(r, &map);
    return !r->sink.failed || no_memory(r);
}

/* ---- buffers ---- */

static int before(const void *a, const void *b)
{
    const part *x = (const part *)a, *y = (const part *)b;
    if (x->buffer != y->buffer)
        return x->buffer < y->buffer ? -1 : 1;
    return x->start < y->start ? -1 : x->start > y->start;
}

/* The bytes of a view of the source. Those of new keys are in the sink already: their buffer is the sink. */
static part part_of(const json_t *view)
{
    /* 3.6.1: byteOffset is optional, and 0 without it. */
    const size_t start = index_of(view, "byteOffset"), from = start == SIZE_MAX ? 0 : start;
    const part p = {index_of(view, "buffer"), from, from + index_of(view, "byteLength"), 0};
    return p;
}

static int is_new(const json_t *view)
{
    return json_object_get(view, "new") != NULL;
}

/*
 * Overlapping views become one part. Their places keep the remainder modulo 4, so elements remain aligned (3.6.2.4).
 *
 *     views of buffer 0    [8 ... 20)   [12 ...... 40)       [64 ... 70)
 *     parts                [8 ................... 40)        [64 ... 70)
 */
static int collect_parts(rewriter *r)
{
    size_t n = 0;
    for (size_t i = 0; i < json_array_size(r->sink.views); i++) {
        const json_t *view = json_array_get(r->sink.views, i);
        const part p = part_of(view);
        nkwi_buffer buffer;
        if (is_new(view))
            continue;
        if (p.buffer >= nkwi_length(&r->g.buffer_list) || p.end < p.start)
            return nkwi_fail(r->sink.error, NULL, NKW_IMPORT_INVALID, "bufferView %zu is outside its buffer", i);
        if (!nkwi_gltf_buffer(&r->g, p.buffer, &buffer))
            return 0;
        if (p.end > buffer.bytes)
            return nkwi_fail(r->sink.error, NULL, NKW_IMPORT_INVALID, "bufferView %zu is outside its buffer", i);
        r->parts[n++] = p;
    }
    qsort(r->parts, n, sizeof *r->parts, before);
    for (size_t i = 0; i < n; i++) {
        part *last = r->part_count ? &r->parts[r->part_count - 1] : NULL;
        if (last && last->buffer == r->parts[i].buffer && r->parts[i].start < last->end)
            last->end = r->parts[i].end > last->end ? r->parts[i].end : last->end;
        else
            r->parts[r->part_count++] = r->parts[i];
    }
    return 1;
}

static int copy_parts(rewriter *r)
{
    static const unsigned char zeros[4] = {0};
    for (size_t i = 0; i < r->part_count; i++) {
        part *p = &r->parts[i];
        nkwi_buffer buffer;
        if (!nkwi_gltf_buffer(&r->g, p->buffer, &buffer))
            return 0;
        const size_t lead = p->start % 4, at = nkwi_sink_append(&r->sink, zeros, lead);
        const size_t begin = p->start - lead;
        if (!r->sink.failed)
            r->sink.bytes = at;
        p->at = nkwi_sink_append(&r->sink, buffer.data + begin, p->end - begin) + lead;
    }
    return !r->sink.failed || no_memory(r);
}

static void place_views(rewriter *r)
{
    for (size_t i = 0; i < json_array_size(r->sink.views); i++) {
        json_t *view = json_array_get(r->sink.views, i);
        const part p = part_of(view);
        size_t low = 0, high = r->part_count;
        if (is_new(view)) {
            json_object_del(view, "new");
            continue;
        }
        while (high - low > 1) {
            size_t middle = low + (high - low) / 2;
            if (before(&r->parts[middle], &p) <= 0)
                low = middle;
            else
                high = middle;
        }
        nkwi_set(&r->sink, view, "buffer", json_integer(0));
        nkwi_set(&r->sink, view, "byteOffset",
                 json_integer((json_int_t)(r->parts[low].at + p.start - r->parts[low].start)));
    }
}

static int copy_buffers(rewriter *r)
{
    r->parts = (part *)nkwi_take(&r->sink.scratch, json_array_size(r->sink.views), sizeof *r->parts);
    if (!r->parts)
        return no_memory(r);
    if (!collect_parts(r) || !copy_parts(r))
        return 0;
    place_views(r);
    return !r->sink.failed || no_memory(r);
}

/* ---- images ---- */

/* The types of core glTF, EXT_texture_webp and KHR_texture_basisu; NULL for another. */
static const char *type_of(const unsigned char *data, size_t bytes)
{
    if (bytes > 12 && memcmp(data, "RIFF", 4) == 0 && memcmp(data + 8, "WEBP", 4) == 0)
        return "image/webp";
    if (bytes > 12 && memcmp(data, "\xabKTX 20\xbb\r\n\x1a\n", 12) == 0)
        return "image/ktx2";
    return nkwi_image_type(data, bytes);
}

/* The path of an outer image; NULL of others. */
static const char *outer_of(const json_t *image)
{
    const char *uri = json_string_value(json_object_get(image, "uri"));
    return uri && strncmp(uri, "data:", 5) != 0 ? uri : NULL;
}

/* An outer image becomes a view. One that cannot be read, or is of another type, remains a name. */
static void embed_image(rewriter *r, json_t *image)
{
    const char *uri = outer_of(image);
    if (!uri || !r->g.memory->reader)
        return;
    char *path = (char *)nkwi_take(&r->sink.scratch, strlen(uri) + 1, 1);
    if (!path || nkwi_path_from_uri(uri, path))
        return;
    size_t bytes = r->g.memory->reader(r->g.memory->user, path, NULL, 0);
    unsigned char *data = bytes < NKWI_BYTES_MOST ? (unsigned char *)nkwi_take(&r->sink.scratch, bytes + 1, 1) : NULL;
    if (!data || r->g.memory->reader(r->g.memory->user, path, data, bytes) == SIZE_MAX || !type_of(data, bytes))
        return;
    json_t *view = json_object();
    nkwi_set(&r->sink, view, "buffer", json_integer(0));
    nkwi_set(&r->sink, view, "byteOffset", json_integer((json_int_t)nkwi_sink_append(&r->sink, data, bytes)));
    nkwi_set(&r->sink, view, "byteLength", json_integer((json_int_t)bytes));
    nkwi_set(&r->sink, view, "new", json_true());
    nkwi_set(&r->sink, image, "bufferView", json_integer((json_int_t)json_array_size(r->sink.views)));
    nkwi_set(&r->sink, image, "mimeType", json_string(type_of(data, bytes)));
    nkwi_put(&r->sink, r->sink.views, view);
    json_object_del(image, "uri");
}

static void embed_images(rewriter *r, nkw_gltf_file *file)
{
    json_t *images = json_object_get(r->root, "images");
    for (size_t i = 0; i < json_array_size(images); i++) {
        json_t *image = json_array_get(images, i);
        if (r->rewriting->embeds_images)
            embed_image(r, image);
        if (outer_of(image))
            file->outer_image = file->outer_images++ ? file->outer_image : i;
    }
}

/* ---- the file ---- */

static int check_file(rewriter *r)
{
    const json_t *used = json_object_get(r->root, "extensionsUsed");
    for (size_t i = 0; i < json_array_size(used); i++) {
        const char *name = json_string_value(json_array_get(used, i));
        if (name && strstr(name, "meshopt_compression"))
            return nkwi_fail(r->sink.error, NULL, NKW_IMPORT_UNSUPPORTED, "files with %s cannot be rewritten", name);
    }
    return 1;
}

static json_t *list_of(rewriter *r, const char *key)
{
    json_t *list = json_object_get(r->root, key);
    if (!list)
        json_object_set_new(r->root, key, list = json_array());
    return list;
}

/* Nine digits are enough for a float. */
static int is_short(const json_t *value)
{
    const double number = json_real_value(value);
    char text[32];
    if (!json_is_real(value) || (double)(float)number == number)
        return 1;
    snprintf(text, sizeof text, "%.9g", number);
    return strtod(text, NULL) == number;
}

static int are_short(json_t *value)
{
    const char *key;
    json_t *member;
    size_t i;
    if (json_is_array(value))
        json_array_foreach(value, i, member) if (!are_short(member)) return 0;
    json_object_foreach(value, key, member) if (!are_short(member)) return 0;
    return is_short(value);
}

static int rewrite(rewriter *r, nkw_gltf_form form, const char *uri, nkw_gltf_file *file)
{
    if (!nkwi_gltf_begin(&r->g) || !check_file(r))
        return 0;
    nkwi_sink_open(&r->sink, r->g.error, list_of(r, "bufferViews"), list_of(r, "accessors"));
    nkwi_sink_begin_keys(&r->sink);
    nkwi_set(&r->sink, r->sink.view, "new", json_true());
    const int done = replace_animations(r);
    nkwi_sink_end_keys(&r->sink);
    if (!done)
        return 0;
    embed_images(r, file);
    return drop_views(r) && copy_buffers(r) &&
           nkwi_sink_write(&r->sink, r->root, form, uri, are_short(r->root) ? 9 : 17, file);
}

nkw_import_result nkw_gltf_rewrite(const nkw_gltf_rewriting *rewriting, nkw_gltf_form form, const char *uri,
                                   nkw_gltf_file *file, nkw_import_error *error)
{
    const nkw_gltf_file none = {NULL, 0, NULL, 0, 0, 0};
    nkw_import_memory memory = *rewriting->source;
    nkw_import_error own;
    char *folder = NULL;
    nkwi_document document;
    rewriter r;
    error = error ? error : &own;
    memset(&r, 0, sizeof r);
    memset(&document, 0, sizeof document);
    document.memory.most = SIZE_MAX;
    nkwi_fault_none(error, memory.file);
    *file = none;
    r.rewriting = rewriting;
    if (nkwi_document_reader(&memory, &folder, error))
        r.root = nkwi_gltf_open(&r.g, &document, &memory, 0, error);
    if (!r.root || !rewrite(&r, form, uri ? uri : "", file)) {
        nkw_gltf_file_free(file);
        if (error->code == NKW_IMPORT_OK)
            nkwi_fail(error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the file");
    }
    nkwi_sink_close(&r.sink);
    nkwi_give(&r.g.scratch);
    nkwi_give(&document.memory);
    json_decref(r.root);
    free(folder);
    return error->code;
}
