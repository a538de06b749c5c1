/* SPDX-License-Identifier: MIT */
/** @file From a loaded cgltf_data to a skeleton, clips and skins, in one call. To be copied, and included after cgltf.h */
#ifndef GLTF_CGLTF_H
#define GLTF_CGLTF_H

#include <nakawari/nakawari.h>
#include <string.h>

typedef struct gltf_character {
    nkw_skeleton skeleton; /* all nodes, parents before their children */
    int32_t *joint_of_node, *float_of_node; /* of data->nodes[i]: the joint, the first morph weight in clips */
    nkw_pose_span rest;
    float *rest_floats;
    size_t float_count;
    nkw_clip **clips; /* of data->animations */
    nkw_palette_source *skins; /* of data->skins; set models, and call nkw_palette_from_models */
    /* The caller's memory, which is freed as a whole: `count` zero elements of `size` bytes; does not return NULL. */
    void *(*take)(size_t count, size_t size);
} gltf_character;

static inline float *gltf_floats(gltf_character *c, const cgltf_accessor *a)
{
    size_t n = cgltf_accessor_unpack_floats(a, NULL, 0);
    float *floats = (float *)c->take(n, sizeof *floats);
    cgltf_accessor_unpack_floats(a, floats, n);
    return floats;
}

static inline size_t gltf_weights(const cgltf_node *n)
{
    return n->mesh && n->mesh->primitives_count > 0 ? n->mesh->primitives[0].targets_count : 0;
}

/* A matrix with shear loses it. */
static inline nkw_result gltf_load_nodes(const cgltf_data *data, gltf_character *c, size_t *bad)
{
    size_t n = data->nodes_count;
    int32_t *maps = (int32_t *)c->take(5 * n, sizeof *maps);
    c->skeleton.parents = maps + n;
    c->skeleton.joint_count = c->rest.joint_count = n;
    c->rest.data = (float *)c->take(nkw_pose_floats(n), sizeof(float));
    c->joint_of_node = maps + 2 * n;
    c->float_of_node = maps + 4 * n;
    for (size_t i = 0; i < n; c->float_count += gltf_weights(&data->nodes[i++])) {
        maps[i] = data->nodes[i].parent ? (int32_t)(data->nodes[i].parent - data->nodes) : NKW_NO_JOINT;
        c->float_of_node[i] = (int32_t)c->float_count;
    }
    c->rest_floats = (float *)c->take(c->float_count, sizeof(float));
    nkw_result result = nkw_skeleton_from_parents(maps, n, c->joint_of_node, maps + 3 * n, maps + n, bad);
    for (size_t i = 0; i < n && result == NKW_OK; i++) {
        const cgltf_node *node = &data->nodes[i];
        const float *t = node->translation, *r = node->rotation, *s = node->scale;
        nkw_trs trs = {{t[0], t[1], t[2]}, {r[0], r[1], r[2], r[3]}, {s[0], s[1], s[2]}};
        if (node->has_matrix)
            trs = nkw_trs_from_mat4((const nkw_mat4 *)(const void *)node->matrix);
        nkw_pose_set(c->rest, (size_t)c->joint_of_node[i], &trs);
        const float *weights = node->weights ? node->weights : node->mesh ? node->mesh->weights : NULL;
        for (size_t k = 0; k < gltf_weights(node) && weights; k++)
            c->rest_floats[(size_t)c->float_of_node[i] + k] = weights[k];
    }
    return result;
}

/* The enumerations of paths and of interpolations have the same order in both libraries. */
static inline nkw_result gltf_load_clip(const cgltf_data *data, size_t animation, gltf_character *c, size_t *bad)
{
    const cgltf_animation *a = &data->animations[animation];
    nkw_clip_track *tracks = (nkw_clip_track *)c->take(a->channels_count, sizeof *tracks), *to = tracks;
    for (const cgltf_animation_channel *from = a->channels; from < a->channels + a->channels_count; from++) {
        if (!from->target_node)
            continue;
        to->target = (nkw_clip_target)(from->target_path - cgltf_animation_path_type_translation);
        int is_rotation = to->target == NKW_CLIP_ROTATION, is_floats = to->target == NKW_CLIP_FLOATS;
        to->index = (uint32_t)(is_floats ? c->float_of_node : c->joint_of_node)[from->target_node - data->nodes];
        to->track.times = gltf_floats(c, from->sampler->input);
        to->track.values = gltf_floats(c, from->sampler->output);
        to->track.count = from->sampler->input->count;
        to->track.width = is_floats ? gltf_weights(from->target_node) : is_rotation ? 4 : 3;
        to->track.kind = is_rotation ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
        if (is_rotation && from->sampler->output->component_type != cgltf_component_type_r_32f)
            to->track.kind = NKW_TRACK_ROTATION_NORMALIZED; /* integers are rounded unit quaternions */
        to++->track.interpolation = (nkw_interpolation)from->sampler->interpolation;
    }
    size_t bytes, n = (size_t)(to - tracks), joints = c->rest.joint_count;
    const nkw_work work = {c->take(NKW_CLIP_BUILD_WORK(n), 1), NKW_CLIP_BUILD_WORK(n)};
    nkw_bytes_span block = {NULL, 0};
    nkw_clip_source source = {tracks,           n,   joints, c->float_count, {c->rest.data, joints}, c->rest_floats,
                              NKW_CLIP_FLOAT32, NULL};
    nkw_result result = nkw_clip_build(&source, block, &block.bytes, bad, work);
    if (!block.bytes)
        return result;
    block.data = c->take(block.bytes, 1);
    c->clips[animation] = (nkw_clip *)block.data;
    return nkw_clip_build(&source, block, &bytes, bad, work);
}

/* After cgltf_load_buffers and cgltf_validate. Ends at the first error; *bad is its node, or its track with a node. */
static inline nkw_result gltf_load(const cgltf_data *data, void *(*take)(size_t count, size_t size), gltf_character *c,
                                   size_t *bad)
{
    memset(c, 0, sizeof *c);
    c->take = take;
    nkw_result result = gltf_load_nodes(data, c, bad);
    c->clips = (nkw_clip **)c->take(data->animations_count, sizeof *c->clips);
    c->skins = (nkw_palette_source *)c->take(data->skins_count, sizeof *c->skins);
    for (size_t i = 0; i < data->animations_count && result == NKW_OK; i++)
        result = gltf_load_clip(data, i, c, bad);
    for (size_t i = 0; i < data->skins_count && result == NKW_OK; i++) {
        const cgltf_skin *from = &data->skins[i];
        int32_t *joints = (int32_t *)c->take(from->joints_count, sizeof *joints);
        for (size_t j = 0; j < from->joints_count; j++)
            joints[j] = c->joint_of_node[from->joints[j] - data->nodes];
        c->skins[i].joints = joints;
        c->skins[i].joint_count = from->joints_count;
        c->skins[i].model_count = data->nodes_count;
        if (from->inverse_bind_matrices)
            c->skins[i].inverse_bind = (const nkw_mat4 *)(void *)gltf_floats(c, from->inverse_bind_matrices);
    }
    return result;
}

#endif
