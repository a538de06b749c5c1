/* SPDX-License-Identifier: MIT */
/*
 * What Assimp 5.2 loses of Collada, from the text of the file: the names of nodes, and clips. It names nodes by their
 * ids, and mixes the animations of clips.
 *
 * Each clip is imported by itself, from a copy of the text of the same length: the library of clips has another name,
 * a channel of an animation that is not of the clip has a target that is no node, and the animations are one, for their
 * inner tags are blank.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/edit.h>

#include "assimp.h"
#include "decimal.h"
#include "utf8.h"
#include "xml.h"

enum { NAME_MOST = 1024, CLIPS_MOST = 256 };

/* Every node of the tree whose name is the id gets the name. */
static int rename_nodes(nkwi_assimp *a, const char *id, const char *name)
{
    nkw_document_node *nodes = a->document->nodes;
    const char *text = NULL;
    memset(a->uses, 0, a->node_count * sizeof *a->uses);
    int32_t first = nkwi_assimp_find_nth(a, id, a->uses), node = first;
    while (node != NKW_NO_JOINT) {
        text = text ? text : nkwi_document_text(a->document, a->error, name);
        if (!text)
            return 0;
        nodes[nkwi_assimp_joint(a, node)].name = text;
        node = nkwi_assimp_find_nth(a, id, a->uses);
        node = node == first ? NKW_NO_JOINT : node;
    }
    return 1;
}

/* A node is known to Assimp by its id, without one by its sid. */
static int read_names(nkwi_assimp *a, const nkw_import_memory *file)
{
    nkwi_xml x = nkwi_xml_begin(file->data, file->bytes);
    char id[NAME_MOST], name[NAME_MOST];
    while (nkwi_xml_next(&x)) {
        if (!nkwi_xml_opens(&x, "node"))
            continue;
        nkwi_xml_text(&x, nkwi_xml_attribute(&x, "id").data ? "id" : "sid", id, sizeof id);
        nkwi_xml_text(&x, "name", name, sizeof name);
        nkwi_utf8(name, strlen(name));
        if (id[0] && name[0] && !rename_nodes(a, id, name))
            return 0;
    }
    return 1;
}

/* A clip: its tag, and its part of the text. */
typedef struct clip {
    nkwi_xml tag;
    nkwi_span part;
} clip;

/* The next clip of the file. */
static int next_clip(nkwi_xml *x, clip *out)
{
    while (nkwi_xml_next(x)) {
        if (!nkwi_xml_opens(x, "animation_clip"))
            continue;
        out->tag = *x;
        out->part.data = x->at;
        while (!out->tag.is_empty && nkwi_xml_next(x) && !nkwi_span_is(x->name, "animation_clip"))
            continue;
        out->part.length = (size_t)(x->at - out->part.data);
        return 1;
    }
    return 0;
}

/* Whether the clip has the animation of this id. */
static int has_animation(const clip *c, const char *id)
{
    nkwi_xml x = nkwi_xml_begin(c->part.data, c->part.length);
    char url[NAME_MOST];
    while (nkwi_xml_next(&x)) {
        nkwi_xml_text(&x, "url", url, sizeof url);
        if (nkwi_xml_opens(&x, "instance_animation") && url[0] == '#' && strcmp(url + 1, id) == 0)
            return 1;
    }
    return 0;
}

/* The copy of the text while the tags of the text are read. */
typedef struct copy {
    const char *text;
    char *out;
    size_t depth, chosen; /* of animations: inner ones count; that of the chosen one, 0 for none */
    nkwi_span close; /* the last </animation> of the library, which remains */
    int is_open; /* an <animation> remains */
} copy;

static void blank(copy *c, const char *from, const char *to)
{
    memset(c->out + (from - c->text), ' ', (size_t)(to - from));
}

/* A tag of an animation: the first of a library remains, and the last. */
static void copy_animation(copy *c, const nkwi_xml *x, const clip *of)
{
    const char *from = x->name.data - 1;
    char id[NAME_MOST];
    while (*from != '<')
        from--;
    if (x->closes) {
        if (c->close.data)
            blank(c, c->close.data, c->close.data + c->close.length);
        c->close.data = from;
        c->close.length = (size_t)(x->at - from);
        c->chosen = c->chosen == c->depth ? 0 : c->chosen;
        c->depth -= c->depth > 0;
        return;
    }
    if (c->is_open || x->is_empty)
        blank(c, from, x->at);
    if (x->is_empty)
        return;
    c->is_open = 1;
    c->depth++;
    nkwi_xml_text(x, "id", id, sizeof id);
    if (!c->chosen && has_animation(of, id))
        c->chosen = c->depth;
}

/* The target of a channel that is not of the clip: no node has such an id. */
static void copy_channel(copy *c, const nkwi_xml *x)
{
    const nkwi_span target = nkwi_xml_attribute(x, "target");
    for (size_t i = 0; !c->chosen && i < target.length; i++)
        if (target.data[i] != '/')
            c->out[target.data + i - c->text] = '_';
}

/* The text with the animations of one clip, as one animation. To be freed. */
static char *text_of_clip(const nkw_import_memory *file, const clip *of)
{
    copy c = {(const char *)file->data, (char *)malloc(file->bytes + 1), 0, 0, {NULL, 0}, 0};
    nkwi_xml x = nkwi_xml_begin(file->data, file->bytes);
    if (!c.out)
        return NULL;
    memcpy(c.out, file->data, file->bytes);
    while (nkwi_xml_next(&x)) {
        if (nkwi_span_is(x.name, "animation"))
            copy_animation(&c, &x, of);
        else if (nkwi_xml_opens(&x, "channel"))
            copy_channel(&c, &x);
        else if (nkwi_span_is(x.name, "library_animation_clips"))
            c.out[x.name.data + x.name.length - 1 - c.text] = '_';
        else if (nkwi_span_is(x.name, "library_animations")) {
            c.close.data = NULL;
            c.is_open = 0;
        }
    }
    return c.out;
}

/* An attribute that is a time in seconds; 0 where there is none. */
static int read_time(const nkwi_xml *tag, const char *key, float *seconds)
{
    const nkwi_span value = nkwi_xml_attribute(tag, key);
    double number;
    if (!value.data || nkwi_decimal(value.data, value.length, &number))
        return 0;
    *seconds = (float)number;
    return 1;
}

/* The part of the tracks from the start of the clip to its end, where it states them. */
static int trim(nkwi_assimp *a, const nkwi_xml *tag, const nkw_document_animation *animation, nkw_clip_track *tracks)
{
    float start = 0.0f, end = 0.0f;
    int has_end = read_time(tag, "end", &end);
    if (!read_time(tag, "start", &start) && !has_end)
        return 1;
    for (size_t i = 0; i < animation->track_count; i++) {
        nkw_track *t = &tracks[i].track;
        float last = has_end ? end : t->times[t->count - 1];
        size_t room = t->count + 1;
        const nkw_track_span span = {(float *)nkwi_assimp_take(a, "animations", room, sizeof(float)),
                                     (float *)nkwi_assimp_take(a, "animations", room, t->width * sizeof(float)),
                                     NULL, room};
        if (!span.times || !span.values)
            return 0;
        if (last >= start)
            nkw_track_trim(t, start, last, span, t); /* a track that is not valid remains, to be reported */
    }
    return 1;
}

static int read_clip(nkwi_assimp *a, const nkw_import_memory *file, const char *name, const clip *c, size_t index,
                     nkw_document_animation *out)
{
    nkw_import_memory memory = *file;
    nkwi_assimp_files files;
    char text[NAME_MOST];
    char *data = text_of_clip(file, c);
    nkw_clip_track *tracks;
    memory.data = data;
    if (!data)
        return nkwi_fail(a->error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the text of a clip");
    const struct aiScene *scene = nkwi_assimp_import(&memory, name, &files);
    nkwi_xml_text(&c->tag, nkwi_xml_attribute(&c->tag, "name").length ? "name" : "id", text, sizeof text);
    nkwi_utf8(text, strlen(text));
    out->name = nkwi_document_name(a->document, a->error, text, "animation", index);
    int good = out->name && scene;
    if (!scene)
        nkwi_fail(a->error, NULL, NKW_IMPORT_INVALID, "Assimp: %s", aiGetErrorString());
    good = good && nkwi_assimp_join_animations(a, scene, index, out, &tracks) && trim(a, &c->tag, out, tracks);
    aiReleaseImport(scene);
    free(data);
    return good;
}

static int read_clips(nkwi_assimp *a, const nkw_import_memory *file, const char *name)
{
    nkwi_xml x = nkwi_xml_begin(file->data, file->bytes);
    size_t count = 0, read = 0;
    clip c;
    while (next_clip(&x, &c))
        count++;
    if (count == 0)
        return 1;
    if (count > CLIPS_MOST && !nkwi_document_warn(a->document, a->error, "%zu clips: the first %d are read", count,
                                                  CLIPS_MOST))
        return 0;
    count = count < CLIPS_MOST ? count : CLIPS_MOST;
    nkw_document_animation *list =
        (nkw_document_animation *)nkwi_assimp_take(a, "animations", count, sizeof *list);
    x = nkwi_xml_begin(file->data, file->bytes);
    for (; list && read < count && next_clip(&x, &c); read++)
        if (!read_clip(a, file, name, &c, read, &list[read]))
            return 0;
    a->document->all.animations = list;
    a->document->all.animation_count = read;
    return list != NULL;
}

int nkwi_assimp_collada(nkwi_assimp *a, const nkw_import_memory *file, const char *name)
{
    if (strcmp(nkwi_assimp_extension(file), ".dae") != 0)
        return 1;
    return read_clips(a, file, name) && read_names(a, file);
}
