/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "random.h"
#include "support/expect.h"
#include "views.h"

enum { MOST = 300, LAYERS = 5 };

static const size_t counts[] = {0,  1,  2,  3,  4,  5,  7,   8,   9,   15,  16,  17,  23,
                                31, 32, 33, 64, 65, 67, 127, 128, 129, 131, 151, MOST};
#define COUNTS (sizeof counts / sizeof *counts)

static nkw_trs records[LAYERS][MOST + 1], result[MOST + 1], expected[MOST];
static float poses[LAYERS][NKW_POSE_FLOATS(MOST)], masks[LAYERS][NKW_POSE_STRIDE(MOST)], out[NKW_POSE_FLOATS(MOST)];
static unsigned char memory[64 * 1024];

static const nkw_mask_view whole = {NULL, 0};

static nkw_records_view view(const nkw_trs *trs, size_t n)
{
    nkw_records_view r = {trs, n};
    return r;
}

static nkw_records_span span(nkw_trs *trs, size_t n)
{
    nkw_records_span r = {trs, n};
    return r;
}

/* Poses that share some rotations and numbers, some of the other sign; lengths of rotations that are far from 1. */
static void draw(random_source *r, size_t n, int far)
{
    for (size_t k = 0; k < LAYERS; k++) {
        for (size_t j = 0; j < n; j++) {
            nkw_trs trs = {random_vec3(r, -5, 5), random_rotation(r), random_vec3(r, -2, 2)};
            if (k > 0 && j % 3 == 0)
                trs.rotation = random_bits(r) % 2 ? records[0][j].rotation : nkw_quat_negate(records[0][j].rotation);
            if (k > 0 && j % 4 == 0)
                trs.translation = records[0][j].translation;
            if (far && j % 7 == 0)
                trs.rotation = nkw_quat_scale(trs.rotation, random_bits(r) % 2 ? 0x1p-70f : 0x1p66f);
            records[k][j] = trs;
            masks[k][j] = random_bits(r) % 4 == 0 ? 0.0f : random_between(r, -0.25f, 1.25f);
        }
        nkw_pose_from_trs(records[k], pose_span(poses[k], n));
    }
}

/* What the function of poses wrote to `out`; the record behind the result keeps its bytes. */
static void expect_result(size_t n)
{
    nkw_trs guard;
    memset(&guard, 0xa5, sizeof guard);
    nkw_trs_from_pose(pose_view(out, n), expected);
    assert_memory_equal(result, expected, n * sizeof *result);
    assert_memory_equal(&result[n], &guard, sizeof guard);
}

static nkw_records_span fresh(size_t n)
{
    memset(result, 0xa5, sizeof result);
    return span(result, n);
}

static void a_pose_from_records_and_back_is_unchanged(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (size_t c = 0; c < COUNTS; c++) {
        const size_t n = counts[c], stride = NKW_POSE_STRIDE(n);
        draw(&r, n, 0);
        for (size_t j = 0; j < n; j++) {
            const nkw_trs t = nkw_pose_get(pose_view(poses[0], n), j);
            assert_memory_equal(&t, &records[0][j], sizeof t);
        }
        for (size_t i = 0; i < 10; i++)
            for (size_t j = n; j < stride; j++)
                expect_bits(poses[0][i * stride + j], i < 6 ? 0.0f : 1.0f);
        memcpy(out, poses[0], sizeof out);
        fresh(n);
        nkw_trs_from_pose(pose_view(out, n), result);
        expect_result(n);
        assert_memory_equal(result, records[0], n * sizeof *result);
    }
}

static void blends_are_those_of_poses(void **state)
{
    static const float ts[] = {0.3f, 0.5f, 0.75f, 0.0f, 1.0f, -0.5f, 1.75f, NAN};
    (void)state;
    random_source r = random_from(2);
    for (size_t c = 0; c < COUNTS; c++)
        for (size_t i = 0; i < 2 * sizeof ts / sizeof *ts; i++) {
            const size_t n = counts[c];
            const float t = ts[i / 2];
            const nkw_mask_view mask = i % 2 ? mask_view(masks[0], n) : whole;
            draw(&r, n, c % 2 == 0);
            assert_int_equal(nkw_pose_blend(pose_view(poses[0], n), pose_view(poses[1], n), t, mask, pose_span(out, n)),
                             NKW_OK);
            assert_int_equal(nkw_records_blend(view(records[0], n), view(records[1], n), t, mask, fresh(n)), NKW_OK);
            expect_result(n);
            nkw_records_blend(view(records[0], n), view(records[1], n), t, mask, span(records[i % 2], n));
            assert_memory_equal(records[i % 2], expected, n * sizeof *expected);
        }
}

static void layers_are_those_of_poses(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (size_t c = 0; c < COUNTS; c++)
        for (size_t i = 0; i < 16; i++) {
            const size_t n = counts[c], count = i % LAYERS;
            nkw_pose_layer layers[LAYERS];
            nkw_records_layer same[LAYERS];
            draw(&r, n, 0);
            for (size_t k = 0; k < LAYERS; k++) {
                const float weight = i % 3 ? random_between(&r, -0.25f, 2) : 0.25f;
                const nkw_mask_view mask = i & 1 ? mask_view(masks[k], n) : whole;
                const nkw_pose_layer layer = {pose_view(poses[k], n), weight, mask};
                const nkw_records_layer record = {view(records[k], n), weight, mask};
                layers[k] = layer;
                same[k] = record;
            }
            nkw_pose_layers_blend(layers, count, pose_view(poses[LAYERS - 1], n), 0.75f, pose_span(out, n));
            assert_int_equal(nkw_records_layers_blend(same, count, view(records[LAYERS - 1], n), 0.75f, fresh(n),
                                                      work_in(memory, sizeof memory)),
                             NKW_OK);
            expect_result(n);
        }
}

static void additive_poses_are_those_of_poses(void **state)
{
    static float delta[NKW_POSE_FLOATS(MOST)];
    (void)state;
    random_source r = random_from(4);
    for (size_t c = 0; c < COUNTS; c++)
        for (size_t i = 0; i < 8; i++) {
            const size_t n = counts[c];
            const nkw_additive side = i & 1 ? NKW_ADDITIVE_PARENT : NKW_ADDITIVE_LOCAL;
            const nkw_mask_view mask = i & 2 ? mask_view(masks[0], n) : whole;
            const float weight = i & 4 ? 1.5f : 0.75f;
            draw(&r, n, 0);
            nkw_pose_additive_build(pose_view(poses[0], n), pose_view(poses[1], n), side, pose_span(out, n));
            assert_int_equal(nkw_records_additive_build(view(records[0], n), view(records[1], n), side, fresh(n)),
                             NKW_OK);
            expect_result(n);
            nkw_pose_from_trs(result, pose_span(delta, n));
            nkw_pose_additive_apply(pose_view(poses[2], n), pose_view(delta, n), weight, mask, side, pose_span(out, n));
            assert_int_equal(
                nkw_records_additive_apply(view(records[2], n), view(result, n), weight, mask, side, span(result, n)),
                NKW_OK);
            expect_result(n);
        }
}

/* The table of the page: t, the weight of a layer, the weight of an additive pose, a mask. */
static void weights_above_one_and_below_zero(void **state)
{
    static const struct {
        float given, blend, layer, additive, mask;
    } rows[] = {{-0.5f, -0.5f, 0, 0, 0}, {1.5f, 1.5f, 0.6f, 1.5f, 1}, {NAN, 0, 0, 0, 0}};
    (void)state;
    nkw_trs a = nkw_trs_identity(), b = a, none = a;
    a.translation.x = 0;
    b.translation.x = 1;
    for (size_t i = 0; i < 3; i++) {
        const float w = rows[i].given, mask[NKW_POSE_STRIDE(1)] = {w};
        const nkw_records_layer layers[2] = {{view(&b, 1), w, whole}, {view(&a, 1), 1, whole}};
        nkw_records_blend(view(&a, 1), view(&b, 1), w, whole, span(result, 1));
        expect_bits(result[0].translation.x, rows[i].blend);
        nkw_records_layers_blend(layers, 2, view(&none, 1), 0, span(result, 1), work_in(memory, sizeof memory));
        expect_bits(result[0].translation.x, rows[i].layer);
        nkw_records_additive_apply(view(&a, 1), view(&b, 1), w, whole, NKW_ADDITIVE_LOCAL, span(result, 1));
        expect_bits(result[0].translation.x, rows[i].additive);
        nkw_records_blend(view(&a, 1), view(&b, 1), 1, mask_view(mask, 1), span(result, 1));
        expect_bits(result[0].translation.x, rows[i].mask);
    }
}

static void models_are_those_of_poses(void **state)
{
    static nkw_mat4 models[MOST], same[MOST];
    static int32_t parents[MOST];
    (void)state;
    random_source r = random_from(5);
    for (size_t c = 0; c < COUNTS; c++)
        for (size_t i = 0; i < 4; i++) {
            const size_t n = counts[c];
            const nkw_range range = {n / 3, n - n / 5};
            const nkw_skeleton skeleton = {parents, n};
            nkw_mat4 root = nkw_mat4_from_translation(random_vec3(&r, -1, 1));
            draw(&r, n, 0);
            for (size_t j = 0; j < n; j++)
                parents[j] = (int32_t)j - 1 - (int32_t)(random_bits(&r) % 3);
            memset(models, 0, sizeof models);
            memset(same, 0, sizeof same);
            nkw_skeleton_models_from_pose(&skeleton, pose_view(poses[0], n), i & 1 ? &root : NULL,
                                          i & 2 ? &range : NULL, models);
            assert_int_equal(nkw_skeleton_models_from_records(&skeleton, view(records[0], n), i & 1 ? &root : NULL,
                                                              i & 2 ? &range : NULL, same),
                             NKW_OK);
            assert_memory_equal(models, same, sizeof models);
        }
    const nkw_skeleton skeleton = {parents, 3};
    assert_int_equal(nkw_skeleton_models_from_records(&skeleton, view(records[0], 2), NULL, NULL, same),
                     NKW_MISMATCHED);
}

/* Two keys of a rotation, and a number. */
static const nkw_clip *build_clip(size_t n, nkw_clip_track *tracks, unsigned char *block, size_t bytes)
{
    static const float times[2] = {0, 2}, values[8] = {0, 0, 0, 1, 0.6f, 0, 0, 0.8f}, numbers[2] = {1, 3};
    memset(tracks, 0, (n + 1) * sizeof *tracks);
    for (size_t k = 0; k <= n; k++) {
        tracks[k].target = k < n ? NKW_CLIP_ROTATION : NKW_CLIP_FLOATS;
        tracks[k].index = k < n ? (uint32_t)k : 0;
        tracks[k].track.times = times;
        tracks[k].track.values = k < n ? values : numbers;
        tracks[k].track.count = 2;
        tracks[k].track.width = k < n ? 4 : 1;
        tracks[k].track.kind = k < n ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
        tracks[k].track.interpolation = NKW_INTERPOLATION_LINEAR;
    }
    nkw_clip_source source;
    memset(&source, 0, sizeof source);
    source.tracks = tracks;
    source.track_count = n + 1;
    source.joint_count = n;
    source.float_count = 1;
    size_t used, bad;
    assert_int_equal(nkw_clip_build(&source, bytes_span(block, bytes), &used, &bad, work_in(memory, sizeof memory)),
                     NKW_OK);
    return (const nkw_clip *)(const void *)block;
}

static void clips_are_sampled_as_into_poses(void **state)
{
    static nkw_clip_track tracks[MOST + 1];
    static uint32_t block[64 * 1024];
    (void)state;
    for (size_t c = 1; c < COUNTS; c++) {
        const size_t n = counts[c];
        const nkw_clip *clip = build_clip(n, tracks, (unsigned char *)block, sizeof block);
        uint32_t cursors[4] = {0};
        float number, same;
        nkw_clip_sample(clip, 0.75f, NULL, pose_span(out, n), &number);
        assert_int_equal(nkw_clip_sample_records(clip, 0.75f, cursors, fresh(n), &same, work_in(memory, sizeof memory)),
                         NKW_OK);
        expect_result(n);
        expect_bits(same, number);
        same = 0.0f;
        assert_int_equal(nkw_clip_sample_records(clip, 0.75f, NULL, span(NULL, 0), &same, work_in(NULL, 0)), NKW_OK);
        expect_bits(same, number);
        const nkw_work little = {memory, NKW_CLIP_RECORDS_WORK(n) - 1};
        assert_int_equal(nkw_clip_sample_records(clip, 0, NULL, span(result, n), NULL, little), NKW_TOO_SMALL);
        assert_int_equal(
            nkw_clip_sample_records(clip, 0, NULL, span(result, n - 1), NULL, work_in(memory, sizeof memory)),
            NKW_MISMATCHED);
        expect_result(n);
    }
}

static void what_does_not_fit_is_refused(void **state)
{
    (void)state;
    const nkw_work work = work_in(memory, sizeof memory), little = {work.data, NKW_RECORDS_LAYERS_WORK(1) - 1};
    const nkw_records_view three = view(records[0], 3), two = view(records[1], 2);
    const nkw_records_layer layer = {three, 1, whole}, other = {three, 1, mask_view(masks[0], 2)};
    random_source r = random_from(6);
    draw(&r, 3, 0);
    const nkw_records_span o = fresh(3);
    assert_int_equal(nkw_records_blend(three, two, 0.5f, whole, o), NKW_MISMATCHED);
    assert_int_equal(nkw_records_blend(two, three, 0.5f, whole, o), NKW_MISMATCHED);
    assert_int_equal(nkw_records_blend(three, three, 0.5f, mask_view(masks[0], 2), o), NKW_MISMATCHED);
    assert_int_equal(nkw_records_layers_blend(&layer, 1, two, 0, o, work), NKW_MISMATCHED);
    assert_int_equal(nkw_records_layers_blend(&other, 1, three, 0, o, work), NKW_MISMATCHED);
    assert_int_equal(nkw_records_layers_blend(&layer, 1, three, 0, o, little), NKW_TOO_SMALL);
    assert_int_equal(nkw_records_additive_build(three, two, NKW_ADDITIVE_LOCAL, o), NKW_MISMATCHED);
    assert_int_equal(nkw_records_additive_build(three, three, (nkw_additive)2, o), NKW_BAD_METHOD);
    assert_int_equal(nkw_records_additive_apply(three, two, 1, whole, NKW_ADDITIVE_LOCAL, o), NKW_MISMATCHED);
    assert_int_equal(nkw_records_additive_apply(three, three, 1, whole, (nkw_additive)2, o), NKW_BAD_METHOD);
    for (size_t i = 0; i < sizeof result; i++)
        assert_int_equal(((unsigned char *)result)[i], 0xa5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pose_from_records_and_back_is_unchanged),
        cmocka_unit_test(blends_are_those_of_poses),
        cmocka_unit_test(layers_are_those_of_poses),
        cmocka_unit_test(additive_poses_are_those_of_poses),
        cmocka_unit_test(weights_above_one_and_below_zero),
        cmocka_unit_test(models_are_those_of_poses),
        cmocka_unit_test(clips_are_sampled_as_into_poses),
        cmocka_unit_test(what_does_not_fit_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
