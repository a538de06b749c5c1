/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Bounds of skinned meshes, from one box for each joint, without skinning a vertex.
 *
 * Linear blend skinning moves a vertex v to the mean of M_j v by its weights, which are not negative and sum to 1. So
 * with B_j a box of all vertices that joint j influences, the vertex is in the convex hull of the boxes M_j B_j, and
 * the box around them contains every skinned vertex:
 *
 *     box = union over j of M_j B_j        M_j the joint matrix of the palette
 *
 * The boxes of the joints are made once. A pose then costs about 40 ns for each joint. Rounding of skinning is
 * included, as a margin of 2^-19 of the largest magnitude.
 *
 * Not contained are vertices whose weights are negative or do not sum to 1 (nkw_skin_normalize_weights), and vertices
 * of dual quaternion skinning between joints that rotate against each other: they bulge out of the convex hull.
 */
#ifndef NAKAWARI_BOUNDS_H
#define NAKAWARI_BOUNDS_H

#include "box.h"
#include "skin.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The boxes of the joints in the bind pose: box j contains the positions of all vertices that joint j influences with a
 * weight other than 0. The last box, number joint_count, contains the vertices without influence, which skinning
 * copies.
 *
 * positions  of the mesh in the bind pose, skin->vertex_count vectors. For morph targets, add the extent of their
 *            differences to the boxes
 * boxes      receives joint_count + 1 boxes; empty where there are no vertices
 * Returns    NKW_OK; NKW_BAD_FORMAT for formats that are not for joints and weights; nothing is then written
 */
NKW_API nkw_result nkw_box_from_skin(const nkw_skin *skin, nkw_vec3_stream_view positions, nkw_box *boxes,
                                     size_t joint_count);

/**
 * The box of a pose: the union of nkw_box_transform of the boxes by the joint matrices, and of the last box.
 *
 * palette  joint matrices, NKW_PALETTE_MAT4 or NKW_PALETTE_MAT3X4; the box is in the space that the palette leads to
 * boxes    palette.joint_count + 1 boxes of nkw_box_from_skin
 * box      receives the box; empty if all boxes are
 * Returns  NKW_OK; NKW_BAD_FORMAT for another format; nothing is then written
 */
NKW_API nkw_result nkw_box_from_palette(nkw_palette_view palette, const nkw_box *boxes, nkw_box *box);

#ifdef __cplusplus
}
#endif

#endif
