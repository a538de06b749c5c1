/* SPDX-License-Identifier: MIT */
/* What FBX states of meshes beside Assimp: geometric transforms, bind poses of clusters, weights of blend shapes. */
#include <math.h>
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/transform.h>

#include "assimp_fbx.h"

/* Whether an object is a Deformer or Geometry of this sort, which its third value names. */
static int is_sort(const nkwi_fbx *f, size_t object, const char *kind, const char *sort)
{
    return nkwi_fbx_is_kind(f, object, kind) &&
           (!sort || nkwi_fbx_equals(nkwi_fbx_at(&f->tree, f->objects[object].node, 2), sort));
}

/* The next object of a sort that is connected to another, from the connection *link on. */
static size_t next_of(const nkwi_fbx *f, size_t to, const char *kind, const char *sort, size_t *link)
{
    const nkwi_fbx_object *o = &f->objects[to];
    while (*link < o->link_count) {
        const nkwi_fbx_link *l = &f->links[o->first_link + (*link)++];
        if (!l->property && is_sort(f, l->from, kind, sort))
            return l->from;
    }
    return NKWI_FBX_NONE;
}

static size_t geometry_of(const nkwi_assimp *a, size_t node)
{
    size_t link = 0;
    const size_t object = node > 0 ? a->fbx->models[node].object : NKWI_FBX_NONE;
    return object == NKWI_FBX_NONE ? object : next_of(&a->fbx->file, object, "Geometry", NULL, &link);
}

void nkwi_assimp_fbx_geometry(const nkwi_assimp *a, size_t node, nkw_mat4 *matrix)
{
    const nkwi_fbx_model *m = &a->fbx->models[node];
    if (node > 0 && m->object != NKWI_FBX_NONE && m->has_geometry)
        *matrix = nkw_mat4_from_trs(&m->geometry);
}

/* The cluster of a bone in a skin of the geometry. */
static size_t find_cluster(const nkwi_fbx *f, size_t geometry, size_t bone)
{
    size_t skin, cluster, at = 0;
    while ((skin = next_of(f, geometry, "Deformer", "Skin", &at)) != NKWI_FBX_NONE) {
        size_t link = 0;
        while ((cluster = next_of(f, skin, "Deformer", "Cluster", &link)) != NKWI_FBX_NONE) {
            size_t models = 0;
            if (next_of(f, cluster, "Model", NULL, &models) == bone)
                return cluster;
        }
    }
    return NKWI_FBX_NONE;
}

/* Transform is the mesh in the space of the bone, both in the bind pose. */
int nkwi_assimp_fbx_bind(nkwi_assimp *a, size_t node, size_t bone, nkw_mat4 *matrix)
{
    nkwi_fbx *f = &a->fbx->file;
    const size_t geometry = geometry_of(a, node);
    const size_t cluster =
        geometry == NKWI_FBX_NONE ? geometry : find_cluster(f, geometry, a->fbx->models[bone].object);
    nkw_mat4 bind, own = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
    size_t count = 0;
    if (cluster == NKWI_FBX_NONE)
        return 1;
    const size_t place = nkwi_fbx_below(&f->tree, f->objects[cluster].node, "Transform");
    const double *numbers = place == NKWI_FBX_NONE ? NULL : nkwi_fbx_numbers(&f->tree, place, &a->scratch, &count);
    if (f->tree.fault)
        return nkwi_assimp_fbx_fail(a);
    for (size_t i = 0; i < 16; i++) {
        if (count != 16 || !(fabs(numbers[i]) < 3e38))
            return 1;
        bind.m[i] = (float)numbers[i];
    }
    nkwi_assimp_fbx_geometry(a, node, &own);
    *matrix = nkw_mat4_mul(&bind, &own);
    return 1;
}

/* ---- blend shapes ---- */

static size_t count_shapes(const nkwi_fbx *f, size_t channel)
{
    size_t link = 0, count = 0;
    while (next_of(f, channel, "Geometry", "Shape", &link) != NKWI_FBX_NONE)
        count++;
    return count;
}

/* Adds the shapes of a channel to a list that has room for them; `list` NULL: counts only. */
static int add_shapes(nkwi_assimp *a, size_t channel, nkwi_assimp_shape *list, size_t *count)
{
    nkwi_fbx *f = &a->fbx->file;
    const size_t shapes = count_shapes(f, channel);
    const size_t place = nkwi_fbx_below(&f->tree, f->objects[channel].node, "FullWeights");
    size_t full_count = 0;
    const double *full =
        place == NKWI_FBX_NONE || !list ? NULL : nkwi_fbx_numbers(&f->tree, place, &a->scratch, &full_count);
    if (f->tree.fault)
        return nkwi_assimp_fbx_fail(a);
    for (size_t i = 0; list && i < shapes; i++) {
        const nkwi_assimp_shape shape = {channel, full_count == shapes ? full : NULL, i, shapes};
        list[*count + i] = shape;
    }
    *count += shapes;
    return 1;
}

static int list_shapes(nkwi_assimp *a, size_t geometry, nkwi_assimp_shape *list, size_t *count)
{
    const nkwi_fbx *f = &a->fbx->file;
    size_t blend, channel, at = 0;
    *count = 0;
    while ((blend = next_of(f, geometry, "Deformer", "BlendShape", &at)) != NKWI_FBX_NONE) {
        size_t link = 0;
        while ((channel = next_of(f, blend, "Deformer", "BlendShapeChannel", &link)) != NKWI_FBX_NONE)
            if (!add_shapes(a, channel, list, count))
                return 0;
    }
    return 1;
}

nkwi_assimp_shape *nkwi_assimp_fbx_shapes(nkwi_assimp *a, size_t node, size_t *count)
{
    const size_t geometry = geometry_of(a, node);
    *count = 0;
    if (geometry == NKWI_FBX_NONE || !list_shapes(a, geometry, NULL, count) || *count == 0)
        return NULL;
    nkwi_assimp_shape *list = (nkwi_assimp_shape *)nkwi_assimp_scratch(a, "meshes", *count, sizeof *list);
    return list && list_shapes(a, geometry, list, count) ? list : NULL;
}

/* The percent at which a shape is whole; that of the mesh, which follows the shapes, is 0. */
static double full_at(const nkwi_assimp_shape *s, size_t i)
{
    return i == s->count ? 0.0 : s->full ? s->full[i] : 100.0 * (double)(i + 1) / (double)s->count;
}

/* The nearest shape at or below a percent, `sign` 1, or above it, -1; count + 1 for none. The mesh is one of them. */
static size_t nearest(const nkwi_assimp_shape *s, double percent, double sign)
{
    size_t best = s->count + 1;
    for (size_t i = 0; i <= s->count; i++) {
        const double gap = sign * (percent - full_at(s, i));
        if ((gap > 0.0 || (gap == 0.0 && sign > 0.0)) && (best > s->count || gap < sign * (percent - full_at(s, best))))
            best = i;
    }
    return best;
}

/*
 * Between the percents a < b of two neighbours, of which the mesh is one with 0, these have 1 - x and x with
 * x = (percent - a)/(b - a); the first and the last line continue outside.
 */
float nkwi_assimp_fbx_weight(const nkwi_assimp_shape *shape, float percent)
{
    const double p = (double)percent;
    size_t low = nearest(shape, p, 1.0), high = nearest(shape, p, -1.0);
    if (high > shape->count && low <= shape->count) {
        high = low;
        low = nearest(shape, nextafter(full_at(shape, high), -INFINITY), 1.0);
    } else if (low > shape->count && high <= shape->count) {
        low = high;
        high = nearest(shape, full_at(shape, low), -1.0);
    }
    if (low > shape->count || high > shape->count)
        return 0.0f;
    const double from = full_at(shape, low), x = (p - from) / (full_at(shape, high) - from);
    return shape->index == high ? (float)x : shape->index == low ? (float)(1.0 - x) : 0.0f;
}

/* Blender has DeformPercent as a node, not as a property. */
float nkwi_assimp_fbx_percent(const nkwi_assimp *a, size_t channel)
{
    const nkwi_fbx *f = &a->fbx->file;
    const nkwi_fbx_value *value =
        nkwi_fbx_at(&f->tree, nkwi_fbx_below(&f->tree, f->objects[channel].node, "DeformPercent"), 0);
    return (float)nkwi_fbx_number(f, channel, "DeformPercent", value && value->kind != 'S' ? value->real : 0.0);
}

int nkwi_assimp_fbx_weights(nkwi_assimp *a, size_t node, size_t count, float *weights)
{
    size_t shapes;
    const nkwi_assimp_shape *list = nkwi_assimp_fbx_shapes(a, node, &shapes);
    if (a->error->code != NKW_IMPORT_OK)
        return 0;
    for (size_t i = 0; list && i < shapes && i < count; i++)
        weights[i] = nkwi_assimp_fbx_weight(&list[i], nkwi_assimp_fbx_percent(a, list[i].channel));
    if (count != shapes)
        return nkwi_document_warn(a->document, a->error, "%s: %zu of its %zu blend shapes are read, and stay at rest",
                                  a->nodes[node]->mName.data, count, shapes);
    return 1;
}
