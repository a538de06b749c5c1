/* SPDX-License-Identifier: MIT */
/* A character of plain arrays: three nodes in the order hand, root, arm; a skin of two joints, a rigid part, morphs. */
#include <stdlib.h>

#include "support/expect.h"
#include "support/views.h"

enum { HAND, ROOT, ARM, NODES, VERTICES = 2 };

typedef struct plain {
    int32_t parents[NODES];
    nkw_trs rest[NODES];
    int32_t skin_joints[2];
    nkw_character_skin skin;
    nkw_vec3 positions[VERTICES], deltas[VERTICES];
    unsigned char joints[2 * VERTICES], weights[2 * VERTICES];
    nkw_morph_target target;
    nkw_character_part parts[3];
    float times[2], rotations[8], weight_keys[2], rest_floats[2];
    nkw_clip_track tracks[2];
    nkw_character_animation animations[2];
    nkw_character_source source;
    nkw_character c;
    void *block;
    size_t bytes;
    double memory[NKW_CHARACTER_WORK(NODES, 2) / 8 + 4];
} plain;

static const char *const names[NODES] = {"hand", "root", "arm"};
static plain s;

static nkw_work work(void)
{
    return work_in(s.memory, sizeof s.memory);
}

static void set_up_nodes(void)
{
    const nkw_vec3 up = {0.0f, 1.0f, 0.0f}, right = {2.0f, 0.0f, 0.0f}, z = {0.0f, 0.0f, 1.0f};
    s.parents[HAND] = ARM, s.parents[ROOT] = NKW_NO_JOINT, s.parents[ARM] = ROOT;
    for (size_t i = 0; i < NODES; i++)
        s.rest[i] = nkw_trs_identity();
    s.rest[HAND].translation = right;
    s.rest[ARM].translation = up;
    s.rest[ARM].rotation = nkw_quat_from_axis_angle(z, 0.5f);
    s.source.node_parents = s.parents;
    s.source.rest = s.rest;
    s.source.names = names;
    s.source.node_count = NODES;
}

/* Parts: skinned by hand and arm, rigid at the arm, rigid there with a morph target. */
static void set_up_parts(void)
{
    s.skin_joints[0] = HAND, s.skin_joints[1] = ARM;
    s.skin.joints = s.skin_joints;
    s.skin.joint_count = 2;
    s.source.skins = &s.skin;
    s.source.skin_count = 1;
    s.source.binds_at_rest = 1;
    for (size_t v = 0; v < VERTICES; v++) {
        const nkw_vec3 p = {1.0f, (float)v, 0.5f}, d = {0.0f, 0.0f, 1.0f + (float)v};
        s.positions[v] = p;
        s.deltas[v] = d;
        s.joints[2 * v] = (unsigned char)v;
        s.weights[2 * v] = 255;
    }
    for (size_t i = 0; i < 3; i++) {
        s.parts[i].joint = ARM;
        s.parts[i].skin_index = i ? NKW_NO_JOINT : 0;
        s.parts[i].vertices.positions.data = s.positions;
        s.parts[i].skin.vertex_count = VERTICES;
    }
    const nkw_skin_view joints = {s.joints, 0, NKW_SKIN_U8}, weights = {s.weights, 0, NKW_SKIN_U8};
    s.parts[0].skin.influence_count = 2;
    s.parts[0].skin.joints = joints;
    s.parts[0].skin.weights = weights;
    s.target.deltas.positions.data = s.deltas;
    s.parts[2].morph.targets = &s.target;
    s.parts[2].morph.target_count = 1;
    s.parts[2].morph.vertex_count = VERTICES;
    s.parts[2].float_first = 1;
    s.source.parts = s.parts;
    s.source.part_count = 3;
}

/* Animation 0 turns the arm from 0.5 rad by a quarter turn, and the second float from 0 to 1; animation 1 has no tracks. */
static void set_up_animations(void)
{
    const nkw_vec3 z = {0.0f, 0.0f, 1.0f};
    const nkw_quat turns[2] = {s.rest[ARM].rotation, nkw_quat_from_axis_angle(z, 0.5f + 1.5707964f)};
    s.times[1] = s.weight_keys[1] = 1.0f;
    memcpy(s.rotations, turns, sizeof turns);
    for (size_t i = 0; i < 2; i++) {
        s.tracks[i].track.times = s.times;
        s.tracks[i].track.count = 2;
    }
    s.tracks[0].target = NKW_CLIP_ROTATION;
    s.tracks[0].index = ARM;
    s.tracks[0].track.values = s.rotations;
    s.tracks[0].track.width = 4;
    s.tracks[0].track.kind = NKW_TRACK_ROTATION;
    s.tracks[1].target = NKW_CLIP_FLOATS;
    s.tracks[1].index = 1;
    s.tracks[1].track.values = s.weight_keys;
    s.tracks[1].track.width = 1;
    s.animations[0].name = "wave";
    s.animations[0].tracks = s.tracks;
    s.animations[0].track_count = 2;
    s.source.animations = s.animations;
    s.source.animation_count = 2;
    s.rest_floats[0] = 0.25f;
    s.source.rest_floats = s.rest_floats;
    s.source.float_count = 2;
}

static int set_up(void **state)
{
    (void)state;
    memset(&s, 0, sizeof s);
    set_up_nodes();
    set_up_parts();
    set_up_animations();
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    free(s.block);
    return 0;
}

static void build(void)
{
    size_t bad = 99, again = 0;
    assert_int_equal(nkw_character_build(&s.source, bytes_span(NULL, 0), &s.bytes, NULL, &bad, work()), NKW_OK);
    assert_int_equal(bad, 0);
    s.block = malloc(s.bytes);
    assert_non_null(s.block);
    assert_int_equal(nkw_character_build(&s.source, bytes_span(s.block, s.bytes), &again, &s.c, NULL, work()), NKW_OK);
    assert_int_equal(again, s.bytes);
}

static void refused(nkw_result result, size_t bad)
{
    size_t bytes = 99, found = 99;
    nkw_character c;
    assert_int_equal(nkw_character_build(&s.source, bytes_span(NULL, 0), &bytes, &c, &found, work()), result);
    assert_int_equal(bytes, 0);
    assert_int_equal(found, bad);
}

static void nodes_become_joints_parents_first(void **state)
{
    (void)state;
    build();
    assert_int_equal(s.c.skeleton.joint_count, NODES);
    assert_int_equal(nkw_skeleton_validate(&s.c.skeleton, NULL), NKW_OK);
    assert_int_equal(nkw_mixer_set_validate(&s.c.set, NULL), NKW_OK);
    for (size_t n = 0; n < NODES; n++) {
        const size_t j = (size_t)s.c.joint_of_node[n];
        const nkw_trs rest = nkw_pose_get(s.c.set.rest, j);
        assert_int_equal(s.c.node_of_joint[j], n);
        assert_string_equal(s.c.names[j], names[n]);
        assert_ptr_not_equal(s.c.names[j], names[n]);
        expect_floats_bits(&rest.translation.x, &s.rest[n].translation.x, 10);
        if (s.parents[n] != NKW_NO_JOINT)
            assert_int_equal(s.c.skeleton.parents[j], s.c.joint_of_node[s.parents[n]]);
    }
    assert_string_equal(nkw_clip_describe(s.c.set.clips[0].clip).name, "wave");
    assert_string_equal(nkw_clip_describe(s.c.set.clips[1].clip).name, "");
    expect_bits(s.c.set.rest_floats[0], 0.25f);
}

/* Positions of a part at a time of clip 0. */
static void vertices_at(float time, size_t part, const nkw_mat4 *root, nkw_vec3 *out)
{
    float pose[NKW_POSE_FLOATS(NODES)], floats[2];
    nkw_mat4 models[NODES], palette[8];
    nkw_vertices_span to;
    memset(&to, 0, sizeof to);
    to.positions.data = out;
    assert_int_equal(nkw_clip_sample(s.c.set.clips[0].clip, time, NULL, pose_span(pose, NODES), floats), NKW_OK);
    assert_int_equal(nkw_character_palette(&s.c, pose_view(pose, NODES), root, models, palette), NKW_OK);
    assert_int_equal(nkw_character_vertices(&s.c, part, floats, palette, to), NKW_OK);
}

/* By hand: the arm is at (0, 1, 0), turned by 0.5 rad, then by a quarter turn more about z. */
static void parts_move_with_their_joints(void **state)
{
    (void)state;
    const nkw_vec3 z = {0.0f, 0.0f, 1.0f}, up = {0.0f, 1.0f, 0.0f};
    const nkw_quat quarter = nkw_quat_from_axis_angle(z, 1.5707964f);
    nkw_vec3 got[VERTICES];
    build();
    assert_int_equal(s.c.most_vertices, VERTICES);
    assert_int_equal(s.c.palette.joint_count, 3); /* two of the skin, one that both rigid parts share */
    vertices_at(0.0f, 0, NULL, got);
    for (size_t v = 0; v < VERTICES; v++)
        expect_vec3_near(got[v], s.positions[v], 1e-6);
    vertices_at(1.0f, 0, NULL, got);
    for (size_t v = 0; v < VERTICES; v++)
        expect_vec3_near(got[v], nkw_vec3_add(up, nkw_quat_rotate(quarter, nkw_vec3_sub(s.positions[v], up))), 1e-6);
    const nkw_quat turned = nkw_quat_from_axis_angle(z, 0.5f + 1.5707964f);
    for (size_t part = 1; part < 3; part++) {
        vertices_at(1.0f, part, NULL, got);
        for (size_t v = 0; v < VERTICES; v++) {
            const nkw_vec3 p = part == 2 ? nkw_vec3_add(s.positions[v], s.deltas[v]) : s.positions[v];
            expect_vec3_near(got[v], nkw_vec3_add(up, nkw_quat_rotate(turned, p)), 1e-6);
        }
    }
}

static void a_root_places_all_parts(void **state)
{
    (void)state;
    nkw_trs place = nkw_trs_identity();
    place.translation.x = 8.0f;
    const nkw_mat4 root = nkw_mat4_from_trs(&place);
    build();
    for (size_t part = 0; part < 3; part++) {
        nkw_vec3 here[VERTICES], there[VERTICES];
        vertices_at(0.5f, part, NULL, here);
        vertices_at(0.5f, part, &root, there);
        for (size_t v = 0; v < VERTICES; v++)
            expect_vec3_near(there[v], nkw_vec3_add(here[v], place.translation), 2e-6);
    }
}

static void a_skin_without_matrices_has_identities(void **state)
{
    (void)state;
    nkw_vec3 got[VERTICES];
    s.source.binds_at_rest = 0;
    build();
    vertices_at(0.0f, 0, NULL, got); /* vertex 1 is of the arm */
    expect_vec3_near(
        got[1], nkw_vec3_add(s.rest[ARM].translation, nkw_quat_rotate(s.rest[ARM].rotation, s.positions[1])), 1e-6);
}

static void a_block_that_is_too_small_is_not_written(void **state)
{
    (void)state;
    build();
    unsigned char *guarded = (unsigned char *)malloc(s.bytes);
    size_t bytes = 0;
    nkw_character c;
    assert_non_null(guarded);
    memset(guarded, 0xa5, s.bytes);
    memset(&c, 0xa5, sizeof c);
    assert_int_equal(nkw_character_build(&s.source, bytes_span(guarded, s.bytes - 1), &bytes, &c, NULL, work()),
                     NKW_TOO_SMALL);
    assert_int_equal(bytes, s.bytes);
    for (size_t i = 0; i < s.bytes; i++)
        assert_int_equal(guarded[i], 0xa5);
    assert_int_equal(((unsigned char *)&c)[0], 0xa5);
    free(guarded);
    const nkw_work less = work_in(s.memory, NKW_CHARACTER_WORK(NODES, 2) - 1);
    assert_int_equal(nkw_character_build(&s.source, bytes_span(NULL, 0), &bytes, NULL, NULL, less), NKW_TOO_SMALL);
    assert_int_equal(bytes, 0);
}

static void wrong_sources_name_the_first_offender(void **state)
{
    (void)state;
    s.parents[ROOT] = HAND;
    refused(NKW_NOT_A_TREE, 0);
    s.parents[ROOT] = NKW_NO_JOINT;
    s.skin_joints[1] = NODES;
    refused(NKW_OUT_OF_RANGE, 0);
    s.skin_joints[1] = ARM;
    s.parts[1].joint = -1;
    refused(NKW_OUT_OF_RANGE, 1);
    s.parts[1].joint = ARM;
    s.parts[2].skin_index = 1;
    refused(NKW_OUT_OF_RANGE, 2);
    s.parts[2].skin_index = -2;
    refused(NKW_OUT_OF_RANGE, 2);
    s.parts[2].skin_index = NKW_NO_JOINT;
    s.parts[2].float_first = 2;
    refused(NKW_OUT_OF_RANGE, 2);
    s.parts[2].float_first = SIZE_MAX;
    refused(NKW_OUT_OF_RANGE, 2);
    s.parts[2].float_first = 1;
    s.parts[2].morph.vertex_count = 1;
    refused(NKW_MISMATCHED, 2);
    s.parts[2].morph.vertex_count = VERTICES;
    s.tracks[0].index = NODES;
    refused(NKW_OUT_OF_RANGE, 0);
    s.animations[1] = s.animations[0];
    s.animations[0].track_count = 0;
    s.tracks[0].index = ARM;
    s.times[1] = -1.0f;
    refused(NKW_NOT_ASCENDING, 1);
    s.source.node_count = 0;
    s.source.part_count = s.source.skin_count = 0;
    refused(NKW_EMPTY, 0);
}

static void nodes_alone_are_a_character(void **state)
{
    (void)state;
    nkw_character_source nodes;
    memset(&nodes, 0, sizeof nodes);
    nodes.node_parents = s.parents;
    nodes.node_count = NODES;
    s.source = nodes;
    build();
    assert_int_equal(s.c.set.clip_count, 0);
    assert_int_equal(s.c.palette.joint_count, 0);
    assert_string_equal(s.c.names[2], "");
    const nkw_vertices_span none = {{NULL, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    assert_int_equal(nkw_character_vertices(&s.c, 0, NULL, NULL, none), NKW_OUT_OF_RANGE);
    float pose[NKW_POSE_FLOATS(1)] = {0};
    assert_int_equal(nkw_character_palette(&s.c, pose_view(pose, 1), NULL, NULL, NULL), NKW_MISMATCHED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(nodes_become_joints_parents_first, set_up, tear_down),
        cmocka_unit_test_setup_teardown(parts_move_with_their_joints, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_root_places_all_parts, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_skin_without_matrices_has_identities, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_block_that_is_too_small_is_not_written, set_up, tear_down),
        cmocka_unit_test_setup_teardown(wrong_sources_name_the_first_offender, set_up, tear_down),
        cmocka_unit_test_setup_teardown(nodes_alone_are_a_character, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
