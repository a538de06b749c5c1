/* SPDX-License-Identifier: MIT */
#include "reframe.h"

#include <string.h>

/* ---- axes ---- */

typedef struct named_axes {
    const char *name;
    nkw_axes axes;
} named_axes;

static const named_axes tools[] = {
    {"gltf", NKW_AXES_GLTF},
    {"maya", NKW_AXES_GLTF},
    {"vrm", NKW_AXES_GLTF},
    {"godot", NKW_AXES_GODOT},
    {"usd-y", NKW_AXES_USD_Y},
    {"usd-z", NKW_AXES_USD_Z},
    {"blender", NKW_AXES_BLENDER},
    {"max", NKW_AXES_BLENDER},
    {"unity", NKW_AXES_UNITY},
    {"directx", NKW_AXES_UNITY},
    {"unreal", NKW_AXES_UNREAL},
    {"unreal-mesh", NKW_AXES_UNREAL_MESH},
    {"opengl-camera", NKW_AXES_OPENGL_CAMERA},
    {"opencv-camera", NKW_AXES_OPENCV_CAMERA},
};

/* A signed letter: "x", "-z". Moves on beyond it; 0 if there is none. */
static int read_axis(const char **text, nkw_axis *axis)
{
    const int negative = **text == '-';
    *text += negative;
    if (**text < 'x' || **text > 'z')
        return 0;
    const int number = **text - 'x' + 1;
    *axis = (nkw_axis)(negative ? -number : number);
    ++*text;
    return 1;
}

static int read_comma(const char **text)
{
    const int found = **text == ',';
    *text += found;
    return found;
}

int reframe_axes(const char *text, nkw_axes *axes)
{
    for (size_t i = 0; i < sizeof tools / sizeof *tools; i++)
        if (strcmp(text, tools[i].name) == 0) {
            *axes = tools[i].axes;
            return 1;
        }
    return read_axis(&text, &axes->right) && read_comma(&text) && read_axis(&text, &axes->up) && read_comma(&text) &&
           read_axis(&text, &axes->forward) && *text == 0 &&
           nkw_axes_map_is_valid(nkw_axes_map_from_axes(*axes, *axes));
}

/* ---- the parts ---- */

typedef struct frame {
    model *m;
    nkw_axes_map map;
    float scale;
    int failed;
} frame;

/* Converted vectors in memory of the model, times a factor. NULL for NULL. */
static const nkw_vec3 *vectors(frame *f, const nkw_vec3 *v, size_t count, float factor)
{
    nkw_vec3 *out = v && !f->failed ? model_take(f->m, count, sizeof *out) : NULL;
    f->failed |= v && !out;
    for (size_t i = 0; out && i < count; i++) {
        const nkw_vec3 p = nkw_axes_convert_vec3(f->map, v[i]);
        out[i].x = factor * p.x, out[i].y = factor * p.y, out[i].z = factor * p.z;
    }
    return out;
}

static nkw_trs transform(const frame *f, const nkw_trs *t)
{
    nkw_trs r = nkw_axes_convert_trs(f->map, t);
    r.translation.x *= f->scale, r.translation.y *= f->scale, r.translation.z *= f->scale;
    return r;
}

static nkw_mat4 matrix(const frame *f, const nkw_mat4 *m)
{
    nkw_mat4 r = nkw_axes_convert_mat4(f->map, m);
    for (int i = 12; i < 15; i++)
        r.m[i] *= f->scale;
    return r;
}

static void change_nodes(frame *f)
{
    nkw_document *d = &f->m->document;
    const size_t count = d->skeleton.joint_count;
    nkw_document_node *nodes = model_take(f->m, count, sizeof *nodes);
    nkw_mat4 *matrices = model_take(f->m, count, sizeof *matrices);
    float *rest = model_take(f->m, nkw_pose_floats(count), sizeof *rest);
    f->failed |= !nodes || !matrices || !rest;
    if (f->failed)
        return;
    const nkw_pose_span pose = {rest, count};
    nkw_pose_identity(pose);
    for (size_t j = 0; j < count; j++) {
        const nkw_trs original = nkw_pose_get(d->rest, j), t = transform(f, &original);
        nodes[j] = d->nodes[j];
        nodes[j].rest = transform(f, &d->nodes[j].rest);
        if (nodes[j].matrix) {
            matrices[j] = matrix(f, nodes[j].matrix);
            nodes[j].matrix = &matrices[j];
        }
        nkw_pose_set(pose, j, &t);
    }
    d->nodes = nodes;
    d->rest = NKW_VIEW(nkw_pose, pose);
}

static void change_skins(frame *f)
{
    nkw_document *d = &f->m->document;
    nkw_document_skin *skins = model_take(f->m, d->skin_count, sizeof *skins);
    f->failed |= !skins;
    for (size_t i = 0; !f->failed && i < d->skin_count; i++) {
        skins[i] = d->skins[i];
        nkw_mat4 *inverse = model_take(f->m, skins[i].joint_count, sizeof *inverse);
        f->failed |= !inverse;
        for (size_t k = 0; inverse && skins[i].inverse_bind && k < skins[i].joint_count; k++)
            inverse[k] = matrix(f, &skins[i].inverse_bind[k]);
        skins[i].inverse_bind = skins[i].inverse_bind ? inverse : NULL;
    }
    if (skins)
        d->skins = skins;
}

/* x y z and the sign of the bitangent, which a mirror negates. */
static const float *tangents(frame *f, const float *from, size_t count)
{
    const float sign = nkw_axes_map_is_mirror(f->map) ? -1.0f : 1.0f;
    float *out = from && !f->failed ? model_take(f->m, 4 * count, sizeof *out) : NULL;
    f->failed |= from && !out;
    for (size_t i = 0; out && i < count; i++) {
        const nkw_vec3 v = {from[4 * i], from[4 * i + 1], from[4 * i + 2]}, t = nkw_axes_convert_vec3(f->map, v);
        memcpy(out + 4 * i, &t, sizeof t);
        out[4 * i + 3] = sign * from[4 * i + 3];
    }
    return out;
}

/* A mirror reverses the order of the vertices of triangles. */
static const uint32_t *indices(frame *f, const nkw_document_primitive *p)
{
    uint32_t *out;
    if (p->topology != NKW_DOCUMENT_TRIANGLES || !nkw_axes_map_is_mirror(f->map))
        return p->indices;
    out = f->failed ? NULL : model_take(f->m, p->index_count, sizeof *out);
    f->failed |= !out;
    for (size_t i = 0; out && i < p->index_count; i++)
        out[i] = p->indices[i % 3 == 0 || i + 3 - i % 3 > p->index_count ? i : i % 3 == 1 ? i + 1 : i - 1];
    return out;
}

static void change_primitive(frame *f, nkw_document_primitive *p)
{
    nkw_document_target *targets = model_take(f->m, p->target_count, sizeof *targets);
    f->failed |= !targets;
    p->indices = indices(f, p);
    p->positions = vectors(f, p->positions, p->vertex_count, f->scale);
    p->box = nkw_box_from_points(p->positions, p->positions ? p->vertex_count : 0);
    p->normals = vectors(f, p->normals, p->vertex_count, 1.0f);
    p->tangents = tangents(f, p->tangents, p->vertex_count);
    for (size_t i = 0; !f->failed && i < p->target_count; i++) {
        targets[i].positions = vectors(f, p->targets[i].positions, p->vertex_count, f->scale);
        targets[i].normals = vectors(f, p->targets[i].normals, p->vertex_count, 1.0f);
        targets[i].tangents = vectors(f, p->targets[i].tangents, p->vertex_count, 1.0f);
    }
    p->targets = targets;
}

static void change_meshes(frame *f)
{
    nkw_document *d = &f->m->document;
    nkw_document_mesh *meshes = model_take(f->m, d->mesh_count, sizeof *meshes);
    f->failed |= !meshes;
    for (size_t i = 0; !f->failed && i < d->mesh_count; i++) {
        meshes[i] = d->meshes[i];
        nkw_document_primitive *parts = model_take(f->m, meshes[i].primitive_count, sizeof *parts);
        f->failed |= !parts;
        for (size_t k = 0; !f->failed && k < meshes[i].primitive_count; k++) {
            parts[k] = meshes[i].primitives[k];
            change_primitive(f, &parts[k]);
        }
        meshes[i].primitives = parts;
    }
    if (meshes)
        d->meshes = meshes;
}

/* Values and tangents are converted alike: tangents are values per second. */
static void change_track(frame *f, nkw_clip_track *track)
{
    static const nkw_axes_kind kinds[] = {NKW_AXES_VEC3, NKW_AXES_QUAT, NKW_AXES_SCALE};
    nkw_track *t = &track->track;
    const size_t count = nkw_track_value_count(t);
    if (track->target == NKW_CLIP_FLOATS || count == SIZE_MAX)
        return;
    float *out = model_take(f->m, count, sizeof *out);
    f->failed |= !out;
    if (!out)
        return;
    nkw_axes_convert_values(f->map, t->values, count / t->width, kinds[track->target], out);
    for (size_t i = 0; track->target == NKW_CLIP_TRANSLATION && i < count; i++)
        out[i] *= f->scale;
    t->values = out;
}

int reframe(model *m, nkw_axes_map map, float scale)
{
    frame f = {m, map, scale, 0};
    change_nodes(&f);
    change_skins(&f);
    change_meshes(&f);
    for (size_t a = 0; a < m->document.animation_count; a++)
        for (size_t i = 0; !f.failed && i < m->animations[a].track_count; i++)
            change_track(&f, model_tracks(m, a) + i);
    return !f.failed;
}
