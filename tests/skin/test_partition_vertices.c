/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "random.h"
#include "support/expect.h"
#include "support/partition.h"

static mesh_data data;

#define JOINTS 12

static nkw_mat4 bind[JOINTS], model[JOINTS];
static nkw_vec3 positions[MOST_VERTICES], normals[MOST_VERTICES];

/* Rigid joints and vertices within 2.6 of the origin. */
static void draw_pose(random_source *r)
{
    for (size_t b = 0; b < JOINTS; b++) {
        nkw_trs at = {random_vec3(r, -1.5f, 1.5f), random_rotation(r), {1, 1, 1}}, to = at;
        to.rotation = random_rotation(r);
        to.translation = random_vec3(r, -1.5f, 1.5f);
        nkw_mat4 rest = nkw_mat4_from_trs(&at);
        bind[b] = nkw_mat4_inverse_affine(&rest);
        model[b] = nkw_mat4_from_trs(&to);
    }
    for (size_t v = 0; v < MOST_VERTICES; v++) {
        positions[v] = random_vec3(r, -1.5f, 1.5f);
        normals[v] = random_direction(r);
    }
}

static nkw_result vertices(const nkw_partition *p, size_t part, const nkw_vec3 *with, size_t slots, float *out,
                           size_t stride)
{
    const nkw_partition_source source = {&data.mesh, bind, positions, with};
    return nkw_partition_vertices(p, part, &source, slots, out, stride);
}

/* out += weight m (v, w) */
static void add_transformed(const nkw_mat4 *m, const double v[3], double w, double weight, double out[3])
{
    for (size_t c = 0; c < 3; c++)
        out[c] += weight * (m->m[c] * v[0] + m->m[4 + c] * v[1] + m->m[8 + c] * v[2] + m->m[12 + c] * w);
}

/* Linear blend skinning of a vector of the mesh's vertex v, in double. */
static void blend(size_t v, nkw_vec3 vector, double w, double out[3])
{
    const double from[3] = {vector.x, vector.y, vector.z};
    for (size_t i = v * data.mesh.influence_count; i < (v + 1) * data.mesh.influence_count; i++) {
        double local[3] = {0};
        if (data.weights[i] == 0.0f)
            continue;
        add_transformed(&bind[data.joints[i]], from, w, 1, local);
        add_transformed(&model[data.joints[i]], local, w, data.weights[i], out);
    }
}

static double weight_of(size_t v)
{
    const float *w = data.weights + 4 * v;
    return ((double)w[0] + w[1]) + ((double)w[2] + w[3]);
}

/* What a shader makes of a joint-local vertex of eight slots, in double: position and normal. */
static void blend_local(const float *vertex, const uint16_t *joints, size_t count, double out[6])
{
    for (size_t s = 0; s < count; s++) {
        const float *at = vertex + 7 * s;
        const double position[3] = {at[1], at[2], at[3]}, normal[3] = {at[4], at[5], at[6]};
        add_transformed(&model[joints[s]], position, 1, at[0], out);
        add_transformed(&model[joints[s]], normal, 0, at[0], out + 3);
    }
}

static void vertices_blend_as_linear_blend_skinning_does(void **state)
{
    (void)state;
    random_source r = random_from(7);
    static float out[MOST_VERTICES * 60];
    mesh_shape(&data, 400, 300, 4, JOINTS);
    mesh_draw(&data, &r);
    draw_pose(&r);
    nkw_partition p = partition_build(&data.mesh, 8, NKW_OK);
    double worst = 0;
    for (size_t k = 0; k < p.part_count; k++) {
        const nkw_part *part = &p.parts[k];
        vertices(&p, k, normals, 8, out, 60);
        for (size_t i = 0; i < part->vertex_count; i++) {
            double got[6] = {0}, want[6] = {0};
            size_t v = p.vertices[part->first_vertex + i];
            blend_local(out + i * 60, p.joints + part->first_joint, part->joint_count, got);
            blend(v, positions[v], 1, want);
            blend(v, normals[v], 0, want + 3);
            for (size_t c = 0; c < 6; c++)
                worst = fmax(worst, fabs(got[c] - want[c]) / (weight_of(v) + 1e-9));
        }
    }
    expect_near(worst, 0, 2e-7 * 2.6);
    partition_free(&p);
}

static void vertices_have_every_joint_of_the_part(void **state)
{
    (void)state;
    random_source r = random_from(8);
    float out[5 * 32];
    mesh_strip(&data);
    draw_pose(&r);
    nkw_partition p = partition_build(&data.mesh, 3, NKW_OK);
    for (size_t i = 0; i < sizeof out / sizeof out[0]; i++)
        out[i] = -77;
    vertices(&p, 0, normals, 4, out, 32);
    static const float weights[5][3] = {{1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0.5f, 0.5f}, {0, 0, 1}};
    for (size_t v = 0; v < 5; v++) {
        for (size_t s = 0; s < 3; s++) {
            const float *at = out + 32 * v + 7 * s;
            nkw_vec3 position = {at[1], at[2], at[3]}, normal = {at[4], at[5], at[6]};
            expect_bits(at[0], weights[v][s]);
            expect_vec3_bits(position, nkw_mat4_transform_point(&bind[s], positions[v]));
            expect_vec3_bits(normal, nkw_mat4_transform_direction(&bind[s], normals[v]));
        }
        for (size_t i = 21; i < 32; i++)
            expect_bits(out[32 * v + i], i < 28 ? 0.0f : -77.0f);
    }
    partition_free(&p);
}

static void vertices_without_normals_have_four_floats_to_a_slot(void **state)
{
    (void)state;
    random_source r = random_from(9);
    float out[5 * 8];
    mesh_strip(&data);
    draw_pose(&r);
    nkw_partition p = partition_build(&data.mesh, 3, NKW_OK);
    assert_int_equal(NKW_PARTITION_FLOATS(2, 0), 8);
    assert_int_equal(NKW_PARTITION_FLOATS(4, 1), 28);
    vertices(&p, 0, NULL, 2, out, 8);
    nkw_vec3 position = {out[8 * 3 + 5], out[8 * 3 + 6], out[8 * 3 + 7]};
    expect_bits(out[8 * 3 + 0], 0.0f);
    expect_bits(out[8 * 3 + 4], 0.5f);
    expect_vec3_bits(position, nkw_mat4_transform_point(&bind[1], positions[3]));
    partition_free(&p);
}

static void a_joint_that_is_named_twice_has_both_weights(void **state)
{
    (void)state;
    float out[3 * 4];
    mesh_shape(&data, 1, 3, 2, 1);
    data.indices[1] = 1;
    data.indices[2] = 2;
    for (size_t i = 0; i < 6; i++)
        data.weights[i] = 0.25f;
    bind[0] = nkw_mat4_identity();
    nkw_partition p = partition_build(&data.mesh, 1, NKW_OK);
    vertices(&p, 0, NULL, 1, out, 4);
    expect_bits(out[0], 0.5f);
    partition_free(&p);
}

static void vertices_write_nothing_for_no_part_and_for_a_short_stride(void **state)
{
    (void)state;
    float out[4] = {5, 5, 5, 5}, before[4] = {5, 5, 5, 5};
    mesh_strip(&data);
    nkw_partition p = partition_build(&data.mesh, 3, NKW_OK);
    assert_int_equal(vertices(&p, 3, NULL, 1, out, 4), NKW_OUT_OF_RANGE);
    assert_int_equal(vertices(&p, 0, NULL, 1, out, 3), NKW_TOO_SMALL);
    assert_int_equal(vertices(&p, 0, normals, 1, out, 6), NKW_TOO_SMALL);
    assert_int_equal(vertices(&p, 0, NULL, SIZE_MAX / 4 + 1, out, 0), NKW_TOO_SMALL);
    expect_floats_bits(out, before, 4);
    partition_free(&p);
}

/* Runs that leave the partition, joints and vertices that leave the mesh: one number wrong at a time. */
static void vertices_write_nothing_for_a_partition_that_is_not_sound(void **state)
{
    (void)state;
    float out[5 * 12], before[5 * 12];
    mesh_strip(&data);
    nkw_partition p = partition_build(&data.mesh, 3, NKW_OK);
    nkw_part *part = &p.parts[0];
    const nkw_part whole = *part;
    for (size_t i = 0; i < 60; i++)
        out[i] = before[i] = 5;
    for (int wrong = 0; wrong < 8; wrong++) {
        *part = whole;
        uint16_t joint = p.joints[whole.first_joint];
        uint32_t vertex = p.vertices[whole.first_vertex];
        if (wrong == 0)
            part->first_joint = (uint32_t)p.joint_count + 1;
        else if (wrong == 1)
            part->joint_count = (uint32_t)(p.joint_count - part->first_joint) + 1;
        else if (wrong == 2)
            part->first_vertex = (uint32_t)p.vertex_count + 1;
        else if (wrong == 3)
            part->vertex_count = (uint32_t)(p.vertex_count - part->first_vertex) + 1;
        else if (wrong == 4)
            p.joints[whole.first_joint] = (uint16_t)data.mesh.joint_count;
        else if (wrong == 5)
            p.vertices[whole.first_vertex] = (uint32_t)data.mesh.vertex_count;
        else if (wrong == 6)
            part->joint_count = UINT32_MAX;
        else
            part->vertex_count = UINT32_MAX;
        assert_int_equal(vertices(&p, 0, NULL, 3, out, 12), NKW_OUT_OF_RANGE);
        expect_floats_bits(out, before, 60);
        p.joints[whole.first_joint] = joint;
        p.vertices[whole.first_vertex] = vertex;
    }
    *part = whole;
    assert_int_equal(vertices(&p, 0, NULL, 3, out, 12), NKW_OK);
    assert_true(out[0] != 5.0f);
    partition_free(&p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vertices_blend_as_linear_blend_skinning_does),
        cmocka_unit_test(vertices_have_every_joint_of_the_part),
        cmocka_unit_test(vertices_without_normals_have_four_floats_to_a_slot),
        cmocka_unit_test(a_joint_that_is_named_twice_has_both_weights),
        cmocka_unit_test(vertices_write_nothing_for_no_part_and_for_a_short_stride),
        cmocka_unit_test(vertices_write_nothing_for_a_partition_that_is_not_sound),
    };
    return cmocka_run_group_tests_name("partition_vertices", tests, NULL, NULL);
}
