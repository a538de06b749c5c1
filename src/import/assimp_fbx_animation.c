/* SPDX-License-Identifier: MIT */
/* The animation stacks of FBX as tracks of the document. */
#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "assimp_fbx.h"
#include "fbx_bake.h"
#include "utf8.h"

/* An animation while it is read. */
typedef struct reader {
    nkwi_assimp *a;
    const nkwi_fbx_stack *stack;
    nkw_document_animation *out;
    nkw_document_unread *unread;
    float start, stop;
    size_t outside, spins;
    /* What is sampled. */
    size_t node;
    nkw_clip_target target;
    const nkwi_assimp_shape *shapes;
    nkwi_fbx_animated *percents; /* of each shape */
    size_t shape_count;
} reader;

/* ---- samples ---- */

static void sample_local(void *user, float time, float *out)
{
    const reader *r = (const reader *)user;
    nkwi_assimp_fbx_local(r->a, r->node, r->target, time, out);
}

static void sample_weights(void *user, float time, float *out)
{
    const reader *r = (const reader *)user;
    for (size_t i = 0; i < r->shape_count; i++)
        out[i] = nkwi_assimp_fbx_weight(&r->shapes[i], nkwi_fbx_sample(&r->percents[i], time).x);
}

static void add_scales(const reader *r, nkwi_fbx_times *times, int32_t node)
{
    for (; node >= 0; node = r->a->fbx->inherits[node])
        nkwi_fbx_add_times(times, &r->a->fbx->animated[node][2]);
}

/* The times of all properties on which the sample depends. */
static void add_local_times(const reader *r, nkwi_fbx_times *times)
{
    const nkwi_assimp_fbx *f = r->a->fbx;
    const nkwi_fbx_animated *own = f->animated[r->node];
    if (r->target == NKW_CLIP_SCALE) {
        add_scales(r, times, (int32_t)r->node);
        return;
    }
    nkwi_fbx_add_times(times, &own[r->target == NKW_CLIP_ROTATION]);
    if (r->target != NKW_CLIP_TRANSLATION)
        return;
    if (f->models[r->node].has_pivot) {
        nkwi_fbx_add_times(times, &own[1]);
        nkwi_fbx_add_times(times, &own[2]);
    }
    if (nkwi_assimp_fbx_is_apart(r->a, r->node))
        add_scales(r, times, r->a->parents[r->node]);
}

/* ---- tracks ---- */

/* The times between the start and the stop; none where nothing animates the sample. */
static nkwi_fbx_times times_of(const reader *r)
{
    nkwi_fbx_times times = {NULL, 0, 0, 0, 0, r->start, r->stop, 0, 0};
    if (r->shapes)
        for (size_t i = 0; i < r->shape_count; i++)
            nkwi_fbx_add_times(&times, &r->percents[i]);
    else
        add_local_times(r, &times);
    if (times.channels > 0)
        nkwi_fbx_sort_times(&times);
    return times;
}

/* A property without curves has a value of its own in the stack: no track is needed where that is the rest value. */
static int is_rest(const reader *r, const nkwi_fbx_times *times, const nkwi_fbx_baked *baked, int32_t joint)
{
    const nkw_document *d = &r->a->document->all;
    const nkw_trs *rest = &d->nodes[joint].rest;
    const float *values = r->target == NKW_CLIP_TRANSLATION ? &rest->translation.x
                          : r->target == NKW_CLIP_ROTATION  ? &rest->rotation.x
                          : r->target == NKW_CLIP_SCALE     ? &rest->scale.x
                                                            : d->rest_floats + d->nodes[joint].float_first;
    for (size_t i = 0; times->curves == 0 && i < baked->width; i++)
        if (baked->values[i] != values[i])
            return 0;
    return times->curves == 0;
}

/* A track of what the reader samples, unless nothing animates it. */
static int read_track(reader *r, int32_t joint, size_t width)
{
    nkwi_fbx_times times = times_of(r);
    const nkwi_fbx_source source = {r->shapes ? sample_weights : sample_local, r, width, r->target == NKW_CLIP_ROTATION,
                                    &times};
    nkwi_fbx_baked baked;
    memset(&baked, 0, sizeof baked);
    r->outside += times.outside;
    int done = !times.failed && (times.channels == 0 || nkwi_fbx_bake(&source, &baked));
    if (!done)
        nkwi_fail(r->a->error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the keys of an animation");
    r->spins += baked.spins;
    if (done && baked.count > 0 && !is_rest(r, &times, &baked, joint))
        done = nkwi_assimp_store(r->a, r->out, r->target, joint, width, &baked);
    nkwi_fbx_baked_free(&baked);
    free(times.list);
    return done;
}

static int read_node(reader *r, size_t node)
{
    static const nkw_clip_target targets[] = {NKW_CLIP_TRANSLATION, NKW_CLIP_ROTATION, NKW_CLIP_SCALE};
    const nkwi_fbx_model *m = &r->a->fbx->models[node];
    r->node = node;
    r->shapes = NULL;
    for (int k = 0; m->object != NKWI_FBX_NONE && k < 3; k++) {
        r->target = targets[k];
        const int32_t joint =
            k == 2 ? nkwi_assimp_bone_joint(r->a, (int32_t)node) : nkwi_assimp_joint(r->a, (int32_t)node);
        if (!read_track(r, joint, r->target == NKW_CLIP_ROTATION ? 4 : 3))
            return 0;
    }
    return 1;
}

/* The percents of the blend shapes of a node. */
static int read_shapes(reader *r, size_t node)
{
    nkwi_assimp *a = r->a;
    const int32_t joint = a->document->all.joint_of_node[a->mesh_carrier[node]];
    const size_t width = a->document->all.nodes[joint].float_count;
    if (width == 0 || width > NKWI_FBX_WIDTH)
        return width == 0 || nkwi_document_warn(a->document, a->error, "%s: more than %d blend shapes stay at rest",
                                                a->nodes[node]->mName.data, (int)NKWI_FBX_WIDTH);
    r->shapes = nkwi_assimp_fbx_shapes(a, node, &r->shape_count);
    r->percents = (nkwi_fbx_animated *)nkwi_assimp_scratch(a, "animations", width, sizeof *r->percents);
    if (!r->shapes || !r->percents || r->shape_count != width)
        return a->error->code == NKW_IMPORT_OK;
    for (size_t i = 0; i < width; i++) {
        const nkw_vec3 rest = {nkwi_assimp_fbx_percent(a, r->shapes[i].channel), 0.0f, 0.0f};
        nkwi_fbx_animated one = {r->stack, NULL, 0, rest, NKW_EULER_XYZ, 'N'};
        one.channels = nkwi_fbx_channels(r->stack, r->shapes[i].channel, "DeformPercent", &one.count);
        r->percents[i] = one;
    }
    r->node = node;
    r->target = NKW_CLIP_FLOATS;
    return read_track(r, joint, width);
}

/* ---- what is not read ---- */

static int is_read(const nkwi_fbx *f, const nkwi_fbx_channel *c)
{
    static const char *const names[] = {"Lcl Translation", "Lcl Rotation", "Lcl Scaling"};
    for (int k = 0; k < 3; k++)
        if (nkwi_fbx_equals(c->property, names[k]))
            return nkwi_fbx_is_kind(f, c->object, "Model");
    return nkwi_fbx_equals(c->property, "DeformPercent") || nkwi_fbx_equals(c->property, "Weight");
}

static int has_curve(const nkwi_fbx_channel *c)
{
    return c->curves[0] || c->curves[1] || c->curves[2];
}

static int read_unread(reader *r)
{
    const nkwi_fbx *f = &r->a->fbx->file;
    for (size_t i = 0; i < r->stack->channel_count; i++) {
        const nkwi_fbx_channel *c = &r->stack->channels[i];
        char name[128], reason[256];
        if (is_read(f, c) || !has_curve(c))
            continue;
        nkwi_fbx_name(f, c->object, name, sizeof name);
        snprintf(reason, sizeof reason, "%.*s of %s: no part of a document", (int)(c->property->bytes % 100),
                 c->property->text, name);
        nkwi_tame(reason);
        const nkw_document_unread one = {i, nkwi_document_text(r->a->document, r->a->error, reason)};
        if (!one.reason)
            return 0;
        r->unread[r->out->unread_count++] = one;
    }
    return 1;
}

/* ---- the animation ---- */

static void widen(reader *r, const nkwi_fbx_curve *curve)
{
    if (!curve)
        return;
    const float first = curve->curve.keys[0].time, last = curve->curve.keys[curve->curve.key_count - 1].time;
    r->start = first < r->start ? first : r->start;
    r->stop = last > r->stop ? last : r->stop;
}

/* The take, or, where it states none, all keys. */
static void find_range(reader *r)
{
    r->start = r->stack->start, r->stop = r->stack->stop;
    if (r->stop > r->start)
        return;
    r->start = FLT_MAX, r->stop = -FLT_MAX;
    for (size_t i = 0; i < r->stack->channel_count; i++)
        for (int k = 0; k < 3; k++)
            widen(r, r->stack->channels[i].curves[k]);
    if (r->stop < r->start)
        r->start = r->stop = 0.0f;
}

static int take_lists(reader *r)
{
    const size_t most = 4 * r->a->node_count;
    r->out->tracks = (nkw_clip_track *)nkwi_assimp_take(r->a, "animations", most, sizeof *r->out->tracks);
    r->out->channels = (nkw_document_channel *)nkwi_assimp_take(r->a, "animations", most, sizeof *r->out->channels);
    r->unread = (nkw_document_unread *)nkwi_assimp_take(r->a, "animations", r->stack->channel_count, sizeof *r->unread);
    r->out->unread = r->unread;
    return r->out->tracks && r->out->channels && r->unread;
}

static int warn(reader *r)
{
    nkwi_document *d = r->a->document;
    nkw_import_error *error = r->a->error;
    if (r->outside > 0 && !nkwi_document_warn(d, error, "%s: %zu keys are outside of the take, from %g to %g s",
                                              r->out->name, r->outside, (double)r->start, (double)r->stop))
        return 0;
    return r->spins == 0 ||
           nkwi_document_warn(d, error,
                              "%s: %zu turns by more than half a turn from one frame to the next go the "
                              "shorter way",
                              r->out->name, r->spins);
}

static int read_animation(nkwi_assimp *a, size_t index, nkw_document_animation *out)
{
    reader r;
    char name[256];
    memset(&r, 0, sizeof r);
    r.a = a;
    r.stack = &a->fbx->stacks[index];
    r.out = out;
    nkwi_fbx_name(&a->fbx->file, r.stack->object, name, sizeof name);
    nkwi_utf8(name, strlen(name));
    out->name = nkwi_document_name(a->document, a->error, name, "animation", index);
    if (!out->name || !take_lists(&r))
        return 0;
    find_range(&r);
    nkwi_assimp_fbx_choose(a, r.stack);
    for (size_t i = 1; i < a->node_count; i++)
        if (!read_node(&r, i) || !read_shapes(&r, i))
            return 0;
    return read_unread(&r) && warn(&r);
}

int nkwi_assimp_fbx_animations(nkwi_assimp *a)
{
    nkw_document *d = &a->document->all;
    const nkwi_assimp_fbx *f = a->fbx;
    nkw_document_animation *list =
        (nkw_document_animation *)nkwi_assimp_take(a, "animations", f->stack_count, sizeof *list);
    for (size_t i = 0; list && i < f->stack_count; i++)
        if (!read_animation(a, i, &list[i]))
            return 0;
    if (!list)
        return 0;
    d->animations = list;
    d->animation_count = f->stack_count;
    return f->file.bad_curves == 0 ||
           nkwi_document_warn(a->document, a->error,
                              "%zu curves are left out: their keys are not finite, or not in the "
                              "order of their times",
                              f->file.bad_curves);
}
