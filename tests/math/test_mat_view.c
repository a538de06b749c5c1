/* SPDX-License-Identifier: MIT */
/* Cameras and the makers of matrices. */
#include <math.h>

#include "support/expect.h"

#define QUARTER 1.57079633f

static nkw_vec3 vec(float x, float y, float z)
{
    nkw_vec3 v = {x, y, z};
    return v;
}

static void expect_point(const nkw_mat4 *m, nkw_vec3 p, nkw_vec3 expected, double tolerance)
{
    expect_vec3_near(nkw_mat4_transform_point(m, p), expected, tolerance);
}

static void translation_scale_and_rotation_move_a_point(void **state)
{
    (void)state;
    nkw_mat4 t = nkw_mat4_from_translation(vec(1, 2, 3)), s = nkw_mat4_from_scale(vec(2, 3, 4));
    nkw_mat4 r = nkw_mat4_from_axis_angle(vec(0, 0, 2), QUARTER);
    expect_point(&t, vec(10, 20, 30), vec(11, 22, 33), 0);
    expect_point(&s, vec(1, 1, 1), vec(2, 3, 4), 0);
    expect_point(&r, vec(1, 0, 5), vec(0, 1, 5), 1e-6);
    nkw_mat4 none = nkw_mat4_from_axis_angle(vec(0, 0, 0), 1.0f), identity = nkw_mat4_identity();
    assert_true(nkw_mat4_equal_within(&none, &identity, 0.0f));
}

/* OpenGL Programming Guide, gluLookAt(4, 2, 1, 2, 4, -3, 2, 2, -1), by its formulas in binary64. */
static void look_at_by_its_definition(void **state)
{
    (void)state;
    nkw_vec3 eye = vec(4, 2, 1), target = vec(2, 4, -3), up = vec(2, 2, -1);
    nkw_mat4 view = nkw_mat4_look_at(eye, target, up);
    double f[3] = {-2 / sqrt(24), 2 / sqrt(24), -4 / sqrt(24)};
    double s[3] = {f[1] * -1 - f[2] * 2, f[2] * 2 - f[0] * -1, f[0] * 2 - f[1] * 2};
    double length = sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
    for (int i = 0; i < 3; i++)
        s[i] /= length;
    double u[3] = {s[1] * f[2] - s[2] * f[1], s[2] * f[0] - s[0] * f[2], s[0] * f[1] - s[1] * f[0]};
    const double e[3] = {4, 2, 1};
    const double *row[3] = {s, u, f};
    for (int i = 0; i < 3; i++) {
        double sign = i == 2 ? -1 : 1, sum = 0;
        for (int k = 0; k < 3; k++) {
            assert_true(fabs((double)view.m[4 * k + i] - sign * row[i][k]) < 3e-7);
            sum += sign * row[i][k] * e[k];
        }
        assert_true(fabs((double)view.m[12 + i] + sum) < 1e-6);
    }
    expect_point(&view, eye, vec(0, 0, 0), 1e-6);
    expect_point(&view, target, vec(0, 0, -sqrtf(24)), 1e-6);
}

static void look_at_of_no_direction_is_a_translation(void **state)
{
    (void)state;
    nkw_mat4 view = nkw_mat4_look_at(vec(1, 2, 3), vec(1, 2, 3), vec(0, 1, 0));
    nkw_mat4 back = nkw_mat4_from_translation(vec(-1, -2, -3));
    assert_true(nkw_mat4_equal_within(&view, &back, 0.0f));
}

/* A camera that looks straight up, with `up` along its direction, still has a rotation. */
static void look_at_along_up_is_a_rotation(void **state)
{
    (void)state;
    nkw_mat4 view = nkw_mat4_look_at(vec(0, 0, 0), vec(0, 5, 0), vec(0, 1, 0));
    nkw_mat4 back = nkw_mat4_transpose(&view), product = nkw_mat4_mul(&view, &back), identity = nkw_mat4_identity();
    assert_true(nkw_mat4_equal_within(&product, &identity, 1e-6f));
    expect_point(&view, vec(0, 5, 0), vec(0, 0, -5), 1e-6);
}

/* The clip coordinates of a point of the camera's space, divided by w. */
static nkw_vec3 seen(const nkw_mat4 *m, float x, float y, float z)
{
    return nkw_mat4_project_point(m, vec(x, y, z));
}

static const struct depth_case {
    nkw_graphics graphics;
    int reversed_z;
    float top, near_depth, far_depth;
} depth_cases[] = {
    {NKW_GRAPHICS_GL, 0, 1, -1, 1},    {NKW_GRAPHICS_GL, 1, 1, 1, -1},     {NKW_GRAPHICS_D3D, 0, 1, 0, 1},
    {NKW_GRAPHICS_D3D, 1, 1, 1, 0},    {NKW_GRAPHICS_VULKAN, 0, -1, 0, 1}, {NKW_GRAPHICS_VULKAN, 1, -1, 1, 0},
};
#define DEPTH_CASES (sizeof depth_cases / sizeof depth_cases[0])

/* A field of view of 90 degrees: at z = -d, the image has the height 2 d. */
static void perspective_maps_the_visible_volume_to_the_clip_space(void **state)
{
    (void)state;
    for (size_t i = 0; i < DEPTH_CASES; i++) {
        const struct depth_case *c = &depth_cases[i];
        nkw_perspective camera = {QUARTER, 2.0f, 0.5f, 200.0f, c->graphics, c->reversed_z};
        nkw_mat4 m = nkw_mat4_from_perspective(&camera);
        expect_vec3_near(seen(&m, 1.0f, 0.5f, -0.5f), vec(1, c->top, c->near_depth), 1e-6);
        expect_vec3_near(seen(&m, -400.0f, -200.0f, -200.0f), vec(-1, -c->top, c->far_depth), 1e-6);
    }
}

static void a_camera_without_a_farthest_plane_is_the_limit(void **state)
{
    (void)state;
    for (size_t i = 0; i < DEPTH_CASES; i++) {
        const struct depth_case *c = &depth_cases[i];
        nkw_perspective camera = {1.0f, 1.5f, 0.1f, INFINITY, c->graphics, c->reversed_z}, finite = camera;
        finite.far_z = 1e20f;
        nkw_mat4 m = nkw_mat4_from_perspective(&camera), near_it = nkw_mat4_from_perspective(&finite);
        assert_true(nkw_mat4_equal_within(&m, &near_it, 1e-20f));
        expect_vec3_near(seen(&m, 0.0f, 0.0f, -0.1f), vec(0, 0, c->near_depth), 1e-6);
        expect_vec3_near(seen(&m, 0.0f, 0.0f, -1e9f), vec(0, 0, c->far_depth), 1e-6);
    }
}

/* glm::perspective(1, 1.5, 0.1, 100) and glm::perspectiveZO by their formulas in binary64. */
static void perspective_has_the_elements_of_its_formula(void **state)
{
    (void)state;
    nkw_perspective camera = {1.0f, 1.5f, 0.1f, 100.0f, NKW_GRAPHICS_GL, 0};
    double n = (double)0.1f, f = 100, c = 1 / tan(0.5);
    nkw_mat4 m = nkw_mat4_from_perspective(&camera);
    expect_bits(m.m[0], (float)(c / 1.5));
    expect_bits(m.m[5], (float)c);
    expect_bits(m.m[10], (float)(-(f + n) / (f - n)));
    expect_bits(m.m[14], (float)(-2 * f * n / (f - n)));
    expect_bits(m.m[11], -1.0f);
    camera.graphics = NKW_GRAPHICS_D3D;
    m = nkw_mat4_from_perspective(&camera);
    expect_bits(m.m[10], (float)(-f / (f - n)));
    expect_bits(m.m[14], (float)(-f * n / (f - n)));
}

static void what_is_no_camera_is_the_zero_matrix(void **state)
{
    (void)state;
    const nkw_perspective wrong[] = {
        {0, 1, 1, 2, NKW_GRAPHICS_GL, 0},        {3.2f, 1, 1, 2, NKW_GRAPHICS_GL, 0},  {1, 0, 1, 2, NKW_GRAPHICS_GL, 0},
        {1, INFINITY, 1, 2, NKW_GRAPHICS_GL, 0}, {1, 1, 0, 2, NKW_GRAPHICS_GL, 0},     {1, 1, 2, 2, NKW_GRAPHICS_GL, 0},
        {1, 1, 1, NAN, NKW_GRAPHICS_GL, 0},      {1, 1, 1, 2, (nkw_graphics)3, 0},     {NAN, 1, 1, 2, NKW_GRAPHICS_GL, 0},
        {1, 1, INFINITY, INFINITY, NKW_GRAPHICS_GL, 0},
    };
    nkw_mat4 zero = {{0}};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        nkw_mat4 m = nkw_mat4_from_perspective(&wrong[i]);
        assert_memory_equal(&m, &zero, sizeof m);
    }
    const nkw_orthographic flat[] = {
        {1, 1, -1, 1, 0, 1, NKW_GRAPHICS_GL, 0}, {-1, 1, 2, 2, 0, 1, NKW_GRAPHICS_GL, 0},
        {-1, 1, -1, 1, 3, 3, NKW_GRAPHICS_GL, 0}, {-1, NAN, -1, 1, 0, 1, NKW_GRAPHICS_GL, 0},
        {-1, 1, -1, 1, 0, INFINITY, NKW_GRAPHICS_GL, 0}, {-1, 1, -1, 1, 0, 1, (nkw_graphics)-1, 0},
    };
    for (size_t i = 0; i < sizeof flat / sizeof flat[0]; i++) {
        nkw_mat4 m = nkw_mat4_from_orthographic(&flat[i]);
        assert_memory_equal(&m, &zero, sizeof m);
    }
}

static void orthographic_maps_its_box_to_the_clip_space(void **state)
{
    (void)state;
    for (size_t i = 0; i < DEPTH_CASES; i++) {
        const struct depth_case *c = &depth_cases[i];
        nkw_orthographic camera = {-4, 8, -1, 3, -5, 45, c->graphics, c->reversed_z};
        nkw_mat4 m = nkw_mat4_from_orthographic(&camera);
        expect_vec3_near(seen(&m, 8, 3, 5), vec(1, c->top, c->near_depth), 1e-6);
        expect_vec3_near(seen(&m, -4, -1, -45), vec(-1, -c->top, c->far_depth), 1e-6);
    }
}

static void equal_within_compares_every_element(void **state)
{
    (void)state;
    nkw_mat4 a = nkw_mat4_identity(), b = a;
    for (int i = 0; i < 16; i++) {
        b.m[i] = a.m[i] + 0.5f;
        assert_true(nkw_mat4_equal_within(&a, &b, 0.5f));
        assert_false(nkw_mat4_equal_within(&a, &b, 0.4f));
        b.m[i] = NAN;
        assert_false(nkw_mat4_equal_within(&a, &b, INFINITY));
        b.m[i] = a.m[i];
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(translation_scale_and_rotation_move_a_point),
        cmocka_unit_test(look_at_by_its_definition),
        cmocka_unit_test(look_at_of_no_direction_is_a_translation),
        cmocka_unit_test(look_at_along_up_is_a_rotation),
        cmocka_unit_test(perspective_maps_the_visible_volume_to_the_clip_space),
        cmocka_unit_test(a_camera_without_a_farthest_plane_is_the_limit),
        cmocka_unit_test(perspective_has_the_elements_of_its_formula),
        cmocka_unit_test(what_is_no_camera_is_the_zero_matrix),
        cmocka_unit_test(orthographic_maps_its_box_to_the_clip_space),
        cmocka_unit_test(equal_within_compares_every_element),
    };
    return cmocka_run_group_tests_name("mat_view", tests, NULL, NULL);
}
