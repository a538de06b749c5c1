/* SPDX-License-Identifier: MIT */
#include "collada.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <libxml/parser.h>

#include "decimal.h"

int nkwi_collada_is(const xmlNode *tag, const char *name)
{
    return tag && tag->type == XML_ELEMENT_NODE && strcmp((const char *)tag->name, name) == 0;
}

static xmlNode *first_of(xmlNode *tag, const char *name)
{
    while (tag && !nkwi_collada_is(tag, name))
        tag = tag->next;
    return tag;
}

xmlNode *nkwi_collada_child(const xmlNode *tag, const char *name)
{
    return tag ? first_of(tag->children, name) : NULL;
}

xmlNode *nkwi_collada_next(const xmlNode *tag, const char *name)
{
    return first_of(tag->next, name);
}

xmlNode *nkwi_collada_walk(const xmlNode *top, const xmlNode *tag)
{
    do {
        if (tag->type == XML_ELEMENT_NODE && tag->children)
            tag = tag->children;
        else {
            while (tag != top && !tag->next)
                tag = tag->parent;
            tag = tag == top ? NULL : tag->next;
        }
    } while (tag && tag->type != XML_ELEMENT_NODE);
    return (xmlNode *)tag; /* a tag of the document, which this reader owns */
}

const char *nkwi_collada_text(const xmlNode *tag, const char *key)
{
    for (const xmlAttr *a = tag ? tag->properties : NULL; a; a = a->next)
        if (strcmp((const char *)a->name, key) == 0)
            return a->children && a->children->content ? (const char *)a->children->content : "";
    return NULL;
}

/* ---- ids ---- */

static int compare_ids(const void *left, const void *right)
{
    const nkwi_collada_id *a = (const nkwi_collada_id *)left, *b = (const nkwi_collada_id *)right;
    const int order = strcmp(a->text, b->text);
    return order != 0 ? order : a->order < b->order ? -1 : a->order > b->order;
}

static int read_ids(nkwi_collada *c, const xmlNode *top)
{
    size_t count = 0;
    for (const xmlNode *t = top; t; t = nkwi_collada_walk(top, t))
        count += nkwi_collada_text(t, "id") != NULL;
    c->ids = (nkwi_collada_id *)nkwi_take(c->memory, count, sizeof *c->ids);
    for (const xmlNode *t = top; c->ids && t; t = nkwi_collada_walk(top, t)) {
        const nkwi_collada_id one = {nkwi_collada_text(t, "id"), (xmlNode *)t, c->id_count};
        if (one.text)
            c->ids[c->id_count++] = one;
    }
    if (c->ids)
        qsort(c->ids, c->id_count, sizeof *c->ids, compare_ids);
    return c->ids != NULL;
}

xmlNode *nkwi_collada_find(const nkwi_collada *c, const char *id)
{
    size_t low = 0, high = c->id_count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (strcmp(c->ids[middle].text, id) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low < c->id_count && strcmp(c->ids[low].text, id) == 0 ? c->ids[low].tag : NULL;
}

xmlNode *nkwi_collada_of_url(const nkwi_collada *c, const char *url)
{
    return url && url[0] == '#' ? nkwi_collada_find(c, url + 1) : NULL;
}

xmlNode *nkwi_collada_input(const nkwi_collada *c, const xmlNode *tag, const char *semantic)
{
    for (xmlNode *t = nkwi_collada_child(tag, "input"); t; t = nkwi_collada_next(t, "input")) {
        const char *name = nkwi_collada_text(t, "semantic");
        if (name && strcmp(name, semantic) == 0)
            return nkwi_collada_of_url(c, nkwi_collada_text(t, "source"));
    }
    return NULL;
}

xmlNode *nkwi_collada_scene(const nkwi_collada *c)
{
    const xmlNode *top = c->xml ? xmlDocGetRootElement(c->xml) : NULL;
    const xmlNode *instance = nkwi_collada_child(nkwi_collada_child(top, "scene"), "instance_visual_scene");
    xmlNode *scene = nkwi_collada_of_url(c, nkwi_collada_text(instance, "url"));
    return nkwi_collada_is(scene, "visual_scene") ? scene : NULL;
}

/* ---- numbers ---- */

size_t nkwi_collada_numbers(const xmlNode *tag, float *out, size_t most)
{
    xmlChar *content = tag ? xmlNodeGetContent(tag) : NULL;
    const char *at = (const char *)content;
    size_t count = 0;
    while (at && *(at += strspn(at, " \t\r\n"))) {
        const size_t length = strcspn(at, " \t\r\n");
        double number;
        if (count < most)
            out[count] = nkwi_decimal(at, length, &number) ? NAN : (float)number;
        count++;
        at += length;
    }
    xmlFree(content);
    return count;
}

/* ---- the document ---- */

/* Entities of the file can grow without end, except within the limits that XML_PARSE_HUGE lifts. */
static int has_entities(const char *data, size_t bytes)
{
    static const char mark[] = "<!ENTITY";
    const char *at = data, *end = data + bytes;
    while ((at = (const char *)memchr(at, '<', (size_t)(end - at))) != NULL) {
        if ((size_t)(end - at) >= sizeof mark - 1 && memcmp(at, mark, sizeof mark - 1) == 0)
            return 1;
        at++;
    }
    return 0;
}

int nkwi_collada_begin(nkwi_collada *c, nkwi_memory *memory, const void *data, size_t bytes)
{
    const int huge = has_entities((const char *)data, bytes) ? 0 : XML_PARSE_HUGE;
    memset(c, 0, sizeof *c);
    c->memory = memory;
    c->fault = "the XML is not read";
    xmlParserCtxt *reader = bytes <= INT_MAX ? xmlNewParserCtxt() : NULL;
    if (!reader)
        return 0;
    c->xml = xmlCtxtReadMemory(reader, (const char *)data, (int)bytes, NULL, NULL,
                               huge | XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_COMPACT);
    c->line = reader->lastError.line;
    xmlFreeParserCtxt(reader);
    const xmlNode *top = c->xml ? xmlDocGetRootElement(c->xml) : NULL;
    if (!top)
        return 0;
    c->fault = "no memory";
    if (!read_ids(c, top) || !nkwi_collada_elements(c) || !nkwi_collada_channels(c))
        return 0;
    c->fault = NULL;
    return 1;
}

void nkwi_collada_end(nkwi_collada *c)
{
    if (c->xml)
        xmlFreeDoc(c->xml);
    c->xml = NULL;
}
