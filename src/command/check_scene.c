/* SPDX-License-Identifier: MIT */
/* Scenes, names of joints, pictures beside the file, and how large skins are. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/box.h>
#include <nakawari/mat.h>

#include "check.h"
#include "moment.h"

/* ---- scenes ---- */

static int32_t root_of(const nkw_document *d, int32_t joint)
{
    while (d->skeleton.parents[joint] != NKW_NO_JOINT)
        joint = d->skeleton.parents[joint];
    return joint;
}

static int has_root(const nkw_document_scene *scene, int32_t root)
{
    for (size_t i = 0; i < scene->root_count; i++)
        if (scene->roots[i] == root)
            return 1;
    return 0;
}

/* The first joint of the skin of a node that is not in a scene which has the node. */
static void check_skinned(check *c, size_t node, const nkw_document_scene *scene)
{
    const nkw_document *d = c->document;
    const nkw_document_skin *skin = &d->skins[d->nodes[node].skin];
    size_t outside = 0, first = 0;
    for (size_t i = 0; i < skin->joint_count; i++)
        if (!has_root(scene, root_of(d, skin->joints[i])))
            first = outside++ ? first : i;
    if (!outside)
        return;
    finding f =
        check_finding_at(SEVERITY_WARNING, "joint-outside-scene", "skin", skin->name, (size_t)d->nodes[node].skin);
    f.amount = (double)outside;
    snprintf(f.detail, sizeof f.detail, "%zu %s not in the scene of its mesh, as %.80s",
             COUNT(outside, "joint is", "joints are"), d->nodes[skin->joints[first]].name);
    findings_add(&c->found, &f);
}

static void check_scenes(check *c)
{
    const nkw_document *d = c->document;
    for (size_t s = 0; s < d->scene_count; s++) {
        finding f = check_finding_at(SEVERITY_WARNING, "empty-scene", "scene", d->scenes[s].name, s);
        snprintf(f.detail, sizeof f.detail, "it has no nodes");
        if (d->scenes[s].root_count == 0)
            findings_add(&c->found, &f);
        for (size_t j = 0; j < d->skeleton.joint_count; j++)
            if (d->nodes[j].skin >= 0 && has_root(&d->scenes[s], root_of(d, (int32_t)j)))
                check_skinned(c, j, &d->scenes[s]);
    }
}

/* ---- names ---- */

static int by_name(const void *a, const void *b)
{
    return strcmp((*(const nkw_document_node *const *)a)->name, (*(const nkw_document_node *const *)b)->name);
}

/* The nodes that are joints of skins or animated. Returns their number. */
static size_t list_joints(const nkw_document *d, const nkw_document_node **list, unsigned char *listed)
{
    size_t count = 0;
    for (size_t s = 0; s < d->skin_count; s++)
        for (size_t i = 0; i < d->skins[s].joint_count; i++)
            listed[d->skins[s].joints[i]] = 1;
    for (size_t a = 0; a < d->animation_count; a++)
        for (size_t i = 0; i < d->animations[a].track_count; i++)
            listed[d->animations[a].channels[i].joint] = 1;
    for (size_t j = 0; j < d->skeleton.joint_count; j++)
        if (listed[j])
            list[count++] = &d->nodes[j];
    return count;
}

static void check_names(check *c)
{
    const size_t joints = c->document->skeleton.joint_count;
    const nkw_document_node **list = calloc(joints, sizeof *list);
    unsigned char *listed = calloc(joints, 1);
    c->found.failed |= !list || !listed;
    const size_t count = list && listed ? list_joints(c->document, list, listed) : 0;
    if (count)
        qsort(list, count, sizeof *list, by_name);
    for (size_t i = 0, same; i < count; i += same) {
        for (same = 1; i + same < count && strcmp(list[i]->name, list[i + same]->name) == 0;)
            same++;
        finding f = check_finding_at(SEVERITY_NOTE, "equal-names", "node", list[i]->name, list[i]->number);
        f.amount = (double)same;
        snprintf(f.detail, sizeof f.detail, "%zu joints have this name: a tool that binds by names takes one of them",
                 same);
        if (same > 1)
            findings_add(&c->found, &f);
    }
    free(list);
    free(listed);
}

/* ---- pictures ---- */

static void check_images(check *c)
{
    const nkw_document *d = c->document;
    for (size_t i = 0; i < d->image_count && strcmp(d->format, "glTF 2.0") != 0; i++) {
        size_t bytes = 0;
        const char *path = d->images[i].data ? NULL : d->images[i].path;
        unsigned char *data = path ? input_read_beside(d, path, &bytes) : NULL;
        finding f = check_finding_at(SEVERITY_WARNING, "absent-image", "image", d->images[i].name, i);
        snprintf(f.detail, sizeof f.detail, "%.140s cannot be read", path ? path : "");
        if (path && !data)
            findings_add(&c->found, &f);
        free(data);
    }
}

/* ---- the size of skins ---- */

static double diagonal(const nkw_box *b)
{
    const double x = (double)b->high.x - (double)b->low.x, y = (double)b->high.y - (double)b->low.y;
    const double z = (double)b->high.z - (double)b->low.z;
    return x >= 0.0 ? sqrt(x * x + y * y + z * z) : 0.0;
}

/* The scale of joint times inverse bind matrix: the cube root of the determinant. The median joint is enough. */
static double scale_of(const moment *m, const nkw_document_skin *skin)
{
    const size_t i = skin->joint_count / 2;
    const double bind = fabs((double)nkw_mat4_determinant(&skin->inverse_bind[i]));
    const double model = fabs((double)nkw_mat4_determinant(&m->models[skin->joints[i]]));
    return cbrt(bind * model);
}

/*
 * In the rest pose the vertices of a skin are about as large as its skeleton, and joint times inverse bind matrix is about
 * 1. A file in other units has one of both otherwise, one whose matrices are scaled has both.
 */
static void check_size(check *c, moment *m, size_t node)
{
    const nkw_document *d = c->document;
    const nkw_document_skin *skin = &d->skins[d->nodes[node].skin];
    nkw_box vertices = NKW_BOX_EMPTY, joints = NKW_BOX_EMPTY;
    for (size_t i = 0; i < skin->joint_count; i++) {
        const float *t = m->models[skin->joints[i]].m;
        const nkw_box point = {{t[12], t[13], t[14]}, {t[12], t[13], t[14]}};
        joints = nkw_box_union(&joints, &point);
    }
    for (size_t p = 0; p < d->meshes[d->nodes[node].mesh].primitive_count; p++) {
        const nkw_document_primitive *primitive = &d->meshes[d->nodes[node].mesh].primitives[p];
        moment_vertices(m, node, p);
        const nkw_box part = nkw_box_from_points(m->positions, primitive->vertex_count);
        vertices = nkw_box_union(&vertices, &part);
    }
    const double ratio = diagonal(&vertices) / diagonal(&joints), scale = scale_of(m, skin);
    if (!(diagonal(&joints) > 0.0) || (ratio < 10.0 && ratio > 0.1) || (scale < 5.0 && scale > 0.2) || isnan(ratio))
        return;
    finding f = check_finding_at(SEVERITY_WARNING, "scaled-matrix", "skin", skin->name, (size_t)d->nodes[node].skin);
    f.amount = scale;
    snprintf(f.detail, sizeof f.detail,
             "joints scale vertices by %.3g at rest: they are %.3g times as large as the skeleton", scale, ratio);
    findings_add(&c->found, &f);
}

static void check_sizes(check *c)
{
    const nkw_document *d = c->document;
    moment m;
    if (d->skin_count == 0)
        return;
    if (moment_open(&m, d, INPUT_REST)) {
        moment_at(&m, 0.0f);
        for (size_t j = 0; j < d->skeleton.joint_count; j++)
            if (d->nodes[j].skin >= 0 && d->nodes[j].mesh >= 0 && d->skins[d->nodes[j].skin].inverse_bind)
                check_size(c, &m, j);
    } else
        c->found.failed = 1;
    moment_close(&m);
}

void check_scene(check *c)
{
    check_scenes(c);
    check_names(c);
    check_images(c);
    if (c->found.counts[SEVERITY_ERROR] == 0)
        check_sizes(c);
}
