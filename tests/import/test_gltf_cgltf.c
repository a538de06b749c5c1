/* SPDX-License-Identifier: MIT */
/* docs/examples/gltf_cgltf.h, from a cgltf_data of a few nodes. */
#include <stdlib.h>

#include "cgltf.h"

#include "gltf_cgltf.h"
#include "support/expect.h"
#include "support/views.h"

static void *blocks[256];
static size_t block_count;

static void *take(size_t count, size_t size)
{
    assert_true(block_count < sizeof blocks / sizeof *blocks);
    void *block = calloc(count + 1, size);
    assert_non_null(block);
    return blocks[block_count++] = block;
}

static void give(void)
{
    while (block_count > 0)
        free(blocks[--block_count]);
}

/* Node 1 is the root, node 0 its child, node 2, with a matrix and a mesh of two targets, the child of node 0. */
typedef struct file {
    float weights[2], times[2], turns[8], morphs[4], bind[16];
    cgltf_accessor input, turn, morph, inverse_bind;
    cgltf_animation_sampler samplers[2];
    cgltf_animation_channel channels[3];
    cgltf_animation animation;
    cgltf_primitive primitive;
    cgltf_mesh mesh;
    cgltf_node nodes[3], *joints[2];
    cgltf_skin skin;
    cgltf_data data;
} file;

static void fill(file *f)
{
    static const file zero;
    *f = zero;
    for (size_t i = 0; i < 3; i++)
        f->nodes[i].rotation[3] = f->nodes[i].scale[0] = f->nodes[i].scale[1] = f->nodes[i].scale[2] = 1.0f;
    for (size_t i = 0; i < 16; i += 5)
        f->bind[i] = f->nodes[2].matrix[i] = 1.0f;
    f->nodes[0].parent = &f->nodes[1];
    f->nodes[0].translation[1] = 3.0f;
    f->nodes[2].parent = &f->nodes[0];
    f->nodes[2].has_matrix = 1;
    f->nodes[2].matrix[12] = 5.0f;
    f->primitive.targets_count = 2;
    f->weights[1] = 0.25f;
    const cgltf_mesh mesh = {&f->primitive, 1, f->weights, 2};
    f->mesh = mesh;
    f->nodes[2].mesh = &f->mesh;
    f->times[1] = 2.0f;
    f->turns[3] = f->turns[6] = 1.0f; /* half a turn about z */
    f->morphs[2] = 8.0f;
    const cgltf_component_type type = cgltf_component_type_r_32f;
    const cgltf_accessor input = {2, f->times, 2, type}, turn = {2, f->turns, 8, type}, morph = {4, f->morphs, 4, type};
    const cgltf_accessor inverse_bind = {1, f->bind, 16, type};
    f->input = input;
    f->turn = turn;
    f->morph = morph;
    f->inverse_bind = inverse_bind;
    const cgltf_animation_sampler turns = {&f->input, &f->turn, cgltf_interpolation_type_linear};
    const cgltf_animation_sampler morphs = {&f->input, &f->morph, cgltf_interpolation_type_step};
    f->samplers[0] = turns;
    f->samplers[1] = morphs;
    const cgltf_animation_channel channels[3] = {
        {&f->samplers[0], NULL, cgltf_animation_path_type_rotation},
        {&f->samplers[0], &f->nodes[0], cgltf_animation_path_type_rotation},
        {&f->samplers[1], &f->nodes[2], cgltf_animation_path_type_weights},
    };
    memcpy(f->channels, channels, sizeof channels);
    const cgltf_animation animation = {f->channels, 3};
    f->animation = animation;
    f->joints[0] = &f->nodes[2];
    f->joints[1] = &f->nodes[1];
    const cgltf_skin skin = {f->joints, 2, NULL};
    f->skin = skin;
    const cgltf_data data = {&f->skin, 1, f->nodes, 3, &f->animation, 1};
    f->data = data;
}

static void one_call_loads_a_character(void **state)
{
    (void)state;
    file f;
    gltf_character c;
    size_t bad = 9;
    float pose[NKW_POSE_FLOATS(3)], floats[2];
    nkw_mat4 models[3];
    fill(&f);
    assert_int_equal(gltf_load(&f.data, take, &c, &bad), NKW_OK);
    const int32_t joints[3] = {1, 0, 2};
    for (size_t i = 0; i < 3; i++)
        assert_int_equal(c.joint_of_node[i], joints[i]);
    assert_int_equal(c.float_count, 2);
    expect_floats_bits(c.rest_floats, f.weights, 2);
    assert_int_equal(nkw_clip_sample(c.clips[0], 1.0f, NULL, pose_span(pose, 3), floats), NKW_OK);
    assert_int_equal(nkw_skeleton_models_from_pose(&c.skeleton, pose_view(pose, 3), NULL, NULL, models), NKW_OK);
    nkw_vec3 tip = {models[2].m[12], models[2].m[13], models[2].m[14]}, want = {0, 3 + 5, 0}; /* a quarter turn */
    expect_vec3_near(tip, want, 1e-5);
    expect_floats_bits(floats, f.morphs, 2);
    nkw_clip_sample(c.clips[0], 2.0f, NULL, pose_span(pose, 3), floats);
    expect_floats_bits(floats, f.morphs + 2, 2);
    assert_int_equal(c.skins[0].joint_count, 2);
    assert_int_equal(c.skins[0].joints[0], 2);
    assert_int_equal(c.skins[0].joints[1], 0);
    assert_null(c.skins[0].inverse_bind);
    assert_int_equal(nkw_palette_source_validate(&c.skins[0], NULL), NKW_OK);
    give();
}

/* Integers are rounded unit quaternions: 90/127 twice has the length 1.0022. */
static void rotations_of_integers_are_normalised(void **state)
{
    (void)state;
    file f;
    gltf_character c;
    size_t bad = 9;
    float pose[NKW_POSE_FLOATS(3)];
    fill(&f);
    f.turns[6] = f.turns[7] = 90.0f / 127.0f;
    f.turn.component_type = cgltf_component_type_r_8;
    assert_int_equal(gltf_load(&f.data, take, &c, &bad), NKW_OK);
    nkw_clip_sample(c.clips[0], 2.0f, NULL, pose_span(pose, 3), NULL);
    nkw_quat got = nkw_pose_get(pose_view(pose, 3), (size_t)c.joint_of_node[0]).rotation;
    expect_near(got.z, sqrt(0.5), 1e-7);
    expect_near(got.w, sqrt(0.5), 1e-7);
    give();
}

static void errors_end_the_call(void **state)
{
    (void)state;
    file f;
    gltf_character c;
    size_t bad = 9;
    fill(&f);
    f.skin.joints_count = 1;
    f.skin.inverse_bind_matrices = &f.inverse_bind;
    f.times[0] = 3.0f;
    assert_int_equal(gltf_load(&f.data, take, &c, &bad), NKW_NOT_ASCENDING);
    assert_null(c.clips[0]);
    f.times[0] = 0.0f;
    assert_int_equal(gltf_load(&f.data, take, &c, &bad), NKW_OK);
    expect_floats_bits(c.skins[0].inverse_bind[0].m, f.bind, 16);
    f.nodes[1].parent = &f.nodes[2];
    assert_int_equal(gltf_load(&f.data, take, &c, &bad), NKW_NOT_A_TREE);
    assert_int_equal(bad, 0);
    give();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_call_loads_a_character),
        cmocka_unit_test(rotations_of_integers_are_normalised),
        cmocka_unit_test(errors_end_the_call),
    };
    return cmocka_run_group_tests_name("gltf_cgltf", tests, NULL, NULL);
}
