/* SPDX-License-Identifier: MIT */
/*
 * cmocka with the assertions that arithmetic needs. A failure names the test's own line and prints both
 * numbers in hex and decimal, and their distance in ULPs.
 */
#ifndef NAKAWARI_TESTS_EXPECT_H
#define NAKAWARI_TESTS_EXPECT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include <nakawari/nakawari.h>

/* Fails unless got has the very bits of want (any NaN equals any NaN; -0 is not 0). */
#define expect_bits(got, want) expect_bits_at((got), (want), __FILE__, __LINE__)
/* Fails unless |got - want| <= bound. NaN fails. */
#define expect_near(got, want, bound) expect_near_at((got), (want), (bound), __FILE__, __LINE__)
/* Fails unless got is within `ulps` units in the last place of want. */
#define expect_ulps(got, want, ulps) expect_ulps_at((got), (want), (ulps), __FILE__, __LINE__)
#define expect_nan(got) expect_nan_at((got), __FILE__, __LINE__)
#define expect_vec3_bits(got, want) expect_vec3_bits_at((got), (want), __FILE__, __LINE__)
#define expect_vec3_near(got, want, bound) expect_vec3_near_at((got), (want), (bound), __FILE__, __LINE__)
#define expect_quat_bits(got, want) expect_quat_bits_at((got), (want), __FILE__, __LINE__)
#define expect_quat_near(got, want, bound) expect_quat_near_at((got), (want), (bound), __FILE__, __LINE__)
/* The same rotation: near want or near -want. */
#define expect_rotation_near(got, want, bound) \
    expect_rotation_near_at((got), (want), (bound), __FILE__, __LINE__)
#define expect_floats_near(got, want, count, bound) \
    expect_floats_near_at((got), (want), (count), (bound), __FILE__, __LINE__)
#define expect_floats_bits(got, want, count) \
    expect_floats_bits_at((got), (want), (count), __FILE__, __LINE__)

uint32_t bits_of(float value);
float float_of(uint32_t bits);
/* ULPs between two finite floats, counted over the representable values. */
double ulp_distance(float a, float b);

void expect_bits_at(float got, float want, const char *file, int line);
void expect_near_at(double got, double want, double bound, const char *file, int line);
void expect_ulps_at(float got, float want, double ulps, const char *file, int line);
void expect_nan_at(float got, const char *file, int line);
void expect_vec3_bits_at(nkw_vec3 got, nkw_vec3 want, const char *file, int line);
void expect_vec3_near_at(nkw_vec3 got, nkw_vec3 want, double bound, const char *file, int line);
void expect_quat_bits_at(nkw_quat got, nkw_quat want, const char *file, int line);
void expect_quat_near_at(nkw_quat got, nkw_quat want, double bound, const char *file, int line);
void expect_rotation_near_at(nkw_quat got, nkw_quat want, double bound, const char *file, int line);
void expect_floats_near_at(const float *got, const float *want, size_t count, double bound,
                           const char *file, int line);
void expect_floats_bits_at(const float *got, const float *want, size_t count, const char *file,
                           int line);

#endif
