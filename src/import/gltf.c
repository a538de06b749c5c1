/* SPDX-License-Identifier: MIT */
/* glTF 2.0: the container (4.4), versions and extensions; then the parts. */
#include "gltf.h"

#include <stdio.h>
#include <string.h>

void *nkwi_gltf_take(nkwi_gltf *g, const nkwi_value *at, size_t count, size_t size)
{
    return nkwi_document_take(g->document, g->error, &at->place, count, size);
}

void *nkwi_gltf_scratch(nkwi_gltf *g, const nkwi_value *at, size_t count, size_t size)
{
    void *block = nkwi_take(&g->scratch, count, size);
    if (!block)
        nkwi_fail(g->error, &at->place, NKW_IMPORT_NO_MEMORY, "no memory for %zu elements of %zu bytes", count, size);
    return block;
}

const char *nkwi_gltf_name(nkwi_gltf *g, const nkwi_value *object, const char *kind)
{
    return nkwi_document_name(g->document, g->error, nkwi_text(object, "name", NULL), kind, object->place.index);
}

int nkwi_gltf_list(nkwi_gltf *g, const char *key, nkwi_value *list, size_t *count)
{
    *list = nkwi_member(&g->root, key);
    *count = nkwi_length(list);
    return nkwi_is_array(g->error, list);
}

void *nkwi_gltf_each(nkwi_gltf *g, const char *key, size_t size, nkwi_gltf_reader read, size_t *count)
{
    nkwi_value list;
    if (!nkwi_gltf_list(g, key, &list, count))
        return NULL;
    unsigned char *elements = (unsigned char *)nkwi_gltf_take(g, &list, *count, size);
    for (size_t i = 0; elements && i < *count; i++) {
        nkwi_value object = nkwi_element(&list, i);
        if (!read(g, &object, elements + i * size))
            return NULL;
    }
    return elements;
}

/*
 * Extensions without which nodes, meshes, skins and animations are complete: of materials, images, lights, rights,
 * metadata, physics, sound; and pointers, which animations list as not read.
 */
static int is_ignorable(const char *extension)
{
    static const char *const beginnings[] = {"KHR_materials_",
                                             "KHR_texture_",
                                             "EXT_texture_",
                                             "MSFT_texture_",
                                             "KHR_lights_",
                                             "EXT_lights_",
                                             "KHR_xmp",
                                             "KHR_mesh_quantization",
                                             "KHR_node_visibility",
                                             "KHR_techniques_",
                                             "FB_ngon_encoding",
                                             "MSFT_lod",
                                             "ADOBE_materials_",
                                             "VRM",
                                             "EXT_materials_",
                                             "GOOGLE_texture_",
                                             "MSFT_packing_",
                                             "EXT_structural_metadata",
                                             "EXT_mesh_features",
                                             "EXT_instance_features",
                                             "CESIUM_primitive_outline",
                                             "AGI_",
                                             "KHR_interactivity",
                                             "KHR_physics_",
                                             "OMI_physics_",
                                             "MSFT_audio_",
                                             "KHR_audio_",
                                             "KHR_animation_pointer"};
    for (size_t i = 0; i < sizeof beginnings / sizeof *beginnings; i++)
        if (strncmp(extension, beginnings[i], strlen(beginnings[i])) == 0)
            return 1;
    return 0;
}

static int check_extensions(nkwi_gltf *g)
{
    nkwi_value list;
    size_t count;
    if (!nkwi_gltf_list(g, "extensionsRequired", &list, &count))
        return 0;
    for (size_t i = 0; i < count; i++) {
        nkwi_value element = nkwi_element(&list, i);
        const char *name = json_string_value(element.json);
        if (!name)
            return nkwi_fail(g->error, &element.place, NKW_IMPORT_INVALID, "is no name");
        if (!is_ignorable(name))
            return nkwi_fail(g->error, &element.place, NKW_IMPORT_UNSUPPORTED,
                             "the file requires the extension %s, which is not read", name);
    }
    return 1;
}

/* 3.2: the version is major.minor; a file for a later minor version is valid where minVersion allows it. */
static int check_version(nkwi_gltf *g)
{
    nkwi_value asset = nkwi_member(&g->root, "asset"), at = nkwi_member(&asset, "version");
    if (!nkwi_is_object(g->error, &g->root) || !nkwi_is_object(g->error, &asset))
        return 0;
    const char *version = nkwi_text(&asset, "version", NULL), *least = nkwi_text(&asset, "minVersion", "2.0");
    if (!version)
        return nkwi_fail(g->error, &at.place, NKW_IMPORT_INVALID, "is missing");
    if (strncmp(version, "2.", 2) != 0 || strcmp(least, "2.0") != 0)
        return nkwi_fail(g->error, &at.place, NKW_IMPORT_UNSUPPORTED, "version %s is not read, only 2.0",
                         strcmp(least, "2.0") != 0 ? least : version);
    g->document->all.generator = nkwi_document_text(g->document, g->error, nkwi_text(&asset, "generator", ""));
    return g->document->all.generator != NULL;
}

int nkwi_gltf_begin(nkwi_gltf *g)
{
    size_t views, buffers;
    if (!nkwi_gltf_list(g, "accessors", &g->accessor_list, &g->accessor_count) ||
        !nkwi_gltf_list(g, "bufferViews", &g->view_list, &views) ||
        !nkwi_gltf_list(g, "buffers", &g->buffer_list, &buffers))
        return 0;
    g->buffers = (nkwi_buffer *)nkwi_gltf_scratch(g, &g->buffer_list, buffers, sizeof *g->buffers);
    g->accessors = (nkwi_accessor *)nkwi_gltf_scratch(g, &g->accessor_list, g->accessor_count, sizeof *g->accessors);
    return g->buffers && g->accessors;
}

static int read_parts(nkwi_gltf *g)
{
    nkwi_value list;
    if (!check_version(g) || !check_extensions(g) || !nkwi_gltf_list(g, "nodes", &list, &g->node_count) ||
        !nkwi_gltf_list(g, "meshes", &list, &g->mesh_count) || !nkwi_gltf_list(g, "skins", &list, &g->skin_count) ||
        !nkwi_gltf_list(g, "materials", &list, &g->material_count))
        return 0;
    return nkwi_gltf_begin(g) && nkwi_gltf_images(g) && nkwi_gltf_materials(g) && nkwi_gltf_meshes(g) &&
           nkwi_gltf_nodes(g) && nkwi_gltf_skins(g) && nkwi_gltf_animations(g) && nkwi_gltf_scenes(g);
}

static uint32_t number_at(const unsigned char *p)
{
    return (uint32_t)p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
}

static int is_glb(const void *data, size_t bytes)
{
    return bytes >= 4 && memcmp(data, "glTF", 4) == 0;
}

enum { CHUNK_JSON = 0x4e4f534a, CHUNK_BIN = 0x004e4942, GLB_HEADER = 12, CHUNK_HEADER = 8 };

/* 4.4: the JSON chunk, and the binary one that may follow. */
static int split_glb(nkwi_gltf *g, const unsigned char **json, size_t *json_bytes)
{
    const unsigned char *data = (const unsigned char *)g->memory->data;
    size_t bytes = g->memory->bytes;
    if (bytes < GLB_HEADER + CHUNK_HEADER)
        return nkwi_fail_at(g->error, "byte 0", NKW_IMPORT_INVALID, "a GLB of %zu bytes has no chunk", bytes);
    uint32_t version = number_at(data + 4), length = number_at(data + 8), chunk = number_at(data + GLB_HEADER);
    if (version != 2)
        return nkwi_fail_at(g->error, "byte 4", NKW_IMPORT_UNSUPPORTED, "GLB version %u is not read, only 2",
                            (unsigned)version);
    if (length > bytes || length < GLB_HEADER + CHUNK_HEADER)
        return nkwi_fail_at(g->error, "byte 8", NKW_IMPORT_INVALID, "the length is %u bytes, the file has %zu",
                            (unsigned)length, bytes);
    size_t left = length - GLB_HEADER - CHUNK_HEADER;
    if (number_at(data + GLB_HEADER + 4) != CHUNK_JSON)
        return nkwi_fail_at(g->error, "byte 16", NKW_IMPORT_INVALID, "the first chunk is not JSON");
    if (chunk > left)
        return nkwi_fail_at(g->error, "byte 12", NKW_IMPORT_INVALID, "the chunk has %u bytes, the file has %zu more",
                            (unsigned)chunk, left);
    *json = data + GLB_HEADER + CHUNK_HEADER;
    *json_bytes = chunk;
    left -= chunk;
    if (left < CHUNK_HEADER || number_at(*json + chunk + 4) != CHUNK_BIN)
        return 1;
    g->bin = *json + chunk + CHUNK_HEADER;
    g->bin_bytes = number_at(*json + chunk);
    if (g->bin_bytes > left - CHUNK_HEADER) {
        char place[32];
        snprintf(place, sizeof place, "byte %zu", (size_t)(*json - data) + chunk);
        return nkwi_fail_at(g->error, place, NKW_IMPORT_INVALID, "the chunk has %zu bytes, the file has %zu more",
                            g->bin_bytes, left - CHUNK_HEADER);
    }
    return 1;
}

/* Texts may have a byte order mark before them, which JSON does not allow. */
static size_t mark_of(const void *data, size_t bytes)
{
    return bytes >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
}

int nkwi_gltf_is(const void *data, size_t bytes)
{
    const char *text = (const char *)data;
    size_t i = mark_of(data, bytes);
    while (i < bytes && (text[i] == ' ' || text[i] == '\t' || text[i] == '\r' || text[i] == '\n'))
        i++;
    return is_glb(data, bytes) || (i < bytes && text[i] == '{');
}

static json_t *parse(nkwi_gltf *g, const unsigned char *text, size_t bytes, size_t flags)
{
    json_error_t wrong;
    char place[64];
    json_t *tree = json_loadb((const char *)text, bytes, JSON_REJECT_DUPLICATES | JSON_ALLOW_NUL | flags, &wrong);
    if (tree)
        return tree;
    size_t before = (size_t)(text - (const unsigned char *)g->memory->data);
    if (is_glb(g->memory->data, g->memory->bytes))
        snprintf(place, sizeof place, "byte %zu", before + (size_t)(wrong.position > 0 ? wrong.position : 0));
    else
        snprintf(place, sizeof place, "line %d, column %d", wrong.line, wrong.column);
    nkwi_fail_at(g->error, place, NKW_IMPORT_INVALID, "JSON: %s", wrong.text);
    return NULL;
}

json_t *nkwi_gltf_open(nkwi_gltf *g, nkwi_document *document, const nkw_import_memory *memory, size_t flags,
                       nkw_import_error *error)
{
    size_t bytes = memory->bytes;
    const unsigned char *text = (const unsigned char *)memory->data;
    memset(g, 0, sizeof *g);
    g->document = document;
    g->memory = memory;
    g->error = error;
    g->scratch.most = SIZE_MAX;
    if (is_glb(memory->data, memory->bytes) && !split_glb(g, &text, &bytes))
        return NULL;
    for (; text != memory->data && bytes > 0 && text[bytes - 1] == 0; bytes--)
        g->zeros++; /* behind the JSON of a GLB, in place of spaces */
    size_t mark = mark_of(text, bytes);
    json_t *tree = parse(g, text + mark, bytes - mark, flags);
    g->root = nkwi_root(tree);
    return tree;
}

/* Integers become doubles, which hold all that are valid. */
int nkwi_gltf_read(nkwi_document *document, const nkw_import_memory *memory, nkw_import_error *error)
{
    nkwi_gltf g;
    json_t *tree = nkwi_gltf_open(&g, document, memory, JSON_DECODE_INT_AS_REAL, error);
    if (!tree)
        return 0;
    const nkw_document_space space = {NKW_AXES_GLTF, 1.0f};
    document->all.format = "glTF 2.0";
    document->all.space = space;
    if (g.zeros && !nkwi_document_warn(document, error, "the JSON chunk ends with %zu zero bytes in place of spaces",
                                       g.zeros)) {
        json_decref(tree);
        return 0;
    }
    int done = nkwi_keys_are(&g.root) ? nkwi_keys_read_tree(document, &g.root, error) : read_parts(&g);
    nkwi_give(&g.scratch);
    json_decref(tree);
    return done;
}
