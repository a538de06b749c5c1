/* SPDX-License-Identifier: MIT */
/*
 * The views of a file that is rewritten (rewrite.h): those that nothing names are dropped, the others renumbered.
 *
 * Invariant: every index of a view is a member bufferView of an object, also in extensions that are not known here, so
 * one walk of the tree finds all. In extras a member of this name means what it likes: they stay as they are.
 *
 *     views        0    1    2    3    4         1 and 2 had only old keys
 *     used         1    0    0    1    1
 *     to           0    -    -    1    2         the new index
 */
#include <string.h>

#include "rewrite.h"

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
    if (nkwi_rewriter_index(value, "bufferView") != SIZE_MAX)
        at(user, value, nkwi_rewriter_index(value, "bufferView"));
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
static void renumber_all(nkwi_rewriter *r, view_map *map)
{
    json_t *list = r->sink.accessors;
    for (size_t i = 0; i < json_array_size(list); i++) {
        json_t *copy = json_deep_copy(json_array_get(list, i));
        r->sink.failed = r->sink.failed || json_array_set_new(list, i, copy) != 0;
    }
    each_view(r->root, renumber, map);
}

/* Drops the views that nothing refers to. */
int nkwi_rewriter_views(nkwi_rewriter *r)
{
    const size_t count = json_array_size(r->sink.views);
    view_map map = {(size_t *)nkwi_take(&r->sink.scratch, count, sizeof(size_t)), count, &r->sink};
    json_t *list = json_array();
    if (!map.to || !list)
        return nkwi_rewriter_no_memory(r);
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
    return !r->sink.failed || nkwi_rewriter_no_memory(r);
}
