/* SPDX-License-Identifier: MIT */
/* The channels of a Collada file: what a target names, and the curve for it. */
#include <string.h>

#include "collada.h"

enum { PART_MOST = 1024 };

/* ---- targets ---- */

/* The tag of a target: the id of the first part, then the first tag below with the sid of each other part. */
static xmlNode *find_sid(const xmlNode *top, const char *sid)
{
    for (xmlNode *t = nkwi_collada_walk(top, top); t; t = nkwi_collada_walk(top, t)) {
        const char *own = nkwi_collada_text(t, "sid");
        if (own && strcmp(own, sid) == 0)
            return t;
    }
    return NULL;
}

/* A node without an id is known by its sid. */
static xmlNode *find_first(const nkwi_collada *c, const char *name)
{
    xmlNode *found = nkwi_collada_find(c, name), *scene = nkwi_collada_scene(c);
    return found || !scene ? found : find_sid(scene, name);
}

static xmlNode *find_target(const nkwi_collada *c, const char *target, size_t length)
{
    char part[PART_MOST];
    xmlNode *tag = NULL;
    for (size_t at = 0; at < length; at++) {
        size_t end = at;
        while (end < length && target[end] != '/')
            end++;
        if (end - at >= sizeof part)
            return NULL;
        memcpy(part, target + at, end - at);
        part[end - at] = 0;
        tag = at == 0 ? find_first(c, part) : tag ? find_sid(tag, part) : NULL;
        at = end;
    }
    return tag;
}

/* (i) and (i)(j): a number, or a column and a row of a matrix. */
static int read_indices(const char *text, size_t *first)
{
    size_t numbers[2] = {0, 0}, count = 0;
    while (*text == '(' && count < 2) {
        for (text++; *text >= '0' && *text <= '9' && numbers[count] < 10000; text++)
            numbers[count] = 10 * numbers[count] + (size_t)(*text - '0');
        if (*text++ != ')')
            return 0;
        count++;
    }
    *first = count == 2 ? 4 * numbers[1] + numbers[0] : numbers[0];
    return count > 0 && !*text && (count == 1 || (numbers[0] < 4 && numbers[1] < 4));
}

/* What follows the tag in a target: a member or an index. 0 if it is none; *is_whole where there is nothing. */
static int read_member(const char *text, size_t *first, int *is_whole)
{
    static const char *const names[] = {".X", ".Y", ".Z", ".ANGLE"};
    *first = 0;
    *is_whole = !*text;
    for (size_t i = 0; i < 4; i++)
        if (strcmp(text, names[i]) == 0) {
            *first = i;
            return 1;
        }
    return *is_whole || read_indices(text, first);
}

/* A member begins at the last point behind the last slash, an index at the first bracket there. */
static size_t length_of_path(const char *target)
{
    const char *slash = strrchr(target, '/'), *last = slash ? slash : target, *point = strrchr(last, '.');
    const char *bracket = strchr(last, '(');
    const char *end = bracket ? bracket : slash && point ? point : target + strlen(target);
    return (size_t)(end - target);
}

/* ---- channels ---- */

/* The curve of the sampler of a channel, read once: its tag points to it. */
static const nkwi_collada_curve *curve_of(nkwi_collada *c, nkwi_collada_channel *out)
{
    xmlNode *sampler = nkwi_collada_of_url(c, nkwi_collada_text(out->tag, "source"));
    out->reason = "its sampler is not there";
    if (!nkwi_collada_is(sampler, "sampler"))
        return NULL;
    if (!sampler->_private)
        sampler->_private = (void *)nkwi_collada_curve_read(c, sampler, &out->reason);
    else
        out->reason = NULL;
    return (const nkwi_collada_curve *)sampler->_private;
}

/* Finds the element of a tag. */
static size_t element_of(const nkwi_collada *c, const xmlNode *tag)
{
    size_t count = 0, i = 0;
    if (!nkwi_collada_is(tag->parent, "node"))
        return NKWI_COLLADA_NONE;
    const nkwi_collada_element *list = nkwi_collada_elements_of(c, tag->parent, &count);
    while (i < count && list[i].tag != tag)
        i++;
    return i < count ? (size_t)(list + i - c->elements) : NKWI_COLLADA_NONE;
}

static int has_infinity(const xmlNode *sampler)
{
    for (const xmlNode *t = nkwi_collada_walk(sampler, sampler); t; t = nkwi_collada_walk(sampler, t)) {
        const int is = nkwi_collada_is(t, "pre_infinity") || nkwi_collada_is(t, "post_infinity");
        if (is && t->children && t->children->content && strcmp((const char *)t->children->content, "CONSTANT") != 0)
            return 1;
    }
    return 0;
}

/* Returns 0 without memory. */
static int read_channel(nkwi_collada *c, nkwi_collada_channel *out)
{
    const char *target = nkwi_collada_text(out->tag, "target");
    int is_whole = 0;
    target = target ? target : "";
    const size_t length = length_of_path(target);
    const xmlNode *tag = find_target(c, target, length);
    out->element = out->next = NKWI_COLLADA_NONE;
    out->reason = "its target is not in the file";
    if (!tag)
        return 1;
    out->element = element_of(c, tag);
    out->reason = "no part of a document";
    if (out->element == NKWI_COLLADA_NONE)
        return 1;
    out->reason = "no member of its target";
    if (!read_member(target + length, &out->first, &is_whole))
        return 1;
    const nkwi_collada_curve *curve = curve_of(c, out);
    if (!curve)
        return out->reason != NULL;
    const size_t width = nkwi_collada_width(c->elements[out->element].kind);
    out->reason = "its keys have more numbers than its target";
    if (curve->width > width || out->first > width - curve->width || (!is_whole && curve->width > 1))
        return 1;
    out->reason = "the skew of a node";
    if (c->elements[out->element].kind != NKWI_COLLADA_SKEW)
        out->curve = curve;
    c->infinities += out->curve && has_infinity(nkwi_collada_of_url(c, nkwi_collada_text(out->tag, "source")));
    return 1;
}

static int is_channel(const xmlNode *tag)
{
    return nkwi_collada_is(tag, "channel") && nkwi_collada_is(tag->parent, "animation");
}

int nkwi_collada_channels(nkwi_collada *c)
{
    const xmlNode *top = xmlDocGetRootElement(c->xml);
    size_t count = 0;
    for (const xmlNode *t = top; t; t = nkwi_collada_walk(top, t))
        count += (size_t)is_channel(t);
    c->channels = (nkwi_collada_channel *)nkwi_take(c->memory, count, sizeof *c->channels);
    for (xmlNode *t = (xmlNode *)top; c->channels && t; t = nkwi_collada_walk(top, t)) {
        nkwi_collada_channel *one = &c->channels[c->channel_count];
        c->morphs += (size_t)nkwi_collada_is(t, "morph");
        if (!is_channel(t))
            continue;
        one->number = c->channel_count++;
        one->tag = t;
        if (!read_channel(c, one))
            return 0;
    }
    return c->channels != NULL;
}
