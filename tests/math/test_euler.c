/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "random.h"
#include "support/expect.h"

#define PI      3.14159274f
#define HALF_PI 1.57079637f

static const nkw_euler_order orders[6] = {NKW_EULER_XYZ, NKW_EULER_XZY, NKW_EULER_YXZ,
                                          NKW_EULER_YZX, NKW_EULER_ZXY, NKW_EULER_ZYX};
static const char axes[6][4] = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};

static nkw_vec3 vec(float x, float y, float z)
{
    nkw_vec3 r = {x, y, z};
    return r;
}

static nkw_quat about(char axis, nkw_vec3 angles)
{
    return axis == 'x'   ? nkw_quat_from_axis_angle(vec(1, 0, 0), angles.x)
           : axis == 'y' ? nkw_quat_from_axis_angle(vec(0, 1, 0), angles.y)
                         : nkw_quat_from_axis_angle(vec(0, 0, 1), angles.z);
}

static float angle_about(char axis, nkw_vec3 angles)
{
    return axis == 'x' ? angles.x : axis == 'y' ? angles.y : angles.z;
}

static void no_angles_are_no_rotation(void **state)
{
    (void)state;
    for (int o = 0; o < 6; o++) {
        expect_quat_bits(nkw_quat_from_euler(vec(0, 0, 0), orders[o]), nkw_quat_identity());
        expect_vec3_near(nkw_euler_from_quat(nkw_quat_identity(), orders[o]), vec(0, 0, 0), 0);
        nkw_quat other = nkw_quat_negate(nkw_quat_identity());
        expect_vec3_near(nkw_euler_from_quat(other, orders[o]), vec(0, 0, 0), 0);
    }
}

static void order_names_the_product_from_left_to_right(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 3000; i++) {
        nkw_vec3 a = random_vec3(&r, -4, 4);
        for (int o = 0; o < 6; o++) {
            nkw_quat product =
                nkw_quat_mul(nkw_quat_mul(about(axes[o][0], a), about(axes[o][1], a)), about(axes[o][2], a));
            expect_quat_near(nkw_quat_from_euler(a, orders[o]), product, 5e-7);
            nkw_mat3 m = nkw_mat3_from_euler(a, orders[o]), n = nkw_mat3_from_quat(product);
            expect_floats_near(m.m, n.m, 9, 1e-6);
        }
    }
}

static void yxz_is_the_matrix_of_the_exercise(void **state)
{
    (void)state;
    /* Ry(216 deg) Rx(60 deg) Rz(45 deg): key 1 of the exercise's scene 1, by rows in coursework/keys.json. */
    nkw_mat3 m = nkw_mat3_from_euler(vec(1.04719755f, 3.76991118f, 0.785398163f), NKW_EULER_YXZ);
    const float want[9] = {-0.93200489f, 0.35355339f,  -0.07979277f, 0.21211792f, 0.35355339f,
                           -0.91104665f, -0.29389263f, -0.86602540f, -0.40450850f};
    expect_floats_near(m.m, want, 9, 3e-7);
}

static void angles_within_range_come_back(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 3000; i++) {
        for (int o = 0; o < 6; o++) {
            nkw_vec3 a = random_vec3(&r, -3.1f, 3.1f);
            float *middle = axes[o][1] == 'x' ? &a.x : axes[o][1] == 'y' ? &a.y : &a.z;
            *middle *= 0.49f;
            expect_vec3_near(nkw_euler_from_quat(nkw_quat_from_euler(a, orders[o]), orders[o]), a, 1e-5);
            nkw_mat3 m = nkw_mat3_from_euler(a, orders[o]);
            expect_vec3_near(nkw_euler_from_mat3(&m, orders[o]), a, 1e-5);
        }
    }
}

static void rotation_comes_back_at_and_near_the_poles(void **state)
{
    (void)state;
    random_source r = random_from(3);
    static const float off[] = {0, 1e-8f, 5e-8f, 1e-7f, 1e-6f, 1e-5f, 1e-4f, 1e-3f, 1e-2f};
    for (int i = 0; i < 9000; i++) {
        for (int o = 0; o < 6; o++) {
            nkw_vec3 a = random_vec3(&r, -PI, PI);
            float *middle = axes[o][1] == 'x' ? &a.x : axes[o][1] == 'y' ? &a.y : &a.z;
            *middle = (i % 2 ? -1.0f : 1.0f) * (HALF_PI - off[i % 9]);
            nkw_quat q = nkw_quat_from_euler(a, orders[o]);
            nkw_mat3 m = nkw_mat3_from_quat(q);
            expect_rotation_near(nkw_quat_from_euler(nkw_euler_from_quat(q, orders[o]), orders[o]), q, 4e-7);
            expect_rotation_near(nkw_quat_from_euler(nkw_euler_from_mat3(&m, orders[o]), orders[o]), q, 5e-7);
        }
    }
}

/* The product of the three turns in binary64, rounded once. */
static nkw_quat rounded_rotation(nkw_vec3 angles, const char *order)
{
    double q[4] = {0, 0, 0, 1};
    for (int k = 0; k < 3; k++) {
        double half = 0.5 * (double)angle_about(order[k], angles), s = sin(half), c = cos(half);
        int i = order[k] - 'x', a = (i + 1) % 3, b = (i + 2) % 3;
        double r[4];
        r[i] = q[i] * c + q[3] * s;
        r[a] = q[a] * c + q[b] * s;
        r[b] = q[b] * c - q[a] * s;
        r[3] = q[3] * c - q[i] * s;
        memcpy(q, r, sizeof q);
    }
    nkw_quat r = {(float)q[0], (float)q[1], (float)q[2], (float)q[3]};
    return r;
}

static void at_the_pole_the_last_angle_is_zero(void **state)
{
    (void)state;
    for (int o = 0; o < 6; o++) {
        for (int side = -1; side <= 1; side += 2) {
            nkw_vec3 a = vec(0.5f, 0.5f, 0.5f);
            float *middle = axes[o][1] == 'x' ? &a.x : axes[o][1] == 'y' ? &a.y : &a.z;
            *middle = (float)side * HALF_PI;
            nkw_vec3 got = nkw_euler_from_quat(rounded_rotation(a, axes[o]), orders[o]);
            expect_bits(angle_about(axes[o][2], got), 0.0f);
            expect_bits(angle_about(axes[o][1], got), (float)side * HALF_PI);
        }
    }
}

static void outer_angles_reach_half_a_turn(void **state)
{
    (void)state;
    nkw_mat3 m = {{-1, 0, 0, 0, 1, 0, 0, 0, -1}};
    expect_near(nkw_abs(nkw_euler_from_mat3(&m, NKW_EULER_YXZ).y), PI, 0);
    expect_near(nkw_euler_from_mat3(&m, NKW_EULER_YXZ).x, 0.0, 0);
}

static void zero_quaternion_and_unknown_order_are_defined(void **state)
{
    (void)state;
    nkw_quat zero = {0, 0, 0, 0};
    nkw_vec3 a = vec(0.1f, 0.2f, 0.3f);
    expect_vec3_near(nkw_euler_from_quat(zero, NKW_EULER_ZXY), vec(0, 0, 0), 0);
    expect_quat_bits(nkw_quat_from_euler(a, (nkw_euler_order)77), nkw_quat_from_euler(a, NKW_EULER_XYZ));
    expect_quat_bits(nkw_quat_from_euler(a, (nkw_euler_order)-1), nkw_quat_from_euler(a, NKW_EULER_XYZ));
}

static void opposite_quaternions_have_the_same_angles(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 3000; i++) {
        nkw_quat q = random_rotation(&r);
        nkw_vec3 a = nkw_euler_from_quat(q, NKW_EULER_ZYX);
        expect_vec3_near(nkw_euler_from_quat(nkw_quat_negate(q), NKW_EULER_ZYX), a, 1e-6);
    }
}

static void unwrap_moves_by_whole_turns_to_the_reference(void **state)
{
    (void)state;
    nkw_vec3 got = nkw_euler_unwrap(vec(-3.0f, 3.0f, 0.5f), vec(3.0f, -3.0f, 12.0f));
    expect_vec3_near(got, vec(3.28318531f, -3.28318531f, 13.0663706f), 1e-6);
    expect_vec3_bits(nkw_euler_unwrap(vec(1, -2, 3), vec(1, 1, 1)), vec(1, -2, 3));
    expect_nan(nkw_euler_unwrap(vec(NAN, 0, 0), vec(0, 0, 0)).x);
}

static void opposite_signs_give_the_same_angles_at_half_turns(void **state)
{
    (void)state;
    nkw_quat x = {1.0f, 0.0f, 0.0f, 0.0f}, z = {0.0f, 0.0f, 1.0f, 0.0f};
    for (int order = NKW_EULER_XYZ; order <= NKW_EULER_ZYX; order++) {
        nkw_vec3 a = nkw_euler_from_quat(x, (nkw_euler_order)order);
        nkw_vec3 b = nkw_euler_from_quat(nkw_quat_negate(x), (nkw_euler_order)order);
        assert_true(a.x == b.x && a.y == b.y && a.z == b.z);
        a = nkw_euler_from_quat(z, (nkw_euler_order)order);
        b = nkw_euler_from_quat(nkw_quat_negate(z), (nkw_euler_order)order);
        assert_true(a.x == b.x && a.y == b.y && a.z == b.z);
    }
}

/* Rotations of any length, at the pole and elsewhere; of matrices of any size the angles are finite. */
static void angles_do_not_depend_on_the_length(void **state)
{
    (void)state;
    random_source r = random_from(12);
    for (int i = 0; i < 6000; i++) {
        nkw_euler_order order = (nkw_euler_order)(i % 6);
        nkw_vec3 angles = random_vec3(&r, -1.5f, 1.5f);
        float *middle = order == NKW_EULER_XZY || order == NKW_EULER_YZX   ? &angles.z
                        : order == NKW_EULER_XYZ || order == NKW_EULER_ZYX ? &angles.y
                                                                           : &angles.x;
        *middle = i % 5 == 0 ? 0x1.921fb6p0f : *middle;
        nkw_quat q = nkw_quat_from_euler(angles, order);
        float size = float_of((uint32_t)(127 + (int)(random_bits(&r) % 120) - 60) << 23);
        nkw_quat scaled = nkw_quat_scale(q, size);
        expect_rotation_near(nkw_quat_from_euler(nkw_euler_from_quat(scaled, order), order), q, 5e-7);
        nkw_mat3 m;
        for (int k = 0; k < 9; k++)
            m.m[k] = i % 2 ? random_finite(&r) : random_scaled(&r, 120, 127);
        assert_true(nkw_vec3_is_finite(nkw_euler_from_mat3(&m, order)));
    }
}

/* Angles on both sides of the length from which they are computed in binary64. */
static void alternate_angles_are_the_same_rotation(void **state)
{
    (void)state;
    random_source r = random_from(31);
    for (int i = 0; i < 12000; i++) {
        nkw_euler_order order = orders[i % 6];
        nkw_vec3 a = random_vec3(&r, -3.0f, 3.0f), b = nkw_euler_alternate(a, order);
        expect_rotation_near(nkw_quat_from_euler(b, order), nkw_quat_from_euler(a, order), 8e-7);
        assert_true(nkw_vec3_distance(a, b) > 0.1f);
        expect_vec3_near(nkw_euler_alternate(b, order), a, 8e-7);
    }
}

/* A pitch that passes through the pole at constant speed: its other triple continues where the first jumps. */
static void filtered_angles_pass_through_the_pole(void **state)
{
    (void)state;
    enum { KEYS = 120 };
    nkw_vec3 angles[KEYS], filtered[KEYS];
    float jump = 0.0f;
    for (int k = 0; k < KEYS; k++) {
        nkw_vec3 turned = vec(0.1f * (float)k, 0.3f, 0.2f);
        angles[k] = nkw_euler_from_quat(nkw_quat_from_euler(turned, NKW_EULER_YXZ), NKW_EULER_YXZ);
        jump = k ? nkw_max(jump, nkw_vec3_distance(angles[k], angles[k - 1])) : jump;
    }
    assert_true(jump > 3.0f);
    nkw_euler_filter(angles, KEYS, NKW_EULER_YXZ, filtered);
    for (int k = 0; k < KEYS; k++)
        expect_vec3_near(filtered[k], vec(0.1f * (float)k, 0.3f, 0.2f), 3e-5);
    nkw_euler_filter(angles, KEYS, NKW_EULER_YXZ, angles);
    assert_memory_equal(angles, filtered, sizeof angles);
    nkw_euler_filter(angles, 0, NKW_EULER_YXZ, angles);
}

static void nearest_angles_are_no_farther_than_either_triple(void **state)
{
    (void)state;
    random_source r = random_from(32);
    for (int i = 0; i < 12000; i++) {
        nkw_euler_order order = orders[i % 6];
        nkw_vec3 a = random_vec3(&r, -6.0f, 6.0f), reference = random_vec3(&r, -20.0f, 20.0f);
        nkw_vec3 got = nkw_euler_nearest(a, reference, order);
        float distance = nkw_vec3_distance(got, reference) * (1.0f - 1e-6f);
        assert_true(distance <= nkw_vec3_distance(nkw_euler_unwrap(a, reference), reference));
        nkw_vec3 other = nkw_euler_unwrap(nkw_euler_alternate(a, order), reference);
        assert_true(distance <= nkw_vec3_distance(other, reference));
        expect_rotation_near(nkw_quat_from_euler(got, order), nkw_quat_from_euler(a, order), 4e-6);
    }
    expect_vec3_bits(nkw_euler_nearest(vec(1, 2, 3), vec(1, 2, 3), NKW_EULER_ZYX), vec(1, 2, 3));
}

/* The other triple of (-0, 0, -0) is (pi, pi, pi), and that of (0, -0, 0) is (-pi, -pi, -pi). */
static void a_zero_is_turned_by_its_sign(void **state)
{
    (void)state;
    for (int o = 0; o < 6; o++)
        for (int signs = 0; signs < 8; signs++) {
            const float zero[2] = {0.0f, -0.0f};
            nkw_vec3 a = vec(zero[signs & 1], zero[signs >> 1 & 1], zero[signs >> 2]);
            nkw_vec3 b = nkw_euler_alternate(a, orders[o]);
            const float in[3] = {a.x, a.y, a.z}, out[3] = {b.x, b.y, b.z};
            for (int axis = 0; axis < 3; axis++)
                expect_bits(out[axis], (axis == axes[o][1] - 'x') == !signbit(in[axis]) ? PI : -PI);
        }
}

/* Halfway between both triples, exactly: each angle is pi/2 from 0 and from pi. */
static void of_two_triples_at_one_distance_the_first_is_nearest(void **state)
{
    (void)state;
    for (int o = 0; o < 6; o++) {
        float a[3] = {-0.0f, -0.0f, -0.0f};
        a[axes[o][1] - 'x'] = 0.0f;
        nkw_vec3 first = vec(a[0], a[1], a[2]), halfway = vec(0.5f * PI, 0.5f * PI, 0.5f * PI);
        expect_vec3_bits(nkw_euler_alternate(first, orders[o]), vec(PI, PI, PI));
        expect_vec3_bits(nkw_euler_nearest(first, halfway, orders[o]), first);
    }
}

static void euler_lerp_unwraps_what_it_is_told_to(void **state)
{
    (void)state;
    nkw_vec3 a = vec(3, 3, 3), b = vec(-3, -3, -3);
    expect_vec3_near(nkw_euler_lerp(a, b, 0.5f, NKW_UNWRAP_NONE), vec(0, 0, 0), 0);
    expect_vec3_near(nkw_euler_lerp(a, b, 0.5f, NKW_UNWRAP_YAW), vec(0, -PI, 0), 3e-7);
    expect_vec3_near(nkw_euler_lerp(a, b, 0.5f, NKW_UNWRAP_ALL), vec(-PI, -PI, -PI), 3e-7);
    expect_vec3_bits(nkw_euler_lerp(a, b, 0.0f, NKW_UNWRAP_NONE), a);
    expect_vec3_bits(nkw_euler_lerp(a, b, 1.0f, NKW_UNWRAP_ALL), b);
    nkw_vec3 odd = vec(-0.0f, 1, 1e38f), far = vec(1, -0.0f, INFINITY);
    expect_vec3_bits(nkw_euler_lerp(odd, far, 0.0f, NKW_UNWRAP_NONE), odd);
    expect_vec3_bits(nkw_euler_lerp(far, odd, 1.0f, NKW_UNWRAP_NONE), odd);
    expect_vec3_bits(nkw_euler_lerp(a, b, 0.25f, (nkw_unwrap)7), nkw_euler_lerp(a, b, 0.25f, NKW_UNWRAP_NONE));
}

static void euler_lerp_unwraps_only_beyond_half_a_turn(void **state)
{
    (void)state;
    nkw_vec3 a = vec(0, 0, 0), less = vec(0, 3.1415925f, 0), more = vec(0, 3.1415930f, 0);
    expect_near(nkw_euler_lerp(a, less, 0.5f, NKW_UNWRAP_YAW).y, 0.5 * 3.1415925, 1e-6);
    expect_near(nkw_euler_lerp(a, more, 0.5f, NKW_UNWRAP_YAW).y, 1.5 * 3.14159265, 1e-6);
}

/* ---- Proper orders ---- */

static const nkw_euler_order proper[6] = {NKW_EULER_XYX, NKW_EULER_XZX, NKW_EULER_YXY,
                                          NKW_EULER_YZY, NKW_EULER_ZXZ, NKW_EULER_ZYZ};
static const char proper_axes[6][4] = {"xyx", "xzx", "yxy", "yzy", "zxz", "zyz"};

static nkw_quat turn(char axis, float angle)
{
    return about(axis, vec(angle, angle, angle));
}

/* The product of three turns by its definition, about axes that turn along. */
static nkw_quat product_of(const char *about_axes, const float *angles)
{
    return nkw_quat_mul(nkw_quat_mul(turn(about_axes[0], angles[0]), turn(about_axes[1], angles[1])),
                        turn(about_axes[2], angles[2]));
}

static void proper_orders_name_their_product(void **state)
{
    (void)state;
    random_source r = random_from(71);
    for (int i = 0; i < 3000; i++) {
        nkw_vec3 a = random_vec3(&r, -4, 4);
        for (int o = 0; o < 6; o++) {
            nkw_quat product = product_of(proper_axes[o], &a.x), q = nkw_quat_from_euler(a, proper[o]);
            expect_quat_near(q, product, 5e-7);
            nkw_mat3 m = nkw_mat3_from_euler(a, proper[o]), n = nkw_mat3_from_quat(product);
            expect_floats_near(m.m, n.m, 9, 1e-6);
            /* Angles of any rotation are in range and are that rotation; from the matrix too. */
            nkw_vec3 b = nkw_euler_from_quat(product, proper[o]), c = nkw_euler_from_mat3(&n, proper[o]);
            assert_true(nkw_abs(b.x) <= PI && b.y >= 0 && b.y <= PI && nkw_abs(b.z) <= PI);
            expect_rotation_near(nkw_quat_from_euler(b, proper[o]), product, 8e-7);
            expect_rotation_near(nkw_quat_from_euler(c, proper[o]), product, 1.2e-6);
            expect_vec3_bits(nkw_euler_from_quat(nkw_quat_negate(product), proper[o]), b);
            nkw_vec3 other = nkw_euler_alternate(b, proper[o]);
            expect_rotation_near(nkw_quat_from_euler(other, proper[o]), product, 1e-6);
            expect_near(other.y, -b.y, 0);
        }
    }
    /* ZXZ of 0.3, 1.1, -2: by hand, w = cos 0.55 cos(-0.85). */
    nkw_quat q = nkw_quat_from_euler(vec(0.3f, 1.1f, -2), NKW_EULER_ZXZ);
    const nkw_quat want = {0.21351117f, 0.47709005f, -0.64048497f, 0.56265182f};
    expect_quat_near(q, want, 1e-7);
}

static void proper_angles_within_range_come_back(void **state)
{
    (void)state;
    random_source r = random_from(72);
    for (int i = 0; i < 3000; i++) {
        nkw_vec3 a = random_vec3(&r, -3.1f, 3.1f);
        a.y = random_between(&r, 0.05f, 3.09f);
        for (int o = 0; o < 6; o++)
            expect_vec3_near(nkw_euler_from_quat(nkw_quat_from_euler(a, proper[o]), proper[o]), a, 1e-5);
    }
}

/* Middle angle 0 and pi: the last angle is 0, the first the whole turn; near them the rotation is kept. */
static void proper_orders_have_poles_at_zero_and_pi(void **state)
{
    (void)state;
    random_source r = random_from(73);
    for (int o = 0; o < 6; o++) {
        expect_vec3_near(nkw_euler_from_quat(nkw_quat_identity(), proper[o]), vec(0, 0, 0), 0);
        expect_vec3_near(nkw_euler_from_quat((nkw_quat){0, 0, 0, 0}, proper[o]), vec(0, 0, 0), 0);
        nkw_vec3 half = nkw_euler_from_quat(turn(proper_axes[o][1], PI), proper[o]);
        expect_vec3_near(half, vec(0, PI, 0), 1e-6);
        for (int i = 0; i < 400; i++) {
            float x = random_between(&r, -3, 3), away = nkw_pow(10, random_between(&r, -9, -2));
            nkw_vec3 a = nkw_euler_from_quat(turn(proper_axes[o][0], x), proper[o]);
            expect_vec3_near(a, vec(x, 0, 0), 1e-6);
            for (int south = 0; south < 2; south++) {
                float angles[3] = {x, south ? PI - away : away, random_between(&r, -3, 3)};
                nkw_quat q = product_of(proper_axes[o], angles);
                nkw_vec3 b = nkw_euler_from_quat(q, proper[o]);
                expect_rotation_near(nkw_quat_from_euler(b, proper[o]), q, 8e-7);
            }
        }
    }
}

/* A motion through both poles: the filtered angles are those that it was made from, without jumps. */
static void filtered_proper_angles_do_not_jump(void **state)
{
    (void)state;
    enum { COUNT = 400 };
    nkw_vec3 angles[COUNT], track[COUNT];
    for (int o = 0; o < 6; o++) {
        for (int i = 0; i < COUNT; i++) {
            float t = 0.02f * (float)i;
            track[i] = vec(1.5f + 0.3f * t, 0.4f + 1.3f * t, -0.7f - 0.9f * t);
            angles[i] = nkw_euler_from_quat(nkw_quat_from_euler(track[i], proper[o]), proper[o]);
        }
        nkw_euler_filter(angles, COUNT, proper[o], angles);
        for (int i = 0; i < COUNT; i++) {
            nkw_quat q = nkw_quat_from_euler(track[i], proper[o]);
            expect_rotation_near(nkw_quat_from_euler(angles[i], proper[o]), q, 2e-6);
            expect_vec3_near(angles[i], track[i], 3e-4);
        }
    }
}

/* ---- What tools call their orders ---- */

/* How a tool turns a vector: about axes that stay, in the order of the name, or about axes that turn along. */
typedef struct named {
    const char *tool, *name;
    int moves;
    nkw_euler_order order;
} named;

static void names_of_tools_are_these_orders(void **state)
{
    (void)state;
    static const named tools[] = {
        {"Blender XYZ", "xyz", 0, NKW_EULER_ZYX},        {"Blender ZXY", "zxy", 0, NKW_EULER_YXZ},
        {"Maya xyz", "xyz", 0, NKW_EULER_ZYX},           {"Maya yzx", "yzx", 0, NKW_EULER_XZY},
        {"3ds Max XYZ", "xyz", 0, NKW_EULER_ZYX},        {"FBX eEulerXYZ", "xyz", 0, NKW_EULER_ZYX},
        {"USD rotateXYZ", "xyz", 0, NKW_EULER_ZYX},      {"USD rotateZXY", "zxy", 0, NKW_EULER_YXZ},
        {"Houdini xyz", "xyz", 0, NKW_EULER_ZYX},        {"Unity ZXY", "zxy", 0, NKW_EULER_YXZ},
        {"SciPy xyz", "xyz", 0, NKW_EULER_ZYX},          {"SciPy XYZ", "xyz", 1, NKW_EULER_XYZ},
        {"three.js XYZ", "xyz", 1, NKW_EULER_XYZ},       {"three.js YXZ", "yxz", 1, NKW_EULER_YXZ},
        {"Godot YXZ", "yxz", 1, NKW_EULER_YXZ},          {"BVH Z X Y channels", "zxy", 1, NKW_EULER_ZXY},
        {"SciPy ZXZ", "zxz", 1, NKW_EULER_ZXZ},          {"SciPy zxz", "zxz", 0, NKW_EULER_ZXZ},
    };
    random_source r = random_from(74);
    for (size_t i = 0; i < sizeof tools / sizeof *tools; i++) {
        const named *t = &tools[i];
        nkw_vec3 v = random_direction(&r), got = v;
        float a[3] = {random_between(&r, -2, 2), random_between(&r, -2, 2), random_between(&r, -2, 2)}, by[3];
        int is_proper = t->name[0] == t->name[2];
        /* Of axes that turn along, the last turn is the first of the vector. */
        for (int k = 0; k < 3; k++) {
            int n = t->moves ? 2 - k : k;
            got = nkw_quat_rotate(turn(t->name[n], a[n]), got);
            by[is_proper ? (t->moves ? n : 2 - n) : t->name[n] - 'x'] = a[n];
        }
        nkw_vec3 want = nkw_quat_rotate(nkw_quat_from_euler(vec(by[0], by[1], by[2]), t->order), v);
        if (nkw_vec3_distance(got, want) > 2e-6f)
            fail_msg("%s", t->tool);
    }
    /* Unreal's FRotator: its quaternion by its own formula, of pitch, yaw and roll. */
    float p = 0.4f, y = -1.1f, l = 0.7f, sp = nkw_sin(p / 2), cp = nkw_cos(p / 2), sy = nkw_sin(y / 2);
    float cy = nkw_cos(y / 2), sr = nkw_sin(l / 2), cr = nkw_cos(l / 2);
    const nkw_quat unreal = {cr * sp * sy - sr * cp * cy, -cr * sp * cy - sr * cp * sy, cr * cp * sy - sr * sp * cy,
                             cr * cp * cy + sr * sp * sy};
    expect_quat_near(nkw_quat_from_euler(vec(-l, -p, y), NKW_EULER_ZYX), unreal, 3e-7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(opposite_signs_give_the_same_angles_at_half_turns),
        cmocka_unit_test(no_angles_are_no_rotation),
        cmocka_unit_test(order_names_the_product_from_left_to_right),
        cmocka_unit_test(yxz_is_the_matrix_of_the_exercise),
        cmocka_unit_test(angles_within_range_come_back),
        cmocka_unit_test(rotation_comes_back_at_and_near_the_poles),
        cmocka_unit_test(at_the_pole_the_last_angle_is_zero),
        cmocka_unit_test(outer_angles_reach_half_a_turn),
        cmocka_unit_test(zero_quaternion_and_unknown_order_are_defined),
        cmocka_unit_test(opposite_quaternions_have_the_same_angles),
        cmocka_unit_test(unwrap_moves_by_whole_turns_to_the_reference),
        cmocka_unit_test(angles_do_not_depend_on_the_length),
        cmocka_unit_test(alternate_angles_are_the_same_rotation),
        cmocka_unit_test(filtered_angles_pass_through_the_pole),
        cmocka_unit_test(nearest_angles_are_no_farther_than_either_triple),
        cmocka_unit_test(a_zero_is_turned_by_its_sign),
        cmocka_unit_test(euler_lerp_unwraps_what_it_is_told_to),
        cmocka_unit_test(euler_lerp_unwraps_only_beyond_half_a_turn),
        cmocka_unit_test(proper_orders_name_their_product),
        cmocka_unit_test(proper_angles_within_range_come_back),
        cmocka_unit_test(proper_orders_have_poles_at_zero_and_pi),
        cmocka_unit_test(filtered_proper_angles_do_not_jump),
        cmocka_unit_test(names_of_tools_are_these_orders),
        cmocka_unit_test(of_two_triples_at_one_distance_the_first_is_nearest),
    };
    return cmocka_run_group_tests_name("euler", tests, NULL, NULL);
}
