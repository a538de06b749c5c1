/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Triangle meshes prepared for skinning and shading: smooth normals, tangents, consistent facing, equal
 * vertices joined.
 *
 * A corner is a vertex of a triangle: triangle t has the corners 3t, 3t + 1, 3t + 2. Normals are computed for corners,
 * because the two sides of a hard edge have the same position and different normals. Write the corners as vertices of
 * their own, then join those that are equal: nkw_mesh_weld.
 *
 * Corners have the same position if their coordinates are equal as numbers: -0 is 0. Triangles with two corners at the
 * same position, or with three on a line, are degenerate. Computed in binary64, sums in the order of the triangles.
 */
#ifndef NAKAWARI_MESH_H
#define NAKAWARI_MESH_H

#include <stdint.h>

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The triangles of a mesh, in arrays of the caller. Vertices that no triangle uses are not read. */
typedef struct nkw_mesh {
    const nkw_vec3 *positions; /**< vertex_count */
    size_t vertex_count; /**< at most 2^32 */
    const uint32_t *indices; /**< 3 for each triangle; NULL: 0 1 2, 3 4 5 ... */
    size_t triangle_count; /**< at most 2^32 / 24 */
} nkw_mesh;
NKW_SIZE(nkw_mesh, 32, 16);

/** The bytes of working memory that are enough for every function here that takes an nkw_mesh. */
#define NKW_MESH_WORK(triangle_count) ((triangle_count) * (size_t)192)

/**
 * Smooth normals, one for each corner:
 *
 *     n = normalize(sum over the corners c at the same position of angle(c) N(c))
 *
 * N(c) is the unit normal of the triangle of c, counter-clockwise seen from its tip, and angle(c) the angle of the
 * triangle at c. Counted are the triangles whose normal is at most `crease` from that of the corner's own triangle. The
 * weights by angle make the result independent of how flat faces are divided into triangles.
 *
 * Degenerate triangles have the weight 0; their own corners count all triangles at the position. Where the sum cancels
 * (its length is at most 2^-20 of the sum of its weights: both sides of a sheet), n is the normal of the corner's own
 * triangle. Where that is degenerate too, n is the zero vector.
 *
 * crease   radians, not negative; from pi on, all triangles count. 2^-20 rad are added for rounding
 * normals  receives 3 * mesh->triangle_count normals; may be the positions
 * bad      receives the first offending triangle, 0 if there is none; may be NULL
 * work     NKW_MESH_WORK
 * Returns
 *
 *     NKW_OK            no error
 *     NKW_OUT_OF_RANGE  a count is out of the range stated above (*bad is then 0), a vertex index is not less than
 *                       vertex_count, or the crease is negative or NaN (*bad is then 0)
 *     NKW_NOT_FINITE    a position is not finite
 *     NKW_TOO_SMALL     too little working memory; none is needed to check a mesh
 *
 * The time grows with the square of the number of triangles at one position, and linearly from pi on.
 *
 * Error   1 u of each component, where the sum is at least half of the sum of its weights
 * Source  Thuermer, Wuethrich, Computing Vertex Normals from Polygonal Facets, Journal of Graphics Tools, 1998.
 */
NKW_API nkw_result nkw_mesh_normals(const nkw_mesh *mesh, float crease, nkw_vec3 *normals, size_t *bad, nkw_work work);

/** The surface of a mesh: what tangents are computed from. */
typedef struct nkw_mesh_surface {
    const nkw_vec3 *normals; /**< mesh.vertex_count, of any length */
    const float *texcoords; /**< 2 for each vertex: u, v */
} nkw_mesh_surface;
NKW_SIZE(nkw_mesh_surface, 16, 8);

/**
 * Tangents by MikkTSpace, one for each corner: the basis of tangent space normal maps in which Blender and others bake.
 * The tangent is the direction of growing u in the plane of the normal n, the bitangent that of growing v:
 *
 *     t = normalize(sum over the corners c of the group of angle(c) S(c))       b = sign n x t
 *
 * S(c) is dP/du of the triangle of c, angle(c) its angle at c, both projected to the plane of n. A group is corners of
 * equal position, normal and texture coordinates, connected by shared edges, whose textures have the same orientation;
 * sign is -1 where the texture is mirrored. Normals are normalised first.
 *
 * A triangle without slopes, whose texture has no area (at most FLT_MIN), adds nothing, and its corners belong to the
 * first group that reaches them; corners that none reaches have the tangent (1, 0, 0) and the sign -1. A triangle with
 * two corners at one position has the tangents of the first other triangle at the same vertices, or the same. Where the
 * sum is zero, t is zero.
 *
 * In glTF, v grows downward in the picture, and normal maps are baked with v upward: negate the sign there.
 *
 * tangents    receives x, y, z, sign for each corner: 4 floats
 * bitangents  receives a vector for each corner, or NULL
 * bad         receives the first offending triangle, 0 if there is none; may be NULL
 * work        NKW_MESH_WORK
 * Returns     as nkw_mesh_normals; NKW_NOT_FINITE also for a normal or a texture coordinate
 *
 * The reference computes in binary32 and takes the angle from its cosine, which differs by up to 5e-4 rad near 0 and pi.
 * It also splits groups whose slopes are opposite.
 *
 * Source  Mikkelsen, Simulation of Wrinkled Surfaces Revisited, 2008, and his mikktspace.c.
 */
NKW_API nkw_result nkw_mesh_tangents(const nkw_mesh *mesh, nkw_mesh_surface surface, float *tangents,
                                     nkw_vec3 *bitangents, size_t *bad, nkw_work work);

/** What nkw_mesh_fix_facing found. Pieces are triangles that edges of two triangles connect; degenerate ones are none. */
typedef struct nkw_mesh_facing {
    size_t turned_count; /**< triangles whose second and third vertex were exchanged */
    size_t piece_count;
    size_t closed_count; /**< pieces all of whose edges have two triangles that agree */
    size_t conflict_count; /**< edges whose two triangles cannot agree: a Moebius strip has one */
    size_t branch_count; /**< edges of three triangles or more, which connect none */
} nkw_mesh_facing;
NKW_SIZE(nkw_mesh_facing, 40, 20);

/**
 * Makes the triangles of each piece face the same way: two triangles that share an edge, by its positions, pass it in
 * opposite directions.
 *
 *     closed pieces    outward: the volume, the sum of det(p0, p1, p2) / 6, is positive
 *     other pieces     the way of most of their triangles; of halves, that of the first triangle
 *
 * The same holds for closed pieces of no volume (at most 2^-40 of the sum of the magnitudes). A piece inside of another
 * is turned outward too. Degenerate triangles are not turned.
 *
 * indices  receives the triangles, 3 * mesh->triangle_count indices; may be the indices of the mesh
 * facing   receives what was found; may be NULL
 * bad      receives the first offending triangle, 0 if there is none; may be NULL
 * work     NKW_MESH_WORK
 * Returns  as nkw_mesh_normals
 *
 * Normals of turned triangles are not changed: where they point to the back, negate them, or compute them anew.
 */
NKW_API nkw_result nkw_mesh_fix_facing(const nkw_mesh *mesh, uint32_t *indices, nkw_mesh_facing *facing, size_t *bad,
                                       nkw_work work);

/** The bytes of working memory of nkw_mesh_weld for `count` records. */
#define NKW_MESH_WELD_WORK(count) ((count) * (size_t)12)

/**
 * Joins equal records, such as interleaved vertices: records whose `stride` bytes are the same. Floats are compared as
 * bits: 0 and -0 differ.
 *
 * records  `count` records of `stride` bytes, contiguous; any alignment
 * remap    receives for each record the number of its value; values are numbered in the order of their first record.
 *          So remap[i] is new if it is larger than all before, and record i is then its first
 * distinct receives the number of values; may be NULL
 * work     NKW_MESH_WELD_WORK
 * Returns  NKW_OUT_OF_RANGE for more than 2^30 records, NKW_TOO_SMALL; nothing is then written
 */
NKW_API nkw_result nkw_mesh_weld(const void *records, size_t count, size_t stride, uint32_t *remap, size_t *distinct,
                                 nkw_work work);

#ifdef __cplusplus
}
#endif

#endif
