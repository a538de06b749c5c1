/* SPDX-License-Identifier: MIT */
/* Animations of a scene of Assimp: channels of nodes and of morph targets; keys are LINEAR, times become seconds. */
#include <stdio.h>
#include <string.h>

#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

#include "assimp.h"

/* An animation while it is read. */
typedef struct reader {
    nkwi_assimp *a;
    const struct aiAnimation *from;
    size_t index;
    double ticks; /* per second */
    nkw_clip_track *tracks;
    nkw_document_channel *channels;
    size_t count;
} reader;

static int fail_channel(const reader *r, const char *list, size_t channel, const char *reason)
{
    const nkwi_place root = {NULL, NULL, 0}, all = {&root, "animations", 0}, at = {&all, NULL, r->index};
    const nkwi_place channels = {&at, list, 0}, place = {&channels, NULL, channel};
    return nkwi_fail(r->a->error, &place, NKW_IMPORT_INVALID, "%s", reason);
}

/* Ticks per second: those of the file; those of X where it states none (4800); otherwise 25. */
static double ticks_of(const nkwi_assimp *a, const struct aiAnimation *from)
{
    if (a->frame_rate > 0.0 && a->frame_rate < 1e12)
        return a->frame_rate;
    if (from->mTicksPerSecond > 0.0 && from->mTicksPerSecond < 1e12)
        return from->mTicksPerSecond;
    return strstr(a->document->all.format, "Direct3D XFile") ? 4800.0 : 25.0;
}

/* Room for a track of `count` keys, which the caller fills; *times and *values point to it. */
static int begin_track(reader *r, size_t number, int32_t joint, nkw_clip_target target, size_t width, size_t count,
                       float **times, float **values)
{
    const nkw_document *d = &r->a->document->all;
    *times = (float *)nkwi_assimp_take(r->a, "animations", count, sizeof **times);
    *values = (float *)nkwi_assimp_take(r->a, "animations", count, width * sizeof **values);
    if (!*times || !*values)
        return 0;
    const nkw_track track = {*times,
                             *values,
                             count,
                             width,
                             target == NKW_CLIP_ROTATION ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS,
                             NKW_INTERPOLATION_LINEAR,
                             NULL};
    const uint32_t at = target == NKW_CLIP_FLOATS ? d->nodes[joint].float_first : (uint32_t)joint;
    const nkw_clip_track out = {target, at, track};
    const nkw_document_channel channel = {number, joint, 0, 0, count * (1 + width) * sizeof(float), 0, 0.0f};
    r->tracks[r->count] = out;
    r->channels[r->count++] = channel;
    if (target != NKW_CLIP_FLOATS)
        r->a->document->nodes[joint].matrix = NULL; /* its keys replace it */
    return 1;
}

static int read_vectors(reader *r, size_t number, int32_t node, nkw_clip_target target, const struct aiVectorKey *keys,
                        size_t count)
{
    float *times, *values;
    if (count == 0)
        return 1;
    if (!keys)
        return fail_channel(r, "channels", number, "the channel has no keys");
    if (!begin_track(r, number, nkwi_assimp_joint(r->a, node), target, 3, count, &times, &values))
        return 0;
    for (size_t i = 0; i < count; i++) {
        const nkw_vec3 v = {keys[i].mValue.x, keys[i].mValue.y, keys[i].mValue.z};
        times[i] = (float)(keys[i].mTime / r->ticks);
        memcpy(values + 3 * i, &v, sizeof v);
    }
    return 1;
}

/* Importers make rotations of angles and matrices: their signs mean nothing, and follow the key before. */
static int read_rotations(reader *r, size_t number, int32_t node, const struct aiQuatKey *keys, size_t count)
{
    float *times, *values;
    if (count == 0)
        return 1;
    if (!keys)
        return fail_channel(r, "channels", number, "the channel has no keys");
    if (!begin_track(r, number, nkwi_assimp_joint(r->a, node), NKW_CLIP_ROTATION, 4, count, &times, &values))
        return 0;
    nkw_quat last = {0.0f, 0.0f, 0.0f, 0.0f};
    for (size_t i = 0; i < count; i++) {
        nkw_quat q = {keys[i].mValue.x, keys[i].mValue.y, keys[i].mValue.z, keys[i].mValue.w};
        q = i > 0 && nkw_quat_dot(last, q) < 0.0f ? nkw_quat_negate(q) : q;
        last = q;
        times[i] = (float)(keys[i].mTime / r->ticks);
        memcpy(values + 4 * i, &q, sizeof q);
    }
    return 1;
}

/* A channel of a node that does not exist is left out. */
static int read_channel(reader *r, size_t number)
{
    struct aiNodeAnim *c = r->from->mChannels[number];
    if (!c)
        return fail_channel(r, "channels", number, "the channel is missing");
    /* Channels of nodes with the same name are in the order of the nodes. */
    int32_t node = nkwi_assimp_find_nth(r->a, c->mNodeName.data, r->a->uses);
    return node == NKW_NO_JOINT ||
           (read_vectors(r, number, node, NKW_CLIP_TRANSLATION, c->mPositionKeys, c->mNumPositionKeys) &&
            read_rotations(r, number, node, c->mRotationKeys, c->mNumRotationKeys) &&
            read_vectors(r, number, node, NKW_CLIP_SCALE, c->mScalingKeys, c->mNumScalingKeys));
}

/* Whether the name of a mesh is that of a channel, up to a star. */
static int is_name(const char *name, const char *channel)
{
    size_t length = strcspn(channel, "*");
    return strncmp(name, channel, length) == 0 && name[length] == 0;
}

static int read_weights(reader *r, size_t number, int32_t joint)
{
    const struct aiMeshMorphAnim *c = r->from->mMorphMeshChannels[number];
    size_t width = r->a->document->nodes[joint].float_count;
    float *times, *values;
    if (!begin_track(r, r->from->mNumChannels + number, joint, NKW_CLIP_FLOATS, width, c->mNumKeys, &times, &values))
        return 0;
    for (size_t i = 0; i < c->mNumKeys; i++) {
        const struct aiMeshMorphKey *key = &c->mKeys[i];
        times[i] = (float)(key->mTime / r->ticks);
        for (unsigned k = 0; key->mValues && key->mWeights && k < key->mNumValuesAndWeights; k++)
            if (key->mValues[k] < width)
                values[i * width + key->mValues[k]] = (float)key->mWeights[k];
    }
    return 1;
}

/* The first node with morph targets that has the name of the channel, or whose mesh has it. */
static int read_morphs(reader *r, size_t number)
{
    const nkw_document *d = &r->a->document->all;
    const struct aiMeshMorphAnim *c = r->from->mMorphMeshChannels[number];
    if (!c || (c->mNumKeys > 0 && !c->mKeys))
        return fail_channel(r, "weights", number, "the channel has no keys");
    for (size_t j = 0; c->mNumKeys > 0 && j < d->skeleton.joint_count; j++) {
        const nkw_document_node *node = &d->nodes[j];
        if (node->float_count > 0 &&
            (is_name(node->name, c->mName.data) || is_name(d->meshes[node->mesh].name, c->mName.data)))
            return read_weights(r, number, (int32_t)j);
    }
    return 1;
}

/* The channels of the animation `from` are added to the tracks. */
static int read_channels(reader *r)
{
    size_t nodes = r->from->mNumChannels, morphs = r->from->mNumMorphMeshChannels;
    if ((nodes > 0 && !r->from->mChannels) || (morphs > 0 && !r->from->mMorphMeshChannels))
        return fail_channel(r, "channels", 0, "there are no channels");
    memset(r->a->uses, 0, r->a->node_count * sizeof *r->a->uses);
    r->ticks = ticks_of(r->a, r->from);
    for (size_t i = 0; i < nodes; i++)
        if (!read_channel(r, i))
            return 0;
    for (size_t i = 0; i < morphs; i++)
        if (!read_morphs(r, i))
            return 0;
    return 1;
}

static int read_animation(reader *r, const struct aiAnimation *from, nkw_document_animation *out)
{
    if (!from)
        return fail_channel(r, "channels", 0, "the animation is missing");
    const size_t most = 3 * (size_t)from->mNumChannels + from->mNumMorphMeshChannels;
    r->from = from;
    r->tracks = (nkw_clip_track *)nkwi_assimp_take(r->a, "animations", most, sizeof *r->tracks);
    r->channels = (nkw_document_channel *)nkwi_assimp_take(r->a, "animations", most, sizeof *r->channels);
    if (!r->tracks || !r->channels || !read_channels(r))
        return 0;
    out->tracks = r->tracks;
    out->channels = r->channels;
    out->track_count = r->count;
    return 1;
}

int nkwi_assimp_animations(nkwi_assimp *a)
{
    if (a->fbx)
        return nkwi_assimp_fbx_animations(a);
    if (a->collada)
        return nkwi_assimp_collada_animations(a);
    nkw_document *d = &a->document->all;
    size_t count = a->scene->mAnimations ? a->scene->mNumAnimations : 0;
    nkw_document_animation *list = (nkw_document_animation *)nkwi_assimp_take(a, "animations", count, sizeof *list);
    a->uses = (uint32_t *)nkwi_assimp_scratch(a, "animations", a->node_count, sizeof *a->uses);
    if (!list || !a->uses)
        return 0;
    for (size_t i = 0; i < count; i++) {
        reader r = {a, NULL, i, 0.0, NULL, NULL, 0};
        if (!read_animation(&r, a->scene->mAnimations[i], &list[i]))
            return 0;
        list[i].name = nkwi_assimp_name(a, &a->scene->mAnimations[i]->mName, "animation", i);
        if (!list[i].name)
            return 0;
    }
    d->animations = list;
    d->animation_count = count;
    return 1;
}
