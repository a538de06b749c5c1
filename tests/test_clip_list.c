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
    static float work[NKW_CLIP_TRACK_WORK(RANDOM_CLIP_JOINTS, RANDOM_CLIP_FLOATS)];
    const size_t joints = nkw_clip_joint_count(clip), count = nkw_clip_track_count(clip);
    nkw_clip_source source = {t->tracks,         count,     joints,           nkw_clip_float_count(clip),
                              {t->rest, joints}, t->floats, NKW_CLIP_FLOAT32, NULL};
    assert_true(count <= TRACKS);
    for (size_t i = 0; i < count; i++) {
        nkw_edit_memory memory = {t->times[i], t->values[i], t->modes[i], RANDOM_CLIP_KEYS};
        nkw_clip_track shape;
        size_t floats = NKW_CLIP_TRACK_WORK(joints, nkw_clip_float_count(clip));
        assert_int_equal(nkw_clip_track_shape(clip, i, &shape), NKW_OK);
        assert_null(shape.track.values);
        assert_int_equal(nkw_clip_track_get(clip, i, &memory, &t->tracks[i], work, floats), NKW_OK);
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
        expect_floats_bits(x, y, nkw_clip_float_count(want));
    }
}

static void a_clip_of_its_own_tracks_returns_the_same_samples(void **state)
{
    (void)state;
    random_source r = random_from(21);
    static random_clip c;
    static taken t;
    static uint32_t work[NKW_CLIP_WORK(TRACKS)];
    for (int i = 0; i < 40; i++) {
        size_t bytes;
        draw(&r, 1 + random_bits(&r) % RANDOM_CLIP_JOINTS, i % 5, &c);
        nkw_clip *clip = clip_build(&c.source, work, &bytes);
        take(clip, &t);
        nkw_clip *again = clip_build(&t.source, work, &bytes);
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
    static uint32_t work[NKW_CLIP_WORK(TRACKS)];
    for (int i = 0; i < 10; i++) {
        float pose[NKW_POSE_FLOATS(17)], floats[RANDOM_CLIP_FLOATS];
        size_t bytes;
        draw(&r, 17, i % 3, &c);
        c.source.format = NKW_CLIP_UNORM16;
        nkw_clip *clip = clip_build(&c.source, work, &bytes);
        take(clip, &t);
        for (size_t k = 0; k < t.source.track_count; k++) {
            const nkw_clip_track *track = &t.tracks[k];
            size_t key = random_bits(&r) % track->track.count;
            while (key + 1 < track->track.count && track->track.times[key + 1] == track->track.times[key])
                key++;
            nkw_clip_sample(clip, track->track.times[key], NULL, pose_span(pose, 17), floats);
            float want[4], *out = floats + track->index;
            nkw_trs trs = nkw_pose_get(pose_view(pose, 17), track->target == NKW_CLIP_FLOATS ? 0 : track->index);
            nkw_track_sample(&track->track, track->track.times[key], want);
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
    static uint32_t work[NKW_CLIP_WORK(12)];
    nkw_clip_source source = {tracks, 12, 13, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
    for (int format = 0; format < 2; format++) {
        size_t bytes, seen = 0;
        source.format = (nkw_clip_format)format;
        nkw_clip *clip = clip_build(&source, work, &bytes);
        assert_int_equal(nkw_clip_track_count(clip), 9);
        for (size_t i = 0; i < 9; i++) {
            nkw_clip_track shape;
            assert_int_equal(nkw_clip_track_shape(clip, i, &shape), NKW_OK);
            assert_int_equal(shape.target, NKW_CLIP_TRANSLATION);
            assert_true(shape.index % 4 != 3 && shape.index < 12);
            seen |= (size_t)1 << shape.index;
        }
        assert_int_equal(seen, 0x777);
        free(clip);
    }
}

static void names_come_back(void **state)
{
    (void)state;
    const char *const joints[3] = {"hips", NULL, "左手"};
    const nkw_clip_names names = {"walk", joints}, only = {NULL, joints}, own = {"run", NULL};
    nkw_clip_source source = {NULL, 0, 3, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, &names};
    uint32_t work[1];
    size_t bytes;
    nkw_clip *clip = clip_build(&source, work, &bytes);
    assert_string_equal(nkw_clip_name(clip), "walk");
    assert_string_equal(nkw_clip_joint_name(clip, 0), "hips");
    assert_string_equal(nkw_clip_joint_name(clip, 1), "");
    assert_string_equal(nkw_clip_joint_name(clip, 2), "左手");
    assert_string_equal(nkw_clip_joint_name(clip, 3), "");
    free(clip);
    source.names = &only;
    clip = clip_build(&source, work, &bytes);
    assert_string_equal(nkw_clip_name(clip), "");
    assert_string_equal(nkw_clip_joint_name(clip, 2), "左手");
    free(clip);
    source.names = &own;
    clip = clip_build(&source, work, &bytes);
    assert_string_equal(nkw_clip_name(clip), "run");
    assert_string_equal(nkw_clip_joint_name(clip, 2), "");
    free(clip);
    source.names = NULL;
    clip = clip_build(&source, work, &bytes);
    assert_string_equal(nkw_clip_name(clip), "");
    assert_string_equal(nkw_clip_joint_name(clip, SIZE_MAX), "");
    free(clip);
}

static void too_little_memory_and_wrong_indices_are_refused(void **state)
{
    (void)state;
    random_source r = random_from(23);
    static random_clip c;
    static uint32_t order[NKW_CLIP_WORK(TRACKS)];
    static float times[RANDOM_CLIP_KEYS], values[12 * RANDOM_CLIP_KEYS];
    static float work[NKW_CLIP_TRACK_WORK(8, 0)];
    size_t bytes;
    draw(&r, 8, 4, &c);
    nkw_clip *clip = clip_build(&c.source, order, &bytes);
    nkw_clip_track out, shape;
    nkw_edit_memory memory = {times, values, NULL, RANDOM_CLIP_KEYS};
    size_t all = NKW_CLIP_TRACK_WORK(8, 0), count = nkw_clip_track_count(clip);
    unsigned char modes[RANDOM_CLIP_KEYS];
    assert_int_equal(nkw_clip_track_shape(clip, count, &shape), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_clip_track_shape(clip, SIZE_MAX, &shape), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_clip_track_get(clip, count, &memory, &out, work, all), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_clip_track_get(clip, 0, &memory, &out, work, all), NKW_TOO_SMALL);
    memory.key_interpolation = modes;
    assert_int_equal(nkw_clip_track_get(clip, 0, &memory, &out, work, all - 1), NKW_TOO_SMALL);
    memory.key_capacity--;
    assert_int_equal(nkw_clip_track_get(clip, 0, &memory, &out, work, all), NKW_TOO_SMALL);
    memory.key_capacity++;
    assert_int_equal(nkw_clip_track_get(clip, 0, &memory, &out, work, all), NKW_OK);
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
    static uint32_t order[NKW_CLIP_WORK(TRACKS)];
    size_t bytes;
    draw(&r, 9, 2, &c);
    nkw_clip *block = clip_build(&c.source, order, &bytes);
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
        cmocka_unit_test(names_come_back),
        cmocka_unit_test(too_little_memory_and_wrong_indices_are_refused),
        cmocka_unit_test(a_block_of_this_byte_order_is_copied_whatever_its_alignment),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
