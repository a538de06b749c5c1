/* SPDX-License-Identifier: MIT */
/* Documents of any format: opening, closing, the order of nodes. */
#include "document.h"

#include <stdint.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "file.h"

void *nkwi_document_take(nkwi_document *document, nkw_import_error *error, const nkwi_place *place, size_t count,
                         size_t size)
{
    void *block = nkwi_take(&document->memory, count, size);
    if (!block && document->memory.exceeded)
        nkwi_fail(error, place, NKW_IMPORT_TOO_LARGE,
                  "%zu elements of %zu bytes: more than a file of %zu bytes may take", count, size,
                  document->all.bytes);
    else if (!block)
        nkwi_fail(error, place, NKW_IMPORT_NO_MEMORY, "no memory for %zu elements of %zu bytes", count, size);
    return block;
}

const char *nkwi_document_text(nkwi_document *document, nkw_import_error *error, const char *text)
{
    size_t bytes = strlen(text) + 1;
    char *copy = (char *)nkwi_document_take(document, error, NULL, bytes, 1);
    return copy ? (const char *)memcpy(copy, text, bytes) : NULL;
}

const char *nkwi_document_name(nkwi_document *document, nkw_import_error *error, const char *name, const char *kind,
                               size_t number)
{
    char made[64];
    if (name && *name)
        return nkwi_document_text(document, error, name);
    snprintf(made, sizeof made, "%s_%zu", kind, number);
    return nkwi_document_text(document, error, made);
}

int nkwi_document_warn(nkwi_document *d, nkw_import_error *error, const char *format, ...)
{
    char text[200];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    nkwi_tame(text);
    if (!d->warnings)
        d->warnings = (const char **)nkwi_document_take(d, error, NULL, NKWI_WARNINGS, sizeof *d->warnings);
    d->all.warnings = d->warnings;
    if (!d->warnings || d->all.warning_count == NKWI_WARNINGS)
        return d->warnings != NULL;
    const char *copy = nkwi_document_text(d, error, text);
    if (copy)
        d->warnings[d->all.warning_count++] = copy;
    return copy != NULL;
}

/* The places of the morph weights of each joint, after those of the joints before it. */
static int place_weights(nkwi_document *d, nkw_import_error *error, const nkwi_place *place)
{
    static const uint32_t most = (uint32_t)1 << 29; /* of nkw_clip_build */
    for (size_t j = 0; j < d->all.skeleton.joint_count; j++) {
        nkw_document_node *node = &d->nodes[j];
        size_t count = node->mesh == NKW_NO_JOINT ? 0 : d->all.meshes[node->mesh].target_count;
        const nkwi_place at = {place, NULL, node->number};
        if (count > most - d->all.float_count)
            return nkwi_fail(error, &at, NKW_IMPORT_TOO_LARGE, "more than %lu morph weights", (unsigned long)most);
        node->float_first = (uint32_t)d->all.float_count;
        node->float_count = (uint32_t)count;
        d->all.float_count += count;
    }
    return 1;
}

static int copy_weights(nkwi_document *d, nkw_import_error *error, const nkwi_place *place)
{
    float *floats = (float *)nkwi_document_take(d, error, place, d->all.float_count, sizeof *floats);
    for (size_t j = 0; floats && j < d->all.skeleton.joint_count; j++)
        if (d->nodes[j].float_count > 0)
            memcpy(floats + d->nodes[j].float_first, d->all.meshes[d->nodes[j].mesh].weights,
                   d->nodes[j].float_count * sizeof *floats);
    d->all.rest_floats = d->rest_floats = floats;
    return floats != NULL;
}

int nkwi_document_nodes(nkwi_document *d, nkw_import_error *error, const nkwi_place *place,
                        const nkw_document_node *list, const int32_t *node_parents, size_t count)
{
    int32_t *maps = (int32_t *)nkwi_document_take(d, error, place, count, 3 * sizeof *maps);
    d->nodes = (nkw_document_node *)nkwi_document_take(d, error, place, count, sizeof *d->nodes);
    float *rest = (float *)nkwi_document_take(d, error, place, nkw_pose_floats(count), sizeof *rest);
    size_t bad = 0;
    if (!maps || !d->nodes || !rest)
        return 0;
    int32_t *joint_of_node = maps, *node_of_joint = maps + count, *parents = maps + 2 * count;
    /* A file of meshes or materials only has no nodes. */
    nkw_result result =
        count ? nkw_skeleton_from_parents(node_parents, count, joint_of_node, node_of_joint, parents, &bad) : NKW_OK;
    const nkwi_place at = {place, NULL, bad};
    if (result != NKW_OK) {
        error->result = result;
        return nkwi_fail(error, &at, NKW_IMPORT_INVALID, "the node is a descendant of itself, or of such a node");
    }
    const nkw_pose_span pose = {rest, count};
    nkw_pose_identity(pose);
    for (size_t j = 0; j < count; j++) {
        d->nodes[j] = list[node_of_joint[j]];
        nkw_pose_set(pose, j, &d->nodes[j].rest);
    }
    d->all.nodes = d->nodes;
    d->all.joint_of_node = joint_of_node;
    d->all.skeleton.parents = parents;
    d->all.skeleton.joint_count = count;
    d->all.rest = NKW_VIEW(nkw_pose, pose);
    return place_weights(d, error, place) && copy_weights(d, error, place);
}

/* The names that clips store. */
static int name_clips(nkwi_document *d, nkw_import_error *error)
{
    const size_t joints = d->all.skeleton.joint_count, count = d->all.animation_count;
    const char **names = (const char **)nkwi_document_take(d, error, NULL, joints, sizeof *names);
    nkw_clip_names *clips = (nkw_clip_names *)nkwi_document_take(d, error, NULL, count, sizeof *clips);
    const char **floats = (const char **)nkwi_document_take(d, error, NULL, d->all.float_count, sizeof *floats);
    if (!names || !clips || !floats)
        return 0;
    for (size_t j = 0; j < joints; j++) {
        const nkw_document_node *node = &d->nodes[j];
        names[j] = node->name;
        for (size_t k = 0; k < node->float_count; k++)
            floats[node->float_first + k] = d->all.meshes[node->mesh].target_names[k];
    }
    for (size_t i = 0; i < count; i++) {
        clips[i].clip = d->all.animations[i].name;
        clips[i].joints = names;
        clips[i].floats = floats;
    }
    d->all.clip_names = clips;
    return 1;
}

static int read_format(nkwi_document *d, const nkw_import_memory *memory, nkw_import_error *error)
{
    if (nkwi_gltf_is(memory->data, memory->bytes))
        return nkwi_gltf_read(d, memory, error);
    if (nkwi_bvh_is(memory->data, memory->bytes))
        return nkwi_bvh_read(d, memory, error);
    if (nkwi_obj_is(memory->data, memory->bytes))
        return nkwi_obj_read(d, memory, error);
    if (nkwi_keys_is(memory->data, memory->bytes))
        return nkwi_keys_read(d, memory, error);
#if defined(NKWI_ASSIMP)
    if (nkwi_assimp_is(memory))
        return nkwi_assimp_read(d, memory, error);
#endif
    if (memory->bytes > 0 && nkwi_obj_is_named(memory->file))
        return nkwi_obj_read(d, memory, error);
    return nkwi_fail(error, NULL, NKW_IMPORT_UNKNOWN, memory->bytes ? "no format that is read" : "the file is empty");
}

void nkwi_document_boxes(nkwi_document *d)
{
    for (size_t m = 0; m < d->all.mesh_count; m++)
        for (size_t k = 0; k < d->all.meshes[m].primitive_count; k++) {
            /* Memory of the document. */
            nkw_document_primitive *p = (nkw_document_primitive *)&d->all.meshes[m].primitives[k];
            p->box = nkw_box_from_points(p->positions, p->positions ? p->vertex_count : 0);
        }
}

static int read_document(nkwi_document *d, const nkw_import_memory *memory, nkw_import_error *error)
{
    d->memory.most = NKWI_MEMORY_MOST(memory->bytes);
    d->all.bytes = memory->bytes;
    d->all.scene = NKW_NO_JOINT;
    d->v_is_up = memory->v_is_up;
    d->all.file = nkwi_document_text(d, error, memory->file ? memory->file : "");
    d->all.generator = "";
    if (!d->all.file)
        return 0;
    if (!read_format(d, memory, error) || !name_clips(d, error))
        return 0;
    nkwi_document_boxes(d);
    return 1;
}

static nkw_import_result open_document(const nkw_import_memory *memory, int wants_obj, nkw_document **document,
                                       nkw_import_error *error)
{
    nkwi_document *d = (nkwi_document *)calloc(1, sizeof *d);
    if (d)
        d->wants_obj = wants_obj;
    if (!d)
        nkwi_fail(error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for a document");
    else if (!read_document(d, memory, error))
        nkw_document_close(&d->all);
    else
        *document = &d->all;
    return error->code;
}

int nkwi_document_reader(nkw_import_memory *memory, char **folder, nkw_import_error *error)
{
    *folder = NULL;
    if (memory->reader || !memory->folder)
        return 1;
    size_t length = strlen(memory->folder);
    *folder = (char *)malloc(length + 2);
    if (!*folder)
        return nkwi_fail(error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the name of the folder");
    memcpy(*folder, memory->folder, length + 1);
    if (length > 0 && memory->folder[length - 1] != '/')
        memcpy(*folder + length, "/", 2);
    memory->reader = nkwi_folder_reader;
    memory->user = *folder;
    return 1;
}

nkw_import_result nkwi_document_from_memory(const nkw_import_memory *memory, int wants_obj, nkw_document **document,
                                            nkw_import_error *error)
{
    nkw_import_memory from = *memory;
    char *folder = NULL;
    nkwi_fault_none(error, memory->file ? memory->file : "");
    *document = NULL;
    if (nkwi_document_reader(&from, &folder, error))
        open_document(&from, wants_obj, document, error);
    free(folder);
    return error->code;
}

nkw_import_result nkw_document_from_memory(const nkw_import_memory *memory, nkw_document **document,
                                           nkw_import_error *error)
{
    nkw_import_error other;
    return nkwi_document_from_memory(memory, 0, document, error ? error : &other);
}

nkw_import_result nkwi_document_open(const char *path, int wants_obj, nkw_document **document, nkw_import_error *error)
{
    nkw_import_memory memory = {NULL, 0, path, NULL, nkwi_folder_reader, NULL, 0, 0};
    void *data;
    nkwi_fault_none(error, path);
    *document = NULL;
    if (!nkwi_file_read(error, path, &data, &memory.bytes))
        return error->code;
    char *folder = nkwi_folder_of(path);
    memory.data = data;
    memory.user = folder;
    if (!folder)
        nkwi_fail(error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the name of the folder");
    else
        open_document(&memory, wants_obj, document, error);
    free(folder);
    free(data);
    return error->code;
}

nkw_import_result nkw_document_open(const char *path, nkw_document **document, nkw_import_error *error)
{
    nkw_import_error other;
    return nkwi_document_open(path, 0, document, error ? error : &other);
}

void nkw_document_close(nkw_document *document)
{
    nkwi_document *d = (nkwi_document *)(void *)document;
    if (d) {
        nkwi_give(&d->memory);
        free(d);
    }
}
