/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"
#include "views.h"
#include "../../docs/examples/matrix_stack.h"

#define JOINTS 83

static uint64_t hash_matrices(uint64_t hash, const nkw_mat4 *m)
{
    return hash_floats(hash, m[0].m, 16 * JOINTS);
}

static uint64_t hash_numbers(uint64_t hash, const int32_t *a)
{
    for (size_t i = 0; i < JOINTS; i++) {
        float number = (float)a[i];
        hash = hash_floats(hash, &number, 1);
    }
    return hash;
}

static void draw_pose(random_source *r, float *pose)
{
    nkw_trs trs[JOINTS];
    for (int j = 0; j < JOINTS; j++) {
        trs[j].translation = random_vec3(r, -5, 5);
        trs[j].rotation = random_rotation(r);
        trs[j].scale = random_vec3(r, -0.5f, 2);
    }
    nkw_pose_from_trs(trs, pose_span(pose, JOINTS));
}

/* Parents above and below, three roots, in the order of a file that knows none: a walk with strides of 50 modulo 83. */
static uint64_t order(random_source *r, int32_t *parents)
{
    int32_t file[JOINTS], joint_of_node[JOINTS], node_of_joint[JOINTS];
    for (int k = 0; k < JOINTS; k++)
        file[k * 50 % JOINTS] = k < 3 ? NKW_NO_JOINT : (int32_t)(random_bits(r) % (uint64_t)k) * 50 % JOINTS;
    nkw_skeleton_from_parents(file, JOINTS, joint_of_node, node_of_joint, parents, NULL);
    uint64_t hash = hash_numbers(hash_numbers(HASH_START, joint_of_node), node_of_joint);
    return hash_numbers(hash, parents);
}

static uint64_t walk(uint64_t hash, const int32_t *parents, const nkw_mat4 *locals, const nkw_mat4 *root)
{
    int32_t child[JOINTS], sibling[JOINTS], a[JOINTS], b[JOINTS], c[JOINTS];
    int32_t roots = NKW_NO_JOINT;
    nkw_mat4 models[JOINTS];
    const nkw_tree tree = {child, sibling, JOINTS};
    for (int j = 0; j < JOINTS; j++)
        child[j] = NKW_NO_JOINT;
    for (int j = JOINTS - 1; j >= 0; j--) {
        int32_t *first = parents[j] == NKW_NO_JOINT ? &roots : &child[parents[j]];
        sibling[j] = *first;
        *first = j;
    }
    nkw_skeleton_from_tree(&tree, a, b, c, NULL);
    hash = hash_numbers(hash_numbers(hash_numbers(hash, a), b), c);
    matrix_stack_walk(&tree, locals, root, STACK_COLUMN_VECTORS, a, JOINTS, models, NULL);
    hash = hash_matrices(hash, models);
    matrix_stack_walk(&tree, locals, root, STACK_ROW_VECTORS, a, JOINTS, models, NULL);
    return hash_matrices(hash, models);
}

uint64_t data_skeleton(void)
{
    random_source r = random_from(5);
    float pose[NKW_POSE_FLOATS(JOINTS)];
    int32_t parents[JOINTS];
    nkw_mat4 models[JOINTS], locals[JOINTS];
    const nkw_mat4 root = {{0.5f, 1, -2, 7, 3, 0.25f, 1, 7, -1, 1, 4, 7, 10, -20, 30, 7}};
    uint64_t hash = order(&r, parents);
    const nkw_skeleton skeleton = {parents, JOINTS};
    draw_pose(&r, pose);
    nkw_skeleton_models_from_pose(&skeleton, pose_view(pose, skeleton.joint_count), NULL, NULL, models);
    hash = hash_matrices(hash, models);
    update_models_from_pose(&skeleton, pose, &root, 17, 80, models);
    hash = hash_matrices(hash, models);
    nkw_skeleton_locals_from_models(&skeleton, models, &root, locals);
    hash = walk(hash_matrices(hash, locals), parents, locals, &root);
    nkw_skeleton_models_from_locals(&skeleton, locals, NULL, NULL, models);
    update_models_from_locals(&skeleton, locals, &root, 1, 16, models);
    hash = hash_matrices(hash, models);
    float residual = pose_from_models(&skeleton, models, NULL, pose);
    return hash_floats(hash_floats(hash, pose, NKW_POSE_FLOATS(JOINTS)), &residual, 1);
}
