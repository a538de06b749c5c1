/* SPDX-License-Identifier: MIT */
/*
 * docs/examples/textbook.c, the formulas as the exercise and the lesson print them, in binary64, against the library.
 * The bounds are those that docs/textbook.md states.
 */
#include "expect.h"
#include "random.h"

#include <math.h>

#include "../../docs/examples/textbook.h"

enum { ROUNDS = 2000 };

static tb_vec3 wide(nkw_vec3 v)
{
    tb_vec3 r = {(double)v.x, (double)v.y, (double)v.z};
    return r;
}

static tb_quat wide_quat(nkw_quat q)
{
    tb_quat r = {(double)q.x, (double)q.y, (double)q.z, (double)q.w};
    return r;
}

static tb_mat3 wide_mat3(const nkw_mat3 *m)
{
    tb_mat3 r;
    for (size_t i = 0; i < 9; i++)
        r.m[i % 3][i / 3] = (double)m->m[i];
    return r;
}

static void expect_point(nkw_vec3 got, tb_vec3 want, double bound)
{
    expect_near((double)got.x, want.x, bound);
    expect_near((double)got.y, want.y, bound);
    expect_near((double)got.z, want.z, bound);
}

static void expect_mat3(const nkw_mat3 *got, const tb_mat3 *want, double bound)
{
    for (size_t i = 0; i < 9; i++)
        expect_near((double)got->m[i], want->m[i % 3][i / 3], bound);
}

/* Of a quaternion or its negative: both are the rotation. */
static void expect_turn(nkw_quat got, tb_quat want, double bound)
{
    double along = (double)got.x * want.x + (double)got.y * want.y + (double)got.z * want.z + (double)got.w * want.w;
    double sign = along < 0.0 ? -1.0 : 1.0;
    expect_near((double)got.x, sign * want.x, bound);
    expect_near((double)got.y, sign * want.y, bound);
    expect_near((double)got.z, sign * want.z, bound);
    expect_near((double)got.w, sign * want.w, bound);
}

static void the_curves_are_the_textbooks(void **state)
{
    (void)state;
    random_source r = random_from(11);
    for (int i = 0; i < ROUNDS; i++) {
        nkw_vec3 p[4];
        double weight[4], t;
        for (int k = 0; k < 4; k++)
            p[k] = random_vec3(&r, -1.0f, 1.0f);
        tb_vec3 w[4] = {wide(p[0]), wide(p[1]), wide(p[2]), wide(p[3])};
        float at = i == 0 ? 0.0f : i == 1 ? 1.0f : random_unit(&r);
        t = (double)at;
        expect_point(nkw_vec3_lerp(p[0], p[1], at), tb_linear(w[0], w[1], t), 3e-7);
        tb_hermite_weights(t, weight); /* p0, p1, v0, v1 here; p0, v0, p1, v1 in the library */
        expect_point(nkw_vec3_hermite(p[0], p[1], p[2], p[3], at), tb_sum(weight, w[0], w[2], w[1], w[3]), 3e-7);
        tb_bezier_weights(t, weight);
        expect_point(nkw_vec3_bezier(p[0], p[1], p[2], p[3], at), tb_sum(weight, w[0], w[1], w[2], w[3]), 3e-7);
        tb_bspline_weights(t, weight);
        expect_point(nkw_vec3_bspline(p[0], p[1], p[2], p[3], at), tb_sum(weight, w[0], w[1], w[2], w[3]), 3e-7);
    }
}

static void the_weights_are_the_textbooks(void **state)
{
    (void)state;
    static const size_t library[4] = {0, 2, 1, 3}; /* of p0, p1, v0, v1 */
    for (int i = 0; i <= 64; i++) {
        float t = (float)i / 64.0f;
        double h[4], x[4], b[4];
        tb_hermite_weights((double)t, h);
        tb_bezier_weights((double)t, x);
        tb_bspline_weights((double)t, b);
        nkw_weights hermite = nkw_cubic_weights(NKW_CUBIC_HERMITE, 0, t);
        nkw_weights bezier = nkw_cubic_weights(NKW_CUBIC_BEZIER, 0, t);
        nkw_weights bspline = nkw_cubic_weights(NKW_CUBIC_BSPLINE, 0, t);
        for (size_t k = 0; k < 4; k++) {
            expect_near((double)hermite.w[library[k]], h[k], 2e-7);
            expect_near((double)bezier.w[k], x[k], 2e-7);
            expect_near((double)bspline.w[k], b[k], 2e-7);
        }
    }
}

static void slerp_is_the_textbooks(void **state)
{
    (void)state;
    random_source r = random_from(12);
    for (int i = 0; i < ROUNDS; i++) {
        nkw_quat a = random_rotation(&r);
        nkw_quat b = i % 4 ? random_rotation(&r) : random_near(&r, a, random_unit(&r) * 0.01f);
        float t = i == 0 ? 0.0f : i == 1 ? 1.0f : random_unit(&r);
        expect_turn(nkw_quat_slerp(a, b, t), tb_slerp(wide_quat(a), wide_quat(b), (double)t), 3e-7);
    }
    nkw_quat same = nkw_quat_identity();
    expect_turn(nkw_quat_slerp(same, same, 0.3f), tb_slerp(wide_quat(same), wide_quat(same), 0.3), 1e-7);
}

/* Also the four branches of the textbook's conversion: turns of 180 degrees about each axis have w = 0. */
static void conversions_are_the_textbooks(void **state)
{
    (void)state;
    static const nkw_quat half_turns[3] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    random_source r = random_from(13);
    for (int i = 0; i < ROUNDS; i++) {
        nkw_quat q = i < 3 ? half_turns[i] : random_rotation(&r);
        nkw_mat3 m = nkw_mat3_from_quat(q);
        tb_mat3 want = tb_mat3_from_quat(wide_quat(q)), wide_m = wide_mat3(&m);
        expect_mat3(&m, &want, 5e-7);
        expect_turn(nkw_quat_from_mat3(&m), tb_quat_from_mat3(&wide_m), 5e-7);
    }
}

static void euler_angles_are_the_textbooks(void **state)
{
    (void)state;
    random_source r = random_from(14);
    for (int i = 0; i < ROUNDS; i++) {
        tb_angles a = {0.0, 0.0, 0.0}, b, c;
        nkw_vec3 v = {random_between(&r, -1.5f, 1.5f), random_between(&r, -3.1f, 3.1f),
                      random_between(&r, -3.1f, 3.1f)};
        nkw_vec3 to = {random_between(&r, -1.5f, 1.5f), random_between(&r, -3.1f, 3.1f),
                       random_between(&r, -3.1f, 3.1f)};
        float t = random_unit(&r);
        a.pitch = (double)v.x, a.yaw = (double)v.y, a.roll = (double)v.z;
        b.pitch = (double)to.x, b.yaw = (double)to.y, b.roll = (double)to.z;
        nkw_mat3 m = nkw_mat3_from_euler(v, NKW_EULER_YXZ);
        tb_mat3 want = tb_mat3_from_angles(a), wide_m = wide_mat3(&m);
        expect_mat3(&m, &want, 5e-7);
        c = tb_angles_from_mat3(&wide_m);
        nkw_vec3 back = nkw_euler_from_mat3(&m, NKW_EULER_YXZ);
        double bound = 1e-6 / cos(a.pitch); /* yaw and roll are less certain towards the pole */
        expect_near((double)back.x, c.pitch, bound);
        expect_near((double)back.y, c.yaw, bound);
        expect_near((double)back.z, c.roll, bound);
        c = tb_angles_lerp(a, b, (double)t);
        nkw_vec3 between = nkw_euler_lerp(v, to, t, NKW_UNWRAP_YAW);
        expect_near((double)between.x, c.pitch, 5e-7);
        expect_near(sin((double)between.y), sin(c.yaw), 1e-6);
        expect_near(cos((double)between.y), cos(c.yaw), 1e-6);
        expect_near((double)between.z, c.roll, 5e-7);
    }
}

enum { CHAIN = 4 };

/* The lesson's products of T, J and T^-1 are the library's models times inverse bind matrices. */
static void joint_matrices_are_the_textbooks(void **state)
{
    (void)state;
    random_source r = random_from(15);
    for (int round = 0; round < 100; round++) {
        int32_t parents[CHAIN] = {NKW_NO_JOINT, 0, 1, 2};
        nkw_vec3 at[CHAIN];
        nkw_mat4 locals[CHAIN], models[CHAIN], rest[CHAIN], inverse_bind[CHAIN], palette[CHAIN];
        tb_vec3 bind[CHAIN];
        tb_mat4 j[CHAIN], want[CHAIN];
        nkw_vec3 zero = {0.0f, 0.0f, 0.0f};
        for (int i = 0; i < CHAIN; i++) {
            at[i] = random_vec3(&r, -1.0f, 1.0f);
            bind[i] = wide(at[i]);
            rest[i] = nkw_mat4_from_translation(at[i]);
            nkw_quat turn = random_rotation(&r);
            nkw_mat3 m = nkw_mat3_from_quat(turn);
            nkw_vec3 offset = nkw_vec3_sub(at[i], i ? at[i - 1] : zero); /* T(i-1)^-1 T */
            locals[i] = nkw_mat4_from_mat3(&m, offset);
            tb_mat3 w = tb_mat3_from_quat(wide_quat(turn));
            for (int row = 0; row < 4; row++)
                for (int column = 0; column < 4; column++)
                    j[i].m[row][column] = row < 3 && column < 3 ? w.m[row][column] : row == column;
        }
        tb_joint_chain(bind, j, CHAIN, want);
        for (int i = 0; i < CHAIN; i++)
            models[i] = i ? nkw_mat4_mul_affine(&models[parents[i]], &locals[i]) : locals[i];
        nkw_palette_source source = {.models = rest, .model_count = CHAIN, .joint_count = CHAIN};
        nkw_palette_inverse_bind(&source, inverse_bind);
        source.models = models;
        source.inverse_bind = inverse_bind;
        nkw_palette_span out = {palette, CHAIN, NKW_PALETTE_MAT4};
        assert_int_equal(nkw_palette_from_models(&source, out), NKW_OK);
        for (size_t i = 0; i < CHAIN; i++)
            for (size_t e = 0; e < 16; e++)
                expect_near((double)palette[i].m[e], want[i].m[e % 4][e / 4], 2e-6);
    }
}

static void normals_are_the_textbooks(void **state)
{
    (void)state;
    random_source r = random_from(16);
    for (int i = 0; i < ROUNDS; i++) {
        nkw_mat3 m = nkw_mat3_from_quat(random_rotation(&r));
        nkw_vec3 scale = random_vec3(&r, 0.25f, 2.0f);
        for (size_t e = 0; e < 9; e++)
            m.m[e] *= e < 3 ? scale.x : e < 6 ? scale.y : scale.z;
        tb_mat3 wide_m = wide_mat3(&m), want = tb_normal_matrix(&wide_m);
        nkw_mat3 normal = nkw_mat3_normal(&m);
        expect_mat3(&normal, &want, 2e-6);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_curves_are_the_textbooks),   cmocka_unit_test(the_weights_are_the_textbooks),
        cmocka_unit_test(slerp_is_the_textbooks),         cmocka_unit_test(conversions_are_the_textbooks),
        cmocka_unit_test(euler_angles_are_the_textbooks), cmocka_unit_test(joint_matrices_are_the_textbooks),
        cmocka_unit_test(normals_are_the_textbooks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
