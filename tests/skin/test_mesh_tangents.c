/* SPDX-License-Identifier: MIT */
/* Hand-made surfaces. The reference itself is compared in tests/wasm/mikktspace.test.mjs. */
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/solids.h"
#include "support/views.h"

enum { CORNERS = 3 * SOLID_TRIANGLES };

static unsigned char memory[NKW_MESH_WORK(SOLID_TRIANGLES) + 16];
static float tangents[4 * CORNERS];
static nkw_vec3 bitangents[CORNERS];

static void make_tangents(const nkw_mesh *mesh, const nkw_vec3 *normals, const float *texcoords)
{
    const nkw_mesh_surface surface = {normals, texcoords};
    size_t bad = 99;
    memset(memory, 0xa5, sizeof memory);
    memset(tangents, 0xa5, sizeof tangents);
    assert_int_equal(nkw_mesh_tangents(mesh, surface, tangents, bitangents, &bad,
                                       work_in(memory, NKW_MESH_WORK(mesh->triangle_count) + 15)),
                     NKW_OK);
    assert_int_equal(bad, 0);
}

static void expect_frame(size_t corner, nkw_vec3 t, float sign, nkw_vec3 b, double bound)
{
    const float *got = tangents + 4 * corner;
    expect_floats_near(got, &t.x, 3, bound);
    expect_bits(got[3], sign);
    expect_vec3_near(bitangents[corner], b, bound);
}

static const nkw_vec3 quad[] = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
static const uint32_t quad_indices[] = {0, 1, 2, 0, 2, 3};
static const nkw_vec3 up[] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
static const nkw_vec3 x_axis = {1, 0, 0}, y_axis = {0, 1, 0};

static void a_quad_has_the_directions_of_its_texture(void **state)
{
    (void)state;
    const nkw_mesh mesh = {quad, 4, quad_indices, 2};
    const nkw_vec3 left = {-1, 0, 0}, down = {0, -1, 0}, d = {0.70710678f, 0.70710678f, 0};
    const struct {
        float uv[8];
        nkw_vec3 t, b;
        float sign;
    } cases[] = {
        {{0, 0, 1, 0, 1, 1, 0, 1}, x_axis, y_axis, 1},
        {{1, 0, 0, 0, 0, 1, 1, 1}, left, y_axis, -1}, /* mirrored */
        {{0, 1, 1, 1, 1, 0, 0, 0}, x_axis, down, -1}, /* v downward, as in glTF */
        {{0, 0, 0, 1, 1, 1, 1, 0}, y_axis, x_axis, -1}, /* u and v exchanged */
        {{0, 0, 0, -1, 1, -1, 1, 0}, y_axis, left, 1}, /* a quarter turn */
        {{0, 0, 200, -200, 300, -100, 100, 100}, d, {-0.70710678f, 0.70710678f, 0}, 1},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        make_tangents(&mesh, up, cases[k].uv);
        for (size_t c = 0; c < 6; c++)
            expect_frame(c, cases[k].t, cases[k].sign, cases[k].b, 6e-8);
    }
}

/* Two quads side by side, the second mirrored: the shared edge has the same texture coordinates, but not a tangent. */
static void a_mirrored_half_has_its_own_tangents(void **state)
{
    (void)state;
    const nkw_vec3 positions[] = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 1, 0}, {0, 1, 0}, {1, 1, 0}};
    const nkw_vec3 normals[] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    const uint32_t indices[] = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
    const float uv[] = {0, 0, 1, 0, 0, 0, 0, 1, 1, 1, 0, 1};
    const nkw_mesh mesh = {positions, 6, indices, 4};
    const nkw_vec3 left = {-1, 0, 0};
    make_tangents(&mesh, normals, uv);
    for (size_t c = 0; c < 12; c++)
        expect_frame(c, c < 6 ? x_axis : left, c < 6 ? 1.0f : -1.0f, y_axis, 6e-8);
}

/*
 * Two triangles of 45 and 90 degrees at a shared vertex, their slopes 0 and 90 degrees from x:
 * t = (45, 90) / |(45, 90)| there. Positions, normals and texture coordinates agree along the edge.
 */
static void slopes_are_weighted_by_angle(void **state)
{
    (void)state;
    const nkw_vec3 positions[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 1, 0}};
    const uint32_t indices[] = {0, 1, 2, 0, 2, 3};
    /* In the first triangle u = x, v = y. In the second u = y, and v = 1 at (1, 1), 3 at (-1, 1): v = 2 y - x. */
    const float uv[] = {0, 0, 1, 0, 1, 1, 1, 3};
    const nkw_mesh mesh = {positions, 4, indices, 2};
    make_tangents(&mesh, up, uv);
    /* dP/du of the second: the direction with dv = 0, 2 dy = dx, projected on u = y: (2, 1) / sqrt 5. */
    const double a = 0.25, b = 0.5, x = a + b * 2 / sqrt(5.0), y = b / sqrt(5.0), l = sqrt(x * x + y * y);
    const nkw_vec3 t = {(float)(x / l), (float)(y / l), 0}, n = {-t.y, t.x, 0};
    expect_frame(0, t, 1, n, 1e-7);
    expect_frame(3, t, 1, n, 1e-7);
    expect_frame(1, x_axis, 1, y_axis, 1e-7);
}

static void a_seam_separates_tangents(void **state)
{
    (void)state;
    /* The same two triangles, the second with u + 5: no vertex is shared. */
    const nkw_vec3 positions[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {-1, 1, 0}};
    const nkw_vec3 normals[] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    const float uv[] = {0, 0, 1, 0, 1, 1, 5, 0, 6, 1, 6, 3};
    const nkw_mesh mesh = {positions, 6, NULL, 2};
    const nkw_vec3 t = {(float)(2 / sqrt(5.0)), (float)(1 / sqrt(5.0)), 0}, n = {-t.y, t.x, 0};
    make_tangents(&mesh, normals, uv);
    for (size_t c = 0; c < 6; c++)
        expect_frame(c, c < 3 ? x_axis : t, 1, c < 3 ? y_axis : n, 1e-7);
}

static void tangents_are_in_the_plane_of_the_normal(void **state)
{
    (void)state;
    random_source r = random_from(7);
    for (int round = 0; round < 200; round++) {
        nkw_vec3 normals[4];
        const float uv[] = {0, 0, 1, 0.2f, 1.3f, 1, -0.1f, 1};
        const nkw_mesh mesh = {quad, 4, quad_indices, 2};
        for (int i = 0; i < 4; i++)
            normals[i] = nkw_vec3_scale(nkw_vec3_add(up[i], random_vec3(&r, -0.7f, 0.7f)), random_between(&r, 0.1f, 9));
        make_tangents(&mesh, normals, uv);
        for (size_t c = 0; c < 6; c++) {
            const nkw_vec3 n = nkw_vec3_normalize(normals[quad_indices[c]]);
            const nkw_vec3 t = {tangents[4 * c], tangents[4 * c + 1], tangents[4 * c + 2]};
            expect_near((double)nkw_vec3_dot(n, t), 0, 2e-7);
            expect_near((double)nkw_vec3_length(t), 1, 2e-7);
            expect_vec3_near(bitangents[c], nkw_vec3_cross(n, t), 4e-7);
        }
    }
}

static void what_has_no_slope_takes_the_tangent_of_its_neighbours(void **state)
{
    (void)state;
    /* A textured triangle; one without texture area beside it; a collapsed one; one far from all. */
    const nkw_vec3 positions[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {5, 5, 5}, {6, 5, 5}, {5, 6, 5}};
    const nkw_vec3 normals[] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    const float uv[] = {0, 0, -1, 0, 0, 1, -2, 2, 3, 3, 3, 3, 3, 3};
    const uint32_t indices[] = {1, 3, 2, 0, 0, 2, 0, 1, 2, 4, 5, 6};
    float flat[14];
    memcpy(flat, uv, sizeof flat);
    flat[6] = -0.5f; /* (1, 1) is halfway between the texture coordinates of (1, 0) and (0, 1): no area */
    flat[7] = 0.5f;
    const nkw_mesh mesh = {positions, 7, indices, 4};
    const nkw_vec3 left = {-1, 0, 0}, down = {0, -1, 0};
    make_tangents(&mesh, normals, flat);
    for (size_t c = 6; c < 9; c++)
        expect_frame(c, left, -1, y_axis, 0); /* the sound one: mirrored */
    expect_frame(0, left, -1, y_axis, 0);
    expect_frame(2, left, -1, y_axis, 0);
    expect_frame(1, x_axis, -1, down, 0); /* its third corner: no group reaches it */
    for (size_t c = 3; c < 6; c++)
        expect_frame(c, left, -1, y_axis, 0);
    for (size_t c = 9; c < 12; c++)
        expect_frame(c, x_axis, -1, down, 0);
}

static void faults_have_their_triangle(void **state)
{
    (void)state;
    const nkw_mesh mesh = {quad, 4, quad_indices, 2};
    float uv[8] = {0};
    nkw_vec3 normals[4];
    memcpy(normals, up, sizeof normals);
    const nkw_mesh_surface surface = {normals, uv};
    const nkw_work work = work_in(memory, sizeof memory), less = {work.data, NKW_MESH_WORK(2) - 1};
    size_t bad = 99;
    tangents[0] = 77;
    assert_int_equal(nkw_mesh_tangents(&mesh, surface, tangents, NULL, &bad, less), NKW_TOO_SMALL);
    uv[7] = NAN;
    assert_int_equal(nkw_mesh_tangents(&mesh, surface, tangents, NULL, &bad, work), NKW_NOT_FINITE);
    assert_int_equal(bad, 1);
    normals[1].x = INFINITY;
    assert_int_equal(nkw_mesh_tangents(&mesh, surface, tangents, NULL, &bad, work), NKW_NOT_FINITE);
    assert_int_equal(bad, 0);
    const nkw_mesh few = {quad, 3, quad_indices, 2};
    assert_int_equal(nkw_mesh_tangents(&few, surface, tangents, NULL, &bad, work), NKW_OUT_OF_RANGE);
    assert_int_equal(bad, 1);
    assert_true(tangents[0] == 77);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_quad_has_the_directions_of_its_texture),
        cmocka_unit_test(a_mirrored_half_has_its_own_tangents),
        cmocka_unit_test(slopes_are_weighted_by_angle),
        cmocka_unit_test(a_seam_separates_tangents),
        cmocka_unit_test(tangents_are_in_the_plane_of_the_normal),
        cmocka_unit_test(what_has_no_slope_takes_the_tangent_of_its_neighbours),
        cmocka_unit_test(faults_have_their_triangle),
    };
    return cmocka_run_group_tests_name("mesh_tangents", tests, NULL, NULL);
}
