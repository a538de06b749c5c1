/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "support/expect.h"

static void knots_are_sums_of_powers_of_distances(void **state)
{
    (void)state;
    static const float points[8] = {0, 0, 3, 4, 3, 4, 3, 13};
    float knots[4];
    const nkw_spline s = {NULL, points, 4, 2, 2, NKW_SPLINE_CATMULL_ROM, NKW_SPLINE_ENDS_FREE, 0, NULL, NULL};
    static const float uniform[4] = {0, 1, 2, 3}, centripetal[4] = {0, 2.23606798f, 2.23606798f, 5.23606798f},
                       chordal[4] = {0, 5, 5, 14}, squared[4] = {0, 25, 25, 106};
    assert_int_equal(nkw_spline_knots(&s, 0, knots), NKW_OK);
    expect_floats_bits(knots, uniform, 4);
    assert_int_equal(nkw_spline_knots(&s, 0.5f, knots), NKW_OK);
    expect_floats_near(knots, centripetal, 4, 5e-7);
    assert_int_equal(nkw_spline_knots(&s, 1, knots), NKW_OK);
    expect_floats_bits(knots, chordal, 4);
    assert_int_equal(nkw_spline_knots(&s, 2, knots), NKW_OK);
    expect_floats_near(knots, squared, 4, 1e-5);
    float kept[4];
    memcpy(kept, knots, sizeof kept);
    assert_int_equal(nkw_spline_knots(&s, NAN, knots), NKW_NOT_FINITE);
    nkw_spline bad = s;
    bad.stride = 1;
    assert_int_equal(nkw_spline_knots(&bad, 1, knots), NKW_BAD_WIDTH);
    bad.width = 0;
    assert_int_equal(nkw_spline_knots(&bad, 1, knots), NKW_EMPTY);
    bad = s;
    bad.count = 0;
    assert_int_equal(nkw_spline_knots(&bad, 1, knots), NKW_EMPTY);
    expect_floats_bits(knots, kept, 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(knots_are_sums_of_powers_of_distances),
    };
    return cmocka_run_group_tests_name("spline_knots", tests, NULL, NULL);
}
