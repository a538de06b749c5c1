/* SPDX-License-Identifier: MIT */
#include "skinmodel.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/skin.h>
#include <nakawari/vec.h>

static int complain(const nkw_document *d, size_t joint, const char *what)
{
    output_text(stderr, d->file);
    fputs(": node ", stderr);
    output_text(stderr, d->nodes[joint].name);
    fprintf(stderr, ": %s\n", what);
    return 0;
}

/* ---- bones ---- */

/* The nearest joint above that is in the skin, as an index of the skin. */
static int32_t parent_in_skin(const nkw_document *d, const int32_t *index_of_joint, int32_t joint)
{
    do
        joint = d->skeleton.parents[joint];
    while (joint >= 0 && index_of_joint[joint] < 0);
    return joint < 0 ? NKW_NO_JOINT : index_of_joint[joint];
}

/* Sorts the joints of the skin by depth; rank[i] is the bone of joint i of the skin. */
static int sort_bones(skinmodel *s, const nkw_document *d, const nkw_document_skin *skin, uint16_t *rank)
{
    const size_t count = skin->joint_count, joints = d->skeleton.joint_count;
    int32_t *index = malloc(joints * sizeof *index), *parents = malloc(count * sizeof *parents);
    uint16_t *depths = calloc(count, sizeof *depths);
    uint32_t *order = calloc(count, sizeof *order);
    int fine = index && parents && depths && order;
    for (size_t j = 0; fine && j < joints; j++)
        index[j] = NKW_NO_JOINT;
    for (size_t i = 0; fine && i < count; i++)
        index[skin->joints[i]] = (int32_t)i;
    for (size_t i = 0; fine && i < count; i++)
        parents[i] = parent_in_skin(d, index, skin->joints[i]);
    const nkw_skeleton bones = {parents, count};
    fine = fine && nkw_skeleton_depths(&bones, depths, order, NULL) == NKW_OK;
    for (size_t b = 0; fine && b < count; b++)
        rank[order[b]] = (uint16_t)b;
    for (size_t b = 0; fine && b < count; b++) {
        const size_t i = order[b];
        s->joint_of_bone[b] = skin->joints[i];
        s->parents[b] = parents[i] < 0 ? NKW_NO_JOINT : (int32_t)rank[parents[i]];
        s->inverse_bind[b] = skin->inverse_bind ? skin->inverse_bind[i] : nkw_mat4_identity();
    }
    free(index);
    free(parents);
    free(depths);
    free(order);
    return fine;
}

nkw_mat4 skinmodel_bind_local(const skinmodel *s, size_t bone)
{
    nkw_mat4 bind = nkw_mat4_inverse_affine(&s->inverse_bind[bone]);
    return s->parents[bone] < 0 ? bind : nkw_mat4_mul_affine(&s->inverse_bind[s->parents[bone]], &bind);
}

/* ---- vertices ---- */

static int usable(const nkw_document_primitive *p)
{
    return p->topology == NKW_DOCUMENT_TRIANGLES && p->positions && p->influence_count;
}

static void count_elements(skinmodel *s, const nkw_document_mesh *mesh)
{
    for (size_t i = 0; i < mesh->primitive_count; i++)
        if (usable(&mesh->primitives[i])) {
            s->mesh.vertex_count += mesh->primitives[i].vertex_count;
            s->mesh.triangle_count += mesh->primitives[i].index_count / 3;
            if (s->texcoord_count < mesh->primitives[i].texcoord_count)
                s->texcoord_count = mesh->primitives[i].texcoord_count;
        }
}

static int allocate(skinmodel *s, size_t influences)
{
    const size_t vertices = s->mesh.vertex_count, triangles = s->mesh.triangle_count;
    s->indices = calloc(3 * triangles + 1, sizeof *s->indices);
    s->materials = calloc(triangles + 1, sizeof *s->materials);
    s->joints = calloc(vertices * influences + 1, sizeof *s->joints);
    s->weights = calloc(vertices * influences + 1, sizeof *s->weights);
    s->positions = calloc(vertices + 1, sizeof *s->positions);
    s->normals = calloc(vertices + 1, sizeof *s->normals);
    s->joint_of_bone = calloc(s->bone_count, sizeof *s->joint_of_bone);
    s->parents = calloc(s->bone_count, sizeof *s->parents);
    s->inverse_bind = calloc(s->bone_count, sizeof *s->inverse_bind);
    s->texcoords = calloc(2 * s->texcoord_count * vertices + 1, sizeof *s->texcoords);
    return s->indices && s->materials && s->joints && s->weights && s->positions && s->normals && s->joint_of_bone &&
           s->parents && s->inverse_bind && s->texcoords;
}

/* Appends a primitive at a vertex and a triangle. */
static void append(skinmodel *s, const nkw_document_primitive *p, size_t vertex, size_t triangle)
{
    const size_t keep = s->mesh.influence_count;
    nkw_skin_span joints = {s->joints + vertex * keep, 0, NKW_SKIN_U16};
    nkw_skin_span weights = {s->weights + vertex * keep, 0, NKW_SKIN_F32};
    nkw_skin_prune(&p->skin, keep, joints, weights);
    memcpy(s->positions + vertex, p->positions, p->vertex_count * sizeof *p->positions);
    if (p->normals)
        memcpy(s->normals + vertex, p->normals, p->vertex_count * sizeof *p->normals);
    for (size_t set = 0; set < p->texcoord_count; set++)
        for (size_t v = 0; v < p->vertex_count; v++)
            memcpy(s->texcoords + 2 * (s->texcoord_count * (vertex + v) + set), p->texcoords[set] + 2 * v,
                   2 * sizeof *s->texcoords);
    for (size_t i = 0; i < p->index_count / 3 * 3; i++)
        s->indices[3 * triangle + i] = (uint32_t)vertex + p->indices[i];
    for (size_t i = 0; i < p->index_count / 3; i++)
        s->materials[triangle + i] = (uint32_t)(p->material + 1);
}

static void append_all(skinmodel *s, const nkw_document_mesh *mesh)
{
    size_t vertex = 0, triangle = 0;
    for (size_t i = 0; i < mesh->primitive_count; i++)
        if (usable(&mesh->primitives[i])) {
            append(s, &mesh->primitives[i], vertex, triangle);
            vertex += mesh->primitives[i].vertex_count;
            triangle += mesh->primitives[i].index_count / 3;
        }
}

int skinmodel_open(skinmodel *s, const nkw_document *d, size_t joint, size_t influences)
{
    memset(s, 0, sizeof *s);
    const nkw_document_mesh *mesh = &d->meshes[d->nodes[joint].mesh];
    const nkw_document_skin *skin = &d->skins[d->nodes[joint].skin];
    s->bone_count = skin->joint_count;
    s->mesh.influence_count = influences < NKW_SKIN_INFLUENCES ? influences : NKW_SKIN_INFLUENCES;
    count_elements(s, mesh);
    uint16_t *rank = calloc(s->bone_count + 1, sizeof *rank);
    int fine = rank && s->bone_count <= 65536 && allocate(s, s->mesh.influence_count);
    fine = (fine && sort_bones(s, d, skin, rank)) || complain(d, joint, "no memory, or more than 65536 bones");
    if (fine)
        append_all(s, mesh);
    for (size_t i = 0; fine && i < s->mesh.vertex_count * s->mesh.influence_count; i++)
        if (s->joints[i] < s->bone_count)
            s->joints[i] = rank[s->joints[i]];
        else if (s->weights[i] != 0.0f)
            fine = complain(d, joint, "a joint of a vertex is not in the skin: see nakawari check");
    free(rank);
    s->mesh.indices = s->indices, s->mesh.materials = s->materials;
    s->mesh.joints = s->joints, s->mesh.weights = s->weights;
    s->mesh.joint_count = s->bone_count;
    return fine;
}

void skinmodel_free(skinmodel *s)
{
    free(s->indices);
    free(s->materials);
    free(s->joints);
    free(s->weights);
    free(s->positions);
    free(s->normals);
    free(s->texcoords);
    free(s->joint_of_bone);
    free(s->parents);
    free(s->inverse_bind);
}
