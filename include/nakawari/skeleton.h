/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Floor 5: a skeleton: which joint hangs from which; and the way from local transforms to model matrices and back.
 *
 * Every joint has one parent, or none: then it is a root. Joints are numbered so that a parent comes before its
 * children, and one pass over an array is enough:
 *
 *     model[j] = model[parent j] local[j]        root joints: root local[j]
 *
 * on column vectors: a point goes through its own joint first. A model matrix takes from the joint's space to the
 * model's. It is a matrix and not a TRS because a turned child of an unevenly scaled parent is sheared, which a TRS
 * cannot say.
 *
 * `root` places the whole skeleton: the character in the world, or the nodes above the skeleton in a file. It is
 * applied once, to each joint that has no parent. NULL is for none. What a file says of the first joint itself is that
 * joint's local transform and not `root` as well: given as both, it would be applied twice.
 *
 * All matrices are affine: last rows are not read and are written as exactly 0 0 0 1.
 *
 * Any parents are safe: one that is not less than its joint, or is negative, makes the joint a root in all functions
 * but the validating ones. So nothing is read or written outside the arrays.
 *
 * Source Foley, van Dam, Feiner, Hughes, Computer Graphics: Principles and Practice, chapter 7, 1990.
 */
#ifndef NAKAWARI_SKELETON_H
#define NAKAWARI_SKELETON_H

#include <stdint.h>

#include "pose.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** In the place of a joint or node: none. */
#define NKW_NO_JOINT (-1)

/** A hierarchy over the caller's array, which may lie in a mapped file. */
typedef struct nkw_skeleton {
    const int32_t *parents; /**< joint_count indices: the joint's parent, less than its own, or NKW_NO_JOINT */
    size_t joint_count; /**< at least 1 */
} nkw_skeleton;

/**
 * Checks a skeleton: NKW_EMPTY without joints; NKW_OUT_OF_RANGE where a parent is neither a joint nor NKW_NO_JOINT;
 * NKW_NOT_ORDERED where a parent does not come before its child, which every cycle has somewhere. *bad_joint becomes
 * the first offending joint, 0 if there is none; it may be NULL.
 */
NKW_API nkw_result nkw_skeleton_validate(const nkw_skeleton *skeleton, size_t *bad_joint);

/**
 * The end of a subtree: joints `joint` .. end - 1 are the longest run in which every joint but the first has its
 * parent in the run. In depth-first order that is the joint and all below it. In other orders there may be more below
 * it further on. A joint that the skeleton has not gives joint_count.
 */
NKW_API size_t nkw_skeleton_subtree_end(const nkw_skeleton *skeleton, size_t joint);

/**
 * Puts joints that a file lists in any order (glTF nodes, Assimp) into depth-first order: each joint is followed by
 * all that is below it, its children in the file's order, roots too. So an order that is depth-first already stays as
 * it is.
 *
 * file_parents   joint_count parents in the file's numbers, before or after their children
 * joint_of_file  joint_count numbers: the new number of each of the file's joints
 * file_of_joint  joint_count numbers: the number in the file of each new joint
 * parents        joint_count parents in the new numbers: a valid skeleton
 *
 * The three outputs are also the working memory: no two of the four arrays may be the same.
 *
 * NKW_EMPTY without joints; NKW_OUT_OF_RANGE where a parent is neither a joint nor NKW_NO_JOINT (or where there are
 * more than 2^31 - 1); NKW_NOT_A_TREE where no root is above a joint, for it is in a cycle or below one; cycles are
 * looked for when all parents are joints. *bad_joint becomes the first offending joint in the file's numbers, 0 if
 * there is none; it may be NULL. Outputs hold nothing of use after an error.
 */
NKW_API nkw_result nkw_skeleton_order(const int32_t *file_parents, size_t joint_count, int32_t *joint_of_file,
                                      int32_t *file_of_joint, int32_t *parents, size_t *bad_joint);

/**
 * A hierarchy as D3DXFRAME and its like have it: every node knows its first child and its next sibling. Node 0 is the
 * first root, its siblings are the others.
 */
typedef struct nkw_tree {
    const int32_t *first_child; /**< node_count nodes or NKW_NO_JOINT */
    const int32_t *next_sibling; /**< node_count nodes or NKW_NO_JOINT */
    size_t node_count; /**< at least 1 */
} nkw_tree;

/** How many int32_t nkw_tree_validate takes as working memory. */
#define NKW_TREE_WORK(node_count) (3 * (node_count))

/**
 * Checks a tree: NKW_EMPTY without nodes; NKW_OUT_OF_RANGE where a child or sibling is neither a node nor NKW_NO_JOINT
 * (or where there are more than 2^31 - 1); NKW_NOT_A_TREE for a node that is reached twice (so every cycle) or not at
 * all. *bad_node becomes the first offender on the walk, then the first node that the walk leaves out; 0 if there is
 * none; it may be NULL.
 *
 * work  work_count numbers, at least NKW_TREE_WORK(node_count), otherwise NKW_TOO_SMALL
 */
NKW_API nkw_result nkw_tree_validate(const nkw_tree *tree, size_t *bad_node, int32_t *work, size_t work_count);

/**
 * The skeleton of a tree, depth first: a node, its children's subtrees, its siblings. Arrays as for
 * nkw_skeleton_order, with nodes in the place of the file's joints; results as for nkw_tree_validate.
 */
NKW_API nkw_result nkw_skeleton_from_tree(const nkw_tree *tree, int32_t *joint_of_node, int32_t *node_of_joint,
                                          int32_t *parents, size_t *bad_node);

/**
 * Local to model: joint_count matrices from a pose (pose.h), or from local matrices, where nodes are given as such.
 *
 *     model[j] = nkw_mat4_mul_affine(model[parent j], local[j]),    local[j] = nkw_mat4_from_trs(transform of j)
 *
 * bit for bit; joints without a parent: of `root`, or the local matrix itself where root is NULL. `locals` may be
 * `models`.
 *
 * range    NULL: all joints. Otherwise only these joints, after a change to their local transforms; the matrices of
 *          their parents outside the range are read from `models`. nkw_skeleton_subtree_end returns the end of a subtree
 * Returns  NKW_MISMATCHED for a pose of another number of joints than the skeleton, nothing is then written
 *
 * Error  2.8 u for each joint from the root on, of the Frobenius norm of the 3x3 block; of the place 2.6 u, of the
 *        length of the bones laid end to end; for rotations and even scales. That takes each joint for the worst: along
 *        a chain at random errors grow with the root of its length, to 20.4 u at the end of 67 joints and 77 u of 1000,
 *        and the place to 4 u.
 */
NKW_API nkw_result nkw_models_from_pose(const nkw_skeleton *skeleton, nkw_pose_view pose, const nkw_mat4 *root,
                                        const nkw_range *range, nkw_mat4 *models);
NKW_API void nkw_models_from_locals(const nkw_skeleton *skeleton, const nkw_mat4 *locals, const nkw_mat4 *root,
                                    const nkw_range *range, nkw_mat4 *models);

/**
 * Model to local: local[j] = inverse(model[parent j]) model[j], with `root` in the place of the parent's matrix where
 * there is none. A parent whose matrix is singular (a scale of zero) has no inverse: then the local's 3x3 block and
 * translation are zero, for finite models. `locals` may be `models`.
 *
 * Error  1.7 u of the product of the Frobenius norms of the inverse and of the model matrix, so of the local matrix
 *        times the condition of the parent's.
 */
NKW_API void nkw_locals_from_models(const nkw_skeleton *skeleton, const nkw_mat4 *models, const nkw_mat4 *root,
                                    nkw_mat4 *locals);

/**
 * Model to pose: the TRS (nkw_trs_from_mat4) of each of those local matrices; padding at the identity. A local matrix
 * that is zero becomes the identity rotation at scale 0.
 *
 * residual  becomes the largest nkw_trs_residual: the shear that the pose cannot hold; about 1e-6 where there is none,
 *           NaN where one is; may be NULL
 * Returns   NKW_MISMATCHED for a pose of another number of joints than the skeleton, nothing is then written
 */
NKW_API nkw_result nkw_pose_from_models(const nkw_skeleton *skeleton, const nkw_mat4 *models, const nkw_mat4 *root,
                                        nkw_pose_span pose, float *residual);

#ifdef __cplusplus
}
#endif

#endif
