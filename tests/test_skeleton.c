/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

#define JOINTS 77

static float pose[NKW_POSE_FLOATS(JOINTS)];
static nkw_mat4 locals[JOINTS], models[JOINTS], walked[JOINTS];
static int32_t parents[JOINTS], child[JOINTS], sibling[JOINTS], work[3 * JOINTS];
static const nkw_skeleton skeleton = {parents, JOINTS};
static const nkw_tree tree = {child, sibling, JOINTS};
static const nkw_mat4 root = {{0.5f, 1, -2, 0, 3, 0.25f, 1, 0, -1, 1, 4, 0, 10, -20, 30, 1}};

/* Depth-first parents, some of them roots; some local matrices with uneven scale. */
static void draw(random_source *r)
{
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_trs trs = {random_vec3(r, -3, 3), random_rotation(r), random_vec3(r, 0.5f, 2)};
        int32_t parent = (int32_t)j - 1;
        for (uint64_t up = random_bits(r) % 4; up > 0 && parent >= 0; up--)
            parent = parents[parent];
        parents[j] = parent;
        nkw_pose_set(pose, JOINTS, j, &trs);
        locals[j] = nkw_mat4_from_trs(&trs);
    }
}

/* The same hierarchy as first children and next siblings. */
static void link_tree(void)
{
    int32_t roots = NKW_NO_JOINT;
    for (size_t j = 0; j < JOINTS; j++)
        child[j] = NKW_NO_JOINT;
    for (size_t j = JOINTS; j-- > 0;) {
        int32_t *first = parents[j] < 0 ? &roots : &child[parents[j]];
        sibling[j] = *first;
        *first = (int32_t)j;
    }
    assert_int_equal(roots, 0);
}

/* By the single functions. */
static nkw_mat4 model_of(size_t j, const nkw_mat4 *above)
{
    if (parents[j] < 0)
        return above ? nkw_mat4_mul_affine(above, &locals[j]) : locals[j];
    nkw_mat4 parent = model_of((size_t)parents[j], above);
    return nkw_mat4_mul_affine(&parent, &locals[j]);
}

static void expect_models(const nkw_mat4 *got, const nkw_mat4 *above)
{
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_mat4 want = model_of(j, above);
        expect_floats_bits(got[j].m, want.m, 16);
    }
}

static void models_are_parents_times_locals_bit_for_bit(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int round = 0; round < 30; round++) {
        const nkw_mat4 *above = round % 2 ? &root : NULL;
        draw(&r);
        nkw_models_from_pose(&skeleton, pose, above, models);
        expect_models(models, above);
        nkw_models_from_locals(&skeleton, locals, above, models);
        expect_models(models, above);
    }
}

static void any_number_of_joints_gives_the_same(void **state)
{
    (void)state;
    random_source r = random_from(2);
    draw(&r);
    for (size_t count = 0; count <= JOINTS; count++) {
        float part[NKW_POSE_FLOATS(JOINTS)];
        nkw_skeleton first = {parents, count};
        nkw_mat4 guard = {{7}};
        for (size_t j = 0; j < count; j++) {
            nkw_trs trs = nkw_pose_get(pose, JOINTS, j);
            nkw_pose_set(part, count, j, &trs);
        }
        if (count < JOINTS)
            models[count] = guard;
        nkw_models_from_pose(&first, part, &root, models);
        for (size_t j = 0; j < count; j++) {
            nkw_mat4 want = model_of(j, &root);
            expect_floats_bits(models[j].m, want.m, 16);
        }
        if (count < JOINTS)
            expect_floats_bits(models[count].m, guard.m, 16);
    }
}

static void locals_may_be_replaced_by_models(void **state)
{
    (void)state;
    random_source r = random_from(3);
    draw(&r);
    memcpy(models, locals, sizeof models);
    nkw_models_from_locals(&skeleton, models, &root, models);
    expect_models(models, &root);
}

static void shear_survives(void **state)
{
    (void)state;
    const nkw_vec3 z = {0, 0, 1};
    const int32_t two[2] = {NKW_NO_JOINT, 0};
    nkw_skeleton s = {two, 2};
    float p[NKW_POSE_FLOATS(2)];
    nkw_mat4 m[2];
    nkw_trs wide = {{0, 0, 0}, {0, 0, 0, 1}, {3, 1, 1}},
            turned = {{0, 0, 0}, nkw_quat_from_axis_angle(z, 0.5f), {1, 1, 1}};
    nkw_pose_set(p, 2, 0, &wide);
    nkw_pose_set(p, 2, 1, &turned);
    nkw_models_from_pose(&s, p, NULL, m);
    nkw_trs held = nkw_trs_from_mat4(&m[1]);
    assert_true(nkw_trs_residual(&held, &m[1]) > 0.1f);
    expect_near(m[1].m[0], 3 * cos(0.5), 1e-6);
    expect_near(m[1].m[1], sin(0.5), 1e-6);
    expect_near(m[1].m[4], -3 * sin(0.5), 1e-6);
}

static void an_update_changes_its_range_alone(void **state)
{
    (void)state;
    random_source r = random_from(4);
    draw(&r);
    nkw_models_from_pose(&skeleton, pose, &root, models);
    for (size_t from = 0; from < JOINTS; from++) {
        size_t end = nkw_skeleton_subtree_end(&skeleton, from);
        nkw_trs trs = {random_vec3(&r, -3, 3), random_rotation(&r), random_vec3(&r, 0.5f, 2)};
        nkw_pose_set(pose, JOINTS, from, &trs);
        locals[from] = nkw_mat4_from_trs(&trs);
        if (from % 2)
            nkw_models_update_from_pose(&skeleton, pose, &root, from, end, models);
        else
            nkw_models_update_from_locals(&skeleton, locals, &root, from, end, models);
        expect_models(models, &root);
    }
    nkw_mat4 kept = models[JOINTS - 1];
    nkw_models_update_from_pose(&skeleton, pose, NULL, JOINTS - 1, JOINTS - 1, models);
    expect_floats_bits(models[JOINTS - 1].m, kept.m, 16);
    nkw_models_update_from_pose(&skeleton, pose, &root, 3, 9999, models);
    expect_models(models, &root);
}

static void subtrees_end_where_their_joints_do(void **state)
{
    (void)state;
    const int32_t p[6] = {NKW_NO_JOINT, 0, 1, 0, NKW_NO_JOINT, 4};
    const size_t ends[7] = {4, 3, 3, 4, 6, 6, 6};
    nkw_skeleton s = {p, 6};
    for (size_t j = 0; j < 7; j++)
        assert_int_equal(nkw_skeleton_subtree_end(&s, j), ends[j]);
}

static void bad_parents_are_roots(void **state)
{
    (void)state;
    random_source r = random_from(5);
    const size_t bad[4] = {0, 3, 4, 6};
    draw(&r);
    parents[0] = 5;
    parents[3] = -7;
    parents[4] = 4;
    parents[6] = INT32_MAX;
    nkw_models_from_pose(&skeleton, pose, NULL, models);
    for (size_t i = 0; i < 4; i++)
        expect_floats_bits(models[bad[i]].m, locals[bad[i]].m, 16);
    nkw_models_from_pose(&skeleton, pose, &root, models);
    for (size_t i = 0; i < 4; i++) {
        nkw_mat4 want = nkw_mat4_mul_affine(&root, &locals[bad[i]]);
        expect_floats_bits(models[bad[i]].m, want.m, 16);
    }
}

/* The largest element of a - b, as a part of the largest of b. */
static double distance(const nkw_mat4 *a, const nkw_mat4 *b)
{
    double far = 0, size = 0;
    for (int i = 0; i < 16; i++) {
        far = fmax(far, fabs((double)a->m[i] - (double)b->m[i]));
        size = fmax(size, fabs((double)b->m[i]));
    }
    return far / size;
}

static void locals_come_back_from_models(void **state)
{
    (void)state;
    random_source r = random_from(6);
    nkw_mat4 back[JOINTS];
    draw(&r);
    for (size_t j = 0; j < JOINTS; j++)
        parents[j] = j == 0 ? NKW_NO_JOINT : (int32_t)(j - 1 - random_bits(&r) % (j < 4 ? j : 4));
    nkw_models_from_locals(&skeleton, locals, &root, models);
    nkw_locals_from_models(&skeleton, models, &root, back);
    for (size_t j = 0; j < 20; j++)
        assert_true(distance(&back[j], &locals[j]) < 1e-3);
    for (size_t j = 0; j < JOINTS; j++)
        assert_true(back[j].m[3] == 0.0f && back[j].m[15] == 1.0f);
    nkw_locals_from_models(&skeleton, models, &root, models);
    for (size_t j = 0; j < JOINTS; j++)
        expect_floats_bits(models[j].m, back[j].m, 16);
}

static void poses_come_back_from_rigid_models(void **state)
{
    (void)state;
    random_source r = random_from(7);
    float back[NKW_POSE_FLOATS(JOINTS)];
    draw(&r);
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_trs trs = nkw_pose_get(pose, JOINTS, j);
        trs.scale.x = trs.scale.y = trs.scale.z = 1.0f;
        nkw_pose_set(pose, JOINTS, j, &trs);
    }
    nkw_models_from_pose(&skeleton, pose, NULL, models);
    assert_true(nkw_pose_from_models(&skeleton, models, NULL, back) < 1e-4f);
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_trs got = nkw_pose_get(back, JOINTS, j), want = nkw_pose_get(pose, JOINTS, j);
        expect_rotation_near(got.rotation, want.rotation, 2e-5);
        expect_near(got.translation.x, want.translation.x, 1e-3);
        expect_near(got.scale.y, 1.0, 2e-5);
    }
}

static void a_singular_parent_gives_zero_locals(void **state)
{
    (void)state;
    const int32_t two[2] = {NKW_NO_JOINT, 0};
    nkw_skeleton s = {two, 2};
    nkw_mat4 m[2] = {{{0}}, root}, local[2];
    nkw_locals_from_models(&s, m, NULL, local);
    for (int i = 0; i < 15; i++)
        expect_bits(nkw_abs(local[1].m[i]), 0.0f);
}

static void the_stack_gives_the_bits_of_the_array_in_both_conventions(void **state)
{
    (void)state;
    random_source r = random_from(8);
    for (int round = 0; round < 20; round++) {
        const nkw_mat4 *above = round % 2 ? &root : NULL;
        size_t bad = 99;
        draw(&r);
        link_tree();
        nkw_models_from_locals(&skeleton, locals, above, models);
        for (int convention = NKW_COLUMN_VECTORS; convention <= NKW_ROW_VECTORS; convention++) {
            assert_int_equal(
                nkw_tree_walk(&tree, locals, above, (nkw_convention)convention, work, JOINTS, walked, &bad), NKW_OK);
            assert_int_equal(bad, 0);
            for (size_t j = 0; j < JOINTS; j++)
                expect_floats_bits(walked[j].m, models[j].m, 16);
        }
    }
}

static void a_full_stack_is_said(void **state)
{
    (void)state;
    int32_t down[4] = {1, 2, 3, NKW_NO_JOINT}, none[4] = {NKW_NO_JOINT, NKW_NO_JOINT, NKW_NO_JOINT, NKW_NO_JOINT};
    nkw_tree line = {down, none, 4};
    size_t bad = 99;
    assert_int_equal(nkw_tree_walk(&line, locals, NULL, NKW_COLUMN_VECTORS, work, 2, walked, &bad), NKW_TOO_SMALL);
    assert_int_equal(bad, 2);
    assert_int_equal(nkw_tree_walk(&line, locals, NULL, NKW_COLUMN_VECTORS, work, 3, walked, &bad), NKW_OK);
}

static void trees_become_skeletons(void **state)
{
    (void)state;
    random_source r = random_from(9);
    int32_t joint_of_node[JOINTS], node_of_joint[JOINTS], got[JOINTS];
    draw(&r);
    link_tree();
    assert_int_equal(nkw_tree_validate(&tree, work, NULL), NKW_OK);
    assert_int_equal(nkw_skeleton_from_tree(&tree, joint_of_node, node_of_joint, got, NULL), NKW_OK);
    for (int32_t j = 0; j < JOINTS; j++) {
        assert_int_equal(joint_of_node[j], j);
        assert_int_equal(node_of_joint[j], j);
        assert_int_equal(got[j], parents[j]);
    }
}

static void expect_tree(const int32_t *children, const int32_t *siblings, size_t count, nkw_result result, size_t node)
{
    nkw_tree t = {children, siblings, count};
    size_t bad = 99;
    assert_int_equal(nkw_tree_validate(&t, work, &bad), result);
    assert_int_equal(bad, node);
    assert_int_equal(nkw_tree_validate(&t, work, NULL), result);
}

static void trees_that_are_none_are_refused(void **state)
{
    (void)state;
    const int32_t up[3] = {1, 0, -1}, shared[3] = {1, 2, -1}, to2[3] = {-1, 2, -1}, none[3] = {-1, -1, -1};
    const int32_t far[3] = {1, 3, -1}, under[3] = {1, -2, -1}, own[3] = {-1, 1, -1}, line[3] = {1, 2, -1};
    expect_tree(none, none, 0, NKW_EMPTY, 0);
    expect_tree(line, none, 3, NKW_OK, 0);
    expect_tree(up, none, 3, NKW_NOT_A_TREE, 0);
    expect_tree(shared, to2, 3, NKW_NOT_A_TREE, 2);
    expect_tree(none, none, 3, NKW_NOT_A_TREE, 1);
    expect_tree(far, none, 3, NKW_OUT_OF_RANGE, 1);
    expect_tree(under, none, 3, NKW_OUT_OF_RANGE, 1);
    expect_tree(line, own, 3, NKW_NOT_A_TREE, 1);
}

static void walks_over_bad_trees_end_within_their_arrays(void **state)
{
    (void)state;
    random_source r = random_from(10);
    int refused = 0;
    for (int round = 0; round < 2000; round++) {
        int32_t c[6], s[6], stack[3];
        nkw_tree t = {c, s, 6};
        for (int i = 0; i < 6; i++) {
            c[i] = (int32_t)(random_bits(&r) % 9) - 2;
            s[i] = (int32_t)(random_bits(&r) % 9) - 2;
        }
        refused += nkw_tree_walk(&t, locals, NULL, NKW_COLUMN_VECTORS, stack, 3, walked, NULL) != NKW_OK;
    }
    assert_true(refused > 1000);
}

static void files_are_put_in_depth_first_order(void **state)
{
    (void)state;
    /* Node 4 is the root, its children 0 and 3; 0 has 5, 3 has 1 and 2. */
    const int32_t file[6] = {4, 3, 3, 4, NKW_NO_JOINT, 0};
    const int32_t order[6] = {4, 0, 5, 3, 1, 2}, numbers[6] = {1, 4, 5, 3, 0, 2}, want[6] = {-1, 0, 1, 0, 3, 3};
    int32_t joint_of_file[6], file_of_joint[6], got[6];
    size_t bad = 99;
    assert_int_equal(nkw_skeleton_order(file, 6, joint_of_file, file_of_joint, got, &bad), NKW_OK);
    assert_int_equal(bad, 0);
    assert_memory_equal(file_of_joint, order, sizeof order);
    assert_memory_equal(joint_of_file, numbers, sizeof numbers);
    assert_memory_equal(got, want, sizeof want);
}

static void depth_first_orders_stay(void **state)
{
    (void)state;
    random_source r = random_from(11);
    int32_t a[JOINTS], b[JOINTS], got[JOINTS];
    draw(&r);
    assert_int_equal(nkw_skeleton_order(parents, JOINTS, a, b, got, NULL), NKW_OK);
    assert_memory_equal(got, parents, sizeof got);
    for (int32_t j = 0; j < JOINTS; j++)
        assert_true(a[j] == j && b[j] == j);
}

static void any_order_becomes_a_valid_skeleton_of_the_same_shape(void **state)
{
    (void)state;
    random_source r = random_from(12);
    for (int round = 0; round < 50; round++) {
        int32_t place[JOINTS], file[JOINTS], joint_of_file[JOINTS], file_of_joint[JOINTS], got[JOINTS];
        nkw_skeleton made = {got, JOINTS};
        draw(&r);
        for (int32_t j = 0; j < JOINTS; j++)
            place[j] = j;
        for (size_t j = JOINTS; j-- > 1;) {
            size_t k = (size_t)(random_bits(&r) % (j + 1));
            int32_t swap = place[j];
            place[j] = place[k];
            place[k] = swap;
        }
        for (size_t j = 0; j < JOINTS; j++)
            file[place[j]] = parents[j] < 0 ? NKW_NO_JOINT : place[parents[j]];
        assert_int_equal(nkw_skeleton_order(file, JOINTS, joint_of_file, file_of_joint, got, NULL), NKW_OK);
        assert_int_equal(nkw_skeleton_validate(&made, NULL), NKW_OK);
        for (size_t j = 0; j < JOINTS; j++) {
            int32_t above = file[file_of_joint[j]];
            assert_int_equal(joint_of_file[file_of_joint[j]], j);
            assert_int_equal(got[j], above < 0 ? NKW_NO_JOINT : joint_of_file[above]);
        }
    }
}

static void orders_that_are_none_are_refused(void **state)
{
    (void)state;
    const int32_t cycle[4] = {NKW_NO_JOINT, 2, 3, 1}, far[4] = {-1, 0, 4, 0}, under[4] = {-1, -2, 0, 0};
    int32_t a[4], b[4], c[4];
    size_t bad = 99;
    assert_int_equal(nkw_skeleton_order(cycle, 4, a, b, c, &bad), NKW_NOT_A_TREE);
    assert_int_equal(bad, 1);
    assert_int_equal(nkw_skeleton_order(far, 4, a, b, c, &bad), NKW_OUT_OF_RANGE);
    assert_int_equal(bad, 2);
    assert_int_equal(nkw_skeleton_order(under, 4, a, b, c, &bad), NKW_OUT_OF_RANGE);
    assert_int_equal(bad, 1);
    assert_int_equal(nkw_skeleton_order(under, 0, a, b, c, &bad), NKW_EMPTY);
    assert_int_equal(bad, 0);
}

static void expect_invalid(const int32_t *p, size_t count, nkw_result result, size_t joint)
{
    nkw_skeleton s = {p, count};
    size_t bad = 99;
    assert_int_equal(nkw_skeleton_validate(&s, &bad), result);
    assert_int_equal(bad, joint);
    assert_int_equal(nkw_skeleton_validate(&s, NULL), result);
}

static void validate_names_the_first_offender(void **state)
{
    (void)state;
    const int32_t good[4] = {-1, 0, -1, 1}, late[4] = {-1, 2, 0, 1}, own[4] = {-1, 0, 2, 0}, far[4] = {-1, 0, 1, 4};
    const int32_t under[4] = {-1, 0, -2, 0};
    expect_invalid(good, 4, NKW_OK, 0);
    expect_invalid(good, 0, NKW_EMPTY, 0);
    expect_invalid(late, 4, NKW_NOT_ORDERED, 1);
    expect_invalid(own, 4, NKW_NOT_ORDERED, 2);
    expect_invalid(far, 4, NKW_OUT_OF_RANGE, 3);
    expect_invalid(under, 4, NKW_OUT_OF_RANGE, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(models_are_parents_times_locals_bit_for_bit),
        cmocka_unit_test(any_number_of_joints_gives_the_same),
        cmocka_unit_test(locals_may_be_replaced_by_models),
        cmocka_unit_test(shear_survives),
        cmocka_unit_test(an_update_changes_its_range_alone),
        cmocka_unit_test(subtrees_end_where_their_joints_do),
        cmocka_unit_test(bad_parents_are_roots),
        cmocka_unit_test(locals_come_back_from_models),
        cmocka_unit_test(poses_come_back_from_rigid_models),
        cmocka_unit_test(a_singular_parent_gives_zero_locals),
        cmocka_unit_test(the_stack_gives_the_bits_of_the_array_in_both_conventions),
        cmocka_unit_test(a_full_stack_is_said),
        cmocka_unit_test(trees_become_skeletons),
        cmocka_unit_test(trees_that_are_none_are_refused),
        cmocka_unit_test(walks_over_bad_trees_end_within_their_arrays),
        cmocka_unit_test(files_are_put_in_depth_first_order),
        cmocka_unit_test(depth_first_orders_stay),
        cmocka_unit_test(any_order_becomes_a_valid_skeleton_of_the_same_shape),
        cmocka_unit_test(orders_that_are_none_are_refused),
        cmocka_unit_test(validate_names_the_first_offender),
    };
    return cmocka_run_group_tests_name("skeleton", tests, NULL, NULL);
}
