/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "put.h"
#include "random_clip.h"
#include "support/clips.h"
#include "support/views.h"
#include "support/resample.h"

static random_clip drawn;

static void expect_tracks_bits(random_source *r, size_t joints, int variety)
{
    size_t bytes;
    random_clip_draw(r, joints, variety, &drawn);
    nkw_clip *clip = clip_build(&drawn.source, &bytes);
    uint32_t cursors[RANDOM_CLIP_TRACKS];
    memset(cursors, 0xff, sizeof cursors);
    assert_true(nkw_clip_describe(clip).cursor_count <= RANDOM_CLIP_TRACKS);
    for (int i = 0; i < 60; i++) {
        float time = random_clip_time(r, &drawn, i);
        float got[NKW_POSE_FLOATS(RANDOM_CLIP_JOINTS)], want[NKW_POSE_FLOATS(RANDOM_CLIP_JOINTS)];
        float floats[RANDOM_CLIP_FLOATS] = {0}, want_floats[RANDOM_CLIP_FLOATS] = {0};
        random_clip_sample(&drawn, time, want, want_floats);
        nkw_clip_sample(clip, time, i % 2 ? cursors : NULL, pose_span(got, nkw_clip_describe(clip).joint_count),
                        floats);
        expect_same_pose(got, want, joints);
        expect_floats_bits(floats, want_floats, drawn.source.float_count);
    }
    free(clip);
}

static void sampling_gives_the_bits_of_track_by_track(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (int variety = 0; variety < 5; variety++)
        for (size_t joints = 1; joints <= RANDOM_CLIP_JOINTS; joints += joints < 20 ? 1 : 5)
            for (int round = 0; round < (variety == 2 ? 6 : 1); round++)
                expect_tracks_bits(&r, joints, variety);
}

/* Lanes that end with the last joint may go on over the padding of the pose, never beyond it. */
static void tracks_of_the_last_joints_alone_stay_within_their_component(void **state)
{
    (void)state;
    random_source r = random_from(14);
    for (size_t joints = 1; joints <= RANDOM_CLIP_JOINTS; joints++) {
        for (size_t first = 0; first < joints; first++) {
            size_t bytes, kept = 0;
            float got[NKW_POSE_FLOATS(RANDOM_CLIP_JOINTS)], want[NKW_POSE_FLOATS(RANDOM_CLIP_JOINTS)], none[1];
            random_clip_draw(&r, joints, 0, &drawn);
            for (size_t i = 0; i < drawn.source.track_count; i++)
                if (drawn.tracks[i].index >= first)
                    drawn.tracks[kept++] = drawn.tracks[i];
            drawn.source.track_count = kept;
            nkw_clip *clip = clip_build(&drawn.source, &bytes);
            random_clip_sample(&drawn, 0.35f, want, none);
            nkw_clip_sample(clip, 0.35f, NULL, pose_span(got, nkw_clip_describe(clip).joint_count), NULL);
            expect_same_pose(got, want, joints);
            free(clip);
        }
    }
}

static void tracks_of_one_time_array_share_a_lookup(void **state)
{
    (void)state;
    random_source r = random_from(2);
    size_t bytes;
    for (int variety = 0; variety < 2; variety++) {
        random_clip_draw(&r, 20, variety, &drawn);
        nkw_clip *clip = clip_build(&drawn.source, &bytes);
        assert_int_equal(nkw_clip_describe(clip).cursor_count, 1);
        free(clip);
    }
    /* The same times in another place. */
    float copy[RANDOM_CLIP_KEYS];
    random_clip_draw(&r, 20, 1, &drawn);
    memcpy(copy, drawn.times[1], sizeof copy);
    drawn.tracks[3].track.times = copy;
    nkw_clip *clip = clip_build(&drawn.source, &bytes);
    assert_int_equal(nkw_clip_describe(clip).cursor_count, 1);
    free(clip);
}

static nkw_clip_error difference_from(const nkw_clip *clip, const nkw_clip_source *source)
{
    NKW_STACK_WORK(work, NKW_CLIP_DIFFERENCE_WORK(RANDOM_CLIP_JOINTS, RANDOM_CLIP_FLOATS));
    const nkw_clip_description d = nkw_clip_describe(clip);
    const size_t needed = NKW_CLIP_DIFFERENCE_WORK(d.joint_count, d.float_count);
    const nkw_work enough = {work.data, needed}, small = {work.data, needed - 1};
    const nkw_work misaligned = {(unsigned char *)work.data + 4, needed};
    nkw_clip_error error = {INFINITY, INFINITY, INFINITY, INFINITY}, none = error;
    nkw_result result = nkw_clip_difference(clip, source, &error, enough);
    assert_true(result == NKW_OK || (result == NKW_MISMATCHED && isinf(error.rotation)));
    const nkw_result refused = result == NKW_OK ? NKW_TOO_SMALL : result;
    assert_int_equal(nkw_clip_difference(clip, source, &none, small), refused);
    assert_int_equal(nkw_clip_difference(clip, source, &none, misaligned), refused);
    assert_true(isinf(none.translation) && isinf(none.rotation) && isinf(none.scale) && isinf(none.floats));
    return error;
}

static void a_pose_of_other_joints_is_not_written(void **state)
{
    (void)state;
    nkw_clip_source source = {NULL, 0, 17, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
    float pose[NKW_POSE_FLOATS(17)] = {7.0f};
    size_t bytes;
    nkw_clip *clip = clip_build(&source, &bytes);
    assert_int_equal(nkw_clip_sample(clip, 0.0f, NULL, pose_span(pose, 16), NULL), NKW_MISMATCHED);
    expect_bits(pose[0], 7.0f);
    assert_int_equal(nkw_clip_sample(clip, 0.0f, NULL, pose_span(pose, 17), NULL), NKW_OK);
    expect_bits(pose[0], 0.0f);
    free(clip);
}

static void the_difference_of_a_baked_clip_shows_between_its_own_keys(void **state)
{
    (void)state;
    const float at[2] = {0, 1}, ease[18] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0};
    float times[25], made[75];
    NKW_STACK_WORK(track_work, NKW_TRACK_WORK(3));
    nkw_clip_track track = {
        NKW_CLIP_TRANSLATION, 0, {at, ease, 2, 3, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE, NULL}};
    nkw_clip_track baked = track;
    float error = resample(&track.track, 24.0f, times, made, track_work, &baked.track);
    nkw_clip_source source = {&track, 1, 1, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL}, of_baked = source;
    size_t bytes;
    of_baked.tracks = &baked;
    nkw_clip *clip = clip_build(&of_baked, &bytes);
    assert_true(error > 0.001f);
    expect_bits(difference_from(clip, &source).translation, error);
    free(clip);
}

static void a_clip_and_tracks_that_are_none_of_its_own_differ_infinitely(void **state)
{
    (void)state;
    const float at[2] = {0, 1}, values[32] = {0};
    nkw_clip_track track = {
        NKW_CLIP_TRANSLATION, 0, {at, values, 2, 3, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL}};
    nkw_clip_source source = {&track, 1, 1, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
    size_t bytes;
    nkw_clip *clip = clip_build(&source, &bytes);
    expect_bits(difference_from(clip, &source).scale, 0.0f);
    track.track.width = 16;
    expect_bits(difference_from(clip, &source).scale, INFINITY);
    track.track.width = 3;
    track.index = 1;
    expect_bits(difference_from(clip, &source).rotation, INFINITY);
    track.index = 0;
    track.target = NKW_CLIP_FLOATS;
    expect_bits(difference_from(clip, &source).floats, INFINITY);
    track.track.width = 0;
    expect_bits(difference_from(clip, &source).floats, INFINITY);
    track.track.width = 3;
    track.target = NKW_CLIP_TRANSLATION;
    track.track.count = 0;
    expect_bits(difference_from(clip, &source).translation, INFINITY);
    free(clip);
}

static void a_clip_without_tracks_is_the_rest_pose(void **state)
{
    (void)state;
    nkw_clip_source source = {NULL, 0, 17, 2, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
    size_t bytes;
    float pose[NKW_POSE_FLOATS(17)], identity[NKW_POSE_FLOATS(17)], floats[2] = {7, 7};
    nkw_clip *clip = clip_build(&source, &bytes);
    nkw_pose_identity(pose_span(identity, 17));
    nkw_clip_sample(clip, 0.3f, NULL, pose_span(pose, nkw_clip_describe(clip).joint_count), floats);
    expect_same_pose(pose, identity, 17);
    expect_bits(floats[0], 0.0f);
    expect_bits(floats[1], 0.0f);
    assert_int_equal(nkw_clip_describe(clip).joint_count, 17);
    assert_int_equal(nkw_clip_describe(clip).float_count, 2);
    expect_bits(nkw_clip_describe(clip).start, 0.0f);
    expect_bits(nkw_clip_describe(clip).end, 0.0f);
    free(clip);
}

static void pose_or_floats_may_be_left_out(void **state)
{
    (void)state;
    random_source r = random_from(4);
    size_t bytes;
    random_clip_draw(&r, 9, 2, &drawn);
    nkw_clip *clip = clip_build(&drawn.source, &bytes);
    float pose[NKW_POSE_FLOATS(9)], floats[RANDOM_CLIP_FLOATS], both[NKW_POSE_FLOATS(9)], with[RANDOM_CLIP_FLOATS];
    nkw_clip_sample(clip, 0.4f, NULL, pose_span(both, nkw_clip_describe(clip).joint_count), with);
    nkw_clip_sample(clip, 0.4f, NULL, pose_span(pose, nkw_clip_describe(clip).joint_count), NULL);
    nkw_clip_sample(clip, 0.4f, NULL, pose_span(NULL, 0), floats);
    nkw_clip_sample(clip, 0.4f, NULL, pose_span(NULL, 0), NULL);
    expect_same_pose(pose, both, 9);
    expect_floats_bits(floats, with, RANDOM_CLIP_FLOATS);
    free(clip);
}

static nkw_clip_error difference(const nkw_clip *clip)
{
    return difference_from(clip, &drawn.source);
}

static void a_clip_of_floats_does_not_differ_from_its_tracks(void **state)
{
    (void)state;
    random_source r = random_from(11);
    size_t bytes;
    random_clip_draw(&r, 19, 2, &drawn);
    nkw_clip *clip = clip_build(&drawn.source, &bytes);
    nkw_clip_error error = difference(clip);
    expect_bits(error.translation, 0.0f);
    expect_bits(error.scale, 0.0f);
    expect_bits(error.floats, 0.0f);
    assert_true(error.rotation < 1e-7f);
    for (size_t i = 0; i < nkw_track_value_count(&drawn.tracks[0].track); i += 3)
        drawn.values[0][i] += 1.0f;
    error = difference(clip);
    assert_true(error.rotation > 0.1f || error.floats > 0.1f || error.scale > 0.1f || error.translation > 0.1f);
    free(clip);
}

/* At a key; between keys that are half a turn apart; radians. */
#define COMPACT_AT_KEY  1.24e-4f
#define COMPACT_BETWEEN 1.75e-4f

/* Numbers are drawn from -3..3, so half a step is 4.6e-5. The bound of rotations is for unit keys. */
static void a_compact_clip_is_within_its_bound(void **state)
{
    (void)state;
    random_source r = random_from(12);
    for (int variety = 0; variety < 3; variety++) {
        size_t bytes, compact_bytes;
        random_clip_draw(&r, 37, variety, &drawn);
        for (size_t i = 0; i < drawn.source.track_count; i++)
            if (drawn.tracks[i].target == NKW_CLIP_ROTATION)
                drawn.tracks[i].track.kind = NKW_TRACK_ROTATION_NORMALIZED;
        nkw_clip *clip = clip_build(&drawn.source, &bytes);
        drawn.source.format = NKW_CLIP_UNORM16;
        nkw_clip *compact = clip_build(&drawn.source, &compact_bytes);
        nkw_clip_error error = difference(compact);
        assert_true(compact_bytes < bytes);
        assert_true(error.translation > 0.0f && error.translation < 4.8e-5f);
        assert_true(error.scale > 0.0f && error.scale < 4.8e-5f);
        assert_true(error.floats < 4.8e-5f);
        assert_true(error.rotation > 0.0f && error.rotation < COMPACT_BETWEEN);
        free(clip);
        free(compact);
    }
}

/* The turns of joint j: by pi about an axis and on again, where a dot product of 0 says which way round. */
static void draw_half_turns(random_source *r, size_t j, float *values)
{
    nkw_quat q = j % 2 ? random_rotation(r) : nkw_quat_identity();
    for (size_t k = 0; k < RANDOM_CLIP_KEYS; k++) {
        memcpy(values + 4 * k, &q, sizeof q);
        nkw_quat half = {0, 0, 0, random_between(r, -1e-6f, 1e-6f)};
        *(k % 3 == 0 ? &half.x : k % 3 == 1 ? &half.y : &half.z) = random_bits(r) % 2 ? 1.0f : -1.0f;
        half.w = j % 4 < 2 ? 0.0f : half.w;
        q = nkw_quat_scale(nkw_quat_mul(q, half), random_bits(r) % 2 ? 1.0f : -1.0f);
    }
}

static void compact_rotations_half_a_turn_apart_go_the_same_way(void **state)
{
    (void)state;
    random_source r = random_from(17);
    for (int round = 0; round < 20; round++) {
        size_t bytes;
        random_clip_draw(&r, 33, 0, &drawn);
        drawn.source.format = NKW_CLIP_UNORM16;
        for (size_t i = 0; i < drawn.source.track_count; i++)
            if (drawn.tracks[i].target == NKW_CLIP_ROTATION)
                draw_half_turns(&r, drawn.tracks[i].index, drawn.values[i]);
        nkw_clip *clip = clip_build(&drawn.source, &bytes);
        assert_true(difference(clip).rotation < COMPACT_BETWEEN);
        free(clip);
    }
}

/* Rotations that are turned over, on the border of it, and all that stand on one axis or between some. */
static nkw_quat special_rotation(random_source *r)
{
    const float parts[4] = {0.0f, 1.0f, -1.0f, random_between(r, -1e-4f, 1e-4f)};
    nkw_quat q = {parts[random_bits(r) % 4], parts[random_bits(r) % 4], parts[random_bits(r) % 4],
                  parts[random_bits(r) % 4]};
    return nkw_quat_normalize(q);
}

static void compact_rotations_of_equal_components_are_within_their_bound(void **state)
{
    (void)state;
    random_source r = random_from(18);
    for (int round = 0; round < 30; round++) {
        size_t bytes;
        random_clip_draw(&r, 33, 0, &drawn);
        drawn.source.format = NKW_CLIP_UNORM16;
        for (size_t i = 0; i < drawn.source.track_count; i++)
            for (size_t k = 0; k < RANDOM_CLIP_KEYS && drawn.tracks[i].target == NKW_CLIP_ROTATION; k++) {
                nkw_quat q = special_rotation(&r);
                memcpy(drawn.values[i] + 4 * k, &q, sizeof q);
            }
        nkw_clip *clip = clip_build(&drawn.source, &bytes);
        assert_true(difference(clip).rotation < COMPACT_BETWEEN);
        for (size_t i = 0; i < drawn.source.track_count; i++)
            drawn.tracks[i].track.interpolation = NKW_INTERPOLATION_STEP;
        nkw_clip *held = clip_build(&drawn.source, &bytes);
        assert_true(difference(held).rotation < COMPACT_AT_KEY);
        free(clip);
        free(held);
    }
}

/* Every joint turns by the angles k step + first about an axis of its own, its keys of random signs. */
static void draw_turns(random_source *r, float first, float step)
{
    random_clip_draw(r, 33, 0, &drawn);
    drawn.source.format = NKW_CLIP_UNORM16;
    for (size_t i = 0; i < drawn.source.track_count; i++) {
        nkw_vec3 axis = nkw_quat_rotate(random_rotation(r), (nkw_vec3){0.0f, 0.0f, 1.0f});
        for (size_t k = 0; k < RANDOM_CLIP_KEYS && drawn.tracks[i].target == NKW_CLIP_ROTATION; k++) {
            nkw_quat q = nkw_quat_from_axis_angle(axis, first + step * (float)k);
            q = nkw_quat_scale(q, random_bits(r) % 2 ? 1.0f : -1.0f);
            memcpy(drawn.values[i] + 4 * k, &q, sizeof q);
        }
    }
}

static void compact_rotations_go_round_and_round(void **state)
{
    (void)state;
    random_source r = random_from(19);
    for (float step = -3.1f; step < 3.1f; step += 0.31f) {
        size_t bytes;
        draw_turns(&r, random_between(&r, -3.0f, 3.0f), step);
        nkw_clip *clip = clip_build(&drawn.source, &bytes);
        assert_true(difference(clip).rotation < COMPACT_BETWEEN);
        free(clip);
    }
}

static void a_source_of_other_joints_is_infinitely_far(void **state)
{
    (void)state;
    random_source r = random_from(21);
    size_t bytes;
    random_clip_draw(&r, 9, 3, &drawn);
    nkw_clip *clip = clip_build(&drawn.source, &bytes);
    assert_true(difference(clip).rotation < 1e-6f);
    drawn.source.joint_count = 8;
    nkw_clip_error error = difference(clip);
    assert_true(isinf(error.translation) && isinf(error.rotation) && isinf(error.scale) && isinf(error.floats));
    free(clip);
}

/* 0.3 radians in all, from anywhere on, about half a turn too: 0.3/65535 and what rounding adds. */
static void compact_rotations_of_a_narrow_range_are_more_exact(void **state)
{
    (void)state;
    random_source r = random_from(20);
    for (float first = -3.3f; first < 3.3f; first += 0.3f) {
        size_t bytes;
        draw_turns(&r, first, 0.3f / RANDOM_CLIP_KEYS);
        nkw_clip *clip = clip_build(&drawn.source, &bytes);
        assert_true(difference(clip).rotation < 6e-6f);
        free(clip);
    }
}

static void compact_rotations_are_unit(void **state)
{
    (void)state;
    random_source r = random_from(13);
    size_t bytes;
    random_clip_draw(&r, 20, 0, &drawn);
    drawn.source.format = NKW_CLIP_UNORM16;
    nkw_clip *clip = clip_build(&drawn.source, &bytes);
    for (int i = 0; i < 200; i++) {
        float pose[NKW_POSE_FLOATS(20)];
        nkw_clip_sample(clip, i % 5 ? random_unit(&r) : drawn.times[0][i % RANDOM_CLIP_KEYS], NULL,
                        pose_span(pose, nkw_clip_describe(clip).joint_count), NULL);
        for (size_t j = 0; j < 20; j++)
            expect_near(nkw_quat_length(nkw_pose_get(pose_view(pose, 20), j).rotation), 1.0, 7e-7);
    }
    free(clip);
}

/* The worst that a search found: off by 5.7e-7. */
static void compact_rotations_are_unit_between_far_keys_too(void **state)
{
    (void)state;
    nkw_quat keys[2] = {{0x1.272354p-2f, -0x1.0d576ep-4f, 0x1.e289acp-1f, 0x1.9dd64cp-4f},
                        {0x1.c2f85cp-2f, 0x1.c97c54p-3f, 0x1.4652dep-1f, -0x1.2b760ap-1f}};
    const float times[2] = {0.0f, 1.0f};
    float values[8], pose[NKW_POSE_FLOATS(1)];
    size_t bytes;
    for (size_t k = 0; k < 2; k++)
        put_quat(values + 4 * k, nkw_quat_normalize(keys[k]));
    const nkw_track track = {times, values, 2, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR, NULL};
    const nkw_clip_track rotation = {NKW_CLIP_ROTATION, 0, track};
    nkw_clip_source source = {&rotation, 1, 1, 0, {NULL, 0}, NULL, NKW_CLIP_UNORM16, NULL};
    nkw_clip *clip = clip_build(&source, &bytes);
    nkw_clip_sample(clip, 0x1.ffffb6p-2f, NULL, pose_span(pose, nkw_clip_describe(clip).joint_count), NULL);
    expect_near(nkw_quat_length(nkw_pose_get(pose_view(pose, 1), 0).rotation), 1.0, 7e-7);
    free(clip);
}

static void build_refuses_a_block_that_is_too_small(void **state)
{
    (void)state;
    random_source r = random_from(8);
    NKW_STACK_WORK(work, NKW_CLIP_BUILD_WORK(RANDOM_CLIP_TRACKS));
    size_t bytes, again = 0, bad = 9;
    random_clip_draw(&r, 5, 2, &drawn);
    assert_int_equal(nkw_clip_build(&drawn.source, bytes_span(NULL, 0), &bytes, &bad, work), NKW_TOO_SMALL);
    assert_true(bytes > 0 && bad == 0);
    unsigned char *block = (unsigned char *)calloc(1, bytes);
    assert_int_equal(nkw_clip_build(&drawn.source, bytes_span(block, bytes - 1), &again, NULL, work), NKW_TOO_SMALL);
    assert_int_equal(again, bytes);
    assert_int_equal(block[0], 0);
    const nkw_work misaligned = {(unsigned char *)work.data + 4, work.bytes - 4}, none = {NULL, work.bytes};
    assert_int_equal(nkw_clip_build(&drawn.source, bytes_span(block, bytes), &again, NULL, misaligned), NKW_TOO_SMALL);
    assert_int_equal(again, 0);
    assert_int_equal(nkw_clip_build(&drawn.source, bytes_span(block, bytes), &again, NULL, none), NKW_TOO_SMALL);
    assert_int_equal(nkw_clip_build(&drawn.source, bytes_span(block, bytes), &again, NULL, work), NKW_OK);
    assert_int_equal(again, bytes);
    free(block);
}

static void open_refuses_other_files(void **state)
{
    (void)state;
    random_source r = random_from(9);
    size_t bytes;
    const nkw_clip *clip;
    random_clip_draw(&r, 5, 2, &drawn);
    nkw_clip *block = clip_build(&drawn.source, &bytes);
    uint32_t *words = (uint32_t *)(void *)block;
    assert_int_equal(nkw_clip_open(block, 3, &clip), NKW_TOO_SMALL);
    assert_int_equal(nkw_clip_open(block, bytes - 1, &clip), NKW_TOO_SMALL);
    assert_null(clip);
    words[0] = 0x636c6970u; /* the other byte order */
    assert_int_equal(nkw_clip_open(block, bytes, &clip), NKW_NOT_A_CLIP);
    words[0] = 0x70696c63u;
    words[1] = 99;
    assert_int_equal(nkw_clip_open(block, bytes, &clip), NKW_NOT_A_CLIP);
    free(block);
}

static void expect_word_refused(nkw_clip *block, size_t bytes, size_t word, uint32_t value, nkw_result result)
{
    const nkw_clip *clip;
    uint32_t *words = (uint32_t *)(void *)block, kept = words[word];
    words[word] = value;
    assert_int_equal(nkw_clip_open(block, bytes, &clip), result);
    assert_null(clip);
    words[word] = kept;
}

/* Words 7 and 8: where timelines are, and how many; 4 words each, of which the second counts the key times. */
static void open_refuses_parts_that_share_words(void **state)
{
    (void)state;
    enum { LINES = 4000 };
    const nkw_clip *clip;
    random_source r = random_from(16);
    size_t bytes;
    random_clip_draw(&r, 5, 2, &drawn);
    nkw_clip *block = clip_build(&drawn.source, &bytes);
    uint32_t end = (uint32_t)(bytes / 4), *words = (uint32_t *)calloc(end + 4 * LINES, sizeof *words);
    assert_non_null(words);
    memcpy(words, block, bytes);
    for (uint32_t i = 0; i < LINES; i++)
        memcpy(words + end + 4 * i, words + words[7] + 4 * (i < words[8] ? i : 0), 16);
    words[2] = end + 4 * LINES;
    words[7] = end;
    assert_int_equal(nkw_clip_open(words, 4 * (size_t)words[2], &clip), NKW_OK);
    words[8] = LINES;
    assert_int_equal(nkw_clip_open(words, 4 * (size_t)words[2], &clip), NKW_OUT_OF_RANGE);
    assert_null(clip);
    free(words);
    free(block);
}

/* Words 3..6: joints, floats, start, end. */
static void open_refuses_a_head_that_is_not_sound(void **state)
{
    (void)state;
    random_source r = random_from(15);
    size_t bytes;
    const nkw_clip *clip;
    random_clip_draw(&r, 5, 2, &drawn);
    nkw_clip *block = clip_build(&drawn.source, &bytes);
    expect_word_refused(block, bytes, 2, 3, NKW_TOO_SMALL);
    expect_word_refused(block, bytes, 3, UINT32_MAX, NKW_OUT_OF_RANGE);
    expect_word_refused(block, bytes, 3, (1u << 26) + 1, NKW_OUT_OF_RANGE);
    expect_word_refused(block, bytes, 4, (1u << 29) + 1, NKW_OUT_OF_RANGE);
    expect_word_refused(block, bytes, 3, 1u << 20, NKW_OUT_OF_RANGE);
    expect_word_refused(block, bytes, 4, 1u << 20, NKW_OUT_OF_RANGE);
    expect_word_refused(block, bytes, 4, 64, NKW_OUT_OF_RANGE);
    expect_word_refused(block, bytes, 5, bits_of(NAN), NKW_NOT_FINITE);
    expect_word_refused(block, bytes, 6, bits_of(INFINITY), NKW_NOT_FINITE);
    expect_word_refused(block, bytes, 6, bits_of(-1e9f), NKW_NOT_ASCENDING);
    assert_int_equal(nkw_clip_open((const char *)block + 1, bytes - 1, &clip), NKW_NOT_A_CLIP);
    assert_null(clip);
    assert_int_equal(nkw_clip_open(block, bytes, &clip), NKW_OK);
    free(block);
}

static void a_block_may_be_copied_and_larger_than_the_clip(void **state)
{
    (void)state;
    random_source r = random_from(16);
    size_t bytes;
    const nkw_clip *clip;
    random_clip_draw(&r, 17, 2, &drawn);
    nkw_clip *block = clip_build(&drawn.source, &bytes);
    /* At every alignment of a float. */
    for (size_t shift = 0; shift < 64; shift += 4) {
        char *copy = (char *)malloc(bytes + 64 + 100);
        float got[NKW_POSE_FLOATS(17)], want[NKW_POSE_FLOATS(17)];
        assert_non_null(copy);
        memcpy(copy + shift, block, bytes);
        assert_int_equal(nkw_clip_open(copy + shift, bytes + 100, &clip), NKW_OK);
        assert_int_equal(nkw_clip_describe(clip).bytes, bytes);
        nkw_clip_sample(clip, 0.3f, NULL, pose_span(got, nkw_clip_describe(clip).joint_count), NULL);
        nkw_clip_sample(block, 0.3f, NULL, pose_span(want, nkw_clip_describe(block).joint_count), NULL);
        expect_same_pose(got, want, 17);
        free(copy);
    }
    free(block);
}

/* One word changed: either it is refused, or sampling stays within its arrays (the sanitizers watch). */
static void a_damaged_block_is_refused_or_safe(void **state)
{
    random_source r = random_from(10);
    size_t bytes, refused = 0;
    random_clip_draw(&r, 12, 2, &drawn);
    drawn.source.format = *state ? NKW_CLIP_UNORM16 : NKW_CLIP_FLOAT32;
    nkw_clip *block = clip_build(&drawn.source, &bytes);
    uint32_t *damaged = (uint32_t *)malloc(bytes);
    assert_non_null(damaged);
    for (size_t i = 0; i < bytes / 4 && i < 900; i++) {
        const uint32_t others[4] = {0xffffffffu, 0x7fc00000u, (uint32_t)random_bits(&r), (uint32_t)(bytes / 4)};
        for (int o = 0; o < 5; o++) {
            const nkw_clip *clip;
            memcpy(damaged, block, bytes);
            damaged[i] = o < 4 ? others[o] : damaged[i] + 1;
            if (nkw_clip_open(damaged, bytes, &clip) != NKW_OK && ++refused)
                continue;
            const nkw_clip_description d = nkw_clip_describe(clip);
            assert_true(d.joint_count + d.float_count <= bytes);
            float *pose = (float *)malloc(sizeof(float) * (1 + nkw_pose_floats(d.joint_count)));
            float *floats = (float *)malloc(sizeof(float) * (1 + d.float_count));
            nkw_clip_sample(clip, 0.3f, NULL, pose_span(pose, d.joint_count), floats);
            free(pose);
            free(floats);
        }
    }
    assert_true(refused > 300);
    free(damaged);
    free(block);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sampling_gives_the_bits_of_track_by_track),
        cmocka_unit_test(tracks_of_the_last_joints_alone_stay_within_their_component),
        cmocka_unit_test(tracks_of_one_time_array_share_a_lookup),
        cmocka_unit_test(a_pose_of_other_joints_is_not_written),
        cmocka_unit_test(the_difference_of_a_baked_clip_shows_between_its_own_keys),
        cmocka_unit_test(a_clip_and_tracks_that_are_none_of_its_own_differ_infinitely),
        cmocka_unit_test(a_clip_without_tracks_is_the_rest_pose),
        cmocka_unit_test(pose_or_floats_may_be_left_out),
        cmocka_unit_test(a_clip_of_floats_does_not_differ_from_its_tracks),
        cmocka_unit_test(a_compact_clip_is_within_its_bound),
        cmocka_unit_test(compact_rotations_half_a_turn_apart_go_the_same_way),
        cmocka_unit_test(compact_rotations_of_equal_components_are_within_their_bound),
        cmocka_unit_test(a_source_of_other_joints_is_infinitely_far),
        cmocka_unit_test(compact_rotations_go_round_and_round),
        cmocka_unit_test(compact_rotations_of_a_narrow_range_are_more_exact),
        cmocka_unit_test(compact_rotations_are_unit),
        cmocka_unit_test(compact_rotations_are_unit_between_far_keys_too),
        cmocka_unit_test(build_refuses_a_block_that_is_too_small),
        cmocka_unit_test(open_refuses_other_files),
        cmocka_unit_test(open_refuses_a_head_that_is_not_sound),
        cmocka_unit_test(open_refuses_parts_that_share_words),
        cmocka_unit_test(a_block_may_be_copied_and_larger_than_the_clip),
        cmocka_unit_test(a_damaged_block_is_refused_or_safe),
        cmocka_unit_test_prestate(a_damaged_block_is_refused_or_safe, (void *)"compact"),
    };
    return cmocka_run_group_tests_name("clip", tests, NULL, NULL);
}
