/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 6: a skinned mesh cut into parts that each need at most N bones, for shaders whose palette holds no more.
 *
 * A part has triangles of one material and a list of at most N bones, and its vertices name their bones by the place
 * in that list, the slot. Every triangle comes into exactly one part, but for those whose own three vertices need more
 * than N bones: these are listed, and come into none.
 *
 *     part        material, a run of triangles, a run of bones, a run of vertices
 *     triangles   which triangle of the mesh it was; in a part, in the order of the mesh
 *     indices     three vertices of the part for each triangle, counted from the part's first
 *     vertices    which vertex of the mesh it was; in a part, in the order of first use
 *     slots       `influences` for each vertex: place in the part's bone list
 *     weights     `influences` for each vertex: the mesh's
 *
 * A vertex needs the bones whose weight is not zero. Triangles of one material with the same bones stay together; the
 * sets of bones are packed one part after the other: the part begins with the largest set left and takes, again and
 * again, of the sets that share a bone with it the one that brings the fewest new bones; when none of them fits, the
 * largest set that does. Afterwards no two parts of one material could be one: together they need more than N bones.
 * The bone lists do not depend on the order of the triangles. Parts ascend by material, then by their bones.
 *
 * Source  the parts, their order and the bone-local vertex: the skin model converter of
 *         スキンモデルデータの作成, with parts of two or four bones. The packing is greedy bin packing of items that
 *         share space: Grange, Kacem, Martin, Algorithms for the bin packing problem with overlapping items, 2018.
 */
#ifndef NAKAWARI_PARTITION_H
#define NAKAWARI_PARTITION_H

#include <stdint.h>

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * A skinned mesh, in the caller's arrays. All are packed: a file's joints of one byte, weights in whole numbers and
 * vertices with a stride are widened and gathered first.
 */
typedef struct nkw_partition_mesh {
    const uint32_t *indices; /**< 3 vertices for each triangle */
    const uint32_t *materials; /**< one for each triangle, any numbers; NULL: all 0 */
    size_t triangles; /**< at most 2^32 / 24 */
    const uint16_t *joints; /**< `influences` bones for each vertex; where the weight is 0, any number */
    const float *weights; /**< `influences` for each vertex, not negative; their sum is not looked at */
    size_t vertices; /**< less than 2^32 - 1 */
    size_t influences; /**< 1..8 */
    size_t bones; /**< at most 65536 */
    /**
     * NULL, or a number for each bone: the bones of a part ascend by this, then by index. With the depths of
     * nkw_bones_order roots come first; with NULL too, where parents stand before their children.
     */
    const uint16_t *depths;
} nkw_partition_mesh;

/** One part. Every run is given by its first element in the arrays of nkw_partition, and how many there are. */
typedef struct nkw_part {
    uint32_t material;
    uint32_t first_triangle, triangle_count;
    uint32_t first_bone, bone_count;
    uint32_t first_vertex, vertex_count;
} nkw_part;

/** The mesh in parts: the caller's arrays, of the lengths that nkw_partition_bounds gives, and what is in them. */
typedef struct nkw_partition {
    nkw_part *parts; /**< sizes.parts */
    uint16_t *bones; /**< sizes.bones: the parts' bones, one part after the other */
    uint32_t *triangles; /**< mesh.triangles: triangles of the mesh, part by part; after them the rejected, ascending */
    uint32_t *indices; /**< 3 * mesh.triangles */
    uint32_t *vertices; /**< sizes.vertices: vertices of the mesh, part by part */
    uint16_t *slots; /**< sizes.vertices * influences; 0 where the weight is 0 */
    float *weights; /**< sizes.vertices * influences */
    size_t part_count, bone_count, triangle_count, vertex_count; /**< elements in use */
    size_t rejected_count; /**< triangles that need more than N bones: triangles[triangle_count] and on */
} nkw_partition;

/** Lengths that are enough for every mesh of these counts. */
typedef struct nkw_partition_sizes {
    size_t parts, bones, vertices;
    size_t work; /**< uint32_t of working memory */
} nkw_partition_sizes;

/**
 * The lengths for a mesh of these counts, at most max_bones bones in a part; of the mesh only the counts are read. A
 * length that size_t cannot hold is SIZE_MAX. All are 0 for counts that nkw_partition_build refuses.
 */
NKW_API nkw_partition_sizes nkw_partition_bounds(const nkw_partition_mesh *mesh, size_t max_bones);

/**
 * Checks a mesh: NKW_OUT_OF_RANGE where a count is out of the range above (*bad_triangle is 0), a vertex index is not
 * below `vertices`, or a bone with a weight is not below `bones`; NKW_NOT_FINITE where a weight is not finite;
 * NKW_BAD_WEIGHTS where one is negative. *bad_triangle becomes the first triangle that meets the fault, 0 if there is
 * none; it may be NULL. Vertices that no triangle uses are not looked at.
 */
NKW_API nkw_result nkw_partition_validate(const nkw_partition_mesh *mesh, size_t *bad_triangle);

/**
 * Cuts the mesh into parts of at most max_bones bones (2, 4 or any). The arrays of *out are the caller's; the counts
 * are written. Gives the fault of nkw_partition_validate, or NKW_TOO_SMALL where work_count is less than sizes.work,
 * all counts then 0; and NKW_TOO_MANY where triangles are rejected, *bad_triangle the first of them: all others are in
 * parts even so, and whether that is an error is the caller's to say. No triangles, no parts.
 *
 * The same parts on every target. The time grows with the triangles and, beyond a few thousand of them, with the
 * different sets of bones: with parts * max_bones * sets that have one and the same bone.
 */
NKW_API nkw_result nkw_partition_build(const nkw_partition_mesh *mesh, size_t max_bones, uint32_t *work,
                                       size_t work_count, nkw_partition *out, size_t *bad_triangle);

/** Floats in a bone-local vertex of `slots` slots: weight and position for each, and the normal where there is one. */
#define NKW_BONE_LOCAL_FLOATS(slots, normals) ((slots) * ((normals) ? 7 : 4))

/**
 * The converter's vertices: each has, for each of the part's bones, its weight there and its position and normal in the
 * space of that bone, so that a shader needs the bones' model matrices alone, no inverse bind:
 *
 *     weight, x, y, z, nx, ny, nz     for slot 0, then for slot 1, ...
 *     position(slot) = inverse_bind[bone] (p, 1)      normal(slot) = inverse_bind[bone] (n, 0)
 *
 *     p' = sum over slots of weight * model[bone] (position, 1)
 *
 * Positions and normals are not weighted. A slot whose bone does not move the vertex has its position and the weight
 * 0; slots beyond the part's bones are all 0. A bone that a vertex names twice has the sum of both weights.
 *
 * mesh          the mesh that the partition was built from
 * part          which part; one that the partition has not, and one that leads outside it or the mesh, writes nothing
 * slots         how many a vertex has, at least the part's bones to have them all: N, or the converter's 2 or 4
 * inverse_bind  mesh.bones affine matrices
 * positions     mesh.vertices; normals too, or NULL: then there are four floats to a slot
 * out           the part's vertex i begins at out[i * stride]
 * stride        floats from vertex to vertex, at least NKW_BONE_LOCAL_FLOATS(slots, normals), else nothing is written.
 *               What is beyond is left as it is: room for texture coordinates
 *
 * Error  of the sum against linear blend skinning, each coordinate, by the rounding of what is written: 2e-7 R for
 *        rigid bones and weights that sum to 1, R the largest distance of vertices and bones from the origin.
 */
NKW_API void nkw_partition_bone_local(const nkw_partition_mesh *mesh, const nkw_partition *partition, size_t part,
                                      size_t slots, const nkw_mat4 *inverse_bind, const nkw_vec3 *positions,
                                      const nkw_vec3 *normals, float *out, size_t stride);

/**
 * Bones by their distance from the root: order[0..bones-1] are the bones, roots first, then their children, each level
 * ascending by index; depths[b] is the level of bone b, a root's 0. So parents stand before their children whatever the
 * file's order is.
 *
 * parents   -1 for a root, else the parent's index
 * bones     at most 65536, else NKW_OUT_OF_RANGE and *bad_bone 65536
 * order     may be NULL, for the depths alone
 * bad_bone  may be NULL
 *
 * NKW_OUT_OF_RANGE where a parent is neither -1 nor a bone, NKW_NOT_A_TREE where going up from a bone never ends;
 * *bad_bone is then the first such bone, and order is not written.
 */
NKW_API nkw_result nkw_bones_order(const int32_t *parents, size_t bones, uint16_t *depths, uint32_t *order,
                                   size_t *bad_bone);

#ifdef __cplusplus
}
#endif

#endif
