/* SPDX-License-Identifier: CC0-1.0 */
/* Quaternions and their conversions; swing and twist; the mean. */
#include "truth.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>
#include <string.h>

static void product_case(const char *kind, const char *name, const float a[4], const float b[4])
{
    wide p[4], q[4];
    wide_from(a, p, 4);
    wide_from(b, q, 4);
    wide_quat_mul(p, q, p);
    truth_case(kind, name, NULL);
    truth_in("a", a, 4);
    truth_in("b", b, 4);
    truth_out("q", p, 4);
}

static void rotate_case(const char *kind, const char *name, const char *check, const float q[4], const float v[3])
{
    wide w[4], u[3], m[9], r[3];
    wide_from(q, w, 4);
    wide_from(v, u, 3);
    wide_mat3_from_quat(w, m);
    for (int i = 0; i < 3; i++)
        r[i] = m[i] * u[0] + m[3 + i] * u[1] + m[6 + i] * u[2];
    truth_case(kind, name, check);
    truth_scale(truth_size(v, 3));
    truth_in("q", q, 4);
    truth_in("v", v, 3);
    truth_out("rotated", r, 3);
}

static void matrix_case(const char *kind, const char *name, const float q[4], int from_matrix)
{
    wide w[4], m[9];
    float rounded[9];
    wide_from(q, w, 4);
    wide_normalize(w, 4);
    wide_mat3_from_quat(w, m);
    wide_round(m, rounded, 9);
    truth_case(kind, name, NULL);
    if (!from_matrix) {
        truth_in("q", q, 4);
        truth_out("m", m, 9);
        return;
    }
    truth_in("m", rounded, 9);
    truth_out("q", w, 4);
}

static void axis_angle_case(const char *kind, const char *name, const float axis[3], float angle)
{
    wide a[3], q[4], half = (wide)angle / 2;
    wide_from(axis, a, 3);
    wide_normalize(a, 3);
    for (int i = 0; i < 3; i++)
        q[i] = sinq(half) * a[i];
    q[3] = wide_length(a, 3) > 0 ? cosq(half) : 1;
    truth_case(kind, name, NULL);
    truth_in("axis", axis, 3);
    truth_in("angle", &angle, 1);
    truth_out("q", q, 4);
}

static void swing_case(const char *kind, const char *name, const float q[4], const float axis[3])
{
    wide w[4], a[3], twist[4], back[4], swing[4];
    wide_from(q, w, 4);
    wide_from(axis, a, 3);
    wide_normalize(w, 4);
    wide_normalize(a, 3);
    wide along = wide_dot(w, a, 3);
    for (int i = 0; i < 3; i++)
        twist[i] = along * a[i];
    twist[3] = w[3];
    if (wide_length(twist, 4) == 0)
        twist[3] = 1;
    wide_normalize(twist, 4);
    truth_inverse(twist, back);
    wide_quat_mul(w, back, swing);
    truth_case(kind, name, NULL);
    truth_in("q", q, 4);
    truth_in("axis", axis, 3);
    truth_out("swing", swing, 4);
    truth_out("twist", twist, 4);
}

/* The eigenvector by squaring the matrix. */
static void mean_case(const char *kind, const char *name, const char *check, const float *q, const float *weights,
                      int n)
{
    wide m[16] = {0}, mean[4];
    int best = 0;
    for (int k = 0; k < n; k++)
        for (int i = 0; i < 16; i++)
            m[i] += (wide)weights[k] * q[4 * k + i / 4] * q[4 * k + i % 4];
    for (int step = 0; step < 60; step++) {
        wide s[16], trace = m[0] + m[5] + m[10] + m[15];
        wide_scale(m, 1 / trace, 16);
        for (int i = 0; i < 16; i++)
            s[i] = wide_dot(m + i / 4 * 4, m + i % 4 * 4, 4);
        memcpy(m, s, sizeof s);
    }
    for (int i = 1; i < 4; i++)
        best = m[5 * i] > m[5 * best] ? i : best;
    memcpy(mean, m + 4 * best, sizeof mean);
    wide_normalize(mean, 4);
    truth_case(kind, name, check);
    truth_in("rotations", q, 4 * n);
    truth_in("weights", weights, n);
    truth_out("q", mean, 4);
}

static const float identity[4] = {0, 0, 0, 1};
static const float half_x[4] = {1, 0, 0, 0}, half_xy[4] = {0.6f, 0.8f, 0, 0};
static const float x_axis[3] = {1, 0, 0}, z_axis[3] = {0, 0, 1}, no_axis[3] = {0, 0, 0};

static void products(void)
{
    static const char *const lines[] = {"in a 4", "in b 4", "out q 4 near", NULL};
    static const char *const rotated[] = {"in q 4", "in v 3", "out rotated 3 near", NULL};
    static const float i[4] = {1, 0, 0, 0}, j[4] = {0, 1, 0, 0};
    const float v[3] = {1, 2, 3}, far[3] = {1e20f, -2e20f, 3e20f}, odd[3] = {NAN, 0, 0};
    float a[4], b[4];
    truth_group("quat_mul", lines, 4.0, "the sum of four products; rotation by b, then by a");
    for (int k = 0; k < 8; k++) {
        truth_some_turn(a);
        truth_some_turn(b);
        product_case("ordinary", "random", a, b);
    }
    product_case("boundary", "identity", identity, b);
    product_case("boundary", "i-j-is-k", i, j);
    truth_group("quat_rotate", rotated, 24.0, "binary32 near half turns, times `size`, the largest component of v");
    for (int k = 0; k < 8; k++) {
        float u[3];
        put_vec3(u, random_vec3(truth_random(), -4.0f, 4.0f));
        truth_some_turn(a);
        rotate_case("ordinary", "random", NULL, a, u);
    }
    truth_turn(0, 0, 1, 90, a);
    rotate_case("boundary", "a-quarter-turn-about-z-takes-x-to-y", NULL, a, x_axis);
    rotate_case("boundary", "half-turn", NULL, half_x, v);
    rotate_case("boundary", "identity", "exact", identity, v);
    rotate_case("hostile", "far-vector", NULL, a, far);
    rotate_case("hostile", "nan", "nan", a, odd);
}

static void conversions(void)
{
    static const char *const matrix[] = {"in q 4", "out m 9 near", NULL};
    static const char *const back[] = {"in m 9", "out q 4 sign", NULL};
    static const char *const axis[] = {"in axis 3", "in angle 1", "out q 4 near", NULL};
    float q[6][4];
    for (int k = 0; k < 6; k++)
        truth_some_turn(q[k]);
    truth_group("mat3_from_quat", matrix, 6.0, "elements are sums of products of unit quaternions; column by column");
    for (int k = 0; k < 6; k++)
        matrix_case("ordinary", "random", q[k], 0);
    matrix_case("boundary", "half-turn-about-x", half_x, 0);
    matrix_case("boundary", "half-turn-between-axes", half_xy, 0);
    truth_group("quat_from_mat3", back, 8.0, "the elements of the matrix are rounded once");
    for (int k = 0; k < 6; k++)
        matrix_case("ordinary", "random", q[k], 1);
    matrix_case("boundary", "identity", identity, 1);
    matrix_case("boundary", "half-turn-about-x", half_x, 1);
    matrix_case("boundary", "half-turn-between-axes", half_xy, 1);
    truth_turn(1, 1, 1, 120, q[0]);
    matrix_case("boundary", "trace-0", q[0], 1);
    truth_turn(1, 0.001f, 0, 179.99f, q[0]);
    matrix_case("hostile", "nearly-a-half-turn", q[0], 1);
    truth_turn(1, 2, 3, 0.001f, q[0]);
    matrix_case("hostile", "nearly-no-turn", q[0], 1);
    truth_group("quat_from_axis_angle", axis, 4.0, "sine and cosine of half the angle; the axis need not be unit");
    for (int k = 0; k < 6; k++) {
        float a[3];
        put_vec3(a, random_vec3(truth_random(), -4.0f, 4.0f));
        axis_angle_case("ordinary", "random", a, random_between(truth_random(), -6.0f, 6.0f));
    }
    axis_angle_case("boundary", "no-angle", x_axis, 0.0f);
    axis_angle_case("hostile", "zero-axis-is-the-identity", no_axis, 1.0f);
    axis_angle_case("hostile", "a-hundred-turns", z_axis, 628.3f);
}

static void parts(void)
{
    static const char *const lines[] = {"in q 4", "in axis 3", "out swing 4 sign", "out twist 4 sign", NULL};
    float q[4], axis[3];
    truth_group("swing_twist", lines, 6.0, "q = swing twist; both parts unit, of either sign");
    for (int k = 0; k < 8; k++) {
        truth_some_turn(q);
        put_vec3(axis, random_direction(truth_random()));
        swing_case("ordinary", "random", q, axis);
    }
    truth_turn(0, 0, 1, 75, q);
    swing_case("boundary", "twist-alone", q, z_axis);
    swing_case("boundary", "swing-alone", q, x_axis);
    swing_case("hostile", "half-turn-of-the-axis-has-no-twist", half_xy, z_axis);
}

static void means(void)
{
    static const char *const lines[] = {"in rotations n", "in weights n", "out q 4 sign", NULL};
    float q[16], weights[4] = {1, 1, 1, 1};
    truth_group("quat_mean", lines, 8.0, "the eigenvector of the sum of weight q q^T (Markley and others 2007)");
    for (int k = 0; k < 6; k++) {
        float around[4];
        truth_some_turn(around);
        for (int i = 0; i < 4; i++) {
            nkw_quat near = random_near(truth_random(), quat_at(around), 0.6f * random_unit(truth_random()));
            put_quat(q + 4 * i, random_bits(truth_random()) & 1 ? nkw_quat_negate(near) : near);
            weights[i] = random_between(truth_random(), 0.1f, 1.0f);
        }
        mean_case("ordinary", "random-signs", NULL, q, weights, 4);
    }
    weights[0] = weights[1] = 1.0f;
    memcpy(q, identity, sizeof identity);
    truth_turn(0, 1, 0, 90, q + 4);
    mean_case("boundary", "two-of-equal-weight-meet-half-way", NULL, q, weights, 2);
    mean_case("boundary", "one", NULL, q + 4, weights, 1);
    memcpy(q + 4, half_x, sizeof half_x);
    mean_case("hostile", "half-a-turn-apart-any-unit-quaternion", "unit", q, weights, 2);
}

void truth_rotations(const char *folder)
{
    static const char *const about[] = {
        "Quaternions are x y z w, unit to rounding, Hamilton's product: i j = k. Column vectors, right-handed:",
        "a positive angle about z takes x towards y. mul(a, b) rotates by b, then by a. Angles in radians.",
        "Matrices are column by column: m[0..2] is where x goes.",
        "Results marked `sign` are compared up to the sign of the whole quaternion.",
        "swing_twist: the twist is about the axis and applied first; q is swing times twist.",
        NULL,
    };
    truth_open(folder, "rotations", about);
    products();
    conversions();
    parts();
    means();
    truth_close();
}

#else
typedef int truth_rotations_is_skipped;
#endif
