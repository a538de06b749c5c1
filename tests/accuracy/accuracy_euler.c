/* SPDX-License-Identifier: MIT */
/*
 * Errors of <nakawari/euler.h> against binary128.
 *
 * Angles are judged by the rotation built again from them, exactly: 2 sin(phi/2) of the turn phi that it is off,
 * which for small phi is phi. All six orders take turns. Near the pole single angles have no meaning.
 */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>
#include <string.h>

#define SAMPLES 25000u
#define PI      0x1.921fb6p1f

/* ---- Samples: three angles and the order; for matrices and quaternions those follow from x + 4 ---- */

static void uniform_angles(random_source *r, float *x)
{
    for (int i = 0; i < 3; i++)
        x[i] = random_between(r, -PI, PI);
    x[3] = (float)(random_bits(r) % 6);
}

/* The axis of the middle angle. */
static int middle_of(const float *x)
{
    static const int middle[6] = {1, 2, 0, 2, 0, 1};
    return middle[(int)x[3]];
}

static void below_80_degrees(random_source *r, float *x)
{
    uniform_angles(r, x);
    x[middle_of(x)] = random_between(r, -1.396f, 1.396f);
}

static void near_pole(random_source *r, float *x, float low, float high)
{
    uniform_angles(r, x);
    float sign = random_sign(r), delta = random_log(r, low, high);
    x[middle_of(x)] = sign * (PI / 2.0f - delta);
}

static void pole_3(random_source *r, float *x)
{
    near_pole(r, x, 1e-3f, 1e-1f);
}

static void pole_5(random_source *r, float *x)
{
    near_pole(r, x, 1e-5f, 1e-3f);
}

static void pole_8(random_source *r, float *x)
{
    near_pole(r, x, 1e-8f, 1e-5f);
}

static void at_pole(random_source *r, float *x)
{
    uniform_angles(r, x);
    x[middle_of(x)] = random_sign(r) * (PI / 2.0f);
}

static void small_angles(random_source *r, float *x)
{
    uniform_angles(r, x);
    for (int i = 0; i < 3; i++) {
        float sign = random_sign(r);
        x[i] = sign * random_log(r, 1e-6f, 1e-2f);
    }
}

static void many_turns(random_source *r, float *x)
{
    uniform_angles(r, x);
    for (int i = 0; i < 3; i++) {
        float sign = random_sign(r);
        x[i] = sign * random_log(r, 10.0f, 1e30f);
    }
}

/* The largest angles that are computed in binary32. */
static void hundreds_of_turns(random_source *r, float *x)
{
    uniform_angles(r, x);
    for (int i = 0; i < 3; i++)
        x[i] = random_between(r, -4700.0f, 4700.0f);
}

static void exact_quat(const float *x, wide q[4])
{
    wide angles[3];
    wide_from(x, angles, 3);
    wide_quat_from_euler(angles, (nkw_euler_order)x[3], q);
}

/* The double sine and cosine serve to make inputs; only their roundings to float are inputs. */
static void as_quat(float *x)
{
    static const int axes[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    wide q[4] = {0, 0, 0, 1};
    for (int i = 0; i < 3; i++) {
        int axis = axes[(int)x[3]][i];
        wide turn[4] = {0, 0, 0, cos(0.5 * (double)x[axis])};
        turn[axis] = sin(0.5 * (double)x[axis]);
        wide_quat_mul(q, turn, q);
    }
    wide_round(q, x + 4, 4);
}

/* The matrix of that quaternion before its rounding would need it again: from the rounded one, rounded. */
static void as_matrix(float *x)
{
    double m[9];
    as_quat(x);
    double_mat3_from_quat(quat_at(x + 4), m);
    for (int i = 0; i < 9; i++)
        x[4 + i] = (float)m[i];
}

static void with_noise(random_source *r, float *x)
{
    as_matrix(x);
    for (int i = 4; i < 13; i++)
        x[i] += random_between(r, -0x1p-24f, 0x1p-24f);
}

#define REGION(name)                                                                                                   \
    static void name##_quat(random_source *r, float *x)                                                                \
    {                                                                                                                  \
        name(r, x);                                                                                                    \
        as_quat(x);                                                                                                    \
    }                                                                                                                  \
    static void name##_matrix(random_source *r, float *x)                                                              \
    {                                                                                                                  \
        name(r, x);                                                                                                    \
        as_matrix(x);                                                                                                  \
    }                                                                                                                  \
    static void name##_noise(random_source *r, float *x)                                                               \
    {                                                                                                                  \
        name(r, x);                                                                                                    \
        with_noise(r, x);                                                                                              \
    }

REGION(below_80_degrees)
REGION(pole_3)
REGION(pole_5)
REGION(pole_8)
REGION(at_pole)
REGION(small_angles)

/* Any unit quaternion and any rounded rotation, poles of every order included by chance only. */
static void uniform_quat(random_source *r, float *x)
{
    uniform_angles(r, x);
    put_quat(x + 4, random_unit_quat(r));
}

/* ---- From angles ---- */

static double quat_error(const float *x)
{
    wide q[4];
    float got[4];
    exact_quat(x, q);
    put_quat(got, nkw_quat_from_euler(vec3_at(x), (nkw_euler_order)x[3]));
    return wide_error(got, q, 4);
}

static double mat3_error(const float *x)
{
    wide q[4], m[9];
    nkw_mat3 got = nkw_mat3_from_euler(vec3_at(x), (nkw_euler_order)x[3]);
    exact_quat(x, q);
    wide_mat3_from_quat(q, m);
    return wide_error(got.m, m, 9);
}

/* ---- To angles ---- */

static void rebuilt(nkw_vec3 angles, float order, wide q[4])
{
    float x[4] = {angles.x, angles.y, angles.z, order};
    exact_quat(x, q);
}

static nkw_vec3 angles_of_matrix(const float *x)
{
    nkw_mat3 m;
    memcpy(m.m, x + 4, sizeof m.m);
    return nkw_euler_from_mat3(&m, (nkw_euler_order)x[3]);
}

static double from_quat_error(const float *x)
{
    wide got[4], q[4];
    rebuilt(nkw_euler_from_quat(quat_at(x + 4), (nkw_euler_order)x[3]), x[3], got);
    wide_from(x + 4, q, 4);
    return wide_turn(got, q);
}

static double from_mat3_error(const float *x)
{
    wide got[4], m[9], q[4];
    rebuilt(angles_of_matrix(x), x[3], got);
    wide_from(x + 4, m, 9);
    wide_quat_from_mat3(m, q);
    return wide_turn(got, q);
}

/* |R - M| / sqrt 2 of the matrix as it is: what is no rotation in it counts as error too. */
static double from_mat3_as_given_error(const float *x)
{
    wide got[4], m[9];
    rebuilt(angles_of_matrix(x), x[3], got);
    wide_mat3_from_quat(got, m);
    return wide_error_of(x + 4, m, 9, sqrt(2.0));
}

#define TO_QUAT "nkw_euler_from_quat"
#define TO_MAT3 "nkw_euler_from_mat3"

/* ---- Moved by whole turns: angles and reference, three each ---- */

static void angles_and_reference(random_source *r, float *x, float size)
{
    for (int i = 0; i < 6; i++)
        x[i] = random_between(r, -size, size);
}

static void few_turns(random_source *r, float *x)
{
    angles_and_reference(r, x, 20.0f);
}

static void hundred_radians(random_source *r, float *x)
{
    angles_and_reference(r, x, 100.0f);
}

static void far_reference(random_source *r, float *x)
{
    few_turns(r, x);
    for (int i = 3; i < 6; i++)
        x[i] *= 1e3f;
}

/* Nearly whole turns, and the reference near 0: nearly all of the angle goes. */
static void whole_turns(random_source *r, float *x)
{
    for (int i = 0; i < 3; i++) {
        float turns = (float)(int)random_between(r, 1.0f, 17.0f), sign = random_sign(r);
        x[i] = sign * (float)(6.283185307179586 * (double)turns) * (1.0f + random_scaled(r, -24, -8));
        x[3 + i] = random_between(r, -1.0f, 1.0f);
    }
}

/* Of the two angles about half a turn away, the nearer one. */
static double unwrap_error(const float *x)
{
    float got[3];
    double worst = 0.0;
    put_vec3(got, nkw_euler_unwrap(vec3_at(x), vec3_at(x + 3)));
    for (int i = 0; i < 3; i++) {
        wide turns = (wide)rint((double)(((wide)x[i] - got[i]) / (2 * wide_pi())));
        wide exact = (wide)x[i] - turns * 2 * wide_pi();
        int within = fabs((double)(exact - x[3 + i])) <= (double)wide_pi() + 1e-6;
        worst = fmax(worst, within ? accuracy_ulps(got[i], (double)exact) : HUGE_VAL);
    }
    return worst;
}

#define UNWRAP "nkw_euler_unwrap"

static const wide_case unwraps[] = {
    {UNWRAP, "both to 20 rad", few_turns, unwrap_error, 6, WIDE_CHECKED},
    {UNWRAP, "both to 100 rad", hundred_radians, unwrap_error, 6, WIDE_CHECKED},
    {UNWRAP, "reference to 20000 rad", far_reference, unwrap_error, 6, WIDE_CHECKED},
    {UNWRAP, "nearly whole turns, result near 0", whole_turns, unwrap_error, 6, WIDE_NOTED},
};

/* Each angle in ULP: half a turn less, towards 0; the middle one negated too. */
static double alternate_error(const float *x)
{
    nkw_vec3 got = nkw_euler_alternate(vec3_at(x), (nkw_euler_order)(int)x[3]);
    static const int middle[6] = {1, 2, 0, 2, 0, 1};
    const float g[3] = {got.x, got.y, got.z};
    double worst = 0.0;
    for (int i = 0; i < 3; i++) {
        wide exact = (wide)x[i] - (x[i] < 0.0f ? -wide_pi() : wide_pi());
        exact = i == middle[(int)x[3]] ? -exact : exact;
        worst = fmax(worst, accuracy_ulps(g[i], (double)exact));
    }
    return worst;
}

/* ---- Euler angles: a, b, t, what is unwrapped ---- */

static void two_angles(random_source *r, float *x, float size)
{
    for (int i = 0; i < 6; i++)
        x[i] = random_between(r, -size, size);
    x[6] = random_unit(r);
    x[7] = (float)(random_bits(r) % 3);
}

static void one_turn(random_source *r, float *x)
{
    two_angles(r, x, PI);
}

static void some_turns(random_source *r, float *x)
{
    two_angles(r, x, 20.0f);
}

static void near_angles(random_source *r, float *x)
{
    two_angles(r, x, PI);
    for (int i = 0; i < 3; i++)
        x[3 + i] = x[i] + random_scaled(r, -24, -4);
}

static void fine_angles(random_source *r, float *x)
{
    two_angles(r, x, PI);
    x[6] = fabsf(random_scaled(r, -30, 0));
}

/* Of the larger of a as moved and b, each angle for itself. */
static double euler_lerp_error(const float *x)
{
    float got[3];
    double worst = 0.0;
    put_vec3(got, nkw_euler_lerp(vec3_at(x), vec3_at(x + 3), x[6], (nkw_unwrap)x[7]));
    for (int i = 0; i < 3; i++) {
        wide a = x[i], b = x[3 + i];
        int moves = x[7] == (float)NKW_UNWRAP_ALL || (x[7] == (float)NKW_UNWRAP_YAW && i == 1);
        if (moves && fabsq(b - a) > wide_pi())
            a += (a < b ? 2 : -2) * wide_pi();
        wide exact = (1 - (wide)x[6]) * a + (wide)x[6] * b;
        worst = fmax(worst, wide_error_of(got + i, &exact, 1, fmaxq(fabsq(a), fabsq(b))));
    }
    return worst;
}

#define ANGLES "nkw_euler_lerp"

static const wide_case lerps[] = {
    {ANGLES, "+-pi", one_turn, euler_lerp_error, 8, WIDE_CHECKED},
    {ANGLES, "+-pi, t in 2^-30 .. 1", fine_angles, euler_lerp_error, 8, WIDE_CHECKED},
    {ANGLES, "+-20", some_turns, euler_lerp_error, 8, WIDE_CHECKED},
    {ANGLES, "nearly equal", near_angles, euler_lerp_error, 8, WIDE_CHECKED},
};

static const wide_case cases[] = {
    {"nkw_euler_alternate", "+-pi", uniform_angles, alternate_error, 4, WIDE_CHECKED},
    {"nkw_euler_alternate", "1e-6 .. 1e-2", small_angles, alternate_error, 4, WIDE_CHECKED},
    {"nkw_quat_from_euler", "+-pi", uniform_angles, quat_error, 4, WIDE_CHECKED},
    {"nkw_quat_from_euler", "1e-6 .. 1e-2", small_angles, quat_error, 4, WIDE_CHECKED},
    {"nkw_quat_from_euler", "10 .. 1e30", many_turns, quat_error, 4, WIDE_CHECKED},
    {"nkw_quat_from_euler", "+-4700", hundreds_of_turns, quat_error, 4, WIDE_CHECKED},
    {"nkw_mat3_from_euler", "+-pi", uniform_angles, mat3_error, 4, WIDE_CHECKED},
    {"nkw_mat3_from_euler", "1e-6 .. 1e-2", small_angles, mat3_error, 4, WIDE_CHECKED},
    {"nkw_mat3_from_euler", "+-4700", hundreds_of_turns, mat3_error, 4, WIDE_CHECKED},
    {"nkw_mat3_from_euler", "10 .. 1e30", many_turns, mat3_error, 4, WIDE_CHECKED},
    {TO_QUAT, "uniform rotations", uniform_quat, from_quat_error, 8, WIDE_CHECKED},
    {TO_QUAT, "middle below 80 degrees", below_80_degrees_quat, from_quat_error, 8, WIDE_CHECKED},
    {TO_QUAT, "1e-3 .. 1e-1 from the pole", pole_3_quat, from_quat_error, 8, WIDE_CHECKED},
    {TO_QUAT, "1e-5 .. 1e-3 from the pole", pole_5_quat, from_quat_error, 8, WIDE_CHECKED},
    {TO_QUAT, "1e-8 .. 1e-5 from the pole", pole_8_quat, from_quat_error, 8, WIDE_CHECKED},
    {TO_QUAT, "at the pole", at_pole_quat, from_quat_error, 8, WIDE_CHECKED},
    {TO_QUAT, "1e-6 .. 1e-2", small_angles_quat, from_quat_error, 8, WIDE_CHECKED},
    {TO_MAT3, "middle below 80 degrees", below_80_degrees_matrix, from_mat3_error, 13, WIDE_CHECKED},
    {TO_MAT3, "at the pole", at_pole_matrix, from_mat3_error, 13, WIDE_CHECKED},
    {TO_MAT3, "1e-8 .. 1e-5 from the pole, noise 1 u", pole_8_noise, from_mat3_error, 13, WIDE_CHECKED},
    {TO_MAT3, "at the pole, noise 1 u", at_pole_noise, from_mat3_error, 13, WIDE_CHECKED},
    {TO_MAT3, "1e-6 .. 1e-2, noise 1 u", small_angles_noise, from_mat3_error, 13, WIDE_CHECKED},
    {TO_MAT3, "as given: below 80 degrees", below_80_degrees_matrix, from_mat3_as_given_error, 13, WIDE_NOTED},
    {TO_MAT3, "as given: 1e-3 .. 1e-1", pole_3_matrix, from_mat3_as_given_error, 13, WIDE_NOTED},
    {TO_MAT3, "as given: 1e-5 .. 1e-3", pole_5_matrix, from_mat3_as_given_error, 13, WIDE_NOTED},
    {TO_MAT3, "as given: 1e-8 .. 1e-5", pole_8_matrix, from_mat3_as_given_error, 13, WIDE_NOTED},
    {TO_MAT3, "as given: at the pole", at_pole_matrix, from_mat3_as_given_error, 13, WIDE_NOTED},
    {TO_MAT3, "as given: 1e-6 .. 1e-2", small_angles_matrix, from_mat3_as_given_error, 13, WIDE_NOTED},
    {TO_MAT3, "as given, noise: below 80 degrees", below_80_degrees_noise, from_mat3_as_given_error, 13, WIDE_NOTED},
    {TO_MAT3, "as given, noise: 1e-3 .. 1e-1", pole_3_noise, from_mat3_as_given_error, 13, WIDE_NOTED},
    {TO_MAT3, "as given, noise: 1e-5 .. 1e-3", pole_5_noise, from_mat3_as_given_error, 13, WIDE_NOTED},
    {TO_MAT3, "as given, noise: 1e-8 .. 1e-5", pole_8_noise, from_mat3_as_given_error, 13, WIDE_NOTED},
    {TO_MAT3, "as given, noise: at the pole", at_pole_noise, from_mat3_as_given_error, 13, WIDE_NOTED},
    {TO_MAT3, "as given, noise: 1e-6 .. 1e-2", small_angles_noise, from_mat3_as_given_error, 13, WIDE_NOTED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("euler.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    wide_search(&a, unwraps, sizeof unwraps / sizeof unwraps[0], SAMPLES);
    wide_search(&a, lerps, sizeof lerps / sizeof lerps[0], SAMPLES);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
