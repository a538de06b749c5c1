/* SPDX-License-Identifier: MIT */
#include "moment.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/segment.h>

static size_t largest_skin(const nkw_document *d)
{
    size_t most = 0;
    for (size_t i = 0; i < d->skin_count; i++)
        most = d->skins[i].joint_count > most ? d->skins[i].joint_count : most;
    return most;
}

static size_t largest_primitive(const nkw_document *d)
{
    size_t most = 0;
    for (size_t i = 0; i < d->mesh_count; i++)
        for (size_t p = 0; p < d->meshes[i].primitive_count; p++) {
            size_t count = d->meshes[i].primitives[p].vertex_count;
            most = count > most ? count : most;
        }
    return most;
}

/* One element at least, so that NULL means that there is no memory. */
static void *zeros(size_t count, size_t size)
{
    return calloc(count ? count : 1, size);
}

int moment_open(moment *m, const nkw_document *d, size_t animation)
{
    nkw_import_error error;
    memset(m, 0, sizeof *m);
    m->document = d;
    if (d->skeleton.joint_count == 0) {
        output_text(stderr, d->file);
        fputs(": the file has no nodes\n", stderr);
        return 0;
    }
    if (nkw_document_clip(d, animation, NKW_CLIP_FLOAT32, &m->clip, &error) != NKW_IMPORT_OK) {
        input_report(&error);
        return 0;
    }
    size_t joints = d->skeleton.joint_count, vertices = largest_primitive(d);
    m->cursors = zeros(nkw_clip_describe(m->clip).cursor_count, sizeof *m->cursors);
    m->pose = zeros(nkw_pose_floats(joints), sizeof *m->pose);
    m->floats = zeros(d->float_count, sizeof *m->floats);
    m->models = zeros(joints, sizeof *m->models);
    m->palette = zeros(largest_skin(d), sizeof *m->palette);
    m->positions = zeros(vertices, sizeof *m->positions);
    m->normals = zeros(vertices, sizeof *m->normals);
    if (m->cursors && m->pose && m->floats && m->models && m->palette && m->positions && m->normals)
        return 1;
    fprintf(stderr, "%s: no memory\n", d->file);
    return 0;
}

void moment_close(moment *m)
{
    nkw_import_free(m->clip);
    free(m->cursors);
    free(m->pose);
    free(m->floats);
    free(m->models);
    free(m->palette);
    free(m->positions);
    free(m->normals);
}

nkw_pose_view moment_pose(const moment *m)
{
    nkw_pose_view pose = {m->pose, m->document->skeleton.joint_count};
    return pose;
}

void moment_at(moment *m, float time)
{
    nkw_pose_span pose = {m->pose, m->document->skeleton.joint_count};
    nkw_clip_sample(m->clip, time, m->cursors, pose, m->floats);
    nkw_document_models(m->document, moment_pose(m), NULL, m->models);
}

void moment_palette(moment *m, size_t skin)
{
    nkw_document_palette(m->document, skin, m->models, m->palette);
}

void moment_vertices(moment *m, size_t joint, size_t primitive)
{
    const nkw_document_node *node = &m->document->nodes[joint];
    nkw_document_vertices_span out = {m->positions, m->normals};
    if (node->skin >= 0)
        moment_palette(m, (size_t)node->skin);
    const nkw_document_moment now = {m->models, m->floats, m->palette};
    nkw_document_vertices(m->document, joint, primitive, &now, out);
}

int moment_rest_box(const nkw_document *d, nkw_box *box)
{
    moment m;
    const int done = moment_open(&m, d, INPUT_REST);
    *box = NKW_BOX_EMPTY;
    if (done)
        moment_at(&m, 0.0f);
    for (size_t j = 0; done && j < d->skeleton.joint_count; j++)
        for (size_t k = 0; d->nodes[j].mesh >= 0 && k < d->meshes[d->nodes[j].mesh].primitive_count; k++) {
            const nkw_document_primitive *p = &d->meshes[d->nodes[j].mesh].primitives[k];
            if (!p->positions)
                continue;
            moment_vertices(&m, j, k);
            const nkw_box part = nkw_box_from_points(m.positions, p->vertex_count);
            *box = nkw_box_union(box, &part);
        }
    moment_close(&m);
    return done;
}

size_t moment_rate_count(const moment *m, float rate)
{
    const nkw_clip_description d = nkw_clip_describe(m->clip);
    const nkw_timeline line = {d.start, rate, 0};
    double steps = ((double)d.end - (double)d.start) * (double)rate;
    if (!(steps < 1e9))
        return SIZE_MAX;
    size_t count = (size_t)steps;
    while (nkw_timeline_time(line, count) < d.end)
        count++;
    return count + 1;
}

float moment_rate_time(const moment *m, float rate, size_t k)
{
    const nkw_clip_description d = nkw_clip_describe(m->clip);
    const float time = nkw_timeline_time((nkw_timeline){d.start, rate, 0}, k);
    return time < d.end ? time : d.end;
}
