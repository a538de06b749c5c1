/* SPDX-License-Identifier: MIT */
/* A document as a glTF 2.0 file. */
#include <stdio.h>
#include <string.h>

#include "sink.h"
#include "write_valid.h"

typedef struct writer {
    nkwi_sink sink;
    const nkw_document *document;
    json_t *root;
    struct written {
        const void *data;
        size_t width, accessor;
    } * written; /* arrays that have an accessor: parts of meshes share them */
    size_t written_count, written_room;
    size_t *plain; /* of each material the number of the same without its picture, or SIZE_MAX; of glTF files NULL */
} writer;

/* Memory until the file is written; without it the sink has failed. */
static void *take(writer *w, size_t count, size_t size)
{
    void *block = nkwi_take(&w->sink.scratch, count, size);
    w->sink.failed = w->sink.failed || !block;
    return block;
}

/* An array of the root; NULL if it is empty, which is not valid. */
static json_t *add_list(writer *w, const char *key, size_t count)
{
    json_t *list = count > 0 ? json_array() : NULL;
    if (list)
        nkwi_set(&w->sink, w->root, key, list);
    return list;
}

/* An object of a list. */
static json_t *add_object(writer *w, json_t *list, const char *name)
{
    json_t *object = json_object();
    nkwi_put(&w->sink, list, object);
    if (name && name[0])
        nkwi_set(&w->sink, object, "name", nkwi_string(&w->sink, name));
    return object;
}

static void set_index(writer *w, json_t *object, const char *key, size_t index)
{
    nkwi_set(&w->sink, object, key, json_integer((json_int_t)index));
}

static size_t number_of(const writer *w, int32_t joint)
{
    return w->document->nodes[joint].number;
}

/* ---- nodes and scenes ---- */

static int differs(const float *a, const float *b, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (a[i] != b[i])
            return 1;
    return 0;
}

static void set_transform(writer *w, json_t *object, const nkw_document_node *node)
{
    static const nkw_trs identity = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 1.0f}};
    const nkw_trs *t = &node->rest;
    if (node->matrix) {
        nkwi_set(&w->sink, object, "matrix", nkwi_floats_of(&w->sink, node->matrix->m, 16));
        return;
    }
    if (differs(&t->translation.x, &identity.translation.x, 3))
        nkwi_set(&w->sink, object, "translation", nkwi_floats_of(&w->sink, &t->translation.x, 3));
    if (differs(&t->rotation.x, &identity.rotation.x, 4))
        nkwi_set(&w->sink, object, "rotation", nkwi_floats_of(&w->sink, &t->rotation.x, 4));
    if (differs(&t->scale.x, &identity.scale.x, 3))
        nkwi_set(&w->sink, object, "scale", nkwi_floats_of(&w->sink, &t->scale.x, 3));
}

static void set_children(writer *w, json_t *nodes)
{
    const nkw_document *d = w->document;
    for (size_t i = 0; i < d->skeleton.joint_count; i++) {
        const int32_t parent = d->skeleton.parents[d->joint_of_node[i]];
        if (parent == NKW_NO_JOINT)
            continue;
        json_t *object = json_array_get(nodes, number_of(w, parent)), *list = json_object_get(object, "children");
        if (!list)
            nkwi_set(&w->sink, object, "children", list = json_array());
        nkwi_put(&w->sink, list, json_integer((json_int_t)i));
    }
}

static void write_nodes(writer *w)
{
    const nkw_document *d = w->document;
    json_t *list = add_list(w, "nodes", d->skeleton.joint_count);
    for (size_t i = 0; i < d->skeleton.joint_count; i++) {
        const nkw_document_node *node = &d->nodes[d->joint_of_node[i]];
        json_t *object = add_object(w, list, node->name);
        set_transform(w, object, node);
        if (node->mesh != NKW_NO_JOINT)
            set_index(w, object, "mesh", (size_t)node->mesh);
        if (node->skin != NKW_NO_JOINT && node->mesh != NKW_NO_JOINT)
            set_index(w, object, "skin", (size_t)node->skin);
        if (node->float_count > 0 && d->rest_floats)
            nkwi_set(&w->sink, object, "weights",
                     nkwi_floats_of(&w->sink, d->rest_floats + node->float_first, node->float_count));
    }
    set_children(w, list);
}

/* Without scenes: one of all roots. */
static void write_scenes(writer *w)
{
    const nkw_document *d = w->document;
    json_t *list = add_list(w, "scenes", 1);
    for (size_t i = 0; i < d->scene_count; i++) {
        json_t *object = add_object(w, list, d->scenes[i].name), *roots = json_array();
        for (size_t k = 0; k < d->scenes[i].root_count; k++)
            nkwi_put(&w->sink, roots, json_integer((json_int_t)number_of(w, d->scenes[i].roots[k])));
        if (d->scenes[i].root_count > 0)
            nkwi_set(&w->sink, object, "nodes", roots);
        else
            json_decref(roots);
    }
    if (d->scene_count == 0) {
        json_t *object = add_object(w, list, NULL), *roots = json_array();
        for (size_t i = 0; i < d->skeleton.joint_count; i++)
            if (d->skeleton.parents[d->joint_of_node[i]] == NKW_NO_JOINT)
                nkwi_put(&w->sink, roots, json_integer((json_int_t)i));
        nkwi_set(&w->sink, object, "nodes", roots);
    }
    if (d->scene != NKW_NO_JOINT || d->scene_count == 0)
        set_index(w, w->root, "scene", d->scene_count ? (size_t)d->scene : 0);
}

static void set_matrices(writer *w, json_t *object, const nkw_document_skin *skin)
{
    nkw_mat4 *valid = NULL;
    if (nkwi_valid_applies(w->document))
        valid = (nkw_mat4 *)take(w, skin->joint_count, sizeof *valid);
    for (size_t i = 0; valid && i < skin->joint_count; i++)
        valid[i] = nkwi_valid_matrix(&skin->inverse_bind[i]);
    const nkwi_numbers matrices = {NKWI_F32, 0, 16, skin->joint_count, valid ? valid : skin->inverse_bind, 0, 0};
    set_index(w, object, "inverseBindMatrices", nkwi_sink_numbers(&w->sink, &matrices));
}

static void write_skins(writer *w)
{
    const nkw_document *d = w->document;
    json_t *list = add_list(w, "skins", d->skin_count);
    for (size_t i = 0; i < d->skin_count; i++) {
        const nkw_document_skin *skin = &d->skins[i];
        json_t *object = add_object(w, list, skin->name), *joints = json_array();
        for (size_t k = 0; k < skin->joint_count; k++)
            nkwi_put(&w->sink, joints, json_integer((json_int_t)number_of(w, skin->joints[k])));
        nkwi_set(&w->sink, object, "joints", joints);
        if (skin->inverse_bind)
            set_matrices(w, object, skin);
    }
}

/* ---- meshes ---- */

/* The accessor of an array, once. */
static size_t accessor_of(writer *w, const nkwi_numbers *n)
{
    for (size_t i = 0; i < w->written_count; i++)
        if (w->written[i].data == n->data && w->written[i].width == n->width)
            return w->written[i].accessor;
    const struct written entry = {n->data, n->width, nkwi_sink_numbers(&w->sink, n)};
    if (w->written_count < w->written_room)
        w->written[w->written_count++] = entry;
    return entry.accessor;
}

static void set_floats(writer *w, json_t *attributes, const char *key, const void *data, size_t width, size_t count)
{
    const nkwi_numbers n = {NKWI_F32, 0, width, count, data, strcmp(key, "POSITION") == 0, 34962};
    if (data && count > 0)
        set_index(w, attributes, key, accessor_of(w, &n));
}

/* Set `set` of four influences: joints and weights, with zeros after the last. */
static void set_four(writer *w, json_t *attributes, const nkw_document_primitive *p, size_t set)
{
    const size_t first = 4 * set, most = p->influence_count - first < 4 ? p->influence_count - first : 4;
    uint16_t *joints = (uint16_t *)take(w, 4 * p->vertex_count, sizeof *joints);
    float *weights = (float *)take(w, 4 * p->vertex_count, sizeof *weights);
    for (size_t v = 0; v < p->vertex_count && !w->sink.failed; v++)
        for (size_t k = 0; k < most; k++) {
            weights[4 * v + k] = p->weights[v * p->influence_count + first + k];
            joints[4 * v + k] = p->joints[v * p->influence_count + first + k];
        }
    const nkwi_numbers j = {NKWI_U16, 0, 4, p->vertex_count, joints, 0, 34962};
    const nkwi_numbers x = {NKWI_F32, 0, 4, p->vertex_count, weights, 0, 34962};
    char key[32];
    if (w->sink.failed)
        return;
    snprintf(key, sizeof key, "JOINTS_%zu", set);
    set_index(w, attributes, key, nkwi_sink_numbers(&w->sink, &j));
    snprintf(key, sizeof key, "WEIGHTS_%zu", set);
    set_index(w, attributes, key, nkwi_sink_numbers(&w->sink, &x));
}

static void set_influences(writer *w, json_t *attributes, const nkw_document_primitive *p)
{
    nkw_document_primitive valid = *p;
    const size_t count = p->vertex_count * p->influence_count;
    if (count > 0 && nkwi_valid_applies(w->document)) {
        uint16_t *joints = (uint16_t *)take(w, count, sizeof *joints);
        float *weights = (float *)take(w, count, sizeof *weights);
        if (w->sink.failed)
            return;
        nkwi_valid_influences(p, joints, weights);
        valid.joints = joints;
        valid.weights = weights;
    }
    for (size_t set = 0; 4 * set < p->influence_count; set++)
        set_four(w, attributes, &valid, set);
}

/* Normals and tangents. Arrays that are valid already are written themselves, so that primitives share them. */
static void set_directions(writer *w, json_t *attributes, const nkw_document_primitive *p)
{
    const size_t n = p->vertex_count;
    const float *normals = p->normals ? &p->normals[0].x : NULL, *tangents = p->tangents;
    if (n > 0 && (normals || tangents) && p->positions && nkwi_valid_applies(w->document)) {
        nkw_vec3 *faces = (nkw_vec3 *)take(w, n, sizeof *faces);
        float *units = (float *)take(w, 3 * n, sizeof *units), *fours = (float *)take(w, 4 * n, sizeof *fours);
        if (w->sink.failed)
            return;
        nkwi_valid_faces(p, faces);
        if (normals) {
            nkwi_valid_units(normals, 3, faces, n, units);
            normals = memcmp(units, normals, 3 * n * sizeof *units) == 0 ? normals : units;
        }
        if (tangents) {
            nkwi_valid_units(tangents, 4, faces, n, fours);
            tangents = memcmp(fours, tangents, 4 * n * sizeof *fours) == 0 ? tangents : fours;
        }
    }
    set_floats(w, attributes, "NORMAL", normals, 3, n);
    set_floats(w, attributes, "TANGENT", tangents, 4, n);
}

static void set_indices(writer *w, json_t *object, const nkw_document_primitive *p)
{
    nkwi_numbers n = {NKWI_U32, 0, 1, p->index_count, p->indices, 0, 34963};
    uint16_t *shorts = NULL;
    if (p->vertex_count < 65536)
        shorts = (uint16_t *)nkwi_take(&w->sink.scratch, p->index_count, sizeof *shorts);
    for (size_t i = 0; shorts && i < p->index_count; i++)
        shorts[i] = (uint16_t)p->indices[i];
    if (shorts) {
        n.component = NKWI_U16;
        n.data = shorts;
    }
    if (p->index_count > 0)
        set_index(w, object, "indices", nkwi_sink_numbers(&w->sink, &n));
}

static void set_targets(writer *w, json_t *object, const nkw_document_primitive *p)
{
    json_t *list = json_array();
    for (size_t i = 0; i < p->target_count; i++) {
        json_t *target = json_object();
        set_floats(w, target, "POSITION", p->targets[i].positions, 3, p->vertex_count);
        set_floats(w, target, "NORMAL", p->targets[i].normals, 3, p->vertex_count);
        set_floats(w, target, "TANGENT", p->targets[i].tangents, 3, p->vertex_count);
        nkwi_put(&w->sink, list, target);
    }
    nkwi_set(&w->sink, object, "targets", list);
}

/* 0..1, as glTF requires. */
static void set_colors(writer *w, json_t *attributes, const nkw_document_primitive *p)
{
    const float *colors = p->colors;
    if (colors && p->vertex_count > 0 && nkwi_valid_applies(w->document)) {
        float *valid = (float *)take(w, 4 * p->vertex_count, sizeof *valid);
        if (valid && nkwi_valid_colors(colors, 4 * p->vertex_count, valid))
            colors = valid;
    }
    set_floats(w, attributes, "COLOR_0", colors, 4, p->vertex_count);
}

/* Of a part that has not the texture coordinates of its material's picture, the material without it. */
static size_t material_of(const writer *w, const nkw_document_primitive *p)
{
    const size_t plain = w->plain ? w->plain[p->material] : SIZE_MAX;
    return plain != SIZE_MAX && p->texcoord_count <= w->document->materials[p->material].image_texcoords
               ? plain
               : (size_t)p->material;
}

static void write_primitive(writer *w, json_t *list, const nkw_document_primitive *p)
{
    static const int modes[] = {0, 1, 4};
    json_t *object = json_object(), *attributes = json_object();
    nkwi_put(&w->sink, list, object);
    nkwi_set(&w->sink, object, "attributes", attributes);
    set_floats(w, attributes, "POSITION", p->positions, 3, p->vertex_count);
    set_directions(w, attributes, p);
    for (size_t set = 0; set < p->texcoord_count; set++) {
        char key[32];
        snprintf(key, sizeof key, "TEXCOORD_%zu", set);
        set_floats(w, attributes, key, p->texcoords[set], 2, p->vertex_count);
    }
    set_colors(w, attributes, p);
    set_influences(w, attributes, p);
    set_indices(w, object, p);
    if (modes[p->topology] != 4)
        nkwi_set(&w->sink, object, "mode", json_integer(modes[p->topology]));
    if (p->material != NKW_NO_JOINT)
        set_index(w, object, "material", material_of(w, p));
    if (p->target_count > 0)
        set_targets(w, object, p);
}

/* glTF has no mesh without a part, and no morph weights without targets: one point, which no target moves. */
static void write_point(writer *w, json_t *list, size_t target_count)
{
    static const nkw_vec3 origin = {0.0f, 0.0f, 0.0f};
    const nkw_document_target still = {&origin, NULL, NULL};
    nkw_document_target *targets = (nkw_document_target *)nkwi_take(&w->sink.scratch, target_count, sizeof *targets);
    nkw_document_primitive p;
    memset(&p, 0, sizeof p);
    w->sink.failed = w->sink.failed || !targets;
    for (size_t i = 0; targets && i < target_count; i++)
        targets[i] = still;
    p.topology = NKW_DOCUMENT_POINTS;
    p.material = NKW_NO_JOINT;
    p.vertex_count = 1;
    p.positions = &origin;
    p.targets = targets;
    p.target_count = targets ? target_count : 0;
    write_primitive(w, list, &p);
}

static void write_meshes(writer *w)
{
    const nkw_document *d = w->document;
    json_t *list = add_list(w, "meshes", d->mesh_count);
    for (size_t i = 0; i < d->mesh_count; i++) {
        const nkw_document_mesh *mesh = &d->meshes[i];
        json_t *object = add_object(w, list, mesh->name), *primitives = json_array(), *names = json_array();
        nkwi_set(&w->sink, object, "primitives", primitives);
        for (size_t k = 0; k < mesh->primitive_count; k++)
            if (mesh->primitives[k].vertex_count > 0)
                write_primitive(w, primitives, &mesh->primitives[k]);
        if (json_array_size(primitives) == 0)
            write_point(w, primitives, mesh->target_count);
        if (mesh->target_count > 0 && mesh->weights)
            nkwi_set(&w->sink, object, "weights", nkwi_floats_of(&w->sink, mesh->weights, mesh->target_count));
        for (size_t k = 0; k < mesh->target_count; k++)
            nkwi_put(&w->sink, names, nkwi_string(&w->sink, mesh->target_names[k]));
        if (mesh->target_count > 0)
            nkwi_set(&w->sink, object, "extras", json_pack("{s:o}", "targetNames", names));
        else
            json_decref(names);
    }
}

/* A path of a PNG or JPEG file by its end, in any case. */
static int is_picture(const char *path)
{
    static const char *const ends[] = {"png", "jpg", "jpeg"};
    const char *end = strrchr(path, '.');
    for (size_t i = 0; end && i < 3; i++) {
        size_t k = 0;
        while (ends[i][k] && (end[k + 1] | 32) == ends[i][k])
            k++;
        if (!ends[i][k] && !end[k + 1])
            return 1;
    }
    return 0;
}

/* The type of a picture whose bytes are there; NULL of others. */
static const char *type_of(const nkw_document_image *image)
{
    return image->data ? nkwi_image_type(image->data, image->bytes) : NULL;
}

/* A picture of the file, or the name of an outer one. */
static int is_written(const nkw_document_image *image)
{
    return type_of(image) || (image->path && is_picture(image->path));
}

/* How many of the first images are written: the number of the texture of the next one. */
static size_t count_images(const nkw_document *d, size_t images)
{
    size_t number = 0;
    for (size_t i = 0; i < images; i++)
        number += (size_t)is_written(&d->images[i]);
    return number;
}

static void name_outer(writer *w, json_t *object, size_t image, nkw_gltf_file *file)
{
    nkwi_set(&w->sink, object, "uri", nkwi_uri(&w->sink, w->document->images[image].path));
    file->outer_image = file->outer_images++ ? file->outer_image : image;
}

static void write_images(writer *w, nkw_gltf_file *file)
{
    const nkw_document *d = w->document;
    const size_t count = count_images(d, d->image_count);
    json_t *images = add_list(w, "images", count), *textures = add_list(w, "textures", count);
    for (size_t i = 0, number = 0; i < d->image_count; i++) {
        const nkw_document_image *image = &d->images[i];
        if (!is_written(image))
            continue;
        json_t *object = add_object(w, images, image->name);
        if (type_of(image)) {
            set_index(w, object, "bufferView", nkwi_sink_bytes(&w->sink, image->data, image->bytes));
            nkwi_set(&w->sink, object, "mimeType", json_string(type_of(image)));
        } else
            name_outer(w, object, i, file);
        set_index(w, add_object(w, textures, NULL), "source", number++);
    }
}

/* The picture of a material, which is_written; set 0 is not stated. */
static json_t *texture_of(const nkw_document *d, const nkw_document_material *m)
{
    json_t *texture = json_pack("{s:I}", "index", (json_int_t)count_images(d, (size_t)(m->image - d->images)));
    if (m->image_texcoords > 0)
        json_object_set_new(texture, "texCoord", json_integer((json_int_t)m->image_texcoords));
    return texture;
}

static void write_material(writer *w, json_t *list, const nkw_document_material *m, int is_plain)
{
    json_t *object = add_object(w, list, m->name), *look = json_object();
    nkwi_set(&w->sink, look, "baseColorFactor", nkwi_floats_of(&w->sink, m->color, 4));
    nkwi_set(&w->sink, look, "metallicFactor", json_integer(0));
    if (m->image && !is_plain && is_written(m->image))
        nkwi_set(&w->sink, look, "baseColorTexture", texture_of(w->document, m));
    nkwi_set(&w->sink, object, "pbrMetallicRoughness", look);
    if (m->color[3] < 1.0f)
        nkwi_set(&w->sink, object, "alphaMode", json_string("BLEND"));
}

/* The materials whose picture some part has no texture coordinates for are needed without it, too. */
static void find_plain(writer *w)
{
    const nkw_document *d = w->document;
    size_t count = d->material_count;
    if (!nkwi_valid_applies(d) || count == 0)
        return;
    w->plain = (size_t *)take(w, count, sizeof *w->plain);
    for (size_t i = 0; w->plain && i < d->material_count; i++)
        w->plain[i] = SIZE_MAX;
    for (size_t i = 0; w->plain && i < d->mesh_count; i++)
        for (size_t k = 0; k < d->meshes[i].primitive_count; k++) {
            const nkw_document_primitive *p = &d->meshes[i].primitives[k];
            const nkw_document_material *m = p->material == NKW_NO_JOINT ? NULL : &d->materials[p->material];
            if (m && m->image && is_written(m->image) && p->texcoord_count <= m->image_texcoords &&
                w->plain[p->material] == SIZE_MAX)
                w->plain[p->material] = count++;
        }
}

static void write_materials(writer *w)
{
    const nkw_document *d = w->document;
    json_t *list = add_list(w, "materials", d->material_count);
    find_plain(w);
    for (size_t i = 0; i < d->material_count; i++)
        write_material(w, list, &d->materials[i], 0);
    for (size_t number = d->material_count, i = 0; w->plain && i < d->material_count; i++)
        for (size_t k = 0; k < d->material_count; k++)
            if (w->plain[k] == number) {
                write_material(w, list, &d->materials[k], 1);
                number++;
                break;
            }
}

/* ---- animations ---- */

static int write_animation(writer *w, json_t *list, const nkw_document_animation *a, const nkwi_place *place)
{
    static const char *const paths[] = {"translation", "rotation", "scale", "weights"};
    const nkwi_place channel_list = {place, "channels", 0};
    json_t *object = add_object(w, list, a->name), *channels = json_array(), *samplers = json_array();
    nkwi_set(&w->sink, object, "channels", channels);
    nkwi_set(&w->sink, object, "samplers", samplers);
    for (size_t i = 0; i < a->track_count; i++) {
        const nkwi_place at = {&channel_list, NULL, a->channels[i].number};
        json_t *sampler = nkwi_sink_sampler(&w->sink, &a->tracks[i], &at, NKWI_F32);
        if (!sampler)
            return 0;
        nkwi_put(&w->sink, samplers, sampler);
        nkwi_put(&w->sink, channels,
                 json_pack("{s:I,s:{s:I,s:s}}", "sampler", (json_int_t)i, "target", "node",
                           (json_int_t)number_of(w, a->channels[i].joint), "path", paths[a->tracks[i].target]));
    }
    return 1;
}

/* An animation without channels is not valid. */
static int write_animations(writer *w)
{
    const nkw_document *d = w->document;
    const nkwi_place root = {NULL, NULL, 0}, place = {&root, "animations", 0};
    json_t *list = add_list(w, "animations", 1);
    int done = 1;
    nkwi_sink_begin_keys(&w->sink);
    for (size_t i = 0; done && i < d->animation_count; i++) {
        const nkwi_place at = {&place, NULL, i};
        if (d->animations[i].track_count > 0)
            done = write_animation(w, list, &d->animations[i], &at);
    }
    nkwi_sink_end_keys(&w->sink);
    return done;
}

static size_t most_arrays(const nkw_document *d)
{
    size_t count = 1;
    for (size_t i = 0; i < d->mesh_count; i++)
        count += d->meshes[i].primitive_count * (5 + 3 * d->meshes[i].target_count);
    return count;
}

static int write_parts(writer *w, nkw_gltf_form form, const char *uri, nkw_gltf_file *file)
{
    w->written_room = most_arrays(w->document);
    w->written = (struct written *)nkwi_take(&w->sink.scratch, w->written_room, sizeof *w->written);
    w->sink.failed = w->sink.failed || !w->written;
    if (w->sink.failed)
        return nkwi_fail(w->sink.error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the file");
    nkwi_set(&w->sink, w->root, "asset", json_pack("{s:s,s:s}", "version", "2.0", "generator", "nakawari"));
    write_scenes(w);
    write_nodes(w);
    write_images(w, file);
    write_materials(w);
    write_meshes(w);
    write_skins(w);
    if (!write_animations(w))
        return 0;
    nkwi_set(&w->sink, w->root, "accessors", json_incref(w->sink.accessors));
    nkwi_set(&w->sink, w->root, "bufferViews", json_incref(w->sink.views));
    return nkwi_sink_write(&w->sink, w->root, form, uri, 9, file);
}

nkw_import_result nkw_document_write(const nkw_document *document, nkw_gltf_form form, const char *uri,
                                     nkw_gltf_file *file, nkw_import_error *error)
{
    const nkw_gltf_file none = {NULL, 0, NULL, 0, 0, 0};
    nkw_import_error own;
    writer w;
    error = error ? error : &own;
    memset(&w, 0, sizeof w);
    nkwi_fault_none(error, document->file);
    *file = none;
    w.document = document;
    w.root = json_object();
    nkwi_sink_open(&w.sink, error, json_array(), json_array());
    if (!write_parts(&w, form, uri ? uri : "", file)) {
        nkw_gltf_file_free(file);
        if (error->code == NKW_IMPORT_OK)
            nkwi_fail(error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the file");
    }
    json_decref(w.sink.views);
    json_decref(w.sink.accessors);
    json_decref(w.root);
    nkwi_sink_close(&w.sink);
    return error->code;
}
