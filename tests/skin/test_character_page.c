/* SPDX-License-Identifier: MIT */
/*
 * The program of docs/character.md, with a character of two joints: base and tip, a metre apart, and a strip of four
 * vertices along y. The file lists the tip before the base, and the mesh's node before both.
 */
#include <math.h>
#include <stdlib.h>

#include "character.c" /* the blocks of the page */
#include "support/expect.h"

enum { STRIP, TIP, BASE, NODES, TAKEN = 64 };

static void *taken[TAKEN];

void *take(size_t count, size_t size)
{
    void *memory = calloc(count ? count : 1, size);
    assert_non_null(memory);
    for (int i = 0; i < TAKEN; i++)
        if (!taken[i])
            return taken[i] = memory;
    fail();
    return NULL;
}

void give(void *memory)
{
    for (int i = 0; i < TAKEN; i++)
        if (taken[i] == memory)
            taken[i] = NULL;
    free(memory);
}

static int give_all(void **state)
{
    (void)state;
    for (int i = 0; i < TAKEN; i++)
        give(taken[i]);
    return 0;
}

static const int32_t node_parents[NODES] = {NKW_NO_JOINT, BASE, NKW_NO_JOINT};
static const nkw_trs node_trs[NODES] = {
    {{9, 9, 9}, {0, 0, 0, 1}, {2, 2, 2}},
    {{0, 1, 0}, {0, 0, 0, 1}, {1, 1, 1}},
    {{1, 0, 0}, {0, 0, 0, 1}, {1, 1, 1}},
};
static const int32_t skin_nodes[2] = {BASE, TIP};
static const nkw_mat4 inverse_bind[2] = {
    {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1}},
    {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, -1, 0, 1}},
};
static const nkw_vec3 bind_positions[4] = {{1, 0, 0}, {1, 1, 0}, {1, 2, 0}, {2, 2, 0}};
static const unsigned char joints[4][4] = {{0, 1, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}};
static const float joint_weights[4][4] = {{1, 0, 0, 0}, {0.5f, 0.5f, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}};
static const float rest_weights[2] = {0.25f, 0};

/* From 0.5 s to 1.5 s the tip turns by 90 degrees about z, the base goes two metres, two targets come in. */
static const float bend_times[2] = {0.5f, 1.5f};
static const float bend_turns[8] = {0, 0, 0, 1, 0, 0, 0.70710678f, 0.70710678f};
static const float bend_ways[6] = {1, 0, 0, 3, 0, 0};
static const float bend_weights[4] = {0, 0, 1, 0.5f};
static const channel bend[3] = {
    {TIP, 2, 4, NKW_CLIP_ROTATION, NKW_INTERPOLATION_LINEAR, bend_times, bend_turns},
    {BASE, 2, 3, NKW_CLIP_TRANSLATION, NKW_INTERPOLATION_LINEAR, bend_times, bend_ways},
    {STRIP, 2, 2, NKW_CLIP_FLOATS, NKW_INTERPOLATION_LINEAR, bend_times, bend_weights},
};
/* The base is four metres up all the time, the rest as it rests. */
static const float lift_times[2] = {0, 2}, lift_ways[6] = {1, 4, 0, 1, 4, 0};
static const channel lift[1] = {
    {BASE, 2, 3, NKW_CLIP_TRANSLATION, NKW_INTERPOLATION_STEP, lift_times, lift_ways},
};

static void load(character *c, actor *a)
{
    const nkw_clip *first, *second;
    size_t bad;
    memset(c, 0, sizeof *c);
    c->weight_count = 2;
    c->rest_weights = rest_weights;
    assert_int_equal(load_nodes(c, node_parents, node_trs, NODES, &bad), NKW_OK);
    assert_int_equal(load_skin(c, skin_nodes, inverse_bind, 2, &bad), NKW_OK);
    assert_int_equal(load_clip(c, bend, 3, &first, &bad), NKW_OK);
    assert_int_equal(load_clip(c, lift, 1, &second, &bad), NKW_OK);
    make_actor(c, first, second, a);
}

/* The strip at a moment: its vertices after the skin, at x, y in pairs. */
static void expect_strip(const character *c, actor *a, float seconds, float fade, const float *xy)
{
    const nkw_skin skin = {4, 4, {joints, 0, NKW_SKIN_U8}, {joint_weights, 0, NKW_SKIN_F32}};
    const nkw_vertices_view in = {{bind_positions, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    nkw_vec3 moved[4];
    const nkw_vertices_span out = {{moved, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
    const float both[2] = {seconds, seconds};
    size_t bad;
    assert_int_equal(nkw_skin_validate(&skin, c->skin_count, &bad), NKW_OK);
    animate(c, a, both, fade, NULL);
    skin_mesh(c, a, &skin, in, out);
    for (int v = 0; v < 4; v++) {
        const nkw_vec3 want = {xy[2 * v], xy[2 * v + 1], 0};
        expect_vec3_near(moved[v], want, 1e-6);
    }
}

static void at_the_first_key_vertices_stand_where_they_were_bound(void **state)
{
    static const float bound[8] = {1, 0, 1, 1, 1, 2, 2, 2};
    character c;
    actor a;
    (void)state;
    load(&c, &a);
    expect_strip(&c, &a, 0, 0, bound);
    expect_strip(&c, &a, 1, 0, bound); /* the next pass: the clip is one second long */
}

static void half_way_the_tip_has_turned_by_half_the_angle(void **state)
{
    const float s = 0.70710678f, xy[8] = {2, 0, 2, 1, 2 - s, 1 + s, 2, 1 + 2 * s};
    character c;
    actor a;
    (void)state;
    load(&c, &a);
    expect_strip(&c, &a, 0.5f, 0, xy);
    expect_strip(&c, &a, 7.5f, 0, xy);
    expect_near(a.weights[0][0], 0.5, 1e-7);
    expect_near(a.weights[0][1], 0.25, 1e-7);
}

static void two_clips_blend_with_their_weights(void **state)
{
    const double eighth = 3.14159265358979 / 8;
    const float x = (float)sin(eighth), y = (float)cos(eighth);
    const float half[8] = {1.5f, 2, 1.5f, 3, 1.5f - x, 3 + y, 1.5f + y - x, 3 + x + y};
    static const float lifted[8] = {1, 4, 1, 5, 1, 6, 2, 6};
    character c;
    actor a;
    (void)state;
    load(&c, &a);
    expect_strip(&c, &a, 0.5f, 0.5f, half);
    expect_near(a.weights[0][0], 0.375, 1e-7);
    expect_near(a.weights[0][1], 0.125, 1e-7);
    expect_strip(&c, &a, 0.5f, 1, lifted);
    expect_near(a.weights[0][0], 0.25, 0);
}

static void nodes_are_found_by_the_map_and_stand_below_their_place(void **state)
{
    static const nkw_mat4 place = {{0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 10, 20, 30, 1}}; /* x to y, y to -x */
    static const float seconds[2] = {0.5f, 0};
    character c;
    actor a;
    (void)state;
    load(&c, &a);
    animate(&c, &a, seconds, 0, &place);
    const float *tip = a.models[c.joint_of_node[TIP]].m, *strip = a.models[c.joint_of_node[STRIP]].m;
    const float tip_at[3] = {10 - 1, 20 + 2, 30}, strip_at[3] = {10 - 9, 20 + 9, 30 + 9};
    expect_floats_near(tip + 12, tip_at, 3, 1e-5);
    expect_floats_near(strip + 12, strip_at, 3, 1e-5);
}

static void morph_targets_add_their_weights_times_their_differences(void **state)
{
    static const nkw_vec3 wide[4] = {{1, 0, 0}, {2, 0, 0}, {0, 0, 0}, {0, 0, 4}}, high[4] = {{0, 8, 0}};
    const nkw_vec3 *const targets[2] = {wide, high};
    static const float weights[2] = {0.5f, 0.25f};
    static const nkw_vec3 want[4] = {{1.5f, 2, 0}, {2, 1, 0}, {1, 2, 0}, {2, 2, 2}};
    nkw_vec3 out[4];
    (void)state;
    morph(bind_positions, targets, weights, 2, out, 4);
    for (int v = 0; v < 4; v++)
        expect_vec3_near(out[v], want[v], 0);
}

static void errors_name_the_files_own_numbers(void **state)
{
    static const int32_t circle[NODES] = {NKW_NO_JOINT, BASE, TIP};
    static const nkw_mat4 not_finite[2] = {{{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}, {{NAN}}};
    nkw_trs no_turn[NODES];
    channel narrow[3];
    const nkw_clip *clip;
    character c;
    actor a;
    size_t bad;
    (void)state;
    load(&c, &a);
    memcpy(narrow, bend, sizeof bend);
    narrow[1].width = 2;
    assert_int_equal(load_clip(&c, narrow, 3, &clip, &bad), NKW_BAD_WIDTH);
    assert_int_equal(bad, 1);
    assert_null(clip);
    assert_int_equal(load_skin(&c, skin_nodes, not_finite, 2, &bad), NKW_NOT_FINITE);
    assert_int_equal(bad, 1);
    assert_int_equal(load_nodes(&c, circle, node_trs, NODES, &bad), NKW_NOT_A_TREE);
    assert_int_equal(bad, TIP);
    memcpy(no_turn, node_trs, sizeof no_turn);
    no_turn[TIP].rotation.w = 0;
    assert_int_equal(load_nodes(&c, node_parents, no_turn, NODES, &bad), NKW_NOT_UNIT);
    assert_int_equal(bad, TIP);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(at_the_first_key_vertices_stand_where_they_were_bound, give_all),
        cmocka_unit_test_teardown(half_way_the_tip_has_turned_by_half_the_angle, give_all),
        cmocka_unit_test_teardown(two_clips_blend_with_their_weights, give_all),
        cmocka_unit_test_teardown(nodes_are_found_by_the_map_and_stand_below_their_place, give_all),
        cmocka_unit_test_teardown(morph_targets_add_their_weights_times_their_differences, give_all),
        cmocka_unit_test_teardown(errors_name_the_files_own_numbers, give_all),
    };
    return cmocka_run_group_tests_name("character", tests, NULL, NULL);
}
