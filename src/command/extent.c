/* SPDX-License-Identifier: MIT */
#include "extent.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/scalar.h>
#include <nakawari/skeleton.h>
#include <nakawari/vec.h>

static void include_point(extent *e, nkw_vec3 p)
{
    if (!isfinite(p.x) || !isfinite(p.y) || !isfinite(p.z))
        return;
    e->low = nkw_vec3_min(e->low, p);
    e->high = nkw_vec3_max(e->high, p);
}

/* The largest length of the three axes of a matrix. */
static float stretch_of(const nkw_mat4 *m)
{
    float most = 0.0f;
    for (int c = 0; c < 3; c++) {
        nkw_vec3 axis = {m->m[4 * c], m->m[4 * c + 1], m->m[4 * c + 2]};
        most = nkw_max(most, nkw_vec3_length(axis));
    }
    return most;
}

/* How far the vertices of a primitive reach from the joints of a skin in the bind pose. */
static void reach_skin(extent *e, const nkw_document_primitive *p, const nkw_document_skin *skin)
{
    for (size_t i = 0; i < p->vertex_count * p->influence_count; i++) {
        size_t joint = p->joints[i];
        if (!(p->weights[i] > 0.0f) || joint >= skin->joint_count)
            continue;
        nkw_vec3 at = p->positions[i / p->influence_count];
        if (skin->inverse_bind)
            at = nkw_mat4_transform_point(&skin->inverse_bind[joint], at);
        float *reach = &e->reach[skin->joints[joint]], distance = nkw_vec3_length(at);
        if (distance > *reach && isfinite(distance))
            *reach = distance;
    }
}

static void reach_rigid(extent *e, const nkw_document_primitive *p, size_t joint)
{
    for (size_t v = 0; v < p->vertex_count; v++) {
        float distance = nkw_vec3_length(p->positions[v]);
        if (distance > e->reach[joint] && isfinite(distance))
            e->reach[joint] = distance;
    }
}

static void reach_mesh(extent *e, moment *m, size_t joint)
{
    const nkw_document_node *node = &m->document->nodes[joint];
    const nkw_document_mesh *mesh = &m->document->meshes[node->mesh];
    for (size_t i = 0; i < mesh->primitive_count; i++) {
        const nkw_document_primitive *p = &mesh->primitives[i];
        if (!p->positions)
            continue;
        moment_vertices(m, joint, i);
        for (size_t v = 0; v < p->vertex_count; v++)
            include_point(e, m->positions[v]);
        if (node->skin >= 0 && p->influence_count)
            reach_skin(e, p, &m->document->skins[node->skin]);
        else
            reach_rigid(e, p, joint);
    }
}

/* The radius of a joint without vertices: it may be a socket, an eye, the end of a chain. */
#define PART 0.0625f

/*
 * Cameras and lights see as far as the model, and so may a node that has neither parent nor child nor any vertices to
 * move: 1/10000 of the model is then 0.006 degrees.
 */
static int sees_far(const nkw_document *d, size_t joint)
{
    const size_t next = nkw_skeleton_subtree_end(&d->skeleton, joint);
    return d->nodes[joint].is_view || (d->mesh_count == 0 && d->skeleton.parents[joint] < 0 && next == joint + 1);
}

static void measure(extent *e, moment *m)
{
    const nkw_skeleton *s = &m->document->skeleton;
    e->low = e->high = nkw_mat4_translation(&m->models[0]);
    for (size_t j = 0; j < s->joint_count; j++) {
        include_point(e, nkw_mat4_translation(&m->models[j]));
        if (m->document->nodes[j].mesh >= 0)
            reach_mesh(e, m, j);
    }
    e->size = nkw_vec3_length(nkw_vec3_sub(e->high, e->low));
    if (!(e->size > 0.0f && isfinite(e->size)))
        e->size = 1.0f;
    for (size_t j = 0; j < s->joint_count; j++) {
        const float stretch = stretch_of(&m->models[j]);
        const float scale = stretch > 0.0f ? stretch : 1.0f;
        e->radius[j] = e->reach[j] > 0.0f ? e->reach[j] * scale : PART * e->size;
        if (sees_far(m->document, j))
            e->radius[j] = nkw_max(e->radius[j], e->size);
        if (!(e->reach[j] > 0.0f))
            e->reach[j] = 0.01f * e->size / scale;
        e->lever[j] = e->radius[j] / scale * stretch;
        e->stretch[j] = s->parents[j] < 0 ? 1.0f : stretch_of(&m->models[s->parents[j]]);
    }
    /* Children come after their parents. The way from joint to joint is at least as long as the straight line. */
    for (size_t j = s->joint_count; j-- > 0;) {
        int32_t parent = s->parents[j];
        if (parent < 0)
            continue;
        nkw_vec3 bone = nkw_vec3_sub(nkw_mat4_translation(&m->models[j]), nkw_mat4_translation(&m->models[parent]));
        e->lever[parent] = nkw_max(e->lever[parent], nkw_vec3_length(bone) + e->lever[j]);
    }
}

int extent_open(extent *e, const nkw_document *d)
{
    moment m;
    size_t joints = d->skeleton.joint_count;
    memset(e, 0, sizeof *e);
    e->size = 1.0f;
    if (joints == 0)
        return 1;
    e->reach = calloc(joints, sizeof *e->reach);
    e->radius = calloc(joints, sizeof *e->radius);
    e->lever = calloc(joints, sizeof *e->lever);
    e->stretch = calloc(joints, sizeof *e->stretch);
    e->tolerances = calloc(joints, sizeof *e->tolerances);
    int fine = moment_open(&m, d, INPUT_REST) && e->reach && e->radius && e->lever && e->stretch && e->tolerances;
    if (fine) {
        moment_at(&m, 0.0f);
        measure(e, &m);
    }
    moment_close(&m);
    return fine;
}

void extent_free(extent *e)
{
    free(e->reach);
    free(e->radius);
    free(e->lever);
    free(e->stretch);
    free(e->tolerances);
}

nkw_clip_reduction extent_reduction(const extent *e, const nkw_document *d, float tolerance)
{
    const nkw_clip_reduction r = {d->skeleton.parents, tolerance, 0.0f, e->tolerances, e->radius, tolerance / e->size};
    for (size_t j = 0; j < d->skeleton.joint_count; j++)
        e->tolerances[j] = nkw_min(tolerance, 0.05f * e->lever[j]);
    return r;
}
