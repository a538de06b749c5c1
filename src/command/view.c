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
    v->texture_count = d->material_count;
    v->textures = calloc(d->material_count + 1, sizeof *v->textures);
    if (!v->shown || !v->bones || !v->textures) {
        fprintf(stderr, "%s: no memory\n", d->file);
        return 0;
    }
    mark_scene(v, d);
    mark_bones(v, d);
    for (size_t i = 0; i < d->material_count; i++)
        if (d->materials[i].image)
            texture_open(&v->textures[i], d, d->materials[i].image);
    v->frames_bones = d->skin_count > 0 || d->mesh_count == 0;
    view_turn(v, NKW_VEC3_ZERO, 0.0f, 0.0f);
    return 1;
}

void view_free(view *v)
{
    free(v->shown);
    free(v->bones);
    for (size_t i = 0; v->textures && i < v->texture_count; i++)
        texture_free(&v->textures[i]);
    free(v->textures);
}

/* ---- the camera ---- */

static const view_box empty_box = {{INFINITY, INFINITY, INFINITY},
                                   {-INFINITY, -INFINITY, -INFINITY},
                                   {INFINITY, INFINITY, INFINITY},
                                   {-INFINITY, -INFINITY, -INFINITY},
                                   INFINITY};

void view_turn(view *v, nkw_vec3 origin, float yaw, float pitch)
{
    const nkw_vec3 x = {1.0f, 0.0f, 0.0f}, y = {0.0f, 1.0f, 0.0f};
    v->eye = nkw_mat4_from_quat(nkw_quat_mul(nkw_quat_from_axis_angle(x, pitch), nkw_quat_from_axis_angle(y, -yaw)));
    nkw_vec3 moved = nkw_mat4_transform_point(&v->eye, nkw_vec3_scale(origin, -1.0f));
    v->eye.m[12] = moved.x, v->eye.m[13] = moved.y, v->eye.m[14] = moved.z;
    v->origin = origin;
    v->box = empty_box;
}

static void include_point(view *v, nkw_vec3 world)
{
    nkw_vec3 p = nkw_mat4_transform_point(&v->eye, world);
    if (!isfinite(p.x) || !isfinite(p.y) || !isfinite(p.z))
        return;
    v->box.low = nkw_vec3_min(v->box.low, p);
    v->box.high = nkw_vec3_max(v->box.high, p);
    v->box.least = nkw_vec3_min(v->box.least, nkw_vec3_sub(world, v->origin));
    v->box.most = nkw_vec3_max(v->box.most, nkw_vec3_sub(world, v->origin));
    v->box.sole = nkw_min(v->box.sole, p.y - world.y * v->eye.m[5]);
}

nkw_vec3 view_middle(const view *v, const moment *m)
{
    nkw_vec3 sum = NKW_VEC3_ZERO;
    size_t count = 0;
    for (size_t j = 0; j < m->document->skeleton.joint_count; j++)
        if (v->shown[j] && v->bones[j]) {
            sum = nkw_vec3_add(sum, nkw_mat4_translation(&m->models[j]));
            count++;
        }
    nkw_vec3 mean = nkw_vec3_scale(sum, 1.0f / (float)(count ? count : 1));
    mean.y = 0.0f;
    return isfinite(mean.x) && isfinite(mean.z) ? mean : NKW_VEC3_ZERO;
}

static const nkw_document_mesh *mesh_of(const view *v, const nkw_document *d, size_t joint)
{
    return v->shown[joint] && d->nodes[joint].mesh >= 0 ? &d->meshes[d->nodes[joint].mesh] : NULL;
}

/* Calls `at` for each primitive that is shown, its vertices computed. */
typedef void (*visit)(void *user, moment *m, const nkw_document_primitive *p);

static void visit_primitives(const view *v, moment *m, visit at, void *user)
{
    for (size_t j = 0; j < m->document->skeleton.joint_count; j++) {
        const nkw_document_mesh *mesh = mesh_of(v, m->document, j);
        for (size_t p = 0; mesh && p < mesh->primitive_count; p++) {
            if (!mesh->primitives[p].positions)
                continue;
            moment_vertices(m, j, p);
            at(user, m, &mesh->primitives[p]);
        }
    }
}

static void include_vertices(void *user, moment *m, const nkw_document_primitive *p)
{
    for (size_t i = 0; i < p->vertex_count; i++)
        include_point(user, m->positions[i]);
}

void view_include(view *v, moment *m)
{
    for (size_t j = 0; j < m->document->skeleton.joint_count; j++)
        if (v->frames_bones && v->shown[j] && v->bones[j])
            include_point(v, nkw_mat4_translation(&m->models[j]));
    visit_primitives(v, m, include_vertices, v);
}

void view_join(view_box *box, const view_box *other)
{
    box->low = nkw_vec3_min(box->low, other->low);
    box->high = nkw_vec3_max(box->high, other->high);
    box->least = nkw_vec3_min(box->least, other->least);
    box->most = nkw_vec3_max(box->most, other->most);
    box->sole = nkw_min(box->sole, other->sole);
}

/* From above: the world's y has a share of the eye's z. */
static int sees_floor(const view *v)
{
    return v->eye.m[6] > 0.02f;
}

void view_include_shadow(view *v, view_box *box)
{
    float edge = box->sole + box->least.y * v->eye.m[5];
    if (sees_floor(v) && edge < box->low.y)
        box->low.y = edge;
}

/* From the box to the units of the canvas, with a margin of 4 %. */
typedef struct frame {
    const view *view;
    canvas *canvas;
    float scale;
} frame;

static frame frame_of(const view *v, canvas *c)
{
    const view_box *b = &v->box;
    float wide = nkw_max(b->high.x - b->low.x, 1e-20f), high = nkw_max(b->high.y - b->low.y, 1e-20f);
    frame f = {v, c, 0.92f * nkw_min(c->width / wide, c->height / high)};
    return f;
}

static nkw_vec3 to_canvas(const frame *f, nkw_vec3 world)
{
    const view_box *b = &f->view->box;
    nkw_vec3 p = nkw_mat4_transform_point(&f->view->eye, world);
    nkw_vec3 out = {0.5f * f->canvas->width + f->scale * (p.x - 0.5f * (b->low.x + b->high.x)),
                    0.5f * f->canvas->height - f->scale * (p.y - 0.5f * (b->low.y + b->high.y)), p.z};
    return out;
}

/* ---- the floor ---- */

static const nkw_vec3 paper = {0.86f, 0.88f, 0.91f}, shade = {0.6f, 0.63f, 0.68f}, rule = {0.7f, 0.73f, 0.78f};

nkw_vec3 view_paper(void)
{
    return paper;
}

/* The shadow of a primitive on the floor below it. */
static void drop_shadow(void *user, moment *m, const nkw_document_primitive *p)
{
    const frame *f = user;
    for (size_t t = 0; p->topology == NKW_DOCUMENT_TRIANGLES && t + 2 < p->index_count; t += 3) {
        nkw_vec3 place[3];
        for (size_t i = 0; i < 3; i++) {
            nkw_vec3 at = m->positions[p->indices[t + i]];
            at.y = f->view->box.least.y;
            place[i] = to_canvas(f, at);
        }
        f->canvas->shadow(f->canvas, place, shade);
    }
}

/* 1, 2 or 5 times a power of ten, the largest that is at most 12 % of a length. */
static float rule_step(float length)
{
    float step = 1e-20f;
    while (step * 10.0f <= 0.12f * length && step < 1e20f)
        step *= 10.0f;
    return step * (step * 5.0f <= 0.12f * length ? 5.0f : step * 2.0f <= 0.12f * length ? 2.0f : 1.0f);
}

enum { RULES = 16 };

/* One piece of a line of the floor, paler with the distance from the middle of the box. */
static void draw_rule(const frame *f, nkw_vec3 a, nkw_vec3 b, nkw_vec3 middle, float radius)
{
    nkw_vec3 away = nkw_vec3_sub(nkw_vec3_lerp(a, b, 0.5f), middle);
    float distance = nkw_vec3_length(away) / radius;
    const nkw_vec3 ends[2] = {to_canvas(f, a), to_canvas(f, b)};
    if (distance < 1.0f)
        f->canvas->line(f->canvas, CANVAS_FLOOR, ends, f->canvas->unit, nkw_vec3_lerp(rule, paper, distance));
}

static void draw_rules(const frame *f, float step, nkw_vec3 middle)
{
    float x0 = floorf(middle.x / step), z0 = floorf(middle.z / step), radius = step * (float)RULES;
    for (int i = -RULES; i <= RULES; i++)
        for (int k = -RULES; k < RULES; k++) {
            float x = step * (x0 + (float)i), z = step * (z0 + (float)k);
            nkw_vec3 a = {x, middle.y, z}, b = {x, middle.y, z + step};
            draw_rule(f, a, b, middle, radius);
            x = step * (x0 + (float)k), z = step * (z0 + (float)i);
            nkw_vec3 c = {x, middle.y, z}, d = {x + step, middle.y, z};
            draw_rule(f, c, d, middle, radius);
        }
}

void view_draw_floor(const view *v, moment *m, canvas *c)
{
    const view_box *b = &v->box;
    frame f = frame_of(v, c);
    nkw_vec3 size = nkw_vec3_sub(b->most, b->least), middle = nkw_vec3_lerp(b->least, b->most, 0.5f);
    float length = nkw_max(size.x, nkw_max(size.z, size.y));
    if (!sees_floor(v) || !(length > 0.0f) || !isfinite(length))
        return;
    middle = nkw_vec3_add(middle, v->origin);
    middle.y = b->least.y;
    visit_primitives(v, m, drop_shadow, &f);
    draw_rules(&f, rule_step(length), middle);
}

/* ---- drawing ---- */

static nkw_vec3 colour_at(const nkw_document *d, const nkw_document_primitive *p, size_t vertex)
{
    nkw_vec3 colour = {0.62f, 0.62f, 0.64f};
    if (p->material >= 0) {
        const float *c = d->materials[p->material].color;
        nkw_vec3 own = {nkw_clamp(c[0], 0.0f, 1.0f), nkw_clamp(c[1], 0.0f, 1.0f), nkw_clamp(c[2], 0.0f, 1.0f)};
        colour = own;
    }
    if (p->colors) {
        const float *c = p->colors + 4 * vertex;
        nkw_vec3 times = {nkw_clamp(c[0], 0.0f, 1.0f), nkw_clamp(c[1], 0.0f, 1.0f), nkw_clamp(c[2], 0.0f, 1.0f)};
        colour.x *= times.x, colour.y *= times.y, colour.z *= times.z;
    }
    return colour;
}

/* The texture coordinates of the picture of a primitive; NULL without a material, or without its set. */
static const float *texcoords_of(const nkw_document *d, const nkw_document_primitive *p)
{
    const size_t set = p->material >= 0 ? d->materials[p->material].image_texcoords : SIZE_MAX;
    return set < p->texcoord_count ? p->texcoords[set] : NULL;
}

static const texture *texture_of(const view *v, const nkw_document *document, const nkw_document_primitive *p)
{
    const texture *t = texcoords_of(document, p) ? &v->textures[p->material] : NULL;
    return t && t->level_count ? t : NULL;
}

static void draw_triangles(const frame *f, moment *m, const nkw_document_primitive *p)
{
    const texture *t = texture_of(f->view, m->document, p);
    const float *uv = texcoords_of(m->document, p);
    for (size_t k = 0; k + 2 < p->index_count; k += 3) {
        canvas_corner corner[3];
        const uint32_t *index = p->indices + k;
        nkw_vec3 a = m->positions[index[0]], b = m->positions[index[1]], c = m->positions[index[2]];
        nkw_vec3 face = nkw_vec3_cross(nkw_vec3_sub(b, a), nkw_vec3_sub(c, a));
        for (int i = 0; i < 3; i++) {
            corner[i].place = to_canvas(f, m->positions[index[i]]);
            corner[i].normal = nkw_mat4_transform_direction(&f->view->eye, p->normals ? m->normals[index[i]] : face);
            corner[i].colour = colour_at(m->document, p, index[i]);
            corner[i].u = t ? uv[2 * index[i]] : 0.0f;
            corner[i].v = t ? uv[2 * index[i] + 1] : 0.0f;
        }
        f->canvas->triangle(f->canvas, corner, t);
    }
}

/* Points and lines have no side to be lit. */
static void draw_lines(const frame *f, moment *m, const nkw_document_primitive *p)
{
    const size_t corners = p->topology == NKW_DOCUMENT_LINES ? 2 : 1;
    const float width = (corners == 2 ? 1.6f : 3.2f) * f->canvas->unit;
    for (size_t k = 0; k + corners <= p->index_count; k += corners) {
        nkw_vec3 ends[2] = {to_canvas(f, m->positions[p->indices[k]]),
                            to_canvas(f, m->positions[p->indices[k + corners - 1]])};
        nkw_vec3 colour = nkw_vec3_scale(colour_at(m->document, p, p->indices[k]), 0.8f);
        f->canvas->line(f->canvas, CANVAS_SCENE, ends, width, colour);
    }
}

static void draw_primitive(void *user, moment *m, const nkw_document_primitive *p)
{
    if (p->topology == NKW_DOCUMENT_TRIANGLES)
        draw_triangles(user, m, p);
    else
        draw_lines(user, m, p);
}

/* Each bone is orange with a dark rim, each joint a light disc with a dark rim. */
static void draw_bones(const frame *f, const moment *m)
{
    const nkw_vec3 rim = {0.05f, 0.05f, 0.07f}, bone = {0.9f, 0.25f, 0.02f}, joint = {0.95f, 0.9f, 0.8f};
    const int32_t *parents = m->document->skeleton.parents;
    const view *v = f->view;
    canvas *c = f->canvas;
    float width = nkw_max(0.9f * c->unit, 0.0075f * c->width), edge = 0.7f * c->unit;
    for (int pass = 0; pass < 4; pass++)
        for (size_t j = 0; j < m->document->skeleton.joint_count; j++) {
            if (!v->shown[j] || !v->bones[j])
                continue;
            nkw_vec3 ends[2] = {to_canvas(f, nkw_mat4_translation(&m->models[j])),
                                to_canvas(f, nkw_mat4_translation(&m->models[j]))};
            if (pass >= 2)
                c->line(c, CANVAS_OVER, ends, pass == 2 ? 1.9f * width + edge : 1.9f * width - edge,
                        pass == 2 ? rim : joint);
            if (pass >= 2 || parents[j] < 0 || !v->bones[parents[j]])
                continue;
            ends[0] = to_canvas(f, nkw_mat4_translation(&m->models[parents[j]]));
            c->line(c, CANVAS_OVER, ends, pass == 0 ? width + 2.0f * edge : width, pass == 0 ? rim : bone);
        }
}

/* A motion capture has joints only. */
static int shows_mesh(const view *v, const nkw_document *d)
{
    for (size_t j = 0; j < d->skeleton.joint_count; j++) {
        const nkw_document_mesh *mesh = mesh_of(v, d, j);
        for (size_t p = 0; mesh && p < mesh->primitive_count; p++)
            if (mesh->primitives[p].positions)
                return 1;
    }
    return 0;
}

void view_draw(const view *v, moment *m, canvas *c, int skeleton)
{
    frame f = frame_of(v, c);
    visit_primitives(v, m, draw_primitive, &f);
    if (skeleton || !shows_mesh(v, m->document))
        draw_bones(&f, m);
}
