/* SPDX-License-Identifier: MIT */
#include "fbx_tree.h"

#include <stdlib.h>
#include <string.h>

int nkwi_fbx_fail(nkwi_fbx_tree *tree, size_t at, const char *fault)
{
    if (!tree->fault) {
        tree->fault = fault;
        tree->at = at;
    }
    return 0;
}

/* The array with room for one element more; NULL without memory. */
static void *widen(void *list, size_t count, size_t *room, size_t size)
{
    if (count < *room)
        return list;
    const size_t more = *room ? 2 * *room : 256;
    void *wider = more < SIZE_MAX / size ? realloc(list, more * size) : NULL;
    *room = wider ? more : *room;
    return wider;
}

int nkwi_fbx_add_node(nkwi_fbx_tree *tree, const char *name, size_t length)
{
    const nkwi_fbx_node node = {name, length, tree->value_count, 0, NKWI_FBX_NONE, NKWI_FBX_NONE};
    nkwi_fbx_node *wider = (nkwi_fbx_node *)widen(tree->nodes, tree->node_count, &tree->node_room, sizeof *wider);
    const size_t index = tree->node_count, before = tree->last[tree->depth];
    if (!wider)
        return nkwi_fbx_fail(tree, 0, "no memory for the nodes");
    tree->nodes = wider;
    tree->nodes[tree->node_count++] = node;
    if (before != NKWI_FBX_NONE)
        tree->nodes[before].next = index;
    else if (tree->depth > 0)
        tree->nodes[tree->last[tree->depth - 1]].child = index;
    else
        tree->root = index;
    tree->last[tree->depth] = index;
    return 1;
}

int nkwi_fbx_add_value(nkwi_fbx_tree *tree, const nkwi_fbx_value *value)
{
    nkwi_fbx_value *wider = (nkwi_fbx_value *)widen(tree->values, tree->value_count, &tree->value_room, sizeof *wider);
    if (!wider)
        return nkwi_fbx_fail(tree, 0, "no memory for the values");
    tree->values = wider;
    tree->values[tree->value_count++] = *value;
    tree->nodes[tree->node_count - 1].value_count++;
    return 1;
}

int nkwi_fbx_open(nkwi_fbx_tree *tree, const void *data, size_t bytes)
{
    static const char mark[] = "Kaydara FBX Binary  ";
    memset(tree, 0, sizeof *tree);
    tree->root = tree->last[0] = NKWI_FBX_NONE;
    const int is_binary = bytes >= 27 && memcmp(data, mark, sizeof mark) == 0;
    const int done = is_binary ? nkwi_fbx_read_binary(tree, (const unsigned char *)data, bytes)
                               : nkwi_fbx_read_text(tree, (const char *)data, bytes);
    if (done && (tree->version < 7100 || tree->version > 7799))
        return nkwi_fbx_fail(tree, 0, "FBX versions 7100 to 7700 are read, and this file is of another");
    return done;
}

void nkwi_fbx_close(nkwi_fbx_tree *tree)
{
    free(tree->nodes);
    free(tree->values);
    tree->nodes = NULL;
    tree->values = NULL;
}

int nkwi_fbx_is(const nkwi_fbx_tree *tree, size_t node, const char *name)
{
    const nkwi_fbx_node *n = &tree->nodes[node];
    return n->name_length == strlen(name) && memcmp(n->name, name, n->name_length) == 0;
}

size_t nkwi_fbx_find(const nkwi_fbx_tree *tree, size_t node, const char *name)
{
    while (node != NKWI_FBX_NONE && !nkwi_fbx_is(tree, node, name))
        node = tree->nodes[node].next;
    return node;
}

size_t nkwi_fbx_below(const nkwi_fbx_tree *tree, size_t node, const char *name)
{
    return node == NKWI_FBX_NONE ? node : nkwi_fbx_find(tree, tree->nodes[node].child, name);
}

const nkwi_fbx_value *nkwi_fbx_at(const nkwi_fbx_tree *tree, size_t node, size_t value)
{
    if (node == NKWI_FBX_NONE || value >= tree->nodes[node].value_count)
        return NULL;
    return &tree->values[tree->nodes[node].first + value];
}

int nkwi_fbx_equals(const nkwi_fbx_value *value, const char *text)
{
    return value && value->kind == 'S' && value->bytes == strlen(text) && memcmp(value->text, text, value->bytes) == 0;
}

/* Numbers that are values of their own, as in text without a count. */
static double *plain_numbers(nkwi_fbx_tree *tree, size_t node, nkwi_memory *memory, size_t *count)
{
    const nkwi_fbx_node *n = &tree->nodes[node];
    double *out = (double *)nkwi_take(memory, n->value_count, sizeof *out);
    if (!out)
        nkwi_fbx_fail(tree, 0, "no memory for the numbers");
    for (size_t i = 0; out && i < n->value_count; i++)
        out[i] = tree->values[n->first + i].kind == 'S' ? 0.0 : tree->values[n->first + i].real;
    *count = out ? n->value_count : 0;
    return out;
}

double *nkwi_fbx_numbers(nkwi_fbx_tree *tree, size_t node, nkwi_memory *memory, size_t *count)
{
    const nkwi_fbx_value *value = nkwi_fbx_at(tree, node, 0);
    *count = 0;
    if (!value)
        return NULL;
    if (value->kind != 'A')
        return plain_numbers(tree, node, memory, count);
    const size_t most = value->element == 't' ? nkwi_fbx_scan(value, NULL, 0) : (size_t)value->integer;
    double *out = (double *)nkwi_take(memory, most, sizeof *out);
    if (!out) {
        nkwi_fbx_fail(tree, 0, "no memory for the numbers of an array");
        return NULL;
    }
    if (value->element == 't')
        nkwi_fbx_scan(value, out, most);
    else if (!nkwi_fbx_unpack(tree, value, memory, out))
        return NULL;
    *count = most;
    return out;
}
