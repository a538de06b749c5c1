/* SPDX-License-Identifier: MIT */
#include "random.h"
#include "support/expect.h"

static nkw_result depths_of(const int32_t *parents, size_t joint_count, uint16_t *depths, uint32_t *order, size_t *bad)
{
    const nkw_skeleton skeleton = {parents, joint_count};
    return nkw_skeleton_depths(&skeleton, depths, order, bad);
}

static void joints_come_roots_first_and_level_by_level(void **state)
{
    (void)state;
    static const int32_t parents[] = {3, 0, 0, -1, 1, -1, 3};
    static const uint16_t want_depths[] = {1, 2, 2, 0, 3, 0, 1};
    static const uint32_t want[] = {3, 5, 0, 6, 1, 2, 4};
    uint16_t depths[7];
    uint32_t order[7];
    size_t bad = 99;
    assert_int_equal(depths_of(parents, 7, depths, order, &bad), NKW_OK);
    assert_int_equal(bad, 0);
    assert_memory_equal(depths, want_depths, sizeof depths);
    assert_memory_equal(order, want, sizeof order);
    assert_int_equal(depths_of(parents, 7, depths, NULL, NULL), NKW_OK);
    assert_int_equal(depths_of(NULL, 0, NULL, NULL, &bad), NKW_OK);
}

static void a_chain_of_all_joints_is_ordered_either_way(void **state)
{
    (void)state;
    static int32_t parents[65536];
    static uint16_t depths[65536];
    static uint32_t order[65536];
    for (int up = 0; up < 2; up++) {
        for (int32_t b = 0; b < 65536; b++)
            parents[b] = up ? b - 1 : b == 65535 ? -1 : b + 1;
        assert_int_equal(depths_of(parents, 65536, depths, order, NULL), NKW_OK);
        for (uint32_t b = 0; b < 65536; b++) {
            assert_int_equal(order[b], up ? b : 65535 - b);
            assert_int_equal(depths[b], up ? b : 65535 - b);
        }
    }
}

static void random_trees_are_ordered_parents_first(void **state)
{
    (void)state;
    random_source r = random_from(10);
    for (size_t round = 0; round < 100; round++) {
        size_t n = 1 + random_bits(&r) % 200, place[200];
        int32_t parents[200];
        uint16_t depths[200];
        uint32_t order[200];
        /* Tree over i, under the names (i * 7 + 3) mod n where that is one to one. */
        size_t step = n % 7 ? 7 : 1;
        for (size_t i = 0; i < n; i++)
            parents[(i * step + 3) % n] =
                i == 0 || random_bits(&r) % 20 == 0 ? -1 : (int32_t)((random_bits(&r) % i * step + 3) % n);
        assert_int_equal(depths_of(parents, n, depths, order, NULL), NKW_OK);
        for (size_t i = 0; i < n; i++)
            place[order[i]] = i;
        for (size_t b = 0; b < n; b++) {
            assert_int_equal(order[place[b]], b);
            assert_int_equal(depths[b], parents[b] < 0 ? 0 : depths[parents[b]] + 1);
            assert_true(parents[b] < 0 || place[parents[b]] < place[b]);
        }
    }
}

static void expect_no_order(const int32_t *parents, size_t joints, nkw_result result, size_t joint)
{
    uint16_t depths[8];
    uint32_t order[8] = {77};
    size_t bad = 99;
    assert_int_equal(depths_of(parents, joints, depths, order, &bad), result);
    assert_int_equal(bad, joint);
    assert_int_equal(order[0], 77);
}

static void parents_that_make_no_tree_are_named(void **state)
{
    (void)state;
    static const int32_t below[] = {-1, -2}, beyond[] = {-1, 0, 3}, own[] = {-1, 1}, cycle[] = {-1, 0, 4, 2, 3, 1};
    expect_no_order(below, 2, NKW_OUT_OF_RANGE, 1);
    expect_no_order(beyond, 3, NKW_OUT_OF_RANGE, 2);
    expect_no_order(own, 2, NKW_NOT_A_TREE, 1);
    expect_no_order(cycle, 6, NKW_NOT_A_TREE, 2);
    expect_no_order(NULL, 65537, NKW_OUT_OF_RANGE, 65536);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(joints_come_roots_first_and_level_by_level),
        cmocka_unit_test(a_chain_of_all_joints_is_ordered_either_way),
        cmocka_unit_test(random_trees_are_ordered_parents_first),
        cmocka_unit_test(parents_that_make_no_tree_are_named),
    };
    return cmocka_run_group_tests_name("skeleton_depths", tests, NULL, NULL);
}
