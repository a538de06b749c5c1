/* SPDX-License-Identifier: MIT */
/* Functions of one number against those of the C library in binary64, rounded: equal bits for almost all arguments. */
#include <math.h>

#include "support/expect.h"
#include "support/random.h"

#define COUNT 400000

static float uniform(random_source *r)
{
    return random_between(r, -1.0f, 1.0f);
}

static float angle(random_source *r)
{
    return random_between(r, -3.15f, 3.15f);
}

/* Where the last term of the sine's polynomial is largest. */
static float steep_angle(random_source *r)
{
    return random_between(r, 1.35f, 1.79f);
}

/* Beyond what the short reduction of angles is for. */
static float far_angle(random_source *r)
{
    return random_scaled(r, 18, 60);
}

static float any(random_source *r)
{
    return random_scaled(r, -12, 12);
}

static float positive(random_source *r)
{
    return nkw_abs(random_scaled(r, -40, 40));
}

static float exponent(random_source *r)
{
    return random_between(r, -80.0f, 80.0f);
}

/*
 * `differ`: how many of the COUNT arguments have a result so close to the middle of two floats that it is the other
 * one.
 */
static const struct row {
    const char *name;
    float (*function)(float x);
    double (*exact)(double x);
    float (*draw)(random_source *r);
    int differ;
} rows[] = {
    {"sin", nkw_sin, sin, angle, 82},     {"sin", nkw_sin, sin, far_angle, 88},  {"cos", nkw_cos, cos, angle, 67},
    {"cos", nkw_cos, cos, far_angle, 86}, {"tan", nkw_tan, tan, angle, 63},      {"tan", nkw_tan, tan, far_angle, 56},
    {"asin", nkw_asin, asin, uniform, 0}, {"acos", nkw_acos, acos, uniform, 0},  {"atan", nkw_atan, atan, any, 0},
    {"exp", nkw_exp, exp, exponent, 0},   {"log", nkw_log, log, positive, 0},    {"exp", nkw_exp, exp, uniform, 0},
    {"atan", nkw_atan, atan, uniform, 0}, {"sin", nkw_sin, sin, steep_angle, 114},
};

static void functions_of_one_number_are_rounded_correctly(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        random_source r = random_from(100 + k);
        int differ = 0;
        for (int i = 0; i < COUNT; i++) {
            float x = rows[k].draw(&r), got = rows[k].function(x), want = (float)rows[k].exact((double)x);
            if (bits_of(got) == bits_of(want))
                continue;
            expect_ulps(got, want, 1);
            differ++;
        }
        if (differ != rows[k].differ) {
            print_error("%s: %d of %d are not rounded correctly, not %d\n", rows[k].name, differ, COUNT,
                        rows[k].differ);
            fail();
        }
    }
}

/* The turn from one angle to another, both near, either far, both far: as the directions say. */
static void differences_of_far_angles_are_exact(void **state)
{
    (void)state;
    random_source r = random_from(99);
    for (int i = 0; i < 200000; i++) {
        float from = i & 1 ? random_scaled(&r, 19, 127) : angle(&r),
              to = i & 2 ? random_scaled(&r, 19, 127) : angle(&r);
        double x = cos(to) * cos(from) + sin(to) * sin(from), y = sin(to) * cos(from) - cos(to) * sin(from);
        double off = fabs((double)nkw_angle_difference(from, to) - atan2(y, x));
        assert_true(off <= 3e-7 || fabs(off - 6.283185307179586) <= 3e-7);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(functions_of_one_number_are_rounded_correctly),
        cmocka_unit_test(differences_of_far_angles_are_exact),
    };
    return cmocka_run_group_tests_name("scalar_rounding", tests, NULL, NULL);
}
