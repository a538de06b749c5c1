/* SPDX-License-Identifier: MIT */
/* Clips of tracks that are resampled, each at the lowest rate that keeps a tolerance; clips of nearly even times. */
#include "support/clips.h"
#include "support/page.h"
#include "support/tracks.h"
#include "support/views.h"
#include "support/resample.h"

#define JOINTS    150
#define TRACKS    (3 * JOINTS)
#define KEYS      65
#define RATE      32.0f
#define TOLERANCE 8e-3f

/* What is captured, and the tracks that are made of it. */
typedef struct capture {
    float times[KEYS], values[TRACKS][4 * KEYS];
    float own_times[TRACKS][KEYS], own_values[TRACKS][4 * KEYS];
    nkw_clip_track tracks[TRACKS], own[TRACKS];
} capture;

static capture taken;

/* A wave of 1/2, 1 or 2 turns in the two seconds. Of rotations the angle about y, of numbers each component. */
static void draw_values(size_t joint, int rotation, float *values)
{
    float turns = joint % 3 == 0 ? 0.5f : joint % 3 == 1 ? 1.0f : 2.0f, phase = 0.1f * (float)joint;
    for (size_t k = 0; k < KEYS; k++) {
        float angle = 6.2831853f * turns * (float)k / (float)(KEYS - 1) + phase;
        nkw_vec3 wave = {0.2f * nkw_sin(angle), 0.1f * nkw_cos(angle), 0.3f * nkw_sin(angle + 1.0f)}, up = {0, 1, 0};
        nkw_quat turn = nkw_quat_from_axis_angle(up, 2.0f * wave.x);
        if (rotation)
            memcpy(values + 4 * k, &turn, sizeof turn);
        else
            memcpy(values + 3 * k, &wave, sizeof wave);
    }
}

static int draw(void **state)
{
    capture *c = &taken;
    (void)state;
    for (size_t k = 0; k < KEYS; k++)
        c->times[k] = nkw_timeline_time((nkw_timeline){0.0f, RATE, 0}, k);
    for (size_t i = 0; i < TRACKS; i++) {
        nkw_clip_target target = (nkw_clip_target)(i % 3);
        int rotation = target == NKW_CLIP_ROTATION;
        nkw_track track = {c->times,
                           c->values[i],
                           KEYS,
                           rotation ? 4 : 3,
                           rotation ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS,
                           NKW_INTERPOLATION_LINEAR,
                           NULL};
        nkw_clip_track whole = {target, (uint32_t)(i / 3), track};
        NKW_STACK_WORK(room, NKW_TRACK_WORK(4));
        draw_values(i / 3, rotation, c->values[i]);
        c->tracks[i] = c->own[i] = whole;
        float rate = resample_within(&track, TOLERANCE, c->own_times[i], c->own_values[i], room, &c->own[i].track);
        assert_true(rate > 0.0f && rate < RATE);
    }
    return 0;
}

static nkw_clip_source source_of(const nkw_clip_track *tracks, nkw_clip_format format)
{
    nkw_clip_source source = {tracks, TRACKS, JOINTS, 0, {NULL, 0}, NULL, format, NULL};
    return source;
}

static nkw_clip *build(const nkw_clip_track *tracks, nkw_clip_format format)
{
    nkw_clip_source source = source_of(tracks, format);
    size_t bytes;
    return clip_build(&source, &bytes);
}

static void sampling_gives_the_bits_of_track_by_track(void **state)
{
    (void)state;
    nkw_clip *clip = build(taken.own, NKW_CLIP_FLOAT32);
    for (float time = -0.1f; time < 2.2f; time += 0.0371f) {
        float got[NKW_POSE_FLOATS(JOINTS)], want[NKW_POSE_FLOATS(JOINTS)];
        nkw_clip_sample(clip, time, NULL, pose_span(got, nkw_clip_describe(clip).joint_count), NULL);
        nkw_pose_identity(pose_span(want, JOINTS));
        for (size_t i = 0; i < TRACKS; i++)
            track_sample_to(&taken.own[i], time, JOINTS, want, NULL);
        expect_same_pose(got, want, JOINTS);
    }
    free(clip);
}

/* 16 bits add half a step of a range of 0.6 at most, and 1.75e-4 radians. */
static void fewer_keys_keep_the_tolerance(void **state)
{
    (void)state;
    for (int format = NKW_CLIP_FLOAT32; format <= NKW_CLIP_UNORM16; format++) {
        NKW_STACK_WORK(work, NKW_CLIP_DIFFERENCE_WORK(JOINTS, 0));
        nkw_clip *whole = build(taken.tracks, (nkw_clip_format)format);
        nkw_clip *own = build(taken.own, (nkw_clip_format)format);
        const nkw_clip_description of_whole = nkw_clip_describe(whole), of_own = nkw_clip_describe(own);
        nkw_clip_source source = source_of(taken.tracks, NKW_CLIP_FLOAT32);
        nkw_clip_error error;
        assert_int_equal(nkw_clip_difference(own, &source, &error, work), NKW_OK);
        assert_true(error.translation > 1e-5f && error.translation < TOLERANCE + 5e-6f);
        assert_true(error.rotation > 1e-5f && error.rotation < TOLERANCE + 1.75e-4f);
        assert_true(error.scale > 1e-5f && error.scale < TOLERANCE + 5e-6f);
        expect_page("subjects/clip/clip.md", "| %s | %lu | %lu | %.4f | %.4f |", format ? "16 bits" : "floats",
                    (unsigned long)of_whole.bytes, (unsigned long)of_own.bytes, (double)error.translation,
                    (double)error.rotation);
        assert_int_equal(of_whole.cursor_count, 1);
        assert_true(of_own.cursor_count > 1 && of_own.cursor_count <= 4);
        assert_true(of_own.bytes < of_whole.bytes / 2);
        free(whole);
        free(own);
    }
}

/* Key times that are even before they are rounded: the clip finds their segments by a rate. */
static void nearly_even_times_give_the_bits_of_tracks(void **state)
{
    (void)state;
    const float step = 1.0f / 24;
    for (int series = 0; series < 4; series++) {
        float times[KEYS], time = -1.0f;
        for (size_t k = 0; k < KEYS; k++)
            times[k] = series == 0   ? (float)k * step
                       : series == 1 ? (float)(k + 10) * step
                       : series == 2 ? (float)(k + 10) / 29.97f
                                     : (k ? times[k - 1] : -0.7f) + step;
        nkw_clip_track track = taken.tracks[1];
        track.index = 0;
        track.track.times = times;
        nkw_clip_source source = {&track, 1, 1, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
        size_t bytes;
        nkw_clip *clip = clip_build(&source, &bytes);
        for (int i = 0; i < 2000; i++, time += 0.0025f) {
            float pose[NKW_POSE_FLOATS(1)], want[4], at = i < (int)KEYS ? times[i] : time;
            nkw_clip_sample(clip, at, NULL, pose_span(pose, 1), NULL);
            nkw_track_sample(&track.track, at, NULL, want);
            nkw_quat got = nkw_pose_get(pose_view(pose, 1), 0).rotation;
            assert_memory_equal(&got, want, sizeof got);
        }
        free(clip);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sampling_gives_the_bits_of_track_by_track),
        cmocka_unit_test(fewer_keys_keep_the_tolerance),
        cmocka_unit_test(nearly_even_times_give_the_bits_of_tracks),
    };
    return cmocka_run_group_tests_name("clip_rates", tests, draw, NULL);
}
