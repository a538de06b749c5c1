/* SPDX-License-Identifier: MIT */
#include "random.h"
#include "support/expect.h"
#include "../../docs/examples/matrix_stack.h"

#define MOST 150

/* root 0; 1 and 4 below it, 2 and 3 below 1; root 5 with 6 */
static const int32_t small[7] = {NKW_NO_JOINT, 0, 1, 1, 0, NKW_NO_JOINT, 5};

static const nkw_mat4 some_root = {{0.5f, 1, -2, 7, 3, 0.25f, 1, 7, -1, 1, 4, 7, 10, -20, 30, 7}};

static void depth_first_files_keep_their_order(void **state)
{
    (void)state;
    int32_t to[7], from[7], parents[7];
    size_t bad = 99;
    assert_int_equal(nkw_skeleton_from_parents(small, 7, to, from, parents, &bad), NKW_OK);
    assert_int_equal(bad, 0);
    assert_memory_equal(parents, small, sizeof small);
    for (int32_t j = 0; j < 7; j++) {
        assert_int_equal(to[j], j);
        assert_int_equal(from[j], j);
    }
}

static void children_before_parents_are_put_in_order(void **state)
{
    (void)state;
    const int32_t file[6] = {3, 5, 3, NKW_NO_JOINT, 0, NKW_NO_JOINT};
    const int32_t want_from[6] = {3, 0, 4, 2, 5, 1}, want_to[6] = {1, 5, 3, 0, 2, 4},
                  want_parents[6] = {-1, 0, 1, 0, -1, 4};
    int32_t to[6], from[6], parents[6];
    assert_int_equal(nkw_skeleton_from_parents(file, 6, to, from, parents, NULL), NKW_OK);
    assert_memory_equal(from, want_from, sizeof from);
    assert_memory_equal(to, want_to, sizeof to);
    assert_memory_equal(parents, want_parents, sizeof parents);
}

/* A tree of n nodes under shuffled numbers. */
static void shuffle_tree(random_source *r, int32_t n, int32_t *file)
{
    int32_t name[MOST];
    for (int32_t k = 0; k < n; k++)
        name[k] = k;
    for (int32_t k = n - 1; k > 0; k--) {
        int32_t other = (int32_t)(random_bits(r) % (uint64_t)(k + 1)), kept = name[k];
        name[k] = name[other];
        name[other] = kept;
    }
    for (int32_t k = 0; k < n; k++)
        file[name[k]] = k == 0 || random_bits(r) % 20 == 0 ? NKW_NO_JOINT : name[random_bits(r) % (uint64_t)k];
}

static void any_order_becomes_depth_first_and_keeps_parents(void **state)
{
    (void)state;
    random_source r = random_from(9);
    for (int32_t n = 1; n <= MOST; n++) {
        int32_t file[MOST], to[MOST], from[MOST], parents[MOST];
        shuffle_tree(&r, n, file);
        const nkw_skeleton skeleton = {parents, (size_t)n};
        assert_int_equal(nkw_skeleton_from_parents(file, (size_t)n, to, from, parents, NULL), NKW_OK);
        assert_int_equal(nkw_skeleton_validate(&skeleton, NULL), NKW_OK);
        for (int32_t k = 0; k < n; k++) {
            assert_int_equal(to[from[k]], k);
            assert_int_equal(parents[k], file[from[k]] < 0 ? NKW_NO_JOINT : to[file[from[k]]]);
            /* Depth first: from a joint to the next its parent stays on the chain above. */
            int32_t above = k - 1;
            while (k && above != parents[k] && above >= 0)
                above = parents[above];
            assert_true(k == 0 || above == parents[k]);
        }
        for (int32_t a = 0; a < n; a++)
            for (int32_t b = a + 1; b < n; b++)
                assert_true(file[a] != file[b] || to[a] < to[b]);
    }
}

static void expect_order(const int32_t *file, size_t count, nkw_result result, size_t joint)
{
    int32_t to[8], from[8], parents[8];
    size_t bad = 99;
    assert_int_equal(nkw_skeleton_from_parents(file, count, to, from, parents, &bad), result);
    assert_int_equal(bad, joint);
    assert_int_equal(nkw_skeleton_from_parents(file, count, to, from, parents, NULL), result);
}

static void ordering_names_what_cannot_be_ordered(void **state)
{
    (void)state;
    const int32_t far[3] = {NKW_NO_JOINT, 3, 0}, negative[3] = {NKW_NO_JOINT, 0, -2};
    const int32_t cycle[5] = {NKW_NO_JOINT, 4, 1, 0, 2}, self[2] = {NKW_NO_JOINT, 1}, none[2] = {1, 0};
    expect_order(far, 0, NKW_EMPTY, 0);
    expect_order(far, 3, NKW_OUT_OF_RANGE, 1);
    expect_order(negative, 3, NKW_OUT_OF_RANGE, 2);
    expect_order(cycle, 5, NKW_NOT_A_TREE, 1);
    expect_order(self, 2, NKW_NOT_A_TREE, 1);
    expect_order(none, 2, NKW_NOT_A_TREE, 0);
}

/* The links of parents in any order; node 0 must be a root. Children may stand in either order. */
static void link_tree(const int32_t *parents, int32_t count, int32_t *child, int32_t *sibling)
{
    int32_t roots = NKW_NO_JOINT;
    for (int32_t j = 0; j < count; j++)
        child[j] = NKW_NO_JOINT;
    for (int32_t j = count; j-- > 0;) {
        int32_t *first = parents[j] == NKW_NO_JOINT ? &roots : &child[parents[j]];
        sibling[j] = *first;
        *first = j;
    }
    assert_int_equal(roots, 0);
}

static void trees_become_the_skeletons_of_their_parents(void **state)
{
    (void)state;
    random_source r = random_from(10);
    for (int32_t n = 1; n <= MOST; n++) {
        int32_t file[MOST], child[MOST], sibling[MOST], a[3][MOST], b[3][MOST];
        do
            shuffle_tree(&r, n, file);
        while (file[0] != NKW_NO_JOINT);
        link_tree(file, n, child, sibling);
        const nkw_tree tree = {child, sibling, (size_t)n};
        assert_int_equal(nkw_skeleton_from_parents(file, (size_t)n, a[0], a[1], a[2], NULL), NKW_OK);
        assert_int_equal(nkw_skeleton_from_tree(&tree, b[0], b[1], b[2], NULL), NKW_OK);
        for (int k = 0; k < 3; k++)
            assert_memory_equal(a[k], b[k], (size_t)n * sizeof(int32_t));
    }
}

static void expect_tree(const int32_t *child, const int32_t *sibling, size_t count, nkw_result result, size_t node)
{
    const nkw_tree tree = {child, sibling, count};
    int32_t a[3][4];
    size_t bad = 99;
    assert_int_equal(nkw_skeleton_from_tree(&tree, a[0], a[1], a[2], &bad), result);
    assert_int_equal(bad, node);
    assert_int_equal(nkw_skeleton_from_tree(&tree, a[0], a[1], a[2], NULL), result);
}

static void tree_validation_names_the_first_offender(void **state)
{
    (void)state;
    const int32_t child[4] = {1, 3, -1, -1}, sibling[4] = {-1, 2, -1, -1}, lone[4] = {-1, -1, -1, -1};
    const int32_t far[4] = {1, 4, -1, -1}, negative[4] = {-1, -2, -1, -1}, up[4] = {1, 0, -1, -1},
                  twice[4] = {-1, 2, 3, -1};
    const int32_t self[4] = {-1, 1, -1, -1};
    expect_tree(child, sibling, 4, NKW_OK, 0);
    expect_tree(child, sibling, 0, NKW_EMPTY, 0);
    expect_tree(far, sibling, 4, NKW_OUT_OF_RANGE, 1);
    expect_tree(child, negative, 4, NKW_OUT_OF_RANGE, 1);
    expect_tree(up, sibling, 4, NKW_NOT_A_TREE, 0);
    expect_tree(child, twice, 4, NKW_NOT_A_TREE, 3);
    expect_tree(child, self, 4, NKW_NOT_A_TREE, 1);
    expect_tree(lone, sibling, 4, NKW_NOT_A_TREE, 1);
}

static void the_matrix_stack_gives_the_bits_of_the_array_form(void **state)
{
    (void)state;
    random_source r = random_from(11);
    static nkw_mat4 locals[MOST], models[MOST], columns[MOST], rows[MOST];
    for (int32_t n = 1; n <= MOST; n++) {
        int32_t file[MOST], child[MOST], sibling[MOST], to[MOST], from[MOST], parents[MOST], stack[MOST];
        do
            shuffle_tree(&r, n, file);
        while (file[0] != NKW_NO_JOINT);
        link_tree(file, n, child, sibling);
        const nkw_tree tree = {child, sibling, (size_t)n};
        const nkw_skeleton skeleton = {parents, (size_t)n};
        const nkw_mat4 *root = n % 2 ? &some_root : NULL;
        for (int32_t k = 0; k < n; k++) {
            nkw_trs trs = {random_vec3(&r, -5, 5), random_rotation(&r), random_vec3(&r, 0.5f, 2)};
            locals[k] = nkw_mat4_from_trs(&trs);
        }
        assert_int_equal(matrix_stack_walk(&tree, locals, root, STACK_COLUMN_VECTORS, stack, MOST, columns, NULL),
                         NKW_OK);
        assert_int_equal(matrix_stack_walk(&tree, locals, root, STACK_ROW_VECTORS, stack, MOST, rows, NULL), NKW_OK);
        assert_int_equal(nkw_skeleton_from_tree(&tree, to, from, parents, NULL), NKW_OK);
        for (int32_t k = 0; k < n; k++)
            models[k] = locals[from[k]];
        nkw_skeleton_models_from_locals(&skeleton, models, root, NULL, models);
        for (int32_t k = 0; k < n; k++) {
            expect_floats_bits(columns[from[k]].m, models[k].m, 16);
            expect_floats_bits(rows[from[k]].m, models[k].m, 16);
        }
    }
}

/* By the book of row vectors, element by element and not through this library: v' = v (local parent). */
static void row_vectors_go_through_the_child_first(void **state)
{
    (void)state;
    const int32_t child[2] = {1, -1}, sibling[2] = {-1, -1};
    const nkw_tree tree = {child, sibling, 2};
    /* The parent turns x to y and moves by 10 x; the child moves by 7 x: the child's origin ends at (10, 7, 0). */
    const nkw_mat4 locals[2] = {{{0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 10, 0, 0, 1}},
                                {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7, 0, 0, 1}}};
    nkw_mat4 models[2];
    int32_t stack[1];
    assert_int_equal(matrix_stack_walk(&tree, locals, NULL, STACK_ROW_VECTORS, stack, 1, models, NULL), NKW_OK);
    const float want[16] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 10, 7, 0, 1};
    expect_floats_bits(models[1].m, want, 16);
}

static void expect_walk(const nkw_tree *tree, size_t stack_count, nkw_result result, size_t node)
{
    nkw_mat4 locals[4], models[4];
    int32_t stack[5] = {-7, -7, -7, -7, -7};
    size_t bad = 99;
    for (int j = 0; j < 4; j++)
        locals[j] = nkw_mat4_identity();
    assert_int_equal(matrix_stack_walk(tree, locals, NULL, STACK_COLUMN_VECTORS, stack, stack_count, models, &bad),
                     result);
    assert_int_equal(bad, node);
    assert_int_equal(stack[stack_count], -7);
    assert_int_equal(matrix_stack_walk(tree, locals, NULL, STACK_ROW_VECTORS, stack, stack_count, models, NULL),
                     result);
}

static void the_walk_stops_at_a_full_stack_and_at_bad_links(void **state)
{
    (void)state;
    const int32_t chain[4] = {1, 2, 3, -1}, none[4] = {-1, -1, -1, -1}, row[4] = {1, 2, 3, -1};
    const int32_t far[4] = {1, 4, -1, -1}, negative[4] = {1, -2, -1, -1}, loop[4] = {1, 2, 3, 0},
                  side[4] = {-1, 3, -1, 1};
    const nkw_tree deep = {chain, none, 4}, broad = {none, row, 4}, empty = {chain, none, 0};
    expect_walk(&deep, 3, NKW_OK, 0);
    expect_walk(&deep, 2, NKW_TOO_SMALL, 2);
    expect_walk(&deep, 0, NKW_TOO_SMALL, 0);
    expect_walk(&broad, 0, NKW_OK, 0);
    expect_walk(&empty, 3, NKW_EMPTY, 0);
    expect_walk(&(nkw_tree){far, none, 4}, 4, NKW_OUT_OF_RANGE, 1);
    expect_walk(&(nkw_tree){none, negative, 4}, 4, NKW_OUT_OF_RANGE, 1);
    expect_walk(&(nkw_tree){loop, none, 4}, 4, NKW_NOT_A_TREE, 3);
    expect_walk(&(nkw_tree){none, loop, 4}, 4, NKW_NOT_A_TREE, 3);
    expect_walk(&(nkw_tree){(const int32_t[4]){1, -1, -1, -1}, side, 4}, 4, NKW_NOT_A_TREE, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(depth_first_files_keep_their_order),
        cmocka_unit_test(children_before_parents_are_put_in_order),
        cmocka_unit_test(any_order_becomes_depth_first_and_keeps_parents),
        cmocka_unit_test(ordering_names_what_cannot_be_ordered),
        cmocka_unit_test(trees_become_the_skeletons_of_their_parents),
        cmocka_unit_test(tree_validation_names_the_first_offender),
        cmocka_unit_test(the_matrix_stack_gives_the_bits_of_the_array_form),
        cmocka_unit_test(row_vectors_go_through_the_child_first),
        cmocka_unit_test(the_walk_stops_at_a_full_stack_and_at_bad_links),
    };
    return cmocka_run_group_tests_name("skeleton_order", tests, NULL, NULL);
}
