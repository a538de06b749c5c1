/* SPDX-License-Identifier: MIT */
/* Nodes of a scene of Assimp: their order, their names, their transforms. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/transform.h>

#include "assimp.h"
#include "utf8.h"

/* A node, and the index of its parent. */
typedef struct visit {
    const struct aiNode *node;
    int32_t parent;
} visit;

typedef struct visits {
    visit *data;
    size_t count, room;
} visits;

static int push(nkwi_assimp *a, visits *v, const struct aiNode *node, int32_t parent)
{
    if (v->count == v->room) {
        size_t room = v->room ? 2 * v->room : 64;
        visit *wider = room < SIZE_MAX / sizeof *wider ? (visit *)realloc(v->data, room * sizeof *wider) : NULL;
        if (!wider)
            return nkwi_fail(a->error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the nodes");
        v->data = wider;
        v->room = room;
    }
    v->data[v->count].node = node;
    v->data[v->count++].parent = parent;
    return 1;
}

/* The nodes of the tree: a node, then its first child with all below, and so on. The next one to visit is the last. */
static int walk(nkwi_assimp *a, visits *waiting, visits *list)
{
    if (!a->scene->mRootNode)
        return nkwi_fail(a->error, NULL, NKW_IMPORT_INVALID, "the file has no nodes");
    if (!push(a, waiting, a->scene->mRootNode, NKW_NO_JOINT))
        return 0;
    while (waiting->count > 0) {
        const visit v = waiting->data[--waiting->count];
        int32_t index = (int32_t)list->count;
        if (list->count == INT32_MAX)
            return nkwi_fail(a->error, NULL, NKW_IMPORT_TOO_LARGE, "too many nodes");
        if (!push(a, list, v.node, v.parent))
            return 0;
        for (unsigned i = v.node->mNumChildren; i-- > 0;)
            if (v.node->mChildren[i] && !push(a, waiting, v.node->mChildren[i], index))
                return 0;
    }
    return 1;
}

static int compare_names(const void *left, const void *right)
{
    const nkwi_assimp_name_index *a = (const nkwi_assimp_name_index *)left, *b = (const nkwi_assimp_name_index *)right;
    int order = strcmp(a->name, b->name);
    return order != 0 ? order : a->node < b->node ? -1 : a->node > b->node;
}

int32_t nkwi_assimp_find_nth(const nkwi_assimp *a, const char *name, uint32_t *uses)
{
    size_t low = 0, high = a->node_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (strcmp(a->by_name[middle].name, name) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == a->node_count || strcmp(a->by_name[low].name, name) != 0)
        return NKW_NO_JOINT;
    size_t next = low + (uses ? uses[low]++ : 0);
    return next < a->node_count && strcmp(a->by_name[next].name, name) == 0 ? a->by_name[next].node
                                                                            : a->by_name[low].node;
}

int32_t nkwi_assimp_find(const nkwi_assimp *a, const char *name)
{
    return nkwi_assimp_find_nth(a, name, NULL);
}

int32_t nkwi_assimp_joint(const nkwi_assimp *a, int32_t node)
{
    return a->document->all.joint_of_node[(size_t)node];
}

int32_t nkwi_assimp_bone_joint(const nkwi_assimp *a, int32_t node)
{
    return a->document->all.joint_of_node[a->carrier[node]];
}

/* Copies the tree; every transform is finite. */
static int read_nodes(nkwi_assimp *a, const visits *list)
{
    const nkwi_place root = {NULL, NULL, 0}, nodes = {&root, "nodes", 0};
    size_t count = list->count;
    a->node_count = count;
    a->nodes = (const struct aiNode **)nkwi_assimp_scratch(a, "nodes", count, sizeof *a->nodes);
    a->parents = (int32_t *)nkwi_assimp_scratch(a, "nodes", count, sizeof *a->parents);
    a->locals = (nkw_mat4 *)nkwi_assimp_scratch(a, "nodes", count, sizeof *a->locals);
    a->by_name = (nkwi_assimp_name_index *)nkwi_assimp_scratch(a, "nodes", count, sizeof *a->by_name);
    a->rests = (nkw_trs *)nkwi_assimp_scratch(a, "nodes", count, sizeof *a->rests);
    a->carrier = (size_t *)nkwi_assimp_scratch(a, "nodes", count, sizeof *a->carrier);
    a->mesh_carrier = (size_t *)nkwi_assimp_scratch(a, "nodes", count, sizeof *a->mesh_carrier);
    a->is_split = (unsigned char *)nkwi_assimp_scratch(a, "nodes", count, 1);
    if (!a->nodes || !a->parents || !a->locals || !a->by_name || !a->rests || !a->carrier || !a->mesh_carrier ||
        !a->is_split)
        return 0;
    for (size_t i = 0; i < count; i++) {
        const nkwi_assimp_name_index name = {list->data[i].node->mName.data, (int32_t)i};
        const nkwi_place at = {&nodes, NULL, i};
        a->nodes[i] = list->data[i].node;
        a->parents[i] = list->data[i].parent;
        a->locals[i] = nkwi_assimp_matrix(&a->nodes[i]->mTransformation);
        a->by_name[i] = name;
        a->carrier[i] = a->mesh_carrier[i] = i;
        if (!nkwi_assimp_check_node(a, i))
            return 0;
        for (int k = 0; k < 16; k++)
            if (!isfinite(a->locals[i].m[k]))
                return nkwi_fail(a->error, &at, NKW_IMPORT_INVALID, "the matrix of the node is not finite");
    }
    qsort(a->by_name, count, sizeof *a->by_name, compare_names);
    return 1;
}

int nkwi_assimp_tree(nkwi_assimp *a)
{
    visits waiting = {NULL, 0, 0}, list = {NULL, 0, 0};
    int done = walk(a, &waiting, &list) && read_nodes(a, &list);
    free(waiting.data);
    free(list.data);
    return done;
}

/* Whether the matrix is a translation, a rotation and a scale, except for rounding. */
static int is_trs(const nkw_mat4 *matrix, const nkw_trs *trs)
{
    const nkw_mat4 again = nkw_mat4_from_trs(trs);
    for (int c = 0; c < 4; c++) {
        const float *m = matrix->m + 4 * c;
        float size = c < 3 ? fabsf(m[0]) + fabsf(m[1]) + fabsf(m[2]) : 1.0f;
        for (int r = 0; r < 4; r++)
            if (!(fabsf(m[r] - again.m[4 * c + r]) <= 4e-6f * size))
                return 0;
    }
    return 1;
}

/* A matrix that is no TRS is kept. */
static int read_node(nkwi_assimp *a, size_t node, nkw_document_node *out)
{
    const char *name = nkwi_assimp_collada_name(a, node);
    out->name = name ? nkwi_document_name(a->document, a->error, name, "node", node)
                     : nkwi_assimp_name(a, &a->nodes[node]->mName, "node", node);
    out->number = node;
    out->rest = (a->fbx || a->collada) && node > 0 ? a->rests[node] : nkw_trs_from_mat4(&a->locals[node]);
    out->mesh = out->skin = NKW_NO_JOINT;
    if (!out->name || is_trs(&a->locals[node], &out->rest))
        return out->name != NULL;
    nkw_mat4 *matrix = (nkw_mat4 *)nkwi_assimp_take(a, "nodes", 1, sizeof *matrix);
    if (!matrix)
        return 0;
    *matrix = a->locals[node];
    out->matrix = matrix;
    return 1;
}

/* The scene is one root. */
static int read_scene(nkwi_assimp *a)
{
    nkw_document *d = &a->document->all;
    nkw_document_scene *scene = (nkw_document_scene *)nkwi_assimp_take(a, "scenes", 1, sizeof *scene);
    int32_t *root = (int32_t *)nkwi_assimp_take(a, "scenes", 1, sizeof *root);
    if (!scene || !root)
        return 0;
    *root = nkwi_assimp_joint(a, 0);
    scene->name = nkwi_document_name(a->document, a->error, NULL, "scene", 0);
    scene->roots = root;
    scene->root_count = 1;
    d->scenes = scene;
    d->scene_count = 1;
    d->scene = 0;
    return scene->name != NULL;
}

static int read_extra(nkwi_assimp *a, size_t number, nkw_document_node *out)
{
    static const char *const ends[] = {"scale", "geometry"};
    const nkwi_assimp_extra *extra = &a->extras[number - a->node_count];
    char name[sizeof a->nodes[0]->mName.data + 16];
    snprintf(name, sizeof name, "%s_%s", a->nodes[extra->node]->mName.data, ends[extra->kind]);
    nkwi_utf8(name, strlen(name));
    out->name = nkwi_document_name(a->document, a->error, name, "node", number);
    out->number = number;
    out->rest = extra->rest;
    out->mesh = out->skin = NKW_NO_JOINT;
    return out->name != NULL;
}

int nkwi_assimp_nodes(nkwi_assimp *a)
{
    static const nkwi_place root = {NULL, NULL, 0}, place = {&root, "nodes", 0};
    const size_t count = a->node_count + a->extra_count;
    nkw_document_node *list = (nkw_document_node *)nkwi_assimp_scratch(a, "nodes", count, sizeof *list);
    int32_t *parents = (int32_t *)nkwi_assimp_scratch(a, "nodes", count, sizeof *parents);
    if (!list || !parents)
        return 0;
    for (size_t i = 0; i < count; i++) {
        const int32_t parent = i < a->node_count ? a->parents[i] : NKW_NO_JOINT;
        if (i >= a->node_count)
            parents[i] = (int32_t)a->extras[i - a->node_count].parent;
        else
            parents[i] = parent < 0 || nkwi_assimp_fbx_is_apart(a, i) ? parent : (int32_t)a->carrier[parent];
        if (!(i < a->node_count ? read_node(a, i, &list[i]) : read_extra(a, i, &list[i])))
            return 0;
    }
    return nkwi_assimp_instances(a, list) && nkwi_document_nodes(a->document, a->error, &place, list, parents, count) &&
           nkwi_assimp_skins(a) && read_scene(a);
}
