/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "random.h"
#include "support/expect.h"
#include "support/partition.h"

static mesh_data data, shuffled;
static const nkw_partition unused = {NULL, NULL, NULL, NULL, NULL, NULL, NULL, 9, 9, 9, 9, 9};

static void random_meshes_are_covered_exactly(void **state)
{
    (void)state;
    random_source r = random_from(1);
    size_t rejecting = 0;
    for (size_t round = 0; round < 400; round++) {
        size_t triangles = random_bits(&r) % (round < 100 ? 12 : MOST_TRIANGLES);
        mesh_shape(&data, triangles, 1 + random_bits(&r) % MOST_VERTICES, 1 + random_bits(&r) % 8,
                   1 + random_bits(&r) % 200);
        mesh_draw(&data, &r);
        if (round % 5 == 0)
            data.mesh.materials = NULL;
        size_t max_joint_count = random_bits(&r) % 30;
        size_t more = mesh_needing_more(&data.mesh, max_joint_count);
        rejecting += more != 0;
        nkw_partition p = partition_build(&data.mesh, max_joint_count, more ? NKW_TOO_MANY : NKW_OK);
        assert_int_equal(p.rejected_count, more);
        expect_partition(&data.mesh, max_joint_count, &p);
        partition_free(&p);
    }
    assert_true(rejecting > 50 && rejecting < 350);
}

static void a_mesh_without_triangles_has_no_parts(void **state)
{
    (void)state;
    nkw_partition_mesh mesh = {NULL, NULL, 0, NULL, NULL, 0, 4, 0, NULL};
    nkw_partition p = unused;
    NKW_STACK_WORK(work, 32);
    size_t bad = 99;
    assert_true(nkw_partition_bounds(&mesh, 4).work_bytes <= 32);
    assert_int_equal(nkw_partition_build(&mesh, 4, &p, &bad, work), NKW_OK);
    expect_nothing(&p);
    assert_int_equal(bad, 0);
}

static void a_mesh_of_one_joint_is_one_part(void **state)
{
    (void)state;
    random_source r = random_from(2);
    mesh_shape(&data, 100, 60, 1, 1);
    mesh_draw(&data, &r);
    data.mesh.materials = NULL;
    for (size_t v = 0; v < 60; v++) {
        data.weights[v] = 1;
        data.joints[v] = 0;
    }
    nkw_partition p = partition_build(&data.mesh, 1, NKW_OK);
    expect_partition(&data.mesh, 1, &p);
    assert_int_equal(p.part_count, 1);
    assert_int_equal(p.joint_count, 1);
    partition_free(&p);
}

static void vertices_without_weights_need_no_joints(void **state)
{
    (void)state;
    mesh_shape(&data, 5, 15, 2, 3);
    nkw_partition p = partition_build(&data.mesh, 0, NKW_OK);
    expect_partition(&data.mesh, 0, &p);
    assert_int_equal(p.part_count, 1);
    assert_int_equal(p.joint_count, 0);
    assert_int_equal(p.triangle_count, 5);
    partition_free(&p);
}

static void room_for_all_joints_gives_one_part_per_material(void **state)
{
    (void)state;
    random_source r = random_from(3);
    mesh_shape(&data, 500, 300, 4, 70);
    mesh_draw(&data, &r);
    static const size_t most[] = {70, 71, 65536, SIZE_MAX};
    for (size_t i = 0; i < 4; i++) {
        nkw_partition p = partition_build(&data.mesh, most[i], NKW_OK);
        expect_partition(&data.mesh, most[i], &p);
        assert_int_equal(p.part_count, 3);
        assert_int_equal(p.parts[1].material, 1);
        partition_free(&p);
    }
}

static void all_joints_that_joints_can_name_will_do(void **state)
{
    (void)state;
    mesh_shape(&data, 1, 3, 1, 65536);
    for (uint16_t v = 0; v < 3; v++) {
        data.indices[v] = v;
        data.weights[v] = 1;
        data.joints[v] = (uint16_t)(65535 - v);
    }
    nkw_partition p = partition_build(&data.mesh, 3, NKW_OK);
    const uint16_t want[] = {65533, 65534, 65535};
    assert_int_equal(p.joint_count, 3);
    assert_memory_equal(p.joints, want, sizeof want);
    partition_free(&p);
}

/*
 * The triangles need {0 1} {0 1 2} {1 2} {1 2 3} {2 3} and, of the other material, {3 4}. With three joints in a part:
 * {0 1 2} takes {0 1} and {1 2}, {1 2 3} takes {2 3}.
 */
static void a_strip_of_six_triangles_comes_out_as_by_hand(void **state)
{
    (void)state;
    mesh_strip(&data);
    nkw_partition p = partition_build(&data.mesh, 3, NKW_OK);
    expect_partition(&data.mesh, 3, &p);
    static const nkw_part parts[] = {{0, 0, 3, 0, 3, 0, 5}, {0, 3, 2, 3, 3, 5, 4}, {7, 5, 1, 6, 2, 9, 3}};
    static const uint16_t joints[] = {0, 1, 2, 1, 2, 3, 3, 4};
    static const uint32_t triangles[] = {0, 1, 2, 3, 4, 5};
    static const uint32_t indices[] = {0, 1, 2, 1, 2, 3, 2, 3, 4, 0, 1, 2, 1, 2, 3, 0, 1, 2};
    static const uint32_t vertices[] = {0, 1, 2, 3, 4, 3, 4, 5, 6, 5, 6, 7};
    static const uint16_t slots[] = {0, 0, 0, 0, 1, 0, 1, 2, 2, 0, 0, 1, 1, 0, 2, 0, 2, 0, 0, 0, 0, 0, 1, 0};
    assert_int_equal(p.part_count, 3);
    assert_memory_equal(p.parts, parts, sizeof parts);
    assert_memory_equal(p.joints, joints, sizeof joints);
    assert_memory_equal(p.triangles, triangles, sizeof triangles);
    assert_memory_equal(p.indices, indices, sizeof indices);
    assert_memory_equal(p.vertices, vertices, sizeof vertices);
    assert_memory_equal(p.joint_slots, slots, sizeof slots);
    partition_free(&p);
}

static void triangles_that_need_more_joints_are_listed_after_the_parts(void **state)
{
    (void)state;
    mesh_strip(&data);
    nkw_partition p = partition_build(&data.mesh, 2, NKW_TOO_MANY);
    expect_partition(&data.mesh, 2, &p);
    static const uint32_t triangles[] = {0, 2, 4, 5, 1, 3};
    assert_int_equal(p.triangle_count, 4);
    assert_int_equal(p.rejected_count, 2);
    assert_int_equal(p.part_count, 4);
    assert_memory_equal(p.triangles, triangles, sizeof triangles);
    partition_free(&p);
    p = partition_build(&data.mesh, 0, NKW_TOO_MANY);
    assert_int_equal(p.part_count, 0);
    assert_int_equal(p.rejected_count, 6);
    partition_free(&p);
}

/* Two rings of four joints each, their triangles in turn: first fit in the order of the mesh would need four parts. */
static void sets_that_share_joints_are_packed_together(void **state)
{
    (void)state;
    static const uint16_t pairs[][2] = {{0, 1}, {4, 5}, {1, 2}, {5, 6}, {2, 3}, {6, 7}, {3, 0}, {7, 4}};
    mesh_shape(&data, 8, 24, 2, 8);
    data.mesh.materials = NULL;
    for (size_t t = 0; t < 8; t++)
        for (size_t c = 0; c < 3; c++) {
            data.indices[3 * t + c] = (uint32_t)(3 * t + c);
            for (size_t i = 0; i < 2; i++) {
                data.joints[2 * (3 * t + c) + i] = pairs[t][i];
                data.weights[2 * (3 * t + c) + i] = 0.5f;
            }
        }
    nkw_partition p = partition_build(&data.mesh, 4, NKW_OK);
    static const uint16_t joints[] = {0, 1, 2, 3, 4, 5, 6, 7};
    static const uint32_t triangles[] = {0, 2, 4, 6, 1, 3, 5, 7};
    assert_int_equal(p.part_count, 2);
    assert_memory_equal(p.joints, joints, sizeof joints);
    assert_memory_equal(p.triangles, triangles, sizeof triangles);
    partition_free(&p);
}

static void the_same_mesh_gives_the_same_partition(void **state)
{
    (void)state;
    random_source r = random_from(4);
    mesh_shape(&data, 500, 300, 4, 60);
    mesh_draw(&data, &r);
    nkw_partition a = partition_build(&data.mesh, 12, NKW_OK), b = partition_build(&data.mesh, 12, NKW_OK);
    assert_int_equal(a.part_count, b.part_count);
    assert_memory_equal(a.parts, b.parts, a.part_count * sizeof(nkw_part));
    assert_memory_equal(a.joints, b.joints, a.joint_count * sizeof(uint16_t));
    assert_memory_equal(a.triangles, b.triangles, 500 * sizeof(uint32_t));
    assert_memory_equal(a.joint_slots, b.joint_slots, 4 * a.vertex_count * sizeof(uint16_t));
    partition_free(&a);
    partition_free(&b);
}

static void the_order_of_triangles_does_not_change_the_joints_of_parts(void **state)
{
    (void)state;
    random_source r = random_from(5);
    mesh_shape(&data, 500, 300, 4, 60);
    mesh_draw(&data, &r);
    mesh_shape(&shuffled, 500, 300, 4, 60);
    memcpy(shuffled.joints, data.joints, sizeof data.joints);
    memcpy(shuffled.weights, data.weights, sizeof data.weights);
    for (size_t t = 0; t < 500; t++) {
        size_t from = (t * 77 + 13) % 500;
        shuffled.materials[t] = data.materials[from];
        memcpy(shuffled.indices + 3 * t, data.indices + 3 * from, 3 * sizeof(uint32_t));
    }
    nkw_partition a = partition_build(&data.mesh, 12, NKW_OK), b = partition_build(&shuffled.mesh, 12, NKW_OK);
    expect_partition(&shuffled.mesh, 12, &b);
    assert_int_equal(a.part_count, b.part_count);
    assert_memory_equal(a.joints, b.joints, a.joint_count * sizeof(uint16_t));
    for (size_t k = 0; k < a.part_count; k++)
        assert_int_equal(a.parts[k].triangle_count, b.parts[k].triangle_count);
    partition_free(&a);
    partition_free(&b);
}

static void joints_of_a_part_ascend_by_depth_where_depths_are_given(void **state)
{
    (void)state;
    random_source r = random_from(6);
    uint16_t depths[60];
    mesh_shape(&data, 500, 300, 4, 60);
    mesh_draw(&data, &r);
    for (size_t b = 0; b < 60; b++)
        depths[b] = (uint16_t)(random_bits(&r) % 5 * 16383);
    data.mesh.depths = depths;
    nkw_partition p = partition_build(&data.mesh, 14, NKW_OK);
    expect_partition(&data.mesh, 14, &p);
    partition_free(&p);
}

static void expect_invalid(nkw_result result, size_t triangle)
{
    const nkw_work none = {NULL, 0};
    nkw_partition p = unused;
    size_t bad = 99;
    result = result == NKW_OK ? NKW_TOO_SMALL : result; /* a sound mesh, and no memory for its parts */
    assert_int_equal(nkw_partition_build(&data.mesh, 4, &p, &bad, none), result);
    assert_int_equal(bad, triangle);
    assert_int_equal(nkw_partition_build(&data.mesh, 4, &p, NULL, none), result);
    expect_nothing(&p);
}

static void build_names_a_vertex_index_out_of_range(void **state)
{
    (void)state;
    mesh_strip(&data);
    expect_invalid(NKW_OK, 0);
    data.indices[3 * 4 + 2] = 8;
    expect_invalid(NKW_OUT_OF_RANGE, 4);
    data.indices[3 * 2 + 1] = UINT32_MAX;
    expect_invalid(NKW_OUT_OF_RANGE, 2);
}

static void build_names_a_joint_out_of_range(void **state)
{
    (void)state;
    mesh_strip(&data);
    data.joints[2 * 3 + 1] = 5;
    expect_invalid(NKW_OUT_OF_RANGE, 1);
    data.weights[2 * 3 + 1] = -0.0f;
    expect_invalid(NKW_OK, 0);
}

static void build_names_weights_that_are_not_finite_or_negative(void **state)
{
    (void)state;
    static const float bad[] = {NAN, INFINITY, -INFINITY};
    for (size_t i = 0; i < 3; i++) {
        mesh_strip(&data);
        data.weights[2 * 5 + 1] = bad[i];
        expect_invalid(NKW_NOT_FINITE, 3);
    }
    mesh_strip(&data);
    data.weights[2 * 6] = -1e-30f;
    expect_invalid(NKW_BAD_WEIGHTS, 4);
}

static void build_does_not_look_at_vertices_that_no_triangle_uses(void **state)
{
    (void)state;
    mesh_strip(&data);
    data.mesh.vertex_count = 9;
    data.weights[2 * 8] = NAN;
    expect_invalid(NKW_OK, 0);
}

static void build_names_counts_out_of_range(void **state)
{
    (void)state;
    mesh_strip(&data);
    data.mesh.influence_count = 0;
    expect_invalid(NKW_OUT_OF_RANGE, 0);
    data.mesh.influence_count = 9;
    expect_invalid(NKW_OUT_OF_RANGE, 0);
    mesh_strip(&data);
    data.mesh.joint_count = 65537;
    expect_invalid(NKW_OUT_OF_RANGE, 0);
    mesh_strip(&data);
    data.mesh.vertex_count = UINT32_MAX;
    expect_invalid(NKW_OUT_OF_RANGE, 0);
    mesh_strip(&data);
    data.mesh.triangle_count = UINT32_MAX / 24 + 1;
    expect_invalid(NKW_OUT_OF_RANGE, 0);
    assert_int_equal(nkw_partition_bounds(&data.mesh, 4).work_bytes, 0);
}

static void too_little_working_memory_is_refused(void **state)
{
    (void)state;
    mesh_strip(&data);
    nkw_partition_sizes sizes = nkw_partition_bounds(&data.mesh, 3);
    assert_int_equal(sizes.part_count, 6);
    assert_int_equal(sizes.joint_count, 18);
    assert_int_equal(sizes.vertex_count, 18);
    nkw_partition p = unused;
    unsigned char *memory = malloc(sizes.work_bytes + 4);
    const nkw_work small = {memory, sizes.work_bytes - 1}, misaligned = {memory + 4, sizes.work_bytes};
    assert_int_equal(nkw_partition_build(&data.mesh, 3, &p, NULL, small), NKW_TOO_SMALL);
    expect_nothing(&p);
    assert_int_equal(nkw_partition_build(&data.mesh, 3, &p, NULL, misaligned), NKW_TOO_SMALL);
    expect_nothing(&p);
    free(memory);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_meshes_are_covered_exactly),
        cmocka_unit_test(a_mesh_without_triangles_has_no_parts),
        cmocka_unit_test(a_mesh_of_one_joint_is_one_part),
        cmocka_unit_test(vertices_without_weights_need_no_joints),
        cmocka_unit_test(room_for_all_joints_gives_one_part_per_material),
        cmocka_unit_test(all_joints_that_joints_can_name_will_do),
        cmocka_unit_test(a_strip_of_six_triangles_comes_out_as_by_hand),
        cmocka_unit_test(triangles_that_need_more_joints_are_listed_after_the_parts),
        cmocka_unit_test(sets_that_share_joints_are_packed_together),
        cmocka_unit_test(the_same_mesh_gives_the_same_partition),
        cmocka_unit_test(the_order_of_triangles_does_not_change_the_joints_of_parts),
        cmocka_unit_test(joints_of_a_part_ascend_by_depth_where_depths_are_given),
        cmocka_unit_test(build_names_a_vertex_index_out_of_range),
        cmocka_unit_test(build_names_a_joint_out_of_range),
        cmocka_unit_test(build_names_weights_that_are_not_finite_or_negative),
        cmocka_unit_test(build_does_not_look_at_vertices_that_no_triangle_uses),
        cmocka_unit_test(build_names_counts_out_of_range),
        cmocka_unit_test(too_little_working_memory_is_refused),
    };
    return cmocka_run_group_tests_name("partition", tests, NULL, NULL);
}
