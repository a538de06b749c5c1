/* SPDX-License-Identifier: MIT */
/* The names and the tracks of a clip, taken out again; blocks of the other byte order. */
#include <math.h>
#include <stdlib.h>

#include "random_clip.h"
#include "support/clips.h"
#include "support/expect.h"
#include "views.h"

#define TRACKS (3 * RANDOM_CLIP_JOINTS + RANDOM_CLIP_FLOATS)

/* Keys of all tracks of a clip. */
typedef struct taken {
    nkw_clip_track tracks[TRACKS];
    float times[TRACKS][RANDOM_CLIP_KEYS], values[TRACKS][12 * RANDOM_CLIP_KEYS];
    unsigned char modes[TRACKS][RANDOM_CLIP_KEYS];
    float rest[NKW_POSE_FLOATS(RANDOM_CLIP_JOINTS)], floats[RANDOM_CLIP_FLOATS];
    nkw_clip_source source;
} taken;

static void take(const nkw_clip *clip, taken *t)
{
    NKW_STACK_WORK(room, NKW_CLIP_TRACK_GET_WORK(RANDOM_CLIP_JOINTS, RANDOM_CLIP_FLOATS));
    const nkw_clip_description d = nkw_clip_describe(clip);
    const size_t joints = d.joint_count, count = d.track_count;
    const nkw_work work = {room.data, NKW_CLIP_TRACK_GET_WORK(joints, d.float_count)}, none = {NULL, 0};
    const nkw_track_span nowhere = {NULL, NULL, NULL, 0};
    nkw_clip_source source = {t->tracks,         count,     joints,           d.float_count,
                              {t->rest, joints}, t->floats, NKW_CLIP_FLOAT32, NULL};
    assert_true(count <= TRACKS);
    for (size_t i = 0; i < count; i++) {
        nkw_track_span memory = {t->times[i], t->values[i], t->modes[i], RANDOM_CLIP_KEYS};
        nkw_clip_track shape;
        assert_int_equal(nkw_clip_track_get(clip, i, nowhere, &shape, none), NKW_TOO_SMALL);
        assert_null(shape.track.values);
        assert_int_equal(nkw_clip_track_get(clip, i, memory, &t->tracks[i], work), NKW_OK);
        assert_int_equal(t->tracks[i].target, shape.target);
        assert_int_equal(t->tracks[i].index, shape.index);
        assert_int_equal(t->tracks[i].track.count, shape.track.count);
        expect_floats_bits(t->tracks[i].track.times, shape.track.times, shape.track.count);
        assert_int_equal(nkw_track_validate(&t->tracks[i].track, NULL), NKW_OK);
    }
    assert_int_equal(nkw_clip_sample(clip, 0.0f, NULL, pose_span(t->rest, joints), t->floats), NKW_OK);
    t->source = source;
}

/* Draws a clip whose rotations are unit, so that no key is changed by what normalises it. */
static void draw(random_source *r, size_t joints, int variety, random_clip *c)
{
    memset(c, 0, sizeof *c);
    random_clip_draw(r, joints, variety, c);
}

static void expect_samples(random_source *r, const random_clip *c, const nkw_clip *got, const nkw_clip *want)
{
    const size_t joints = c->source.joint_count;
    static float a[NKW_POSE_FLOATS(RANDOM_CLIP_JOINTS)], b[NKW_POSE_FLOATS(RANDOM_CLIP_JOINTS)];
    float x[RANDOM_CLIP_FLOATS], y[RANDOM_CLIP_FLOATS];
    for (int i = 0; i < 24; i++) {
        float time = random_clip_time(r, c, i);
        assert_int_equal(nkw_clip_sample(got, time, NULL, pose_span(a, joints), x), NKW_OK);
        assert_int_equal(nkw_clip_sample(want, time, NULL, pose_span(b, joints), y), NKW_OK);
        expect_same_pose(a, b, joints);
        expect_floats_bits(x, y, nkw_clip_describe(want).float_count);
    }
}

static void a_clip_of_its_own_tracks_returns_the_same_samples(void **state)
{
    (void)state;
    random_source r = random_from(21);
    static random_clip c;
    static taken t;
    for (int i = 0; i < 40; i++) {
        size_t bytes;
        draw(&r, 1 + random_bits(&r) % RANDOM_CLIP_JOINTS, i % 5, &c);
        nkw_clip *clip = clip_build(&c.source, &bytes);
        take(clip, &t);
        nkw_clip *again = clip_build(&t.source, &bytes);
        expect_samples(&r, &c, again, clip);
        free(again);
        free(clip);
    }
}

static void the_keys_of_compact_clips_are_their_samples(void **state)
{
    (void)state;
    random_source r = random_from(22);
    static random_clip c;
    static taken t;
    for (int i = 0; i < 10; i++) {
        float pose[NKW_POSE_FLOATS(17)], floats[RANDOM_CLIP_FLOATS];
        size_t bytes;
        draw(&r, 17, i % 3, &c);
        c.source.format = NKW_CLIP_UNORM16;
        nkw_clip *clip = clip_build(&c.source, &bytes);
        take(clip, &t);
        for (size_t k = 0; k < t.source.track_count; k++) {
            const nkw_clip_track *track = &t.tracks[k];
            size_t key = random_bits(&r) % track->track.count;
            while (key + 1 < track->track.count && track->track.times[key + 1] == track->track.times[key])
                key++;
            nkw_clip_sample(clip, track->track.times[key], NULL, pose_span(pose, 17), floats);
            float want[4], *out = floats + track->index;
            nkw_trs trs = nkw_pose_get(pose_view(pose, 17), track->target == NKW_CLIP_FLOATS ? 0 : track->index);
            nkw_track_sample(&track->track, track->track.times[key], NULL, want);
            expect_floats_bits(want,
                               track->target == NKW_CLIP_FLOATS        ? out
                               : track->target == NKW_CLIP_TRANSLATION ? &trs.translation.x
                               : track->target == NKW_CLIP_ROTATION    ? &trs.rotation.x
                                                                       : &trs.scale.x,
                               track->track.width);
        }
        free(clip);
    }
}

static void moving_tracks_are_listed_once_and_constant_ones_are_not(void **state)
{
    (void)state;
    const float times[2] = {0.0f, 1.0f}, move[6] = {0, 0, 0, 0, 1, 0}, still[6] = {1, 2, 3, 1, 2, 3};
    nkw_track moving = {times, move, 2, 3, NKW_TRACK_FLOATS, NKW_INTERPOLATION_LINEAR, NULL}, constant = moving;
    constant.values = still;
    nkw_clip_track tracks[12];
    for (uint32_t j = 0; j < 12; j++) {
        nkw_clip_track c = {NKW_CLIP_TRANSLATION, j, j % 4 == 3 ? constant : moving};
        tracks[j] = c;
    }
    const nkw_work none = {NULL, 0};
    const nkw_track_span nowhere = {NULL, NULL, NULL, 0};
    nkw_clip_source source = {tracks, 12, 13, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
    for (int format = 0; format < 2; format++) {
        size_t bytes, seen = 0;
        source.format = (nkw_clip_format)format;
        nkw_clip *clip = clip_build(&source, &bytes);
        assert_int_equal(nkw_clip_describe(clip).track_count, 9);
        for (size_t i = 0; i < 9; i++) {
            nkw_clip_track shape;
            assert_int_equal(nkw_clip_track_get(clip, i, nowhere, &shape, none), NKW_TOO_SMALL);
            assert_int_equal(shape.target, NKW_CLIP_TRANSLATION);
            assert_true(shape.index % 4 != 3 && shape.index < 12);
            seen |= (size_t)1 << shape.index;
        }
        assert_int_equal(seen, 0x777);
        free(clip);
    }
}

/* The track of one clip of one joint, built as floats. */
static nkw_clip *rebuilt(const nkw_clip *clip, float *times, float *values, size_t capacity)
{
    NKW_STACK_WORK(work, NKW_CLIP_TRACK_GET_WORK(1, 0));
    size_t bytes;
    nkw_clip_track track;
    const nkw_track_span memory = {times, values, NULL, capacity};
    assert_int_equal(nkw_clip_describe(clip).track_count, 1);
    assert_int_equal(nkw_clip_track_get(clip, 0, memory, &track, work), NKW_OK);
    const nkw_clip_source source = {&track, 1, 1, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
    return clip_build(&source, &bytes);
}

static nkw_quat rotation_at(const nkw_clip *clip, float time)
{
    float pose[NKW_POSE_FLOATS(1)];
    assert_int_equal(nkw_clip_sample(clip, time, NULL, pose_span(pose, 1), NULL), NKW_OK);
    return nkw_pose_get(pose_view(pose, 1), 0).rotation;
}

/* A turn that goes on by half a turn for each key, as stored in 16 bits or packed, keeps its direction. */
static void half_turns_keep_their_direction(void **state)
{
    (void)state;
    const float known[12] = {0, 0, 0, 1, 0, 1, 0, -4.37113883e-08f, 0, 8.74227766e-08f, 0, 1};
    static float times[20], values[80], got_times[20], got_values[80], block[4096];
    static double work[NKW_CLIP_REDUCE_WORK(1, 1, 0) / 8 + 2];
    random_source r = random_from(25);
    for (size_t k = 0; k < 20; k++)
        times[k] = (float)k;
    for (int i = 0; i < 300; i++) {
        const size_t count = i < 2 ? 3 : 20;
        const nkw_clip_track track = {
            NKW_CLIP_ROTATION, 0, {times, values, count, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR, NULL}};
        nkw_clip_source source = {&track, 1, 1, 0, {NULL, 0}, NULL, NKW_CLIP_UNORM16, NULL};
        const nkw_quat start = random_rotation(&r);
        const nkw_vec3 axis = {random_between(&r, -1, 1), random_between(&r, -1, 1), random_between(&r, -1, 1)};
        for (size_t k = 0; k < count; k++) {
            float turn = 3.14159265f * (1.0f - (i % 3 ? 1e-6f : 1e-4f) * random_between(&r, 0.0f, 1.0f));
            nkw_quat q = nkw_quat_mul(nkw_quat_from_axis_angle(nkw_vec3_normalize(axis), turn * (float)(k % 2)), start);
            memcpy(values + 4 * k, i < 2 ? known + 4 * k : &q.x, sizeof q);
        }
        size_t bytes;
        nkw_clip *built = clip_build(&source, &bytes);
        if (i % 2) {
            const nkw_clip_reduction within = {NULL, 1e-3f, 0.1f, NULL, NULL, 0.0f};
            nkw_clip_reduced reduced;
            source.format = NKW_CLIP_FLOAT32;
            assert_int_equal(nkw_clip_reduce(&source, &within, bytes_span(block, sizeof block), &reduced, NULL,
                                             work_in(work, sizeof work)),
                             NKW_OK);
        }
        const nkw_clip *clip = i % 2 ? (const nkw_clip *)(const void *)block : built;
        nkw_clip *again = rebuilt(clip, got_times, got_values, 20);
        for (size_t k = 0; k < 10 * (count - 1); k++) {
            nkw_quat want = rotation_at(clip, 0.1f * (float)k), got = rotation_at(again, 0.1f * (float)k);
            assert_true(nkw_quat_angle(want, got) < (i % 2 ? 2e-2f : 2.5e-4f));
        }
        free(again);
        free(built);
    }
}

/* What a compact or reduced clip interpolates, and what a clip of floats interpolates between the same keys. */
static void rebuilt_clips_of_other_formats_differ_by_rounding(void **state)
{
    (void)state;
    random_source r = random_from(26);
    static random_clip c;
    static taken t;
    static float block[1 << 17], a[NKW_POSE_FLOATS(17)], b[NKW_POSE_FLOATS(17)];
    static double work[NKW_CLIP_REDUCE_WORK(RANDOM_CLIP_TRACKS, 17, RANDOM_CLIP_FLOATS) / 8 + 2];
    float x[RANDOM_CLIP_FLOATS], y[RANDOM_CLIP_FLOATS];
    int moved = 0;
    for (int i = 0; i < 40; i++) {
        size_t bytes;
        draw(&r, 17, i % 3, &c);
        c.source.format = i % 2 ? NKW_CLIP_FLOAT32 : NKW_CLIP_UNORM16;
        nkw_clip *built = clip_build(&c.source, &bytes);
        const nkw_clip_reduction within = {NULL, 1e-3f, 0.1f, NULL, NULL, 1e-3f};
        nkw_clip_reduced reduced;
        if (i % 2)
            assert_int_equal(nkw_clip_reduce(&c.source, &within, bytes_span(block, sizeof block), &reduced, NULL,
                                             work_in(work, sizeof work)),
                             NKW_OK);
        const nkw_clip *clip = i % 2 ? (const nkw_clip *)(const void *)block : built;
        take(clip, &t);
        nkw_clip *again = clip_build(&t.source, &bytes);
        for (int k = 0; k < 60; k++) {
            const float time = random_clip_time(&r, &c, k);
            nkw_clip_sample(clip, time, NULL, pose_span(a, 17), x);
            nkw_clip_sample(again, time, NULL, pose_span(b, 17), y);
            for (size_t j = 0; j < 17; j++) {
                nkw_trs p = nkw_pose_get(pose_view(a, 17), j), q = nkw_pose_get(pose_view(b, 17), j);
                const float sign = nkw_quat_dot(p.rotation, q.rotation) < 0.0f ? -1.0f : 1.0f;
                expect_vec3_near(p.translation, q.translation, 1e-6);
                expect_vec3_near(p.scale, q.scale, 1e-6);
                const float d = nkw_quat_length(nkw_quat_sub(p.rotation, nkw_quat_scale(q.rotation, sign)));
                assert_true(d < 1e-3f);
                moved += d > 1e-6f; /* between keys half a turn apart */
            }
            for (size_t f = 0; f < nkw_clip_describe(clip).float_count; f++)
                expect_near(x[f], y[f], 1e-6);
        }
        free(again);
        free(built);
    }
    assert_true(moved < 10);
}

static void a_compact_clip_is_never_larger_than_one_of_floats(void **state)
{
    (void)state;
    random_source r = random_from(28);
    static random_clip c;
    size_t smaller = 0;
    for (int i = 0; i < 600; i++) {
        size_t floats, compact;
        draw(&r, 1 + random_bits(&r) % RANDOM_CLIP_JOINTS, i % 5, &c);
        for (size_t k = 0; k < c.source.track_count; k++)
            if (c.tracks[k].track.count > 2 + (size_t)i % 7)
                c.tracks[k].track.count = 2 + (size_t)i % 7;
        floats = clip_size_of(&c.source);
        c.source.format = NKW_CLIP_UNORM16;
        compact = clip_size_of(&c.source);
        assert_true(compact <= floats);
        smaller += compact < floats;
        nkw_clip *clip = clip_build(&c.source, &compact); /* as large as measured */
        free(clip);
    }
    assert_true(smaller > 100);
}

/* The time of a track does not depend on the number of others: in cubic time these were minutes. */
static void all_tracks_of_thousands_of_joints_are_taken_out(void **state)
{
    (void)state;
    enum { MANY = 4000, COUNT = 3 * MANY };
    const float times[3] = {0.0f, 0.5f, 1.0f};
    float *values = (float *)calloc(12 * COUNT, sizeof *values), work_values[12], work_times[3];
    const nkw_work work = {malloc(NKW_CLIP_TRACK_GET_WORK(MANY, 0)), NKW_CLIP_TRACK_GET_WORK(MANY, 0)};
    nkw_clip_track *tracks = (nkw_clip_track *)calloc(COUNT, sizeof *tracks);
    unsigned char *seen = (unsigned char *)calloc(COUNT, 1);
    assert_true(values && work.data && tracks && seen);
    for (size_t i = 0; i < COUNT; i++) {
        const int is_rotation = i % 3 == NKW_CLIP_ROTATION;
        const nkw_track track = {times,
                                 values + 12 * i,
                                 3,
                                 is_rotation ? 4 : 3,
                                 is_rotation ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS,
                                 NKW_INTERPOLATION_LINEAR,
                                 NULL};
        const nkw_clip_track c = {(nkw_clip_target)(i % 3), (uint32_t)(i / 3), track};
        tracks[i] = c;
        for (size_t k = 0; k < 3; k++)
            for (size_t n = 0; n < track.width; n++)
                values[12 * i + k * track.width + n] = is_rotation ? n == (k + i) % 4 : (float)(i + k * n);
    }
    for (int format = 0; format < 2; format++) {
        nkw_clip_source source = {tracks, COUNT, MANY, 0, {NULL, 0}, NULL, (nkw_clip_format)format, NULL};
        const nkw_track_span memory = {work_times, work_values, NULL, 3};
        size_t bytes;
        nkw_clip *clip = clip_build(&source, &bytes);
        memset(seen, 0, COUNT);
        assert_int_equal(nkw_clip_describe(clip).track_count, COUNT);
        for (size_t i = 0; i < COUNT; i++) {
            nkw_clip_track got;
            assert_int_equal(nkw_clip_track_get(clip, i, memory, &got, work), NKW_OK);
            const size_t at = 3 * (size_t)got.index + (size_t)got.target;
            if (at >= COUNT || seen[at])
                fail();
            seen[at] = 1;
            if (format == NKW_CLIP_FLOAT32)
                expect_floats_bits(got.track.values, values + 12 * at, 3 * got.track.width);
        }
        free(clip);
    }
    free(values), free(work.data), free(tracks), free(seen);
}

/* The indices of tracks in a block are checked: a list has as many as its count says. */
static void damaged_indices_of_tracks_are_refused(void **state)
{
    (void)state;
    random_source r = random_from(27);
    static random_clip c;
    static float times[RANDOM_CLIP_KEYS], values[12 * RANDOM_CLIP_KEYS];
    NKW_STACK_WORK(work, NKW_CLIP_TRACK_GET_WORK(9, RANDOM_CLIP_FLOATS));
    const nkw_work none = {NULL, 0};
    const nkw_track_span nowhere = {NULL, NULL, NULL, 0};
    static unsigned char modes[RANDOM_CLIP_KEYS];
    size_t bytes, refused = 0;
    draw(&r, 9, 2, &c);
    nkw_clip *whole = clip_build(&c.source, &bytes), *damaged = (nkw_clip *)malloc(bytes);
    uint32_t *words = (uint32_t *)(void *)damaged;
    assert_non_null(words);
    memcpy(words, whole, bytes);
    for (size_t i = 0; i < bytes / 4; i++)
        for (int bit = 0; bit < 32; bit += 5) {
            const nkw_track_span memory = {times, values, modes, RANDOM_CLIP_KEYS};
            const nkw_clip *clip;
            words[i] ^= 1u << bit;
            if (nkw_clip_open(words, bytes, &clip) != NKW_OK)
                refused++;
            const nkw_clip_description d = nkw_clip_describe(clip ? clip : whole);
            for (size_t k = 0; clip && k <= d.track_count && d.joint_count == 9; k++) {
                nkw_clip_track got;
                nkw_result shape = nkw_clip_track_get(clip, k, nowhere, &got, none);
                assert_true(shape == NKW_OUT_OF_RANGE || (shape == NKW_TOO_SMALL && k < d.track_count));
                nkw_clip_track_get(clip, k, memory, &got, work);
            }
            words[i] ^= 1u << bit;
        }
    assert_true(refused > 100);
    free(damaged), free(whole);
}

static void names_come_back(void **state)
{
    (void)state;
    const char *const joints[3] = {"hips", NULL, "左手"};
    const char *const floats[2] = {"smile", NULL};
    const nkw_clip_names names = {"walk", joints, floats}, only = {NULL, joints, NULL}, own = {"run", NULL, NULL};
    const nkw_clip_names of_floats = {NULL, NULL, floats};
    nkw_clip_source source = {NULL, 0, 3, 2, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, &names};
    size_t bytes;
    nkw_clip *clip = clip_build(&source, &bytes);
    assert_string_equal(nkw_clip_describe(clip).name, "walk");
    assert_string_equal(nkw_clip_joint_name(clip, 0), "hips");
    assert_string_equal(nkw_clip_joint_name(clip, 1), "");
    assert_string_equal(nkw_clip_joint_name(clip, 2), "左手");
    assert_string_equal(nkw_clip_joint_name(clip, 3), "");
    assert_string_equal(nkw_clip_float_name(clip, 0), "smile");
    assert_string_equal(nkw_clip_float_name(clip, 1), "");
    assert_string_equal(nkw_clip_float_name(clip, 2), "");
    free(clip);
    source.names = &of_floats;
    clip = clip_build(&source, &bytes);
    assert_string_equal(nkw_clip_joint_name(clip, 0), "");
    assert_string_equal(nkw_clip_float_name(clip, 0), "smile");
    free(clip);
    source.names = &only;
    clip = clip_build(&source, &bytes);
    assert_string_equal(nkw_clip_describe(clip).name, "");
    assert_string_equal(nkw_clip_joint_name(clip, 2), "左手");
    assert_string_equal(nkw_clip_float_name(clip, 0), "");
    free(clip);
    source.names = &own;
    clip = clip_build(&source, &bytes);
    assert_string_equal(nkw_clip_describe(clip).name, "run");
    assert_string_equal(nkw_clip_joint_name(clip, 2), "");
    free(clip);
    source.names = NULL;
    clip = clip_build(&source, &bytes);
    assert_string_equal(nkw_clip_describe(clip).name, "");
    assert_string_equal(nkw_clip_joint_name(clip, SIZE_MAX), "");
    assert_string_equal(nkw_clip_float_name(clip, SIZE_MAX), "");
    free(clip);
}

static void too_little_memory_and_wrong_indices_are_refused(void **state)
{
    (void)state;
    random_source r = random_from(23);
    static random_clip c;
    static float times[RANDOM_CLIP_KEYS], values[12 * RANDOM_CLIP_KEYS];
    NKW_STACK_WORK(work, NKW_CLIP_TRACK_GET_WORK(8, 0));
    const nkw_work small = {work.data, work.bytes - 1}, none = {NULL, 0};
    const nkw_track_span nowhere = {NULL, NULL, NULL, 0};
    const nkw_work misaligned = {(unsigned char *)work.data + 4, work.bytes};
    size_t bytes;
    draw(&r, 8, 4, &c);
    nkw_clip *clip = clip_build(&c.source, &bytes);
    nkw_clip_track out, shape;
    nkw_track_span memory = {times, values, NULL, RANDOM_CLIP_KEYS};
    size_t count = nkw_clip_describe(clip).track_count;
    unsigned char modes[RANDOM_CLIP_KEYS];
    assert_int_equal(nkw_clip_track_get(clip, count, nowhere, &shape, none), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_clip_track_get(clip, SIZE_MAX, nowhere, &shape, none), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_clip_track_get(clip, count, memory, &out, work), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_clip_track_get(clip, 0, memory, &out, work), NKW_TOO_SMALL);
    memory.key_interpolation = modes;
    assert_int_equal(nkw_clip_track_get(clip, 0, memory, &out, small), NKW_TOO_SMALL);
    assert_int_equal(nkw_clip_track_get(clip, 0, memory, &out, misaligned), NKW_TOO_SMALL);
    assert_null(out.track.values);
    memory.key_capacity--;
    assert_int_equal(nkw_clip_track_get(clip, 0, memory, &out, work), NKW_TOO_SMALL);
    memory.key_capacity++;
    assert_int_equal(nkw_clip_track_get(clip, 0, memory, &out, work), NKW_OK);
    free(clip);
}

static uint32_t swapped(uint32_t w)
{
    return w >> 24 | (w >> 8 & 0xff00u) | (w << 8 & 0xff0000u) | w << 24;
}

/* Conversions of whole clips are in test_clip_convert.c. */
static void a_block_of_this_byte_order_is_copied_whatever_its_alignment(void **state)
{
    (void)state;
    random_source r = random_from(24);
    static random_clip c;
    size_t bytes;
    draw(&r, 9, 2, &c);
    nkw_clip *block = clip_build(&c.source, &bytes);
    unsigned char *odd = (unsigned char *)malloc(bytes + 1);
    uint32_t *out = (uint32_t *)malloc(bytes);
    assert_true(odd && out);
    memcpy(odd + 1, block, bytes);
    const nkw_clip *clip;
    assert_int_equal(nkw_clip_convert(odd + 1, bytes, out, &clip), NKW_OK);
    assert_ptr_equal(clip, out);
    assert_memory_equal(out, block, bytes);
    assert_int_equal(nkw_clip_convert(out, bytes, odd + 1, &clip), NKW_NOT_A_CLIP);
    assert_null(clip);
    assert_int_equal(nkw_clip_convert(out, 8, out, &clip), NKW_TOO_SMALL);
    out[0] = swapped(out[0]); /* says to be of the other order, which the rest is not */
    assert_int_not_equal(nkw_clip_convert(out, bytes, out, &clip), NKW_OK);
    assert_null(clip);
    free(odd);
    free(out);
    free(block);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_clip_of_its_own_tracks_returns_the_same_samples),
        cmocka_unit_test(the_keys_of_compact_clips_are_their_samples),
        cmocka_unit_test(moving_tracks_are_listed_once_and_constant_ones_are_not),
        cmocka_unit_test(half_turns_keep_their_direction),
        cmocka_unit_test(rebuilt_clips_of_other_formats_differ_by_rounding),
        cmocka_unit_test(a_compact_clip_is_never_larger_than_one_of_floats),
        cmocka_unit_test(all_tracks_of_thousands_of_joints_are_taken_out),
        cmocka_unit_test(damaged_indices_of_tracks_are_refused),
        cmocka_unit_test(names_come_back),
        cmocka_unit_test(too_little_memory_and_wrong_indices_are_refused),
        cmocka_unit_test(a_block_of_this_byte_order_is_copied_whatever_its_alignment),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
