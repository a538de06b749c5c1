/* SPDX-License-Identifier: MIT */
/*
 * Normals, tangents and facing of meshes on request.
 *
 * A primitive is taken apart into corners. What is made is written to the corners, and those of equal source vertex,
 * normal and tangent are one vertex again.
 */
#include "prepare.h"

#include <string.h>

#include <nakawari/mesh.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

/* Of a corner: the vertex that all other attributes are copied from. */
typedef struct corner {
    uint32_t vertex;
    nkw_vec3 normal;
    float tangent[4];
} corner;

typedef struct corners {
    nkwi_prepare *p;
    nkwi_place place; /* of the primitive */
    nkw_document_primitive *primitive;
    corner *list;
    size_t count; /* 3 for each triangle */
    int has_normals, has_tangents;
    nkw_work work;
} corners;

void *nkwi_prepare_scratch(nkwi_prepare *p, size_t count, size_t size)
{
    void *block = nkwi_take(&p->scratch, count, size);
    if (!block)
        nkwi_fail(p->error, NULL, NKW_IMPORT_NO_MEMORY, "no memory for %zu elements of %zu bytes", count, size);
    return block;
}

static int refuse(const corners *c, nkw_result result, size_t triangle)
{
    c->p->error->result = result;
    return nkwi_fail(c->p->error, &c->place, NKW_IMPORT_REFUSED, "triangle %zu: %s", triangle, nkw_result_text(result));
}

/* Working memory, aligned to 16. */
static int take_work(corners *c, size_t bytes)
{
    unsigned char *block = (unsigned char *)nkwi_prepare_scratch(c->p, bytes + 16, 1);
    if (!block)
        return 0;
    c->work.data = block + (16 - (size_t)block % 16) % 16;
    c->work.bytes = bytes;
    return 1;
}

/* Normals that are all zero are none: some formats have them so. */
static int are_zero(const nkw_vec3 *v, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (v[i].x != 0.0f || v[i].y != 0.0f || v[i].z != 0.0f)
            return 0;
    return 1;
}

static int take_apart(corners *c, const uint32_t *indices)
{
    const nkw_document_primitive *d = c->primitive;
    c->has_normals = d->normals && !are_zero(d->normals, d->vertex_count);
    c->has_tangents = d->tangents != NULL;
    c->list = (corner *)nkwi_prepare_scratch(c->p, c->count, sizeof *c->list);
    for (size_t i = 0; c->list && i < c->count; i++) {
        const uint32_t v = indices[i];
        c->list[i].vertex = v;
        if (c->has_normals)
            c->list[i].normal = d->normals[v];
        if (c->has_tangents)
            memcpy(c->list[i].tangent, d->tangents + 4 * (size_t)v, sizeof c->list[i].tangent);
    }
    return c->list != NULL;
}

/* ---- Facing ---- */

static nkw_vec3 position_of(const corners *c, size_t i)
{
    return c->primitive->positions[c->list[i].vertex];
}

/* Normals of a turned triangle that point to its back are negated; the bitangents stay. */
static void turn_normals(corners *c, size_t first)
{
    const nkw_vec3 u = nkw_vec3_sub(position_of(c, first + 1), position_of(c, first));
    const nkw_vec3 v = nkw_vec3_sub(position_of(c, first + 2), position_of(c, first));
    const nkw_vec3 face = nkw_vec3_cross(u, v);
    for (size_t i = first; i < first + 3; i++)
        if (nkw_vec3_dot(c->list[i].normal, face) < 0.0f) {
            c->list[i].normal = nkw_vec3_scale(c->list[i].normal, -1.0f);
            c->list[i].tangent[3] = -c->list[i].tangent[3];
        }
}

/* Returns the indices as they face the same way; takes the corners apart by them. */
static int make_facing(corners *c)
{
    const nkw_document_primitive *d = c->primitive;
    const nkw_mesh mesh = {d->positions, d->vertex_count, d->indices, c->count / 3};
    uint32_t *indices = (uint32_t *)nkwi_prepare_scratch(c->p, c->count, sizeof *indices);
    nkw_mesh_facing found;
    size_t bad;
    if (!indices)
        return 0;
    const nkw_result result = nkw_mesh_fix_facing(&mesh, indices, &found, &bad, c->work);
    if (result != NKW_OK)
        return refuse(c, result, bad);
    if (!take_apart(c, indices))
        return 0;
    for (size_t i = 0; i < c->count; i += 3)
        if (indices[i + 1] != d->indices[i + 1] || indices[i + 2] != d->indices[i + 2])
            turn_normals(c, i);
    c->p->turned += found.turned_count;
    c->p->conflicts += found.conflict_count;
    c->p->branches += found.branch_count;
    return found.turned_count > 0 ? 1 : -1;
}

/* ---- Normals and tangents ---- */

static int make_normals(corners *c)
{
    nkw_vec3 *loose = (nkw_vec3 *)nkwi_prepare_scratch(c->p, c->count, sizeof *loose);
    const nkw_mesh mesh = {loose, c->count, NULL, c->count / 3};
    size_t bad;
    for (size_t i = 0; loose && i < c->count; i++)
        loose[i] = position_of(c, i);
    if (!loose)
        return 0;
    const nkw_result result = nkw_mesh_normals(&mesh, c->p->wanted->crease, loose, &bad, c->work);
    if (result != NKW_OK)
        return refuse(c, result, bad);
    for (size_t i = 0; i < c->count; i++)
        c->list[i].normal = loose[i];
    c->has_normals = 1;
    c->p->normals++;
    return 1;
}

/* A tangent in the plane of the normal: where the function has none, any. */
static void write_tangent(corner *to, const float *made, float sign)
{
    const nkw_vec3 n = nkw_vec3_normalize(to->normal), t = {made[0], made[1], made[2]};
    nkw_vec3 flat = nkw_vec3_normalize(nkw_vec3_sub(t, nkw_vec3_scale(n, nkw_vec3_dot(n, t))));
    if (nkw_vec3_length(flat) < 0.5f)
        flat = nkw_vec3_perpendicular(n);
    memcpy(to->tangent, &flat, sizeof flat);
    to->tangent[3] = sign * made[3];
}

/* Normal maps are baked with v upwards. */
static int make_tangents(corners *c)
{
    const nkw_document_primitive *d = c->primitive;
    const float sign = c->p->document->v_is_up ? 1.0f : -1.0f;
    nkw_vec3 *positions = (nkw_vec3 *)nkwi_prepare_scratch(c->p, c->count, 2 * sizeof *positions);
    float *texcoords = (float *)nkwi_prepare_scratch(c->p, c->count, 2 * sizeof *texcoords);
    float *made = (float *)nkwi_prepare_scratch(c->p, c->count, 4 * sizeof *made);
    if (!positions || !texcoords || !made)
        return 0;
    nkw_vec3 *normals = positions + c->count;
    for (size_t i = 0; i < c->count; i++) {
        positions[i] = position_of(c, i);
        normals[i] = c->list[i].normal;
        memcpy(texcoords + 2 * i, d->texcoords[0] + 2 * (size_t)c->list[i].vertex, 2 * sizeof *texcoords);
    }
    const nkw_mesh mesh = {positions, c->count, NULL, c->count / 3};
    const nkw_mesh_surface surface = {normals, texcoords};
    size_t bad;
    const nkw_result result = nkw_mesh_tangents(&mesh, surface, made, NULL, &bad, c->work);
    if (result != NKW_OK)
        return refuse(c, result, bad);
    for (size_t i = 0; i < c->count; i++)
        write_tangent(&c->list[i], made + 4 * i, sign);
    c->has_tangents = 1;
    c->p->tangents++;
    return 1;
}

/* ---- Together again ---- */

/* The elements of the vertices, of `bytes` bytes each, in memory of the document. */
static const void *gather(const corners *c, const uint32_t *vertices, size_t count, const void *data, size_t bytes)
{
    nkwi_prepare *p = c->p;
    if (!data || p->error->code != NKW_IMPORT_OK)
        return NULL;
    char *out = (char *)nkwi_document_take(p->document, p->error, &c->place, count, bytes);
    for (size_t i = 0; out && i < count; i++)
        memcpy(out + i * bytes, (const char *)data + vertices[i] * bytes, bytes);
    return out;
}

static void gather_targets(const corners *c, const uint32_t *vertices, size_t count)
{
    nkw_document_primitive *d = c->primitive;
    nkw_document_target *targets = (nkw_document_target *)nkwi_document_take(c->p->document, c->p->error, &c->place,
                                                                             d->target_count, sizeof *targets);
    for (size_t i = 0; targets && i < d->target_count; i++) {
        const nkw_document_target *from = &d->targets[i];
        targets[i].positions = (const nkw_vec3 *)gather(c, vertices, count, from->positions, sizeof(nkw_vec3));
        targets[i].normals = (const nkw_vec3 *)gather(c, vertices, count, from->normals, sizeof(nkw_vec3));
        targets[i].tangents = (const nkw_vec3 *)gather(c, vertices, count, from->tangents, sizeof(nkw_vec3));
    }
    d->targets = targets;
}

static void gather_texcoords(const corners *c, const uint32_t *vertices, size_t count)
{
    nkw_document_primitive *d = c->primitive;
    const float **sets =
        (const float **)nkwi_document_take(c->p->document, c->p->error, &c->place, d->texcoord_count, sizeof *sets);
    for (size_t i = 0; sets && i < d->texcoord_count; i++)
        sets[i] = (const float *)gather(c, vertices, count, d->texcoords[i], 2 * sizeof(float));
    d->texcoords = d->texcoord_count ? sets : NULL;
}

static void gather_all(const corners *c, const uint32_t *vertices, size_t count)
{
    nkw_document_primitive *d = c->primitive;
    const size_t joints = d->influence_count, kept = d->skin.influence_count;
    d->positions = (const nkw_vec3 *)gather(c, vertices, count, d->positions, sizeof(nkw_vec3));
    d->colors = (const float *)gather(c, vertices, count, d->colors, 4 * sizeof(float));
    gather_texcoords(c, vertices, count);
    d->joints = (const uint16_t *)gather(c, vertices, count, d->joints, joints * sizeof *d->joints);
    d->weights = (const float *)gather(c, vertices, count, d->weights, joints * sizeof *d->weights);
    if (kept) {
        d->skin.joints.data = gather(c, vertices, count, d->skin.joints.data, kept * sizeof(uint16_t));
        d->skin.weights.data = gather(c, vertices, count, d->skin.weights.data, kept * sizeof(float));
        d->skin.vertex_count = count;
    }
    gather_targets(c, vertices, count);
    d->vertex_count = count;
}

static int join(corners *c)
{
    nkwi_prepare *p = c->p;
    nkw_document_primitive *d = c->primitive;
    size_t count;
    uint32_t *indices = (uint32_t *)nkwi_document_take(p->document, p->error, &c->place, c->count, sizeof *indices);
    uint32_t *vertices = (uint32_t *)nkwi_prepare_scratch(p, c->count, sizeof *vertices), next = 0;
    if (!indices || !vertices || !take_work(c, NKW_MESH_WELD_WORK(c->count)))
        return 0;
    nkw_mesh_weld(c->list, c->count, sizeof *c->list, indices, &count, c->work);
    nkw_vec3 *normals = (nkw_vec3 *)nkwi_document_take(p->document, p->error, &c->place, count, sizeof *normals);
    float *tangents = (float *)nkwi_document_take(p->document, p->error, &c->place, count, 4 * sizeof *tangents);
    if (!normals || !tangents)
        return 0;
    for (size_t i = 0; i < c->count; i++)
        if (indices[i] == next) {
            vertices[next] = c->list[i].vertex;
            normals[next] = c->list[i].normal;
            memcpy(tangents + 4 * next++, c->list[i].tangent, 4 * sizeof *tangents);
        }
    gather_all(c, vertices, count);
    d->normals = c->has_normals ? normals : NULL;
    d->tangents = c->has_tangents ? tangents : NULL;
    d->indices = indices;
    d->index_count = c->count;
    return p->error->code == NKW_IMPORT_OK;
}

static int prepare_corners(corners *c)
{
    const nkw_document_preparation *wanted = c->p->wanted;
    int changes = 0, done = take_work(c, NKW_MESH_WORK(c->count / 3)) && take_apart(c, c->primitive->indices);
    if (done && wanted->fix_facing) {
        done = make_facing(c);
        changes = done > 0;
    }
    if (done && wanted->make_normals && !c->has_normals)
        changes = done = make_normals(c);
    if (done && wanted->make_tangents && !c->has_tangents && c->has_normals && c->primitive->texcoord_count)
        changes = done = make_tangents(c);
    else if (done && wanted->make_tangents && !c->has_tangents)
        c->p->without_texcoords++;
    return done && (!changes || join(c));
}

static int prepare_mesh(nkwi_prepare *p, size_t mesh)
{
    const nkwi_place root = {NULL, NULL, 0}, meshes = {&root, "meshes", 0}, at = {&meshes, NULL, mesh},
                     list = {&at, "primitives", 0};
    nkw_document_mesh *m = &p->meshes[mesh];
    int done = 1;
    for (size_t k = 0; done && k < m->primitive_count; k++) {
        nkw_document_primitive *d = (nkw_document_primitive *)&m->primitives[k];
        nkw_document_primitive made = *d;
        corners c = {p, {&list, NULL, k}, &made, NULL, d->index_count / 3 * 3, 0, 0, {NULL, 0}};
        if (d->topology != NKW_DOCUMENT_TRIANGLES || c.count == 0)
            continue;
        p->primitives++;
        done = prepare_corners(&c);
        if (done)
            *d = made;
        nkwi_give(&p->scratch);
        memset(&p->scratch, 0, sizeof p->scratch);
        p->scratch.most = SIZE_MAX;
    }
    return done;
}

/* One line for each thing that was wanted. */
static int say(nkwi_prepare *p)
{
    const nkw_document_preparation *w = p->wanted;
    nkwi_document *d = p->document;
    int done = 1;
    if (w->fix_facing)
        done = nkwi_document_warn(
            d, p->error, "triangles turned: %zu; edges whose triangles cannot agree: %zu, of more than two: %zu",
            p->turned, p->conflicts, p->branches);
    if (done && w->make_normals)
        done = nkwi_document_warn(d, p->error, "normals made for %zu of %zu primitives, smooth up to %.4g degrees",
                                  p->normals, p->primitives, (double)nkw_degrees_from_radians(w->crease));
    if (done && w->make_tangents)
        done = nkwi_document_warn(
            d, p->error, "tangents made for %zu of %zu primitives; without texture coordinates or normals: %zu",
            p->tangents, p->primitives, p->without_texcoords);
    return done;
}

/* The meshes and their primitives, to be changed. */
static int copy_meshes(nkwi_prepare *p)
{
    nkw_document *d = &p->document->all;
    p->meshes = (nkw_document_mesh *)nkwi_document_take(p->document, p->error, NULL, d->mesh_count, sizeof *p->meshes);
    for (size_t i = 0; p->meshes && i < d->mesh_count; i++) {
        const size_t count = d->meshes[i].primitive_count;
        nkw_document_primitive *primitives =
            (nkw_document_primitive *)nkwi_document_take(p->document, p->error, NULL, count, sizeof *primitives);
        if (!primitives)
            return 0;
        if (count)
            memcpy(primitives, d->meshes[i].primitives, count * sizeof *primitives);
        p->meshes[i] = d->meshes[i];
        p->meshes[i].primitives = primitives;
    }
    return p->meshes != NULL;
}

static int prepare(nkwi_prepare *p)
{
    nkw_document *d = &p->document->all;
    if (!(p->wanted->crease >= 0.0f)) {
        p->error->result = NKW_OUT_OF_RANGE;
        return nkwi_fail(p->error, NULL, NKW_IMPORT_REFUSED, "the crease is negative or not a number");
    }
    if (!copy_meshes(p) || (p->wanted->apply_transforms && !nkwi_prepare_transforms(p)))
        return 0;
    d->meshes = p->meshes;
    for (size_t i = 0; i < d->mesh_count; i++)
        if (!prepare_mesh(p, i))
            return 0;
    nkwi_document_boxes(p->document);
    return say(p);
}

nkw_import_result nkw_document_prepare(nkw_document *document, const nkw_document_preparation *preparation,
                                       nkw_import_error *error)
{
    nkw_import_error other;
    nkwi_prepare p;
    memset(&p, 0, sizeof p);
    p.document = (nkwi_document *)(void *)document;
    p.error = error ? error : &other;
    p.wanted = preparation;
    p.scratch.most = SIZE_MAX;
    nkwi_fault_none(p.error, document->file);
    prepare(&p);
    nkwi_give(&p.scratch);
    return p.error->code;
}
