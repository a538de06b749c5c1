/* SPDX-License-Identifier: MIT */
/*
 * What the functions on meshes share: the elements that are equal, and the corners of triangles.
 *
 * A corner c is vertex c % 3 of triangle c / 3. The edge of a corner leads to the next corner of its triangle.
 */
#ifndef NAKAWARI_MESH_JOIN_H
#define NAKAWARI_MESH_JOIN_H

#include "lane/strict.h"

#include <nakawari/mesh.h>

#include "lane/scalar.h"
#include "lane/vec.h"

#define MESH_NONE           UINT32_MAX
#define MESH_MOST_TRIANGLES (UINT32_MAX / 24) /* a table has 6 places for each triangle */

/*
 * Equal elements: first[i] is the first element that equals i, next[i] the next one after i, or MESH_NONE. So the
 * elements that equal i are first[i], next[first[i]], ..., ascending.
 */
typedef struct mesh_join {
    uint32_t *first, *next;
} mesh_join;

/* The hash of an element, and whether two elements are equal, which then have the same hash. */
typedef uint32_t mesh_hash(const void *context, size_t i);
typedef int mesh_same(const void *context, size_t a, size_t b);

/* Mixes one word into a hash (the body of MurmurHash3, Appleby). */
static inline uint32_t mesh_mix(uint32_t hash, uint32_t word)
{
    word *= 0xcc9e2d51u;
    word = (word << 15) | (word >> 17);
    hash ^= word * 0x1b873593u;
    hash = (hash << 13) | (hash >> 19);
    return hash * 5u + 0xe6546b64u;
}

/* The finish of MurmurHash3: every bit of the hash changes with every bit of the words. */
static inline uint32_t mesh_mixed(uint32_t hash)
{
    hash = (hash ^ (hash >> 16)) * 0x85ebca6bu;
    hash = (hash ^ (hash >> 13)) * 0xc2b2ae35u;
    return hash ^ (hash >> 16);
}

/* Joins n elements. The table of 2 n places has, for each set of equal elements, the last one so far. */
static inline void mesh_join_equal(mesh_join out, size_t n, uint32_t *table, mesh_hash *hash, mesh_same *same,
                                   const void *context)
{
    const size_t size = 2 * n;
    for (size_t i = 0; i < size; i++)
        table[i] = MESH_NONE;
    for (size_t i = 0; i < n; i++) {
        size_t at = (size_t)(((uint64_t)hash(context, i) * size) >> 32);
        while (table[at] != MESH_NONE && !same(context, table[at], i))
            at = at + 1 == size ? 0 : at + 1;
        const uint32_t last = table[at];
        out.first[i] = last == MESH_NONE ? (uint32_t)i : out.first[last];
        if (last != MESH_NONE)
            out.next[last] = (uint32_t)i;
        out.next[i] = MESH_NONE;
        table[at] = (uint32_t)i;
    }
}

/* Vectors that are equal as numbers have the same words: -0 + 0 is 0. */
static inline uint32_t mesh_mix_vec3(uint32_t hash, nkw_vec3 v)
{
    return mesh_mix(mesh_mix(mesh_mix(hash, lane_bits(v.x + 0.0f)), lane_bits(v.y + 0.0f)), lane_bits(v.z + 0.0f));
}

static inline int mesh_same_vec3(nkw_vec3 a, nkw_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static inline size_t mesh_vertex(const nkw_mesh *mesh, size_t corner)
{
    return mesh->indices ? mesh->indices[corner] : corner;
}

static inline lane_f64_vec3 mesh_position(const nkw_mesh *mesh, size_t corner)
{
    return lane_f64_vec3_from(mesh->positions[mesh_vertex(mesh, corner)]);
}

/* The next corner of the triangle, and the one before. */
static inline size_t mesh_after(size_t corner)
{
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

static inline size_t mesh_before(size_t corner)
{
    return corner % 3 == 0 ? corner + 2 : corner - 1;
}

/* Checks a mesh. Stores the first offending triangle. */
nkw_result nkwi_mesh_check(const nkw_mesh *mesh, size_t *bad);

/* Joins the corners of the same position. */
void nkwi_mesh_join_positions(const nkw_mesh *mesh, mesh_join out, uint32_t *table);

/*
 * Joins the edges with the same ends, in either direction. `ids` has a number for each of n corners: the same for the
 * same end. Edges of triangles with two equal ends equal no other.
 */
void nkwi_mesh_join_edges(const uint32_t *ids, size_t n, mesh_join out, uint32_t *table);

/* Whether two corners of the triangle are the same. */
static inline int mesh_is_collapsed(const uint32_t *ids, size_t triangle)
{
    const uint32_t *id = ids + 3 * triangle;
    return id[0] == id[1] || id[1] == id[2] || id[2] == id[0];
}

/* Whether the edge of the corner leads from the smaller id to the larger. */
static inline int mesh_ascends(const uint32_t *ids, size_t corner)
{
    return ids[corner] < ids[mesh_after(corner)];
}

#endif
