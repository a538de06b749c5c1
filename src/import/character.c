/* SPDX-License-Identifier: MIT */
/* The character of a document: its source, from what the document points to. */
#include <stdlib.h>
#include <string.h>

#include "fault.h"

/* The arrays of a source, in one block of memory. */
typedef struct arrays {
    nkw_trs *rest;
    const char **names;
    nkw_character_animation *animations;
    nkw_character_skin *skins;
    nkw_character_part *parts;
    nkw_morph_target *targets;
    size_t part_count, target_count, most_tracks;
    void *work;
} arrays;

static const nkw_document_mesh *mesh_of(const nkw_document *d, size_t joint)
{
    return d->nodes[joint].mesh == NKW_NO_JOINT ? NULL : &d->meshes[d->nodes[joint].mesh];
}

static void count_all(const nkw_document *d, arrays *a)
{
    for (size_t j = 0; j < d->skeleton.joint_count; j++) {
        const nkw_document_mesh *mesh = mesh_of(d, j);
        a->part_count += mesh ? mesh->primitive_count : 0;
        a->target_count += mesh ? mesh->primitive_count * mesh->target_count : 0;
    }
    for (size_t i = 0; i < d->animation_count; i++)
        if (d->animations[i].track_count > a->most_tracks)
            a->most_tracks = d->animations[i].track_count;
}

static int take_all(const nkw_document *d, arrays *a)
{
    a->rest = (nkw_trs *)calloc(d->skeleton.joint_count + 1, sizeof *a->rest);
    a->names = (const char **)calloc(d->skeleton.joint_count + 1, sizeof *a->names);
    a->animations = (nkw_character_animation *)calloc(d->animation_count + 1, sizeof *a->animations);
    a->skins = (nkw_character_skin *)calloc(d->skin_count + 1, sizeof *a->skins);
    a->parts = (nkw_character_part *)calloc(a->part_count + 1, sizeof *a->parts);
    a->targets = (nkw_morph_target *)calloc(a->target_count + 1, sizeof *a->targets);
    a->work = malloc(NKW_CHARACTER_WORK(d->skeleton.joint_count, a->most_tracks) + 16);
    return a->rest && a->names && a->animations && a->skins && a->parts && a->targets && a->work;
}

static void free_all(arrays *a)
{
    free(a->rest);
    free(a->names);
    free(a->animations);
    free(a->skins);
    free(a->parts);
    free(a->targets);
    free(a->work);
}

static nkw_vec3_stream_view stream(const void *data, size_t stride)
{
    const nkw_vec3_stream_view view = {data, stride};
    return view;
}

/* `targets` receives the targets of the primitive. */
static nkw_character_part part_of(const nkw_document *d, size_t joint, const nkw_document_primitive *p,
                                  nkw_morph_target *targets)
{
    const nkw_document_node *node = &d->nodes[joint];
    nkw_character_part part;
    memset(&part, 0, sizeof part);
    part.joint = (int32_t)joint;
    part.skin_index = p->influence_count > 0 ? node->skin : NKW_NO_JOINT;
    part.vertices.positions = stream(p->positions, 0);
    part.vertices.normals = stream(p->normals, 0);
    part.vertices.tangents = stream(p->tangents, 4 * sizeof *p->tangents);
    part.skin = p->skin;
    part.skin.vertex_count = p->vertex_count;
    part.float_first = node->float_first;
    part.morph.targets = targets;
    part.morph.target_count = p->target_count;
    part.morph.vertex_count = p->vertex_count;
    for (size_t k = 0; k < p->target_count; k++) {
        targets[k].deltas.positions = stream(p->targets[k].positions, 0);
        targets[k].deltas.normals = stream(p->targets[k].normals, 0);
        targets[k].deltas.tangents = stream(p->targets[k].tangents, 0);
    }
    return part;
}

static void fill_parts(const nkw_document *d, arrays *a)
{
    nkw_character_part *part = a->parts;
    nkw_morph_target *targets = a->targets;
    for (size_t j = 0; j < d->skeleton.joint_count; j++) {
        const nkw_document_mesh *mesh = mesh_of(d, j);
        for (size_t k = 0; mesh && k < mesh->primitive_count; k++) {
            *part++ = part_of(d, j, &mesh->primitives[k], targets);
            targets += mesh->primitives[k].target_count;
        }
    }
}

static nkw_character_source source_of(const nkw_document *d, const arrays *a, nkw_clip_format format)
{
    nkw_character_source source;
    memset(&source, 0, sizeof source);
    for (size_t j = 0; j < d->skeleton.joint_count; j++) {
        a->rest[j] = d->nodes[j].rest;
        a->names[j] = d->nodes[j].name;
    }
    for (size_t i = 0; i < d->animation_count; i++) {
        a->animations[i].name = d->animations[i].name;
        a->animations[i].tracks = d->animations[i].tracks;
        a->animations[i].track_count = d->animations[i].track_count;
    }
    for (size_t i = 0; i < d->skin_count; i++) {
        a->skins[i].joints = d->skins[i].joints;
        a->skins[i].inverse_bind = d->skins[i].inverse_bind;
        a->skins[i].joint_count = d->skins[i].joint_count;
    }
    source.node_parents = d->skeleton.parents;
    source.node_count = d->skeleton.joint_count;
    source.rest = a->rest;
    source.names = a->names;
    source.animations = a->animations;
    source.animation_count = d->animation_count;
    source.rest_floats = d->rest_floats;
    source.float_count = d->float_count;
    source.skins = a->skins;
    source.skin_count = d->skin_count;
    source.parts = a->parts;
    source.part_count = a->part_count;
    source.format = format;
    return source;
}

nkw_import_result nkw_document_character(const nkw_document *document, nkw_clip_format format, nkw_bytes_span block,
                                         size_t *bytes, nkw_character *character, nkw_import_error *error)
{
    nkw_import_error other;
    arrays a;
    error = error ? error : &other;
    memset(&a, 0, sizeof a);
    nkwi_fault_none(error, document->file);
    *bytes = 0;
    count_all(document, &a);
    if (!take_all(document, &a))
        nkwi_fail(error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the arrays of a character");
    else {
        fill_parts(document, &a);
        const nkw_character_source source = source_of(document, &a, format);
        const size_t most = NKW_CHARACTER_WORK(source.node_count, a.most_tracks);
        const nkw_work work = {(unsigned char *)a.work + (16 - (size_t)a.work % 16) % 16, most};
        const nkw_result result = nkw_character_build(&source, block, bytes, character, NULL, work);
        /* The same error, with its place. */
        if (result != NKW_OK && (*bytes > 0 || nkw_document_validate(document, error) == NKW_IMPORT_OK)) {
            error->result = result;
            nkwi_fail(error, NULL, NKW_IMPORT_REFUSED, "%s", nkw_result_text(result));
        }
    }
    free_all(&a);
    return error->code;
}
