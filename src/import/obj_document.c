/* SPDX-License-Identifier: MIT */
/* The document of an OBJ file: a root of the name of the file, below it a node and a mesh for each object and group. */
#include <stdlib.h>
#include <string.h>

#include "obj.h"

/* A primitive: the elements of one part, material, kind and set of attributes. */
enum { SHAPE_PART, SHAPE_MATERIAL, SHAPE_TOPOLOGY, SHAPE_ATTRIBUTES };
enum { HAS_TEXCOORDS = 1, HAS_NORMALS = 2, HAS_COLORS = 4 };

typedef struct shape {
    size_t vertex_count, index_count;
    nkw_vec3 *positions, *normals;
    float *texcoords, *colors;
    const float **texcoord_sets; /* one: texcoords */
    uint32_t *indices;
    size_t filled; /* indices */
} shape;

typedef struct builder {
    nkwi_obj *o;
    nkwi_obj_table shape_keys, vertex_keys; /* vertex: shape, position, texture coordinate, normal */
    nkwi_obj_list shapes; /* shape */
    nkwi_obj_list vertices; /* uint32_t: in its shape */
} builder;

static const nkwi_obj_position *position_of(const nkwi_obj *o, const nkwi_obj_corner *c)
{
    return (const nkwi_obj_position *)o->positions.data + (c->at[OBJ_POSITION] - 1);
}

/* ---- Vertices ---- */

static int check_corner(const nkwi_obj *o, const nkwi_obj_element *e, const nkwi_obj_corner *c)
{
    static const char *const kinds[OBJ_ATTRIBUTES] = {"vertex", "texture coordinate", "normal"};
    const size_t counts[OBJ_ATTRIBUTES] = {o->positions.count, o->texcoords.count, o->normals.count};
    for (int i = 0; i < OBJ_ATTRIBUTES; i++)
        if (c->at[i] > counts[i])
            return nkwi_obj_fail(o, e->line, "%s %lu does not exist: there are %zu", kinds[i], (unsigned long)c->at[i],
                                 counts[i]);
    return 1;
}

/* The attributes that all corners of an element have. */
static uint32_t attributes_of(const nkwi_obj *o, const nkwi_obj_element *e, const nkwi_obj_corner *corners)
{
    uint32_t all = HAS_TEXCOORDS | HAS_NORMALS | HAS_COLORS;
    for (size_t i = 0; i < e->count; i++) {
        all &= corners[i].at[OBJ_TEXCOORD] ? all : ~(uint32_t)HAS_TEXCOORDS;
        all &= corners[i].at[OBJ_NORMAL] ? all : ~(uint32_t)HAS_NORMALS;
        all &= position_of(o, &corners[i])->has_color ? all : ~(uint32_t)HAS_COLORS;
    }
    return all;
}

static size_t index_count_of(const nkwi_obj_element *e)
{
    switch (e->topology) {
    case NKW_DOCUMENT_POINTS:
        return e->count;
    case NKW_DOCUMENT_LINES:
        return 2 * (e->count - 1);
    default:
        return 3 * (e->count - 2);
    }
}

static int find_vertex(builder *b, uint32_t primitive, uint32_t attributes, nkwi_obj_corner *c)
{
    const nkwi_obj_key key = {{primitive, c->at[OBJ_POSITION], attributes & HAS_TEXCOORDS ? c->at[OBJ_TEXCOORD] : 0,
                               attributes & HAS_NORMALS ? c->at[OBJ_NORMAL] : 0}};
    uint32_t number;
    if (!nkwi_obj_number(b->o, &b->vertex_keys, &key, &number))
        return 0;
    if (number == b->vertices.count) {
        uint32_t *vertex = (uint32_t *)nkwi_obj_add(b->o, &b->vertices, sizeof *vertex);
        if (!vertex)
            return 0;
        *vertex = (uint32_t)((shape *)b->shapes.data)[primitive].vertex_count++;
    }
    c->vertex = ((const uint32_t *)b->vertices.data)[number];
    return 1;
}

static int place_element(builder *b, nkwi_obj_element *e)
{
    nkwi_obj_corner *corners = (nkwi_obj_corner *)b->o->corners.data + e->first;
    for (size_t i = 0; i < e->count; i++)
        if (!check_corner(b->o, e, &corners[i]))
            return 0;
    const uint32_t attributes = attributes_of(b->o, e, corners);
    const nkwi_obj_key key = {{e->part, (uint32_t)(e->material + 1), (uint32_t)e->topology, attributes}};
    if (!nkwi_obj_number(b->o, &b->shape_keys, &key, &e->primitive) ||
        (e->primitive == b->shapes.count && !nkwi_obj_add(b->o, &b->shapes, sizeof(shape))))
        return 0;
    ((shape *)b->shapes.data)[e->primitive].index_count += index_count_of(e);
    for (size_t i = 0; i < e->count; i++)
        if (!find_vertex(b, e->primitive, attributes, &corners[i]))
            return 0;
    return 1;
}

/* ---- Arrays ---- */

static void *take(const builder *b, size_t count, size_t size)
{
    return nkwi_document_take(b->o->document, b->o->error, NULL, count, size);
}

static int take_arrays(const builder *b, shape *s, uint32_t attributes)
{
    const size_t n = s->vertex_count;
    s->positions = (nkw_vec3 *)take(b, n, sizeof *s->positions);
    s->indices = s->positions ? (uint32_t *)take(b, s->index_count, sizeof *s->indices) : NULL;
    if (!s->indices)
        return 0;
    if (attributes & HAS_NORMALS && !(s->normals = (nkw_vec3 *)take(b, n, sizeof *s->normals)))
        return 0;
    if (attributes & HAS_TEXCOORDS) {
        s->texcoords = (float *)take(b, n, 2 * sizeof *s->texcoords);
        s->texcoord_sets = s->texcoords ? (const float **)take(b, 1, sizeof *s->texcoord_sets) : NULL;
        if (!s->texcoord_sets)
            return 0;
        s->texcoord_sets[0] = s->texcoords;
    }
    return !(attributes & HAS_COLORS) || (s->colors = (float *)take(b, n, 4 * sizeof *s->colors)) != NULL;
}

static void fill_vertex(const nkwi_obj *o, const shape *s, const nkwi_obj_corner *c)
{
    const nkwi_obj_position *p = position_of(o, c);
    s->positions[c->vertex] = p->at;
    if (s->normals)
        s->normals[c->vertex] = ((const nkw_vec3 *)o->normals.data)[c->at[OBJ_NORMAL] - 1];
    if (s->texcoords)
        memcpy(s->texcoords + 2 * c->vertex, (const nkwi_obj_texcoord *)o->texcoords.data + (c->at[OBJ_TEXCOORD] - 1),
               sizeof(nkwi_obj_texcoord));
    if (s->colors) {
        memcpy(s->colors + 4 * c->vertex, p->color, sizeof p->color);
        s->colors[4 * c->vertex + 3] = 1.0f;
    }
}

static void fill_element(const nkwi_obj *o, shape *s, const nkwi_obj_element *e)
{
    const nkwi_obj_corner *corners = (const nkwi_obj_corner *)o->corners.data + e->first;
    uint32_t *out = s->indices + s->filled;
    const size_t count = index_count_of(e);
    for (size_t i = 0; i < e->count; i++)
        fill_vertex(o, s, &corners[i]);
    if (e->topology == NKW_DOCUMENT_TRIANGLES)
        nkwi_obj_triangles(o, e, out);
    for (size_t i = 0; i < count; i++)
        out[i] = corners[e->topology == NKW_DOCUMENT_TRIANGLES ? out[i]
                         : e->topology == NKW_DOCUMENT_LINES   ? i / 2 + i % 2
                                                               : i]
                     .vertex;
    s->filled += count;
}

static int make_shapes(builder *b)
{
    nkwi_obj_element *elements = (nkwi_obj_element *)b->o->elements.data;
    for (size_t i = 0; i < b->o->elements.count; i++)
        if (!place_element(b, &elements[i]))
            return 0;
    shape *shapes = (shape *)b->shapes.data;
    const nkwi_obj_key *keys = (const nkwi_obj_key *)b->shape_keys.keys.data;
    for (size_t i = 0; i < b->shapes.count; i++)
        if (!take_arrays(b, &shapes[i], keys[i].parts[SHAPE_ATTRIBUTES]))
            return 0;
    for (size_t i = 0; i < b->o->elements.count; i++)
        fill_element(b->o, &shapes[elements[i].primitive], &elements[i]);
    return 1;
}

/* ---- Meshes and nodes ---- */

static const char *part_name(const nkwi_obj *o, size_t part)
{
    const nkwi_obj_key *key = (const nkwi_obj_key *)o->parts.keys.data + part;
    return nkwi_obj_name_of(o, key->parts[1] ? key->parts[1] : key->parts[0]);
}

static void set_primitive(const shape *s, const nkwi_obj_key *key, nkw_document_primitive *out)
{
    out->topology = (nkw_document_topology)key->parts[SHAPE_TOPOLOGY];
    out->material = (int32_t)key->parts[SHAPE_MATERIAL] - 1;
    out->vertex_count = s->vertex_count;
    out->positions = s->positions;
    out->normals = s->normals;
    out->texcoords = s->texcoord_sets;
    out->texcoord_count = s->texcoord_sets ? 1 : 0;
    out->colors = s->colors;
    out->indices = s->indices;
    out->index_count = s->index_count;
}

static int make_meshes(const builder *b)
{
    nkw_document *d = &b->o->document->all;
    const size_t parts = b->o->parts.keys.count, shapes = b->shapes.count;
    const nkwi_obj_key *keys = (const nkwi_obj_key *)b->shape_keys.keys.data;
    nkw_document_mesh *meshes = (nkw_document_mesh *)take(b, parts, sizeof *meshes);
    nkw_document_primitive *primitives = (nkw_document_primitive *)take(b, shapes, sizeof *primitives);
    if (!meshes || !primitives)
        return 0;
    for (size_t i = 0; i < shapes; i++)
        meshes[keys[i].parts[SHAPE_PART]].primitive_count++;
    for (size_t i = 0, first = 0; i < parts; first += meshes[i++].primitive_count) {
        meshes[i].primitives = primitives + first;
        meshes[i].name = nkwi_document_name(b->o->document, b->o->error, part_name(b->o, i), "mesh", i);
        if (!meshes[i].name)
            return 0;
    }
    for (size_t i = 0; i < parts; i++)
        meshes[i].primitive_count = 0;
    for (size_t i = 0; i < shapes; i++) {
        nkw_document_mesh *mesh = &meshes[keys[i].parts[SHAPE_PART]];
        const size_t at = (size_t)(mesh->primitives - primitives) + mesh->primitive_count++;
        set_primitive((const shape *)b->shapes.data + i, &keys[i], &primitives[at]);
    }
    d->meshes = meshes;
    d->mesh_count = parts;
    return 1;
}

/* The last name of the path of the file. */
static const char *file_name(const nkwi_obj *o)
{
    const char *file = o->document->all.file, *slash = strrchr(file, '/');
    return slash ? slash + 1 : file;
}

static int name_nodes(nkwi_obj *o, nkw_document_node *nodes, int32_t *parents, size_t count)
{
    const nkw_trs identity = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 1.0f}};
    for (size_t i = 0; i < count; i++) {
        const char *name = i == 0 ? file_name(o) : part_name(o, i - 1);
        parents[i] = i == 0 ? NKW_NO_JOINT : 0;
        nodes[i].name = nkwi_document_name(o->document, o->error, name, "node", i);
        nodes[i].number = i;
        nodes[i].mesh = i == 0 ? NKW_NO_JOINT : (int32_t)(i - 1);
        nodes[i].skin = NKW_NO_JOINT;
        nodes[i].rest = identity;
        if (!nodes[i].name)
            return 0;
    }
    return 1;
}

static int make_nodes(nkwi_obj *o)
{
    static const nkwi_place root = {NULL, NULL, 0}, place = {&root, "nodes", 0};
    const size_t count = 1 + o->parts.keys.count;
    nkw_document_node *nodes = (nkw_document_node *)calloc(count, sizeof *nodes);
    int32_t *parents = (int32_t *)calloc(count, sizeof *parents);
    int done = nodes && parents;
    if (!done)
        nkwi_fail(o->error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for the nodes");
    done = done && name_nodes(o, nodes, parents, count) &&
           nkwi_document_nodes(o->document, o->error, &place, nodes, parents, count);
    free(nodes);
    free(parents);
    return done;
}

int nkwi_obj_document(nkwi_obj *o)
{
    builder b;
    memset(&b, 0, sizeof b);
    b.o = o;
    o->document->all.format = "OBJ";
    const int done = nkwi_obj_materials(o) && make_shapes(&b) && make_meshes(&b) && make_nodes(o);
    nkwi_obj_give(&b.shape_keys);
    nkwi_obj_give(&b.vertex_keys);
    free(b.shapes.data);
    free(b.vertices.data);
    return done;
}
