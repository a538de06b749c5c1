/* SPDX-License-Identifier: MIT */
/* glTF 2.0, 3.11: animations. */
#include <stdio.h>
#include <string.h>

#include "gltf.h"

/* The target of a path; NKW_CLIP_FLOATS + 1 for any other text. */
static int target_of(const char *path)
{
    static const char *const paths[] = {"translation", "rotation", "scale", "weights"};
    int target = 0;
    while (target <= NKW_CLIP_FLOATS && strcmp(path, paths[target]) != 0)
        target++;
    return target;
}

static int interpolation_of(nkwi_gltf *g, const nkwi_value *sampler, nkw_interpolation *out)
{
    static const char *const names[] = {"LINEAR", "STEP", "CUBICSPLINE"};
    nkwi_value at = nkwi_member(sampler, "interpolation");
    const char *name = at.json ? nkwi_text(sampler, "interpolation", "") : "LINEAR";
    for (int i = 0; i < 3; i++)
        if (strcmp(name, names[i]) == 0) {
            *out = (nkw_interpolation)i;
            return 1;
        }
    return nkwi_fail(g->error, &at.place, NKW_IMPORT_INVALID, "\"%s\" is no interpolation", name);
}

/* The keys of a sampler. The track has its target, and the width of its values. */
static int read_sampler(nkwi_gltf *g, const nkwi_value *sampler, nkw_clip_track *out, nkw_document_channel *channel)
{
    static const size_t components[] = {3, 4, 3, 1};
    nkw_track *track = &out->track;
    nkwi_value output = nkwi_member(sampler, "output");
    size_t values;
    int32_t input_index, output_index;
    if (!nkwi_is_object(g->error, sampler) || !interpolation_of(g, sampler, &track->interpolation) ||
        !nkwi_gltf_floats(g, sampler, "input", 1, NKWI_NORMALIZED, &track->times, &track->count) ||
        !nkwi_gltf_floats(g, sampler, "output", components[out->target], NKWI_NORMALIZED, &track->values, &values) ||
        !nkwi_index(g->error, sampler, "input", "accessor", g->accessor_count, &input_index) ||
        !nkwi_index(g->error, sampler, "output", "accessor", g->accessor_count, &output_index))
        return 0;
    size_t parts = track->interpolation == NKW_INTERPOLATION_CUBICSPLINE ? 3 : 1;
    size_t each = out->target == NKW_CLIP_FLOATS ? parts * track->width : parts;
    if (values / each != track->count || values % each != 0)
        return nkwi_fail(g->error, &output.place, NKW_IMPORT_INVALID, "%zu values for %zu keys of %zu", values,
                         track->count, each);
    if (out->target == NKW_CLIP_ROTATION && g->accessors[output_index].component != NKWI_F32)
        track->kind = NKW_TRACK_ROTATION_NORMALIZED; /* rounded unit quaternions */
    channel->input = (size_t)input_index;
    channel->output = (size_t)output_index;
    channel->bytes = nkwi_gltf_bytes(g, channel->input) + nkwi_gltf_bytes(g, channel->output);
    return 1;
}

/*
 * Why a channel is no track, or NULL: the pointer of KHR_animation_pointer, weights of a mesh that has none. In
 * `pointer`, room for a text.
 */
static const char *unread_reason(nkwi_gltf *g, const nkwi_value *target, int32_t node, char pointer[256])
{
    nkwi_value extensions = nkwi_member(target, "extensions");
    nkwi_value extension = nkwi_member(&extensions, "KHR_animation_pointer");
    const char *path = nkwi_text(target, "path", "");
    if (extension.json || strcmp(path, "pointer") == 0) {
        snprintf(pointer, 256, "KHR_animation_pointer %.200s is not read", nkwi_text(&extension, "pointer", ""));
        return pointer;
    }
    if (node == NKW_NO_JOINT || strcmp(path, "weights") != 0)
        return NULL;
    const nkw_document *d = &g->document->all;
    return d->nodes[d->joint_of_node[node]].float_count > 0 ? NULL : "weights, but the mesh has no morph targets";
}

/* What the channel moves: a property of a joint, or the morph weights of its mesh. */
static int read_target(nkwi_gltf *g, const nkwi_value *target, int32_t joint, nkw_clip_track *out)
{
    const nkw_document_node *node = &g->document->all.nodes[joint];
    nkwi_value path = nkwi_member(target, "path");
    const char *name = nkwi_text(target, "path", "");
    int found = target_of(name);
    if (found > NKW_CLIP_FLOATS)
        return nkwi_fail(g->error, &path.place, NKW_IMPORT_INVALID, "\"%s\" is no path", name);
    out->target = (nkw_clip_target)found;
    out->index = found == NKW_CLIP_FLOATS ? node->float_first : (uint32_t)joint;
    out->track.width = found == NKW_CLIP_FLOATS ? node->float_count : found == NKW_CLIP_ROTATION ? 4 : 3;
    out->track.kind = found == NKW_CLIP_ROTATION ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
    return 1;
}

/*
 * A channel becomes a track. *is_track is 0 where it has no node, or is not read: the reason is then in `unread`, NULL
 * otherwise.
 */
static int read_channel(nkwi_gltf *g, const nkwi_value *channel, const nkwi_value *samplers, nkw_clip_track *track,
                        nkw_document_channel *origin, nkw_document_unread *unread, int *is_track)
{
    int32_t node, sampler_index;
    char pointer[256];
    unread->reason = NULL;
    nkwi_value target = nkwi_member(channel, "target");
    if (!nkwi_is_object(g->error, channel) || !nkwi_is_object(g->error, &target) ||
        !nkwi_index(g->error, &target, "node", "node", g->node_count, &node) ||
        !nkwi_needed_index(g->error, channel, "sampler", "sampler", nkwi_length(samplers), &sampler_index))
        return 0;
    const char *reason = unread_reason(g, &target, node, pointer);
    *is_track = node != NKW_NO_JOINT && !reason;
    if (reason) {
        unread->number = channel->place.index;
        unread->reason = nkwi_document_text(g->document, g->error, reason);
        return unread->reason != NULL;
    }
    if (!*is_track)
        return 1;
    nkwi_value sampler = nkwi_element(samplers, (size_t)sampler_index);
    origin->number = channel->place.index;
    origin->joint = g->document->all.joint_of_node[node];
    return read_target(g, &target, origin->joint, track) && read_sampler(g, &sampler, track, origin);
}

static int read_animation(nkwi_gltf *g, const nkwi_value *object, void *element)
{
    nkw_document_animation *animation = (nkw_document_animation *)element;
    nkwi_value channels = nkwi_member(object, "channels"), samplers = nkwi_member(object, "samplers");
    if (!nkwi_is_object(g->error, object) || !nkwi_is_array(g->error, &channels) || !nkwi_is_array(g->error, &samplers))
        return 0;
    size_t count = nkwi_length(&channels);
    nkw_clip_track *tracks = (nkw_clip_track *)nkwi_gltf_take(g, &channels, count, sizeof *tracks);
    nkw_document_channel *origins = (nkw_document_channel *)nkwi_gltf_take(g, &channels, count, sizeof *origins);
    nkw_document_unread *unread = (nkw_document_unread *)nkwi_gltf_take(g, &channels, count, sizeof *unread);
    animation->name = nkwi_gltf_name(g, object, "animation");
    animation->tracks = tracks;
    animation->channels = origins;
    animation->unread = unread;
    if (!animation->name || !tracks || !origins || !unread)
        return 0;
    for (size_t i = 0; i < count; i++) {
        nkwi_value channel = nkwi_element(&channels, i);
        size_t k = animation->track_count;
        int is_track;
        nkw_document_unread *rest = &unread[animation->unread_count];
        if (!read_channel(g, &channel, &samplers, &tracks[k], &origins[k], rest, &is_track))
            return 0;
        animation->track_count += is_track ? 1 : 0;
        animation->unread_count += rest->reason != NULL;
        if (is_track && tracks[k].target != NKW_CLIP_FLOATS)
            g->document->nodes[origins[k].joint].matrix = NULL; /* its keys replace it */
    }
    return 1;
}

int nkwi_gltf_animations(nkwi_gltf *g)
{
    nkw_document *document = &g->document->all;
    document->animations = (nkw_document_animation *)nkwi_gltf_each(g, "animations", sizeof *document->animations,
                                                                    read_animation, &document->animation_count);
    return document->animations != NULL;
}
