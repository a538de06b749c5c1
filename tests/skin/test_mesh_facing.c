/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/solids.h"
#include "support/views.h"

static unsigned char memory[NKW_MESH_WORK(SOLID_TRIANGLES) + 16];

/* In place. */
static nkw_mesh_facing fix(solid *s)
{
    const nkw_mesh mesh = solid_mesh(s);
    nkw_mesh_facing facing = {99, 99, 99, 99, 99};
    size_t bad = 99;
    memset(memory, 0xa5, sizeof memory);
    assert_int_equal(
        nkw_mesh_fix_facing(&mesh, s->indices, &facing, &bad, work_in(memory, NKW_MESH_WORK(s->triangle_count) + 15)),
        NKW_OK);
    assert_int_equal(bad, 0);
    return facing;
}

static void turn(solid *s, size_t triangle)
{
    uint32_t *i = s->indices + 3 * triangle, second = i[1];
    i[1] = i[2];
    i[2] = second;
}

static void expect_facing(nkw_mesh_facing got, size_t turned, size_t pieces, size_t closed)
{
    assert_int_equal(got.turned_count, turned);
    assert_int_equal(got.piece_count, pieces);
    assert_int_equal(got.closed_count, closed);
    assert_int_equal(got.conflict_count, 0);
    assert_int_equal(got.branch_count, 0);
}

/* All 4096 sets of turned triangles. */
static void a_cube_faces_outward_whatever_was_turned(void **state)
{
    (void)state;
    solid want;
    solid_cube(&want, 0x2a);
    for (unsigned set = 0; set < 4096; set++) {
        solid s = want;
        size_t turned = 0;
        for (size_t t = 0; t < 12; t++)
            if (set >> t & 1) {
                turn(&s, t);
                turned++;
            }
        expect_facing(fix(&s), turned, 1, 1);
        assert_memory_equal(s.indices, want.indices, 36 * sizeof(uint32_t));
    }
}

/* Each quad has vertices of its own: edges are shared by their positions. */
static void positions_connect_not_vertices(void **state)
{
    (void)state;
    solid cube, s;
    solid_cube(&cube, 0);
    s = cube;
    s.vertex_count = 36;
    for (uint32_t c = 0; c < 36; c++) {
        s.positions[c] = cube.positions[cube.indices[c]];
        s.indices[c] = c;
    }
    turn(&s, 4);
    turn(&s, 11);
    expect_facing(fix(&s), 2, 1, 1);
    for (uint32_t c = 0; c < 36; c++)
        assert_int_equal(s.indices[c], c);
}

/* A sheet has no outside: the way of the majority, and of the first of two halves. */
static void open_pieces_face_the_way_of_most_of_their_triangles(void **state)
{
    (void)state;
    for (size_t wrong = 0; wrong <= 10; wrong++) {
        solid s;
        s.vertex_count = 12;
        s.triangle_count = 0;
        for (uint32_t i = 0; i < 12; i++)
            s.positions[i] = (nkw_vec3){(float)(i / 2), (float)(i % 2), 0.1f * (float)(i * i)};
        for (uint32_t i = 0; i < 10; i++)
            solid_triangle(&s, i, i % 2 ? i + 2 : i + 1, i % 2 ? i + 1 : i + 2);
        const solid sheet = s;
        for (size_t t = 10 - wrong; t < 10; t++)
            turn(&s, t);
        expect_facing(fix(&s), wrong <= 5 ? wrong : 10 - wrong, 1, 0);
        solid want = sheet;
        for (size_t t = 0; wrong > 5 && t < 10; t++)
            turn(&want, t);
        assert_memory_equal(s.indices, want.indices, 30 * sizeof(uint32_t));
    }
}

/* A strip of 2 n triangles whose ends are joined, with half a turn or without. */
static void add_strip(solid *s, size_t n, int twisted)
{
    s->vertex_count = 2 * n;
    s->triangle_count = 0;
    for (size_t i = 0; i < n; i++) {
        const double a = 6.283185307 * (double)i / (double)n, half = twisted ? a / 2 : 0;
        for (size_t side = 0; side < 2; side++) {
            const double r = 3 + (side ? 1 : -1) * cos(half), z = (side ? 1 : -1) * sin(half);
            s->positions[2 * i + side] = (nkw_vec3){(float)(r * cos(a)), (float)(r * sin(a)), (float)z};
        }
    }
    for (size_t i = 0; i < n; i++) {
        const size_t crossed = twisted && i == n - 1, j = 2 * ((i + 1) % n);
        const uint32_t quad[4] = {(uint32_t)(2 * i), (uint32_t)(2 * i + 1), (uint32_t)(j + !crossed),
                                  (uint32_t)(j + crossed)};
        solid_quad(s, quad, 0);
    }
}

static void a_moebius_strip_has_one_edge_that_cannot_agree(void **state)
{
    (void)state;
    for (size_t n = 5; n < 30; n++) {
        solid s;
        add_strip(&s, n, 0);
        expect_facing(fix(&s), 0, 1, 0);
        add_strip(&s, n, 1);
        turn(&s, n);
        const nkw_mesh_facing found = fix(&s);
        assert_int_equal(found.conflict_count, 1);
        assert_int_equal(found.piece_count, 1);
        assert_int_equal(found.closed_count, 0);
        assert_int_equal(fix(&s).turned_count, 0);
    }
}

/* Three fins at one edge: no piece continues over it. */
static void an_edge_of_three_triangles_connects_none(void **state)
{
    (void)state;
    solid s = {{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}}, {0, 1, 2, 0, 1, 3, 1, 0, 4}, 5, 3};
    const solid same = s;
    const nkw_mesh_facing found = fix(&s);
    assert_int_equal(found.branch_count, 1);
    assert_int_equal(found.piece_count, 3);
    assert_int_equal(found.turned_count, 0);
    assert_memory_equal(s.indices, same.indices, 9 * sizeof(uint32_t));
}

/* The small cube inside of the large one, inside out; the collapsed triangles connect nothing and are no piece. */
static void pieces_are_settled_apart_and_collapsed_triangles_left(void **state)
{
    (void)state;
    solid s, small;
    solid_cube(&s, 0);
    solid_cube(&small, 0x3f);
    for (size_t i = 0; i < 8; i++)
        s.positions[8 + i] = nkw_vec3_scale(small.positions[i], 0.5f);
    for (size_t t = 0; t < 12; t++)
        solid_triangle(&s, 8 + small.indices[3 * t], 8 + small.indices[3 * t + 2], 8 + small.indices[3 * t + 1]);
    s.vertex_count = 16;
    solid_triangle(&s, 0, 1, 1);
    solid_triangle(&s, 0, 8, 0);
    expect_facing(fix(&s), 12, 2, 2);
    for (size_t c = 0; c < 36; c++)
        assert_int_equal(s.indices[36 + c], 8 + small.indices[c]);
    assert_true(s.indices[72] == 0 && s.indices[73] == 1 && s.indices[74] == 1);
}

/* Front and back of one triangle: closed, without volume. */
static void both_sides_of_a_sheet_stay(void **state)
{
    (void)state;
    solid s = {{{0.1f, 0.2f, 0.3f}, {1, 0.7f, 0.9f}, {0.4f, 1, 0.1f}}, {0, 1, 2, 2, 1, 0}, 3, 2};
    expect_facing(fix(&s), 0, 1, 1);
    assert_true(s.indices[1] == 1 && s.indices[3] == 2);
    turn(&s, 1);
    expect_facing(fix(&s), 1, 1, 1);
}

static void faults_write_nothing(void **state)
{
    (void)state;
    solid s;
    solid_cube(&s, 0);
    const nkw_mesh mesh = solid_mesh(&s);
    const nkw_work work = work_in(memory, sizeof memory), less = {work.data, NKW_MESH_WORK(12) - 1};
    nkw_mesh_facing facing = {7, 7, 7, 7, 7};
    uint32_t out[36] = {77};
    size_t bad;
    assert_int_equal(nkw_mesh_fix_facing(&mesh, out, &facing, &bad, less), NKW_TOO_SMALL);
    s.indices[14] = 8;
    assert_int_equal(nkw_mesh_fix_facing(&mesh, out, &facing, &bad, work), NKW_OUT_OF_RANGE);
    assert_int_equal(bad, 4);
    s.indices[14] = 1;
    s.positions[1].z = NAN;
    assert_int_equal(nkw_mesh_fix_facing(&mesh, out, &facing, &bad, work), NKW_NOT_FINITE);
    assert_true(out[0] == 77 && facing.turned_count == 7 && facing.branch_count == 7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cube_faces_outward_whatever_was_turned),
        cmocka_unit_test(positions_connect_not_vertices),
        cmocka_unit_test(open_pieces_face_the_way_of_most_of_their_triangles),
        cmocka_unit_test(a_moebius_strip_has_one_edge_that_cannot_agree),
        cmocka_unit_test(an_edge_of_three_triangles_connects_none),
        cmocka_unit_test(pieces_are_settled_apart_and_collapsed_triangles_left),
        cmocka_unit_test(both_sides_of_a_sheet_stay),
        cmocka_unit_test(faults_write_nothing),
    };
    return cmocka_run_group_tests_name("mesh_facing", tests, NULL, NULL);
}
