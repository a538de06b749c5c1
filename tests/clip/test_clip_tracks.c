/* SPDX-License-Identifier: MIT */
/* What becomes of a clip's tracks: constants, gaps between joints, their order, and those that are refused. */
#include <fenv.h>
#include <math.h>
#include <stdlib.h>

#include "random_clip.h"
#include "support/clips.h"
#include "support/views.h"

static random_clip drawn;

static void constant_tracks_are_stored_once(void **state)
{
    (void)state;
    random_source r = random_from(3);
    size_t bytes, pose_bytes = sizeof(float) * NKW_POSE_FLOATS(20);
    random_clip_draw(&r, 20, 0, &drawn);
    for (size_t i = 0; i < drawn.source.track_count; i++)
        for (size_t k = 1; k < RANDOM_CLIP_KEYS; k++)
            for (size_t c = 0; c < drawn.tracks[i].track.width; c++)
                drawn.values[i][k * drawn.tracks[i].track.width + c] = drawn.values[i][c] = nkw_abs(drawn.values[i][c]);
    nkw_clip *clip = clip_build(&drawn.source, &bytes);
    assert_int_equal(nkw_clip_describe(clip).cursor_count, 0);
    assert_true(bytes < pose_bytes + 512);
    expect_bits(nkw_clip_describe(clip).start, 0.0f);
    expect_bits(nkw_clip_describe(clip).end, drawn.times[0][RANDOM_CLIP_KEYS - 1]);
    free(clip);
}

/* Of rotations those that are as if normalised; what normalising changes is no constant, unless keys are so too. */
static void cubic_rotations_that_stay_are_constants(void **state)
{
    (void)state;
    const float at[3] = {0, 1, 2};
    const nkw_quat keys[4] = {{0, 0, 0, 1}, {0.6f, 0, 0, 0.8f}, {0, 0, 0.70710678f, 0.70710678f}, {-0.0f, 0, 0, 1}};
    random_source r = random_from(34);
    size_t bytes, found = 0;
    for (int i = 0; i < 400; i++) {
        nkw_quat q = i < 4 ? keys[i] : random_rotation(&r);
        if (i % 4 == 3 && i > 4)
            q.x += 1e-3f;
        float values[36] = {0}, pose[NKW_POSE_FLOATS(1)], want[4];
        for (int k = 0; k < 3; k++)
            memcpy(values + 12 * k + 4, &q, sizeof q);
        nkw_track_kind kind = i % 2 ? NKW_TRACK_ROTATION_NORMALIZED : NKW_TRACK_ROTATION;
        nkw_clip_track t = {NKW_CLIP_ROTATION, 0, {at, values, 3, 4, kind, NKW_INTERPOLATION_CUBICSPLINE, NULL}};
        nkw_clip_source source = {&t, 1, 1, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
        nkw_clip *clip = clip_build(&source, &bytes);
        found += nkw_clip_describe(clip).cursor_count == 0;
        for (float time = 0; time <= 2; time += 0.25f) {
            nkw_clip_sample(clip, time, NULL, pose_span(pose, nkw_clip_describe(clip).joint_count), NULL);
            nkw_track_sample(&t.track, time, NULL, want);
            nkw_quat got = nkw_pose_get(pose_view(pose, 1), 0).rotation;
            assert_memory_equal(&got, want, sizeof got);
        }
        free(clip);
    }
    assert_in_range(found, 200, 398);
}

/* The duration overflows, and its product with a tangent of 0 is NaN. */
static void cubics_over_an_endless_duration_are_no_constants(void **state)
{
    (void)state;
    const float at[2] = {-3e38f, 3e38f}, values[24] = {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    nkw_clip_track t = {
        NKW_CLIP_ROTATION, 0, {at, values, 2, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_CUBICSPLINE, NULL}};
    nkw_clip_source source = {&t, 1, 1, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
    float pose[NKW_POSE_FLOATS(1)], want[4];
    size_t bytes;
    nkw_clip *clip = clip_build(&source, &bytes);
    nkw_clip_sample(clip, 0.0f, NULL, pose_span(pose, nkw_clip_describe(clip).joint_count), NULL);
    nkw_track_sample(&t.track, 0.0f, NULL, want);
    expect_nan(want[3]);
    expect_nan(nkw_pose_get(pose_view(pose, 1), 0).rotation.w);
    free(clip);
}

/* Every eighth joint has no track, and rests at numbers that lanes may not go over in some of them. */
static void short_gaps_between_joints_are_gone_over(void **state)
{
    (void)state;
    enum { JOINTS = 40 };
    static const float odd[5] = {0.5f, -0.0f, INFINITY, NAN, 3e38f};
    random_source r = random_from(33);
    size_t all, bytes, sparse, left = 0;
    random_clip_draw(&r, JOINTS, 0, &drawn);
    free(clip_build(&drawn.source, &all));
    for (size_t i = 0; i < drawn.source.track_count; i++)
        if (drawn.tracks[i].index % 8 != 4)
            drawn.tracks[left++] = drawn.tracks[i];
    drawn.source.track_count = left;
    nkw_clip *clip = clip_build(&drawn.source, &bytes);
    assert_in_range(bytes, all - 256, all);
    free(clip);
    for (size_t c = 0; c < 10; c++)
        for (size_t j = 4; j < JOINTS; j += 8)
            drawn.rest[c * NKW_POSE_STRIDE(JOINTS) + j] = odd[(c + j / 8) % 5];
    clip = clip_build(&drawn.source, &bytes);
    for (int i = 0; i < 20; i++) {
        float got[NKW_POSE_FLOATS(JOINTS)], want[NKW_POSE_FLOATS(JOINTS)], time = random_clip_time(&r, &drawn, i);
        float none[1];
        random_clip_sample(&drawn, time, want, none);
        nkw_clip_sample(clip, time, NULL, pose_span(got, nkw_clip_describe(clip).joint_count), NULL);
        for (size_t c = 0; c < 10; c++)
            for (size_t j = 0; j < JOINTS; j++) {
                size_t at = c * NKW_POSE_STRIDE(JOINTS) + j;
                if (want[at] == want[at])
                    expect_bits(got[at], want[at]);
                else
                    expect_nan(got[at]);
            }
    }
    free(clip);
    drawn.source.format = NKW_CLIP_UNORM16;
    clip = clip_build(&drawn.source, &bytes);
    for (int i = 4; i < 20; i++) {
        float got[NKW_POSE_FLOATS(JOINTS)];
        nkw_clip_sample(clip, random_clip_time(&r, &drawn, i), NULL,
                        pose_span(got, nkw_clip_describe(clip).joint_count), NULL);
        for (size_t c = 0; c < 10; c++)
            for (size_t j = 4; j < JOINTS; j += 8)
                if (odd[(c + j / 8) % 5] == odd[(c + j / 8) % 5])
                    expect_bits(got[c * NKW_POSE_STRIDE(JOINTS) + j], odd[(c + j / 8) % 5]);
    }
    free(clip);
    drawn.source.format = NKW_CLIP_FLOAT32;
    /* Where few joints move, nothing grows. */
    for (size_t i = left = 0; i < drawn.source.track_count; i++)
        if (drawn.tracks[i].index % 5 == 0)
            drawn.tracks[left++] = drawn.tracks[i];
    drawn.source.track_count = left;
    free(clip_build(&drawn.source, &sparse));
    assert_true(sparse < all / 3);
}

static void the_order_of_tracks_does_not_matter(void **state)
{
    (void)state;
    random_source r = random_from(5);
    size_t bytes, again;
    for (int variety = 0; variety < 3; variety++) {
        random_clip_draw(&r, 23, variety, &drawn);
        nkw_clip *clip = clip_build(&drawn.source, &bytes);
        for (size_t i = 0; i < drawn.source.track_count / 2; i++) {
            nkw_clip_track swap = drawn.tracks[i];
            drawn.tracks[i] = drawn.tracks[drawn.source.track_count - 1 - i];
            drawn.tracks[drawn.source.track_count - 1 - i] = swap;
        }
        nkw_clip *permuted = clip_build(&drawn.source, &again);
        assert_int_equal(again, bytes);
        assert_memory_equal(clip, permuted, bytes);
        free(clip);
        free(permuted);
    }
}

/*
 * Key times that differ in one key of 64 only, each of them of several tracks and in copies: as many timelines as there
 * are different times.
 */
static void equal_times_share_a_timeline_and_times_that_differ_in_one_key_do_not(void **state)
{
    (void)state;
    enum { COUNT = 60, COPY_KEYS = 64, KINDS = 7 };
    static float times[COUNT][COPY_KEYS], values[COUNT][3 * COPY_KEYS], got[NKW_POSE_FLOATS(COUNT)];
    static nkw_clip_track tracks[COUNT];
    nkw_clip_source source = {tracks, COUNT, COUNT, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
    for (uint32_t i = 0; i < COUNT; i++) {
        for (size_t k = 0; k < COPY_KEYS; k++) {
            times[i][k] = (float)k + (k == 3 * (i % KINDS) + 2 ? 0.5f : 0.0f);
            for (size_t c = 0; c < 3; c++)
                values[i][3 * k + c] = times[i][k] + (float)i;
        }
        const nkw_track t = {times[i], values[i], COPY_KEYS, 3, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL};
        tracks[i] = (nkw_clip_track){NKW_CLIP_TRANSLATION, i, t};
    }
    size_t bytes;
    nkw_clip *clip = clip_build(&source, &bytes);
    assert_int_equal(nkw_clip_describe(clip).cursor_count, KINDS);
    for (float time = 0.25f; time < 63.0f; time += 0.5f) {
        nkw_clip_sample(clip, time, NULL, pose_span(got, COUNT), NULL);
        for (uint32_t i = 0; i < COUNT; i++) {
            float want[3];
            nkw_track_sample(&tracks[i].track, time, NULL, want);
            expect_bits(got[i], want[0]);
        }
    }
    free(clip);
}

static void expect_refused(nkw_result result, size_t track, int line)
{
    static uint64_t block[1 << 15];
    NKW_STACK_WORK(work, NKW_CLIP_BUILD_WORK(RANDOM_CLIP_TRACKS));
    size_t bytes = 9, bad = 99;
    nkw_result got = nkw_clip_build(&drawn.source, bytes_span(NULL, 0), &bytes, &bad, work);
    if (got != result || bad != track || bytes) {
        print_error("got %s at %zu, want %s at %zu\n", nkw_result_text(got), bad, nkw_result_text(result), track);
        _fail(__FILE__, line);
    }
    assert_int_equal(nkw_clip_build(&drawn.source, bytes_span(block, sizeof block), &bytes, NULL, work), result);
}

static void build_refuses_what_is_no_clip(void **state)
{
    (void)state;
    random_source r = random_from(6);
    random_clip_draw(&r, 5, 0, &drawn);
    nkw_clip_track *t = &drawn.tracks[7], kept = *t;
    t->index = 5;
    expect_refused(NKW_OUT_OF_RANGE, 7, __LINE__);
    *t = kept;
    t->target = (nkw_clip_target)4;
    expect_refused(NKW_BAD_METHOD, 7, __LINE__);
    *t = kept;
    t->track.kind = t->track.kind == NKW_TRACK_FLOATS ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
    expect_refused(t->track.kind == NKW_TRACK_FLOATS ? NKW_MISMATCHED : NKW_BAD_WIDTH, 7, __LINE__);
    *t = kept;
    t->target = NKW_CLIP_FLOATS;
    expect_refused(NKW_OUT_OF_RANGE, 7, __LINE__);
    *t = kept;
    t->track.width = 2;
    expect_refused(NKW_BAD_WIDTH, 7, __LINE__);
    *t = kept;
    t->track.count = 0;
    expect_refused(NKW_EMPTY, 7, __LINE__);
    *t = kept;
    t->index = drawn.tracks[10].index;
    t->target = drawn.tracks[10].target;
    t->track = drawn.tracks[10].track;
    expect_refused(NKW_REPEATED, 10, __LINE__);
    *t = kept;
    drawn.source.format = (nkw_clip_format)2;
    expect_refused(NKW_BAD_FORMAT, 0, __LINE__);
    drawn.source.format = NKW_CLIP_FLOAT32;
    drawn.source.rest.joint_count++;
    expect_refused(NKW_MISMATCHED, 0, __LINE__);
    drawn.source.rest.joint_count--;
    NKW_STACK_WORK(work, NKW_CLIP_BUILD_WORK(RANDOM_CLIP_TRACKS));
    const nkw_work small = {work.data, NKW_CLIP_BUILD_WORK(drawn.source.track_count) - 1};
    size_t bytes;
    assert_int_equal(nkw_clip_build(&drawn.source, bytes_span(NULL, 0), &bytes, NULL, small), NKW_TOO_SMALL);
    assert_int_equal(bytes, 0);
    drawn.source.track_count = 0;
    drawn.source.joint_count = (1u << 26) + 1;
    expect_refused(NKW_OUT_OF_RANGE, 0, __LINE__);
    drawn.source.joint_count = 5;
    drawn.source.float_count = (1u << 29) + 1;
    expect_refused(NKW_OUT_OF_RANGE, 0, __LINE__);
    drawn.source.joint_count = drawn.source.float_count = 0;
    expect_refused(NKW_EMPTY, 0, __LINE__);
}

/* Tracks 5 6 2 2 9 6 of joints, and of floats one that reaches over two others. */
static void the_first_that_repeats_is_named(void **state)
{
    (void)state;
    random_source r = random_from(8);
    random_clip_draw(&r, 12, 0, &drawn);
    const uint32_t joints[6] = {5, 6, 2, 2, 9, 6}, others[6] = {5, 6, 2, 6, 9, 2}, floats[3] = {0, 7, 2};
    drawn.source.track_count = 6;
    for (size_t i = 0; i < 6; i++) {
        drawn.tracks[i].target = NKW_CLIP_ROTATION;
        drawn.tracks[i].track = drawn.tracks[0].track;
        drawn.tracks[i].index = joints[i];
    }
    expect_refused(NKW_REPEATED, 3, __LINE__);
    for (size_t i = 0; i < 6; i++)
        drawn.tracks[i].index = others[i];
    expect_refused(NKW_REPEATED, 3, __LINE__);
    drawn.source.track_count = 3;
    drawn.source.float_count = 20;
    for (size_t i = 0; i < 3; i++) {
        drawn.tracks[i].target = NKW_CLIP_FLOATS;
        drawn.tracks[i].track.kind = NKW_TRACK_FLOATS;
        drawn.tracks[i].track.width = i == 0 ? 10 : 1;
        drawn.tracks[i].index = floats[i];
    }
    expect_refused(NKW_REPEATED, 1, __LINE__);
}

static void floats_that_overlap_are_refused(void **state)
{
    (void)state;
    random_source r = random_from(7);
    random_clip_draw(&r, 3, 2, &drawn);
    size_t last = drawn.source.track_count - 2;
    assert_int_equal(drawn.tracks[last].track.width, 4);
    drawn.tracks[last].index = 4;
    expect_refused(NKW_REPEATED, last, __LINE__);
}

static void compact_keys_take_half_the_room_and_less(void **state)
{
    (void)state;
    random_source r = random_from(41);
    size_t floats, compact;
    random_clip_draw(&r, RANDOM_CLIP_JOINTS, 0, &drawn);
    free(clip_build(&drawn.source, &floats));
    drawn.source.format = NKW_CLIP_UNORM16;
    free(clip_build(&drawn.source, &compact));
    /* Of 24 keys: 12 words and 2 for the range instead of 24, of rotations 36 and 6 instead of 120. */
    assert_true(2 * compact < floats);
}

/* Tracks of few keys: 40 joints take no more memory as a compact clip, and not much more than their keys. */
static void few_keys_do_not_grow(void **state)
{
    (void)state;
    random_source r = random_from(42);
    random_clip_draw(&r, RANDOM_CLIP_JOINTS, 0, &drawn);
    for (size_t keys = 2; keys < 8; keys++) {
        size_t floats, compact, raw = 4 * keys * (1 + 10 * RANDOM_CLIP_JOINTS);
        for (size_t i = 0; i < drawn.source.track_count; i++)
            drawn.tracks[i].track.count = keys;
        drawn.source.format = NKW_CLIP_FLOAT32;
        free(clip_build(&drawn.source, &floats));
        drawn.source.format = NKW_CLIP_UNORM16;
        nkw_clip *clip = clip_build(&drawn.source, &compact);
        assert_true(compact <= floats && compact < raw + raw / 2);
        assert_true(keys < 5 || compact < raw + raw / 8);
        float got[NKW_POSE_FLOATS(RANDOM_CLIP_JOINTS)], want[NKW_POSE_FLOATS(RANDOM_CLIP_JOINTS)], none[1];
        random_clip_sample(&drawn, 0.01f, want, none);
        nkw_clip_sample(clip, 0.01f, NULL, pose_span(got, RANDOM_CLIP_JOINTS), NULL);
        for (size_t j = 0; keys < 5 && j < RANDOM_CLIP_JOINTS; j++)
            expect_bits(got[j], want[j]);
        free(clip);
    }
}

static void a_clip_that_lasts_longer_is_compared_while_the_tracks_last(void **state)
{
    (void)state;
    const float own[4] = {-1, 0, 1, 2}, at[2] = {0, 1}, longer[12] = {9, 9, 9, 0, 0, 0, 1, 2, 3, -9, -9, -9};
    nkw_clip_track made = {
        NKW_CLIP_TRANSLATION, 0, {own, longer, 4, 3, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL}};
    nkw_clip_track track = {
        NKW_CLIP_TRANSLATION, 0, {at, longer + 3, 2, 3, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL}};
    nkw_clip_source of_made = {&made, 1, 1, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL}, source = of_made;
    size_t bytes;
    NKW_STACK_WORK(work, NKW_CLIP_DIFFERENCE_WORK(1, 0));
    nkw_clip_error error;
    source.tracks = &track;
    nkw_clip *clip = clip_build(&of_made, &bytes);
    assert_int_equal(nkw_clip_difference(clip, &source, &error, work), NKW_OK);
    expect_bits(error.translation, 0.0f);
    free(clip);
}

static void compact_steps_hold_their_key(void **state)
{
    (void)state;
    const float at[3] = {0, 1, 2}, values[9] = {0, 0, 0, 1, 2, 3, 4, 5, 6};
    nkw_clip_track track = {
        NKW_CLIP_TRANSLATION, 0, {at, values, 3, 3, NKW_TRACK_FLOATS, NKW_INTERPOLATION_STEP, NULL}};
    nkw_clip_source source = {&track, 1, 1, 0, {NULL, 0}, NULL, NKW_CLIP_UNORM16, NULL};
    size_t bytes;
    float pose[NKW_POSE_FLOATS(1)];
    nkw_clip *clip = clip_build(&source, &bytes);
    for (int k = 0; k < 5; k++) {
        nkw_clip_sample(clip, 0.5f * (float)k, NULL, pose_span(pose, 1), NULL);
        nkw_vec3 want = {values[k / 2 * 3], values[k / 2 * 3 + 1], values[k / 2 * 3 + 2]};
        expect_vec3_near(nkw_pose_get(pose_view(pose, 1), 0).translation, want, 6.0 / 65535);
    }
    free(clip);
}

static void compact_steps_of_rotations_have_the_same_bits_until_the_next_key(void **state)
{
    (void)state;
    random_source r = random_from(42);
    const float at[3] = {0, 1, 2};
    float values[12], first[NKW_POSE_FLOATS(1)], later[NKW_POSE_FLOATS(1)];
    for (int i = 0; i < 200; i++) {
        for (int k = 0; k < 3; k++) {
            nkw_quat q = random_rotation(&r);
            memcpy(values + 4 * k, &q, sizeof q);
        }
        nkw_clip_track track = {
            NKW_CLIP_ROTATION, 0, {at, values, 3, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_STEP, NULL}};
        nkw_clip_source source = {&track, 1, 1, 0, {NULL, 0}, NULL, NKW_CLIP_UNORM16, NULL};
        size_t bytes;
        nkw_clip *clip = clip_build(&source, &bytes);
        nkw_clip_sample(clip, 1.0f, NULL, pose_span(first, 1), NULL);
        nkw_clip_sample(clip, 1.7f, NULL, pose_span(later, 1), NULL);
        expect_quat_bits(nkw_pose_get(pose_view(later, 1), 0).rotation, nkw_pose_get(pose_view(first, 1), 0).rotation);
        free(clip);
    }
}

/*
 * Exported rotations near the identity: components of 1e-29 to 1e-23, w off 1 by a rounding. No product is subnormal.
 */
static void noise_in_rotations_makes_no_subnormal_products(void **state)
{
    (void)state;
#ifdef FE_UNDERFLOW
    enum { JOINTS = 20 };
    const float at[4] = {0, 0.25f, 0.5f, 1};
    float values[JOINTS][16], pose[NKW_POSE_FLOATS(JOINTS)];
    nkw_clip_track tracks[JOINTS];
    random_source r = random_from(27);
    size_t bytes;
    for (uint32_t j = 0; j < JOINTS; j++) {
        nkw_clip_track t = {
            NKW_CLIP_ROTATION, j, {at, values[j], 4, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR, NULL}};
        for (int i = 0; i < 16; i++)
            values[j][i] = i % 4 == 3 ? 1.0f - 0x1p-24f * (float)(i / 4 % 2)
                                      : random_between(&r, -1, 1) * powf(10, random_between(&r, -29, -23));
        tracks[j] = t;
    }
    nkw_clip_source source = {tracks, JOINTS, JOINTS, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
    nkw_clip *clip = clip_build(&source, &bytes);
    feclearexcept(FE_UNDERFLOW);
    for (float time = 0; time < 1; time += 0.0625f)
        nkw_clip_sample(clip, time, NULL, pose_span(pose, JOINTS), NULL);
    assert_int_equal(fetestexcept(FE_UNDERFLOW), 0);
    free(clip);
#endif
}

/* Times that stay between two keys, cross them, hold them and jump. */
static void a_cache_keeps_the_bits(void **state)
{
    (void)state;
    random_source r = random_from(28);
    for (int round = 0; round < 60; round++) {
        size_t joints = 1 + (size_t)(random_bits(&r) % RANDOM_CLIP_JOINTS), bytes;
        random_clip_draw(&r, joints, round % 5, &drawn);
        drawn.source.format = round % 4 ? NKW_CLIP_UNORM16 : NKW_CLIP_FLOAT32;
        nkw_clip *clip = clip_build(&drawn.source, &bytes);
        size_t cached = nkw_clip_describe(clip).cache_bytes;
        void *cache = calloc(1, cached);
        assert_non_null(cache);
        float time = 0, got[NKW_POSE_FLOATS(RANDOM_CLIP_JOINTS)], want[NKW_POSE_FLOATS(RANDOM_CLIP_JOINTS)];
        float floats[RANDOM_CLIP_FLOATS] = {0}, want_floats[RANDOM_CLIP_FLOATS] = {0};
        for (int i = 0; i < 150; i++) {
            time = i % 25 == 0 ? random_clip_time(&r, &drawn, i / 25) : time + 0.004f;
            assert_int_equal(nkw_clip_sample(clip, time, NULL, pose_span(want, joints), want_floats), NKW_OK);
            assert_int_equal(
                nkw_clip_sample_cached(clip, time, bytes_span(cache, cached), pose_span(got, joints), floats), NKW_OK);
            expect_same_pose(got, want, joints);
            expect_floats_bits(floats, want_floats, drawn.source.float_count);
        }
        assert_int_equal(
            nkw_clip_sample_cached(clip, time, bytes_span(cache, cached - 1), pose_span(got, joints), floats),
            NKW_TOO_SMALL);
        assert_int_equal(
            nkw_clip_sample_cached(clip, time, bytes_span(cache, cached), pose_span(got, joints + 1), floats),
            NKW_MISMATCHED);
        free(cache);
        free(clip);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constant_tracks_are_stored_once),
        cmocka_unit_test(short_gaps_between_joints_are_gone_over),
        cmocka_unit_test(cubic_rotations_that_stay_are_constants),
        cmocka_unit_test(cubics_over_an_endless_duration_are_no_constants),
        cmocka_unit_test(the_order_of_tracks_does_not_matter),
        cmocka_unit_test(equal_times_share_a_timeline_and_times_that_differ_in_one_key_do_not),
        cmocka_unit_test(build_refuses_what_is_no_clip),
        cmocka_unit_test(the_first_that_repeats_is_named),
        cmocka_unit_test(floats_that_overlap_are_refused),
        cmocka_unit_test(compact_keys_take_half_the_room_and_less),
        cmocka_unit_test(few_keys_do_not_grow),
        cmocka_unit_test(a_clip_that_lasts_longer_is_compared_while_the_tracks_last),
        cmocka_unit_test(compact_steps_hold_their_key),
        cmocka_unit_test(a_cache_keeps_the_bits),
        cmocka_unit_test(noise_in_rotations_makes_no_subnormal_products),
        cmocka_unit_test(compact_steps_of_rotations_have_the_same_bits_until_the_next_key),
    };
    return cmocka_run_group_tests_name("clip_tracks", tests, NULL, NULL);
}
