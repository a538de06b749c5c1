/* SPDX-License-Identifier: MIT */
/*
 * Vertices multiplied by the rest transforms of their nodes, which become identities.
 *
 * A node is kept with its transform if it is animated, a joint of a skin, a camera or light, or above such a node. For
 * the others, M(node) = M(parent) T(node), where M of a kept node is the identity: so a mesh below a kept node is
 * multiplied by the transforms up to that node.
 */
#include "prepare.h"

#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/transform.h>
#include <nakawari/vec.h>

typedef struct transforms {
    nkwi_prepare *p;
    unsigned char *kept; /* of each joint */
    nkw_mat4 *models; /* of each joint, M */
    size_t *uses; /* nodes of each mesh */
    int32_t *mesh_of; /* of each joint */
    size_t mesh_count;
    nkw_mat3 normals; /* of the current mesh: the inverse transpose */
    int mirrors; /* whether the determinant is negative */
    size_t changed;
} transforms;

static void find_kept(transforms *t)
{
    const nkw_document *d = &t->p->document->all;
    for (size_t a = 0; a < d->animation_count; a++)
        for (size_t i = 0; i < d->animations[a].track_count; i++)
            if (d->animations[a].tracks[i].target != NKW_CLIP_FLOATS)
                t->kept[d->animations[a].channels[i].joint] = 1;
    for (size_t s = 0; s < d->skin_count; s++)
        for (size_t k = 0; k < d->skins[s].joint_count; k++)
            t->kept[d->skins[s].joints[k]] = 1;
    for (size_t j = d->skeleton.joint_count; j-- > 0;) {
        t->kept[j] = t->kept[j] || d->nodes[j].is_view;
        if (t->kept[j] && d->skeleton.parents[j] != NKW_NO_JOINT)
            t->kept[d->skeleton.parents[j]] = 1;
    }
}

/* In place of the transforms of kept nodes, identities. */
static void multiply(transforms *t)
{
    const nkw_document *d = &t->p->document->all;
    for (size_t j = 0; j < d->skeleton.joint_count; j++) {
        const nkw_document_node *node = &d->nodes[j];
        t->models[j] = t->kept[j]     ? nkw_mat4_identity()
                       : node->matrix ? *node->matrix
                                      : nkw_mat4_from_trs(&node->rest);
    }
    nkw_skeleton_models_from_locals(&d->skeleton, t->models, NULL, NULL, t->models);
}

static nkw_vec3 *take_vectors(const transforms *t, const nkw_vec3 *from, size_t count)
{
    return from && t->p->error->code == NKW_IMPORT_OK
               ? (nkw_vec3 *)nkwi_document_take(t->p->document, t->p->error, NULL, count, sizeof *from)
               : NULL;
}

static nkw_vec3 normal_of(const transforms *t, nkw_vec3 n)
{
    return nkw_vec3_normalize(nkw_mat3_transform(&t->normals, n));
}

/* Differences: M (p + d) - M p, and the same of normals; of tangents, which have no sign, the direction. */
static void change_target(const transforms *t, const nkw_mat4 *m, const nkw_document_primitive *base,
                          nkw_document_target *target)
{
    const size_t n = base->vertex_count;
    const nkw_document_target from = *target;
    nkw_vec3 *positions = take_vectors(t, from.positions, n), *normals = take_vectors(t, from.normals, n);
    nkw_vec3 *tangents = take_vectors(t, from.tangents, n);
    for (size_t i = 0; positions && i < n; i++)
        positions[i] = nkw_mat4_transform_direction(m, from.positions[i]);
    for (size_t i = 0; normals && base->normals && i < n; i++)
        normals[i] =
            nkw_vec3_sub(normal_of(t, nkw_vec3_add(base->normals[i], from.normals[i])), normal_of(t, base->normals[i]));
    for (size_t i = 0; tangents && i < n; i++)
        tangents[i] = nkw_mat4_transform_direction(m, from.tangents[i]);
    target->positions = positions;
    target->normals = base->normals ? normals : from.normals;
    target->tangents = tangents;
}

static void change_targets(const transforms *t, const nkw_mat4 *m, nkw_document_primitive *d)
{
    nkw_document_target *targets =
        (nkw_document_target *)nkwi_document_take(t->p->document, t->p->error, NULL, d->target_count, sizeof *targets);
    for (size_t i = 0; targets && i < d->target_count; i++) {
        targets[i] = d->targets[i];
        change_target(t, m, d, &targets[i]);
    }
    d->targets = targets;
}

static const float *change_tangents(const transforms *t, const nkw_mat4 *m, const nkw_document_primitive *d)
{
    float *out = d->tangents
                     ? (float *)nkwi_document_take(t->p->document, t->p->error, NULL, d->vertex_count, 4 * sizeof *out)
                     : NULL;
    for (size_t i = 0; out && i < d->vertex_count; i++) {
        const float *from = d->tangents + 4 * i;
        const nkw_vec3 v = {from[0], from[1], from[2]};
        const nkw_vec3 turned = nkw_vec3_normalize(nkw_mat4_transform_direction(m, v));
        memcpy(out + 4 * i, &turned, sizeof turned);
        out[4 * i + 3] = t->mirrors ? -from[3] : from[3];
    }
    return out;
}

/* A mirror reverses triangles. */
static const uint32_t *change_indices(const transforms *t, const nkw_document_primitive *d)
{
    if (!t->mirrors || d->topology != NKW_DOCUMENT_TRIANGLES)
        return d->indices;
    uint32_t *out = (uint32_t *)nkwi_document_take(t->p->document, t->p->error, NULL, d->index_count, sizeof *out);
    for (size_t i = 0; out && i < d->index_count / 3 * 3; i++)
        out[i] = d->indices[i % 3 == 0 ? i : i % 3 == 1 ? i + 1 : i - 1];
    return out;
}

static void change_primitive(const transforms *t, const nkw_mat4 *m, nkw_document_primitive *d)
{
    const size_t n = d->vertex_count;
    nkw_vec3 *positions = take_vectors(t, d->positions, n), *normals = take_vectors(t, d->normals, n);
    change_targets(t, m, d);
    d->tangents = change_tangents(t, m, d);
    d->indices = change_indices(t, d);
    for (size_t i = 0; positions && i < n; i++)
        positions[i] = nkw_mat4_transform_point(m, d->positions[i]);
    for (size_t i = 0; normals && i < n; i++)
        normals[i] = normal_of(t, d->normals[i]);
    d->positions = positions;
    d->normals = normals;
}

/* The mesh of a node that is not kept: its own copy, if other nodes have it too. */
static int change_mesh(transforms *t, size_t joint)
{
    nkwi_prepare *p = t->p;
    const nkw_document_node *node = &p->document->nodes[joint];
    const nkw_mat4 *m = &t->models[joint];
    const size_t own = (size_t)node->mesh;
    nkw_document_mesh *mesh = &p->meshes[own];
    if (t->uses[own] > 1) {
        const nkw_document_primitive *from = mesh->primitives;
        t->uses[own]--;
        t->mesh_of[joint] = (int32_t)t->mesh_count;
        p->meshes[t->mesh_count] = *mesh;
        mesh = &p->meshes[t->mesh_count++];
        nkw_document_primitive *copies = (nkw_document_primitive *)nkwi_document_take(
            p->document, p->error, NULL, mesh->primitive_count, sizeof *copies);
        if (!copies)
            return 0;
        if (mesh->primitive_count)
            memcpy(copies, from, mesh->primitive_count * sizeof *copies);
        mesh->primitives = copies;
    }
    const nkw_mat3 linear = nkw_mat3_from_mat4(m);
    t->normals = nkw_mat3_normal(&linear);
    t->mirrors = nkw_mat3_determinant(&linear) < 0.0f;
    for (size_t k = 0; k < mesh->primitive_count; k++) {
        nkw_document_primitive *d = (nkw_document_primitive *)&mesh->primitives[k];
        if (node->skin == NKW_NO_JOINT || d->skin.influence_count == 0)
            change_primitive(t, m, d);
    }
    t->changed++;
    return p->error->code == NKW_IMPORT_OK;
}

static int is_identity(const nkw_mat4 *m)
{
    const nkw_mat4 identity = nkw_mat4_identity();
    for (int i = 0; i < 16; i++)
        if (m->m[i] != identity.m[i])
            return 0;
    return 1;
}

/* Each node has at most one copy of a mesh: room for them. */
static int take_rooms(transforms *t)
{
    nkwi_prepare *p = t->p;
    const nkw_document *d = &p->document->all;
    const size_t joints = d->skeleton.joint_count;
    nkw_document_mesh *meshes =
        (nkw_document_mesh *)nkwi_document_take(p->document, p->error, NULL, d->mesh_count + joints, sizeof *meshes);
    t->kept = (unsigned char *)nkwi_prepare_scratch(p, joints, 1);
    t->models = (nkw_mat4 *)nkwi_prepare_scratch(p, joints, sizeof *t->models);
    t->uses = (size_t *)nkwi_prepare_scratch(p, d->mesh_count, sizeof *t->uses);
    t->mesh_of = (int32_t *)nkwi_prepare_scratch(p, joints, sizeof *t->mesh_of);
    t->mesh_count = d->mesh_count;
    if (!meshes || !t->kept || !t->models || !t->uses || !t->mesh_of)
        return 0;
    if (d->mesh_count)
        memcpy(meshes, p->meshes, d->mesh_count * sizeof *meshes);
    p->meshes = meshes;
    for (size_t j = 0; j < joints; j++) {
        t->mesh_of[j] = d->nodes[j].mesh;
        if (d->nodes[j].mesh != NKW_NO_JOINT)
            t->uses[d->nodes[j].mesh]++;
    }
    return 1;
}

/* The last step: before it, the document is as it was. */
static int write_nodes(transforms *t)
{
    nkwi_document *d = t->p->document;
    const size_t joints = d->all.skeleton.joint_count;
    float *rest = (float *)nkwi_document_take(d, t->p->error, NULL, nkw_pose_floats(joints), sizeof *rest);
    const nkw_pose_span pose = {rest, joints};
    if (!rest)
        return 0;
    nkw_pose_identity(pose);
    for (size_t j = 0; j < joints; j++) {
        d->nodes[j].mesh = t->mesh_of[j];
        if (!t->kept[j]) {
            d->nodes[j].rest = nkw_trs_identity();
            d->nodes[j].matrix = NULL;
        }
        const nkw_trs local = t->kept[j] ? nkw_pose_get(d->all.rest, j) : d->nodes[j].rest;
        nkw_pose_set(pose, j, &local);
    }
    d->all.rest = NKW_VIEW(nkw_pose, pose);
    d->all.meshes = t->p->meshes;
    d->all.mesh_count = t->mesh_count;
    return 1;
}

int nkwi_prepare_transforms(nkwi_prepare *p)
{
    transforms t;
    memset(&t, 0, sizeof t);
    t.p = p;
    if (!take_rooms(&t))
        return 0;
    find_kept(&t);
    multiply(&t);
    const size_t joints = p->document->all.skeleton.joint_count;
    size_t kept = 0;
    for (size_t j = 0; j < joints; j++) {
        kept += t.kept[j];
        if (!t.kept[j] && p->document->nodes[j].mesh != NKW_NO_JOINT && !is_identity(&t.models[j]) &&
            !change_mesh(&t, j))
            return 0;
    }
    return write_nodes(&t) &&
           nkwi_document_warn(p->document, p->error,
                              "nodes whose vertices were multiplied by their transforms: %zu; nodes that keep theirs "
                              "(animated, joints, cameras, above such): %zu",
                              t.changed, kept);
}
