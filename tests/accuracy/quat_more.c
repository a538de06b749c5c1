/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/quat.h> against binary128: swing and twist, the mean. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>
#include <string.h>

#define SAMPLES 20000u
#define SWING   "nkw_quat_swing_twist"
#define TWIST   "nkw_quat_twist_angle"
#define MEAN    "nkw_quat_mean"

/* ---- Swing and twist: q, axis ---- */

static void any_rotation(random_source *r, float *x)
{
    put_quat(x, random_unit_quat(r));
    put_vec3(x + 4, nkw_vec3_scale(random_direction(r), random_log(r, 1e-3f, 1e3f)));
}

/* A swing by nearly half a turn: w and v.a are small. */
static void far_swing(random_source *r, float *x)
{
    nkw_vec3 axis = random_direction(r), across = nkw_vec3_perpendicular(axis);
    nkw_quat half_turn = {across.x, across.y, across.z, 0.0f};
    put_quat(x, random_unit_near(r, half_turn, random_log(r, 1e-6f, 1e-1f)));
    put_vec3(x + 4, axis);
}

static void small_rotation(random_source *r, float *x)
{
    put_quat(x, random_unit_near(r, nkw_quat_identity(), random_log(r, 1e-7f, 1e-2f)));
    put_vec3(x + 4, random_direction(r));
}

/* v.a and w as the parts, q's length and the axis' cancelled. */
static void wide_parts(const float *x, wide q[4], wide axis[3], wide *along)
{
    wide_from(x, q, 4);
    wide_from(x + 4, axis, 3);
    wide_normalize(q, 4);
    wide_normalize(axis, 3);
    *along = wide_dot(q, axis, 3);
}

static double swing_twist_error(const float *x)
{
    wide q[4], axis[3], along, twist[4], inverse[4], swing[4];
    float got[8];
    wide_parts(x, q, axis, &along);
    for (int i = 0; i < 3; i++)
        twist[i] = along * axis[i];
    twist[3] = q[3];
    wide_normalize(twist, 4);
    memcpy(inverse, twist, sizeof twist);
    wide_scale(inverse, -1, 3);
    wide_quat_mul(q, inverse, swing);
    nkw_swing_twist s = nkw_quat_swing_twist(quat_at(x), vec3_at(x + 4));
    put_quat(got, s.swing);
    put_quat(got + 4, s.twist);
    return fmax(wide_error(got, swing, 4), wide_error(got + 4, twist, 4));
}

/* Where v.a cancels to less than 2^-20 |v|, no bound is stated. */
static double twist_angle_error(const float *x)
{
    wide q[4], axis[3], along;
    wide_parts(x, q, axis, &along);
    if (fabsq(along) < (wide)0x1p-20 * wide_length(q, 3))
        return 0.0;
    wide exact = 2 * atan2q(q[3] < 0 ? -along : along, fabsq(q[3]));
    return accuracy_ulps(nkw_quat_twist_angle(quat_at(x), vec3_at(x + 4)), (double)exact);
}

/* ---- The mean: four quaternions, four weights ---- */

static void spread(random_source *r, float *x, float low, float high)
{
    nkw_quat middle = random_unit_quat(r);
    for (int i = 0; i < 4; i++) {
        nkw_quat q = random_unit_near(r, middle, random_log(r, low, high));
        put_quat(x + 4 * i, nkw_quat_scale(q, random_sign(r)));
        x[16 + i] = random_log(r, 1e-3f, 1.0f);
    }
}

static void near_each_other(random_source *r, float *x)
{
    spread(r, x, 1e-6f, 1e-2f);
}

static void within_a_right_angle(random_source *r, float *x)
{
    spread(r, x, 1e-2f, 0.78f);
}

static void anywhere(random_source *r, float *x)
{
    spread(r, x, 0.1f, 3.0f);
}

static void wide_square(wide m[16])
{
    wide s[16], trace = m[0] + m[5] + m[10] + m[15];
    wide_scale(m, 1 / trace, 16);
    for (int i = 0; i < 16; i++)
        s[i] = wide_dot(m + i / 4 * 4, m + i % 4 * 4, 4);
    memcpy(m, s, sizeof s);
}

/* The ratio of the two largest eigenvalues is that of a difference of 2^-20 of the sum, or more. */
static int is_decided(const wide m[16], const wide mean[4])
{
    wide applied[4], trace = m[0] + m[5] + m[10] + m[15], squares = wide_dot(m, m, 16);
    for (int i = 0; i < 4; i++)
        applied[i] = wide_dot(m + 4 * i, mean, 4);
    wide largest = wide_length(applied, 4);
    /* The others are at most the root of the sum of their squares. */
    return largest - sqrtq(squares - largest * largest) > (wide)0x1p-20 * trace;
}

static double mean_error(const float *x)
{
    wide m[16] = {0}, k[16], mean[4];
    nkw_quat q[4];
    float got[4];
    for (int n = 0; n < 4; n++) {
        q[n] = quat_at(x + 4 * n);
        for (int i = 0; i < 16; i++)
            m[i] += (wide)x[16 + n] * x[4 * n + i / 4] * x[4 * n + i % 4];
    }
    memcpy(k, m, sizeof m);
    for (int i = 0; i < 60; i++)
        wide_square(k);
    int best = 0;
    for (int i = 1; i < 4; i++)
        best = k[i * 5] > k[best * 5] ? i : best;
    memcpy(mean, k + 4 * best, sizeof mean);
    wide_normalize(mean, 4);
    put_quat(got, nkw_quat_mean(q, 4, x + 16));
    return is_decided(m, mean) ? wide_error_either(got, mean, 4) : 0.0;
}

static const wide_case cases[] = {
    {SWING, "any", any_rotation, swing_twist_error, 7, WIDE_CHECKED},
    {SWING, "1e-6 .. 0.1 from a half turn of the axis", far_swing, swing_twist_error, 7, WIDE_CHECKED},
    {SWING, "1e-7 .. 1e-2", small_rotation, swing_twist_error, 7, WIDE_CHECKED},
    {TWIST, "any", any_rotation, twist_angle_error, 7, WIDE_CHECKED},
    {TWIST, "1e-6 .. 0.1 from a half turn of the axis", far_swing, twist_angle_error, 7, WIDE_NOTED},
    {TWIST, "1e-7 .. 1e-2", small_rotation, twist_angle_error, 7, WIDE_CHECKED},
    {MEAN, "within 0.01", near_each_other, mean_error, 20, WIDE_CHECKED},
    {MEAN, "within 0.78", within_a_right_angle, mean_error, 20, WIDE_CHECKED},
    {MEAN, "anywhere", anywhere, mean_error, 20, WIDE_CHECKED},
};

void quat_more(accuracy *a)
{
    wide_search(a, cases, sizeof cases / sizeof cases[0], SAMPLES);
}

#else
/* ISO C forbids an empty file. */
typedef int quat_more_is_skipped;
#endif
