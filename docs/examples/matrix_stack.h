/* SPDX-License-Identifier: MIT */
/** @file The model matrices of a tree by the matrix stack, to be compared with the array form of the library. */
#ifndef MATRIX_STACK_H
#define MATRIX_STACK_H

#include <nakawari/skeleton.h>

#ifdef __cplusplus
extern "C" {
#endif

/** On which side of a matrix its vectors stand. Any other number is read as STACK_COLUMN_VECTORS. */
typedef enum stack_convention {
    STACK_COLUMN_VECTORS, /**< v' = M v: model = parent local; this library, OpenGL, glTF */
    STACK_ROW_VECTORS /**< v' = v M: model = local parent; D3DX, DirectXMath; rows of row vectors */
} stack_convention;

/**
 * The model matrices of a tree by the matrix stack, the method of the D3DX days, to be read beside
 * nkw_models_from_locals: the top of the stack is what the node's local matrix is multiplied with; going down to a
 * child pushes the result, coming back pops it, siblings share what is there. Gives the very bits of the array form,
 * in both conventions: see docs/floors/5-skeleton.md for why.
 *
 * locals  node_count matrices in the convention's own layout (columns of column vectors, rows of row vectors)
 * root    what the stack begins with, or NULL for none
 * stack   stack_count nodes, whose matrices are the pushed ones; a tree needs as many as it has levels, less one
 * models  node_count matrices, in the nodes' order; may be `locals`
 *
 * NKW_EMPTY without nodes; NKW_TOO_SMALL where the stack is full; NKW_OUT_OF_RANGE and NKW_NOT_A_TREE where the walk
 * meets a child or sibling out of range, or has met more nodes than there are. *bad_node becomes the node that it
 * stopped at, 0 if there is none; it may be NULL. Nothing is ever written outside the arrays. Models of nodes that the
 * walk does not reach are not written; nkw_tree_validate finds them.
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
