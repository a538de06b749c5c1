/* SPDX-License-Identifier: MIT */
/* The mixer: restored states, steps of any size, fades, groups, layers, the direct calls. */
#include <math.h>
#include <stdlib.h>

#include "mixer_scene.h"
#include "support/clips.h"
#include "support/expect.h"

static mixer_scene scene, other;

static size_t play(mixer_scene *s, const nkw_mixer_options *options)
{
    size_t slot = 99;
    assert_int_equal(nkw_mixer_play(&s->mixer, &s->set, options, &slot), NKW_OK);
    return slot;
}

static void advance(mixer_scene *s, double seconds)
{
    assert_int_equal(mixer_scene_advance(s, seconds), NKW_OK);
}

static void draw(uint64_t seed, uint32_t root_parts)
{
    random_source r = random_from(seed);
    mixer_scene_draw(&scene, &r, root_parts);
    assert_int_equal(nkw_mixer_set_validate(&scene.set, NULL), NKW_OK);
}

/* The sample of a clip of the scene. */
static void sample(uint32_t clip, float time, float *pose, float *floats)
{
    assert_int_equal(nkw_clip_sample(scene.clips[clip].clip, time, NULL, pose_span(pose, MIXER_JOINTS), floats),
                     NKW_OK);
}

/* ---- The state ---- */

/* The arrays of poses in use: padding has no meaning. */
static void expect_same_rows(const float *a, const float *b, size_t rows)
{
    for (size_t c = 0; c < rows; c++)
        expect_floats_bits(a + c * NKW_POSE_STRIDE(MIXER_JOINTS), b + c * NKW_POSE_STRIDE(MIXER_JOINTS), MIXER_JOINTS);
}

/* If each frame after a restore, and the state after it, are the same, all later ones are. */
static void a_restored_state_repeats_every_bit(void **state)
{
    (void)state;
    random_source r = random_from(61);
    size_t busy = 0, transitions = 0, events = 0;
    draw(60, 7);
    for (int frame = 0; frame < 10000; frame++) {
        mixer_scene_act(&scene, &r);
        const nkw_mixer saved = scene.mixer;
        float poses[NKW_MIXER_POSES_FLOATS(MIXER_JOINTS)];
        memcpy(poses, scene.poses, sizeof poses);
        const double seconds = random_bits(&r) % 8 ? (double)random_unit(&r) / 16.0 : 0.0;
        advance(&scene, seconds);
        memcpy(&other, &scene, sizeof other);
        other.frame.pose = pose_span(other.pose, MIXER_JOINTS);
        other.frame.floats = other.floats;
        other.frame.poses = other.poses;
        other.frame.events = other.events;
        memset(other.memory, 0xff, sizeof other.memory); /* NaN */
        memset(other.pose, 0xff, sizeof other.pose);
        memcpy(&other.mixer, &saved, sizeof saved);
        memcpy(other.poses, poses, sizeof poses);
        advance(&other, seconds);
        assert_memory_equal(&other.mixer, &scene.mixer, sizeof saved);
        expect_same_pose(other.pose, scene.pose, MIXER_JOINTS);
        expect_same_rows(other.poses, scene.poses, 20);
        expect_floats_bits(other.floats, scene.floats, RANDOM_CLIP_FLOATS);
        assert_memory_equal(&other.frame.motion, &scene.frame.motion, sizeof other.frame.motion);
        assert_int_equal(other.frame.event_count, scene.frame.event_count);
        assert_int_equal(nkw_pose_validate(pose_view(scene.pose, MIXER_JOINTS), NULL), NKW_OK);
        for (size_t i = 0; i < NKW_MIXER_SLOTS; i++)
            busy += scene.mixer.slot[i].playing != 0;
        transitions += scene.mixer.transition != NKW_MIXER_CROSS_FADE;
        events += scene.frame.event_count;
    }
    assert_true(busy > 20000 && transitions > 1000 && events > 10000);
}

/* Each of the 10,000 steps has a random part of a second. The bounds are sums of roundings: 64 steps of 2^-53 of 8 s. */
static void a_step_of_a_second_is_as_many_smaller_ones(void **state)
{
    (void)state;
    random_source r = random_from(71);
    draw(70, 0);
    for (int round = 0; round < 300; round++) {
        memset(&scene.mixer, 0, sizeof scene.mixer);
        scene.frame.poses = NULL;
        for (int k = 0; k < 5; k++) {
            nkw_mixer_options o = mixer_scene_options(&r);
            o.transition = k % 2 ? NKW_MIXER_CROSS_FADE : NKW_MIXER_FADE_IN;
            scene.mixer.slot[play(&scene, &o)].speed = random_between(&r, -2.0f, 2.0f);
        }
        const nkw_mixer begin = scene.mixer;
        advance(&scene, 1.0);
        memcpy(&other.mixer, &scene.mixer, sizeof other.mixer);
        memcpy(other.pose, scene.pose, sizeof other.pose);
        scene.mixer = begin;
        for (int left = 1024; left > 0;) {
            const int part = 1 + (int)(random_bits(&r) % 64);
            advance(&scene, (double)(part < left ? part : left) / 1024.0);
            left -= part;
        }
        for (size_t i = 0; i < NKW_MIXER_SLOTS; i++) {
            const nkw_mixer_slot *a = &other.mixer.slot[i], *b = &scene.mixer.slot[i];
            assert_int_equal(a->playing, b->playing);
            expect_near(b->time, a->time, 1e-12);
            expect_near(b->fade.elapsed, a->fade.elapsed, 1e-13);
        }
        for (size_t j = 0; j < MIXER_JOINTS; j++) {
            const nkw_trs a = nkw_pose_get(pose_view(other.pose, MIXER_JOINTS), j);
            const nkw_trs b = nkw_pose_get(pose_view(scene.pose, MIXER_JOINTS), j);
            expect_vec3_near(b.translation, a.translation, 1e-4);
            expect_rotation_near(b.rotation, a.rotation, 1e-4);
        }
    }
}

/* ---- Fades ---- */

static double weight_of(const nkw_mixer_slot *s)
{
    const nkw_mixer_fade *f = &s->fade;
    return f->elapsed < f->duration ? f->from + (f->to - f->from) * (f->elapsed / f->duration) : f->to;
}

static void weights_of_cross_fades_sum_to_one(void **state)
{
    (void)state;
    random_source r = random_from(81);
    nkw_mixer_options o = {0};
    draw(80, 0);
    play(&scene, &o);
    size_t most = 0;
    for (int frame = 0; frame < 4000; frame++) {
        o.clip = (uint32_t)(random_bits(&r) % MIXER_CLIPS);
        o.fade = random_unit(&r);
        if (random_bits(&r) % 16 == 0)
            nkw_mixer_play(&scene.mixer, &scene.set, &o, NULL);
        advance(&scene, (double)random_unit(&r) / 32.0);
        double sum = 0.0;
        size_t count = 0;
        for (size_t i = 0; i < NKW_MIXER_SLOTS; i++)
            if (scene.mixer.slot[i].playing) {
                sum += weight_of(&scene.mixer.slot[i]);
                count++;
            }
        expect_near(sum, 1.0, 1e-6);
        most = count > most ? count : most;
    }
    assert_true(most >= 4);
}

static void a_slot_that_has_faded_out_is_free(void **state)
{
    (void)state;
    draw(82, 0);
    nkw_mixer_options o = {0};
    const size_t a = play(&scene, &o);
    o.clip = 1;
    o.fade = 0.5f;
    const size_t b = play(&scene, &o);
    advance(&scene, 0.25);
    expect_near(weight_of(&scene.mixer.slot[a]), 0.5, 0.0);
    expect_near(weight_of(&scene.mixer.slot[b]), 0.5, 0.0);
    advance(&scene, 0.25);
    assert_int_equal(scene.mixer.slot[a].playing, 0);
    expect_near(weight_of(&scene.mixer.slot[b]), 1.0, 0.0);
    assert_int_equal(nkw_mixer_stop(&scene.mixer, b, 0.0f), NKW_OK);
    advance(&scene, 0.0);
    const nkw_mixer_slot none = {0};
    assert_memory_equal(&scene.mixer.slot[b], &none, sizeof none);
    expect_same_pose(scene.pose, scene.rest, MIXER_JOINTS);
    expect_floats_bits(scene.floats, scene.rest_floats, RANDOM_CLIP_FLOATS);
}

static void all_slots_may_play_and_one_more_is_refused(void **state)
{
    (void)state;
    draw(83, 0);
    nkw_mixer_options o = {0};
    size_t slot = 99;
    o.transition = NKW_MIXER_FADE_IN;
    for (size_t i = 0; i < NKW_MIXER_SLOTS; i++)
        assert_int_equal(play(&scene, &o), i);
    const nkw_mixer before = scene.mixer;
    assert_int_equal(nkw_mixer_play(&scene.mixer, &scene.set, &o, &slot), NKW_TOO_MANY);
    assert_int_equal(slot, 99);
    assert_memory_equal(&before, &scene.mixer, sizeof before);
    advance(&scene, 0.1);
}

/* ---- Groups ---- */

/* Lengths 0.375 and L, weights 1 - t and t: the rate is 1 / (0.375 + t (L - 0.375)); its integral over a second. */
static void a_group_advances_by_the_mean_of_its_lengths(void **state)
{
    (void)state;
    for (uint32_t sync = 0; sync < 2; sync++) {
        draw(90, 0);
        const double l = nkw_clip_describe(scene.clips[0].clip).end;
        nkw_mixer_options o = {.clip = 1, .group = 5, .mode = NKW_PLAYBACK_LOOP, .sync = (nkw_mixer_sync)sync};
        const size_t a = play(&scene, &o);
        o.clip = 0;
        o.fade = 1.0f;
        const size_t b = play(&scene, &o);
        advance(&scene, 0.5);
        const double half = log((0.375 + 0.5 * (l - 0.375)) / 0.375) / (l - 0.375);
        expect_near(scene.mixer.slot[a].time, 0.375 * half, 1e-12);
        expect_near(scene.mixer.slot[b].time, l * half, 1e-12);
        advance(&scene, 0.5);
        const double whole = log(l / 0.375) / (l - 0.375);
        assert_int_equal(scene.mixer.slot[a].playing, 0);
        expect_near(scene.mixer.slot[b].time, l * whole, 1e-12);
    }
}

/* Weights that change little, much and from or to 0, against the sum of many small parts (Simpson's rule). */
static void a_group_of_any_weights_is_integrated(void **state)
{
    (void)state;
    static const float fades[][4] = {{1.0f, 1.0f, 0.5f, 0.5f}, {1.0f, 0.9f, 0.2f, 0.25f}, {0.0f, 1.0f, 1.0f, 0.0f},
                                     {0.0f, 1.0f, 0.0f, 2.0f}, {1.0f, 0.0f, 3.0f, 1.0f},  {0.0f, 1.0f, 0.0f, 0.0f}};
    for (size_t f = 0; f < sizeof fades / sizeof *fades; f++) {
        const float *w = fades[f];
        draw(91, 0);
        const double l = nkw_clip_describe(scene.clips[0].clip).end;
        nkw_mixer_options o = {.clip = 1, .group = 1, .mode = NKW_PLAYBACK_LOOP, .transition = NKW_MIXER_FADE_IN};
        const size_t a = play(&scene, &o);
        o.clip = 0;
        const size_t b = play(&scene, &o);
        scene.mixer.slot[a].fade = (nkw_mixer_fade){0.0, 1.0, w[0], w[1]};
        scene.mixer.slot[b].fade = (nkw_mixer_fade){0.0, 1.0, w[2], w[3]};
        scene.mixer.slot[b].speed = 2.0f;
        double cycles = 0.0;
        for (int k = 0; k <= 20000; k++) {
            const double t = k / 20000.0 + (k == 0 ? 1e-9 : k == 20000 ? -1e-9 : 0.0);
            const double wa = w[0] + (w[1] - w[0]) * t, wb = w[2] + (w[3] - w[2]) * t;
            const double simpson = k == 0 || k == 20000 ? 1.0 : k % 2 ? 4.0 : 2.0;
            cycles += simpson * (wa + 2.0 * wb) / (wa * 0.375 + wb * l) / 60000.0;
        }
        advance(&scene, 1.0);
        if (scene.mixer.slot[a].playing)
            expect_near(scene.mixer.slot[a].time, 0.375 * cycles, 1e-9);
        if (scene.mixer.slot[b].playing)
            expect_near(scene.mixer.slot[b].time, l * cycles, 1e-9);
    }
}

static void phases_and_markers_agree_with_the_leader(void **state)
{
    (void)state;
    random_source r = random_from(92);
    draw(92, 0);
    const double l = nkw_clip_describe(scene.clips[0].clip).end;
    nkw_mixer_options o = {.clip = 0, .group = 2, .mode = NKW_PLAYBACK_LOOP, .transition = NKW_MIXER_FADE_IN};
    o.time = 0.5f;
    const size_t lead = play(&scene, &o);
    o.clip = 1;
    o.sync = NKW_MIXER_SYNC_PHASE;
    const size_t phase = play(&scene, &o);
    o.sync = NKW_MIXER_SYNC_MARKERS;
    const size_t marks = play(&scene, &o);
    for (int frame = 0; frame < 2000; frame++) {
        advance(&scene, frame ? (double)random_unit(&r) / 8.0 : 0.0);
        const double time = scene.mixer.slot[lead].time;
        expect_near(scene.mixer.slot[phase].time / 0.375, time / l, 1e-12 * (1.0 + time));
        /* The times of the markers, measured in cycles of each clip from its first marker on. */
        const double a0 = scene.markers[0][0], a1 = scene.markers[0][1];
        const double b0 = (double)scene.markers[1][0] - 0.25, b1 = (double)scene.markers[1][1] - 0.25;
        const double x = (time - a0) / l - floor((time - a0) / l), split = (a1 - a0) / l;
        const double y = (scene.mixer.slot[marks].time - b0) / 0.375;
        const double own = (b1 - b0) / 0.375, fraction = y - floor(y);
        const double want = x < split ? x / split * own : own + (x - split) / (1.0 - split) * (1.0 - own);
        if (want > 1e-9 && want < 1.0 - 1e-9)
            expect_near(fraction, want, 1e-10);
    }
}

/* ---- The direct calls ---- */

static void one_slot_is_the_clip_bit_for_bit(void **state)
{
    (void)state;
    random_source r = random_from(101);
    float pose[MIXER_POSE], floats[RANDOM_CLIP_FLOATS];
    for (uint32_t mode = 0; mode < 3; mode++) {
        draw(100, 0);
        nkw_mixer_options o = {.clip = 1, .mode = (nkw_playback)mode};
        const size_t slot = play(&scene, &o);
        for (int frame = 0; frame < 200; frame++) {
            advance(&scene, (double)random_unit(&r) / 8.0);
            const nkw_playback_range range = {
                .duration = 0.375, .before = (nkw_playback)mode, .after = (nkw_playback)mode};
            const double time = 0.25 + nkw_playback_head_f64(&range, scene.mixer.slot[slot].time).time;
            sample(1, (float)time, pose, floats);
            expect_same_pose(scene.pose, pose, MIXER_JOINTS);
            expect_floats_bits(scene.floats, floats, RANDOM_CLIP_FLOATS);
        }
    }
}

static void two_slots_are_a_blend_bit_for_bit(void **state)
{
    (void)state;
    float a[MIXER_POSE], b[MIXER_POSE], fa[RANDOM_CLIP_FLOATS], fb[RANDOM_CLIP_FLOATS];
    const nkw_mask_view none = {NULL, MIXER_JOINTS};
    draw(102, 0);
    nkw_mixer_options o = {0};
    play(&scene, &o);
    o.clip = 2;
    o.fade = 1.0f;
    play(&scene, &o);
    for (int frame = 1; frame < 64; frame++) {
        const float t = (float)frame / 64.0f;
        advance(&scene, 1.0 / 64.0);
        sample(0, t, a, fa);
        sample(2, t, b, fb);
        float want[MIXER_POSE];
        if (frame < 32)
            nkw_pose_blend(pose_view(a, MIXER_JOINTS), pose_view(b, MIXER_JOINTS), t, none,
                           pose_span(want, MIXER_JOINTS));
        else
            nkw_pose_blend(pose_view(b, MIXER_JOINTS), pose_view(a, MIXER_JOINTS), 1.0f - t, none,
                           pose_span(want, MIXER_JOINTS));
        if (frame != 32)
            expect_same_pose(scene.pose, want, MIXER_JOINTS);
        for (size_t i = 0; i < RANDOM_CLIP_FLOATS; i++)
            expect_bits(scene.floats[i], nkw_lerp(fa[i], fb[i], t));
    }
}

static void layers_masks_and_added_slots_are_the_direct_calls(void **state)
{
    (void)state;
    float base[MIXER_POSE], top[MIXER_POSE], add[MIXER_POSE], start[MIXER_POSE];
    float fb[RANDOM_CLIP_FLOATS], ft[RANDOM_CLIP_FLOATS], fa[RANDOM_CLIP_FLOATS], fs[RANDOM_CLIP_FLOATS];
    draw(103, 0);
    nkw_mixer_options o = {0};
    play(&scene, &o);
    o.clip = 2;
    o.layer = 4;
    o.mask = 1;
    scene.mixer.slot[play(&scene, &o)].weight = 0.75f;
    o.clip = 1;
    o.blend = NKW_MIXER_ADD;
    scene.mixer.slot[play(&scene, &o)].weight = 1.25f;
    advance(&scene, 0.125);
    sample(0, 0.125f, base, fb);
    sample(2, 0.125f, top, ft);
    sample(1, 0.375f, add, fa);
    sample(1, 0.25f, start, fs);
    const nkw_mask_view mask = mask_view(scene.mask, MIXER_JOINTS);
    const nkw_pose_layer layer = {pose_view(top, MIXER_JOINTS), 0.75f, mask};
    const nkw_pose_span out = pose_span(base, MIXER_JOINTS), delta = pose_span(add, MIXER_JOINTS);
    nkw_pose_layers_blend(&layer, 1, pose_view(base, MIXER_JOINTS), 1.0f - 0x1p-20f, out);
    nkw_pose_additive_build(pose_view(add, MIXER_JOINTS), pose_view(start, MIXER_JOINTS), NKW_ADDITIVE_LOCAL, delta);
    nkw_pose_additive_apply(pose_view(base, MIXER_JOINTS), pose_view(add, MIXER_JOINTS), 1.25f, mask,
                            NKW_ADDITIVE_LOCAL, out);
    expect_same_pose(scene.pose, base, MIXER_JOINTS);
    for (size_t i = 0; i < RANDOM_CLIP_FLOATS; i++)
        expect_near(scene.floats[i], fb[i] + (ft[i] - fb[i]) * 0.75f + 1.25f * (fa[i] - fs[i]), 1e-5);
    scene.clips[1].reference = pose_view(scene.rest, MIXER_JOINTS);
    advance(&scene, 0.0);
    sample(1, 0.375f, add, fa);
    sample(0, 0.125f, base, fb);
    nkw_pose_layers_blend(&layer, 1, pose_view(base, MIXER_JOINTS), 1.0f - 0x1p-20f, out);
    nkw_pose_additive_build(pose_view(add, MIXER_JOINTS), scene.set.rest, NKW_ADDITIVE_LOCAL, delta);
    nkw_pose_additive_apply(pose_view(base, MIXER_JOINTS), pose_view(add, MIXER_JOINTS), 1.25f, mask,
                            NKW_ADDITIVE_LOCAL, out);
    expect_same_pose(scene.pose, base, MIXER_JOINTS);
}

/* ---- Transitions of the pose ---- */

/* Keys are at least 0.01 s apart and at most 6 units or half a turn: in 1e-6 s poses move by less than 1e-3. */

static void transitions_begin_at_the_shown_pose_and_end_at_the_clip(void **state)
{
    (void)state;
    for (uint32_t kind = NKW_MIXER_INERTIA; kind <= NKW_MIXER_DEAD_BLEND; kind++) {
        draw(110, 0);
        nkw_mixer_options o = {.mode = NKW_PLAYBACK_LOOP};
        float shown[MIXER_POSE], pose[MIXER_POSE], floats[RANDOM_CLIP_FLOATS];
        const size_t a = play(&scene, &o);
        for (int frame = 0; frame < 20; frame++)
            advance(&scene, 1.0 / 64.0);
        memcpy(shown, scene.pose, sizeof shown);
        o.clip = 2;
        o.fade = 0.25f;
        o.transition = (nkw_mixer_transition)kind;
        const size_t b = play(&scene, &o);
        advance(&scene, 1e-6);
        assert_int_equal(scene.mixer.slot[a].playing, 0);
        for (size_t j = 0; j < MIXER_JOINTS; j++) {
            const nkw_trs x = nkw_pose_get(pose_view(shown, MIXER_JOINTS), j);
            const nkw_trs y = nkw_pose_get(pose_view(scene.pose, MIXER_JOINTS), j);
            expect_vec3_near(y.translation, x.translation, 1e-3);
            expect_rotation_near(y.rotation, x.rotation, 1e-3);
        }
        advance(&scene, 0.125);
        sample(2, (float)scene.mixer.slot[b].time, pose, floats);
        assert_memory_not_equal(pose, scene.pose, sizeof(float) * MIXER_JOINTS);
        advance(&scene, 0.125);
        sample(2, (float)scene.mixer.slot[b].time, pose, floats);
        expect_same_pose(scene.pose, pose, MIXER_JOINTS);
        assert_int_equal(scene.mixer.transition, NKW_MIXER_CROSS_FADE);
    }
}

/* The calls of transition.h by hand. */
static void inertia_is_that_of_poses_bit_for_bit(void **state)
{
    (void)state;
    float p[4][MIXER_POSE], floats[RANDOM_CLIP_FLOATS], v[2][NKW_POSE_VELOCITY_FLOATS(MIXER_JOINTS)];
    float offsets[NKW_POSE_INERTIA_FLOATS(MIXER_JOINTS)];
    draw(111, 0);
    nkw_mixer_options o = {0};
    play(&scene, &o);
    advance(&scene, 0.125);
    advance(&scene, 0.0625);
    o.clip = 2;
    o.fade = 0.5f;
    o.transition = NKW_MIXER_INERTIA;
    play(&scene, &o);
    advance(&scene, 0.03125);
    sample(0, 0.125f, p[0], floats);
    sample(0, 0.1875f, p[1], floats);
    sample(2, 0.0f, p[2], floats);
    sample(2, 0.03125f, p[3], floats);
    const nkw_pose_velocity_span va = {v[0], MIXER_JOINTS}, vb = {v[1], MIXER_JOINTS};
    nkw_pose_velocity_from_poses(pose_view(p[0], MIXER_JOINTS), pose_view(p[1], MIXER_JOINTS), 0.0625f, va);
    nkw_pose_velocity_from_poses(pose_view(p[2], MIXER_JOINTS), pose_view(p[3], MIXER_JOINTS), 0.03125f, vb);
    const nkw_pose_state from = {pose_view(p[1], MIXER_JOINTS), NKW_VIEW(nkw_pose_velocity, va)};
    const nkw_pose_state to = {pose_view(p[2], MIXER_JOINTS), NKW_VIEW(nkw_pose_velocity, vb)};
    const nkw_pose_inertia inertia = {offsets, MIXER_JOINTS};
    nkw_pose_inertia_begin(inertia, &from, &to, 0.5f);
    nkw_pose_inertia_evaluate(inertia, pose_view(p[3], MIXER_JOINTS), 0.03125f, pose_span(p[0], MIXER_JOINTS));
    expect_same_pose(scene.pose, p[0], MIXER_JOINTS);
}

/* ---- Faults ---- */

static void wrong_arguments_change_nothing(void **state)
{
    (void)state;
    draw(120, 0);
    nkw_mixer_options good = {0};
    play(&scene, &good);
    const nkw_mixer before = scene.mixer;
    static const struct {
        nkw_mixer_options options;
        nkw_result result;
    } faults[] = {
        {{.clip = MIXER_CLIPS}, NKW_OUT_OF_RANGE},
        {{.mask = 2}, NKW_OUT_OF_RANGE},
        {{.fade = -1.0f}, NKW_OUT_OF_RANGE},
        {{.mode = (nkw_playback)3}, NKW_BAD_METHOD},
        {{.blend = (nkw_mixer_blend)2}, NKW_BAD_METHOD},
        {{.sync = (nkw_mixer_sync)3}, NKW_BAD_METHOD},
        {{.transition = (nkw_mixer_transition)4}, NKW_BAD_METHOD},
        {{.fade = NAN}, NKW_NOT_FINITE},
        {{.time = INFINITY}, NKW_NOT_FINITE},
    };
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++)
        assert_int_equal(nkw_mixer_play(&scene.mixer, &scene.set, &faults[i].options, NULL), faults[i].result);
    assert_int_equal(nkw_mixer_stop(&scene.mixer, 1, 0.0f), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_mixer_stop(&scene.mixer, NKW_MIXER_SLOTS, 0.0f), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_mixer_stop(&scene.mixer, 0, -1.0f), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_mixer_stop(&scene.mixer, 0, NAN), NKW_NOT_FINITE);
    assert_int_equal(mixer_scene_advance(&scene, (double)NAN), NKW_NOT_FINITE);
    assert_int_equal(mixer_scene_advance(&scene, -0.5), NKW_OUT_OF_RANGE);
    assert_int_equal(mixer_scene_advance(&scene, 0x1p31), NKW_OUT_OF_RANGE);
    const nkw_work less = {mixer_scene_work(&scene).data, NKW_MIXER_WORK(1, MIXER_JOINTS, RANDOM_CLIP_FLOATS) - 1};
    assert_int_equal(nkw_mixer_advance(&scene.mixer, &scene.set, 0.1, &scene.frame, less), NKW_TOO_SMALL);
    scene.set.root_parts = NKW_ROOT_PLANE;
    scene.set.root = MIXER_JOINTS;
    assert_int_equal(mixer_scene_advance(&scene, 0.1), NKW_OUT_OF_RANGE);
    assert_int_equal(nkw_mixer_set_validate(&scene.set, NULL), NKW_OUT_OF_RANGE);
    scene.set.rest.data = NULL;
    assert_int_equal(mixer_scene_advance(&scene, 0.1), NKW_EMPTY);
    scene.frame.pose.joint_count = 3;
    assert_int_equal(mixer_scene_advance(&scene, 0.1), NKW_MISMATCHED);
    assert_memory_equal(&before, &scene.mixer, sizeof before);
}

static void a_transition_of_poses_needs_their_memory(void **state)
{
    (void)state;
    draw(121, 0);
    nkw_mixer_options o = {.transition = NKW_MIXER_INERTIA, .fade = 1.0f};
    play(&scene, &o);
    scene.frame.poses = NULL;
    assert_int_equal(mixer_scene_advance(&scene, 0.1), NKW_TOO_SMALL);
    scene.frame.poses = scene.poses;
    advance(&scene, 0.1);
}

static void weights_and_speeds_of_any_value_are_defined(void **state)
{
    (void)state;
    static const float weights[] = {NAN, -1.0f, 0.0f, -INFINITY}, speeds[] = {NAN, INFINITY, -INFINITY};
    draw(122, 0);
    nkw_mixer_options o = {0};
    const size_t slot = play(&scene, &o);
    for (size_t i = 0; i < 4; i++) {
        scene.mixer.slot[slot].weight = weights[i];
        advance(&scene, 0.1);
        expect_same_pose(scene.pose, scene.rest, MIXER_JOINTS);
    }
    const double time = scene.mixer.slot[slot].time;
    for (size_t i = 0; i < 3; i++) {
        scene.mixer.slot[slot].speed = speeds[i];
        scene.mixer.slot[slot].weight = INFINITY;
        advance(&scene, 0.1);
        assert_true(scene.mixer.slot[slot].time == time);
        assert_int_equal(nkw_pose_validate(pose_view(scene.pose, MIXER_JOINTS), NULL), NKW_OK);
    }
}

static void validate_names_the_first_offender(void **state)
{
    (void)state;
    draw(123, 0);
    size_t bad = 99;
    nkw_mixer_options o = {0};
    const size_t slot = play(&scene, &o);
    nkw_mixer m = scene.mixer;
    assert_int_equal(nkw_mixer_validate(&m, &scene.set, &bad), NKW_OK);
    m.slot[slot + 1] = m.slot[slot];
    m.slot[slot + 1].clip = MIXER_CLIPS;
    m.slot_count = 2;
    assert_int_equal(nkw_mixer_validate(&m, &scene.set, &bad), NKW_OUT_OF_RANGE);
    assert_int_equal(bad, slot + 1);
    m.slot[slot].time = (double)NAN;
    assert_int_equal(nkw_mixer_validate(&m, &scene.set, &bad), NKW_NOT_FINITE);
    assert_int_equal(bad, slot);
    m.transition = (nkw_mixer_transition)9;
    assert_int_equal(nkw_mixer_validate(&m, &scene.set, &bad), NKW_BAD_METHOD);
    scene.markers[2][1] = 99.0f;
    assert_int_equal(nkw_mixer_set_validate(&scene.set, &bad), NKW_OUT_OF_RANGE);
    assert_int_equal(bad, 2);
    scene.markers[2][1] = 0.0f;
    assert_int_equal(nkw_mixer_set_validate(&scene.set, &bad), NKW_NOT_ASCENDING);
    scene.marks[1][0].duration = -1.0f;
    assert_int_equal(nkw_mixer_set_validate(&scene.set, &bad), NKW_OUT_OF_RANGE);
    assert_int_equal(bad, 1);
    scene.clips[1].end = 0.125f;
    assert_int_equal(nkw_mixer_set_validate(&scene.set, &bad), NKW_OUT_OF_RANGE);
    scene.set.float_count = 3;
    assert_int_equal(nkw_mixer_set_validate(&scene.set, &bad), NKW_MISMATCHED);
    assert_int_equal(bad, 0);
    scene.clips[0].clip = NULL;
    assert_int_equal(nkw_mixer_set_validate(&scene.set, &bad), NKW_EMPTY);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_restored_state_repeats_every_bit),
        cmocka_unit_test(a_step_of_a_second_is_as_many_smaller_ones),
        cmocka_unit_test(weights_of_cross_fades_sum_to_one),
        cmocka_unit_test(a_slot_that_has_faded_out_is_free),
        cmocka_unit_test(all_slots_may_play_and_one_more_is_refused),
        cmocka_unit_test(a_group_advances_by_the_mean_of_its_lengths),
        cmocka_unit_test(a_group_of_any_weights_is_integrated),
        cmocka_unit_test(phases_and_markers_agree_with_the_leader),
        cmocka_unit_test(one_slot_is_the_clip_bit_for_bit),
        cmocka_unit_test(two_slots_are_a_blend_bit_for_bit),
        cmocka_unit_test(layers_masks_and_added_slots_are_the_direct_calls),
        cmocka_unit_test(transitions_begin_at_the_shown_pose_and_end_at_the_clip),
        cmocka_unit_test(inertia_is_that_of_poses_bit_for_bit),
        cmocka_unit_test(wrong_arguments_change_nothing),
        cmocka_unit_test(a_transition_of_poses_needs_their_memory),
        cmocka_unit_test(weights_and_speeds_of_any_value_are_defined),
        cmocka_unit_test(validate_names_the_first_offender),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
