/* SPDX-License-Identifier: MIT */
#include "fuzz.h"
#include "../support/views.h"
#include "../../docs/examples/matrix_stack.h"

#include <string.h>

enum { JOINTS = 90 };

static void compose(fuzz *f, const nkw_skeleton *s, int wild)
{
    size_t n = s->joint_count, from = fuzz_huge(f), to = fuzz_huge(f);
    const float *pose = fuzz_pose(f, n, wild);
    nkw_mat4 *models = fuzz_block(f, n * sizeof *models), *locals = fuzz_matrices(f, n, wild);
    const nkw_mat4 *root = fuzz_byte(f) % 2 ? fuzz_matrices(f, 1, wild) : NULL;
    nkw_skeleton_models_from_pose(s, pose_view(pose, s->joint_count), root, NULL, models);
    FUZZ_CHECK(fuzz_affine(models, n));
    FUZZ_CHECK(wild || fuzz_finite((const float *)models, 16 * n));
    update_models_from_pose(s, pose, root, from, to, models);
    FUZZ_CHECK(fuzz_affine(models, n));
    nkw_skeleton_models_from_locals(s, locals, root, NULL, models);
    update_models_from_locals(s, locals, root, from, to, models);
    FUZZ_CHECK(fuzz_affine(models, n));
    nkw_mat4 *copy = fuzz_block(f, n * sizeof *copy);
    memcpy(copy, locals, n * sizeof *copy);
    nkw_skeleton_models_from_locals(s, copy, root, NULL, copy);
    FUZZ_CHECK(fuzz_same((float *)copy, (float *)models, 16 * n));
    nkw_skeleton_locals_from_models(s, models, root, locals);
    nkw_skeleton_locals_from_models(s, copy, root, copy);
    FUZZ_CHECK(fuzz_same((float *)copy, (float *)locals, 16 * n) && fuzz_affine(locals, n));
    float residual = pose_from_models(s, models, root, fuzz_room(f, NKW_POSE_FLOATS(n)));
    FUZZ_CHECK(residual >= 0.0f || (wild && residual != residual));
}

static void bounds(fuzz *f, const nkw_skeleton *s)
{
    size_t bad, n = s->joint_count, joint = fuzz_byte(f) % 4 ? fuzz_upto(f, JOINTS) : fuzz_huge(f);
    nkw_skeleton_validate(s, &bad);
    FUZZ_CHECK(bad < n || bad == 0);
    size_t end = nkw_skeleton_subtree_end(s, joint);
    FUZZ_CHECK(end <= n && (joint >= n || end > joint));
}

/* Maps are each other's inverses; parents come first and are those of the file. */
static void check_order(const int32_t *file, size_t n, const int32_t *to, const int32_t *from, const int32_t *parents)
{
    nkw_skeleton s = {parents, n};
    FUZZ_CHECK(nkw_skeleton_validate(&s, NULL) == NKW_OK);
    for (size_t j = 0; j < n; j++) {
        FUZZ_CHECK(from[j] >= 0 && (size_t)from[j] < n && (size_t)to[from[j]] == j);
        if (file)
            FUZZ_CHECK(parents[j] < 0 ? file[from[j]] < 0 : file[from[j]] == from[parents[j]]);
    }
}

static void order(fuzz *f, size_t n)
{
    const int32_t *file = fuzz_byte(f) % 2 ? fuzz_parents(f, n, 1) : fuzz_links(f, n, n, fuzz_byte(f) % 2);
    int32_t *to = fuzz_block(f, 4 * n), *from = fuzz_block(f, 4 * n), *parents = fuzz_block(f, 4 * n);
    size_t bad;
    nkw_result result = nkw_skeleton_from_parents(file, n, to, from, parents, &bad);
    FUZZ_CHECK(bad < n || bad == 0);
    if (result == NKW_OK)
        check_order(file, n, to, from, parents);
}

/* A sound tree, of first children and next siblings, in a file's order; or links at random. */
static nkw_tree draw_tree(fuzz *f, size_t n)
{
    int32_t *child = fuzz_links(f, n, n, 1), *sibling = fuzz_links(f, n, n, 1);
    const int32_t *parents = fuzz_parents(f, n, 0);
    nkw_tree tree = {child, sibling, n};
    if (fuzz_byte(f) % 2)
        return tree;
    for (size_t i = 0; i < n; i++)
        child[i] = sibling[i] = NKW_NO_JOINT;
    for (size_t i = n; i-- > 1;) {
        int32_t *first = parents[i] < 0 ? &sibling[0] : &child[parents[i]];
        sibling[i] = *first;
        *first = (int32_t)i;
    }
    for (size_t k = fuzz_byte(f) % 3; k > 0 && n; k--)
        (fuzz_byte(f) % 2 ? child : sibling)[fuzz_upto(f, n - 1)] = (int32_t)fuzz_upto(f, n) - 1;
    return tree;
}

static void walk(fuzz *f, size_t n)
{
    nkw_tree tree = draw_tree(f, n);
    int32_t *to = fuzz_block(f, 4 * n), *from = fuzz_block(f, 4 * n), *parents = fuzz_block(f, 4 * n);
    size_t bad, levels = fuzz_byte(f) % 2 ? n : fuzz_upto(f, 8);
    nkw_result result = nkw_skeleton_from_tree(&tree, to, from, parents, &bad);
    FUZZ_CHECK(bad < n || bad == 0);
    nkw_mat4 *locals = fuzz_matrices(f, n, 1), *models = fuzz_block(f, n * sizeof *models);
    stack_convention convention = (stack_convention)fuzz_choice(f, 1);
    nkw_result walked =
        matrix_stack_walk(&tree, locals, NULL, convention, fuzz_block(f, 4 * levels), levels, models, &bad);
    FUZZ_CHECK(bad < n || bad == 0);
    if (result != NKW_OK)
        return;
    check_order(NULL, n, to, from, parents);
    FUZZ_CHECK(walked == NKW_OK || walked == NKW_TOO_SMALL);
    FUZZ_CHECK(walked != NKW_OK || fuzz_affine(models, n));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    size_t n = fuzz_upto(&f, JOINTS);
    int wild = fuzz_byte(&f) % 2;
    nkw_skeleton s = {fuzz_parents(&f, n, wild), n};
    bounds(&f, &s);
    compose(&f, &s, wild);
    order(&f, fuzz_upto(&f, JOINTS));
    walk(&f, fuzz_upto(&f, JOINTS));
    return fuzz_end(&f);
}
