/* SPDX-License-Identifier: MIT */
/*
 * Importers split a mesh into the corners of its faces. Vertices with the same bits in all attributes, influences and
 * morph targets are one again, the first of them; the order of the others stays.
 */
#include <string.h>

#include "assimp.h"

/* An attribute: `size` bytes for each vertex. */
typedef struct attribute {
    char *data;
    size_t size;
} attribute;

typedef struct attributes {
    attribute *list;
    size_t count;
} attributes;

static void add(attributes *all, const void *data, size_t size)
{
    const attribute one = {(char *)data, size}; /* memory of the document, which this reader has written */
    if (data && size > 0)
        all->list[all->count++] = one;
}

static int list_attributes(nkwi_assimp *a, const nkw_document_primitive *p, attributes *all)
{
    all->count = 0;
    all->list = (attribute *)nkwi_assimp_scratch(a, "meshes", 6 + p->texcoord_count + 3 * p->target_count, sizeof *all->list);
    if (!all->list)
        return 0;
    add(all, p->positions, sizeof *p->positions);
    add(all, p->normals, sizeof *p->normals);
    add(all, p->tangents, 4 * sizeof *p->tangents);
    for (size_t set = 0; set < p->texcoord_count; set++)
        add(all, p->texcoords[set], 2 * sizeof(float));
    add(all, p->colors, 4 * sizeof *p->colors);
    add(all, p->joints, p->influence_count * sizeof *p->joints);
    add(all, p->weights, p->influence_count * sizeof *p->weights);
    for (size_t t = 0; t < p->target_count; t++) {
        add(all, p->targets[t].positions, sizeof(nkw_vec3));
        add(all, p->targets[t].normals, sizeof(nkw_vec3));
        add(all, p->targets[t].tangents, sizeof(nkw_vec3));
    }
    return 1;
}

/* FNV-1a of the bytes of a vertex, mixed. Source: Fowler, Noll, Vo, The FNV Non-Cryptographic Hash Algorithm, 2011. */
static uint64_t hash_of(const attributes *all, size_t vertex)
{
    uint64_t hash = 14695981039346656037u;
    for (size_t k = 0; k < all->count; k++)
        for (size_t i = 0; i < all->list[k].size; i++)
            hash = (hash ^ (unsigned char)all->list[k].data[vertex * all->list[k].size + i]) * 1099511628211u;
    return hash ^ hash >> 32;
}

static int is_equal(const attributes *all, size_t left, size_t right)
{
    for (size_t k = 0; k < all->count; k++) {
        const attribute *at = &all->list[k];
        if (memcmp(at->data + left * at->size, at->data + right * at->size, at->size) != 0)
            return 0;
    }
    return 1;
}

static void move(const attributes *all, size_t from, size_t to)
{
    for (size_t k = 0; k < all->count; k++)
        memmove(all->list[k].data + to * all->list[k].size, all->list[k].data + from * all->list[k].size,
                all->list[k].size);
}

int nkwi_assimp_join(nkwi_assimp *a, nkw_document_primitive *p, uint32_t *indices)
{
    size_t n = p->vertex_count, room = 64, count = 0;
    attributes all;
    while (room < 2 * n)
        room *= 2;
    uint32_t *slots = (uint32_t *)nkwi_assimp_scratch(a, "meshes", room, sizeof *slots); /* 1 more than the vertex */
    uint32_t *vertex_of = (uint32_t *)nkwi_assimp_scratch(a, "meshes", n, sizeof *vertex_of);
    if (!slots || !vertex_of || !list_attributes(a, p, &all))
        return 0;
    for (size_t v = 0; v < n; v++) {
        size_t slot = (size_t)hash_of(&all, v) & (room - 1);
        while (slots[slot] > 0 && !is_equal(&all, slots[slot] - 1, v))
            slot = (slot + 1) & (room - 1);
        if (slots[slot] == 0) {
            move(&all, v, count);
            slots[slot] = (uint32_t)++count;
        }
        vertex_of[v] = slots[slot] - 1;
    }
    for (size_t i = 0; i < p->index_count; i++)
        indices[i] = vertex_of[indices[i]];
    p->vertex_count = count;
    return 1;
}
