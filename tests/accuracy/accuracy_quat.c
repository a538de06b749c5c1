/* SPDX-License-Identifier: MIT */
/* Errors of <nakawari/quat.h> against binary128. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>

#define SAMPLES 40000u
#define FEWER   100000u
#define PI      3.14159265f

/* ---- Products ---- */

static void unit_pair(random_source *r, float *x)
{
    put_quat(x, random_unit_quat(r));
    put_quat(x + 4, random_unit_quat(r));
}

static double mul_error(const float *x)
{
    wide a[4], b[4];
    float got[4];
    wide_from(x, a, 4);
    wide_from(x + 4, b, 4);
    wide_quat_mul(a, b, a);
    put_quat(got, nkw_quat_mul(quat_at(x), quat_at(x + 4)));
    return wide_error(got, a, 4);
}

static void turned_vector(random_source *r, float *x)
{
    put_quat(x, random_unit_quat(r));
    put_vec3(x + 4, random_vec3(r, -1.0f, 1.0f));
}

static void half_turned_vector(random_source *r, float *x)
{
    wide q[4];
    put_vec3(x, random_direction(r));
    x[3] = random_scaled(r, -24, -6);
    wide_from(x, q, 4);
    wide_normalize(q, 4);
    for (int i = 0; i < 4; i++)
        x[i] = (float)q[i];
    put_vec3(x + 4, random_vec3(r, -1.0f, 1.0f));
}

/* The same, unit as the library makes it. */
static void half_turned_by_normalised(random_source *r, float *x)
{
    put_vec3(x, random_direction(r));
    x[3] = random_scaled(r, -24, -6);
    put_quat(x, nkw_quat_normalize(quat_at(x)));
    put_vec3(x + 4, random_vec3(r, -1.0f, 1.0f));
}

/* Against the rotation of q, its length left out; or against that of its conjugate. */
static double off_rotated(nkw_vec3 v, const float *x, int back)
{
    wide q[4], p[3], m[9], exact[3];
    float got[3] = {v.x, v.y, v.z};
    wide_from(x, q, 4);
    wide_from(x + 4, p, 3);
    q[3] = back ? -q[3] : q[3];
    wide_mat3_from_quat(q, m);
    for (int i = 0; i < 3; i++)
        exact[i] = m[i] * p[0] + m[3 + i] * p[1] + m[6 + i] * p[2];
    return wide_error(got, exact, 3);
}

static double rotate_error(const float *x)
{
    return off_rotated(nkw_quat_rotate(quat_at(x), vec3_at(x + 4)), x, 0);
}

static double rotate_inverse_error(const float *x)
{
    return off_rotated(nkw_quat_rotate_inverse(quat_at(x), vec3_at(x + 4)), x, 1);
}

static double identity_rotates_nothing(const float *x)
{
    nkw_vec3 v = nkw_quat_rotate(nkw_quat_identity(), vec3_at(x + 4));
    return v.x == x[4] && v.y == x[5] && v.z == x[6] ? 0.0 : HUGE_VAL;
}

/* ---- Length ---- */

static void any_quat(random_source *r, float *x)
{
    float size = random_log(r, 1e-3f, 1e3f);
    for (int i = 0; i < 4; i++)
        x[i] = random_between(r, -1.0f, 1.0f) * size;
}

static void unit_quat(random_source *r, float *x)
{
    put_quat(x, random_unit_quat(r));
}

static void scattered_quat(random_source *r, float *x)
{
    for (int i = 0; i < 4; i++)
        x[i] = random_scaled(r, -30, 30);
}

static void huge_quat(random_source *r, float *x)
{
    for (int i = 0; i < 4; i++)
        x[i] = random_scaled(r, 100, 126);
}

static void tiny_quat(random_source *r, float *x)
{
    for (int i = 0; i < 4; i++)
        x[i] = random_scaled(r, -149, -100);
}

static void rescued_quat(random_source *r, float *x)
{
    float scale = random_bits(r) >> 63 ? 0x1p-48f : 0x1p48f;
    for (int i = 0; i < 4; i++)
        x[i] = random_scaled(r, -4, 4) * scale;
}

static double length_error(const float *x)
{
    wide q[4];
    wide_from(x, q, 4);
    return accuracy_ulps(nkw_quat_length(quat_at(x)), (double)wide_length(q, 4));
}

static double normalize_error(const float *x)
{
    wide q[4];
    float got[4];
    wide_from(x, q, 4);
    wide_normalize(q, 4);
    put_quat(got, nkw_quat_normalize(quat_at(x)));
    return wide_error(got, q, 4);
}

static double inverse_error(const float *x)
{
    wide q[4];
    float got[4];
    wide_from(x, q, 4);
    wide n2 = wide_dot(q, q, 4);
    wide_scale(q, -1 / n2, 4);
    q[3] = -q[3];
    put_quat(got, nkw_quat_inverse(quat_at(x)));
    return wide_error(got, q, 4);
}

/* ---- Axis and angle ---- */

static void axis_angle(random_source *r, float *x)
{
    put_vec3(x, random_direction(r));
    x[3] = random_between(r, -2.0f * PI, 2.0f * PI);
}

static void small_axis_angle(random_source *r, float *x)
{
    put_vec3(x, random_direction(r));
    x[3] = random_log(r, 1e-8f, 1e-2f);
}

static void many_turns(random_source *r, float *x)
{
    put_vec3(x, random_direction(r));
    x[3] = random_log(r, 10.0f, 1e30f);
}

static void long_axis(random_source *r, float *x)
{
    float size = random_log(r, 1e-38f, 1e38f);
    put_vec3(x, nkw_vec3_scale(random_direction(r), size));
    x[3] = random_between(r, -PI, PI);
}

static double from_axis_angle_error(const float *x)
{
    wide axis[3], q[4];
    float got[4];
    wide_from(x, axis, 3);
    wide_normalize(axis, 3);
    wide_quat_from_axis(axis, x[3], q);
    put_quat(got, nkw_quat_from_axis_angle(vec3_at(x), x[3]));
    return wide_error(got, q, 4);
}

static void small_turn(random_source *r, float *x)
{
    float half = random_log(r, 1e-8f, 1e-2f);
    put_vec3(x, nkw_vec3_scale(random_direction(r), half));
    x[3] = random_sign(r);
}

static void half_turn(random_source *r, float *x)
{
    put_vec3(x, random_direction(r));
    x[3] = random_scaled(r, -30, -6);
}

static double axis_error(const float *x)
{
    wide v[3];
    float got[3];
    wide_from(x, v, 3);
    wide_scale(v, x[3] < 0.0f ? -1 : 1, 3);
    wide_normalize(v, 3);
    put_vec3(got, nkw_axis_angle_from_quat(quat_at(x)).axis);
    return wide_error(got, v, 3);
}

/* The header gives the angle's bound beside the axis's: beyond it the error is infinite. */
static double angle_of_axis_error(const float *x)
{
    wide v[3];
    wide_from(x, v, 3);
    wide exact = 2 * atan2q(wide_length(v, 3), fabsq(x[3]));
    double ulps = accuracy_ulps(nkw_axis_angle_from_quat(quat_at(x)).angle, (double)exact);
    return ulps <= 0.501 ? ulps : HUGE_VAL;
}

static void near_quats(random_source *r, float *x)
{
    nkw_quat a = random_unit_quat(r);
    float angle = random_log(r, 1e-7f, 0.1f);
    put_quat(x, a);
    put_quat(x + 4, nkw_quat_scale(random_unit_near(r, a, angle), random_sign(r)));
}

/* Nearly no turn, of quaternions of different lengths. */
static void tiny_angles(random_source *r, float *x)
{
    for (int k = 0; k < 8; k += 4) {
        for (int i = 0; i < 3; i++)
            x[k + i] = random_scaled(r, -60, -20);
        x[k + 3] = random_between(r, 0.5f, 2.0f);
    }
}

/* About half a turn apart. */
static void far_quats(random_source *r, float *x)
{
    nkw_quat a = random_unit_quat(r);
    put_quat(x, a);
    put_quat(x + 4, random_unit_near(r, a, random_between(r, 1.57f, 1.5716f)));
}

static double angle_error(const float *x)
{
    wide a[4], b[4];
    wide_from(x, a, 4);
    wide_from(x + 4, b, 4);
    wide_scale(a, -1, 3);
    wide_quat_mul(a, b, a);
    wide exact = 2 * atan2q(wide_length(a, 3), fabsq(a[3]));
    return accuracy_ulps(nkw_quat_angle(quat_at(x), quat_at(x + 4)), (double)exact);
}

/* ---- Directions ---- */

static void two_directions(random_source *r, float *x)
{
    put_vec3(x, nkw_vec3_scale(random_direction(r), random_log(r, 1e-3f, 1e3f)));
    put_vec3(x + 3, nkw_vec3_scale(random_direction(r), random_log(r, 1e-3f, 1e3f)));
}

static void directions_apart(random_source *r, float *x, float low, float high)
{
    nkw_vec3 a = random_direction(r);
    nkw_vec3 b = nkw_vec3_add_scaled(a, random_direction(r), random_log(r, low, high));
    put_vec3(x, a);
    put_vec3(x + 3, b);
}

static void near_directions(random_source *r, float *x)
{
    directions_apart(r, x, 1e-7f, 0.1f);
}

static void about_opposite_directions(random_source *r, float *x)
{
    directions_apart(r, x, 1e-5f, 0.1f);
    put_vec3(x + 3, nkw_vec3_negate(vec3_at(x + 3)));
}

static void opposite_directions(random_source *r, float *x)
{
    near_directions(r, x);
    put_vec3(x + 3, nkw_vec3_negate(vec3_at(x + 3)));
}

/* Opposite along an axis but for 2^-40 .. 2^-20 across it: nearer than rounding allows elsewhere. */
static void opposite_on_axis(random_source *r, float *x)
{
    x[0] = random_between(r, 0.5f, 1.0f);
    x[3] = -random_between(r, 0.5f, 1.0f);
    x[1] = random_scaled(r, -40, -20);
    x[2] = random_scaled(r, -40, -20);
    x[4] = random_scaled(r, -40, -20);
    x[5] = random_scaled(r, -40, -20);
}

static double from_vectors_error(const float *x)
{
    wide a[3], b[3], q[4];
    float got[4];
    wide_from(x, a, 3);
    wide_from(x + 3, b, 3);
    wide_normalize(a, 3);
    wide_normalize(b, 3);
    wide_cross(a, b, q);
    /* 1 + a.b = |a + b|^2 / 2 without cancellation. */
    for (int i = 0; i < 3; i++)
        a[i] += b[i];
    q[3] = wide_dot(a, a, 3) / 2;
    wide_normalize(q, 4);
    put_quat(got, nkw_quat_from_vectors(vec3_at(x), vec3_at(x + 3)));
    return wide_error_either(got, q, 4);
}

static double look_error(const float *x)
{
    wide z[3], up[3], m[9], q[4];
    float got[4];
    wide_from(x, z, 3);
    wide_from(x + 3, up, 3);
    wide_scale(z, -1, 3);
    wide_normalize(z, 3);
    wide_normalize(up, 3);
    wide_cross(up, z, m);
    /* Nearer than the header's 2^-30 rad to forward, up may be replaced. */
    if (m[0] * m[0] + m[1] * m[1] + m[2] * m[2] < 0x1p-58)
        return 0.0;
    wide_normalize(m, 3);
    wide_cross(z, m, m + 3);
    for (int i = 0; i < 3; i++)
        m[6 + i] = z[i];
    wide_quat_from_mat3(m, q);
    put_quat(got, nkw_quat_look_rotation(vec3_at(x), vec3_at(x + 3)));
    return wide_error_either(got, q, 4);
}

/* ---- Matrices: 9 elements, then the quaternion that made them ---- */

static void matrix_of(float *x, nkw_quat q)
{
    wide w[4], m[9];
    put_quat(x + 9, q);
    wide_from(x + 9, w, 4);
    wide_mat3_from_quat(w, m);
    wide_round(m, x, 9);
}

static nkw_quat about(nkw_vec3 axis, float half)
{
    float s = nkw_sin(half), c = nkw_cos(half);
    nkw_quat q = {axis.x * s, axis.y * s, axis.z * s, c};
    return q;
}

static void uniform_matrix(random_source *r, float *x)
{
    matrix_of(x, random_unit_quat(r));
}

static void near_half_turn_matrix(random_source *r, float *x)
{
    nkw_vec3 axis = random_direction(r);
    nkw_quat q = {axis.x, axis.y, axis.z, 0.5f * random_log(r, 1e-7f, 1e-2f)};
    matrix_of(x, q);
}

static void half_turn_matrix(random_source *r, float *x)
{
    nkw_vec3 axis = random_direction(r);
    nkw_quat q = {axis.x, axis.y, axis.z, 0.0f};
    matrix_of(x, q);
}

static void small_angle_matrix(random_source *r, float *x)
{
    nkw_vec3 axis = random_direction(r);
    matrix_of(x, about(axis, 0.5f * random_log(r, 1e-7f, 1e-2f)));
}

static void tied_matrix(random_source *r, float *x)
{
    float q[4];
    for (int i = 0; i < 4; i++) {
        float sign = random_sign(r);
        q[i] = sign * (0.5f + random_between(r, -1e-6f, 1e-6f));
    }
    matrix_of(x, quat_at(q));
}

static void traceless_matrix(random_source *r, float *x)
{
    nkw_vec3 axis = random_direction(r);
    matrix_of(x, about(axis, PI / 3.0f + random_between(r, -5e-4f, 5e-4f)));
}

static void noisy_matrix(random_source *r, float *x)
{
    uniform_matrix(r, x);
    for (int i = 0; i < 9; i++)
        x[i] += random_between(r, -1e-6f, 1e-6f);
}

static void drifted_matrix(random_source *r, float *x)
{
    uniform_matrix(r, x);
    for (int i = 0; i < 9; i++)
        x[i] += random_between(r, -1e-3f, 1e-3f);
}

static void axis_half_turn_matrix(random_source *r, float *x)
{
    unsigned k = (unsigned)(random_bits(r) % 3);
    nkw_vec3 axis = {k == 0 ? 1.0f : 0.0f, k == 1 ? 1.0f : 0.0f, k == 2 ? 1.0f : 0.0f};
    matrix_of(x, about(axis, PI / 2.0f + random_between(r, -5e-5f, 5e-5f)));
}

static nkw_quat from_matrix(const float *x)
{
    nkw_mat3 m;
    for (int i = 0; i < 9; i++)
        m.m[i] = x[i];
    return nkw_quat_from_mat3(&m);
}

static double off_nearest(nkw_quat q, const float *x)
{
    wide m[9], exact[4];
    float got[4] = {q.x, q.y, q.z, q.w};
    wide_from(x, m, 9);
    wide_quat_from_mat3(m, exact);
    return wide_error_either(got, exact, 4);
}

static double nearest_error(const float *x)
{
    return off_nearest(from_matrix(x), x);
}

static double generating_error(const float *x)
{
    wide q[4];
    float got[4];
    wide_from(x + 9, q, 4);
    wide_normalize(q, 4);
    put_quat(got, from_matrix(x));
    return wide_error_either(got, q, 4);
}

static double unit_error(const float *x)
{
    float got[4];
    put_quat(got, from_matrix(x));
    return wide_unit_error(got, 4);
}

/* q to a matrix and back. */
static double round_trip_error(const float *x)
{
    nkw_mat3 m = nkw_mat3_from_quat(quat_at(x));
    wide q[4];
    float got[4];
    wide_from(x, q, 4);
    put_quat(got, nkw_quat_from_mat3(&m));
    return wide_error_either(got, q, 4);
}

/* ---- Scalar product ---- */

static void any_pair(random_source *r, float *x)
{
    any_quat(r, x);
    any_quat(r, x + 4);
}

static void scattered_pair(random_source *r, float *x)
{
    scattered_quat(r, x);
    scattered_quat(r, x + 4);
}

/* 1e-7 .. 0.1 from a quarter turn of the 3-sphere. */
static void crossed_pair(random_source *r, float *x)
{
    nkw_vec3 axis = random_direction(r);
    nkw_quat a = random_unit_quat(r), half = {axis.x, axis.y, axis.z, 0.0f};
    put_quat(x, a);
    put_quat(x + 4, random_unit_near(r, nkw_quat_mul(a, half), random_log(r, 1e-7f, 0.1f)));
}

static double dot_error(const float *x)
{
    wide a[4], b[4];
    wide_from(x, a, 4);
    wide_from(x + 4, b, 4);
    wide exact = wide_dot(a, b, 4);
    float got = nkw_quat_dot(quat_at(x), quat_at(x + 4));
    return wide_error_of(&got, &exact, 1, wide_length(a, 4) * wide_length(b, 4));
}

#define BACK "nkw_quat_rotate_inverse"

static const wide_case products[] = {
    {"nkw_quat_dot", "unit", unit_pair, dot_error, 8, WIDE_CHECKED},
    {"nkw_quat_dot", "1e-3 .. 1e3", any_pair, dot_error, 8, WIDE_CHECKED},
    {"nkw_quat_dot", "2^-30 .. 2^30 mixed", scattered_pair, dot_error, 8, WIDE_CHECKED},
    {"nkw_quat_dot", "1e-7 .. 0.1 from a right angle", crossed_pair, dot_error, 8, WIDE_CHECKED},
    {BACK, "unit", turned_vector, rotate_inverse_error, 7, WIDE_CHECKED},
    {BACK, "near half turns", half_turned_vector, rotate_inverse_error, 7, WIDE_CHECKED},
    {BACK, "near half turns, q normalised", half_turned_by_normalised, rotate_inverse_error, 7, WIDE_CHECKED},
};

static const wide_case cases[] = {
    {"nkw_quat_mul", "unit", unit_pair, mul_error, 8, WIDE_UNITS},
    {"nkw_quat_rotate", "unit", turned_vector, rotate_error, 7, WIDE_UNITS},
    {"nkw_quat_rotate", "near half turns", half_turned_vector, rotate_error, 7, WIDE_UNITS},
    {"nkw_quat_rotate", "near half turns, q normalised", half_turned_by_normalised, rotate_error, 7, WIDE_CHECKED},
    {"nkw_quat_rotate", "identity, bit for bit", turned_vector, identity_rotates_nothing, 7, WIDE_CHECKED},
    {"nkw_quat_length", "1e-3 .. 1e3", any_quat, length_error, 4, WIDE_CHECKED},
    {"nkw_quat_length", "unit", unit_quat, length_error, 4, WIDE_CHECKED},
    {"nkw_quat_length", "2^100 .. 2^126", huge_quat, length_error, 4, WIDE_CHECKED},
    {"nkw_quat_length", "2^-149 .. 2^-100", tiny_quat, length_error, 4, WIDE_CHECKED},
    {"nkw_quat_normalize", "1e-3 .. 1e3", any_quat, normalize_error, 4, WIDE_CHECKED},
    {"nkw_quat_normalize", "unit", unit_quat, normalize_error, 4, WIDE_CHECKED},
    {"nkw_quat_normalize", "2^-30 .. 2^30 mixed", scattered_quat, normalize_error, 4, WIDE_CHECKED},
    {"nkw_quat_normalize", "2^-52 .. 2^52", rescued_quat, normalize_error, 4, WIDE_CHECKED},
    {"nkw_quat_normalize", "2^100 .. 2^126", huge_quat, normalize_error, 4, WIDE_CHECKED},
    {"nkw_quat_normalize", "2^-149 .. 2^-100", tiny_quat, normalize_error, 4, WIDE_CHECKED},
    {"nkw_quat_inverse", "1e-3 .. 1e3", any_quat, inverse_error, 4, WIDE_CHECKED},
    {"nkw_quat_inverse", "unit", unit_quat, inverse_error, 4, WIDE_CHECKED},
    {"nkw_quat_from_axis_angle", "+-2 pi", axis_angle, from_axis_angle_error, 4, WIDE_CHECKED},
    {"nkw_quat_from_axis_angle", "1e-8 .. 1e-2", small_axis_angle, from_axis_angle_error, 4, WIDE_CHECKED},
    {"nkw_quat_from_axis_angle", "10 .. 1e30", many_turns, from_axis_angle_error, 4, WIDE_CHECKED},
    {"nkw_quat_from_axis_angle", "axis 1e-38 .. 1e38", long_axis, from_axis_angle_error, 4, WIDE_CHECKED},
    {"nkw_axis_angle_from_quat", "axis, unit", unit_quat, axis_error, 4, WIDE_CHECKED},
    {"nkw_axis_angle_from_quat", "axis, half angle 1e-8 .. 1e-2", small_turn, axis_error, 4, WIDE_CHECKED},
    {"nkw_axis_angle_from_quat", "axis, near half turns", half_turn, axis_error, 4, WIDE_CHECKED},
    {"nkw_axis_angle_from_quat", "angle in ULP, unit", unit_quat, angle_of_axis_error, 4, WIDE_CHECKED},
    {"nkw_axis_angle_from_quat", "angle in ULP, 1e-8 .. 1e-2", small_turn, angle_of_axis_error, 4, WIDE_CHECKED},
    {"nkw_axis_angle_from_quat", "angle in ULP, near half turns", half_turn, angle_of_axis_error, 4, WIDE_CHECKED},
    {"nkw_quat_from_vectors", "any", two_directions, from_vectors_error, 6, WIDE_CHECKED},
    {"nkw_quat_from_vectors", "1e-7 .. 0.1 apart", near_directions, from_vectors_error, 6, WIDE_CHECKED},
    {"nkw_quat_from_vectors", "1e-5 .. 0.1 from opposite", about_opposite_directions, from_vectors_error, 6,
     WIDE_CHECKED},
    {"nkw_quat_from_vectors", "1e-7 .. 0.1 from opposite", opposite_directions, from_vectors_error, 6, WIDE_CHECKED},
    {"nkw_quat_from_vectors", "2^-40 .. 2^-20 from opposite", opposite_on_axis, from_vectors_error, 6, WIDE_CHECKED},
    {"nkw_quat_look_rotation", "any", two_directions, look_error, 6, WIDE_CHECKED},
    {"nkw_quat_look_rotation", "up 1e-7 .. 0.1 from forward", near_directions, look_error, 6, WIDE_CHECKED},
    {"nkw_quat_look_rotation", "up 1e-7 .. 0.1 from backward", opposite_directions, look_error, 6, WIDE_CHECKED},
    {"nkw_quat_from_mat3", "uniform", uniform_matrix, nearest_error, 13, WIDE_CHECKED},
    {"nkw_quat_from_mat3", "1e-7 .. 1e-2 from half turns", near_half_turn_matrix, nearest_error, 13, WIDE_CHECKED},
    {"nkw_quat_from_mat3", "half turns", half_turn_matrix, nearest_error, 13, WIDE_CHECKED},
    {"nkw_quat_from_mat3", "angles 1e-7 .. 1e-2", small_angle_matrix, nearest_error, 13, WIDE_CHECKED},
    {"nkw_quat_from_mat3", "ties of all four components", tied_matrix, nearest_error, 13, WIDE_CHECKED},
    {"nkw_quat_from_mat3", "trace 0", traceless_matrix, nearest_error, 13, WIDE_CHECKED},
    {"nkw_quat_from_mat3", "noise 1e-6", noisy_matrix, nearest_error, 13, WIDE_CHECKED},
    {"nkw_quat_from_mat3", "noise 1e-3", drifted_matrix, nearest_error, 13, WIDE_CHECKED},
    {"nkw_quat_from_mat3", "half turns about axes", axis_half_turn_matrix, nearest_error, 13, WIDE_CHECKED},
    {"nkw_quat_from_mat3", "uniform, generating quaternion", uniform_matrix, generating_error, 13, WIDE_NOTED},
    {"nkw_quat_from_mat3", "uniform, length - 1", uniform_matrix, unit_error, 13, WIDE_NOTED},
    {"nkw_quat_from_mat3", "round trip", unit_quat, round_trip_error, 4, WIDE_NOTED},
    {"nkw_quat_angle", "unit", unit_pair, angle_error, 8, WIDE_CHECKED},
    {"nkw_quat_angle", "1e-7 .. 0.1 apart", near_quats, angle_error, 8, WIDE_CHECKED},
    {"nkw_quat_angle", "2^-60 .. 2^-20, not unit", tiny_angles, angle_error, 8, WIDE_CHECKED},
    {"nkw_quat_angle", "about half a turn", far_quats, angle_error, 8, WIDE_CHECKED},
};

int main(int argc, char **argv)
{
    accuracy a = accuracy_begin("quat.h", argc, argv);
    wide_search(&a, cases, sizeof cases / sizeof cases[0], SAMPLES);
    wide_search(&a, products, sizeof products / sizeof products[0], FEWER);
    quat_more(&a);
    return accuracy_end(&a);
}

#else
WIDE_SKIPPED
#endif
