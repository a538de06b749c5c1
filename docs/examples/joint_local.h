/* SPDX-License-Identifier: MIT */
/**
 * @file
 * The vertices of the skin model converter (スキンモデルデータの作成) from a partition, and joints by their depth.
 */
#ifndef JOINT_LOCAL_H
#define JOINT_LOCAL_H

#include <nakawari/partition.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Floats in a joint-local vertex of `slots` slots: weight and position for each, and the normal where there is one. */
#define JOINT_LOCAL_FLOATS(slots, normals) ((slots) * ((normals) ? 7 : 4))

/**
 * The converter's vertices: each has, for each of the part's joints, its weight there and its position and normal in
 * the space of that joint, so that a shader needs the joints' model matrices alone, no inverse bind:
 *
 *     weight, x, y, z, nx, ny, nz     for slot 0, then for slot 1, ...
 *     position(slot) = inverse_bind[joint] (p, 1)      normal(slot) = inverse_bind[joint] (n, 0)
 *
 *     p' = sum over slots of weight * model[joint] (position, 1)
 *
 * Positions and normals are not weighted. A slot whose joint does not move the vertex has its position and the weight
 * 0; slots beyond the part's joints are all 0. A joint that a vertex names twice has the sum of both weights.
 *
 * mesh          the mesh that the partition was built from
 * part          which part; one that the partition has not, and one that leads outside it or the mesh, writes nothing
 * slots         how many a vertex has, at least the part's joints to have them all: N, or the converter's 2 or 4
 * inverse_bind  mesh.joint_count affine matrices
 * positions     mesh.vertex_count; normals too, or NULL: then there are four floats to a slot
 * out           the part's vertex i begins at out[i * stride]
 * stride        floats from vertex to vertex, at least JOINT_LOCAL_FLOATS(slots, normals), else nothing is written.
 *               What is beyond is left as it is: room for texture coordinates
 *
 * Error  of the sum against linear blend skinning, each coordinate, by the rounding of what is written: 2e-7 R for
 *        rigid joints and weights that sum to 1, R the largest distance of vertices and joints from the origin.
 */
void joint_local_vertices(const nkw_partition_mesh *mesh, const nkw_partition *partition, size_t part, size_t slots,
                          const nkw_mat4 *inverse_bind, const nkw_vec3 *positions, const nkw_vec3 *normals, float *out,
                          size_t stride);

/**
 * Joints by their distance from the root: order[0..joint_count-1] are the joints, roots first, then their children,
 * each level ascending by index; depths[b] is the level of joint b, a root's 0. So parents stand before their children
 * whatever the file's order is.
 *
 * parents      -1 for a root, else the parent's index
 * joint_count  at most 65536, else NKW_OUT_OF_RANGE and *bad_joint 65536
 * order        may be NULL, for the depths alone
 * bad_joint    may be NULL
 *
 * NKW_OUT_OF_RANGE where a parent is neither -1 nor a joint, NKW_NOT_A_TREE where going up from a joint never ends;
 * *bad_joint is then the first such joint, and order is not written.
 */
nkw_result joints_by_depth(const int32_t *parents, size_t joint_count, uint16_t *depths, uint32_t *order,
                           size_t *bad_joint);

#ifdef __cplusplus
}
#endif

#endif
