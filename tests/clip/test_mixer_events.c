/* SPDX-License-Identifier: MIT */
/* Events and the motion of the root of a mixer, with clips whose positions are known. */
#include <math.h>

#include "random.h"
#include "support/clips.h"
#include "support/expect.h"

enum { TICKS = 64, EVENTS = 5, CAPACITY = 4000 };

/* A root that moves by `way` along z and turns by `angle` about y in a second. */
typedef struct walk {
    float times[2], positions[6], rotations[8];
    nkw_clip_track tracks[2];
    float block[512];
} walk;

typedef struct world {
    walk walks[2];
    nkw_mixer_clip clips[2];
    nkw_mixer_mark marks[EVENTS];
    nkw_mixer_set set;
    nkw_mixer mixer;
    float rest[NKW_POSE_FLOATS(1)], pose[NKW_POSE_FLOATS(1)];
    nkw_mixer_event events[CAPACITY];
    nkw_mixer_frame frame;
    unsigned char memory[NKW_MIXER_WORK(4, 1, 0) + 16];
} world;

static world w;

static void build_walk(walk *k, float way, float angle)
{
    const nkw_vec3 y = {0.0f, 1.0f, 0.0f};
    const nkw_quat turn = nkw_quat_from_axis_angle(y, angle), none = nkw_quat_identity();
    k->times[1] = 1.0f;
    k->positions[5] = way;
    memcpy(k->rotations, &none, sizeof none);
    memcpy(k->rotations + 4, &turn, sizeof turn);
    k->tracks[0].target = NKW_CLIP_TRANSLATION;
    k->tracks[0].track = (nkw_track){.times = k->times, .values = k->positions, .count = 2, .width = 3};
    k->tracks[1].target = NKW_CLIP_ROTATION;
    k->tracks[1].track =
        (nkw_track){.times = k->times, .values = k->rotations, .count = 2, .width = 4, .kind = NKW_TRACK_ROTATION};
    const nkw_clip_source source = {.tracks = k->tracks, .track_count = 2, .joint_count = 1};
    assert_int_equal(clip_build_into(&source, k->block, sizeof k->block, NULL), NKW_OK);
}

static void begin(float angle)
{
    memset(&w, 0, sizeof w);
    build_walk(&w.walks[0], 2.0f, angle);
    build_walk(&w.walks[1], 4.0f, 0.0f);
    nkw_pose_identity(pose_span(w.rest, 1));
    for (int i = 0; i < 2; i++)
        w.clips[i].clip = (const nkw_clip *)(const void *)w.walks[i].block;
    w.set = (nkw_mixer_set){.clips = w.clips, .clip_count = 2, .rest = pose_view(w.rest, 1)};
    w.frame.pose = pose_span(w.pose, 1);
    w.frame.events = w.events;
    w.frame.event_capacity = CAPACITY;
}

static size_t play(nkw_mixer_options options)
{
    size_t slot = 99;
    assert_int_equal(nkw_mixer_play(&w.mixer, &w.set, &options, &slot), NKW_OK);
    return slot;
}

static void advance(double seconds)
{
    assert_int_equal(nkw_mixer_advance(&w.mixer, &w.set, seconds, &w.frame, work_in(w.memory, sizeof w.memory)),
                     NKW_OK);
}

/* ---- Events, counted in ticks of 1/64 s ---- */

/* Instants at both ends, one between, and two intervals, the second of which goes on over the end. */
static const int begins[EVENTS] = {0, 64, 23, 10, 50}, lengths[EVENTS] = {0, 0, 0, 9, 30};

static int modulo(int a, int n)
{
    return (a % n + n) % n;
}

static int is_at(nkw_playback mode, int t, int x)
{
    if (mode == NKW_PLAYBACK_LOOP)
        return modulo(x - t, TICKS) == 0;
    if (mode == NKW_PLAYBACK_PING_PONG)
        return modulo(x, 2 * TICKS) == t || modulo(-x, 2 * TICKS) == t;
    return x == t;
}

/* Whether x is in the interval of event i, [t, t + d); the one that goes on over the end is not tested in ping-pong. */
static int is_in(nkw_playback mode, int i, int x)
{
    const int t = begins[i], d = lengths[i], y = modulo(x, 2 * TICKS);
    if (mode == NKW_PLAYBACK_LOOP)
        return modulo(x - t, TICKS) < d;
    if (mode == NKW_PLAYBACK_PING_PONG)
        return (y >= t && y < t + d) || (y >= 2 * TICKS - t - d && y < 2 * TICKS - t);
    return x >= t && x < t + d;
}

typedef struct report {
    int event;
    nkw_mixer_event_kind kind;
} report;

/*
 * What is reported of event i at the place x of a step: instants at x, but not where the step begins; intervals where
 * the tick that ends in x, backwards the tick that begins in x, goes over one of their ends.
 */
static size_t tick(nkw_playback mode, int i, int x, int from, int to, report *list, size_t n)
{
    const int before = to < from ? x : x - 1, after = to < from ? x - 1 : x;
    if (lengths[i] == 0 && x != from && is_at(mode, begins[i], x))
        list[n++] = (report){i, NKW_MIXER_PASSED};
    if (lengths[i] > 0 && x != (to < from ? to : from) && is_in(mode, i, before) != is_in(mode, i, after))
        list[n++] = (report){i, is_in(mode, i, after) ? NKW_MIXER_ENTERED : NKW_MIXER_LEFT};
    return n;
}

/* What the first frame reports of event i at the time where the slot begins. */
static size_t tick_first(nkw_playback mode, int i, int from, report *list, size_t n)
{
    if (lengths[i] == 0 && is_at(mode, begins[i], from))
        list[n++] = (report){i, NKW_MIXER_PASSED};
    if (lengths[i] > 0 && is_in(mode, i, from))
        list[n++] = (report){i, NKW_MIXER_ENTERED};
    return n;
}

static double seconds_of_step;

static void begin_events(nkw_playback mode)
{
    begin(0.0f);
    for (int i = 0; i < EVENTS; i++)
        w.marks[i] = (nkw_mixer_mark){(float)begins[i] / TICKS, (float)lengths[i] / TICKS};
    w.clips[0].events = w.marks;
    w.clips[0].event_count = mode == NKW_PLAYBACK_PING_PONG ? EVENTS - 1 : EVENTS;
}

/* The reports of a step, by walking tick by tick. */
static void check_step(nkw_playback mode, int from, int to, int is_first, size_t slot)
{
    const int way = to < from ? -1 : 1;
    size_t at = 0;
    for (int x = from; x != to + way; x += way) {
        report want[2 * EVENTS];
        size_t n = 0;
        for (int i = 0; i < (int)w.clips[0].event_count; i++) {
            n = is_first && x == from ? tick_first(mode, i, x, want, n) : n;
            n = tick(mode, i, x, from, to, want, n);
        }
        for (size_t k = 0; k < n; k++, at++) {
            assert_true(at < w.frame.event_count);
            assert_int_equal(w.events[at].event, want[k].event);
            assert_int_equal(w.events[at].kind, want[k].kind);
            assert_int_equal(w.events[at].slot, slot);
            expect_near(w.events[at].weight, 1.0, 0.0);
            const double share = to == from ? 0.0 : (double)(x - from) / (double)(to - from);
            expect_near(w.events[at].moment, share * seconds_of_step, 1e-7 * seconds_of_step);
        }
    }
    assert_int_equal(at, w.frame.event_count);
}

static void events_are_reported_once_in_any_steps(void **state)
{
    (void)state;
    random_source r = random_from(31);
    static const float speeds[] = {1.0f, -1.0f, 2.0f, -0.5f, 0.0f};
    for (int round = 0; round < 600; round++) {
        const nkw_playback mode = (nkw_playback)(round % 3);
        int from = (int)(random_bits(&r) % 200) - 100;
        begin_events(mode);
        const size_t slot = play((nkw_mixer_options){.mode = mode, .time = (float)from / TICKS});
        for (int step = 0; step < 40; step++) {
            const float speed = speeds[random_bits(&r) % 5];
            const int ticks = 2 * (int)(random_bits(&r) % (step % 8 == 0 ? 400 : 12));
            const int to = from + (int)(speed * (float)ticks);
            w.mixer.slot[slot].speed = speed;
            seconds_of_step = (double)ticks / TICKS;
            advance(seconds_of_step);
            check_step(mode, from, to, step == 0, slot);
            from = to;
        }
    }
}

/* Times that binary floats do not have: the number of passes of 10^5 uneven steps is that of one. */
static void many_uneven_steps_pass_as_often_as_one(void **state)
{
    (void)state;
    random_source r = random_from(32);
    for (int mode = NKW_PLAYBACK_LOOP; mode <= NKW_PLAYBACK_PING_PONG; mode++) {
        begin_events((nkw_playback)mode);
        w.clips[0].end = 0.7f;
        const size_t slot = play((nkw_mixer_options){.mode = (nkw_playback)mode});
        size_t passed = 0;
        for (int step = 0; step < 100000; step++) {
            advance((double)random_unit(&r) / 16.0);
            for (size_t i = 0; i < w.frame.event_count; i++)
                passed += w.events[i].event == 2;
        }
        const double x = w.mixer.slot[slot].time, t = 23.0 / 64.0, l = (double)0.7f;
        const double want = mode == NKW_PLAYBACK_LOOP
                                ? floor((x - t) / l) + 1.0
                                : floor((x - t) / (2.0 * l)) + 1.0 + floor((x - (2.0 * l - t)) / (2.0 * l)) + 1.0;
        expect_near((double)passed, want, 0.0);
    }
}

/*
 * Intervals of one and of two cycles, whose floats are 6e-8 s too long, end when they begin again: each frame leaves what
 * it enters, and leaves first.
 */
static void intervals_of_whole_cycles_are_left_before_they_are_entered(void **state)
{
    (void)state;
    for (int backwards = 0; backwards < 2; backwards++) {
        begin_events(NKW_PLAYBACK_LOOP);
        const float start = 0.3f, end = 1.7f, length = end - start;
        const double sevenths = (double)length / 7.0; /* steps end at the intervals' ends, to rounding */
        const nkw_mixer_mark whole[2] = {{0.43f, length}, {0.87f, 2.0f * length}};
        w.clips[0].start = start;
        w.clips[0].end = end;
        w.clips[0].events = whole;
        w.clips[0].event_count = 2;
        const size_t slot = play((nkw_mixer_options){.mode = NKW_PLAYBACK_LOOP, .time = 0.13f});
        w.mixer.slot[slot].speed = backwards ? -1.0f : 1.0f;
        advance(0.0);
        size_t passed = 0;
        for (int step = 0; step < 100000; step++) {
            advance(sevenths);
            for (size_t i = 0; i < w.frame.event_count; i += 2) {
                const nkw_mixer_event *left = &w.events[i], *entered = left + 1;
                assert_true(i + 1 < w.frame.event_count && left->event == entered->event);
                assert_int_equal(left->kind, NKW_MIXER_LEFT);
                assert_int_equal(entered->kind, NKW_MIXER_ENTERED);
                assert_true(left->moment == entered->moment);
                passed += left->event == 0;
            }
        }
        const double cycles = fabs(w.mixer.slot[slot].time - (double)0.13f) / (double)length;
        assert_true(fabs((double)passed - cycles) <= 1.0);
    }
}

static void a_slot_that_is_freed_leaves_its_intervals(void **state)
{
    (void)state;
    begin_events(NKW_PLAYBACK_LOOP);
    const size_t slot = play((nkw_mixer_options){.mode = NKW_PLAYBACK_LOOP, .time = 12.0f / TICKS});
    advance(0.0);
    assert_int_equal(w.frame.event_count, 2); /* 12 is in both intervals: the second goes on over the end */
    assert_int_equal(w.events[0].kind, NKW_MIXER_ENTERED);
    assert_int_equal(w.events[1].kind, NKW_MIXER_ENTERED);
    assert_int_equal(nkw_mixer_stop(&w.mixer, slot, 3.0f / TICKS), NKW_OK);
    advance(1.0);
    assert_int_equal(w.frame.event_count, 2);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(w.events[i].kind, NKW_MIXER_LEFT);
        assert_int_equal(w.events[i].event, 3 + i);
        expect_near(w.events[i].weight, 0.0, 0.0);
        expect_near(w.events[i].moment, 3.0 / TICKS, 1e-8); /* when the slot is freed */
    }
}

static void too_many_events_are_counted(void **state)
{
    (void)state;
    begin_events(NKW_PLAYBACK_LOOP);
    play((nkw_mixer_options){.mode = NKW_PLAYBACK_LOOP, .time = 1.0f / TICKS});
    w.frame.event_capacity = 3;
    w.events[3].event = 77;
    advance(100.0);
    assert_int_equal(w.frame.event_count, 100 + 100 + 100 + 200 + 201);
    assert_int_equal(w.events[3].event, 77);
    static const int first[3] = {4, 3, 4}; /* it begins in interval 4, enters 3 at 10, leaves 4 at 16 */
    for (int i = 0; i < 3; i++)
        assert_int_equal(w.events[i].event, first[i]);
    w.frame.event_capacity = 0;
    w.frame.events = NULL;
    advance(0x1p30);
    assert_true(w.frame.event_count >= 5 * (1 << 24));
}

/* ---- The motion of the root ---- */

static void motion_continues_over_loops_and_returns_in_ping_pong(void **state)
{
    (void)state;
    random_source r = random_from(41);
    for (int mode = 0; mode < 3; mode++) {
        begin(0.0f);
        w.set.root_parts = NKW_ROOT_PLANE;
        play((nkw_mixer_options){.mode = (nkw_playback)mode});
        double time = 0.0;
        for (int step = 0; step < 2000; step++) {
            const double seconds = (double)random_unit(&r) * (step % 16 ? 0.0625 : 4.0), before = time;
            time += seconds;
            advance(seconds);
            const double fold = fmod(time, 2.0), fold_before = fmod(before, 2.0);
            const double want = mode == NKW_PLAYBACK_LOOP ? 2.0 * seconds
                                : mode == NKW_PLAYBACK_CLAMP
                                    ? 2.0 * (fmin(time, 1.0) - fmin(before, 1.0))
                                    : 2.0 * (fmin(fold, 2.0 - fold) - fmin(fold_before, 2.0 - fold_before));
            expect_near(w.frame.motion.translation.z, want, 1e-6);
            expect_near(w.frame.motion.translation.x, 0.0, 0.0);
            expect_near(nkw_pose_get(pose_view(w.pose, 1), 0).translation.z, 0.0, 0.0);
        }
    }
}

/*
 * 2 units ahead and 1.5 rad a cycle. After n cycles and t seconds the place is at the sum of the n ways of 2 units, each
 * turned by those before it, and 2 t more; a turn by a about y takes z to (sin a, 0, cos a).
 */
static void steps_of_a_turning_walk_lead_to_its_place(void **state)
{
    (void)state;
    random_source r = random_from(42);
    begin(1.5f);
    w.set.root_parts = NKW_ROOT_PLANE | NKW_ROOT_YAW;
    const size_t slot = play((nkw_mixer_options){.mode = NKW_PLAYBACK_LOOP});
    nkw_trs place = nkw_trs_identity();
    for (int step = 0; step < 500; step++) {
        advance((double)random_unit(&r) / 8.0);
        place = nkw_trs_mul(&place, &w.frame.motion);
        const double time = w.mixer.slot[slot].time, n = floor(time), way = 2.0 * (time - n);
        double x = way * sin(1.5 * n), z = way * cos(1.5 * n);
        for (int k = 0; k < (int)n; k++) {
            x += 2.0 * sin(1.5 * k);
            z += 2.0 * cos(1.5 * k);
        }
        const nkw_quat turn = {0.0f, (float)sin(0.75 * time), 0.0f, (float)cos(0.75 * time)};
        expect_near(place.translation.x, x, 2e-5);
        expect_near(place.translation.z, z, 2e-5);
        expect_rotation_near(place.rotation, turn, 2e-5);
    }
}

static void motions_of_slots_are_averaged_by_their_weights(void **state)
{
    (void)state;
    begin(0.0f);
    w.set.root_parts = NKW_ROOT_PLANE;
    nkw_mixer_options o = {.mode = NKW_PLAYBACK_LOOP, .transition = NKW_MIXER_FADE_IN};
    const size_t a = play(o);
    o.clip = 1;
    const size_t b = play(o);
    o.layer = 1;
    play(o);
    w.mixer.slot[a].weight = 0.75f;
    w.mixer.slot[b].weight = 0.25f;
    advance(0.25);
    expect_near(w.frame.motion.translation.z, 0.25 * (0.75 * 2.0 + 0.25 * 4.0), 1e-6);
    w.mixer.slot[a].weight = 0.0f;
    advance(0.25);
    expect_near(w.frame.motion.translation.z, 0.25 * 0.25 * 4.0, 1e-6);
    w.mixer.slot[a].weight = 1.0f;
    w.mixer.slot[b].weight = 0.0f;
    advance(0.25);
    expect_near(w.frame.motion.translation.z, 0.25 * 2.0, 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(events_are_reported_once_in_any_steps),
        cmocka_unit_test(many_uneven_steps_pass_as_often_as_one),
        cmocka_unit_test(intervals_of_whole_cycles_are_left_before_they_are_entered),
        cmocka_unit_test(a_slot_that_is_freed_leaves_its_intervals),
        cmocka_unit_test(too_many_events_are_counted),
        cmocka_unit_test(motion_continues_over_loops_and_returns_in_ping_pong),
        cmocka_unit_test(steps_of_a_turning_walk_lead_to_its_place),
        cmocka_unit_test(motions_of_slots_are_averaged_by_their_weights),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
