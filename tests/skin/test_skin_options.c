/* SPDX-License-Identifier: MIT */
/* nkw_skin_options, and joints that are floats. */
#include <math.h>

#include "support/expect.h"
#include "support/put.h"
#include "support/skin_mesh.h"

static const nkw_skin_options inverse = {0, 1, 0}, divided = {0, 0, 1};

/* Joints at most 1 rad apart, with scales 0.5 to 2; every second mesh is mirrored. */
static mesh draw_near(uint64_t seed, size_t k)
{
    random_source r = random_from(seed);
    mesh m = draw(seed, k, 0);
    nkw_quat middle = random_rotation(&r);
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_quat turn = nkw_quat_from_axis_angle(random_direction(&r), random_between(&r, 0, 0.5f));
        nkw_vec3 scale = random_vec3(&r, 0.5f, 2);
        scale.x = seed % 2 ? -scale.x : scale.x;
        nkw_trs trs = {random_vec3(&r, -2, 2), nkw_quat_mul(middle, turn), scale};
        m.matrices[j] = nkw_mat4_from_trs(&trs);
    }
    return m;
}

/* x of M^T x = n in binary64, by elimination with pivots. */
static void solve_transposed(const double m[9], const float *n, double x[3])
{
    double a[3][4];
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 4; c++)
            a[r][c] = c < 3 ? m[r * 3 + c] : (double)n[r];
    for (int p = 0; p < 3; p++) {
        int best = p;
        for (int r = p + 1; r < 3; r++)
            best = fabs(a[r][p]) > fabs(a[best][p]) ? r : best;
        for (int c = 0; c < 4; c++) {
            double t = a[p][c];
            a[p][c] = a[best][c], a[best][c] = t;
        }
        for (int r = 0; r < 3; r++)
            for (int c = 3; r != p && c >= p; c--)
                a[r][c] -= a[r][p] / a[p][p] * a[p][c];
    }
    for (int p = 0; p < 3; p++)
        x[p] = a[p][3] / a[p][p];
}

static void expect_inverse_normal(const mesh *m, size_t k, size_t i, const float *got)
{
    double block[9] = {0}, x[3], length;
    for (size_t e = 0; e < k; e++)
        for (size_t a = 0; a < 9; a++)
            block[a] += (double)m->weights[i * k + e] * (double)m->matrices[m->joints[i * k + e]].m[a / 3 * 4 + a % 3];
    solve_transposed(block, m->v + i * FLOATS + 3, x);
    length = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    for (int c = 0; c < 3; c++)
        expect_near(got[c], x[c] / length, 2e-6);
}

static void normals_are_by_the_inverse_transpose_of_the_blend(void **state)
{
    (void)state;
    for (size_t k = 1; k <= 8; k++) {
        mesh m = draw_near(70 + k, k);
        nkw_skin skin = skin_of(&m, k);
        /* Of another format, and of no joint: not read. */
        nkw_skin_palette palette = {
            {m.matrices, JOINTS, NKW_PALETTE_MAT4}, {m.duals, 0, NKW_PALETTE_DUAL_QUAT}, inverse};
        const nkw_skin_palette usual = palette_of(m.matrices, NULL, JOINTS, 0);
        float out[VERTICES * FLOATS] = {0}, plain[VERTICES * FLOATS] = {0};
        assert_int_equal(nkw_skin_linear(&skin, &palette, streams(m.v, FLOATS), spans(out, FLOATS)), NKW_OK);
        assert_int_equal(nkw_skin_linear(&skin, &usual, streams(m.v, FLOATS), spans(plain, FLOATS)), NKW_OK);
        for (size_t i = 0; i < VERTICES; i++) {
            expect_inverse_normal(&m, k, i, out + i * FLOATS + 3);
            expect_floats_bits(out + i * FLOATS, plain + i * FLOATS, 3);
            expect_floats_bits(out + i * FLOATS + 6, plain + i * FLOATS + 6, 6);
        }
    }
}

/* The normal of one vertex of one joint. */
static nkw_vec3 skin_normal(const nkw_mat3 *block, nkw_vec3 n, nkw_skin_options options)
{
    static const uint8_t joint = 0;
    static const float weight = 1;
    const nkw_mat4 m = {{block->m[0], block->m[1], block->m[2], 0, block->m[3], block->m[4], block->m[5], 0,
                         block->m[6], block->m[7], block->m[8], 0, 0, 0, 0, 1}};
    const nkw_skin skin = {1, 1, {&joint, 0, NKW_SKIN_U8}, {&weight, 0, NKW_SKIN_F32}};
    const nkw_skin_palette palette = {{&m, 1, NKW_PALETTE_MAT4}, {NULL, 0, NKW_PALETTE_NORMAL_MAT3}, options};
    const nkw_vertices_view in = {{NULL, 0}, {&n, 0}, {NULL, 0}, {NULL, 0}};
    const nkw_vertices_span out = {{NULL, 0}, {&n, 0}, {NULL, 0}, {NULL, 0}};
    assert_int_equal(nkw_skin_linear(&skin, &palette, in, out), NKW_OK);
    return n;
}

/* Scale 0 along an axis that is not one of the coordinates': rounding makes the determinant anything near 0. */
static void a_flat_blend_has_the_normal_of_its_plane_on_one_side(void **state)
{
    (void)state;
    random_source r = random_from(72);
    size_t negative = 0;
    for (int round = 0; round < 500; round++) {
        const nkw_quat q = random_rotation(&r);
        const nkw_mat3 turn = nkw_mat3_from_quat(q), back = nkw_mat3_transpose(&turn);
        const nkw_mat3 flat = {{1, 0, 0, 0, 1, 0, 0, 0, 0}};
        nkw_mat3 m = nkw_mat3_mul(&flat, &back);
        m = nkw_mat3_mul(&turn, &m);
        negative += nkw_mat3_determinant(&m) < 0.0f;
        const nkw_vec3 axis = nkw_mat3_column(&turn, 2), n = random_direction(&r);
        const float side = nkw_vec3_dot(axis, n);
        const nkw_vec3 got = skin_normal(&m, n, inverse);
        if (fabsf(side) > 0.05f)
            expect_vec3_near(got, nkw_vec3_scale(axis, side < 0 ? -1.0f : 1.0f), 1e-5);
    }
    assert_true(negative > 50);
}

static void normals_without_a_direction_are_zero(void **state)
{
    (void)state;
    const nkw_vec3 zero = {0, 0, 0}, n = {1, 2, 3};
    const nkw_mat3 line = {{1, 0, 0, 0, 0, 0, 0, 0, 0}}, none = {{0}}, mirrored = {{-2, 0, 0, 0, 1, 0, 0, 0, 1}};
    expect_vec3_near(skin_normal(&line, n, inverse), zero, 0);
    expect_vec3_near(skin_normal(&none, n, inverse), zero, 0);
    expect_vec3_near(skin_normal(&mirrored, zero, inverse), zero, 0);
    /* |det M| (M^-1)^T n of diag(-2, 1, 1): 2 (-0.5, 2, 3) */
    const nkw_skin_options kept = {1, 1, 0};
    const nkw_vec3 longer = {-1, 4, 6};
    expect_vec3_near(skin_normal(&mirrored, n, kept), longer, 0);
}

static void positions_are_divided_by_the_sum_of_the_weights(void **state)
{
    (void)state;
    for (size_t k = 1; k <= 8; k++) {
        mesh m = draw_near(80 + k, k);
        nkw_skin skin = skin_of(&m, k);
        nkw_skin_palette palette = palette_of(m.matrices, NULL, JOINTS, 0);
        float whole[VERTICES * FLOATS] = {0}, plain[VERTICES * FLOATS] = {0}, out[VERTICES * FLOATS] = {0};
        nkw_skin_linear(&skin, &palette, streams(m.v, FLOATS), spans(whole, FLOATS));
        for (size_t i = 0; i < VERTICES * k; i++)
            m.weights[i] *= i / k % 7 == 3 ? 0.0f : 1.0f + (float)(i / k % 5) * 0.75f;
        nkw_skin_linear(&skin, &palette, streams(m.v, FLOATS), spans(plain, FLOATS));
        palette.options = divided;
        nkw_skin_linear(&skin, &palette, streams(m.v, FLOATS), spans(out, FLOATS));
        for (size_t i = 0; i < VERTICES; i++) {
            const float *p = out + i * FLOATS;
            for (size_t c = 0; i % 7 != 3 && c < 3; c++)
                expect_near(p[c], whole[i * FLOATS + c], 4e-6);
            if (i % 7 == 3)
                expect_floats_bits(p, m.v + i * FLOATS, 12);
            expect_floats_bits(p + 3, plain + i * FLOATS + 3, 9);
        }
    }
}

static void weights_that_cancel_divide_by_zero(void **state)
{
    (void)state;
    mesh m = draw(90, 2, 0);
    for (size_t i = 0; i < VERTICES; i++)
        m.joints[2 * i] = 1, m.joints[2 * i + 1] = 2, m.weights[2 * i] = 1, m.weights[2 * i + 1] = -1;
    nkw_skin skin = skin_of(&m, 2);
    nkw_skin_palette palette = palette_of(m.matrices, NULL, JOINTS, 0);
    float out[VERTICES * FLOATS] = {0};
    palette.options = divided;
    nkw_skin_linear(&skin, &palette, streams(m.v, FLOATS), spans(out, FLOATS));
    for (size_t i = 0; i < VERTICES; i++)
        for (size_t c = 0; c < 3; c++)
            assert_true(!(fabsf(out[i * FLOATS + c]) < INFINITY));
}

static const float no_joints[] = {NAN, -1.0f, -1e-40f, 0.5f, 22.5f, 16777218.0f, 3e9f, 1e30f, INFINITY, -INFINITY};
#define NO_JOINTS (sizeof no_joints / sizeof *no_joints)

/* Those of m, each fifth a float that is no joint where `wrong`; m has then a joint beyond the palette there. */
static void floats_of_joints(mesh *m, size_t n, int wrong, float *out)
{
    for (size_t i = 0; i < n; i++) {
        if (wrong && i % 5 == 2)
            m->joints[i] = JOINTS;
        out[i] = wrong && i % 5 == 2 ? no_joints[i / 5 % NO_JOINTS] : m->joints[i] ? (float)m->joints[i] : -0.0f;
    }
}

static void joints_may_be_floats(void **state)
{
    (void)state;
    for (size_t k = 1; k <= 8; k++)
        for (int wrong = 0; wrong < 2; wrong++) {
            mesh m = draw(100 + k, k, 0);
            float joints[VERTICES * 8], want[VERTICES * FLOATS] = {0}, got[VERTICES * FLOATS] = {0};
            floats_of_joints(&m, VERTICES * k, wrong, joints);
            nkw_skin skin = skin_of(&m, k);
            const nkw_skin_palette palette = palette_of(m.matrices, NULL, JOINTS, 0);
            nkw_skin_linear(&skin, &palette, streams(m.v, FLOATS), spans(want, FLOATS));
            skin.joints = (nkw_skin_view){joints, 0, NKW_SKIN_F32};
            assert_int_equal(nkw_skin_linear(&skin, &palette, streams(m.v, FLOATS), spans(got, FLOATS)), NKW_OK);
            expect_floats_bits(got, want, VERTICES * FLOATS);
        }
}

static void floats_that_are_no_joint_are_named(void **state)
{
    (void)state;
    mesh m = draw(110, 4, 0);
    float joints[VERTICES * 4];
    size_t bad;
    floats_of_joints(&m, VERTICES * 4, 0, joints);
    nkw_skin skin = skin_of(&m, 4);
    skin.joints = (nkw_skin_view){joints, 0, NKW_SKIN_F32};
    assert_int_equal(nkw_skin_validate(&skin, JOINTS, NULL), NKW_OK);
    for (size_t e = 0; e < NO_JOINTS; e++) {
        const size_t at = 4 * (7 + e) + e % 4;
        const float before = joints[at];
        joints[at] = no_joints[e];
        assert_int_equal(nkw_skin_validate(&skin, SIZE_MAX, &bad), NKW_OUT_OF_RANGE);
        assert_int_equal(bad, 7 + e);
        joints[at] = before;
    }
}

static void pruning_converts_joints_from_and_to_floats(void **state)
{
    (void)state;
    const float joints[4] = {3, 0.5f, 7, 16777216}, weights[4] = {0.25f, 0.5f, 0.125f, 0.125f};
    float kept_weights[4], as_floats[4];
    uint32_t kept[4];
    const nkw_skin skin = {1, 4, {joints, 0, NKW_SKIN_F32}, {weights, 0, NKW_SKIN_F32}};
    const nkw_skin_span to = {kept, 0, NKW_SKIN_U32}, w = {kept_weights, 0, NKW_SKIN_F32};
    assert_int_equal(nkw_skin_prune(&skin, 4, to, w), NKW_OK);
    assert_memory_equal(kept, ((const uint32_t[4]){3, 0, 7, 1u << 24}), sizeof kept);
    expect_floats_bits(kept_weights, ((const float[4]){0.5f, 0, 0.25f, 0.25f}), 4);
    kept[2] = (1u << 24) + 1;
    const nkw_skin whole = {1, 4, {kept, 0, NKW_SKIN_U32}, {weights, 0, NKW_SKIN_F32}};
    assert_int_equal(nkw_skin_prune(&whole, 4, (nkw_skin_span){as_floats, 0, NKW_SKIN_F32}, w), NKW_OK);
    expect_floats_bits(as_floats, ((const float[4]){3, 0, 0, 16777216}), 4);
    expect_bits(kept_weights[2], 0);
}

static void boxes_of_joints_are_those_of_floats(void **state)
{
    (void)state;
    mesh m = draw(120, 4, 0);
    float joints[VERTICES * 4];
    nkw_box want[JOINTS + 1], got[JOINTS + 1];
    floats_of_joints(&m, VERTICES * 4, 1, joints);
    nkw_skin skin = skin_of(&m, 4);
    const nkw_vec3_stream_view positions = {m.v, FLOATS * sizeof(float)};
    assert_int_equal(nkw_box_from_skin(&skin, positions, want, JOINTS), NKW_OK);
    skin.joints = (nkw_skin_view){joints, 0, NKW_SKIN_F32};
    assert_int_equal(nkw_box_from_skin(&skin, positions, got, JOINTS), NKW_OK);
    assert_memory_equal(got, want, sizeof got);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normals_are_by_the_inverse_transpose_of_the_blend),
        cmocka_unit_test(a_flat_blend_has_the_normal_of_its_plane_on_one_side),
        cmocka_unit_test(normals_without_a_direction_are_zero),
        cmocka_unit_test(positions_are_divided_by_the_sum_of_the_weights),
        cmocka_unit_test(weights_that_cancel_divide_by_zero),
        cmocka_unit_test(joints_may_be_floats),
        cmocka_unit_test(floats_that_are_no_joint_are_named),
        cmocka_unit_test(pruning_converts_joints_from_and_to_floats),
        cmocka_unit_test(boxes_of_joints_are_those_of_floats),
    };
    return cmocka_run_group_tests_name("skin_options", tests, NULL, NULL);
}
