/* SPDX-License-Identifier: MIT */
#include "assimp_fbx.h"

#include <stdio.h>
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/transform.h>
#include <nakawari/vec.h>

int nkwi_assimp_fbx_fail(nkwi_assimp *a)
{
    char place[32];
    const nkwi_fbx_tree *tree = &a->fbx->file.tree;
    snprintf(place, sizeof place, "byte %zu", tree->at);
    return nkwi_fail_at(a->error, tree->at ? place : "", NKW_IMPORT_INVALID, "FBX: %s", tree->fault);
}

/* ---- models of nodes ---- */

/* Assimp adds digits to a name that another node has already. */
static int is_name(const nkwi_fbx *f, size_t object, const char *name)
{
    char text[1024];
    nkwi_fbx_name(f, object, text, sizeof text);
    return strncmp(name, text, strlen(text)) == 0;
}

/* The Model of the next node below an object, from the connection *link on. */
static size_t next_model(const nkwi_fbx *f, size_t parent, size_t *link, const char *name)
{
    const nkwi_fbx_object *o = &f->objects[parent];
    for (size_t i = *link; i < o->link_count; i++) {
        const nkwi_fbx_link *l = &f->links[o->first_link + i];
        if (l->property || !nkwi_fbx_is_kind(f, l->from, "Model") || !is_name(f, l->from, name))
            continue;
        *link = i + 1;
        return l->from;
    }
    return NKWI_FBX_NONE;
}

/* The nodes of Assimp are in the order of the connections. A node that is none of them keeps its matrix. */
static int find_models(nkwi_assimp *a)
{
    nkwi_assimp_fbx *f = a->fbx;
    size_t *links = (size_t *)nkwi_assimp_scratch(a, "nodes", a->node_count, sizeof *links);
    if (!links)
        return 0;
    for (size_t i = 0; i < a->node_count; i++) {
        const size_t parent = i == 0 ? NKWI_FBX_NONE : f->models[a->parents[i]].object;
        const char *name = a->nodes[i]->mName.data;
        const size_t object = i == 0                    ? f->file.root
                              : parent == NKWI_FBX_NONE ? parent
                                                        : next_model(&f->file, parent, &links[a->parents[i]], name);
        if (object == NKWI_FBX_NONE &&
            !nkwi_document_warn(a->document, a->error, "%s: its keys are not found, and it stays at rest", name))
            return 0;
        f->models[i].object = object;
        if (object == NKWI_FBX_NONE || i == 0)
            continue;
        f->models[i] = nkwi_fbx_model_of(&f->file, object);
        if (f->models[i].is_spheric &&
            !nkwi_document_warn(a->document, a->error, "%s: its spheric rotation is read as XYZ", name))
            return 0;
    }
    return 1;
}

static int has_model(const nkwi_assimp_fbx *f, size_t node)
{
    return node > 0 && f->models[node].object != NKWI_FBX_NONE;
}

/* A parent without a Model passes its scale on as any node does. */
static int has_mode(const nkwi_assimp *a, size_t node)
{
    return has_model(a->fbx, node) && a->fbx->models[node].inherit != NKWI_FBX_RSRS && a->parents[node] > 0 &&
           has_model(a->fbx, (size_t)a->parents[node]);
}

int nkwi_assimp_fbx_is_apart(const nkwi_assimp *a, size_t node)
{
    return a->fbx && has_mode(a, node);
}

static int is_animated(const nkwi_assimp_fbx *f, size_t object, const char *property)
{
    for (size_t i = 0; i < f->stack_count; i++) {
        size_t count;
        if (nkwi_fbx_channels(&f->stacks[i], object, property, &count))
            return 1;
    }
    return 0;
}

static void find_scales(nkwi_assimp *a)
{
    nkwi_assimp_fbx *f = a->fbx;
    for (size_t i = 0; i < a->node_count; i++) {
        f->inherits[i] = NKW_NO_JOINT;
        if (!has_model(f, i))
            continue;
        const nkw_vec3 s = f->models[i].scaling;
        if (has_mode(a, i))
            f->inherits[i] = f->models[i].inherit == NKWI_FBX_RRSS ? a->parents[i] : f->inherits[a->parents[i]];
        f->is_scaled[i] = s.x != 1.0f || s.y != 1.0f || s.z != 1.0f ||
                          is_animated(f, f->models[i].object, "Lcl Scaling") ||
                          (f->inherits[i] >= 0 && f->is_scaled[f->inherits[i]]);
    }
}

/* ---- transforms ---- */

void nkwi_assimp_fbx_choose(nkwi_assimp *a, const nkwi_fbx_stack *stack)
{
    static const char *const names[] = {"Lcl Translation", "Lcl Rotation", "Lcl Scaling"};
    nkwi_assimp_fbx *f = a->fbx;
    for (size_t i = 1; i < a->node_count; i++) {
        const nkwi_fbx_model *m = &f->models[i];
        const nkw_vec3 rest[] = {m->translation, m->rotation, m->scaling};
        for (int k = 0; has_model(f, i) && k < 3; k++) {
            nkwi_fbx_animated one = {stack, NULL, 0, rest[k], m->order, "TRS"[k]};
            if (stack)
                one.channels = nkwi_fbx_channels(stack, m->object, names[k], &one.count);
            f->animated[i][k] = one;
        }
    }
}

nkw_vec3 nkwi_assimp_fbx_scale(const nkwi_assimp *a, size_t node, float time)
{
    const nkwi_assimp_fbx *f = a->fbx;
    nkw_vec3 scale = nkwi_fbx_sample(&f->animated[node][2], time);
    for (int32_t i = f->inherits[node]; i >= 0; i = f->inherits[i])
        scale = nkw_vec3_mul(scale, nkwi_fbx_sample(&f->animated[i][2], time));
    return scale;
}

void nkwi_assimp_fbx_local(const nkwi_assimp *a, size_t node, nkw_clip_target target, float time, float *out)
{
    const nkwi_assimp_fbx *f = a->fbx;
    const nkwi_fbx_model *m = &f->models[node];
    nkw_vec3 v;
    nkw_quat q = {0.0f, 0.0f, 0.0f, 1.0f};
    if (target == NKW_CLIP_ROTATION || m->has_pivot)
        q = nkwi_fbx_rotation(m, nkwi_fbx_sample(&f->animated[node][1], time));
    if (target == NKW_CLIP_ROTATION) {
        memcpy(out, &q, sizeof q);
        return;
    }
    if (target == NKW_CLIP_SCALE)
        v = nkwi_assimp_fbx_scale(a, node, time);
    else {
        const nkw_vec3 none = {1.0f, 1.0f, 1.0f},
                       s = m->has_pivot ? nkwi_fbx_sample(&f->animated[node][2], time) : none;
        v = nkwi_fbx_translation(m, nkwi_fbx_sample(&f->animated[node][0], time), q, s);
        if (has_mode(a, node))
            v = nkw_vec3_mul(v, nkwi_assimp_fbx_scale(a, (size_t)a->parents[node], time));
    }
    memcpy(out, &v, sizeof v);
}

/* ---- nodes of the document ---- */

/* One node more: at `*number`, below the one before. */
static void add_extra(nkwi_assimp *a, size_t node, nkwi_assimp_extra_kind kind, size_t parent, const nkw_trs *rest)
{
    const nkwi_assimp_extra extra = {node, kind, parent, *rest};
    a->extras[a->extra_count++] = extra;
}

static int has_bones(const nkwi_assimp *a, size_t node)
{
    const struct aiNode *n = a->nodes[node];
    for (unsigned i = 0; i < n->mNumMeshes; i++)
        if (n->mMeshes[i] < a->scene->mNumMeshes && a->scene->mMeshes[n->mMeshes[i]]->mNumBones > 0)
            return 1;
    return 0;
}

/* The matrices at rest, and the nodes that a scale and a geometric transform need. */
static int place_nodes(nkwi_assimp *a)
{
    nkwi_assimp_fbx *f = a->fbx;
    a->extras = (nkwi_assimp_extra *)nkwi_assimp_scratch(a, "nodes", 2 * a->node_count, sizeof *a->extras);
    if (!a->extras)
        return 0;
    for (size_t i = a->node_count; i-- > 1;)
        if (has_mode(a, i) && f->is_scaled[a->parents[i]])
            a->is_split[a->parents[i]] = 1;
    nkwi_assimp_fbx_choose(a, NULL);
    for (size_t i = 1; i < a->node_count; i++) {
        nkw_trs rest = {{0, 0, 0}, {0, 0, 0, 1}, {1, 1, 1}}, scale = rest;
        if (!has_model(f, i))
            continue;
        nkwi_assimp_fbx_local(a, i, NKW_CLIP_TRANSLATION, 0.0f, &rest.translation.x);
        nkwi_assimp_fbx_local(a, i, NKW_CLIP_ROTATION, 0.0f, &rest.rotation.x);
        scale.scale = nkwi_assimp_fbx_scale(a, i, 0.0f);
        rest.scale = a->is_split[i] ? rest.scale : scale.scale;
        a->locals[i] = nkw_mat4_from_trs(&rest);
        a->rests[i] = rest;
        if (a->is_split[i])
            add_extra(a, i, NKWI_ASSIMP_SCALE, i, &scale);
        a->carrier[i] = a->is_split[i] ? a->node_count + a->extra_count - 1 : i;
        a->mesh_carrier[i] = a->carrier[i];
        if (f->models[i].has_geometry && a->nodes[i]->mNumMeshes > 0 && !has_bones(a, i)) {
            add_extra(a, i, NKWI_ASSIMP_GEOMETRY, a->carrier[i], &f->models[i].geometry);
            a->mesh_carrier[i] = a->node_count + a->extra_count - 1;
        }
    }
    return 1;
}

/* The stacks of the file, which are objects in its order. */
static int read_stacks(nkwi_assimp *a)
{
    nkwi_assimp_fbx *f = a->fbx;
    const nkwi_fbx_tree *tree = &f->file.tree;
    size_t count = 0;
    for (size_t i = 0; i < f->file.object_count; i++)
        count += (size_t)nkwi_fbx_is_kind(&f->file, i, "AnimationStack");
    f->stacks = (nkwi_fbx_stack *)nkwi_assimp_scratch(a, "animations", count, sizeof *f->stacks);
    const size_t list = nkwi_fbx_find(tree, tree->root, "Objects");
    for (size_t n = nkwi_fbx_below(tree, list, "AnimationStack"); f->stacks && n != NKWI_FBX_NONE;
         n = nkwi_fbx_find(tree, tree->nodes[n].next, "AnimationStack")) {
        size_t object = 0;
        while (object < f->file.object_count && f->file.objects[object].node != n)
            object++;
        if (object < f->file.object_count && !nkwi_fbx_stack_read(&f->file, object, &f->stacks[f->stack_count++]))
            return nkwi_assimp_fbx_fail(a);
    }
    return f->stacks != NULL;
}

/* UpAxis and the like are 0, 1, 2 for x, y, z, each with a sign. 0 if the file states none. */
static int read_axis(const nkwi_fbx *f, size_t list, const char *name, const char *sign)
{
    const double axis = nkwi_fbx_listed_number(f, list, name, -1.0);
    const int number = axis >= 0.0 && axis < 3.0 ? (int)axis + 1 : 0;
    return nkwi_fbx_listed_number(f, list, sign, 1.0) < 0.0 ? -number : number;
}

/*
 * FrontAxis points to the viewer, as a character does; CoordAxis to the right of the viewer, which is the left of the
 * character. A unit is UnitScaleFactor centimetres.
 */
static void read_space(nkwi_assimp *a)
{
    const nkwi_fbx *f = &a->fbx->file;
    const size_t list = nkwi_fbx_below(&f->tree, f->settings, "Properties70");
    const int right = read_axis(f, list, "CoordAxis", "CoordAxisSign");
    const nkw_axes axes = {(nkw_axis)-right, (nkw_axis)read_axis(f, list, "UpAxis", "UpAxisSign"),
                           (nkw_axis)read_axis(f, list, "FrontAxis", "FrontAxisSign")};
    const double unit = nkwi_fbx_listed_number(f, list, "UnitScaleFactor", list == NKWI_FBX_NONE ? 0.0 : 1.0);
    nkw_document_space *space = &a->document->all.space;
    if (axes.right && axes.up && axes.forward && nkw_axes_map_is_valid(nkw_axes_map_from_axes(axes, axes)))
        space->axes = axes;
    space->metres = unit > 1e-9 && unit < 1e9 ? (float)(0.01 * unit) : 0.0f;
}

/* What moves by other rules than curves and linear skins. */
static int warn_lost(nkwi_assimp *a)
{
    const nkwi_fbx *f = &a->fbx->file;
    size_t constraints = 0, dual = 0;
    for (size_t i = 0; i < f->object_count; i++) {
        const size_t sort = nkwi_fbx_is_kind(f, i, "Deformer")
                                ? nkwi_fbx_below(&f->tree, f->objects[i].node, "SkinningType")
                                : NKWI_FBX_NONE;
        const nkwi_fbx_value *name = nkwi_fbx_at(&f->tree, sort, 0);
        constraints += (size_t)nkwi_fbx_is_kind(f, i, "Constraint");
        dual += nkwi_fbx_equals(name, "DualQuaternion") || nkwi_fbx_equals(name, "Blend");
    }
    if (constraints > 0 && !nkwi_document_warn(a->document, a->error, "%zu constraints are not applied", constraints))
        return 0;
    return dual == 0 ||
           nkwi_document_warn(a->document, a->error, "%zu skins by dual quaternions are linear skins here", dual);
}

int nkwi_assimp_fbx_open(nkwi_assimp *a, const nkw_import_memory *memory)
{
    if (!strstr(a->document->all.format, "FBX"))
        return 1;
    a->fbx = (nkwi_assimp_fbx *)nkwi_assimp_scratch(a, "nodes", 1, sizeof *a->fbx);
    if (!a->fbx)
        return 0;
    nkwi_assimp_fbx *f = a->fbx;
    f->models = (nkwi_fbx_model *)nkwi_assimp_scratch(a, "nodes", a->node_count, sizeof *f->models);
    f->inherits = (int32_t *)nkwi_assimp_scratch(a, "nodes", a->node_count, sizeof *f->inherits);
    f->is_scaled = (unsigned char *)nkwi_assimp_scratch(a, "nodes", a->node_count, 1);
    f->animated = (nkwi_fbx_animated(*)[3])nkwi_assimp_scratch(a, "nodes", a->node_count, sizeof *f->animated);
    if (!f->models || !f->inherits || !f->is_scaled || !f->animated)
        return 0;
    if (!nkwi_fbx_begin(&f->file, &a->scratch, memory->data, memory->bytes))
        return nkwi_assimp_fbx_fail(a);
    read_space(a);
    if (!read_stacks(a) || !find_models(a) || !warn_lost(a))
        return 0;
    find_scales(a);
    return place_nodes(a);
}

void nkwi_assimp_fbx_close(nkwi_assimp *a)
{
    if (a->fbx)
        nkwi_fbx_end(&a->fbx->file);
}
