/* SPDX-License-Identifier: MIT */
/* The animations of Collada as tracks of the document: one for each animation_clip, or one of all channels. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/transform.h>

#include "assimp_collada.h"
#include "decimal.h"
#include "fbx_bake.h"

/* An animation while it is read. */
typedef struct reader {
    nkwi_assimp *a;
    nkwi_collada *c;
    nkw_document_animation *out;
    float start, stop; /* that the clip states; NaN for none */
    size_t spins, sheared;
    unsigned char *is_used; /* of each channel */
    /* What is sampled. */
    const nkwi_collada_element *list;
    size_t count;
    nkw_clip_target target;
    unsigned char *is_active; /* of each channel: it is of the clip */
} reader;

/* ---- samples ---- */

static void sample_local(void *user, float time, float *out)
{
    reader *r = (reader *)user;
    const nkw_trs t = nkwi_collada_transform(r->c, r->list, r->count, time, NULL);
    if (r->target == NKW_CLIP_TRANSLATION)
        memcpy(out, &t.translation, sizeof t.translation);
    else if (r->target == NKW_CLIP_ROTATION)
        memcpy(out, &t.rotation, sizeof t.rotation);
    else
        memcpy(out, &t.scale, sizeof t.scale);
}

/* ---- times ---- */

/* The next channel that changes what is sampled, from *channel of *element on; NULL after the last. */
typedef struct walk {
    size_t element, channel;
} walk;

static const nkwi_collada_channel *next_channel(const reader *r, walk *w)
{
    const int part = r->target == NKW_CLIP_TRANSLATION ? 0 : r->target == NKW_CLIP_ROTATION ? 1 : 2;
    while (w->channel == NKWI_COLLADA_NONE && w->element < r->count) {
        if (nkwi_collada_affects(r->list, r->count, w->element, part))
            w->channel = r->list[w->element].channel;
        w->element++;
    }
    if (w->channel == NKWI_COLLADA_NONE)
        return NULL;
    const nkwi_collada_channel *found = &r->c->channels[w->channel];
    w->channel = found->next;
    return found;
}

/* The times between the start and the stop; channels 0 where nothing animates the sample. */
static nkwi_fbx_times times_of(const reader *r)
{
    nkwi_fbx_times times = {NULL, 0, 0, 0, 0, FLT_MAX, -FLT_MAX, 0, 0};
    const walk first = {0, NKWI_COLLADA_NONE};
    const nkwi_collada_channel *one;
    for (walk w = first; (one = next_channel(r, &w)) != NULL; times.channels++) {
        times.start = fminf(times.start, one->curve->times[0]);
        times.stop = fmaxf(times.stop, one->curve->times[one->curve->count - 1]);
    }
    times.start = isnan(r->start) ? times.start : r->start;
    times.stop = fmaxf(isnan(r->stop) ? times.stop : r->stop, times.start);
    if (times.channels == 0)
        return times;
    for (walk w = first; (one = next_channel(r, &w)) != NULL;) {
        const nkwi_collada_curve *c = one->curve;
        r->is_used[one->number] = 1;
        times.curves++;
        for (size_t k = 0; k < c->count; k++)
            nkwi_fbx_add_time(&times, c->times[k], k > 0 && c->kinds[k - 1] == NKWI_COLLADA_STEP ? NKWI_FBX_JUMP : 0);
    }
    nkwi_fbx_sort_times(&times);
    return times;
}

/* ---- tracks ---- */

static int read_track(reader *r, int32_t joint, size_t width)
{
    nkwi_fbx_times times = times_of(r);
    const nkwi_fbx_source source = {sample_local, r, width, r->target == NKW_CLIP_ROTATION, &times};
    nkwi_fbx_baked baked;
    memset(&baked, 0, sizeof baked);
    int done = !times.failed && (times.channels == 0 || nkwi_fbx_bake(&source, &baked));
    if (!done)
        nkwi_fail(r->a->error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the keys of an animation");
    r->spins += baked.spins;
    if (done && baked.count > 0)
        done = nkwi_assimp_store(r->a, r->out, r->target, joint, width, &baked);
    nkwi_fbx_baked_free(&baked);
    free(times.list);
    return done;
}

/* Whether a matrix of the node's keys shears. */
static int is_sheared(const reader *r)
{
    const walk first = {0, NKWI_COLLADA_NONE};
    const nkwi_collada_channel *one;
    for (walk w = first; (one = next_channel(r, &w)) != NULL;)
        for (size_t k = 0; k < one->curve->count; k++) {
            nkw_mat4 m;
            const nkw_trs t = nkwi_collada_transform(r->c, r->list, r->count, one->curve->times[k], &m);
            if (nkw_trs_residual(&t, &m) > 1e-4f)
                return 1;
        }
    return 0;
}

static int read_node(reader *r, size_t node)
{
    static const nkw_clip_target targets[] = {NKW_CLIP_TRANSLATION, NKW_CLIP_ROTATION, NKW_CLIP_SCALE};
    const xmlNode *tag = r->a->collada->tags[node];
    const int32_t joint = nkwi_assimp_joint(r->a, (int32_t)node);
    const size_t before = r->out->track_count;
    if (!tag)
        return 1;
    r->list = nkwi_collada_elements_of(r->c, tag, &r->count);
    for (int k = 0; k < 3; k++) {
        r->target = targets[k];
        if (!read_track(r, joint, r->target == NKW_CLIP_ROTATION ? 4 : 3))
            return 0;
    }
    if (r->out->track_count > before)
        r->a->document->nodes[joint].matrix = NULL; /* its keys replace it */
    r->sheared += r->out->track_count > before && is_sheared(r);
    return 1;
}

/* ---- what is not read ---- */

static int read_unread(reader *r)
{
    nkw_document_unread *list =
        (nkw_document_unread *)nkwi_assimp_take(r->a, "animations", r->c->channel_count, sizeof *list);
    r->out->unread = list;
    for (size_t i = 0; list && i < r->c->channel_count; i++) {
        const nkwi_collada_channel *c = &r->c->channels[i];
        const char *target = nkwi_collada_text(c->tag, "target");
        char reason[256];
        if (!r->is_active[i] || r->is_used[i])
            continue;
        snprintf(reason, sizeof reason, "%.150s: %s", target ? target : "",
                 c->curve ? "its target is not in the scene" : c->reason);
        nkwi_tame(reason);
        const nkw_document_unread one = {i, nkwi_document_text(r->a->document, r->a->error, reason)};
        if (!one.reason)
            return 0;
        list[r->out->unread_count++] = one;
    }
    return list != NULL;
}

/* ---- animations ---- */

/* An attribute that is a time in seconds; NaN where there is none. */
static float time_of(const xmlNode *tag, const char *key)
{
    const char *text = nkwi_collada_text(tag, key);
    double number;
    return text && !nkwi_decimal(text, strlen(text), &number) ? (float)number : NAN;
}

/* The channels of a clip are those of its animations, and of animations in them. */
static int is_of(const nkwi_collada_channel *channel, const xmlNode *clip)
{
    const xmlNode *tag = clip ? channel->tag->parent : NULL;
    while (nkwi_collada_is(tag, "animation") && tag->_private != clip)
        tag = tag->parent;
    return !clip || nkwi_collada_is(tag, "animation");
}

/* Links the channels of a clip to the elements. */
static void choose(reader *r, xmlNode *clip)
{
    nkwi_collada *c = r->c;
    static const char name[] = "instance_animation";
    for (xmlNode *t = nkwi_collada_child(clip, name); t; t = nkwi_collada_next(t, name)) {
        xmlNode *animation = nkwi_collada_of_url(c, nkwi_collada_text(t, "url"));
        if (nkwi_collada_is(animation, "animation"))
            animation->_private = clip;
    }
    for (size_t i = 0; i < c->element_count; i++)
        c->elements[i].channel = NKWI_COLLADA_NONE;
    for (size_t i = c->channel_count; i-- > 0;) {
        nkwi_collada_channel *one = &c->channels[i];
        r->is_used[i] = 0;
        r->is_active[i] = (unsigned char)is_of(one, clip);
        if (!r->is_active[i] || !one->curve || one->element == NKWI_COLLADA_NONE)
            continue;
        one->next = c->elements[one->element].channel;
        c->elements[one->element].channel = i;
    }
}

static int warn(reader *r)
{
    nkwi_document *d = r->a->document;
    if (r->sheared > 0 && !nkwi_document_warn(d, r->a->error, "%s: the keys of %zu nodes shear, which tracks do not",
                                              r->out->name, r->sheared))
        return 0;
    return r->spins == 0 || nkwi_document_warn(d, r->a->error,
                                               "%s: %zu turns by more than half a turn from one frame to the next go "
                                               "the shorter way",
                                               r->out->name, r->spins);
}

static int read_animation(reader *r, xmlNode *clip, const char *name, size_t index, nkw_document_animation *out)
{
    nkwi_assimp *a = r->a;
    const size_t most = 3 * a->node_count;
    r->out = out;
    r->start = time_of(clip, "start"), r->stop = time_of(clip, "end");
    r->spins = r->sheared = 0;
    out->name = nkwi_document_name(a->document, a->error, name, "animation", index);
    out->tracks = (nkw_clip_track *)nkwi_assimp_take(a, "animations", most, sizeof *out->tracks);
    out->channels = (nkw_document_channel *)nkwi_assimp_take(a, "animations", most, sizeof *out->channels);
    if (!out->name || !out->tracks || !out->channels)
        return 0;
    choose(r, clip);
    for (size_t i = 1; i < a->node_count; i++)
        if (!read_node(r, i))
            return 0;
    return read_unread(r) && warn(r);
}

static const char *name_of(const xmlNode *tag)
{
    const char *name = nkwi_collada_text(tag, "name");
    return name && *name ? name : nkwi_collada_text(tag, "id");
}

/* The clip after `last`, in the order of the file; NULL after the last. */
static xmlNode *next_clip(const xmlNode *top, const xmlNode *last)
{
    xmlNode *t = nkwi_collada_walk(top, last);
    while (t && !nkwi_collada_is(t, "animation_clip"))
        t = nkwi_collada_walk(top, t);
    return t;
}

/* The animation that has all others, or NULL. */
static const xmlNode *only_animation(const xmlNode *top)
{
    static const char library[] = "library_animations";
    const xmlNode *found = NULL;
    for (const xmlNode *l = nkwi_collada_child(top, library); l; l = nkwi_collada_next(l, library))
        for (const xmlNode *t = nkwi_collada_child(l, "animation"); t; t = nkwi_collada_next(t, "animation")) {
            if (found)
                return NULL;
            found = t;
        }
    return found;
}

int nkwi_assimp_collada_animations(nkwi_assimp *a)
{
    nkwi_collada *c = &a->collada->file;
    nkw_document *d = &a->document->all;
    const xmlNode *top = xmlDocGetRootElement(c->xml);
    reader r;
    size_t count = 0, read = 0;
    memset(&r, 0, sizeof r);
    r.a = a;
    r.c = c;
    r.is_used = (unsigned char *)nkwi_assimp_scratch(a, "animations", c->channel_count, 1);
    r.is_active = (unsigned char *)nkwi_assimp_scratch(a, "animations", c->channel_count, 1);
    for (const xmlNode *t = top; (t = next_clip(top, t)) != NULL;)
        count++;
    const int has_clips = count > 0;
    count = has_clips ? count : c->channel_count > 0;
    nkw_document_animation *list = (nkw_document_animation *)nkwi_assimp_take(a, "animations", count, sizeof *list);
    if (!r.is_used || !r.is_active || !list)
        return 0;
    d->animations = list;
    for (xmlNode *t = has_clips ? next_clip(top, top) : NULL; read < count; t = has_clips ? next_clip(top, t) : NULL) {
        if (!read_animation(&r, t, name_of(t ? t : only_animation(top)), read, &list[read]))
            return 0;
        d->animation_count = ++read;
    }
    return 1;
}
