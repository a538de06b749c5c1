/* SPDX-License-Identifier: MIT */
/* Objects, connections and properties of an FBX file. */
#include "fbx.h"

#include <stdlib.h>
#include <string.h>

static size_t count_children(const nkwi_fbx_tree *tree, size_t node)
{
    size_t count = 0;
    for (size_t n = node == NKWI_FBX_NONE ? node : tree->nodes[node].child; n != NKWI_FBX_NONE; n = tree->nodes[n].next)
        count++;
    return count;
}

static int compare_objects(const void *left, const void *right)
{
    const nkwi_fbx_object *a = (const nkwi_fbx_object *)left, *b = (const nkwi_fbx_object *)right;
    return a->id != b->id ? (a->id < b->id ? -1 : 1) : a->node < b->node ? -1 : a->node > b->node;
}

static int compare_links(const void *left, const void *right)
{
    const nkwi_fbx_link *a = (const nkwi_fbx_link *)left, *b = (const nkwi_fbx_link *)right;
    return a->to != b->to ? (a->to < b->to ? -1 : 1) : a->order < b->order ? -1 : a->order > b->order;
}

/* The first object of an id; NKWI_FBX_NONE. */
static size_t find_object(const nkwi_fbx *fbx, int64_t id)
{
    size_t low = 0, high = fbx->object_count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (fbx->objects[middle].id < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low < fbx->object_count && fbx->objects[low].id == id ? low : NKWI_FBX_NONE;
}

/* The list of the properties that objects of a kind have: Definitions, ObjectType, PropertyTemplate, Properties70. */
static size_t definition_of(const nkwi_fbx_tree *tree, size_t definitions, size_t node)
{
    for (size_t n = nkwi_fbx_below(tree, definitions, "ObjectType"); n != NKWI_FBX_NONE;
         n = nkwi_fbx_find(tree, tree->nodes[n].next, "ObjectType")) {
        const nkwi_fbx_value *kind = nkwi_fbx_at(tree, n, 0);
        if (kind && kind->kind == 'S' && kind->bytes == tree->nodes[node].name_length &&
            memcmp(kind->text, tree->nodes[node].name, kind->bytes) == 0)
            return nkwi_fbx_below(tree, nkwi_fbx_below(tree, n, "PropertyTemplate"), "Properties70");
    }
    return NKWI_FBX_NONE;
}

static int read_objects(nkwi_fbx *fbx)
{
    const nkwi_fbx_tree *tree = &fbx->tree;
    const size_t list = nkwi_fbx_find(tree, tree->root, "Objects");
    const size_t definitions = nkwi_fbx_find(tree, tree->root, "Definitions");
    const nkwi_fbx_object root = {0, NKWI_FBX_NONE, NKWI_FBX_NONE, 0, 0};
    fbx->objects = (nkwi_fbx_object *)nkwi_take(fbx->memory, count_children(tree, list) + 1, sizeof *fbx->objects);
    if (!fbx->objects)
        return nkwi_fbx_fail(&fbx->tree, 0, "no memory for the objects");
    fbx->objects[fbx->object_count++] = root;
    for (size_t n = list == NKWI_FBX_NONE ? list : tree->nodes[list].child; n != NKWI_FBX_NONE;
         n = tree->nodes[n].next) {
        const nkwi_fbx_value *id = nkwi_fbx_at(tree, n, 0);
        const nkwi_fbx_object object = {id ? id->integer : 0, n, definition_of(tree, definitions, n), 0, 0};
        if (id && id->kind == 'I' && id->integer != 0)
            fbx->objects[fbx->object_count++] = object;
    }
    qsort(fbx->objects, fbx->object_count, sizeof *fbx->objects, compare_objects);
    fbx->root = find_object(fbx, 0);
    return 1;
}

static int read_links(nkwi_fbx *fbx)
{
    const nkwi_fbx_tree *tree = &fbx->tree;
    const size_t list = nkwi_fbx_find(tree, tree->root, "Connections");
    fbx->links = (nkwi_fbx_link *)nkwi_take(fbx->memory, count_children(tree, list), sizeof *fbx->links);
    if (!fbx->links)
        return nkwi_fbx_fail(&fbx->tree, 0, "no memory for the connections");
    for (size_t n = list == NKWI_FBX_NONE ? list : tree->nodes[list].child; n != NKWI_FBX_NONE;
         n = tree->nodes[n].next) {
        const nkwi_fbx_value *kind = nkwi_fbx_at(tree, n, 0), *from = nkwi_fbx_at(tree, n, 1);
        const nkwi_fbx_value *to = nkwi_fbx_at(tree, n, 2), *property = nkwi_fbx_at(tree, n, 3);
        const int to_property = nkwi_fbx_equals(kind, "OP");
        if (!from || !to || from->kind != 'I' || to->kind != 'I' || (to_property && !property) ||
            !(to_property || nkwi_fbx_equals(kind, "OO")))
            continue;
        const nkwi_fbx_link link = {find_object(fbx, from->integer), find_object(fbx, to->integer), n,
                                    to_property ? property : NULL};
        if (link.from != NKWI_FBX_NONE && link.to != NKWI_FBX_NONE)
            fbx->links[fbx->link_count++] = link;
    }
    qsort(fbx->links, fbx->link_count, sizeof *fbx->links, compare_links);
    for (size_t i = fbx->link_count; i-- > 0;) {
        nkwi_fbx_object *object = &fbx->objects[fbx->links[i].to];
        object->first_link = i;
        object->link_count++;
    }
    return 1;
}

/* From version 1004 of the header on, a TCDefinition that is not 127 is that of FBX 8. */
static double ticks_of(const nkwi_fbx_tree *tree)
{
    const size_t header = nkwi_fbx_find(tree, tree->root, "FBXHeaderExtension");
    const nkwi_fbx_value *version = nkwi_fbx_at(tree, nkwi_fbx_below(tree, header, "FBXHeaderVersion"), 0);
    const nkwi_fbx_value *definition =
        nkwi_fbx_at(tree, nkwi_fbx_below(tree, nkwi_fbx_below(tree, header, "OtherFlags"), "TCDefinition"), 0);
    return version && definition && version->integer >= 1004 && definition->integer != 127 ? 141120000.0
                                                                                           : 46186158000.0;
}

int nkwi_fbx_begin(nkwi_fbx *fbx, nkwi_memory *memory, const void *data, size_t bytes)
{
    memset(fbx, 0, sizeof *fbx);
    fbx->memory = memory;
    if (!nkwi_fbx_open(&fbx->tree, data, bytes))
        return 0;
    fbx->settings = nkwi_fbx_find(&fbx->tree, fbx->tree.root, "GlobalSettings");
    fbx->ticks = ticks_of(&fbx->tree);
    return read_objects(fbx) && read_links(fbx);
}

void nkwi_fbx_end(nkwi_fbx *fbx)
{
    nkwi_fbx_close(&fbx->tree);
}

int nkwi_fbx_is_kind(const nkwi_fbx *fbx, size_t object, const char *kind)
{
    const size_t node = fbx->objects[object].node;
    return node != NKWI_FBX_NONE && nkwi_fbx_is(&fbx->tree, node, kind);
}

/* Text has KIND::NAME, binary files have NAME, the bytes 0 and 1, KIND. */
void nkwi_fbx_name(const nkwi_fbx *fbx, size_t object, char *name, size_t room)
{
    const nkwi_fbx_value *value = nkwi_fbx_at(&fbx->tree, fbx->objects[object].node, 1);
    size_t first = 0, end = value && value->kind == 'S' ? value->bytes : 0;
    for (size_t i = 0; i + 1 < end; i++) {
        if (value->text[i] == 0 && value->text[i + 1] == 1)
            end = i;
        else if (fbx->tree.is_text && first == 0 && value->text[i] == ':' && value->text[i + 1] == ':')
            first = i + 2;
    }
    const size_t length = end - first < room ? end - first : room - 1;
    if (length > 0)
        memcpy(name, value->text + first, length);
    name[length] = 0;
}

size_t nkwi_fbx_listed(const nkwi_fbx *fbx, size_t list, const char *name)
{
    const nkwi_fbx_tree *tree = &fbx->tree;
    size_t last = NKWI_FBX_NONE;
    for (size_t n = nkwi_fbx_below(tree, list, "P"); n != NKWI_FBX_NONE;
         n = nkwi_fbx_find(tree, tree->nodes[n].next, "P"))
        if (nkwi_fbx_equals(nkwi_fbx_at(tree, n, 0), name))
            last = n;
    return last;
}

size_t nkwi_fbx_property(const nkwi_fbx *fbx, size_t object, const char *name)
{
    const nkwi_fbx_object *o = &fbx->objects[object];
    const size_t own = nkwi_fbx_listed(fbx, nkwi_fbx_below(&fbx->tree, o->node, "Properties70"), name);
    return own != NKWI_FBX_NONE ? own : nkwi_fbx_listed(fbx, o->definition, name);
}

static double number_of(const nkwi_fbx *fbx, size_t property, size_t index, double other)
{
    const nkwi_fbx_value *value = nkwi_fbx_at(&fbx->tree, property, 4 + index);
    const int is_number = value && (value->kind == 'I' || value->kind == 'R');
    return is_number && value->real > -3e38 && value->real < 3e38 ? value->real : other;
}

double nkwi_fbx_listed_number(const nkwi_fbx *fbx, size_t list, const char *name, double other)
{
    return number_of(fbx, nkwi_fbx_listed(fbx, list, name), 0, other);
}

double nkwi_fbx_number(const nkwi_fbx *fbx, size_t object, const char *name, double other)
{
    return number_of(fbx, nkwi_fbx_property(fbx, object, name), 0, other);
}

nkw_vec3 nkwi_fbx_vector(const nkwi_fbx *fbx, size_t object, const char *name, nkw_vec3 other)
{
    const size_t property = nkwi_fbx_property(fbx, object, name);
    const nkw_vec3 out = {(float)number_of(fbx, property, 0, (double)other.x),
                          (float)number_of(fbx, property, 1, (double)other.y),
                          (float)number_of(fbx, property, 2, (double)other.z)};
    return out;
}
