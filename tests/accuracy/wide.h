/* SPDX-License-Identifier: MIT */
/*
 * The oracle of the accuracy programs: exact results in IEEE binary128, from the exact float inputs.
 *
 * Vectors, quaternions (x y z w) and matrices (column by column) are arrays of `wide`; arguments of the measured
 * functions are arrays of float, so that one driver samples, measures and prints them all. Errors are in u = 2^-24
 * of the norm of the exact result unless said otherwise. A NaN or an infinity is an infinite error.
 *
 * Needs GCC's libquadmath. Elsewhere WIDE_AVAILABLE is 0 and the program is skipped: WIDE_SKIPPED.
 */
#ifndef NAKAWARI_TESTS_WIDE_H
#define NAKAWARI_TESTS_WIDE_H

#if defined(__SIZEOF_FLOAT128__) && defined(__GNUC__) && !defined(__clang__)
#define WIDE_AVAILABLE 1
#else
#define WIDE_AVAILABLE 0
#endif

/* What CTest takes for skipped. */
#define WIDE_SKIP_CODE 77

#include <stdio.h>

#define WIDE_SKIPPED                                                                                                   \
    int main(void)                                                                                                     \
    {                                                                                                                  \
        puts("skipped: this compiler has no binary128 with libquadmath");                                              \
        return WIDE_SKIP_CODE;                                                                                         \
    }

#if WIDE_AVAILABLE

/* Samples are made in binary64 here and there: the same ones on every target. */
#pragma GCC optimize("fp-contract=off")

#include <nakawari/nakawari.h>

#include "../support/random.h"
#include "accuracy.h"

__extension__ typedef __float128 wide;

/* ---- The driver ---- */

/* The largest number of arguments of a sample: a 4x4 matrix and some. */
#define WIDE_ARGUMENTS 48

typedef void wide_sampler(random_source *r, float *x);
/* The error of one sample, in the unit of the function's Error line. */
typedef double wide_measure(const float *x);

typedef enum wide_kind {
    WIDE_CHECKED, /* against the Error line */
    WIDE_UNITS, /* the same; its unit quaternions are searched component by component too */
    WIDE_NOTED /* printed only: another measure than the Error line's, or outside its range */
} wide_kind;

typedef struct wide_case {
    const char *function;
    const char *region;
    wide_sampler *sample;
    wide_measure *error;
    int arguments;
    wide_kind kind;
} wide_case;

/* Measures each case over `count` samples, times the effort. */
void wide_run(accuracy *a, const wide_case *cases, size_t size, uint32_t count);
/*
 * The same, then a search of as many steps for cases that are checked: from the worst of 300 samples on, one of the
 * numbers that the sampler draws is changed, by 1 to 2^20 last places, to fewer bits, in one of its highest bits, to any
 * other, by whole exponents about the middle of its range, or to one equal or opposite to another, and stays so where
 * the error did not fall; after 3000 changes without gain, from the worst of other samples. So the sample stays in its
 * region. What is found is the case's worst, and its witness.
 */
void wide_search(accuracy *a, const wide_case *cases, size_t size, uint32_t count);
/* The same for cases that draw from wide_source; their witness is the seed that the climb began from. */
void wide_search_seeds(accuracy *a, const wide_case *cases, size_t size, uint32_t count);

/* The cases of a header that stand in the file STEM_more.c. */
void curve_more(accuracy *a);
void mat_more(accuracy *a);
void quat_more(accuracy *a);
void orient_more(accuracy *a);

/* ---- Between the types ---- */

nkw_vec3 vec3_at(const float *x);
nkw_quat quat_at(const float *x);
void put_vec3(float *x, nkw_vec3 v);
void put_quat(float *x, nkw_quat q);
void wide_from(const float *x, wide *out, int n);
/* Each element rounded. */
void wide_round(const wide *x, float *out, int n);

/* ---- Samples ---- */

/* Log-uniform in low .. high, both positive. */
float random_log(random_source *r, float low, float high);
/* Negative half of the time. */
float random_sign(random_source *r);
/* Uniform over rotations, each component of an exactly unit quaternion rounded once. */
nkw_quat random_unit_quat(random_source *r);
/* The same at `angle`, in radians between the quaternions, from q. */
nkw_quat random_unit_near(random_source *r, nkw_quat q, float angle);
/* The rotation matrix of q, unit, in binary64. */
void double_mat3_from_quat(nkw_quat q, double m[9]);

/* For samples of more numbers than arguments: the seed of a source, two numbers; and that source, taken once. */
void wide_seed(random_source *r, float *x);
random_source wide_source(const float *x);

/* ---- Norms and errors ---- */

wide wide_dot(const wide *a, const wide *b, int n);
wide wide_length(const wide *a, int n);
void wide_scale(wide *a, wide s, int n);
/* a / |a|; zero stays. */
void wide_normalize(wide *a, int n);
/* |got - exact| / |exact|. */
double wide_error(const float *got, const wide *exact, int n);
/* The same of the nearer of exact and -exact. */
double wide_error_either(const float *got, const wide *exact, int n);
/* |got - exact| / magnitude. */
double wide_error_of(const float *got, const wide *exact, int n, wide magnitude);
/* ||q| - 1|. */
double wide_unit_error(const float *q, int n);
/* 2 sin(angle / 2) of the turn between two rotations, neither need be unit. */
double wide_turn(const wide a[4], const wide b[4]);

/* ---- Algebra ---- */

wide wide_pi(void);
void wide_cross(const wide a[3], const wide b[3], wide out[3]);
void wide_quat_mul(const wide a[4], const wide b[4], wide out[4]);
/* The rotation of q, which need not be unit. */
void wide_mat3_from_quat(const wide q[4], wide m[9]);
/* The quaternion of the rotation nearest to m, for m not far from one. */
void wide_quat_from_mat3(const wide m[9], wide q[4]);
/* The turn by `angle` about a unit axis. */
void wide_quat_from_axis(const wide axis[3], wide angle, wide q[4]);
/* The logarithm of a unit quaternion, half the rotation vector, and its inverse. */
void wide_quat_log(const wide q[4], wide v[3]);
void wide_quat_exp(const wide v[3], wide q[4]);
/* The rate of the rotation vector r = 2 v for the angular velocity w: w - r x w / 2 + c r x (r x w). */
void wide_rotation_rate(const wide v[3], const wide w[3], wide out[3]);
/* Angles about x, y, z, of the order R = Ri Rj Rk. */
void wide_quat_from_euler(const wide angles[3], nkw_euler_order order, wide q[4]);
/* The arc from a to b as given, angle taken of the directions alone. */
void wide_slerp(const wide a[4], const wide b[4], wide t, wide out[4]);
void wide_mat_mul(const wide *a, const wide *b, wide *out, int n);
/* T R S of the rotation's direction. */
void wide_mat4_from_trs(const nkw_trs *trs, wide out[16]);
/* The 3x3 block, as nine numbers. */
void wide_block(const wide m[16], wide out[9]);
wide wide_determinant(const wide *m, int n);
/* By elimination with partial pivoting; 0 for a singular matrix. n at most 4. */
int wide_inverse(const wide *m, wide *out, int n);

#endif
#endif
