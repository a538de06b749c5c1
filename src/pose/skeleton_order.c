/* SPDX-License-Identifier: MIT */
/* Depth-first orders of parents in any order and of first-child/next-sibling trees. */
#include "lane/strict.h"

#include <nakawari/mat.h>
#include <nakawari/skeleton.h>

#include "report.h"

#define MOST_NODES ((size_t)INT32_MAX)

static int is_link(int32_t to, size_t count)
{
    return to == NKW_NO_JOINT || (to >= 0 && (size_t)to < count);
}

static nkw_result check_count(size_t count)
{
    return count == 0 ? NKW_EMPTY : count > MOST_NODES ? NKW_OUT_OF_RANGE : NKW_OK;
}

static void fill(int32_t *a, size_t count)
{
    for (size_t i = 0; i < count; i++)
        a[i] = NKW_NO_JOINT;
}

static nkw_result check_parents(const int32_t *parents, size_t count, size_t *offender)
{
    nkw_result result = check_count(count);
    for (size_t i = 0; result == NKW_OK && i < count; i++) {
        *offender = i;
        result = is_link(parents[i], count) ? NKW_OK : NKW_OUT_OF_RANGE;
    }
    return result;
}

/* Writes first children and next siblings in the order of the file. Returns the first root. */
static int32_t link_children(const int32_t *parents, size_t count, int32_t *first_child, int32_t *next_sibling)
{
    int32_t roots = NKW_NO_JOINT;
    fill(first_child, count);
    for (size_t i = count; i-- > 0;) {
        int32_t *first = parents[i] == NKW_NO_JOINT ? &roots : &first_child[parents[i]];
        next_sibling[i] = *first;
        *first = (int32_t)i;
    }
    return roots;
}

/* The depth-first walk: writes the nodes in the order of their visits and returns their number. */
static size_t walk_down(int32_t node, const int32_t *parents, const int32_t *first_child, const int32_t *next_sibling,
                        int32_t *met)
{
    size_t count = 0;
    while (node != NKW_NO_JOINT) {
        met[count++] = node;
        int32_t next = first_child[node];
        while (next == NKW_NO_JOINT && node != NKW_NO_JOINT) {
            next = next_sibling[node];
            node = parents[node];
        }
        node = next;
    }
    return count;
}

static size_t first_missing(const int32_t *number, size_t count)
{
    size_t i = 0;
    while (i < count && number[i] != NKW_NO_JOINT)
        i++;
    return i;
}

nkw_result nkw_skeleton_from_parents(const int32_t *node_parents, size_t joint_count, int32_t *joint_of_node,
                                     int32_t *node_of_joint, int32_t *parents, size_t *bad)
{
    size_t offender = 0;
    nkw_result result = check_parents(node_parents, joint_count, &offender);
    if (result != NKW_OK)
        return report(result, offender, bad);
    int32_t roots = link_children(node_parents, joint_count, joint_of_node, node_of_joint);
    size_t met = walk_down(roots, node_parents, joint_of_node, node_of_joint, parents);
    fill(joint_of_node, joint_count);
    for (size_t k = 0; k < met; k++) {
        node_of_joint[k] = parents[k];
        joint_of_node[parents[k]] = (int32_t)k;
    }
    if (met < joint_count)
        return report(NKW_NOT_A_TREE, first_missing(joint_of_node, joint_count), bad);
    for (size_t k = 0; k < joint_count; k++) {
        int32_t parent = node_parents[node_of_joint[k]];
        parents[k] = parent == NKW_NO_JOINT ? NKW_NO_JOINT : joint_of_node[parent];
    }
    return report(NKW_OK, 0, bad);
}

/* NKW_NOT_A_TREE if `node` was visited before (it has a number), NKW_OUT_OF_RANGE if one of its links is invalid. */
static nkw_result check_node(const nkw_tree *tree, int32_t node, const int32_t *joint_of_node)
{
    if (joint_of_node[node] != NKW_NO_JOINT)
        return NKW_NOT_A_TREE;
    if (!is_link(tree->first_child[node], tree->node_count) || !is_link(tree->next_sibling[node], tree->node_count))
        return NKW_OUT_OF_RANGE;
    return NKW_OK;
}

nkw_result nkw_skeleton_from_tree(const nkw_tree *tree, int32_t *joint_of_node, int32_t *node_of_joint,
                                  int32_t *parents, size_t *bad)
{
    nkw_result result = check_count(tree->node_count);
    if (result != NKW_OK)
        return report(result, 0, bad);
    fill(joint_of_node, tree->node_count);
    int32_t node = 0, parent = NKW_NO_JOINT, joint = 0;
    for (; node != NKW_NO_JOINT; joint++) {
        result = check_node(tree, node, joint_of_node);
        if (result != NKW_OK)
            return report(result, (size_t)node, bad);
        joint_of_node[node] = joint;
        node_of_joint[joint] = node;
        parents[joint] = parent;
        parent = joint;
        node = tree->first_child[node];
        while (node == NKW_NO_JOINT && parent != NKW_NO_JOINT) {
            node = tree->next_sibling[node_of_joint[parent]];
            parent = parents[parent];
        }
    }
    size_t missing = first_missing(joint_of_node, tree->node_count);
    return report(missing < tree->node_count ? NKW_NOT_A_TREE : NKW_OK, missing, bad);
}
