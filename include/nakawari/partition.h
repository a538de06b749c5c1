/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Partitions a skinned mesh into parts of at most N joints, for shaders with a palette of N joints.
 *
 * A part has triangles of one material and a list of at most N joints. Its vertices name their joints by the index in
 * that list, the slot. Every triangle is in exactly one part, except triangles whose three vertices need more than N
 * joints: they are rejected and are in no part.
 *
 *     part        material, a range of triangles, a range of joints, a range of vertices
 *     triangles   the index of the triangle in the mesh; in a part, in the order of the mesh
 *     indices     three vertices for each triangle, counted from the first vertex of the part
 *     vertices    the index of the vertex in the mesh; in a part, in the order of first use
 *     joint_slots influence_count for each vertex: the index in the joint list of the part
 *     weights     influence_count for each vertex: copied from the mesh
 *
 * A vertex needs the joints whose weight is not zero. If all weights of its vertices are zero, a part has no joints.
 * Triangles of one material with the same set of joints are in the same part. The sets are packed into one part after
 * another. A part begins with the largest set left. Of the sets that share a joint with the part and fit, it takes the
 * one that adds the fewest joints, repeatedly; if there is none, the largest set that fits. So no two parts of one
 * material can be joined: together they need more than N joints. The joint lists do not depend on the order of the
 * triangles. Parts ascend by material, then by their joints.
 *
 * Source  the parts and their order: the skin model converter of スキンモデルデータの作成, with parts of two or four joints. The
 *         packing is greedy bin packing of items that share space: Grange, Kacem, Martin, Algorithms for the bin
 *         packing problem with overlapping items, 2018.
 */
#ifndef NAKAWARI_PARTITION_H
#define NAKAWARI_PARTITION_H

#include <stdint.h>

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * A skinned mesh, in arrays of the caller without a stride. Convert joints of one byte or of floats, integer weights and
 * interleaved vertices first: nkw_skin_prune.
 */
typedef struct nkw_partition_mesh {
    const uint32_t *indices; /**< 3 vertices for each triangle */
    const uint32_t *materials; /**< one for each triangle, any numbers; NULL: all 0 */
    size_t triangle_count; /**< at most 2^32 / 24 */
    const uint16_t *joints; /**< influence_count joints for each vertex; any number if the weight is 0 */
    const float *weights; /**< influence_count for each vertex, not negative; of any sum */
    size_t vertex_count; /**< less than 2^32 - 1 */
    size_t influence_count; /**< 1..8 */
    size_t joint_count; /**< at most 65536 */
    /**
     * NULL, or a number for each joint: the joints of a part ascend by this number, then by index. With the depths of
     * the joints in the hierarchy, parents come before their children; with NULL only if they do in the skeleton.
     */
    const uint16_t *depths;
} nkw_partition_mesh;
NKW_SIZE(nkw_partition_mesh, 72, 36);

/** One part: the first element and the count of its ranges in the arrays of nkw_partition. */
typedef struct nkw_part {
    uint32_t material;
    uint32_t first_triangle, triangle_count;
    uint32_t first_joint, joint_count;
    uint32_t first_vertex, vertex_count;
} nkw_part;
NKW_SIZE(nkw_part, 28, 28);

/** The parts of a mesh: arrays of the caller, of the lengths that nkw_partition_bounds returns, and their contents. */
typedef struct nkw_partition {
    nkw_part *parts; /**< sizes.part_count */
    uint16_t *joints; /**< sizes.joint_count: the joints of each part, in the order of the parts */
    uint32_t *triangles; /**< mesh.triangle_count: triangles of the mesh by part, then the rejected ones, ascending */
    uint32_t *indices; /**< 3 * mesh.triangle_count */
    uint32_t *vertices; /**< sizes.vertex_count: vertices of the mesh, in the order of the parts */
    uint16_t *joint_slots; /**< sizes.vertex_count * influence_count; 0 if the weight is 0 */
    float *weights; /**< sizes.vertex_count * influence_count */
    size_t part_count, joint_count, triangle_count, vertex_count; /**< elements in use */
    size_t rejected_count; /**< triangles that need more than N joints, from triangles[triangle_count] on */
} nkw_partition;
NKW_SIZE(nkw_partition, 96, 48);

/** Array lengths that are sufficient for every mesh of the same counts. */
typedef struct nkw_partition_sizes {
    size_t part_count, joint_count, vertex_count;
    size_t work_bytes; /**< of working memory */
} nkw_partition_sizes;
NKW_SIZE(nkw_partition_sizes, 32, 16);

/**
 * Returns the array lengths for parts of at most max_joint_count joints. Only the counts of the mesh are read. A length
 * that size_t cannot hold is SIZE_MAX. All are 0 for counts that nkw_partition_build rejects.
 */
NKW_API nkw_partition_sizes nkw_partition_bounds(const nkw_partition_mesh *mesh, size_t max_joint_count);

/**
 * Partitions the mesh into parts of at most max_joint_count joints.
 *
 * Checks the mesh first. Vertices that no triangle uses are not read.
 *
 * out      its arrays are the caller's; the function writes their elements and the counts, which are 0 after an error
 *          other than NKW_TOO_MANY
 * bad      receives the first offending triangle, 0 if there is none; may be NULL
 * work     work_bytes of nkw_partition_bounds
 * Returns
 *
 *     NKW_OK            no error; without triangles there are no parts
 *     NKW_OUT_OF_RANGE  a count is out of the range stated above (*bad is then 0), a vertex index is not less than
 *                       vertex_count, or a joint with a weight is not less than joint_count
 *     NKW_NOT_FINITE    a weight is not finite
 *     NKW_BAD_WEIGHTS   a weight is negative
 *     NKW_TOO_SMALL     too little working memory; none is needed to check a mesh
 *     NKW_TOO_MANY      triangles are rejected: *bad is the first of them, and all others are in parts
 *
 * The parts are the same on every target. The time grows linearly with the number of triangles. With more than a few
 * thousand different sets of joints it grows with parts * max_joint_count * (sets that contain the same joint).
 *
 * Stack  at most 2 KiB.
 */
NKW_API nkw_result nkw_partition_build(const nkw_partition_mesh *mesh, size_t max_joint_count, nkw_partition *out,
                                       size_t *bad, nkw_work work);

/** What nkw_partition_vertices reads, beside the partition. */
typedef struct nkw_partition_source {
    const nkw_partition_mesh *mesh; /**< the mesh that the partition was built from */
    const nkw_mat4 *inverse_bind; /**< mesh->joint_count affine matrices */
    const nkw_vec3 *positions; /**< mesh->vertex_count positions in the bind pose */
    const nkw_vec3 *normals; /**< mesh->vertex_count normals, or NULL */
} nkw_partition_source;
NKW_SIZE(nkw_partition_source, 32, 16);

/** The number of floats of a vertex of nkw_partition_vertices: per slot a weight, a position, and a normal if any. */
#define NKW_PARTITION_FLOATS(slot_count, normals) ((slot_count) * ((normals) ? 7 : 4))

/**
 * The vertices of a part in the spaces of its joints: for each of the part's joints the weight, and the position and
 * normal in the space of that joint. A shader then needs the models of the joints only, no inverse bind matrices:
 *
 *     weight, x, y, z, nx, ny, nz     for slot 0, then for slot 1, ...
 *     position(slot) = inverse_bind[joint] (p, 1)      normal(slot) = inverse_bind[joint] (n, 0)
 *
 *     p' = sum over slots of weight * model[joint] (position, 1)
 *
 * Positions and normals are not weighted. A slot whose joint does not influence the vertex has its position and the
 * weight 0; slots after the part's joints are 0. A joint that a vertex names twice has the sum of both weights.
 *
 * slot_count  slots of a vertex; joints of the part after these are left out
 * out         receives vertex i of the part from out[i * stride] on
 * stride      floats from vertex to vertex, at least NKW_PARTITION_FLOATS(slot_count, normals). The floats after these
 *             are not written: there is room for texture coordinates
 * Returns     NKW_OK; NKW_OUT_OF_RANGE for an unknown part, and for one with an index outside the partition or the
 *             mesh; NKW_TOO_SMALL for too small a stride. Nothing is written after an error
 *
 * Error   of p' against linear blend skinning, each coordinate: 2e-7 R for rigid joints and weights that sum to 1, R
 *         the largest distance of vertices and joints from the origin.
 * Source  the converter of skin models, スキンモデルデータの作成.
 */
NKW_API nkw_result nkw_partition_vertices(const nkw_partition *partition, size_t part,
                                          const nkw_partition_source *source, size_t slot_count, float *out,
                                          size_t stride);

#ifdef __cplusplus
}
#endif

#endif
