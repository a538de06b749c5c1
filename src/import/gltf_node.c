/* SPDX-License-Identifier: MIT */
/* glTF 2.0, 3.5 and 3.7.3: nodes, skins and scenes. */
#include <nakawari/transform.h>

#include "gltf.h"

/* 3.5.2: a matrix, or a translation, a rotation and a scale. */
static int read_transform(nkwi_gltf *g, const nkwi_value *object, nkw_document_node *node)
{
    const nkw_trs identity = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 1.0f}};
    nkwi_value at = nkwi_member(object, "matrix");
    node->rest = identity;
    if (!at.json)
        return nkwi_floats(g->error, object, "translation", &node->rest.translation.x, 3) &&
               nkwi_floats(g->error, object, "rotation", &node->rest.rotation.x, 4) &&
               nkwi_floats(g->error, object, "scale", &node->rest.scale.x, 3);
    nkw_mat4 *matrix = (nkw_mat4 *)nkwi_gltf_take(g, &at, 1, sizeof *matrix);
    if (!matrix || !nkwi_floats(g->error, object, "matrix", matrix->m, 16))
        return 0;
    node->rest = nkw_trs_from_mat4(matrix);
    node->matrix = matrix;
    return 1;
}

static int read_children(nkwi_gltf *g, const nkwi_value *object, int32_t *parents)
{
    nkwi_value children = nkwi_member(object, "children");
    if (!nkwi_is_array(g->error, &children))
        return 0;
    for (size_t i = 0; i < nkwi_length(&children); i++) {
        nkwi_value element = nkwi_element(&children, i);
        int32_t child;
        if (!nkwi_index_at(g->error, &element, "node", g->node_count, &child))
            return 0;
        if (parents[child] != NKW_NO_JOINT)
            return nkwi_fail(g->error, &element.place, NKW_IMPORT_INVALID, "node %d is a child of node %d already",
                             (int)child, (int)parents[child]);
        parents[child] = (int32_t)object->place.index;
    }
    return 1;
}

/* The morph weights of a node are its own; otherwise those of its mesh. */
static int read_node(nkwi_gltf *g, const nkwi_value *object, nkw_document_node *node, int32_t *parents)
{
    if (!nkwi_is_object(g->error, object))
        return 0;
    nkwi_value extensions = nkwi_member(object, "extensions");
    node->name = nkwi_gltf_name(g, object, "node");
    node->number = object->place.index;
    node->is_view = nkwi_member(object, "camera").json || nkwi_member(&extensions, "KHR_lights_punctual").json;
    return node->name && read_transform(g, object, node) && read_children(g, object, parents) &&
           nkwi_index(g->error, object, "mesh", "mesh", g->mesh_count, &node->mesh) &&
           nkwi_index(g->error, object, "skin", "skin", g->skin_count, &node->skin);
}

/* After the nodes are sorted. */
static int read_weights(nkwi_gltf *g, const nkwi_value *list)
{
    const nkwi_document *document = g->document;
    for (size_t j = 0; j < document->all.skeleton.joint_count; j++) {
        const nkw_document_node *node = &document->nodes[j];
        nkwi_value object = nkwi_element(list, node->number);
        if (node->float_count > 0 &&
            !nkwi_floats(g->error, &object, "weights", document->rest_floats + node->float_first, node->float_count))
            return 0;
    }
    return 1;
}

int nkwi_gltf_nodes(nkwi_gltf *g)
{
    nkwi_value list;
    size_t count;
    if (!nkwi_gltf_list(g, "nodes", &list, &count))
        return 0;
    if (count > INT32_MAX)
        return nkwi_fail(g->error, &list.place, NKW_IMPORT_TOO_LARGE, "%zu nodes are too many", count);
    nkw_document_node *nodes = (nkw_document_node *)nkwi_gltf_scratch(g, &list, count, sizeof *nodes);
    int32_t *parents = (int32_t *)nkwi_gltf_scratch(g, &list, count, sizeof *parents);
    if (!nodes || !parents)
        return 0;
    for (size_t i = 0; i < count; i++)
        parents[i] = NKW_NO_JOINT;
    for (size_t i = 0; i < count; i++) {
        nkwi_value object = nkwi_element(&list, i);
        if (!read_node(g, &object, &nodes[i], parents))
            return 0;
    }
    return nkwi_document_nodes(g->document, g->error, &list.place, nodes, parents, count) && read_weights(g, &list);
}

/* Nodes of the file as joints. */
static const int32_t *read_joints(nkwi_gltf *g, const nkwi_value *list)
{
    size_t count = nkwi_length(list);
    int32_t *joints = (int32_t *)nkwi_gltf_take(g, list, count, sizeof *joints);
    for (size_t i = 0; joints && i < count; i++) {
        nkwi_value element = nkwi_element(list, i);
        int32_t node;
        if (!nkwi_index_at(g->error, &element, "node", g->node_count, &node))
            return NULL;
        joints[i] = g->document->all.joint_of_node[node];
    }
    return joints;
}

static int read_skin(nkwi_gltf *g, const nkwi_value *object, void *element)
{
    nkw_document_skin *skin = (nkw_document_skin *)element;
    nkwi_value joints = nkwi_member(object, "joints"), matrices = nkwi_member(object, "inverseBindMatrices");
    const float *floats;
    size_t count;
    if (!nkwi_is_object(g->error, object) || !nkwi_is_array(g->error, &joints))
        return 0;
    skin->name = nkwi_gltf_name(g, object, "skin");
    skin->joint_count = nkwi_length(&joints);
    if (skin->joint_count == 0)
        return nkwi_fail(g->error, &joints.place, NKW_IMPORT_INVALID, "the skin has no joints");
    skin->joints = read_joints(g, &joints);
    if (!skin->name || !skin->joints)
        return 0;
    if (!matrices.json)
        return 1;
    if (!nkwi_gltf_floats(g, object, "inverseBindMatrices", 16, NKWI_NORMALIZED, &floats, &count))
        return 0;
    if (count < skin->joint_count)
        return nkwi_fail(g->error, &matrices.place, NKW_IMPORT_INVALID, "%zu matrices for %zu joints", count,
                         skin->joint_count);
    skin->inverse_bind = (const nkw_mat4 *)(const void *)floats;
    return 1;
}

int nkwi_gltf_skins(nkwi_gltf *g)
{
    nkw_document *document = &g->document->all;
    document->skins =
        (nkw_document_skin *)nkwi_gltf_each(g, "skins", sizeof *document->skins, read_skin, &document->skin_count);
    return document->skins != NULL;
}

static int read_scene(nkwi_gltf *g, const nkwi_value *object, void *element)
{
    nkw_document_scene *scene = (nkw_document_scene *)element;
    nkwi_value roots = nkwi_member(object, "nodes");
    if (!nkwi_is_object(g->error, object) || !nkwi_is_array(g->error, &roots))
        return 0;
    scene->name = nkwi_gltf_name(g, object, "scene");
    scene->root_count = nkwi_length(&roots);
    scene->roots = read_joints(g, &roots);
    return scene->name && scene->roots;
}

int nkwi_gltf_scenes(nkwi_gltf *g)
{
    nkw_document *document = &g->document->all;
    document->scenes =
        (nkw_document_scene *)nkwi_gltf_each(g, "scenes", sizeof *document->scenes, read_scene, &document->scene_count);
    return document->scenes &&
           nkwi_index(g->error, &g->root, "scene", "scene", document->scene_count, &document->scene);
}
