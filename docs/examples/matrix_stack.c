/* SPDX-License-Identifier: MIT */
#include "matrix_stack.h"

#include <nakawari/mat.h>

static int is_link(int32_t to, size_t count)
{
    return to == NKW_NO_JOINT || (to >= 0 && (size_t)to < count);
}

static nkw_result stop(nkw_result result, size_t node, size_t *bad_node)
{
    if (bad_node)
        *bad_node = node;
    return result;
}

/* local parent, of row vectors: element (row r, column c) is at r * 4 + c. The sums of nkw_mat4_mul_affine. */
static nkw_mat4 mul_rows(const nkw_mat4 *local, const nkw_mat4 *parent)
{
    nkw_mat4 out;
    const float *p = parent->m;
    for (size_t r = 0; r < 4; r++) {
        const float *l = local->m + 4 * r;
        for (size_t c = 0; c < 3; c++) {
            float below = r == 3 ? l[2] * p[8 + c] + p[12 + c] : l[2] * p[8 + c];
            out.m[4 * r + c] = (l[0] * p[c] + l[1] * p[4 + c]) + below;
        }
        out.m[4 * r + 3] = r == 3 ? 1.0f : 0.0f;
    }
    return out;
}

static nkw_mat4 compose(const nkw_mat4 *parent, const nkw_mat4 *local, stack_convention convention)
{
    if (!parent) {
        nkw_mat3 block = nkw_mat3_from_mat4(local);
        return nkw_mat4_from_mat3(&block, nkw_mat4_translation(local));
    }
    return convention == STACK_ROW_VECTORS ? mul_rows(local, parent) : nkw_mat4_mul_affine(parent, local);
}

nkw_result matrix_stack_walk(const nkw_tree *tree, const nkw_mat4 *locals, const nkw_mat4 *root,
                             stack_convention convention, int32_t *stack, size_t stack_count, nkw_mat4 *models,
                             size_t *bad_node)
{
    size_t top = 0, met = 0;
    int32_t node = 0;
    if (tree->node_count == 0)
        return stop(NKW_EMPTY, 0, bad_node);
    while (node != NKW_NO_JOINT) {
        int32_t last = node, child = tree->first_child[node];
        models[node] = compose(top ? &models[stack[top - 1]] : root, &locals[node], convention);
        if (child != NKW_NO_JOINT) {
            if (top == stack_count)
                return stop(NKW_TOO_SMALL, (size_t)node, bad_node);
            stack[top++] = node;
            node = child;
        } else {
            while (top && tree->next_sibling[last] == NKW_NO_JOINT)
                last = stack[--top];
            node = tree->next_sibling[last];
        }
        if (!is_link(node, tree->node_count))
            return stop(NKW_OUT_OF_RANGE, (size_t)last, bad_node);
        if (node != NKW_NO_JOINT && ++met == tree->node_count)
            return stop(NKW_NOT_A_TREE, (size_t)last, bad_node);
    }
    return stop(NKW_OK, 0, bad_node);
}
