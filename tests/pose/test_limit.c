/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/joint_limits.h"

#define PI 3.14159274f

static const nkw_vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};

/* The swing about axes x and y of the z axis, after a twist about z. */
static nkw_quat rotation_of(float swing_x, float swing_y, float twist)
{
    nkw_vec3 half = {0.5f * swing_x, 0.5f * swing_y, 0};
    return nkw_quat_mul(nkw_quat_exp(half), nkw_quat_from_axis_angle(z, twist));
}

static nkw_vec3 swing_of(nkw_quat q)
{
    return nkw_vec3_scale(nkw_quat_log(nkw_quat_swing_twist(q, z).swing), 2.0f);
}

static nkw_limit limit_of(float a, float b, float low, float high)
{
    nkw_limit limit = {nkw_quat_identity(), {0, 0, 3}, {2, 0, 0}, a, b, low, high};
    return limit;
}

static void rotations_inside_come_back_bit_for_bit(void **state)
{
    (void)state;
    random_source r = random_from(1);
    nkw_limit limit = limit_of(1.0f, 0.5f, -0.7f, 1.2f);
    for (int i = 0; i < 20000; i++) {
        float angle = random_between(&r, 0, 2 * PI), part = 0.999f * random_unit(&r);
        nkw_quat q = rotation_of(1.0f * part * nkw_cos(angle), 0.5f * part * nkw_sin(angle),
                                 random_between(&r, -0.699f, 1.199f));
        q = i % 2 ? nkw_quat_negate(q) : q;
        expect_quat_bits(nkw_limit_apply(&limit, q), q);
        expect_quat_bits(limit_ellipse(q, z, x, 1.0f, 0.5f), q);
        expect_quat_bits(limit_cone(q, z, 1.0f), q);
        expect_quat_bits(limit_twist(q, z, -0.7f, 1.2f), q);
    }
}

static void limits_twice_are_limits_once(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 30000; i++) {
        nkw_limit limit = {random_rotation(&r),         random_direction(&r),        random_direction(&r),
                           random_between(&r, 0, 2.5f), random_between(&r, 0, 2.5f), random_between(&r, -3, 0),
                           random_between(&r, 0, 3)};
        nkw_quat q = nkw_limit_apply(&limit, random_rotation(&r));
        expect_near(nkw_quat_length(q), 1.0, 4e-7);
        expect_quat_bits(nkw_limit_apply(&limit, q), q);
    }
}

/* A rest rotation that is not finite has no limits; a zero one counts as the identity. */
static void a_rest_that_is_not_finite_is_no_limit(void **state)
{
    (void)state;
    random_source r = random_from(10);
    for (int i = 0; i < 12; i++) {
        const nkw_quat q = random_rotation(&r);
        nkw_limit limit = {nkw_quat_identity(), random_direction(&r), random_direction(&r), 0.1f, 0.1f, -0.1f, 0.1f};
        const nkw_quat limited = nkw_limit_apply(&limit, q);
        assert_true(nkw_quat_angle(limited, q) > 0.01f);
        memset(&limit.rest, 0, sizeof limit.rest);
        expect_quat_bits(nkw_limit_apply(&limit, q), limited);
        limit.rest = nkw_quat_identity();
        (&limit.rest.x)[i % 4] = i / 4 == 0 ? NAN : i / 4 == 1 ? INFINITY : -INFINITY;
        expect_quat_bits(nkw_limit_apply(&limit, q), q);
    }
}

/* The angle of the swing of q, from |(w, part along the axis)| = cos of its half. */
static double swing_angle(nkw_quat q, nkw_vec3 axis)
{
    const double along = (double)q.x * axis.x + (double)q.y * axis.y + (double)q.z * axis.z;
    const double cosine = sqrt((double)q.w * q.w + along * along) / (double)nkw_quat_length(q);
    return 2 * acos(cosine < 1 ? cosine : 1);
}

/* Swings up to half a turn, and by all but it: each limit is applied once, then again. */
static void limits_twice_are_limits_once_up_to_a_swing_of_2_9(void **state)
{
    (void)state;
    random_source r = random_from(9);
    int beyond = 0, within = 0;
    for (int i = 0; i < 60000; i++) {
        const nkw_vec3 axis = random_direction(&r), side = random_direction(&r);
        const float a = random_between(&r, 0, 3.3f), b = random_between(&r, 0, 3.3f);
        const float ends[2] = {random_between(&r, -3.1f, 3.1f), random_between(&r, -3.1f, 3.1f)};
        const nkw_quat swing = nkw_quat_from_axis_angle(nkw_vec3_normalize(nkw_vec3_cross(axis, side)),
                                                        3.14159274f - nkw_abs(random_scaled(&r, -24, 0)));
        const nkw_quat q = nkw_quat_mul(swing, nkw_quat_from_axis_angle(axis, random_between(&r, -3.1f, 3.1f)));
        const nkw_limit limit = {nkw_quat_identity(), axis, side, a, b, ends[0], ends[1]};
        const nkw_quat once[4] = {limit_cone(q, axis, a), limit_ellipse(q, axis, side, a, b),
                                  limit_twist(q, axis, ends[0], ends[1]), nkw_limit_apply(&limit, q)};
        const nkw_quat twice[4] = {limit_cone(once[0], axis, a), limit_ellipse(once[1], axis, side, a, b),
                                   limit_twist(once[2], axis, ends[0], ends[1]), nkw_limit_apply(&limit, once[3])};
        for (int k = 0; k < 4; k++) {
            const int holds = k == 0 || swing_angle(once[k], axis) <= 2.9;
            *(holds ? &within : &beyond) += 1;
            if (holds)
                expect_quat_bits(twice[k], once[k]);
        }
    }
    assert_true(within > 100000 && beyond > 10000);
}

static void a_cone_keeps_the_direction_of_the_swing_and_the_twist(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 20000; i++) {
        float angle = random_between(&r, 0, 2 * PI), swing = random_between(&r, 0.5f, 3.0f);
        float twist = random_between(&r, -3, 3), c = nkw_cos(angle), s = nkw_sin(angle);
        nkw_quat got = limit_cone(rotation_of(swing * c, swing * s, twist), z, 0.5f);
        expect_rotation_near(got, rotation_of(0.5f * c, 0.5f * s, twist), 1e-6);
    }
}

static void a_twist_goes_to_the_nearer_end_round_the_circle(void **state)
{
    (void)state;
    expect_rotation_near(limit_twist(rotation_of(0.3f, 0.2f, 1.5f), z, -1, 1), rotation_of(0.3f, 0.2f, 1), 3e-7);
    expect_rotation_near(limit_twist(rotation_of(0.3f, 0.2f, -2), z, 0, 1), rotation_of(0.3f, 0.2f, 0), 3e-7);
    /* -3 is 3.28, nearer to 1 than to -1.5. */
    expect_rotation_near(limit_twist(rotation_of(0, 0, -3), z, -0.1f, 1), rotation_of(0, 0, 1), 3e-7);
    /* Ranges across half a turn. */
    nkw_quat inside = rotation_of(0.1f, 0, -3.1f);
    expect_quat_bits(limit_twist(inside, z, 3.0f, 3.4f), inside);
    expect_rotation_near(limit_twist(rotation_of(0.1f, 0, -2.5f), z, 3.0f, 3.4f), rotation_of(0.1f, 0, 3.4f), 4e-7);
    expect_rotation_near(limit_twist(rotation_of(0.1f, 0, 2.5f), z, 3.0f, 3.4f), rotation_of(0.1f, 0, 3.0f), 4e-7);
}

/* The nearest of many points of the ellipse, in binary64. */
static double nearest_of_many(double a, double b, double px, double py)
{
    double best = HUGE_VAL;
    for (int i = 0; i < 20000; i++) {
        double t = 6.283185307179586 * i / 20000, dx = a * cos(t) - px, dy = b * sin(t) - py;
        double d2 = dx * dx + dy * dy;
        best = d2 < best ? d2 : best;
    }
    return sqrt(best);
}

static void a_swing_goes_to_the_nearest_point_of_the_ellipse(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int i = 0; i < 1500; i++) {
        float a = random_between(&r, 0.01f, 2.5f), b = i % 3 ? random_between(&r, 0.01f, 2.5f) : 1e-4f;
        float angle = random_between(&r, 0, 2 * PI), swing = random_between(&r, 0.1f, 3.0f);
        float px = swing * nkw_cos(angle), py = swing * nkw_sin(angle);
        px = i % 10 == 0 ? 0.0f : px;
        py = i % 10 == 1 ? 0.0f : py;
        if ((px / a) * (px / a) + (py / b) * (py / b) < 1.001f)
            continue;
        nkw_vec3 got = swing_of(limit_ellipse(rotation_of(px, py, 0.4f), z, x, a, b));
        double dx = (double)(got.x - px), dy = (double)(got.y - py);
        /* On the boundary, and no point of it is nearer. */
        double along = (double)(got.x / a), across = (double)(got.y / b);
        expect_near(sqrt(along * along + across * across), 1.0, 4e-6 / (double)(a < b ? a : b));
        double nearest = nearest_of_many((double)a, (double)b, (double)px, (double)py);
        expect_near(sqrt(dx * dx + dy * dy), nearest, 3e-6 + 1e-7 / nearest);
    }
}

static void an_ellipse_without_width_is_a_hinge(void **state)
{
    (void)state;
    nkw_quat got = limit_ellipse(rotation_of(0.8f, 0.3f, 0.2f), z, x, 2, 0);
    expect_rotation_near(got, rotation_of(0.8f, 0, 0.2f), 4e-7);
    got = limit_ellipse(rotation_of(0.8f, 0.3f, 0.2f), z, x, 0.5f, 0);
    expect_rotation_near(got, rotation_of(0.5f, 0, 0.2f), 4e-7);
    got = limit_ellipse(rotation_of(0.8f, 0.3f, 0.2f), z, x, 0, 0.1f);
    expect_rotation_near(got, rotation_of(0, 0.1f, 0.2f), 4e-7);
    got = limit_ellipse(rotation_of(0.8f, 0.3f, 0.2f), z, x, 0, 0);
    expect_rotation_near(got, rotation_of(0, 0, 0.2f), 4e-7);
}

static void equal_half_axes_are_a_cone(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 5000; i++) {
        nkw_quat q = random_rotation(&r);
        nkw_vec3 axis = random_direction(&r), side = random_direction(&r);
        float angle = random_between(&r, 0, 2.5f);
        expect_rotation_near(limit_ellipse(q, axis, side, angle, angle), limit_cone(q, axis, angle), 1e-6);
    }
}

static void limits_are_measured_from_the_rest_rotation(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 5000; i++) {
        nkw_limit limit = limit_of(0.6f, 0.3f, -0.2f, 0.4f), resting = limit;
        nkw_quat q = random_rotation(&r);
        resting.rest = random_rotation(&r);
        expect_rotation_near(nkw_limit_apply(&resting, nkw_quat_mul(resting.rest, q)),
                             nkw_quat_mul(resting.rest, nkw_limit_apply(&limit, q)), 2e-5);
    }
}

static void swing_and_twist_are_limited_apart(void **state)
{
    (void)state;
    nkw_limit limit = limit_of(0.6f, 0.3f, -0.2f, 0.4f);
    expect_rotation_near(nkw_limit_apply(&limit, rotation_of(2, 0, 1)), rotation_of(0.6f, 0, 0.4f), 5e-7);
    expect_rotation_near(nkw_limit_apply(&limit, rotation_of(0, -2, 0.1f)), rotation_of(0, -0.3f, 0.1f), 5e-7);
    expect_rotation_near(nkw_limit_apply(&limit, rotation_of(0.1f, 0.1f, -1)), rotation_of(0.1f, 0.1f, -0.2f), 5e-7);
}

static void no_axis_and_no_number_are_no_limit(void **state)
{
    (void)state;
    const nkw_vec3 none = {0, 0, 0}, odd = {NAN, 0, 0};
    nkw_quat q = rotation_of(2, 1, 2), broken = {NAN, 0, 0, 1}, endless = {INFINITY, 0, 0, 1};
    nkw_limit limit = limit_of(0, 0, 0, 0);
    limit.axis = none;
    expect_quat_bits(nkw_limit_apply(&limit, q), q);
    expect_quat_bits(limit_cone(q, none, 0), q);
    expect_quat_bits(limit_cone(q, odd, 0), q);
    expect_quat_bits(limit_cone(q, z, NAN), q);
    expect_quat_bits(limit_cone(q, z, 4), q);
    expect_quat_bits(limit_twist(q, z, NAN, 1), q);
    expect_quat_bits(limit_twist(q, z, -4, 4), q);
    expect_quat_bits(limit_twist(q, z, 0, INFINITY), q);
    expect_quat_bits(limit_cone(broken, z, 0), broken);
    expect_quat_bits(limit_twist(endless, z, 0, 0), endless);
}

static void odd_limits_are_defined(void **state)
{
    (void)state;
    /* Negative angles are 0; a range upside down is its mean. */
    expect_rotation_near(limit_cone(rotation_of(1, 0, 0.5f), z, -1), rotation_of(0, 0, 0.5f), 4e-7);
    expect_rotation_near(limit_twist(rotation_of(1, 0, 0.5f), z, 0.3f, 0.1f), rotation_of(1, 0, 0.2f), 4e-7);
    /* The side along the axis; the axis swung to its opposite; the zero quaternion. */
    nkw_quat over = {1, 0, 0, 0}, nothing = {0, 0, 0, 0};
    expect_near(nkw_vec3_length(swing_of(limit_ellipse(rotation_of(2, 1, 0), z, z, 0.5f, 0.5f))), 0.5, 1e-6);
    expect_near(nkw_vec3_length(swing_of(limit_cone(over, z, 0.5f))), 0.5, 1e-6);
    expect_quat_bits(limit_cone(nothing, z, 0.5f), nothing);
    nkw_limit limit = limit_of(0.5f, 0.5f, -1, 1);
    limit.rest = nothing;
    expect_rotation_near(nkw_limit_apply(&limit, rotation_of(2, 0, 0)), rotation_of(0.5f, 0, 0), 4e-7);
    nkw_quat long_one = nkw_quat_scale(rotation_of(2, 0, 0), 5.0f);
    expect_rotation_near(limit_cone(long_one, z, 0.5f), rotation_of(0.5f, 0, 0), 4e-7);
    expect_rotation_near(limit_cone(rotation_of(0, 2, 0), y, 0.5f), rotation_of(0, 2, 0), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rotations_inside_come_back_bit_for_bit),
        cmocka_unit_test(limits_twice_are_limits_once),
        cmocka_unit_test(limits_twice_are_limits_once_up_to_a_swing_of_2_9),
        cmocka_unit_test(a_cone_keeps_the_direction_of_the_swing_and_the_twist),
        cmocka_unit_test(a_twist_goes_to_the_nearer_end_round_the_circle),
        cmocka_unit_test(a_swing_goes_to_the_nearest_point_of_the_ellipse),
        cmocka_unit_test(an_ellipse_without_width_is_a_hinge),
        cmocka_unit_test(equal_half_axes_are_a_cone),
        cmocka_unit_test(limits_are_measured_from_the_rest_rotation),
        cmocka_unit_test(swing_and_twist_are_limited_apart),
        cmocka_unit_test(no_axis_and_no_number_are_no_limit),
        cmocka_unit_test(odd_limits_are_defined),
        cmocka_unit_test(a_rest_that_is_not_finite_is_no_limit),
    };
    return cmocka_run_group_tests_name("limit", tests, NULL, NULL);
}
