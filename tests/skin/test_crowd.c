/* SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "random.h"
#include "random_clip.h"
#include "support/expect.h"
#include "support/views.h"

#define JOINTS 22

static float poses[NKW_CROWD][NKW_POSE_FLOATS(JOINTS)], crowd[NKW_CROWD_POSE_FLOATS(JOINTS)];
static float models[NKW_CROWD_MATRIX_FLOATS(JOINTS)], roots[NKW_CROWD_MATRIX_FLOATS(1)];
static nkw_mat4 matrices[NKW_CROWD][JOINTS], bind[JOINTS], root[NKW_CROWD];
static int32_t parents[JOINTS];
static const nkw_skeleton skeleton = {parents, JOINTS};
static const float *in[NKW_CROWD];
static const nkw_mat4 *in_roots[NKW_CROWD];
static nkw_mat4 *out[NKW_CROWD];

static nkw_trs some_trs(random_source *r)
{
    nkw_trs trs = {random_vec3(r, -3, 3), random_rotation(r), random_vec3(r, 0.5f, 2)};
    return trs;
}

static void draw(random_source *r)
{
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_trs trs = some_trs(r);
        parents[j] = (int32_t)(random_bits(r) % (j + 1)) - 1;
        bind[j] = nkw_mat4_from_trs(&trs);
    }
    for (size_t i = 0; i < NKW_CROWD; i++) {
        nkw_trs placed = some_trs(r);
        root[i] = nkw_mat4_from_trs(&placed);
        in[i] = poses[i];
        in_roots[i] = &root[i];
        out[i] = matrices[i];
        for (size_t j = 0; j < JOINTS; j++) {
            nkw_trs trs = some_trs(r);
            nkw_pose_set(pose_span(poses[i], JOINTS), j, &trs);
        }
    }
}

static nkw_mat4 local_of(size_t i, size_t j)
{
    nkw_trs trs = nkw_pose_get(pose_view(poses[i], JOINTS), j);
    return nkw_mat4_from_trs(&trs);
}

/* By the single functions. */
static nkw_mat4 model_of(size_t i, size_t j, int rooted)
{
    nkw_mat4 local = local_of(i, j);
    if (parents[j] < 0)
        return rooted ? nkw_mat4_mul_affine(&root[i], &local) : local;
    nkw_mat4 parent = model_of(i, (size_t)parents[j], rooted);
    return nkw_mat4_mul_affine(&parent, &local);
}

static void every_lane_gives_the_bits_of_its_character_alone(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int round = 0; round < 20; round++) {
        draw(&r);
        crowd_from_poses(in, JOINTS, crowd);
        crowd_from_matrices(in_roots, 1, roots);
        crowd_models_from_pose(&skeleton, crowd, round % 2 ? roots : NULL, models);
        matrices_from_crowd(models, JOINTS, out);
        for (size_t i = 0; i < NKW_CROWD; i++)
            for (size_t j = 0; j < JOINTS; j++) {
                nkw_mat4 want = model_of(i, j, round % 2);
                expect_floats_bits(matrices[i][j].m, want.m, 16);
            }
    }
}

static void palettes_are_models_times_inverse_binds(void **state)
{
    (void)state;
    random_source r = random_from(2);
    float palette[NKW_CROWD_MATRIX_FLOATS(4)];
    const int32_t joints[4] = {7, 0, -1, 21};
    const nkw_mat4 identity = nkw_mat4_identity();
    draw(&r);
    crowd_from_poses(in, JOINTS, crowd);
    crowd_models_from_pose(&skeleton, crowd, NULL, models);
    crowd_palette_from_models(models, JOINTS, joints, bind, 4, palette);
    matrices_from_crowd(palette, 4, out);
    for (size_t i = 0; i < NKW_CROWD; i++)
        for (size_t k = 0; k < 4; k++) {
            nkw_mat4 model = k == 2 ? identity : model_of(i, (size_t)joints[k], 0);
            nkw_mat4 want = k == 2 ? identity : nkw_mat4_mul_affine(&model, &bind[k]);
            expect_floats_bits(matrices[i][k].m, want.m, 16);
        }
}

static void palettes_may_take_the_place_of_models(void **state)
{
    (void)state;
    random_source r = random_from(3);
    static float palette[NKW_CROWD_MATRIX_FLOATS(JOINTS)], copied[NKW_CROWD_MATRIX_FLOATS(JOINTS)];
    draw(&r);
    crowd_from_poses(in, JOINTS, crowd);
    crowd_models_from_pose(&skeleton, crowd, NULL, models);
    crowd_palette_from_models(models, JOINTS, NULL, bind, JOINTS, palette);
    crowd_palette_from_models(models, JOINTS, NULL, NULL, JOINTS, copied);
    expect_floats_bits(copied, models, NKW_CROWD_MATRIX_FLOATS(JOINTS));
    crowd_palette_from_models(models, JOINTS, NULL, bind, JOINTS, models);
    expect_floats_bits(models, palette, NKW_CROWD_MATRIX_FLOATS(JOINTS));
}

static void lanes_without_a_character_are_the_identity_and_left_out(void **state)
{
    (void)state;
    random_source r = random_from(4);
    const nkw_mat4 identity = nkw_mat4_identity();
    draw(&r);
    in[5] = NULL;
    in_roots[5] = NULL;
    crowd_from_poses(in, JOINTS, crowd);
    crowd_from_matrices(in_roots, 1, roots);
    crowd_models_from_pose(&skeleton, crowd, roots, models);
    out[6] = NULL;
    nkw_mat4 kept = matrices[6][3];
    matrices_from_crowd(models, JOINTS, out);
    for (size_t j = 0; j < JOINTS; j++)
        expect_floats_bits(matrices[5][j].m, identity.m, 16);
    expect_floats_bits(matrices[6][3].m, kept.m, 16);
}

static void any_parents_stay_within_the_arrays(void **state)
{
    (void)state;
    random_source r = random_from(5);
    draw(&r);
    parents[0] = 5;
    parents[3] = -7;
    parents[4] = 4;
    parents[6] = JOINTS;
    crowd_from_poses(in, JOINTS, crowd);
    crowd_models_from_pose(&skeleton, crowd, NULL, models);
    matrices_from_crowd(models, JOINTS, out);
    const size_t made_roots[4] = {0, 3, 4, 6};
    for (size_t k = 0; k < 4; k++) {
        nkw_mat4 want = local_of(2, made_roots[k]);
        expect_floats_bits(matrices[2][made_roots[k]].m, want.m, 16);
    }
}

static void nothing_is_written_without_joints(void **state)
{
    (void)state;
    float none[1] = {7};
    const nkw_skeleton empty = {NULL, 0};
    crowd_from_poses(in, 0, none);
    crowd_models_from_pose(&empty, none, NULL, none);
    crowd_palette_from_models(none, 0, NULL, NULL, 0, none);
    matrices_from_crowd(none, 0, out);
    expect_bits(none[0], 7.0f);
}

/* A clip of JOINTS joints of every kind of track, to be freed. */
static nkw_clip *some_clip(random_source *r, random_clip *from)
{
    NKW_STACK_WORK(work, NKW_CLIP_BUILD_WORK(RANDOM_CLIP_TRACKS));
    size_t bytes;
    const nkw_clip *clip;
    random_clip_draw(r, JOINTS, 2, from);
    assert_int_equal(nkw_clip_build(&from->source, bytes_span(NULL, 0), &bytes, NULL, work), NKW_TOO_SMALL);
    void *block = malloc(bytes);
    assert_non_null(block);
    assert_int_equal(nkw_clip_build(&from->source, bytes_span(block, bytes), &bytes, NULL, work), NKW_OK);
    assert_int_equal(nkw_clip_open(block, bytes, &clip), NKW_OK);
    return (nkw_clip *)block;
}

static void a_clip_at_many_times_is_the_clip_at_each(void **state)
{
    (void)state;
    static random_clip from;
    NKW_STACK_WORK(work, NKW_CROWD_SAMPLE_WORK(JOINTS));
    static float want[NKW_CROWD_POSE_FLOATS(JOINTS)];
    random_source r = random_from(6);
    nkw_clip *clip = some_clip(&r, &from);
    uint32_t cursors[NKW_CROWD * RANDOM_CLIP_TRACKS] = {0};
    float times[NKW_CROWD];
    assert_true(nkw_clip_describe(clip).cursor_count <= RANDOM_CLIP_TRACKS);
    for (size_t characters = 0; characters <= NKW_CROWD; characters++) {
        for (size_t i = 0; i < NKW_CROWD; i++) {
            times[i] = random_between(&r, -1.0f, 5.0f);
            nkw_clip_sample(clip, times[i], NULL, pose_span(poses[i], nkw_clip_describe(clip).joint_count), NULL);
            in[i] = i < characters ? poses[i] : NULL;
        }
        crowd_from_poses(in, JOINTS, want);
        crowd_sample(clip, times, characters % 2 ? cursors : NULL, characters, work, crowd);
        expect_floats_bits(crowd, want, NKW_CROWD_POSE_FLOATS(JOINTS));
    }
    free(clip);
}

/* Frames 3 .. 22 of 21, of a skin of 5 joints: the first ones and what is beyond the chunk are left alone. */
static void baked_frames_are_palettes_one_by_one(void **state)
{
    (void)state;
    enum { FRAMES = 21, SKIN = 5, FROM = 3, FIRST = 7, ALL = FIRST + FRAMES * SKIN + 4 };
    static random_clip drawn;
    NKW_STACK_WORK(work, NKW_CROWD_BAKE_WORK(JOINTS, SKIN));
    static nkw_mat4 buffer[ALL], want[ALL], alone[JOINTS];
    const int32_t joints[SKIN] = {21, 0, 3, 3, 11};
    const nkw_palette_chunk chunk = {FRAMES, SKIN, FIRST};
    random_source r = random_from(7);
    draw(&r);
    nkw_clip *clip = some_clip(&r, &drawn);
    const nkw_crowd_source source = {clip, &skeleton, &root[0], joints, bind, SKIN, 0.25f, 24.0f};
    for (size_t i = 0; i < ALL; i++)
        buffer[i] = want[i] = nkw_mat4_identity();
    for (size_t f = FROM; f < FRAMES; f++) {
        nkw_clip_sample(clip, nkw_timeline_time((nkw_timeline){0.25f, 24.0f, 0}, f), NULL,
                        pose_span(poses[0], nkw_clip_describe(clip).joint_count), NULL);
        nkw_skeleton_models_from_pose(&skeleton, pose_view(poses[0], skeleton.joint_count), &root[0], NULL, alone);
        palette_from_models(alone, JOINTS, joints, bind, NULL, SKIN, want + FIRST + f * SKIN);
    }
    crowd_bake(&source, &chunk, FROM, FRAMES + 2, work, buffer);
    expect_floats_bits(buffer[0].m, want[0].m, 16 * ALL);
    crowd_bake(&source, &chunk, FRAMES, FRAMES + 9, work, buffer);
    expect_floats_bits(buffer[0].m, want[0].m, 16 * ALL);
    free(clip);
}

static void a_clip_of_other_joints_is_not_baked(void **state)
{
    (void)state;
    static random_clip drawn;
    NKW_STACK_WORK(work, NKW_CROWD_BAKE_WORK(JOINTS, JOINTS));
    random_source r = random_from(8);
    draw(&r);
    nkw_clip *clip = some_clip(&r, &drawn);
    const nkw_skeleton shorter = {parents, JOINTS - 1};
    const nkw_crowd_source source = {clip, &shorter, NULL, NULL, NULL, JOINTS - 1, 0.0f, 30.0f};
    const nkw_palette_chunk chunk = {1, JOINTS - 1, 0};
    nkw_mat4 before = matrices[0][0] = nkw_mat4_identity();
    assert_int_equal(crowd_bake(&source, &chunk, 0, 1, work, matrices[0]), NKW_MISMATCHED);
    expect_floats_bits(matrices[0][0].m, before.m, 16);
    free(clip);
}

static void counts_that_do_not_match_write_nothing(void **state)
{
    (void)state;
    static random_clip drawn;
    static float floats[NKW_CROWD_POSE_FLOATS(JOINTS)];
    NKW_STACK_WORK(work, NKW_CROWD_BAKE_WORK(JOINTS, JOINTS));
    const nkw_work small = {work.data, NKW_CROWD_SAMPLE_WORK(JOINTS) - 1}, less = {work.data, work.bytes - 1};
    const nkw_work misaligned = {(unsigned char *)work.data + 4, work.bytes};
    random_source r = random_from(10);
    draw(&r);
    nkw_clip *clip = some_clip(&r, &drawn);
    const float time = 0.5f;
    const nkw_crowd_players players = {&time, NULL, 1};
    const nkw_crowd_source source = {clip, &skeleton, NULL, NULL, NULL, JOINTS, 0.0f, 30.0f};
    const nkw_palette_chunk chunk = {1, JOINTS, 0}, thin = {1, JOINTS - 1, 0};
    nkw_pose_view views[NKW_CROWD] = {{NULL, 0}};
    floats[0] = 7.0f;
    const nkw_crowd_poses_span span = crowd_poses_span(floats, JOINTS);
    assert_int_equal(nkw_crowd_sample(&players, clip, crowd_poses_span(floats, JOINTS - 1), work), NKW_MISMATCHED);
    assert_int_equal(nkw_crowd_sample(&players, clip, span, small), NKW_TOO_SMALL);
    assert_int_equal(nkw_crowd_sample(&players, clip, span, misaligned), NKW_TOO_SMALL);
    views[3] = pose_view(poses[0], JOINTS - 1);
    assert_int_equal(nkw_crowd_from_poses(views, crowd_poses_span(floats, JOINTS)), NKW_MISMATCHED);
    assert_int_equal(nkw_crowd_models_from_pose(&skeleton, crowd_poses_view(floats, JOINTS),
                                                crowd_matrices_view(floats, 2), crowd_matrices_span(floats, JOINTS)),
                     NKW_MISMATCHED);
    /* Each of the three by itself. */
    assert_int_equal(nkw_crowd_models_from_pose(&skeleton, crowd_poses_view(floats, JOINTS - 1),
                                                crowd_matrices_view(NULL, 0), crowd_matrices_span(floats, JOINTS)),
                     NKW_MISMATCHED);
    assert_int_equal(nkw_crowd_models_from_pose(&skeleton, crowd_poses_view(floats, JOINTS),
                                                crowd_matrices_view(NULL, 0), crowd_matrices_span(floats, JOINTS - 1)),
                     NKW_MISMATCHED);
    assert_int_equal(nkw_crowd_models_from_pose(&skeleton, crowd_poses_view(floats, JOINTS),
                                                crowd_matrices_view(floats, 0), crowd_matrices_span(floats, JOINTS)),
                     NKW_MISMATCHED);
    assert_int_equal(nkw_crowd_bake(&source, &thin, NULL, matrices[0], NULL, work), NKW_MISMATCHED);
    assert_int_equal(nkw_crowd_bake(&source, &chunk, NULL, matrices[0], NULL, less), NKW_TOO_SMALL);
    assert_int_equal(nkw_crowd_bake(&source, &chunk, NULL, matrices[0], NULL, misaligned), NKW_TOO_SMALL);
    assert_int_equal(nkw_crowd_bake(&source, &chunk, NULL, matrices[0], NULL, work), NKW_OK);
    expect_bits(floats[0], 7.0f);
    free(clip);
}

static void expect_invalid(const nkw_crowd_source *source, nkw_result result, size_t joint)
{
    NKW_STACK_WORK(work, NKW_CROWD_BAKE_WORK(JOINTS, 3));
    const nkw_palette_chunk chunk = {1, source->joint_count, 0};
    const nkw_mat4 before = matrices[0][0] = nkw_mat4_identity();
    size_t bad = 99;
    assert_int_equal(nkw_crowd_bake(source, &chunk, NULL, matrices[0], &bad, work), result);
    assert_int_equal(bad, joint);
    assert_int_equal(nkw_crowd_bake(source, &chunk, NULL, matrices[0], NULL, work), result);
    if (result != NKW_OK)
        expect_floats_bits(matrices[0][0].m, before.m, 16);
}

static void bake_names_the_first_offender(void **state)
{
    (void)state;
    static random_clip drawn;
    random_source r = random_from(9);
    draw(&r);
    nkw_clip *clip = some_clip(&r, &drawn);
    int32_t joints[3] = {0, 21, 4};
    nkw_crowd_source source = {clip, &skeleton, &root[0], joints, bind, 3, 0.0f, -30.0f};
    expect_invalid(&source, NKW_OK, 0);
    source.joint_count = 0;
    expect_invalid(&source, NKW_EMPTY, 0);
    source.joint_count = 3;
    bind[2].m[5] = NAN;
    expect_invalid(&source, NKW_NOT_FINITE, 2);
    joints[1] = JOINTS;
    expect_invalid(&source, NKW_OUT_OF_RANGE, 1);
    source.rate = 0.0f;
    expect_invalid(&source, NKW_OUT_OF_RANGE, 0);
    source.rate = INFINITY;
    expect_invalid(&source, NKW_NOT_FINITE, 0);
    source.rate = 30.0f;
    source.start = NAN;
    expect_invalid(&source, NKW_NOT_FINITE, 0);
    source.start = 0.0f;
    root[0].m[14] = INFINITY;
    expect_invalid(&source, NKW_NOT_FINITE, 0);
    const nkw_skeleton shorter = {parents, JOINTS - 1};
    source.skeleton = &shorter;
    expect_invalid(&source, NKW_MISMATCHED, 0);
    parents[7] = 7;
    expect_invalid(&source, NKW_NOT_ORDERED, 7);
    free(clip);
}

enum { VERTICES = 75, INFLUENCES = 5 }; /* more than a block; groups and blocks end within */

static float weights[VERTICES * INFLUENCES], bind_vectors[4][VERTICES * 4], results[2][NKW_CROWD][4][VERTICES * 4];
static uint8_t indices[VERTICES * INFLUENCES];

/* Vertices without weights, joints beyond the palette, zero directions. */
static void draw_skin(random_source *r)
{
    for (size_t i = 0; i < VERTICES * INFLUENCES; i++) {
        indices[i] = (uint8_t)(random_bits(r) % (JOINTS + 1));
        weights[i] = i / INFLUENCES % 11 == 3 ? 0.0f : random_unit(r);
    }
    for (size_t v = 0; v < 4; v++)
        for (size_t i = 0; i < VERTICES * 4; i++)
            bind_vectors[v][i] = i / 3 % 13 == 0 ? 0.0f : random_between(r, -1, 1);
}

/* The streams that `mask` names. */
static nkw_vertices_view bind_streams(int mask)
{
    nkw_vertices_view v = {{mask & 1 ? bind_vectors[0] : NULL, 0},
                           {mask & 2 ? bind_vectors[1] : NULL, 12},
                           {mask & 4 ? bind_vectors[2] : NULL, 16},
                           {mask & 8 ? bind_vectors[3] : NULL, 0}};
    return v;
}

static nkw_vertices_span result_streams(int which, size_t lane, int mask, size_t stride)
{
    float(*to)[VERTICES * 4] = results[which][lane];
    nkw_vertices_span v = {{mask & 1 ? to[0] : NULL, stride},
                           {mask & 2 ? to[1] : NULL, stride},
                           {mask & 4 ? to[2] : NULL, stride},
                           {mask & 8 ? to[3] : NULL, stride}};
    return v;
}

static void compare_skins(const nkw_skin *skin, nkw_skin_options options, int in_mask, int out_mask, size_t stride)
{
    const nkw_vertices_view view = bind_streams(in_mask);
    nkw_vertices_span outs[NKW_CROWD];
    memset(results, 0, sizeof results);
    for (size_t i = 0; i < NKW_CROWD; i++) {
        const int mask = i == 6 ? 0 : i == 9 ? out_mask & 2 : out_mask;
        const nkw_skin_palette palette = {
            {matrices[i], JOINTS, NKW_PALETTE_MAT4}, {NULL, 0, NKW_PALETTE_MAT4}, options};
        /* One lane with another stride, so that not all outputs are contiguous. */
        const size_t apart = i == 12 && !options.keep_length ? 16 : stride;
        const nkw_vertices_span alone = result_streams(0, i, mask, apart);
        outs[i] = result_streams(1, i, mask, apart);
        assert_int_equal(nkw_skin_linear(skin, &palette, view, alone), NKW_OK);
    }
    assert_int_equal(nkw_crowd_skin(crowd_matrices_view(models, JOINTS), skin, view, options, outs), NKW_OK);
    expect_floats_bits(results[1][0][0], results[0][0][0], sizeof results[0] / sizeof(float));
}

static void every_lane_is_skinned_as_its_character_alone(void **state)
{
    (void)state;
    random_source r = random_from(12);
    draw(&r);
    draw_skin(&r);
    crowd_from_poses(in, JOINTS, crowd);
    crowd_models_from_pose(&skeleton, crowd, NULL, models);
    matrices_from_crowd(models, JOINTS, out);
    for (int round = 0; round < 64; round++) {
        const size_t k = (size_t)round % (INFLUENCES + 1);
        nkw_skin skin = {
            round % 7 == 6 ? VERTICES - 2 : VERTICES, k, {indices, 0, NKW_SKIN_U8}, {weights, 0, NKW_SKIN_F32}};
        if (round % 5 == 4)
            skin.weights.format = NKW_SKIN_U8;
        const nkw_skin_options options = {round % 2, round / 2 % 2, round / 4 % 2};
        compare_skins(&skin, options, round % 3 ? 15 : 1 + round % 15, round % 4 ? 15 : 3, round % 8 < 4 ? 12 : 16);
    }
}

static void a_crowd_is_copied_where_formats_do_not_fit(void **state)
{
    (void)state;
    random_source r = random_from(13);
    draw_skin(&r);
    const nkw_skin skin = {VERTICES, 4, {indices, 0, NKW_SKIN_FORMAT_MAX_ENUM}, {weights, 0, NKW_SKIN_F32}};
    const nkw_vertices_view view = bind_streams(1);
    nkw_vertices_span outs[NKW_CROWD];
    for (size_t i = 0; i < NKW_CROWD; i++)
        outs[i] = result_streams(0, i, 1, 12);
    assert_int_equal(
        nkw_crowd_skin(crowd_matrices_view(models, JOINTS), &skin, view, (nkw_skin_options){0, 0, 0}, outs),
        NKW_BAD_FORMAT);
    for (size_t i = 0; i < NKW_CROWD; i++)
        expect_floats_bits(results[0][i][0], bind_vectors[0], 3 * VERTICES);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_lane_gives_the_bits_of_its_character_alone),
        cmocka_unit_test(palettes_are_models_times_inverse_binds),
        cmocka_unit_test(palettes_may_take_the_place_of_models),
        cmocka_unit_test(lanes_without_a_character_are_the_identity_and_left_out),
        cmocka_unit_test(a_clip_at_many_times_is_the_clip_at_each),
        cmocka_unit_test(baked_frames_are_palettes_one_by_one),
        cmocka_unit_test(a_clip_of_other_joints_is_not_baked),
        cmocka_unit_test(counts_that_do_not_match_write_nothing),
        cmocka_unit_test(bake_names_the_first_offender),
        cmocka_unit_test(every_lane_is_skinned_as_its_character_alone),
        cmocka_unit_test(a_crowd_is_copied_where_formats_do_not_fit),
        cmocka_unit_test(any_parents_stay_within_the_arrays),
        cmocka_unit_test(nothing_is_written_without_joints),
    };
    return cmocka_run_group_tests_name("crowd", tests, NULL, NULL);
}
