/* SPDX-License-Identifier: MIT */
/* glTF 2.0, 3.7: meshes: attributes, sets of influences, morph targets, lists of triangles; and materials. */
#include <stdio.h>
#include <string.h>

#include "gltf.h"

/* The attribute `key`, where it is there: vertex_count elements of `width` floats. */
static int read_attribute(nkwi_gltf *g, const nkwi_value *attributes, const char *key, size_t width,
                          size_t vertex_count, const float **out)
{
    nkwi_value at = nkwi_member(attributes, key);
    size_t count;
    *out = NULL;
    if (!at.json)
        return 1;
    if (!nkwi_gltf_floats(g, attributes, key, width, NKWI_ANY, out, &count))
        return 0;
    return count == vertex_count ||
           nkwi_fail(g->error, &at.place, NKW_IMPORT_INVALID, "%zu elements for %zu vertices", count, vertex_count);
}

/* The same as vectors. */
static int read_vectors(nkwi_gltf *g, const nkwi_value *attributes, const char *key, size_t vertex_count,
                        const nkw_vec3 **out)
{
    const float *floats;
    int done = read_attribute(g, attributes, key, 3, vertex_count, &floats);
    *out = (const nkw_vec3 *)(const void *)floats;
    return done;
}

/* Sets are numbered from 0 without a gap (3.7.2.1). What comes after a gap is not read, and a warning says so. */
static int count_texcoords(nkwi_gltf *g, const nkwi_value *attributes, size_t *sets)
{
    const char *key;
    json_t *value;
    size_t named = 0;
    char next[32];
    json_object_foreach((json_t *)attributes->json, key, value) named += strncmp(key, "TEXCOORD_", 9) == 0;
    for (*sets = 0; *sets <= named; ++*sets) {
        snprintf(next, sizeof next, "TEXCOORD_%zu", *sets);
        if (!nkwi_member(attributes, next).json)
            break;
    }
    return *sets == named || nkwi_document_warn(g->document, g->error,
                                                "a primitive has %zu sets of texture coordinates, "
                                                "but no %s: %zu are read",
                                                named, next, *sets);
}

/* All sets of texture coordinates. */
static int read_texcoords(nkwi_gltf *g, const nkwi_value *attributes, nkw_document_primitive *out)
{
    if (!count_texcoords(g, attributes, &out->texcoord_count) || out->texcoord_count == 0)
        return out->texcoord_count == 0;
    const float **sets = (const float **)nkwi_gltf_take(g, attributes, out->texcoord_count, sizeof *sets);
    out->texcoords = sets;
    for (size_t set = 0; sets && set < out->texcoord_count; set++) {
        char key[32];
        size_t count;
        snprintf(key, sizeof key, "TEXCOORD_%zu", set);
        nkwi_value at = nkwi_member(attributes, key);
        if (!nkwi_gltf_texcoords(g, attributes, key, &sets[set], &count))
            return 0;
        if (count != out->vertex_count)
            return nkwi_fail(g->error, &at.place, NKW_IMPORT_INVALID, "%zu elements for %zu vertices", count,
                             out->vertex_count);
    }
    return sets != NULL;
}

/* COLOR_0: three components or four; alpha is 1 where there are three. */
static int read_colors(nkwi_gltf *g, const nkwi_value *attributes, nkw_document_primitive *out)
{
    int32_t index;
    const float *given;
    if (!nkwi_index(g->error, attributes, "COLOR_0", "accessor", g->accessor_count, &index))
        return 0;
    if (index == NKW_NO_JOINT)
        return 1;
    nkwi_value accessor = nkwi_element(&g->accessor_list, (size_t)index);
    if (strcmp(nkwi_text(&accessor, "type", ""), "VEC3") != 0)
        return read_attribute(g, attributes, "COLOR_0", 4, out->vertex_count, &out->colors);
    float *colors = (float *)nkwi_gltf_take(g, attributes, out->vertex_count, 4 * sizeof *colors);
    if (!colors || !read_attribute(g, attributes, "COLOR_0", 3, out->vertex_count, &given))
        return 0;
    for (size_t i = 0; i < out->vertex_count; i++) {
        memcpy(colors + 4 * i, given + 3 * i, 3 * sizeof *colors);
        colors[4 * i + 3] = 1.0f;
    }
    out->colors = colors;
    return 1;
}

/* 3.7.2.1: the lists that a mode means. `corner` returns the vertex of corner c of shape i of n. */
enum { MODE_POINTS, MODE_LINES, MODE_LOOP, MODE_STRIP, MODE_TRIANGLES, MODE_TRIANGLE_STRIP, MODE_TRIANGLE_FAN };

static size_t shape_count(size_t mode, size_t n)
{
    switch (mode) {
    case MODE_POINTS:
        return n;
    case MODE_LINES:
        return n / 2;
    case MODE_LOOP:
        return n < 2 ? 0 : n;
    case MODE_STRIP:
        return n < 2 ? 0 : n - 1;
    case MODE_TRIANGLES:
        return n / 3;
    default:
        return n < 3 ? 0 : n - 2;
    }
}

static size_t corner(size_t mode, size_t n, size_t i, size_t c)
{
    switch (mode) {
    case MODE_POINTS:
        return i;
    case MODE_LINES:
        return 2 * i + c;
    case MODE_LOOP:
        return i + c < n ? i + c : 0;
    case MODE_STRIP:
        return i + c;
    case MODE_TRIANGLES:
        return 3 * i + c;
    case MODE_TRIANGLE_STRIP:
        return i + (c == 0 ? 0 : c == 1 ? 1 + i % 2 : 2 - i % 2);
    default:
        return c == 2 ? 0 : i + 1 + c;
    }
}

/* `given`: n vertices, or NULL: 0, 1, 2 ... */
static int expand(nkwi_gltf *g, const nkwi_value *at, size_t mode, const uint32_t *given, size_t n,
                  nkw_document_primitive *out)
{
    size_t corners = mode == MODE_POINTS ? 1 : mode < MODE_TRIANGLES ? 2 : 3, shapes = shape_count(mode, n);
    uint32_t *list = (uint32_t *)nkwi_gltf_take(g, at, shapes, corners * sizeof *list);
    if (!list)
        return 0;
    for (size_t i = 0; i < shapes; i++)
        for (size_t c = 0; c < corners; c++) {
            size_t k = corner(mode, n, i, c);
            list[i * corners + c] = given ? given[k] : (uint32_t)k;
        }
    out->topology = (nkw_document_topology)(corners - 1);
    out->indices = list;
    out->index_count = shapes * corners;
    return 1;
}

static int read_indices(nkwi_gltf *g, const nkwi_value *object, nkw_document_primitive *out)
{
    nkwi_value at = nkwi_member(object, "indices"), mode_at = nkwi_member(object, "mode");
    const uint32_t *given = NULL;
    size_t n = out->vertex_count, mode;
    if (!nkwi_count(g->error, object, "mode", MODE_TRIANGLES, &mode))
        return 0;
    if (mode > MODE_TRIANGLE_FAN)
        return nkwi_fail(g->error, &mode_at.place, NKW_IMPORT_INVALID, "%zu is no mode", mode);
    if (n >= UINT32_MAX)
        return nkwi_fail(g->error, &object->place, NKW_IMPORT_TOO_LARGE, "%zu vertices are too many", n);
    if (!at.json)
        return expand(g, object, mode, NULL, n, out);
    if (!nkwi_gltf_integers(g, object, "indices", &given, &n))
        return 0;
    for (size_t i = 0; i < n; i++)
        if (given[i] >= out->vertex_count)
            return nkwi_fail(g->error, &at.place, NKW_IMPORT_INVALID,
                             "index %zu: vertex %lu does not exist: there are %zu", i, (unsigned long)given[i],
                             out->vertex_count);
    if (mode != MODE_TRIANGLES && mode != MODE_POINTS && mode != MODE_LINES)
        return expand(g, object, mode, given, n, out);
    size_t corners = mode == MODE_POINTS ? 1 : mode == MODE_LINES ? 2 : 3;
    out->topology = (nkw_document_topology)(corners - 1);
    out->indices = given;
    out->index_count = n - n % corners;
    return 1;
}

/* One set of four influences, of vertex_count vertices. *is_there is 0 after the last set. */
static int read_set(nkwi_gltf *g, const nkwi_value *attributes, size_t set, size_t vertex_count,
                    const uint16_t **joints, const float **weights, int *is_there)
{
    char joint_key[32], weight_key[32];
    size_t joint_count, weight_count;
    snprintf(joint_key, sizeof joint_key, "JOINTS_%zu", set);
    snprintf(weight_key, sizeof weight_key, "WEIGHTS_%zu", set);
    nkwi_value at = nkwi_member(attributes, joint_key);
    *is_there = at.json != NULL;
    if (!*is_there)
        return 1;
    if (!nkwi_gltf_shorts(g, attributes, joint_key, joints, &joint_count) ||
        !nkwi_gltf_floats(g, attributes, weight_key, 4, NKWI_NORMALIZED, weights, &weight_count))
        return 0;
    return (joint_count == vertex_count && weight_count == vertex_count) ||
           nkwi_fail(g->error, &at.place, NKW_IMPORT_INVALID, "%zu joints and %zu weights for %zu vertices",
                     joint_count, weight_count, vertex_count);
}

/* Joins sets: 4 `sets` influences for each vertex. */
static int join_sets(nkwi_gltf *g, const nkwi_value *attributes, size_t sets, nkw_document_primitive *out)
{
    size_t n = out->vertex_count, width = 4 * sets;
    uint16_t *joints = (uint16_t *)nkwi_gltf_take(g, attributes, n, width * sizeof *joints);
    float *weights = (float *)nkwi_gltf_take(g, attributes, n, width * sizeof *weights);
    if (!joints || !weights)
        return 0;
    for (size_t set = 0; set < sets; set++) {
        const uint16_t *from_joints = NULL;
        const float *from_weights = NULL;
        int is_there;
        if (!read_set(g, attributes, set, n, &from_joints, &from_weights, &is_there))
            return 0;
        for (size_t v = 0; v < n; v++) {
            memcpy(joints + v * width + 4 * set, from_joints + 4 * v, 4 * sizeof *joints);
            memcpy(weights + v * width + 4 * set, from_weights + 4 * v, 4 * sizeof *weights);
        }
    }
    out->joints = joints;
    out->weights = weights;
    return 1;
}

enum { SETS_MOST = 16 };

#define DRACO "KHR_draco_mesh_compression"

/* 3.7.3.3: the influences, as in the file and as nkw_skin_linear reads them. */
static int read_influences(nkwi_gltf *g, const nkwi_value *attributes, nkw_document_primitive *out)
{
    size_t sets = 0, n = out->vertex_count;
    const uint16_t *joints = NULL;
    const float *weights = NULL;
    int more = 1;
    while (more && sets <= SETS_MOST) {
        if (!read_set(g, attributes, sets, n, &joints, &weights, &more))
            return 0;
        sets += more ? 1 : 0;
        out->joints = sets == 1 ? joints : NULL;
        out->weights = sets == 1 ? weights : NULL;
    }
    if (sets > SETS_MOST)
        return nkwi_fail(g->error, &attributes->place, NKW_IMPORT_TOO_LARGE, "more than %d sets of joints", SETS_MOST);
    if (sets == 0 || (sets > 1 && !join_sets(g, attributes, sets, out)))
        return sets == 0;
    out->influence_count = 4 * sets;
    size_t keep = sets > 1 ? NKW_SKIN_INFLUENCES : 4;
    uint16_t *kept_joints = (uint16_t *)nkwi_gltf_take(g, attributes, n, keep * sizeof *kept_joints);
    float *kept_weights = (float *)nkwi_gltf_take(g, attributes, n, keep * sizeof *kept_weights);
    if (!kept_joints || !kept_weights)
        return 0;
    const nkw_skin all = {n, 4 * sets, {out->joints, 0, NKW_SKIN_U16}, {out->weights, 0, NKW_SKIN_F32}};
    const nkw_skin_span to_joints = {kept_joints, 0, NKW_SKIN_U16}, to_weights = {kept_weights, 0, NKW_SKIN_F32};
    const nkw_skin skin = {n, keep, {kept_joints, 0, NKW_SKIN_U16}, {kept_weights, 0, NKW_SKIN_F32}};
    nkw_skin_prune(&all, keep, to_joints, to_weights);
    out->skin = skin;
    return 1;
}

static int read_targets(nkwi_gltf *g, const nkwi_value *object, nkw_document_primitive *out)
{
    nkwi_value list = nkwi_member(object, "targets");
    if (!nkwi_is_array(g->error, &list))
        return 0;
    size_t count = nkwi_length(&list), n = out->vertex_count;
    nkw_document_target *targets = (nkw_document_target *)nkwi_gltf_take(g, &list, count, sizeof *targets);
    for (size_t i = 0; targets && i < count; i++) {
        nkwi_value target = nkwi_element(&list, i);
        if (!nkwi_is_object(g->error, &target) || !read_vectors(g, &target, "POSITION", n, &targets[i].positions) ||
            !read_vectors(g, &target, "NORMAL", n, &targets[i].normals) ||
            !read_vectors(g, &target, "TANGENT", n, &targets[i].tangents))
            return 0;
    }
    out->targets = targets;
    out->target_count = count;
    return targets != NULL;
}

/* Accessors of compressed primitives have no buffer view: they would be zeros. */
static int check_compression(nkwi_gltf *g, const nkwi_value *object, const nkwi_value *attributes)
{
    nkwi_value extensions = nkwi_member(object, "extensions"), draco = nkwi_member(&extensions, DRACO);
    int32_t index;
    if (!draco.json || !nkwi_index(g->error, attributes, "POSITION", "accessor", g->accessor_count, &index))
        return !draco.json;
    if (index == NKW_NO_JOINT)
        return 1;
    nkwi_value accessor = nkwi_element(&g->accessor_list, (size_t)index);
    return nkwi_member(&accessor, "bufferView").json != NULL ||
           nkwi_fail(g->error, &draco.place, NKW_IMPORT_UNSUPPORTED, "the extension %s is not read", DRACO);
}

/* A primitive without positions has no vertices. */
static int read_primitive(nkwi_gltf *g, const nkwi_value *object, nkw_document_primitive *out)
{
    nkwi_value attributes = nkwi_member(object, "attributes");
    const float *positions;
    if (!nkwi_is_object(g->error, object) || !nkwi_is_object(g->error, &attributes) ||
        !nkwi_index(g->error, object, "material", "material", g->material_count, &out->material) ||
        !check_compression(g, object, &attributes))
        return 0;
    if (!nkwi_member(&attributes, "POSITION").json)
        return read_targets(g, object, out) && expand(g, object, MODE_POINTS, NULL, 0, out);
    if (!nkwi_gltf_floats(g, &attributes, "POSITION", 3, NKWI_ANY, &positions, &out->vertex_count))
        return 0;
    out->positions = (const nkw_vec3 *)(const void *)positions;
    return read_vectors(g, &attributes, "NORMAL", out->vertex_count, &out->normals) &&
           read_attribute(g, &attributes, "TANGENT", 4, out->vertex_count, &out->tangents) &&
           read_texcoords(g, &attributes, out) && read_colors(g, &attributes, out) && read_indices(g, object, out) &&
           read_influences(g, &attributes, out) && read_targets(g, object, out);
}

/* Names are a convention of exporters: mesh.extras.targetNames. */
static int name_targets(nkwi_gltf *g, const nkwi_value *object, nkw_document_mesh *mesh)
{
    nkwi_value extras = nkwi_member(object, "extras"), list = nkwi_member(&extras, "targetNames");
    const char **names = (const char **)nkwi_gltf_take(g, object, mesh->target_count, sizeof *names);
    for (size_t i = 0; names && i < mesh->target_count; i++) {
        nkwi_value name = nkwi_element(&list, i);
        names[i] = nkwi_document_name(g->document, g->error, json_string_value(name.json), "target", i);
        if (!names[i])
            return 0;
    }
    mesh->target_names = names;
    return names != NULL;
}

static int read_mesh(nkwi_gltf *g, const nkwi_value *object, void *element)
{
    nkw_document_mesh *mesh = (nkw_document_mesh *)element;
    nkwi_value list = nkwi_member(object, "primitives");
    if (!nkwi_is_object(g->error, object) || !nkwi_is_array(g->error, &list))
        return 0;
    size_t count = nkwi_length(&list);
    nkw_document_primitive *primitives = (nkw_document_primitive *)nkwi_gltf_take(g, &list, count, sizeof *primitives);
    mesh->name = nkwi_gltf_name(g, object, "mesh");
    mesh->primitives = primitives;
    mesh->primitive_count = count;
    if (!mesh->name || !primitives)
        return 0;
    for (size_t i = 0; i < count; i++) {
        nkwi_value primitive = nkwi_element(&list, i);
        if (!read_primitive(g, &primitive, &primitives[i]))
            return 0;
        if (primitives[i].target_count != primitives[0].target_count)
            return nkwi_fail(g->error, &primitive.place, NKW_IMPORT_INVALID, "%zu morph targets, primitive 0 has %zu",
                             primitives[i].target_count, primitives[0].target_count);
    }
    mesh->target_count = count > 0 ? primitives[0].target_count : 0;
    float *weights = (float *)nkwi_gltf_take(g, object, mesh->target_count, sizeof *weights);
    mesh->weights = weights;
    return weights && name_targets(g, object, mesh) &&
           (mesh->target_count == 0 || nkwi_floats(g->error, object, "weights", weights, mesh->target_count));
}

int nkwi_gltf_meshes(nkwi_gltf *g)
{
    nkw_document *document = &g->document->all;
    document->meshes =
        (nkw_document_mesh *)nkwi_gltf_each(g, "meshes", sizeof *document->meshes, read_mesh, &document->mesh_count);
    return document->meshes != NULL;
}

static int read_material(nkwi_gltf *g, const nkwi_value *object, void *element)
{
    nkw_document_material *material = (nkw_document_material *)element;
    nkwi_value pbr = nkwi_member(object, "pbrMetallicRoughness");
    for (int c = 0; c < 4; c++)
        material->color[c] = 1.0f;
    material->name = nkwi_gltf_name(g, object, "material");
    if (!material->name || !nkwi_is_object(g->error, object) ||
        !nkwi_floats(g->error, &pbr, "baseColorFactor", material->color, 4))
        return 0;
    material->image = nkwi_gltf_texture(g, &pbr, "baseColorTexture", &material->image_texcoords);
    return 1;
}

int nkwi_gltf_materials(nkwi_gltf *g)
{
    nkw_document *document = &g->document->all;
    document->materials = (nkw_document_material *)nkwi_gltf_each(g, "materials", sizeof *document->materials,
                                                                  read_material, &document->material_count);
    return document->materials != NULL;
}
