/* SPDX-License-Identifier: MIT */
/* From documents to the structures of the library. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/transform.h>
#include <nakawari/vec.h>

#include "fault.h"

nkw_clip_source nkw_document_clip_source(const nkw_document *document, size_t animation, nkw_clip_format format)
{
    nkw_clip_source source = {
        NULL,   0,   document->skeleton.joint_count, document->float_count, document->rest, document->rest_floats,
        format, NULL};
    if (animation < document->animation_count) {
        source.tracks = document->animations[animation].tracks;
        source.track_count = document->animations[animation].track_count;
        source.names = document->clip_names + animation;
    }
    return source;
}

/* The error of a track of an animation, or of the clip as a whole. */
static void refuse_track(const nkw_document *document, size_t animation, nkw_result result, size_t bad,
                         nkw_import_error *error)
{
    const nkwi_place root = {NULL, NULL, 0}, list = {&root, "animations", 0}, at = {&list, NULL, animation};
    const nkwi_place channels = {&at, "channels", 0};
    size_t key = 0;
    error->result = result;
    if (animation >= document->animation_count || document->animations[animation].track_count == 0) {
        nkwi_fail(error, &list, NKW_IMPORT_REFUSED, "%s", nkw_result_text(result));
        return;
    }
    const nkw_document_animation *a = &document->animations[animation];
    const nkwi_place channel = {&channels, NULL, a->channels[bad].number};
    if (nkw_track_validate(&a->tracks[bad].track, &key) == result)
        nkwi_fail(error, &channel, NKW_IMPORT_REFUSED, "key %zu: %s", key, nkw_result_text(result));
    else
        nkwi_fail(error, &channel, NKW_IMPORT_REFUSED, "%s", nkw_result_text(result));
}

/* Working memory and the size of the clip; work->data is to be freed. */
static int measure(const nkw_document *document, size_t animation, const nkw_clip_source *source, size_t *bytes,
                   nkw_work *work, nkw_import_error *error)
{
    const nkw_bytes_span none = {NULL, 0};
    size_t bad;
    work->bytes = NKW_CLIP_BUILD_WORK(source->track_count);
    work->data = malloc(work->bytes + 1);
    if (!work->data)
        return nkwi_fail(error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the clip");
    nkw_result result = nkw_clip_build(source, none, bytes, &bad, *work);
    if (*bytes == 0)
        refuse_track(document, animation, result, bad, error);
    return *bytes > 0;
}

nkw_import_result nkw_document_clip(const nkw_document *document, size_t animation, nkw_clip_format format,
                                    nkw_clip **clip, nkw_import_error *error)
{
    nkw_import_error other;
    const nkw_clip_source source = nkw_document_clip_source(document, animation, format);
    nkw_work work;
    nkw_bytes_span block = {NULL, 0};
    size_t bytes;
    error = error ? error : &other;
    nkwi_fault_none(error, document->file);
    *clip = NULL;
    if (measure(document, animation, &source, &block.bytes, &work, error)) {
        block.data = malloc(block.bytes);
        if (!block.data)
            nkwi_fail(error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for a clip of %zu bytes", block.bytes);
        else
            nkw_clip_build(&source, block, &bytes, NULL, work);
        *clip = (nkw_clip *)block.data;
    }
    free(work.data);
    return error->code;
}

void nkw_import_free(void *block)
{
    free(block);
}

nkw_result nkw_document_models(const nkw_document *document, nkw_pose_view pose, const nkw_mat4 *root, nkw_mat4 *models)
{
    size_t count = document->skeleton.joint_count;
    if (pose.joint_count != count)
        return NKW_MISMATCHED;
    for (size_t j = 0; j < count; j++) {
        nkw_trs local = nkw_pose_get(pose, j);
        models[j] = document->nodes[j].matrix ? *document->nodes[j].matrix : nkw_mat4_from_trs(&local);
    }
    nkw_skeleton_models_from_locals(&document->skeleton, models, root, NULL, models);
    return NKW_OK;
}

nkw_result nkw_document_mesh_joints(const nkw_document *document, int32_t root, int32_t *joints, size_t capacity,
                                    size_t *count)
{
    const size_t all = document->skeleton.joint_count, first = root == NKW_NO_JOINT ? 0 : (size_t)root;
    *count = 0;
    if (root < NKW_NO_JOINT || (root != NKW_NO_JOINT && first >= all))
        return NKW_OUT_OF_RANGE;
    const size_t end = root == NKW_NO_JOINT ? all : nkw_skeleton_subtree_end(&document->skeleton, first);
    for (size_t j = first; j < end; j++) {
        if (document->nodes[j].mesh == NKW_NO_JOINT)
            continue;
        if (*count < capacity)
            joints[*count] = (int32_t)j;
        ++*count;
    }
    return *count <= capacity ? NKW_OK : NKW_TOO_SMALL;
}

nkw_palette_source nkw_document_palette_source(const nkw_document *document, size_t skin, const nkw_mat4 *models)
{
    const nkw_document_skin *s = &document->skins[skin];
    const nkw_palette_source source = {models,        document->skeleton.joint_count, s->joints, s->inverse_bind, NULL,
                                       s->joint_count};
    return source;
}

nkw_result nkw_document_palette(const nkw_document *document, size_t skin, const nkw_mat4 *models, nkw_mat4 *palette)
{
    if (skin >= document->skin_count)
        return NKW_OUT_OF_RANGE;
    const nkw_palette_source source = nkw_document_palette_source(document, skin, models);
    const nkw_palette_span out = {palette, source.joint_count, NKW_PALETTE_MAT4};
    return nkw_palette_from_models(&source, out);
}

/* Adds the differences of one target. */
static void add_scaled(nkw_vec3 *out, const nkw_vec3 *differences, float weight, size_t count)
{
    for (size_t v = 0; differences && v < count; v++)
        out[v] = nkw_vec3_add_scaled(out[v], differences[v], weight);
}

void nkw_document_morph(const nkw_document_primitive *primitive, const float *weights, nkw_document_vertices_span out)
{
    size_t count = primitive->vertex_count;
    if (count == 0)
        return;
    memcpy(out.positions, primitive->positions, count * sizeof *out.positions);
    if (out.normals && primitive->normals)
        memcpy(out.normals, primitive->normals, count * sizeof *out.normals);
    else if (out.normals)
        memset(out.normals, 0, count * sizeof *out.normals);
    for (size_t k = 0; weights && k < primitive->target_count; k++) {
        if (weights[k] == 0.0f)
            continue;
        add_scaled(out.positions, primitive->targets[k].positions, weights[k], count);
        if (out.normals)
            add_scaled(out.normals, primitive->targets[k].normals, weights[k], count);
    }
}

/* Skins in place: normals by normal matrices, as the matrices may scale. */
static nkw_result move(const nkw_skin *skin, const nkw_mat4 *matrices, size_t matrix_count,
                       nkw_document_vertices_span out)
{
    nkw_mat3 *normals = (nkw_mat3 *)malloc(matrix_count * sizeof *normals);
    if (!normals)
        return NKW_TOO_SMALL;
    for (size_t i = 0; i < matrix_count; i++) {
        nkw_mat3 linear = nkw_mat3_from_mat4(&matrices[i]);
        normals[i] = nkw_mat3_normal(&linear);
    }
    const nkw_skin_palette palette = {
        {matrices, matrix_count, NKW_PALETTE_MAT4}, {normals, matrix_count, NKW_PALETTE_NORMAL_MAT3}, {0, 0, 0}};
    const nkw_vertices_view from = {{out.positions, 0}, {out.normals, 0}, {NULL, 0}, {NULL, 0}};
    const nkw_vertices_span to = {{out.positions, 0}, {out.normals, 0}, {NULL, 0}, {NULL, 0}};
    nkw_result result = nkw_skin_linear(skin, &palette, from, to);
    free(normals);
    return result;
}

nkw_result nkw_document_vertices(const nkw_document *document, size_t joint, size_t primitive,
                                 const nkw_document_moment *moment, nkw_document_vertices_span out)
{
    if (joint >= document->skeleton.joint_count || document->nodes[joint].mesh == NKW_NO_JOINT ||
        primitive >= document->meshes[document->nodes[joint].mesh].primitive_count)
        return NKW_OUT_OF_RANGE;
    const nkw_document_node *node = &document->nodes[joint];
    const nkw_document_primitive *from = &document->meshes[node->mesh].primitives[primitive];
    nkw_document_morph(from, (moment->floats ? moment->floats : document->rest_floats) + node->float_first, out);
    if (node->skin != NKW_NO_JOINT && from->influence_count > 0)
        return move(&from->skin, moment->palette, document->skins[node->skin].joint_count, out);
    for (size_t v = 0; v < from->vertex_count; v++)
        out.positions[v] = nkw_mat4_transform_point(&moment->models[joint], out.positions[v]);
    nkw_mat3 linear = nkw_mat3_from_mat4(&moment->models[joint]), normal = nkw_mat3_normal(&linear);
    for (size_t v = 0; out.normals && v < from->vertex_count; v++)
        out.normals[v] = nkw_vec3_normalize(nkw_mat3_transform(&normal, out.normals[v]));
    return NKW_OK;
}

/* The first vertex whose influences nkw_skin_linear would read otherwise than meant; NKW_OK if there is none. */
static nkw_result check_vertices(const nkw_document_primitive *p, size_t joint_count, size_t *bad)
{
    for (size_t i = 0; i < p->vertex_count * p->influence_count; i++) {
        *bad = i / p->influence_count;
        if (!isfinite(p->weights[i]))
            return NKW_NOT_FINITE;
        if (p->weights[i] < 0.0f)
            return NKW_BAD_WEIGHTS;
        if (p->weights[i] > 0.0f && p->joints[i] >= joint_count)
            return NKW_OUT_OF_RANGE;
    }
    return NKW_OK;
}

/* The skinned primitives of a joint. */
static int check_mesh(const nkw_document *document, const nkw_document_node *node, nkw_import_error *error)
{
    const nkw_document_mesh *mesh = &document->meshes[node->mesh];
    const nkwi_place root = {NULL, NULL, 0}, list = {&root, "meshes", 0}, at = {&list, NULL, (size_t)node->mesh};
    const nkwi_place primitives = {&at, "primitives", 0};
    for (size_t i = 0; i < mesh->primitive_count; i++) {
        const nkwi_place primitive = {&primitives, NULL, i};
        size_t bad;
        nkw_result result = check_vertices(&mesh->primitives[i], document->skins[node->skin].joint_count, &bad);
        error->result = result;
        if (result != NKW_OK)
            return nkwi_fail(error, &primitive, NKW_IMPORT_REFUSED, "vertex %zu: %s", bad, nkw_result_text(result));
    }
    return 1;
}

static int check_skin(const nkw_document *document, size_t skin, nkw_import_error *error)
{
    const nkwi_place root = {NULL, NULL, 0}, list = {&root, "skins", 0}, at = {&list, NULL, skin};
    const nkw_palette_source source = nkw_document_palette_source(document, skin, NULL);
    size_t bad;
    error->result = nkw_palette_source_validate(&source, &bad);
    return error->result == NKW_OK ||
           nkwi_fail(error, &at, NKW_IMPORT_REFUSED, "joint %zu of the skin: %s", bad, nkw_result_text(error->result));
}

nkw_import_result nkw_document_validate(const nkw_document *document, nkw_import_error *error)
{
    nkw_import_error other;
    int good = 1;
    error = error ? error : &other;
    nkwi_fault_none(error, document->file);
    for (size_t i = 0; good && i < document->animation_count; i++) {
        const nkw_clip_source source = nkw_document_clip_source(document, i, NKW_CLIP_FLOAT32);
        nkw_work work;
        size_t bytes;
        good = measure(document, i, &source, &bytes, &work, error);
        free(work.data);
    }
    for (size_t i = 0; good && i < document->skin_count; i++)
        good = check_skin(document, i, error);
    for (size_t j = 0; good && j < document->skeleton.joint_count; j++) {
        const nkw_document_node *node = &document->nodes[j];
        if (node->mesh != NKW_NO_JOINT && node->skin != NKW_NO_JOINT)
            good = check_mesh(document, node, error);
    }
    return error->code;
}
