/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

static int contains(const nkw_box *box, nkw_vec3 p)
{
    return box->low.x <= p.x && p.x <= box->high.x && box->low.y <= p.y && p.y <= box->high.y && box->low.z <= p.z &&
           p.z <= box->high.z;
}

static int is_empty(const nkw_box *box)
{
    return !(box->low.x <= box->high.x && box->low.y <= box->high.y && box->low.z <= box->high.z);
}

static nkw_box with_point(const nkw_box *box, nkw_vec3 p)
{
    const nkw_box point = {p, p};
    return nkw_box_union(box, &point);
}

static void boxes_join_and_grow(void **state)
{
    (void)state;
    nkw_box empty = NKW_BOX_EMPTY, a = {{0, 0, 0}, {1, 1, 1}}, b = {{-1, 2, 0.5f}, {0.5f, 3, 0.6f}};
    assert_int_equal(is_empty(&empty), 1);
    assert_int_equal(is_empty(&a), 0);
    nkw_box both = nkw_box_union(&a, &b), alone = nkw_box_union(&empty, &a);
    const nkw_box want = {{-1, 0, 0}, {1, 3, 1}};
    expect_floats_bits(&both.low.x, &want.low.x, 6);
    expect_floats_bits(&alone.low.x, &a.low.x, 6);
    nkw_vec3 odd = {NAN, 5, 5}, point = {2, 0.5f, 0};
    nkw_box partly = with_point(&a, odd), grown = with_point(&a, point);
    const nkw_box other = {{0, 0, 0}, {1, 5, 5}};
    expect_floats_bits(&partly.low.x, &other.low.x, 6);
    expect_bits(grown.high.x, 2);
    expect_bits(grown.high.y, 1);
    nkw_mat4 identity = nkw_mat4_identity();
    nkw_box moved = nkw_box_transform(&empty, &identity);
    assert_int_equal(is_empty(&moved), 1);
    nkw_box broken = {{NAN, 0, 0}, {1, 1, 1}};
    assert_int_equal(is_empty(&broken), 1);
}

static void the_box_of_points_has_their_least_and_greatest_numbers(void **state)
{
    (void)state;
    const nkw_vec3 points[] = {{3, -1, NAN}, {-2, 5, 1e-40f}, {0, 5, -7}, {3e38f, 2, -INFINITY}};
    const nkw_box want[] = {NKW_BOX_EMPTY,
                            {{3, -1, INFINITY}, {3, -1, -INFINITY}},
                            {{-2, -1, 1e-40f}, {3, 5, 1e-40f}},
                            {{-2, -1, -7}, {3, 5, 1e-40f}},
                            {{-2, -1, -INFINITY}, {3e38f, 5, 1e-40f}}};
    for (size_t n = 0; n <= 4; n++) {
        const nkw_box box = nkw_box_from_points(points, n);
        expect_floats_bits(&box.low.x, &want[n].low.x, 6);
    }
}

/* Each axis by itself: NaN in one coordinate, a side that runs back, an image that leaves the floats. */
static void each_axis_of_a_box_counts(void **state)
{
    (void)state;
    const nkw_box one = {{1, 1, 1}, {2, 2, 2}};
    for (int axis = 0; axis < 3; axis++) {
        nkw_vec3 p = {5, 5, 5};
        (&p.x)[axis] = NAN;
        nkw_box partly = with_point(&one, p), thin = one, flat = one;
        expect_bits((&partly.high.x)[axis], 2);
        expect_bits((&partly.high.x)[(axis + 1) % 3], 5);
        (&thin.low.x)[axis] = nextafterf(2, 3);
        assert_int_equal(is_empty(&thin), 1);
        (&flat.low.x)[axis] = 2;
        assert_int_equal(is_empty(&flat), 0);
        (&thin.low.x)[axis] = NAN;
        assert_int_equal(is_empty(&thin), 1);
        nkw_mat4 far = nkw_mat4_identity();
        far.m[12 + axis] = 3e38f;
        far.m[5 * axis] = 3e38f;
        nkw_box all = nkw_box_transform(&one, &far);
        for (int k = 0; k < 3; k++) {
            expect_bits((&all.low.x)[k], -INFINITY);
            expect_bits((&all.high.x)[k], INFINITY);
        }
        nkw_box empty = nkw_box_transform(&thin, &far);
        assert_int_equal(is_empty(&empty), 1);
    }
}

static void transformed_boxes_contain_transformed_points(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 20000; i++) {
        nkw_vec3 p = random_vec3(&r, -5, 5), q = random_vec3(&r, -5, 5);
        nkw_box box = NKW_BOX_EMPTY;
        box = with_point(&box, p);
        box = with_point(&box, q);
        nkw_trs trs = {random_vec3(&r, -100, 100), random_rotation(&r), random_vec3(&r, -3, 3)};
        nkw_mat4 t = nkw_mat4_from_trs(&trs);
        nkw_box moved = nkw_box_transform(&box, &t);
        for (int k = 0; k < 8; k++) {
            nkw_vec3 corner = {k & 1 ? p.x : q.x, k & 2 ? p.y : q.y, k & 4 ? p.z : q.z};
            assert_true(contains(&moved, nkw_mat4_transform_point(&t, corner)));
        }
    }
    nkw_mat4 t = nkw_mat4_identity();
    t.m[5] = INFINITY;
    const nkw_box one = {{1, 1, 1}, {2, 2, 2}};
    nkw_box all = nkw_box_transform(&one, &t);
    expect_bits(all.low.x, -INFINITY);
    expect_bits(all.high.z, INFINITY);
    t.m[5] = NAN;
    all = nkw_box_transform(&one, &t);
    expect_bits(all.low.y, -INFINITY);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(boxes_join_and_grow),
        cmocka_unit_test(the_box_of_points_has_their_least_and_greatest_numbers),
        cmocka_unit_test(each_axis_of_a_box_counts),
        cmocka_unit_test(transformed_boxes_contain_transformed_points),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
