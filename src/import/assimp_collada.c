/* SPDX-License-Identifier: MIT */
/* Nodes of Collada, read beside Assimp (collada.h), which names nodes by their ids, or else by their sids. */
#include "assimp_collada.h"

#include <stdlib.h>
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/transform.h>

static int begins(const char *at, const char *end, const char *text)
{
    const size_t length = strlen(text);
    return (size_t)(end - at) >= length && memcmp(at, text, length) == 0;
}

static char *find(char *at, char *end, const char *text)
{
    while (at < end && !begins(at, end, text))
        at++;
    return at < end ? at + strlen(text) : end;
}

/* The text behind > without the blanks at its beginning, which follow it. Returns its end. */
static char *trim(char *at, char *end)
{
    char *from = at, *to;
    while (from < end && (*from == ' ' || *from == '\t' || *from == '\r' || *from == '\n'))
        from++;
    to = from < end ? (char *)memchr(from, '<', (size_t)(end - from)) : NULL;
    if (!to || to == from || from == at)
        return at;
    memmove(at, from, (size_t)(to - from));
    memset(at + (to - from), ' ', (size_t)(from - at));
    return to;
}

/* The end of the library at a tag, which becomes blank; of an empty one the end of its tag. */
static char *blank(char *at, char *end, const char *close)
{
    char *open = find(at, end, ">");
    char *last = open < end && open[-2] == '/' ? open : find(open, end, close);
    if (last < end)
        memset(at, ' ', (size_t)(last - at));
    return last;
}

int nkwi_assimp_collada_trim(nkw_import_memory *memory, void **copy)
{
    char *text = memory->bytes > 0 && memory->bytes < SIZE_MAX ? (char *)malloc(memory->bytes) : NULL;
    *copy = text;
    if (!text)
        return 0;
    memcpy(text, memory->data, memory->bytes);
    for (char *at = text, *end = text + memory->bytes; at < end;) {
        if (begins(at, end, "<!--"))
            at = find(at, end, "-->");
        else if (begins(at, end, "<library_animations"))
            at = blank(at, end, "</library_animations>");
        else if (begins(at, end, "<library_animation_clips"))
            at = blank(at, end, "</library_animation_clips>");
        else
            at = *at == '>' ? trim(at + 1, end) : at + 1;
    }
    memory->data = text;
    return 1;
}

/* ---- tags of nodes ---- */

/* The node after `last` below a node: its nodes, then those of which it has instances. */
static const xmlNode *next_child(const xmlNode *parent, const xmlNode *last)
{
    const xmlNode *next = NULL;
    if (!last || nkwi_collada_is(last, "node"))
        next = last ? nkwi_collada_next(last, "node") : nkwi_collada_child(parent, "node");
    if (next)
        return next;
    return last && nkwi_collada_is(last, "instance_node") ? nkwi_collada_next(last, "instance_node")
                                                          : nkwi_collada_child(parent, "instance_node");
}

static int is_name(const xmlNode *tag, const char *name)
{
    const char *id = nkwi_collada_text(tag, "id"), *sid = nkwi_collada_text(tag, "sid");
    const char *known = id && *id ? id : sid && *sid ? sid : NULL;
    return known ? strcmp(known, name) == 0 : strncmp(name, "$ColladaAutoName$", 17) == 0;
}

/* A node of Assimp is that of the next tag below its parent which has its name. */
static int find_tags(nkwi_assimp *a)
{
    nkwi_assimp_collada *c = a->collada;
    const xmlNode **last = (const xmlNode **)nkwi_assimp_scratch(a, "nodes", a->node_count, sizeof *last);
    if (!last)
        return 0;
    c->tags[0] = nkwi_collada_scene(&c->file);
    for (size_t i = 1; i < a->node_count; i++) {
        const size_t parent = (size_t)a->parents[i];
        const char *name = a->nodes[i]->mName.data;
        const xmlNode *tag = NULL, *at = last[parent];
        while (c->tags[parent] && !tag && (at = next_child(c->tags[parent], at)) != NULL) {
            tag = nkwi_collada_is(at, "node") ? at : nkwi_collada_of_url(&c->file, nkwi_collada_text(at, "url"));
            tag = nkwi_collada_is(tag, "node") && is_name(tag, name) ? tag : NULL;
        }
        if (tag)
            last[parent] = at;
        c->tags[i] = tag;
        if (!tag && c->tags[parent] &&
            !nkwi_document_warn(a->document, a->error, "%s: its keys are not found, and it stays at rest", name))
            return 0;
    }
    return 1;
}

/* The transforms at rest: the product of the elements, without the skew. */
static int place_nodes(nkwi_assimp *a)
{
    nkwi_assimp_collada *c = a->collada;
    a->rests[0] = nkw_trs_from_mat4(&a->locals[0]);
    for (size_t i = 1; i < a->node_count; i++) {
        size_t count = 0, skews = 0;
        a->rests[i] = nkw_trs_from_mat4(&a->locals[i]);
        if (!c->tags[i])
            continue;
        const nkwi_collada_element *list = nkwi_collada_elements_of(&c->file, c->tags[i], &count);
        a->rests[i] = nkwi_collada_transform(&c->file, list, count, 0.0f, &a->locals[i]);
        for (size_t k = 0; k < count; k++)
            skews += list[k].kind == NKWI_COLLADA_SKEW;
        if (skews > 0 &&
            !nkwi_document_warn(a->document, a->error, "%s: its skew is not applied", a->nodes[i]->mName.data))
            return 0;
    }
    return 1;
}

static int warn_count(nkwi_assimp *a, size_t count, const char *what)
{
    return count == 0 || nkwi_document_warn(a->document, a->error, "%zu %s", count, what);
}

static int warn_lost(nkwi_assimp *a)
{
    const nkwi_collada *c = &a->collada->file;
    return warn_count(a, c->unread_kinds, "curves have segments of CARDINAL, BSPLINE or another kind: they are "
                                          "LINEAR") &&
           warn_count(a, c->no_tangents, "curves have cubic segments without tangents: they are LINEAR") &&
           warn_count(a, c->bad_curves, "curves are left out: their keys are not finite, or not in the order of their "
                                        "times") &&
           warn_count(a, c->morphs, "morph controllers are not read: Assimp loses their meshes") &&
           warn_count(a, c->infinities, "curves go on outside of their keys in another program: they stay") &&
           warn_count(a, c->flat_keys, "matrices of keys have a scale of 0: where they have no rotation, it is that of "
                                       "the key beside");
}

int nkwi_assimp_collada_open(nkwi_assimp *a, const nkw_import_memory *memory)
{
    if (strcmp(nkwi_assimp_extension(memory), ".dae") != 0)
        return 1;
    a->collada = (nkwi_assimp_collada *)nkwi_assimp_scratch(a, "nodes", 1, sizeof *a->collada);
    if (!a->collada)
        return 0;
    nkwi_assimp_collada *c = a->collada;
    c->tags = (const xmlNode **)nkwi_assimp_scratch(a, "nodes", a->node_count, sizeof *c->tags);
    if (!c->tags)
        return 0;
    if (!nkwi_collada_begin(&c->file, &a->scratch, memory->data, memory->bytes))
        return nkwi_fail(a->error, NULL, c->file.xml ? NKW_IMPORT_NO_MEMORY : NKW_IMPORT_INVALID,
                         "Collada: %s, line %d", c->file.fault, c->file.line);
    return find_tags(a) && place_nodes(a) && warn_lost(a);
}

const char *nkwi_assimp_collada_name(const nkwi_assimp *a, size_t node)
{
    const char *name = a->collada && node > 0 ? nkwi_collada_text(a->collada->tags[node], "name") : NULL;
    return name && *name ? name : NULL;
}

void nkwi_assimp_collada_close(nkwi_assimp *a)
{
    if (a->collada)
        nkwi_collada_end(&a->collada->file);
}
