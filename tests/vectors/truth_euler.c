/* SPDX-License-Identifier: CC0-1.0 */
/* Euler angles of six orders, from and to rotations; the nearer of two triples. */
#include "truth.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>
#include <string.h>

static const char *const names[6] = {"XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"};
static const int axes[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

/* R = Ri Rj Rk, quaternion and matrix, from the product of three turns about axes. */
static void turn_of(const float angles[3], int order, wide q[4], wide m[9])
{
    wide identity[4] = {0, 0, 0, 1};
    memcpy(q, identity, sizeof identity);
    for (int i = 0; i < 3; i++) {
        wide v[3] = {0, 0, 0};
        v[axes[order][i]] = (wide)angles[axes[order][i]] / 2;
        truth_append(q, v, 1);
    }
    wide_mat3_from_quat(q, m);
}

static void from_angles(const char *kind, const char *name, const float angles[3], int order, int matrix)
{
    wide q[4], m[9];
    float o = (float)order;
    turn_of(angles, order, q, m);
    truth_case(kind, name, NULL);
    truth_in("angles", angles, 3);
    truth_in("order", &o, 1);
    if (matrix)
        truth_out("m", m, 9);
    else
        truth_out("q", q, 4);
}

static void to_angles(const char *kind, const char *name, const float angles[3], int order)
{
    wide q[4], m[9], exact[3], w[4];
    float rounded[4], o = (float)order, e = axes[order][1] == (axes[order][0] + 1) % 3 ? 1.0f : -1.0f;
    int i = axes[order][0], j = axes[order][1], k = axes[order][2];
    turn_of(angles, order, q, m);
    wide_round(q, rounded, 4);
    wide_from(rounded, w, 4);
    wide_normalize(w, 4);
    wide_mat3_from_quat(w, m);
    /* Element (row i, column k) is e sin j. */
    exact[j] = asinq(e * m[3 * k + i]);
    exact[i] = atan2q(-e * m[3 * k + j], m[3 * k + k]);
    exact[k] = atan2q(-e * m[3 * j + i], m[3 * i + i]);
    truth_case(kind, name, NULL);
    truth_scale(8.0 / (double)cosq(exact[j]));
    truth_in("q", rounded, 4);
    truth_in("order", &o, 1);
    truth_out("angles", exact, 3);
}

static void unwrapped(const char *kind, const char *name, const float angles[3], const float reference[3], int order)
{
    wide best[3] = {0}, least = HUGE_VALQ, pi = wide_pi();
    float o = (float)order;
    for (int triple = 0; triple < 2; triple++) {
        wide x[3], sum = 0;
        for (int i = 0; i < 3; i++) {
            wide a = angles[i];
            x[i] = !triple ? a : i == axes[order][1] ? pi - a : a + pi;
            x[i] -= 2 * pi * rintq((x[i] - reference[i]) / (2 * pi));
            sum += (x[i] - reference[i]) * (x[i] - reference[i]);
        }
        if (sum < least)
            memcpy(best, x, sizeof x);
        least = sum < least ? sum : least;
    }
    truth_case(kind, name, NULL);
    truth_scale(truth_size(reference, 3));
    truth_in("angles", angles, 3);
    truth_in("reference", reference, 3);
    truth_in("order", &o, 1);
    truth_out("nearest", best, 3);
}

static void angles_groups(void)
{
    static const char *const quat[] = {"in angles 3", "in order 1", "out q 4 sign", NULL};
    static const char *const matrix[] = {"in angles 3", "in order 1", "out m 9 near", NULL};
    const float none[3] = {0, 0, 0}, pole[3] = {0x1.921fb6p0f, 0x1.921fb6p0f, 0x1.921fb6p0f}, far[3] = {100, -200, 300};
    for (int m = 0; m < 2; m++) {
        truth_group(m ? "mat3_from_euler" : "quat_from_euler", m ? matrix : quat, 8.0, "products of sines and cosines");
        for (int order = 0; order < 6; order++) {
            float a[3];
            for (int n = 0; n < 2; n++) {
                put_vec3(a, random_vec3(truth_random(), -3.0f, 3.0f));
                from_angles("ordinary", names[order], a, order, m);
            }
            from_angles("boundary", "all-at-a-quarter-turn", pole, order, m);
        }
        from_angles("boundary", "no-angles", none, 0, m);
        from_angles("hostile", "angles-of-many-turns", far, 2, m);
    }
}

static void back_group(void)
{
    static const char *const lines[] = {"in q 4", "in order 1", "out angles 3 near", NULL};
    truth_group("euler_from_quat", lines, 4.0,
                "angles in -pi..pi, the middle one in -pi/2..pi/2; `size` grows near a pole");
    for (int order = 0; order < 6; order++) {
        float a[3];
        for (int n = 0; n < 3; n++) {
            put_vec3(a, random_vec3(truth_random(), -3.0f, 3.0f));
            a[axes[order][1]] = random_between(truth_random(), -1.4f, 1.4f);
            to_angles("ordinary", names[order], a, order);
        }
        a[axes[order][1]] = 1.55f;
        to_angles("hostile", "one-degree-from-the-pole", a, order);
    }
}

static void nearest_group(void)
{
    static const char *const lines[] = {"in angles 3", "in reference 3", "in order 1", "out nearest 3 near", NULL};
    const float same[3] = {1, 2, 3}, jumped[3] = {3.04f, 0.2f, -3.04f}, before[3] = {-0.1f, 2.94f, 0.1f};
    truth_group("euler_nearest", lines, 4.0,
                "of the two triples of a rotation, each plus whole turns, the one nearest");
    for (int n = 0; n < 12; n++) {
        float a[3], r[3];
        put_vec3(a, random_vec3(truth_random(), -3.0f, 3.0f));
        put_vec3(r, random_vec3(truth_random(), -12.0f, 12.0f));
        unwrapped("ordinary", names[n % 6], a, r, n % 6);
    }
    unwrapped("boundary", "already-there", same, same, 0);
    unwrapped("hostile", "across-the-pole", jumped, before, 0);
}

void truth_euler(const char *folder)
{
    static const char *const about[] = {
        "Euler angles: x about X, y about Y, z about Z, radians, in every order. The order is the product from left to "
        "right,",
        "order 2, YXZ, is R = Ry Rx Rz: intrinsic y, x, z, or extrinsic z, x, y.",
        "orders: 0 XYZ, 1 XZY, 2 YXZ, 3 YZX, 4 ZXY, 5 ZYX. Quaternions x y z w; matrices column by column.",
        "The other triple of a rotation, for the order i j k: i + pi, pi - j, k + pi.",
        NULL,
    };
    truth_open(folder, "euler", about);
    angles_groups();
    back_group();
    nearest_group();
    truth_close();
}

#else
typedef int truth_euler_is_skipped;
#endif
