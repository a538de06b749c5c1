/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/solids.h"
#include "support/views.h"

#define PI     3.14159265f
#define DEGREE (PI / 180)

enum { WORK = NKW_MESH_WORK(SOLID_TRIANGLES) };

static unsigned char memory[WORK + 16];
static nkw_vec3 normals[3 * SOLID_TRIANGLES];

static nkw_vec3 vec3(float x, float y, float z)
{
    nkw_vec3 v = {x, y, z};
    return v;
}

static void make_normals(const nkw_mesh *mesh, float crease)
{
    size_t bad = 99;
    memset(memory, 0xa5, sizeof memory);
    memset(normals, 0xa5, sizeof normals);
    assert_int_equal(
        nkw_mesh_normals(mesh, crease, normals, &bad, work_in(memory, NKW_MESH_WORK(mesh->triangle_count) + 16)),
        NKW_OK);
    assert_int_equal(bad, 0);
}

static nkw_vec3 face_normal(const nkw_mesh *mesh, size_t triangle)
{
    const uint32_t *i = mesh->indices + 3 * triangle;
    nkw_vec3 u = nkw_vec3_sub(mesh->positions[i[1]], mesh->positions[i[0]]);
    nkw_vec3 v = nkw_vec3_sub(mesh->positions[i[2]], mesh->positions[i[0]]);
    return nkw_vec3_normalize(nkw_vec3_cross(u, v));
}

/* ---- normals ---- */

static void a_cube_below_the_crease_of_90_degrees_has_the_normals_of_its_faces(void **state)
{
    (void)state;
    solid s;
    const float creases[] = {0, 45 * DEGREE, 89.9f * DEGREE};
    solid_cube(&s, 0x15);
    const nkw_mesh mesh = solid_mesh(&s);
    for (int k = 0; k < 3; k++) {
        make_normals(&mesh, creases[k]);
        for (size_t c = 0; c < 36; c++)
            expect_vec3_near(normals[c], face_normal(&mesh, c / 3), 0);
    }
}

/* Whatever the diagonals: three triangles at one corner, five or six at another. */
static void a_smooth_cube_has_the_normals_of_its_diagonals(void **state)
{
    (void)state;
    const float creases[] = {90 * DEGREE, 100 * DEGREE, PI, 10, INFINITY};
    for (unsigned diagonals = 0; diagonals < 64; diagonals++) {
        solid s;
        solid_cube(&s, diagonals);
        const nkw_mesh mesh = solid_mesh(&s);
        for (int k = 0; k < 5; k++) {
            make_normals(&mesh, creases[k]);
            for (size_t c = 0; c < 36; c++)
                expect_vec3_near(normals[c], nkw_vec3_scale(s.positions[s.indices[c]], 0.57735026919f), 6e-8);
        }
    }
}

enum { SIDES = 12 };

static nkw_vec3 on_circle(size_t i, float z)
{
    const double angle = 2 * 3.14159265358979 * (double)(i % SIDES) / SIDES;
    return vec3((float)cos(angle), (float)sin(angle), z);
}

static void add_cylinder(solid *s)
{
    s->vertex_count = 2 * SIDES;
    s->triangle_count = 0;
    for (uint32_t i = 0; i < SIDES; i++) {
        const uint32_t j = (i + 1) % SIDES, side[4] = {i, j, SIDES + j, SIDES + i};
        s->positions[i] = on_circle(i, 0);
        s->positions[SIDES + i] = on_circle(i, 3);
        solid_quad(s, side, i % 3 == 0);
    }
    for (uint32_t i = 2; i < SIDES; i++) {
        solid_triangle(s, 0, i, i - 1);
        solid_triangle(s, SIDES, SIDES + i - 1, SIDES + i);
    }
}

/* Sides meet at 30 degrees, caps at 90. */
static void a_cylinder_is_smooth_around_and_hard_at_its_caps(void **state)
{
    (void)state;
    solid s;
    add_cylinder(&s);
    const nkw_mesh mesh = solid_mesh(&s);
    make_normals(&mesh, 31 * DEGREE);
    for (size_t c = 0; c < 3 * s.triangle_count; c++) {
        const size_t v = s.indices[c];
        const nkw_vec3 cap = vec3(0, 0, v < SIDES ? -1 : 1);
        expect_vec3_near(normals[c], c < 6 * SIDES ? on_circle(v, 0) : cap, 2e-7);
    }
    make_normals(&mesh, 29 * DEGREE);
    for (size_t c = 0; c < 6 * SIDES; c++) {
        const double angle = 2 * 3.14159265358979 * ((double)(c / 6) + 0.5) / SIDES;
        expect_vec3_near(normals[c], vec3((float)cos(angle), (float)sin(angle), 0), 2e-7);
    }
}

static void degenerate_triangles_do_not_count_and_receive_the_sum(void **state)
{
    (void)state;
    const nkw_vec3 positions[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {9, 9, 9}, {9, 9, 8}};
    /* One triangle; two corners in one place; three on a line; a point alone. */
    const uint32_t indices[] = {0, 1, 2, 0, 1, 1, 0, 3, 1, 4, 5, 4};
    const nkw_mesh mesh = {positions, 6, indices, 4};
    make_normals(&mesh, 0);
    for (size_t c = 0; c < 9; c++)
        expect_vec3_bits(normals[c], c == 7 ? vec3(0, 0, 0) : vec3(0, 0, 1));
    for (size_t c = 9; c < 12; c++)
        expect_vec3_bits(normals[c], vec3(0, 0, 0));
}

static void both_sides_of_a_sheet_keep_their_normals(void **state)
{
    (void)state;
    const nkw_vec3 positions[] = {{0.1f, 0.2f, 0.3f}, {1, 0.7f, 0.9f}, {0.4f, 1, 0.1f}};
    const uint32_t indices[] = {0, 1, 2, 2, 1, 0};
    const nkw_mesh mesh = {positions, 3, indices, 2};
    make_normals(&mesh, PI);
    for (size_t c = 0; c < 6; c++)
        expect_vec3_near(normals[c], face_normal(&mesh, c / 3), 1e-6);
}

static void minus_zero_is_the_same_position_as_zero(void **state)
{
    (void)state;
    /* Two triangles at a right angle that share an edge by its numbers alone. */
    const nkw_vec3 positions[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, -0.0f, 0}, {-0.0f, 0, -0.0f}, {0, 0, 1}};
    const nkw_mesh mesh = {positions, 6, NULL, 2};
    make_normals(&mesh, PI);
    expect_vec3_near(normals[0], vec3(0, 0.70710678f, 0.70710678f), 6e-8);
    expect_vec3_bits(normals[0], normals[4]);
    expect_vec3_bits(normals[1], normals[3]);
    expect_vec3_bits(normals[2], vec3(0, 0, 1));
    expect_vec3_bits(normals[5], vec3(0, 1, 0));
}

static void a_power_of_two_does_not_change_a_bit(void **state)
{
    (void)state;
    random_source r = random_from(3);
    const int powers[] = {-120, -60, 60, 120};
    for (int k = 0; k < 4; k++) {
        solid s;
        nkw_vec3 want[36];
        solid_cube(&s, 9);
        for (size_t i = 0; i < 8; i++)
            s.positions[i] = nkw_vec3_add(s.positions[i], random_vec3(&r, -0.5f, 0.5f));
        const nkw_mesh mesh = solid_mesh(&s);
        make_normals(&mesh, 1.6f);
        memcpy(want, normals, sizeof want);
        for (size_t i = 0; i < 8; i++)
            s.positions[i] = nkw_vec3_scale(s.positions[i], ldexpf(1, powers[k]));
        make_normals(&mesh, 1.6f);
        expect_floats_bits(&normals[0].x, &want[0].x, 108);
    }
}

/* The definition, by libm, for each corner through all others. */
static nkw_vec3 plain_normal(const nkw_mesh *mesh, size_t corner, double crease)
{
    double sum[3] = {0, 0, 0};
    const nkw_vec3 own = face_normal(mesh, corner / 3), at = mesh->positions[mesh->indices[corner]];
    for (size_t c = 0; c < 3 * mesh->triangle_count; c++) {
        const uint32_t *i = mesh->indices + c / 3 * 3;
        const nkw_vec3 p = mesh->positions[mesh->indices[c]], n = face_normal(mesh, c / 3);
        if (!nkw_vec3_equal_within(p, at, 0) || acos(fmin(1.0, (double)nkw_vec3_dot(n, own))) > crease)
            continue;
        const nkw_vec3 u = nkw_vec3_normalize(nkw_vec3_sub(mesh->positions[i[(c % 3 + 1) % 3]], p));
        const nkw_vec3 v = nkw_vec3_normalize(nkw_vec3_sub(mesh->positions[i[(c % 3 + 2) % 3]], p));
        const double angle = acos((double)nkw_vec3_dot(u, v));
        sum[0] += angle * (double)n.x, sum[1] += angle * (double)n.y, sum[2] += angle * (double)n.z;
    }
    const double length = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    return vec3((float)(sum[0] / length), (float)(sum[1] / length), (float)(sum[2] / length));
}

static void uneven_meshes_follow_the_definition(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (int round = 0; round < 40; round++) {
        const float crease = random_between(&r, 0.2f, 3.0f);
        solid s;
        add_cylinder(&s);
        for (size_t i = 0; i < s.vertex_count; i++)
            s.positions[i] = nkw_vec3_add(s.positions[i], random_vec3(&r, -0.15f, 0.15f));
        const nkw_mesh mesh = solid_mesh(&s);
        make_normals(&mesh, crease);
        for (size_t c = 0; c < 3 * s.triangle_count; c++)
            expect_vec3_near(normals[c], plain_normal(&mesh, c, (double)crease), 1e-4);
    }
}

static void normals_may_overwrite_positions(void **state)
{
    (void)state;
    solid s;
    nkw_vec3 corners[36];
    solid_cube(&s, 0);
    for (size_t c = 0; c < 36; c++)
        corners[c] = s.positions[s.indices[c]];
    const nkw_mesh mesh = solid_mesh(&s), loose = {corners, 36, NULL, 12};
    make_normals(&mesh, PI);
    nkw_mesh_normals(&loose, PI, corners, NULL, work_in(memory, sizeof memory));
    expect_floats_bits(&corners[0].x, &normals[0].x, 108);
}

static void faults_have_their_triangle(void **state)
{
    (void)state;
    solid s;
    solid_cube(&s, 0);
    nkw_mesh mesh = solid_mesh(&s);
    const nkw_work work = work_in(memory, sizeof memory), none = {NULL, 0};
    const nkw_work less = {work.data, NKW_MESH_WORK(12) - 1};
    size_t bad = 99;
    assert_int_equal(nkw_mesh_normals(&mesh, 1, normals, &bad, none), NKW_TOO_SMALL);
    assert_int_equal(nkw_mesh_normals(&mesh, 1, normals, NULL, less), NKW_TOO_SMALL);
    assert_int_equal(nkw_mesh_normals(&mesh, -1e-9f, normals, &bad, work), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_mesh_normals(&mesh, NAN, normals, &bad, work), NKW_OUT_OF_RANGE);
    assert_int_equal(bad, 0);
    s.indices[3 * 7 + 2] = 8;
    assert_int_equal(nkw_mesh_normals(&mesh, 1, normals, &bad, work), NKW_OUT_OF_RANGE);
    assert_int_equal(bad, 7);
    s.indices[3 * 7 + 2] = UINT32_MAX;
    assert_int_equal(nkw_mesh_normals(&mesh, 1, normals, &bad, none), NKW_OUT_OF_RANGE);
    assert_int_equal(bad, 7);
    solid_cube(&s, 0);
    s.positions[7].y = INFINITY; /* first in triangle 2: 1 3 7 */
    assert_int_equal(nkw_mesh_normals(&mesh, 1, normals, &bad, work), NKW_NOT_FINITE);
    assert_int_equal(bad, 2);
    mesh.indices = NULL; /* vertices 0 to 7 are two triangles and two corners */
    s.positions[7].y = 1;
    assert_int_equal(nkw_mesh_normals(&mesh, 1, normals, &bad, work), NKW_OUT_OF_RANGE);
    assert_int_equal(bad, 2);
    mesh.triangle_count = SIZE_MAX / 24 + 1;
    assert_int_equal(nkw_mesh_normals(&mesh, 1, normals, &bad, work), NKW_OUT_OF_RANGE);
    mesh.triangle_count = 0;
    assert_int_equal(nkw_mesh_normals(&mesh, 1, NULL, &bad, none), NKW_OK);
}

/* ---- equal records ---- */

static void records_are_numbered_in_their_order(void **state)
{
    (void)state;
    const float records[][2] = {{1, 2}, {3, 4}, {1, 2}, {0, 4}, {-0.0f, 4}, {3, 4}, {1, 3}};
    const uint32_t want[] = {0, 1, 0, 2, 3, 1, 4};
    uint32_t remap[7];
    size_t distinct = 0;
    assert_int_equal(nkw_mesh_weld(records, 7, 8, remap, &distinct, work_in(memory, sizeof memory)), NKW_OK);
    assert_int_equal(distinct, 5);
    assert_memory_equal(remap, want, sizeof want);
}

static void random_records_are_joined_as_by_comparing_all(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (size_t stride = 0; stride <= 13; stride++) {
        enum { COUNT = 300 };
        unsigned char records[13 * COUNT];
        uint32_t remap[COUNT], next = 0;
        size_t distinct = 99;
        for (size_t i = 0; i < sizeof records; i++)
            records[i] = (unsigned char)(random_bits(&r) % (stride < 4 ? 5 : 2));
        assert_int_equal(nkw_mesh_weld(records, COUNT, stride, remap, &distinct, work_in(memory, sizeof memory)),
                         NKW_OK);
        for (size_t i = 0; i < COUNT; i++) {
            size_t j = 0;
            while (memcmp(records + j * stride, records + i * stride, stride))
                j++;
            assert_int_equal(remap[i], j == i ? next++ : remap[j]);
        }
        assert_int_equal(distinct, next);
    }
}

static void too_many_records_or_too_little_memory_write_nothing(void **state)
{
    (void)state;
    uint32_t remap[2] = {7, 7};
    size_t distinct = 7;
    const nkw_work work = work_in(memory, sizeof memory), less = {work.data, NKW_MESH_WELD_WORK(2) - 1};
    assert_int_equal(nkw_mesh_weld("ab", 2, 1, remap, &distinct, less), NKW_TOO_SMALL);
    assert_int_equal(nkw_mesh_weld("ab", ((size_t)1 << 30) + 1, 1, remap, &distinct, work), NKW_OUT_OF_RANGE);
    assert_true(remap[0] == 7 && remap[1] == 7 && distinct == 7);
    assert_int_equal(nkw_mesh_weld(NULL, 0, 4, remap, &distinct, work), NKW_OK);
    assert_int_equal(distinct, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cube_below_the_crease_of_90_degrees_has_the_normals_of_its_faces),
        cmocka_unit_test(a_smooth_cube_has_the_normals_of_its_diagonals),
        cmocka_unit_test(a_cylinder_is_smooth_around_and_hard_at_its_caps),
        cmocka_unit_test(degenerate_triangles_do_not_count_and_receive_the_sum),
        cmocka_unit_test(both_sides_of_a_sheet_keep_their_normals),
        cmocka_unit_test(minus_zero_is_the_same_position_as_zero),
        cmocka_unit_test(a_power_of_two_does_not_change_a_bit),
        cmocka_unit_test(uneven_meshes_follow_the_definition),
        cmocka_unit_test(normals_may_overwrite_positions),
        cmocka_unit_test(faults_have_their_triangle),
        cmocka_unit_test(records_are_numbered_in_their_order),
        cmocka_unit_test(random_records_are_joined_as_by_comparing_all),
        cmocka_unit_test(too_many_records_or_too_little_memory_write_nothing),
    };
    return cmocka_run_group_tests_name("mesh", tests, NULL, NULL);
}
