/* SPDX-License-Identifier: MIT */
/** @file The model matrices of a tree by the matrix stack, to be compared with the array form of the library. */
#ifndef MATRIX_STACK_H
#define MATRIX_STACK_H

#include <nakawari/skeleton.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The side on which a vector is multiplied to a matrix. Any other number is read as STACK_COLUMN_VECTORS. */
typedef enum stack_convention {
    STACK_COLUMN_VECTORS, /**< v' = M v: model = parent local; this library, OpenGL, glTF */
    STACK_ROW_VECTORS /**< v' = v M: model = local parent; D3DX, DirectXMath; rows of row vectors */
} stack_convention;

/**
 * The model matrices of a tree by the matrix stack, the method of D3DX. Each node's local matrix is multiplied with the
 * matrix on top of the stack. Descending to a child pushes the product, returning pops it; siblings share the top. The
 * results have the bits of nkw_skeleton_models_from_locals in both conventions; docs/subjects/pose/skeleton.md explains
 * why.
 *
 * locals   node_count matrices in the layout of the convention (columns for column vectors, rows for row vectors)
 * root     the first matrix on the stack; NULL: none
 * stack    stack_count node indices: the nodes whose matrices are pushed; at least the number of levels minus 1
 * models   node_count matrices, in the order of the nodes; may be `locals`
 * Returns  NKW_EMPTY without nodes; NKW_TOO_SMALL if the stack is full; NKW_OUT_OF_RANGE if a child or sibling is out
 *          of range, or if there are more than 2^31 - 1 nodes; NKW_NOT_A_TREE if the walk visits more than node_count
 *          nodes. *bad_node becomes the node at which the walk stopped, 0 if there is none; it may be NULL.
 *
 * Nothing is written outside the arrays. The models of nodes that the walk does not reach are not written;
 * nkw_skeleton_from_tree reports such nodes.
 *
 * Source the matrix stack of ID3DXMatrixStack, Microsoft, DirectX 9 SDK.
 */
nkw_result matrix_stack_walk(const nkw_tree *tree, const nkw_mat4 *locals, const nkw_mat4 *root,
                             stack_convention convention, int32_t *stack, size_t stack_count, nkw_mat4 *models,
                             size_t *bad_node);

#ifdef __cplusplus
}
#endif

#endif
