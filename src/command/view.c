/* SPDX-License-Identifier: MIT */
#include "view.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

/* ---- what is shown ---- */

static void mark_scene(view *v, const nkw_document *d)
{
    const nkw_document_scene *scene = d->scene < 0 ? NULL : &d->scenes[d->scene];
    memset(v->shown, scene == NULL, d->skeleton.joint_count);
    for (size_t i = 0; scene && i < scene->root_count; i++)
        v->shown[scene->roots[i]] = 1;
    for (size_t j = 0; j < d->skeleton.joint_count; j++)
        if (d->skeleton.parents[j] >= 0)
            v->shown[j] |= v->shown[d->skeleton.parents[j]];
}

static void mark_bones(view *v, const nkw_document *d)
{
    memset(v->bones, d->skin_count == 0, d->skeleton.joint_count);
    for (size_t s = 0; s < d->skin_count; s++)
        for (size_t i = 0; i < d->skins[s].joint_count; i++)
            v->bones[d->skins[s].joints[i]] = 1;
}

int view_open(view *v, const nkw_document *d)
{
    memset(v, 0, sizeof *v);
    v->shown = calloc(d->skeleton.joint_count, 1);
    v->bones = calloc(d->skeleton.joint_count, 1);
    if (!v->shown || !v->bones) {
        fprintf(stderr, "%s: no memory\n", d->file);
        return 0;
    }
    mark_scene(v, d);
    mark_bones(v, d);
    v->frames_bones = d->skin_count > 0 || d->mesh_count == 0;
    view_turn(v, 0.0f, 0.0f);
    return 1;
}

void view_free(view *v)
{
    free(v->shown);
    free(v->bones);
}

/* ---- the camera ---- */

void view_turn(view *v, float yaw, float pitch)
{
    const nkw_vec3 x = {1.0f, 0.0f, 0.0f}, y = {0.0f, 1.0f, 0.0f};
    const nkw_vec3 low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};
    v->eye = nkw_mat4_from_quat(nkw_quat_mul(nkw_quat_from_axis_angle(x, pitch), nkw_quat_from_axis_angle(y, -yaw)));
    v->low = low;
    v->high = high;
}

static void include_point(view *v, nkw_vec3 world)
{
    nkw_vec3 p = nkw_mat4_transform_point(&v->eye, world);
    if (!isfinite(p.x) || !isfinite(p.y) || !isfinite(p.z))
        return;
    v->low.x = nkw_min(v->low.x, p.x), v->low.y = nkw_min(v->low.y, p.y), v->low.z = nkw_min(v->low.z, p.z);
    v->high.x = nkw_max(v->high.x, p.x), v->high.y = nkw_max(v->high.y, p.y), v->high.z = nkw_max(v->high.z, p.z);
}

static nkw_vec3 origin_of(const nkw_mat4 *m)
{
    nkw_vec3 p = {m->m[12], m->m[13], m->m[14]};
    return p;
}

static const nkw_document_mesh *mesh_of(const view *v, const nkw_document *d, size_t joint)
{
    return v->shown[joint] && d->nodes[joint].mesh >= 0 ? &d->meshes[d->nodes[joint].mesh] : NULL;
}

void view_include(view *v, moment *m)
{
    const nkw_document *d = m->document;
    for (size_t j = 0; j < d->skeleton.joint_count; j++) {
        const nkw_document_mesh *mesh = mesh_of(v, d, j);
        if (v->frames_bones && v->shown[j] && v->bones[j])
            include_point(v, origin_of(&m->models[j]));
        for (size_t p = 0; mesh && p < mesh->primitive_count; p++) {
            if (!mesh->primitives[p].positions)
                continue;
            moment_vertices(m, j, p);
            for (size_t i = 0; i < mesh->primitives[p].vertex_count; i++)
                include_point(v, m->positions[i]);
        }
    }
}

void view_join(view *v, const view *other)
{
    v->low.x = nkw_min(v->low.x, other->low.x), v->low.y = nkw_min(v->low.y, other->low.y);
    v->high.x = nkw_max(v->high.x, other->high.x), v->high.y = nkw_max(v->high.y, other->high.y);
}

/* From the box to the points of the raster, with a margin of 4 %. */
static nkw_vec3 to_raster(const view *v, const raster *r, nkw_vec3 world)
{
    nkw_vec3 p = nkw_mat4_transform_point(&v->eye, world);
    float wide = nkw_max(v->high.x - v->low.x, 1e-20f), high = nkw_max(v->high.y - v->low.y, 1e-20f);
    float scale = 0.92f * nkw_min((float)r->width / wide, (float)r->height / high);
    nkw_vec3 out = {0.5f * (float)r->width + scale * (p.x - 0.5f * (v->low.x + v->high.x)),
                    0.5f * (float)r->height - scale * (p.y - 0.5f * (v->low.y + v->high.y)), p.z};
    return out;
}

/* ---- drawing ---- */

static nkw_vec3 colour_of(const nkw_document *d, const nkw_document_primitive *p)
{
    nkw_vec3 colour = {0.62f, 0.62f, 0.64f};
    if (p->material >= 0) {
        const float *c = d->materials[p->material].color;
        nkw_vec3 own = {nkw_saturate(c[0]), nkw_saturate(c[1]), nkw_saturate(c[2])};
        colour = own;
    }
    return colour;
}

static void draw_primitive(const view *v, moment *m, raster *r, size_t joint, size_t index)
{
    const nkw_document_mesh *mesh = &m->document->meshes[m->document->nodes[joint].mesh];
    const nkw_document_primitive *p = &mesh->primitives[index];
    if (!p->positions || p->topology != NKW_DOCUMENT_TRIANGLES)
        return;
    moment_vertices(m, joint, index);
    nkw_vec3 colour = colour_of(m->document, p);
    for (size_t t = 0; t + 2 < p->index_count; t += 3) {
        raster_corner corner[3];
        nkw_vec3 at[3];
        for (int i = 0; i < 3; i++)
            at[i] = m->positions[p->indices[t + (size_t)i]];
        nkw_vec3 face = nkw_vec3_cross(nkw_vec3_sub(at[1], at[0]), nkw_vec3_sub(at[2], at[0]));
        for (int i = 0; i < 3; i++) {
            nkw_vec3 normal = p->normals ? m->normals[p->indices[t + (size_t)i]] : face;
            corner[i].place = to_raster(v, r, at[i]);
            corner[i].normal = nkw_mat4_transform_direction(&v->eye, normal);
        }
        raster_triangle(r, corner, colour);
    }
}

static void draw_bones(const view *v, const moment *m, raster *r)
{
    const nkw_vec3 bone = {0.9f, 0.25f, 0.02f}, end = {0.05f, 0.05f, 0.07f};
    const int32_t *parents = m->document->skeleton.parents;
    float width = nkw_max(2.5f, 0.008f * (float)r->width);
    for (size_t j = 0; j < m->document->skeleton.joint_count; j++)
        if (v->shown[j] && v->bones[j] && parents[j] >= 0 && v->bones[parents[j]])
            raster_line(r, to_raster(v, r, origin_of(&m->models[parents[j]])),
                        to_raster(v, r, origin_of(&m->models[j])), width, bone);
    for (size_t j = 0; j < m->document->skeleton.joint_count; j++)
        if (v->shown[j] && v->bones[j])
            raster_disc(r, to_raster(v, r, origin_of(&m->models[j])), width, end);
}

void view_draw(const view *v, moment *m, raster *r, int skeleton)
{
    for (size_t j = 0; j < m->document->skeleton.joint_count; j++) {
        const nkw_document_mesh *mesh = mesh_of(v, m->document, j);
        for (size_t p = 0; mesh && p < mesh->primitive_count; p++)
            draw_primitive(v, m, r, j, p);
    }
    if (skeleton)
        draw_bones(v, m, r);
}
