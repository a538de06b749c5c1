/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 6: a skinned mesh cut into parts that each need at most N joints, for shaders whose palette holds no more.
 *
 * A part has triangles of one material and a list of at most N joints, and its vertices name their joints by the place
 * in that list, the slot. Every triangle comes into exactly one part, but for those whose own three vertices need more
 * than N joints: these are listed, and come into none.
 *
 *     part        material, a run of triangles, a run of joints, a run of vertices
 *     triangles   which triangle of the mesh it was; in a part, in the order of the mesh
 *     indices     three vertices of the part for each triangle, counted from the part's first
 *     vertices    which vertex of the mesh it was; in a part, in the order of first use
 *     slots       influence_count for each vertex: place in the part's joint list
 *     weights     influence_count for each vertex: the mesh's
 *
 * A vertex needs the joints whose weight is not zero. A part has no joints where all weights of its vertices are zero. Triangles of one material with the same joints stay together; the
 * sets of joints are packed one part after the other: the part begins with the largest set left and takes, again and
 * again, of the sets that share a joint with it the one that brings the fewest new joints; when none of them fits, the
 * largest set that does. Afterwards no two parts of one material could be one: together they need more than N joints.
 * The joint lists do not depend on the order of the triangles. Parts ascend by material, then by their joints.
 *
 * Source  the parts and their order: the skin model converter of スキンモデルデータの作成, with parts of two or four joints. The packing is greedy bin packing of items that
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
    size_t triangle_count; /**< at most 2^32 / 24 */
    const uint16_t *joints; /**< influence_count joints for each vertex; where the weight is 0, any number */
    const float *weights; /**< influence_count for each vertex, not negative; their sum is not looked at */
    size_t vertex_count; /**< less than 2^32 - 1 */
    size_t influence_count; /**< 1..8 */
    size_t joint_count; /**< at most 65536 */
    /**
     * NULL, or a number for each joint: the joints of a part ascend by this, then by index. With the depths
     * in the hierarchy roots come first; with NULL too, where parents come before their children.
     */
    const uint16_t *depths;
} nkw_partition_mesh;

/** One part. Every run is given by its first element in the arrays of nkw_partition, and how many there are. */
typedef struct nkw_part {
    uint32_t material;
    uint32_t first_triangle, triangle_count;
    uint32_t first_joint, joint_count;
    uint32_t first_vertex, vertex_count;
} nkw_part;

/** The mesh in parts: the caller's arrays, of the lengths that nkw_partition_bounds gives, and what is in them. */
typedef struct nkw_partition {
    nkw_part *parts; /**< sizes.part_count */
    uint16_t *joints; /**< sizes.joint_count: the parts' joints, one part after the other */
    uint32_t *triangles; /**< mesh.triangle_count: triangles of the mesh by part, then the rejected, ascending */
    uint32_t *indices; /**< 3 * mesh.triangle_count */
    uint32_t *vertices; /**< sizes.vertex_count: vertices of the mesh, part by part */
    uint16_t *slots; /**< sizes.vertex_count * influence_count; 0 where the weight is 0 */
    float *weights; /**< sizes.vertex_count * influence_count */
    size_t part_count, joint_count, triangle_count, vertex_count; /**< elements in use */
    size_t rejected_count; /**< triangles that need more than N joints: triangles[triangle_count] and on */
} nkw_partition;

/** Lengths that are enough for every mesh of these counts. */
typedef struct nkw_partition_sizes {
    size_t part_count, joint_count, vertex_count;
    size_t work_count; /**< uint32_t of working memory */
} nkw_partition_sizes;

/**
 * The lengths for a mesh of these counts, at most max_joint_count joints in a part; of the mesh only the counts are read. A
 * length that size_t cannot hold is SIZE_MAX. All are 0 for counts that nkw_partition_build refuses.
 */
NKW_API nkw_partition_sizes nkw_partition_bounds(const nkw_partition_mesh *mesh, size_t max_joint_count);

/**
 * Checks a mesh: NKW_OUT_OF_RANGE where a count is out of the range above (*bad_triangle is 0), a vertex index is not
 * below vertex_count, or a joint with a weight is not below joint_count; NKW_NOT_FINITE where a weight is not finite;
 * NKW_BAD_WEIGHTS where one is negative. *bad_triangle becomes the first triangle that meets the fault, 0 if there is
 * none; it may be NULL. Vertices that no triangle uses are not looked at.
 */
NKW_API nkw_result nkw_partition_validate(const nkw_partition_mesh *mesh, size_t *bad_triangle);

/**
 * Cuts the mesh into parts of at most max_joint_count joints (2, 4 or any). The arrays of *out are the caller's; the counts
 * are written. Returns the fault of nkw_partition_validate, or NKW_TOO_SMALL where work_count is less than
 * sizes.work_count, all counts are then 0; and NKW_TOO_MANY where triangles are rejected, *bad_triangle the first of them: all others are in
 * parts even so, and whether that is an error is the caller's to say. No triangles, no parts.
 *
 * The same parts on every target. The time grows with the triangles and, beyond a few thousand of them, with the
 * different sets of joints: with parts * max_joint_count * sets that have one and the same joint.
 */
NKW_API nkw_result nkw_partition_build(const nkw_partition_mesh *mesh, size_t max_joint_count, nkw_partition *out,
                                       size_t *bad_triangle, uint32_t *work, size_t work_count);

#ifdef __cplusplus
}
#endif

#endif
