/* SPDX-License-Identifier: MIT */
/*
 * The block of a character, each array at a multiple of 64 bytes:
 *
 *     parents, joint_of_node, node_of_joint      joint_count each
 *     rest pose, rest floats
 *     names                                      pointers, then the texts
 *     joints and inverse bind matrices           of all skins, one after another; then of the joints of rigid parts
 *     influences of rigid parts                  joint 0, weight 255: of the largest, all use the same
 *     parts, morph targets
 *     clips of the set, blocks of the clips
 *
 * One pass without memory measures it, a second one writes.
 */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/character.h>
#include <nakawari/transform.h>

#include "report.h"
#include "work.h"

#define ALIGN 64u

/* `data` NULL: nothing is written. */
typedef struct builder {
    const nkw_character_source *source;
    unsigned char *data;
    size_t at;
    int too_large; /* for size_t */
    nkw_character c;
    /* The working memory. */
    nkw_mat4 *models; /* of the rest pose */
    nkw_pose_span rest;
    nkw_work clip_work;
    nkw_clip_track *tracks;
    const int32_t *joint_of_node, *node_of_joint, *parents;
    /* Parts of the block. */
    int32_t *matrix_joints;
    nkw_mat4 *inverse_bind;
    nkw_character_part *parts;
    size_t bad;
} builder;

/* The next `count` elements of the block; NULL while it is measured. */
static void *take(builder *b, size_t count, size_t size)
{
    void *taken = b->data ? b->data + b->at : NULL;
    if (count > (SIZE_MAX - b->at - ALIGN) / size) {
        b->too_large = 1;
        return NULL;
    }
    b->at = (b->at + count * size + ALIGN - 1) / ALIGN * ALIGN;
    return taken;
}

static void *copy(builder *b, const void *from, size_t count, size_t size)
{
    void *to = take(b, count, size);
    if (to && count > 0)
        memcpy(to, from, count * size);
    return to;
}

static int is_node(const nkw_character_source *s, int32_t node)
{
    return node >= 0 && (size_t)node < s->node_count;
}

static int is_rigid(const nkw_character_part *part)
{
    return part->skin_index == NKW_NO_JOINT;
}

/* ---- Checks ---- */

static nkw_result check_skins(builder *b)
{
    const nkw_character_source *s = b->source;
    for (b->bad = 0; b->bad < s->skin_count; b->bad++)
        for (size_t j = 0; j < s->skins[b->bad].joint_count; j++)
            if (!is_node(s, s->skins[b->bad].joints[j]))
                return NKW_OUT_OF_RANGE;
    return NKW_OK;
}

static nkw_result check_parts(builder *b)
{
    const nkw_character_source *s = b->source;
    for (b->bad = 0; b->bad < s->part_count; b->bad++) {
        const nkw_character_part *p = &s->parts[b->bad];
        if (!is_node(s, p->joint) || (!is_rigid(p) && (p->skin_index < 0 || (size_t)p->skin_index >= s->skin_count)))
            return NKW_OUT_OF_RANGE;
        if (p->float_first > s->float_count || p->morph.target_count > s->float_count - p->float_first)
            return NKW_OUT_OF_RANGE;
        if (p->morph.target_count > 0 && p->morph.vertex_count != p->skin.vertex_count)
            return NKW_MISMATCHED;
    }
    return NKW_OK;
}

/* ---- The parts of the block ---- */

static void place_skeleton(builder *b)
{
    const nkw_character_source *s = b->source;
    const size_t n = s->node_count;
    b->c.skeleton.parents = (const int32_t *)copy(b, b->parents, n, sizeof *b->parents);
    b->c.skeleton.joint_count = n;
    b->c.joint_of_node = (const int32_t *)copy(b, b->joint_of_node, n, sizeof *b->joint_of_node);
    b->c.node_of_joint = (const int32_t *)copy(b, b->node_of_joint, n, sizeof *b->node_of_joint);
    b->c.set.rest.data = (const float *)copy(b, b->rest.data, NKW_POSE_FLOATS(n), sizeof(float));
    b->c.set.rest.joint_count = n;
    float *floats = (float *)take(b, s->float_count, sizeof *floats);
    for (size_t i = 0; b->data && i < s->float_count; i++)
        floats[i] = s->rest_floats ? s->rest_floats[i] : 0.0f;
    b->c.set.rest_floats = floats;
    b->c.set.float_count = s->float_count;
}

static void place_names(builder *b)
{
    const nkw_character_source *s = b->source;
    const char **names = (const char **)take(b, s->node_count, sizeof *names);
    for (size_t j = 0; j < s->node_count; j++) {
        const char *name = s->names ? s->names[b->node_of_joint[j]] : "";
        if (b->data)
            names[j] = (const char *)b->data + b->at;
        do { /* one byte at a time: the library does not import strlen */
            if (b->data)
                b->data[b->at] = (unsigned char)*name;
            b->too_large |= b->at == SIZE_MAX - ALIGN;
            b->at += !b->too_large;
        } while (*name++);
    }
    take(b, 0, 1);
    b->c.names = names;
}

static void place_skin(builder *b, const nkw_character_skin *skin, size_t first)
{
    const nkw_mat4 identity = nkw_mat4_identity();
    for (size_t i = 0; i < skin->joint_count; i++)
        b->matrix_joints[first + i] = b->joint_of_node[skin->joints[i]];
    if (!skin->inverse_bind && b->source->binds_at_rest) {
        const nkw_palette_source bind = {b->models, b->c.skeleton.joint_count, b->matrix_joints + first, NULL,
                                         NULL,      skin->joint_count};
        nkw_palette_inverse_bind(&bind, b->inverse_bind + first);
        return;
    }
    for (size_t i = 0; i < skin->joint_count; i++)
        b->inverse_bind[first + i] = skin->inverse_bind ? skin->inverse_bind[i] : identity;
}

static size_t first_matrix_of_skin(const nkw_character_source *s, int32_t skin)
{
    size_t first = 0;
    for (int32_t k = 0; k < skin; k++)
        first += s->skins[k].joint_count;
    return first;
}

/* The matrices of the skins, then one of each rigid part; neighbours that the same joint moves share it. */
static void place_matrices(builder *b)
{
    const nkw_character_source *s = b->source;
    size_t count = s->part_count;
    for (size_t k = 0; k < s->skin_count; k++)
        count += s->skins[k].joint_count;
    b->matrix_joints = (int32_t *)take(b, count, sizeof *b->matrix_joints);
    b->inverse_bind = (nkw_mat4 *)take(b, count, sizeof *b->inverse_bind);
    size_t first = 0;
    for (size_t k = 0; b->data && k < s->skin_count; first += s->skins[k++].joint_count)
        place_skin(b, &s->skins[k], first);
    for (size_t p = 0; b->data && p < s->part_count; p++) {
        nkw_character_part *part = &b->parts[p];
        part->joint = b->joint_of_node[part->joint];
        part->matrix_count = is_rigid(part) ? 1 : s->skins[part->skin_index].joint_count;
        part->matrix_first = is_rigid(part) ? first : first_matrix_of_skin(s, part->skin_index);
        if (!is_rigid(part))
            continue;
        const int shares = p > 0 && is_rigid(part - 1) && part[-1].joint == part->joint;
        part->matrix_first -= (size_t)shares;
        b->matrix_joints[part->matrix_first] = part->joint;
        b->inverse_bind[part->matrix_first] = nkw_mat4_identity();
        first += !shares;
    }
    b->c.palette.model_count = s->node_count;
    b->c.palette.joints = b->matrix_joints;
    b->c.palette.inverse_bind = b->inverse_bind;
    b->c.palette.joint_count = first;
}

static void place_parts(builder *b)
{
    const nkw_character_source *s = b->source;
    size_t rigid = 0;
    for (size_t p = 0; p < s->part_count; p++) {
        const size_t vertices = s->parts[p].skin.vertex_count;
        b->c.most_vertices = vertices > b->c.most_vertices ? vertices : b->c.most_vertices;
        rigid = is_rigid(&s->parts[p]) && vertices > rigid ? vertices : rigid;
    }
    unsigned char *joints = (unsigned char *)take(b, rigid, 1), *weights = (unsigned char *)take(b, rigid, 1);
    b->parts = (nkw_character_part *)copy(b, s->parts, s->part_count, sizeof *b->parts);
    if (b->data) {
        memset(joints, 0, rigid);
        memset(weights, 255, rigid);
    }
    for (size_t p = 0; p < s->part_count; p++) {
        const nkw_morph *morph = &s->parts[p].morph;
        const void *targets = copy(b, morph->targets, morph->target_count, sizeof *morph->targets);
        if (!b->data)
            continue;
        const nkw_skin one = {b->parts[p].skin.vertex_count, 1, {joints, 0, NKW_SKIN_U8}, {weights, 0, NKW_SKIN_U8}};
        b->parts[p].morph.targets = (const nkw_morph_target *)targets;
        if (is_rigid(&b->parts[p]))
            b->parts[p].skin = one;
    }
    b->c.parts = b->parts;
    b->c.part_count = s->part_count;
}

/* ---- Clips ---- */

/* The tracks of an animation, of joints. */
static nkw_clip_source clip_source(const builder *b, const nkw_character_animation *a, const nkw_clip_names *names)
{
    nkw_clip_source source;
    memset(&source, 0, sizeof source);
    for (size_t i = 0; i < a->track_count; i++) {
        b->tracks[i] = a->tracks[i];
        if (a->tracks[i].target != NKW_CLIP_FLOATS && a->tracks[i].index < b->source->node_count)
            b->tracks[i].index = (uint32_t)b->joint_of_node[a->tracks[i].index];
    }
    source.tracks = b->tracks;
    source.track_count = a->track_count;
    source.joint_count = b->source->node_count;
    source.float_count = b->source->float_count;
    source.rest = NKW_VIEW(nkw_pose, b->rest);
    source.rest_floats = b->source->rest_floats;
    source.format = b->source->format;
    source.names = names;
    return source;
}

static nkw_result place_clip(builder *b, size_t i, nkw_mixer_clip *clip)
{
    const nkw_clip_names names = {b->source->animations[i].name, NULL, NULL};
    const nkw_clip_source source = clip_source(b, &b->source->animations[i], &names);
    nkw_bytes_span block = {NULL, 0};
    size_t bytes;
    nkw_result result = nkw_clip_build(&source, block, &bytes, NULL, b->clip_work);
    if (bytes == 0)
        return result;
    block.data = take(b, bytes, 1);
    block.bytes = bytes;
    if (!b->data)
        return NKW_OK;
    result = nkw_clip_build(&source, block, &bytes, NULL, b->clip_work);
    memset(clip, 0, sizeof *clip);
    clip->clip = (const nkw_clip *)block.data;
    return result;
}

static nkw_result place_clips(builder *b)
{
    const size_t count = b->source->animation_count;
    nkw_result result = NKW_OK;
    b->c.clips = (nkw_mixer_clip *)take(b, count, sizeof *b->c.clips);
    for (b->bad = 0; result == NKW_OK && b->bad < count; b->bad += result == NKW_OK)
        result = place_clip(b, b->bad, b->data ? &b->c.clips[b->bad] : NULL);
    b->c.set.clips = b->c.clips;
    b->c.set.clip_count = count;
    return result;
}

static nkw_result place_all(builder *b, void *data)
{
    b->data = (unsigned char *)data;
    b->at = 0;
    memset(&b->c, 0, sizeof b->c);
    place_skeleton(b);
    if (data && b->source->binds_at_rest)
        nkw_skeleton_models_from_pose(&b->c.skeleton, NKW_VIEW(nkw_pose, b->rest), NULL, NULL, b->models);
    place_names(b);
    place_parts(b);
    place_matrices(b);
    return place_clips(b);
}

/* ---- The functions ---- */

static size_t most_tracks(const nkw_character_source *s)
{
    size_t most = 0;
    for (size_t i = 0; i < s->animation_count; i++)
        most = s->animations[i].track_count > most ? s->animations[i].track_count : most;
    return most;
}

/* Divides the working memory, which begins at a multiple of 16, and so do its parts but the last two. */
static int divide(builder *b, nkw_work work, int32_t **maps)
{
    const size_t n = b->source->node_count, tracks = most_tracks(b->source), limit = SIZE_MAX / 512;
    if (n > limit || tracks > limit || !work_fits(work, NKW_CHARACTER_WORK(n, tracks)))
        return 0;
    unsigned char *at = (unsigned char *)work.data;
    b->models = (nkw_mat4 *)(void *)at;
    at += n * sizeof *b->models;
    b->rest.data = (float *)(void *)at;
    b->rest.joint_count = n;
    at += NKW_POSE_FLOATS(n) * sizeof(float);
    b->clip_work.data = at;
    b->clip_work.bytes = NKW_CLIP_BUILD_WORK(tracks);
    at += (b->clip_work.bytes + 15) / 16 * 16;
    b->tracks = (nkw_clip_track *)(void *)at;
    *maps = (int32_t *)(void *)(b->tracks + tracks);
    return 1;
}

/* Sorts the nodes and checks the source. */
static nkw_result begin(builder *b, nkw_work work)
{
    const size_t n = b->source->node_count;
    int32_t *maps;
    if (!divide(b, work, &maps))
        return NKW_TOO_SMALL;
    nkw_result result = nkw_skeleton_from_parents(b->source->node_parents, n, maps, maps + n, maps + 2 * n, &b->bad);
    if (result != NKW_OK)
        return result;
    b->joint_of_node = maps;
    b->node_of_joint = maps + n;
    b->parents = maps + 2 * n;
    nkw_pose_identity(b->rest);
    for (size_t j = 0; b->source->rest && j < n; j++)
        nkw_pose_set(b->rest, j, &b->source->rest[b->node_of_joint[j]]);
    result = check_skins(b);
    return result == NKW_OK ? check_parts(b) : result;
}

nkw_result nkw_character_build(const nkw_character_source *source, nkw_bytes_span block, size_t *bytes,
                               nkw_character *character, size_t *bad, nkw_work work)
{
    builder b;
    memset(&b, 0, sizeof b);
    b.source = source;
    *bytes = 0;
    nkw_result result = begin(&b, work);
    if (result == NKW_OK)
        result = place_all(&b, NULL);
    if (result != NKW_OK)
        return report(result, b.bad, bad);
    if (b.too_large)
        return report(NKW_TOO_SMALL, 0, bad);
    *bytes = b.at;
    if (!block.data)
        return report(NKW_OK, 0, bad);
    if (block.bytes < b.at || ((uintptr_t)block.data & 7) != 0)
        return report(NKW_TOO_SMALL, 0, bad);
    result = place_all(&b, block.data);
    *character = b.c;
    return report(result, b.bad, bad);
}

nkw_result nkw_character_palette(const nkw_character *character, nkw_pose_view pose, const nkw_mat4 *root,
                                 nkw_mat4 *models, nkw_mat4 *palette)
{
    nkw_palette_source source = character->palette;
    const nkw_palette_span out = {palette, source.joint_count, NKW_PALETTE_MAT4};
    const nkw_result result = nkw_skeleton_models_from_pose(&character->skeleton, pose, root, NULL, models);
    source.models = models;
    return result == NKW_OK ? nkw_palette_from_models(&source, out) : result;
}

nkw_result nkw_character_vertices(const nkw_character *character, size_t part, const float *floats,
                                  const nkw_mat4 *palette, nkw_vertices_span out)
{
    if (part >= character->part_count)
        return NKW_OUT_OF_RANGE;
    const nkw_character_part *p = &character->parts[part];
    const float *weights = (floats ? floats : character->set.rest_floats) + p->float_first;
    nkw_skin_palette matrices;
    nkw_vertices_view in = p->vertices;
    memset(&matrices, 0, sizeof matrices);
    matrices.matrices.data = palette + p->matrix_first;
    matrices.matrices.joint_count = p->matrix_count;
    matrices.matrices.format = NKW_PALETTE_MAT4;
    matrices.options.inverse_normals = 1;
    if (p->morph.target_count > 0) {
        nkw_morph_apply(&p->morph, weights, in, out);
        const nkw_vec3_stream_view none = {NULL, 0};
        in.positions = in.positions.data ? NKW_VIEW(nkw_vec3_stream, out.positions) : none;
        in.normals = in.normals.data ? NKW_VIEW(nkw_vec3_stream, out.normals) : none;
        in.tangents = in.tangents.data ? NKW_VIEW(nkw_vec3_stream, out.tangents) : none;
        in.bitangents = in.bitangents.data ? NKW_VIEW(nkw_vec3_stream, out.bitangents) : none;
    }
    return nkw_skin_linear(&p->skin, &matrices, in, out);
}
