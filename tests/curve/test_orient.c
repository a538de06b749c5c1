/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"

#define PI 3.14159274f

static const nkw_quat identity = {0, 0, 0, 1};

static nkw_vec3 vec(float x, float y, float z)
{
    nkw_vec3 r = {x, y, z};
    return r;
}

static nkw_quat about_z(float angle)
{
    return nkw_quat_from_axis_angle(vec(0, 0, 1), angle);
}

/* Two rotations: anything from equal over close and sign-flipped to unrelated. */
static void draw_pair(random_source *r, nkw_quat *a, nkw_quat *b)
{
    static const float angles[] = {1e-7f, 1e-5f, 1e-3f, 0.03f, 0.3f, 1.0f, 1.5f};
    uint64_t bits = random_bits(r);
    *a = random_rotation(r);
    *b = bits % 9 == 7 ? *a : bits % 9 == 8 ? random_rotation(r) : random_near(r, *a, angles[bits % 9]);
    if (bits & 256)
        *b = nkw_quat_negate(*b);
}

static nkw_quat nearer(nkw_quat a, nkw_quat b)
{
    return nkw_quat_dot(a, b) < 0 ? nkw_quat_negate(b) : b;
}

static void slerp_gives_its_ends_bit_for_bit(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int i = 0; i < 50000; i++) {
        nkw_quat a, b;
        draw_pair(&r, &a, &b);
        a.x = i % 4 == 1 ? -0.0f : a.x;
        b.y = i % 4 == 2 ? -0.0f : b.y;
        expect_quat_bits(nkw_quat_slerp(a, b, 0.0f), a);
        expect_quat_bits(nkw_quat_slerp(a, b, -0.0f), a);
        expect_quat_bits(nkw_quat_slerp(a, b, 1.0f), nearer(a, b));
        expect_quat_bits(nkw_quat_nlerp(a, b, 0.0f), a);
        expect_quat_bits(nkw_quat_nlerp(a, b, 1.0f), nearer(a, b));
    }
}

/* No t is 1/2 or outside, so that loops may take the way for those aside if they mistake the ends for such. */
static void arrays_of_slerps_keep_the_ends_too(void **state)
{
    (void)state;
    enum { N = 64 };
    nkw_quat a[N], b[N], got[N];
    float from[4][N], to[4][N], t[N];
    const nkw_quat_view p = {from[0], from[1], from[2], from[3]}, q = {to[0], to[1], to[2], to[3]};
    const nkw_quat_span p_span = {from[0], from[1], from[2], from[3]}, q_span = {to[0], to[1], to[2], to[3]};
    random_source r = random_from(20);
    for (int end = 0; end < 3; end++) {
        for (size_t i = 0; i < N; i++) {
            draw_pair(&r, &a[i], &b[i]);
            *(end == 1 ? &b[i].x : &a[i].x) = -0.0f;
            t[i] = i % 3 ? random_between(&r, 0.01f, 0.49f) : end == 0 ? 0.0f : end == 1 ? 1.0f : -0.0f;
        }
        nkw_quat_unpack_n(a, p_span, N);
        nkw_quat_unpack_n(b, q_span, N);
        nkw_quat_slerp_n(p, q, t, p_span, N);
        nkw_quat_pack_n(p, got, N);
        for (size_t i = 0; i < N; i++)
            expect_quat_bits(got[i], i % 3 ? nkw_quat_slerp(a[i], b[i], t[i]) : end == 1 ? nearer(a[i], b[i]) : a[i]);
    }
}

static void slerp_between_equal_or_opposite_inputs_is_that_input(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (int i = 0; i < 50000; i++) {
        nkw_quat q = random_rotation(&r);
        float t = random_between(&r, -1, 2);
        expect_quat_bits(nkw_quat_slerp(q, q, t), q);
        expect_quat_bits(nkw_quat_slerp(q, nkw_quat_negate(q), t), q);
        expect_quat_bits(nkw_quat_nlerp(q, q, t), q);
        expect_quat_bits(nkw_quat_nlerp(q, nkw_quat_negate(q), t), q);
    }
}

static void slerp_swaps_bit_for_bit(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (int i = 0; i < 50000; i++) {
        nkw_quat a, b;
        draw_pair(&r, &a, &b);
        float t = i % 100 ? random_unit(&r) : 0.5f;
        nkw_quat forth = nkw_quat_slerp(a, b, t), back = nkw_quat_slerp(b, a, 1.0f - t);
        expect_quat_near(nkw_quat_dot(a, b) < 0 ? nkw_quat_negate(back) : back, forth, 0);
    }
}

static void slerp_turns_at_constant_speed(void **state)
{
    (void)state;
    for (int i = 0; i <= 100; i++) {
        float t = (float)i / 100;
        expect_quat_near(nkw_quat_slerp(about_z(0.5f), about_z(3.0f), t), about_z(0.5f + 2.5f * t), 3e-7);
    }
}

static void slerp_goes_on_along_its_arc_beyond_the_ends(void **state)
{
    (void)state;
    static const float far[] = {-0x1p-24f, 1.0000001f, -1, 2, 3.5f, -10, 100, 1000};
    for (int i = 0; i < 8; i++)
        expect_quat_near(nkw_quat_slerp(about_z(0), about_z(1), far[i]), about_z(far[i]),
                         2e-7 + 1e-7 * (double)nkw_abs(far[i]));
    expect_near(nkw_quat_length(nkw_quat_slerp(about_z(0), about_z(1), 1e30f)), 1.0, 2e-7);
    expect_near(nkw_quat_length(nkw_quat_slerp(about_z(0), about_z(1), -3e38f)), 1.0, 2e-7);
}

static void slerp_takes_the_shorter_arc(void **state)
{
    (void)state;
    /* From -170 to 170 degrees through 180, not through 0. */
    nkw_quat middle = nkw_quat_slerp(about_z(-2.96705973f), about_z(2.96705973f), 0.5f);
    expect_rotation_near(middle, about_z(PI), 3e-7);
    random_source r = random_from(4);
    for (int i = 0; i < 20000; i++) {
        nkw_quat a, b;
        draw_pair(&r, &a, &b);
        nkw_quat half = nkw_quat_slerp(a, b, 0.5f);
        expect_near(nkw_quat_angle(a, half), 0.5 * (double)nkw_quat_angle(a, b), 2e-6);
        expect_rotation_near(half, nkw_quat_slerp(a, nkw_quat_negate(b), 0.5f), 0);
    }
}

static void slerp_stays_unit_and_smooth_through_the_smallest_angles(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int i = 0; i < 20000; i++) {
        nkw_quat a = random_rotation(&r);
        float angle = (float)(i % 200) * 1e-8f;
        nkw_quat b = random_near(&r, a, angle), q = nkw_quat_slerp(a, i % 2 ? b : nkw_quat_negate(b), random_unit(&r));
        expect_near(nkw_quat_length(q), 1.0, 2e-7);
        assert_true(nkw_quat_angle(a, q) <= nkw_quat_angle(a, b) + 4e-7f);
    }
}

static void slerp_never_steps_back(void **state)
{
    (void)state;
    random_source r = random_from(6);
    for (int i = 0; i < 300; i++) {
        nkw_quat a, b;
        draw_pair(&r, &a, &b);
        double before = -1;
        for (int k = 0; k <= 1024; k++) {
            nkw_quat q = nkw_quat_slerp(a, b, (float)k / 1024);
            double angle = nkw_quat_angle(a, q);
            assert_true(angle >= before - 2.5e-7);
            before = angle;
        }
    }
}

static void zero_and_subnormal_quaternions_give_finite_results(void **state)
{
    (void)state;
    static const nkw_quat odd[] = {
        {0, 0, 0, 0},       {0x1p-149f, 0, 0, 0},         {0, 0, 0, 1}, {1e-40f, -1e-40f, 0, 1e-40f},
        {0, 0, 0, 1.0001f}, {0.5f, 0.5f, 0.5f, 0.50001f}, {0, 0, 0, -1}};
    for (size_t i = 0; i < 7; i++)
        for (size_t k = 0; k < 7; k++)
            for (int t = -4; t <= 8; t++) {
                assert_true(nkw_quat_is_finite(nkw_quat_slerp(odd[i], odd[k], (float)t / 4)));
                assert_true(nkw_quat_is_finite(nkw_quat_nlerp(odd[i], odd[k], (float)t / 4)));
                for (int path = 0; path < 4; path++)
                    assert_true(
                        nkw_quat_is_finite(nkw_quat_slerp_path(odd[i], odd[k], (float)t / 4, (nkw_path)path, 0)));
            }
    expect_quat_bits(nkw_quat_nlerp(odd[0], odd[0], 0.5f), identity);
}

static void expect_all_nan(nkw_quat q)
{
    expect_nan(q.x);
    expect_nan(q.y);
    expect_nan(q.z);
    expect_nan(q.w);
}

/* NaN at each place of a and b, and in t. */
static void interpolations_of_nan_are_nan(void **state)
{
    (void)state;
    float in[9][9], out[4][9];
    const nkw_quat_view a = {in[0], in[1], in[2], in[3]}, b = {in[4], in[5], in[6], in[7]};
    const nkw_quat_span result = {out[0], out[1], out[2], out[3]};
    static const float numbers[9] = {0.6f, 0, 0, 0.8f, 0, 0, 0.6f, 0.8f, 0.3f};
    nkw_quat got[9];
    for (size_t k = 0; k < 9; k++)
        for (size_t i = 0; i < 9; i++)
            in[k][i] = i == k ? NAN : numbers[k];
    nkw_quat_nlerp_n(a, b, in[8], result, 9);
    nkw_quat_pack_n((nkw_quat_view){out[0], out[1], out[2], out[3]}, got, 9);
    for (size_t i = 0; i < 9; i++) {
        nkw_quat from = {in[0][i], in[1][i], in[2][i], in[3][i]}, to = {in[4][i], in[5][i], in[6][i], in[7][i]};
        expect_all_nan(got[i]);
        expect_all_nan(nkw_quat_nlerp(from, to, in[8][i]));
        expect_all_nan(nkw_quat_slerp(from, to, in[8][i]));
    }
}

static void nlerp_follows_the_path_of_slerp(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (int i = 0; i < 20000; i++) {
        nkw_quat a, b;
        draw_pair(&r, &a, &b);
        float t = random_unit(&r);
        nkw_quat n = nkw_quat_nlerp(a, b, t);
        expect_near(nkw_quat_length(n), 1.0, 2.5e-7);
        /* On the arc: the angles to both ends add up. */
        expect_near((double)nkw_quat_angle(a, n) + (double)nkw_quat_angle(n, b), nkw_quat_angle(a, b), 3e-6);
    }
    expect_quat_near(nkw_quat_nlerp(about_z(0), about_z(1.5f), 0.5f), about_z(0.75f), 1.5e-7);
}

static void short_path_is_slerp(void **state)
{
    (void)state;
    random_source r = random_from(8);
    for (int i = 0; i < 20000; i++) {
        nkw_quat a, b;
        draw_pair(&r, &a, &b);
        float t = random_unit(&r);
        expect_quat_near(nkw_quat_slerp_path(a, b, t, NKW_PATH_SHORT, 0), nkw_quat_slerp(a, b, t), 4e-7);
        expect_quat_bits(nkw_quat_slerp_path(a, b, t, (nkw_path)9, 0), nkw_quat_slerp_path(a, b, t, NKW_PATH_SHORT, 0));
    }
}

static void long_path_goes_the_other_way_round(void **state)
{
    (void)state;
    nkw_quat a = about_z(0), b = about_z(1);
    for (int i = 0; i <= 20; i++) {
        float t = (float)i / 20;
        expect_rotation_near(nkw_quat_slerp_path(a, b, t, NKW_PATH_LONG, 0), about_z(t * (1 - 2 * PI)), 5e-7);
        expect_rotation_near(nkw_quat_slerp_path(a, nkw_quat_negate(b), t, NKW_PATH_LONG, 0), about_z(t * (1 - 2 * PI)),
                             5e-7);
    }
}

static void path_as_given_follows_the_signs(void **state)
{
    (void)state;
    nkw_quat a = about_z(0), b = about_z(1);
    for (int i = 0; i <= 20; i++) {
        float t = (float)i / 20;
        expect_quat_near(nkw_quat_slerp_path(a, b, t, NKW_PATH_AS_GIVEN, 0), about_z(t), 3e-7);
        expect_rotation_near(nkw_quat_slerp_path(a, nkw_quat_negate(b), t, NKW_PATH_AS_GIVEN, 0),
                             about_z(t * (1 - 2 * PI)), 5e-7);
    }
}

static void paths_between_opposites_are_a_turn_about_local_z(void **state)
{
    (void)state;
    random_source r = random_from(9);
    for (int i = 0; i < 5000; i++) {
        nkw_quat q = random_rotation(&r);
        float t = random_unit(&r);
        nkw_quat want = nkw_quat_mul(q, about_z(2 * PI * t));
        expect_quat_near(nkw_quat_slerp_path(q, nkw_quat_negate(q), t, NKW_PATH_AS_GIVEN, 0), want, 1e-6);
        expect_rotation_near(nkw_quat_slerp_path(q, q, t, NKW_PATH_LONG, 0), want, 1e-6);
        expect_quat_near(nkw_quat_slerp_path(q, q, t, NKW_PATH_AS_GIVEN, 0), q, 0);
        expect_quat_bits(nkw_quat_slerp_path(q, nkw_quat_negate(q), 0, NKW_PATH_AS_GIVEN, 0), q);
        expect_quat_bits(nkw_quat_slerp_path(q, nkw_quat_negate(q), 1, NKW_PATH_AS_GIVEN, 0), nkw_quat_negate(q));
    }
}

static void paths_near_opposite_stay_unit(void **state)
{
    (void)state;
    /* Of lengths that differ by one ULP, so that a + b is along a - b. */
    nkw_quat a = {1, 0, 0, 0}, b = {-0x1.fffffep-1f, 0, 0, 0};
    random_source r = random_from(13);
    for (int i = 0; i < 20000; i++) {
        float t = random_unit(&r);
        nkw_quat p = random_rotation(&r), q = random_near(&r, p, 1e-7f * (float)(i % 30));
        expect_near(nkw_quat_length(nkw_quat_slerp_path(a, b, t, NKW_PATH_AS_GIVEN, 0)), 1.0, 2e-7);
        expect_near(nkw_quat_length(nkw_quat_slerp_path(p, q, t, NKW_PATH_LONG, 0)), 1.0, 3e-7);
    }
}

static void exp_undoes_log(void **state)
{
    (void)state;
    random_source r = random_from(10);
    for (int i = 0; i < 20000; i++) {
        nkw_quat q = i % 3 ? random_rotation(&r) : random_near(&r, i % 2 ? identity : nkw_quat_negate(identity), 1e-6f);
        expect_quat_near(nkw_quat_exp(nkw_quat_log(q)), q, 5e-7);
    }
}

static void log_is_half_the_rotation_vector(void **state)
{
    (void)state;
    expect_vec3_near(nkw_quat_log(about_z(1.5f)), vec(0, 0, 0.75f), 1e-7);
    expect_vec3_near(nkw_quat_log(identity), vec(0, 0, 0), 0);
    expect_vec3_bits(nkw_quat_log(nkw_quat_negate(identity)), vec(PI, 0, 0));
    nkw_quat minus_zero = {0, 0, 0, -0.0f}, tiny = {0, 1e-40f, 0, 1};
    expect_vec3_near(nkw_quat_log(minus_zero), vec(0, 0, 0), 0);
    expect_vec3_bits(nkw_quat_log(tiny), vec(0, 1e-40f, 0));
    expect_quat_near(nkw_quat_exp(vec(0, 0, 0)), identity, 0);
    expect_quat_near(nkw_quat_exp(vec(0, 1e-40f, 0)), tiny, 0);
}

static void powers_add_up(void **state)
{
    (void)state;
    random_source r = random_from(11);
    for (int i = 0; i < 20000; i++) {
        nkw_quat q = random_rotation(&r);
        float s = random_between(&r, -3, 3), t = random_between(&r, -3, 3);
        expect_quat_near(nkw_quat_pow(q, 1), q, 1.5e-7);
        expect_quat_near(nkw_quat_pow(q, 0), identity, 0);
        expect_quat_near(nkw_quat_pow(q, -1), nkw_quat_conjugate(q), 1.5e-7);
        expect_quat_near(nkw_quat_mul(nkw_quat_pow(q, s), nkw_quat_pow(q, t)), nkw_quat_pow(q, s + t), 3e-6);
    }
    expect_quat_near(nkw_quat_pow(about_z(1), 0.5f), about_z(0.5f), 1e-7);
}

static void angular_velocity_and_integrate_undo_each_other(void **state)
{
    (void)state;
    random_source r = random_from(12);
    for (int i = 0; i < 20000; i++) {
        nkw_quat a, b;
        draw_pair(&r, &a, &b);
        float duration = random_between(&r, 0.01f, 2.0f);
        nkw_vec3 w = nkw_quat_angular_velocity(a, b, duration);
        expect_rotation_near(nkw_quat_integrate(a, w, duration), b, 6e-7);
        expect_near(nkw_vec3_length(w) * duration, nkw_quat_angle(a, b), 2e-6);
    }
}

static void angular_velocity_stands_in_the_outer_frame(void **state)
{
    (void)state;
    /* An object that lies on its side and turns about the world's z. */
    nkw_quat side = nkw_quat_from_axis_angle(vec(1, 0, 0), 0.5f * PI);
    nkw_quat after = nkw_quat_mul(about_z(0.2f), side);
    expect_vec3_near(nkw_quat_angular_velocity(side, after, 0.1f), vec(0, 0, 2), 4e-6);
    expect_vec3_bits(nkw_quat_angular_velocity(side, after, 0.0f), vec(0, 0, 0));
    expect_vec3_near(nkw_quat_angular_velocity(side, nkw_quat_negate(side), 1.0f), vec(0, 0, 0), 0);
}

/* None, one, half or all of t beyond 0..1, some far; the result over each of the nine inputs. */
static void arrays_of_slerps_beyond_their_ends_are_single_ones(void **state)
{
    (void)state;
    enum { N = 300 };
    static const float odd[6] = {1.00001f, -0.25f, 1.5f, 1e6f, NAN, -INFINITY};
    random_source r = random_from(77);
    for (size_t round = 0; round < 60; round++) {
        float c[9][N], out[4][N];
        nkw_quat want[N];
        for (size_t i = 0; i < N; i++) {
            nkw_quat a, b;
            draw_pair(&r, &a, &b);
            const float all[9] = {a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w, random_unit(&r)};
            for (size_t k = 0; k < 9; k++)
                c[k][i] = all[k];
            int is_odd = round % 4 == 0 ? 0 : round % 4 == 1 ? i == 70 : round % 4 == 2 ? i % 2 == 0 : 1;
            if (is_odd)
                c[8][i] = odd[round % 8 < 4 ? i % 3 : i % 6];
            want[i] = nkw_quat_slerp(a, b, c[8][i]);
        }
        float *to[4] = {out[0], out[1], out[2], out[3]};
        to[round % 4] = c[round % 9];
        nkw_quat_view from = {c[0], c[1], c[2], c[3]}, until = {c[4], c[5], c[6], c[7]};
        nkw_quat_span result = {to[0], to[1], to[2], to[3]};
        nkw_quat_slerp_n(from, until, c[8], result, N);
        for (size_t i = 0; i < N; i++) {
            nkw_quat got = {to[0][i], to[1][i], to[2][i], to[3][i]};
            if (want[i].w == want[i].w)
                expect_quat_bits(got, want[i]);
            else
                expect_nan(got.w);
        }
    }
}

static void far_t_gives_unit_quaternions(void **state)
{
    (void)state;
    nkw_quat a = nkw_quat_identity(), b = {0.6f, 0.0f, 0.0f, 0.8f}, half = {1.0f, 0.0f, 0.0f, 0.0f};
    const float far[] = {1e3f, -1e5f, 1e10f, 1e18f};
    for (int i = 0; i < 4; i++)
        assert_float_equal(nkw_quat_length(nkw_quat_nlerp(a, b, far[i])), 1.0f, 2e-7f);
    assert_float_equal(nkw_quat_length(nkw_quat_slerp(a, half, 3e38f)), 1.0f, 2e-7f);
    nkw_vec3 fast = {1e5f, 1e30f, 3.0f};
    assert_float_equal(nkw_quat_length(nkw_quat_integrate(a, fast, 1e30f)), 1.0f, 2e-7f);
}

/* At a.b = 0 both arcs have the same length: b keeps its sign. The angle is half a turn and every product is exact. */
static void orthogonal_keys_keep_their_signs(void **state)
{
    (void)state;
    const nkw_quat pairs[4][2] = {{{1, 0, 0, 0}, {0, 1, 0, 0}},
                                  {{0, 0, 0, 1}, {-1, 0, 0, 0}},
                                  {{0.5f, 0.5f, 0.5f, 0.5f}, {-0.5f, 0.5f, -0.5f, 0.5f}},
                                  {{0.5f, -0.5f, 0.5f, -0.5f}, {-0.5f, -0.5f, 0.5f, 0.5f}}};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k <= 16; k++) {
            float t = (float)k / 16;
            nkw_quat a = pairs[i][0], b = pairs[i][1], slerp = nkw_quat_slerp(a, b, t), nlerp = nkw_quat_nlerp(a, b, t);
            nkw_quat line = nkw_quat_normalize(nkw_quat_add(nkw_quat_scale(a, 1 - t), nkw_quat_scale(b, t)));
            nkw_quat arc =
                nkw_quat_add(nkw_quat_scale(a, nkw_cos(0.5f * PI * t)), nkw_quat_scale(b, nkw_sin(0.5f * PI * t)));
            expect_quat_near(slerp, arc, 3e-7);
            expect_quat_near(nlerp, line, 3e-7);
            expect_quat_near(nkw_quat_slerp_path(a, b, t, NKW_PATH_SHORT, 0), arc, 3e-7);
        }
}

/* One t for all: inside, at the ends, beyond, and so far that angles need the long reduction. */
static void arrays_of_slerps_at_one_t_are_single_ones(void **state)
{
    (void)state;
    enum { N = 37 };
    static const float ts[] = {0,    -0.0f,     1,         0.5f,       0.25f, 0.75f,  -0.5f, 1.5f,
                               1e5f, 262143.0f, 262144.0f, -262144.0f, 1e7f,  -1e18f, 3e38f};
    float c[8][N], out[4][N];
    nkw_quat a[N], b[N];
    random_source r = random_from(21);
    const nkw_quat_view from = {c[0], c[1], c[2], c[3]}, to = {c[4], c[5], c[6], c[7]};
    const nkw_quat_span span_a = {c[0], c[1], c[2], c[3]}, span_b = {c[4], c[5], c[6], c[7]};
    const nkw_quat_span result = {out[0], out[1], out[2], out[3]};
    for (size_t i = 0; i < N; i++)
        draw_pair(&r, &a[i], &b[i]);
    nkw_quat_unpack_n(a, span_a, N);
    nkw_quat_unpack_n(b, span_b, N);
    for (size_t k = 0; k < sizeof ts / sizeof ts[0]; k++)
        for (size_t n = 1; n <= N; n += 6) {
            nkw_quat_slerp_at_n(from, to, ts[k], result, n);
            for (size_t i = 0; i < n; i++) {
                nkw_quat got = {out[0][i], out[1][i], out[2][i], out[3][i]};
                expect_quat_bits(got, nkw_quat_slerp(a[i], b[i], ts[k]));
            }
        }
}

/* Shoemake's formula in binary64, at every angle between the keys. */
static void slerp_and_nlerp_are_exact_to_their_bounds(void **state)
{
    (void)state;
    random_source r = random_from(22);
    for (int i = 0; i < 20000; i++) {
        nkw_quat a, b;
        draw_pair(&r, &a, &b);
        float t = i % 10 ? random_unit(&r) : 0.5f;
        const double p[4] = {a.x, a.y, a.z, a.w}, d[4] = {b.x, b.y, b.z, b.w};
        double lp = 0, ld = 0, cosine = 0, sum = 0, n2 = 0, q[4], line[4], arc[4], u = t;
        for (int k = 0; k < 4; k++) {
            lp += p[k] * p[k];
            ld += d[k] * d[k];
            cosine += p[k] * d[k];
        }
        double sign = cosine < 0 ? -1 : 1;
        for (int k = 0; k < 4; k++) {
            q[k] = sign * d[k] / sqrt(ld);
            sum += (p[k] / sqrt(lp) - q[k]) * (p[k] / sqrt(lp) - q[k]);
            line[k] = (1 - u) * p[k] + u * sign * d[k];
            n2 += line[k] * line[k];
        }
        double h = 2 * asin(0.5 * sqrt(sum)), wa = h > 0 ? sin((1 - u) * h) / sin(h) : 1 - u,
               wb = h > 0 ? sin(u * h) / sin(h) : u;
        nkw_quat slerp = nkw_quat_slerp(a, b, t), nlerp = nkw_quat_nlerp(a, b, t);
        const double got[4] = {slerp.x, slerp.y, slerp.z, slerp.w}, got_line[4] = {nlerp.x, nlerp.y, nlerp.z, nlerp.w};
        for (int k = 0; k < 4; k++) {
            arc[k] = wa * p[k] / sqrt(lp) + wb * q[k];
            expect_near(got[k], arc[k], 3.7 * 0x1p-24);
            expect_near(got_line[k], line[k] / sqrt(n2), 3.3 * 0x1p-24);
        }
    }
}

/* 2^-25 rad from opposite the arc is still the keys' own: about x, not about z. */
static void paths_near_opposite_follow_the_keys(void **state)
{
    (void)state;
    nkw_quat a = identity, b = {0x1p-25f, 0, 0, -1}, c = {0, 0x1p-25f, 0, -1};
    expect_quat_near(nkw_quat_slerp_path(a, b, 0.5f, NKW_PATH_AS_GIVEN, 0), nkw_quat_from_axis_angle(vec(1, 0, 0), PI),
                     1e-5);
    expect_quat_near(nkw_quat_slerp_path(a, c, 0.5f, NKW_PATH_AS_GIVEN, 0), nkw_quat_from_axis_angle(vec(0, 1, 0), PI),
                     1e-5);
}

static void nlerp_goes_on_along_its_line_beyond_the_ends(void **state)
{
    (void)state;
    static const float far[] = {-0x1p-24f, 1.0000001f, -1, 2, -10, 1000, -0x1p60f, 0x1p60f};
    nkw_quat a = about_z(0.2f), b = about_z(1.4f);
    for (int i = 0; i < 8; i++) {
        double t = (double)far[i];
        double z = (1 - t) * (double)a.z + t * (double)b.z, w = (1 - t) * (double)a.w + t * (double)b.w;
        double length = sqrt(z * z + w * w);
        nkw_quat want = {0, 0, (float)(z / length), (float)(w / length)};
        expect_quat_near(nkw_quat_nlerp(a, b, far[i]), want, 1e-6);
    }
}

/* A quarter turn about z, in steps of 0.5 radians; the goal as q and as -q. */
static void a_rotation_towards_turns_by_its_angle(void **state)
{
    (void)state;
    nkw_vec3 z = {0, 0, 1};
    nkw_quat from = nkw_quat_from_axis_angle(z, 0.25f), to = nkw_quat_from_axis_angle(z, 1.75f);
    for (int side = 0; side < 2; side++) {
        nkw_quat goal = side ? nkw_quat_negate(to) : to, step = nkw_quat_rotate_towards(from, goal, 0.5f);
        assert_true(nkw_quat_equal_within(step, nkw_quat_from_axis_angle(z, 0.75f), 1e-6f));
        nkw_quat end = nkw_quat_rotate_towards(from, goal, 2.0f), none = nkw_quat_rotate_towards(from, goal, -1.0f);
        assert_memory_equal(&end, &goal, sizeof goal);
        assert_true(nkw_quat_equal_within(none, from, 0.0f));
        assert_false(nkw_quat_equal_within(none, goal, 1.4f));
    }
    assert_false(nkw_quat_is_finite(nkw_quat_rotate_towards(from, to, NAN)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arrays_of_slerps_beyond_their_ends_are_single_ones),
        cmocka_unit_test(far_t_gives_unit_quaternions),
        cmocka_unit_test(slerp_gives_its_ends_bit_for_bit),
        cmocka_unit_test(arrays_of_slerps_keep_the_ends_too),
        cmocka_unit_test(slerp_between_equal_or_opposite_inputs_is_that_input),
        cmocka_unit_test(slerp_swaps_bit_for_bit),
        cmocka_unit_test(slerp_turns_at_constant_speed),
        cmocka_unit_test(slerp_goes_on_along_its_arc_beyond_the_ends),
        cmocka_unit_test(slerp_takes_the_shorter_arc),
        cmocka_unit_test(slerp_stays_unit_and_smooth_through_the_smallest_angles),
        cmocka_unit_test(slerp_never_steps_back),
        cmocka_unit_test(zero_and_subnormal_quaternions_give_finite_results),
        cmocka_unit_test(interpolations_of_nan_are_nan),
        cmocka_unit_test(nlerp_follows_the_path_of_slerp),
        cmocka_unit_test(short_path_is_slerp),
        cmocka_unit_test(long_path_goes_the_other_way_round),
        cmocka_unit_test(path_as_given_follows_the_signs),
        cmocka_unit_test(paths_between_opposites_are_a_turn_about_local_z),
        cmocka_unit_test(paths_near_opposite_stay_unit),
        cmocka_unit_test(exp_undoes_log),
        cmocka_unit_test(log_is_half_the_rotation_vector),
        cmocka_unit_test(powers_add_up),
        cmocka_unit_test(angular_velocity_and_integrate_undo_each_other),
        cmocka_unit_test(angular_velocity_stands_in_the_outer_frame),
        cmocka_unit_test(orthogonal_keys_keep_their_signs),
        cmocka_unit_test(arrays_of_slerps_at_one_t_are_single_ones),
        cmocka_unit_test(slerp_and_nlerp_are_exact_to_their_bounds),
        cmocka_unit_test(paths_near_opposite_follow_the_keys),
        cmocka_unit_test(nlerp_goes_on_along_its_line_beyond_the_ends),
        cmocka_unit_test(a_rotation_towards_turns_by_its_angle),
    };
    return cmocka_run_group_tests_name("orient", tests, NULL, NULL);
}
