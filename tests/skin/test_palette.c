/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/views.h"

#define MODELS 23
#define COUNT  37

typedef struct scene {
    nkw_mat4 models[MODELS], inverse_bind[COUNT], global_inverse;
    int32_t joints[COUNT];
} scene;

static nkw_mat4 draw_matrix(random_source *r, float low, float high)
{
    nkw_trs trs;
    trs.translation = random_vec3(r, -3, 3);
    trs.rotation = random_rotation(r);
    trs.scale = random_vec3(r, low, high);
    return nkw_mat4_from_trs(&trs);
}

static void draw(random_source *r, scene *s)
{
    for (int i = 0; i < MODELS; i++)
        s->models[i] = draw_matrix(r, 0.5f, 2);
    for (int i = 0; i < COUNT; i++) {
        s->inverse_bind[i] = draw_matrix(r, 0.5f, 2);
        s->joints[i] = (int32_t)(random_bits(r) % MODELS);
    }
    s->global_inverse = draw_matrix(r, 0.5f, 2);
}

/* The formulas of the header, by the scalar functions. */
static nkw_mat4 expected(const scene *s, const int32_t *joints, const nkw_mat4 *ib, const nkw_mat4 *g, size_t i)
{
    size_t j = joints ? (size_t)joints[i] : i;
    if (j >= MODELS)
        return nkw_mat4_identity();
    nkw_mat4 m = g ? nkw_mat4_mul_affine(g, &s->models[j]) : s->models[j];
    return ib ? nkw_mat4_mul_affine(&m, &ib[i]) : m;
}

static void expect_palettes(const scene *s, const int32_t *joints, const nkw_mat4 *ib, const nkw_mat4 *g, size_t n)
{
    nkw_mat4 palette[COUNT + 1];
    nkw_mat3x4 rows[COUNT + 1];
    nkw_dual_quat duals[COUNT + 1];
    memset(palette, 0x5a, sizeof palette);
    memset(rows, 0x5a, sizeof rows);
    memset(duals, 0x5a, sizeof duals);
    nkw_mat4 guard = palette[n];
    palette_from_models(s->models, MODELS, joints, ib, g, n, palette);
    palette_3x4_from_models(s->models, MODELS, joints, ib, g, n, rows);
    palette_dual_from_models(s->models, MODELS, joints, ib, g, n, duals);
    for (size_t i = 0; i < n; i++) {
        nkw_mat4 want = expected(s, joints, ib, g, i);
        nkw_mat3x4 want_rows = nkw_mat3x4_from_mat4(&want);
        nkw_dual_quat want_dual = nkw_dual_quat_from_mat4(&want);
        expect_floats_bits(palette[i].m, want.m, 16);
        expect_floats_bits(rows[i].m, want_rows.m, 12);
        expect_quat_bits(duals[i].real, want_dual.real);
        expect_quat_bits(duals[i].dual, want_dual.dual);
    }
    assert_memory_equal(&palette[n], &guard, sizeof palette[n]);
    assert_memory_equal(&rows[n], &guard, sizeof rows[n]);
    assert_memory_equal(&duals[n], &guard, sizeof duals[n]);
}

static void every_joint_matrix_is_the_product_of_the_single_functions(void **state)
{
    (void)state;
    random_source r = random_from(1);
    scene s;
    for (size_t n = 0; n <= COUNT; n++) {
        draw(&r, &s);
        expect_palettes(&s, s.joints, s.inverse_bind, &s.global_inverse, n);
        expect_palettes(&s, s.joints, s.inverse_bind, NULL, n);
        expect_palettes(&s, s.joints, NULL, &s.global_inverse, n);
        expect_palettes(&s, NULL, s.inverse_bind, &s.global_inverse, n);
        expect_palettes(&s, NULL, NULL, NULL, n);
    }
}

static void joints_that_no_model_has_give_the_identity(void **state)
{
    (void)state;
    random_source r = random_from(2);
    scene s;
    draw(&r, &s);
    s.joints[0] = -1;
    s.joints[7] = MODELS;
    s.joints[16] = INT32_MIN;
    s.joints[17] = INT32_MAX;
    s.joints[COUNT - 1] = MODELS + 1;
    expect_palettes(&s, s.joints, s.inverse_bind, &s.global_inverse, COUNT);
    nkw_mat4 out[3], one = nkw_mat4_identity();
    palette_from_models(NULL, 0, NULL, s.inverse_bind, &s.global_inverse, 3, out);
    for (int i = 0; i < 3; i++)
        expect_floats_bits(out[i].m, one.m, 16);
}

static void last_rows_are_not_read_and_come_out_exact(void **state)
{
    (void)state;
    random_source r = random_from(3);
    scene s, bad;
    nkw_mat4 out[MODELS], want[MODELS];
    nkw_mat3 normals[MODELS], want_normals[MODELS];
    nkw_dual_quat duals[MODELS], want_duals[MODELS];
    draw(&r, &s);
    bad = s;
    for (int k = 3; k < 16; k += 4) {
        bad.global_inverse.m[k] = NAN;
        for (int i = 0; i < MODELS; i++)
            bad.models[i].m[k] = bad.inverse_bind[i].m[k] = k == 7 ? INFINITY : NAN;
    }
    palette_from_models(s.models, MODELS, NULL, s.inverse_bind, &s.global_inverse, MODELS, want);
    palette_from_models(bad.models, MODELS, NULL, bad.inverse_bind, &bad.global_inverse, MODELS, out);
    expect_floats_bits(out[0].m, want[0].m, 16 * MODELS);
    palette_from_models(bad.models, MODELS, NULL, NULL, NULL, MODELS, out);
    expect_floats_bits(out[0].m, s.models[0].m, 16 * MODELS);
    palette_normals(bad.models, MODELS, normals);
    palette_normals(s.models, MODELS, want_normals);
    expect_floats_bits(normals[0].m, want_normals[0].m, 9 * MODELS);
    palette_dual_from_models(bad.models, MODELS, NULL, NULL, NULL, MODELS, duals);
    palette_dual_from_models(s.models, MODELS, NULL, NULL, NULL, MODELS, want_duals);
    assert_memory_equal(duals, want_duals, sizeof duals);
}

static void a_palette_may_be_written_over_its_models_or_inverse_binds(void **state)
{
    (void)state;
    random_source r = random_from(4);
    scene s;
    nkw_mat4 want[COUNT], over[COUNT];
    draw(&r, &s);
    palette_from_models(s.models, MODELS, s.joints, s.inverse_bind, &s.global_inverse, COUNT, want);
    memcpy(over, s.inverse_bind, sizeof over);
    palette_from_models(s.models, MODELS, s.joints, over, &s.global_inverse, COUNT, over);
    expect_floats_bits(over[0].m, want[0].m, 16 * COUNT);
    palette_from_models(s.models, MODELS, NULL, s.inverse_bind, &s.global_inverse, MODELS, want);
    palette_from_models(s.models, MODELS, NULL, s.inverse_bind, &s.global_inverse, MODELS, s.models);
    expect_floats_bits(s.models[0].m, want[0].m, 16 * MODELS);
}

static void the_bind_pose_has_the_identity_as_its_palette(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (int round = 0; round < 200; round++) {
        scene s;
        nkw_mat4 out[COUNT], one = nkw_mat4_identity();
        const nkw_mat4 *g = round % 2 ? &s.global_inverse : NULL;
        draw(&r, &s);
        inverse_bind_from_models(s.models, MODELS, s.joints, g, COUNT, s.inverse_bind);
        palette_from_models(s.models, MODELS, s.joints, s.inverse_bind, g, COUNT, out);
        for (int i = 0; i < COUNT; i++)
            expect_floats_near(out[i].m, one.m, 16, 1.5e-5);
    }
}

static void inverse_binds_are_the_inverses_and_zeros_where_there_is_none(void **state)
{
    (void)state;
    random_source r = random_from(6);
    scene s;
    nkw_mat4 out[COUNT], zero = {{0}}, one = nkw_mat4_identity(), in_place[MODELS];
    draw(&r, &s);
    s.joints[3] = 5;
    s.joints[4] = -7;
    for (int k = 4; k < 8; k++)
        s.models[5].m[k] = 0.0f;
    inverse_bind_from_models(s.models, MODELS, s.joints, &s.global_inverse, COUNT, out);
    expect_floats_near(out[3].m, zero.m, 16, 0.0);
    expect_floats_near(out[4].m, one.m, 16, 0.0);
    nkw_mat4 m = nkw_mat4_mul_affine(&s.global_inverse, &s.models[s.joints[20]]), want = nkw_mat4_inverse_affine(&m);
    expect_floats_bits(out[20].m, want.m, 16);
    memcpy(in_place, s.models, sizeof in_place);
    inverse_bind_from_models(in_place, MODELS, NULL, NULL, MODELS, in_place);
    want = nkw_mat4_inverse_affine(&s.models[MODELS - 1]);
    expect_floats_bits(in_place[MODELS - 1].m, want.m, 16);
}

static void inverse_binds_are_those_of_the_single_function_at_every_count(void **state)
{
    (void)state;
    random_source r = random_from(16);
    for (size_t n = 0; n <= COUNT; n++) {
        nkw_mat4 models[COUNT], out[COUNT + 1], guard;
        memset(out, 0x5a, sizeof out);
        guard = out[0];
        for (size_t i = 0; i < n; i++)
            models[i] = draw_matrix(&r, i % 3 ? 0.1f : -2.0f, 2.0f);
        for (size_t k = 4; k < 8; k++)
            models[n / 2 % COUNT].m[k] = 0.0f;
        inverse_bind_from_models(models, n, NULL, NULL, n, out);
        for (size_t i = 0; i < n; i++) {
            nkw_mat4 want = nkw_mat4_inverse_affine(&models[i]);
            expect_floats_bits(out[i].m, want.m, 16);
        }
        assert_memory_equal(&out[n], &guard, sizeof guard);
    }
}

static void normals_are_those_of_the_single_function_in_three_forms(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (size_t n = 0; n <= COUNT; n++) {
        nkw_mat4 palette[COUNT];
        nkw_mat3 normals[COUNT + 1];
        nkw_mat3x4 rows[COUNT + 1];
        float columns[12 * (COUNT + 1)];
        memset(normals, 0x5a, sizeof normals);
        memset(rows, 0x5a, sizeof rows);
        memset(columns, 0x5a, sizeof columns);
        nkw_mat3x4 guard = rows[0];
        for (size_t i = 0; i < n; i++)
            palette[i] = draw_matrix(&r, i % 3 ? 0.1f : -2.0f, 2.0f);
        for (size_t k = 0; k < 12; k++)
            palette[n / 2 % COUNT].m[k] *= k / 4 == 1 ? 0.0f : 1.0f;
        palette_normals(palette, n, normals);
        palette_normals_rows(palette, n, rows);
        palette_normals_columns(palette, n, columns);
        for (size_t i = 0; i < n; i++) {
            nkw_mat3 linear = nkw_mat3_from_mat4(&palette[i]), want = nkw_mat3_normal(&linear);
            expect_floats_bits(normals[i].m, want.m, 9);
            for (size_t k = 0; k < 12; k++) {
                expect_bits(rows[i].m[k], k % 4 == 3 ? 0.0f : want.m[k % 4 * 3 + k / 4]);
                expect_bits(columns[12 * i + k], k % 4 == 3 ? 0.0f : want.m[k / 4 * 3 + k % 4]);
            }
        }
        assert_memory_equal(&normals[n], &guard, sizeof normals[n]);
        assert_memory_equal(&rows[n], &guard, sizeof rows[n]);
        assert_memory_equal(&columns[12 * n], &guard, sizeof guard);
    }
}

static void normals_stay_at_right_angles_to_turned_surfaces(void **state)
{
    (void)state;
    random_source r = random_from(8);
    for (int i = 0; i < 1000; i++) {
        nkw_mat4 m = draw_matrix(&r, 0.3f, 3);
        nkw_mat3 normal;
        nkw_vec3 u = random_direction(&r), v = random_direction(&r), n = nkw_vec3_cross(u, v);
        palette_normals(&m, 1, &normal);
        nkw_vec3 normal_now = nkw_vec3_normalize(nkw_mat3_transform(&normal, n));
        expect_near(nkw_vec3_dot(normal_now, nkw_mat4_transform_direction(&m, u)), 0.0, 4e-6);
        expect_near(nkw_vec3_dot(normal_now, nkw_mat4_transform_direction(&m, v)), 0.0, 4e-6);
    }
}

static void palettes_go_to_rows_and_duals_and_come_back(void **state)
{
    (void)state;
    random_source r = random_from(9);
    nkw_mat4 palette[COUNT], back[COUNT];
    nkw_mat3x4 rows[COUNT];
    nkw_dual_quat duals[COUNT];
    for (int i = 0; i < COUNT; i++)
        palette[i] = draw_matrix(&r, 1, 1);
    palette_3x4_from_models(palette, COUNT, NULL, NULL, NULL, COUNT, rows);
    nkw_palette_to_mat4(palette_view(NKW_PALETTE_MAT3X4, rows, COUNT), back);
    expect_floats_bits(back[0].m, palette[0].m, 16 * COUNT);
    expect_bits(rows[2].m[7], palette[2].m[13]);
    palette_dual_from_models(palette, COUNT, NULL, NULL, NULL, COUNT, duals);
    nkw_palette_to_mat4(palette_view(NKW_PALETTE_DUAL_QUAT, duals, COUNT), back);
    for (int i = 0; i < COUNT; i++)
        expect_floats_near(back[i].m, palette[i].m, 16, 3e-6);
}

/* ---- The lesson's chain, with the numbers of the floor's page ---- */

static nkw_mat4 moved_up(float y)
{
    nkw_mat4 m = nkw_mat4_identity();
    m.m[13] = y;
    return m;
}

static nkw_mat4 turned_about_x(float angle)
{
    nkw_vec3 x = {1, 0, 0};
    return nkw_mat4_from_quat(nkw_quat_from_axis_angle(x, angle));
}

static void expect_rows(const nkw_mat4 *m, const float rows[16])
{
    nkw_mat4 want = nkw_mat4_from_row_major(rows);
    expect_floats_near(m->m, want.m, 16, 0.5001e-5);
}

/* Models of the lesson's four joints, one metre apart along y, bent by +0.5 and -0.5 rad about x. */
static void bend(nkw_mat4 models[4])
{
    const float angles[4] = {0.0f, 0.5f, -0.5f, 0.0f};
    for (int i = 0; i < 4; i++) {
        nkw_mat4 step = moved_up(i ? 1.0f : 0.0f), turn = turned_about_x(angles[i]);
        nkw_mat4 local = nkw_mat4_mul_affine(&step, &turn);
        models[i] = i ? nkw_mat4_mul_affine(&models[i - 1], &local) : local;
    }
}

static void the_lessons_chain_is_model_times_inverse_bind(void **state)
{
    (void)state;
    const float angles[4] = {0.0f, 0.5f, -0.5f, 0.0f};
    nkw_mat4 bind[4], inverse_bind[4], models[4], palette[4], chain = nkw_mat4_identity();
    for (int i = 0; i < 4; i++)
        bind[i] = moved_up((float)i);
    inverse_bind_from_models(bind, 4, NULL, NULL, 4, inverse_bind);
    bend(models);
    palette_from_models(models, 4, NULL, inverse_bind, NULL, 4, palette);
    for (int i = 0; i < 4; i++) {
        nkw_mat4 t = moved_up((float)i), j = turned_about_x(angles[i]), back = moved_up(-(float)i);
        expect_floats_near(inverse_bind[i].m, back.m, 16, 0.0);
        chain = nkw_mat4_mul_affine(&chain, &t);
        chain = nkw_mat4_mul_affine(&chain, &j);
        chain = nkw_mat4_mul_affine(&chain, &back);
        expect_floats_near(palette[i].m, chain.m, 16, 1e-6);
    }
}

static void the_pages_matrices_are_these(void **state)
{
    (void)state;
    static const float model1[16] = {1, 0, 0, 0, 0, 0.87758f, -0.47943f, 1, 0, 0.47943f, 0.87758f, 0, 0, 0, 0, 1};
    static const float model2[16] = {1, 0, 0, 0, 0, 1, 0, 1.87758f, 0, 0, 1, 0.47943f, 0, 0, 0, 1};
    static const float model3[16] = {1, 0, 0, 0, 0, 1, 0, 2.87758f, 0, 0, 1, 0.47943f, 0, 0, 0, 1};
    static const float joint1[16] = {1, 0,        0,        0,         0, 0.87758f, -0.47943f, 0.12242f,
                                     0, 0.47943f, 0.87758f, -0.47943f, 0, 0,        0,         1};
    static const float joint2[16] = {1, 0, 0, 0, 0, 1, 0, -0.12242f, 0, 0, 1, 0.47943f, 0, 0, 0, 1};
    nkw_mat4 bind[4], inverse_bind[4], models[4], palette[4], one = nkw_mat4_identity();
    for (int i = 0; i < 4; i++)
        bind[i] = moved_up((float)i);
    inverse_bind_from_models(bind, 4, NULL, NULL, 4, inverse_bind);
    bend(models);
    palette_from_models(models, 4, NULL, inverse_bind, NULL, 4, palette);
    expect_rows(&models[1], model1);
    expect_rows(&models[2], model2);
    expect_rows(&models[3], model3);
    expect_floats_near(palette[0].m, one.m, 16, 0.0);
    expect_rows(&palette[1], joint1);
    expect_rows(&palette[2], joint2);
    expect_rows(&palette[3], joint2);
    nkw_vec3 elbow = {0, 2, 0}, tip = {0.5f, 3, 0}, want_elbow = {0, 1.87758f, 0.47943f},
             want_tip = {0.5f, 2.87758f, 0.47943f};
    expect_vec3_near(nkw_mat4_transform_point(&palette[1], elbow), want_elbow, 1e-5);
    expect_vec3_near(nkw_mat4_transform_point(&palette[2], elbow), want_elbow, 1e-5);
    expect_vec3_near(nkw_mat4_transform_point(&palette[3], tip), want_tip, 1e-5);
}

/* ---- Validation ---- */

static void expect_invalid(size_t models, const scene *s, const int32_t *joints, size_t n, nkw_result result,
                           size_t joint)
{
    size_t bad = 99;
    assert_int_equal(palette_source_validate(models, joints, s->inverse_bind, n, &bad), result);
    assert_int_equal(bad, joint);
    assert_int_equal(palette_source_validate(models, joints, s->inverse_bind, n, NULL), result);
}

static void validate_names_the_first_offender(void **state)
{
    (void)state;
    random_source r = random_from(10);
    scene s;
    draw(&r, &s);
    expect_invalid(MODELS, &s, s.joints, COUNT, NKW_OK, 0);
    expect_invalid(MODELS, &s, s.joints, 0, NKW_EMPTY, 0);
    expect_invalid(MODELS, &s, NULL, MODELS, NKW_OK, 0);
    expect_invalid(MODELS, &s, NULL, MODELS + 1, NKW_OUT_OF_RANGE, MODELS);
    s.inverse_bind[30].m[7] = NAN;
    expect_invalid(MODELS, &s, s.joints, COUNT, NKW_OK, 0);
    s.inverse_bind[30].m[13] = INFINITY;
    expect_invalid(MODELS, &s, s.joints, COUNT, NKW_NOT_FINITE, 30);
    s.joints[11] = MODELS;
    expect_invalid(MODELS, &s, s.joints, COUNT, NKW_OUT_OF_RANGE, 11);
    s.joints[2] = -1;
    expect_invalid(MODELS, &s, s.joints, COUNT, NKW_OUT_OF_RANGE, 2);
}

static void expect_invalid_dual(const nkw_dual_quat *palette, size_t n, nkw_result result, size_t joint)
{
    size_t bad = 99;
    assert_int_equal(nkw_palette_validate(palette_view(NKW_PALETTE_DUAL_QUAT, palette, n), &bad), result);
    assert_int_equal(bad, joint);
    assert_int_equal(nkw_palette_validate(palette_view(NKW_PALETTE_DUAL_QUAT, palette, n), NULL), result);
}

static void validate_names_the_first_bad_dual_quaternion(void **state)
{
    (void)state;
    random_source r = random_from(11);
    scene s;
    draw(&r, &s);
    static nkw_dual_quat palette[COUNT];
    palette_dual_from_models(s.models, MODELS, s.joints, s.inverse_bind, NULL, COUNT, palette);
    expect_invalid_dual(palette, COUNT, NKW_OK, 0);
    expect_invalid_dual(palette, 0, NKW_EMPTY, 0);
    palette[20].real = nkw_quat_scale(palette[20].real, 1.009f);
    expect_invalid_dual(palette, COUNT, NKW_OK, 0);
    palette[20].real = nkw_quat_scale(palette[20].real, 1.009f);
    expect_invalid_dual(palette, COUNT, NKW_NOT_UNIT, 20);
    palette[9].dual.z = INFINITY;
    expect_invalid_dual(palette, COUNT, NKW_NOT_FINITE, 9);
    palette[4].real.x = NAN;
    expect_invalid_dual(palette, COUNT, NKW_NOT_FINITE, 4);
}

/* ---- Chunks ---- */

static void expect_placed(nkw_palette_chunk *c, size_t n, size_t align, nkw_result result, size_t total,
                          size_t bad_chunk)
{
    size_t got = 99, bad = 99;
    assert_int_equal(nkw_palette_chunks_place(c, n, align, &got, &bad), result);
    assert_int_equal(got, total);
    assert_int_equal(bad, bad_chunk);
    assert_int_equal(nkw_palette_chunks_place(c, n, align, &got, NULL), result);
}

static void chunks_follow_each_other_at_multiples_of_the_alignment(void **state)
{
    (void)state;
    nkw_palette_chunk c[3] = {{3, 5, 99}, {1, 67, 99}, {30, 2, 99}};
    expect_placed(c, 3, 0, NKW_OK, 142, 0);
    assert_int_equal(c[0].first, 0);
    assert_int_equal(c[1].first, 15);
    assert_int_equal(c[2].first, 82);
    expect_placed(c, 3, 16, NKW_OK, 156, 0);
    assert_int_equal(c[1].first, 16);
    assert_int_equal(c[2].first, 96);
    expect_placed(c, 3, 15, NKW_OK, 150, 0);
    assert_int_equal(c[1].first, 15);
    assert_int_equal(c[2].first, 90);
    expect_placed(c, 0, 4, NKW_OK, 0, 0);
}

static void chunks_without_a_place_are_named(void **state)
{
    (void)state;
    const size_t most = SIZE_MAX / 64;
    nkw_palette_chunk c[3] = {{3, 5, 0}, {0, 4, 0}, {1, 1, 0}};
    expect_placed(c, 3, 1, NKW_EMPTY, 15, 1);
    c[1].frame_count = 4;
    c[1].joint_count = 0;
    expect_placed(c, 3, 1, NKW_EMPTY, 15, 1);
    c[1].joint_count = SIZE_MAX / 2;
    expect_placed(c, 3, 1, NKW_TOO_SMALL, 15, 1);
    c[1].frame_count = most - 15;
    c[1].joint_count = 1;
    expect_placed(c, 3, 1, NKW_TOO_SMALL, most, 2);
    expect_placed(c, 2, 1, NKW_OK, most, 0);
    c[1].frame_count = 1;
    expect_placed(c, 2, SIZE_MAX, NKW_TOO_SMALL, 15, 1);
}

static void expect_invalid_chunks(const nkw_palette_chunk *c, size_t n, size_t total, nkw_result result, size_t chunk)
{
    size_t bad = 99;
    assert_int_equal(nkw_palette_chunks_validate(c, n, total, &bad), result);
    assert_int_equal(bad, chunk);
    assert_int_equal(nkw_palette_chunks_validate(c, n, total, NULL), result);
}

static void validate_names_the_first_bad_chunk(void **state)
{
    (void)state;
    nkw_palette_chunk c[3] = {{3, 5, 0}, {1, 67, 0}, {30, 2, 0}};
    size_t total;
    assert_int_equal(nkw_palette_chunks_place(c, 3, 16, &total, NULL), NKW_OK);
    expect_invalid_chunks(c, 3, total, NKW_OK, 0);
    expect_invalid_chunks(c, 0, 0, NKW_OK, 0);
    expect_invalid_chunks(c, 3, total - 1, NKW_OUT_OF_RANGE, 2);
    c[2].first = total + 1;
    expect_invalid_chunks(c, 3, total, NKW_OUT_OF_RANGE, 2);
    c[2].first = 82;
    expect_invalid_chunks(c, 3, total, NKW_REPEATED, 2);
    c[2].first = 83;
    expect_invalid_chunks(c, 3, total, NKW_OK, 0);
    c[1].frame_count = SIZE_MAX;
    expect_invalid_chunks(c, 3, SIZE_MAX, NKW_OUT_OF_RANGE, 1);
    c[1].frame_count = 0;
    expect_invalid_chunks(c, 3, total, NKW_EMPTY, 1);
    c[0].joint_count = 0;
    expect_invalid_chunks(c, 3, total, NKW_EMPTY, 0);
}

static void every_place_in_a_chunk_is_its_own(void **state)
{
    (void)state;
    nkw_palette_chunk c[3] = {{3, 5, 0}, {1, 7, 0}, {4, 2, 0}};
    size_t total, seen[64] = {0};
    assert_int_equal(nkw_palette_chunks_place(c, 3, 4, &total, NULL), NKW_OK);
    for (int i = 0; i < 3; i++) {
        for (size_t f = 0; f < c[i].frame_count; f++)
            for (size_t j = 0; j < c[i].joint_count; j++) {
                size_t place = c[i].first + f * c[i].joint_count + j;
                assert_in_range(place, c[i].first, total - 1);
                assert_int_equal(seen[place]++, 0);
            }
    }
}

/* |s - 1|, 2 of a mirror, 0 of rigid joints and of a joint without a model; the first of the largest. */
static void the_residual_is_what_dual_quaternions_drop(void **state)
{
    (void)state;
    random_source r = random_from(12);
    scene s;
    size_t bad = 9;
    for (int i = 0; i < MODELS; i++)
        s.models[i] = draw_matrix(&r, 1, 1);
    nkw_palette_source source = {s.models, MODELS, NULL, NULL, NULL, MODELS};
    assert_true(nkw_palette_residual(&source, NULL) < 5e-7f);
    for (int n = 0; n < 100; n++) {
        const float scale = random_between(&r, 0, 3);
        s.models[7] = draw_matrix(&r, scale, scale);
        expect_near(nkw_palette_residual(&source, &bad), fabs((double)scale - 1), 1e-6);
        assert_int_equal(bad, fabsf(scale - 1) > 1e-6f ? 7 : bad);
    }
    s.models[9] = draw_matrix(&r, -1, -1);
    s.models[7] = draw_matrix(&r, 3.5f, 3.5f);
    const int32_t joints[3] = {9, 7, -1};
    source.joints = joints;
    source.joint_count = 3;
    expect_near(nkw_palette_residual(&source, &bad), 2.5, 2e-6);
    assert_int_equal(bad, 1);
    source.joint_count = 1;
    expect_near(nkw_palette_residual(&source, &bad), 2, 2e-6);
    for (int i = 0; i < MODELS; i++)
        s.inverse_bind[i] = nkw_mat4_inverse_affine(&s.models[i]);
    source = (nkw_palette_source){s.models, MODELS, NULL, s.inverse_bind, NULL, MODELS};
    assert_true(nkw_palette_residual(&source, NULL) < 3e-6f);
    s.models[4].m[5] = NAN;
    assert_true(isnan(nkw_palette_residual(&source, &bad)));
    assert_int_equal(bad, 4);
    source.joint_count = 0;
    expect_bits(nkw_palette_residual(&source, &bad), 0);
    assert_int_equal(bad, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_joint_matrix_is_the_product_of_the_single_functions),
        cmocka_unit_test(joints_that_no_model_has_give_the_identity),
        cmocka_unit_test(last_rows_are_not_read_and_come_out_exact),
        cmocka_unit_test(a_palette_may_be_written_over_its_models_or_inverse_binds),
        cmocka_unit_test(the_bind_pose_has_the_identity_as_its_palette),
        cmocka_unit_test(inverse_binds_are_the_inverses_and_zeros_where_there_is_none),
        cmocka_unit_test(inverse_binds_are_those_of_the_single_function_at_every_count),
        cmocka_unit_test(normals_are_those_of_the_single_function_in_three_forms),
        cmocka_unit_test(normals_stay_at_right_angles_to_turned_surfaces),
        cmocka_unit_test(palettes_go_to_rows_and_duals_and_come_back),
        cmocka_unit_test(the_lessons_chain_is_model_times_inverse_bind),
        cmocka_unit_test(the_pages_matrices_are_these),
        cmocka_unit_test(validate_names_the_first_offender),
        cmocka_unit_test(validate_names_the_first_bad_dual_quaternion),
        cmocka_unit_test(chunks_follow_each_other_at_multiples_of_the_alignment),
        cmocka_unit_test(chunks_without_a_place_are_named),
        cmocka_unit_test(validate_names_the_first_bad_chunk),
        cmocka_unit_test(every_place_in_a_chunk_is_its_own),
        cmocka_unit_test(the_residual_is_what_dual_quaternions_drop),
    };
    return cmocka_run_group_tests_name("palette", tests, NULL, NULL);
}
