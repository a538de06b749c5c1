/* SPDX-License-Identifier: MIT */
/* The programs of docs/subjects/clip/mixer.md: a jointed tank, and a blend tree. */
#include <math.h>

#include "subjects_clip_mixer_1.c" /* the blocks of the page */
#include "subjects_clip_mixer_2.c"
#include "support/clips.h"
#include "support/expect.h"

/* Clip 0: in 2 s the hull drives 6 m, the turret turns by 1.5 rad about y, the gun rises by 0.5 rad about x. */
typedef struct armour {
    float times[2], way[6], turns[2][8], rest[NKW_POSE_FLOATS(FRAMES)], blocks[CLIPS][512];
    nkw_mixer_clip clips[CLIPS];
    nkw_mixer_set set;
} armour;

static armour a;

static void key_turn(float *keys, nkw_vec3 axis, float from, float to)
{
    const nkw_quat q[2] = {nkw_quat_from_axis_angle(axis, from), nkw_quat_from_axis_angle(axis, to)};
    memcpy(keys, q, sizeof q);
}

/* `turn` and `rise` of the turret and the gun at the start and the end. */
static void build_clip(uint32_t clip, float duration, const float turn[2], const float rise[2])
{
    const nkw_vec3 x = {1.0f, 0.0f, 0.0f}, y = {0.0f, 1.0f, 0.0f};
    a.times[1] = duration;
    a.way[5] = 6.0f;
    key_turn(a.turns[0], y, turn[0], turn[1]);
    key_turn(a.turns[1], x, -rise[0], -rise[1]);
    const nkw_clip_track tracks[3] = {
        {NKW_CLIP_TRANSLATION, HULL, {.times = a.times, .values = a.way, .count = 2, .width = 3}},
        {NKW_CLIP_ROTATION,
         TURRET,
         {.times = a.times, .values = a.turns[0], .count = 2, .width = 4, .kind = NKW_TRACK_ROTATION}},
        {NKW_CLIP_ROTATION,
         GUN,
         {.times = a.times, .values = a.turns[1], .count = 2, .width = 4, .kind = NKW_TRACK_ROTATION}},
    };
    const nkw_clip_source source = {
        .tracks = tracks, .track_count = 3, .joint_count = FRAMES, .rest = pose_view(a.rest, FRAMES)};
    assert_int_equal(clip_build_into(&source, a.blocks[clip], sizeof a.blocks[clip], NULL), NKW_OK);
    a.clips[clip].clip = (const nkw_clip *)(const void *)a.blocks[clip];
}

/* The turret is 1 m above the hull, the gun 1 m ahead in the turret. */
static void begin(void)
{
    memset(&a, 0, sizeof a);
    nkw_trs turret = nkw_trs_identity(), gun = turret;
    turret.translation.y = 1.0f;
    gun.translation.z = 1.0f;
    nkw_pose_identity(pose_span(a.rest, FRAMES));
    nkw_pose_set(pose_span(a.rest, FRAMES), TURRET, &turret);
    nkw_pose_set(pose_span(a.rest, FRAMES), GUN, &gun);
    build_clip(0, 2.0f, (const float[]){0.0f, 1.5f}, (const float[]){0.0f, 0.5f});
    build_clip(1, 1.0f, (const float[]){0.75f, 0.75f}, (const float[]){0.0f, 0.0f});
    for (uint32_t clip = 2; clip < CLIPS; clip++)
        build_clip(clip, 0.5f, (const float[]){0.0f, 1.0f}, (const float[]){0.0f, 0.0f});
    a.set.clips = a.clips;
    a.set.clip_count = CLIPS;
    a.set.rest = pose_view(a.rest, FRAMES);
    assert_int_equal(nkw_mixer_set_validate(&a.set, NULL), NKW_OK);
}

/* The muzzle, 2 m ahead in the gun: by the angles of both joints. */
static void expect_muzzle(const tank *t, double way, double turn, double rise)
{
    const nkw_vec3 tip = {0.0f, 0.0f, 2.0f};
    const nkw_vec3 got = nkw_mat4_transform_point(&t->models[GUN], tip);
    const double ahead = 1.0 + 2.0 * cos(rise);
    expect_near(got.x, ahead * sin(turn), 1e-5);
    expect_near(got.y, 1.0 + 2.0 * sin(rise), 1e-5);
    expect_near(got.z, way + ahead * cos(turn), 1e-5);
}

static void a_tank_of_three_frames_is_played(void **state)
{
    (void)state;
    tank t;
    memset(&t, 0, sizeof t);
    begin();
    tank_play(&t, &a.set, 0, 0.0f);
    for (int frame = 1; frame < 120; frame++) {
        const double u = frame / 120.0;
        assert_int_equal(tank_advance_time(&t, &a.set, 2.0 / 120.0), NKW_OK);
        expect_muzzle(&t, 6.0 * u, 1.5 * u, 0.5 * u);
    }
    assert_int_equal(tank_advance_time(&t, &a.set, 2.0 / 120.0 + 0.5), NKW_OK);
    expect_muzzle(&t, 1.5, 0.375, 0.125);
}

/* In the middle of the fade: half of both ways, and the angles in the middle, of two equal weights. */
static void a_tank_fades_from_clip_to_clip(void **state)
{
    (void)state;
    tank t;
    memset(&t, 0, sizeof t);
    begin();
    tank_play(&t, &a.set, 0, 0.0f);
    assert_int_equal(tank_advance_time(&t, &a.set, 1.0), NKW_OK);
    tank_play(&t, &a.set, 1, 0.5f);
    assert_int_equal(tank_advance_time(&t, &a.set, 0.25), NKW_OK);
    const double turn = 0.5 * (1.5 * 0.625 + 0.75);
    expect_muzzle(&t, 0.5 * (6.0 * 0.625 + 6.0 * 0.25), turn, 0.5 * 0.5 * 0.625);
    assert_int_equal(tank_advance_time(&t, &a.set, 0.25), NKW_OK);
    expect_muzzle(&t, 3.0, 0.75, 0.0);
}

static void a_tree_of_four_clips_is_steered(void **state)
{
    (void)state;
    static const float steers[][2] = {{0.0f, 0.0f}, {0.25f, 0.0f}, {1.0f, 0.5f}, {1.75f, 1.0f}, {2.5f, 0.0f}};
    float pose[NKW_POSE_FLOATS(FRAMES)];
    nkw_mixer mixer;
    NKW_STACK_WORK(work, NKW_MIXER_WORK(4, FRAMES, 0));
    nkw_mixer_frame frame = {.pose = {pose, FRAMES}};
    memset(&mixer, 0, sizeof mixer);
    begin();
    tree_begin(&mixer, &a.set);
    for (size_t i = 0; i < sizeof steers / sizeof *steers; i++) {
        tree_steer(&mixer, steers[i][0], steers[i][1]);
        const double before = mixer.slot[RUN].time, walked = mixer.slot[WALK].time;
        assert_int_equal(nkw_mixer_advance(&mixer, &a.set, 0.125, &frame, work), NKW_OK);
        const double walk = mixer.slot[WALK].weight, run = mixer.slot[RUN].weight;
        expect_near(mixer.slot[IDLE].weight + walk + run, 1.0, 1e-6);
        const double length = walk + run > 0.0 ? (walk + 0.5 * run) / (walk + run) : 0.75;
        expect_near(mixer.slot[WALK].time - walked, 0.125 / length, 1e-12);
        expect_near(mixer.slot[RUN].time - before, 0.5 * 0.125 / length, 1e-12);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_tank_of_three_frames_is_played),
        cmocka_unit_test(a_tank_fades_from_clip_to_clip),
        cmocka_unit_test(a_tree_of_four_clips_is_steered),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
