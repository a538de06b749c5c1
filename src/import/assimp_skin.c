/* SPDX-License-Identifier: MIT */
/* From the meshes of a scene of Assimp, which have bones each, to meshes and skins of nodes. */
#include <string.h>

#include "assimp.h"

/* The skin of a node's meshes while it is made. */
typedef struct builder {
    nkwi_assimp *a;
    size_t node; /* of the tree, which has the meshes */
    int32_t *first; /* of each node its first entry, or NKW_NO_JOINT */
    nkwi_assimp_bone *entries;
    size_t count, room;
    uint16_t *entry_of_bone; /* of the mesh that is read */
} builder;

/* The entry of a node and a matrix: a skin may have a node twice. -1 if there are too many. */
static int32_t entry_of(builder *b, int32_t node, const nkw_mat4 *matrix)
{
    const nkwi_assimp_bone entry = {node, b->first[node], *matrix};
    for (int32_t i = b->first[node]; i != NKW_NO_JOINT; i = b->entries[i].next)
        if (memcmp(&b->entries[i].inverse_bind, matrix, sizeof *matrix) == 0)
            return i;
    if (b->count == b->room)
        return NKW_NO_JOINT;
    b->first[node] = (int32_t)b->count;
    b->entries[b->count] = entry;
    return (int32_t)b->count++;
}

static int find_bones(builder *b, size_t mesh)
{
    const nkwi_place root = {NULL, NULL, 0}, list = {&root, "meshes", 0}, at = {&list, NULL, mesh};
    const nkwi_place bones = {&at, "bones", 0};
    const struct aiMesh *m = b->a->scene->mMeshes[mesh];
    for (size_t i = 0; i < m->mNumBones; i++) {
        const nkwi_place bone = {&bones, NULL, i};
        nkw_mat4 matrix = nkwi_assimp_matrix(&m->mBones[i]->mOffsetMatrix);
        int32_t node = nkwi_assimp_find(b->a, m->mBones[i]->mName.data);
        if (node == NKW_NO_JOINT)
            return nkwi_fail(b->a->error, &bone, NKW_IMPORT_INVALID, "there is no node with the name of the bone");
        if (b->a->fbx && !nkwi_assimp_fbx_bind(b->a, b->node, (size_t)node, &matrix))
            return 0;
        int32_t entry = entry_of(b, node, &matrix);
        if (entry == NKW_NO_JOINT || entry > UINT16_MAX)
            return nkwi_fail(b->a->error, &bone, NKW_IMPORT_TOO_LARGE, "the skin has more than 65536 joints");
        b->entry_of_bone[i] = (uint16_t)entry;
    }
    return 1;
}

/* A vertex without weights moves with the node of the mesh: an entry with the identity. */
static int hold_vertices(builder *b, uint16_t *joints, float *weights, size_t vertex_count, size_t width)
{
    nkw_mat4 own = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
    if (b->a->fbx)
        nkwi_assimp_fbx_geometry(b->a, b->node, &own);
    for (size_t v = 0; v < vertex_count; v++) {
        float most = 0.0f;
        for (size_t i = 0; i < width; i++)
            most = weights[v * width + i] > most ? weights[v * width + i] : most;
        if (most > 0.0f)
            continue;
        int32_t entry = entry_of(b, (int32_t)b->node, &own);
        if (entry == NKW_NO_JOINT || entry > UINT16_MAX)
            return nkwi_fail(b->a->error, NULL, NKW_IMPORT_TOO_LARGE, "the skin has more than 65536 joints");
        joints[v * width] = (uint16_t)entry;
        weights[v * width] = 1.0f;
    }
    return 1;
}

/* The influences of a mesh with joints of the skin; and the largest of them, of sum 1. */
static int bind(builder *b, size_t mesh, nkw_document_primitive *out)
{
    size_t n = out->vertex_count, width = out->influence_count, keep = width > 4 ? NKW_SKIN_INFLUENCES : 4;
    if (width == 0)
        return 1;
    uint16_t *joints = (uint16_t *)nkwi_assimp_take(b->a, "meshes", n, width * sizeof *joints);
    float *weights = (float *)nkwi_assimp_take(b->a, "meshes", n, width * sizeof *weights);
    uint16_t *kept_joints = (uint16_t *)nkwi_assimp_take(b->a, "meshes", n, keep * sizeof *kept_joints);
    float *kept_weights = (float *)nkwi_assimp_take(b->a, "meshes", n, keep * sizeof *kept_weights);
    if (!joints || !weights || !kept_joints || !kept_weights || !find_bones(b, mesh))
        return 0;
    memcpy(weights, out->weights, n * width * sizeof *weights);
    for (size_t i = 0; i < n * width; i++)
        joints[i] = weights[i] != 0.0f ? b->entry_of_bone[out->joints[i]] : 0;
    if (!hold_vertices(b, joints, weights, n, width))
        return 0;
    const nkw_skin all = {n, width, {joints, 0, NKW_SKIN_U16}, {weights, 0, NKW_SKIN_F32}};
    const nkw_skin_span to_joints = {kept_joints, 0, NKW_SKIN_U16}, to_weights = {kept_weights, 0, NKW_SKIN_F32};
    const nkw_skin skin = {n, keep, {kept_joints, 0, NKW_SKIN_U16}, {kept_weights, 0, NKW_SKIN_F32}};
    nkw_skin_prune(&all, keep, to_joints, to_weights);
    out->joints = joints;
    out->weights = weights;
    out->skin = skin;
    return 1;
}

/* Every primitive of a mesh has the same number of targets: missing ones have no differences. */
static int level_targets(nkwi_assimp *a, nkw_document_primitive *p, size_t count)
{
    if (p->target_count == count)
        return 1;
    nkw_document_target *targets = (nkw_document_target *)nkwi_assimp_take(a, "meshes", count, sizeof *targets);
    if (!targets)
        return 0;
    if (p->target_count > 0)
        memcpy(targets, p->targets, p->target_count * sizeof *targets);
    p->targets = targets;
    p->target_count = count;
    return 1;
}

/* Names and weights of the targets: those of the first mesh that has them. */
static int read_targets(nkwi_assimp *a, size_t index, nkw_document_mesh *mesh)
{
    const struct aiNode *node = a->nodes[index];
    float *weights = (float *)nkwi_assimp_take(a, "meshes", mesh->target_count, sizeof *weights);
    const char **names = (const char **)nkwi_assimp_take(a, "meshes", mesh->target_count, sizeof *names);
    mesh->weights = weights;
    mesh->target_names = names;
    if (!weights || !names)
        return 0;
    if (a->fbx && !nkwi_assimp_fbx_weights(a, index, mesh->target_count, weights))
        return 0;
    for (size_t i = mesh->primitive_count; i-- > 0;) {
        const struct aiMesh *m = a->scene->mMeshes[node->mMeshes[i]];
        for (size_t t = 0; t < m->mNumAnimMeshes; t++) {
            weights[t] = a->fbx ? weights[t] : m->mAnimMeshes[t]->mWeight;
            names[t] = nkwi_assimp_name(a, &m->mAnimMeshes[t]->mName, "target", t);
            if (!names[t])
                return 0;
        }
    }
    return 1;
}

/* Takes the entries of the builder as the skin of the node. */
static int end_skin(builder *b, nkw_document_node *out)
{
    nkw_document *d = &b->a->document->all;
    if (b->count == 0)
        return 1;
    nkwi_assimp_bone *bones = (nkwi_assimp_bone *)nkwi_assimp_scratch(b->a, "skins", b->count, sizeof *bones);
    if (!bones)
        return 0;
    memcpy(bones, b->entries, b->count * sizeof *bones);
    for (size_t i = 0; i < b->count; i++)
        b->first[bones[i].node] = NKW_NO_JOINT;
    b->a->skins[d->skin_count].bones = bones;
    b->a->skins[d->skin_count].count = b->count;
    out->skin = (int32_t)d->skin_count++;
    return 1;
}

/* The room of a skin: all bones, and one for vertices without weights. */
static int begin_skin(builder *b, const struct aiNode *node)
{
    size_t bones = 1, most = 1;
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        size_t count = b->a->scene->mMeshes[node->mMeshes[i]]->mNumBones;
        bones += count;
        most = count > most ? count : most;
    }
    b->count = 0;
    b->room = bones < INT32_MAX ? bones : INT32_MAX;
    b->entries = (nkwi_assimp_bone *)nkwi_assimp_scratch(b->a, "skins", b->room, sizeof *b->entries);
    b->entry_of_bone = (uint16_t *)nkwi_assimp_scratch(b->a, "skins", most, sizeof *b->entry_of_bone);
    return b->entries && b->entry_of_bone;
}

static int make_mesh(builder *b, nkw_document_mesh *mesh, nkw_document_node *out)
{
    nkwi_assimp *a = b->a;
    const struct aiNode *node = a->nodes[b->node];
    size_t count = node->mNumMeshes;
    nkw_document_primitive *list = (nkw_document_primitive *)nkwi_assimp_take(a, "meshes", count, sizeof *list);
    if (!list || !begin_skin(b, node))
        return 0;
    mesh->primitives = list;
    mesh->primitive_count = count;
    mesh->name = nkwi_assimp_name(a, &a->scene->mMeshes[node->mMeshes[0]]->mName, "mesh", (size_t)out->mesh);
    for (size_t i = 0; i < count; i++) {
        list[i] = a->primitives[node->mMeshes[i]];
        mesh->target_count = list[i].target_count > mesh->target_count ? list[i].target_count : mesh->target_count;
        if (!bind(b, node->mMeshes[i], &list[i]))
            return 0;
    }
    for (size_t i = 0; i < count; i++)
        if (!level_targets(a, &list[i], mesh->target_count))
            return 0;
    return mesh->name && read_targets(a, b->node, mesh) && end_skin(b, out);
}

/* Nodes that have the same meshes share them. */
static int is_same(const struct aiNode *left, const struct aiNode *right)
{
    return left->mNumMeshes == right->mNumMeshes &&
           memcmp(left->mMeshes, right->mMeshes, left->mNumMeshes * sizeof *left->mMeshes) == 0;
}

int nkwi_assimp_instances(nkwi_assimp *a, nkw_document_node *list)
{
    nkw_document *d = &a->document->all;
    builder b = {a, 0, NULL, NULL, 0, 0, NULL};
    size_t count = a->node_count;
    nkw_document_mesh *meshes = (nkw_document_mesh *)nkwi_assimp_take(a, "meshes", count, sizeof *meshes);
    size_t *user = (size_t *)nkwi_assimp_scratch(a, "meshes", a->scene->mNumMeshes, sizeof *user);
    a->skins = (nkwi_assimp_skin *)nkwi_assimp_scratch(a, "skins", count, sizeof *a->skins);
    b.first = (int32_t *)nkwi_assimp_scratch(a, "skins", count, sizeof *b.first);
    if (!meshes || !user || !a->skins || !b.first)
        return 0;
    d->meshes = meshes;
    for (size_t i = 0; i < count; i++)
        b.first[i] = NKW_NO_JOINT;
    for (b.node = 0; b.node < count; b.node++) {
        const struct aiNode *node = a->nodes[b.node];
        if (!nkwi_assimp_check_node(a, b.node))
            return 0;
        if (node->mNumMeshes == 0 || !a->has_meshes)
            continue;
        nkw_document_node *out = &list[a->mesh_carrier[b.node]];
        size_t *known = &user[node->mMeshes[0]]; /* 1 more than the node that has this first mesh */
        if (*known > 0 && a->scene->mMeshes[node->mMeshes[0]]->mNumBones == 0 && is_same(a->nodes[*known - 1], node)) {
            out->mesh = list[a->mesh_carrier[*known - 1]].mesh;
            out->skin = list[a->mesh_carrier[*known - 1]].skin;
            continue;
        }
        *known = b.node + 1;
        out->mesh = (int32_t)d->mesh_count++;
        if (!make_mesh(&b, &meshes[out->mesh], out))
            return 0;
    }
    return 1;
}

int nkwi_assimp_skins(nkwi_assimp *a)
{
    nkw_document *d = &a->document->all;
    nkw_document_skin *skins = (nkw_document_skin *)nkwi_assimp_take(a, "skins", d->skin_count, sizeof *skins);
    if (!skins)
        return 0;
    d->skins = skins;
    for (size_t k = 0; k < d->skin_count; k++) {
        const nkwi_assimp_skin *from = &a->skins[k];
        int32_t *joints = (int32_t *)nkwi_assimp_take(a, "skins", from->count, sizeof *joints);
        nkw_mat4 *matrices = (nkw_mat4 *)nkwi_assimp_take(a, "skins", from->count, sizeof *matrices);
        if (!joints || !matrices)
            return 0;
        for (size_t i = 0; i < from->count; i++) {
            joints[i] = nkwi_assimp_bone_joint(a, from->bones[i].node);
            matrices[i] = from->bones[i].inverse_bind;
        }
        skins[k].name = nkwi_document_name(a->document, a->error, NULL, "skin", k);
        skins[k].joints = joints;
        skins[k].inverse_bind = matrices;
        skins[k].joint_count = from->count;
        if (!skins[k].name)
            return 0;
    }
    return 1;
}
