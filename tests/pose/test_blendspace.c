/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

enum { SAMPLES = 9 };

static void draw_samples(random_source *r, float *samples, size_t numbers)
{
    for (size_t i = 0; i < numbers; i++)
        samples[i] = random_between(r, -4, 4);
}

static nkw_blendspace space_of(const float *samples, size_t count, size_t dimension, nkw_blendspace_kind kind)
{
    nkw_blendspace space = {samples, count, dimension, kind};
    return space;
}

static void weights_sum_to_one_and_stay_within(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 5000; i++) {
        float samples[3 * SAMPLES], point[3], weights[SAMPLES];
        size_t dimension = 1 + (size_t)i % 3, count = 1 + (size_t)i % SAMPLES;
        draw_samples(&r, samples, sizeof samples / sizeof *samples);
        draw_samples(&r, point, 3);
        for (int k = 0; k < 3; k++)
            point[k] *= i % 4 ? 1.0f : 100.0f;
        nkw_blendspace space = space_of(samples, count, dimension,
                                        dimension == 2 ? (nkw_blendspace_kind)(i % 2) : NKW_BLENDSPACE_CARTESIAN);
        assert_int_equal(nkw_blendspace_weights(&space, point, weights), NKW_OK);
        double sum = 0;
        for (size_t k = 0; k < count; k++) {
            assert_true(weights[k] >= 0.0f && weights[k] <= 1.0f);
            sum += (double)weights[k];
        }
        expect_near(sum, 1.0, 3e-7);
    }
}

static void samples_have_their_own_weight_exactly(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 1000; i++) {
        float samples[2 * SAMPLES], weights[SAMPLES];
        draw_samples(&r, samples, 2 * SAMPLES);
        if (i % 3 == 0)
            samples[0] = samples[1] = 0.0f;
        nkw_blendspace space = space_of(samples, SAMPLES, 2, (nkw_blendspace_kind)(i % 2));
        for (size_t k = 0; k < SAMPLES; k++) {
            nkw_blendspace_weights(&space, samples + 2 * k, weights);
            for (size_t j = 0; j < SAMPLES; j++)
                expect_bits(weights[j], j == k ? 1.0f : 0.0f);
        }
    }
}

static void one_dimension_is_linear_between_neighbours(void **state)
{
    (void)state;
    const float samples[4] = {5, -1, 0, 2};
    nkw_blendspace space = space_of(samples, 4, 1, NKW_BLENDSPACE_CARTESIAN);
    static const float points[6] = {-1.5f, -0.25f, 0.5f, 3, 4.25f, 9};
    static const float want[6][4] = {{0, 1, 0, 0},         {0, 0.25f, 0.75f, 0},
                                     {0, 0, 0.75f, 0.25f}, {1.0f / 3, 0, 0, 2.0f / 3},
                                     {0.75f, 0, 0, 0.25f}, {1, 0, 0, 0}};
    for (int i = 0; i < 6; i++) {
        float weights[4];
        nkw_blendspace_weights(&space, &points[i], weights);
        expect_floats_near(weights, want[i], 4, 1e-7);
    }
}

/* Of four samples at the corners of a square, the centre has a quarter each; the middle of an edge a half of two. */
static void a_square_is_weighted_symmetrically(void **state)
{
    (void)state;
    const float samples[8] = {0, 0, 1, 0, 1, 1, 0, 1}, centre[2] = {0.5f, 0.5f}, edge[2] = {0.5f, 0};
    const float quarters[4] = {0.25f, 0.25f, 0.25f, 0.25f}, halves[4] = {0.5f, 0.5f, 0, 0};
    nkw_blendspace space = space_of(samples, 4, 2, NKW_BLENDSPACE_CARTESIAN);
    float weights[4];
    nkw_blendspace_weights(&space, centre, weights);
    expect_floats_bits(weights, quarters, 4);
    nkw_blendspace_weights(&space, edge, weights);
    expect_floats_bits(weights, halves, 4);
}

/* In polar form, at one speed a direction half-way between two has half of each; the idle has none. */
static void polar_weights_keep_the_speed(void **state)
{
    (void)state;
    const float samples[6] = {0, 0, 2, 0, 0, 2}, point[2] = {1.41421356f, 1.41421356f};
    nkw_blendspace polar = space_of(samples, 3, 2, NKW_BLENDSPACE_POLAR);
    float weights[3];
    nkw_blendspace_weights(&polar, point, weights);
    expect_near(weights[0], 0, 1e-6);
    expect_near(weights[1], 0.5, 1e-6);
    expect_near(weights[2], 0.5, 1e-6);
    /* Behind two opposite samples: by the angle to each. */
    const float sides[4] = {2, 0, -2, 0}, behind[2] = {1, -1.7320508f};
    nkw_blendspace opposite = space_of(sides, 2, 2, NKW_BLENDSPACE_POLAR);
    nkw_blendspace_weights(&opposite, behind, weights);
    expect_near(weights[0], 2.0 / 3, 1e-6);
    expect_near(weights[1], 1.0 / 3, 1e-6);
    nkw_blendspace plain = space_of(samples, 3, 2, NKW_BLENDSPACE_CARTESIAN);
    const float inner[2] = {1, 1};
    nkw_blendspace_weights(&plain, inner, weights);
    expect_near(weights[1], weights[2], 0);
    assert_true(weights[0] >= 0.2f);
}

/* The weight of sample a against b at p by the definition, in long double: one way around the circle, or both. */
static long double polar_by_definition(const float *p, const float *a, const float *b)
{
    long double mean = (hypotl(a[0], a[1]) + hypotl(b[0], b[1])) / 2, least = 1, whole = acosl(-1) * 4;
    long double length = (hypotl(b[0], b[1]) - hypotl(a[0], a[1])) / mean;
    long double from_a = (hypotl(p[0], p[1]) - hypotl(a[0], a[1])) / mean;
    long double angle = 2 * remainderl(atan2l(b[1], b[0]) - atan2l(a[1], a[0]), whole / 2);
    long double of_p = 2 * remainderl(atan2l(p[1], p[0]) - atan2l(a[1], a[0]), whole / 2);
    const long double ways[2] = {angle, angle < 0 ? angle + whole : angle - whole};
    for (int k = 0; k < (fabsl(angle) >= whole / 4 ? 2 : 1); k++) {
        long double h = 1 - (from_a * length + of_p * ways[k]) / (length * length + ways[k] * ways[k]);
        least = h < least ? h : least;
    }
    return least > 0 ? least : 0;
}

static void polar_weights_are_those_of_the_definition(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 4000; i++) {
        enum { FEW = 4 };
        float samples[2 * FEW], point[2], weights[FEW];
        long double want[FEW], sum = 0;
        draw_samples(&r, samples, 2 * FEW);
        draw_samples(&r, point, 2);
        for (int k = 0; k < FEW; k++) {
            want[k] = 1;
            for (int j = 0; j < FEW; j++) {
                long double h = j == k ? 1 : polar_by_definition(point, samples + 2 * k, samples + 2 * j);
                want[k] = h < want[k] ? h : want[k];
            }
            sum += want[k];
        }
        if (sum < 1e-3L)
            continue;
        nkw_blendspace space = space_of(samples, FEW, 2, NKW_BLENDSPACE_POLAR);
        nkw_blendspace_weights(&space, point, weights);
        for (int k = 0; k < FEW; k++)
            expect_near(weights[k], (double)(want[k] / sum), 2e-6);
    }
}

static void weights_are_continuous(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 60; i++) {
        float samples[2 * SAMPLES], before[SAMPLES], weights[SAMPLES], point[2];
        for (int k = 0; k < SAMPLES; k++) {
            samples[2 * k] = (float)(k % 3) + random_between(&r, -0.2f, 0.2f);
            samples[2 * k + 1] = (float)(k / 3) + random_between(&r, -0.2f, 0.2f);
        }
        nkw_blendspace space = space_of(samples, SAMPLES, 2, NKW_BLENDSPACE_CARTESIAN);
        for (int s = 0; s <= 1000; s++) {
            point[0] = -1 + 0.004f * (float)s;
            point[1] = 0.5f + 0.3f * (float)(i % 5);
            nkw_blendspace_weights(&space, point, weights);
            for (int k = 0; s && k < SAMPLES; k++)
                assert_true(nkw_abs(weights[k] - before[k]) < 0.06f);
            memcpy(before, weights, sizeof before);
        }
    }
}

static void coincident_samples_share_their_weight(void **state)
{
    (void)state;
    const float samples[6] = {1, 2, 1, 2, 3, 3}, half[2] = {1, 2}, other[2] = {3, 3};
    nkw_blendspace space = space_of(samples, 3, 2, NKW_BLENDSPACE_CARTESIAN);
    float weights[3];
    nkw_blendspace_weights(&space, half, weights);
    const float want[3] = {0.5f, 0.5f, 0}, last[3] = {0, 0, 1};
    expect_floats_bits(weights, want, 3);
    nkw_blendspace_weights(&space, other, weights);
    expect_floats_bits(weights, last, 3);
}

static void numbers_that_are_not_finite_are_defined(void **state)
{
    (void)state;
    const float samples[6] = {1, 2, NAN, 2, 3, 3}, odd[2] = {NAN, 0}, endless[2] = {0, INFINITY}, point[2] = {1, 2};
    const float equal[3] = {0.5f, 0, 0.5f}, first[3] = {1, 0, 0};
    nkw_blendspace space = space_of(samples, 3, 2, NKW_BLENDSPACE_CARTESIAN);
    float weights[3];
    nkw_blendspace_weights(&space, odd, weights);
    expect_floats_bits(weights, equal, 3);
    nkw_blendspace_weights(&space, endless, weights);
    expect_floats_bits(weights, equal, 3);
    nkw_blendspace_weights(&space, point, weights);
    expect_floats_bits(weights, first, 3);
    space.kind = (nkw_blendspace_kind)7;
    assert_int_equal(nkw_blendspace_weights(&space, point, weights), NKW_BAD_METHOD);
    space.kind = NKW_BLENDSPACE_POLAR;
    space.dimension = 3;
    assert_int_equal(nkw_blendspace_weights(&space, point, weights), NKW_BAD_METHOD);
    space.dimension = 0;
    assert_int_equal(nkw_blendspace_weights(&space, point, weights), NKW_EMPTY);
    expect_floats_bits(weights, first, 3);
    space = space_of(NULL, 0, 2, NKW_BLENDSPACE_CARTESIAN);
    assert_int_equal(nkw_blendspace_weights(&space, point, NULL), NKW_EMPTY);
    space = space_of(samples + 2, 1, 2, NKW_BLENDSPACE_CARTESIAN);
    nkw_blendspace_weights(&space, point, weights);
    expect_bits(weights[0], 0.0f);
}

static void validate_names_the_first_offender(void **state)
{
    (void)state;
    float samples[6] = {1, 2, 3, 2, 3, 3};
    nkw_blendspace space = space_of(samples, 3, 2, NKW_BLENDSPACE_POLAR);
    size_t bad = 9;
    assert_int_equal(nkw_blendspace_validate(&space, &bad), NKW_OK);
    assert_int_equal(bad, 0);
    samples[4] = 1, samples[5] = 2;
    assert_int_equal(nkw_blendspace_validate(&space, &bad), NKW_REPEATED);
    assert_int_equal(bad, 2);
    samples[3] = INFINITY;
    assert_int_equal(nkw_blendspace_validate(&space, &bad), NKW_NOT_FINITE);
    assert_int_equal(bad, 1);
    space.dimension = 1;
    assert_int_equal(nkw_blendspace_validate(&space, NULL), NKW_BAD_METHOD);
    space.dimension = 0;
    assert_int_equal(nkw_blendspace_validate(&space, &bad), NKW_EMPTY);
    assert_int_equal(bad, 0);
}

static void each_part_of_the_shape_is_checked(void **state)
{
    (void)state;
    const float samples[6] = {0, 0, 1, 2, 3, 4};
    size_t bad = 9;
    nkw_blendspace space = space_of(samples, 2, 2, NKW_BLENDSPACE_POLAR);
    assert_int_equal(nkw_blendspace_validate(&space, &bad), NKW_OK);
    space.dimension = 3;
    assert_int_equal(nkw_blendspace_validate(&space, &bad), NKW_BAD_METHOD);
    space.kind = NKW_BLENDSPACE_CARTESIAN;
    assert_int_equal(nkw_blendspace_validate(&space, &bad), NKW_OK);
    space.kind = (nkw_blendspace_kind)2;
    assert_int_equal(nkw_blendspace_validate(&space, &bad), NKW_BAD_METHOD);
    space.dimension = 0;
    assert_int_equal(nkw_blendspace_validate(&space, &bad), NKW_EMPTY);
    space.dimension = 2;
    space.count = 0;
    assert_int_equal(nkw_blendspace_validate(&space, &bad), NKW_EMPTY);
    assert_int_equal(bad, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(weights_sum_to_one_and_stay_within),
        cmocka_unit_test(samples_have_their_own_weight_exactly),
        cmocka_unit_test(one_dimension_is_linear_between_neighbours),
        cmocka_unit_test(a_square_is_weighted_symmetrically),
        cmocka_unit_test(polar_weights_keep_the_speed),
        cmocka_unit_test(weights_are_continuous),
        cmocka_unit_test(coincident_samples_share_their_weight),
        cmocka_unit_test(numbers_that_are_not_finite_are_defined),
        cmocka_unit_test(validate_names_the_first_offender),
        cmocka_unit_test(polar_weights_are_those_of_the_definition),
        cmocka_unit_test(each_part_of_the_shape_is_checked),
    };
    return cmocka_run_group_tests_name("blendspace", tests, NULL, NULL);
}
