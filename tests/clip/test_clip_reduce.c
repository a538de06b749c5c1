/* SPDX-License-Identifier: MIT */
/* Clips that are reduced to a tolerance. */
#include "support/clips.h"
#include "support/farthest.h"
#include "support/page.h"
#include "support/tracks.h"
#include "support/views.h"
#include "support/random_clip.h"

#define JOINTS 90 /* more rotations, and more numbers, than a packed group has */
#define KEYS   61
#define TRACKS (3 * JOINTS + 1)
#define FLOATS 3

static struct {
    float times[KEYS], values[TRACKS][4 * KEYS];
    int32_t parents[JOINTS];
    nkw_clip_track tracks[TRACKS];
    nkw_clip_source source;
} drawn;
static double work[NKW_CLIP_REDUCE_WORK(TRACKS, JOINTS, FLOATS) / 8 + 2];
static float block[1 << 19], pose[NKW_POSE_FLOATS(JOINTS)], wanted[NKW_POSE_FLOATS(JOINTS)], floats[FLOATS];

/*
 * Chains of ten joints of length 0.1. All rotate, the roots also translate; scales and other translations stay within
 * 1e-7 of their first key. Whole periods: the last key equals the first. The floats are a wave.
 */
static float wave(size_t track, size_t k, size_t component)
{
    float turns = (float)(1 + (track + component) % 3), phase = 0.7f * (float)track + (float)component;
    return nkw_sin(6.2831853f * turns * (float)(k % (KEYS - 1)) / (float)(KEYS - 1) + phase);
}

static void draw_key(size_t track, size_t k, float *v)
{
    nkw_vec3 turn = {0.3f * wave(track, k, 0), 0.2f * wave(track, k, 1), 0.1f * wave(track, k, 2)};
    nkw_quat q = nkw_quat_exp(turn);
    float still = 1e-7f * wave(track, k, 0), moving = track % 30 == 0 ? 0.5f * wave(track, k, 0) : still;
    if (track == TRACKS - 1)
        v[0] = wave(0, k, 0), v[1] = 0.25f, v[2] = 100.0f * wave(2, k, 0);
    else if (track % 3 == 1)
        memcpy(v, &q, sizeof q);
    else
        v[0] = track % 3 == 2 ? 1.0f + still : 0.1f + moving, v[1] = track % 3 == 2 ? 1.0f : still, v[2] = v[1];
}

static int draw(void **state)
{
    (void)state;
    for (size_t k = 0; k < KEYS; k++)
        drawn.times[k] = nkw_timeline_time((nkw_timeline){0.5f, 30.0f, 0}, k);
    for (size_t i = 0; i < TRACKS; i++) {
        const nkw_clip_target target = i == TRACKS - 1 ? NKW_CLIP_FLOATS : (nkw_clip_target)(i % 3);
        const size_t width = target == NKW_CLIP_ROTATION ? 4 : 3;
        const nkw_track track = {drawn.times,
                                 drawn.values[i],
                                 KEYS,
                                 width,
                                 target == NKW_CLIP_ROTATION ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS,
                                 NKW_INTERPOLATION_LINEAR,
                                 NULL};
        const nkw_clip_track whole = {target, i == TRACKS - 1 ? 0 : (uint32_t)(i / 3), track};
        drawn.tracks[i] = whole;
        for (size_t k = 0; k < KEYS; k++)
            draw_key(i, k, drawn.values[i] + width * k);
    }
    for (size_t j = 0; j < JOINTS; j++)
        drawn.parents[j] = j % 10 == 0 ? NKW_NO_JOINT : (int32_t)j - 1;
    const nkw_clip_source source = {drawn.tracks, TRACKS, JOINTS, FLOATS, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
    drawn.source = source;
    return 0;
}

static nkw_clip_reduction within(float tolerance)
{
    const nkw_clip_reduction r = {drawn.parents, tolerance, 0.1f, NULL, NULL, 1e-3f};
    return r;
}

static nkw_result reduce_to(const nkw_clip_reduction *r, nkw_clip_reduced *reduced)
{
    size_t bad;
    return nkw_clip_reduce(&drawn.source, r, bytes_span(block, sizeof block), reduced, &bad,
                           work_in(work, sizeof work));
}

static const nkw_clip *reduced_clip(const nkw_clip_reduction *r, nkw_clip_reduced *reduced)
{
    const nkw_clip *clip = NULL;
    assert_int_equal(reduce_to(r, reduced), NKW_OK);
    assert_int_equal(nkw_clip_open(block, reduced->bytes, &clip), NKW_OK);
    assert_int_equal(nkw_clip_describe(clip).bytes, reduced->bytes);
    return clip;
}

static void want(float time)
{
    nkw_pose_identity(pose_span(wanted, JOINTS));
    for (size_t i = 0; i < TRACKS; i++)
        track_sample_to(&drawn.tracks[i], time, JOINTS, wanted, floats);
}

/* The largest distance in model space of the points within 0.1 of a joint. */
static float distance_at(const nkw_clip *clip, float time)
{
    static nkw_mat4 got_models[JOINTS], want_models[JOINTS];
    const nkw_skeleton skeleton = {drawn.parents, JOINTS};
    float largest = 0.0f;
    want(time);
    nkw_clip_sample(clip, time, NULL, pose_span(pose, JOINTS), floats);
    nkw_skeleton_models_from_pose(&skeleton, pose_view(pose, JOINTS), NULL, NULL, got_models);
    nkw_skeleton_models_from_pose(&skeleton, pose_view(wanted, JOINTS), NULL, NULL, want_models);
    for (size_t j = 0; j < JOINTS; j++) {
        float d = (float)farthest_distance(&got_models[j], &want_models[j], 0.1);
        largest = d > largest ? d : largest;
    }
    return largest;
}

static void a_reduced_clip_is_small_and_within_the_tolerance(void **state)
{
    const float tolerances[3] = {1e-4f, 1e-3f, 1e-2f};
    size_t before = clip_size_of(&drawn.source), bytes = 0, all[3];
    (void)state;
    for (int i = 0; i < 3; i++) {
        const nkw_clip_reduction r = within(tolerances[i]);
        nkw_clip_reduced reduced;
        const nkw_clip *clip = reduced_clip(&r, &reduced);
        float largest = 0.0f;
        for (size_t k = 0; k < 2 * KEYS - 1; k++) {
            float d = distance_at(clip, 0.5f + (float)k / 60.0f);
            largest = d > largest ? d : largest;
        }
        assert_true(reduced.share <= 1.0f && reduced.distance <= tolerances[i] && reduced.floats <= 1e-3f);
        assert_true(largest <= tolerances[i] + 1e-5f && largest >= reduced.distance - 1e-5f);
        assert_true(reduced.bytes * 4 < before && (bytes == 0 || reduced.bytes < bytes));
        bytes = all[i] = reduced.bytes;
    }
    expect_page("subjects/clip/clip.md",
                "| %d joints, %d keys, 100 of %d tracks move ([`tests/clip/test_clip_reduce.c`]"
                "(../../../tests/clip/test_clip_reduce.c)) | %lu | %lu | %lu |",
                JOINTS, KEYS, TRACKS, (unsigned long)before, (unsigned long)all[0], (unsigned long)all[1]);
}

static void tracks_within_the_tolerance_become_constant(void **state)
{
    const nkw_clip_reduction r = within(1e-3f);
    nkw_clip_reduced reduced;
    (void)state;
    reduced_clip(&r, &reduced);
    assert_int_equal(reduced.constant_count, JOINTS + JOINTS - JOINTS / 10);
    assert_int_equal(reduced.packed_count, TRACKS - reduced.constant_count);
}

static void a_loop_stays_closed(void **state)
{
    const nkw_clip_reduction r = within(1e-3f);
    nkw_clip_reduced reduced;
    float first[NKW_POSE_FLOATS(JOINTS)];
    (void)state;
    const nkw_clip *clip = reduced_clip(&r, &reduced);
    nkw_clip_sample(clip, nkw_clip_describe(clip).start, NULL, pose_span(first, JOINTS), NULL);
    nkw_clip_sample(clip, nkw_clip_describe(clip).end, NULL, pose_span(pose, JOINTS), NULL);
    for (size_t c = 0; c < 10; c++)
        for (size_t j = 0; j < JOINTS; j++)
            assert_true(first[c * NKW_POSE_STRIDE(JOINTS) + j] == pose[c * NKW_POSE_STRIDE(JOINTS) + j]);
    assert_true(nkw_clip_describe(clip).start == drawn.times[0] &&
                nkw_clip_describe(clip).end == drawn.times[KEYS - 1]);
}

/* Every joint has its own tolerance: that of an odd chain is 100 times that of an even one. */
static void each_joint_keeps_its_own_tolerance(void **state)
{
    float tolerances[JOINTS], distances[JOINTS];
    nkw_clip_reduction r = within(0.0f);
    nkw_clip_reduced own, strict;
    (void)state;
    for (size_t j = 0; j < JOINTS; j++) {
        tolerances[j] = j / 10 % 2 ? 1e-2f : 1e-4f;
        distances[j] = 0.05f;
    }
    r.tolerances = tolerances, r.distances = distances;
    reduced_clip(&r, &own);
    assert_true(own.share <= 1.0f && own.distance > 1e-4f && own.distance <= 1e-2f);
    for (size_t j = 0; j < JOINTS; j++)
        tolerances[j] = 1e-4f;
    reduced_clip(&r, &strict);
    assert_true(strict.share <= 1.0f && strict.distance <= 1e-4f && own.bytes < strict.bytes);
}

static void a_tolerance_of_zero_keeps_the_bits_of_the_tracks(void **state)
{
    nkw_clip_reduction r = within(0.0f);
    nkw_clip_reduced reduced;
    (void)state;
    r.float_tolerance = 0.0f;
    const nkw_clip *clip = reduced_clip(&r, &reduced);
    assert_true(reduced.share == 0.0f && reduced.packed_count == 0);
    for (size_t k = 0; k < 100; k++) {
        float time = 0.4f + 0.023f * (float)k;
        want(time);
        nkw_clip_sample(clip, time, NULL, pose_span(pose, JOINTS), NULL);
        for (size_t c = 0; c < 10; c++)
            assert_memory_equal(pose + c * NKW_POSE_STRIDE(JOINTS), wanted + c * NKW_POSE_STRIDE(JOINTS),
                                JOINTS * sizeof *pose);
    }
}

/* A joint that turns round and round, one that jumps far, steps, and cubics. */
static void tracks_that_cannot_be_packed_keep_their_bits(void **state)
{
    const nkw_clip_reduction r = within(1e-4f);
    nkw_clip_reduced reduced;
    (void)state;
    for (size_t k = 0; k < KEYS; k++) {
        nkw_vec3 up = {0.0f, 1.0f, 0.0f};
        nkw_quat q = nkw_quat_from_axis_angle(up, 0.4f * (float)k);
        memcpy(drawn.values[1] + 4 * k, &q, sizeof q);
        drawn.values[30][3 * k] = k < 20 ? 0.0f : 1e4f;
    }
    drawn.tracks[61].track.interpolation = NKW_INTERPOLATION_STEP;
    drawn.tracks[60].track.interpolation = NKW_INTERPOLATION_CUBICSPLINE;
    drawn.tracks[60].track.count = KEYS / 3;
    const nkw_clip *clip = reduced_clip(&r, &reduced);
    assert_true(reduced.share <= 1.0f);
    for (size_t k = 0; k < 100; k++) {
        float time = 0.4f + 0.023f * (float)k;
        want(time);
        nkw_clip_sample(clip, time, NULL, pose_span(pose, JOINTS), NULL);
        for (size_t c = 0; c < 10; c++) {
            size_t at = c * NKW_POSE_STRIDE(JOINTS);
            if (c >= 3 && c < 7) /* the rotations of joints 0 and 20 */
                assert_true(pose[at] == wanted[at] && pose[at + 20] == wanted[at + 20]);
            else if (c < 3) /* the translations of joints 10 and 20 */
                assert_true(pose[at + 10] == wanted[at + 10] && pose[at + 20] == wanted[at + 20]);
        }
    }
    draw(state);
}

static void a_cache_returns_the_same_bits(void **state)
{
    static float cache[1 << 14], again[NKW_POSE_FLOATS(JOINTS)];
    const nkw_clip_reduction r = within(1e-3f);
    nkw_clip_reduced reduced;
    (void)state;
    const nkw_clip *clip = reduced_clip(&r, &reduced);
    assert_true(nkw_clip_describe(clip).cache_bytes <= sizeof cache);
    memset(cache, 0, sizeof cache);
    for (size_t k = 0; k < 300; k++) {
        float time = k < 250 ? 0.45f + 0.01f * (float)k : 0.5f + (float)(k * 7 % 11) / 30.0f;
        float twice[2][FLOATS];
        nkw_clip_sample(clip, time, NULL, pose_span(pose, JOINTS), twice[0]);
        assert_int_equal(
            nkw_clip_sample_cached(clip, time, bytes_span(cache, sizeof cache), pose_span(again, JOINTS), twice[1]),
            NKW_OK);
        assert_memory_equal(twice[0], twice[1], sizeof twice[0]);
        for (size_t c = 0; c < 10; c++)
            assert_memory_equal(pose + c * NKW_POSE_STRIDE(JOINTS), again + c * NKW_POSE_STRIDE(JOINTS),
                                JOINTS * sizeof *pose);
    }
}

/*
 * Joints that stay, but for the noise of an exporter: scales and rotations are equal, so they are stored once for many,
 * and a pose has them all, up to the last joint.
 */
static void equal_constants_are_stored_once(void **state)
{
    (void)state;
    const nkw_quat unit = {0.6f, 0.0f, 0.0f, 0.8f};
    const nkw_clip_reduction r = {NULL, 1e-4f, 0.1f, NULL, NULL, 1e-3f};
    nkw_clip_source still = drawn.source;
    nkw_clip_reduced reduced;
    static nkw_clip_track tracks[TRACKS];
    static float values[TRACKS][4 * KEYS];
    for (size_t i = 0; i < TRACKS; i++) {
        tracks[i] = drawn.tracks[i];
        tracks[i].track.values = values[i];
        for (size_t k = 0; k < KEYS; k++)
            if (tracks[i].target == NKW_CLIP_ROTATION)
                memcpy(values[i] + 4 * k, &unit, sizeof unit);
            else
                for (size_t c = 0; c < tracks[i].track.width; c++)
                    values[i][tracks[i].track.width * k + c] =
                        (tracks[i].target == NKW_CLIP_SCALE ? 1.0f : (float)(3 * i + c)) + 1e-6f * (float)(k % 2);
    }
    still.tracks = tracks;
    assert_int_equal(
        nkw_clip_reduce(&still, &r, bytes_span(block, sizeof block), &reduced, NULL, work_in(work, sizeof work)),
        NKW_OK);
    const nkw_clip *clip;
    assert_int_equal(nkw_clip_open(block, reduced.bytes, &clip), NKW_OK);
    assert_int_equal(reduced.constant_count, TRACKS);
    assert_true(reduced.bytes <= 4 * (3 * NKW_POSE_STRIDE(JOINTS) + FLOATS) + 300);
    memset(pose, 0xff, sizeof pose);
    assert_int_equal(nkw_clip_sample(clip, 1.0f, NULL, pose_span(pose, JOINTS), floats), NKW_OK);
    for (size_t j = 0; j < JOINTS; j++) {
        const nkw_trs trs = nkw_pose_get(pose_view(pose, JOINTS), j);
        assert_true(nkw_abs(trs.scale.x - 1.0f) <= 1e-6f && nkw_abs(trs.scale.z - 1.0f) <= 1e-6f);
        assert_true(nkw_quat_angle(trs.rotation, unit) <= 1e-6f);
        assert_true(nkw_abs(trs.translation.y - values[3 * j][1]) <= 1e-4f);
    }
}

static void wrong_arguments_are_refused(void **state)
{
    nkw_clip_reduction r = within(1e-3f);
    const size_t needed = NKW_CLIP_REDUCE_WORK(TRACKS, JOINTS, FLOATS);
    const nkw_work room = work_in(work, sizeof work), enough = {room.data, needed}, little = {room.data, needed - 1};
    const nkw_work misaligned = {(unsigned char *)room.data + 8, needed};
    nkw_clip_reduced reduced;
    size_t bad = 9;
    (void)state;
    assert_int_equal(nkw_clip_reduce(&drawn.source, &r, bytes_span(NULL, 0), &reduced, &bad, enough), NKW_TOO_SMALL);
    const size_t bytes = reduced.bytes;
    assert_true(bytes > 0 && bytes <= sizeof block && bad == 0);
    const nkw_bytes_span whole = bytes_span(block, bytes), small = bytes_span(block, bytes - 1);
    assert_int_equal(nkw_clip_reduce(&drawn.source, &r, small, &reduced, &bad, enough), NKW_TOO_SMALL);
    assert_int_equal(reduced.bytes, bytes);
    assert_int_equal(nkw_clip_reduce(&drawn.source, &r, whole, &reduced, &bad, little), NKW_TOO_SMALL);
    assert_int_equal(reduced.bytes, 0);
    assert_int_equal(nkw_clip_reduce(&drawn.source, &r, whole, &reduced, &bad, misaligned), NKW_TOO_SMALL);
    assert_int_equal(reduced.bytes, 0);
    r.distance = -1.0f;
    assert_int_equal(reduce_to(&r, &reduced), NKW_OUT_OF_RANGE);
    r = within(NAN);
    assert_int_equal(reduce_to(&r, &reduced), NKW_NOT_FINITE);
    r = within(1e-3f);
    drawn.source.format = NKW_CLIP_UNORM16;
    assert_int_equal(reduce_to(&r, &reduced), NKW_BAD_FORMAT);
    drawn.source.format = NKW_CLIP_FLOAT32;
    drawn.tracks[7].index = 0;
    assert_int_equal(reduce_to(&r, &reduced), NKW_REPEATED);
    assert_int_equal(reduced.bytes, 0);
    draw(state);
}

/* A change of any word of the block: refused, or sampled without an access outside (sanitizers). */
static void a_damaged_reduced_block_is_refused_or_safe(void **state)
{
    const nkw_clip_reduction r = within(1e-3f);
    nkw_clip_reduced reduced;
    random_source random = random_from(3);
    uint32_t *words = (uint32_t *)(void *)block;
    (void)state;
    reduced_clip(&r, &reduced);
    for (size_t i = 0; i < reduced.bytes / 4; i += i < 3000 ? 1 : 61) {
        const uint32_t kept = words[i];
        const nkw_clip *clip;
        words[i] = i % 3 == 0 ? (uint32_t)random_bits(&random) : i % 3 == 1 ? kept + 1 : kept ^ 1u << i % 32;
        if (nkw_clip_open(block, reduced.bytes, &clip) == NKW_OK && nkw_clip_describe(clip).joint_count == JOINTS &&
            nkw_clip_describe(clip).float_count == FLOATS)
            for (int k = 0; k < 3; k++)
                nkw_clip_sample(clip, 0.5f + (float)k, NULL, pose_span(pose, JOINTS), floats);
        words[i] = kept;
    }
    const nkw_clip *clip;
    assert_int_equal(nkw_clip_open(block, reduced.bytes - 4, &clip), NKW_TOO_SMALL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_reduced_clip_is_small_and_within_the_tolerance),
        cmocka_unit_test(tracks_within_the_tolerance_become_constant),
        cmocka_unit_test(a_loop_stays_closed),
        cmocka_unit_test(each_joint_keeps_its_own_tolerance),
        cmocka_unit_test(a_tolerance_of_zero_keeps_the_bits_of_the_tracks),
        cmocka_unit_test(tracks_that_cannot_be_packed_keep_their_bits),
        cmocka_unit_test(a_cache_returns_the_same_bits),
        cmocka_unit_test(equal_constants_are_stored_once),
        cmocka_unit_test(wrong_arguments_are_refused),
        cmocka_unit_test(a_damaged_reduced_block_is_refused_or_safe),
    };
    return cmocka_run_group_tests(tests, draw, NULL);
}
