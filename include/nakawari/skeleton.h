/* SPDX-License-Identifier: MIT */
/**
 * @file
 * A skeleton: the parent of each joint; model matrices from local transforms, and the inverse.
 *
 * Every joint has one parent, except root joints. Joints are numbered so that a parent comes before its children, and
 * one pass over the array computes all model matrices:
 *
 *     model[j] = model[parent j] local[j]        root joints: root local[j]
 *
 * on column vectors: the local matrix is applied to a point first. A model matrix maps the joint's space to the
 * model's. It is a matrix and not a TRS because a rotated child of an unevenly scaled parent is sheared; a TRS cannot
 * represent shear.
 *
 * `root` places the whole skeleton: the position of the character in the world, or the product of the nodes above the
 * skeleton in a file. It is applied once, to each root joint. NULL: none. The transform of the first joint itself is
 * its local transform. Do not pass it as `root` too: it would be applied twice.
 *
 * All matrices are affine: last rows are not read and are written as exactly 0 0 0 1.
 *
 * Invalid parents are memory-safe: a joint is a root joint if its parent index is negative or not less than its own.
 * Only the validate functions report it.
 *
 * Source Foley, van Dam, Feiner, Hughes, Computer Graphics: Principles and Practice, chapter 7, 1990.
 *
 * Example  nkw_skeleton skeleton; nkw_tree tree; nkw_pose_view view; nkw_pose_span pose; nkw_mat4 *models, *locals;
 *          int32_t *a, *b, *parents; uint16_t *depths; uint32_t *order; float *error; size_t n, bad;
 *
 *     nkw_skeleton_validate(&skeleton, &bad);                     parents come first
 *     n = nkw_skeleton_subtree_end(&skeleton, 3);                 of joints in depth-first order
 *     nkw_skeleton_from_parents(a, 24, a, b, parents, &bad);      sorts nodes: parents first
 *     nkw_skeleton_depths(&skeleton, depths, order, &bad);        joints by depth
 *     nkw_skeleton_from_tree(&tree, a, b, parents, &bad);         from first children and siblings
 *     nkw_skeleton_models_from_pose(&skeleton, view, NULL, NULL, models);    forward kinematics
 *     nkw_skeleton_models_from_locals(&skeleton, locals, NULL, NULL, models);    of matrices
 *     nkw_skeleton_locals_from_models(&skeleton, models, NULL, locals);    and back
 *     nkw_skeleton_pose_from_models(&skeleton, models, NULL, pose, error);    decomposes all joints
 */
#ifndef NAKAWARI_SKELETON_H
#define NAKAWARI_SKELETON_H

#include <stdint.h>

#include "pose.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The index that stands for no joint or no node. */
#define NKW_NO_JOINT (-1)

/** A hierarchy over an array of the caller, which may be in a mapped file. */
typedef struct nkw_skeleton {
    const int32_t *parents; /**< joint_count indices: the parent, less than the joint's own index, or NKW_NO_JOINT */
    size_t joint_count; /**< at least 1 */
} nkw_skeleton;
NKW_SIZE(nkw_skeleton, 16, 8);

/**
 * Checks a skeleton.
 *
 * Returns  NKW_EMPTY without joints; NKW_OUT_OF_RANGE if a parent is neither a joint nor NKW_NO_JOINT; NKW_NOT_ORDERED
 *          if a parent does not come before its child, so for every cycle. *bad becomes the first offending joint, 0
 *          if there is none; it may be NULL.
 */
NKW_API nkw_result nkw_skeleton_validate(const nkw_skeleton *skeleton, size_t *bad);

/**
 * Returns the end of a subtree: `joint` .. end - 1 is the longest range in which every joint except the first has its
 * parent in the range. In depth-first order this is the joint and all its descendants. In other orders further
 * descendants may follow after the range. Returns joint_count if joint >= joint_count.
 */
NKW_API size_t nkw_skeleton_subtree_end(const nkw_skeleton *skeleton, size_t joint);

/**
 * The skeleton of the nodes of a file (glTF, Assimp), which may be in any order, in depth-first order: each joint is
 * followed by all its descendants. Children and roots keep their order in the file, so an order that is already
 * depth-first does not change.
 *
 * node_parents   joint_count parents, as node indices, before or after their children
 * joint_of_node  receives joint_count numbers: the joint of each node
 * node_of_joint  receives joint_count numbers: the node of each joint
 * parents        receives joint_count parents, as joint indices: a valid skeleton
 * Returns        NKW_EMPTY without joints; NKW_OUT_OF_RANGE if a parent is neither a node nor NKW_NO_JOINT, or if there
 *                are more than 2^31 - 1 nodes; otherwise NKW_NOT_A_TREE if a node is in a cycle or below one.
 *                *bad becomes the index of the first offending node, 0 if there is none; it may be NULL. The outputs
 *                are undefined after an error
 *
 * The three outputs are also the working memory: no two of the four arrays may be the same.
 */
NKW_API nkw_result nkw_skeleton_from_parents(const int32_t *node_parents, size_t joint_count, int32_t *joint_of_node,
                                             int32_t *node_of_joint, int32_t *parents, size_t *bad);

/**
 * The depths of the joints of a skeleton whose joints may be in any order, and the joints level by level: roots first,
 * then their children, each level ascending by index. A parent then precedes its children, whatever the order of the
 * file.
 *
 * skeleton  at most 65536 joints; a parent may come after its child
 * depths    receives the level of each joint; that of a root is 0
 * order     receives the joints, joint_count of them; may be NULL
 * Returns   NKW_OK; NKW_OUT_OF_RANGE for a parent that is neither a joint nor NKW_NO_JOINT, and for more joints, *bad
 *           is then 65536; NKW_NOT_A_TREE for a joint that is its own ancestor. `order` is not written after an error.
 *           *bad becomes the first joint that causes the error, 0 if there is none; it may be NULL
 */
NKW_API nkw_result nkw_skeleton_depths(const nkw_skeleton *skeleton, uint16_t *depths, uint32_t *order, size_t *bad);

/**
 * A hierarchy as in D3DXFRAME: each node has a first child and a next sibling. Node 0 is the first root; its siblings
 * are the other roots.
 */
typedef struct nkw_tree {
    const int32_t *first_child; /**< node_count nodes or NKW_NO_JOINT */
    const int32_t *next_sibling; /**< node_count nodes or NKW_NO_JOINT */
    size_t node_count; /**< at least 1 */
} nkw_tree;
NKW_SIZE(nkw_tree, 24, 12);

/**
 * The skeleton of a tree in depth-first order: a node, the subtrees of its children, its siblings. The tree is checked.
 * The arrays are those of nkw_skeleton_from_parents.
 *
 * Returns  NKW_EMPTY without nodes; NKW_OUT_OF_RANGE if a child or sibling is neither a node nor NKW_NO_JOINT, or if
 *          there are more than 2^31 - 1 nodes; NKW_NOT_A_TREE if a node is reached twice, as in every cycle, or not at
 *          all. *bad becomes the first offending node of the depth-first walk, otherwise the first node that the walk
 *          does not reach, 0 if there is none; it may be NULL. The outputs are undefined after an error
 */
NKW_API nkw_result nkw_skeleton_from_tree(const nkw_tree *tree, int32_t *joint_of_node, int32_t *node_of_joint,
                                          int32_t *parents, size_t *bad);

/**
 * Local to model: joint_count matrices from a pose (pose.h), or from local matrices.
 *
 *     model[j] = nkw_mat4_mul_affine(model[parent j], local[j]),    local[j] = nkw_mat4_from_trs(transform of j)
 *
 * bit for bit. For a root joint, `root` takes the place of the parent's matrix; if root is NULL, its model matrix is
 * the local matrix. `locals` may be `models`.
 *
 * range    NULL: all joints. Otherwise only these joints are written, for example after a change to their local
 *          transforms. The matrices of parents outside the range are read from `models`. nkw_skeleton_subtree_end
 *          returns the end of a subtree
 * Returns  NKW_MISMATCHED if the pose has another number of joints than the skeleton; nothing is then written
 *
 * Error  3.4 u for each joint from the root on, of the Frobenius norm of the 3x3 block; of the position 3.2 u, of the
 *        sum of the distances between the joints of the chain; for unit rotations with each component rounded once and
 *        uniform scales. This is the worst case of each joint: along random chains errors grow with the square root of
 *        the length, to 9.3 u in the root mean square and 23.3 u in the worst of 1000 chains of 67 joints, 67 u of 1000
 *        joints, and those of the position to 4 u.
 * Stack  at most 3 KiB in nkw_skeleton_models_from_pose.
 */
NKW_API nkw_result nkw_skeleton_models_from_pose(const nkw_skeleton *skeleton, nkw_pose_view pose, const nkw_mat4 *root,
                                                 const nkw_range *range, nkw_mat4 *models);
NKW_API void nkw_skeleton_models_from_locals(const nkw_skeleton *skeleton, const nkw_mat4 *locals, const nkw_mat4 *root,
                                             const nkw_range *range, nkw_mat4 *models);

/**
 * Model to local: local[j] = inverse(model[parent j]) model[j]. For a root joint, `root` takes the place of the
 * parent's matrix. If that matrix is flat (a scale of zero there or above), the 3x3 block and the translation of the
 * local matrix are zero, for finite models. Flat: the determinant is at most 2^-20 of the product of the lengths of the
 * columns; rounding decides whether it is 0. `locals` may be `models`.
 *
 * Error  13.0 u of |A^-1| |B| in the 3x3 block, and of |A^-1| (|s| + |t|) in the translation: A, s the block and the
 *        translation of the parent's matrix, B, t those of the joint's, the Frobenius norms; so of the local matrix
 *        times the condition of the parent's. 3.5 u for scales of 0.8 to 1.25.
 * Stack  at most 4 KiB.
 */
NKW_API void nkw_skeleton_locals_from_models(const nkw_skeleton *skeleton, const nkw_mat4 *models, const nkw_mat4 *root,
                                             nkw_mat4 *locals);

/**
 * Model to pose: the TRS (nkw_trs_from_mat4) of each local matrix of nkw_skeleton_locals_from_models; the padding
 * becomes the identity. A local matrix of zeros becomes the identity rotation with scale 0.
 *
 * residual  becomes the largest nkw_trs_residual: the shear that the pose cannot represent; about 1e-6 without shear,
 *           NaN if one residual is NaN; may be NULL
 * Returns   NKW_MISMATCHED if the pose has another number of joints than the skeleton; nothing is then written
 *
 * Stack  at most 6 KiB.
 */
NKW_API nkw_result nkw_skeleton_pose_from_models(const nkw_skeleton *skeleton, const nkw_mat4 *models,
                                                 const nkw_mat4 *root, nkw_pose_span pose, float *residual);

#ifdef __cplusplus
}
#endif

#endif
